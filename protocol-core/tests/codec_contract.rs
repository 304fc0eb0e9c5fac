//! The laws that every vehicle obeys, whatever its tables hold.
//!
//! A vehicle may share identifiers with another, name its nodes as it likes and set its own timeouts.

mod fleet;

use fleet::{Car, DOCUMENTED, fleet};
use proptest::prelude::*;
use protocol_core::codec::{MessageInfo, Mux};
use protocol_core::model::{Reading, Readings, Value};
use protocol_core::vehicle::Node;
use protocol_core::{CanFrame, CanId};
use protocol_core::{checksum, codec, frame, model, stream, vehicle};
use std::collections::{BTreeMap, BTreeSet};

/// Returns everything that a store knows.
fn state(readings: &Readings) -> Vec<Option<(Reading, u8)>> {
    Value::ALL.iter().map(|value| readings.get(*value)).collect()
}

#[test]
fn received_messages_are_sorted_by_identifier_and_found_by_it() {
    for Car { vehicle, messages, .. } in fleet() {
        assert!(vehicle.rx.is_sorted_by_key(|row| row.id), "{}", vehicle.name);
        for (index, row) in vehicle.rx.iter().enumerate() {
            assert_eq!(vehicle.index_of(row.id), Some(index as u8));
            let info = messages.iter().find(|info| info.id == row.id).expect("a message of the DBC");
            assert_eq!((info.name, info.len.min(row.len)), (row.name, row.len));
        }
    }
}

/// What auto-detection stands on. Vehicles may share identifiers; one that has none of its own is never found.
#[test]
fn every_vehicle_sends_an_identifier_that_no_other_one_of_its_bit_rate_has() {
    let fleet = fleet();
    for Car { vehicle, .. } in &fleet {
        let is_other =
            |other: &&Car| other.vehicle.name != vehicle.name && other.vehicle.bitrate == vehicle.bitrate;
        let is_shared = |id: &CanId| fleet.iter().filter(is_other).any(|other| other.vehicle.has_id(*id));
        assert!(
            vehicle.ids.iter().any(|id| !is_shared(id)),
            "{}: every identifier of it is another vehicle's too, so a cluster cannot find out which one it is on",
            vehicle.name
        );
    }
}

#[test]
fn the_documents_print_no_29_bit_identifier_for_two_vehicles() {
    let mut owners: BTreeMap<CanId, &str> = BTreeMap::new();
    for Car { vehicle, messages, .. } in fleet() {
        if !DOCUMENTED.contains(&vehicle.name) {
            continue;
        }
        for message in messages.iter().filter(|message| message.id.is_extended()) {
            if let Some(other) = owners.insert(message.id, vehicle.name) {
                panic!("{:?} {} is sent on {other} and on {}", message.id, message.name, vehicle.name);
            }
        }
    }
    assert!(owners.len() > 100);
}

#[test]
fn a_vehicle_is_recognised_by_every_message_that_the_cluster_does_not_send() {
    for Car { vehicle, messages, .. } in fleet() {
        assert!(vehicle.ids.is_sorted());
        assert!(vehicle.rx.iter().all(|row| vehicle.has_id(row.id)));
        // The sender of what is not recognised: the cluster's own node, whatever the DBC calls it.
        let own: BTreeSet<&str> =
            messages.iter().filter(|info| !vehicle.has_id(info.id)).map(|info| info.sender).collect();
        assert!(own.len() <= usize::from(vehicle.node(Node::Cluster).is_some()), "{}: {own:?}", vehicle.name);
        for message in messages {
            let is_own = own.contains(message.sender);
            assert_eq!(vehicle.has_id(message.id), !is_own, "{} of {}", message.name, vehicle.name);
        }
        for row in vehicle.tx {
            assert!(!vehicle.has_id(row.id), "{} of {} is sent by the cluster", row.name, vehicle.name);
        }
    }
}

#[test]
fn bus_11_identifiers_that_differ_in_one_bit_are_not_received() {
    for Car { vehicle, .. } in fleet() {
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

/// Returns `timeout_ms` of a message, where the binding sets it.
fn timeout_set(binding: &str, message: &str) -> Option<u32> {
    let (_, section) = binding.split_once(&format!("[rx.{message}]"))?;
    let section = section.split("\n[").next()?;
    let line = section.lines().find_map(|line| line.trim().strip_prefix("timeout_ms"))?;
    line.trim_start_matches([' ', '=']).split([' ', '#']).next()?.replace('_', "").parse().ok()
}

#[test]
fn a_timeout_is_five_slow_cycles_and_at_least_half_a_second_unless_it_is_set() {
    let mut set = 0;
    for car in fleet() {
        let binding = car.binding();
        for row in car.vehicle.rx {
            let info = car.messages.iter().find(|info| info.id == row.id).expect("a message of the DBC");
            let written = timeout_set(&binding, row.name);
            set += usize::from(written.is_some());
            let expected = written.unwrap_or((info.slow_cycle_ms * 5).max(500));
            assert_eq!(row.timeout_ms, expected, "{}.{}", car.vehicle.name, row.name);
        }
    }
    assert!(set >= 2, "the hostile vehicle sets two");
}

#[test]
fn life_counters_are_where_the_rows_say() {
    for Car { vehicle, messages, .. } in fleet() {
        let lives = vehicle.rx.iter().map(|row| (row.id, row.life));
        for (id, life) in lives.chain(vehicle.tx.iter().map(|row| (row.id, row.life))) {
            let info = messages.iter().find(|info| info.id == id).expect("a message of the DBC");
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
    for Car { vehicle, .. } in fleet() {
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
    for Car { vehicle, .. } in fleet() {
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
fn unknown_inputs_are_sent_as_the_binding_says_or_as_the_invalid_or_start_values_of_the_message() {
    for car in fleet() {
        let Car { vehicle, messages, .. } = car;
        let binding = car.binding();
        // `SIGNAL = { ..., missing = RAW }`
        let said = |signal: &str| {
            let mut rows = binding.lines().filter(|line| line.starts_with(&format!("{signal} = {{")));
            let raw = rows.find_map(|line| line.split_once("missing = "))?.1;
            let digits: String = raw.chars().filter(|&c| c != '_').take_while(char::is_ascii_digit).collect();
            digits.parse().ok()
        };
        for (index, row) in vehicle.tx.iter().enumerate() {
            let info = messages.iter().find(|info| info.id == row.id).expect("a message of the DBC");
            let data = (vehicle.encode)(index as u8, &Readings::new());
            for signal in info.signals.iter().filter(|signal| signal.life.is_none()) {
                let raw = signal.raw(&data);
                let expected = said(signal.name).or(signal.invalid_raw).unwrap_or(signal.start_raw);
                assert_eq!(raw, expected, "{}.{}.{}", vehicle.name, row.name, signal.name);
            }
        }
    }
}

#[test]
fn fault_texts_are_sorted_and_found() {
    for Car { vehicle, .. } in fleet() {
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
    let all: Vec<&'static MessageInfo> = fleet().iter().flat_map(|car| car.messages).collect();
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
        for Car { vehicle, .. } in fleet() {
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
        for Car { vehicle, messages, .. } in fleet() {
            let mut readings = Readings::new();
            for value in Value::ALL {
                readings.set(Readings::LOCAL, *value, Reading::Valid(number));
            }
            for (index, row) in vehicle.tx.iter().enumerate() {
                let data = (vehicle.encode)(index as u8, &readings);
                let info = messages.iter().find(|info| info.id == row.id).expect("a message of the DBC");
                for signal in info.signals.iter().filter(|signal| signal.life.is_none()) {
                    let raw = signal.raw(&data);
                    prop_assert!(signal.is_valid(raw) || signal.invalid_raw == Some(raw), "{}", signal.name);
                }
            }
        }
    }
}
