//! What the firmware itself has to tell the driver: lines that no message on the bus could bring.
//!
//! A line of the cluster goes first; these fill the place when there is none, or a lesser one.

use cluster::View;
use cluster::texts;
use cluster::view::Line;
use pico::Boot;
use protocol_core::{Millis, Severity};

use crate::recognition::Recognition;

/// How long after start a panic of the previous run is shown, in milliseconds.
const RESTARTED_MS: u64 = 10_000;

/// Time that the CAN controller has to come up before its absence is shown, in milliseconds.
const CONTROLLER_MS: u64 = 100;

/// Adds the firmware's own line to `view`, if there is one.
pub fn add(view: &mut View, controller_answers: bool, recognition: &Recognition, boot: &Boot, now: Millis) {
    let line = |severity, text, code| Line { severity, text, code, position: 1, count: 1 };
    let own = match (&boot.note, controller_answers) {
        (_, false) if now.0 >= CONTROLLER_MS => line(Severity::Warn, texts::NO_CONTROLLER, None),
        (Some(note), _) if now.0 < RESTARTED_MS => {
            line(Severity::Warn, texts::RESTARTED, u16::try_from(note.line).ok())
        }
        _ => match recognition.line(now) {
            Some((severity, text)) => line(severity, text, None),
            None => return,
        },
    };
    if view.line.is_none_or(|line| line.severity <= own.severity) {
        view.line = Some(own);
        view.severity = view.severity.max(own.severity);
    }
}
