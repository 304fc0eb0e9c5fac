//! Plays the virtual vehicle on a real bus: everything but the cluster, which is on the desk.
//!
//! Owns the pace: virtual time follows the wall clock, each frame goes out when it is due and never before. After a
//! pause of the machine the vehicle goes on where it was; nothing is sent in a burst.

use crate::out::say;
use crate::vehicle_new;
use crate::vehicles::{self, Tables};
use anyhow::{Context, Result, anyhow, bail};
use bench::can::Frame;
use bench::join::adapter::{Adapter, Said};
use clap::{Args, Subcommand};
use protocol_core::codec::MessageInfo;
use protocol_core::{CanFrame, CanId};
use std::collections::{BTreeMap, VecDeque};
use std::path::PathBuf;
use std::time::{Duration, Instant};
use vehicle_compiler::did_you_mean;
use virtual_vehicle::{Kind, Sent, VirtualVehicle};

/// Time between two looks at the adapter.
const TURN: Duration = Duration::from_millis(1);
/// Time between two status lines.
const STATUS_EVERY_US: u64 = 1_000_000;
/// The vehicle waits for a machine that was away for longer than this.
const LATE_US: u64 = 250_000;
/// Frames that wait for a busy adapter; older ones are lost, as in a node whose buffers are full.
const WAITING_MAX: usize = 256;
/// Frames that are taken from the adapter in one turn.
const FRAMES_PER_TURN: usize = 256;
/// Time after which a cluster that is not heard is worth a hint.
const SILENCE_US: u64 = 3_000_000;
/// Node of the DBC that is on the desk.
const CLUSTER: &str = "Cluster";

/// Where to play which vehicle.
#[derive(Args, Clone, Debug)]
#[command(args_conflicts_with_subcommands = true)]
pub struct Options {
    #[command(subcommand)]
    command: Option<Command>,
    /// Vehicle to play: citybus, jiulong or c5ev.
    #[arg(long, value_name = "NAME", default_value = "citybus")]
    vehicle: String,
    /// CAN interface of Linux, up and with the vehicle's bit rate: can0.
    #[arg(long, value_name = "INTERFACE")]
    can: Option<String>,
    /// Serial adapter that speaks SLCAN: /dev/ttyACM0.
    #[arg(long, value_name = "PORT", conflicts_with = "can")]
    slcan: Option<PathBuf>,
    /// Speed of the serial port in baud; adapters on USB ignore it.
    #[arg(long, value_name = "BAUD", default_value_t = 115_200)]
    baud: u32,
    /// Ends after so many seconds.
    #[arg(long)]
    seconds: Option<f64>,
    /// Sets a control before the start, as often as you like: `--set driver.gear=D`.
    #[arg(long, value_name = "PATH=VALUE")]
    set: Vec<String>,
    /// Prints what can be set in this vehicle, and ends.
    #[arg(long)]
    list: bool,
}

/// What else can be done with a vehicle.
#[derive(Clone, Debug, Subcommand)]
enum Command {
    /// Makes the folder of a vehicle out of a DBC file: bindings by names and units, and a drive through their ranges.
    New(vehicle_new::Options),
}

/// Plays the vehicle until the time is over or the process ends.
///
/// # Errors
/// If there is no such vehicle, control or adapter; or the adapter is gone.
pub fn run(options: &Options) -> Result<()> {
    if let Some(Command::New(options)) = &options.command {
        return vehicle_new::run(options);
    }
    let kind = named(&options.vehicle)?;
    let tables = Tables::named(kind.name())?;
    let vehicle = make(kind, &options.set)?;
    if options.list {
        for control in vehicle.controls() {
            say!("{:32} {:40} {}", control.path, control.range(), control.en)?;
        }
        return Ok(());
    }
    let bitrate = tables.vehicle.bitrate;
    let adapter = match (&options.can, &options.slcan) {
        (Some(interface), _) => socketcan(interface)?,
        (None, Some(port)) => serial(port, options.baud, bitrate)?,
        (None, None) => bail!("say where the bus is: --can can0 or --slcan /dev/ttyACM0"),
    };
    say!("{} plays at {bitrate} bit/s; Ctrl-C ends it", kind.name())?;
    let mut desk = Desk::new(vehicle, tables, adapter);
    let end = options.seconds.map(Duration::from_secs_f64);
    let started = Instant::now();
    while end.is_none_or(|end| started.elapsed() < end) {
        let now_us = u64::try_from(started.elapsed().as_micros())?;
        desk.turn(now_us)?;
        for line in desk.status(now_us) {
            say!("{line}")?;
        }
        std::thread::sleep(TURN);
    }
    Ok(())
}

/// Returns the virtual vehicle of a name.
///
/// # Errors
/// If there is none; the error names the nearest and all.
pub fn named(name: &str) -> Result<Kind> {
    let names = || Kind::ALL.into_iter().map(Kind::name);
    Kind::from_name(name).ok_or_else(|| {
        let near = did_you_mean(name, names());
        anyhow!(
            "no virtual vehicle is called `{name}`{near} (known: {})",
            names().collect::<Vec<_>>().join(", ")
        )
    })
}

/// Returns a vehicle with some of its controls set.
///
/// # Errors
/// If one is not `PATH=VALUE`, or the vehicle has no such control, or it does not take the value.
pub fn make(kind: Kind, set: &[String]) -> Result<VirtualVehicle> {
    let mut vehicle = VirtualVehicle::new(kind, virtual_vehicle::Options::default());
    for assignment in set {
        let (path, value) = assignment.split_once('=').with_context(|| {
            format!("`{assignment}` is not PATH=VALUE; `cargo xtask vehicle --list` shows all")
        })?;
        let control = vehicle.controls().find(|control| control.path == path);
        let setting = control.map(|control| control.read(value)).transpose()?.flatten();
        vehicle.set(path, setting)?;
    }
    Ok(vehicle)
}

/// Opens a CAN interface of Linux.
///
/// # Errors
/// If there is none of this name; the error says what to type.
#[cfg(target_os = "linux")]
pub fn socketcan(interface: &str) -> Result<Box<dyn Adapter>> {
    Ok(Box::new(bench::join::socketcan::SocketCan::open(interface)?))
}

/// Opens a CAN interface of Linux.
///
/// # Errors
/// Always: this is not Linux.
#[cfg(not(target_os = "linux"))]
pub fn socketcan(interface: &str) -> Result<Box<dyn Adapter>> {
    bail!("{interface}: only Linux has CAN interfaces; use --slcan with a serial adapter")
}

#[cfg(unix)]
fn serial(port: &std::path::Path, baud: u32, bitrate: u32) -> Result<Box<dyn Adapter>> {
    let port = bench::join::pty::SerialPort::open(port, baud)?;
    Ok(Box::new(bench::join::adapter::SlcanAdapter::open(port, bitrate)?))
}

#[cfg(not(unix))]
fn serial(port: &std::path::Path, _: u32, _: u32) -> Result<Box<dyn Adapter>> {
    bail!("{}: serial ports are opened on Linux and macOS only", port.display())
}

/// A vehicle, and a bus with a cluster on it.
struct Desk<A> {
    vehicle: VirtualVehicle,
    tables: Tables,
    adapter: A,
    waiting: VecDeque<Sent>,
    /// Time for which the vehicle stood still because the machine was away.
    away_us: u64,
    tally: Tally,
    /// The same at the last status line.
    before: Tally,
    status_due_us: u64,
    /// The cluster's frames by identifier: the newest, and what was last printed of it.
    meters: BTreeMap<CanId, (CanFrame, String)>,
    hinted: bool,
    /// What was last told of lines that were not taken.
    told: Said,
}

/// What went over the adapter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Tally {
    sent: u64,
    /// Lost because the adapter was busy for too long.
    lost: u64,
    from_cluster: u64,
    /// From nodes that are neither the cluster nor played here.
    from_others: u64,
}

impl<A: Adapter> Desk<A> {
    fn new(vehicle: VirtualVehicle, tables: Tables, adapter: A) -> Self {
        Self {
            vehicle,
            tables,
            adapter,
            waiting: VecDeque::new(),
            away_us: 0,
            tally: Tally::default(),
            before: Tally::default(),
            status_due_us: STATUS_EVERY_US,
            meters: BTreeMap::new(),
            hinted: false,
            told: Said::default(),
        }
    }

    /// Brings the vehicle to `now_us` after the start, sends what is due and takes what was heard.
    fn turn(&mut self, now_us: u64) -> Result<()> {
        let lag = now_us.saturating_sub(self.away_us).saturating_sub(self.vehicle.now_ms() * 1_000);
        if lag > LATE_US {
            self.away_us += lag;
        }
        let vehicle_us = now_us.saturating_sub(self.away_us);
        // Ends: each pass takes the vehicle one step on, and it is late by 250 ms at most.
        while self.vehicle.now_ms() * 1_000 <= vehicle_us {
            self.vehicle.advance();
            self.waiting.extend(self.vehicle.take_frames());
        }
        while self.waiting.front().is_some_and(|sent| sent.at_us <= vehicle_us) {
            let Some(frame) = self.waiting.front().map(|sent| Frame::from(&sent.frame)) else { break };
            if !self.adapter.send(&frame)? {
                break;
            }
            self.waiting.pop_front();
            self.tally.sent += 1;
        }
        while self.waiting.len() > WAITING_MAX {
            self.waiting.pop_front();
            self.tally.lost += 1;
        }
        self.hear()
    }

    fn hear(&mut self) -> Result<()> {
        for _ in 0..FRAMES_PER_TURN {
            let Some(frame) = self.adapter.receive()? else { break };
            let Some(frame) = vehicles::can_frame(&frame) else { continue };
            // Whoever sends it: the nodes that are played here hear what is on the bus.
            self.vehicle.receive(&frame);
            if self.tables.message(frame.id).is_some_and(|message| message.sender == CLUSTER) {
                self.tally.from_cluster += 1;
                let meter = self.meters.entry(frame.id).or_insert_with(|| (frame, String::new()));
                meter.0 = frame;
            } else {
                self.tally.from_others += 1;
            }
        }
        Ok(())
    }

    /// Lines to print: once a second what went over the bus, and what the cluster says if that has changed.
    fn status(&mut self, now_us: u64) -> Vec<String> {
        if now_us < self.status_due_us {
            return Vec::new();
        }
        self.status_due_us = now_us - now_us % STATUS_EVERY_US + STATUS_EVERY_US;
        let (now, before) = (self.tally, self.before);
        self.before = now;
        let mut line = format!(
            "{:>6} s  {} frames sent, {} from the cluster",
            now_us / 1_000_000,
            now.sent - before.sent,
            now.from_cluster - before.from_cluster
        );
        let extras = [
            (now.lost - before.lost, "lost: the adapter is busy, or nobody acknowledges"),
            (now.from_others - before.from_others, "from nodes that are neither the cluster nor played here"),
            (self.adapter.refused(), "commands refused by the adapter so far"),
        ];
        for (count, text) in extras.iter().filter(|(count, _)| *count > 0) {
            line += &format!(", {count} {text}");
        }
        let mut lines = vec![line];
        for (id, (frame, printed)) in &mut self.meters {
            let Some(text) = self.tables.message(*id).map(|message| meter_text(message, frame)) else {
                continue;
            };
            if *printed != text {
                lines.push(format!("          {text}"));
                *printed = text;
            }
        }
        lines.extend(self.not_taken());
        if now.from_cluster == 0 && now_us >= SILENCE_US && !self.hinted {
            self.hinted = true;
            lines.push(format!(
                "          nothing from the cluster yet: is it powered, CAN-H on CAN-H and CAN-L on CAN-L, 120 ohm at \
                 both ends (60 ohm between the wires), {} bit/s on both sides?",
                self.tables.vehicle.bitrate
            ));
        }
        lines
    }

    /// Lines to print of what the adapter said and nobody took: at first, and whenever there is twice as much of it.
    fn not_taken(&mut self) -> Vec<String> {
        let Said { unknown, fd_frames, first_unknown, .. } = self.adapter.said();
        let mut lines = Vec::new();
        if unknown > 0 && unknown >= self.told.unknown * 2 {
            self.told.unknown = unknown;
            lines.push(format!(
                "          {unknown} lines of the adapter are not understood, the first is `{first_unknown}`"
            ));
        }
        if fd_frames > 0 && fd_frames >= self.told.fd_frames * 2 {
            self.told.fd_frames = fd_frames;
            lines.push(format!(
                "          {fd_frames} frames of CAN FD are on the bus, which no cluster here reads"
            ));
        }
        lines
    }
}

/// Every value of a message of the cluster but its life counters.
fn meter_text(message: &MessageInfo, frame: &CanFrame) -> String {
    if frame.len() < message.len {
        return format!("{}: {} bytes of {}", message.name, frame.len(), message.len);
    }
    let data = frame.padded();
    let signals = message.signals.iter().enumerate();
    let shown = signals.filter(|(_, signal)| signal.life.is_none() && message.carries(signal, data));
    let texts = shown.filter_map(|(index, signal)| {
        let (raw, counts) = (message.get)(index, *data)?;
        let text = match (signal.word(raw), counts) {
            (Some(word), _) => word.to_owned(),
            (None, Some(counts)) => {
                vehicles::with_unit(&vehicles::decimal(counts, signal.scale.den), signal.unit)
            }
            (None, None) => "--".into(),
        };
        Some(format!("{} {text}", signal.name))
    });
    format!("{}: {}", message.name, texts.collect::<Vec<_>>().join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;
    use std::io;
    use std::sync::{Arc, Mutex};

    /// An adapter that writes down what it is given and when, and gives what the test has put there.
    #[derive(Default)]
    struct Notes {
        now_us: u64,
        sent: Vec<(u64, Frame)>,
        to_hear: VecDeque<Frame>,
        said: Said,
        busy: Cell<bool>,
    }

    #[derive(Clone, Default)]
    struct Paper(Arc<Mutex<Notes>>);

    impl Adapter for Paper {
        fn send(&mut self, frame: &Frame) -> io::Result<bool> {
            let mut notes = self.0.lock().unwrap();
            let now_us = notes.now_us;
            if !notes.busy.get() {
                notes.sent.push((now_us, *frame));
            }
            Ok(!notes.busy.get())
        }

        fn receive(&mut self) -> io::Result<Option<Frame>> {
            Ok(self.0.lock().unwrap().to_hear.pop_front())
        }

        fn said(&self) -> Said {
            self.0.lock().unwrap().said.clone()
        }
    }

    fn desk() -> (Desk<Paper>, Paper) {
        let (tables, paper) = (Tables::named("citybus").unwrap(), Paper::default());
        (Desk::new(make(Kind::Citybus, &[]).unwrap(), tables, paper.clone()), paper)
    }

    fn turn(desk: &mut Desk<Paper>, paper: &Paper, now_us: u64) {
        paper.0.lock().unwrap().now_us = now_us;
        desk.turn(now_us).unwrap();
    }

    /// What the vehicle sends by itself: the same vehicle without a clock.
    fn expected(millis: u64) -> Vec<(u64, Frame)> {
        let mut vehicle = make(Kind::Citybus, &[]).unwrap();
        let mut sent = Vec::new();
        while vehicle.now_ms() <= millis {
            vehicle.advance();
            sent.extend(vehicle.take_frames().iter().map(|sent| (sent.at_us, Frame::from(&sent.frame))));
        }
        sent.retain(|(at_us, _)| *at_us <= millis * 1_000);
        sent
    }

    #[test]
    fn every_frame_goes_out_when_it_is_due_and_none_before() {
        let (mut desk, paper) = desk();
        for now in 0..=2_000 {
            turn(&mut desk, &paper, now * 1_000);
        }
        let (sent, expected) = (paper.0.lock().unwrap().sent.clone(), expected(2_000));
        assert!(sent.len() > 100, "{} frames in two seconds", sent.len());
        assert_eq!(
            sent.iter().map(|(_, frame)| frame).collect::<Vec<_>>(),
            expected.iter().map(|(_, frame)| frame).collect::<Vec<_>>()
        );
        for ((went, frame), (due, _)) in sent.iter().zip(&expected) {
            assert!((*due..due + 1_000).contains(went), "{frame} due at {due} us went at {went} us");
        }
    }

    #[test]
    fn after_a_pause_of_the_machine_nothing_goes_out_in_a_burst() {
        let (mut desk, paper) = desk();
        for now in (0..=1_000).chain(61_000..=62_000) {
            turn(&mut desk, &paper, now * 1_000);
        }
        let sent = paper.0.lock().unwrap().sent.clone();
        let after = sent.iter().filter(|(at, _)| *at >= 61_000_000).count();
        let second = sent.iter().filter(|(at, _)| *at <= 1_000_000).count();
        assert!(
            after < second * 3 / 2,
            "{after} frames in the second after the pause, {second} in the one before"
        );
    }

    #[test]
    fn a_busy_adapter_costs_the_oldest_frames_and_is_named() {
        let (mut desk, paper) = desk();
        paper.0.lock().unwrap().busy.set(true);
        for now in 0..=5_000 {
            turn(&mut desk, &paper, now * 1_000);
        }
        assert!(desk.waiting.len() <= WAITING_MAX && desk.tally.lost > 0, "{:?}", desk.tally);
        let lines = desk.status(5_000_000);
        assert!(lines[0].contains("nobody acknowledges"), "{lines:?}");
        assert!(lines[1].contains("nothing from the cluster yet"), "{lines:?}");
    }

    #[test]
    fn lines_that_are_not_understood_are_said_before_any_advice_about_wires() {
        let (mut desk, paper) = desk();
        let tell = |unknown, fd_frames| {
            let first_unknown = "hello".to_owned();
            paper.0.lock().unwrap().said = Said { unknown, fd_frames, first_unknown, ..Said::default() };
        };
        tell(3, 1);
        let lines = desk.status(SILENCE_US);
        let expected = "          3 lines of the adapter are not understood, the first is `hello`";
        assert_eq!(lines[1], expected);
        assert!(lines[2].contains("1 frames of CAN FD"), "{lines:?}");
        assert!(lines[3].contains("nothing from the cluster yet"), "{lines:?}");
        tell(5, 1);
        assert_eq!(desk.status(SILENCE_US * 2).len(), 1, "little more is no news");
        tell(6, 1);
        assert!(desk.status(SILENCE_US * 3)[1].contains("6 lines"));
    }

    #[test]
    fn what_the_cluster_says_is_printed_decoded_and_once_until_it_changes() {
        let (mut desk, paper) = desk();
        let meter = desk.tables.messages.iter().find(|message| message.name == "Meter2").unwrap();
        let odometer = meter.signal("odometer").unwrap();
        let mut data = meter.start_frame();
        odometer.set_raw(&mut data, 100 * i64::from(odometer.scale.den));
        let frame = Frame::from(&CanFrame::full(meter.id, data));
        let lines = |desk: &mut Desk<Paper>, second: u64| {
            paper.0.lock().unwrap().to_hear.push_back(frame);
            turn(desk, &paper, second * 1_000_000);
            desk.status(second * 1_000_000)
        };
        let first = lines(&mut desk, 1);
        assert!(first[0].contains("1 from the cluster"), "{first:?}");
        assert!(first[1].contains("Meter2: odometer 100 km"), "{first:?}");
        assert_eq!(lines(&mut desk, 2).len(), 1);
    }

    #[test]
    fn an_unknown_vehicle_or_control_is_named() {
        let Err(error) = named("buss") else { panic!("there is no buss") };
        assert!(error.to_string().contains("citybus"), "{error}");
        for (wrong, hint) in
            [("driver.gear", "--list"), ("no.such=1", "no control"), ("driver.gear=P", "takes")]
        {
            let Err(error) = make(Kind::Citybus, &[wrong.to_owned()]) else { panic!("{wrong} was set") };
            assert!(error.to_string().contains(hint), "{error}");
        }
        assert!(make(Kind::Citybus, &["driver.gear=D".into()]).is_ok());
    }
}
