//! What an instrument knows: state, freshness, faults, telltales, what to send.
//!
//! Pure logic between frames and pixels: frames, inputs and the time go in, a [`View`], a [`Chime`] and frames to send
//! come out. No hardware, no clock, no allocation, no identifiers: vehicles are tables in `protocol-core`.
//!
//! Where a rule lives: `sources` (what puts a line on the screen), `telltales`, `chime` (sounds), `inputs` (own
//! wires), `texts` (all words), each a table; `hv_off`, `limp`, `charger`, `hvac`, `buzzer`, `reverse` (timing), each a
//! small machine; `own` (what the instrument says of itself); `navigator` (which page, what turns it).

#![no_std]
#![forbid(unsafe_code)]

mod buzzer;
mod charge;
mod charger;
pub mod chime;
mod cluster;
mod debounce;
mod decisions;
mod facts;
mod faults;
pub mod history;
mod hv_off;
mod hvac;
pub mod inputs;
pub mod instrument;
mod limp;
mod navigator;
mod odometer;
pub mod own;
mod press;
mod reception;
mod reverse;
mod settings;
mod sources;
mod start;
pub mod telltales;
pub mod texts;
mod timers;
mod transmit;
mod trip;
pub mod view;

pub use chime::{Chime, Sound};
pub use cluster::Cluster;
pub use history::{Entry, Source};
pub use inputs::{Button, Buttons, Contacts, Controller, Inputs, Key};
pub use instrument::{Access, Instrument};
pub use reception::{Counters, MAX_MESSAGES, Received};
pub use telltales::{Place, Telltale, TelltaleColour, Telltales};
pub use timers::Options;
pub use transmit::MAX_SENT;
pub use view::page::{Page, Trip};
pub use view::{View, page};
