//! What the cluster decides by itself, for the messages that it sends.
//!
//! Functions of what is known now. Source: BUS-R129 with BUS-93, JL-R026, JL-R031 with JL-36.

use crate::driver::inputs::{Inputs, flag};
use protocol_core::model::{Gear, Reading, Shown, Value};

/// Versions that the cluster tells the vehicle, 0 to 255 (JL-R026).
const HARDWARE: i32 = 1;
const SOFTWARE: i32 = 1;

/// Returns every decision.
pub(crate) fn of(
    inputs: &Inputs,
    shown: impl Fn(Value) -> Shown<i32>,
    odometer_km8: Option<u32>,
) -> [(Value, Reading); 5] {
    let gear = shown(Value::VehicleGear).value().and_then(Gear::from_number);
    let driving_gear = gear.is_some_and(Gear::drives);
    let driver_left = inputs.contacts.is_closed(Value::BodySeatEmpty) && driving_gear;
    // Who may be upgraded is known, not guessed (JL-36): speed, gear and drive, each by a fresh value of its own.
    let standing = shown(Value::VehicleSpeed) == Shown::Value(0);
    let parked = matches!(gear, Some(Gear::N | Gear::P));
    let not_ready = shown(Value::VehicleReady) == Shown::Value(0);
    [
        (Value::ClusterDriverLeft, flag(driver_left)),
        (Value::ClusterUpgradeForbidden, flag(!(standing && parked && not_ready))),
        (Value::ClusterOdometer, odometer_km8.map_or(Reading::Invalid, distance)),
        (Value::ClusterHardware, Reading::Valid(HARDWARE)),
        (Value::ClusterSoftware, Reading::Valid(SOFTWARE)),
    ]
}

fn distance(km8: u32) -> Reading {
    Reading::Valid(i32::try_from(km8).unwrap_or(i32::MAX))
}
