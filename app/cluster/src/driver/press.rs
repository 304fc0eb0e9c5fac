//! A button: short and long presses from its wire, which is sampled every tick.
//!
//! A press is reported at once, for what must not wait; whether it was short or long shows later. A press that has been
//! used is neither.

use super::debounce::Debounce;
use protocol_core::Millis;

/// How long a button is held down for a long push, in milliseconds.
const LONG_MS: u64 = 1_000;

/// A short or long press of a button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Push {
    /// The button goes down.
    Begins,
    /// It has come up before it was long.
    Short,
    /// It has been down for [`LONG_MS`].
    Long,
}

/// One button.
#[derive(Clone, Copy)]
pub(crate) struct Press {
    wire: Debounce,
    is_down: bool,
    /// When the push began that is neither short nor long yet.
    since: Option<Millis>,
}

impl Press {
    /// Returns a button that is up; one held down since power-on counts once.
    pub(crate) const fn new() -> Self {
        Self { wire: Debounce::new(0), is_down: false, since: None }
    }

    /// Takes one sample of the wire.
    pub(crate) fn sample(&mut self, down: bool, now: Millis) -> Option<Push> {
        let was_down = core::mem::replace(&mut self.is_down, self.wire.sample(down.into()) != 0);
        if self.is_down && !was_down {
            self.since = Some(now);
            return Some(Push::Begins);
        }
        let since = self.since?;
        let push = if !self.is_down {
            Push::Short
        } else if now.since(since) >= LONG_MS {
            Push::Long
        } else {
            return None;
        };
        self.since = None;
        Some(push)
    }

    /// Uses the push up: it is neither short nor long any more.
    pub(crate) fn spend(&mut self) {
        self.since = None;
    }
}
