//! The cluster's own wires: from the board's parts to what the instrument takes in.
//!
//! Everything goes through as it is, bounces too. This board has no key switch, and wires some of the contacts: what has
//! no wire is not known, and said to be so.

use cluster::{Contacts, Controller, Inputs};
use pico::{BodyWires, Buttons, Gauges, Measured};

/// The board's inputs, and what changes slowly as of the last [`Self::look`].
pub struct Wires {
    buttons: Buttons,
    body: BodyWires,
    gauges: Gauges,
    measured: Measured,
    controller: Option<Controller>,
}

impl Wires {
    /// Takes the board's parts.
    pub fn new(buttons: Buttons, body: BodyWires, mut gauges: Gauges) -> Self {
        let measured = gauges.measure();
        Self { buttons, body, gauges, measured, controller: None }
    }

    /// Looks at what changes slowly.
    pub fn look(&mut self, controller: Controller) {
        self.measured = self.gauges.measure();
        self.controller = Some(controller);
    }

    /// Takes a sample of every wire; to be called every tick.
    pub fn sample(&mut self) -> Inputs {
        let [next, menu] = self.buttons.held();
        let Measured { supply_decivolts, air_front_centimpa, air_rear_centimpa } = self.measured;
        Inputs {
            key: None,
            contacts: Contacts::closed(self.body.closed()),
            unwired: Contacts::closed(self.body.wired()).others(),
            supply_decivolts,
            air_front_centimpa,
            air_rear_centimpa,
            buttons: cluster::Buttons { next, menu },
            controller: self.controller,
        }
    }
}
