//! The virtual bench: an emulated RP2040, the chips on its pins, a CAN bus.
//!
//! Owns virtual time and everything outside the firmware: the RP2040 engine ([`rp2040`]), the chip models
//! ([`chips`]) and the CAN bus between nodes ([`can`]). It loads the ELF that goes to the board, unmodified, and
//! never links firmware code. There is no wall clock here: two runs of the same inputs are equal to the cycle.

#![forbid(unsafe_code)]

pub mod can;
pub mod chips;
pub mod flash;
pub mod join;
pub mod latency;
pub mod log;
pub mod pins;
pub mod printable;
pub mod recent;
pub mod rig;
pub mod rp2040;
pub mod scenario;
pub mod switches;
pub mod time;
