//! Telltales: each row alone, and what a start and silence do to them.

mod lighting;
mod rows;
