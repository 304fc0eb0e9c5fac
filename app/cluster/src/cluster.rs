//! The instrument itself: takes frames, inputs and the time, tells what to show, to sound and to send.
//!
//! Owns one of each part and the order in which they run. Every rule is in a part.
//! Source: BUS-R015, BUS-R016, BUS-R049, BUS-R129 with BUS-93, BUS-108, BUS-115; JL-R026, JL-R031.

use crate::chime::{Chime, Player, Sound};
use crate::debounce::Debounce;
use crate::faults::Faults;
use crate::history::Entry;
use crate::inputs::{self, Button, Inputs, flag};
use crate::lamps::Lamps;
use crate::limp;
use crate::odometer::Odometer;
use crate::reception::{Counters, Facts, MAX_MESSAGES, Nodes, Received, Reception};
use crate::reverse::Reverse;
use crate::settings::Settings;
use crate::telltale::Telltales;
use crate::texts;
use crate::timers::{Options, Timers};
use crate::transmit::{MAX_SENT, Transmit};
use crate::trip::{self, Trip, Trips};
use crate::view::{ActiveFault, Limp, View};
use protocol_core::model::{Gear, Reading, Readings, Shown, Value};
use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, Millis};

/// All lamps are lit for this long after start, in milliseconds, so that a dead one is noticed.
const BULB_CHECK_MS: u64 = 3_000;
/// Time that nodes have to send their first frames before one counts as missing, in milliseconds.
const BOOT_MS: u64 = 5_000;
/// Half a period of the heartbeat on the screen, in milliseconds.
const HEARTBEAT_MS: u64 = 500;

/// What the documents call the loss of the link between battery and vehicle controller.
const LINK_FAULT: &str = "与整车控制器通讯故障";

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
    buttons: (Debounce, Debounce),
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
            buttons: (Debounce::new(), Debounce::new()),
            silent: Nodes::NONE,
            started: None,
            listening: None,
        }
    }

    /// Starts the odometer from a distance that was kept, in 1/8 km; never takes distance away.
    pub fn restore(&mut self, odometer_km8: u32) {
        self.odometer.restore(odometer_km8);
    }

    /// Sets what a workshop may switch.
    pub fn configure(&mut self, options: Options) {
        self.timers.options = options;
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
        if self.buttons.0.pushed(inputs.buttons.next) {
            self.press(Button::Next, now);
        }
        if self.buttons.1.pushed(inputs.buttons.menu) {
            self.press(Button::Menu, now);
        }
        inputs::file(inputs, &mut self.reception.readings);
        self.silent = self.reception.silent_nodes(self.vehicle, listening, BOOT_MS, now);
        self.measure(now);
        self.decide(inputs, now);
        self.timers.observe(self.vehicle, &self.reception, now);

        let Self { vehicle, reception, timers, faults, lamps, silent, .. } = self;
        let facts = Facts { vehicle, reception, timers, silent: *silent, started: listening, now };
        faults.tick(&facts);
        lamps.tick(&facts);
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
        let gear = self.shown(Value::VehicleGear, now).value().and_then(Gear::from_model);
        let driving_gear = matches!(gear, Some(Gear::D | Gear::R | Gear::Forward(_)));
        let standing = self.shown(Value::VehicleSpeed, now) == Shown::Value(0);
        let odometer = i32::try_from(self.odometer.km8()).unwrap_or(i32::MAX);
        let decisions = [
            (Value::ClusterDriverLeft, flag(inputs.seat_empty && driving_gear)),
            (Value::ClusterUpgradeForbidden, flag(!standing || driving_gear)),
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

    /// Takes a push of a button.
    pub fn press(&mut self, button: Button, now: Millis) {
        match button {
            Button::Next if self.faults.sound().is_some() => {
                self.faults.acknowledge();
                self.play(now);
            }
            Button::Next => self.faults.next_line(now),
            Button::Menu => self.settings.advance(),
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
        self.reception.counters(self.vehicle)
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
        let is_bulb_check = self.started.is_none_or(|started| now.since(started) < BULB_CHECK_MS);
        View {
            speed_kmh: shown(Value::VehicleSpeed)
                .map(|speed| (speed.max(0) >> 8).min(u16::MAX.into()) as u16),
            gear: shown(Value::VehicleGear).value().and_then(Gear::from_model),
            soc_percent: shown(Value::BatterySoc).map(|soc| (soc / 10).clamp(0, 100) as u8),
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
            charging: trip::charging(shown, known(Value::BatteryCapacity)),
            limp: self.limp(now),
            hv_off_s: self.timers.hv_off.countdown_s(now),
            telltales: if is_bulb_check { Telltales::ALL } else { self.lamps.lit() },
            severity: self.faults.worst(),
            line: self.faults.line(self.vehicle, &self.timers, now),
            heartbeat: (now.0 / HEARTBEAT_MS) % 2 == 1,
            language: self.settings.language,
            theme: self.settings.theme,
        }
    }

    /// Returns the limits of limp mode while it holds: concluded, or reported by battery or vehicle (BUS-R115).
    fn limp(&self, now: Millis) -> Option<Limp> {
        let limps = |fault: ActiveFault| fault.text == texts::LIMP || fault.text.zh == LINK_FAULT;
        let capacity_ah = self.reception.last_known(Value::BatteryCapacity);
        self.active_faults(now)
            .any(limps)
            .then(|| Limp { limit_deciamps: capacity_ah.and_then(limp::limit_deciamps) })
    }
}
