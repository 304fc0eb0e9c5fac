//! Code of all three vehicles: decode and encode.

#![no_std]
#![no_main]

use codec_cost as _;
use protocol_core::generated::{citybus, c5ev, jiulong};
use protocol_core::{Readings, Vehicle};

type Codec = (fn(u8, &[u8; 8], &mut Readings), fn(u8, &Readings) -> [u8; 8]);

const fn codec(vehicle: &Vehicle) -> Codec {
    (vehicle.decode, vehicle.encode)
}

#[used]
#[unsafe(no_mangle)]
#[unsafe(link_section = ".table")]
static TABLE: [Codec; 3] = [codec(&citybus::VEHICLE), codec(&c5ev::VEHICLE), codec(&jiulong::VEHICLE)];
