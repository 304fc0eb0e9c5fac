//! The fault history as it is kept: one part for each entry, with where and in which run it came.
//!
//! The only file that knows both the history's entries and what is kept of them.
//!
//! | bytes    | what                                                             |
//! |----------|------------------------------------------------------------------|
//! | 0 to 15  | [`Entry::to_bytes`]; its times count from the start of their run |
//! | 16 to 19 | start in which it came first, counted over all starts            |
//! | 20 to 23 | start in which it came last                                      |
//! | 24 to 27 | odometer when it came last, in 0.1 km                            |
//! | 28 to 31 | [`tag`] of the vehicle                                           |
//!
//! An entry is due at once when it is new or has become worse; that it has come once more, at most every 10 s.

use super::parts::{Bytes, FAULTS, Part};
use crate::faults::Entry;
use crate::faults::memory::{ENTRY_BYTES, HISTORY, History};
use heapless::Vec;
use protocol_core::Millis;
use protocol_core::model::Severity;

/// Places for entries.
const PLACES: usize = FAULTS;
/// Time between two saves of entries that have only come once more, in milliseconds.
const COUNT_EVERY_MS: u64 = 10_000;
/// Where the time of the first coming stands in an entry.
const FIRST: core::ops::Range<usize> = 6..11;

/// Where and when the instrument is.
#[derive(Clone, Copy)]
pub(crate) struct Stamp {
    pub(crate) start: u32,
    pub(crate) hectometres: u32,
    pub(crate) vehicle: u32,
}

/// Returns what tells the entries of one vehicle from those of another: FNV-1a of its name.
pub(crate) fn tag(name: &str) -> u32 {
    name.bytes().fold(0x811C_9DC5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

/// A kept entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KeptFault {
    /// The entry; its times count from the start of their run.
    pub entry: Entry,
    /// Start in which it came first.
    pub first_start: u32,
    /// Start in which it came last.
    pub last_start: u32,
    /// Odometer when it came last, in 0.1 km.
    pub hectometres: u32,
    /// [`tag`] of the vehicle.
    vehicle: u32,
}

impl KeptFault {
    fn to_bytes(self) -> Bytes {
        let numbers = [self.first_start, self.last_start, self.hectometres, self.vehicle];
        self.entry.to_bytes().into_iter().chain(numbers.into_iter().flat_map(u32::to_le_bytes)).collect()
    }

    /// Returns the entry of bytes that were kept; `None` = they are none.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let entry = Entry::from_bytes(bytes.first_chunk()?)?;
        let number =
            |at| bytes.get(at..).and_then(<[u8]>::first_chunk).map_or(0, |word| u32::from_le_bytes(*word));
        Some(Self {
            entry,
            first_start: number(16),
            last_start: number(20),
            hectometres: number(24),
            vehicle: number(28),
        })
    }

    fn is_of(&self, vehicle: u32, entry: &Entry) -> bool {
        (self.vehicle, self.entry.fault, self.entry.code) == (vehicle, entry.fault, entry.code)
    }

    fn weight(entry: &Entry) -> (Severity, u16) {
        (entry.severity, entry.count)
    }
}

/// What is kept at each place.
#[derive(Clone)]
pub(crate) struct Ledger {
    places: [Option<KeptFault>; PLACES],
    saved_at: Millis,
}

impl Ledger {
    pub(crate) const fn new() -> Self {
        Self { places: [None; PLACES], saved_at: Millis(0) }
    }

    /// Takes what was kept at a place.
    pub(crate) fn take(&mut self, place: u8, bytes: &[u8]) {
        if let Some(kept) = self.places.get_mut(usize::from(place)) {
            *kept = KeptFault::from_bytes(bytes);
        }
    }

    /// Tells every kept entry of a vehicle, the one that came last at the end; none of them has come in this run.
    pub(crate) fn recall(&self, vehicle: u32, mut remember: impl FnMut(Entry)) {
        let mut kept: Vec<&KeptFault, PLACES> =
            self.places.iter().flatten().filter(|kept| kept.vehicle == vehicle).collect();
        kept.sort_unstable_by_key(|kept| (kept.last_start, kept.entry.last));
        for kept in kept {
            remember(Entry { first: Millis(0), last: Millis(0), ..kept.entry });
        }
    }

    /// Returns the entry that is to be saved next, and its place.
    pub(crate) fn due(&self, history: &History, stamp: Stamp, now: Millis) -> Option<(Part, Bytes)> {
        let may_count = now.since(self.saved_at) >= COUNT_EVERY_MS;
        for entry in history.iter() {
            let kept =
                self.places.iter().position(|kept| kept.is_some_and(|kept| kept.is_of(stamp.vehicle, entry)));
            let old = kept.and_then(|place| self.places.get(place).copied().flatten());
            let is_due = old.is_none_or(|old| {
                old.entry.severity < entry.severity
                    || may_count && KeptFault::weight(&old.entry) != KeptFault::weight(entry)
            });
            if !is_due {
                continue;
            }
            let place = kept.or_else(|| self.free(history, stamp.vehicle))?;
            let fault = KeptFault {
                entry: *entry,
                first_start: old.map_or(stamp.start, |old| old.first_start),
                last_start: stamp.start,
                hectometres: stamp.hectometres,
                vehicle: stamp.vehicle,
            };
            let mut bytes = fault.to_bytes();
            if let Some(old) = old.map(|old| old.entry.to_bytes())
                && let (Some(to), Some(from)) = (bytes.get_mut(FIRST), old.get(FIRST))
            {
                to.copy_from_slice(from);
            }
            return Some((Part::Fault(place as u8), bytes));
        }
        None
    }

    /// Returns a place that is free, or that of the oldest entry that the history has let go.
    fn free(&self, history: &History, vehicle: u32) -> Option<usize> {
        let is_gone = |kept: &KeptFault| !history.iter().any(|entry| kept.is_of(vehicle, entry));
        let gone = |(place, kept): (usize, &Option<KeptFault>)| match kept {
            None => Some((None, place)),
            Some(kept) => is_gone(kept).then_some((Some((kept.last_start, kept.entry.last)), place)),
        };
        self.places.iter().enumerate().filter_map(gone).min().map(|(_, place)| place)
    }

    /// Takes note that an entry has been saved.
    pub(crate) fn saved(&mut self, place: u8, bytes: &[u8], now: Millis) {
        self.take(place, bytes);
        self.saved_at = now;
    }
}

const _: () = assert!(ENTRY_BYTES == 16, "a kept fault begins with its entry");
const _: () = assert!(PLACES == HISTORY, "each entry has a place");
