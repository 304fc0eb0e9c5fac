//! How the instrument looks: layout, colours, languages and the path from a view to pixels.
//!
//! [`Screen`] compares a [`View`](cluster::View) with what the panel shows, hands out what changed as tiles, and paints a
//! tile into memory or on any [`DrawTarget`](embedded_graphics_core::draw_target::DrawTarget): each pixel once, so that
//! nothing flickers. No hardware, no clock, no allocation, integers only.
//!
//! ```
//! use cluster::View;
//! use ui::{Screen, Tile};
//!
//! let mut screen = Screen::new();
//! let mut buffer = [0_u16; ui::TILE_PIXELS];
//! screen.update(&View::default());
//! while let Some(area) = screen.next_tile(buffer.len()) {
//!     // Straight into memory, for 16-bit SPI frames: window(area), then DMA of the pixels.
//!     let pixels = screen.render(&area, &mut buffer).expect("next_tile keeps to the buffer's length");
//!     assert_eq!(pixels.len(), area.size.width as usize * area.size.height as usize);
//!     // Or on any target: a tile of bytes, a display driver, a window on a PC.
//!     let mut tile = Tile::new(&mut buffer, area).unwrap();
//!     screen.draw(&area, &mut tile).unwrap();
//! }
//! ```

#![no_std]
#![forbid(unsafe_code)]

mod element;
mod fonts;
mod layout;
mod pages;
mod picture;
mod regions;
mod scanline;
mod screen;
mod theme;
mod tile;
mod words;

pub use pages::looks_same;
pub use picture::{has_glyph, message_room};
pub use screen::Screen;
pub use tile::{PanelPixel, Tile};

/// Width of the screen in pixels.
pub const WIDTH: u16 = 320;
/// Height of the screen in pixels.
pub const HEIGHT: u16 = 240;
/// Pixels of a tile buffer: sixteen full rows.
pub const TILE_PIXELS: usize = WIDTH as usize * 16;
