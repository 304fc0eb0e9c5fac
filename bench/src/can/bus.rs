//! The bus between the nodes: arbitration, acknowledgement, error confinement, faults.
//!
//! Owns virtual bus time to the bit, every node's error counters and who may talk. Nodes ask with [`Bus::request`]; the
//! bus answers with [`Event`]s from [`Bus::poll`], one at a time, so that an answer can be acted upon (a next request in
//! the intermission, say) before time goes on. A wire that is cut leaves its node alone on a segment of its own, where
//! it hears only itself and nobody acknowledges.
//!
//! Time never goes back, on any segment: what becomes possible late (a node recovers, joins or is told to send) starts
//! then and not before, and a call with a time that is over ends the run with a panic.
//!
//! Modelled: arbitration by identifier, RTR and IDE bits; ACK from any other active node; error flags, delimiters and
//! counters; error active, passive and bus-off; suspend transmission; recovery after 128 x 11 recessive bits; joining
//! after 11 recessive bits. Not modelled: single bits on the wire (an error hits a frame at one chosen bit), overload
//! frames, errors in the last bit of the end of frame.
//!
//! Source: Bosch CAN 2.0 part B, chapters 3 to 8; ISO 11898-1:2015, 12.1 (error counting rules, referred to by letter).

use std::collections::VecDeque;

use super::bits::{self, FrameBits};
use super::event::{Aborted, BusError, BusStats, ErrorCounters, Event, EventKind, NodeId, NodeMode, Tag};
use super::frame::Frame;
use crate::time::Nanos;
use protocol_core::states::Confinement;

/// Consecutive recessive bits after which a node may join, and of which 128 end bus-off.
const BUS_IDLE: u32 = 11;
/// Error flag of one node.
const ERROR_FLAG: u32 = 6;
/// The other nodes' flags, which answer the first one.
const ERROR_ECHO: u32 = 6;
/// Recessive bits after the error flags.
const ERROR_DELIMITER: u32 = 8;
/// Extra wait of an error-passive transmitter.
const SUSPEND_TRANSMISSION: u32 = 8;
/// Occurrences of [`BUS_IDLE`] that end bus-off.
const RECOVERY_IDLES: u32 = 128;
/// Dominant bits after an error flag at which the counters rise again (rule f), and then at every eighth.
const STUCK_DOMINANT_FIRST: u32 = 14;
const STUCK_DOMINANT_NEXT: u32 = 8;
/// Counters above this make a node error-passive.
const PASSIVE_ABOVE: u16 = 127;
/// Transmit counter above this takes a node off the bus.
const BUS_OFF_ABOVE: u16 = 255;
/// Where the receive counter of an error-passive node lands after a good frame (rule h: 119..=127).
const RECEIVE_AFTER_GOOD: u16 = 119;
/// A bit rate further off than this, in thousandths, cannot follow the bus.
const RATE_TOLERANCE_PER_MILLE: u64 = 15;
/// Bit at which a node with the wrong bit rate sees its first stuff error.
const MISREAD_BIT: u32 = 20;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Presence {
    Off,
    Joining { since: Nanos },
    On,
}

#[derive(Clone, Copy, Debug)]
struct Request {
    tag: Tag,
    frame: Frame,
    ready_at: Nanos,
    single_shot: bool,
}

#[derive(Debug)]
struct Node {
    name: String,
    segment: usize,
    mode: NodeMode,
    presence: Presence,
    bitrate: u32,
    counters: ErrorCounters,
    state: Confinement,
    bus_off_at: Nanos,
    idles_to_recover: u32,
    suspended_until: Nanos,
    pending: VecDeque<Request>,
    forced_bit_errors: u32,
    garbled_receptions: u32,
}

impl Node {
    fn takes_part(&self) -> bool {
        self.presence == Presence::On && self.state != Confinement::BusOff
    }

    /// Its error flag destroys a frame for everybody.
    fn can_flag(&self) -> bool {
        self.takes_part() && self.mode == NodeMode::Active && self.state == Confinement::ErrorActive
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Step {
    /// An error ends the frame; the transmitter calls it so.
    Fault(BusError),
    /// End of the ACK slot.
    Ack,
    /// Valid for the receivers.
    Receive,
    /// Valid for the receivers although the transmitter missed its acknowledge.
    ReceiveUnacknowledged,
    /// Valid for the transmitter.
    Sent,
}

/// The frame that is on a segment.
#[derive(Debug)]
struct Transfer {
    frame: Frame,
    bits: FrameBits,
    start: Nanos,
    transmitters: Vec<NodeId>,
    /// Who will lose arbitration when, ascending.
    losers: VecDeque<(Nanos, NodeId)>,
    /// Receivers whose copy is damaged.
    garbled: Vec<NodeId>,
    /// Receivers that cannot read the bit rate and will say so.
    misreading: Vec<NodeId>,
    step: Step,
    at: Nanos,
}

/// A piece of wire: the bus itself, or the stub that a cut node is left with.
#[derive(Debug, Default)]
struct Segment {
    transfer: Option<Transfer>,
    /// No start of frame before this.
    free_at: Nanos,
    /// Start of the current recessive phase.
    recessive_since: Nanos,
    /// Stuck dominant; the next time at which the counters rise.
    shorted: Option<Nanos>,
    /// Who was transmitting when the short came.
    stuck_transmitter: Option<NodeId>,
}

/// What a segment does next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Action {
    // Order matters: at the same instant a node joins before the next frame starts.
    Join(NodeId),
    Recover(NodeId),
    LoseArbitration,
    Advance,
    Penalty,
    Start,
}

/// A CAN bus. All times are virtual; two runs with the same calls give the same events.
#[derive(Debug)]
pub struct Bus {
    bitrate: u32,
    nodes: Vec<Node>,
    /// Segment 0 is the bus.
    segments: Vec<Segment>,
    events: VecDeque<Event>,
    stats: BusStats,
    /// How far the bus has come: nothing happens before this any more.
    now: Nanos,
}

impl Bus {
    /// A bus of `bitrate` bit/s (at least 1) without nodes.
    pub fn new(bitrate: u32) -> Self {
        Self {
            bitrate: bitrate.max(1),
            nodes: Vec::new(),
            segments: vec![Segment::default()],
            events: VecDeque::new(),
            stats: BusStats::default(),
            now: Nanos::ZERO,
        }
    }

    /// Bit rate in bit/s.
    pub fn bitrate(&self) -> u32 {
        self.bitrate
    }

    /// The time that `bits` bits take on this bus.
    pub fn span(&self, bits: u32) -> Nanos {
        Nanos(u64::from(bits) * 1_000_000_000 / u64::from(self.bitrate))
    }

    /// Adds a node that takes full part from power-on.
    pub fn attach(&mut self, name: &str) -> NodeId {
        let id = self.attach_off(name);
        let node = &mut self.nodes[id.0];
        (node.mode, node.presence) = (NodeMode::Active, Presence::On);
        id
    }

    /// Adds a node that is off; [`Bus::set_mode`] brings it in.
    pub fn attach_off(&mut self, name: &str) -> NodeId {
        self.nodes.push(Node {
            name: name.to_owned(),
            segment: 0,
            mode: NodeMode::Off,
            presence: Presence::Off,
            bitrate: self.bitrate,
            counters: ErrorCounters::default(),
            state: Confinement::ErrorActive,
            bus_off_at: Nanos::ZERO,
            idles_to_recover: 0,
            suspended_until: Nanos::ZERO,
            pending: VecDeque::new(),
            forced_bit_errors: 0,
            garbled_receptions: 0,
        });
        NodeId(self.nodes.len() - 1)
    }

    /// The name that `node` was attached under.
    pub fn name(&self, node: NodeId) -> &str {
        &self.nodes[node.0].name
    }

    /// Error counters of `node`.
    pub fn counters(&self, node: NodeId) -> ErrorCounters {
        self.nodes[node.0].counters
    }

    /// Fault confinement state of `node`.
    pub fn state(&self, node: NodeId) -> Confinement {
        self.nodes[node.0].state
    }

    /// What went over the bus so far.
    pub fn stats(&self) -> BusStats {
        self.stats
    }

    /// Requests of `node` that have not been sent.
    pub fn pending(&self, node: NodeId) -> usize {
        self.nodes[node.0].pending.len()
    }

    /// True while `node` is in the middle of a frame: sending it, or receiving one that is not yet valid.
    pub fn is_busy(&self, node: NodeId) -> bool {
        let state = &self.nodes[node.0];
        let Some(transfer) = &self.segments[state.segment].transfer else { return false };
        state.takes_part() && (transfer.step != Step::Sent || transfer.transmitters.contains(&node))
    }

    /// True while a frame of `node` is on the bus.
    pub fn is_transmitting(&self, node: NodeId) -> bool {
        let transfer = self.segments[self.nodes[node.0].segment].transfer.as_ref();
        transfer.is_some_and(|transfer| {
            transfer.transmitters.contains(&node) || transfer.losers.iter().any(|&(_, loser)| loser == node)
        })
    }

    /// Asks for `frame` to be sent, not before `ready_at`, after the node's earlier requests and not in a time that is
    /// over.
    ///
    /// It is tried again after lost arbitration and errors until it is sent or aborted.
    pub fn request(&mut self, node: NodeId, ready_at: Nanos, frame: Frame, tag: Tag) {
        self.nodes[node.0].pending.push_back(Request { tag, frame, ready_at, single_shot: false });
    }

    /// Like [`Bus::request`], but gives up after the first lost arbitration or error.
    pub fn request_once(&mut self, node: NodeId, ready_at: Nanos, frame: Frame, tag: Tag) {
        self.nodes[node.0].pending.push_back(Request { tag, frame, ready_at, single_shot: true });
    }

    /// Takes back the node's first request with `tag`.
    pub fn abort(&mut self, node: NodeId, tag: Tag) -> Aborted {
        let transmitting = self.is_transmitting(node);
        let pending = &mut self.nodes[node.0].pending;
        match pending.iter().position(|request| request.tag == tag) {
            None => Aborted::Unknown,
            Some(0) if transmitting => {
                pending[0].single_shot = true;
                Aborted::InTransmission
            }
            Some(index) => {
                pending.remove(index);
                Aborted::Removed
            }
        }
    }

    /// Changes how much `node` takes part; coming from off it first waits for 11 recessive bits.
    ///
    /// Going off in the middle of an own frame destroys that frame.
    ///
    /// # Panics
    /// If the bus has already come further than `now`.
    pub fn set_mode(&mut self, node: NodeId, now: Nanos, mode: NodeMode) {
        self.come_to(now);
        if mode == NodeMode::Off {
            self.leave_transfer(node, now);
        }
        let state = &mut self.nodes[node.0];
        state.mode = mode;
        state.presence = match (mode, state.presence) {
            (NodeMode::Off, _) => Presence::Off,
            (_, Presence::Off) => Presence::Joining { since: now },
            (_, presence) => presence,
        };
    }

    /// Sets the bit rate that `node` believes in, in bit/s. More than 1.5 % off the bus it reads garbage.
    pub fn set_bitrate(&mut self, node: NodeId, bitrate: u32) {
        self.nodes[node.0].bitrate = bitrate.max(1);
    }

    /// Clears the error counters of `node` and makes it error-active (a controller's reset).
    pub fn reset_errors(&mut self, node: NodeId) {
        let state = &mut self.nodes[node.0];
        state.counters = ErrorCounters::default();
        state.state = Confinement::ErrorActive;
    }

    /// Fault: the next `frames` frames of `node` each meet a bit error.
    pub fn force_bit_errors(&mut self, node: NodeId, frames: u32) {
        self.nodes[node.0].forced_bit_errors = frames;
    }

    /// Fault: the next `frames` frames on the bus reach `node` with a wrong CRC.
    pub fn garble_receptions(&mut self, node: NodeId, frames: u32) {
        self.nodes[node.0].garbled_receptions = frames;
    }

    /// Fault: the wire of `node` is cut; it is deaf and mute for the others and alone with itself.
    ///
    /// # Panics
    /// If the bus has already come further than `now`.
    pub fn cut(&mut self, node: NodeId, now: Nanos) {
        self.come_to(now);
        if self.nodes[node.0].segment != 0 {
            return;
        }
        self.leave_transfer(node, now);
        self.segments.push(Segment { free_at: now, recessive_since: now, ..Segment::default() });
        self.nodes[node.0].segment = self.segments.len() - 1;
    }

    /// Ends [`Bus::cut`]; the node takes part again after 11 recessive bits.
    ///
    /// # Panics
    /// If the bus has already come further than `now`.
    pub fn mend(&mut self, node: NodeId, now: Nanos) {
        self.come_to(now);
        let state = &mut self.nodes[node.0];
        if state.segment == 0 {
            return;
        }
        self.segments[state.segment].transfer = None;
        state.segment = 0;
        if state.presence == Presence::On {
            state.presence = Presence::Joining { since: now };
        }
    }

    /// Fault: the bus is stuck dominant (`true`) or free again (`false`).
    ///
    /// # Panics
    /// If the bus has already come further than `now`.
    pub fn short(&mut self, now: Nanos, shorted: bool) {
        self.come_to(now);
        let idle = self.span(BUS_IDLE);
        let first = self.span(STUCK_DOMINANT_FIRST);
        match (shorted, self.segments[0].shorted.is_some()) {
            (true, false) => {
                let transmitter = self.segments[0].transfer.as_ref().map(|transfer| transfer.transmitters[0]);
                if transmitter.is_some() {
                    self.fault(0, now, BusError::Bit);
                }
                let segment = &mut self.segments[0];
                segment.stuck_transmitter = transmitter;
                segment.shorted = Some(now + first);
            }
            (false, true) => {
                let segment = &mut self.segments[0];
                segment.shorted = None;
                segment.recessive_since = now;
                segment.free_at = now + idle;
            }
            _ => {}
        }
    }

    /// The next instant at which the bus does something by itself.
    pub fn next_event(&self) -> Option<Nanos> {
        match self.events.front() {
            Some(event) => Some(event.at),
            None => self.next_action().map(|(at, _, _)| at),
        }
    }

    /// The next event up to and including `now`; call until it gives `None`. From then on the time up to `now` is over.
    ///
    /// # Panics
    /// If an event lies before one that has been given: a fault of this model.
    pub fn poll(&mut self, now: Nanos) -> Option<Event> {
        loop {
            if let Some(event) = self.events.pop_front() {
                return Some(event);
            }
            // Every action moves a frame on, raises a counter towards its end or lets a node in: this ends.
            let Some((at, action, segment)) = self.next_action().filter(|&(at, _, _)| at <= now) else {
                self.now = self.now.max(now);
                return None;
            };
            self.come_to(at);
            self.act(segment, at, action);
        }
    }

    fn matched(&self, node: NodeId) -> bool {
        let (ours, theirs) = (u64::from(self.bitrate), u64::from(self.nodes[node.0].bitrate));
        ours.abs_diff(theirs) * 1_000 <= ours * RATE_TOLERANCE_PER_MILLE
    }

    fn members(&self, segment: usize) -> impl Iterator<Item = (NodeId, &Node)> {
        self.nodes
            .iter()
            .enumerate()
            .filter(move |(_, node)| node.segment == segment)
            .map(|(i, n)| (NodeId(i), n))
    }

    /// Takes `node` out of the frame that it is sending; without a transmitter the frame is broken.
    fn leave_transfer(&mut self, node: NodeId, now: Nanos) {
        let index = self.nodes[node.0].segment;
        let Some(transfer) = &mut self.segments[index].transfer else { return };
        transfer.losers.retain(|&(_, loser)| loser != node);
        if transfer.transmitters == [node] {
            self.break_off(index, now);
        } else {
            transfer.transmitters.retain(|&transmitter| transmitter != node);
        }
    }

    /// Brings the bus to `at`: the check, in every run, that no frame is put onto a wire that has been heard empty.
    fn come_to(&mut self, at: Nanos) {
        assert!(at >= self.now, "bus time goes back: {at} after {}", self.now);
        self.now = at;
    }

    fn emit(&mut self, at: Nanos, node: NodeId, kind: EventKind) {
        self.come_to(at);
        self.events.push_back(Event { at, node, kind });
    }

    fn next_action(&self) -> Option<(Nanos, Action, usize)> {
        (0..self.segments.len())
            .filter_map(|index| self.segment_action(index).map(|(at, action)| (at, action, index)))
            .min_by_key(|&(at, action, index)| (at, index, action))
    }

    fn segment_action(&self, index: usize) -> Option<(Nanos, Action)> {
        let segment = &self.segments[index];
        if let Some(at) = segment.shorted {
            return self.short_still_counts(index).then_some((at, Action::Penalty));
        }
        if let Some(transfer) = &segment.transfer {
            let loses = transfer.losers.front().map(|&(at, _)| (at, Action::LoseArbitration));
            return loses.into_iter().chain([(transfer.at, Action::Advance)]).min();
        }
        let next = self.members(index).filter_map(|(id, node)| self.node_action(segment, id, node)).min();
        // A node that recovers, joins or is asked late finds the wire free for long: it starts now, not then.
        next.map(|(at, action)| (at.max(self.now), action))
    }

    /// What `node` does next on an idle segment.
    fn node_action(&self, segment: &Segment, id: NodeId, node: &Node) -> Option<(Nanos, Action)> {
        if let Presence::Joining { since } = node.presence {
            let idle = if self.matched(id) {
                self.span(BUS_IDLE)
            } else {
                Nanos(u64::from(BUS_IDLE) * 1_000_000_000 / u64::from(node.bitrate))
            };
            return Some((since.max(segment.recessive_since) + idle, Action::Join(id)));
        }
        if node.presence == Presence::Off {
            return None;
        }
        if node.state == Confinement::BusOff {
            let from = node.bus_off_at.max(segment.recessive_since);
            return Some((from + self.span(BUS_IDLE * node.idles_to_recover), Action::Recover(id)));
        }
        let request = node.pending.front().filter(|_| node.mode == NodeMode::Active)?;
        Some((request.ready_at.max(segment.free_at).max(node.suspended_until), Action::Start))
    }

    fn act(&mut self, index: usize, at: Nanos, action: Action) {
        match action {
            Action::Join(node) => {
                self.nodes[node.0].presence = Presence::On;
                self.emit(at, node, EventKind::Joined);
            }
            Action::Recover(node) => {
                self.reset_errors(node);
                self.emit(at, node, EventKind::StateChanged { state: Confinement::ErrorActive });
            }
            Action::LoseArbitration => {
                let transfer = self.segments[index].transfer.as_mut();
                if let Some((_, node)) = transfer.and_then(|transfer| transfer.losers.pop_front())
                    && let Some(&Request { tag, .. }) = self.nodes[node.0].pending.front()
                {
                    self.emit(at, node, EventKind::ArbitrationLost { tag });
                    self.give_up_if_asked(node, at);
                }
            }
            Action::Advance => self.advance_transfer(index, at),
            Action::Penalty => self.penalise_stuck_dominant(index, at),
            Action::Start => self.start_frame(index, at),
        }
    }

    fn start_frame(&mut self, index: usize, start: Nanos) {
        self.count_idles(index, start);
        let mut contenders: Vec<(u32, NodeId, Frame)> = self
            .members(index)
            .filter(|(id, node)| {
                matches!(self.node_action(&self.segments[index], *id, node), Some((at, Action::Start)) if at <= start)
            })
            .filter_map(|(id, node)| node.pending.front().map(|r| (r.frame.arbitration_key(), id, r.frame)))
            .collect();
        contenders.sort_by_key(|&(key, id, _)| (key, id));
        let Some(&(best, winner, frame)) = contenders.first() else { return };
        let bits = FrameBits::of(&frame);
        let transmitters: Vec<NodeId> =
            contenders.iter().filter(|&&(key, _, _)| key == best).map(|&(_, id, _)| id).collect();
        let mut losers: VecDeque<(Nanos, NodeId)> = contenders
            .iter()
            .filter(|&&(key, _, _)| key != best)
            .filter_map(|(_, id, other)| {
                bits::first_difference(&frame, other).map(|bit| (start + self.span(bit), *id))
            })
            .collect();
        losers.make_contiguous().sort();

        // Equal identifiers with different contents collide at the first bit that differs.
        let collision = contenders
            .iter()
            .filter(|&&(key, _, _)| key == best)
            .filter_map(|(_, _, other)| bits::first_difference(&frame, other))
            .min();
        let forced = self.nodes[winner.0].forced_bit_errors > 0;
        self.nodes[winner.0].forced_bit_errors -= u32::from(forced);
        let misreading: Vec<NodeId> = self
            .members(index)
            .filter(|(id, node)| index == 0 && node.can_flag() && !self.matched(*id) && *id != winner)
            .map(|(id, _)| id)
            .collect();
        let garbled = self.take_garbled(index, &transmitters);

        let unreadable = index == 0 && !self.matched(winner) || !misreading.is_empty();
        let fault =
            [unreadable.then_some(MISREAD_BIT.min(bits.crc_end)), collision, forced.then_some(bits.crc_end)]
                .into_iter()
                .flatten()
                .min();
        let (step, at) = match fault {
            Some(bit) => (Step::Fault(BusError::Bit), start + self.span(bit)),
            None => (Step::Ack, start + self.span(bits.ack_end())),
        };
        self.segments[index].transfer =
            Some(Transfer { frame, bits, start, transmitters, losers, garbled, misreading, step, at });
    }

    /// Books the idle time before a frame towards the recovery of nodes that are bus-off.
    fn count_idles(&mut self, index: usize, until: Nanos) {
        let idle = self.span(BUS_IDLE).0.max(1);
        let recessive_since = self.segments[index].recessive_since;
        for node in self.nodes.iter_mut().filter(|n| n.segment == index && n.state == Confinement::BusOff) {
            let idles = until.since(recessive_since.max(node.bus_off_at)).0 / idle;
            // One is left at least: the recovery itself is an action of its own.
            let left = u64::from(node.idles_to_recover).saturating_sub(idles).max(1);
            node.idles_to_recover = u32::try_from(left).unwrap_or(RECOVERY_IDLES);
        }
    }

    fn take_garbled(&mut self, index: usize, transmitters: &[NodeId]) -> Vec<NodeId> {
        let mut garbled = Vec::new();
        for (i, node) in self.nodes.iter_mut().enumerate() {
            let hears = node.segment == index && node.takes_part() && !transmitters.contains(&NodeId(i));
            if hears && node.garbled_receptions > 0 {
                node.garbled_receptions -= 1;
                garbled.push(NodeId(i));
            }
        }
        garbled
    }

    fn advance_transfer(&mut self, index: usize, at: Nanos) {
        let Some(transfer) = &self.segments[index].transfer else { return };
        let (step, start, bits) = (transfer.step, transfer.start, transfer.bits);
        match step {
            Step::Fault(error) => self.fault(index, at, error),
            Step::Ack if !self.is_acknowledged(index) => self.miss_acknowledge(index, at),
            Step::Ack => {
                let flagged = transfer.garbled.iter().any(|node| self.nodes[node.0].can_flag());
                if flagged {
                    // A CRC error is flagged from the bit after the ACK delimiter on.
                    self.schedule(
                        index,
                        Step::Fault(BusError::Bit),
                        start + self.span(bits.ack_delimiter_end()),
                    );
                } else {
                    self.schedule(index, Step::Receive, start + self.span(bits.received()));
                }
            }
            Step::Receive => {
                self.deliver(index, at);
                self.schedule(index, Step::Sent, start + self.span(bits.sent()));
            }
            Step::ReceiveUnacknowledged => {
                self.deliver(index, at);
                self.segments[index].transfer = None;
            }
            Step::Sent => self.complete(index, at),
        }
    }

    fn schedule(&mut self, index: usize, step: Step, at: Nanos) {
        if let Some(transfer) = &mut self.segments[index].transfer {
            (transfer.step, transfer.at) = (step, at);
        }
    }

    /// Whether `node` reads the frame on its segment as it was sent.
    fn reads_well(&self, transfer: &Transfer, id: NodeId, node: &Node) -> bool {
        node.takes_part()
            && self.matched(id)
            && !transfer.transmitters.contains(&id)
            && !transfer.garbled.contains(&id)
    }

    fn is_acknowledged(&self, index: usize) -> bool {
        let Some(transfer) = &self.segments[index].transfer else { return false };
        // Two transmitters of the same frame acknowledge nothing, as neither is a receiver.
        self.members(index)
            .any(|(id, node)| node.mode == NodeMode::Active && self.reads_well(transfer, id, node))
    }

    fn miss_acknowledge(&mut self, index: usize, at: Nanos) {
        let Some(transfer) = &self.segments[index].transfer else { return };
        let passive =
            transfer.transmitters.iter().all(|node| self.nodes[node.0].state == Confinement::ErrorPassive);
        if !passive {
            return self.fault(index, at, BusError::Ack);
        }
        // The flag of an error-passive transmitter is recessive: for a silent listener the frame ends well.
        let (start, bits, frame) = (transfer.start, transfer.bits, transfer.frame);
        let (transmitters, garbled) = (transfer.transmitters.clone(), transfer.garbled.clone());
        self.fault(index, at, BusError::Ack);
        self.segments[index].transfer = Some(Transfer {
            frame,
            bits,
            start,
            transmitters,
            losers: VecDeque::new(),
            garbled,
            misreading: Vec::new(),
            step: Step::ReceiveUnacknowledged,
            at: start + self.span(bits.received()),
        });
    }

    /// Ends the frame on the segment with error flags, a delimiter and an intermission.
    fn fault(&mut self, index: usize, at: Nanos, error: BusError) {
        let Some(transfer) = self.segments[index].transfer.take() else { return };
        let silent_listener_survives = error == BusError::Ack
            && transfer.transmitters.iter().all(|node| self.nodes[node.0].state == Confinement::ErrorPassive);
        let flagging = self.members(index).filter(|(_, node)| node.can_flag()).count();
        let flags = if flagging > 1 { ERROR_FLAG + ERROR_ECHO } else { ERROR_FLAG };
        let end = at + self.span(flags + ERROR_DELIMITER + bits::INTERMISSION);
        self.finish_segment(index, transfer.start, end);
        self.stats.error_frames += 1;

        for &node in &transfer.transmitters {
            let was_passive = self.nodes[node.0].state == Confinement::ErrorPassive;
            let tag = self.nodes[node.0].pending.front().map(|request| request.tag);
            self.emit(at, node, EventKind::Error { error, transmitting: tag });
            // Rule c: +8, except for an error-passive transmitter that only misses its acknowledge.
            if !(was_passive && error == BusError::Ack) {
                self.count(node, at, 8, 0);
            }
            self.give_up_if_asked(node, at);
            self.suspend_if_passive(node, end);
        }
        if silent_listener_survives {
            return;
        }
        let receivers: Vec<NodeId> = self
            .members(index)
            .filter(|(id, node)| node.takes_part() && !transfer.transmitters.contains(id))
            .map(|(id, _)| id)
            .collect();
        for node in receivers {
            let garbled = transfer.garbled.contains(&node);
            let error = if garbled { BusError::Crc } else { BusError::Stuff };
            self.emit(at, node, EventKind::Error { error, transmitting: None });
            // Rules a and b: +1, and +8 for the one that spoke up first and sees the others answer.
            let spoke_up = (garbled || transfer.misreading.contains(&node)) && self.nodes[node.0].can_flag();
            self.count(node, at, 0, if spoke_up { 9 } else { 1 });
        }
    }

    /// The transmitter vanished in mid-frame: the receivers see a stuff error.
    fn break_off(&mut self, index: usize, at: Nanos) {
        if let Some(transfer) = &mut self.segments[index].transfer {
            transfer.transmitters.clear();
        }
        self.fault(index, at, BusError::Stuff);
    }

    fn deliver(&mut self, index: usize, at: Nanos) {
        let Some(transfer) = &self.segments[index].transfer else { return };
        let frame = transfer.frame;
        let receivers: Vec<(NodeId, bool, bool)> = self
            .members(index)
            .filter(|(id, node)| node.takes_part() && !transfer.transmitters.contains(id))
            .map(|(id, node)| (id, self.reads_well(transfer, id, node), transfer.garbled.contains(&id)))
            .collect();
        for (node, reads_well, garbled) in receivers {
            if reads_well {
                self.count_good_reception(node, at);
                self.emit(at, node, EventKind::Received { frame });
            } else {
                let error = if garbled { BusError::Crc } else { BusError::Stuff };
                self.emit(at, node, EventKind::Error { error, transmitting: None });
                self.count(node, at, 0, 1);
            }
        }
    }

    fn complete(&mut self, index: usize, at: Nanos) {
        let Some(transfer) = self.segments[index].transfer.take() else { return };
        let end = transfer.start + self.span(transfer.bits.total());
        self.finish_segment(index, transfer.start, end);
        self.stats.frames += 1;
        for node in transfer.transmitters {
            let state = &mut self.nodes[node.0];
            // Rule g.
            state.counters.transmit = state.counters.transmit.saturating_sub(1);
            if let Some(request) = state.pending.pop_front() {
                self.emit(at, node, EventKind::Sent { tag: request.tag });
            }
            self.update_state(node, at);
            self.suspend_if_passive(node, end);
        }
    }

    fn finish_segment(&mut self, index: usize, start: Nanos, end: Nanos) {
        // Both a good frame and an error frame end in 11 recessive bits: delimiter, (EOF,) intermission.
        let recessive = self.span(BUS_IDLE);
        self.stats.busy += end.since(start);
        let segment = &mut self.segments[index];
        segment.free_at = end;
        segment.recessive_since = end.since(recessive);
    }

    fn suspend_if_passive(&mut self, node: NodeId, end: Nanos) {
        let suspended = end + self.span(SUSPEND_TRANSMISSION);
        let state = &mut self.nodes[node.0];
        if state.state == Confinement::ErrorPassive {
            state.suspended_until = suspended;
        }
    }

    fn give_up_if_asked(&mut self, node: NodeId, at: Nanos) {
        let pending = &mut self.nodes[node.0].pending;
        if let Some(&Request { tag, single_shot: true, .. }) = pending.front() {
            pending.pop_front();
            self.emit(at, node, EventKind::GivenUp { tag });
        }
    }

    fn short_still_counts(&self, index: usize) -> bool {
        let stuck = self.segments[index].stuck_transmitter;
        self.members(index).any(|(id, node)| {
            node.takes_part()
                && node.mode == NodeMode::Active
                && (stuck == Some(id) || node.counters.receive <= PASSIVE_ABOVE)
        })
    }

    fn penalise_stuck_dominant(&mut self, index: usize, at: Nanos) {
        let next = at + self.span(STUCK_DOMINANT_NEXT);
        let stuck = self.segments[index].stuck_transmitter;
        let members: Vec<NodeId> =
            self.members(index).filter(|(_, node)| node.takes_part()).map(|(id, _)| id).collect();
        for node in members {
            if stuck == Some(node) {
                self.count(node, at, 8, 0);
            } else {
                self.count(node, at, 0, 8);
            }
        }
        self.segments[index].shorted = Some(next);
    }

    /// Raises the counters of `node`, unless they rest.
    fn count(&mut self, node: NodeId, at: Nanos, transmit: u16, receive: u16) {
        let state = &mut self.nodes[node.0];
        if state.mode != NodeMode::Active {
            return;
        }
        state.counters.transmit = (state.counters.transmit + transmit).min(BUS_OFF_ABOVE + 1);
        state.counters.receive = (state.counters.receive + receive).min(255);
        self.update_state(node, at);
    }

    /// Rule h.
    fn count_good_reception(&mut self, node: NodeId, at: Nanos) {
        let state = &mut self.nodes[node.0];
        if state.mode != NodeMode::Active {
            return;
        }
        state.counters.receive = match state.counters.receive {
            above if above > PASSIVE_ABOVE => RECEIVE_AFTER_GOOD,
            count => count.saturating_sub(1),
        };
        self.update_state(node, at);
    }

    fn update_state(&mut self, node: NodeId, at: Nanos) {
        let state = &mut self.nodes[node.0];
        let next = match state.counters {
            _ if state.state == Confinement::BusOff => Confinement::BusOff,
            ErrorCounters { transmit, .. } if transmit > BUS_OFF_ABOVE => Confinement::BusOff,
            ErrorCounters { transmit, receive } if transmit.max(receive) > PASSIVE_ABOVE => {
                Confinement::ErrorPassive
            }
            _ => Confinement::ErrorActive,
        };
        if next == state.state {
            return;
        }
        state.state = next;
        if next == Confinement::BusOff {
            (state.bus_off_at, state.idles_to_recover) = (at, RECOVERY_IDLES);
        }
        self.emit(at, node, EventKind::StateChanged { state: next });
    }
}
