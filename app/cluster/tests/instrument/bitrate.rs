//! The bit rate at which to listen.

use cluster::instrument::bitrate::BitrateScan;
use protocol_core::Millis;
use protocol_core::generated::{VEHICLES, citybus, jiulong};
use protocol_core::vehicle::Vehicle;

#[test]
fn the_scan_waits_on_a_silent_bus_and_moves_on_errors() {
    let mut scan = BitrateScan::new(VEHICLES);
    assert_eq!(scan.bitrate(), 250_000);
    assert!((0..100_000).step_by(10).all(|now| scan.listen(false, false, Millis(now)).is_none()));
    assert_eq!(scan.listen(false, true, Millis(100_000)), Some(500_000));
    assert_eq!(scan.listen(false, true, Millis(100_010)), None, "it gives each rate a little time");
    assert_eq!(scan.listen(false, true, Millis(100_020)), Some(250_000));
}

#[test]
fn a_rate_with_frames_survives_errors_and_is_left_when_only_errors_remain() {
    let mut scan = BitrateScan::new(VEHICLES);
    for now in (0..5_000).step_by(10) {
        assert_eq!(scan.listen(now % 300 == 0, true, Millis(now)), None);
    }
    let left = (5_000..6_000).step_by(10).find(|&now| scan.listen(false, true, Millis(now)).is_some());
    assert_eq!(left, Some(5_300), "500 ms after the last frame, at 4800");
}

#[test]
fn where_all_vehicles_have_one_rate_errors_change_nothing() {
    static SAME_RATE: [&Vehicle; 2] = [&citybus::VEHICLE, &jiulong::VEHICLE];
    let mut scan = BitrateScan::new(&SAME_RATE);
    assert!((0..10_000).step_by(10).all(|now| scan.listen(false, true, Millis(now)).is_none()));
    assert_eq!(scan.bitrate(), 250_000);
}
