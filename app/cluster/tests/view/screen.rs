//! The view: values as the screens want them.

use crate::support::toy::*;
use crate::support::*;
use protocol_core::Millis;
use protocol_core::model::{Gear, Shown};

#[test]
fn bus_r015_no_gear_information_no_gear_icon() {
    let drive = Drive::of(&TOY);
    assert_eq!(drive.cluster.view(Millis(0)).gear, None);
    let mut drive = healthy();
    for gear in [0, 5, 10, 17, 255] {
        drive.gear_and_speed(gear, 0);
        drive.run(CYCLE);
        assert_eq!(drive.view().gear, None, "gear {gear} is not defined (BUS-36)");
    }
}

#[test]
fn bus_36_every_defined_gear_is_shown() {
    let gears = [(1, Gear::D), (2, Gear::R), (3, Gear::N), (4, Gear::P), (11, Gear::D1), (16, Gear::D6)];
    let mut drive = healthy();
    for (number, gear) in gears {
        drive.gear_and_speed(number, 0);
        drive.run(CYCLE);
        assert_eq!(drive.view().gear, Some(gear));
    }
}

#[test]
fn speed_is_whole_kilometres_per_hour_rounded_down() {
    let mut drive = healthy();
    for (raw, kmh) in [(0u16, 0u16), (255, 0), (256, 1), (12_799, 49), (12_800, 50), (51_200, 200)] {
        let [low, high] = raw.to_le_bytes();
        drive.repeat(DRIVE, [1, low, high, 0, 0, 0, 0, 0]);
        drive.run(CYCLE);
        assert_eq!(drive.view().speed_kmh, Shown::Value(kmh));
    }
}

#[test]
fn bus_r064_the_charge_is_whole_percent_rounded_down() {
    let mut drive = healthy();
    for (raw, percent) in [(0u8, 0u8), (1, 0), (2, 0), (3, 1), (249, 99), (250, 100)] {
        let mut data = PACK_WELL;
        data[4] = raw;
        drive.repeat(PACK, data);
        drive.run(CYCLE);
        assert_eq!(drive.view().soc_percent, Shown::Value(percent), "BUS-115: {raw} x 0.4 %");
    }
}

#[test]
fn bus_r062_pack_voltage_current_and_their_product_are_shown_with_sign() {
    let mut drive = healthy();
    // 350.0 V and 25.0 A are 8.75 kW.
    let view = drive.view();
    assert_eq!(view.pack_decivolts, Shown::Value(3_500));
    assert_eq!(view.pack_deciamps, Shown::Value(250));
    assert_eq!(view.power_hectowatts, Shown::Value(87));
    let mut data = PACK_WELL;
    // -100.0 A: regeneration (BUS-R063).
    [data[2], data[3]] = 9_000u16.to_le_bytes();
    drive.repeat(PACK, data);
    drive.run(CYCLE);
    assert_eq!(drive.view().power_hectowatts, Shown::Value(-350));
}

#[test]
fn bus_r057_and_bus_r058_the_motor_is_shown() {
    let mut drive = healthy();
    drive.repeat(MOTOR, [0x10, 0x27, 0, 0, 61, 72, 0, 0]);
    drive.run(CYCLE);
    let view = drive.view();
    assert_eq!(view.motor_rpm, Shown::Value(10_000));
    assert_eq!((view.motor_celsius, view.inverter_celsius), (Shown::Value(61), Shown::Value(72)));
}

#[test]
fn before_anything_arrives_everything_is_missing() {
    let drive = Drive::of(&TOY);
    let view = drive.cluster.view(Millis(0));
    assert_eq!(view.speed_kmh, Shown::Never);
    assert_eq!(view.soc_percent, Shown::Never);
    assert_eq!(view.power_hectowatts, Shown::Never);
    assert_eq!(view.line, None);
}

#[test]
fn the_heartbeat_toggles_every_half_second() {
    let drive = Drive::of(&TOY);
    let beats: Vec<bool> = (0..2_000).map(|ms| drive.cluster.view(Millis(ms)).heartbeat).collect();
    let changes: Vec<usize> = (1..beats.len()).filter(|&ms| beats[ms] != beats[ms - 1]).collect();
    assert_eq!(changes, [500, 1_000, 1_500]);
}

#[test]
fn a_view_before_the_first_word_from_anywhere_holds_no_value() {
    use cluster::View;
    let view = cluster::Cluster::new(&TOY).view(Millis(0));
    // Before its first tick a cluster differs from nothing at all only by its bulb check.
    assert_eq!(View { telltales: cluster::Telltales::NONE, ..view }, View::default());
}
