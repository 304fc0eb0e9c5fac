//! INT is low: empties the controller into the queue.

use rtic::Mutex;

use crate::app::can_service::Context;
use crate::queue::Stamped;

/// Takes every waiting frame, stamped with the time of the interrupt.
// In RAM with its entry, the driver and the SPI loop inlined: drawing turns the 16 KB flash cache over all the time,
// and every miss would come on top of the 14 us that a frame takes on the wire. Still in flash: the critical section
// of the lock, and copying a frame's bytes.
#[unsafe(link_section = ".data.ram.can_service")]
pub fn can_service(mut cx: Context) {
    let at_us = pico::stamp_us();
    let queue = cx.local.frames_in;
    cx.shared.can.lock(|can| can.service(|frame| queue.enqueue(Stamped { frame, at_us }).is_ok()));
}
