//! Brake air and brake vacuum: used by the pedal, restored by the compressor.
//!
//! Not supported: the circuits behind the reservoirs, the dryer.

use crate::STEP_S;
use crate::world::World;

/// Pressure that pressing the pedal to the floor takes from each reservoir, in MPa.
const PEDAL_MPA: f64 = 0.04;
/// Share of that which the rear reservoir gives.
const REAR: f64 = 0.9;
/// Leakage in MPa per s.
const LEAK_MPA_PER_S: f64 = 0.000_01;
/// What a compressor at its default speed adds to both, in MPa per s.
const PUMP_MPA_PER_S: f64 = 0.006;
/// Safety valve in MPa.
const VALVE_MPA: f64 = 0.9;
/// Vacuum that pressing the pedal to the floor takes, in kPa.
const PEDAL_KPA: f64 = 15.0;
/// What the pump adds to the vacuum, in kPa per s.
const PUMP_KPA_PER_S: f64 = 6.0;
/// Vacuum that the pump reaches, in kPa.
const VACUUM_MAX: f64 = 80.0;
/// Compressor speed in rpm at which it gives what is said here.
const RATED_RPM: f64 = 1_500.0;

/// Uses and restores.
pub(super) fn step(world: &mut World) {
    if !world.spec.has_air {
        return;
    }
    let pump = world.compressor.rpm / RATED_RPM;
    let air = &mut world.air;
    let pressed = (world.driver.brake - air.pressed).max(0.0);
    air.pressed = world.driver.brake;
    let gained = (PUMP_MPA_PER_S * pump - LEAK_MPA_PER_S) * STEP_S;
    air.front_mpa = (air.front_mpa + gained - PEDAL_MPA * pressed).clamp(0.0, VALVE_MPA);
    air.rear_mpa = (air.rear_mpa + gained - REAR * PEDAL_MPA * pressed).clamp(0.0, VALVE_MPA);
    if let Some(mpa) = air.mpa_override {
        (air.front_mpa, air.rear_mpa) = (mpa, mpa);
    }
    if world.spec.has_vacuum {
        let change = PUMP_KPA_PER_S * pump * STEP_S - PEDAL_KPA * pressed;
        air.vacuum_kpa = (air.vacuum_kpa + change).clamp(0.0, VACUUM_MAX);
    }
}
