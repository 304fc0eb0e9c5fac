//! What was saved last, and so which part is due.

use super::faults::{self, Ledger};
use super::parts::{Bytes, Distance, Memory, PER_KM, Part, Starts, numbers};
use crate::cluster::Cluster;
use crate::own::Restart;
use protocol_core::Millis;
use protocol_core::model::{Shown, Value};

/// Distance after which the trips are due, in counts of the odometer.
const TRIPS_EVERY: u64 = PER_KM;
/// Time after which the trips are due for their energy alone, in milliseconds.
const ENERGY_EVERY_MS: u64 = 300_000;

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
