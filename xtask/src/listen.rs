//! Prints the records that a cluster sends on its UART.
//!
//! Reads bytes from a serial port, which it sets up, from a file or from standard input. Noise is counted and skipped: the
//! decoder finds the next record by itself. Texts are printed as they cannot steer a terminal. Faults are told again and again for whoever
//! comes late; printed is each of them once, and again when something about it has changed.

use crate::out::{self, note};
use crate::words::page;
use anyhow::{Context, Result, bail};
use bench::printable::printable;
use clap::Args;
use cluster::Named;
use protocol_core::generated::VEHICLES;
use protocol_core::link::{Decoder, Fault, Health, Record, Sample, Screen, Trip, Trips};
use protocol_core::model::Severity;
use protocol_core::states::Confinement;
use protocol_core::vehicle::NO_VEHICLE;
use protocol_core::{Value, Vehicle};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// Where the bytes come from.
#[derive(Args, Debug)]
pub struct Options {
    /// Serial port, or a file with what came from one; `-` is standard input.
    source: PathBuf,
    /// Speed of the serial port in baud.
    #[arg(long, value_name = "BAUD", default_value_t = 115_200)]
    baud: u32,
}

/// What was read of a source.
#[derive(Debug, Default, PartialEq, Eq)]
struct Heard {
    bytes: u64,
    records: u64,
    /// The first one is what was cut off when listening began.
    damaged: u64,
}

/// Prints every record until the source ends.
///
/// # Errors
/// If the source cannot be opened or read, or holds no record of a cluster.
pub fn run(options: &Options) -> Result<()> {
    let heard = print(&mut *open(options)?, &mut out::stdout())?;
    if heard.damaged > 0 {
        note!("{} damaged records skipped", heard.damaged);
    }
    if heard.records == 0 {
        bail!(
            "{}: {} bytes and no record of a cluster in them; name the serial port on its UART (GP0), or a file with \
             what came from there",
            options.source.display(),
            heard.bytes
        );
    }
    Ok(())
}

fn open(options: &Options) -> Result<Box<dyn Read>> {
    let source = &options.source;
    if source == Path::new("-") {
        return Ok(Box::new(std::io::stdin().lock()));
    }
    #[cfg(unix)]
    if port::is_device(source) {
        return Ok(Box::new(port::Port::open(source, options.baud)?));
    }
    Ok(Box::new(File::open(source).with_context(|| format!("cannot open {}", source.display()))?))
}

/// Serial ports of Linux and macOS; elsewhere the system's own tool sets a port up (`mode COM3 115200,n,8,1`).
#[cfg(unix)]
mod port {
    use crate::out::note;
    use bench::join::pty::SerialPort;
    use bench::join::wire::Wire;
    use std::io::{self, Read};
    use std::os::unix::fs::FileTypeExt;
    use std::path::Path;
    use std::time::{Duration, Instant};

    /// Time between two looks at a port that has nothing.
    const TURN: Duration = Duration::from_millis(5);
    /// Silence that is worth a hint; a cluster speaks several times a second.
    const SILENCE: Duration = Duration::from_secs(3);

    pub(super) fn is_device(path: &Path) -> bool {
        std::fs::metadata(path).is_ok_and(|metadata| metadata.file_type().is_char_device())
    }

    /// A serial port whose reader waits.
    pub(super) struct Port {
        port: SerialPort,
        opened: Instant,
        /// Nothing has come yet and nothing was said about it.
        is_to_hint: bool,
    }

    impl Port {
        pub(super) fn open(path: &Path, baud: u32) -> io::Result<Self> {
            Ok(Self { port: SerialPort::open(path, baud)?, opened: Instant::now(), is_to_hint: true })
        }
    }

    impl Read for Port {
        /// Ends with bytes, or with the error of a port that is gone.
        fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
            loop {
                let count = self.port.read(into)?;
                if count > 0 {
                    self.is_to_hint = false;
                    return Ok(count);
                }
                if self.is_to_hint && self.opened.elapsed() >= SILENCE {
                    self.is_to_hint = false;
                    note!("nothing heard yet: is GP0 of the cluster on RX of the adapter, ground on ground?");
                }
                std::thread::sleep(TURN);
            }
        }
    }
}

fn print(source: &mut dyn Read, out: &mut dyn Write) -> Result<Heard> {
    let (mut decoder, mut heard, mut bytes) = (Decoder::new(), Heard::default(), [0; 256]);
    let mut told = Told::default();
    loop {
        let length = source.read(&mut bytes).context("the source ended with an error")?;
        if length == 0 {
            return Ok(heard);
        }
        heard.bytes += length as u64;
        for &byte in &bytes[..length] {
            match decoder.push(byte) {
                Some(Ok(record)) => {
                    heard.records += 1;
                    write_record(&record, &mut told, out)?;
                }
                Some(Err(_)) => heard.damaged += 1,
                None => {}
            }
        }
        out.flush()?;
    }
}

/// What was printed of faults, and whose they are.
struct Told {
    /// Who says what the codes mean; nobody until it has greeted.
    vehicle: &'static Vehicle,
    /// How many were active.
    active: Option<u8>,
    /// By list, number and code: severity and how often it had come.
    faults: BTreeMap<(bool, u8, Option<u16>), (u8, u16)>,
}

impl Default for Told {
    fn default() -> Self {
        Self { vehicle: &NO_VEHICLE, active: None, faults: BTreeMap::new() }
    }
}

impl Told {
    /// Takes the vehicle's name from a greeting.
    fn meet(&mut self, vehicle: &str) {
        let known = VEHICLES.iter().find(|known| known.name == vehicle);
        self.vehicle = known.copied().unwrap_or(&NO_VEHICLE);
    }

    /// Returns how somebody reads a fault: its key, its stage, its code, how bad it is and what the driver reads.
    fn said(&self, fault: u8, stage: u8, code: Option<u16>, severity: u8) -> String {
        let severity = Severity::from_model(severity.into()).word();
        let number = code.map_or(String::new(), |code| format!(" code {code}"));
        let Some(named) = Named::of_record(fault, stage, code) else {
            return format!("fault {fault}{number}: {severity}, of a newer firmware");
        };
        let stage = named.stage_key().map_or(String::new(), |stage| format!(" {stage}"));
        let text = named.text(self.vehicle);
        format!("{}{stage}{number}: {severity}, {} {}", named.fault.key(), text.en, text.zh)
    }

    /// Returns whether there is something new about the fault.
    fn is_new(&mut self, is_active: bool, fault: &Fault) -> bool {
        let news = (fault.severity, fault.times);
        self.faults.insert((is_active, fault.fault, fault.code), news) != Some(news)
    }
}

fn write_record(record: &Record, told: &mut Told, out: &mut dyn Write) -> std::io::Result<()> {
    match record {
        Record::Hello { version, vehicle, build } => {
            told.meet(vehicle.as_str());
            let vehicle =
                if vehicle.as_str().is_empty() { "a vehicle not known yet" } else { vehicle.as_str() };
            let (version, vehicle) = (printable(version.as_str()), printable(vehicle));
            writeln!(out, "hello   firmware {version} for {vehicle}, build {build:08x}")
        }
        Record::Health(health) => write_health(health, out),
        Record::Values { first, items } => {
            let values = Value::ALL.iter().skip(usize::from(*first)).zip(items.as_slice());
            for (value, sample) in values {
                if *sample != Sample::Never {
                    writeln!(out, "value   {:28} {}", value.path(), sample.show(value.unit()))?;
                }
            }
            Ok(())
        }
        Record::Shown(screen) => write_screen(screen, told, out),
        Record::Panic { line, text } => writeln!(out, "panic   line {line}: {}", printable(text.as_str())),
        Record::Trips(trips) => write_trips(trips, out),
        Record::Active { count, fault } => {
            if told.active.replace(*count) != Some(*count) {
                writeln!(out, "active  {count} faults")?;
            }
            match fault.filter(|fault| told.is_new(true, fault)) {
                Some(fault) => {
                    writeln!(out, "active  {}, came at {}", said(told, &fault), seconds(fault.first_ms))
                }
                None => Ok(()),
            }
        }
        Record::Remembered { fault, last_ms, .. } => {
            if !told.is_new(false, fault) {
                return Ok(());
            }
            let (first, last) = (seconds(fault.first_ms), seconds(*last_ms));
            let times = if fault.times == 1 { "once".into() } else { format!("{} times", fault.times) };
            writeln!(out, "history {}, {times}, first at {first}, last at {last}", said(told, fault))
        }
    }
}

fn said(told: &Told, fault: &Fault) -> String {
    told.said(fault.fault, fault.stage, fault.code, fault.severity)
}

fn seconds(ms: u64) -> String {
    format!("{}.{:03} s", ms / 1_000, ms % 1_000)
}

fn write_trips(trips: &Trips, out: &mut dyn Write) -> std::io::Result<()> {
    let range = if trips.range_is_estimated { "~" } else { "" };
    write!(
        out,
        "trips   range {range}{} km, now {} Wh/km",
        number(trips.range_km),
        number(trips.consumption_whkm)
    )?;
    for (name, trip) in ["A", "B"].into_iter().zip(trips.trips) {
        let Trip { hectometres, average_whkm, used_watthours, regained_watthours } = trip;
        let average = average_whkm.map_or("--".into(), |average| average.to_string());
        let (km, tenths) = (hectometres / 10, hectometres % 10);
        write!(
            out,
            "; {name} {km}.{tenths} km, {average} Wh/km, used {used_watthours} Wh, regained {regained_watthours} Wh"
        )?;
    }
    writeln!(out)
}

fn write_health(health: &Health, out: &mut dyn Write) -> std::io::Result<()> {
    writeln!(
        out,
        "health  up {}.{:03} s, CAN {} (TEC {}, REC {}), received {}, sent {}, unknown {}, short {}, damaged {}, overruns {}, \
         queue overflows {}, idle {}.{} %, last reset {}",
        health.uptime_ms / 1000,
        health.uptime_ms % 1000,
        health.can_state.map_or(Confinement::OFFLINE, Confinement::word),
        health.tec,
        health.rec,
        health.frames_received,
        health.frames_sent,
        health.frames_unknown,
        health.frames_dropped_short,
        health.frames_damaged,
        health.overruns,
        health.ring_overflows,
        health.idle_permille / 10,
        health.idle_permille % 10,
        health.last_reset.word(),
    )
}

fn write_screen(screen: &Screen, told: &Told, out: &mut dyn Write) -> std::io::Result<()> {
    let line = screen.line.map_or(String::new(), |line| {
        format!(", line {}", told.said(line.fault, line.stage, line.code, line.severity))
    });
    let hv_off = screen.hv_off_s.map_or(String::new(), |seconds| format!(", HV off in {seconds} s"));
    let limp = match (screen.limps, screen.limp_deciamps) {
        (false, _) => String::new(),
        (true, None) => ", limp".into(),
        (true, Some(limit)) => format!(", limp at {}.{} A", limit / 10, limit % 10),
    };
    writeln!(
        out,
        "shown   page {}, {} km/h, SOC {} %, lamps {:06x}{line}{hv_off}{limp}",
        page(screen.page),
        number(screen.speed_kmh),
        number(screen.soc_percent),
        screen.telltales
    )
}

fn number(sample: Sample) -> String {
    match sample {
        Sample::Value(number) => number.to_string(),
        _ => "--".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cluster::FaultId;
    use protocol_core::generated::citybus;
    use protocol_core::link::{Chunk, MAX_FRAME, ScreenLine, encode};

    #[test]
    fn records_are_printed_in_order_and_noise_between_them_is_skipped() {
        let items = [Sample::Value(12_425), Sample::Value(1)].into_iter().collect::<Chunk>();
        let records = [
            Record::Hello { version: "0.1.0".into(), vehicle: "citybus".into(), build: 7 },
            Record::Values { first: 0, items },
        ];
        let mut bytes = vec![0x55, 0xAA, 0x00];
        for record in &records {
            let mut frame = [0; MAX_FRAME];
            let length = encode(record, &mut frame).unwrap();
            bytes.extend_from_slice(&frame[..length]);
            bytes.extend_from_slice(&[0xFF, 0x13, 0x00]);
        }
        let mut out = Vec::new();
        print(&mut &*bytes, &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        let lines: Vec<_> =
            text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
        let expected = [
            "hello firmware 0.1.0 for citybus, build 00000007",
            "value vehicle.speed 48.5 km/h",
            "value vehicle.gear D",
        ];
        assert_eq!(lines, expected);
    }

    fn printed(records: &[Record]) -> Vec<String> {
        let mut bytes = Vec::new();
        for record in records {
            let mut frame = [0; MAX_FRAME];
            let length = encode(record, &mut frame).unwrap();
            bytes.extend_from_slice(&frame[..length]);
        }
        let mut out = Vec::new();
        print(&mut &*bytes, &mut out).unwrap();
        String::from_utf8(out).unwrap().lines().map(str::to_owned).collect()
    }

    #[test]
    fn a_fault_is_printed_once_and_again_when_it_has_changed() {
        let fault = Fault {
            fault: FaultId::BatteryAlarm.number(),
            code: Some(3),
            severity: 2,
            first_ms: 12_345,
            times: 1,
            ..Fault::default()
        };
        let again = Fault { times: 2, ..fault };
        let active = |fault| Record::Active { count: 1, fault: Some(fault) };
        let past = |fault, last_ms| Record::Remembered { count: 1, fault, last_ms };
        let lines = printed(&[
            Record::Active { count: 0, fault: None },
            active(fault),
            past(fault, 12_345),
            active(fault),
            past(fault, 12_345),
            past(again, 20_000),
            Record::Active { count: 0, fault: None },
        ]);
        let expected = [
            "active  0 faults",
            "active  1 faults",
            "active  battery_alarm code 3: derate, Battery fault 动力电池故障, came at 12.345 s",
            "history battery_alarm code 3: derate, Battery fault 动力电池故障, once, first at 12.345 s, last at 12.345 s",
            "history battery_alarm code 3: derate, Battery fault 动力电池故障, 2 times, first at 12.345 s, last at 20.000 s",
            "active  0 faults",
        ];
        assert_eq!(lines, expected);
    }

    #[test]
    fn a_fault_is_said_in_the_words_of_its_row_and_its_code_in_those_of_the_vehicle_that_has_greeted() {
        let line = ScreenLine { code: Some(105), severity: 1, ..ScreenLine::default() };
        let shown = |fault: FaultId, stage, line| {
            let line = Some(ScreenLine { fault: fault.number(), stage, ..line });
            Record::Shown(Screen { line, ..Screen::default() })
        };
        let greeting = Record::Hello { version: "0.1.0".into(), vehicle: "citybus".into(), build: 7 };
        let plain = ScreenLine { severity: 3, ..ScreenLine::default() };
        let lines = printed(&[
            shown(FaultId::Battery, 0, line),
            greeting,
            shown(FaultId::Battery, 0, line),
            shown(FaultId::HvOff, 1, plain),
            shown(FaultId::Identified, 0, ScreenLine::default()),
            Record::Shown(Screen { line: Some(ScreenLine { fault: 255, ..line }), ..Screen::default() }),
        ]);
        let said: Vec<_> =
            lines.iter().filter_map(|line| line.split_once(", line ")).map(|pair| pair.1).collect();
        let vehicle = format!("identified: none, {} {}", citybus::VEHICLE.en, citybus::VEHICLE.zh);
        let expected = [
            "battery_code level_1 code 105: warn, Battery fault level 1 动力电池一级故障",
            "battery_code level_1 code 105: warn, Battery too hot 电芯高温",
            "hv_off overdue: stop, HV still on: battery will cut it 高压未断开 电池将自行断开",
            &vehicle,
            "fault 255 code 105: warn, of a newer firmware",
        ];
        assert_eq!(said, expected);
    }

    #[test]
    fn page_countdown_limp_and_trips_are_printed() {
        let screen = Screen {
            speed_kmh: Sample::Value(23),
            page: 9,
            hv_off_s: Some(28),
            limps: true,
            limp_deciamps: Some(545),
            ..Screen::default()
        };
        let trip = Trip {
            hectometres: 1_234,
            average_whkm: Some(187),
            used_watthours: 23_000,
            regained_watthours: 12,
        };
        let trips = Trips {
            trips: [trip, Trip::default()],
            consumption_whkm: Sample::Stale,
            range_km: Sample::Value(182),
            range_is_estimated: true,
        };
        let expected = [
            "shown   page codes, 23 km/h, SOC -- %, lamps 000000, HV off in 28 s, limp at 54.5 A",
            "trips   range ~182 km, now -- Wh/km; A 123.4 km, 187 Wh/km, used 23000 Wh, regained 12 Wh; \
             B 0.0 km, -- Wh/km, used 0 Wh, regained 0 Wh",
        ];
        assert_eq!(printed(&[Record::Shown(screen), Record::Trips(trips)]), expected);
    }
}
