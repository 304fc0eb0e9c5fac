//! When the reversing chime may sound: R without interruption for two seconds.
//!
//! Source: BUS-R017 and BUS-37: the time starts at the first R frame; any other gear or silence clears it at once.

use protocol_core::Millis;
use protocol_core::model::{Gear, Shown};

/// R for this long, in milliseconds, before the chime sounds.
const STEADY_MS: u64 = 2_000;

/// Since when R is engaged.
#[derive(Clone, Copy)]
pub(crate) struct Reverse {
    since: Option<Millis>,
}

impl Reverse {
    pub(crate) const fn new() -> Self {
        Self { since: None }
    }

    /// Takes the gear as it is now known.
    pub(crate) fn observe(&mut self, gear: Shown<i32>, now: Millis) {
        self.since = match gear.value().and_then(Gear::from_number) {
            Some(Gear::R) => self.since.or(Some(now)),
            _ => None,
        };
    }

    /// Returns whether R has lasted long enough.
    pub(crate) fn is_steady(&self, now: Millis) -> bool {
        self.since.is_some_and(|since| now.since(since) >= STEADY_MS)
    }
}
