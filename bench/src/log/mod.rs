//! Recordings of a CAN bus: reads the formats that people have, writes candump's.
//!
//! Reads `candump -l` logs, what candump prints on the screen, Vector ASC and GVRET/SavvyCAN CSV; the format is found
//! from the lines themselves, and a format that is recognised but not read is refused by its name. Every line is read,
//! counted as no frame, or an error that names file and line: nothing is skipped silently. Error frames of a recording
//! are counted, they carry no data.
//!
//! What a file does not tell is asked for, never guessed ([`Reading`]): which of several channels is meant, what the times
//! count from, how far apart frames without times are. Clocks that go back by up to a tenth of a second are taken as the
//! order in which a recorder emptied its buffers: such a frame keeps its place and takes the time of the one above.
//! Not supported: CAN FD frames (an error that says so), binary formats (BLF, MF4): convert them with
//! `python3 -m can.logconvert IN OUT.log`.

mod asc;
mod candump;
mod format;
mod gvret;
mod line;
mod live;
mod others;
mod placer;
mod reader;
mod times;
mod token;

pub use live::Live;

use crate::can::Frame;
use crate::time::Nanos;
use line::Event;
use placer::Placer;
use reader::{Reader, Said};
use std::collections::HashMap;
use std::fmt;
use std::path::Path;

/// One recorded frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Time since the first frame of the recording; zero if the recording has no times.
    pub at: Nanos,
    /// The frame.
    pub frame: Frame,
    /// The line it stands in, from 1.
    pub line: usize,
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
    /// What is wrong.
    pub problem: String,
}

/// What a file says reaches the terminal with its control characters escaped.
impl fmt::Display for LogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (file, problem) = (token::printable(&self.file), token::printable(&self.problem));
        match self.line {
            0 => write!(f, "{file}: {problem}"),
            line => write!(f, "{file}:{line}: {problem}"),
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
    /// Reads a file.
    ///
    /// # Errors
    /// If the file is missing, is not text, or as for [`Reading::text`].
    pub fn file(&self, path: &Path) -> Result<Log, LogError> {
        let file = path.display().to_string();
        let wrong = |problem: String| LogError { file: file.clone(), line: 0, problem };
        let bytes = std::fs::read(path).map_err(|error| wrong(format!("cannot read the log: {error}")))?;
        if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
            return Err(wrong("UTF-16 text; save it as UTF-8".into()));
        }
        // Frames are ASCII in every format; what else a head holds may be in any encoding.
        let text = String::from_utf8_lossy(&bytes);
        if matches!(text, std::borrow::Cow::Owned(_)) && bytes.contains(&0) {
            return Err(wrong("not a text log (BLF and MF4: `python3 -m can.logconvert IN OUT.log`)".into()));
        }
        self.text(&file, &text)
    }

    /// Reads the text of a recording; `file` is its name in errors.
    ///
    /// # Errors
    /// If a line cannot be read, time goes back, there is no frame at all, or the file leaves open what this reading does
    /// not say either.
    pub fn text(&self, file: &str, text: &str) -> Result<Log, LogError> {
        let mut reader = Reader::new(file);
        let (mut said, mut stamps) = (Vec::new(), Vec::new());
        for line in text.split_inclusive('\n') {
            let Some(what) = reader.read(line)? else { continue };
            let at = match &what {
                Said::Event(event) => event.at,
                Said::Time(at) => Some(*at),
            };
            stamps.extend(at.map(|at| (reader.number(), at)));
            said.push((reader.number(), what));
        }
        let channel = self.channel_of(&said).map_err(|problem| reader.wrong(0, problem))?;
        let times = match self.times {
            Some(times) => times,
            None => times::kind_of(&stamps).map_err(|(line, problem)| reader.wrong(line, problem))?,
        };
        let mut placer = Placer::new(self.clone(), channel, times);
        let mut entries = Vec::new();
        for (line, what) in said {
            let placed = placer.place(what).map_err(|problem| reader.wrong(line, problem))?;
            entries.extend(placed.map(|(at, frame)| Entry { at, frame, line }));
        }
        if entries.is_empty() {
            return Err(reader.no_frames());
        }
        Ok(Log {
            origin: placer.origin(),
            timed: placer.is_timed(),
            error_frames: placer.error_frames,
            notes: notes(&reader, &placer),
            entries,
        })
    }

    /// Returns the channel to keep, `None` = every one.
    fn channel_of(&self, said: &[(usize, Said)]) -> Result<Option<String>, String> {
        // In the order in which they are first heard.
        let (mut heard, mut places) = (Vec::<(&str, usize)>::new(), HashMap::new());
        for (_, what) in said {
            let Said::Event(event @ Event { frame: Some(_), .. }) = what else { continue };
            let place = *places.entry(event.channel.as_str()).or_insert_with(|| {
                heard.push((&event.channel, 0));
                heard.len() - 1
            });
            heard[place].1 += 1;
        }
        let list = || {
            let name = |(name, frames): &(&str, usize)| format!("{name}: {frames} frames");
            let named: Vec<String> = heard.iter().take(CHANNELS_NAMED).map(name).collect();
            let more = heard.len().saturating_sub(CHANNELS_NAMED);
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            named.join(", ") + &more
        };
        match &self.channel {
            Some(Channel::All) => Ok(None),
            Some(Channel::Named(name)) if heard.is_empty() || places.contains_key(name.as_str()) => {
                Ok(Some(name.clone()))
            }
            Some(Channel::Named(name)) => Err(format!("no frame is of channel {name} ({})", list())),
            None if heard.len() > 1 => {
                Err(format!("the log has {} channels ({}); {CHOOSE}", heard.len(), list()))
            }
            None => Ok(None),
        }
    }
}

/// Channels that a message names; a recording has a handful, a damaged one may have any number.
const CHANNELS_NAMED: usize = 8;
/// What is said of a recording of several channels.
const CHOOSE: &str = "choose one with `--channel NAME`, or mix them with `--channel all`";

/// Returns what a reader of the recording should know.
fn notes(reader: &Reader, placer: &Placer) -> Vec<String> {
    let mut notes = Vec::new();
    match reader.foreign {
        0 => {}
        1 => notes.push(format!("1 line is no frame: line {}", reader.first_foreign)),
        n => notes.push(format!("{n} lines are no frames, the first is line {}", reader.first_foreign)),
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

/// Returns one line of a `candump -l` log.
pub fn candump_line(at: Nanos, interface: &str, frame: &Frame) -> String {
    format!("({}.{:06}) {interface} {frame}", at.0 / 1_000_000_000, at.0 / 1_000 % 1_000_000)
}

#[cfg(test)]
mod tests;
