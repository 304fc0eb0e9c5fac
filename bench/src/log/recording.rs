//! A recording that is read twice: once for what its file tells, once for its frames, in memory that does not grow.
//!
//! The first pass finds the format, the channels, the identifiers and what the times count from; every line that cannot be
//! read is found by it. The second one gives the frames.

use super::blf::{self, Blf};
use super::formats;
use super::line::{Event, Line, What};
use super::lines::{self, Lines};
use super::placer::{CHOOSE, Placer};
use super::reader::{Reader, Said};
use super::times::Proof;
use super::{Channel, Entry, LogError, Reading, Times, notes};
use crate::can::Id;
use std::collections::{BTreeMap, HashMap};
use std::fs::File;
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Channels that a message names; a recording has a handful, a damaged one may have any number.
const CHANNELS_NAMED: usize = 8;

/// Where the bytes of a recording are.
#[derive(Clone, Debug)]
enum Source {
    File(PathBuf),
    /// What cannot be read twice: a pipe, a text of a test.
    Held(Arc<[u8]>),
}

impl Source {
    fn of(path: &Path) -> std::io::Result<Self> {
        if path.metadata()?.is_file() {
            return Ok(Self::File(path.to_owned()));
        }
        let mut bytes = Vec::new();
        File::open(path)?.read_to_end(&mut bytes)?;
        Ok(Self::Held(bytes.into()))
    }

    fn open(&self) -> std::io::Result<Box<dyn Read + Send>> {
        Ok(match self {
            Self::File(path) => Box::new(File::open(path)?),
            Self::Held(bytes) => Box::new(Cursor::new(Arc::clone(bytes))),
        })
    }
}

/// One pass over a recording.
struct Pass {
    body: Body,
    reader: Reader,
}

enum Body {
    Text(Lines),
    Blf(Blf),
}

impl Pass {
    fn new(file: &str, source: &Source, strict: bool) -> Result<Self, LogError> {
        let reader = Reader::new(file, strict);
        let unread = |error| reader.wrong(0, format!("cannot read the log: {error}"));
        let (start, bytes) = source.open().and_then(lines::peeked).map_err(unread)?;
        if let Some(problem) = formats::refusal(&start) {
            return Err(reader.wrong(0, problem));
        }
        let body = if start.starts_with(blf::START) {
            Body::Blf(Blf::new(bytes))
        } else {
            Body::Text(Lines::new(&start, bytes))
        };
        Ok(Self { body, reader })
    }

    /// Reads on to the next thing that is said about a bus.
    fn next(&mut self) -> Result<Option<Said>, LogError> {
        loop {
            match &mut self.body {
                Body::Text(lines) => {
                    let next = self.reader.number() + 1;
                    let read = lines.read();
                    let Some(line) = read.map_err(|error| self.reader.wrong(next, error.to_string()))? else {
                        return Ok(None);
                    };
                    if let Some(said) = self.reader.read(&line.text, line.is_ended)? {
                        return Ok(Some(said));
                    }
                }
                Body::Blf(blf) => {
                    self.reader.count_object(formats::BLF);
                    let number = self.reader.number();
                    let read = blf.read().map_err(|problem| {
                        let text = format!("object {number}: {} ({})", problem.text, formats::BLF);
                        self.reader.wrong(0, text)
                    })?;
                    match read {
                        Some(Line::Event(event)) => return Ok(Some(Said::Event(event))),
                        Some(_) => {}
                        None if blf.is_cut_off => {
                            self.reader.cut_off()?;
                            return Ok(None);
                        }
                        None => return Ok(None),
                    }
                }
            }
        }
    }
}

/// A recording whose file has been looked through.
#[derive(Clone, Debug)]
pub struct Recording {
    file: String,
    source: Source,
    reading: Reading,
    /// The channel to keep, `None` = every one.
    channel: Option<String>,
    times: Times,
    format: &'static str,
    heard: Heard,
}

impl Reading {
    /// Looks through a file.
    ///
    /// # Errors
    /// If the file is missing, its format is not read, a line cannot be read, there is no frame at all, or the file leaves
    /// open what this reading does not say either.
    pub fn open(&self, path: &Path) -> Result<Recording, LogError> {
        let file = path.display().to_string();
        let source = Source::of(path).map_err(|error| {
            let problem = format!("cannot read the log: {error}");
            LogError { file: file.clone(), line: 0, column: 0, problem }
        })?;
        Recording::new(file, source, self)
    }

    /// Looks through a recording that is in memory; `file` is its name in errors.
    ///
    /// # Errors
    /// Like [`Reading::open`].
    pub fn bytes(&self, file: &str, bytes: &[u8]) -> Result<Recording, LogError> {
        Recording::new(file.to_owned(), Source::Held(bytes.into()), self)
    }
}

impl Recording {
    fn new(file: String, source: Source, reading: &Reading) -> Result<Self, LogError> {
        let mut pass = Pass::new(&file, &source, reading.strict)?;
        let (mut heard, mut proof) = (Heard::default(), Proof::default());
        while let Some(said) = pass.next()? {
            let at = match &said {
                Said::Event(event) => event.at,
                Said::Time(at) => Some(*at),
            };
            if let Some(at) = at {
                proof.take(pass.reader.number(), at);
            }
            if let Said::Event(event) = said {
                heard.take(&event);
            }
        }
        let reader = &pass.reader;
        if heard.channels.is_empty() {
            return Err(match heard.fd_frames {
                0 => reader.no_frames(),
                fd => reader.wrong(0, format!("the log holds {fd} frames of CAN FD and no classic one")),
            });
        }
        let channel = heard.choose(reading.channel.as_ref()).map_err(|problem| reader.wrong(0, problem))?;
        let times = match reading.times {
            Some(times) => times,
            None => proof.kind().map_err(|(line, problem)| reader.wrong(line, problem))?,
        };
        let format = reader.format().unwrap_or_default();
        Ok(Self { file, source, reading: reading.clone(), channel, times, format, heard })
    }

    /// What the format of the recording is called.
    pub fn format(&self) -> &'static str {
        self.format
    }

    /// Returns the identifiers of the channel that is meant, and how many frames each has.
    pub fn ids(&self) -> impl Iterator<Item = (Id, usize)> {
        let is_meant = |channel: usize| {
            self.channel.as_ref().is_none_or(|meant| *meant == self.heard.channels[channel].0)
        };
        self.heard
            .ids
            .iter()
            .filter(move |((channel, _), _)| is_meant(*channel))
            .map(|((_, id), n)| (*id, *n))
    }

    /// Starts to give the frames.
    ///
    /// # Errors
    /// If the file cannot be read any more.
    pub fn entries(&self) -> Result<Entries, LogError> {
        let pass = Pass::new(&self.file, &self.source, self.reading.strict)?;
        let mut placer = Placer::new(self.reading.clone(), self.channel.clone(), self.times);
        // Numbered as by the first pass, whichever of them are meant.
        placer.channels = self.channels().map(str::to_owned).collect();
        Ok(Entries { pass, placer, shared: self.heard.shared_ids(), is_over: false })
    }

    /// Names of all channels, in the order in which they are first heard.
    pub fn channels(&self) -> impl Iterator<Item = &str> {
        self.heard.channels.iter().map(|(name, _)| name.as_str())
    }
}

/// What the first pass heard.
#[derive(Clone, Debug, Default)]
struct Heard {
    /// Channels with how many frames they have, in the order in which they are first heard.
    channels: Vec<(String, usize)>,
    places: HashMap<String, usize>,
    /// Frames by channel and identifier.
    ids: HashMap<(usize, Id), usize>,
    fd_frames: usize,
}

impl Heard {
    fn take(&mut self, event: &Event) {
        let frame = match event.what {
            What::Frame(frame) => frame,
            What::FdFrame => {
                self.fd_frames += 1;
                return;
            }
            What::BusError => return,
        };
        let place = match self.places.get(&event.channel) {
            Some(place) => *place,
            None => {
                self.channels.push((event.channel.clone(), 0));
                self.places.insert(event.channel.clone(), self.channels.len() - 1);
                self.channels.len() - 1
            }
        };
        self.channels[place].1 += 1;
        *self.ids.entry((place, frame.id)).or_default() += 1;
    }

    /// Returns the channel to keep, `None` = every one.
    fn choose(&self, wanted: Option<&Channel>) -> Result<Option<String>, String> {
        match wanted {
            Some(Channel::All) => Ok(None),
            Some(Channel::Named(name)) if self.places.contains_key(name) => Ok(Some(name.clone())),
            Some(Channel::Named(name)) => Err(format!("no frame is of channel {name} ({})", self.listed())),
            None if self.channels.len() > 1 => {
                let shared = self.shared_ids().map_or(String::new(), |shared| format!("; {shared}"));
                let (count, list) = (self.channels.len(), self.listed());
                Err(format!("the log has {count} channels ({list}){shared}; {CHOOSE}"))
            }
            None => Ok(None),
        }
    }

    fn listed(&self) -> String {
        let name = |(name, frames): &(String, usize)| format!("{name}: {frames} frames");
        let named: Vec<String> = self.channels.iter().take(CHANNELS_NAMED).map(name).collect();
        let more = self.channels.len().saturating_sub(CHANNELS_NAMED);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        named.join(", ") + &more
    }

    /// Returns what to say of identifiers that are on more than one channel, if there are any.
    fn shared_ids(&self) -> Option<String> {
        let mut channels = BTreeMap::<(bool, u32), usize>::new();
        for (_, id) in self.ids.keys() {
            *channels.entry((id.is_extended(), id.raw())).or_default() += 1;
        }
        channels.retain(|_, count| *count > 1);
        let ((extended, first), _) = channels.first_key_value()?;
        let first = if *extended { format!("{first:08X}") } else { format!("{first:03X}") };
        Some(match channels.len() {
            1 => format!("identifier {first} is on more than one of them"),
            n => format!("{n} identifiers are on more than one of them, the first is {first}"),
        })
    }
}

/// The frames of a recording, ascending in time.
pub struct Entries {
    pass: Pass,
    placer: Placer,
    /// What to say of identifiers on several channels.
    shared: Option<String>,
    is_over: bool,
}

impl Entries {
    fn read(&mut self) -> Result<Option<Entry>, LogError> {
        while let Some(said) = self.pass.next()? {
            let line = self.pass.reader.number();
            let placed = self.placer.place(line, said);
            if let Some(entry) = placed.map_err(|problem| self.pass.reader.wrong(line, problem))? {
                return Ok(Some(entry));
            }
        }
        Ok(None)
    }

    /// Returns the time of the first frame as the recorder wrote it, in nanoseconds since its own epoch; zero before it.
    pub fn origin(&self) -> i64 {
        self.placer.origin()
    }

    /// Returns whether the frames have times, the recorder's or evenly spaced ones.
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

    /// Returns how many lines so far are no frames and no part of the format.
    pub fn foreign_lines(&self) -> usize {
        self.pass.reader.foreign
    }

    /// Returns what a reader of the recording should know so far, one sentence each.
    pub fn notes(&self) -> Vec<String> {
        let mut notes = notes(&self.pass.reader, &self.placer);
        let is_mixed = self.placer.keeps_all();
        notes.extend(
            self.shared.iter().filter(|_| is_mixed).map(|shared| format!("channels are mixed: {shared}")),
        );
        notes
    }
}

impl Iterator for Entries {
    type Item = Result<Entry, LogError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.is_over {
            return None;
        }
        let read = self.read();
        self.is_over = !matches!(read, Ok(Some(_)));
        read.transpose()
    }
}
