//! What one line of a recording says, in any format.

use super::token::{Evidence, Read, Stamp, coded_frame, count, data_length, hex_byte, payload};
use crate::can::{Frame, Id};
use std::fmt;
use std::ops::RangeInclusive;

/// What one line of a recording says.
#[derive(Debug)]
pub(super) enum Line {
    /// Something that happened on a bus.
    Event(Event),
    /// Nothing about a bus, as the format has such lines: empty, a comment, a header.
    Blank,
    /// Something that is not of this format, or is no matter of CAN; its time, if it has one.
    Foreign(Option<Stamp>),
}

/// Something that happened on a bus.
#[derive(Debug)]
pub(super) struct Event {
    /// When, unless the recorder wrote no times.
    pub(super) at: Option<Stamp>,
    /// Interface or number of the bus, as written.
    pub(super) channel: String,
    pub(super) what: What,
}

/// What happened on a bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    Frame(Frame),
    /// A frame of CAN FD.
    FdFrame,
    BusError,
}

impl Event {
    /// Something at a time, in nanoseconds, that counts from where `evidence` says.
    pub(super) fn at(nanos: i64, evidence: Evidence, channel: &str, what: What) -> Line {
        Line::Event(Self { at: Some(Stamp { nanos, evidence }), channel: channel.to_owned(), what })
    }
}

/// Reads the lines of one format. What one line means may depend on lines before it.
pub(super) trait ReadLine: fmt::Debug + Send {
    /// Reads a line without its end.
    fn read(&mut self, line: &str) -> Read<Line>;
}

/// A format whose lines stand for themselves.
pub(super) struct EachLine(pub(super) fn(&str) -> Read<Line>);

impl fmt::Debug for EachLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("EachLine")
    }
}

impl ReadLine for EachLine {
    fn read(&mut self, line: &str) -> Read<Line> {
        (self.0)(line.trim())
    }
}

/// Makes a data frame of the bytes that stand in `words`, as many as `length` says; more words may follow. With more than
/// eight of them it is a frame of CAN FD.
pub(super) fn counted(id: Id, length: &str, words: &[&str], digits: RangeInclusive<usize>) -> Read<What> {
    let length = count(length)?;
    if length > data_length(15) && words.len() >= length {
        return Ok(What::FdFrame);
    }
    let code = u8::try_from(length).ok().filter(|code| *code <= 15);
    let code = code.ok_or_else(|| format!("fewer than {length} data bytes"))?;
    let needed = data_length(code);
    let words = words.get(..needed).ok_or_else(|| format!("fewer than {needed} data bytes"))?;
    coded_frame(id, code, &payload(words.iter().copied(), hex_byte(digits))?).map(What::Frame)
}
