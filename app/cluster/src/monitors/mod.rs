//! The timing machines: who is due when, file by file.
//!
//! Owns one of each that has a memory and feeds them; the rules are in the files.

mod buzzer;
mod charger;
pub(crate) mod hv_off;
pub(crate) mod hvac;
pub(crate) mod limp;
pub(crate) mod reverse;

use crate::reception::Reception;
use buzzer::Buzzer;
use charger::Charger;
use hv_off::HvOff;
use protocol_core::Millis;
use protocol_core::model::Value;
use protocol_core::vehicle::{Node, Vehicle};

/// What whoever builds the cluster may switch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Tells that a running air conditioning has lost its link (BUS-23: off by default).
    pub hvac_alarm: bool,
    /// Consent to remote upgrades: without it the cluster forbids them always (JL-36).
    pub may_upgrade: bool,
}

impl Options {
    /// Nothing is switched on.
    pub const NONE: Self = Self { hvac_alarm: false, may_upgrade: false };
}

/// One of each machine.
#[derive(Clone)]
pub(crate) struct Timers {
    pub(crate) options: Options,
    pub(crate) hv_off: HvOff,
    pub(crate) charger: Charger,
    pub(crate) buzzer: Buzzer,
}

impl Timers {
    pub(crate) const fn new(options: Options, vehicle: &Vehicle) -> Self {
        Self {
            options,
            hv_off: HvOff::new(vehicle.rules.hv_off),
            charger: Charger::new(),
            buzzer: Buzzer::new(),
        }
    }

    /// Feeds the machines with what is known now; to be called after every frame and every tick.
    pub(crate) fn observe(&mut self, vehicle: &Vehicle, reception: &Reception, now: Millis) {
        let shown = |value| reception.shown(vehicle, value, now);
        self.hv_off.observe(shown(Value::BatteryHvOffRequest), shown(Value::ContactorMain), now);
        let last_sign = reception.last_sign(vehicle, Node::Charger);
        self.charger.observe(vehicle.rules.charger_loss_ms, shown(Value::ChargePlug), last_sign, now);
        self.buzzer.observe(shown(Value::VehicleBuzzer), now);
    }
}
