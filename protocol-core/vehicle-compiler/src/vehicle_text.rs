//! Rust text of the vehicle: tables of received and sent messages, the decoder and the encoder of model values.

use crate::binding::{BOUND, Binding, How, HowBack, Rx, RxValue, States, StreamRow, Term, Tx, TxSignal};
use crate::codec_text::{counts, id_text, validity, width};
use crate::meaning::variant;
use crate::network::{Condition, Message, Network, Signal};
use crate::one_line;
use crate::ratio::Linear;
use protocol_core::checksum::Checksum;
use protocol_core::model::{Severity, Unit};
use protocol_core::vehicle::{Node, Rules};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

fn life_text(message: &Message) -> String {
    let segment = message.life().map(|signal| signal.segments()[0]);
    match segment {
        None => "None".into(),
        Some(segment) => {
            let mask = ((1u16 << segment.bits) - 1) << segment.low;
            format!("Some(Life {{ byte: {}, mask: 0x{mask:02X} }})", segment.byte)
        }
    }
}

fn checksum_text(checksum: Option<Checksum>) -> String {
    checksum.map_or("None".into(), |Checksum { byte, len, kind }| {
        format!("Some(Checksum {{ byte: {byte}, len: {len}, kind: ChecksumKind::{kind:?} }})")
    })
}

fn write_streams(out: &mut String, network: &Network, binding: &Binding) {
    let _ = writeln!(out, "\nstatic STREAMS: &[Stream] = &[");
    for stream in &binding.streams {
        let StreamRow { name, frames, step, zeros_pad, start, size, valid, scale, .. } = stream;
        let message = &network.messages[stream.first];
        let row = binding.rx.iter().position(|rx| rx.message == stream.first).unwrap_or(usize::MAX);
        let cells: Vec<String> = stream
            .cells
            .iter()
            .map(|(number, value)| format!("Cell {{ number: {number:?}, value: {value} }}"))
            .collect();
        let bound: Vec<String> = BOUND
            .iter()
            .zip(&stream.bound)
            .map(|(field, value)| match value {
                Some(value) => format!("{field}: Some(Value::{})", variant(*value)),
                None => format!("{field}: None"),
            })
            .collect();
        let Linear { mul, add, den } = scale;
        let _ = write!(out, "    Stream {{ name: {name:?}, row: {row}, first: {}, ", id_text(message.id));
        let _ = write!(out, "step: {step}, frames: {frames}, len: {}, zeros_pad: {zeros_pad}, ", message.len);
        let _ = writeln!(out, "start: {start}, size: {size}, valid: {valid:?},");
        let _ = writeln!(out, "        scale: Scale {{ mul: {mul}, add: {add}, den: {den} }},");
        let _ = writeln!(out, "        cells: &[{}],", cells.join(", "));
        let _ = writeln!(out, "        bound: Bound {{ {} }} }},", bound.join(", "));
    }
    out.push_str("];\n");
}

/// Writes the identifiers of all messages that the cluster does not send itself.
fn write_ids(out: &mut String, network: &Network, binding: &Binding) {
    let own = binding.nodes.iter().find(|row| row.node == Node::Cluster).map(|row| row.dbc.as_str());
    let sure = network.messages.iter().filter(|message| message.doubt.is_none());
    let others = sure.filter(|message| Some(message.sender.as_str()) != own);
    let mut ids: Vec<u32> = others.map(|message| message.id).collect();
    ids.sort_unstable();
    let _ = writeln!(out, "\nstatic IDS: &[CanId] = &[");
    for id in ids {
        let _ = writeln!(out, "    {},", id_text(id));
    }
    out.push_str("];\n");
}

fn write_rows(out: &mut String, network: &Network, binding: &Binding) {
    let _ = writeln!(out, "\nstatic RX: &[RxMessage] = &[");
    for rx in &binding.rx {
        let message = &network.messages[rx.message];
        let _ = write!(out, "    RxMessage {{ id: {}, name: {:?}, ", id_text(message.id), message.name);
        let _ = write!(
            out,
            "node: Node::{:?}, len: {}, cycle_ms: {}, timeout_ms: {}, ",
            rx.node, rx.len, rx.cycle_ms, rx.timeout_ms
        );
        let (life, checksum) = (life_text(message), checksum_text(rx.checksum));
        let _ = writeln!(
            out,
            "life: {life}, checksum: {checksum}, expected: {}, vital: {} }},",
            rx.expected, rx.vital
        );
    }
    let _ = writeln!(out, "];\n\nstatic TX: &[TxMessage] = &[");
    for tx in &binding.tx {
        let message = &network.messages[tx.message];
        let _ = write!(out, "    TxMessage {{ id: {}, name: {:?}, ", id_text(message.id), message.name);
        let (life, checksum) = (life_text(message), checksum_text(tx.checksum));
        let _ = writeln!(out, "cycle_ms: {}, life: {life}, checksum: {checksum} }},", tx.cycle_ms);
    }
    let _ = writeln!(out, "];\n\n/// Texts of the fault codes, sorted by source and code.");
    let _ = writeln!(out, "pub static FAULTS: &[FaultText] = &[");
    for fault in &binding.faults {
        let severity = match fault.severity {
            None => "None",
            Some(Severity::None | Severity::Warn) => "Some(Severity::Warn)",
            Some(Severity::Derate) => "Some(Severity::Derate)",
            Some(Severity::Stop) => "Some(Severity::Stop)",
        };
        let _ = writeln!(
            out,
            "    FaultText {{ source: Node::{:?}, code: {}, severity: {severity}, fire: {}, limps: {}, zh: {:?}, en: {:?} }},",
            fault.source, fault.code, fault.fire, fault.limps, fault.zh, fault.en
        );
    }
    let _ = writeln!(out, "];\n\nstatic NODES: &[NodeName] = &[");
    for row in &binding.nodes {
        let _ = writeln!(
            out,
            "    NodeName {{ node: Node::{:?}, zh: {:?}, en: {:?} }},",
            row.node, row.zh, row.en
        );
    }
    out.push_str("];\n");
}

/// Rounds `numerator / den` as Rust text.
fn divided(numerator: &str, den: i64, nearest: bool) -> String {
    match (den, nearest) {
        (1, _) => numerator.into(),
        (den, false) if den.count_ones() == 1 => format!("({numerator}) >> {}", den.trailing_zeros()),
        (den, false) => format!("codec::floor_div({numerator}, {den})"),
        (den, true) => format!("codec::nearest_div({numerator}, {den})"),
    }
}

/// Whether every step of the scale fits in 32 bits for every raw value, valid or not.
fn fits(linear: Linear, signal: &Signal, nearest: bool) -> bool {
    let spare = if nearest { linear.den / 2 } else { 0 };
    let step = |raw: i128| {
        let product = raw * i128::from(linear.mul);
        let sum = product + i128::from(linear.add);
        let all = [product, sum, sum + i128::from(spare)];
        all.iter().all(|number| i32::try_from(*number).is_ok())
    };
    step(signal.span().0) && step(signal.span().1)
}

/// State tables of a vehicle by their Rust text; equal ones are one table.
#[derive(Default)]
struct Tables(BTreeMap<String, usize>);

impl Tables {
    /// Returns the state of a raw value as an expression; `INVALID` where there is none.
    fn state(&mut self, states: &States, other: Option<i32>, signal: &Signal, raw: &str) -> String {
        let text = |state: Option<i32>| state.map_or("INVALID".to_string(), |state| state.to_string());
        let (lowest, highest) = signal.span();
        if lowest == 0 && highest <= 15 {
            let highest = highest as i64;
            let cells = (0..=highest).map(|raw| text(states.get(&raw).copied().unwrap_or(other)));
            let table = format!("[i32; {}] = [{}]", highest + 1, cells.collect::<Vec<_>>().join(", "));
            let next = self.0.len();
            let number = *self.0.entry(table).or_insert(next);
            return format!("STATES_{number}[({raw} & {highest}) as usize]");
        }
        let arms: Vec<String> =
            states.iter().map(|(raw, state)| format!("{raw} => {}", text(*state))).collect();
        format!("match {raw} {{ {}, _ => {} }}", arms.join(", "), text(other))
    }

    fn write(&self, out: &mut String) {
        let mut tables: Vec<(&usize, &String)> =
            self.0.iter().map(|(table, number)| (number, table)).collect();
        tables.sort();
        for (number, table) in tables {
            let _ = writeln!(out, "\nstatic STATES_{number}: {table};");
        }
    }
}

/// Returns the last raw value if states are the raw values 0 to that one.
fn identity(states: &States, other: Option<i32>) -> Option<i64> {
    let same = states
        .iter()
        .enumerate()
        .all(|(index, (raw, state))| *raw == index as i64 && state.map(i64::from) == Some(*raw));
    states.keys().next_back().copied().filter(|_| same && other.is_none())
}

/// Returns the single bit of a flag that is simply sent as 0 or 1: byte and mask.
fn plain_bit(term: &Term, message: &Message) -> Option<(u8, u8)> {
    let signal = &message.signals[term.signal];
    let How::Mapped { states, other } = &term.how else { return None };
    let segment = signal.segments()[0];
    (signal.length == 1 && identity(states, *other) == Some(1)).then_some((segment.byte, 1 << segment.low))
}

/// Returns bits of several signals as one number: neighbours move together.
fn gathered(value: &RxValue, message: &Message, filler: &[u8]) -> String {
    let mut runs: BTreeMap<(u8, i16), u8> = BTreeMap::new();
    let mut parts = Vec::new();
    for (index, term) in value.terms.iter().enumerate() {
        let signal = &message.signals[term.signal];
        if let How::Mapped { states, other: Some(0) } = &term.how {
            let raws: Vec<String> = states.keys().map(i64::to_string).collect();
            let is_set = format!("matches!(frame.{}_raw(), {})", signal.function, raws.join(" | "));
            parts.push(format!("({is_set} as i32) << {index}"));
            continue;
        }
        let segment = signal.segments()[0];
        *runs.entry((segment.byte, index as i16 - i16::from(segment.low))).or_default() |= 1 << segment.low;
    }
    let run = |((byte, shift), mask): (&(u8, i16), &u8)| {
        let part = match mask {
            0xFF => format!("frame.0[{byte}] as i32"),
            mask => format!("(frame.0[{byte}] & 0x{mask:02X}) as i32"),
        };
        let part = match filler {
            [] => part,
            filler => format!("if {} {{ 0 }} else {{ {part} }}", is_filler(*byte, filler)),
        };
        match shift {
            0 => part,
            1.. => format!("({part}) << {shift}"),
            ..0 => format!("({part}) >> {}", -shift),
        }
    };
    parts.extend(runs.iter().map(run));
    parts.join(" | ")
}

/// Returns the bytes that hold bit fields of `terms`: whatever is filler in them is no bit.
pub(crate) fn field_bytes(terms: &[Term], message: &Message) -> BTreeSet<u8> {
    let is_field =
        |term: &&Term| message.signals[term.signal].length < 8 || matches!(term.how, How::Mapped { .. });
    let fields = terms.iter().filter(is_field);
    fields.flat_map(|term| message.signals[term.signal].segments()).map(|segment| segment.byte).collect()
}

/// Returns the condition that a byte is filler.
fn is_filler(byte: u8, filler: &[u8]) -> String {
    let values: Vec<String> = filler.iter().map(|value| format!("0x{value:02X}")).collect();
    format!("matches!(frame.0[{byte}], {})", values.join(" | "))
}

/// Returns the condition that one of the bytes is filler.
fn is_any_filler(bytes: &BTreeSet<u8>, filler: &[u8]) -> String {
    bytes.iter().map(|byte| is_filler(*byte, filler)).collect::<Vec<_>>().join(" || ")
}

/// Writes a value of the frame. Bit fields in a byte of filler say nothing; of several, one that reports something stands
/// although others are filler, and none of them is then known to be well.
fn write_value(out: &mut String, tables: &mut Tables, message: &Message, value: &RxValue, filler: &[u8]) {
    let target = format!("source, Value::{}", variant(value.value));
    let bytes = field_bytes(&value.terms, message);
    if filler.is_empty() || bytes.is_empty() {
        return write_plain(out, tables, message, value, filler.contains(&0xFF));
    }
    let is_unknown = is_any_filler(&bytes, filler);
    if value.value.unit() == Unit::Bits {
        let _ = writeln!(out, "    let bits = {};", gathered(value, message, filler));
        let _ = writeln!(out, "    readings.put({target}, bits, bits != 0 || !({is_unknown}));");
    } else if bytes.len() > 1 && value.terms.len() > 1 {
        write_worst(out, tables, message, value, filler);
        let _ = writeln!(
            out,
            "    readings.put({target}, worst, worst > 0 || worst != INVALID && !({is_unknown}));"
        );
    } else {
        let mut plain = String::new();
        write_plain(&mut plain, tables, message, value, false);
        let _ = writeln!(
            out,
            "    if {is_unknown} {{\n        readings.put({target}, 0, false);\n    }} else {{"
        );
        for line in plain.lines() {
            let _ = writeln!(out, "    {line}");
        }
        out.push_str("    }\n");
    }
}

/// Writes the worst state of several signals; one whose byte is filler is no state.
fn write_worst(out: &mut String, tables: &mut Tables, message: &Message, value: &RxValue, filler: &[u8]) {
    for (index, term) in value.terms.iter().enumerate() {
        let signal = &message.signals[term.signal];
        let raw = format!("frame.{}_raw()", signal.function);
        let How::Mapped { states, other } = &term.how else { continue };
        let state = tables.state(states, *other, signal, &raw);
        let bytes = field_bytes(std::slice::from_ref(term), message);
        let state = match filler {
            [] => state,
            filler => format!("if {} {{ INVALID }} else {{ {state} }}", is_any_filler(&bytes, filler)),
        };
        let _ = match index {
            0 => writeln!(out, "    let worst = {state};"),
            _ => writeln!(out, "    let worst = i32::max(worst, {state});"),
        };
    }
}

/// Writes a value; `filled` tells that a number whose bytes are all 0xFF is not available.
fn write_plain(out: &mut String, tables: &mut Tables, message: &Message, value: &RxValue, filled: bool) {
    let target = format!("source, Value::{}", variant(value.value));
    if value.value.unit() == Unit::Bits {
        let _ = writeln!(out, "    readings.put({target}, {}, true);", gathered(value, message, &[]));
        return;
    }
    if let [term] = value.terms.as_slice() {
        let signal = &message.signals[term.signal];
        let raw = format!("frame.{}_raw()", signal.function);
        match &term.how {
            How::Float { linear: Linear { mul, add, den }, nearest, magnitude } => {
                let valid = validity(signal, "raw");
                let valid = if valid.is_empty() { String::new() } else { format!(" && {valid}") };
                let add = if *nearest { add + den / 2 } else { *add };
                let (bits, number) = (width(signal), if *magnitude { "number.abs()" } else { "number" });
                let _ = writeln!(out, "    let raw = {raw};");
                let _ =
                    writeln!(out, "    let number = codec::float{bits}_counts(raw, {mul}, {add}, {den});");
                let _ = writeln!(out, "    let valid = number != INVALID{valid};");
                let _ =
                    writeln!(out, "    readings.put({target}, if valid {{ {number} }} else {{ 0 }}, valid);");
            }
            How::Scaled { linear, nearest, magnitude, off } => {
                if *off > 0.0 {
                    let _ =
                        writeln!(out, "    // The factor as a short fraction: at most {off:.1e} counts off.");
                }
                let valid = validity(signal, "raw");
                let is_whole = signal.length.is_multiple_of(8) && !signal.signed();
                let valid = match valid.is_empty() {
                    false => valid,
                    true if filled && is_whole => format!("raw != {}", signal.span().1),
                    true => "true".into(),
                };
                let number = if fits(*linear, signal, *nearest) {
                    divided(&counts("raw", "i32", linear.mul, linear.add), linear.den, *nearest)
                } else {
                    // An invalid raw value of more than 32 bits may overflow; what comes of it is not used.
                    let wide = match signal.length {
                        0..=32 => counts("raw", "i64", linear.mul, linear.add),
                        _ => {
                            format!("(raw as i64).wrapping_mul({}).wrapping_add({})", linear.mul, linear.add)
                        }
                    };
                    let spare = if *nearest { format!(" + {}", linear.den / 2) } else { String::new() };
                    format!("({wide}{spare}).div_euclid({}) as i32", linear.den)
                };
                let number = if *magnitude { format!("({number}).abs()") } else { number };
                let _ = writeln!(out, "    let raw = {raw};");
                let _ = writeln!(out, "    readings.put({target}, {number}, {valid});");
            }
            How::Mapped { states, other } => match identity(states, *other) {
                Some(last) => {
                    let valid = match i128::from(last) == signal.span().1 {
                        true => "true".into(),
                        false => format!("raw <= {last}"),
                    };
                    let _ = writeln!(out, "    let raw = {raw};");
                    let _ = writeln!(out, "    readings.put({target}, raw as i32, {valid});");
                }
                None => {
                    let _ = writeln!(out, "    let state = {};", tables.state(states, *other, signal, &raw));
                    let _ = writeln!(out, "    readings.put({target}, state, state != INVALID);");
                }
            },
        }
        return;
    }
    let bits: Option<Vec<(u8, u8)>> = value.terms.iter().map(|term| plain_bit(term, message)).collect();
    if let (Some(bits), Unit::Flag) = (bits, value.value.unit()) {
        let mut masks = [0u8; 8];
        for (byte, mask) in bits {
            masks[usize::from(byte)] |= mask;
        }
        let terms: Vec<String> = masks
            .iter()
            .enumerate()
            .filter(|(_, mask)| **mask != 0)
            .map(|(byte, mask)| match mask {
                0xFF => format!("frame.0[{byte}]"),
                mask => format!("frame.0[{byte}] & 0x{mask:02X}"),
            })
            .collect();
        let _ = writeln!(out, "    let set = {} != 0;", joined(&terms));
        let _ = writeln!(out, "    readings.put({target}, set as i32, true);");
        return;
    }
    write_worst(out, tables, message, value, &[]);
    let _ = writeln!(out, "    readings.put({target}, worst, worst != INVALID);");
}

/// Writes the values that are always in the frame, then those of each multiplex value.
fn write_values(out: &mut String, tables: &mut Tables, message: &Message, values: &[RxValue], filler: &[u8]) {
    let mut pages: BTreeMap<&[Condition], Vec<&RxValue>> = BTreeMap::new();
    for value in values {
        pages.entry(value.when(message)).or_default().push(value);
    }
    for (when, values) in pages {
        let terms: Vec<String> = when.iter().map(|condition| condition_text(message, condition)).collect();
        if !terms.is_empty() {
            let _ = writeln!(out, "    if {} {{", terms.join(" && "));
        }
        for value in values {
            write_value(out, tables, message, value, filler);
        }
        if !terms.is_empty() {
            out.push_str("    }\n");
        }
    }
}

/// Returns whether a multiplexer is at one of the values as Rust text.
fn condition_text(message: &Message, condition: &Condition) -> String {
    let raw = format!("frame.{}_raw()", message.signals[condition.selector].function);
    // What the multiplexer never holds cannot stand in a pattern of its type.
    let (lowest, highest) = message.signals[condition.selector].span();
    let held = condition.ranges.iter().filter(|(first, last)| *last >= lowest && *first <= highest);
    let held: Vec<(i128, i128)> =
        held.map(|(first, last)| (*first.max(&lowest), *last.min(&highest))).collect();
    match held.as_slice() {
        [(first, last)] if first == last => format!("{raw} == {first}"),
        ranges => {
            let arms: Vec<String> = ranges.iter().map(|(first, last)| format!("{first}..={last}")).collect();
            format!("matches!({raw}, {})", arms.join(" | "))
        }
    }
}

fn joined(terms: &[String]) -> String {
    match terms {
        [one] => one.clone(),
        many => format!("({})", many.join(" | ")),
    }
}

fn write_decoder(out: &mut String, network: &Network, rx: &[Rx], filler: &[u8]) {
    let mut tables = Tables::default();
    for row in rx {
        let message = &network.messages[row.message];
        let name = &message.function;
        let unused = if row.values.is_empty() { "_" } else { "" };
        let _ = writeln!(
            out,
            "\nfn decode_{name}({unused}source: u8, {unused}data: &[u8; 8], {unused}readings: &mut Readings) {{"
        );
        if !row.values.is_empty() {
            let _ = writeln!(out, "    let frame = {}(*data);", message.type_name);
        }
        write_values(out, &mut tables, message, &row.values, filler);
        out.push_str("}\n");
    }
    tables.write(out);
    let _ = writeln!(out, "\nstatic DECODERS: [fn(u8, &[u8; 8], &mut Readings); {}] = [", rx.len());
    for row in rx {
        let _ = writeln!(out, "    decode_{},", &network.messages[row.message].function);
    }
    out.push_str("];\n\nfn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {\n");
    out.push_str("    if let Some(decode) = DECODERS.get(index as usize) {\n");
    out.push_str("        decode(index, data, readings);\n    }\n}\n");
}

fn write_encoder(out: &mut String, network: &Network, tx: &[Tx]) {
    for row in tx {
        let message = &network.messages[row.message];
        let _ = writeln!(out, "\nfn encode_{}(values: &Readings) -> [u8; 8] {{", message.function);
        let _ = writeln!(out, "    let frame = {}::new();", message.type_name);
        for (index, signal) in message.signals.iter().enumerate() {
            if signal.life.is_some() {
                continue;
            }
            let bound = row.signals.iter().find(|bound| bound.signal == index);
            let raw = match bound {
                Some(bound) => raw_text(bound, signal),
                None if signal.start_raw == 0 => continue,
                None => signal.start_raw.to_string(),
            };
            let _ = writeln!(out, "    let frame = frame.with_{}_raw({raw});", signal.function);
        }
        out.push_str("    frame.0\n}\n");
    }
    if tx.is_empty() {
        out.push_str("\nfn encode(_index: u8, _values: &Readings) -> [u8; 8] {\n    [0; 8]\n}\n");
        return;
    }
    let _ = writeln!(out, "\nfn encode(index: u8, values: &Readings) -> [u8; 8] {{\n    match index {{");
    for (index, row) in tx.iter().enumerate() {
        let name = &network.messages[row.message].function;
        let _ = writeln!(out, "        {index} => encode_{name}(values),");
    }
    out.push_str("        _ => [0; 8],\n    }\n}\n");
}

/// Returns the raw value that a model value is sent as.
fn raw_text(bound: &TxSignal, signal: &Signal) -> String {
    let kind = format!("{}{}", if signal.signed() { 'i' } else { 'u' }, width(signal));
    let known = format!("codec::known(values, Value::{})", variant(bound.value));
    let short = |raw: i128| raw.clamp(i64::MIN.into(), i64::MAX.into()) as i64;
    let (low, high) = (short(signal.range.0), short(signal.range.1));
    let scaled = |linear: Linear, low: i64, high: i64, nearest: bool| {
        let Linear { mul, add, den } = linear;
        let add = if nearest { add + den / 2 } else { add };
        format!("codec::scaled(number, {mul}, {add}, {den}, {low}, {high})")
    };
    let missing = bound.missing;
    match &bound.how {
        HowBack::Scaled { linear, nearest } => {
            let number = scaled(*linear, low, high, *nearest);
            format!("{known}.map_or({missing}, |number| {number} as {kind})")
        }
        HowBack::Part { linear, low, length } => {
            let number = scaled(*linear, 0, i64::from(u32::MAX), false);
            let mask = (1u64 << length) - 1;
            let shifted = if *low == 0 { number } else { format!("{number} >> {low}") };
            format!("{known}.map_or({missing}, |number| ({shifted} & 0x{mask:X}) as {kind})")
        }
        HowBack::Mapped(states)
            if bound.value.unit() == Unit::Flag && *states == BTreeMap::from([(0, 0), (1, 1)]) =>
        {
            format!("{known}.map_or({missing}, |state| (state != 0) as {kind})")
        }
        HowBack::Mapped(states) => {
            let arms: Vec<String> =
                states.iter().map(|(state, raw)| format!("Some({state}) => {raw}")).collect();
            format!("match {known} {{ {}, _ => {missing} }}", arms.join(", "))
        }
    }
}

/// Writes tables, decoder, encoder and the vehicle itself.
pub(crate) fn write(out: &mut String, name: &str, network: &Network, binding: &Binding) {
    write_rows(out, network, binding);
    write_streams(out, network, binding);
    write_ids(out, network, binding);
    write_decoder(out, network, &binding.rx, &binding.filler);
    write_encoder(out, network, &binding.tx);
    let _ = writeln!(out, "\n/// {} ({}).", one_line(&binding.en), one_line(&binding.zh));
    let _ = writeln!(out, "pub static VEHICLE: Vehicle = Vehicle {{");
    let _ = writeln!(out, "    name: {name:?},\n    zh: {:?},\n    en: {:?},", binding.zh, binding.en);
    let _ = writeln!(out, "    bitrate: {},\n    worst_level: {},", binding.bitrate, binding.worst_level);
    let rules = match binding.rules {
        Rules::NONE => "Rules::NONE".into(),
        rules => format!("{rules:?}"),
    };
    let _ = writeln!(out, "    rules: {rules},");
    out.push_str(
        "    rx: RX,\n    decode,\n    streams: STREAMS,\n    ids: IDS,\n    tx: TX,\n    encode,\n    faults: FAULTS,\n    nodes: NODES,\n};\n",
    );
}
