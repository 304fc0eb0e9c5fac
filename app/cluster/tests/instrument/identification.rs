//! Recognition of the vehicle, with the identifiers of the real tables.

use cluster::instrument::identification::{DISTINCT, Detector, Found, KEPT, Sureness};
use cluster::own::Search;
use protocol_core::generated::{SHIPPED_VEHICLES, VEHICLES, c5ev, citybus, example, jiulong};
use protocol_core::vehicle::{Life, RxMessage, Vehicle};
use protocol_core::{CanFrame, CanId, Millis};

/// Later than anything in a test.
const NOW: Millis = Millis(100_000);

fn frame(id: CanId) -> CanFrame {
    CanFrame::full(id, [0x5A; 8])
}

/// A frame of the vehicle with its check byte right, or with one bit of it wrong.
fn sealed(vehicle: &Vehicle, id: CanId, is_right: bool) -> CanFrame {
    let mut data = [0x5A; 8];
    let message = vehicle.index_of(id).and_then(|index| vehicle.rx.get(usize::from(index)));
    if let Some(checksum) = message.and_then(|message| message.checksum) {
        checksum.seal(&mut data);
        data[usize::from(checksum.byte)] ^= u8::from(!is_right);
    }
    CanFrame::full(id, data)
}

/// Hears each identifier twice: what comes once may be anybody's.
fn hear(detector: &mut Detector, vehicle: &Vehicle, ids: &[CanId], start: u64) -> Option<Found> {
    let times = (start..).step_by(10).map(Millis);
    let mut found = None;
    for (&id, now) in ids.iter().zip(times) {
        for _ in 0..2 {
            found = found.or(detector.hear(&sealed(vehicle, id, true), vehicle.bitrate, now));
        }
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
            assert!(detector.may_answer(NOW));
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
    assert!(!detector.may_answer(NOW), "it is shown, and only listened to");
    let others = c5ev::VEHICLE.ids.iter().filter(|other| **other != id).take(2);
    others.for_each(|id| assert!(detector.hear(&frame(*id), 250_000, Millis(3_000)).is_none()));
    assert_eq!(detector.found().map(|found| found.sureness), Some(Sureness::Certain));
    assert!(detector.may_answer(NOW));
}

#[test]
fn the_one_frame_of_a_car_s_cluster_wire_at_its_own_cycle_is_recognised() {
    let mut detector = Detector::new(SHIPPED_VEHICLES);
    let mut times = (0..).step_by(200).map(Millis);
    let found = times.find_map(|now| detector.hear(&frame(c5ev::id::VCU_TO_CLUSTER), 250_000, now));
    let found = found.map(|found| (found.vehicle.name, found.sureness, found.at));
    assert_eq!(found, Some(("c5ev", Sureness::Likely, Millis(1_000))));
    assert!(c5ev::VEHICLE.tx.is_empty(), "it has no answer to wait for");
}

/// Identifiers of 11 bits as other cars have them, and the example's own.
const STRANGERS: [&[u16]; 4] = [
    &[0x11A, 0x1D4, 0x1DA, 0x1DB, 0x1DC, 0x284, 0x2B0, 0x355, 0x390, 0x54B, 0x55B, 0x5BC, 0x59E],
    &[0x106, 0x116, 0x118, 0x102, 0x129, 0x132, 0x20C, 0x212, 0x257, 0x292, 0x2B4, 0x318, 0x332, 0x3FE],
    &[0x0AA, 0x0B5, 0x112, 0x1A1, 0x1D0, 0x2FA, 0x328, 0x349, 0x3E8, 0x432, 0x508, 0x5BC],
    &[0x120, 0x128, 0x240, 0x248, 0x350],
];

/// Bytes that look like anything, the same in every run.
fn noise(seed: &mut u64) -> [u8; 8] {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed ^ *seed >> 29).to_le_bytes()
}

#[test]
fn the_11_bit_identifiers_of_other_cars_are_never_answered_whatever_vehicles_are_known() {
    for vehicles in [SHIPPED_VEHICLES, VEHICLES] {
        for bitrate in [250_000, 500_000] {
            for ids in STRANGERS {
                let mut detector = Detector::new(vehicles);
                let mut seed = 1;
                // Ten minutes, a frame every 10 ms.
                for (index, now) in (0..60_000).zip((0..).step_by(10).map(Millis)) {
                    let id = CanId::standard(ids[index % ids.len()]);
                    detector.hear(&CanFrame::full(id, noise(&mut seed)), bitrate, now);
                    assert!(!detector.may_answer(NOW), "{ids:X?} at {bitrate}, {now:?}");
                }
                assert!(detector.found().is_none(), "{ids:X?} at {bitrate}");
            }
        }
    }
}

#[test]
fn identifiers_of_11_bits_without_check_bytes_are_shown_and_never_answered() {
    static BARE: Vehicle = Vehicle { rx: &[], ..example::VEHICLE };
    static VEHICLES: [&Vehicle; 1] = [&BARE];
    let mut detector = Detector::new(&VEHICLES);
    for (index, now) in (0..10_000).zip((0..).step_by(10).map(Millis)) {
        detector.hear(&frame(BARE.ids[index % BARE.ids.len()]), BARE.bitrate, now);
    }
    assert_eq!(detector.found().map(|found| found.sureness), Some(Sureness::Likely));
    assert!(!detector.may_answer(NOW));
}

#[test]
fn a_vehicle_with_check_bytes_needs_one_that_is_right() {
    // As many 29-bit identifiers as one likes, the one with a check byte always wrong, or not there.
    const ALL: [CanId; 4] = [
        CanId::extended(0x18FF_0001),
        CanId::extended(0x18FF_0002),
        CanId::extended(0x18FF_0003),
        CanId::extended(0x18FF_0004),
    ];
    static CHECKED: [RxMessage; 1] = [RxMessage { id: ALL[0], ..example::VEHICLE.rx[0] }];
    static VEHICLE: Vehicle = Vehicle { rx: &CHECKED, ids: &ALL, ..example::VEHICLE };
    static VEHICLES: [&Vehicle; 1] = [&VEHICLE];
    let ride = |ids: &[CanId], is_right| {
        let mut detector = Detector::new(&VEHICLES);
        for (index, now) in (0..1_000).zip((0..).step_by(10).map(Millis)) {
            detector.hear(&sealed(&VEHICLE, ids[index % ids.len()], is_right), VEHICLE.bitrate, now);
        }
        detector.found().map(|found| found.sureness)
    };
    assert_eq!(ride(&ALL[1..], true), Some(Sureness::Likely), "never heard");
    assert_eq!(ride(&ALL, false), None, "each wrong one starts anew");
    assert_eq!(ride(&ALL, true), Some(Sureness::Certain));
}

#[test]
fn a_vehicle_of_one_identifier_is_certain_only_by_its_life_counter() {
    const ONLY: CanId = CanId::extended(0x18FF_0001);
    static MESSAGE: [RxMessage; 1] = [RxMessage { id: ONLY, checksum: None, ..example::VEHICLE.rx[0] }];
    static COUNTED: [RxMessage; 1] = [RxMessage { life: Some(Life { byte: 7, mask: 0xF0 }), ..MESSAGE[0] }];
    static BARE: [&Vehicle; 1] = [&Vehicle { rx: &MESSAGE, ids: &[ONLY], ..example::VEHICLE }];
    static COUNTING: [&Vehicle; 1] = [&Vehicle { rx: &COUNTED, ids: &[ONLY], ..example::VEHICLE }];
    let ride = |vehicles: &'static [&'static Vehicle], step: u8| {
        let mut detector = Detector::new(vehicles);
        for turn in 0..1_000_u64 {
            let life = ((turn as u8).wrapping_mul(step) << 4) | 0x0A;
            let frame = CanFrame::full(ONLY, [0, 0, 0, 0, 0, 0, 0, life]);
            detector.hear(&frame, vehicles[0].bitrate, Millis(turn * 50));
        }
        detector.found().map(|found| (found.sureness, found.at))
    };
    let [likely, certain] =
        [Sureness::Likely, Sureness::Certain].map(|sureness| Some((sureness, Millis(1_000))));
    assert_eq!(ride(&BARE, 1), likely, "identifiers alone");
    assert_eq!(ride(&COUNTING, 0), likely, "a counter that stands still");
    assert_eq!(ride(&COUNTING, 2), likely, "one that jumps");
    assert_eq!(ride(&COUNTING, 1), certain);
}

#[test]
fn bus_r021_a_counter_that_counts_makes_three_identifiers_certain_sooner() {
    for vehicle in SHIPPED_VEHICLES {
        let counted = vehicle.rx.iter().find_map(|message| Some((message.id, message.life?)));
        let Some((id, life)) = counted else { continue };
        let others = vehicle.ids.iter().copied().filter(|other| *other != id).take(2);
        for (step, is_enough) in [(1, true), (0, false), (2, false), (255, false)] {
            let mut detector = Detector::new(SHIPPED_VEHICLES);
            let first = CanFrame::full(id, [0; 8]);
            let mut data = [0; 8];
            data[usize::from(life.byte)] =
                u8::wrapping_mul(step, 1 << life.mask.trailing_zeros()) & life.mask;
            let frames = [first, CanFrame::full(id, data)].into_iter().chain(others.clone().map(frame));
            let found = frames.filter_map(|frame| detector.hear(&frame, vehicle.bitrate, Millis(10))).count();
            assert_eq!(found == 1, is_enough, "{}: a step of {step}", vehicle.name);
        }
    }
}

#[test]
fn two_vehicles_that_are_both_likely_are_a_contradiction_and_neither_is_answered() {
    let mut detector = Detector::new(SHIPPED_VEHICLES);
    let mut times = (0..).step_by(50).map(Millis);
    for id in [c5ev::id::VCU_TO_CLUSTER, jiulong::VEHICLE.ids[0]] {
        for now in times.by_ref().take(30) {
            detector.hear(&frame(id), 250_000, now);
        }
    }
    assert_eq!(detector.found().map(|found| found.vehicle.name), Some("c5ev"));
    let other = detector.contradiction(Millis(3_000)).map(|vehicle| vehicle.name);
    assert_eq!((other, detector.may_answer(NOW)), (Some("jiulong"), false));
}

#[test]
fn the_search_says_what_it_has_found_and_what_contradicts_it() {
    let mut detector = Detector::new(SHIPPED_VEHICLES);
    assert_eq!(detector.state(Millis(0)), Search::Listening);
    hear(&mut detector, &citybus::VEHICLE, citybus::VEHICLE.ids, 100).expect("the bus");
    assert_eq!(detector.state(Millis(1_000)), Search::Found { at: Millis(120) });
    hear(&mut detector, &jiulong::VEHICLE, &jiulong::VEHICLE.ids[..3], 2_000);
    assert_eq!(detector.state(Millis(2_020)), Search::Contradicted);
}

#[test]
fn a_likely_vehicle_gives_way_to_a_certain_one_that_gets_its_frames() {
    let mut detector = Detector::new(SHIPPED_VEHICLES);
    for now in (0..=1_000).step_by(50).map(Millis) {
        detector.hear(&frame(c5ev::id::VCU_TO_CLUSTER), 250_000, now);
    }
    assert_eq!(detector.found().map(|found| found.vehicle.name), Some("c5ev"));
    assert!(detector.take_kept().count() > 0);
    let found = hear(&mut detector, &jiulong::VEHICLE, &jiulong::VEHICLE.ids[..3], 2_000);
    let found = found.map(|found| (found.vehicle.name, found.sureness));
    assert_eq!(found, Some(("jiulong", Sureness::Certain)));
    assert!(detector.may_answer(NOW) && detector.contradiction(Millis(2_020)).is_none());
    let kept: Vec<_> = detector.take_kept().map(|(frame, _)| frame.id).collect();
    assert_eq!(kept, jiulong::VEHICLE.ids[..3].iter().flat_map(|id| [*id; 2]).collect::<Vec<_>>());
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
    let (ours, theirs) = (citybus::VEHICLE.ids, jiulong::VEHICLE.ids);
    let mut detector = Detector::new(VEHICLES);
    assert!(
        hear(&mut detector, &citybus::VEHICLE, &[ours[0], ours[1], theirs[0], ours[2], ours[3]], 0).is_none()
    );
    assert!(hear(&mut detector, &citybus::VEHICLE, &[ours[0]], 90).is_some());
    let mut torn = Detector::new(VEHICLES);
    for turn in 0..1_000 {
        let ids = if turn % 2 == 0 { ours } else { theirs };
        assert!(torn.hear(&frame(ids[turn % ids.len()]), 250_000, Millis(turn as u64 * 10)).is_none());
    }
}

#[test]
fn a_vehicle_is_recognised_at_its_own_bit_rate_only() {
    let mut detector = Detector::new(VEHICLES);
    for (&id, now) in citybus::VEHICLE.ids.iter().zip((0..).step_by(10).map(Millis)) {
        assert!(detector.hear(&frame(id), 500_000, now).is_none());
    }
}

#[test]
fn what_was_found_stays_found_and_a_contradiction_is_told() {
    let mut detector = Detector::new(VEHICLES);
    hear(&mut detector, &citybus::VEHICLE, citybus::VEHICLE.ids, 0).expect("the bus");
    for now in 0..2 {
        assert!(
            hear(&mut detector, &citybus::VEHICLE, &jiulong::VEHICLE.ids[..2], 1_000 + now * 100).is_none()
        );
        assert!(detector.contradiction(Millis(1_900)).is_none(), "two stray identifiers");
    }
    assert!(hear(&mut detector, &citybus::VEHICLE, &jiulong::VEHICLE.ids[..3], 2_000).is_none());
    assert_eq!(detector.contradiction(Millis(2_020)).map(|vehicle| vehicle.name), Some("jiulong"));
    assert_eq!(detector.found().map(|found| found.vehicle.name), Some("citybus"));
    assert!(detector.contradiction(Millis(7_019)).is_some(), "it was heard less than 5 s ago");
    assert!(detector.contradiction(Millis(7_020)).is_none(), "it is gone");
}

#[test]
fn frames_heard_before_the_recognition_are_kept_in_order() {
    let mut detector = Detector::new(VEHICLES);
    let known = jiulong::VEHICLE.ids;
    let ids = [known[1], CanId::standard(0x7FF), known[0], known[2]];
    hear(&mut detector, &jiulong::VEHICLE, &ids, 100).expect("the vehicle");
    let kept: Vec<_> = detector.take_kept().map(|(frame, at)| (frame.id, at.0)).collect();
    let twice = ids.into_iter().zip([100, 110, 120, 130]).flat_map(|heard| [heard; 2]);
    assert_eq!(kept, twice.collect::<Vec<_>>());
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
