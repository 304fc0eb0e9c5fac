//! Nothing to do: sleeps, and measures how much.

use core::sync::atomic::{AtomicU32, Ordering};

use crate::app::idle::Context;

/// Microseconds slept since start, wrapping.
static SLEPT_US: AtomicU32 = AtomicU32::new(0);

/// Returns the microseconds slept since start, wrapping.
pub fn slept_us() -> u32 {
    SLEPT_US.load(Ordering::Relaxed)
}

/// Sleeps until an interrupt comes, for ever.
pub fn idle(_: Context) -> ! {
    loop {
        // Interrupts are masked so that the time in their tasks does not count as sleep; a pending one wakes the
        // core all the same and is served at the end of the section.
        cortex_m::interrupt::free(|_| {
            let asleep = pico::stamp_us();
            cortex_m::asm::wfi();
            let slept = pico::stamp_us().wrapping_sub(asleep);
            // Only this task writes: load and store need not be one.
            SLEPT_US.store(SLEPT_US.load(Ordering::Relaxed).wrapping_add(slept), Ordering::Relaxed);
        });
    }
}
