//! Anything at all: no panic, no memory of other vehicles, the same answer twice.

use crate::support::toy::*;
use cluster::{Button, Cluster, Inputs, Received};
use proptest::prelude::*;
use protocol_core::model::{Shown, Value};
use protocol_core::{CanFrame, CanId, Millis, Severity};

#[derive(Clone, Debug)]
enum Event {
    Frame(u8, Vec<u8>),
    Stranger(u32, [u8; 8]),
    Tick(u8),
    Wait(u64),
    Press(bool),
}

fn event() -> impl Strategy<Value = Event> {
    prop_oneof![
        4 => (0u8..6, prop::collection::vec(any::<u8>(), 0..=8)).prop_map(|(index, data)| Event::Frame(index, data)),
        2 => (0u8..6, prop::array::uniform8(0u8..4))
            .prop_map(|(index, data)| Event::Frame(index, data.to_vec())),
        1 => (any::<u32>(), any::<[u8; 8]>()).prop_map(|(id, data)| Event::Stranger(id, data)),
        4 => any::<u8>().prop_map(Event::Tick),
        2 => prop_oneof![0u64..50, 400u64..700, 9_000u64..11_000, 0u64..1 << 40].prop_map(Event::Wait),
        1 => any::<bool>().prop_map(Event::Press),
    ]
}

/// Applies the events and returns everything that could be observed.
fn observe(events: &[Event], strangers: bool) -> Vec<String> {
    let mut cluster = Cluster::new(&TOY);
    let mut now = Millis(0);
    let mut seen = Vec::new();
    for event in events {
        match event {
            Event::Frame(index, data) => {
                let id = TOY.rx[usize::from(*index)].id;
                let frame = CanFrame::from_slice(id, data).expect("at most 8 bytes");
                let received = cluster.receive(&frame, now);
                assert_eq!(received == Received::Stored, data.len() == 8);
            }
            Event::Stranger(id, data) => {
                let id = CanId::from_packed(*id);
                if strangers && TOY.index_of(id).is_none() {
                    assert_eq!(cluster.receive(&CanFrame::full(id, *data), now), Received::Unknown);
                }
            }
            Event::Tick(bits) => {
                let mut inputs = Inputs::default();
                inputs.contacts.set(Value::BodySeatEmpty, bits & 1 != 0);
                inputs.contacts.set(Value::BodySmoke, bits & 2 != 0);
                inputs.buttons.next = bits & 4 != 0;
                inputs.buttons.menu = bits & 8 != 0;
                now = now.after(10);
                cluster.tick(&inputs, now);
            }
            Event::Wait(ms) => now = now.after(*ms),
            Event::Press(next) => cluster.press(if *next { Button::Next } else { Button::Menu }, now),
        }
        let view = cluster.view(now);
        if let Some(line) = view.line {
            assert!(line.severity == view.severity, "a lower severity is shown: {view:?}");
            assert!((1..=line.count).contains(&line.position), "{line:?}");
        } else {
            assert_eq!(view.severity, Severity::None);
        }
        if !matches!(cluster.shown(Value::VehicleSpeed, now), Shown::Value(_)) {
            assert!(view.speed_kmh.value().is_none() && view.gear.is_none());
        }
        seen.push(format!("{view:?} {:?} {:?}", cluster.chime(now), cluster.transmit(now)));
    }
    seen
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn no_sequence_panics_and_every_sequence_gives_the_same_twice(
        events in prop::collection::vec(event(), 0..120),
    ) {
        prop_assert_eq!(observe(&events, true), observe(&events, true));
    }

    #[test]
    fn frames_of_another_vehicle_change_nothing(events in prop::collection::vec(event(), 0..120)) {
        prop_assert_eq!(observe(&events, true), observe(&events, false));
    }
}

#[test]
fn the_cluster_takes_less_than_7_kib() {
    assert!(size_of::<Cluster>() < 7 * 1024, "{} bytes", size_of::<Cluster>());
}

#[test]
fn a_cluster_can_live_in_a_static() {
    static CLUSTER: std::sync::Mutex<Cluster> = std::sync::Mutex::new(Cluster::new(&TOY));
    let mut cluster = CLUSTER.lock().expect("nobody else");
    cluster.tick(&Inputs::default(), Millis(0));
}
