//! Runs a scenario against a subject and says what became of each expectation.
//!
//! Time goes in steps of 10 ms. What is looked at is written down with its time; the verdict is reached afterwards,
//! because a sound is only known in hindsight. What a step does at some instant, happens before anything is looked at.

use serde::{Deserialize, Serialize};

use super::{Answer, Demand, Name, Scenario, Subject, Wanted};

/// Time from one look to the next, in milliseconds: the cluster's own tick.
const LOOK_MS: u64 = 10;

/// What became of one expectation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Line in the file.
    pub line: usize,
    /// What was expected: `sound none`.
    pub expected: String,
    /// When it was decided, in milliseconds.
    pub at_ms: u64,
    /// What there was then.
    pub got: String,
    /// It was as expected.
    pub passed: bool,
}

/// What became of a scenario.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// Every expectation that this subject can answer, in the order of the file.
    pub checks: Vec<Check>,
    /// Failures as lines for a person; empty = passed.
    pub failures: Vec<String>,
}

/// What was found, when it changed.
type Timeline = Vec<(u64, Option<Answer>)>;

/// Runs a scenario to its end.
pub fn run(scenario: &Scenario, subject: &mut dyn Subject) -> Verdict {
    let mut timelines: Vec<Timeline> = vec![Timeline::new(); scenario.demands.len()];
    let stopped = drive(scenario, subject, &mut timelines).err();
    let mut verdict = Verdict { checks: Vec::new(), failures: Vec::new() };
    for (demand, timeline) in scenario.demands.iter().zip(&mut timelines) {
        if demand.name == Name::Sound {
            *timeline = sounds(demand, subject);
        }
        if let Some(check) = judge(demand, timeline) {
            if !check.passed {
                let seconds = check.at_ms as f64 / 1_000.0;
                let (file, line, place) = (&scenario.file, check.line, subject.place());
                verdict.failures.push(format!(
                    "{file}:{line}: at {seconds} s expected {}, got {} ({place})",
                    check.expected, check.got
                ));
            }
            verdict.checks.push(check);
        }
    }
    if let Some((line, error)) = stopped {
        verdict.failures.insert(0, format!("{}:{line}: {error:#} ({})", scenario.file, subject.place()));
    }
    verdict
}

/// Lets time pass, does what is to be done and writes down what is seen; stops at what cannot be done, with its line.
fn drive(
    scenario: &Scenario,
    subject: &mut dyn Subject,
    timelines: &mut [Timeline],
) -> Result<(), (usize, anyhow::Error)> {
    let mut acts = scenario.acts.iter().peekable();
    for now in (0..=scenario.end_ms.next_multiple_of(LOOK_MS)).step_by(LOOK_MS as usize) {
        let here = acts.peek().map_or(1, |act| act.line);
        subject.advance_to(now).map_err(|error| (here, error))?;
        while let Some(act) = acts.next_if(|act| act.at_ms <= now) {
            subject.act(&act.action).map_err(|error| (act.line, error))?;
        }
        for (demand, timeline) in scenario.demands.iter().zip(&mut *timelines) {
            if demand.name != Name::Sound && (demand.at_ms..=demand.last_ms()).contains(&now) {
                let answer = match (&demand.name, &demand.wanted) {
                    (Name::Picture, Wanted::Words(files)) => {
                        files.first().and_then(|file| subject.picture(file))
                    }
                    (name, _) => subject.look(name),
                };
                note(timeline, now, answer);
            }
        }
    }
    if scenario.demands.iter().any(|demand| demand.name == Name::Sound) {
        let end = scenario.end_ms + subject.hindsight_ms();
        subject.advance_to(end).map_err(|error| (1, error))?;
    }
    Ok(())
}

/// Runs a scenario and tells `tell` every change of what a driver sees and hears: time in ms, name, what it is now.
///
/// # Errors
/// If the subject cannot go on.
pub fn trace(
    scenario: &Scenario,
    subject: &mut dyn Subject,
    tell: &mut dyn FnMut(u64, &str, &str) -> std::io::Result<()>,
) -> anyhow::Result<()> {
    let names = Name::on_screen();
    let mut last: Vec<Option<Answer>> = vec![None; names.len()];
    let mut acts = scenario.acts.iter().peekable();
    for now in (0..=scenario.end_ms.next_multiple_of(LOOK_MS)).step_by(LOOK_MS as usize) {
        subject.advance_to(now)?;
        while let Some(act) = acts.next_if(|act| act.at_ms <= now) {
            tell(now, "do", &format!("{:?}", act.action))?;
            subject.act(&act.action)?;
        }
        for (name, last) in names.iter().zip(&mut last) {
            let answer = subject.look(name);
            if answer != *last
                && let Some(answer) = &answer
            {
                tell(now, &name.to_string(), &answer.to_string())?;
            }
            *last = answer;
        }
    }
    Ok(())
}

fn note(timeline: &mut Timeline, now: u64, answer: Option<Answer>) {
    if timeline.last().is_none_or(|(_, last)| *last != answer) {
        timeline.push((now, answer));
    }
}

fn sounds(demand: &Demand, subject: &dyn Subject) -> Timeline {
    let mut timeline = Timeline::new();
    for now in (demand.at_ms..=demand.last_ms()).step_by(LOOK_MS as usize) {
        note(&mut timeline, now, Some(subject.sound_at(now)));
    }
    timeline
}

impl Demand {
    /// The last moment that it is looked at.
    fn last_ms(&self) -> u64 {
        self.until_ms.unwrap_or(self.settled_ms)
    }

    fn expected(&self) -> String {
        let never = if self.never { "never " } else { "" };
        format!("{} {never}{}", self.name, self.wanted)
    }
}

/// Decides about one expectation; `None` = this subject cannot be asked.
fn judge(demand: &Demand, timeline: &Timeline) -> Option<Check> {
    if !timeline.is_empty() && timeline.iter().all(|(_, answer)| answer.is_none()) {
        return None;
    }
    let fits = |answer: &Option<Answer>| answer.as_ref().is_some_and(|answer| demand.wanted.fits(answer));
    let check = |at_ms: u64, answer: Option<&Answer>, passed| {
        let got = answer.map_or_else(|| "nothing: the run ended before".into(), ToString::to_string);
        Some(Check { line: demand.line, expected: demand.expected(), at_ms, got, passed })
    };
    let Some((_, last)) = timeline.last() else { return check(demand.at_ms, None, false) };
    if demand.until_ms.is_none() {
        // Once is enough.
        let found = timeline.iter().find(|(_, answer)| fits(answer));
        let (at_ms, answer) = found.map_or((demand.at_ms, last), |(at, answer)| (*at, answer));
        return check(at_ms, answer.as_ref(), found.is_some());
    }
    // Throughout, from the time by which it has settled: what was found last before that counts from then on.
    let settled = timeline.iter().rposition(|(at, _)| *at <= demand.settled_ms).unwrap_or(0);
    let surely =
        |answer: &Option<Answer>| answer.as_ref().is_some_and(|answer| demand.wanted.surely_fits(answer));
    let is_wrong = |answer: &Option<Answer>| if demand.never { surely(answer) } else { !fits(answer) };
    let wrong = timeline[settled..].iter().find(|(_, answer)| is_wrong(answer));
    let (at_ms, answer) = wrong.map_or((demand.last_ms(), last), |(at, answer)| (*at, answer));
    check(at_ms.max(demand.settled_ms), answer.as_ref(), wrong.is_none())
}

#[cfg(test)]
mod tests {
    use super::super::{Action, Place, parse};
    use super::*;
    use anyhow::Result;
    use virtual_vehicle::Kind;

    /// Shows the lamp of READY for a while, sounds for a while.
    struct Script {
        now_ms: u64,
        lit: (u64, u64),
        sound: (u64, u64),
        broken_at: u64,
    }

    impl Subject for Script {
        fn place(&self) -> Place {
            Place::Host
        }

        fn advance_to(&mut self, ms: u64) -> Result<()> {
            self.now_ms = ms;
            if ms >= self.broken_at { Err(anyhow::anyhow!("it broke")) } else { Ok(()) }
        }

        fn act(&mut self, _: &Action) -> Result<()> {
            Ok(())
        }

        fn look(&mut self, name: &Name) -> Option<Answer> {
            let lit = (self.lit.0..self.lit.1).contains(&self.now_ms);
            matches!(name, Name::Telltale(_)).then(|| Answer::word(if lit { "on" } else { "off" }))
        }

        fn sound_at(&self, ms: u64) -> Answer {
            let sounds = (self.sound.0..self.sound.1).contains(&ms);
            Answer::word(if sounds { "stop" } else { "none" })
        }

        fn hindsight_ms(&self) -> u64 {
            0
        }
    }

    fn failures(steps: &str) -> Vec<String> {
        let text = format!("title = \"t\"\nsteps = [\n{steps}\n]\n");
        let scenario = parse("citybus/test.toml", Kind::Citybus, &text).unwrap();
        let mut subject = Script { now_ms: 0, lit: (1_000, 2_000), sound: (1_000, 2_000), broken_at: 60_000 };
        run(&scenario, &mut subject).failures
    }

    #[test]
    fn an_expectation_must_come_true_within_its_time() {
        for name in [("telltale.ready = \"on\""), ("sound = \"stop\"")] {
            let step =
                |at: f64, within: f64| format!("{{ at = {at}, expect = {{ {name} }}, within = {within} }},");
            assert!(failures(&step(0.7, 0.3)).is_empty());
            assert_eq!(failures(&step(0.7, 0.29)).len(), 1);
            assert!(failures(&step(1.99, 0.0)).is_empty());
            assert_eq!(failures(&step(2.0, 5.0)).len(), 1);
        }
    }

    #[test]
    fn what_must_hold_until_a_time_may_not_fail_once() {
        let step = |at: f64, until: f64| {
            format!("{{ at = {at}, expect = {{ telltale.ready = \"on\" }}, within = 0.1, until = {until} }},")
        };
        assert!(failures(&step(0.9, 1.99)).is_empty());
        assert_eq!(
            failures(&step(0.9, 2.5)),
            ["citybus/test.toml:3: at 2 s expected telltale.ready on, got off (host)"]
        );
        assert_eq!(
            failures(&step(0.8, 1.5)),
            ["citybus/test.toml:3: at 0.9 s expected telltale.ready on, got off (host)"]
        );
    }

    #[test]
    fn what_must_never_be_may_not_be_once() {
        let step = |at: f64, until: f64| {
            format!("{{ at = {at}, never = {{ sound = \"stop\" }}, within = 0, until = {until} }},")
        };
        assert!(failures(&step(0.0, 0.99)).is_empty());
        assert!(failures(&step(2.0, 9.0)).is_empty());
        assert_eq!(
            failures(&step(0.0, 1.0)),
            ["citybus/test.toml:3: at 1 s expected sound never stop, got stop (host)"]
        );
    }

    #[test]
    fn what_the_subject_cannot_show_is_left_out_and_a_stop_fails_all_that_comes_later() {
        assert!(failures("{ at = 1, expect = { health.tec = 5 } },").is_empty());
        let text = "title = \"t\"\nsteps = [\n{ at = 1.2, expect = { telltale.ready = true } },\n\
                    { at = 5, expect = { telltale.ready = false, sound = \"none\" } },\n]\n";
        let scenario = parse("citybus/test.toml", Kind::Citybus, text).unwrap();
        let mut subject = Script { now_ms: 0, lit: (1_000, 2_000), sound: (0, 0), broken_at: 3_000 };
        let failures = run(&scenario, &mut subject).failures;
        assert_eq!(failures[0], "citybus/test.toml:1: it broke (host)");
        assert!(
            failures[1].contains("citybus/test.toml:4: at 5 s expected telltale.ready off, got nothing"),
            "{failures:?}"
        );
    }
}
