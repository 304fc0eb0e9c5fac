//! Everything on the link but the motor: converter, pumps, air, air conditioning; and the insulation monitor.
//!
//! Each part obeys what the vehicle controller commands, as its page says, and takes its power from the link. Owns
//! [`crate::world::Part`]s, supply, air, air conditioning and insulation.
//! Source: rules BUS-R040 to R048, R052, R118, R121, R133 to R144.

mod air;
mod controls;
mod converter;
mod hvac;
mod insulation;
mod pumps;

pub(crate) use controls::CONTROLS;

use crate::world::{Part, World};
use crate::{STEP_MS, STEP_S};

/// A part's own precharge takes this long.
const PRECHARGE_MS: u64 = 800;
/// A part that runs ends up this much warmer than the air, in degrees.
const WARMER: f64 = 28.0;
/// Time constant of its temperature in s.
const WARM_S: f64 = 400.0;

/// Gives the parts the state of a vehicle that stood over night.
pub(crate) fn build(world: &mut World) {
    converter::rest(world, world.spec);
    world.hvac.cabin_celsius = world.road.celsius;
}

/// Lets every part act for one step.
pub(crate) fn step(world: &mut World) {
    let spec = world.spec;
    let link = if world.hv_connected() { world.motor.link_volts } else { 0.0 };
    let air = world.road.celsius;
    for part in [&mut world.dcdc, &mut world.steering, &mut world.compressor] {
        feed(part, link, air);
    }
    converter::step(world, spec);
    pumps::step(world, spec);
    air::step(world);
    hvac::step(world, spec);
    insulation::step(world);
}

/// What the link does to a part: its voltage, its precharge, its warmth.
fn feed(part: &mut Part, link: f64, air: f64) {
    part.input_volts = link;
    part.powered_ms = if link > 0.0 { part.powered_ms.saturating_add(STEP_MS) } else { 0 };
    part.precharged = part.powered_ms >= PRECHARGE_MS;
    let end = air + if part.running { WARMER } else { 0.0 };
    part.celsius += (end - part.celsius) * STEP_S / WARM_S;
}

/// Takes `watts` from the link.
fn take(part: &mut Part, watts: f64) {
    part.watts = watts;
    part.input_amps = if part.input_volts > 0.0 { watts / part.input_volts } else { 0.0 };
}
