//! Gives each frame its time, and keeps those of the channel that is meant.

use super::line::{Event, What};
use super::reader::{STRICT, Said};
use super::times::Clock;
use super::{Channel, Entry, Reading, Times};
use crate::time::Nanos;

/// What is said of a recording of several channels.
pub(super) const CHOOSE: &str = "choose one with `--channel NAME`, or mix them with `--channel all`";

/// Where the times of the frames come from; settled by the first event.
#[derive(Debug)]
enum Source {
    /// The recorder's clock.
    Recorder(Clock),
    /// The lines have none: so far apart.
    Spaced(Nanos),
    /// The lines have none, and none is needed.
    Untimed,
}

/// Places the events of one recording in time.
#[derive(Debug)]
pub(super) struct Placer {
    reading: Reading,
    /// The channel to keep, `None` = every one.
    channel: Option<String>,
    times: Times,
    source: Option<Source>,
    /// Frames placed so far.
    pub(super) frames: usize,
    /// Frames left out because of their channel.
    pub(super) of_others: usize,
    /// Bus errors on the channel that is meant.
    pub(super) error_frames: usize,
    /// Frames of CAN FD on the channel that is meant.
    pub(super) fd_frames: usize,
    /// Names of the channels, in the order in which they were first heard.
    pub(super) channels: Vec<String>,
}

impl Placer {
    pub(super) fn new(reading: Reading, channel: Option<String>, times: Times) -> Self {
        Self {
            reading,
            channel,
            times,
            source: None,
            frames: 0,
            of_others: 0,
            error_frames: 0,
            fd_frames: 0,
            channels: Vec::new(),
        }
    }

    /// Returns a frame of the channel that is meant, with its time since the first one.
    pub(super) fn place(&mut self, line: usize, said: Said) -> Result<Option<Entry>, String> {
        let event = match said {
            Said::Event(event) => event,
            Said::Time(at) => {
                if let Some(Source::Recorder(clock)) = &mut self.source {
                    clock.pass(at)?;
                }
                return Ok(None);
            }
        };
        if self.source.is_none() {
            self.source = Some(self.source_for(&event)?);
        }
        let now = match (&mut self.source, event.at) {
            (Some(Source::Recorder(clock)), Some(at)) => Some(clock.pass(at)?),
            (Some(Source::Recorder(_)), None) => {
                return Err("a line without a time, and those above have one".into());
            }
            (_, Some(_)) => return Err("a line with a time, and those above have none".into()),
            (_, None) => None,
        };
        let is_meant = self.channel.as_ref().is_none_or(|channel| *channel == event.channel);
        let frame = match event.what {
            What::Frame(frame) => frame,
            What::BusError => {
                self.error_frames += usize::from(is_meant);
                return Ok(None);
            }
            What::FdFrame if is_meant && self.reading.strict => {
                return Err(format!("a CAN FD frame, which is not read{STRICT}"));
            }
            What::FdFrame => {
                self.fd_frames += usize::from(is_meant);
                return Ok(None);
            }
        };
        if !is_meant {
            self.of_others += 1;
            return Ok(None);
        }
        let at = match (&mut self.source, now) {
            (Some(Source::Recorder(clock)), Some(now)) => clock.place(now)?,
            (Some(Source::Spaced(spacing)), _) => {
                let nanos = spacing.0.checked_mul(self.frames as u64);
                Nanos(nanos.ok_or("the recording plays for more than 584 years")?)
            }
            _ => Nanos::ZERO,
        };
        self.frames += 1;
        let channel = self.number_of(&event.channel);
        Ok(Some(Entry { at, frame, line, channel }))
    }

    /// Returns the place of a channel among those heard.
    fn number_of(&mut self, channel: &str) -> usize {
        self.channels.iter().position(|known| known == channel).unwrap_or_else(|| {
            self.channels.push(channel.to_owned());
            self.channels.len() - 1
        })
    }

    fn source_for(&self, first: &Event) -> Result<Source, String> {
        match (first.at, self.reading.spacing) {
            (Some(_), None) => Ok(Source::Recorder(Clock::new(self.times))),
            (Some(_), Some(_)) => Err("the log has times of its own; leave `--spacing-ms` out".into()),
            (None, Some(spacing)) => Ok(Source::Spaced(spacing)),
            (None, None) if self.reading.untimed => Ok(Source::Untimed),
            (None, None) => {
                Err("the log has no times: say with `--spacing-ms N` how many milliseconds frames \
                                 are apart, or record with candump -l"
                    .into())
            }
        }
    }

    /// Says what the times count from, before the first one is placed.
    pub(super) fn count_from(&mut self, times: Times) {
        self.times = times;
    }

    /// Keeps the first channel heard if none was chosen; another one is an error then.
    pub(super) fn keep_to_one(&mut self, event: &Event) -> Result<(), String> {
        if self.reading.channel == Some(Channel::All) || !matches!(event.what, What::Frame(_)) {
            return Ok(());
        }
        let kept = self.channel.get_or_insert_with(|| event.channel.clone());
        if self.reading.channel.is_some() || *kept == event.channel {
            return Ok(());
        }
        Err(format!("a frame of {} after frames of {kept}; {}", event.channel, CHOOSE))
    }

    /// Time of the first frame, in nanoseconds since the recorder's epoch.
    pub(super) fn origin(&self) -> i64 {
        if let Some(Source::Recorder(clock)) = &self.source { clock.origin() } else { 0 }
    }

    /// Returns whether the channels of the recording are taken as one bus.
    pub(super) fn keeps_all(&self) -> bool {
        self.channel.is_none()
    }

    pub(super) fn is_timed(&self) -> bool {
        !matches!(self.source, Some(Source::Untimed))
    }

    /// Frames that were dated before the one above, and by how much at most.
    pub(super) fn late(&self) -> Option<(usize, Nanos)> {
        match &self.source {
            Some(Source::Recorder(clock)) if clock.late > 0 => Some((clock.late, clock.latest_by)),
            _ => None,
        }
    }
}
