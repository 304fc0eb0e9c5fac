//! What the rows of messages and signals can be asked, on every row of every vehicle.

use protocol_core::CanId;
use protocol_core::codec::{Mux, scaled};
use protocol_core::generated::{MESSAGES, VEHICLES, citybus, example};
use protocol_core::model::{Readings, Value};
use protocol_core::vehicle::{NO_VEHICLE, Node};

#[test]
fn a_start_frame_has_every_start_value_and_fill_around_them() {
    for message in MESSAGES.iter().flat_map(|(_, messages)| *messages) {
        let frame = message.start_frame();
        let mut rest = frame;
        for signal in message.signals.iter().filter(|signal| !matches!(signal.mux, Mux::When(_))) {
            let start = signal.start_raw;
            assert_eq!(signal.raw(&frame), start, "{}.{}", message.name, signal.name);
            signal.set_raw(&mut rest, signal.raw(&message.fill));
        }
        assert_eq!(rest, message.fill, "{}: outside of its signals a frame is fill", message.name);
    }
}

#[test]
fn every_raw_value_with_a_word_is_told_by_it_and_no_other() {
    for message in MESSAGES.iter().flat_map(|(_, messages)| *messages) {
        for signal in message.signals {
            for raw in signal.values.iter().flat_map(|(raw, _)| [raw - 1, *raw, raw + 1]) {
                let listed = signal.values.iter().find(|(value, _)| *value == raw).map(|(_, word)| *word);
                assert_eq!(signal.word(raw), listed, "{}.{} {raw}", message.name, signal.name);
            }
        }
    }
}

#[test]
fn an_encoder_s_number_is_scaled_shifted_rounded_down_and_limited() {
    // (number x mul + add) / den, worked out by hand.
    assert_eq!(scaled(10, 3, 1, 2, -100, 100), 15);
    assert_eq!(scaled(-10, 3, 1, 2, -100, 100), -15, "-14.5 rounded down");
    assert_eq!(scaled(i32::MAX, 1 << 31, 0, 1, 0, i64::MAX), 4_611_686_016_279_904_256);
    for (number, limited) in [(-6, -5), (-5, -5), (-4, -4), (7, 7), (8, 8), (9, 8)] {
        assert_eq!(scaled(number, 1, 0, 1, -5, 8), limited);
    }
}

#[test]
fn what_a_vehicle_does_not_have_is_not_found() {
    for vehicle in VEHICLES {
        for row in vehicle.nodes {
            assert_eq!(vehicle.node(row.node), Some(row));
        }
        for row in vehicle.faults {
            assert_eq!(vehicle.fault(row.source, row.code), Some(row));
        }
        assert_eq!(vehicle.fault(Node::Vcu, u16::MAX), None);
        assert!(vehicle.ids.iter().all(|&id| vehicle.has_id(id)));
    }
    assert_eq!((NO_VEHICLE.node(Node::Vcu), NO_VEHICLE.fault(Node::Vcu, 1)), (None, None));
    assert!(citybus::VEHICLE.ids.iter().all(|&id| !example::VEHICLE.has_id(id)));
}

#[test]
fn no_vehicle_says_nothing() {
    let mut readings = Readings::new();
    (NO_VEHICLE.decode)(0, &[0xFF; 8], &mut readings);
    assert!(Value::ALL.iter().all(|&value| readings.get(value).is_none()));
    assert_eq!((NO_VEHICLE.encode)(0, &readings), [0; 8]);
    assert_eq!((NO_VEHICLE.index_of(CanId::standard(0)), NO_VEHICLE.ids.len()), (None, 0));
}
