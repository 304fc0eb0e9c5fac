//! Freshness: what arrived, what stopped arriving, what never came.

use crate::support::toy::*;
use crate::support::*;
use cluster::{Cluster, Received, Telltale};
use protocol_core::model::{Shown, Value};
use protocol_core::{CanFrame, CanId, Millis};

fn speed(drive: &Drive, at: Millis) -> Shown<i32> {
    drive.cluster.shown(Value::VehicleSpeed, at)
}

#[test]
fn a_value_nobody_sent_is_never_seen() {
    let cluster = Cluster::new(&TOY);
    for &value in Value::ALL {
        assert_eq!(cluster.shown(value, Millis(1_000_000)), Shown::Never, "{}", value.path());
    }
}

#[test]
fn bus_108_a_value_is_stale_exactly_at_its_time_out() {
    let mut drive = Drive::of(&TOY);
    drive.now = Millis(70);
    drive.send(DRIVE, [1, 0, 10, 0, 0, 0, 0, 1]);
    assert_eq!(speed(&drive, Millis(70)), Shown::Value(2560));
    assert_eq!(speed(&drive, Millis(70 + DRIVE_TIMEOUT - 1)), Shown::Value(2560));
    assert_eq!(speed(&drive, Millis(70 + DRIVE_TIMEOUT)), Shown::Stale);
    assert_eq!(speed(&drive, Millis(u64::MAX)), Shown::Stale);
}

#[test]
fn bus_108_stale_values_are_shown_as_missing_not_as_zero_or_as_the_last_value() {
    let mut drive = healthy();
    drive.gear_and_speed(1, 50);
    drive.run(200);
    let before = drive.view();
    assert_eq!((before.speed_kmh, before.gear.is_some()), (Shown::Value(50), true));
    for id in [DRIVE, PACK, MOTOR] {
        drive.stop(id);
    }
    drive.run(500);
    let view = drive.view();
    assert_eq!(view.speed_kmh, Shown::Stale);
    assert_eq!(view.gear, None, "BUS-R015");
    assert_eq!(view.soc_percent, Shown::Stale);
    assert_eq!(view.pack_decivolts, Shown::Stale);
    assert_eq!(view.pack_deciamps, Shown::Stale);
    assert_eq!(view.power_hectowatts, Shown::Stale);
    assert_eq!(view.motor_rpm, Shown::Stale);
    assert_eq!(view.motor_celsius, Shown::Stale);
    assert_eq!(view.inverter_celsius, Shown::Stale);
    assert_eq!(view.cell_millivolts, (Shown::Never, Shown::Never));
    assert!(!view.telltales.is_lit(Telltale::Ready), "nothing healthy is lit from stale data");
}

#[test]
fn a_value_comes_back_with_the_first_living_frame() {
    let mut drive = healthy();
    drive.stop(DRIVE);
    drive.run(1_000);
    assert_eq!(drive.view().speed_kmh, Shown::Stale);
    drive.gear_and_speed(1, 30);
    drive.run(CYCLE);
    assert_eq!(drive.view().speed_kmh, Shown::Value(30));
}

#[test]
fn a_value_that_its_sender_marks_is_invalid_not_zero() {
    let mut drive = healthy();
    let mut data = PACK_WELL;
    data[4] = 0xFF;
    drive.repeat(PACK, data);
    drive.run(CYCLE);
    assert_eq!(drive.view().soc_percent, Shown::Invalid);
    assert_eq!(drive.view().pack_decivolts, Shown::Value(3_500), "its neighbours are not touched");
}

#[test]
fn bus_108_a_life_counter_that_stands_still_is_silence() {
    let mut drive = healthy();
    drive.stop(DRIVE);
    let start = drive.now;
    let frame = [1, 0, 10, 1, 0, 0, 0, 200];
    for step in 0..DRIVE_TIMEOUT {
        drive.now = start.after(step);
        drive.send(DRIVE, frame);
        assert_eq!(speed(&drive, drive.now), Shown::Value(2560), "{step} ms after the counter moved");
    }
    drive.now = start.after(DRIVE_TIMEOUT);
    drive.send(DRIVE, frame);
    assert_eq!(speed(&drive, drive.now), Shown::Stale);
    drive.send(DRIVE, [1, 0, 11, 1, 0, 0, 0, 201]);
    assert_eq!(speed(&drive, drive.now), Shown::Value(2816), "the counter moves again");
}

#[test]
fn bus_r061_only_the_bits_of_the_counter_count_as_life() {
    let mut drive = Drive::of(&TOY);
    for step in 0..=500 {
        drive.now = Millis(step);
        // The low nibble moves, the counter in the high one does not.
        drive.send(PACK, [0xAC, 0x0D, 0, 0, 0, 0, 0, 0x30 | step as u8 & 0x0F]);
    }
    assert_eq!(drive.cluster.shown(Value::BatteryVoltage, Millis(499)), Shown::Value(3_500));
    assert_eq!(drive.cluster.shown(Value::BatteryVoltage, Millis(500)), Shown::Stale);
}

#[test]
fn bus_11_a_frame_that_differs_in_one_identifier_bit_changes_nothing() {
    let known: Vec<u32> = TOY.rx.iter().map(|message| message.id.packed()).collect();
    for &id in &known {
        for bit in (0..29).chain([31]) {
            let other = CanId::from_packed(id ^ 1 << bit);
            if known.contains(&other.packed()) {
                continue;
            }
            let mut cluster = Cluster::new(&TOY);
            let frame = CanFrame::full(other, [0x11; 8]);
            assert_eq!(cluster.receive(&frame, Millis(5)), Received::Unknown);
            assert!(
                Value::ALL.iter().all(|&value| cluster.shown(value, Millis(5)) == Shown::Never),
                "{other}"
            );
            assert_eq!(cluster.counters().unknown, 1);
        }
    }
}

#[test]
fn a_frame_with_too_few_bytes_is_counted_and_changes_nothing() {
    let mut drive = healthy();
    let before = drive.cluster.view(drive.now);
    for len in 0..8 {
        let frame = CanFrame::from_slice(DRIVE, &[0xAA; 8][..len]).expect("at most 8 bytes");
        assert_eq!(drive.cluster.receive(&frame, drive.now), Received::TooShort);
    }
    assert_eq!(drive.cluster.view(drive.now), before);
    assert_eq!(drive.cluster.counters().too_short, 8);
}

#[test]
fn what_is_stored_is_counted() {
    let mut drive = Drive::of(&TOY);
    drive.send(FAULTS, [0; 8]);
    drive.send(DRIVE, [0; 8]);
    drive.send(DRIVE, [0; 8]);
    let counters = drive.cluster.counters();
    assert_eq!((counters.stored, counters.unknown, counters.too_short), (3, 0, 0));
}

#[test]
fn a_node_that_stops_is_named_and_lights_the_lamp() {
    let mut drive = healthy();
    drive.run(4_000);
    assert_eq!(drive.line(), None);
    drive.stop(PACK);
    drive.run(500 - CYCLE);
    assert_eq!(drive.line(), None, "{} ms of silence", 500 - CYCLE);
    drive.run(CYCLE);
    assert_eq!(drive.line(), Some(("No communication: BMS", None)));
    assert!(drive.view().telltales.is_lit(Telltale::NoCommunication));
    drive.repeat(PACK, PACK_WELL);
    drive.run(CYCLE);
    assert_eq!(drive.line(), None);
    assert!(!drive.view().telltales.is_lit(Telltale::NoCommunication));
}

#[test]
fn nodes_have_time_to_boot_before_they_are_missed() {
    let mut drive = Drive::of(&TOY);
    drive.run(5_000);
    assert_eq!(drive.line(), None);
    drive.run(TICK);
    assert_eq!(drive.lines(2), [("No communication: VCU", None), ("No communication: BMS", None)]);
}

#[test]
fn bus_06_a_message_that_some_vehicles_lack_is_not_missed() {
    let mut drive = healthy();
    drive.stop(MOTOR);
    drive.run(10_000);
    assert_eq!(drive.line(), None);
    assert_eq!(drive.view().motor_rpm, Shown::Stale);
}

#[test]
fn nothing_happens_where_32_bit_milliseconds_would_wrap() {
    for wrap in [1u64 << 31, 1 << 32, 1 << 33] {
        let mut drive = healthy_at(Millis(wrap - 5_000 - wrap % CYCLE));
        drive.gear_and_speed(1, 36);
        drive.run(1_000);
        let before = drive.cluster.odometer_km8();
        for _ in 0..10_000 / TICK {
            drive.run(TICK);
            assert_eq!(drive.view().speed_kmh, Shown::Value(36), "at {:?}", drive.now);
            assert_eq!(drive.line(), None, "at {:?}", drive.now);
        }
        // 36 km/h for 10 s is 100 m, for 12.5 s one eighth of a kilometre.
        assert!((before..=before + 1).contains(&drive.cluster.odometer_km8()));
        drive.stop(DRIVE);
        drive.run(DRIVE_TIMEOUT);
        assert_eq!(drive.view().speed_kmh, Shown::Stale);
    }
}
