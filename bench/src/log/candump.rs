//! can-utils' candump: `candump -l` files and what candump prints on the screen.

use super::{Line, data_frame, identifier, payload, seconds};
use crate::can::Frame;
use crate::time::Nanos;

/// Bit 29 of a SocketCAN identifier marks an error frame.
const ERROR_FLAG: u32 = 0x2000_0000;

/// `(1436509052.249713) can0 18FEF100#0102030405060708`
pub(super) fn looks_logged(line: &str) -> bool {
    line.starts_with('(') && line.contains('#')
}

/// `(1436509052.249713)  can0  18FEF100   [8]  01 02 03 04 05 06 07 08`, the time being optional.
pub(super) fn looks_shown(line: &str) -> bool {
    line.contains('[') && line.contains(']')
}

pub(super) fn read_logged(line: &str) -> Result<Line, String> {
    if line.is_empty() || line.starts_with('#') {
        return Ok(Line::Nothing);
    }
    let words: Vec<&str> = line.split_whitespace().collect();
    // candump -l adds a third word only for the direction (R or T).
    let ([time, _, text] | [time, _, text, "R" | "T"]) = words[..] else {
        return Err("expected `(seconds) interface id#data`".into());
    };
    let at = time.strip_prefix('(').and_then(|time| time.strip_suffix(')'));
    let at = seconds(at.ok_or_else(|| format!("`{time}` is not a time in brackets"))?)?;
    let (id, data) =
        text.split_once('#').ok_or_else(|| format!("`{text}` has no `#` between id and data"))?;
    if data.starts_with('#') {
        return Err("a CAN FD frame; only classic CAN is known here".into());
    }
    let extended = match id.len() {
        3 => false,
        8 => true,
        n => return Err(format!("identifier `{id}` has {n} digits; 3 for 11 bits, 8 for 29 bits")),
    };
    if extended && u32::from_str_radix(id, 16).is_ok_and(|raw| raw & ERROR_FLAG != 0) {
        return Ok(Line::BusError);
    }
    let id = identifier(id, extended)?;
    if let Some(length) = data.strip_prefix('R') {
        let length = if length.is_empty() { Ok(0) } else { u8::from_str_radix(length, 16) };
        let length = length.map_err(|_| format!("`{data}` is not a remote request"))?;
        return Ok(Line::Frame(at, Frame::new_remote(id, length)));
    }
    if data.len() % 2 != 0 || !data.is_ascii() {
        return Err(format!("`{data}` is not pairs of hexadecimal digits"));
    }
    let pairs = (0..data.len()).step_by(2).map(|at| &data[at..at + 2]);
    Ok(Line::Frame(at, data_frame(id, &payload(pairs)?)?))
}

pub(super) fn read_shown(line: &str) -> Result<Line, String> {
    if line.is_empty() || line.starts_with('#') {
        return Ok(Line::Nothing);
    }
    let (at, rest) = match line.strip_prefix('(') {
        Some(rest) => {
            let (time, rest) = rest.split_once(')').ok_or("the time has no closing bracket")?;
            // `candump -td` prints differences, which cannot be told apart; `-ta` and `-tz` are absolute.
            (seconds(time.trim())?, rest)
        }
        None => (Nanos::ZERO, line),
    };
    // `-x` adds the direction between interface and identifier, `-a` an ASCII view in quotes at the end.
    let rest = rest.split('\'').next().unwrap_or(rest);
    let (head, tail) = rest.split_once('[').ok_or("expected `interface id [length] data`")?;
    let id = head.split_whitespace().last().ok_or("no identifier before `[`")?;
    let (length, data) = tail.split_once(']').ok_or("the length has no closing bracket")?;
    let length: usize = length.trim().parse().map_err(|_| format!("`[{length}]` is not a length"))?;
    let extended = id.len() > 3;
    if extended && u32::from_str_radix(id, 16).is_ok_and(|raw| raw & ERROR_FLAG != 0) {
        return Ok(Line::BusError);
    }
    let id = identifier(id, extended)?;
    if data.contains("remote request") {
        return Ok(Line::Frame(at, Frame::new_remote(id, length as u8)));
    }
    let bytes = payload(data.split_whitespace())?;
    if bytes.len() != length {
        return Err(format!("{} data bytes after `[{length}]`", bytes.len()));
    }
    Ok(Line::Frame(at, data_frame(id, &bytes)?))
}
