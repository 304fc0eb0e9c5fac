//! Vector ASC: `   1.234567 1  18FEF100x       Rx   d 8 01 02 03 04 05 06 07 08`.
//!
//! Source: the text format as python-can writes and reads it; `base hex` and absolute time stamps only.

use super::{Line, data_frame, identifier, payload, seconds};
use crate::can::Frame;

/// First words of lines that carry no event.
const HEADERS: &[&str] = &["date", "base", "internal", "no", "begin", "end", "//", "start", "measurement"];

pub(super) fn looks_like(line: &str) -> bool {
    line.starts_with("date ") || line.starts_with("base ")
}

pub(super) fn read(line: &str) -> Result<Line, String> {
    let lower = line.to_ascii_lowercase();
    let words: Vec<&str> = line.split_whitespace().collect();
    if let Some(base) = lower.strip_prefix("base ") {
        return match base.split_whitespace().next() {
            Some("hex") => Ok(Line::Nothing),
            _ => Err("only `base hex` is known here".into()),
        };
    }
    if lower.starts_with("base") || words.is_empty() || HEADERS.iter().any(|header| lower.starts_with(header))
    {
        return Ok(Line::Nothing);
    }
    let at = seconds(words[0])?;
    if lower.contains("errorframe") {
        return Ok(Line::BusError);
    }
    if words.get(1) == Some(&"CANFD") {
        return Err("a CAN FD frame; only classic CAN is known here".into());
    }
    // Statistics, triggers and the like: an event of a channel that is not a frame.
    let [_, channel, id, _direction, kind, rest @ ..] = &words[..] else { return Ok(Line::Nothing) };
    if channel.parse::<u8>().is_err() || !matches!(*kind, "d" | "r") {
        return Ok(Line::Nothing);
    }
    let bare = id.strip_suffix(['x', 'X']);
    let id = identifier(bare.unwrap_or(id), bare.is_some())?;
    let length = match rest.first() {
        Some(word) => usize::from_str_radix(word, 16).map_err(|_| format!("`{word}` is not a length"))?,
        None => 0,
    };
    if *kind == "r" {
        return Ok(Line::Frame(at, Frame::new_remote(id, length as u8)));
    }
    let data = rest.get(1..1 + length).ok_or_else(|| format!("fewer than {length} data bytes"))?;
    Ok(Line::Frame(at, data_frame(id, &payload(data.iter().copied())?)?))
}
