//! What went wrong since power-on: a ring of faults with a fixed record for whoever keeps them.
//!
//! A fault that returns is counted, not listed twice, as long as its entry is still in the ring. The oldest entry makes
//! room for a new one. Refuses to know where records are kept and what a code means.

use super::table::FaultId;
use heapless::Deque;
use protocol_core::Millis;
use protocol_core::model::Severity;

/// Faults that are remembered.
pub const HISTORY: usize = 32;

/// Bytes of one entry as it is kept.
pub const ENTRY_BYTES: usize = 16;

/// One fault of the past.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Which fault.
    pub fault: FaultId,
    /// Its code; for alarm bits the number of the bit, from 1.
    pub code: Option<u16>,
    /// The worst that it has been.
    pub severity: Severity,
    /// When it was first seen, since power-on.
    pub first: Millis,
    /// When it came last, since power-on.
    pub last: Millis,
    /// How often it came, at least 1; stays at its largest value.
    pub count: u16,
}

impl Entry {
    /// Returns the record of the entry.
    ///
    /// | bytes    | what                                           |
    /// |----------|------------------------------------------------|
    /// | 0        | [`FaultId::number`]                            |
    /// | 1        | severity: 0 information, 1 warn, 2 derate, 3 stop |
    /// | 2 to 3   | code, low byte first, 0 = none                 |
    /// | 4 to 5   | count, low byte first                          |
    /// | 6 to 10  | first seen, milliseconds, low byte first       |
    /// | 11 to 15 | came last, milliseconds, low byte first        |
    pub fn to_bytes(&self) -> [u8; ENTRY_BYTES] {
        let [code_low, code_high] = self.code.unwrap_or(0).to_le_bytes();
        let [count_low, count_high] = self.count.to_le_bytes();
        let [a, b, c, d, e] = time_to_bytes(self.first);
        let [f, g, h, i, j] = time_to_bytes(self.last);
        let (fault, severity) = (self.fault.number(), self.severity as u8);
        [fault, severity, code_low, code_high, count_low, count_high, a, b, c, d, e, f, g, h, i, j]
    }

    /// Returns the entry of a record; `None` = it is none.
    pub fn from_bytes(bytes: &[u8; ENTRY_BYTES]) -> Option<Self> {
        let [fault, severity, code_low, code_high, count_low, count_high, a, b, c, d, e, f, g, h, i, j] =
            *bytes;
        let code = u16::from_le_bytes([code_low, code_high]);
        let count = u16::from_le_bytes([count_low, count_high]);
        Some(Self {
            fault: FaultId::from_number(fault)?,
            code: (code != 0).then_some(code),
            severity: (severity <= Severity::Stop as u8).then(|| Severity::from_model(severity.into()))?,
            first: time_from_bytes([a, b, c, d, e]),
            last: time_from_bytes([f, g, h, i, j]),
            count: (count != 0).then_some(count)?,
        })
    }
}

/// 40 bits last for 34 years.
fn time_to_bytes(time: Millis) -> [u8; 5] {
    let [a, b, c, d, e, ..] = time.0.min((1 << 40) - 1).to_le_bytes();
    [a, b, c, d, e]
}

fn time_from_bytes([a, b, c, d, e]: [u8; 5]) -> Millis {
    Millis(u64::from_le_bytes([a, b, c, d, e, 0, 0, 0]))
}

/// The last faults, the one that came first at the front.
#[derive(Clone)]
pub(crate) struct History {
    entries: Deque<Entry, HISTORY>,
}

impl History {
    pub(crate) const fn new() -> Self {
        Self { entries: Deque::new() }
    }

    /// Notes that a fault has come.
    pub(crate) fn came(&mut self, fault: FaultId, code: Option<u16>, severity: Severity, now: Millis) {
        if let Some(entry) = self.find_mut(fault, code) {
            entry.count = entry.count.saturating_add(1);
            entry.last = now;
            entry.severity = entry.severity.max(severity);
            return;
        }
        if self.entries.is_full() {
            self.entries.pop_front();
        }
        let entry = Entry { fault, code, severity, first: now, last: now, count: 1 };
        // Cannot fail: there is room now.
        let _ = self.entries.push_back(entry);
    }

    /// Takes an entry of an earlier run: an entry of its own, or on top of the same fault's count.
    pub(crate) fn remember(&mut self, entry: Entry) {
        if let Some(known) = self.find_mut(entry.fault, entry.code) {
            known.count = known.count.saturating_add(entry.count);
            known.severity = known.severity.max(entry.severity);
        } else {
            // Without room it is lost: those of this run are worth more.
            let _ = self.entries.push_back(entry);
        }
    }

    /// Notes how bad a fault has become that is still there; returns whether it has an entry.
    pub(crate) fn worsened(&mut self, fault: FaultId, code: Option<u16>, severity: Severity) -> bool {
        let entry = self.find_mut(fault, code);
        entry.map(|entry| entry.severity = entry.severity.max(severity)).is_some()
    }

    fn find_mut(&mut self, fault: FaultId, code: Option<u16>) -> Option<&mut Entry> {
        self.entries.iter_mut().find(|entry| (entry.fault, entry.code) == (fault, code))
    }

    /// Returns the entry of a fault.
    pub(crate) fn find(&self, fault: FaultId, code: Option<u16>) -> Option<&Entry> {
        self.entries.iter().find(|entry| (entry.fault, entry.code) == (fault, code))
    }

    /// Returns the entries, the one that came first at the front.
    pub(crate) fn iter(&self) -> impl DoubleEndedIterator<Item = &Entry> + ExactSizeIterator {
        self.entries.iter()
    }
}
