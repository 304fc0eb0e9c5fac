//! What several documents ask of the world in the same words.
//!
//! Pure questions to the [`World`] that rows of more than one message share. Refuses to know raw values that only one
//! message has.

use crate::Kind;
use crate::world::{Charge, Gear, Part, RelayState, World};
use protocol_core::model::Severity;

/// Numbers a choice of words, the first true one; `other` if none is.
pub(super) fn word(choices: &[(bool, f64)], other: f64) -> Option<f64> {
    Some(choices.iter().find(|(holds, _)| *holds).map_or(other, |(_, number)| *number))
}

/// Level where 3 is worst (BUS-R026).
pub(super) fn level_up(severity: Severity) -> Option<f64> {
    Some(match severity {
        Severity::None => 0.0,
        Severity::Warn => 1.0,
        Severity::Derate => 2.0,
        Severity::Stop => 3.0,
    })
}

/// Level or raw value where 1 is worst (BUS-R066, R147, JL-R010, R019, R030).
pub(super) fn level_down(severity: Severity) -> Option<f64> {
    Some(match severity {
        Severity::None => 0.0,
        Severity::Warn => 3.0,
        Severity::Derate => 2.0,
        Severity::Stop => 1.0,
    })
}

/// State of charge in percent, as the vehicle controller last heard it.
pub(super) fn heard_soc(world: &World) -> Option<f64> {
    Some(world.vcu.heard.soc * 100.0)
}

/// State of charge in percent, as the battery controller believes.
pub(super) fn soc(world: &World) -> Option<f64> {
    Some(world.counted_soc() * 100.0)
}

/// Pack voltage in V.
pub(super) fn pack_volts(world: &World) -> Option<f64> {
    Some(world.pack.volts)
}

/// Pack current in A, positive = out of the battery.
pub(super) fn pack_amps(world: &World) -> Option<f64> {
    Some(world.pack.amps)
}

/// Speed in km/h, never negative.
pub(super) fn speed(world: &World) -> Option<f64> {
    Some(world.motion.kmh())
}

/// Accelerator pedal in percent; not known when its sensor is broken (JL-R011).
pub(super) fn accelerator(world: &World) -> Option<f64> {
    (!world.driver.accelerator_fault).then_some(world.driver.accelerator * 100.0)
}

/// Brake pedal in percent; a switch says 0 or 100 (BUS-R019).
pub(super) fn brake(world: &World) -> Option<f64> {
    let brake = world.driver.brake;
    Some(match (world.driver.digital_brake, brake > 0.0) {
        (false, _) => brake * 100.0,
        (true, pressed) => f64::from(u8::from(pressed)) * 100.0,
    })
}

/// The gear that is engaged, numbered by the document; `None` = not known.
pub(super) fn gear(world: &World, n: f64, d: f64, r: f64, p: Option<f64>) -> Option<f64> {
    match world.vcu.gear? {
        Gear::N => Some(n),
        Gear::D => Some(d),
        Gear::R => Some(r),
        Gear::P => p,
        Gear::D1 | Gear::D2 | Gear::D3 | Gear::D4 | Gear::D5 | Gear::D6 => None,
    }
}

/// Protection bit `place` of the motor controller.
pub(super) fn protection(world: &World, place: usize) -> Option<f64> {
    let bit = u32::try_from(place).ok().and_then(|place| world.motor.protections.checked_shr(place));
    Some(f64::from(bit.unwrap_or(0) & 1))
}

/// The motor controller reports a fault.
pub(super) fn motor_fault(world: &World) -> bool {
    world.motor.fault_code != 0 || world.motor.protections != 0
}

/// Motor controller's current out of its direct-current side, in A, positive = drive (BUS-64).
pub(super) fn motor_amps(world: &World) -> Option<f64> {
    let volts = world.motor.link_volts;
    Some(if volts > 1.0 { world.motor.watts / volts } else { 0.0 })
}

/// 0 = stopped, 1 = running, 2 = fault: steering, compressor, DC/DC.
pub(super) fn status(part: &Part) -> Option<f64> {
    word(&[(part.fault_code != 0, 2.0), (part.running, 1.0)], 0.0)
}

/// 0 = open, 1 = closed, 3 = welded (BUS-R068 to R070).
pub(super) fn relay(state: RelayState) -> Option<f64> {
    Some(match state {
        RelayState::Open => 0.0,
        RelayState::Closed => 1.0,
        RelayState::Welded => 3.0,
    })
}

/// The charging state as both bus and cluster count it: idle, charging, complete, fault.
pub(super) fn charge_state(world: &World) -> Option<f64> {
    Some(match world.bms.charge {
        Charge::Idle => 0.0,
        Charge::Charging => 1.0,
        Charge::Complete => 2.0,
        Charge::Fault => 3.0,
    })
}

/// A charger is there.
pub(super) fn plugged(world: &World) -> bool {
    world.charger.plugged
}

/// The battery controller reports the fault whose bit is at this place of its alarm message.
pub(super) fn alarm(world: &World, place: u8) -> bool {
    world.bms.active.iter().any(|fault| fault.code == place)
}

/// The leak level as a severity: level 2 is worse (BUS-100).
pub(super) fn leak(world: &World) -> Severity {
    match world.insulation.level {
        0 => Severity::None,
        1 => Severity::Derate,
        _ => Severity::Stop,
    }
}

/// Cells in one box of the battery.
pub(super) const fn cells_per_box(kind: Kind) -> usize {
    match kind {
        Kind::Citybus => 12,
        Kind::Jiulong | Kind::C5ev => 10,
    }
}

/// Box and place of a cell, both from 1.
pub(super) fn cell_seat(world: &World, cell: usize) -> (f64, f64) {
    let per_box = cells_per_box(world.kind);
    ((cell / per_box + 1) as f64, (cell % per_box + 1) as f64)
}

/// Box and place of a temperature probe, both from 1; probes are spread evenly over the boxes.
pub(super) fn probe_seat(world: &World, probe: usize) -> (f64, f64) {
    let boxes = world.pack.cell_volts.len().div_ceil(cells_per_box(world.kind)).max(1);
    let per_box = world.pack.probe_celsius.len().div_ceil(boxes).max(1);
    ((probe / per_box + 1) as f64, (probe % per_box + 1) as f64)
}

/// Returns the `place`-th highest value and its index; of equals the first one is higher.
pub(super) fn highest(values: &[f64], place: usize) -> Option<(f64, usize)> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]).then(a.cmp(b)));
    order.get(place).map(|index| (values[*index], *index))
}

/// Returns the `place`-th lowest value and its index; of equals the first one is lower.
pub(super) fn lowest(values: &[f64], place: usize) -> Option<(f64, usize)> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]).then(a.cmp(b)));
    order.get(place).map(|index| (values[*index], *index))
}
