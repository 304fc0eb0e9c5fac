//! From the key to READY, and back: START, high voltage on request, the battery's request to open it.
//!
//! START closes high voltage; the battery precharges; READY follows when the link holds and torque may be sent. A request
//! of the battery to open is answered within 5 s (BUS-R065, R076, R078): the torque fades for three, then the command
//! falls. High voltage that was cut off comes back only after the key has been turned off. The key comes by wire and in
//! the cluster's message (V-3).

use crate::STEP_MS;
use crate::spec::Spec;
use crate::world::{Key, VcuSpans, World};
use protocol_core::model::Severity;

/// The key falls back from START to ON after this.
const START_MS: u64 = 500;
/// Time for the torque to fade before high voltage is opened; the rule allows 5 s until it is open.
pub(super) const HV_OFF_ANSWER_MS: u64 = 3_000;
/// Frames of the cluster older than this no longer count: three of its 1 s cycles.
pub(super) const CLUSTER_HEARD_MS: u64 = 3_000;
/// The motor controller is lost after this: ten of its cycles (V-5).
const MOTOR_LOST_MS: u64 = 1_000;
/// Share of the nominal voltage above which the link counts as live.
const LIVE: f64 = 0.6;
/// The link has to be live this long before READY.
const READY_MS: u64 = 300;

/// The cluster is heard now.
pub(super) fn hears_cluster(world: &World) -> bool {
    world.meter.silent_ms < CLUSTER_HEARD_MS
}

/// The motor controller is heard now.
pub(super) fn hears_motor(world: &World) -> bool {
    world.vcu.heard.motor_silence_ms < MOTOR_LOST_MS
}

/// Position of the key by both ways: a cluster that says "off" is obeyed, and so is its START while the wire is on.
fn key_position(world: &World) -> Key {
    let wire = world.driver.key;
    match world.meter.key.filter(|_| hears_cluster(world)) {
        Some(said @ (Key::Lock | Key::Accessory)) => said.min(wire),
        Some(Key::Start) => wire.max(if wire >= Key::On { Key::Start } else { wire }),
        Some(Key::On) | None => wire,
    }
}

/// Follows the key.
pub(super) fn key(world: &mut World) {
    let position = key_position(world);
    world.vcu.key = position;
    world.vcu.parking_brake =
        if hears_cluster(world) { world.meter.parking_brake } else { world.driver.parking_brake };
    let spans = &mut world.vcu.spans;
    match position {
        Key::Lock | Key::Accessory => {
            world.vcu.started = false;
            world.vcu.hv_cutoff = false;
            *spans = VcuSpans { pantograph_ms: spans.pantograph_ms, ..VcuSpans::default() };
        }
        Key::On => {}
        Key::Start => world.vcu.started |= !world.vcu.hv_cutoff && !world.charger.plugged,
    }
    // A spring turns the key back.
    if world.driver.key == Key::Start {
        world.vcu.spans.start_ms += STEP_MS;
        if world.vcu.spans.start_ms >= START_MS {
            world.driver.key = Key::On;
        }
    } else {
        world.vcu.spans.start_ms = 0;
    }
}

/// Asks for high voltage, or lets it go.
pub(super) fn high_voltage(world: &mut World, spec: &Spec) {
    let vcu = &mut world.vcu;
    vcu.spans.hv_off_ms = match vcu.heard.battery.hv_off_request && !vcu.ignores_hv_off && vcu.hv_command {
        true => vcu.spans.hv_off_ms + STEP_MS,
        false => 0,
    };
    if vcu.spans.hv_off_ms >= HV_OFF_ANSWER_MS {
        vcu.hv_cutoff = true;
        vcu.started = false;
    }
    if world.charger.plugged {
        vcu.started = false;
    }
    // While the bus charges, its converter and air conditioning are this controller's, not the battery's (BUS-R030).
    let serves_charging = spec.serves_charging && world.charger.plugged && vcu.key >= Key::On;
    vcu.hv_command = (vcu.started || serves_charging) && !vcu.hv_cutoff;
}

/// Share of the torque that is left while a request to open high voltage is being answered.
pub(super) fn fading(world: &World) -> f64 {
    1.0 - (world.vcu.spans.hv_off_ms as f64 / HV_OFF_ANSWER_MS as f64).min(1.0)
}

/// Watches the link by what is heard: the main contactor of the battery, the voltage of the motor controller.
pub(super) fn link(world: &mut World, spec: &Spec) {
    let heard = &world.vcu.heard;
    let is_closed = heard.battery.main_closed.unwrap_or(true);
    let link_volts = heard.motor.link_volts.filter(|_| hears_motor(world));
    let is_up = link_volts.map(|volts| volts > LIVE * spec.link_volts);
    // Without the motor controller's voltage the battery's word has to do; one of the two must be there.
    let live = is_closed && is_up.unwrap_or(heard.battery.main_closed.is_some());
    world.vcu.link_volts = link_volts;
    let spans = &mut world.vcu.spans;
    spans.hv_on_ms = if live { spans.hv_on_ms.saturating_add(STEP_MS) } else { 0 };
}

/// Decides whether torque may be given.
pub(super) fn ready(world: &mut World) {
    let rolls = world.motion.metres_per_s != 0.0;
    let hears_motor = hears_motor(world);
    let vcu = &mut world.vcu;
    let battery = &vcu.heard.battery;
    let may_drive = battery.discharge_limit_amps.is_some_and(|amps| amps > 0.0);
    let may_brake = rolls && battery.charge_limit_amps.is_some_and(|amps| amps > 0.0);
    vcu.ready = vcu.started
        && vcu.hv_command
        && vcu.spans.hv_on_ms >= READY_MS
        && vcu.pantograph_state == 0
        && vcu.own_severity < Severity::Stop
        && (may_drive || may_brake)
        && hears_motor
        && vcu.heard.motor.fault_code == 0;
}

/// The link is live and accessories may run.
pub(super) fn is_live(world: &World) -> bool {
    world.vcu.spans.hv_on_ms > 0
}
