//! The vehicles that the laws are tried on: those of the repository, and one that does all that the documents allow.
//!
//! A test that uses this names the parts of `protocol-core` in its own root, because the generated file does.

use protocol_core::codec::MessageInfo;
use protocol_core::generated::{MESSAGES, VEHICLES};
use protocol_core::vehicle::Vehicle;
use std::path::PathBuf;

#[path = "../hostile/hostile.rs"]
#[rustfmt::skip]
#[allow(clippy::all, clippy::cast_lossless, dead_code, missing_docs, unreachable_pub, unused_imports)]
mod hostile;

/// The vehicles that were made from printed documents, so that nothing of them may be missing.
#[allow(dead_code, reason = "not every test asks")]
pub(crate) const DOCUMENTED: [&str; 4] = ["citybus", "c5ev", "example", "jiulong"];

/// One vehicle with its files.
#[allow(dead_code, reason = "not every test asks for all")]
pub(crate) struct Car {
    pub(crate) vehicle: &'static Vehicle,
    pub(crate) messages: &'static [MessageInfo],
    /// Folder of its DBC and its `vehicle.toml`, from the root of the repository.
    pub(crate) folder: String,
}

#[allow(dead_code, reason = "not every test asks for all")]
impl Car {
    /// Returns the path of one of its files.
    pub(crate) fn file(&self, name: &str) -> PathBuf {
        surroundings::root().join(&self.folder).join(name)
    }

    /// Returns the text of its `vehicle.toml`.
    pub(crate) fn binding(&self) -> String {
        let path = self.file("vehicle.toml");
        std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }
}

/// Returns every vehicle.
pub(crate) fn fleet() -> Vec<Car> {
    let messages = |vehicle: &Vehicle| {
        let found = MESSAGES.iter().find(|(name, _)| *name == vehicle.name);
        found.unwrap_or_else(|| panic!("{} has no messages", vehicle.name)).1
    };
    let known = VEHICLES.iter().map(|&vehicle| Car {
        vehicle,
        messages: messages(vehicle),
        folder: format!("vehicles/{}", vehicle.name),
    });
    let folder = "protocol-core/tests/hostile".to_owned();
    known.chain([Car { vehicle: &hostile::VEHICLE, messages: hostile::MESSAGES, folder }]).collect()
}
