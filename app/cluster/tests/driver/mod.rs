//! Inputs and decisions of the cluster itself.

use crate::support::toy::*;
use crate::support::*;
use cluster::{Buttons, Contacts, FaultId, Inputs, Key};
use protocol_core::Millis;
use protocol_core::model::{Gear, Shown, Value};

fn shown(drive: &Drive, value: Value) -> Shown<i32> {
    drive.cluster.shown(value, Millis(u64::MAX / 2))
}

#[test]
fn own_wires_are_values_that_do_not_go_stale() {
    let mut drive = Drive::of(&TOY);
    drive.inputs = Inputs {
        key: Some(Key::Start),
        contacts: Contacts::closed([Value::BodyHorn]),
        supply_decivolts: Some(274),
        air_rear_centimpa: Some(81),
        ..Inputs::default()
    };
    drive.run(TICK);
    assert_eq!(shown(&drive, Value::BodyKey), Shown::Value(3));
    assert_eq!(shown(&drive, Value::BodyHorn), Shown::Value(1));
    assert_eq!(shown(&drive, Value::BodySmoke), Shown::Value(0));
    assert_eq!(shown(&drive, Value::SupplyVoltage), Shown::Value(274));
    assert_eq!(shown(&drive, Value::AirRear), Shown::Value(81));
    assert_eq!(shown(&drive, Value::AirFront), Shown::Invalid, "no sensor is not zero pressure");
}

#[test]
fn every_contact_is_filed_under_its_own_value() {
    for value in Contacts::ALL {
        let mut drive = Drive::of(&TOY);
        drive.inputs.contacts.set(*value, true);
        drive.run(TICK);
        let on: Vec<Value> =
            Contacts::ALL.iter().copied().filter(|&value| shown(&drive, value) == Shown::Value(1)).collect();
        assert_eq!(on, [*value]);
    }
}

#[test]
fn bus_r129_driver_left_needs_an_empty_seat_and_a_driving_gear() {
    // Gears of the model: D, R, N, P, forward gears 1 to 6 (BUS-93), none, undefined.
    let gears = [(1, 1), (2, 1), (3, 0), (4, 0), (11, 1), (16, 1), (0, 0), (5, 0), (17, 0)];
    for (gear, left) in gears {
        for seat_empty in [false, true] {
            let mut drive = healthy();
            drive.inputs.contacts.set(Value::BodySeatEmpty, seat_empty);
            drive.gear_and_speed(gear, 0);
            drive.run(CYCLE);
            let expected = if seat_empty { left } else { 0 };
            assert_eq!(shown(&drive, Value::ClusterDriverLeft), Shown::Value(expected), "gear {gear}");
        }
    }
}

#[test]
fn bus_r129_a_driver_who_has_left_is_gone_until_a_known_gear_or_the_seat_ends_it() {
    let left = |drive: &Drive| shown(drive, Value::ClusterDriverLeft);
    let mut drive = healthy();
    drive.inputs.contacts.set(Value::BodySeatEmpty, true);
    drive.gear_and_speed(1, 0);
    drive.run(CYCLE);
    assert_eq!(drive.view().line.map(|line| line.named.fault), Some(FaultId::DriverLeft));
    assert!(drive.sound().is_some(), "the driver is told");
    drive.stop(DRIVE);
    drive.run(DRIVE_TIMEOUT);
    assert_eq!(left(&drive), Shown::Value(1), "no gear ends nothing");
    let mut seated = drive.clone();
    seated.inputs.contacts.set(Value::BodySeatEmpty, false);
    seated.run(CYCLE);
    assert_eq!(left(&seated), Shown::Value(0), "somebody sits there");
    drive.gear_and_speed(3, 0);
    drive.run(CYCLE);
    assert_eq!(left(&drive), Shown::Value(0), "neutral, known");
    drive.stop(DRIVE);
    drive.run(DRIVE_TIMEOUT);
    assert_eq!(left(&drive), Shown::Value(0), "nor does no gear begin it");
}

#[test]
fn jl_r031_remote_upgrade_is_allowed_only_while_the_vehicle_is_known_to_be_parked() {
    let forbidden = |gear: u8, kmh: u16, ready: u8| {
        let mut drive = healthy();
        let [low, high] = (kmh * 256).to_le_bytes();
        drive.repeat(DRIVE, [gear, low, high, ready, 0, 0, 0, 0]);
        drive.run(CYCLE);
        shown(&drive, Value::ClusterUpgradeForbidden)
    };
    // Gears in the model's numbers; 0 and 20 are none.
    let parked = [Gear::N, Gear::P];
    for gear in 0..=20 {
        let is_parked = Gear::from_number(gear.into()).is_some_and(|gear| parked.contains(&gear));
        for kmh in [0, 1, 80] {
            for ready in [0, 1] {
                let expected = !(is_parked && kmh == 0 && ready == 0);
                let shown = forbidden(gear, kmh, ready);
                assert_eq!(shown, Shown::Value(expected.into()), "gear {gear}, {kmh} km/h, READY {ready}");
            }
        }
    }
}

#[test]
fn jl_r031_what_has_fallen_silent_allows_no_remote_upgrade() {
    let mut drive = healthy();
    drive.repeat(DRIVE, [3, 0, 0, 0, 0, 0, 0, 0]);
    drive.run(CYCLE);
    assert_eq!(shown(&drive, Value::ClusterUpgradeForbidden), Shown::Value(0));
    drive.stop(DRIVE);
    drive.run(DRIVE_TIMEOUT);
    assert_eq!(shown(&drive, Value::ClusterUpgradeForbidden), Shown::Value(1));
}

#[test]
fn a_push_changes_language_then_colours() {
    let mut drive = healthy();
    let mut seen = Vec::new();
    for _ in 0..5 {
        seen.push((drive.view().language, drive.view().theme));
        drive.inputs.buttons = Buttons { menu: true, ..Buttons::default() };
        drive.run(200);
        drive.inputs.buttons = Buttons::default();
        drive.run(200);
    }
    use cluster::view::{Language::*, Theme::*};
    assert_eq!(seen, [(Chinese, Night), (English, Night), (Chinese, Day), (English, Day), (Chinese, Night)]);
}

#[test]
fn a_push_silences_the_sound() {
    let mut drive = healthy();
    drive.report(3, 0);
    drive.run(CYCLE);
    drive.inputs.buttons.next = true;
    drive.run(2 * TICK);
    assert!(drive.sound().is_some(), "two samples could be a bounce");
    drive.run(TICK);
    assert_eq!(drive.sound(), None);
}

#[test]
fn single_glitches_never_add_up_to_a_push() {
    let mut drive = healthy();
    let before = drive.view().language;
    for level in "100110010010110011001".repeat(20).chars() {
        drive.inputs.buttons.menu = level == '1';
        drive.run(TICK);
        assert_eq!(drive.view().language, before);
    }
}

#[test]
fn a_held_or_bouncing_button_counts_once() {
    let mut drive = healthy();
    // Bounces on the way down, holds, bounces on the way up.
    let wire = "0010110111111111101111111111111111010010000000000000";
    let mut changes = 0;
    for level in wire.chars() {
        let before = drive.view().language;
        drive.inputs.buttons.menu = level == '1';
        drive.run(TICK);
        changes += u32::from(drive.view().language != before);
    }
    assert_eq!(changes, 1);
}
