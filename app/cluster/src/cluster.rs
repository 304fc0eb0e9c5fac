//! The cluster of one vehicle: takes frames, inputs and the time, tells what to show, to sound and to send.
//!
//! Owns one of each part and the order in which they run. Every rule is in a part.
//! Source: BUS-R015, BUS-R016, BUS-R049, BUS-108.

mod pages;

use crate::chime::{Chime, Player, Sound};
use crate::decisions;
use crate::driver::inputs::{self, Button, Controller, Inputs};
use crate::driver::press::{Press, Push};
use crate::driver::settings::Settings;
use crate::facts::Facts;
use crate::faults::arbitration::Faults;
use crate::faults::memory::History;
use crate::faults::{Entry, Named};
use crate::kept::parts::{Bytes, Distance, Part};
use crate::monitors::limp;
use crate::monitors::reverse::Reverse;
use crate::monitors::{Options, Timers};
use crate::navigator::{Pages, Situation};
use crate::own::{Conditions, Traffic};
use crate::reception::{Counters, MAX_MESSAGES, Nodes, Received, Reception};
use crate::start::{self, Start};
use crate::telltales::{Lighting, Telltale, Telltales};
use crate::transmit::{MAX_SENT, Transmit};
use crate::trips::charge;
use crate::trips::odometer::Odometer;
use crate::trips::{self, Trips};
use crate::view::page::{Page, Trip};
use crate::view::{ActiveFault, Charging, Limp, Line, Text, View};
use protocol_core::model::{Gear, Readings, Severity, Shown, Value};
use protocol_core::vehicle::{Node, Vehicle};
use protocol_core::{CanFrame, Millis};

/// Length of a turn in the place of the message line, in milliseconds.
const TURN_MS: u64 = 1_000;
/// Half a period of the heartbeat on the screen, in milliseconds.
const HEARTBEAT_MS: u64 = 500;

/// Silence of everything from which on the wires are the likelier cause, in milliseconds.
const STOPPED_MS: u64 = 1_000;

/// An instrument cluster for one vehicle.
#[derive(Clone)]
pub struct Cluster {
    vehicle: &'static Vehicle,
    reception: Reception,
    timers: Timers,
    faults: Faults,
    lighting: Lighting,
    reverse: Reverse,
    player: Player,
    odometer: Odometer,
    trips: Trips,
    /// Both as they were before any vehicle was recognised.
    before: (Odometer, Trips),
    transmit: Transmit,
    settings: Settings,
    buttons: (Press, Press),
    pages: Pages,
    controller: Option<Controller>,
    conditions: Conditions,
    silent: Nodes,
    /// The seat was left in a driving gear, and neither has ended since.
    driver_left: bool,
    start: Start,
}

impl Cluster {
    /// Returns a cluster that has seen nothing yet.
    ///
    /// # Panics
    ///
    /// If the vehicle's tables are longer than [`MAX_MESSAGES`] or [`MAX_SENT`]; in a `static`, while compiling.
    pub const fn new(vehicle: &'static Vehicle) -> Self {
        Self::with_options(vehicle, Options::NONE)
    }

    /// Returns a cluster that has seen nothing yet, with what whoever builds it may switch.
    ///
    /// # Panics
    ///
    /// As [`Self::new`].
    pub const fn with_options(vehicle: &'static Vehicle, options: Options) -> Self {
        assert!(vehicle.rx.len() <= MAX_MESSAGES, "too many received messages: raise MAX_MESSAGES");
        assert!(vehicle.tx.len() <= MAX_SENT, "too many sent messages: raise MAX_SENT");
        Self {
            vehicle,
            reception: Reception::new(),
            timers: Timers::new(options, vehicle),
            faults: Faults::new(),
            lighting: Lighting::new(),
            reverse: Reverse::new(),
            player: Player::new(),
            odometer: Odometer::new(),
            trips: Trips::new(),
            before: (Odometer::new(), Trips::new()),
            transmit: Transmit::new(),
            settings: Settings::new(),
            buttons: (Press::new(), Press::new()),
            pages: Pages::new(),
            controller: None,
            conditions: Conditions::NONE,
            silent: Nodes::NONE,
            driver_left: false,
            start: Start::new(),
        }
    }

    /// Starts the odometer from a distance in 1/8 km; never takes distance away.
    pub fn restore(&mut self, odometer_km8: u32) {
        self.odometer.restore(odometer_km8);
        self.before.0.restore(odometer_km8);
    }

    /// Returns what is to be kept of a part; empty = it is not the cluster's.
    pub(crate) fn part(&self, part: Part) -> Bytes {
        let of = |bytes: &[u8]| Bytes::from_slice(bytes).unwrap_or_default();
        match part {
            Part::Distance => of(&self.odometer.kept().to_bytes()),
            Part::Trips => self.trips.kept(),
            Part::Settings => of(&self.settings.kept()),
            Part::Vehicle => of(self.vehicle.name.as_bytes()),
            Part::Starts | Part::Workshop | Part::Fault(_) => Bytes::new(),
        }
    }

    /// Goes on from a part that was kept; it stays if the vehicle known now turns out to be a wrong one.
    pub(crate) fn restore_part(&mut self, part: Part, bytes: &[u8]) {
        match part {
            Part::Distance => {
                if let Some(distance) = Distance::from_bytes(bytes) {
                    self.odometer.resume(distance);
                    self.before.0.resume(distance);
                }
            }
            Part::Trips => {
                self.trips.resume(bytes);
                self.before.1.resume(bytes);
            }
            Part::Settings => self.settings.resume(bytes),
            Part::Vehicle | Part::Starts | Part::Workshop | Part::Fault(_) => {}
        }
    }

    /// Takes note that the instrument is new: what it has counted is the whole distance.
    pub(crate) fn start_distance(&mut self) {
        self.odometer.begin();
        self.before.0.begin();
    }

    /// Takes note that the kept distance is lost.
    pub(crate) fn forget_distance(&mut self) {
        self.odometer.forget();
        self.before.0.forget();
    }

    /// Takes a fault of an earlier run.
    pub(crate) fn remember(&mut self, entry: Entry) {
        self.faults.history_mut().remember(entry);
    }

    /// Returns what went wrong, to look at more than once.
    pub(crate) fn remembered_faults(&self) -> &History {
        self.faults.history()
    }

    /// Returns the odometer in 0.1 km, rounded down.
    pub(crate) fn hectometres(&self) -> u32 {
        self.odometer.hectometres()
    }

    /// Takes what the instrument knows of itself: shown from now on.
    pub(crate) fn know(&mut self, conditions: Conditions) {
        self.conditions = conditions;
    }

    /// Sets a trip to zero.
    pub fn reset_trip(&mut self, trip: Trip) {
        self.trips.reset(trip);
    }

    /// Stores what `frame` says; a frame that is not the vehicle's or is too short changes nothing.
    pub fn receive(&mut self, frame: &CanFrame, now: Millis) -> Received {
        let gear_before = self.shown(Value::VehicleGear, now);
        let received = self.reception.receive(self.vehicle, frame, now);
        if received == Received::Stored {
            // Silence that has just ended interrupts R, even if no tick fell into it (BUS-37).
            self.reverse.observe(gear_before, now);
            self.reverse.observe(self.shown(Value::VehicleGear, now), now);
            self.timers.observe(self.vehicle, &self.reception, now);
            let Self { vehicle, reception, timers, faults, silent, .. } = self;
            let started = self.start.listening().unwrap_or(now);
            faults.watch_for_fire(&Facts { vehicle, reception, timers, silent: *silent, started, now });
        }
        received
    }

    /// Takes the inputs and lets time pass; to be called every 10 ms.
    pub fn tick(&mut self, inputs: &Inputs, now: Millis) {
        let listening = self.start.tick(now);
        self.feel(inputs, now);
        self.controller = inputs.controller;
        inputs::file(inputs, &mut self.reception.readings);
        self.reception.judge(self.vehicle, now);
        self.silent = self.reception.silent_nodes(self.vehicle, listening, start::BOOT_MS, now);
        self.measure(now);
        self.decide(now);
        self.timers.observe(self.vehicle, &self.reception, now);

        let Self { vehicle, reception, timers, faults, lighting, silent, .. } = self;
        let facts = Facts { vehicle, reception, timers, silent: *silent, started: listening, now };
        faults.tick(&facts);
        lighting.tick(&facts);
        self.pages.follow(
            Situation {
                is_alarming: self.faults.burns() || self.faults.sound() == Some(Sound::Stop),
                plug: self.charging(now).map(|charging| charging.plug),
                speed: self.shown(Value::VehicleSpeed, now),
            },
            now,
        );
        self.play(now);
    }

    /// Adds up distance and energy.
    fn measure(&mut self, now: Millis) {
        let speed = self.shown(Value::VehicleSpeed, now).value();
        let distance = self.shown(Value::VehicleOdometer, now).value();
        self.odometer.drive(speed.filter(|_| distance.is_none()), now);
        if let Some(km8) = distance {
            self.odometer.follow(km8);
        }
        let is_charging = trips::is_charging(|value| self.shown(value, now));
        self.trips.drive(speed, self.power(now).value(), is_charging, now);
    }

    /// Returns the power in 10 mW, positive = out of the battery.
    fn power(&self, now: Millis) -> Shown<i64> {
        trips::power(self.shown(Value::BatteryVoltage, now), self.shown(Value::BatteryCurrent, now))
    }

    /// Files the cluster's own decisions as local values, for the messages that it sends.
    fn decide(&mut self, now: Millis) {
        let seat = self.shown(Value::BodySeatEmpty, now);
        self.driver_left = decisions::has_left(self.driver_left, seat, self.gear(now));
        let known = decisions::Known {
            driver_left: seat.value().map(|_| self.driver_left),
            odometer_km8: self.odometer.known_km8(),
            may_upgrade: self.timers.options.may_upgrade,
        };
        let decisions = decisions::of(known, |value| self.shown(value, now));
        for (value, reading) in decisions {
            self.reception.readings.set(Readings::LOCAL, value, reading);
        }
    }

    fn play(&mut self, now: Millis) {
        self.reverse.observe(self.shown(Value::VehicleGear, now), now);
        let reverse = self.reverse.is_steady(now).then_some(Sound::Reverse);
        let buzzer = self.timers.buzzer.sounds(self.vehicle.rules.buzzer_ms, now).then_some(Sound::Buzzer);
        self.player.play([self.faults.sound(), reverse, buzzer], now);
    }

    /// Takes a sample of both buttons.
    fn feel(&mut self, inputs: &Inputs, now: Millis) {
        match self.buttons.0.sample(inputs.buttons.next, now) {
            // A button silences when it is pressed, not when it is released.
            Some(Push::Begins) if self.silence(now) => self.buttons.0.spend(),
            Some(Push::Short) => self.press(Button::Next, now),
            Some(Push::Long) => self.hold(now),
            Some(Push::Begins) | None => {}
        }
        if self.buttons.1.sample(inputs.buttons.menu, now) == Some(Push::Begins) {
            self.press(Button::Menu, now);
        }
    }

    /// Silences what sounds and acknowledges what is over; returns whether there was anything.
    fn silence(&mut self, now: Millis) -> bool {
        let sounds =
            self.faults.sound().is_some() || self.timers.buzzer.sounds(self.vehicle.rules.buzzer_ms, now);
        let is_asked = sounds || self.faults.unseen(self.vehicle, now).is_some();
        if is_asked {
            self.faults.acknowledge(now);
            self.timers.buzzer.silence();
            self.play(now);
        }
        is_asked
    }

    /// Takes a short push of a button.
    pub fn press(&mut self, button: Button, now: Millis) {
        match button {
            Button::Next if self.silence(now) => {}
            Button::Next => self.pages.turn(self.contents(), now),
            Button::Menu => self.settings.advance(),
        }
    }

    /// Takes a long push of [`Button::Next`]: a trip that is shown is set to zero, any other page gives way to the main
    /// page.
    pub fn hold(&mut self, now: Millis) {
        if let Some(trip) = self.pages.hold(now) {
            self.reset_trip(trip);
        }
    }

    /// Returns the next frame that is due; to be called until `None` after every tick from which on the cluster may send.
    ///
    /// The first call after a tick starts the cycles. A frame that the bus does not take is not repeated.
    pub fn transmit(&mut self, now: Millis) -> Option<CanFrame> {
        self.start.listening()?;
        self.transmit.start(now);
        self.transmit.next(self.vehicle, &self.reception.readings, now)
    }

    /// Returns what may be shown of `value`.
    pub fn shown(&self, value: Value, now: Millis) -> Shown<i32> {
        self.reception.shown(self.vehicle, value, now)
    }

    /// Returns the vehicle whose frames are decoded; the one without messages until one is identified.
    pub fn vehicle(&self) -> &'static Vehicle {
        self.vehicle
    }

    /// Becomes the cluster of `vehicle`: what was received so far is forgotten, settings stay. What was driven stays if
    /// no vehicle was known; what was driven under a wrong one is not this vehicle's.
    ///
    /// Nodes get their time to boot once more. Its tables must fit, as in [`Self::new`]; those of the generated vehicles
    /// do, a test proves it.
    pub fn recognise(&mut self, vehicle: &'static Vehicle) {
        if self.vehicle.rx.is_empty() {
            self.before = (self.odometer, self.trips.clone());
        } else {
            (self.odometer, self.trips) = self.before.clone();
        }
        self.vehicle = vehicle;
        self.reception = Reception::new();
        self.timers = Timers::new(self.timers.options, vehicle);
        self.faults = Faults::new();
        self.lighting = Lighting::new();
        self.reverse = Reverse::new();
        self.transmit = Transmit::new();
        self.silent = Nodes::NONE;
        self.driver_left = false;
        self.start.of_another_vehicle();
    }

    /// Returns what was received so far.
    pub fn counters(&self) -> Counters {
        self.reception.counters()
    }

    /// Returns the total distance in 1/8 km; `None` = the kept one is lost, and the vehicle has sent none since.
    pub fn known_odometer_km8(&self) -> Option<u32> {
        self.odometer.known_km8()
    }

    /// Returns the distance in 1/8 km, counted from zero if it is not known.
    pub fn odometer_km8(&self) -> u32 {
        self.odometer.km8()
    }

    /// Returns every active fault, whether the line shows it now or not.
    pub fn active_faults(&self, now: Millis) -> impl Iterator<Item = ActiveFault> {
        self.faults.active(self.vehicle, &self.timers, now)
    }

    /// Returns what went wrong since power-on, what came first at the front; see [`Entry::to_bytes`].
    pub fn history(&self) -> impl Iterator<Item = &Entry> {
        self.faults.history().iter()
    }

    /// Returns what is said of a remembered fault, and its code as the driver reads it.
    pub fn remembered(&self, entry: &Entry) -> (Text, Option<u16>) {
        let named = self.named(entry);
        (named.text(self.vehicle), named.printed_code())
    }

    /// Returns a remembered fault by name, at its worst.
    pub fn named(&self, entry: &Entry) -> Named {
        Named::graded(entry.fault, entry.code, entry.severity, self.vehicle)
    }

    /// Returns the sound that plays as of the last tick, and whether it is in a tone or in a pause now.
    pub fn chime(&self, now: Millis) -> Option<Chime> {
        self.player.chime(now)
    }

    /// Returns what is to be shown.
    pub fn view(&self, now: Millis) -> View {
        let shown = |value| self.shown(value, now);
        let voltage = shown(Value::BatteryVoltage);
        let current = shown(Value::BatteryCurrent);
        let power = self.power(now);
        let known = |value| self.reception.last_known(value);
        let faults = self.faults.line(self.vehicle, &self.timers, now);
        let below = self.faults.below(self.vehicle, &self.timers, now);
        let is_alarming = matches!(self.faults.sound(), Some(Sound::Fire | Sound::Stop));
        let page = self.page(now);
        let is_taken_over =
            |line: &Line| is_alarming && line.severity == Severity::Stop && matches!(page, Page::Main);
        let traffic = self.traffic(now);
        let unseen = self.faults.unseen(self.vehicle, now);
        let line = self.conditions.beside(traffic, faults, self.faults.misses_a_node(), self.vehicle, now);
        View {
            speed_kmh: shown(Value::VehicleSpeed)
                .map(|speed| (speed.max(0) >> 8).min(u16::MAX.into()) as u16),
            gear: self.gear(now),
            soc_percent: self.charge(now).map(|soc| (soc / 10).clamp(0, 100) as u8),
            pack_decivolts: voltage,
            pack_deciamps: current,
            power_hectowatts: match power {
                // Where the battery's current is not on this wire, what the motor says of itself is better than nothing.
                Shown::Never => shown(Value::MotorPower).map(|watts| watts / 100),
                power => power.map(|power| (power / 10_000) as i32),
            },
            motor_rpm: shown(Value::MotorSpeed),
            motor_celsius: shown(Value::MotorTemperature),
            inverter_celsius: shown(Value::InverterTemperature),
            cell_millivolts: (shown(Value::BatteryCellMax), shown(Value::BatteryCellMin)),
            cell_celsius: (shown(Value::BatteryTemperatureMax), shown(Value::BatteryTemperatureMin)),
            odometer_hectometres: self.odometer.hectometres(),
            journeys: self.trips.journeys(),
            consumption_whkm: trips::consumption_whkm(shown(Value::VehicleSpeed), power),
            range: self.trips.range(shown, known),
            charging: self.charging(now),
            limp: self.limp(),
            hv_off_s: self.timers.hv_off.countdown_s(now),
            page,
            telltales: if self.start.is_bulb_check(now) { Telltales::ALL } else { self.lit() },
            is_power_limited: self.lighting.lit().is_lit(Telltale::PowerLimited),
            is_charge_low: self.lighting.lit().is_lit(Telltale::LowCharge),
            severity: self.faults.worst().max(line.map_or(Severity::None, |line| line.severity)),
            line,
            unseen,
            says_unseen: says_unseen(line, unseen, now),
            below,
            says_below: below.is_some() && now.0 / TURN_MS % 4 == 3,
            alarm: faults.filter(is_taken_over),
            heartbeat: (now.0 / HEARTBEAT_MS) % 2 == 1,
            language: self.settings.language,
            theme: self.settings.theme,
        }
    }

    fn gear(&self, now: Millis) -> Option<Gear> {
        self.shown(Value::VehicleGear, now).value().and_then(Gear::from_number)
    }

    /// Returns what is known of the bus.
    fn traffic(&self, now: Millis) -> Traffic {
        let last = self.reception.last_heard();
        Traffic {
            has_stopped: last.is_some_and(|last| now.since(last) >= STOPPED_MS) && !self.silent.is_empty(),
            is_doubled: self.reception.doubled(now).is_some(),
        }
    }

    /// Returns the lit telltales: fire is a battery fault, whatever the battery says of its level.
    fn lit(&self) -> Telltales {
        let mut lit = self.lighting.lit();
        if self.faults.burns() {
            lit.set(Telltale::BatteryFault, true);
        }
        lit
    }

    /// Returns what there is to tell while a plug is inserted.
    fn charging(&self, now: Millis) -> Option<Charging> {
        trips::charging(|value| self.shown(value, now), self.reception.last_known(Value::BatteryCapacity))
    }

    /// Returns the charge in 0.1 %.
    fn charge(&self, now: Millis) -> Shown<i32> {
        let silent_ms = self.reception.last_sign(self.vehicle, Node::Bms).map(|at| now.since(at));
        charge::of(self.shown(Value::BatterySoc, now), self.shown(Value::VehicleSoc, now), silent_ms)
    }

    /// Returns the limits of limp mode while it holds: concluded, or reported by battery or vehicle (BUS-R115).
    fn limp(&self) -> Option<Limp> {
        let capacity_ah = self.reception.last_known(Value::BatteryCapacity);
        let limps = self.faults.limps(self.vehicle);
        let limit = |(rule, capacity)| limp::limit_deciamps(rule, capacity);
        limps.then(|| Limp { limit_deciamps: self.vehicle.rules.limp.zip(capacity_ah).and_then(limit) })
    }
}

/// Returns whether the place of the message line is for a fault that is over: alone, or in every second turn beside a milder
/// one that is not.
fn says_unseen(line: Option<Line>, unseen: Option<Line>, now: Millis) -> bool {
    let Some(unseen) = unseen else { return false };
    line.is_none_or(|line| line.severity < unseen.severity && now.0 / TURN_MS % 2 == 1)
}
