//! Vehicle `citybus`: Electric bus (纯电动客车).
//!
//! Generated from `vehicles/citybus/citybus.dbc` and `vehicles/citybus/vehicle.toml`; refresh with `cargo xtask codegen`.

use crate::checksum::{Checksum, ChecksumKind};
use crate::codec::{self, Got, LifeKind, MessageInfo, Mux, Order, Scale, SignalInfo};
use crate::frame::CanId;
use crate::model::{INVALID, Readings, Severity, Value};
use crate::stream::{Bound, Cell, Stream};
use crate::vehicle::{FaultText, HvOffRule, Life, LimpRule, Node, NodeName, Rules, RxMessage, TxMessage, Vehicle};

/// Identifiers.
pub mod id {
    use crate::frame::CanId;

    /// VCU1.
    pub const VCU1: CanId = CanId::extended(0x0CF101A7);
    /// VCU2.
    pub const VCU2: CanId = CanId::extended(0x0CF102A7);
    /// VCU3.
    pub const VCU3: CanId = CanId::extended(0x0CF103A7);
    /// VCU4.
    pub const VCU4: CanId = CanId::extended(0x0C3C494A);
    /// VCU5.
    pub const VCU5: CanId = CanId::extended(0x0C3C514A);
    /// VCU6.
    pub const VCU6: CanId = CanId::extended(0x0CF105A7);
    /// VCU7.
    pub const VCU7: CanId = CanId::extended(0x0CF1064A);
    /// VCU8.
    pub const VCU8: CanId = CanId::extended(0x0C3C4D4A);
    /// VCU9.
    pub const VCU9: CanId = CanId::extended(0x18F105D0);
    /// VCU10.
    pub const VCU10: CanId = CanId::extended(0x1801A9EF);
    /// IPU1.
    pub const IPU1: CanId = CanId::extended(0x18F11FF0);
    /// IPU2.
    pub const IPU2: CanId = CanId::extended(0x18F120F0);
    /// IPU3.
    pub const IPU3: CanId = CanId::extended(0x18F121F0);
    /// BMS1.
    pub const BMS1: CanId = CanId::extended(0x18F13DF3);
    /// BMS2.
    pub const BMS2: CanId = CanId::extended(0x18F13EF3);
    /// BMS4.
    pub const BMS4: CanId = CanId::extended(0x18F140F3);
    /// BMS5.
    pub const BMS5: CanId = CanId::extended(0x18F141F3);
    /// BMS6.
    pub const BMS6: CanId = CanId::extended(0x18F142F3);
    /// BMS7.
    pub const BMS7: CanId = CanId::extended(0x18F143F3);
    /// BMS8.
    pub const BMS8: CanId = CanId::extended(0x18F144F3);
    /// BMS9.
    pub const BMS9: CanId = CanId::extended(0x18F145F3);
    /// BMS10.
    pub const BMS10: CanId = CanId::extended(0x18F146F3);
    /// BMS11.
    pub const BMS11: CanId = CanId::extended(0x18F147F3);
    /// BMS12.
    pub const BMS12: CanId = CanId::extended(0x18F148F3);
    /// SteeringPump.
    pub const STEERING_PUMP: CanId = CanId::extended(0x142FFF95);
    /// LowVoltageSteering.
    pub const LOW_VOLTAGE_STEERING: CanId = CanId::extended(0x0CF603A1);
    /// DCDC.
    pub const DCDC: CanId = CanId::extended(0x142CFF98);
    /// AirPump.
    pub const AIR_PUMP: CanId = CanId::extended(0x1429FF9B);
    /// Meter1.
    pub const METER1: CanId = CanId::extended(0x18F43A17);
    /// Meter2.
    pub const METER2: CanId = CanId::extended(0x18F54A17);
    /// HVAC.
    pub const HVAC: CanId = CanId::extended(0x18FFC09E);
    /// Insulation.
    pub const INSULATION: CanId = CanId::extended(0x18F746E5);
    /// ChargerTx.
    pub const CHARGER_TX: CanId = CanId::extended(0x18F1F399);
    /// ChargerRx.
    pub const CHARGER_RX: CanId = CanId::extended(0x18F199F3);
    /// PEU.
    pub const PEU: CanId = CanId::extended(0x1801EFA9);
}

/// VCU1 (0CF101A7) from VCU, every 20 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu1(pub [u8; 8]);

impl Default for Vcu1 {
    fn default() -> Self { Self::new() }
}

impl Vcu1 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0x00, 0x00]) }

    /// Returns `drive_mode` as sent: 2 bits from bit 0.
    #[inline(always)]
    pub const fn drive_mode_raw(self) -> u8 { self.0[0] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn drive_mode(self) -> Option<i32> {
        let raw = self.drive_mode_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `drive_mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_drive_mode_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `gear` as sent: 4 bits from bit 2.
    #[inline(always)]
    pub const fn gear_raw(self) -> u8 { self.0[0] >> 2 & 0x0F }
    /// Returns the value, 0 to 11; `None` if not valid.
    #[inline(always)]
    pub const fn gear(self) -> Option<i32> {
        let raw = self.gear_raw();
        if raw <= 11 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `gear` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_gear_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xC3 | (raw & 0x0F) << 2;
        self
    }

    /// Returns `handbrake` as sent: 1 bit from bit 6.
    #[inline(always)]
    pub const fn handbrake_raw(self) -> u8 { self.0[0] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn handbrake(self) -> Option<i32> {
        let raw = self.handbrake_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `handbrake` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_handbrake_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `foot_brake` as sent: 1 bit from bit 7.
    #[inline(always)]
    pub const fn foot_brake_raw(self) -> u8 { self.0[0] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn foot_brake(self) -> Option<i32> {
        let raw = self.foot_brake_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `foot_brake` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_foot_brake_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `accelerator_pedal` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn accelerator_pedal_raw(self) -> u8 { self.0[1] }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn accelerator_pedal(self) -> Option<i32> {
        let raw = self.accelerator_pedal_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `accelerator_pedal` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_accelerator_pedal_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `vehicle_speed` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn vehicle_speed_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/256 km/h, 0 to 51200; `None` if not valid.
    #[inline(always)]
    pub const fn vehicle_speed(self) -> Option<i32> {
        let raw = self.vehicle_speed_raw();
        if raw <= 51200 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `vehicle_speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vehicle_speed_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `brake_pedal` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn brake_pedal_raw(self) -> u8 { self.0[4] }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn brake_pedal(self) -> Option<i32> {
        let raw = self.brake_pedal_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `brake_pedal` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_brake_pedal_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `torque_limited` as sent: 1 bit from bit 48.
    #[inline(always)]
    pub const fn torque_limited_raw(self) -> u8 { self.0[6] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn torque_limited(self) -> Option<i32> {
        let raw = self.torque_limited_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `torque_limited` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_torque_limited_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `power_limited` as sent: 1 bit from bit 49.
    #[inline(always)]
    pub const fn power_limited_raw(self) -> u8 { self.0[6] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn power_limited(self) -> Option<i32> {
        let raw = self.power_limited_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `power_limited` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_power_limited_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFD | (raw & 0x01) << 1;
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

    /// Returns `ready` as sent: 1 bit from bit 55.
    #[inline(always)]
    pub const fn ready_raw(self) -> u8 { self.0[6] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn ready(self) -> Option<i32> {
        let raw = self.ready_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `ready` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_ready_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// VCU2 (0CF102A7) from VCU, every 20 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu2(pub [u8; 8]);

impl Default for Vcu2 {
    fn default() -> Self { Self::new() }
}

impl Vcu2 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF]) }

    /// Returns `target_torque` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn target_torque_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 Nm, -30000 to 30000; `None` if not valid.
    #[inline(always)]
    pub const fn target_torque(self) -> Option<i32> {
        let raw = self.target_torque_raw();
        if raw <= 60000 { Some(raw as i32 - 30000) } else { None }
    }
    /// Returns the frame with `target_torque` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_target_torque_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `ipu_enable` as sent: 1 bit from bit 16.
    #[inline(always)]
    pub const fn ipu_enable_raw(self) -> u8 { self.0[2] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn ipu_enable(self) -> Option<i32> {
        let raw = self.ipu_enable_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `ipu_enable` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_ipu_enable_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `discharge_enable` as sent: 1 bit from bit 23.
    #[inline(always)]
    pub const fn discharge_enable_raw(self) -> u8 { self.0[2] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn discharge_enable(self) -> Option<i32> {
        let raw = self.discharge_enable_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `discharge_enable` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_discharge_enable_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `control_mode` as sent: 2 bits from bit 24.
    #[inline(always)]
    pub const fn control_mode_raw(self) -> u8 { self.0[3] & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn control_mode(self) -> Option<i32> {
        let raw = self.control_mode_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `control_mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_control_mode_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `power_limit` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn power_limit_raw(self) -> u8 { self.0[4] }
    /// Returns the value in kW, 1 to 250; `None` if not valid.
    #[inline(always)]
    pub const fn power_limit(self) -> Option<i32> {
        let raw = self.power_limit_raw();
        if raw >= 1 && raw <= 250 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `power_limit` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_power_limit_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }
}

/// VCU3 (0CF103A7) from VCU, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu3(pub [u8; 8]);

impl Default for Vcu3 {
    fn default() -> Self { Self::new() }
}

impl Vcu3 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0xFF, 0x00, 0x00, 0x00]) }

    /// Returns `vendor_code` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn vendor_code_raw(self) -> u8 { self.0[0] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn vendor_code(self) -> Option<i32> {
        let raw = self.vendor_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `vendor_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vendor_code_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `hv_command` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn hv_command_raw(self) -> u8 { self.0[1] }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn hv_command(self) -> Option<i32> {
        let raw = self.hv_command_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `hv_command` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hv_command_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `mcu_input_voltage` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn mcu_input_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn mcu_input_voltage(self) -> Option<i32> {
        let raw = self.mcu_input_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `mcu_input_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_mcu_input_voltage_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `pantograph_state` as sent: 2 bits from bit 45.
    #[inline(always)]
    pub const fn pantograph_state_raw(self) -> u8 { self.0[5] >> 5 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn pantograph_state(self) -> Option<i32> {
        let raw = self.pantograph_state_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `pantograph_state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pantograph_state_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0x9F | (raw & 0x03) << 5;
        self
    }

    /// Returns `charge_enable` as sent: 1 bit from bit 47.
    #[inline(always)]
    pub const fn charge_enable_raw(self) -> u8 { self.0[5] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn charge_enable(self) -> Option<i32> {
        let raw = self.charge_enable_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_enable` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_enable_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `hv_cutoff` as sent: 1 bit from bit 48.
    #[inline(always)]
    pub const fn hv_cutoff_raw(self) -> u8 { self.0[6] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn hv_cutoff(self) -> Option<i32> {
        let raw = self.hv_cutoff_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hv_cutoff` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hv_cutoff_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `precharge_relay` as sent: 1 bit from bit 49.
    #[inline(always)]
    pub const fn precharge_relay_raw(self) -> u8 { self.0[6] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn precharge_relay(self) -> Option<i32> {
        let raw = self.precharge_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `precharge_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_precharge_relay_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `motor_relay` as sent: 1 bit from bit 50.
    #[inline(always)]
    pub const fn motor_relay_raw(self) -> u8 { self.0[6] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn motor_relay(self) -> Option<i32> {
        let raw = self.motor_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `motor_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_relay_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `accessory_relay` as sent: 1 bit from bit 51.
    #[inline(always)]
    pub const fn accessory_relay_raw(self) -> u8 { self.0[6] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn accessory_relay(self) -> Option<i32> {
        let raw = self.accessory_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `accessory_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_accessory_relay_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `accessory_precharge_relay` as sent: 1 bit from bit 52.
    #[inline(always)]
    pub const fn accessory_precharge_relay_raw(self) -> u8 { self.0[6] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn accessory_precharge_relay(self) -> Option<i32> {
        let raw = self.accessory_precharge_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `accessory_precharge_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_accessory_precharge_relay_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `defrost_relay` as sent: 1 bit from bit 53.
    #[inline(always)]
    pub const fn defrost_relay_raw(self) -> u8 { self.0[6] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn defrost_relay(self) -> Option<i32> {
        let raw = self.defrost_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `defrost_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_defrost_relay_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `charge_relay` as sent: 1 bit from bit 54.
    #[inline(always)]
    pub const fn charge_relay_raw(self) -> u8 { self.0[6] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn charge_relay(self) -> Option<i32> {
        let raw = self.charge_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_relay_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `battery_relay` as sent: 1 bit from bit 55.
    #[inline(always)]
    pub const fn battery_relay_raw(self) -> u8 { self.0[6] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn battery_relay(self) -> Option<i32> {
        let raw = self.battery_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `battery_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_battery_relay_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// VCU4 (0C3C494A) from VCU, every 50 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu4(pub [u8; 8]);

impl Default for Vcu4 {
    fn default() -> Self { Self::new() }
}

impl Vcu4 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00]) }

    /// Returns `fault_reset` as sent: 1 bit from bit 0.
    #[inline(always)]
    pub const fn fault_reset_raw(self) -> u8 { self.0[0] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn fault_reset(self) -> Option<i32> {
        let raw = self.fault_reset_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_reset` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_reset_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `run` as sent: 1 bit from bit 6.
    #[inline(always)]
    pub const fn run_raw(self) -> u8 { self.0[0] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn run(self) -> Option<i32> {
        let raw = self.run_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `run` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_run_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `frequency` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn frequency_raw(self) -> u8 { self.0[1] }
    /// Returns the value in Hz, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn frequency(self) -> Option<i32> {
        let raw = self.frequency_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `frequency` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_frequency_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// VCU5 (0C3C514A) from VCU, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu5(pub [u8; 8]);

impl Default for Vcu5 {
    fn default() -> Self { Self::new() }
}

impl Vcu5 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `reset` as sent: 1 bit from bit 0.
    #[inline(always)]
    pub const fn reset_raw(self) -> u8 { self.0[0] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn reset(self) -> Option<i32> {
        let raw = self.reset_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `reset` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_reset_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `derate` as sent: 1 bit from bit 5.
    #[inline(always)]
    pub const fn derate_raw(self) -> u8 { self.0[0] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn derate(self) -> Option<i32> {
        let raw = self.derate_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `derate` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_derate_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `start_permit` as sent: 1 bit from bit 6.
    #[inline(always)]
    pub const fn start_permit_raw(self) -> u8 { self.0[0] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn start_permit(self) -> Option<i32> {
        let raw = self.start_permit_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `start_permit` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_start_permit_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `aux_battery_voltage` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn aux_battery_voltage_raw(self) -> u8 { self.0[4] }
    /// Returns the value in V, 0 to 40; `None` if not valid.
    #[inline(always)]
    pub const fn aux_battery_voltage(self) -> Option<i32> {
        let raw = self.aux_battery_voltage_raw();
        if raw <= 40 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `aux_battery_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_aux_battery_voltage_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `soc` as sent: 16 bits down from bit 47.
    #[inline(always)]
    pub const fn soc_raw(self) -> u16 { u16::from_be_bytes([self.0[5], self.0[6]]) }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn soc(self) -> Option<i32> {
        let raw = self.soc_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u16) -> Self {
        self.0[6] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// VCU6 (0CF105A7) from VCU, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu6(pub [u8; 8]);

impl Default for Vcu6 {
    fn default() -> Self { Self::new() }
}

impl Vcu6 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0x00]) }

    /// Returns `input_voltage_limit` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn input_voltage_limit_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn input_voltage_limit(self) -> Option<i32> {
        let raw = self.input_voltage_limit_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `input_voltage_limit` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_input_voltage_limit_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `start_battery_voltage` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn start_battery_voltage_raw(self) -> u8 { self.0[2] }
    /// Returns the value in V, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn start_battery_voltage(self) -> Option<i32> {
        let raw = self.start_battery_voltage_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `start_battery_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_start_battery_voltage_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `command` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn command_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 85 to 170; `None` if not valid.
    #[inline(always)]
    pub const fn command(self) -> Option<i32> {
        let raw = self.command_raw();
        if raw >= 85 && raw <= 170 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `command` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_command_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// VCU7 (0CF1064A) from VCU, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu7(pub [u8; 8]);

impl Default for Vcu7 {
    fn default() -> Self { Self::new() }
}

impl Vcu7 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0xFF, 0x00, 0xFF, 0xFF, 0xFF]) }

    /// Returns `fault_level` as sent: 3 bits from bit 0.
    #[inline(always)]
    pub const fn fault_level_raw(self) -> u8 { self.0[0] & 0x07 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn fault_level(self) -> Option<i32> {
        let raw = self.fault_level_raw();
        if raw <= 3 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xF8 | raw & 0x07;
        self
    }

    /// Returns `dtc` as sent: 16 bits from bit 8.
    #[inline(always)]
    pub const fn dtc_raw(self) -> u16 { u16::from_le_bytes([self.0[1], self.0[2]]) }
    /// Returns the value, 0 to 65535; `None` if not valid.
    #[inline(always)]
    pub const fn dtc(self) -> Option<i32> {
        let raw = self.dtc_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `dtc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_dtc_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `dryer_pressure_switch` as sent: 1 bit from bit 32.
    #[inline(always)]
    pub const fn dryer_pressure_switch_raw(self) -> u8 { self.0[4] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn dryer_pressure_switch(self) -> Option<i32> {
        let raw = self.dryer_pressure_switch_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `dryer_pressure_switch` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_dryer_pressure_switch_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `compressor_over_temperature` as sent: 1 bit from bit 33.
    #[inline(always)]
    pub const fn compressor_over_temperature_raw(self) -> u8 { self.0[4] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn compressor_over_temperature(self) -> Option<i32> {
        let raw = self.compressor_over_temperature_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `compressor_over_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_compressor_over_temperature_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFD | (raw & 0x01) << 1;
        self
    }
}

/// VCU8 (0C3C4D4A) from VCU, every 50 ms.
pub type Vcu8 = Vcu4;

/// VCU9 (18F105D0) from VCU, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu9(pub [u8; 8]);

impl Default for Vcu9 {
    fn default() -> Self { Self::new() }
}

impl Vcu9 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0xFF]) }

    /// Returns `oil_pump_command` as sent: 2 bits from bit 0.
    #[inline(always)]
    pub const fn oil_pump_command_raw(self) -> u8 { self.0[0] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn oil_pump_command(self) -> Option<i32> {
        let raw = self.oil_pump_command_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `oil_pump_command` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_oil_pump_command_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `vehicle_speed` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn vehicle_speed_raw(self) -> u8 { self.0[6] }
    /// Returns the value in km/h, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn vehicle_speed(self) -> Option<i32> {
        let raw = self.vehicle_speed_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `vehicle_speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vehicle_speed_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }
}

/// VCU10 (1801A9EF) from VCU, every 50 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu10(pub [u8; 8]);

impl Default for Vcu10 {
    fn default() -> Self { Self::new() }
}

impl Vcu10 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0x00]) }

    /// Returns `positive_contactor` as sent: 2 bits from bit 0.
    #[inline(always)]
    pub const fn positive_contactor_raw(self) -> u8 { self.0[0] & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn positive_contactor(self) -> Option<i32> {
        let raw = self.positive_contactor_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `positive_contactor` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_contactor_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `negative_contactor` as sent: 2 bits from bit 2.
    #[inline(always)]
    pub const fn negative_contactor_raw(self) -> u8 { self.0[0] >> 2 & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn negative_contactor(self) -> Option<i32> {
        let raw = self.negative_contactor_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `negative_contactor` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_contactor_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `positive_precharge` as sent: 2 bits from bit 4.
    #[inline(always)]
    pub const fn positive_precharge_raw(self) -> u8 { self.0[0] >> 4 & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn positive_precharge(self) -> Option<i32> {
        let raw = self.positive_precharge_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `positive_precharge` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_precharge_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `negative_precharge` as sent: 2 bits from bit 6.
    #[inline(always)]
    pub const fn negative_precharge_raw(self) -> u8 { self.0[0] >> 6 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn negative_precharge(self) -> Option<i32> {
        let raw = self.negative_precharge_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `negative_precharge` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_precharge_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0x3F | (raw & 0x03) << 6;
        self
    }

    /// Returns `defrost` as sent: 2 bits from bit 8.
    #[inline(always)]
    pub const fn defrost_raw(self) -> u8 { self.0[1] & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn defrost(self) -> Option<i32> {
        let raw = self.defrost_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `defrost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_defrost_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `hvac` as sent: 2 bits from bit 10.
    #[inline(always)]
    pub const fn hvac_raw(self) -> u8 { self.0[1] >> 2 & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn hvac(self) -> Option<i32> {
        let raw = self.hvac_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `hvac` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hvac_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `battery_heater` as sent: 2 bits from bit 12.
    #[inline(always)]
    pub const fn battery_heater_raw(self) -> u8 { self.0[1] >> 4 & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn battery_heater(self) -> Option<i32> {
        let raw = self.battery_heater_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `battery_heater` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_battery_heater_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `heater` as sent: 2 bits from bit 14.
    #[inline(always)]
    pub const fn heater_raw(self) -> u8 { self.0[1] >> 6 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn heater(self) -> Option<i32> {
        let raw = self.heater_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `heater` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_heater_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0x3F | (raw & 0x03) << 6;
        self
    }

    /// Returns `charge` as sent: 2 bits from bit 16.
    #[inline(always)]
    pub const fn charge_raw(self) -> u8 { self.0[2] & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn charge(self) -> Option<i32> {
        let raw = self.charge_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `charge` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `accessory` as sent: 2 bits from bit 18.
    #[inline(always)]
    pub const fn accessory_raw(self) -> u8 { self.0[2] >> 2 & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn accessory(self) -> Option<i32> {
        let raw = self.accessory_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `accessory` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_accessory_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `accessory_precharge` as sent: 2 bits from bit 20.
    #[inline(always)]
    pub const fn accessory_precharge_raw(self) -> u8 { self.0[2] >> 4 & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn accessory_precharge(self) -> Option<i32> {
        let raw = self.accessory_precharge_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `accessory_precharge` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_accessory_precharge_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `contactor_4` as sent: 2 bits from bit 22.
    #[inline(always)]
    pub const fn contactor_4_raw(self) -> u8 { self.0[2] >> 6 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn contactor_4(self) -> Option<i32> {
        let raw = self.contactor_4_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `contactor_4` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_contactor_4_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0x3F | (raw & 0x03) << 6;
        self
    }

    /// Returns `contactor_5` as sent: 2 bits from bit 24.
    #[inline(always)]
    pub const fn contactor_5_raw(self) -> u8 { self.0[3] & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn contactor_5(self) -> Option<i32> {
        let raw = self.contactor_5_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `contactor_5` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_contactor_5_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `contactor_6` as sent: 2 bits from bit 26.
    #[inline(always)]
    pub const fn contactor_6_raw(self) -> u8 { self.0[3] >> 2 & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn contactor_6(self) -> Option<i32> {
        let raw = self.contactor_6_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `contactor_6` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_contactor_6_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `contactor_7` as sent: 2 bits from bit 28.
    #[inline(always)]
    pub const fn contactor_7_raw(self) -> u8 { self.0[3] >> 4 & 0x03 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn contactor_7(self) -> Option<i32> {
        let raw = self.contactor_7_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `contactor_7` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_contactor_7_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `contactor_8` as sent: 2 bits from bit 30.
    #[inline(always)]
    pub const fn contactor_8_raw(self) -> u8 { self.0[3] >> 6 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn contactor_8(self) -> Option<i32> {
        let raw = self.contactor_8_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `contactor_8` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_contactor_8_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0x3F | (raw & 0x03) << 6;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// IPU1 (18F11FF0) from MCU, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ipu1(pub [u8; 8]);

impl Default for Ipu1 {
    fn default() -> Self { Self::new() }
}

impl Ipu1 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0x00]) }

    /// Returns `bus_voltage` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn bus_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn bus_voltage(self) -> Option<i32> {
        let raw = self.bus_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `bus_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_voltage_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `bus_current` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn bus_current_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 A, -10000 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn bus_current(self) -> Option<i32> {
        let raw = self.bus_current_raw();
        if raw <= 20000 { Some(raw as i32 - 10000) } else { None }
    }
    /// Returns the frame with `bus_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_current_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `mode` as sent: 5 bits from bit 34.
    #[inline(always)]
    pub const fn mode_raw(self) -> u8 { self.0[4] >> 2 & 0x1F }
    /// Returns the value, 0 to 26; `None` if not valid.
    #[inline(always)]
    pub const fn mode(self) -> Option<i32> {
        let raw = self.mode_raw();
        if raw <= 26 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_mode_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0x83 | (raw & 0x1F) << 2;
        self
    }

    /// Returns `bus_overcurrent` as sent: 1 bit from bit 40.
    #[inline(always)]
    pub const fn bus_overcurrent_raw(self) -> u8 { self.0[5] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn bus_overcurrent(self) -> Option<i32> {
        let raw = self.bus_overcurrent_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `bus_overcurrent` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_overcurrent_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `position_sensor_fault` as sent: 1 bit from bit 42.
    #[inline(always)]
    pub const fn position_sensor_fault_raw(self) -> u8 { self.0[5] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn position_sensor_fault(self) -> Option<i32> {
        let raw = self.position_sensor_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `position_sensor_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_position_sensor_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `bus_overvoltage` as sent: 1 bit from bit 43.
    #[inline(always)]
    pub const fn bus_overvoltage_raw(self) -> u8 { self.0[5] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn bus_overvoltage(self) -> Option<i32> {
        let raw = self.bus_overvoltage_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `bus_overvoltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_overvoltage_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `bus_undervoltage` as sent: 1 bit from bit 44.
    #[inline(always)]
    pub const fn bus_undervoltage_raw(self) -> u8 { self.0[5] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn bus_undervoltage(self) -> Option<i32> {
        let raw = self.bus_undervoltage_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `bus_undervoltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_undervoltage_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `motor_over_temperature` as sent: 1 bit from bit 45.
    #[inline(always)]
    pub const fn motor_over_temperature_raw(self) -> u8 { self.0[5] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn motor_over_temperature(self) -> Option<i32> {
        let raw = self.motor_over_temperature_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `motor_over_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_over_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `inverter_over_temperature` as sent: 1 bit from bit 46.
    #[inline(always)]
    pub const fn inverter_over_temperature_raw(self) -> u8 { self.0[5] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn inverter_over_temperature(self) -> Option<i32> {
        let raw = self.inverter_over_temperature_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `inverter_over_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_inverter_over_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `overspeed` as sent: 1 bit from bit 47.
    #[inline(always)]
    pub const fn overspeed_raw(self) -> u8 { self.0[5] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overspeed(self) -> Option<i32> {
        let raw = self.overspeed_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overspeed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overspeed_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `life` as sent: 4 bits from bit 60.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] >> 4 }
    /// Returns the value, 0 to 15; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x0F | (raw & 0x0F) << 4;
        self
    }
}

/// IPU2 (18F120F0) from MCU, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ipu2(pub [u8; 8]);

impl Default for Ipu2 {
    fn default() -> Self { Self::new() }
}

impl Ipu2 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `peak_torque` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn peak_torque_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 Nm, -30000 to 30000; `None` if not valid.
    #[inline(always)]
    pub const fn peak_torque(self) -> Option<i32> {
        let raw = self.peak_torque_raw();
        if raw <= 60000 { Some(raw as i32 - 30000) } else { None }
    }
    /// Returns the frame with `peak_torque` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_peak_torque_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `motor_speed` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn motor_speed_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in rpm, -12000 to 12000; `None` if not valid.
    #[inline(always)]
    pub const fn motor_speed(self) -> Option<i32> {
        let raw = self.motor_speed_raw();
        if raw <= 24000 { Some(raw as i32 - 12000) } else { None }
    }
    /// Returns the frame with `motor_speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_speed_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `motor_torque` as sent: 16 bits from bit 32.
    #[inline(always)]
    pub const fn motor_torque_raw(self) -> u16 { u16::from_le_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/10 Nm, -30000 to 30000; `None` if not valid.
    #[inline(always)]
    pub const fn motor_torque(self) -> Option<i32> {
        let raw = self.motor_torque_raw();
        if raw <= 60000 { Some(raw as i32 - 30000) } else { None }
    }
    /// Returns the frame with `motor_torque` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_torque_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `motor_temperature` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn motor_temperature_raw(self) -> u8 { self.0[6] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn motor_temperature(self) -> Option<i32> {
        let raw = self.motor_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `motor_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_temperature_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `controller_temperature` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn controller_temperature_raw(self) -> u8 { self.0[7] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn controller_temperature(self) -> Option<i32> {
        let raw = self.controller_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `controller_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_controller_temperature_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// IPU3 (18F121F0) from MCU, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ipu3(pub [u8; 8]);

impl Default for Ipu3 {
    fn default() -> Self { Self::new() }
}

impl Ipu3 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF]) }

    /// Returns `status` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn status_raw(self) -> u8 { self.0[0] }
    /// Returns the value, 0 to 5; `None` if not valid.
    #[inline(always)]
    pub const fn status(self) -> Option<i32> {
        let raw = self.status_raw();
        if raw <= 5 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `status` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_status_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `fault_code` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn fault_code_raw(self) -> u8 { self.0[1] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn fault_code(self) -> Option<i32> {
        let raw = self.fault_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_code_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }
}

/// BMS1 (18F13DF3) from BMS, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms1(pub [u8; 8]);

impl Default for Bms1 {
    fn default() -> Self { Self::new() }
}

impl Bms1 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `pack_voltage` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn pack_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn pack_voltage(self) -> Option<i32> {
        let raw = self.pack_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `pack_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_voltage_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `pack_current` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn pack_current_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 A, -10000 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn pack_current(self) -> Option<i32> {
        let raw = self.pack_current_raw();
        if raw <= 20000 { Some(raw as i32 - 10000) } else { None }
    }
    /// Returns the frame with `pack_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_current_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `soc` as sent: 16 bits from bit 32.
    #[inline(always)]
    pub const fn soc_raw(self) -> u16 { u16::from_le_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn soc(self) -> Option<i32> {
        let raw = self.soc_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `fault_level` as sent: 3 bits from bit 48.
    #[inline(always)]
    pub const fn fault_level_raw(self) -> u8 { self.0[6] & 0x07 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn fault_level(self) -> Option<i32> {
        let raw = self.fault_level_raw();
        if raw <= 3 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF8 | raw & 0x07;
        self
    }

    /// Returns `hv_open_request` as sent: 2 bits from bit 51.
    #[inline(always)]
    pub const fn hv_open_request_raw(self) -> u8 { self.0[6] >> 3 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn hv_open_request(self) -> Option<i32> {
        let raw = self.hv_open_request_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hv_open_request` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hv_open_request_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xE7 | (raw & 0x03) << 3;
        self
    }

    /// Returns `check_state` as sent: 3 bits from bit 53.
    #[inline(always)]
    pub const fn check_state_raw(self) -> u8 { self.0[6] >> 5 }
    /// Returns the value, 0 to 4; `None` if not valid.
    #[inline(always)]
    pub const fn check_state(self) -> Option<i32> {
        let raw = self.check_state_raw();
        if raw <= 4 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `check_state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_check_state_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0x1F | (raw & 0x07) << 5;
        self
    }

    /// Returns `heater_relay` as sent: 2 bits from bit 56.
    #[inline(always)]
    pub const fn heater_relay_raw(self) -> u8 { self.0[7] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn heater_relay(self) -> Option<i32> {
        let raw = self.heater_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `heater_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_heater_relay_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `charge_2_relay` as sent: 2 bits from bit 58.
    #[inline(always)]
    pub const fn charge_2_relay_raw(self) -> u8 { self.0[7] >> 2 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn charge_2_relay(self) -> Option<i32> {
        let raw = self.charge_2_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_2_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_2_relay_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `charge_1_relay` as sent: 2 bits from bit 60.
    #[inline(always)]
    pub const fn charge_1_relay_raw(self) -> u8 { self.0[7] >> 4 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn charge_1_relay(self) -> Option<i32> {
        let raw = self.charge_1_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_1_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_1_relay_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `main_relay` as sent: 2 bits from bit 62.
    #[inline(always)]
    pub const fn main_relay_raw(self) -> u8 { self.0[7] >> 6 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn main_relay(self) -> Option<i32> {
        let raw = self.main_relay_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `main_relay` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_main_relay_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x3F | (raw & 0x03) << 6;
        self
    }
}

/// BMS2 (18F13EF3) from BMS, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms2(pub [u8; 8]);

impl Default for Bms2 {
    fn default() -> Self { Self::new() }
}

impl Bms2 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF]) }

    /// Returns `max_cell_voltage` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn max_cell_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn max_cell_voltage(self) -> Option<i32> {
        let raw = self.max_cell_voltage_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_cell_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_cell_voltage_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `min_cell_voltage` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn min_cell_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn min_cell_voltage(self) -> Option<i32> {
        let raw = self.min_cell_voltage_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_cell_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_cell_voltage_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_cell_temperature` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn max_cell_temperature_raw(self) -> u8 { self.0[4] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn max_cell_temperature(self) -> Option<i32> {
        let raw = self.max_cell_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `max_cell_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_cell_temperature_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `min_cell_temperature` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn min_cell_temperature_raw(self) -> u8 { self.0[5] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn min_cell_temperature(self) -> Option<i32> {
        let raw = self.min_cell_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `min_cell_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_cell_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }
}

/// BMS4 (18F140F3) from BMS, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms4(pub [u8; 8]);

impl Default for Bms4 {
    fn default() -> Self { Self::new() }
}

impl Bms4 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF]) }

    /// Returns `max_charge_current` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn max_charge_current_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 A, -10000 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn max_charge_current(self) -> Option<i32> {
        let raw = self.max_charge_current_raw();
        if raw <= 20000 { Some(raw as i32 - 10000) } else { None }
    }
    /// Returns the frame with `max_charge_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_charge_current_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_discharge_current` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn max_discharge_current_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 A, -10000 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn max_discharge_current(self) -> Option<i32> {
        let raw = self.max_discharge_current_raw();
        if raw <= 20000 { Some(raw as i32 - 10000) } else { None }
    }
    /// Returns the frame with `max_discharge_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_discharge_current_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_temperature` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn max_temperature_raw(self) -> u8 { self.0[4] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature(self) -> Option<i32> {
        let raw = self.max_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `max_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `min_temperature` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn min_temperature_raw(self) -> u8 { self.0[5] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature(self) -> Option<i32> {
        let raw = self.min_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `min_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `min_soc` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn min_soc_raw(self) -> u8 { self.0[6] }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn min_soc(self) -> Option<i32> {
        let raw = self.min_soc_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `min_soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_soc_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }
}

/// BMS5 (18F141F3) from BMS, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms5(pub [u8; 8]);

impl Default for Bms5 {
    fn default() -> Self { Self::new() }
}

impl Bms5 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF]) }

    /// Returns `fault_code` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn fault_code_raw(self) -> u8 { self.0[0] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn fault_code(self) -> Option<i32> {
        let raw = self.fault_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_code_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `charge_interval` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn charge_interval_raw(self) -> u8 { self.0[1] }
    /// Returns the value in d, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn charge_interval(self) -> Option<i32> {
        let raw = self.charge_interval_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `charge_interval` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_interval_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `charge_state` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn charge_state_raw(self) -> u8 { self.0[2] }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn charge_state(self) -> Option<i32> {
        let raw = self.charge_state_raw();
        if raw <= 3 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `charge_state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_state_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `balancing` as sent: 1 bit from bit 24.
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

    /// Returns `plug_state` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn plug_state_raw(self) -> u8 { self.0[4] }
    /// Returns the value, 85 to 170; `None` if not valid.
    #[inline(always)]
    pub const fn plug_state(self) -> Option<i32> {
        let raw = self.plug_state_raw();
        if raw >= 85 && raw <= 170 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `plug_state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_plug_state_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `pantograph_charge_state` as sent: 3 bits from bit 40.
    #[inline(always)]
    pub const fn pantograph_charge_state_raw(self) -> u8 { self.0[5] & 0x07 }
    /// Returns the value, 0 to 4; `None` if not valid.
    #[inline(always)]
    pub const fn pantograph_charge_state(self) -> Option<i32> {
        let raw = self.pantograph_charge_state_raw();
        if raw <= 4 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `pantograph_charge_state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pantograph_charge_state_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xF8 | raw & 0x07;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }
}

/// BMS6 (18F142F3) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms6(pub [u8; 8]);

impl Default for Bms6 {
    fn default() -> Self { Self::new() }
}

impl Bms6 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `min_temperature_1` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn min_temperature_1_raw(self) -> u8 { self.0[0] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_1(self) -> Option<i32> {
        let raw = self.min_temperature_1_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `min_temperature_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `min_temperature_1_box` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn min_temperature_1_box_raw(self) -> u8 { self.0[1] }
    /// Returns the value, 1 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_1_box(self) -> Option<i32> {
        let raw = self.min_temperature_1_box_raw();
        if raw >= 1 && raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_temperature_1_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_1_box_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `min_temperature_2` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn min_temperature_2_raw(self) -> u8 { self.0[2] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_2(self) -> Option<i32> {
        let raw = self.min_temperature_2_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `min_temperature_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_2_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `min_temperature_2_box` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn min_temperature_2_box_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 1 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_2_box(self) -> Option<i32> {
        let raw = self.min_temperature_2_box_raw();
        if raw >= 1 && raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_temperature_2_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_2_box_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `min_temperature_3` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn min_temperature_3_raw(self) -> u8 { self.0[4] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_3(self) -> Option<i32> {
        let raw = self.min_temperature_3_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `min_temperature_3` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_3_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `min_temperature_3_box` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn min_temperature_3_box_raw(self) -> u8 { self.0[5] }
    /// Returns the value, 1 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_3_box(self) -> Option<i32> {
        let raw = self.min_temperature_3_box_raw();
        if raw >= 1 && raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_temperature_3_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_3_box_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `min_temperature_4` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn min_temperature_4_raw(self) -> u8 { self.0[6] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_4(self) -> Option<i32> {
        let raw = self.min_temperature_4_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `min_temperature_4` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_4_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `min_temperature_4_box` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn min_temperature_4_box_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 1 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_4_box(self) -> Option<i32> {
        let raw = self.min_temperature_4_box_raw();
        if raw >= 1 && raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_temperature_4_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_4_box_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// BMS7 (18F143F3) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms7(pub [u8; 8]);

impl Default for Bms7 {
    fn default() -> Self { Self::new() }
}

impl Bms7 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `max_temperature_1` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn max_temperature_1_raw(self) -> u8 { self.0[0] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_1(self) -> Option<i32> {
        let raw = self.max_temperature_1_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `max_temperature_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `max_temperature_1_box` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn max_temperature_1_box_raw(self) -> u8 { self.0[1] }
    /// Returns the value, 1 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_1_box(self) -> Option<i32> {
        let raw = self.max_temperature_1_box_raw();
        if raw >= 1 && raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_temperature_1_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_1_box_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `max_temperature_2` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn max_temperature_2_raw(self) -> u8 { self.0[2] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_2(self) -> Option<i32> {
        let raw = self.max_temperature_2_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `max_temperature_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_2_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `max_temperature_2_box` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn max_temperature_2_box_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 1 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_2_box(self) -> Option<i32> {
        let raw = self.max_temperature_2_box_raw();
        if raw >= 1 && raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_temperature_2_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_2_box_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `max_temperature_3` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn max_temperature_3_raw(self) -> u8 { self.0[4] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_3(self) -> Option<i32> {
        let raw = self.max_temperature_3_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `max_temperature_3` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_3_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `max_temperature_3_box` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn max_temperature_3_box_raw(self) -> u8 { self.0[5] }
    /// Returns the value, 1 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_3_box(self) -> Option<i32> {
        let raw = self.max_temperature_3_box_raw();
        if raw >= 1 && raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_temperature_3_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_3_box_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `max_temperature_4` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn max_temperature_4_raw(self) -> u8 { self.0[6] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_4(self) -> Option<i32> {
        let raw = self.max_temperature_4_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `max_temperature_4` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_4_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `max_temperature_4_box` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn max_temperature_4_box_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 1 to 100; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_4_box(self) -> Option<i32> {
        let raw = self.max_temperature_4_box_raw();
        if raw >= 1 && raw <= 100 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_temperature_4_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_4_box_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// BMS8 (18F144F3) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms8(pub [u8; 8]);

impl Default for Bms8 {
    fn default() -> Self { Self::new() }
}

impl Bms8 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `min_voltage_1` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn min_voltage_1_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_1(self) -> Option<i32> {
        let raw = self.min_voltage_1_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_1_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `min_voltage_1_cell` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn min_voltage_1_cell_raw(self) -> u8 { self.0[2] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_1_cell(self) -> Option<i32> {
        let raw = self.min_voltage_1_cell_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_1_cell` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_1_cell_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `min_voltage_1_box` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn min_voltage_1_box_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_1_box(self) -> Option<i32> {
        let raw = self.min_voltage_1_box_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_1_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_1_box_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `min_voltage_2` as sent: 16 bits from bit 32.
    #[inline(always)]
    pub const fn min_voltage_2_raw(self) -> u16 { u16::from_le_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_2(self) -> Option<i32> {
        let raw = self.min_voltage_2_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_2_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `min_voltage_2_cell` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn min_voltage_2_cell_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_2_cell(self) -> Option<i32> {
        let raw = self.min_voltage_2_cell_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_2_cell` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_2_cell_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `min_voltage_2_box` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn min_voltage_2_box_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_2_box(self) -> Option<i32> {
        let raw = self.min_voltage_2_box_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_2_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_2_box_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// BMS9 (18F145F3) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms9(pub [u8; 8]);

impl Default for Bms9 {
    fn default() -> Self { Self::new() }
}

impl Bms9 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `min_voltage_3` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn min_voltage_3_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_3(self) -> Option<i32> {
        let raw = self.min_voltage_3_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_3` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_3_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `min_voltage_3_cell` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn min_voltage_3_cell_raw(self) -> u8 { self.0[2] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_3_cell(self) -> Option<i32> {
        let raw = self.min_voltage_3_cell_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_3_cell` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_3_cell_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `min_voltage_3_box` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn min_voltage_3_box_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_3_box(self) -> Option<i32> {
        let raw = self.min_voltage_3_box_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_3_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_3_box_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `min_voltage_4` as sent: 16 bits from bit 32.
    #[inline(always)]
    pub const fn min_voltage_4_raw(self) -> u16 { u16::from_le_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_4(self) -> Option<i32> {
        let raw = self.min_voltage_4_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_4` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_4_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `min_voltage_4_cell` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn min_voltage_4_cell_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_4_cell(self) -> Option<i32> {
        let raw = self.min_voltage_4_cell_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_4_cell` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_4_cell_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `min_voltage_4_box` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn min_voltage_4_box_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_4_box(self) -> Option<i32> {
        let raw = self.min_voltage_4_box_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_voltage_4_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_4_box_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// BMS10 (18F146F3) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms10(pub [u8; 8]);

impl Default for Bms10 {
    fn default() -> Self { Self::new() }
}

impl Bms10 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `max_voltage_1` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn max_voltage_1_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_1(self) -> Option<i32> {
        let raw = self.max_voltage_1_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_1_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_voltage_1_cell` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn max_voltage_1_cell_raw(self) -> u8 { self.0[2] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_1_cell(self) -> Option<i32> {
        let raw = self.max_voltage_1_cell_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_1_cell` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_1_cell_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `max_voltage_1_box` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn max_voltage_1_box_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_1_box(self) -> Option<i32> {
        let raw = self.max_voltage_1_box_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_1_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_1_box_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `max_voltage_2` as sent: 16 bits from bit 32.
    #[inline(always)]
    pub const fn max_voltage_2_raw(self) -> u16 { u16::from_le_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_2(self) -> Option<i32> {
        let raw = self.max_voltage_2_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_2_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_voltage_2_cell` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn max_voltage_2_cell_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_2_cell(self) -> Option<i32> {
        let raw = self.max_voltage_2_cell_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_2_cell` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_2_cell_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `max_voltage_2_box` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn max_voltage_2_box_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_2_box(self) -> Option<i32> {
        let raw = self.max_voltage_2_box_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_2_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_2_box_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// BMS11 (18F147F3) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms11(pub [u8; 8]);

impl Default for Bms11 {
    fn default() -> Self { Self::new() }
}

impl Bms11 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `max_voltage_3` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn max_voltage_3_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_3(self) -> Option<i32> {
        let raw = self.max_voltage_3_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_3` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_3_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_voltage_3_cell` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn max_voltage_3_cell_raw(self) -> u8 { self.0[2] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_3_cell(self) -> Option<i32> {
        let raw = self.max_voltage_3_cell_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_3_cell` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_3_cell_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `max_voltage_3_box` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn max_voltage_3_box_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_3_box(self) -> Option<i32> {
        let raw = self.max_voltage_3_box_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_3_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_3_box_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `max_voltage_4` as sent: 16 bits from bit 32.
    #[inline(always)]
    pub const fn max_voltage_4_raw(self) -> u16 { u16::from_le_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/100 V, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_4(self) -> Option<i32> {
        let raw = self.max_voltage_4_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_4` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_4_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[5] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_voltage_4_cell` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn max_voltage_4_cell_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_4_cell(self) -> Option<i32> {
        let raw = self.max_voltage_4_cell_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_4_cell` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_4_cell_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `max_voltage_4_box` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn max_voltage_4_box_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 1 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_4_box(self) -> Option<i32> {
        let raw = self.max_voltage_4_box_raw();
        if raw >= 1 && raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage_4_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_4_box_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// BMS12 (18F148F3) from BMS, every 3000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bms12(pub [u8; 8]);

impl Default for Bms12 {
    fn default() -> Self { Self::new() }
}

impl Bms12 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF]) }

    /// Returns `rated_capacity` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn rated_capacity_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in Ah, 0 to 1000; `None` if not valid.
    #[inline(always)]
    pub const fn rated_capacity(self) -> Option<i32> {
        let raw = self.rated_capacity_raw();
        if raw <= 1000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `rated_capacity` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_rated_capacity_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `rated_voltage` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn rated_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in V, 0 to 1000; `None` if not valid.
    #[inline(always)]
    pub const fn rated_voltage(self) -> Option<i32> {
        let raw = self.rated_voltage_raw();
        if raw <= 1000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `rated_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_rated_voltage_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `production_year` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn production_year_raw(self) -> u8 { self.0[4] }
    /// Returns the value, 1985 to 2235; `None` if not valid.
    #[inline(always)]
    pub const fn production_year(self) -> Option<i32> {
        let raw = self.production_year_raw();
        if raw <= 250 { Some(raw as i32 + 1985) } else { None }
    }
    /// Returns the frame with `production_year` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_production_year_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `production_month` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn production_month_raw(self) -> u8 { self.0[5] }
    /// Returns the value, 0 to 12; `None` if not valid.
    #[inline(always)]
    pub const fn production_month(self) -> Option<i32> {
        let raw = self.production_month_raw();
        if raw <= 12 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `production_month` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_production_month_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `production_day` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn production_day_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 31; `None` if not valid.
    #[inline(always)]
    pub const fn production_day(self) -> Option<i32> {
        let raw = self.production_day_raw();
        if raw <= 31 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `production_day` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_production_day_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }
}

/// SteeringPump (142FFF95) from SteeringPump, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SteeringPump(pub [u8; 8]);

impl Default for SteeringPump {
    fn default() -> Self { Self::new() }
}

impl SteeringPump {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `motor_speed` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn motor_speed_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/8 rpm, 0 to 40000; `None` if not valid.
    #[inline(always)]
    pub const fn motor_speed(self) -> Option<i32> {
        let raw = self.motor_speed_raw();
        if raw <= 40000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `motor_speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_speed_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `bus_voltage` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn bus_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn bus_voltage(self) -> Option<i32> {
        let raw = self.bus_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `bus_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_voltage_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `current` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn current_raw(self) -> u8 { self.0[4] }
    /// Returns the value in A, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn current(self) -> Option<i32> {
        let raw = self.current_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_current_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `controller_temperature` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn controller_temperature_raw(self) -> u8 { self.0[5] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn controller_temperature(self) -> Option<i32> {
        let raw = self.controller_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `controller_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_controller_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `fault_code` as sent: 4 bits from bit 56.
    #[inline(always)]
    pub const fn fault_code_raw(self) -> u8 { self.0[7] & 0x0F }
    /// Returns the value, 0 to 15; `None` if not valid.
    #[inline(always)]
    pub const fn fault_code(self) -> Option<i32> {
        let raw = self.fault_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_code_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF0 | raw & 0x0F;
        self
    }

    /// Returns `status` as sent: 2 bits from bit 60.
    #[inline(always)]
    pub const fn status_raw(self) -> u8 { self.0[7] >> 4 & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn status(self) -> Option<i32> {
        let raw = self.status_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `status` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_status_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `external_control` as sent: 1 bit from bit 62.
    #[inline(always)]
    pub const fn external_control_raw(self) -> u8 { self.0[7] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn external_control(self) -> Option<i32> {
        let raw = self.external_control_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `external_control` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_external_control_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `precharged` as sent: 1 bit from bit 63.
    #[inline(always)]
    pub const fn precharged_raw(self) -> u8 { self.0[7] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn precharged(self) -> Option<i32> {
        let raw = self.precharged_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `precharged` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_precharged_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// LowVoltageSteering (0CF603A1) from LowVoltageSteering, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LowVoltageSteering(pub [u8; 8]);

impl Default for LowVoltageSteering {
    fn default() -> Self { Self::new() }
}

impl LowVoltageSteering {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `status` as sent: 2 bits from bit 0.
    #[inline(always)]
    pub const fn status_raw(self) -> u8 { self.0[0] & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn status(self) -> Option<i32> {
        let raw = self.status_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `status` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_status_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `output_voltage` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn output_voltage_raw(self) -> u8 { self.0[1] }
    /// Returns the value in V, 0 to 35; `None` if not valid.
    #[inline(always)]
    pub const fn output_voltage(self) -> Option<i32> {
        let raw = self.output_voltage_raw();
        if raw <= 35 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_voltage_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `output_current` as sent: 16 bits from bit 24.
    #[inline(always)]
    pub const fn output_current_raw(self) -> u16 { u16::from_le_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in 1/10 A, 0 to 2000; `None` if not valid.
    #[inline(always)]
    pub const fn output_current(self) -> Option<i32> {
        let raw = self.output_current_raw();
        if raw <= 2000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_current_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[5] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `radiator_temperature` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn radiator_temperature_raw(self) -> u8 { self.0[6] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn radiator_temperature(self) -> Option<i32> {
        let raw = self.radiator_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `radiator_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_radiator_temperature_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `fault_code` as sent: 6 bits from bit 56.
    #[inline(always)]
    pub const fn fault_code_raw(self) -> u8 { self.0[7] & 0x3F }
    /// Returns the value, 0 to 63; `None` if not valid.
    #[inline(always)]
    pub const fn fault_code(self) -> Option<i32> {
        let raw = self.fault_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_code_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xC0 | raw & 0x3F;
        self
    }

    /// Returns `alarm_level` as sent: 2 bits from bit 62.
    #[inline(always)]
    pub const fn alarm_level_raw(self) -> u8 { self.0[7] >> 6 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn alarm_level(self) -> Option<i32> {
        let raw = self.alarm_level_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `alarm_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_alarm_level_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x3F | (raw & 0x03) << 6;
        self
    }
}

/// DCDC (142CFF98) from DCDC, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dcdc(pub [u8; 8]);

impl Default for Dcdc {
    fn default() -> Self { Self::new() }
}

impl Dcdc {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `input_voltage` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn input_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn input_voltage(self) -> Option<i32> {
        let raw = self.input_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `input_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_input_voltage_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `input_current` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn input_current_raw(self) -> u8 { self.0[2] }
    /// Returns the value in A, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn input_current(self) -> Option<i32> {
        let raw = self.input_current_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `input_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_input_current_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `output_current` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn output_current_raw(self) -> u8 { self.0[3] }
    /// Returns the value in A, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn output_current(self) -> Option<i32> {
        let raw = self.output_current_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_current_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `controller_temperature` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn controller_temperature_raw(self) -> u8 { self.0[4] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn controller_temperature(self) -> Option<i32> {
        let raw = self.controller_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `controller_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_controller_temperature_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `output_voltage` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn output_voltage_raw(self) -> u8 { self.0[5] }
    /// Returns the value in V, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn output_voltage(self) -> Option<i32> {
        let raw = self.output_voltage_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_voltage_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `fault_code` as sent: 4 bits from bit 56.
    #[inline(always)]
    pub const fn fault_code_raw(self) -> u8 { self.0[7] & 0x0F }
    /// Returns the value, 0 to 15; `None` if not valid.
    #[inline(always)]
    pub const fn fault_code(self) -> Option<i32> {
        let raw = self.fault_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_code_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF0 | raw & 0x0F;
        self
    }

    /// Returns `status` as sent: 2 bits from bit 60.
    #[inline(always)]
    pub const fn status_raw(self) -> u8 { self.0[7] >> 4 & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn status(self) -> Option<i32> {
        let raw = self.status_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `status` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_status_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `precharged` as sent: 1 bit from bit 63.
    #[inline(always)]
    pub const fn precharged_raw(self) -> u8 { self.0[7] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn precharged(self) -> Option<i32> {
        let raw = self.precharged_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `precharged` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_precharged_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// AirPump (1429FF9B) from AirCompressor, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AirPump(pub [u8; 8]);

impl Default for AirPump {
    fn default() -> Self { Self::new() }
}

impl AirPump {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `motor_speed` as sent: 16 bits from bit 0.
    #[inline(always)]
    pub const fn motor_speed_raw(self) -> u16 { u16::from_le_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/8 rpm, 0 to 40000; `None` if not valid.
    #[inline(always)]
    pub const fn motor_speed(self) -> Option<i32> {
        let raw = self.motor_speed_raw();
        if raw <= 40000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `motor_speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_speed_raw(mut self, raw: u16) -> Self {
        self.0[0] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `bus_voltage` as sent: 16 bits from bit 16.
    #[inline(always)]
    pub const fn bus_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn bus_voltage(self) -> Option<i32> {
        let raw = self.bus_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `bus_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_voltage_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `current` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn current_raw(self) -> u8 { self.0[4] }
    /// Returns the value in A, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn current(self) -> Option<i32> {
        let raw = self.current_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_current_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `controller_temperature` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn controller_temperature_raw(self) -> u8 { self.0[5] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn controller_temperature(self) -> Option<i32> {
        let raw = self.controller_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `controller_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_controller_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `fault_code` as sent: 4 bits from bit 56.
    #[inline(always)]
    pub const fn fault_code_raw(self) -> u8 { self.0[7] & 0x0F }
    /// Returns the value, 0 to 15; `None` if not valid.
    #[inline(always)]
    pub const fn fault_code(self) -> Option<i32> {
        let raw = self.fault_code_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_code` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_code_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF0 | raw & 0x0F;
        self
    }

    /// Returns `status` as sent: 2 bits from bit 60.
    #[inline(always)]
    pub const fn status_raw(self) -> u8 { self.0[7] >> 4 & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn status(self) -> Option<i32> {
        let raw = self.status_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `status` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_status_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `precharged` as sent: 1 bit from bit 63.
    #[inline(always)]
    pub const fn precharged_raw(self) -> u8 { self.0[7] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn precharged(self) -> Option<i32> {
        let raw = self.precharged_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `precharged` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_precharged_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// Meter1 (18F43A17) from Cluster, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meter1(pub [u8; 8]);

impl Default for Meter1 {
    fn default() -> Self { Self::new() }
}

impl Meter1 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `aux_battery_voltage` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn aux_battery_voltage_raw(self) -> u8 { self.0[0] }
    /// Returns the value in 1/5 V, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn aux_battery_voltage(self) -> Option<i32> {
        let raw = self.aux_battery_voltage_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `aux_battery_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_aux_battery_voltage_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `exit_door` as sent: 1 bit from bit 8.
    #[inline(always)]
    pub const fn exit_door_raw(self) -> u8 { self.0[1] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn exit_door(self) -> Option<i32> {
        let raw = self.exit_door_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `exit_door` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_exit_door_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `middle_door` as sent: 1 bit from bit 9.
    #[inline(always)]
    pub const fn middle_door_raw(self) -> u8 { self.0[1] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn middle_door(self) -> Option<i32> {
        let raw = self.middle_door_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `middle_door` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_middle_door_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `entry_door` as sent: 1 bit from bit 10.
    #[inline(always)]
    pub const fn entry_door_raw(self) -> u8 { self.0[1] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn entry_door(self) -> Option<i32> {
        let raw = self.entry_door_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `entry_door` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_entry_door_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `rear_hatch` as sent: 1 bit from bit 11.
    #[inline(always)]
    pub const fn rear_hatch_raw(self) -> u8 { self.0[1] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn rear_hatch(self) -> Option<i32> {
        let raw = self.rear_hatch_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `rear_hatch` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_rear_hatch_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `handbrake` as sent: 1 bit from bit 12.
    #[inline(always)]
    pub const fn handbrake_raw(self) -> u8 { self.0[1] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn handbrake(self) -> Option<i32> {
        let raw = self.handbrake_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `handbrake` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_handbrake_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `smoke_alarm` as sent: 1 bit from bit 13.
    #[inline(always)]
    pub const fn smoke_alarm_raw(self) -> u8 { self.0[1] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_alarm(self) -> Option<i32> {
        let raw = self.smoke_alarm_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_alarm` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_alarm_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `key_position` as sent: 2 bits from bit 14.
    #[inline(always)]
    pub const fn key_position_raw(self) -> u8 { self.0[1] >> 6 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn key_position(self) -> Option<i32> {
        let raw = self.key_position_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `key_position` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_key_position_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0x3F | (raw & 0x03) << 6;
        self
    }

    /// Returns `front_air_pressure` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn front_air_pressure_raw(self) -> u8 { self.0[2] }
    /// Returns the value in 1/100 MPa, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn front_air_pressure(self) -> Option<i32> {
        let raw = self.front_air_pressure_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `front_air_pressure` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_front_air_pressure_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `rear_air_pressure` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn rear_air_pressure_raw(self) -> u8 { self.0[3] }
    /// Returns the value in 1/100 MPa, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn rear_air_pressure(self) -> Option<i32> {
        let raw = self.rear_air_pressure_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `rear_air_pressure` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_rear_air_pressure_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `low_beam` as sent: 1 bit from bit 32.
    #[inline(always)]
    pub const fn low_beam_raw(self) -> u8 { self.0[4] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn low_beam(self) -> Option<i32> {
        let raw = self.low_beam_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `low_beam` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_low_beam_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `high_beam` as sent: 1 bit from bit 33.
    #[inline(always)]
    pub const fn high_beam_raw(self) -> u8 { self.0[4] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn high_beam(self) -> Option<i32> {
        let raw = self.high_beam_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `high_beam` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_high_beam_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `brake_lamp` as sent: 1 bit from bit 34.
    #[inline(always)]
    pub const fn brake_lamp_raw(self) -> u8 { self.0[4] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn brake_lamp(self) -> Option<i32> {
        let raw = self.brake_lamp_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `brake_lamp` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_brake_lamp_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `right_turn` as sent: 1 bit from bit 35.
    #[inline(always)]
    pub const fn right_turn_raw(self) -> u8 { self.0[4] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn right_turn(self) -> Option<i32> {
        let raw = self.right_turn_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `right_turn` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_right_turn_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `left_turn` as sent: 1 bit from bit 36.
    #[inline(always)]
    pub const fn left_turn_raw(self) -> u8 { self.0[4] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn left_turn(self) -> Option<i32> {
        let raw = self.left_turn_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `left_turn` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_left_turn_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `hazard` as sent: 1 bit from bit 37.
    #[inline(always)]
    pub const fn hazard_raw(self) -> u8 { self.0[4] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn hazard(self) -> Option<i32> {
        let raw = self.hazard_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hazard` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hazard_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `front_fog` as sent: 1 bit from bit 38.
    #[inline(always)]
    pub const fn front_fog_raw(self) -> u8 { self.0[4] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn front_fog(self) -> Option<i32> {
        let raw = self.front_fog_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `front_fog` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_front_fog_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `rear_fog` as sent: 1 bit from bit 39.
    #[inline(always)]
    pub const fn rear_fog_raw(self) -> u8 { self.0[4] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn rear_fog(self) -> Option<i32> {
        let raw = self.rear_fog_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `rear_fog` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_rear_fog_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `side_lamp` as sent: 1 bit from bit 40.
    #[inline(always)]
    pub const fn side_lamp_raw(self) -> u8 { self.0[5] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn side_lamp(self) -> Option<i32> {
        let raw = self.side_lamp_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `side_lamp` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_side_lamp_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `horn` as sent: 1 bit from bit 41.
    #[inline(always)]
    pub const fn horn_raw(self) -> u8 { self.0[5] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn horn(self) -> Option<i32> {
        let raw = self.horn_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `horn` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_horn_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `driver_left_seat` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn driver_left_seat_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn driver_left_seat(self) -> Option<i32> {
        let raw = self.driver_left_seat_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `driver_left_seat` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_driver_left_seat_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// Meter2 (18F54A17) from Cluster, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meter2(pub [u8; 8]);

impl Default for Meter2 {
    fn default() -> Self { Self::new() }
}

impl Meter2 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF]) }

    /// Returns `odometer` as sent: 32 bits from bit 0.
    #[inline(always)]
    pub const fn odometer_raw(self) -> u32 { u32::from_le_bytes([self.0[0], self.0[1], self.0[2], self.0[3]]) }
    /// Returns the value in 1/8 km, 0 to 4294967294; `None` if not valid.
    #[inline(always)]
    pub const fn odometer(self) -> Option<i64> {
        let raw = self.odometer_raw();
        if raw <= 4294967294 { Some(raw as i64) } else { None }
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

/// HVAC (18FFC09E) from HVAC, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hvac(pub [u8; 8]);

impl Default for Hvac {
    fn default() -> Self { Self::new() }
}

impl Hvac {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0x00]) }

    /// Returns `return_sensor_open` as sent: 1 bit from bit 0.
    #[inline(always)]
    pub const fn return_sensor_open_raw(self) -> u8 { self.0[0] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn return_sensor_open(self) -> Option<i32> {
        let raw = self.return_sensor_open_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `return_sensor_open` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_return_sensor_open_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `outside_sensor_open` as sent: 1 bit from bit 1.
    #[inline(always)]
    pub const fn outside_sensor_open_raw(self) -> u8 { self.0[0] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn outside_sensor_open(self) -> Option<i32> {
        let raw = self.outside_sensor_open_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `outside_sensor_open` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_outside_sensor_open_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `evaporator_1_sensor_open` as sent: 1 bit from bit 2.
    #[inline(always)]
    pub const fn evaporator_1_sensor_open_raw(self) -> u8 { self.0[0] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn evaporator_1_sensor_open(self) -> Option<i32> {
        let raw = self.evaporator_1_sensor_open_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `evaporator_1_sensor_open` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_evaporator_1_sensor_open_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `evaporator_2_sensor_open` as sent: 1 bit from bit 3.
    #[inline(always)]
    pub const fn evaporator_2_sensor_open_raw(self) -> u8 { self.0[0] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn evaporator_2_sensor_open(self) -> Option<i32> {
        let raw = self.evaporator_2_sensor_open_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `evaporator_2_sensor_open` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_evaporator_2_sensor_open_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `supply_overvoltage` as sent: 1 bit from bit 4.
    #[inline(always)]
    pub const fn supply_overvoltage_raw(self) -> u8 { self.0[0] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn supply_overvoltage(self) -> Option<i32> {
        let raw = self.supply_overvoltage_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `supply_overvoltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_supply_overvoltage_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `supply_undervoltage` as sent: 1 bit from bit 5.
    #[inline(always)]
    pub const fn supply_undervoltage_raw(self) -> u8 { self.0[0] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn supply_undervoltage(self) -> Option<i32> {
        let raw = self.supply_undervoltage_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `supply_undervoltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_supply_undervoltage_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `inverter_fault` as sent: 1 bit from bit 6.
    #[inline(always)]
    pub const fn inverter_fault_raw(self) -> u8 { self.0[0] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn inverter_fault(self) -> Option<i32> {
        let raw = self.inverter_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `inverter_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_inverter_fault_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `pressure_fault` as sent: 1 bit from bit 7.
    #[inline(always)]
    pub const fn pressure_fault_raw(self) -> u8 { self.0[0] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn pressure_fault(self) -> Option<i32> {
        let raw = self.pressure_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `pressure_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pressure_fault_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `fan_low` as sent: 1 bit from bit 13.
    #[inline(always)]
    pub const fn fan_low_raw(self) -> u8 { self.0[1] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn fan_low(self) -> Option<i32> {
        let raw = self.fan_low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fan_low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fan_low_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `fan_mid` as sent: 1 bit from bit 14.
    #[inline(always)]
    pub const fn fan_mid_raw(self) -> u8 { self.0[1] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn fan_mid(self) -> Option<i32> {
        let raw = self.fan_mid_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fan_mid` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fan_mid_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `fan_high` as sent: 1 bit from bit 15.
    #[inline(always)]
    pub const fn fan_high_raw(self) -> u8 { self.0[1] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn fan_high(self) -> Option<i32> {
        let raw = self.fan_high_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fan_high` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fan_high_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `heating` as sent: 1 bit from bit 16.
    #[inline(always)]
    pub const fn heating_raw(self) -> u8 { self.0[2] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn heating(self) -> Option<i32> {
        let raw = self.heating_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `heating` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_heating_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `defrost_1` as sent: 1 bit from bit 17.
    #[inline(always)]
    pub const fn defrost_1_raw(self) -> u8 { self.0[2] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn defrost_1(self) -> Option<i32> {
        let raw = self.defrost_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `defrost_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_defrost_1_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `fresh_air` as sent: 1 bit from bit 18.
    #[inline(always)]
    pub const fn fresh_air_raw(self) -> u8 { self.0[2] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn fresh_air(self) -> Option<i32> {
        let raw = self.fresh_air_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fresh_air` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fresh_air_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `sterilise` as sent: 1 bit from bit 19.
    #[inline(always)]
    pub const fn sterilise_raw(self) -> u8 { self.0[2] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn sterilise(self) -> Option<i32> {
        let raw = self.sterilise_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `sterilise` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_sterilise_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `defrost_2` as sent: 1 bit from bit 20.
    #[inline(always)]
    pub const fn defrost_2_raw(self) -> u8 { self.0[2] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn defrost_2(self) -> Option<i32> {
        let raw = self.defrost_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `defrost_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_defrost_2_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `cooling_2` as sent: 1 bit from bit 21.
    #[inline(always)]
    pub const fn cooling_2_raw(self) -> u8 { self.0[2] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn cooling_2(self) -> Option<i32> {
        let raw = self.cooling_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `cooling_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cooling_2_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `cooling_1` as sent: 1 bit from bit 23.
    #[inline(always)]
    pub const fn cooling_1_raw(self) -> u8 { self.0[2] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn cooling_1(self) -> Option<i32> {
        let raw = self.cooling_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `cooling_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cooling_1_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `cabin_temperature` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn cabin_temperature_raw(self) -> u8 { self.0[3] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn cabin_temperature(self) -> Option<i32> {
        let raw = self.cabin_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `cabin_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_cabin_temperature_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `outside_temperature` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn outside_temperature_raw(self) -> u8 { self.0[4] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn outside_temperature(self) -> Option<i32> {
        let raw = self.outside_temperature_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `outside_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_outside_temperature_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `communication_alarm` as sent: 1 bit from bit 47.
    #[inline(always)]
    pub const fn communication_alarm_raw(self) -> u8 { self.0[5] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn communication_alarm(self) -> Option<i32> {
        let raw = self.communication_alarm_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `communication_alarm` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_communication_alarm_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// Insulation (18F746E5) from InsulationMonitor, every 1000 to 3000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Insulation(pub [u8; 8]);

impl Default for Insulation {
    fn default() -> Self { Self::new() }
}

impl Insulation {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `leakage_level` as sent: 3 bits from bit 0.
    #[inline(always)]
    pub const fn leakage_level_raw(self) -> u8 { self.0[0] & 0x07 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn leakage_level(self) -> Option<i32> {
        let raw = self.leakage_level_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `leakage_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_leakage_level_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xF8 | raw & 0x07;
        self
    }

    /// Returns `positive_resistance` as sent: 16 bits from bit 8.
    #[inline(always)]
    pub const fn positive_resistance_raw(self) -> u16 { u16::from_le_bytes([self.0[1], self.0[2]]) }
    /// Returns the value in kohm, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn positive_resistance(self) -> Option<i32> {
        let raw = self.positive_resistance_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `positive_resistance` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_resistance_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `negative_resistance` as sent: 16 bits from bit 24.
    #[inline(always)]
    pub const fn negative_resistance_raw(self) -> u16 { u16::from_le_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in kohm, 0 to 65534; `None` if not valid.
    #[inline(always)]
    pub const fn negative_resistance(self) -> Option<i32> {
        let raw = self.negative_resistance_raw();
        if raw <= 65534 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `negative_resistance` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_resistance_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
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

    /// Returns `level_1_alarm` as sent: 1 bit from bit 48.
    #[inline(always)]
    pub const fn level_1_alarm_raw(self) -> u8 { self.0[6] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn level_1_alarm(self) -> Option<i32> {
        let raw = self.level_1_alarm_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `level_1_alarm` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_level_1_alarm_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `level_2_alarm` as sent: 1 bit from bit 49.
    #[inline(always)]
    pub const fn level_2_alarm_raw(self) -> u8 { self.0[6] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn level_2_alarm(self) -> Option<i32> {
        let raw = self.level_2_alarm_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `level_2_alarm` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_level_2_alarm_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `positive_fault` as sent: 1 bit from bit 50.
    #[inline(always)]
    pub const fn positive_fault_raw(self) -> u8 { self.0[6] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn positive_fault(self) -> Option<i32> {
        let raw = self.positive_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `positive_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `negative_fault` as sent: 1 bit from bit 51.
    #[inline(always)]
    pub const fn negative_fault_raw(self) -> u8 { self.0[6] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn negative_fault(self) -> Option<i32> {
        let raw = self.negative_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `negative_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `wiring_fault` as sent: 1 bit from bit 52.
    #[inline(always)]
    pub const fn wiring_fault_raw(self) -> u8 { self.0[6] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn wiring_fault(self) -> Option<i32> {
        let raw = self.wiring_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `wiring_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_wiring_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `device_fault` as sent: 1 bit from bit 53.
    #[inline(always)]
    pub const fn device_fault_raw(self) -> u8 { self.0[6] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn device_fault(self) -> Option<i32> {
        let raw = self.device_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `device_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_device_fault_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `life` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// ChargerTx (18F1F399) from OBC, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChargerTx(pub [u8; 8]);

impl Default for ChargerTx {
    fn default() -> Self { Self::new() }
}

impl ChargerTx {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF]) }

    /// Returns `life` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[0] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `output_voltage` as sent: 16 bits from bit 8.
    #[inline(always)]
    pub const fn output_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[1], self.0[2]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn output_voltage(self) -> Option<i32> {
        let raw = self.output_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_voltage_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `output_current` as sent: 16 bits from bit 24.
    #[inline(always)]
    pub const fn output_current_raw(self) -> u16 { u16::from_le_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in 1/10 A, -5000 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn output_current(self) -> Option<i32> {
        let raw = self.output_current_raw();
        if raw <= 10000 { Some(raw as i32 - 5000) } else { None }
    }
    /// Returns the frame with `output_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_current_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
        self
    }

    /// Returns `hardware_fault` as sent: 1 bit from bit 40.
    #[inline(always)]
    pub const fn hardware_fault_raw(self) -> u8 { self.0[5] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn hardware_fault(self) -> Option<i32> {
        let raw = self.hardware_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hardware_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hardware_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `over_temperature` as sent: 1 bit from bit 41.
    #[inline(always)]
    pub const fn over_temperature_raw(self) -> u8 { self.0[5] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn over_temperature(self) -> Option<i32> {
        let raw = self.over_temperature_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `over_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_over_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `input_voltage_fault` as sent: 1 bit from bit 42.
    #[inline(always)]
    pub const fn input_voltage_fault_raw(self) -> u8 { self.0[5] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn input_voltage_fault(self) -> Option<i32> {
        let raw = self.input_voltage_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `input_voltage_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_input_voltage_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `start_inhibited` as sent: 1 bit from bit 43.
    #[inline(always)]
    pub const fn start_inhibited_raw(self) -> u8 { self.0[5] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn start_inhibited(self) -> Option<i32> {
        let raw = self.start_inhibited_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `start_inhibited` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_start_inhibited_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `communication_fault` as sent: 1 bit from bit 44.
    #[inline(always)]
    pub const fn communication_fault_raw(self) -> u8 { self.0[5] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn communication_fault(self) -> Option<i32> {
        let raw = self.communication_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `communication_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_communication_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `fault_level` as sent: 2 bits from bit 45.
    #[inline(always)]
    pub const fn fault_level_raw(self) -> u8 { self.0[5] >> 5 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn fault_level(self) -> Option<i32> {
        let raw = self.fault_level_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0x9F | (raw & 0x03) << 5;
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
}

/// ChargerRx (18F199F3) from BMS, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChargerRx(pub [u8; 8]);

impl Default for ChargerRx {
    fn default() -> Self { Self::new() }
}

impl ChargerRx {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF]) }

    /// Returns `life` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[0] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `max_voltage` as sent: 16 bits from bit 8.
    #[inline(always)]
    pub const fn max_voltage_raw(self) -> u16 { u16::from_le_bytes([self.0[1], self.0[2]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage(self) -> Option<i32> {
        let raw = self.max_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `max_current` as sent: 16 bits from bit 24.
    #[inline(always)]
    pub const fn max_current_raw(self) -> u16 { u16::from_le_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in 1/10 A, -5000 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn max_current(self) -> Option<i32> {
        let raw = self.max_current_raw();
        if raw <= 10000 { Some(raw as i32 - 5000) } else { None }
    }
    /// Returns the frame with `max_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_current_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
        self
    }

    /// Returns `enable` as sent: 1 bit from bit 40.
    #[inline(always)]
    pub const fn enable_raw(self) -> u8 { self.0[5] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn enable(self) -> Option<i32> {
        let raw = self.enable_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `enable` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_enable_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFE | raw & 0x01;
        self
    }
}

/// PEU (1801EFA9) from ICS4in1, every 100 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Peu(pub [u8; 8]);

impl Default for Peu {
    fn default() -> Self { Self::new() }
}

impl Peu {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF]) }

    /// Returns `positive_contactor` as sent: 2 bits from bit 0.
    #[inline(always)]
    pub const fn positive_contactor_raw(self) -> u8 { self.0[0] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn positive_contactor(self) -> Option<i32> {
        let raw = self.positive_contactor_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `positive_contactor` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_contactor_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `battery_main_contactor` as sent: 2 bits from bit 2.
    #[inline(always)]
    pub const fn battery_main_contactor_raw(self) -> u8 { self.0[0] >> 2 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn battery_main_contactor(self) -> Option<i32> {
        let raw = self.battery_main_contactor_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `battery_main_contactor` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_battery_main_contactor_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `positive_precharge` as sent: 2 bits from bit 4.
    #[inline(always)]
    pub const fn positive_precharge_raw(self) -> u8 { self.0[0] >> 4 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn positive_precharge(self) -> Option<i32> {
        let raw = self.positive_precharge_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `positive_precharge` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_positive_precharge_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `negative_precharge` as sent: 2 bits from bit 6.
    #[inline(always)]
    pub const fn negative_precharge_raw(self) -> u8 { self.0[0] >> 6 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn negative_precharge(self) -> Option<i32> {
        let raw = self.negative_precharge_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `negative_precharge` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_precharge_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0x3F | (raw & 0x03) << 6;
        self
    }

    /// Returns `defrost` as sent: 2 bits from bit 8.
    #[inline(always)]
    pub const fn defrost_raw(self) -> u8 { self.0[1] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn defrost(self) -> Option<i32> {
        let raw = self.defrost_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `defrost` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_defrost_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `hvac` as sent: 2 bits from bit 10.
    #[inline(always)]
    pub const fn hvac_raw(self) -> u8 { self.0[1] >> 2 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn hvac(self) -> Option<i32> {
        let raw = self.hvac_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hvac` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hvac_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `battery_heater` as sent: 2 bits from bit 12.
    #[inline(always)]
    pub const fn battery_heater_raw(self) -> u8 { self.0[1] >> 4 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn battery_heater(self) -> Option<i32> {
        let raw = self.battery_heater_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `battery_heater` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_battery_heater_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `heater` as sent: 2 bits from bit 14.
    #[inline(always)]
    pub const fn heater_raw(self) -> u8 { self.0[1] >> 6 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn heater(self) -> Option<i32> {
        let raw = self.heater_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `heater` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_heater_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0x3F | (raw & 0x03) << 6;
        self
    }

    /// Returns `accessory` as sent: 2 bits from bit 16.
    #[inline(always)]
    pub const fn accessory_raw(self) -> u8 { self.0[2] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn accessory(self) -> Option<i32> {
        let raw = self.accessory_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `accessory` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_accessory_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `accessory_precharge` as sent: 2 bits from bit 18.
    #[inline(always)]
    pub const fn accessory_precharge_raw(self) -> u8 { self.0[2] >> 2 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn accessory_precharge(self) -> Option<i32> {
        let raw = self.accessory_precharge_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `accessory_precharge` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_accessory_precharge_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `charge_1` as sent: 2 bits from bit 20.
    #[inline(always)]
    pub const fn charge_1_raw(self) -> u8 { self.0[2] >> 4 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn charge_1(self) -> Option<i32> {
        let raw = self.charge_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_1_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `charge_2` as sent: 2 bits from bit 22.
    #[inline(always)]
    pub const fn charge_2_raw(self) -> u8 { self.0[2] >> 6 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn charge_2(self) -> Option<i32> {
        let raw = self.charge_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_2_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0x3F | (raw & 0x03) << 6;
        self
    }
}

fn get_vcu1(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu1(data);
    Some(match index {
        0 => (frame.drive_mode_raw() as i64, frame.drive_mode().map(|value| value as i64)),
        1 => (frame.gear_raw() as i64, frame.gear().map(|value| value as i64)),
        2 => (frame.handbrake_raw() as i64, frame.handbrake().map(|value| value as i64)),
        3 => (frame.foot_brake_raw() as i64, frame.foot_brake().map(|value| value as i64)),
        4 => (frame.accelerator_pedal_raw() as i64, frame.accelerator_pedal().map(|value| value as i64)),
        5 => (frame.vehicle_speed_raw() as i64, frame.vehicle_speed().map(|value| value as i64)),
        6 => (frame.brake_pedal_raw() as i64, frame.brake_pedal().map(|value| value as i64)),
        7 => (frame.torque_limited_raw() as i64, frame.torque_limited().map(|value| value as i64)),
        8 => (frame.power_limited_raw() as i64, frame.power_limited().map(|value| value as i64)),
        9 => (frame.system_fault_raw() as i64, frame.system_fault().map(|value| value as i64)),
        10 => (frame.ready_raw() as i64, frame.ready().map(|value| value as i64)),
        11 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu1(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu1(data);
    match index {
        0 => frame.with_drive_mode_raw(raw as u8).0,
        1 => frame.with_gear_raw(raw as u8).0,
        2 => frame.with_handbrake_raw(raw as u8).0,
        3 => frame.with_foot_brake_raw(raw as u8).0,
        4 => frame.with_accelerator_pedal_raw(raw as u8).0,
        5 => frame.with_vehicle_speed_raw(raw as u16).0,
        6 => frame.with_brake_pedal_raw(raw as u8).0,
        7 => frame.with_torque_limited_raw(raw as u8).0,
        8 => frame.with_power_limited_raw(raw as u8).0,
        9 => frame.with_system_fault_raw(raw as u8).0,
        10 => frame.with_ready_raw(raw as u8).0,
        11 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu2(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu2(data);
    Some(match index {
        0 => (frame.target_torque_raw() as i64, frame.target_torque().map(|value| value as i64)),
        1 => (frame.ipu_enable_raw() as i64, frame.ipu_enable().map(|value| value as i64)),
        2 => (frame.discharge_enable_raw() as i64, frame.discharge_enable().map(|value| value as i64)),
        3 => (frame.control_mode_raw() as i64, frame.control_mode().map(|value| value as i64)),
        4 => (frame.power_limit_raw() as i64, frame.power_limit().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu2(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu2(data);
    match index {
        0 => frame.with_target_torque_raw(raw as u16).0,
        1 => frame.with_ipu_enable_raw(raw as u8).0,
        2 => frame.with_discharge_enable_raw(raw as u8).0,
        3 => frame.with_control_mode_raw(raw as u8).0,
        4 => frame.with_power_limit_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu3(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu3(data);
    Some(match index {
        0 => (frame.vendor_code_raw() as i64, frame.vendor_code().map(|value| value as i64)),
        1 => (frame.hv_command_raw() as i64, frame.hv_command().map(|value| value as i64)),
        2 => (frame.mcu_input_voltage_raw() as i64, frame.mcu_input_voltage().map(|value| value as i64)),
        3 => (frame.pantograph_state_raw() as i64, frame.pantograph_state().map(|value| value as i64)),
        4 => (frame.charge_enable_raw() as i64, frame.charge_enable().map(|value| value as i64)),
        5 => (frame.hv_cutoff_raw() as i64, frame.hv_cutoff().map(|value| value as i64)),
        6 => (frame.precharge_relay_raw() as i64, frame.precharge_relay().map(|value| value as i64)),
        7 => (frame.motor_relay_raw() as i64, frame.motor_relay().map(|value| value as i64)),
        8 => (frame.accessory_relay_raw() as i64, frame.accessory_relay().map(|value| value as i64)),
        9 => (frame.accessory_precharge_relay_raw() as i64, frame.accessory_precharge_relay().map(|value| value as i64)),
        10 => (frame.defrost_relay_raw() as i64, frame.defrost_relay().map(|value| value as i64)),
        11 => (frame.charge_relay_raw() as i64, frame.charge_relay().map(|value| value as i64)),
        12 => (frame.battery_relay_raw() as i64, frame.battery_relay().map(|value| value as i64)),
        13 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu3(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu3(data);
    match index {
        0 => frame.with_vendor_code_raw(raw as u8).0,
        1 => frame.with_hv_command_raw(raw as u8).0,
        2 => frame.with_mcu_input_voltage_raw(raw as u16).0,
        3 => frame.with_pantograph_state_raw(raw as u8).0,
        4 => frame.with_charge_enable_raw(raw as u8).0,
        5 => frame.with_hv_cutoff_raw(raw as u8).0,
        6 => frame.with_precharge_relay_raw(raw as u8).0,
        7 => frame.with_motor_relay_raw(raw as u8).0,
        8 => frame.with_accessory_relay_raw(raw as u8).0,
        9 => frame.with_accessory_precharge_relay_raw(raw as u8).0,
        10 => frame.with_defrost_relay_raw(raw as u8).0,
        11 => frame.with_charge_relay_raw(raw as u8).0,
        12 => frame.with_battery_relay_raw(raw as u8).0,
        13 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu4(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu4(data);
    Some(match index {
        0 => (frame.fault_reset_raw() as i64, frame.fault_reset().map(|value| value as i64)),
        1 => (frame.run_raw() as i64, frame.run().map(|value| value as i64)),
        2 => (frame.frequency_raw() as i64, frame.frequency().map(|value| value as i64)),
        3 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu4(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu4(data);
    match index {
        0 => frame.with_fault_reset_raw(raw as u8).0,
        1 => frame.with_run_raw(raw as u8).0,
        2 => frame.with_frequency_raw(raw as u8).0,
        3 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu5(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu5(data);
    Some(match index {
        0 => (frame.reset_raw() as i64, frame.reset().map(|value| value as i64)),
        1 => (frame.derate_raw() as i64, frame.derate().map(|value| value as i64)),
        2 => (frame.start_permit_raw() as i64, frame.start_permit().map(|value| value as i64)),
        3 => (frame.aux_battery_voltage_raw() as i64, frame.aux_battery_voltage().map(|value| value as i64)),
        4 => (frame.soc_raw() as i64, frame.soc().map(|value| value as i64)),
        5 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu5(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu5(data);
    match index {
        0 => frame.with_reset_raw(raw as u8).0,
        1 => frame.with_derate_raw(raw as u8).0,
        2 => frame.with_start_permit_raw(raw as u8).0,
        3 => frame.with_aux_battery_voltage_raw(raw as u8).0,
        4 => frame.with_soc_raw(raw as u16).0,
        5 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu6(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu6(data);
    Some(match index {
        0 => (frame.input_voltage_limit_raw() as i64, frame.input_voltage_limit().map(|value| value as i64)),
        1 => (frame.start_battery_voltage_raw() as i64, frame.start_battery_voltage().map(|value| value as i64)),
        2 => (frame.command_raw() as i64, frame.command().map(|value| value as i64)),
        3 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu6(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu6(data);
    match index {
        0 => frame.with_input_voltage_limit_raw(raw as u16).0,
        1 => frame.with_start_battery_voltage_raw(raw as u8).0,
        2 => frame.with_command_raw(raw as u8).0,
        3 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu7(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu7(data);
    Some(match index {
        0 => (frame.fault_level_raw() as i64, frame.fault_level().map(|value| value as i64)),
        1 => (frame.dtc_raw() as i64, frame.dtc().map(|value| value as i64)),
        2 => (frame.dryer_pressure_switch_raw() as i64, frame.dryer_pressure_switch().map(|value| value as i64)),
        3 => (frame.compressor_over_temperature_raw() as i64, frame.compressor_over_temperature().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu7(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu7(data);
    match index {
        0 => frame.with_fault_level_raw(raw as u8).0,
        1 => frame.with_dtc_raw(raw as u16).0,
        2 => frame.with_dryer_pressure_switch_raw(raw as u8).0,
        3 => frame.with_compressor_over_temperature_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu9(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu9(data);
    Some(match index {
        0 => (frame.oil_pump_command_raw() as i64, frame.oil_pump_command().map(|value| value as i64)),
        1 => (frame.vehicle_speed_raw() as i64, frame.vehicle_speed().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu9(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu9(data);
    match index {
        0 => frame.with_oil_pump_command_raw(raw as u8).0,
        1 => frame.with_vehicle_speed_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu10(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu10(data);
    Some(match index {
        0 => (frame.positive_contactor_raw() as i64, frame.positive_contactor().map(|value| value as i64)),
        1 => (frame.negative_contactor_raw() as i64, frame.negative_contactor().map(|value| value as i64)),
        2 => (frame.positive_precharge_raw() as i64, frame.positive_precharge().map(|value| value as i64)),
        3 => (frame.negative_precharge_raw() as i64, frame.negative_precharge().map(|value| value as i64)),
        4 => (frame.defrost_raw() as i64, frame.defrost().map(|value| value as i64)),
        5 => (frame.hvac_raw() as i64, frame.hvac().map(|value| value as i64)),
        6 => (frame.battery_heater_raw() as i64, frame.battery_heater().map(|value| value as i64)),
        7 => (frame.heater_raw() as i64, frame.heater().map(|value| value as i64)),
        8 => (frame.charge_raw() as i64, frame.charge().map(|value| value as i64)),
        9 => (frame.accessory_raw() as i64, frame.accessory().map(|value| value as i64)),
        10 => (frame.accessory_precharge_raw() as i64, frame.accessory_precharge().map(|value| value as i64)),
        11 => (frame.contactor_4_raw() as i64, frame.contactor_4().map(|value| value as i64)),
        12 => (frame.contactor_5_raw() as i64, frame.contactor_5().map(|value| value as i64)),
        13 => (frame.contactor_6_raw() as i64, frame.contactor_6().map(|value| value as i64)),
        14 => (frame.contactor_7_raw() as i64, frame.contactor_7().map(|value| value as i64)),
        15 => (frame.contactor_8_raw() as i64, frame.contactor_8().map(|value| value as i64)),
        16 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu10(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu10(data);
    match index {
        0 => frame.with_positive_contactor_raw(raw as u8).0,
        1 => frame.with_negative_contactor_raw(raw as u8).0,
        2 => frame.with_positive_precharge_raw(raw as u8).0,
        3 => frame.with_negative_precharge_raw(raw as u8).0,
        4 => frame.with_defrost_raw(raw as u8).0,
        5 => frame.with_hvac_raw(raw as u8).0,
        6 => frame.with_battery_heater_raw(raw as u8).0,
        7 => frame.with_heater_raw(raw as u8).0,
        8 => frame.with_charge_raw(raw as u8).0,
        9 => frame.with_accessory_raw(raw as u8).0,
        10 => frame.with_accessory_precharge_raw(raw as u8).0,
        11 => frame.with_contactor_4_raw(raw as u8).0,
        12 => frame.with_contactor_5_raw(raw as u8).0,
        13 => frame.with_contactor_6_raw(raw as u8).0,
        14 => frame.with_contactor_7_raw(raw as u8).0,
        15 => frame.with_contactor_8_raw(raw as u8).0,
        16 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_ipu1(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Ipu1(data);
    Some(match index {
        0 => (frame.bus_voltage_raw() as i64, frame.bus_voltage().map(|value| value as i64)),
        1 => (frame.bus_current_raw() as i64, frame.bus_current().map(|value| value as i64)),
        2 => (frame.mode_raw() as i64, frame.mode().map(|value| value as i64)),
        3 => (frame.bus_overcurrent_raw() as i64, frame.bus_overcurrent().map(|value| value as i64)),
        4 => (frame.position_sensor_fault_raw() as i64, frame.position_sensor_fault().map(|value| value as i64)),
        5 => (frame.bus_overvoltage_raw() as i64, frame.bus_overvoltage().map(|value| value as i64)),
        6 => (frame.bus_undervoltage_raw() as i64, frame.bus_undervoltage().map(|value| value as i64)),
        7 => (frame.motor_over_temperature_raw() as i64, frame.motor_over_temperature().map(|value| value as i64)),
        8 => (frame.inverter_over_temperature_raw() as i64, frame.inverter_over_temperature().map(|value| value as i64)),
        9 => (frame.overspeed_raw() as i64, frame.overspeed().map(|value| value as i64)),
        10 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_ipu1(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Ipu1(data);
    match index {
        0 => frame.with_bus_voltage_raw(raw as u16).0,
        1 => frame.with_bus_current_raw(raw as u16).0,
        2 => frame.with_mode_raw(raw as u8).0,
        3 => frame.with_bus_overcurrent_raw(raw as u8).0,
        4 => frame.with_position_sensor_fault_raw(raw as u8).0,
        5 => frame.with_bus_overvoltage_raw(raw as u8).0,
        6 => frame.with_bus_undervoltage_raw(raw as u8).0,
        7 => frame.with_motor_over_temperature_raw(raw as u8).0,
        8 => frame.with_inverter_over_temperature_raw(raw as u8).0,
        9 => frame.with_overspeed_raw(raw as u8).0,
        10 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_ipu2(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Ipu2(data);
    Some(match index {
        0 => (frame.peak_torque_raw() as i64, frame.peak_torque().map(|value| value as i64)),
        1 => (frame.motor_speed_raw() as i64, frame.motor_speed().map(|value| value as i64)),
        2 => (frame.motor_torque_raw() as i64, frame.motor_torque().map(|value| value as i64)),
        3 => (frame.motor_temperature_raw() as i64, frame.motor_temperature().map(|value| value as i64)),
        4 => (frame.controller_temperature_raw() as i64, frame.controller_temperature().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_ipu2(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Ipu2(data);
    match index {
        0 => frame.with_peak_torque_raw(raw as u16).0,
        1 => frame.with_motor_speed_raw(raw as u16).0,
        2 => frame.with_motor_torque_raw(raw as u16).0,
        3 => frame.with_motor_temperature_raw(raw as u8).0,
        4 => frame.with_controller_temperature_raw(raw as u8).0,
        _ => data,
    }
}

fn get_ipu3(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Ipu3(data);
    Some(match index {
        0 => (frame.status_raw() as i64, frame.status().map(|value| value as i64)),
        1 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_ipu3(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Ipu3(data);
    match index {
        0 => frame.with_status_raw(raw as u8).0,
        1 => frame.with_fault_code_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms1(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms1(data);
    Some(match index {
        0 => (frame.pack_voltage_raw() as i64, frame.pack_voltage().map(|value| value as i64)),
        1 => (frame.pack_current_raw() as i64, frame.pack_current().map(|value| value as i64)),
        2 => (frame.soc_raw() as i64, frame.soc().map(|value| value as i64)),
        3 => (frame.fault_level_raw() as i64, frame.fault_level().map(|value| value as i64)),
        4 => (frame.hv_open_request_raw() as i64, frame.hv_open_request().map(|value| value as i64)),
        5 => (frame.check_state_raw() as i64, frame.check_state().map(|value| value as i64)),
        6 => (frame.heater_relay_raw() as i64, frame.heater_relay().map(|value| value as i64)),
        7 => (frame.charge_2_relay_raw() as i64, frame.charge_2_relay().map(|value| value as i64)),
        8 => (frame.charge_1_relay_raw() as i64, frame.charge_1_relay().map(|value| value as i64)),
        9 => (frame.main_relay_raw() as i64, frame.main_relay().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms1(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms1(data);
    match index {
        0 => frame.with_pack_voltage_raw(raw as u16).0,
        1 => frame.with_pack_current_raw(raw as u16).0,
        2 => frame.with_soc_raw(raw as u16).0,
        3 => frame.with_fault_level_raw(raw as u8).0,
        4 => frame.with_hv_open_request_raw(raw as u8).0,
        5 => frame.with_check_state_raw(raw as u8).0,
        6 => frame.with_heater_relay_raw(raw as u8).0,
        7 => frame.with_charge_2_relay_raw(raw as u8).0,
        8 => frame.with_charge_1_relay_raw(raw as u8).0,
        9 => frame.with_main_relay_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms2(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms2(data);
    Some(match index {
        0 => (frame.max_cell_voltage_raw() as i64, frame.max_cell_voltage().map(|value| value as i64)),
        1 => (frame.min_cell_voltage_raw() as i64, frame.min_cell_voltage().map(|value| value as i64)),
        2 => (frame.max_cell_temperature_raw() as i64, frame.max_cell_temperature().map(|value| value as i64)),
        3 => (frame.min_cell_temperature_raw() as i64, frame.min_cell_temperature().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms2(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms2(data);
    match index {
        0 => frame.with_max_cell_voltage_raw(raw as u16).0,
        1 => frame.with_min_cell_voltage_raw(raw as u16).0,
        2 => frame.with_max_cell_temperature_raw(raw as u8).0,
        3 => frame.with_min_cell_temperature_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms4(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms4(data);
    Some(match index {
        0 => (frame.max_charge_current_raw() as i64, frame.max_charge_current().map(|value| value as i64)),
        1 => (frame.max_discharge_current_raw() as i64, frame.max_discharge_current().map(|value| value as i64)),
        2 => (frame.max_temperature_raw() as i64, frame.max_temperature().map(|value| value as i64)),
        3 => (frame.min_temperature_raw() as i64, frame.min_temperature().map(|value| value as i64)),
        4 => (frame.min_soc_raw() as i64, frame.min_soc().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms4(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms4(data);
    match index {
        0 => frame.with_max_charge_current_raw(raw as u16).0,
        1 => frame.with_max_discharge_current_raw(raw as u16).0,
        2 => frame.with_max_temperature_raw(raw as u8).0,
        3 => frame.with_min_temperature_raw(raw as u8).0,
        4 => frame.with_min_soc_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms5(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms5(data);
    Some(match index {
        0 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        1 => (frame.charge_interval_raw() as i64, frame.charge_interval().map(|value| value as i64)),
        2 => (frame.charge_state_raw() as i64, frame.charge_state().map(|value| value as i64)),
        3 => (frame.balancing_raw() as i64, frame.balancing().map(|value| value as i64)),
        4 => (frame.plug_state_raw() as i64, frame.plug_state().map(|value| value as i64)),
        5 => (frame.pantograph_charge_state_raw() as i64, frame.pantograph_charge_state().map(|value| value as i64)),
        6 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms5(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms5(data);
    match index {
        0 => frame.with_fault_code_raw(raw as u8).0,
        1 => frame.with_charge_interval_raw(raw as u8).0,
        2 => frame.with_charge_state_raw(raw as u8).0,
        3 => frame.with_balancing_raw(raw as u8).0,
        4 => frame.with_plug_state_raw(raw as u8).0,
        5 => frame.with_pantograph_charge_state_raw(raw as u8).0,
        6 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms6(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms6(data);
    Some(match index {
        0 => (frame.min_temperature_1_raw() as i64, frame.min_temperature_1().map(|value| value as i64)),
        1 => (frame.min_temperature_1_box_raw() as i64, frame.min_temperature_1_box().map(|value| value as i64)),
        2 => (frame.min_temperature_2_raw() as i64, frame.min_temperature_2().map(|value| value as i64)),
        3 => (frame.min_temperature_2_box_raw() as i64, frame.min_temperature_2_box().map(|value| value as i64)),
        4 => (frame.min_temperature_3_raw() as i64, frame.min_temperature_3().map(|value| value as i64)),
        5 => (frame.min_temperature_3_box_raw() as i64, frame.min_temperature_3_box().map(|value| value as i64)),
        6 => (frame.min_temperature_4_raw() as i64, frame.min_temperature_4().map(|value| value as i64)),
        7 => (frame.min_temperature_4_box_raw() as i64, frame.min_temperature_4_box().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms6(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms6(data);
    match index {
        0 => frame.with_min_temperature_1_raw(raw as u8).0,
        1 => frame.with_min_temperature_1_box_raw(raw as u8).0,
        2 => frame.with_min_temperature_2_raw(raw as u8).0,
        3 => frame.with_min_temperature_2_box_raw(raw as u8).0,
        4 => frame.with_min_temperature_3_raw(raw as u8).0,
        5 => frame.with_min_temperature_3_box_raw(raw as u8).0,
        6 => frame.with_min_temperature_4_raw(raw as u8).0,
        7 => frame.with_min_temperature_4_box_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms7(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms7(data);
    Some(match index {
        0 => (frame.max_temperature_1_raw() as i64, frame.max_temperature_1().map(|value| value as i64)),
        1 => (frame.max_temperature_1_box_raw() as i64, frame.max_temperature_1_box().map(|value| value as i64)),
        2 => (frame.max_temperature_2_raw() as i64, frame.max_temperature_2().map(|value| value as i64)),
        3 => (frame.max_temperature_2_box_raw() as i64, frame.max_temperature_2_box().map(|value| value as i64)),
        4 => (frame.max_temperature_3_raw() as i64, frame.max_temperature_3().map(|value| value as i64)),
        5 => (frame.max_temperature_3_box_raw() as i64, frame.max_temperature_3_box().map(|value| value as i64)),
        6 => (frame.max_temperature_4_raw() as i64, frame.max_temperature_4().map(|value| value as i64)),
        7 => (frame.max_temperature_4_box_raw() as i64, frame.max_temperature_4_box().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms7(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms7(data);
    match index {
        0 => frame.with_max_temperature_1_raw(raw as u8).0,
        1 => frame.with_max_temperature_1_box_raw(raw as u8).0,
        2 => frame.with_max_temperature_2_raw(raw as u8).0,
        3 => frame.with_max_temperature_2_box_raw(raw as u8).0,
        4 => frame.with_max_temperature_3_raw(raw as u8).0,
        5 => frame.with_max_temperature_3_box_raw(raw as u8).0,
        6 => frame.with_max_temperature_4_raw(raw as u8).0,
        7 => frame.with_max_temperature_4_box_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms8(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms8(data);
    Some(match index {
        0 => (frame.min_voltage_1_raw() as i64, frame.min_voltage_1().map(|value| value as i64)),
        1 => (frame.min_voltage_1_cell_raw() as i64, frame.min_voltage_1_cell().map(|value| value as i64)),
        2 => (frame.min_voltage_1_box_raw() as i64, frame.min_voltage_1_box().map(|value| value as i64)),
        3 => (frame.min_voltage_2_raw() as i64, frame.min_voltage_2().map(|value| value as i64)),
        4 => (frame.min_voltage_2_cell_raw() as i64, frame.min_voltage_2_cell().map(|value| value as i64)),
        5 => (frame.min_voltage_2_box_raw() as i64, frame.min_voltage_2_box().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms8(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms8(data);
    match index {
        0 => frame.with_min_voltage_1_raw(raw as u16).0,
        1 => frame.with_min_voltage_1_cell_raw(raw as u8).0,
        2 => frame.with_min_voltage_1_box_raw(raw as u8).0,
        3 => frame.with_min_voltage_2_raw(raw as u16).0,
        4 => frame.with_min_voltage_2_cell_raw(raw as u8).0,
        5 => frame.with_min_voltage_2_box_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms9(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms9(data);
    Some(match index {
        0 => (frame.min_voltage_3_raw() as i64, frame.min_voltage_3().map(|value| value as i64)),
        1 => (frame.min_voltage_3_cell_raw() as i64, frame.min_voltage_3_cell().map(|value| value as i64)),
        2 => (frame.min_voltage_3_box_raw() as i64, frame.min_voltage_3_box().map(|value| value as i64)),
        3 => (frame.min_voltage_4_raw() as i64, frame.min_voltage_4().map(|value| value as i64)),
        4 => (frame.min_voltage_4_cell_raw() as i64, frame.min_voltage_4_cell().map(|value| value as i64)),
        5 => (frame.min_voltage_4_box_raw() as i64, frame.min_voltage_4_box().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms9(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms9(data);
    match index {
        0 => frame.with_min_voltage_3_raw(raw as u16).0,
        1 => frame.with_min_voltage_3_cell_raw(raw as u8).0,
        2 => frame.with_min_voltage_3_box_raw(raw as u8).0,
        3 => frame.with_min_voltage_4_raw(raw as u16).0,
        4 => frame.with_min_voltage_4_cell_raw(raw as u8).0,
        5 => frame.with_min_voltage_4_box_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms10(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms10(data);
    Some(match index {
        0 => (frame.max_voltage_1_raw() as i64, frame.max_voltage_1().map(|value| value as i64)),
        1 => (frame.max_voltage_1_cell_raw() as i64, frame.max_voltage_1_cell().map(|value| value as i64)),
        2 => (frame.max_voltage_1_box_raw() as i64, frame.max_voltage_1_box().map(|value| value as i64)),
        3 => (frame.max_voltage_2_raw() as i64, frame.max_voltage_2().map(|value| value as i64)),
        4 => (frame.max_voltage_2_cell_raw() as i64, frame.max_voltage_2_cell().map(|value| value as i64)),
        5 => (frame.max_voltage_2_box_raw() as i64, frame.max_voltage_2_box().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms10(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms10(data);
    match index {
        0 => frame.with_max_voltage_1_raw(raw as u16).0,
        1 => frame.with_max_voltage_1_cell_raw(raw as u8).0,
        2 => frame.with_max_voltage_1_box_raw(raw as u8).0,
        3 => frame.with_max_voltage_2_raw(raw as u16).0,
        4 => frame.with_max_voltage_2_cell_raw(raw as u8).0,
        5 => frame.with_max_voltage_2_box_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms11(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms11(data);
    Some(match index {
        0 => (frame.max_voltage_3_raw() as i64, frame.max_voltage_3().map(|value| value as i64)),
        1 => (frame.max_voltage_3_cell_raw() as i64, frame.max_voltage_3_cell().map(|value| value as i64)),
        2 => (frame.max_voltage_3_box_raw() as i64, frame.max_voltage_3_box().map(|value| value as i64)),
        3 => (frame.max_voltage_4_raw() as i64, frame.max_voltage_4().map(|value| value as i64)),
        4 => (frame.max_voltage_4_cell_raw() as i64, frame.max_voltage_4_cell().map(|value| value as i64)),
        5 => (frame.max_voltage_4_box_raw() as i64, frame.max_voltage_4_box().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms11(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms11(data);
    match index {
        0 => frame.with_max_voltage_3_raw(raw as u16).0,
        1 => frame.with_max_voltage_3_cell_raw(raw as u8).0,
        2 => frame.with_max_voltage_3_box_raw(raw as u8).0,
        3 => frame.with_max_voltage_4_raw(raw as u16).0,
        4 => frame.with_max_voltage_4_cell_raw(raw as u8).0,
        5 => frame.with_max_voltage_4_box_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms12(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Bms12(data);
    Some(match index {
        0 => (frame.rated_capacity_raw() as i64, frame.rated_capacity().map(|value| value as i64)),
        1 => (frame.rated_voltage_raw() as i64, frame.rated_voltage().map(|value| value as i64)),
        2 => (frame.production_year_raw() as i64, frame.production_year().map(|value| value as i64)),
        3 => (frame.production_month_raw() as i64, frame.production_month().map(|value| value as i64)),
        4 => (frame.production_day_raw() as i64, frame.production_day().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms12(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Bms12(data);
    match index {
        0 => frame.with_rated_capacity_raw(raw as u16).0,
        1 => frame.with_rated_voltage_raw(raw as u16).0,
        2 => frame.with_production_year_raw(raw as u8).0,
        3 => frame.with_production_month_raw(raw as u8).0,
        4 => frame.with_production_day_raw(raw as u8).0,
        _ => data,
    }
}

fn get_steering_pump(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = SteeringPump(data);
    Some(match index {
        0 => (frame.motor_speed_raw() as i64, frame.motor_speed().map(|value| value as i64)),
        1 => (frame.bus_voltage_raw() as i64, frame.bus_voltage().map(|value| value as i64)),
        2 => (frame.current_raw() as i64, frame.current().map(|value| value as i64)),
        3 => (frame.controller_temperature_raw() as i64, frame.controller_temperature().map(|value| value as i64)),
        4 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        5 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        6 => (frame.status_raw() as i64, frame.status().map(|value| value as i64)),
        7 => (frame.external_control_raw() as i64, frame.external_control().map(|value| value as i64)),
        8 => (frame.precharged_raw() as i64, frame.precharged().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_steering_pump(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = SteeringPump(data);
    match index {
        0 => frame.with_motor_speed_raw(raw as u16).0,
        1 => frame.with_bus_voltage_raw(raw as u16).0,
        2 => frame.with_current_raw(raw as u8).0,
        3 => frame.with_controller_temperature_raw(raw as u8).0,
        4 => frame.with_life_raw(raw as u8).0,
        5 => frame.with_fault_code_raw(raw as u8).0,
        6 => frame.with_status_raw(raw as u8).0,
        7 => frame.with_external_control_raw(raw as u8).0,
        8 => frame.with_precharged_raw(raw as u8).0,
        _ => data,
    }
}

fn get_low_voltage_steering(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = LowVoltageSteering(data);
    Some(match index {
        0 => (frame.status_raw() as i64, frame.status().map(|value| value as i64)),
        1 => (frame.output_voltage_raw() as i64, frame.output_voltage().map(|value| value as i64)),
        2 => (frame.output_current_raw() as i64, frame.output_current().map(|value| value as i64)),
        3 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        4 => (frame.radiator_temperature_raw() as i64, frame.radiator_temperature().map(|value| value as i64)),
        5 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        6 => (frame.alarm_level_raw() as i64, frame.alarm_level().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_low_voltage_steering(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = LowVoltageSteering(data);
    match index {
        0 => frame.with_status_raw(raw as u8).0,
        1 => frame.with_output_voltage_raw(raw as u8).0,
        2 => frame.with_output_current_raw(raw as u16).0,
        3 => frame.with_life_raw(raw as u8).0,
        4 => frame.with_radiator_temperature_raw(raw as u8).0,
        5 => frame.with_fault_code_raw(raw as u8).0,
        6 => frame.with_alarm_level_raw(raw as u8).0,
        _ => data,
    }
}

fn get_dcdc(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Dcdc(data);
    Some(match index {
        0 => (frame.input_voltage_raw() as i64, frame.input_voltage().map(|value| value as i64)),
        1 => (frame.input_current_raw() as i64, frame.input_current().map(|value| value as i64)),
        2 => (frame.output_current_raw() as i64, frame.output_current().map(|value| value as i64)),
        3 => (frame.controller_temperature_raw() as i64, frame.controller_temperature().map(|value| value as i64)),
        4 => (frame.output_voltage_raw() as i64, frame.output_voltage().map(|value| value as i64)),
        5 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        6 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        7 => (frame.status_raw() as i64, frame.status().map(|value| value as i64)),
        8 => (frame.precharged_raw() as i64, frame.precharged().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_dcdc(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Dcdc(data);
    match index {
        0 => frame.with_input_voltage_raw(raw as u16).0,
        1 => frame.with_input_current_raw(raw as u8).0,
        2 => frame.with_output_current_raw(raw as u8).0,
        3 => frame.with_controller_temperature_raw(raw as u8).0,
        4 => frame.with_output_voltage_raw(raw as u8).0,
        5 => frame.with_life_raw(raw as u8).0,
        6 => frame.with_fault_code_raw(raw as u8).0,
        7 => frame.with_status_raw(raw as u8).0,
        8 => frame.with_precharged_raw(raw as u8).0,
        _ => data,
    }
}

fn get_air_pump(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = AirPump(data);
    Some(match index {
        0 => (frame.motor_speed_raw() as i64, frame.motor_speed().map(|value| value as i64)),
        1 => (frame.bus_voltage_raw() as i64, frame.bus_voltage().map(|value| value as i64)),
        2 => (frame.current_raw() as i64, frame.current().map(|value| value as i64)),
        3 => (frame.controller_temperature_raw() as i64, frame.controller_temperature().map(|value| value as i64)),
        4 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        5 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        6 => (frame.status_raw() as i64, frame.status().map(|value| value as i64)),
        7 => (frame.precharged_raw() as i64, frame.precharged().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_air_pump(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = AirPump(data);
    match index {
        0 => frame.with_motor_speed_raw(raw as u16).0,
        1 => frame.with_bus_voltage_raw(raw as u16).0,
        2 => frame.with_current_raw(raw as u8).0,
        3 => frame.with_controller_temperature_raw(raw as u8).0,
        4 => frame.with_life_raw(raw as u8).0,
        5 => frame.with_fault_code_raw(raw as u8).0,
        6 => frame.with_status_raw(raw as u8).0,
        7 => frame.with_precharged_raw(raw as u8).0,
        _ => data,
    }
}

fn get_meter1(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Meter1(data);
    Some(match index {
        0 => (frame.aux_battery_voltage_raw() as i64, frame.aux_battery_voltage().map(|value| value as i64)),
        1 => (frame.exit_door_raw() as i64, frame.exit_door().map(|value| value as i64)),
        2 => (frame.middle_door_raw() as i64, frame.middle_door().map(|value| value as i64)),
        3 => (frame.entry_door_raw() as i64, frame.entry_door().map(|value| value as i64)),
        4 => (frame.rear_hatch_raw() as i64, frame.rear_hatch().map(|value| value as i64)),
        5 => (frame.handbrake_raw() as i64, frame.handbrake().map(|value| value as i64)),
        6 => (frame.smoke_alarm_raw() as i64, frame.smoke_alarm().map(|value| value as i64)),
        7 => (frame.key_position_raw() as i64, frame.key_position().map(|value| value as i64)),
        8 => (frame.front_air_pressure_raw() as i64, frame.front_air_pressure().map(|value| value as i64)),
        9 => (frame.rear_air_pressure_raw() as i64, frame.rear_air_pressure().map(|value| value as i64)),
        10 => (frame.low_beam_raw() as i64, frame.low_beam().map(|value| value as i64)),
        11 => (frame.high_beam_raw() as i64, frame.high_beam().map(|value| value as i64)),
        12 => (frame.brake_lamp_raw() as i64, frame.brake_lamp().map(|value| value as i64)),
        13 => (frame.right_turn_raw() as i64, frame.right_turn().map(|value| value as i64)),
        14 => (frame.left_turn_raw() as i64, frame.left_turn().map(|value| value as i64)),
        15 => (frame.hazard_raw() as i64, frame.hazard().map(|value| value as i64)),
        16 => (frame.front_fog_raw() as i64, frame.front_fog().map(|value| value as i64)),
        17 => (frame.rear_fog_raw() as i64, frame.rear_fog().map(|value| value as i64)),
        18 => (frame.side_lamp_raw() as i64, frame.side_lamp().map(|value| value as i64)),
        19 => (frame.horn_raw() as i64, frame.horn().map(|value| value as i64)),
        20 => (frame.driver_left_seat_raw() as i64, frame.driver_left_seat().map(|value| value as i64)),
        21 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_meter1(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Meter1(data);
    match index {
        0 => frame.with_aux_battery_voltage_raw(raw as u8).0,
        1 => frame.with_exit_door_raw(raw as u8).0,
        2 => frame.with_middle_door_raw(raw as u8).0,
        3 => frame.with_entry_door_raw(raw as u8).0,
        4 => frame.with_rear_hatch_raw(raw as u8).0,
        5 => frame.with_handbrake_raw(raw as u8).0,
        6 => frame.with_smoke_alarm_raw(raw as u8).0,
        7 => frame.with_key_position_raw(raw as u8).0,
        8 => frame.with_front_air_pressure_raw(raw as u8).0,
        9 => frame.with_rear_air_pressure_raw(raw as u8).0,
        10 => frame.with_low_beam_raw(raw as u8).0,
        11 => frame.with_high_beam_raw(raw as u8).0,
        12 => frame.with_brake_lamp_raw(raw as u8).0,
        13 => frame.with_right_turn_raw(raw as u8).0,
        14 => frame.with_left_turn_raw(raw as u8).0,
        15 => frame.with_hazard_raw(raw as u8).0,
        16 => frame.with_front_fog_raw(raw as u8).0,
        17 => frame.with_rear_fog_raw(raw as u8).0,
        18 => frame.with_side_lamp_raw(raw as u8).0,
        19 => frame.with_horn_raw(raw as u8).0,
        20 => frame.with_driver_left_seat_raw(raw as u8).0,
        21 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_meter2(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Meter2(data);
    Some(match index {
        0 => (frame.odometer_raw() as i64, frame.odometer().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_meter2(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Meter2(data);
    match index {
        0 => frame.with_odometer_raw(raw as u32).0,
        _ => data,
    }
}

fn get_hvac(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Hvac(data);
    Some(match index {
        0 => (frame.return_sensor_open_raw() as i64, frame.return_sensor_open().map(|value| value as i64)),
        1 => (frame.outside_sensor_open_raw() as i64, frame.outside_sensor_open().map(|value| value as i64)),
        2 => (frame.evaporator_1_sensor_open_raw() as i64, frame.evaporator_1_sensor_open().map(|value| value as i64)),
        3 => (frame.evaporator_2_sensor_open_raw() as i64, frame.evaporator_2_sensor_open().map(|value| value as i64)),
        4 => (frame.supply_overvoltage_raw() as i64, frame.supply_overvoltage().map(|value| value as i64)),
        5 => (frame.supply_undervoltage_raw() as i64, frame.supply_undervoltage().map(|value| value as i64)),
        6 => (frame.inverter_fault_raw() as i64, frame.inverter_fault().map(|value| value as i64)),
        7 => (frame.pressure_fault_raw() as i64, frame.pressure_fault().map(|value| value as i64)),
        8 => (frame.fan_low_raw() as i64, frame.fan_low().map(|value| value as i64)),
        9 => (frame.fan_mid_raw() as i64, frame.fan_mid().map(|value| value as i64)),
        10 => (frame.fan_high_raw() as i64, frame.fan_high().map(|value| value as i64)),
        11 => (frame.heating_raw() as i64, frame.heating().map(|value| value as i64)),
        12 => (frame.defrost_1_raw() as i64, frame.defrost_1().map(|value| value as i64)),
        13 => (frame.fresh_air_raw() as i64, frame.fresh_air().map(|value| value as i64)),
        14 => (frame.sterilise_raw() as i64, frame.sterilise().map(|value| value as i64)),
        15 => (frame.defrost_2_raw() as i64, frame.defrost_2().map(|value| value as i64)),
        16 => (frame.cooling_2_raw() as i64, frame.cooling_2().map(|value| value as i64)),
        17 => (frame.cooling_1_raw() as i64, frame.cooling_1().map(|value| value as i64)),
        18 => (frame.cabin_temperature_raw() as i64, frame.cabin_temperature().map(|value| value as i64)),
        19 => (frame.outside_temperature_raw() as i64, frame.outside_temperature().map(|value| value as i64)),
        20 => (frame.communication_alarm_raw() as i64, frame.communication_alarm().map(|value| value as i64)),
        21 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_hvac(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Hvac(data);
    match index {
        0 => frame.with_return_sensor_open_raw(raw as u8).0,
        1 => frame.with_outside_sensor_open_raw(raw as u8).0,
        2 => frame.with_evaporator_1_sensor_open_raw(raw as u8).0,
        3 => frame.with_evaporator_2_sensor_open_raw(raw as u8).0,
        4 => frame.with_supply_overvoltage_raw(raw as u8).0,
        5 => frame.with_supply_undervoltage_raw(raw as u8).0,
        6 => frame.with_inverter_fault_raw(raw as u8).0,
        7 => frame.with_pressure_fault_raw(raw as u8).0,
        8 => frame.with_fan_low_raw(raw as u8).0,
        9 => frame.with_fan_mid_raw(raw as u8).0,
        10 => frame.with_fan_high_raw(raw as u8).0,
        11 => frame.with_heating_raw(raw as u8).0,
        12 => frame.with_defrost_1_raw(raw as u8).0,
        13 => frame.with_fresh_air_raw(raw as u8).0,
        14 => frame.with_sterilise_raw(raw as u8).0,
        15 => frame.with_defrost_2_raw(raw as u8).0,
        16 => frame.with_cooling_2_raw(raw as u8).0,
        17 => frame.with_cooling_1_raw(raw as u8).0,
        18 => frame.with_cabin_temperature_raw(raw as u8).0,
        19 => frame.with_outside_temperature_raw(raw as u8).0,
        20 => frame.with_communication_alarm_raw(raw as u8).0,
        21 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_insulation(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Insulation(data);
    Some(match index {
        0 => (frame.leakage_level_raw() as i64, frame.leakage_level().map(|value| value as i64)),
        1 => (frame.positive_resistance_raw() as i64, frame.positive_resistance().map(|value| value as i64)),
        2 => (frame.negative_resistance_raw() as i64, frame.negative_resistance().map(|value| value as i64)),
        3 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        4 => (frame.level_1_alarm_raw() as i64, frame.level_1_alarm().map(|value| value as i64)),
        5 => (frame.level_2_alarm_raw() as i64, frame.level_2_alarm().map(|value| value as i64)),
        6 => (frame.positive_fault_raw() as i64, frame.positive_fault().map(|value| value as i64)),
        7 => (frame.negative_fault_raw() as i64, frame.negative_fault().map(|value| value as i64)),
        8 => (frame.wiring_fault_raw() as i64, frame.wiring_fault().map(|value| value as i64)),
        9 => (frame.device_fault_raw() as i64, frame.device_fault().map(|value| value as i64)),
        10 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_insulation(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Insulation(data);
    match index {
        0 => frame.with_leakage_level_raw(raw as u8).0,
        1 => frame.with_positive_resistance_raw(raw as u16).0,
        2 => frame.with_negative_resistance_raw(raw as u16).0,
        3 => frame.with_fault_code_raw(raw as u8).0,
        4 => frame.with_level_1_alarm_raw(raw as u8).0,
        5 => frame.with_level_2_alarm_raw(raw as u8).0,
        6 => frame.with_positive_fault_raw(raw as u8).0,
        7 => frame.with_negative_fault_raw(raw as u8).0,
        8 => frame.with_wiring_fault_raw(raw as u8).0,
        9 => frame.with_device_fault_raw(raw as u8).0,
        10 => frame.with_life_raw(raw as u8).0,
        _ => data,
    }
}

fn get_charger_tx(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = ChargerTx(data);
    Some(match index {
        0 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        1 => (frame.output_voltage_raw() as i64, frame.output_voltage().map(|value| value as i64)),
        2 => (frame.output_current_raw() as i64, frame.output_current().map(|value| value as i64)),
        3 => (frame.hardware_fault_raw() as i64, frame.hardware_fault().map(|value| value as i64)),
        4 => (frame.over_temperature_raw() as i64, frame.over_temperature().map(|value| value as i64)),
        5 => (frame.input_voltage_fault_raw() as i64, frame.input_voltage_fault().map(|value| value as i64)),
        6 => (frame.start_inhibited_raw() as i64, frame.start_inhibited().map(|value| value as i64)),
        7 => (frame.communication_fault_raw() as i64, frame.communication_fault().map(|value| value as i64)),
        8 => (frame.fault_level_raw() as i64, frame.fault_level().map(|value| value as i64)),
        9 => (frame.fault_code_raw() as i64, frame.fault_code().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_charger_tx(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = ChargerTx(data);
    match index {
        0 => frame.with_life_raw(raw as u8).0,
        1 => frame.with_output_voltage_raw(raw as u16).0,
        2 => frame.with_output_current_raw(raw as u16).0,
        3 => frame.with_hardware_fault_raw(raw as u8).0,
        4 => frame.with_over_temperature_raw(raw as u8).0,
        5 => frame.with_input_voltage_fault_raw(raw as u8).0,
        6 => frame.with_start_inhibited_raw(raw as u8).0,
        7 => frame.with_communication_fault_raw(raw as u8).0,
        8 => frame.with_fault_level_raw(raw as u8).0,
        9 => frame.with_fault_code_raw(raw as u8).0,
        _ => data,
    }
}

fn get_charger_rx(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = ChargerRx(data);
    Some(match index {
        0 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        1 => (frame.max_voltage_raw() as i64, frame.max_voltage().map(|value| value as i64)),
        2 => (frame.max_current_raw() as i64, frame.max_current().map(|value| value as i64)),
        3 => (frame.enable_raw() as i64, frame.enable().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_charger_rx(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = ChargerRx(data);
    match index {
        0 => frame.with_life_raw(raw as u8).0,
        1 => frame.with_max_voltage_raw(raw as u16).0,
        2 => frame.with_max_current_raw(raw as u16).0,
        3 => frame.with_enable_raw(raw as u8).0,
        _ => data,
    }
}

fn get_peu(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Peu(data);
    Some(match index {
        0 => (frame.positive_contactor_raw() as i64, frame.positive_contactor().map(|value| value as i64)),
        1 => (frame.battery_main_contactor_raw() as i64, frame.battery_main_contactor().map(|value| value as i64)),
        2 => (frame.positive_precharge_raw() as i64, frame.positive_precharge().map(|value| value as i64)),
        3 => (frame.negative_precharge_raw() as i64, frame.negative_precharge().map(|value| value as i64)),
        4 => (frame.defrost_raw() as i64, frame.defrost().map(|value| value as i64)),
        5 => (frame.hvac_raw() as i64, frame.hvac().map(|value| value as i64)),
        6 => (frame.battery_heater_raw() as i64, frame.battery_heater().map(|value| value as i64)),
        7 => (frame.heater_raw() as i64, frame.heater().map(|value| value as i64)),
        8 => (frame.accessory_raw() as i64, frame.accessory().map(|value| value as i64)),
        9 => (frame.accessory_precharge_raw() as i64, frame.accessory_precharge().map(|value| value as i64)),
        10 => (frame.charge_1_raw() as i64, frame.charge_1().map(|value| value as i64)),
        11 => (frame.charge_2_raw() as i64, frame.charge_2().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_peu(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Peu(data);
    match index {
        0 => frame.with_positive_contactor_raw(raw as u8).0,
        1 => frame.with_battery_main_contactor_raw(raw as u8).0,
        2 => frame.with_positive_precharge_raw(raw as u8).0,
        3 => frame.with_negative_precharge_raw(raw as u8).0,
        4 => frame.with_defrost_raw(raw as u8).0,
        5 => frame.with_hvac_raw(raw as u8).0,
        6 => frame.with_battery_heater_raw(raw as u8).0,
        7 => frame.with_heater_raw(raw as u8).0,
        8 => frame.with_accessory_raw(raw as u8).0,
        9 => frame.with_accessory_precharge_raw(raw as u8).0,
        10 => frame.with_charge_1_raw(raw as u8).0,
        11 => frame.with_charge_2_raw(raw as u8).0,
        _ => data,
    }
}

static VCU1_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "drive_mode", start: 0, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "park"), (1, "snow"), (2, "climb"), (3, "drive")] },
    SignalInfo { name: "gear", start: 2, length: 4, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 11), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "D"), (2, "R"), (3, "D1"), (4, "N"), (5, "D2"), (6, "D3"), (8, "P"), (9, "D4"), (10, "D5"), (11, "D6")] },
    SignalInfo { name: "handbrake", start: 6, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "foot_brake", start: 7, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "accelerator_pedal", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "vehicle_speed", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 256 }, unit: "km/h", range: (0, 51200), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "brake_pedal", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "torque_limited", start: 48, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "power_limited", start: 49, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "system_fault", start: 54, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "ready", start: 55, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "life", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static VCU2_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "target_torque", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -30000, den: 10 }, unit: "Nm", range: (0, 60000), start_raw: 30000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "ipu_enable", start: 16, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "disable"), (1, "enable")] },
    SignalInfo { name: "discharge_enable", start: 23, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "disable"), (1, "enable")] },
    SignalInfo { name: "control_mode", start: 24, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "speed"), (2, "torque")] },
    SignalInfo { name: "power_limit", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "kW", range: (1, 250), start_raw: 255, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static VCU3_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "vendor_code", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "hv_command", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[(0, "open"), (1, "close")] },
    SignalInfo { name: "mcu_input_voltage", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "pantograph_state", start: 45, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "disconnected"), (1, "rising"), (2, "connected"), (3, "fault")] },
    SignalInfo { name: "charge_enable", start: 47, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "stop"), (1, "permit")] },
    SignalInfo { name: "hv_cutoff", start: 48, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "precharge_relay", start: 49, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "motor_relay", start: 50, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "accessory_relay", start: 51, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "accessory_precharge_relay", start: 52, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "defrost_relay", start: 53, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "charge_relay", start: 54, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "battery_relay", start: 55, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "life", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static VCU4_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "fault_reset", start: 0, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "idle"), (1, "reset")] },
    SignalInfo { name: "run", start: 6, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "stop"), (1, "run")] },
    SignalInfo { name: "frequency", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "Hz", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "life", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static VCU5_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "reset", start: 0, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "idle"), (1, "reset")] },
    SignalInfo { name: "derate", start: 5, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "normal"), (1, "derate")] },
    SignalInfo { name: "start_permit", start: 6, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "stop"), (1, "permit")] },
    SignalInfo { name: "aux_battery_voltage", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "V", range: (0, 40), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "soc", start: 47, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "life", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static VCU6_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "input_voltage_limit", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "start_battery_voltage", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "V", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "command", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (85, 170), start_raw: 85, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[(85, "standby"), (170, "start")] },
    SignalInfo { name: "life", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static VCU7_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "fault_level", start: 0, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2"), (3, "level_3")] },
    SignalInfo { name: "dtc", start: 8, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 65535), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "dryer_pressure_switch", start: 32, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "compressor_over_temperature", start: 33, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
];

static VCU9_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "oil_pump_command", start: 0, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "stop"), (1, "run"), (2, "reserved"), (3, "test")] },
    SignalInfo { name: "vehicle_speed", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "km/h", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static VCU10_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "positive_contactor", start: 0, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "negative_contactor", start: 2, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "positive_precharge", start: 4, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "negative_precharge", start: 6, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "defrost", start: 8, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "hvac", start: 10, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "battery_heater", start: 12, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "heater", start: 14, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "charge", start: 16, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "accessory", start: 18, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "accessory_precharge", start: 20, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "contactor_4", start: 22, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "contactor_5", start: 24, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "contactor_6", start: 26, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "contactor_7", start: 28, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "contactor_8", start: 30, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed")] },
    SignalInfo { name: "life", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static IPU1_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "bus_voltage", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "bus_current", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -10000, den: 10 }, unit: "A", range: (0, 20000), start_raw: 10000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "mode", start: 34, length: 5, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 26), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "failure"), (2, "zero_torque"), (3, "speed"), (10, "brake"), (18, "forward"), (26, "reverse")] },
    SignalInfo { name: "bus_overcurrent", start: 40, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "position_sensor_fault", start: 42, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "bus_overvoltage", start: 43, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "bus_undervoltage", start: 44, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "motor_over_temperature", start: 45, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "inverter_over_temperature", start: 46, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "overspeed", start: 47, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "life", start: 60, length: 4, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 15), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::Nibble), values: &[] },
];

static IPU2_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "peak_torque", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -30000, den: 10 }, unit: "Nm", range: (0, 60000), start_raw: 30000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "motor_speed", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -12000, den: 1 }, unit: "rpm", range: (0, 24000), start_raw: 12000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "motor_torque", start: 32, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -30000, den: 10 }, unit: "Nm", range: (0, 60000), start_raw: 30000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "motor_temperature", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "controller_temperature", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static IPU3_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "status", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 5), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[(0, "ready"), (2, "running"), (5, "fault")] },
    SignalInfo { name: "fault_code", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static BMS1_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "pack_voltage", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "pack_current", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -10000, den: 10 }, unit: "A", range: (0, 20000), start_raw: 10000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "soc", start: 32, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "fault_level", start: 48, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_3"), (2, "level_2"), (3, "level_1")] },
    SignalInfo { name: "hv_open_request", start: 51, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 2, invalid_raw: None, mux: Mux::Always, life: None, values: &[(2, "none"), (3, "open")] },
    SignalInfo { name: "check_state", start: 53, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 4), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "invalid"), (1, "precharging"), (2, "precharged"), (3, "calibration"), (4, "fault")] },
    SignalInfo { name: "heater_relay", start: 56, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed"), (3, "welded")] },
    SignalInfo { name: "charge_2_relay", start: 58, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed"), (3, "welded")] },
    SignalInfo { name: "charge_1_relay", start: 60, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed"), (3, "welded")] },
    SignalInfo { name: "main_relay", start: 62, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "open"), (1, "closed"), (3, "welded")] },
];

static BMS2_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "max_cell_voltage", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_cell_voltage", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_cell_temperature", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_cell_temperature", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static BMS4_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "max_charge_current", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -10000, den: 10 }, unit: "A", range: (0, 20000), start_raw: 10000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_discharge_current", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -10000, den: 10 }, unit: "A", range: (0, 20000), start_raw: 10000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_soc", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static BMS5_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "fault_code", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "charge_interval", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "d", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "charge_state", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[(0, "idle"), (1, "charging"), (2, "complete"), (3, "fault")] },
    SignalInfo { name: "balancing", start: 24, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "plug_state", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (85, 170), start_raw: 170, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[(85, "inserted"), (170, "not_inserted")] },
    SignalInfo { name: "pantograph_charge_state", start: 40, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 4), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "forbidden"), (1, "ready"), (2, "charging"), (3, "complete"), (4, "fault")] },
    SignalInfo { name: "life", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static BMS6_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "min_temperature_1", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_1_box", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 100), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_2", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_2_box", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 100), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_3", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_3_box", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 100), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_4", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_4_box", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 100), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static BMS7_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "max_temperature_1", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_1_box", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 100), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_2", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_2_box", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 100), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_3", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_3_box", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 100), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_4", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_4_box", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 100), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static BMS8_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "min_voltage_1", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_1_cell", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_1_box", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_2", start: 32, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_2_cell", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_2_box", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static BMS9_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "min_voltage_3", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_3_cell", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_3_box", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_4", start: 32, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_4_cell", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_4_box", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static BMS10_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "max_voltage_1", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_1_cell", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_1_box", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_2", start: 32, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_2_cell", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_2_box", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static BMS11_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "max_voltage_3", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_3_cell", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_3_box", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_4", start: 32, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "V", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_4_cell", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_4_box", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 254), start_raw: 1, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static BMS12_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "rated_capacity", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "Ah", range: (0, 1000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "rated_voltage", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "V", range: (0, 1000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "production_year", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 1985, den: 1 }, unit: "", range: (0, 250), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "production_month", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 12), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "production_day", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 31), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static STEERING_PUMP_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "motor_speed", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 8 }, unit: "rpm", range: (0, 40000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "bus_voltage", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "current", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "A", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "controller_temperature", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "life", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 1, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From1To255), values: &[] },
    SignalInfo { name: "fault_code", start: 56, length: 4, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 15), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "input_overcurrent"), (2, "input_overvoltage"), (3, "input_undervoltage"), (4, "overload"), (5, "open_circuit"), (6, "short_circuit"), (7, "output_phase_loss"), (8, "controller_over_temperature"), (9, "overspeed")] },
    SignalInfo { name: "status", start: 60, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "stopped"), (1, "running"), (2, "fault")] },
    SignalInfo { name: "external_control", start: 62, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "internal"), (1, "external")] },
    SignalInfo { name: "precharged", start: 63, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
];

static LOW_VOLTAGE_STEERING_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "status", start: 0, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "stopped"), (1, "running"), (2, "fault")] },
    SignalInfo { name: "output_voltage", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "V", range: (0, 35), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "output_current", start: 24, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "A", range: (0, 2000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "life", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
    SignalInfo { name: "radiator_temperature", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "fault_code", start: 56, length: 6, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 63), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "alarm_level", start: 62, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: Some(3), mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2"), (3, "invalid")] },
];

static DCDC_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "input_voltage", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "input_current", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "A", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "output_current", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "A", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "controller_temperature", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "output_voltage", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "V", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "life", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 1, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From1To255), values: &[] },
    SignalInfo { name: "fault_code", start: 56, length: 4, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 15), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "hardware"), (2, "output_short"), (3, "input_undervoltage"), (4, "input_overvoltage"), (5, "output_undervoltage"), (6, "output_overvoltage"), (7, "output_overcurrent"), (8, "over_temperature")] },
    SignalInfo { name: "status", start: 60, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "stopped"), (1, "running"), (2, "fault")] },
    SignalInfo { name: "precharged", start: 63, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
];

static AIR_PUMP_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "motor_speed", start: 0, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 8 }, unit: "rpm", range: (0, 40000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "bus_voltage", start: 16, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "current", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "A", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "controller_temperature", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "life", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 1, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From1To255), values: &[] },
    SignalInfo { name: "fault_code", start: 56, length: 4, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 15), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "input_overcurrent"), (2, "input_overvoltage"), (3, "input_undervoltage"), (4, "overload"), (5, "open_circuit"), (6, "short_circuit"), (7, "output_phase_loss"), (8, "controller_over_temperature"), (9, "overspeed"), (10, "compressor_over_temperature")] },
    SignalInfo { name: "status", start: 60, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "stopped"), (1, "running"), (2, "fault")] },
    SignalInfo { name: "precharged", start: 63, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
];

static METER1_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "aux_battery_voltage", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 5 }, unit: "V", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "exit_door", start: 8, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "closed"), (1, "open")] },
    SignalInfo { name: "middle_door", start: 9, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "closed"), (1, "open")] },
    SignalInfo { name: "entry_door", start: 10, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "closed"), (1, "open")] },
    SignalInfo { name: "rear_hatch", start: 11, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "closed"), (1, "open")] },
    SignalInfo { name: "handbrake", start: 12, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "smoke_alarm", start: 13, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "key_position", start: 14, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "lock"), (1, "on"), (2, "acc"), (3, "start")] },
    SignalInfo { name: "front_air_pressure", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "MPa", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "rear_air_pressure", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "MPa", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "low_beam", start: 32, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "high_beam", start: 33, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "brake_lamp", start: 34, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "right_turn", start: 35, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "left_turn", start: 36, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "hazard", start: 37, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "front_fog", start: 38, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "rear_fog", start: 39, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "side_lamp", start: 40, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "horn", start: 41, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "driver_left_seat", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "life", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static METER2_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "odometer", start: 0, length: 32, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 8 }, unit: "km", range: (0, 4294967294), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static HVAC_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "return_sensor_open", start: 0, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "outside_sensor_open", start: 1, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "evaporator_1_sensor_open", start: 2, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "evaporator_2_sensor_open", start: 3, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "supply_overvoltage", start: 4, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "supply_undervoltage", start: 5, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "inverter_fault", start: 6, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "pressure_fault", start: 7, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "fan_low", start: 13, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "fan_mid", start: 14, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "fan_high", start: 15, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "heating", start: 16, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "defrost_1", start: 17, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "fresh_air", start: 18, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "sterilise", start: 19, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "defrost_2", start: 20, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "cooling_2", start: 21, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "cooling_1", start: 23, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "cabin_temperature", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "outside_temperature", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "communication_alarm", start: 47, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "life", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static INSULATION_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "leakage_level", start: 0, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2")] },
    SignalInfo { name: "positive_resistance", start: 8, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "kohm", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "negative_resistance", start: 24, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "kohm", range: (0, 65534), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "fault_code", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "level_1_alarm", start: 48, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "level_2_alarm", start: 49, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "positive_fault", start: 50, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "negative_fault", start: 51, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "wiring_fault", start: 52, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "device_fault", start: 53, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "life", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
];

static CHARGER_TX_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "life", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
    SignalInfo { name: "output_voltage", start: 8, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "output_current", start: 24, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -5000, den: 10 }, unit: "A", range: (0, 10000), start_raw: 5000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "hardware_fault", start: 40, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "over_temperature", start: 41, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "input_voltage_fault", start: 42, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "start_inhibited", start: 43, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "communication_fault", start: 44, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "fault_level", start: 45, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_3"), (2, "level_2"), (3, "level_1")] },
    SignalInfo { name: "fault_code", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static CHARGER_RX_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "life", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
    SignalInfo { name: "max_voltage", start: 8, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_current", start: 24, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -5000, den: 10 }, unit: "A", range: (0, 10000), start_raw: 5000, invalid_raw: Some(65535), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "enable", start: 40, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "disable"), (1, "enable")] },
];

static PEU_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "positive_contactor", start: 0, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "battery_main_contactor", start: 2, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "positive_precharge", start: 4, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "negative_precharge", start: 6, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "defrost", start: 8, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "hvac", start: 10, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "battery_heater", start: 12, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "heater", start: 14, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "accessory", start: 16, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "accessory_precharge", start: 18, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "charge_1", start: 20, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
    SignalInfo { name: "charge_2", start: 22, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_detected"), (1, "open"), (2, "closed"), (3, "fault")] },
];

/// Every message of the vehicle, in the order of the DBC: for tools.
pub static MESSAGES: &[MessageInfo] = &[
    MessageInfo { id: CanId::extended(0x0CF101A7), name: "VCU1", sender: "VCU", len: 8, cycle_ms: 20, slow_cycle_ms: 20, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0x00, 0x00], get: get_vcu1, set: set_vcu1, signals: VCU1_SIGNALS },
    MessageInfo { id: CanId::extended(0x0CF102A7), name: "VCU2", sender: "VCU", len: 8, cycle_ms: 20, slow_cycle_ms: 20, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF], get: get_vcu2, set: set_vcu2, signals: VCU2_SIGNALS },
    MessageInfo { id: CanId::extended(0x0CF103A7), name: "VCU3", sender: "VCU", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0xFF, 0x00, 0x00, 0x00], get: get_vcu3, set: set_vcu3, signals: VCU3_SIGNALS },
    MessageInfo { id: CanId::extended(0x0C3C494A), name: "VCU4", sender: "VCU", len: 8, cycle_ms: 50, slow_cycle_ms: 50, optional: false, fill: [0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00], get: get_vcu4, set: set_vcu4, signals: VCU4_SIGNALS },
    MessageInfo { id: CanId::extended(0x0C3C514A), name: "VCU5", sender: "VCU", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00], get: get_vcu5, set: set_vcu5, signals: VCU5_SIGNALS },
    MessageInfo { id: CanId::extended(0x0CF105A7), name: "VCU6", sender: "VCU", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0x00], get: get_vcu6, set: set_vcu6, signals: VCU6_SIGNALS },
    MessageInfo { id: CanId::extended(0x0CF1064A), name: "VCU7", sender: "VCU", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0xFF, 0x00, 0xFF, 0xFF, 0xFF], get: get_vcu7, set: set_vcu7, signals: VCU7_SIGNALS },
    MessageInfo { id: CanId::extended(0x0C3C4D4A), name: "VCU8", sender: "VCU", len: 8, cycle_ms: 50, slow_cycle_ms: 50, optional: false, fill: [0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00], get: get_vcu4, set: set_vcu4, signals: VCU4_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F105D0), name: "VCU9", sender: "VCU", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0xFF], get: get_vcu9, set: set_vcu9, signals: VCU9_SIGNALS },
    MessageInfo { id: CanId::extended(0x1801A9EF), name: "VCU10", sender: "VCU", len: 8, cycle_ms: 50, slow_cycle_ms: 50, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0x00], get: get_vcu10, set: set_vcu10, signals: VCU10_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F11FF0), name: "IPU1", sender: "MCU", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0x00], get: get_ipu1, set: set_ipu1, signals: IPU1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F120F0), name: "IPU2", sender: "MCU", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_ipu2, set: set_ipu2, signals: IPU2_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F121F0), name: "IPU3", sender: "MCU", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: false, fill: [0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF], get: get_ipu3, set: set_ipu3, signals: IPU3_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F13DF3), name: "BMS1", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms1, set: set_bms1, signals: BMS1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F13EF3), name: "BMS2", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF], get: get_bms2, set: set_bms2, signals: BMS2_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F140F3), name: "BMS4", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF], get: get_bms4, set: set_bms4, signals: BMS4_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F141F3), name: "BMS5", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF], get: get_bms5, set: set_bms5, signals: BMS5_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F142F3), name: "BMS6", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms6, set: set_bms6, signals: BMS6_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F143F3), name: "BMS7", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms7, set: set_bms7, signals: BMS7_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F144F3), name: "BMS8", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms8, set: set_bms8, signals: BMS8_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F145F3), name: "BMS9", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms9, set: set_bms9, signals: BMS9_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F146F3), name: "BMS10", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms10, set: set_bms10, signals: BMS10_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F147F3), name: "BMS11", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms11, set: set_bms11, signals: BMS11_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F148F3), name: "BMS12", sender: "BMS", len: 8, cycle_ms: 3000, slow_cycle_ms: 3000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF], get: get_bms12, set: set_bms12, signals: BMS12_SIGNALS },
    MessageInfo { id: CanId::extended(0x142FFF95), name: "SteeringPump", sender: "SteeringPump", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_steering_pump, set: set_steering_pump, signals: STEERING_PUMP_SIGNALS },
    MessageInfo { id: CanId::extended(0x0CF603A1), name: "LowVoltageSteering", sender: "LowVoltageSteering", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_low_voltage_steering, set: set_low_voltage_steering, signals: LOW_VOLTAGE_STEERING_SIGNALS },
    MessageInfo { id: CanId::extended(0x142CFF98), name: "DCDC", sender: "DCDC", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_dcdc, set: set_dcdc, signals: DCDC_SIGNALS },
    MessageInfo { id: CanId::extended(0x1429FF9B), name: "AirPump", sender: "AirCompressor", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_air_pump, set: set_air_pump, signals: AIR_PUMP_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F43A17), name: "Meter1", sender: "Cluster", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_meter1, set: set_meter1, signals: METER1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F54A17), name: "Meter2", sender: "Cluster", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF], get: get_meter2, set: set_meter2, signals: METER2_SIGNALS },
    MessageInfo { id: CanId::extended(0x18FFC09E), name: "HVAC", sender: "HVAC", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0x00], get: get_hvac, set: set_hvac, signals: HVAC_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F746E5), name: "Insulation", sender: "InsulationMonitor", len: 8, cycle_ms: 1000, slow_cycle_ms: 3000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_insulation, set: set_insulation, signals: INSULATION_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F1F399), name: "ChargerTx", sender: "OBC", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF], get: get_charger_tx, set: set_charger_tx, signals: CHARGER_TX_SIGNALS },
    MessageInfo { id: CanId::extended(0x18F199F3), name: "ChargerRx", sender: "BMS", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF], get: get_charger_rx, set: set_charger_rx, signals: CHARGER_RX_SIGNALS },
    MessageInfo { id: CanId::extended(0x1801EFA9), name: "PEU", sender: "ICS4in1", len: 8, cycle_ms: 100, slow_cycle_ms: 100, optional: true, fill: [0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF], get: get_peu, set: set_peu, signals: PEU_SIGNALS },
];

static RX: &[RxMessage] = &[
    RxMessage { id: CanId::extended(0x0CF101A7), name: "VCU1", node: Node::Vcu, len: 8, cycle_ms: 20, timeout_ms: 500, life: Some(Life { byte: 7, mask: 0xFF }), checksum: None, expected: true, vital: true },
    RxMessage { id: CanId::extended(0x0CF103A7), name: "VCU3", node: Node::Vcu, len: 8, cycle_ms: 100, timeout_ms: 500, life: Some(Life { byte: 7, mask: 0xFF }), checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x0CF1064A), name: "VCU7", node: Node::Vcu, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x1429FF9B), name: "AirPump", node: Node::Compressor, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: Some(Life { byte: 6, mask: 0xFF }), checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x142CFF98), name: "DCDC", node: Node::Dcdc, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: Some(Life { byte: 6, mask: 0xFF }), checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x142FFF95), name: "SteeringPump", node: Node::Steering, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: Some(Life { byte: 6, mask: 0xFF }), checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x18F11FF0), name: "IPU1", node: Node::Inverter, len: 8, cycle_ms: 100, timeout_ms: 500, life: Some(Life { byte: 7, mask: 0xF0 }), checksum: None, expected: false, vital: true },
    RxMessage { id: CanId::extended(0x18F120F0), name: "IPU2", node: Node::Inverter, len: 8, cycle_ms: 100, timeout_ms: 500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x18F121F0), name: "IPU3", node: Node::Inverter, len: 8, cycle_ms: 100, timeout_ms: 500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x18F13DF3), name: "BMS1", node: Node::Bms, len: 8, cycle_ms: 500, timeout_ms: 2500, life: None, checksum: None, expected: true, vital: true },
    RxMessage { id: CanId::extended(0x18F13EF3), name: "BMS2", node: Node::Bms, len: 8, cycle_ms: 500, timeout_ms: 2500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x18F140F3), name: "BMS4", node: Node::Bms, len: 8, cycle_ms: 500, timeout_ms: 2500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x18F141F3), name: "BMS5", node: Node::Bms, len: 8, cycle_ms: 500, timeout_ms: 2500, life: Some(Life { byte: 6, mask: 0xFF }), checksum: None, expected: true, vital: true },
    RxMessage { id: CanId::extended(0x18F142F3), name: "BMS6", node: Node::Bms, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x18F143F3), name: "BMS7", node: Node::Bms, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x18F144F3), name: "BMS8", node: Node::Bms, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x18F146F3), name: "BMS10", node: Node::Bms, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x18F148F3), name: "BMS12", node: Node::Bms, len: 8, cycle_ms: 3000, timeout_ms: 15000, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x18F746E5), name: "Insulation", node: Node::Insulation, len: 8, cycle_ms: 1000, timeout_ms: 15000, life: Some(Life { byte: 7, mask: 0xFF }), checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x18FFC09E), name: "HVAC", node: Node::Hvac, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: Some(Life { byte: 7, mask: 0xFF }), checksum: None, expected: false, vital: false },
];

static TX: &[TxMessage] = &[
    TxMessage { id: CanId::extended(0x18F43A17), name: "Meter1", cycle_ms: 1000, life: Some(Life { byte: 7, mask: 0xFF }), checksum: None },
    TxMessage { id: CanId::extended(0x18F54A17), name: "Meter2", cycle_ms: 1000, life: None, checksum: None },
];

/// Texts of the fault codes, sorted by source and code.
pub static FAULTS: &[FaultText] = &[
    FaultText { source: Node::Vcu, code: 3, severity: Some(Severity::Stop), fire: false, limps: false, zh: "单体过压", en: "Cell overvoltage" },
    FaultText { source: Node::Vcu, code: 4, severity: Some(Severity::Stop), fire: false, limps: false, zh: "单体欠压", en: "Cell undervoltage" },
    FaultText { source: Node::Vcu, code: 6, severity: Some(Severity::Stop), fire: false, limps: false, zh: "电芯高温", en: "Battery too hot" },
    FaultText { source: Node::Vcu, code: 8, severity: Some(Severity::Stop), fire: false, limps: false, zh: "温差过大", en: "Temperatures uneven" },
    FaultText { source: Node::Vcu, code: 12, severity: Some(Severity::Stop), fire: false, limps: false, zh: "回充电流超限", en: "Regen overcurrent" },
    FaultText { source: Node::Vcu, code: 13, severity: Some(Severity::Stop), fire: false, limps: false, zh: "绝缘过低", en: "Insulation low" },
    FaultText { source: Node::Vcu, code: 20, severity: Some(Severity::Stop), fire: false, limps: false, zh: "高压互锁故障", en: "HV interlock open" },
    FaultText { source: Node::Vcu, code: 23, severity: Some(Severity::Derate), fire: false, limps: false, zh: "充电座过温", en: "Charge socket hot" },
    FaultText { source: Node::Vcu, code: 24, severity: Some(Severity::Stop), fire: true, limps: false, zh: "火灾报警", en: "Battery fire" },
    FaultText { source: Node::Vcu, code: 52, severity: Some(Severity::Derate), fire: false, limps: false, zh: "单体过压", en: "Cell overvoltage" },
    FaultText { source: Node::Vcu, code: 53, severity: Some(Severity::Derate), fire: false, limps: false, zh: "单体欠压", en: "Cell undervoltage" },
    FaultText { source: Node::Vcu, code: 55, severity: Some(Severity::Derate), fire: false, limps: false, zh: "电芯高温", en: "Battery too hot" },
    FaultText { source: Node::Vcu, code: 57, severity: Some(Severity::Derate), fire: false, limps: false, zh: "温差过大", en: "Temperatures uneven" },
    FaultText { source: Node::Vcu, code: 61, severity: Some(Severity::Derate), fire: false, limps: false, zh: "回充电流超限", en: "Regen overcurrent" },
    FaultText { source: Node::Vcu, code: 62, severity: Some(Severity::Derate), fire: false, limps: false, zh: "绝缘过低", en: "Insulation low" },
    FaultText { source: Node::Vcu, code: 63, severity: Some(Severity::Derate), fire: false, limps: false, zh: "BMS内部通讯故障", en: "Battery link fault" },
    FaultText { source: Node::Vcu, code: 64, severity: Some(Severity::Derate), fire: false, limps: false, zh: "电流传感器故障", en: "Current sensor fault" },
    FaultText { source: Node::Vcu, code: 70, severity: Some(Severity::Derate), fire: false, limps: true, zh: "与整车控制器通讯故障", en: "Battery-VCU link fault" },
    FaultText { source: Node::Vcu, code: 72, severity: Some(Severity::Derate), fire: false, limps: false, zh: "主正接触器故障", en: "Main contactor fault" },
    FaultText { source: Node::Vcu, code: 74, severity: Some(Severity::Warn), fire: false, limps: false, zh: "充电座过温", en: "Charge socket hot" },
    FaultText { source: Node::Vcu, code: 100, severity: Some(Severity::Warn), fire: false, limps: false, zh: "总电压过压", en: "Pack overvoltage" },
    FaultText { source: Node::Vcu, code: 101, severity: Some(Severity::Warn), fire: false, limps: false, zh: "总电压欠压", en: "Pack undervoltage" },
    FaultText { source: Node::Vcu, code: 102, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体过压", en: "Cell overvoltage" },
    FaultText { source: Node::Vcu, code: 103, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体欠压", en: "Cell undervoltage" },
    FaultText { source: Node::Vcu, code: 104, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体压差过大", en: "Cell voltages uneven" },
    FaultText { source: Node::Vcu, code: 105, severity: Some(Severity::Warn), fire: false, limps: false, zh: "电芯高温", en: "Battery too hot" },
    FaultText { source: Node::Vcu, code: 106, severity: Some(Severity::Warn), fire: false, limps: false, zh: "电芯低温", en: "Battery too cold" },
    FaultText { source: Node::Vcu, code: 107, severity: Some(Severity::Warn), fire: false, limps: false, zh: "温差过大", en: "Temperatures uneven" },
    FaultText { source: Node::Vcu, code: 108, severity: Some(Severity::Warn), fire: false, limps: false, zh: "电池SOC过低", en: "Charge low" },
    FaultText { source: Node::Vcu, code: 110, severity: Some(Severity::Warn), fire: false, limps: false, zh: "放电电流超限", en: "Discharge overcurrent" },
    FaultText { source: Node::Vcu, code: 111, severity: Some(Severity::Warn), fire: false, limps: false, zh: "回充电流超限", en: "Regen overcurrent" },
    FaultText { source: Node::Vcu, code: 112, severity: Some(Severity::Warn), fire: false, limps: false, zh: "绝缘过低", en: "Insulation low" },
    FaultText { source: Node::Bms, code: 3, severity: Some(Severity::Stop), fire: false, limps: false, zh: "单体过压", en: "Cell overvoltage" },
    FaultText { source: Node::Bms, code: 4, severity: Some(Severity::Stop), fire: false, limps: false, zh: "单体欠压", en: "Cell undervoltage" },
    FaultText { source: Node::Bms, code: 6, severity: Some(Severity::Stop), fire: false, limps: false, zh: "电芯高温", en: "Battery too hot" },
    FaultText { source: Node::Bms, code: 8, severity: Some(Severity::Stop), fire: false, limps: false, zh: "温差过大", en: "Temperatures uneven" },
    FaultText { source: Node::Bms, code: 12, severity: Some(Severity::Stop), fire: false, limps: false, zh: "回充电流超限", en: "Regen overcurrent" },
    FaultText { source: Node::Bms, code: 13, severity: Some(Severity::Stop), fire: false, limps: false, zh: "绝缘过低", en: "Insulation low" },
    FaultText { source: Node::Bms, code: 20, severity: Some(Severity::Stop), fire: false, limps: false, zh: "高压互锁故障", en: "HV interlock open" },
    FaultText { source: Node::Bms, code: 23, severity: Some(Severity::Derate), fire: false, limps: false, zh: "充电座过温", en: "Charge socket hot" },
    FaultText { source: Node::Bms, code: 24, severity: Some(Severity::Stop), fire: true, limps: false, zh: "火灾报警", en: "Battery fire" },
    FaultText { source: Node::Bms, code: 52, severity: Some(Severity::Derate), fire: false, limps: false, zh: "单体过压", en: "Cell overvoltage" },
    FaultText { source: Node::Bms, code: 53, severity: Some(Severity::Derate), fire: false, limps: false, zh: "单体欠压", en: "Cell undervoltage" },
    FaultText { source: Node::Bms, code: 55, severity: Some(Severity::Derate), fire: false, limps: false, zh: "电芯高温", en: "Battery too hot" },
    FaultText { source: Node::Bms, code: 57, severity: Some(Severity::Derate), fire: false, limps: false, zh: "温差过大", en: "Temperatures uneven" },
    FaultText { source: Node::Bms, code: 61, severity: Some(Severity::Derate), fire: false, limps: false, zh: "回充电流超限", en: "Regen overcurrent" },
    FaultText { source: Node::Bms, code: 62, severity: Some(Severity::Derate), fire: false, limps: false, zh: "绝缘过低", en: "Insulation low" },
    FaultText { source: Node::Bms, code: 63, severity: Some(Severity::Derate), fire: false, limps: false, zh: "BMS内部通讯故障", en: "Battery link fault" },
    FaultText { source: Node::Bms, code: 64, severity: Some(Severity::Derate), fire: false, limps: false, zh: "电流传感器故障", en: "Current sensor fault" },
    FaultText { source: Node::Bms, code: 70, severity: Some(Severity::Derate), fire: false, limps: true, zh: "与整车控制器通讯故障", en: "Battery-VCU link fault" },
    FaultText { source: Node::Bms, code: 72, severity: Some(Severity::Derate), fire: false, limps: false, zh: "主正接触器故障", en: "Main contactor fault" },
    FaultText { source: Node::Bms, code: 74, severity: Some(Severity::Warn), fire: false, limps: false, zh: "充电座过温", en: "Charge socket hot" },
    FaultText { source: Node::Bms, code: 100, severity: Some(Severity::Warn), fire: false, limps: false, zh: "总电压过压", en: "Pack overvoltage" },
    FaultText { source: Node::Bms, code: 101, severity: Some(Severity::Warn), fire: false, limps: false, zh: "总电压欠压", en: "Pack undervoltage" },
    FaultText { source: Node::Bms, code: 102, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体过压", en: "Cell overvoltage" },
    FaultText { source: Node::Bms, code: 103, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体欠压", en: "Cell undervoltage" },
    FaultText { source: Node::Bms, code: 104, severity: Some(Severity::Warn), fire: false, limps: false, zh: "单体压差过大", en: "Cell voltages uneven" },
    FaultText { source: Node::Bms, code: 105, severity: Some(Severity::Warn), fire: false, limps: false, zh: "电芯高温", en: "Battery too hot" },
    FaultText { source: Node::Bms, code: 106, severity: Some(Severity::Warn), fire: false, limps: false, zh: "电芯低温", en: "Battery too cold" },
    FaultText { source: Node::Bms, code: 107, severity: Some(Severity::Warn), fire: false, limps: false, zh: "温差过大", en: "Temperatures uneven" },
    FaultText { source: Node::Bms, code: 108, severity: Some(Severity::Warn), fire: false, limps: false, zh: "电池SOC过低", en: "Charge low" },
    FaultText { source: Node::Bms, code: 110, severity: Some(Severity::Warn), fire: false, limps: false, zh: "放电电流超限", en: "Discharge overcurrent" },
    FaultText { source: Node::Bms, code: 111, severity: Some(Severity::Warn), fire: false, limps: false, zh: "回充电流超限", en: "Regen overcurrent" },
    FaultText { source: Node::Bms, code: 112, severity: Some(Severity::Warn), fire: false, limps: false, zh: "绝缘过低", en: "Insulation low" },
    FaultText { source: Node::Dcdc, code: 1, severity: None, fire: false, limps: false, zh: "硬件故障", en: "Hardware fault" },
    FaultText { source: Node::Dcdc, code: 2, severity: None, fire: false, limps: false, zh: "输出短路", en: "Output short" },
    FaultText { source: Node::Dcdc, code: 3, severity: None, fire: false, limps: false, zh: "输入欠压", en: "Input undervoltage" },
    FaultText { source: Node::Dcdc, code: 4, severity: None, fire: false, limps: false, zh: "输入过压", en: "Input overvoltage" },
    FaultText { source: Node::Dcdc, code: 5, severity: None, fire: false, limps: false, zh: "输出欠压", en: "Output undervoltage" },
    FaultText { source: Node::Dcdc, code: 6, severity: None, fire: false, limps: false, zh: "输出过压", en: "Output overvoltage" },
    FaultText { source: Node::Dcdc, code: 7, severity: None, fire: false, limps: false, zh: "输出过流", en: "Output overcurrent" },
    FaultText { source: Node::Dcdc, code: 8, severity: None, fire: false, limps: false, zh: "温度故障", en: "Too hot" },
    FaultText { source: Node::Steering, code: 1, severity: None, fire: false, limps: false, zh: "输入过流", en: "Input overcurrent" },
    FaultText { source: Node::Steering, code: 2, severity: None, fire: false, limps: false, zh: "输入过压", en: "Input overvoltage" },
    FaultText { source: Node::Steering, code: 3, severity: None, fire: false, limps: false, zh: "输入欠压", en: "Input undervoltage" },
    FaultText { source: Node::Steering, code: 4, severity: None, fire: false, limps: false, zh: "过载保护", en: "Overload" },
    FaultText { source: Node::Steering, code: 5, severity: None, fire: false, limps: false, zh: "输入输出断线", en: "Open circuit" },
    FaultText { source: Node::Steering, code: 6, severity: None, fire: false, limps: false, zh: "输入输出短路", en: "Short circuit" },
    FaultText { source: Node::Steering, code: 7, severity: None, fire: false, limps: false, zh: "输出缺相", en: "Phase loss" },
    FaultText { source: Node::Steering, code: 8, severity: None, fire: false, limps: false, zh: "控制器过温", en: "Controller hot" },
    FaultText { source: Node::Steering, code: 9, severity: None, fire: false, limps: false, zh: "电机超速", en: "Overspeed" },
    FaultText { source: Node::Compressor, code: 1, severity: None, fire: false, limps: false, zh: "输入过流", en: "Input overcurrent" },
    FaultText { source: Node::Compressor, code: 2, severity: None, fire: false, limps: false, zh: "输入过压", en: "Input overvoltage" },
    FaultText { source: Node::Compressor, code: 3, severity: None, fire: false, limps: false, zh: "输入欠压", en: "Input undervoltage" },
    FaultText { source: Node::Compressor, code: 4, severity: None, fire: false, limps: false, zh: "过载保护", en: "Overload" },
    FaultText { source: Node::Compressor, code: 5, severity: None, fire: false, limps: false, zh: "输入输出断线", en: "Open circuit" },
    FaultText { source: Node::Compressor, code: 6, severity: None, fire: false, limps: false, zh: "输入输出短路", en: "Short circuit" },
    FaultText { source: Node::Compressor, code: 7, severity: None, fire: false, limps: false, zh: "输出缺相", en: "Phase loss" },
    FaultText { source: Node::Compressor, code: 8, severity: None, fire: false, limps: false, zh: "控制器过温", en: "Controller hot" },
    FaultText { source: Node::Compressor, code: 9, severity: None, fire: false, limps: false, zh: "电机超速", en: "Overspeed" },
    FaultText { source: Node::Compressor, code: 10, severity: None, fire: false, limps: false, zh: "空压机高温", en: "Compressor hot" },
];

static NODES: &[NodeName] = &[
    NodeName { node: Node::Vcu, zh: "整车控制器", en: "Vehicle controller" },
    NodeName { node: Node::Inverter, zh: "电机控制器", en: "Motor controller" },
    NodeName { node: Node::Bms, zh: "电池系统", en: "Battery" },
    NodeName { node: Node::Dcdc, zh: "DCDC", en: "DC/DC converter" },
    NodeName { node: Node::Steering, zh: "助力", en: "Steering" },
    NodeName { node: Node::Compressor, zh: "空压机", en: "Air compressor" },
    NodeName { node: Node::Hvac, zh: "空调", en: "Air conditioning" },
    NodeName { node: Node::Insulation, zh: "绝缘检测仪", en: "Insulation monitor" },
    NodeName { node: Node::Charger, zh: "充电机", en: "Charger" },
    NodeName { node: Node::Contactors, zh: "四合一", en: "Contactor box" },
    NodeName { node: Node::Cluster, zh: "仪表", en: "Cluster" },
];

static STREAMS: &[Stream] = &[
];

static IDS: &[CanId] = &[
    CanId::extended(0x0C3C494A),
    CanId::extended(0x0C3C4D4A),
    CanId::extended(0x0C3C514A),
    CanId::extended(0x0CF101A7),
    CanId::extended(0x0CF102A7),
    CanId::extended(0x0CF103A7),
    CanId::extended(0x0CF105A7),
    CanId::extended(0x0CF1064A),
    CanId::extended(0x0CF603A1),
    CanId::extended(0x1429FF9B),
    CanId::extended(0x142CFF98),
    CanId::extended(0x142FFF95),
    CanId::extended(0x1801A9EF),
    CanId::extended(0x1801EFA9),
    CanId::extended(0x18F105D0),
    CanId::extended(0x18F11FF0),
    CanId::extended(0x18F120F0),
    CanId::extended(0x18F121F0),
    CanId::extended(0x18F13DF3),
    CanId::extended(0x18F13EF3),
    CanId::extended(0x18F140F3),
    CanId::extended(0x18F141F3),
    CanId::extended(0x18F142F3),
    CanId::extended(0x18F143F3),
    CanId::extended(0x18F144F3),
    CanId::extended(0x18F145F3),
    CanId::extended(0x18F146F3),
    CanId::extended(0x18F147F3),
    CanId::extended(0x18F148F3),
    CanId::extended(0x18F199F3),
    CanId::extended(0x18F1F399),
    CanId::extended(0x18F746E5),
    CanId::extended(0x18FFC09E),
];

fn decode_vcu1(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Vcu1(*data);
    let raw = frame.vehicle_speed_raw();
    readings.put(source, Value::VehicleSpeed, raw as i32, raw <= 51200);
    if matches!(frame.0[0], 0xFF | 0xFE) {
        readings.put(source, Value::VehicleGear, 0, false);
    } else {
        let state = STATES_0[(frame.gear_raw() & 15) as usize];
        readings.put(source, Value::VehicleGear, state, state != INVALID);
    }
    if matches!(frame.0[0], 0xFF | 0xFE) {
        readings.put(source, Value::VehicleMode, 0, false);
    } else {
        let state = STATES_1[(frame.drive_mode_raw() & 3) as usize];
        readings.put(source, Value::VehicleMode, state, state != INVALID);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::VehicleReady, 0, false);
    } else {
        let raw = frame.ready_raw();
        readings.put(source, Value::VehicleReady, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::VehicleFault, 0, false);
    } else {
        let raw = frame.system_fault_raw();
        readings.put(source, Value::VehicleFault, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::VehiclePowerLimited, 0, false);
    } else {
        let raw = frame.power_limited_raw();
        readings.put(source, Value::VehiclePowerLimited, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::VehicleTorqueLimited, 0, false);
    } else {
        let raw = frame.torque_limited_raw();
        readings.put(source, Value::VehicleTorqueLimited, raw as i32, true);
    }
    let raw = frame.accelerator_pedal_raw();
    readings.put(source, Value::VehicleAccelerator, (raw as i32) * 4, raw <= 250);
    let raw = frame.brake_pedal_raw();
    readings.put(source, Value::VehicleBrake, (raw as i32) * 4, raw <= 250);
    if matches!(frame.0[0], 0xFF | 0xFE) {
        readings.put(source, Value::VehicleFootBrake, 0, false);
    } else {
        let raw = frame.foot_brake_raw();
        readings.put(source, Value::VehicleFootBrake, raw as i32, true);
    }
    if matches!(frame.0[0], 0xFF | 0xFE) {
        readings.put(source, Value::VehicleParkingBrake, 0, false);
    } else {
        let raw = frame.handbrake_raw();
        readings.put(source, Value::VehicleParkingBrake, raw as i32, true);
    }
}

fn decode_vcu3(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Vcu3(*data);
    if matches!(frame.0[1], 0xFF | 0xFE) {
        readings.put(source, Value::VehicleHvCommand, 0, false);
    } else {
        let raw = frame.hv_command_raw();
        readings.put(source, Value::VehicleHvCommand, raw as i32, raw <= 1);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::RelayCutoff, 0, false);
    } else {
        let raw = frame.hv_cutoff_raw();
        readings.put(source, Value::RelayCutoff, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::RelayPrecharge, 0, false);
    } else {
        let raw = frame.precharge_relay_raw();
        readings.put(source, Value::RelayPrecharge, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::RelayMotor, 0, false);
    } else {
        let raw = frame.motor_relay_raw();
        readings.put(source, Value::RelayMotor, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::RelayAccessory, 0, false);
    } else {
        let raw = frame.accessory_relay_raw();
        readings.put(source, Value::RelayAccessory, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::RelayAccessoryPrecharge, 0, false);
    } else {
        let raw = frame.accessory_precharge_relay_raw();
        readings.put(source, Value::RelayAccessoryPrecharge, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::RelayDefrost, 0, false);
    } else {
        let raw = frame.defrost_relay_raw();
        readings.put(source, Value::RelayDefrost, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::RelayCharge, 0, false);
    } else {
        let raw = frame.charge_relay_raw();
        readings.put(source, Value::RelayCharge, raw as i32, true);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::RelayBattery, 0, false);
    } else {
        let raw = frame.battery_relay_raw();
        readings.put(source, Value::RelayBattery, raw as i32, true);
    }
}

fn decode_vcu7(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Vcu7(*data);
    if matches!(frame.0[0], 0xFF | 0xFE) {
        readings.put(source, Value::VehicleFaultLevel, 0, false);
    } else {
        let raw = frame.fault_level_raw();
        readings.put(source, Value::VehicleFaultLevel, raw as i32, raw <= 3);
    }
    let raw = frame.dtc_raw();
    readings.put(source, Value::VehicleFaultCode, raw as i32, raw != 65535);
    if matches!(frame.0[4], 0xFF | 0xFE) {
        readings.put(source, Value::CompressorHot, 0, false);
    } else {
        let raw = frame.compressor_over_temperature_raw();
        readings.put(source, Value::CompressorHot, raw as i32, true);
    }
    if matches!(frame.0[4], 0xFF | 0xFE) {
        readings.put(source, Value::CompressorDryerSwitch, 0, false);
    } else {
        let raw = frame.dryer_pressure_switch_raw();
        readings.put(source, Value::CompressorDryerSwitch, raw as i32, true);
    }
}

fn decode_air_pump(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = AirPump(*data);
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::CompressorState, 0, false);
    } else {
        let raw = frame.status_raw();
        readings.put(source, Value::CompressorState, raw as i32, raw <= 2);
    }
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::CompressorFaultCode, 0, false);
    } else {
        let raw = frame.fault_code_raw();
        readings.put(source, Value::CompressorFaultCode, raw as i32, true);
    }
    let raw = frame.motor_speed_raw();
    readings.put(source, Value::CompressorSpeed, (raw as i32) >> 3, raw <= 40000);
    let raw = frame.controller_temperature_raw();
    readings.put(source, Value::CompressorTemperature, raw as i32 - 40, raw <= 250);
}

fn decode_dcdc(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Dcdc(*data);
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::DcdcState, 0, false);
    } else {
        let raw = frame.status_raw();
        readings.put(source, Value::DcdcState, raw as i32, raw <= 2);
    }
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::DcdcFaultCode, 0, false);
    } else {
        let raw = frame.fault_code_raw();
        readings.put(source, Value::DcdcFaultCode, raw as i32, true);
    }
    let raw = frame.output_voltage_raw();
    readings.put(source, Value::DcdcOutput, (raw as i32) * 10, raw <= 254);
    let raw = frame.controller_temperature_raw();
    readings.put(source, Value::DcdcTemperature, raw as i32 - 40, raw <= 250);
    let raw = frame.input_voltage_raw();
    readings.put(source, Value::DcdcInput, raw as i32, raw <= 10000);
    let raw = frame.output_current_raw();
    readings.put(source, Value::DcdcCurrent, (raw as i32) * 10, raw <= 254);
}

fn decode_steering_pump(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = SteeringPump(*data);
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::SteeringState, 0, false);
    } else {
        let raw = frame.status_raw();
        readings.put(source, Value::SteeringState, raw as i32, raw <= 2);
    }
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::SteeringFaultCode, 0, false);
    } else {
        let raw = frame.fault_code_raw();
        readings.put(source, Value::SteeringFaultCode, raw as i32, true);
    }
    let raw = frame.motor_speed_raw();
    readings.put(source, Value::SteeringSpeed, (raw as i32) >> 3, raw <= 40000);
    let raw = frame.controller_temperature_raw();
    readings.put(source, Value::SteeringTemperature, raw as i32 - 40, raw <= 250);
}

fn decode_ipu1(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Ipu1(*data);
    let raw = frame.bus_voltage_raw();
    readings.put(source, Value::InverterVoltage, raw as i32, raw <= 10000);
    let raw = frame.bus_current_raw();
    readings.put(source, Value::InverterCurrent, raw as i32 - 10000, raw <= 20000);
}

fn decode_ipu2(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Ipu2(*data);
    let raw = frame.motor_speed_raw();
    readings.put(source, Value::MotorSpeed, raw as i32 - 12000, raw <= 24000);
    let raw = frame.motor_torque_raw();
    readings.put(source, Value::MotorTorque, raw as i32 - 30000, raw <= 60000);
    let raw = frame.motor_temperature_raw();
    readings.put(source, Value::MotorTemperature, raw as i32 - 40, raw <= 250);
    let raw = frame.controller_temperature_raw();
    readings.put(source, Value::InverterTemperature, raw as i32 - 40, raw <= 250);
}

fn decode_ipu3(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Ipu3(*data);
    if matches!(frame.0[0], 0xFF | 0xFE) {
        readings.put(source, Value::MotorFault, 0, false);
    } else {
        let state = match frame.status_raw() { 0 => 0, 2 => 0, 5 => 1, _ => 0 };
        readings.put(source, Value::MotorFault, state, state != INVALID);
    }
    let raw = frame.fault_code_raw();
    readings.put(source, Value::MotorFaultCode, raw as i32, raw != 255);
    if matches!(frame.0[0], 0xFF | 0xFE) {
        readings.put(source, Value::MotorState, 0, false);
    } else {
        let state = match frame.status_raw() { 0 => 0, 2 => 1, 5 => 2, _ => INVALID };
        readings.put(source, Value::MotorState, state, state != INVALID);
    }
}

fn decode_bms1(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bms1(*data);
    let raw = frame.pack_voltage_raw();
    readings.put(source, Value::BatteryVoltage, raw as i32, raw <= 10000);
    let raw = frame.pack_current_raw();
    readings.put(source, Value::BatteryCurrent, raw as i32 - 10000, raw <= 20000);
    let raw = frame.soc_raw();
    readings.put(source, Value::BatterySoc, (raw as i32) * 4, raw <= 250);
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::BatteryState, 0, false);
    } else {
        let raw = frame.check_state_raw();
        readings.put(source, Value::BatteryState, raw as i32, raw <= 4);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::BatteryHvOffRequest, 0, false);
    } else {
        let state = STATES_2[(frame.hv_open_request_raw() & 3) as usize];
        readings.put(source, Value::BatteryHvOffRequest, state, state != INVALID);
    }
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::BatteryFaultLevel, 0, false);
    } else {
        let state = STATES_3[(frame.fault_level_raw() & 7) as usize];
        readings.put(source, Value::BatteryFaultLevel, state, state != INVALID);
    }
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::ContactorMain, 0, false);
    } else {
        let state = STATES_4[(frame.main_relay_raw() & 3) as usize];
        readings.put(source, Value::ContactorMain, state, state != INVALID);
    }
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::ContactorCharge1, 0, false);
    } else {
        let state = STATES_4[(frame.charge_1_relay_raw() & 3) as usize];
        readings.put(source, Value::ContactorCharge1, state, state != INVALID);
    }
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::ContactorCharge2, 0, false);
    } else {
        let state = STATES_4[(frame.charge_2_relay_raw() & 3) as usize];
        readings.put(source, Value::ContactorCharge2, state, state != INVALID);
    }
    if matches!(frame.0[7], 0xFF | 0xFE) {
        readings.put(source, Value::ContactorHeater, 0, false);
    } else {
        let state = STATES_4[(frame.heater_relay_raw() & 3) as usize];
        readings.put(source, Value::ContactorHeater, state, state != INVALID);
    }
}

fn decode_bms2(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bms2(*data);
    let raw = frame.max_cell_voltage_raw();
    readings.put(source, Value::BatteryCellMax, (raw as i32) * 10, raw <= 65534);
    let raw = frame.min_cell_voltage_raw();
    readings.put(source, Value::BatteryCellMin, (raw as i32) * 10, raw <= 65534);
    let raw = frame.max_cell_temperature_raw();
    readings.put(source, Value::BatteryTemperatureMax, raw as i32 - 40, raw <= 250);
    let raw = frame.min_cell_temperature_raw();
    readings.put(source, Value::BatteryTemperatureMin, raw as i32 - 40, raw <= 250);
}

fn decode_bms4(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bms4(*data);
    let raw = frame.max_charge_current_raw();
    readings.put(source, Value::BatteryChargeLimit, (raw as i32 - 10000).abs(), raw <= 20000);
    let raw = frame.max_discharge_current_raw();
    readings.put(source, Value::BatteryDischargeLimit, raw as i32 - 10000, raw <= 20000);
    let raw = frame.max_temperature_raw();
    readings.put(source, Value::BatteryTemperatureUpper, raw as i32 - 40, raw <= 250);
    let raw = frame.min_temperature_raw();
    readings.put(source, Value::BatteryTemperatureLower, raw as i32 - 40, raw <= 250);
    let raw = frame.min_soc_raw();
    readings.put(source, Value::BatterySocLower, (raw as i32) * 4, raw <= 250);
}

fn decode_bms5(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bms5(*data);
    let raw = frame.fault_code_raw();
    readings.put(source, Value::BatteryFaultCode, raw as i32, raw != 255);
    if matches!(frame.0[3], 0xFF | 0xFE) {
        readings.put(source, Value::BatteryBalancing, 0, false);
    } else {
        let raw = frame.balancing_raw();
        readings.put(source, Value::BatteryBalancing, raw as i32, true);
    }
    if matches!(frame.0[2], 0xFF | 0xFE) {
        readings.put(source, Value::ChargeState, 0, false);
    } else {
        let raw = frame.charge_state_raw();
        readings.put(source, Value::ChargeState, raw as i32, raw <= 3);
    }
    if matches!(frame.0[4], 0xFF | 0xFE) {
        readings.put(source, Value::ChargePlug, 0, false);
    } else {
        let state = match frame.plug_state_raw() { 85 => 1, 170 => 0, _ => INVALID };
        readings.put(source, Value::ChargePlug, state, state != INVALID);
    }
    let raw = frame.charge_interval_raw();
    readings.put(source, Value::ChargeInterval, raw as i32, raw <= 254);
}

fn decode_bms6(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bms6(*data);
    let raw = frame.min_temperature_1_box_raw();
    readings.put(source, Value::BatteryTemperatureMinBox, raw as i32, raw >= 1 && raw <= 100);
}

fn decode_bms7(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bms7(*data);
    let raw = frame.max_temperature_1_box_raw();
    readings.put(source, Value::BatteryTemperatureMaxBox, raw as i32, raw >= 1 && raw <= 100);
}

fn decode_bms8(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bms8(*data);
    let raw = frame.min_voltage_1_box_raw();
    readings.put(source, Value::BatteryCellMinBox, raw as i32, raw >= 1 && raw <= 254);
    let raw = frame.min_voltage_1_cell_raw();
    readings.put(source, Value::BatteryCellMinCell, raw as i32, raw >= 1 && raw <= 254);
}

fn decode_bms10(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bms10(*data);
    let raw = frame.max_voltage_1_box_raw();
    readings.put(source, Value::BatteryCellMaxBox, raw as i32, raw >= 1 && raw <= 254);
    let raw = frame.max_voltage_1_cell_raw();
    readings.put(source, Value::BatteryCellMaxCell, raw as i32, raw >= 1 && raw <= 254);
}

fn decode_bms12(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Bms12(*data);
    let raw = frame.rated_capacity_raw();
    readings.put(source, Value::BatteryCapacity, raw as i32, raw <= 1000);
    let raw = frame.rated_voltage_raw();
    readings.put(source, Value::BatteryRatedVoltage, (raw as i32) * 10, raw <= 1000);
}

fn decode_insulation(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Insulation(*data);
    let worst = if matches!(frame.0[0], 0xFF | 0xFE) { INVALID } else { STATES_5[(frame.leakage_level_raw() & 7) as usize] };
    let worst = i32::max(worst, if matches!(frame.0[6], 0xFF | 0xFE) { INVALID } else { STATES_6[(frame.level_1_alarm_raw() & 1) as usize] });
    let worst = i32::max(worst, if matches!(frame.0[6], 0xFF | 0xFE) { INVALID } else { STATES_7[(frame.level_2_alarm_raw() & 1) as usize] });
    readings.put(source, Value::InsulationLevel, worst, worst > 0 || worst != INVALID && !(matches!(frame.0[0], 0xFF | 0xFE) || matches!(frame.0[6], 0xFF | 0xFE)));
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::InsulationFault, 0, false);
    } else {
        let set = frame.0[6] & 0x0C != 0;
        readings.put(source, Value::InsulationFault, set as i32, true);
    }
    let raw = frame.positive_resistance_raw();
    readings.put(source, Value::InsulationPositive, raw as i32, raw <= 65534);
    let raw = frame.negative_resistance_raw();
    readings.put(source, Value::InsulationNegative, raw as i32, raw <= 65534);
    let raw = frame.fault_code_raw();
    readings.put(source, Value::InsulationFaultCode, raw as i32, raw != 255);
    if matches!(frame.0[6], 0xFF | 0xFE) {
        readings.put(source, Value::InsulationDeviceFault, 0, false);
    } else {
        let set = frame.0[6] & 0x30 != 0;
        readings.put(source, Value::InsulationDeviceFault, set as i32, true);
    }
}

fn decode_hvac(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Hvac(*data);
    if matches!(frame.0[1], 0xFF | 0xFE) {
        readings.put(source, Value::HvacOn, 0, false);
    } else {
        let raw = frame.fan_low_raw();
        readings.put(source, Value::HvacOn, raw as i32, true);
    }
    if matches!(frame.0[2], 0xFF | 0xFE) {
        readings.put(source, Value::HvacCooling, 0, false);
    } else {
        let set = frame.0[2] & 0xA0 != 0;
        readings.put(source, Value::HvacCooling, set as i32, true);
    }
    if matches!(frame.0[2], 0xFF | 0xFE) {
        readings.put(source, Value::HvacHeating, 0, false);
    } else {
        let raw = frame.heating_raw();
        readings.put(source, Value::HvacHeating, raw as i32, true);
    }
    if matches!(frame.0[2], 0xFF | 0xFE) {
        readings.put(source, Value::HvacDefrosting, 0, false);
    } else {
        let set = frame.0[2] & 0x12 != 0;
        readings.put(source, Value::HvacDefrosting, set as i32, true);
    }
    if matches!(frame.0[1], 0xFF | 0xFE) {
        readings.put(source, Value::HvacFan, 0, false);
    } else {
        let worst = STATES_6[(frame.fan_mid_raw() & 1) as usize];
        let worst = i32::max(worst, STATES_8[(frame.fan_high_raw() & 1) as usize]);
        readings.put(source, Value::HvacFan, worst, worst != INVALID);
    }
    if matches!(frame.0[2], 0xFF | 0xFE) {
        readings.put(source, Value::HvacFreshAir, 0, false);
    } else {
        let raw = frame.fresh_air_raw();
        readings.put(source, Value::HvacFreshAir, raw as i32, true);
    }
    if matches!(frame.0[2], 0xFF | 0xFE) {
        readings.put(source, Value::HvacSterilising, 0, false);
    } else {
        let raw = frame.sterilise_raw();
        readings.put(source, Value::HvacSterilising, raw as i32, true);
    }
    if matches!(frame.0[0], 0xFF | 0xFE) {
        readings.put(source, Value::HvacFault, 0, false);
    } else {
        let set = frame.0[0] != 0;
        readings.put(source, Value::HvacFault, set as i32, true);
    }
    let raw = frame.cabin_temperature_raw();
    readings.put(source, Value::HvacInside, raw as i32 - 40, raw <= 250);
    let raw = frame.outside_temperature_raw();
    readings.put(source, Value::HvacOutside, raw as i32 - 40, raw <= 250);
}

static STATES_0: [i32; 16] = [INVALID, 1, 2, 11, 3, 12, 13, INVALID, 4, 14, 15, 16, INVALID, INVALID, INVALID, INVALID];

static STATES_1: [i32; 4] = [1, 4, 3, 2];

static STATES_2: [i32; 4] = [INVALID, INVALID, 0, 1];

static STATES_3: [i32; 8] = [0, 3, 2, 1, INVALID, INVALID, INVALID, INVALID];

static STATES_4: [i32; 4] = [0, 1, INVALID, 2];

static STATES_5: [i32; 8] = [0, 1, 3, INVALID, INVALID, INVALID, INVALID, INVALID];

static STATES_6: [i32; 2] = [0, 1];

static STATES_7: [i32; 2] = [0, 3];

static STATES_8: [i32; 2] = [0, 2];

static DECODERS: [fn(u8, &[u8; 8], &mut Readings); 20] = [
    decode_vcu1,
    decode_vcu3,
    decode_vcu7,
    decode_air_pump,
    decode_dcdc,
    decode_steering_pump,
    decode_ipu1,
    decode_ipu2,
    decode_ipu3,
    decode_bms1,
    decode_bms2,
    decode_bms4,
    decode_bms5,
    decode_bms6,
    decode_bms7,
    decode_bms8,
    decode_bms10,
    decode_bms12,
    decode_insulation,
    decode_hvac,
];

fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    if let Some(decode) = DECODERS.get(index as usize) {
        decode(index, data, readings);
    }
}

fn encode_meter1(values: &Readings) -> [u8; 8] {
    let frame = Meter1::new();
    let frame = frame.with_aux_battery_voltage_raw(codec::known(values, Value::SupplyVoltage).map_or(255, |number| codec::scaled(number, 1, 1, 2, 0, 254) as u8));
    let frame = frame.with_exit_door_raw(codec::known(values, Value::BodyDoorRear).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_middle_door_raw(codec::known(values, Value::BodyDoorMiddle).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_entry_door_raw(codec::known(values, Value::BodyDoorFront).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_rear_hatch_raw(codec::known(values, Value::BodyDoorHatch).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_handbrake_raw(codec::known(values, Value::BodyParkingBrake).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_smoke_alarm_raw(codec::known(values, Value::BodySmoke).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_key_position_raw(match codec::known(values, Value::BodyKey) { Some(0) => 0, Some(1) => 2, Some(2) => 1, Some(3) => 3, _ => 1 });
    let frame = frame.with_front_air_pressure_raw(codec::known(values, Value::AirFront).map_or(255, |number| codec::scaled(number, 1, 0, 1, 0, 254) as u8));
    let frame = frame.with_rear_air_pressure_raw(codec::known(values, Value::AirRear).map_or(255, |number| codec::scaled(number, 1, 0, 1, 0, 254) as u8));
    let frame = frame.with_low_beam_raw(codec::known(values, Value::BodyLowBeam).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_high_beam_raw(codec::known(values, Value::BodyHighBeam).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_brake_lamp_raw(codec::known(values, Value::BodyBrakeLamp).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_right_turn_raw(codec::known(values, Value::BodyTurnRight).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_left_turn_raw(codec::known(values, Value::BodyTurnLeft).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_hazard_raw(codec::known(values, Value::BodyHazard).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_front_fog_raw(codec::known(values, Value::BodyFrontFog).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_rear_fog_raw(codec::known(values, Value::BodyRearFog).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_side_lamp_raw(codec::known(values, Value::BodySideLamp).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_horn_raw(codec::known(values, Value::BodyHorn).map_or(0, |state| (state != 0) as u8));
    let frame = frame.with_driver_left_seat_raw(codec::known(values, Value::ClusterDriverLeft).map_or(255, |state| (state != 0) as u8));
    frame.0
}

fn encode_meter2(values: &Readings) -> [u8; 8] {
    let frame = Meter2::new();
    let frame = frame.with_odometer_raw(codec::known(values, Value::ClusterOdometer).map_or(4294967295, |number| codec::scaled(number, 1, 0, 1, 0, 4294967294) as u32));
    frame.0
}

fn encode(index: u8, values: &Readings) -> [u8; 8] {
    match index {
        0 => encode_meter1(values),
        1 => encode_meter2(values),
        _ => [0; 8],
    }
}

/// Electric bus (纯电动客车).
pub static VEHICLE: Vehicle = Vehicle {
    name: "citybus",
    zh: "纯电动客车",
    en: "Electric bus",
    bitrate: 250000,
    worst_level: 3,
    rules: Rules { hv_off: Some(HvOffRule { vehicle_ms: 5000, battery_ms: 35000 }), limp: Some(LimpRule { silence_ms: 5000, most_deciamps: 600, deciamps_per_ah: 3 }), charger_loss_ms: None, hvac_loss_ms: Some(10000), buzzer_ms: None },
    rx: RX,
    decode,
    streams: STREAMS,
    ids: IDS,
    tx: TX,
    encode,
    faults: FAULTS,
    nodes: NODES,
};
