//! Judges scenarios on a thread of its own, one after the other, on a bench of its own.

use anyhow::{Context, Result, bail};
use bench::scenario::{
    self, Action, Answer, BenchSubject, Name, Pictures, Place, Scenario, Subject, Verdict,
};
use bench_page::{Judge, Trial};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, Sender, TryRecvError};
use std::thread::JoinHandle;

/// A scenario before the judge, for whom waits for the verdict; dropped, the judge goes on to the next one.
struct Pending {
    verdict: Receiver<Result<Verdict, String>>,
    is_given_up: Arc<AtomicBool>,
}

impl Drop for Pending {
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
pub(crate) struct JudgeThread {
    cases: Option<Sender<Case>>,
    /// Tells the trial before the judge that nobody waits for it.
    last: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Drop for JudgeThread {
    fn drop(&mut self) {
        self.last.store(true, Ordering::Relaxed);
        drop(self.cases.take());
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

impl JudgeThread {
    /// Judges on a bench of its own with the image in `elf`.
    ///
    /// # Errors
    /// If the thread cannot be started.
    pub(crate) fn of_firmware(elf: PathBuf) -> Result<Self> {
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
    fn put(&mut self, scenario: Scenario) -> Pending {
        let (sender, verdict) = mpsc::channel();
        let is_given_up = Arc::new(AtomicBool::new(false));
        std::mem::replace(&mut self.last, Arc::clone(&is_given_up)).store(true, Ordering::Relaxed);
        let case = Case { scenario, verdict: sender, is_given_up: Arc::clone(&is_given_up) };
        // A judge who has gone is noticed by whoever waits for the verdict.
        if let Some(cases) = &self.cases {
            let _ = cases.send(case);
        }
        Pending { verdict, is_given_up }
    }
}

impl Judge for JudgeThread {
    fn judge(&mut self, scenario: Scenario) -> Box<dyn Trial> {
        Box::new(self.put(scenario))
    }
}

impl Trial for Pending {
    fn verdict(&mut self) -> Option<Result<Verdict, String>> {
        match self.verdict.try_recv() {
            Ok(verdict) => Some(verdict),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err("not judged: the judge has gone".into())),
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::anyhow;
    use std::sync::atomic::AtomicUsize;
    use virtual_vehicle::Kind;

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
        let mut judge = JudgeThread::start(move |_, is_given_up| {
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
        let mut trial = judge.put(scenario());
        has_begun.recv().unwrap();
        for _ in 1..40 {
            trial = judge.put(scenario());
        }
        assert!(trial.verdict.recv().unwrap().is_ok(), "the last one is judged");
        assert_eq!(most.load(Ordering::SeqCst), 1);
    }

    #[test]
    fn a_judge_who_cannot_judge_says_why() {
        let mut judge = JudgeThread::start(|_, _| Err(anyhow!("no bench"))).unwrap();
        assert_eq!(judge.put(scenario()).verdict.recv().unwrap(), Err("no bench".to_owned()));
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
