//! Scenarios as data: what is done to a vehicle, and what its cluster must then show, sound and send.
//!
//! One file, one story; one row, one step (bench/scenarios/README.md). The same rows run against the cluster's logic
//! on the host ([`HostSubject`]) and against the real firmware on the bench ([`BenchSubject`]), and both must come to the
//! same verdict. Virtual time only. Refuses to know why something is shown: it sees what a driver and the bus see.

mod answer;
mod bench_subject;
mod format;
mod host_subject;
mod line;
mod name;
mod runner;
mod sound;
mod subject;

pub use answer::{Answer, Wanted};
pub use bench_subject::{BenchSubject, Pictures};
pub use format::{parse, read_file};
pub use host_subject::HostSubject;
pub use name::Name;
pub use runner::{Check, Verdict, run, trace};
pub use subject::Subject;

use crate::can::Frame;
use anyhow::{Context, Result, bail};
use cluster::Button;
use protocol_core::Vehicle;
use protocol_core::generated::VEHICLES;
use std::fmt;
use std::path::PathBuf;
use virtual_vehicle::{Kind, Options, Setting};

/// Where a scenario runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// The cluster's logic, ticked on the host; there is no bus.
    Host,
    /// The real firmware on the bench.
    Firmware,
}

impl Place {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Host, Self::Firmware];

    /// Returns the word that stands in scenario files.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Host => "host",
            Self::Firmware => "firmware",
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// A fault of the bus or of the supply that a bench can make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BusFault {
    /// Stuck dominant: nobody hears anybody.
    Short,
    /// A node sends the most urgent identifier without a pause: nobody else is heard.
    Babble,
    /// Frames reach the cluster with a wrong CRC.
    Garble,
    /// The cluster's connector is pulled.
    Unplug,
    /// The cluster's supply is cut; it starts anew, with what its flash holds, when that ends.
    PowerCut,
}

impl BusFault {
    const ALL: [(&'static str, Self); 5] = [
        ("bus.short", Self::Short),
        ("bus.babble", Self::Babble),
        ("bus.garble", Self::Garble),
        ("bus.unplug", Self::Unplug),
        ("power.cut", Self::PowerCut),
    ];
}

/// One thing that is done.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// A control of the virtual vehicle is set.
    Set {
        /// Path of the control, such as `driver.key`.
        path: String,
        /// What it is set to.
        setting: Setting,
    },
    /// A button of the cluster is held down or let go.
    Hold(Button, bool),
    /// A bus fault begins or ends.
    Fault(BusFault, bool),
    /// A frame is put on the bus by hand.
    Send(Frame),
}

/// An action and its time.
#[derive(Clone, Debug, PartialEq)]
pub struct Act {
    /// Time from the start, in milliseconds.
    pub at_ms: u64,
    /// Line in the file.
    pub line: usize,
    /// What is done.
    pub action: Action,
}

/// One thing that is expected.
#[derive(Clone, Debug, PartialEq)]
pub struct Demand {
    /// Line in the file.
    pub line: usize,
    /// What is looked at.
    pub name: Name,
    /// What it must be, or must not be.
    pub wanted: Wanted,
    /// It must never be so.
    pub never: bool,
    /// Time of the step, in milliseconds.
    pub at_ms: u64,
    /// Time by which it has settled.
    pub settled_ms: u64,
    /// It must be so up to this time; `None` = once until it has settled is enough.
    pub until_ms: Option<u64>,
}

/// A story of a vehicle.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// Folder and file, as in messages: `citybus/reverse.toml`.
    pub file: String,
    /// Which vehicle.
    pub kind: Kind,
    /// What it shows, in one sentence.
    pub title: String,
    /// Rules of the documents that it shows.
    pub rules: Vec<String>,
    /// Where it runs.
    pub on: Vec<Place>,
    /// How the vehicle is built.
    pub options: Options,
    /// What is done, in the order of time.
    pub acts: Vec<Act>,
    /// What is expected.
    pub demands: Vec<Demand>,
    /// Its length in milliseconds.
    pub end_ms: u64,
}

impl Scenario {
    /// Returns its name: the file without folder and ending.
    pub fn name(&self) -> &str {
        let file = self.file.rsplit('/').next().unwrap_or(&self.file);
        file.strip_suffix(".toml").unwrap_or(file)
    }
}

/// Returns what the cluster knows of the vehicle.
fn vehicle(kind: Kind) -> Option<&'static Vehicle> {
    VEHICLES.iter().copied().find(|vehicle| vehicle.name == kind.name())
}

/// Returns the folder of all scenarios: one folder per vehicle.
pub fn folder() -> PathBuf {
    surroundings::root().join("bench/scenarios")
}

/// Returns the scenario files of a vehicle, sorted by name; none if it has no folder.
///
/// # Errors
/// If the folder cannot be read.
pub fn files(kind: Kind) -> Result<Vec<PathBuf>> {
    let folder = folder().join(kind.name());
    if !folder.exists() {
        return Ok(Vec::new());
    }
    let entries =
        std::fs::read_dir(&folder).with_context(|| format!("{}: cannot be read", folder.display()))?;
    let paths: Result<Vec<PathBuf>, _> = entries.map(|entry| entry.map(|entry| entry.path())).collect();
    let mut files = paths?;
    files.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    files.sort();
    Ok(files)
}

/// Reads every scenario of a vehicle.
///
/// # Errors
/// If any is wrong; the error names file and line of everything that is.
pub fn load(kind: Kind) -> Result<Vec<Scenario>> {
    let mut wrong = Vec::new();
    let mut scenarios = Vec::new();
    for file in files(kind)? {
        match read_file(&file) {
            Ok(scenario) => scenarios.push(scenario),
            Err(error) => wrong.push(format!("{error:#}")),
        }
    }
    if !wrong.is_empty() {
        bail!("{}", wrong.join("\n"));
    }
    Ok(scenarios)
}
