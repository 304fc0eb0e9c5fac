//! GVRET CSV as SavvyCAN saves it: `Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8`.
//!
//! The head names the columns: the direction is missing in older files, and some write the length as `DLC`. Time stamps
//! are microseconds, in some files of SavvyCAN's below zero. Source: SavvyCAN's loader and files of its users.

use super::line::{Event, Line, ReadLine, What};
use super::token::{
    Evidence, Problem, Read, count, data_frame, hex, hex_byte, identifier, is_digits, payload, quoted,
};

pub(super) fn looks_like(line: &str) -> bool {
    let line = line.to_ascii_lowercase();
    line.starts_with("time stamp,id,extended")
}

/// Where the head says that each value stands.
#[derive(Debug, Default)]
pub(super) struct Gvret {
    columns: Option<Columns>,
}

#[derive(Clone, Copy, Debug)]
struct Columns {
    time: usize,
    id: usize,
    extended: usize,
    bus: usize,
    length: usize,
    data: usize,
}

impl Columns {
    fn of(head: &str) -> Read<Self> {
        let names: Vec<String> = head.split(',').map(|name| name.trim().to_ascii_lowercase()).collect();
        let find = |wanted: &[&str]| {
            let found = names.iter().position(|name| wanted.contains(&name.as_str()));
            found.ok_or_else(|| format!("no column {} in the head", wanted.join(" or ")))
        };
        Ok(Self {
            time: find(&["time stamp"])?,
            id: find(&["id"])?,
            extended: find(&["extended"])?,
            bus: find(&["bus"])?,
            length: find(&["len", "dlc"])?,
            data: find(&["d1"])?,
        })
    }
}

impl ReadLine for Gvret {
    fn read(&mut self, line: &str) -> Read<Line> {
        let line = line.trim();
        if line.is_empty() {
            return Ok(Line::Blank);
        }
        if looks_like(line) {
            self.columns = Some(Columns::of(line)?);
            return Ok(Line::Blank);
        }
        let (Some(columns), true) = (self.columns, line.contains(',')) else {
            return Ok(Line::Foreign(None));
        };
        let words: Vec<&str> = line.split(',').map(str::trim).collect();
        let word = |column: usize| {
            let word = words.get(column).copied();
            word.ok_or_else(|| Problem::from(format!("column {} is missing", column + 1)))
        };
        let nanos = micros(word(columns.time)?)?;
        let extended = is_true(word(columns.extended)?)?;
        let text = word(columns.id)?;
        let id = identifier(text, hex(text, 1..=8), extended).map_err(|mut problem| {
            if text.contains("E+") {
                problem.text += ": a spreadsheet has rewritten it";
            }
            problem
        })?;
        let bus = word(columns.bus)?;
        if !is_digits(bus) {
            return Err(Problem::of(bus, format!("{} in column Bus; a number", quoted(bus))));
        }
        let length = count(word(columns.length)?)?;
        if length > 8 {
            return Ok(Event::at(nanos, Evidence::Absolute, bus, What::FdFrame));
        }
        let data = words.get(columns.data..columns.data + length);
        let data = data.ok_or_else(|| format!("fewer than {length} data bytes"))?;
        let data = payload(data.iter().copied(), hex_byte(1..=2))?;
        Ok(Event::at(nanos, Evidence::Absolute, bus, What::Frame(data_frame(id, &data)?)))
    }
}

fn is_true(text: &str) -> Read<bool> {
    match text.to_ascii_lowercase().as_str() {
        "true" | "1" => Ok(true),
        "false" | "0" => Ok(false),
        _ => Err(Problem::of(text, format!("{} in column Extended; true or false", quoted(text)))),
    }
}

/// Reads whole microseconds, below zero too, as nanoseconds.
fn micros(text: &str) -> Read<i64> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let micros: Option<i64> = if is_digits(digits) { text.parse().ok() } else { None };
    micros
        .and_then(|micros| micros.checked_mul(1_000))
        .ok_or_else(|| Problem::of(text, format!("{} is not a time in microseconds", quoted(text))))
}
