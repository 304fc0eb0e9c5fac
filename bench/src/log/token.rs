//! Tokens that the formats share, each held to its form: digits only, no sign, no other width than stated.

use crate::can::{Frame, Id};
use std::ops::RangeInclusive;

/// Longest piece of a file that a message repeats, in characters.
const QUOTED_MAX: usize = 60;
/// Most data bytes of a classic frame; a length code of 9 to 15 means as many (ISO 11898-1).
const DATA_MAX: usize = 8;
/// What is said of a frame with more data or another form than classic CAN.
pub(super) const CAN_FD: &str = "a CAN FD frame; only classic CAN is known here";

/// What the form of a time says about what it counts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Evidence {
    /// From a fixed moment: the format says so.
    Absolute,
    /// From the line before: the file says so.
    Delta,
    /// Very likely from a fixed moment: candump writes gaps in another form.
    Likely,
    /// Nothing: the tool writes both alike.
    Nothing,
}

/// A time as the recorder wrote it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    /// Nanoseconds since an epoch of the recorder's own; SavvyCAN writes some below zero.
    pub(super) nanos: i64,
    /// What its form says about what it counts from.
    pub(super) evidence: Evidence,
}

/// Returns a piece of a file for a message: cut to a readable length, nothing in it that a terminal would obey.
pub(super) fn quoted(text: &str) -> String {
    let mut shown: String = text.chars().take(QUOTED_MAX).collect();
    if shown.len() < text.len() {
        shown.push_str("...");
    }
    format!("`{}`", printable(&shown))
}

/// Returns text with every control character and every mark that turns the direction of writing as an escape.
pub(super) fn printable(text: &str) -> String {
    let obeyed = |sign: char| {
        sign.is_control()
            || matches!(sign, '\u{200E}' | '\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}')
    };
    let mut shown = String::with_capacity(text.len());
    for sign in text.chars() {
        if obeyed(sign) { shown.extend(sign.escape_default()) } else { shown.push(sign) }
    }
    shown
}

/// Returns whether text is one digit or more and nothing else.
pub(super) fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Reads a number of so many hexadecimal digits.
pub(super) fn hex(text: &str, digits: RangeInclusive<usize>) -> Option<u32> {
    let is_hex = text.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_hex && digits.contains(&text.len()) { u32::from_str_radix(text, 16).ok() } else { None }
}

/// Reads decimal seconds exactly: digits, a point, up to nine digits.
pub(super) fn seconds(text: &str) -> Result<i64, String> {
    let wrong = || format!("{} is not a time in seconds", quoted(text));
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    if !is_digits(whole) || !(fraction.is_empty() || is_digits(fraction)) || fraction.len() > 9 {
        return Err(wrong());
    }
    let nanos: i64 = format!("{fraction:0<9}").parse().map_err(|_| wrong())?;
    let whole = whole.parse::<i64>().ok().and_then(|whole| whole.checked_mul(1_000_000_000));
    whole.and_then(|whole| whole.checked_add(nanos)).ok_or_else(wrong)
}

/// Makes an identifier of a number that was read, or not, from `text`; `extended` says how many bits it has.
pub(super) fn identifier(text: &str, raw: Option<u32>, extended: bool) -> Result<Id, String> {
    let raw = raw.ok_or_else(|| format!("{} is not an identifier", quoted(text)))?;
    let id = if extended { Id::extended(raw) } else { u16::try_from(raw).ok().and_then(Id::standard) };
    id.ok_or_else(|| {
        format!("identifier {} has more than {} bits", quoted(text), if extended { 29 } else { 11 })
    })
}

/// Reads the data bytes of `words`, all of them, with `byte`.
pub(super) fn payload<'a>(
    words: impl IntoIterator<Item = &'a str>,
    byte: impl Fn(&str) -> Option<u8>,
) -> Result<Vec<u8>, String> {
    let read = |word: &str| byte(word).ok_or_else(|| format!("{} is not a data byte", quoted(word)));
    words.into_iter().map(read).collect()
}

/// Reads one byte of so many hexadecimal digits.
pub(super) fn hex_byte(digits: RangeInclusive<usize>) -> impl Fn(&str) -> Option<u8> {
    move |word| hex(word, digits.clone()).and_then(|value| u8::try_from(value).ok())
}

/// Returns how many data bytes a length code stands for.
pub(super) fn data_length(code: u8) -> usize {
    usize::from(code).min(DATA_MAX)
}

/// Makes a data frame of at most eight bytes.
pub(super) fn data_frame(id: Id, data: &[u8]) -> Result<Frame, String> {
    Frame::new(id, data)
        .ok_or_else(|| format!("{} data bytes; a classic CAN frame has at most {DATA_MAX}", data.len()))
}

/// Makes a data frame whose length code is written out: of 9 to 15 it has eight bytes.
pub(super) fn coded_frame(id: Id, code: u8, data: &[u8]) -> Result<Frame, String> {
    if data.len() != data_length(code) {
        return Err(format!("{} data bytes where the length says {}", data.len(), data_length(code)));
    }
    Ok(Frame { dlc: code, ..data_frame(id, data)? })
}
