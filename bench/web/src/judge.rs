//! Scenarios that are judged in a Worker of their own, and the page's side of it.

use crate::embedded;
use anyhow::{Context, Result, anyhow};
use bench::scenario::{self, BenchSubject, Scenario, Verdict};
use bench_page::{Judge, Trial};
use serde::{Deserialize, Serialize};
use std::sync::{Arc, Mutex, PoisonError};
use virtual_vehicle::Kind;

/// What a judging Worker answers.
#[derive(Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Judged {
    /// The scenario came to its end.
    Verdict(Verdict),
    /// It did not.
    Problem(String),
}

/// Judges the scenario `citybus/fire` with this image of the flash; returns JSON.
pub fn judge_scenario(flash: &[u8], name: &str) -> String {
    let judged = match verdict(flash, name) {
        Ok(verdict) => Judged::Verdict(verdict),
        Err(error) => Judged::Problem(format!("{error:#}")),
    };
    serde_json::to_string(&judged).unwrap_or_default()
}

fn verdict(flash: &[u8], name: &str) -> Result<Verdict> {
    let (vehicle, file) = name.split_once('/').context("a scenario is named as citybus/fire")?;
    let kind = Kind::from_name(vehicle).ok_or_else(|| anyhow!("there is no vehicle `{vehicle}`"))?;
    let scenario = embedded::library().find(kind, file)?;
    let pictures = embedded::pictures(kind);
    let mut subject = BenchSubject::with_flash(flash.to_vec(), kind, scenario.options, pictures);
    Ok(scenario::run(&scenario, &mut subject))
}

/// Where the page's session and the judging Worker meet.
#[derive(Clone, Default)]
pub(crate) struct Court(Arc<Mutex<Docket>>);

#[derive(Default)]
struct Docket {
    /// Counts scenarios; an answer to an older one is dropped.
    number: u64,
    /// The scenario that a Worker is to judge next.
    wanted: Option<String>,
    answer: Option<Judged>,
}

impl Court {
    fn with<T>(&self, what: impl FnOnce(&mut Docket) -> T) -> T {
        what(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Takes the scenario that is to be judged, with its number.
    pub(crate) fn take(&self) -> Option<(u64, String)> {
        self.with(|docket| Some((docket.number, docket.wanted.take()?)))
    }

    /// Takes the answer of a Worker.
    pub(crate) fn answer(&self, number: u64, text: &str) {
        let judged = serde_json::from_str(text).unwrap_or_else(|error| Judged::Problem(error.to_string()));
        self.with(|docket| {
            if docket.number == number {
                docket.answer = Some(judged);
            }
        });
    }
}

impl Judge for Court {
    fn judge(&mut self, scenario: Scenario) -> Box<dyn Trial> {
        let number = self.with(|docket| {
            docket.number += 1;
            docket.wanted = Some(format!("{}/{}", scenario.kind.name(), scenario.name()));
            docket.answer = None;
            docket.number
        });
        Box::new(Pending { court: self.clone(), number })
    }
}

struct Pending {
    court: Court,
    number: u64,
}

impl Trial for Pending {
    fn verdict(&mut self) -> Option<Result<Verdict, String>> {
        self.court.with(|docket| {
            if docket.number != self.number {
                return Some(Err("not judged: another scenario is".into()));
            }
            Some(match docket.answer.take()? {
                Judged::Verdict(verdict) => Ok(verdict),
                Judged::Problem(problem) => Err(problem),
            })
        })
    }
}
