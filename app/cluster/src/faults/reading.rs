//! What a route of a fault says now.
//!
//! Owns how each kind of condition and severity is read, and what silence and undefined values mean to it; the rows are in
//! `table`, the set of active faults is in `arbitration`.
//! Source: BUS-R049, BUS-R079, BUS-R119; readings BUS-55, BUS-79, BUS-113, BUS-116, C5-15, JL-23.

use super::named::Named;
use super::table::{FaultId, Grade, When};
use super::turns::Reporter;
use crate::facts::Facts;
use protocol_core::model::{Severity, Shown, Value};

/// What a route says now.
pub(crate) enum Report {
    /// Nothing that can be believed: silent or never heard.
    Unknown,
    /// The sender speaks, and says what its documents do not define or mark as not valid.
    Undefined,
    /// No fault.
    Clear,
    /// A fault.
    Fault(Severity, Option<u16>),
    /// Alarm bits; how bad each is, [`Reporter::severity_of_bit`] says.
    Bits(u32),
}

impl Reporter {
    /// Returns what the route says now.
    pub(crate) fn report(&self, facts: &Facts<'_>) -> Report {
        let route = self.route;
        if route.unless_sent.is_some_and(|value| facts.is_sent(value)) {
            return Report::Clear;
        }
        let value_of = |value| facts.shown(value).value();
        let reports = match route.when {
            When::Bits(value) => {
                return match facts.shown(value) {
                    Shown::Value(bits) => Report::Bits(bits.cast_unsigned()),
                    missing => missing_report(missing),
                };
            }
            When::Silent(node) => Some(facts.silent.has(node)),
            When::Level(value) => value_of(value).map(|level| level > 0),
            When::Code(value) => value_of(value).map(|code| code != 0),
            When::Is(value, wanted) => value_of(value).map(|number| number == wanted),
            When::AnyIs(values, wanted) => any(facts, values, |number| number == wanted),
            When::AnyBelow(values, limit) => any(facts, values, |number| number < limit),
            When::Moving(flags) => match facts.moves() {
                Some(true) => any(facts, flags, |number| number == 1),
                _ => Some(false),
            },
            When::HvOff => Some(facts.timers.hv_off.phase(facts.now).is_some()),
            When::ChargerLost => Some(facts.timers.charger.is_lost()),
            When::HvacLost => Some(facts.has_lost_hvac()),
            When::Limps => Some(facts.link().limps()),
            // Takes no turns: see `fire_code` and `own`.
            When::Fire(..) | When::Own => Some(false),
        };
        match reports {
            None => route.when.value().map_or(Report::Unknown, |value| missing_report(facts.shown(value))),
            Some(false) => Report::Clear,
            Some(true) => {
                let code = route.code.and_then(|value| code_of(facts, value));
                let missing = || match route.grade {
                    Grade::Level(level) => missing_report(facts.shown(level)),
                    _ => Report::Unknown,
                };
                self.severity(facts, code).map_or_else(missing, |severity| Report::Fault(severity, code))
            }
        }
    }

    /// Returns how bad the alarm of bit `code` is.
    pub(crate) fn severity_of_bit(&self, facts: &Facts<'_>, code: u16) -> Severity {
        self.severity(facts, Some(code)).unwrap_or_default()
    }

    /// Returns the severity, `None` while the value that says it is silent or not valid.
    ///
    /// The level field decides (BUS-79); the vehicle's text of the code only on a vehicle that has none.
    fn severity(&self, facts: &Facts<'_>, code: Option<u16>) -> Option<Severity> {
        let of_text = || {
            let explained = Named { fault: self.row.fault, stage: 0, code }.explained(facts.vehicle);
            explained.and_then(|text| text.severity).unwrap_or_default()
        };
        let fresh = |value| facts.shown(value).value().map_or(Severity::None, Severity::from_model);
        match self.route.grade {
            Grade::Level(value) => match facts.shown(value) {
                Shown::Value(level) => Some(Severity::from_model(level)),
                Shown::Never => Some(of_text()),
                Shown::Stale | Shown::Invalid => None,
            },
            Grade::Always(severity) => Some(severity),
            Grade::Joins(least) => Some(fresh(Value::VehicleFaultLevel).max(least)),
            Grade::Alarm(level) => Some(match of_text() {
                Severity::None => fresh(level).max(Severity::Warn),
                severity => severity,
            }),
        }
    }

    /// Returns whether the code is part of a fault's name.
    pub(crate) fn has_several(&self) -> bool {
        self.route.rotates || matches!(self.route.when, When::Bits(_))
    }
}

/// Returns what a value means that is not there.
fn missing_report(shown: Shown<i32>) -> Report {
    if shown == Shown::Invalid { Report::Undefined } else { Report::Unknown }
}

/// Returns the code by which a route reports fire now.
pub(crate) fn fire_code(facts: &Facts<'_>) -> Option<u16> {
    FaultId::Fire.row().routes.iter().find_map(|route| {
        let When::Fire(node, value) = route.when else { return None };
        let fault = facts.vehicle.fault(node, code_of(facts, value)?)?;
        fault.fire.then_some(fault.code)
    })
}

/// Returns whether a value is so; `None` = none is, and one that was sent cannot be believed.
fn any(facts: &Facts<'_>, values: &[Value], is_so: impl Fn(i32) -> bool) -> Option<bool> {
    let mut sent = values.iter().map(|&value| facts.shown(value)).filter(|shown| *shown != Shown::Never);
    if sent.clone().any(|shown| shown.value().is_some_and(&is_so)) {
        return Some(true);
    }
    sent.all(|shown| shown.value().is_some()).then_some(false)
}

/// Returns the code in `value`, `None` for 0 and for anything that cannot be believed.
fn code_of(facts: &Facts<'_>, value: Value) -> Option<u16> {
    facts.shown(value).value().and_then(|code| u16::try_from(code).ok()).filter(|&code| code != 0)
}
