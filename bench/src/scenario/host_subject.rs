//! The cluster's logic on the host: the virtual vehicle's frames go straight in, every 10 ms the cluster is ticked.
//!
//! The same instrument as on the chip, fed like there: frames, the own wires from the vehicle's body, the time. There is
//! no bus and no controller: a fault of the bus is nothing but silence, and frames take no time.

use super::line::FoundLine;
use super::name::Signal;
use super::{Action, Answer, BusFault, Name, Place, Subject};
use crate::switches;
use anyhow::Result;
use cluster::kept::Memory;
use cluster::page::key_of;
use cluster::{Button, Buttons, Contacts, Inputs, Instrument, Sound, View};
use protocol_core::generated::SHIPPED_VEHICLES;
use protocol_core::link::Sample;
use protocol_core::model::{Gear, Shown};
use protocol_core::{CanFrame, Millis};
use virtual_vehicle::{Kind, Options, STEP_MS, VirtualVehicle, World};

/// A supply below this is not measured, in volts.
const SUPPLY_MEASURED: f64 = 3.0;

/// An instrument beside a virtual vehicle.
pub struct HostSubject {
    vehicle: VirtualVehicle,
    instrument: Instrument,
    buttons: Buttons,
    faults: Vec<BusFault>,
    sent: Transmitted,
    /// When which sound began.
    sounds: Vec<(u64, Option<Sound>)>,
    now_ms: u64,
}

impl HostSubject {
    /// Switches a vehicle and its cluster on.
    pub fn new(kind: Kind, options: Options) -> Self {
        let mut vehicle = VirtualVehicle::new(kind, options);
        vehicle.over_a_bus();
        let mut instrument = Instrument::searching(SHIPPED_VEHICLES, cluster::Options::default());
        // As the firmware on a board of which the flash is empty.
        instrument.resume(Memory::New);
        Self {
            vehicle,
            instrument,
            buttons: Buttons::default(),
            faults: Vec::new(),
            sent: Transmitted::default(),
            sounds: Vec::new(),
            now_ms: 0,
        }
    }

    fn now(&self) -> Millis {
        Millis(self.now_ms)
    }

    fn step(&mut self) {
        self.vehicle.advance();
        self.now_ms += STEP_MS;
        let is_silent = !self.faults.is_empty();
        let carries = self.bus_carries();
        for sent in self.vehicle.take_frames() {
            if carries {
                self.vehicle.receive(&sent.frame);
            }
            if !is_silent {
                self.instrument.hear(&sent.frame, Millis(self.now_ms));
            }
        }
        let now = self.now();
        self.instrument.tick(&inputs(self.vehicle.world(), self.buttons), now);
        let access = self.instrument.look(|| false, now);
        debug_assert!(super::vehicle(self.vehicle.kind()).is_none_or(|it| it.bitrate == access.bitrate));
        let Self { instrument, vehicle, sent, now_ms, .. } = self;
        while instrument.offer(|frame| {
            if !is_silent {
                vehicle.receive(frame);
                sent.push(*now_ms, *frame);
            }
            true
        }) {}
        let sound = self.instrument.chime(now).map(|chime| chime.sound);
        if self.sounds.last().map(|(_, sound)| *sound) != Some(sound) {
            self.sounds.push((self.now_ms, sound));
        }
    }

    /// The other nodes hear one another: only the cluster's own wires and receptions are at fault, if anything is.
    fn bus_carries(&self) -> bool {
        !self.faults.iter().any(|fault| matches!(fault, BusFault::Short | BusFault::Babble))
    }

    fn view(&self) -> View {
        self.instrument.view(self.now())
    }
}

impl Subject for HostSubject {
    fn place(&self) -> Place {
        Place::Host
    }

    fn advance_to(&mut self, ms: u64) -> Result<()> {
        while self.now_ms + STEP_MS <= ms {
            self.step();
        }
        Ok(())
    }

    fn act(&mut self, action: &Action) -> Result<()> {
        match action {
            Action::Set { path, setting } => self.vehicle.set(path, *setting)?,
            Action::Hold(Button::Next, down) => self.buttons.next = *down,
            Action::Hold(Button::Menu, down) => self.buttons.menu = *down,
            Action::Fault(fault, on) => {
                self.faults.retain(|other| other != fault);
                self.faults.extend(on.then_some(*fault));
            }
            Action::Send(frame) => {
                let Some(frame) = frame.data_frame() else { return Ok(()) };
                if self.bus_carries() {
                    self.vehicle.receive(&frame);
                }
                if self.faults.is_empty() {
                    self.instrument.hear(&frame, Millis(self.now_ms));
                }
            }
        }
        Ok(())
    }

    fn look(&mut self, name: &Name) -> Option<Answer> {
        let view = self.view();
        Some(match name {
            Name::Speed => Answer::of_number(sample(view.speed_kmh)),
            Name::Gear => gear(view.gear),
            Name::Odometer => Answer::Number(f64::from(view.odometer_hectometres) / 10.0),
            Name::Line => Answer::Line(view.line.map(FoundLine::of_view)),
            Name::Unseen => Answer::Line(view.unseen.map(FoundLine::of_view)),
            Name::Below => Answer::Line(view.below.map(FoundLine::of_view)),
            Name::Severity => Answer::word(view.line.map(|line| line.severity).unwrap_or_default().word()),
            Name::Telltale(lamp) => Answer::word(if view.telltales.is_lit(*lamp) { "on" } else { "off" }),
            Name::Countdown => view.hv_off_s.map_or(Answer::word("none"), |s| Answer::Number(s.into())),
            Name::Limp => match view.limp.map(|limp| limp.limit_deciamps) {
                None => Answer::word("none"),
                Some(None) => Answer::word("unknown"),
                Some(Some(deciamps)) => Answer::Number(f64::from(deciamps) / 10.0),
            },
            Name::Page => page(view.page.number()),
            Name::Value(value) => {
                Answer::of_sample(self.instrument.cluster().shown(*value, self.now()).into(), *value)
            }
            Name::Sent(signal) => self.sent.answer(signal, self.now_ms),
            Name::Truth { path, .. } => Answer::of_truth(self.vehicle.readout(path)),
            Name::Sound => self.sound_at(self.now_ms),
            Name::Health(_) | Name::Picture => return None,
        })
    }

    fn sound_at(&self, ms: u64) -> Answer {
        let sound = self.sounds.iter().rev().find(|(at, _)| *at <= ms).and_then(|(_, sound)| *sound);
        Answer::Word(sound.map_or_else(|| "none".into(), |sound| sound.key().to_owned()))
    }

    fn hindsight_ms(&self) -> u64 {
        0
    }
}

/// The last frame of each message that the cluster has sent.
#[derive(Default)]
pub(super) struct Transmitted {
    last: Vec<(u64, CanFrame)>,
}

impl Transmitted {
    /// Cycles without a frame after which its signals are stale.
    const CYCLES: u64 = 3;

    pub(super) fn push(&mut self, at_ms: u64, frame: CanFrame) {
        self.last.retain(|(_, other)| other.id != frame.id);
        self.last.push((at_ms, frame));
    }

    /// Returns what was last sent of a signal.
    pub(super) fn answer(&self, signal: &Signal, now_ms: u64) -> Answer {
        let message = signal.message;
        let Some((at_ms, frame)) = self.last.iter().find(|(_, frame)| frame.id == message.id) else {
            return Answer::word("never");
        };
        if now_ms.saturating_sub(*at_ms) > Self::CYCLES * u64::from(message.cycle_ms.max(10)) {
            return Answer::word("stale");
        }
        let info = &message.signals[signal.index];
        match (message.get)(signal.index, *frame.padded()) {
            None | Some((_, None)) => Answer::word("invalid"),
            Some((raw, Some(counts))) => match info.word(raw) {
                Some(word) => Answer::word(word),
                None => Answer::Number(counts as f64 / f64::from(info.scale.den.max(1))),
            },
        }
    }
}

pub(super) fn gear(gear: Option<Gear>) -> Answer {
    Answer::word(gear.map_or("none", Gear::word))
}

pub(super) fn page(number: u8) -> Answer {
    Answer::word(key_of(number).unwrap_or("unknown"))
}

fn sample(shown: Shown<impl Into<i32>>) -> Sample {
    shown.map(Into::into).into()
}

/// The cluster's own wires, as the board's pins bring them to the firmware.
fn inputs(world: &World, buttons: Buttons) -> Inputs {
    let air = |mpa: f64| (world.kind == Kind::Citybus).then_some((mpa * 100.0).round() as u16);
    Inputs {
        key: None,
        contacts: Contacts::closed(switches::closed(world)),
        unwired: Contacts::closed(switches::SWITCHES.iter().map(|switch| switch.value)).others(),
        supply_decivolts: Some(world.supply.volts)
            .filter(|volts| *volts >= SUPPLY_MEASURED)
            .map(|volts| (volts * 10.0).round() as u16),
        air_front_centimpa: air(world.air.front_mpa),
        air_rear_centimpa: air(world.air.rear_mpa),
        buttons,
        controller: None,
    }
}
