//! Scenarios on the page: which there are, and one that plays before the person's eyes.
//!
//! What is done is done on the page's own bench, at its times, where a person may watch and interfere. Whether every
//! expectation comes true is not judged here: a second, undisturbed run of the same scenario does that on the thread of
//! the [`Judge`], faster than real time, and the page is told of each check when the story has come to it.

use super::wires::Wires;
use crate::rig::Rig;
use crate::scenario::{
    self, Act, Action, Answer, BenchSubject, BusFault, Check, Name, Pictures, Place, Scenario, Subject,
    Verdict,
};
use crate::time::Nanos;
use anyhow::{Context, Result, anyhow, bail};
use cluster::Button;
use serde::Serialize;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, Sender, TryRecvError};
use std::thread::JoinHandle;
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
pub(super) struct Story {
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
pub(super) struct Playing {
    acts: std::vec::IntoIter<Act>,
    waiting: Option<Act>,
    judged: Judged,
    story: Story,
}

/// Where a verdict comes from.
enum Judged {
    /// The judge has it before him.
    Pending(Trial),
    /// He has decided.
    Done(Verdict),
    /// There is none; the story says why.
    Never,
}

/// A scenario before the judge, for whom waits for the verdict; dropped, the judge goes on to the next one.
struct Trial {
    verdict: Receiver<Result<Verdict, String>>,
    is_given_up: Arc<AtomicBool>,
}

impl Drop for Trial {
    fn drop(&mut self) {
        self.is_given_up.store(true, Ordering::Relaxed);
    }
}

/// The same, for the judge.
struct Case {
    scenario: Scenario,
    verdict: Sender<Result<Verdict, String>>,
    is_given_up: Arc<AtomicBool>,
}

/// The thread that judges scenarios, one after the other; dropped, it has ended.
pub(super) struct Judge {
    cases: Option<Sender<Case>>,
    /// Tells the trial before the judge that nobody waits for it.
    last: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Drop for Judge {
    fn drop(&mut self) {
        self.last.store(true, Ordering::Relaxed);
        drop(self.cases.take());
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

impl Judge {
    /// Judges on a bench of its own with the image in `elf`.
    ///
    /// # Errors
    /// If the thread cannot be started.
    pub(super) fn of_firmware(elf: PathBuf) -> Result<Self> {
        Self::start(move |scenario, is_given_up| {
            let pictures = Pictures::of(scenario.kind, &std::env::temp_dir().join("cluster-bench"), false);
            let bench = BenchSubject::new(&elf, scenario.kind, scenario.options, pictures)?;
            Ok(scenario::run(scenario, &mut Watched { subject: bench, is_given_up }))
        })
    }

    fn start(
        mut judge: impl FnMut(&Scenario, &AtomicBool) -> Result<Verdict> + Send + 'static,
    ) -> Result<Self> {
        let (cases, given) = mpsc::channel::<Case>();
        let work = move || {
            for case in given {
                if !case.is_given_up.load(Ordering::Relaxed) {
                    let verdict = judge(&case.scenario, &case.is_given_up);
                    // The page may have gone on to something else.
                    let _ = case.verdict.send(verdict.map_err(|error| format!("{error:#}")));
                }
            }
        };
        let thread = std::thread::Builder::new().name("judge".into());
        let thread = thread.spawn(work).context("no thread for judging scenarios")?;
        Ok(Self { cases: Some(cases), last: Arc::default(), thread: Some(thread) })
    }

    /// Puts a scenario before the judge, who leaves the former one.
    fn judge(&mut self, scenario: Scenario) -> Trial {
        let (sender, verdict) = mpsc::channel();
        let is_given_up = Arc::new(AtomicBool::new(false));
        std::mem::replace(&mut self.last, Arc::clone(&is_given_up)).store(true, Ordering::Relaxed);
        let case = Case { scenario, verdict: sender, is_given_up: Arc::clone(&is_given_up) };
        // A judge who has gone is noticed by whoever waits for the verdict.
        if let Some(cases) = &self.cases {
            let _ = cases.send(case);
        }
        Trial { verdict, is_given_up }
    }
}

/// The judge's bench, which stands still at the next step once the trial is given up.
struct Watched<'j, S> {
    subject: S,
    is_given_up: &'j AtomicBool,
}

impl<S: Subject> Subject for Watched<'_, S> {
    fn place(&self) -> Place {
        self.subject.place()
    }

    fn advance_to(&mut self, ms: u64) -> Result<()> {
        if self.is_given_up.load(Ordering::Relaxed) {
            bail!("nobody waits for the verdict");
        }
        self.subject.advance_to(ms)
    }

    fn act(&mut self, action: &Action) -> Result<()> {
        self.subject.act(action)
    }

    fn look(&mut self, name: &Name) -> Option<Answer> {
        self.subject.look(name)
    }

    fn picture(&mut self, file: &str) -> Option<Answer> {
        self.subject.picture(file)
    }

    fn sound_at(&self, ms: u64) -> Answer {
        self.subject.sound_at(ms)
    }

    fn hindsight_ms(&self) -> u64 {
        self.subject.hindsight_ms()
    }
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
    pub(super) fn start(scenario: Scenario, rig: &mut Rig, judge: Option<&mut Judge>) -> Self {
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

    /// What the page is told at this virtual time; of the verdict, only what the story has come to.
    pub(super) fn story(&mut self, now: Nanos) -> &Story {
        if let Judged::Pending(trial) = &self.judged {
            match trial.verdict.try_recv() {
                Ok(Ok(verdict)) => self.judged = Judged::Done(verdict),
                Ok(Err(problem)) => self.is_not_judged(problem),
                Err(TryRecvError::Disconnected) => {
                    self.is_not_judged("not judged: the judge has gone".into());
                }
                Err(TryRecvError::Empty) => {}
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::AtomicUsize;

    fn scenario() -> Scenario {
        scenario::parse(
            "citybus/test.toml",
            Kind::Citybus,
            "title = \"t\"\nsteps = [\n{ at = 1, expect = { speed = 0 } },\n]\n",
        )
        .unwrap()
    }

    fn nothing_found() -> Verdict {
        Verdict { checks: Vec::new(), failures: Vec::new() }
    }

    #[test]
    fn one_trial_at_a_time_and_the_one_that_is_given_up_is_left() {
        let (alive, most) = (AtomicUsize::new(0), Arc::new(AtomicUsize::new(0)));
        let (begun, has_begun) = mpsc::channel();
        let (seen, mut is_first) = (Arc::clone(&most), true);
        let mut judge = Judge::start(move |_, is_given_up| {
            seen.fetch_max(alive.fetch_add(1, Ordering::SeqCst) + 1, Ordering::SeqCst);
            // The first trial would never come to its end.
            if std::mem::take(&mut is_first) {
                begun.send(())?;
                while !is_given_up.load(Ordering::Relaxed) {
                    std::thread::yield_now();
                }
            }
            alive.fetch_sub(1, Ordering::SeqCst);
            Ok(nothing_found())
        })
        .unwrap();
        let mut trial = judge.judge(scenario());
        has_begun.recv().unwrap();
        for _ in 1..40 {
            trial = judge.judge(scenario());
        }
        assert!(trial.verdict.recv().unwrap().is_ok(), "the last one is judged");
        assert_eq!(most.load(Ordering::SeqCst), 1);
    }

    #[test]
    fn a_judge_who_cannot_judge_says_why() {
        let mut judge = Judge::start(|_, _| Err(anyhow!("no bench"))).unwrap();
        assert_eq!(judge.judge(scenario()).verdict.recv().unwrap(), Err("no bench".to_owned()));
    }

    #[test]
    fn a_trial_that_is_given_up_ends_at_the_next_step() {
        let is_given_up = AtomicBool::new(false);
        let subject = scenario::HostSubject::new(Kind::Citybus, scenario().options);
        let mut watched = Watched { subject, is_given_up: &is_given_up };
        assert!(scenario::run(&scenario(), &mut watched).checks[0].passed);
        is_given_up.store(true, Ordering::Relaxed);
        let verdict = scenario::run(&scenario(), &mut watched);
        assert!(verdict.failures[0].contains("nobody waits"), "{:?}", verdict.failures);
    }
}
