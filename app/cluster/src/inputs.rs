//! The cluster's own wires: what comes in without a bus, as plain data.
//!
//! Owns the list of inputs and the table that files them as local model values, so that lamps, faults and sent
//! messages read them like anything else. Refuses to know pins, dividers and debouncing of hardware.
//! Source: bus document, Meter1 BYTE1 to BYTE7; BUS-R128, BUS-94 to BUS-96.

use crate::own::Conditions;
use protocol_core::model::{Reading, Readings, Value};
use protocol_core::states::Confinement;

pub use protocol_core::states::Key;

/// Which doors are open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Doors {
    /// Entry door.
    pub front: bool,
    /// Middle door; stays `false` on a two-door bus (BUS-R128).
    pub middle: bool,
    /// Exit door.
    pub rear: bool,
    /// Rear hatch.
    pub hatch: bool,
}

/// Which lights are on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lights {
    /// Dipped beam.
    pub low_beam: bool,
    /// Main beam.
    pub high_beam: bool,
    /// Brake lamps.
    pub brake: bool,
    /// Right direction indicator, blinking as the flasher does.
    pub turn_right: bool,
    /// Left direction indicator, blinking as the flasher does.
    pub turn_left: bool,
    /// Hazard warning.
    pub hazard: bool,
    /// Front fog lamps.
    pub front_fog: bool,
    /// Rear fog lamps.
    pub rear_fog: bool,
    /// Side lamps.
    pub side: bool,
}

/// A button of the cluster.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// Silences the sound; without a sound, turns to the next page.
    Next,
    /// Turns to the next setting: language, then colours.
    Menu,
}

/// Which buttons are held down, as wired; bouncing is filtered here.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Buttons {
    /// [`Button::Next`].
    pub next: bool,
    /// [`Button::Menu`].
    pub menu: bool,
}

/// How the CAN controller is; counters since power-on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Controller {
    /// Fault confinement; `None` = not started, or not answering.
    pub state: Option<Confinement>,
    /// Transmit error counter.
    pub transmit_errors: u8,
    /// Receive error counter.
    pub receive_errors: u8,
    /// Frames sent and acknowledged.
    pub sent: u32,
    /// Frames that the controller or the queue behind it had no room for.
    pub lost: u32,
}

/// Everything that comes in without a bus.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Inputs {
    /// Key position.
    pub key: Key,
    /// Doors.
    pub doors: Doors,
    /// Lights.
    pub lights: Lights,
    /// Nobody sits on the driver's seat.
    pub seat_empty: bool,
    /// The parking brake is set.
    pub parking_brake: bool,
    /// The smoke detector gives alarm.
    pub smoke: bool,
    /// The horn is pressed.
    pub horn: bool,
    /// Low-voltage supply in 0.1 V; `None` = cannot be measured.
    pub supply_decivolts: Option<u16>,
    /// Front brake air reservoir in 0.01 MPa; `None` = no sensor, or one that is broken.
    pub air_front_centimpa: Option<u16>,
    /// Rear brake air reservoir in 0.01 MPa; `None` = no sensor, or one that is broken.
    pub air_rear_centimpa: Option<u16>,
    /// Buttons.
    pub buttons: Buttons,
    /// The CAN controller; `None` = there is none to ask.
    pub controller: Option<Controller>,
    /// What the instrument knows of itself.
    pub conditions: Conditions,
}

/// The model value that an input is filed as, and how it is read.
type Row = (Value, fn(&Inputs) -> Reading);

const ROWS: &[Row] = &[
    (Value::BodyKey, |i| Reading::Valid(i.key.number())),
    (Value::BodyDoorFront, |i| flag(i.doors.front)),
    (Value::BodyDoorMiddle, |i| flag(i.doors.middle)),
    (Value::BodyDoorRear, |i| flag(i.doors.rear)),
    (Value::BodyDoorHatch, |i| flag(i.doors.hatch)),
    (Value::BodyParkingBrake, |i| flag(i.parking_brake)),
    (Value::BodySmoke, |i| flag(i.smoke)),
    (Value::BodySeatEmpty, |i| flag(i.seat_empty)),
    (Value::BodyHorn, |i| flag(i.horn)),
    (Value::BodyLowBeam, |i| flag(i.lights.low_beam)),
    (Value::BodyHighBeam, |i| flag(i.lights.high_beam)),
    (Value::BodyBrakeLamp, |i| flag(i.lights.brake)),
    (Value::BodyTurnRight, |i| flag(i.lights.turn_right)),
    (Value::BodyTurnLeft, |i| flag(i.lights.turn_left)),
    (Value::BodyHazard, |i| flag(i.lights.hazard)),
    (Value::BodyFrontFog, |i| flag(i.lights.front_fog)),
    (Value::BodyRearFog, |i| flag(i.lights.rear_fog)),
    (Value::BodySideLamp, |i| flag(i.lights.side)),
    (Value::SupplyVoltage, |i| measured(i.supply_decivolts)),
    (Value::AirFront, |i| measured(i.air_front_centimpa)),
    (Value::AirRear, |i| measured(i.air_rear_centimpa)),
];

/// Returns the reading of a yes or no.
pub(crate) fn flag(on: bool) -> Reading {
    Reading::Valid(i32::from(on))
}

fn measured(value: Option<u16>) -> Reading {
    value.map_or(Reading::Invalid, |number| Reading::Valid(i32::from(number)))
}

/// Files `inputs` as local values; what the vehicle sends on its bus has precedence over the own wire.
pub(crate) fn file(inputs: &Inputs, readings: &mut Readings) {
    for &(value, read) in ROWS {
        if readings.get(value).is_none_or(|(_, source)| source == Readings::LOCAL) {
            readings.set(Readings::LOCAL, value, read(inputs));
        }
    }
}
