//! What stands on the page that is shown: lists cut to their part, values of the technical one.

use super::Cluster;
use crate::driver::inputs::Controller;
use crate::faults::Entry;
use crate::navigator::{Contents, Leaf, parts_of};
use crate::view::page::{Chapter, Count, Page, ROWS, VALUES};
use crate::view::{ActiveFault, List, Listed, Sheet};
use protocol_core::Millis;
use protocol_core::model::{Severity, Shown};

impl Cluster {
    /// Returns how much there is to turn through.
    pub(super) fn contents(&self) -> Contents {
        let is_sent = |chapter: &Chapter| {
            *chapter == Chapter::Bus
                || chapter.items().iter().any(|item| self.reception.readings.get(item.value).is_some())
        };
        let bits =
            Chapter::ALL.iter().enumerate().map(|(place, chapter)| u16::from(is_sent(chapter)) << place);
        Contents {
            faults: self.faults.count(),
            history: self.faults.history().iter().len(),
            chapters: bits.fold(0, |all, bit| all | bit),
        }
    }

    /// Returns the page that is shown, with what only it shows.
    pub(super) fn page(&self, now: Millis) -> Page {
        match self.pages.leaf() {
            Leaf::Main => Page::Main,
            Leaf::Trip(trip) => Page::Trip(trip),
            Leaf::Energy => Page::Energy,
            Leaf::Faults(part) => {
                use Severity::{Derate, None, Stop, Warn};
                let worst_first = [Stop, Derate, Warn, None].into_iter().flat_map(|severity| {
                    self.active_faults(now).filter(move |fault| fault.severity == severity)
                });
                let rows = worst_first.map(|fault| {
                    let ActiveFault { severity, text, code, count, first, .. } = fault;
                    Listed { severity, text, code, count, at_s: seconds(first) }
                });
                Page::Faults(list(rows, part, self.faults.count()))
            }
            Leaf::History(part) => {
                let entries = self.faults.history().iter();
                let count = entries.len();
                let rows = entries.rev().map(|entry| {
                    let (text, code) = self.remembered(entry);
                    let Entry { severity, count, last, .. } = *entry;
                    Listed { severity, text, code, count, at_s: seconds(last) }
                });
                Page::History(list(rows, part, count))
            }
            Leaf::Technic(place) => {
                let chapters = self.contents().chapters;
                let chapter = Chapter::ALL.get(usize::from(place)).copied().unwrap_or_default();
                let mut values = [Shown::Never; VALUES];
                if chapter == Chapter::Bus {
                    values.iter_mut().zip(Count::ALL).for_each(|(value, &count)| *value = self.count(count));
                } else {
                    let items = chapter.items().iter();
                    values
                        .iter_mut()
                        .zip(items)
                        .for_each(|(value, item)| *value = self.shown(item.value, now));
                }
                let before = chapters & ((1 << place) - 1);
                let (position, count) = (before.count_ones() as u8 + 1, chapters.count_ones() as u8);
                Page::Technic(Sheet { chapter, values, position, count })
            }
        }
    }

    /// Returns a counter of the bus.
    fn count(&self, count: Count) -> Shown<i32> {
        let counters = self.counters();
        let number = |number: u32| Shown::Value(i32::try_from(number).unwrap_or(i32::MAX));
        let told = |tell: fn(Controller) -> u32| self.controller.map_or(Shown::Never, |it| number(tell(it)));
        match count {
            Count::State => told(|controller| controller.state.map_or(0, |state| state as u32)),
            Count::TransmitErrors => told(|controller| controller.transmit_errors.into()),
            Count::ReceiveErrors => told(|controller| controller.receive_errors.into()),
            Count::Sent => told(|controller| controller.sent),
            Count::Lost => told(|controller| controller.lost),
            Count::Stored => number(counters.stored),
            Count::Unknown => number(counters.unknown),
            Count::Short => number(counters.too_short),
            Count::Damaged => number(counters.damaged),
        }
    }
}

/// Returns whole seconds since power-on.
fn seconds(time: Millis) -> u32 {
    u32::try_from(time.0 / 1_000).unwrap_or(u32::MAX)
}

/// Returns the part of a list, counted from 0; the last one when the list has become shorter than that.
fn list(rows: impl Iterator<Item = Listed>, part: u8, length: usize) -> List {
    let count = parts_of(length);
    let part = part.min(count - 1);
    let mut shown = rows.skip(usize::from(part) * ROWS);
    List { rows: core::array::from_fn(|_| shown.next()), position: part + 1, count }
}
