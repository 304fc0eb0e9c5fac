//! The vans and buses E66 to E10 (九龙).

mod controls;
pub(crate) mod faults;
mod hears;
mod spec;
mod wire;

use crate::vehicle::{Controls, Definition};
use protocol_core::generated::jiulong::MESSAGES;

/// The vans.
pub(crate) static VEHICLE: Definition = Definition {
    name: "jiulong",
    spec: &spec::SPEC,
    messages: MESSAGES,
    sheets: wire::SHEETS,
    unprinted: wire::UNPRINTED,
    hears: hears::HEARS,
    controls: Controls { has: controls::HAS, own: controls::OWN },
};
