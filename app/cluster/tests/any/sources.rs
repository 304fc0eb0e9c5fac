//! Every source of faults: when it is on the line, how bad it is, whether it sounds.

use crate::probe::*;
use cluster::Sound;
use proptest::prelude::*;
use protocol_core::Severity::{self, Derate, Stop, Warn};
use protocol_core::model::Value as V;
use protocol_core::vehicle::Node;

/// Value and number that make the fault, its text, its severity, whether it sounds.
type Source = (V, i32, &'static str, Severity, bool);

const SOURCES: &[Source] = &[
    (V::VehicleFaultLevel, 2, "System fault level 2", Derate, true),
    (V::VehicleControllerLevel, 3, "Vehicle controller fault", Stop, true),
    (V::VehicleFault, 1, "System fault", Warn, false),
    (V::VehicleShiftFailed, 1, "Gear not engaged", Warn, true),
    (V::BatteryHvOffRequest, 1, "Battery asks for HV off: stop", Stop, true),
    (V::BatteryFaultLevel, 1, "Battery fault level 1", Warn, true),
    (V::VehicleBatteryLevel, 1, "Battery fault level 1", Warn, true),
    (V::BatterySmoke, 1, "Smoke in the battery", Stop, true),
    (V::BatteryFault, 1, "Battery fault", Warn, false),
    (V::MotorFaultLevel, 3, "Motor system fault", Stop, true),
    (V::MotorFault, 1, "Motor controller fault", Warn, false),
    (V::InsulationLevel, 3, "Insulation fault", Stop, true),
    (V::InsulationFault, 1, "Insulation fault", Warn, false),
    (V::InsulationDeviceFault, 1, "Insulation monitor fault", Warn, false),
    (V::SteeringState, 2, "Steering assistance fault", Warn, false),
    (V::DcdcState, 2, "DC/DC converter fault", Warn, false),
    (V::DcdcFault, 1, "DC/DC converter fault", Warn, false),
    (V::CompressorState, 2, "Air compressor fault", Warn, false),
    (V::CompressorFault, 1, "Air compressor fault", Warn, false),
    (V::CompressorHot, 1, "Air compressor hot", Warn, false),
    (V::BrakeVacuumFault, 1, "Brake vacuum fault", Derate, true),
    (V::BrakeEbdFault, 1, "EBD fault", Warn, true),
    (V::BrakeAbsFault, 1, "ABS fault", Warn, false),
    (V::CoolingPumpFault, 1, "Cooling fault", Warn, false),
    (V::CoolingFanFault, 1, "Cooling fault", Warn, false),
    (V::SupplyLow, 1, "Low-voltage supply low", Warn, false),
    (V::VehicleSupplyLow, 1, "Low-voltage supply low", Warn, false),
    (V::ChargerFaultLevel, 2, "Charger fault", Derate, true),
    (V::ChargerFault, 1, "Charger fault", Warn, false),
    (V::HvacFault, 1, "Air conditioning fault", Warn, false),
    (V::VehicleMode, 5, "Limp mode", Derate, true),
    (V::VehiclePowerLimited, 1, "Power limited", Severity::None, false),
    (V::VehicleTorqueLimited, 1, "Torque limited", Severity::None, false),
];

#[test]
fn every_source_has_its_text_its_severity_and_its_sound_and_ends_with_its_cause() {
    for &(value, number, text, severity, sounds) in SOURCES {
        let mut drive = Drive::new();
        drive.keep(Node::Inverter, value, number);
        drive.run(CYCLE);
        assert_eq!(drive.faults(), [(text, None, severity)], "{}", value.path());
        assert_eq!(drive.view().line.map(|line| line.text.en), Some(text));
        assert_eq!(drive.sound().is_some(), sounds, "{}", value.path());
        drive.keep(Node::Inverter, value, 0);
        drive.run(CYCLE);
        assert_eq!(drive.faults(), [], "{}", value.path());
    }
}

#[test]
fn silence_of_its_sender_keeps_a_stop_fault_and_takes_the_others() {
    // The request for high voltage off has a clock of its own.
    for &(value, number, text, severity, _) in SOURCES.iter().filter(|row| row.0 != V::BatteryHvOffRequest) {
        let mut drive = Drive::new();
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
    for &(value, ..) in SOURCES {
        let mut drive = Drive::new();
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
        let mut drive = Drive::new();
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
            let mut drive = Drive::new();
            drive.keep(Node::Vcu, V::VehicleFaultLevel, own);
            drive.keep(Node::Vcu, V::VehicleControllerLevel, state);
            drive.run(CYCLE);
            assert_eq!(drive.view().severity, Severity::from_model(own.max(state)));
        }
    }
}

#[test]
fn every_alarm_bit_is_a_fault_of_its_own_with_its_own_stage() {
    let mut drive = Drive::new();
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
        let mut drive = Drive::new();
        drive.keep(Node::Bms, V::BatteryAlarms, 1);
        drive.keep(Node::Bms, V::BatteryFaultLevel, level);
        drive.run(CYCLE);
        assert!(drive.faults().contains(&("Alarm 1", None, severity)), "{:?}", drive.faults());
    }
}

#[test]
fn an_alarm_bit_without_a_text_still_says_whose_it_is() {
    let mut drive = Drive::new();
    drive.keep(Node::Bms, V::BatteryAlarms, 1 << 8);
    drive.keep(Node::Inverter, V::MotorAlarms, 1 << 8);
    drive.run(CYCLE);
    assert_eq!(drive.texts(), ["Battery fault", "Motor system fault"]);
}

#[test]
fn alarm_bits_that_fall_silent_keep_their_stop_faults_only() {
    let mut drive = Drive::new();
    drive.keep(Node::Inverter, V::BatteryAlarms, 0b111);
    drive.run(CYCLE);
    drive.hush(Node::Inverter);
    drive.run(TIMEOUT);
    assert_eq!(drive.texts(), ["Alarm 3"]);
}

#[test]
fn jl_24_a_smoke_bit_is_not_told_twice_where_each_detector_has_its_own() {
    let mut drive = Drive::new();
    drive.keep(Node::Bms, V::BatterySmoke, 1);
    drive.keep(Node::Bms, V::BatteryAlarms, 0b100);
    drive.run(CYCLE);
    assert_eq!(drive.texts(), ["Alarm 3"]);
}

#[test]
fn jl_23_either_report_of_a_low_supply_counts_and_silence_of_one_does_not_clear_the_other() {
    for (first, second, low) in [(0, 0, false), (0, 1, true), (1, 0, true), (1, 1, true)] {
        let mut drive = Drive::new();
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
        let mut drive = Drive::new();
        drive.keep(Node::Vcu, bit, 1);
        drive.keep(Node::Vcu, level, 0);
        drive.run(CYCLE);
        assert_eq!(drive.texts(), [""; 0], "{}", bit.path());
    }
}

#[test]
fn sixty_alarms_at_once_keep_the_worst_and_end_with_their_causes() {
    let mut drive = Drive::new();
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
    let mut drive = Drive::new();
    drive.keep(Node::Bms, V::BatteryAlarms, -1);
    drive.keep(Node::Inverter, V::MotorAlarms, -1);
    drive.run(CYCLE);
    let active = |drive: &Drive| -> Vec<_> {
        drive
            .cluster
            .active_faults(drive.at())
            .map(|fault| (fault.source, fault.severity, fault.first))
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
    let mut drive = Drive::new();
    drive.keep(Node::Bms, V::BatteryFaultLevel, 2);
    for code in [5, 6, 5, 6] {
        drive.keep(Node::Bms, V::BatteryFaultCode, code);
        drive.run(1_000);
    }
    let codes: Vec<_> = drive.faults().into_iter().map(|fault| fault.1).collect();
    assert_eq!(codes, [Some(5), Some(6)]);
}

/// Sources whose severity grows with the vehicle controller's own report (BUS-113).
const JOINED: &[V] = &[
    V::MotorFault,
    V::SteeringState,
    V::DcdcState,
    V::CompressorState,
    V::VehiclePowerLimited,
    V::VehicleTorqueLimited,
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    /// Whatever fails together, in whatever order: all of it is active, the worst of it is shown, each line in turn.
    #[test]
    fn any_mixture_of_sources_is_active_and_only_its_worst_is_shown(
        phases in prop::collection::vec(prop::collection::vec(any::<bool>(), SOURCES.len()), 1..4),
    ) {
        // Told by one of two values only, or with a clock of its own: tested one by one.
        let doubled = [
            V::VehicleFault, V::InsulationFault, V::ChargerFault, V::DcdcFault, V::CompressorFault,
            V::CoolingFanFault, V::VehicleSupplyLow, V::BatteryHvOffRequest, V::VehicleBatteryLevel,
        ];
        let rows: Vec<_> = SOURCES.iter().filter(|row| !doubled.contains(&row.0)).collect();
        let mut drive = Drive::new();
        for phase in phases {
            for (row, &on) in rows.iter().zip(&phase) {
                drive.keep(Node::Inverter, row.0, if on { row.1 } else { 0 });
            }
            drive.run(CYCLE);
            let active: Vec<_> = rows.iter().zip(&phase).filter(|(_, on)| **on).map(|(row, _)| **row).collect();
            let own = if active.iter().any(|row| row.0 == V::VehicleFaultLevel) { Derate } else { Severity::None };
            let severity = |row: &Source| if JOINED.contains(&row.0) { row.3.max(own) } else { row.3 };
            let stated: Vec<_> = active.iter().map(|row| (row.2, None, severity(row))).collect();
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
