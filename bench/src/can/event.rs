//! The words between the bus and its nodes: who, what was asked, what happened.
//!
//! Source: ISO 11898-1:2015, 12.1 (fault confinement states and counters).

#[cfg(doc)]
use super::Bus;
use super::frame::Frame;
use crate::time::Nanos;
use protocol_core::states::Confinement;

/// A node on a [`Bus`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub(super) usize);

/// The node's own name for a request; comes back with the events about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Tag(pub u32);

/// How much a node takes part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeMode {
    /// Neither hears nor speaks.
    Off,
    /// Hears; sends nothing, not even an acknowledge or an error flag; its counters rest.
    ListenOnly,
    /// Hears, acknowledges, sends.
    Active,
}

/// What went wrong, as seen by the node that reports it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BusError {
    /// Sent one level, saw the other.
    Bit,
    /// Six equal bits: garbage, or another node's error flag.
    Stuff,
    /// The CRC does not fit.
    Crc,
    /// Nobody acknowledged.
    Ack,
}

/// Error counters of a node.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ErrorCounters {
    /// Transmit error counter; 256 = bus-off.
    pub transmit: u16,
    /// Receive error counter, saturates at 255.
    pub receive: u16,
}

/// Something that happened to one node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    /// When.
    pub at: Nanos,
    /// To whom.
    pub node: NodeId,
    /// What.
    pub kind: EventKind,
}

/// What can happen on a bus segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// A frame of another node is valid (end of the last but one bit of its end of frame).
    Received {
        /// Identifier, flags and data that were on the wire.
        frame: Frame,
    },
    /// A requested frame went out and was acknowledged (end of its end of frame).
    Sent {
        /// Of the request.
        tag: Tag,
    },
    /// Another frame won; the request stays.
    ArbitrationLost {
        /// Of the request.
        tag: Tag,
    },
    /// The request was given up after a lost arbitration or an error: single shot, or abort was asked for.
    GivenUp {
        /// Of the request.
        tag: Tag,
    },
    /// An error was seen.
    Error {
        /// Which.
        error: BusError,
        /// The request that was on the bus, if this node was transmitting; it stays.
        transmitting: Option<Tag>,
    },
    /// The fault confinement state changed.
    StateChanged {
        /// The new state; to the bus a node with a warning is error-active.
        state: Confinement,
    },
    /// The node has seen 11 recessive bits and takes part from now on.
    Joined,
}

/// What [`Bus::abort`] could do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aborted {
    /// The request is gone.
    Removed,
    /// The frame is on the bus: it will be [`EventKind::Sent`], or [`EventKind::GivenUp`] if it fails.
    InTransmission,
    /// No such request.
    Unknown,
}

/// What went over the bus so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BusStats {
    /// Frames that were sent and acknowledged.
    pub frames: u64,
    /// Frames that ended in an error flag.
    pub error_frames: u64,
    /// Time in frames, error frames and intermissions.
    pub busy: Nanos,
}
