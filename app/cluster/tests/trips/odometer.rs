//! The distance: exact, whatever the ticks, and never backwards.

use crate::support::toy::*;
use cluster::{Cluster, Inputs};
use proptest::prelude::*;
use protocol_core::{CanFrame, Millis};

/// Drives `cluster` for `ms` at `raw` (1/256 km/h) from `start` in ticks of `tick_ms`.
fn drive_on(cluster: &mut Cluster, start: u64, ms: u64, raw: u16, tick_ms: u64) {
    let [low, high] = raw.to_le_bytes();
    let mut now = start;
    let mut life = (start / 100) as u8;
    while now < start + ms {
        now = (now + tick_ms).min(start + ms);
        life = life.wrapping_add(1);
        cluster.receive(&CanFrame::full(DRIVE, [1, low, high, 0, 0, 0, 0, life]), Millis(now));
        cluster.tick(&Inputs::default(), Millis(now));
    }
}

fn started() -> Cluster {
    let mut cluster = Cluster::new(&TOY);
    cluster.tick(&Inputs::default(), Millis(0));
    cluster
}

#[test]
fn bus_118_an_hour_at_a_steady_speed_is_exactly_that_many_kilometres() {
    for kmh in [1u16, 7, 36, 90, 113] {
        let mut cluster = started();
        drive_on(&mut cluster, 0, 3_600_000, kmh * 256, 100);
        assert_eq!(cluster.odometer_km8(), u32::from(kmh) * 8);
        assert_eq!(cluster.view(Millis(3_600_000)).odometer_hectometres, u32::from(kmh) * 10);
    }
}

#[test]
fn the_slowest_speed_is_not_lost_in_rounding() {
    let mut cluster = started();
    // 1/256 km/h for 32 hours is one eighth of a kilometre, to the millisecond.
    drive_on(&mut cluster, 0, 32 * 3_600_000 - 100, 1, 100);
    assert_eq!(cluster.odometer_km8(), 0);
    drive_on(&mut cluster, 32 * 3_600_000 - 100, 100, 1, 100);
    assert_eq!(cluster.odometer_km8(), 1);
}

#[test]
fn time_without_a_known_speed_adds_nothing() {
    let mut drive = healthy();
    drive.gear_and_speed(1, 90);
    drive.run(10_000);
    drive.stop(DRIVE);
    drive.run(1_000);
    let before = drive.view().odometer_hectometres;
    drive.run(3_600_000);
    assert_eq!(drive.view().odometer_hectometres, before);
}

#[test]
fn a_stall_adds_one_second_at_most() {
    let mut cluster = started();
    drive_on(&mut cluster, 0, 1_000, 36 * 256, 10);
    // 36 km/h is 10 m/s: an hour that nobody watched counts as 10 m.
    drive_on(&mut cluster, 1_000, 3_600_000, 36 * 256, 3_600_000);
    assert_eq!(cluster.odometer_km8(), 0);
    assert_eq!(cluster.view(Millis(3_601_000)).odometer_hectometres, 0);
}

#[test]
fn a_clock_that_steps_back_counts_no_way_twice() {
    let mut cluster = started();
    drive_on(&mut cluster, 0, 3_600_000, 8 * 256, 100);
    for _ in 0..100_000 {
        drive_on(&mut cluster, 3_599_000, 1_000, 8 * 256, 1_000);
        cluster.tick(&Inputs::default(), Millis(3_599_000));
    }
    assert_eq!(cluster.odometer_km8(), 64);
}

#[test]
fn a_kept_distance_is_taken_up_and_never_taken_away() {
    let mut cluster = started();
    cluster.restore(123_456);
    assert_eq!(cluster.odometer_km8(), 123_456);
    cluster.restore(5);
    assert_eq!(cluster.odometer_km8(), 123_456);
    drive_on(&mut cluster, 0, 3_600_000, 256, 100);
    assert_eq!(cluster.odometer_km8(), 123_464);
    cluster.restore(u32::MAX);
    assert_eq!(cluster.odometer_km8(), u32::MAX);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_division_into_ticks_gives_the_same_distance(
        legs in prop::collection::vec((1u64..200, 0u16..=51_200), 1..20),
        ticks in prop::array::uniform2(1u64..400),
    ) {
        let distances = ticks.map(|tick| {
            let mut cluster = started();
            cluster.restore(1_000);
            let mut now = 0;
            for &(tenths, raw) in &legs {
                drive_on(&mut cluster, now, tenths * 100, raw, tick);
                now += tenths * 100;
            }
            cluster.odometer_km8()
        });
        let exact: u64 = legs.iter().map(|&(tenths, raw)| tenths * 100 * u64::from(raw)).sum();
        prop_assert_eq!(u64::from(distances[0]), 1_000 + exact * 8 / (256 * 3_600_000));
        prop_assert_eq!(distances[0], distances[1]);
    }
}
