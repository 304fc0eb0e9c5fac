//! The battery: cells, contactors, the controller's fault table and limits, charging.
//!
//! Each step: contacts and cells move, sensors look, the fault table is walked, limits and the request to open high
//! voltage follow from it, then charging and the coils. Owns `World::pack`, `World::bms`, `World::charger` and the
//! voltage of the high-voltage link. Refuses to lay out frames. Source: BUS-R063 to R117, R144 to R154, JL-R018 to
//! R024, C5-R003 to R011.

mod charging;
mod contactors;
mod controls;
mod limits;
mod monitor;
mod pack;

#[cfg(test)]
pub(crate) use charging::charger as charger_step;
pub(crate) use controls::CONTROLS;
pub(crate) use limits::sent as limits_sent;

use crate::STEP_MS;
use crate::world::{Key, World};

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
    let silence_ms = world.bms.vcu_silence_ms;
    if silence_ms < COMMAND_MS {
        world.bms.hv_wanted = world.bms.vcu.high_voltage;
    }
    world.bms.hv_wanted &= world.driver.key >= Key::On;
    wish.high_voltage |= world.bms.hv_wanted;
    let is_refused = world.bms.isolated || world.bms.defects.negative_cut || stays_open(world);
    if is_refused || charging::forbids_high_voltage(world) {
        wish = contactors::Wish::default();
    }
    let told = world.bms.vcu.link_volts.filter(|_| silence_ms < SILENCE_MS);
    let link_volts = if world.spec.battery.measures_link { Some(world.motor.link_volts) } else { told };
    contactors::drive(world, wish, link_volts);
}

/// Parked with an open interlock or on fire nobody drives off: what is open stays open (BUS-R112, R117, V-8).
fn stays_open(world: &World) -> bool {
    world.bms.forbids_closing && !world.bms.main.driven
}

/// Power-off: every coil is released and everything forgotten but what is counted; latched faults go, too (BUS-R117).
fn sleep(world: &mut World) {
    contactors::drive(world, contactors::Wish::default(), None);
    monitor::forget(world);
    charging::stop(world);
    limits::step(world, &limits::Allowed::none());
}

/// Counts up a span that holds on, or starts it anew.
fn count_while(holds: bool, ms: &mut u64) {
    *ms = if holds { ms.saturating_add(STEP_MS) } else { 0 };
}
