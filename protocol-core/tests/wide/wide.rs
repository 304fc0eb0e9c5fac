//! Vehicle `wide`: Wide (宽).
//!
//! Generated from `wide.dbc` and `vehicle.toml`; refresh with `cargo xtask codegen`.

use crate::checksum::{Checksum, ChecksumKind};
use crate::codec::{self, Got, LifeKind, MessageInfo, Mux, Order, Scale, SignalInfo};
use crate::frame::CanId;
use crate::model::{INVALID, Readings, Severity, Value};
use crate::stream::{Bound, Cell, Stream};
use crate::vehicle::{FaultText, HvOffRule, Life, LimpRule, Node, NodeName, Rules, RxMessage, TxMessage, Vehicle};

/// Identifiers.
pub mod id {
    use crate::frame::CanId;

    /// Floats.
    pub const FLOATS: CanId = CanId::standard(0x100);
    /// Double.
    pub const DOUBLE: CanId = CanId::standard(0x101);
    /// Pages.
    pub const PAGES: CanId = CanId::standard(0x102);
    /// Wide.
    pub const WIDE: CanId = CanId::standard(0x103);
    /// Long.
    pub const LONG: CanId = CanId::standard(0x104);
    /// EEC1.
    pub const EEC1: CanId = CanId::extended(0x00F004FE);
    /// Vin.
    pub const VIN: CanId = CanId::extended(0x00000100);
}

/// Floats (100) from Engine, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Floats(pub [u8; 8]);

impl Default for Floats {
    fn default() -> Self { Self::new() }
}

impl Floats {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `volts` as sent: 32 bits from bit 0.
    #[inline(always)]
    pub const fn volts_raw(self) -> u32 { u32::from_le_bytes([self.0[0], self.0[1], self.0[2], self.0[3]]) }
    /// Returns the frame with `volts` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_volts_raw(mut self, raw: u32) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self.0[2] = (raw >> 16) as u8;
        self.0[3] = (raw >> 24) as u8;
        self
    }

    /// Returns `amps` as sent: 32 bits down from bit 39.
    #[inline(always)]
    pub const fn amps_raw(self) -> u32 { u32::from_be_bytes([self.0[4], self.0[5], self.0[6], self.0[7]]) }
    /// Returns the frame with `amps` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_amps_raw(mut self, raw: u32) -> Self {
        self.0[7] = raw as u8;
        self.0[6] = (raw >> 8) as u8;
        self.0[5] = (raw >> 16) as u8;
        self.0[4] = (raw >> 24) as u8;
        self
    }
}

/// Double (101) from Engine, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Double(pub [u8; 8]);

impl Default for Double {
    fn default() -> Self { Self::new() }
}

impl Double {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `rpm` as sent: 64 bits from bit 0.
    #[inline(always)]
    pub const fn rpm_raw(self) -> u64 { u64::from_le_bytes([self.0[0], self.0[1], self.0[2], self.0[3], self.0[4], self.0[5], self.0[6], self.0[7]]) }
    /// Returns the frame with `rpm` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_rpm_raw(mut self, raw: u64) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self.0[2] = (raw >> 16) as u8;
        self.0[3] = (raw >> 24) as u8;
        self.0[4] = (raw >> 32) as u8;
        self.0[5] = (raw >> 40) as u8;
        self.0[6] = (raw >> 48) as u8;
        self.0[7] = (raw >> 56) as u8;
        self
    }
}

/// Pages (102) from Pack, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pages(pub [u8; 8]);

impl Default for Pages {
    fn default() -> Self { Self::new() }
}

impl Pages {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `page` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn page_raw(self) -> u8 { self.0[0] }
    /// Returns the frame with `page` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_page_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `half` as sent: 4 bits from bit 8, only while `page` is 1.
    #[inline(always)]
    pub const fn half_raw(self) -> u8 { self.0[1] & 0x0F }
    /// Returns the frame with `half` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_half_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xF0 | raw & 0x0F;
        self
    }

    /// Returns `soc` as sent: 8 bits from bit 8, only while `page` is 0 or 3 to 5.
    #[inline(always)]
    pub const fn soc_raw(self) -> u8 { self.0[1] }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `cell` as sent: 16 bits down from bit 23, only while `page` is 1, only while `half` is 2 to 3 or 9.
    #[inline(always)]
    pub const fn cell_raw(self) -> u16 { u16::from_be_bytes([self.0[2], self.0[3]]) }
    /// Returns the frame with `cell` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cell_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `warm` as sent: 8 bits from bit 16, only while `page` is 1, only while `half` is 4 to 15.
    #[inline(always)]
    pub const fn warm_raw(self) -> i8 { (self.0[2]) as i8 }
    /// Returns the frame with `warm` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_warm_raw(mut self, raw: i8) -> Self {
        self.0[2] = raw as u8;
        self
    }
}

/// Wide (103) from Pack, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wide(pub [u8; 8]);

impl Default for Wide {
    fn default() -> Self { Self::new() }
}

impl Wide {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `odometer` as sent: 64 bits down from bit 7.
    #[inline(always)]
    pub const fn odometer_raw(self) -> u64 { u64::from_be_bytes([self.0[0], self.0[1], self.0[2], self.0[3], self.0[4], self.0[5], self.0[6], self.0[7]]) }
    /// Returns the frame with `odometer` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_odometer_raw(mut self, raw: u64) -> Self {
        self.0[7] = raw as u8;
        self.0[6] = (raw >> 8) as u8;
        self.0[5] = (raw >> 16) as u8;
        self.0[4] = (raw >> 24) as u8;
        self.0[3] = (raw >> 32) as u8;
        self.0[2] = (raw >> 40) as u8;
        self.0[1] = (raw >> 48) as u8;
        self.0[0] = (raw >> 56) as u8;
        self
    }
}

/// Long (104) from Pack, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Long(pub [u8; 8]);

impl Default for Long {
    fn default() -> Self { Self::new() }
}

impl Long {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `power` as sent: 40 bits from bit 0.
    #[inline(always)]
    pub const fn power_raw(self) -> i64 { (((self.0[0] as u64 | (self.0[1] as u64) << 8 | (self.0[2] as u64) << 16 | (self.0[3] as u64) << 24 | (self.0[4] as u64) << 32) << 24) as i64) >> 24 }
    /// Returns the frame with `power` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_power_raw(mut self, raw: i64) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = ((raw as u64) >> 8) as u8;
        self.0[2] = ((raw as u64) >> 16) as u8;
        self.0[3] = ((raw as u64) >> 24) as u8;
        self.0[4] = ((raw as u64) >> 32) as u8;
        self
    }

    /// Returns `Speed` as sent: 16 bits from bit 40.
    #[inline(always)]
    pub const fn speed_raw(self) -> u16 { u16::from_le_bytes([self.0[5], self.0[6]]) }
    /// Returns the frame with `Speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_speed_raw(mut self, raw: u16) -> Self {
        self.0[5] = raw as u8;
        self.0[6] = (raw >> 8) as u8;
        self
    }

    /// Returns `speed` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn speed_2_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn speed_2(self) -> Option<i32> {
        let raw = self.speed_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_speed_2_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// EEC1 (00F004FE) from Engine, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Eec1(pub [u8; 8]);

impl Default for Eec1 {
    fn default() -> Self { Self::new() }
}

impl Eec1 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `overheat` as sent: 2 bits from bit 0.
    #[inline(always)]
    pub const fn overheat_raw(self) -> u8 { self.0[0] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn overheat(self) -> Option<i32> {
        let raw = self.overheat_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overheat` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overheat_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `leak` as sent: 3 bits from bit 2.
    #[inline(always)]
    pub const fn leak_raw(self) -> i8 { (((self.0[0] >> 2 & 0x07) << 5) as i8) >> 5 }
    /// Returns the value, -4 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn leak(self) -> Option<i32> {
        let raw = self.leak_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `leak` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_leak_raw(mut self, raw: i8) -> Self {
        self.0[0] = self.0[0] & 0xE3 | ((raw as u8) & 0x07) << 2;
        self
    }

    /// Returns `torque` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn torque_raw(self) -> u8 { self.0[2] }
    /// Returns the value in Nm, -125 to 125; `None` if not valid.
    #[inline(always)]
    pub const fn torque(self) -> Option<i32> {
        let raw = self.torque_raw();
        if raw <= 250 { Some(raw as i32 - 125) } else { None }
    }
    /// Returns the frame with `torque` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_torque_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }
}

/// Vin (00000100) from Engine, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vin(pub [u8; 8]);

impl Default for Vin {
    fn default() -> Self { Self::new() }
}

impl Vin {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `vin` as sent: 64 bits down from bit 7.
    #[inline(always)]
    pub const fn vin_raw(self) -> u64 { u64::from_be_bytes([self.0[0], self.0[1], self.0[2], self.0[3], self.0[4], self.0[5], self.0[6], self.0[7]]) }
    /// Returns the frame with `vin` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vin_raw(mut self, raw: u64) -> Self {
        self.0[7] = raw as u8;
        self.0[6] = (raw >> 8) as u8;
        self.0[5] = (raw >> 16) as u8;
        self.0[4] = (raw >> 24) as u8;
        self.0[3] = (raw >> 32) as u8;
        self.0[2] = (raw >> 40) as u8;
        self.0[1] = (raw >> 48) as u8;
        self.0[0] = (raw >> 56) as u8;
        self
    }
}

fn get_floats(_index: usize, _data: [u8; 8]) -> Option<Got> { None }

fn set_floats(_index: usize, data: [u8; 8], _raw: i64) -> [u8; 8] { data }

fn get_double(_index: usize, _data: [u8; 8]) -> Option<Got> { None }

fn set_double(_index: usize, data: [u8; 8], _raw: i64) -> [u8; 8] { data }

fn get_pages(_index: usize, _data: [u8; 8]) -> Option<Got> { None }

fn set_pages(_index: usize, data: [u8; 8], _raw: i64) -> [u8; 8] { data }

fn get_wide(_index: usize, _data: [u8; 8]) -> Option<Got> { None }

fn set_wide(_index: usize, data: [u8; 8], _raw: i64) -> [u8; 8] { data }

fn get_long(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Long(data);
    Some(match index {
        0 => (frame.speed_2_raw() as i64, frame.speed_2().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_long(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Long(data);
    match index {
        0 => frame.with_speed_2_raw(raw as u8).0,
        _ => data,
    }
}

fn get_eec1(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Eec1(data);
    Some(match index {
        0 => (frame.overheat_raw() as i64, frame.overheat().map(|value| value as i64)),
        1 => (frame.leak_raw() as i64, frame.leak().map(|value| value as i64)),
        2 => (frame.torque_raw() as i64, frame.torque().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_eec1(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Eec1(data);
    match index {
        0 => frame.with_overheat_raw(raw as u8).0,
        1 => frame.with_leak_raw(raw as i8).0,
        2 => frame.with_torque_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vin(_index: usize, _data: [u8; 8]) -> Option<Got> { None }

fn set_vin(_index: usize, data: [u8; 8], _raw: i64) -> [u8; 8] { data }

static FLOATS_SIGNALS: &[SignalInfo] = &[
];

static DOUBLE_SIGNALS: &[SignalInfo] = &[
];

static PAGES_SIGNALS: &[SignalInfo] = &[
];

static WIDE_SIGNALS: &[SignalInfo] = &[
];

static LONG_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "speed", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static EEC1_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "overheat", start: 0, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "warning"), (2, "stop"), (3, "stop")] },
    SignalInfo { name: "leak", start: 2, length: 3, order: Order::Intel, signed: true, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (-4, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "torque", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -125, den: 1 }, unit: "Nm", range: (0, 250), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static VIN_SIGNALS: &[SignalInfo] = &[
];

/// Every message of the vehicle, in the order of the DBC: for tools.
pub static MESSAGES: &[MessageInfo] = &[
    MessageInfo { id: CanId::standard(0x100), name: "Floats", sender: "Engine", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_floats, set: set_floats, signals: FLOATS_SIGNALS },
    MessageInfo { id: CanId::standard(0x101), name: "Double", sender: "Engine", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_double, set: set_double, signals: DOUBLE_SIGNALS },
    MessageInfo { id: CanId::standard(0x102), name: "Pages", sender: "Pack", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_pages, set: set_pages, signals: PAGES_SIGNALS },
    MessageInfo { id: CanId::standard(0x103), name: "Wide", sender: "Pack", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_wide, set: set_wide, signals: WIDE_SIGNALS },
    MessageInfo { id: CanId::standard(0x104), name: "Long", sender: "Pack", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_long, set: set_long, signals: LONG_SIGNALS },
    MessageInfo { id: CanId::extended(0x00F004FE), name: "EEC1", sender: "Engine", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_eec1, set: set_eec1, signals: EEC1_SIGNALS },
    MessageInfo { id: CanId::extended(0x00000100), name: "Vin", sender: "Engine", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_vin, set: set_vin, signals: VIN_SIGNALS },
];

static RX: &[RxMessage] = &[
    RxMessage { id: CanId::standard(0x100), name: "Floats", node: Node::Vcu, len: 8, cycle_ms: 100, timeout_ms: 500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::standard(0x101), name: "Double", node: Node::Vcu, len: 8, cycle_ms: 100, timeout_ms: 500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::standard(0x102), name: "Pages", node: Node::Bms, len: 8, cycle_ms: 100, timeout_ms: 500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::standard(0x103), name: "Wide", node: Node::Bms, len: 8, cycle_ms: 100, timeout_ms: 500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::standard(0x104), name: "Long", node: Node::Bms, len: 8, cycle_ms: 100, timeout_ms: 500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x00F004FE), name: "EEC1", node: Node::Vcu, len: 8, cycle_ms: 100, timeout_ms: 500, life: None, checksum: None, expected: true, vital: false },
];

static TX: &[TxMessage] = &[
];

/// Texts of the fault codes, sorted by source and code.
pub static FAULTS: &[FaultText] = &[
    FaultText { source: Node::Vcu, code: 1, severity: Some(Severity::Warn), fire: false, limps: false, zh: "电机过热", en: "Motor hot" },
    FaultText { source: Node::Vcu, code: 2, severity: Some(Severity::Stop), fire: false, limps: false, zh: "电机严重过热", en: "Motor too hot" },
    FaultText { source: Node::Vcu, code: 3, severity: Some(Severity::Derate), fire: false, limps: false, zh: "泄漏", en: "Leak" },
];

static NODES: &[NodeName] = &[
    NodeName { node: Node::Vcu, zh: "发动机", en: "Engine" },
    NodeName { node: Node::Bms, zh: "电池", en: "Battery" },
];

static STREAMS: &[Stream] = &[
];

static IDS: &[CanId] = &[
    CanId::standard(0x100),
    CanId::standard(0x101),
    CanId::standard(0x102),
    CanId::standard(0x103),
    CanId::standard(0x104),
    CanId::extended(0x00000100),
    CanId::extended(0x00F004FE),
];

fn decode_floats(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Floats(*data);
    let raw = frame.volts_raw();
    let number = codec::float32_counts(raw, 10, 0, 1);
    let valid = number != INVALID && codec::float32_order(raw) >= -1 && codec::float32_order(raw) <= 1148846080;
    readings.put(source, Value::BatteryVoltage, if valid { number } else { 0 }, valid);
    let raw = frame.amps_raw();
    let number = codec::float32_counts(raw, -20, 5, 2);
    let valid = number != INVALID && codec::float32_order(raw) >= -1140449281 && codec::float32_order(raw) <= 1140465664;
    readings.put(source, Value::BatteryCurrent, if valid { number } else { 0 }, valid);
}

fn decode_double(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Double(*data);
    let raw = frame.rpm_raw();
    let number = codec::float64_counts(raw, 1, 0, 2);
    let valid = number != INVALID;
    readings.put(source, Value::MotorSpeed, if valid { number.abs() } else { 0 }, valid);
}

fn decode_pages(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Pages(*data);
    if matches!(frame.page_raw(), 0..=0 | 3..=5) {
    let raw = frame.soc_raw();
    readings.put(source, Value::BatterySoc, ((raw as i64) * 1568627451).div_euclid(400000000) as i32, raw <= 254);
    }
    if frame.page_raw() == 1 && matches!(frame.half_raw(), 2..=3 | 9..=9) {
    let raw = frame.cell_raw();
    readings.put(source, Value::BatteryCellMax, raw as i32, raw <= 65000);
    }
    if frame.page_raw() == 1 && matches!(frame.half_raw(), 4..=15) {
    let raw = frame.warm_raw();
    readings.put(source, Value::BatteryTemperatureMax, raw as i32, true);
    }
}

fn decode_wide(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Wide(*data);
    let raw = frame.odometer_raw();
    readings.put(source, Value::VehicleOdometer, ((raw as i64).wrapping_mul(1).wrapping_add(0)).div_euclid(1000) as i32, raw <= 4000000000);
}

fn decode_long(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Long(*data);
    let raw = frame.speed_raw();
    readings.put(source, Value::VehicleSpeed, ((raw as i64) * 499999989).div_euclid(195312500) as i32, raw <= 25000);
    // The factor as a short fraction: at most 3.7e-8 counts off.
    let raw = frame.power_raw();
    readings.put(source, Value::MotorPower, ((raw as i64).wrapping_mul(5000).wrapping_add(-163760044)).div_euclid(4094001) as i32, raw >= -81847267 && raw <= 81912772);
}

fn decode_eec1(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Eec1(*data);
    let raw = frame.torque_raw();
    readings.put(source, Value::MotorTorque, (raw as i32) * 10 - 1250, raw <= 250);
    readings.put(source, Value::MotorAlarms, (matches!(frame.overheat_raw(), 1) as i32) << 0 | (matches!(frame.overheat_raw(), 2 | 3) as i32) << 1 | (matches!(frame.leak_raw(), -4 | 3) as i32) << 2, true);
}

static DECODERS: [fn(u8, &[u8; 8], &mut Readings); 6] = [
    decode_floats,
    decode_double,
    decode_pages,
    decode_wide,
    decode_long,
    decode_eec1,
];

fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    if let Some(decode) = DECODERS.get(index as usize) {
        decode(index, data, readings);
    }
}

fn encode(_index: u8, _values: &Readings) -> [u8; 8] {
    [0; 8]
}

/// Wide (宽).
pub static VEHICLE: Vehicle = Vehicle {
    name: "wide",
    zh: "宽",
    en: "Wide",
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
