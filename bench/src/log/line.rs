//! What one line of a recording says, in any format, and which format that is.

use super::token::Stamp;
use super::{asc, candump, gvret};
use crate::can::Frame;

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
    /// The frame; `None` = a bus error.
    pub(super) frame: Option<Frame>,
}

/// Reads the lines of one format. What one line means may depend on lines before it.
#[derive(Debug)]
pub(super) enum Format {
    Logged,
    Shown(candump::Shown),
    Gvret,
    Asc(asc::Asc),
}

impl Format {
    /// Returns the format that a line is of, if it is of one.
    pub(super) fn of(line: &str) -> Option<Self> {
        if candump::looks_logged(line) {
            Some(Self::Logged)
        } else if gvret::looks_like(line) {
            Some(Self::Gvret)
        } else if asc::looks_like(line) {
            Some(Self::Asc(asc::Asc::default()))
        } else if candump::looks_shown(line) {
            Some(Self::Shown(candump::Shown::default()))
        } else {
            None
        }
    }

    /// Reads a line.
    pub(super) fn read(&mut self, line: &str) -> Result<Line, String> {
        match self {
            Self::Logged => candump::read_logged(line.trim()),
            Self::Shown(shown) => shown.read(line),
            Self::Gvret => gvret::read(line.trim()),
            Self::Asc(asc) => asc.read(line.trim()),
        }
    }
}
