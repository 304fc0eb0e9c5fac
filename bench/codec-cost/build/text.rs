//! The decoders' text.

use crate::mix::Message;
use protocol_core::codec::{MessageInfo, SignalInfo};
use std::fmt::Write;

/// How a generator's users read a signal.
pub struct Manner {
    pub name: &'static str,
    /// The statement that makes `frame` out of `data`, for a type.
    frame: fn(&str) -> String,
    /// The expression of a signal's value.
    value: fn(&SignalInfo) -> String,
}

pub const MANNERS: &[Manner] = &[
    Manner { name: "empty", frame: |_| "let _ = data;".into(), value: |_| "0".into() },
    Manner { name: "ours", frame: our_frame, value: our_counts },
    Manner { name: "judged", frame: our_frame, value: our_judged },
    Manner { name: "codegen_float", frame: their_frame, value: their_physical },
    Manner { name: "codegen_raw", frame: their_frame, value: their_raw },
];

fn our_frame(name: &str) -> String {
    format!("let frame = citybus::{name}(*data);")
}

fn our_counts(signal: &SignalInfo) -> String {
    scaled(&format!("frame.{}_raw() as i32", signal.name), signal)
}

fn our_judged(signal: &SignalInfo) -> String {
    format!("frame.{}().unwrap_or(INVALID)", signal.name)
}

fn their_frame(name: &str) -> String {
    format!("let Ok(frame) = theirs::{name}::try_from(data.as_slice()) else {{ return }};")
}

fn their_physical(signal: &SignalInfo) -> String {
    match signal.values {
        [] => format!("frame.{}().counts({})", signal.name, signal.scale.den),
        // The getter gives an enumeration: the raw value is the number.
        _ => format!("frame.{}_raw_val() as i32", signal.name),
    }
}

fn their_raw(signal: &SignalInfo) -> String {
    scaled(&format!("frame.{}_raw_val() as i32", signal.name), signal)
}

/// Returns `raw * mul + add` without the parts that do nothing.
fn scaled(raw: &str, signal: &SignalInfo) -> String {
    let product =
        if signal.scale.mul == 1 { raw.to_string() } else { format!("({raw}) * {}", signal.scale.mul) };
    match signal.scale.add {
        0 => product,
        add => format!("{product} + ({add})"),
    }
}

/// `SteeringPump`, `BMSExtremes` and `VCU1` as a function: `steering_pump`, `bms_extremes`, `vcu1`.
fn function(name: &str) -> String {
    let letters: Vec<char> = name.chars().collect();
    let mut out = String::new();
    for (index, letter) in letters.iter().enumerate().filter(|(_, letter)| **letter != '_') {
        let before = index.checked_sub(1).map(|before| letters[before]);
        let after_small = before.is_some_and(|before| before.is_ascii_lowercase());
        let ends_capitals = before.is_some_and(|before| before.is_ascii_uppercase())
            && letters.get(index + 1).is_some_and(char::is_ascii_lowercase);
        if before == Some('_') || letter.is_ascii_uppercase() && (after_small || ends_capitals) {
            out.push('_');
        }
        out.push(letter.to_ascii_lowercase());
    }
    out
}

/// The same as a type: `SteeringPump`, `Vcu1`.
fn kind(name: &str) -> String {
    let word = |word: &str| word[..1].to_ascii_uppercase() + &word[1..];
    function(name).split('_').map(word).collect()
}

/// One decoder per message and their table.
pub fn rust(mix: &[Message], manner: &Manner) -> String {
    let mut out = String::new();
    for message in mix {
        let _ = writeln!(
            out,
            "extern \"C\" fn {}(data: &[u8; 8], values: &mut Values) {{",
            function(message.info.name)
        );
        let _ = writeln!(out, "    {}", (manner.frame)(&kind(message.info.name)));
        for (index, signal) in message.signals.iter().enumerate() {
            if manner.name == "empty" {
                let _ = writeln!(out, "    let _ = values;");
                break;
            }
            let _ = writeln!(out, "    values[{index}] = {};", (manner.value)(signal));
        }
        out.push_str("}\n\n");
    }
    let names: Vec<String> = mix.iter().map(|message| function(message.info.name)).collect();
    let _ = writeln!(out, "table!([{}]);", names.join(", "));
    out
}

/// The same in C, over cantools' unpack functions and structures.
pub fn c(mix: &[Message]) -> String {
    let mut out = String::from("#include \"bus.h\"\n");
    for message in mix {
        let name = function(message.info.name);
        let _ = writeln!(out, "\nvoid decode_{name}(const uint8_t *data, int32_t *values)\n{{");
        let _ = writeln!(out, "    struct bus_{name}_t frame;");
        let _ = writeln!(out, "    if (bus_{name}_unpack(&frame, data, 8) != 0) {{ return; }}");
        for (index, signal) in message.signals.iter().enumerate() {
            let raw = format!("(int32_t)frame.{}", signal.name);
            let _ = writeln!(out, "    values[{index}] = {};", scaled(&raw, signal));
        }
        out.push_str("}\n");
    }
    out
}

/// Names of the messages and their bound signals, a line each, and the declarations of the C functions.
pub fn summary(mix: &[Message]) -> String {
    let signals = |message: &Message| {
        message.signals.iter().map(|signal| format!(" {}", signal.name)).collect::<String>()
    };
    let lines: String =
        mix.iter().map(|message| format!("{}{}\n", message.info.name, signals(message))).collect();
    let most = mix.iter().map(|message| message.signals.len()).max().unwrap_or(0);
    let names: Vec<String> =
        mix.iter().map(|message| format!("decode_{}", function(message.info.name))).collect();
    let mut out = format!("pub const MESSAGES: usize = {};\n", mix.len());
    let _ = writeln!(out, "const _: () = assert!({most} <= MOST_VALUES, \"MOST_VALUES is too small\");");
    let _ = writeln!(out, "#[used]\n#[unsafe(link_section = \".mix\")]");
    let _ = writeln!(out, "static MIX: [u8; {}] = *b{lines:?};", lines.len());
    let _ = writeln!(out, "#[macro_export]\nmacro_rules! c_decoders {{\n    () => {{");
    let _ = writeln!(out, "        unsafe extern \"C\" {{");
    for name in &names {
        let _ = writeln!(out, "            safe fn {name}(data: &[u8; 8], values: &mut Values);");
    }
    let _ = writeln!(out, "        }}\n        table!([{}]);\n    }};\n}}", names.join(", "));
    out
}

/// A reader and a writer of every message of a vehicle, all its signals, bound or not.
pub fn every_message(vehicle: &str, messages: &[MessageInfo]) -> String {
    let mut out = format!(
        "mod {vehicle} {{\n    use super::*;\n    use protocol_core::generated::{vehicle} as theirs;\n"
    );
    let mut rows = Vec::new();
    let mut known = Vec::new();
    for message in messages.iter().filter(|message| !message.signals.is_empty()) {
        // Messages that differ only in their identifier share one codec.
        if known.contains(&message.signals.as_ptr()) {
            continue;
        }
        known.push(message.signals.as_ptr());
        let (name, kind, count) = (function(message.name), kind(message.name), message.signals.len());
        let _ = writeln!(out, "    fn read_{name}(data: &[u8; 8], values: &mut Every) {{");
        let _ = writeln!(out, "        let frame = theirs::{kind}(*data);");
        for (index, signal) in message.signals.iter().enumerate() {
            let name = function(signal.name);
            let _ = writeln!(
                out,
                "        values[{index}] = frame.{name}().map_or(INVALID, |value| value as i32);"
            );
        }
        let _ = writeln!(out, "    }}\n    fn write_{name}(values: &Every) -> [u8; 8] {{");
        let _ = writeln!(out, "        const _: () = assert!({count} <= MOST_SIGNALS);");
        let _ = writeln!(out, "        let frame = theirs::{kind}::new();");
        for (index, signal) in message.signals.iter().enumerate() {
            let _ = writeln!(
                out,
                "        let frame = frame.with_{}_raw(values[{index}] as _);",
                function(signal.name)
            );
        }
        let _ = writeln!(out, "        frame.0\n    }}");
        rows.push(format!("(read_{name}, write_{name})"));
    }
    let _ = writeln!(out, "    pub static ROWS: [Codec; {}] = [{}];\n}}", rows.len(), rows.join(", "));
    out
}
