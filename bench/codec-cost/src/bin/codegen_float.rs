//! dbc-codegen as its documentation shows it: physical values, floats where the factor is no integer.

#![no_std]
#![no_main]

use codec_cost::{Physical, Values, table};

#[allow(dead_code, clippy::all)]
mod theirs {
    include!(concat!(env!("OUT_DIR"), "/theirs.rs"));
}

include!(concat!(env!("OUT_DIR"), "/codegen_float.rs"));
