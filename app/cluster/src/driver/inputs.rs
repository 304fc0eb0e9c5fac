//! The cluster's own wires: what comes in without a bus, as plain data.
//!
//! Owns the list of contacts and files every input as a local model value, so that telltales, faults and sent messages
//! read them like anything else. Refuses to know pins, dividers and bouncing.
//! Source: bus document, Meter1 BYTE1 to BYTE7; BUS-R128, BUS-94 to BUS-96.

use protocol_core::model::{Reading, Readings, Value};
use protocol_core::states::Confinement;

pub use protocol_core::states::Key;

/// Which contacts are closed, each known by the model value that it says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Contacts(u32);

impl Contacts {
    /// Every contact that a vehicle may have; a board wires some of them. Open is the usual case: a closed door, a
    /// released brake, a lamp that is off.
    pub const ALL: &'static [Value] = &[
        Value::BodyDoorFront,
        // Stays open on a two-door bus (BUS-R128).
        Value::BodyDoorMiddle,
        Value::BodyDoorRear,
        Value::BodyDoorHatch,
        Value::BodyParkingBrake,
        Value::BodySmoke,
        Value::BodySeatEmpty,
        Value::BodyHorn,
        Value::BodyLowBeam,
        Value::BodyHighBeam,
        Value::BodyBrakeLamp,
        // Blinking as the flasher does.
        Value::BodyTurnRight,
        Value::BodyTurnLeft,
        Value::BodyHazard,
        Value::BodyFrontFog,
        Value::BodyRearFog,
        Value::BodySideLamp,
    ];

    /// Returns the contacts of which these are closed; a value that is no contact's changes nothing.
    pub fn closed(values: impl IntoIterator<Item = Value>) -> Self {
        values.into_iter().fold(Self::default(), |mut contacts, value| {
            contacts.set(value, true);
            contacts
        })
    }

    /// Closes or opens the contact of `value`; a value that is no contact's changes nothing.
    pub fn set(&mut self, value: Value, is_closed: bool) {
        let bit = Self::bit(value);
        self.0 = if is_closed { self.0 | bit } else { self.0 & !bit };
    }

    /// Returns whether the contact of `value` is closed.
    pub fn is_closed(self, value: Value) -> bool {
        self.0 & Self::bit(value) != 0
    }

    /// Returns the contacts that are not among these.
    pub fn others(self) -> Self {
        let all = Self::closed(Self::ALL.iter().copied());
        Self(all.0 & !self.0)
    }

    fn bit(value: Value) -> u32 {
        Self::ALL.iter().position(|known| *known == value).map_or(0, |place| 1 << place)
    }

    /// Returns the contacts as bits, bit n = n-th of [`Self::ALL`]; 1 = closed.
    pub(crate) const fn bits(self) -> u32 {
        self.0
    }

    /// Returns the contacts of these bits.
    pub(crate) const fn of_bits(bits: u32) -> Self {
        Self(bits)
    }
}

const _: () = assert!(Contacts::ALL.len() <= u32::BITS as usize, "one bit per contact");

/// A button of the cluster.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// Silences the sound; without a sound, turns to the next page.
    Next,
    /// Turns to the next setting: language, then colours.
    Menu,
}

/// Which buttons are held down, as wired: with their bounces.
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
    /// Key position; `None` = there is no key switch to ask.
    pub key: Option<Key>,
    /// Contacts of the body.
    pub contacts: Contacts,
    /// Contacts that have no wire: whether they are closed is not known.
    pub unwired: Contacts,
    /// Low-voltage supply in 0.1 V; `None` = cannot be measured.
    pub supply_decivolts: Option<u16>,
    /// Front brake air reservoir in 0.01 MPa; `None` = no sensor, or one that is broken.
    pub air_front_centimpa: Option<u16>,
    /// Rear brake air reservoir in 0.01 MPa; `None` = no sensor, or one that is broken.
    pub air_rear_centimpa: Option<u16>,
    /// The two buttons at the panel, true = pressed.
    pub buttons: Buttons,
    /// The CAN controller; `None` = there is none to ask.
    pub controller: Option<Controller>,
}

/// Returns the reading of a yes or no.
pub(crate) fn flag(on: bool) -> Reading {
    Reading::Valid(i32::from(on))
}

fn measured(value: Option<u16>) -> Reading {
    value.map_or(Reading::Invalid, |number| Reading::Valid(i32::from(number)))
}

/// Files `inputs` as local values; what the vehicle sends on its bus has precedence over the own wire.
pub(crate) fn file(inputs: &Inputs, readings: &mut Readings) {
    let contacts = Contacts::ALL.iter().map(|&value| match inputs.unwired.is_closed(value) {
        true => (value, Reading::Invalid),
        false => (value, flag(inputs.contacts.is_closed(value))),
    });
    let others = [
        (Value::BodyKey, inputs.key.map_or(Reading::Invalid, |key| Reading::Valid(key.number()))),
        (Value::SupplyVoltage, measured(inputs.supply_decivolts)),
        (Value::AirFront, measured(inputs.air_front_centimpa)),
        (Value::AirRear, measured(inputs.air_rear_centimpa)),
    ];
    for (value, reading) in contacts.chain(others) {
        if readings.get(value).is_none_or(|(_, source)| source == Readings::LOCAL) {
            readings.set(Readings::LOCAL, value, reading);
        }
    }
}
