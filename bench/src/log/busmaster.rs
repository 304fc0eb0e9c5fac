//! BUSMASTER's logs: `22:20:14:9920 Rx 1 0x0CF101A7 x 8 D0 00 00 0A 50 FF 80 01`.
//!
//! The head says the base of the numbers and what the times count from: the clock of the system, the start of the log,
//! or the line before. Type: s = 11 bits, x = 29 bits, r behind it = remote request. Source: its logs and its converter
//! to ASC.

use super::line::{Event, Line, ReadLine, What};
use super::token::{
    Evidence, Problem, Read, count, data_frame, hex, hex_byte, identifier, is_digits, payload, quoted,
    time_of_day,
};
use crate::can::Frame;

/// What the head says that times count from.
const MODES: &[(&str, Evidence)] = &[
    ("SYSTEM MODE", Evidence::Midnight),
    ("ABSOLUTE MODE", Evidence::Absolute),
    ("RELATIVE MODE", Evidence::Delta),
];

/// What the head said.
#[derive(Debug)]
pub(super) struct Busmaster {
    decimal: bool,
    times: Evidence,
}

impl Default for Busmaster {
    fn default() -> Self {
        Self { decimal: false, times: Evidence::Midnight }
    }
}

pub(super) fn looks_like(line: &str) -> bool {
    line.starts_with("***BUSMASTER")
}

impl Busmaster {
    fn read_head(&mut self, text: &str) {
        match text {
            "HEX" => self.decimal = false,
            "DEC" => self.decimal = true,
            _ => {}
        }
        if let Some((_, times)) = MODES.iter().find(|(mode, _)| *mode == text) {
            self.times = *times;
        }
    }

    fn number(&self, text: &str) -> Option<u32> {
        match (self.decimal, text.strip_prefix("0x")) {
            (_, Some(digits)) => hex(digits, 1..=8),
            (false, None) => hex(text, 1..=8),
            (true, None) => text.parse().ok().filter(|_| is_digits(text)),
        }
    }

    fn byte(&self, text: &str) -> Option<u8> {
        if self.decimal { text.parse().ok().filter(|_| is_digits(text)) } else { hex_byte(2..=2)(text) }
    }
}

impl ReadLine for Busmaster {
    fn read(&mut self, line: &str) -> Read<Line> {
        let line = line.trim();
        if line.is_empty() {
            return Ok(Line::Blank);
        }
        if let Some(text) = line.strip_prefix("***") {
            self.read_head(text.trim_end_matches('*'));
            return Ok(Line::Blank);
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        let [time, "Rx" | "Tx", channel, id, kind, length, data @ ..] = &words[..] else {
            return Ok(Line::Foreign(None));
        };
        let nanos = time_of_day(time, ':')?;
        let (extended, remote) = match *kind {
            "s" => (false, false),
            "x" => (true, false),
            "sr" => (false, true),
            "xr" => (true, true),
            other => return Err(Problem::of(other, format!("{} is not s, x, sr or xr", quoted(other)))),
        };
        let id = identifier(id, self.number(id), extended)?;
        let length = count(length)?;
        let frame = if remote {
            Frame::new_remote(id, u8::try_from(length).map_err(|_| "a length code above 15")?)
        } else {
            let data = data.get(..length).ok_or_else(|| format!("fewer than {length} data bytes"))?;
            data_frame(id, &payload(data.iter().copied(), |word| self.byte(word))?)?
        };
        Ok(Event::at(nanos, self.times, channel, What::Frame(frame)))
    }
}
