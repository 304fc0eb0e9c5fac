//! The vehicle controller: key, READY, gear, torque, limits, faults, and what it commands its parts.
//!
//! Owns [`crate::world::Vcu`] and the motor's wanted torque. What it knows of the battery it has heard
//! ([`crate::world::Heard`]), so that a battery which falls silent leaves it with old figures and its watch. Refuses to
//! open or close a contactor itself: it asks, the battery acts.
//! Source: rules BUS-R014 to R048, R065, R076 to R082, R130 to R132, JL-R009 to R017, C5-R012 to R014.

mod controls;
mod faults;
mod limits;
mod orders;
mod power_up;
mod shift;
mod torque;

pub(crate) use controls::CONTROLS;
pub(crate) use limits::is_warm;

use crate::spec;
use crate::world::{Key, World};

/// Gives the vehicle controller what it remembers from yesterday.
pub(crate) fn build(world: &mut World) {
    world.vcu.joules_per_metre = spec::of(world.kind).joules_per_metre;
    power_up::hear(world);
    orders::range(world);
}

/// Lets the vehicle controller decide once.
pub(crate) fn step(world: &mut World) {
    let spec = spec::of(world.kind);
    power_up::hear(world);
    power_up::key(world);
    power_up::high_voltage(world);
    power_up::ready(world, spec);
    shift::step(world, spec);
    faults::step(world);
    limits::step(world, spec);
    torque::step(world, spec);
    orders::step(world, spec);
    if world.driver.key < Key::On {
        world.vcu.gear = None;
    }
}
