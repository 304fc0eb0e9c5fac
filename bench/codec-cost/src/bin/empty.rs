//! The frame of every program with decoders that do nothing: what is subtracted from the others.

#![no_std]
#![no_main]

use codec_cost::{Values, table};

include!(concat!(env!("OUT_DIR"), "/empty.rs"));
