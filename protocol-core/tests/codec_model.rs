//! Every plain line `path = "signal"` of every `vehicle.toml`, over all raw values of up to 16 bits.
//!
//! What the decoder stores must be the signal's physical value in the unit of the path, rounded down. The lines are read
//! here by plain text search and the units by a table of their own, not by the compiler.

mod fleet;

use fleet::fleet;
use protocol_core::codec::{MessageInfo, Mux, SignalInfo};
use protocol_core::model::{Reading, Readings, Unit, Value};
use protocol_core::vehicle::Vehicle;
use protocol_core::{checksum, codec, frame, model, stream, vehicle};

/// Returns how many model counts one unit of the DBC is, as a fraction; `None` for states.
fn counts(unit: Unit, dbc: &str) -> Option<(i64, i64)> {
    Some(match (unit, dbc) {
        (Unit::Count, _) => (1, 1),
        (Unit::Kmh256, "km/h") => (256, 1),
        (Unit::Km8, "km") => (8, 1),
        (Unit::Permille, "%") | (Unit::Decivolt, "V") | (Unit::Deciamp, "A") => (10, 1),
        (Unit::DeciNm, "Nm" | "N.m") => (10, 1),
        (Unit::Decivolt, "mV") => (1, 100),
        (Unit::Millivolt, "mV") => (1, 1),
        (Unit::Millivolt, "V") => (1_000, 1),
        (Unit::Rpm, "rpm" | "r/min") | (Unit::Celsius, "°C" | "degC") => (1, 1),
        (Unit::Kiloohm, "kohm" | "kOhm" | "kΩ")
        | (Unit::Ah, "Ah")
        | (Unit::Hertz, "Hz")
        | (Unit::Day, "d") => (1, 1),
        (Unit::Watt, "W") | (Unit::Kilopascal, "kPa") => (1, 1),
        (Unit::Watt, "kW") | (Unit::Kilopascal, "MPa") => (1_000, 1),
        (Unit::Kilopascal, "bar" | "Bar") | (Unit::CentiMpa, "MPa") => (100, 1),
        (Unit::CentiMpa, "bar" | "Bar") => (10, 1),
        (Unit::CentiMpa, "kPa") => (1, 10),
        (
            Unit::Kmh256
            | Unit::Km8
            | Unit::Permille
            | Unit::Decivolt
            | Unit::Millivolt
            | Unit::Deciamp
            | Unit::DeciNm
            | Unit::Rpm
            | Unit::Celsius
            | Unit::Kiloohm
            | Unit::Ah
            | Unit::Watt
            | Unit::Hertz
            | Unit::Day
            | Unit::Kilopascal
            | Unit::CentiMpa,
            _,
        ) => panic!("no value of the model in {unit:?} comes in \"{dbc}\""),
        _ => return None,
    })
}

fn expected(signal: &SignalInfo, unit: Unit, raw: i64, magnitude: bool) -> Option<Option<i32>> {
    let Some((num, den)) = counts(unit, signal.unit) else {
        let one_bit = unit == Unit::Flag && signal.length == 1;
        return one_bit.then_some(Some(raw as i32));
    };
    Some(signal.physical(raw).map(|physical| {
        let number = (physical * num).div_euclid(den * i64::from(signal.scale.den));
        let number = i32::try_from(number).expect("a model number");
        if magnitude { number.abs() } else { number }
    }))
}

/// Returns how many raw values were compared for one line; 0 = not a plain one.
fn compare(vehicle: &Vehicle, message: &MessageInfo, path: &str, text: &str, filler: &[u8]) -> u64 {
    let magnitude = text.contains("magnitude = true");
    let name = match text.strip_prefix("{ signal = \"") {
        Some(rest) if magnitude => rest.split('"').next(),
        _ => text.strip_prefix('"').and_then(|rest| rest.split('"').next()),
    };
    let Some(value) = Value::from_path(path) else { return 0 };
    let (Some(name), Some(index)) = (name, vehicle.index_of(message.id)) else { return 0 };
    let signal = message.signal(name).expect("a signal of the message");
    let selector = message.signals.iter().find(|signal| signal.mux == Mux::Selector);
    let mut met = 0;
    for raw in 0..1i64 << signal.length.min(16) {
        let mut data = [0x5A; 8];
        if let (Mux::When(page), Some(selector)) = (signal.mux, selector) {
            selector.set_raw(&mut data, i64::from(page));
        }
        signal.set_raw(&mut data, raw);
        if let (Mux::When(page), Some(selector)) = (signal.mux, selector) {
            untouched_by_other_pages(vehicle, index, data, (selector, page), value);
        }
        let mut readings = Readings::new();
        (vehicle.decode)(index, &data, &mut readings);
        let read = match readings.get(value) {
            Some((Reading::Valid(number), source)) if source == index => Some(number),
            Some((Reading::Invalid, source)) if source == index => None,
            other => panic!("{path} is not stored by {}: {other:?}", message.name),
        };
        let Some(expected) = expected(signal, value.unit(), signal.raw(&data), magnitude) else { return 0 };
        let mut emptied = data;
        signal.set_raw(&mut emptied, !raw);
        let holds_filler =
            data.iter().zip(emptied).any(|(byte, other)| *byte != other && filler.contains(byte));
        if !(holds_filler && read.is_none()) {
            assert_eq!(read, expected, "{}: {path} from {}.{name}, raw {raw}", vehicle.name, message.name);
        }
        met += 1;
    }
    met
}

/// A multiplexed value is read from its own page only.
fn untouched_by_other_pages(
    vehicle: &Vehicle,
    index: u8,
    data: [u8; 8],
    (selector, page): (&SignalInfo, u32),
    value: Value,
) {
    for other in (0..1i64 << selector.length.min(8)).filter(|other| *other != i64::from(page)) {
        let mut data = data;
        selector.set_raw(&mut data, other);
        let mut readings = Readings::new();
        (vehicle.decode)(index, &data, &mut readings);
        assert_eq!(readings.get(value), None, "{} in page {other} of {}", value.path(), vehicle.name);
    }
}

#[test]
fn every_plainly_bound_value_is_the_physical_value_in_the_models_unit() {
    let (mut lines, mut values) = (0, 0);
    for car in fleet() {
        let (vehicle, messages, text) = (car.vehicle, car.messages, car.binding());
        let mut message = None;
        // `filler = [0xFF, 0xFE]`: what such a byte says is nothing.
        let list = text.lines().find_map(|line| line.strip_prefix("filler = [")?.split_once(']'));
        let hex = |byte: &str| u8::from_str_radix(byte.trim().strip_prefix("0x")?, 16).ok();
        let filler: Vec<u8> = list.map_or(Vec::new(), |(list, _)| list.split(',').filter_map(hex).collect());
        for line in text.lines() {
            if let Some(section) = line.strip_prefix('[').and_then(|rest| rest.split(']').next()) {
                let name = section.strip_prefix("rx.");
                message = messages.iter().find(|message| Some(message.name) == name);
            }
            if let (Some(message), Some((path, text))) = (message, line.split_once(" = ")) {
                let met = compare(vehicle, message, path, text, &filler);
                lines += u64::from(met > 0);
                values += met;
            }
        }
    }
    println!("{lines} lines, {values} raw values");
    assert!(lines > 120 && values > 1_000_000, "only {lines} lines with {values} raw values were met");
}
