//! What several documents ask of the world in the same words.
//!
//! Pure questions to the [`World`] that rows of more than one message share. Refuses to know raw values that only one
//! message has.

use crate::told::{ChargeOrder, ConverterCommand, HvacOrder, MotorReport, PartsReport, PumpCommand};
use crate::world::{Charge, Gear, Part, RelayState, World};
use protocol_core::model::Severity;

/// Numbers a choice of words, the first true one; `other` if none is.
pub(crate) fn word(choices: &[(bool, f64)], other: f64) -> Option<f64> {
    Some(choices.iter().find(|(holds, _)| *holds).map_or(other, |(_, number)| *number))
}

/// Level where 3 is worst (BUS-R026).
pub(crate) fn level_up(severity: Severity) -> Option<f64> {
    Some(match severity {
        Severity::None => 0.0,
        Severity::Warn => 1.0,
        Severity::Derate => 2.0,
        Severity::Stop => 3.0,
    })
}

/// Level or raw value where 1 is worst (BUS-R066, R147, JL-R010, R019, R030).
pub(crate) fn level_down(severity: Severity) -> Option<f64> {
    Some(match severity {
        Severity::None => 0.0,
        Severity::Warn => 3.0,
        Severity::Derate => 2.0,
        Severity::Stop => 1.0,
    })
}

/// State of charge in percent, as the vehicle controller last heard it.
pub(crate) fn heard_soc(world: &World) -> Option<f64> {
    world.vcu.heard.battery.soc.map(|soc| soc * 100.0)
}

/// State of charge in percent, as the battery controller believes.
pub(crate) fn soc(world: &World) -> Option<f64> {
    Some(world.counted_soc() * 100.0)
}

/// Pack voltage in V.
pub(crate) fn pack_volts(world: &World) -> Option<f64> {
    Some(world.pack.volts)
}

/// Pack current in A, positive = out of the battery.
pub(crate) fn pack_amps(world: &World) -> Option<f64> {
    Some(world.pack.amps)
}

/// Speed in km/h, never negative.
pub(crate) fn speed(world: &World) -> Option<f64> {
    Some(world.motion.kmh())
}

/// Accelerator pedal in percent; not known when its sensor is broken (JL-R011).
pub(crate) fn accelerator(world: &World) -> Option<f64> {
    (!world.driver.accelerator_fault).then_some(world.driver.accelerator * 100.0)
}

/// Brake pedal in percent; a switch says 0 or 100 (BUS-R019).
pub(crate) fn brake(world: &World) -> Option<f64> {
    let brake = world.driver.brake;
    Some(match (world.driver.digital_brake, brake > 0.0) {
        (false, _) => brake * 100.0,
        (true, pressed) => f64::from(u8::from(pressed)) * 100.0,
    })
}

/// The gear that is engaged, numbered by the document; `None` = not known.
pub(crate) fn gear(world: &World, n: f64, d: f64, r: f64, p: Option<f64>) -> Option<f64> {
    match world.vcu.gear? {
        Gear::N => Some(n),
        Gear::D => Some(d),
        Gear::R => Some(r),
        Gear::P => p,
        Gear::D1 | Gear::D2 | Gear::D3 | Gear::D4 | Gear::D5 | Gear::D6 => None,
    }
}

/// Protection bit `place` of the motor controller.
pub(crate) fn protection(world: &World, place: usize) -> Option<f64> {
    let bit = u32::try_from(place).ok().and_then(|place| world.motor.protections.checked_shr(place));
    Some(f64::from(bit.unwrap_or(0) & 1))
}

/// The motor controller reports a fault.
pub(crate) fn motor_fault(world: &World) -> bool {
    world.motor.fault_code != 0 || world.motor.protections != 0
}

/// Motor controller's current out of its direct-current side, in A, positive = drive (BUS-64).
pub(crate) fn motor_amps(world: &World) -> Option<f64> {
    let volts = world.motor.link_volts;
    Some(if volts > 1.0 { world.motor.watts / volts } else { 0.0 })
}

/// 0 = stopped, 1 = running, 2 = fault: steering, compressor, DC/DC.
pub(crate) fn status(part: &Part) -> Option<f64> {
    word(&[(part.fault_code != 0, 2.0), (part.running, 1.0)], 0.0)
}

/// 0 = open, 1 = closed, 3 = welded (BUS-R068 to R070).
pub(crate) fn relay(state: RelayState) -> Option<f64> {
    Some(match state {
        RelayState::Open => 0.0,
        RelayState::Closed => 1.0,
        RelayState::Welded => 3.0,
    })
}

/// The charging state as both bus and cluster count it: idle, charging, complete, fault.
pub(crate) fn charge_state(world: &World) -> Option<f64> {
    Some(match world.bms.charge {
        Charge::Idle => 0.0,
        Charge::Charging => 1.0,
        Charge::Complete => 2.0,
        Charge::Fault => 3.0,
    })
}

/// A charger is there.
pub(crate) fn plugged(world: &World) -> bool {
    world.charger.plugged
}

/// The battery controller reports the fault whose bit is at this place of its alarm message.
pub(crate) fn alarm(world: &World, place: u8) -> bool {
    world.bms.active.iter().any(|fault| fault.code == place)
}

/// A leak level as a severity: level 2 is worse (BUS-100).
pub(crate) const fn leak(level: u8) -> Severity {
    match level {
        0 => Severity::None,
        1 => Severity::Derate,
        _ => Severity::Stop,
    }
}

/// Box and place of a cell, both from 1.
pub(crate) fn cell_seat(world: &World, cell: usize) -> (f64, f64) {
    let per_box = world.spec.cells_per_box;
    ((cell / per_box + 1) as f64, (cell % per_box + 1) as f64)
}

/// Box and place of a temperature probe, both from 1; probes are spread evenly over the boxes.
pub(crate) fn probe_seat(world: &World, probe: usize) -> (f64, f64) {
    let boxes = world.pack.cell_volts.len().div_ceil(world.spec.cells_per_box).max(1);
    let per_box = world.pack.probe_celsius.len().div_ceil(boxes).max(1);
    ((probe / per_box + 1) as f64, (probe % per_box + 1) as f64)
}

/// Returns the `place`-th highest value and its index; of equals the first one is higher.
pub(crate) fn highest(values: &[f64], place: usize) -> Option<(f64, usize)> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]).then(a.cmp(b)));
    order.get(place).map(|index| (values[*index], *index))
}

/// Returns the `place`-th lowest value and its index; of equals the first one is lower.
pub(crate) fn lowest(values: &[f64], place: usize) -> Option<(f64, usize)> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]).then(a.cmp(b)));
    order.get(place).map(|index| (values[*index], *index))
}

/// What the battery orders of the charger, thresholds not included.
pub(crate) fn charge_order(world: &World) -> ChargeOrder {
    let bms = &world.bms;
    ChargeOrder {
        enabled: bms.charger_enabled,
        amps: bms.wanted_charge.0,
        volts: bms.wanted_charge.1,
        bounds: None,
    }
}

/// What the motor controller knows of itself.
pub(crate) fn motor_report(world: &World) -> MotorReport {
    let motor = &world.motor;
    MotorReport {
        link_volts: Some(motor.link_volts),
        rpm: motor.rpm,
        watts: motor.watts,
        celsius: Some(motor.celsius),
        inverter_celsius: Some(motor.inverter_celsius),
        fault_code: motor.fault_code,
        protections: motor.protections,
        tripped: motor.protections_set != 0,
        phase_amps: motor.phase_amps,
        phase_volts: motor.phase_volts,
    }
}

/// What the vehicle controller orders of the converter.
pub(crate) fn converter_command(world: &World) -> ConverterCommand {
    let (lowest_input, start_volts) = world.vcu.dcdc_volts;
    ConverterCommand { run: world.vcu.dcdc, lowest_input, start_volts }
}

/// What it orders of a pump: run, frequency.
pub(crate) const fn pump_command((run, hertz): (bool, f64)) -> PumpCommand {
    PumpCommand { run, hertz }
}

/// What it orders of the air conditioning.
pub(crate) fn hvac_order(world: &World) -> HvacOrder {
    let hvac = world.vcu.hvac;
    HvacOrder {
        permit: hvac.permit,
        derate: hvac.derate,
        reset: hvac.reset,
        supply_volts: world.supply.volts,
        soc: world.vcu.heard.battery.soc,
    }
}

/// What converter, compressor and air conditioning know of themselves.
pub(crate) fn parts_report(world: &World) -> PartsReport {
    PartsReport {
        leak: Severity::None,
        hvac_fault: world.hvac.faults != 0,
        hvac_on: world.hvac.on,
        heating_fan: if world.hvac.heating { world.hvac.fan } else { 0 },
        compressor_code: world.compressor.fault_code,
        compressor_on: world.compressor.running,
        dcdc_fault: world.dcdc.fault_code != 0,
    }
}
