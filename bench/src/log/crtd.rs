//! OVMS's logs (CRTD): `1632426782.045940 1R11 679 00`.
//!
//! The second word is the number of the bus, which may be missing, and the kind of the record: R or T and the bits of
//! the identifier, or C and something that is no frame. Source: the OVMS documentation of the format.

use super::line::{Event, Line, What};
use super::token::{Evidence, Read, data_frame, hex, hex_byte, identifier, payload, seconds};

/// Records of an OVMS that are no frames: comments, events, versions, statistics.
const OTHER_RECORDS: &[&str] = &["CXX", "CEV", "CVR", "CST", "CMT", "CBC", "CDP", "CCM"];

pub(super) fn looks_like(line: &str) -> bool {
    let words: Vec<&str> = line.split_whitespace().take(2).collect();
    let [time, record] = words[..] else { return false };
    let (_, kind) = parts(record);
    let is_frame = matches!(kind, "R11" | "R29" | "T11" | "T29");
    seconds(time).is_ok() && (is_frame || OTHER_RECORDS.contains(&kind))
}

pub(super) fn read(line: &str) -> Read<Line> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let [time, record, rest @ ..] = &words[..] else {
        return Ok(if line.is_empty() { Line::Blank } else { Line::Foreign(None) });
    };
    let (bus, kind) = parts(record);
    let extended = match kind {
        "R11" | "T11" => false,
        "R29" | "T29" => true,
        // An error of the controller: CRTD's only record of one.
        "CER" => return Ok(Event::at(seconds(time)?, Evidence::Absolute, bus, What::BusError)),
        other if OTHER_RECORDS.contains(&other) => return Ok(Line::Blank),
        _ => return Ok(Line::Foreign(None)),
    };
    let nanos = seconds(time)?;
    let [id, data @ ..] = rest else { return Err("no identifier".into()) };
    let id = identifier(id, hex(id, 1..=8), extended)?;
    let frame = data_frame(id, &payload(data.iter().copied(), hex_byte(2..=2))?)?;
    Ok(Event::at(nanos, Evidence::Absolute, bus, What::Frame(frame)))
}

/// Cuts `1R29` into the number of the bus and the kind.
fn parts(record: &str) -> (&str, &str) {
    let digits = record.bytes().take_while(u8::is_ascii_digit).count();
    record.split_at(digits)
}
