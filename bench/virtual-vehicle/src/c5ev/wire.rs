//! The car: what every node but the cluster tells.
//!
//! Tables only. The charger broadcasts as long as it is plugged in (C5-R004, R005). The motor command is a torque; with
//! the cruise control on it is a speed, in the same bytes (C5-R015). The bytes that the source lost (C5-01) stay 0.
//! Source: the C5EV document, readings C5-01 to C5-44.

use crate::bms;
use crate::bus::rows::{Row, Sheet, bit, fixed, flag, value};
use crate::bus::truth::{alarm, gear, heard_soc, pack_amps, pack_volts, plugged, soc, speed, word};
use crate::bus::unprinted::{MOTOR_REPORT, PARTS_COMMANDS, PARTS_REPORT};
use crate::drive::STIFFNESS;
use crate::vehicle::Unsaid;
use crate::world::{Charge, Contactor, Gear, RelayState, World};
use protocol_core::model::Severity;

pub(super) static SHEETS: &[Sheet] = &[
    Sheet::of("VCUToBMS", VCU_TO_BMS),
    Sheet::of("BMSA", BMSA).sent(bms::limits_sent),
    Sheet::of("BMSB", BMSB),
    Sheet::of("BMSC", BMSC),
    Sheet::of("BMSD", BMSD),
    Sheet::of("ChargerTx", CHARGER_TX).only(plugged),
    Sheet::of("ChargerControl", CHARGER_CONTROL),
    Sheet::of("ChargerVoltageLimits", CHARGER_VOLTAGE_LIMITS),
    Sheet::of("ChargerCurrentLimits", CHARGER_CURRENT_LIMITS),
    Sheet::of("VCUToCluster", VCU_TO_CLUSTER),
    Sheet::of("VCUToMCU", VCU_TO_MCU),
];

/// No message of the motor is printed, and none to the parts.
pub(super) static UNPRINTED: &[Unsaid] = &[MOTOR_REPORT, PARTS_COMMANDS, PARTS_REPORT];

const VCU_TO_BMS: &[Row] = &[value("relay_command", |world| word(&[(world.vcu.hv_command, ON)], OFF))];

const ON: f64 = 170.0;
const OFF: f64 = 85.0;

const BMSA: &[Row] = &[
    value("soc", soc),
    fixed("soh", 98.0),
    // Discharge is positive (C5-R003).
    value("pack_current", pack_amps),
    value("max_discharge_current", |world| Some(world.bms.discharge_limit_amps)),
    // Negative here (C5-13).
    value("max_charge_current", |world| Some(-world.bms.charge_limit_amps)),
];

/// Silence of the vehicle controller after which the battery says so, in milliseconds.
const VCU_LOST_MS: u64 = 1_000;

const BMSB: &[Row] = &[
    value("pack_voltage", pack_volts),
    value("max_cell_voltage", |world| Some(world.bms.cell_max.value)),
    value("min_cell_voltage", |world| Some(world.bms.cell_min.value)),
    fixed("balancing_fault", 0.0),
    fixed("temperature_sensing_fault", 0.0),
    fixed("voltage_sensing_fault", 0.0),
    flag("current_sensing_fault", |world| world.bms.defects.current_sensor),
    flag("vcu_lost", |world| world.bms.vcu_silence_ms >= VCU_LOST_MS),
    fixed("can_fault", 0.0),
    flag("self_check_passed", |world| !alarm(world, SELF_CHECK)),
    fixed("slave_8_lost", 0.0),
    fixed("slave_7_lost", 0.0),
    fixed("slave_6_lost", 0.0),
    fixed("slave_5_lost", 0.0),
    fixed("slave_4_lost", 0.0),
    fixed("slave_3_lost", 0.0),
    fixed("slave_2_lost", 0.0),
    flag("slave_1_lost", |world| world.bms.defects.internal_bus),
];

/// Bit of the self check in BMSD; it is reported twice, in BMSB with the other sign (C5-44).
const SELF_CHECK: u8 = 16;

const BMSC: &[Row] = &[
    value("mean_temperature", |world| {
        let probes = &world.pack.probe_celsius;
        (!probes.is_empty()).then(|| probes.iter().sum::<f64>() / probes.len() as f64)
    }),
    value("max_temperature", |world| Some(world.bms.hot.value)),
    value("min_temperature", |world| Some(world.bms.cold.value)),
    value("max_temperature_probe", |world| Some(world.bms.hot.index as f64 + 1.0)),
    value("min_temperature_probe", |world| Some(world.bms.cold.index as f64 + 1.0)),
    fixed("cycles", 312.0),
    flag("precharge_fault", |world| world.bms.precharge_failed),
    flag("negative_contactor", |world| is_shut(&world.bms.negative)),
    flag("positive_contactor", |world| is_shut(&world.bms.main)),
    flag("charging", |world| world.bms.charge == Charge::Charging),
    flag("charge_gun", plugged),
    flag("positive_open_request", |world| world.bms.hv_off_request),
];

/// There is no code for "welded" here.
fn is_shut(contactor: &Contactor) -> bool {
    contactor.state() != RelayState::Open
}

const BMSD: &[Row] = &[
    bit("cell_voltage_high_1", alarm),
    bit("cell_voltage_low_1", alarm),
    bit("pack_voltage_high_1", alarm),
    bit("soc_low_1", alarm),
    bit("discharge_current_high_1", alarm),
    bit("regen_current_high_1", alarm),
    bit("temperature_high_1", alarm),
    bit("temperature_low_1", alarm),
    bit("cell_voltage_high_2", alarm),
    bit("cell_voltage_low_2", alarm),
    bit("pack_voltage_high_2", alarm),
    bit("soc_low_2", alarm),
    bit("discharge_current_high_2", alarm),
    bit("regen_current_high_2", alarm),
    bit("temperature_high_2", alarm),
    bit("temperature_low_2", alarm),
    bit("self_check_fault", alarm),
    bit("cell_spread_1", alarm),
    bit("pack_voltage_low_1", alarm),
    bit("temperature_spread_1", alarm),
    bit("insulation_1", alarm),
    bit("positive_open_fault", alarm),
    bit("positive_close_fault", alarm),
    bit("cell_spread_2", alarm),
    bit("pack_voltage_low_2", alarm),
    bit("temperature_spread_2", alarm),
    bit("insulation_2", alarm),
    bit("hv_interlock_fault", alarm),
    bit("negative_open_fault", alarm),
    bit("negative_close_fault", alarm),
    value("positive_insulation", |world| Some(world.insulation.positive_kiloohm)),
    value("negative_insulation", |world| Some(world.insulation.negative_kiloohm)),
];

const CHARGER_TX: &[Row] = &[
    value("output_voltage", |world| Some(world.charger.volts)),
    value("output_current", |world| Some(world.charger.amps)),
    flag("hardware_fault", |world| world.charger.hardware_fault),
    flag("over_temperature", |world| world.charger.over_temperature),
    flag("input_voltage_fault", |world| world.charger.input_fault),
    flag("can_timeout", |world| world.charger.communication_fault),
    value("charger_state", |world| {
        let charger = &world.charger;
        let fault = charger.hardware_fault
            || charger.over_temperature
            || charger.communication_fault
            || charger.reversed
            || charger.start_inhibited
            || charger.input_fault;
        word(&[(fault, 2.0), (charger.running, 1.0)], 0.0)
    }),
    flag("output_reversed", |world| world.charger.reversed),
    fixed("output_short", 0.0),
    flag("overcurrent_warning", |world| world.charger.trips.over_amps_warning),
    flag("undervoltage_warning", |world| world.charger.trips.under_volts_warning),
    flag("overvoltage_warning", |world| world.charger.trips.over_volts_warning),
    flag("overcurrent_protection", |world| world.charger.trips.over_amps_protection),
    flag("undervoltage_protection", |world| world.charger.trips.under_volts_protection),
    flag("overvoltage_protection", |world| world.charger.trips.over_volts_protection),
    flag("overcurrent_data_error", |world| world.charger.trips.over_amps_data),
    flag("undervoltage_data_error", |world| world.charger.trips.under_volts_data),
    flag("overvoltage_data_error", |world| world.charger.trips.over_volts_data),
];

const CHARGER_CONTROL: &[Row] = &[
    value("max_voltage", |world| Some(world.bms.wanted_charge.1)),
    value("max_current", |world| Some(world.bms.wanted_charge.0)),
    // 0 charges (C5-R011).
    flag("charge_inhibit", |world| !world.bms.charger_enabled),
];

const CHARGER_VOLTAGE_LIMITS: &[Row] = &[
    value("overvoltage_protection", |world| Some(world.bms.charger_bounds.over_volts_protection)),
    value("undervoltage_protection", |world| Some(world.bms.charger_bounds.under_volts_protection)),
    value("overvoltage_warning", |world| Some(world.bms.charger_bounds.over_volts_warning)),
    value("undervoltage_warning", |world| Some(world.bms.charger_bounds.under_volts_warning)),
];

const CHARGER_CURRENT_LIMITS: &[Row] = &[
    value("overcurrent_protection", |world| Some(world.bms.charger_bounds.over_amps_protection)),
    value("overcurrent_warning", |world| Some(world.bms.charger_bounds.over_amps_warning)),
];

/// State of charge below which the lamp is on.
const BATTERY_LOW: f64 = 0.15;

const VCU_TO_CLUSTER: &[Row] = &[
    value("soc", heard_soc),
    value("vehicle_speed", speed),
    value("motor_power", |world| Some(world.vcu.heard.motor.watts / 1_000.0)),
    value("battery_voltage", |world| world.vcu.heard.battery.volts),
    value("remaining_range", |world| Some(world.vcu.range_km)),
    value("gear", |world| gear(world, 0.0, 1.0, 2.0, Some(3.0))),
    flag("insulation_fault", |world| world.vcu.heard.parts.leak != Severity::None),
    flag("battery_fault", |world| world.vcu.heard.battery.severity != Severity::None),
    flag("motor_fault", |world| {
        let motor = &world.vcu.heard.motor;
        motor.fault_code != 0 || motor.protections != 0
    }),
    flag("ready", |world| world.vcu.ready),
    flag("system_fault", |world| world.vcu.system_fault),
    flag("charging", |world| world.vcu.heard.battery.charge == Charge::Charging),
    fixed("ebd_fault", 0.0),
    fixed("abs_fault", 0.0),
    flag("turtle_mode", |world| world.vcu.limp || world.vcu.power_limited),
    flag("charge_connected", plugged),
    flag("cruise", |world| world.driver.cruise),
    flag("battery_low", |world| world.vcu.heard.battery.soc.is_some_and(|soc| soc < BATTERY_LOW)),
    flag("buzzer", |world| world.vcu.buzzer),
    flag("sport_mode", |world| !world.driver.economy),
];

/// Direction of the gear: forwards is positive.
fn sign(world: &World) -> f64 {
    if world.vcu.gear == Some(Gear::R) { -1.0 } else { 1.0 }
}

/// Torque in the direction of the gear.
fn along(world: &World) -> f64 {
    world.vcu.wanted_nm * sign(world)
}

const VCU_TO_MCU: &[Row] = &[
    // Braking is torque against the direction.
    value("work_mode", |world| word(&[(along(world) < 0.0, 2.0)], 1.0)),
    value("control_mode", |world| word(&[(world.driver.cruise, 2.0)], 1.0)),
    value("direction", |world| {
        word(&[(world.vcu.gear == Some(Gear::D), 2.0), (world.vcu.gear == Some(Gear::R), 1.0)], 0.0)
    }),
    value("torque", |world| Some(world.vcu.wanted_nm.abs())),
    // A speed beyond the present one by as much as gives the torque.
    value("speed", |world| {
        let rpm = world.vcu.heard.motor.rpm * sign(world);
        Some((rpm + along(world) / STIFFNESS).max(0.0))
    }),
    // Low bytes of 9000 rpm and 300 Nm; the high ones are lost (C5-01).
    fixed("max_speed_low", 40.0),
    fixed("max_torque_low", 44.0),
];
