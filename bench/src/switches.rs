//! The vehicle's switches on the cluster's contacts: pin by pin, as docs/wiring.md has them.
//!
//! The rig closes the pins, the runs on the host close the contacts. Refuses to know the board's own table: it is
//! checked by this one.

use protocol_core::Value;
use virtual_vehicle::World;

/// A switch of the vehicle, to ground.
pub struct Switch {
    /// GPIO of the Pico.
    pub pin: u8,
    /// What a closed one says.
    pub value: Value,
    /// Returns whether it is closed.
    pub is_closed: fn(&World) -> bool,
}

const fn switch(pin: u8, value: Value, is_closed: fn(&World) -> bool) -> Switch {
    Switch { pin, value, is_closed }
}

/// Every switch.
pub const SWITCHES: &[Switch] = &[
    switch(4, Value::BodyDoorFront, |world| world.body.front_door),
    switch(5, Value::BodyDoorRear, |world| world.body.rear_door),
    switch(6, Value::BodySeatEmpty, |world| world.driver.seat_empty),
    switch(7, Value::BodyParkingBrake, |world| world.driver.parking_brake),
    switch(14, Value::BodySmoke, |world| world.body.smoke),
    switch(21, Value::BodyTurnLeft, |world| world.body.turn_left),
    switch(22, Value::BodyTurnRight, |world| world.body.turn_right),
    switch(1, Value::BodyHazard, |world| world.body.hazard),
];

/// Returns what the closed switches say.
pub fn closed(world: &World) -> impl Iterator<Item = Value> {
    SWITCHES.iter().filter(|switch| (switch.is_closed)(world)).map(|switch| switch.value)
}
