//! What a filler byte says: nothing. Every byte of every message of the real tables, filled in turn.

use cluster::{Cluster, Inputs, Telltale};
use protocol_core::generated::{SHIPPED_VEHICLES, citybus};
use protocol_core::model::{Reading, Readings, Severity};
use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, Millis, Shown, Value};

/// Vehicles whose documents say what an unused byte is filled with: the other two say nothing, or 0.
fn filled() -> impl Iterator<Item = &'static Vehicle> {
    [&citybus::VEHICLE].into_iter()
}

/// A cluster of the vehicle past its bulb check.
fn cluster(vehicle: &'static Vehicle) -> Cluster {
    let mut cluster = Cluster::new(vehicle);
    for now in [0, 4_000] {
        cluster.tick(&Inputs::default(), Millis(now));
    }
    cluster
}

#[test]
fn bus_r008_no_byte_of_filler_lights_ready_asks_for_high_voltage_off_or_stops_the_vehicle() {
    let mut frames = 0;
    for vehicle in filled() {
        for message in vehicle.rx {
            // One byte, and from each byte to the end of the counted ones.
            for (from, to) in (0..8).flat_map(|byte| [(byte, byte + 1), (byte, 8)]) {
                for fill in [0xFF, 0xFE, 0x00] {
                    let mut data = [0; 8];
                    data[from..to].fill(fill);
                    let mut cluster = cluster(vehicle);
                    cluster.receive(&CanFrame::full(message.id, data), Millis(4_005));
                    cluster.tick(&Inputs::default(), Millis(4_010));
                    let view = cluster.view(Millis(4_010));
                    let case = format!("{} {fill:02X} in {from}..{to}", message.name);
                    assert!(!view.telltales.is_lit(Telltale::Ready), "{case}: READY");
                    assert_eq!(view.hv_off_s, None, "{case}: high voltage off");
                    assert!(view.severity < Severity::Stop, "{case}: {:?}", view.line);
                    frames += 1;
                }
            }
        }
    }
    assert!(frames > 800, "{frames}");
}

#[test]
fn bus_r008_a_message_of_filler_has_no_value_at_all() {
    for vehicle in filled() {
        for (index, message) in (0..).zip(vehicle.rx) {
            let mut readings = Readings::new();
            (vehicle.decode)(index, &[0xFF; 8], &mut readings);
            for value in Value::ALL.iter().copied() {
                if let Some((reading, _)) = readings.get(value) {
                    assert_eq!(reading, Reading::Invalid, "{}: {}", message.name, value.path());
                }
            }
        }
    }
}

#[test]
fn bus_r008_what_one_part_of_a_value_reports_stands_beside_filler_in_another() {
    // Insulation level 2 in byte 1, filler in byte 7, where two alarm bits say the same.
    let mut readings = Readings::new();
    let index = citybus::VEHICLE.index_of(citybus::id::INSULATION).expect("it is received");
    let mut decode = |data: [u8; 8]| {
        (citybus::VEHICLE.decode)(index, &data, &mut readings);
        readings.get(Value::InsulationLevel).map(|(reading, _)| reading)
    };
    assert_eq!(decode([2, 0, 0, 0, 0, 0, 0xFF, 0]), Some(Reading::Valid(3)));
    assert_eq!(decode([0, 0, 0, 0, 0, 0, 0xFF, 0]), Some(Reading::Invalid), "none of it is known to be well");
    assert_eq!(decode([0; 8]), Some(Reading::Valid(0)));
}

#[test]
fn a_ready_lamp_goes_out_when_its_byte_turns_to_filler() {
    let mut cluster = cluster(&citybus::VEHICLE);
    let mut see = |data: [u8; 8], now: u64| {
        cluster.receive(&CanFrame::full(citybus::id::VCU1, data), Millis(now));
        cluster.tick(&Inputs::default(), Millis(now));
        (
            cluster.view(Millis(now)).telltales.is_lit(Telltale::Ready),
            cluster.shown(Value::VehicleReady, Millis(now)),
        )
    };
    assert_eq!(see([7, 0, 0, 0, 0, 0, 0x80, 1], 4_020), (true, Shown::Value(1)));
    assert_eq!(see([7, 0, 0, 0, 0, 0, 0xFF, 2], 4_040), (false, Shown::Invalid));
}

#[test]
fn every_vehicle_that_is_not_filled_is_known() {
    let others: Vec<&str> = SHIPPED_VEHICLES
        .iter()
        .map(|vehicle| vehicle.name)
        .filter(|name| filled().all(|v| v.name != *name))
        .collect();
    assert_eq!(others, ["c5ev", "jiulong"]);
}
