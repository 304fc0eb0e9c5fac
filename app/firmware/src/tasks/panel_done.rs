//! The DMA has given the last pixel of a tile to the SPI.

use crate::app::panel_done::Context;

/// Wakes `draw`.
pub fn panel_done(cx: Context) {
    pico::panel_port::acknowledge();
    cx.local.tile_done_in.write(());
}
