//! The instrument without its hardware: identification, gate, contacts, what it says of itself.

mod bitrate;
mod identification;
mod rota;
mod trust;

use cluster::own::Restart;
use cluster::{Contacts, Controller, FaultId, Inputs, Instrument, Options, Received, Telltale};
use protocol_core::generated::{SHIPPED_VEHICLES, VEHICLES, c5ev, citybus, jiulong};
use protocol_core::states::Confinement;
use protocol_core::vehicle::{Node, Vehicle};
use protocol_core::{CanFrame, CanId, Millis, Shown, Value};

const TICK: u64 = 10;

/// A frame of the vehicle with its check byte right.
fn frame_of(vehicle: &Vehicle, id: CanId) -> CanFrame {
    let mut data = [0; 8];
    let message = vehicle.index_of(id).and_then(|index| vehicle.rx.get(usize::from(index)));
    if let Some(checksum) = message.and_then(|message| message.checksum) {
        checksum.seal(&mut data);
    }
    CanFrame::full(id, data)
}

/// Identifiers that only this vehicle has.
fn own_ids(vehicle: &'static Vehicle) -> impl Iterator<Item = CanId> {
    let others = move || SHIPPED_VEHICLES.iter().filter(move |other| other.name != vehicle.name);
    vehicle.rx.iter().map(|message| message.id).filter(move |id| others().all(|other| !other.has_id(*id)))
}

/// An instrument, ticked every 10 ms as the firmware does it, and the frames that its controller takes.
struct Run {
    instrument: Instrument,
    inputs: Inputs,
    now: Millis,
    sent: Vec<(u64, CanFrame)>,
    /// The controller takes what it is offered.
    takes: bool,
}

impl Run {
    fn of(instrument: Instrument) -> Self {
        Self { instrument, inputs: Inputs::default(), now: Millis(0), sent: Vec::new(), takes: true }
    }

    fn searching() -> Self {
        Self::of(Instrument::searching(SHIPPED_VEHICLES, Options::default()))
    }

    fn fixed() -> Self {
        Self::of(Instrument::fixed(&citybus::VEHICLE, Options::default()))
    }

    fn hear(&mut self, vehicle: &'static Vehicle, ids: usize) {
        // Twice: what comes once may be anybody's.
        for id in own_ids(vehicle).take(ids).flat_map(|id| [id; 2]) {
            self.instrument.hear(&frame_of(vehicle, id), self.now);
        }
    }

    fn tick(&mut self) {
        self.instrument.tick(&self.inputs, self.now);
        self.instrument.offer(|frame| {
            if self.takes {
                self.sent.push((self.now.0, *frame));
            }
            self.takes
        });
        self.instrument.look(|| false, self.now);
        self.now = self.now.after(TICK);
    }

    fn ticks(&mut self, count: usize) {
        for _ in 0..count {
            self.tick();
        }
    }

    fn line(&self) -> Option<(FaultId, Option<u16>)> {
        self.instrument.view(self.now).line.map(|line| (line.named.fault, line.code))
    }
}

#[test]
fn nothing_is_sent_before_the_vehicle_is_certain_and_no_frame_is_lost_afterwards() {
    for vehicle in SHIPPED_VEHICLES.iter().copied().filter(|vehicle| !vehicle.tx.is_empty()) {
        let mut run = Run::searching();
        run.ticks(100);
        run.hear(vehicle, 2);
        run.ticks(100);
        assert_eq!(run.sent, [], "{}", vehicle.name);
        assert!(!run.instrument.access().may_send);

        run.hear(vehicle, vehicle.rx.len());
        let certain = run.now.0;
        run.ticks(20);
        assert!(run.instrument.access().may_send, "{}", vehicle.name);
        assert_eq!(run.instrument.access().bitrate, vehicle.bitrate);
        let first: Vec<CanId> = run.sent.iter().map(|(_, frame)| frame.id).take(vehicle.tx.len()).collect();
        let table: Vec<CanId> = vehicle.tx.iter().map(|message| message.id).collect();
        assert_eq!(first, table, "each message once, in the order of its first time");
        assert_eq!(run.sent[0].0, certain + TICK, "the controller may send from then on");
        run.ticks(300);
        for message in vehicle.tx {
            let times: Vec<u64> =
                run.sent.iter().filter(|(_, frame)| frame.id == message.id).map(|(at, _)| *at).collect();
            let cycle = u64::from(message.cycle_ms);
            assert!(times.windows(2).all(|pair| pair[1] - pair[0] == cycle), "{}: {times:?}", message.name);
        }
    }
}

#[test]
fn an_instrument_for_one_vehicle_takes_part_from_the_start() {
    for vehicle in VEHICLES {
        let instrument = Instrument::fixed(vehicle, Options::default());
        let access = instrument.access();
        assert_eq!((access.bitrate, access.may_send), (vehicle.bitrate, true), "{}", vehicle.name);
    }
    let mut run = Run::fixed();
    run.tick();
    assert_eq!(run.sent.len(), 1);
    let foreign = own_ids(&c5ev::VEHICLE).next().expect("one of its own");
    assert_eq!(run.instrument.hear(&CanFrame::full(foreign, [0; 8]), run.now), Some(Received::Unknown));
    assert_eq!(run.line(), None, "it searches for nothing and says so by saying nothing");
}

#[test]
fn frames_are_kept_until_the_vehicle_is_known_and_then_counted_and_shown() {
    let mut run = Run::searching();
    let ids: Vec<CanId> = own_ids(&citybus::VEHICLE).collect();
    let heard = |run: &mut Run, id| run.instrument.hear(&frame_of(&citybus::VEHICLE, id), run.now);
    for id in [0, 1, 0, 1, 2] {
        assert_eq!(heard(&mut run, ids[id]), None);
    }
    assert_eq!(run.instrument.cluster().counters().stored, 0);
    assert_eq!(heard(&mut run, ids[2]), Some(Received::Stored), "the sixth frame makes it certain");
    assert_eq!(run.instrument.cluster().counters().stored, 6);
    assert_eq!(run.instrument.cluster().vehicle().name, "citybus");
    assert_eq!(heard(&mut run, ids[0]), Some(Received::Stored));
}

#[test]
fn of_frames_that_the_bus_does_not_take_the_oldest_go() {
    let mut run = Run::fixed();
    run.takes = false;
    // Two messages a second: 8 wait, the 12 before them are gone.
    run.ticks(1_000);
    assert_eq!(run.sent, []);
    run.takes = true;
    run.ticks(8);
    let times: Vec<u64> = run.sent.iter().map(|(at, _)| *at).collect();
    assert_eq!(times, (10_000..10_080).step_by(10).collect::<Vec<_>>(), "one a tick: one transmit buffer");
    let mut steady = Run::fixed();
    steady.ticks(1_001);
    let expected: Vec<CanFrame> = steady.sent.iter().rev().take(8).rev().map(|(_, frame)| *frame).collect();
    assert_eq!(run.sent.iter().map(|(_, frame)| *frame).collect::<Vec<_>>(), expected);
}

#[test]
fn a_bounce_of_a_contact_is_not_seen_and_30_ms_are() {
    let mut run = Run::fixed();
    let door = |run: &Run| run.instrument.cluster().shown(Value::BodyDoorFront, run.now);
    run.ticks(10);
    for closed in [true, true, false, true, false, false, true, true] {
        run.inputs.contacts.set(Value::BodyDoorFront, closed);
        run.tick();
        assert_eq!(door(&run), Shown::Value(0));
    }
    run.tick();
    assert_eq!(door(&run), Shown::Value(1), "the third sample in a row");
    run.inputs.contacts.set(Value::BodyDoorFront, false);
    run.ticks(2);
    assert_eq!(door(&run), Shown::Value(1));
    run.tick();
    assert_eq!(door(&run), Shown::Value(0));
}

#[test]
fn what_is_closed_at_the_start_counts_at_once() {
    let mut run = Run::fixed();
    run.inputs.contacts = Contacts::closed([Value::BodyParkingBrake]);
    run.tick();
    assert_eq!(run.instrument.cluster().shown(Value::BodyParkingBrake, run.now), Shown::Value(1));
    run.ticks(400);
    assert!(run.instrument.view(run.now).telltales.is_lit(Telltale::ParkingBrake));
}

#[test]
fn a_value_that_is_no_contact_s_closes_none() {
    let mut contacts = Contacts::default();
    contacts.set(Value::VehicleSpeed, true);
    assert_eq!(contacts, Contacts::default());
    assert!(!contacts.is_closed(Value::VehicleSpeed));
    assert!(!Contacts::closed(Contacts::ALL.iter().copied()).is_closed(Value::VehicleSpeed));
}

#[test]
fn the_bit_rate_moves_on_errors_while_no_vehicle_is_known_and_nobody_is_asked_later() {
    let mut instrument = Instrument::searching(VEHICLES, Options::default());
    let first = instrument.access().bitrate;
    let moved = instrument.look(|| true, Millis(100)).bitrate;
    assert_ne!(moved, first);
    for id in own_ids(&jiulong::VEHICLE) {
        instrument.hear(&frame_of(&jiulong::VEHICLE, id), Millis(110));
    }
    assert_eq!(instrument.cluster().vehicle().name, "", "these are of the other bit rate");
    assert_eq!(instrument.look(|| true, Millis(110)).bitrate, moved, "frames speak for a rate");
    assert_eq!(instrument.look(|| true, Millis(600)).bitrate, moved);
    assert_eq!(instrument.look(|| true, Millis(610)).bitrate, first, "500 ms after the last frame");
    for id in own_ids(&jiulong::VEHICLE) {
        instrument.hear(&frame_of(&jiulong::VEHICLE, id), Millis(1_010));
    }
    let access = instrument.look(|| unreachable!("the vehicle is known"), Millis(1_020));
    assert_eq!((access.bitrate, access.may_send), (jiulong::VEHICLE.bitrate, true));
}

#[test]
fn it_says_that_its_controller_does_not_answer() {
    let mut run = Run::fixed();
    run.ticks(20);
    assert_eq!(run.line(), None, "without anyone to ask it accuses nobody");
    run.inputs.controller = Some(Controller::default());
    run.tick();
    assert_eq!(run.line(), Some((FaultId::NoController, None)));
    run.inputs.controller =
        Some(Controller { state: Some(Confinement::ErrorActive), ..Controller::default() });
    run.tick();
    assert_eq!(run.line(), None);
}

#[test]
fn it_says_for_ten_seconds_why_it_started() {
    let mut run = Run::fixed();
    run.instrument.restarted(Some(Restart::Panic(Some(42))));
    run.ticks(998);
    assert_eq!(run.line(), Some((FaultId::Restarted, Some(42))));
    run.ticks(3);
    assert_ne!(run.line(), Some((FaultId::Restarted, Some(42))));
}

#[test]
fn it_says_that_it_listens_and_then_whom_it_has_found() {
    let mut run = Run::searching();
    run.ticks(101);
    assert_eq!(run.line(), Some((FaultId::Listening, None)));
    run.hear(&citybus::VEHICLE, 3);
    run.tick();
    assert_eq!(run.line(), Some((FaultId::Identified, None)));
    let said = run.instrument.view(run.now).line.map(|line| line.text.en);
    assert_eq!(said, Some(citybus::VEHICLE.en));
}

#[test]
fn bus_r133_what_was_switched_on_stays_on_when_the_vehicle_is_found() {
    for hvac_alarm in [false, true] {
        let mut run =
            Run::of(Instrument::searching(SHIPPED_VEHICLES, Options { hvac_alarm, ..Options::NONE }));
        run.ticks(10);
        run.hear(&citybus::VEHICLE, 3);
        // Whichever bit it is that says that the air conditioning runs.
        for message in citybus::VEHICLE.rx.iter().filter(|message| message.node == Node::Hvac) {
            for bit in 0..64 {
                if run.instrument.cluster().shown(Value::HvacOn, run.now) != Shown::Value(1) {
                    let frame = CanFrame::full(message.id, (1_u64 << bit).to_le_bytes());
                    run.instrument.hear(&frame, run.now);
                }
            }
        }
        assert_eq!(run.instrument.cluster().shown(Value::HvacOn, run.now), Shown::Value(1));
        run.ticks(1_100);
        let lost = |fault: cluster::view::ActiveFault| fault.named.fault == FaultId::HvacLost;
        assert_eq!(run.instrument.cluster().active_faults(run.now).any(lost), hvac_alarm);
    }
}
