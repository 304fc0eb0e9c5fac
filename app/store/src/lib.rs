//! Keeps small records in NOR flash over any cut of power.
//!
//! A record is a key and up to [`MAX_PAYLOAD`] bytes; the newest of each key counts. Records are appended by programs
//! of one page at most, one per call, so whoever drives the store decides when each of them happens; sectors are erased
//! ahead, by the caller and when the caller likes. Refuses to know what a record means, what time it is, and how a flash
//! is written.
//!
//! | module     | knows                                                          |
//! |------------|----------------------------------------------------------------|
//! | `format`   | how a record and a sector's head lie in flash                  |
//! | `scan`     | which records of a region count                                |
//! | [`Store`]  | where the next record goes, which sector is erased next        |
//!
//! Why not a crate that is there: docs/adr/0006-store.md.

#![no_std]
#![forbid(unsafe_code)]

mod format;
mod scan;
mod store;

pub use format::{FORMAT, MAX_PAYLOAD, PAGE_BYTES, SECTOR_BYTES, SLOT_BYTES};
pub use scan::{Condition, MAX_KEYS};
pub use store::{Error, Next, Store};
