//! What the times of a recording count from, and the time that each frame gets.
//!
//! Times count from a fixed moment or from the line before. GVRET and the head of an ASC file say which; a candump line
//! does not always: `-ta` writes ten digits before the point, `-td` (from the line before) and `-tz` (from the first
//! line) both write three. Decided is only what the lines prove: gaps between frames do not grow for ever, so times
//! that only rise are no gaps, and times that rise and fall are no clock. The rest has to be said.

use super::Times;
use super::token::{Evidence, Stamp};
use crate::time::Nanos;

/// A step back up to here is the order in which a recorder emptied its buffers, not another recording.
const STEP_BACK_MAX: Nanos = Nanos::from_millis(100);
/// A time of day that is half of this earlier than the one before is of the next day; in nanoseconds.
const DAY: i64 = 24 * 3_600 * 1_000_000_000;
/// Steps upwards that prove a clock. That nine gaps in a row happen to be sorted has a chance of one in 362 880.
const RISES_OF_A_CLOCK: usize = 8;
/// A clock that was read a little late now and then goes back in at most one of so many steps; gaps do in every other.
const RISES_PER_FALL: usize = 8;

/// What the times of a recording prove about what they count from.
#[derive(Debug, Default)]
pub(super) struct Proof {
    /// The first one and its line.
    first: Option<(usize, Stamp)>,
    last: i64,
    rises: usize,
    falls: usize,
    /// The line of the first step back.
    first_fall: usize,
}

impl Proof {
    /// Takes the next time and its line.
    pub(super) fn take(&mut self, line: usize, stamp: Stamp) {
        if self.first.is_none() {
            self.first = Some((line, stamp));
        } else if stamp.nanos > self.last {
            self.rises += 1;
        } else if stamp.nanos < self.last {
            if self.falls == 0 {
                self.first_fall = line;
            }
            self.falls += 1;
        }
        self.last = stamp.nanos;
    }

    /// Returns what the times count from, or the line and the reason why that cannot be told.
    pub(super) fn kind(&self) -> Result<Times, (usize, String)> {
        let Some((first_line, first)) = self.first else { return Ok(Times::Absolute) };
        match first.evidence {
            Evidence::Absolute | Evidence::Midnight => return Ok(Times::Absolute),
            Evidence::Delta => return Ok(Times::Delta),
            Evidence::Likely | Evidence::Nothing => {}
        }
        if self.falls * RISES_PER_FALL > self.rises {
            let problem = "time goes back: if each time counts from the line before, as candump -td writes it, say \
                           `--times delta`; if not, say `--times absolute`";
            return Err((self.first_fall, problem.into()));
        }
        if first.evidence == Evidence::Nothing && self.rises < RISES_OF_A_CLOCK {
            return Err((first_line, UNDECIDED.into()));
        }
        Ok(Times::Absolute)
    }
}

/// What is said when nothing tells one kind of times from the other.
pub(super) const UNDECIDED: &str = "times of this form count from the first line (candump -tz) or from the line before \
                                    (candump -td), and nothing here tells which: say `--times absolute` or `--times \
                                    delta`";

/// Turns the times of a recording into times since its first frame.
#[derive(Debug)]
pub(super) struct Clock {
    times: Times,
    /// Sum of all gaps so far, in nanoseconds.
    sum: i64,
    /// The last time of day, and the days before it, in nanoseconds.
    of_day: i64,
    days: i64,
    origin: Option<i64>,
    latest: i64,
    /// Frames that were dated before the one above.
    pub(super) late: usize,
    /// The longest step back among them.
    pub(super) latest_by: Nanos,
}

impl Clock {
    pub(super) fn new(times: Times) -> Self {
        Self { times, sum: 0, of_day: 0, days: 0, origin: None, latest: 0, late: 0, latest_by: Nanos::ZERO }
    }

    /// Time of the first frame, in nanoseconds since the recorder's epoch.
    pub(super) fn origin(&self) -> i64 {
        self.origin.unwrap_or(0)
    }

    /// Takes the time of a line, whatever the line says, and returns it as one that counts from a fixed moment.
    pub(super) fn pass(&mut self, stamp: Stamp) -> Result<i64, String> {
        match self.times {
            Times::Absolute if stamp.evidence == Evidence::Midnight => {
                if stamp.nanos + DAY / 2 < self.of_day {
                    self.days += DAY;
                }
                self.of_day = stamp.nanos;
                Ok(self.days + stamp.nanos)
            }
            Times::Absolute => Ok(stamp.nanos),
            Times::Delta => {
                let sum = self.sum.checked_add(stamp.nanos);
                self.sum = sum.ok_or("the times add up to more than 292 years")?;
                Ok(self.sum)
            }
        }
    }

    /// Returns the time since the first frame of a frame at `now`, which is never before that of the frame above.
    pub(super) fn place(&mut self, now: i64) -> Result<Nanos, String> {
        let origin = *self.origin.get_or_insert_with(|| {
            self.latest = now;
            now
        });
        if now < self.latest {
            let back = Nanos(now.abs_diff(self.latest));
            if back > STEP_BACK_MAX {
                return Err(format!("time goes back by {back}; cut the log here, or sort its lines by time"));
            }
            self.late += 1;
            self.latest_by = self.latest_by.max(back);
        }
        self.latest = self.latest.max(now);
        Ok(Nanos(self.latest.abs_diff(origin)))
    }
}
