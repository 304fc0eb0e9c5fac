//! A vehicle with hand-written codecs.
//!
//! Not generated on purpose: what the cluster does is tested without the compiler of vehicles.

use super::Drive;
use protocol_core::model::{Reading, Readings, Value};
use protocol_core::vehicle::{FaultText, Life, NO_VEHICLE, Node, NodeName, RxMessage, TxMessage, Vehicle};
use protocol_core::{CanId, Millis, Severity};

pub(crate) const DRIVE: CanId = CanId::extended(0x100);
pub(crate) const FAULTS: CanId = CanId::extended(0x101);
pub(crate) const PACK: CanId = CanId::extended(0x200);
pub(crate) const PACK_CODE: CanId = CanId::extended(0x201);
pub(crate) const MOTOR: CanId = CanId::extended(0x300);
pub(crate) const PARTS: CanId = CanId::extended(0x400);
pub(crate) const OWN: CanId = CanId::extended(0x700);
pub(crate) const OWN_WAY: CanId = CanId::extended(0x701);

/// A fault report without a level field.
pub(crate) const NO_LEVEL: u8 = 0xEE;

/// A fault report whose level is not defined.
pub(crate) const BAD_LEVEL: u8 = 0xEF;

/// Time-outs in milliseconds.
pub(crate) const DRIVE_TIMEOUT: u64 = 500;
pub(crate) const FAULTS_TIMEOUT: u64 = 600;

const fn rx(
    id: CanId,
    name: &'static str,
    node: Node,
    timeout_ms: u32,
    life: Option<Life>,
    expected: bool,
) -> RxMessage {
    RxMessage {
        id,
        name,
        node,
        len: 8,
        cycle_ms: 0,
        timeout_ms,
        life,
        checksum: None,
        expected,
        vital: false,
    }
}

const fn tx(id: CanId, name: &'static str, cycle_ms: u32, life: Life) -> TxMessage {
    TxMessage { id, name, cycle_ms, life: Some(life), checksum: None }
}

const fn fault(source: Node, code: u16, zh: &'static str, en: &'static str) -> FaultText {
    let severity = if code == 9 { Some(Severity::Stop) } else { None };
    FaultText { source, code, severity, fire: false, limps: false, zh, en }
}

const fn fire(source: Node) -> FaultText {
    FaultText { fire: true, ..fault(source, 24, "火灾报警", "Fire") }
}

pub(crate) static TOY: Vehicle = toy(TOY_FAULTS);
const TOY_FAULTS: &[FaultText] = &[
    fault(Node::Vcu, 3, "单体过压", "Cell overvoltage"),
    fault(Node::Vcu, 4, "单体欠压", "Cell undervoltage"),
    fault(Node::Vcu, 9, "九", "Nine"),
    fire(Node::Vcu),
    fault(Node::Bms, 3, "单体过压", "Cell overvoltage"),
    fault(Node::Bms, 4, "单体欠压", "Cell undervoltage"),
    fire(Node::Bms),
];

/// The same vehicle, but for what code 24 means.
pub(crate) static OTHER: Vehicle = toy(OTHER_FAULTS);
const OTHER_FAULTS: &[FaultText] =
    &[fault(Node::Vcu, 24, "单体压差大", "Cells uneven"), fault(Node::Bms, 24, "单体压差大", "Cells uneven")];

const RX: &[RxMessage] = &[
    rx(DRIVE, "Drive", Node::Vcu, DRIVE_TIMEOUT as u32, Some(Life { byte: 7, mask: 0xFF }), true),
    rx(FAULTS, "Faults", Node::Vcu, FAULTS_TIMEOUT as u32, None, true),
    rx(PACK, "Pack", Node::Bms, 500, Some(Life { byte: 7, mask: 0xF0 }), true),
    rx(PACK_CODE, "PackCode", Node::Bms, 2_500, None, false),
    rx(MOTOR, "Motor", Node::Inverter, 500, None, false),
    rx(PARTS, "Parts", Node::Dcdc, 500, None, false),
];
const TX: &[TxMessage] = &[
    tx(OWN, "Own", 1_000, Life { byte: 7, mask: 0xFF }),
    tx(OWN_WAY, "OwnWay", 500, Life { byte: 0, mask: 0xF0 }),
];
const NODES: &[NodeName] = &[NodeName { node: Node::Vcu, zh: "整车", en: "VCU" }];

const fn toy(faults: &'static [FaultText]) -> Vehicle {
    Vehicle {
        name: "toy",
        bitrate: 250_000,
        rx: RX,
        decode,
        tx: TX,
        encode,
        faults,
        rules: super::RULES,
        nodes: NODES,
        ..NO_VEHICLE
    }
}

fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    let word = |at: usize| i32::from(u16::from_le_bytes([data[at], data[at + 1]]));
    let mut set = |value, number: i32| readings.set(index, value, Reading::Valid(number));
    let bit = |byte: usize, bit: u8| i32::from(data[byte] >> bit & 1);
    match index {
        0 => {
            set(Value::VehicleGear, i32::from(data[0]));
            set(Value::VehicleSpeed, word(1));
            set(Value::VehicleReady, bit(3, 0));
            set(Value::VehicleFault, bit(3, 1));
            set(Value::VehiclePowerLimited, bit(3, 2));
            set(Value::VehicleTorqueLimited, bit(3, 3));
        }
        1 => {
            set(Value::VehicleFaultCode, word(1));
            match data[0] {
                NO_LEVEL => {}
                BAD_LEVEL => readings.set(index, Value::VehicleFaultLevel, Reading::Invalid),
                level => set(Value::VehicleFaultLevel, i32::from(level)),
            }
        }
        2 => {
            set(Value::BatteryVoltage, word(0));
            set(Value::BatteryCurrent, word(2) - 10_000);
            set(Value::BatteryFaultLevel, i32::from(data[5]));
            set(Value::BatteryHvOffRequest, bit(6, 0));
            set(Value::ContactorMain, bit(6, 1));
            let soc = if data[4] == 0xFF { Reading::Invalid } else { Reading::Valid(i32::from(data[4]) * 4) };
            readings.set(index, Value::BatterySoc, soc);
        }
        3 => set(Value::BatteryFaultCode, i32::from(data[0])),
        4 => {
            set(Value::MotorSpeed, word(0));
            set(Value::MotorFault, bit(2, 0));
            set(Value::MotorFaultCode, i32::from(data[3]));
            set(Value::MotorTemperature, i32::from(data[4]));
            set(Value::InverterTemperature, i32::from(data[5]));
            set(Value::MotorFaultLevel, i32::from(data[6]));
        }
        5 => {
            set(Value::DcdcState, i32::from(data[0]));
            set(Value::DcdcFaultCode, i32::from(data[1]));
            set(Value::SteeringState, i32::from(data[2]));
            set(Value::SteeringFaultCode, i32::from(data[3]));
            set(Value::CompressorState, i32::from(data[4]));
            set(Value::CompressorFaultCode, i32::from(data[5]));
        }
        _ => {}
    }
}

/// Returns a value as a byte, 0xFF = not known.
fn byte(values: &Readings, value: Value) -> u8 {
    match values.get(value) {
        Some((Reading::Valid(number), _)) => number as u8,
        _ => 0xFF,
    }
}

fn encode(index: u8, values: &Readings) -> [u8; 8] {
    let odometer = match values.get(Value::ClusterOdometer) {
        Some((Reading::Valid(km8), _)) => km8 as u32,
        _ => u32::MAX,
    };
    let [a, b, c, d] = odometer.to_le_bytes();
    match index {
        0 => [
            byte(values, Value::ClusterDriverLeft),
            byte(values, Value::BodyKey),
            byte(values, Value::AirFront),
            byte(values, Value::BodyDoorMiddle),
            byte(values, Value::ClusterUpgradeForbidden),
            byte(values, Value::BodyTurnLeft),
            byte(values, Value::SupplyVoltage),
            0,
        ],
        1 => [0x05, a, b, c, d, 0xFF, 0xFF, 0xFF],
        _ => [0; 8],
    }
}

/// A healthy vehicle that stands in N, after the bulb check.
pub(crate) fn healthy() -> Drive {
    healthy_at(Millis(0))
}

/// The same, started at another time.
pub(crate) fn healthy_at(now: Millis) -> Drive {
    let mut drive = Drive::at(&TOY, now);
    drive.gear_and_speed(3, 0);
    drive.report(0, 0);
    drive.repeat(PACK, PACK_WELL);
    drive.repeat(PACK_CODE, [0; 8]);
    drive.repeat(MOTOR, [0, 0, 0, 0, 40, 50, 0, 0]);
    drive.repeat(PARTS, [1, 0, 1, 0, 1, 0, 0, 0]);
    drive.run(3_000);
    drive
}

/// What this vehicle's nodes send.
impl Drive {
    /// Gear in the model's numbers and speed in whole km/h.
    pub(crate) fn gear_and_speed(&mut self, gear: u8, kmh: u16) {
        let [low, high] = (kmh * 256).to_le_bytes();
        self.repeat(DRIVE, [gear, low, high, 0b0001, 0, 0, 0, 0]);
    }

    /// The vehicle controller's fault report.
    pub(crate) fn report(&mut self, level: u8, code: u16) {
        let [low, high] = code.to_le_bytes();
        self.repeat(FAULTS, [level, low, high, 0, 0, 0, 0, 0]);
    }

    /// The battery's fault report.
    pub(crate) fn battery_report(&mut self, level: u8, code: u8) {
        let mut data = PACK_WELL;
        data[5] = level;
        self.repeat(PACK, data);
        self.repeat(PACK_CODE, [code, 0, 0, 0, 0, 0, 0, 0]);
    }
}

/// 350.0 V, 25.0 A, 80 %, no fault, main contactor closed.
pub(crate) const PACK_WELL: [u8; 8] = [0xAC, 0x0D, 0x0A, 0x28, 200, 0, 0b10, 0];
