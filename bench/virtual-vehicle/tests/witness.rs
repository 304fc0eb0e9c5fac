//! The frames of the virtual vehicle against cantools, which read the same DBC independently, and against the truth.
//!
//! 36 s of each vehicle go through `tools/witness/vehicle_log.py` as a candump log: every frame must be known, full,
//! within its limits, filled as its document says and in time; every value that it says must be what was true in the
//! vehicle when the frame was made. Runs with the interpreter in `WITNESS_PYTHON`, else the one that
//! `cargo xtask test` installs, else `python3`.

mod truth;

use protocol_core::generated;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use surroundings::{need, root};
use truth::{drive, truths};
use virtual_vehicle::{Kind, Options, STEP_MS, VirtualVehicle};

/// What was true when a frame was made: signal and value.
type Facts = Vec<(&'static str, f64)>;

/// Returns a log of a vehicle on a short drive that ends at the plug, and what was true in each frame.
fn log(kind: Kind) -> (String, Vec<Facts>) {
    let options = Options { optional: true, ..Options::default() };
    let (mut log, mut facts) = (String::new(), Vec::new());
    let mut vehicle = VirtualVehicle::new(kind, options);
    let named = generated::MESSAGES.iter().find(|(name, _)| *name == kind.name());
    let messages = named.expect("a generated vehicle of this name").1;
    for second in 0..36 {
        drive(&mut vehicle, second);
        for _ in 0..1_000 / STEP_MS {
            vehicle.advance();
            for sent in vehicle.take_frames() {
                let (seconds, micros) = (sent.at_us / 1_000_000, sent.at_us % 1_000_000);
                write!(log, "({}.{micros:06}) can0 {}#", 1_700_000_000 + seconds, sent.frame.id)
                    .expect("a string takes all");
                for byte in sent.frame.bytes() {
                    write!(log, "{byte:02X}").expect("a string takes all");
                }
                log.push('\n');
                let name = messages.iter().find(|info| info.id == sent.frame.id).map(|info| info.name);
                let of_this = truths(kind).iter().filter(|(message, ..)| Some(*message) == name);
                facts.push(of_this.map(|(_, signal, truth)| (*signal, truth(vehicle.world()))).collect());
            }
        }
    }
    (log, facts)
}

/// Returns half a count and the limits of a signal, in its unit.
fn step_of(kind: Kind, message: &str, signal: &str) -> (f64, f64, f64) {
    let named = generated::MESSAGES.iter().find(|(name, _)| *name == kind.name());
    let info = named.and_then(|(_, messages)| messages.iter().find(|info| info.name == message));
    let row = info.and_then(|info| info.signal(signal)).expect("a signal of this name");
    let physical = |raw: i64| row.scale.counts(raw) as f64 / f64::from(row.scale.den);
    let half = f64::from(row.scale.mul.abs()) / f64::from(row.scale.den) / 2.0;
    (half, physical(row.range.0), physical(row.range.1))
}

fn compare(python: &Path, kind: Kind) {
    let (text, facts) = log(kind);
    let file = surroundings::scratch().join(format!("vehicle-{}.log", kind.name()));
    std::fs::write(&file, text).expect("the target folder takes a file");
    let output = Command::new(python)
        .arg(root().join("tools/witness/vehicle_log.py"))
        .arg(root().join(format!("vehicles/{0}/{0}.dbc", kind.name())))
        .arg(&file)
        .output()
        .expect("the interpreter starts");
    assert!(output.status.success(), "{}: {}", kind.name(), String::from_utf8_lossy(&output.stderr));
    let (mut values, mut compared, mut frames) = (0, 0, BTreeSet::new());
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let [number, message, signal, value] = line.split('\t').collect::<Vec<_>>()[..] else {
            panic!("four fields in `{line}`");
        };
        let number: usize = number.parse().expect("a frame's number");
        frames.insert(number);
        values += 1;
        let Some((_, truth)) = facts[number].iter().find(|(name, _)| *name == signal) else { continue };
        // What its sender has not heard yet is not true and not false.
        if truth.is_nan() {
            continue;
        }
        let (half, low, high) = step_of(kind, message, signal);
        let value: f64 = value.parse().unwrap_or_else(|_| panic!("{message}.{signal} is not available"));
        let truth = truth.clamp(low, high);
        assert!(
            (value - truth).abs() <= half + 1e-6,
            "{message}.{signal}: cantools reads {value}, not {truth}"
        );
        compared += 1;
    }
    assert_eq!(frames.len(), facts.len(), "every frame was decoded");
    assert!(compared > 1_000, "{compared} values compared");
    println!(
        "{}: {} frames and {values} values as cantools has them, {compared} as they are true",
        kind.name(),
        frames.len()
    );
}

#[test]
fn cantools_reads_out_of_the_frames_what_is_true_in_the_vehicle() {
    let Some(python) = need::witness("the frames of the virtual vehicle") else { return };
    std::thread::scope(|scope| {
        for kind in Kind::ALL {
            let python = &python;
            scope.spawn(move || compare(python, kind));
        }
    });
}
