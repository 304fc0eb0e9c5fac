//! Reads a recording line by line: finds the format, counts what is no frame, notices a last line that is cut off.

use super::format::Format;
use super::line::{Event, Line};
use super::token::Stamp;
use super::{LogError, others};
use crate::can::Id;
use std::collections::HashMap;

/// Longest head: tools put some lines before the first frame, a terminal's log the start of a program.
const HEAD_LINES: usize = 1_000;

/// What a line said about a bus.
#[derive(Debug)]
pub(super) enum Said {
    /// Something that happened on a bus.
    Event(Event),
    /// Time that passed at a line that is no matter of CAN.
    Time(Stamp),
}

/// Reads the lines of one recording.
#[derive(Debug, Default)]
pub(super) struct Reader {
    file: String,
    format: Option<Format>,
    /// Lines read so far.
    number: usize,
    /// The first line that is not empty.
    first_text: usize,
    /// Lines that are no frames and no part of the format, and the first of them.
    pub(super) foreign: usize,
    pub(super) first_foreign: usize,
    /// The last line ended without an end of line and is not whole.
    pub(super) is_cut_off: bool,
    /// Length of the shortest line of each identifier, in bytes.
    shortest: HashMap<Id, usize>,
}

impl Reader {
    pub(super) fn new(file: &str) -> Self {
        Self { file: file.to_owned(), ..Self::default() }
    }

    /// Number of the line that was read last, from 1.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// Returns an error of a line; line 0 is the file as a whole.
    pub(super) fn wrong(&self, line: usize, problem: impl Into<String>) -> LogError {
        LogError { file: self.file.clone(), line, problem: problem.into() }
    }

    /// Reads the next line, with its end of line if it has one: only the last one of a recording may have none.
    pub(super) fn read(&mut self, line: &str) -> Result<Option<Said>, LogError> {
        self.number += 1;
        // A mark of the byte order stands before the text and is no part of it.
        let line = if self.number == 1 { line.trim_start_matches('\u{FEFF}') } else { line };
        let (text, is_ended) = match line.strip_suffix('\n') {
            Some(text) => (text, true),
            None => (line, false),
        };
        if self.format.is_none() && !self.find_format(text.trim())? {
            return Ok(None);
        }
        let Some(format) = &mut self.format else { return Ok(None) };
        let said = format.read(text);
        let has_frames = !self.shortest.is_empty();
        match said {
            Err(_) if !is_ended && has_frames => self.is_cut_off = true,
            Err(problem) => return Err(self.wrong(self.number, problem)),
            Ok(Line::Blank) => {}
            Ok(Line::Foreign(at)) => {
                self.count_foreign();
                return Ok(at.map(Said::Time));
            }
            Ok(Line::Event(event)) => {
                if let Some(frame) = &event.frame {
                    let length = text.trim().len();
                    let shortest = self.shortest.entry(frame.id).or_insert(length);
                    // A line that lost its end may still read as a frame with less data.
                    if !is_ended && length < *shortest {
                        self.is_cut_off = true;
                        return Ok(None);
                    }
                    *shortest = length.min(*shortest);
                }
                return Ok(Some(Said::Event(event)));
            }
        }
        Ok(None)
    }

    /// Ends a recording in which no frame was found.
    pub(super) fn no_frames(&self) -> LogError {
        if self.format.is_none() && self.first_text > 0 {
            return self.wrong(self.first_text, UNKNOWN);
        }
        self.wrong(0, "the log holds no frame")
    }

    fn find_format(&mut self, text: &str) -> Result<bool, LogError> {
        if text.is_empty() || text.starts_with('#') {
            return Ok(false);
        }
        if self.first_text == 0 {
            self.first_text = self.number;
        }
        if let Some(problem) = others::refusal(text) {
            return Err(self.wrong(self.number, problem));
        }
        self.format = Format::of(text);
        if self.format.is_none() {
            self.count_foreign();
            if self.number >= HEAD_LINES {
                return Err(self.no_frames());
            }
        }
        Ok(self.format.is_some())
    }

    fn count_foreign(&mut self) {
        if self.foreign == 0 {
            self.first_foreign = self.number;
        }
        self.foreign += 1;
    }
}

/// What is said of a file of no format that is known.
const UNKNOWN: &str = "not a CAN log that is known here (candump, Vector ASC, GVRET CSV)";
