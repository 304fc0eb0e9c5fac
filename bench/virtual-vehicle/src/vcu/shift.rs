//! The gear that is engaged: the lever's, when that is possible.
//!
//! Without a gearbox there are D, R and N, and P in the car (BUS-R014, BUS-36). D and R engage with READY and not
//! against the way the vehicle rolls; a gear that is refused leaves neutral and is said so (jiulong `shift_failed`).

use crate::spec::Spec;
use crate::world::{Gear, Key, World};

/// Speed against the gear, in km/h, at which it still engages.
pub(super) const AGAINST_KMH: f64 = 3.0;
/// Speed at which P still engages, in km/h.
const PARK_KMH: f64 = 1.0;

/// Engages what the lever asks for, or refuses it.
pub(super) fn step(world: &mut World, spec: &Spec) {
    if world.vcu.key < Key::On {
        return;
    }
    let engaged = world.vcu.gear.unwrap_or_default();
    let lever = world.driver.gear;
    world.vcu.shift_failed = false;
    if lever == engaged {
        world.vcu.gear = Some(engaged);
        return;
    }
    let forwards_kmh = world.motion.metres_per_s * 3.6;
    let (possible, refused) = match lever {
        Gear::N => (true, false),
        Gear::D => (world.vcu.ready && forwards_kmh >= -AGAINST_KMH, forwards_kmh < -AGAINST_KMH),
        Gear::R => (world.vcu.ready && forwards_kmh <= AGAINST_KMH, forwards_kmh > AGAINST_KMH),
        Gear::P => (world.motion.kmh() < PARK_KMH, world.motion.kmh() >= PARK_KMH),
        // A gearbox: no lever of these vehicles has it.
        Gear::D1 | Gear::D2 | Gear::D3 | Gear::D4 | Gear::D5 | Gear::D6 => (false, true),
    };
    let exists = spec.gears.contains(&lever);
    world.vcu.gear = Some(if possible && exists { lever } else { Gear::N });
    world.vcu.shift_failed = refused || !exists;
}
