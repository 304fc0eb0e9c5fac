//! Vehicle `example`: Example vehicle (纯电动汽车).
//!
//! Generated from `vehicles/example/example.dbc` and `vehicles/example/vehicle.toml`; refresh with `cargo xtask codegen`.

use crate::checksum::{Checksum, ChecksumKind};
use crate::codec::{self, Got, LifeKind, MessageInfo, Mux, Order, Scale, SignalInfo};
use crate::frame::CanId;
use crate::model::{INVALID, Readings, Severity, Value};
use crate::stream::{Bound, Cell, Stream};
use crate::vehicle::{FaultText, HvOffRule, Life, LimpRule, Node, NodeName, Rules, RxMessage, TxMessage, Vehicle};

/// Identifiers.
pub mod id {
    use crate::frame::CanId;

    /// Drive.
    pub const DRIVE: CanId = CanId::standard(0x120);
    /// Motor.
    pub const MOTOR: CanId = CanId::standard(0x128);
    /// Pack.
    pub const PACK: CanId = CanId::standard(0x240);
    /// PackDetails.
    pub const PACK_DETAILS: CanId = CanId::standard(0x248);
    /// Converter.
    pub const CONVERTER: CanId = CanId::standard(0x350);
    /// Panel.
    pub const PANEL: CanId = CanId::standard(0x3A0);
}

/// Drive (120) from Controller, every 20 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drive(pub [u8; 8]);

impl Default for Drive {
    fn default() -> Self { Self::new() }
}

impl Drive {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `speed` as sent: 16 bits down from bit 7.
    #[inline(always)]
    pub const fn speed_raw(self) -> u16 { u16::from_be_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/100 km/h, 0 to 16000; `None` if not valid.
    #[inline(always)]
    pub const fn speed(self) -> Option<i32> {
        let raw = self.speed_raw();
        if raw <= 16000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_speed_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[0] = (raw >> 8) as u8;
        self
    }

    /// Returns `gear` as sent: 3 bits from bit 16.
    #[inline(always)]
    pub const fn gear_raw(self) -> u8 { self.0[2] & 0x07 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn gear(self) -> Option<i32> {
        let raw = self.gear_raw();
        if raw <= 3 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `gear` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_gear_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xF8 | raw & 0x07;
        self
    }

    /// Returns `ready` as sent: 1 bit from bit 19.
    #[inline(always)]
    pub const fn ready_raw(self) -> u8 { self.0[2] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn ready(self) -> Option<i32> {
        let raw = self.ready_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `ready` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_ready_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `torque_limited` as sent: 1 bit from bit 20.
    #[inline(always)]
    pub const fn torque_limited_raw(self) -> u8 { self.0[2] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn torque_limited(self) -> Option<i32> {
        let raw = self.torque_limited_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `torque_limited` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_torque_limited_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `foot_brake` as sent: 1 bit from bit 21.
    #[inline(always)]
    pub const fn foot_brake_raw(self) -> u8 { self.0[2] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn foot_brake(self) -> Option<i32> {
        let raw = self.foot_brake_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `foot_brake` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_foot_brake_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `accelerator` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn accelerator_raw(self) -> u8 { self.0[3] }
    /// Returns the value in 1/2 %, 0 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn accelerator(self) -> Option<i32> {
        let raw = self.accelerator_raw();
        if raw <= 200 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `accelerator` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_accelerator_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `fault_level` as sent: 2 bits from bit 32.
    #[inline(always)]
    pub const fn fault_level_raw(self) -> u8 { self.0[4] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn fault_level(self) -> Option<i32> {
        let raw = self.fault_level_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `fault_code` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn fault_code_raw(self) -> u8 { self.0[5] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn fault_code(self) -> Option<i32> {
        let raw = self.fault_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_code_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `life` as sent: 4 bits from bit 48.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[6] & 0x0F }
    /// Returns the value, 0 to 15; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF0 | raw & 0x0F;
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

/// Motor (128) from Inverter, every 50 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Motor(pub [u8; 8]);

impl Default for Motor {
    fn default() -> Self { Self::new() }
}

impl Motor {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `speed` as sent: 16 bits down from bit 7.
    #[inline(always)]
    pub const fn speed_raw(self) -> i16 { (u16::from_be_bytes([self.0[0], self.0[1]])) as i16 }
    /// Returns the value in rpm, -12000 to 12000; `None` if not valid.
    #[inline(always)]
    pub const fn speed(self) -> Option<i32> {
        let raw = self.speed_raw();
        if raw >= -12000 && raw <= 12000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_speed_raw(mut self, raw: i16) -> Self {
        self.0[1] = raw as u8;
        self.0[0] = ((raw as u16) >> 8) as u8;
        self
    }

    /// Returns `torque` as sent: 12 bits down from bit 23.
    #[inline(always)]
    pub const fn torque_raw(self) -> i16 { ((((self.0[3] >> 4) as u16 | (self.0[2] as u16) << 4) << 4) as i16) >> 4 }
    /// Returns the value in 1/4 Nm, -1600 to 1600; `None` if not valid.
    #[inline(always)]
    pub const fn torque(self) -> Option<i32> {
        let raw = self.torque_raw();
        if raw >= -1600 && raw <= 1600 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `torque` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_torque_raw(mut self, raw: i16) -> Self {
        self.0[3] = self.0[3] & 0x0F | ((raw as u8) & 0x0F) << 4;
        self.0[2] = ((raw as u16) >> 4) as u8;
        self
    }

    /// Returns `motor_temperature` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn motor_temperature_raw(self) -> u8 { self.0[4] }
    /// Returns the value in °C, -50 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn motor_temperature(self) -> Option<i32> {
        let raw = self.motor_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 50) } else { None }
    }
    /// Returns the frame with `motor_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_temperature_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `inverter_temperature` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn inverter_temperature_raw(self) -> u8 { self.0[5] }
    /// Returns the value in °C, -50 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn inverter_temperature(self) -> Option<i32> {
        let raw = self.inverter_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 50) } else { None }
    }
    /// Returns the frame with `inverter_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_inverter_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `fault_code` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn fault_code_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn fault_code(self) -> Option<i32> {
        let raw = self.fault_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_code_raw(mut self, raw: u8) -> Self {
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

/// Pack (240) from Battery, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pack(pub [u8; 8]);

impl Default for Pack {
    fn default() -> Self { Self::new() }
}

impl Pack {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `voltage` as sent: 16 bits down from bit 7.
    #[inline(always)]
    pub const fn voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn voltage(self) -> Option<i32> {
        let raw = self.voltage_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_voltage_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[0] = (raw >> 8) as u8;
        self
    }

    /// Returns `current` as sent: 16 bits down from bit 23.
    #[inline(always)]
    pub const fn current_raw(self) -> i16 { (u16::from_be_bytes([self.0[2], self.0[3]])) as i16 }
    /// Returns the value in 1/10 A, -5000 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn current(self) -> Option<i32> {
        let raw = self.current_raw();
        if raw >= -5000 && raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_current_raw(mut self, raw: i16) -> Self {
        self.0[3] = raw as u8;
        self.0[2] = ((raw as u16) >> 8) as u8;
        self
    }

    /// Returns `soc` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn soc_raw(self) -> u8 { self.0[4] }
    /// Returns the value in 1/2 %, 0 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn soc(self) -> Option<i32> {
        let raw = self.soc_raw();
        if raw <= 200 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `fault_level` as sent: 2 bits from bit 40.
    #[inline(always)]
    pub const fn fault_level_raw(self) -> u8 { self.0[5] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn fault_level(self) -> Option<i32> {
        let raw = self.fault_level_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `contactor` as sent: 2 bits from bit 42.
    #[inline(always)]
    pub const fn contactor_raw(self) -> u8 { self.0[5] >> 2 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn contactor(self) -> Option<i32> {
        let raw = self.contactor_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `contactor` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_contactor_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `life` as sent: 4 bits from bit 48.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[6] & 0x0F }
    /// Returns the value, 0 to 15; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF0 | raw & 0x0F;
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

/// PackDetails (248) from Battery, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PackDetails(pub [u8; 8]);

impl Default for PackDetails {
    fn default() -> Self { Self::new() }
}

impl PackDetails {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `page` as sent: 2 bits from bit 0.
    #[inline(always)]
    pub const fn page_raw(self) -> u8 { self.0[0] & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn page(self) -> Option<i32> {
        let raw = self.page_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `page` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_page_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `max_cell_voltage` as sent: 16 bits down from bit 15, only while `page` is 0.
    #[inline(always)]
    pub const fn max_cell_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[1], self.0[2]]) }
    /// Returns the value in mV, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn max_cell_voltage(self) -> Option<i32> {
        let raw = self.max_cell_voltage_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_cell_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_cell_voltage_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `min_cell_voltage` as sent: 16 bits down from bit 31, only while `page` is 0.
    #[inline(always)]
    pub const fn min_cell_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in mV, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn min_cell_voltage(self) -> Option<i32> {
        let raw = self.min_cell_voltage_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_cell_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_cell_voltage_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_temperature` as sent: 8 bits from bit 8, only while `page` is 1.
    #[inline(always)]
    pub const fn max_temperature_raw(self) -> u8 { self.0[1] }
    /// Returns the value in °C, -50 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature(self) -> Option<i32> {
        let raw = self.max_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 50) } else { None }
    }
    /// Returns the frame with `max_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `min_temperature` as sent: 8 bits from bit 16, only while `page` is 1.
    #[inline(always)]
    pub const fn min_temperature_raw(self) -> u8 { self.0[2] }
    /// Returns the value in °C, -50 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature(self) -> Option<i32> {
        let raw = self.min_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 50) } else { None }
    }
    /// Returns the frame with `min_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `balancing` as sent: 1 bit from bit 24, only while `page` is 1.
    #[inline(always)]
    pub const fn balancing_raw(self) -> u8 { self.0[3] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn balancing(self) -> Option<i32> {
        let raw = self.balancing_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `balancing` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_balancing_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `charge_limit` as sent: 12 bits down from bit 15, only while `page` is 2.
    #[inline(always)]
    pub const fn charge_limit_raw(self) -> u16 { (self.0[2] >> 4) as u16 | (self.0[1] as u16) << 4 }
    /// Returns the value in 1/10 A, 0 to 4000; `None` if not valid.
    #[inline(always)]
    pub const fn charge_limit(self) -> Option<i32> {
        let raw = self.charge_limit_raw();
        if raw <= 4000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `charge_limit` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_limit_raw(mut self, raw: u16) -> Self {
        self.0[2] = self.0[2] & 0x0F | ((raw as u8) & 0x0F) << 4;
        self.0[1] = (raw >> 4) as u8;
        self
    }

    /// Returns `discharge_limit` as sent: 12 bits down from bit 31, only while `page` is 2.
    #[inline(always)]
    pub const fn discharge_limit_raw(self) -> u16 { (self.0[4] >> 4) as u16 | (self.0[3] as u16) << 4 }
    /// Returns the value in 1/10 A, 0 to 4000; `None` if not valid.
    #[inline(always)]
    pub const fn discharge_limit(self) -> Option<i32> {
        let raw = self.discharge_limit_raw();
        if raw <= 4000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `discharge_limit` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_discharge_limit_raw(mut self, raw: u16) -> Self {
        self.0[4] = self.0[4] & 0x0F | ((raw as u8) & 0x0F) << 4;
        self.0[3] = (raw >> 4) as u8;
        self
    }

    /// Returns `health` as sent: 8 bits from bit 40, only while `page` is 2.
    #[inline(always)]
    pub const fn health_raw(self) -> u8 { self.0[5] }
    /// Returns the value in 1/2 %, 0 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn health(self) -> Option<i32> {
        let raw = self.health_raw();
        if raw <= 200 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `health` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_health_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `fault_code` as sent: 8 bits from bit 48, only while `page` is 2.
    #[inline(always)]
    pub const fn fault_code_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn fault_code(self) -> Option<i32> {
        let raw = self.fault_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_code_raw(mut self, raw: u8) -> Self {
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

/// Converter (350) from Converter, every 200 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Converter(pub [u8; 8]);

impl Default for Converter {
    fn default() -> Self { Self::new() }
}

impl Converter {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `state` as sent: 2 bits from bit 0.
    #[inline(always)]
    pub const fn state_raw(self) -> u8 { self.0[0] & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn state(self) -> Option<i32> {
        let raw = self.state_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_state_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `output_voltage` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn output_voltage_raw(self) -> u8 { self.0[1] }
    /// Returns the value in 1/10 V, 0 to 250; `None` if not valid.
    #[inline(always)]
    pub const fn output_voltage(self) -> Option<i32> {
        let raw = self.output_voltage_raw();
        if raw <= 250 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_voltage_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `output_current` as sent: 16 bits down from bit 23.
    #[inline(always)]
    pub const fn output_current_raw(self) -> i16 { (u16::from_be_bytes([self.0[2], self.0[3]])) as i16 }
    /// Returns the value in 1/10 A, -2000 to 2000; `None` if not valid.
    #[inline(always)]
    pub const fn output_current(self) -> Option<i32> {
        let raw = self.output_current_raw();
        if raw >= -2000 && raw <= 2000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_current_raw(mut self, raw: i16) -> Self {
        self.0[3] = raw as u8;
        self.0[2] = ((raw as u16) >> 8) as u8;
        self
    }

    /// Returns `temperature` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn temperature_raw(self) -> u8 { self.0[4] }
    /// Returns the value in °C, -50 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn temperature(self) -> Option<i32> {
        let raw = self.temperature_raw();
        if raw <= 250 { Some(raw as i32 - 50) } else { None }
    }
    /// Returns the frame with `temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `checksum` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn checksum_raw(self) -> u8 { self.0[5] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn checksum(self) -> Option<i32> {
        let raw = self.checksum_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `checksum` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_checksum_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }
}

/// Panel (3A0) from Cluster, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Panel(pub [u8; 8]);

impl Default for Panel {
    fn default() -> Self { Self::new() }
}

impl Panel {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `odometer` as sent: 24 bits down from bit 7.
    #[inline(always)]
    pub const fn odometer_raw(self) -> u32 { self.0[2] as u32 | (self.0[1] as u32) << 8 | (self.0[0] as u32) << 16 }
    /// Returns the value in 1/8 km, 0 to 15999992; `None` if not valid.
    #[inline(always)]
    pub const fn odometer(self) -> Option<i32> {
        let raw = self.odometer_raw();
        if raw <= 15999992 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `odometer` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_odometer_raw(mut self, raw: u32) -> Self {
        self.0[2] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self.0[0] = (raw >> 16) as u8;
        self
    }

    /// Returns `key` as sent: 2 bits from bit 24.
    #[inline(always)]
    pub const fn key_raw(self) -> u8 { self.0[3] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn key(self) -> Option<i32> {
        let raw = self.key_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `key` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_key_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `driver_left` as sent: 1 bit from bit 26.
    #[inline(always)]
    pub const fn driver_left_raw(self) -> u8 { self.0[3] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn driver_left(self) -> Option<i32> {
        let raw = self.driver_left_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `driver_left` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_driver_left_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `life` as sent: 4 bits from bit 48.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[6] & 0x0F }
    /// Returns the value, 0 to 15; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF0 | raw & 0x0F;
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

fn get_drive(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Drive(data);
    Some(match index {
        0 => (frame.speed_raw() as i64, frame.speed().map(|value| value as i64)),
        1 => (frame.gear_raw() as i64, frame.gear().map(|value| value as i64)),
        2 => (frame.ready_raw() as i64, frame.ready().map(|value| value as i64)),
        3 => (frame.torque_limited_raw() as i64, frame.torque_limited().map(|value| value as i64)),
        4 => (frame.foot_brake_raw() as i64, frame.foot_brake().map(|value| value as i64)),
        5 => (frame.accelerator_raw() as i64, frame.accelerator().map(|value| value as i64)),
        6 => (frame.fault_level_raw() as i64, frame.fault_level().map(|value| value as i64)),
        7 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        8 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        9 => (frame.checksum_raw() as i64, frame.checksum().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_drive(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Drive(data);
    match index {
        0 => frame.with_speed_raw(raw as u16).0,
        1 => frame.with_gear_raw(raw as u8).0,
        2 => frame.with_ready_raw(raw as u8).0,
        3 => frame.with_torque_limited_raw(raw as u8).0,
        4 => frame.with_foot_brake_raw(raw as u8).0,
        5 => frame.with_accelerator_raw(raw as u8).0,
        6 => frame.with_fault_level_raw(raw as u8).0,
        7 => frame.with_fault_code_raw(raw as u8).0,
        8 => frame.with_life_raw(raw as u8).0,
        9 => frame.with_checksum_raw(raw as u8).0,
        _ => data,
    }
}

fn get_motor(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Motor(data);
    Some(match index {
        0 => (frame.speed_raw() as i64, frame.speed().map(|value| value as i64)),
        1 => (frame.torque_raw() as i64, frame.torque().map(|value| value as i64)),
        2 => (frame.motor_temperature_raw() as i64, frame.motor_temperature().map(|value| value as i64)),
        3 => (frame.inverter_temperature_raw() as i64, frame.inverter_temperature().map(|value| value as i64)),
        4 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        5 => (frame.checksum_raw() as i64, frame.checksum().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_motor(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Motor(data);
    match index {
        0 => frame.with_speed_raw(raw as i16).0,
        1 => frame.with_torque_raw(raw as i16).0,
        2 => frame.with_motor_temperature_raw(raw as u8).0,
        3 => frame.with_inverter_temperature_raw(raw as u8).0,
        4 => frame.with_fault_code_raw(raw as u8).0,
        5 => frame.with_checksum_raw(raw as u8).0,
        _ => data,
    }
}

fn get_pack(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Pack(data);
    Some(match index {
        0 => (frame.voltage_raw() as i64, frame.voltage().map(|value| value as i64)),
        1 => (frame.current_raw() as i64, frame.current().map(|value| value as i64)),
        2 => (frame.soc_raw() as i64, frame.soc().map(|value| value as i64)),
        3 => (frame.fault_level_raw() as i64, frame.fault_level().map(|value| value as i64)),
        4 => (frame.contactor_raw() as i64, frame.contactor().map(|value| value as i64)),
        5 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        6 => (frame.checksum_raw() as i64, frame.checksum().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_pack(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Pack(data);
    match index {
        0 => frame.with_voltage_raw(raw as u16).0,
        1 => frame.with_current_raw(raw as i16).0,
        2 => frame.with_soc_raw(raw as u8).0,
        3 => frame.with_fault_level_raw(raw as u8).0,
        4 => frame.with_contactor_raw(raw as u8).0,
        5 => frame.with_life_raw(raw as u8).0,
        6 => frame.with_checksum_raw(raw as u8).0,
        _ => data,
    }
}

fn get_pack_details(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = PackDetails(data);
    Some(match index {
        0 => (frame.page_raw() as i64, frame.page().map(|value| value as i64)),
        1 => (frame.max_cell_voltage_raw() as i64, frame.max_cell_voltage().map(|value| value as i64)),
        2 => (frame.min_cell_voltage_raw() as i64, frame.min_cell_voltage().map(|value| value as i64)),
        3 => (frame.max_temperature_raw() as i64, frame.max_temperature().map(|value| value as i64)),
        4 => (frame.min_temperature_raw() as i64, frame.min_temperature().map(|value| value as i64)),
        5 => (frame.balancing_raw() as i64, frame.balancing().map(|value| value as i64)),
        6 => (frame.charge_limit_raw() as i64, frame.charge_limit().map(|value| value as i64)),
        7 => (frame.discharge_limit_raw() as i64, frame.discharge_limit().map(|value| value as i64)),
        8 => (frame.health_raw() as i64, frame.health().map(|value| value as i64)),
        9 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        10 => (frame.checksum_raw() as i64, frame.checksum().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_pack_details(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = PackDetails(data);
    match index {
        0 => frame.with_page_raw(raw as u8).0,
        1 => frame.with_max_cell_voltage_raw(raw as u16).0,
        2 => frame.with_min_cell_voltage_raw(raw as u16).0,
        3 => frame.with_max_temperature_raw(raw as u8).0,
        4 => frame.with_min_temperature_raw(raw as u8).0,
        5 => frame.with_balancing_raw(raw as u8).0,
        6 => frame.with_charge_limit_raw(raw as u16).0,
        7 => frame.with_discharge_limit_raw(raw as u16).0,
        8 => frame.with_health_raw(raw as u8).0,
        9 => frame.with_fault_code_raw(raw as u8).0,
        10 => frame.with_checksum_raw(raw as u8).0,
        _ => data,
    }
}

fn get_converter(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Converter(data);
    Some(match index {
        0 => (frame.state_raw() as i64, frame.state().map(|value| value as i64)),
        1 => (frame.output_voltage_raw() as i64, frame.output_voltage().map(|value| value as i64)),
        2 => (frame.output_current_raw() as i64, frame.output_current().map(|value| value as i64)),
        3 => (frame.temperature_raw() as i64, frame.temperature().map(|value| value as i64)),
        4 => (frame.checksum_raw() as i64, frame.checksum().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_converter(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Converter(data);
    match index {
        0 => frame.with_state_raw(raw as u8).0,
        1 => frame.with_output_voltage_raw(raw as u8).0,
        2 => frame.with_output_current_raw(raw as i16).0,
        3 => frame.with_temperature_raw(raw as u8).0,
        4 => frame.with_checksum_raw(raw as u8).0,
        _ => data,
    }
}

fn get_panel(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Panel(data);
    Some(match index {
        0 => (frame.odometer_raw() as i64, frame.odometer().map(|value| value as i64)),
        1 => (frame.key_raw() as i64, frame.key().map(|value| value as i64)),
        2 => (frame.driver_left_raw() as i64, frame.driver_left().map(|value| value as i64)),
        3 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        4 => (frame.checksum_raw() as i64, frame.checksum().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_panel(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Panel(data);
    match index {
        0 => frame.with_odometer_raw(raw as u32).0,
        1 => frame.with_key_raw(raw as u8).0,
        2 => frame.with_driver_left_raw(raw as u8).0,
        3 => frame.with_life_raw(raw as u8).0,
        4 => frame.with_checksum_raw(raw as u8).0,
        _ => data,
    }
}

static DRIVE_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "speed", start: 7, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "km/h", range: (0, 16000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "gear", start: 16, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "P"), (1, "R"), (2, "N"), (3, "D")] },
    SignalInfo { name: "ready", start: 19, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "torque_limited", start: 20, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "foot_brake", start: 21, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "accelerator", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 2 }, unit: "%", range: (0, 200), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "fault_level", start: 32, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "warn"), (2, "derate"), (3, "stop")] },
    SignalInfo { name: "fault_code", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "life", start: 48, length: 4, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 15), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::Nibble), values: &[] },
    SignalInfo { name: "checksum", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static MOTOR_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "speed", start: 7, length: 16, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "rpm", range: (-12000, 12000), start_raw: 0, invalid_raw: Some(-32768), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "torque", start: 23, length: 12, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 4 }, unit: "Nm", range: (-1600, 1600), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "motor_temperature", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -50, den: 1 }, unit: "°C", range: (0, 250), start_raw: 50, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "inverter_temperature", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -50, den: 1 }, unit: "°C", range: (0, 250), start_raw: 50, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "fault_code", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "checksum", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static PACK_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "voltage", start: 7, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 5000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "current", start: 23, length: 16, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (-5000, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "soc", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 2 }, unit: "%", range: (0, 200), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "fault_level", start: 40, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "warn"), (2, "derate"), (3, "stop")] },
    SignalInfo { name: "contactor", start: 42, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed"), (2, "welded"), (3, "fault")] },
    SignalInfo { name: "life", start: 48, length: 4, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 15), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::Nibble), values: &[] },
    SignalInfo { name: "checksum", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static PACK_DETAILS_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "page", start: 0, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Selector, life: None, values: &[] },
    SignalInfo { name: "max_cell_voltage", start: 15, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "mV", range: (0, 5000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::When(0), life: None, values: &[] },
    SignalInfo { name: "min_cell_voltage", start: 31, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "mV", range: (0, 5000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::When(0), life: None, values: &[] },
    SignalInfo { name: "max_temperature", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -50, den: 1 }, unit: "°C", range: (0, 250), start_raw: 50, invalid_raw: Some(255), mux: Mux::When(1), life: None, values: &[] },
    SignalInfo { name: "min_temperature", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -50, den: 1 }, unit: "°C", range: (0, 250), start_raw: 50, invalid_raw: Some(255), mux: Mux::When(1), life: None, values: &[] },
    SignalInfo { name: "balancing", start: 24, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::When(1), life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "charge_limit", start: 15, length: 12, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (0, 4000), start_raw: 0, invalid_raw: None, mux: Mux::When(2), life: None, values: &[] },
    SignalInfo { name: "discharge_limit", start: 31, length: 12, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (0, 4000), start_raw: 0, invalid_raw: None, mux: Mux::When(2), life: None, values: &[] },
    SignalInfo { name: "health", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 2 }, unit: "%", range: (0, 200), start_raw: 0, invalid_raw: Some(255), mux: Mux::When(2), life: None, values: &[] },
    SignalInfo { name: "fault_code", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::When(2), life: None, values: &[] },
    SignalInfo { name: "checksum", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static CONVERTER_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "state", start: 0, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "stopped"), (1, "running"), (2, "fault")] },
    SignalInfo { name: "output_voltage", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 250), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "output_current", start: 23, length: 16, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (-2000, 2000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "temperature", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -50, den: 1 }, unit: "°C", range: (0, 250), start_raw: 50, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "checksum", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static PANEL_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "odometer", start: 7, length: 24, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 8 }, unit: "km", range: (0, 15999992), start_raw: 0, invalid_raw: Some(16777215), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "key", start: 24, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "lock"), (1, "acc"), (2, "on"), (3, "start")] },
    SignalInfo { name: "driver_left", start: 26, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "life", start: 48, length: 4, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 15), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::Nibble), values: &[] },
    SignalInfo { name: "checksum", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

/// Every message of the vehicle, in the order of the DBC: for tools.
pub static MESSAGES: &[MessageInfo] = &[
    MessageInfo { id: CanId::standard(0x120), name: "Drive", sender: "Controller", len: 8, cycle_ms: 20, slow_cycle_ms: 20, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_drive, set: set_drive, signals: DRIVE_SIGNALS },
    MessageInfo { id: CanId::standard(0x128), name: "Motor", sender: "Inverter", len: 8, cycle_ms: 50, slow_cycle_ms: 50, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_motor, set: set_motor, signals: MOTOR_SIGNALS },
    MessageInfo { id: CanId::standard(0x240), name: "Pack", sender: "Battery", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_pack, set: set_pack, signals: PACK_SIGNALS },
    MessageInfo { id: CanId::standard(0x248), name: "PackDetails", sender: "Battery", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_pack_details, set: set_pack_details, signals: PACK_DETAILS_SIGNALS },
    MessageInfo { id: CanId::standard(0x350), name: "Converter", sender: "Converter", len: 6, cycle_ms: 200, slow_cycle_ms: 200, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_converter, set: set_converter, signals: CONVERTER_SIGNALS },
    MessageInfo { id: CanId::standard(0x3A0), name: "Panel", sender: "Cluster", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_panel, set: set_panel, signals: PANEL_SIGNALS },
];

static RX: &[RxMessage] = &[
    RxMessage { id: CanId::standard(0x120), name: "Drive", node: Node::Vcu, len: 8, cycle_ms: 20, timeout_ms: 500, life: Some(Life { byte: 6, mask: 0x0F }), checksum: Some(Checksum { byte: 7, len: 8, kind: ChecksumKind::Crc8SaeJ1850 }), expected: true, vital: false },
    RxMessage { id: CanId::standard(0x128), name: "Motor", node: Node::Inverter, len: 8, cycle_ms: 50, timeout_ms: 500, life: None, checksum: Some(Checksum { byte: 7, len: 8, kind: ChecksumKind::Sum8 }), expected: true, vital: false },
    RxMessage { id: CanId::standard(0x240), name: "Pack", node: Node::Bms, len: 8, cycle_ms: 100, timeout_ms: 500, life: Some(Life { byte: 6, mask: 0x0F }), checksum: Some(Checksum { byte: 7, len: 8, kind: ChecksumKind::Crc8SaeJ1850 }), expected: true, vital: false },
    RxMessage { id: CanId::standard(0x248), name: "PackDetails", node: Node::Bms, len: 8, cycle_ms: 100, timeout_ms: 500, life: None, checksum: Some(Checksum { byte: 7, len: 8, kind: ChecksumKind::Crc8SaeJ1850 }), expected: true, vital: false },
    RxMessage { id: CanId::standard(0x350), name: "Converter", node: Node::Dcdc, len: 6, cycle_ms: 200, timeout_ms: 1000, life: None, checksum: Some(Checksum { byte: 5, len: 6, kind: ChecksumKind::Xor8 }), expected: true, vital: false },
];

static TX: &[TxMessage] = &[
    TxMessage { id: CanId::standard(0x3A0), name: "Panel", cycle_ms: 500, life: Some(Life { byte: 6, mask: 0x0F }), checksum: Some(Checksum { byte: 7, len: 8, kind: ChecksumKind::Crc8SaeJ1850 }) },
];

/// Texts of the fault codes, sorted by source and code.
pub static FAULTS: &[FaultText] = &[
    FaultText { source: Node::Vcu, code: 1, severity: Some(Severity::Warn), fire: false, limps: false, zh: "动力电池电量低", en: "Battery charge low" },
    FaultText { source: Node::Vcu, code: 2, severity: Some(Severity::Derate), fire: false, limps: false, zh: "电机温度高", en: "Motor hot: power reduced" },
    FaultText { source: Node::Vcu, code: 3, severity: Some(Severity::Stop), fire: false, limps: false, zh: "绝缘故障", en: "Insulation fault" },
    FaultText { source: Node::Inverter, code: 1, severity: Some(Severity::Derate), fire: false, limps: false, zh: "电机控制器温度高", en: "Inverter hot" },
    FaultText { source: Node::Inverter, code: 2, severity: Some(Severity::Stop), fire: false, limps: false, zh: "电机系统故障", en: "Resolver lost" },
    FaultText { source: Node::Bms, code: 1, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体压差大", en: "Cells uneven" },
    FaultText { source: Node::Bms, code: 2, severity: Some(Severity::Derate), fire: false, limps: false, zh: "单体欠压", en: "Cell voltage low" },
    FaultText { source: Node::Bms, code: 3, severity: Some(Severity::Stop), fire: false, limps: false, zh: "单体过压", en: "Cell voltage high" },
];

static NODES: &[NodeName] = &[
    NodeName { node: Node::Vcu, zh: "整车控制器", en: "Vehicle controller" },
    NodeName { node: Node::Inverter, zh: "电机控制器", en: "Inverter" },
    NodeName { node: Node::Bms, zh: "电池系统", en: "Battery" },
    NodeName { node: Node::Dcdc, zh: "DCDC", en: "DC/DC converter" },
    NodeName { node: Node::Cluster, zh: "仪表", en: "Cluster" },
];

static STREAMS: &[Stream] = &[
];

static IDS: &[CanId] = &[
    CanId::standard(0x120),
    CanId::standard(0x128),
    CanId::standard(0x240),
    CanId::standard(0x248),
    CanId::standard(0x350),
];

fn decode_drive(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Drive(*data);
    let raw = frame.speed_raw();
    readings.put(source, Value::VehicleSpeed, codec::floor_div((raw as i32) * 64, 25), raw <= 16000);
    let state = STATES_0[(frame.gear_raw() & 7) as usize];
    readings.put(source, Value::VehicleGear, state, state != INVALID);
    let raw = frame.ready_raw();
    readings.put(source, Value::VehicleReady, raw as i32, true);
    let raw = frame.fault_level_raw();
    readings.put(source, Value::VehicleFaultLevel, raw as i32, true);
    let raw = frame.fault_code_raw();
    readings.put(source, Value::VehicleFaultCode, raw as i32, true);
    let raw = frame.torque_limited_raw();
    readings.put(source, Value::VehicleTorqueLimited, raw as i32, true);
    let raw = frame.accelerator_raw();
    readings.put(source, Value::VehicleAccelerator, (raw as i32) * 5, raw <= 200);
    let raw = frame.foot_brake_raw();
    readings.put(source, Value::VehicleFootBrake, raw as i32, true);
}

fn decode_motor(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Motor(*data);
    let raw = frame.speed_raw();
    readings.put(source, Value::MotorSpeed, raw as i32, raw >= -12000 && raw <= 12000);
    let raw = frame.torque_raw();
    readings.put(source, Value::MotorTorque, ((raw as i32) * 5) >> 1, raw >= -1600 && raw <= 1600);
    let raw = frame.motor_temperature_raw();
    readings.put(source, Value::MotorTemperature, raw as i32 - 50, raw <= 250);
    let raw = frame.fault_code_raw();
    readings.put(source, Value::MotorFaultCode, raw as i32, true);
    let raw = frame.inverter_temperature_raw();
    readings.put(source, Value::InverterTemperature, raw as i32 - 50, raw <= 250);
}

fn decode_pack(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Pack(*data);
    let raw = frame.voltage_raw();
    readings.put(source, Value::BatteryVoltage, raw as i32, raw <= 5000);
    let raw = frame.current_raw();
    readings.put(source, Value::BatteryCurrent, raw as i32, raw >= -5000 && raw <= 5000);
    let raw = frame.soc_raw();
    readings.put(source, Value::BatterySoc, (raw as i32) * 5, raw <= 200);
    let raw = frame.fault_level_raw();
    readings.put(source, Value::BatteryFaultLevel, raw as i32, true);
    let raw = frame.contactor_raw();
    readings.put(source, Value::ContactorMain, raw as i32, true);
}

fn decode_pack_details(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = PackDetails(*data);
    if frame.page_raw() == 0 {
    let raw = frame.max_cell_voltage_raw();
    readings.put(source, Value::BatteryCellMax, raw as i32, raw <= 5000);
    let raw = frame.min_cell_voltage_raw();
    readings.put(source, Value::BatteryCellMin, raw as i32, raw <= 5000);
    }
    if frame.page_raw() == 1 {
    let raw = frame.max_temperature_raw();
    readings.put(source, Value::BatteryTemperatureMax, raw as i32 - 50, raw <= 250);
    let raw = frame.min_temperature_raw();
    readings.put(source, Value::BatteryTemperatureMin, raw as i32 - 50, raw <= 250);
    let raw = frame.balancing_raw();
    readings.put(source, Value::BatteryBalancing, raw as i32, true);
    }
    if frame.page_raw() == 2 {
    let raw = frame.fault_code_raw();
    readings.put(source, Value::BatteryFaultCode, raw as i32, true);
    let raw = frame.charge_limit_raw();
    readings.put(source, Value::BatteryChargeLimit, raw as i32, raw <= 4000);
    let raw = frame.discharge_limit_raw();
    readings.put(source, Value::BatteryDischargeLimit, raw as i32, raw <= 4000);
    let raw = frame.health_raw();
    readings.put(source, Value::BatteryHealth, (raw as i32) * 5, raw <= 200);
    }
}

fn decode_converter(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Converter(*data);
    let raw = frame.state_raw();
    readings.put(source, Value::DcdcState, raw as i32, raw <= 2);
    let raw = frame.output_voltage_raw();
    readings.put(source, Value::DcdcOutput, raw as i32, raw <= 250);
    let raw = frame.temperature_raw();
    readings.put(source, Value::DcdcTemperature, raw as i32 - 50, raw <= 250);
    let raw = frame.output_current_raw();
    readings.put(source, Value::DcdcCurrent, raw as i32, raw >= -2000 && raw <= 2000);
}

static STATES_0: [i32; 8] = [4, 2, 3, 1, INVALID, INVALID, INVALID, INVALID];

static DECODERS: [fn(u8, &[u8; 8], &mut Readings); 5] = [
    decode_drive,
    decode_motor,
    decode_pack,
    decode_pack_details,
    decode_converter,
];

fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    if let Some(decode) = DECODERS.get(index as usize) {
        decode(index, data, readings);
    }
}

fn encode_panel(values: &Readings) -> [u8; 8] {
    let frame = Panel::new();
    let frame = frame.with_odometer_raw(codec::known(values, Value::ClusterOdometer).map_or(16777215, |number| codec::scaled(number, 1, 0, 1, 0, 15999992) as u32));
    let frame = frame.with_key_raw(match codec::known(values, Value::BodyKey) { Some(0) => 0, Some(1) => 1, Some(2) => 2, Some(3) => 3, _ => 0 });
    let frame = frame.with_driver_left_raw(codec::known(values, Value::ClusterDriverLeft).map_or(0, |state| (state != 0) as u8));
    frame.0
}

fn encode(index: u8, values: &Readings) -> [u8; 8] {
    match index {
        0 => encode_panel(values),
        _ => [0; 8],
    }
}

/// Example vehicle (纯电动汽车).
pub static VEHICLE: Vehicle = Vehicle {
    name: "example",
    zh: "纯电动汽车",
    en: "Example vehicle",
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
