//! Telltales: every condition lights its lamp alone, and nothing healthy is lit from stale data.

use crate::support::probe::*;
use crate::support::*;
use cluster::{Inputs, Telltale, Telltales};
use proptest::prelude::*;
use protocol_core::generated::VEHICLES;
use protocol_core::model::Value as V;
use protocol_core::vehicle::Node;
use protocol_core::{CanFrame, Millis};

/// Lamps that warn: silence keeps them as they last were (BUS-108).
const WARNINGS: &[Telltale] = &[
    Telltale::SystemFault,
    Telltale::BatteryFault,
    Telltale::MotorFault,
    Telltale::Insulation,
    Telltale::LowVoltage,
    Telltale::Steering,
    Telltale::Compressor,
    Telltale::AirPressure,
    Telltale::AntiLock,
    Telltale::BrakeForce,
];

const CONDITIONS: &[(V, i32, Telltale)] = &[
    (V::BodyTurnLeft, 1, Telltale::TurnLeft),
    (V::BodyTurnRight, 1, Telltale::TurnRight),
    (V::BodyLowBeam, 1, Telltale::LowBeam),
    (V::BodyHighBeam, 1, Telltale::HighBeam),
    (V::BodyFrontFog, 1, Telltale::FrontFog),
    (V::BodyRearFog, 1, Telltale::RearFog),
    (V::VehicleReady, 1, Telltale::Ready),
    (V::VehicleFault, 1, Telltale::SystemFault),
    (V::VehicleFaultLevel, 1, Telltale::SystemFault),
    (V::VehicleControllerLevel, 3, Telltale::SystemFault),
    (V::BatteryFaultLevel, 1, Telltale::BatteryFault),
    (V::VehicleBatteryLevel, 1, Telltale::BatteryFault),
    (V::BatteryFault, 1, Telltale::BatteryFault),
    (V::BatterySmoke, 1, Telltale::BatteryFault),
    (V::MotorFault, 1, Telltale::MotorFault),
    (V::MotorFaultLevel, 2, Telltale::MotorFault),
    (V::InsulationLevel, 1, Telltale::Insulation),
    (V::InsulationFault, 1, Telltale::Insulation),
    (V::VehiclePowerLimited, 1, Telltale::PowerLimited),
    (V::VehicleTorqueLimited, 1, Telltale::PowerLimited),
    (V::BatteryLow, 1, Telltale::LowCharge),
    (V::BatterySoc, 199, Telltale::LowCharge),
    (V::ContactorMain, 0, Telltale::BatteryCut),
    (V::ChargePlug, 1, Telltale::ChargePlug),
    (V::ChargeState, 1, Telltale::Charging),
    (V::DcdcState, 2, Telltale::LowVoltage),
    (V::DcdcFault, 1, Telltale::LowVoltage),
    (V::SupplyLow, 1, Telltale::LowVoltage),
    (V::VehicleSupplyLow, 1, Telltale::LowVoltage),
    (V::SteeringState, 2, Telltale::Steering),
    (V::CompressorState, 2, Telltale::Compressor),
    (V::CompressorFault, 1, Telltale::Compressor),
    (V::BodyParkingBrake, 1, Telltale::ParkingBrake),
    (V::BodyDoorMiddle, 1, Telltale::Door),
    (V::AirFront, 39, Telltale::AirPressure),
    (V::AirRear, 39, Telltale::AirPressure),
    (V::BrakeAbsFault, 1, Telltale::AntiLock),
    (V::BrakeEbdFault, 1, Telltale::BrakeForce),
];

#[test]
fn every_condition_lights_one_lamp_and_silence_keeps_only_what_warns() {
    for &(value, number, lamp) in CONDITIONS {
        let mut drive = healthy();
        drive.keep(Node::Inverter, value, number);
        drive.run(CYCLE);
        assert_eq!(drive.lit(), [lamp], "{} = {number}", value.path());
        drive.hush(Node::Inverter);
        drive.run(10_000);
        let kept: &[_] = if WARNINGS.contains(&lamp) { &[lamp] } else { &[] };
        assert_eq!(drive.lit(), kept, "{} = {number}, silent", value.path());
    }
}

#[test]
fn every_lamp_but_the_one_for_silence_has_a_condition_here() {
    for &lamp in Telltale::ALL.iter().filter(|&&lamp| lamp != Telltale::NoCommunication) {
        assert!(CONDITIONS.iter().any(|condition| condition.2 == lamp), "{lamp:?}");
    }
}

#[test]
fn c5_r012_a_lamp_that_the_vehicle_commands_follows_its_bit_and_nothing_else() {
    let commanded = [
        (V::BatteryLow, V::BatterySoc, 50, Telltale::LowCharge),
        (V::VehicleFault, V::VehicleFaultLevel, 3, Telltale::SystemFault),
    ];
    for (bit, reason, number, lamp) in commanded {
        let mut drive = healthy();
        drive.keep(Node::Bms, reason, number);
        for on in [0, 1, 0] {
            drive.keep(Node::Vcu, bit, on);
            drive.run(CYCLE);
            assert_eq!(drive.lit().contains(&lamp), on == 1, "{}", bit.path());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// For every vehicle, after any traffic: once all is silent, only warnings are lit, and none that was dark before.
    #[test]
    fn nothing_healthy_is_lit_from_stale_data(
        vehicle in 0..VEHICLES.len(),
        traffic in prop::collection::vec((0usize..64, any::<[u8; 8]>()), 1..150),
    ) {
        let vehicle = VEHICLES[vehicle];
        let mut cluster = cluster::Cluster::new(vehicle);
        let inputs = Inputs::default();
        let mut now = Millis(0);
        cluster.tick(&inputs, now);
        now = now.after(5_000);
        for (index, data) in traffic {
            let message = &vehicle.rx[index % vehicle.rx.len()];
            cluster.receive(&CanFrame::full(message.id, data), now);
            now = now.after(10);
            cluster.tick(&inputs, now);
        }
        let before = cluster.view(now).telltales;
        let longest = vehicle.rx.iter().map(|message| u64::from(message.timeout_ms)).max().unwrap_or(0);
        for _ in 0..=longest / 10 {
            now = now.after(10);
            cluster.tick(&inputs, now);
        }
        let after = cluster.view(now).telltales;
        for &lamp in Telltale::ALL {
            let may_be_lit = match lamp {
                Telltale::NoCommunication => true,
                _ => WARNINGS.contains(&lamp) && before.is_lit(lamp),
            };
            prop_assert!(may_be_lit || !after.is_lit(lamp), "{lamp:?} of {}", vehicle.name);
        }
    }
}

#[test]
fn air_pressure_lights_its_lamp_below_400_kpa_exactly() {
    for reservoir in [V::AirFront, V::AirRear] {
        let mut drive = healthy();
        for (pressure, is_low) in [(41, false), (40, false), (39, true), (40, false), (0, true), (41, false)]
        {
            drive.keep(Node::Vcu, reservoir, pressure);
            drive.run(CYCLE);
            assert_eq!(
                drive.lit().contains(&Telltale::AirPressure),
                is_low,
                "{} at {pressure}",
                reservoir.path()
            );
        }
    }
}

#[test]
fn each_lamp_is_set_and_read_alone() {
    let mut all = 0;
    for &lamp in Telltale::ALL {
        let mut some = Telltales::NONE;
        // Twice the same is the same.
        for lit in [true, true] {
            some.set(lamp, lit);
            let read: Vec<_> = Telltale::ALL.iter().filter(|&&other| some.is_lit(other)).collect();
            assert_eq!(read, [&lamp]);
        }
        assert_eq!(some.bits(), 1 << (lamp as u32), "bits go by the order of the lamps");
        all |= some.bits();
        let mut others = Telltales::ALL;
        for lit in [false, false] {
            others.set(lamp, lit);
            assert_eq!(others.bits() | some.bits(), Telltales::ALL.bits());
            assert!(!others.is_lit(lamp));
        }
    }
    assert_eq!(Telltales::ALL.bits(), all, "the bulb check lights every lamp, and nothing that is none");
}
