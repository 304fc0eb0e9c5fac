//! What is chosen when the image is built.

use cluster::{Access, Instrument, Options};
use protocol_core::generated::{SHIPPED_VEHICLES, VEHICLES};
use protocol_core::vehicle::Vehicle;

/// The controller never drives the bus, not even to acknowledge.
pub const LISTEN_ONLY: bool = cfg!(feature = "listen-only");

/// The vehicle that this image is for; whoever builds sets `CLUSTER_VEHICLE` to its name, or leaves it out.
const FIXED: Option<&Vehicle> = match option_env!("CLUSTER_VEHICLE") {
    Some(name) => Some(named(name)),
    None => None,
};

const OPTIONS: Options =
    Options { hvac_alarm: cfg!(feature = "hvac-alarm"), may_upgrade: cfg!(feature = "remote-upgrade") };

/// Returns the instrument to start with.
pub const fn instrument() -> Instrument {
    match FIXED {
        Some(vehicle) => Instrument::fixed(vehicle, OPTIONS),
        None => Instrument::searching(SHIPPED_VEHICLES, OPTIONS),
    }
}

/// How the controller starts.
pub const FIRST_ACCESS: Access = match FIXED {
    Some(vehicle) => Access::fixed(vehicle),
    None => Access::searching(SHIPPED_VEHICLES),
};

const fn named(name: &str) -> &'static Vehicle {
    let mut index = 0;
    while index < VEHICLES.len() {
        if is_same(VEHICLES[index].name.as_bytes(), name.as_bytes()) {
            return VEHICLES[index];
        }
        index += 1;
    }
    panic!("CLUSTER_VEHICLE is not the name of a folder in vehicles/")
}

const fn is_same(a: &[u8], b: &[u8]) -> bool {
    let mut index = 0;
    while index < a.len() && index < b.len() && a[index] == b[index] {
        index += 1;
    }
    index == a.len() && index == b.len()
}
