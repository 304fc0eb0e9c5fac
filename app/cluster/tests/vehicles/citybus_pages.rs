//! What is on the document's pages beside the main screen: identifiers, scales, sub screens, frames that are not read.

use super::citybus::{AIR, BMS1, BMS5, DCDC, IPU3, PACK, STEERING, VCU7, started};
use crate::support::*;
use cluster::Received;
use protocol_core::generated::citybus::VEHICLE;
use protocol_core::generated::{c5ev, jiulong};
use protocol_core::model::{Severity, Shown, Value};
use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, CanId};

fn ids(vehicle: &'static Vehicle) -> impl Iterator<Item = CanId> {
    vehicle.rx.iter().map(|message| message.id).chain(vehicle.tx.iter().map(|message| message.id))
}

fn shown(ride: &Drive, value: Value) -> Shown<i32> {
    ride.cluster.shown(value, ride.now)
}

#[test]
fn bus_r004_bus_r007_jl_r008_every_identifier_has_29_bits_and_two_fixed_zeros() {
    for id in ids(&VEHICLE).chain(ids(&jiulong::VEHICLE)) {
        assert!(id.is_extended(), "{id}");
        assert_eq!(id.bits() >> 24 & 0b11, 0, "R and DP of {id}");
    }
}

#[test]
fn jl_r007_addresses_are_in_the_reserved_range_or_known_to_j1939() {
    // 0x28 the cluster as printed (JL-39), 0xF3 the battery.
    for id in ids(&jiulong::VEHICLE) {
        let address = id.bits() & 0xFF;
        assert!((208..=231).contains(&address) || [0x28, 0xF3].contains(&address), "{id}");
    }
}

#[test]
fn bus_r009_bus_r010_a_physical_value_is_raw_times_resolution_plus_offset_byte_1_first() {
    let mut ride = started();
    ride.hear(BMS1, PACK);
    // 0x1518 x 0.1 V; 0x2774 x 0.1 A - 1000 A; 0xBB x 0.4 %.
    assert_eq!(shown(&ride, Value::BatteryVoltage), Shown::Value(5_400));
    assert_eq!(shown(&ride, Value::BatteryCurrent), Shown::Value(100));
    assert_eq!(shown(&ride, Value::BatterySoc), Shown::Value(748));
}

#[test]
fn bus_r029_level_3_is_the_worst_of_the_vehicle() {
    let severities: Vec<_> =
        (0..4).map(|level| started().hear(VCU7, [level, 0, 0, 0, 0, 0, 0, 0]).severity).collect();
    assert_eq!(severities, [Severity::None, Severity::Warn, Severity::Derate, Severity::Stop]);
}

#[test]
fn bus_r032_a_contactor_fault_has_its_code_and_text() {
    let mut ride = started();
    ride.hear(VCU7, [2, 72, 0, 0, 0, 0, 0, 0]);
    let texts: Vec<_> =
        ride.cluster.active_faults(ride.last()).map(|fault| (fault.text.zh, fault.code)).collect();
    assert!(texts.contains(&("主正接触器故障", Some(72))), "{texts:?}");
}

#[test]
fn bus_r053_bus_r055_bus_r122_bus_r145_frames_of_separate_agreement_change_nothing() {
    // VCU9 (oil pump), VCU10 (contactors by CAN), low-voltage steering, on-board charger and its commands.
    for id in [0x18F1_05D0, 0x1801_A9EF, 0x0CF6_03A1, 0x18F1_F399, 0x18F1_99F3] {
        let mut ride = started();
        let frame = CanFrame::full(CanId::extended(id), [0x55; 8]);
        assert_eq!(ride.cluster.receive(&frame, ride.now), Received::Unknown, "{id:08X}");
    }
}

#[test]
fn bus_r031_bus_r155_contactor_feedback_is_read_only_by_configuration() {
    let mut ride = started();
    let frame = CanFrame::full(CanId::extended(0x1801_EFA9), [0x55; 8]);
    assert_eq!(ride.cluster.receive(&frame, ride.now), Received::Unknown, "BUS-60: no such box by default");
    assert_eq!(shown(&ride, Value::BoxMotor), Shown::Never);
}

#[test]
fn bus_r083_the_pantograph_byte_changes_nothing() {
    let views = [0, 1, 4, 0xFF].map(|pantograph| {
        let mut ride = started();
        ride.hear(BMS5, [0, 3, 1, 0, 0x55, pantograph, 1, 0xFF])
    });
    assert!(views.iter().all(|view| *view == views[0]));
}

#[test]
fn bus_r060_bus_r120_bus_r124_bus_r126_bus_r143_codes_are_numbers_for_the_sub_screen_without_any_fault_state()
{
    let codes = [
        (IPU3, [2, 77, 0, 0, 0, 0, 0, 0], Value::MotorFaultCode, 77),
        (STEERING, [0, 0, 0, 0, 0, 0, 1, 0x14], Value::SteeringFaultCode, 4),
        (DCDC, [0, 0, 0, 0, 0, 0, 1, 0x18], Value::DcdcFaultCode, 8),
        (AIR, [0, 0, 0, 0, 0, 0, 1, 0x1A], Value::CompressorFaultCode, 10),
        // 255 is filler (BUS-R008).
        (0x18F7_46E5, [0, 0, 0, 0, 0, 254, 0, 1], Value::InsulationFaultCode, 254),
    ];
    for (id, data, value, code) in codes {
        let mut ride = started();
        let view = ride.hear(id, data);
        assert_eq!(shown(&ride, value), Shown::Value(code), "{}", value.path());
        assert_eq!(view.line, None, "BUS-90: no text without the fault state");
    }
}

#[test]
fn bus_r067_the_battery_s_relay_states_are_there_for_a_page() {
    // BYTE8: bits 1-0 heater, 3-2 charge 2, 5-4 charge 1, 7-6 main; 00 open, 01 closed, 10 undefined, 11 welded.
    let relays = [
        (Value::ContactorHeater, 0),
        (Value::ContactorCharge2, 2),
        (Value::ContactorCharge1, 4),
        (Value::ContactorMain, 6),
    ];
    for (raw, state) in
        [(0b00, Shown::Value(0)), (0b01, Shown::Value(1)), (0b10, Shown::Invalid), (0b11, Shown::Value(2))]
    {
        for (relay, shift) in relays {
            let mut ride = started();
            let mut data = PACK;
            data[7] = raw << shift;
            ride.hear(BMS1, data);
            assert_eq!(shown(&ride, relay), state, "{} {raw:02b}", relay.path());
        }
    }
}

const HVAC: u32 = 0x18FF_C09E;

#[test]
fn bus_r134_the_communication_bit_of_the_air_conditioning_changes_nothing() {
    let [without, with] = [0, 0x80].map(|bit| started().hear(HVAC, [0, 0x20, 0, 64, 60, bit, 0, 1]));
    assert_eq!(without, with);
}

#[test]
fn bus_r135_bus_r137_bus_r138_the_bits_of_the_air_conditioning_say_what_it_does() {
    let what = [Value::HvacOn, Value::HvacCooling, Value::HvacHeating, Value::HvacDefrosting];
    // BYTE2 and BYTE3, then on, cooling, heating, defrosting; with none of the last three it ventilates.
    let bits = [
        ([0x00, 0x00], [0, 0, 0, 0]),
        ([0x20, 0x00], [1, 0, 0, 0]),
        ([0x20, 0x80], [1, 1, 0, 0]),
        ([0x20, 0x20], [1, 1, 0, 0]),
        ([0x20, 0x01], [1, 0, 1, 0]),
        ([0x20, 0x02], [1, 0, 0, 1]),
        ([0x20, 0x10], [1, 0, 0, 1]),
    ];
    for (bytes, states) in bits {
        let mut ride = started();
        ride.hear(HVAC, [0, bytes[0], bytes[1], 64, 60, 0, 0, 1]);
        assert_eq!(what.map(|value| shown(&ride, value)), states.map(Shown::Value), "{bytes:02X?}");
    }
}

#[test]
fn bus_r136_the_fan_runs_high_medium_or_low() {
    // BYTE2 bit 5 = on and low, bit 6 = medium, bit 7 = high; the faster bit wins.
    for (byte, speed) in
        [(0x00, 0), (0x20, 0), (0x40, 1), (0x60, 1), (0x80, 2), (0xA0, 2), (0xC0, 2), (0xE0, 2)]
    {
        let mut ride = started();
        ride.hear(HVAC, [0, byte, 0, 64, 60, 0, 0, 1]);
        assert_eq!(shown(&ride, Value::HvacFan), Shown::Value(speed), "{byte:02X}");
    }
}

#[test]
fn bus_r138_fresh_air_and_sterilising_each_have_a_bit() {
    for (byte, states) in [(0x00, [0, 0]), (0x04, [1, 0]), (0x08, [0, 1]), (0xF3, [0, 0])] {
        let mut ride = started();
        ride.hear(HVAC, [0, 0x20, byte, 64, 60, 0, 0, 1]);
        let what = [Value::HvacFreshAir, Value::HvacSterilising].map(|value| shown(&ride, value));
        assert_eq!(what, states.map(Shown::Value), "{byte:02X}");
    }
}

#[test]
fn c5_r002_the_cluster_sends_nothing_that_could_hold_a_reserved_field() {
    assert_eq!(c5ev::VEHICLE.tx.len(), 0);
}
