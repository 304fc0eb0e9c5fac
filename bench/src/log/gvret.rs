//! GVRET CSV as SavvyCAN saves it: `Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8`.
//!
//! Time stamps are microseconds. The direction column is missing in older files.

use super::{Line, data_frame, identifier, payload};
use crate::time::Nanos;

pub(super) fn looks_like(line: &str) -> bool {
    line.to_ascii_lowercase().starts_with("time stamp,id,extended")
}

pub(super) fn read(line: &str) -> Result<Line, String> {
    if line.is_empty() || looks_like(line) {
        return Ok(Line::Nothing);
    }
    let mut words: Vec<&str> = line.split(',').map(str::trim).collect();
    if words.get(3).is_some_and(|word| matches!(*word, "Rx" | "Tx")) {
        words.remove(3);
    }
    let [time, id, extended, _bus, length, data @ ..] = &words[..] else {
        return Err("expected `time,id,extended,direction,bus,length,bytes`".into());
    };
    let micros: u64 = time.parse().map_err(|_| format!("`{time}` is not a time in microseconds"))?;
    let at = micros.checked_mul(1_000).map(Nanos).ok_or_else(|| format!("`{time}` is too large a time"))?;
    let extended = match extended.to_ascii_lowercase().as_str() {
        "true" | "1" => true,
        "false" | "0" => false,
        other => return Err(format!("`{other}` in column Extended; true or false")),
    };
    let length: usize = length.parse().map_err(|_| format!("`{length}` is not a length"))?;
    let data = data.get(..length).ok_or_else(|| format!("fewer than {length} data bytes"))?;
    Ok(Line::Frame(at, data_frame(identifier(id, extended)?, &payload(data.iter().copied())?)?))
}
