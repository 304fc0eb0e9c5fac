//! One DBC file, checked: what is on the wire.
//!
//! `can-dbc` decides whether the text is a DBC; names, ranges, overlaps and attributes are checked here, and the
//! decimal numbers are read again from the text so that they stay exact. A section that changes what a signal means is
//! an error with its line as long as nothing here carries it out.
//! Not supported: IEEE floats, ranges of multiplexers, multiplexed multiplexers, CAN FD, matching by J1939 group.

use crate::diagnostics::{Diagnostics, Report, did_you_mean, line_of};
use crate::names::{self, Named};
use crate::places::{Entry, MessagePlace, Places, SignalPlace};
use crate::ratio::{Linear, Ratio};
use can_dbc::{
    AttributeDefinition, AttributeValue, AttributeValueType, ByteOrder, Dbc, DbcError, MultiplexIndicator,
    ValueType,
};
use protocol_core::codec::{LifeKind, Mux, Order};
use std::collections::{BTreeMap, BTreeSet};

pub(crate) struct Network {
    pub(crate) bitrate: u32,
    pub(crate) nodes: Vec<String>,
    pub(crate) messages: Vec<Message>,
}

pub(crate) struct Message {
    /// Packed: bit 31 = 29-bit identifier.
    pub(crate) id: u32,
    pub(crate) name: String,
    pub(crate) sender: String,
    pub(crate) len: u8,
    pub(crate) cycle_ms: u32,
    pub(crate) slow_cycle_ms: u32,
    pub(crate) optional: bool,
    pub(crate) fill: [u8; 8],
    pub(crate) signals: Vec<Signal>,
}

#[derive(PartialEq)]
pub(crate) struct Signal {
    pub(crate) name: String,
    pub(crate) start: u8,
    pub(crate) length: u8,
    pub(crate) order: Order,
    pub(crate) signed: bool,
    pub(crate) factor: Ratio,
    pub(crate) offset: Ratio,
    pub(crate) scale: Linear,
    pub(crate) unit: String,
    pub(crate) range: (i64, i64),
    pub(crate) start_raw: i64,
    pub(crate) invalid_raw: Option<i64>,
    pub(crate) mux: Mux,
    pub(crate) life: Option<LifeKind>,
    pub(crate) values: Vec<(i64, String)>,
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

impl Signal {
    /// Returns lowest and highest raw value that the bits can hold.
    pub(crate) fn span(&self) -> (i64, i64) {
        span(self.length, self.signed)
    }

    /// Returns the runs of bits, from the lowest raw bit up.
    pub(crate) fn segments(&self) -> Vec<Segment> {
        segments(self.start, self.length, self.order)
    }
}

impl Message {
    pub(crate) fn life(&self) -> Option<&Signal> {
        self.signals.iter().find(|signal| signal.life.is_some())
    }

    pub(crate) fn signal(&self, name: &str) -> Option<usize> {
        self.signals.iter().position(|signal| signal.name == name)
    }
}

fn span(length: u8, signed: bool) -> (i64, i64) {
    match signed {
        true => (-(1 << (length - 1)), (1 << (length - 1)) - 1),
        false => (0, (1 << length) - 1),
    }
}

/// `protocol_core::codec` walks single bits; this finds whole runs, because shifts and masks are made from them.
fn segments(start: u8, length: u8, order: Order) -> Vec<Segment> {
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

/// What Vector's editors write signals into that belong to no message; neither number is an identifier.
const INDEPENDENT: [(&str, u64); 2] =
    [("VECTOR__INDEPENDENT_SIG_MSG", 0xC000_0000), ("VECTOR__INDEPENDENT_SIG_MSG", 0x4000_0000)];

/// Pairs each message of the text with its place, but for the container of signals without a message.
pub(crate) fn placed<'d, 'p, 't>(
    dbc: &'d Dbc,
    places: &'p Places<'t>,
) -> impl Iterator<Item = (&'d can_dbc::Message, &'p MessagePlace<'t>)> {
    dbc.messages
        .iter()
        .zip(&places.messages)
        .filter(|(_, place)| !INDEPENDENT.contains(&(place.name, place.id)))
}

/// Returns the four numbers `(factor,offset) [minimum|maximum]` of the text after the colon of a signal.
fn numbers(text: &str) -> Option<[Ratio; 4]> {
    let (_, after) = text.split_once('(')?;
    let (scale, after) = after.split_once(')')?;
    let (_, after) = after.split_once('[')?;
    let (range, _) = after.split_once(']')?;
    let (factor, offset) = scale.split_once(',')?;
    let (minimum, maximum) = range.split_once('|')?;
    let read = |text: &str| Ratio::parse(text.trim());
    Some([read(factor)?, read(offset)?, read(minimum)?, read(maximum)?])
}

/// Reads an attribute as a whole number; an ENUM may be given by number or by one of `words`.
fn whole(value: Option<&AttributeValue>, words: &[&str]) -> Result<Option<i64>, String> {
    let bad = |shown: String| Err(format!("has the value {shown}, a whole number is needed"));
    match value {
        None => Ok(None),
        Some(AttributeValue::Uint(number)) => match i64::try_from(*number) {
            Ok(number) => Ok(Some(number)),
            Err(_) => bad(number.to_string()),
        },
        Some(AttributeValue::Int(number)) => Ok(Some(*number)),
        Some(AttributeValue::Double(number)) if number.fract() == 0.0 => Ok(Some(*number as i64)),
        Some(AttributeValue::Double(number)) => bad(number.to_string()),
        Some(AttributeValue::String(word)) => match words.iter().position(|known| known == word) {
            Some(index) => Ok(Some(index as i64)),
            None => bad(format!("\"{word}\"")),
        },
    }
}

/// What the numbers of `VFrameFormat` mean where the file does not define it: the table that Vector's editors write.
const FRAME_FORMATS: [&str; 16] = [
    "StandardCAN",
    "ExtendedCAN",
    "reserved",
    "J1939PG",
    "reserved",
    "reserved",
    "reserved",
    "reserved",
    "reserved",
    "reserved",
    "reserved",
    "reserved",
    "reserved",
    "reserved",
    "StandardCAN_FD",
    "ExtendedCAN_FD",
];

const LIFE_WORDS: [&str; 4] = ["none", "counter_0_255", "counter_1_255", "nibble"];

/// The attributes that are read here, and the value tables: given twice, only one of them can hold.
const READ: [&str; 10] = [
    "BusSpeed",
    "FillByte",
    "GenMsgCycleTime",
    "GenMsgCycleTimeSlow",
    "GenSigStartValue",
    "LifeKind",
    "Optional",
    "SigInvalidRaw",
    "VAL_",
    "VFrameFormat",
];

/// Reads a DBC text.
pub(crate) fn read(file: &str, text: &str) -> Result<Network, Diagnostics> {
    let dbc = parse(file, text)?;
    let mut report = Report::new(file, text);
    let places = Places::find(without_mark(text));
    if let Some(line) = first_unplaced(&dbc, &places) {
        report.line(line, "this entry is not understood: write each entry on a line of its own");
        return report.finish().or(()).map(|()| unreachable!("a report with errors is an error"));
    }
    let nodes: Vec<String> = dbc.nodes.iter().map(|node| node.0.clone()).collect();
    let bitrate = dbc
        .attribute_values_database
        .iter()
        .find(|attribute| attribute.name == "BusSpeed")
        .map(|attribute| &attribute.value)
        .or(dbc.attribute_default("BusSpeed"));
    let bitrate = match whole(bitrate, &[]) {
        Ok(Some(rate)) if (10_000..=1_000_000).contains(&rate) => rate as u32,
        _ => {
            let line = places.note_line("BusSpeed", 0, "", 1);
            report.line(line, "BusSpeed must be set, 10000 to 1000000 bit/s");
            0
        }
    };
    for (name, line, first) in places.repeated.iter().filter(|(name, ..)| READ.contains(name)) {
        let what = if *name == "VAL_" { "this value table" } else { name };
        report.line(*line, format!("{what} is given before, in line {first}"));
    }
    report_sections(&places, &mut report);
    report_names(&dbc, &places, &mut report);
    let mut identifiers: BTreeMap<u64, usize> = BTreeMap::new();
    let mut messages: Vec<Message> = Vec::new();
    for (message, place) in placed(&dbc, &places) {
        let line = place.line;
        if let Some(first) = identifiers.insert(place.id, line) {
            report.line(line, format!("identifier {} is used before, in line {first}", place.id));
        }
        if let Some(reason) = wrong_identifier(place.id) {
            report.line(line, format!("identifier {} of `{}` {reason}", place.id, message.name));
        }
        if let Some(sender) = message.transmitter.as_ref().filter(|sender| !nodes.contains(sender)) {
            let near = did_you_mean(sender, nodes.iter().map(String::as_str));
            report.line(line, format!("sender `{sender}` is not in the list of nodes (BU_){near}"));
        }
        messages.push(read_message(&dbc, message, place, &places, &mut report));
    }
    for (line, signal) in places.tables_of_nothing() {
        report.line(line, format!("value table of a signal that does not exist: `{signal}`"));
    }
    report.finish().or(Network { bitrate, nodes, messages })
}

/// Returns the first line at which the text's messages and signals are not those of the parser.
fn first_unplaced(dbc: &Dbc, places: &Places<'_>) -> Option<usize> {
    let last = places.messages.last().map_or(1, |place| place.line);
    if dbc.messages.len() != places.messages.len() {
        return Some(last);
    }
    let same = |(message, place): &(&can_dbc::Message, &MessagePlace<'_>)| {
        let names = message.signals.iter().map(|signal| signal.name.as_str());
        message.name == place.name && names.eq(place.signals.iter().map(|place| place.name))
    };
    dbc.messages.iter().zip(&places.messages).find(|pair| !same(pair)).map(|(_, place)| place.line)
}

/// Returns why a number cannot be an identifier, `None` if it can.
fn wrong_identifier(written: u64) -> Option<String> {
    const BIT_31: u64 = 1 << 31;
    match written {
        0..=0x7FF => None,
        0x800..=0x1FFF_FFFF => {
            let advice = format!("write {} if it has 29 (bit 31 set)", written + BIT_31);
            Some(format!("(0x{written:X}) has more than 11 bits: {advice}"))
        }
        _ if (BIT_31..=BIT_31 + 0x1FFF_FFFF).contains(&written) => None,
        _ => Some(format!("(0x{:X}) has more than 29 bits", written & (BIT_31 - 1))),
    }
}

/// Reports what can be parsed, changes the meaning of signals, and is not carried out.
fn report_sections(places: &Places<'_>, report: &mut Report<'_>) {
    let signal = |message: u64, name: &str| {
        let message = places.message(message)?;
        Some((message, message.signals.iter().find(|signal| signal.name == name)?))
    };
    for kind in &places.kinds {
        let bits = match kind.kind {
            "0" => continue,
            "1" => 32,
            _ => 64,
        };
        let of = places.message(kind.message).map_or("no message", |message| message.name);
        let text = format!(
            "`{}` of {of} is an IEEE float of {bits} bits (SIG_VALTYPE_), which is not supported: take the signal out, \
             or have it sent as a whole number with a factor",
            kind.signal
        );
        report.line(kind.line, text);
    }
    for values in &places.mux_values {
        let Some((message, place)) = signal(values.message, values.signal) else {
            report.line(
                values.line,
                format!("SG_MUL_VAL_ of a signal that does not exist: `{}`", values.signal),
            );
            continue;
        };
        let is_plain = match values.ranges.as_slice() {
            [(first, last)] => first == last && place.mux == format!("m{first}"),
            _ => false,
        };
        let mut selectors = message.signals.iter().filter(|signal| signal.mux.ends_with('M'));
        let is_only =
            selectors.next().is_some_and(|signal| signal.name == values.selector && signal.mux == "M")
                && selectors.next().is_none();
        if !is_plain || !is_only {
            let text = format!(
                "SG_MUL_VAL_ lets `{}` of {} depend on more than one value of one multiplexer, which is not supported: \
                 write one signal (m0, m1 ...) for each value",
                values.signal, message.name
            );
            report.line(values.line, text);
        }
    }
}

/// Reports names that are not different in Rust.
fn report_names(dbc: &Dbc, places: &Places<'_>, report: &mut Report<'_>) {
    let rows: Vec<(Named<'_>, Vec<Named<'_>>)> = placed(dbc, places)
        .map(|(_, place)| {
            let signals = place.signals.iter().map(|place| Named { name: place.name, line: place.line });
            (Named { name: place.name, line: place.line }, signals.collect())
        })
        .collect();
    names::report_collisions(&rows, report);
}

/// Reports a frame that is not classic CAN, or is not matched by its whole identifier.
fn report_format(
    dbc: &Dbc,
    message: &can_dbc::Message,
    place: &MessagePlace<'_>,
    places: &Places<'_>,
    report: &mut Report<'_>,
) {
    let words = dbc.attribute_definitions.iter().find_map(|definition| match definition {
        AttributeDefinition::Message(name, AttributeValueType::Enum(words)) if name == "VFrameFormat" => {
            Some(words.as_slice())
        }
        _ => None,
    });
    let word = match dbc.resolved_message_attribute(message.id, "VFrameFormat") {
        Some(AttributeValue::String(word)) => Some(word.as_str()),
        value => whole(value, &[]).ok().flatten().and_then(|index| {
            let index = usize::try_from(index).ok()?;
            let defined = words.and_then(|words| words.get(index)).map(String::as_str);
            defined.or_else(|| FRAME_FORMATS.get(index).copied())
        }),
    };
    let line = places.note_line("VFrameFormat", place.id, "", place.line);
    let name = place.name;
    match word {
        Some(word) if word.ends_with("_FD") => {
            report.line(line, format!("message `{name}` is CAN FD ({word}); only classic CAN is received here"));
        }
        Some("J1939PG") => report.line(
            line,
            format!(
                "message `{name}` is matched by its J1939 group (VFrameFormat J1939PG), which is not supported: all 29 \
                 bits must match, so write the identifier as it is on the bus and ExtendedCAN"
            ),
        ),
        _ => {}
    }
}

fn read_message(
    dbc: &Dbc,
    message: &can_dbc::Message,
    place: &MessagePlace<'_>,
    places: &Places<'_>,
    report: &mut Report<'_>,
) -> Message {
    let (id, line) = (place.id, place.line);
    report_format(dbc, message, place, places, report);
    let mut attribute = |name: &str, range: std::ops::RangeInclusive<i64>| {
        let value = whole(dbc.resolved_message_attribute(message.id, name), &[]);
        match value {
            Ok(None) => 0,
            Ok(Some(number)) if range.contains(&number) => number,
            Ok(Some(number)) => {
                let at = places.note_line(name, id, "", line);
                report.line(at, format!("{name} is {number}, must be {} to {}", range.start(), range.end()));
                0
            }
            Err(reason) => {
                report.line(places.note_line(name, id, "", line), format!("{name} {reason}"));
                0
            }
        }
    };
    let cycle_ms = attribute("GenMsgCycleTime", 0..=60_000) as u32;
    let slow_cycle_ms = (attribute("GenMsgCycleTimeSlow", 0..=60_000) as u32).max(cycle_ms);
    let optional = attribute("Optional", 0..=1) == 1;
    let fill_byte = attribute("FillByte", 0..=255) as u8;
    if message.size > 8 {
        report
            .line(line, format!("message `{}` has {} bytes; classic CAN has 8", message.name, message.size));
    }
    let len = message.size.min(8) as u8;
    let mut signals = Vec::new();
    let mut lines: BTreeMap<&str, usize> = BTreeMap::new();
    for (signal, place) in message.signals.iter().zip(&place.signals) {
        lines.insert(place.name, place.line);
        signals.extend(read_signal(dbc, message, signal, (id, place), len, places, report));
    }
    let mut owners: BTreeMap<(u8, u8), Vec<&Signal>> = BTreeMap::new();
    for signal in &signals {
        let mut rivals = BTreeSet::new();
        for segment in signal.segments() {
            for bit in segment.low..segment.low + segment.bits {
                let owner = owners.entry((segment.byte, bit)).or_default();
                rivals.extend(
                    owner.iter().filter(|other| clash(other.mux, signal.mux)).map(|other| &*other.name),
                );
                owner.push(signal);
            }
        }
        for rival in rivals {
            let at = lines.get(signal.name.as_str()).copied().unwrap_or(line);
            report.line(at, format!("signal `{}` overlaps `{rival}`", signal.name));
        }
    }
    let selectors = signals.iter().filter(|signal| signal.mux == Mux::Selector).count();
    let multiplexed = signals.iter().any(|signal| matches!(signal.mux, Mux::When(_)));
    if selectors > 1 || multiplexed && selectors == 0 {
        report
            .line(line, format!("message `{}` has {selectors} multiplexers, needs exactly 1", message.name));
    }
    if let Some(selector) = signals.iter().find(|signal| signal.mux == Mux::Selector) {
        let (lowest, highest) = selector.span();
        for signal in &signals {
            let Mux::When(when) = signal.mux else { continue };
            if !(lowest..=highest).contains(&i64::from(when)) {
                let at = lines.get(signal.name.as_str()).copied().unwrap_or(line);
                let bits = selector.length;
                let text = format!(
                    "`{}` is sent at {when}, which the {bits} bits of `{}` never hold",
                    signal.name, selector.name
                );
                report.line(at, text);
            }
        }
    }
    if signals.iter().filter(|signal| signal.life.is_some()).count() > 1 {
        report.line(line, format!("message `{}` has more than one life counter", message.name));
    }
    let mut fill = [0; 8];
    for (byte, filled) in fill.iter_mut().enumerate().take(usize::from(len)) {
        let used = owners.keys().any(|(owned, _)| usize::from(*owned) == byte);
        *filled = if used { 0 } else { fill_byte };
    }
    Message {
        id: message.id.raw(),
        name: message.name.clone(),
        sender: message.transmitter.clone().unwrap_or_default(),
        len,
        cycle_ms,
        slow_cycle_ms,
        optional,
        fill,
        signals,
    }
}

/// Two signals may share bits only if they are never in the same frame.
fn clash(a: Mux, b: Mux) -> bool {
    !matches!((a, b), (Mux::When(a), Mux::When(b)) if a != b)
}

fn read_signal(
    dbc: &Dbc,
    message: &can_dbc::Message,
    signal: &can_dbc::Signal,
    (id, place): (u64, &SignalPlace<'_>),
    len: u8,
    places: &Places<'_>,
    report: &mut Report<'_>,
) -> Option<Signal> {
    let name = signal.name.as_str();
    let (line, text) = (place.line, place.numbers);
    let Some([factor, offset, minimum, maximum]) = numbers(text) else {
        report.line(line, format!("factor, offset and range of `{name}` are not four short decimal numbers"));
        return None;
    };
    if !(1..=32).contains(&signal.size) || signal.start_bit > 63 {
        report.line(
            line,
            format!(
                "`{name}` must have 1 to 32 bits within 8 bytes, has {} at {}",
                signal.size, signal.start_bit
            ),
        );
        return None;
    }
    let (start, length) = (signal.start_bit as u8, signal.size as u8);
    let order = match signal.byte_order {
        ByteOrder::LittleEndian => Order::Intel,
        ByteOrder::BigEndian => Order::Motorola,
    };
    let signed = signal.value_type == ValueType::Signed;
    if segments(start, length, order).iter().any(|segment| segment.byte >= len) {
        report.line(line, format!("`{name}` reaches beyond the {len} bytes of the message"));
        return None;
    }
    if factor == Ratio::ZERO {
        report.line(line, format!("factor of `{name}` is 0"));
        return None;
    }
    let Some(scale) = Linear::new(factor, offset) else {
        report.line(line, format!("factor and offset of `{name}` need more than 31 bits as a fraction"));
        return None;
    };
    let (lowest, highest) = span(length, signed);
    let mut range = (lowest, highest);
    let raw = |limit: Ratio| limit.checked_sub(offset).and_then(|above| above.checked_div(factor));
    if minimum != maximum || minimum != Ratio::ZERO {
        let (Some(a), Some(b)) = (raw(minimum), raw(maximum)) else {
            report.line(line, format!("the range of `{name}` has too many digits"));
            return None;
        };
        let (low, high) = if factor.num > 0 { (a, b) } else { (b, a) };
        let (low, high) = (low.ceil(), high.floor());
        if low > high || low < i128::from(lowest) || high > i128::from(highest) {
            report.line(
                line,
                format!(
                    "range of `{name}` is raw {low} to {high}; its {length} bits hold {lowest} to {highest}"
                ),
            );
            return None;
        }
        range = (low as i64, high as i64);
    }
    let mut attribute = |attribute: &str, words: &[&str]| {
        let value = whole(dbc.resolved_signal_attribute(message.id, name, attribute), words);
        value.unwrap_or_else(|reason| {
            report.line(
                places.note_line(attribute, id, name, line),
                format!("{attribute} of `{name}` {reason}"),
            );
            None
        })
    };
    let life = match attribute("LifeKind", &LIFE_WORDS) {
        Some(1) => Some(LifeKind::From0To255),
        Some(2) => Some(LifeKind::From1To255),
        Some(3) => Some(LifeKind::Nibble),
        _ => None,
    };
    let invalid_raw = attribute("SigInvalidRaw", &[]).filter(|raw| *raw != -1);
    let start_raw = attribute("GenSigStartValue", &[]).unwrap_or(0);
    for (what, raw) in [("SigInvalidRaw", invalid_raw), ("GenSigStartValue", Some(start_raw))] {
        if raw.is_some_and(|raw| !(lowest..=highest).contains(&raw)) {
            let at = places.note_line(what, id, name, line);
            report.line(at, format!("{what} of `{name}` does not fit in its {length} bits"));
        }
    }
    let bits = if life == Some(LifeKind::Nibble) { 4 } else { 8 };
    if life.is_some() && (length != bits || segments(start, length, order).len() != 1) {
        let at = places.note_line("LifeKind", id, name, line);
        report.line(at, format!("life counter `{name}` must have {bits} bits within one byte"));
    }
    let mux = match signal.multiplexer_indicator {
        // The parser takes an `m` without a number for no multiplexing at all.
        MultiplexIndicator::Plain if place.mux.is_empty() => Mux::Always,
        MultiplexIndicator::Plain => {
            report.line(line, format!("`{name}` is multiplexed (`m`) but does not say at which value"));
            Mux::Always
        }
        MultiplexIndicator::Multiplexor => Mux::Selector,
        MultiplexIndicator::MultiplexedSignal(when) => Mux::When(u32::try_from(when).unwrap_or_else(|_| {
            report.line(line, format!("`{name}` is sent at {when}, which has more than 32 bits"));
            0
        })),
        MultiplexIndicator::MultiplexorAndMultiplexedSignal(_) => {
            report.line(line, format!("`{name}`: a multiplexed multiplexer is not supported"));
            Mux::Always
        }
    };
    let mut values: Vec<(i64, String)> = dbc
        .value_descriptions_for_signal(message.id, name)
        .unwrap_or_default()
        .iter()
        .map(|value| (value.id, value.description.clone()))
        .collect();
    values.sort();
    for (raw, word) in &values {
        if !(lowest..=highest).contains(raw) {
            let at = places.note_line("VAL_", id, name, line);
            report.line(at, format!("value {raw} \"{word}\" does not fit in the {length} bits of `{name}`"));
        }
    }
    for pair in values.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        report.line(
            places.note_line("VAL_", id, name, line),
            format!("value {} of `{name}` is named twice", pair[0].0),
        );
    }
    Some(Signal {
        name: name.into(),
        start,
        length,
        order,
        signed,
        factor,
        offset,
        scale,
        unit: signal.unit.clone(),
        range,
        start_raw,
        invalid_raw,
        mux,
        life,
        values,
    })
}

/// Returns the text behind its byte-order mark, if it has one.
pub(crate) fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{FEFF}').unwrap_or(text)
}

/// Parses the text; a syntax error carries its line.
pub(crate) fn parse(file: &str, text: &str) -> Result<Dbc, Diagnostics> {
    let text = without_mark(text);
    let error = match Dbc::try_from(text) {
        Ok(dbc) => return Ok(dbc),
        Err(error) => error,
    };
    let shown = error.to_string();
    if let DbcError::Pest(_) = error {
        // The grammar's own report begins "--> line:column" and ends "= expected ...".
        let line =
            shown.split("--> ").nth(1).and_then(|at| at.split(':').next()?.trim().parse().ok()).unwrap_or(1);
        let source = text.lines().nth(usize::max(line, 1) - 1).unwrap_or("").trim();
        let message = if source.is_empty() || line > text.lines().count() {
            "the file ends in the middle of an entry".to_string()
        } else {
            let expected = shown.rsplit("= ").next().unwrap_or("").replace('_', " ");
            format!("not valid DBC: `{source}` ({expected})")
        };
        return Err(Diagnostics::one(file, line, message));
    }
    let entries = Places::find(text).entries;
    let Some(entry) = failing_entry(text, &entries, |text| Dbc::try_from(text).is_err_and(is_number_error))
    else {
        return Err(Diagnostics::one(file, 1, format!("not valid DBC: {shown}")));
    };
    let (line, number) = match &error {
        DbcError::InvalidInt(number) | DbcError::InvalidUint(number) => {
            (entry.line_of(number), number.clone())
        }
        DbcError::MessageIdOutOfRange(id) => (entry.line_of(&id.to_string()), id.to_string()),
        _ => {
            return Err(Diagnostics::one(
                file,
                line_of(text, entry.start),
                format!("not valid DBC: {shown}"),
            ));
        }
    };
    let line = line.unwrap_or(line_of(text, entry.start));
    let reason = if number.starts_with('-') { "must not be negative" } else { "is too large for its place" };
    Err(Diagnostics::one(file, line, format!("not valid DBC: the number {number} {reason}")))
}

/// The grammar holds, but a number does not fit: such errors carry no position.
fn is_number_error(error: DbcError) -> bool {
    !matches!(error, DbcError::Pest(_))
}

/// Returns the first entry with which the text fails; `fails` is asked once for each halving of the entries.
fn failing_entry<'e, 't>(
    text: &str,
    entries: &'e [Entry<'t>],
    mut fails: impl FnMut(&str) -> bool,
) -> Option<&'e Entry<'t>> {
    let end = |index: usize| entries.get(index + 1).map_or(text.len(), |next| next.start);
    let (mut right, mut wrong) = (0, entries.len());
    while right < wrong {
        let middle = right.midpoint(wrong);
        if fails(&text[..end(middle)]) { wrong = middle } else { right = middle + 1 }
    }
    entries.get(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_that_does_not_fit_is_found_without_parsing_the_file_for_every_line() {
        let mut text = String::from("VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: A\n\n");
        for id in 1..=400 {
            text.push_str(&format!("BO_ {id} M{id}: 8 A\n SG_ s : 0|8@1+ (1,0) [0|255] \"\" A\n\n"));
        }
        for id in 1..=400 {
            text.push_str(&format!("VAL_ {id} s 0 \"none\" 1 \"one\" ;\n"));
        }
        let wrong = "VAL_ 300 s 0 \"none\" 18446744073709551616 \"one\" ;";
        text = text.replace("VAL_ 300 s 0 \"none\" 1 \"one\" ;", wrong);
        let line =
            text.lines().position(|line| line.contains("18446744073709551616")).expect("it is there") + 1;
        let mut parses = 0;
        let entries = Places::find(&text).entries;
        let found = failing_entry(&text, &entries, |text| {
            parses += 1;
            Dbc::try_from(text).is_err_and(is_number_error)
        });
        assert_eq!(found.and_then(|entry| entry.line_of("18446744073709551616")), Some(line));
        assert!(parses <= 12, "{parses} parses of {} entries", entries.len());
        let said = parse("x.dbc", &text).expect_err("a number too large").to_string();
        let number = "the number 18446744073709551616 is too large for its place";
        assert_eq!(said, format!("x.dbc:{line}: not valid DBC: {number}"));
    }
}
