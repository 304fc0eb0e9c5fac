//! The battery asks for high voltage off: who is due when, and what the driver is told.
//!
//! | since the request | phase                | whose turn                                         |
//! |-------------------|----------------------|----------------------------------------------------|
//! | 0 to 5 s          | [`Phase::Asked`]     | the vehicle opens the circuit                      |
//! | 5 to 35 s         | [`Phase::Overdue`]   | the vehicle is late                                |
//! | from 35 s         | [`Phase::Due`]       | the battery opens it by itself                     |
//! | contactor open    | [`Phase::Off`]       | nobody's; closed or unknown again: as the time has it |
//!
//! A withdrawal ends it, a further request starts anew. Silence withdraws nothing: the battery's clock runs on, and an
//! open contactor is not believed from stale data. The times are those of the bus document; a vehicle whose document
//! prints none stays at [`Phase::Asked`], without a countdown.
//! Source: BUS-R065, BUS-R076, BUS-R078; readings BUS-67 (exactly 11, by the vehicle's table) and BUS-68.

use protocol_core::Millis;
use protocol_core::model::Shown;
use protocol_core::states::Contactor;
use protocol_core::vehicle::HvOffRule;

/// How far a request has come; in the order of the texts of `Words::Phases`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// The vehicle is within its time.
    Asked,
    /// The vehicle has let its time pass.
    Overdue,
    /// The battery's time has come.
    Due,
    /// The main contactor is open.
    Off,
}

/// A request and since when it stands.
#[derive(Clone, Copy)]
pub(crate) struct HvOff {
    /// `None` = the vehicle's document prints no times: the request is asked for ever.
    rule: Option<HvOffRule>,
    since: Option<Millis>,
    is_open: bool,
}

impl HvOff {
    pub(crate) const fn new(rule: Option<HvOffRule>) -> Self {
        Self { rule, since: None, is_open: false }
    }

    /// Takes the request and the main contactor as they are now known.
    pub(crate) fn observe(&mut self, request: Shown<i32>, contactor: Shown<i32>, now: Millis) {
        match request {
            Shown::Value(1) => self.since = self.since.or(Some(now)),
            Shown::Value(_) => self.since = None,
            Shown::Never | Shown::Stale | Shown::Invalid => {}
        }
        self.is_open = contactor == Shown::Value(Contactor::Open.number());
    }

    /// Returns how far the request has come; `None` = there is none.
    pub(crate) fn phase(&self, now: Millis) -> Option<Phase> {
        let age_ms = now.since(self.since?);
        Some(match self.rule {
            _ if self.is_open => Phase::Off,
            Some(rule) if age_ms >= u64::from(rule.battery_ms) => Phase::Due,
            Some(rule) if age_ms >= u64::from(rule.vehicle_ms) => Phase::Overdue,
            _ => Phase::Asked,
        })
    }

    /// Returns the seconds until the battery opens the circuit, rounded up; `None` = nothing to wait for.
    pub(crate) fn countdown_s(&self, now: Millis) -> Option<u8> {
        let battery_ms = u64::from(self.rule?.battery_ms);
        match self.phase(now)? {
            Phase::Asked | Phase::Overdue => {
                let left_ms = battery_ms.saturating_sub(now.since(self.since?));
                u8::try_from(left_ms.div_ceil(1_000)).ok()
            }
            Phase::Due | Phase::Off => None,
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::vec::Vec;

    const BUS: Option<HvOffRule> = Some(HvOffRule { vehicle_ms: 5_000, battery_ms: 35_000 });

    /// What was known at one time.
    type Moment = (u64, Shown<i32>, Shown<i32>);

    /// The naive statement: asks the whole history.
    fn stated(history: &[Moment], now: u64) -> Option<(Phase, Option<u8>)> {
        let spoken: Vec<_> = history.iter().filter(|(_, request, _)| request.value().is_some()).collect();
        let first =
            spoken.iter().rposition(|(_, request, _)| *request != Shown::Value(1)).map_or(0, |at| at + 1);
        let start = spoken.get(first)?.0;
        let seconds = (now - start) as f64 / 1_000.0;
        let left = Some((35.0 - seconds).ceil() as u8);
        Some(match history.last()?.2 {
            Shown::Value(0) => (Phase::Off, None),
            _ if seconds < 5.0 => (Phase::Asked, left),
            _ if seconds < 35.0 => (Phase::Overdue, left),
            _ => (Phase::Due, None),
        })
    }

    /// Lives through every sequence of `depth` moments and compares at each, and just before the next.
    fn every_history(depth: u32) {
        let requests = [Shown::Value(1), Shown::Value(0), Shown::Stale, Shown::Never];
        let contactors = [Shown::Value(1), Shown::Value(0), Shown::Stale];
        fn live(
            machine: HvOff,
            past: &[Moment],
            depth: u32,
            requests: &[Shown<i32>],
            contactors: &[Shown<i32>],
        ) {
            if depth == 0 {
                return;
            }
            for step in [10, 4_990, 5_000, 29_990, 35_000] {
                let now = past.last().map_or(0, |moment| moment.0) + step;
                for &request in requests {
                    for &contactor in contactors {
                        let mut machine = machine;
                        machine.observe(request, contactor, Millis(now));
                        let mut history = past.to_vec();
                        history.push((now, request, contactor));
                        for later in [now, now + 9, now + 4_999, now + 5_000, now + 34_999, now + 35_000] {
                            let at = Millis(later);
                            let found = machine.phase(at).map(|phase| (phase, machine.countdown_s(at)));
                            assert_eq!(found, stated(&history, later), "{later} ms after {history:?}");
                        }
                        live(machine, &history, depth - 1, requests, contactors);
                    }
                }
            }
        }
        live(HvOff::new(BUS), &[], depth, &requests, &contactors);
    }

    #[test]
    fn bus_r065_bus_r076_every_history_of_a_request_goes_as_stated() {
        every_history(3);
    }

    #[test]
    fn bus_68_the_countdown_ends_when_the_battery_acts() {
        let mut machine = HvOff::new(BUS);
        machine.observe(Shown::Value(1), Shown::Value(1), Millis(7));
        let left = |ms: u64| machine.countdown_s(Millis(7 + ms));
        assert_eq!(
            [0, 1, 999, 1_000, 1_001, 34_999, 35_000].map(left),
            [Some(35), Some(35), Some(35), Some(34), Some(34), Some(1), None]
        );
    }

    #[test]
    fn without_printed_times_a_request_stands_and_nobody_is_late() {
        let mut machine = HvOff::new(None);
        machine.observe(Shown::Value(1), Shown::Value(1), Millis(7));
        for now in [7, 5_007, 35_007, 3_600_000].map(Millis) {
            assert_eq!((machine.phase(now), machine.countdown_s(now)), (Some(Phase::Asked), None));
        }
    }
}
