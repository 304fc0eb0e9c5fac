//! The person at the wheel, doors and road: what is set there, and a driver who holds a speed.
//!
//! `driver.target` puts someone in the seat who turns the key to start, releases the hand brake, selects D and uses
//! both pedals; a person who selects D or R himself turns the key to start as well, so that a gear is all it takes to
//! drive off. A key that a person turns off stays off. Reads nothing but the speed and the lamps that a driver sees;
//! knows no torque and no force.

use crate::STEP_S;
use crate::control::{Control, Group, Setting, Takes, Word, flag, is_on};
use crate::world::{Gear, Key, World};

/// Pedal per km/h that is missing.
const PEDAL_PER_KMH: f64 = 0.08;
/// Pedal per km/h that is missing for one second.
const PEDAL_PER_KMH_S: f64 = 0.012;
/// Brake pedal per unit of effort below zero: the brake bites harder than the motor pushes.
const BRAKE_PER_EFFORT: f64 = 0.2;
/// How far a foot moves in one second, of the whole pedal.
const FOOT_PER_S: f64 = 1.5;
/// A careful driver uses no more than this of the accelerator and of the brake.
const CAREFUL: (f64, f64) = (0.85, 0.35);
/// Brake pedal with which a standing vehicle is held.
const HOLD: f64 = 0.25;

/// Lets the driver act on what he saw in the last step.
pub(crate) fn step(world: &mut World) {
    let Some(target) = world.driver.target_kmh else { return };
    let may_start = !world.vcu.started && !world.vcu.hv_cutoff && !world.charger.plugged;
    if world.driver.key == Key::On && may_start {
        world.driver.key = Key::Start;
    }
    let ready = world.vcu.ready;
    let speed = if world.motion.metres_per_s < 0.0 { -world.motion.kmh() } else { world.motion.kmh() };
    world.driver.parking_brake &= !ready;
    if target > 0.0 && matches!(world.driver.gear, Gear::N | Gear::P) && ready {
        world.driver.gear = Gear::D;
    }
    if world.driver.gear == Gear::R && speed > -1.0 {
        world.driver.gear = Gear::D;
    }
    let (accelerator, brake) = pedals(world, target, speed, ready);
    let foot = FOOT_PER_S * STEP_S;
    let driver = &mut world.driver;
    driver.accelerator += (accelerator - driver.accelerator).clamp(-2.0 * foot, foot);
    driver.brake += (brake - driver.brake).clamp(-2.0 * foot, foot);
}

/// Accelerator and brake that the driver wants.
fn pedals(world: &mut World, target: f64, speed: f64, ready: bool) -> (f64, f64) {
    let missing = target - speed;
    if !ready || (target == 0.0 && speed < 1.0) || speed < -0.5 {
        world.driver.effort = 0.0;
        return (0.0, HOLD);
    }
    let wanted = PEDAL_PER_KMH * missing + world.driver.effort;
    // Only near the target, and only while the pedal still answers: else it would learn from the long way there.
    if missing.abs() < 8.0 && wanted.abs() < CAREFUL.0 {
        world.driver.effort =
            (world.driver.effort + PEDAL_PER_KMH_S * missing * STEP_S).clamp(-CAREFUL.0, CAREFUL.0);
    }
    (wanted.clamp(0.0, CAREFUL.0), (-wanted * BRAKE_PER_EFFORT).clamp(0.0, CAREFUL.1))
}

const PERCENT: Takes = Takes::Number { min: 0.0, max: 100.0, step: 1.0, unit: "%" };

const KEYS: &[Word] = &[key(Key::Lock), key(Key::Accessory), key(Key::On), key(Key::Start)];

const fn key(key: Key) -> Word {
    Word { word: key.word(), zh: key.zh(), en: key.en() }
}

/// What a lever has, in the order of the words of its control; P is the last, for it is not on every lever.
const LEVER: [Gear; 4] = [Gear::N, Gear::D, Gear::R, Gear::P];
const GEARS: &[Word] = &[gear(LEVER[0]), gear(LEVER[1]), gear(LEVER[2]), gear(LEVER[3])];

const fn gear(gear: Gear) -> Word {
    Word { word: gear.word(), zh: gear.zh(), en: gear.en() }
}

fn get_key(world: &World) -> Setting {
    Some(f64::from(world.driver.key.number()))
}

fn set_key(world: &mut World, setting: Setting) {
    world.driver.key = setting.and_then(|number| Key::from_number(number as i32)).unwrap_or(Key::On);
}

fn get_gear(world: &World) -> Setting {
    let place = LEVER.iter().position(|gear| *gear == world.driver.gear);
    place.map(|place| place as f64)
}

fn set_gear(world: &mut World, setting: Setting) {
    let gear = setting.and_then(|place| LEVER.get(place as usize)).copied().unwrap_or_default();
    world.driver.gear = gear;
    if matches!(gear, Gear::D | Gear::R) && world.driver.key == Key::On && !world.vcu.started {
        world.driver.key = Key::Start;
    }
}

fn set_target(world: &mut World, setting: Setting) {
    if setting.is_none() && world.driver.target_kmh.is_some() {
        world.driver.accelerator = 0.0;
        world.driver.brake = 0.0;
    }
    if setting.is_some() && world.driver.key < Key::On {
        world.driver.key = Key::On;
    }
    world.driver.target_kmh = setting;
    world.driver.effort = 0.0;
}

/// A lever without P, and one with.
pub(crate) const GEAR: &[Control] = &[lever(GEARS.split_at(3).0)];
pub(crate) const GEAR_WITH_PARK: &[Control] = &[lever(GEARS)];

const fn lever(gears: &'static [Word]) -> Control {
    Control::new("driver.gear", ["挡位", "Gear"], DRIVER, Takes::Choice(gears), get_gear, set_gear)
}

const DRIVER: Group = Group::Driver;
const BODY: Group = Group::Body;

/// Key, pedals, lever, seat, doors, lights and the road.
pub(crate) const CONTROLS: &[Control] = &[
    Control::new("driver.key", ["钥匙", "Key"], DRIVER, Takes::Choice(KEYS), get_key, set_key),
    Control::new(
        "driver.target",
        ["目标车速", "Speed to hold"],
        DRIVER,
        Takes::Number { min: 0.0, max: 150.0, step: 1.0, unit: "km/h" },
        |world| world.driver.target_kmh,
        set_target,
    )
    .free(),
    Control::new(
        "driver.accelerator",
        ["加速踏板", "Accelerator"],
        DRIVER,
        PERCENT,
        |world| Some(100.0 * world.driver.accelerator),
        |world, setting| world.driver.accelerator = setting.unwrap_or_default() / 100.0,
    ),
    Control::new(
        "driver.brake",
        ["制动踏板", "Brake"],
        DRIVER,
        PERCENT,
        |world| Some(100.0 * world.driver.brake),
        |world, setting| world.driver.brake = setting.unwrap_or_default() / 100.0,
    ),
    Control::new(
        "driver.parking_brake",
        ["手刹", "Hand brake"],
        DRIVER,
        Takes::Flag,
        |world| flag(world.driver.parking_brake),
        |world, setting| world.driver.parking_brake = is_on(setting),
    ),
    Control::new(
        "driver.seat_empty",
        ["司机离座", "Seat empty"],
        DRIVER,
        Takes::Flag,
        |world| flag(world.driver.seat_empty),
        |world, setting| world.driver.seat_empty = is_on(setting),
    ),
    Control::new(
        "driver.economy",
        ["经济模式", "Economy mode"],
        DRIVER,
        Takes::Flag,
        |world| flag(world.driver.economy),
        |world, setting| world.driver.economy = is_on(setting),
    ),
    Control::new(
        "driver.cruise",
        ["定速巡航", "Cruise control"],
        DRIVER,
        Takes::Flag,
        |world| flag(world.driver.cruise),
        |world, setting| world.driver.cruise = is_on(setting),
    )
    .optional(),
    Control::new(
        "driver.air_conditioning",
        ["空调", "Air conditioning"],
        DRIVER,
        Takes::Flag,
        |world| flag(world.driver.air_conditioning),
        |world, setting| world.driver.air_conditioning = is_on(setting),
    ),
    Control::new(
        "driver.digital_brake",
        ["开关式制动踏板", "Brake pedal is a switch"],
        DRIVER,
        Takes::Flag,
        |world| flag(world.driver.digital_brake),
        |world, setting| world.driver.digital_brake = is_on(setting),
    )
    .optional(),
    Control::new(
        "driver.accelerator_fault",
        ["加速踏板故障", "Accelerator sensor broken"],
        DRIVER,
        Takes::Flag,
        |world| flag(world.driver.accelerator_fault),
        |world, setting| world.driver.accelerator_fault = is_on(setting),
    )
    .optional(),
    Control::new(
        "body.front_door",
        ["前门", "Front door"],
        BODY,
        Takes::Flag,
        |world| flag(world.body.front_door),
        |world, setting| world.body.front_door = is_on(setting),
    ),
    Control::new(
        "body.rear_door",
        ["后门", "Rear door"],
        BODY,
        Takes::Flag,
        |world| flag(world.body.rear_door),
        |world, setting| world.body.rear_door = is_on(setting),
    ),
    Control::new(
        "body.turn_left",
        ["左转向", "Left indicator"],
        BODY,
        Takes::Flag,
        |world| flag(world.body.turn_left),
        |world, setting| world.body.turn_left = is_on(setting),
    ),
    Control::new(
        "body.turn_right",
        ["右转向", "Right indicator"],
        BODY,
        Takes::Flag,
        |world| flag(world.body.turn_right),
        |world, setting| world.body.turn_right = is_on(setting),
    ),
    Control::new(
        "body.hazard",
        ["应急灯", "Hazard warning"],
        BODY,
        Takes::Flag,
        |world| flag(world.body.hazard),
        |world, setting| world.body.hazard = is_on(setting),
    ),
    Control::new(
        "body.smoke",
        ["车厢烟雾", "Smoke in the passenger room"],
        BODY,
        Takes::Flag,
        |world| flag(world.body.smoke),
        |world, setting| world.body.smoke = is_on(setting),
    ),
    Control::new(
        "road.slope",
        ["坡度", "Slope"],
        Group::Road,
        Takes::Number { min: -20.0, max: 20.0, step: 0.5, unit: "%" },
        |world| Some(world.road.slope_percent),
        |world, setting| world.road.slope_percent = setting.unwrap_or_default(),
    ),
    Control::new(
        "road.celsius",
        ["气温", "Air temperature"],
        Group::Road,
        Takes::Number { min: -40.0, max: 50.0, step: 1.0, unit: "°C" },
        |world| Some(world.road.celsius),
        |world, setting| world.road.celsius = setting.unwrap_or_default(),
    ),
];
