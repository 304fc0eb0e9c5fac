//! Steering pump and air compressor: motors that follow a frequency.
//!
//! They obey after the start command; 0 Hz means their own default (BUS-R040, R052). The steering pump is under its own
//! control at the rated speed from power-up, and whenever nothing valid comes from outside (BUS-R118).

use super::take;
use crate::STEP_S;
use crate::spec::Spec;
use crate::told::PumpCommand;
use crate::world::{Part, World};

/// Rated frequency in Hz: the default of both.
const DEFAULT_HZ: f64 = 50.0;
/// Revolutions per minute and Hz of a motor with two pole pairs.
const RPM_PER_HZ: f64 = 30.0;
/// How fast a pump gains or loses speed, in rpm per s.
const SPIN: f64 = 1_500.0;
/// Share of the pump's power without anyone turning the wheel.
const IDLE: f64 = 0.35;

/// Lets both follow their command.
pub(super) fn step(world: &mut World, spec: &Spec) {
    let steering_load = if world.motion.kmh() < 5.0 { 0.6 } else { IDLE };
    steering(&mut world.steering, world.parts_heard.steering);
    compressor(&mut world.compressor, world.parts_heard.compressor);
    for (part, watts) in [
        (&mut world.steering, spec.steering_watts * steering_load),
        (&mut world.compressor, spec.compressor_watts),
    ] {
        let share = part.rpm / (DEFAULT_HZ * RPM_PER_HZ);
        take(part, if part.input_volts > 0.0 { watts * share } else { 0.0 });
    }
}

fn steering(part: &mut Part, heard: Option<PumpCommand>) {
    part.external = heard.is_some_and(|command| command.run && command.hertz > 0.0);
    let wanted = heard.map_or(part.running, |command| command.run);
    part.running = wanted && can_run(part);
    spin(part, heard);
}

fn compressor(part: &mut Part, heard: Option<PumpCommand>) {
    part.external = heard.is_some_and(|command| command.run && command.hertz > 0.0);
    part.running = heard.is_some_and(|command| command.run) && can_run(part);
    spin(part, heard);
}

fn can_run(part: &Part) -> bool {
    part.precharged && part.fault_code == 0
}

fn spin(part: &mut Part, heard: Option<PumpCommand>) {
    let hertz = heard.filter(|_| part.external).map_or(DEFAULT_HZ, |command| command.hertz);
    let wanted = if part.running { hertz * RPM_PER_HZ } else { 0.0 };
    let most = SPIN * STEP_S;
    part.rpm += (wanted - part.rpm).clamp(-most, most);
}
