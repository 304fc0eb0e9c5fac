//! Measures the firmware on the bench: the figures that the README quotes.
//!
//! Counts and virtual times only, so that two machines print the same. What depends on the machine (how fast the
//! engine is) is printed beside the table, not in it.

use crate::out::say;
use crate::{firmware, workspace};
use anyhow::{Context, Result, bail};
use bench::can::{Id, LoadGenerator};
use bench::log::Log;
use bench::rig::{Rig, RigOptions};
use bench::time::Nanos;
use clap::Args;
use std::process::Command;
use std::time::Instant;

/// What to do with the figures.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Fails if the README quotes other figures.
    #[arg(long)]
    pub check: bool,
}

const BEGIN: &str = "<!-- figures: cargo xtask figures -->\n";
const END: &str = "<!-- /figures -->";

/// A row of the table: what was measured, and the figure.
type Row = (&'static str, String);

/// Prints the figures and writes them into the README, or checks that it quotes them.
///
/// # Errors
/// If the firmware cannot be built or run, or the README quotes other figures.
pub fn run(options: &Options) -> Result<()> {
    let elf = firmware::build(&firmware::Options::default())?.elf;
    let log = Log::read_file(&workspace::root().join("vehicles/bus/captures/city.log"))?;
    let started = Instant::now();
    let mut rows = Vec::new();
    let mut virtual_time = start_up(&elf, &mut rows)?;
    virtual_time += drive(&elf, &log, &mut rows)?;
    virtual_time += full_load(&elf, &log, &mut rows)?;
    let (flash, ram) = firmware::footprint(&elf)?;
    rows.push((
        "flash, static RAM",
        format!("{:.1} KiB, {:.1} KiB", flash as f64 / 1024.0, ram as f64 / 1024.0),
    ));
    let version = workspace::capture(Command::new("rustc").arg("--version"))?;
    let compiler = version.split(" (").next().unwrap_or_default();
    let table = table(&rows, compiler);
    say!("{}", table.trim_end())?;
    let ratio = virtual_time.as_secs_f64() / started.elapsed().as_secs_f64();
    say!("(engine: {ratio:.2} times as fast as real time on this machine)")?;
    quote(&table, compiler, options.check)
}

fn start_up(elf: &std::path::Path, rows: &mut Vec<Row>) -> Result<Nanos> {
    let mut rig = Rig::new(elf, &RigOptions::default())?;
    let step = Nanos::from_micros(100);
    while rig.board().panel().visible(rig.now()).is_none() || rig.board().panel().undrawn_pixels() > 0 {
        if rig.now() > Nanos::from_secs(2) {
            bail!("the panel is still dark after 2 s");
        }
        rig.run_for(step)?;
    }
    rows.push(("power-on to a whole, lit picture", format!("{:.1} ms", rig.now().as_secs_f64() * 1e3)));
    Ok(rig.now())
}

fn drive(elf: &std::path::Path, log: &Log, rows: &mut Vec<Row>) -> Result<Nanos> {
    let mut rig = Rig::new(elf, &RigOptions::default())?;
    rig.run_for(Nanos::from_millis(500))?;
    rig.replay(log, false);
    let panel_before = rig.board().panel().counters();
    rig.run_for(log.duration() + Nanos::from_millis(1_500))?;
    let lost = log.entries.len() as u64 - u64::from(rig.health().frames_received);
    rows.push(("frames of the 60 s drive sent, lost", format!("{}, {lost}", log.entries.len())));
    let panel = rig.board().panel().counters();
    let bytes = (panel.bytes - panel_before.bytes) as f64 / log.duration().as_secs_f64();
    rows.push(("panel bytes per second of the drive (a full picture: 153 600)", format!("{bytes:.0}")));
    rows.push((
        "pixels that flickered (A, B, A within 40 ms) in that drive",
        rig.board().panel().flickered_pixels().to_string(),
    ));
    Ok(rig.now())
}

fn full_load(elf: &std::path::Path, log: &Log, rows: &mut Vec<Row>) -> Result<Nanos> {
    let mut rig = Rig::new(elf, &RigOptions::default())?;
    rig.run_for(Nanos::from_millis(500))?;
    let idle = |from: &bench::rp2040::Stats, to: &bench::rp2040::Stats| {
        100.0 * (to.cycles_asleep - from.cycles_asleep) as f64 / (to.cycles - from.cycles) as f64
    };
    let quiet = rig.chip().stats();
    rig.run_for(Nanos::from_secs(2))?;
    let asleep_quiet = idle(&quiet, &rig.chip().stats());
    let flood = rig.board_mut().bus_mut().attach("flood");
    let id = Id::extended(0x1FFF_FFF0).context("a 29-bit identifier")?;
    rig.board_mut().join(LoadGenerator::sequenced(flood, id));
    rig.replay(log, true);
    let (before, chip_before) = (rig.board().mcp2515().counters(), rig.chip().stats());
    rig.run_for(Nanos::from_secs(20))?;
    let after = rig.board().mcp2515().counters();
    let frames = after.frames_seen - before.frames_seen;
    let lost = after.frames_overrun.iter().sum::<u64>() + u64::from(rig.health().ring_overflows);
    rows.push((
        "frames at 100 % load of 250 kbit/s for 20 s while drawing: seen, lost",
        format!("{frames}, {lost}"),
    ));
    let bytes = (after.spi_bytes - before.spi_bytes) as f64 / frames as f64;
    rows.push(("SPI bytes per received frame, sending included", format!("{bytes:.2}")));
    rows.push((
        "longest time with INT low at that load",
        format!("{:.0} us", longest_low(&rig).0 as f64 / 1e3),
    ));
    let asleep = idle(&chip_before, &rig.chip().stats());
    rows.push(("processor asleep: quiet bus, that load", format!("{asleep_quiet:.1} %, {asleep:.1} %")));
    Ok(rig.now())
}

/// Returns the longest time that the MCP2515 has waited for service.
fn longest_low(rig: &Rig) -> Nanos {
    let pairs = rig.board().int_edges().windows(2);
    pairs.filter(|pair| !pair[0].1).map(|pair| pair[1].0 - pair[0].0).max().unwrap_or_default()
}

/// The head of the first column: another compiler makes another image.
fn heading(compiler: &str) -> String {
    format!("| measured on the bench, {compiler} |")
}

fn table(rows: &[Row], compiler: &str) -> String {
    let mut table = format!("{} figure |\n| --- | --- |\n", heading(compiler));
    for (what, figure) in rows {
        table.push_str(&format!("| {what} | {figure} |\n"));
    }
    table
}

fn quote(table: &str, compiler: &str, check: bool) -> Result<()> {
    let path = workspace::root().join("README.md");
    let readme = std::fs::read_to_string(&path)?;
    let (head, rest) = readme.split_once(BEGIN).context("README.md has no figures block")?;
    let (quoted, tail) = rest.split_once(END).context("the figures block of README.md has no end")?;
    if quoted == table {
        return Ok(());
    }
    if check && !quoted.starts_with(&heading(compiler)) {
        say!("README.md quotes the image of another compiler than {compiler}: not compared")?;
        return Ok(());
    }
    if check {
        bail!("README.md quotes other figures; `cargo xtask figures` writes these into it");
    }
    std::fs::write(path, format!("{head}{BEGIN}{table}{END}{tail}"))?;
    say!("README.md is updated")?;
    Ok(())
}
