//! The laws that every vehicle obeys, whatever its tables hold.

use proptest::prelude::*;
use protocol_core::codec::{MessageInfo, Mux};
use protocol_core::generated::{MESSAGES, VEHICLES};
use protocol_core::model::{Reading, Readings, Value};
use protocol_core::vehicle::{Node, Vehicle};
use protocol_core::{CanFrame, CanId};
use std::collections::{BTreeMap, BTreeSet};

fn messages(vehicle: &Vehicle) -> &'static [MessageInfo] {
    MESSAGES.iter().find(|(name, _)| *name == vehicle.name).expect("every vehicle has its messages").1
}

/// Returns everything that a store knows.
fn state(readings: &Readings) -> Vec<Option<(Reading, u8)>> {
    Value::ALL.iter().map(|value| readings.get(*value)).collect()
}

#[test]
fn received_messages_are_sorted_by_identifier_and_found_by_it() {
    for vehicle in VEHICLES {
        assert!(vehicle.rx.is_sorted_by_key(|row| row.id), "{}", vehicle.name);
        for (index, row) in vehicle.rx.iter().enumerate() {
            assert_eq!(vehicle.index_of(row.id), Some(index as u8));
            let info = messages(vehicle).iter().find(|info| info.id == row.id).expect("a message of the DBC");
            assert_eq!((info.name, info.len.min(row.len)), (row.name, row.len));
        }
    }
}

#[test]
fn no_identifier_of_one_vehicle_is_in_the_tables_of_another() {
    for vehicle in VEHICLES {
        for other in VEHICLES.iter().filter(|other| other.name != vehicle.name) {
            for message in messages(other) {
                assert_eq!(vehicle.index_of(message.id), None, "{} in {}", message.name, vehicle.name);
                assert!(vehicle.tx.iter().all(|row| row.id != message.id));
            }
        }
    }
}

/// What auto-detection stands on: an identifier tells the vehicle.
#[test]
fn no_29_bit_identifier_is_used_by_two_vehicles() {
    let mut owners: BTreeMap<CanId, &str> = BTreeMap::new();
    for (vehicle, messages) in MESSAGES {
        for message in messages.iter().filter(|message| message.id.is_extended()) {
            if let Some(other) = owners.insert(message.id, vehicle) {
                panic!("{:?} {} is sent on {other} and on {vehicle}", message.id, message.name);
            }
        }
    }
    assert!(owners.len() > 100);
}

#[test]
fn a_vehicle_is_recognised_by_every_message_that_the_cluster_does_not_send() {
    for vehicle in VEHICLES {
        assert!(vehicle.ids.is_sorted());
        for message in messages(vehicle) {
            let is_own = vehicle.node(Node::Cluster).is_some() && message.sender == "Cluster";
            assert_eq!(vehicle.has_id(message.id), !is_own, "{} of {}", message.name, vehicle.name);
        }
        assert!(vehicle.rx.iter().all(|row| vehicle.has_id(row.id)));
    }
}

#[test]
fn bus_11_identifiers_that_differ_in_one_bit_are_not_received() {
    for vehicle in VEHICLES {
        let known: BTreeSet<CanId> = vehicle.rx.iter().map(|row| row.id).collect();
        for id in &known {
            for bit in 0..if id.is_extended() { 29 } else { 11 } {
                let near = CanId::from_packed(id.packed() ^ 1 << bit);
                assert_eq!(vehicle.index_of(near).is_some(), known.contains(&near), "{near:?}");
            }
            let bits = id.bits();
            let other_kind =
                if id.is_extended() { CanId::standard(bits as u16) } else { CanId::extended(bits) };
            assert_eq!(vehicle.index_of(other_kind), None, "{id:?} as {other_kind:?}");
        }
    }
}

#[test]
fn a_timeout_is_five_slow_cycles_and_at_least_half_a_second() {
    for vehicle in VEHICLES {
        for row in vehicle.rx {
            let info = messages(vehicle).iter().find(|info| info.id == row.id).expect("a message of the DBC");
            assert_eq!(row.timeout_ms, (info.slow_cycle_ms * 5).max(500), "{}.{}", vehicle.name, row.name);
        }
    }
}

#[test]
fn life_counters_are_where_the_rows_say() {
    for vehicle in VEHICLES {
        let lives = vehicle.rx.iter().map(|row| (row.id, row.life));
        for (id, life) in lives.chain(vehicle.tx.iter().map(|row| (row.id, row.life))) {
            let info = messages(vehicle).iter().find(|info| info.id == id).expect("a message of the DBC");
            let signal = info.signals.iter().find(|signal| signal.life.is_some());
            assert_eq!(life.is_some(), signal.is_some(), "{}", info.name);
            if let (Some(life), Some(signal)) = (life, signal) {
                let mut data = [0; 8];
                signal.set_raw(&mut data, -1);
                let mut expected = [0; 8];
                expected[usize::from(life.byte)] = life.mask;
                assert_eq!(data, expected, "{}", info.name);
            }
        }
    }
}

#[test]
fn an_index_beyond_the_tables_changes_nothing() {
    for vehicle in VEHICLES {
        let mut readings = Readings::new();
        for index in vehicle.rx.len()..=255 {
            (vehicle.decode)(index as u8, &[0x55; 8], &mut readings);
        }
        assert!(state(&readings).iter().all(Option::is_none), "{}", vehicle.name);
        for index in vehicle.tx.len()..=255 {
            assert_eq!((vehicle.encode)(index as u8, &readings), [0; 8]);
        }
    }
}

#[test]
fn each_message_writes_under_its_own_index() {
    for vehicle in VEHICLES {
        let mut owners: Vec<Option<u8>> = vec![None; Value::COUNT];
        for index in 0..vehicle.rx.len() as u8 {
            let mut readings = Readings::new();
            (vehicle.decode)(index, &[0; 8], &mut readings);
            for value in Value::ALL {
                if let Some((_, source)) = readings.get(*value) {
                    assert_eq!(source, index);
                    let other = owners[*value as usize].replace(index);
                    assert_eq!(other, None, "{} has two sources in {}", value.path(), vehicle.name);
                }
            }
        }
    }
}

#[test]
fn unknown_inputs_are_sent_as_the_start_or_invalid_values_of_the_message() {
    for vehicle in VEHICLES {
        for (index, row) in vehicle.tx.iter().enumerate() {
            let info = messages(vehicle).iter().find(|info| info.id == row.id).expect("a message of the DBC");
            let data = (vehicle.encode)(index as u8, &Readings::new());
            for signal in info.signals.iter().filter(|signal| signal.life.is_none()) {
                let raw = signal.raw(&data);
                let expected = signal.invalid_raw.unwrap_or(signal.start_raw);
                assert_eq!(raw, expected, "{}.{}.{}", vehicle.name, row.name, signal.name);
            }
        }
    }
}

#[test]
fn fault_texts_are_sorted_and_found() {
    for vehicle in VEHICLES {
        assert!(vehicle.faults.is_sorted_by_key(|fault| (fault.source, fault.code)));
        for fault in vehicle.faults {
            assert_eq!(vehicle.fault(fault.source, fault.code), Some(fault));
            assert!(vehicle.node(fault.source).is_some(), "{:?} has a name", fault.source);
        }
        assert_eq!(vehicle.fault(Node::Cluster, 1), None);
    }
}

/// Any vehicle and any of its messages.
fn any_message() -> impl Strategy<Value = &'static MessageInfo> {
    let all: Vec<&'static MessageInfo> = MESSAGES.iter().flat_map(|(_, messages)| messages.iter()).collect();
    proptest::sample::select(all)
}

proptest! {
    #[test]
    fn rows_and_getters_agree_for_any_bytes(message in any_message(), data: [u8; 8]) {
        for (index, signal) in message.signals.iter().enumerate() {
            let raw = signal.raw(&data);
            prop_assert_eq!((message.get)(index, data), Some((raw, signal.physical(raw))));
        }
        prop_assert_eq!((message.get)(message.signals.len(), data), None);
    }

    #[test]
    fn writing_back_what_was_read_changes_nothing(message in any_message(), data: [u8; 8]) {
        let mut by_row = data;
        let mut by_setter = data;
        for (index, signal) in message.signals.iter().enumerate() {
            signal.set_raw(&mut by_row, signal.raw(&data));
            by_setter = (message.set)(index, by_setter, signal.raw(&data));
        }
        prop_assert_eq!(by_row, data);
        prop_assert_eq!(by_setter, data);
    }

    #[test]
    fn a_frame_built_from_the_fill_reads_back(message in any_message(), seed: [u8; 8]) {
        let mut data = message.fill;
        let plain = || message.signals.iter().filter(|signal| !matches!(signal.mux, Mux::When(_)));
        for signal in plain() {
            signal.set_raw(&mut data, signal.raw(&seed));
        }
        for signal in plain() {
            prop_assert_eq!(signal.raw(&data), signal.raw(&seed));
        }
        for (byte, fill) in message.fill.iter().enumerate().filter(|(_, fill)| **fill != 0) {
            prop_assert_eq!(data[byte], *fill, "a reserved byte keeps its fill");
        }
    }

    #[test]
    fn no_bytes_of_any_length_panic(bytes in proptest::collection::vec(any::<u8>(), 0..=8)) {
        for vehicle in VEHICLES {
            let mut readings = Readings::new();
            for (index, row) in vehicle.rx.iter().enumerate() {
                let frame = CanFrame::from_slice(row.id, &bytes).expect("at most 8 bytes");
                (vehicle.decode)(index as u8, frame.padded(), &mut readings);
            }
            let once = state(&readings);
            for (index, row) in vehicle.rx.iter().enumerate() {
                let frame = CanFrame::from_slice(row.id, &bytes).expect("at most 8 bytes");
                (vehicle.decode)(index as u8, frame.padded(), &mut readings);
            }
            prop_assert_eq!(once, state(&readings), "the same frames twice give the same state");
            for index in 0..vehicle.tx.len() {
                (vehicle.encode)(index as u8, &readings);
            }
        }
    }

    #[test]
    fn no_local_input_panics_an_encoder(number: i32) {
        for vehicle in VEHICLES {
            let mut readings = Readings::new();
            for value in Value::ALL {
                readings.set(Readings::LOCAL, *value, Reading::Valid(number));
            }
            for (index, row) in vehicle.tx.iter().enumerate() {
                let data = (vehicle.encode)(index as u8, &readings);
                let info = messages(vehicle).iter().find(|info| info.id == row.id).expect("a message of the DBC");
                for signal in info.signals.iter().filter(|signal| signal.life.is_none()) {
                    let raw = signal.raw(&data);
                    prop_assert!(signal.is_valid(raw) || signal.invalid_raw == Some(raw), "{}", signal.name);
                }
            }
        }
    }
}
