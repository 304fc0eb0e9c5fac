//! The city bus: what every node but the cluster tells.
//!
//! Tables only. The charger's two frames travel between charger and battery on a bus of their own (BUS-R011); they are
//! put on the cluster's bus where the vehicle is built with its optional messages (BUS-103, BUS-R145), and only while a
//! charger is there (BUS-R146). VCU9, VCU10, the low-voltage steering and the PEU belong to parts that this vehicle has
//! only then (BUS-04, BUS-R054, R055).
//! Source: the bus document, readings BUS-01 to BUS-121.

use crate::bms;
use crate::bus::rows::{Row, Sheet, element, fixed, flag, value};
use crate::bus::truth::{
    accelerator, brake, cell_seat, charge_order, charge_state, gear, heard_soc, highest, level_down,
    level_up, lowest, motor_amps, motor_fault, pack_amps, pack_volts, plugged, probe_seat, protection, relay,
    soc, speed, status, word,
};
use crate::vehicle::Unsaid;
use crate::world::{Charge, Contactor, Gear, World};
use protocol_core::model::Severity;

pub(super) static SHEETS: &[Sheet] = &[
    Sheet::of("VCU1", VCU1),
    Sheet::of("VCU2", VCU2),
    Sheet::of("VCU3", VCU3),
    Sheet::of("VCU4", VCU4),
    Sheet::of("VCU5", VCU5),
    Sheet::of("VCU6", VCU6),
    Sheet::of("VCU7", VCU7).overview(100),
    Sheet::of("VCU8", VCU8),
    Sheet::of("VCU9", VCU9),
    Sheet::of("VCU10", VCU10),
    Sheet::of("IPU1", IPU1).here(|world| !world.motor.own_bus),
    Sheet::of("IPU2", IPU2),
    Sheet::of("IPU3", IPU3),
    Sheet::of("BMS1", BMS1),
    Sheet::of("BMS2", BMS2),
    Sheet::of("BMS4", BMS4).sent(bms::limits_sent),
    Sheet::of("BMS5", BMS5),
    Sheet::of("BMS6", BMS6),
    Sheet::of("BMS7", BMS7),
    Sheet::of("BMS8", BMS8),
    Sheet::of("BMS9", BMS9),
    Sheet::of("BMS10", BMS10),
    Sheet::of("BMS11", BMS11),
    Sheet::of("BMS12", BMS12).overview(500),
    Sheet::of("SteeringPump", STEERING_PUMP),
    Sheet::of("LowVoltageSteering", LOW_VOLTAGE_STEERING),
    Sheet::of("DCDC", DCDC),
    Sheet::of("AirPump", AIR_PUMP),
    Sheet::of("HVAC", HVAC),
    Sheet::of("Insulation", INSULATION).overview(3_000),
    Sheet::of("ChargerTx", CHARGER_TX).only(plugged).elsewhere(),
    Sheet::of("ChargerRx", CHARGER_RX).only(plugged).elsewhere(),
    Sheet::of("PEU", PEU),
];

/// The pantograph's charger is outside and is told over a line of its own.
pub(super) static UNPRINTED: &[Unsaid] = &[Unsaid {
    between: None,
    bring: |world, unprinted, is_heard| {
        unprinted.charge_order.bring(is_heard.then(|| charge_order(world)));
    },
}];

const VCU1: &[Row] = &[
    // The vehicle has no climb or snow mode (BUS-R018).
    value("drive_mode", |world| {
        word(&[(matches!(world.vcu.gear, Some(Gear::D | Gear::R)), DRIVE_MODE)], PARK_MODE)
    }),
    value("gear", |world| gear(world, 4.0, 1.0, 2.0, Some(8.0))),
    flag("handbrake", |world| world.vcu.parking_brake),
    flag("foot_brake", |world| world.driver.brake > 0.0),
    value("accelerator_pedal", accelerator),
    value("vehicle_speed", speed),
    value("brake_pedal", brake),
    flag("torque_limited", |world| world.vcu.torque_limited),
    flag("power_limited", |world| world.vcu.power_limited),
    flag("system_fault", |world| world.vcu.system_fault),
    flag("ready", |world| world.vcu.ready),
];

const DRIVE_MODE: f64 = 3.0;
const PARK_MODE: f64 = 0.0;

const VCU2: &[Row] = &[
    value("target_torque", |world| Some(world.vcu.wanted_nm)),
    flag("ipu_enable", |world| world.vcu.ready),
    flag("discharge_enable", |world| !world.vcu.hv_command),
    fixed("control_mode", TORQUE_MODE),
    // 0 is as invalid as 255 (BUS-R035).
    value("power_limit", |world| {
        let kilowatts = world.vcu.allowed_watts / 1_000.0;
        (kilowatts >= 1.0).then_some(kilowatts)
    }),
];

const TORQUE_MODE: f64 = 2.0;

const VCU3: &[Row] = &[
    fixed("vendor_code", 1.0),
    flag("hv_command", |world| world.vcu.hv_command),
    value("mcu_input_voltage", |world| world.vcu.link_volts),
    value("pantograph_state", |world| Some(f64::from(world.vcu.pantograph_state))),
    flag("charge_enable", |world| world.vcu.charge_enable),
    flag("hv_cutoff", |world| world.vcu.hv_cutoff),
    flag("precharge_relay", |world| world.vcu.relays.precharge),
    flag("motor_relay", |world| world.vcu.relays.motor),
    flag("accessory_relay", |world| world.vcu.relays.accessory),
    flag("accessory_precharge_relay", |world| world.vcu.relays.accessory_precharge),
    flag("defrost_relay", |world| world.vcu.relays.defrost),
    flag("charge_relay", |world| world.vcu.relays.charge),
    flag("battery_relay", |world| world.vcu.relays.battery),
];

const VCU4: &[Row] = &[
    fixed("fault_reset", 0.0),
    flag("run", |world| world.vcu.steering.0),
    value("frequency", |world| Some(world.vcu.steering.1)),
];

const VCU5: &[Row] = &[
    flag("reset", |world| world.vcu.hvac.reset),
    flag("derate", |world| world.vcu.hvac.derate),
    flag("start_permit", |world| world.vcu.hvac.permit),
    value("aux_battery_voltage", |world| Some(world.supply.volts)),
    value("soc", heard_soc),
];

const VCU6: &[Row] = &[
    // 0: the converter's own limits (BUS-R047).
    value("input_voltage_limit", |world| Some(world.vcu.dcdc_volts.0)),
    value("start_battery_voltage", |world| Some(world.vcu.dcdc_volts.1)),
    value("command", |world| word(&[(world.vcu.dcdc, START)], STANDBY)),
];

const START: f64 = 170.0;
const STANDBY: f64 = 85.0;

const VCU7: &[Row] = &[
    value("fault_level", |world| level_up(world.vcu.severity)),
    value("dtc", |world| Some(f64::from(world.vcu.code))),
    fixed("dryer_pressure_switch", 0.0),
    flag("compressor_over_temperature", |world| world.vcu.heard.parts.compressor_code == COMPRESSOR_HOT),
];

/// Fault code of the compressor: its own over-temperature.
const COMPRESSOR_HOT: u8 = 10;

const VCU8: &[Row] = &[
    fixed("fault_reset", 0.0),
    flag("run", |world| world.vcu.compressor.0),
    value("frequency", |world| Some(world.vcu.compressor.1)),
];

const VCU9: &[Row] = &[flag("oil_pump_command", |world| world.vcu.ready), value("vehicle_speed", speed)];

const VCU10: &[Row] = &[
    flag("positive_contactor", |world| world.vcu.relays.motor),
    fixed("negative_contactor", 0.0),
    flag("positive_precharge", |world| world.vcu.relays.precharge),
    fixed("negative_precharge", 0.0),
    flag("defrost", |world| world.vcu.relays.defrost),
    fixed("hvac", 0.0),
    fixed("battery_heater", 0.0),
    fixed("heater", 0.0),
    fixed("charge", 0.0),
    flag("accessory", |world| world.vcu.relays.accessory),
    flag("accessory_precharge", |world| world.vcu.relays.accessory_precharge),
    fixed("contactor_4", 0.0),
    fixed("contactor_5", 0.0),
    fixed("contactor_6", 0.0),
    fixed("contactor_7", 0.0),
    fixed("contactor_8", 0.0),
];

const IPU1: &[Row] = &[
    value("bus_voltage", |world| Some(world.motor.link_volts)),
    value("bus_current", motor_amps),
    value("mode", ipu_mode),
    element("bus_overcurrent", protection, 0),
    element("position_sensor_fault", protection, 1),
    element("bus_overvoltage", protection, 2),
    element("bus_undervoltage", protection, 3),
    element("motor_over_temperature", protection, 4),
    element("inverter_over_temperature", protection, 5),
    element("overspeed", protection, 6),
];

/// Mode of the motor controller: off, failure, zero torque, braking, forward or reverse.
fn ipu_mode(world: &World) -> Option<f64> {
    let motor = &world.motor;
    word(
        &[
            (motor_fault(world), 1.0),
            (!motor.running, 0.0),
            (motor.nm == 0.0, 2.0),
            (motor.nm * motor.rpm < 0.0, 10.0),
            (motor.nm < 0.0, 26.0),
        ],
        18.0,
    )
}

const IPU2: &[Row] = &[
    value("peak_torque", |world| Some(world.motor.peak_nm)),
    value("motor_speed", |world| Some(world.motor.rpm)),
    value("motor_torque", |world| Some(world.motor.nm)),
    value("motor_temperature", |world| Some(world.motor.celsius)),
    value("controller_temperature", |world| Some(world.motor.inverter_celsius)),
];

const IPU3: &[Row] = &[
    value("status", |world| word(&[(motor_fault(world), 5.0), (world.motor.running, 2.0)], 0.0)),
    value("fault_code", |world| Some(f64::from(world.motor.fault_code))),
];

const BMS1: &[Row] = &[
    value("pack_voltage", pack_volts),
    value("pack_current", pack_amps),
    value("soc", soc),
    value("fault_level", |world| level_down(world.bms.severity)),
    value("hv_open_request", |world| word(&[(world.bms.hv_off_request, 3.0)], 2.0)),
    value("check_state", |world| {
        let bms = &world.bms;
        word(
            &[
                (bms.severity > Severity::None, 4.0),
                (bms.precharge.closed && !bms.precharged, 1.0),
                (bms.precharged, 2.0),
            ],
            0.0,
        )
    }),
    value("heater_relay", |world| relay(Contactor::pair_state(&world.bms.heater))),
    value("charge_2_relay", |world| relay(Contactor::pair_state(&world.bms.charge_2))),
    value("charge_1_relay", |world| relay(Contactor::pair_state(&world.bms.charge_1))),
    value("main_relay", |world| relay(world.bms.main.state())),
];

const BMS2: &[Row] = &[
    value("max_cell_voltage", |world| Some(world.bms.cell_max.value)),
    value("min_cell_voltage", |world| Some(world.bms.cell_min.value)),
    value("max_cell_temperature", |world| Some(world.bms.hot.value)),
    value("min_cell_temperature", |world| Some(world.bms.cold.value)),
];

const BMS4: &[Row] = &[
    // Sign not printed: positive (BUS-73).
    value("max_charge_current", |world| Some(world.bms.charge_limit_amps)),
    value("max_discharge_current", |world| Some(world.bms.discharge_limit_amps)),
    fixed("max_temperature", 55.0),
    fixed("min_temperature", -20.0),
    fixed("min_soc", 10.0),
];

const BMS5: &[Row] = &[
    value("fault_code", |world| Some(f64::from(world.bms.code))),
    value("charge_interval", |world| Some(f64::from(world.bms.charge_interval_days))),
    value("charge_state", charge_state),
    flag("balancing", |world| world.bms.balancing),
    value("plug_state", |world| word(&[(world.charger.plugged, INSERTED)], NOT_INSERTED)),
    value("pantograph_charge_state", |world| {
        let charge = world.bms.charge;
        word(
            &[
                (!world.charger.pantograph, 0.0),
                (charge == Charge::Idle, 1.0),
                (charge == Charge::Charging, 2.0),
                (charge == Charge::Complete, 3.0),
            ],
            4.0,
        )
    }),
];

const INSERTED: f64 = 85.0;
const NOT_INSERTED: f64 = 170.0;

fn cold(world: &World, place: usize) -> Option<f64> {
    Some(lowest(&world.pack.probe_celsius, place)?.0)
}

fn cold_box(world: &World, place: usize) -> Option<f64> {
    Some(probe_seat(world, lowest(&world.pack.probe_celsius, place)?.1).0)
}

fn hot(world: &World, place: usize) -> Option<f64> {
    Some(highest(&world.pack.probe_celsius, place)?.0)
}

fn hot_box(world: &World, place: usize) -> Option<f64> {
    Some(probe_seat(world, highest(&world.pack.probe_celsius, place)?.1).0)
}

const BMS6: &[Row] = &[
    element("min_temperature_1", cold, 0),
    element("min_temperature_1_box", cold_box, 0),
    element("min_temperature_2", cold, 1),
    element("min_temperature_2_box", cold_box, 1),
    element("min_temperature_3", cold, 2),
    element("min_temperature_3_box", cold_box, 2),
    element("min_temperature_4", cold, 3),
    element("min_temperature_4_box", cold_box, 3),
];

const BMS7: &[Row] = &[
    element("max_temperature_1", hot, 0),
    element("max_temperature_1_box", hot_box, 0),
    element("max_temperature_2", hot, 1),
    element("max_temperature_2_box", hot_box, 1),
    element("max_temperature_3", hot, 2),
    element("max_temperature_3_box", hot_box, 2),
    element("max_temperature_4", hot, 3),
    element("max_temperature_4_box", hot_box, 3),
];

fn low(world: &World, place: usize) -> Option<f64> {
    Some(lowest(&world.pack.cell_volts, place)?.0)
}

fn low_cell(world: &World, place: usize) -> Option<f64> {
    Some(cell_seat(world, lowest(&world.pack.cell_volts, place)?.1).1)
}

fn low_box(world: &World, place: usize) -> Option<f64> {
    Some(cell_seat(world, lowest(&world.pack.cell_volts, place)?.1).0)
}

fn high(world: &World, place: usize) -> Option<f64> {
    Some(highest(&world.pack.cell_volts, place)?.0)
}

fn high_cell(world: &World, place: usize) -> Option<f64> {
    Some(cell_seat(world, highest(&world.pack.cell_volts, place)?.1).1)
}

fn high_box(world: &World, place: usize) -> Option<f64> {
    Some(cell_seat(world, highest(&world.pack.cell_volts, place)?.1).0)
}

const BMS8: &[Row] = &[
    element("min_voltage_1", low, 0),
    element("min_voltage_1_cell", low_cell, 0),
    element("min_voltage_1_box", low_box, 0),
    element("min_voltage_2", low, 1),
    element("min_voltage_2_cell", low_cell, 1),
    element("min_voltage_2_box", low_box, 1),
];

const BMS9: &[Row] = &[
    element("min_voltage_3", low, 2),
    element("min_voltage_3_cell", low_cell, 2),
    element("min_voltage_3_box", low_box, 2),
    element("min_voltage_4", low, 3),
    element("min_voltage_4_cell", low_cell, 3),
    element("min_voltage_4_box", low_box, 3),
];

const BMS10: &[Row] = &[
    element("max_voltage_1", high, 0),
    element("max_voltage_1_cell", high_cell, 0),
    element("max_voltage_1_box", high_box, 0),
    element("max_voltage_2", high, 1),
    element("max_voltage_2_cell", high_cell, 1),
    element("max_voltage_2_box", high_box, 1),
];

const BMS11: &[Row] = &[
    element("max_voltage_3", high, 2),
    element("max_voltage_3_cell", high_cell, 2),
    element("max_voltage_3_box", high_box, 2),
    element("max_voltage_4", high, 3),
    element("max_voltage_4_cell", high_cell, 3),
    element("max_voltage_4_box", high_box, 3),
];

const BMS12: &[Row] = &[
    value("rated_capacity", |world| Some(world.pack.capacity_ah)),
    value("rated_voltage", |world| Some(world.pack.cell_volts.len() as f64 * NOMINAL_CELL_VOLTS)),
    fixed("production_year", 2018.0),
    fixed("production_month", 4.0),
    fixed("production_day", 3.0),
];

/// Nominal voltage of an iron phosphate cell, in V.
const NOMINAL_CELL_VOLTS: f64 = 3.2;

const STEERING_PUMP: &[Row] = &[
    value("motor_speed", |world| Some(world.steering.rpm)),
    value("bus_voltage", |world| Some(world.steering.input_volts)),
    value("current", |world| Some(world.steering.input_amps)),
    value("controller_temperature", |world| Some(world.steering.celsius)),
    value("fault_code", |world| Some(f64::from(world.steering.fault_code))),
    value("status", |world| status(&world.steering)),
    flag("external_control", |world| world.steering.external),
    flag("precharged", |world| world.steering.precharged),
];

const LOW_VOLTAGE_STEERING: &[Row] = &[
    value("status", |world| status(&world.steering)),
    value("output_voltage", |world| Some(world.supply.volts)),
    value("output_current", |world| Some(world.steering.output_amps)),
    value("radiator_temperature", |world| Some(world.steering.celsius)),
    value("fault_code", |world| Some(f64::from(world.steering.fault_code))),
    value("alarm_level", |world| word(&[(world.steering.fault_code != 0, 1.0)], 0.0)),
];

const DCDC: &[Row] = &[
    value("input_voltage", |world| Some(world.dcdc.input_volts)),
    value("input_current", |world| Some(world.dcdc.input_amps)),
    value("output_current", |world| Some(world.dcdc.output_amps)),
    value("controller_temperature", |world| Some(world.dcdc.celsius)),
    value("output_voltage", |world| Some(world.dcdc.output_volts)),
    value("fault_code", |world| Some(f64::from(world.dcdc.fault_code))),
    value("status", |world| status(&world.dcdc)),
    flag("precharged", |world| world.dcdc.precharged),
];

const AIR_PUMP: &[Row] = &[
    value("motor_speed", |world| Some(world.compressor.rpm)),
    value("bus_voltage", |world| Some(world.compressor.input_volts)),
    value("current", |world| Some(world.compressor.input_amps)),
    value("controller_temperature", |world| Some(world.compressor.celsius)),
    value("fault_code", |world| Some(f64::from(world.compressor.fault_code))),
    value("status", |world| status(&world.compressor)),
    flag("precharged", |world| world.compressor.precharged),
];

const HVAC: &[Row] = &[
    element("return_sensor_open", hvac_fault, 0),
    element("outside_sensor_open", hvac_fault, 1),
    element("evaporator_1_sensor_open", hvac_fault, 2),
    element("evaporator_2_sensor_open", hvac_fault, 3),
    element("supply_overvoltage", hvac_fault, 4),
    element("supply_undervoltage", hvac_fault, 5),
    element("inverter_fault", hvac_fault, 6),
    element("pressure_fault", hvac_fault, 7),
    // The low bit says that it is on, the others how fast (BUS-R135, R136).
    flag("fan_low", |world| world.hvac.on),
    flag("fan_mid", |world| world.hvac.fan == 2),
    flag("fan_high", |world| world.hvac.fan == 3),
    flag("heating", |world| world.hvac.heating),
    fixed("defrost_1", 0.0),
    fixed("fresh_air", 0.0),
    fixed("sterilise", 0.0),
    fixed("defrost_2", 0.0),
    fixed("cooling_2", 0.0),
    flag("cooling_1", |world| world.hvac.cooling),
    value("cabin_temperature", |world| Some(world.hvac.cabin_celsius)),
    value("outside_temperature", |world| Some(world.road.celsius)),
    flag("communication_alarm", |world| world.hvac.communication_alarm),
];

fn hvac_fault(world: &World, place: usize) -> Option<f64> {
    Some(f64::from(world.hvac.faults >> place.min(7) & 1))
}

const INSULATION: &[Row] = &[
    value("leakage_level", |world| Some(f64::from(world.insulation.level))),
    value("positive_resistance", |world| Some(world.insulation.positive_kiloohm)),
    value("negative_resistance", |world| Some(world.insulation.negative_kiloohm)),
    value("fault_code", |world| Some(f64::from(world.insulation.fault_code))),
    flag("level_1_alarm", |world| world.insulation.level == 1),
    flag("level_2_alarm", |world| world.insulation.level >= 2),
    flag("positive_fault", |world| {
        world.insulation.level > 0 && world.insulation.positive_kiloohm <= world.insulation.negative_kiloohm
    }),
    flag("negative_fault", |world| {
        world.insulation.level > 0 && world.insulation.negative_kiloohm <= world.insulation.positive_kiloohm
    }),
    fixed("wiring_fault", 0.0),
    flag("device_fault", |world| world.insulation.device_fault),
];

const CHARGER_TX: &[Row] = &[
    value("output_voltage", |world| Some(world.charger.volts)),
    // Negative while charging (BUS-104).
    value("output_current", |world| Some(-world.charger.amps)),
    flag("hardware_fault", |world| world.charger.hardware_fault),
    flag("over_temperature", |world| world.charger.over_temperature),
    flag("input_voltage_fault", |world| world.charger.input_fault),
    flag("start_inhibited", |world| world.charger.start_inhibited),
    flag("communication_fault", |world| world.charger.communication_fault),
    value("fault_level", |world| level_down(world.charger.severity)),
    value("fault_code", |world| Some(f64::from(world.charger.code))),
];

const CHARGER_RX: &[Row] = &[
    value("max_voltage", |world| Some(world.bms.wanted_charge.1)),
    // Sign not printed: positive (BUS-104).
    value("max_current", |world| Some(world.bms.wanted_charge.0)),
    flag("enable", |world| world.bms.charger_enabled),
];

const PEU: &[Row] = &[
    value("positive_contactor", |world| reported(world.contactor_box.motor)),
    value("battery_main_contactor", |world| sensed(&[world.bms.main])),
    value("positive_precharge", |world| reported(world.contactor_box.precharge)),
    fixed("negative_precharge", 0.0),
    value("defrost", |world| reported(world.contactor_box.defrost)),
    fixed("hvac", 0.0),
    value("battery_heater", |world| sensed(&world.bms.heater)),
    fixed("heater", 0.0),
    value("accessory", |world| reported(world.contactor_box.accessory)),
    value("accessory_precharge", |world| reported(world.contactor_box.accessory_precharge)),
    value("charge_1", |world| sensed(&world.bms.charge_1)),
    value("charge_2", |world| sensed(&world.bms.charge_2)),
];

/// Closed is 2 and open 1 here (BUS-59).
fn reported(closed: bool) -> Option<f64> {
    word(&[(closed, 2.0)], 1.0)
}

/// The same of contactors that can fail.
fn sensed(relays: &[Contactor]) -> Option<f64> {
    let fault = relays.iter().any(|relay| relay.welded || relay.driven && relay.stuck_open);
    word(&[(fault, 3.0), (relays.iter().all(|relay| relay.closed), 2.0)], 1.0)
}
