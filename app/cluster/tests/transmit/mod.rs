//! What the cluster sends: cycle, phase, life counter, no bursts.

mod unknown;

use crate::support::toy::*;
use crate::support::*;
use cluster::{Cluster, Contacts, Inputs, Key};
use proptest::prelude::*;
use protocol_core::Value;
use protocol_core::{CanFrame, CanId, Millis};

/// Everything that is due now.
fn due(cluster: &mut Cluster, now: Millis) -> Vec<CanFrame> {
    core::iter::from_fn(|| cluster.transmit(now)).take(100).collect()
}

/// Runs for `ms` and returns what was sent and when.
fn sent(drive: &mut Drive, ms: u64) -> Vec<(u64, CanFrame)> {
    let mut sent = Vec::new();
    for _ in 0..ms / TICK {
        let now = drive.now;
        drive.run(TICK);
        sent.extend(due(&mut drive.cluster, now).into_iter().map(|frame| (now.0, frame)));
    }
    sent
}

fn times(sent: &[(u64, CanFrame)], id: CanId) -> Vec<u64> {
    sent.iter().filter(|(_, frame)| frame.id == id).map(|&(at, _)| at).collect()
}

#[test]
fn nothing_is_sent_before_the_first_tick() {
    let mut cluster = Cluster::new(&TOY);
    assert_eq!(due(&mut cluster, Millis(1_000_000)), []);
}

#[test]
fn every_message_keeps_its_cycle_and_its_phase() {
    let mut drive = Drive::at(&TOY, Millis(30));
    let sent = sent(&mut drive, 10_000);
    assert_eq!(times(&sent, OWN), (0..10).map(|n| 30 + n * 1_000).collect::<Vec<_>>());
    assert_eq!(times(&sent, OWN_WAY), (0..20).map(|n| 50 + n * 500).collect::<Vec<_>>());
}

#[test]
fn bus_r127_the_heartbeat_counts_every_frame_from_0_to_255_and_round() {
    let mut drive = Drive::of(&TOY);
    let sent = sent(&mut drive, 300_000);
    let beats: Vec<u8> =
        sent.iter().filter(|(_, frame)| frame.id == OWN).map(|(_, frame)| frame.bytes()[7]).collect();
    assert_eq!(beats.len(), 300);
    assert!(beats.iter().zip(0u32..).all(|(&beat, n)| u32::from(beat) == n % 256));
}

#[test]
fn a_counter_of_some_bits_leaves_its_neighbours_alone() {
    let mut drive = Drive::of(&TOY);
    let sent = sent(&mut drive, 20_000);
    let bytes: Vec<u8> =
        sent.iter().filter(|(_, frame)| frame.id == OWN_WAY).map(|(_, frame)| frame.bytes()[0]).collect();
    assert!(bytes.iter().zip(0u32..).all(|(&byte, n)| u32::from(byte) == (n % 16) << 4 | 5), "{bytes:02X?}");
}

#[test]
fn a_stall_sends_each_message_once_and_keeps_its_phase() {
    let mut drive = Drive::of(&TOY);
    sent(&mut drive, 2_000);
    for stall in [1, 499, 500, 999, 1_000, 12_345, 5_000_000_000] {
        let now = Millis(drive.now.0 / 10_000 * 10_000 + 20_000 + stall);
        drive.cluster.tick(&drive.inputs, now);
        let after = due(&mut drive.cluster, now);
        assert_eq!(after.len(), 2, "after {stall} ms, {after:?}");
        drive.now = Millis(now.0 / 10 * 10 + 10);
        let sent = sent(&mut drive, 3_000);
        assert!(times(&sent, OWN).iter().all(|at| at % 1_000 == 0), "after {stall} ms");
        assert!(times(&sent, OWN_WAY).iter().all(|at| at % 500 == 20), "after {stall} ms");
    }
}

#[test]
fn what_is_sent_is_what_the_wires_say() {
    let mut drive = healthy();
    drive.inputs = Inputs {
        key: Some(Key::On),
        contacts: Contacts::closed([Value::BodySeatEmpty, Value::BodyTurnLeft]),
        air_front_centimpa: None,
        supply_decivolts: Some(240),
        ..Inputs::default()
    };
    drive.gear_and_speed(1, 5);
    let sent = sent(&mut drive, 2_000);
    let (_, own) = sent.iter().rev().find(|(_, frame)| frame.id == OWN).expect("one a second");
    assert_eq!(own.bytes()[..7], [1, 2, 0xFF, 0, 1, 1, 240]);
}

#[test]
fn bus_r128_a_two_door_bus_sends_0_for_its_middle_door() {
    let mut drive = healthy();
    drive.inputs.contacts.set(Value::BodyDoorFront, true);
    drive.inputs.contacts.set(Value::BodyDoorRear, true);
    let sent = sent(&mut drive, 1_000);
    let (_, own) = sent.iter().find(|(_, frame)| frame.id == OWN).expect("one a second");
    assert_eq!(own.bytes()[3], 0);
}

#[test]
fn bus_97_the_odometer_is_sent_in_eighths_of_a_kilometre() {
    let mut drive = healthy();
    drive.cluster.restore(0x0102_0304);
    let sent = sent(&mut drive, 1_000);
    let (_, way) = sent.iter().rev().find(|(_, frame)| frame.id == OWN_WAY).expect("two a second");
    assert_eq!(way.bytes()[1..5], [4, 3, 2, 1]);
}

proptest! {
    /// Whatever the ticks: never two frames of a message closer than its cycle allows, never one lost for longer.
    #[test]
    fn no_rhythm_of_ticks_makes_a_burst(steps in prop::collection::vec(1u64..3_000, 1..200)) {
        let mut cluster = Cluster::new(&TOY);
        let mut now = Millis(0);
        let mut last: Option<u64> = None;
        for step in steps {
            cluster.tick(&Inputs::default(), now);
            let frames = due(&mut cluster, now);
            for message in TOY.tx {
                prop_assert!(frames.iter().filter(|frame| frame.id == message.id).count() <= 1);
            }
            if frames.iter().any(|frame| frame.id == OWN) {
                last = Some(now.0);
            }
            // The phase is a multiple of the cycle from start: one per second that any tick falls into.
            prop_assert_eq!(last.map(|at| at / 1_000), Some(now.0 / 1_000));
            now = now.after(step);
        }
    }
}
