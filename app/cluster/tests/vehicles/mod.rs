//! The whole cluster on the generated vehicles: the contract that all inherit, and the documents' bytes.

mod c5ev;
mod citybus;
mod citybus_pages;
mod contract;
mod jiulong;
