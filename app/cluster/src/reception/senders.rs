//! Two senders of one message: told by its life counter, or by twice its printed rate.
//!
//! | evidence | two senders | one sender                                                             |
//! |----------|-------------|-------------------------------------------------------------------------|
//! | counter  | each frame goes on where the one before the last stopped, and not where the last did: [`JUMPS`] times in a row | by chance once in 256 to the power of [`JUMPS`] even if it counts at random |
//! | rate     | at least 8 frames in 5 cycles, for [`WINDOWS`] times 5 cycles on end | 6 at most: jitter and one frame that was late |
//!
//! Refuses to know which of the two is right. Source: BUS-R021 (a counter counts by one), the printed cycles.

use protocol_core::Millis;
use protocol_core::vehicle::{Life, RxMessage};

/// Frames in a row that go on from the frame before the last.
const JUMPS: u8 = 6;
/// Cycles in one count of frames.
const CYCLES: u32 = 5;
/// Frames in that time that are too many for one sender.
const TOO_MANY: u8 = 8;
/// Counts in a row with too many frames.
const WINDOWS: u8 = 4;

/// Returns the low bits of a time: enough to tell ages of up to 49 days.
pub(super) const fn stamp(now: Millis) -> u32 {
    now.0 as u32
}

/// What speaks for two senders of one message.
#[derive(Clone, Copy)]
pub(super) struct Senders {
    /// The last two states of the counter, the newer one first.
    last: (u8, u8),
    jumps: u8,
    /// When the count of frames began: the low bits of the time.
    since: u32,
    frames: u8,
    windows: u8,
}

impl Senders {
    pub(super) const fn new() -> Self {
        Self { last: (0, 0), jumps: 0, since: 0, frames: 0, windows: 0 }
    }

    /// Takes a frame with this state of its life counter; returns whether its message has two senders.
    pub(super) fn hear(&mut self, message: &RxMessage, count: Option<u8>, now: Millis) -> bool {
        if let Some((life, count)) = message.life.zip(count) {
            self.follow(life, count);
        }
        if message.cycle_ms > 0 {
            self.count(message.cycle_ms.saturating_mul(CYCLES), stamp(now));
        }
        self.jumps >= JUMPS || self.windows >= WINDOWS
    }

    fn follow(&mut self, Life { mask, .. }: Life, count: u8) {
        let one = 1 << mask.trailing_zeros().min(7);
        let follows = |before: u8| count == before.wrapping_add(one) & mask;
        let (last, before) = self.last;
        self.jumps = if follows(before) && !follows(last) { self.jumps.saturating_add(1) } else { 0 };
        self.last = (count, last);
    }

    fn count(&mut self, span_ms: u32, now: u32) {
        let age_ms = now.wrapping_sub(self.since);
        if age_ms < span_ms {
            self.frames = self.frames.saturating_add(1);
            return;
        }
        let is_too_many = self.frames >= TOO_MANY && age_ms / 2 < span_ms;
        self.windows = if is_too_many { self.windows.saturating_add(1) } else { 0 };
        (self.since, self.frames) = (now, 1);
    }
}
