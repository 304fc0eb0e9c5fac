//! Vehicle `c5ev`: C5EV electric car (C5EV纯电动汽车).
//!
//! Generated from `vehicles/c5ev/c5ev.dbc` and `vehicles/c5ev/vehicle.toml`; refresh with `cargo xtask codegen`.

use crate::checksum::{Checksum, ChecksumKind};
use crate::codec::{self, Got, LifeKind, MessageInfo, Mux, Order, Scale, SignalInfo};
use crate::frame::CanId;
use crate::model::{INVALID, Readings, Severity, Value};
use crate::stream::{Bound, Cell, Stream};
use crate::vehicle::{FaultText, HvOffRule, Life, LimpRule, Node, NodeName, Rules, RxMessage, TxMessage, Vehicle};

/// Identifiers.
pub mod id {
    use crate::frame::CanId;

    /// VCUToBMS.
    pub const VCU_TO_BMS: CanId = CanId::extended(0x1807F427);
    /// BMSA.
    pub const BMSA: CanId = CanId::extended(0x182127F4);
    /// BMSB.
    pub const BMSB: CanId = CanId::extended(0x182227F4);
    /// BMSC.
    pub const BMSC: CanId = CanId::extended(0x182327F4);
    /// BMSD.
    pub const BMSD: CanId = CanId::extended(0x182427F4);
    /// ChargerTx.
    pub const CHARGER_TX: CanId = CanId::extended(0x1840FFE5);
    /// ChargerControl.
    pub const CHARGER_CONTROL: CanId = CanId::extended(0x1830E5F4);
    /// ChargerVoltageLimits.
    pub const CHARGER_VOLTAGE_LIMITS: CanId = CanId::extended(0x1820E5F4);
    /// ChargerCurrentLimits.
    pub const CHARGER_CURRENT_LIMITS: CanId = CanId::extended(0x1810E5F4);
    /// VCUToCluster.
    pub const VCU_TO_CLUSTER: CanId = CanId::extended(0x18C21727);
    /// VCUToMCU.
    pub const VCU_TO_MCU: CanId = CanId::extended(0x0801EF27);
}

/// VCUToBMS (1807F427) from VCU, every 200 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VcuToBms(pub [u8; 8]);

impl Default for VcuToBms {
    fn default() -> Self { Self::new() }
}

impl VcuToBms {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `relay_command` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn relay_command_raw(self) -> u8 { self.0[0] }
    /// Returns the value, 85 to 170; `None` if not valid.
    #[inline(always)]
    pub const fn relay_command(self) -> Option<i32> {
        let raw = self.relay_command_raw();
        if raw >= 85 && raw <= 170 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `relay_command` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_relay_command_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }
}

/// BMSA (182127F4) from BMS, every 200 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bmsa(pub [u8; 8]);

impl Default for Bmsa {
    fn default() -> Self { Self::new() }
}

impl Bmsa {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `soc` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn soc_raw(self) -> u8 { self.0[0] }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn soc(self) -> Option<i32> {
        let raw = self.soc_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `soh` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn soh_raw(self) -> u8 { self.0[1] }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn soh(self) -> Option<i32> {
        let raw = self.soh_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `soh` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soh_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `pack_current` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn pack_current_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 A, -5000 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn pack_current(self) -> Option<i32> {
        let raw = self.pack_current_raw();
        if raw <= 10000 { Some(raw as i32 - 5000) } else { None }
    }
    /// Returns the frame with `pack_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_current_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_discharge_current` as sent: 16 bits from bit 32.
    #[inline(always)]
    pub const fn max_discharge_current_raw(self) -> u16 { u16::from_le_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/10 A, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn max_discharge_current(self) -> Option<i32> {
        let raw = self.max_discharge_current_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_discharge_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_discharge_current_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_charge_current` as sent: 16 bits from bit 48.
    #[inline(always)]
    pub const fn max_charge_current_raw(self) -> u16 { u16::from_le_bytes([self.0[6], self.0[7]]) }
    /// Returns the value in 1/10 A, -5000 to 0; `None` if not valid.
    #[inline(always)]
    pub const fn max_charge_current(self) -> Option<i32> {
        let raw = self.max_charge_current_raw();
        if raw <= 5000 { Some(raw as i32 - 5000) } else { None }
    }
    /// Returns the frame with `max_charge_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_charge_current_raw(mut self, raw: u16) -> Self {
        self.0[6] = raw as u8;
        self.0[7] = (raw >> 8) as u8;
        self
    }
}

/// BMSB (182227F4) from BMS, every 200 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bmsb(pub [u8; 8]);

impl Default for Bmsb {
    fn default() -> Self { Self::new() }
}

impl Bmsb {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `pack_voltage` as sent: 16 bits down from bit 7.
    #[inline(always)]
    pub const fn pack_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn pack_voltage(self) -> Option<i32> {
        let raw = self.pack_voltage_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `pack_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_voltage_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[0] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_cell_voltage` as sent: 16 bits down from bit 23.
    #[inline(always)]
    pub const fn max_cell_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/1000 V, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn max_cell_voltage(self) -> Option<i32> {
        let raw = self.max_cell_voltage_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_cell_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_cell_voltage_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `min_cell_voltage` as sent: 16 bits down from bit 39.
    #[inline(always)]
    pub const fn min_cell_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/1000 V, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn min_cell_voltage(self) -> Option<i32> {
        let raw = self.min_cell_voltage_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_cell_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_cell_voltage_raw(mut self, raw: u16) -> Self {
        self.0[5] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
        self
    }

    /// Returns `balancing_fault` as sent: 1 bit from bit 49.
    #[inline(always)]
    pub const fn balancing_fault_raw(self) -> u8 { self.0[6] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn balancing_fault(self) -> Option<i32> {
        let raw = self.balancing_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `balancing_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_balancing_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `temperature_sensing_fault` as sent: 1 bit from bit 50.
    #[inline(always)]
    pub const fn temperature_sensing_fault_raw(self) -> u8 { self.0[6] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_sensing_fault(self) -> Option<i32> {
        let raw = self.temperature_sensing_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `temperature_sensing_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_sensing_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `voltage_sensing_fault` as sent: 1 bit from bit 51.
    #[inline(always)]
    pub const fn voltage_sensing_fault_raw(self) -> u8 { self.0[6] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn voltage_sensing_fault(self) -> Option<i32> {
        let raw = self.voltage_sensing_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `voltage_sensing_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_voltage_sensing_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `current_sensing_fault` as sent: 1 bit from bit 52.
    #[inline(always)]
    pub const fn current_sensing_fault_raw(self) -> u8 { self.0[6] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn current_sensing_fault(self) -> Option<i32> {
        let raw = self.current_sensing_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `current_sensing_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_current_sensing_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `vcu_lost` as sent: 1 bit from bit 53.
    #[inline(always)]
    pub const fn vcu_lost_raw(self) -> u8 { self.0[6] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn vcu_lost(self) -> Option<i32> {
        let raw = self.vcu_lost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `vcu_lost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vcu_lost_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `can_fault` as sent: 1 bit from bit 54.
    #[inline(always)]
    pub const fn can_fault_raw(self) -> u8 { self.0[6] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn can_fault(self) -> Option<i32> {
        let raw = self.can_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `can_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_can_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `self_check_passed` as sent: 1 bit from bit 55.
    #[inline(always)]
    pub const fn self_check_passed_raw(self) -> u8 { self.0[6] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn self_check_passed(self) -> Option<i32> {
        let raw = self.self_check_passed_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `self_check_passed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_self_check_passed_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `slave_8_lost` as sent: 1 bit from bit 56.
    #[inline(always)]
    pub const fn slave_8_lost_raw(self) -> u8 { self.0[7] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn slave_8_lost(self) -> Option<i32> {
        let raw = self.slave_8_lost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `slave_8_lost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_slave_8_lost_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `slave_7_lost` as sent: 1 bit from bit 57.
    #[inline(always)]
    pub const fn slave_7_lost_raw(self) -> u8 { self.0[7] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn slave_7_lost(self) -> Option<i32> {
        let raw = self.slave_7_lost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `slave_7_lost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_slave_7_lost_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `slave_6_lost` as sent: 1 bit from bit 58.
    #[inline(always)]
    pub const fn slave_6_lost_raw(self) -> u8 { self.0[7] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn slave_6_lost(self) -> Option<i32> {
        let raw = self.slave_6_lost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `slave_6_lost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_slave_6_lost_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `slave_5_lost` as sent: 1 bit from bit 59.
    #[inline(always)]
    pub const fn slave_5_lost_raw(self) -> u8 { self.0[7] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn slave_5_lost(self) -> Option<i32> {
        let raw = self.slave_5_lost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `slave_5_lost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_slave_5_lost_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `slave_4_lost` as sent: 1 bit from bit 60.
    #[inline(always)]
    pub const fn slave_4_lost_raw(self) -> u8 { self.0[7] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn slave_4_lost(self) -> Option<i32> {
        let raw = self.slave_4_lost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `slave_4_lost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_slave_4_lost_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `slave_3_lost` as sent: 1 bit from bit 61.
    #[inline(always)]
    pub const fn slave_3_lost_raw(self) -> u8 { self.0[7] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn slave_3_lost(self) -> Option<i32> {
        let raw = self.slave_3_lost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `slave_3_lost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_slave_3_lost_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `slave_2_lost` as sent: 1 bit from bit 62.
    #[inline(always)]
    pub const fn slave_2_lost_raw(self) -> u8 { self.0[7] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn slave_2_lost(self) -> Option<i32> {
        let raw = self.slave_2_lost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `slave_2_lost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_slave_2_lost_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `slave_1_lost` as sent: 1 bit from bit 63.
    #[inline(always)]
    pub const fn slave_1_lost_raw(self) -> u8 { self.0[7] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn slave_1_lost(self) -> Option<i32> {
        let raw = self.slave_1_lost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `slave_1_lost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_slave_1_lost_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// BMSC (182327F4) from BMS, every 200 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bmsc(pub [u8; 8]);

impl Default for Bmsc {
    fn default() -> Self { Self::new() }
}

impl Bmsc {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `mean_temperature` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn mean_temperature_raw(self) -> u8 { self.0[0] }
    /// Returns the value in °C, -50 to 150; `None` if not valid.
    #[inline(always)]
    pub const fn mean_temperature(self) -> Option<i32> {
        let raw = self.mean_temperature_raw();
        if raw <= 200 { Some(raw as i32 - 50) } else { None }
    }
    /// Returns the frame with `mean_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_mean_temperature_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `max_temperature` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn max_temperature_raw(self) -> u8 { self.0[1] }
    /// Returns the value in °C, -50 to 150; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature(self) -> Option<i32> {
        let raw = self.max_temperature_raw();
        if raw <= 200 { Some(raw as i32 - 50) } else { None }
    }
    /// Returns the frame with `max_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `min_temperature` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn min_temperature_raw(self) -> u8 { self.0[2] }
    /// Returns the value in °C, -50 to 150; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature(self) -> Option<i32> {
        let raw = self.min_temperature_raw();
        if raw <= 200 { Some(raw as i32 - 50) } else { None }
    }
    /// Returns the frame with `min_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `max_temperature_probe` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn max_temperature_probe_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 0 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_probe(self) -> Option<i32> {
        let raw = self.max_temperature_probe_raw();
        if raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_temperature_probe` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_probe_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `min_temperature_probe` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn min_temperature_probe_raw(self) -> u8 { self.0[4] }
    /// Returns the value, 0 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_probe(self) -> Option<i32> {
        let raw = self.min_temperature_probe_raw();
        if raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_temperature_probe` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_probe_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `cycles` as sent: 16 bits down from bit 47.
    #[inline(always)]
    pub const fn cycles_raw(self) -> u16 { u16::from_be_bytes([self.0[5], self.0[6]]) }
    /// Returns the value, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn cycles(self) -> Option<i32> {
        let raw = self.cycles_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `cycles` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cycles_raw(mut self, raw: u16) -> Self {
        self.0[6] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `precharge_fault` as sent: 1 bit from bit 56.
    #[inline(always)]
    pub const fn precharge_fault_raw(self) -> u8 { self.0[7] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn precharge_fault(self) -> Option<i32> {
        let raw = self.precharge_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `precharge_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_precharge_fault_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `negative_contactor` as sent: 1 bit from bit 57.
    #[inline(always)]
    pub const fn negative_contactor_raw(self) -> u8 { self.0[7] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn negative_contactor(self) -> Option<i32> {
        let raw = self.negative_contactor_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `negative_contactor` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_contactor_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `positive_contactor` as sent: 1 bit from bit 58.
    #[inline(always)]
    pub const fn positive_contactor_raw(self) -> u8 { self.0[7] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn positive_contactor(self) -> Option<i32> {
        let raw = self.positive_contactor_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `positive_contactor` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_contactor_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `charging` as sent: 1 bit from bit 59.
    #[inline(always)]
    pub const fn charging_raw(self) -> u8 { self.0[7] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn charging(self) -> Option<i32> {
        let raw = self.charging_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charging` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charging_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `charge_gun` as sent: 1 bit from bit 62.
    #[inline(always)]
    pub const fn charge_gun_raw(self) -> u8 { self.0[7] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn charge_gun(self) -> Option<i32> {
        let raw = self.charge_gun_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_gun` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_gun_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `positive_open_request` as sent: 1 bit from bit 63.
    #[inline(always)]
    pub const fn positive_open_request_raw(self) -> u8 { self.0[7] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn positive_open_request(self) -> Option<i32> {
        let raw = self.positive_open_request_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `positive_open_request` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_open_request_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// BMSD (182427F4) from BMS, every 200 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bmsd(pub [u8; 8]);

impl Default for Bmsd {
    fn default() -> Self { Self::new() }
}

impl Bmsd {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `cell_voltage_high_1` as sent: 1 bit from bit 0.
    #[inline(always)]
    pub const fn cell_voltage_high_1_raw(self) -> u8 { self.0[0] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn cell_voltage_high_1(self) -> Option<i32> {
        let raw = self.cell_voltage_high_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `cell_voltage_high_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cell_voltage_high_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `cell_voltage_low_1` as sent: 1 bit from bit 1.
    #[inline(always)]
    pub const fn cell_voltage_low_1_raw(self) -> u8 { self.0[0] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn cell_voltage_low_1(self) -> Option<i32> {
        let raw = self.cell_voltage_low_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `cell_voltage_low_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cell_voltage_low_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `pack_voltage_high_1` as sent: 1 bit from bit 2.
    #[inline(always)]
    pub const fn pack_voltage_high_1_raw(self) -> u8 { self.0[0] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn pack_voltage_high_1(self) -> Option<i32> {
        let raw = self.pack_voltage_high_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `pack_voltage_high_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_voltage_high_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `soc_low_1` as sent: 1 bit from bit 3.
    #[inline(always)]
    pub const fn soc_low_1_raw(self) -> u8 { self.0[0] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn soc_low_1(self) -> Option<i32> {
        let raw = self.soc_low_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `soc_low_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_low_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `discharge_current_high_1` as sent: 1 bit from bit 4.
    #[inline(always)]
    pub const fn discharge_current_high_1_raw(self) -> u8 { self.0[0] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn discharge_current_high_1(self) -> Option<i32> {
        let raw = self.discharge_current_high_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `discharge_current_high_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_discharge_current_high_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `regen_current_high_1` as sent: 1 bit from bit 5.
    #[inline(always)]
    pub const fn regen_current_high_1_raw(self) -> u8 { self.0[0] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn regen_current_high_1(self) -> Option<i32> {
        let raw = self.regen_current_high_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `regen_current_high_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_regen_current_high_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `temperature_high_1` as sent: 1 bit from bit 6.
    #[inline(always)]
    pub const fn temperature_high_1_raw(self) -> u8 { self.0[0] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_high_1(self) -> Option<i32> {
        let raw = self.temperature_high_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `temperature_high_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_high_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `temperature_low_1` as sent: 1 bit from bit 7.
    #[inline(always)]
    pub const fn temperature_low_1_raw(self) -> u8 { self.0[0] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_low_1(self) -> Option<i32> {
        let raw = self.temperature_low_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `temperature_low_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_low_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `cell_voltage_high_2` as sent: 1 bit from bit 8.
    #[inline(always)]
    pub const fn cell_voltage_high_2_raw(self) -> u8 { self.0[1] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn cell_voltage_high_2(self) -> Option<i32> {
        let raw = self.cell_voltage_high_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `cell_voltage_high_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cell_voltage_high_2_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `cell_voltage_low_2` as sent: 1 bit from bit 9.
    #[inline(always)]
    pub const fn cell_voltage_low_2_raw(self) -> u8 { self.0[1] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn cell_voltage_low_2(self) -> Option<i32> {
        let raw = self.cell_voltage_low_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `cell_voltage_low_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cell_voltage_low_2_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `pack_voltage_high_2` as sent: 1 bit from bit 10.
    #[inline(always)]
    pub const fn pack_voltage_high_2_raw(self) -> u8 { self.0[1] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn pack_voltage_high_2(self) -> Option<i32> {
        let raw = self.pack_voltage_high_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `pack_voltage_high_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_voltage_high_2_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `soc_low_2` as sent: 1 bit from bit 11.
    #[inline(always)]
    pub const fn soc_low_2_raw(self) -> u8 { self.0[1] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn soc_low_2(self) -> Option<i32> {
        let raw = self.soc_low_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `soc_low_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_low_2_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `discharge_current_high_2` as sent: 1 bit from bit 12.
    #[inline(always)]
    pub const fn discharge_current_high_2_raw(self) -> u8 { self.0[1] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn discharge_current_high_2(self) -> Option<i32> {
        let raw = self.discharge_current_high_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `discharge_current_high_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_discharge_current_high_2_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `regen_current_high_2` as sent: 1 bit from bit 13.
    #[inline(always)]
    pub const fn regen_current_high_2_raw(self) -> u8 { self.0[1] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn regen_current_high_2(self) -> Option<i32> {
        let raw = self.regen_current_high_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `regen_current_high_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_regen_current_high_2_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `temperature_high_2` as sent: 1 bit from bit 14.
    #[inline(always)]
    pub const fn temperature_high_2_raw(self) -> u8 { self.0[1] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_high_2(self) -> Option<i32> {
        let raw = self.temperature_high_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `temperature_high_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_high_2_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `temperature_low_2` as sent: 1 bit from bit 15.
    #[inline(always)]
    pub const fn temperature_low_2_raw(self) -> u8 { self.0[1] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_low_2(self) -> Option<i32> {
        let raw = self.temperature_low_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `temperature_low_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_low_2_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `self_check_fault` as sent: 1 bit from bit 16.
    #[inline(always)]
    pub const fn self_check_fault_raw(self) -> u8 { self.0[2] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn self_check_fault(self) -> Option<i32> {
        let raw = self.self_check_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `self_check_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_self_check_fault_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `cell_spread_1` as sent: 1 bit from bit 17.
    #[inline(always)]
    pub const fn cell_spread_1_raw(self) -> u8 { self.0[2] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn cell_spread_1(self) -> Option<i32> {
        let raw = self.cell_spread_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `cell_spread_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cell_spread_1_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `pack_voltage_low_1` as sent: 1 bit from bit 18.
    #[inline(always)]
    pub const fn pack_voltage_low_1_raw(self) -> u8 { self.0[2] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn pack_voltage_low_1(self) -> Option<i32> {
        let raw = self.pack_voltage_low_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `pack_voltage_low_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_voltage_low_1_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `temperature_spread_1` as sent: 1 bit from bit 19.
    #[inline(always)]
    pub const fn temperature_spread_1_raw(self) -> u8 { self.0[2] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_spread_1(self) -> Option<i32> {
        let raw = self.temperature_spread_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `temperature_spread_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_spread_1_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `insulation_1` as sent: 1 bit from bit 20.
    #[inline(always)]
    pub const fn insulation_1_raw(self) -> u8 { self.0[2] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn insulation_1(self) -> Option<i32> {
        let raw = self.insulation_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `insulation_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_insulation_1_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `positive_open_fault` as sent: 1 bit from bit 22.
    #[inline(always)]
    pub const fn positive_open_fault_raw(self) -> u8 { self.0[2] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn positive_open_fault(self) -> Option<i32> {
        let raw = self.positive_open_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `positive_open_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_open_fault_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `positive_close_fault` as sent: 1 bit from bit 23.
    #[inline(always)]
    pub const fn positive_close_fault_raw(self) -> u8 { self.0[2] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn positive_close_fault(self) -> Option<i32> {
        let raw = self.positive_close_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `positive_close_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_close_fault_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `cell_spread_2` as sent: 1 bit from bit 25.
    #[inline(always)]
    pub const fn cell_spread_2_raw(self) -> u8 { self.0[3] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn cell_spread_2(self) -> Option<i32> {
        let raw = self.cell_spread_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `cell_spread_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cell_spread_2_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `pack_voltage_low_2` as sent: 1 bit from bit 26.
    #[inline(always)]
    pub const fn pack_voltage_low_2_raw(self) -> u8 { self.0[3] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn pack_voltage_low_2(self) -> Option<i32> {
        let raw = self.pack_voltage_low_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `pack_voltage_low_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_voltage_low_2_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `temperature_spread_2` as sent: 1 bit from bit 27.
    #[inline(always)]
    pub const fn temperature_spread_2_raw(self) -> u8 { self.0[3] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_spread_2(self) -> Option<i32> {
        let raw = self.temperature_spread_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `temperature_spread_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_spread_2_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `insulation_2` as sent: 1 bit from bit 28.
    #[inline(always)]
    pub const fn insulation_2_raw(self) -> u8 { self.0[3] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn insulation_2(self) -> Option<i32> {
        let raw = self.insulation_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `insulation_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_insulation_2_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `hv_interlock_fault` as sent: 1 bit from bit 29.
    #[inline(always)]
    pub const fn hv_interlock_fault_raw(self) -> u8 { self.0[3] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn hv_interlock_fault(self) -> Option<i32> {
        let raw = self.hv_interlock_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hv_interlock_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hv_interlock_fault_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `negative_open_fault` as sent: 1 bit from bit 30.
    #[inline(always)]
    pub const fn negative_open_fault_raw(self) -> u8 { self.0[3] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn negative_open_fault(self) -> Option<i32> {
        let raw = self.negative_open_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `negative_open_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_open_fault_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `negative_close_fault` as sent: 1 bit from bit 31.
    #[inline(always)]
    pub const fn negative_close_fault_raw(self) -> u8 { self.0[3] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn negative_close_fault(self) -> Option<i32> {
        let raw = self.negative_close_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `negative_close_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_close_fault_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `positive_insulation` as sent: 16 bits down from bit 39.
    #[inline(always)]
    pub const fn positive_insulation_raw(self) -> u16 { u16::from_be_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/10 kohm, 0 to 65535; `None` if not valid.
    #[inline(always)]
    pub const fn positive_insulation(self) -> Option<i32> {
        let raw = self.positive_insulation_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `positive_insulation` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_insulation_raw(mut self, raw: u16) -> Self {
        self.0[5] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
        self
    }

    /// Returns `negative_insulation` as sent: 16 bits down from bit 55.
    #[inline(always)]
    pub const fn negative_insulation_raw(self) -> u16 { u16::from_be_bytes([self.0[6], self.0[7]]) }
    /// Returns the value in 1/10 kohm, 0 to 65535; `None` if not valid.
    #[inline(always)]
    pub const fn negative_insulation(self) -> Option<i32> {
        let raw = self.negative_insulation_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `negative_insulation` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_insulation_raw(mut self, raw: u16) -> Self {
        self.0[7] = raw as u8;
        self.0[6] = (raw >> 8) as u8;
        self
    }
}

/// ChargerTx (1840FFE5) from OBC, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChargerTx(pub [u8; 8]);

impl Default for ChargerTx {
    fn default() -> Self { Self::new() }
}

impl ChargerTx {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `output_voltage` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn output_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 3600; `None` if not valid.
    #[inline(always)]
    pub const fn output_voltage(self) -> Option<i32> {
        let raw = self.output_voltage_raw();
        if raw <= 3600 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_voltage_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `output_current` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn output_current_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 A, 0 to 160; `None` if not valid.
    #[inline(always)]
    pub const fn output_current(self) -> Option<i32> {
        let raw = self.output_current_raw();
        if raw <= 160 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_current_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `hardware_fault` as sent: 1 bit from bit 32.
    #[inline(always)]
    pub const fn hardware_fault_raw(self) -> u8 { self.0[4] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn hardware_fault(self) -> Option<i32> {
        let raw = self.hardware_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hardware_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hardware_fault_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `over_temperature` as sent: 1 bit from bit 33.
    #[inline(always)]
    pub const fn over_temperature_raw(self) -> u8 { self.0[4] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn over_temperature(self) -> Option<i32> {
        let raw = self.over_temperature_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `over_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_over_temperature_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `input_voltage_fault` as sent: 1 bit from bit 34.
    #[inline(always)]
    pub const fn input_voltage_fault_raw(self) -> u8 { self.0[4] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn input_voltage_fault(self) -> Option<i32> {
        let raw = self.input_voltage_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `input_voltage_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_input_voltage_fault_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `can_timeout` as sent: 1 bit from bit 35.
    #[inline(always)]
    pub const fn can_timeout_raw(self) -> u8 { self.0[4] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn can_timeout(self) -> Option<i32> {
        let raw = self.can_timeout_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `can_timeout` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_can_timeout_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `charger_state` as sent: 2 bits from bit 36.
    #[inline(always)]
    pub const fn charger_state_raw(self) -> u8 { self.0[4] >> 4 & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn charger_state(self) -> Option<i32> {
        let raw = self.charger_state_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `charger_state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charger_state_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `output_reversed` as sent: 1 bit from bit 40.
    #[inline(always)]
    pub const fn output_reversed_raw(self) -> u8 { self.0[5] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn output_reversed(self) -> Option<i32> {
        let raw = self.output_reversed_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `output_reversed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_reversed_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `output_short` as sent: 1 bit from bit 41.
    #[inline(always)]
    pub const fn output_short_raw(self) -> u8 { self.0[5] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn output_short(self) -> Option<i32> {
        let raw = self.output_short_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `output_short` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_short_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `overcurrent_warning` as sent: 1 bit from bit 42.
    #[inline(always)]
    pub const fn overcurrent_warning_raw(self) -> u8 { self.0[5] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overcurrent_warning(self) -> Option<i32> {
        let raw = self.overcurrent_warning_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overcurrent_warning` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overcurrent_warning_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `undervoltage_warning` as sent: 1 bit from bit 43.
    #[inline(always)]
    pub const fn undervoltage_warning_raw(self) -> u8 { self.0[5] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn undervoltage_warning(self) -> Option<i32> {
        let raw = self.undervoltage_warning_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `undervoltage_warning` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_undervoltage_warning_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `overvoltage_warning` as sent: 1 bit from bit 44.
    #[inline(always)]
    pub const fn overvoltage_warning_raw(self) -> u8 { self.0[5] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overvoltage_warning(self) -> Option<i32> {
        let raw = self.overvoltage_warning_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overvoltage_warning` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overvoltage_warning_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `overcurrent_protection` as sent: 1 bit from bit 45.
    #[inline(always)]
    pub const fn overcurrent_protection_raw(self) -> u8 { self.0[5] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overcurrent_protection(self) -> Option<i32> {
        let raw = self.overcurrent_protection_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overcurrent_protection` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overcurrent_protection_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `undervoltage_protection` as sent: 1 bit from bit 46.
    #[inline(always)]
    pub const fn undervoltage_protection_raw(self) -> u8 { self.0[5] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn undervoltage_protection(self) -> Option<i32> {
        let raw = self.undervoltage_protection_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `undervoltage_protection` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_undervoltage_protection_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `overvoltage_protection` as sent: 1 bit from bit 47.
    #[inline(always)]
    pub const fn overvoltage_protection_raw(self) -> u8 { self.0[5] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overvoltage_protection(self) -> Option<i32> {
        let raw = self.overvoltage_protection_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overvoltage_protection` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overvoltage_protection_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `overcurrent_data_error` as sent: 1 bit from bit 53.
    #[inline(always)]
    pub const fn overcurrent_data_error_raw(self) -> u8 { self.0[6] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overcurrent_data_error(self) -> Option<i32> {
        let raw = self.overcurrent_data_error_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overcurrent_data_error` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overcurrent_data_error_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `undervoltage_data_error` as sent: 1 bit from bit 54.
    #[inline(always)]
    pub const fn undervoltage_data_error_raw(self) -> u8 { self.0[6] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn undervoltage_data_error(self) -> Option<i32> {
        let raw = self.undervoltage_data_error_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `undervoltage_data_error` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_undervoltage_data_error_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `overvoltage_data_error` as sent: 1 bit from bit 55.
    #[inline(always)]
    pub const fn overvoltage_data_error_raw(self) -> u8 { self.0[6] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overvoltage_data_error(self) -> Option<i32> {
        let raw = self.overvoltage_data_error_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overvoltage_data_error` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overvoltage_data_error_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// ChargerControl (1830E5F4) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChargerControl(pub [u8; 8]);

impl Default for ChargerControl {
    fn default() -> Self { Self::new() }
}

impl ChargerControl {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `max_voltage` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn max_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 6000; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage(self) -> Option<i32> {
        let raw = self.max_voltage_raw();
        if raw <= 6000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_current` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn max_current_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 A, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn max_current(self) -> Option<i32> {
        let raw = self.max_current_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_current_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `charge_inhibit` as sent: 1 bit from bit 39.
    #[inline(always)]
    pub const fn charge_inhibit_raw(self) -> u8 { self.0[4] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn charge_inhibit(self) -> Option<i32> {
        let raw = self.charge_inhibit_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_inhibit` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_inhibit_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// ChargerVoltageLimits (1820E5F4) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChargerVoltageLimits(pub [u8; 8]);

impl Default for ChargerVoltageLimits {
    fn default() -> Self { Self::new() }
}

impl ChargerVoltageLimits {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `overvoltage_protection` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn overvoltage_protection_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 6000; `None` if not valid.
    #[inline(always)]
    pub const fn overvoltage_protection(self) -> Option<i32> {
        let raw = self.overvoltage_protection_raw();
        if raw <= 6000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `overvoltage_protection` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overvoltage_protection_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `undervoltage_protection` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn undervoltage_protection_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 V, 0 to 6000; `None` if not valid.
    #[inline(always)]
    pub const fn undervoltage_protection(self) -> Option<i32> {
        let raw = self.undervoltage_protection_raw();
        if raw <= 6000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `undervoltage_protection` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_undervoltage_protection_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `overvoltage_warning` as sent: 16 bits from bit 32.
    #[inline(always)]
    pub const fn overvoltage_warning_raw(self) -> u16 { u16::from_le_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/10 V, 0 to 6000; `None` if not valid.
    #[inline(always)]
    pub const fn overvoltage_warning(self) -> Option<i32> {
        let raw = self.overvoltage_warning_raw();
        if raw <= 6000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `overvoltage_warning` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overvoltage_warning_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `undervoltage_warning` as sent: 16 bits from bit 48.
    #[inline(always)]
    pub const fn undervoltage_warning_raw(self) -> u16 { u16::from_le_bytes([self.0[6], self.0[7]]) }
    /// Returns the value in 1/10 V, 0 to 6000; `None` if not valid.
    #[inline(always)]
    pub const fn undervoltage_warning(self) -> Option<i32> {
        let raw = self.undervoltage_warning_raw();
        if raw <= 6000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `undervoltage_warning` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_undervoltage_warning_raw(mut self, raw: u16) -> Self {
        self.0[6] = raw as u8;
        self.0[7] = (raw >> 8) as u8;
        self
    }
}

/// ChargerCurrentLimits (1810E5F4) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChargerCurrentLimits(pub [u8; 8]);

impl Default for ChargerCurrentLimits {
    fn default() -> Self { Self::new() }
}

impl ChargerCurrentLimits {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `overcurrent_protection` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn overcurrent_protection_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 A, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn overcurrent_protection(self) -> Option<i32> {
        let raw = self.overcurrent_protection_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `overcurrent_protection` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overcurrent_protection_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `overcurrent_warning` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn overcurrent_warning_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 A, 0 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn overcurrent_warning(self) -> Option<i32> {
        let raw = self.overcurrent_warning_raw();
        if raw <= 5000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `overcurrent_warning` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overcurrent_warning_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }
}

/// VCUToCluster (18C21727) from VCU, every 200 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VcuToCluster(pub [u8; 8]);

impl Default for VcuToCluster {
    fn default() -> Self { Self::new() }
}

impl VcuToCluster {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `soc` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn soc_raw(self) -> u8 { self.0[0] }
    /// Returns the value in 1/2 %, 0 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn soc(self) -> Option<i32> {
        let raw = self.soc_raw();
        if raw <= 200 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `vehicle_speed` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn vehicle_speed_raw(self) -> u8 { self.0[1] }
    /// Returns the value in km/h, 0 to 150; `None` if not valid.
    #[inline(always)]
    pub const fn vehicle_speed(self) -> Option<i32> {
        let raw = self.vehicle_speed_raw();
        if raw <= 150 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `vehicle_speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vehicle_speed_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `motor_power` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn motor_power_raw(self) -> u8 { self.0[2] }
    /// Returns the value in kW, -50 to 80; `None` if not valid.
    #[inline(always)]
    pub const fn motor_power(self) -> Option<i32> {
        let raw = self.motor_power_raw();
        if raw <= 130 { Some(raw as i32 - 50) } else { None }
    }
    /// Returns the frame with `motor_power` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_power_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `battery_voltage` as sent: 16 bits from bit 24.
    #[inline(always)]
    pub const fn battery_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in V, 0 to 400; `None` if not valid.
    #[inline(always)]
    pub const fn battery_voltage(self) -> Option<i32> {
        let raw = self.battery_voltage_raw();
        if raw <= 400 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `battery_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_battery_voltage_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
        self
    }

    /// Returns `remaining_range` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn remaining_range_raw(self) -> u8 { self.0[5] }
    /// Returns the value in km, 0 to 150; `None` if not valid.
    #[inline(always)]
    pub const fn remaining_range(self) -> Option<i32> {
        let raw = self.remaining_range_raw();
        if raw <= 150 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `remaining_range` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_remaining_range_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `gear` as sent: 2 bits from bit 48.
    #[inline(always)]
    pub const fn gear_raw(self) -> u8 { self.0[6] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn gear(self) -> Option<i32> {
        let raw = self.gear_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `gear` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_gear_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `insulation_fault` as sent: 1 bit from bit 50.
    #[inline(always)]
    pub const fn insulation_fault_raw(self) -> u8 { self.0[6] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn insulation_fault(self) -> Option<i32> {
        let raw = self.insulation_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `insulation_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_insulation_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `battery_fault` as sent: 1 bit from bit 51.
    #[inline(always)]
    pub const fn battery_fault_raw(self) -> u8 { self.0[6] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn battery_fault(self) -> Option<i32> {
        let raw = self.battery_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `battery_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_battery_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `motor_fault` as sent: 1 bit from bit 52.
    #[inline(always)]
    pub const fn motor_fault_raw(self) -> u8 { self.0[6] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn motor_fault(self) -> Option<i32> {
        let raw = self.motor_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `motor_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `ready` as sent: 1 bit from bit 53.
    #[inline(always)]
    pub const fn ready_raw(self) -> u8 { self.0[6] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn ready(self) -> Option<i32> {
        let raw = self.ready_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `ready` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_ready_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `system_fault` as sent: 1 bit from bit 54.
    #[inline(always)]
    pub const fn system_fault_raw(self) -> u8 { self.0[6] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn system_fault(self) -> Option<i32> {
        let raw = self.system_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `system_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_system_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `charging` as sent: 1 bit from bit 55.
    #[inline(always)]
    pub const fn charging_raw(self) -> u8 { self.0[6] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn charging(self) -> Option<i32> {
        let raw = self.charging_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charging` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charging_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `ebd_fault` as sent: 1 bit from bit 56.
    #[inline(always)]
    pub const fn ebd_fault_raw(self) -> u8 { self.0[7] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn ebd_fault(self) -> Option<i32> {
        let raw = self.ebd_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `ebd_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_ebd_fault_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `abs_fault` as sent: 1 bit from bit 57.
    #[inline(always)]
    pub const fn abs_fault_raw(self) -> u8 { self.0[7] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn abs_fault(self) -> Option<i32> {
        let raw = self.abs_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `abs_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_abs_fault_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `turtle_mode` as sent: 1 bit from bit 58.
    #[inline(always)]
    pub const fn turtle_mode_raw(self) -> u8 { self.0[7] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn turtle_mode(self) -> Option<i32> {
        let raw = self.turtle_mode_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `turtle_mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_turtle_mode_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `charge_connected` as sent: 1 bit from bit 59.
    #[inline(always)]
    pub const fn charge_connected_raw(self) -> u8 { self.0[7] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn charge_connected(self) -> Option<i32> {
        let raw = self.charge_connected_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_connected` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_connected_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `cruise` as sent: 1 bit from bit 60.
    #[inline(always)]
    pub const fn cruise_raw(self) -> u8 { self.0[7] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn cruise(self) -> Option<i32> {
        let raw = self.cruise_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `cruise` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cruise_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `battery_low` as sent: 1 bit from bit 61.
    #[inline(always)]
    pub const fn battery_low_raw(self) -> u8 { self.0[7] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn battery_low(self) -> Option<i32> {
        let raw = self.battery_low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `battery_low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_battery_low_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `buzzer` as sent: 1 bit from bit 62.
    #[inline(always)]
    pub const fn buzzer_raw(self) -> u8 { self.0[7] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn buzzer(self) -> Option<i32> {
        let raw = self.buzzer_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `buzzer` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_buzzer_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `sport_mode` as sent: 1 bit from bit 63.
    #[inline(always)]
    pub const fn sport_mode_raw(self) -> u8 { self.0[7] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn sport_mode(self) -> Option<i32> {
        let raw = self.sport_mode_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `sport_mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_sport_mode_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// VCUToMCU (0801EF27) from VCU, every 20 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VcuToMcu(pub [u8; 8]);

impl Default for VcuToMcu {
    fn default() -> Self { Self::new() }
}

impl VcuToMcu {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `work_mode` as sent: 2 bits from bit 0.
    #[inline(always)]
    pub const fn work_mode_raw(self) -> u8 { self.0[0] & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn work_mode(self) -> Option<i32> {
        let raw = self.work_mode_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `work_mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_work_mode_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `control_mode` as sent: 2 bits from bit 2.
    #[inline(always)]
    pub const fn control_mode_raw(self) -> u8 { self.0[0] >> 2 & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn control_mode(self) -> Option<i32> {
        let raw = self.control_mode_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `control_mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_control_mode_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `direction` as sent: 2 bits from bit 4.
    #[inline(always)]
    pub const fn direction_raw(self) -> u8 { self.0[0] >> 4 & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn direction(self) -> Option<i32> {
        let raw = self.direction_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `direction` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_direction_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `torque` as sent: 16 bits from bit 8, only while `control_mode` is 1.
    #[inline(always)]
    pub const fn torque_raw(self) -> u16 { u16::from_le_bytes([self.0[1], self.0[2]]) }
    /// Returns the value in Nm, 0 to 300; `None` if not valid.
    #[inline(always)]
    pub const fn torque(self) -> Option<i32> {
        let raw = self.torque_raw();
        if raw <= 300 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `torque` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_torque_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `speed` as sent: 16 bits from bit 8, only while `control_mode` is 2.
    #[inline(always)]
    pub const fn speed_raw(self) -> u16 { u16::from_le_bytes([self.0[1], self.0[2]]) }
    /// Returns the value in rpm, 0 to 15000; `None` if not valid.
    #[inline(always)]
    pub const fn speed(self) -> Option<i32> {
        let raw = self.speed_raw();
        if raw <= 15000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_speed_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_speed_low` as sent: 8 bits from bit 24, only while `control_mode` is 1.
    #[inline(always)]
    pub const fn max_speed_low_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn max_speed_low(self) -> Option<i32> {
        let raw = self.max_speed_low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `max_speed_low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_speed_low_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `max_torque_low` as sent: 8 bits from bit 24, only while `control_mode` is 2.
    #[inline(always)]
    pub const fn max_torque_low_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn max_torque_low(self) -> Option<i32> {
        let raw = self.max_torque_low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `max_torque_low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_torque_low_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }
}

fn get_vcu_to_bms(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = VcuToBms(data);
    Some(match index {
        0 => (frame.relay_command_raw() as i64, frame.relay_command().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu_to_bms(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = VcuToBms(data);
    match index {
        0 => frame.with_relay_command_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bmsa(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bmsa(data);
    Some(match index {
        0 => (frame.soc_raw() as i64, frame.soc().map(|value| value as i64)),
        1 => (frame.soh_raw() as i64, frame.soh().map(|value| value as i64)),
        2 => (frame.pack_current_raw() as i64, frame.pack_current().map(|value| value as i64)),
        3 => (frame.max_discharge_current_raw() as i64, frame.max_discharge_current().map(|value| value as i64)),
        4 => (frame.max_charge_current_raw() as i64, frame.max_charge_current().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bmsa(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bmsa(data);
    match index {
        0 => frame.with_soc_raw(raw as u8).0,
        1 => frame.with_soh_raw(raw as u8).0,
        2 => frame.with_pack_current_raw(raw as u16).0,
        3 => frame.with_max_discharge_current_raw(raw as u16).0,
        4 => frame.with_max_charge_current_raw(raw as u16).0,
        _ => data,
    }
}

fn get_bmsb(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bmsb(data);
    Some(match index {
        0 => (frame.pack_voltage_raw() as i64, frame.pack_voltage().map(|value| value as i64)),
        1 => (frame.max_cell_voltage_raw() as i64, frame.max_cell_voltage().map(|value| value as i64)),
        2 => (frame.min_cell_voltage_raw() as i64, frame.min_cell_voltage().map(|value| value as i64)),
        3 => (frame.balancing_fault_raw() as i64, frame.balancing_fault().map(|value| value as i64)),
        4 => (frame.temperature_sensing_fault_raw() as i64, frame.temperature_sensing_fault().map(|value| value as i64)),
        5 => (frame.voltage_sensing_fault_raw() as i64, frame.voltage_sensing_fault().map(|value| value as i64)),
        6 => (frame.current_sensing_fault_raw() as i64, frame.current_sensing_fault().map(|value| value as i64)),
        7 => (frame.vcu_lost_raw() as i64, frame.vcu_lost().map(|value| value as i64)),
        8 => (frame.can_fault_raw() as i64, frame.can_fault().map(|value| value as i64)),
        9 => (frame.self_check_passed_raw() as i64, frame.self_check_passed().map(|value| value as i64)),
        10 => (frame.slave_8_lost_raw() as i64, frame.slave_8_lost().map(|value| value as i64)),
        11 => (frame.slave_7_lost_raw() as i64, frame.slave_7_lost().map(|value| value as i64)),
        12 => (frame.slave_6_lost_raw() as i64, frame.slave_6_lost().map(|value| value as i64)),
        13 => (frame.slave_5_lost_raw() as i64, frame.slave_5_lost().map(|value| value as i64)),
        14 => (frame.slave_4_lost_raw() as i64, frame.slave_4_lost().map(|value| value as i64)),
        15 => (frame.slave_3_lost_raw() as i64, frame.slave_3_lost().map(|value| value as i64)),
        16 => (frame.slave_2_lost_raw() as i64, frame.slave_2_lost().map(|value| value as i64)),
        17 => (frame.slave_1_lost_raw() as i64, frame.slave_1_lost().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bmsb(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bmsb(data);
    match index {
        0 => frame.with_pack_voltage_raw(raw as u16).0,
        1 => frame.with_max_cell_voltage_raw(raw as u16).0,
        2 => frame.with_min_cell_voltage_raw(raw as u16).0,
        3 => frame.with_balancing_fault_raw(raw as u8).0,
        4 => frame.with_temperature_sensing_fault_raw(raw as u8).0,
        5 => frame.with_voltage_sensing_fault_raw(raw as u8).0,
        6 => frame.with_current_sensing_fault_raw(raw as u8).0,
        7 => frame.with_vcu_lost_raw(raw as u8).0,
        8 => frame.with_can_fault_raw(raw as u8).0,
        9 => frame.with_self_check_passed_raw(raw as u8).0,
        10 => frame.with_slave_8_lost_raw(raw as u8).0,
        11 => frame.with_slave_7_lost_raw(raw as u8).0,
        12 => frame.with_slave_6_lost_raw(raw as u8).0,
        13 => frame.with_slave_5_lost_raw(raw as u8).0,
        14 => frame.with_slave_4_lost_raw(raw as u8).0,
        15 => frame.with_slave_3_lost_raw(raw as u8).0,
        16 => frame.with_slave_2_lost_raw(raw as u8).0,
        17 => frame.with_slave_1_lost_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bmsc(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bmsc(data);
    Some(match index {
        0 => (frame.mean_temperature_raw() as i64, frame.mean_temperature().map(|value| value as i64)),
        1 => (frame.max_temperature_raw() as i64, frame.max_temperature().map(|value| value as i64)),
        2 => (frame.min_temperature_raw() as i64, frame.min_temperature().map(|value| value as i64)),
        3 => (frame.max_temperature_probe_raw() as i64, frame.max_temperature_probe().map(|value| value as i64)),
        4 => (frame.min_temperature_probe_raw() as i64, frame.min_temperature_probe().map(|value| value as i64)),
        5 => (frame.cycles_raw() as i64, frame.cycles().map(|value| value as i64)),
        6 => (frame.precharge_fault_raw() as i64, frame.precharge_fault().map(|value| value as i64)),
        7 => (frame.negative_contactor_raw() as i64, frame.negative_contactor().map(|value| value as i64)),
        8 => (frame.positive_contactor_raw() as i64, frame.positive_contactor().map(|value| value as i64)),
        9 => (frame.charging_raw() as i64, frame.charging().map(|value| value as i64)),
        10 => (frame.charge_gun_raw() as i64, frame.charge_gun().map(|value| value as i64)),
        11 => (frame.positive_open_request_raw() as i64, frame.positive_open_request().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bmsc(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bmsc(data);
    match index {
        0 => frame.with_mean_temperature_raw(raw as u8).0,
        1 => frame.with_max_temperature_raw(raw as u8).0,
        2 => frame.with_min_temperature_raw(raw as u8).0,
        3 => frame.with_max_temperature_probe_raw(raw as u8).0,
        4 => frame.with_min_temperature_probe_raw(raw as u8).0,
        5 => frame.with_cycles_raw(raw as u16).0,
        6 => frame.with_precharge_fault_raw(raw as u8).0,
        7 => frame.with_negative_contactor_raw(raw as u8).0,
        8 => frame.with_positive_contactor_raw(raw as u8).0,
        9 => frame.with_charging_raw(raw as u8).0,
        10 => frame.with_charge_gun_raw(raw as u8).0,
        11 => frame.with_positive_open_request_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bmsd(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bmsd(data);
    Some(match index {
        0 => (frame.cell_voltage_high_1_raw() as i64, frame.cell_voltage_high_1().map(|value| value as i64)),
        1 => (frame.cell_voltage_low_1_raw() as i64, frame.cell_voltage_low_1().map(|value| value as i64)),
        2 => (frame.pack_voltage_high_1_raw() as i64, frame.pack_voltage_high_1().map(|value| value as i64)),
        3 => (frame.soc_low_1_raw() as i64, frame.soc_low_1().map(|value| value as i64)),
        4 => (frame.discharge_current_high_1_raw() as i64, frame.discharge_current_high_1().map(|value| value as i64)),
        5 => (frame.regen_current_high_1_raw() as i64, frame.regen_current_high_1().map(|value| value as i64)),
        6 => (frame.temperature_high_1_raw() as i64, frame.temperature_high_1().map(|value| value as i64)),
        7 => (frame.temperature_low_1_raw() as i64, frame.temperature_low_1().map(|value| value as i64)),
        8 => (frame.cell_voltage_high_2_raw() as i64, frame.cell_voltage_high_2().map(|value| value as i64)),
        9 => (frame.cell_voltage_low_2_raw() as i64, frame.cell_voltage_low_2().map(|value| value as i64)),
        10 => (frame.pack_voltage_high_2_raw() as i64, frame.pack_voltage_high_2().map(|value| value as i64)),
        11 => (frame.soc_low_2_raw() as i64, frame.soc_low_2().map(|value| value as i64)),
        12 => (frame.discharge_current_high_2_raw() as i64, frame.discharge_current_high_2().map(|value| value as i64)),
        13 => (frame.regen_current_high_2_raw() as i64, frame.regen_current_high_2().map(|value| value as i64)),
        14 => (frame.temperature_high_2_raw() as i64, frame.temperature_high_2().map(|value| value as i64)),
        15 => (frame.temperature_low_2_raw() as i64, frame.temperature_low_2().map(|value| value as i64)),
        16 => (frame.self_check_fault_raw() as i64, frame.self_check_fault().map(|value| value as i64)),
        17 => (frame.cell_spread_1_raw() as i64, frame.cell_spread_1().map(|value| value as i64)),
        18 => (frame.pack_voltage_low_1_raw() as i64, frame.pack_voltage_low_1().map(|value| value as i64)),
        19 => (frame.temperature_spread_1_raw() as i64, frame.temperature_spread_1().map(|value| value as i64)),
        20 => (frame.insulation_1_raw() as i64, frame.insulation_1().map(|value| value as i64)),
        21 => (frame.positive_open_fault_raw() as i64, frame.positive_open_fault().map(|value| value as i64)),
        22 => (frame.positive_close_fault_raw() as i64, frame.positive_close_fault().map(|value| value as i64)),
        23 => (frame.cell_spread_2_raw() as i64, frame.cell_spread_2().map(|value| value as i64)),
        24 => (frame.pack_voltage_low_2_raw() as i64, frame.pack_voltage_low_2().map(|value| value as i64)),
        25 => (frame.temperature_spread_2_raw() as i64, frame.temperature_spread_2().map(|value| value as i64)),
        26 => (frame.insulation_2_raw() as i64, frame.insulation_2().map(|value| value as i64)),
        27 => (frame.hv_interlock_fault_raw() as i64, frame.hv_interlock_fault().map(|value| value as i64)),
        28 => (frame.negative_open_fault_raw() as i64, frame.negative_open_fault().map(|value| value as i64)),
        29 => (frame.negative_close_fault_raw() as i64, frame.negative_close_fault().map(|value| value as i64)),
        30 => (frame.positive_insulation_raw() as i64, frame.positive_insulation().map(|value| value as i64)),
        31 => (frame.negative_insulation_raw() as i64, frame.negative_insulation().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bmsd(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bmsd(data);
    match index {
        0 => frame.with_cell_voltage_high_1_raw(raw as u8).0,
        1 => frame.with_cell_voltage_low_1_raw(raw as u8).0,
        2 => frame.with_pack_voltage_high_1_raw(raw as u8).0,
        3 => frame.with_soc_low_1_raw(raw as u8).0,
        4 => frame.with_discharge_current_high_1_raw(raw as u8).0,
        5 => frame.with_regen_current_high_1_raw(raw as u8).0,
        6 => frame.with_temperature_high_1_raw(raw as u8).0,
        7 => frame.with_temperature_low_1_raw(raw as u8).0,
        8 => frame.with_cell_voltage_high_2_raw(raw as u8).0,
        9 => frame.with_cell_voltage_low_2_raw(raw as u8).0,
        10 => frame.with_pack_voltage_high_2_raw(raw as u8).0,
        11 => frame.with_soc_low_2_raw(raw as u8).0,
        12 => frame.with_discharge_current_high_2_raw(raw as u8).0,
        13 => frame.with_regen_current_high_2_raw(raw as u8).0,
        14 => frame.with_temperature_high_2_raw(raw as u8).0,
        15 => frame.with_temperature_low_2_raw(raw as u8).0,
        16 => frame.with_self_check_fault_raw(raw as u8).0,
        17 => frame.with_cell_spread_1_raw(raw as u8).0,
        18 => frame.with_pack_voltage_low_1_raw(raw as u8).0,
        19 => frame.with_temperature_spread_1_raw(raw as u8).0,
        20 => frame.with_insulation_1_raw(raw as u8).0,
        21 => frame.with_positive_open_fault_raw(raw as u8).0,
        22 => frame.with_positive_close_fault_raw(raw as u8).0,
        23 => frame.with_cell_spread_2_raw(raw as u8).0,
        24 => frame.with_pack_voltage_low_2_raw(raw as u8).0,
        25 => frame.with_temperature_spread_2_raw(raw as u8).0,
        26 => frame.with_insulation_2_raw(raw as u8).0,
        27 => frame.with_hv_interlock_fault_raw(raw as u8).0,
        28 => frame.with_negative_open_fault_raw(raw as u8).0,
        29 => frame.with_negative_close_fault_raw(raw as u8).0,
        30 => frame.with_positive_insulation_raw(raw as u16).0,
        31 => frame.with_negative_insulation_raw(raw as u16).0,
        _ => data,
    }
}

fn get_charger_tx(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = ChargerTx(data);
    Some(match index {
        0 => (frame.output_voltage_raw() as i64, frame.output_voltage().map(|value| value as i64)),
        1 => (frame.output_current_raw() as i64, frame.output_current().map(|value| value as i64)),
        2 => (frame.hardware_fault_raw() as i64, frame.hardware_fault().map(|value| value as i64)),
        3 => (frame.over_temperature_raw() as i64, frame.over_temperature().map(|value| value as i64)),
        4 => (frame.input_voltage_fault_raw() as i64, frame.input_voltage_fault().map(|value| value as i64)),
        5 => (frame.can_timeout_raw() as i64, frame.can_timeout().map(|value| value as i64)),
        6 => (frame.charger_state_raw() as i64, frame.charger_state().map(|value| value as i64)),
        7 => (frame.output_reversed_raw() as i64, frame.output_reversed().map(|value| value as i64)),
        8 => (frame.output_short_raw() as i64, frame.output_short().map(|value| value as i64)),
        9 => (frame.overcurrent_warning_raw() as i64, frame.overcurrent_warning().map(|value| value as i64)),
        10 => (frame.undervoltage_warning_raw() as i64, frame.undervoltage_warning().map(|value| value as i64)),
        11 => (frame.overvoltage_warning_raw() as i64, frame.overvoltage_warning().map(|value| value as i64)),
        12 => (frame.overcurrent_protection_raw() as i64, frame.overcurrent_protection().map(|value| value as i64)),
        13 => (frame.undervoltage_protection_raw() as i64, frame.undervoltage_protection().map(|value| value as i64)),
        14 => (frame.overvoltage_protection_raw() as i64, frame.overvoltage_protection().map(|value| value as i64)),
        15 => (frame.overcurrent_data_error_raw() as i64, frame.overcurrent_data_error().map(|value| value as i64)),
        16 => (frame.undervoltage_data_error_raw() as i64, frame.undervoltage_data_error().map(|value| value as i64)),
        17 => (frame.overvoltage_data_error_raw() as i64, frame.overvoltage_data_error().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_charger_tx(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = ChargerTx(data);
    match index {
        0 => frame.with_output_voltage_raw(raw as u16).0,
        1 => frame.with_output_current_raw(raw as u16).0,
        2 => frame.with_hardware_fault_raw(raw as u8).0,
        3 => frame.with_over_temperature_raw(raw as u8).0,
        4 => frame.with_input_voltage_fault_raw(raw as u8).0,
        5 => frame.with_can_timeout_raw(raw as u8).0,
        6 => frame.with_charger_state_raw(raw as u8).0,
        7 => frame.with_output_reversed_raw(raw as u8).0,
        8 => frame.with_output_short_raw(raw as u8).0,
        9 => frame.with_overcurrent_warning_raw(raw as u8).0,
        10 => frame.with_undervoltage_warning_raw(raw as u8).0,
        11 => frame.with_overvoltage_warning_raw(raw as u8).0,
        12 => frame.with_overcurrent_protection_raw(raw as u8).0,
        13 => frame.with_undervoltage_protection_raw(raw as u8).0,
        14 => frame.with_overvoltage_protection_raw(raw as u8).0,
        15 => frame.with_overcurrent_data_error_raw(raw as u8).0,
        16 => frame.with_undervoltage_data_error_raw(raw as u8).0,
        17 => frame.with_overvoltage_data_error_raw(raw as u8).0,
        _ => data,
    }
}

fn get_charger_control(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = ChargerControl(data);
    Some(match index {
        0 => (frame.max_voltage_raw() as i64, frame.max_voltage().map(|value| value as i64)),
        1 => (frame.max_current_raw() as i64, frame.max_current().map(|value| value as i64)),
        2 => (frame.charge_inhibit_raw() as i64, frame.charge_inhibit().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_charger_control(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = ChargerControl(data);
    match index {
        0 => frame.with_max_voltage_raw(raw as u16).0,
        1 => frame.with_max_current_raw(raw as u16).0,
        2 => frame.with_charge_inhibit_raw(raw as u8).0,
        _ => data,
    }
}

fn get_charger_voltage_limits(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = ChargerVoltageLimits(data);
    Some(match index {
        0 => (frame.overvoltage_protection_raw() as i64, frame.overvoltage_protection().map(|value| value as i64)),
        1 => (frame.undervoltage_protection_raw() as i64, frame.undervoltage_protection().map(|value| value as i64)),
        2 => (frame.overvoltage_warning_raw() as i64, frame.overvoltage_warning().map(|value| value as i64)),
        3 => (frame.undervoltage_warning_raw() as i64, frame.undervoltage_warning().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_charger_voltage_limits(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = ChargerVoltageLimits(data);
    match index {
        0 => frame.with_overvoltage_protection_raw(raw as u16).0,
        1 => frame.with_undervoltage_protection_raw(raw as u16).0,
        2 => frame.with_overvoltage_warning_raw(raw as u16).0,
        3 => frame.with_undervoltage_warning_raw(raw as u16).0,
        _ => data,
    }
}

fn get_charger_current_limits(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = ChargerCurrentLimits(data);
    Some(match index {
        0 => (frame.overcurrent_protection_raw() as i64, frame.overcurrent_protection().map(|value| value as i64)),
        1 => (frame.overcurrent_warning_raw() as i64, frame.overcurrent_warning().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_charger_current_limits(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = ChargerCurrentLimits(data);
    match index {
        0 => frame.with_overcurrent_protection_raw(raw as u16).0,
        1 => frame.with_overcurrent_warning_raw(raw as u16).0,
        _ => data,
    }
}

fn get_vcu_to_cluster(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = VcuToCluster(data);
    Some(match index {
        0 => (frame.soc_raw() as i64, frame.soc().map(|value| value as i64)),
        1 => (frame.vehicle_speed_raw() as i64, frame.vehicle_speed().map(|value| value as i64)),
        2 => (frame.motor_power_raw() as i64, frame.motor_power().map(|value| value as i64)),
        3 => (frame.battery_voltage_raw() as i64, frame.battery_voltage().map(|value| value as i64)),
        4 => (frame.remaining_range_raw() as i64, frame.remaining_range().map(|value| value as i64)),
        5 => (frame.gear_raw() as i64, frame.gear().map(|value| value as i64)),
        6 => (frame.insulation_fault_raw() as i64, frame.insulation_fault().map(|value| value as i64)),
        7 => (frame.battery_fault_raw() as i64, frame.battery_fault().map(|value| value as i64)),
        8 => (frame.motor_fault_raw() as i64, frame.motor_fault().map(|value| value as i64)),
        9 => (frame.ready_raw() as i64, frame.ready().map(|value| value as i64)),
        10 => (frame.system_fault_raw() as i64, frame.system_fault().map(|value| value as i64)),
        11 => (frame.charging_raw() as i64, frame.charging().map(|value| value as i64)),
        12 => (frame.ebd_fault_raw() as i64, frame.ebd_fault().map(|value| value as i64)),
        13 => (frame.abs_fault_raw() as i64, frame.abs_fault().map(|value| value as i64)),
        14 => (frame.turtle_mode_raw() as i64, frame.turtle_mode().map(|value| value as i64)),
        15 => (frame.charge_connected_raw() as i64, frame.charge_connected().map(|value| value as i64)),
        16 => (frame.cruise_raw() as i64, frame.cruise().map(|value| value as i64)),
        17 => (frame.battery_low_raw() as i64, frame.battery_low().map(|value| value as i64)),
        18 => (frame.buzzer_raw() as i64, frame.buzzer().map(|value| value as i64)),
        19 => (frame.sport_mode_raw() as i64, frame.sport_mode().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu_to_cluster(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = VcuToCluster(data);
    match index {
        0 => frame.with_soc_raw(raw as u8).0,
        1 => frame.with_vehicle_speed_raw(raw as u8).0,
        2 => frame.with_motor_power_raw(raw as u8).0,
        3 => frame.with_battery_voltage_raw(raw as u16).0,
        4 => frame.with_remaining_range_raw(raw as u8).0,
        5 => frame.with_gear_raw(raw as u8).0,
        6 => frame.with_insulation_fault_raw(raw as u8).0,
        7 => frame.with_battery_fault_raw(raw as u8).0,
        8 => frame.with_motor_fault_raw(raw as u8).0,
        9 => frame.with_ready_raw(raw as u8).0,
        10 => frame.with_system_fault_raw(raw as u8).0,
        11 => frame.with_charging_raw(raw as u8).0,
        12 => frame.with_ebd_fault_raw(raw as u8).0,
        13 => frame.with_abs_fault_raw(raw as u8).0,
        14 => frame.with_turtle_mode_raw(raw as u8).0,
        15 => frame.with_charge_connected_raw(raw as u8).0,
        16 => frame.with_cruise_raw(raw as u8).0,
        17 => frame.with_battery_low_raw(raw as u8).0,
        18 => frame.with_buzzer_raw(raw as u8).0,
        19 => frame.with_sport_mode_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu_to_mcu(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = VcuToMcu(data);
    Some(match index {
        0 => (frame.work_mode_raw() as i64, frame.work_mode().map(|value| value as i64)),
        1 => (frame.control_mode_raw() as i64, frame.control_mode().map(|value| value as i64)),
        2 => (frame.direction_raw() as i64, frame.direction().map(|value| value as i64)),
        3 => (frame.torque_raw() as i64, frame.torque().map(|value| value as i64)),
        4 => (frame.speed_raw() as i64, frame.speed().map(|value| value as i64)),
        5 => (frame.max_speed_low_raw() as i64, frame.max_speed_low().map(|value| value as i64)),
        6 => (frame.max_torque_low_raw() as i64, frame.max_torque_low().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu_to_mcu(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = VcuToMcu(data);
    match index {
        0 => frame.with_work_mode_raw(raw as u8).0,
        1 => frame.with_control_mode_raw(raw as u8).0,
        2 => frame.with_direction_raw(raw as u8).0,
        3 => frame.with_torque_raw(raw as u16).0,
        4 => frame.with_speed_raw(raw as u16).0,
        5 => frame.with_max_speed_low_raw(raw as u8).0,
        6 => frame.with_max_torque_low_raw(raw as u8).0,
        _ => data,
    }
}

static VCU_TO_BMS_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "relay_command", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (85, 170), start_raw: 85, invalid_raw: None, mux: Mux::Always, life: None, values: &[(85, "off"), (170, "on")] },
];

static BMSA_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "soc", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "soh", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "pack_current", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -5000, den: 10 }, unit: "A", range: (0, 10000), start_raw: 5000, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_discharge_current", start: 32, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (0, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_charge_current", start: 48, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -5000, den: 10 }, unit: "A", range: (0, 5000), start_raw: 5000, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static BMSB_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "pack_voltage", start: 7, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_cell_voltage", start: 23, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 1000 }, unit: "V", range: (0, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_cell_voltage", start: 39, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 1000 }, unit: "V", range: (0, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "balancing_fault", start: 49, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "temperature_sensing_fault", start: 50, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "voltage_sensing_fault", start: 51, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "current_sensing_fault", start: 52, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "vcu_lost", start: 53, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "can_fault", start: 54, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "self_check_passed", start: 55, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_passed"), (1, "passed")] },
    SignalInfo { name: "slave_8_lost", start: 56, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "slave_7_lost", start: 57, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "slave_6_lost", start: 58, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "slave_5_lost", start: 59, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "slave_4_lost", start: 60, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "slave_3_lost", start: 61, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "slave_2_lost", start: 62, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "slave_1_lost", start: 63, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
];

static BMSC_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "mean_temperature", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -50, den: 1 }, unit: "°C", range: (0, 200), start_raw: 50, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -50, den: 1 }, unit: "°C", range: (0, 200), start_raw: 50, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -50, den: 1 }, unit: "°C", range: (0, 200), start_raw: 50, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_probe", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 100), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_probe", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 100), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "cycles", start: 47, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "precharge_fault", start: 56, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "negative_contactor", start: 57, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "positive_contactor", start: 58, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "charging", start: 59, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "charge_gun", start: 62, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_connected"), (1, "connected")] },
    SignalInfo { name: "positive_open_request", start: 63, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
];

static BMSD_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "cell_voltage_high_1", start: 0, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "cell_voltage_low_1", start: 1, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "pack_voltage_high_1", start: 2, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "soc_low_1", start: 3, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "discharge_current_high_1", start: 4, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "regen_current_high_1", start: 5, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "temperature_high_1", start: 6, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "temperature_low_1", start: 7, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "cell_voltage_high_2", start: 8, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "cell_voltage_low_2", start: 9, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "pack_voltage_high_2", start: 10, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "soc_low_2", start: 11, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "discharge_current_high_2", start: 12, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "regen_current_high_2", start: 13, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "temperature_high_2", start: 14, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "temperature_low_2", start: 15, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "self_check_fault", start: 16, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "cell_spread_1", start: 17, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "pack_voltage_low_1", start: 18, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "temperature_spread_1", start: 19, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "insulation_1", start: 20, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "positive_open_fault", start: 22, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "positive_close_fault", start: 23, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "cell_spread_2", start: 25, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "pack_voltage_low_2", start: 26, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "temperature_spread_2", start: 27, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "insulation_2", start: 28, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "hv_interlock_fault", start: 29, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "negative_open_fault", start: 30, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "negative_close_fault", start: 31, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "positive_insulation", start: 39, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "kohm", range: (0, 65535), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "negative_insulation", start: 55, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "kohm", range: (0, 65535), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static CHARGER_TX_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "output_voltage", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 3600), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "output_current", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (0, 160), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "hardware_fault", start: 32, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "over_temperature", start: 33, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "input_voltage_fault", start: 34, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "can_timeout", start: 35, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "timeout")] },
    SignalInfo { name: "charger_state", start: 36, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: Some(3), mux: Mux::Always, life: None, values: &[(0, "ready"), (1, "charging"), (2, "fault"), (3, "invalid")] },
    SignalInfo { name: "output_reversed", start: 40, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "output_short", start: 41, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "overcurrent_warning", start: 42, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "undervoltage_warning", start: 43, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "overvoltage_warning", start: 44, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "overcurrent_protection", start: 45, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "undervoltage_protection", start: 46, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "overvoltage_protection", start: 47, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "overcurrent_data_error", start: 53, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "undervoltage_data_error", start: 54, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "overvoltage_data_error", start: 55, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
];

static CHARGER_CONTROL_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "max_voltage", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 6000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_current", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (0, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "charge_inhibit", start: 39, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 1, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "charge"), (1, "protect")] },
];

static CHARGER_VOLTAGE_LIMITS_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "overvoltage_protection", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 6000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "undervoltage_protection", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 6000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "overvoltage_warning", start: 32, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 6000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "undervoltage_warning", start: 48, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 6000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static CHARGER_CURRENT_LIMITS_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "overcurrent_protection", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (0, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "overcurrent_warning", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (0, 5000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static VCU_TO_CLUSTER_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "soc", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 2 }, unit: "%", range: (0, 200), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "vehicle_speed", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "km/h", range: (0, 150), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "motor_power", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -50, den: 1 }, unit: "kW", range: (0, 130), start_raw: 50, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "battery_voltage", start: 24, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "V", range: (0, 400), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "remaining_range", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "km", range: (0, 150), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "gear", start: 48, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "N"), (1, "D"), (2, "R"), (3, "P")] },
    SignalInfo { name: "insulation_fault", start: 50, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "battery_fault", start: 51, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "motor_fault", start: 52, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "ready", start: 53, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "system_fault", start: 54, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "charging", start: 55, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "ebd_fault", start: 56, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "abs_fault", start: 57, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "turtle_mode", start: 58, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "charge_connected", start: 59, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_connected"), (1, "connected")] },
    SignalInfo { name: "cruise", start: 60, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "battery_low", start: 61, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "buzzer", start: 62, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "sport_mode", start: 63, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "eco"), (1, "sport")] },
];

static VCU_TO_MCU_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "work_mode", start: 0, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(1, "traction"), (2, "braking")] },
    SignalInfo { name: "control_mode", start: 2, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 1, invalid_raw: None, mux: Mux::Selector, life: None, values: &[(1, "torque"), (2, "speed")] },
    SignalInfo { name: "direction", start: 4, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "ccw"), (2, "cw")] },
    SignalInfo { name: "torque", start: 8, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "Nm", range: (0, 300), start_raw: 0, invalid_raw: None, mux: Mux::When(1), life: None, values: &[] },
    SignalInfo { name: "speed", start: 8, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "rpm", range: (0, 15000), start_raw: 0, invalid_raw: None, mux: Mux::When(2), life: None, values: &[] },
    SignalInfo { name: "max_speed_low", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::When(1), life: None, values: &[] },
    SignalInfo { name: "max_torque_low", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::When(2), life: None, values: &[] },
];

/// Every message of the vehicle, in the order of the DBC: for tools.
pub static MESSAGES: &[MessageInfo] = &[
    MessageInfo { id: CanId::extended(0x1807F427), name: "VCUToBMS", sender: "VCU", len: 8, cycle_ms: 200, slow_cycle_ms: 200, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_vcu_to_bms, set: set_vcu_to_bms, signals: VCU_TO_BMS_SIGNALS },
    MessageInfo { id: CanId::extended(0x182127F4), name: "BMSA", sender: "BMS", len: 8, cycle_ms: 200, slow_cycle_ms: 200, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bmsa, set: set_bmsa, signals: BMSA_SIGNALS },
    MessageInfo { id: CanId::extended(0x182227F4), name: "BMSB", sender: "BMS", len: 8, cycle_ms: 200, slow_cycle_ms: 200, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bmsb, set: set_bmsb, signals: BMSB_SIGNALS },
    MessageInfo { id: CanId::extended(0x182327F4), name: "BMSC", sender: "BMS", len: 8, cycle_ms: 200, slow_cycle_ms: 200, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bmsc, set: set_bmsc, signals: BMSC_SIGNALS },
    MessageInfo { id: CanId::extended(0x182427F4), name: "BMSD", sender: "BMS", len: 8, cycle_ms: 200, slow_cycle_ms: 200, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bmsd, set: set_bmsd, signals: BMSD_SIGNALS },
    MessageInfo { id: CanId::extended(0x1840FFE5), name: "ChargerTx", sender: "OBC", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_charger_tx, set: set_charger_tx, signals: CHARGER_TX_SIGNALS },
    MessageInfo { id: CanId::extended(0x1830E5F4), name: "ChargerControl", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_charger_control, set: set_charger_control, signals: CHARGER_CONTROL_SIGNALS },
    MessageInfo { id: CanId::extended(0x1820E5F4), name: "ChargerVoltageLimits", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_charger_voltage_limits, set: set_charger_voltage_limits, signals: CHARGER_VOLTAGE_LIMITS_SIGNALS },
    MessageInfo { id: CanId::extended(0x1810E5F4), name: "ChargerCurrentLimits", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_charger_current_limits, set: set_charger_current_limits, signals: CHARGER_CURRENT_LIMITS_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C21727), name: "VCUToCluster", sender: "VCU", len: 8, cycle_ms: 200, slow_cycle_ms: 200, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_vcu_to_cluster, set: set_vcu_to_cluster, signals: VCU_TO_CLUSTER_SIGNALS },
    MessageInfo { id: CanId::extended(0x0801EF27), name: "VCUToMCU", sender: "VCU", len: 8, cycle_ms: 20, slow_cycle_ms: 20, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_vcu_to_mcu, set: set_vcu_to_mcu, signals: VCU_TO_MCU_SIGNALS },
];

static RX: &[RxMessage] = &[
    RxMessage { id: CanId::extended(0x182127F4), name: "BMSA", node: Node::Bms, len: 8, cycle_ms: 200, timeout_ms: 1000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x182227F4), name: "BMSB", node: Node::Bms, len: 8, cycle_ms: 200, timeout_ms: 1000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x182327F4), name: "BMSC", node: Node::Bms, len: 8, cycle_ms: 200, timeout_ms: 1000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x182427F4), name: "BMSD", node: Node::Bms, len: 8, cycle_ms: 200, timeout_ms: 1000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x1840FFE5), name: "ChargerTx", node: Node::Charger, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x18C21727), name: "VCUToCluster", node: Node::Vcu, len: 8, cycle_ms: 200, timeout_ms: 1000, life: None, checksum: None, expected: true, vital: false },
];

static TX: &[TxMessage] = &[
];

/// Texts of the fault codes, sorted by source and code.
pub static FAULTS: &[FaultText] = &[
    FaultText { source: Node::Bms, code: 1, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体电压高1", en: "Cell overvoltage 1" },
    FaultText { source: Node::Bms, code: 2, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体电压低1", en: "Cell undervoltage 1" },
    FaultText { source: Node::Bms, code: 3, severity: Some(Severity::Warn), fire: false, limps: false, zh: "总电压过高1", en: "Pack overvoltage 1" },
    FaultText { source: Node::Bms, code: 4, severity: Some(Severity::Warn), fire: false, limps: false, zh: "SOC低1", en: "Charge low 1" },
    FaultText { source: Node::Bms, code: 5, severity: Some(Severity::Warn), fire: false, limps: false, zh: "放电电流大1", en: "Discharge current 1" },
    FaultText { source: Node::Bms, code: 6, severity: Some(Severity::Warn), fire: false, limps: false, zh: "回馈电流大1", en: "Regen current 1" },
    FaultText { source: Node::Bms, code: 7, severity: Some(Severity::Warn), fire: false, limps: false, zh: "电池温度高1", en: "Battery hot 1" },
    FaultText { source: Node::Bms, code: 8, severity: Some(Severity::Warn), fire: false, limps: false, zh: "电池温度低1", en: "Battery cold 1" },
    FaultText { source: Node::Bms, code: 9, severity: Some(Severity::Derate), fire: false, limps: false, zh: "单体电压高2", en: "Cell overvoltage 2" },
    FaultText { source: Node::Bms, code: 10, severity: Some(Severity::Derate), fire: false, limps: false, zh: "单体电压低2", en: "Cell undervoltage 2" },
    FaultText { source: Node::Bms, code: 11, severity: Some(Severity::Derate), fire: false, limps: false, zh: "总电压过高2", en: "Pack overvoltage 2" },
    FaultText { source: Node::Bms, code: 12, severity: Some(Severity::Derate), fire: false, limps: false, zh: "SOC低2", en: "Charge low 2" },
    FaultText { source: Node::Bms, code: 13, severity: Some(Severity::Derate), fire: false, limps: false, zh: "放电电流大2", en: "Discharge current 2" },
    FaultText { source: Node::Bms, code: 14, severity: Some(Severity::Derate), fire: false, limps: false, zh: "回馈电流大2", en: "Regen current 2" },
    FaultText { source: Node::Bms, code: 15, severity: Some(Severity::Derate), fire: false, limps: false, zh: "电池温度高2", en: "Battery hot 2" },
    FaultText { source: Node::Bms, code: 16, severity: Some(Severity::Derate), fire: false, limps: false, zh: "电池温度低2", en: "Battery cold 2" },
    FaultText { source: Node::Bms, code: 17, severity: None, fire: false, limps: false, zh: "BMS自检故障", en: "Battery self-check" },
    FaultText { source: Node::Bms, code: 18, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体压差大1", en: "Cells uneven 1" },
    FaultText { source: Node::Bms, code: 19, severity: Some(Severity::Warn), fire: false, limps: false, zh: "总电压过低1", en: "Pack undervoltage 1" },
    FaultText { source: Node::Bms, code: 20, severity: Some(Severity::Warn), fire: false, limps: false, zh: "温度差大1", en: "Temperatures uneven 1" },
    FaultText { source: Node::Bms, code: 21, severity: Some(Severity::Warn), fire: false, limps: false, zh: "绝缘故障1", en: "Insulation 1" },
    FaultText { source: Node::Bms, code: 22, severity: None, fire: false, limps: false, zh: "正极继电器断开故障", en: "Positive relay open fault" },
    FaultText { source: Node::Bms, code: 23, severity: None, fire: false, limps: false, zh: "正极继电器闭合故障", en: "Positive relay close fault" },
    FaultText { source: Node::Bms, code: 24, severity: Some(Severity::Derate), fire: false, limps: false, zh: "单体压差大2", en: "Cells uneven 2" },
    FaultText { source: Node::Bms, code: 25, severity: Some(Severity::Derate), fire: false, limps: false, zh: "总电压过低2", en: "Pack undervoltage 2" },
    FaultText { source: Node::Bms, code: 26, severity: Some(Severity::Derate), fire: false, limps: false, zh: "温度差大2", en: "Temperatures uneven 2" },
    FaultText { source: Node::Bms, code: 27, severity: Some(Severity::Derate), fire: false, limps: false, zh: "绝缘报警2", en: "Insulation 2" },
    FaultText { source: Node::Bms, code: 28, severity: None, fire: false, limps: false, zh: "高压互锁故障", en: "HV interlock open" },
    FaultText { source: Node::Bms, code: 29, severity: None, fire: false, limps: false, zh: "负极继电器断开故障", en: "Negative relay open fault" },
    FaultText { source: Node::Bms, code: 30, severity: None, fire: false, limps: false, zh: "负极继电器闭合故障", en: "Negative relay close fault" },
];

static NODES: &[NodeName] = &[
    NodeName { node: Node::Vcu, zh: "整车控制器", en: "Vehicle controller" },
    NodeName { node: Node::Bms, zh: "电池系统", en: "Battery" },
    NodeName { node: Node::Charger, zh: "充电机", en: "Charger" },
];

static STREAMS: &[Stream] = &[
];

static IDS: &[CanId] = &[
    CanId::extended(0x0801EF27),
    CanId::extended(0x1807F427),
    CanId::extended(0x1810E5F4),
    CanId::extended(0x1820E5F4),
    CanId::extended(0x182127F4),
    CanId::extended(0x182227F4),
    CanId::extended(0x182327F4),
    CanId::extended(0x182427F4),
    CanId::extended(0x1830E5F4),
    CanId::extended(0x1840FFE5),
    CanId::extended(0x18C21727),
];

fn decode_bmsa(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bmsa(*data);
    let raw = frame.pack_current_raw();
    readings.put(source, Value::BatteryCurrent, raw as i32 - 5000, raw <= 10000);
    let raw = frame.max_charge_current_raw();
    readings.put(source, Value::BatteryChargeLimit, (raw as i32 - 5000).abs(), raw <= 5000);
    let raw = frame.max_discharge_current_raw();
    readings.put(source, Value::BatteryDischargeLimit, raw as i32, raw <= 5000);
    let raw = frame.soh_raw();
    readings.put(source, Value::BatteryHealth, (raw as i32) * 4, raw <= 250);
}

fn decode_bmsb(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bmsb(*data);
    let raw = frame.max_cell_voltage_raw();
    readings.put(source, Value::BatteryCellMax, raw as i32, raw <= 5000);
    let raw = frame.min_cell_voltage_raw();
    readings.put(source, Value::BatteryCellMin, raw as i32, raw <= 5000);
}

fn decode_bmsc(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bmsc(*data);
    let raw = frame.positive_open_request_raw();
    readings.put(source, Value::BatteryHvOffRequest, raw as i32, true);
    let raw = frame.max_temperature_raw();
    readings.put(source, Value::BatteryTemperatureMax, raw as i32 - 50, raw <= 200);
    let raw = frame.min_temperature_raw();
    readings.put(source, Value::BatteryTemperatureMin, raw as i32 - 50, raw <= 200);
    let raw = frame.positive_contactor_raw();
    readings.put(source, Value::ContactorMain, raw as i32, true);
    let raw = frame.negative_contactor_raw();
    readings.put(source, Value::ContactorNegative, raw as i32, true);
}

fn decode_bmsd(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bmsd(*data);
    readings.put(source, Value::BatteryAlarms, frame.0[0] as i32 | (frame.0[1] as i32) << 8 | ((frame.0[2] & 0xC0) as i32) << 15 | ((frame.0[2] & 0x1F) as i32) << 16 | ((frame.0[3] & 0xFE) as i32) << 22, true);
    let raw = frame.positive_insulation_raw();
    readings.put(source, Value::InsulationPositive, codec::floor_div(raw as i32, 10), true);
    let raw = frame.negative_insulation_raw();
    readings.put(source, Value::InsulationNegative, codec::floor_div(raw as i32, 10), true);
}

fn decode_charger_tx(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = ChargerTx(*data);
    let raw = frame.output_voltage_raw();
    readings.put(source, Value::ChargerVoltage, raw as i32, raw <= 3600);
    let raw = frame.output_current_raw();
    readings.put(source, Value::ChargerCurrent, raw as i32, raw <= 160);
    let set = (frame.0[4] & 0x0F | frame.0[5] & 0x03) != 0;
    readings.put(source, Value::ChargerFault, set as i32, true);
}

fn decode_vcu_to_cluster(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = VcuToCluster(*data);
    let raw = frame.vehicle_speed_raw();
    readings.put(source, Value::VehicleSpeed, (raw as i32) * 256, raw <= 150);
    let state = STATES_0[(frame.gear_raw() & 3) as usize];
    readings.put(source, Value::VehicleGear, state, state != INVALID);
    let raw = frame.ready_raw();
    readings.put(source, Value::VehicleReady, raw as i32, true);
    let raw = frame.system_fault_raw();
    readings.put(source, Value::VehicleFault, raw as i32, true);
    let raw = frame.turtle_mode_raw();
    readings.put(source, Value::VehiclePowerLimited, raw as i32, true);
    let raw = frame.remaining_range_raw();
    readings.put(source, Value::VehicleRange, (raw as i32) * 8, raw <= 150);
    let raw = frame.buzzer_raw();
    readings.put(source, Value::VehicleBuzzer, raw as i32, true);
    let raw = frame.cruise_raw();
    readings.put(source, Value::VehicleCruise, raw as i32, true);
    let state = STATES_1[(frame.sport_mode_raw() & 1) as usize];
    readings.put(source, Value::VehicleEconomy, state, state != INVALID);
    let raw = frame.abs_fault_raw();
    readings.put(source, Value::BrakeAbsFault, raw as i32, true);
    let raw = frame.ebd_fault_raw();
    readings.put(source, Value::BrakeEbdFault, raw as i32, true);
    let raw = frame.battery_voltage_raw();
    readings.put(source, Value::BatteryVoltage, (raw as i32) * 10, raw <= 400);
    let raw = frame.soc_raw();
    readings.put(source, Value::BatterySoc, (raw as i32) * 5, raw <= 200);
    let raw = frame.battery_fault_raw();
    readings.put(source, Value::BatteryFault, raw as i32, true);
    let raw = frame.battery_low_raw();
    readings.put(source, Value::BatteryLow, raw as i32, true);
    let raw = frame.charging_raw();
    readings.put(source, Value::ChargeState, raw as i32, true);
    let raw = frame.charge_connected_raw();
    readings.put(source, Value::ChargePlug, raw as i32, true);
    let raw = frame.motor_fault_raw();
    readings.put(source, Value::MotorFault, raw as i32, true);
    let raw = frame.motor_power_raw();
    readings.put(source, Value::MotorPower, (raw as i32) * 1000 - 50000, raw <= 130);
    let raw = frame.insulation_fault_raw();
    readings.put(source, Value::InsulationFault, raw as i32, true);
}

static STATES_0: [i32; 4] = [3, 1, 2, 4];

static STATES_1: [i32; 2] = [1, 0];

static DECODERS: [fn(u8, &[u8; 8], &mut Readings); 6] = [
    decode_bmsa,
    decode_bmsb,
    decode_bmsc,
    decode_bmsd,
    decode_charger_tx,
    decode_vcu_to_cluster,
];

fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    if let Some(decode) = DECODERS.get(index as usize) {
        decode(index, data, readings);
    }
}

fn encode(_index: u8, _values: &Readings) -> [u8; 8] {
    [0; 8]
}

/// C5EV electric car (C5EV纯电动汽车).
pub static VEHICLE: Vehicle = Vehicle {
    name: "c5ev",
    zh: "C5EV纯电动汽车",
    en: "C5EV electric car",
    bitrate: 250000,
    worst_level: 3,
    rules: Rules { hv_off: None, limp: None, charger_loss_ms: Some(5000), hvac_loss_ms: None, buzzer_ms: Some(120000) },
    rx: RX,
    decode,
    streams: STREAMS,
    ids: IDS,
    tx: TX,
    encode,
    faults: FAULTS,
    nodes: NODES,
};
