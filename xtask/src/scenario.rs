//! Runs scenario files against the cluster's logic and against the real firmware.
//!
//! Scenarios are data: bench/scenarios/README.md. Each runs where it says, on as many threads as the machine has; what
//! is printed stands in the order of the files, however they end.

use crate::out::say;
use crate::vehicles::short_seconds;
use crate::{firmware, workspace};
use anyhow::{Result, bail};
use bench::scenario::{self, BenchSubject, HostSubject, Pictures, Place, Scenario, Verdict};
use clap::{Args, ValueEnum};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;
use virtual_vehicle::Kind;

/// Which scenarios to run, and where.
#[derive(Args, Clone, Debug, Default)]
pub struct Options {
    /// Files, or names as `reverse` or `citybus/reverse`; all if none is given.
    names: Vec<String>,
    /// Runs in one place only.
    #[arg(long, value_enum)]
    on: Option<On>,
    /// Runs those of one vehicle only.
    #[arg(long, value_name = "NAME")]
    vehicle: Option<String>,
    /// Prints what there is and runs nothing.
    #[arg(long)]
    list: bool,
    /// Prints what the cluster's logic shows and sounds, when it changes, and checks nothing: for whoever writes one.
    #[arg(long, requires = "names")]
    trace: bool,
    /// Takes the pictures shown now as the new golden ones.
    #[arg(long)]
    bless: bool,
    /// Runs this ELF in place of building the firmware.
    #[arg(long)]
    elf: Option<PathBuf>,
}

/// One of the two places.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum On {
    /// The cluster's logic.
    Host,
    /// The real firmware on the bench.
    Firmware,
}

impl On {
    fn place(self) -> Place {
        match self {
            Self::Host => Place::Host,
            Self::Firmware => Place::Firmware,
        }
    }
}

/// One scenario in one place.
struct Job<'s> {
    scenario: &'s Scenario,
    place: Place,
}

/// Runs the scenarios and prints a line for each, with every expectation that failed.
///
/// # Errors
/// If a file is wrong, a name is not known or an expectation is not met.
pub fn run(options: &Options) -> Result<()> {
    let scenarios = chosen(options)?;
    if options.list {
        for scenario in &scenarios {
            let places: Vec<&str> = scenario.on.iter().map(|place| place.word()).collect();
            say!("{:36} {:14} {}", name(scenario), places.join(" "), scenario.title)?;
        }
        return Ok(());
    }
    if options.trace {
        return scenarios.iter().try_for_each(print_trace);
    }
    let is_wanted = |place: &Place| options.on.is_none_or(|on| on.place() == *place);
    let mut jobs: Vec<Job<'_>> = Vec::new();
    for scenario in &scenarios {
        jobs.extend(scenario.on.iter().copied().filter(is_wanted).map(|place| Job { scenario, place }));
    }
    let needs_firmware = jobs.iter().any(|job| job.place == Place::Firmware);
    let elf = match &options.elf {
        Some(elf) => Some(elf.clone()),
        None if needs_firmware => Some(firmware::build(&firmware::Options::default())?.elf),
        None => None,
    };
    let started = Instant::now();
    let verdicts = run_all(&jobs, elf.as_deref(), options.bless);
    report(&scenarios, &jobs, &verdicts, started.elapsed().as_secs_f64())
}

fn print_trace(scenario: &Scenario) -> Result<()> {
    say!("{}: {}", name(scenario), scenario.title)?;
    let mut subject = HostSubject::new(scenario.kind, scenario.options);
    scenario::trace(scenario, &mut subject, &mut |ms, name, now| {
        say!("{:>8} {name:24} {now}", short_seconds(ms))
    })
}

fn name(scenario: &Scenario) -> &str {
    scenario.file.strip_suffix(".toml").unwrap_or(&scenario.file)
}

/// Reads the scenarios that are asked for.
fn chosen(options: &Options) -> Result<Vec<Scenario>> {
    let kinds = match &options.vehicle {
        None => Kind::ALL.to_vec(),
        Some(vehicle) => match Kind::from_name(vehicle) {
            Some(kind) => vec![kind],
            None => {
                bail!("no vehicle `{vehicle}` drives; there are {}", Kind::ALL.map(Kind::name).join(", "))
            }
        },
    };
    let (mut scenarios, mut wrong) = (Vec::new(), Vec::new());
    for kind in kinds {
        match scenario::load(kind) {
            Ok(loaded) => scenarios.extend(loaded),
            Err(error) => wrong.push(format!("{error:#}")),
        }
    }
    if !wrong.is_empty() {
        bail!("{}", wrong.join("\n"));
    }
    if options.names.is_empty() {
        return Ok(scenarios);
    }
    for wanted in &options.names {
        if !scenarios.iter().any(|scenario| is_named(scenario, wanted)) {
            bail!("no scenario is called `{wanted}`; `cargo xtask scenario --list` shows all");
        }
    }
    scenarios.retain(|scenario| options.names.iter().any(|wanted| is_named(scenario, wanted)));
    Ok(scenarios)
}

fn is_named(scenario: &Scenario, wanted: &str) -> bool {
    let wanted = wanted.strip_suffix(".toml").unwrap_or(wanted);
    let own = name(scenario);
    wanted == scenario.name() || wanted == own || wanted.ends_with(&format!("scenarios/{own}"))
}

/// Runs every job; the longest ones first, so that no thread has to wait long for the others in the end.
fn run_all(jobs: &[Job<'_>], elf: Option<&Path>, bless: bool) -> Vec<Verdict> {
    let mut order: Vec<usize> = (0..jobs.len()).collect();
    order.sort_by_key(|index| {
        let job = &jobs[*index];
        std::cmp::Reverse((job.place, job.scenario.end_ms))
    });
    let next = AtomicUsize::new(0);
    let verdicts: Mutex<Vec<Option<Verdict>>> = Mutex::new(vec![None; jobs.len()]);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads.min(jobs.len()) {
            scope.spawn(|| {
                while let Some(&index) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let verdict = run_one(&jobs[index], elf, bless);
                    if let Ok(mut verdicts) = verdicts.lock() {
                        verdicts[index] = Some(verdict);
                    }
                }
            });
        }
    });
    let verdicts = verdicts.into_inner().unwrap_or_default();
    verdicts.into_iter().map(|verdict| verdict.unwrap_or_else(|| broken("its thread ended"))).collect()
}

fn broken(why: &str) -> Verdict {
    Verdict { checks: Vec::new(), failures: vec![why.to_owned()] }
}

fn run_one(job: &Job<'_>, elf: Option<&Path>, bless: bool) -> Verdict {
    let Scenario { kind, options, .. } = *job.scenario;
    match (job.place, elf) {
        (Place::Host, _) => scenario::run(job.scenario, &mut HostSubject::new(kind, options)),
        (Place::Firmware, None) => broken("no firmware"),
        (Place::Firmware, Some(elf)) => {
            let pictures = Pictures::of(kind, &workspace::root().join("target/out/scenarios"), bless);
            match BenchSubject::new(elf, kind, options, pictures) {
                Ok(mut subject) => scenario::run(job.scenario, &mut subject),
                Err(error) => broken(&format!("{error:#}")),
            }
        }
    }
}

fn report(scenarios: &[Scenario], jobs: &[Job<'_>], verdicts: &[Verdict], seconds: f64) -> Result<()> {
    let mut failed = 0;
    for scenario in scenarios {
        let own = || jobs.iter().zip(verdicts).filter(|(job, _)| std::ptr::eq(job.scenario, scenario));
        if own().next().is_none() {
            continue;
        }
        let failures: Vec<&String> = own().flat_map(|(_, verdict)| &verdict.failures).collect();
        let word = if failures.is_empty() { "ok" } else { "FAILED" };
        failed += usize::from(!failures.is_empty());
        let mut checks = String::new();
        for (job, verdict) in own() {
            let passed = verdict.checks.iter().filter(|check| check.passed).count();
            write!(checks, " {} {passed}/{}", job.place, verdict.checks.len())?;
        }
        say!("{word:7} {:32}{checks:32} {}", name(scenario), scenario.title)?;
        for failure in failures {
            say!("        {failure}")?;
        }
    }
    let virtual_s = |place| {
        let of_place = jobs.iter().filter(|job| job.place == place);
        of_place.map(|job| job.scenario.end_ms).sum::<u64>() / 1_000
    };
    say!(
        "{} runs of {} scenarios: {} s of virtual time on the host, {} s on the firmware, in {seconds:.0} s",
        jobs.len(),
        scenarios.len(),
        virtual_s(Place::Host),
        virtual_s(Place::Firmware)
    )?;
    if failed == 0 {
        return Ok(());
    }
    bail!("{failed} of {} scenarios failed; run one with `cargo xtask scenario NAME`", scenarios.len())
}
