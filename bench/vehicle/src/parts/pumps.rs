//! Steering pump and air compressor: motors that follow a frequency.
//!
//! They obey after the start command; 0 Hz means their own default (BUS-R040, R052). The steering pump is under its own
//! control at the rated speed from power-up, and whenever nothing valid comes from outside (BUS-R118).

use super::take;
use crate::spec::Spec;
use crate::world::{Part, World};
use crate::{Kind, STEP_S};
use protocol_core::vehicle::Node;

/// Rated frequency in Hz: the default of both.
const DEFAULT_HZ: f64 = 50.0;
/// Revolutions per minute and Hz of a motor with two pole pairs.
const RPM_PER_HZ: f64 = 30.0;
/// How fast a pump gains or loses speed, in rpm per s.
const SPIN: f64 = 1_500.0;
/// Silence of the vehicle controller after which its command is no longer valid: five of its slowest cycles.
const VALID_MS: u64 = 1_000;
/// Share of the pump's power without anyone turning the wheel.
const IDLE: f64 = 0.35;

/// Lets both follow their command.
pub(super) fn step(world: &mut World, spec: &Spec) {
    let heard = |node: Node, message: &'static str| silence(world, node, message) < VALID_MS;
    let valid = (heard(Node::Steering, "VCU4"), heard(Node::Compressor, "VCU8"));
    let steering_load = if world.motion.kmh() < 5.0 { 0.6 } else { IDLE };
    steering(&mut world.steering, world.vcu.steering, valid.0);
    compressor(&mut world.compressor, world.vcu.compressor, valid.1);
    for (part, watts) in [
        (&mut world.steering, spec.steering_watts * steering_load),
        (&mut world.compressor, spec.compressor_watts),
    ] {
        let share = part.rpm / (DEFAULT_HZ * RPM_PER_HZ);
        take(part, if part.input_volts > 0.0 { watts * share } else { 0.0 });
    }
}

/// How long a node has not heard its command, in ms: the bus has a message for each, the others are told by wire.
pub(super) fn silence(world: &World, node: Node, message: &str) -> u64 {
    let any = world.links.silence_ms(node, Node::Vcu);
    // Before the first step there are no messages: nobody is missed yet.
    match (world.kind, world.links.message_silence_ms(message)) {
        (Kind::Citybus, ms) if ms < u64::MAX => any.max(ms),
        (Kind::Citybus, _) => any,
        (Kind::Jiulong | Kind::C5ev, _) => 0,
    }
}

fn steering(part: &mut Part, (run, hertz): (bool, f64), valid: bool) {
    part.external = valid && run && hertz > 0.0;
    let wanted = if valid { run } else { part.running };
    part.running = wanted && can_run(part);
    spin(part, if part.external { hertz } else { DEFAULT_HZ });
}

fn compressor(part: &mut Part, (run, hertz): (bool, f64), valid: bool) {
    part.external = valid && run && hertz > 0.0;
    part.running = valid && run && can_run(part);
    spin(part, if part.external { hertz } else { DEFAULT_HZ });
}

fn can_run(part: &Part) -> bool {
    part.precharged && part.fault_code == 0
}

fn spin(part: &mut Part, hertz: f64) {
    let wanted = if part.running { hertz * RPM_PER_HZ } else { 0.0 };
    let most = SPIN * STEP_S;
    part.rpm += (wanted - part.rpm).clamp(-most, most);
}
