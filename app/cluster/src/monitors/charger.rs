//! A charger that falls silent while it is plugged in.
//!
//! The battery opens its relay by itself after 5 s; the driver is told why charging has ended. The time counts from
//! the charger's last word or from the plug, whichever came later. A charger that this cluster has never heard is not
//! missed: on some vehicles it speaks on another wire.
//! Source: C5-R005, C5-R006; readings C5-22, C5-41.

use protocol_core::Millis;
use protocol_core::model::Shown;

/// Since when the plug is inserted.
#[derive(Clone, Copy)]
pub(crate) struct Charger {
    plugged: Option<Millis>,
    is_lost: bool,
}

impl Charger {
    pub(crate) const fn new() -> Self {
        Self { plugged: None, is_lost: false }
    }

    /// Takes the plug as it is now known and the charger's last sign of life; `rule_ms` = silence that ends a charge.
    pub(crate) fn observe(
        &mut self,
        rule_ms: Option<u32>,
        plug: Shown<i32>,
        last_sign: Option<Millis>,
        now: Millis,
    ) {
        match plug {
            Shown::Value(1) => self.plugged = self.plugged.or(Some(now)),
            Shown::Value(_) => self.plugged = None,
            Shown::Never | Shown::Stale | Shown::Invalid => {}
        }
        let waits_from = self.plugged.zip(last_sign).map(|(plugged, last)| plugged.max(last));
        let is_plugged = plug == Shown::Value(1);
        let silence = waits_from.map(|from| now.since(from)).zip(rule_ms);
        self.is_lost = is_plugged && silence.is_some_and(|(silent_ms, most)| silent_ms >= u64::from(most));
    }

    /// Returns whether the charger has been silent for too long.
    pub(crate) fn is_lost(self) -> bool {
        self.is_lost
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::vec::Vec;

    #[derive(Clone, Copy, Debug)]
    struct Moment {
        at: u64,
        plug: Shown<i32>,
        heard: bool,
    }

    /// The naive statement: the last 5 s saw the plug in and heard no charger, which had spoken before.
    fn stated(history: &[Moment]) -> bool {
        let Some(last) = history.last() else { return false };
        let spoken = history.iter().filter(|moment| moment.plug.value().is_some());
        let plug: Vec<_> = spoken.map(|moment| (moment.at, moment.plug == Shown::Value(1))).collect();
        let out = plug.iter().rposition(|(_, is_in)| !is_in).map_or(0, |at| at + 1);
        let Some(&(plugged, _)) = plug.get(out) else { return false };
        let heard = history.iter().rfind(|moment| moment.heard).map(|moment| moment.at);
        last.plug == Shown::Value(1)
            && heard.is_some_and(|heard| last.at - heard >= 5_000)
            && last.at - plugged >= 5_000
    }

    #[test]
    fn c5_r005_c5_41_every_history_of_plug_and_charger_goes_as_stated() {
        fn live(machine: Charger, last_sign: Option<Millis>, past: &[Moment], depth: u32) {
            if depth == 0 {
                return;
            }
            for step in [10, 4_990, 5_000] {
                let at = past.last().map_or(0, |moment| moment.at) + step;
                for plug in [Shown::Value(1), Shown::Value(0), Shown::Stale] {
                    for heard in [false, true] {
                        let mut machine = machine;
                        let last_sign = if heard { Some(Millis(at)) } else { last_sign };
                        machine.observe(Some(5_000), plug, last_sign, Millis(at));
                        let mut history = past.to_vec();
                        history.push(Moment { at, plug, heard });
                        assert_eq!(machine.is_lost(), stated(&history), "{history:?}");
                        live(machine, last_sign, &history, depth - 1);
                    }
                }
            }
        }
        live(Charger::new(), None, &[], 4);
    }
}
