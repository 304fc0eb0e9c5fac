//! Scenarios on the page: which there are, and one that plays before the person's eyes.
//!
//! What is done is done on the page's own bench, at its times, where a person may watch and interfere. Whether every
//! expectation comes true is not judged here: a second, undisturbed run of the same scenario does that beside it, by a
//! [`Judge`], faster than real time, and the page is told of each check when the story has come to it.

use crate::wires::Wires;
use anyhow::{Result, anyhow};
use bench::rig::Rig;
use bench::scenario::{self, Act, Action, BusFault, Check, Scenario, Verdict};
use bench::time::Nanos;
use cluster::Button;
use serde::Serialize;
use virtual_vehicle::{Kind, Takes, VirtualVehicle};

/// A scenario to choose from.
#[derive(Debug, Serialize)]
pub(crate) struct Scene {
    name: String,
    title: String,
}

/// One thing that is done: seconds from the start, what.
#[derive(Clone, Debug, Serialize)]
struct Deed(f64, String);

/// One expectation, in the words of the scenario file.
#[derive(Clone, Debug, Serialize)]
struct Expectation {
    /// Seconds at which it is decided.
    at: f64,
    expected: String,
    /// What there was and whether it was so; `None` until the story has come there.
    found: Option<Found>,
}

/// What became of an expectation.
#[derive(Clone, Debug, Serialize)]
struct Found {
    got: String,
    passed: bool,
}

/// What the page knows of the scenario that plays.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Story {
    name: String,
    title: String,
    rules: Vec<String>,
    /// Seconds.
    end: f64,
    deeds: Vec<Deed>,
    /// `None` until the judging run has come to its end.
    checks: Option<Vec<Expectation>>,
    /// Why the judging run could not be done.
    problem: Option<String>,
}

/// A scenario that plays.
pub(crate) struct Playing {
    acts: std::vec::IntoIter<Act>,
    waiting: Option<Act>,
    judged: Judged,
    story: Story,
}

/// Where a verdict comes from.
enum Judged {
    /// The judge has it before him.
    Pending(Box<dyn Trial>),
    /// He has decided.
    Done(Verdict),
    /// There is none; the story says why.
    Never,
}

/// Who judges scenarios on a bench of his own, beside the page's.
pub trait Judge: Send {
    /// Puts a scenario before the judge, who leaves the former one.
    fn judge(&mut self, scenario: Scenario) -> Box<dyn Trial>;
}

/// A scenario before the judge; dropped, nobody waits for the verdict any more.
pub trait Trial: Send {
    /// The verdict once there is one, or why there will be none.
    fn verdict(&mut self) -> Option<Result<Verdict, String>>;
}

/// A scenario file: its name with the folder, and its text.
pub type Text = (String, String);

/// The scenarios that can be played: reads the files of a vehicle, wherever they are kept.
pub struct Library(Box<dyn Fn(Kind) -> Vec<Text> + Send>);

impl Library {
    /// Takes the files of a vehicle from `texts`.
    pub fn new(texts: impl Fn(Kind) -> Vec<Text> + Send + 'static) -> Self {
        Self(Box::new(texts))
    }

    /// Lists the scenarios of a vehicle; one that is wrong is left to `cargo xtask scenario` to complain about.
    pub(crate) fn list(&self, kind: Kind) -> Vec<Scene> {
        let files = (self.0)(kind);
        let read = files.iter().filter_map(|(file, text)| scenario::parse(file, kind, text).ok());
        read.map(|scenario| Scene { name: scenario.name().to_owned(), title: scenario.title }).collect()
    }

    /// Returns the scenario of this name.
    ///
    /// # Errors
    /// If there is none, or its file is wrong.
    pub fn find(&self, kind: Kind, name: &str) -> Result<Scenario> {
        let path = format!("{}/{name}.toml", kind.name());
        let mut files = (self.0)(kind).into_iter();
        let (file, text) = files
            .find(|(file, _)| *file == path)
            .ok_or_else(|| anyhow!("{} has no scenario `{name}`", kind.name()))?;
        scenario::parse(&file, kind, &text)
    }
}

impl Playing {
    /// Puts the scenario's own vehicle on a fresh bench and has the scenario judged beside it.
    pub(crate) fn start(
        scenario: Scenario,
        rig: &mut Rig,
        judge: Option<&mut (dyn Judge + 'static)>,
    ) -> Self {
        rig.drive(VirtualVehicle::new(scenario.kind, scenario.options));
        let unjudged = "not judged: there is no image for a second run";
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
            problem: judge.is_none().then(|| unjudged.to_owned()),
        };
        let acts = scenario.acts.clone().into_iter();
        let judged = judge.map_or(Judged::Never, |judge| Judged::Pending(judge.judge(scenario)));
        Self { acts, waiting: None, judged, story }
    }

    /// Does what is due at this virtual time.
    ///
    /// # Errors
    /// If the vehicle does not take a setting.
    pub(crate) fn act(&mut self, rig: &mut Rig, wires: &mut Wires) -> Result<(), String> {
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

    /// What the page is told at this virtual time; of the verdict, only what the story has come to.
    pub(crate) fn story(&mut self, now: Nanos) -> &Story {
        if let Judged::Pending(trial) = &mut self.judged {
            match trial.verdict() {
                Some(Ok(verdict)) => self.judged = Judged::Done(verdict),
                Some(Err(problem)) => self.is_not_judged(problem),
                None => {}
            }
        }
        if let Judged::Done(verdict) = &self.judged {
            let now_ms = now.0 / 1_000_000;
            let expectation = |check: &Check| Expectation {
                at: seconds(check.at_ms),
                expected: check.expected.clone(),
                found: (check.at_ms <= now_ms)
                    .then(|| Found { got: check.got.clone(), passed: check.passed }),
            };
            self.story.checks = Some(verdict.checks.iter().map(expectation).collect());
        }
        &self.story
    }

    fn is_not_judged(&mut self, problem: String) {
        (self.judged, self.story.problem) = (Judged::Never, Some(problem));
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
        BusFault::PowerCut => "power.cut",
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
