//! The car (C5EV).

mod controls;
pub(crate) mod faults;
mod hears;
mod spec;
mod wire;

use crate::vehicle::{Controls, Definition};
use protocol_core::generated::c5ev::MESSAGES;

/// The car.
pub(crate) static VEHICLE: Definition = Definition {
    name: "c5ev",
    spec: &spec::SPEC,
    messages: MESSAGES,
    sheets: wire::SHEETS,
    unprinted: wire::UNPRINTED,
    hears: hears::HEARS,
    controls: Controls { has: controls::HAS, own: controls::OWN },
};
