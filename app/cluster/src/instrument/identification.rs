//! Which vehicle this is, told from the identifiers on its bus.
//!
//! Owns the evidence and the frames heard so far, so that nothing is lost while it is gathered.
//!
//! | what is heard                                | what it says                                           |
//! |----------------------------------------------|--------------------------------------------------------|
//! | a 29-bit identifier of one vehicle           | speaks for it                                          |
//! | a message of one vehicle, check byte right   | speaks for it, and proves it                           |
//! | a life counter that has counted by one       | proves it, if its messages have no check bytes         |
//! | an 11-bit identifier without a check byte    | a frame of it, no more: any vehicle may have that one  |
//! | a message of one vehicle, check byte wrong   | starts the evidence anew                               |
//! | an identifier of another vehicle             | starts the evidence anew, until a vehicle is found     |
//! | an identifier that no vehicle or several have | nothing                                               |
//!
//! A vehicle is certain after [`DISTINCT`] different identifiers that speak for it in a row, with proof; without check
//! bytes [`UNPROVEN`] frames in a row are as good. It is likely if its frames just keep coming: then it is shown, and
//! not answered. Identifiers alone never make a vehicle of fewer certain.
//!
//! What was found can be wrong. As much evidence for another vehicle is a doubt, for as long as that one is heard; while
//! there is doubt nothing may be sent. The vehicle found gives way to one that is surer, and to any that was recognised
//! beside it once it has been silent for [`SILENT_MS`]; two that are both heard leave the first one. Refuses to know
//! the controller and what the messages mean.
//! Source: BUS-11 (all bits of an identifier count), BUS-R021 (counters count by one); no two vehicles share a 29-bit
//! identifier (contract test).

use crate::own::Search;
use crate::reception::MAX_MESSAGES;
use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, CanId, Millis};

/// Different identifiers of one vehicle that make it certain; all of them, again and again, if it has fewer.
pub const DISTINCT: usize = 3;
/// Frames in a row that make up for a proof where no message has a check byte: what a tester sends once is fewer.
pub const UNPROVEN: u32 = 6;
/// Frames in a row that make a vehicle likely: a wire with one message of 200 ms has them after a second.
pub const REPEATS: u32 = 6;
/// Time over which those frames must come, in milliseconds.
pub const REPEATS_SPAN_MS: u64 = 1_000;
/// Silence of the vehicle found after which it gives way to another one that was recognised, in milliseconds: with the
/// second that recognition takes, the right one is shown 3 s after its first frame at the latest.
pub const SILENT_MS: u64 = 2_000;
/// Time after its last frame for which another vehicle is held to be on the bus, in milliseconds.
const DOUBT_MS: u64 = 5_000;
/// Changes between the frames of two vehicles, less than [`DOUBT_MS`] apart, that are a doubt before any is found.
const TURNS: u32 = 20;
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
#[derive(Clone)]
struct Evidence {
    vehicle: &'static Vehicle,
    /// Identifiers that tell it from other vehicles.
    ids: [Option<CanId>; DISTINCT],
    /// A check byte was right or a life counter has counted.
    is_proven: bool,
    frames: u32,
    since: Millis,
    last: Millis,
    /// Life counters of its messages; of those heard, bit n = message n.
    lives: [u8; MAX_MESSAGES],
    heard: u64,
}

const _: () = assert!(MAX_MESSAGES <= u64::BITS as usize, "one bit per message");

impl Evidence {
    const fn of(vehicle: &'static Vehicle, now: Millis) -> Self {
        Self {
            vehicle,
            ids: [None; DISTINCT],
            is_proven: false,
            frames: 0,
            since: now,
            last: now,
            lives: [0; MAX_MESSAGES],
            heard: 0,
        }
    }

    /// Adds a frame with an identifier of the vehicle and returns how sure that makes it.
    fn add(&mut self, frame: &CanFrame, now: Millis) -> Option<Sureness> {
        let check = check(self.vehicle, frame);
        if check == Some(false) {
            *self = Self::of(self.vehicle, now);
            return None;
        }
        self.last = now;
        self.frames = self.frames.saturating_add(1);
        let has_checks = has_check_bytes(self.vehicle);
        self.is_proven |= check == Some(true) || self.has_counted(frame) && !has_checks;
        let tells = check == Some(true) || frame.id.is_extended();
        let place = self.ids.iter_mut().find(|known| known.is_none_or(|known| known == frame.id));
        if let Some(place) = place.filter(|_| tells) {
            *place = Some(frame.id);
        }
        let distinct = self.ids.iter().flatten().count();
        let lasts = now.since(self.since) >= REPEATS_SPAN_MS && self.frames >= REPEATS;
        let is_as_good = !has_checks && self.frames >= UNPROVEN;
        let is_certain = distinct >= DISTINCT && (self.is_proven || is_as_good)
            || distinct >= self.vehicle.ids.len() && lasts && self.is_proven;
        if is_certain { Some(Sureness::Certain) } else { lasts.then_some(Sureness::Likely) }
    }

    /// Returns whether the life counter of the frame's message is one further than in the frame before.
    fn has_counted(&mut self, frame: &CanFrame) -> bool {
        let Some(index) = self.vehicle.index_of(frame.id).map(usize::from) else { return false };
        let Some(life) = self.vehicle.rx.get(index).and_then(|message| message.life) else { return false };
        let Some(last) = self.lives.get_mut(index) else { return false };
        let count = frame.padded().get(usize::from(life.byte)).copied().unwrap_or(0) & life.mask;
        let step = count.wrapping_sub(core::mem::replace(last, count)) & life.mask;
        let was_heard = self.heard >> index & 1 != 0;
        self.heard |= 1 << index;
        was_heard && u32::from(step) == 1 << life.mask.trailing_zeros()
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
    /// What speaks for the vehicle found, or for the one heard last while none is.
    evidence: Option<Evidence>,
    /// What speaks for another one beside the vehicle found.
    rival: Option<Evidence>,
    found: Option<Found>,
    /// When the vehicle found was heard last.
    heard: Millis,
    /// Another vehicle for which as much speaks as for the one found, and its last frame.
    contradiction: Option<(&'static Vehicle, Millis)>,
    /// Changes between the frames of several vehicles while none is found, and the last of them.
    turns: (u32, Millis),
    kept: [Option<(CanFrame, Millis)>; KEPT],
    next: usize,
}

impl Detector {
    /// Returns a detector that has heard nothing.
    pub const fn new(vehicles: &'static [&'static Vehicle]) -> Self {
        Self {
            vehicles,
            evidence: None,
            rival: None,
            found: None,
            heard: Millis(0),
            contradiction: None,
            turns: (0, Millis(0)),
            kept: [None; KEPT],
            next: 0,
        }
    }

    /// Takes a frame that was heard at `bitrate`; returns the vehicle that it has made known: the first one, or one in
    /// whose place another was held to be the right one.
    ///
    /// Until a vehicle is certain the frame is kept for [`Self::take_kept`].
    pub fn hear(&mut self, frame: &CanFrame, bitrate: u32, now: Millis) -> Option<Found> {
        let is_certain = self.found.is_some_and(|found| found.sureness == Sureness::Certain);
        if !is_certain {
            self.keep(frame, now);
        }
        let owner = self.owner(frame.id, bitrate)?;
        let is_found = self.found.is_some_and(|found| core::ptr::eq(found.vehicle, owner));
        if is_found {
            self.heard = now;
            if is_certain {
                return None;
            }
        }
        let sureness = self.weigh(frame, owner, is_found, now)?;
        match &mut self.found {
            Some(found) if is_found => found.sureness = found.sureness.max(sureness),
            Some(found) if sureness <= found.sureness && now.since(self.heard) < SILENT_MS => {
                self.contradiction = Some((owner, now));
            }
            _ => return Some(self.become_sure_of(owner, sureness, now)),
        }
        None
    }

    /// Takes `vehicle` for the right one, whatever was found before.
    fn become_sure_of(&mut self, vehicle: &'static Vehicle, sureness: Sureness, now: Millis) -> Found {
        if self.found.is_some() {
            self.evidence = self.rival.take();
        }
        let found = Found { vehicle, sureness, at: now };
        (self.found, self.heard, self.contradiction) = (Some(found), now, None);
        found
    }

    /// Returns what was recognised; its sureness may still grow.
    pub fn found(&self) -> Option<Found> {
        self.found
    }

    /// Returns whether the cluster may take part in the bus: the vehicle is certain, and nothing speaks against it.
    pub fn may_answer(&self, now: Millis) -> bool {
        let is_certain = self.found.is_some_and(|found| found.sureness == Sureness::Certain);
        is_certain && self.contradiction(now).is_none()
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
            (None, _) if self.turns.0 >= TURNS && now.since(self.turns.1) < DOUBT_MS => Search::Contradicted,
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

    /// Adds to the evidence for `owner`, which ends by long silence, and that for another vehicle by this frame.
    fn weigh(
        &mut self,
        frame: &CanFrame,
        owner: &'static Vehicle,
        is_found: bool,
        now: Millis,
    ) -> Option<Sureness> {
        let is_rival = self.found.is_some() && !is_found;
        let slot = if is_rival { &mut self.rival } else { &mut self.evidence };
        let is_another = slot.as_ref().is_some_and(|evidence| !core::ptr::eq(evidence.vehicle, owner));
        let is_old = slot.as_ref().is_some_and(|evidence| now.since(evidence.last) >= DOUBT_MS);
        if is_another || is_old {
            *slot = None;
        }
        if is_another && self.found.is_none() {
            let (turns, last) = self.turns;
            let before = if now.since(last) < DOUBT_MS { turns } else { 0 };
            self.turns = (before.saturating_add(1), now);
        }
        slot.get_or_insert_with(|| Evidence::of(owner, now)).add(frame, now)
    }
}
