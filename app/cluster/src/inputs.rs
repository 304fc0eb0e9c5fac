//! The cluster's own wires: what comes in without a bus, as plain data.
//!
//! Owns the list of inputs and the table that files them as local model values, so that lamps, faults and sent
//! messages read them like anything else. Refuses to know pins, dividers and debouncing of hardware.
//! Source: bus document, Meter1 BYTE1 to BYTE7; BUS-R128, BUS-94 to BUS-96.

use protocol_core::model::{Reading, Readings, Value};

/// Key position.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Key {
    /// Locked.
    #[default]
    Lock = 0,
    /// Accessories.
    Accessory = 1,
    /// On.
    On = 2,
    /// Start.
    Start = 3,
}

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
    /// Silences the sound; without a sound, turns to the next line.
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
    pub hand_brake: bool,
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
}

/// One input and the model value that it is filed as.
struct Row {
    value: Value,
    read: fn(&Inputs) -> Reading,
}

const fn row(value: Value, read: fn(&Inputs) -> Reading) -> Row {
    Row { value, read }
}

const ROWS: &[Row] = &[
    row(Value::BodyKey, |i| Reading::Valid(i.key as i32)),
    row(Value::BodyDoorFront, |i| flag(i.doors.front)),
    row(Value::BodyDoorMiddle, |i| flag(i.doors.middle)),
    row(Value::BodyDoorRear, |i| flag(i.doors.rear)),
    row(Value::BodyDoorHatch, |i| flag(i.doors.hatch)),
    row(Value::BodyHandBrake, |i| flag(i.hand_brake)),
    row(Value::BodySmoke, |i| flag(i.smoke)),
    row(Value::BodySeatEmpty, |i| flag(i.seat_empty)),
    row(Value::BodyHorn, |i| flag(i.horn)),
    row(Value::BodyLowBeam, |i| flag(i.lights.low_beam)),
    row(Value::BodyHighBeam, |i| flag(i.lights.high_beam)),
    row(Value::BodyBrakeLamp, |i| flag(i.lights.brake)),
    row(Value::BodyTurnRight, |i| flag(i.lights.turn_right)),
    row(Value::BodyTurnLeft, |i| flag(i.lights.turn_left)),
    row(Value::BodyHazard, |i| flag(i.lights.hazard)),
    row(Value::BodyFrontFog, |i| flag(i.lights.front_fog)),
    row(Value::BodyRearFog, |i| flag(i.lights.rear_fog)),
    row(Value::BodySideLamp, |i| flag(i.lights.side)),
    row(Value::SupplyVoltage, |i| measured(i.supply_decivolts)),
    row(Value::AirFront, |i| measured(i.air_front_centimpa)),
    row(Value::AirRear, |i| measured(i.air_rear_centimpa)),
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
    for row in ROWS {
        if readings.get(row.value).is_none_or(|(_, source)| source == Readings::LOCAL) {
            readings.set(Readings::LOCAL, row.value, (row.read)(inputs));
        }
    }
}
