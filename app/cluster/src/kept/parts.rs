//! The parts that are kept, and their bytes.
//!
//! Refuses to know what is due when, and where the values come from.

use crate::own::Restart;
use heapless::Vec;

/// Speed counts (1/256 km/h) times milliseconds in one kilometre: what distances are counted in.
pub(crate) const PER_KM: u64 = 256 * 3_600_000;
/// Places for faults.
pub(crate) const FAULTS: usize = 32;
/// Longest part.
pub const PART_BYTES: usize = 64;
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
        let fault = number.checked_sub(FIRST_FAULT).filter(|place| usize::from(*place) < FAULTS);
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
    pub(crate) const fn step(self) -> (u64, bool) {
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

    pub(crate) fn count(&mut self, restart: Option<Restart>) {
        let (count, last) = match restart {
            None => (&mut self.power_ons, 0),
            Some(Restart::Watchdog) => (&mut self.watchdogs, 1),
            Some(Restart::Panic(_)) => (&mut self.panics, 2),
        };
        *count = count.saturating_add(1);
        self.last = last;
    }

    pub(crate) fn to_bytes(self) -> Bytes {
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
