//! What a scenario can look at: one name, one place on the screen, on the bus or in the vehicle.
//!
//! Owns the names and what each can be answered with, so that a misspelt expectation is an error and not a failure.
//! Refuses to know how a subject finds the answer.

use super::{sound, vehicle};
use cluster::Telltale;
use cluster::page::keys;
use protocol_core::Value;
use protocol_core::codec::{MessageInfo, SignalInfo};
use protocol_core::generated::MESSAGES;
use protocol_core::link::Health;
use protocol_core::model::{Gear, Missing, Severity};
use protocol_core::states::{self, Confinement, ResetReason};
use std::fmt;
use virtual_vehicle::{Kind, Readout, VirtualVehicle};

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
    /// What came and went and was not acknowledged.
    Unseen,
    /// What is milder than the STOP on the line.
    Below,
    /// Severity of the message line.
    Severity,
    /// A telltale.
    Telltale(Telltale),
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
    Truth {
        /// Its name.
        path: &'static str,
        /// What kind of state it is; `None` = a number.
        kind: Option<states::Kind>,
    },
    /// A field of the firmware's health record.
    Health(String),
    /// The whole panel, against a golden picture.
    Picture,
}

/// A signal of a message that the cluster sends.
#[derive(Clone, Copy, Debug)]
pub struct Signal {
    /// Message that carries it.
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

/// Names of one word.
const PLAIN: [(&str, Name); 12] = [
    ("speed", Name::Speed),
    ("gear", Name::Gear),
    ("odometer", Name::Odometer),
    ("line", Name::Line),
    ("unseen", Name::Unseen),
    ("below", Name::Below),
    ("severity", Name::Severity),
    ("sound", Name::Sound),
    ("countdown", Name::Countdown),
    ("limp", Name::Limp),
    ("page", Name::Page),
    ("picture", Name::Picture),
];

/// What a name can be answered with.
pub(super) struct Answers {
    /// Whether a number may be wanted.
    pub(super) numbers: bool,
    /// These words.
    pub(super) words: Vec<String>,
    /// The kind of state whose words are among them.
    pub(super) kind: Option<states::Kind>,
}

impl Answers {
    /// Names the right word for a state that is written as it is known elsewhere.
    pub(super) fn spelling(&self, text: &str) -> Option<String> {
        let meant = self.kind?.meant_by(text)?;
        Some(format!("`{text}` is written `{}` here", meant.word))
    }
}

impl Name {
    /// Reads a name; the error says what there is instead.
    pub(super) fn read(text: &str, kind: Kind) -> Result<Self, String> {
        if let Some((_, name)) = PLAIN.iter().find(|(word, _)| *word == text) {
            return Ok(name.clone());
        }
        let names = PLAIN.map(|(word, _)| word).join(", ");
        let (group, rest) = text.split_once('.').ok_or_else(|| {
            format!("`{text}` cannot be looked at; there are {names}, telltale.*, sent.*, truth.*, health.* and the values")
        })?;
        match group {
            "telltale" => {
                let telltale = Telltale::ALL.iter().find(|telltale| telltale.key() == rest);
                let all = || Telltale::ALL.iter().map(|it| it.key()).collect::<Vec<_>>().join(", ");
                telltale
                    .map(|telltale| Self::Telltale(*telltale))
                    .ok_or_else(|| format!("no telltale `{rest}`; there are {}", all()))
            }
            "sent" => signal(rest, kind).map(Self::Sent),
            "truth" => {
                let readouts = readouts(kind);
                if let Some(&Readout { path, kind, .. }) = readouts.iter().find(|one| one.path == rest) {
                    return Ok(Self::Truth { path, kind });
                }
                let paths: Vec<&str> = readouts.iter().map(|readout| readout.path).collect();
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
        let plain =
            [Self::Gear, Self::Line, Self::Unseen, Self::Sound, Self::Countdown, Self::Limp, Self::Page];
        plain.into_iter().chain(Telltale::ALL.iter().map(|it| Self::Telltale(*it))).collect()
    }

    /// Returns what it can be answered with.
    pub(super) fn answers(&self) -> Answers {
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let missing = || Missing::ALL.iter().map(|missing| missing.word().to_owned()).collect::<Vec<_>>();
        let kind = match self {
            Self::Gear => Some(Gear::KIND),
            Self::Severity => Some(Severity::KIND),
            Self::Value(value) => value.unit().kind(),
            Self::Truth { kind, .. } => *kind,
            _ => None,
        };
        let states = || {
            let states = kind.map(|kind| kind.states).unwrap_or_default();
            states.iter().map(|state| state.word.to_owned()).collect::<Vec<_>>()
        };
        let (numbers, words) = match self {
            Self::Speed => (true, missing()),
            Self::Gear => (false, [words(&["none"]), states()].concat()),
            Self::Odometer => (true, words(&["never"])),
            Self::Line | Self::Unseen | Self::Below => (false, words(&["none"])),
            Self::Severity => (false, states()),
            Self::Telltale(_) => (false, words(&["off", "on", "never"])),
            Self::Sound => (false, sound::words().map(str::to_owned).collect()),
            Self::Countdown => (true, words(&["none"])),
            Self::Limp => (true, words(&["none", "unknown"])),
            Self::Page => (false, keys().map(str::to_owned).collect()),
            Self::Value(_) | Self::Truth { .. } => (kind.is_none(), [missing(), states()].concat()),
            Self::Sent(signal) => {
                let mut all = missing();
                all.extend(signal.info().values.iter().map(|(_, word)| (*word).to_owned()));
                (true, all)
            }
            Self::Health(_) => {
                let mut all = words(&["never"]);
                all.extend(ResetReason::ALL.iter().map(|reason| reason.word().to_owned()));
                let confinement = Confinement::ALL.iter().map(|state| state.word());
                all.extend(confinement.chain([Confinement::OFFLINE]).map(str::to_owned));
                (true, all)
            }
            Self::Picture => (false, Vec::new()),
        };
        Answers { numbers, words, kind }
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Telltale(telltale) => write!(f, "telltale.{}", telltale.key()),
            Self::Value(value) => f.write_str(value.path()),
            Self::Sent(signal) => write!(f, "sent.{}.{}", signal.message.name, signal.info().name),
            Self::Truth { path, .. } => write!(f, "truth.{path}"),
            Self::Health(field) => write!(f, "health.{field}"),
            other => {
                let plain = PLAIN.iter().find(|(_, name)| name == other);
                f.write_str(plain.map_or("", |(word, _)| word))
            }
        }
    }
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

fn readouts(kind: Kind) -> Vec<Readout> {
    VirtualVehicle::new(kind, virtual_vehicle::Options::default()).readouts()
}

/// The names of the record's fields are the record's own.
fn health_fields() -> Vec<String> {
    match serde_json::to_value(Health::default()) {
        Ok(serde_json::Value::Object(fields)) => fields.keys().cloned().collect(),
        _ => Vec::new(),
    }
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
            "unseen",
            "below",
            "severity",
            "sound",
            "countdown",
            "limp",
            "page",
            "odometer",
            "picture",
        ];
        let more =
            ["telltale.battery_fault", "telltale.ready", "battery.soc", "sent.Meter1.driver_left_seat"];
        for name in names.into_iter().chain(more).chain(["health.can_state"]) {
            match Name::read(name, Kind::Citybus) {
                Ok(read) => assert_eq!(read.to_string(), name),
                Err(error) => assert!(name.starts_with("sent."), "{error}"),
            }
        }
    }

    #[test]
    fn a_state_is_answered_with_its_words_and_never_with_a_number() {
        let mut states = 0;
        for &value in Value::ALL {
            let answers = Name::Value(value).answers();
            let Some(kind) = value.unit().kind() else {
                assert!(answers.numbers && answers.kind.is_none(), "{}", value.path());
                continue;
            };
            states += 1;
            assert!(!answers.numbers, "{}", value.path());
            for state in kind.states {
                assert!(
                    answers.words.iter().any(|word| word == state.word),
                    "{} {}",
                    value.path(),
                    state.word
                );
            }
        }
        assert!(states > 40);
    }

    #[test]
    fn a_state_written_as_it_is_known_elsewhere_is_told_with_its_word() {
        let spelling = |name: &str, text: &str| {
            let name = Name::read(name, Kind::Citybus).unwrap_or_else(|error| panic!("{error}"));
            name.answers().spelling(text)
        };
        let written = |text: &str, word: &str| Some(format!("`{text}` is written `{word}` here"));
        assert_eq!(spelling("charge.state", "not charging"), written("not charging", "idle"));
        assert_eq!(spelling("vehicle.mode", "5"), written("5", "limp"));
        assert_eq!(spelling("body.key", "accessory"), written("accessory", "acc"));
        assert_eq!(spelling("truth.vcu.ready", "1"), written("1", "yes"));
        assert_eq!(spelling("charge.state", "chargeing"), None, "a slip is no spelling");
        assert_eq!(spelling("battery.soc", "1"), None);
    }

    #[test]
    fn an_unknown_name_is_told_with_what_there_is() {
        let error = |name: &str| Name::read(name, Kind::Citybus).unwrap_err();
        assert!(error("telltale.redy").contains("ready"));
        assert!(error("battery.sock").contains("battery.soc"));
        assert!(error("sent.VCU1.speed").contains("Meter1"));
        assert!(error("health.x").contains("can_state"));
        assert!(error("sped").contains("speed"));
    }
}
