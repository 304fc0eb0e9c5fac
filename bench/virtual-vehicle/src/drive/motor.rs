//! The motor and its controller: torque, electrical power, heat, protections.
//!
//! Electrical power is mechanical power and three losses: a share of it, the copper's, and the controller's own. All
//! of it comes out of the link, whose voltage the battery's module owns: nothing flows while the contactors are open.
//! Protections from temperature and speed are this module's; the others are set by a person.

use crate::STEP_S;
use crate::control::Setting;
use crate::spec::Spec;
use crate::told::Hold;
use crate::world::World;

/// Torque that the motor gives in speed mode for each rpm that is missing, in Nm; the vehicle controller knows it.
pub(crate) const STIFFNESS: f64 = 1.0;
/// Time from no torque to the largest, in s.
const FULL_TORQUE_S: f64 = 0.3;
/// Share of the heat that the windings take; the rest is the controller's.
const WINDING_SHARE: f64 = 0.6;
/// Thermal mass of winding and controller in J/K per W of the motor's rating.
const THERMAL_MASS: (f64, f64) = (0.5, 0.12);
/// Cooling of winding and controller in W/K per W of rating.
const COOLING: (f64, f64) = (4.0e-4, 6.0e-4);
/// Winding and controller temperature above which the protection bits are set.
pub(crate) const TOO_HOT: (f64, f64) = (150.0, 90.0);

/// Gives the torque that is wanted, as far and as fast as the motor can.
pub(super) fn torque(world: &mut World, spec: &Spec) {
    let can = world.hv_connected() && world.motor.fault_code == 0 && world.motor.protections_set == 0;
    let command = world.motor.heard.filter(|command| can && command.enabled);
    world.motor.running = command.is_some();
    world.motor.wanted_nm = match command.map(|command| command.hold) {
        None => 0.0,
        Some(Hold::Torque(nm)) => nm.clamp(-spec.max_nm, spec.max_nm),
        Some(Hold::Speed(rpm)) => (STIFFNESS * (rpm - world.motor.rpm)).clamp(-spec.max_nm, spec.max_nm),
    };
    world.motor.peak_nm = if world.motor.running {
        spec.driving_nm(spec.max_watts, spec.omega(world.motion.metres_per_s).abs())
    } else {
        0.0
    };
    if !world.motor.running {
        world.motor.nm = 0.0;
        return;
    }
    let most = spec.max_nm * STEP_S / FULL_TORQUE_S;
    let motor = &mut world.motor;
    // Less torque comes at once: a limit that falls is kept in the same step.
    let falls = motor.wanted_nm * motor.nm >= 0.0 && motor.wanted_nm.abs() < motor.nm.abs();
    motor.nm =
        if falls { motor.wanted_nm } else { motor.nm + (motor.wanted_nm - motor.nm).clamp(-most, most) };
}

/// Takes the power from the link that torque and speed need.
pub(super) fn power(world: &mut World, spec: &Spec, omega: f64) {
    let nm = world.motor.nm;
    let mechanical = nm * omega;
    let loss = if world.motor.running {
        spec.idle_watts + Spec::LOSS * mechanical.abs() + spec.copper_watts(nm)
    } else {
        0.0
    };
    let motor = &mut world.motor;
    motor.watts = mechanical + loss;
    let share = nm.abs() / spec.max_nm;
    motor.phase_amps =
        share * spec.max_watts / (0.6 * spec.link_volts) * if motor.watts < 0.0 { -1.0 } else { 1.0 };
    motor.phase_volts =
        0.4 * motor.link_volts * (motor.rpm.abs() / spec.overspeed_rpm() + 0.1 * share).min(1.0);
    world.energy.motor += motor.watts * STEP_S;
    world.energy.motor_heat += loss * STEP_S;
    world.energy.accessories += world.accessory_watts() * STEP_S;
    heat_up(world, spec, loss);
}

fn heat_up(world: &mut World, spec: &Spec, loss: f64) {
    let ambient = world.road.celsius;
    let cooler = if world.vcu.coolant_pump { 1.0 } else { 0.3 } + 0.5 * f64::from(world.vcu.coolant_fan);
    let warm = |celsius: f64, watts: f64, mass: f64, cooling: f64| {
        let out = cooling * spec.max_watts * cooler * (celsius - ambient);
        celsius + (watts - out) / (mass * spec.max_watts) * STEP_S
    };
    let motor = &mut world.motor;
    motor.celsius = warm(motor.celsius, WINDING_SHARE * loss, THERMAL_MASS.0, COOLING.0);
    motor.inverter_celsius =
        warm(motor.inverter_celsius, (1.0 - WINDING_SHARE) * loss, THERMAL_MASS.1, COOLING.1);
}

/// Puts a person's temperatures in place and sets the protections that follow from what is.
pub(super) fn heat(world: &mut World, spec: &Spec) {
    let motor = &mut world.motor;
    motor.celsius = motor.celsius_override.unwrap_or(motor.celsius);
    motor.inverter_celsius = motor.inverter_celsius_override.unwrap_or(motor.inverter_celsius);
    let bits = spec.protections;
    let seen = [
        motor.celsius > TOO_HOT.0,
        motor.inverter_celsius > TOO_HOT.1,
        motor.rpm.abs() > spec.overspeed_rpm(),
    ];
    let own = bits.iter().zip(seen).fold(0, |bits, (bit, is)| bits | u32::from(is) << bit);
    motor.protections = motor.protections_set | own;
}

pub(super) fn get_protection(world: &World) -> Setting {
    Some(match world.motor.protections_set {
        0 => 0.0,
        bits => f64::from(bits.trailing_zeros() + 1),
    })
}

pub(super) fn set_protection(world: &mut World, setting: Setting) {
    world.motor.protections_set = match setting.unwrap_or_default() as u32 {
        0 => 0,
        word => 1 << (word - 1),
    };
}
