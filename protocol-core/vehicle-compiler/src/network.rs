//! What is on the wire: nodes, messages and signals of one DBC file, as [`crate::gate`] has read them.
//!
//! Numbers stay exact fractions. What a file says and cannot be had is kept beside with its reason, so that it keeps
//! nobody from using the rest: a message or a signal with a doubt may be looked at, but not bound.

use crate::number::{self, Number};
use crate::places::At;
use crate::ratio::{Linear, Ratio};
use protocol_core::CanId;
use protocol_core::codec::{LifeKind, Mux, Order};
use std::collections::BTreeMap;

/// What one DBC file says.
#[derive(Debug)]
pub struct Network {
    /// Bits per second (`BusSpeed`), if the file says it.
    pub bitrate: Option<u32>,
    /// Names of the nodes, behind those of the list those too that only send.
    pub nodes: Vec<String>,
    /// How many of them are in the list.
    pub(crate) listed_nodes: usize,
    /// In the order of the file.
    pub messages: Vec<Message>,
    by_id: BTreeMap<u32, usize>,
    by_name: BTreeMap<String, usize>,
}

/// Why something cannot be bound, and where the DBC says it.
#[derive(Clone, Debug)]
pub struct Doubt {
    pub(crate) at: At,
    /// What is wrong and what would be right.
    pub text: String,
}

/// One message.
#[derive(Debug)]
pub struct Message {
    /// Packed: bit 31 = 29-bit identifier. Of a J1939 group the one without priority and source.
    pub id: u32,
    /// Whatever the source and the priority, J1939 says that it is this message.
    pub any_source: bool,
    /// The long name if there is one.
    pub name: String,
    /// The name behind `BO_`.
    pub(crate) short: String,
    /// Node that sends it; empty = none is named.
    pub sender: String,
    /// Bytes of a frame, 0 to 8.
    pub len: u8,
    pub(crate) cycle_ms: u32,
    pub(crate) slow_cycle_ms: u32,
    pub(crate) optional: bool,
    pub(crate) fill: [u8; 8],
    /// Those that can be read.
    pub signals: Vec<Signal>,
    /// Those that cannot, by name.
    pub lost: Vec<(String, Doubt)>,
    /// Set if no frame of it can be told or read.
    pub doubt: Option<Doubt>,
    /// Set if another message has its name.
    pub(crate) twice: Option<Doubt>,
    /// Name of its type in Rust.
    pub(crate) type_name: String,
    /// Name of its functions in Rust.
    pub(crate) function: String,
}

/// One signal.
#[derive(Debug)]
pub struct Signal {
    /// The long name if there is one.
    pub name: String,
    /// The name behind `SG_`.
    pub(crate) short: String,
    pub(crate) at: At,
    pub(crate) start: u8,
    /// Bits, 1 to 64.
    pub length: u8,
    pub(crate) order: Order,
    /// What the bits are.
    pub number: Number,
    pub(crate) factor: Ratio,
    pub(crate) offset: Ratio,
    /// The same in 31 bits, if it is exact.
    pub(crate) scale: Option<Linear>,
    /// Unit of the physical value.
    pub unit: String,
    /// Lowest and highest valid raw value of a whole number.
    pub(crate) range: (i128, i128),
    /// The file says more than the bits can hold.
    pub(crate) is_limited: bool,
    /// Lowest and highest valid value of a float, before factor and offset.
    pub(crate) float_range: Option<(f64, f64)>,
    pub(crate) start_raw: i128,
    pub(crate) invalid_raw: Option<i128>,
    /// Its raw value decides which others are in the frame.
    pub is_selector: bool,
    /// All must hold for the signal to be in the frame.
    pub when: Vec<Condition>,
    pub(crate) life: Option<LifeKind>,
    /// Words for raw values, sorted by raw value.
    pub values: Vec<(i64, String)>,
    pub(crate) doubt: Option<Doubt>,
    /// Name of its getter in Rust.
    pub(crate) function: String,
}

/// Raw values of a multiplexer at which a signal is in the frame.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Condition {
    /// Index of the multiplexer in the message.
    pub selector: usize,
    /// First and last raw value of each range.
    pub ranges: Vec<(i128, i128)>,
}

/// A run of bits of one signal within one byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Segment {
    pub(crate) byte: u8,
    /// Lowest bit in the byte.
    pub(crate) low: u8,
    pub(crate) bits: u8,
    /// Place of the lowest bit in the raw value.
    pub(crate) place: u8,
}

impl Network {
    pub(crate) fn new(
        bitrate: Option<u32>,
        (nodes, listed_nodes): (Vec<String>, usize),
        messages: Vec<Message>,
    ) -> Self {
        let sure = || messages.iter().enumerate().filter(|(_, message)| message.doubt.is_none());
        let by_id = sure().map(|(index, message)| (message.id, index)).collect();
        let names = messages.iter().enumerate().rev();
        let by_name = names
            .flat_map(|(index, message)| [(message.short.clone(), index), (message.name.clone(), index)])
            .collect();
        Self { bitrate, nodes, listed_nodes, messages, by_id, by_name }
    }

    /// Returns the index of the message that a frame with `id` is: the one with this identifier, else the one of its
    /// J1939 group.
    pub fn message_of(&self, id: CanId) -> Option<usize> {
        self.by_id.get(&id.packed()).or_else(|| self.by_id.get(&id.group()?.packed())).copied()
    }

    /// Returns the index of the message with this name, long or short.
    pub fn index(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }
}

impl Message {
    pub(crate) fn life(&self) -> Option<&Signal> {
        self.signals.iter().find(|signal| signal.life.is_some())
    }

    /// Returns the index of the signal with this name, long or short.
    pub fn signal(&self, name: &str) -> Option<usize> {
        let long = self.signals.iter().position(|signal| signal.name == name);
        long.or_else(|| self.signals.iter().position(|signal| signal.short == name))
    }

    /// Returns whether signal `index` is in this frame: multiplexed signals are only sometimes.
    pub fn carries(&self, index: usize, data: &[u8; 8]) -> bool {
        let holds = |condition: &Condition| {
            let raw = self.signals.get(condition.selector).map(|selector| selector.raw(data));
            raw.is_some_and(|raw| condition.holds(raw))
        };
        self.signals.get(index).is_some_and(|signal| signal.when.iter().all(holds))
    }

    /// Returns a frame of the start values of all signals that are always in it.
    pub fn start_frame(&self) -> [u8; 8] {
        let mut data = self.fill;
        for signal in self.signals.iter().filter(|signal| signal.when.is_empty()) {
            signal.set_raw(&mut data, signal.start_raw);
        }
        data
    }

    /// Returns how a row of the generated tables says when a signal is in the frame; `None` if it cannot.
    pub(crate) fn mux(&self, signal: &Signal) -> Option<Mux> {
        let selectors = self.signals.iter().filter(|signal| signal.is_selector).count();
        match (signal.when.as_slice(), signal.is_selector) {
            ([], false) => Some(Mux::Always),
            ([], true) if selectors == 1 => Some(Mux::Selector),
            ([Condition { ranges, .. }], false) if selectors == 1 => match ranges.as_slice() {
                [(first, last)] if first == last => u32::try_from(*first).ok().map(Mux::When),
                _ => None,
            },
            _ => None,
        }
    }
}

impl Condition {
    /// Returns whether a raw value of the multiplexer is among the ranges.
    pub fn holds(&self, raw: i128) -> bool {
        self.ranges.iter().any(|(first, last)| (*first..=*last).contains(&raw))
    }

    /// Returns whether this and `other` never hold together.
    fn excludes(&self, other: &Self) -> bool {
        let apart = |a: &(i128, i128), b: &(i128, i128)| a.1 < b.0 || b.1 < a.0;
        self.selector == other.selector
            && self.ranges.iter().all(|a| other.ranges.iter().all(|b| apart(a, b)))
    }
}

impl PartialEq for Signal {
    /// Compares what the bits are and mean; where it stands in the file does not count.
    fn eq(&self, other: &Self) -> bool {
        let form = |signal: &Self| (signal.start, signal.length, signal.order, signal.number);
        let scale = |signal: &Self| (signal.factor, signal.offset, signal.range, signal.float_range);
        let raws = |signal: &Self| (signal.start_raw, signal.invalid_raw, signal.life, signal.is_selector);
        (&self.name, &self.function, &self.unit) == (&other.name, &other.function, &other.unit)
            && form(self) == form(other)
            && scale(self) == scale(other)
            && raws(self) == raws(other)
            && (&self.when, &self.values) == (&other.when, &other.values)
    }
}

impl Signal {
    /// Returns lowest and highest raw value that the bits can hold.
    pub fn span(&self) -> (i128, i128) {
        self.number.span(self.length)
    }

    /// Returns the same limited to 64 bits with a sign.
    pub(crate) fn short_span(&self) -> (i64, i64) {
        let short = |raw: i128| raw.clamp(i64::MIN.into(), i64::MAX.into()) as i64;
        (short(self.span().0), short(self.span().1))
    }

    /// Returns whether the raw value has a sign.
    pub(crate) fn signed(&self) -> bool {
        self.number == Number::Signed
    }

    /// Returns whether raw and physical value fit a row of the generated tables, exactly.
    pub(crate) fn has_row(&self, message: &Message) -> bool {
        let fits = |scale: Linear| {
            let counts = |raw: i128| raw * i128::from(scale.mul) + i128::from(scale.add);
            let (low, high) = self.span();
            [low, high, counts(low), counts(high)].iter().all(|number| i64::try_from(*number).is_ok())
        };
        !self.number.is_float() && self.scale.is_some_and(fits) && message.mux(self).is_some()
    }

    /// Returns the runs of bits, from the lowest raw bit up.
    pub(crate) fn segments(&self) -> Vec<Segment> {
        segments(self.start, self.length, self.order)
    }

    /// Returns whether this and `other` are never in the same frame.
    pub(crate) fn excludes(&self, other: &Self) -> bool {
        self.when.iter().any(|own| other.when.iter().any(|theirs| own.excludes(theirs)))
    }

    /// Returns the raw value in a frame: the whole number that the bits make.
    pub fn raw(&self, data: &[u8; 8]) -> i128 {
        let part = |segment: Segment| {
            let byte = data.get(usize::from(segment.byte)).copied().unwrap_or(0);
            (u64::from(byte >> segment.low) & ((1 << segment.bits) - 1)) << segment.place
        };
        let bits = self.segments().into_iter().map(part).fold(0, |bits, part| bits | part);
        self.number.of_bits(bits, self.length)
    }

    /// Writes the low bits of `raw` into a frame and leaves all other bits.
    pub fn set_raw(&self, data: &mut [u8; 8], raw: i128) {
        for Segment { byte, low, bits, place } in self.segments() {
            let mask = (((1u16 << bits) - 1) << low) as u8;
            let part = ((raw >> place) as u8) << low;
            if let Some(byte) = data.get_mut(usize::from(byte)) {
                *byte = *byte & !mask | part & mask;
            }
        }
    }

    /// Returns whether the sender may send `raw` as a value.
    pub fn is_valid(&self, raw: i128) -> bool {
        if self.invalid_raw == Some(raw) {
            return false;
        }
        if self.number.is_float() {
            let value = self.number.float(raw);
            let (low, high) = self.float_range.unwrap_or((f64::MIN, f64::MAX));
            return value.is_finite() && low <= value && value <= high;
        }
        (self.range.0..=self.range.1).contains(&raw)
    }

    /// Returns the physical value of `raw` as a decimal, valid or not: exact for whole numbers of up to 37 digits.
    pub fn value(&self, raw: i128) -> String {
        if !self.number.is_float() {
            return number::decimal(raw, self.factor, self.offset);
        }
        let value = self.number.float(raw);
        if (self.factor, self.offset) == (Ratio::whole(1), Ratio::ZERO) && self.number == Number::Float32 {
            // The shortest decimal that is this float, not the one that is its widened copy.
            return number::shown((value as f32).to_string().parse().unwrap_or(value));
        }
        number::shown(value * self.factor.approximately() + self.offset.approximately())
    }

    /// Returns the greatest raw value of which the physical value is not above `number / 10^decimals` (not below it, where
    /// the factor is negative), and whether it is exactly that; `None` if the factor is 0 or the numbers are too long.
    pub fn raw_of(&self, number: i128, decimals: u32) -> Option<(i128, bool)> {
        let value = Ratio::new(number, 10i128.checked_pow(decimals)?);
        let steps = value.checked_sub(self.offset)?.checked_div(self.factor)?;
        if self.number.is_float() {
            return Some((self.number.pattern(steps.approximately()), true));
        }
        Some((steps.floor(), steps.den == 1))
    }

    /// Returns the physical distance from one raw value to the next.
    pub fn step(&self) -> String {
        number::decimal(1, Ratio { num: self.factor.num.abs(), ..self.factor }, Ratio::ZERO)
    }

    /// Returns lowest and highest valid raw value of a whole number.
    pub fn range(&self) -> (i128, i128) {
        self.range
    }

    /// Returns whether a higher raw value is a lower physical value.
    pub fn is_falling(&self) -> bool {
        self.factor.num < 0
    }

    /// Returns the word for a raw value.
    pub fn word(&self, raw: i128) -> Option<&str> {
        let raw = i64::try_from(raw).ok()?;
        let index = self.values.binary_search_by_key(&raw, |(value, _)| *value).ok()?;
        Some(&self.values[index].1)
    }

    /// Returns whether it is a life counter.
    pub fn is_life(&self) -> bool {
        self.life.is_some()
    }

    /// Returns the raw value that is sent before anything is known.
    pub fn start_raw(&self) -> i128 {
        self.start_raw
    }
}

/// `protocol_core::codec` walks single bits; this finds whole runs, because shifts and masks are made from them.
pub(crate) fn segments(start: u8, length: u8, order: Order) -> Vec<Segment> {
    let mut found = Vec::new();
    let mut left = length;
    match order {
        Order::Intel => {
            let mut bit = u16::from(start);
            while left > 0 {
                let low = (bit % 8) as u8;
                let bits = left.min(8 - low);
                found.push(Segment { byte: (bit / 8) as u8, low, bits, place: length - left });
                bit += u16::from(bits);
                left -= bits;
            }
        }
        Order::Motorola => {
            let (mut byte, mut high) = (start / 8, start % 8);
            while left > 0 {
                let bits = left.min(high + 1);
                left -= bits;
                found.push(Segment { byte, low: high + 1 - bits, bits, place: left });
                (byte, high) = (byte + 1, 7);
            }
            found.reverse();
        }
    }
    found
}
