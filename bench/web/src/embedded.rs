//! The scenarios and golden pictures that are part of the module.

use bench::scenario::Pictures;
use bench_page::Library;
use virtual_vehicle::Kind;

include!(concat!(env!("OUT_DIR"), "/scenarios.rs"));

/// The scenarios of every vehicle.
pub(crate) fn library() -> Library {
    Library::new(|kind| {
        let of_kind = TEXTS.iter().filter(|(file, _)| file.split('/').next() == Some(kind.name()));
        of_kind.map(|(file, text)| ((*file).to_owned(), (*text).to_owned())).collect()
    })
}

/// The golden pictures of a vehicle.
pub(crate) fn pictures(kind: Kind) -> Pictures {
    let of_kind = PICTURES.iter().filter(|(vehicle, ..)| *vehicle == kind.name());
    Pictures::known(of_kind.map(|(_, name, png)| ((*name).to_owned(), png.to_vec())).collect())
}
