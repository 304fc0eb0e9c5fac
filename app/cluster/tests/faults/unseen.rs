//! What came and went before anybody acknowledged it; fire that was acknowledged.

use crate::support::probe::*;
use crate::support::*;
use cluster::faults::{Grade, ROWS, Route, Row, When};
use cluster::view::Line;
use cluster::{Button, FaultId, Sound};
use protocol_core::Severity::{self, Derate, Stop, Warn};
use protocol_core::model::Value as V;
use protocol_core::vehicle::Node;

/// Every row and value that can be made by one number, with its severity.
fn cases() -> Vec<(&'static Row, V, i32, Severity)> {
    let mut cases = Vec::new();
    for row in ROWS {
        for Route { when, grade, .. } in row.routes {
            let (value, numbers) = match when {
                When::Level(value) => (*value, vec![1, 2, 3]),
                When::Is(value, number) if !value.path().starts_with("cluster.") => (*value, vec![*number]),
                When::AnyIs(values, number) => (values[0], vec![*number]),
                _ => continue,
            };
            for number in numbers {
                let severity = match grade {
                    Grade::Level(_) => Severity::from_model(number),
                    Grade::Always(severity) | Grade::Joins(severity) => *severity,
                    Grade::Alarm(_) => continue,
                };
                cases.push((row, value, number, severity));
            }
        }
    }
    cases
}

fn unseen(drive: &Drive) -> Option<(FaultId, Severity)> {
    drive.view().unseen.map(|line| (line.named.fault, line.severity))
}

#[test]
fn a_stop_or_derate_that_came_and_went_is_said_until_it_is_acknowledged_and_nothing_milder() {
    let mut told = 0;
    for (row, value, number, severity) in cases() {
        let mut drive = healthy();
        drive.keep(Node::Inverter, value, number);
        drive.run(CYCLE);
        let path = value.path();
        assert_eq!(unseen(&drive), None, "{path}: it is there, not over");
        drive.keep(Node::Inverter, value, 0);
        drive.run(CYCLE);
        assert_eq!(drive.faults(), [], "{path}");
        let expected = (severity >= Derate).then_some((row.fault, severity));
        assert_eq!(unseen(&drive), expected, "{path} {number}");
        assert_eq!((drive.view().line, drive.sound()), (None, None), "{path}: it is over");
        assert_eq!(drive.view().says_unseen, expected.is_some());
        told += usize::from(expected.is_some());
        drive.run(60_000);
        assert_eq!(unseen(&drive), expected, "{path}: for as long as nobody has seen it");
        let page = drive.view().page;
        drive.cluster.press(Button::Next, drive.now);
        drive.run(TICK);
        assert_eq!(unseen(&drive), None, "{path}: acknowledged");
        assert_eq!(
            drive.view().page == page,
            expected.is_some(),
            "{path}: the push acknowledged, or turned the page"
        );
    }
    assert!(told > 10, "only {told} of them are STOP or DERATE");
}

#[test]
fn acknowledged_while_it_was_there_it_is_over_when_it_ends() {
    let mut drive = healthy();
    drive.keep(Node::Inverter, V::BodySmoke, 1);
    drive.run(CYCLE);
    drive.cluster.press(Button::Next, drive.now);
    drive.keep(Node::Inverter, V::BodySmoke, 0);
    drive.run(CYCLE);
    assert_eq!(unseen(&drive), None);
}

#[test]
fn what_is_back_is_there_and_not_over() {
    let mut drive = healthy();
    for there in [1, 0, 1, 0] {
        drive.keep(Node::Inverter, V::BodySmoke, there);
        drive.run(CYCLE);
        assert_eq!(unseen(&drive).is_some(), there == 0);
    }
}

/// Returns what stands in the place of the line in each of the next seconds.
fn said(drive: &mut Drive, seconds: u64) -> Vec<(Option<FaultId>, bool)> {
    let mut all = Vec::new();
    for _ in 0..seconds {
        drive.run(1_000);
        let view = drive.view();
        let line: Option<Line> = if view.says_unseen { view.unseen } else { view.line };
        all.push((line.map(|line| line.named.fault), view.says_unseen));
    }
    all
}

#[test]
fn it_takes_turns_with_a_milder_line_and_never_hides_one_as_bad() {
    for (milder, is_said) in [(Warn, true), (Derate, true), (Stop, false)] {
        let mut drive = healthy();
        drive.keep(Node::Inverter, V::BodySmoke, 1);
        drive.run(CYCLE);
        drive.keep(Node::Inverter, V::BodySmoke, 0);
        drive.keep(Node::Inverter, V::MotorFaultLevel, milder as i32);
        drive.run(CYCLE);
        let all = said(&mut drive, 8);
        let over = all.iter().filter(|(fault, is_over)| *is_over && *fault == Some(FaultId::Smoke)).count();
        let there = all.iter().filter(|(fault, is_over)| !is_over && *fault == Some(FaultId::Motor)).count();
        assert_eq!((over, there), if is_said { (4, 4) } else { (0, 8) }, "{milder:?}");
        assert_eq!(unseen(&drive), Some((FaultId::Smoke, Stop)), "it waits");
    }
}

#[test]
fn several_take_turns_the_worst_of_them() {
    let mut drive = healthy();
    for value in [V::BodySmoke, V::BatterySmoke, V::BrakeVacuumFault] {
        drive.keep(Node::Inverter, value, 1);
    }
    drive.run(CYCLE);
    for value in [V::BodySmoke, V::BatterySmoke, V::BrakeVacuumFault] {
        drive.keep(Node::Inverter, value, 0);
    }
    drive.run(CYCLE);
    let all = said(&mut drive, 8);
    let of = |wanted| all.iter().filter(|(fault, _)| *fault == Some(wanted)).count();
    assert_eq!((of(FaultId::Smoke), of(FaultId::BatterySmoke), of(FaultId::BrakeVacuum)), (4, 4, 0));
    drive.keep(Node::Inverter, V::MotorFaultLevel, 1);
    drive.run(CYCLE);
    let all = said(&mut drive, 8);
    let of = |wanted| all.iter().filter(|(fault, _)| *fault == Some(wanted)).count();
    assert_eq!(
        (of(FaultId::Smoke), of(FaultId::BatterySmoke), of(FaultId::Motor)),
        (2, 2, 4),
        "beside a milder one"
    );
    assert_eq!(drive.view().unseen.map(|line| line.count), Some(2));
}

#[test]
fn a_lower_level_of_the_same_route_is_the_same_fault() {
    let mut drive = healthy();
    drive.keep(Node::Inverter, V::MotorFaultLevel, 3);
    drive.run(CYCLE);
    drive.keep(Node::Inverter, V::MotorFaultLevel, 1);
    drive.run(CYCLE);
    // The level without a code is one fault that has become milder; nothing of it is over.
    assert_eq!(drive.faults().len(), 1);
}

#[test]
fn bus_r079_an_acknowledged_fire_sounds_again_after_thirty_seconds_for_ever() {
    use crate::support::toy;
    let mut drive = toy::healthy();
    drive.report(3, 24);
    drive.run(CYCLE);
    for _ in 0..3 {
        assert_eq!(drive.sound(), Some(Sound::Fire));
        let since = drive.now;
        drive.cluster.press(Button::Next, since);
        drive.run(TICK);
        while drive.sound().is_none() {
            assert_eq!(
                drive.view().line.map(|line| line.named.fault),
                Some(FaultId::Fire),
                "it is still said"
            );
            drive.run(TICK);
        }
        assert_eq!(drive.sound(), Some(Sound::Fire));
        assert!(
            (30_000..=30_000 + 2 * TICK).contains(&drive.now.since(since)),
            "{:?}",
            drive.now.since(since)
        );
    }
}

#[test]
fn a_stop_takes_the_main_page_over_until_it_is_acknowledged_and_nothing_milder_does() {
    for (row, value, number, severity) in cases() {
        let mut drive = healthy();
        drive.keep(Node::Inverter, value, number);
        drive.run(CYCLE);
        let alarm = |drive: &Drive| drive.view().alarm.map(|line| line.named.fault);
        let sounds = drive.sound().is_some();
        let expected = (severity == Stop && sounds).then_some(row.fault);
        assert_eq!(alarm(&drive), expected, "{} {number}", value.path());
        drive.run(10_000);
        assert_eq!(alarm(&drive), expected, "{}: for as long as nobody acknowledges it", value.path());
        drive.cluster.press(Button::Next, drive.now);
        drive.run(TICK);
        assert_eq!(alarm(&drive), None, "{}: acknowledged it leaves the line", value.path());
        if sounds {
            assert!(drive.view().line.is_some(), "{}", value.path());
        }
    }
}

#[test]
fn of_more_than_there_is_room_for_the_milder_and_the_older_are_left_out() {
    // In the order of their turns, in which they end; the brake vacuum is a DERATE.
    let all = [
        (V::VehicleFaultLevel, 3),
        (V::VehicleControllerLevel, 3),
        (V::BatteryFaultLevel, 3),
        (V::BatterySmoke, 1),
        (V::MotorFaultLevel, 3),
        (V::InsulationLevel, 3),
        (V::BodySmoke, 1),
        // As bad as what the vehicle reports.
        (V::SteeringState, 2),
        (V::BrakeVacuumFault, 1),
        (V::ChargerFaultLevel, 3),
    ];
    let mut drive = healthy();
    all.iter().for_each(|(value, number)| drive.keep(Node::Inverter, *value, *number));
    drive.run(CYCLE);
    all.iter().for_each(|(value, _)| drive.keep(Node::Inverter, *value, 0));
    drive.run(CYCLE);
    assert_eq!(drive.faults(), []);
    let mut told: Vec<FaultId> = said(&mut drive, 20).into_iter().filter_map(|(fault, _)| fault).collect();
    told.sort_unstable();
    told.dedup();
    assert_eq!(told.len(), 8, "{told:?}");
    assert!(!told.contains(&FaultId::VehicleLevel), "the oldest made room");
    assert!(told.contains(&FaultId::Charger) && !told.contains(&FaultId::BrakeVacuum), "{told:?}");
}

#[test]
fn bus_r119_bus_r123_bus_r125_what_is_milder_is_said_below_a_stop_without_a_button() {
    let parts = [
        (V::SteeringState, FaultId::Steering),
        (V::DcdcState, FaultId::Dcdc),
        (V::CompressorState, FaultId::Compressor),
        (V::MotorFault, FaultId::Inverter),
    ];
    let mut drive = healthy();
    for (value, _) in parts {
        drive.keep(Node::Inverter, value, if value == V::MotorFault { 1 } else { 2 });
    }
    drive.run(CYCLE);
    assert_eq!(drive.view().below, None, "nothing is above them");
    drive.keep(Node::Inverter, V::BodySmoke, 1);
    for is_acknowledged in [false, true] {
        drive.run(CYCLE);
        if is_acknowledged {
            drive.cluster.press(Button::Next, drive.now);
        }
        let mut told = Vec::new();
        let mut seconds = [0; 2];
        for _ in 0..160 {
            drive.run(100);
            let view = drive.view();
            assert_eq!(view.line.map(|line| line.named.fault), Some(FaultId::Smoke), "the STOP has its line");
            assert_eq!(view.alarm.is_some(), !is_acknowledged);
            let below = view.below.expect("four are milder");
            assert_eq!((below.severity, below.count), (Warn, 4));
            told.push(below.named.fault);
            seconds[usize::from(view.says_below)] += 1;
        }
        told.sort_unstable();
        told.dedup();
        let mut expected: Vec<FaultId> = parts.iter().map(|(_, fault)| *fault).collect();
        expected.sort_unstable();
        assert_eq!(told, expected, "each has its turn within 16 s");
        assert_eq!(seconds, [120, 40], "where there is one place the STOP has three seconds of four");
    }
    drive.keep(Node::Inverter, V::BodySmoke, 0);
    drive.run(CYCLE);
    assert_eq!(drive.view().below, None);
}
