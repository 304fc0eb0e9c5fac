//! What an instrument keeps over power-off: which parts, when each is due, how it is restored.
//!
//! A part is a few bytes under a number of its own; where they are kept is somebody else's business. Numbers stand for
//! ever. A part grows at its end only: whoever finds it shorter takes the rest as it is at first, whoever finds it
//! longer leaves the rest alone.
//!
//! | number       | part       | bytes                                                          | due                     |
//! |--------------|------------|----------------------------------------------------------------|-------------------------|
//! | 1            | `Distance` | 7: counts of the odometer; topmost bit = not known             | every 0.1 km, stopped   |
//! | 2            | `Trips`    | 64: both trips: way, way with known power, used, regained      | every 1 km, stopped, reset, every 5 min |
//! | 3            | `Settings` | 2: language, theme                                             | changed                 |
//! | 4            | `Vehicle`  | its name                                                       | another is certain      |
//! | 5            | `Starts`   | 13: power-ons, watchdog, panics, last cause                    | every start             |
//! | 6            | `Workshop` | written by a workshop's tool alone (docs/store.md)             | never                   |
//! | 32 to 63     | `Fault`    | `faults`                                                       | it came, worsened, came again |
//!
//! Numbers of more than a byte have their low byte first. Nothing is due before [`Keeper::begin`]: what was kept is
//! never overwritten by an instrument that has not been told of it.

mod faults;

use crate::cluster::Cluster;
use crate::own::Restart;
use crate::trips::odometer::PER_KM;
pub use faults::KeptFault;
use faults::Ledger;
use heapless::Vec;
use protocol_core::Millis;
use protocol_core::model::{Shown, Value};

/// Longest part.
pub const PART_BYTES: usize = 64;
/// Distance after which the trips are due, in counts of the odometer.
const TRIPS_EVERY: u64 = PER_KM;
/// Time after which the trips are due for their energy alone, in milliseconds.
const ENERGY_EVERY_MS: u64 = 300_000;
/// First number of a fault.
const FIRST_FAULT: u8 = 32;

/// The bytes of a part.
pub type Bytes = Vec<u8, PART_BYTES>;

/// A part of what is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The odometer.
    Distance,
    /// Both trips with their energy.
    Trips,
    /// What the driver has chosen.
    Settings,
    /// The vehicle that was certain last.
    Vehicle,
    /// How often and why the instrument has started.
    Starts,
    /// What a workshop has set.
    Workshop,
    /// An entry of the fault history.
    Fault(u8),
}

impl Part {
    /// Every part that is there once, in the order in which they are saved.
    pub const SINGLE: [Self; 6] =
        [Self::Settings, Self::Distance, Self::Trips, Self::Vehicle, Self::Starts, Self::Workshop];

    /// Returns the number under which it is kept.
    pub const fn number(self) -> u8 {
        match self {
            Self::Distance => 1,
            Self::Trips => 2,
            Self::Settings => 3,
            Self::Vehicle => 4,
            Self::Starts => 5,
            Self::Workshop => 6,
            Self::Fault(place) => FIRST_FAULT + place,
        }
    }

    /// Returns the part that is kept under a number.
    pub fn from_number(number: u8) -> Option<Self> {
        let fault = number.checked_sub(FIRST_FAULT).filter(|place| usize::from(*place) < faults::PLACES);
        let single = Self::SINGLE.into_iter().find(|part| part.number() == number);
        single.or(fault.map(Self::Fault))
    }
}

/// How what was kept was found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Memory {
    /// Nothing was ever kept: the instrument is new, and its distance is zero.
    #[default]
    New,
    /// It is there.
    Kept,
    /// It cannot be read, or not be written: the distance is not known unless it was restored.
    Damaged,
}

/// A distance as it is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Distance {
    /// Counts of the odometer, 921 600 000 in a kilometre.
    pub counts: u64,
    /// It is the vehicle's, not only what was driven since the last one was lost.
    pub is_known: bool,
}

impl Distance {
    const UNKNOWN: u64 = 1 << 55;

    /// Returns a known distance in metres.
    pub const fn of_metres(metres: u64) -> Self {
        Self { counts: metres * (PER_KM / 1_000), is_known: true }
    }

    /// Returns the distance in metres, rounded down.
    pub const fn metres(self) -> u64 {
        self.counts / (PER_KM / 1_000)
    }

    /// Returns the bytes that are kept.
    pub fn to_bytes(self) -> [u8; 7] {
        let flag = if self.is_known { 0 } else { Self::UNKNOWN };
        let [a, b, c, d, e, f, g, _] = (self.counts.min(Self::UNKNOWN - 1) | flag).to_le_bytes();
        [a, b, c, d, e, f, g]
    }

    /// Returns the distance of bytes that were kept; `None` = they are none.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let [a, b, c, d, e, f, g] = *bytes.first_chunk()?;
        let word = u64::from_le_bytes([a, b, c, d, e, f, g, 0]);
        Some(Self { counts: word & (Self::UNKNOWN - 1), is_known: word & Self::UNKNOWN == 0 })
    }

    /// The step of which each is saved.
    const fn step(self) -> (u64, bool) {
        (self.counts / (PER_KM / 10), self.is_known)
    }
}

/// Reads eight-byte numbers, low byte first; missing ones are zero.
pub(crate) fn numbers(bytes: &[u8]) -> impl Iterator<Item = u64> {
    let words = bytes.chunks_exact(8).filter_map(|word| word.first_chunk().copied());
    words.map(u64::from_le_bytes).chain(core::iter::repeat(0))
}

/// How often and why the instrument has started.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Starts {
    /// Starts that no fault of its own has caused: supply, RUN pin, a new image.
    pub power_ons: u32,
    /// Starts by the watchdog.
    pub watchdogs: u32,
    /// Starts after a panic or a hard fault.
    pub panics: u32,
    /// Cause of the last: 0 power-on, 1 watchdog, 2 panic.
    pub last: u8,
}

impl Starts {
    /// Returns all starts.
    pub fn all(self) -> u32 {
        self.power_ons.saturating_add(self.watchdogs).saturating_add(self.panics)
    }

    fn count(&mut self, restart: Option<Restart>) {
        let (count, last) = match restart {
            None => (&mut self.power_ons, 0),
            Some(Restart::Watchdog) => (&mut self.watchdogs, 1),
            Some(Restart::Panic(_)) => (&mut self.panics, 2),
        };
        *count = count.saturating_add(1);
        self.last = last;
    }

    fn to_bytes(self) -> Bytes {
        let counts = [self.power_ons, self.watchdogs, self.panics];
        counts.into_iter().flat_map(u32::to_le_bytes).chain([self.last]).collect()
    }

    /// Returns the starts of bytes that were kept.
    pub fn from_bytes(bytes: &[u8]) -> Self {
        let mut counts =
            bytes.chunks_exact(4).filter_map(|word| word.first_chunk().copied()).map(u32::from_le_bytes);
        let mut next = || counts.next().unwrap_or(0);
        let (power_ons, watchdogs, panics) = (next(), next(), next());
        Self { power_ons, watchdogs, panics, last: bytes.get(12).copied().unwrap_or(0) }
    }
}

/// That a workshop has set the odometer, and what it was before: the record of a deliberate act.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Workshop {
    /// How often it was set, over the life of the instrument.
    pub times: u32,
    /// What it was before the last time; `None` = nothing was kept.
    pub before: Option<Distance>,
    /// What it was set to.
    pub after: Distance,
    /// Who did it, or on what order, as far as there is room.
    pub by: Vec<u8, 40>,
}

impl Workshop {
    /// Returns the bytes that are kept: times, before (all ones = nothing), after, who.
    pub fn to_bytes(&self) -> Bytes {
        let before = self.before.map_or([0xFF; 7], Distance::to_bytes);
        let numbers = self.times.to_le_bytes().into_iter().chain(before).chain(self.after.to_bytes());
        numbers.chain(self.by.iter().copied()).collect()
    }

    /// Returns the record of bytes that were kept; `None` = they are none.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (times, rest) = bytes.split_first_chunk()?;
        let (before, rest) = rest.split_first_chunk::<7>()?;
        let (after, by) = rest.split_first_chunk::<7>()?;
        Some(Self {
            times: u32::from_le_bytes(*times),
            before: Distance::from_bytes(before).filter(|_| *before != [0xFF; 7]),
            after: Distance::from_bytes(after)?,
            by: by.iter().copied().take(40).collect(),
        })
    }
}

/// What was saved last, and so what is due.
#[derive(Clone)]
pub(crate) struct Keeper {
    may_save: bool,
    /// As they were saved, in the order of [`Part::SINGLE`].
    saved: [Bytes; Part::SINGLE.len()],
    /// When the trips were saved last.
    trips_at: Millis,
    starts: Starts,
    ledger: Ledger,
}

impl Keeper {
    pub(crate) const fn new() -> Self {
        Self {
            may_save: false,
            saved: [const { Bytes::new() }; Part::SINGLE.len()],
            trips_at: Millis(0),
            starts: Starts { power_ons: 0, watchdogs: 0, panics: 0, last: 0 },
            ledger: Ledger::new(),
        }
    }

    /// Takes a part that was kept.
    pub(crate) fn restore(&mut self, cluster: &mut Cluster, part: Part, bytes: &[u8]) {
        match part {
            Part::Fault(place) => self.ledger.take(place, bytes),
            Part::Starts => self.starts = Starts::from_bytes(bytes),
            part => cluster.restore_part(part, bytes),
        }
        if let Some(saved) = self.saved_mut(part) {
            saved.clear();
            // A longer part of a later firmware differs, and is saved anew.
            let _ = saved.extend_from_slice(bytes);
        }
    }

    /// Takes note that everything that was kept has been restored: from now on parts are due.
    pub(crate) fn begin(&mut self, cluster: &mut Cluster, memory: Memory, restart: Option<Restart>) {
        let has_distance = self.saved(Part::Distance).is_some_and(|saved| !saved.is_empty());
        match memory {
            Memory::New => cluster.start_distance(),
            Memory::Kept | Memory::Damaged if !has_distance => cluster.forget_distance(),
            Memory::Kept | Memory::Damaged => {}
        }
        self.starts.count(restart);
        self.recall(cluster);
        self.may_save = true;
    }

    /// Gives the cluster the faults that are kept of its vehicle.
    pub(crate) fn recall(&self, cluster: &mut Cluster) {
        let vehicle = faults::tag(cluster.vehicle().name);
        self.ledger.recall(vehicle, |entry| cluster.remember(entry));
    }

    fn saved(&self, part: Part) -> Option<&Bytes> {
        Part::SINGLE.into_iter().zip(&self.saved).find(|(other, _)| *other == part).map(|(_, saved)| saved)
    }

    fn saved_mut(&mut self, part: Part) -> Option<&mut Bytes> {
        Part::SINGLE
            .into_iter()
            .zip(&mut self.saved)
            .find(|(other, _)| *other == part)
            .map(|(_, saved)| saved)
    }

    /// Returns the name of the vehicle that was certain last; empty = none is known.
    pub(crate) fn vehicle(&self) -> &[u8] {
        self.saved(Part::Vehicle).map_or(&[], |name| name.as_slice())
    }

    /// Returns what is to be saved next; `is_certain` tells whether the cluster's vehicle is.
    pub(crate) fn due(&self, cluster: &Cluster, is_certain: bool, now: Millis) -> Option<(Part, Bytes)> {
        if !self.may_save {
            return None;
        }
        let is_standing = cluster.shown(Value::VehicleSpeed, now) == Shown::Value(0);
        for (part, saved) in Part::SINGLE.into_iter().zip(&self.saved) {
            let bytes = match part {
                Part::Starts => self.starts.to_bytes(),
                Part::Vehicle if !is_certain => continue,
                part => cluster.part(part),
            };
            if bytes != *saved && !bytes.is_empty() && self.is_due(part, saved, &bytes, is_standing, now) {
                return Some((part, bytes));
            }
        }
        let stamp = faults::Stamp {
            start: self.starts.all(),
            hectometres: cluster.hectometres(),
            vehicle: faults::tag(cluster.vehicle().name),
        };
        self.ledger.due(cluster.remembered_faults(), stamp, now)
    }

    /// Returns whether a part that has changed is to be saved now.
    fn is_due(&self, part: Part, saved: &[u8], bytes: &[u8], is_standing: bool, now: Millis) -> bool {
        match part {
            Part::Distance => {
                let [before, after] =
                    [saved, bytes].map(|bytes| Distance::from_bytes(bytes).map(Distance::step));
                is_standing || before != after
            }
            Part::Trips => {
                let ways = |bytes| numbers(bytes).step_by(4).take(2);
                let is_moved = ways(saved).ne(ways(bytes));
                let is_far = |(before, after): (u64, u64)| after < before || after - before >= TRIPS_EVERY;
                saved.is_empty()
                    || is_standing && is_moved
                    || ways(saved).zip(ways(bytes)).any(is_far)
                    || now.since(self.trips_at) >= ENERGY_EVERY_MS
            }
            _ => true,
        }
    }

    /// Takes note that a part has been saved.
    pub(crate) fn saved_now(&mut self, part: Part, bytes: &Bytes, now: Millis) {
        match part {
            Part::Trips => self.trips_at = now,
            Part::Fault(place) => self.ledger.saved(place, bytes, now),
            _ => {}
        }
        if let Some(saved) = self.saved_mut(part) {
            saved.clone_from(bytes);
        }
    }
}
