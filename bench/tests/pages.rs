//! The pages behind the main screen, on the image that goes to the board: one button, a whole turn through the book.

mod firmware;

use bench::log::Log;
use bench::rig::{Rig, RigOptions};
use bench::time::Nanos;
use cluster::page::Chapter;
use protocol_core::link::Record;

/// The button that turns pages.
const NEXT: usize = 0;
/// Time in which a push is filtered, the page drawn and its number told.
const SETTLED: Nanos = Nanos::from_millis(700);

fn push(rig: &mut Rig, held: Nanos) {
    rig.hold_button(NEXT, true);
    rig.run_for(held).unwrap();
    rig.hold_button(NEXT, false);
    rig.run_for(SETTLED).unwrap();
}

fn page(rig: &Rig) -> u8 {
    rig.screen().expect("the firmware says what it shows").page
}

fn driving() -> Rig {
    let city = surroundings::root().join("vehicles/citybus/captures/city.log");
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.replay(&Log::read_file(&city).unwrap(), true);
    rig.run_for(Nanos::from_secs(4)).unwrap();
    rig
}

#[test]
fn one_button_turns_through_every_page_and_back_to_the_first() {
    let mut rig = driving();
    let mut seen = vec![page(&rig)];
    for _ in 0..20 {
        push(&mut rig, Nanos::from_millis(150));
        seen.push(page(&rig));
        if seen.last() == Some(&0) {
            break;
        }
    }
    assert_eq!(seen.last(), Some(&0), "{seen:?}");
    seen.dedup();
    // Main, trips, energy, faults, history, then every chapter of which the vehicle sends something.
    assert_eq!(seen[..6], [0, 1, 2, 3, 4, 5], "{seen:?}");
    let chapters: Vec<u8> = Chapter::ALL.iter().map(|chapter| chapter.number()).collect();
    let turned = &seen[6..seen.len() - 1];
    let places = turned.iter().map(|page| chapters.iter().position(|number| number == page));
    assert!(places.clone().all(|place| place.is_some()) && places.is_sorted(), "{seen:?}");
    assert!(turned.len() >= 10, "{seen:?}");
    let panel = rig.board().panel();
    assert_eq!(panel.undrawn_pixels(), 0);
    assert_eq!(
        panel.flickered_pixels(),
        0,
        "pixels that left their colour and came back to it in one picture"
    );
    assert!(panel.violations().is_empty(), "{:?}", panel.violations().first());
    assert_eq!(rig.damaged_records(), 0);
}

#[test]
fn a_turned_page_is_another_picture_and_a_long_push_brings_the_main_one_back() {
    let mut rig = driving();
    let middle = |rig: &Rig| {
        let at = |place: u16| rig.board().panel().colour_at(place % 320, 26 + place / 320);
        (0..320 * 163).map(at).collect::<Vec<u16>>()
    };
    let main = middle(&rig);
    push(&mut rig, Nanos::from_millis(150));
    let differing = main.iter().zip(middle(&rig)).filter(|(was, is)| **was != *is).count();
    assert!(differing > 5_000, "{differing} pixels differ between the dial and a trip");
    push(&mut rig, Nanos::from_millis(150));
    push(&mut rig, Nanos::from_millis(150));
    assert_eq!(page(&rig), 3);
    push(&mut rig, Nanos::from_millis(1_200));
    assert_eq!(page(&rig), 0);
}

#[test]
fn trips_and_faults_are_told_over_the_link() {
    let mut rig = driving();
    rig.run_for(Nanos::from_secs(40)).unwrap();
    let records = rig.records();
    let driven = records.iter().rev().find_map(|(_, record)| match record {
        Record::Trips(trips) => Some(trips.trips[0].hectometres),
        _ => None,
    });
    assert!(driven.is_some_and(|hectometres| hectometres > 0), "{driven:?}");
    let counts = |record: &Record| match record {
        Record::Active { count, .. } => Some(*count),
        _ => None,
    };
    assert!(records.iter().any(|(_, record)| counts(record) == Some(0)), "nothing is wrong at first");
    let first = records.iter().find_map(|(at, record)| match record {
        Record::Remembered { fault, .. } => Some((*at, fault.first_ms)),
        _ => None,
    });
    let (at, came_ms) = first.expect("the drive has a fault");
    let delay_ms = at.0 / 1_000_000 - came_ms;
    assert!(delay_ms < 500, "told {delay_ms} ms after it came");
}
