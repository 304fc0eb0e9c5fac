//! All three vehicles whole: code, message tables, names and fault texts.

#![no_std]
#![no_main]

use codec_cost as _;
use protocol_core::Vehicle;
use protocol_core::generated::{citybus, c5ev, jiulong};

#[used]
#[unsafe(no_mangle)]
#[unsafe(link_section = ".table")]
static TABLE: [&Vehicle; 3] = [&citybus::VEHICLE, &c5ev::VEHICLE, &jiulong::VEHICLE];
