//! A long drive on a full bus: invariants at every tick, around every wrap boundary.
//!
//! A day on each vehicle, cut into pieces that start at each boundary of a counter; `CLUSTER_HOURS=1` makes it shorter.
//! Everything comes from a seed, nothing from the machine's clock.

use cluster::page::Page;
use cluster::{Cluster, Inputs, Key, Sound, Trip, View};
use protocol_core::generated::{c5ev, citybus, example, jiulong};
use protocol_core::model::{Severity, Shown, Value};
use protocol_core::{CanFrame, CanId, Millis, Vehicle};
use std::fmt;

/// Bits of a frame of 8 bytes without stuffing.
const FRAME_BITS: u32 = 131;
/// Ticks in a second.
const TICKS: u32 = 100;

/// A generator of numbers that gives the same for the same seed (Marsaglia, xorshift64).
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, most: u64) -> u64 {
        self.next() % most
    }
}

/// What was shown when an invariant broke; put into words only then.
struct What<'a> {
    vehicle: &'static str,
    now: Millis,
    view: &'a View,
}

impl fmt::Display for What<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {} ms: {:?}", self.vehicle, self.now.0, self.view)
    }
}

/// One vehicle under way: traffic with moods, so that values hold, change, fail and fall silent.
struct Day {
    vehicle: &'static Vehicle,
    cluster: Cluster,
    inputs: Inputs,
    dice: Dice,
    now: Millis,
    /// What each message says until the next mood, `None` = silent.
    said: Vec<Option<[u8; 8]>>,
    frames: u32,
    sent: Vec<u64>,
    last: Option<View>,
    turn: usize,
    life: u8,
}

impl Day {
    fn new(vehicle: &'static Vehicle, start: u64) -> Self {
        Self {
            vehicle,
            cluster: Cluster::new(vehicle),
            inputs: Inputs { key: Some(Key::On), ..Inputs::default() },
            dice: Dice(0x9E37_79B9_7F4A_7C15 ^ start),
            now: Millis(start),
            said: vec![Some([0; 8]); vehicle.rx.len()],
            frames: 0,
            sent: vec![0; vehicle.tx.len()],
            last: None,
            turn: 0,
            life: 0,
        }
    }

    /// Changes what some messages say: mostly zeros and small numbers, sometimes anything, sometimes nothing.
    fn change_mood(&mut self) {
        for said in &mut self.said {
            *said = match self.dice.below(12) {
                0 => None,
                1 => Some(self.dice.next().to_le_bytes()),
                2 => Some((self.dice.next() & self.dice.next() & self.dice.next()).to_le_bytes()),
                3..6 => Some([0; 8]),
                _ => *said,
            };
        }
        let bits = self.dice.next();
        self.inputs.contacts.set(Value::BodySeatEmpty, bits & 1 != 0);
        self.inputs.contacts.set(Value::BodySmoke, bits & 0xF0 == 0);
        self.inputs.buttons.next = bits & 2 != 0;
        self.inputs.buttons.menu = bits & 4 != 0;
        self.inputs.air_front_centimpa = (bits & 8 != 0).then_some((bits >> 8 & 0x7F) as u16);
    }

    fn receive(&mut self) {
        for _ in 0..self.vehicle.bitrate / FRAME_BITS / TICKS {
            self.frames = self.frames.wrapping_add(1);
            self.turn = (self.turn + 1) % (self.said.len() + 2);
            let frame = match (self.said.get(self.turn), self.vehicle.rx.get(self.turn)) {
                (Some(&said), Some(message)) => {
                    let mut data = said.unwrap_or_default();
                    if let Some(life) = message.life {
                        self.life = self.life.wrapping_add(1);
                        data[usize::from(life.byte)] = self.life << life.mask.trailing_zeros();
                    }
                    // A silent message still fills the bus: as somebody else's.
                    let id = if said.is_some() { message.id } else { CanId::standard(0x555) };
                    CanFrame::full(id, data)
                }
                (_, _) => {
                    let id = CanId::extended(self.dice.next() as u32);
                    CanFrame::full(id, self.dice.next().to_le_bytes())
                }
            };
            self.cluster.receive(&frame, self.now);
        }
    }

    fn tick(&mut self) {
        self.receive();
        self.cluster.tick(&self.inputs, self.now);
        let mut at_once = 0u32;
        while let Some(frame) = self.cluster.transmit(self.now) {
            let index =
                self.vehicle.tx.iter().position(|message| message.id == frame.id).expect("in its table");
            assert_eq!(at_once & 1 << index, 0, "twice at once");
            at_once |= 1 << index;
            self.sent[index] += 1;
        }
        if self.now.0.is_multiple_of(100) {
            self.check();
        }
        self.now = self.now.after(10);
    }

    fn check(&mut self) {
        let (now, view) = (self.now, self.cluster.view(self.now));
        let what = What { vehicle: self.vehicle.name, now, view: &view };
        match view.line {
            Some(line) => {
                assert_eq!(line.severity, view.severity, "a lower severity hides a higher one: {what}");
                assert!((1..=line.count).contains(&line.position), "{what}");
                assert!(!line.text.zh.is_empty() && !line.text.en.is_empty(), "{what}");
            }
            None => assert_eq!(view.severity, Severity::None, "{what}"),
        }
        // A sound has a cause, and fire always sounds.
        let chime = self.cluster.chime(now).map(|chime| chime.sound);
        let worst = self.cluster.active_faults(now).map(|fault| fault.severity).max().unwrap_or_default();
        match chime {
            Some(Sound::Stop) => assert_eq!(worst, Severity::Stop, "{what}"),
            Some(Sound::Derate) => assert!(worst >= Severity::Derate, "{what}"),
            Some(Sound::Warn) => assert!(worst >= Severity::Warn, "{what}"),
            Some(Sound::Buzzer) => {
                assert_eq!(self.cluster.shown(Value::VehicleBuzzer, now), Shown::Value(1), "{what}");
            }
            Some(Sound::Fire | Sound::Reverse) | None => {}
        }
        assert!(
            self.cluster
                .history()
                .all(|entry| entry.count > 0 && entry.first <= entry.last && entry.last <= now)
        );
        if let Some(last) = self.last {
            assert!(view.odometer_hectometres >= last.odometer_hectometres, "never backwards: {what}");
            for ((trip, before), name) in view.journeys.iter().zip(&last.journeys).zip([Trip::A, Trip::B]) {
                let grows =
                    trip.hectometres >= before.hectometres && trip.used_watthours >= before.used_watthours;
                let is_shown = [view.page, last.page].contains(&Page::Trip(name));
                assert!(
                    grows || is_shown && trip.hectometres == 0,
                    "only a trip that is shown is reset: {what}"
                );
            }
        }
        self.last = Some(view);
    }

    fn drive(&mut self, ms: u64) {
        let start = self.now;
        while self.now.since(start) < ms {
            if self.dice.below(300) == 0 {
                self.change_mood();
            }
            self.tick();
        }
        let counters = self.cluster.counters();
        let counted = counters.stored.wrapping_add(counters.unknown).wrapping_add(counters.too_short);
        assert_eq!(counted.wrapping_add(counters.damaged), self.frames, "every frame is counted once");
        for (message, &sent) in self.vehicle.tx.iter().zip(&self.sent) {
            let due = ms / u64::from(message.cycle_ms);
            assert!(sent.abs_diff(due) <= 1, "{}: {sent} of {due}", message.name);
        }
    }
}

fn live_through_a_day(vehicle: &'static Vehicle) {
    let hours: u64 = std::env::var("CLUSTER_HOURS").ok().and_then(|hours| hours.parse().ok()).unwrap_or(24);
    // Power-on; 16, 24, 31 and 32 bits of milliseconds, 32 and 52 bits of microseconds, 40 bits of the history.
    let boundaries: [u64; 8] =
        [0, 1 << 16, 1 << 24, 1 << 31, 1 << 32, (1 << 32) / 1_000, (1 << 52) / 1_000, 1 << 40];
    let piece = hours * 3_600_000 / boundaries.len() as u64 / 10 * 10;
    for boundary in boundaries {
        Day::new(vehicle, boundary.saturating_sub(piece / 2) / 10 * 10).drive(piece);
    }
}

// One test each, so that they run side by side.

#[test]
fn a_day_of_the_bus_on_a_full_bus_breaks_no_invariant() {
    live_through_a_day(&citybus::VEHICLE);
}

#[test]
fn a_day_of_jiulong_on_a_full_bus_breaks_no_invariant() {
    live_through_a_day(&jiulong::VEHICLE);
}

#[test]
fn a_day_of_c5ev_on_a_full_bus_breaks_no_invariant() {
    live_through_a_day(&c5ev::VEHICLE);
}

#[test]
fn a_day_of_the_example_on_a_full_bus_breaks_no_invariant() {
    live_through_a_day(&example::VEHICLE);
}
