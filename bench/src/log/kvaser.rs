//! What Kvaser's CanKing writes: `Chn Identifier Flg   DLC  D0...1...2...3...4...5...6..D7       Time     Dir`.
//!
//! Flags: X = 29 bits, R = remote request. Source: files of its users, SavvyCAN's loader.

use super::line::{Event, Line, What, counted};
use super::token::{Evidence, Problem, Read, count, hex, identifier, is_digits, quoted, seconds};
use crate::can::Frame;

pub(super) fn looks_like(line: &str) -> bool {
    line.split_whitespace().take(4).eq(["Chn", "Identifier", "Flg", "DLC"])
}

pub(super) fn read(line: &str) -> Read<Line> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let [channel, id, rest @ .., time, "R" | "T"] = &words[..] else {
        return Ok(if line.is_empty() || looks_like(line) { Line::Blank } else { Line::Foreign(None) });
    };
    if !is_digits(channel) {
        return Ok(Line::Foreign(None));
    }
    let nanos = seconds(time)?;
    let event = |what| Ok(Event::at(nanos, Evidence::Absolute, channel, what));
    if rest.contains(&"ErrorFrame") {
        return event(What::BusError);
    }
    let flags = rest.iter().take_while(|word| !is_digits(word)).count();
    let (flags, rest) = rest.split_at(flags);
    if let Some(flag) = flags.iter().find(|flag| !flag.chars().all(|flag| matches!(flag, 'X' | 'R'))) {
        return Err(Problem::of(flag, format!("{} is not a flag that is known (X, R)", quoted(flag))));
    }
    let has = |flag: char| flags.iter().any(|flags| flags.contains(flag));
    let id = identifier(id, hex(id, 1..=8), has('X'))?;
    let [length, data @ ..] = rest else { return Err("no length".into()) };
    if has('R') {
        let code = u8::try_from(count(length)?).ok().filter(|code| *code <= 15);
        return event(What::Frame(Frame::new_remote(id, code.ok_or("a length code above 15")?)));
    }
    event(counted(id, length, data, 2..=2)?)
}
