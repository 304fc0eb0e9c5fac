//! The battery: cells, contactors, the controller's fault table and limits, charging.
//!
//! Each step: contacts and cells move, sensors look, the fault table is walked, limits and the request to open high
//! voltage follow from it, then charging and the coils. Owns `World::pack`, `World::bms`, `World::charger` and the
//! voltage of the high-voltage link. Refuses to lay out frames. Source: BUS-R063 to R117, R144 to R154, JL-R018 to
//! R024, C5-R003 to R011.

mod charging;
mod contactors;
mod controls;
mod faults;
mod limits;
mod monitor;
mod pack;
mod spec;

pub(crate) use controls::CONTROLS;

use crate::world::{Key, World};
use crate::{Kind, STEP_MS};
use protocol_core::vehicle::Node;

/// Silence of another node that counts as lost communication: fault 18 (BUS-R115), C5-R005, C5-R007.
const SILENCE_MS: u64 = 5_000;
/// A command older than this is not obeyed; the last one heard holds.
const COMMAND_MS: u64 = 500;

/// Builds the battery in the size of the vehicle.
pub(crate) fn build(world: &mut World) {
    pack::build(world);
    charging::build(world);
    pack::measure(world);
    limits::step(world, &limits::Allowed::default());
}

/// Lets one step pass.
pub(crate) fn step(world: &mut World) {
    let precharge_amps = contactors::step(world);
    let load = charging::load(world, precharge_amps);
    pack::step(world, load);
    pack::measure(world);
    if !world.is_awake() {
        sleep(world);
        return;
    }
    let allowed = monitor::step(world);
    monitor::hv_off(world);
    limits::step(world, &allowed);
    let mut wish = charging::step(world);
    let heard = command_silence_ms(world);
    if heard < COMMAND_MS {
        world.bms.hv_wanted = world.vcu.hv_command;
    }
    world.bms.hv_wanted &= world.driver.key >= Key::On;
    wish.high_voltage |= world.bms.hv_wanted;
    if world.bms.isolated || world.bms.defects.negative_cut || charging::forbids_high_voltage(world) {
        wish = contactors::Wish::default();
    }
    contactors::drive(world, wish, heard < SILENCE_MS);
}

/// Returns for how long nobody has told what high voltage is to do, in milliseconds: on the bus VCU3 says so, and brings
/// the link voltage by which the main contactor is closed (BUS-R036).
fn command_silence_ms(world: &World) -> u64 {
    let node_ms = world.links.silence_ms(Node::Bms, Node::Vcu);
    match (world.kind, world.links.message_silence_ms("VCU3")) {
        // Before the first step there are no messages: nobody is missed yet.
        (Kind::Citybus, ms) if ms < u64::MAX => node_ms.max(ms),
        _ => node_ms,
    }
}

/// Power-off: every coil is released and everything forgotten but what is counted; latched faults go, too (BUS-R117).
fn sleep(world: &mut World) {
    contactors::drive(world, contactors::Wish::default(), false);
    monitor::forget(world);
    charging::stop(world);
    limits::step(world, &limits::Allowed::none());
}

/// Counts up a span that holds on, or starts it anew.
fn count_while(holds: bool, ms: &mut u64) {
    *ms = if holds { ms.saturating_add(STEP_MS) } else { 0 };
}
