//! Measures the firmware on the bench: the figures that the README quotes.
//!
//! Counts and virtual times only, so that two machines print the same. What depends on the machine (how fast the
//! engine is) is printed beside the table, not in it.

use crate::out::say;
use crate::{firmware, workspace};
use anyhow::{Context, Result, bail};
use bench::can::{Id, LoadGenerator};
use bench::latency::{self, Change, Traffic};
use bench::log::Log;
use bench::rig::{Rig, RigOptions};
use bench::rp2040::Stats;
use bench::time::Nanos;
use clap::Args;
use std::path::Path;
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
    let log = Log::read_file(&workspace::root().join("vehicles/citybus/captures/city.log"))?;
    let started = Instant::now();
    let mut rows = Vec::new();
    let mut virtual_time = start_up(&elf, &mut rows)?;
    virtual_time += drive(&elf, &log, &mut rows)?;
    virtual_time += full_load(&elf, &log, &mut rows)?;
    let ratio = virtual_time.as_secs_f64() / started.elapsed().as_secs_f64();
    latency(&elf, &log, &mut rows)?;
    let (flash, ram) = firmware::footprint(&elf)?;
    rows.push((
        "flash, static RAM",
        format!("{:.1} KiB, {:.1} KiB", flash as f64 / 1024.0, ram as f64 / 1024.0),
    ));
    let version = workspace::capture(Command::new("rustc").arg("--version"))?;
    let compiler = version.split(" (").next().unwrap_or_default();
    let table = table(&rows, compiler);
    say!("{}", table.trim_end())?;
    say!("(engine: {ratio:.2} times as fast as real time on this machine)")?;
    quote(&table, compiler, options.check)
}

fn start_up(elf: &Path, rows: &mut Vec<Row>) -> Result<Nanos> {
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

fn drive(elf: &Path, log: &Log, rows: &mut Vec<Row>) -> Result<Nanos> {
    let mut rig = Rig::new(elf, &RigOptions::default())?;
    rig.run_for(Nanos::from_millis(500))?;
    let alone = rig.chip().stats();
    rig.run_for(Nanos::from_secs(2))?;
    let asleep_alone = asleep(&alone, &rig.chip().stats());
    rig.replay(log, false);
    let before = rig.board().panel();
    let (bytes, changed, chip) = (before.counters().bytes, before.changed_pixels(), rig.chip().stats());
    rig.run_for(log.duration() + Nanos::from_millis(1_500))?;
    let lost = log.entries.len() as u64 - u64::from(rig.health().frames_received);
    rows.push(("frames of the 60 s city drive: sent, lost", format!("{}, {lost}", log.entries.len())));
    let panel = rig.board().panel();
    let (bytes, changed) = (panel.counters().bytes - bytes, panel.changed_pixels() - changed);
    rows.push((
        "panel bytes of that drive, against the 2 that each changed pixel takes",
        format!("{bytes}, {:.2} times", bytes as f64 / (2 * changed) as f64),
    ));
    rows.push((
        "pixels that left their colour and came back to it within one picture of that drive",
        panel.flickered_pixels().to_string(),
    ));
    rows.push((
        "processor asleep: no vehicle for 2 s, that drive",
        format!("{asleep_alone:.1} %, {:.1} %", asleep(&chip, &rig.chip().stats())),
    ));
    Ok(rig.now())
}

/// What is sent without a pause.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Flood {
    /// Frames of an identifier that no vehicle has, in the pauses of the drive.
    Strangers,
    /// The drive's own frames.
    Own,
}

/// What [`FLOODED`] of a bus without a pause did.
struct Load {
    seen: u64,
    lost: u64,
    bytes: u64,
    longest_low: Nanos,
    asleep: f64,
    took: Nanos,
}

/// How long a bus is kept without a pause.
const FLOODED: Nanos = Nanos::from_secs(20);

fn full_load(elf: &Path, log: &Log, rows: &mut Vec<Row>) -> Result<Nanos> {
    let [strangers, own] = [flood(elf, log, Flood::Strangers)?, flood(elf, log, Flood::Own)?];
    let counts = |load: &Load| format!("{}, {}", load.seen, load.lost);
    rows.push(("frames in 20 s of full load, 250 kbit/s, no vehicle's: seen, lost", counts(&strangers)));
    rows.push(("frames in 20 s of full load, the drive's back to back: seen, lost", counts(&own)));
    rows.push((
        "processor asleep at these two loads",
        format!("{:.1} %, {:.1} %", strangers.asleep, own.asleep),
    ));
    let low = |load: &Load| format!("{:.0} us", load.longest_low.0 as f64 / 1e3);
    rows.push((
        "longest time with INT low in these 20 s (a sample)",
        format!("{}, {}", low(&strangers), low(&own)),
    ));
    let bytes = strangers.bytes as f64 / strangers.seen as f64;
    rows.push(("SPI bytes per received frame at the first, sending included", format!("{bytes:.2}")));
    Ok(strangers.took + own.took)
}

fn flood(elf: &Path, log: &Log, flood: Flood) -> Result<Load> {
    let mut rig = Rig::new(elf, &RigOptions::default())?;
    rig.run_for(Nanos::from_millis(2_500))?;
    let node = rig.board_mut().bus_mut().attach("flood");
    match flood {
        Flood::Strangers => {
            let id = Id::extended(0x1FFF_FFF0).context("a 29-bit identifier")?;
            rig.board_mut().join(LoadGenerator::sequenced(node, id));
            rig.replay(log, true);
        }
        Flood::Own => {
            rig.board_mut().join(LoadGenerator::of_recording(node, log.recording()));
        }
    }
    let (before, chip) = (rig.board().mcp2515().counters(), rig.chip().stats());
    rig.run_for(FLOODED)?;
    let after = rig.board().mcp2515().counters();
    Ok(Load {
        seen: after.frames_seen - before.frames_seen,
        lost: after.frames_overrun.iter().sum::<u64>() + u64::from(rig.health().ring_overflows),
        bytes: after.spi_bytes - before.spi_bytes,
        longest_low: longest_low(&rig),
        asleep: asleep(&chip, &rig.chip().stats()),
        took: rig.now(),
    })
}

/// Changes that are measured of each kind.
const CHANGES: usize = 60;

fn latency(elf: &Path, log: &Log, rows: &mut Vec<Row>) -> Result<()> {
    let measured = |change| -> Result<String> {
        let times = latency::measure(elf, log, change, Traffic::Standing, CHANGES)?;
        let ms = |time: Nanos| time.as_secs_f64() * 1e3;
        Ok(format!("{:.1} / {:.1} ms", ms(times.median()), ms(times.worst())))
    };
    rows.push((
        "end of a frame to its last pixel, standing bus, median / worst of 60: gear",
        measured(Change::Gear)?,
    ));
    rows.push(("the same: a fault's lamps and line", measured(Change::Fault)?));
    rows.push((
        "the same: speed with its pointer, 48 to 49, 119 to 188 km/h",
        format!("{}, {}", measured(Change::Speed)?, measured(Change::Dial)?),
    ));
    Ok(())
}

/// Returns how much of the time between two looks the processor slept, in percent.
fn asleep(from: &Stats, to: &Stats) -> f64 {
    100.0 * (to.cycles_asleep - from.cycles_asleep) as f64 / (to.cycles - from.cycles) as f64
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
