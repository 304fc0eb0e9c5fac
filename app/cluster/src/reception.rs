//! What came in and how long ago: readings and last signs of life.
//!
//! Owns the readings, the last sign of life of every message and the receive counters. A life counter that stands
//! still is silence, however many frames arrive, and in a vital message it discredits its whole node: what such a node
//! says of trouble is still believed, what it says of health is not. Messages that nobody misses (nameplates) are no
//! sign of life of a node that has others. What a stream says gives way to any message that says it too.
//! Refuses to know what a value means, and which of two senders of a message is the right one.
//! Source: BUS-11 (all bits of the identifier), BUS-108 (time-outs), BUS-R021, BUS-R061 and BUS-63 (life counters).

mod senders;

use protocol_core::model::{Reading, Readings, Shown, Unit, Value};
use protocol_core::stream::{Stream, Streams};
use protocol_core::vehicle::{Node, RxMessage, Vehicle};
use protocol_core::{CanFrame, Millis};
use senders::{Senders, stamp};

/// Most messages that a vehicle's receive table may have.
pub const MAX_MESSAGES: usize = 64;

/// What became of a received frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Received {
    /// Its values are stored.
    Stored,
    /// The vehicle's table does not have its identifier; nothing changed.
    Unknown,
    /// It has fewer bytes than its message; nothing changed.
    TooShort,
    /// Its check byte is wrong; nothing changed.
    Damaged,
}

/// What was received since power-on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Frames whose values were stored.
    pub stored: u32,
    /// Frames with an identifier that the vehicle's table does not have.
    pub unknown: u32,
    /// Frames with fewer bytes than their message.
    pub too_short: u32,
    /// Frames with a wrong check byte.
    pub damaged: u32,
}

/// The last sign of life of one message.
#[derive(Clone, Copy)]
struct Sign {
    /// [`NEVER`] = none yet.
    at: Millis,
    /// Last frame, a sign of life or not: the low bits of its time.
    heard: u32,
    life: u8,
    senders: Senders,
}

/// Time for which two senders are said after the last evidence, in milliseconds.
const DOUBLED_MS: u64 = 5_000;

const NEVER: Millis = Millis(u64::MAX);

/// The readings and the signs of life of all messages.
#[derive(Clone)]
pub(crate) struct Reception {
    pub(crate) readings: Readings,
    signs: [Sign; MAX_MESSAGES],
    /// Last frame of any message.
    heard: Option<Millis>,
    /// A node one of whose messages has two senders, and when that was last seen.
    doubled: Option<(Node, Millis)>,
    /// Nodes with a vital message whose life counter stands still, as of the last [`Self::judge`].
    discredited: Nodes,
    stored: u32,
    unknown: u32,
    too_short: u32,
    damaged: u32,
    streams: Streams,
}

impl Reception {
    pub(crate) const fn new() -> Self {
        Self {
            readings: Readings::new(),
            signs: [Sign { at: NEVER, heard: 0, life: 0, senders: Senders::new() }; MAX_MESSAGES],
            heard: None,
            doubled: None,
            discredited: Nodes::NONE,
            stored: 0,
            unknown: 0,
            too_short: 0,
            damaged: 0,
            streams: Streams::new(),
        }
    }

    /// Stores the values of `frame`.
    pub(crate) fn receive(&mut self, vehicle: &Vehicle, frame: &CanFrame, now: Millis) -> Received {
        let stream = vehicle.stream_of(frame.id);
        let row = row_of(vehicle, frame);
        let Some(len) = row.map(|(_, message)| message.len).or(stream.map(|(stream, _)| stream.len)) else {
            self.unknown = self.unknown.wrapping_add(1);
            return Received::Unknown;
        };
        if frame.len() < len {
            self.too_short = self.too_short.wrapping_add(1);
            return Received::TooShort;
        }
        let checksum = row.and_then(|(_, message)| message.checksum);
        if checksum.is_some_and(|checksum| !checksum.holds(frame.padded())) {
            self.damaged = self.damaged.wrapping_add(1);
            return Received::Damaged;
        }
        if let Some((index, message)) = row {
            self.store(vehicle, index, message, frame, now);
        }
        if let Some((stream, index)) = stream {
            self.streams.store(stream, index, frame.padded());
            self.sum_up(vehicle, stream, now);
        }
        self.stored = self.stored.wrapping_add(1);
        Received::Stored
    }

    /// Stores the values of a message and its sign of life.
    fn store(&mut self, vehicle: &Vehicle, index: u8, message: &RxMessage, frame: &CanFrame, now: Millis) {
        (vehicle.decode)(index, frame.padded(), &mut self.readings);
        let life = message.life.map(|life| {
            let byte = frame.padded().get(usize::from(life.byte)).copied().unwrap_or(0);
            byte & life.mask
        });
        let Some(sign) = self.signs.get_mut(usize::from(index)) else { return };
        if message.life.zip(life).is_some_and(|(life, count)| sign.senders.hear(life, count)) {
            self.doubled = Some((message.node, now));
        }
        self.heard = Some(now);
        sign.heard = stamp(now);
        if sign.at == NEVER || life.is_none_or(|life| life != sign.life) {
            (sign.at, sign.life) = (now, life.unwrap_or(0));
        }
    }

    /// Judges the nodes by the life counters of their vital messages; to be called every tick.
    pub(crate) fn judge(&mut self, vehicle: &Vehicle, now: Millis) {
        self.discredited = Nodes::NONE;
        for (message, sign) in vehicle.rx.iter().zip(&self.signs) {
            let timeout_ms = u64::from(message.timeout_ms);
            let is_heard = sign.at != NEVER && u64::from(stamp(now).wrapping_sub(sign.heard)) < timeout_ms;
            if message.vital && is_heard && now.since(sign.at) >= timeout_ms {
                self.discredited.add(message.node);
            }
        }
    }

    /// Returns a node one of whose messages has two senders.
    pub(crate) fn doubled(&self, now: Millis) -> Option<Node> {
        let (node, at) = self.doubled?;
        (now.since(at) < DOUBLED_MS).then_some(node)
    }

    /// Returns when any message was heard last.
    pub(crate) const fn last_heard(&self) -> Option<Millis> {
        self.heard
    }

    /// Files what a stream says under the values that no other message brings.
    fn sum_up(&mut self, vehicle: &Vehicle, stream: &Stream, now: Millis) {
        if self.is_silent(vehicle, usize::from(stream.row), now) {
            return;
        }
        for (value, reading) in self.streams.summary(stream).readings(&stream.bound) {
            let is_free = match self.readings.get(value) {
                Some((_, source)) if source == stream.row => true,
                _ => matches!(self.shown(vehicle, value, now), Shown::Never | Shown::Stale),
            };
            if is_free {
                self.readings.set(stream.row, value, reading);
            }
        }
    }

    /// Returns what may be shown of `value`.
    pub(crate) fn shown(&self, vehicle: &Vehicle, value: Value, now: Millis) -> Shown<i32> {
        let Some((reading, source)) = self.readings.get(value) else {
            return Shown::Never;
        };
        if source != Readings::LOCAL && self.is_silent(vehicle, usize::from(source), now) {
            return Shown::Stale;
        }
        match reading {
            Reading::Valid(number) if self.is_discredited(vehicle, source) && !is_trouble(value, number) => {
                Shown::Stale
            }
            Reading::Valid(number) => Shown::Value(number),
            Reading::Invalid => Shown::Invalid,
        }
    }

    fn is_discredited(&self, vehicle: &Vehicle, source: u8) -> bool {
        let message = vehicle.rx.get(usize::from(source)).filter(|_| !self.discredited.is_empty());
        message.is_some_and(|message| self.discredited.has(message.node))
    }

    /// Returns the last number of `value`, however old.
    pub(crate) fn last_known(&self, value: Value) -> Option<i32> {
        match self.readings.get(value)? {
            (Reading::Valid(number), _) => Some(number),
            (Reading::Invalid, _) => None,
        }
    }

    /// Returns whether message `index` has gone without a sign of life for its time-out.
    fn is_silent(&self, vehicle: &Vehicle, index: usize, now: Millis) -> bool {
        self.signs.get(index).zip(vehicle.rx.get(index)).is_none_or(|(sign, message)| {
            sign.at == NEVER || now.since(sign.at) >= u64::from(message.timeout_ms)
        })
    }

    /// Returns when `node` gave its last sign of life: of its vital messages the oldest counts, else the newest of those
    /// that are missed, else of all.
    pub(crate) fn last_sign(&self, vehicle: &Vehicle, node: Node) -> Option<Millis> {
        let rows = || vehicle.rx.iter().zip(&self.signs).filter(|(message, _)| message.node == node);
        let at = |sign: &Sign| Some(sign.at).filter(|at| *at != NEVER);
        let vital = rows().filter(|(message, _)| message.vital && message.expected);
        if let Some(oldest) = vital.map(|(_, sign)| at(sign)).min() {
            return oldest;
        }
        let is_missed = rows().any(|(message, _)| message.expected);
        let counting = rows().filter(|(message, _)| message.expected || !is_missed);
        counting.filter_map(|(_, sign)| at(sign)).max()
    }

    /// Returns the nodes of which an expected message is missing.
    ///
    /// A message that has never come counts from `started`, and not before `grace_ms` have passed: nodes need time to
    /// boot.
    pub(crate) fn silent_nodes(
        &self,
        vehicle: &Vehicle,
        started: Millis,
        grace_ms: u64,
        now: Millis,
    ) -> Nodes {
        let mut silent = Nodes::NONE;
        for (message, sign) in vehicle.rx.iter().zip(&self.signs).filter(|(message, _)| message.expected) {
            let timeout_ms = u64::from(message.timeout_ms);
            let missing = match sign.at {
                NEVER => now.since(started) >= timeout_ms.max(grace_ms),
                at => now.since(at) >= timeout_ms,
            };
            if missing {
                silent.add(message.node);
            }
        }
        silent
    }

    /// Returns what was received so far.
    pub(crate) fn counters(&self) -> Counters {
        Counters {
            stored: self.stored,
            unknown: self.unknown,
            too_short: self.too_short,
            damaged: self.damaged,
        }
    }
}

/// Returns whether a number of this value reports trouble: believed from whomever.
fn is_trouble(value: Value, number: i32) -> bool {
    let reports = matches!(value.unit(), Unit::Severity | Unit::Bits)
        || matches!(value, Value::BatteryHvOffRequest | Value::VehicleFaultCode | Value::BatteryFaultCode);
    reports && number != 0
}

fn row_of<'a>(vehicle: &'a Vehicle, frame: &CanFrame) -> Option<(u8, &'a RxMessage)> {
    let index = vehicle.index_of(frame.id)?;
    Some((index, vehicle.rx.get(usize::from(index))?))
}

/// A set of nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Nodes(u16);

impl Nodes {
    pub(crate) const NONE: Self = Self(0);

    fn add(&mut self, node: Node) {
        self.0 |= 1 << node as u8;
    }

    pub(crate) fn has(self, node: Node) -> bool {
        self.0 >> node as u8 & 1 != 0
    }

    pub(crate) fn is_empty(self) -> bool {
        self.0 == 0
    }
}
