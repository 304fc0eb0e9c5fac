//! Frames, generated codecs, the vehicle-neutral model and the PC link's records.
//!
//! Shared by the firmware, the bench and the tools. Pure data and pure functions: no allocation, no hardware, no
//! clock (time comes in as [`Millis`]), no floats. What the bytes of a message mean is generated from
//! `vehicles/<name>/` by `cargo xtask codegen`; nothing here knows an identifier.

#![no_std]
#![forbid(unsafe_code)]

pub mod checksum;
pub mod codec;
pub mod frame;
#[cfg(feature = "vehicles")]
pub mod generated;
pub mod link;
pub mod model;
pub mod states;
pub mod stream;
pub mod time;
pub mod unit;
pub mod vehicle;

pub use frame::{CanFrame, CanId};
pub use model::{Reading, Readings, Severity, Shown, Value};
pub use time::Millis;
pub use vehicle::{RxMessage, Vehicle};
