//! Owns the bench: obeys the pages, keeps the pace, tells what happened.
//!
//! Everything that touches the [`Rig`] happens here, one command after the other, in [`Session::take`] and
//! [`Session::turn`]; who calls them, on a thread of a PC or in a browser's Worker, brings the wall clock, the judge of
//! scenarios and what becomes of each [`Update`]. It blocks nowhere and opens nothing. A bench that has stopped (the firmware did what is not modelled) stays to be
//! looked at until it is started again. Memory is bounded over any length of run.

use crate::catalog::{self, Catalog};
use crate::live::{self, State, Told};
use crate::pace::{Pace, SLICE};
use crate::recording::{Length, Recorder, Recording};
use crate::scenes::{Judge, Library, Playing};
use crate::trace::Trace;
use crate::wires::Wires;
use anyhow::Result;
use bench::chips::picture::Picture;
use bench::rig::Rig;
use bench::time::Nanos;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::time::Duration;
use virtual_vehicle::{Kind, Setting};

/// Pictures are told at most this often.
const PICTURE_EVERY: Duration = Duration::from_millis(33);
/// States are told this often.
const STATE_EVERY: Duration = Duration::from_millis(100);
/// Most slices that one step lets pass.
const STEP_MAX: u32 = 1_000;

/// What a page may ask for.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub enum Command {
    /// Holds or lets go of a button of the cluster.
    Button {
        /// 0 or 1.
        index: usize,
        /// Held down.
        down: bool,
    },
    /// Changes one thing in the vehicle or on the wires.
    Set {
        /// Public name of the control.
        path: String,
        /// The setting; null = left to the vehicle.
        value: Setting,
    },
    /// Sets several things at once.
    Preset {
        /// Name of the preset.
        name: String,
    },
    /// Stops or continues virtual time.
    Pause {
        /// Virtual time stands still.
        on: bool,
    },
    /// Stops, after so many slices.
    Step {
        /// Slices of 10 ms.
        slices: u32,
    },
    /// Sets how fast virtual time runs; 1 = real time, 0 = as fast as the machine can.
    Speed {
        /// Virtual seconds per second.
        factor: f64,
    },
    /// Starts the bench again, with another vehicle or with the recording.
    Start {
        /// Folder of the vehicle; null = the recording.
        vehicle: Option<String>,
    },
    /// Starts the bench again and plays a scenario of its vehicle.
    Play {
        /// Folder and name, as `cargo xtask scenario` takes it.
        name: String,
    },
    /// Starts or ends a recording.
    Record {
        /// It runs.
        on: bool,
    },
    /// Tells everything once more, for a page that has just come.
    Look,
}

/// What a page is told.
#[derive(Clone, Debug)]
pub enum Update {
    /// What there is to see and to change, as JSON: for every page, and first of all for one that has just come.
    Catalog(Arc<str>),
    /// State or notice, as JSON.
    Text(Arc<str>),
    /// The panel has changed.
    Picture(Arc<Picture>),
    /// A recording has ended and may be fetched; `None` = a new one runs.
    Recorded(Option<Recording>),
}

/// A line for the person at the page.
#[derive(Serialize)]
struct Notice<'a> {
    kind: &'static str,
    text: &'a str,
}

/// Wall time since any fixed moment.
pub type Clock = Box<dyn Fn() -> Duration + Send>;

/// Takes what the pages are told.
pub type Tell = Box<dyn FnMut(Update) + Send>;

/// Builds a bench around a vehicle; `None` = around the recording.
pub type Make = Box<dyn FnMut(Option<Kind>) -> Result<Rig> + Send>;

/// The bench and all that is known of it.
pub struct Session {
    make: Make,
    vehicle: Option<Kind>,
    recording_name: Option<String>,
    notes: Vec<String>,
    library: Library,
    judge: Option<Box<dyn Judge>>,
    rig: Rig,
    /// Counts benches.
    bench: u64,
    clock: Clock,
    pace: Pace,
    wires: Wires,
    trace: Trace,
    heard: usize,
    told: Told,
    /// A page has just come and wants every row.
    whole: bool,
    /// What the panel last looked like when it was told: when its glass last changed, and whether it was lit.
    pictured: Option<(Option<Nanos>, bool)>,
    recorder: Option<Recorder>,
    /// Counts recordings that have ended, and how long the last one is while it may be fetched.
    recorded: (u64, Option<Length>),
    playing: Option<Playing>,
    stopped: Option<String>,
    /// Wall time of the last picture and the last state that were told.
    told_at: (Duration, Duration),
    tell: Tell,
}

/// What a session begins with.
pub struct Beginning {
    /// Builds benches.
    pub make: Make,
    /// The vehicle of the first one; `None` = the recording.
    pub vehicle: Option<Kind>,
    /// Name of the recording that can be played in place of a vehicle.
    pub recording: Option<String>,
    /// What else is on the bus, as lines for a person.
    pub notes: Vec<String>,
    /// The scenarios that can be played.
    pub library: Library,
    /// Judges them; without one they play unjudged.
    pub judge: Option<Box<dyn Judge>>,
    /// The wall clock.
    pub clock: Clock,
    /// Takes what the pages are told.
    pub tell: Tell,
}

impl Session {
    /// Builds the first bench.
    ///
    /// # Errors
    /// If it cannot be built.
    pub fn new(beginning: Beginning) -> Result<Self> {
        let Beginning { mut make, vehicle, recording, notes, library, judge, clock, tell } = beginning;
        let rig = build_at_ease(&mut make, vehicle)?;
        let mut session = Self {
            pace: Pace::new(rig.now(), clock()),
            make,
            vehicle,
            recording_name: recording,
            notes,
            library,
            judge,
            rig,
            bench: 1,
            clock,
            wires: Wires::default(),
            trace: Trace::default(),
            heard: 0,
            told: Told::default(),
            whole: true,
            pictured: None,
            recorder: None,
            recorded: (0, None),
            playing: None,
            stopped: None,
            told_at: (Duration::ZERO, Duration::ZERO),
            tell,
        };
        session.tell_catalog();
        session.tell_picture();
        Ok(session)
    }

    /// Lets one slice of virtual time pass if one is due, and tells what is to be told; returns how long there is
    /// nothing to do but to wait for commands, zero if the next slice is due.
    pub fn turn(&mut self) -> Duration {
        let nap = if self.stopped.is_none() && self.pace.is_due(self.rig.now(), (self.clock)()) {
            self.pass();
            Duration::ZERO
        } else {
            self.pace.nap(self.rig.now(), (self.clock)())
        };
        let wall = (self.clock)();
        if wall.saturating_sub(self.told_at.0) >= PICTURE_EVERY {
            self.told_at.0 = wall;
            self.tell_picture();
        }
        if wall.saturating_sub(self.told_at.1) >= STATE_EVERY {
            self.told_at.1 = wall;
            self.tell_state();
        }
        nap
    }

    /// Starts the bench again with another recording, which is called so from now on.
    pub fn play_recording(&mut self, name: &str) {
        self.recording_name = Some(name.to_owned());
        self.take(Command::Start { vehicle: None });
    }

    /// The bench as it is.
    pub fn rig(&self) -> &Rig {
        &self.rig
    }

    /// Lets one slice of virtual time pass and looks at what happened in it.
    fn pass(&mut self) {
        if let Some(playing) = &mut self.playing
            && let Err(problem) = playing.act(&mut self.rig, &mut self.wires)
        {
            self.playing = None;
            self.notice(&problem);
        }
        let started = (self.clock)();
        // To the next whole slice: the engine stops a little late, and that must not add up.
        let now = self.rig.now();
        let run = self.rig.run_for(Nanos((now.0 / SLICE.0 + 1) * SLICE.0).since(now));
        self.pace.passed((self.clock)().saturating_sub(started));
        self.stopped = run.err().map(|stop| stop.to_string());
        let (heard, next) = self.rig.heard_since(self.heard);
        self.heard = next;
        for heard in &heard {
            self.trace.hear(heard);
            if let Some(recorder) = &mut self.recorder {
                recorder.hear(heard);
            }
        }
        if let Err(error) = self.record() {
            self.recorder = None;
            self.notice(&format!("{error:#}"));
        }
    }

    /// Shows the running recording what the panel shows, and ends one that is full.
    fn record(&mut self) -> Result<()> {
        let Some(recorder) = &mut self.recorder else { return Ok(()) };
        let now = self.rig.now();
        if recorder.wants_picture(now) {
            recorder.see(now, &picture(&self.rig))?;
        }
        if recorder.is_full() {
            self.end_recording()?;
        }
        Ok(())
    }

    fn end_recording(&mut self) -> Result<()> {
        if let Some(recorder) = self.recorder.take() {
            let recording = recorder.finish()?;
            self.recorded = (self.recorded.0 + 1, Some(recording.length));
            (self.tell)(Update::Recorded(Some(recording)));
        }
        Ok(())
    }

    /// Obeys a page; what cannot be done is told to all of them.
    pub fn take(&mut self, command: Command) {
        if let Err(problem) = self.obey(command) {
            self.notice(&problem);
        }
    }

    fn obey(&mut self, command: Command) -> Result<(), String> {
        let (now, wall) = (self.rig.now(), (self.clock)());
        match command {
            Command::Button { index, down } => self.rig.hold_button(index, down),
            Command::Pause { on } => self.pace.pause(on, now, wall),
            Command::Step { slices } => self.pace.step(slices.min(STEP_MAX)),
            Command::Speed { factor } => self.pace.set_factor(factor, now, wall),
            Command::Look => self.whole = true,
            Command::Set { path, value } => return self.set(&path, value),
            Command::Preset { name } => {
                let vehicle = self.rig.vehicle_mut().ok_or("a recording takes no settings")?;
                return catalog::preset(vehicle, &name);
            }
            Command::Start { vehicle } => {
                let kind = vehicle
                    .as_deref()
                    .map(|name| Kind::from_name(name).ok_or_else(|| format!("there is no vehicle `{name}`")));
                let kind = kind.transpose()?;
                if kind.is_none() && self.recording_name.is_none() {
                    return Err(
                        "there is no recording to play: `cargo xtask run --log FILE` brings one".into()
                    );
                }
                let rig = build_at_ease(&mut self.make, kind).map_err(|error| format!("{error:#}"))?;
                return self.begin(rig, kind, None);
            }
            Command::Play { name } => {
                let kind = self.vehicle.ok_or("a recording plays; choose a vehicle first")?;
                let scenario = self.library.find(kind, &name).map_err(|error| format!("{error:#}"))?;
                let mut rig = (self.make)(Some(kind)).map_err(|error| format!("{error:#}"))?;
                let playing = Playing::start(scenario, &mut rig, self.judge.as_deref_mut());
                return self.begin(rig, Some(kind), Some(playing));
            }
            Command::Record { on: true } => {
                let recorder = Recorder::new(now, &picture(&self.rig));
                self.recorder = Some(recorder.map_err(|error| format!("{error:#}"))?);
                self.recorded.1 = None;
                (self.tell)(Update::Recorded(None));
            }
            Command::Record { on: false } => {
                return self.end_recording().map_err(|error| format!("{error:#}"));
            }
        }
        Ok(())
    }

    fn set(&mut self, path: &str, value: Setting) -> Result<(), String> {
        if self.wires.set(&mut self.rig, path, value == Some(1.0)) {
            return Ok(());
        }
        let vehicle = self.rig.vehicle_mut().ok_or("a recording takes no settings")?;
        vehicle.set(path, value).map_err(|error| error.to_string())
    }

    /// Goes on with another bench, from power-on.
    fn begin(&mut self, rig: Rig, vehicle: Option<Kind>, playing: Option<Playing>) -> Result<(), String> {
        self.end_recording().map_err(|error| format!("{error:#}"))?;
        (self.rig, self.vehicle) = (rig, vehicle);
        self.bench += 1;
        self.pace.restart(self.rig.now(), (self.clock)());
        (self.wires, self.trace, self.told) = (Wires::default(), Trace::default(), Told::default());
        (self.heard, self.whole) = (0, true);
        (self.pictured, self.playing, self.stopped) = (None, playing, None);
        self.tell_catalog();
        self.tell_picture();
        Ok(())
    }

    fn tell_catalog(&mut self) {
        let around = catalog::Around {
            bench: self.bench,
            recording: self.recording_name.as_deref(),
            notes: &self.notes,
            bitrate: self.rig.board().bus().bitrate(),
        };
        let text = json(&Catalog::of(self.rig.vehicle(), &self.library, &around));
        (self.tell)(Update::Catalog(text));
    }

    /// Tells the picture if it has changed.
    fn tell_picture(&mut self) {
        let panel = self.rig.board().panel();
        let look = (panel.last_change(), panel.visible(self.rig.now()).is_some());
        if self.pictured == Some(look) {
            return;
        }
        self.pictured = Some(look);
        (self.tell)(Update::Picture(Arc::new(picture(&self.rig))));
    }

    fn tell_state(&mut self) {
        let now = self.rig.now();
        let around = live::Around {
            bench: self.bench,
            wall: (self.clock)(),
            wires: &self.wires,
            recording: self.recorder.as_ref().map(Recorder::length),
            recorded: self.recorded.1.map(|length| (self.recorded.0, length)),
            playing: self.playing.as_mut().map(|playing| playing.story(now)),
            stopped: self.stopped.as_deref(),
            bus: self.trace.take(std::mem::take(&mut self.whole)),
        };
        let text = json(&State::of(&self.rig, &mut self.pace, &mut self.told, around));
        (self.tell)(Update::Text(text));
    }

    fn notice(&mut self, text: &str) {
        (self.tell)(Update::Text(json(&Notice { kind: "notice", text })));
    }
}

/// Builds a bench whose vehicle is READY: driver's seat taken, key turned to start.
fn build_at_ease(make: &mut Make, vehicle: Option<Kind>) -> Result<Rig> {
    let mut rig = make(vehicle)?;
    if let Some(vehicle) = rig.vehicle_mut() {
        catalog::begin(vehicle);
    }
    Ok(rig)
}

/// What a person sees: black while the panel is dark.
fn picture(rig: &Rig) -> Picture {
    let panel = rig.board().panel();
    panel.visible(rig.now()).unwrap_or_else(|| {
        let glass = panel.glass();
        Picture { rgb: vec![0; glass.rgb.len()], ..glass }
    })
}

fn json(value: &impl Serialize) -> Arc<str> {
    serde_json::to_string(value).unwrap_or_default().into()
}
