//! A vehicle of which every node can send every value.
//!
//! One frame holds one value. What is kept is sent again every 100 ms, so each node has one time-out: 500 ms.

use super::Drive;
use protocol_core::model::{Readings, Value};
use protocol_core::vehicle::{FaultText, NO_VEHICLE, Node, NodeName, RxMessage, Vehicle};
use protocol_core::{CanId, Severity};

pub(crate) const TIMEOUT: u64 = 500;

pub(crate) const NODES: [Node; 10] = [
    Node::Vcu,
    Node::Inverter,
    Node::Bms,
    Node::Dcdc,
    Node::Steering,
    Node::Compressor,
    Node::Hvac,
    Node::Insulation,
    Node::Charger,
    Node::Contactors,
];

pub(crate) const fn id(node: Node) -> CanId {
    CanId::extended(0x100 + node as u32)
}

pub(crate) const fn rx(node: Node) -> RxMessage {
    let expected = matches!(node, Node::Vcu | Node::Bms);
    let timeout_ms = TIMEOUT as u32;
    RxMessage {
        id: id(node),
        name: "Probe",
        node,
        len: 8,
        cycle_ms: 0,
        timeout_ms,
        life: None,
        checksum: None,
        expected,
        vital: false,
    }
}

pub(crate) const RX: [RxMessage; NODES.len()] = {
    let mut rows = [rx(Node::Vcu); NODES.len()];
    let mut index = 0;
    while index < NODES.len() {
        rows[index] = rx(NODES[index]);
        index += 1;
    }
    rows
};

/// The code that says the battery burns.
pub(crate) const FIRE_CODE: i32 = 99;

const fn alarm(source: Node, code: u16, severity: Option<Severity>, en: &'static str) -> FaultText {
    FaultText { source, code, severity, fire: false, limps: false, zh: en, en }
}

const FAULTS: &[FaultText] = &[
    alarm(Node::Vcu, 70, None, "Link fault"),
    FaultText { fire: true, ..alarm(Node::Vcu, FIRE_CODE as u16, None, "Fire") },
    alarm(Node::Bms, 1, None, "Alarm 1"),
    alarm(Node::Bms, 2, Some(Severity::Derate), "Alarm 2"),
    alarm(Node::Bms, 3, Some(Severity::Stop), "Alarm 3"),
    alarm(Node::Bms, 32, Some(Severity::Warn), "Alarm 32"),
    FaultText { fire: true, ..alarm(Node::Bms, FIRE_CODE as u16, None, "Fire") },
];

/// The bytes of a frame that says this number, or that the value is not valid.
pub(crate) fn data(value: Value, number: Option<i32>) -> [u8; 8] {
    let [a, b, c, d] = number.unwrap_or(0).to_le_bytes();
    [value as u8, u8::from(number.is_none()), 0, 0, a, b, c, d]
}

pub(crate) fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    let number = i32::from_le_bytes([data[4], data[5], data[6], data[7]]);
    readings.put(index, Value::ALL[usize::from(data[0])], number, data[1] == 0);
}

pub(crate) static PROBE: Vehicle = Vehicle {
    name: "probe",
    bitrate: 250_000,
    rx: &RX,
    decode,
    faults: FAULTS,
    rules: super::RULES,
    nodes: &[NodeName { node: Node::Vcu, zh: "整车", en: "VCU" }],
    ..NO_VEHICLE
};

/// A healthy vehicle after the bulb check and after every time-out of a start.
pub(crate) fn healthy() -> Drive {
    let mut drive = Drive::of(&PROBE);
    drive.keep(Node::Vcu, Value::VehicleSpeed, 0);
    drive.keep(Node::Bms, Value::BatteryHvOffRequest, 0);
    drive.run(6_000);
    drive
}
