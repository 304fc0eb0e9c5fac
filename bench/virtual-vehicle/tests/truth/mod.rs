//! What is true in the vehicle, signal by signal, for tests that read its frames; and a driver who makes it move.
//!
//! Written from the documents and not from the sender's tables, which it is compared with.

use virtual_vehicle::world::Gear;
use virtual_vehicle::{Kind, VirtualVehicle, World};

/// Changes a setting.
pub(crate) fn set(vehicle: &mut VirtualVehicle, path: &str, number: f64) {
    vehicle.set(path, Some(number)).unwrap_or_else(|error| panic!("{error}"));
}

/// A driver who accelerates, brakes, turns round and plugs in, so that values move; one scene per 4 s.
pub(crate) fn drive(vehicle: &mut VirtualVehicle, second: u64) {
    let scene: &[(&str, f64)] = match second {
        0 => {
            &[("driver.parking_brake", 0.0), ("driver.brake", 0.3), ("driver.key", 3.0), ("driver.gear", 1.0)]
        }
        4 => &[("driver.brake", 0.0), ("driver.accelerator", 63.0), ("driver.air_conditioning", 1.0)],
        12 => &[("driver.accelerator", 17.0), ("driver.economy", 1.0), ("driver.cruise", 1.0)],
        16 => &[("driver.accelerator", 0.0), ("driver.brake", 44.0), ("driver.cruise", 0.0)],
        24 => &[("driver.brake", 100.0), ("driver.gear", 0.0), ("driver.parking_brake", 1.0)],
        28 => &[("charge.plug", 1.0)],
        _ => &[],
    };
    // Only the car has a cruise control; the bus has no economy mode.
    for (path, number) in scene.iter().filter(|(path, _)| vehicle.setting(path).is_some()).collect::<Vec<_>>()
    {
        set(vehicle, path, *number);
    }
}

/// Returns what is true of a vehicle's signals.
pub(crate) fn truths(kind: Kind) -> &'static [Truth] {
    match kind {
        Kind::Citybus => BUS,
        Kind::Jiulong => JIULONG,
        Kind::C5ev => C5EV,
    }
}

/// Message, signal and what is true of it, in the signal's unit.
pub(crate) type Truth = (&'static str, &'static str, fn(&World) -> f64);

const BUS: &[Truth] = &[
    ("VCU1", "vehicle_speed", |world| world.motion.kmh()),
    ("VCU1", "accelerator_pedal", |world| world.driver.accelerator * 100.0),
    ("VCU1", "brake_pedal", |world| world.driver.brake * 100.0),
    ("VCU1", "ready", |world| f64::from(u8::from(world.vcu.ready))),
    ("VCU1", "gear", |world| gear(world, [4.0, 1.0, 2.0, 8.0])),
    ("VCU1", "handbrake", |world| f64::from(u8::from(world.driver.parking_brake))),
    ("VCU2", "target_torque", |world| world.vcu.wanted_nm),
    ("VCU3", "mcu_input_voltage", |world| heard(world.vcu.link_volts)),
    ("VCU5", "aux_battery_voltage", |world| world.supply.volts),
    ("VCU5", "soc", |world| heard(world.vcu.heard.battery.soc) * 100.0),
    ("VCU7", "dtc", |world| f64::from(world.vcu.code)),
    ("IPU1", "bus_voltage", |world| world.motor.link_volts),
    ("IPU2", "motor_speed", |world| world.motor.rpm),
    ("IPU2", "motor_torque", |world| world.motor.nm),
    ("IPU2", "motor_temperature", |world| world.motor.celsius),
    ("IPU2", "controller_temperature", |world| world.motor.inverter_celsius),
    ("BMS1", "pack_voltage", |world| world.pack.volts),
    ("BMS1", "pack_current", |world| world.pack.amps),
    ("BMS1", "soc", |world| world.pack.soc * 100.0),
    ("BMS1", "main_relay", |world| f64::from(u8::from(world.bms.main.closed))),
    ("BMS1", "charge_1_relay", |world| {
        f64::from(u8::from(world.bms.charge_1.iter().all(|relay| relay.closed)))
    }),
    ("BMS1", "hv_open_request", |world| if world.bms.hv_off_request { 3.0 } else { 2.0 }),
    ("BMS2", "max_cell_voltage", |world| top(&world.pack.cell_volts)),
    ("BMS2", "min_cell_voltage", |world| bottom(&world.pack.cell_volts)),
    ("BMS2", "max_cell_temperature", |world| top(&world.pack.probe_celsius)),
    ("BMS2", "min_cell_temperature", |world| bottom(&world.pack.probe_celsius)),
    ("BMS4", "max_charge_current", |world| world.bms.charge_limit_amps),
    ("BMS4", "max_discharge_current", |world| world.bms.discharge_limit_amps),
    ("BMS5", "plug_state", |world| if world.charger.plugged { 85.0 } else { 170.0 }),
    ("BMS6", "min_temperature_1", |world| bottom(&world.pack.probe_celsius)),
    ("BMS7", "max_temperature_1", |world| top(&world.pack.probe_celsius)),
    ("BMS8", "min_voltage_1", |world| bottom(&world.pack.cell_volts)),
    ("BMS10", "max_voltage_1", |world| top(&world.pack.cell_volts)),
    ("BMS12", "rated_capacity", |world| world.pack.capacity_ah),
    ("SteeringPump", "motor_speed", |world| world.steering.rpm),
    ("DCDC", "output_voltage", |world| world.dcdc.output_volts),
    ("DCDC", "output_current", |world| world.dcdc.output_amps),
    ("AirPump", "bus_voltage", |world| world.compressor.input_volts),
    ("HVAC", "cabin_temperature", |world| world.hvac.cabin_celsius),
    ("HVAC", "outside_temperature", |world| world.road.celsius),
    ("Insulation", "positive_resistance", |world| world.insulation.positive_kiloohm),
    ("ChargerTx", "output_current", |world| -world.charger.amps),
    ("ChargerTx", "output_voltage", |world| world.charger.volts),
];

const JIULONG: &[Truth] = &[
    ("VCU1", "accelerator_pedal", |world| world.driver.accelerator * 100.0),
    ("VCU1", "torque", |world| world.vcu.wanted_nm),
    ("VCU1", "motor_temperature", |world| heard(world.vcu.heard.motor.celsius)),
    ("VCU1", "economy_mode", |world| f64::from(u8::from(world.driver.economy))),
    ("VCU2", "gear", |world| gear(world, [0.0, 1.0, 2.0, f64::NAN])),
    ("VCU2", "soc", |world| heard(world.vcu.heard.battery.soc) * 100.0),
    ("VCU2", "controller_temperature", |world| heard(world.vcu.heard.motor.inverter_celsius)),
    ("VCU2", "vacuum", |world| world.air.vacuum_kpa / 100.0),
    ("VCU3", "vehicle_speed", |world| world.motion.kmh()),
    ("VCU3", "motor_speed", |world| world.vcu.heard.motor.rpm),
    ("VCU3", "remaining_range", |world| world.vcu.range_km),
    ("VCU4", "motor_voltage", |world| heard(world.vcu.heard.motor.link_volts)),
    ("VCU4", "air_pressure_1", |world| world.air.front_mpa * 10.0),
    ("BMSStatus", "pack_voltage", |world| world.pack.volts),
    ("BMSStatus", "pack_current", |world| world.pack.amps),
    ("BMSStatus", "soc", |world| world.pack.soc * 100.0),
    ("BMSFaults", "series_cells", |world| world.pack.cell_volts.len() as f64),
    ("BMSFaults", "capacity", |world| world.pack.capacity_ah),
    ("CellVoltages1", "voltage_1", |world| world.pack.cell_volts[0]),
    ("CellVoltages7", "voltage_3", |world| world.pack.cell_volts[26]),
    ("CellVoltages7", "number_3", |_| 26.0),
    ("ModuleTemperatures2", "temperature_1", |world| world.pack.probe_celsius[3]),
    ("BMSExtremes", "max_cell_voltage", |world| top(&world.pack.cell_volts)),
    ("BMSExtremes", "min_cell_voltage", |world| bottom(&world.pack.cell_volts)),
    ("BMSExtremes", "max_temperature", |world| top(&world.pack.probe_celsius)),
    ("BMSExtremes", "min_temperature", |world| bottom(&world.pack.probe_celsius)),
    ("Charger", "output_current", |world| -world.charger.amps),
];

const C5EV: &[Truth] = &[
    ("BMSA", "soc", |world| world.pack.soc * 100.0),
    ("BMSA", "pack_current", |world| world.pack.amps),
    ("BMSA", "max_charge_current", |world| -world.bms.charge_limit_amps),
    ("BMSA", "max_discharge_current", |world| world.bms.discharge_limit_amps),
    ("BMSB", "pack_voltage", |world| world.pack.volts),
    ("BMSB", "max_cell_voltage", |world| top(&world.pack.cell_volts)),
    ("BMSB", "min_cell_voltage", |world| bottom(&world.pack.cell_volts)),
    ("BMSC", "max_temperature", |world| top(&world.pack.probe_celsius)),
    ("BMSC", "positive_contactor", |world| f64::from(u8::from(world.bms.main.closed))),
    ("BMSC", "charge_gun", |world| f64::from(u8::from(world.charger.plugged))),
    ("BMSC", "min_temperature", |world| bottom(&world.pack.probe_celsius)),
    ("BMSD", "negative_insulation", |world| world.insulation.negative_kiloohm),
    ("ChargerTx", "output_voltage", |world| world.charger.volts),
    ("ChargerTx", "output_current", |world| world.charger.amps),
    ("VCUToCluster", "vehicle_speed", |world| world.motion.kmh()),
    ("VCUToCluster", "soc", |world| heard(world.vcu.heard.battery.soc) * 100.0),
    ("VCUToCluster", "battery_voltage", |world| heard(world.vcu.heard.battery.volts)),
    ("VCUToCluster", "gear", |world| gear(world, [0.0, 1.0, 2.0, 3.0])),
    ("VCUToCluster", "ready", |world| f64::from(u8::from(world.vcu.ready))),
    ("VCUToCluster", "motor_power", |world| world.vcu.heard.motor.watts / 1_000.0),
    ("VCUToCluster", "remaining_range", |world| world.vcu.range_km),
    ("VCUToCluster", "charge_connected", |world| f64::from(u8::from(world.charger.plugged))),
    ("VCUToCluster", "cruise", |world| f64::from(u8::from(world.driver.cruise))),
];

/// What the vehicle controller passes on is true as it heard it; not a number = it has not heard it yet.
fn heard(told: Option<f64>) -> f64 {
    told.unwrap_or(f64::NAN)
}

/// The engaged gear in a document's numbers for N, D, R and P.
fn gear(world: &World, [n, d, r, p]: [f64; 4]) -> f64 {
    match world.vcu.gear {
        Some(Gear::D) => d,
        Some(Gear::R) => r,
        Some(Gear::P) => p,
        _ => n,
    }
}

/// Highest value.
pub(crate) fn top(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::MIN, f64::max)
}

/// Lowest value.
pub(crate) fn bottom(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::MAX, f64::min)
}
