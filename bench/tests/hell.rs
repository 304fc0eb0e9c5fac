//! A bus from hell in front of the cluster's logic: nothing healthy may be shown and nothing sent without evidence.
//!
//! The vehicle drives; its frames reach the cluster as they are, or with another vehicle's among them, as filler, cut short,
//! with counters that stand still, in part, or not at all; the cluster is switched off and on. The judge knows which frames
//! came through as they were sent, reads them by the codecs and by nothing of the cluster, and asks of every claim on the
//! screen whether one of them said so not long ago. Virtual time only; the generator is an xorshift with fixed seeds.

use cluster::Inputs;
use cluster::{Instrument, Options, Telltale};
use protocol_core::generated::SHIPPED_VEHICLES;
use protocol_core::model::{Reading, Readings, Shown, Value};
use protocol_core::{CanFrame, Millis, Vehicle};
use std::collections::{BTreeMap, VecDeque};
use virtual_vehicle::{Kind, VirtualVehicle};

/// Virtual seconds per vehicle: an hour.
const SECONDS: u64 = 3_600;
/// A claim may be so much older than its evidence, in milliseconds: the longest time-out and the time in which a counter that
/// stands still or another vehicle on the bus is found out.
const MEMORY_MS: u64 = 10_000;
/// Time in which another vehicle on the bus is found out, in milliseconds.
const FOUND_OUT_MS: u64 = 3_500;
const STEP_MS: u64 = 10;

/// Marsaglia's xorshift of 64 bits.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, below: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % below.max(1)
    }
}

/// What becomes of the frames for a while.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Torment {
    /// They come as they are.
    None,
    /// Another vehicle's come, too.
    Company,
    /// Only another vehicle's come.
    Exchange,
    /// None comes.
    Silence,
    /// Every byte of some is this.
    Filler(u8),
    /// Some repeat what they were at its beginning: counters stand still.
    Stuck,
    /// Some are cut short.
    Short,
    /// Some of the identifiers are lost.
    Lost,
    /// The cluster is switched off and on at the beginning.
    Reset,
}

const TORMENTS: [Torment; 11] = [
    Torment::None,
    Torment::Company,
    Torment::Exchange,
    Torment::Silence,
    Torment::Filler(0xFF),
    Torment::Filler(0xFE),
    Torment::Filler(0x00),
    Torment::Stuck,
    Torment::Short,
    Torment::Lost,
    Torment::Reset,
];

/// What genuine frames of one vehicle said of late: when, READY, speed in 1/256 km/h.
#[derive(Default)]
struct Evidence {
    heard: VecDeque<(u64, Option<bool>, Option<i32>)>,
}

impl Evidence {
    fn hear(&mut self, vehicle: &Vehicle, frame: &CanFrame, now: u64) {
        let Some(index) = vehicle.index_of(frame.id) else { return };
        let Ok(data) = <&[u8; 8]>::try_from(frame.bytes()) else { return };
        let mut readings = Readings::new();
        (vehicle.decode)(index, data, &mut readings);
        let said = |value| match readings.get(value) {
            Some((Reading::Valid(number), _)) => Some(number),
            _ => None,
        };
        self.heard.push_back((
            now,
            said(Value::VehicleReady).map(|ready| ready == 1),
            said(Value::VehicleSpeed),
        ));
        while self.heard.front().is_some_and(|(at, ..)| now - at > MEMORY_MS) {
            self.heard.pop_front();
        }
    }

    fn said_ready(&self, now: u64) -> bool {
        self.heard.iter().any(|(at, ready, _)| now - at <= MEMORY_MS && *ready == Some(true))
    }

    fn said_speed(&self, kmh: u16, now: u64) -> bool {
        let is_it = |speed: i32| (speed.max(0) >> 8) as u16 == kmh;
        self.heard.iter().any(|(at, _, speed)| now - at <= MEMORY_MS && speed.is_some_and(is_it))
    }

    fn is_alive(&self, now: u64) -> bool {
        self.heard.back().is_some_and(|(at, ..)| now - at <= MEMORY_MS)
    }

    /// Whether it is heard now, and has been for long enough that its vehicle is found out.
    fn is_established(&self, now: u64) -> bool {
        let (Some((first, ..)), Some((last, ..))) = (self.heard.front(), self.heard.back()) else {
            return false;
        };
        now - last <= 1_000 && last - first >= FOUND_OUT_MS
    }
}

fn tables(kind: Kind) -> &'static Vehicle {
    SHIPPED_VEHICLES.iter().copied().find(|vehicle| vehicle.name == kind.name()).expect("it is shipped")
}

/// A vehicle that is READY and drives.
fn driving(kind: Kind) -> VirtualVehicle {
    let mut vehicle = VirtualVehicle::new(kind, virtual_vehicle::Options::default());
    vehicle.over_a_bus();
    let settings = [
        ("driver.key", "start"),
        ("driver.parking_brake", "off"),
        ("driver.seat_empty", "off"),
        ("driver.gear", "D"),
        ("driver.target", "40"),
    ];
    for (path, text) in settings {
        let Some(control) = vehicle.controls().find(|control| control.path == path) else { continue };
        let setting = control.read(text).expect("the setting is one");
        vehicle.set(path, setting).expect("the vehicle takes it");
    }
    vehicle
}

fn instrument() -> Instrument {
    let mut instrument = Instrument::searching(SHIPPED_VEHICLES, Options::default());
    instrument.resume(cluster::kept::Memory::New);
    instrument
}

/// Steps a vehicle and returns its frames, each of its nodes hearing the others.
fn frames_of(vehicle: &mut VirtualVehicle) -> Vec<CanFrame> {
    vehicle.advance();
    let frames: Vec<CanFrame> = vehicle.take_frames().into_iter().map(|sent| sent.frame).collect();
    frames.iter().for_each(|frame| vehicle.receive(frame));
    frames
}

#[derive(Default, Debug)]
struct Counts {
    ticks: u64,
    ready: u64,
    speeds: u64,
    sent: u64,
    spoilt: u64,
}

fn live(kind: Kind, seed: u64, seconds: u64) -> Counts {
    let mut dice = Dice(seed);
    let others: Vec<Kind> = Kind::ALL.into_iter().filter(|other| *other != kind).collect();
    let (mut own, mut other) = (driving(kind), driving(others[dice.roll(2) as usize]));
    let mut cluster = instrument();
    let mut evidence: BTreeMap<&str, Evidence> = BTreeMap::new();
    let mut last: BTreeMap<u32, CanFrame> = BTreeMap::new();
    let (mut torment, mut ends, mut victims, mut born) = (Torment::None, 20_000, 0, 0);
    let mut past = Vec::new();
    let mut counts = Counts::default();
    for now in (STEP_MS..=seconds * 1_000).step_by(STEP_MS as usize) {
        if now >= ends {
            torment = TORMENTS[dice.roll(TORMENTS.len() as u64) as usize];
            ends = now + 500 + dice.roll(12_000);
            victims = dice.roll(u64::MAX);
            last.clear();
            past.push((now, torment));
            if torment == Torment::Reset {
                (cluster, born) = (instrument(), now);
            }
        }
        let at = Millis(now - born);
        let mut deliver = |frame: &CanFrame, vehicle: Option<&'static Vehicle>| {
            if let Some(vehicle) = vehicle {
                evidence.entry(vehicle.name).or_default().hear(vehicle, frame, now);
            } else {
                counts.spoilt += 1;
            }
            cluster.hear(frame, at);
        };
        for frame in frames_of(&mut own) {
            let is_victim = victims >> (frame.id.packed().wrapping_mul(0x9E37_79B9) >> 26) & 1 == 1;
            let genuine = Some(tables(kind));
            match torment {
                Torment::Exchange | Torment::Silence => {}
                // Zeros are numbers that the documents define: who sends them says so. Only the bus's document says what a
                // filler byte means (BUS-R008); by the others' 255 is a speed (JL-22).
                Torment::Filler(byte) if is_victim => {
                    let says_so = byte == 0 || kind != Kind::Citybus;
                    deliver(&CanFrame::full(frame.id, [byte; 8]), genuine.filter(|_| says_so));
                }
                Torment::Stuck if is_victim => {
                    let first = !last.contains_key(&frame.id.packed());
                    let stuck = *last.entry(frame.id.packed()).or_insert(frame);
                    // Without a counter nobody can know.
                    let counts = |vehicle: &&Vehicle| {
                        let row = vehicle.index_of(frame.id).map(|index| &vehicle.rx[usize::from(index)]);
                        row.is_some_and(|row| row.life.is_some())
                    };
                    deliver(&stuck, genuine.filter(|vehicle| first || !counts(vehicle)));
                }
                Torment::Short if is_victim => {
                    let length = dice.roll(8) as usize;
                    if let Some(short) = CanFrame::from_slice(frame.id, &frame.bytes()[..length]) {
                        deliver(&short, None);
                    }
                }
                Torment::Lost if is_victim => {}
                _ => deliver(&frame, genuine),
            }
        }
        let is_heard = matches!(torment, Torment::Company | Torment::Exchange);
        for frame in frames_of(&mut other) {
            if is_heard {
                deliver(&frame, Some(tables(other.kind())));
            }
        }
        cluster.tick(&Inputs::default(), at);
        cluster.look(|| false, at);
        let view = cluster.view(at);
        let found = cluster.cluster().vehicle();
        let when = || {
            format!(
                "{} at {now} ms as {}, seed {seed}; of late {:?}",
                kind.name(),
                found.name,
                &past[past.len().saturating_sub(6)..]
            )
        };
        // A silent bus contradicts nothing; a bus on which only another vehicle speaks does.
        let is_another_s =
            evidence.iter().any(|(name, other)| *name != found.name && other.is_established(now));
        let said = evidence.entry(found.name).or_default();
        if view.telltales.is_lit(Telltale::Ready) && view.telltales != cluster::Telltales::ALL {
            assert!(said.said_ready(now), "READY without evidence: {}", when());
            counts.ready += 1;
        }
        if let Shown::Value(kmh) = view.speed_kmh {
            assert!(said.said_speed(kmh, now), "{kmh} km/h without evidence: {}", when());
            counts.speeds += 1;
        }
        let mut sent = Vec::new();
        while cluster.offer(|frame| {
            sent.push(frame.id);
            true
        }) {}
        for id in sent {
            let is_own = said.is_alive(now) || !is_another_s;
            assert!(is_own, "{id:?} sent on a bus without {}: {}", found.name, when());
            assert!(found.tx.iter().any(|message| message.id == id), "{id:?} is not its own: {}", when());
            counts.sent += 1;
        }
        counts.ticks += 1;
    }
    counts
}

#[test]
fn nothing_healthy_is_claimed_and_nothing_sent_without_evidence() {
    for kind in Kind::ALL {
        let counts = live(kind, 0x5EED + kind as u64, SECONDS);
        println!("{}: {counts:?} in {SECONDS} s", kind.name());
        assert!(counts.ready * 5 > counts.ticks && counts.speeds * 5 > counts.ticks, "it drives: {counts:?}");
        assert!(counts.sent > 0 && counts.spoilt > 500, "{counts:?}");
    }
}
