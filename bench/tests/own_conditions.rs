//! What the firmware says of itself: the cause stands on the screen, not the nodes that are missed because of it.

mod firmware;

use bench::can::{Frame, Id};
use bench::chips::mcp2515::Mode;
use bench::log::{Entry, Log};
use bench::rig::{Rig, RigOptions};
use bench::time::Nanos;
use cluster::FaultId;
use object::{Object, ObjectSection, ObjectSymbol};
use protocol_core::link::Screen;
use std::path::Path;

fn city() -> Log {
    let path = surroundings::root().join("vehicles/citybus/captures/city.log");
    Log::read_file(&path).unwrap()
}

fn says(rig: &Rig, fault: FaultId) -> bool {
    rig.screen().and_then(|screen: Screen| screen.line).is_some_and(|line| line.fault == fault.number())
}

/// Returns whether the screen says that this vehicle was identified.
fn names(rig: &Rig, vehicle: &str) -> bool {
    says(rig, FaultId::Identified) && rig.identified().name == vehicle
}

/// Runs for `seconds` and asserts every 100 ms that the line is `fault`.
fn keeps_saying(rig: &mut Rig, fault: FaultId, seconds: u64) {
    for tenth in 0..seconds * 10 {
        let line = rig.screen().and_then(|screen| screen.line);
        assert!(says(rig, fault), "{fault:?} after {tenth} tenths of a second: {line:?}");
        rig.run_for(Nanos::from_millis(100)).unwrap();
    }
}

#[test]
fn a_controller_that_answers_no_more_is_named_and_not_the_nodes_that_it_no_longer_hears() {
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.replay(&city(), true);
    rig.run_for(Nanos::from_secs(6)).unwrap();
    rig.board_mut().cut_miso(true);
    rig.run_for(Nanos::from_millis(1_500)).unwrap();
    keeps_saying(&mut rig, FaultId::NoController, 12);
    rig.board_mut().cut_miso(false);
    rig.run_for(Nanos::from_secs(3)).unwrap();
    assert!(!says(&rig, FaultId::NoController), "it is back");
}

/// What a tester of another vehicle sends: three of its messages, `rounds` times, 10 ms apart, from the start on.
fn tester(rounds: u64) -> Vec<Entry> {
    let turns = (0..rounds).flat_map(|_| [0x1802_28D0, 0x1803_28D0, 0x1804_28D0]);
    let stray = |(id, turn): (u32, u64)| {
        let frame = Frame::new(Id::extended(id).expect("29 bits"), &[0; 8]).expect("8 bytes");
        Entry { at: Nanos::from_millis(10 * turn), frame, line: 0, channel: 0 }
    };
    turns.zip(0..).map(stray).collect()
}

#[test]
fn a_wrong_recognition_is_right_three_seconds_after_the_first_frame_of_the_right_vehicle() {
    for rounds in [1, 3] {
        let mut log = city();
        log.entries.iter_mut().for_each(|entry| entry.at += Nanos::from_millis(500));
        log.entries.splice(0..0, tester(rounds));
        let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
        rig.run_for(Nanos::from_millis(300)).unwrap();
        rig.replay(&log, false);
        rig.run_for(Nanos::from_millis(450)).unwrap();
        assert_eq!(names(&rig, "jiulong"), rounds > 1, "three frames, each once, say nothing");
        rig.run_for(Nanos::from_millis(150)).unwrap();
        let doubtful = rig.heard().len();
        rig.run_for(Nanos::from_millis(1_400)).unwrap();
        if rounds > 1 {
            assert!(says(&rig, FaultId::Doubt), "for as long as it lasts");
            let heard = rig.heard();
            let sent: Vec<_> = heard[doubtful..].iter().filter(|heard| heard.by_cluster).collect();
            assert!(
                sent.is_empty(),
                "nothing is sent on a doubtful bus: {sent:?}, from {:?}",
                heard[doubtful].at
            );
            assert_eq!(rig.board().mcp2515().mode(), Mode::ListenOnly);
        }
        rig.run_for(Nanos::from_millis(1_500)).unwrap();
        assert!(names(&rig, "citybus"), "the right one, by its name");
        let right = rig.heard().len();
        rig.run_for(Nanos::from_secs(3)).unwrap();
        let screen = rig.screen().expect("the firmware reports");
        assert!(matches!(screen.speed_kmh, protocol_core::link::Sample::Value(_)), "{:?}", screen.speed_kmh);
        let heard = rig.heard();
        let sent: Vec<_> = heard[right..].iter().filter(|heard| heard.by_cluster).collect();
        let ids = protocol_core::generated::citybus::VEHICLE.tx.iter().map(|message| message.id.bits());
        let own: Vec<u32> = ids.collect();
        assert!(sent.len() >= 4, "{} frames in 3 s", sent.len());
        assert!(sent.iter().all(|heard| own.contains(&heard.frame.id.raw())), "its own frames only");
    }
}

/// Writes the image anew with the function whose mangled name ends in `name` replaced by an endless loop.
fn with_endless_loop(elf: &Path, name: &str, to: &Path) {
    let mut bytes = std::fs::read(elf).unwrap();
    let file = object::File::parse(&*bytes).unwrap();
    let mut found = file.symbols().filter(|symbol| symbol.name().is_ok_and(|it| it.contains(name)));
    let symbol = found.next().unwrap_or_else(|| panic!("{name} is not in the image"));
    assert!(found.next().is_none(), "{name} is there twice");
    let section = file.section_by_index(symbol.section_index().unwrap()).unwrap();
    let (start, _) = section.file_range().unwrap();
    // Bit 0 of the address of a function only says that it is Thumb code.
    let place = (start + (symbol.address() & !1) - section.address()) as usize;
    drop(found);
    // `b .`
    bytes[place..place + 2].copy_from_slice(&0xE7FE_u16.to_le_bytes());
    std::fs::write(to, bytes).unwrap();
}

#[test]
fn a_reset_by_the_watchdog_is_said_on_the_screen_for_ten_seconds() {
    let folder = tempfile::tempdir().unwrap();
    let elf = folder.path().join("stands-still.elf");
    // Reached by the first fault: until then this firmware is like any other.
    with_endless_loop(&firmware::elf(), "6Faults7present", &elf);
    let mut rig = Rig::new(&elf, &RigOptions::default()).unwrap();
    rig.run_for(Nanos::from_secs(1)).unwrap();
    assert!(!says(&rig, FaultId::Restarted), "power came up");
    // Three identifiers of the bus, one of them with a level 3 fault, and a counter that counts: recognised, and the
    // firmware stands still.
    for (id, data) in [
        (0x0CF1_01A7, [0x07, 0, 0, 0, 0, 0xFF, 0x80, 1]),
        (0x18F1_3DF3, [0x7C, 0x15, 0x10, 0x27, 0xC8, 0, 0x50, 0x40]),
        (0x0CF1_064A, [3, 0, 0, 0xFF, 0, 0xFF, 0xFF, 0xFF]),
        (0x0CF1_01A7, [0x07, 0, 0, 0, 0, 0xFF, 0x80, 2]),
    ] {
        rig.send(Frame::new(Id::extended(id).expect("29 bits"), &data).expect("8 bytes"));
    }
    // The watchdog's second, and the start.
    rig.run_for(Nanos::from_millis(2_000)).unwrap();
    keeps_saying(&mut rig, FaultId::Restarted, 8);
    rig.run_for(Nanos::from_secs(3)).unwrap();
    assert!(!says(&rig, FaultId::Restarted), "ten seconds are over");
}
