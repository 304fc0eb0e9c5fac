//! Reads a recording line by line: finds the format, counts what is no frame, notices a last line that is cut off.

use super::LogError;
use super::formats::{self, Format};
use super::line::{Event, Line, ReadLine, What};
use super::token::{Problem, Stamp};
use crate::can::Id;
use std::borrow::Cow;
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
    /// Refuses what is otherwise counted and said.
    strict: bool,
    /// The name of the format and what reads its lines.
    format: Option<(&'static str, Box<dyn ReadLine>)>,
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
    pub(super) fn new(file: &str, strict: bool) -> Self {
        Self { file: file.to_owned(), strict, ..Self::default() }
    }

    /// What the format is called, once it is found.
    pub(super) fn format(&self) -> Option<&'static str> {
        self.format.as_ref().map(|(name, _)| *name)
    }

    /// Number of the line that was read last, from 1.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// Returns an error of a line; line 0 is the file as a whole.
    pub(super) fn wrong(&self, line: usize, problem: impl Into<String>) -> LogError {
        LogError { file: self.file.clone(), line, column: 0, problem: problem.into() }
    }

    /// Reads the next line, without its end; only the last one of a recording may have had none.
    pub(super) fn read(&mut self, line: &str, is_ended: bool) -> Result<Option<Said>, LogError> {
        self.number += 1;
        // A mark of the byte order stands before the text and is no part of it.
        let line = if self.number == 1 { line.trim_start_matches('\u{FEFF}') } else { line };
        let text = &*without_colours(line);
        if self.format.is_none() && !self.find_format(text.trim())? {
            return Ok(None);
        }
        let Some((_, reader)) = &mut self.format else { return Ok(None) };
        let said = reader.read(text);
        let has_frames = !self.shortest.is_empty();
        match said {
            Err(_) if !is_ended && has_frames => self.cut_off()?,
            Err(problem) => return Err(self.wrong_line(text, problem)),
            Ok(Line::Blank) => {}
            Ok(Line::Foreign(at)) => {
                self.count_foreign()?;
                return Ok(at.map(Said::Time));
            }
            Ok(Line::Event(event)) => {
                if let What::Frame(frame) = &event.what {
                    let length = text.trim().len();
                    let shortest = self.shortest.entry(frame.id).or_insert(length);
                    // A line that lost its end may still read as a frame with less data.
                    if !is_ended && length < *shortest {
                        self.cut_off()?;
                        return Ok(None);
                    }
                    *shortest = length.min(*shortest);
                }
                return Ok(Some(Said::Event(event)));
            }
        }
        Ok(None)
    }

    fn wrong_line(&self, line: &str, problem: Problem) -> LogError {
        let column = problem.column(line).unwrap_or(0);
        let name = self.format().map_or(String::new(), |name| format!(" ({name})"));
        LogError { column, ..self.wrong(self.number, problem.text + &name) }
    }

    /// The recording ends in the middle of a line.
    pub(super) fn cut_off(&mut self) -> Result<(), LogError> {
        if self.strict {
            return Err(self.wrong(self.number, format!("the last line is cut off{STRICT}")));
        }
        self.is_cut_off = true;
        Ok(())
    }

    /// Takes the next object of a recording that has no lines.
    pub(super) fn count_object(&mut self, format: &'static str) {
        self.format.get_or_insert_with(|| (format, Box::new(super::line::EachLine(|_| Ok(Line::Blank)))));
        self.number += 1;
    }

    /// Ends a recording in which no frame was found.
    pub(super) fn no_frames(&self) -> LogError {
        if self.format.is_none() && self.first_text > 0 {
            return self.wrong(self.first_text, formats::unknown());
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
        self.format = Format::of(text).map(|format| (format.name, format.reader()));
        if self.format.is_none() {
            self.count_foreign()?;
            if self.number >= HEAD_LINES {
                return Err(self.no_frames());
            }
        }
        Ok(self.format.is_some())
    }

    fn count_foreign(&mut self) -> Result<(), LogError> {
        if self.strict {
            return Err(self.wrong(self.number, format!("the line is no frame{STRICT}")));
        }
        if self.foreign == 0 {
            self.first_foreign = self.number;
        }
        self.foreign += 1;
        Ok(())
    }
}

/// What is said of something that is refused only because it was asked for.
pub(super) const STRICT: &str = ", and `--strict` leaves nothing out";

/// Returns a line without the escapes by which candump -c colours it.
fn without_colours(line: &str) -> Cow<'_, str> {
    if !line.contains("\u{1b}[") {
        return Cow::Borrowed(line);
    }
    let mut parts = line.split("\u{1b}[");
    let mut text = parts.next().unwrap_or("").to_owned();
    for part in parts {
        match part.split_once('m') {
            Some((colour, rest)) if colour.bytes().all(|byte| byte.is_ascii_digit() || byte == b';') => {
                text.push_str(rest);
            }
            _ => {
                text.push_str("\u{1b}[");
                text.push_str(part);
            }
        }
    }
    Cow::Owned(text)
}
