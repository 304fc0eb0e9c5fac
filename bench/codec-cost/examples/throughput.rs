//! Decodes frames on the PC as the firmware does and prints how many per second: `throughput FRAMES`.
//!
//! FRAMES holds one frame per line, `<name of the message> <16 hex digits>`; the witness reads the same file.

use protocol_core::Readings;
use protocol_core::generated::citybus::VEHICLE;
use std::hint::black_box;
use std::time::Instant;

/// Passes over the file: the PC needs some to have time to measure.
const PASSES: u32 = 2_000;

fn frame(line: &str) -> Option<(u8, [u8; 8])> {
    let (name, hex) = line.split_once(' ')?;
    let index = VEHICLE.rx.iter().position(|row| row.name == name)?;
    Some((index as u8, u64::from_str_radix(hex, 16).ok()?.to_be_bytes()))
}

fn main() {
    let path = std::env::args().nth(1).expect("a file of frames");
    let text = std::fs::read_to_string(path).expect("the file can be read");
    let frames: Vec<(u8, [u8; 8])> =
        text.lines().map(|line| frame(line).expect("a message and 8 bytes")).collect();
    let mut readings = Readings::new();
    let started = Instant::now();
    for _ in 0..PASSES {
        for (index, data) in &frames {
            (black_box(VEHICLE.decode))(*index, black_box(data), black_box(&mut readings));
        }
    }
    let seconds = started.elapsed().as_secs_f64();
    println!("{:.0}", f64::from(PASSES) * frames.len() as f64 / seconds);
}
