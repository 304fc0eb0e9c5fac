//! What the cluster decides by itself, for the messages that it sends.
//!
//! Functions of what is known now. What is not known is no decision: it goes out as "not available", or as the safe value
//! that the vehicle's table gives. Source: BUS-R129 with BUS-93, JL-R026, JL-R031 with JL-36.

use crate::driver::inputs::flag;
use protocol_core::model::{Gear, Reading, Shown, Value};

/// Versions that the cluster tells the vehicle, 0 to 255 (JL-R026).
const HARDWARE: i32 = 1;
const SOFTWARE: i32 = 1;

/// What the decisions need beside the values.
pub(crate) struct Known {
    /// The driver has left the seat in a driving gear; `None` = no seat contact.
    pub(crate) driver_left: Option<bool>,
    /// Total distance in 1/8 km; `None` = what was driven before power-on is not known.
    pub(crate) odometer_km8: Option<u32>,
    /// A person has consented to remote upgrades.
    pub(crate) may_upgrade: bool,
}

/// Returns whether the driver has left the seat, if `before` tells whether he had: an unknown gear ends nothing.
pub(crate) fn has_left(before: bool, seat_empty: Shown<i32>, gear: Option<Gear>) -> bool {
    seat_empty == Shown::Value(1) && gear.map_or(before, Gear::drives)
}

/// Returns every decision.
pub(crate) fn of(known: Known, shown: impl Fn(Value) -> Shown<i32>) -> [(Value, Reading); 5] {
    let gear = shown(Value::VehicleGear).value().and_then(Gear::from_number);
    // Who may be upgraded is known, not guessed (JL-36): speed, gear and drive, each by a fresh value of its own.
    let standing = shown(Value::VehicleSpeed) == Shown::Value(0);
    let parked = matches!(gear, Some(Gear::N | Gear::P));
    let not_ready = shown(Value::VehicleReady) == Shown::Value(0);
    let is_allowed = known.may_upgrade && standing && parked && not_ready;
    [
        (Value::ClusterDriverLeft, known.driver_left.map_or(Reading::Invalid, flag)),
        (Value::ClusterUpgradeForbidden, flag(!is_allowed)),
        (Value::ClusterOdometer, known.odometer_km8.map_or(Reading::Invalid, distance)),
        (Value::ClusterHardware, Reading::Valid(HARDWARE)),
        (Value::ClusterSoftware, Reading::Valid(SOFTWARE)),
    ]
}

fn distance(km8: u32) -> Reading {
    Reading::Valid(i32::try_from(km8).unwrap_or(i32::MAX))
}
