//! What is shown: numbers, pages, what turns them.

mod pages;
mod parts;
mod screen;
