//! The city bus (纯电动客车).

mod controls;
pub(crate) mod faults;
mod hears;
mod spec;
mod wire;

use crate::vehicle::{Controls, Definition};
use protocol_core::generated::citybus::MESSAGES;

/// The city bus.
pub(crate) static VEHICLE: Definition = Definition {
    name: "citybus",
    spec: &spec::SPEC,
    messages: MESSAGES,
    sheets: wire::SHEETS,
    unprinted: wire::UNPRINTED,
    hears: hears::HEARS,
    controls: Controls { has: controls::HAS, own: controls::OWN },
};
