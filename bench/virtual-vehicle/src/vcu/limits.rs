//! How much power and torque is allowed now, and who says so.
//!
//! The vehicle drives strictly within what the battery sends (BUS-R082), less what the accessories take. On top of that
//! come the limp mode after losing the battery (BUS-R080), heat, faults, and the fading of a cut-off. The factors are a
//! table: the product is what is left.

use super::{faults, power_up};
use crate::spec::Spec;
use crate::world::World;
use protocol_core::model::Severity;

/// Share of the battery's limit that is used: the rest is for a voltage that sags within a step.
const MARGIN: f64 = 0.97;
/// Share of the rated power below which the driver is told of a limit.
const TOLD: f64 = 0.8;
/// Winding and controller temperature at which the torque starts to fall, and over how many degrees it falls to none.
const WARM: [(f64, f64); 2] = [(140.0, 20.0), (85.0, 10.0)];
/// Share of the power with an ordinary fault of its own (BUS level 2), and with an alarm of the car (C5-R014).
const DERATED: f64 = 0.5;

/// Works out the limits.
pub(super) fn step(world: &mut World, spec: &Spec) {
    let cool = cool(world);
    let factors = [
        power_up::fading(world),
        cool,
        if world.vcu.own_severity >= Severity::Derate { DERATED } else { 1.0 },
        if faults::alarms(world) { DERATED } else { 1.0 },
        if world.driver.economy { 0.85 } else { 1.0 },
    ];
    let factor: f64 = factors.iter().product();
    let battery = &world.vcu.heard.battery;
    let accessories = world.accessory_watts();
    // A limit that has never been heard allows nothing.
    let limit_watts = |amps: Option<f64>| MARGIN * amps.unwrap_or(0.0) * battery.volts.unwrap_or(0.0);
    let from_battery = limit_watts(battery.discharge_limit_amps) - accessories;
    let own = factor * if world.vcu.limp { spec.limp_watts } else { spec.max_watts };
    // What the accessories eat does not reach the battery: the motor may give back so much more.
    let into_battery = limit_watts(battery.charge_limit_amps) + accessories;
    let may_charge = battery.charge_limit_amps.is_some_and(|amps| amps > 0.0);
    let vcu = &mut world.vcu;
    vcu.allowed_watts = if vcu.ready { own.min(from_battery).max(0.0) } else { 0.0 };
    vcu.may_regenerate = vcu.ready && !vcu.limp && !vcu.seat_cut && may_charge;
    vcu.allowed_regeneration_watts =
        if vcu.may_regenerate { (factor * spec.regeneration_watts).min(into_battery).max(0.0) } else { 0.0 };
    let told = TOLD * spec.max_watts * if world.driver.economy { 0.85 } else { 1.0 };
    // A limit of 0 takes READY, too, and is the strictest limit of all.
    let nothing =
        vcu.heard.battery.discharge_limit_amps == Some(0.0) && vcu.started && vcu.spans.hv_on_ms > 0;
    vcu.power_limited = vcu.limp || nothing || (vcu.ready && vcu.allowed_watts < told);
    vcu.torque_limited = cool < 1.0 || vcu.seat_cut;
}

/// Share of the torque that heat leaves.
fn cool(world: &World) -> f64 {
    let share = |celsius: f64, (from, over): (f64, f64)| (1.0 - (celsius - from) / over).clamp(0.0, 1.0);
    let motor = &world.vcu.heard.motor;
    let share = |celsius: Option<f64>, warm| celsius.map_or(1.0, |celsius| share(celsius, warm));
    share(motor.celsius, WARM[0]).min(share(motor.inverter_celsius, WARM[1]))
}

/// How bad what the motor controller reports is: it stops for a fault and for a protection that has tripped, drives on
/// with less when too hot or too fast, and gives alarm while heat takes torque (JL-R010).
pub(crate) fn motor_severity(world: &World) -> Severity {
    let motor = &world.vcu.heard.motor;
    match (motor.fault_code != 0 || motor.tripped, motor.protections != 0) {
        (true, _) => Severity::Stop,
        (false, true) => Severity::Derate,
        (false, false) if cool(world) < 1.0 => Severity::Warn,
        (false, false) => Severity::None,
    }
}

/// Speed in km/h at which the torque is taken back.
pub(super) fn top_kmh(world: &World, spec: &Spec, reverse: bool) -> f64 {
    let worst = faults::worst(world).max(motor_severity(world));
    match (reverse, worst) {
        (true, _) => spec.top_reverse_kmh,
        (false, Severity::Derate) => spec.derated_top * spec.top_kmh,
        _ => spec.top_kmh,
    }
}
