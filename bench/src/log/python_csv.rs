//! python-can's CSV: `timestamp,arbitration_id,extended,remote,error,dlc,data`, the data in base64.
//!
//! Source: the CSV reader and writer of python-can. It writes no channel.

use super::line::{Event, Line, What};
use super::token::{Evidence, Problem, Read, coded_frame, count, hex, identifier, quoted, seconds};
use crate::can::Frame;

/// The first line of such a file.
pub(super) const HEAD: &str = "timestamp,arbitration_id,extended,remote,error,dlc,data";
/// The digits of base64 in the order of their values (RFC 4648, table 1).
const BASE64: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

pub(super) fn looks_like(line: &str) -> bool {
    line.starts_with("timestamp,arbitration_id,")
}

pub(super) fn read(line: &str) -> Read<Line> {
    if line.is_empty() || line == HEAD {
        return Ok(Line::Blank);
    }
    let words: Vec<&str> = line.split(',').collect();
    let [time, id, extended, remote, error, length, data] = words[..] else {
        return if words.len() == 1 {
            Ok(Line::Foreign(None))
        } else {
            Err(format!("expected `{HEAD}`").into())
        };
    };
    // The writer prints a float, which may have more digits than a nanosecond.
    let whole = time.len().min(time.find('.').map_or(time.len(), |point| point + 10));
    let nanos = seconds(&time[..whole]).map_err(|problem| Problem::of(time, problem.text))?;
    let event = |what| Ok(Event::at(nanos, Evidence::Absolute, "", what));
    if flag(error)? {
        return event(What::BusError);
    }
    let digits = id.strip_prefix("0x").unwrap_or("");
    let id = identifier(id, hex(digits, 1..=8), flag(extended)?)?;
    let length = count(length)?;
    if flag(remote)? {
        let code = u8::try_from(length).ok().filter(|code| *code <= 15);
        return event(What::Frame(Frame::new_remote(id, code.ok_or("a length code above 15")?)));
    }
    let bytes = decoded(data).ok_or_else(|| Problem::of(data, format!("{} is not base64", quoted(data))))?;
    if bytes.len() > 8 {
        return event(What::FdFrame);
    }
    let code = u8::try_from(length).ok().filter(|code| *code <= 15).ok_or("a length code above 15")?;
    event(What::Frame(coded_frame(id, code, &bytes)?))
}

fn flag(text: &str) -> Read<bool> {
    match text {
        "0" => Ok(false),
        "1" => Ok(true),
        _ => Err(Problem::of(text, format!("{} is neither 0 nor 1", quoted(text)))),
    }
}

/// Returns bytes as base64 with its padding.
pub(super) fn encoded(bytes: &[u8]) -> String {
    let mut text = String::new();
    for three in bytes.chunks(3) {
        let byte = |at: usize| u32::from(three.get(at).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let value = bits >> (18 - 6 * digit) & 0x3F;
            text.push(if digit > three.len() { '=' } else { char::from(BASE64[value as usize]) });
        }
    }
    text
}

/// Returns the bytes of a base64 text with its padding.
fn decoded(text: &str) -> Option<Vec<u8>> {
    let digits = text.trim_end_matches('=');
    if !text.len().is_multiple_of(4) || text.len() - digits.len() > 2 {
        return None;
    }
    let (mut bytes, mut bits, mut held) = (Vec::new(), 0_u32, 0);
    for digit in digits.bytes() {
        let value = BASE64.iter().position(|known| *known == digit)?;
        bits = bits << 6 | u32::try_from(value).ok()?;
        held += 6;
        if held >= 8 {
            held -= 8;
            bytes.push((bits >> held & 0xFF) as u8);
        }
    }
    Some(bytes)
}
