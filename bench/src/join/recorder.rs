//! Writes every frame on the bus to a candump log.
//!
//! Listens only: it acknowledges nothing and sends nothing. The lines can be read back by every command here that
//! takes a log, and by `canplayer`.

use super::{Port, Tool};
use crate::can::{Event, EventKind, NodeMode};
use crate::log::candump_line;
use std::io::{self, Write};

/// Name of the bus in the log.
const INTERFACE: &str = "can0";

/// A log that is being written.
pub struct Recorder<W> {
    log: W,
    /// What went wrong while an event was written.
    failed: Option<io::Error>,
}

impl<W: Write + Send> Recorder<W> {
    /// A recorder that appends lines to `log`.
    pub fn new(log: W) -> Self {
        Self { log, failed: None }
    }
}

impl<W: Write + Send> Tool for Recorder<W> {
    fn name(&self) -> String {
        "recorder".into()
    }

    fn sit(&mut self, port: &mut Port<'_>) {
        port.enter(NodeMode::ListenOnly, port.bitrate());
    }

    fn hear(&mut self, event: &Event) {
        if let EventKind::Received { frame } = event.kind
            && self.failed.is_none()
        {
            self.failed = writeln!(self.log, "{}", candump_line(event.at, INTERFACE, &frame)).err();
        }
    }

    fn act(&mut self, port: &mut Port<'_>) -> io::Result<()> {
        if port.missed() > 0 {
            return Err(io::Error::other(format!("{} frames could not be written in time", port.missed())));
        }
        self.failed.take().map_or_else(|| self.log.flush(), Err)
    }
}
