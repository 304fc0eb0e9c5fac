//! What a person may change in the vehicle: one table for the page, the scenarios and the command line.
//!
//! A control is a row: its name, its words, its range, and how it is read and written in the [`World`]. Refuses to know
//! what a setting leads to.

use crate::world::World;
use std::fmt;

/// What is set: a number, a word's index or 0/1; `None` = left to the vehicle.
pub type Setting = Option<f64>;

/// One word of a choice; its index is the setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// As written in scenario files: `reverse`.
    pub word: &'static str,
    /// In simplified Chinese.
    pub zh: &'static str,
    /// In English.
    pub en: &'static str,
}

/// A word that is written like this, in Chinese and in English.
pub(crate) const fn word(word: &'static str, zh: &'static str, en: &'static str) -> Word {
    Word { word, zh, en }
}

/// What settings a control takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Takes {
    /// 0 = off, 1 = on.
    Flag,
    /// One of these words.
    Choice(&'static [Word]),
    /// A number.
    Number {
        /// Smallest.
        min: f64,
        /// Largest.
        max: f64,
        /// Distance from one to the next that is worth telling apart.
        step: f64,
        /// Unit, for example `%`.
        unit: &'static str,
    },
}

/// Where a control stands on the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Group {
    /// Key, pedals, gear, seat.
    Driver,
    /// Doors, lights.
    Body,
    /// Slope, air temperature.
    Road,
    /// Plug, pantograph.
    Charging,
    /// Cells, contactors, sensors of the battery.
    Battery,
    /// Motor and its controller.
    Motor,
    /// Converter, pumps, air conditioning, insulation.
    Parts,
    /// Nodes that fall silent, frames that stop.
    Links,
}

/// One thing that a person may change.
#[derive(Clone, Copy)]
pub struct Control {
    /// Public name: `driver.gear`.
    pub path: &'static str,
    /// What it is called in simplified Chinese.
    pub zh: &'static str,
    /// What it is called in English.
    pub en: &'static str,
    /// Where it stands.
    pub group: Group,
    /// What it takes.
    pub takes: Takes,
    /// May be left to the vehicle: its setting may be `None`.
    pub free: bool,
    /// Only vehicles that name it have it.
    pub(crate) optional: bool,
    /// Reads what is set.
    pub get: fn(&World) -> Setting,
    /// Sets it.
    pub set: fn(&mut World, Setting),
}

impl Control {
    /// A control of every vehicle that is always set.
    pub(crate) const fn new(
        path: &'static str,
        [zh, en]: [&'static str; 2],
        group: Group,
        takes: Takes,
        get: fn(&World) -> Setting,
        set: fn(&mut World, Setting),
    ) -> Self {
        Self { path, zh, en, group, takes, free: false, optional: false, get, set }
    }

    /// The same, but it may be left to the vehicle.
    pub(crate) const fn free(self) -> Self {
        Self { free: true, ..self }
    }

    /// The same, of those vehicles alone that name it.
    pub(crate) const fn optional(self) -> Self {
        Self { optional: true, ..self }
    }

    /// Checks a setting against what the control takes.
    ///
    /// # Errors
    /// If it is out of range or may not be left to the vehicle.
    pub fn check(&self, setting: Setting) -> Result<(), ControlError> {
        let wrong = |takes: String| Err(ControlError::Range { path: self.path, takes });
        let Some(number) = setting else {
            return if self.free { Ok(()) } else { wrong(self.range()) };
        };
        let fits = match self.takes {
            Takes::Flag => number == 0.0 || number == 1.0,
            Takes::Choice(words) => number.fract() == 0.0 && (0.0..words.len() as f64).contains(&number),
            Takes::Number { min, max, .. } => (min..=max).contains(&number),
        };
        if fits { Ok(()) } else { wrong(self.range()) }
    }

    /// Reads a setting as a person writes it: `on`, `reverse`, `48.5`, `auto`.
    ///
    /// # Errors
    /// If the text is none of what the control takes.
    pub fn read(&self, text: &str) -> Result<Setting, ControlError> {
        let setting = match (self.takes, text) {
            (_, "auto") => None,
            (Takes::Flag, "on" | "true") => Some(1.0),
            (Takes::Flag, "off" | "false") => Some(0.0),
            (Takes::Choice(words), text) => match words.iter().position(|word| word.word == text) {
                Some(index) => Some(index as f64),
                None => return Err(self.misspelt(words, text)),
            },
            (_, text) => match text.parse::<f64>() {
                Ok(number) => Some(number),
                Err(_) => return Err(ControlError::Range { path: self.path, takes: self.range() }),
            },
        };
        self.check(setting).map(|()| setting)
    }

    /// Says what is wrong with a word: that it is spelt otherwise, or what there is instead.
    fn misspelt(&self, words: &[Word], text: &str) -> ControlError {
        let is_meant =
            |word: &&Word| [word.word, word.zh, word.en].iter().any(|face| face.eq_ignore_ascii_case(text));
        match words.iter().find(is_meant) {
            Some(Word { word, .. }) => ControlError::Spelling { path: self.path, text: text.into(), word },
            None => ControlError::Range { path: self.path, takes: self.range() },
        }
    }

    /// Says what the control takes: `0..100 %`, `off or on`, `D, N or R`.
    pub fn range(&self) -> String {
        let range = match self.takes {
            Takes::Flag => "off or on".to_owned(),
            Takes::Choice(words) => words.iter().map(|word| word.word).collect::<Vec<_>>().join(", "),
            Takes::Number { min, max, unit, .. } => format!("{min} to {max} {unit}").trim_end().to_owned(),
        };
        if self.free { format!("{range}, or auto") } else { range }
    }
}

/// Why a control was not set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ControlError {
    /// There is no such control in this vehicle.
    Unknown {
        /// What was asked for.
        path: String,
        /// The vehicle's folder.
        vehicle: &'static str,
        /// The control whose name is nearest.
        nearest: Option<&'static str>,
    },
    /// The control has the word, but spells it otherwise.
    Spelling {
        /// The control.
        path: &'static str,
        /// What was written.
        text: String,
        /// How it is written.
        word: &'static str,
    },
    /// The control does not take this.
    Range {
        /// The control.
        path: &'static str,
        /// What it takes.
        takes: String,
    },
}

impl fmt::Display for ControlError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { path, vehicle, nearest: Some(nearest) } => {
                write!(f, "{vehicle} has no control `{path}`; did you mean `{nearest}`?")
            }
            Self::Unknown { path, vehicle, nearest: None } => {
                write!(f, "{vehicle} has no control `{path}`; `cargo xtask vehicle --list` shows all")
            }
            Self::Spelling { path, text, word } => write!(f, "`{text}` is written `{word}` in `{path}`"),
            Self::Range { path, takes } => write!(f, "`{path}` takes {takes}"),
        }
    }
}

impl std::error::Error for ControlError {}

/// Reads a setting of [`Takes::Flag`].
pub(crate) fn is_on(setting: Setting) -> bool {
    setting.is_some_and(|number| number != 0.0)
}

/// Writes a setting of [`Takes::Flag`].
pub(crate) fn flag(on: bool) -> Setting {
    Some(f64::from(u8::from(on)))
}
