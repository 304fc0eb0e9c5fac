//! From the wire to the glass: how soon the driver sees what a frame says, with the image that goes to the board.

mod firmware;

use bench::latency::{Change, Traffic, measure};
use bench::log::Log;
use bench::time::Nanos;

/// Changes of each kind: the phase between the bus and the firmware's tick takes as many values.
const CHANGES: usize = 60;

fn held(change: Change, traffic: Traffic, median_ms: u64, worst_ms: u64) {
    let city = surroundings::root().join("vehicles/citybus/captures/city.log");
    let city = Log::read_file(&city).unwrap();
    let times = measure(&firmware::elf(), &city, change, traffic, CHANGES).unwrap();
    let (median, worst) = (times.median(), times.worst());
    println!("{change:?}, {traffic:?}: median {median}, worst {worst}");
    assert!(median <= Nanos::from_millis(median_ms), "{change:?}, {traffic:?}: median {median}");
    assert!(worst <= Nanos::from_millis(worst_ms), "{change:?}, {traffic:?}: worst {worst}");
}

#[test]
fn a_gear_shows_within_20_ms() {
    held(Change::Gear, Traffic::Standing, 10, 20);
}

#[test]
fn a_fault_shows_within_30_ms() {
    held(Change::Fault, Traffic::Standing, 15, 30);
}

#[test]
fn a_speed_shows_within_30_ms_with_its_pointer() {
    held(Change::Speed, Traffic::Standing, 15, 30);
}

#[test]
fn a_speed_that_sweeps_the_dial_shows_within_30_ms() {
    held(Change::Dial, Traffic::Standing, 20, 30);
}

#[test]
fn a_speed_shows_within_30_ms_on_a_full_bus() {
    held(Change::Speed, Traffic::Full, 15, 30);
}
