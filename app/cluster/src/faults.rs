//! Which fault stands on the message line: many sources, one active set, one line.
//!
//! Owns the set of active faults; what makes each report is in `sources`. Only the highest severity present is shown; its faults take
//! turns of one second in the order of the table. Silence clears what was harmless and keeps a STOP: only its source
//! can take that back. Fire latches until power-off and takes over everything.
//!
//! | what happens                        | what the set does                                              |
//! |-------------------------------------|----------------------------------------------------------------|
//! | the source clears the fault         | it goes at once                                                |
//! | the source rotates its codes        | a code stays until [`ROTATION_MS`] without it                  |
//! | the source reports a lower severity | what it reported above goes at once: it reports its worst only |
//! | the fault worsens                   | it moves up and sounds again                                   |
//! | a level comes before its code       | the old code stands beside it until the next one comes         |
//! | the source falls silent             | STOP stays, the rest goes                                      |
//! | the driver acknowledges             | the sound ends, the line stays                                 |
//! | a fault is reported by two routes   | one line, one sound, one entry: those of the worse report      |
//!
//! Source: BUS-R027 to BUS-R029, BUS-R033, BUS-R079; readings BUS-33, BUS-77, BUS-112, BUS-113, BUS-116; JL-R013.

use crate::chime::Sound;
use crate::facts::Facts;
use crate::history::History;
use crate::monitors::Timers;
use crate::sources::{ROWS, Report, Row, code_of};
use crate::texts;
use crate::view::{ActiveFault, Line};
use heapless::Vec;
use protocol_core::Millis;
use protocol_core::model::Severity::{self, Derate, Stop, Warn};
use protocol_core::model::Value as V;
use protocol_core::vehicle::{Node, Vehicle};

/// How long a line stands before the next of its severity takes its turn, in milliseconds (BUS-33).
const TURN_MS: u64 = 1_000;
/// How long a code that its sender rotates may be missing, in milliseconds: ten codes of one second each.
const ROTATION_MS: u64 = 10_000;
/// Most faults that are active at once; beyond that the mildest are left out.
const MOST: usize = 40;

/// One active fault.
#[derive(Clone, Copy)]
pub(crate) struct Fault {
    row: u8,
    pub(crate) code: Option<u16>,
    pub(crate) severity: Severity,
    /// When it became active.
    first: Millis,
    /// When its source last reported it.
    last: Millis,
    /// The driver has acknowledged it: it makes no sound.
    heard: bool,
    /// Its level has changed beside a code that may be the old level's: the next code replaces it.
    lags: bool,
}

impl Fault {
    fn row(&self) -> Option<&'static Row> {
        ROWS.get(usize::from(self.row))
    }

    /// Returns whether a report is of this fault: the code is part of its name only where codes rotate.
    fn is_same(&self, row: u8, code: Option<u16>) -> bool {
        self.row == row && (self.code == code || !self.row().is_some_and(Row::has_several))
    }

    fn order(&self) -> (u8, Millis, Option<u16>) {
        (self.row, self.first, self.code)
    }
}

/// Whose turn it is on the message line.
#[derive(Clone, Copy)]
struct Turn {
    row: u8,
    code: Option<u16>,
    severity: Severity,
    place: usize,
    since: Millis,
}

/// The active faults and the turn among them.
#[derive(Clone)]
pub(crate) struct Faults {
    /// In the order of their turns.
    active: Vec<Fault, MOST>,
    turn: Option<Turn>,
    /// Code by which fire was reported.
    fire: Option<u16>,
    history: History,
}

impl Faults {
    pub(crate) const fn new() -> Self {
        Self { active: Vec::new(), turn: None, fire: None, history: History::new() }
    }

    /// Latches fire if either route reports it (BUS-116); called for every frame, so that none is missed.
    pub(crate) fn watch_for_fire(&mut self, facts: &Facts<'_>) {
        let routes = [(Node::Vcu, V::VehicleFaultCode), (Node::Bms, V::BatteryFaultCode)];
        for code in routes.into_iter().filter_map(|(node, value)| Some((node, code_of(facts, value)?))) {
            let fault = facts.vehicle.fault(code.0, code.1);
            self.fire = self.fire.or(fault.filter(|fault| fault.fire).map(|fault| fault.code));
        }
    }

    /// Brings the active set up to date and gives the next line its turn.
    pub(crate) fn tick(&mut self, facts: &Facts<'_>) {
        self.watch_for_fire(facts);
        for (index, row) in (0u8..).zip(ROWS) {
            match row.report(facts) {
                Report::Fault(severity, code) => self.report(index, row, severity, code, facts.now),
                Report::Bits(bits) => self.report_bits(index, row, bits, facts),
                Report::Clear => self.active.retain(|fault| fault.row != index),
                Report::Unknown => self.active.retain(|fault| fault.row != index || fault.severity == Stop),
            }
        }
        self.take_turn(facts.now);
    }

    /// Takes the one fault that a source reports now; what it reported before stays only while it may be rotating.
    fn report(&mut self, index: u8, row: &Row, severity: Severity, code: Option<u16>, now: Millis) {
        self.active.retain(|fault| {
            fault.row != index
                || fault.is_same(index, code)
                // A fault without its code yet is not one of several.
                || fault.code.is_some()
                    && !fault.lags
                    && fault.severity <= severity
                    && now.since(fault.last) < ROTATION_MS
        });
        self.present(index, row, severity, code, now);
    }

    /// Takes all alarm bits of a source.
    fn report_bits(&mut self, index: u8, row: &Row, bits: u32, facts: &Facts<'_>) {
        let is_set = |code: u16| code.checked_sub(1).is_some_and(|bit| bits >> bit & 1 != 0);
        self.active.retain(|fault| fault.row != index || fault.code.is_some_and(is_set));
        for code in (1..=u32::BITS as u16).filter(|&code| is_set(code)) {
            self.present(index, row, row.stage(facts, code), Some(code), facts.now);
        }
    }

    fn present(&mut self, index: u8, row: &Row, severity: Severity, code: Option<u16>, now: Millis) {
        let other = self.other_route(index, code).copied();
        // How bad it was by that route when the driver acknowledged it: no worse, it makes no sound again.
        let acknowledged = other.filter(|other| other.heard).map(|other| other.severity);
        if let Some(fault) = self.active.iter_mut().find(|fault| fault.is_same(index, code)) {
            if fault.code != code
                || severity > fault.severity && !self.history.worsened(row.source, code, severity)
            {
                Self::note(&mut self.history, row, code, severity, other, now);
            }
            fault.heard &= severity <= fault.severity;
            fault.heard |= acknowledged.is_some_and(|worst| severity <= worst);
            fault.lags |= row.code_lags && severity != fault.severity;
            (fault.severity, fault.code, fault.last) = (severity, code, now);
            return;
        }
        let heard = acknowledged.is_some_and(|worst| severity <= worst);
        let fault = Fault { row: index, code, severity, first: now, last: now, heard, lags: false };
        if self.active.is_full() {
            let mildest = self.active.iter().enumerate().min_by_key(|(_, fault)| fault.severity);
            match mildest.map(|(place, mildest)| (place, mildest.severity)) {
                Some((place, mild)) if mild < severity => drop(self.active.remove(place)),
                _ => return,
            }
        }
        Self::note(&mut self.history, row, code, severity, other, now);
        let place = self.active.iter().position(|other| other.order() > fault.order());
        // Neither can fail: there is room, and the place is within the list.
        let _ = self.active.insert(place.unwrap_or(self.active.len()), fault);
    }

    /// Notes a fault that has come: anew, or in the entry that its other route has made.
    fn note(
        history: &mut History,
        row: &Row,
        code: Option<u16>,
        severity: Severity,
        other: Option<Fault>,
        now: Millis,
    ) {
        let mut has_entry = |source| history.worsened(source, code, severity);
        let is_noted = other
            .and_then(|other| other.row())
            .is_some_and(|other| has_entry(other.source) || has_entry(row.source));
        if !is_noted {
            history.came(row.source, code, severity, now);
        }
    }

    /// Gives the line to the next fault of the worst severity if its time has come or its fault is gone.
    fn take_turn(&mut self, now: Millis) {
        let worst = self.worst_active();
        let mut shown = self.told().filter(|fault| fault.severity == worst);
        let turn = self.turn.filter(|turn| turn.severity == worst);
        let place = turn.and_then(|turn| shown.clone().position(|fault| fault.is_same(turn.row, turn.code)));
        let (place, since) = match (turn, place) {
            (Some(turn), Some(place)) if now.since(turn.since) < TURN_MS => (place, turn.since),
            (_, Some(place)) => (place + 1, now),
            // What followed the fault that is gone has moved into its place.
            (Some(turn), None) => (turn.place, now),
            (None, None) => (0, now),
        };
        let place = if place < shown.clone().count() { place } else { 0 };
        let next = shown.nth(place).map(|fault| (fault.row, fault.code));
        drop(shown);
        self.turn = next.map(|(row, code)| Turn { row, code, severity: worst, place, since });
    }

    fn worst_active(&self) -> Severity {
        self.active.iter().map(|fault| fault.severity).max().unwrap_or_default()
    }

    /// Returns the report of the same fault by its other route.
    fn other_route(&self, row: u8, code: Option<u16>) -> Option<&Fault> {
        self.active.iter().find(|other| {
            let repeats =
                |repeat: u8, row: u8| ROWS.get(usize::from(repeat)).is_some_and(|it| it.repeats == Some(row));
            other.code == code && (repeats(row, other.row) || repeats(other.row, row))
        })
    }

    /// Returns the active faults that are told, each once: of two routes the worse.
    fn told(&self) -> impl Iterator<Item = &Fault> + Clone {
        self.active.iter().filter(|fault| {
            let rank = |fault: &Fault, other: &Fault| {
                (fault.severity, fault.row().is_none_or(|row| row.repeats != Some(other.row)))
            };
            self.other_route(fault.row, fault.code)
                .is_none_or(|other| rank(fault, other) > rank(other, fault))
        })
    }

    /// Silences every fault that is active now.
    pub(crate) fn acknowledge(&mut self) {
        for fault in &mut self.active {
            fault.heard = true;
        }
    }

    /// Returns the worst severity that is active.
    pub(crate) fn worst(&self) -> Severity {
        if self.fire.is_some() { Stop } else { self.worst_active() }
    }

    /// Returns the sound that the faults call for.
    pub(crate) fn sound(&self) -> Option<Sound> {
        if self.fire.is_some() {
            return Some(Sound::Fire);
        }
        let audible = |fault: &&Fault| !fault.heard && fault.row().is_some_and(|row| row.sounds);
        match self.told().filter(audible).map(|fault| fault.severity).max()? {
            Severity::None => None,
            Warn => Some(Sound::Warn),
            Derate => Some(Sound::Derate),
            Stop => Some(Sound::Stop),
        }
    }

    /// Returns the message line.
    pub(crate) fn line(&self, vehicle: &Vehicle, timers: &Timers, now: Millis) -> Option<Line> {
        if self.fire.is_some() {
            return Some(Line { severity: Stop, text: texts::FIRE, code: self.fire, position: 1, count: 1 });
        }
        let turn = self.turn?;
        let shown = self.told().filter(|fault| fault.severity == turn.severity);
        let fault = shown.clone().nth(turn.place)?;
        let row = fault.row()?;
        Some(Line {
            severity: fault.severity,
            text: row.text(fault, vehicle, timers.hv_off.phase(now)),
            code: row.printed(fault.code),
            position: turn.place as u8 + 1,
            count: shown.count() as u8,
        })
    }

    /// Returns whether the line only says that a node is missing.
    pub(crate) fn misses_a_node(&self) -> bool {
        let row = self.turn.and_then(|turn| ROWS.get(usize::from(turn.row)));
        self.fire.is_none() && row.is_some_and(Row::misses_a_node)
    }

    /// Returns whether an active fault means that the vehicle limps.
    pub(crate) fn limps(&self, vehicle: &Vehicle) -> bool {
        self.active.iter().any(|fault| fault.row().is_some_and(|row| row.limps(fault, vehicle)))
    }

    /// Returns how many faults are active.
    pub(crate) fn count(&self) -> usize {
        self.told().count()
    }

    /// Returns every active fault, in the order of the table.
    pub(crate) fn active<'a>(
        &'a self,
        vehicle: &'a Vehicle,
        timers: &'a Timers,
        now: Millis,
    ) -> impl Iterator<Item = ActiveFault> + 'a {
        self.told().filter_map(move |fault| {
            let row = fault.row()?;
            Some(ActiveFault {
                source: row.source,
                code: row.printed(fault.code),
                severity: fault.severity,
                text: row.text(fault, vehicle, timers.hv_off.phase(now)),
                first: fault.first,
                count: self.history.find(row.source, fault.code).map_or(1, |entry| entry.count),
            })
        })
    }

    /// Returns what went wrong since power-on.
    pub(crate) fn history_mut(&mut self) -> &mut History {
        &mut self.history
    }

    /// Returns what went wrong.
    pub(crate) fn history(&self) -> &History {
        &self.history
    }
}
