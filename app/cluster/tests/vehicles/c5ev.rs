//! The cluster on C5EV's bus: one frame commands lamps and buzzer; the battery adds details. Bytes written by hand.

use crate::support::*;
use cluster::view::Plug;
use cluster::{Sound, Telltale};
use protocol_core::CanId;
use protocol_core::generated::c5ev::VEHICLE;
use protocol_core::model::{Gear, Severity, Shown};

fn id(name: &str) -> CanId {
    VEHICLE.rx.iter().find(|message| message.name == name).expect("in the table").id
}

/// A cluster after its bulb check, with the vehicle's word that all is well.
fn started() -> Drive {
    let mut ride = Drive::of(&VEHICLE);
    ride.repeat(id("VCUToCluster"), command(0, 0));
    ride.run(3_010);
    ride
}

/// English text and severity of all active faults.
fn texts(ride: &Drive) -> Vec<(&'static str, Severity)> {
    ride.faults().into_iter().map(|(text, _, severity)| (text, severity)).collect()
}

/// The cluster's frame: 10 %, standing, 0 kW, 320 V, 60 km, with two bytes of bits.
fn command(byte_6: u8, byte_7: u8) -> [u8; 8] {
    [20, 0, 50, 0x40, 0x01, 60, byte_6, byte_7]
}

#[test]
fn c5_r012_each_lamp_follows_its_bit_alone_and_at_once() {
    let lamps = [
        (0x04, 0, Telltale::Insulation),
        (0x08, 0, Telltale::BatteryFault),
        (0x10, 0, Telltale::MotorFault),
        (0x20, 0, Telltale::Ready),
        (0x40, 0, Telltale::SystemFault),
        (0x80, 0, Telltale::Charging),
        (0, 0x01, Telltale::BrakeForce),
        (0, 0x02, Telltale::AntiLock),
        (0, 0x04, Telltale::PowerLimited),
        (0, 0x08, Telltale::ChargePlug),
        (0, 0x20, Telltale::LowCharge),
    ];
    for (byte_6, byte_7, lamp) in lamps {
        let mut ride = started();
        assert_eq!(ride.lit(), [], "C5-34: 10 % of charge alone lights nothing");
        ride.repeat(id("VCUToCluster"), command(byte_6, byte_7));
        ride.run(100);
        assert_eq!(ride.lit(), [lamp], "{byte_6:02X} {byte_7:02X}");
        ride.repeat(id("VCUToCluster"), command(0, 0));
        ride.run(100);
        assert_eq!(ride.lit(), []);
    }
}

#[test]
fn c5_r013_the_buzzer_follows_bit_6_of_byte_7_with_a_guard_of_two_minutes() {
    let mut ride = started();
    ride.repeat(id("VCUToCluster"), command(0, 0x40));
    ride.run(10_000);
    assert_eq!(ride.sound(), Some(Sound::Buzzer));
    ride.run(120_000);
    assert_eq!(ride.sound(), None, "C5-R014, C5-20");
    ride.repeat(id("VCUToCluster"), command(0, 0));
    ride.run(100);
    ride.repeat(id("VCUToCluster"), command(0, 0x40));
    ride.run(100);
    assert_eq!(ride.sound(), Some(Sound::Buzzer));
}

#[test]
fn c5_15_the_second_stage_of_an_alarm_is_worse_than_the_first() {
    let stages = [
        ([1, 0, 0, 0], "Cell overvoltage 1", Severity::Warn),
        ([0, 1, 0, 0], "Cell overvoltage 2", Severity::Derate),
        ([0, 0, 0x10, 0], "Insulation 1", Severity::Warn),
        ([0, 0, 0, 0x10], "Insulation 2", Severity::Derate),
    ];
    for (bytes, text, severity) in stages {
        let mut ride = started();
        let mut data = [0, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF];
        data[..4].copy_from_slice(&bytes);
        ride.repeat(id("BMSD"), data);
        ride.run(100);
        assert_eq!(texts(&ride), [(text, severity)]);
    }
}

#[test]
fn c5_r003_what_the_cluster_s_own_frame_says_is_shown() {
    let mut ride = started();
    ride.repeat(id("VCUToCluster"), [150, 50, 80, 0x40, 0x01, 60, 0, 0]);
    ride.run(100);
    let view = ride.view();
    assert_eq!((view.speed_kmh, view.soc_percent), (Shown::Value(50), Shown::Value(75)));
    assert_eq!(view.pack_decivolts, Shown::Value(3_200));
    assert_eq!(view.power_hectowatts, Shown::Value(300), "the motor's own, 80 - 50 kW");
    assert_eq!(view.range.map(|range| range.km), Shown::Value(60));
    assert_ne!(view.gear, Some(Gear::P), "the frame has D, R and N only");
}

#[test]
fn c5_r005_a_charger_that_falls_silent_is_told_after_five_seconds() {
    let mut ride = started();
    ride.repeat(id("VCUToCluster"), command(0x80, 0x08));
    ride.repeat(id("ChargerTx"), [0x10, 0x0E, 0x64, 0, 0, 0, 0, 0]);
    ride.run(1_000);
    let charging = ride.view().charging.expect("plugged in");
    assert_eq!((charging.plug, charging.deciamps), (Plug::Charging, Shown::Value(100)));
    ride.stop(id("ChargerTx"));
    ride.run(4_990);
    assert_eq!(texts(&ride), []);
    ride.run(10);
    assert_eq!(texts(&ride), [("Charger lost: charging ends", Severity::Warn)], "C5-41");
}

#[test]
fn silence_of_the_cluster_s_frame_darkens_the_healthy_and_keeps_the_warnings() {
    let mut ride = started();
    ride.repeat(id("VCUToCluster"), command(0x28, 0x20));
    ride.run(100);
    assert_eq!(ride.lit(), [Telltale::Ready, Telltale::BatteryFault, Telltale::LowCharge]);
    ride.stop(id("VCUToCluster"));
    ride.run(10_000);
    assert_eq!(ride.lit(), [Telltale::BatteryFault, Telltale::NoCommunication]);
}
