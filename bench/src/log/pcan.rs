//! PEAK's trace files (`.trc`): versions 1.0, 1.1, 1.2, 1.3, 2.0 and 2.1.
//!
//! The head says the version; a file without says 1.0 by that. From 2.0 on it also names the columns, by letters. Times
//! are milliseconds since the start of the trace. Source: PEAK's description of the format, python-can's reader.

use super::line::{Event, Line, ReadLine, What};
use super::token::{
    Evidence, Problem, Read, count, data_frame, hex, hex_byte, identifier, is_digits, millis, payload, quoted,
};
use crate::can::Frame;

/// Columns of the versions that do not name them, and of 2.0 and 2.1 as they name them: `N` number, `O` time, `B` bus,
/// `T` type, `I` identifier, `d` direction, `R` reserved, `l` bytes, `L` length code, `D` data.
const COLUMNS: &[(&str, &str)] = &[
    ("1.0", "NOILD"),
    ("1.1", "NOTILD"),
    ("1.2", "NOBTILD"),
    ("1.3", "NOBTIRLD"),
    ("2.0", "NOTIdLD"),
    ("2.1", "NOTBIdRLD"),
];

/// What a type of line is; what is not in the table is no matter of frames.
const TYPES: &[(&str, Kind)] = &[
    ("Rx", Kind::Data),
    ("Tx", Kind::Data),
    ("Warng", Kind::BusError),
    ("Error", Kind::BusError),
    ("DT", Kind::Data),
    ("RR", Kind::Remote),
    ("FD", Kind::Fd),
    ("FB", Kind::Fd),
    ("FE", Kind::Fd),
    ("BI", Kind::Fd),
    ("ER", Kind::BusError),
    ("ST", Kind::Other),
    ("EC", Kind::Other),
    ("EV", Kind::Other),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Data,
    Remote,
    Fd,
    BusError,
    Other,
}

/// What the head said.
#[derive(Debug)]
pub(super) struct Pcan {
    columns: String,
}

impl Default for Pcan {
    fn default() -> Self {
        Self { columns: COLUMNS[0].1.to_owned() }
    }
}

pub(super) fn looks_like(line: &str) -> bool {
    line.starts_with(";$FILEVERSION")
        || line.starts_with(';') && line[1..].trim_start().starts_with("Message Number")
}

impl Pcan {
    fn read_head(&mut self, text: &str) -> Read<()> {
        if let Some(version) = text.strip_prefix("$FILEVERSION=") {
            let known = COLUMNS.iter().find(|(known, _)| *known == version.trim());
            let (_, columns) = known.ok_or_else(|| {
                Problem::of(
                    version,
                    format!("{} is not a version that is known (1.0 to 2.1)", quoted(version)),
                )
            })?;
            self.columns = (*columns).to_owned();
        } else if let Some(columns) = text.strip_prefix("$COLUMNS=") {
            self.columns = columns.chars().filter(char::is_ascii_alphabetic).collect();
        }
        Ok(())
    }
}

impl ReadLine for Pcan {
    fn read(&mut self, line: &str) -> Read<Line> {
        let line = line.trim();
        if let Some(text) = line.strip_prefix(';') {
            return self.read_head(text).map(|()| Line::Blank);
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        let Some(number) = words.first() else { return Ok(Line::Blank) };
        if !is_digits(number.trim_end_matches(')')) {
            return Ok(Line::Foreign(None));
        }
        let word = |letter: char| {
            let column = self.columns.find(letter)?;
            words.get(column).copied()
        };
        let needed = |letter: char| {
            word(letter).ok_or_else(|| Problem::from(format!("the line ends before column {letter}")))
        };
        let nanos = millis(needed('O')?)?;
        let event = |what| Ok(Event::at(nanos, Evidence::Absolute, word('B').unwrap_or(""), what));
        let kind = match word('T') {
            None => Kind::Data,
            Some(text) => match TYPES.iter().find(|(known, _)| *known == text) {
                Some((_, kind)) => *kind,
                None => return Err(Problem::of(text, format!("{} is not a type of line", quoted(text)))),
            },
        };
        let text = match kind {
            Kind::Other => return Ok(Line::Blank),
            Kind::BusError => return event(What::BusError),
            Kind::Fd => return event(What::FdFrame),
            Kind::Data | Kind::Remote => needed('I')?,
        };
        // Version 1.0 has no types: an error has an identifier that no frame can have.
        if text == "FFFFFFFF" {
            return event(What::BusError);
        }
        let extended = match text.len() {
            4 => false,
            // PEAK writes eight, python-can seven and more.
            5..=8 => true,
            n => {
                let problem =
                    format!("identifier {} has {n} digits; 4 for 11 bits, 5 to 8 for 29 bits", quoted(text));
                return Err(Problem::of(text, problem));
            }
        };
        let id = identifier(text, hex(text, 4..=8), extended)?;
        let length = if self.columns.contains('l') { 'l' } else { 'L' };
        let code = u8::try_from(count(needed(length)?)?).ok().filter(|code| *code <= 15);
        let code = code.ok_or("a length code above 15")?;
        let data = self.columns.find('D').and_then(|column| words.get(column..)).unwrap_or(&[]);
        if kind == Kind::Remote || data.first() == Some(&"RTR") {
            return event(What::Frame(Frame::new_remote(id, code)));
        }
        let needed = usize::from(code.min(8));
        let data = data.get(..needed).ok_or_else(|| format!("fewer than {needed} data bytes"))?;
        let frame = data_frame(id, &payload(data.iter().copied(), hex_byte(2..=2))?)?;
        event(What::Frame(Frame { dlc: code, ..frame }))
    }
}
