//! What the firmware runs: the vehicle's decoder, into the model, with validity, states and source.

#![no_std]
#![no_main]

use protocol_core::Readings;
use protocol_core::generated::citybus;

#[used]
#[unsafe(no_mangle)]
#[unsafe(link_section = ".table")]
static TABLE: fn(u8, &[u8; 8], &mut Readings) = citybus::VEHICLE.decode;

// The panic handler.
use codec_cost as _;
