//! What went wrong since power-on: entries, counts, records.

use crate::support::probe::*;
use crate::support::*;
use cluster::{Entry, FaultId};
use proptest::prelude::*;
use protocol_core::model::Value as V;
use protocol_core::vehicle::Node;
use protocol_core::{Millis, Severity};

fn entries(drive: &Drive) -> Vec<Entry> {
    drive.cluster.history().copied().collect()
}

#[test]
fn a_fault_is_remembered_with_its_times_and_how_often_it_came() {
    let mut drive = healthy();
    let first = drive.now;
    for _ in 0..3 {
        drive.keep(Node::Dcdc, V::DcdcState, 2);
        drive.keep(Node::Dcdc, V::DcdcFaultCode, 5);
        drive.run(CYCLE);
        drive.keep(Node::Dcdc, V::DcdcState, 1);
        drive.run(CYCLE);
    }
    let (fault, code, severity) = (FaultId::Dcdc, Some(5), Severity::Warn);
    let last = Millis(first.0 + 4 * CYCLE);
    assert_eq!(entries(&drive), [Entry { fault, code, severity, first, last, count: 3 }]);
    assert_eq!(drive.faults(), []);
}

#[test]
fn the_worst_that_a_fault_has_been_is_remembered_and_worsening_is_no_return() {
    let mut drive = healthy();
    for level in [1, 3, 2] {
        drive.keep(Node::Vcu, V::VehicleFaultLevel, level);
        drive.run(CYCLE);
    }
    let all: Vec<_> =
        entries(&drive).iter().map(|entry| (entry.fault, entry.severity, entry.count)).collect();
    assert_eq!(all, [(FaultId::VehicleLevel, Severity::Stop, 1)]);
}

#[test]
fn the_worst_is_remembered_even_if_it_lasted_for_one_tick() {
    let mut drive = healthy();
    for level in [1, 3, 1] {
        drive.keep(Node::Vcu, V::VehicleFaultLevel, level);
        drive.run_by(CYCLE, CYCLE);
    }
    assert_eq!(entries(&drive).iter().map(|entry| entry.severity).collect::<Vec<_>>(), [Severity::Stop]);
}

#[test]
fn a_component_that_changes_its_code_has_two_entries() {
    let mut drive = healthy();
    drive.keep(Node::Dcdc, V::DcdcState, 2);
    for code in [5, 6, 5] {
        drive.keep(Node::Dcdc, V::DcdcFaultCode, code);
        drive.run(CYCLE);
    }
    let all: Vec<_> = entries(&drive).iter().map(|entry| (entry.code, entry.count)).collect();
    assert_eq!(all, [(Some(5), 2), (Some(6), 1)]);
    assert_eq!(drive.cluster.active_faults(drive.last()).map(|fault| fault.count).collect::<Vec<_>>(), [2]);
}

#[test]
fn the_oldest_entry_makes_room() {
    let mut drive = healthy();
    drive.keep(Node::Vcu, V::VehicleFaultLevel, 0);
    for code in 100..140 {
        drive.keep(Node::Vcu, V::VehicleFaultCode, code);
        drive.run(CYCLE);
    }
    let codes: Vec<_> = entries(&drive).iter().filter_map(|entry| entry.code).collect();
    assert_eq!(codes, (108..140).collect::<Vec<_>>());
}

#[test]
fn the_record_of_an_entry_is_as_documented() {
    let entry = Entry {
        fault: FaultId::Battery,
        code: Some(0x0102),
        severity: Severity::Derate,
        first: Millis(0x05_0403_0201),
        last: Millis(0x0A_0908_0706),
        count: 0x0B0C,
    };
    let bytes = [6, 2, 2, 1, 0x0C, 0x0B, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10];
    assert_eq!(entry.to_bytes(), bytes);
    assert_eq!(Entry::from_bytes(&bytes), Some(entry));
}

#[test]
fn a_time_beyond_the_record_stays_at_its_end() {
    let fault = FaultId::Smoke;
    let (first, last) = (Millis(u64::MAX), Millis(1 << 40));
    let entry = Entry { fault, code: None, severity: Severity::Stop, first, last, count: 1 };
    let kept = Entry::from_bytes(&entry.to_bytes()).expect("an entry");
    assert_eq!((kept.first, kept.last), (Millis((1 << 40) - 1), Millis((1 << 40) - 1)));
}

#[test]
fn the_number_of_a_fault_never_changes() {
    use FaultId::{Battery, Fire, Limp, NoController, SilentContactors, VehicleLevel};
    // Kept records must still be readable.
    let fixed = [
        (VehicleLevel, 1),
        (Battery, 6),
        (Limp, 31),
        (SilentContactors, 73),
        (Fire, 96),
        (NoController, 128),
    ];
    assert!(fixed.iter().all(|(fault, number)| fault.number() == *number));
}

proptest! {
    #[test]
    fn any_record_is_refused_or_written_back_as_it_was(bytes in any::<[u8; 16]>(), number in 0u8..140, severity in 0u8..6) {
        let mut bytes = bytes;
        (bytes[0], bytes[1]) = (number, severity);
        let is_entry = FaultId::from_number(number).is_some() && severity <= 3 && bytes[4..6] != [0, 0];
        let entry = Entry::from_bytes(&bytes);
        prop_assert_eq!(entry.is_some(), is_entry);
        if let Some(entry) = entry {
            prop_assert_eq!(entry.to_bytes(), bytes);
        }
    }
}
