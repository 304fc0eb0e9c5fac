//! Scenarios on the page: which there are, and one that plays before the person's eyes.
//!
//! What is done is done on the page's own bench, at its times, where a person may watch and interfere. Whether every
//! expectation comes true is not judged here: a second, undisturbed run of the same scenario does that on a thread of
//! its own, faster than real time, and the page shows each check when the story has come to it.

use super::wires::Wires;
use crate::rig::Rig;
use crate::scenario::{self, Act, Action, BenchSubject, BusFault, Pictures, Scenario, Verdict};
use anyhow::{Result, anyhow};
use cluster::Button;
use serde::Serialize;
use std::path::Path;
use std::sync::mpsc::{self, Receiver, TryRecvError};
use virtual_vehicle::{Kind, Takes, VirtualVehicle};

/// A scenario to choose from.
#[derive(Debug, Serialize)]
pub(super) struct Scene {
    name: String,
    title: String,
}

/// One thing that is done: seconds from the start, what.
#[derive(Clone, Debug, Serialize)]
struct Deed(f64, String);

/// One expectation: seconds at which it was decided, what was expected, what there was, whether it was so.
#[derive(Clone, Debug, Serialize)]
struct Found(f64, String, String, bool);

/// What the page knows of the scenario that plays.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Story {
    name: String,
    title: String,
    rules: Vec<String>,
    /// Seconds.
    end: f64,
    deeds: Vec<Deed>,
    /// `None` until the judging run has come to its end.
    checks: Option<Vec<Found>>,
    /// Why the judging run could not be done.
    problem: Option<String>,
}

/// A scenario that plays.
pub(super) struct Playing {
    acts: std::vec::IntoIter<Act>,
    waiting: Option<Act>,
    judge: Receiver<Result<Verdict, String>>,
    story: Story,
}

/// Lists the scenarios of a vehicle; one that cannot be read is left to `cargo xtask scenario` to complain about.
pub(super) fn list(kind: Kind) -> Vec<Scene> {
    let files = scenario::files(kind).unwrap_or_default();
    let read = files.iter().filter_map(|file| scenario::read_file(file).ok());
    read.map(|scenario| Scene { name: scenario.name().to_owned(), title: scenario.title }).collect()
}

/// Returns the scenario of this name.
///
/// # Errors
/// If there is none, or its file is wrong.
pub(super) fn find(kind: Kind, name: &str) -> Result<Scenario> {
    let mut files = scenario::files(kind)?.into_iter();
    let file = files.find(|file| file.file_stem().is_some_and(|stem| stem == name));
    scenario::read_file(&file.ok_or_else(|| anyhow!("{} has no scenario `{name}`", kind.name()))?)
}

impl Playing {
    /// Puts the scenario's own vehicle on a fresh bench and has the scenario judged beside it.
    pub(super) fn start(scenario: Scenario, rig: &mut Rig, elf: Option<&Path>) -> Self {
        rig.drive(VirtualVehicle::new(scenario.kind, scenario.options));
        let story = Story {
            name: scenario.name().to_owned(),
            title: scenario.title.clone(),
            rules: scenario.rules.clone(),
            end: seconds(scenario.end_ms),
            deeds: scenario
                .acts
                .iter()
                .map(|act| Deed(seconds(act.at_ms), describe(&act.action, rig)))
                .collect(),
            checks: None,
            problem: None,
        };
        let acts = scenario.acts.clone().into_iter();
        let (verdict, judge) = mpsc::channel();
        if let Some(elf) = elf.map(Path::to_owned) {
            // Without a thread there is no verdict, and the page says so.
            let _ = std::thread::Builder::new().name("judge".into()).spawn(move || {
                let golden = scenario::folder().join(scenario.kind.name());
                let pictures = Pictures { golden, actual: std::env::temp_dir(), bless: false };
                let subject = BenchSubject::new(&elf, scenario.kind, scenario.options, pictures);
                let judged = subject.map(|mut subject| scenario::run(&scenario, &mut subject));
                // The page may have gone on to something else.
                let _ = verdict.send(judged.map_err(|error| format!("{error:#}")));
            });
        }
        Self { acts, waiting: None, judge, story }
    }

    /// Does what is due at this virtual time.
    ///
    /// # Errors
    /// If the vehicle does not take a setting.
    pub(super) fn act(&mut self, rig: &mut Rig, wires: &mut Wires) -> Result<(), String> {
        let now_ms = rig.now().0 / 1_000_000;
        while let Some(act) = self.waiting.take().or_else(|| self.acts.next()) {
            if act.at_ms > now_ms {
                self.waiting = Some(act);
                break;
            }
            perform(&act.action, rig, wires)?;
        }
        Ok(())
    }

    /// What the page is told; the verdict is in it once there is one.
    pub(super) fn story(&mut self) -> &Story {
        match self.judge.try_recv() {
            Ok(Ok(verdict)) => {
                let found = verdict.checks.into_iter();
                let found =
                    found.map(|check| Found(seconds(check.at_ms), check.expected, check.got, check.passed));
                self.story.checks = Some(found.collect());
            }
            Ok(Err(problem)) => self.story.problem = Some(problem),
            Err(TryRecvError::Disconnected)
                if self.story.checks.is_none() && self.story.problem.is_none() =>
            {
                self.story.problem = Some("not judged: there is no image for a second run".into());
            }
            Err(_) => {}
        }
        &self.story
    }
}

fn perform(action: &Action, rig: &mut Rig, wires: &mut Wires) -> Result<(), String> {
    match action {
        Action::Set { path, setting } => {
            let Some(vehicle) = rig.vehicle_mut() else { return Ok(()) };
            vehicle.set(path, *setting).map_err(|error| error.to_string())?;
        }
        Action::Hold(button, down) => rig.hold_button(index(*button), *down),
        Action::Fault(fault, on) => {
            wires.set(rig, wire(*fault), *on);
        }
        Action::Send(frame) => rig.send(*frame),
    }
    Ok(())
}

const fn index(button: Button) -> usize {
    match button {
        Button::Next => 0,
        Button::Menu => 1,
    }
}

const fn wire(fault: BusFault) -> &'static str {
    match fault {
        BusFault::Short => "bus.short",
        BusFault::Babble => "bus.babble",
        BusFault::Garble => "bus.garble",
        BusFault::Unplug => "bus.unplug",
    }
}

/// Says what is done as a scenario file does: `driver.gear = D`.
fn describe(action: &Action, rig: &Rig) -> String {
    let on = |on: &bool| if *on { "on" } else { "off" };
    match action {
        Action::Set { path, setting: None } => format!("{path} = auto"),
        Action::Set { path, setting: Some(number) } => {
            let controls = rig.vehicle().into_iter().flat_map(VirtualVehicle::controls);
            let takes = controls.filter(|control| control.path == path).map(|control| control.takes).next();
            match takes {
                Some(Takes::Flag) => format!("{path} = {}", on(&(*number == 1.0))),
                Some(Takes::Choice(words)) => {
                    let word = words.get(*number as usize).map_or("?", |word| word.word);
                    format!("{path} = {word}")
                }
                Some(Takes::Number { unit, .. }) => format!("{path} = {number} {unit}").trim_end().to_owned(),
                None => format!("{path} = {number}"),
            }
        }
        Action::Hold(button, down) => format!("button {} = {}", ["A", "B"][index(*button)], on(down)),
        Action::Fault(fault, is_on) => format!("{} = {}", wire(*fault), on(is_on)),
        Action::Send(frame) => format!("send {frame}"),
    }
}

fn seconds(ms: u64) -> f64 {
    ms as f64 / 1e3
}
