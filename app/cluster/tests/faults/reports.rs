//! The message line: which fault, which words, whose turn.

use crate::support::toy::*;
use crate::support::*;
use cluster::{Button, FaultId, Sound, Telltale};
use protocol_core::Severity;

#[test]
fn bus_r049_no_text_without_a_level() {
    let mut drive = healthy();
    drive.report(0, 0);
    drive.run(1_000);
    assert_eq!(drive.line(), None);
    assert_eq!(drive.view().severity, Severity::None);
}

#[test]
fn bus_r050_each_level_has_its_text() {
    let texts = [
        (1, "系统一级故障", "System fault level 1", Severity::Warn),
        (2, "系统二级故障", "System fault level 2", Severity::Derate),
        (3, "系统三级故障", "System fault level 3", Severity::Stop),
    ];
    for (level, zh, en, severity) in texts {
        let mut drive = healthy();
        drive.report(level, 0);
        drive.run(CYCLE);
        let view = drive.view();
        let line = view.line.expect("a level has a text");
        assert_eq!((line.text.zh, line.text.en, line.severity, view.severity), (zh, en, severity, severity));
        drive.report(0, 0);
        drive.run(CYCLE);
        assert_eq!(drive.line(), None, "gone with the level");
    }
}

#[test]
fn bus_r051_the_code_of_the_vehicle_has_two_bytes() {
    let mut drive = healthy();
    drive.report(1, 0xABCD);
    drive.run(CYCLE);
    assert_eq!(drive.lines(2), [("System fault level 1", None), ("Vehicle fault code", Some(0xABCD))]);
}

#[test]
fn bus_55_a_code_without_a_level_is_shown_as_a_number_and_makes_no_sound() {
    let mut drive = healthy();
    drive.report(0, 700);
    drive.run(CYCLE);
    assert_eq!(drive.line(), Some(("Vehicle fault code", Some(700))));
    assert_eq!(drive.view().severity, Severity::None);
    assert_eq!(drive.sound(), None);
}

#[test]
fn bus_r072_a_battery_code_that_the_vehicle_forwards_has_its_text() {
    let mut drive = healthy();
    drive.report(2, 3);
    drive.run(CYCLE);
    assert_eq!(drive.lines(2), [("System fault level 2", None), ("Cell overvoltage", Some(3))]);
}

#[test]
fn bus_54_the_high_byte_of_a_code_counts() {
    let mut drive = healthy();
    drive.report(2, 0x103);
    drive.run(1_100);
    assert_eq!(drive.line(), Some(("Vehicle fault code", Some(0x103))));
}

#[test]
fn bus_77_the_battery_speaks_for_itself_only_until_the_vehicle_forwards_its_code() {
    let mut drive = healthy();
    drive.battery_report(3, 4);
    drive.run(CYCLE);
    assert_eq!(drive.lines(3), [("Cell undervoltage", Some(4))]);
    drive.report(3, 4);
    drive.run(CYCLE);
    let view = drive.view();
    assert_eq!(view.line.map(|line| line.count), Some(2), "level text and one code, not two");
}

#[test]
fn bus_79_the_level_comes_from_the_level_field_not_from_the_code() {
    let mut drive = healthy();
    // Code 3 is a level 3 fault in the battery's table; the field says level 1.
    drive.battery_report(1, 3);
    drive.run(CYCLE);
    assert_eq!(drive.view().severity, Severity::Warn);
}

#[test]
fn a_code_decides_its_severity_only_where_the_vehicle_has_no_level_field() {
    let mut drive = Drive::of(&TOY);
    drive.report(NO_LEVEL, 9);
    drive.run(CYCLE);
    assert_eq!((drive.line(), drive.view().severity), (Some(("Nine", Some(9))), Severity::Stop));
    drive.report(1, 9);
    drive.run(CYCLE);
    assert_eq!(drive.view().severity, Severity::Warn);
}

#[test]
fn a_code_that_arrives_after_its_level_takes_the_place_of_the_level_text() {
    let mut drive = healthy();
    drive.battery_report(2, 0);
    drive.run(CYCLE);
    drive.battery_report(2, 4);
    drive.run(CYCLE);
    assert_eq!(drive.lines(3), [("Cell undervoltage", Some(4))]);
}

#[test]
fn a_battery_level_without_a_code_still_has_a_text() {
    let mut drive = healthy();
    drive.battery_report(2, 0);
    drive.run(CYCLE);
    assert_eq!(drive.line(), Some(("Battery fault level 2", None)));
}

#[test]
fn components_in_their_fault_state_have_texts_and_codes_as_numbers() {
    // BUS-R059, BUS-R119, BUS-R123, BUS-R125; the code is a number only (BUS-R033).
    let rows: [(_, [u8; 8], _, _, _); 4] = [
        (MOTOR, [0, 0, 1, 12, 0, 0, 0, 0], "电机控制器系统故障", 12, Telltale::MotorFault),
        (PARTS, [1, 0, 2, 4, 1, 0, 0, 0], "助力系统故障", 4, Telltale::Steering),
        (PARTS, [2, 5, 1, 0, 1, 0, 0, 0], "DCDC 系统故障", 5, Telltale::LowVoltage),
        (PARTS, [1, 0, 1, 0, 2, 6, 0, 0], "空压机系统故障", 6, Telltale::Compressor),
    ];
    for (id, data, zh, code, lamp) in rows {
        let mut drive = healthy();
        drive.repeat(id, data);
        drive.run(CYCLE);
        let line = drive.view().line.expect("a component has failed");
        assert_eq!((line.text.zh, line.code, line.severity), (zh, Some(code), Severity::Warn));
        assert!(drive.view().telltales.is_lit(lamp), "{zh}");
    }
}

#[test]
fn bus_90_a_component_code_without_the_fault_state_is_no_line() {
    let mut drive = healthy();
    drive.repeat(PARTS, [1, 5, 1, 4, 1, 6, 0, 0]);
    drive.run(CYCLE);
    assert_eq!(drive.line(), None);
    drive.repeat(PARTS, [3, 5, 3, 4, 3, 6, 0, 0]);
    drive.run(CYCLE);
    assert_eq!(drive.line(), None, "status 3 is not defined");
}

#[test]
fn bus_113_texts_take_turns_of_one_second_the_system_level_first() {
    let mut drive = healthy();
    drive.repeat(PARTS, [2, 5, 1, 0, 2, 6, 0, 0]);
    drive.report(3, 0);
    drive.run(CYCLE);
    let start = drive.now;
    let expected = ["System fault level 3", "DC/DC converter fault", "Air compressor fault"];
    let mut changes = Vec::new();
    let mut last = None;
    while drive.now < start.after(6_000) {
        if drive.line() != last {
            last = drive.line();
            changes.push((drive.now, last.map(|(text, _)| text)));
        }
        drive.run(TICK);
    }
    for (n, pair) in changes.windows(2).enumerate().skip(1) {
        assert_eq!(pair[1].0.since(pair[0].0), 1_000, "turn {n}");
    }
    let texts: Vec<_> = changes.iter().filter_map(|change| change.1).collect();
    assert_eq!(texts[..3], expected);
    assert_eq!(texts[3..6], expected);
}

#[test]
fn bus_r024_and_bus_r025_limits_are_shown_as_lines_and_lamp() {
    for (bit, text) in [(0b0100, "Power limited"), (0b1000, "Torque limited")] {
        let mut drive = healthy();
        drive.repeat(DRIVE, [1, 0, 0, bit, 0, 0, 0, 0]);
        drive.run(CYCLE);
        assert_eq!(drive.line(), Some((text, None)));
        assert!(drive.view().telltales.is_lit(Telltale::PowerLimited));
        assert_eq!(drive.sound(), None);
        drive.gear_and_speed(1, 0);
        drive.run(CYCLE);
        assert_eq!(drive.line(), None);
    }
}

#[test]
fn the_highest_severity_hides_the_others_and_gives_them_back() {
    let mut drive = healthy();
    drive.battery_report(1, 3);
    drive.run(CYCLE);
    drive.report(3, 500);
    drive.run(CYCLE);
    let lines = drive.lines(4);
    assert!(!lines.contains(&("Cell overvoltage", Some(3))), "{lines:?}");
    drive.report(0, 0);
    drive.run(CYCLE);
    assert_eq!(drive.line(), Some(("Cell overvoltage", Some(3))));
}

/// Sends the codes of one level in turn, one second each, as BUS-R028 and BUS-33 have it.
fn rotate(drive: &mut Drive, level: u8, codes: &[u16], seconds: usize) -> Vec<(&'static str, Option<u16>)> {
    let mut seen = Vec::new();
    for second in 0..seconds {
        drive.report(level, codes[second % codes.len()]);
        for _ in 0..1_000 / TICK {
            drive.run(TICK);
            seen.extend(drive.line().filter(|line| !seen.contains(line)));
        }
    }
    seen
}

#[test]
fn codes_that_the_sender_rotates_stay_active_in_between() {
    let mut drive = healthy();
    let seen = rotate(&mut drive, 2, &[101, 102, 103, 104], 12);
    assert_eq!(drive.view().line.map(|line| line.count), Some(5), "level text and four codes");
    assert_eq!(seen.len(), 5);
    // One of them is repaired: it goes after ten seconds without it.
    rotate(&mut drive, 2, &[101, 102, 103], 8);
    assert_eq!(drive.view().line.map(|line| line.count), Some(5));
    rotate(&mut drive, 2, &[101, 102, 103], 6);
    assert_eq!(drive.view().line.map(|line| line.count), Some(4));
}

#[test]
fn bus_r027_a_lower_level_means_that_the_higher_faults_are_gone() {
    let mut drive = healthy();
    rotate(&mut drive, 3, &[201, 202], 4);
    drive.report(1, 301);
    drive.run(CYCLE);
    assert_eq!(drive.view().severity, Severity::Warn);
    assert_eq!(drive.view().line.map(|line| line.count), Some(2), "level text and the code of level 1");
}

#[test]
fn a_code_that_comes_behind_its_level_leaves_nothing_of_the_old_one() {
    let mut drive = healthy();
    drive.battery_report(2, 63);
    drive.run(CYCLE);
    // The level is in one message, the code in another: for a moment STOP stands beside the code of level 2.
    drive.battery_report(3, 63);
    drive.run(CYCLE);
    drive.battery_report(3, 20);
    drive.run(CYCLE);
    assert_eq!(drive.turns(3), [("Battery fault level 3", Some(20))]);
    // And the same on the way back.
    drive.battery_report(2, 20);
    drive.run(CYCLE);
    drive.battery_report(2, 63);
    drive.run(CYCLE);
    assert_eq!(drive.turns(3), [("Battery fault level 2", Some(63))]);
}

#[test]
fn a_fault_that_worsens_moves_up_at_once() {
    let mut drive = healthy();
    drive.report(1, 500);
    drive.run(CYCLE);
    drive.report(3, 500);
    drive.run(CYCLE);
    assert_eq!(drive.view().severity, Severity::Stop);
    assert_eq!(drive.view().line.map(|line| line.count), Some(2));
}

#[test]
fn silence_never_clears_a_stop_fault() {
    let mut drive = healthy();
    drive.report(3, 77);
    drive.run(CYCLE);
    drive.stop(FAULTS);
    drive.run(100_000);
    assert_eq!(drive.view().severity, Severity::Stop);
    assert_eq!(drive.lines(2), [("System fault level 3", None), ("Vehicle fault code", Some(77))]);
    drive.report(0, 0);
    drive.run(CYCLE);
    assert_eq!(drive.line(), None, "only its source takes it back");
}

#[test]
fn a_level_that_is_not_valid_neither_clears_nor_softens_a_stop_fault() {
    let mut drive = healthy();
    drive.report(3, 77);
    drive.run(CYCLE);
    drive.report(BAD_LEVEL, 77);
    drive.run(CYCLE);
    assert_eq!(drive.view().severity, Severity::Stop);
    assert_eq!(drive.lines(2), [("System fault level 3", None), ("Vehicle fault code", Some(77))]);
}

#[test]
fn silence_takes_milder_faults_away_and_says_why() {
    let mut drive = healthy();
    drive.battery_report(2, 3);
    drive.run(3_000);
    drive.stop(PACK);
    drive.run(500);
    assert_eq!(drive.lines(3), [("No communication: BMS", None)]);
}

#[test]
fn bus_67_the_battery_asks_for_high_voltage_off() {
    let mut drive = healthy();
    let mut data = PACK_WELL;
    data[6] = 0b11;
    drive.repeat(PACK, data);
    drive.run(CYCLE);
    assert_eq!(drive.line(), Some(("Battery asks for HV off: stop", None)));
    assert_eq!(drive.view().severity, Severity::Stop);
    drive.repeat(PACK, PACK_WELL);
    drive.run(CYCLE);
    assert_eq!(drive.line(), None, "withdrawn");
}

#[test]
fn bus_68_the_line_tells_when_the_vehicle_and_when_the_battery_is_due() {
    let mut drive = healthy();
    let mut data = PACK_WELL;
    data[6] = 0b11;
    drive.repeat(PACK, data);
    let start = drive.now;
    let at = |drive: &mut Drive, ms: u64| {
        drive.run(start.after(ms + TICK).since(drive.now));
        drive.line().map(|(text, _)| text)
    };
    assert_eq!(at(&mut drive, 4_990), Some("Battery asks for HV off: stop"));
    assert_eq!(at(&mut drive, 5_000), Some("HV still on: battery will cut it"));
    assert_eq!(at(&mut drive, 34_990), Some("HV still on: battery will cut it"));
    assert_eq!(at(&mut drive, 35_000), Some("Battery cuts HV now"));
}

#[test]
fn bus_68_an_acknowledged_request_sounds_again_with_each_phase() {
    let mut drive = healthy();
    let mut data = PACK_WELL;
    data[6] = 0b11;
    drive.repeat(PACK, data);
    let start = drive.now;
    for begins in [0, 5_000, 35_000] {
        drive.run(start.after(begins + 2 * TICK).since(drive.now));
        assert_eq!(drive.sound(), Some(Sound::Stop), "{begins} ms after the request");
        drive.cluster.press(Button::Next, drive.now);
        drive.run(1_000);
        assert_eq!(drive.sound(), None, "acknowledged");
    }
    drive.run(60_000);
    assert_eq!(drive.sound(), None, "nothing new");
}

#[test]
fn bus_116_fire_by_either_route_takes_over_everything_until_power_off() {
    for route in ["vehicle", "battery"] {
        let mut drive = healthy();
        drive.repeat(PARTS, [2, 5, 1, 0, 2, 6, 0, 0]);
        match route {
            "vehicle" => drive.report(3, 24),
            _ => drive.battery_report(3, 24),
        }
        drive.run(CYCLE);
        assert_eq!(drive.lines(4), [("FIRE: stop, get everyone out", Some(24))], "{route}");
        drive.report(3, 4);
        drive.battery_report(3, 3);
        drive.run(10_000);
        assert_eq!(drive.lines(4), [("FIRE: stop, get everyone out", Some(24))], "{route}: another code");
        drive.report(0, 0);
        drive.battery_report(0, 0);
        drive.run(60_000);
        let view = drive.view();
        assert_eq!(drive.line(), Some(("FIRE: stop, get everyone out", Some(24))), "{route}: latched");
        assert_eq!((view.severity, view.line.map(|line| line.count)), (Severity::Stop, Some(1)));
    }
}

#[test]
fn bus_r079_fire_by_either_route_lights_its_telltale_and_stands_in_the_list_and_in_the_history() {
    for route in ["vehicle", "battery"] {
        let mut drive = healthy();
        // The battery says its code in a message of its own; its level may say something else.
        match route {
            "vehicle" => drive.report(3, 24),
            _ => drive.battery_report(0, 24),
        }
        drive.run(CYCLE);
        drive.report(0, 0);
        drive.battery_report(0, 0);
        drive.run(60_000);
        assert!(drive.view().telltales.is_lit(Telltale::BatteryFault), "{route}");
        let active: Vec<_> = drive.cluster.active_faults(drive.now).collect();
        let fire = active.first().expect("an active fault");
        assert_eq!((fire.named.fault, fire.code, fire.severity), (FaultId::Fire, Some(24), Severity::Stop));
        let entries = drive.cluster.history().filter(|entry| entry.fault == FaultId::Fire);
        assert_eq!(entries.map(|entry| (entry.code, entry.count)).collect::<Vec<_>>(), [(Some(24), 1)]);
    }
}

#[test]
fn bus_116_fire_is_not_missed_between_two_ticks() {
    let mut drive = healthy();
    drive.send(FAULTS, [3, 24, 0, 0, 0, 0, 0, 0]);
    drive.send(FAULTS, [0; 8]);
    drive.run(TICK);
    assert_eq!(drive.line(), Some(("FIRE: stop, get everyone out", Some(24))));
}

#[test]
fn bus_106_24_is_no_fire_in_another_name_space() {
    let mut drive = healthy();
    drive.repeat(MOTOR, [0, 0, 1, 24, 0, 0, 0, 0]);
    drive.repeat(PARTS, [2, 24, 2, 24, 2, 24, 0, 0]);
    drive.run(CYCLE);
    assert!(drive.lines(5).iter().all(|(text, _)| !text.contains("FIRE")));
}

#[test]
fn bus_106_24_is_no_fire_on_a_vehicle_that_calls_it_otherwise() {
    let mut drive = Drive::of(&TOY);
    drive.cluster = cluster::Cluster::new(&OTHER);
    drive.report(3, 24);
    drive.battery_report(3, 24);
    drive.run(CYCLE);
    assert_eq!(drive.lines(3), [("System fault level 3", None), ("Cells uneven", Some(24))]);
}

#[test]
fn more_faults_than_there_is_room_for_keep_the_worst() {
    let mut drive = healthy();
    // Thirty codes of level 1, faster than any of them is forgotten, then one STOP.
    for code in 100..130 {
        drive.report(1, code);
        drive.run(CYCLE);
    }
    drive.battery_report(3, 4);
    drive.run(CYCLE);
    assert_eq!(drive.view().severity, Severity::Stop);
    assert_eq!(drive.line(), Some(("Cell undervoltage", Some(4))));
}

#[test]
fn when_the_shown_fault_goes_the_one_after_it_is_next() {
    let mut drive = healthy();
    drive.repeat(PARTS, [2, 5, 2, 4, 2, 6, 0, 0]);
    drive.run(TICK);
    assert_eq!(drive.line(), Some(("Steering assistance fault", Some(4))));
    drive.run(1_500);
    assert_eq!(drive.line(), Some(("DC/DC converter fault", Some(5))));
    drive.repeat(PARTS, [1, 0, 2, 4, 2, 6, 0, 0]);
    drive.run(CYCLE);
    assert_eq!(drive.line(), Some(("Air compressor fault", Some(6))));
}
