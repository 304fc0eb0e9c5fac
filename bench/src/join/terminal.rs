//! A serial CAN adapter that is not there: the bench's end of an SLCAN line.
//!
//! Owns what such an adapter remembers: open or closed, bit rate, time stamps, status flags. A bit rate that is not the
//! bus's is taken at its word: the node then reads garbage and disturbs the others, as on a desk; without `S` it is the
//! bus's. Frames that wait when the channel is closed are still sent, for a short time. A client that goes away
//! closes the channel.
//!
//! Source: LAWICEL CAN232 manual; kinder in one place, because clients are careless: a command that asks for what is
//! already so is done and not refused (python-can opens twice, SavvyCAN and slcand close first).

use super::slcan::{Answer, Command, Flag, Line, Lines, stamp};
use super::wire::{Outbox, Wire};
use super::{Port, Tool};
use crate::can::{Confinement, Event, EventKind, NodeMode};
use crate::time::Nanos;
use std::io;

/// Lines that wait for a client that does not read: two seconds of a full bus at 250 kbit/s.
const OUTBOX_LINES: usize = 4_096;
/// Bytes that are read in one turn: some 150 frames, twice of what a full bus takes in a slice.
const READ_MAX: usize = 4_096;
/// Time in which frames that were asked for before `C` may still be sent.
const CLOSING: Nanos = Nanos::from_millis(100);
/// Versions that `V` and `v` tell: 1.1.
const VERSION: [u8; 4] = *b"0101";
/// Serial number that `N` tells.
const SERIAL: [u8; 4] = *b"BNCH";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Channel {
    Closed,
    /// Closed for the client; what it has asked for is still sent.
    Closing {
        until: Nanos,
    },
    Open,
    Listening,
}

/// The virtual adapter behind a wire.
pub struct Terminal<W> {
    name: String,
    wire: W,
    lines: Lines,
    outbox: Outbox,
    channel: Channel,
    /// `None` until the client says one: that of the bus.
    bitrate: Option<u32>,
    stamps: bool,
    /// Flags since the last `F`.
    flags: u8,
    was_connected: bool,
}

impl<W: Wire> Terminal<W> {
    /// An adapter with a closed channel.
    pub fn new(name: impl Into<String>, wire: W) -> Self {
        Self {
            name: name.into(),
            wire,
            lines: Lines::of_commands(),
            outbox: Outbox::new(OUTBOX_LINES),
            channel: Channel::Closed,
            bitrate: None,
            stamps: false,
            flags: 0,
            was_connected: false,
        }
    }

    fn raise(&mut self, flag: Flag) {
        self.flags |= flag as u8;
    }

    /// The client has opened the channel.
    pub(super) fn is_open(&self) -> bool {
        matches!(self.channel, Channel::Open | Channel::Listening)
    }

    fn say(&mut self, answer: &Answer) {
        if !self.outbox.push(answer.line()) {
            self.raise(Flag::ReceiveFull);
            self.raise(Flag::Overrun);
        }
    }

    /// Does what a command asks for and returns the answer.
    fn obey(&mut self, command: Command, port: &mut Port<'_>) -> Answer {
        match command {
            Command::Nothing | Command::AcceptanceCode(_) | Command::AcceptanceMask(_) => Answer::Done,
            Command::Setup(_) | Command::Timing(..) | Command::Stamps(_) if self.is_open() => Answer::Refused,
            Command::Setup(_) | Command::Timing(..) => {
                self.bitrate = command.bitrate();
                Answer::Done
            }
            Command::Stamps(on) => {
                self.stamps = on;
                Answer::Done
            }
            Command::Open => self.open(Channel::Open, port),
            Command::Listen => self.open(Channel::Listening, port),
            Command::Close => {
                self.close(port);
                Answer::Done
            }
            Command::Send(_) if self.channel != Channel::Open => Answer::Refused,
            Command::Send(frame) if port.send(frame) => Answer::Queued { extended: frame.id.is_extended() },
            Command::Send(_) => {
                self.raise(Flag::TransmitFull);
                Answer::Refused
            }
            Command::Version => Answer::Version(VERSION),
            Command::Software => Answer::Software(VERSION),
            Command::Serial => Answer::Serial(SERIAL),
            Command::Status if self.is_open() => {
                if port.is_warned() {
                    self.raise(Flag::Warning);
                }
                if port.state() != Confinement::ErrorActive {
                    self.raise(Flag::Passive);
                }
                Answer::Status(std::mem::take(&mut self.flags))
            }
            Command::Status => Answer::Refused,
        }
    }

    fn open(&mut self, wanted: Channel, port: &mut Port<'_>) -> Answer {
        if self.channel == wanted {
            return Answer::Done;
        }
        if self.is_open() {
            return Answer::Refused;
        }
        self.channel = wanted;
        self.flags = 0;
        self.enter(port);
        Answer::Done
    }

    fn enter(&self, port: &mut Port<'_>) {
        let mode = match self.channel {
            Channel::Open => NodeMode::Active,
            Channel::Listening => NodeMode::ListenOnly,
            Channel::Closed | Channel::Closing { .. } => return,
        };
        port.enter(mode, self.bitrate.unwrap_or(port.bitrate()));
    }

    fn close(&mut self, port: &mut Port<'_>) {
        if self.is_open() {
            self.channel = Channel::Closing { until: port.now() + CLOSING };
        }
    }

    /// Leaves the bus once everything is sent, or it has taken too long.
    fn finish_closing(&mut self, port: &mut Port<'_>) {
        if let Channel::Closing { until } = self.channel
            && (port.pending() == 0 || port.now() >= until)
        {
            port.leave();
            self.channel = Channel::Closed;
        }
    }

    /// Obeys what the client has written and returns how many bytes that was.
    fn read(&mut self, port: &mut Port<'_>) -> io::Result<usize> {
        let mut bytes = [0; READ_MAX];
        let count = self.wire.read(&mut bytes)?;
        for &byte in &bytes[..count] {
            let command = match self.lines.push(byte) {
                None => continue,
                Some(Line::Text(line)) => Command::parse(line),
                Some(Line::TooLong | Line::Bell) => None,
            };
            let answer = command.map_or(Answer::Refused, |command| self.obey(command, port));
            self.say(&answer);
        }
        Ok(count)
    }

    /// The next client finds the adapter as if it had just been plugged in.
    fn forget_client(&mut self, port: &mut Port<'_>) {
        self.close(port);
        self.lines.clear();
        self.outbox.clear();
        (self.bitrate, self.stamps, self.flags) = (None, false, 0);
    }
}

impl<W: Wire> Tool for Terminal<W> {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn sit(&mut self, port: &mut Port<'_>) {
        self.enter(port);
    }

    fn hear(&mut self, event: &Event) {
        if !self.is_open() {
            return;
        }
        match event.kind {
            EventKind::Received { frame } => {
                let stamp = self.stamps.then(|| stamp(event.at));
                self.say(&Answer::Received { frame, stamp });
            }
            EventKind::Error { .. } => self.raise(Flag::BusError),
            EventKind::ArbitrationLost { .. } => self.raise(Flag::ArbitrationLost),
            EventKind::StateChanged { state: Confinement::ErrorPassive | Confinement::BusOff } => {
                self.raise(Flag::Passive);
            }
            EventKind::Sent { .. }
            | EventKind::GivenUp { .. }
            | EventKind::StateChanged { .. }
            | EventKind::Joined => {}
        }
    }

    fn act(&mut self, port: &mut Port<'_>) -> io::Result<()> {
        if port.missed() > 0 && self.is_open() {
            self.raise(Flag::Overrun);
        }
        // What a client wrote before it left still counts, `printf ... > /dev/pts/5` included.
        let connected = self.wire.is_connected()?;
        let count = self.read(port)?;
        if connected {
            self.outbox.flush(&mut self.wire)?;
            self.was_connected = true;
        } else if count == 0 && (self.was_connected || self.is_open() || !self.outbox.is_empty()) {
            self.forget_client(port);
            self.was_connected = false;
        }
        self.finish_closing(port);
        Ok(())
    }
}
