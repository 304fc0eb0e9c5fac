//! The thread that owns the bench: obeys the pages, keeps the pace, tells what happened.
//!
//! Everything that touches the [`Rig`] happens here, one command after the other, and nothing else: files are made by the
//! server, of what is told in [`Latest`]. A bench that has stopped (the firmware did what is not modelled) stays to be
//! looked at until it is started again. Memory is bounded over any length of run.

use super::catalog::{self, Catalog};
use super::live::{self, State, Told};
use super::pace::{Pace, SLICE};
use super::recording::{self, Length, Recorder, Recording};
use super::scenes::{self, Judge, Playing};
use super::trace::Trace;
use super::wires::Wires;
use crate::chips::picture::Picture;
use crate::rig::Rig;
use crate::time::Nanos;
use anyhow::Result;
use axum::body::Bytes;
use axum::extract::ws::Utf8Bytes;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError};
use std::time::{Duration, Instant};
use tokio::sync::{broadcast, watch};
use virtual_vehicle::{Kind, Setting};

/// Pictures are told at most this often.
const PICTURE_EVERY: Duration = Duration::from_millis(33);
/// States are told this often.
const STATE_EVERY: Duration = Duration::from_millis(100);
/// Commands that are obeyed between two slices.
const COMMANDS_PER_SLICE: usize = 64;
/// Most slices that one step lets pass.
const STEP_MAX: u32 = 1_000;

/// What a page may ask for.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Command {
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

/// What is told to every page.
#[derive(Clone, Debug)]
pub(super) enum Update {
    /// A picture as PNG.
    Picture(Bytes),
    /// Catalog, state or notice as JSON.
    Text(Utf8Bytes),
}

/// What a page must know that has just come, and what files are made of.
#[derive(Clone, Default)]
pub(super) struct Latest {
    pub(super) catalog: Utf8Bytes,
    /// What the panel shows, as PNG; empty = nothing was told yet.
    pub(super) picture: Bytes,
    /// The same as pixels.
    pub(super) shown: Option<Arc<Picture>>,
    /// The last recording that has ended.
    pub(super) recorded: Option<Recording>,
}

/// A line for the person at the page.
#[derive(Serialize)]
struct Notice<'a> {
    kind: &'static str,
    text: &'a str,
}

/// Builds a bench around a vehicle; `None` = around the recording.
pub(super) type Make = Box<dyn FnMut(Option<Kind>) -> Result<Rig> + Send>;

/// The bench and all that is known of it.
pub(super) struct Session {
    make: Make,
    vehicle: Option<Kind>,
    recording_name: Option<String>,
    notes: Vec<String>,
    judge: Option<Judge>,
    rig: Rig,
    /// Counts benches.
    bench: u64,
    clock: Instant,
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
    latest: watch::Sender<Latest>,
    updates: broadcast::Sender<Update>,
}

/// What a session begins with.
pub(super) struct Beginning {
    pub(super) make: Make,
    pub(super) vehicle: Option<Kind>,
    pub(super) recording: Option<String>,
    pub(super) notes: Vec<String>,
    pub(super) elf: Option<PathBuf>,
    pub(super) latest: watch::Sender<Latest>,
    pub(super) updates: broadcast::Sender<Update>,
}

impl Session {
    /// Builds the first bench.
    ///
    /// # Errors
    /// If it cannot be built, or no thread for judging scenarios can be started.
    pub(super) fn new(beginning: Beginning) -> Result<Self> {
        let Beginning { mut make, vehicle, recording, notes, elf, latest, updates } = beginning;
        let rig = build_at_ease(&mut make, vehicle)?;
        let clock = Instant::now();
        let mut session = Self {
            pace: Pace::new(rig.now(), clock.elapsed()),
            make,
            vehicle,
            recording_name: recording,
            notes,
            judge: elf.map(Judge::of_firmware).transpose()?,
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
            latest,
            updates,
        };
        session.tell_catalog();
        session.tell_picture();
        Ok(session)
    }

    /// Runs until nobody can ask any more.
    pub(super) fn run(mut self, commands: &Receiver<Command>) {
        let (mut pictured, mut told) = (Duration::ZERO, Duration::ZERO);
        loop {
            for _ in 0..COMMANDS_PER_SLICE {
                match commands.try_recv() {
                    Ok(command) => self.take(command),
                    Err(TryRecvError::Empty) => break,
                    Err(TryRecvError::Disconnected) => return,
                }
            }
            if self.stopped.is_none() && self.pace.is_due(self.rig.now(), self.clock.elapsed()) {
                self.pass();
            } else {
                let nap = self.pace.nap(self.rig.now(), self.clock.elapsed());
                match commands.recv_timeout(nap) {
                    Ok(command) => self.take(command),
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => return,
                }
            }
            let wall = self.clock.elapsed();
            if wall.saturating_sub(pictured) >= PICTURE_EVERY {
                pictured = wall;
                self.tell_picture();
            }
            if wall.saturating_sub(told) >= STATE_EVERY {
                told = wall;
                self.tell_state();
            }
        }
    }

    /// Lets one slice of virtual time pass and looks at what happened in it.
    fn pass(&mut self) {
        if let Some(playing) = &mut self.playing
            && let Err(problem) = playing.act(&mut self.rig, &mut self.wires)
        {
            self.playing = None;
            self.notice(&problem);
        }
        let started = Instant::now();
        // To the next whole slice: the engine stops a little late, and that must not add up.
        let now = self.rig.now();
        let run = self.rig.run_for(Nanos((now.0 / SLICE.0 + 1) * SLICE.0).since(now));
        self.pace.passed(started.elapsed());
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
            self.latest.send_modify(|latest| latest.recorded = Some(recording));
        }
        Ok(())
    }

    fn take(&mut self, command: Command) {
        if let Err(problem) = self.obey(command) {
            self.notice(&problem);
        }
    }

    fn obey(&mut self, command: Command) -> Result<(), String> {
        let (now, wall) = (self.rig.now(), self.clock.elapsed());
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
                let scenario = scenes::find(kind, &name).map_err(|error| format!("{error:#}"))?;
                let mut rig = (self.make)(Some(kind)).map_err(|error| format!("{error:#}"))?;
                let playing = Playing::start(scenario, &mut rig, self.judge.as_mut());
                return self.begin(rig, Some(kind), Some(playing));
            }
            Command::Record { on: true } => {
                let recorder = Recorder::new(now, &picture(&self.rig));
                self.recorder = Some(recorder.map_err(|error| format!("{error:#}"))?);
                self.recorded.1 = None;
                self.latest.send_modify(|latest| latest.recorded = None);
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
        self.pace.restart(self.rig.now(), self.clock.elapsed());
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
        let text = json(&Catalog::of(self.rig.vehicle(), &around));
        self.latest.send_modify(|latest| latest.catalog = text.clone());
        self.tell(Update::Text(text));
    }

    /// Tells the picture if it has changed.
    fn tell_picture(&mut self) {
        let panel = self.rig.board().panel();
        let look = (panel.last_change(), panel.visible(self.rig.now()).is_some());
        if self.pictured == Some(look) {
            return;
        }
        self.pictured = Some(look);
        let shown = picture(&self.rig);
        let Ok(png) = recording::png(&shown, 1) else { return };
        let png = Bytes::from(png);
        self.latest.send_modify(|latest| {
            (latest.picture, latest.shown) = (png.clone(), Some(Arc::new(shown)));
        });
        self.tell(Update::Picture(png));
    }

    fn tell_state(&mut self) {
        let now = self.rig.now();
        let around = live::Around {
            bench: self.bench,
            wall: self.clock.elapsed(),
            wires: &self.wires,
            recording: self.recorder.as_ref().map(Recorder::length),
            recorded: self.recorded.1.map(|length| (self.recorded.0, length)),
            playing: self.playing.as_mut().map(|playing| playing.story(now)),
            stopped: self.stopped.as_deref(),
            bus: self.trace.take(std::mem::take(&mut self.whole)),
        };
        let text = json(&State::of(&self.rig, &mut self.pace, &mut self.told, around));
        self.tell(Update::Text(text));
    }

    fn notice(&self, text: &str) {
        self.tell(Update::Text(json(&Notice { kind: "notice", text })));
    }

    fn tell(&self, update: Update) {
        // Without a page nobody listens.
        let _ = self.updates.send(update);
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

fn json(value: &impl Serialize) -> Utf8Bytes {
    serde_json::to_string(value).unwrap_or_default().into()
}
