//! Our getters: raw value and integer scale, as the others give it.

#![no_std]
#![no_main]

use codec_cost::{Values, table};
use protocol_core::generated::citybus;

include!(concat!(env!("OUT_DIR"), "/ours.rs"));
