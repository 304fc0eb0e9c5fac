//! Recordings of a CAN bus: reads the formats that people have, writes candump's.
//!
//! Reads `candump -l` logs, what candump prints on the screen, Vector ASC and GVRET/SavvyCAN CSV; the format is found
//! from the lines themselves. A line that cannot be read is an error that names file and line; nothing is skipped
//! silently. Error frames of a recording are counted, they carry no data.
//! Not supported: CAN FD frames (an error that says so), binary formats (BLF, MF4): convert them with
//! `python3 -m can.logconvert IN OUT.log`.

mod asc;
mod candump;
mod gvret;

use crate::can::Frame;
use crate::time::Nanos;
use std::fmt;
use std::path::Path;

/// One recorded frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Time since the first frame of the recording.
    pub at: Nanos,
    /// The frame.
    pub frame: Frame,
    /// The line it stands in, from 1.
    pub line: usize,
}

/// A whole recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Log {
    /// Time of the first frame as the recorder wrote it (nanoseconds since its own epoch).
    pub origin: Nanos,
    /// The frames, ascending in time.
    pub entries: Vec<Entry>,
    /// Lines that record a bus error instead of a frame.
    pub error_frames: usize,
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

impl fmt::Display for LogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            0 => write!(f, "{}: {}", self.file, self.problem),
            line => write!(f, "{}:{line}: {}", self.file, self.problem),
        }
    }
}

impl std::error::Error for LogError {}

/// What one line of a recording says.
enum Line {
    /// A frame and the recorder's time of it.
    Frame(Nanos, Frame),
    /// A bus error.
    BusError,
    /// Nothing: empty, a comment or a header.
    Nothing,
}

/// One format of recordings.
struct Format {
    /// Whether a line looks like it.
    looks_like: fn(&str) -> bool,
    read: fn(&str) -> Result<Line, String>,
}

const FORMATS: &[Format] = &[
    Format { looks_like: candump::looks_logged, read: candump::read_logged },
    Format { looks_like: gvret::looks_like, read: gvret::read },
    Format { looks_like: asc::looks_like, read: asc::read },
    Format { looks_like: candump::looks_shown, read: candump::read_shown },
];

impl Log {
    /// Reads a file.
    ///
    /// # Errors
    /// If the file is missing, is not text, or a line cannot be read.
    pub fn read_file(path: &Path) -> Result<Self, LogError> {
        let file = path.display().to_string();
        let bytes = std::fs::read(path).map_err(|error| LogError {
            file: file.clone(),
            line: 0,
            problem: format!("cannot read the log: {error}"),
        })?;
        let text = String::from_utf8(bytes).map_err(|error| LogError {
            line: 1 + error.as_bytes()[..error.utf8_error().valid_up_to()]
                .iter()
                .filter(|&&b| b == b'\n')
                .count(),
            file: file.clone(),
            problem: "not a text log (BLF and MF4: `python3 -m can.logconvert IN OUT.log`)".into(),
        })?;
        Self::parse(&file, &text)
    }

    /// Reads the text of a recording; `file` is its name in errors.
    ///
    /// # Errors
    /// If a line cannot be read, time goes back, or there is no frame at all.
    pub fn parse(file: &str, text: &str) -> Result<Self, LogError> {
        let wrong = |line: usize, problem: String| LogError { file: file.to_owned(), line, problem };
        let first =
            text.lines().map(str::trim).find(|line| FORMATS.iter().any(|format| (format.looks_like)(line)));
        let format = first.and_then(|line| FORMATS.iter().find(|format| (format.looks_like)(line)));
        let Some(Format { read, .. }) = format else {
            let line = text.lines().position(|line| !line.trim().is_empty()).map_or(0, |index| index + 1);
            return Err(wrong(
                line,
                "not a CAN log that is known here (candump, Vector ASC, GVRET CSV)".into(),
            ));
        };
        let mut log = Self { origin: Nanos::ZERO, entries: Vec::new(), error_frames: 0 };
        let mut last = None;
        for (index, line) in text.lines().enumerate() {
            let (line, number) = (line.trim(), index + 1);
            match read(line).map_err(|problem| wrong(number, problem))? {
                Line::Nothing => {}
                Line::BusError => log.error_frames += 1,
                Line::Frame(at, frame) => {
                    if last.is_some_and(|last| at < last) {
                        return Err(wrong(number, "time goes back; sort the log by time first".into()));
                    }
                    last = Some(at);
                    if log.entries.is_empty() {
                        log.origin = at;
                    }
                    log.entries.push(Entry { at: at - log.origin, frame, line: number });
                }
            }
        }
        if log.entries.is_empty() {
            return Err(wrong(0, "the log holds no frame".into()));
        }
        Ok(log)
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

/// Returns one line of a `candump -l` log.
pub fn candump_line(at: Nanos, interface: &str, frame: &Frame) -> String {
    format!("({}.{:06}) {interface} {frame}", at.0 / 1_000_000_000, at.0 / 1_000 % 1_000_000)
}

/// Reads decimal seconds exactly: digits, a point, up to nine digits.
fn seconds(text: &str) -> Result<Nanos, String> {
    let wrong = || format!("`{text}` is not a time in seconds");
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(whole) || !(fraction.is_empty() || digits(fraction)) || fraction.len() > 9 {
        return Err(wrong());
    }
    let nanos: u64 = format!("{fraction:0<9}").parse().map_err(|_| wrong())?;
    let whole =
        whole.parse::<u64>().ok().and_then(|whole| whole.checked_mul(1_000_000_000)).ok_or_else(wrong)?;
    whole.checked_add(nanos).map(Nanos).ok_or_else(wrong)
}

/// Reads an identifier in hexadecimal; `extended` says how many bits it has.
fn identifier(text: &str, extended: bool) -> Result<crate::can::Id, String> {
    let raw =
        u32::from_str_radix(text, 16).map_err(|_| format!("`{text}` is not a hexadecimal identifier"))?;
    let id = if extended {
        crate::can::Id::extended(raw)
    } else {
        u16::try_from(raw).ok().and_then(crate::can::Id::standard)
    };
    id.ok_or_else(|| format!("identifier {text} has more than {} bits", if extended { 29 } else { 11 }))
}

/// Reads data bytes in hexadecimal, one word each.
fn payload<'a>(words: impl Iterator<Item = &'a str>) -> Result<Vec<u8>, String> {
    let byte = |word: &str| u8::from_str_radix(word, 16).map_err(|_| format!("`{word}` is not a data byte"));
    words.map(byte).collect()
}

/// Makes a data frame of at most eight bytes.
fn data_frame(id: crate::can::Id, data: &[u8]) -> Result<Frame, String> {
    Frame::new(id, data)
        .ok_or_else(|| format!("{} data bytes; a classic CAN frame has at most 8", data.len()))
}

#[cfg(test)]
mod tests;
