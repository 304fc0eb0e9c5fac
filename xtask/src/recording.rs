//! How a recording is read, for every command that takes one.

use crate::out::note;
use anyhow::Result;
use bench::log::{Channel, Live, Log, Reading, Recording, Times};
use bench::time::Nanos;
use clap::{Args, ValueEnum};
use std::path::Path;

/// What a recording does not tell of itself.
#[derive(Args, Clone, Debug, Default, PartialEq, Eq)]
pub struct Choices {
    /// Channel of the recording to read, as it is written there: `can0`, `1`; `all` takes several as one bus.
    #[arg(long, value_name = "NAME")]
    channel: Option<String>,
    /// What the recording's times count from, if it does not tell.
    #[arg(long, value_enum)]
    times: Option<CountedFrom>,
    /// Milliseconds from frame to frame of a recording without times.
    #[arg(long, value_name = "MS", value_parser = clap::value_parser!(u32).range(1..))]
    spacing_ms: Option<u32>,
    /// Refuses what is otherwise left out, counted and said: lines that are no frames, frames of CAN FD, a last line that
    /// is cut off.
    #[arg(long)]
    strict: bool,
}

/// What the times of a recording count from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum CountedFrom {
    /// From a fixed moment: candump -ta, candump -tz.
    Absolute,
    /// From the line before: candump -td.
    Delta,
}

impl Choices {
    /// Reads a file and says on standard error what was left out or mended.
    ///
    /// # Errors
    /// If it cannot be read, or leaves open what these choices do not say either.
    pub fn read(&self, path: &Path) -> Result<Log> {
        let log = self.reading().file(path)?;
        say_notes(path, &log.notes);
        Ok(log)
    }

    /// Looks through a file, whose frames are then read one by one.
    ///
    /// # Errors
    /// Like [`Choices::read`].
    pub fn open(&self, path: &Path) -> Result<Recording> {
        Ok(self.reading().open(path)?)
    }

    /// Looks through a file, one without times too.
    ///
    /// # Errors
    /// Like [`Choices::read`].
    pub fn open_untimed(&self, path: &Path) -> Result<Recording> {
        Ok(Reading { untimed: true, ..self.reading() }.open(path)?)
    }

    /// Looks through a file, all of whose channels are kept apart by their names if `keeps_channels`.
    ///
    /// # Errors
    /// Like [`Choices::read`].
    pub fn open_all(&self, path: &Path, keeps_channels: bool) -> Result<Recording> {
        let mut reading = self.reading();
        if keeps_channels {
            reading.channel.get_or_insert(Channel::All);
        }
        Ok(reading.open(path)?)
    }

    /// Starts a recording on standard input, with times or without.
    pub fn live(&self) -> Live {
        Live::new("stdin", &Reading { untimed: true, ..self.reading() })
    }

    fn reading(&self) -> Reading {
        let channel = self.channel.as_ref().map(|name| match name.as_str() {
            "all" => Channel::All,
            name => Channel::Named(name.to_owned()),
        });
        let times = self.times.map(|times| match times {
            CountedFrom::Absolute => Times::Absolute,
            CountedFrom::Delta => Times::Delta,
        });
        let spacing = self.spacing_ms.map(|ms| Nanos::from_millis(ms.into()));
        Reading { channel, times, spacing, untimed: false, strict: self.strict }
    }
}

/// Says on standard error what the reader of a recording should know.
pub fn say_notes(path: &Path, notes: &[String]) {
    for note in notes {
        note!("{}: {note}", path.display());
    }
}
