//! Telltales: which condition lights which, what silence does, and who is seen of two in one cell.

use crate::support::toy::*;
use crate::support::*;
use cluster::{Inputs, Place, Telltale, TelltaleColour, Telltales};
use protocol_core::Millis;
use protocol_core::Value;

fn lit(drive: &Drive) -> Vec<Telltale> {
    let telltales = drive.view().telltales;
    Telltale::ALL.iter().copied().filter(|&lamp| telltales.is_lit(lamp)).collect()
}

#[test]
fn all_lamps_are_lit_for_three_seconds_after_start() {
    for start in [0, 20, u64::from(u32::MAX)] {
        let mut drive = Drive::at(&TOY, Millis(start));
        assert_eq!(drive.cluster.view(Millis(start)).telltales, Telltales::ALL, "before the first tick");
        drive.run(TICK);
        assert_eq!(drive.cluster.view(Millis(start + 2_999)).telltales, Telltales::ALL);
        assert_eq!(drive.cluster.view(Millis(start + 3_000)).telltales, Telltales::NONE);
    }
}

#[test]
fn the_lamps_check_says_nothing_of_power_and_charge_and_hides_nothing_of_them() {
    let facts = |drive: &Drive| {
        let view = drive.view();
        assert_eq!(view.telltales, Telltales::ALL);
        (view.is_power_limited, view.is_charge_low)
    };
    let mut drive = Drive::of(&TOY);
    drive.run(1_000);
    assert_eq!(facts(&drive), (false, false));
    drive.repeat(DRIVE, [3, 0, 0, 0b0100, 0, 0, 0, 0]);
    drive.run(1_000);
    assert_eq!(facts(&drive), (true, false), "bus_r024");
    let mut low = PACK_WELL;
    low[4] = 20;
    drive.repeat(PACK, low);
    drive.run(500);
    assert_eq!(facts(&drive), (true, true), "bus_r096");
}

#[test]
fn of_two_in_one_cell_each_is_seen_for_half_a_second_in_turn_and_one_alone_all_the_time() {
    for &guest in Telltale::ALL {
        let Place::With(host) = guest.place() else { continue };
        let lit = |of: &[Telltale]| {
            let mut lit = Telltales::NONE;
            of.iter().for_each(|&telltale| lit.set(telltale, true));
            lit
        };
        assert_eq!(lit(&[guest, host]).in_turn(false), lit(&[host]), "{guest:?}");
        assert_eq!(lit(&[guest, host]).in_turn(true), lit(&[guest]), "{guest:?}");
        for turn in [false, true] {
            assert_eq!(lit(&[guest]).in_turn(turn), lit(&[guest]));
            assert_eq!(lit(&[host]).in_turn(turn), lit(&[host]));
        }
    }
    // Half a second is that of the view, and the check after start shows both.
    let mut drive = Drive::of(&TOY);
    let mut seen = [Telltales::NONE; 2];
    for _ in 0..100 {
        drive.run(TICK);
        let view = drive.view();
        seen[usize::from(view.heartbeat)] = view.telltales.in_turn(view.heartbeat);
    }
    assert_eq!(seen[0].bits() | seen[1].bits(), Telltales::ALL.bits());
    assert_ne!(seen[0], seen[1]);
}

#[test]
fn a_real_fault_during_the_bulb_check_stays_lit_after_it() {
    let mut drive = Drive::of(&TOY);
    drive.repeat(DRIVE, [3, 0, 0, 0b10, 0, 0, 0, 0]);
    drive.run(3_000 + TICK);
    assert_eq!(lit(&drive), [Telltale::SystemFault]);
}

#[test]
fn a_healthy_vehicle_shows_only_ready() {
    let mut drive = healthy();
    drive.run(10_000);
    assert_eq!(lit(&drive), [Telltale::Ready]);
}

#[test]
fn bus_r022_ready_follows_its_bit_and_is_green() {
    let mut drive = healthy();
    assert_eq!(Telltale::Ready.colour(), TelltaleColour::Green);
    drive.repeat(DRIVE, [3, 0, 0, 0, 0, 0, 0, 0]);
    drive.run(CYCLE);
    assert_eq!(lit(&drive), []);
}

#[test]
fn bus_r023_and_bus_111_the_system_fault_lamp_follows_its_bit_alone() {
    let mut drive = healthy();
    assert_eq!(Telltale::SystemFault.colour(), TelltaleColour::Red);
    drive.report(3, 4);
    drive.battery_report(3, 4);
    drive.run(CYCLE);
    assert!(!lit(&drive).contains(&Telltale::SystemFault));
    drive.repeat(DRIVE, [3, 0, 0, 0b11, 0, 0, 0, 0]);
    drive.run(CYCLE);
    assert!(lit(&drive).contains(&Telltale::SystemFault));
}

#[test]
fn bus_108_silence_keeps_what_warns_and_darkens_the_rest() {
    let mut drive = healthy();
    drive.repeat(DRIVE, [3, 0, 0, 0b1111, 0, 0, 0, 0]);
    drive.battery_report(1, 3);
    drive.repeat(MOTOR, [0, 0, 1, 0, 0, 0, 0, 0]);
    drive.run(CYCLE);
    use Telltale::{BatteryFault, MotorFault, NoCommunication, PowerLimited, Ready, SystemFault};
    assert_eq!(lit(&drive), [Ready, SystemFault, BatteryFault, MotorFault, PowerLimited]);
    for id in [DRIVE, PACK, MOTOR] {
        drive.stop(id);
    }
    drive.run(10_000);
    assert_eq!(lit(&drive), [SystemFault, BatteryFault, MotorFault, NoCommunication]);
    drive.gear_and_speed(3, 0);
    drive.battery_report(0, 0);
    drive.repeat(MOTOR, [0; 8]);
    drive.run(CYCLE);
    assert_eq!(lit(&drive), [Ready], "their sources take them back");
}

#[test]
fn silence_alone_lights_no_fault_lamp() {
    let mut drive = Drive::of(&TOY);
    drive.run(60_000);
    assert_eq!(lit(&drive), [Telltale::NoCommunication]);
}

#[test]
fn bus_r096_low_charge_has_its_hysteresis() {
    let mut drive = healthy();
    let mut charge = |raw: u8| {
        let mut data = PACK_WELL;
        data[4] = raw;
        drive.repeat(PACK, data);
        drive.run(CYCLE);
        lit(&drive).contains(&Telltale::LowCharge)
    };
    // 0.4 % per bit: 50 = 20.0 %, 55 = 22.0 %.
    let steps = [(56, false), (50, false), (49, true), (50, true), (55, true), (56, false), (51, false)];
    for (raw, expected) in steps {
        assert_eq!(charge(raw), expected, "{} %", f64::from(raw) * 0.4);
    }
    assert!(charge(10));
    assert!(!charge(0xFF), "an unknown charge is not a low one");
}

#[test]
fn an_open_main_contactor_lights_battery_cut() {
    let mut drive = healthy();
    let mut data = PACK_WELL;
    data[6] = 0;
    drive.repeat(PACK, data);
    drive.run(CYCLE);
    assert!(lit(&drive).contains(&Telltale::BatteryCut));
}

#[test]
fn every_own_wire_has_its_lamp() {
    type Wire = fn(&mut Inputs);
    let wires: &[(Wire, Telltale)] = &[
        (|i| i.contacts.set(Value::BodyTurnLeft, true), Telltale::TurnLeft),
        (|i| i.contacts.set(Value::BodyTurnRight, true), Telltale::TurnRight),
        (|i| i.contacts.set(Value::BodyLowBeam, true), Telltale::LowBeam),
        (|i| i.contacts.set(Value::BodyHighBeam, true), Telltale::HighBeam),
        (|i| i.contacts.set(Value::BodyFrontFog, true), Telltale::FrontFog),
        (|i| i.contacts.set(Value::BodyRearFog, true), Telltale::RearFog),
        (|i| i.contacts.set(Value::BodyParkingBrake, true), Telltale::ParkingBrake),
        (|i| i.contacts.set(Value::BodyDoorFront, true), Telltale::Door),
        (|i| i.contacts.set(Value::BodyDoorMiddle, true), Telltale::Door),
        (|i| i.contacts.set(Value::BodyDoorRear, true), Telltale::Door),
        (|i| i.contacts.set(Value::BodyDoorHatch, true), Telltale::Door),
        (|i| i.air_front_centimpa = Some(39), Telltale::AirPressure),
        (|i| i.air_rear_centimpa = Some(0), Telltale::AirPressure),
    ];
    for (n, (set, lamp)) in wires.iter().enumerate() {
        let mut drive = healthy();
        set(&mut drive.inputs);
        drive.run(TICK);
        assert!(lit(&drive).contains(lamp), "wire {n} lights {lamp:?}");
        assert_eq!(lit(&drive).len(), 2, "wire {n} lights one lamp beside READY");
        drive.inputs =
            Inputs { air_front_centimpa: Some(40), air_rear_centimpa: Some(40), ..Inputs::default() };
        drive.run(TICK);
        assert_eq!(lit(&drive), [Telltale::Ready], "wire {n} released");
    }
}

#[test]
fn bus_39_the_parking_brake_lamp_follows_the_own_wire() {
    let mut drive = healthy();
    drive.inputs.contacts.set(Value::BodyParkingBrake, true);
    for id in [DRIVE, PACK, FAULTS, MOTOR, PARTS] {
        drive.stop(id);
    }
    drive.run(10_000);
    assert!(lit(&drive).contains(&Telltale::ParkingBrake), "no bus is needed");
}
