//! What a person may do to the vehicle controller.
//!
//! Fault codes by the level of the vehicle's own document: level 3 is the worst in the bus, level 1 in the jiulong
//! (BUS-34, JL-14); each level takes a second code so that one sees them take turns.

use crate::control::{Control, Group, Setting, Takes, flag, is_on};
use crate::world::World;

const CODE: Takes = Takes::Number { min: 0.0, max: 65_535.0, step: 1.0, unit: "" };

fn get<const ROW: usize, const PLACE: usize>(world: &World) -> Setting {
    Some(f64::from(world.vcu.set_codes[ROW][PLACE]))
}

fn set<const ROW: usize, const PLACE: usize>(world: &mut World, setting: Setting) {
    world.vcu.set_codes[ROW][PLACE] = setting.unwrap_or_default() as u16;
}

/// A fault code of severity `ROW` (0 = WARN to 2 = STOP), the first or the second of it.
const fn code<const ROW: usize, const PLACE: usize>(path: &'static str, words: [&'static str; 2]) -> Control {
    Control::new(path, words, Group::Parts, CODE, get::<ROW, PLACE>, set::<ROW, PLACE>)
}

const LEVEL_1: [&str; 2] = ["整车一级故障代码", "Vehicle fault, level 1"];
const LEVEL_1B: [&str; 2] = ["整车一级故障代码 2", "Vehicle fault, level 1, second"];
const LEVEL_2: [&str; 2] = ["整车二级故障代码", "Vehicle fault, level 2"];
const LEVEL_2B: [&str; 2] = ["整车二级故障代码 2", "Vehicle fault, level 2, second"];
const LEVEL_3: [&str; 2] = ["整车三级故障代码", "Vehicle fault, level 3"];
const LEVEL_3B: [&str; 2] = ["整车三级故障代码 2", "Vehicle fault, level 3, second"];

/// Codes where level 3 is the worst.
pub(crate) const RISING_LEVELS: &[Control] = &[
    code::<0, 0>("vcu.fault_level_1", LEVEL_1),
    code::<0, 1>("vcu.fault_level_1b", LEVEL_1B),
    code::<2, 0>("vcu.fault_level_3", LEVEL_3),
    code::<2, 1>("vcu.fault_level_3b", LEVEL_3B),
];

/// Codes where level 1 is the worst.
pub(crate) const FALLING_LEVELS: &[Control] = &[
    code::<2, 0>("vcu.fault_level_1", LEVEL_1),
    code::<2, 1>("vcu.fault_level_1b", LEVEL_1B),
    code::<0, 0>("vcu.fault_level_3", LEVEL_3),
    code::<0, 1>("vcu.fault_level_3b", LEVEL_3B),
];

/// Codes of level 2, and what the vehicle controller is told to do wrong.
pub(crate) const CONTROLS: &[Control] = &[
    code::<1, 0>("vcu.fault_level_2", LEVEL_2),
    code::<1, 1>("vcu.fault_level_2b", LEVEL_2B),
    Control::new(
        "vcu.ignores_hv_off",
        ["不响应断高压请求", "Ignores requests to open high voltage"],
        Group::Parts,
        Takes::Flag,
        |world| flag(world.vcu.ignores_hv_off),
        |world, setting| world.vcu.ignores_hv_off = is_on(setting),
    ),
    Control::new(
        "vcu.dcdc_input_limit",
        ["DC/DC 输入下限", "DC/DC: lowest input, 0 = its own"],
        Group::Parts,
        Takes::Number { min: 0.0, max: 1_000.0, step: 1.0, unit: "V" },
        |world| Some(world.vcu.dcdc_volts.0),
        |world, setting| world.vcu.dcdc_volts.0 = setting.unwrap_or_default(),
    )
    .optional(),
    Control::new(
        "vcu.dcdc_start_volts",
        ["DC/DC 起动电压", "DC/DC: starts below, 0 = its own"],
        Group::Parts,
        Takes::Number { min: 0.0, max: 40.0, step: 1.0, unit: "V" },
        |world| Some(world.vcu.dcdc_volts.1),
        |world, setting| world.vcu.dcdc_volts.1 = setting.unwrap_or_default(),
    )
    .optional(),
];
