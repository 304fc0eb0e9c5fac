//! Reads a DBC text: every section that says what the bits mean is carried out or told with its place.
//!
//! Owns the grades. An *error* is a text of which nothing can be had. A *warning* is a message or a signal that cannot be
//! had: to bind it is an error, to leave it alone is not. A *note* is what was understood another way than it is written
//! (a range beyond the bits, a start value that does not fit).
//! Not supported, and a warning with its place: CAN FD, more than 8 bytes, more than 64 bits.

use crate::diagnostics::{Diagnostics, Report, did_you_mean};
use crate::multiplex::{Mark, find_conditions};
use crate::names;
use crate::network::{Doubt, Message, Network, Signal, segments};
use crate::number::Number;
use crate::places::{At, MessagePlace, MuxValues, Note, Places, SignalPlace, Written};
use crate::ratio::{Linear, Ratio};
use crate::syntax::{first_unplaced, parse, placed, without_mark};
use can_dbc::{AttributeDefinition, AttributeValue, AttributeValueType, ByteOrder, Dbc, ValueType};
use protocol_core::CanId;
use protocol_core::codec::{LifeKind, Order};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

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

/// Attributes and tables that say something of a signal: given twice, only one of them can hold.
const OF_SIGNALS: [&str; 5] =
    ["GenSigStartValue", "LifeKind", "SigInvalidRaw", "SystemSignalLongSymbol", "VAL_"];

/// The same of a message.
const OF_MESSAGES: [&str; 6] = [
    "FillByte",
    "GenMsgCycleTime",
    "GenMsgCycleTimeSlow",
    "Optional",
    "SystemMessageLongSymbol",
    "VFrameFormat",
];

/// Source address of a J1939 identifier that stands for any: no node has it.
const ANY_SOURCE: u32 = 0xFE;

/// A network and what was found in its text besides.
pub(crate) struct Found {
    pub(crate) network: Network,
    /// Warnings and notes.
    pub(crate) findings: Diagnostics,
}

/// Reads a DBC text.
///
/// # Errors
///
/// If it is none: everything that is wrong with it.
pub(crate) fn read(file: &str, text: &str) -> Result<Found, Diagnostics> {
    let dbc = parse(file, text)?;
    let places = Places::find(without_mark(text));
    if let Some(line) = first_unplaced(&dbc, &places) {
        let said = "this entry is not understood: write each entry on a line of its own";
        return Err(Diagnostics::one(file, line, said));
    }
    let mut gate = Gate::new(&dbc, &places, Report::new(file, text));
    let network = gate.network();
    Ok(Found { network, findings: gate.report.finish() })
}

/// A value of an attribute.
#[derive(Clone, Copy)]
enum Said<'a> {
    Text(&'a str),
    Number(&'a str),
    Float(f64),
}

/// Name and place of what is given again, and the line of the one before.
type Again<'a> = (&'a str, At, usize);

struct Gate<'a> {
    dbc: &'a Dbc,
    places: &'a Places<'a>,
    report: Report<'a>,
    defaults: BTreeMap<&'a str, &'a AttributeValue>,
    /// `SIG_VALTYPE_` by message and signal.
    kinds: BTreeMap<(u64, &'a str), (&'a str, At)>,
    /// `SG_MUL_VAL_` by message and signal.
    ranges: BTreeMap<u64, BTreeMap<&'a str, &'a MuxValues<'a>>>,
    frame_formats: Vec<&'a str>,
    /// What is given twice, by message and signal: name, place, line of the one before.
    repeated: BTreeMap<(u64, &'a str), Vec<Again<'a>>>,
}

impl<'a> Gate<'a> {
    fn new(dbc: &'a Dbc, places: &'a Places<'a>, report: Report<'a>) -> Self {
        let formats = dbc.attribute_definitions.iter().find_map(|definition| match definition {
            AttributeDefinition::Message(name, AttributeValueType::Enum(words)) if name == "VFrameFormat" => {
                Some(words.iter().map(String::as_str).collect())
            }
            _ => None,
        });
        let mut ranges: BTreeMap<u64, BTreeMap<&str, &MuxValues<'_>>> = BTreeMap::new();
        for values in &places.mux_values {
            ranges.entry(values.message).or_default().insert(values.signal, values);
        }
        let mut repeated: BTreeMap<(u64, &str), Vec<Again<'_>>> = BTreeMap::new();
        for ((name, message, signal), at, first) in &places.repeated {
            repeated.entry((*message, *signal)).or_default().push((name, *at, *first));
        }
        Self {
            dbc,
            places,
            report,
            repeated,
            // The first of several holds, as everywhere.
            defaults: dbc
                .attribute_defaults
                .iter()
                .rev()
                .map(|row| (row.name.as_str(), &row.value))
                .collect(),
            kinds: places
                .kinds
                .iter()
                .map(|kind| ((kind.message, kind.signal), (kind.kind, kind.at)))
                .collect(),
            ranges,
            frame_formats: formats.unwrap_or(FRAME_FORMATS.to_vec()),
        }
    }

    fn network(&mut self) -> Network {
        let (dbc, places) = (self.dbc, self.places);
        let mut nodes: Vec<String> = dbc.nodes.iter().map(|node| node.0.clone()).collect();
        let bitrate = self.bitrate();
        let signal_is_there = |message: u64, name: &str| {
            places
                .message(message)
                .is_some_and(|place| place.signals.iter().any(|signal| signal.name == name))
        };
        for values in &places.mux_values {
            if !signal_is_there(values.message, values.signal) {
                let text = format!("SG_MUL_VAL_ of a signal that does not exist: `{}`", values.signal);
                self.report.warning(values.at, text);
            }
        }
        for (at, signal) in places.tables_of_nothing() {
            self.report.note(at, format!("value table of a signal that does not exist: `{signal}`"));
        }
        for ((name, message, _), at, first) in &places.repeated {
            if *message == u64::MAX && *name == "BusSpeed" || places.message(*message).is_none() {
                self.report.note(*at, format!("{name} is given before, in line {first}"));
            }
        }
        let mut lines: BTreeMap<u32, usize> = BTreeMap::new();
        let mut messages: Vec<Message> = Vec::new();
        let mut names: BTreeMap<String, usize> = BTreeMap::new();
        let mut unknown_senders = BTreeSet::new();
        for (message, place) in placed(dbc, places) {
            let mut read = self.message(message, place);
            // Of a group the identifier is without priority and source: two may be one.
            if let (None, Some(first)) = (&read.doubt, lines.insert(read.id, place.at.line)) {
                let text = format!("identifier {} is used before, in line {first}", place.id);
                self.report.warning(place.at, text.clone());
                let doubt = Doubt { at: place.at, text };
                for other in messages.iter_mut().filter(|other: &&mut Message| other.id == read.id) {
                    other.doubt.get_or_insert(doubt.clone());
                }
                read.doubt = Some(doubt);
            }
            if let Some(first) = names.insert(read.name.clone(), place.at.line) {
                let text = format!("message `{}` is used before, in line {first}", read.name);
                self.report.warning(place.at, text.clone());
                let doubt = Doubt { at: place.at, text };
                for other in messages.iter_mut().filter(|other: &&mut Message| other.name == read.name) {
                    other.twice.get_or_insert(doubt.clone());
                }
                read.twice = Some(doubt);
            }
            if !read.sender.is_empty() && !nodes.contains(&read.sender) {
                if unknown_senders.insert(read.sender.clone()) {
                    let near = did_you_mean(&read.sender, nodes.iter().map(String::as_str));
                    let text = format!("sender `{}` is not in the list of nodes (BU_){near}", read.sender);
                    self.report.note(place.at, text);
                }
                nodes.push(read.sender.clone());
            }
            messages.push(read);
        }
        names::make_unique(&mut messages);
        Network::new(bitrate, (nodes, dbc.nodes.len()), messages)
    }

    fn bitrate(&mut self) -> Option<u32> {
        let said = self.places.network_attribute("BusSpeed");
        let value = said.map(|note| said_by(note.value)).or_else(|| self.default("BusSpeed"))?;
        match whole(value, &[]) {
            Ok(rate) if (10_000..=1_000_000).contains(&rate) => Some(rate as u32),
            _ => {
                let at = said.map_or(At { line: 1, column: 0 }, |note| note.at);
                self.report.warning(at, "BusSpeed is not 10000 to 1000000 bit/s");
                None
            }
        }
    }

    fn default(&self, name: &str) -> Option<Said<'a>> {
        self.defaults.get(name).map(|value| match value {
            AttributeValue::Uint(number) => Said::Float(*number as f64),
            AttributeValue::Int(number) => Said::Float(*number as f64),
            AttributeValue::Double(number) => Said::Float(*number),
            AttributeValue::String(text) => Said::Text(text),
        })
    }

    /// Returns an attribute of a message, or of a signal if one is named: what is written, else the default.
    fn attribute(&self, name: &str, message: u64, signal: &str) -> Option<(Said<'a>, Option<At>)> {
        let note: Option<Note<'a>> = self.places.attribute(name, message, signal);
        match note {
            Some(note) => Some((said_by(note.value), Some(note.at))),
            None => self.default(name).map(|said| (said, None)),
        }
    }

    fn message(&mut self, message: &can_dbc::Message, place: &MessagePlace<'a>) -> Message {
        let (id, name) = (place.id, place.name);
        let mut doubt = self.repeated(&OF_MESSAGES, id, "").map(|(_, doubt)| doubt);
        let (format, said_at) = self.frame_format(id);
        let format_at = said_at.unwrap_or(place.at);
        if let Some(text) = wrong_identifier(id) {
            doubt = Some(Doubt { at: place.at, text: format!("identifier {id} of `{name}` {text}") });
        }
        if format.ends_with("_FD") {
            let text = format!("message `{name}` is CAN FD ({format}); only classic CAN is received here");
            doubt = Some(Doubt { at: format_at, text });
        } else if message.size > 8 {
            let text = format!("message `{name}` has {} bytes; classic CAN has 8", message.size);
            doubt = Some(Doubt { at: place.at, text });
        }
        if let Some(doubt) = &doubt {
            self.report.warning(doubt.at, doubt.text.clone());
        }
        let can_id = CanId::from_packed(id as u32);
        // A file that says nothing of the form of 29 bits and writes a source that nobody has means any.
        let is_open = format != "ExtendedCAN" && said_at.is_none() && can_id.bits() & 0xFF == ANY_SOURCE;
        let group = can_id.group().filter(|_| format == "J1939PG" || is_open);
        let len = message.size.min(8) as u8;
        let cycle_ms = self.number_of("GenMsgCycleTime", id, place.at, 0..=60_000);
        let slow_cycle_ms = self.number_of("GenMsgCycleTimeSlow", id, place.at, 0..=60_000).max(cycle_ms);
        let optional = self.number_of("Optional", id, place.at, 0..=1) == 1;
        let fill_byte = self.number_of("FillByte", id, place.at, 0..=255) as u8;
        let (signals, lost) = self.signals(message, place, len);
        let mut fill = [fill_byte; 8];
        for segment in signals.iter().flat_map(Signal::segments) {
            fill[usize::from(segment.byte)] = 0;
        }
        fill[usize::from(len)..].fill(0);
        if doubt.is_none() && signals.iter().filter(|signal| signal.life.is_some()).count() > 1 {
            let text = format!("message `{name}` has more than one life counter");
            self.report.warning(place.at, text.clone());
            doubt = Some(Doubt { at: place.at, text });
        }
        Message {
            id: group.unwrap_or(can_id).packed(),
            any_source: group.is_some(),
            name: self.long_name("SystemMessageLongSymbol", id, "", name),
            short: name.into(),
            sender: message.transmitter.clone().unwrap_or_default(),
            len,
            cycle_ms,
            slow_cycle_ms,
            optional,
            fill,
            signals,
            lost,
            doubt,
            twice: None,
            type_name: String::new(),
            function: String::new(),
        }
    }

    /// Returns the first of these attributes that is given twice, and the doubt that this raises.
    fn repeated(&self, names: &[&str], message: u64, signal: &str) -> Option<(&'a str, Doubt)> {
        let of = self.repeated.get(&(message, signal))?;
        let (name, at, first) = of.iter().find(|(name, ..)| names.contains(name))?;
        let what = if *name == "VAL_" { "this value table" } else { name };
        Some((name, Doubt { at: *at, text: format!("{what} is given before, in line {first}") }))
    }

    fn long_name(&self, attribute: &str, message: u64, signal: &str, short: &str) -> String {
        match self.places.attribute(attribute, message, signal).map(|note| note.value) {
            Some(Written::Text(long)) if names::is_name(long) => long.into(),
            _ => short.into(),
        }
    }

    /// Returns the word of `VFrameFormat`, empty if the file does not say it, and where it stands.
    fn frame_format(&self, message: u64) -> (String, Option<At>) {
        let Some((said, at)) = self.attribute("VFrameFormat", message, "") else { return Default::default() };
        let word = match said {
            Said::Text(word) => word,
            number => {
                let index = whole(number, &[]).ok().and_then(|index| usize::try_from(index).ok());
                let defined = index.and_then(|index| self.frame_formats.get(index));
                let usual = index.and_then(|index| FRAME_FORMATS.get(index));
                defined.or(usual).copied().unwrap_or("")
            }
        };
        (word.into(), at)
    }

    /// Reads an attribute of a message; a number that cannot be is told and is 0.
    fn number_of(&mut self, name: &str, id: u64, line: At, range: RangeInclusive<i64>) -> u32 {
        let Some((said, at)) = self.attribute(name, id, "") else { return 0 };
        let text = match whole(said, &[]) {
            Ok(number) if range.contains(&number) => return number as u32,
            Ok(number) => {
                format!("{name} is {number}, must be {} to {}; taken as 0", range.start(), range.end())
            }
            Err(reason) => format!("{name} {reason}; taken as 0"),
        };
        self.report.note(at.unwrap_or(line), text);
        0
    }

    /// Returns the signals that can be read and those that cannot.
    fn signals(
        &mut self,
        message: &can_dbc::Message,
        place: &MessagePlace<'a>,
        len: u8,
    ) -> (Vec<Signal>, Vec<(String, Doubt)>) {
        let (mut signals, mut lost, mut marks): (Vec<Signal>, Vec<(String, Doubt)>, Vec<Mark<'_>>) =
            Default::default();
        for (signal, place_of) in message.signals.iter().zip(&place.signals) {
            match self.signal(signal, (place.id, place_of), len) {
                Ok(mut read) => {
                    if let Some(first) = signals.iter_mut().find(|first| first.name == read.name) {
                        let text =
                            format!("signal `{}` is used before, in line {}", read.name, first.at.line);
                        self.report.warning(read.at, text.clone());
                        let doubt = Doubt { at: read.at, text };
                        first.doubt.get_or_insert(doubt.clone());
                        read.doubt = Some(doubt);
                    }
                    signals.push(read);
                    marks.push(Mark::read(place_of.mux));
                }
                Err(doubt) => lost.push((signal.name.clone(), doubt)),
            }
        }
        let none = BTreeMap::new();
        let ranges = self.ranges.get(&place.id).unwrap_or(&none);
        let mut wrong: Vec<(usize, Doubt)> = find_conditions(&mut signals, &marks, ranges, place);
        wrong.sort_by_key(|(index, _)| std::cmp::Reverse(*index));
        wrong.dedup_by_key(|(index, _)| *index);
        for (index, doubt) in wrong {
            lost.push((signals.remove(index).name, doubt));
            // What follows has moved up, and so have the multiplexers that it names.
            for condition in signals.iter_mut().flat_map(|signal| &mut signal.when) {
                condition.selector -= usize::from(condition.selector > index);
            }
        }
        for (_, doubt) in &lost {
            self.report.warning(doubt.at, doubt.text.clone());
        }
        self.report_overlaps(&signals);
        (signals, lost)
    }

    fn report_overlaps(&mut self, signals: &[Signal]) {
        let mut owners: BTreeMap<(u8, u8), Vec<usize>> = BTreeMap::new();
        for (index, signal) in signals.iter().enumerate() {
            let mut rivals = BTreeSet::new();
            for segment in signal.segments() {
                for bit in segment.low..segment.low + segment.bits {
                    let owner = owners.entry((segment.byte, bit)).or_default();
                    rivals.extend(owner.iter().filter(|other| !signals[**other].excludes(signal)).copied());
                    owner.push(index);
                }
            }
            for rival in rivals {
                let text = format!("signal `{}` overlaps `{}`", signal.name, signals[rival].name);
                self.report.note(signal.at, text);
            }
        }
    }

    fn signal(
        &mut self,
        signal: &can_dbc::Signal,
        (id, place): (u64, &SignalPlace<'a>),
        len: u8,
    ) -> Result<Signal, Doubt> {
        let (name, at) = (place.name, place.at);
        let lost = |text: String| Err(Doubt { at, text });
        let Some([factor, offset, minimum, maximum]) = numbers(place.numbers) else {
            return lost(format!("factor, offset and range of `{name}` are not four decimal numbers"));
        };
        let (Some(factor), Some(offset)) = (Ratio::parse(factor), Ratio::parse(offset)) else {
            return lost(format!("factor or offset of `{name}` is beyond 37 digits"));
        };
        if !(1..=64).contains(&signal.size) || signal.start_bit > 63 {
            return lost(format!(
                "`{name}` must have 1 to 64 bits within 8 bytes, has {} at {}",
                signal.size, signal.start_bit
            ));
        }
        let (start, length) = (signal.start_bit as u8, signal.size as u8);
        let order = match signal.byte_order {
            ByteOrder::LittleEndian => Order::Intel,
            ByteOrder::BigEndian => Order::Motorola,
        };
        if segments(start, length, order).iter().any(|segment| segment.byte >= len) {
            return lost(format!("`{name}` reaches beyond the {len} bytes of the message"));
        }
        let number = match self.kinds.get(&(id, name)) {
            Some(("1", _)) if length == 32 => Number::Float32,
            Some(("2", _)) if length == 64 => Number::Float64,
            Some((kind @ ("1" | "2"), kind_at)) => {
                let bits = if *kind == "1" { 32 } else { 64 };
                let text =
                    format!("`{name}` is an IEEE float of {bits} bits (SIG_VALTYPE_), but has {length}");
                return Err(Doubt { at: *kind_at, text });
            }
            _ if signal.value_type == ValueType::Signed => Number::Signed,
            _ => Number::Unsigned,
        };
        let mut read = Signal {
            name: self.long_name("SystemSignalLongSymbol", id, name, name),
            short: name.into(),
            at,
            start,
            length,
            order,
            number,
            factor,
            offset,
            scale: Linear::new(factor, offset),
            unit: signal.unit.clone(),
            range: number.span(length),
            is_limited: false,
            float_range: None,
            start_raw: 0,
            invalid_raw: None,
            is_selector: Mark::read(place.mux).is_selector,
            when: Vec::new(),
            life: None,
            values: Vec::new(),
            doubt: self.repeated(&OF_SIGNALS, id, name).map(|(_, doubt)| doubt),
            function: String::new(),
        };
        if factor == Ratio::ZERO {
            read.doubt = Some(Doubt { at, text: format!("factor of `{name}` is 0") });
        }
        self.limits(&mut read, minimum, maximum);
        self.raws(&mut read, id);
        self.words(&mut read, id);
        if let Some(doubt) = &read.doubt {
            self.report.warning(doubt.at, doubt.text.clone());
        }
        Ok(read)
    }

    /// Reads the range in which a value is valid, and limits it to what the bits can hold.
    fn limits(&mut self, signal: &mut Signal, minimum: &str, maximum: &str) {
        let limits = [minimum, maximum].map(Ratio::parse);
        if limits == [Some(Ratio::ZERO); 2] || signal.factor == Ratio::ZERO {
            return;
        }
        let (at, name) = (signal.at, &signal.name);
        if signal.number.is_float() {
            let value = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
            let unscaled =
                |value: f64| (value - signal.offset.approximately()) / signal.factor.approximately();
            let near = |value: f64| signal.number.float(signal.number.pattern(value));
            let (a, b) = (near(unscaled(value(minimum))), near(unscaled(value(maximum))));
            if a.is_nan() || b.is_nan() || a == b {
                self.report
                    .note(at, format!("the range of `{name}` says nothing; every value is taken as valid"));
            } else {
                signal.float_range = Some((a.min(b), a.max(b)));
            }
            return;
        }
        let (lowest, highest) = signal.span();
        // A limit of more digits than can be read is one that no raw value reaches.
        let beyond = |text: &str| if text.starts_with('-') { i128::MIN } else { i128::MAX };
        let raw = |limit: Option<Ratio>, text: &str, up: bool| {
            let above = limit.and_then(|limit| limit.checked_sub(signal.offset)?.checked_div(signal.factor));
            above.map_or(beyond(text), |above| if up { above.ceil() } else { above.floor() })
        };
        let rising = signal.factor.num > 0;
        let (low, high) = match rising {
            true => (raw(limits[0], minimum, true), raw(limits[1], maximum, false)),
            false => (raw(limits[1], maximum, true), raw(limits[0], minimum, false)),
        };
        let (held_low, held_high) = (low.clamp(lowest, highest), high.clamp(lowest, highest));
        if low > high || low > highest || high < lowest {
            let text = format!("the range of `{name}` holds no raw value; every value is taken as valid");
            self.report.note(at, text);
            return;
        }
        if (held_low, held_high) != (low, high) {
            let bits = signal.length;
            let shown = |raw: i128| {
                if raw == i128::MIN || raw == i128::MAX { "beyond".into() } else { raw.to_string() }
            };
            let text = format!(
                "range of `{name}` is raw {} to {}; its {bits} bits hold {lowest} to {highest}, which is taken",
                shown(low),
                shown(high)
            );
            self.report.note(at, text);
        }
        signal.is_limited = (held_low, held_high) != (low, high);
        signal.range = (held_low, held_high);
    }

    /// Reads the attributes that are raw values, and the life counter.
    fn raws(&mut self, signal: &mut Signal, id: u64) {
        let (short, name) = (signal.short.clone(), signal.name.clone());
        let mut doubts: Vec<Doubt> = Vec::new();
        let mut notes: Vec<(At, String)> = Vec::new();
        let mut read = |attribute: &str, words: &[&str]| {
            let (said, at) = self.attribute(attribute, id, &short)?;
            let at = at.unwrap_or(signal.at);
            match whole(said, words) {
                Ok(number) => Some((number, at)),
                Err(reason) => {
                    notes.push((at, format!("{attribute} of `{name}` {reason}")));
                    None
                }
            }
        };
        let life = read("LifeKind", &LIFE_WORDS);
        let invalid = read("SigInvalidRaw", &[]).filter(|(raw, _)| *raw != -1);
        let start = read("GenSigStartValue", &[]);
        let (lowest, highest) = signal.span();
        let fits = |raw: i64| (lowest..=highest).contains(&i128::from(raw));
        match invalid {
            Some((raw, _)) if fits(raw) => signal.invalid_raw = Some(raw.into()),
            Some((_, at)) => {
                let text = format!("SigInvalidRaw of `{name}` does not fit in its {} bits", signal.length);
                doubts.push(Doubt { at, text });
            }
            None => {}
        }
        match start {
            Some((raw, _)) if fits(raw) => signal.start_raw = raw.into(),
            Some((_, at)) => {
                let bits = signal.length;
                notes.push((
                    at,
                    format!("GenSigStartValue of `{name}` does not fit in its {bits} bits; taken as 0"),
                ));
            }
            None => {}
        }
        signal.life = match life {
            Some((1, _)) => Some(LifeKind::From0To255),
            Some((2, _)) => Some(LifeKind::From1To255),
            Some((3, _)) => Some(LifeKind::Nibble),
            _ => None,
        };
        let bits = if signal.life == Some(LifeKind::Nibble) { 4 } else { 8 };
        if let (Some(_), Some((_, at))) = (signal.life, life)
            && (signal.length != bits || signal.segments().len() != 1)
        {
            doubts.push(Doubt {
                at,
                text: format!("life counter `{name}` must have {bits} bits within one byte"),
            });
            signal.life = None;
        }
        for (at, text) in notes {
            self.report.note(at, text);
        }
        let first = doubts.into_iter().next();
        signal.doubt = signal.doubt.take().or(first);
    }

    /// Reads the value table.
    fn words(&mut self, signal: &mut Signal, id: u64) {
        let Some(words) = self.places.words(id, &signal.short) else { return };
        let (lowest, highest) = signal.span();
        let mut values: BTreeMap<i64, String> = BTreeMap::new();
        for (written, word) in &words.rows {
            let raw =
                written.parse::<i64>().ok().filter(|raw| (lowest..=highest).contains(&i128::from(*raw)));
            let Some(raw) = raw else {
                let (bits, name) = (signal.length, &signal.name);
                let text = format!("value {written} \"{word}\" does not fit in the {bits} bits of `{name}`");
                self.report.note(words.at, text);
                continue;
            };
            if values.insert(raw, word.replace("\\\"", "\"")).is_some() {
                let text = format!("value {raw} of `{}` is named twice; the last name is taken", signal.name);
                self.report.note(words.at, text);
            }
        }
        signal.values = values.into_iter().collect();
    }
}

/// Returns the four numbers `(factor,offset) [minimum|maximum]` of the text after the colon of a signal.
pub(crate) fn numbers(text: &str) -> Option<[&str; 4]> {
    let (_, after) = text.split_once('(')?;
    let (scale, after) = after.split_once(')')?;
    let (_, after) = after.split_once('[')?;
    let (range, _) = after.split_once(']')?;
    let (factor, offset) = scale.split_once(',')?;
    let (minimum, maximum) = range.split_once('|')?;
    Some([factor, offset, minimum, maximum].map(str::trim))
}

fn said_by(written: Written<'_>) -> Said<'_> {
    match written {
        Written::Text(text) => Said::Text(text),
        Written::Number(number) => Said::Number(number),
    }
}

/// Reads an attribute as a whole number; an ENUM may be given by number or by one of `words`.
fn whole(said: Said<'_>, words: &[&str]) -> Result<i64, String> {
    let bad = |shown: String| Err(format!("has the value {shown}, a whole number is needed"));
    match said {
        Said::Number(text) => match Ratio::parse(text).filter(|ratio| ratio.den == 1) {
            Some(ratio) => i64::try_from(ratio.num).or(bad(text.into())),
            None => bad(text.into()),
        },
        Said::Float(number) if number.fract() == 0.0 && number.abs() < 9e18 => Ok(number as i64),
        Said::Float(number) => bad(number.to_string()),
        Said::Text(word) => match words.iter().position(|known| *known == word) {
            Some(index) => Ok(index as i64),
            None => bad(format!("\"{word}\"")),
        },
    }
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
