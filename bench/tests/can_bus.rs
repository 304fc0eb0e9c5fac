//! Who wins the bus, who hears it, who is taken off it.

use bench::can::bits::FrameBits;
use bench::can::{
    Aborted, Bus, BusError, Confinement, Event, EventKind, Frame, Id, LoadGenerator, NodeId, NodeMode,
    Participant, Replay, Tag,
};
use bench::time::Nanos;
use proptest::prelude::*;

const BIT: u64 = 4_000; // ns at 250 kbit/s
const LONG: Nanos = Nanos::from_secs(10);

fn bus() -> Bus {
    Bus::new(250_000)
}

fn standard(raw: u16, payload: &[u8]) -> Frame {
    Frame::new(Id::standard(raw).unwrap(), payload).unwrap()
}

fn extended(raw: u32, payload: &[u8]) -> Frame {
    Frame::new(Id::extended(raw).unwrap(), payload).unwrap()
}

fn run(bus: &mut Bus, until: Nanos) -> Vec<Event> {
    std::iter::from_fn(|| bus.poll(until)).collect()
}

fn sent_order(events: &[Event]) -> Vec<(NodeId, Tag)> {
    let sent = |event: &Event| match event.kind {
        EventKind::Sent { tag } => Some((event.node, tag)),
        _ => None,
    };
    events.iter().filter_map(sent).collect()
}

#[test]
fn a_frame_is_valid_for_receivers_one_bit_before_its_transmitter() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach("b"));
    let frame = standard(0x2AA, &[0x55, 0xAA]);
    bus.request(a, Nanos(1_000), frame, Tag(7));
    let bits = u64::from(FrameBits::of(&frame).total());
    let events = run(&mut bus, LONG);
    let end_of_frame = 1_000 + (bits - 3) * BIT;
    assert_eq!(
        events,
        [
            Event { at: Nanos(end_of_frame - BIT), node: b, kind: EventKind::Received { frame } },
            Event { at: Nanos(end_of_frame), node: a, kind: EventKind::Sent { tag: Tag(7) } },
        ]
    );
}

#[test]
fn lower_identifiers_win_and_losers_follow_back_to_back() {
    let mut bus = bus();
    let nodes: Vec<NodeId> = ["a", "b", "c"].map(|name| bus.attach(name)).to_vec();
    let frames = [extended(0x0C00_0003, &[3]), extended(0x0C00_0001, &[1]), extended(0x0C00_0002, &[2])];
    for (index, frame) in frames.into_iter().enumerate() {
        bus.request(nodes[index], Nanos::ZERO, frame, Tag(index as u32));
    }
    let events = run(&mut bus, LONG);
    assert_eq!(sent_order(&events), [(nodes[1], Tag(1)), (nodes[2], Tag(2)), (nodes[0], Tag(0))]);
    let lost = events.iter().filter(|e| matches!(e.kind, EventKind::ArbitrationLost { .. })).count();
    assert_eq!(lost, 3, "two lose the first round, one the second");
    let total: u64 = frames.iter().map(|frame| u64::from(FrameBits::of(frame).total())).sum();
    assert_eq!(
        events.last().map(|event| event.at),
        Some(Nanos((total - 3) * BIT)),
        "no gap between the frames"
    );
}

#[test]
fn a_standard_frame_wins_over_an_extended_one_of_the_same_base_identifier() {
    let mut bus = bus();
    let (a, b) = (bus.attach("extended"), bus.attach("standard"));
    bus.request(a, Nanos::ZERO, extended(0x123 << 18, &[]), Tag(0));
    bus.request(b, Nanos::ZERO, Frame::new_remote(Id::standard(0x123).unwrap(), 0), Tag(0));
    assert_eq!(
        sent_order(&run(&mut bus, LONG))[0].0,
        b,
        "even a remote one: IDE is dominant, SRR and RTR tie"
    );
}

#[test]
fn a_data_frame_wins_over_the_remote_frame_that_asks_for_it() {
    let mut bus = bus();
    let (a, b) = (bus.attach("asks"), bus.attach("tells"));
    bus.request(a, Nanos::ZERO, Frame::new_remote(Id::standard(0x123).unwrap(), 1), Tag(0));
    bus.request(b, Nanos::ZERO, standard(0x123, &[1]), Tag(0));
    assert_eq!(sent_order(&run(&mut bus, LONG))[0].0, b);
}

#[test]
fn a_loser_receives_the_frame_that_beat_it() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach("b"));
    let winner = standard(1, &[9]);
    bus.request(a, Nanos::ZERO, winner, Tag(0));
    bus.request(b, Nanos::ZERO, standard(2, &[]), Tag(0));
    let events = run(&mut bus, LONG);
    assert!(events.iter().any(|e| e.node == b && e.kind == EventKind::Received { frame: winner }));
}

#[test]
fn equal_identifiers_with_different_data_collide_as_a_bit_error() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach("b"));
    bus.request(a, Nanos::ZERO, standard(1, &[1]), Tag(0));
    bus.request(b, Nanos::ZERO, standard(1, &[2]), Tag(0));
    let events = run(&mut bus, Nanos::from_millis(1));
    assert!(events.iter().any(|e| matches!(e.kind, EventKind::Error { error: BusError::Bit, .. })));
    assert!(sent_order(&events).is_empty());
}

#[test]
fn a_lonely_node_goes_error_passive_but_never_bus_off() {
    let mut bus = bus();
    let alone = bus.attach("alone");
    bus.request(alone, Nanos::ZERO, standard(1, &[1]), Tag(0));
    let events = run(&mut bus, Nanos::from_secs(1));
    assert_eq!(bus.counters(alone).transmit, 128, "16 missed acknowledges, then none counts");
    assert_eq!(bus.state(alone), Confinement::ErrorPassive);
    assert!(events.len() > 1_000, "it keeps trying");
    assert!(sent_order(&events).is_empty());
}

#[test]
fn an_error_passive_transmitter_waits_eight_bits_longer() {
    let mut bus = bus();
    let alone = bus.attach("alone");
    let frame = standard(0x2AA, &[]);
    bus.request(alone, Nanos::ZERO, frame, Tag(0));
    let errors: Vec<u64> = run(&mut bus, Nanos::from_secs(1))
        .iter()
        .filter(|e| matches!(e.kind, EventKind::Error { error: BusError::Ack, .. }))
        .map(|e| e.at.0)
        .collect();
    // Start of frame to ACK slot, error flag 6, delimiter 8, intermission 3.
    let active = (u64::from(FrameBits::of(&frame).ack_end()) + 6 + 8 + 3) * BIT;
    assert_eq!(errors[1] - errors[0], active);
    assert_eq!(errors[41] - errors[40], active + 8 * BIT);
}

#[test]
fn a_listener_does_not_acknowledge_but_hears_once_the_sender_is_passive() {
    let mut bus = bus();
    let (sender, listener) = (bus.attach("sender"), bus.attach("listener"));
    bus.set_mode(listener, Nanos::ZERO, NodeMode::ListenOnly);
    let frame = standard(1, &[1]);
    bus.request(sender, Nanos::ZERO, frame, Tag(0));
    let events = run(&mut bus, Nanos::from_millis(100));
    assert!(sent_order(&events).is_empty());
    let first = events.iter().find(|e| e.kind == EventKind::Received { frame }).expect("heard");
    let passive = events
        .iter()
        .find(|e| e.kind == EventKind::StateChanged { state: Confinement::ErrorPassive })
        .expect("sender goes passive");
    assert!(first.at > passive.at, "before that its active error flag destroys every frame");
    assert_eq!(bus.counters(listener).receive, 0, "a listener's counters rest");
}

#[test]
fn thirty_two_bit_errors_take_a_node_off_the_bus_and_128_times_11_bits_bring_it_back() {
    let mut bus = bus();
    let (bad, other) = (bus.attach("bad"), bus.attach("other"));
    bus.force_bit_errors(bad, 40);
    bus.request(bad, Nanos::ZERO, standard(1, &[1]), Tag(0));
    let events = run(&mut bus, LONG);
    let state_at = |wanted: Confinement, skip: usize| {
        let is = |e: &&Event| e.node == bad && e.kind == EventKind::StateChanged { state: wanted };
        events.iter().filter(is).nth(skip).map(|e| e.at)
    };
    let errors_before_off = events
        .iter()
        .filter(|e| e.node == bad && matches!(e.kind, EventKind::Error { .. }))
        .filter(|e| Some(e.at) <= state_at(Confinement::BusOff, 0))
        .count();
    assert_eq!(errors_before_off, 32);
    let off = state_at(Confinement::BusOff, 0).expect("bus-off");
    let back = state_at(Confinement::ErrorActive, 0).expect("recovery");
    // The last error frame's flags are dominant; the count starts with its delimiter.
    let idle = (back - off).0 / BIT;
    assert!((128 * 11 + 6..=128 * 11 + 12).contains(&idle), "{idle} bits");
    assert_eq!(sent_order(&events), [(bad, Tag(0))], "the request survives, eight more bit errors later");
    assert!(bus.counters(other).receive > 0, "32 error flags were seen");
}

#[test]
fn a_frame_that_waited_through_bus_off_starts_after_the_recovery() {
    let mut bus = bus();
    let (bad, ear) = (bus.attach("bad"), bus.attach("ear"));
    bus.force_bit_errors(bad, 32);
    let frame = standard(1, &[1]);
    bus.request(bad, Nanos::ZERO, frame, Tag(0));
    let events = run(&mut bus, LONG);
    let at = |node: NodeId, kind: EventKind| {
        events.iter().find(|e| e.node == node && e.kind == kind).map(|e| e.at).expect("happens")
    };
    let back = at(bad, EventKind::StateChanged { state: Confinement::ErrorActive });
    let heard = at(ear, EventKind::Received { frame });
    assert_eq!(heard - back, Nanos(u64::from(FrameBits::of(&frame).received()) * BIT));
    assert!(events.is_sorted_by_key(|event| event.at));
}

#[test]
fn two_nodes_with_one_identifier_never_put_two_frames_into_the_time_of_one() {
    let mut bus = bus();
    let [one, same, third, ear] = ["one", "same", "third", "ear"].map(|name| bus.attach(name));
    let sends = |node: NodeId, raw: u32, every_ms: u64| {
        LoadGenerator::new(node, move |n| extended(raw, &[every_ms as u8, n as u8]))
            .spaced_by(Nanos::from_millis(every_ms))
    };
    let mut generators = [sends(one, 0x18FF_1234, 2), sends(same, 0x18FF_1234, 3), sends(third, 0x1000, 5)];
    generators.iter_mut().for_each(|generator| generator.start(Nanos::ZERO, &mut bus));
    let (mut bus_offs, mut heard, mut last) = (0, Vec::new(), Nanos::ZERO);
    while let Some(event) = bus.poll(LONG) {
        assert!(event.at >= last, "{event:?} after {last}");
        last = event.at;
        generators.iter_mut().for_each(|generator| generator.on_event(&event, &mut bus));
        match event.kind {
            EventKind::StateChanged { state: Confinement::BusOff } => bus_offs += 1,
            EventKind::Received { frame } if event.node == ear => heard.push((event.at, frame)),
            _ => {}
        }
    }
    assert!(bus_offs > 100, "the two take each other off the bus again and again: {bus_offs}");
    assert!(heard.len() >= 2_000, "the third is heard every 5 ms: {}", heard.len());
    for pair in heard.windows(2) {
        let frame_time = Nanos(u64::from(FrameBits::of(&pair[1].1).total()) * BIT);
        assert!(pair[1].0 - pair[0].0 >= frame_time, "{pair:?}");
    }
}

#[test]
fn what_becomes_possible_late_happens_late() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach_off("b"));
    bus.attach("ear");
    // Heard empty up to 10 ms: no frame may start in there any more.
    assert!(run(&mut bus, Nanos::from_millis(10)).is_empty());
    bus.request(a, Nanos::ZERO, standard(1, &[]), Tag(0));
    bus.request(a, Nanos::from_millis(30), standard(2, &[]), Tag(1));
    bus.request(a, Nanos::ZERO, standard(3, &[]), Tag(2));
    bus.request(b, Nanos::ZERO, standard(4, &[]), Tag(3));
    let events = run(&mut bus, Nanos::from_millis(20));
    assert_eq!(sent_order(&events), [(a, Tag(0))]);
    assert!(events[0].at > Nanos::from_millis(10));
    bus.abort(a, Tag(1));
    bus.set_mode(b, Nanos::from_millis(20), NodeMode::Active);
    let events = run(&mut bus, LONG);
    assert_eq!(sent_order(&events), [(a, Tag(2)), (b, Tag(3))]);
    assert!(events.iter().all(|event| event.at > Nanos::from_millis(20)), "{events:?}");
}

#[test]
#[should_panic(expected = "bus time goes back")]
fn a_call_with_a_time_that_is_over_ends_the_run() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach("b"));
    bus.request(a, Nanos::from_millis(1), standard(1, &[]), Tag(0));
    assert!(!run(&mut bus, Nanos::from_millis(2)).is_empty());
    bus.cut(b, Nanos::from_millis(1));
}

#[test]
fn recovery_takes_128_gaps_on_a_full_bus() {
    let mut bus = bus();
    let (bad, load) = (bus.attach("bad"), bus.attach("load"));
    bus.attach("listener");
    bus.force_bit_errors(bad, 32);
    bus.request(bad, Nanos::ZERO, standard(0, &[]), Tag(0));
    let mut generator = LoadGenerator::sequenced(load, Id::extended(0x18FF_0000).unwrap());
    generator.start(Nanos::ZERO, &mut bus);
    let (mut off, mut back) = (None, None);
    while let (Some(event), None) = (bus.poll(LONG), back) {
        generator.on_event(&event, &mut bus);
        match event.kind {
            EventKind::StateChanged { state: Confinement::BusOff } if event.node == bad => {
                off = Some(generator.sent());
            }
            EventKind::StateChanged { state: Confinement::ErrorActive } if event.node == bad => {
                back = Some(generator.sent());
            }
            _ => {}
        }
    }
    let frames = back.expect("recovery") - off.expect("bus-off");
    assert!((127..=129).contains(&frames), "one gap of 11 recessive bits per frame: {frames}");
}

#[test]
fn a_cut_wire_makes_a_node_deaf_and_mute_and_mending_lets_it_join() {
    let mut bus = bus();
    let (a, b, c) = (bus.attach("a"), bus.attach("b"), bus.attach("c"));
    bus.cut(b, Nanos::ZERO);
    bus.request(a, Nanos::ZERO, standard(1, &[]), Tag(1));
    bus.request(b, Nanos::ZERO, standard(0, &[]), Tag(2));
    let events = run(&mut bus, Nanos::from_millis(100));
    assert_eq!(sent_order(&events), [(a, Tag(1))]);
    assert!(!events.iter().any(|e| e.node == b && matches!(e.kind, EventKind::Received { .. })));
    assert_eq!(bus.counters(b).transmit, 128, "alone with itself, nobody acknowledges");
    bus.mend(b, Nanos::from_millis(100));
    let events = run(&mut bus, Nanos::from_millis(200));
    assert!(matches!(events[0], Event { node, kind: EventKind::Joined, .. } if node == b));
    assert_eq!(sent_order(&events), [(b, Tag(2))]);
    assert!(events.iter().any(|e| e.node == c && matches!(e.kind, EventKind::Received { .. })));
}

#[test]
fn cutting_the_wire_of_a_transmitter_breaks_its_frame_for_the_others() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach("b"));
    bus.attach("c");
    bus.request(a, Nanos::ZERO, standard(1, &[0; 8]), Tag(0));
    run(&mut bus, Nanos(20 * BIT));
    bus.cut(a, Nanos(20 * BIT));
    let events = run(&mut bus, Nanos::from_millis(2));
    assert!(events.iter().any(|e| e.node == b && matches!(e.kind, EventKind::Error { .. })));
    assert!(!events.iter().any(|e| matches!(e.kind, EventKind::Received { .. })));
}

#[test]
fn a_dominant_short_lets_nobody_through_and_takes_the_transmitter_off() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach("b"));
    bus.request(a, Nanos::ZERO, standard(1, &[1]), Tag(0));
    run(&mut bus, Nanos(30 * BIT));
    bus.short(Nanos(30 * BIT), true);
    bus.request(b, Nanos(40 * BIT), standard(2, &[2]), Tag(1));
    let events = run(&mut bus, Nanos::from_millis(500));
    assert!(sent_order(&events).is_empty());
    assert_eq!(bus.state(a), Confinement::BusOff);
    assert_eq!(bus.state(b), Confinement::ErrorPassive);
    bus.short(Nanos::from_millis(500), false);
    let events = run(&mut bus, Nanos::from_secs(1));
    // Nobody acknowledges b until a has recovered; then a's identifier wins.
    assert_eq!(sent_order(&events), [(a, Tag(0)), (b, Tag(1))]);
}

#[test]
fn a_node_with_the_wrong_bit_rate_disturbs_until_it_is_error_passive() {
    let mut bus = bus();
    let (good, wrong) = (bus.attach("good"), bus.attach("wrong"));
    bus.attach("third");
    bus.set_bitrate(wrong, 500_000);
    bus.request(good, Nanos::ZERO, standard(1, &[1]), Tag(0));
    let events = run(&mut bus, LONG);
    assert_eq!(sent_order(&events), [(good, Tag(0))]);
    assert_eq!(bus.state(wrong), Confinement::ErrorPassive);
    assert!(!events.iter().any(|e| e.node == wrong && matches!(e.kind, EventKind::Received { .. })));
    assert!(bus.counters(good).transmit > 96, "every destroyed frame costs the good node eight");
    bus.request(wrong, LONG, standard(2, &[]), Tag(0));
    let events = run(&mut bus, LONG + LONG);
    assert!(
        events
            .iter()
            .any(|e| e.node == wrong && e.kind == EventKind::StateChanged { state: Confinement::BusOff })
    );
}

#[test]
fn a_clock_that_is_one_percent_off_still_follows() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach("b"));
    bus.set_bitrate(b, 252_500);
    bus.request(a, Nanos::ZERO, standard(1, &[1]), Tag(0));
    assert_eq!(sent_order(&run(&mut bus, LONG)), [(a, Tag(0))]);
}

#[test]
fn a_garbled_reception_is_flagged_and_the_frame_is_repeated() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach("b"));
    bus.attach("c");
    bus.garble_receptions(b, 1);
    bus.request(a, Nanos::ZERO, standard(1, &[1]), Tag(0));
    let events = run(&mut bus, LONG);
    assert!(
        events.iter().any(|e| e.node == b && matches!(e.kind, EventKind::Error { error: BusError::Crc, .. }))
    );
    assert_eq!(sent_order(&events).len(), 1);
    assert_eq!(bus.counters(a).transmit, 7, "+8 for the error, -1 for the good frame");
    assert_eq!(bus.counters(b).receive, 8, "+1, +8 as the first to speak up, -1 for the good frame");
}

#[test]
fn an_aborted_request_goes_away_unless_its_frame_is_on_the_bus() {
    let mut bus = bus();
    let (a, b) = (bus.attach("a"), bus.attach("b"));
    bus.request(a, Nanos::ZERO, standard(1, &[1]), Tag(1));
    bus.request(a, Nanos::ZERO, standard(2, &[2]), Tag(2));
    run(&mut bus, Nanos(10 * BIT));
    assert_eq!(bus.abort(a, Tag(1)), Aborted::InTransmission);
    assert_eq!(bus.abort(a, Tag(2)), Aborted::Removed);
    assert_eq!(bus.abort(a, Tag(3)), Aborted::Unknown);
    assert_eq!(sent_order(&run(&mut bus, LONG)), [(a, Tag(1))]);
    assert_eq!(bus.pending(b), 0);
}

#[test]
fn a_single_shot_is_given_up_after_an_error() {
    let mut bus = bus();
    let a = bus.attach("a");
    bus.request_once(a, Nanos::ZERO, standard(1, &[1]), Tag(1));
    let events = run(&mut bus, LONG);
    assert_eq!(events.last().map(|e| e.kind), Some(EventKind::GivenUp { tag: Tag(1) }));
    assert_eq!(bus.pending(a), 0);
}

#[test]
fn a_late_node_joins_in_the_gap_of_a_full_bus() {
    let mut bus = bus();
    let (load, late) = (bus.attach("load"), bus.attach_off("late"));
    bus.attach("ear");
    let mut generator = LoadGenerator::sequenced(load, Id::standard(0x55).unwrap());
    generator.start(Nanos::ZERO, &mut bus);
    let mut joined = None;
    let mut first = None;
    assert!(run(&mut bus, Nanos(10 * BIT)).is_empty(), "its first frame is under way");
    bus.set_mode(late, Nanos(10 * BIT), NodeMode::Active);
    while let (Some(event), None) = (bus.poll(LONG), first) {
        generator.on_event(&event, &mut bus);
        match event.kind {
            EventKind::Joined => joined = Some(generator.sent()),
            EventKind::Received { frame } if event.node == late => first = Some(frame.data[0]),
            _ => {}
        }
    }
    assert_eq!(joined, Some(1), "after the frame that was under way");
    assert_eq!(first, Some(1), "and hears the next one whole");
}

#[test]
fn back_to_back_load_reaches_the_published_frame_rates() {
    // 131 bits at 250 kbit/s without a stuff bit: 1908 frames/s; 160 bits at most: 1562 frames/s.
    let mut bus = bus();
    let load = bus.attach("load");
    bus.attach("ear");
    let mut generator = LoadGenerator::sequenced(load, Id::extended(0x1555_5555).unwrap());
    generator.start(Nanos::ZERO, &mut bus);
    let (mut next, mut heard) = (0u64, 0u64);
    while let Some(event) = bus.poll(Nanos::from_secs(1)) {
        generator.on_event(&event, &mut bus);
        if let EventKind::Received { frame } = event.kind {
            assert_eq!(u64::from_le_bytes(frame.data), next, "in order, none missing");
            (next, heard) = (next + 1, heard + 1);
        }
    }
    assert!((1_562..=1_908).contains(&heard), "{heard}");
    assert!(bus.stats().busy.0 >= 999_000_000, "100 % load: {}", bus.stats().busy);
}

#[test]
fn a_spaced_generator_keeps_its_period_and_its_limit() {
    let mut bus = bus();
    let load = bus.attach("load");
    bus.attach("ear");
    let mut generator = LoadGenerator::sequenced(load, Id::standard(1).unwrap())
        .spaced_by(Nanos::from_millis(10))
        .limited_to(5);
    generator.start(Nanos::ZERO, &mut bus);
    let mut last = Nanos::ZERO;
    while let Some(event) = bus.poll(LONG) {
        generator.on_event(&event, &mut bus);
        last = event.at;
    }
    assert_eq!(generator.sent(), 5);
    assert!((Nanos::from_millis(40)..Nanos::from_millis(41)).contains(&last), "{last}");
}

#[test]
fn a_replay_keeps_its_times_and_repeats_after_its_period() {
    let mut bus = bus();
    let player = bus.attach("player");
    bus.attach("ear");
    let frame = standard(0x2AA, &[]);
    let recording = vec![(Nanos::from_millis(1), frame), (Nanos::from_millis(5), frame)];
    let mut replay = Replay::new(player, recording).repeated_every(Nanos::from_millis(20));
    replay.start(Nanos::from_millis(100), &mut bus);
    let mut starts = Vec::new();
    while let Some(event) = bus.poll(Nanos::from_millis(150)) {
        replay.on_event(&event, &mut bus);
        if matches!(event.kind, EventKind::Sent { .. }) {
            starts.push((event.at.0 - u64::from(FrameBits::of(&frame).sent()) * BIT) / 1_000_000);
        }
    }
    assert_eq!(starts, [101, 105, 121, 125, 141, 145]);
}

fn scenario(bitrate: u32, requests: &[(u8, u32, u16, u8)]) -> (Vec<Event>, usize) {
    let mut bus = Bus::new(bitrate);
    let nodes: Vec<NodeId> = ["a", "b", "c", "d"].map(|name| bus.attach(name)).to_vec();
    for (index, &(node, at, id, dlc)) in requests.iter().enumerate() {
        let node = usize::from(node) % 4;
        // The identifier's low bits name the node: two nodes never send the same one.
        let frame = standard(id << 2 & 0x7FC | node as u16, &[index as u8; 8][..usize::from(dlc)]);
        bus.request(nodes[node], Nanos(u64::from(at)), frame, Tag(index as u32));
    }
    let events = run(&mut bus, LONG);
    let left = nodes.iter().map(|&node| bus.pending(node)).sum();
    (events, left)
}

proptest! {
    #[test]
    fn every_frame_arrives_once_at_every_other_node_and_time_never_goes_back(
        bitrate in prop_oneof![Just(125_000u32), Just(250_000), Just(333_333), Just(1_000_000)],
        requests in prop::collection::vec((0..4u8, 0..5_000_000u32, 0..0x200u16, 0..=8u8), 0..40),
    ) {
        let (events, left) = scenario(bitrate, &requests);
        prop_assert_eq!(left, 0);
        prop_assert_eq!(sent_order(&events).len(), requests.len());
        let received = events.iter().filter(|e| matches!(e.kind, EventKind::Received { .. })).count();
        prop_assert_eq!(received, 3 * requests.len());
        prop_assert!(events.is_sorted_by_key(|event| event.at));
        prop_assert_eq!(&scenario(bitrate, &requests).0, &events);
    }
}
