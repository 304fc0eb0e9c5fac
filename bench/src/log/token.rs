//! Tokens that the formats share, each held to its form: digits only, no sign, no other width than stated.

use crate::can::{Frame, Id};
use crate::printable::printable;
use std::ops::RangeInclusive;

/// What a reader makes of a piece of a line.
pub(super) type Read<T> = Result<T, Problem>;

/// Why a line cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Problem {
    pub(super) text: String,
    /// Where the piece that is meant stands in memory, inside of its line.
    address: Option<usize>,
}

impl Problem {
    /// A problem with one piece of the line.
    pub(super) fn of(piece: &str, text: String) -> Self {
        Self { text, address: Some(piece.as_ptr() as usize) }
    }

    /// Returns the column in `line` of the piece that is meant, in characters from 1.
    pub(super) fn column(&self, line: &str) -> Option<usize> {
        let bytes = self.address?.checked_sub(line.as_ptr() as usize)?;
        Some(line.get(..bytes)?.chars().count() + 1)
    }
}

impl From<String> for Problem {
    fn from(text: String) -> Self {
        Self { text, address: None }
    }
}

impl From<&str> for Problem {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

/// Longest piece of a file that a message repeats, in characters.
const QUOTED_MAX: usize = 60;
/// Most data bytes of a classic frame; a length code of 9 to 15 means as many (ISO 11898-1).
const DATA_MAX: usize = 8;
/// What the form of a time says about what it counts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Evidence {
    /// From a fixed moment: the format says so.
    Absolute,
    /// From the line before: the file says so.
    Delta,
    /// From the last midnight: the format writes hours, minutes and seconds.
    Midnight,
    /// Very likely from a fixed moment: candump writes gaps in another form.
    Likely,
    /// Nothing: the tool writes both alike.
    Nothing,
}

/// A time as the recorder wrote it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    /// Nanoseconds since an epoch of the recorder's own; SavvyCAN writes some below zero.
    pub(super) nanos: i64,
    /// What its form says about what it counts from.
    pub(super) evidence: Evidence,
}

/// Returns a piece of a file for a message: cut to a readable length, nothing in it that a terminal would obey.
pub(super) fn quoted(text: &str) -> String {
    let mut shown: String = text.chars().take(QUOTED_MAX).collect();
    if shown.len() < text.len() {
        shown.push_str("...");
    }
    format!("`{}`", printable(&shown))
}

/// Returns whether text is one digit or more and nothing else.
pub(super) fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Reads a number of so many hexadecimal digits.
pub(super) fn hex(text: &str, digits: RangeInclusive<usize>) -> Option<u32> {
    let is_hex = text.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_hex && digits.contains(&text.len()) { u32::from_str_radix(text, 16).ok() } else { None }
}

/// Reads a decimal number exactly, in units of 10 to the power of minus `decimals`: digits, a point, no more digits than
/// that.
fn fixed(text: &str, decimals: usize) -> Option<i64> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    if !is_digits(whole) || !(fraction.is_empty() || is_digits(fraction)) || fraction.len() > decimals {
        return None;
    }
    let scale = 10_i64.checked_pow(u32::try_from(decimals).ok()?)?;
    let fraction: i64 = format!("0{fraction:0<decimals$}").parse().ok()?;
    whole.parse::<i64>().ok()?.checked_mul(scale)?.checked_add(fraction)
}

/// Reads decimal seconds exactly, to nine digits behind the point, as nanoseconds.
pub(super) fn seconds(text: &str) -> Read<i64> {
    fixed(text, 9).ok_or_else(|| Problem::of(text, format!("{} is not a time in seconds", quoted(text))))
}

/// Reads decimal milliseconds exactly, to six digits behind the point, as nanoseconds.
pub(super) fn millis(text: &str) -> Read<i64> {
    fixed(text, 6).ok_or_else(|| Problem::of(text, format!("{} is not a time in milliseconds", quoted(text))))
}

/// Reads `21:11:45:171` as nanoseconds: hours, minutes, seconds and a fraction behind `point`.
pub(super) fn time_of_day(text: &str, point: char) -> Read<i64> {
    let read = || {
        let (clock, fraction) = text.rsplit_once(point)?;
        let parts: Vec<&str> = clock.split(':').collect();
        let [hours, minutes, seconds] = parts[..] else { return None };
        let two = |text: &str, limit: i64| {
            let number = if text.len() <= 2 { fixed(text, 0)? } else { return None };
            (number < limit).then_some(number)
        };
        let whole = two(hours, 24)? * 3_600 + two(minutes, 60)? * 60 + two(seconds, 60)?;
        fixed(&format!("{whole}.{fraction}"), 9).filter(|_| is_digits(fraction))
    };
    read().ok_or_else(|| Problem::of(text, format!("{} is not a time of day", quoted(text))))
}

/// Makes an identifier of a number that was read, or not, from `text`; `extended` says how many bits it has.
pub(super) fn identifier(text: &str, raw: Option<u32>, extended: bool) -> Read<Id> {
    let raw = raw.ok_or_else(|| Problem::of(text, format!("{} is not an identifier", quoted(text))))?;
    let id = if extended { Id::extended(raw) } else { u16::try_from(raw).ok().and_then(Id::standard) };
    id.ok_or_else(|| {
        let bits = if extended { 29 } else { 11 };
        Problem::of(text, format!("identifier {} has more than {bits} bits", quoted(text)))
    })
}

/// Makes an identifier of hexadecimal digits where nothing else says how many bits it has: 29 if it needs them.
pub(super) fn identifier_by_size(text: &str) -> Read<Id> {
    let raw = hex(text, 1..=8);
    identifier(text, raw, raw.is_some_and(|raw| raw > 0x7FF))
}

/// Reads the data bytes of `words`, all of them, with `byte`.
pub(super) fn payload<'a>(
    words: impl IntoIterator<Item = &'a str>,
    byte: impl Fn(&str) -> Option<u8>,
) -> Read<Vec<u8>> {
    let read = |word: &str| {
        byte(word).ok_or_else(|| Problem::of(word, format!("{} is not a data byte", quoted(word))))
    };
    words.into_iter().map(read).collect()
}

/// Reads one byte of so many hexadecimal digits.
pub(super) fn hex_byte(digits: RangeInclusive<usize>) -> impl Fn(&str) -> Option<u8> {
    move |word| hex(word, digits.clone()).and_then(|value| u8::try_from(value).ok())
}

/// Reads a decimal number of at most three digits: lengths and length codes.
pub(super) fn count(text: &str) -> Read<usize> {
    let number = if is_digits(text) && text.len() <= 3 { text.parse().ok() } else { None };
    number.ok_or_else(|| Problem::of(text, format!("{} is not a length", quoted(text))))
}

/// Returns how many data bytes a length code stands for.
pub(super) fn data_length(code: u8) -> usize {
    usize::from(code).min(DATA_MAX)
}

/// Makes a data frame of at most eight bytes.
pub(super) fn data_frame(id: Id, data: &[u8]) -> Read<Frame> {
    Frame::new(id, data).ok_or_else(|| {
        format!("{} data bytes; a classic CAN frame has at most {DATA_MAX}", data.len()).into()
    })
}

/// Makes a data frame whose length code is written out: of 9 to 15 it has eight bytes.
pub(super) fn coded_frame(id: Id, code: u8, data: &[u8]) -> Read<Frame> {
    if data.len() != data_length(code) {
        let needed = data_length(code);
        return Err(format!("{} data bytes where the length says {needed}", data.len()).into());
    }
    Ok(Frame { dlc: code, ..data_frame(id, data)? })
}
