//! Which vehicle this is, told from the identifiers on its bus.
//!
//! Owns the evidence and the frames heard so far, so that nothing is lost while it is gathered.
//!
//! | what is heard                                | what it says                                           |
//! |----------------------------------------------|--------------------------------------------------------|
//! | a 29-bit identifier of one vehicle           | speaks for it                                          |
//! | a message of one vehicle, check byte right   | speaks for it, and proves it                           |
//! | an 11-bit identifier without a check byte    | a frame of it, no more: any vehicle may have that one  |
//! | a message of one vehicle, check byte wrong   | starts the evidence anew                               |
//! | an identifier of another vehicle             | starts the evidence anew                               |
//! | an identifier that no vehicle or several have | nothing                                               |
//!
//! A vehicle is certain after [`DISTINCT`] different identifiers that speak for it in a row, a vehicle with check bytes
//! only with proof among them; it is likely if its frames just keep coming. A likely vehicle may be shown but not
//! answered, and gives way to one that becomes certain. A certain one stays until power-off: a bus that contradicts it
//! raises a doubt, and never another picture under way. Refuses to know the controller and what the messages mean.
//! Source: BUS-11 (all bits of an identifier count); no two vehicles share a 29-bit identifier (contract test).

use crate::own::Search;
use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, CanId, Millis};

/// Different identifiers of one vehicle that make it certain; all of them, again and again, if it has fewer.
pub const DISTINCT: usize = 3;
/// Frames in a row that make a vehicle likely.
pub const REPEATS: u32 = 20;
/// Time over which those frames must come, in milliseconds.
pub const REPEATS_SPAN_MS: u64 = 1_000;
/// Time after its last frame for which another vehicle is held to be on the bus, in milliseconds.
const DOUBT_MS: u64 = 5_000;
/// Frames kept for the cluster until the vehicle is certain; beyond that the oldest go, they are worth least.
pub const KEPT: usize = 32;

/// How sure a recognition is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sureness {
    /// Its frames come again and again, and none of another vehicle: good enough to be shown.
    Likely,
    /// Enough different identifiers, proven where it can be, and nothing against it between them: may be answered.
    Certain,
}

/// What was recognised.
#[derive(Clone, Copy)]
pub struct Found {
    /// Vehicle whose identifiers came.
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
    /// Identifiers that tell it from other vehicles.
    ids: [Option<CanId>; DISTINCT],
    /// A check byte was right.
    is_proven: bool,
    frames: u32,
    since: Millis,
}

impl Evidence {
    const fn of(vehicle: &'static Vehicle, now: Millis) -> Self {
        Self { vehicle, ids: [None; DISTINCT], is_proven: false, frames: 0, since: now }
    }

    /// Adds a frame with an identifier of the vehicle and returns how sure that makes it.
    fn add(&mut self, frame: &CanFrame, now: Millis) -> Option<Sureness> {
        let check = check(self.vehicle, frame);
        if check == Some(false) {
            *self = Self::of(self.vehicle, now);
            return None;
        }
        self.frames = self.frames.saturating_add(1);
        self.is_proven |= check == Some(true);
        let tells = check == Some(true) || frame.id.is_extended();
        let place = self.ids.iter_mut().find(|known| known.is_none_or(|known| known == frame.id));
        if let Some(place) = place.filter(|_| tells) {
            *place = Some(frame.id);
        }
        let distinct = self.ids.iter().flatten().count();
        let lasts = now.since(self.since) >= REPEATS_SPAN_MS && self.frames >= REPEATS;
        let enough = distinct >= DISTINCT || distinct >= self.vehicle.ids.len() && lasts;
        if enough && (self.is_proven || !has_check_bytes(self.vehicle)) {
            Some(Sureness::Certain)
        } else {
            lasts.then_some(Sureness::Likely)
        }
    }
}

/// Returns whether the check byte of a frame is right; `None` = its message has none.
fn check(vehicle: &Vehicle, frame: &CanFrame) -> Option<bool> {
    let message = vehicle.index_of(frame.id).and_then(|index| vehicle.rx.get(usize::from(index)))?;
    let checksum = message.checksum?;
    Some(frame.len() >= message.len && checksum.holds(frame.padded()))
}

fn has_check_bytes(vehicle: &Vehicle) -> bool {
    vehicle.rx.iter().any(|message| message.checksum.is_some())
}

/// Tells the vehicle from what is heard.
#[derive(Clone)]
pub struct Detector {
    vehicles: &'static [&'static Vehicle],
    evidence: Option<Evidence>,
    found: Option<Found>,
    /// Another vehicle for which as much speaks as for the one found, and its last frame.
    contradiction: Option<(&'static Vehicle, Millis)>,
    kept: [Option<(CanFrame, Millis)>; KEPT],
    next: usize,
}

impl Detector {
    /// Returns a detector that has heard nothing.
    pub const fn new(vehicles: &'static [&'static Vehicle]) -> Self {
        Self { vehicles, evidence: None, found: None, contradiction: None, kept: [None; KEPT], next: 0 }
    }

    /// Takes a frame that was heard at `bitrate`; returns the vehicle that it has made known: once, or a second time in
    /// place of one that was only likely.
    ///
    /// Until a vehicle is certain the frame is kept for [`Self::take_kept`].
    pub fn hear(&mut self, frame: &CanFrame, bitrate: u32, now: Millis) -> Option<Found> {
        if let Some(found) = self.found.filter(|found| found.sureness == Sureness::Certain) {
            self.observe(found, frame, bitrate, now);
            return None;
        }
        self.keep(frame, now);
        self.search(frame, bitrate, now)
    }

    /// Returns what was recognised; its sureness may still grow.
    pub fn found(&self) -> Option<Found> {
        self.found
    }

    /// Returns whether the cluster may take part in the bus: the vehicle is certain.
    pub fn may_answer(&self) -> bool {
        self.found.is_some_and(|found| found.sureness == Sureness::Certain)
    }

    /// Returns the other vehicle for which as much speaks as for the one found, as long as it is heard: something is
    /// wrong with this bus.
    pub fn contradiction(&self, now: Millis) -> Option<&'static Vehicle> {
        let (vehicle, heard) = self.contradiction?;
        (now.since(heard) < DOUBT_MS).then_some(vehicle)
    }

    /// Returns what the driver should know of the search.
    pub fn state(&self, now: Millis) -> Search {
        match (self.found, self.contradiction(now)) {
            (None, _) => Search::Listening,
            (Some(_), Some(_)) => Search::Contradicted,
            (Some(Found { at, .. }), None) => Search::Found { at },
        }
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

    /// Adds to the evidence for the owner of `id`; that for another vehicle ends.
    fn weigh(&mut self, frame: &CanFrame, owner: &'static Vehicle, now: Millis) -> Option<Sureness> {
        let same = self.evidence.filter(|evidence| core::ptr::eq(evidence.vehicle, owner));
        let mut evidence = same.unwrap_or(Evidence::of(owner, now));
        let sureness = evidence.add(frame, now);
        self.evidence = Some(evidence);
        sureness
    }

    fn search(&mut self, frame: &CanFrame, bitrate: u32, now: Millis) -> Option<Found> {
        let owner = self.owner(frame.id, bitrate)?;
        let sureness = self.weigh(frame, owner, now)?;
        let new = Found { vehicle: owner, sureness, at: now };
        match self.found {
            None => self.found = Some(new),
            Some(found) if core::ptr::eq(found.vehicle, owner) => {
                self.found = Some(Found { sureness: sureness.max(found.sureness), ..found });
                return None;
            }
            Some(_) if sureness == Sureness::Certain => (self.found, self.contradiction) = (Some(new), None),
            Some(_) => {
                self.contradiction = Some((owner, now));
                return None;
            }
        }
        self.found
    }

    /// Looks for what contradicts a certain vehicle; its own frames say nothing new.
    fn observe(&mut self, found: Found, frame: &CanFrame, bitrate: u32, now: Millis) {
        if found.vehicle.has_id(frame.id) {
            return;
        }
        let Some(other) = self.owner(frame.id, bitrate) else { return };
        if self.weigh(frame, other, now).is_some() {
            self.contradiction = Some((other, now));
        }
    }
}
