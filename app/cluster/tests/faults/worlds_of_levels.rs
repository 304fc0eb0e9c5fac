//! Fault arbitration against a second, naive statement of it, over every sequence of a small world.
//!
//! The model below keeps the whole history and asks it; the cluster keeps a set and updates it. They share no code.

use crate::support::toy::*;
use crate::support::*;
use protocol_core::{Millis, Severity};
use std::collections::BTreeSet;

/// What a source says at one instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Says {
    Nothing,
    Clear,
    Fault(Severity, u16),
}

/// One step of a world: what the sources send, and for how long.
#[derive(Clone, Copy, Debug)]
struct Step {
    /// Level and code of the vehicle controller, `None` = it is silent.
    vehicle: Option<(u8, u16)>,
    /// Level and code of the battery.
    battery: (u8, u8),
    dcdc_failed: bool,
    ms: u64,
}

fn severity(level: u8) -> Severity {
    [Severity::None, Severity::Warn, Severity::Derate, Severity::Stop][usize::from(level)]
}

/// The history of one world: for every tick, what each source said.
#[derive(Clone, Default)]
struct History {
    level: Vec<Says>,
    code: Vec<Says>,
    battery: Vec<Says>,
    silent: Vec<bool>,
    dcdc: Vec<bool>,
}

impl History {
    fn tick(&mut self, step: &Step, silence_ms: u64) {
        let last = |says: &[Says]| says.last().copied().unwrap_or(Says::Nothing);
        let (level, code) = match step.vehicle {
            Some((level, code)) => (
                if level > 0 { Says::Fault(severity(level), 0) } else { Says::Clear },
                if code > 0 { Says::Fault(severity(level), code) } else { Says::Clear },
            ),
            // Until the time-out the last frame still counts.
            None if silence_ms < FAULTS_TIMEOUT => (last(&self.level), last(&self.code)),
            None => (Says::Nothing, Says::Nothing),
        };
        self.level.push(level);
        self.code.push(code);
        let (level, code) = step.battery;
        let says = if level > 0 { Says::Fault(severity(level), u16::from(code)) } else { Says::Clear };
        self.battery.push(says);
        self.silent.push(step.vehicle.is_none() && silence_ms >= FAULTS_TIMEOUT);
        self.dcdc.push(step.dcdc_failed);
    }

    /// Returns how bad `code` stands at the last tick, `None` = it is not active.
    fn stands(says: &[Says], code: u16) -> Option<Severity> {
        let reported = |&says: &Says| matches!(says, Says::Fault(_, other) if other == code);
        let last = says.iter().rposition(reported)?;
        let Says::Fault(severity, _) = says[last] else { return None };
        let since = &says[last + 1..];
        let forgotten = match since.iter().rposition(|&says| says != Says::Nothing) {
            // Ten seconds without it, counted only while the source speaks.
            Some(latest) => (latest as u64 + 1) * CYCLE >= 10_000,
            None => false,
        };
        let taken_back = since.iter().any(|&says| match says {
            Says::Clear => true,
            Says::Fault(other, _) => other < severity,
            Says::Nothing => severity < Severity::Stop,
        });
        (!forgotten && !taken_back).then_some(severity)
    }

    /// Returns the severity that is shown and all lines of it.
    fn shown(&self, codes: &[u16]) -> (Severity, BTreeSet<(&'static str, u16)>) {
        let mut faults = Vec::new();
        let level = Self::stands(&self.level, 0);
        if let Some(severity) = level {
            let text = ["", "System fault level 1", "System fault level 2", "System fault level 3"];
            faults.push((severity, text[severity as usize], 0));
        }
        let name = |code| match code {
            3 => "Cell overvoltage",
            4 => "Cell undervoltage",
            _ => "Vehicle fault code",
        };
        for &code in codes {
            let vehicle = Self::stands(&self.code, code);
            faults.extend(vehicle.map(|severity| (severity, name(code), code)));
            // The vehicle arbitrates: what it reports is not repeated; what it takes over starts afresh.
            let battery: Vec<Says> = (0..self.battery.len())
                .map(|tick| {
                    let forwarded = |code| Self::stands(&self.code[..=tick], code).is_some();
                    match self.battery[tick] {
                        Says::Fault(_, code) if forwarded(code) => Says::Clear,
                        says => says,
                    }
                })
                .collect();
            let battery = Self::stands(&battery, code);
            faults.extend(battery.map(|severity| (severity, name(code), code)));
        }
        if self.dcdc.last() == Some(&true) {
            // Joins what the vehicle reports now, and is at least WARN.
            let now = match self.level.last() {
                Some(Says::Fault(severity, _)) => *severity,
                _ => Severity::None,
            };
            faults.push((now.max(Severity::Warn), "DC/DC converter fault", 5));
        }
        if self.silent.last() == Some(&true) {
            faults.push((Severity::Derate, "No communication: VCU", 0));
        }
        let worst = faults.iter().map(|fault| fault.0).max().unwrap_or_default();
        let lines = faults.iter().filter(|fault| fault.0 == worst).map(|&(_, text, code)| (text, code));
        (worst, lines.collect())
    }
}

/// A world so far: the cluster, what was sent to it, and what the naive statement remembers.
#[derive(Clone)]
struct World {
    drive: Drive,
    history: History,
    last_heard: Millis,
    past: Vec<Step>,
}

impl World {
    fn new() -> Self {
        let mut drive = healthy();
        drive.run(CYCLE);
        let mut history = History::default();
        history.tick(&Step { vehicle: Some((0, 0)), battery: (0, 0), dcdc_failed: false, ms: CYCLE }, 0);
        let last_heard = Millis(drive.now.0 - CYCLE);
        Self { drive, history, last_heard, past: Vec::new() }
    }

    /// Lives through one step and compares at its start and at its end.
    fn live(&mut self, step: Step) {
        self.past.push(step);
        match step.vehicle {
            Some((level, code)) => self.drive.report(level, code),
            None => self.drive.stop(FAULTS),
        }
        self.drive.battery_report(step.battery.0, step.battery.1);
        self.drive.repeat(PARTS, [1 + u8::from(step.dcdc_failed), 5, 1, 0, 1, 0, 0, 0]);
        let ticks = step.ms / CYCLE;
        for tick in 0..ticks {
            if step.vehicle.is_some() {
                self.last_heard = self.drive.now;
            }
            self.history.tick(&step, self.drive.now.since(self.last_heard));
            let at = self.drive.now;
            self.drive.run_by(CYCLE, CYCLE);
            if tick < 2 || tick + 2 >= ticks {
                self.compare(at, tick);
            }
        }
    }

    fn compare(&self, at: Millis, tick: u64) {
        let (worst, lines) = self.history.shown(&[3, 4, 700]);
        let view = self.drive.cluster.view(at);
        let when = || format!("at tick {tick} of the last step of {:#?}", self.past);
        assert_eq!(view.severity, worst, "{}", when());
        let count = usize::from(view.line.map_or(0, |line| line.count));
        assert_eq!(count, lines.len(), "{lines:?} {}", when());
        let shown = view.line.map(|line| (line.text.en, line.code.unwrap_or(0)));
        assert!(
            shown.is_none_or(|line| lines.contains(&line)),
            "{shown:?} is not among {lines:?} {}",
            when()
        );
    }
}

/// Lives through every sequence of `depth` steps out of `steps`.
fn every_sequence(steps: &[Step], depth: u32) {
    fn live_on(world: &World, steps: &[Step], depth: u32) {
        for &step in steps {
            let mut next = world.clone();
            next.live(step);
            if depth > 1 {
                live_on(&next, steps, depth - 1);
            }
        }
    }
    live_on(&World::new(), steps, depth);
}

fn steps(vehicle: &[Option<(u8, u16)>], battery: &[(u8, u8)], dcdc: &[bool], ms: &[u64]) -> Vec<Step> {
    let mut steps = Vec::new();
    for &vehicle in vehicle {
        for &battery in battery {
            for &dcdc_failed in dcdc {
                steps.extend(ms.iter().map(|&ms| Step { vehicle, battery, dcdc_failed, ms }));
            }
        }
    }
    steps
}

#[test]
fn every_history_of_the_vehicle_s_own_report_is_shown_as_stated() {
    let vehicle =
        [Some((0, 0)), Some((1, 3)), Some((1, 700)), Some((3, 4)), Some((3, 700)), Some((0, 700)), None];
    every_sequence(&steps(&vehicle, &[(0, 0)], &[false], &[100, 10_000]), 4);
}

#[test]
fn every_mixture_of_three_sources_is_shown_as_stated() {
    let vehicle = [Some((0, 0)), Some((2, 3)), Some((3, 4)), None];
    let battery = [(0, 0), (1, 3), (3, 4)];
    every_sequence(&steps(&vehicle, &battery, &[false, true], &[700]), 3);
}

#[test]
fn every_time_around_the_boundaries_is_shown_as_stated() {
    let vehicle = [Some((2, 3)), Some((2, 4)), None];
    every_sequence(&steps(&vehicle, &[(0, 0)], &[false], &[500, 600, 9_800, 9_900, 10_000]), 3);
}
