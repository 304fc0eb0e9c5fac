//! The real firmware on the bench, with the virtual vehicle on its bus.
//!
//! What is shown comes from the PC link's records, what is sent from the bus, the sound from the buzzer's pin, pictures
//! from the panel's memory. Nothing is asked of the firmware that it does not tell a person or a computer anyway.

use super::host_subject::{Transmitted, gear, page};
use super::line::FoundLine;
use super::sound::{self, LONGEST_PAUSE_MS};
use super::{Action, Answer, BusFault, Name, Place, Subject};
use crate::chips::picture::Picture;
use crate::rig::{Rig, RigOptions};
use crate::rp2040::image;
use crate::time::Nanos;
use anyhow::{Context, Result};
use cluster::Button;
use protocol_core::link::Screen;
use protocol_core::model::{Gear, Severity};
use std::io::Cursor;
use std::path::{Path, PathBuf};
use virtual_vehicle::{Kind, Options, VirtualVehicle};

/// Where pictures are and what becomes of them.
#[derive(Clone, Debug)]
pub struct Pictures(Golden);

#[derive(Clone, Debug)]
enum Golden {
    Files {
        /// The golden ones.
        golden: PathBuf,
        /// Where one that differs is written to.
        actual: PathBuf,
        /// What is shown becomes the golden picture.
        bless: bool,
    },
    /// PNG files by name, where there are no folders.
    Known(Vec<(String, Vec<u8>)>),
}

impl Pictures {
    /// The golden pictures of a vehicle's scenarios. One that differs is written into the vehicle's folder in `actual`;
    /// with `bless`, what is shown becomes the golden one.
    pub fn of(kind: Kind, actual: &Path, bless: bool) -> Self {
        let golden = super::folder().join(kind.name()).join("pictures");
        Self(Golden::Files { golden, actual: actual.join(kind.name()), bless })
    }

    /// These PNG files, by name, are the golden pictures; one that differs is kept nowhere.
    pub fn known(files: Vec<(String, Vec<u8>)>) -> Self {
        Self(Golden::Known(files))
    }

    fn blesses(&self) -> bool {
        matches!(self.0, Golden::Files { bless: true, .. })
    }

    /// Returns the golden picture; with `bless` it is what is shown.
    fn golden(&self, file: &str, shown: &Picture) -> Option<Picture> {
        match &self.0 {
            Golden::Files { golden, bless: true, .. } => {
                write_picture(&golden.join(file), shown).ok().map(|()| shown.clone())
            }
            Golden::Files { golden, .. } => Picture::read_png(&golden.join(file)).ok(),
            Golden::Known(files) => {
                let (_, png) = files.iter().find(|(name, _)| name == file)?;
                Picture::from_png(Cursor::new(png)).ok()
            }
        }
    }

    /// Keeps a picture that differs, where there is a place, and says where.
    fn keep(&self, file: &str, shown: &Picture) -> String {
        let Golden::Files { actual, .. } = &self.0 else { return String::new() };
        let path = actual.join(file);
        let _ = write_picture(&path, shown);
        format!(", see {}", path.display())
    }
}

/// After this long without a pixel a picture is complete.
const QUIET: Nanos = Nanos::from_millis(5);

/// The firmware beside a virtual vehicle.
pub struct BenchSubject {
    rig: Rig,
    pictures: Pictures,
    sent: Transmitted,
    /// Number of the first frame on the bus that has not been looked at.
    heard: usize,
    /// Golden pictures read or written in this run, by file.
    golden: Vec<(String, Option<Picture>)>,
}

impl BenchSubject {
    /// Switches a vehicle and a cluster with the image in `elf` on.
    ///
    /// # Errors
    /// If the file is not an image for the board.
    pub fn new(elf: &Path, kind: Kind, options: Options, pictures: Pictures) -> Result<Self> {
        Ok(Self::with_flash(image::load_elf(elf)?, kind, options, pictures))
    }

    /// The same with this image of the flash.
    pub fn with_flash(flash: Vec<u8>, kind: Kind, options: Options, pictures: Pictures) -> Self {
        let usual = RigOptions::default();
        let bitrate = super::vehicle(kind).map_or(usual.bitrate, |vehicle| vehicle.bitrate);
        let mut rig = Rig::with_flash(flash, &RigOptions { bitrate, ..usual });
        rig.drive(VirtualVehicle::new(kind, options));
        Self { rig, pictures, sent: Transmitted::default(), heard: 0, golden: Vec::new() }
    }

    /// The bench, to look at more than a scenario can name.
    pub fn rig(&self) -> &Rig {
        &self.rig
    }

    /// Compares the panel with a golden picture.
    fn picture(&mut self, file: &str) -> Answer {
        let now = self.rig.now();
        let Some(shown) = self.rig.board().panel().visible(now) else { return Answer::word("a dark panel") };
        if !self.golden.iter().any(|(name, _)| name == file) {
            let drawing = self.rig.board().panel().last_write().is_some_and(|at| now.since(at) < QUIET);
            if self.pictures.blesses() && drawing {
                return Answer::word("half a picture");
            }
            let golden = self.pictures.golden(file, &shown);
            self.golden.push((file.to_owned(), golden));
        }
        let golden =
            self.golden.iter().find(|(name, _)| name == file).and_then(|(_, golden)| golden.as_ref());
        match golden {
            Some(golden) if golden.rgb == shown.rgb => Answer::word(file),
            Some(golden) => {
                let pixels = golden.rgb.chunks(3).zip(shown.rgb.chunks(3));
                let differing = pixels.filter(|(golden, shown)| golden != shown).count();
                let where_it_is = self.pictures.keep(file, &shown);
                Answer::Word(format!("{differing} other pixels{where_it_is}"))
            }
            None => Answer::word("a picture that is not there to compare with: --bless takes what is shown"),
        }
    }
}

fn write_picture(path: &Path, picture: &Picture) -> Result<()> {
    let folder = path.parent().unwrap_or(path);
    std::fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    std::fs::write(path, picture.png()?).with_context(|| format!("cannot write {}", path.display()))
}

impl Subject for BenchSubject {
    fn place(&self) -> Place {
        Place::Firmware
    }

    fn advance_to(&mut self, ms: u64) -> Result<()> {
        self.rig.run_for(Nanos::from_millis(ms).since(self.rig.now()))?;
        let (heard, next) = self.rig.heard_since(self.heard);
        self.heard = next;
        for heard in heard.iter().filter(|heard| heard.by_cluster) {
            if let Some(frame) = heard.frame.data_frame() {
                self.sent.push(heard.at.as_micros() / 1_000, frame);
            }
        }
        Ok(())
    }

    fn act(&mut self, action: &Action) -> Result<()> {
        match action {
            Action::Set { path, setting } => {
                if let Some(vehicle) = self.rig.vehicle_mut() {
                    vehicle.set(path, *setting)?;
                }
            }
            Action::Hold(button, down) => {
                let index = match button {
                    Button::Next => 0,
                    Button::Menu => 1,
                };
                self.rig.hold_button(index, *down);
            }
            Action::Fault(fault, on) => match fault {
                BusFault::Short => self.rig.short_bus(*on),
                BusFault::Babble => self.rig.babble(*on),
                BusFault::Garble => self.rig.garble(*on),
                BusFault::Unplug => self.rig.unplug(*on),
                BusFault::PowerCut => self.rig.cut_power(*on),
            },
            Action::Send(frame) => self.rig.send(*frame),
        }
        Ok(())
    }

    fn look(&mut self, name: &Name) -> Option<Answer> {
        let vehicle = self.rig.identified();
        let shown = |answer: &dyn Fn(Screen) -> Answer| {
            self.rig.screen().map_or_else(|| Answer::word("never"), answer)
        };
        Some(match name {
            Name::Speed => shown(&|screen| Answer::of_number(screen.speed_kmh)),
            Name::Gear => shown(&|screen| gear(Gear::from_number(screen.gear.into()))),
            Name::Odometer => shown(&|screen| Answer::Number(f64::from(screen.odometer_hectometres) / 10.0)),
            Name::Line => {
                shown(&|screen| Answer::Line(screen.line.map(|line| FoundLine::of_record(line, vehicle))))
            }
            Name::Unseen => {
                shown(&|screen| Answer::Line(screen.unseen.map(|line| FoundLine::of_record(line, vehicle))))
            }
            Name::Below => {
                shown(&|screen| Answer::Line(screen.below.map(|line| FoundLine::of_record(line, vehicle))))
            }
            Name::Severity => shown(&|screen| {
                let severity = screen.line.map_or(0, |line| line.severity);
                Answer::word(Severity::from_model(severity.into()).word())
            }),
            Name::Telltale(lamp) => shown(&|screen| {
                Answer::word(if screen.telltales >> *lamp as u8 & 1 != 0 { "on" } else { "off" })
            }),
            Name::Value(value) => Answer::of_sample(self.rig.value(*value), *value),
            Name::Sent(signal) => self.sent.answer(signal, self.rig.now().as_micros() / 1_000),
            Name::Truth { path, .. } => {
                Answer::of_truth(self.rig.vehicle().and_then(|vehicle| vehicle.readout(path)))
            }
            Name::Health(field) => health(self.rig.health(), field),
            Name::Sound => self.sound_at(self.rig.now().as_micros() / 1_000),
            Name::Countdown => {
                shown(&|screen| screen.hv_off_s.map_or(Answer::word("none"), |s| Answer::Number(s.into())))
            }
            Name::Limp => shown(&|screen| match (screen.limps, screen.limp_deciamps) {
                (false, _) => Answer::word("none"),
                (true, None) => Answer::word("unknown"),
                (true, Some(deciamps)) => Answer::Number(f64::from(deciamps) / 10.0),
            }),
            Name::Page => shown(&|screen| page(screen.page)),
            Name::Picture => return None,
        })
    }

    fn picture(&mut self, file: &str) -> Option<Answer> {
        Some(Self::picture(self, file))
    }

    fn sound_at(&self, ms: u64) -> Answer {
        sound::sound_at(self.rig.board().buzzer(), Nanos::from_millis(ms))
    }

    fn hindsight_ms(&self) -> u64 {
        LONGEST_PAUSE_MS
    }
}

/// Returns a field of the health record; a state is told by its word.
fn health(health: protocol_core::link::Health, field: &str) -> Answer {
    match serde_json::to_value(health).ok().and_then(|record| record.get(field).cloned()) {
        Some(serde_json::Value::Number(number)) => Answer::Number(number.as_f64().unwrap_or_default()),
        Some(serde_json::Value::String(word)) => Answer::Word(word),
        _ => Answer::word("never"),
    }
}
