//! Vector ASC: `   1.234567 1  18FEF100x       Rx   d 8 01 02 03 04 05 06 07 08`.
//!
//! Source: the text format as python-can, can-utils' asc2log and loggers of several makers write and read it. The head
//! says whether numbers are hexadecimal and what the times count from. Events of other kinds (statistics, transport
//! protocols, other buses) are no frames.

use super::line::{Event, Line, ReadLine, What};
use super::token::{
    Evidence, Problem, Read, Stamp, coded_frame, data_length, hex, hex_byte, identifier, is_digits, payload,
    quoted, seconds,
};
use crate::can::Frame;

/// First words of lines that carry no event.
const HEADERS: &[&str] =
    &["date", "internal", "no", "begin", "end", "//", "start", "measurement", "previous"];

/// What the head of a file said.
#[derive(Debug, Default)]
pub(super) struct Asc {
    /// Numbers are decimal.
    decimal: bool,
    times: Option<Evidence>,
}

pub(super) fn looks_like(line: &str) -> bool {
    let line = line.trim().to_ascii_lowercase();
    let words: Vec<&str> = line.split_whitespace().collect();
    line.starts_with("date ")
        || line.starts_with("base ")
        || words.first().is_some_and(|time| seconds(time).is_ok()) && Parts::of(&words).is_some()
}

impl ReadLine for Asc {
    fn read(&mut self, line: &str) -> Read<Line> {
        let line = line.trim();
        let lower = line.to_ascii_lowercase();
        let words: Vec<&str> = line.split_whitespace().collect();
        let Some(first) = words.first() else { return Ok(Line::Blank) };
        if lower.starts_with("base ") {
            return self.read_base(&lower).map(|()| Line::Blank);
        }
        if HEADERS.iter().any(|header| lower.starts_with(header)) {
            return Ok(Line::Blank);
        }
        if lower.ends_with("start of measurement") {
            return Ok(Line::Blank);
        }
        let parts = Parts::of(&words);
        let evidence = self.times.unwrap_or(Evidence::Nothing);
        let at = seconds(first).map(|nanos| Stamp { nanos, evidence });
        if parts.is_none() && at.is_err() {
            return Ok(Line::Foreign(None));
        }
        let at = at?;
        if words[1..].iter().any(|word| word.eq_ignore_ascii_case("errorframe")) {
            let channel = words.get(1).map_or_else(String::new, |word| (*word).to_owned());
            return Ok(Line::Event(Event { at: Some(at), channel, what: What::BusError }));
        }
        if words.get(1) == Some(&"CANFD") {
            let channel = words.get(2).map_or_else(String::new, |word| (*word).to_owned());
            return Ok(Line::Event(Event { at: Some(at), channel, what: What::FdFrame }));
        }
        let Some(Parts { channel, id, kind, rest }) = parts else { return Ok(Line::Foreign(Some(at))) };
        let bare = id.strip_suffix(['x', 'X']);
        let id = identifier(id, self.number(bare.unwrap_or(id)), bare.is_some())?;
        let frame = match kind {
            "d" | "D" => self.data_frame(id, rest)?,
            "r" | "R" => Frame::new_remote(id, self.remote_length(rest)?),
            other => {
                let text = format!("{} behind Rx or Tx; d is data, r a remote request", quoted(other));
                return Err(Problem::of(other, text));
            }
        };
        Ok(Line::Event(Event { at: Some(at), channel, what: What::Frame(frame) }))
    }
}

impl Asc {
    /// `base hex timestamps absolute`
    fn read_base(&mut self, lower: &str) -> Read<()> {
        let words: Vec<&str> = lower.split_whitespace().collect();
        self.decimal = match words.get(1) {
            Some(&"hex") => false,
            Some(&"dec") => true,
            _ => return Err("neither `base hex` nor `base dec`".into()),
        };
        self.times = match words[2..] {
            [] => self.times,
            ["timestamps", "absolute", ..] => Some(Evidence::Absolute),
            ["timestamps", "relative", ..] => Some(Evidence::Delta),
            _ => return Err("expected `timestamps absolute` or `timestamps relative` here".into()),
        };
        Ok(())
    }

    /// Reads an identifier in the file's base.
    fn number(&self, text: &str) -> Option<u32> {
        if !self.decimal {
            return hex(text, 1..=8);
        }
        if is_digits(text) { text.parse().ok() } else { None }
    }

    /// Reads a length code.
    fn code(&self, text: &str) -> Option<u8> {
        if !self.decimal {
            return hex_byte(1..=1)(text);
        }
        let code = if is_digits(text) { text.parse().ok() } else { None };
        code.filter(|code| *code <= 15)
    }

    fn data_frame(&self, id: crate::can::Id, rest: &[&str]) -> Read<Frame> {
        let length = rest.first().copied().unwrap_or("");
        let code = self.code(length).ok_or_else(|| not_a_code(length))?;
        let needed = data_length(code);
        let words = rest.get(1..=needed).ok_or_else(|| format!("fewer than {needed} data bytes"))?;
        let byte = |word: &str| {
            if !self.decimal {
                return hex_byte(2..=2)(word);
            }
            if is_digits(word) { word.parse().ok() } else { None }
        };
        coded_frame(id, code, &payload(words.iter().copied(), byte)?)
    }

    /// Reads the length of a remote request, which may be missing before `Length = 1704000 ...`.
    fn remote_length(&self, rest: &[&str]) -> Read<u8> {
        let is_attribute =
            |word: &str| word.contains('=') || rest.get(1).is_some_and(|next| next.starts_with('='));
        match rest.first() {
            None => Ok(0),
            Some(word) if is_attribute(word) => Ok(0),
            Some(word) => self.code(word).ok_or_else(|| not_a_code(word)),
        }
    }
}

fn not_a_code(text: &str) -> Problem {
    Problem::of(text, format!("{} is not a length code of 0 to 15", quoted(text)))
}

/// A line that is meant as a frame, cut at the word `Rx` or `Tx`.
struct Parts<'a> {
    channel: String,
    id: &'a str,
    kind: &'a str,
    rest: &'a [&'a str],
}

impl<'a> Parts<'a> {
    /// `1.234567 1 18FEF100x Rx d ...`; `CAN 1` and `can1` are channels of other tools.
    fn of(words: &'a [&'a str]) -> Option<Self> {
        let at = words.iter().position(|word| matches!(word.to_ascii_lowercase().as_str(), "rx" | "tx"))?;
        let (channel, id) = (words.get(1..at.checked_sub(1)?)?, words[at - 1]);
        let kind = words.get(at + 1).copied().unwrap_or("");
        let names_can = match channel {
            [name] => is_digits(name) || name.get(..3).is_some_and(|head| head.eq_ignore_ascii_case("can")),
            [name, number] => name.eq_ignore_ascii_case("can") && is_digits(number),
            _ => return None,
        };
        let is_frame = names_can || matches!(kind, "d" | "D" | "r" | "R");
        is_frame.then(|| Self {
            channel: channel.join(" "),
            id,
            kind,
            rest: words.get(at + 2..).unwrap_or(&[]),
        })
    }
}
