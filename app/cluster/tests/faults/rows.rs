//! Every row of the table: when it is on the line, how bad it is, whether it sounds.

use crate::support::probe::*;
use crate::support::*;
use cluster::faults::{Grade, ROWS, Route, Row, Voice, When, Words};
use cluster::view::Text;
use cluster::{FaultId, Sound};
use proptest::prelude::*;
use protocol_core::Severity::{self, Derate, Stop, Warn};
use protocol_core::model::Value as V;
use protocol_core::vehicle::{Node, RxMessage};

/// One value that makes a fault by one of its routes, and what the row says then.
#[derive(Clone, Copy, Debug)]
struct Case {
    row: &'static Row,
    route: &'static Route,
    value: V,
    number: i32,
    text: &'static str,
    severity: Severity,
}

impl Case {
    fn of(row: &'static Row, route: &'static Route, value: V, number: i32) -> Self {
        let severity = match route.grade {
            Grade::Level(level) => {
                assert_eq!(level, value, "a level grades itself");
                Severity::from_model(number)
            }
            Grade::Always(severity) | Grade::Joins(severity) => severity,
            Grade::Alarm(_) => panic!("alarm bits have tests of their own"),
        };
        let stage = if matches!(row.words, Words::Levels(_)) { number as usize - 1 } else { 0 };
        Self { row, route, value, number, text: row.words.texts()[stage].en, severity }
    }

    fn sounds(&self) -> bool {
        // The vehicle stands.
        self.row.voice == Voice::AsSevere
    }
}

/// Every value that makes a fault, at every level that it can have.
fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for row in ROWS {
        for route in row.routes {
            let (values, numbers): (&[V], &[i32]) = match &route.when {
                When::Level(value) => (core::slice::from_ref(value), &[1, 2, 3]),
                // What the cluster itself decides, no frame can say.
                When::Is(value, _) if value.path().starts_with("cluster.") => continue,
                When::Is(value, number) => (core::slice::from_ref(value), core::slice::from_ref(number)),
                When::AnyIs(values, number) => (values, core::slice::from_ref(number)),
                // What depends on the vehicle's motion has tests of its own, below.
                When::AnyBelow(..) | When::Moving(_) => continue,
                When::HvOff => (&[V::BatteryHvOffRequest], &[1]),
                // Codes, bits, silence and fire have tests of their own; what the instrument finds in itself is in `own`.
                When::Code(_) | When::Bits(_) | When::Silent(_) | When::Limps => continue,
                When::ChargerLost | When::HvacLost | When::Fire(..) | When::Own => continue,
            };
            for &value in values {
                cases.extend(numbers.iter().map(|&number| Case::of(row, route, value, number)));
            }
        }
    }
    assert!(cases.len() > 40, "only {} values make a fault", cases.len());
    cases
}

#[test]
fn every_fault_has_its_text_its_severity_and_its_sound_and_ends_with_its_cause() {
    for case in cases() {
        let (path, text, severity) = (case.value.path(), case.text, case.severity);
        let mut drive = healthy();
        drive.keep(Node::Inverter, case.value, case.number);
        drive.run(CYCLE);
        assert_eq!(drive.faults(), [(text, None, severity)], "{path}");
        assert_eq!(drive.view().line.map(|line| line.text.en), Some(text));
        assert_eq!(drive.view().line.map(|line| line.named.fault), Some(case.row.fault), "{path}");
        assert_eq!(drive.sound().is_some(), case.sounds(), "{path}");
        let kept: Vec<_> = drive.cluster.history().map(|entry| entry.fault).collect();
        assert_eq!(kept == [case.row.fault], case.row.is_kept, "{path}");
        drive.keep(Node::Inverter, case.value, 0);
        drive.run(CYCLE);
        assert_eq!(drive.faults(), [], "{path}");
    }
}

/// Speed in the model's unit, 1/256 km/h.
const SLOW: i32 = 256;

#[test]
fn what_only_matters_in_motion_sounds_unless_the_vehicle_is_known_to_stand() {
    let rows: Vec<&Row> = ROWS.iter().filter(|row| row.voice == Voice::Moving).collect();
    assert!(rows.iter().any(|row| row.fault == FaultId::Steering), "steering is one of them");
    for case in cases().iter().filter(|case| case.row.voice == Voice::Moving) {
        let mut drive = healthy();
        drive.keep(Node::Vcu, V::VehicleSpeed, 0);
        drive.keep(Node::Inverter, case.value, case.number);
        drive.run(CYCLE);
        let path = case.value.path();
        assert_eq!((drive.faults().len(), drive.sound()), (1, None), "{path}: it is said and does not sound");
        drive.keep(Node::Vcu, V::VehicleSpeed, SLOW);
        drive.run(CYCLE);
        assert_eq!(drive.sound(), Some(Sound::Warn), "{path}: it sounds in motion");
        drive.keep(Node::Vcu, V::VehicleSpeed, -SLOW);
        drive.run(CYCLE);
        assert_eq!(drive.sound(), Some(Sound::Warn), "{path}: backwards, too");
        drive.hush(Node::Vcu);
        drive.run(TIMEOUT + CYCLE);
        assert!(drive.sound().is_some(), "{path}: at an unknown speed");
    }
}

#[test]
fn brake_air_is_low_below_its_limit_on_either_circuit() {
    for value in [V::AirFront, V::AirRear] {
        for (number, is_low) in [(39, true), (40, false), (0, true)] {
            let mut drive = healthy();
            drive.keep(Node::Inverter, V::AirFront, 80);
            drive.keep(Node::Inverter, V::AirRear, 80);
            drive.keep(Node::Inverter, value, number);
            drive.run(CYCLE);
            let said = drive.view().line.map(|line| line.named.fault);
            assert_eq!(said == Some(FaultId::AirLow), is_low, "{} {number}", value.path());
        }
    }
}

#[test]
fn an_open_door_is_said_in_motion_and_not_before_it() {
    for door in [V::BodyDoorFront, V::BodyDoorMiddle, V::BodyDoorRear, V::BodyDoorHatch] {
        let mut drive = healthy();
        drive.keep(Node::Inverter, door, 1);
        for (speed, is_said) in [(0, false), (SLOW, true), (-SLOW, true), (0, false)] {
            drive.keep(Node::Vcu, V::VehicleSpeed, speed);
            drive.run(CYCLE);
            let said = drive.view().line.map(|line| line.named.fault);
            assert_eq!(said == Some(FaultId::DoorOpen), is_said, "{} at {speed}", door.path());
        }
        drive.keep(Node::Vcu, V::VehicleSpeed, SLOW);
        drive.keep(Node::Inverter, door, 0);
        drive.run(CYCLE);
        assert_eq!(drive.view().line, None, "{}: closed", door.path());
    }
}

#[test]
fn every_text_has_room_in_the_line_beside_a_code() {
    for text in ROWS.iter().flat_map(|row| row.words.texts()) {
        // The line is 320 pixels wide: 40 Latin or 20 Chinese characters of 8 and 16 pixels, less the code.
        assert!(text.en.is_ascii() && text.en.len() <= 34, "{}", text.en);
        assert!(text.zh.chars().count() <= 17, "{}", text.zh);
    }
}

#[test]
fn what_two_faults_say_alike_is_of_the_same_part_of_the_vehicle() {
    // By its level and code, by a bit alone: no vehicle has both.
    let alike = [
        [FaultId::BatteryAlarm, FaultId::BatteryFault],
        [FaultId::Motor, FaultId::MotorAlarm],
        [FaultId::Insulation, FaultId::InsulationFault],
        [FaultId::Charger, FaultId::ChargerFault],
    ];
    for (place, row) in ROWS.iter().enumerate() {
        for other in &ROWS[place + 1..] {
            let texts = || other.words.texts().iter();
            let is_alike = |text: &Text| texts().any(|its| its.zh == text.zh || its.en == text.en);
            let found = row.words.texts().iter().any(is_alike);
            assert_eq!(found, alike.contains(&[row.fault, other.fault]), "{:?} {:?}", row.fault, other.fault);
        }
    }
}

#[test]
fn a_silent_node_has_its_line_its_severity_and_its_sound_and_ends_with_its_word() {
    use protocol_core::vehicle::Vehicle;
    static ALL_EXPECTED: Vehicle = Vehicle { rx: &EXPECTED, ..PROBE };
    const EXPECTED: [RxMessage; NODES.len()] = {
        let mut rows = RX;
        let mut at = 0;
        while at < rows.len() {
            rows[at].expected = true;
            at += 1;
        }
        rows
    };
    let silences = ROWS.iter().filter_map(|row| match row.routes {
        [Route { when: When::Silent(node), grade: Grade::Always(severity), .. }] => {
            Some((row, *node, *severity))
        }
        _ => None,
    });
    let mut nodes = 0;
    for (row, node, severity) in silences {
        let mut drive = Drive::of(&ALL_EXPECTED);
        for (place, &node) in NODES.iter().enumerate() {
            drive.keep(node, V::ALL[place], 0);
        }
        drive.run(6_000);
        assert_eq!(drive.faults(), [], "{node:?}");
        drive.hush(node);
        drive.run(TIMEOUT + CYCLE);
        let said = row.words.texts()[0].en;
        assert_eq!(drive.faults(), [(said, None, severity)], "{node:?}");
        assert_eq!(drive.sound().is_some(), row.voice == Voice::AsSevere, "{node:?}: the vehicle stands");
        drive.speak(node);
        drive.run(CYCLE + TICK);
        assert_eq!(drive.faults(), [], "{node:?}");
        nodes += 1;
    }
    assert_eq!(nodes, NODES.len());
}

#[test]
fn silence_of_its_sender_keeps_a_stop_fault_and_takes_the_others() {
    // The request for high voltage off has a clock of its own.
    for Case { value, number, text, severity, .. } in cases() {
        if value == V::BatteryHvOffRequest {
            continue;
        }
        let mut drive = healthy();
        // A node that nobody misses.
        drive.keep(Node::Inverter, value, number);
        drive.run(CYCLE);
        drive.hush(Node::Inverter);
        drive.run(10_000);
        let kept: &[_] = if severity == Stop { &[text] } else { &[] };
        assert_eq!(drive.texts(), kept, "{}", value.path());
    }
}

#[test]
fn a_value_that_its_sender_marks_as_not_valid_makes_no_fault() {
    for Case { value, .. } in cases() {
        let mut drive = healthy();
        drive.keep_invalid(Node::Inverter, value);
        drive.run(CYCLE);
        assert_eq!(drive.faults(), [], "{}", value.path());
    }
}

#[test]
fn jl_r013_a_level_1_fault_of_any_of_the_fields_is_red_and_sounds() {
    let fields = [
        V::VehicleFaultLevel,
        V::VehicleControllerLevel,
        V::BatteryFaultLevel,
        V::VehicleBatteryLevel,
        V::MotorFaultLevel,
        V::InsulationLevel,
    ];
    for bits in 1..1 << fields.len() {
        let mut drive = healthy();
        for (bit, &field) in fields.iter().enumerate() {
            drive.keep(Node::Vcu, field, if bits >> bit & 1 != 0 { 3 } else { 2 });
        }
        drive.run(CYCLE);
        let view = drive.view();
        assert_eq!((view.severity, drive.sound()), (Stop, Some(Sound::Stop)), "{bits:06b}");
        let count = view.line.map(|line| u32::from(line.count));
        // The battery's own level and the copy of it are one fault.
        let doubled = bits & 0b1100 == 0b1100;
        let told = u32::count_ones(bits) - u32::from(doubled);
        assert_eq!(count, Some(told), "only the level 1 faults take turns");
    }
}

#[test]
fn jl_56_the_worse_of_two_levels_of_the_vehicle_controller_is_shown() {
    for own in 0..4 {
        for state in 0..4 {
            let mut drive = healthy();
            drive.keep(Node::Vcu, V::VehicleFaultLevel, own);
            drive.keep(Node::Vcu, V::VehicleControllerLevel, state);
            drive.run(CYCLE);
            assert_eq!(drive.view().severity, Severity::from_model(own.max(state)));
        }
    }
}

#[test]
fn every_alarm_bit_is_a_fault_of_its_own_with_its_own_stage() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryAlarms, 0b111 | i32::MIN);
    drive.run(CYCLE);
    let all = [
        ("Alarm 1", None, Warn),
        ("Alarm 2", None, Derate),
        ("Alarm 3", None, Stop),
        ("Alarm 32", None, Warn),
    ];
    assert_eq!(drive.faults(), all, "C5-15: stage 2 is worse than stage 1");
    assert_eq!(drive.view().line.map(|line| (line.text.en, line.code)), Some(("Alarm 3", None)));
    drive.keep(Node::Bms, V::BatteryAlarms, 0b010);
    drive.run(CYCLE);
    assert_eq!(drive.faults(), [("Alarm 2", None, Derate)]);
    drive.keep(Node::Bms, V::BatteryAlarms, 0);
    drive.run(CYCLE);
    assert_eq!(drive.faults(), []);
}

#[test]
fn an_alarm_bit_without_a_stage_is_as_bad_as_its_sender_s_level() {
    for (level, severity) in [(0, Warn), (1, Warn), (2, Derate), (3, Stop)] {
        let mut drive = healthy();
        drive.keep(Node::Bms, V::BatteryAlarms, 1);
        drive.keep(Node::Bms, V::BatteryFaultLevel, level);
        drive.run(CYCLE);
        assert!(drive.faults().contains(&("Alarm 1", None, severity)), "{:?}", drive.faults());
    }
}

#[test]
fn an_alarm_bit_without_a_text_still_says_whose_it_is() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryAlarms, 1 << 8);
    drive.keep(Node::Inverter, V::MotorAlarms, 1 << 8);
    drive.run(CYCLE);
    assert_eq!(drive.texts(), ["Battery fault", "Motor system fault"]);
}

#[test]
fn alarm_bits_that_fall_silent_keep_their_stop_faults_only() {
    let mut drive = healthy();
    drive.keep(Node::Inverter, V::BatteryAlarms, 0b111);
    drive.run(CYCLE);
    drive.hush(Node::Inverter);
    drive.run(TIMEOUT);
    assert_eq!(drive.texts(), ["Alarm 3"]);
}

#[test]
fn jl_24_a_smoke_bit_is_not_told_twice_where_each_detector_has_its_own() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatterySmoke, 1);
    drive.keep(Node::Bms, V::BatteryAlarms, 0b100);
    drive.run(CYCLE);
    assert_eq!(drive.texts(), ["Alarm 3"]);
}

#[test]
fn jl_23_either_report_of_a_low_supply_counts_and_silence_of_one_does_not_clear_the_other() {
    for (first, second, low) in [(0, 0, false), (0, 1, true), (1, 0, true), (1, 1, true)] {
        let mut drive = healthy();
        drive.keep(Node::Vcu, V::SupplyLow, first);
        drive.keep(Node::Inverter, V::VehicleSupplyLow, second);
        drive.run(CYCLE);
        assert_eq!(!drive.texts().is_empty(), low);
        drive.hush(Node::Inverter);
        drive.run(TIMEOUT);
        assert_eq!(!drive.texts().is_empty(), first == 1);
    }
}

#[test]
fn a_vehicle_with_levels_is_not_told_again_by_its_bit() {
    let pairs = [
        (V::VehicleFault, V::VehicleFaultLevel),
        (V::InsulationFault, V::InsulationLevel),
        (V::ChargerFault, V::ChargerFaultLevel),
        (V::DcdcFault, V::DcdcState),
        (V::BatteryFault, V::BatteryAlarms),
    ];
    for (bit, level) in pairs {
        let mut drive = healthy();
        drive.keep(Node::Vcu, bit, 1);
        drive.keep(Node::Vcu, level, 0);
        drive.run(CYCLE);
        assert_eq!(drive.texts(), [""; 0], "{}", bit.path());
    }
}

#[test]
fn sixty_alarms_at_once_keep_the_worst_and_end_with_their_causes() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryAlarms, -1);
    drive.keep(Node::Inverter, V::MotorAlarms, -1);
    drive.keep(Node::Vcu, V::VehicleFaultLevel, 3);
    drive.run(CYCLE);
    let stops = drive.faults().into_iter().filter(|fault| fault.2 == Stop).map(|fault| fault.0);
    assert_eq!(stops.collect::<Vec<_>>(), ["System fault level 3", "Alarm 3"]);
    drive.keep(Node::Bms, V::BatteryAlarms, 0);
    drive.keep(Node::Inverter, V::MotorAlarms, 0);
    drive.keep(Node::Vcu, V::VehicleFaultLevel, 0);
    drive.run(CYCLE);
    assert_eq!(drive.faults(), []);
}

#[test]
fn a_full_set_takes_a_worse_fault_for_a_mild_one_and_no_further_mild_one() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryAlarms, -1);
    drive.keep(Node::Inverter, V::MotorAlarms, -1);
    drive.run(CYCLE);
    let active = |drive: &Drive| -> Vec<_> {
        drive
            .cluster
            .active_faults(drive.last())
            .map(|fault| (fault.named, fault.severity, fault.first))
            .collect()
    };
    let full = active(&drive);
    drive.keep(Node::Vcu, V::BrakeAbsFault, 1);
    drive.run(1_000);
    assert_eq!(active(&drive), full, "the same faults since the same time: none gives way to its like");
    assert!(!drive.texts().contains(&"ABS fault"));
    drive.inputs.contacts.set(V::BodySmoke, true);
    drive.run(CYCLE);
    assert!(drive.faults().contains(&("Smoke alarm", None, Stop)));
    assert_eq!(active(&drive).len(), full.len(), "one made room");
    let stops = |faults: &[(_, Severity, _)]| faults.iter().filter(|fault| fault.1 == Stop).count();
    assert_eq!(stops(&active(&drive)), stops(&full) + 1, "and it was a mild one");
}

#[test]
fn codes_that_a_battery_rotates_at_one_level_stand_side_by_side() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryFaultLevel, 2);
    for code in [5, 6, 5, 6] {
        drive.keep(Node::Bms, V::BatteryFaultCode, code);
        drive.run(1_000);
    }
    let codes: Vec<_> = drive.faults().into_iter().map(|fault| fault.1).collect();
    assert_eq!(codes, [Some(5), Some(6)]);
}

/// One case of every fault that can be there beside every other: a level of each level.
fn independent() -> Vec<Case> {
    let all = cases();
    let mut rows = Vec::<Case>::new();
    for case in &all {
        let is_first = rows.last().is_none_or(|last| last.row.fault != case.row.fault);
        let is_told = case.route.unless_sent.is_none_or(|value| all.iter().all(|other| other.value != value));
        // The request for high voltage off has a clock of its own.
        if is_first && is_told && case.value != V::BatteryHvOffRequest {
            let level = 1 + (rows.len() as i32 + 1) % 3;
            let number = if case.route.when == When::Level(case.value) { level } else { case.number };
            rows.push(Case::of(case.row, case.route, case.value, number));
        }
    }
    assert_eq!(rows[0].value, V::VehicleFaultLevel);
    rows
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    /// Whatever fails together, in whatever order: all of it is active, the worst of it is shown, each line in turn.
    #[test]
    fn any_mixture_of_faults_is_active_and_only_its_worst_is_shown(
        phases in prop::collection::vec(prop::collection::vec(any::<bool>(), independent().len()), 1..4),
    ) {
        let rows = independent();
        let mut drive = healthy();
        for phase in phases {
            for (row, &on) in rows.iter().zip(&phase) {
                drive.keep(Node::Inverter, row.value, if on { row.number } else { 0 });
            }
            drive.run(CYCLE);
            let active: Vec<_> = rows.iter().zip(&phase).filter(|(_, on)| **on).map(|(row, _)| *row).collect();
            let own = active.iter().find(|row| row.value == V::VehicleFaultLevel);
            let own = own.map_or(Severity::None, |row| row.severity);
            // BUS-113: some grow with the vehicle controller's own report.
            let severity = |row: &Case| match row.route.grade {
                Grade::Joins(least) => least.max(own),
                _ => row.severity,
            };
            let stated: Vec<_> = active.iter().map(|row| (row.text, None, severity(row))).collect();
            let mut found = drive.faults();
            found.sort();
            let mut sorted = stated.clone();
            sorted.sort();
            prop_assert_eq!(found, sorted);
            let worst = stated.iter().map(|fault| fault.2).max().unwrap_or_default();
            prop_assert_eq!(drive.view().severity, worst);
            let worst_lines: Vec<_> = stated.iter().filter(|fault| fault.2 == worst).map(|fault| fault.0).collect();
            let mut shown = Vec::new();
            for _ in 0..worst_lines.len() {
                shown.extend(drive.view().line.map(|line| line.text.en));
                drive.run(1_000);
            }
            shown.sort_unstable();
            let mut stated = worst_lines.clone();
            stated.sort_unstable();
            prop_assert_eq!(shown, stated, "every line of the worst severity, once");
        }
    }
}
