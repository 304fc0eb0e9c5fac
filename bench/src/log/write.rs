//! Writes recordings: candump, Vector ASC, python-can's CSV.
//!
//! What a form cannot say is written as its own tools write it: candump and CSV have times to the microsecond. A recorder's
//! time before 1970 exists in no form; it is written from zero on.

use super::Entry;
use super::calendar;
use super::python_csv;
use crate::can::Frame;
use crate::time::Nanos;
use std::io::{self, Write};

/// A form in which recordings are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `candump -l`.
    Candump,
    /// Vector ASC.
    Asc,
    /// python-can's CSV, which names no channel.
    Csv,
}

impl Form {
    /// Every form.
    pub const ALL: [Self; 3] = [Self::Candump, Self::Asc, Self::Csv];

    /// The ending of such a file's name.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Candump => "log",
            Self::Asc => "asc",
            Self::Csv => "csv",
        }
    }
}

/// Writes one recording.
pub struct Writer<W> {
    out: W,
    form: Form,
    /// Name of each channel in candump's form, and its number in ASC's.
    channels: Vec<(String, u32)>,
    /// Time of the first frame since 1970, in nanoseconds; `None` before it.
    origin: Option<u64>,
}

impl<W: Write> Writer<W> {
    /// A recording whose channels have these names.
    pub fn new(out: W, form: Form, channels: &[&str]) -> Self {
        Self { out, form, channels: named(channels), origin: None }
    }

    /// Writes a frame; `origin` is the time of the first one as the recorder wrote it.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn write(&mut self, origin: i64, entry: &Entry) -> io::Result<()> {
        let since_1970 = match self.origin {
            Some(origin) => origin,
            None => {
                let origin = u64::try_from(origin).unwrap_or(0);
                self.head(origin)?;
                *self.origin.insert(origin)
            }
        };
        let (frame, absolute) = (&entry.frame, Nanos(since_1970.saturating_add(entry.at.0)));
        let (name, number) =
            self.channels.get(entry.channel).map_or(("can0", 1), |(name, n)| (name.as_str(), *n));
        match self.form {
            Form::Candump => writeln!(self.out, "{}", candump_line(absolute, name, frame)),
            Form::Asc => writeln!(self.out, "{}", asc_line(entry.at, number, frame)),
            Form::Csv => writeln!(self.out, "{}", csv_line(absolute, frame)),
        }
    }

    /// Writes what stands behind the last frame.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn finish(mut self) -> io::Result<()> {
        if self.form == Form::Asc {
            writeln!(self.out, "End TriggerBlock")?;
        }
        self.out.flush()
    }

    fn head(&mut self, origin: u64) -> io::Result<()> {
        match self.form {
            Form::Candump => Ok(()),
            Form::Asc => {
                let date = asc_date(origin);
                writeln!(self.out, "date {date}\nbase hex  timestamps absolute\nno internal events logged")?;
                writeln!(self.out, "Begin Triggerblock {date}\n{:11.6} Start of measurement", 0.0)
            }
            Form::Csv => writeln!(self.out, "{}", python_csv::HEAD),
        }
    }
}

/// Returns each channel as candump names an interface and as ASC numbers it, from 1.
fn named(channels: &[&str]) -> Vec<(String, u32)> {
    let number = |name: &&str| {
        let digits = name.len() - name.trim_end_matches(|sign: char| sign.is_ascii_digit()).len();
        name[name.len() - digits..].parse::<u32>().ok().filter(|number| *number < 100)
    };
    let numbers: Vec<Option<u32>> = channels.iter().map(number).collect();
    let are_counted_from_zero = numbers.contains(&Some(0)) || numbers.contains(&None);
    let one = |(place, name): (usize, &&str)| {
        let number = numbers[place].unwrap_or(place as u32) + u32::from(are_counted_from_zero);
        let is_name = name.starts_with(|sign: char| sign.is_ascii_alphabetic())
            && name.bytes().all(|byte| byte.is_ascii_alphanumeric());
        (if is_name { (*name).to_owned() } else { format!("can{}", number - 1) }, number)
    };
    channels.iter().enumerate().map(one).collect()
}

/// Returns one line of a `candump -l` log.
pub fn candump_line(at: Nanos, interface: &str, frame: &Frame) -> String {
    format!("({}) {interface} {frame}", micros(at))
}

fn micros(at: Nanos) -> String {
    format!("{}.{:06}", at.0 / 1_000_000_000, at.0 / 1_000 % 1_000_000)
}

fn asc_line(at: Nanos, channel: u32, frame: &Frame) -> String {
    let id = format!("{:X}{}", frame.id.raw(), if frame.id.is_extended() { "x" } else { "" });
    let head = format!("{:>11} {channel}  {id:<15} Rx   ", micros(at));
    if frame.remote {
        return format!("{head}r {:x}", frame.dlc);
    }
    let data = frame.payload().iter().map(|byte| format!(" {byte:02X}")).collect::<String>();
    format!("{head}d {:x}{data}", frame.dlc)
}

/// `Sun Nov 22 10:00:00.000 am 2026`, in UTC.
fn asc_date(origin: u64) -> String {
    const DAYS: [&str; 7] = ["Thu", "Fri", "Sat", "Sun", "Mon", "Tue", "Wed"];
    const MONTHS: [&str; 12] =
        ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"];
    let (millis, seconds) = (origin / 1_000_000 % 1_000, origin / 1_000_000_000);
    let (days, of_day) = ((seconds / 86_400) as i64, seconds % 86_400);
    let (year, month, day) = calendar::date(days);
    let (hour, minute, second) = (of_day / 3_600, of_day / 60 % 60, of_day % 60);
    let (half, hour) = (if hour < 12 { "am" } else { "pm" }, (hour + 11) % 12 + 1);
    let (name, month) = (DAYS[(days % 7) as usize], MONTHS[(month - 1) as usize]);
    format!("{name} {month} {day:02} {hour:02}:{minute:02}:{second:02}.{millis:03} {half} {year}")
}

fn csv_line(at: Nanos, frame: &Frame) -> String {
    let (extended, remote) = (u8::from(frame.id.is_extended()), u8::from(frame.remote));
    let data = python_csv::encoded(frame.payload());
    format!("{},{:#x},{extended},{remote},0,{},{data}", micros(at), frame.id.raw(), frame.dlc)
}
