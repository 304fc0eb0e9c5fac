//! What an instrument knows: state, freshness, faults, telltales, what to send.
//!
//! Pure logic between frames and pixels: frames, inputs and the time go in, a [`View`], a [`Chime`] and frames to send
//! come out. No hardware, no clock, no allocation, no identifiers: vehicles are tables in `protocol-core`.
//!
//! The door is [`Instrument`]. Where a rule lives: `faults` (what puts a line on the screen, what is remembered),
//! `telltales`, `chime` (sounds), `driver::inputs` (own wires), each a table; `monitors` (timing), each a small machine;
//! `instrument` (which vehicle this is, when it may send), `own` (what the instrument says of itself); `navigator` (which
//! page, what turns it); `decisions` (what is said to the vehicle); `kept` (what outlives power-off).

#![no_std]
#![forbid(unsafe_code)]

pub mod chime;
mod cluster;
mod decisions;
mod driver;
mod facts;
pub mod faults;
pub mod instrument;
pub mod kept;
mod monitors;
mod navigator;
pub mod own;
mod reception;
mod start;
pub mod telltales;
mod text;
mod transmit;
mod trips;
pub mod view;

pub use chime::{Chime, Sound};
pub use cluster::Cluster;
pub use driver::inputs;
pub use driver::inputs::{Button, Buttons, Contacts, Controller, Inputs, Key};
pub use faults::{Entry, FaultId, Named};
pub use instrument::{Access, Instrument};
pub use kept::{Memory, Part};
pub use monitors::Options;
pub use reception::{Counters, MAX_MESSAGES, Received};
pub use telltales::{Place, Telltale, TelltaleColour, Telltales};
pub use transmit::MAX_SENT;
pub use view::page::{Page, Trip};
pub use view::{View, page};
