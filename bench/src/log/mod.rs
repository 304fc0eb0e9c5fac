//! Recordings of a CAN bus: reads the formats that people have, writes three of them.
//!
//! The formats are the rows of [`FORMATS`], and Vector BLF; a recording's is found from its head or its lines, and a
//! format that is recognised but not read is refused by its name. Every line is read, counted as no frame, or an error
//! that names file, line and column: nothing is skipped silently. Error frames and frames of CAN FD are counted.
//!
//! What a file does not tell is asked for, never guessed ([`Reading`]): which of several channels is meant, what the times
//! count from, how far apart frames without times are. Clocks that go back by up to a tenth of a second are taken as the
//! order in which a recorder emptied its buffers: such a frame keeps its place and takes the time of the one above.
//! A file is read twice and never held ([`Recording`]); [`Log`] holds all of its frames.
//! Not supported: the data of CAN FD frames, MF4.

mod asc;
mod blf;
mod busmaster;
mod calendar;
mod candump;
mod crtd;
mod formats;
mod gvret;
mod kvaser;
mod line;
mod lines;
mod live;
mod pcan;
mod placer;
mod python_csv;
mod reader;
mod recording;
mod tables;
mod terminals;
mod times;
mod token;
mod write;

pub use formats::{BLF, FORMATS, Format};
pub use live::Live;
pub use recording::{Entries, Recording};
pub use write::{Form, Writer, candump_line};

use crate::can::Frame;
use crate::printable::printable;
use crate::time::Nanos;
use placer::Placer;
use reader::Reader;
use std::fmt;
use std::path::Path;

/// One recorded frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Time since the first frame of the recording; zero if the recording has no times.
    pub at: Nanos,
    /// The frame.
    pub frame: Frame,
    /// The line it stands in, from 1; the object in a format without lines.
    pub line: usize,
    /// Its channel: the place in [`Recording::channels`].
    pub channel: usize,
}

/// A whole recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Log {
    /// Time of the first frame as the recorder wrote it, in nanoseconds since its own epoch; below zero in some files of
    /// SavvyCAN's.
    pub origin: i64,
    /// The frames have times, the recorder's or evenly spaced ones.
    pub timed: bool,
    /// The frames, ascending in time.
    pub entries: Vec<Entry>,
    /// Lines that record a bus error instead of a frame.
    pub error_frames: usize,
    /// What its reader should know, one sentence each: lines left out, times mended.
    pub notes: Vec<String>,
}

/// How to read a recording: what its file does not tell.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// The channel whose frames are meant; needed for a recording of several.
    pub channel: Option<Channel>,
    /// What the times count from; `None` = as the file tells or proves.
    pub times: Option<Times>,
    /// Time from frame to frame of a recording without times; `None` = such a recording is refused.
    pub spacing: Option<Nanos>,
    /// Takes a recording without times as it is: all at zero.
    pub untimed: bool,
    /// Refuses what is otherwise counted and said: lines that are no frames, frames of CAN FD, a last line that is cut off.
    pub strict: bool,
}

/// Which channels of a recording are meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Channel {
    /// All of them as if they were one bus.
    All,
    /// The one of this name: the interface in candump's logs, the number of the bus in the others.
    Named(String),
}

/// What the times of a recording count from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Times {
    /// From a fixed moment, 1970 or the start of the recording.
    Absolute,
    /// From the line before.
    Delta,
}

/// What is wrong with a recording, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LogError {
    /// Name of the file.
    pub file: String,
    /// Line from 1; 0 if the file as a whole is meant.
    pub line: usize,
    /// Column from 1, in characters; 0 if the line as a whole is meant.
    pub column: usize,
    /// What is wrong.
    pub problem: String,
}

/// What a file says reaches the terminal with its control characters escaped.
impl fmt::Display for LogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (file, problem) = (printable(&self.file), printable(&self.problem));
        match (self.line, self.column) {
            (0, _) => write!(f, "{file}: {problem}"),
            (line, 0) => write!(f, "{file}:{line}: {problem}"),
            (line, column) => write!(f, "{file}:{line}:{column}: {problem}"),
        }
    }
}

impl std::error::Error for LogError {}

impl Log {
    /// Returns a recording of these frames, ascending in time: made, not read.
    pub fn of(entries: Vec<Entry>) -> Self {
        Self { origin: 0, timed: true, entries, error_frames: 0, notes: Vec::new() }
    }

    /// Reads a file that tells everything itself.
    ///
    /// # Errors
    /// Like [`Reading::file`].
    pub fn read_file(path: &Path) -> Result<Self, LogError> {
        Reading::default().file(path)
    }

    /// Reads the text of a recording that tells everything itself; `file` is its name in errors.
    ///
    /// # Errors
    /// Like [`Reading::text`].
    pub fn parse(file: &str, text: &str) -> Result<Self, LogError> {
        Reading::default().text(file, text)
    }

    /// Returns the time from the first to the last frame.
    pub fn duration(&self) -> Nanos {
        self.entries.last().map_or(Nanos::ZERO, |entry| entry.at)
    }

    /// Returns the frames with their times, as a replay node takes them.
    pub fn recording(&self) -> Vec<(Nanos, Frame)> {
        self.entries.iter().map(|entry| (entry.at, entry.frame)).collect()
    }
}

impl Reading {
    /// Reads a file and holds all of its frames.
    ///
    /// # Errors
    /// Like [`Reading::open`], and if time goes back.
    pub fn file(&self, path: &Path) -> Result<Log, LogError> {
        self.open(path)?.log()
    }

    /// Reads the text of a recording; `file` is its name in errors.
    ///
    /// # Errors
    /// Like [`Reading::file`].
    pub fn text(&self, file: &str, text: &str) -> Result<Log, LogError> {
        self.bytes(file, text.as_bytes())?.log()
    }
}

impl Recording {
    /// Reads all frames.
    ///
    /// # Errors
    /// If time goes back, or some lines have times and others have none.
    pub fn log(&self) -> Result<Log, LogError> {
        let mut frames = self.entries()?;
        let entries = frames.by_ref().collect::<Result<Vec<Entry>, LogError>>()?;
        Ok(Log {
            origin: frames.origin(),
            timed: frames.is_timed(),
            error_frames: frames.error_frames(),
            notes: frames.notes(),
            entries,
        })
    }
}

/// Returns what a reader of the recording should know.
fn notes(reader: &Reader, placer: &Placer) -> Vec<String> {
    let mut notes = Vec::new();
    match reader.foreign {
        0 => {}
        1 => notes.push(format!("1 line is no frame: line {}", reader.first_foreign)),
        n => notes.push(format!("{n} lines are no frames, the first is line {}", reader.first_foreign)),
    }
    if placer.fd_frames > 0 {
        notes.push(format!("{} frames of CAN FD are left out", placer.fd_frames));
    }
    if placer.of_others > 0 {
        notes.push(format!("{} frames of other channels are left out", placer.of_others));
    }
    if let Some((late, by)) = placer.late() {
        notes.push(format!("{late} frames are dated up to {by} before the one above and take its time"));
    }
    if reader.is_cut_off {
        notes.push(format!("the last line is cut off; {} frames before it were read", placer.frames));
    }
    notes
}

#[cfg(test)]
mod tests;
