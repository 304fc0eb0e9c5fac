//! Every message of all three vehicles, all signals: read with validity, and written.

#![no_std]
#![no_main]
#![allow(clippy::unnecessary_cast, reason = "a signal of 32 bits gives an i64, all others an i32")]

use codec_cost::INVALID;

/// Most signals of one message.
const MOST_SIGNALS: usize = 64;

type Every = [i32; MOST_SIGNALS];
type Codec = (fn(&[u8; 8], &mut Every), fn(&Every) -> [u8; 8]);

include!(concat!(env!("OUT_DIR"), "/every.rs"));

#[used]
#[unsafe(no_mangle)]
#[unsafe(link_section = ".table")]
static TABLE: [&[Codec]; 3] = [&citybus::ROWS, &c5ev::ROWS, &jiulong::ROWS];
