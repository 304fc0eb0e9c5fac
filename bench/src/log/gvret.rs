//! GVRET CSV as SavvyCAN saves it: `Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8`.
//!
//! Time stamps are microseconds, in some files of SavvyCAN's below zero. The direction column is missing in older files,
//! and some write the length as `DLC`.

use super::line::{Event, Line};
use super::token::{Evidence, Stamp, data_frame, hex, hex_byte, identifier, is_digits, payload, quoted};

pub(super) fn looks_like(line: &str) -> bool {
    line.trim().to_ascii_lowercase().starts_with("time stamp,id,extended")
}

pub(super) fn read(line: &str) -> Result<Line, String> {
    if line.is_empty() || looks_like(line) {
        return Ok(Line::Blank);
    }
    if !line.contains(',') {
        return Ok(Line::Foreign(None));
    }
    let mut words: Vec<&str> = line.split(',').map(str::trim).collect();
    if words.get(3).is_some_and(|word| matches!(*word, "Rx" | "Tx")) {
        words.remove(3);
    }
    let [time, id, extended, bus, length, data @ ..] = &words[..] else {
        return Err("expected `time,id,extended,direction,bus,length,bytes`".into());
    };
    let at = Stamp { nanos: micros(time)?, evidence: Evidence::Absolute };
    let extended = match extended.to_ascii_lowercase().as_str() {
        "true" | "1" => true,
        "false" | "0" => false,
        other => return Err(format!("{} in column Extended; true or false", quoted(other))),
    };
    let is_rounded = id.contains("E+");
    let id = identifier(id, hex(id, 1..=8), extended).map_err(|problem| {
        if is_rounded { format!("{problem}: a spreadsheet has rewritten it") } else { problem }
    })?;
    if !is_digits(bus) {
        return Err(format!("{} in column Bus; a number", quoted(bus)));
    }
    let count: usize = if is_digits(length) { length.parse().ok() } else { None }
        .ok_or_else(|| format!("{} is not a length", quoted(length)))?;
    let data = data.get(..count).ok_or_else(|| format!("fewer than {count} data bytes"))?;
    let data = payload(data.iter().copied(), hex_byte(1..=2))?;
    let frame = Some(data_frame(id, &data)?);
    Ok(Line::Event(Event { at: Some(at), channel: (*bus).to_owned(), frame }))
}

/// Reads whole microseconds, below zero too, as nanoseconds.
fn micros(text: &str) -> Result<i64, String> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let micros: Option<i64> = if is_digits(digits) { text.parse().ok() } else { None };
    micros
        .and_then(|micros| micros.checked_mul(1_000))
        .ok_or_else(|| format!("{} is not a time in microseconds", quoted(text)))
}
