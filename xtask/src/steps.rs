//! A list of named steps: all are run, failures are summed up at the end.

use anyhow::{Result, bail};
use std::time::Instant;

/// Steps that have been run so far.
#[derive(Default)]
pub struct Steps {
    passed: usize,
    skipped: Vec<String>,
    failed: Vec<String>,
}

/// What became of a step that did not fail.
pub enum Outcome {
    /// It did what its name says.
    Done,
    /// It could not run here; the reason says what to install.
    Skipped(String),
}

impl Steps {
    /// Runs one step; a failure is printed, remembered and does not stop the others.
    pub fn run(&mut self, name: &str, step: impl FnOnce() -> Result<()>) {
        self.try_run(name, || step().map(|()| Outcome::Done));
    }

    /// Runs one step that may be skipped for a reason; in CI a skip is a failure.
    pub fn try_run(&mut self, name: &str, step: impl FnOnce() -> Result<Outcome>) {
        println!("\n=== {name}");
        let started = Instant::now();
        match step() {
            Ok(Outcome::Done) => {
                self.passed += 1;
                println!("--- {name}: ok ({} s)", started.elapsed().as_secs());
            }
            Ok(Outcome::Skipped(reason)) if !crate::workspace::is_ci() => {
                println!("--- {name}: skipped: {reason}");
                self.skipped.push(format!("{name}: {reason}"));
            }
            Ok(Outcome::Skipped(reason)) => {
                println!("--- {name}: FAILED: {reason}");
                self.failed.push(format!("{name}: {reason}"));
            }
            Err(error) => {
                println!("--- {name}: FAILED: {error:#}");
                self.failed.push(format!("{name}: {error:#}"));
            }
        }
    }

    /// Prints the sum.
    ///
    /// # Errors
    /// If any step failed.
    pub fn finish(self) -> Result<()> {
        println!();
        for line in &self.skipped {
            println!("skipped  {line}");
        }
        for line in &self.failed {
            println!("FAILED   {line}");
        }
        println!("{} passed, {} failed, {} skipped", self.passed, self.failed.len(), self.skipped.len());
        if self.failed.is_empty() {
            return Ok(());
        }
        bail!("{} of {} steps failed", self.failed.len(), self.passed + self.failed.len())
    }
}
