//! Real CAN adapters: frames to and from a bus on the desk.
//!
//! [`Adapter`] is all that is asked of one; [`SlcanAdapter`] is the client of a serial one, [`super::socketcan`] Linux's
//! own interface. [`Bridge`] makes one bus of the bench's and the adapter's. Refuses to know what a frame means.

use super::slcan::{Answer, Command, Line, Lines};
use super::wire::{Outbox, Wire};
use super::{Port, Tool};
use crate::can::{Event, EventKind, Frame, NodeMode};
use crate::printable::printable;
use std::collections::VecDeque;
use std::io;

/// Lines that wait for a serial adapter.
const OUTBOX_LINES: usize = 1_024;
/// Bytes that are read at once.
const READ_MAX: usize = 4_096;
/// Frames that wait for an adapter that is busy.
const BACKLOG_MAX: usize = 1_024;
/// Characters that are repeated of a line that was not understood.
const QUOTED_MAX: usize = 40;
/// Frames that are taken from an adapter in one turn: more than any bus carries in that time.
const FRAMES_PER_TURN: usize = 256;

/// A CAN adapter that never waits.
pub trait Adapter: Send {
    /// Hands a frame over to be sent; `false` if the adapter is busy and did not take it.
    ///
    /// # Errors
    /// If the adapter is gone, or the interface is down.
    fn send(&mut self, frame: &Frame) -> io::Result<bool>;

    /// Takes the next frame that was heard; own frames are not heard.
    ///
    /// # Errors
    /// Like [`Adapter::send`].
    fn receive(&mut self) -> io::Result<Option<Frame>>;

    /// Commands or frames that the adapter has refused.
    fn refused(&self) -> u64 {
        0
    }

    /// What the adapter has said besides frames.
    fn said(&self) -> Said {
        Said::default()
    }
}

/// What an adapter has said besides frames.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Said {
    /// Answers and frames that were understood.
    pub understood: u64,
    /// Frames of CAN FD, which are not taken.
    pub fd_frames: u64,
    /// Lines that were not understood.
    pub unknown: u64,
    /// The first of these, with its control characters escaped.
    pub first_unknown: String,
}

impl<A: Adapter + ?Sized> Adapter for Box<A> {
    fn send(&mut self, frame: &Frame) -> io::Result<bool> {
        (**self).send(frame)
    }

    fn receive(&mut self) -> io::Result<Option<Frame>> {
        (**self).receive()
    }

    fn refused(&self) -> u64 {
        (**self).refused()
    }

    fn said(&self) -> Said {
        (**self).said()
    }
}

/// A serial adapter that speaks SLCAN.
pub struct SlcanAdapter<W: Wire> {
    wire: W,
    lines: Lines,
    outbox: Outbox,
    heard: VecDeque<Frame>,
    refused: u64,
    said: Said,
}

impl<W: Wire> SlcanAdapter<W> {
    /// Closes the adapter's channel, in whatever state it was left, sets the bit rate and opens it.
    ///
    /// Answers are not waited for: there are adapters that give none. [`Adapter::refused`] counts the refusals.
    ///
    /// # Errors
    /// If SLCAN has no name for the bit rate, or the wire is gone.
    pub fn open(wire: W, bitrate: u32) -> io::Result<Self> {
        let setup = Command::setup(bitrate).ok_or_else(|| {
            let problem = format!("SLCAN knows no {bitrate} bit/s; 10000 to 1000000 in the usual steps");
            io::Error::new(io::ErrorKind::InvalidInput, problem)
        })?;
        let (lines, outbox) = (Lines::of_answers(), Outbox::new(OUTBOX_LINES));
        let mut adapter =
            Self { wire, lines, outbox, heard: VecDeque::new(), refused: 0, said: Said::default() };
        // The empty line ends what another program may have left half said.
        for command in [Command::Nothing, Command::Close, setup, Command::Open] {
            adapter.outbox.push(command.line());
        }
        adapter.outbox.flush(&mut adapter.wire)?;
        Ok(adapter)
    }
}

impl<W: Wire> Drop for SlcanAdapter<W> {
    /// Closes the channel as far as the wire takes the bytes: an adapter that stays open goes on talking.
    fn drop(&mut self) {
        self.outbox.clear();
        self.outbox.push(Command::Nothing.line());
        self.outbox.push(Command::Close.line());
        let _ = self.outbox.flush(&mut self.wire);
    }
}

impl<W: Wire> Adapter for SlcanAdapter<W> {
    fn send(&mut self, frame: &Frame) -> io::Result<bool> {
        let fits = !self.outbox.is_full();
        if fits {
            self.outbox.push(Command::Send(*frame).line());
        }
        self.outbox.flush(&mut self.wire)?;
        Ok(fits)
    }

    fn receive(&mut self) -> io::Result<Option<Frame>> {
        self.outbox.flush(&mut self.wire)?;
        if self.heard.is_empty() {
            let mut bytes = [0; READ_MAX];
            let count = self.wire.read(&mut bytes)?;
            for &byte in &bytes[..count] {
                match self.lines.push(byte) {
                    Some(Line::Bell) => self.refused += 1,
                    Some(Line::Text(line)) => self.heard.extend(self.said.take(line)),
                    Some(Line::TooLong) => self.said.not_understood("a line that does not end"),
                    None => {}
                }
            }
        }
        Ok(self.heard.pop_front())
    }

    fn refused(&self) -> u64 {
        self.refused
    }

    fn said(&self) -> Said {
        self.said.clone()
    }
}

impl Said {
    /// Takes a line and returns the frame in it.
    fn take(&mut self, line: &[u8]) -> Option<Frame> {
        match (Answer::parse(line), line.first()) {
            (Some(Answer::Received { frame, .. }), _) => {
                self.understood += 1;
                return Some(frame);
            }
            (Some(_), _) => self.understood += 1,
            (None, Some(b'd' | b'D' | b'b' | b'B')) if line.iter().all(u8::is_ascii_hexdigit) => {
                self.fd_frames += 1;
            }
            // Versions and serial numbers of any form; nobody here asks for one.
            (None, Some(b'V' | b'v' | b'N')) => self.understood += 1,
            (None, _) => self.not_understood(&String::from_utf8_lossy(line)),
        }
        None
    }

    fn not_understood(&mut self, line: &str) {
        if self.unknown == 0 {
            let start: String = line.chars().take(QUOTED_MAX).collect();
            self.first_unknown = printable(&start).into_owned();
        }
        self.unknown += 1;
    }
}

/// Makes one bus of the bench's and of an adapter's: each side hears the other's frames.
pub struct Bridge<A> {
    name: String,
    adapter: A,
    /// Frames that the adapter was too busy for, oldest first.
    backlog: VecDeque<Frame>,
}

impl<A: Adapter> Bridge<A> {
    /// A bridge to `adapter`.
    pub fn new(name: impl Into<String>, adapter: A) -> Self {
        Self { name: name.into(), adapter, backlog: VecDeque::new() }
    }
}

impl<A: Adapter> Tool for Bridge<A> {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn sit(&mut self, port: &mut Port<'_>) {
        port.enter(NodeMode::Active, port.bitrate());
    }

    fn hear(&mut self, event: &Event) {
        if let EventKind::Received { frame } = event.kind {
            if self.backlog.len() == BACKLOG_MAX {
                self.backlog.pop_front();
            }
            self.backlog.push_back(frame);
        }
    }

    fn act(&mut self, port: &mut Port<'_>) -> io::Result<()> {
        while let Some(frame) = self.backlog.front() {
            if !self.adapter.send(frame)? {
                break;
            }
            self.backlog.pop_front();
        }
        for _ in 0..FRAMES_PER_TURN {
            let Some(frame) = self.adapter.receive()? else { break };
            // On a bus that is full the adapter's frames are late like anybody's; beyond that they are lost.
            port.send(frame);
        }
        Ok(())
    }
}
