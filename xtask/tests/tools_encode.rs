//! `cargo xtask encode`: the inverse of decode, and errors that say what would be right.

mod program;

use program::xtask;
use protocol_core::codec::{MessageInfo, Mux, SignalInfo};
use protocol_core::generated::MESSAGES;
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::process::Output;

fn encode(arguments: &[&str]) -> Output {
    xtask().arg("encode").args(arguments).output().unwrap()
}

fn encoded(arguments: &[&str]) -> String {
    let output = encode(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap().trim_end().into()
}

fn complaint(arguments: &[&str]) -> String {
    let output = encode(arguments);
    assert_eq!(output.status.code(), Some(1), "{arguments:?} must fail");
    String::from_utf8(output.stderr).unwrap()
}

/// Decodes frames and returns, per frame, what decode says of each signal.
fn decoded(vehicle: &str, frames: &[String]) -> Vec<BTreeMap<String, Json>> {
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("x.log");
    let line = |(index, frame): (usize, &String)| format!("({index}.0) can0 {frame}\n");
    std::fs::write(&log, frames.iter().enumerate().map(line).collect::<String>()).unwrap();
    let mut command = xtask();
    let output =
        command.args(["decode", "--format", "json", "--vehicle", vehicle]).arg(&log).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let mut rows = vec![BTreeMap::new(); frames.len()];
    for line in String::from_utf8(output.stdout).unwrap().lines() {
        let row: Json = serde_json::from_str(line).unwrap();
        let index = row["time"].as_f64().unwrap() as usize;
        rows[index].insert(row["signal"].as_str().unwrap().to_owned(), row);
    }
    rows
}

/// Signals that a frame can carry together, for each state of the multiplexer.
fn groups(message: &MessageInfo) -> Vec<Vec<&SignalInfo>> {
    let always = || message.signals.iter().filter(|signal| signal.mux == Mux::Always);
    let mut states: Vec<u32> = Vec::new();
    for signal in message.signals {
        if let Mux::When(raw) = signal.mux
            && !states.contains(&raw)
        {
            states.push(raw);
        }
    }
    if states.is_empty() {
        return vec![always().collect()];
    }
    let of = |state| message.signals.iter().filter(move |signal| signal.mux == Mux::When(state));
    states.into_iter().map(|state| always().chain(of(state)).collect()).collect()
}

/// A valid raw value: lowest, highest, or in the middle.
fn pick(signal: &SignalInfo, which: usize) -> i64 {
    let (low, high) = signal.range;
    let candidates = match which {
        0 => [low, low + 1],
        1 => [high, high - 1],
        _ => [low + (high - low) / 2, high],
    };
    candidates.into_iter().find(|&raw| signal.is_valid(raw)).unwrap()
}

#[test]
fn every_message_of_every_vehicle_survives_encode_and_decode() {
    for (vehicle, messages) in MESSAGES {
        let mut frames = Vec::new();
        let mut made_of = Vec::new();
        for message in *messages {
            for group in groups(message) {
                for which in 0..3 {
                    let values: Vec<(&str, i64)> =
                        group.iter().map(|signal| (signal.name, pick(signal, which))).collect();
                    let raws: Vec<String> =
                        values.iter().map(|(name, raw)| format!("{name}=raw:{raw}")).collect();
                    let mut arguments = vec![message.name, "--vehicle", vehicle];
                    arguments.extend(raws.iter().map(String::as_str));
                    frames.push(encoded(&arguments));
                    made_of.push((message, values));
                }
            }
        }
        let rows = decoded(vehicle, &frames);
        for ((frame, row), (message, values)) in frames.iter().zip(&rows).zip(&made_of) {
            for (name, raw) in values {
                assert_eq!(row[*name]["raw"], *raw, "{vehicle} {frame} {name}");
                assert_eq!(row[*name]["valid"], true, "{vehicle} {frame} {name}");
            }
            // And back from the everyday values, by word where there is one.
            let text =
                |row: &Json| row["word"].as_str().map_or_else(|| row["value"].to_string(), str::to_owned);
            let values: Vec<String> = row.iter().map(|(name, row)| format!("{name}={}", text(row))).collect();
            let mut arguments = vec![message.name, "--vehicle", vehicle];
            arguments.extend(values.iter().map(String::as_str));
            assert_eq!(encoded(&arguments), *frame, "{vehicle} {values:?}");
        }
    }
}

#[test]
fn what_is_not_given_has_its_start_value() {
    for (vehicle, messages) in MESSAGES {
        let names = messages.iter().map(|message| (message, encoded(&[message.name, "--vehicle", vehicle])));
        let (infos, frames): (Vec<&MessageInfo>, Vec<String>) = names.unzip();
        for (message, row) in infos.iter().zip(decoded(vehicle, &frames)) {
            for signal in message.signals.iter().filter(|signal| !matches!(signal.mux, Mux::When(_))) {
                assert_eq!(
                    row[signal.name]["raw"], signal.start_raw,
                    "{vehicle} {}.{}",
                    message.name, signal.name
                );
            }
        }
    }
}

#[test]
fn a_frame_is_printed_as_cansend_takes_it() {
    let frame = encoded(&["0CF101A7", "vehicle_speed=48.5", "gear=D", "ready=yes", "life=raw:0x1F"]);
    assert_eq!(frame, "0CF101A7#0400803000FF801F");
}

#[test]
fn the_multiplexer_follows_its_signals() {
    let torque = encoded(&["VCUToMCU", "torque=12"]);
    let speed = encoded(&["VCUToMCU", "speed=300"]);
    let rows = decoded("c5ev", &[torque, speed]);
    assert_eq!((&rows[0]["control_mode"]["raw"], &rows[0]["torque"]["raw"]), (&1.into(), &12.into()));
    assert_eq!((&rows[1]["control_mode"]["raw"], &rows[1]["speed"]["raw"]), (&2.into(), &300.into()));
    assert!(!rows[1].contains_key("torque"));
    let said = complaint(&["VCUToMCU", "torque=12", "speed=300"]);
    assert!(said.contains("`speed` is sent only while `control_mode` is raw:2"), "{said}");
}

#[test]
fn a_name_that_two_vehicles_have_is_decided_by_the_signals_or_asked_for() {
    let said = complaint(&["VCU1"]);
    assert!(said.contains("`VCU1` is a message of citybus and jiulong; say which with --vehicle"), "{said}");
    assert!(encoded(&["VCU1", "vehicle_speed=0"]).starts_with("0CF101A7#"));
}

#[test]
fn misspelt_names_get_the_nearest_match() {
    for (arguments, expected) in [
        (&["Insulaton"][..], "no message is called `Insulaton`; did you mean `Insulation`?"),
        (
            &["0CF101A7", "vehicle_sped=1"],
            "`VCU1` has no signal `vehicle_sped`; did you mean `vehicle_speed`?",
        ),
        (&["0CF101A7", "ready=yess"], "nor raw:N; did you mean `yes`?"),
        (&["VCU1", "--vehicle", "jiulnog"], "no vehicle is called `jiulnog`; did you mean `jiulong`?"),
        (&["0CF101A7", "ready"], "`ready` is not SIGNAL=VALUE"),
        (&["0CF101A7", "ready=yes", "ready=no"], "`ready` is given twice"),
    ] {
        let said = complaint(arguments);
        assert!(said.contains(expected), "{said}");
    }
}

#[test]
fn values_that_cannot_be_sent_are_named_all_at_once_with_the_nearest_valid_ones() {
    let said = complaint(&["0CF101A7", "vehicle_speed=48.501", "accelerator_pedal=101", "gear=raw:16"]);
    for line in [
        "`vehicle_speed` goes in steps of 0.00390625 km/h; nearest valid: 48.5 and 48.50390625 km/h",
        "`accelerator_pedal` is valid from 0 to 100 %; nearest valid: 100 %",
        "`gear` has 4 bits: raw 0 to 15, not 16",
    ] {
        assert!(said.contains(line), "{said}");
    }
}
