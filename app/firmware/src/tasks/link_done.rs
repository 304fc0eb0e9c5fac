//! The DMA has given the last byte of a stretch to the UART.

use rtic::Mutex;

use crate::app::link_done::Context;

/// Starts the next stretch.
pub fn link_done(mut cx: Context) {
    cx.shared.link.lock(pico::LinkPort::on_irq);
}
