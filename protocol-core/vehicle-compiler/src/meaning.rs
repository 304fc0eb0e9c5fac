//! What model values count in: physical units as fractions, states by the rows of the model.

use crate::ratio::Ratio;
use protocol_core::checksum::ChecksumKind;
use protocol_core::model::{Unit, Value};
use protocol_core::states::State;
use protocol_core::vehicle::Node;

/// Units of a DBC by what they measure: how many counts of the model one of them is, as a fraction.
const UNITS: [(Unit, &str, i128, i128); 30] = [
    (Unit::Kmh256, "km/h", 256, 1),
    (Unit::Km8, "km", 8, 1),
    (Unit::Permille, "%", 10, 1),
    (Unit::Decivolt, "V", 10, 1),
    (Unit::Decivolt, "mV", 1, 100),
    (Unit::Millivolt, "mV", 1, 1),
    (Unit::Millivolt, "V", 1000, 1),
    (Unit::Deciamp, "A", 10, 1),
    (Unit::DeciNm, "Nm", 10, 1),
    (Unit::DeciNm, "N.m", 10, 1),
    (Unit::Rpm, "rpm", 1, 1),
    (Unit::Rpm, "r/min", 1, 1),
    (Unit::Celsius, "°C", 1, 1),
    (Unit::Celsius, "degC", 1, 1),
    (Unit::Kiloohm, "kohm", 1, 1),
    (Unit::Kiloohm, "kOhm", 1, 1),
    (Unit::Kiloohm, "kΩ", 1, 1),
    (Unit::Ah, "Ah", 1, 1),
    (Unit::CentiMpa, "MPa", 100, 1),
    (Unit::CentiMpa, "bar", 10, 1),
    (Unit::CentiMpa, "Bar", 10, 1),
    (Unit::CentiMpa, "kPa", 1, 10),
    (Unit::Kilopascal, "kPa", 1, 1),
    (Unit::Kilopascal, "bar", 100, 1),
    (Unit::Kilopascal, "Bar", 100, 1),
    (Unit::Kilopascal, "MPa", 1000, 1),
    (Unit::Watt, "W", 1, 1),
    (Unit::Watt, "kW", 1000, 1),
    (Unit::Hertz, "Hz", 1, 1),
    (Unit::Day, "d", 1, 1),
];

/// Returns how many counts of `unit` one `dbc_unit` is, `None` if they do not measure the same thing.
pub(crate) fn counts_per(unit: Unit, dbc_unit: &str) -> Option<Ratio> {
    if unit == Unit::Count {
        return Some(Ratio::whole(1));
    }
    let row = UNITS.iter().find(|(of, name, ..)| (*of, *name) == (unit, dbc_unit))?;
    Some(Ratio::new(row.2, row.3))
}

/// Returns the units of a DBC in which a value of the model may come.
pub(crate) fn accepted(unit: Unit) -> Vec<&'static str> {
    UNITS.iter().filter(|(of, ..)| *of == unit).map(|(_, name, ..)| *name).collect()
}

/// Returns the states of a unit of states; none for a unit of numbers.
pub(crate) fn states(unit: Unit) -> &'static [State] {
    unit.kind().map_or(&[], |kind| kind.states)
}

/// Returns the name of the variant of `Value`.
pub(crate) fn variant(value: Value) -> String {
    format!("{value:?}")
}

/// Every node with its name in `vehicle.toml`.
pub(crate) const NODES: [(&str, Node); 11] = [
    ("vcu", Node::Vcu),
    ("inverter", Node::Inverter),
    ("bms", Node::Bms),
    ("dcdc", Node::Dcdc),
    ("steering", Node::Steering),
    ("compressor", Node::Compressor),
    ("hvac", Node::Hvac),
    ("insulation", Node::Insulation),
    ("charger", Node::Charger),
    ("contactors", Node::Contactors),
    ("cluster", Node::Cluster),
];

/// Every kind of checksum with its name in `vehicle.toml`.
pub(crate) const CHECKSUMS: [(&str, ChecksumKind); 3] = [
    ("crc8_sae_j1850", ChecksumKind::Crc8SaeJ1850),
    ("sum8", ChecksumKind::Sum8),
    ("xor8", ChecksumKind::Xor8),
];
