//! Which format a recording is in, and its lines read as that format has them.

use super::line::Line;
use super::{asc, candump, gvret};

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
