//! Trips, energy, consumption, range and charging: exact, signed, and honest about what is missing.

use crate::support::probe::*;
use crate::support::*;
use cluster::view::{Journey, Plug, Range};
use cluster::{Cluster, Inputs, Trip};
use proptest::prelude::*;
use protocol_core::model::{Shown, Value as V};
use protocol_core::vehicle::Node;
use protocol_core::{CanFrame, Millis};

/// Drives at a steady speed in km/h with a steady voltage in 0.1 V and current in 0.1 A.
fn steady(drive: &mut Drive, kmh: i32, decivolts: i32, deciamps: i32) {
    drive.keep(Node::Vcu, V::VehicleSpeed, kmh * 256);
    drive.keep(Node::Bms, V::BatteryVoltage, decivolts);
    drive.keep(Node::Bms, V::BatteryCurrent, deciamps);
}

#[test]
fn ten_minutes_at_60_km_h_and_60_kw_are_ten_kilometres_and_ten_kilowatt_hours() {
    let mut drive = healthy();
    steady(&mut drive, 60, 6_000, 1_000);
    drive.run(600_000);
    let view = drive.view();
    let trip = Journey {
        hectometres: 100,
        average_whkm: Some(1_000),
        used_watthours: 10_000,
        regained_watthours: 0,
    };
    assert_eq!(view.journeys, [trip, trip]);
    assert_eq!(view.consumption_whkm, Shown::Value(1_000));
    assert_eq!(view.power_hectowatts, Shown::Value(600));
}

#[test]
fn regained_energy_has_a_sign_and_is_taken_off_the_average() {
    let mut drive = healthy();
    steady(&mut drive, 60, 6_000, 1_000);
    drive.run(300_000);
    steady(&mut drive, 60, 6_000, -500);
    drive.run(300_000);
    let view = drive.view();
    assert_eq!(view.consumption_whkm, Shown::Value(-500));
    assert_eq!(view.power_hectowatts, Shown::Value(-300));
    let trip = view.journeys[0];
    assert_eq!((trip.used_watthours, trip.regained_watthours, trip.average_whkm), (5_000, 2_500, Some(250)));
}

#[test]
fn energy_from_a_plug_is_not_regained_energy() {
    for (value, number) in [(V::ChargePlug, 1), (V::ChargeState, 1)] {
        let mut drive = healthy();
        drive.keep(Node::Vcu, value, number);
        drive.run(CYCLE);
        steady(&mut drive, 0, 6_000, -500);
        drive.run(60_000);
        assert_eq!(drive.view().journeys[0].regained_watthours, 0, "{}", value.path());
    }
}

#[test]
fn distance_without_a_known_power_does_not_dilute_the_average() {
    let mut drive = healthy();
    steady(&mut drive, 60, 6_000, 1_000);
    drive.run(60_000);
    drive.keep_invalid(Node::Bms, V::BatteryCurrent);
    drive.run(60_000);
    let trip = drive.view().journeys[0];
    assert_eq!((trip.hectometres, trip.average_whkm), (20, Some(1_000)));
    assert_eq!(drive.view().consumption_whkm, Shown::Invalid);
}

#[test]
fn an_average_over_less_than_a_hundred_metres_is_not_shown() {
    let mut drive = healthy();
    steady(&mut drive, 36, 6_000, 100);
    drive.run(9_900);
    assert_eq!(drive.view().journeys[0].average_whkm, None);
    drive.run(200);
    assert!(drive.view().journeys[0].average_whkm.is_some());
}

#[test]
fn the_present_consumption_says_nothing_below_five_kilometres_per_hour() {
    let mut drive = healthy();
    for (raw, is_shown) in [(1_279, false), (1_280, true)] {
        steady(&mut drive, 0, 6_000, 100);
        drive.keep(Node::Vcu, V::VehicleSpeed, raw);
        drive.run(CYCLE);
        assert_eq!(drive.view().consumption_whkm != Shown::Never, is_shown, "{raw}/256 km/h");
    }
    drive.keep_invalid(Node::Vcu, V::VehicleSpeed);
    drive.run(CYCLE);
    assert_eq!(drive.view().consumption_whkm, Shown::Invalid);
    drive.hush(Node::Vcu);
    drive.run(TIMEOUT);
    assert_eq!(drive.view().consumption_whkm, Shown::Stale);
}

#[test]
fn each_trip_is_reset_alone_and_the_odometer_never() {
    let mut drive = healthy();
    steady(&mut drive, 60, 6_000, 1_000);
    drive.run(60_000);
    drive.cluster.reset_trip(Trip::A);
    drive.run(60_000);
    let view = drive.view();
    assert_eq!(view.journeys.map(|journey| journey.hectometres), [10, 20]);
    assert_eq!(view.odometer_hectometres, 20);
    drive.cluster.reset_trip(Trip::B);
    assert_eq!(drive.view().journeys.map(|journey| journey.hectometres), [10, 0]);
}

#[test]
fn the_odometer_follows_the_vehicle_s_own_distance_and_never_runs_backwards() {
    let mut drive = healthy();
    steady(&mut drive, 90, 6_000, 100);
    drive.keep(Node::Vcu, V::VehicleOdometer, 8_000);
    drive.run(60_000);
    assert_eq!(drive.cluster.odometer_km8(), 8_000, "the vehicle counts, not the speed");
    drive.keep(Node::Vcu, V::VehicleOdometer, 8_004);
    drive.run(CYCLE);
    assert_eq!(drive.cluster.odometer_km8(), 8_004);
    for behind in [100, -1, 0] {
        drive.keep(Node::Vcu, V::VehicleOdometer, behind);
        drive.run(CYCLE);
        assert_eq!(drive.cluster.odometer_km8(), 8_004, "never backwards");
    }
    // 1.5 km a minute from the moment on at which the vehicle's distance is no longer known.
    drive.keep_invalid(Node::Vcu, V::VehicleOdometer);
    drive.run(60_000);
    assert_eq!(drive.cluster.odometer_km8(), 8_016);
    assert_eq!(drive.view().journeys[0].hectometres, 30, "the trips count the speed throughout");
}

#[test]
fn the_range_is_shown_as_sent() {
    let mut drive = healthy();
    assert_eq!(drive.view().range, Shown::Never);
    drive.keep(Node::Vcu, V::VehicleRange, 8 * 123 + 7);
    drive.run(CYCLE);
    assert_eq!(drive.view().range, Shown::Value(Range { km: 123, is_estimated: false }));
    drive.hush(Node::Vcu);
    drive.run(TIMEOUT);
    assert_eq!(drive.view().range, Shown::Stale);
    drive.keep_invalid(Node::Vcu, V::VehicleRange);
    drive.speak(Node::Vcu);
    drive.run(CYCLE);
    assert_eq!(drive.view().range, Shown::Invalid);
}

#[test]
fn without_one_from_the_vehicle_the_range_is_estimated_and_says_so() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatterySoc, 600);
    drive.keep(Node::Bms, V::BatterySocLower, 100);
    drive.keep(Node::Bms, V::BatteryCapacity, 200);
    drive.keep(Node::Bms, V::BatteryRatedVoltage, 5_000);
    steady(&mut drive, 60, 6_000, 1_000);
    drive.run(59_000);
    assert_eq!(drive.view().range, Shown::Never, "less than a kilometre is no base");
    drive.run(2_000);
    // 200 Ah x 500 V = 100 kWh, half of it above the lower limit, 1 kWh/km.
    assert_eq!(drive.view().range, Shown::Value(Range { km: 50, is_estimated: true }));
    drive.keep(Node::Bms, V::BatterySoc, 90);
    drive.run(CYCLE);
    assert_eq!(
        drive.view().range,
        Shown::Value(Range { km: 0, is_estimated: true }),
        "below the lower limit"
    );
    drive.keep_invalid(Node::Bms, V::BatterySoc);
    drive.run(CYCLE);
    assert_eq!(drive.view().range, Shown::Invalid);
    drive.hush(Node::Bms);
    drive.run(TIMEOUT);
    assert_eq!(drive.view().range, Shown::Stale, "a stale charge estimates nothing");
}

#[test]
fn a_drive_that_has_used_nothing_or_only_regained_estimates_no_range() {
    for deciamps in [-100, 0] {
        let mut drive = healthy();
        drive.keep(Node::Bms, V::BatterySoc, 600);
        drive.keep(Node::Bms, V::BatteryCapacity, 200);
        steady(&mut drive, 60, 6_000, deciamps);
        drive.run(120_000);
        assert_eq!(drive.view().range, Shown::Never);
    }
}

#[test]
fn the_charging_view_has_power_into_the_battery_and_the_time_that_is_left() {
    let mut drive = healthy();
    assert_eq!(drive.view().charging, None);
    drive.keep(Node::Vcu, V::ChargePlug, 1);
    drive.run(CYCLE);
    assert_eq!(drive.view().charging.map(|charging| charging.plug), Some(Plug::Inserted));
    drive.keep(Node::Bms, V::ChargeState, 1);
    drive.keep(Node::Bms, V::BatterySoc, 500);
    drive.keep(Node::Bms, V::BatteryCapacity, 200);
    steady(&mut drive, 0, 5_000, -1_000);
    drive.run(CYCLE);
    let charging = drive.view().charging.expect("plugged in");
    assert_eq!(charging.plug, Plug::Charging);
    assert_eq!((charging.deciamps, charging.hectowatts), (Shown::Value(1_000), Shown::Value(500)));
    assert_eq!(charging.minutes_left, Some(60), "100 Ah to go at 100 A");
    for (state, plug) in [(2, Plug::Complete), (3, Plug::Fault), (0, Plug::Inserted)] {
        drive.keep(Node::Bms, V::ChargeState, state);
        drive.run(CYCLE);
        let charging = drive.view().charging.expect("plugged in");
        assert_eq!((charging.plug, charging.minutes_left), (plug, None));
    }
    drive.hush(Node::Vcu);
    drive.hush(Node::Bms);
    drive.run(TIMEOUT);
    assert_eq!(drive.view().charging, None, "nothing is known of a plug");
}

#[test]
fn charging_without_a_current_into_the_battery_has_no_time() {
    for (deciamps, charge) in [(0, 500), (100, 500), (-100, 1_001)] {
        let mut drive = healthy();
        drive.keep(Node::Bms, V::ChargeState, 1);
        drive.keep(Node::Bms, V::BatterySoc, charge);
        drive.keep(Node::Bms, V::BatteryCapacity, 200);
        steady(&mut drive, 0, 5_000, deciamps);
        drive.run(CYCLE);
        assert_eq!(drive.view().charging.map(|charging| charging.minutes_left), Some(None));
    }
}

#[test]
fn the_charger_s_own_figures_stand_in_for_the_battery_s() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::ChargeState, 1);
    drive.keep(Node::Charger, V::ChargerVoltage, 4_000);
    drive.keep(Node::Charger, V::ChargerCurrent, 250);
    drive.run(CYCLE);
    let charging = drive.view().charging.expect("charging");
    assert_eq!((charging.decivolts, charging.hectowatts), (Shown::Value(4_000), Shown::Value(100)));
}

#[test]
fn the_battery_s_figures_come_first_and_nothing_stands_in_for_nothing() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::ChargeState, 1);
    steady(&mut drive, 0, 5_000, -1_000);
    drive.keep(Node::Charger, V::ChargerVoltage, 4_000);
    drive.keep(Node::Charger, V::ChargerCurrent, 250);
    drive.run(CYCLE);
    let charging = drive.view().charging.expect("charging");
    assert_eq!((charging.decivolts, charging.deciamps), (Shown::Value(5_000), Shown::Value(1_000)));
    for value in [V::BatteryVoltage, V::BatteryCurrent] {
        drive.keep_invalid(Node::Bms, value);
    }
    drive.hush(Node::Charger);
    drive.run(TIMEOUT);
    let charging = drive.view().charging.expect("charging");
    assert_eq!(
        (charging.decivolts, charging.deciamps),
        (Shown::Invalid, Shown::Invalid),
        "as the battery says"
    );
}

fn set(cluster: &mut Cluster, value: V, number: i32, now: Millis) {
    let [a, b, c, d] = number.to_le_bytes();
    cluster.receive(&CanFrame::full(PROBE.rx[0].id, [value as u8, 0, 0, 0, a, b, c, d]), now);
}

proptest! {
    /// Whatever the ticks: the same drive gives the same trip.
    #[test]
    fn any_division_of_a_time_into_ticks_gives_the_same_trip(
        legs in prop::collection::vec((0i32..30_000, -2_000i32..5_000, 1u64..400), 1..20),
        splits in prop::collection::vec(1u64..200, 1..50),
    ) {
        let mut journeys = Vec::new();
        for splits in [&[1][..], &splits[..]] {
            let mut cluster = Cluster::new(&PROBE);
            let (mut now, mut splits) = (0, splits.iter().cycle());
            cluster.tick(&Inputs::default(), Millis(0));
            for &(speed, deciamps, ms) in &legs {
                let end = now + ms;
                set(&mut cluster, V::VehicleSpeed, speed, Millis(now));
                set(&mut cluster, V::BatteryVoltage, 6_000, Millis(now));
                set(&mut cluster, V::BatteryCurrent, deciamps, Millis(now));
                while now < end {
                    now = (now + splits.next().copied().unwrap_or(1)).min(end);
                    cluster.tick(&Inputs::default(), Millis(now));
                }
            }
            let view = cluster.view(Millis(now));
            journeys.push((view.journeys, view.odometer_hectometres, cluster.odometer_km8()));
        }
        prop_assert_eq!(&journeys[0], &journeys[1]);
    }
}
