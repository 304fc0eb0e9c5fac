//! The instrument itself: takes frames, inputs and the time, tells what to show, to sound and to send.
//!
//! Owns one of each part and the order in which they run. Every rule is in a part.
//! Source: BUS-R015, BUS-R016, BUS-R049, BUS-R129 with BUS-93, BUS-108, BUS-115; JL-R026, JL-R031, JL-23.

use crate::chime::{Chime, Player, Sound};
use crate::faults::Faults;
use crate::history::Entry;
use crate::inputs::{self, Button, Controller, Inputs, flag};
use crate::lamps::Lamps;
use crate::limp;
use crate::odometer::Odometer;
use crate::own::Conditions;
use crate::page::{CELLS, Contents, Count, Leaf, Page, Pages, Part, ROWS, Situation, parts_of};
use crate::press::{Press, Push};
use crate::reception::{Counters, Facts, MAX_MESSAGES, Nodes, Received, Reception};
use crate::reverse::Reverse;
use crate::settings::Settings;
use crate::sources;
use crate::telltale::{Telltale, Telltales};
use crate::timers::{Options, Timers};
use crate::transmit::{MAX_SENT, Transmit};
use crate::trip::{self, Trip, Trips};
use crate::view::{ActiveFault, Charging, Limp, List, Listed, Sheet, Text, View};
use protocol_core::model::{Gear, Reading, Readings, Severity, Shown, Value};
use protocol_core::vehicle::{Node, Vehicle};
use protocol_core::{CanFrame, Millis};

/// All lamps are lit for this long after start, in milliseconds, so that a dead one is noticed.
const BULB_CHECK_MS: u64 = 3_000;
/// Time that nodes have to send their first frames before one counts as missing, in milliseconds.
const BOOT_MS: u64 = 5_000;
/// Half a period of the heartbeat on the screen, in milliseconds.
const HEARTBEAT_MS: u64 = 500;

/// A battery of which nothing has been heard for this long does not vouch for anybody's copy, in milliseconds.
const BATTERY_HEARD_MS: u64 = 1_000;

/// Versions that the cluster tells the vehicle, 0 to 255 (JL-R026).
const HARDWARE: i32 = 1;
const SOFTWARE: i32 = 1;

/// An instrument cluster for one vehicle.
#[derive(Clone)]
pub struct Cluster {
    vehicle: &'static Vehicle,
    reception: Reception,
    timers: Timers,
    faults: Faults,
    lamps: Lamps,
    reverse: Reverse,
    player: Player,
    odometer: Odometer,
    trips: Trips,
    transmit: Transmit,
    settings: Settings,
    buttons: (Press, Press),
    pages: Pages,
    controller: Option<Controller>,
    conditions: Conditions,
    silent: Nodes,
    /// Time of the first tick.
    started: Option<Millis>,
    /// Time of the first tick for this vehicle.
    listening: Option<Millis>,
}

impl Cluster {
    /// Returns a cluster that has seen nothing yet.
    ///
    /// # Panics
    ///
    /// If the vehicle's tables are longer than [`MAX_MESSAGES`] or [`MAX_SENT`]; in a `static`, while compiling.
    pub const fn new(vehicle: &'static Vehicle) -> Self {
        assert!(vehicle.rx.len() <= MAX_MESSAGES, "too many received messages: raise MAX_MESSAGES");
        assert!(vehicle.tx.len() <= MAX_SENT, "too many sent messages: raise MAX_SENT");
        Self {
            vehicle,
            reception: Reception::new(),
            timers: Timers::new(),
            faults: Faults::new(),
            lamps: Lamps::new(),
            reverse: Reverse::new(),
            player: Player::new(),
            odometer: Odometer::new(),
            trips: Trips::new(),
            transmit: Transmit::new(),
            settings: Settings::new(),
            buttons: (Press::new(), Press::new()),
            pages: Pages::new(),
            controller: None,
            conditions: Conditions { controller_missing: false, restart: None, search: None },
            silent: Nodes::NONE,
            started: None,
            listening: None,
        }
    }

    /// Starts the odometer from a distance that was kept, in 1/8 km; never takes distance away.
    pub fn restore(&mut self, odometer_km8: u32) {
        self.odometer.restore(odometer_km8);
    }

    /// Returns the cluster with what whoever builds it may switch.
    pub const fn with(mut self, options: Options) -> Self {
        self.timers.options = options;
        self
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
            let started = self.listening.unwrap_or(now);
            faults.watch_for_fire(&Facts { vehicle, reception, timers, silent: *silent, started, now });
        }
        received
    }

    /// Takes the inputs and lets time pass; to be called every 10 ms.
    pub fn tick(&mut self, inputs: &Inputs, now: Millis) {
        self.started.get_or_insert(now);
        let listening = *self.listening.get_or_insert(now);
        self.feel(inputs, now);
        self.controller = inputs.controller;
        inputs::file(inputs, &mut self.reception.readings);
        self.silent = self.reception.silent_nodes(self.vehicle, listening, BOOT_MS, now);
        self.measure(now);
        self.decide(inputs, now);
        self.timers.observe(self.vehicle, &self.reception, now);

        let Self { vehicle, reception, timers, faults, lamps, silent, .. } = self;
        let facts = Facts { vehicle, reception, timers, silent: *silent, started: listening, now };
        faults.tick(&facts);
        lamps.tick(&facts);
        self.pages.follow(
            Situation {
                is_alarming: matches!(self.faults.sound(), Some(Sound::Fire | Sound::Stop)),
                plug: self.charging(now).map(|charging| charging.plug),
                speed: self.shown(Value::VehicleSpeed, now),
            },
            now,
        );
        self.play(now);
        self.transmit.start(now);
    }

    /// Adds up distance and energy.
    fn measure(&mut self, now: Millis) {
        let speed = self.shown(Value::VehicleSpeed, now).value();
        let distance = self.shown(Value::VehicleOdometer, now).value();
        self.odometer.drive(speed.filter(|_| distance.is_none()), now);
        if let Some(km8) = distance {
            self.odometer.follow(km8);
        }
        let is_charging = trip::is_charging(|value| self.shown(value, now));
        self.trips.drive(speed, self.power(now).value(), is_charging, now);
    }

    /// Returns the power in 10 mW, positive = out of the battery.
    fn power(&self, now: Millis) -> Shown<i64> {
        trip::power(self.shown(Value::BatteryVoltage, now), self.shown(Value::BatteryCurrent, now))
    }

    /// Files the cluster's own decisions as local values, for the messages that it sends.
    fn decide(&mut self, inputs: &Inputs, now: Millis) {
        let gear = self.shown(Value::VehicleGear, now).value().and_then(Gear::from_number);
        let driving_gear = gear.is_some_and(Gear::drives);
        // Who may be upgraded is known, not guessed (JL-36): speed, gear and drive, each by a fresh value of its own.
        let standing = self.shown(Value::VehicleSpeed, now) == Shown::Value(0);
        let parked = matches!(gear, Some(Gear::N | Gear::P));
        let not_ready = self.shown(Value::VehicleReady, now) == Shown::Value(0);
        let odometer = i32::try_from(self.odometer.km8()).unwrap_or(i32::MAX);
        let decisions = [
            (Value::ClusterDriverLeft, flag(inputs.contacts.is_closed(Value::BodySeatEmpty) && driving_gear)),
            (Value::ClusterUpgradeForbidden, flag(!(standing && parked && not_ready))),
            (Value::ClusterOdometer, Reading::Valid(odometer)),
            (Value::ClusterHardware, Reading::Valid(HARDWARE)),
            (Value::ClusterSoftware, Reading::Valid(SOFTWARE)),
        ];
        for (value, reading) in decisions {
            self.reception.readings.set(Readings::LOCAL, value, reading);
        }
    }

    fn play(&mut self, now: Millis) {
        self.reverse.observe(self.shown(Value::VehicleGear, now), now);
        let reverse = self.reverse.is_steady(now).then_some(Sound::Reverse);
        let buzzer = self.timers.buzzer.sounds(now).then_some(Sound::Buzzer);
        self.player.play([self.faults.sound(), reverse, buzzer], now);
    }

    /// Takes a sample of both buttons.
    fn feel(&mut self, inputs: &Inputs, now: Millis) {
        match self.buttons.0.sample(inputs.buttons.next, now) {
            // A sound ends when the finger comes, not when it goes.
            Some(Push::Begins) if self.silence(now) => self.buttons.0.spend(),
            Some(Push::Short) => self.press(Button::Next, now),
            Some(Push::Long) => self.hold(now),
            Some(Push::Begins) | None => {}
        }
        if self.buttons.1.sample(inputs.buttons.menu, now) == Some(Push::Begins) {
            self.press(Button::Menu, now);
        }
    }

    /// Silences what can be silenced; returns whether there was anything.
    fn silence(&mut self, now: Millis) -> bool {
        let sounds = self.faults.sound().is_some() || self.timers.buzzer.sounds(now);
        if sounds {
            self.faults.acknowledge();
            self.timers.buzzer.silence();
            self.play(now);
        }
        sounds
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

    /// Returns how much there is to turn through.
    fn contents(&self) -> Contents {
        let is_sent = |part: &Part| {
            *part == Part::Bus
                || part.values().iter().any(|&value| self.reception.readings.get(value).is_some())
        };
        let bits = Part::ALL.iter().enumerate().map(|(place, part)| u8::from(is_sent(part)) << place);
        Contents {
            faults: self.faults.count(),
            history: self.faults.history().iter().len(),
            parts: bits.fold(0, |all, bit| all | bit),
        }
    }

    /// Returns the page that is shown, with what only it shows.
    fn page(&self, now: Millis) -> Page {
        match self.pages.leaf() {
            Leaf::Main => Page::Main,
            Leaf::Trip(trip) => Page::Trip(trip),
            Leaf::Energy => Page::Energy,
            Leaf::Faults(part) => {
                use Severity::{Derate, None, Stop, Warn};
                let worst_first = [Stop, Derate, Warn, None].into_iter().flat_map(|severity| {
                    self.active_faults(now).filter(move |fault| fault.severity == severity)
                });
                let rows = worst_first.map(|fault| {
                    let ActiveFault { severity, text, code, count, first, .. } = fault;
                    Listed { severity, text, code, count, at_s: seconds(first) }
                });
                Page::Faults(list(rows, part, self.faults.count()))
            }
            Leaf::History(part) => {
                let entries = self.faults.history().iter();
                let count = entries.len();
                let rows = entries.rev().map(|entry| {
                    let (text, code) = self.remembered(entry);
                    let Entry { severity, count, last, .. } = *entry;
                    Listed { severity, text, code, count, at_s: seconds(last) }
                });
                Page::History(list(rows, part, count))
            }
            Leaf::Technic(place) => {
                let parts = self.contents().parts;
                let part = Part::ALL.get(usize::from(place)).copied().unwrap_or_default();
                let mut cells = [Shown::Never; CELLS];
                if part == Part::Bus {
                    cells.iter_mut().zip(Count::ALL).for_each(|(cell, &count)| *cell = self.count(count));
                } else {
                    let values = part.values().iter();
                    cells.iter_mut().zip(values).for_each(|(cell, &value)| *cell = self.shown(value, now));
                }
                let before = parts & ((1 << place) - 1);
                let (position, count) = (before.count_ones() as u8 + 1, parts.count_ones() as u8);
                Page::Technic(Sheet { part, cells, position, count })
            }
        }
    }

    /// Returns a counter of the bus.
    fn count(&self, count: Count) -> Shown<i32> {
        let counters = self.counters();
        let number = |number: u32| Shown::Value(i32::try_from(number).unwrap_or(i32::MAX));
        let told = |tell: fn(Controller) -> u32| self.controller.map_or(Shown::Never, |it| number(tell(it)));
        match count {
            Count::State => told(|controller| controller.state.map_or(0, |state| state as u32)),
            Count::TransmitErrors => told(|controller| controller.transmit_errors.into()),
            Count::ReceiveErrors => told(|controller| controller.receive_errors.into()),
            Count::Sent => told(|controller| controller.sent),
            Count::Lost => told(|controller| controller.lost),
            Count::Stored => number(counters.stored),
            Count::Unknown => number(counters.unknown),
            Count::Short => number(counters.too_short),
            Count::Damaged => number(counters.damaged),
        }
    }

    /// Returns the next frame that is due; to be called until `None` after every tick.
    ///
    /// The first frames come after the first tick. A frame that the bus does not take is not repeated.
    pub fn transmit(&mut self, now: Millis) -> Option<CanFrame> {
        self.transmit.next(self.vehicle, &self.reception.readings, now)
    }

    /// Returns what may be shown of `value`.
    pub fn shown(&self, value: Value, now: Millis) -> Shown<i32> {
        self.reception.shown(self.vehicle, value, now)
    }

    /// Returns every cell of a stream of the vehicle (`[streams.NAME]`), raw, with its number in the table.
    pub fn cells(&self, stream: &str) -> impl Iterator<Item = (u16, u8)> {
        self.reception.cells(self.vehicle, stream)
    }

    /// Returns the vehicle.
    pub fn vehicle(&self) -> &'static Vehicle {
        self.vehicle
    }

    /// Becomes the cluster of `vehicle`: what was received so far is forgotten, distance and settings stay.
    ///
    /// Nodes get their time to boot once more. Its tables must fit, as in [`Self::new`]; those of the generated vehicles
    /// do, a test proves it.
    pub fn recognise(&mut self, vehicle: &'static Vehicle) {
        self.vehicle = vehicle;
        self.reception = Reception::new();
        self.timers = Timers { options: self.timers.options, ..Timers::new() };
        self.faults = Faults::new();
        self.lamps = Lamps::new();
        self.reverse = Reverse::new();
        self.transmit = Transmit::new();
        self.silent = Nodes::NONE;
        self.listening = None;
    }

    /// Returns what was received so far.
    pub fn counters(&self) -> Counters {
        self.reception.counters()
    }

    /// Returns the total distance in 1/8 km: what is to be kept for [`Self::restore`].
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
        sources::remembered(entry, self.vehicle)
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
        let line = self.conditions.beside(faults, self.faults.misses_a_node(), now);
        let is_bulb_check = self.started.is_none_or(|started| now.since(started) < BULB_CHECK_MS);
        View {
            speed_kmh: shown(Value::VehicleSpeed)
                .map(|speed| (speed.max(0) >> 8).min(u16::MAX.into()) as u16),
            gear: shown(Value::VehicleGear).value().and_then(Gear::from_number),
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
            consumption_whkm: trip::consumption_whkm(shown(Value::VehicleSpeed), power),
            range: self.trips.range(shown, known),
            charging: self.charging(now),
            limp: self.limp(),
            hv_off_s: self.timers.hv_off.countdown_s(now),
            page: self.page(now),
            telltales: if is_bulb_check { Telltales::ALL } else { self.lamps.lit() },
            is_power_limited: self.lamps.lit().is_lit(Telltale::PowerLimited),
            is_charge_low: self.lamps.lit().is_lit(Telltale::LowCharge),
            severity: self.faults.worst().max(line.map_or(Severity::None, |line| line.severity)),
            line,
            heartbeat: (now.0 / HEARTBEAT_MS) % 2 == 1,
            language: self.settings.language,
            theme: self.settings.theme,
        }
    }

    /// Returns what there is to tell while a plug is inserted.
    fn charging(&self, now: Millis) -> Option<Charging> {
        trip::charging(|value| self.shown(value, now), self.reception.last_known(Value::BatteryCapacity))
    }

    /// Returns the charge in 0.1 %: the battery's own word, else the vehicle controller's copy of it (JL-23).
    ///
    /// A silent battery has no charge to copy: the vehicle controller would repeat its last one.
    fn charge(&self, now: Millis) -> Shown<i32> {
        let own = self.shown(Value::BatterySoc, now);
        let is_heard =
            || self.reception.last_sign(Node::Bms).is_some_and(|at| now.since(at) < BATTERY_HEARD_MS);
        match (own, self.shown(Value::VehicleSoc, now)) {
            (Shown::Never | Shown::Stale | Shown::Invalid, copy @ Shown::Value(_)) if is_heard() => copy,
            _ => own,
        }
    }

    /// Returns the limits of limp mode while it holds: concluded, or reported by battery or vehicle (BUS-R115).
    fn limp(&self) -> Option<Limp> {
        let capacity_ah = self.reception.last_known(Value::BatteryCapacity);
        let limps = self.faults.limps(self.vehicle);
        limps.then(|| Limp { limit_deciamps: capacity_ah.and_then(limp::limit_deciamps) })
    }
}

/// Returns whole seconds since power-on.
fn seconds(time: Millis) -> u32 {
    u32::try_from(time.0 / 1_000).unwrap_or(u32::MAX)
}

/// Returns the part of a list, counted from 0; the last one when the list has become shorter than that.
fn list(rows: impl Iterator<Item = Listed>, part: u8, length: usize) -> List {
    let count = parts_of(length);
    let part = part.min(count - 1);
    let mut shown = rows.skip(usize::from(part) * ROWS);
    List { rows: core::array::from_fn(|_| shown.next()), position: part + 1, count }
}
