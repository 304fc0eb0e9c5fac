//! What the instrument says of itself: lines that no message on the bus could bring.
//!
//! Owns which of them is said, and its place beside the line of the faults. A cause goes before its consequences:
//! without a controller, after a restart or among another vehicle's frames the cluster misses nodes because of itself,
//! and says that instead of which nodes it misses. Whatever the vehicle reports goes by its severity; a doubt about the
//! vehicle itself takes its turn beside even the worst report, which may be another vehicle's. Refuses to know
//! where the facts come from.

use crate::faults::{FaultId, Grade, Named};
use crate::view::Line;
use protocol_core::Millis;
use protocol_core::model::Severity;
use protocol_core::vehicle::Vehicle;

/// Time that the CAN controller has to come up before its absence is shown, in milliseconds.
const CONTROLLER_MS: u64 = 100;
/// How long after start a fault of the previous run is shown, in milliseconds.
const RESTARTED_MS: u64 = 10_000;
/// How long after start a damaged memory is said, in milliseconds: long enough to be read behind the name of the
/// vehicle, once.
const DAMAGED_MS: u64 = 10_000;
/// Time after start from which the screen says that the cluster listens, in milliseconds.
const PATIENCE_MS: u64 = 1_000;
/// A doubt about the vehicle has the last second of each of these, in milliseconds, whatever the vehicle reports.
const TURN_MS: u64 = 4_000;
/// How long that turn is, in milliseconds.
const DOUBT_MS: u64 = 1_000;
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
    /// A vehicle was identified.
    Found {
        /// When.
        at: Millis,
    },
    /// As much speaks for another vehicle as for the one identified.
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

/// What the cluster of the vehicle knows of its bus.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Traffic {
    /// All that was heard of the vehicle has stopped.
    pub(crate) has_stopped: bool,
    /// One message comes from two senders.
    pub(crate) is_doubled: bool,
}

impl Conditions {
    /// Nothing is known yet.
    pub(crate) const NONE: Self =
        Self { controller_missing: false, restart: None, search: None, is_memory_damaged: false };

    /// Returns what is said: the cause nearest to the wires first.
    fn own(&self, traffic: Traffic, now: Millis) -> Option<Named> {
        if self.controller_missing && now.0 >= CONTROLLER_MS {
            return Some(Named::of(FaultId::NoController));
        }
        match (self.restart, self.search) {
            (Some(restart), _) if now.0 < RESTARTED_MS => {
                let code = if let Restart::Panic(line) = restart { line } else { None };
                Some(Named { code, ..Named::of(FaultId::Restarted) })
            }
            _ if self.is_memory_damaged && now.0 < DAMAGED_MS => Some(Named::of(FaultId::Memory)),
            (_, Some(Search::Contradicted)) => Some(Named::of(FaultId::Doubt)),
            _ if traffic.has_stopped => Some(Named::of(FaultId::NoTraffic)),
            _ if traffic.is_doubled => Some(Named::of(FaultId::TwoSenders)),
            (_, Some(Search::Found { at })) if now.since(at) < NAME_MS => {
                Some(Named::of(FaultId::Identified))
            }
            (_, Some(Search::Listening)) if now.0 >= PATIENCE_MS => Some(Named::of(FaultId::Listening)),
            _ => None,
        }
    }

    /// Returns the line that is shown beside that of the faults, `faults`; `is_silence` tells whether that one only
    /// misses a node.
    pub(crate) fn beside(
        &self,
        traffic: Traffic,
        faults: Option<Line>,
        is_silence: bool,
        vehicle: &Vehicle,
        now: Millis,
    ) -> Option<Line> {
        let Some(named) = self.own(traffic, now) else { return faults };
        let severity = severity(named.fault);
        // What is no plain fact is why the cluster misses nodes.
        let is_cause = severity > Severity::None;
        let is_doubt = self.search == Some(Search::Contradicted);
        let has_turn = is_doubt && now.0 % TURN_MS >= TURN_MS - DOUBT_MS;
        match faults {
            Some(line) if !has_turn && line.severity > severity && !(is_cause && is_silence) => faults,
            _ => Some(Line::of(named, severity, vehicle)),
        }
    }
}

/// Returns how bad a fault is that is as bad always.
fn severity(fault: FaultId) -> Severity {
    let grade = fault.row().routes.first().map(|route| route.grade);
    if let Some(Grade::Always(severity)) = grade { severity } else { Severity::None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use FaultId::*;
    use Severity::{Derate, Stop, Warn};
    use protocol_core::generated::citybus::VEHICLE;

    fn line(severity: Severity) -> Line {
        let named = Named { code: Some(7), ..Named::of(VehicleCode) };
        Line { count: 2, ..Line::of(named, severity, &VEHICLE) }
    }

    fn said(conditions: Conditions, now: u64) -> Option<(FaultId, Option<u16>)> {
        conditions
            .beside(Traffic::default(), None, false, &VEHICLE, Millis(now))
            .map(|line| (line.named.fault, line.code))
    }

    const NO_CONTROLLER: Conditions = Conditions { controller_missing: true, ..Conditions::NONE };
    const CONTRADICTED: Conditions = Conditions { search: Some(Search::Contradicted), ..Conditions::NONE };
    const RESTARTED: Conditions = Conditions { restart: Some(Restart::Watchdog), ..Conditions::NONE };
    const DAMAGED: Conditions = Conditions { is_memory_damaged: true, ..Conditions::NONE };

    #[test]
    fn a_cause_goes_before_the_silence_that_it_brings_and_never_before_what_the_vehicle_reports() {
        for conditions in [NO_CONTROLLER, CONTRADICTED, RESTARTED, DAMAGED] {
            let own = conditions.beside(Traffic::default(), None, false, &VEHICLE, Millis(200));
            assert!(own.is_some(), "{conditions:?}");
            for severity in [Severity::None, Warn, Derate, Stop] {
                let silence =
                    conditions.beside(Traffic::default(), Some(line(severity)), true, &VEHICLE, Millis(200));
                assert_eq!(silence, own, "{conditions:?} behind a silent node, {severity:?}");
                let report =
                    conditions.beside(Traffic::default(), Some(line(severity)), false, &VEHICLE, Millis(200));
                let expected = if severity > Warn { Some(line(severity)) } else { own };
                assert_eq!(report, expected, "{conditions:?} and a report, {severity:?}");
            }
        }
    }

    #[test]
    fn a_doubt_has_one_second_of_four_beside_the_worst_report() {
        let said = |now| {
            CONTRADICTED
                .beside(Traffic::default(), Some(line(Stop)), false, &VEHICLE, Millis(now))
                .map(|line| line.named.fault)
        };
        let (doubt, report) = (Some(Doubt), Some(VehicleCode));
        let times = [4_000, 6_999, 7_000, 7_999, 8_000];
        assert_eq!(times.map(said), [report, report, doubt, doubt, report]);
    }

    #[test]
    fn a_plain_fact_gives_way_to_every_fault() {
        for search in [Search::Listening, Search::Found { at: Millis(1_500) }] {
            let conditions = Conditions { search: Some(search), ..Conditions::default() };
            assert!(conditions.beside(Traffic::default(), None, false, &VEHICLE, Millis(2_000)).is_some());
            for is_silence in [false, true] {
                let shown = conditions.beside(
                    Traffic::default(),
                    Some(line(Warn)),
                    is_silence,
                    &VEHICLE,
                    Millis(2_000),
                );
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
        let found = Search::Found { at: Millis(700) };
        let found = Conditions { search: Some(found), ..Conditions::default() };
        assert_eq!([700, 5_699, 5_700].map(|now| said(found, now).is_some()), [true, true, false]);
        assert_eq!(said(CONTRADICTED, 100_000_000), Some((Doubt, None)));
    }

    #[test]
    fn a_reset_by_the_watchdog_is_said_like_a_panic_without_its_source_line() {
        let restart = |restart| Conditions { restart: Some(restart), ..Conditions::default() };
        assert_eq!(said(restart(Restart::Watchdog), 0), Some((Restarted, None)));
        assert_eq!(said(restart(Restart::Panic(None)), 0), Some((Restarted, None)));
        assert_eq!(said(restart(Restart::Panic(Some(146))), 0), Some((Restarted, Some(146))));
    }

    #[test]
    fn of_several_causes_the_one_nearest_to_the_wires_is_said() {
        let all = Conditions { controller_missing: true, ..RESTARTED };
        assert_eq!(said(all, 5_000), Some((NoController, None)));
        let both = Conditions { search: Some(Search::Contradicted), ..RESTARTED };
        assert_eq!(
            [9_000, 11_000].map(|now| said(both, now)),
            [Some((Restarted, None)), Some((Doubt, None))]
        );
    }
}
