//! The vehicle controller: key, READY, gear, torque, limits, faults, and what it commands its parts.
//!
//! Owns [`crate::world::Vcu`]. What it knows of other nodes it has heard ([`crate::world::Heard`]), so that one which
//! falls silent leaves it with old figures and its watch. Refuses to open or close a contactor itself: it asks, the
//! battery acts.
//! Source: rules BUS-R014 to R048, R065, R072, R076 to R082, R130 to R132, JL-R009 to R017, C5-R012 to R014.

mod controls;
mod faults;
mod limits;
mod orders;
mod power_up;
mod shift;
mod torque;

pub(crate) use controls::{CONTROLS, FALLING_LEVELS, RISING_LEVELS};
pub(crate) use limits::motor_severity;

use crate::world::{Key, World};

/// Gives the vehicle controller what it remembers from yesterday.
pub(crate) fn build(world: &mut World) {
    world.vcu.joules_per_metre = world.spec.joules_per_metre;
    orders::range(world, world.pack.soc);
}

/// Lets the vehicle controller decide once.
pub(crate) fn step(world: &mut World) {
    let spec = world.spec;
    power_up::key(world);
    power_up::high_voltage(world, spec);
    power_up::link(world, spec);
    faults::step(world);
    power_up::ready(world);
    shift::step(world, spec);
    limits::step(world, spec);
    torque::step(world, spec);
    orders::step(world, spec);
    if world.vcu.key < Key::On {
        world.vcu.gear = None;
    }
}
