//! Time since the board came up, and short waits.
//!
//! Reads the 1 MHz TIMER, which [`crate::init`] has started; never writes it.

use embedded_hal::delay::DelayNs;
use rp2040_hal::pac;

/// Returns the lower 32 bits of the microseconds since start: one load, for time stamps in interrupts.
#[inline(always)]
pub fn stamp_us() -> u32 {
    // SAFETY: reading TIMERAWL has no side effect.
    unsafe { &*pac::TIMER::PTR }.timerawl().read().bits()
}

/// Returns the microseconds since start.
pub fn now_us() -> u64 {
    // SAFETY: reading TIMERAWH and TIMERAWL has no side effect (unlike TIMELR, which latches).
    let timer = unsafe { &*pac::TIMER::PTR };
    let high = timer.timerawh().read().bits();
    let low = timer.timerawl().read().bits();
    // The upper half changes every 71 minutes; if it did just now, one more look is enough.
    let high_after = timer.timerawh().read().bits();
    let low = if high == high_after { low } else { timer.timerawl().read().bits() };
    u64::from(high_after) << 32 | u64::from(low)
}

/// Busy wait, for the few microseconds and milliseconds that chips need at start-up.
#[derive(Clone, Copy, Debug, Default)]
pub struct Delay;

impl DelayNs for Delay {
    fn delay_ns(&mut self, ns: u32) {
        self.delay_us(ns.div_ceil(1_000));
    }

    fn delay_us(&mut self, us: u32) {
        let start = stamp_us();
        // One more than asked for: the first microsecond may have begun already.
        while stamp_us().wrapping_sub(start) <= us {}
    }
}
