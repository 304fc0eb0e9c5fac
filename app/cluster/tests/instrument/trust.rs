//! Recognition that earns and keeps trust: two vehicles one after the other, two at once, and a small one alone.

use super::{Run, own_ids};
use cluster::{FaultId, Instrument, Options};
use protocol_core::generated::{SHIPPED_VEHICLES, c5ev, citybus, jiulong};
use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, CanId, Millis};

/// Time from the first frame of the right vehicle to the end of the wrong one, in milliseconds.
const BOUND_MS: u64 = 3_000;

/// A frame of the vehicle with its life counter at `count`; the other bytes say `fill`.
fn frame(vehicle: &Vehicle, id: CanId, fill: u8, count: u8) -> CanFrame {
    let mut data = [fill; 8];
    let message = vehicle.index_of(id).and_then(|index| vehicle.rx.get(usize::from(index)));
    if let Some(life) = message.and_then(|message| message.life) {
        let byte = &mut data[usize::from(life.byte)];
        *byte = *byte & !life.mask | count << life.mask.trailing_zeros() & life.mask;
    }
    CanFrame::full(id, data)
}

impl Run {
    /// Hears every message of the vehicle once.
    fn round(&mut self, vehicle: &'static Vehicle, fill: u8) {
        let count = (self.now.0 / 100) as u8;
        for id in own_ids(vehicle) {
            self.instrument.hear(&frame(vehicle, id, fill, count), self.now);
        }
    }

    /// Hears the vehicles for a while, every message 10 times a second.
    fn drive(&mut self, vehicles: &[&'static Vehicle], ms: u64, mut look: impl FnMut(&Self)) {
        for _ in 0..ms / 100 {
            vehicles.iter().for_each(|vehicle| self.round(vehicle, 0));
            for _ in 0..10 {
                self.tick();
                look(self);
            }
        }
    }

    fn name(&self) -> &'static str {
        self.instrument.cluster().vehicle().name
    }

    /// Three messages of the wrong vehicle, again and again, that report whatever bits can.
    fn mislead(&mut self, vehicle: &'static Vehicle) {
        for count in 0..3 {
            for id in own_ids(vehicle).take(3) {
                self.instrument.hear(&frame(vehicle, id, 0x55, count), self.now);
            }
            self.tick();
        }
    }
}

fn pairs() -> impl Iterator<Item = (&'static Vehicle, &'static Vehicle)> {
    let all = SHIPPED_VEHICLES.iter().copied();
    all.clone().flat_map(move |wrong| {
        all.clone().filter(move |right| right.name != wrong.name).map(move |right| (wrong, right))
    })
}

#[test]
fn a_wrong_vehicle_goes_with_all_it_left_when_another_is_certain_and_it_is_silent() {
    for (wrong, right) in pairs() {
        let mut run = Run::searching();
        run.mislead(wrong);
        assert_eq!(run.name(), wrong.name);
        run.ticks(20);
        let before = run.sent.len();
        run.takes = false;
        run.drive(&[right], BOUND_MS, |_| {});
        let case = (wrong.name, right.name);
        assert_eq!(run.name(), right.name, "{case:?}");
        run.takes = true;
        run.drive(&[right], 8_000, |run| {
            let is_old = |name: &str| name == wrong.name;
            assert!(!is_old(run.name()), "{case:?}");
        });
        assert_eq!(run.instrument.cluster().counters().unknown, 0, "{case:?}: only its own frames came");
        let left = run.instrument.cluster().history().filter(|entry| entry.first.0 < 100).count();
        assert_eq!(left, 0, "{case:?}: the history of the wrong one is gone");
        let foreign =
            run.sent[before..].iter().find(|(_, sent)| right.tx.iter().all(|own| own.id != sent.id));
        assert_eq!(foreign, None, "{case:?}: no frame of the wrong one waits in the queue");
        assert_eq!(run.sent.len() > before, !right.tx.is_empty(), "{case:?}: the right one is answered");
        assert_ne!(run.line().map(|line| line.0), Some(FaultId::Doubt), "{case:?}: the doubt is over");
    }
}

#[test]
fn what_was_driven_under_a_wrong_vehicle_does_not_count() {
    let mut run = Run::searching();
    // Speed 0x55: something, whatever the vehicle calls it.
    for _ in 0..300 {
        run.mislead(&citybus::VEHICLE);
    }
    run.drive(&[&jiulong::VEHICLE], 8_000, |_| {});
    assert_eq!(run.name(), "jiulong");
    assert_eq!(run.instrument.cluster().odometer_km8(), 0);
    assert_eq!(run.instrument.view(run.now).odometer_hectometres, 0);
}

#[test]
fn nothing_is_sent_from_the_first_doubt_to_its_end() {
    for (wrong, right) in pairs() {
        let mut run = Run::searching();
        run.mislead(wrong);
        let start = run.now.0 + 110;
        run.drive(&[right], BOUND_MS, |_| {});
        let wrong_tx = |frame: &CanFrame| wrong.tx.iter().any(|own| own.id == frame.id);
        let late = run.sent.iter().find(|(at, frame)| *at > start && wrong_tx(frame));
        assert_eq!(late, None, "{} on a bus of {}", wrong.name, right.name);
    }
}

#[test]
fn two_vehicles_at_once_are_said_for_as_long_as_it_lasts_and_the_first_one_stays() {
    for (first, second) in pairs() {
        let case = (first.name, second.name);
        let mut run = Run::searching();
        run.drive(&[first], 2_000, |_| {});
        assert_eq!(run.name(), first.name);
        run.drive(&[first, second], 1_000, |_| {});
        let sent = run.sent.len();
        let (mut said, mut unsaid_ticks) = (0, 0);
        run.drive(&[first, second], 60_000, |run| {
            let is_said = run.line().is_some_and(|line| line.0 == FaultId::Doubt);
            said += u32::from(is_said);
            unsaid_ticks = if is_said { 0 } else { unsaid_ticks + 1 };
            assert!(unsaid_ticks <= 300, "{case:?}: covered for 3 s");
            assert_eq!(run.name(), first.name);
            assert!(!run.instrument.access().may_send);
        });
        assert!(said > 1_000, "{case:?}: {said}");
        assert_eq!(run.sent.len(), sent, "{case:?}: nothing is sent on a doubtful bus");
        run.drive(&[first], 6_000, |_| {});
        assert_ne!(run.line().map(|line| line.0), Some(FaultId::Doubt), "{case:?}");
        run.drive(&[first], 3_000, |_| {});
        assert_eq!(run.sent.len() > sent, !first.tx.is_empty(), "{case:?}: it sends again");
    }
}

#[test]
fn a_doubt_is_not_covered_by_the_worst_report_of_the_vehicle_found() {
    let mut run = Run::searching();
    run.drive(&[&citybus::VEHICLE], 2_000, |_| {});
    let stop = CanFrame::full(citybus::id::VCU7, [3, 55, 0, 0, 0, 0, 0, 0]);
    let (mut doubt, mut stops) = (0, 0);
    for _ in 0..200 {
        run.round(&citybus::VEHICLE, 0);
        run.instrument.hear(&stop, run.now);
        run.round(&jiulong::VEHICLE, 0);
        for _ in 0..10 {
            run.tick();
            let is_doubt = run.line().is_some_and(|line| line.0 == FaultId::Doubt);
            doubt += u32::from(is_doubt);
            stops += u32::from(!is_doubt && run.line().is_some());
            let severity = run.instrument.view(run.now).severity;
            assert!(run.now.0 < 3_000 || severity == protocol_core::model::Severity::Stop);
        }
    }
    assert!(doubt >= 400 && stops >= 1_200, "doubt {doubt}, stop {stops} of 2000 ticks");
}

#[test]
fn vehicles_that_take_turns_from_the_start_are_a_doubt_and_neither_is_found() {
    let mut run = Run::searching();
    let (a, b): (Vec<CanId>, Vec<CanId>) =
        (own_ids(&citybus::VEHICLE).collect(), own_ids(&jiulong::VEHICLE).collect());
    for turn in 0..600 {
        let count = (turn / 10) as u8;
        run.instrument.hear(&frame(&citybus::VEHICLE, a[turn % a.len()], 0, count), run.now);
        run.instrument.hear(&frame(&jiulong::VEHICLE, b[turn % b.len()], 0, count), run.now);
        run.tick();
    }
    assert_eq!((run.name(), run.sent.len()), ("", 0));
    assert_eq!(run.line().map(|line| line.0), Some(FaultId::Doubt));
}

#[test]
fn a_certain_vehicle_whose_bus_falls_silent_stays_and_stray_frames_of_another_do_not_take_it() {
    let mut run = Run::searching();
    run.drive(&[&citybus::VEHICLE], 2_000, |_| {});
    run.ticks(1_000);
    assert_eq!(run.name(), "citybus", "silence alone is no evidence");
    for id in own_ids(&jiulong::VEHICLE).take(3) {
        run.instrument.hear(&frame(&jiulong::VEHICLE, id, 0, 1), run.now);
        run.ticks(10);
    }
    assert_eq!(run.name(), "citybus", "three frames, each once");
}

#[test]
fn the_wire_with_one_identifier_is_recognised_within_1_2_s_and_never_answered() {
    let mut run = Run::searching();
    for turn in 0..50 {
        run.instrument.hear(&frame(&c5ev::VEHICLE, c5ev::id::VCU_TO_CLUSTER, 0, 0), run.now);
        run.ticks(20);
        assert_eq!(run.name() == "c5ev", run.now.0 > 1_000, "{turn}");
    }
    assert!(!run.instrument.access().may_send);
}

#[test]
fn the_wire_with_one_identifier_replaces_a_wrong_vehicle_that_is_silent() {
    let mut run = Run::searching();
    run.mislead(&jiulong::VEHICLE);
    for _ in 0..16 {
        run.instrument.hear(&frame(&c5ev::VEHICLE, c5ev::id::VCU_TO_CLUSTER, 0, 0), run.now);
        run.ticks(20);
    }
    assert_eq!(run.name(), "c5ev");
    assert!(!run.instrument.access().may_send);
}

#[test]
fn a_vehicle_chosen_when_the_image_is_built_is_never_revoked() {
    let mut run = Run::of(Instrument::fixed(&citybus::VEHICLE, Options::default()));
    run.drive(&[&jiulong::VEHICLE], 20_000, |run| assert_eq!(run.name(), "citybus"));
    assert!(run.instrument.access().may_send);
    assert!(run.now > Millis(0));
}
