//! The vans and buses E66 to E10: what every node but the cluster tells.
//!
//! Tables only. The vehicle controller speaks for the motor, too. The charger is on this bus and tells as long as it is
//! plugged in. Cell numbers begin at 0 (JL-25), modules hold three probes; frames are as many as there are cells
//! (JL-27, JL-28), what is left of the last one is zero (JL-R021).
//! Source: the jiulong document, readings JL-01 to JL-58.

use crate::bms;
use crate::bus::rows::{Row, Sheet, bit, element, fixed, flag, value};
use crate::bus::truth::{
    accelerator, alarm, brake, cell_seat, charge_order, gear, heard_soc, level_down, pack_amps, pack_volts,
    plugged, probe_seat, soc, speed, word,
};
use crate::bus::unprinted::{MOTOR_REPORT_ELSEWHERE, PARTS_COMMANDS, PARTS_REPORT};
use crate::told::{BatteryCommand, BatteryReport, Hold, MotorCommand};
use crate::vcu::motor_severity;
use crate::vehicle::Unsaid;
use crate::world::{Charge, Gear, World};
use protocol_core::vehicle::Node;

pub(super) static SHEETS: &[Sheet] = &[
    Sheet::of("VCU1", VCU1),
    Sheet::of("VCU2", VCU2),
    Sheet::of("VCU3", VCU3),
    Sheet::of("VCU4", VCU4),
    Sheet::of("VCU5", VCU5),
    Sheet::of("BMSStatus", BMS_STATUS).sent(bms::limits_sent),
    Sheet::of("CellVoltages", CELL_VOLTAGES).series(4, |world| world.pack.cell_volts.len()),
    Sheet::of("ModuleTemperatures", MODULE_TEMPERATURES).series(3, |world| world.pack.probe_celsius.len()),
    Sheet::of("BMSFaults", BMS_FAULTS),
    Sheet::of("BMSExtremes", BMS_EXTREMES),
    Sheet::of("BMSExtremePositions", BMS_EXTREME_POSITIONS),
    Sheet::of("Charger", CHARGER).only(plugged),
];

/// The document is the instrument's part: motor, converter, pumps and air conditioning are on other buses, and what
/// battery and vehicle controller, battery and charger tell each other beyond the instrument's messages is not in it.
pub(super) static UNPRINTED: &[Unsaid] = &[
    Unsaid {
        between: None,
        bring: |world, unprinted, is_heard| {
            let (enabled, hold) = (world.vcu.ready, Hold::Torque(world.vcu.wanted_nm));
            unprinted.motor_command.bring(is_heard.then_some(MotorCommand { enabled, hold }));
        },
    },
    MOTOR_REPORT_ELSEWHERE,
    Unsaid {
        between: Some((Node::Vcu, Node::Bms)),
        bring: |world, unprinted, is_heard| {
            let high_voltage = world.vcu.hv_command;
            let command = BatteryCommand { high_voltage, ..BatteryCommand::default() };
            unprinted.battery_command.bring(is_heard.then_some(command));
        },
    },
    Unsaid {
        between: Some((Node::Bms, Node::Vcu)),
        bring: |world, unprinted, is_heard| {
            unprinted.battery.bring(is_heard.then(|| BatteryReport {
                charge_limit_amps: Some(world.bms.charge_limit_amps),
                discharge_limit_amps: Some(world.bms.discharge_limit_amps),
                main_closed: Some(world.bms.main.closed && world.bms.negative.closed),
                charge: world.bms.charge,
                limp: world.bms.limp,
                ..BatteryReport::default()
            }));
        },
    },
    Unsaid {
        between: Some((Node::Bms, Node::Charger)),
        bring: |world, unprinted, is_heard| {
            unprinted.charge_order.bring(is_heard.then(|| charge_order(world)));
        },
    },
    PARTS_COMMANDS,
    PARTS_REPORT,
];

/// Voltage below which the auxiliary battery counts as low, in V; a 12 V system.
const AUXILIARY_LOW_VOLTS: f64 = 11.0;
/// Vacuum that brakes need, in kPa below the atmosphere.
const VACUUM_LOW_KPA: f64 = 40.0;

fn auxiliary_low(world: &World) -> bool {
    world.supply.volts < AUXILIARY_LOW_VOLTS
}

const VCU1: &[Row] = &[
    flag("work_state", |world| world.vcu.ready),
    value("vcu_fault_level", |world| level_down(world.vcu.own_severity)),
    flag("vacuum_fault", |world| world.air.vacuum_kpa < VACUUM_LOW_KPA),
    flag("aux_battery_low", auxiliary_low),
    flag("dcdc_fault", |world| world.vcu.heard.parts.dcdc_fault),
    value("accelerator_pedal", accelerator),
    value("brake_pedal", brake),
    // Regeneration is negative (JL-R012).
    value("torque", |world| Some(world.vcu.wanted_nm)),
    value("motor_temperature", |world| world.vcu.heard.motor.celsius),
    flag("water_pump", |world| world.vcu.coolant_pump),
    flag("fan_low", |world| world.vcu.coolant_fan == 1),
    flag("fan_high", |world| world.vcu.coolant_fan == 2),
    flag("air_pump", |world| world.vcu.heard.parts.compressor_on),
    flag("air_conditioning", |world| world.vcu.heard.parts.hvac_on),
    flag("handbrake", |world| world.vcu.parking_brake),
    flag("foot_brake", |world| world.driver.brake > 0.0),
    flag("economy_mode", |world| world.driver.economy),
];

const VCU2: &[Row] = &[
    // No P gear here: invalid (JL-18).
    value("gear", |world| gear(world, 0.0, 1.0, 2.0, None)),
    // There is no code for "off"; invalid says so (JL-16).
    value("front_ptc_fan", ptc_fan),
    value("rear_ptc_fan", ptc_fan),
    value("charge_state", |world| {
        let charge = world.vcu.heard.battery.charge;
        word(
            &[
                (!world.charger.plugged, 0.0),
                (charge == Charge::Idle, 1.0),
                (charge == Charge::Charging, 2.0),
            ],
            3.0,
        )
    }),
    value("vehicle_mode", |world| {
        let driving = matches!(world.vcu.gear, Some(Gear::D | Gear::R));
        word(
            &[
                (world.charger.plugged, 1.0),
                (world.vcu.limp || world.vcu.heard.battery.limp, 4.0),
                (driving && world.vcu.heard.motor.watts < 0.0, 3.0),
                (driving, 2.0),
            ],
            0.0,
        )
    }),
    value("motor_fault_level", |world| level_down(motor_severity(world))),
    value("battery_fault_level", |world| level_down(world.vcu.heard.battery.severity)),
    value("vcu_fault_level", |world| level_down(world.vcu.own_severity)),
    fixed("water_pump_fault", 0.0),
    fixed("fan_fault", 0.0),
    flag("air_pump_fault", |world| world.vcu.heard.parts.compressor_code != 0),
    flag("aux_battery_low", auxiliary_low),
    flag("shift_failed", |world| world.vcu.shift_failed),
    value("controller_temperature", |world| world.vcu.heard.motor.inverter_celsius),
    // Depth of the vacuum (JL-44); not known without a sensor (JL-R014).
    value("vacuum", |world| (!world.air.vacuum_sensor_fault).then_some(world.air.vacuum_kpa / KPA_PER_BAR)),
    value("soc", heard_soc),
];

const KPA_PER_BAR: f64 = 100.0;
const BAR_PER_MPA: f64 = 10.0;

fn ptc_fan(world: &World) -> Option<f64> {
    let fan = world.vcu.heard.parts.heating_fan;
    (fan > 0).then(|| f64::from(fan) - 1.0)
}

const VCU3: &[Row] = &[
    value("vehicle_speed", speed),
    value("remaining_range", |world| Some(world.vcu.range_km)),
    // Negative in reverse (JL-R015).
    value("motor_speed", |world| Some(world.vcu.heard.motor.rpm)),
    element("igbt_protection", heard_protection, 0),
    element("drive_supply_undervoltage", heard_protection, 1),
    element("bridge_shoot_through", heard_protection, 2),
    element("igbt_over_temperature", heard_protection, 3),
    element("motor_over_temperature", heard_protection, 4),
    element("bus_overcurrent", heard_protection, 5),
    element("phase_overcurrent", heard_protection, 6),
    element("control_undervoltage", heard_protection, 7),
    element("control_reversed", heard_protection, 8),
    element("control_overvoltage", heard_protection, 9),
    element("dq_overcurrent", heard_protection, 10),
    element("bus_undervoltage", heard_protection, 11),
    element("bus_overvoltage", heard_protection, 12),
    element("over_torque", heard_protection, 13),
    element("overload", heard_protection, 14),
    element("stall", heard_protection, 15),
    element("driver_over_temperature", heard_protection, 16),
    element("overspeed", heard_protection, 17),
    element("can_fault", heard_protection, 18),
    element("back_emf", heard_protection, 19),
    element("phase_loss", heard_protection, 20),
    element("resolver_fault", heard_protection, 21),
    element("hardware_shutdown", heard_protection, 22),
];

const VCU4: &[Row] = &[
    value("motor_voltage", |world| world.vcu.heard.motor.link_volts),
    // Negative while it charges (JL-R017).
    value("phase_current", |world| Some(world.vcu.heard.motor.phase_amps)),
    value("phase_voltage", |world| Some(world.vcu.heard.motor.phase_volts)),
    value("air_pressure_1", |world| bar(world, world.air.front_mpa)),
    value("air_pressure_2", |world| bar(world, world.air.rear_mpa)),
];

/// Pressure in bar; not known when the sensors are broken (JL-R016).
fn bar(world: &World, mpa: f64) -> Option<f64> {
    (!world.air.pressure_sensor_fault).then_some(mpa * BAR_PER_MPA)
}

const VCU5: &[Row] = &[fixed("hardware_version", 3.0), fixed("software_version", 16.0)];

const BMS_STATUS: &[Row] = &[
    value("pack_voltage", pack_volts),
    value("pack_current", pack_amps),
    value("soc", soc),
    value("battery_fault_level", |world| level_down(world.bms.severity)),
    value("insulation_fault_level", |world| level_down(world.bms.insulation_severity)),
];

/// Number of a cell; 0 fills up the last frame.
fn cell_number(world: &World, cell: usize) -> Option<f64> {
    Some(if cell < world.pack.cell_volts.len() { cell as f64 } else { 0.0 })
}

/// Voltage of a cell; 0 fills up the last frame.
fn cell_volts(world: &World, cell: usize) -> Option<f64> {
    Some(world.pack.cell_volts.get(cell).copied().unwrap_or(0.0))
}

const CELL_VOLTAGES: &[Row] = &[
    element("number_1", cell_number, 0),
    element("voltage_1", cell_volts, 0),
    element("number_2", cell_number, 1),
    element("voltage_2", cell_volts, 1),
    element("number_3", cell_number, 2),
    element("voltage_3", cell_volts, 2),
    element("number_4", cell_number, 3),
    element("voltage_4", cell_volts, 3),
];

/// Temperature of a probe; a place without one is raw 0 (JL-29).
fn probe_celsius(world: &World, probe: usize) -> Option<f64> {
    Some(world.pack.probe_celsius.get(probe).copied().unwrap_or(NO_PROBE_CELSIUS))
}

const NO_PROBE_CELSIUS: f64 = -40.0;

const MODULE_TEMPERATURES: &[Row] = &[
    element("temperature_1", probe_celsius, 0),
    element("temperature_2", probe_celsius, 1),
    element("temperature_3", probe_celsius, 2),
];

const BMS_FAULTS: &[Row] = &[
    bit("voltage_balance_fault", alarm),
    bit("max_temperature_exceeded", alarm),
    bit("pack_voltage_exceeded", alarm),
    bit("negative_cut", alarm),
    bit("pack_current_exceeded", alarm),
    bit("mean_voltage_exceeded", alarm),
    bit("max_voltage_exceeded", alarm),
    bit("min_voltage_exceeded", alarm),
    bit("capacity_low", alarm),
    bit("slave_no_response", alarm),
    bit("insulation_fault", alarm),
    bit("temperature_balance_fault", alarm),
    bit("soc_jump", alarm),
    bit("storage_mismatch", alarm),
    bit("overcharge", alarm),
    bit("soc_high", alarm),
    value("series_cells", |world| Some(world.pack.cell_volts.len() as f64)),
    value("capacity", |world| Some(world.pack.capacity_ah)),
    bit("smoke_detector_1_fault", alarm),
    bit("smoke_detector_2_fault", alarm),
    bit("smoke_detector_3_fault", alarm),
    bit("smoke_detector_4_fault", alarm),
    bit("smoke_detector_5_fault", alarm),
    bit("smoke_detector_6_fault", alarm),
    bit("smoke_alarm_1", alarm),
    bit("smoke_alarm_2", alarm),
    bit("smoke_alarm_3", alarm),
    bit("smoke_alarm_4", alarm),
    bit("smoke_alarm_5", alarm),
    bit("smoke_alarm_6", alarm),
    bit("negative_contactor_welded", alarm),
];

const BMS_EXTREMES: &[Row] = &[
    value("max_cell_voltage", |world| Some(world.bms.cell_max.value)),
    value("min_cell_voltage", |world| Some(world.bms.cell_min.value)),
    value("max_temperature", |world| Some(world.bms.hot.value)),
    value("min_temperature", |world| Some(world.bms.cold.value)),
];

const BMS_EXTREME_POSITIONS: &[Row] = &[
    value("max_voltage_box", |world| Some(cell_seat(world, world.bms.cell_max.index).0)),
    value("max_voltage_position", |world| Some(cell_seat(world, world.bms.cell_max.index).1)),
    value("min_voltage_box", |world| Some(cell_seat(world, world.bms.cell_min.index).0)),
    value("min_voltage_position", |world| Some(cell_seat(world, world.bms.cell_min.index).1)),
    value("max_temperature_box", |world| Some(probe_seat(world, world.bms.hot.index).0)),
    value("max_temperature_position", |world| Some(probe_seat(world, world.bms.hot.index).1)),
    value("min_temperature_box", |world| Some(probe_seat(world, world.bms.cold.index).0)),
    value("min_temperature_position", |world| Some(probe_seat(world, world.bms.cold.index).1)),
];

const CHARGER: &[Row] = &[
    value("output_voltage", |world| Some(world.charger.volts)),
    // Negative while charging (JL-R027).
    value("output_current", |world| Some(-world.charger.amps)),
    flag("hardware_fault", |world| world.charger.hardware_fault),
    flag("over_temperature", |world| world.charger.over_temperature),
    flag("input_voltage_fault", |world| world.charger.input_fault),
    flag("start_inhibited", |world| world.charger.start_inhibited),
    flag("communication_fault", |world| world.charger.communication_fault),
    value("fault_level", |world| level_down(world.charger.severity)),
];

/// Protection bit `place` as the motor controller told it.
fn heard_protection(world: &World, place: usize) -> Option<f64> {
    let bits = world.vcu.heard.motor.protections;
    Some(f64::from(bits >> place.min(31) & 1))
}
