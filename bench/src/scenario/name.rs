//! What a scenario can look at: one name, one place on the screen, on the bus or in the vehicle.
//!
//! Owns the names and what each can be answered with, so that a misspelt expectation is an error and not a failure.
//! Refuses to know how a subject finds the answer.

use super::answer::severity_word;
use super::sound;
use cluster::{Telltale, texts};
use protocol_core::codec::{MessageInfo, SignalInfo};
use protocol_core::generated::{MESSAGES, VEHICLES};
use protocol_core::link::Health;
use protocol_core::model::{Severity, Unit};
use protocol_core::{Value, Vehicle};
use std::fmt;
use virtual_vehicle::{Kind, VirtualVehicle};

/// Something to look at.
#[derive(Clone, Debug, PartialEq)]
pub enum Name {
    /// Road speed as shown, whole km/h.
    Speed,
    /// Gear letter as shown.
    Gear,
    /// Total distance as shown, in km.
    Odometer,
    /// The message line.
    Line,
    /// Severity of the message line.
    Severity,
    /// A lamp.
    Lamp(Telltale),
    /// The sound that plays.
    Sound,
    /// Seconds until the battery opens the high-voltage circuit.
    Countdown,
    /// Current limit of limp mode in A; `unknown` without a rated capacity.
    Limp,
    /// The page of the screen.
    Page,
    /// A value of the model, as the cluster may show it.
    Value(Value),
    /// A signal that the cluster sends.
    Sent(Signal),
    /// A readout of the virtual vehicle.
    Truth(String),
    /// A field of the firmware's health record.
    Health(String),
    /// The whole panel, against a golden picture.
    Picture,
}

/// A signal of a message that the cluster sends.
#[derive(Clone, Copy, Debug)]
pub struct Signal {
    /// The message.
    pub message: &'static MessageInfo,
    /// The signal's place in it.
    pub index: usize,
}

impl PartialEq for Signal {
    fn eq(&self, other: &Self) -> bool {
        self.message.id == other.message.id && self.index == other.index
    }
}

impl Signal {
    fn info(&self) -> &'static SignalInfo {
        &self.message.signals[self.index]
    }
}

/// Pages of the screen, in the order of their numbers; all from the last on are technical.
pub(super) const PAGES: [&str; 7] = ["main", "trip_a", "trip_b", "energy", "faults", "history", "technic"];

const MISSING: [&str; 3] = ["never", "stale", "invalid"];

/// What a name can be answered with.
pub(super) struct Answers {
    /// Numbers.
    pub(super) numbers: bool,
    /// These words.
    pub(super) words: Vec<String>,
}

impl Name {
    /// Reads a name; the error says what there is instead.
    pub(super) fn read(text: &str, kind: Kind) -> Result<Self, String> {
        let plain = [
            ("speed", Self::Speed),
            ("gear", Self::Gear),
            ("odometer", Self::Odometer),
            ("line", Self::Line),
            ("severity", Self::Severity),
            ("sound", Self::Sound),
            ("countdown", Self::Countdown),
            ("limp", Self::Limp),
            ("page", Self::Page),
            ("picture", Self::Picture),
        ];
        if let Some((_, name)) = plain.iter().find(|(word, _)| *word == text) {
            return Ok(name.clone());
        }
        let names = plain.map(|(word, _)| word).join(", ");
        let (group, rest) = text.split_once('.').ok_or_else(|| {
            format!("`{text}` cannot be looked at; there are {names}, lamp.*, sent.*, truth.*, health.* and the values")
        })?;
        match group {
            "lamp" => {
                let lamp = Telltale::ALL.iter().find(|lamp| snake(lamp) == rest);
                let lamps = || Telltale::ALL.iter().map(snake).collect::<Vec<_>>().join(", ");
                lamp.map(|lamp| Self::Lamp(*lamp))
                    .ok_or_else(|| format!("no lamp `{rest}`; there are {}", lamps()))
            }
            "sent" => signal(rest, kind).map(Self::Sent),
            "truth" => {
                let paths = readouts(kind);
                if paths.contains(&rest) {
                    return Ok(Self::Truth(rest.to_owned()));
                }
                Err(format!("{} has no truth `{rest}`; there are {}", kind.name(), paths.join(", ")))
            }
            "health" => {
                let fields = health_fields();
                if fields.iter().any(|field| field == rest) {
                    return Ok(Self::Health(rest.to_owned()));
                }
                Err(format!("no `{rest}` in the health record; there are {}", fields.join(", ")))
            }
            _ => Value::from_path(text).map(Self::Value).ok_or_else(|| {
                let near = Value::ALL.iter().map(|value| value.path());
                let near: Vec<&str> = near.filter(|path| path.split('.').next() == Some(group)).collect();
                match near[..] {
                    [] => format!("no value `{text}`; docs/reference/values.md has all"),
                    _ => format!("no value `{text}`; of {group} there are {}", near.join(", ")),
                }
            }),
        }
    }

    /// Returns what a driver sees and hears, but for numbers that change all the time.
    pub fn on_screen() -> Vec<Self> {
        let plain = [Self::Gear, Self::Line, Self::Sound, Self::Countdown, Self::Limp, Self::Page];
        plain.into_iter().chain(Telltale::ALL.iter().map(|lamp| Self::Lamp(*lamp))).collect()
    }

    /// Returns what it can be answered with.
    pub(super) fn answers(&self) -> Answers {
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let (numbers, words) = match self {
            Self::Speed => (true, words(&MISSING)),
            Self::Gear => (false, words(&["none", "D", "R", "N", "P", "1", "2", "3", "4", "5", "6"])),
            Self::Odometer => (true, words(&["never"])),
            Self::Line => (false, words(&["none"])),
            Self::Severity => {
                let all = [Severity::None, Severity::Warn, Severity::Derate, Severity::Stop];
                (false, words(&all.map(severity_word)))
            }
            Self::Lamp(_) => (false, words(&["off", "on", "never"])),
            Self::Sound => (false, sound::words().map(str::to_owned).collect()),
            Self::Countdown => (true, words(&["none"])),
            Self::Limp => (true, words(&["none", "unknown"])),
            Self::Page => (false, words(&PAGES)),
            Self::Value(value) => {
                let mut all = words(&MISSING);
                all.extend(unit_words(value.unit()));
                (takes_numbers(value.unit()), all)
            }
            Self::Sent(signal) => {
                let mut all = words(&MISSING);
                all.extend(signal.info().values.iter().map(|(_, word)| (*word).to_owned()));
                (true, all)
            }
            Self::Truth(_) => (true, words(&MISSING)),
            Self::Health(_) => {
                let states = ["offline", "error_active", "warning", "error_passive", "bus_off"];
                (
                    true,
                    words(
                        &[&states[..], &["unknown", "power", "pin", "watchdog", "panic", "never"]].concat(),
                    ),
                )
            }
            Self::Picture => (false, Vec::new()),
        };
        Answers { numbers, words }
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lamp(lamp) => write!(f, "lamp.{}", snake(lamp)),
            Self::Value(value) => f.write_str(value.path()),
            Self::Sent(signal) => write!(f, "sent.{}.{}", signal.message.name, signal.info().name),
            Self::Truth(path) => write!(f, "truth.{path}"),
            Self::Health(field) => write!(f, "health.{field}"),
            other => f.write_str(&snake(other)),
        }
    }
}

/// Returns the name of a variant as scenario files have it: `LowCharge` -> `low_charge`.
pub(super) fn snake(variant: impl fmt::Debug) -> String {
    let mut words = String::new();
    for letter in format!("{variant:?}").chars() {
        if letter.is_ascii_uppercase() && !words.is_empty() {
            words.push('_');
        }
        words.push(letter.to_ascii_lowercase());
    }
    words
}

/// Returns what the cluster knows of the vehicle.
pub(super) fn vehicle(kind: Kind) -> Option<&'static Vehicle> {
    VEHICLES.iter().copied().find(|vehicle| vehicle.name == kind.name())
}

/// Returns every text that can stand in the message line of this vehicle.
pub(super) fn line_texts(kind: Kind) -> Vec<&'static str> {
    let vehicle = vehicle(kind);
    let own = vehicle.into_iter().flat_map(|vehicle| vehicle.faults.iter().map(|fault| fault.en));
    let names = VEHICLES.iter().map(|vehicle| vehicle.en);
    let mut all: Vec<&str> = texts::ALL.iter().map(|text| text.en).chain(own).chain(names).collect();
    all.sort_unstable();
    all.dedup();
    all
}

fn signal(rest: &str, kind: Kind) -> Result<Signal, String> {
    let sent: Vec<_> =
        vehicle(kind).map(|vehicle| vehicle.tx).unwrap_or_default().iter().map(|row| row.name).collect();
    let of_vehicle = MESSAGES.iter().find(|(name, _)| *name == kind.name()).map(|(_, messages)| *messages);
    let (name, signal) = rest.split_once('.').unwrap_or((rest, ""));
    let message =
        of_vehicle.into_iter().flatten().find(|message| message.name == name && sent.contains(&name));
    let message =
        message.ok_or_else(|| format!("the cluster does not send `{name}`; it sends {}", sent.join(", ")))?;
    let index = message.signals.iter().position(|info| info.name == signal);
    let index = index.ok_or_else(|| {
        let all: Vec<&str> = message.signals.iter().map(|info| info.name).collect();
        format!("{name} has no signal `{signal}`; there are {}", all.join(", "))
    })?;
    Ok(Signal { message, index })
}

fn readouts(kind: Kind) -> Vec<&'static str> {
    let vehicle = VirtualVehicle::new(kind, virtual_vehicle::Options::default());
    vehicle.readouts().iter().map(|readout| readout.path).collect()
}

/// The names of the record's fields are the record's own.
fn health_fields() -> Vec<String> {
    match serde_json::to_value(Health::default()) {
        Ok(serde_json::Value::Object(fields)) => fields.keys().cloned().collect(),
        _ => Vec::new(),
    }
}

fn takes_numbers(unit: Unit) -> bool {
    unit_words(unit).is_empty() || unit == Unit::Gear
}

/// Words that values of this unit are shown as; none for plain numbers.
fn unit_words(unit: Unit) -> Vec<String> {
    let shown = (-1..=16).map(|counts| unit.show(counts).to_string());
    let is_number = |text: &str| text.split(' ').next().is_some_and(|first| first.parse::<f64>().is_ok());
    let mut words: Vec<String> = shown.filter(|text| !is_number(text)).collect();
    words.sort();
    words.dedup();
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_reads_back_as_itself() {
        let names = [
            "speed",
            "gear",
            "line",
            "severity",
            "sound",
            "countdown",
            "limp",
            "page",
            "odometer",
            "picture",
        ];
        let more = ["lamp.battery_fault", "lamp.ready", "battery.soc", "sent.Meter1.driver_left_seat"];
        for name in names.into_iter().chain(more).chain(["health.can_state"]) {
            match Name::read(name, Kind::Citybus) {
                Ok(read) => assert_eq!(read.to_string(), name),
                Err(error) => assert!(name.starts_with("sent."), "{error}"),
            }
        }
    }

    #[test]
    fn an_unknown_name_is_told_with_what_there_is() {
        let error = |name: &str| Name::read(name, Kind::Citybus).unwrap_err();
        assert!(error("lamp.redy").contains("ready"));
        assert!(error("battery.sock").contains("battery.soc"));
        assert!(error("sent.VCU1.speed").contains("Meter1"));
        assert!(error("health.x").contains("can_state"));
        assert!(error("sped").contains("speed"));
    }
}
