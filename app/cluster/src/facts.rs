//! What the tables of faults and telltales may ask: what was received, what the timing machines conclude from it.

use crate::monitors::Timers;
use crate::monitors::hvac;
use crate::monitors::limp::Link;
use crate::reception::{Nodes, Reception};
use protocol_core::Millis;
use protocol_core::model::{Readings, Shown, Value};
use protocol_core::vehicle::{Node, Vehicle};

/// All that is known at one moment.
#[derive(Clone, Copy)]
pub(crate) struct Facts<'a> {
    pub(crate) vehicle: &'static Vehicle,
    pub(crate) reception: &'a Reception,
    pub(crate) timers: &'a Timers,
    /// Nodes of which an expected message is missing.
    pub(crate) silent: Nodes,
    pub(crate) started: Millis,
    pub(crate) now: Millis,
}

impl Facts<'_> {
    /// Returns what may be shown of `value`.
    pub(crate) fn shown(&self, value: Value) -> Shown<i32> {
        self.reception.shown(self.vehicle, value, self.now)
    }

    /// Returns the last number of `value`, however old: for what does not change, and for what silence leaves as it
    /// was.
    pub(crate) fn last_known(&self, value: Value) -> Option<i32> {
        self.reception.last_known(value)
    }

    /// Returns whether the vehicle has sent `value` since power-on.
    pub(crate) fn is_sent(&self, value: Value) -> bool {
        self.reception.readings.get(value).is_some_and(|(_, source)| source != Readings::LOCAL)
    }

    /// Returns whether the vehicle moves; `None` = its speed is not known.
    pub(crate) fn moves(&self) -> Option<bool> {
        self.shown(Value::VehicleSpeed).value().map(|speed| speed != 0)
    }

    /// Returns how long ago `node` gave its last sign of life, in milliseconds; never = since the start.
    fn silence_ms(&self, node: Node) -> u64 {
        self.now.since(self.reception.last_sign(self.vehicle, node).unwrap_or(self.started))
    }

    /// Returns what is known of the link between battery and vehicle controller.
    pub(crate) fn link(&self) -> Link {
        Link {
            rule: self.vehicle.rules.limp,
            battery_silent_ms: self.silent.has(Node::Bms).then(|| self.silence_ms(Node::Bms)),
            vehicle_silent: self.silent.has(Node::Vcu),
        }
    }

    /// Returns whether the loss of a running air conditioning is to be told.
    pub(crate) fn has_lost_hvac(&self) -> bool {
        let was_running = self.last_known(Value::HvacOn) == Some(1);
        let rule = self.vehicle.rules.hvac_loss_ms.filter(|_| self.timers.options.hvac_alarm);
        hvac::is_lost(rule, was_running, self.silence_ms(Node::Hvac))
    }
}
