//! What every vehicle inherits: the contract between its tables and the cluster.

use cluster::{Cluster, FaultId, Inputs, Received};
use proptest::prelude::*;
use protocol_core::generated::VEHICLES;
use protocol_core::model::{Readings, Shown, Value};
use protocol_core::{CanFrame, Millis, RxMessage, Vehicle};

/// Values that come from a bus, not from the cluster's own wires and decisions.
fn from_the_bus() -> impl Iterator<Item = Value> {
    let mut own = Cluster::new(VEHICLES[0]);
    own.tick(&Inputs::default(), Millis(0));
    Value::ALL.iter().copied().filter(move |&value| own.shown(value, Millis(0)) == Shown::Never)
}

fn known(cluster: &Cluster, now: Millis) -> Vec<Value> {
    from_the_bus().filter(|&value| cluster.shown(value, now).value().is_some()).collect()
}

/// A frame with all bytes `byte` but for a right check byte.
fn frame(message: &RxMessage, byte: u8) -> CanFrame {
    sealed(message, [byte; 8])
}

fn sealed(message: &RxMessage, mut data: [u8; 8]) -> CanFrame {
    if let Some(checksum) = message.checksum {
        checksum.seal(&mut data);
    }
    CanFrame::full(message.id, data)
}

/// Receives every message of `vehicle` once, all bytes `byte`.
fn receive_all(cluster: &mut Cluster, vehicle: &Vehicle, byte: u8, now: Millis) {
    for message in vehicle.rx {
        cluster.receive(&frame(message, byte), now);
    }
}

#[test]
fn the_receive_table_is_sorted_and_its_rows_make_sense() {
    for vehicle in VEHICLES {
        assert!(vehicle.rx.is_sorted_by(|a, b| a.id < b.id), "{}", vehicle.name);
        assert!(vehicle.faults.is_sorted_by_key(|fault| (fault.source, fault.code)), "{}", vehicle.name);
        for message in vehicle.rx {
            assert!(message.timeout_ms >= 500, "BUS-108: {} of {}", message.name, vehicle.name);
            assert!(message.len <= 8 && message.life.is_none_or(|life| life.byte < message.len));
        }
    }
}

#[test]
fn every_message_brings_values_and_a_short_frame_none() {
    for vehicle in VEHICLES {
        for message in vehicle.rx {
            let mut cluster = Cluster::new(vehicle);
            for len in 0..message.len {
                let frame =
                    CanFrame::from_slice(message.id, &[0; 8][..usize::from(len)]).expect("at most 8 bytes");
                assert_eq!(cluster.receive(&frame, Millis(0)), Received::TooShort);
            }
            assert!(Value::ALL.iter().all(|&value| cluster.shown(value, Millis(0)) == Shown::Never));
            assert_eq!(cluster.receive(&frame(message, 0), Millis(0)), Received::Stored);
            let brought = Value::ALL.iter().any(|&value| cluster.shown(value, Millis(0)) != Shown::Never);
            assert!(brought, "{} of {}", message.name, vehicle.name);
        }
    }
}

#[test]
fn a_wrong_check_byte_drops_the_whole_frame_and_is_counted() {
    let mut checked = 0;
    for vehicle in VEHICLES {
        for message in vehicle.rx.iter().filter(|message| message.checksum.is_some()) {
            let mut cluster = Cluster::new(vehicle);
            let right = *frame(message, 0x11).padded();
            for bit in 0..usize::from(message.len) * 8 {
                let mut data = right;
                data[bit / 8] ^= 1 << (bit % 8);
                assert_eq!(cluster.receive(&CanFrame::full(message.id, data), Millis(0)), Received::Damaged);
                checked += 1;
            }
            assert_eq!(cluster.counters().damaged, u32::from(message.len) * 8);
            assert!(Value::ALL.iter().all(|&value| cluster.shown(value, Millis(0)) == Shown::Never));
        }
    }
    assert!(checked >= 300, "no vehicle with checksums was met");
}

#[test]
fn what_the_cluster_sends_is_sealed_after_its_life_counter_is_written() {
    for vehicle in VEHICLES {
        let mut cluster = Cluster::new(vehicle);
        for now in (0..20_000).step_by(10) {
            cluster.tick(&Inputs::default(), Millis(now));
            while let Some(frame) = cluster.transmit(Millis(now)) {
                let message = vehicle.tx.iter().find(|message| message.id == frame.id).expect("in its table");
                assert!(message.checksum.is_none_or(|checksum| checksum.holds(frame.padded())), "{frame:?}");
            }
        }
    }
}

#[test]
fn silence_turns_every_value_stale_at_its_time_out_and_not_before() {
    for vehicle in VEHICLES {
        for message in vehicle.rx {
            let mut cluster = Cluster::new(vehicle);
            cluster.receive(&frame(message, 0), Millis(1_000));
            let timeout = u64::from(message.timeout_ms);
            let seen: Vec<_> = Value::ALL
                .iter()
                .filter(|&&value| cluster.shown(value, Millis(1_000)) != Shown::Never)
                .collect();
            for &&value in &seen {
                assert_ne!(
                    cluster.shown(value, Millis(1_000 + timeout - 1)),
                    Shown::Stale,
                    "{}",
                    value.path()
                );
                assert_eq!(cluster.shown(value, Millis(1_000 + timeout)), Shown::Stale, "{}", value.path());
            }
        }
    }
}

#[test]
fn a_stuck_life_counter_turns_values_stale_while_frames_arrive() {
    for vehicle in VEHICLES {
        let mut cluster = Cluster::new(vehicle);
        let longest = vehicle.rx.iter().map(|message| u64::from(message.timeout_ms)).max().unwrap_or(0);
        for now in (0..=longest).step_by(100) {
            receive_all(&mut cluster, vehicle, 0, Millis(now));
        }
        for value in known(&cluster, Millis(longest)) {
            // Only messages without a counter are still believed.
            let mut readings = Readings::new();
            let counted = vehicle.rx.iter().zip(0..).any(|(message, index)| {
                (vehicle.decode)(index, &[0; 8], &mut readings);
                message.life.is_some() && readings.get(value).is_some_and(|(_, source)| source == index)
            });
            assert!(!counted, "{} of {}", value.path(), vehicle.name);
        }
    }
}

#[test]
fn frames_of_another_vehicle_do_nothing() {
    for vehicle in VEHICLES {
        for other in VEHICLES.iter().filter(|other| other.name != vehicle.name) {
            let mut cluster = Cluster::new(vehicle);
            let mut untouched = Cluster::new(vehicle);
            for step in 0..1_000 {
                let now = Millis(step * 10);
                for message in other.rx.iter().filter(|message| vehicle.index_of(message.id).is_none()) {
                    let frame = CanFrame::full(message.id, [step as u8; 8]);
                    assert_eq!(cluster.receive(&frame, now), Received::Unknown);
                }
                cluster.tick(&Inputs::default(), now);
                untouched.tick(&Inputs::default(), now);
                assert_eq!(cluster.view(now), untouched.view(now));
                assert_eq!(cluster.transmit(now), untouched.transmit(now));
            }
        }
    }
}

#[test]
fn every_sent_message_keeps_its_cycle_and_counts() {
    for vehicle in VEHICLES {
        let mut cluster = Cluster::new(vehicle);
        let mut sent = vec![Vec::new(); vehicle.tx.len()];
        for now in (0..20_000).step_by(10) {
            cluster.tick(&Inputs::default(), Millis(now));
            while let Some(frame) = cluster.transmit(Millis(now)) {
                let index =
                    vehicle.tx.iter().position(|message| message.id == frame.id).expect("in its table");
                sent[index].push((now, *frame.padded()));
            }
        }
        for (message, sent) in vehicle.tx.iter().zip(&sent) {
            assert_eq!(sent.len() as u64, 20_000 / u64::from(message.cycle_ms), "{}", message.name);
            for pair in sent.windows(2) {
                assert_eq!(pair[1].0 - pair[0].0, u64::from(message.cycle_ms), "{}", message.name);
                let Some(life) = message.life else { continue };
                let count = |data: [u8; 8]| data[usize::from(life.byte)] >> life.mask.trailing_zeros();
                let most = life.mask >> life.mask.trailing_zeros();
                assert_eq!(
                    count(pair[1].1) & most,
                    count(pair[0].1).wrapping_add(1) & most,
                    "{}",
                    message.name
                );
            }
        }
    }
}

#[test]
fn after_a_bus_off_of_any_length_each_message_is_sent_once_and_keeps_its_phase() {
    for vehicle in VEHICLES {
        for off_ms in [990, 1_000, 60_000, 3_600_000] {
            let mut cluster = Cluster::new(vehicle);
            let mut sent = vec![Vec::new(); vehicle.tx.len()];
            for now in (0..off_ms + 20_000).step_by(10).map(Millis) {
                cluster.tick(&Inputs::default(), now);
                // Nothing is asked for while the controller is off the bus.
                if (5_000..5_000 + off_ms).contains(&now.0) {
                    continue;
                }
                let mut at_once = Vec::new();
                while let Some(frame) = cluster.transmit(now) {
                    let index =
                        vehicle.tx.iter().position(|message| message.id == frame.id).expect("in its table");
                    assert!(
                        !at_once.contains(&index),
                        "twice at once: {} of {}",
                        vehicle.tx[index].name,
                        vehicle.name
                    );
                    at_once.push(index);
                    sent[index].push(now.0);
                }
            }
            for (message, sent) in vehicle.tx.iter().zip(&sent) {
                let cycle_ms = u64::from(message.cycle_ms);
                let after: Vec<_> = sent.iter().filter(|&&at| at >= 5_000 + off_ms + cycle_ms).collect();
                assert!(after.iter().all(|&at| at % cycle_ms == sent[0] % cycle_ms), "{}", message.name);
                assert!(after.len() as u64 >= (15_000 - cycle_ms) / cycle_ms, "{}", message.name);
            }
        }
    }
}

#[test]
fn becoming_another_vehicle_forgets_what_was_heard_and_keeps_distance_and_settings() {
    for before in VEHICLES {
        for after in VEHICLES {
            let mut cluster = Cluster::new(before);
            cluster.restore(4_321);
            cluster.press(cluster::Button::Menu, Millis(0));
            for now in (0..10_000).step_by(10).map(Millis) {
                receive_all(&mut cluster, before, 0x55, now);
                cluster.tick(&Inputs::default(), now);
            }
            cluster.recognise(after);
            assert_eq!(cluster.vehicle().name, after.name);
            assert!(known(&cluster, Millis(10_000)).is_empty());
            assert_eq!(cluster.active_faults(Millis(10_000)).count(), 0);
            assert!(cluster.odometer_km8() >= 4_321);
            assert_eq!(cluster.view(Millis(10_000)).language, cluster::view::Language::English);
            // Its nodes get their time to boot.
            cluster.tick(&Inputs::default(), Millis(10_000));
            assert_eq!(cluster.active_faults(Millis(10_000)).count(), 0);
        }
    }
}

/// Returns a vehicle, and for each of its messages the data of some frames.
fn bus_traffic() -> impl Strategy<Value = (usize, Vec<(usize, [u8; 8])>)> {
    let data = prop_oneof![any::<[u8; 8]>(), prop::array::uniform8(prop_oneof![Just(0u8), Just(24), 0u8..4])];
    (0..VEHICLES.len(), prop::collection::vec((0usize..32, data), 0..200))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn no_traffic_panics_and_the_same_traffic_gives_the_same((vehicle, traffic) in bus_traffic()) {
        let vehicle = VEHICLES[vehicle];
        let runs = [(); 2].map(|()| {
            let mut cluster = Cluster::new(vehicle);
            let mut now = Millis(0);
            let mut views = Vec::new();
            for (index, data) in &traffic {
                let message = &vehicle.rx[index % vehicle.rx.len()];
                cluster.receive(&sealed(message, *data), now);
                now = now.after(10);
                cluster.tick(&Inputs::default(), now);
                views.push((cluster.view(now), cluster.chime(now), cluster.transmit(now)));
            }
            views
        });
        prop_assert!(runs[0] == runs[1]);
        // BUS-106: the number of the fire alarm means something else on another vehicle.
        let has_fire = vehicle.faults.iter().any(|fault| fault.fire);
        for (view, ..) in &runs[0] {
            prop_assert!(has_fire || view.line.is_none_or(|line| line.named.fault != FaultId::Fire), "{}", vehicle.name);
        }
    }
}

#[test]
fn what_a_vehicle_sends_has_precedence_over_the_own_wire() {
    for vehicle in VEHICLES {
        let mut cluster = Cluster::new(vehicle);
        cluster.tick(&Inputs::default(), Millis(0));
        receive_all(&mut cluster, vehicle, 0x55, Millis(10));
        let before: Vec<_> = Value::ALL.iter().map(|&value| cluster.shown(value, Millis(10))).collect();
        cluster.tick(&Inputs::default(), Millis(10));
        for (&value, &before) in Value::ALL.iter().zip(&before) {
            // The cluster's own decisions follow what it has received.
            if !value.path().starts_with("cluster.") {
                assert_eq!(cluster.shown(value, Millis(10)), before, "{} of {}", value.path(), vehicle.name);
            }
        }
    }
}

#[test]
fn what_the_cluster_decides_is_never_taken_from_a_bus() {
    for vehicle in VEHICLES {
        let mut readings = Readings::new();
        for index in 0..vehicle.rx.len() {
            (vehicle.decode)(index as u8, &[0x55; 8], &mut readings);
        }
        let decided = Value::ALL.iter().filter(|value| value.path().starts_with("cluster."));
        assert!(decided.clone().count() > 0);
        for &value in decided {
            assert_eq!(readings.get(value), None, "{} of {}", value.path(), vehicle.name);
        }
    }
}
