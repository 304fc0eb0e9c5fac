//! What the firmware knows of the instrument itself, gathered for the cluster, which decides what is said.

use cluster::Conditions;
use cluster::own::Restart;
use pico::{Boot, Reset};
use protocol_core::Millis;

use crate::recognition::Recognition;

/// Gathers what is known now.
pub fn gather(controller_answers: bool, recognition: &Recognition, boot: &Boot, now: Millis) -> Conditions {
    let restart = match (&boot.note, boot.reset) {
        (Some(note), _) => Some(Restart::Panic(u16::try_from(note.line).ok())),
        (None, Reset::Watchdog) => Some(Restart::Watchdog),
        (None, Reset::Power | Reset::Pin | Reset::Panic) => None,
    };
    Conditions { controller_missing: !controller_answers, restart, search: recognition.state(now) }
}
