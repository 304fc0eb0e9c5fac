//! From the key to READY, and back: START, high voltage on request, the battery's request to open it.
//!
//! START closes high voltage; the battery precharges; READY follows when the link holds. A request of the battery to
//! open is answered within 5 s (BUS-R065, R076, R078): the torque fades for three, then the command falls. High voltage
//! that was cut off comes back only after the key has been turned off.

use crate::spec::Spec;
use crate::world::{Contactor, Heard, Key, VcuSpans, World};
use crate::{Kind, STEP_MS};
use protocol_core::model::Severity;
use protocol_core::vehicle::Node;

/// The key falls back from START to ON after this.
const START_MS: u64 = 500;
/// Time for the torque to fade before high voltage is opened; the rule allows 5 s until it is open.
pub(super) const HV_OFF_ANSWER_MS: u64 = 3_000;
/// Frames of the battery older than this are old news: twice its slowest cycle.
const HEARD_MS: u64 = 1_000;
/// Share of the nominal voltage above which the link counts as live.
const LIVE: f64 = 0.6;
/// The link has to be live this long before READY.
const READY_MS: u64 = 300;

/// Takes over what the battery's frames say, while they come.
pub(super) fn hear(world: &mut World) {
    if world.links.silence_ms(Node::Vcu, Node::Bms) >= HEARD_MS {
        return;
    }
    let bms = &world.bms;
    // A welded contactor conducts, whatever its coil does (BUS-44).
    let conducts = |contactor: &Contactor| contactor.closed || contactor.welded;
    let circuit =
        |pair: &[Contactor; 2]| pair.iter().all(conducts) || pair.iter().any(|contactor| contactor.welded);
    world.vcu.heard = Heard {
        hv_off_request: bms.hv_off_request,
        charge_limit_amps: bms.charge_limit_amps,
        discharge_limit_amps: bms.discharge_limit_amps,
        volts: world.pack.volts,
        soc: world.counted_soc(),
        severity: bms.severity,
        main_closed: conducts(&bms.main),
        charge_closed: circuit(&bms.charge_1) || circuit(&bms.charge_2),
    };
}

/// Follows the key.
pub(super) fn key(world: &mut World) {
    let spans = &mut world.vcu.spans;
    match world.driver.key {
        Key::Lock | Key::Accessory => {
            world.vcu.started = false;
            world.vcu.hv_cutoff = false;
            *spans = VcuSpans { pantograph_ms: spans.pantograph_ms, ..VcuSpans::default() };
        }
        Key::On => spans.start_ms = 0,
        Key::Start => {
            world.vcu.started |= !world.vcu.hv_cutoff && !world.charger.plugged;
            spans.start_ms += STEP_MS;
            if spans.start_ms >= START_MS {
                world.driver.key = Key::On;
                world.vcu.spans.start_ms = 0;
            }
        }
    }
}

/// Asks for high voltage, or lets it go.
pub(super) fn high_voltage(world: &mut World) {
    let vcu = &mut world.vcu;
    vcu.spans.hv_off_ms = match vcu.heard.hv_off_request && !vcu.ignores_hv_off && vcu.hv_command {
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
    let serves_charging = world.kind == Kind::Citybus && world.charger.plugged && world.driver.key >= Key::On;
    vcu.hv_command = (vcu.started || serves_charging) && !vcu.hv_cutoff;
}

/// Share of the torque that is left while a request to open high voltage is being answered.
pub(super) fn fading(world: &World) -> f64 {
    1.0 - (world.vcu.spans.hv_off_ms as f64 / HV_OFF_ANSWER_MS as f64).min(1.0)
}

/// Decides whether torque may be given.
pub(super) fn ready(world: &mut World, spec: &Spec) {
    let live = world.hv_connected() && world.motor.link_volts > LIVE * spec.link_volts;
    let vcu = &mut world.vcu;
    vcu.spans.hv_on_ms = if live { vcu.spans.hv_on_ms.saturating_add(STEP_MS) } else { 0 };
    vcu.ready = vcu.started
        && vcu.hv_command
        && vcu.spans.hv_on_ms >= READY_MS
        && vcu.pantograph_state == 0
        && vcu.severity < Severity::Stop
        && world.motor.fault_code == 0;
}

/// The link is live and accessories may run.
pub(super) fn is_live(world: &World) -> bool {
    world.vcu.spans.hv_on_ms > 0
}
