//! A classical CAN bus in virtual time: frames, their bits, the bus and its traffic.
//!
//! [`frame`] says what a frame is, [`bits`] how long it is on the wire, [`bus`] who wins, who hears it and who counts
//! errors, [`event`] what nodes are told, [`traffic`] puts load and recordings on it. Chips join through [`Bus::attach`].
//!
//! Source: Bosch CAN 2.0 (1991) parts A and B, ISO 11898-1:2015 for the rules that Bosch left open.
//! Not supported: CAN FD, overload frames, errors between the receivers' and the transmitter's accept point.

pub mod bits;
pub mod bus;
pub mod event;
pub mod frame;
pub mod traffic;

pub use bus::Bus;
pub use event::{Aborted, BusError, BusStats, ErrorCounters, Event, EventKind, NodeId, NodeMode, Tag};
pub use frame::{ExtendedId, Frame, Id, StandardId};
pub use protocol_core::states::Confinement;
pub use traffic::{LoadGenerator, Participant, Replay};
