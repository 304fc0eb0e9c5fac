//! A list of named steps: all are run, failures are summed up at the end.

use crate::out::say;
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
    /// A tool is missing; the reason says what to install. In CI that is a failure.
    Skipped(String),
    /// It did what its name says but for a part, for a reason: passed, and a skip.
    Partly(String),
    /// Something outside of this machine is missing, which no machine can be asked to have: a skip in CI too.
    Unreachable(String),
}

impl Steps {
    /// Runs one step; a failure is printed, remembered and does not stop the others.
    ///
    /// # Errors
    /// If nothing can be printed.
    pub fn run(&mut self, name: &str, step: impl FnOnce() -> Result<()>) -> Result<()> {
        self.try_run(name, || step().map(|()| Outcome::Done))
    }

    /// Runs one step that may be skipped for a reason.
    ///
    /// # Errors
    /// If nothing can be printed.
    pub fn try_run(&mut self, name: &str, step: impl FnOnce() -> Result<Outcome>) -> Result<()> {
        say!("\n=== {name}")?;
        let started = Instant::now();
        let outcome = step();
        say!("{}", self.count(name, outcome, started.elapsed().as_secs(), surroundings::is_ci()))?;
        Ok(())
    }

    /// Counts what became of a step and returns the line that says so.
    fn count(&mut self, name: &str, outcome: Result<Outcome>, seconds: u64, in_ci: bool) -> String {
        let failure = match outcome {
            Ok(Outcome::Done) => {
                self.passed += 1;
                return format!("--- {name}: ok ({seconds} s)");
            }
            Ok(Outcome::Partly(reason)) => {
                self.passed += 1;
                self.skip(format!("{name}: {reason}"));
                return format!("--- {name}: ok ({seconds} s), skipped: {reason}");
            }
            Ok(Outcome::Skipped(reason)) if in_ci => reason,
            Ok(Outcome::Skipped(reason) | Outcome::Unreachable(reason)) => {
                self.skip(format!("{name}: {reason}"));
                return format!("--- {name}: skipped: {reason}");
            }
            Err(error) => format!("{error:#}"),
        };
        self.failed.push(format!("{name}: {failure}"));
        format!("--- {name}: FAILED: {failure}")
    }

    /// Counts a part of a step that was skipped, as a test may be.
    pub fn skip(&mut self, line: String) {
        self.skipped.push(line);
    }

    /// Prints the sum.
    ///
    /// # Errors
    /// If any step failed.
    pub fn finish(self) -> Result<()> {
        say!("")?;
        for line in &self.skipped {
            say!("skipped  {line}")?;
        }
        for line in &self.failed {
            say!("FAILED   {line}")?;
        }
        say!("{}", self.sum())?;
        if self.failed.is_empty() {
            return Ok(());
        }
        bail!("{} of {} steps failed", self.failed.len(), self.passed + self.failed.len())
    }

    fn sum(&self) -> String {
        format!("{} passed, {} failed, {} skipped", self.passed, self.failed.len(), self.skipped.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::anyhow;

    /// Returns the sum of one step of each kind and of a skipped test.
    fn sum(in_ci: bool) -> String {
        let mut steps = Steps::default();
        let outcomes = [
            Ok(Outcome::Done),
            Ok(Outcome::Skipped("no tool".into())),
            Ok(Outcome::Unreachable("no network".into())),
            Ok(Outcome::Partly("no compiler".into())),
            Err(anyhow!("wrong")),
        ];
        for outcome in outcomes {
            steps.count("step", outcome, 0, in_ci);
        }
        steps.skip("a test: no interface".into());
        steps.sum()
    }

    #[test]
    fn skipped_steps_and_tests_are_counted() {
        assert_eq!(sum(false), "2 passed, 1 failed, 4 skipped");
    }

    #[test]
    fn in_ci_a_missing_tool_is_a_failure_and_an_unreachable_network_is_not() {
        assert_eq!(sum(true), "2 passed, 2 failed, 3 skipped");
    }
}
