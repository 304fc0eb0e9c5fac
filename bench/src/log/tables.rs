//! Tables that programs of adapters save: one row per frame, columns between tabs or blanks.
//!
//! Source: files of their users; none of the formats is described in public. What a column may hold besides what was seen
//! in files is an error, not a guess.

use super::line::{Event, Line, What, counted};
use super::token::{
    Evidence, Problem, Read, hex, hex_byte, identifier, identifier_by_size, is_digits, millis, quoted,
    seconds, time_of_day,
};
use crate::can::Frame;

/// `ParserFlags<tab>Ch<tab>Counter<tab>T/R<tab>Time<tab>Flags<tab>CAN ID<tab>Len<tab>Data`: milliseconds.
pub(super) fn looks_like_parser_flags(line: &str) -> bool {
    line.starts_with("ParserFlags\t")
}

pub(super) fn read_parser_flags(line: &str) -> Read<Line> {
    if line.is_empty() || looks_like_parser_flags(line) {
        return Ok(Line::Blank);
    }
    let cells: Vec<&str> = line.split('\t').collect();
    let [_, channel, _, "RX" | "TX", time, flags, id, length, data, ..] = cells[..] else {
        return Ok(Line::Foreign(None));
    };
    if !flags.trim().is_empty() {
        return Err(Problem::of(flags, format!("{} in column Flags is not known", quoted(flags))));
    }
    let digits = id.strip_prefix("0x").unwrap_or(id);
    let words: Vec<&str> = data.trim().strip_prefix("0x").unwrap_or(data).split_whitespace().collect();
    let what = counted(identifier_by_size(digits)?, length, &words, 2..=2)?;
    Ok(Event::at(millis(time)?, Evidence::Absolute, channel, what))
}

/// `NO    Direction  Time Scale        Frame Type      Frame Format        Frame ID    Length          Data`: the program
/// of many USB-CAN adapters, which puts zero bytes between the columns.
pub(super) fn looks_like_usb_can(line: &str) -> bool {
    line.split_whitespace().take(4).eq(["NO", "Direction", "Time", "Scale"])
}

pub(super) fn read_usb_can(line: &str) -> Read<Line> {
    let words: Vec<&str> = line
        .split(|sign: char| sign.is_whitespace() || sign == '\0')
        .filter(|word| !word.is_empty())
        .collect();
    let ["Receive" | "Send" | "Transmit", time, kind, "frame", format, "frame", id, length, data @ ..] =
        words.get(1..).unwrap_or(&[])
    else {
        let is_head = line.is_empty() || looks_like_usb_can(line);
        return Ok(if is_head { Line::Blank } else { Line::Foreign(None) });
    };
    let extended = match *format {
        "Standard" => false,
        "Extended" => true,
        other => return Err(Problem::of(other, format!("{} is not Standard or Extended", quoted(other)))),
    };
    let id = identifier(id, hex(id, 1..=8), extended)?;
    let what = match *kind {
        "Data" => counted(id, length, data, 2..=2)?,
        "Remote" => What::Frame(Frame::new_remote(id, hex_byte(1..=1)(length).ok_or("no length code")?)),
        other => return Err(Problem::of(other, format!("{} is not Data or Remote", quoted(other)))),
    };
    Ok(Event::at(time_of_day(time, ':')?, Evidence::Midnight, "", what))
}

/// `@ TEXT @ 3 @ 64 @ 0 @ 930 @ 1500 @ 00:00:01.500 @`: CarBus Analyzer, whose lines end with CR.
pub(super) fn looks_like_carbus(line: &str) -> bool {
    line.starts_with("@ TEXT @")
}

/// `55,038000<tab>2<tab>00000004<tab>1FF<tab>8<tab>01 00 00 00 00 00 00 00<tab>...`
pub(super) fn read_carbus(line: &str) -> Read<Line> {
    if line.is_empty() || line.starts_with(['@', '#']) {
        return Ok(Line::Blank);
    }
    let cells: Vec<&str> = line.split('\t').collect();
    let [time, channel, flags, id, length, data, ..] = cells[..] else { return Ok(Line::Foreign(None)) };
    if flags != "00000004" {
        return Err(Problem::of(flags, format!("flags {} are not known", quoted(flags))));
    }
    let nanos = seconds(&time.replace(',', ".")).map_err(|problem| Problem::of(time, problem.text))?;
    let id = identifier(id, hex(id, 3..=8), id.len() == 8)?;
    let words: Vec<&str> = data.split_whitespace().collect();
    let what = counted(id, length, &words, 2..=2)?;
    Ok(Event::at(nanos, Evidence::Absolute, channel, what))
}

/// `CAN speed 1: 500k CAN speed 2: 500k ... Id format: HEX | Data format: HEX`
pub(super) fn looks_like_numbered(line: &str) -> bool {
    line.starts_with("CAN speed 1:") && line.contains("Id format: HEX") && line.contains("Data format: HEX")
}

/// `><tab>0<tab>17:18:39.303:4446.00<tab>St<tab>0x197<tab>0<tab>4<tab>64<tab>E0<tab>9E<tab>C0<tab>...<tab>p:1`. What stands
/// behind the milliseconds is no part of the time: it falls within one.
pub(super) fn read_numbered(line: &str) -> Read<Line> {
    let cells: Vec<&str> = line.split('\t').map(str::trim).collect();
    let [_, number, time, kind, id, remote, length, data @ .., port] = &cells[..] else {
        let is_head = looks_like_numbered(line) || cells.iter().all(|cell| cell.is_empty());
        return Ok(if is_head { Line::Blank } else { Line::Foreign(None) });
    };
    let Some(channel) = port.strip_prefix("p:").filter(|_| is_digits(number)) else {
        return Ok(Line::Foreign(None));
    };
    if (*kind, *remote) != ("St", "0") {
        return Err(Problem::of(kind, format!("{} is not a kind of frame that is known", quoted(kind))));
    }
    let clock = time.rsplit_once(':').map_or(*time, |(clock, _)| clock);
    let digits = id.strip_prefix("0x").unwrap_or(id);
    let what = counted(identifier(id, hex(digits, 1..=3), false)?, length, data, 2..=2)?;
    Ok(Event::at(time_of_day(clock, '.')?, Evidence::Midnight, channel, what))
}
