//! The buzzer that a vehicle controller asks for, and a guard against one that never ends.
//!
//! The buzzer follows the bit. After two minutes without a break, where the document prints that, it falls silent although the bit stands, and when the
//! driver has heard it; the bit has to fall before it may sound again. Silence of the sender neither sounds nor counts
//! as a fall. The lamps go on with what they say.
//! Source: C5-R013, C5-R014; reading C5-20.

use protocol_core::Millis;
use protocol_core::model::Shown;

/// Since when the buzzer is asked for.
#[derive(Clone, Copy)]
pub(crate) struct Buzzer {
    since: Option<Millis>,
    is_asked: bool,
    /// The driver has silenced it.
    is_heard: bool,
}

impl Buzzer {
    pub(crate) const fn new() -> Self {
        Self { since: None, is_asked: false, is_heard: false }
    }

    /// Takes the bit as it is now known.
    pub(crate) fn observe(&mut self, asked: Shown<i32>, now: Millis) {
        self.is_asked = asked == Shown::Value(1);
        match asked {
            Shown::Value(1) => self.since = self.since.or(Some(now)),
            Shown::Value(_) => (self.since, self.is_heard) = (None, false),
            Shown::Never | Shown::Stale | Shown::Invalid => {}
        }
    }

    /// Silences the buzzer until its bit has fallen.
    pub(crate) fn silence(&mut self) {
        self.is_heard = self.since.is_some();
    }

    /// Returns whether the buzzer is to sound; `guard_ms` = longest sound without a break.
    pub(crate) fn sounds(self, guard_ms: Option<u32>, now: Millis) -> bool {
        let is_within = |since| guard_ms.is_none_or(|guard_ms| now.since(since) < u64::from(guard_ms));
        self.is_asked && !self.is_heard && self.since.is_some_and(is_within)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::vec::Vec;

    #[test]
    fn c5_r013_c5_20_every_history_of_the_bit_sounds_as_stated() {
        type Moment = (u64, Shown<i32>);
        /// The naive statement: asked now, and the run of ones began less than two minutes ago.
        fn stated(history: &[Moment], now: u64) -> bool {
            let said: Vec<_> = history.iter().filter(|(_, bit)| bit.value().is_some()).collect();
            let run = said.iter().rev().take_while(|(_, bit)| *bit == Shown::Value(1)).last();
            let asked = history.last().is_some_and(|(_, bit)| *bit == Shown::Value(1));
            asked && run.is_some_and(|(since, _)| now - since < 120_000)
        }
        fn live(machine: Buzzer, past: &[Moment], depth: u32) {
            if depth == 0 {
                return;
            }
            for step in [10, 60_000, 119_990, 120_000] {
                let at = past.last().map_or(0, |moment| moment.0) + step;
                for bit in [Shown::Value(1), Shown::Value(0), Shown::Stale, Shown::Invalid] {
                    let mut machine = machine;
                    machine.observe(bit, Millis(at));
                    let mut history = past.to_vec();
                    history.push((at, bit));
                    for now in [at, at + 119_999, at + 120_000] {
                        assert_eq!(
                            machine.sounds(Some(120_000), Millis(now)),
                            stated(&history, now),
                            "{now}: {history:?}"
                        );
                    }
                    live(machine, &history, depth - 1);
                }
            }
        }
        live(Buzzer::new(), &[], 4);
    }
}
