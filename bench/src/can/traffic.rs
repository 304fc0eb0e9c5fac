//! Nodes that only make traffic: full load with sequence numbers, recordings.
//!
//! Both are driven by the events of their own bus node, so a run with them is as deterministic as the bus itself.
//! They refuse to look at other nodes' frames.

use super::bus::Bus;
use super::event::{Event, EventKind, NodeId, Tag};
use super::frame::{Frame, Id};
use crate::time::Nanos;

/// Something that lives on the bus and answers its events.
pub trait Participant {
    /// Called once, when the participant is put on the bus.
    fn start(&mut self, now: Nanos, bus: &mut Bus);

    /// Called for every event of every node; `event.at` is now.
    fn on_event(&mut self, event: &Event, bus: &mut Bus);
}

/// Tag of all requests made here.
const TRAFFIC: Tag = Tag(0);

/// Sends frames back to back: the next one is waiting before the intermission ends.
pub struct LoadGenerator {
    node: NodeId,
    source: Box<dyn FnMut(u64) -> Frame + Send>,
    limit: Option<u64>,
    spacing: Nanos,
    requested: u64,
    sent: u64,
    last_request: Nanos,
}

impl LoadGenerator {
    /// A generator on `node` that asks `source` for frame 0, 1, 2, ...
    pub fn new(node: NodeId, source: impl FnMut(u64) -> Frame + Send + 'static) -> Self {
        Self {
            node,
            source: Box::new(source),
            limit: None,
            spacing: Nanos::ZERO,
            requested: 0,
            sent: 0,
            last_request: Nanos::ZERO,
        }
    }

    /// A generator of eight-byte frames under `id` whose payload is the little-endian sequence number.
    pub fn sequenced(node: NodeId, id: Id) -> Self {
        Self::new(node, move |sequence| Frame { id, remote: false, dlc: 8, data: sequence.to_le_bytes() })
    }

    /// A generator of the frames of a recording, again and again, without its pauses.
    ///
    /// # Panics
    /// If the recording is empty.
    pub fn of_recording(node: NodeId, recording: Vec<(Nanos, Frame)>) -> Self {
        assert!(!recording.is_empty(), "a recording without a frame");
        let length = recording.len() as u64;
        Self::new(node, move |number| recording[(number % length) as usize].1)
    }

    /// Stops after `count` frames.
    pub fn limited_to(self, count: u64) -> Self {
        Self { limit: Some(count), ..self }
    }

    /// Requests at most one frame per `spacing`.
    pub fn spaced_by(self, spacing: Nanos) -> Self {
        Self { spacing, ..self }
    }

    /// Frames that went over the bus.
    pub fn sent(&self) -> u64 {
        self.sent
    }

    fn request(&mut self, at: Nanos, bus: &mut Bus) {
        if self.limit.is_some_and(|limit| self.requested >= limit) {
            return;
        }
        let frame = (self.source)(self.requested);
        self.requested += 1;
        self.last_request = at;
        bus.request(self.node, at, frame, TRAFFIC);
    }
}

impl Participant for LoadGenerator {
    fn start(&mut self, now: Nanos, bus: &mut Bus) {
        self.request(now, bus);
    }

    fn on_event(&mut self, event: &Event, bus: &mut Bus) {
        if event.node == self.node && matches!(event.kind, EventKind::Sent { .. }) {
            self.sent += 1;
            self.request(event.at.max(self.last_request + self.spacing), bus);
        }
    }
}

/// Sends a recording at its recorded times, or as soon after as the bus lets it.
#[derive(Clone, Debug)]
pub struct Replay {
    node: NodeId,
    recording: Vec<(Nanos, Frame)>,
    period: Option<Nanos>,
    base: Nanos,
    next: usize,
    sent: u64,
}

impl Replay {
    /// A replay of `recording` (times from its start, ascending) on `node`.
    pub fn new(node: NodeId, recording: Vec<(Nanos, Frame)>) -> Self {
        Self { node, recording, period: None, base: Nanos::ZERO, next: 0, sent: 0 }
    }

    /// Starts the recording again every `period`.
    pub fn repeated_every(self, period: Nanos) -> Self {
        Self { period: Some(period), ..self }
    }

    /// Frames that went over the bus.
    pub fn sent(&self) -> u64 {
        self.sent
    }

    fn request(&mut self, bus: &mut Bus) {
        if self.next == self.recording.len() {
            let Some(period) = self.period else { return };
            self.next = 0;
            self.base += period;
        }
        if let Some(&(offset, frame)) = self.recording.get(self.next) {
            self.next += 1;
            bus.request(self.node, self.base + offset, frame, TRAFFIC);
        }
    }
}

impl Participant for Replay {
    fn start(&mut self, now: Nanos, bus: &mut Bus) {
        self.base = now;
        self.request(bus);
    }

    fn on_event(&mut self, event: &Event, bus: &mut Bus) {
        if event.node == self.node && matches!(event.kind, EventKind::Sent { .. }) {
            self.sent += 1;
            self.request(bus);
        }
    }
}
