//! What the vehicle controller commands its parts, and the range that it forecasts.
//!
//! Steering runs from START on whatever the hand brake does (BUS-R041); the compressor by reservoir pressure; the
//! DC/DC converter while the link is live, and only by this controller (BUS-R030); the air conditioning's permit 3 s
//! after its relay (BUS-R044), its derate below 30 % (BUS-R046), a reset on its faults (BUS-R045).

use super::power_up::is_live;
use crate::spec::Spec;
use crate::world::{Key, Relays, World};
use crate::{STEP_MS, STEP_S};

/// From the relay's command to the permit (BUS-R044).
const PERMIT_MS: u64 = 3_000;
/// A reset lasts this long.
const RESET_MS: u64 = 3_000;
/// State of charge below which the air conditioning is derated (BUS-R046, BUS-49).
const DERATE_SOC: f64 = 0.30;
/// Air pressure in MPa below which the compressor starts, and above which it stops.
const AIR: (f64, f64) = (0.70, 0.82);
/// Vacuum in kPa below which the pump starts, and above which it stops.
const VACUUM: (f64, f64) = (55.0, 72.0);
/// Above this speed in km/h the wheel turns easily: the pump is slowed down; below, its own default (0) is best.
const EASY_KMH: f64 = 20.0;
/// Frequency of the slowed pump in Hz.
const EASY_HZ: f64 = 35.0;
/// Fan low and high by the hotter of winding (less 30) and controller, in degrees Celsius.
const COOLANT: [f64; 2] = [60.0, 70.0];
/// Distance over which the consumption is averaged, in m.
const MEMORY_M: f64 = 10_000.0;
/// Share of the energy that is counted on.
const USABLE: f64 = 0.92;
/// Time from sending the pantograph up to contact.
const PANTOGRAPH_MS: u64 = 4_000;

/// Commands every part.
pub(super) fn step(world: &mut World, spec: &Spec) {
    let live = is_live(world);
    let vcu = &mut world.vcu;
    vcu.dcdc = live;
    vcu.steering = (vcu.started && live, if world.motion.kmh() > EASY_KMH { EASY_HZ } else { 0.0 });
    compressor(world, spec, live);
    hvac(world, live);
    charging(world);
    relays(world, live);
    coolant(world);
    consumption(world);
    if let Some(soc) = world.vcu.heard.battery.soc {
        range(world, soc);
    }
}

fn compressor(world: &mut World, spec: &Spec, live: bool) {
    let air = world.air.front_mpa.min(world.air.rear_mpa);
    let vacuum = world.air.vacuum_kpa;
    let vans = spec.has_vacuum;
    let low = air < AIR.0 || (vans && vacuum < VACUUM.0);
    let full = air > AIR.1 && (!vans || vacuum > VACUUM.1);
    let run = live && spec.compressor_watts > 0.0 && !full && (low || world.vcu.compressor.0);
    world.vcu.compressor = (run, 0.0);
}

fn hvac(world: &mut World, live: bool) {
    let vcu = &mut world.vcu;
    let spans = &mut vcu.spans;
    // A battery that may give nothing has nothing for comfort (BUS-R082).
    let may = vcu.heard.battery.discharge_limit_amps.is_some_and(|amps| amps > 0.0);
    vcu.hvac.relay = live && may && world.driver.air_conditioning && vcu.key >= Key::On;
    spans.hvac_relay_ms = if vcu.hvac.relay { spans.hvac_relay_ms.saturating_add(STEP_MS) } else { 0 };
    vcu.hvac.permit = spans.hvac_relay_ms > PERMIT_MS;
    vcu.hvac.derate = vcu.heard.battery.soc.is_some_and(|soc| soc < DERATE_SOC);
    spans.hvac_fault_ms =
        if vcu.heard.parts.hvac_fault { spans.hvac_fault_ms.saturating_add(STEP_MS) } else { 0 };
    vcu.hvac.reset = (1..=RESET_MS).contains(&spans.hvac_fault_ms);
}

fn charging(world: &mut World) {
    let still = world.motion.metres_per_s == 0.0;
    let vcu = &mut world.vcu;
    let up = world.charger.pantograph && (still || vcu.pantograph_state > 0);
    vcu.spans.pantograph_ms = if up { vcu.spans.pantograph_ms.saturating_add(STEP_MS) } else { 0 };
    vcu.pantograph_state = match vcu.spans.pantograph_ms {
        0 => 0,
        1..=PANTOGRAPH_MS => 1,
        _ => 2,
    };
    vcu.charge_enable = still && (world.charger.plugged || vcu.pantograph_state == 2);
}

/// States of the high-voltage relays; those that this vehicle has not got stay 0 (BUS-R038).
fn relays(world: &mut World, live: bool) {
    let vcu = &mut world.vcu;
    vcu.relays = Relays {
        precharge: vcu.hv_command && !live,
        motor: vcu.hv_command && live,
        accessory: live,
        accessory_precharge: false,
        defrost: false,
        charge: vcu.heard.battery.charge_closed,
        battery: vcu.heard.battery.main_closed == Some(true),
    };
}

fn coolant(world: &mut World) {
    let motor = &world.vcu.heard.motor;
    let hot = (motor.celsius.unwrap_or(0.0) - 30.0).max(motor.inverter_celsius.unwrap_or(0.0));
    world.vcu.coolant_pump = world.vcu.ready;
    world.vcu.coolant_fan = COOLANT.iter().filter(|from| hot > **from).count() as u8;
}

fn consumption(world: &mut World) {
    let metres = world.motion.metres_per_s.abs() * STEP_S;
    if metres == 0.0 {
        return;
    }
    let joules = world.load_watts() * STEP_S;
    let vcu = &mut world.vcu;
    vcu.joules_per_metre += (joules - vcu.joules_per_metre * metres) / MEMORY_M;
}

/// Forecasts the range from the charge and the mean consumption.
pub(super) fn range(world: &mut World, soc: f64) {
    let spec = world.spec;
    let joules = USABLE * soc * spec.battery.capacity_ah * 3_600.0 * spec.link_volts;
    let lowest = 0.6 * spec.joules_per_metre;
    world.vcu.range_km = joules / world.vcu.joules_per_metre.max(lowest) / 1_000.0;
}
