//! What small programs print on a serial terminal: Battery-Emulator, and loggers that print milliseconds.
//!
//! A terminal's own lines and messages stand between the frames. Neither says how many bits an identifier has: those that
//! need 29 have 29. Source: Battery-Emulator's `print_can_frame`, logs of its users.

use super::line::{Event, Line, counted};
use super::token::{
    Evidence, Problem, Read, count, hex, identifier_by_size, is_digits, millis, quoted, seconds,
};

/// `(683.70) RX0 7E0 [8] D0 00 00 0A 50 FF 80 01`: the direction where candump has the interface.
pub(super) fn looks_like_battery_emulator(line: &str) -> bool {
    battery_emulator(line).is_some()
}

pub(super) fn read_battery_emulator(line: &str) -> Read<Line> {
    let Some([time, bus, rest]) = battery_emulator(line) else {
        return Ok(if line.is_empty() { Line::Blank } else { Line::Foreign(None) });
    };
    let nanos = seconds(time)?;
    let words: Vec<&str> = rest.split_whitespace().collect();
    let [id, length, data @ ..] = &words[..] else { return Err("expected `id [length] data`".into()) };
    let bare = length.strip_prefix('[').and_then(|length| length.strip_suffix(']'));
    let length = bare.ok_or_else(|| Problem::of(length, format!("{} is not `[length]`", quoted(length))))?;
    let id = identifier_by_size(id)?;
    if count(length)? != data.len() {
        return Err(format!("{} data bytes where the length says {length}", data.len()).into());
    }
    // It does not mark frames of CAN FD; those of up to eight bytes look like classic ones.
    let what = counted(id, length, data, 2..=2)?;
    Ok(Event::at(nanos, Evidence::Absolute, bus, what))
}

/// Cuts a line into time, bus and what follows. It numbers the buses by twos: RX0 and TX1 are one bus.
fn battery_emulator(line: &str) -> Option<[&str; 3]> {
    let (time, rest) = line.strip_prefix('(')?.split_once(") ")?;
    let (port, rest) = rest.split_once(' ')?;
    let number = port.strip_prefix("RX").or_else(|| port.strip_prefix("TX"))?;
    let bus = match number {
        "0" | "1" => "0",
        "2" | "3" => "1",
        "4" | "5" => "2",
        "6" | "7" => "3",
        _ => return None,
    };
    Some([time, bus, rest])
}

/// `176487  51E  8  0 0 0 0 C 0 0 0`: milliseconds, identifier, length, bytes.
pub(super) fn looks_like_millis(line: &str) -> bool {
    let words: Vec<&str> = line.split_whitespace().collect();
    let [time, id, length, data @ ..] = &words[..] else { return false };
    let is_byte = |word: &&str| hex(word, 1..=2).is_some();
    is_digits(time)
        && time.len() > 1
        && hex(id, 3..=8).is_some()
        && count(length).is_ok_and(|length| length <= 8 && length == data.len())
        && data.iter().all(is_byte)
}

pub(super) fn read_millis(line: &str) -> Read<Line> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let [time, id, length, data @ ..] = &words[..] else {
        return Ok(if line.is_empty() { Line::Blank } else { Line::Foreign(None) });
    };
    if !is_digits(time) || hex(id, 1..=8).is_none() || count(length).is_err() {
        return Ok(Line::Foreign(None));
    }
    let what = counted(identifier_by_size(id)?, length, data, 1..=2)?;
    Ok(Event::at(millis(time)?, Evidence::Absolute, "", what))
}
