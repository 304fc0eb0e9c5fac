//! What a file is that a person drops on the page: an image, a recording, a DBC file, or none of these.
//!
//! By its bytes first, by the end of its name only where bytes do not tell. Nothing leaves the browser.

use bench::can::Id;
use bench::log::{Log, Reading};
use bench::rp2040::image;
use protocol_core::CanId;
use serde::Serialize;
use std::collections::BTreeMap;
use vehicle_compiler::{Diagnostics, Grade, RunTime, encoding, lint};

/// Findings and decoded signals that are told; the rest is counted.
const ROWS_MAX: usize = 400;

/// What a file is, as the page is told.
#[derive(Serialize)]
#[serde(tag = "is", rename_all = "snake_case")]
pub enum Dropped {
    /// An image of the firmware; the bench has started anew with it.
    Image {
        /// Name of the file.
        name: String,
        /// The flash, from its first byte.
        #[serde(skip)]
        flash: Vec<u8>,
        /// Its length in bytes.
        bytes: usize,
    },
    /// A recording; the bench plays it.
    Recording {
        /// Name of the file.
        name: String,
        /// What it was read as, and what a reader should know of it.
        notes: Vec<String>,
        /// Frames in it.
        frames: usize,
        /// Its length in seconds.
        seconds: f64,
        /// Its frames by the DBC file that was dropped before.
        decoded: Vec<Decoded>,
        /// Signals that are not told.
        more: usize,
    },
    /// A DBC file.
    Dbc {
        /// Name of the file.
        name: String,
        /// Messages that can be read.
        messages: usize,
        /// What is wrong, with its line.
        findings: Vec<Finding>,
        /// Findings that are not told.
        more: usize,
        /// Frames of the recording that was dropped before.
        decoded: Vec<Decoded>,
    },
    /// Nothing that the bench knows.
    Other {
        /// Name of the file.
        name: String,
        /// Why not, in words for a person.
        problem: String,
    },
}

/// One thing that is wrong with a DBC file.
#[derive(Serialize)]
pub struct Finding {
    /// Line, from 1; 0 = the file as a whole.
    line: usize,
    /// Column in bytes, from 1; 0 = the line as a whole.
    column: usize,
    grade: &'static str,
    text: String,
}

/// A signal of a recording.
#[derive(Clone, Serialize)]
pub struct Decoded {
    message: String,
    signal: String,
    /// Frames that carried it.
    frames: usize,
    /// Its last value, with its word where it has one.
    last: String,
    unit: String,
}

/// Says what a file is.
pub fn read_file(name: &str, bytes: &[u8]) -> Dropped {
    let name = name.to_owned();
    if bytes.starts_with(b"\x7fELF") {
        return match image::flash_from_elf(bytes) {
            Ok(flash) => Dropped::Image { name, bytes: flash.len(), flash },
            Err(problem) => Dropped::Other { problem: image::told(&name, problem), name },
        };
    }
    if name.to_lowercase().ends_with(".dbc") {
        return dbc(name, bytes);
    }
    match Reading::default().bytes(&name, bytes) {
        Ok(recording) => match recording.log() {
            Ok(log) => Dropped::Recording {
                notes: std::iter::once(recording.format().to_owned()).chain(log.notes.clone()).collect(),
                frames: log.entries.len(),
                seconds: log.duration().as_secs_f64(),
                decoded: Vec::new(),
                more: 0,
                name,
            },
            Err(error) => Dropped::Other { name, problem: error.to_string() },
        },
        Err(error) => Dropped::Other { name, problem: error.to_string() },
    }
}

fn dbc(name: String, bytes: &[u8]) -> Dropped {
    let none = |name: String, found: Diagnostics| {
        let (findings, more) = told(found);
        Dropped::Dbc { name, messages: 0, findings, more, decoded: Vec::new() }
    };
    let text = match encoding::decode(&name, bytes.to_vec()) {
        Ok(text) => text,
        Err(found) => return none(name, found),
    };
    let found = lint::lint(&name, &text);
    match RunTime::of_texts(&name, (&name, &text), None) {
        Ok(run_time) => {
            let (findings, more) = told(found);
            let messages = run_time.network.messages.len();
            Dropped::Dbc { name, messages, findings, more, decoded: Vec::new() }
        }
        Err(_) => none(name, found),
    }
}

fn told(found: Diagnostics) -> (Vec<Finding>, usize) {
    let more = found.0.len().saturating_sub(ROWS_MAX);
    let rows = found.0.into_iter().take(ROWS_MAX).map(|found| Finding {
        line: found.line,
        column: found.column,
        grade: match found.grade {
            Grade::Error => "error",
            Grade::Warning => "warning",
            Grade::Note => "note",
        },
        text: found.message,
    });
    (rows.collect(), more)
}

/// Reads a DBC file for [`decode`]; `None` if it cannot be read.
pub(crate) fn run_time(name: &str, bytes: &[u8]) -> Option<RunTime> {
    let text = encoding::decode(name, bytes.to_vec()).ok()?;
    RunTime::of_texts(name, (name, &text), None).ok()
}

/// Decodes a recording by a DBC file: each signal once, with its last value.
pub(crate) fn decode(run_time: &RunTime, log: &Log) -> (Vec<Decoded>, usize) {
    let mut rows: BTreeMap<(usize, usize), Decoded> = BTreeMap::new();
    for entry in &log.entries {
        let Some(frame) = entry.frame.data_frame() else { continue };
        let id = match entry.frame.id {
            Id::Standard(id) => CanId::standard(id.raw()),
            Id::Extended(id) => CanId::extended(id.raw()),
        };
        let Some((index, message)) =
            run_time.network.message_of(id).and_then(|at| Some((at, run_time.network.messages.get(at)?)))
        else {
            continue;
        };
        let data = frame.padded();
        for at in 0..message.signals.len() {
            if !message.carries(at, data) {
                continue;
            }
            let signal = &message.signals[at];
            let raw = signal.raw(data);
            let value = signal.word(raw).map_or_else(|| signal.value(raw), |word| format!("{word} ({raw})"));
            let row = rows.entry((index, at)).or_insert_with(|| Decoded {
                message: message.name.clone(),
                signal: signal.name.clone(),
                frames: 0,
                last: String::new(),
                unit: signal.unit.clone(),
            });
            row.frames += 1;
            row.last = value;
        }
    }
    let more = rows.len().saturating_sub(ROWS_MAX);
    (rows.into_values().take(ROWS_MAX).collect(), more)
}
