//! The tasks, one file each; what wakes them and what they share stands in `main.rs`.

mod can_service;
mod draw;
mod idle;
mod link_done;
mod panel_done;
mod report;
mod tick;

pub use can_service::can_service;
pub use draw::{TileBuffer, draw};
pub use idle::idle;
pub use link_done::link_done;
pub use panel_done::panel_done;
pub use report::report;
pub use tick::{Watch, tick};
