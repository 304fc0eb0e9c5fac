//! The cluster's own wires: from the board's parts to what the cluster takes in.
//!
//! Contacts bounce: a change counts when it has stood for [`STEADY_TICKS`]. The buttons go through as they are, the
//! cluster filters them itself. This board has no key switch: power is what the key gives.

use cluster::{Controller, Doors, Inputs, Key, Lights};
use pico::{Body, BodyWires, Buttons, Gauges, Measured};

/// Equal samples in a row that make a level: 30 ms.
const STEADY_TICKS: u8 = 3;

/// The board's inputs and what they last said.
pub struct Wires {
    buttons: Buttons,
    body: BodyWires,
    gauges: Gauges,
    /// What counts.
    steady: Body,
    /// What the wires say, for so many ticks.
    candidate: (Body, u8),
    measured: Measured,
    controller: Option<Controller>,
}

impl Wires {
    /// Takes the board's parts.
    pub fn new(buttons: Buttons, mut body: BodyWires, mut gauges: Gauges) -> Self {
        let (steady, measured) = (body.closed(), gauges.measure());
        Self { buttons, body, gauges, steady, candidate: (steady, 0), measured, controller: None }
    }

    /// Looks at what changes slowly.
    pub fn look(&mut self, controller: Controller) {
        self.measured = self.gauges.measure();
        self.controller = Some(controller);
    }

    /// Takes a sample of every contact and returns what the cluster is told; to be called every tick.
    pub fn sample(&mut self) -> Inputs {
        let closed = self.body.closed();
        let (candidate, ticks) = self.candidate;
        let ticks = if closed == candidate { ticks.saturating_add(1) } else { 1 };
        self.candidate = (closed, ticks);
        if ticks >= STEADY_TICKS {
            self.steady = closed;
        }
        let [next, menu] = self.buttons.held();
        let Body { front_door, rear_door, seat_empty, parking_brake, smoke, turn_left, turn_right } =
            self.steady;
        let Measured { supply_decivolts, air_front_centimpa, air_rear_centimpa } = self.measured;
        Inputs {
            key: Key::On,
            doors: Doors { front: front_door, rear: rear_door, ..Doors::default() },
            lights: Lights { turn_left, turn_right, ..Lights::default() },
            seat_empty,
            parking_brake,
            smoke,
            supply_decivolts,
            air_front_centimpa,
            air_rear_centimpa,
            buttons: cluster::Buttons { next, menu },
            controller: self.controller,
            ..Inputs::default()
        }
    }
}
