//! Prints the records that a cluster sends on its UART.
//!
//! Reads bytes from a serial device, a file or standard input, so that any tool that sets a port up can feed it.
//! Noise is counted and skipped: the decoder finds the next record by itself.

use anyhow::{Context, Result};
use clap::Args;
use protocol_core::Value;
use protocol_core::link::{Decoder, Health, Record, Sample, Screen};
use std::fs::File;
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// Where the bytes come from.
#[derive(Args, Debug)]
pub struct Options {
    /// Serial device or file; `-` is standard input. On Linux set the port up first:
    /// `stty -F /dev/ttyUSB0 115200 raw -echo`.
    source: PathBuf,
}

/// Prints every record until the source ends.
///
/// # Errors
/// If the source cannot be opened or read.
pub fn run(options: &Options) -> Result<()> {
    let mut source: Box<dyn Read> = if options.source == Path::new("-") {
        Box::new(std::io::stdin().lock())
    } else {
        let name = options.source.display();
        Box::new(File::open(&options.source).with_context(|| format!("cannot open {name}"))?)
    };
    match print(&mut source, &mut std::io::stdout().lock()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result.context("the source ended with an error"),
    }
}

fn print(source: &mut dyn Read, out: &mut dyn Write) -> std::io::Result<()> {
    let (mut decoder, mut damaged, mut bytes) = (Decoder::new(), 0_u64, [0; 256]);
    loop {
        let length = source.read(&mut bytes)?;
        if length == 0 {
            break;
        }
        for &byte in &bytes[..length] {
            match decoder.push(byte) {
                Some(Ok(record)) => write_record(&record, out)?,
                // The first one is what was cut off when listening began.
                Some(Err(_)) => damaged += 1,
                None => {}
            }
        }
        out.flush()?;
    }
    if damaged > 0 {
        eprintln!("{damaged} damaged records skipped");
    }
    Ok(())
}

fn write_record(record: &Record, out: &mut dyn Write) -> std::io::Result<()> {
    match record {
        Record::Hello { version, vehicle, build } => {
            let vehicle =
                if vehicle.as_str().is_empty() { "a vehicle not known yet" } else { vehicle.as_str() };
            writeln!(out, "hello   firmware {} for {vehicle}, build {build:08x}", version.as_str())
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
        Record::Shown(screen) => write_screen(screen, out),
        Record::Panic { line, text } => writeln!(out, "panic   line {line}: {}", text.as_str()),
        #[allow(unreachable_patterns, reason = "records of a newer version")]
        other => writeln!(out, "other   {other:?}"),
    }
}

fn write_health(health: &Health, out: &mut dyn Write) -> std::io::Result<()> {
    writeln!(
        out,
        "health  up {}.{:03} s, CAN {:?} (TEC {}, REC {}), received {}, sent {}, unknown {}, short {}, overruns {}, \
         queue overflows {}, idle {}.{} %, last reset {:?}",
        health.uptime_ms / 1000,
        health.uptime_ms % 1000,
        health.can_state,
        health.tec,
        health.rec,
        health.frames_received,
        health.frames_sent,
        health.frames_unknown,
        health.frames_dropped_short,
        health.overruns,
        health.ring_overflows,
        health.idle_permille / 10,
        health.idle_permille % 10,
        health.last_reset,
    )
}

fn write_screen(screen: &Screen, out: &mut dyn Write) -> std::io::Result<()> {
    let line = screen.line.map_or(String::new(), |line| {
        let code = line.code.map_or(String::new(), |code| format!(" code {code}"));
        format!(", line {:04x}{code} severity {}", line.text, line.severity)
    });
    writeln!(
        out,
        "shown   {} km/h, SOC {} %, lamps {:06x}{line}",
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
    use protocol_core::link::{Chunk, MAX_FRAME, encode};

    #[test]
    fn records_are_printed_in_order_and_noise_between_them_is_skipped() {
        let items = [Sample::Value(12_425), Sample::Value(1)].into_iter().collect::<Chunk>();
        let records = [
            Record::Hello { version: "0.1.0".into(), vehicle: "bus".into(), build: 7 },
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
            "hello firmware 0.1.0 for bus, build 00000007",
            "value vehicle.speed 48.5 km/h",
            "value vehicle.gear D",
        ];
        assert_eq!(lines, expected);
    }
}
