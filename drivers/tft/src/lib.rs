//! ILI9341 and ST7789 panels, 320x240 landscape: start-up as a plan, pixels by window and stream.
//!
//! The start-up commands are those of `mipidsi`'s models, recorded ([`script`]) and turned into a plan of steps
//! ([`start_up`]) that never blocks: the caller waits, and paints the first picture while the panel wakes up. After
//! that only windows are opened ([`link`]); the pixel words between `open` and `close` are the board's business, by DMA.
//!
//! Refuses to know the back-light (keep it dark until the plan has ended), clocks, DMA and what is drawn.
//! Not supported: reading the panel, scrolling, sleep, 18-bit colour.

#![no_std]
#![forbid(unsafe_code)]

pub mod link;
pub mod panel;
pub mod script;
pub mod start_up;

pub use link::{Link, Window};
pub use panel::Panel;
pub use start_up::{Start, StartUp, Step};

/// Width of the picture in pixels.
pub const WIDTH: u16 = 320;
/// Height of the picture in pixels.
pub const HEIGHT: u16 = 240;
