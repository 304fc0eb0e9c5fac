//! Drives the real firmware on the virtual bench.

use crate::vehicles::Tables;
use crate::{firmware, workspace};
use anyhow::{Context, Result};
use bench::log::Log;
use bench::rig::{Rig, RigOptions};
use bench::time::Nanos;
use clap::Args;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What to drive and how to show it.
#[derive(Args, Clone, Debug)]
pub struct Options {
    #[command(flatten)]
    build: firmware::Options,
    /// Recording to play on the bus, in a loop.
    #[arg(long, default_value = "vehicles/bus/captures/city.log")]
    log: PathBuf,
    /// Runs this ELF in place of building the firmware.
    #[arg(long)]
    elf: Option<PathBuf>,
    /// Serves no page: runs for `--seconds` and ends.
    #[arg(long)]
    headless: bool,
    /// Virtual seconds to run without a page.
    #[arg(long, default_value_t = 20.0, requires = "headless")]
    seconds: f64,
    /// Writes the panel's last picture to this PNG file.
    #[arg(long, requires = "headless")]
    screenshot: Option<PathBuf>,
    /// Port of the local page; 0 takes any free one.
    #[arg(long, default_value_t = 8015)]
    port: u16,
}

/// Builds the firmware, starts it on the bench and shows it.
///
/// # Errors
/// If the log or the ELF is wrong, the build fails, or the firmware does what the bench does not model.
pub fn run(options: &Options) -> Result<()> {
    let log = Log::read_file(&from_root(&options.log))?;
    let elf = match &options.elf {
        Some(elf) => elf.clone(),
        None => firmware::build(&options.build)?.elf,
    };
    let crystal_hz = match options.build.crystal {
        firmware::Crystal::Mhz8 => 8_000_000,
        firmware::Crystal::Mhz16 => 16_000_000,
    };
    // A recording does not tell its bit rate, the vehicle in it does.
    let bitrate =
        Tables::of_log(&log, None).map_or(RigOptions::default().bitrate, |tables| tables.vehicle.bitrate);
    let rig_options = RigOptions { panel: panel(options.build.panel), crystal_hz, bitrate };
    if !options.headless {
        return bench::page::serve(options.port, move || start(&elf, &rig_options, &log));
    }
    let mut rig = start(&elf, &rig_options, &log)?;
    let started = Instant::now();
    rig.run_for(Nanos((options.seconds * 1e9) as u64))?;
    let wall_seconds = started.elapsed().as_secs_f64();
    if let Some(path) = &options.screenshot {
        std::fs::write(path, rig.picture_png())
            .with_context(|| format!("cannot write {}", path.display()))?;
    }
    report(&rig, wall_seconds);
    Ok(())
}

/// The headless run that the README promises, for `ci`.
///
/// # Errors
/// Like [`run`].
pub fn headless_for_ci(screenshot: &Path) -> Result<()> {
    run(&Options {
        build: firmware::Options::default(),
        log: "vehicles/bus/captures/city.log".into(),
        elf: None,
        headless: true,
        seconds: 20.0,
        screenshot: Some(screenshot.to_owned()),
        port: 0,
    })
}

fn start(elf: &Path, options: &RigOptions, log: &Log) -> Result<Rig> {
    let mut rig = Rig::new(elf, options)?;
    rig.replay(log, true);
    Ok(rig)
}

fn panel(panel: firmware::Panel) -> bench::rig::PanelKind {
    match panel {
        firmware::Panel::Ili9341 => bench::rig::PanelKind::Ili9341,
        firmware::Panel::St7789 => bench::rig::PanelKind::St7789,
    }
}

/// A path that is not there is looked for in the repository, so that the default works from any folder.
fn from_root(path: &Path) -> PathBuf {
    if path.exists() { path.to_owned() } else { workspace::root().join(path) }
}

fn report(rig: &Rig, wall_seconds: f64) {
    let counts = rig.counts();
    let seconds = rig.now().as_secs_f64();
    println!(
        "drove    {seconds:.3} s of virtual time, {:.2} times as fast as real time",
        seconds / wall_seconds
    );
    println!(
        "frames   {} on the bus for the cluster, {} received, {} lost",
        counts.on_bus, counts.received, counts.lost
    );
    for (name, value) in rig.shown_lines() {
        println!("shown    {name:24} {value}");
    }
}
