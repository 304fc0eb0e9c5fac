//! Motion, motor, heat and energy: what the vehicle does with the torque that it is given.
//!
//! Owns [`crate::world::Motion`], [`crate::world::Motor`] and the ledger [`crate::world::Energy`]. Forces are summed
//! at the wheels and integrated with the mean speed of the step, so that work and kinetic energy agree. Knows no driver
//! and no rule; what the motor controller was told arrives as [`crate::world::Motor::heard`].
//!
//! Not supported: wheel slip, gearbox losses, a motor that generates with its controller off.

mod motor;
mod readouts;

pub(crate) use motor::STIFFNESS;
pub(crate) use readouts::readouts;

use crate::STEP_S;
use crate::control::{Control, Group, Takes, Word, flag, is_on};
use crate::spec::Spec;
use crate::world::{Gear, World};

/// Gravity in m/s^2.
const GRAVITY: f64 = 9.81;
/// Share of the weight that the parking brake holds.
const PARKING: f64 = 0.25;

/// Lets the vehicle move for one step.
pub(crate) fn step(world: &mut World) {
    let spec = world.spec;
    motor::torque(world, spec);
    let omega = spec.omega(roll(world, spec));
    motor::power(world, spec, omega);
    motor::heat(world, spec);
}

/// Moves the mass and returns its mean speed in m/s.
fn roll(world: &mut World, spec: &Spec) -> f64 {
    let before = world.motion.metres_per_s;
    let slope = world.road.slope_percent / 100.0;
    let level = 1.0 / (1.0 + slope * slope).sqrt();
    let weight = spec.mass_kg * GRAVITY;
    let climb = weight * slope * level;
    let rolling = spec.rolling * weight * level;
    let drag = spec.drag * before * before;
    let brakes = friction_brakes(world, spec, before);
    let push = spec.newton(world.motor.nm) - climb;
    let hold = rolling + drag + brakes;
    let force = match before {
        0.0 if push.abs() <= hold => 0.0,
        0.0 => push - hold * push.signum(),
        _ => push - hold * before.signum(),
    };
    let inertia = spec.mass_kg * spec.rotating;
    let mut after = before + force / inertia * STEP_S;
    // What resists can stop a vehicle but never drive it backwards: it rests one step before it may roll off again.
    if before * after < 0.0 {
        after = 0.0;
    }
    let mean = (before + after) / 2.0;
    let metres = mean * STEP_S;
    world.motion.metres_per_s = after;
    world.motion.metres += metres.abs();
    world.motor.rpm = spec.rpm(after);
    world.energy.resistance += (rolling + drag) * metres.abs();
    world.energy.brakes += brakes * metres.abs();
    world.energy.climb += climb * metres;
    mean
}

/// Force of the friction brakes in N: what the pedal asks for, less what regeneration already does.
fn friction_brakes(world: &World, spec: &Spec, speed: f64) -> f64 {
    let electric = -spec.newton(world.motor.nm) * speed.signum();
    let pedal = world.driver.brake * spec.brake_newton;
    let pedal = if speed == 0.0 { pedal } else { (pedal - electric.max(0.0)).max(0.0) };
    // The pawl of P is pulled by wire.
    let parked = world.driver.parking_brake || world.vcu.gear == Some(Gear::P);
    pedal + if parked { PARKING * spec.mass_kg * GRAVITY } else { 0.0 }
}

impl World {
    /// Energy of the moving mass, in J.
    pub fn kinetic_joules(&self) -> f64 {
        let spec = self.spec;
        0.5 * spec.mass_kg * spec.rotating * self.motion.metres_per_s * self.motion.metres_per_s
    }
}

const CELSIUS: Takes = Takes::Number { min: -40.0, max: 210.0, step: 1.0, unit: "°C" };

/// Motor and its controller.
pub(crate) const CONTROLS: &[Control] = &[
    Control::new(
        "motor.fault_code",
        ["电机故障代码", "Motor fault code"],
        Group::Motor,
        Takes::Number { min: 0.0, max: 255.0, step: 1.0, unit: "" },
        |world| Some(f64::from(world.motor.fault_code)),
        |world, setting| world.motor.fault_code = setting.unwrap_or_default() as u8,
    ),
    Control::new(
        "motor.celsius",
        ["电机温度", "Motor temperature"],
        Group::Motor,
        CELSIUS,
        |world| world.motor.celsius_override,
        |world, setting| world.motor.celsius_override = setting,
    )
    .free(),
    Control::new(
        "motor.inverter_celsius",
        ["电机控制器温度", "Motor controller temperature"],
        Group::Motor,
        CELSIUS,
        |world| world.motor.inverter_celsius_override,
        |world, setting| world.motor.inverter_celsius_override = setting,
    )
    .free(),
    Control::new(
        "motor.own_bus",
        ["电机控制器在另一路 CAN", "Motor controller on a bus of its own"],
        Group::Motor,
        Takes::Flag,
        |world| flag(world.motor.own_bus),
        |world, setting| world.motor.own_bus = is_on(setting),
    )
    .optional(),
];

/// The protection that a person sets, by the vehicle's words.
pub(crate) const fn protection(words: &'static [Word]) -> Control {
    Control::new(
        "motor.protection",
        ["电机保护", "Motor protection"],
        Group::Motor,
        Takes::Choice(words),
        motor::get_protection,
        motor::set_protection,
    )
}
