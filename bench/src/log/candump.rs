//! can-utils' candump: `candump -l` files and what candump prints on the screen.
//!
//! Source: can-utils lib.c and candump.c. Of the screen's options `-a`, `-c`, `-e`, `-t`, `-x` and `-8` are read; `-i` and
//! `-S` are refused.

use super::calendar;
use super::line::{Event, Line, ReadLine, What};
use super::token::{
    Evidence, Problem, Read, Stamp, coded_frame, data_frame, hex, hex_byte, identifier, is_digits, payload,
    quoted, seconds, time_of_day,
};
use crate::can::{Frame, Id};

/// Bit 29 of a SocketCAN identifier marks an error frame.
const ERROR_FLAG: u32 = 0x2000_0000;
/// Digits before the point of a Unix time, to which candump fills it up.
const UNIX_DIGITS: usize = 10;
/// Digits before the point to which candump fills up a time that counts from the first line or the one before.
const SHORT_DIGITS: usize = 3;

/// `(1436509052.249713) can0 18FEF100#0102030405060708`
pub(super) fn looks_logged(line: &str) -> bool {
    let text = bracketed(line.trim()).and_then(|(_, rest)| rest.split_whitespace().nth(1));
    text.is_some_and(|text| text.contains('#'))
}

/// `(1436509052.249713)  can0  18FEF100   [8]  01 02 03 04 05 06 07 08`, the time being optional.
pub(super) fn looks_shown(line: &str) -> bool {
    matches!(Parts::of(line.trim()), Ok(Some(_)))
}

pub(super) fn read_logged(line: &str) -> Read<Line> {
    if line.is_empty() || line.starts_with('#') {
        return Ok(Line::Blank);
    }
    if !line.starts_with('(') && !line.split_whitespace().any(is_id_and_data) {
        return Ok(Line::Foreign(None));
    }
    let expected = "expected `(seconds) interface id#data`";
    let (time, rest) = bracketed(line).ok_or(expected)?;
    let words: Vec<&str> = rest.split_whitespace().collect();
    // The last word is the direction, which `candump -l -x` writes.
    let ([channel, text] | [channel, text, "R" | "T"]) = words[..] else { return Err(expected.into()) };
    let at = Some(stamp(time)?);
    let event = |what| Ok(Line::Event(Event { at, channel: channel.to_owned(), what }));
    let (id, data) = text
        .split_once('#')
        .ok_or_else(|| Problem::of(text, format!("{} has no `#` between id and data", quoted(text))))?;
    let Some(id) = frame_identifier(id)? else { return event(What::BusError) };
    if data.starts_with('#') {
        return event(What::FdFrame);
    }
    if let Some(length) = data.strip_prefix('R') {
        let code = remote_length(length).ok_or_else(|| {
            let text = format!("{} is not a remote request: R, R0 to R8, R8_9 to R8_F", quoted(data));
            Problem::of(data, text)
        })?;
        return event(What::Frame(Frame::new_remote(id, code)));
    }
    let (bytes, code) = data.split_once('_').map_or((data, None), |(bytes, code)| (bytes, Some(code)));
    if bytes.len() % 2 != 0 || !bytes.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return Err(Problem::of(bytes, format!("{} is not pairs of hexadecimal digits", quoted(bytes))));
    }
    let pairs = (0..bytes.len()).step_by(2).map(|at| &bytes[at..at + 2]);
    let bytes = payload(pairs, hex_byte(2..=2))?;
    event(What::Frame(match code {
        None => data_frame(id, &bytes)?,
        Some(text) => {
            let code = raw_length(text).ok_or_else(|| {
                Problem::of(text, format!("{} is not a length code of 9 to F", quoted(text)))
            })?;
            coded_frame(id, code, &bytes)?
        }
    }))
}

/// What candump prints on the screen.
#[derive(Debug, Default)]
pub(super) struct Shown {
    /// The line before was an error frame: `-e` explains it in the lines below, each after a tab.
    explains: bool,
}

impl ReadLine for Shown {
    fn read(&mut self, line: &str) -> Read<Line> {
        let text = line.trim();
        if text.is_empty() || text.starts_with('#') || self.explains && line.starts_with('\t') {
            return Ok(Line::Blank);
        }
        self.explains = false;
        if looks_logged(text) {
            return Err("a line of candump -l among lines of the screen".into());
        }
        let Some(Parts { time, channel, between, id, length, tail }) = Parts::of(text)? else {
            return Ok(Line::Foreign(None));
        };
        let at = time.map(stamp).transpose()?;
        if !matches!(between[..], [] | ["RX" | "TX", "-" | "B", "-" | "E"]) {
            let text = format!("{} between interface and identifier", quoted(&between.join(" ")));
            return Err(Problem::of(between[0], text));
        }
        let event = |what| Ok(Line::Event(Event { at, channel: channel.to_owned(), what }));
        let Some(id) = frame_identifier(id)? else {
            self.explains = true;
            return event(What::BusError);
        };
        let Some(code) = length.code()? else { return event(What::FdFrame) };
        if tail.trim() == "remote request" {
            return event(What::Frame(Frame::new_remote(id, code)));
        }
        // `-a` adds an ASCII view in quotes at the end.
        let words: Vec<&str> = tail.split('\'').next().unwrap_or(tail).split_whitespace().collect();
        let is_binary = |word: &&str| word.len() == 8 && word.bytes().all(|bit| matches!(bit, b'0' | b'1'));
        if !words.is_empty() && words.iter().all(is_binary) {
            let text = format!("{} is binary, as candump -i writes it; record without -i", quoted(words[0]));
            return Err(Problem::of(words[0], text));
        }
        if words.iter().any(|word| word.contains('`')) {
            return Err("the bytes stand in reverse, as candump -S writes them; record without -S".into());
        }
        event(What::Frame(coded_frame(id, code, &payload(words, hex_byte(2..=2))?)?))
    }
}

/// A line of the screen, cut at the places that its form has.
struct Parts<'a> {
    time: Option<&'a str>,
    channel: &'a str,
    /// Words of `-x` between interface and identifier.
    between: Vec<&'a str>,
    id: &'a str,
    length: Length<'a>,
    tail: &'a str,
}

/// The length as written: `[8]`, or with `-8` the code of it, `{8}`.
enum Length<'a> {
    Bytes(&'a str),
    Code(&'a str),
}

impl Length<'_> {
    /// Returns the length code; `None` = a frame of CAN FD, whose length candump writes with two digits.
    fn code(&self) -> Read<Option<u8>> {
        match self {
            Self::Bytes(text) if text.len() == 2 && is_digits(text) => Ok(None),
            Self::Bytes(text) => match text.as_bytes() {
                [digit @ b'0'..=b'8'] => Ok(Some(digit - b'0')),
                _ => Err(Problem::of(text, format!("{} is not a length of 0 to 8", quoted(text)))),
            },
            Self::Code(text) => hex_byte(1..=1)(text)
                .map(Some)
                .ok_or_else(|| Problem::of(text, format!("{} is not a length code of 0 to F", quoted(text)))),
        }
    }
}

impl<'a> Parts<'a> {
    /// Returns the parts of a line that is meant as a frame, `None` of any other.
    fn of(line: &'a str) -> Read<Option<Self>> {
        let (time, rest) = match bracketed(line) {
            Some((time, rest)) => (Some(time), rest),
            None if line.starts_with('(') && line[1..].starts_with(|sign: char| sign.is_ascii_digit()) => {
                return Err(Problem::of(line, "the time has no closing bracket".into()));
            }
            None => (None, line),
        };
        let cut = rest.find(['[', '{']).and_then(|open| {
            let (head, tail) = (&rest[..open], &rest[open + 1..]);
            let bytes = rest[open..].starts_with('[');
            let (length, tail) = tail.split_once(if bytes { ']' } else { '}' })?;
            let is_length = if bytes { is_digits(length) } else { hex(length, 1..=1).is_some() };
            let length = if bytes { Length::Bytes(length) } else { Length::Code(length) };
            is_length.then_some((head, length, tail))
        });
        let Some((head, length, tail)) = cut else {
            let is_timed = time.is_some_and(|time| seconds(time).is_ok());
            return if is_timed { Err("expected `interface id [length] data`".into()) } else { Ok(None) };
        };
        let words: Vec<&str> = head.split_whitespace().collect();
        match words[..] {
            [channel, ref between @ .., id] => {
                Ok(Some(Self { time, channel, between: between.to_vec(), id, length, tail }))
            }
            [id] if hex(id, 3..=8).is_some() => Err("no interface before the identifier".into()),
            _ => Ok(None),
        }
    }
}

/// Splits `(time) rest`.
fn bracketed(line: &str) -> Option<(&str, &str)> {
    let (time, rest) = line.strip_prefix('(')?.split_once(')')?;
    Some((time.trim(), rest))
}

/// Returns whether a word has the form `id#...`.
fn is_id_and_data(word: &str) -> bool {
    word.split_once('#').is_some_and(|(id, _)| matches!(id.len(), 3 | 8) && hex(id, 3..=8).is_some())
}

/// Reads seconds, or a date as `-tA` writes it.
fn stamp(text: &str) -> Read<Stamp> {
    if let Some((date, clock)) = text.split_once(' ') {
        let seconds = date_seconds(date).zip(time_of_day(clock, '.').ok());
        let nanos = seconds.map(|(seconds, of_day)| seconds * 1_000_000_000 + of_day);
        let nanos = nanos
            .ok_or_else(|| Problem::of(text, format!("{} is neither seconds nor a date", quoted(text))))?;
        return Ok(Stamp { nanos, evidence: Evidence::Absolute });
    }
    let nanos = seconds(text)?;
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let evidence = match (whole.len(), fraction.len()) {
        (UNIX_DIGITS.., _) => Evidence::Absolute,
        (SHORT_DIGITS, 6 | 9) if whole.starts_with('0') => Evidence::Nothing,
        _ => Evidence::Likely,
    };
    Ok(Stamp { nanos, evidence })
}

/// Reads `2026-01-31` as seconds since 1970; the zone is taken as UTC, the recorder's is not written.
fn date_seconds(text: &str) -> Option<i64> {
    let parts: Vec<&str> = text.split('-').collect();
    let [year, month, day] = parts[..] else { return None };
    let number = |text: &str, digits: usize| -> Option<i64> {
        if text.len() == digits && is_digits(text) { text.parse().ok() } else { None }
    };
    let (year, month, day) = (number(year, 4)?, number(month, 2)?, number(day, 2)?);
    if !(1970..=2200).contains(&year) || !(1..=12).contains(&month) || !(1..=31).contains(&day) {
        return None;
    }
    Some(calendar::days(year, month, day) * 86_400)
}

/// Reads an identifier of three or eight digits; `None` = it marks an error frame.
fn frame_identifier(text: &str) -> Read<Option<Id>> {
    let extended = match text.chars().count() {
        3 => false,
        8 => true,
        n => {
            let problem = format!("identifier {} has {n} digits; 3 for 11 bits, 8 for 29 bits", quoted(text));
            return Err(Problem::of(text, problem));
        }
    };
    let raw = hex(text, 3..=8);
    if extended && raw.is_some_and(|raw| raw & ERROR_FLAG != 0) {
        return Ok(None);
    }
    identifier(text, raw, extended).map(Some)
}

/// Reads the length of a remote request: nothing, 0 to 8, or 8 and a length code of 9 to 15.
fn remote_length(text: &str) -> Option<u8> {
    match (text.as_bytes(), text.strip_prefix("8_")) {
        ([], _) => Some(0),
        ([digit @ b'0'..=b'8'], _) => Some(digit - b'0'),
        (_, Some(code)) => raw_length(code),
        _ => None,
    }
}

/// Reads a length code that means eight bytes and is not 8: 9 to F.
fn raw_length(text: &str) -> Option<u8> {
    hex_byte(1..=1)(text).filter(|code| *code > 8)
}
