//! What the instrument says of itself: lines that no message on the bus could bring.
//!
//! Owns which of them is said, and its place beside the line of the faults. A cause goes before its consequences:
//! without a controller, after a restart or among another vehicle's frames the cluster misses nodes because of itself,
//! and says that instead of which nodes it misses. Whatever the vehicle reports goes by its severity. Refuses to know
//! where the facts come from.

use crate::texts;
use crate::view::{Line, Text};
use protocol_core::Millis;
use protocol_core::model::Severity::{self, Warn};

/// Time that the CAN controller has to come up before its absence is shown, in milliseconds.
const CONTROLLER_MS: u64 = 100;
/// How long after start a fault of the previous run is shown, in milliseconds.
const RESTARTED_MS: u64 = 10_000;
/// How long after start a damaged memory is said, in milliseconds: long enough to be read behind the name of the
/// vehicle, once.
const DAMAGED_MS: u64 = 10_000;
/// Time after start from which the screen says that the cluster listens, in milliseconds.
const PATIENCE_MS: u64 = 1_000;
/// Time for which the name of a vehicle is shown after its recognition, in milliseconds.
const NAME_MS: u64 = 5_000;

/// The fault of the cluster that ended its previous run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Restart {
    /// A panic or a hard fault, in this line of the source if it is known.
    Panic(Option<u16>),
    /// The watchdog: the firmware stood still.
    Watchdog,
}

/// How far the search for the vehicle is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// Nothing is recognised yet.
    Listening,
    /// A vehicle of this name was recognised.
    Found {
        /// Its name.
        name: Text,
        /// When.
        at: Millis,
    },
    /// As much speaks for another vehicle as for the one recognised.
    Contradicted,
}

/// What the instrument knows of itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Conditions {
    /// The CAN controller does not answer.
    pub(crate) controller_missing: bool,
    /// Why the cluster started, if it was a fault of its own.
    pub(crate) restart: Option<Restart>,
    /// The search for the vehicle; `None` = there is none, the image is for one vehicle.
    pub(crate) search: Option<Search>,
    /// What was kept cannot be read or written.
    pub(crate) is_memory_damaged: bool,
}

/// A line of the instrument.
struct Own {
    line: Line,
    /// The cluster misses nodes because of this.
    is_cause: bool,
}

impl Own {
    const fn cause(text: Text, code: Option<u16>) -> Self {
        Self { line: Line { severity: Warn, text, code, position: 1, count: 1 }, is_cause: true }
    }

    const fn fact(text: Text) -> Self {
        let line = Line { severity: Severity::None, text, code: None, position: 1, count: 1 };
        Self { line, is_cause: false }
    }
}

impl Conditions {
    /// Nothing is known yet.
    pub(crate) const NONE: Self =
        Self { controller_missing: false, restart: None, search: None, is_memory_damaged: false };

    fn own(&self, now: Millis) -> Option<Own> {
        if self.controller_missing && now.0 >= CONTROLLER_MS {
            return Some(Own::cause(texts::NO_CONTROLLER, None));
        }
        match (self.restart, self.search) {
            (Some(Restart::Panic(line)), _) if now.0 < RESTARTED_MS => {
                Some(Own::cause(texts::RESTARTED, line))
            }
            (Some(Restart::Watchdog), _) if now.0 < RESTARTED_MS => Some(Own::cause(texts::RESTARTED, None)),
            _ if self.is_memory_damaged && now.0 < DAMAGED_MS => Some(Own::cause(texts::MEMORY, None)),
            (_, Some(Search::Contradicted)) => Some(Own::cause(texts::DOUBT, None)),
            (_, Some(Search::Found { name, at })) if now.since(at) < NAME_MS => Some(Own::fact(name)),
            (_, Some(Search::Listening)) if now.0 >= PATIENCE_MS => Some(Own::fact(texts::LISTENING)),
            _ => None,
        }
    }

    /// Returns the line that is shown beside that of the faults, `faults`; `is_silence` tells whether that one only
    /// misses a node.
    pub(crate) fn beside(&self, faults: Option<Line>, is_silence: bool, now: Millis) -> Option<Line> {
        let Some(own) = self.own(now) else { return faults };
        match faults {
            Some(line) if line.severity > own.line.severity && !(own.is_cause && is_silence) => faults,
            _ => Some(own.line),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Severity::{Derate, Stop};

    fn line(severity: Severity) -> Line {
        Line { severity, text: texts::SYSTEM, code: Some(7), position: 1, count: 2 }
    }

    fn said(conditions: Conditions, now: u64) -> Option<(&'static str, Option<u16>)> {
        conditions.beside(None, false, Millis(now)).map(|line| (line.text.en, line.code))
    }

    const NO_CONTROLLER: Conditions = Conditions { controller_missing: true, ..Conditions::NONE };
    const CONTRADICTED: Conditions = Conditions { search: Some(Search::Contradicted), ..Conditions::NONE };
    const RESTARTED: Conditions = Conditions { restart: Some(Restart::Watchdog), ..Conditions::NONE };
    const DAMAGED: Conditions = Conditions { is_memory_damaged: true, ..Conditions::NONE };

    #[test]
    fn a_cause_goes_before_the_silence_that_it_brings_and_never_before_what_the_vehicle_reports() {
        for conditions in [NO_CONTROLLER, CONTRADICTED, RESTARTED, DAMAGED] {
            let own = conditions.beside(None, false, Millis(200));
            assert!(own.is_some(), "{conditions:?}");
            for severity in [Severity::None, Warn, Derate, Stop] {
                let silence = conditions.beside(Some(line(severity)), true, Millis(200));
                assert_eq!(silence, own, "{conditions:?} behind a silent node, {severity:?}");
                let report = conditions.beside(Some(line(severity)), false, Millis(200));
                let expected = if severity > Warn { Some(line(severity)) } else { own };
                assert_eq!(report, expected, "{conditions:?} and a report, {severity:?}");
            }
        }
    }

    #[test]
    fn a_plain_fact_gives_way_to_every_fault() {
        for search in [Search::Listening, Search::Found { name: texts::SYSTEM, at: Millis(1_500) }] {
            let conditions = Conditions { search: Some(search), ..Conditions::default() };
            assert!(conditions.beside(None, false, Millis(2_000)).is_some());
            for is_silence in [false, true] {
                let shown = conditions.beside(Some(line(Warn)), is_silence, Millis(2_000));
                assert_eq!(shown, Some(line(Warn)), "{search:?}");
            }
        }
    }

    #[test]
    fn each_line_has_its_time() {
        assert_eq!([99, 100].map(|now| said(NO_CONTROLLER, now).is_some()), [false, true]);
        assert_eq!([0, 9_999, 10_000].map(|now| said(RESTARTED, now).is_some()), [true, true, false]);
        assert_eq!([0, 9_999, 10_000].map(|now| said(DAMAGED, now).is_some()), [true, true, false]);
        let listening = Conditions { search: Some(Search::Listening), ..Conditions::default() };
        assert_eq!([999, 1_000].map(|now| said(listening, now).is_some()), [false, true]);
        let found = Search::Found { name: texts::SYSTEM, at: Millis(700) };
        let found = Conditions { search: Some(found), ..Conditions::default() };
        assert_eq!([700, 5_699, 5_700].map(|now| said(found, now).is_some()), [true, true, false]);
        assert_eq!(said(CONTRADICTED, 100_000_000), Some((texts::DOUBT.en, None)));
    }

    #[test]
    fn a_reset_by_the_watchdog_is_said_like_a_panic_without_its_source_line() {
        let restart = |restart| Conditions { restart: Some(restart), ..Conditions::default() };
        assert_eq!(said(restart(Restart::Watchdog), 0), Some((texts::RESTARTED.en, None)));
        assert_eq!(said(restart(Restart::Panic(None)), 0), Some((texts::RESTARTED.en, None)));
        assert_eq!(said(restart(Restart::Panic(Some(146))), 0), Some((texts::RESTARTED.en, Some(146))));
    }

    #[test]
    fn of_several_causes_the_one_nearest_to_the_wires_is_said() {
        let all = Conditions { controller_missing: true, ..RESTARTED };
        assert_eq!(said(all, 5_000), Some((texts::NO_CONTROLLER.en, None)));
        let both = Conditions { search: Some(Search::Contradicted), ..RESTARTED };
        assert_eq!(
            [9_000, 11_000].map(|now| said(both, now)),
            [Some((texts::RESTARTED.en, None)), Some((texts::DOUBT.en, None))]
        );
    }
}
