//! Writes every frame on the bus to a candump log.
//!
//! Listens only: it acknowledges nothing and sends nothing. The lines can be read back by every command here that
//! takes a log, and by `canplayer`. Of a bench that is started again the times go on where those of the last one ended.
//! Whole lines are handed over every turn; when they cannot all be written, a [`Receipt`] says how many were.

use super::{Port, Tool, locked};
use crate::can::{Event, EventKind, NodeMode};
use crate::log::candump_line;
use crate::time::Nanos;
use std::io::{self, ErrorKind, Write};
use std::sync::{Arc, Mutex};

/// Name of the bus in the log.
const INTERFACE: &str = "can0";

/// A log that is being written.
pub struct Recorder<W> {
    log: W,
    /// Lines of this turn.
    lines: Vec<u8>,
    /// What is added to the bench's time.
    since: Nanos,
    /// Time of the last line.
    last: Nanos,
    receipt: Receipt,
}

/// Tells what became of a recording, during the run and afterwards.
#[derive(Clone, Debug, Default)]
pub struct Receipt(Arc<Mutex<Written>>);

/// What became of a recording.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// Frames whose lines are whole in the log.
    pub frames: u64,
    /// Bytes of these lines; what stands behind them is a line that was cut off.
    pub bytes: u64,
    /// Why the recording ended before the run did, and how many frames it holds.
    pub failure: Option<String>,
}

impl Receipt {
    /// Returns what became of the recording so far.
    pub fn written(&self) -> Written {
        locked(&self.0).clone()
    }
}

impl<W: Write + Send> Recorder<W> {
    /// A recorder that appends lines to `log`, which must not keep any of them back.
    pub fn new(log: W) -> Self {
        let (since, last) = (Nanos::ZERO, Nanos::ZERO);
        Self { log, lines: Vec::new(), since, last, receipt: Receipt::default() }
    }

    /// Returns what tells later what became of the recording.
    pub fn receipt(&self) -> Receipt {
        self.receipt.clone()
    }

    /// Writes the lines of this turn and counts those that are whole in the log.
    fn write(&mut self) -> io::Result<()> {
        let (mut done, mut result) = (0, Ok(()));
        while result.is_ok() && done < self.lines.len() {
            match self.log.write(&self.lines[done..]) {
                Ok(0) => result = Err(ErrorKind::WriteZero.into()),
                Ok(written) => done += written,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => result = Err(error),
            }
        }
        let is_end = |byte: &u8| *byte == b'\n';
        let whole = self.lines[..done].iter().rposition(is_end).map_or(0, |end| end + 1);
        let frames = self.lines[..whole].iter().filter(|byte| is_end(byte)).count();
        self.lines.clear();
        let mut written = locked(&self.receipt.0);
        written.frames += frames as u64;
        written.bytes += whole as u64;
        result
    }
}

impl<W: Write + Send> Tool for Recorder<W> {
    fn name(&self) -> String {
        "recorder".into()
    }

    fn sit(&mut self, port: &mut Port<'_>) {
        self.since = self.last.since(port.now());
        port.enter(NodeMode::ListenOnly, port.bitrate());
    }

    fn hear(&mut self, event: &Event) {
        if let EventKind::Received { frame } = event.kind {
            self.last = self.since + event.at;
            self.lines.extend(candump_line(self.last, INTERFACE, &frame).bytes());
            self.lines.push(b'\n');
        }
    }

    fn act(&mut self, port: &mut Port<'_>) -> io::Result<()> {
        let missed = match port.missed() {
            0 => Ok(()),
            missed => Err(io::Error::other(format!("{missed} frames could not be written in time"))),
        };
        self.write().and(missed).map_err(|error| {
            let mut written = locked(&self.receipt.0);
            let problem = format!("{error}; {} frames are safely in the log", written.frames);
            written.failure = Some(problem.clone());
            io::Error::new(error.kind(), problem)
        })
    }
}
