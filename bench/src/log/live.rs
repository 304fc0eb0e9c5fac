//! A recording that is still being written: one line at a time, each frame at once.
//!
//! What a whole file proves by its later lines cannot be waited for here: times that may count from the line before are
//! refused at the first frame unless the reading says which they are, and a second channel is when it is heard.

use super::placer::Placer;
use super::reader::{Reader, Said};
use super::times::UNDECIDED;
use super::token::Evidence;
use super::{Channel, Entry, LogError, Reading, Times, notes};

/// Reads a recording line by line.
#[derive(Debug)]
pub struct Live {
    reader: Reader,
    placer: Placer,
    /// What the times count from was said, or the first line told.
    times_known: bool,
}

impl Live {
    /// Starts a recording; `name` is its name in errors.
    pub fn new(name: &str, reading: &Reading) -> Self {
        let channel = match &reading.channel {
            Some(Channel::Named(name)) => Some(name.clone()),
            Some(Channel::All) | None => None,
        };
        let times = reading.times.unwrap_or(Times::Absolute);
        Self {
            reader: Reader::new(name, reading.strict),
            placer: Placer::new(reading.clone(), channel, times),
            times_known: reading.times.is_some(),
        }
    }

    /// Returns the frame of the next line, with its time since the first one; the line comes with its end of line.
    ///
    /// # Errors
    /// If the line cannot be read, its time goes back, or it leaves open what the reading does not say either.
    pub fn read(&mut self, line: &str) -> Result<Option<Entry>, LogError> {
        let (text, is_ended) = match line.strip_suffix('\n') {
            Some(text) => (text.strip_suffix('\r').unwrap_or(text), true),
            None => (line, false),
        };
        let Some(said) = self.reader.read(text, is_ended)? else { return Ok(None) };
        let number = self.reader.number();
        self.place(number, said).map_err(|problem| self.reader.wrong(number, problem))
    }

    fn place(&mut self, line: usize, said: Said) -> Result<Option<Entry>, String> {
        let at = match &said {
            Said::Event(event) => {
                self.placer.keep_to_one(event)?;
                event.at
            }
            Said::Time(at) => Some(*at),
        };
        if let (Some(at), false) = (at, self.times_known) {
            let times = match at.evidence {
                Evidence::Absolute | Evidence::Midnight | Evidence::Likely => Times::Absolute,
                Evidence::Delta => Times::Delta,
                Evidence::Nothing => return Err(UNDECIDED.into()),
            };
            self.placer.count_from(times);
            self.times_known = true;
        }
        self.placer.place(line, said)
    }

    /// Ends the recording.
    ///
    /// # Errors
    /// If there was no frame.
    pub fn finish(&self) -> Result<(), LogError> {
        if self.placer.frames == 0 { Err(self.reader.no_frames()) } else { Ok(()) }
    }

    /// Returns the time of the first frame as the recorder wrote it, in nanoseconds since its own epoch.
    pub fn origin(&self) -> i64 {
        self.placer.origin()
    }

    /// Returns whether the frames have times.
    pub fn is_timed(&self) -> bool {
        self.placer.is_timed()
    }

    /// Returns how many bus errors were recorded so far.
    pub fn error_frames(&self) -> usize {
        self.placer.error_frames
    }

    /// Returns how many frames of CAN FD were left out so far.
    pub fn fd_frames(&self) -> usize {
        self.placer.fd_frames
    }

    /// Returns what a reader of the recording should know, one sentence each.
    pub fn notes(&self) -> Vec<String> {
        notes(&self.reader, &self.placer)
    }
}
