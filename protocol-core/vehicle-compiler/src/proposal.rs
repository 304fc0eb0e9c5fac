//! A first `vehicle.toml` for a DBC file: bindings proposed by name and unit.
//!
//! Proposes only what the file bears out: a name that says the value, and a unit that measures it or states whose words
//! are known. What is proposed is a guess by words, and stands in the file with the comment of the signal for a person to
//! read. Values of which several signals are as good get the first in the order of the file.

use crate::binding::{NOBODY, scale_of};
use crate::diagnostics::Diagnostics;
use crate::encoding;
use crate::gate;
use crate::meaning::{counts_per, states};
use crate::network::{Message, Network, Signal};
use crate::number;
use crate::ratio::Ratio;
use crate::spelling;
use protocol_core::model::{Unit, Value};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// A vehicle as it is proposed.
pub struct Proposal {
    /// Text of the DBC file, UTF-8.
    pub dbc: String,
    /// Text of `vehicle.toml`.
    pub toml: String,
    /// What is bound: value, message, signal.
    pub bound: Vec<(Value, String, String)>,
    /// How the file was read, if it is not UTF-8.
    pub note: Option<String>,
}

type Lists = &'static [&'static [&'static str]];

/// The commonest values, with words of the names of their signals: all words of one list must be in the name, none of
/// the second. The order of the lists is that of trust.
const COMMON: [(Value, Lists, &[&str]); 10] = [
    (
        Value::VehicleSpeed,
        &[
            &["vehicle", "speed"],
            &["veh", "spd"],
            &["vehicle", "spd"],
            &["car", "speed"],
            &["road", "speed"],
            &["speed"],
            &["spd"],
        ],
        &[
            "motor", "engine", "eng", "wheel", "whl", "fan", "wiper", "limit", "set", "target", "cruise",
            "turbine", "trans", "input", "output", "shaft", "mot", "pump", "blower", "raw", "valid", "qf",
            "ctr", "cc", "acc", "unit", "lead",
        ],
    ),
    (
        Value::BatterySoc,
        &[&["soc"], &["state", "charge"], &["charge", "level"]],
        &["min", "max", "target", "valid", "limit", "12v", "lv"],
    ),
    (
        Value::BatteryVoltage,
        &[
            &["battery", "voltage"],
            &["batt", "volt"],
            &["pack", "volt"],
            &["hv", "volt"],
            &["pack", "voltage"],
        ],
        &["cell", "max", "min", "12", "lv", "limit", "target", "aux", "sys", "system", "crank"],
    ),
    (
        Value::BatteryCurrent,
        &[&["battery", "current"], &["batt", "current"], &["pack", "current"], &["hv", "current"]],
        &["max", "min", "limit", "12", "lv", "target", "aux"],
    ),
    (
        Value::BatteryTemperatureMax,
        &[&["battery", "temp", "max"], &["batt", "temp"], &["battery", "temp"], &["pack", "temp"]],
        &["min", "coolant", "target", "inlet", "outlet"],
    ),
    (
        Value::MotorSpeed,
        &[
            &["motor", "speed"],
            &["motor", "rpm"],
            &["mot", "rpm"],
            &["engine", "rpm"],
            &["eng", "rpm"],
            &["engine", "speed"],
            &["eng", "spd"],
            &["rpm"],
        ],
        &["target", "limit", "wheel", "fan", "idle", "min", "max", "set"],
    ),
    (Value::MotorTemperature, &[&["motor", "temp"], &["mot", "temp"]], &["limit", "target"]),
    (Value::VehicleOdometer, &[&["odometer"], &["odo"], &["total", "distance"]], &["trip", "mode"]),
    (
        Value::VehicleAccelerator,
        &[
            &["accelerator"],
            &["accel", "pedal"],
            &["acc", "pedal"],
            &["throttle"],
            &["pedal", "gas"],
            &["gas", "pedal"],
        ],
        &["long", "lateral", "state", "press", "error", "valid", "ctr", "brake"],
    ),
    (
        Value::VehicleGear,
        &[&["gear"], &["shift", "position"], &["prnd"]],
        &["target", "request", "req", "ratio", "box"],
    ),
];

/// Reads a DBC file and proposes its vehicle.
///
/// # Errors
/// If it is no DBC file.
pub fn of_file(path: &Path, name: &str) -> Result<Proposal, Diagnostics> {
    let file = path.display().to_string();
    let bytes = std::fs::read(path)
        .map_err(|error| Diagnostics::one(&file, 0, format!("cannot be read: {error}")))?;
    let read = encoding::read(&file, bytes)?;
    let network = gate::read(&file, &read.text)?.network;
    let found = found(&network);
    let toml = text(name, &network, &found);
    let bound = found
        .iter()
        .map(|found| {
            let message = &network.messages[found.message];
            (found.value, message.name.clone(), message.signals[found.signal].name.clone())
        })
        .collect();
    Ok(Proposal { dbc: read.text, toml, bound, note: read.note })
}

/// One proposed binding.
struct Found {
    value: Value,
    message: usize,
    signal: usize,
    /// Words of the value table that the model does not know.
    unknown: Vec<String>,
}

fn found(network: &Network) -> Vec<Found> {
    let mut found = Vec::new();
    for (value, lists, not) in COMMON {
        let best = lists.iter().find_map(|list| {
            let fits = |signal: &Signal| fits(value, signal, list, not);
            network
                .messages
                .iter()
                .enumerate()
                .filter(|(_, message)| message.doubt.is_none())
                .find_map(|(index, message)| Some((index, message.signals.iter().position(fits)?)))
        });
        let Some((message, signal)) = best else { continue };
        let words = &network.messages[message].signals[signal].values;
        let known = states(value.unit());
        let unknown =
            words.iter().map(|(_, word)| word).filter(|word| known.iter().all(|state| state.word != **word));
        let mut unknown: Vec<String> = unknown.cloned().collect();
        unknown.sort();
        unknown.dedup();
        found.push(Found { value, message, signal, unknown });
    }
    found
}

/// Returns whether a signal can be the value: by its name, and by its unit or its words.
fn fits(value: Value, signal: &Signal, words: &[&str], not: &[&str]) -> bool {
    let name = spaced(&signal.name);
    let parts: Vec<&str> = name.split('_').collect();
    // Words of three letters and less are whole parts of the name, longer ones may stand anywhere in it.
    let has = |word: &&str| if word.len() <= 3 { parts.contains(word) } else { name.contains(word) };
    if signal.doubt.is_some()
        || signal.is_selector
        || !words.iter().all(has)
        || not.iter().any(|word| parts.contains(word))
    {
        return false;
    }
    let is_state = value.unit().kind().is_some();
    let words_are_known = || {
        let known = states(value.unit());
        let of_state = |(_, word): &&(i64, String)| known.iter().any(|state| state.word == word);
        signal.values.iter().filter(of_state).count() >= 2 && !signal.number.is_float()
    };
    let measures = || {
        let fits = |unit| scale_of(value, signal, unit).is_some();
        value.unit() != Unit::Count && unit_of(signal).is_some_and(fits)
    };
    if is_state { words_are_known() } else { signal.length > 1 && measures() }
}

/// Returns the unit of a signal as the model writes it, and how many of it one is.
fn unit_of(signal: &Signal) -> Option<(&'static str, Ratio)> {
    spelling::unit(&signal.unit)
}

/// Returns a name in small letters with `_` between its words.
fn spaced(name: &str) -> String {
    crate::names::function_name(name)
}

fn text(name: &str, network: &Network, found: &[Found]) -> String {
    let mut out = String::from("# Proposed by names and units: read every line.\n\n[vehicle]\n");
    let _ = writeln!(out, "zh = {name:?}\nen = {name:?}\nshipped = false");
    if network.bitrate.is_none() {
        let _ = writeln!(out, "# The DBC does not say it: check.\nbitrate = 500000");
    }
    let mut messages: BTreeMap<usize, Vec<&Found>> = BTreeMap::new();
    found.iter().for_each(|found| messages.entry(found.message).or_default().push(found));
    let sender = |message: &Message| {
        if message.sender.is_empty() { NOBODY.to_owned() } else { message.sender.clone() }
    };
    let mut senders: Vec<String> = messages.keys().map(|index| sender(&network.messages[*index])).collect();
    senders.sort();
    senders.dedup();
    if let Some((first, others)) = senders.split_first() {
        let also: Vec<String> = others.iter().map(|other| format!("{other:?}")).collect();
        let also = if also.is_empty() { String::new() } else { format!(", also = [{}]", also.join(", ")) };
        let _ =
            writeln!(out, "\n[nodes]\n{first} = {{ node = \"vcu\", zh = \"整车\", en = \"Vehicle\"{also} }}");
    }
    for (index, found) in messages {
        let message = &network.messages[index];
        let _ = writeln!(out, "\n[rx.{}]", message.name);
        if message.slow_cycle_ms == 0 {
            let _ = writeln!(out, "timeout_ms = 1000");
        }
        for found in found {
            let signal = &message.signals[found.signal];
            let path = found.value.path();
            if found.value.unit().kind().is_none() {
                let _ = writeln!(out, "{path} = {}", measured(found.value, signal));
                continue;
            }
            if found.unknown.is_empty() {
                let _ = writeln!(out, "{path} = {:?}", signal.name);
                continue;
            }
            let map: Vec<String> =
                found.unknown.iter().map(|word| format!("{word:?} = \"invalid\"")).collect();
            let _ =
                writeln!(out, "{path} = {{ signal = {:?}, map = {{ {} }} }}", signal.name, map.join(", "));
        }
    }
    out
}

/// Returns the binding of a quantity: the signal, and what the DBC says in other words or in another unit.
fn measured(value: Value, signal: &Signal) -> String {
    let name = &signal.name;
    match unit_of(signal) {
        Some((unit, times)) if counts_per(value.unit(), &signal.unit).is_none() => {
            let said =
                |of: Ratio| of.checked_mul(times).and_then(number::plain).unwrap_or_else(|| "0".into());
            let scale = match times == Ratio::whole(1) {
                true => String::new(),
                false => format!(", factor = {}, offset = {}", said(signal.factor), said(signal.offset)),
            };
            format!("{{ signal = {name:?}, unit = {unit:?}{scale} }}")
        }
        _ => format!("{name:?}"),
    }
}
