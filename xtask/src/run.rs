//! Drives the real firmware on the virtual bench.

use crate::out::say;
use crate::output::{self, Output};
use crate::recording::Choices;
use crate::vehicles::{Tables, short_seconds};
use crate::{firmware, vehicle, workspace};
use anyhow::{Context, Result, bail};
use bench::join::Members;
use bench::join::adapter::Bridge;
use bench::join::recorder::{Receipt, Recorder};
use bench::log::Log;
use bench::rig::{Rig, RigOptions};
use bench::rp2040::image;
use bench::time::Nanos;
use bench_host::{Server, Start};
use clap::Args;
use protocol_core::generated::SHIPPED_VEHICLES;
use protocol_core::link::Record;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use virtual_vehicle::Kind;

/// Virtual time between two looks at the wall clock.
const SLICE: Nanos = Nanos::from_millis(10);

/// What to drive and how to show it.
#[derive(Args, Clone, Debug, Default)]
pub struct Options {
    /// Panel controller on the TFT module.
    #[arg(long, value_enum, default_value_t)]
    panel: firmware::Panel,
    /// Crystal on the MCP2515 module.
    #[arg(long, value_enum, default_value_t, value_name = "MHZ")]
    crystal: firmware::Crystal,
    /// Vehicle around the cluster: citybus, jiulong or c5ev.
    #[arg(long, value_name = "NAME", default_value = "citybus")]
    vehicle: String,
    /// Sets a control of the vehicle before the start, as often as you like: `--set driver.gear=D`; `cargo xtask vehicle
    /// --list` shows all.
    #[arg(long, value_name = "PATH=VALUE")]
    set: Vec<String>,
    /// Plays this recording in a loop in place of a vehicle.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["vehicle", "set"])]
    log: Option<PathBuf>,
    #[command(flatten)]
    choices: Choices,
    /// Runs this ELF in place of building the firmware.
    #[arg(long)]
    elf: Option<PathBuf>,
    /// Opens a terminal on which other tools join the bus: python-can, slcand, SavvyCAN.
    #[arg(long)]
    slcan: bool,
    /// Joins the bus with a CAN interface of Linux: vcan0, or can0 of an adapter.
    #[arg(long, value_name = "INTERFACE")]
    can: Option<String>,
    /// Writes every frame on the bus to this candump log.
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Serves no page: runs for `--seconds` and ends.
    #[arg(long)]
    headless: bool,
    /// Virtual seconds to run without a page.
    #[arg(long, default_value_t = 20.0, requires = "headless")]
    seconds: f64,
    /// Writes the panel's last picture to this PNG file.
    #[arg(long, requires = "headless")]
    screenshot: Option<PathBuf>,
    /// Starts with what is kept in this image of the flash, if it is there, and writes it back at the end.
    #[arg(long, value_name = "FILE", requires = "headless")]
    flash: Option<PathBuf>,
    /// Lets `--record` and `--screenshot` replace files that are already there.
    #[arg(long)]
    overwrite: bool,
    /// Port of the local page; 0 takes any free one.
    #[arg(long, default_value_t = 8015)]
    port: u16,
}

/// Builds the firmware, starts it on the bench and shows it.
///
/// # Errors
/// If the log or the ELF is wrong, the build fails, a tool cannot join the bus, or the firmware does what the bench does
/// not model.
pub fn run(options: &Options) -> Result<()> {
    let played = options.log.as_ref().map(|path| from_root(path));
    if played.is_none() && options.choices != Choices::default() {
        bail!(
            "--channel, --times, --spacing-ms and --strict say how a recording is read; name one with --log FILE"
        );
    }
    let outputs = Outputs::checked(options, played.as_deref())?;
    let log = played.as_ref().map(|path| options.choices.read(path)).transpose()?;
    let kind = match log {
        Some(_) => None,
        None => Some(vehicle::named(&options.vehicle)?),
    };
    if let Some(kind) = kind {
        // Said before the firmware is built.
        vehicle::make(kind, &options.set)?;
    }
    let elf = match &options.elf {
        Some(elf) => elf.clone(),
        None => {
            let (panel, crystal) = (options.panel, options.crystal);
            // An image holds no vehicle that is not shipped: its recording needs one that is built for it.
            let recorded = log.as_ref().and_then(Tables::of_log);
            let is_shipped = |name| SHIPPED_VEHICLES.iter().any(|vehicle| vehicle.name == name);
            let vehicle = recorded.map(|tables| tables.vehicle.name).filter(|name| !is_shipped(*name));
            let vehicle = vehicle.map(str::to_owned);
            firmware::build(&firmware::Options { panel, crystal, vehicle, ..firmware::Options::default() })?
                .elf
        }
    };
    // Said before anything is written.
    image::load_elf(&elf)?;
    let rig_options = RigOptions {
        panel: panel(options.panel),
        crystal_hz: match options.crystal {
            firmware::Crystal::Mhz8 => 8_000_000,
            firmware::Crystal::Mhz16 => 16_000_000,
        },
        bitrate: bitrate(kind, log.as_ref()),
    };
    let (members, notes) = members(options, rig_options.bitrate)?;
    let recorded = outputs.record.as_ref().map(|output| BusRecording::start(output, &members)).transpose()?;
    let recording = options.log.as_ref().map(|path| path.display().to_string());
    let (first, set) = (kind, options.set.clone());
    let page_elf = elf.clone();
    let make = move |kind: Option<Kind>| -> Result<Rig> {
        let bitrate = bitrate(kind, log.as_ref());
        let mut rig = Rig::new(&elf, &RigOptions { bitrate, ..rig_options })?;
        match (kind, &log) {
            (Some(kind), _) => {
                // What is set was meant for the vehicle that was asked for, not for another one that the page starts.
                let set = if first == Some(kind) { &set[..] } else { &[] };
                rig.drive(vehicle::make(kind, set)?);
            }
            (None, Some(log)) => rig.replay(log, true),
            (None, None) => {}
        }
        rig.host(&members);
        Ok(rig)
    };
    for note in &notes {
        say!("{note}")?;
    }
    if !options.headless {
        let start = Start { port: options.port, vehicle: kind, recording, notes, elf: Some(page_elf) };
        let server = Server::start(start, make)?;
        say!("the cluster drives at http://{}/  (Ctrl-C ends it)", server.address())?;
        return server.wait();
    }
    let mut rig = make(kind)?;
    if let Some(path) = options.flash.as_ref().filter(|path| path.exists()) {
        let kept = std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        if kept.len() < bench::rig::STORE.end {
            bail!("{} is no image of a whole flash of {} bytes", path.display(), bench::rig::STORE.end);
        }
        rig.keep(&kept);
    }
    let driven = drive(&mut rig, options, recorded.as_ref());
    // What was on the bus at the very end, after the last turn; also of a run that went wrong.
    rig.settle_members();
    if let Some(recorded) = recorded {
        recorded.finish()?;
    }
    let wall_seconds = driven?;
    if let Some(path) = &options.flash {
        // The end of a run is the end of the supply.
        rig.cut_power(true);
        std::fs::write(path, rig.flash()).with_context(|| format!("cannot write {}", path.display()))?;
    }
    if let Some(screenshot) = &outputs.screenshot {
        screenshot.write_whole(&rig.picture_png())?;
    }
    report(&rig, wall_seconds)
}

/// The files that a run writes.
struct Outputs {
    record: Option<Output>,
    screenshot: Option<Output>,
}

impl Outputs {
    /// Checks them before the firmware is built and anything is written.
    fn checked(options: &Options, played: Option<&Path>) -> Result<Self> {
        let inputs: Vec<&Path> = played.into_iter().chain(options.elf.as_deref()).collect();
        let record = options.record.as_ref().map(|path| Output::checked(path, options.overwrite, &inputs));
        let record = record.transpose()?;
        let inputs: Vec<&Path> = inputs.into_iter().chain(options.record.as_deref()).collect();
        let screenshot = options.screenshot.as_ref().map(|path| {
            let output = Output::checked(path, options.overwrite, &inputs)?;
            output.try_whole().map(|()| output)
        });
        Ok(Self { record, screenshot: screenshot.transpose()? })
    }
}

/// The bus as it is being recorded in a file.
struct BusRecording {
    path: PathBuf,
    file: File,
    receipt: Receipt,
}

impl BusRecording {
    fn start(output: &Output, members: &Members) -> Result<Self> {
        let file = output.create()?;
        let path = output.path().to_owned();
        let recorder =
            Recorder::new(file.try_clone().with_context(|| format!("cannot write {}", path.display()))?);
        let receipt = recorder.receipt();
        members.add(recorder);
        Ok(Self { path, file, receipt })
    }

    fn has_failed(&self) -> bool {
        self.receipt.written().failure.is_some()
    }

    /// Says how much is in the file if the recording ended before the run.
    fn finish(&self) -> Result<()> {
        let written = self.receipt.written();
        let Some(failure) = written.failure else { return Ok(()) };
        let cut = match output::cut(&self.file, written.bytes) {
            Ok(()) => String::new(),
            Err(error) => format!(" ({error:#})"),
        };
        bail!("the recording in {} ended early: {failure}{cut}", self.path.display())
    }
}

/// The headless run that the README promises, for `ci`.
///
/// # Errors
/// Like [`run`].
pub fn headless_for_ci(screenshot: &Path) -> Result<()> {
    run(&Options {
        log: Some("vehicles/citybus/captures/city.log".into()),
        headless: true,
        seconds: 20.0,
        screenshot: Some(screenshot.to_owned()),
        overwrite: true,
        ..Options::default()
    })
}

/// Bit rate of the bus, in bit/s. A recording does not tell its own, the vehicle in it does.
fn bitrate(kind: Option<Kind>, log: Option<&Log>) -> u32 {
    let tables = match (kind, log) {
        (Some(kind), _) => Tables::named(kind.name()).ok(),
        (None, Some(log)) => Tables::of_log(log),
        (None, None) => None,
    };
    tables.map_or(RigOptions::default().bitrate, |tables| tables.vehicle.bitrate)
}

/// The tools that were asked for, and lines that say how others join.
fn members(options: &Options, bitrate: u32) -> Result<(Members, Vec<String>)> {
    let (members, mut notes) = (Members::default(), Vec::new());
    if let Some(path) = &options.record {
        notes.push(format!("the bus is recorded in {}", path.display()));
    }
    if let Some(interface) = &options.can {
        members.add(Bridge::new(interface, vehicle::socketcan(interface)?));
        notes.push(format!(
            "{interface} is on the bus: `candump {interface}` shows it, `cansend` and `canplayer` write to it"
        ));
    }
    if options.slcan {
        notes.extend(open_terminal(&members, bitrate)?);
    }
    Ok((members, notes))
}

#[cfg(unix)]
fn open_terminal(members: &Members, bitrate: u32) -> Result<Vec<String>> {
    use bench::join::pty::Pty;
    use bench::join::slcan::Command;
    use bench::join::terminal::Terminal;

    let pty = Pty::open().context("no pseudo-terminal could be opened; is /dev/pts mounted?")?;
    let path = pty.path().display().to_string();
    let setup = Command::setup(bitrate).map_or(Vec::new(), |setup| setup.line());
    let speed = String::from_utf8_lossy(&setup).trim().to_lowercase();
    members.add(Terminal::new("slcan", pty));
    Ok(vec![
        format!("other tools join the bus at {path} (SLCAN, {bitrate} bit/s), for example:"),
        format!("  python3 -m can.viewer -i slcan -c {path} -b {bitrate}"),
        format!("  sudo slcand -o -c -{speed} {path} slcan0 && sudo ip link set slcan0 up && candump slcan0"),
    ])
}

#[cfg(not(unix))]
fn open_terminal(_: &Members, _: u32) -> Result<Vec<String>> {
    anyhow::bail!(
        "--slcan needs pseudo-terminals, which this system does not have; --record and --log work everywhere"
    )
}

/// Runs for the seconds asked for, or until the recording fails: as fast as it can, or in real time if somebody outside
/// listens. Returns the time that it took, in seconds.
fn drive(rig: &mut Rig, options: &Options, recorded: Option<&BusRecording>) -> Result<f64> {
    let (started, end) = (Instant::now(), Nanos((options.seconds * 1e9) as u64));
    let is_watched = options.slcan || options.can.is_some();
    let slice = if is_watched || recorded.is_some() { SLICE } else { end };
    while rig.now() < end && !recorded.is_some_and(BusRecording::has_failed) {
        rig.run_for(slice.min(end.since(rig.now())))?;
        if is_watched {
            std::thread::sleep(Duration::from_nanos(rig.now().0).saturating_sub(started.elapsed()));
        }
    }
    Ok(started.elapsed().as_secs_f64())
}

fn panel(panel: firmware::Panel) -> bench::rig::PanelKind {
    match panel {
        firmware::Panel::Ili9341 => bench::rig::PanelKind::Ili9341,
        firmware::Panel::St7789 => bench::rig::PanelKind::St7789,
    }
}

/// A path that is not there is looked for in the repository, so that the README's examples work from any folder.
fn from_root(path: &Path) -> PathBuf {
    if path.exists() { path.to_owned() } else { workspace::root().join(path) }
}

fn report(rig: &Rig, wall_seconds: f64) -> Result<()> {
    let counts = rig.counts();
    let seconds = rig.now().as_secs_f64();
    say!(
        "drove    {seconds:.3} s of virtual time, {:.2} times as fast as real time",
        seconds / wall_seconds
    )?;
    say!(
        "frames   {} on the bus for the cluster, {} taken by its controller, {} lost",
        counts.on_bus,
        counts.stored,
        counts.lost
    )?;
    let health = rig.records().iter().rev().find(|(_, record)| matches!(record, Record::Health(_)));
    if let Some((told, _)) = health {
        let before = short_seconds(rig.now().since(*told).0 / 1_000_000);
        say!("told     {} received, by its last report {before} s before the end", counts.received)?;
    }
    for (name, value) in rig.shown_lines() {
        say!("shown    {name:24} {value}")?;
    }
    Ok(())
}
