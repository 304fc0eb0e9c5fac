//! Rust text of the messages: one type per message, getters and setters of straight shifts and masks.

use crate::network::{Condition, Message, Network, Segment, Signal};
use crate::number::Number;
use crate::one_line;
use crate::ratio::Linear;
use protocol_core::CanId;
use protocol_core::codec::{self, LifeKind, Mux, Order};
use std::fmt::Write;

/// Bits of the integer that holds the raw value.
pub(crate) fn width(signal: &Signal) -> u8 {
    match signal.length {
        0..=8 => 8,
        9..=16 => 16,
        17..=32 => 32,
        _ => 64,
    }
}

fn raw_type(signal: &Signal) -> String {
    format!("{}{}", if signal.signed() { 'i' } else { 'u' }, width(signal))
}

/// Type of the physical value: 32 bits unless the valid range needs more.
fn physical_type(signal: &Signal, scale: Linear) -> &'static str {
    let fits = |raw: i128| i32::try_from(raw * i128::from(scale.mul) + i128::from(scale.add)).is_ok();
    let (lowest, highest) = signal.span();
    if fits(lowest) && fits(highest) { "i32" } else { "i64" }
}

pub(crate) fn id_text(id: u32) -> String {
    let id = CanId::from_packed(id);
    match id.is_extended() {
        true => format!("CanId::extended(0x{:08X})", id.bits()),
        false => format!("CanId::standard(0x{:03X})", id.bits()),
    }
}

fn bytes_text(bytes: &[u8; 8]) -> String {
    let shown: Vec<String> = bytes.iter().map(|byte| format!("0x{byte:02X}")).collect();
    format!("[{}]", shown.join(", "))
}

/// Returns the unsigned raw value of a message in `self.0`.
fn read_bits(signal: &Signal) -> String {
    let segments = signal.segments();
    let whole = segments.iter().all(|segment| segment.bits == 8);
    let width = width(signal);
    let bytes = |order: &mut dyn Iterator<Item = &Segment>| {
        order.map(|segment| format!("self.0[{}]", segment.byte)).collect::<Vec<_>>().join(", ")
    };
    if whole && segments.len() == 1 {
        return format!("self.0[{}]", segments[0].byte);
    }
    if whole && segments.len() * 8 == usize::from(width) {
        return match signal.order {
            Order::Intel => format!("u{width}::from_le_bytes([{}])", bytes(&mut segments.iter())),
            Order::Motorola => format!("u{width}::from_be_bytes([{}])", bytes(&mut segments.iter().rev())),
        };
    }
    let part = |segment: &Segment| {
        let mut text = format!("self.0[{}]", segment.byte);
        if segment.low > 0 {
            text = format!("{text} >> {}", segment.low);
        }
        if segment.low + segment.bits < 8 {
            text = format!("{text} & 0x{:02X}", (1u16 << segment.bits) - 1);
        }
        if width > 8 {
            text = if text.contains(' ') {
                format!("({text}) as u{width}")
            } else {
                format!("{text} as u{width}")
            };
        }
        if segment.place > 0 {
            text = format!("({text}) << {}", segment.place);
        }
        text
    };
    segments.iter().map(part).collect::<Vec<_>>().join(" | ")
}

fn read_raw(signal: &Signal) -> String {
    let bits = read_bits(signal);
    if !signal.signed() {
        return bits;
    }
    let (kind, spare) = (raw_type(signal), width(signal) - signal.length);
    match spare {
        0 => format!("({bits}) as {kind}"),
        _ => format!("((({bits}) << {spare}) as {kind}) >> {spare}"),
    }
}

/// Returns the condition under which the pattern `raw` of a float is in its range; empty if it has none.
fn float_validity(signal: &Signal, raw: &str) -> String {
    let bits = width(signal);
    let key = |value: f64| match signal.number {
        Number::Float32 => i64::from(codec::float32_order(signal.number.pattern(value) as u32)),
        _ => codec::float64_order(signal.number.pattern(value) as u64),
    };
    let mut terms = Vec::new();
    if let Some((low, high)) = signal.float_range {
        // Minus zero is zero too.
        let low = if low == 0.0 { -0.0 } else { low };
        terms.push(format!("codec::float{bits}_order({raw}) >= {}", key(low)));
        terms.push(format!("codec::float{bits}_order({raw}) <= {}", key(high + 0.0)));
    }
    terms.extend(signal.invalid_raw.map(|invalid| format!("{raw} != {invalid}")));
    terms.join(" && ")
}

/// Returns the condition under which `raw` is a value; empty if it always is.
pub(crate) fn validity(signal: &Signal, raw: &str) -> String {
    if signal.number.is_float() {
        return float_validity(signal, raw);
    }
    let (lowest, highest) = signal.span();
    let (low, high) = signal.range;
    let mut terms = match (low > lowest, high < highest) {
        (false, false) => vec![],
        (false, true) if signal.signed() || high > 0 => vec![format!("{raw} <= {high}")],
        (false, true) => vec![format!("{raw} == {high}")],
        (true, false) => vec![format!("{raw} >= {low}")],
        (true, true) => vec![format!("{raw} >= {low}"), format!("{raw} <= {high}")],
    };
    if let Some(invalid) = signal.invalid_raw.filter(|raw| (low..=high).contains(raw)) {
        terms.push(format!("{raw} != {invalid}"));
    }
    terms.join(" && ")
}

/// Returns `raw * mul + add` in the integer `kind`.
pub(crate) fn counts(raw: &str, kind: &str, mul: i64, add: i64) -> String {
    let mut text = format!("{raw} as {kind}");
    if mul != 1 {
        text = format!("({text}) * {mul}");
    }
    match add {
        0 => {}
        1.. => text = format!("{text} + {add}"),
        ..0 => text = format!("{text} - {}", -add),
    }
    text
}

fn range_doc(signal: &Signal, scale: Linear) -> String {
    let (low, high) = signal.range;
    let unit = match (scale.den, signal.unit.as_str()) {
        (1, "") => String::new(),
        (1, unit) => format!("in {}", one_line(unit)),
        (den, unit) => format!("in 1/{den} {}", one_line(unit)).trim_end().to_string(),
    };
    let value = |raw: i128| raw * i128::from(scale.mul) + i128::from(scale.add);
    let values = (value(low), value(high));
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    format!("Returns the value{unit}, {} to {}; `None` if not valid.", values.0, values.1)
}

fn bits(length: u8) -> String {
    if length == 1 { "1 bit".into() } else { format!("{length} bits") }
}

fn write_getter(out: &mut String, signal: &Signal, scale: Linear) {
    let name = &signal.function;
    let physical = physical_type(signal, scale);
    let value = counts("raw", physical, scale.mul, scale.add);
    let valid = validity(signal, "raw");
    let _ = writeln!(out, "    /// {}", range_doc(signal, scale));
    let body = match valid.as_str() {
        "" => format!("Some({value})"),
        valid => format!("if {valid} {{ Some({value}) }} else {{ None }}"),
    };
    let _ = writeln!(out, "    #[inline(always)]\n    pub const fn {name}(self) -> Option<{physical}> {{");
    let _ = writeln!(out, "        let raw = self.{name}_raw();\n        {body}\n    }}");
}

fn condition_doc(message: &Message, condition: &Condition) -> String {
    let range = |(first, last): &(i128, i128)| match first == last {
        true => first.to_string(),
        false => format!("{first} to {last}"),
    };
    let ranges: Vec<String> = condition.ranges.iter().map(range).collect();
    format!(", only while `{}` is {}", message.signals[condition.selector].name, ranges.join(" or "))
}

fn write_signal(out: &mut String, message: &Message, signal: &Signal) {
    let (name, kind) = (&signal.function, raw_type(signal));
    let place = match signal.order {
        Order::Intel => format!("{} from bit {}", bits(signal.length), signal.start),
        Order::Motorola => format!("{} down from bit {}", bits(signal.length), signal.start),
    };
    let when: String = signal.when.iter().map(|condition| condition_doc(message, condition)).collect();
    let _ = writeln!(out, "    /// Returns `{}` as sent: {place}{when}.", signal.name);
    let _ = writeln!(out, "    #[inline(always)]");
    let _ = writeln!(out, "    pub const fn {name}_raw(self) -> {kind} {{ {} }}", read_raw(signal));

    // What no row can hold is read by the decoder alone.
    if let Some(scale) = signal.scale.filter(|_| signal.has_row(message)) {
        write_getter(out, signal, scale);
    }

    let _ = writeln!(out, "    /// Returns the frame with `{}` set to the low bits of `raw`.", signal.name);
    let _ = writeln!(out, "    #[inline(always)]");
    let _ = writeln!(out, "    pub const fn with_{name}_raw(mut self, raw: {kind}) -> Self {{");
    for segment in signal.segments() {
        let _ = writeln!(out, "        {}", write_segment(signal, segment));
    }
    let _ = writeln!(out, "        self\n    }}\n");
}

/// Returns the statement that puts the bits of `raw` into one byte.
fn write_segment(signal: &Signal, segment: Segment) -> String {
    let Segment { byte, low, bits, place } = segment;
    let width = width(signal);
    let unsigned = if signal.signed() { format!("(raw as u{width})") } else { "raw".into() };
    let part = match (width, place) {
        (8, 0) => unsigned,
        (8, _) => format!("({unsigned} >> {place})"),
        (_, 0) => "(raw as u8)".to_string(),
        _ => format!("(({unsigned} >> {place}) as u8)"),
    };
    if bits == 8 {
        let bare = part.strip_prefix('(').and_then(|part| part.strip_suffix(')')).unwrap_or(&part);
        return format!("self.0[{byte}] = {bare};");
    }
    let mask = ((1u16 << bits) - 1) as u8;
    let keep = !(mask << low);
    let part = match low {
        0 => format!("{part} & 0x{mask:02X}"),
        _ => format!("({part} & 0x{mask:02X}) << {low}"),
    };
    format!("self.0[{byte}] = self.0[{byte}] & 0x{keep:02X} | {part};")
}

fn cycle_doc(message: &Message) -> String {
    match (message.cycle_ms, message.slow_cycle_ms) {
        (0, 0) => String::new(),
        (fast, slow) if fast == slow => format!(", every {fast} ms"),
        (fast, slow) => format!(", every {fast} to {slow} ms"),
    }
}

fn write_message(out: &mut String, message: &Message, like: Option<&Message>) {
    let name = &message.type_name;
    let id = CanId::from_packed(message.id);
    let sender = if message.sender.is_empty() { String::new() } else { format!(" from {}", message.sender) };
    let _ = writeln!(out, "\n/// {} ({id}){sender}{}.", message.name, cycle_doc(message));
    if let Some(like) = like {
        let _ = writeln!(out, "pub type {name} = {};", &like.type_name);
        return;
    }
    let _ = writeln!(out, "#[derive(Clone, Copy, Debug, PartialEq, Eq)]\npub struct {name}(pub [u8; 8]);\n");
    let _ = writeln!(out, "impl Default for {name} {{\n    fn default() -> Self {{ Self::new() }}\n}}\n");
    let _ = writeln!(out, "impl {name} {{");
    let _ = writeln!(out, "    /// Returns a frame with no signal set: reserved bytes at their fill value.");
    let _ = writeln!(out, "    pub const fn new() -> Self {{ Self({}) }}\n", bytes_text(&message.fill));
    for signal in &message.signals {
        write_signal(out, message, signal);
    }
    let trimmed = out.trim_end().len();
    out.truncate(trimmed);
    out.push_str("\n}\n");
}

fn write_accessors(out: &mut String, message: &Message) {
    let name = &message.type_name;
    let rows: Vec<&Signal> = message.signals.iter().filter(|signal| signal.has_row(message)).collect();
    let get = format!("get_{}", message.function);
    let set = format!("set_{}", message.function);
    if rows.is_empty() {
        let _ = writeln!(out, "\nfn {get}(_index: usize, _data: [u8; 8]) -> Option<Got> {{ None }}");
        let _ = writeln!(out, "\nfn {set}(_index: usize, data: [u8; 8], _raw: i64) -> [u8; 8] {{ data }}");
        return;
    }
    let _ = writeln!(out, "\nfn {get}(index: usize, data: [u8; 8]) -> Option<Got> {{");
    let _ = writeln!(out, "    let frame = {name}(data);\n    Some(match index {{");
    for (index, signal) in rows.iter().enumerate() {
        let signal = &signal.function;
        let _ = writeln!(
            out,
            "        {index} => (frame.{signal}_raw() as i64, frame.{signal}().map(|value| value as i64)),"
        );
    }
    let _ = writeln!(out, "        _ => return None,\n    }})\n}}\n");
    let _ = writeln!(out, "fn {set}(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {{");
    let _ = writeln!(out, "    let frame = {name}(data);\n    match index {{");
    for (index, signal) in rows.iter().enumerate() {
        let kind = raw_type(signal);
        let _ = writeln!(out, "        {index} => frame.with_{}_raw(raw as {kind}).0,", &signal.function);
    }
    let _ = writeln!(out, "        _ => data,\n    }}\n}}");
}

fn write_info(out: &mut String, message: &Message, like: &Message) {
    let function = &like.function;
    let _ = write!(out, "    MessageInfo {{ id: {}, name: {:?}, ", id_text(message.id), message.name);
    let _ =
        write!(out, "sender: {:?}, len: {}, cycle_ms: {}, ", message.sender, message.len, message.cycle_ms);
    let _ = write!(out, "slow_cycle_ms: {}, optional: {}, ", message.slow_cycle_ms, message.optional);
    let _ = write!(out, "fill: {}, ", bytes_text(&message.fill));
    let _ = writeln!(out, "get: get_{function}, set: set_{function}, signals: {} }},", table_name(like));
}

/// Returns the name of the table of a message's signals.
fn table_name(message: &Message) -> String {
    format!("{}_SIGNALS", message.function.to_uppercase())
}

fn write_signal_info(out: &mut String, message: &Message, signal: &Signal) {
    let (Some(Linear { mul, add, den }), Some(mux)) = (signal.scale, message.mux(signal)) else { return };
    let order = match signal.order {
        Order::Intel => "Intel",
        Order::Motorola => "Motorola",
    };
    let mux = match mux {
        Mux::Always => "Mux::Always".into(),
        Mux::Selector => "Mux::Selector".into(),
        Mux::When(raw) => format!("Mux::When({raw})"),
    };
    let life = match signal.life {
        None => "None",
        Some(LifeKind::From0To255) => "Some(LifeKind::From0To255)",
        Some(LifeKind::From1To255) => "Some(LifeKind::From1To255)",
        Some(LifeKind::Nibble) => "Some(LifeKind::Nibble)",
    };
    let values: Vec<String> = signal.values.iter().map(|(raw, word)| format!("({raw}, {word:?})")).collect();
    let _ = write!(out, "    SignalInfo {{ name: {:?}, ", signal.name);
    let _ = write!(out, "start: {}, length: {}, order: Order::{order}, ", signal.start, signal.length);
    let _ =
        write!(out, "signed: {}, scale: Scale {{ mul: {mul}, add: {add}, den: {den} }}, ", signal.signed());
    let _ =
        write!(out, "unit: {:?}, range: {:?}, start_raw: {}, ", signal.unit, signal.range, signal.start_raw);
    let _ = write!(out, "invalid_raw: {:?}, mux: {mux}, life: {life}, ", signal.invalid_raw);
    let _ = writeln!(out, "values: &[{}] }},", values.join(", "));
}

/// Writes identifiers, types, accessors and the table of all messages.
///
/// Messages that differ only in identifier and cycle share their type and their signals.
pub(crate) fn write(out: &mut String, network: &Network) {
    out.push_str("\n/// Identifiers.\npub mod id {\n    use crate::frame::CanId;\n\n");
    for message in network.messages.iter().filter(|message| message.doubt.is_none()) {
        let name = message.function.to_uppercase();
        let _ = writeln!(
            out,
            "    /// {}.\n    pub const {name}: CanId = {};",
            message.name,
            id_text(message.id)
        );
    }
    out.push_str("}\n");
    let layout = |index: usize| {
        let message = &network.messages[index];
        let same = |other: &&Message| {
            other.doubt.is_none()
                && other.signals == message.signals
                && other.fill == message.fill
                && other.len == message.len
        };
        network.messages[..index].iter().find(same)
    };
    let layouts: Vec<Option<&Message>> = (0..network.messages.len()).map(layout).collect();
    let all = || network.messages.iter().zip(&layouts).filter(|(message, _)| message.doubt.is_none());
    for (message, like) in all() {
        write_message(out, message, *like);
    }
    for (message, _) in all().filter(|(_, like)| like.is_none()) {
        write_accessors(out, message);
    }
    for (message, _) in all().filter(|(_, like)| like.is_none()) {
        let _ = writeln!(out, "\nstatic {}: &[SignalInfo] = &[", table_name(message));
        for signal in message.signals.iter().filter(|signal| signal.has_row(message)) {
            write_signal_info(out, message, signal);
        }
        out.push_str("];\n");
    }
    let _ = writeln!(out, "\n/// Every message of the vehicle, in the order of the DBC: for tools.");
    let _ = writeln!(out, "pub static MESSAGES: &[MessageInfo] = &[");
    for (message, like) in all() {
        write_info(out, message, like.unwrap_or(message));
    }
    out.push_str("];\n");
}
