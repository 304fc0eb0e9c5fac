//! Every kind of source side by side, over every sequence of a small world, against a naive statement.
//!
//! The statement keeps what was heard at each tick and asks all of it; the cluster keeps a set and updates it. They
//! share no code. What the vehicle and the battery say of each other is lived through in `rules/worlds.rs`.

use crate::support::probe::*;
use crate::support::*;
use cluster::Sound;
use protocol_core::model::Value as V;
use protocol_core::vehicle::Node;
use protocol_core::{Millis, Severity};

/// One step of a world: what changes. `None` = the sender falls silent.
#[derive(Clone, Copy, Debug)]
enum Event {
    /// Level and code, rotating.
    Charger(Option<(i32, i32)>),
    /// Alarm bits.
    Alarms(Option<i32>),
    /// State of a component that prints no level.
    Steering(Option<bool>),
    /// Level without a code, of a sender that is missed.
    Vehicle(Option<i32>),
    /// The cluster's own wire.
    Smoke(bool),
    /// The code that latches.
    Fire(bool),
}

use Event::{Alarms, Charger, Fire, Smoke, Steering, Vehicle};

/// What is known of every source at one tick; `None` = its last word is too old.
#[derive(Clone, Copy, Debug)]
struct Moment {
    charger: Option<(i32, i32)>,
    alarms: Option<i32>,
    steering: Option<bool>,
    vehicle: Option<i32>,
    smoke: bool,
    fire: bool,
}

const HEALTHY: Moment = Moment {
    charger: Some((0, 0)),
    alarms: Some(0),
    steering: Some(false),
    vehicle: Some(0),
    smoke: false,
    fire: false,
};

/// Text, code and severity.
type Line = (&'static str, Option<u16>, Severity);

/// States which faults are active after these moments.
fn stated(moments: &[Moment]) -> Vec<Line> {
    let Some(now) = moments.last() else { return Vec::new() };
    let mut lines = Vec::new();
    // Without a code: what its sender last said, and after silence only if that was STOP.
    let last_level = moments.iter().rev().find_map(|moment| moment.vehicle).unwrap_or(0);
    if last_level == 3 || now.vehicle.is_some_and(|level| level > 0) {
        lines.push(("System fault level 3", None, Severity::from_model(last_level)));
    }
    if now.vehicle.is_none() {
        lines.push(("No communication: VCU", None, Severity::Derate));
    }
    for code in [5, 6] {
        lines.extend(charger(moments, code).map(|severity| ("Charger fault", Some(code as u16), severity)));
    }
    let last_bits = moments.iter().rev().find_map(|moment| moment.alarms).unwrap_or(0);
    if now.alarms.is_some() && last_bits & 0b010 != 0 {
        lines.push(("Alarm 2", None, Severity::Derate));
    }
    if last_bits & 0b100 != 0 {
        lines.push(("Alarm 3", None, Severity::Stop));
    }
    // As bad as what the vehicle reported in the same moment, at least WARN.
    if let Some(then) = moments.iter().rev().find(|moment| moment.steering.is_some())
        && then.steering == Some(true)
    {
        let severity = Severity::from_model(then.vehicle.unwrap_or(0)).max(Severity::Warn);
        if now.steering.is_some() || severity == Severity::Stop {
            lines.push(("Steering assistance fault", None, severity));
        }
    }
    if now.smoke {
        lines.push(("Smoke alarm", None, Severity::Stop));
    }
    lines
}

/// States how bad a code of the charger stands, `None` = it is not active.
fn charger(moments: &[Moment], code: i32) -> Option<Severity> {
    let is_of_code = |moment: &Moment| moment.charger.is_some_and(|(level, said)| level > 0 && said == code);
    let last = moments.iter().rposition(is_of_code)?;
    let (level, _) = moments[last].charger?;
    let after = &moments[last + 1..];
    let taken_back = after.iter().any(|moment| match moment.charger {
        Some((later, _)) => later < level,
        None => level < 3,
    });
    // Ten seconds of other words; silence does not count.
    let spoke = after.iter().rposition(|moment| moment.charger.is_some());
    let forgotten = spoke.is_some_and(|at| (at as u64 + 1) * CYCLE >= 10_000);
    (!taken_back && !forgotten).then(|| Severity::from_model(level))
}

#[derive(Clone)]
struct World {
    drive: Drive,
    /// What every source says from now on.
    said: Moment,
    /// When charger, alarms, steering and vehicle spoke last.
    heard: [Millis; 4],
    moments: Vec<Moment>,
    past: Vec<(Event, u64)>,
}

impl World {
    fn new() -> Self {
        let drive = healthy();
        let heard = [drive.now; 4];
        let mut world = Self { drive, said: HEALTHY, heard, moments: Vec::new(), past: Vec::new() };
        for event in [Charger(Some((0, 0))), Alarms(Some(0)), Steering(Some(false)), Vehicle(Some(0))] {
            world.live(event, CYCLE);
        }
        world.past.clear();
        world
    }

    /// Lives through one step and compares at its first and at its last ticks.
    fn live(&mut self, event: Event, ms: u64) {
        self.past.push((event, ms));
        self.say(event);
        let ticks = ms / CYCLE;
        for tick in 0..ticks {
            let now = self.drive.now;
            let known = self.known(now);
            self.moments.push(known);
            self.drive.run_by(CYCLE, CYCLE);
            if tick < 2 || tick + 2 >= ticks {
                self.compare(now);
            }
        }
    }

    fn say(&mut self, event: Event) {
        let (drive, said) = (&mut self.drive, &mut self.said);
        let mut speaks = |node: Node, words: Option<&[(V, i32)]>| {
            drive.speak(node);
            match words {
                None => drive.hush(node),
                Some(words) => words.iter().for_each(|&(value, number)| drive.keep(node, value, number)),
            }
        };
        match event {
            Charger(words) => {
                said.charger = words;
                let words =
                    words.map(|(level, code)| [(V::ChargerFaultLevel, level), (V::ChargerFaultCode, code)]);
                speaks(Node::Charger, words.as_ref().map(|words| &words[..]));
            }
            Alarms(bits) => {
                said.alarms = bits;
                speaks(
                    Node::Inverter,
                    bits.map(|bits| [(V::BatteryAlarms, bits)]).as_ref().map(|words| &words[..]),
                );
            }
            Steering(failed) => {
                said.steering = failed;
                let words = failed.map(|failed| [(V::SteeringState, 1 + i32::from(failed))]);
                speaks(Node::Steering, words.as_ref().map(|words| &words[..]));
            }
            Vehicle(level) => {
                said.vehicle = level;
                let words = level.map(|level| [(V::VehicleFaultLevel, level)]);
                speaks(Node::Vcu, words.as_ref().map(|words| &words[..]));
            }
            Smoke(smoke) => {
                said.smoke = smoke;
                drive.inputs.contacts.set(V::BodySmoke, smoke);
            }
            Fire(burns) => {
                said.fire |= burns;
                drive.keep(Node::Bms, V::BatteryFaultCode, if burns { FIRE_CODE } else { 0 });
            }
        }
    }

    /// Returns what is known at the next tick: the last word of each source until its time-out.
    fn known(&mut self, now: Millis) -> Moment {
        let said = self.said;
        let speaks =
            [said.charger.is_some(), said.alarms.is_some(), said.steering.is_some(), said.vehicle.is_some()];
        for (heard, _) in self.heard.iter_mut().zip(speaks).filter(|(_, speaks)| *speaks) {
            *heard = now;
        }
        let last = self.moments.last().copied().unwrap_or(HEALTHY);
        let [charger, alarms, steering, vehicle] = self.heard.map(|heard| now.since(heard) < TIMEOUT);
        Moment {
            charger: said.charger.or(last.charger.filter(|_| charger)),
            alarms: said.alarms.or(last.alarms.filter(|_| alarms)),
            steering: said.steering.or(last.steering.filter(|_| steering)),
            vehicle: said.vehicle.or(last.vehicle.filter(|_| vehicle)),
            smoke: said.smoke,
            fire: said.fire,
        }
    }

    fn compare(&self, now: Millis) {
        let when = || format!("after {:?}", self.past);
        let cluster = &self.drive.cluster;
        let fire = ("FIRE: stop, get everyone out", Some(FIRE_CODE as u16), Severity::Stop);
        let mut stated = stated(&self.moments);
        // Once reported, by whatever route, fire is active until power-off.
        stated.extend(self.said.fire.then_some(fire));
        stated.sort();
        let mut active: Vec<Line> =
            cluster.active_faults(now).map(|fault| (fault.text.en, fault.code, fault.severity)).collect();
        active.sort();
        assert_eq!(active, stated, "{}", when());
        let view = cluster.view(now);
        let line = view.line.map(|line| (line.text.en, line.code, line.severity));
        if self.said.fire {
            assert_eq!((view.severity, line), (Severity::Stop, Some(fire)), "BUS-116: {}", when());
            assert_eq!(cluster.chime(now).map(|chime| chime.sound), Some(Sound::Fire), "{}", when());
            return;
        }
        let worst = stated.iter().map(|line| line.2).max().unwrap_or_default();
        let lines: Vec<_> = stated.iter().filter(|line| line.2 == worst).collect();
        assert_eq!(view.severity, worst, "{}", when());
        assert_eq!(view.line.map_or(0, |line| usize::from(line.count)), lines.len(), "{}", when());
        assert!(line.is_none_or(|line| lines.contains(&&line)), "{line:?} {}", when());
    }
}

/// Lives through every sequence of `depth` events, each followed by each of the times.
fn every_sequence(events: &[Event], times: &[u64], depth: u32) {
    fn live_on(world: &World, events: &[Event], times: &[u64], depth: u32) {
        for &event in events {
            for &ms in times {
                let mut next = world.clone();
                next.live(event, ms);
                if depth > 1 {
                    live_on(&next, events, times, depth - 1);
                }
            }
        }
    }
    live_on(&World::new(), events, times, depth);
}

const EVENTS: [Event; 16] = [
    Charger(Some((0, 0))),
    Charger(Some((1, 5))),
    Charger(Some((3, 6))),
    Charger(None),
    Alarms(Some(0)),
    Alarms(Some(0b010)),
    Alarms(Some(0b110)),
    Alarms(None),
    Steering(Some(false)),
    Steering(Some(true)),
    Steering(None),
    Vehicle(Some(0)),
    Vehicle(Some(3)),
    Vehicle(None),
    Smoke(true),
    Fire(true),
];

#[test]
fn every_sequence_of_three_events_of_every_kind_is_shown_as_stated() {
    let ends = [Smoke(false), Fire(false)];
    let events: Vec<Event> = EVENTS.into_iter().chain(ends).collect();
    every_sequence(&events, &[100, 600], 3);
}

#[test]
fn every_sequence_of_four_events_of_every_kind_is_shown_as_stated() {
    every_sequence(&EVENTS, &[600], 4);
}

#[test]
fn every_silence_around_its_boundary_is_shown_as_stated() {
    let silences = [Charger(None), Alarms(None), Steering(None), Vehicle(None)];
    let events: Vec<Event> =
        EVENTS.into_iter().filter(|event| !matches!(event, Fire(_) | Smoke(_))).collect();
    for cause in [Charger(Some((3, 6))), Alarms(Some(0b110)), Steering(Some(true)), Vehicle(Some(3))] {
        let mut world = World::new();
        world.live(cause, CYCLE);
        for silence in silences {
            for ms in [400, 500, 600] {
                let mut world = world.clone();
                world.live(silence, ms);
                for &event in &events {
                    let mut world = world.clone();
                    world.live(event, CYCLE);
                    world.live(Steering(Some(true)), 2 * CYCLE);
                }
            }
        }
    }
}

#[test]
fn every_rotation_of_a_charger_s_codes_is_shown_as_stated() {
    let events = [
        Charger(Some((0, 5))),
        Charger(Some((2, 5))),
        Charger(Some((2, 6))),
        Charger(Some((3, 6))),
        Charger(None),
    ];
    every_sequence(&events, &[100, 9_900, 10_000], 3);
}
