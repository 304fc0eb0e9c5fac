//! Vehicle `hostile`: Conversion (改装车).
//!
//! Generated from `hostile.dbc` and `vehicle.toml`; refresh with `cargo xtask codegen`.

use crate::checksum::{Checksum, ChecksumKind};
use crate::codec::{self, Got, LifeKind, MessageInfo, Mux, Order, Scale, SignalInfo};
use crate::frame::CanId;
use crate::model::{INVALID, Readings, Severity, Value};
use crate::stream::{Bound, Cell, Stream};
use crate::vehicle::{FaultText, HvOffRule, Life, LimpRule, Node, NodeName, Rules, RxMessage, TxMessage, Vehicle};

/// Identifiers.
pub mod id {
    use crate::frame::CanId;

    /// InverterStatus.
    pub const INVERTER_STATUS: CanId = CanId::standard(0x120);
    /// type.
    pub const S_TYPE: CanId = CanId::standard(0x240);
    /// SocOnRequest.
    pub const SOC_ON_REQUEST: CanId = CanId::standard(0x601);
    /// Dial.
    pub const DIAL: CanId = CanId::standard(0x602);
}

/// InverterStatus (120) from Inverter, every 20 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InverterStatus(pub [u8; 8]);

impl Default for InverterStatus {
    fn default() -> Self { Self::new() }
}

impl InverterStatus {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `in` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn s_in_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/100 km/h, 0 to 16000; `None` if not valid.
    #[inline(always)]
    pub const fn s_in(self) -> Option<i32> {
        let raw = self.s_in_raw();
        if raw <= 16000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `in` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_s_in_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `as` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn s_as_raw(self) -> i16 { (u16::from_le_bytes([self.0[2], self.0[3]])) as i16 }
    /// Returns the value in 1/10 A, -4000 to 4000; `None` if not valid.
    #[inline(always)]
    pub const fn s_as(self) -> Option<i32> {
        let raw = self.s_as_raw();
        if raw >= -4000 && raw <= 4000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `as` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_s_as_raw(mut self, raw: i16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = ((raw as u16) >> 8) as u8;
        self
    }

    /// Returns `temp_motor` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn temp_motor_raw(self) -> u8 { self.0[4] }
    /// Returns the value in degC, -40 to 215; `None` if not valid.
    #[inline(always)]
    pub const fn temp_motor(self) -> Option<i32> {
        let raw = self.temp_motor_raw();
        Some(raw as i32 - 40)
    }
    /// Returns the frame with `temp_motor` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temp_motor_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `Self` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn s_self_raw(self) -> u8 { self.0[5] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn s_self(self) -> Option<i32> {
        let raw = self.s_self_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `Self` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_s_self_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }
}

/// type (240) from Pack, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Type(pub [u8; 8]);

impl Default for Type {
    fn default() -> Self { Self::new() }
}

impl Type {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `Volt` as sent: 16 bits down from bit 7.
    #[inline(always)]
    pub const fn volt_raw(self) -> u16 { u16::from_be_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn volt(self) -> Option<i32> {
        let raw = self.volt_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `Volt` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_volt_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[0] = (raw >> 8) as u8;
        self
    }

    /// Returns `tMax` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn t_max_raw(self) -> i8 { (self.0[2]) as i8 }
    /// Returns the value in degC, -40 to 85; `None` if not valid.
    #[inline(always)]
    pub const fn t_max(self) -> Option<i32> {
        let raw = self.t_max_raw();
        if raw >= -40 && raw <= 85 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `tMax` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_t_max_raw(mut self, raw: i8) -> Self {
        self.0[2] = raw as u8;
        self
    }

    /// Returns `state` as sent: 2 bits from bit 24.
    #[inline(always)]
    pub const fn state_raw(self) -> u8 { self.0[3] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn state(self) -> Option<i32> {
        let raw = self.state_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_state_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xFC | raw & 0x03;
        self
    }
}

/// SocOnRequest (601) from Pack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SocOnRequest(pub [u8; 8]);

impl Default for SocOnRequest {
    fn default() -> Self { Self::new() }
}

impl SocOnRequest {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `soc` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn soc_raw(self) -> u8 { self.0[0] }
    /// Returns the value in %, 0 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn soc(self) -> Option<i32> {
        let raw = self.soc_raw();
        if raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }
}

/// Dial (602) from M5Dial, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dial(pub [u8; 8]);

impl Default for Dial {
    fn default() -> Self { Self::new() }
}

impl Dial {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `km` as sent: 32 bits from bit 0.
    #[inline(always)]
    pub const fn km_raw(self) -> u32 { u32::from_le_bytes([self.0[0], self.0[1], self.0[2], self.0[3]]) }
    /// Returns the value in 1/8 km, 0 to 4000000000; `None` if not valid.
    #[inline(always)]
    pub const fn km(self) -> Option<i64> {
        let raw = self.km_raw();
        if raw <= 4000000000 { Some(raw as i64) } else { None }
    }
    /// Returns the frame with `km` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_km_raw(mut self, raw: u32) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self.0[2] = (raw >> 16) as u8;
        self.0[3] = (raw >> 24) as u8;
        self
    }
}

fn get_inverter_status(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = InverterStatus(data);
    Some(match index {
        0 => (frame.s_in_raw() as i64, frame.s_in().map(|value| value as i64)),
        1 => (frame.s_as_raw() as i64, frame.s_as().map(|value| value as i64)),
        2 => (frame.temp_motor_raw() as i64, frame.temp_motor().map(|value| value as i64)),
        3 => (frame.s_self_raw() as i64, frame.s_self().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_inverter_status(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = InverterStatus(data);
    match index {
        0 => frame.with_s_in_raw(raw as u16).0,
        1 => frame.with_s_as_raw(raw as i16).0,
        2 => frame.with_temp_motor_raw(raw as u8).0,
        3 => frame.with_s_self_raw(raw as u8).0,
        _ => data,
    }
}

fn get_s_type(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Type(data);
    Some(match index {
        0 => (frame.volt_raw() as i64, frame.volt().map(|value| value as i64)),
        1 => (frame.t_max_raw() as i64, frame.t_max().map(|value| value as i64)),
        2 => (frame.state_raw() as i64, frame.state().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_s_type(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Type(data);
    match index {
        0 => frame.with_volt_raw(raw as u16).0,
        1 => frame.with_t_max_raw(raw as i8).0,
        2 => frame.with_state_raw(raw as u8).0,
        _ => data,
    }
}

fn get_soc_on_request(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = SocOnRequest(data);
    Some(match index {
        0 => (frame.soc_raw() as i64, frame.soc().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_soc_on_request(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = SocOnRequest(data);
    match index {
        0 => frame.with_soc_raw(raw as u8).0,
        _ => data,
    }
}

fn get_dial(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Dial(data);
    Some(match index {
        0 => (frame.km_raw() as i64, frame.km().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_dial(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Dial(data);
    match index {
        0 => frame.with_km_raw(raw as u32).0,
        _ => data,
    }
}

static INVERTER_STATUS_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "in", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "km/h", range: (0, 16000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "as", start: 16, length: 16, order: Order::Intel, signed: true, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (-4000, 4000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "temp_motor", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "degC", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "Self", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static S_TYPE_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "Volt", start: 7, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "tMax", start: 16, length: 8, order: Order::Intel, signed: true, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "degC", range: (-40, 85), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "state", start: 24, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "Idle"), (1, "Idle_2"), (2, "charging"), (3, "fault")] },
];

static SOC_ON_REQUEST_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "soc", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "%", range: (0, 100), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static DIAL_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "km", start: 0, length: 32, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 8 }, unit: "km", range: (0, 4000000000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

/// Every message of the vehicle, in the order of the DBC: for tools.
pub static MESSAGES: &[MessageInfo] = &[
    MessageInfo { id: CanId::standard(0x120), name: "InverterStatus", sender: "Inverter", len: 8, cycle_ms: 20, slow_cycle_ms: 20, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_inverter_status, set: set_inverter_status, signals: INVERTER_STATUS_SIGNALS },
    MessageInfo { id: CanId::standard(0x240), name: "type", sender: "Pack", len: 6, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_s_type, set: set_s_type, signals: S_TYPE_SIGNALS },
    MessageInfo { id: CanId::standard(0x601), name: "SocOnRequest", sender: "Pack", len: 2, cycle_ms: 0, slow_cycle_ms: 0, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_soc_on_request, set: set_soc_on_request, signals: SOC_ON_REQUEST_SIGNALS },
    MessageInfo { id: CanId::standard(0x602), name: "Dial", sender: "M5Dial", len: 4, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_dial, set: set_dial, signals: DIAL_SIGNALS },
];

static RX: &[RxMessage] = &[
    RxMessage { id: CanId::standard(0x120), name: "InverterStatus", node: Node::Inverter, len: 8, cycle_ms: 20, timeout_ms: 1000, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::standard(0x240), name: "type", node: Node::Bms, len: 6, cycle_ms: 100, timeout_ms: 500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::standard(0x601), name: "SocOnRequest", node: Node::Bms, len: 2, cycle_ms: 0, timeout_ms: 700, life: None, checksum: None, expected: true, vital: false },
];

static TX: &[TxMessage] = &[
    TxMessage { id: CanId::standard(0x602), name: "Dial", cycle_ms: 1000, life: None, checksum: None },
];

/// Texts of the fault codes, sorted by source and code.
pub static FAULTS: &[FaultText] = &[
];

static NODES: &[NodeName] = &[
    NodeName { node: Node::Inverter, zh: "电机控制器", en: "Inverter" },
    NodeName { node: Node::Bms, zh: "电池", en: "Battery" },
    NodeName { node: Node::Cluster, zh: "仪表", en: "Dial" },
];

static STREAMS: &[Stream] = &[
];

static IDS: &[CanId] = &[
    CanId::standard(0x120),
    CanId::standard(0x240),
    CanId::standard(0x601),
];

fn decode_inverter_status(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = InverterStatus(*data);
    let raw = frame.s_in_raw();
    readings.put(source, Value::VehicleSpeed, codec::floor_div((raw as i32) * 64, 25), raw <= 16000);
    let raw = frame.s_as_raw();
    readings.put(source, Value::BatteryCurrent, raw as i32, raw >= -4000 && raw <= 4000);
    let raw = frame.temp_motor_raw();
    readings.put(source, Value::MotorTemperature, raw as i32 - 40, true);
    let raw = frame.s_self_raw();
    readings.put(source, Value::MotorFaultCode, raw as i32, true);
}

fn decode_s_type(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Type(*data);
    let raw = frame.volt_raw();
    readings.put(source, Value::BatteryVoltage, raw as i32, raw <= 5000);
    let raw = frame.t_max_raw();
    readings.put(source, Value::BatteryTemperatureMax, raw as i32, raw >= -40 && raw <= 85);
    let state = STATES_0[(frame.state_raw() & 3) as usize];
    readings.put(source, Value::ChargeState, state, state != INVALID);
}

fn decode_soc_on_request(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = SocOnRequest(*data);
    let raw = frame.soc_raw();
    readings.put(source, Value::BatterySoc, (raw as i32) * 10, raw <= 100);
}

static STATES_0: [i32; 4] = [0, 0, 1, 3];

static DECODERS: [fn(u8, &[u8; 8], &mut Readings); 3] = [
    decode_inverter_status,
    decode_s_type,
    decode_soc_on_request,
];

fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    if let Some(decode) = DECODERS.get(index as usize) {
        decode(index, data, readings);
    }
}

fn encode_dial(values: &Readings) -> [u8; 8] {
    let frame = Dial::new();
    let frame = frame.with_km_raw(codec::known(values, Value::ClusterOdometer).map_or(0, |number| codec::scaled(number, 1, 0, 1, 0, 4000000000) as u32));
    frame.0
}

fn encode(index: u8, values: &Readings) -> [u8; 8] {
    match index {
        0 => encode_dial(values),
        _ => [0; 8],
    }
}

/// Conversion (改装车).
pub static VEHICLE: Vehicle = Vehicle {
    name: "hostile",
    zh: "改装车",
    en: "Conversion",
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
