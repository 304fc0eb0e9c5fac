//! One session of the page and what it wants to tell.

use crate::dropped::{self, Dropped, read_file};
use crate::embedded;
use crate::judge::Court;
use anyhow::{Context, Result};
use bench::chips::picture::Picture;
use bench::log::Log;
use bench::rig::{Rig, RigOptions};
use bench_page::{Beginning, Clock, Command, Recording, Session, Update, decode_to_json, png};
use protocol_core::generated::VEHICLES;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use vehicle_compiler::RunTime;
use virtual_vehicle::{Kind, Options, VirtualVehicle};

/// Something that leaves the module.
pub enum Out {
    /// JSON for the page.
    Text(Arc<str>),
    /// What the panel shows.
    Picture(Arc<Picture>),
    /// A scenario that a second Worker is to judge: its number and its name.
    Judge(u64, String),
}

/// What the session has told and nobody has fetched.
#[derive(Default)]
struct Told {
    texts: VecDeque<Arc<str>>,
    /// A picture that was not fetched is replaced by the next one.
    picture: Option<Arc<Picture>>,
    shown: Option<Arc<Picture>>,
    recorded: Option<Recording>,
}

/// States that wait for a page that is slow: older ones go.
const TEXTS_KEPT: usize = 64;

type Shared<T> = Arc<Mutex<T>>;

fn locked<T>(shared: &Shared<T>) -> MutexGuard<'_, T> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What a bench is built from; a dropped file changes it.
struct Parts {
    flash: Vec<u8>,
    log: Option<Log>,
}

/// A session of the page, and the box for what it tells.
pub struct Desk {
    session: Session,
    told: Shared<Told>,
    parts: Shared<Parts>,
    court: Court,
    /// The DBC file that was dropped last.
    dbc: Option<RunTime>,
}

impl Desk {
    /// Puts a bench with this image of the flash on the desk; `log` is the name and the text of a recording that can be
    /// played.
    ///
    /// # Errors
    /// If the recording cannot be read.
    pub fn new(flash: Vec<u8>, log: Option<(&str, &[u8])>, clock: Clock) -> Result<Self> {
        let told = Shared::<Told>::default();
        let recording = log.map(|(name, _)| name.to_owned());
        let log = log.map(|(name, bytes)| read_log(name, bytes)).transpose()?;
        let parts = Arc::new(Mutex::new(Parts { flash, log }));
        let court = Court::default();
        let (making, telling) = (Arc::clone(&parts), Arc::clone(&told));
        let session = Session::new(Beginning {
            make: Box::new(move |kind| Ok(build(&locked(&making), kind))),
            vehicle: Some(Kind::Citybus),
            recording,
            notes: Vec::new(),
            library: embedded::library(),
            judge: Some(Box::new(court.clone())),
            clock,
            tell: Box::new(move |update| tell(&mut locked(&telling), update)),
        })?;
        Ok(Self { session, told, parts, court, dbc: None })
    }

    /// Obeys a page; what is no command is ignored, as the server does.
    pub fn command(&mut self, json: &str) {
        if let Ok(command) = serde_json::from_str(json) {
            self.session.take(command);
        }
    }

    /// Lets a slice of time pass if one is due; returns how long there is nothing to do.
    pub fn turn(&mut self) -> Duration {
        self.session.turn()
    }

    /// Takes what is to be told next.
    pub fn next_out(&mut self) -> Option<Out> {
        if let Some((number, name)) = self.court.take() {
            return Some(Out::Judge(number, name));
        }
        let mut told = locked(&self.told);
        let text = told.texts.pop_front().map(Out::Text);
        text.or_else(|| told.picture.take().map(Out::Picture))
    }

    /// Takes the answer of the Worker that judges.
    pub fn judged(&mut self, number: u64, answer: &str) {
        self.court.answer(number, answer);
    }

    /// Answers what the page asks for by a name, as the server answers its paths: `screen/2`, `recording.gif`,
    /// `recording.log`, `decode/18FF21F0/00`.
    ///
    /// # Errors
    /// If there is no such thing, in words for a person.
    pub fn ask(&self, path: &str) -> Result<Vec<u8>, String> {
        let told = locked(&self.told);
        let recorded = || told.recorded.clone().ok_or_else(|| "nothing has been recorded yet".to_owned());
        let mut parts = path.split('/');
        match (parts.next(), parts.next(), parts.next()) {
            (Some("screen"), Some(scale), None) => {
                let scale = scale.parse().map_err(|_| format!("`{scale}` is no scale"))?;
                let shown = told.shown.as_ref().ok_or("the panel has shown nothing yet")?;
                png(shown, scale).map_err(|error| format!("{error:#}"))
            }
            (Some("recording.gif"), None, None) => Ok(recorded()?.gif.to_vec()),
            (Some("recording.log"), None, None) => Ok(recorded()?.log.to_vec()),
            (Some("decode"), Some(id), Some(data)) => decode_to_json(id, data).map(String::into_bytes),
            _ => Err(format!("there is no `{path}`")),
        }
    }

    /// Takes a file that was dropped on the page: says what it is, and goes on with it if it is an image of the firmware or
    /// a recording. Returns what the page is told, as JSON.
    pub fn drop_file(&mut self, name: &str, bytes: &[u8]) -> String {
        let mut file = read_file(name, bytes);
        match &mut file {
            Dropped::Image { flash, .. } => {
                locked(&self.parts).flash = std::mem::take(flash);
                self.session.take(Command::Start { vehicle: Some(Kind::Citybus.name().into()) });
            }
            Dropped::Recording { decoded, more, .. } => {
                if let Ok(log) = read_log(name, bytes) {
                    if let Some(dbc) = &self.dbc {
                        (*decoded, *more) = dropped::decode(dbc, &log);
                    }
                    locked(&self.parts).log = Some(log);
                    self.session.play_recording(name);
                }
            }
            Dropped::Dbc { decoded, .. } => {
                self.dbc = dropped::run_time(name, bytes);
                if let (Some(dbc), Some(log)) = (&self.dbc, &locked(&self.parts).log) {
                    *decoded = dropped::decode(dbc, log).0;
                }
            }
            Dropped::Other { .. } => {}
        }
        serde_json::to_string(&file).unwrap_or_default()
    }

    /// Image of the flash, for a Worker that judges.
    pub fn flash(&self) -> Vec<u8> {
        locked(&self.parts).flash.clone()
    }
}

/// Reads a recording of any form.
pub(crate) fn read_log(name: &str, bytes: &[u8]) -> Result<Log> {
    let recording = bench::log::Reading::default().bytes(name, bytes)?;
    recording.log().context("the recording cannot be played")
}

fn build(parts: &Parts, kind: Option<Kind>) -> Rig {
    let of_log = || {
        let frames: Vec<_> = parts
            .log
            .iter()
            .flat_map(|log| &log.entries)
            .filter_map(|entry| entry.frame.data_frame())
            .collect();
        VEHICLES
            .iter()
            .copied()
            .max_by_key(|vehicle| frames.iter().filter(|it| vehicle.has_id(it.id)).count())
    };
    let vehicle = match kind {
        Some(kind) => VEHICLES.iter().copied().find(|vehicle| vehicle.name == kind.name()),
        None => of_log(),
    };
    let usual = RigOptions::default();
    let bitrate = vehicle.map_or(usual.bitrate, |vehicle| vehicle.bitrate);
    let mut rig = Rig::with_flash(parts.flash.clone(), &RigOptions { bitrate, ..usual });
    match (kind, &parts.log) {
        (Some(kind), _) => rig.drive(VirtualVehicle::new(kind, Options::default())),
        (None, Some(log)) => rig.replay(log, true),
        (None, None) => {}
    }
    rig
}

fn tell(told: &mut Told, update: Update) {
    match update {
        Update::Catalog(text) | Update::Text(text) => {
            if told.texts.len() == TEXTS_KEPT {
                told.texts.pop_front();
            }
            told.texts.push_back(text);
        }
        Update::Picture(picture) => {
            told.shown = Some(Arc::clone(&picture));
            told.picture = Some(picture);
        }
        Update::Recorded(recording) => told.recorded = recording,
    }
}
