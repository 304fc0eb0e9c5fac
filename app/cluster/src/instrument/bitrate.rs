//! At which bit rate to listen while the vehicle is searched for.
//!
//! Owns the choice and its age. Refuses to know the controller and whose frames they are.

use protocol_core::Millis;
use protocol_core::vehicle::Vehicle;

/// A bit rate at which nothing but errors is heard is left after this, in milliseconds.
const DWELL_MS: u64 = 20;
/// One at which frames were heard is left after errors alone for this long, in milliseconds.
const TRUSTED_DWELL_MS: u64 = 500;

/// Chooses the bit rate at which to listen.
///
/// A silent bus says nothing of its rate: the choice stays where it is, so that the first frame of the right rate is
/// not missed. Errors without frames move it on; a rate at which frames were heard is given up late.
#[derive(Clone)]
pub struct BitrateScan {
    vehicles: &'static [&'static Vehicle],
    bitrate: u32,
    /// When the rate was chosen, or the last frame was heard at it.
    since: Millis,
    is_trusted: bool,
}

impl BitrateScan {
    /// Returns a scan at the lowest bit rate of the vehicles: there the others give errors soonest.
    pub const fn new(vehicles: &'static [&'static Vehicle]) -> Self {
        let mut lowest = u32::MAX;
        let mut index = 0;
        while index < vehicles.len() {
            if vehicles[index].bitrate < lowest {
                lowest = vehicles[index].bitrate;
            }
            index += 1;
        }
        Self { vehicles, bitrate: lowest, since: Millis(0), is_trusted: false }
    }

    /// Returns the bit rate at which to listen.
    pub const fn bitrate(&self) -> u32 {
        self.bitrate
    }

    /// Listens at the bit rate of the vehicle of this name first, if there is one and no frame has been heard yet.
    pub fn expect(&mut self, name: &[u8]) -> u32 {
        let expected = self.vehicles.iter().find(|vehicle| vehicle.name.as_bytes() == name);
        if let Some(vehicle) = expected.filter(|_| !self.is_trusted) {
            self.bitrate = vehicle.bitrate;
        }
        self.bitrate
    }

    /// Takes what the controller has met since the last call; returns the bit rate to change to.
    pub fn listen(&mut self, frames: bool, errors: bool, now: Millis) -> Option<u32> {
        if frames {
            (self.since, self.is_trusted) = (now, true);
        }
        let dwell = if self.is_trusted { TRUSTED_DWELL_MS } else { DWELL_MS };
        if !errors || now.since(self.since) < dwell {
            return None;
        }
        let rates = || self.vehicles.iter().map(|vehicle| vehicle.bitrate);
        let next = rates().filter(|rate| *rate > self.bitrate).min().or(rates().min())?;
        if next == self.bitrate {
            return None;
        }
        (self.bitrate, self.since, self.is_trusted) = (next, now, false);
        Some(next)
    }
}
