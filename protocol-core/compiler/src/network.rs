//! One DBC file, checked: what is on the wire.
//!
//! `can-dbc` decides whether the text is a DBC; names, ranges, overlaps and attributes are checked here, and the
//! decimal numbers are read again from the text so that they stay exact.

use crate::diagnostics::{Diagnostics, Report, did_you_mean};
use crate::ratio::{Linear, Ratio};
use can_dbc::{AttributeValue, ByteOrder, Dbc, MultiplexIndicator, ValueDescription, ValueType};
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

/// Where things stand in the text, and the text of their numbers.
#[derive(Default)]
struct Lines<'a> {
    messages: BTreeMap<u32, usize>,
    signals: BTreeMap<(u32, &'a str), (usize, &'a str)>,
    /// Lines of attributes and value tables by (keyword or attribute, message, signal).
    notes: BTreeMap<(&'a str, u32, &'a str), usize>,
}

impl<'a> Lines<'a> {
    fn find(text: &'a str, report: &mut Report<'_>) -> Self {
        let mut lines = Self::default();
        let (mut inside_string, mut message) = (false, 0);
        for (index, line) in text.lines().enumerate() {
            let number = index + 1;
            let starts_inside = inside_string;
            inside_string ^= line.replace("\\\"", "").matches('"').count() % 2 == 1;
            if starts_inside {
                continue;
            }
            let words: Vec<&str> = line.split_whitespace().collect();
            match words.as_slice() {
                ["BO_", id, ..] => {
                    message = id.parse().unwrap_or(0);
                    if let Some(first) = lines.messages.insert(message, number) {
                        report.line(number, format!("identifier {id} is used before, in line {first}"));
                    }
                }
                ["SG_", name, ..] => {
                    let name = name.trim_end_matches(':');
                    let rest = line.split_once(':').map_or("", |(_, rest)| rest);
                    if let Some((first, _)) = lines.signals.insert((message, name), (number, rest)) {
                        report.line(number, format!("signal `{name}` is used before, in line {first}"));
                    }
                }
                ["BA_", name, "SG_", id, signal, ..] => {
                    let key = (name.trim_matches('"'), id.parse().unwrap_or(0), *signal);
                    lines.notes.insert(key, number);
                }
                ["BA_", name, "BO_", id, ..] => {
                    lines.notes.insert((name.trim_matches('"'), id.parse().unwrap_or(0), ""), number);
                }
                ["BA_", name, ..] => {
                    lines.notes.insert((name.trim_matches('"'), 0, ""), number);
                }
                ["VAL_", id, signal, ..] => {
                    lines.notes.insert(("VAL_", id.parse().unwrap_or(0), *signal), number);
                }
                _ => {}
            }
        }
        lines
    }

    fn note(&self, name: &str, message: u32, signal: &str, fallback: usize) -> usize {
        self.notes.get(&(name, message, signal)).copied().unwrap_or(fallback)
    }
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
        Some(AttributeValue::Uint(number)) => Ok(i64::try_from(*number).ok()),
        Some(AttributeValue::Int(number)) => Ok(Some(*number)),
        Some(AttributeValue::Double(number)) if number.fract() == 0.0 => Ok(Some(*number as i64)),
        Some(AttributeValue::Double(number)) => bad(number.to_string()),
        Some(AttributeValue::String(word)) => match words.iter().position(|known| known == word) {
            Some(index) => Ok(Some(index as i64)),
            None => bad(format!("\"{word}\"")),
        },
    }
}

const LIFE_WORDS: [&str; 4] = ["none", "counter_0_255", "counter_1_255", "nibble"];

/// Reads a DBC text.
pub(crate) fn read(file: &str, text: &str) -> Result<Network, Diagnostics> {
    let dbc = parse(file, text)?;
    let mut report = Report::new(file, text);
    let lines = Lines::find(text, &mut report);
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
            report.line(lines.note("BusSpeed", 0, "", 1), "BusSpeed must be set, 10000 to 1000000 bit/s");
            0
        }
    };
    let mut messages: Vec<Message> = Vec::new();
    for message in dbc.messages.iter().filter(|message| message.name != "VECTOR__INDEPENDENT_SIG_MSG") {
        let line = lines.messages.get(&message.id.raw()).copied().unwrap_or(0);
        if messages.iter().any(|other| other.name == message.name) {
            report.line(line, format!("message `{}` is used before", message.name));
        }
        if let Some(sender) = message.transmitter.as_ref().filter(|sender| !nodes.contains(sender)) {
            let near = did_you_mean(sender, nodes.iter().map(String::as_str));
            report.line(line, format!("sender `{sender}` is not in the list of nodes (BU_){near}"));
        }
        messages.push(read_message(&dbc, message, line, &lines, &mut report));
    }
    for description in &dbc.value_descriptions {
        let ValueDescription::Signal { message_id, name, .. } = description else { continue };
        if dbc.signal_by_name(*message_id, name).is_none() {
            let line = lines.note("VAL_", message_id.raw(), name, 0);
            report.line(line, format!("value table of a signal that does not exist: `{name}`"));
        }
    }
    report.finish().or(Network { bitrate, nodes, messages })
}

fn read_message(
    dbc: &Dbc,
    message: &can_dbc::Message,
    line: usize,
    lines: &Lines<'_>,
    report: &mut Report<'_>,
) -> Message {
    let id = message.id.raw();
    let mut attribute = |name: &str, range: std::ops::RangeInclusive<i64>| {
        let value = whole(dbc.resolved_message_attribute(message.id, name), &[]);
        match value {
            Ok(None) => 0,
            Ok(Some(number)) if range.contains(&number) => number,
            Ok(Some(number)) => {
                let at = lines.note(name, id, "", line);
                report.line(at, format!("{name} is {number}, must be {} to {}", range.start(), range.end()));
                0
            }
            Err(reason) => {
                report.line(lines.note(name, id, "", line), format!("{name} {reason}"));
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
    for signal in &message.signals {
        signals.extend(read_signal(dbc, message, signal, len, lines, report));
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
            let at = lines.signals.get(&(id, signal.name.as_str())).map_or(line, |(line, _)| *line);
            report.line(at, format!("signal `{}` overlaps `{rival}`", signal.name));
        }
    }
    let selectors = signals.iter().filter(|signal| signal.mux == Mux::Selector).count();
    let multiplexed = signals.iter().any(|signal| matches!(signal.mux, Mux::When(_)));
    if selectors > 1 || multiplexed && selectors == 0 {
        report
            .line(line, format!("message `{}` has {selectors} multiplexers, needs exactly 1", message.name));
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
        id,
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
    len: u8,
    lines: &Lines<'_>,
    report: &mut Report<'_>,
) -> Option<Signal> {
    let id = message.id.raw();
    let name = signal.name.as_str();
    let (line, text) = lines.signals.get(&(id, name)).copied()?;
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
    if minimum != maximum || minimum != Ratio::ZERO {
        let (a, b) = ((minimum - offset) / factor, (maximum - offset) / factor);
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
            report.line(lines.note(attribute, id, name, line), format!("{attribute} of `{name}` {reason}"));
            None
        })
    };
    let life = match attribute("LifeKind", &LIFE_WORDS) {
        Some(1) => Some(LifeKind::From0To255),
        Some(2) => Some(LifeKind::From1To255),
        Some(3) => Some(LifeKind::Nibble),
        _ => None,
    };
    let invalid_raw = attribute("SigInvalidRaw", &[]).filter(|raw| *raw >= 0 || signed && *raw != -1);
    let start_raw = attribute("GenSigStartValue", &[]).unwrap_or(0);
    for (what, raw) in [("SigInvalidRaw", invalid_raw), ("GenSigStartValue", Some(start_raw))] {
        if raw.is_some_and(|raw| !(lowest..=highest).contains(&raw)) {
            let at = lines.note(what, id, name, line);
            report.line(at, format!("{what} of `{name}` does not fit in its {length} bits"));
        }
    }
    let bits = if life == Some(LifeKind::Nibble) { 4 } else { 8 };
    if life.is_some() && (length != bits || segments(start, length, order).len() != 1) {
        let at = lines.note("LifeKind", id, name, line);
        report.line(at, format!("life counter `{name}` must have {bits} bits within one byte"));
    }
    let mux = match signal.multiplexer_indicator {
        MultiplexIndicator::Plain => Mux::Always,
        MultiplexIndicator::Multiplexor => Mux::Selector,
        MultiplexIndicator::MultiplexedSignal(when) => Mux::When(when as u32),
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
            let at = lines.note("VAL_", id, name, line);
            report.line(at, format!("value {raw} \"{word}\" does not fit in the {length} bits of `{name}`"));
        }
    }
    for pair in values.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        report.line(
            lines.note("VAL_", id, name, line),
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

/// Parses the text; a syntax error carries its line.
fn parse(file: &str, text: &str) -> Result<Dbc, Diagnostics> {
    let error = match Dbc::try_from(text) {
        Ok(dbc) => return Ok(dbc),
        Err(error) => error,
    };
    let shown = error.to_string();
    if let can_dbc::DbcError::Pest(_) = error {
        // The grammar's own report begins "--> line:column" and ends "= expected ...".
        let line =
            shown.split("--> ").nth(1).and_then(|at| at.split(':').next()?.trim().parse().ok()).unwrap_or(0);
        let source = text.lines().nth(usize::max(line, 1) - 1).unwrap_or("").trim();
        let message = if source.is_empty() || line > text.lines().count() {
            "the file ends in the middle of an entry".to_string()
        } else {
            let expected = shown.rsplit("= ").next().unwrap_or("").replace('_', " ");
            format!("not valid DBC: `{source}` ({expected})")
        };
        return Err(Diagnostics::one(file, line, message));
    }
    Err(Diagnostics::one(file, failing_line(text), format!("not valid DBC: {shown}")))
}

/// Returns the first line without which the text fails otherwise: for errors that carry no position.
fn failing_line(text: &str) -> usize {
    let ends: Vec<usize> = text.match_indices('\n').map(|(at, _)| at + 1).chain([text.len()]).collect();
    let fails = |count: &usize| {
        let prefix = &text[..ends[*count - 1]];
        matches!(Dbc::try_from(prefix), Err(error) if !matches!(error, can_dbc::DbcError::Pest(_)))
    };
    (1..=ends.len()).find(fails).unwrap_or(0)
}
