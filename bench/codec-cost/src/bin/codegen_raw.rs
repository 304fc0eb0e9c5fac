//! dbc-codegen's raw values with our integer scale: what a user without floats would write.

#![no_std]
#![no_main]

use codec_cost::{Values, table};

#[allow(dead_code, clippy::all)]
mod theirs {
    include!(concat!(env!("OUT_DIR"), "/theirs.rs"));
}

include!(concat!(env!("OUT_DIR"), "/codegen_raw.rs"));
