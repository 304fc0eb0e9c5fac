//! Only what is known is sent, on the real tables.

use cluster::{Cluster, Contacts, Inputs, Options};
use protocol_core::generated::{SHIPPED_VEHICLES, citybus, jiulong};
use protocol_core::model::Readings;
use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, CanId, Millis, Value};
use std::collections::BTreeMap;

/// Returns the last frame of each message that the cluster has sent after `ms` of these inputs.
fn sent(cluster: &mut Cluster, inputs: &Inputs, from: u64, ms: u64) -> BTreeMap<CanId, [u8; 8]> {
    let mut last = BTreeMap::new();
    for now in (from..from + ms).step_by(10).map(Millis) {
        cluster.tick(inputs, now);
        while let Some(frame) = cluster.transmit(now) {
            last.insert(frame.id, *frame.padded());
        }
    }
    last
}

/// The board's inputs with these contacts wired and closed.
fn board(wired: &[Value], closed: &[Value]) -> Inputs {
    let of = |values: &[Value]| Contacts::closed(values.iter().copied());
    Inputs { contacts: of(closed), unwired: of(wired).others(), ..Inputs::default() }
}

/// The contacts that this project's board has a pin for.
const WIRED: [Value; 8] = [
    Value::BodyDoorFront,
    Value::BodyDoorRear,
    Value::BodySeatEmpty,
    Value::BodyParkingBrake,
    Value::BodySmoke,
    Value::BodyTurnLeft,
    Value::BodyTurnRight,
    Value::BodyHazard,
];

#[test]
fn the_page_on_wiring_says_what_goes_out_when_nothing_is_known() {
    let page = include_str!("../../../../docs/wiring.md");
    let page = page.split_once("| message | bytes |\n| --- | --- |\n").expect("its table").1;
    let said: Vec<&str> = page.lines().take_while(|line| line.starts_with('|')).collect();
    let mut stated = Vec::new();
    for vehicle in SHIPPED_VEHICLES {
        for (index, message) in (0..).zip(vehicle.tx) {
            let bytes = (vehicle.encode)(index, &Readings::new()).map(|byte| format!("{byte:02X}"));
            stated.push(format!("| {} {} | {} |", vehicle.name, message.name, bytes.join(" ")));
        }
    }
    assert_eq!(said, stated);
}

#[test]
fn bus_r008_what_has_no_wire_goes_out_as_not_available() {
    let mut cluster = Cluster::new(&citybus::VEHICLE);
    let unwired = board(&[], Contacts::ALL);
    let frames = sent(&mut cluster, &unwired, 0, 3_000);
    let encode = |index| (citybus::VEHICLE.encode)(index, &Readings::new());
    for (index, message) in (0..).zip(citybus::VEHICLE.tx) {
        let (frame, unknown) = (frames[&message.id], encode(index));
        let life = message.life.map(|life| usize::from(life.byte));
        for byte in (0..8).filter(|byte| Some(*byte) != life) {
            assert_eq!(frame[byte], unknown[byte], "{} byte {}", message.name, byte + 1);
        }
    }
    // The same contacts with their wires are sent.
    let wired = Inputs { unwired: board(&WIRED, &[]).unwired, ..board(&WIRED, &WIRED) };
    let frames = sent(&mut cluster, &wired, 3_000, 3_000);
    assert_ne!(frames[&citybus::VEHICLE.tx[0].id], encode(0));
}

#[test]
fn bus_97_the_odometer_is_not_available_until_it_is_restored() {
    let mut cluster = Cluster::new(&citybus::VEHICLE);
    let meter2 = citybus::VEHICLE.tx.iter().find(|message| message.name == "Meter2").expect("it is sent").id;
    let vcu1 = |count| CanFrame::full(citybus::id::VCU1, [7, 0, 0, 50, 0, 0, 0, count]);
    let mut frames = BTreeMap::new();
    for step in 0..300 {
        cluster.receive(&vcu1(step as u8), Millis(step * 100));
        frames.extend(sent(&mut cluster, &Inputs::default(), step * 100, 100));
    }
    assert!(cluster.odometer_km8() > 0, "it has driven");
    assert_eq!(frames[&meter2][..4], [0xFF; 4]);
    cluster.restore(0x0001_2345);
    let frames = sent(&mut cluster, &Inputs::default(), 30_000, 2_000);
    assert_eq!(frames[&meter2][..4], 0x0001_2345_u32.to_le_bytes());
}

/// What jiulong's two upgrade messages say with the vehicle parked.
fn upgrade(options: Options) -> Vec<u8> {
    let vehicle: &Vehicle = &jiulong::VEHICLE;
    let mut cluster = Cluster::with_options(vehicle, options);
    for count in 0..20 {
        // VCU3 has no counter: it begins with the speed.
        for (id, first) in [(jiulong::id::VCU1, count), (jiulong::id::VCU2, count), (jiulong::id::VCU3, 0)] {
            let frame = CanFrame::full(id, [first, 0, 0, 0, 0, 0, 0, 0]);
            cluster.receive(&frame, Millis(u64::from(count) * 100));
        }
        sent(&mut cluster, &Inputs::default(), u64::from(count) * 100, 100);
    }
    let frames = sent(&mut cluster, &Inputs::default(), 2_000, 1_000);
    let is_upgrade = |name: &str| matches!(name, "Meter2" | "Meter3");
    vehicle
        .tx
        .iter()
        .filter(|message| is_upgrade(message.name))
        .map(|message| frames[&message.id][1])
        .collect()
}

#[test]
fn jl_36_a_remote_upgrade_takes_a_person_s_consent() {
    assert_eq!(upgrade(Options::NONE), [1, 1]);
    assert_eq!(upgrade(Options { may_upgrade: true, ..Options::NONE }), [0, 0]);
}
