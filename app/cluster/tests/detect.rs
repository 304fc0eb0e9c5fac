//! Recognition of the vehicle and of its bit rate, with the identifiers of the real tables.

use cluster::detect::{DISTINCT, Detector, Dial, Found, KEPT, Sureness};
use protocol_core::generated::{VEHICLES, bus, c5ev, jiulong};
use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, CanId, Millis};

fn frame(id: CanId) -> CanFrame {
    CanFrame::full(id, [0x5A; 8])
}

fn hear(detector: &mut Detector, vehicle: &Vehicle, ids: &[CanId], start: u64) -> Option<Found> {
    let times = (start..).step_by(10).map(Millis);
    let mut found = None;
    for (&id, now) in ids.iter().zip(times) {
        found = found.or(detector.hear(&frame(id), vehicle.bitrate, now));
    }
    found
}

#[test]
fn any_three_identifiers_of_a_vehicle_make_it_certain_and_two_do_not() {
    for &vehicle in VEHICLES {
        // An identifier that another vehicle of this bit rate has says nothing.
        let is_other = |other: &&Vehicle| other.name != vehicle.name && other.bitrate == vehicle.bitrate;
        let others: Vec<&Vehicle> = VEHICLES.iter().copied().filter(is_other).collect();
        let is_own = |id: &CanId| others.iter().all(|other| !other.has_id(*id));
        let own: Vec<CanId> = vehicle.ids.iter().copied().filter(is_own).collect();
        for ids in own.windows(DISTINCT) {
            let mut detector = Detector::new(VEHICLES);
            assert!(hear(&mut detector, vehicle, &ids[..2], 0).is_none());
            let found = hear(&mut detector, vehicle, &ids[2..], 20).expect("three are enough");
            assert_eq!((found.vehicle.name, found.sureness), (vehicle.name, Sureness::Certain));
            assert_eq!(found.at, Millis(20));
        }
    }
}

#[test]
fn one_identifier_becomes_likely_after_a_second_of_repeats_and_certain_later() {
    let id = c5ev::id::VCU_TO_CLUSTER;
    let mut detector = Detector::new(VEHICLES);
    let times: Vec<u64> = (0..40).map(|index| index * 50).collect();
    let found = times.iter().find_map(|&now| detector.hear(&frame(id), 250_000, Millis(now)));
    let found = found.expect("it keeps coming");
    assert_eq!((found.vehicle.name, found.sureness, found.at), ("c5ev", Sureness::Likely, Millis(1_000)));
    let others = c5ev::VEHICLE.ids.iter().filter(|other| **other != id).take(2);
    others.for_each(|id| assert!(detector.hear(&frame(*id), 250_000, Millis(3_000)).is_none()));
    assert_eq!(detector.found().map(|found| found.sureness), Some(Sureness::Certain));
}

#[test]
fn twenty_frames_within_a_blink_are_no_repeats() {
    let mut detector = Detector::new(VEHICLES);
    let id = c5ev::id::VCU_TO_CLUSTER;
    assert!((0..200).all(|now| detector.hear(&frame(id), 250_000, Millis(now)).is_none()));
}

#[test]
fn noise_says_nothing_and_does_not_interrupt() {
    let mut detector = Detector::new(VEHICLES);
    let ids = jiulong::VEHICLE.ids;
    let noise = [CanId::extended(0x1ABC_DEF0), CanId::standard(0x7FF), CanId::extended(0)];
    for id in noise.into_iter().cycle().take(1_000) {
        assert!(detector.hear(&frame(id), 250_000, Millis(5)).is_none());
    }
    let mixed = [ids[0], noise[0], ids[4], noise[1], noise[2], ids[9]];
    assert_eq!(hear(&mut detector, &jiulong::VEHICLE, &mixed, 10).map(|f| f.vehicle.name), Some("jiulong"));
}

#[test]
fn an_identifier_of_another_vehicle_starts_the_evidence_anew() {
    let (ours, theirs) = (bus::VEHICLE.ids, jiulong::VEHICLE.ids);
    let mut detector = Detector::new(VEHICLES);
    assert!(
        hear(&mut detector, &bus::VEHICLE, &[ours[0], ours[1], theirs[0], ours[2], ours[3]], 0).is_none()
    );
    assert!(hear(&mut detector, &bus::VEHICLE, &[ours[0]], 90).is_some());
    let mut torn = Detector::new(VEHICLES);
    for turn in 0..1_000 {
        let ids = if turn % 2 == 0 { ours } else { theirs };
        assert!(torn.hear(&frame(ids[turn % ids.len()]), 250_000, Millis(turn as u64 * 10)).is_none());
    }
}

#[test]
fn a_vehicle_is_recognised_at_its_own_bit_rate_only() {
    let mut detector = Detector::new(VEHICLES);
    for (&id, now) in bus::VEHICLE.ids.iter().zip((0..).step_by(10).map(Millis)) {
        assert!(detector.hear(&frame(id), 500_000, now).is_none());
    }
}

#[test]
fn what_was_found_stays_found_and_a_contradiction_is_told() {
    let mut detector = Detector::new(VEHICLES);
    hear(&mut detector, &bus::VEHICLE, bus::VEHICLE.ids, 0).expect("the bus");
    for now in 0..2 {
        assert!(hear(&mut detector, &bus::VEHICLE, &jiulong::VEHICLE.ids[..2], 1_000 + now * 100).is_none());
        assert!(detector.contradiction().is_none(), "two stray identifiers");
    }
    assert!(hear(&mut detector, &bus::VEHICLE, &jiulong::VEHICLE.ids[..3], 2_000).is_none());
    assert_eq!(detector.contradiction().map(|vehicle| vehicle.name), Some("jiulong"));
    assert_eq!(detector.found().map(|found| found.vehicle.name), Some("bus"));
}

#[test]
fn frames_heard_before_the_recognition_are_kept_in_order() {
    let mut detector = Detector::new(VEHICLES);
    let known = jiulong::VEHICLE.ids;
    let ids = [known[1], CanId::standard(0x7FF), known[0], known[2]];
    hear(&mut detector, &jiulong::VEHICLE, &ids, 100).expect("the vehicle");
    let kept: Vec<_> = detector.take_kept().map(|(frame, at)| (frame.id, at.0)).collect();
    assert_eq!(kept, ids.into_iter().zip([100, 110, 120, 130]).collect::<Vec<_>>());
    assert_eq!(detector.take_kept().count(), 0);
}

#[test]
fn of_too_many_frames_the_newest_are_kept() {
    let mut detector = Detector::new(VEHICLES);
    for now in 0..3 * KEPT as u64 / 2 {
        detector.hear(&frame(CanId::standard(0x7FF)), 250_000, Millis(now));
    }
    let times: Vec<u64> = detector.take_kept().map(|(_, at)| at.0).collect();
    assert_eq!(times, (KEPT as u64 / 2..3 * KEPT as u64 / 2).collect::<Vec<_>>());
}

#[test]
fn the_dial_waits_on_a_silent_bus_and_turns_on_errors() {
    let mut dial = Dial::new(VEHICLES);
    assert_eq!(dial.bitrate(), 250_000);
    assert!((0..100_000).step_by(10).all(|now| dial.listen(false, false, Millis(now)).is_none()));
    assert_eq!(dial.listen(false, true, Millis(100_000)), Some(500_000));
    assert_eq!(dial.listen(false, true, Millis(100_010)), None, "it gives each rate a little time");
    assert_eq!(dial.listen(false, true, Millis(100_020)), Some(250_000));
}

#[test]
fn a_rate_with_frames_survives_errors_and_is_left_when_only_errors_remain() {
    let mut dial = Dial::new(VEHICLES);
    for now in (0..5_000).step_by(10) {
        assert_eq!(dial.listen(now % 300 == 0, true, Millis(now)), None);
    }
    let left = (5_000..6_000).step_by(10).find(|&now| dial.listen(false, true, Millis(now)).is_some());
    assert_eq!(left, Some(5_300), "500 ms after the last frame, at 4800");
}

#[test]
fn where_all_vehicles_have_one_rate_errors_change_nothing() {
    static SAME_RATE: [&Vehicle; 2] = [&bus::VEHICLE, &jiulong::VEHICLE];
    let mut dial = Dial::new(&SAME_RATE);
    assert!((0..10_000).step_by(10).all(|now| dial.listen(false, true, Millis(now)).is_none()));
    assert_eq!(dial.bitrate(), 250_000);
}
