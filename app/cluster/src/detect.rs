//! Which vehicle this is, told from the identifiers on its bus; and at which bit rate to listen.
//!
//! Owns the evidence and the frames heard so far, so that nothing is lost while it is gathered. A vehicle is certain
//! after [`DISTINCT`] different identifiers of its own in a row, likely if fewer keep coming for a while; an identifier
//! that no vehicle has, or several have, says nothing, and one of another vehicle starts the evidence anew. What was
//! found stays found until power-off: a bus that contradicts it later raises a doubt, and never another picture under
//! way. Refuses to know the controller and what the vehicles' messages mean.
//! Source: BUS-11 (all bits of an identifier count); no two vehicles share a 29-bit identifier (contract test).

use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, CanId, Millis};

/// Different identifiers of one vehicle that make it certain; all of them, if it has fewer.
pub const DISTINCT: usize = 3;
/// Frames that make a vehicle likely whose identifiers are fewer than [`DISTINCT`].
pub const REPEATS: u32 = 20;
/// Time over which those frames must come, in milliseconds.
pub const REPEATS_SPAN_MS: u64 = 1_000;
/// Frames kept for the cluster until the vehicle is known; beyond that the oldest go, they are worth least.
pub const KEPT: usize = 32;

/// A bit rate at which nothing but errors is heard is left after this, in milliseconds.
const DWELL_MS: u64 = 20;
/// One at which frames were heard is left after errors alone for this long, in milliseconds.
const TRUSTED_DWELL_MS: u64 = 500;

/// How sure a recognition is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sureness {
    /// Few identifiers, but again and again, and none of another vehicle.
    Likely,
    /// Enough different identifiers, and none of another vehicle between them.
    Certain,
}

/// What was recognised.
#[derive(Clone, Copy)]
pub struct Found {
    /// The vehicle.
    pub vehicle: &'static Vehicle,
    /// How sure it is.
    pub sureness: Sureness,
    /// When it was recognised.
    pub at: Millis,
}

/// What speaks for one vehicle.
#[derive(Clone, Copy)]
struct Evidence {
    vehicle: &'static Vehicle,
    ids: [Option<CanId>; DISTINCT],
    frames: u32,
    since: Millis,
}

impl Evidence {
    const fn of(vehicle: &'static Vehicle, now: Millis) -> Self {
        Self { vehicle, ids: [None; DISTINCT], frames: 0, since: now }
    }

    /// Adds a frame and returns how sure that makes it.
    fn add(&mut self, id: CanId, now: Millis) -> Option<Sureness> {
        self.frames = self.frames.saturating_add(1);
        if let Some(place) = self.ids.iter_mut().find(|known| known.is_none_or(|known| known == id)) {
            *place = Some(id);
        }
        let distinct = self.ids.iter().flatten().count();
        let lasts = now.since(self.since) >= REPEATS_SPAN_MS && self.frames >= REPEATS;
        if distinct >= DISTINCT.min(self.vehicle.ids.len()) {
            Some(Sureness::Certain)
        } else {
            lasts.then_some(Sureness::Likely)
        }
    }
}

/// Tells the vehicle from what is heard.
#[derive(Clone)]
pub struct Detector {
    vehicles: &'static [&'static Vehicle],
    evidence: Option<Evidence>,
    found: Option<Found>,
    /// Speaks for another vehicle than the one found.
    doubt: Option<Evidence>,
    contradiction: Option<&'static Vehicle>,
    kept: [Option<(CanFrame, Millis)>; KEPT],
    next: usize,
}

impl Detector {
    /// Returns a detector that has heard nothing.
    pub const fn new(vehicles: &'static [&'static Vehicle]) -> Self {
        Self {
            vehicles,
            evidence: None,
            found: None,
            doubt: None,
            contradiction: None,
            kept: [None; KEPT],
            next: 0,
        }
    }

    /// Takes a frame that was heard at `bitrate`; returns what it has made known, once.
    ///
    /// Until then the frame is kept for [`Self::take_kept`].
    pub fn hear(&mut self, frame: &CanFrame, bitrate: u32, now: Millis) -> Option<Found> {
        match self.found {
            None => {
                self.keep(frame, now);
                self.search(frame.id, bitrate, now)
            }
            Some(found) => {
                self.observe(found, frame.id, bitrate, now);
                None
            }
        }
    }

    /// Returns what was recognised; its sureness may still grow.
    pub fn found(&self) -> Option<Found> {
        self.found
    }

    /// Returns the other vehicle for which as much speaks as for the one found: something is wrong with this bus.
    pub fn contradiction(&self) -> Option<&'static Vehicle> {
        self.contradiction
    }

    /// Takes the kept frames out, oldest first, each with the time at which it was heard.
    pub fn take_kept(&mut self) -> impl Iterator<Item = (CanFrame, Millis)> {
        let start = core::mem::take(&mut self.next);
        let kept = core::mem::replace(&mut self.kept, [None; KEPT]);
        (0..KEPT).filter_map(move |offset| kept.get((start + offset) % KEPT).copied().flatten())
    }

    fn keep(&mut self, frame: &CanFrame, now: Millis) {
        if let Some(place) = self.kept.get_mut(self.next) {
            *place = Some((*frame, now));
        }
        self.next = (self.next + 1) % KEPT;
    }

    /// Returns the one vehicle with this identifier among those with this bit rate.
    fn owner(&self, id: CanId, bitrate: u32) -> Option<&'static Vehicle> {
        let mut owners =
            self.vehicles.iter().copied().filter(|vehicle| vehicle.bitrate == bitrate && vehicle.has_id(id));
        let owner = owners.next();
        owner.filter(|_| owners.next().is_none())
    }

    fn search(&mut self, id: CanId, bitrate: u32, now: Millis) -> Option<Found> {
        let owner = self.owner(id, bitrate)?;
        let same = self.evidence.filter(|evidence| core::ptr::eq(evidence.vehicle, owner));
        let mut evidence = same.unwrap_or(Evidence::of(owner, now));
        let sureness = evidence.add(id, now);
        self.evidence = Some(evidence);
        self.found = sureness.map(|sureness| Found { vehicle: owner, sureness, at: now });
        self.found
    }

    /// Lets the sureness of what was found grow, and the doubt.
    fn observe(&mut self, found: Found, id: CanId, bitrate: u32, now: Millis) {
        if found.vehicle.has_id(id) {
            if found.sureness == Sureness::Likely
                && let Some(sureness) = self.evidence.as_mut().and_then(|evidence| evidence.add(id, now))
            {
                self.found = Some(Found { sureness, ..found });
            }
            return;
        }
        let Some(other) = self.owner(id, bitrate) else { return };
        let same = self.doubt.filter(|doubt| core::ptr::eq(doubt.vehicle, other));
        let mut doubt = same.unwrap_or(Evidence::of(other, now));
        if doubt.add(id, now).is_some() {
            self.contradiction = Some(other);
        }
        self.doubt = Some(doubt);
    }
}

/// Chooses the bit rate at which to listen for a vehicle.
///
/// A silent bus says nothing of its rate: the choice stays where it is, so that the first frame of the right rate is
/// not missed. Errors without frames move it on; a rate at which frames were heard is given up late.
#[derive(Clone)]
pub struct Dial {
    vehicles: &'static [&'static Vehicle],
    bitrate: u32,
    /// When the rate was chosen, or the last frame was heard at it.
    since: Millis,
    is_trusted: bool,
}

impl Dial {
    /// Returns a dial at the lowest bit rate of the vehicles: there the others give errors soonest.
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
