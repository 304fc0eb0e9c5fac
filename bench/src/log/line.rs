//! What one line of a recording says, in any format.

use super::token::Stamp;
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
