//! What is wanted of a name, what was found, and whether the two fit.
//!
//! Numbers are in everyday units and must be met exactly; where physics decides, a scenario gives a range. A value that
//! is missing is a word of its own: `never`, `stale`, `invalid`.

use super::line::{FoundLine, WantedLine};
use protocol_core::Value;
use protocol_core::link::Sample;
use protocol_core::model::{Missing, Shown};
use std::fmt;
use virtual_vehicle::Readout;

/// Numbers closer together than this are the same: decimals of a file are no binary fractions.
const SAME: f64 = 1e-6;

/// What was found under a name.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// A number in its everyday unit.
    Number(f64),
    /// A state by its public word.
    Word(String),
    /// The last pause of this sound: it plays still, or has ended.
    Pause(String),
    /// The message line; `None` = it is empty.
    Line(Option<FoundLine>),
}

/// What is wanted under a name.
#[derive(Clone, Debug, PartialEq)]
pub enum Wanted {
    /// This number, up to a rounding error of 1e-6.
    Number(f64),
    /// A number from the first to the second, both included.
    Range(f64, f64),
    /// One of these words.
    Words(Vec<String>),
    /// A message line.
    Line(WantedLine),
}

impl Answer {
    /// Returns the answer of a word.
    pub fn word(word: impl Into<String>) -> Self {
        Self::Word(word.into())
    }

    /// Returns a value as a person reads it.
    pub fn of_sample(sample: Sample, value: Value) -> Self {
        Self::of_shown(sample.into(), |counts| match value.unit().kind() {
            Some(kind) => {
                kind.of_number(counts).map_or(Self::Number(counts.into()), |state| Self::word(state.word))
            }
            None => {
                let text = value.unit().show(counts).to_string();
                let number = text.split(' ').next().and_then(|number| number.parse().ok());
                number.map_or(Self::Word(text), Self::Number)
            }
        })
    }

    /// Returns what is true in the vehicle: a number, or a state's word.
    pub fn of_truth(truth: Option<Readout>) -> Self {
        match truth {
            None => Self::word(Missing::Never.word()),
            Some(Readout { kind: None, value, .. }) => Self::Number(value),
            Some(truth) => Self::word(truth.state().map_or(Missing::Invalid.word(), |state| state.word)),
        }
    }

    /// Returns a shown number.
    pub fn of_number(sample: Sample) -> Self {
        Self::of_shown(sample.into(), |number| Self::Number(number.into()))
    }

    fn of_shown(shown: Shown<i32>, of_value: impl FnOnce(i32) -> Self) -> Self {
        match (shown.value(), shown.missing()) {
            (Some(value), _) => of_value(value),
            (None, missing) => Self::word(missing.unwrap_or(Missing::Never).word()),
        }
    }
}

impl Wanted {
    /// Returns whether `answer` is, or may be, what is wanted.
    pub fn fits(&self, answer: &Answer) -> bool {
        match (self, answer) {
            (Self::Number(wanted), Answer::Number(number)) => (wanted - number).abs() < SAME,
            (Self::Range(low, high), Answer::Number(number)) => (low - SAME..=high + SAME).contains(number),
            (Self::Words(words), Answer::Word(word)) => words.contains(word),
            (Self::Words(words), Answer::Pause(sound)) => {
                words.iter().any(|word| word == sound || word == "none")
            }
            (Self::Words(words), Answer::Line(None)) => words.iter().any(|word| word == "none"),
            (Self::Line(wanted), Answer::Line(Some(line))) => wanted.fits(line),
            _ => false,
        }
    }

    /// Returns whether `answer` is what is wanted, without a doubt.
    pub fn surely_fits(&self, answer: &Answer) -> bool {
        !matches!(answer, Answer::Pause(_)) && self.fits(answer)
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{}", (number * 1e6).round() / 1e6),
            Self::Word(word) => f.write_str(word),
            Self::Pause(sound) => write!(f, "{sound} or none"),
            Self::Line(None) => f.write_str("none"),
            Self::Line(Some(line)) => line.fmt(f),
        }
    }
}

impl fmt::Display for Wanted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Range(low, high) => write!(f, "{low} to {high}"),
            Self::Words(words) => f.write_str(&words.join(" or ")),
            Self::Line(line) => line.fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cluster::{FaultId, Named};
    use protocol_core::model::Severity;

    #[test]
    fn a_missing_value_is_a_word_and_never_zero() {
        for (sample, word) in
            [(Sample::Never, "never"), (Sample::Stale, "stale"), (Sample::Invalid, "invalid")]
        {
            let answer = Answer::of_sample(sample, Value::BatterySoc);
            assert!(!Wanted::Number(0.0).fits(&answer));
            assert!(!Wanted::Range(-1e9, 1e9).fits(&answer));
            assert!(Wanted::Words(vec![word.into()]).fits(&answer));
        }
    }

    #[test]
    fn values_are_numbers_in_everyday_units_or_words() {
        let answer = |value, counts| Answer::of_sample(Sample::Value(counts), value);
        assert_eq!(answer(Value::BatterySoc, 453), Answer::Number(45.3));
        assert_eq!(answer(Value::ContactorMain, 2), Answer::word("welded"));
        assert_eq!(answer(Value::VehicleReady, 1), Answer::word("yes"));
        assert_eq!(answer(Value::ChargeState, 0), Answer::word("idle"));
        assert!(Wanted::Number(45.3).fits(&answer(Value::BatterySoc, 453)));
        assert!(!Wanted::Number(45.3).fits(&answer(Value::BatterySoc, 454)));
        assert!(Wanted::Range(45.0, 45.3).fits(&answer(Value::BatterySoc, 453)));
        assert!(!Wanted::Range(45.0, 45.2).fits(&answer(Value::BatterySoc, 453)));
    }

    #[test]
    fn a_line_is_found_by_its_fault_and_an_empty_one_by_none() {
        let named = Ok(Named::of(FaultId::Fire));
        let line = FoundLine { named, text: "FIRE", severity: Severity::Stop, position: 1, count: 1 };
        let found = Answer::Line(Some(line));
        let of = |fault| Wanted::Line(WantedLine { faults: vec![fault], ..WantedLine::default() });
        assert!(of(FaultId::Fire).fits(&found) && !of(FaultId::Limp).fits(&found));
        assert!(!Wanted::Words(vec!["none".into()]).fits(&found));
        assert!(Wanted::Words(vec!["none".into()]).fits(&Answer::Line(None)));
    }
}
