//! The first seconds: when they began, for the cluster and for the vehicle that it is in.

use protocol_core::Millis;

/// All telltales are lit for this long after start, in milliseconds, so that a dead one is noticed.
const BULB_CHECK_MS: u64 = 3_000;
/// Time that nodes have to send their first frames before one counts as missing, in milliseconds.
pub(crate) const BOOT_MS: u64 = 5_000;

/// The beginnings.
#[derive(Clone, Copy)]
pub(crate) struct Start {
    /// First tick.
    started: Option<Millis>,
    /// First tick for this vehicle.
    listening: Option<Millis>,
}

impl Start {
    pub(crate) const fn new() -> Self {
        Self { started: None, listening: None }
    }

    /// Takes a tick; returns when the first one for this vehicle was.
    pub(crate) fn tick(&mut self, now: Millis) -> Millis {
        self.started.get_or_insert(now);
        *self.listening.get_or_insert(now)
    }

    /// Begins anew for another vehicle: its nodes get their time to boot.
    pub(crate) fn of_another_vehicle(&mut self) {
        self.listening = None;
    }

    /// Returns when the first tick for this vehicle was.
    pub(crate) fn listening(&self) -> Option<Millis> {
        self.listening
    }

    /// Returns whether all telltales are lit, whatever is true.
    pub(crate) fn is_bulb_check(&self, now: Millis) -> bool {
        self.started.is_none_or(|started| now.since(started) < BULB_CHECK_MS)
    }
}
