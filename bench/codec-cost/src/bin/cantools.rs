//! cantools' generated C with our integer scale, compiled by arm-none-eabi-gcc.

#![no_std]
#![no_main]

use codec_cost::{Values, c_decoders, table};

c_decoders!();
