//! Milliseconds since power-on, as the firmware and the tests count them.
//!
//! 64 bits: the counter does not wrap in the life of a vehicle, so no comparison here needs wrap-around arithmetic.

/// A point in time, in milliseconds since power-on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Millis(pub u64);

impl Millis {
    /// Returns the milliseconds from `earlier` to `self`; 0 if `earlier` lies ahead.
    pub const fn since(self, earlier: Self) -> u64 {
        self.0.saturating_sub(earlier.0)
    }

    /// Returns the point `span_ms` later.
    pub const fn after(self, span_ms: u64) -> Self {
        Self(self.0 + span_ms)
    }
}
