//! Two senders of one message, told by its life counter.
//!
//! Each frame goes on where the one before the last stopped, and not where the last did, [`JUMPS`] times in a row: one
//! sender does that by chance once in 256 to the power of [`JUMPS`], even if it counts at random. A message without a
//! counter tells nothing: a sender that is faster than its printed cycle is still one. Refuses to know which of the two is
//! right. Source: BUS-R021 (a counter counts by one).

use protocol_core::Millis;
use protocol_core::vehicle::Life;

/// Frames in a row that go on from the frame before the last.
const JUMPS: u8 = 6;

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
}

impl Senders {
    pub(super) const fn new() -> Self {
        Self { last: (0, 0), jumps: 0 }
    }

    /// Takes a frame with this state of its life counter; returns whether its message has two senders.
    pub(super) fn hear(&mut self, Life { mask, .. }: Life, count: u8) -> bool {
        let one = 1 << mask.trailing_zeros().min(7);
        let follows = |before: u8| count == before.wrapping_add(one) & mask;
        let (last, before) = self.last;
        self.jumps = if follows(before) && !follows(last) { self.jumps.saturating_add(1) } else { 0 };
        self.last = (count, last);
        self.jumps >= JUMPS
    }
}
