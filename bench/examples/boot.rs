//! Boots a firmware image on the bench and tells what it did.
//!
//! `cargo run -p bench --example boot -- ELF [MILLISECONDS [LOG [PICTURE.png]]]`

use anyhow::{Context, Result};
use bench::log::Log;
use bench::rig::{PanelKind, Rig, RigOptions};
use bench::time::Nanos;
use protocol_core::link::Record;
use std::path::Path;
use std::time::Instant;

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let elf = arguments.next().context("name the ELF: boot ELF [MILLISECONDS [LOG [PICTURE.png]]]")?;
    let span = match arguments.next() {
        Some(text) => Nanos::from_millis(text.parse().with_context(|| format!("{text} is no number"))?),
        None => Nanos::from_millis(1_000),
    };
    let panel = if std::env::var_os("ST7789").is_some() { PanelKind::St7789 } else { PanelKind::Ili9341 };
    let mut rig = Rig::new(Path::new(&elf), &RigOptions { panel, ..RigOptions::default() })?;
    if let Some(log) = arguments.next().filter(|log| log != "-") {
        rig.replay(&Log::read_file(Path::new(&log))?, true);
    }

    let clock = Instant::now();
    let outcome = rig.run_for(span);
    let host = clock.elapsed().as_secs_f64();

    for (at, record) in rig.records() {
        match record {
            Record::Values { .. } => {}
            record => println!("{at} {record:?}"),
        }
    }
    let board = rig.board();
    for (at, violation) in board.panel().violations().first() {
        println!("{at} panel: {violation:?}");
    }
    for (at, violation) in board.mcp2515().violations().first() {
        println!("{at} mcp2515: {violation:?}");
    }
    println!("mcp2515: {:?} {:?}", board.mcp2515().mode(), board.mcp2515().bit_timing());
    println!("mcp2515: {:?}", board.mcp2515().counters());
    println!("panel: {:?}", board.panel().counters());
    println!(
        "panel: on {}, undrawn {}, flickered {}, last change {:?}",
        board.panel().is_display_on(),
        board.panel().undrawn_pixels(),
        board.panel().flickered_pixels(),
        board.panel().last_change()
    );
    println!("back-light: {:?}", board.backlight());
    println!("link: {} bytes, {} damaged records", board.uart().len(), rig.damaged_records());
    println!("chip: {:?}", rig.chip().stats());
    println!("virtual {} in {host:.2} s, {:.2} times real time", rig.now(), rig.now().as_secs_f64() / host);
    let picture = arguments.next().unwrap_or_else(|| "boot.png".into());
    std::fs::write(&picture, rig.picture_png()).with_context(|| format!("cannot write {picture}"))?;
    Ok(outcome?)
}
