//! The torque that the motor is asked for: pedals, gear, seat, limits.
//!
//! The accelerator asks for a share of what the motor could give; the limits cut what is over. Released, the motor
//! brakes a little, with the brake pedal more, as far as the battery may be charged: the friction brakes do the rest.
//! Driver's seat empty for 2 s in D or R: no torque either way until he is back (BUS-R130 to R132).

use super::{limits, power_up};
use crate::STEP_MS;
use crate::spec::Spec;
use crate::world::{Gear, World};

/// The seat has to be left for so long (BUS-R131, BUS-93).
pub(super) const SEAT_MS: u64 = 2_000;
/// Brake pedal above which the accelerator is ignored.
const BRAKE_FIRST: f64 = 0.05;
/// The last km/h below the top speed, over which the torque is taken back.
const TOP_BAND_KMH: f64 = 3.0;
/// Regeneration fades out between these speeds in m/s: a motor cannot hold a vehicle still.
const FADE: (f64, f64) = (0.8, 2.5);
/// Speed in m/s that one step can add: the power counts at its end.
const AHEAD: f64 = 0.05;
/// Accelerator below which the motor starts to brake.
const RELEASED: f64 = 0.08;

/// Decides on the torque.
pub(super) fn step(world: &mut World, spec: &Spec) {
    seat(world);
    let direction = match world.vcu.gear {
        Some(Gear::D) => 1.0,
        Some(Gear::R) => -1.0,
        _ => 0.0,
    };
    let free = world.vcu.ready && !world.vcu.seat_cut && direction != 0.0 && !is_held(world);
    if !free {
        world.vcu.wanted_nm = 0.0;
        return;
    }
    let speed = direction * world.motion.metres_per_s;
    let brake = world.driver.brake;
    let accelerator = match brake > BRAKE_FIRST || world.driver.accelerator_fault {
        true => 0.0,
        false => world.driver.accelerator,
    };
    let driving = driving(world, spec, accelerator, speed, direction < 0.0);
    let braking = braking(world, spec, accelerator, brake, speed);
    world.vcu.wanted_nm = direction * (driving - braking);
}

/// A bus that stands does not drive off with a passenger door open or its parking brake on, as the cluster says (V-3).
fn is_held(world: &World) -> bool {
    let says = world.meter.door_open || world.meter.parking_brake;
    world.motion.metres_per_s == 0.0 && says && power_up::hears_cluster(world)
}

fn seat(world: &mut World) {
    let left = world.meter.seat_left && power_up::hears_cluster(world);
    let spans = &mut world.vcu.spans;
    spans.seat_ms = if left { spans.seat_ms.saturating_add(STEP_MS) } else { 0 };
    world.vcu.seat_cut = spans.seat_ms >= SEAT_MS;
}

fn driving(world: &World, spec: &Spec, accelerator: f64, speed: f64, reverse: bool) -> f64 {
    let omega = spec.omega(speed.max(0.0) + AHEAD);
    let wanted = accelerator * spec.driving_nm(spec.max_watts, omega);
    let allowed = spec.driving_nm(world.vcu.allowed_watts, omega);
    let room = (limits::top_kmh(world, spec, reverse) - speed * 3.6) / TOP_BAND_KMH;
    wanted.min(allowed) * room.clamp(0.0, 1.0)
}

fn braking(world: &World, spec: &Spec, accelerator: f64, brake: f64, speed: f64) -> f64 {
    let fade = ((speed - FADE.0) / (FADE.1 - FADE.0)).clamp(0.0, 1.0);
    let released = (1.0 - accelerator / RELEASED).max(0.0);
    let force = released * spec.coast * spec.mass_kg + brake * spec.brake_newton;
    let allowed = spec.regeneration_nm(world.vcu.allowed_regeneration_watts, spec.omega(speed));
    (fade * spec.nm(force)).min(allowed)
}
