//! Other tools on the bench's bus: python-can, can-utils, SavvyCAN, a real adapter, a recording.
//!
//! A [`Tool`] is a program or device outside; each is one node of the virtual bus, which arbitrates, is acknowledged and
//! goes bus-off like any other. [`Members`] gives every tool its turn between two slices of virtual time: what happened
//! on the bus since the last turn is told in order and with its virtual times, what the tool wants to send is requested
//! at the present virtual time. Bench and tools are never further apart than one slice; who calls decides how virtual
//! time follows the wall clock. Not deterministic by nature: the world outside has its own time.
//!
//! [`slcan`] is the text protocol, [`terminal`] the virtual adapter that speaks it, [`pty`] the pseudo-terminal and the
//! serial port under it, [`adapter`] the side of real adapters, [`socketcan`] Linux's own interface, [`recorder`] writes
//! a log.

pub mod adapter;
#[cfg(unix)]
pub mod pty;
pub mod recorder;
pub mod slcan;
#[cfg(target_os = "linux")]
pub mod socketcan;
pub mod terminal;
pub mod wire;

use crate::can::{Aborted, Bus, Confinement, Event, Frame, NodeId, NodeMode, Participant, Tag};
use crate::chips::bench_board::BenchBoard;
use crate::time::Nanos;
use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Longest time between two turns, in virtual time.
pub const TURN: Nanos = Nanos::from_millis(10);
/// Events that are kept for a tool between two turns: some seconds of a full bus.
const INBOX_MAX: usize = 16_384;
/// Frames of one tool that wait to be sent: an eighth of a second of a full bus at 250 kbit/s.
const SEND_MAX: usize = 256;
/// Tag of every request made here.
const TOOL: Tag = Tag(2);
/// Error counters from here on are worth a warning (ISO 11898-1, 12.1.4.2).
const WARNING_LIMIT: u16 = 96;

/// A program or device outside of the bench that takes part in the bus.
pub trait Tool: Send {
    /// What it is called on the bus and in messages.
    fn name(&self) -> String;

    /// It has been given a place on a bus: a new one, or another one after the bench was started again.
    fn sit(&mut self, port: &mut Port<'_>);

    /// One event of its own node; they come in order, before its turn.
    fn hear(&mut self, event: &Event);

    /// Its turn: reads what the outside wants and writes what it should know. Must not wait.
    ///
    /// # Errors
    /// If the outside is gone for good: the tool is taken off the bus.
    fn act(&mut self, port: &mut Port<'_>) -> io::Result<()>;
}

/// A tool's place on the bus, during its turn.
pub struct Port<'a> {
    bus: &'a mut Bus,
    node: NodeId,
    now: Nanos,
    missed: u64,
}

impl Port<'_> {
    /// Virtual time.
    pub fn now(&self) -> Nanos {
        self.now
    }

    /// Bit rate of the bus, in bit/s.
    pub fn bitrate(&self) -> u32 {
        self.bus.bitrate()
    }

    /// Events that were lost since the last turn because turns were too far apart.
    pub fn missed(&self) -> u64 {
        self.missed
    }

    /// Takes part with a bit rate of its own, with fresh error counters; a wrong rate reads garbage and disturbs.
    pub fn enter(&mut self, mode: NodeMode, bitrate: u32) {
        self.bus.set_bitrate(self.node, bitrate);
        self.bus.reset_errors(self.node);
        self.bus.set_mode(self.node, self.now, mode);
    }

    /// Takes back what waits and leaves the bus.
    pub fn leave(&mut self) {
        // Ends: each pass takes one request away.
        while self.bus.abort(self.node, TOOL) == Aborted::Removed {}
        self.bus.set_mode(self.node, self.now, NodeMode::Off);
        while self.bus.abort(self.node, TOOL) == Aborted::Removed {}
    }

    /// Asks for a frame to be sent; `false` if too many wait already.
    pub fn send(&mut self, frame: Frame) -> bool {
        let fits = self.bus.pending(self.node) < SEND_MAX;
        if fits {
            self.bus.request(self.node, self.now, frame, TOOL);
        }
        fits
    }

    /// Frames that wait to be sent.
    pub fn pending(&self) -> usize {
        self.bus.pending(self.node)
    }

    /// Fault confinement state of the tool's node.
    pub fn state(&self) -> Confinement {
        self.bus.state(self.node)
    }

    /// An error counter of the tool's node stands at 96 or more.
    pub fn is_warned(&self) -> bool {
        let counters = self.bus.counters(self.node);
        counters.transmit.max(counters.receive) >= WARNING_LIMIT
    }
}

/// What happened to a tool's node since its last turn.
#[derive(Debug, Default)]
struct Inbox {
    events: VecDeque<Event>,
    missed: u64,
}

/// The part of a tool that lives on the bus: writes down what happens to its node.
struct Ear {
    node: NodeId,
    inbox: Arc<Mutex<Inbox>>,
}

impl Participant for Ear {
    fn start(&mut self, _: Nanos, _: &mut Bus) {}

    fn on_event(&mut self, event: &Event, _: &mut Bus) {
        if event.node != self.node {
            return;
        }
        let mut inbox = locked(&self.inbox);
        if inbox.events.len() == INBOX_MAX {
            inbox.events.pop_front();
            inbox.missed += 1;
        }
        inbox.events.push_back(*event);
    }
}

struct Member {
    tool: Box<dyn Tool>,
    seat: Option<(NodeId, Arc<Mutex<Inbox>>)>,
}

impl Member {
    fn sit(&mut self, board: &mut BenchBoard) {
        // What happened on the bus of a bench that is gone, after the last turn there.
        if let Some((_, inbox)) = self.seat.take() {
            for event in &std::mem::take(&mut *locked(&inbox)).events {
                self.tool.hear(event);
            }
        }
        let (now, inbox) = (board.now(), Arc::default());
        let bus = board.bus_mut();
        let node = bus.attach_off(&self.tool.name());
        self.tool.sit(&mut Port { bus, node, now, missed: 0 });
        board.join(Ear { node, inbox: Arc::clone(&inbox) });
        self.seat = Some((node, inbox));
    }

    fn turn(&mut self, board: &mut BenchBoard) -> io::Result<()> {
        let Some((node, inbox)) = &self.seat else { return Ok(()) };
        let Inbox { events, missed } = std::mem::take(&mut *locked(inbox));
        for event in &events {
            self.tool.hear(event);
        }
        let (node, now) = (*node, board.now());
        let mut port = Port { bus: board.bus_mut(), node, now, missed };
        let result = self.tool.act(&mut port);
        if result.is_err() {
            port.leave();
        }
        result
    }
}

/// Every tool on the bus of a bench. A clone is another handle to the same tools: they outlive a bench that is
/// started again.
#[derive(Clone, Default)]
pub struct Members(Arc<Mutex<Vec<Member>>>);

impl Members {
    /// Adds a tool; it sits down at the next [`Members::attach`].
    pub fn add(&self, tool: impl Tool + 'static) {
        locked(&self.0).push(Member { tool: Box::new(tool), seat: None });
    }

    /// Returns whether there is no tool.
    pub fn is_empty(&self) -> bool {
        locked(&self.0).is_empty()
    }

    /// Gives every tool a node on this board's bus. A bench that the tools sat at before must be gone.
    pub fn attach(&self, board: &mut BenchBoard) {
        for member in locked(&self.0).iter_mut() {
            member.sit(board);
        }
    }

    /// Gives every tool its turn. One that fails leaves the bus, and why is said on standard error.
    pub fn poll(&self, board: &mut BenchBoard) {
        locked(&self.0).retain_mut(|member| match member.turn(board) {
            Ok(()) => true,
            Err(error) => {
                eprintln!("{} has left the bus: {error}", member.tool.name());
                false
            }
        });
    }
}

/// A tool that panicked leaves nothing half done here that a lock would have to protect.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests;
