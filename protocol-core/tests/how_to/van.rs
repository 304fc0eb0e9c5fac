//! Vehicle `van`: Electric van (纯电动汽车).
//!
//! Generated from `vehicles/van/van.dbc` and `vehicles/van/vehicle.toml`; refresh with `cargo xtask codegen`.

use crate::checksum::{Checksum, ChecksumKind};
use crate::codec::{self, Got, LifeKind, MessageInfo, Mux, Order, Scale, SignalInfo};
use crate::frame::CanId;
use crate::model::{INVALID, Readings, Severity, Value};
use crate::stream::{Bound, Cell, Stream};
use crate::vehicle::{FaultText, HvOffRule, Life, LimpRule, Node, NodeName, Rules, RxMessage, TxMessage, Vehicle};

/// Identifiers.
pub mod id {
    use crate::frame::CanId;

    /// Status.
    pub const STATUS: CanId = CanId::standard(0x321);
    /// Distance.
    pub const DISTANCE: CanId = CanId::standard(0x322);
}

/// Status (321) from Controller, every 50 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Status(pub [u8; 8]);

impl Default for Status {
    fn default() -> Self { Self::new() }
}

impl Status {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `speed` as sent: 16 bits down from bit 7.
    #[inline(always)]
    pub const fn speed_raw(self) -> u16 { u16::from_be_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/100 km/h, 0 to 12000; `None` if not valid.
    #[inline(always)]
    pub const fn speed(self) -> Option<i32> {
        let raw = self.speed_raw();
        if raw <= 12000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_speed_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[0] = (raw >> 8) as u8;
        self
    }

    /// Returns `gear` as sent: 2 bits from bit 16.
    #[inline(always)]
    pub const fn gear_raw(self) -> u8 { self.0[2] & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn gear(self) -> Option<i32> {
        let raw = self.gear_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `gear` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_gear_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `soc` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn soc_raw(self) -> u8 { self.0[3] }
    /// Returns the value in 1/2 %, 0 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn soc(self) -> Option<i32> {
        let raw = self.soc_raw();
        if raw <= 200 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `current` as sent: 16 bits down from bit 39.
    #[inline(always)]
    pub const fn current_raw(self) -> i16 { (u16::from_be_bytes([self.0[4], self.0[5]])) as i16 }
    /// Returns the value in 1/10 A, -4000 to 4000; `None` if not valid.
    #[inline(always)]
    pub const fn current(self) -> Option<i32> {
        let raw = self.current_raw();
        if raw >= -4000 && raw <= 4000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_current_raw(mut self, raw: i16) -> Self {
        self.0[5] = raw as u8;
        self.0[4] = ((raw as u16) >> 8) as u8;
        self
    }

    /// Returns `fault` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn fault_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn fault(self) -> Option<i32> {
        let raw = self.fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `checksum` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn checksum_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn checksum(self) -> Option<i32> {
        let raw = self.checksum_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `checksum` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_checksum_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// Distance (322) from Cluster, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Distance(pub [u8; 8]);

impl Default for Distance {
    fn default() -> Self { Self::new() }
}

impl Distance {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `odometer` as sent: 32 bits from bit 0.
    #[inline(always)]
    pub const fn odometer_raw(self) -> u32 { u32::from_le_bytes([self.0[0], self.0[1], self.0[2], self.0[3]]) }
    /// Returns the value in 1/8 km, 0 to 4000000000; `None` if not valid.
    #[inline(always)]
    pub const fn odometer(self) -> Option<i64> {
        let raw = self.odometer_raw();
        if raw <= 4000000000 { Some(raw as i64) } else { None }
    }
    /// Returns the frame with `odometer` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_odometer_raw(mut self, raw: u32) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self.0[2] = (raw >> 16) as u8;
        self.0[3] = (raw >> 24) as u8;
        self
    }
}

fn get_status(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Status(data);
    Some(match index {
        0 => (frame.speed_raw() as i64, frame.speed().map(|value| value as i64)),
        1 => (frame.gear_raw() as i64, frame.gear().map(|value| value as i64)),
        2 => (frame.soc_raw() as i64, frame.soc().map(|value| value as i64)),
        3 => (frame.current_raw() as i64, frame.current().map(|value| value as i64)),
        4 => (frame.fault_raw() as i64, frame.fault().map(|value| value as i64)),
        5 => (frame.checksum_raw() as i64, frame.checksum().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_status(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Status(data);
    match index {
        0 => frame.with_speed_raw(raw as u16).0,
        1 => frame.with_gear_raw(raw as u8).0,
        2 => frame.with_soc_raw(raw as u8).0,
        3 => frame.with_current_raw(raw as i16).0,
        4 => frame.with_fault_raw(raw as u8).0,
        5 => frame.with_checksum_raw(raw as u8).0,
        _ => data,
    }
}

fn get_distance(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Distance(data);
    Some(match index {
        0 => (frame.odometer_raw() as i64, frame.odometer().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_distance(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Distance(data);
    match index {
        0 => frame.with_odometer_raw(raw as u32).0,
        _ => data,
    }
}

static STATUS_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "speed", start: 7, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "km/h", range: (0, 12000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "gear", start: 16, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "N"), (1, "forward"), (2, "R")] },
    SignalInfo { name: "soc", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 2 }, unit: "%", range: (0, 200), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "current", start: 39, length: 16, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (-4000, 4000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "fault", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "checksum", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static DISTANCE_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "odometer", start: 0, length: 32, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 8 }, unit: "km", range: (0, 4000000000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

/// Every message of the vehicle, in the order of the DBC: for tools.
pub static MESSAGES: &[MessageInfo] = &[
    MessageInfo { id: CanId::standard(0x321), name: "Status", sender: "Controller", len: 8, cycle_ms: 50, slow_cycle_ms: 50, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_status, set: set_status, signals: STATUS_SIGNALS },
    MessageInfo { id: CanId::standard(0x322), name: "Distance", sender: "Cluster", len: 4, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_distance, set: set_distance, signals: DISTANCE_SIGNALS },
];

static RX: &[RxMessage] = &[
    RxMessage { id: CanId::standard(0x321), name: "Status", node: Node::Vcu, len: 8, cycle_ms: 50, timeout_ms: 500, life: None, checksum: Some(Checksum { byte: 7, len: 8, kind: ChecksumKind::Xor8 }), expected: true, vital: false },
];

static TX: &[TxMessage] = &[
    TxMessage { id: CanId::standard(0x322), name: "Distance", cycle_ms: 1000, life: None, checksum: None },
];

/// Texts of the fault codes, sorted by source and code.
pub static FAULTS: &[FaultText] = &[
    FaultText { source: Node::Vcu, code: 3, severity: Some(Severity::Stop), fire: false, limps: false, zh: "绝缘故障", en: "Insulation fault" },
];

static NODES: &[NodeName] = &[
    NodeName { node: Node::Vcu, zh: "整车控制器", en: "Vehicle controller" },
    NodeName { node: Node::Cluster, zh: "仪表", en: "Cluster" },
];

static STREAMS: &[Stream] = &[
];

static IDS: &[CanId] = &[
    CanId::standard(0x321),
];

fn decode_status(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Status(*data);
    let raw = frame.speed_raw();
    readings.put(source, Value::VehicleSpeed, codec::floor_div((raw as i32) * 64, 25), raw <= 12000);
    let state = STATES_0[(frame.gear_raw() & 3) as usize];
    readings.put(source, Value::VehicleGear, state, state != INVALID);
    let raw = frame.fault_raw();
    readings.put(source, Value::VehicleFaultCode, raw as i32, true);
    let raw = frame.current_raw();
    readings.put(source, Value::BatteryCurrent, raw as i32, raw >= -4000 && raw <= 4000);
    let raw = frame.soc_raw();
    readings.put(source, Value::BatterySoc, (raw as i32) * 5, raw <= 200);
}

static STATES_0: [i32; 4] = [3, 1, 2, INVALID];

static DECODERS: [fn(u8, &[u8; 8], &mut Readings); 1] = [
    decode_status,
];

fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    if let Some(decode) = DECODERS.get(index as usize) {
        decode(index, data, readings);
    }
}

fn encode_distance(values: &Readings) -> [u8; 8] {
    let frame = Distance::new();
    let frame = frame.with_odometer_raw(codec::known(values, Value::ClusterOdometer).map_or(0, |number| codec::scaled(number, 1, 0, 1, 0, 4000000000) as u32));
    frame.0
}

fn encode(index: u8, values: &Readings) -> [u8; 8] {
    match index {
        0 => encode_distance(values),
        _ => [0; 8],
    }
}

/// Electric van (纯电动汽车).
pub static VEHICLE: Vehicle = Vehicle {
    name: "van",
    zh: "纯电动汽车",
    en: "Electric van",
    bitrate: 500000,
    worst_level: 3,
    rules: Rules::NONE,
    rx: RX,
    decode,
    streams: STREAMS,
    ids: IDS,
    tx: TX,
    encode,
    faults: FAULTS,
    nodes: NODES,
};
