//! Vehicle `jiulong`: Jiulong electric bus (九龙纯电动客车).
//!
//! Generated from `vehicles/jiulong/jiulong.dbc` and `vehicles/jiulong/vehicle.toml`; refresh with `cargo xtask codegen`.

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
    pub const VCU1: CanId = CanId::extended(0x180228D0);
    /// VCU2.
    pub const VCU2: CanId = CanId::extended(0x180328D0);
    /// VCU3.
    pub const VCU3: CanId = CanId::extended(0x180428D0);
    /// VCU4.
    pub const VCU4: CanId = CanId::extended(0x180528D0);
    /// VCU5.
    pub const VCU5: CanId = CanId::extended(0x180628D0);
    /// BMSStatus.
    pub const BMS_STATUS: CanId = CanId::extended(0x180228F3);
    /// CellVoltages1.
    pub const CELL_VOLTAGES1: CanId = CanId::extended(0x18E628F3);
    /// CellVoltages2.
    pub const CELL_VOLTAGES2: CanId = CanId::extended(0x18E528F3);
    /// CellVoltages3.
    pub const CELL_VOLTAGES3: CanId = CanId::extended(0x18E428F3);
    /// CellVoltages4.
    pub const CELL_VOLTAGES4: CanId = CanId::extended(0x18E328F3);
    /// CellVoltages5.
    pub const CELL_VOLTAGES5: CanId = CanId::extended(0x18E228F3);
    /// CellVoltages6.
    pub const CELL_VOLTAGES6: CanId = CanId::extended(0x18E128F3);
    /// CellVoltages7.
    pub const CELL_VOLTAGES7: CanId = CanId::extended(0x18E028F3);
    /// CellVoltages8.
    pub const CELL_VOLTAGES8: CanId = CanId::extended(0x18DF28F3);
    /// CellVoltages9.
    pub const CELL_VOLTAGES9: CanId = CanId::extended(0x18DE28F3);
    /// CellVoltages10.
    pub const CELL_VOLTAGES10: CanId = CanId::extended(0x18DD28F3);
    /// CellVoltages11.
    pub const CELL_VOLTAGES11: CanId = CanId::extended(0x18DC28F3);
    /// CellVoltages12.
    pub const CELL_VOLTAGES12: CanId = CanId::extended(0x18DB28F3);
    /// CellVoltages13.
    pub const CELL_VOLTAGES13: CanId = CanId::extended(0x18DA28F3);
    /// CellVoltages14.
    pub const CELL_VOLTAGES14: CanId = CanId::extended(0x18D928F3);
    /// CellVoltages15.
    pub const CELL_VOLTAGES15: CanId = CanId::extended(0x18D828F3);
    /// CellVoltages16.
    pub const CELL_VOLTAGES16: CanId = CanId::extended(0x18D728F3);
    /// CellVoltages17.
    pub const CELL_VOLTAGES17: CanId = CanId::extended(0x18D628F3);
    /// CellVoltages18.
    pub const CELL_VOLTAGES18: CanId = CanId::extended(0x18D528F3);
    /// CellVoltages19.
    pub const CELL_VOLTAGES19: CanId = CanId::extended(0x18D428F3);
    /// CellVoltages20.
    pub const CELL_VOLTAGES20: CanId = CanId::extended(0x18D328F3);
    /// CellVoltages21.
    pub const CELL_VOLTAGES21: CanId = CanId::extended(0x18D228F3);
    /// CellVoltages22.
    pub const CELL_VOLTAGES22: CanId = CanId::extended(0x18D128F3);
    /// CellVoltages23.
    pub const CELL_VOLTAGES23: CanId = CanId::extended(0x18D028F3);
    /// CellVoltages24.
    pub const CELL_VOLTAGES24: CanId = CanId::extended(0x18CF28F3);
    /// CellVoltages25.
    pub const CELL_VOLTAGES25: CanId = CanId::extended(0x18CE28F3);
    /// CellVoltages26.
    pub const CELL_VOLTAGES26: CanId = CanId::extended(0x18CD28F3);
    /// CellVoltages27.
    pub const CELL_VOLTAGES27: CanId = CanId::extended(0x18CC28F3);
    /// CellVoltages28.
    pub const CELL_VOLTAGES28: CanId = CanId::extended(0x18CB28F3);
    /// CellVoltages29.
    pub const CELL_VOLTAGES29: CanId = CanId::extended(0x18CA28F3);
    /// CellVoltages30.
    pub const CELL_VOLTAGES30: CanId = CanId::extended(0x18C928F3);
    /// CellVoltages31.
    pub const CELL_VOLTAGES31: CanId = CanId::extended(0x18C828F3);
    /// CellVoltages32.
    pub const CELL_VOLTAGES32: CanId = CanId::extended(0x18C728F3);
    /// CellVoltages33.
    pub const CELL_VOLTAGES33: CanId = CanId::extended(0x18C628F3);
    /// CellVoltages34.
    pub const CELL_VOLTAGES34: CanId = CanId::extended(0x18C528F3);
    /// CellVoltages35.
    pub const CELL_VOLTAGES35: CanId = CanId::extended(0x18C428F3);
    /// CellVoltages36.
    pub const CELL_VOLTAGES36: CanId = CanId::extended(0x18C328F3);
    /// CellVoltages37.
    pub const CELL_VOLTAGES37: CanId = CanId::extended(0x18C228F3);
    /// CellVoltages38.
    pub const CELL_VOLTAGES38: CanId = CanId::extended(0x18C128F3);
    /// CellVoltages39.
    pub const CELL_VOLTAGES39: CanId = CanId::extended(0x18C028F3);
    /// CellVoltages40.
    pub const CELL_VOLTAGES40: CanId = CanId::extended(0x18BF28F3);
    /// CellVoltages41.
    pub const CELL_VOLTAGES41: CanId = CanId::extended(0x18BE28F3);
    /// CellVoltages42.
    pub const CELL_VOLTAGES42: CanId = CanId::extended(0x18BD28F3);
    /// CellVoltages43.
    pub const CELL_VOLTAGES43: CanId = CanId::extended(0x18BC28F3);
    /// CellVoltages44.
    pub const CELL_VOLTAGES44: CanId = CanId::extended(0x18BB28F3);
    /// CellVoltages45.
    pub const CELL_VOLTAGES45: CanId = CanId::extended(0x18BA28F3);
    /// CellVoltages46.
    pub const CELL_VOLTAGES46: CanId = CanId::extended(0x18B928F3);
    /// CellVoltages47.
    pub const CELL_VOLTAGES47: CanId = CanId::extended(0x18B828F3);
    /// CellVoltages48.
    pub const CELL_VOLTAGES48: CanId = CanId::extended(0x18B728F3);
    /// CellVoltages49.
    pub const CELL_VOLTAGES49: CanId = CanId::extended(0x18B628F3);
    /// CellVoltages50.
    pub const CELL_VOLTAGES50: CanId = CanId::extended(0x18B528F3);
    /// CellVoltages51.
    pub const CELL_VOLTAGES51: CanId = CanId::extended(0x18B428F3);
    /// CellVoltages52.
    pub const CELL_VOLTAGES52: CanId = CanId::extended(0x18B328F3);
    /// CellVoltages53.
    pub const CELL_VOLTAGES53: CanId = CanId::extended(0x18B228F3);
    /// CellVoltages54.
    pub const CELL_VOLTAGES54: CanId = CanId::extended(0x18B128F3);
    /// CellVoltages55.
    pub const CELL_VOLTAGES55: CanId = CanId::extended(0x18B028F3);
    /// CellVoltages56.
    pub const CELL_VOLTAGES56: CanId = CanId::extended(0x18AF28F3);
    /// CellVoltages57.
    pub const CELL_VOLTAGES57: CanId = CanId::extended(0x18AE28F3);
    /// CellVoltages58.
    pub const CELL_VOLTAGES58: CanId = CanId::extended(0x18AD28F3);
    /// CellVoltages59.
    pub const CELL_VOLTAGES59: CanId = CanId::extended(0x18AC28F3);
    /// CellVoltages60.
    pub const CELL_VOLTAGES60: CanId = CanId::extended(0x18AB28F3);
    /// CellVoltages61.
    pub const CELL_VOLTAGES61: CanId = CanId::extended(0x18AA28F3);
    /// CellVoltages62.
    pub const CELL_VOLTAGES62: CanId = CanId::extended(0x18A928F3);
    /// CellVoltages63.
    pub const CELL_VOLTAGES63: CanId = CanId::extended(0x18A828F3);
    /// CellVoltages64.
    pub const CELL_VOLTAGES64: CanId = CanId::extended(0x18A728F3);
    /// ModuleTemperatures1.
    pub const MODULE_TEMPERATURES1: CanId = CanId::extended(0x180428F3);
    /// ModuleTemperatures2.
    pub const MODULE_TEMPERATURES2: CanId = CanId::extended(0x180528F3);
    /// ModuleTemperatures3.
    pub const MODULE_TEMPERATURES3: CanId = CanId::extended(0x180628F3);
    /// ModuleTemperatures4.
    pub const MODULE_TEMPERATURES4: CanId = CanId::extended(0x180728F3);
    /// ModuleTemperatures5.
    pub const MODULE_TEMPERATURES5: CanId = CanId::extended(0x180828F3);
    /// ModuleTemperatures6.
    pub const MODULE_TEMPERATURES6: CanId = CanId::extended(0x180928F3);
    /// ModuleTemperatures7.
    pub const MODULE_TEMPERATURES7: CanId = CanId::extended(0x180A28F3);
    /// ModuleTemperatures8.
    pub const MODULE_TEMPERATURES8: CanId = CanId::extended(0x180B28F3);
    /// ModuleTemperatures9.
    pub const MODULE_TEMPERATURES9: CanId = CanId::extended(0x180C28F3);
    /// ModuleTemperatures10.
    pub const MODULE_TEMPERATURES10: CanId = CanId::extended(0x180D28F3);
    /// ModuleTemperatures11.
    pub const MODULE_TEMPERATURES11: CanId = CanId::extended(0x180E28F3);
    /// ModuleTemperatures12.
    pub const MODULE_TEMPERATURES12: CanId = CanId::extended(0x180F28F3);
    /// ModuleTemperatures13.
    pub const MODULE_TEMPERATURES13: CanId = CanId::extended(0x181028F3);
    /// ModuleTemperatures14.
    pub const MODULE_TEMPERATURES14: CanId = CanId::extended(0x181128F3);
    /// ModuleTemperatures15.
    pub const MODULE_TEMPERATURES15: CanId = CanId::extended(0x181228F3);
    /// ModuleTemperatures16.
    pub const MODULE_TEMPERATURES16: CanId = CanId::extended(0x181328F3);
    /// ModuleTemperatures17.
    pub const MODULE_TEMPERATURES17: CanId = CanId::extended(0x181428F3);
    /// ModuleTemperatures18.
    pub const MODULE_TEMPERATURES18: CanId = CanId::extended(0x181528F3);
    /// ModuleTemperatures19.
    pub const MODULE_TEMPERATURES19: CanId = CanId::extended(0x181628F3);
    /// ModuleTemperatures20.
    pub const MODULE_TEMPERATURES20: CanId = CanId::extended(0x181728F3);
    /// ModuleTemperatures21.
    pub const MODULE_TEMPERATURES21: CanId = CanId::extended(0x181828F3);
    /// ModuleTemperatures22.
    pub const MODULE_TEMPERATURES22: CanId = CanId::extended(0x181928F3);
    /// ModuleTemperatures23.
    pub const MODULE_TEMPERATURES23: CanId = CanId::extended(0x181A28F3);
    /// BMSFaults.
    pub const BMS_FAULTS: CanId = CanId::extended(0x181B28F3);
    /// BMSExtremes.
    pub const BMS_EXTREMES: CanId = CanId::extended(0x181C28F3);
    /// BMSExtremePositions.
    pub const BMS_EXTREME_POSITIONS: CanId = CanId::extended(0x181D28F3);
    /// Charger.
    pub const CHARGER: CanId = CanId::extended(0x180028E5);
    /// Meter1.
    pub const METER1: CanId = CanId::extended(0x1800D028);
    /// Meter2.
    pub const METER2: CanId = CanId::extended(0x1801D028);
    /// Meter3.
    pub const METER3: CanId = CanId::extended(0x1800F328);
}

/// VCU1 (180228D0) from VCU, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu1(pub [u8; 8]);

impl Default for Vcu1 {
    fn default() -> Self { Self::new() }
}

impl Vcu1 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

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

    /// Returns `work_state` as sent: 3 bits from bit 8.
    #[inline(always)]
    pub const fn work_state_raw(self) -> u8 { self.0[1] & 0x07 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn work_state(self) -> Option<i32> {
        let raw = self.work_state_raw();
        if raw <= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `work_state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_work_state_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xF8 | raw & 0x07;
        self
    }

    /// Returns `vcu_fault_level` as sent: 2 bits from bit 11.
    #[inline(always)]
    pub const fn vcu_fault_level_raw(self) -> u8 { self.0[1] >> 3 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn vcu_fault_level(self) -> Option<i32> {
        let raw = self.vcu_fault_level_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `vcu_fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vcu_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xE7 | (raw & 0x03) << 3;
        self
    }

    /// Returns `vacuum_fault` as sent: 1 bit from bit 13.
    #[inline(always)]
    pub const fn vacuum_fault_raw(self) -> u8 { self.0[1] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn vacuum_fault(self) -> Option<i32> {
        let raw = self.vacuum_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `vacuum_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vacuum_fault_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `aux_battery_low` as sent: 1 bit from bit 14.
    #[inline(always)]
    pub const fn aux_battery_low_raw(self) -> u8 { self.0[1] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn aux_battery_low(self) -> Option<i32> {
        let raw = self.aux_battery_low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `aux_battery_low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_aux_battery_low_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `dcdc_fault` as sent: 1 bit from bit 15.
    #[inline(always)]
    pub const fn dcdc_fault_raw(self) -> u8 { self.0[1] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn dcdc_fault(self) -> Option<i32> {
        let raw = self.dcdc_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `dcdc_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_dcdc_fault_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `accelerator_pedal` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn accelerator_pedal_raw(self) -> u8 { self.0[2] }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn accelerator_pedal(self) -> Option<i32> {
        let raw = self.accelerator_pedal_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `accelerator_pedal` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_accelerator_pedal_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `brake_pedal` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn brake_pedal_raw(self) -> u8 { self.0[3] }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn brake_pedal(self) -> Option<i32> {
        let raw = self.brake_pedal_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `brake_pedal` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_brake_pedal_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `torque` as sent: 16 bits down from bit 39.
    #[inline(always)]
    pub const fn torque_raw(self) -> u16 { u16::from_be_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in 1/10 Nm, -30000 to 30000; `None` if not valid.
    #[inline(always)]
    pub const fn torque(self) -> Option<i32> {
        let raw = self.torque_raw();
        if raw <= 60000 { Some(raw as i32 - 30000) } else { None }
    }
    /// Returns the frame with `torque` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_torque_raw(mut self, raw: u16) -> Self {
        self.0[5] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
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

    /// Returns `water_pump` as sent: 1 bit from bit 56.
    #[inline(always)]
    pub const fn water_pump_raw(self) -> u8 { self.0[7] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn water_pump(self) -> Option<i32> {
        let raw = self.water_pump_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `water_pump` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_water_pump_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `fan_low` as sent: 1 bit from bit 57.
    #[inline(always)]
    pub const fn fan_low_raw(self) -> u8 { self.0[7] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn fan_low(self) -> Option<i32> {
        let raw = self.fan_low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fan_low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fan_low_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `fan_high` as sent: 1 bit from bit 58.
    #[inline(always)]
    pub const fn fan_high_raw(self) -> u8 { self.0[7] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn fan_high(self) -> Option<i32> {
        let raw = self.fan_high_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fan_high` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fan_high_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `air_pump` as sent: 1 bit from bit 59.
    #[inline(always)]
    pub const fn air_pump_raw(self) -> u8 { self.0[7] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn air_pump(self) -> Option<i32> {
        let raw = self.air_pump_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `air_pump` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_air_pump_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `air_conditioning` as sent: 1 bit from bit 60.
    #[inline(always)]
    pub const fn air_conditioning_raw(self) -> u8 { self.0[7] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn air_conditioning(self) -> Option<i32> {
        let raw = self.air_conditioning_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `air_conditioning` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_air_conditioning_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `handbrake` as sent: 1 bit from bit 61.
    #[inline(always)]
    pub const fn handbrake_raw(self) -> u8 { self.0[7] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn handbrake(self) -> Option<i32> {
        let raw = self.handbrake_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `handbrake` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_handbrake_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `foot_brake` as sent: 1 bit from bit 62.
    #[inline(always)]
    pub const fn foot_brake_raw(self) -> u8 { self.0[7] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn foot_brake(self) -> Option<i32> {
        let raw = self.foot_brake_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `foot_brake` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_foot_brake_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `economy_mode` as sent: 1 bit from bit 63.
    #[inline(always)]
    pub const fn economy_mode_raw(self) -> u8 { self.0[7] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn economy_mode(self) -> Option<i32> {
        let raw = self.economy_mode_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `economy_mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_economy_mode_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// VCU2 (180328D0) from VCU, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu2(pub [u8; 8]);

impl Default for Vcu2 {
    fn default() -> Self { Self::new() }
}

impl Vcu2 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

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

    /// Returns `gear` as sent: 2 bits from bit 8.
    #[inline(always)]
    pub const fn gear_raw(self) -> u8 { self.0[1] & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn gear(self) -> Option<i32> {
        let raw = self.gear_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `gear` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_gear_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `front_ptc_fan` as sent: 2 bits from bit 10.
    #[inline(always)]
    pub const fn front_ptc_fan_raw(self) -> u8 { self.0[1] >> 2 & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn front_ptc_fan(self) -> Option<i32> {
        let raw = self.front_ptc_fan_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `front_ptc_fan` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_front_ptc_fan_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `rear_ptc_fan` as sent: 2 bits from bit 12.
    #[inline(always)]
    pub const fn rear_ptc_fan_raw(self) -> u8 { self.0[1] >> 4 & 0x03 }
    /// Returns the value, 0 to 2; `None` if not valid.
    #[inline(always)]
    pub const fn rear_ptc_fan(self) -> Option<i32> {
        let raw = self.rear_ptc_fan_raw();
        if raw <= 2 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `rear_ptc_fan` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_rear_ptc_fan_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `charge_state` as sent: 2 bits from bit 16.
    #[inline(always)]
    pub const fn charge_state_raw(self) -> u8 { self.0[2] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn charge_state(self) -> Option<i32> {
        let raw = self.charge_state_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `charge_state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_charge_state_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `vehicle_mode` as sent: 3 bits from bit 18.
    #[inline(always)]
    pub const fn vehicle_mode_raw(self) -> u8 { self.0[2] >> 2 & 0x07 }
    /// Returns the value, 0 to 4; `None` if not valid.
    #[inline(always)]
    pub const fn vehicle_mode(self) -> Option<i32> {
        let raw = self.vehicle_mode_raw();
        if raw <= 4 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `vehicle_mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vehicle_mode_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0xE3 | (raw & 0x07) << 2;
        self
    }

    /// Returns `motor_fault_level` as sent: 2 bits from bit 24.
    #[inline(always)]
    pub const fn motor_fault_level_raw(self) -> u8 { self.0[3] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn motor_fault_level(self) -> Option<i32> {
        let raw = self.motor_fault_level_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `motor_fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `battery_fault_level` as sent: 2 bits from bit 26.
    #[inline(always)]
    pub const fn battery_fault_level_raw(self) -> u8 { self.0[3] >> 2 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn battery_fault_level(self) -> Option<i32> {
        let raw = self.battery_fault_level_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `battery_fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_battery_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xF3 | (raw & 0x03) << 2;
        self
    }

    /// Returns `vcu_fault_level` as sent: 2 bits from bit 28.
    #[inline(always)]
    pub const fn vcu_fault_level_raw(self) -> u8 { self.0[3] >> 4 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn vcu_fault_level(self) -> Option<i32> {
        let raw = self.vcu_fault_level_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `vcu_fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vcu_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[3] = self.0[3] & 0xCF | (raw & 0x03) << 4;
        self
    }

    /// Returns `water_pump_fault` as sent: 1 bit from bit 32.
    #[inline(always)]
    pub const fn water_pump_fault_raw(self) -> u8 { self.0[4] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn water_pump_fault(self) -> Option<i32> {
        let raw = self.water_pump_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `water_pump_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_water_pump_fault_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `fan_fault` as sent: 2 bits from bit 33.
    #[inline(always)]
    pub const fn fan_fault_raw(self) -> u8 { self.0[4] >> 1 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn fan_fault(self) -> Option<i32> {
        let raw = self.fan_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `fan_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_fan_fault_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xF9 | (raw & 0x03) << 1;
        self
    }

    /// Returns `air_pump_fault` as sent: 1 bit from bit 35.
    #[inline(always)]
    pub const fn air_pump_fault_raw(self) -> u8 { self.0[4] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn air_pump_fault(self) -> Option<i32> {
        let raw = self.air_pump_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `air_pump_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_air_pump_fault_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `aux_battery_low` as sent: 1 bit from bit 36.
    #[inline(always)]
    pub const fn aux_battery_low_raw(self) -> u8 { self.0[4] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn aux_battery_low(self) -> Option<i32> {
        let raw = self.aux_battery_low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `aux_battery_low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_aux_battery_low_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `shift_failed` as sent: 1 bit from bit 37.
    #[inline(always)]
    pub const fn shift_failed_raw(self) -> u8 { self.0[4] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn shift_failed(self) -> Option<i32> {
        let raw = self.shift_failed_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `shift_failed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_shift_failed_raw(mut self, raw: u8) -> Self {
        self.0[4] = self.0[4] & 0xDF | (raw & 0x01) << 5;
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

    /// Returns `vacuum` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn vacuum_raw(self) -> u8 { self.0[6] }
    /// Returns the value in 1/100 bar, 0 to 200; `None` if not valid.
    #[inline(always)]
    pub const fn vacuum(self) -> Option<i32> {
        let raw = self.vacuum_raw();
        if raw <= 200 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `vacuum` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vacuum_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `soc` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn soc_raw(self) -> u8 { self.0[7] }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn soc(self) -> Option<i32> {
        let raw = self.soc_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// VCU3 (180428D0) from VCU, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu3(pub [u8; 8]);

impl Default for Vcu3 {
    fn default() -> Self { Self::new() }
}

impl Vcu3 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `vehicle_speed` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn vehicle_speed_raw(self) -> u8 { self.0[0] }
    /// Returns the value in km/h, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn vehicle_speed(self) -> Option<i32> {
        let raw = self.vehicle_speed_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `vehicle_speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_vehicle_speed_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `remaining_range` as sent: 16 bits down from bit 15.
    #[inline(always)]
    pub const fn remaining_range_raw(self) -> u16 { u16::from_be_bytes([self.0[1], self.0[2]]) }
    /// Returns the value in km, 0 to 65535; `None` if not valid.
    #[inline(always)]
    pub const fn remaining_range(self) -> Option<i32> {
        let raw = self.remaining_range_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `remaining_range` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_remaining_range_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `motor_speed` as sent: 16 bits down from bit 31.
    #[inline(always)]
    pub const fn motor_speed_raw(self) -> u16 { u16::from_be_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in rpm, -15000 to 15000; `None` if not valid.
    #[inline(always)]
    pub const fn motor_speed(self) -> Option<i32> {
        let raw = self.motor_speed_raw();
        if raw <= 30000 { Some(raw as i32 - 15000) } else { None }
    }
    /// Returns the frame with `motor_speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_speed_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `igbt_protection` as sent: 1 bit from bit 40.
    #[inline(always)]
    pub const fn igbt_protection_raw(self) -> u8 { self.0[5] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn igbt_protection(self) -> Option<i32> {
        let raw = self.igbt_protection_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `igbt_protection` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_igbt_protection_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `drive_supply_undervoltage` as sent: 1 bit from bit 41.
    #[inline(always)]
    pub const fn drive_supply_undervoltage_raw(self) -> u8 { self.0[5] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn drive_supply_undervoltage(self) -> Option<i32> {
        let raw = self.drive_supply_undervoltage_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `drive_supply_undervoltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_drive_supply_undervoltage_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `bridge_shoot_through` as sent: 1 bit from bit 42.
    #[inline(always)]
    pub const fn bridge_shoot_through_raw(self) -> u8 { self.0[5] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn bridge_shoot_through(self) -> Option<i32> {
        let raw = self.bridge_shoot_through_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `bridge_shoot_through` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bridge_shoot_through_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `igbt_over_temperature` as sent: 1 bit from bit 43.
    #[inline(always)]
    pub const fn igbt_over_temperature_raw(self) -> u8 { self.0[5] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn igbt_over_temperature(self) -> Option<i32> {
        let raw = self.igbt_over_temperature_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `igbt_over_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_igbt_over_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `motor_over_temperature` as sent: 1 bit from bit 44.
    #[inline(always)]
    pub const fn motor_over_temperature_raw(self) -> u8 { self.0[5] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn motor_over_temperature(self) -> Option<i32> {
        let raw = self.motor_over_temperature_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `motor_over_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_over_temperature_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `bus_overcurrent` as sent: 1 bit from bit 45.
    #[inline(always)]
    pub const fn bus_overcurrent_raw(self) -> u8 { self.0[5] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn bus_overcurrent(self) -> Option<i32> {
        let raw = self.bus_overcurrent_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `bus_overcurrent` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_overcurrent_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `phase_overcurrent` as sent: 1 bit from bit 46.
    #[inline(always)]
    pub const fn phase_overcurrent_raw(self) -> u8 { self.0[5] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn phase_overcurrent(self) -> Option<i32> {
        let raw = self.phase_overcurrent_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `phase_overcurrent` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_phase_overcurrent_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `control_undervoltage` as sent: 1 bit from bit 47.
    #[inline(always)]
    pub const fn control_undervoltage_raw(self) -> u8 { self.0[5] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn control_undervoltage(self) -> Option<i32> {
        let raw = self.control_undervoltage_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `control_undervoltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_control_undervoltage_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `control_reversed` as sent: 1 bit from bit 48.
    #[inline(always)]
    pub const fn control_reversed_raw(self) -> u8 { self.0[6] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn control_reversed(self) -> Option<i32> {
        let raw = self.control_reversed_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `control_reversed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_control_reversed_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `control_overvoltage` as sent: 1 bit from bit 49.
    #[inline(always)]
    pub const fn control_overvoltage_raw(self) -> u8 { self.0[6] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn control_overvoltage(self) -> Option<i32> {
        let raw = self.control_overvoltage_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `control_overvoltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_control_overvoltage_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `dq_overcurrent` as sent: 1 bit from bit 50.
    #[inline(always)]
    pub const fn dq_overcurrent_raw(self) -> u8 { self.0[6] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn dq_overcurrent(self) -> Option<i32> {
        let raw = self.dq_overcurrent_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `dq_overcurrent` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_dq_overcurrent_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `bus_undervoltage` as sent: 1 bit from bit 51.
    #[inline(always)]
    pub const fn bus_undervoltage_raw(self) -> u8 { self.0[6] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn bus_undervoltage(self) -> Option<i32> {
        let raw = self.bus_undervoltage_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `bus_undervoltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_undervoltage_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `bus_overvoltage` as sent: 1 bit from bit 52.
    #[inline(always)]
    pub const fn bus_overvoltage_raw(self) -> u8 { self.0[6] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn bus_overvoltage(self) -> Option<i32> {
        let raw = self.bus_overvoltage_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `bus_overvoltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_bus_overvoltage_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `over_torque` as sent: 1 bit from bit 53.
    #[inline(always)]
    pub const fn over_torque_raw(self) -> u8 { self.0[6] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn over_torque(self) -> Option<i32> {
        let raw = self.over_torque_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `over_torque` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_over_torque_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `overload` as sent: 1 bit from bit 54.
    #[inline(always)]
    pub const fn overload_raw(self) -> u8 { self.0[6] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overload(self) -> Option<i32> {
        let raw = self.overload_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overload` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overload_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `stall` as sent: 1 bit from bit 55.
    #[inline(always)]
    pub const fn stall_raw(self) -> u8 { self.0[6] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn stall(self) -> Option<i32> {
        let raw = self.stall_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `stall` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_stall_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `driver_over_temperature` as sent: 1 bit from bit 56.
    #[inline(always)]
    pub const fn driver_over_temperature_raw(self) -> u8 { self.0[7] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn driver_over_temperature(self) -> Option<i32> {
        let raw = self.driver_over_temperature_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `driver_over_temperature` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_driver_over_temperature_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `overspeed` as sent: 1 bit from bit 57.
    #[inline(always)]
    pub const fn overspeed_raw(self) -> u8 { self.0[7] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overspeed(self) -> Option<i32> {
        let raw = self.overspeed_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overspeed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overspeed_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `can_fault` as sent: 1 bit from bit 58.
    #[inline(always)]
    pub const fn can_fault_raw(self) -> u8 { self.0[7] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn can_fault(self) -> Option<i32> {
        let raw = self.can_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `can_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_can_fault_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `back_emf` as sent: 1 bit from bit 59.
    #[inline(always)]
    pub const fn back_emf_raw(self) -> u8 { self.0[7] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn back_emf(self) -> Option<i32> {
        let raw = self.back_emf_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `back_emf` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_back_emf_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `phase_loss` as sent: 1 bit from bit 60.
    #[inline(always)]
    pub const fn phase_loss_raw(self) -> u8 { self.0[7] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn phase_loss(self) -> Option<i32> {
        let raw = self.phase_loss_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `phase_loss` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_phase_loss_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `resolver_fault` as sent: 1 bit from bit 61.
    #[inline(always)]
    pub const fn resolver_fault_raw(self) -> u8 { self.0[7] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn resolver_fault(self) -> Option<i32> {
        let raw = self.resolver_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `resolver_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_resolver_fault_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `hardware_shutdown` as sent: 1 bit from bit 62.
    #[inline(always)]
    pub const fn hardware_shutdown_raw(self) -> u8 { self.0[7] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn hardware_shutdown(self) -> Option<i32> {
        let raw = self.hardware_shutdown_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hardware_shutdown` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hardware_shutdown_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xBF | (raw & 0x01) << 6;
        self
    }
}

/// VCU4 (180528D0) from VCU, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu4(pub [u8; 8]);

impl Default for Vcu4 {
    fn default() -> Self { Self::new() }
}

impl Vcu4 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `motor_voltage` as sent: 16 bits down from bit 7.
    #[inline(always)]
    pub const fn motor_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn motor_voltage(self) -> Option<i32> {
        let raw = self.motor_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `motor_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motor_voltage_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[0] = (raw >> 8) as u8;
        self
    }

    /// Returns `phase_current` as sent: 16 bits down from bit 23.
    #[inline(always)]
    pub const fn phase_current_raw(self) -> u16 { u16::from_be_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 A, -5000 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn phase_current(self) -> Option<i32> {
        let raw = self.phase_current_raw();
        if raw <= 10000 { Some(raw as i32 - 5000) } else { None }
    }
    /// Returns the frame with `phase_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_phase_current_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `phase_voltage` as sent: 16 bits down from bit 39.
    #[inline(always)]
    pub const fn phase_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[4], self.0[5]]) }
    /// Returns the value in V, 0 to 600; `None` if not valid.
    #[inline(always)]
    pub const fn phase_voltage(self) -> Option<i32> {
        let raw = self.phase_voltage_raw();
        if raw <= 600 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `phase_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_phase_voltage_raw(mut self, raw: u16) -> Self {
        self.0[5] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
        self
    }

    /// Returns `air_pressure_1` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn air_pressure_1_raw(self) -> u8 { self.0[6] }
    /// Returns the value in 1/10 bar, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn air_pressure_1(self) -> Option<i32> {
        let raw = self.air_pressure_1_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `air_pressure_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_air_pressure_1_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `air_pressure_2` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn air_pressure_2_raw(self) -> u8 { self.0[7] }
    /// Returns the value in 1/10 bar, 0 to 254; `None` if not valid.
    #[inline(always)]
    pub const fn air_pressure_2(self) -> Option<i32> {
        let raw = self.air_pressure_2_raw();
        if raw <= 254 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `air_pressure_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_air_pressure_2_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// VCU5 (180628D0) from VCU, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vcu5(pub [u8; 8]);

impl Default for Vcu5 {
    fn default() -> Self { Self::new() }
}

impl Vcu5 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `hardware_version` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn hardware_version_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn hardware_version(self) -> Option<i32> {
        let raw = self.hardware_version_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hardware_version` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hardware_version_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `software_version` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn software_version_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn software_version(self) -> Option<i32> {
        let raw = self.software_version_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `software_version` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_software_version_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// BMSStatus (180228F3) from BMS, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BmsStatus(pub [u8; 8]);

impl Default for BmsStatus {
    fn default() -> Self { Self::new() }
}

impl BmsStatus {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `pack_voltage` as sent: 16 bits down from bit 7.
    #[inline(always)]
    pub const fn pack_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn pack_voltage(self) -> Option<i32> {
        let raw = self.pack_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `pack_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_voltage_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[0] = (raw >> 8) as u8;
        self
    }

    /// Returns `pack_current` as sent: 16 bits down from bit 23.
    #[inline(always)]
    pub const fn pack_current_raw(self) -> u16 { u16::from_be_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/10 A, -5000 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn pack_current(self) -> Option<i32> {
        let raw = self.pack_current_raw();
        if raw <= 10000 { Some(raw as i32 - 5000) } else { None }
    }
    /// Returns the frame with `pack_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_current_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `soc` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn soc_raw(self) -> u8 { self.0[4] }
    /// Returns the value in 1/5 %, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn soc(self) -> Option<i32> {
        let raw = self.soc_raw();
        if raw <= 250 { Some((raw as i32) * 2) } else { None }
    }
    /// Returns the frame with `soc` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
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

    /// Returns `battery_fault_level` as sent: 2 bits from bit 48.
    #[inline(always)]
    pub const fn battery_fault_level_raw(self) -> u8 { self.0[6] & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn battery_fault_level(self) -> Option<i32> {
        let raw = self.battery_fault_level_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `battery_fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_battery_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFC | raw & 0x03;
        self
    }

    /// Returns `insulation_fault_level` as sent: 2 bits from bit 50.
    #[inline(always)]
    pub const fn insulation_fault_level_raw(self) -> u8 { self.0[6] >> 2 & 0x03 }
    /// Returns the value, 0 to 3; `None` if not valid.
    #[inline(always)]
    pub const fn insulation_fault_level(self) -> Option<i32> {
        let raw = self.insulation_fault_level_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `insulation_fault_level` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_insulation_fault_level_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF3 | (raw & 0x03) << 2;
        self
    }
}

/// CellVoltages1 (18E628F3) from BMS, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellVoltages1(pub [u8; 8]);

impl Default for CellVoltages1 {
    fn default() -> Self { Self::new() }
}

impl CellVoltages1 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `number_1` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn number_1_raw(self) -> u8 { self.0[0] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn number_1(self) -> Option<i32> {
        let raw = self.number_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `number_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_number_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `voltage_1` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn voltage_1_raw(self) -> u8 { self.0[1] }
    /// Returns the value in 1/50 V, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn voltage_1(self) -> Option<i32> {
        let raw = self.voltage_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `voltage_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_voltage_1_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `number_2` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn number_2_raw(self) -> u8 { self.0[2] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn number_2(self) -> Option<i32> {
        let raw = self.number_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `number_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_number_2_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `voltage_2` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn voltage_2_raw(self) -> u8 { self.0[3] }
    /// Returns the value in 1/50 V, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn voltage_2(self) -> Option<i32> {
        let raw = self.voltage_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `voltage_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_voltage_2_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `number_3` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn number_3_raw(self) -> u8 { self.0[4] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn number_3(self) -> Option<i32> {
        let raw = self.number_3_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `number_3` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_number_3_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `voltage_3` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn voltage_3_raw(self) -> u8 { self.0[5] }
    /// Returns the value in 1/50 V, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn voltage_3(self) -> Option<i32> {
        let raw = self.voltage_3_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `voltage_3` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_voltage_3_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `number_4` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn number_4_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn number_4(self) -> Option<i32> {
        let raw = self.number_4_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `number_4` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_number_4_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `voltage_4` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn voltage_4_raw(self) -> u8 { self.0[7] }
    /// Returns the value in 1/50 V, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn voltage_4(self) -> Option<i32> {
        let raw = self.voltage_4_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `voltage_4` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_voltage_4_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// CellVoltages2 (18E528F3) from BMS, every 500 ms.
pub type CellVoltages2 = CellVoltages1;

/// CellVoltages3 (18E428F3) from BMS, every 500 ms.
pub type CellVoltages3 = CellVoltages1;

/// CellVoltages4 (18E328F3) from BMS, every 500 ms.
pub type CellVoltages4 = CellVoltages1;

/// CellVoltages5 (18E228F3) from BMS, every 500 ms.
pub type CellVoltages5 = CellVoltages1;

/// CellVoltages6 (18E128F3) from BMS, every 500 ms.
pub type CellVoltages6 = CellVoltages1;

/// CellVoltages7 (18E028F3) from BMS, every 500 ms.
pub type CellVoltages7 = CellVoltages1;

/// CellVoltages8 (18DF28F3) from BMS, every 500 ms.
pub type CellVoltages8 = CellVoltages1;

/// CellVoltages9 (18DE28F3) from BMS, every 500 ms.
pub type CellVoltages9 = CellVoltages1;

/// CellVoltages10 (18DD28F3) from BMS, every 500 ms.
pub type CellVoltages10 = CellVoltages1;

/// CellVoltages11 (18DC28F3) from BMS, every 500 ms.
pub type CellVoltages11 = CellVoltages1;

/// CellVoltages12 (18DB28F3) from BMS, every 500 ms.
pub type CellVoltages12 = CellVoltages1;

/// CellVoltages13 (18DA28F3) from BMS, every 500 ms.
pub type CellVoltages13 = CellVoltages1;

/// CellVoltages14 (18D928F3) from BMS, every 500 ms.
pub type CellVoltages14 = CellVoltages1;

/// CellVoltages15 (18D828F3) from BMS, every 500 ms.
pub type CellVoltages15 = CellVoltages1;

/// CellVoltages16 (18D728F3) from BMS, every 500 ms.
pub type CellVoltages16 = CellVoltages1;

/// CellVoltages17 (18D628F3) from BMS, every 500 ms.
pub type CellVoltages17 = CellVoltages1;

/// CellVoltages18 (18D528F3) from BMS, every 500 ms.
pub type CellVoltages18 = CellVoltages1;

/// CellVoltages19 (18D428F3) from BMS, every 500 ms.
pub type CellVoltages19 = CellVoltages1;

/// CellVoltages20 (18D328F3) from BMS, every 500 ms.
pub type CellVoltages20 = CellVoltages1;

/// CellVoltages21 (18D228F3) from BMS, every 500 ms.
pub type CellVoltages21 = CellVoltages1;

/// CellVoltages22 (18D128F3) from BMS, every 500 ms.
pub type CellVoltages22 = CellVoltages1;

/// CellVoltages23 (18D028F3) from BMS, every 500 ms.
pub type CellVoltages23 = CellVoltages1;

/// CellVoltages24 (18CF28F3) from BMS, every 500 ms.
pub type CellVoltages24 = CellVoltages1;

/// CellVoltages25 (18CE28F3) from BMS, every 500 ms.
pub type CellVoltages25 = CellVoltages1;

/// CellVoltages26 (18CD28F3) from BMS, every 500 ms.
pub type CellVoltages26 = CellVoltages1;

/// CellVoltages27 (18CC28F3) from BMS, every 500 ms.
pub type CellVoltages27 = CellVoltages1;

/// CellVoltages28 (18CB28F3) from BMS, every 500 ms.
pub type CellVoltages28 = CellVoltages1;

/// CellVoltages29 (18CA28F3) from BMS, every 500 ms.
pub type CellVoltages29 = CellVoltages1;

/// CellVoltages30 (18C928F3) from BMS, every 500 ms.
pub type CellVoltages30 = CellVoltages1;

/// CellVoltages31 (18C828F3) from BMS, every 500 ms.
pub type CellVoltages31 = CellVoltages1;

/// CellVoltages32 (18C728F3) from BMS, every 500 ms.
pub type CellVoltages32 = CellVoltages1;

/// CellVoltages33 (18C628F3) from BMS, every 500 ms.
pub type CellVoltages33 = CellVoltages1;

/// CellVoltages34 (18C528F3) from BMS, every 500 ms.
pub type CellVoltages34 = CellVoltages1;

/// CellVoltages35 (18C428F3) from BMS, every 500 ms.
pub type CellVoltages35 = CellVoltages1;

/// CellVoltages36 (18C328F3) from BMS, every 500 ms.
pub type CellVoltages36 = CellVoltages1;

/// CellVoltages37 (18C228F3) from BMS, every 500 ms.
pub type CellVoltages37 = CellVoltages1;

/// CellVoltages38 (18C128F3) from BMS, every 500 ms.
pub type CellVoltages38 = CellVoltages1;

/// CellVoltages39 (18C028F3) from BMS, every 500 ms.
pub type CellVoltages39 = CellVoltages1;

/// CellVoltages40 (18BF28F3) from BMS, every 500 ms.
pub type CellVoltages40 = CellVoltages1;

/// CellVoltages41 (18BE28F3) from BMS, every 500 ms.
pub type CellVoltages41 = CellVoltages1;

/// CellVoltages42 (18BD28F3) from BMS, every 500 ms.
pub type CellVoltages42 = CellVoltages1;

/// CellVoltages43 (18BC28F3) from BMS, every 500 ms.
pub type CellVoltages43 = CellVoltages1;

/// CellVoltages44 (18BB28F3) from BMS, every 500 ms.
pub type CellVoltages44 = CellVoltages1;

/// CellVoltages45 (18BA28F3) from BMS, every 500 ms.
pub type CellVoltages45 = CellVoltages1;

/// CellVoltages46 (18B928F3) from BMS, every 500 ms.
pub type CellVoltages46 = CellVoltages1;

/// CellVoltages47 (18B828F3) from BMS, every 500 ms.
pub type CellVoltages47 = CellVoltages1;

/// CellVoltages48 (18B728F3) from BMS, every 500 ms.
pub type CellVoltages48 = CellVoltages1;

/// CellVoltages49 (18B628F3) from BMS, every 500 ms.
pub type CellVoltages49 = CellVoltages1;

/// CellVoltages50 (18B528F3) from BMS, every 500 ms.
pub type CellVoltages50 = CellVoltages1;

/// CellVoltages51 (18B428F3) from BMS, every 500 ms.
pub type CellVoltages51 = CellVoltages1;

/// CellVoltages52 (18B328F3) from BMS, every 500 ms.
pub type CellVoltages52 = CellVoltages1;

/// CellVoltages53 (18B228F3) from BMS, every 500 ms.
pub type CellVoltages53 = CellVoltages1;

/// CellVoltages54 (18B128F3) from BMS, every 500 ms.
pub type CellVoltages54 = CellVoltages1;

/// CellVoltages55 (18B028F3) from BMS, every 500 ms.
pub type CellVoltages55 = CellVoltages1;

/// CellVoltages56 (18AF28F3) from BMS, every 500 ms.
pub type CellVoltages56 = CellVoltages1;

/// CellVoltages57 (18AE28F3) from BMS, every 500 ms.
pub type CellVoltages57 = CellVoltages1;

/// CellVoltages58 (18AD28F3) from BMS, every 500 ms.
pub type CellVoltages58 = CellVoltages1;

/// CellVoltages59 (18AC28F3) from BMS, every 500 ms.
pub type CellVoltages59 = CellVoltages1;

/// CellVoltages60 (18AB28F3) from BMS, every 500 ms.
pub type CellVoltages60 = CellVoltages1;

/// CellVoltages61 (18AA28F3) from BMS, every 500 ms.
pub type CellVoltages61 = CellVoltages1;

/// CellVoltages62 (18A928F3) from BMS, every 500 ms.
pub type CellVoltages62 = CellVoltages1;

/// CellVoltages63 (18A828F3) from BMS, every 500 ms.
pub type CellVoltages63 = CellVoltages1;

/// CellVoltages64 (18A728F3) from BMS, every 500 ms.
pub type CellVoltages64 = CellVoltages1;

/// ModuleTemperatures1 (180428F3) from BMS, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ModuleTemperatures1(pub [u8; 8]);

impl Default for ModuleTemperatures1 {
    fn default() -> Self { Self::new() }
}

impl ModuleTemperatures1 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `temperature_1` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn temperature_1_raw(self) -> u8 { self.0[0] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_1(self) -> Option<i32> {
        let raw = self.temperature_1_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `temperature_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_1_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `temperature_2` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn temperature_2_raw(self) -> u8 { self.0[1] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_2(self) -> Option<i32> {
        let raw = self.temperature_2_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `temperature_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_2_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `temperature_3` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn temperature_3_raw(self) -> u8 { self.0[2] }
    /// Returns the value in °C, -40 to 210; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_3(self) -> Option<i32> {
        let raw = self.temperature_3_raw();
        if raw <= 250 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `temperature_3` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_3_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }
}

/// ModuleTemperatures2 (180528F3) from BMS, every 500 ms.
pub type ModuleTemperatures2 = ModuleTemperatures1;

/// ModuleTemperatures3 (180628F3) from BMS, every 500 ms.
pub type ModuleTemperatures3 = ModuleTemperatures1;

/// ModuleTemperatures4 (180728F3) from BMS, every 500 ms.
pub type ModuleTemperatures4 = ModuleTemperatures1;

/// ModuleTemperatures5 (180828F3) from BMS, every 500 ms.
pub type ModuleTemperatures5 = ModuleTemperatures1;

/// ModuleTemperatures6 (180928F3) from BMS, every 500 ms.
pub type ModuleTemperatures6 = ModuleTemperatures1;

/// ModuleTemperatures7 (180A28F3) from BMS, every 500 ms.
pub type ModuleTemperatures7 = ModuleTemperatures1;

/// ModuleTemperatures8 (180B28F3) from BMS, every 500 ms.
pub type ModuleTemperatures8 = ModuleTemperatures1;

/// ModuleTemperatures9 (180C28F3) from BMS, every 500 ms.
pub type ModuleTemperatures9 = ModuleTemperatures1;

/// ModuleTemperatures10 (180D28F3) from BMS, every 500 ms.
pub type ModuleTemperatures10 = ModuleTemperatures1;

/// ModuleTemperatures11 (180E28F3) from BMS, every 500 ms.
pub type ModuleTemperatures11 = ModuleTemperatures1;

/// ModuleTemperatures12 (180F28F3) from BMS, every 500 ms.
pub type ModuleTemperatures12 = ModuleTemperatures1;

/// ModuleTemperatures13 (181028F3) from BMS, every 500 ms.
pub type ModuleTemperatures13 = ModuleTemperatures1;

/// ModuleTemperatures14 (181128F3) from BMS, every 500 ms.
pub type ModuleTemperatures14 = ModuleTemperatures1;

/// ModuleTemperatures15 (181228F3) from BMS, every 500 ms.
pub type ModuleTemperatures15 = ModuleTemperatures1;

/// ModuleTemperatures16 (181328F3) from BMS, every 500 ms.
pub type ModuleTemperatures16 = ModuleTemperatures1;

/// ModuleTemperatures17 (181428F3) from BMS, every 500 ms.
pub type ModuleTemperatures17 = ModuleTemperatures1;

/// ModuleTemperatures18 (181528F3) from BMS, every 500 ms.
pub type ModuleTemperatures18 = ModuleTemperatures1;

/// ModuleTemperatures19 (181628F3) from BMS, every 500 ms.
pub type ModuleTemperatures19 = ModuleTemperatures1;

/// ModuleTemperatures20 (181728F3) from BMS, every 500 ms.
pub type ModuleTemperatures20 = ModuleTemperatures1;

/// ModuleTemperatures21 (181828F3) from BMS, every 500 ms.
pub type ModuleTemperatures21 = ModuleTemperatures1;

/// ModuleTemperatures22 (181928F3) from BMS, every 500 ms.
pub type ModuleTemperatures22 = ModuleTemperatures1;

/// ModuleTemperatures23 (181A28F3) from BMS, every 500 ms.
pub type ModuleTemperatures23 = ModuleTemperatures1;

/// BMSFaults (181B28F3) from BMS, every 100 to 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BmsFaults(pub [u8; 8]);

impl Default for BmsFaults {
    fn default() -> Self { Self::new() }
}

impl BmsFaults {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `voltage_balance_fault` as sent: 1 bit from bit 0.
    #[inline(always)]
    pub const fn voltage_balance_fault_raw(self) -> u8 { self.0[0] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn voltage_balance_fault(self) -> Option<i32> {
        let raw = self.voltage_balance_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `voltage_balance_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_voltage_balance_fault_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `max_temperature_exceeded` as sent: 1 bit from bit 1.
    #[inline(always)]
    pub const fn max_temperature_exceeded_raw(self) -> u8 { self.0[0] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_exceeded(self) -> Option<i32> {
        let raw = self.max_temperature_exceeded_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `max_temperature_exceeded` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_exceeded_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `pack_voltage_exceeded` as sent: 1 bit from bit 2.
    #[inline(always)]
    pub const fn pack_voltage_exceeded_raw(self) -> u8 { self.0[0] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn pack_voltage_exceeded(self) -> Option<i32> {
        let raw = self.pack_voltage_exceeded_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `pack_voltage_exceeded` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_voltage_exceeded_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `negative_cut` as sent: 1 bit from bit 3.
    #[inline(always)]
    pub const fn negative_cut_raw(self) -> u8 { self.0[0] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn negative_cut(self) -> Option<i32> {
        let raw = self.negative_cut_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `negative_cut` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_cut_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `pack_current_exceeded` as sent: 1 bit from bit 4.
    #[inline(always)]
    pub const fn pack_current_exceeded_raw(self) -> u8 { self.0[0] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn pack_current_exceeded(self) -> Option<i32> {
        let raw = self.pack_current_exceeded_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `pack_current_exceeded` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_pack_current_exceeded_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `mean_voltage_exceeded` as sent: 1 bit from bit 5.
    #[inline(always)]
    pub const fn mean_voltage_exceeded_raw(self) -> u8 { self.0[0] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn mean_voltage_exceeded(self) -> Option<i32> {
        let raw = self.mean_voltage_exceeded_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `mean_voltage_exceeded` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_mean_voltage_exceeded_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `max_voltage_exceeded` as sent: 1 bit from bit 6.
    #[inline(always)]
    pub const fn max_voltage_exceeded_raw(self) -> u8 { self.0[0] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_exceeded(self) -> Option<i32> {
        let raw = self.max_voltage_exceeded_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `max_voltage_exceeded` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_exceeded_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `min_voltage_exceeded` as sent: 1 bit from bit 7.
    #[inline(always)]
    pub const fn min_voltage_exceeded_raw(self) -> u8 { self.0[0] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_exceeded(self) -> Option<i32> {
        let raw = self.min_voltage_exceeded_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `min_voltage_exceeded` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_exceeded_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `capacity_low` as sent: 1 bit from bit 8.
    #[inline(always)]
    pub const fn capacity_low_raw(self) -> u8 { self.0[1] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn capacity_low(self) -> Option<i32> {
        let raw = self.capacity_low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `capacity_low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_capacity_low_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `slave_no_response` as sent: 1 bit from bit 9.
    #[inline(always)]
    pub const fn slave_no_response_raw(self) -> u8 { self.0[1] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn slave_no_response(self) -> Option<i32> {
        let raw = self.slave_no_response_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `slave_no_response` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_slave_no_response_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `insulation_fault` as sent: 1 bit from bit 10.
    #[inline(always)]
    pub const fn insulation_fault_raw(self) -> u8 { self.0[1] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn insulation_fault(self) -> Option<i32> {
        let raw = self.insulation_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `insulation_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_insulation_fault_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `temperature_balance_fault` as sent: 1 bit from bit 11.
    #[inline(always)]
    pub const fn temperature_balance_fault_raw(self) -> u8 { self.0[1] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn temperature_balance_fault(self) -> Option<i32> {
        let raw = self.temperature_balance_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `temperature_balance_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_temperature_balance_fault_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `soc_jump` as sent: 1 bit from bit 12.
    #[inline(always)]
    pub const fn soc_jump_raw(self) -> u8 { self.0[1] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn soc_jump(self) -> Option<i32> {
        let raw = self.soc_jump_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `soc_jump` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_jump_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `storage_mismatch` as sent: 1 bit from bit 13.
    #[inline(always)]
    pub const fn storage_mismatch_raw(self) -> u8 { self.0[1] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn storage_mismatch(self) -> Option<i32> {
        let raw = self.storage_mismatch_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `storage_mismatch` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_storage_mismatch_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `overcharge` as sent: 1 bit from bit 14.
    #[inline(always)]
    pub const fn overcharge_raw(self) -> u8 { self.0[1] >> 6 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn overcharge(self) -> Option<i32> {
        let raw = self.overcharge_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `overcharge` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_overcharge_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xBF | (raw & 0x01) << 6;
        self
    }

    /// Returns `soc_high` as sent: 1 bit from bit 15.
    #[inline(always)]
    pub const fn soc_high_raw(self) -> u8 { self.0[1] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn soc_high(self) -> Option<i32> {
        let raw = self.soc_high_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `soc_high` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_soc_high_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0x7F | (raw & 0x01) << 7;
        self
    }

    /// Returns `series_cells` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn series_cells_raw(self) -> u8 { self.0[2] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn series_cells(self) -> Option<i32> {
        let raw = self.series_cells_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `series_cells` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_series_cells_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `capacity` as sent: 16 bits from bit 24.
    #[inline(always)]
    pub const fn capacity_raw(self) -> u16 { u16::from_le_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in Ah, 0 to 510; `None` if not valid.
    #[inline(always)]
    pub const fn capacity(self) -> Option<i32> {
        let raw = self.capacity_raw();
        if raw <= 510 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `capacity` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_capacity_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[4] = (raw >> 8) as u8;
        self
    }

    /// Returns `smoke_detector_1_fault` as sent: 1 bit from bit 40.
    #[inline(always)]
    pub const fn smoke_detector_1_fault_raw(self) -> u8 { self.0[5] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_detector_1_fault(self) -> Option<i32> {
        let raw = self.smoke_detector_1_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_detector_1_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_detector_1_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `smoke_detector_2_fault` as sent: 1 bit from bit 41.
    #[inline(always)]
    pub const fn smoke_detector_2_fault_raw(self) -> u8 { self.0[5] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_detector_2_fault(self) -> Option<i32> {
        let raw = self.smoke_detector_2_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_detector_2_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_detector_2_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `smoke_detector_3_fault` as sent: 1 bit from bit 42.
    #[inline(always)]
    pub const fn smoke_detector_3_fault_raw(self) -> u8 { self.0[5] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_detector_3_fault(self) -> Option<i32> {
        let raw = self.smoke_detector_3_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_detector_3_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_detector_3_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `smoke_detector_4_fault` as sent: 1 bit from bit 43.
    #[inline(always)]
    pub const fn smoke_detector_4_fault_raw(self) -> u8 { self.0[5] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_detector_4_fault(self) -> Option<i32> {
        let raw = self.smoke_detector_4_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_detector_4_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_detector_4_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `smoke_detector_5_fault` as sent: 1 bit from bit 44.
    #[inline(always)]
    pub const fn smoke_detector_5_fault_raw(self) -> u8 { self.0[5] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_detector_5_fault(self) -> Option<i32> {
        let raw = self.smoke_detector_5_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_detector_5_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_detector_5_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `smoke_detector_6_fault` as sent: 1 bit from bit 45.
    #[inline(always)]
    pub const fn smoke_detector_6_fault_raw(self) -> u8 { self.0[5] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_detector_6_fault(self) -> Option<i32> {
        let raw = self.smoke_detector_6_fault_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_detector_6_fault` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_detector_6_fault_raw(mut self, raw: u8) -> Self {
        self.0[5] = self.0[5] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `smoke_alarm_1` as sent: 1 bit from bit 48.
    #[inline(always)]
    pub const fn smoke_alarm_1_raw(self) -> u8 { self.0[6] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_alarm_1(self) -> Option<i32> {
        let raw = self.smoke_alarm_1_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_alarm_1` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_alarm_1_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFE | raw & 0x01;
        self
    }

    /// Returns `smoke_alarm_2` as sent: 1 bit from bit 49.
    #[inline(always)]
    pub const fn smoke_alarm_2_raw(self) -> u8 { self.0[6] >> 1 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_alarm_2(self) -> Option<i32> {
        let raw = self.smoke_alarm_2_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_alarm_2` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_alarm_2_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFD | (raw & 0x01) << 1;
        self
    }

    /// Returns `smoke_alarm_3` as sent: 1 bit from bit 50.
    #[inline(always)]
    pub const fn smoke_alarm_3_raw(self) -> u8 { self.0[6] >> 2 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_alarm_3(self) -> Option<i32> {
        let raw = self.smoke_alarm_3_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_alarm_3` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_alarm_3_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xFB | (raw & 0x01) << 2;
        self
    }

    /// Returns `smoke_alarm_4` as sent: 1 bit from bit 51.
    #[inline(always)]
    pub const fn smoke_alarm_4_raw(self) -> u8 { self.0[6] >> 3 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_alarm_4(self) -> Option<i32> {
        let raw = self.smoke_alarm_4_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_alarm_4` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_alarm_4_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xF7 | (raw & 0x01) << 3;
        self
    }

    /// Returns `smoke_alarm_5` as sent: 1 bit from bit 52.
    #[inline(always)]
    pub const fn smoke_alarm_5_raw(self) -> u8 { self.0[6] >> 4 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_alarm_5(self) -> Option<i32> {
        let raw = self.smoke_alarm_5_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_alarm_5` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_alarm_5_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xEF | (raw & 0x01) << 4;
        self
    }

    /// Returns `smoke_alarm_6` as sent: 1 bit from bit 53.
    #[inline(always)]
    pub const fn smoke_alarm_6_raw(self) -> u8 { self.0[6] >> 5 & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn smoke_alarm_6(self) -> Option<i32> {
        let raw = self.smoke_alarm_6_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `smoke_alarm_6` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_smoke_alarm_6_raw(mut self, raw: u8) -> Self {
        self.0[6] = self.0[6] & 0xDF | (raw & 0x01) << 5;
        self
    }

    /// Returns `negative_contactor_welded` as sent: 1 bit from bit 56.
    #[inline(always)]
    pub const fn negative_contactor_welded_raw(self) -> u8 { self.0[7] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn negative_contactor_welded(self) -> Option<i32> {
        let raw = self.negative_contactor_welded_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `negative_contactor_welded` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_negative_contactor_welded_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xFE | raw & 0x01;
        self
    }
}

/// BMSExtremes (181C28F3) from BMS, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BmsExtremes(pub [u8; 8]);

impl Default for BmsExtremes {
    fn default() -> Self { Self::new() }
}

impl BmsExtremes {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `max_cell_voltage` as sent: 16 bits down from bit 7.
    #[inline(always)]
    pub const fn max_cell_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[0], self.0[1]]) }
    /// Returns the value in 1/50 V, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn max_cell_voltage(self) -> Option<i32> {
        let raw = self.max_cell_voltage_raw();
        if raw <= 500 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `max_cell_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_cell_voltage_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[0] = (raw >> 8) as u8;
        self
    }

    /// Returns `min_cell_voltage` as sent: 16 bits down from bit 23.
    #[inline(always)]
    pub const fn min_cell_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[2], self.0[3]]) }
    /// Returns the value in 1/50 V, 0 to 500; `None` if not valid.
    #[inline(always)]
    pub const fn min_cell_voltage(self) -> Option<i32> {
        let raw = self.min_cell_voltage_raw();
        if raw <= 500 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `min_cell_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_cell_voltage_raw(mut self, raw: u16) -> Self {
        self.0[3] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
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
}

/// BMSExtremePositions (181D28F3) from BMS, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BmsExtremePositions(pub [u8; 8]);

impl Default for BmsExtremePositions {
    fn default() -> Self { Self::new() }
}

impl BmsExtremePositions {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `max_voltage_box` as sent: 8 bits from bit 0.
    #[inline(always)]
    pub const fn max_voltage_box_raw(self) -> u8 { self.0[0] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_box(self) -> Option<i32> {
        let raw = self.max_voltage_box_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `max_voltage_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_box_raw(mut self, raw: u8) -> Self {
        self.0[0] = raw;
        self
    }

    /// Returns `max_voltage_position` as sent: 8 bits from bit 8.
    #[inline(always)]
    pub const fn max_voltage_position_raw(self) -> u8 { self.0[1] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn max_voltage_position(self) -> Option<i32> {
        let raw = self.max_voltage_position_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `max_voltage_position` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_voltage_position_raw(mut self, raw: u8) -> Self {
        self.0[1] = raw;
        self
    }

    /// Returns `min_voltage_box` as sent: 8 bits from bit 16.
    #[inline(always)]
    pub const fn min_voltage_box_raw(self) -> u8 { self.0[2] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_box(self) -> Option<i32> {
        let raw = self.min_voltage_box_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `min_voltage_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_box_raw(mut self, raw: u8) -> Self {
        self.0[2] = raw;
        self
    }

    /// Returns `min_voltage_position` as sent: 8 bits from bit 24.
    #[inline(always)]
    pub const fn min_voltage_position_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn min_voltage_position(self) -> Option<i32> {
        let raw = self.min_voltage_position_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `min_voltage_position` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_voltage_position_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `max_temperature_box` as sent: 8 bits from bit 32.
    #[inline(always)]
    pub const fn max_temperature_box_raw(self) -> u8 { self.0[4] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_box(self) -> Option<i32> {
        let raw = self.max_temperature_box_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `max_temperature_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_box_raw(mut self, raw: u8) -> Self {
        self.0[4] = raw;
        self
    }

    /// Returns `max_temperature_position` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn max_temperature_position_raw(self) -> u8 { self.0[5] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn max_temperature_position(self) -> Option<i32> {
        let raw = self.max_temperature_position_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `max_temperature_position` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_max_temperature_position_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `min_temperature_box` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn min_temperature_box_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_box(self) -> Option<i32> {
        let raw = self.min_temperature_box_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `min_temperature_box` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_box_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `min_temperature_position` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn min_temperature_position_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn min_temperature_position(self) -> Option<i32> {
        let raw = self.min_temperature_position_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `min_temperature_position` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_min_temperature_position_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// Charger (180028E5) from OBC, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Charger(pub [u8; 8]);

impl Default for Charger {
    fn default() -> Self { Self::new() }
}

impl Charger {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

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

    /// Returns `output_voltage` as sent: 16 bits down from bit 15.
    #[inline(always)]
    pub const fn output_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[1], self.0[2]]) }
    /// Returns the value in 1/10 V, 0 to 10000; `None` if not valid.
    #[inline(always)]
    pub const fn output_voltage(self) -> Option<i32> {
        let raw = self.output_voltage_raw();
        if raw <= 10000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `output_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_voltage_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `output_current` as sent: 16 bits down from bit 31.
    #[inline(always)]
    pub const fn output_current_raw(self) -> u16 { u16::from_be_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in 1/10 A, -5000 to 5000; `None` if not valid.
    #[inline(always)]
    pub const fn output_current(self) -> Option<i32> {
        let raw = self.output_current_raw();
        if raw <= 10000 { Some(raw as i32 - 5000) } else { None }
    }
    /// Returns the frame with `output_current` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_output_current_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
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
}

/// Meter1 (1800D028) from Cluster, every 500 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meter1(pub [u8; 8]);

impl Default for Meter1 {
    fn default() -> Self { Self::new() }
}

impl Meter1 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

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

    /// Returns `aux_battery_voltage` as sent: 16 bits down from bit 15.
    #[inline(always)]
    pub const fn aux_battery_voltage_raw(self) -> u16 { u16::from_be_bytes([self.0[1], self.0[2]]) }
    /// Returns the value in 1/10 V, 0 to 1000; `None` if not valid.
    #[inline(always)]
    pub const fn aux_battery_voltage(self) -> Option<i32> {
        let raw = self.aux_battery_voltage_raw();
        if raw <= 1000 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `aux_battery_voltage` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_aux_battery_voltage_raw(mut self, raw: u16) -> Self {
        self.0[2] = raw as u8;
        self.0[1] = (raw >> 8) as u8;
        self
    }

    /// Returns `odometer_low` as sent: 16 bits down from bit 31.
    #[inline(always)]
    pub const fn odometer_low_raw(self) -> u16 { u16::from_be_bytes([self.0[3], self.0[4]]) }
    /// Returns the value in km, 0 to 65535; `None` if not valid.
    #[inline(always)]
    pub const fn odometer_low(self) -> Option<i32> {
        let raw = self.odometer_low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `odometer_low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_odometer_low_raw(mut self, raw: u16) -> Self {
        self.0[4] = raw as u8;
        self.0[3] = (raw >> 8) as u8;
        self
    }

    /// Returns `odometer_high` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn odometer_high_raw(self) -> u8 { self.0[5] }
    /// Returns the value in km, 0 to 16711680; `None` if not valid.
    #[inline(always)]
    pub const fn odometer_high(self) -> Option<i32> {
        let raw = self.odometer_high_raw();
        Some((raw as i32) * 65536)
    }
    /// Returns the frame with `odometer_high` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_odometer_high_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }

    /// Returns `hardware_version` as sent: 8 bits from bit 48.
    #[inline(always)]
    pub const fn hardware_version_raw(self) -> u8 { self.0[6] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn hardware_version(self) -> Option<i32> {
        let raw = self.hardware_version_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `hardware_version` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_hardware_version_raw(mut self, raw: u8) -> Self {
        self.0[6] = raw;
        self
    }

    /// Returns `software_version` as sent: 8 bits from bit 56.
    #[inline(always)]
    pub const fn software_version_raw(self) -> u8 { self.0[7] }
    /// Returns the value, 0 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn software_version(self) -> Option<i32> {
        let raw = self.software_version_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `software_version` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_software_version_raw(mut self, raw: u8) -> Self {
        self.0[7] = raw;
        self
    }
}

/// Meter2 (1801D028) from Cluster, every 1000 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meter2(pub [u8; 8]);

impl Default for Meter2 {
    fn default() -> Self { Self::new() }
}

impl Meter2 {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

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

    /// Returns `upgrade_forbidden` as sent: 1 bit from bit 8.
    #[inline(always)]
    pub const fn upgrade_forbidden_raw(self) -> u8 { self.0[1] & 0x01 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn upgrade_forbidden(self) -> Option<i32> {
        let raw = self.upgrade_forbidden_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `upgrade_forbidden` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_upgrade_forbidden_raw(mut self, raw: u8) -> Self {
        self.0[1] = self.0[1] & 0xFE | raw & 0x01;
        self
    }
}

/// Meter3 (1800F328) from Cluster, every 1000 ms.
pub type Meter3 = Meter2;

fn get_vcu1(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu1(data);
    Some(match index {
        0 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        1 => (frame.work_state_raw() as i64, frame.work_state().map(|value| value as i64)),
        2 => (frame.vcu_fault_level_raw() as i64, frame.vcu_fault_level().map(|value| value as i64)),
        3 => (frame.vacuum_fault_raw() as i64, frame.vacuum_fault().map(|value| value as i64)),
        4 => (frame.aux_battery_low_raw() as i64, frame.aux_battery_low().map(|value| value as i64)),
        5 => (frame.dcdc_fault_raw() as i64, frame.dcdc_fault().map(|value| value as i64)),
        6 => (frame.accelerator_pedal_raw() as i64, frame.accelerator_pedal().map(|value| value as i64)),
        7 => (frame.brake_pedal_raw() as i64, frame.brake_pedal().map(|value| value as i64)),
        8 => (frame.torque_raw() as i64, frame.torque().map(|value| value as i64)),
        9 => (frame.motor_temperature_raw() as i64, frame.motor_temperature().map(|value| value as i64)),
        10 => (frame.water_pump_raw() as i64, frame.water_pump().map(|value| value as i64)),
        11 => (frame.fan_low_raw() as i64, frame.fan_low().map(|value| value as i64)),
        12 => (frame.fan_high_raw() as i64, frame.fan_high().map(|value| value as i64)),
        13 => (frame.air_pump_raw() as i64, frame.air_pump().map(|value| value as i64)),
        14 => (frame.air_conditioning_raw() as i64, frame.air_conditioning().map(|value| value as i64)),
        15 => (frame.handbrake_raw() as i64, frame.handbrake().map(|value| value as i64)),
        16 => (frame.foot_brake_raw() as i64, frame.foot_brake().map(|value| value as i64)),
        17 => (frame.economy_mode_raw() as i64, frame.economy_mode().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu1(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu1(data);
    match index {
        0 => frame.with_life_raw(raw as u8).0,
        1 => frame.with_work_state_raw(raw as u8).0,
        2 => frame.with_vcu_fault_level_raw(raw as u8).0,
        3 => frame.with_vacuum_fault_raw(raw as u8).0,
        4 => frame.with_aux_battery_low_raw(raw as u8).0,
        5 => frame.with_dcdc_fault_raw(raw as u8).0,
        6 => frame.with_accelerator_pedal_raw(raw as u8).0,
        7 => frame.with_brake_pedal_raw(raw as u8).0,
        8 => frame.with_torque_raw(raw as u16).0,
        9 => frame.with_motor_temperature_raw(raw as u8).0,
        10 => frame.with_water_pump_raw(raw as u8).0,
        11 => frame.with_fan_low_raw(raw as u8).0,
        12 => frame.with_fan_high_raw(raw as u8).0,
        13 => frame.with_air_pump_raw(raw as u8).0,
        14 => frame.with_air_conditioning_raw(raw as u8).0,
        15 => frame.with_handbrake_raw(raw as u8).0,
        16 => frame.with_foot_brake_raw(raw as u8).0,
        17 => frame.with_economy_mode_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu2(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu2(data);
    Some(match index {
        0 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        1 => (frame.gear_raw() as i64, frame.gear().map(|value| value as i64)),
        2 => (frame.front_ptc_fan_raw() as i64, frame.front_ptc_fan().map(|value| value as i64)),
        3 => (frame.rear_ptc_fan_raw() as i64, frame.rear_ptc_fan().map(|value| value as i64)),
        4 => (frame.charge_state_raw() as i64, frame.charge_state().map(|value| value as i64)),
        5 => (frame.vehicle_mode_raw() as i64, frame.vehicle_mode().map(|value| value as i64)),
        6 => (frame.motor_fault_level_raw() as i64, frame.motor_fault_level().map(|value| value as i64)),
        7 => (frame.battery_fault_level_raw() as i64, frame.battery_fault_level().map(|value| value as i64)),
        8 => (frame.vcu_fault_level_raw() as i64, frame.vcu_fault_level().map(|value| value as i64)),
        9 => (frame.water_pump_fault_raw() as i64, frame.water_pump_fault().map(|value| value as i64)),
        10 => (frame.fan_fault_raw() as i64, frame.fan_fault().map(|value| value as i64)),
        11 => (frame.air_pump_fault_raw() as i64, frame.air_pump_fault().map(|value| value as i64)),
        12 => (frame.aux_battery_low_raw() as i64, frame.aux_battery_low().map(|value| value as i64)),
        13 => (frame.shift_failed_raw() as i64, frame.shift_failed().map(|value| value as i64)),
        14 => (frame.controller_temperature_raw() as i64, frame.controller_temperature().map(|value| value as i64)),
        15 => (frame.vacuum_raw() as i64, frame.vacuum().map(|value| value as i64)),
        16 => (frame.soc_raw() as i64, frame.soc().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu2(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu2(data);
    match index {
        0 => frame.with_life_raw(raw as u8).0,
        1 => frame.with_gear_raw(raw as u8).0,
        2 => frame.with_front_ptc_fan_raw(raw as u8).0,
        3 => frame.with_rear_ptc_fan_raw(raw as u8).0,
        4 => frame.with_charge_state_raw(raw as u8).0,
        5 => frame.with_vehicle_mode_raw(raw as u8).0,
        6 => frame.with_motor_fault_level_raw(raw as u8).0,
        7 => frame.with_battery_fault_level_raw(raw as u8).0,
        8 => frame.with_vcu_fault_level_raw(raw as u8).0,
        9 => frame.with_water_pump_fault_raw(raw as u8).0,
        10 => frame.with_fan_fault_raw(raw as u8).0,
        11 => frame.with_air_pump_fault_raw(raw as u8).0,
        12 => frame.with_aux_battery_low_raw(raw as u8).0,
        13 => frame.with_shift_failed_raw(raw as u8).0,
        14 => frame.with_controller_temperature_raw(raw as u8).0,
        15 => frame.with_vacuum_raw(raw as u8).0,
        16 => frame.with_soc_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu3(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu3(data);
    Some(match index {
        0 => (frame.vehicle_speed_raw() as i64, frame.vehicle_speed().map(|value| value as i64)),
        1 => (frame.remaining_range_raw() as i64, frame.remaining_range().map(|value| value as i64)),
        2 => (frame.motor_speed_raw() as i64, frame.motor_speed().map(|value| value as i64)),
        3 => (frame.igbt_protection_raw() as i64, frame.igbt_protection().map(|value| value as i64)),
        4 => (frame.drive_supply_undervoltage_raw() as i64, frame.drive_supply_undervoltage().map(|value| value as i64)),
        5 => (frame.bridge_shoot_through_raw() as i64, frame.bridge_shoot_through().map(|value| value as i64)),
        6 => (frame.igbt_over_temperature_raw() as i64, frame.igbt_over_temperature().map(|value| value as i64)),
        7 => (frame.motor_over_temperature_raw() as i64, frame.motor_over_temperature().map(|value| value as i64)),
        8 => (frame.bus_overcurrent_raw() as i64, frame.bus_overcurrent().map(|value| value as i64)),
        9 => (frame.phase_overcurrent_raw() as i64, frame.phase_overcurrent().map(|value| value as i64)),
        10 => (frame.control_undervoltage_raw() as i64, frame.control_undervoltage().map(|value| value as i64)),
        11 => (frame.control_reversed_raw() as i64, frame.control_reversed().map(|value| value as i64)),
        12 => (frame.control_overvoltage_raw() as i64, frame.control_overvoltage().map(|value| value as i64)),
        13 => (frame.dq_overcurrent_raw() as i64, frame.dq_overcurrent().map(|value| value as i64)),
        14 => (frame.bus_undervoltage_raw() as i64, frame.bus_undervoltage().map(|value| value as i64)),
        15 => (frame.bus_overvoltage_raw() as i64, frame.bus_overvoltage().map(|value| value as i64)),
        16 => (frame.over_torque_raw() as i64, frame.over_torque().map(|value| value as i64)),
        17 => (frame.overload_raw() as i64, frame.overload().map(|value| value as i64)),
        18 => (frame.stall_raw() as i64, frame.stall().map(|value| value as i64)),
        19 => (frame.driver_over_temperature_raw() as i64, frame.driver_over_temperature().map(|value| value as i64)),
        20 => (frame.overspeed_raw() as i64, frame.overspeed().map(|value| value as i64)),
        21 => (frame.can_fault_raw() as i64, frame.can_fault().map(|value| value as i64)),
        22 => (frame.back_emf_raw() as i64, frame.back_emf().map(|value| value as i64)),
        23 => (frame.phase_loss_raw() as i64, frame.phase_loss().map(|value| value as i64)),
        24 => (frame.resolver_fault_raw() as i64, frame.resolver_fault().map(|value| value as i64)),
        25 => (frame.hardware_shutdown_raw() as i64, frame.hardware_shutdown().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu3(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu3(data);
    match index {
        0 => frame.with_vehicle_speed_raw(raw as u8).0,
        1 => frame.with_remaining_range_raw(raw as u16).0,
        2 => frame.with_motor_speed_raw(raw as u16).0,
        3 => frame.with_igbt_protection_raw(raw as u8).0,
        4 => frame.with_drive_supply_undervoltage_raw(raw as u8).0,
        5 => frame.with_bridge_shoot_through_raw(raw as u8).0,
        6 => frame.with_igbt_over_temperature_raw(raw as u8).0,
        7 => frame.with_motor_over_temperature_raw(raw as u8).0,
        8 => frame.with_bus_overcurrent_raw(raw as u8).0,
        9 => frame.with_phase_overcurrent_raw(raw as u8).0,
        10 => frame.with_control_undervoltage_raw(raw as u8).0,
        11 => frame.with_control_reversed_raw(raw as u8).0,
        12 => frame.with_control_overvoltage_raw(raw as u8).0,
        13 => frame.with_dq_overcurrent_raw(raw as u8).0,
        14 => frame.with_bus_undervoltage_raw(raw as u8).0,
        15 => frame.with_bus_overvoltage_raw(raw as u8).0,
        16 => frame.with_over_torque_raw(raw as u8).0,
        17 => frame.with_overload_raw(raw as u8).0,
        18 => frame.with_stall_raw(raw as u8).0,
        19 => frame.with_driver_over_temperature_raw(raw as u8).0,
        20 => frame.with_overspeed_raw(raw as u8).0,
        21 => frame.with_can_fault_raw(raw as u8).0,
        22 => frame.with_back_emf_raw(raw as u8).0,
        23 => frame.with_phase_loss_raw(raw as u8).0,
        24 => frame.with_resolver_fault_raw(raw as u8).0,
        25 => frame.with_hardware_shutdown_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu4(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu4(data);
    Some(match index {
        0 => (frame.motor_voltage_raw() as i64, frame.motor_voltage().map(|value| value as i64)),
        1 => (frame.phase_current_raw() as i64, frame.phase_current().map(|value| value as i64)),
        2 => (frame.phase_voltage_raw() as i64, frame.phase_voltage().map(|value| value as i64)),
        3 => (frame.air_pressure_1_raw() as i64, frame.air_pressure_1().map(|value| value as i64)),
        4 => (frame.air_pressure_2_raw() as i64, frame.air_pressure_2().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu4(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu4(data);
    match index {
        0 => frame.with_motor_voltage_raw(raw as u16).0,
        1 => frame.with_phase_current_raw(raw as u16).0,
        2 => frame.with_phase_voltage_raw(raw as u16).0,
        3 => frame.with_air_pressure_1_raw(raw as u8).0,
        4 => frame.with_air_pressure_2_raw(raw as u8).0,
        _ => data,
    }
}

fn get_vcu5(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Vcu5(data);
    Some(match index {
        0 => (frame.hardware_version_raw() as i64, frame.hardware_version().map(|value| value as i64)),
        1 => (frame.software_version_raw() as i64, frame.software_version().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_vcu5(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Vcu5(data);
    match index {
        0 => frame.with_hardware_version_raw(raw as u8).0,
        1 => frame.with_software_version_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms_status(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = BmsStatus(data);
    Some(match index {
        0 => (frame.pack_voltage_raw() as i64, frame.pack_voltage().map(|value| value as i64)),
        1 => (frame.pack_current_raw() as i64, frame.pack_current().map(|value| value as i64)),
        2 => (frame.soc_raw() as i64, frame.soc().map(|value| value as i64)),
        3 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        4 => (frame.battery_fault_level_raw() as i64, frame.battery_fault_level().map(|value| value as i64)),
        5 => (frame.insulation_fault_level_raw() as i64, frame.insulation_fault_level().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms_status(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = BmsStatus(data);
    match index {
        0 => frame.with_pack_voltage_raw(raw as u16).0,
        1 => frame.with_pack_current_raw(raw as u16).0,
        2 => frame.with_soc_raw(raw as u8).0,
        3 => frame.with_life_raw(raw as u8).0,
        4 => frame.with_battery_fault_level_raw(raw as u8).0,
        5 => frame.with_insulation_fault_level_raw(raw as u8).0,
        _ => data,
    }
}

fn get_cell_voltages1(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = CellVoltages1(data);
    Some(match index {
        0 => (frame.number_1_raw() as i64, frame.number_1().map(|value| value as i64)),
        1 => (frame.voltage_1_raw() as i64, frame.voltage_1().map(|value| value as i64)),
        2 => (frame.number_2_raw() as i64, frame.number_2().map(|value| value as i64)),
        3 => (frame.voltage_2_raw() as i64, frame.voltage_2().map(|value| value as i64)),
        4 => (frame.number_3_raw() as i64, frame.number_3().map(|value| value as i64)),
        5 => (frame.voltage_3_raw() as i64, frame.voltage_3().map(|value| value as i64)),
        6 => (frame.number_4_raw() as i64, frame.number_4().map(|value| value as i64)),
        7 => (frame.voltage_4_raw() as i64, frame.voltage_4().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_cell_voltages1(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = CellVoltages1(data);
    match index {
        0 => frame.with_number_1_raw(raw as u8).0,
        1 => frame.with_voltage_1_raw(raw as u8).0,
        2 => frame.with_number_2_raw(raw as u8).0,
        3 => frame.with_voltage_2_raw(raw as u8).0,
        4 => frame.with_number_3_raw(raw as u8).0,
        5 => frame.with_voltage_3_raw(raw as u8).0,
        6 => frame.with_number_4_raw(raw as u8).0,
        7 => frame.with_voltage_4_raw(raw as u8).0,
        _ => data,
    }
}

fn get_module_temperatures1(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = ModuleTemperatures1(data);
    Some(match index {
        0 => (frame.temperature_1_raw() as i64, frame.temperature_1().map(|value| value as i64)),
        1 => (frame.temperature_2_raw() as i64, frame.temperature_2().map(|value| value as i64)),
        2 => (frame.temperature_3_raw() as i64, frame.temperature_3().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_module_temperatures1(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = ModuleTemperatures1(data);
    match index {
        0 => frame.with_temperature_1_raw(raw as u8).0,
        1 => frame.with_temperature_2_raw(raw as u8).0,
        2 => frame.with_temperature_3_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms_faults(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = BmsFaults(data);
    Some(match index {
        0 => (frame.voltage_balance_fault_raw() as i64, frame.voltage_balance_fault().map(|value| value as i64)),
        1 => (frame.max_temperature_exceeded_raw() as i64, frame.max_temperature_exceeded().map(|value| value as i64)),
        2 => (frame.pack_voltage_exceeded_raw() as i64, frame.pack_voltage_exceeded().map(|value| value as i64)),
        3 => (frame.negative_cut_raw() as i64, frame.negative_cut().map(|value| value as i64)),
        4 => (frame.pack_current_exceeded_raw() as i64, frame.pack_current_exceeded().map(|value| value as i64)),
        5 => (frame.mean_voltage_exceeded_raw() as i64, frame.mean_voltage_exceeded().map(|value| value as i64)),
        6 => (frame.max_voltage_exceeded_raw() as i64, frame.max_voltage_exceeded().map(|value| value as i64)),
        7 => (frame.min_voltage_exceeded_raw() as i64, frame.min_voltage_exceeded().map(|value| value as i64)),
        8 => (frame.capacity_low_raw() as i64, frame.capacity_low().map(|value| value as i64)),
        9 => (frame.slave_no_response_raw() as i64, frame.slave_no_response().map(|value| value as i64)),
        10 => (frame.insulation_fault_raw() as i64, frame.insulation_fault().map(|value| value as i64)),
        11 => (frame.temperature_balance_fault_raw() as i64, frame.temperature_balance_fault().map(|value| value as i64)),
        12 => (frame.soc_jump_raw() as i64, frame.soc_jump().map(|value| value as i64)),
        13 => (frame.storage_mismatch_raw() as i64, frame.storage_mismatch().map(|value| value as i64)),
        14 => (frame.overcharge_raw() as i64, frame.overcharge().map(|value| value as i64)),
        15 => (frame.soc_high_raw() as i64, frame.soc_high().map(|value| value as i64)),
        16 => (frame.series_cells_raw() as i64, frame.series_cells().map(|value| value as i64)),
        17 => (frame.capacity_raw() as i64, frame.capacity().map(|value| value as i64)),
        18 => (frame.smoke_detector_1_fault_raw() as i64, frame.smoke_detector_1_fault().map(|value| value as i64)),
        19 => (frame.smoke_detector_2_fault_raw() as i64, frame.smoke_detector_2_fault().map(|value| value as i64)),
        20 => (frame.smoke_detector_3_fault_raw() as i64, frame.smoke_detector_3_fault().map(|value| value as i64)),
        21 => (frame.smoke_detector_4_fault_raw() as i64, frame.smoke_detector_4_fault().map(|value| value as i64)),
        22 => (frame.smoke_detector_5_fault_raw() as i64, frame.smoke_detector_5_fault().map(|value| value as i64)),
        23 => (frame.smoke_detector_6_fault_raw() as i64, frame.smoke_detector_6_fault().map(|value| value as i64)),
        24 => (frame.smoke_alarm_1_raw() as i64, frame.smoke_alarm_1().map(|value| value as i64)),
        25 => (frame.smoke_alarm_2_raw() as i64, frame.smoke_alarm_2().map(|value| value as i64)),
        26 => (frame.smoke_alarm_3_raw() as i64, frame.smoke_alarm_3().map(|value| value as i64)),
        27 => (frame.smoke_alarm_4_raw() as i64, frame.smoke_alarm_4().map(|value| value as i64)),
        28 => (frame.smoke_alarm_5_raw() as i64, frame.smoke_alarm_5().map(|value| value as i64)),
        29 => (frame.smoke_alarm_6_raw() as i64, frame.smoke_alarm_6().map(|value| value as i64)),
        30 => (frame.negative_contactor_welded_raw() as i64, frame.negative_contactor_welded().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms_faults(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = BmsFaults(data);
    match index {
        0 => frame.with_voltage_balance_fault_raw(raw as u8).0,
        1 => frame.with_max_temperature_exceeded_raw(raw as u8).0,
        2 => frame.with_pack_voltage_exceeded_raw(raw as u8).0,
        3 => frame.with_negative_cut_raw(raw as u8).0,
        4 => frame.with_pack_current_exceeded_raw(raw as u8).0,
        5 => frame.with_mean_voltage_exceeded_raw(raw as u8).0,
        6 => frame.with_max_voltage_exceeded_raw(raw as u8).0,
        7 => frame.with_min_voltage_exceeded_raw(raw as u8).0,
        8 => frame.with_capacity_low_raw(raw as u8).0,
        9 => frame.with_slave_no_response_raw(raw as u8).0,
        10 => frame.with_insulation_fault_raw(raw as u8).0,
        11 => frame.with_temperature_balance_fault_raw(raw as u8).0,
        12 => frame.with_soc_jump_raw(raw as u8).0,
        13 => frame.with_storage_mismatch_raw(raw as u8).0,
        14 => frame.with_overcharge_raw(raw as u8).0,
        15 => frame.with_soc_high_raw(raw as u8).0,
        16 => frame.with_series_cells_raw(raw as u8).0,
        17 => frame.with_capacity_raw(raw as u16).0,
        18 => frame.with_smoke_detector_1_fault_raw(raw as u8).0,
        19 => frame.with_smoke_detector_2_fault_raw(raw as u8).0,
        20 => frame.with_smoke_detector_3_fault_raw(raw as u8).0,
        21 => frame.with_smoke_detector_4_fault_raw(raw as u8).0,
        22 => frame.with_smoke_detector_5_fault_raw(raw as u8).0,
        23 => frame.with_smoke_detector_6_fault_raw(raw as u8).0,
        24 => frame.with_smoke_alarm_1_raw(raw as u8).0,
        25 => frame.with_smoke_alarm_2_raw(raw as u8).0,
        26 => frame.with_smoke_alarm_3_raw(raw as u8).0,
        27 => frame.with_smoke_alarm_4_raw(raw as u8).0,
        28 => frame.with_smoke_alarm_5_raw(raw as u8).0,
        29 => frame.with_smoke_alarm_6_raw(raw as u8).0,
        30 => frame.with_negative_contactor_welded_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms_extremes(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = BmsExtremes(data);
    Some(match index {
        0 => (frame.max_cell_voltage_raw() as i64, frame.max_cell_voltage().map(|value| value as i64)),
        1 => (frame.min_cell_voltage_raw() as i64, frame.min_cell_voltage().map(|value| value as i64)),
        2 => (frame.max_temperature_raw() as i64, frame.max_temperature().map(|value| value as i64)),
        3 => (frame.min_temperature_raw() as i64, frame.min_temperature().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms_extremes(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = BmsExtremes(data);
    match index {
        0 => frame.with_max_cell_voltage_raw(raw as u16).0,
        1 => frame.with_min_cell_voltage_raw(raw as u16).0,
        2 => frame.with_max_temperature_raw(raw as u8).0,
        3 => frame.with_min_temperature_raw(raw as u8).0,
        _ => data,
    }
}

fn get_bms_extreme_positions(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = BmsExtremePositions(data);
    Some(match index {
        0 => (frame.max_voltage_box_raw() as i64, frame.max_voltage_box().map(|value| value as i64)),
        1 => (frame.max_voltage_position_raw() as i64, frame.max_voltage_position().map(|value| value as i64)),
        2 => (frame.min_voltage_box_raw() as i64, frame.min_voltage_box().map(|value| value as i64)),
        3 => (frame.min_voltage_position_raw() as i64, frame.min_voltage_position().map(|value| value as i64)),
        4 => (frame.max_temperature_box_raw() as i64, frame.max_temperature_box().map(|value| value as i64)),
        5 => (frame.max_temperature_position_raw() as i64, frame.max_temperature_position().map(|value| value as i64)),
        6 => (frame.min_temperature_box_raw() as i64, frame.min_temperature_box().map(|value| value as i64)),
        7 => (frame.min_temperature_position_raw() as i64, frame.min_temperature_position().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_bms_extreme_positions(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = BmsExtremePositions(data);
    match index {
        0 => frame.with_max_voltage_box_raw(raw as u8).0,
        1 => frame.with_max_voltage_position_raw(raw as u8).0,
        2 => frame.with_min_voltage_box_raw(raw as u8).0,
        3 => frame.with_min_voltage_position_raw(raw as u8).0,
        4 => frame.with_max_temperature_box_raw(raw as u8).0,
        5 => frame.with_max_temperature_position_raw(raw as u8).0,
        6 => frame.with_min_temperature_box_raw(raw as u8).0,
        7 => frame.with_min_temperature_position_raw(raw as u8).0,
        _ => data,
    }
}

fn get_charger(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Charger(data);
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
        _ => return None,
    })
}

fn set_charger(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Charger(data);
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
        _ => data,
    }
}

fn get_meter1(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Meter1(data);
    Some(match index {
        0 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        1 => (frame.aux_battery_voltage_raw() as i64, frame.aux_battery_voltage().map(|value| value as i64)),
        2 => (frame.odometer_low_raw() as i64, frame.odometer_low().map(|value| value as i64)),
        3 => (frame.odometer_high_raw() as i64, frame.odometer_high().map(|value| value as i64)),
        4 => (frame.hardware_version_raw() as i64, frame.hardware_version().map(|value| value as i64)),
        5 => (frame.software_version_raw() as i64, frame.software_version().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_meter1(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Meter1(data);
    match index {
        0 => frame.with_life_raw(raw as u8).0,
        1 => frame.with_aux_battery_voltage_raw(raw as u16).0,
        2 => frame.with_odometer_low_raw(raw as u16).0,
        3 => frame.with_odometer_high_raw(raw as u8).0,
        4 => frame.with_hardware_version_raw(raw as u8).0,
        5 => frame.with_software_version_raw(raw as u8).0,
        _ => data,
    }
}

fn get_meter2(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Meter2(data);
    Some(match index {
        0 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        1 => (frame.upgrade_forbidden_raw() as i64, frame.upgrade_forbidden().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_meter2(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Meter2(data);
    match index {
        0 => frame.with_life_raw(raw as u8).0,
        1 => frame.with_upgrade_forbidden_raw(raw as u8).0,
        _ => data,
    }
}

static VCU1_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "life", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
    SignalInfo { name: "work_state", start: 8, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "not_ready"), (1, "ready")] },
    SignalInfo { name: "vcu_fault_level", start: 11, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2"), (3, "level_3")] },
    SignalInfo { name: "vacuum_fault", start: 13, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "aux_battery_low", start: 14, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "dcdc_fault", start: 15, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "accelerator_pedal", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "brake_pedal", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "torque", start: 39, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: -30000, den: 10 }, unit: "Nm", range: (0, 60000), start_raw: 30000, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "motor_temperature", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "water_pump", start: 56, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "fan_low", start: 57, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "fan_high", start: 58, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "air_pump", start: 59, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "air_conditioning", start: 60, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "handbrake", start: 61, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "foot_brake", start: 62, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "off"), (1, "on")] },
    SignalInfo { name: "economy_mode", start: 63, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "power"), (1, "economy")] },
];

static VCU2_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "life", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
    SignalInfo { name: "gear", start: 8, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 0, invalid_raw: Some(3), mux: Mux::Always, life: None, values: &[(0, "N"), (1, "D"), (2, "R"), (3, "invalid")] },
    SignalInfo { name: "front_ptc_fan", start: 10, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 3, invalid_raw: Some(3), mux: Mux::Always, life: None, values: &[(0, "speed_1"), (1, "speed_2"), (2, "speed_3"), (3, "invalid")] },
    SignalInfo { name: "rear_ptc_fan", start: 12, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 2), start_raw: 3, invalid_raw: Some(3), mux: Mux::Always, life: None, values: &[(0, "speed_1"), (1, "speed_2"), (2, "speed_3"), (3, "invalid")] },
    SignalInfo { name: "charge_state", start: 16, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "connected"), (2, "charging"), (3, "stopped")] },
    SignalInfo { name: "vehicle_mode", start: 18, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 4), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "park"), (1, "park_charging"), (2, "electric_drive"), (3, "regeneration"), (4, "limp")] },
    SignalInfo { name: "motor_fault_level", start: 24, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2"), (3, "level_3")] },
    SignalInfo { name: "battery_fault_level", start: 26, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2"), (3, "level_3")] },
    SignalInfo { name: "vcu_fault_level", start: 28, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2"), (3, "level_3")] },
    SignalInfo { name: "water_pump_fault", start: 32, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "fan_fault", start: 33, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "low_speed"), (2, "high_speed"), (3, "all")] },
    SignalInfo { name: "air_pump_fault", start: 35, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "aux_battery_low", start: 36, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "shift_failed", start: 37, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "controller_temperature", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "vacuum", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 100 }, unit: "bar", range: (0, 200), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "soc", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static VCU3_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "vehicle_speed", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "km/h", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "remaining_range", start: 15, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "km", range: (0, 65535), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "motor_speed", start: 31, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: -15000, den: 1 }, unit: "rpm", range: (0, 30000), start_raw: 15000, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "igbt_protection", start: 40, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "drive_supply_undervoltage", start: 41, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "bridge_shoot_through", start: 42, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "igbt_over_temperature", start: 43, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "motor_over_temperature", start: 44, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "bus_overcurrent", start: 45, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "phase_overcurrent", start: 46, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "control_undervoltage", start: 47, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "control_reversed", start: 48, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "control_overvoltage", start: 49, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "dq_overcurrent", start: 50, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "bus_undervoltage", start: 51, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "bus_overvoltage", start: 52, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "over_torque", start: 53, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "overload", start: 54, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "stall", start: 55, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "driver_over_temperature", start: 56, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "overspeed", start: 57, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "can_fault", start: 58, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "back_emf", start: 59, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "phase_loss", start: 60, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "resolver_fault", start: 61, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
    SignalInfo { name: "hardware_shutdown", start: 62, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "protection")] },
];

static VCU4_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "motor_voltage", start: 7, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "phase_current", start: 23, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: -5000, den: 10 }, unit: "A", range: (0, 10000), start_raw: 5000, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "phase_voltage", start: 39, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "V", range: (0, 600), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "air_pressure_1", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "bar", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "air_pressure_2", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "bar", range: (0, 254), start_raw: 0, invalid_raw: Some(255), mux: Mux::Always, life: None, values: &[] },
];

static VCU5_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "hardware_version", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "software_version", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static BMS_STATUS_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "pack_voltage", start: 7, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "pack_current", start: 23, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: -5000, den: 10 }, unit: "A", range: (0, 10000), start_raw: 5000, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "soc", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 0, den: 5 }, unit: "%", range: (0, 250), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "life", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
    SignalInfo { name: "battery_fault_level", start: 48, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2"), (3, "level_3")] },
    SignalInfo { name: "insulation_fault_level", start: 50, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2"), (3, "level_3")] },
];

static CELL_VOLTAGES1_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "number_1", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "voltage_1", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 50 }, unit: "V", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "number_2", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "voltage_2", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 50 }, unit: "V", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "number_3", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "voltage_3", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 50 }, unit: "V", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "number_4", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "voltage_4", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 50 }, unit: "V", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static MODULE_TEMPERATURES1_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "temperature_1", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "temperature_2", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "temperature_3", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static BMS_FAULTS_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "voltage_balance_fault", start: 0, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "max_temperature_exceeded", start: 1, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "pack_voltage_exceeded", start: 2, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "negative_cut", start: 3, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "pack_current_exceeded", start: 4, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "mean_voltage_exceeded", start: 5, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "max_voltage_exceeded", start: 6, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "min_voltage_exceeded", start: 7, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "capacity_low", start: 8, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "slave_no_response", start: 9, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "insulation_fault", start: 10, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "temperature_balance_fault", start: 11, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "soc_jump", start: 12, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "storage_mismatch", start: 13, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "overcharge", start: 14, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "soc_high", start: 15, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "series_cells", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "capacity", start: 24, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "Ah", range: (0, 510), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "smoke_detector_1_fault", start: 40, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "smoke_detector_2_fault", start: 41, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "smoke_detector_3_fault", start: 42, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "smoke_detector_4_fault", start: 43, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "smoke_detector_5_fault", start: 44, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "smoke_detector_6_fault", start: 45, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "smoke_alarm_1", start: 48, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "alarm")] },
    SignalInfo { name: "smoke_alarm_2", start: 49, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "alarm")] },
    SignalInfo { name: "smoke_alarm_3", start: 50, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "alarm")] },
    SignalInfo { name: "smoke_alarm_4", start: 51, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "alarm")] },
    SignalInfo { name: "smoke_alarm_5", start: 52, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "alarm")] },
    SignalInfo { name: "smoke_alarm_6", start: 53, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "alarm")] },
    SignalInfo { name: "negative_contactor_welded", start: 56, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
];

static BMS_EXTREMES_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "max_cell_voltage", start: 7, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 50 }, unit: "V", range: (0, 500), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_cell_voltage", start: 23, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 50 }, unit: "V", range: (0, 500), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 1 }, unit: "°C", range: (0, 250), start_raw: 40, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static BMS_EXTREME_POSITIONS_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "max_voltage_box", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_voltage_position", start: 8, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_box", start: 16, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_voltage_position", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_box", start: 32, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "max_temperature_position", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_box", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "min_temperature_position", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static CHARGER_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "life", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
    SignalInfo { name: "output_voltage", start: 15, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 10000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "output_current", start: 31, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: -5000, den: 10 }, unit: "A", range: (0, 10000), start_raw: 5000, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "hardware_fault", start: 40, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "over_temperature", start: 41, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "input_voltage_fault", start: 42, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "start_inhibited", start: 43, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "no"), (1, "yes")] },
    SignalInfo { name: "communication_fault", start: 44, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "ok"), (1, "fault")] },
    SignalInfo { name: "fault_level", start: 45, length: 2, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 3), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "level_1"), (2, "level_2"), (3, "level_3")] },
];

static METER1_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "life", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
    SignalInfo { name: "aux_battery_voltage", start: 15, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 1000), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "odometer_low", start: 31, length: 16, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "km", range: (0, 65535), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "odometer_high", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 65536, add: 0, den: 1 }, unit: "km", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "hardware_version", start: 48, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "software_version", start: 56, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static METER2_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "life", start: 0, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From0To255), values: &[] },
    SignalInfo { name: "upgrade_forbidden", start: 8, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 1, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "allowed"), (1, "forbidden")] },
];

/// Every message of the vehicle, in the order of the DBC: for tools.
pub static MESSAGES: &[MessageInfo] = &[
    MessageInfo { id: CanId::extended(0x180228D0), name: "VCU1", sender: "VCU", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_vcu1, set: set_vcu1, signals: VCU1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180328D0), name: "VCU2", sender: "VCU", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_vcu2, set: set_vcu2, signals: VCU2_SIGNALS },
    MessageInfo { id: CanId::extended(0x180428D0), name: "VCU3", sender: "VCU", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_vcu3, set: set_vcu3, signals: VCU3_SIGNALS },
    MessageInfo { id: CanId::extended(0x180528D0), name: "VCU4", sender: "VCU", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_vcu4, set: set_vcu4, signals: VCU4_SIGNALS },
    MessageInfo { id: CanId::extended(0x180628D0), name: "VCU5", sender: "VCU", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_vcu5, set: set_vcu5, signals: VCU5_SIGNALS },
    MessageInfo { id: CanId::extended(0x180228F3), name: "BMSStatus", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms_status, set: set_bms_status, signals: BMS_STATUS_SIGNALS },
    MessageInfo { id: CanId::extended(0x18E628F3), name: "CellVoltages1", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18E528F3), name: "CellVoltages2", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18E428F3), name: "CellVoltages3", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18E328F3), name: "CellVoltages4", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18E228F3), name: "CellVoltages5", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18E128F3), name: "CellVoltages6", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18E028F3), name: "CellVoltages7", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18DF28F3), name: "CellVoltages8", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18DE28F3), name: "CellVoltages9", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18DD28F3), name: "CellVoltages10", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18DC28F3), name: "CellVoltages11", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18DB28F3), name: "CellVoltages12", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18DA28F3), name: "CellVoltages13", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D928F3), name: "CellVoltages14", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D828F3), name: "CellVoltages15", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D728F3), name: "CellVoltages16", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D628F3), name: "CellVoltages17", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D528F3), name: "CellVoltages18", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D428F3), name: "CellVoltages19", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D328F3), name: "CellVoltages20", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D228F3), name: "CellVoltages21", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D128F3), name: "CellVoltages22", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18D028F3), name: "CellVoltages23", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18CF28F3), name: "CellVoltages24", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18CE28F3), name: "CellVoltages25", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18CD28F3), name: "CellVoltages26", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18CC28F3), name: "CellVoltages27", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18CB28F3), name: "CellVoltages28", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18CA28F3), name: "CellVoltages29", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C928F3), name: "CellVoltages30", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C828F3), name: "CellVoltages31", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C728F3), name: "CellVoltages32", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C628F3), name: "CellVoltages33", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C528F3), name: "CellVoltages34", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C428F3), name: "CellVoltages35", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C328F3), name: "CellVoltages36", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C228F3), name: "CellVoltages37", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C128F3), name: "CellVoltages38", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18C028F3), name: "CellVoltages39", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18BF28F3), name: "CellVoltages40", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18BE28F3), name: "CellVoltages41", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18BD28F3), name: "CellVoltages42", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18BC28F3), name: "CellVoltages43", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18BB28F3), name: "CellVoltages44", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18BA28F3), name: "CellVoltages45", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B928F3), name: "CellVoltages46", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B828F3), name: "CellVoltages47", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B728F3), name: "CellVoltages48", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B628F3), name: "CellVoltages49", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B528F3), name: "CellVoltages50", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B428F3), name: "CellVoltages51", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B328F3), name: "CellVoltages52", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B228F3), name: "CellVoltages53", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B128F3), name: "CellVoltages54", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18B028F3), name: "CellVoltages55", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18AF28F3), name: "CellVoltages56", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18AE28F3), name: "CellVoltages57", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18AD28F3), name: "CellVoltages58", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18AC28F3), name: "CellVoltages59", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18AB28F3), name: "CellVoltages60", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18AA28F3), name: "CellVoltages61", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18A928F3), name: "CellVoltages62", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18A828F3), name: "CellVoltages63", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x18A728F3), name: "CellVoltages64", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_cell_voltages1, set: set_cell_voltages1, signals: CELL_VOLTAGES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180428F3), name: "ModuleTemperatures1", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180528F3), name: "ModuleTemperatures2", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180628F3), name: "ModuleTemperatures3", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180728F3), name: "ModuleTemperatures4", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180828F3), name: "ModuleTemperatures5", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180928F3), name: "ModuleTemperatures6", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180A28F3), name: "ModuleTemperatures7", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180B28F3), name: "ModuleTemperatures8", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180C28F3), name: "ModuleTemperatures9", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180D28F3), name: "ModuleTemperatures10", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180E28F3), name: "ModuleTemperatures11", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x180F28F3), name: "ModuleTemperatures12", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181028F3), name: "ModuleTemperatures13", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181128F3), name: "ModuleTemperatures14", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181228F3), name: "ModuleTemperatures15", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181328F3), name: "ModuleTemperatures16", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181428F3), name: "ModuleTemperatures17", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181528F3), name: "ModuleTemperatures18", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181628F3), name: "ModuleTemperatures19", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181728F3), name: "ModuleTemperatures20", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181828F3), name: "ModuleTemperatures21", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181928F3), name: "ModuleTemperatures22", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181A28F3), name: "ModuleTemperatures23", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: true, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_module_temperatures1, set: set_module_temperatures1, signals: MODULE_TEMPERATURES1_SIGNALS },
    MessageInfo { id: CanId::extended(0x181B28F3), name: "BMSFaults", sender: "BMS", len: 8, cycle_ms: 100, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms_faults, set: set_bms_faults, signals: BMS_FAULTS_SIGNALS },
    MessageInfo { id: CanId::extended(0x181C28F3), name: "BMSExtremes", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms_extremes, set: set_bms_extremes, signals: BMS_EXTREMES_SIGNALS },
    MessageInfo { id: CanId::extended(0x181D28F3), name: "BMSExtremePositions", sender: "BMS", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_bms_extreme_positions, set: set_bms_extreme_positions, signals: BMS_EXTREME_POSITIONS_SIGNALS },
    MessageInfo { id: CanId::extended(0x180028E5), name: "Charger", sender: "OBC", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_charger, set: set_charger, signals: CHARGER_SIGNALS },
    MessageInfo { id: CanId::extended(0x1800D028), name: "Meter1", sender: "Cluster", len: 8, cycle_ms: 500, slow_cycle_ms: 500, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_meter1, set: set_meter1, signals: METER1_SIGNALS },
    MessageInfo { id: CanId::extended(0x1801D028), name: "Meter2", sender: "Cluster", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_meter2, set: set_meter2, signals: METER2_SIGNALS },
    MessageInfo { id: CanId::extended(0x1800F328), name: "Meter3", sender: "Cluster", len: 8, cycle_ms: 1000, slow_cycle_ms: 1000, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_meter2, set: set_meter2, signals: METER2_SIGNALS },
];

static RX: &[RxMessage] = &[
    RxMessage { id: CanId::extended(0x180028E5), name: "Charger", node: Node::Charger, len: 8, cycle_ms: 1000, timeout_ms: 5000, life: Some(Life { byte: 0, mask: 0xFF }), checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x180228D0), name: "VCU1", node: Node::Vcu, len: 8, cycle_ms: 500, timeout_ms: 2500, life: Some(Life { byte: 0, mask: 0xFF }), checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x180228F3), name: "BMSStatus", node: Node::Bms, len: 8, cycle_ms: 500, timeout_ms: 2500, life: Some(Life { byte: 5, mask: 0xFF }), checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x180328D0), name: "VCU2", node: Node::Vcu, len: 8, cycle_ms: 500, timeout_ms: 2500, life: Some(Life { byte: 0, mask: 0xFF }), checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x180428D0), name: "VCU3", node: Node::Vcu, len: 8, cycle_ms: 500, timeout_ms: 2500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x180428F3), name: "ModuleTemperatures1", node: Node::Bms, len: 8, cycle_ms: 500, timeout_ms: 2500, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x180528D0), name: "VCU4", node: Node::Vcu, len: 8, cycle_ms: 500, timeout_ms: 2500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x181B28F3), name: "BMSFaults", node: Node::Bms, len: 8, cycle_ms: 100, timeout_ms: 2500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x181C28F3), name: "BMSExtremes", node: Node::Bms, len: 8, cycle_ms: 500, timeout_ms: 2500, life: None, checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x181D28F3), name: "BMSExtremePositions", node: Node::Bms, len: 8, cycle_ms: 500, timeout_ms: 2500, life: None, checksum: None, expected: false, vital: false },
    RxMessage { id: CanId::extended(0x18E628F3), name: "CellVoltages1", node: Node::Bms, len: 8, cycle_ms: 500, timeout_ms: 2500, life: None, checksum: None, expected: false, vital: false },
];

static TX: &[TxMessage] = &[
    TxMessage { id: CanId::extended(0x1800D028), name: "Meter1", cycle_ms: 500, life: Some(Life { byte: 0, mask: 0xFF }), checksum: None },
    TxMessage { id: CanId::extended(0x1800F328), name: "Meter3", cycle_ms: 1000, life: Some(Life { byte: 0, mask: 0xFF }), checksum: None },
    TxMessage { id: CanId::extended(0x1801D028), name: "Meter2", cycle_ms: 1000, life: Some(Life { byte: 0, mask: 0xFF }), checksum: None },
];

/// Texts of the fault codes, sorted by source and code.
pub static FAULTS: &[FaultText] = &[
    FaultText { source: Node::Vcu, code: 1, severity: None, fire: false, limps: false, zh: "电机IGBT保护", en: "Motor IGBT" },
    FaultText { source: Node::Vcu, code: 2, severity: None, fire: false, limps: false, zh: "电机驱动电源欠压", en: "Driver undervoltage" },
    FaultText { source: Node::Vcu, code: 3, severity: None, fire: false, limps: false, zh: "电机上下桥直通", en: "Bridge shoot-through" },
    FaultText { source: Node::Vcu, code: 4, severity: None, fire: false, limps: false, zh: "电机IGBT过温", en: "IGBT too hot" },
    FaultText { source: Node::Vcu, code: 5, severity: None, fire: false, limps: false, zh: "电机过温", en: "Motor too hot" },
    FaultText { source: Node::Vcu, code: 6, severity: None, fire: false, limps: false, zh: "电机母线电流过流", en: "DC overcurrent" },
    FaultText { source: Node::Vcu, code: 7, severity: None, fire: false, limps: false, zh: "电机相电流过流", en: "Phase overcurrent" },
    FaultText { source: Node::Vcu, code: 8, severity: None, fire: false, limps: false, zh: "电机控制电压欠压", en: "Control undervoltage" },
    FaultText { source: Node::Vcu, code: 9, severity: None, fire: false, limps: false, zh: "电机控制电压反接", en: "Control supply reversed" },
    FaultText { source: Node::Vcu, code: 10, severity: None, fire: false, limps: false, zh: "电机控制器过压", en: "Control overvoltage" },
    FaultText { source: Node::Vcu, code: 11, severity: None, fire: false, limps: false, zh: "电机dq电流过流", en: "dq overcurrent" },
    FaultText { source: Node::Vcu, code: 12, severity: None, fire: false, limps: false, zh: "电机母线电压欠压", en: "DC undervoltage" },
    FaultText { source: Node::Vcu, code: 13, severity: None, fire: false, limps: false, zh: "电机母线电压过压", en: "DC overvoltage" },
    FaultText { source: Node::Vcu, code: 14, severity: None, fire: false, limps: false, zh: "电机过扭矩", en: "Motor over torque" },
    FaultText { source: Node::Vcu, code: 15, severity: None, fire: false, limps: false, zh: "电机过载", en: "Motor overload" },
    FaultText { source: Node::Vcu, code: 16, severity: None, fire: false, limps: false, zh: "电机堵转", en: "Motor stalled" },
    FaultText { source: Node::Vcu, code: 17, severity: None, fire: false, limps: false, zh: "电机驱动板过温", en: "Driver board hot" },
    FaultText { source: Node::Vcu, code: 18, severity: None, fire: false, limps: false, zh: "电机超速", en: "Motor overspeed" },
    FaultText { source: Node::Vcu, code: 19, severity: None, fire: false, limps: false, zh: "电机CAN通讯故障", en: "Motor CAN fault" },
    FaultText { source: Node::Vcu, code: 20, severity: None, fire: false, limps: false, zh: "电机反电动势保护", en: "Back EMF" },
    FaultText { source: Node::Vcu, code: 21, severity: None, fire: false, limps: false, zh: "电机缺相", en: "Motor phase loss" },
    FaultText { source: Node::Vcu, code: 22, severity: None, fire: false, limps: false, zh: "电机旋变故障", en: "Motor resolver fault" },
    FaultText { source: Node::Vcu, code: 23, severity: None, fire: false, limps: false, zh: "电机硬件关断", en: "Motor hardware off" },
    FaultText { source: Node::Bms, code: 1, severity: None, fire: false, limps: false, zh: "电池电压均衡故障", en: "Cell voltages uneven" },
    FaultText { source: Node::Bms, code: 2, severity: None, fire: false, limps: false, zh: "单节最高温度超限", en: "Cell too hot" },
    FaultText { source: Node::Bms, code: 3, severity: None, fire: false, limps: false, zh: "总电压超限", en: "Pack voltage limit" },
    FaultText { source: Node::Bms, code: 4, severity: None, fire: false, limps: false, zh: "切断主负", en: "Main negative cut" },
    FaultText { source: Node::Bms, code: 5, severity: None, fire: false, limps: false, zh: "总电流超限", en: "Pack current limit" },
    FaultText { source: Node::Bms, code: 6, severity: None, fire: false, limps: false, zh: "平均电压超限", en: "Mean voltage limit" },
    FaultText { source: Node::Bms, code: 7, severity: None, fire: false, limps: false, zh: "单节最高电压超限", en: "Cell overvoltage" },
    FaultText { source: Node::Bms, code: 8, severity: None, fire: false, limps: false, zh: "单节最低电压超限", en: "Cell undervoltage" },
    FaultText { source: Node::Bms, code: 9, severity: None, fire: false, limps: false, zh: "容量低报警", en: "Capacity low" },
    FaultText { source: Node::Bms, code: 10, severity: None, fire: false, limps: false, zh: "下位机无响应报警", en: "Battery slave lost" },
    FaultText { source: Node::Bms, code: 11, severity: None, fire: false, limps: false, zh: "绝缘故障", en: "Insulation fault" },
    FaultText { source: Node::Bms, code: 12, severity: None, fire: false, limps: false, zh: "电池温度均衡故障", en: "Temperatures uneven" },
    FaultText { source: Node::Bms, code: 13, severity: None, fire: false, limps: false, zh: "SOC跳变故障", en: "Charge reading jumped" },
    FaultText { source: Node::Bms, code: 14, severity: None, fire: false, limps: false, zh: "充电储能系统不匹配故障", en: "Charger mismatch" },
    FaultText { source: Node::Bms, code: 15, severity: None, fire: false, limps: false, zh: "过充报警故障", en: "Overcharge" },
    FaultText { source: Node::Bms, code: 16, severity: None, fire: false, limps: false, zh: "SOC过高故障", en: "Charge too high" },
    FaultText { source: Node::Bms, code: 17, severity: Some(Severity::Derate), fire: false, limps: false, zh: "烟雾报警器1设备故障", en: "Smoke detector 1 fault" },
    FaultText { source: Node::Bms, code: 18, severity: Some(Severity::Derate), fire: false, limps: false, zh: "烟雾报警器2设备故障", en: "Smoke detector 2 fault" },
    FaultText { source: Node::Bms, code: 19, severity: Some(Severity::Derate), fire: false, limps: false, zh: "烟雾报警器3设备故障", en: "Smoke detector 3 fault" },
    FaultText { source: Node::Bms, code: 20, severity: Some(Severity::Derate), fire: false, limps: false, zh: "烟雾报警器4设备故障", en: "Smoke detector 4 fault" },
    FaultText { source: Node::Bms, code: 21, severity: Some(Severity::Derate), fire: false, limps: false, zh: "烟雾报警器5设备故障", en: "Smoke detector 5 fault" },
    FaultText { source: Node::Bms, code: 22, severity: Some(Severity::Derate), fire: false, limps: false, zh: "烟雾报警器6设备故障", en: "Smoke detector 6 fault" },
    FaultText { source: Node::Bms, code: 23, severity: Some(Severity::Stop), fire: false, limps: false, zh: "烟雾报警1", en: "Smoke alarm 1" },
    FaultText { source: Node::Bms, code: 24, severity: Some(Severity::Stop), fire: false, limps: false, zh: "烟雾报警2", en: "Smoke alarm 2" },
    FaultText { source: Node::Bms, code: 25, severity: Some(Severity::Stop), fire: false, limps: false, zh: "烟雾报警3", en: "Smoke alarm 3" },
    FaultText { source: Node::Bms, code: 26, severity: Some(Severity::Stop), fire: false, limps: false, zh: "烟雾报警4", en: "Smoke alarm 4" },
    FaultText { source: Node::Bms, code: 27, severity: Some(Severity::Stop), fire: false, limps: false, zh: "烟雾报警5", en: "Smoke alarm 5" },
    FaultText { source: Node::Bms, code: 28, severity: Some(Severity::Stop), fire: false, limps: false, zh: "烟雾报警6", en: "Smoke alarm 6" },
    FaultText { source: Node::Bms, code: 29, severity: None, fire: false, limps: false, zh: "总负接触器粘连故障", en: "Main negative welded" },
];

static NODES: &[NodeName] = &[
    NodeName { node: Node::Vcu, zh: "整车控制器", en: "Vehicle controller" },
    NodeName { node: Node::Bms, zh: "电池系统", en: "Battery" },
    NodeName { node: Node::Charger, zh: "充电机", en: "Charger" },
    NodeName { node: Node::Cluster, zh: "仪表", en: "Cluster" },
];

static STREAMS: &[Stream] = &[
    Stream { name: "cells", row: 10, first: CanId::extended(0x18E628F3), step: -65536, frames: 64, len: 8, zeros_pad: true, start: 0, size: 256, valid: (0, 255),
        scale: Scale { mul: 20, add: 0, den: 1 },
        cells: &[Cell { number: Some(0), value: 1 }, Cell { number: Some(2), value: 3 }, Cell { number: Some(4), value: 5 }, Cell { number: Some(6), value: 7 }],
        bound: Bound { highest: Some(Value::BatteryCellMax), lowest: Some(Value::BatteryCellMin), highest_number: Some(Value::BatteryCellMaxNumber), lowest_number: Some(Value::BatteryCellMinNumber), count: Some(Value::BatteryCellCount) } },
    Stream { name: "modules", row: 5, first: CanId::extended(0x180428F3), step: 65536, frames: 23, len: 8, zeros_pad: false, start: 256, size: 69, valid: (0, 250),
        scale: Scale { mul: 1, add: -40, den: 1 },
        cells: &[Cell { number: None, value: 0 }, Cell { number: None, value: 1 }, Cell { number: None, value: 2 }],
        bound: Bound { highest: Some(Value::BatteryTemperatureMax), lowest: Some(Value::BatteryTemperatureMin), highest_number: Some(Value::BatteryTemperatureMaxModule), lowest_number: Some(Value::BatteryTemperatureMinModule), count: Some(Value::BatteryTemperatureCount) } },
];

static IDS: &[CanId] = &[
    CanId::extended(0x180028E5),
    CanId::extended(0x180228D0),
    CanId::extended(0x180228F3),
    CanId::extended(0x180328D0),
    CanId::extended(0x180428D0),
    CanId::extended(0x180428F3),
    CanId::extended(0x180528D0),
    CanId::extended(0x180528F3),
    CanId::extended(0x180628D0),
    CanId::extended(0x180628F3),
    CanId::extended(0x180728F3),
    CanId::extended(0x180828F3),
    CanId::extended(0x180928F3),
    CanId::extended(0x180A28F3),
    CanId::extended(0x180B28F3),
    CanId::extended(0x180C28F3),
    CanId::extended(0x180D28F3),
    CanId::extended(0x180E28F3),
    CanId::extended(0x180F28F3),
    CanId::extended(0x181028F3),
    CanId::extended(0x181128F3),
    CanId::extended(0x181228F3),
    CanId::extended(0x181328F3),
    CanId::extended(0x181428F3),
    CanId::extended(0x181528F3),
    CanId::extended(0x181628F3),
    CanId::extended(0x181728F3),
    CanId::extended(0x181828F3),
    CanId::extended(0x181928F3),
    CanId::extended(0x181A28F3),
    CanId::extended(0x181B28F3),
    CanId::extended(0x181C28F3),
    CanId::extended(0x181D28F3),
    CanId::extended(0x18A728F3),
    CanId::extended(0x18A828F3),
    CanId::extended(0x18A928F3),
    CanId::extended(0x18AA28F3),
    CanId::extended(0x18AB28F3),
    CanId::extended(0x18AC28F3),
    CanId::extended(0x18AD28F3),
    CanId::extended(0x18AE28F3),
    CanId::extended(0x18AF28F3),
    CanId::extended(0x18B028F3),
    CanId::extended(0x18B128F3),
    CanId::extended(0x18B228F3),
    CanId::extended(0x18B328F3),
    CanId::extended(0x18B428F3),
    CanId::extended(0x18B528F3),
    CanId::extended(0x18B628F3),
    CanId::extended(0x18B728F3),
    CanId::extended(0x18B828F3),
    CanId::extended(0x18B928F3),
    CanId::extended(0x18BA28F3),
    CanId::extended(0x18BB28F3),
    CanId::extended(0x18BC28F3),
    CanId::extended(0x18BD28F3),
    CanId::extended(0x18BE28F3),
    CanId::extended(0x18BF28F3),
    CanId::extended(0x18C028F3),
    CanId::extended(0x18C128F3),
    CanId::extended(0x18C228F3),
    CanId::extended(0x18C328F3),
    CanId::extended(0x18C428F3),
    CanId::extended(0x18C528F3),
    CanId::extended(0x18C628F3),
    CanId::extended(0x18C728F3),
    CanId::extended(0x18C828F3),
    CanId::extended(0x18C928F3),
    CanId::extended(0x18CA28F3),
    CanId::extended(0x18CB28F3),
    CanId::extended(0x18CC28F3),
    CanId::extended(0x18CD28F3),
    CanId::extended(0x18CE28F3),
    CanId::extended(0x18CF28F3),
    CanId::extended(0x18D028F3),
    CanId::extended(0x18D128F3),
    CanId::extended(0x18D228F3),
    CanId::extended(0x18D328F3),
    CanId::extended(0x18D428F3),
    CanId::extended(0x18D528F3),
    CanId::extended(0x18D628F3),
    CanId::extended(0x18D728F3),
    CanId::extended(0x18D828F3),
    CanId::extended(0x18D928F3),
    CanId::extended(0x18DA28F3),
    CanId::extended(0x18DB28F3),
    CanId::extended(0x18DC28F3),
    CanId::extended(0x18DD28F3),
    CanId::extended(0x18DE28F3),
    CanId::extended(0x18DF28F3),
    CanId::extended(0x18E028F3),
    CanId::extended(0x18E128F3),
    CanId::extended(0x18E228F3),
    CanId::extended(0x18E328F3),
    CanId::extended(0x18E428F3),
    CanId::extended(0x18E528F3),
    CanId::extended(0x18E628F3),
];

fn decode_charger(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Charger(*data);
    let raw = frame.output_voltage_raw();
    readings.put(source, Value::ChargerVoltage, raw as i32, raw <= 10000);
    let raw = frame.output_current_raw();
    readings.put(source, Value::ChargerCurrent, (raw as i32 - 5000).abs(), raw <= 10000);
    let state = STATES_0[(frame.fault_level_raw() & 3) as usize];
    readings.put(source, Value::ChargerFaultLevel, state, state != INVALID);
    let set = frame.0[5] & 0x1F != 0;
    readings.put(source, Value::ChargerFault, set as i32, true);
}

fn decode_vcu1(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Vcu1(*data);
    let state = STATES_1[(frame.work_state_raw() & 7) as usize];
    readings.put(source, Value::VehicleReady, state, state != INVALID);
    let raw = frame.accelerator_pedal_raw();
    readings.put(source, Value::VehicleAccelerator, (raw as i32) * 4, raw <= 250);
    let raw = frame.brake_pedal_raw();
    readings.put(source, Value::VehicleBrake, (raw as i32) * 4, raw <= 250);
    let raw = frame.foot_brake_raw();
    readings.put(source, Value::VehicleFootBrake, raw as i32, true);
    let state = STATES_0[(frame.vcu_fault_level_raw() & 3) as usize];
    readings.put(source, Value::VehicleControllerLevel, state, state != INVALID);
    let raw = frame.economy_mode_raw();
    readings.put(source, Value::VehicleEconomy, raw as i32, true);
    let raw = frame.aux_battery_low_raw();
    readings.put(source, Value::VehicleSupplyLow, raw as i32, true);
    let raw = frame.vacuum_fault_raw();
    readings.put(source, Value::BrakeVacuumFault, raw as i32, true);
    let raw = frame.torque_raw();
    readings.put(source, Value::MotorTorque, raw as i32 - 30000, raw <= 60000);
    let raw = frame.motor_temperature_raw();
    readings.put(source, Value::MotorTemperature, raw as i32 - 40, raw <= 250);
    let raw = frame.dcdc_fault_raw();
    readings.put(source, Value::DcdcFault, raw as i32, true);
    let raw = frame.air_pump_raw();
    readings.put(source, Value::CompressorState, raw as i32, true);
    let raw = frame.air_conditioning_raw();
    readings.put(source, Value::HvacOn, raw as i32, true);
    let raw = frame.handbrake_raw();
    readings.put(source, Value::BodyParkingBrake, raw as i32, true);
}

fn decode_bms_status(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = BmsStatus(*data);
    let raw = frame.pack_voltage_raw();
    readings.put(source, Value::BatteryVoltage, raw as i32, raw <= 10000);
    let raw = frame.pack_current_raw();
    readings.put(source, Value::BatteryCurrent, raw as i32 - 5000, raw <= 10000);
    let raw = frame.soc_raw();
    readings.put(source, Value::BatterySoc, (raw as i32) * 4, raw <= 250);
    let state = STATES_0[(frame.battery_fault_level_raw() & 3) as usize];
    readings.put(source, Value::BatteryFaultLevel, state, state != INVALID);
    let state = STATES_0[(frame.insulation_fault_level_raw() & 3) as usize];
    readings.put(source, Value::InsulationLevel, state, state != INVALID);
}

fn decode_vcu2(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Vcu2(*data);
    let state = STATES_2[(frame.gear_raw() & 3) as usize];
    readings.put(source, Value::VehicleGear, state, state != INVALID);
    let state = STATES_3[(frame.vehicle_mode_raw() & 7) as usize];
    readings.put(source, Value::VehicleMode, state, state != INVALID);
    let state = STATES_0[(frame.vcu_fault_level_raw() & 3) as usize];
    readings.put(source, Value::VehicleFaultLevel, state, state != INVALID);
    let state = STATES_0[(frame.battery_fault_level_raw() & 3) as usize];
    readings.put(source, Value::VehicleBatteryLevel, state, state != INVALID);
    let raw = frame.soc_raw();
    readings.put(source, Value::VehicleSoc, (raw as i32) * 4, raw <= 250);
    let raw = frame.shift_failed_raw();
    readings.put(source, Value::VehicleShiftFailed, raw as i32, true);
    let raw = frame.vacuum_raw();
    readings.put(source, Value::BrakeVacuum, raw as i32, raw <= 200);
    let state = STATES_4[(frame.charge_state_raw() & 3) as usize];
    readings.put(source, Value::ChargeState, state, state != INVALID);
    let state = STATES_5[(frame.charge_state_raw() & 3) as usize];
    readings.put(source, Value::ChargePlug, state, state != INVALID);
    let state = STATES_0[(frame.motor_fault_level_raw() & 3) as usize];
    readings.put(source, Value::MotorFaultLevel, state, state != INVALID);
    let raw = frame.controller_temperature_raw();
    readings.put(source, Value::InverterTemperature, raw as i32 - 40, raw <= 250);
    let raw = frame.air_pump_fault_raw();
    readings.put(source, Value::CompressorFault, raw as i32, true);
    let raw = frame.water_pump_fault_raw();
    readings.put(source, Value::CoolingPumpFault, raw as i32, true);
    let state = STATES_5[(frame.fan_fault_raw() & 3) as usize];
    readings.put(source, Value::CoolingFanFault, state, state != INVALID);
    let raw = frame.aux_battery_low_raw();
    readings.put(source, Value::SupplyLow, raw as i32, true);
}

fn decode_vcu3(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Vcu3(*data);
    let raw = frame.vehicle_speed_raw();
    readings.put(source, Value::VehicleSpeed, (raw as i32) * 256, true);
    let raw = frame.remaining_range_raw();
    readings.put(source, Value::VehicleRange, (raw as i32) * 8, true);
    let raw = frame.motor_speed_raw();
    readings.put(source, Value::MotorSpeed, raw as i32 - 15000, raw <= 30000);
    readings.put(source, Value::MotorAlarms, frame.0[5] as i32 | (frame.0[6] as i32) << 8 | ((frame.0[7] & 0x7F) as i32) << 16, true);
}

fn decode_module_temperatures1(_source: u8, _data: &[u8; 8], _readings: &mut Readings) {
}

fn decode_vcu4(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Vcu4(*data);
    let raw = frame.phase_current_raw();
    readings.put(source, Value::MotorPhaseCurrent, (raw as i32 - 5000).abs(), raw <= 10000);
    let raw = frame.motor_voltage_raw();
    readings.put(source, Value::InverterVoltage, raw as i32, raw <= 10000);
    let raw = frame.air_pressure_1_raw();
    readings.put(source, Value::AirFront, raw as i32, raw <= 254);
    let raw = frame.air_pressure_2_raw();
    readings.put(source, Value::AirRear, raw as i32, raw <= 254);
}

fn decode_bms_faults(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = BmsFaults(*data);
    readings.put(source, Value::BatteryAlarms, frame.0[0] as i32 | (frame.0[1] as i32) << 8 | ((frame.0[5] & 0x3F) as i32) << 16 | ((frame.0[6] & 0x3F) as i32) << 22 | ((frame.0[7] & 0x01) as i32) << 28, true);
    let raw = frame.capacity_raw();
    readings.put(source, Value::BatteryCapacity, raw as i32, raw <= 510);
    let set = frame.0[6] & 0x3F != 0;
    readings.put(source, Value::BatterySmoke, set as i32, true);
    let set = frame.0[5] & 0x3F != 0;
    readings.put(source, Value::BatterySmokeDetectorFault, set as i32, true);
    let raw = frame.negative_cut_raw();
    readings.put(source, Value::BatteryNegativeCut, raw as i32, true);
    let state = STATES_6[(frame.negative_contactor_welded_raw() & 1) as usize];
    readings.put(source, Value::ContactorNegative, state, state != INVALID);
    let raw = frame.insulation_fault_raw();
    readings.put(source, Value::InsulationFault, raw as i32, true);
}

fn decode_bms_extremes(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = BmsExtremes(*data);
    let raw = frame.max_cell_voltage_raw();
    readings.put(source, Value::BatteryCellMax, (raw as i32) * 20, raw <= 500);
    let raw = frame.min_cell_voltage_raw();
    readings.put(source, Value::BatteryCellMin, (raw as i32) * 20, raw <= 500);
    let raw = frame.max_temperature_raw();
    readings.put(source, Value::BatteryTemperatureMax, raw as i32 - 40, raw <= 250);
    let raw = frame.min_temperature_raw();
    readings.put(source, Value::BatteryTemperatureMin, raw as i32 - 40, raw <= 250);
}

fn decode_bms_extreme_positions(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = BmsExtremePositions(*data);
    let raw = frame.max_voltage_box_raw();
    readings.put(source, Value::BatteryCellMaxBox, raw as i32, true);
    let raw = frame.max_voltage_position_raw();
    readings.put(source, Value::BatteryCellMaxCell, raw as i32, true);
    let raw = frame.min_voltage_box_raw();
    readings.put(source, Value::BatteryCellMinBox, raw as i32, true);
    let raw = frame.min_voltage_position_raw();
    readings.put(source, Value::BatteryCellMinCell, raw as i32, true);
    let raw = frame.max_temperature_box_raw();
    readings.put(source, Value::BatteryTemperatureMaxBox, raw as i32, true);
    let raw = frame.min_temperature_box_raw();
    readings.put(source, Value::BatteryTemperatureMinBox, raw as i32, true);
}

fn decode_cell_voltages1(_source: u8, _data: &[u8; 8], _readings: &mut Readings) {
}

static STATES_0: [i32; 4] = [0, 3, 2, 1];

static STATES_1: [i32; 8] = [0, 1, 0, 0, 0, 0, 0, 0];

static STATES_2: [i32; 4] = [3, 1, 2, INVALID];

static STATES_3: [i32; 8] = [1, 1, 2, 2, 5, INVALID, INVALID, INVALID];

static STATES_4: [i32; 4] = [0, 0, 1, 0];

static STATES_5: [i32; 4] = [0, 1, 1, 1];

static STATES_6: [i32; 2] = [INVALID, 2];

static DECODERS: [fn(u8, &[u8; 8], &mut Readings); 11] = [
    decode_charger,
    decode_vcu1,
    decode_bms_status,
    decode_vcu2,
    decode_vcu3,
    decode_module_temperatures1,
    decode_vcu4,
    decode_bms_faults,
    decode_bms_extremes,
    decode_bms_extreme_positions,
    decode_cell_voltages1,
];

fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    if let Some(decode) = DECODERS.get(index as usize) {
        decode(index, data, readings);
    }
}

fn encode_meter1(values: &Readings) -> [u8; 8] {
    let frame = Meter1::new();
    let frame = frame.with_aux_battery_voltage_raw(codec::known(values, Value::SupplyVoltage).map_or(0, |number| codec::scaled(number, 1, 0, 1, 0, 1000) as u16));
    let frame = frame.with_odometer_low_raw(codec::known(values, Value::ClusterOdometer).map_or(0, |number| (codec::scaled(number, 1, 0, 8, 0, 4294967295) & 0xFFFF) as u16));
    let frame = frame.with_odometer_high_raw(codec::known(values, Value::ClusterOdometer).map_or(0, |number| codec::scaled(number, 1, 0, 524288, 0, 255) as u8));
    let frame = frame.with_hardware_version_raw(codec::known(values, Value::ClusterHardware).map_or(0, |number| codec::scaled(number, 1, 0, 1, 0, 255) as u8));
    let frame = frame.with_software_version_raw(codec::known(values, Value::ClusterSoftware).map_or(0, |number| codec::scaled(number, 1, 0, 1, 0, 255) as u8));
    frame.0
}

fn encode_meter3(values: &Readings) -> [u8; 8] {
    let frame = Meter3::new();
    let frame = frame.with_upgrade_forbidden_raw(codec::known(values, Value::ClusterUpgradeForbidden).map_or(1, |state| (state != 0) as u8));
    frame.0
}

fn encode_meter2(values: &Readings) -> [u8; 8] {
    let frame = Meter2::new();
    let frame = frame.with_upgrade_forbidden_raw(codec::known(values, Value::ClusterUpgradeForbidden).map_or(1, |state| (state != 0) as u8));
    frame.0
}

fn encode(index: u8, values: &Readings) -> [u8; 8] {
    match index {
        0 => encode_meter1(values),
        1 => encode_meter3(values),
        2 => encode_meter2(values),
        _ => [0; 8],
    }
}

/// Jiulong electric bus (九龙纯电动客车).
pub static VEHICLE: Vehicle = Vehicle {
    name: "jiulong",
    zh: "九龙纯电动客车",
    en: "Jiulong electric bus",
    bitrate: 250000,
    worst_level: 1,
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
