//! `cargo xtask decode`: agrees with cantools, streams, counts what it cannot decode.

mod program;

use program::xtask;
use protocol_core::CanFrame;
use protocol_core::codec::{MessageInfo, Mux, SignalInfo};
use protocol_core::generated::MESSAGES;
use serde_json::Value as Json;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Command, Output, Stdio};
use surroundings::need;

const CITY: &str = "vehicles/citybus/captures/city.log";

fn decode(arguments: &[&str]) -> Command {
    let mut command = xtask();
    command.arg("decode").args(arguments);
    command
}

fn decoded(arguments: &[&str]) -> (String, String) {
    let output = decode(arguments).stdin(Stdio::null()).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
}

fn complaint(arguments: &[&str]) -> String {
    let output = decode(arguments).stdin(Stdio::null()).output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{arguments:?} must fail");
    String::from_utf8(output.stderr).unwrap()
}

fn piped(arguments: &[&str], input: &str) -> Output {
    let mut command = decode(arguments);
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

fn written(folder: &tempfile::TempDir, text: &str) -> String {
    let path = folder.path().join("x.log");
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// Compares every signal of every frame of a log with cantools; returns frames and signals compared.
fn compare_with_cantools(python: &Path, dbc: &str, log: &str) -> (usize, usize) {
    let mut command = Command::new(python);
    command.current_dir(surroundings::root()).args(["tools/witness/decode_log.py", dbc, log]);
    let theirs = command.output().unwrap();
    assert!(theirs.status.success(), "{}", String::from_utf8_lossy(&theirs.stderr));
    let theirs = String::from_utf8(theirs.stdout).unwrap();
    let (ours, _) = decoded(&[log, "--format", "json"]);
    let mut ours = ours.lines().map(|line| serde_json::from_str::<Json>(line).unwrap());
    let (mut frames, mut signals) = (0, 0);
    for line in theirs.lines() {
        let frame: Json = serde_json::from_str(line).unwrap();
        let expected = frame["signals"].as_object().unwrap();
        frames += 1;
        for _ in 0..expected.len() {
            let row = ours.next().expect("a row for every signal that cantools decodes");
            let name = row["signal"].as_str().unwrap();
            let place = format!("frame {frames}: {} {}.{name}", row["time"], row["message"]);
            let Some(expected) = expected.get(name) else { panic!("{place}: not in {line}") };
            assert_eq!((&row["id"], &row["message"]), (&frame["id"], &frame["message"]), "{place}");
            assert_eq!(row["raw"], expected["raw"], "{place}");
            assert_eq!(row["word"], expected["word"], "{place}");
            assert_eq!(row["valid"], expected["valid"], "{place}");
            if row["valid"] == true {
                let (ours, theirs) = (row["value"].as_f64().unwrap(), expected["value"].as_f64().unwrap());
                assert!((ours - theirs).abs() <= 1e-9 * theirs.abs().max(1.0), "{place}: {ours} {theirs}");
            } else {
                assert_eq!(row["value"], Json::Null, "{place}");
            }
            signals += 1;
        }
    }
    assert_eq!(ours.next(), None, "a row that cantools does not have");
    (frames, signals)
}

#[test]
fn the_city_drive_decodes_as_cantools_decodes_it() {
    let Some(python) = need::witness("decode of a drive") else { return };
    let (frames, signals) = compare_with_cantools(&python, "vehicles/citybus/citybus.dbc", CITY);
    let recorded = std::fs::read_to_string(surroundings::root().join(CITY)).unwrap().lines().count();
    assert_eq!(frames, recorded);
    println!("{frames} frames, {signals} signals agree with cantools");
}

/// Frames of every message, with bytes from a fixed sequence: invalid values and undefined codes too.
///
/// A multiplexer that selects nothing is an error for cantools, so it always selects something.
fn scrambled_log(messages: &[MessageInfo], rounds: usize) -> String {
    let mut state = 0x2545_F491_u32;
    let mut log = String::new();
    for round in 0..rounds {
        for (index, message) in messages.iter().enumerate() {
            let mut data = [0; 8];
            for byte in data.iter_mut().take(message.len.into()) {
                state ^= state << 13;
                state ^= state >> 17;
                state ^= state << 5;
                *byte = match state >> 24 & 7 {
                    0 => 0x00,
                    1 => 0xFF,
                    _ => state as u8,
                };
            }
            let when = |signal: &SignalInfo| {
                if let Mux::When(raw) = signal.mux { Some(i64::from(raw)) } else { None }
            };
            let states: Vec<i64> = message.signals.iter().filter_map(when).collect();
            if let Some(selector) = message.signals.iter().find(|signal| signal.mux == Mux::Selector) {
                selector.set_raw(&mut data, states[round % states.len()]);
            }
            let frame = CanFrame::from_slice(message.id, &data[..message.len.into()]).unwrap();
            let bytes: String = frame.bytes().iter().map(|byte| format!("{byte:02X}")).collect();
            log += &format!("({round}.{index:06}) can0 {}#{bytes}\n", frame.id);
        }
    }
    log
}

#[test]
fn scrambled_frames_of_every_vehicle_decode_as_cantools_decodes_them() {
    const ROUNDS: usize = 40;
    let Some(python) = need::witness("decode of every message") else { return };
    for (name, messages) in MESSAGES {
        let folder = tempfile::tempdir().unwrap();
        let log = written(&folder, &scrambled_log(messages, ROUNDS));
        let (frames, signals) = compare_with_cantools(&python, &format!("vehicles/{name}/{name}.dbc"), &log);
        assert_eq!(frames, ROUNDS * messages.len());
        println!("{name}: {frames} frames, {signals} signals agree with cantools");
    }
}

#[test]
fn csv_has_a_header_and_as_many_cells_in_every_row() {
    let (csv, _) = decoded(&[CITY, "--format", "csv", "--signals", "VCU1.*"]);
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("time,id,message,signal,raw,value,unit,valid,word"));
    let first = lines.next().unwrap();
    assert_eq!(first, "0.000000,0CF101A7,VCU1,drive_mode,0,0,,true,park");
    assert!(lines.all(|line| line.split(',').count() == 9));
}

#[test]
fn text_stands_in_columns() {
    let (text, said) = decoded(&[CITY, "--signals", "vehicle_speed", "--absolute"]);
    let lines: Vec<&str> = text.lines().collect();
    let column = lines[0].find("value").unwrap();
    assert_eq!(lines[0].find("message"), lines[1].find("VCU1"));
    assert!(lines[1].starts_with("1767225600.000000  0CF101A7  VCU1"), "{}", lines[1]);
    assert!(
        lines[1..].iter().all(|line| line[column..].ends_with("km/h") && !line[column..].starts_with(' '))
    );
    assert!(said.contains("vehicle  citybus: "), "{said}");
}

#[test]
fn signals_are_picked_by_glob_and_a_misspelt_one_gets_the_nearest() {
    let (json, _) = decoded(&[CITY, "--format", "json", "--signals", "bms1.SOC,g?ar"]);
    let names = json.lines().map(|line| serde_json::from_str::<Json>(line).unwrap()["signal"].clone());
    let names: std::collections::BTreeSet<String> = names.map(|name| name.as_str().unwrap().into()).collect();
    assert_eq!(names.into_iter().collect::<Vec<_>>(), ["gear", "soc"]);
    let said = complaint(&[CITY, "--signals", "vehicle_sped"]);
    assert!(
        said.contains("no signal of `citybus` matches `vehicle_sped`; did you mean `vehicle_speed`?"),
        "{said}"
    );
}

#[test]
fn a_misspelt_vehicle_gets_the_nearest() {
    let said = complaint(&[CITY, "--vehicle", "citybsu"]);
    assert!(said.contains("no vehicle is called `citybsu`; did you mean `citybus`?"), "{said}");
}

#[test]
fn signals_are_named_before_the_file_or_behind_it_one_by_one_or_with_commas() {
    let expected = decoded(&[CITY, "--signals", "vehicle_speed,gear,bms1.soc"]).0;
    for signal in ["vehicle_speed", "gear", "soc"] {
        assert!(expected.contains(signal), "{signal}");
    }
    for arguments in [
        &["--signals", "vehicle_speed,gear,bms1.soc", CITY][..],
        &["--signals", "vehicle_speed,gear", "--signals", "bms1.soc", CITY],
        &["--signals=vehicle_speed", CITY, "--signals=gear", "--signals=bms1.soc"],
    ] {
        assert_eq!(decoded(arguments).0, expected, "{arguments:?}");
    }
}

#[test]
fn the_vehicle_is_found_from_the_identifiers_heard() {
    for (name, messages) in MESSAGES {
        let folder = tempfile::tempdir().unwrap();
        let log = written(&folder, &format!("(0.0) can0 7FF#00\n{}", scrambled_log(&messages[..1], 3)));
        let (_, said) = decoded(&[&log]);
        assert!(said.contains(&format!("vehicle  {name}: 1 of its {} messages", messages.len())), "{said}");
    }
    let folder = tempfile::tempdir().unwrap();
    let log = written(&folder, "(0.0) can0 7FF#00\n");
    let said = complaint(&[&log]);
    assert!(said.contains("has any of the identifiers heard (7FF)"), "{said}");
}

#[test]
fn what_cannot_be_decoded_is_counted() {
    let log = "(0.0) can0 0CF101A7#D000000050FF801F\n(0.1) can0 0CF101A7#D000\n(0.2) can0 7FF#00\n\
               (0.3) can0 7FF#01\n(0.4) can0 0CF101A7#R8\n(0.5) can0 20000080#0000000000000000\n";
    let folder = tempfile::tempdir().unwrap();
    let file = written(&folder, log);
    let streamed = piped(&["-"], log);
    assert!(streamed.status.success());
    for said in [decoded(&[&file]).1, String::from_utf8(streamed.stderr).unwrap()] {
        for line in [
            "frames   5 in 0.400 s, 1 decoded",
            "unknown  2: 7FF x 2",
            "short    1: VCU1 (0CF101A7) x 1",
            "remote   1 requests, which carry no signals",
            "errors   1 error frames recorded",
        ] {
            assert!(said.contains(line), "{line} in {said}");
        }
    }
}

#[test]
fn a_stream_is_decoded_as_the_file_is() {
    let log = std::fs::read_to_string(surroundings::root().join(CITY)).unwrap();
    let start: String = log.lines().take(500).map(|line| format!("{line}\n")).collect();
    let folder = tempfile::tempdir().unwrap();
    let file = written(&folder, &start);
    let streamed = piped(&["-", "--format", "csv"], &start);
    assert_eq!(String::from_utf8(streamed.stdout).unwrap(), decoded(&[&file, "--format", "csv"]).0);
}

#[test]
fn a_live_bus_is_decoded_frame_by_frame() {
    let mut child = decode(&["-", "--signals", "VCU1.gear"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let stdout = BufReader::new(child.stdout.take().unwrap());
    let (sender, rows) = std::sync::mpsc::channel();
    let reader =
        std::thread::spawn(move || stdout.lines().map(Result::unwrap).try_for_each(|row| sender.send(row)));
    // A row must come while the stream is still open; a minute is for ever.
    let next =
        || rows.recv_timeout(std::time::Duration::from_secs(60)).expect("a row before the stream ends");
    for (frame, gear) in [("D000000050FF801F", "N"), ("C400000050FF8020", "D"), ("C800000050FF8021", "R")] {
        // candump's screen output without a time.
        let bytes: Vec<String> = (0..8).map(|at| frame[2 * at..2 * at + 2].into()).collect();
        writeln!(stdin, "  can0  0CF101A7   [8]  {}", bytes.join(" ")).unwrap();
        stdin.flush().unwrap();
        let row = match next() {
            head if head.ends_with("value") => next(),
            row => row,
        };
        assert!(row.ends_with(&format!("  {gear}")), "{row}");
    }
    drop(stdin);
    assert!(child.wait().unwrap().success());
    reader.join().unwrap().unwrap();
}

#[test]
fn a_bad_line_of_a_stream_is_named() {
    let output = piped(&["-"], "(0.0) can0 0CF101A7#D000000050FF801F\n(0.1) can0 0CF101A7#D0000\n");
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("stdin:2:21: `D0000` is not pairs of hexadecimal digits (candump -l)"), "{said}");
}

#[test]
fn nobody_reading_on_is_a_quiet_end() {
    let mut child = decode(&[CITY]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut stdout = BufReader::new(child.stdout.take().unwrap());
    stdout.read_line(&mut String::new()).unwrap();
    drop(stdout);
    // What a shell says of a tool that SIGPIPE has ended.
    assert_eq!(child.wait().unwrap().code(), Some(141));
    let mut said = String::new();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    assert_eq!(said, "");
}
