//! Our getters that also say whether the value is valid, which the others leave to their users.

#![no_std]
#![no_main]

use codec_cost::{INVALID, Values, table};
use protocol_core::generated::citybus;

include!(concat!(env!("OUT_DIR"), "/judged.rs"));
