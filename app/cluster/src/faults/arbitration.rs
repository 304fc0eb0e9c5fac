//! Which fault stands on the message line: many routes, one active set, one line.
//!
//! Owns the set of active faults; what makes each report is in `reading`. Only the highest severity present is shown; its
//! faults take turns of one second in the order of `turns`. Silence clears what was harmless and keeps a STOP: only its
//! route can take that back. Fire latches until power-off and takes over the line; the list has it first.
//!
//! | what happens                        | what the set does                                              |
//! |-------------------------------------|----------------------------------------------------------------|
//! | the route clears the fault          | it goes at once                                                |
//! | the route rotates its codes         | a code stays until [`ROTATION_MS`] without it                  |
//! | the route reports a lower severity  | what it reported above goes at once: it reports its worst only |
//! | the fault worsens                   | it moves up and sounds again                                   |
//! | a level comes before its code       | the old code stands beside it until the next one comes         |
//! | the sender falls silent             | STOP stays, the rest goes                                      |
//! | the route says what nobody defined  | everything stays as it is: only a defined normal clears        |
//! | a request for HV off comes further  | it sounds again, acknowledged or not                           |
//! | the driver acknowledges             | the sound ends, the line stays; fire sounds again after a time |
//! | it ends before that                 | a STOP or DERATE is said to have been until it is acknowledged |
//! | a fault is reported by two routes   | one line, one sound, one entry: those of the worse report      |
//!
//! Source: BUS-R027 to BUS-R029, BUS-R033, BUS-R079; readings BUS-33, BUS-77, BUS-112, BUS-113, BUS-116; JL-R013.

use super::memory::History;
use super::named::Named;
use super::reading::{Report, fire_code};
use super::table::{FaultId, Row, Voice, When, Words};
use super::turns::{REPORTERS, Reporter};
use crate::chime::Sound;
use crate::facts::Facts;
use crate::monitors::Timers;
use crate::monitors::hv_off::Phase;
use crate::view::{ActiveFault, Line};
use heapless::Vec;
use protocol_core::Millis;
use protocol_core::model::Severity::{self, Derate, Stop, Warn};
use protocol_core::vehicle::Vehicle;

/// How long a line stands before the next of its severity takes its turn, in milliseconds (BUS-33).
const TURN_MS: u64 = 1_000;
/// How long a code that its sender rotates may be missing, in milliseconds: ten codes of one second each.
const ROTATION_MS: u64 = 10_000;
/// Most faults that are active at once; beyond that the mildest are left out.
const MOST: usize = 40;
/// Most faults that are over and were not acknowledged; beyond that the mildest are left out.
const MOST_UNSEEN: usize = 8;
/// How long fire is silent after it was acknowledged, in milliseconds: long enough to talk to the passengers; then the
/// alarm that BUS-R079 asks for goes on.
const FIRE_QUIET_MS: u64 = 30_000;

/// One active fault.
#[derive(Clone, Copy)]
struct Fault {
    /// Place of the fault and its route in [`REPORTERS`].
    by: u8,
    code: Option<u16>,
    severity: Severity,
    /// When it became active.
    first: Millis,
    /// When its route last reported it.
    last: Millis,
    /// The driver has acknowledged it: it makes no sound.
    heard: bool,
    /// Its level has changed beside a code that may be the old level's: the next code replaces it.
    lags: bool,
}

impl Fault {
    fn reporter(&self) -> Option<&'static Reporter> {
        REPORTERS.get(usize::from(self.by))
    }

    /// Returns whether a report is of this fault: the code is part of its name only where codes rotate.
    fn is_same(&self, by: u8, code: Option<u16>) -> bool {
        self.by == by && (self.code == code || !self.reporter().is_some_and(Reporter::has_several))
    }

    fn order(&self) -> (u8, Millis, Option<u16>) {
        (self.by, self.first, self.code)
    }

    /// Returns the fault by name.
    fn named(&self, row: &Row, vehicle: &Vehicle, timers: &Timers, now: Millis) -> Named {
        let named = Named::graded(row.fault, self.code, self.severity, vehicle);
        match row.words {
            Words::Phases(_) => {
                Named { stage: timers.hv_off.phase(now).map_or(0, |phase| phase as u8), ..named }
            }
            _ => named,
        }
    }
}

/// A fault that is over and that nobody has acknowledged.
#[derive(Clone, Copy)]
struct Unseen {
    fault: Fault,
    /// Its stage when it ended.
    stage: u8,
}

/// Returns whether the reporter `by` repeats what the reporter `first` says.
fn repeats(by: u8, first: u8) -> bool {
    let at = |by: u8| REPORTERS.get(usize::from(by));
    let repeated = at(by).and_then(|reporter| reporter.route.repeats);
    by != first && repeated.is_some_and(|fault| at(first).is_some_and(|first| first.row.fault == fault))
}

/// Whose turn it is on the message line.
#[derive(Clone, Copy)]
struct Turn {
    by: u8,
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
    /// STOP and DERATE that came and went without being acknowledged, the oldest first.
    unseen: Vec<Unseen, MOST_UNSEEN>,
    /// Since when the acknowledged fire is silent.
    fire_quiet: Option<Millis>,
    /// Code by which fire was reported, and when.
    fire: Option<(u16, Millis)>,
    /// How far a request for high voltage off has come.
    phase: Option<Phase>,
    /// The vehicle is known to stand.
    stands: bool,
    history: History,
}

impl Faults {
    pub(crate) const fn new() -> Self {
        Self {
            active: Vec::new(),
            turn: None,
            unseen: Vec::new(),
            fire_quiet: None,
            fire: None,
            phase: None,
            stands: false,
            history: History::new(),
        }
    }

    /// Latches fire if either route reports it (BUS-116); called for every frame, so that none is missed.
    pub(crate) fn watch_for_fire(&mut self, facts: &Facts<'_>) {
        if self.fire.is_none()
            && let Some(code) = fire_code(facts)
        {
            self.fire = Some((code, facts.now));
            self.history.came(FaultId::Fire, Some(code), Stop, facts.now);
        }
    }

    /// Brings the active set up to date and gives the next line its turn.
    pub(crate) fn tick(&mut self, facts: &Facts<'_>) {
        self.watch_for_fire(facts);
        self.fire_quiet = self.fire_quiet.filter(|since| facts.now.since(*since) < FIRE_QUIET_MS);
        for (by, reporter) in (0u8..).zip(&REPORTERS) {
            match reporter.report(facts) {
                Report::Fault(severity, code) => self.report(by, reporter, severity, code, facts),
                Report::Bits(bits) => self.report_bits(by, reporter, bits, facts),
                Report::Clear => self.end(facts.vehicle, |fault| fault.by == by),
                Report::Unknown => self.end(facts.vehicle, |fault| fault.by == by && fault.severity != Stop),
                Report::Undefined => {}
            }
        }
        self.stands = facts.moves() == Some(false);
        self.follow(facts.timers.hv_off.phase(facts.now));
        self.take_turn(facts.now);
    }

    /// Lets a request for high voltage off sound again when it has come further: each phase is a fact of its own.
    fn follow(&mut self, phase: Option<Phase>) {
        if phase != self.phase && matches!(phase, Some(Phase::Overdue | Phase::Due)) {
            let is_phased = |fault: &&mut Fault| {
                fault.reporter().is_some_and(|by| matches!(by.row.words, Words::Phases(_)))
            };
            self.active.iter_mut().filter(is_phased).for_each(|fault| fault.heard = false);
        }
        self.phase = phase;
    }

    /// Takes the one fault that a route reports now; what it reported before stays only while it may be rotating.
    fn report(
        &mut self,
        by: u8,
        reporter: &Reporter,
        severity: Severity,
        code: Option<u16>,
        facts: &Facts<'_>,
    ) {
        let now = facts.now;
        // A fault without its code yet is not one of several; an old code beside a new level was never a fault.
        self.active
            .retain(|fault| fault.by != by || fault.is_same(by, code) || fault.code.is_some() && !fault.lags);
        self.end(facts.vehicle, |fault| {
            fault.by == by
                && !fault.is_same(by, code)
                && (fault.severity > severity || now.since(fault.last) >= ROTATION_MS)
        });
        self.present(by, reporter, severity, code, now);
    }

    /// Ends faults; what is over before it was acknowledged is told on.
    fn end(&mut self, vehicle: &Vehicle, is_over: impl Fn(&Fault) -> bool) {
        for place in (0..self.active.len()).rev() {
            let Some(fault) = self.active.get(place).copied().filter(&is_over) else { continue };
            let _ = self.active.remove(place);
            let is_told_elsewhere = self.other_route(fault.by, fault.code).is_some();
            if !fault.heard && fault.severity >= Derate && !is_told_elsewhere {
                self.miss(fault, vehicle);
            }
        }
    }

    /// Remembers a fault that is over and was not acknowledged.
    fn miss(&mut self, fault: Fault, vehicle: &Vehicle) {
        let Some(reporter) = fault.reporter() else { return };
        self.unseen.retain(|unseen| !unseen.fault.is_same(fault.by, fault.code));
        if self.unseen.is_full() {
            let mildest = self.unseen.iter().enumerate().min_by_key(|(_, unseen)| unseen.fault.severity);
            match mildest.map(|(place, unseen)| (place, unseen.fault.severity)) {
                Some((place, mild)) if mild <= fault.severity => {
                    let _ = self.unseen.remove(place);
                }
                _ => return,
            }
        }
        let stage = match reporter.row.words {
            Words::Phases(_) => self.phase.map_or(0, |phase| phase as u8),
            _ => Named::graded(reporter.row.fault, fault.code, fault.severity, vehicle).stage,
        };
        // Cannot fail: there is room now.
        let _ = self.unseen.push(Unseen { fault, stage });
    }

    /// Returns one of the worst faults that are over and were not acknowledged: each stands for two turns, of which it has
    /// the second even beside a milder line.
    pub(crate) fn unseen(&self, vehicle: &Vehicle, now: Millis) -> Option<Line> {
        let worst = self.unseen.iter().map(|unseen| unseen.fault.severity).max()?;
        let told = || self.unseen.iter().filter(|unseen| unseen.fault.severity == worst);
        let count = told().count();
        let place = (now.0 / (2 * TURN_MS)) as usize % count.max(1);
        let Unseen { fault, stage } = told().nth(place).copied()?;
        let named = Named { fault: fault.reporter()?.row.fault, stage, code: fault.code };
        let (position, count) = (place as u8 + 1, count as u8);
        Some(Line { position, count, ..Line::of(named, worst, vehicle) })
    }

    /// Takes all alarm bits of a route.
    fn report_bits(&mut self, by: u8, reporter: &Reporter, bits: u32, facts: &Facts<'_>) {
        let is_set = |code: u16| code.checked_sub(1).is_some_and(|bit| bits >> bit & 1 != 0);
        self.end(facts.vehicle, |fault| fault.by == by && !fault.code.is_some_and(is_set));
        for code in (1..=u32::BITS as u16).filter(|&code| is_set(code)) {
            self.present(by, reporter, reporter.severity_of_bit(facts, code), Some(code), facts.now);
        }
    }

    fn present(&mut self, by: u8, reporter: &Reporter, severity: Severity, code: Option<u16>, now: Millis) {
        let row = reporter.row;
        let other = self.other_route(by, code).copied();
        // How bad it was by that route when the driver acknowledged it: no worse, it makes no sound again.
        let acknowledged = other.filter(|other| other.heard).map(|other| other.severity);
        if let Some(fault) = self.active.iter_mut().find(|fault| fault.is_same(by, code)) {
            if fault.code != code
                || severity > fault.severity && !self.history.worsened(row.fault, code, severity)
            {
                Self::note(&mut self.history, row, code, severity, other, now);
            }
            fault.heard &= severity <= fault.severity;
            fault.heard |= acknowledged.is_some_and(|worst| severity <= worst);
            fault.lags |= reporter.route.code_lags && severity != fault.severity;
            (fault.severity, fault.code, fault.last) = (severity, code, now);
            return;
        }
        let heard = acknowledged.is_some_and(|worst| severity <= worst);
        // It is back: it has not come and gone.
        self.unseen.retain(|unseen| !unseen.fault.is_same(by, code));
        let fault = Fault { by, code, severity, first: now, last: now, heard, lags: false };
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
        let mut has_entry = |fault| history.worsened(fault, code, severity);
        let is_noted = other
            .and_then(|other| other.reporter())
            .is_some_and(|other| has_entry(other.row.fault) || has_entry(row.fault));
        if row.is_kept && !is_noted {
            history.came(row.fault, code, severity, now);
        }
    }

    /// Gives the line to the next fault of the worst severity if its time has come or its fault is gone.
    fn take_turn(&mut self, now: Millis) {
        let worst = self.worst_active();
        let mut shown = self.told().filter(|fault| fault.severity == worst);
        let turn = self.turn.filter(|turn| turn.severity == worst);
        let place = turn.and_then(|turn| shown.clone().position(|fault| fault.is_same(turn.by, turn.code)));
        let (place, since) = match (turn, place) {
            (Some(turn), Some(place)) if now.since(turn.since) < TURN_MS => (place, turn.since),
            (_, Some(place)) => (place + 1, now),
            // What followed the fault that is gone has moved into its place.
            (Some(turn), None) => (turn.place, now),
            (None, None) => (0, now),
        };
        let place = if place < shown.clone().count() { place } else { 0 };
        let next = shown.nth(place).map(|fault| (fault.by, fault.code));
        drop(shown);
        self.turn = next.map(|(by, code)| Turn { by, code, severity: worst, place, since });
    }

    fn worst_active(&self) -> Severity {
        self.active.iter().map(|fault| fault.severity).max().unwrap_or_default()
    }

    /// Returns the report of the same fault by its other route.
    fn other_route(&self, by: u8, code: Option<u16>) -> Option<&Fault> {
        let is_other = |other: &&Fault| repeats(by, other.by) || repeats(other.by, by);
        self.active.iter().find(|other| other.code == code && is_other(other))
    }

    /// Returns the active faults that are told, each once: of two routes the worse.
    fn told(&self) -> impl Iterator<Item = &Fault> + Clone {
        self.active.iter().filter(|fault| {
            let rank = |fault: &Fault, other: &Fault| (fault.severity, !repeats(fault.by, other.by));
            self.other_route(fault.by, fault.code).is_none_or(|other| rank(fault, other) > rank(other, fault))
        })
    }

    /// Silences every fault that is active now, fire for a time, and ends what is said of those that are over.
    pub(crate) fn acknowledge(&mut self, now: Millis) {
        for fault in &mut self.active {
            fault.heard = true;
        }
        self.unseen.clear();
        self.fire_quiet = self.fire.map(|_| now);
    }

    /// Returns the worst severity that is active.
    pub(crate) fn worst(&self) -> Severity {
        if self.fire.is_some() { Stop } else { self.worst_active() }
    }

    /// Returns the sound that the faults call for.
    pub(crate) fn sound(&self) -> Option<Sound> {
        if self.fire.is_some() && self.fire_quiet.is_none() {
            return Some(Sound::Fire);
        }
        let is_voiced = |by: &Reporter| match by.row.voice {
            Voice::AsSevere => true,
            Voice::Moving => !self.stands,
            Voice::Silent | Voice::Fire => false,
        };
        let audible = |fault: &&Fault| !fault.heard && fault.reporter().is_some_and(is_voiced);
        match self.told().filter(audible).map(|fault| fault.severity).max()? {
            Severity::None => None,
            Warn => Some(Sound::Warn),
            Derate => Some(Sound::Derate),
            Stop => Some(Sound::Stop),
        }
    }

    /// Returns the message line.
    pub(crate) fn line(&self, vehicle: &Vehicle, timers: &Timers, now: Millis) -> Option<Line> {
        if let Some(named) = self.fire() {
            return Some(Line::of(named, Stop, vehicle));
        }
        let turn = self.turn?;
        let shown = self.told().filter(|fault| fault.severity == turn.severity);
        let fault = shown.clone().nth(turn.place)?;
        let named = fault.named(fault.reporter()?.row, vehicle, timers, now);
        let (position, count) = (turn.place as u8 + 1, shown.count() as u8);
        Some(Line { position, count, ..Line::of(named, fault.severity, vehicle) })
    }

    /// Returns one of the faults that are milder than the STOP on the line: each stands for four turns, of which it has the
    /// last even where there is only one place.
    pub(crate) fn below(&self, vehicle: &Vehicle, timers: &Timers, now: Millis) -> Option<Line> {
        if self.worst() != Stop {
            return None;
        }
        let told = || self.told().filter(|fault| fault.severity < Stop || self.burns());
        let count = told().count();
        let place = (now.0 / (4 * TURN_MS)) as usize % count.max(1);
        let fault = told().nth(place)?;
        let named = fault.named(fault.reporter()?.row, vehicle, timers, now);
        let (position, count) = (place as u8 + 1, count as u8);
        Some(Line { position, count, ..Line::of(named, fault.severity, vehicle) })
    }

    /// Returns whether the line only says that a node is missing.
    pub(crate) fn misses_a_node(&self) -> bool {
        let reporter = self.turn.and_then(|turn| REPORTERS.get(usize::from(turn.by)));
        let is_silence = |it: &Reporter| matches!(it.route.when, When::Silent(_));
        self.fire.is_none() && reporter.is_some_and(is_silence)
    }

    /// Returns whether an active fault means that the vehicle limps: by its row, or by what the vehicle's documents say.
    pub(crate) fn limps(&self, vehicle: &Vehicle) -> bool {
        let limps = |fault: &Fault, by: &Reporter| {
            let explained = Named { fault: by.row.fault, stage: 0, code: fault.code }.explained(vehicle);
            matches!(by.row.fault, FaultId::Limp | FaultId::LimpMode)
                || explained.is_some_and(|text| text.limps)
        };
        self.active.iter().any(|fault| fault.reporter().is_some_and(|by| limps(fault, by)))
    }

    /// Returns whether fire was reported since power-on.
    pub(crate) fn burns(&self) -> bool {
        self.fire.is_some()
    }

    fn fire(&self) -> Option<Named> {
        self.fire.map(|(code, _)| Named { code: Some(code), ..Named::of(FaultId::Fire) })
    }

    /// Returns how many faults are active.
    pub(crate) fn count(&self) -> usize {
        usize::from(self.burns()) + self.told().count()
    }

    /// Returns every active fault: fire, then in the order of the turns.
    pub(crate) fn active<'a>(
        &'a self,
        vehicle: &'a Vehicle,
        timers: &'a Timers,
        now: Millis,
    ) -> impl Iterator<Item = ActiveFault> + 'a {
        let fire = self.fire.zip(self.fire()).map(|((_, first), named)| ActiveFault {
            named,
            code: named.printed_code(),
            severity: Stop,
            text: named.text(vehicle),
            first,
            count: 1,
        });
        let others = self.told().filter_map(move |fault| {
            let row = fault.reporter()?.row;
            let named = fault.named(row, vehicle, timers, now);
            Some(ActiveFault {
                named,
                code: named.printed_code(),
                severity: fault.severity,
                text: named.text(vehicle),
                first: fault.first,
                count: self.history.find(row.fault, fault.code).map_or(1, |entry| entry.count),
            })
        });
        fire.into_iter().chain(others)
    }

    /// Returns what went wrong, to add what an earlier run has kept.
    pub(crate) fn history_mut(&mut self) -> &mut History {
        &mut self.history
    }

    /// Returns what went wrong.
    pub(crate) fn history(&self) -> &History {
        &self.history
    }
}
