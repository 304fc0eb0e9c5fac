//! The air conditioning: permit, precharge, fan, cooling and heating by what it has heard.
//!
//! Decides by the last frame of the vehicle controller, as the numbers stand in it (BUS-50): supply below 25 V forbids the start (BUS-R042), state of charge
//! below 20 % all (BUS-R043, R141), 20 to 30 % the start of cooling (BUS-R139, R140, BUS-49). Loses that frame for 10 s
//! while it runs: gives alarm and keeps on until it is powered down (BUS-R133, BUS-21, BUS-22). Setpoints end at 22 and
//! 32 degrees (BUS-R142).

use crate::spec::Spec;
use crate::world::{Hvac, World};
use crate::{STEP_MS, STEP_S};

/// Frames older than this are old news: five cycles of VCU5.
const HEARD_MS: u64 = 500;
/// Silence that gives the alarm (BUS-R133).
const LOST_MS: u64 = 10_000;
/// Precharge after the permit.
const PRECHARGE_MS: u64 = 2_000;
/// A fault that a reset has not cleared in this time stops it.
const RESET_MS: u64 = 2_000;
/// Auxiliary battery below which it does not start, per nominal volt: 25 V of 24 (BUS-R042).
const START_VOLTS: f64 = 25.0 / 24.0;
/// State of charge below which nothing runs, and up to which cooling does not start.
const SOC: (f64, f64) = (0.20, 0.30);
/// Lowest setpoint of cooling and highest of heating (BUS-R142).
const SETPOINT: (f64, f64) = (22.0, 32.0);
/// Power of the fan at its highest step, as a share of the whole.
const FAN: f64 = 0.04;
/// Share of the power that is left when derated (BUS-R046).
const DERATED: f64 = 0.5;
/// Heat moved per electrical power.
const COOLING: f64 = 2.2;
/// Time constant of the cabin without it, in s.
const CABIN_S: f64 = 900.0;

/// Lets it run for one step.
pub(super) fn step(world: &mut World, spec: &Spec) {
    let silence = world.hvac.silence_ms;
    let powered = world.hv_connected() && world.vcu.hvac.relay;
    let awake = world.is_awake();
    let hvac = &mut world.hvac;
    power(hvac, powered && awake, spec);
    faults(hvac, powered);
    let lost = hvac.on && silence >= LOST_MS;
    hvac.communication_alarm = powered && (hvac.communication_alarm || lost) && silence >= HEARD_MS;
    climate(hvac);
    warmth(world, spec);
}

/// Permit, precharge and start.
fn power(hvac: &mut Hvac, powered: bool, spec: &Spec) {
    let heard = hvac.heard;
    let permitted = powered && heard.permit;
    hvac.permitted_ms = if permitted { hvac.permitted_ms.saturating_add(STEP_MS) } else { 0 };
    hvac.precharged = hvac.permitted_ms >= PRECHARGE_MS;
    let starts = heard.supply_volts >= START_VOLTS * spec.low_volts;
    let charged = heard.soc.is_some_and(|soc| soc >= SOC.0);
    hvac.on = permitted && !hvac.stopped && charged && (hvac.on || starts);
}

/// A fault waits for the reset; what the reset does not clear stops it (BUS-R045).
fn faults(hvac: &mut Hvac, powered: bool) {
    let resets = hvac.faults != 0 && hvac.heard.reset;
    hvac.reset_ms = if resets { hvac.reset_ms.saturating_add(STEP_MS) } else { 0 };
    if hvac.faults == 0 || !powered {
        hvac.stopped = false;
    } else if hvac.reset_ms >= RESET_MS {
        hvac.stopped = true;
    }
}

/// Fan, cooling and heating.
fn climate(hvac: &mut Hvac) {
    let soc = hvac.heard.soc.unwrap_or(0.0);
    if !hvac.on {
        (hvac.fan, hvac.cooling, hvac.heating) = (0, false, false);
        return;
    }
    let cool_to = hvac.setpoint_celsius.max(SETPOINT.0);
    let heat_to = hvac.setpoint_celsius.min(SETPOINT.1);
    let too_warm = hvac.cabin_celsius - cool_to;
    let too_cold = heat_to - hvac.cabin_celsius;
    let may_start = hvac.precharged && soc > SOC.1;
    hvac.cooling = if hvac.cooling { too_warm > -0.5 } else { may_start && too_warm > 1.0 };
    hvac.heating = if hvac.heating { too_cold > -0.5 } else { hvac.precharged && too_cold > 1.0 };
    hvac.fan = match too_warm.max(too_cold) {
        far if far > 5.0 => 3,
        far if far > 2.0 => 2,
        _ => 1,
    };
}

fn warmth(world: &mut World, spec: &Spec) {
    let hvac = &mut world.hvac;
    let full = spec.hvac_watts * if hvac.heard.derate { DERATED } else { 1.0 };
    let busy = if hvac.cooling || hvac.heating { full } else { 0.0 };
    hvac.watts = busy + FAN * spec.hvac_watts * f64::from(hvac.fan) / 3.0;
    let heat = match (hvac.cooling, hvac.heating) {
        (true, _) => -COOLING * busy,
        (false, true) => busy,
        _ => 0.0,
    };
    hvac.cabin_celsius +=
        heat / spec.cabin * STEP_S + (world.road.celsius - hvac.cabin_celsius) * STEP_S / CABIN_S;
}
