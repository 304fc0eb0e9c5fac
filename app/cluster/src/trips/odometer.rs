//! The distance, integrated from the speed in whole numbers: no rounding, never backwards.
//!
//! The sum counts speed counts times milliseconds, so nothing is lost between two ticks, and any division of a time
//! into ticks gives the same distance. Time without a known speed adds nothing. Where the vehicle sends a distance, that
//! distance is followed while it is fresh and ahead, and the speed adds nothing; one that lags behind what was shown is
//! waited for, so the figure never runs backwards.
//! Source: BUS-97 (0.125 km per bit in Meter2), BUS-118 (1/256 km/h per bit in VCU1).

pub(crate) use crate::kept::parts::PER_KM;

use crate::kept::parts::Distance;
use protocol_core::Millis;

/// A step longer than this was a stall; the speed after it says nothing about the time within.
pub(crate) const LONGEST_STEP_MS: u64 = 1_000;

/// The total distance.
#[derive(Clone, Copy)]
pub(crate) struct Odometer {
    sum: u64,
    last: Option<Millis>,
    /// The sum is the whole distance, not only what was driven since power-on.
    is_known: bool,
}

impl Odometer {
    pub(crate) const fn new() -> Self {
        Self { sum: 0, last: None, is_known: false }
    }

    /// Starts from a distance that was kept, in 1/8 km; never takes distance away.
    pub(crate) fn restore(&mut self, km8: u32) {
        self.is_known = true;
        self.sum = self.sum.max(u64::from(km8) * (PER_KM / 8));
    }

    /// Follows the distance that the vehicle sends, in 1/8 km.
    pub(crate) fn follow(&mut self, km8: i32) {
        self.restore(u32::try_from(km8).unwrap_or(0));
    }

    /// Takes note that what was kept is lost: what is counted from now on is not the whole distance.
    pub(crate) fn forget(&mut self) {
        self.is_known = false;
    }

    /// Takes note that nothing was counted before.
    pub(crate) fn begin(&mut self) {
        self.is_known = true;
    }

    /// Goes on from what was kept, to the last count: what was driven since the start comes on top, unless the vehicle
    /// has sent its distance meanwhile. Never takes distance away.
    pub(crate) fn resume(&mut self, kept: Distance) {
        self.sum =
            if self.is_known { self.sum.max(kept.counts) } else { self.sum.saturating_add(kept.counts) };
        self.is_known |= kept.is_known;
    }

    /// Returns what is to be kept.
    pub(crate) fn kept(&self) -> Distance {
        Distance { counts: self.sum, is_known: self.is_known }
    }

    /// Returns the distance in 1/8 km, rounded down; `None` = it is not known.
    pub(crate) fn known_km8(&self) -> Option<u32> {
        self.is_known.then(|| self.km8())
    }

    /// Adds the way since the last call at `speed_kmh256`; `None` = not known.
    pub(crate) fn drive(&mut self, speed_kmh256: Option<i32>, now: Millis) {
        let step = self.last.map_or(0, |last| now.since(last)).min(LONGEST_STEP_MS);
        self.last = self.last.max(Some(now));
        let speed = speed_kmh256.and_then(|speed| u64::try_from(speed).ok()).unwrap_or(0);
        self.sum = self.sum.saturating_add(speed * step);
    }

    /// Returns the distance in 1/8 km, rounded down.
    pub(crate) fn km8(&self) -> u32 {
        u32::try_from(self.sum / (PER_KM / 8)).unwrap_or(u32::MAX)
    }

    /// Returns the distance in 0.1 km, rounded down.
    pub(crate) fn hectometres(&self) -> u32 {
        u32::try_from(self.sum / (PER_KM / 10)).unwrap_or(u32::MAX)
    }
}
