//! `cargo xtask replay`: what the cluster shows of a recording, as it changes.

mod program;

use program::xtask;
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::process::Output;

const CITY: &str = "vehicles/citybus/captures/city.log";

fn run(arguments: &[&str]) -> Output {
    xtask().args(arguments).output().unwrap()
}

fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn json(text: &str) -> Vec<Json> {
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}")))
        .collect()
}

fn replayed(log: &str) -> Vec<Json> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.log");
    std::fs::write(&path, log).unwrap();
    json(&printed(&["replay", path.to_str().unwrap(), "--json"]))
}

#[test]
fn only_changes_are_printed_in_order_of_time() {
    let mut rows = json(&printed(&["replay", CITY, "--json"]));
    let summary = rows.pop().unwrap();
    assert_eq!((&summary["name"], &summary["vehicle"]), (&"summary".into(), &"citybus".into()));
    assert_eq!(summary["frames"].as_u64(), Some(6_620));
    assert_eq!(summary["taken"].as_u64().unwrap() + summary["for_others"].as_u64().unwrap(), 6_620);
    let mut last: BTreeMap<String, Json> = BTreeMap::new();
    let mut time = 0.0;
    for mut row in rows {
        let at = row.as_object_mut().unwrap().remove("time").unwrap().as_f64().unwrap();
        assert!(at >= time, "{row}");
        time = at;
        let name = row["name"].as_str().unwrap().to_owned();
        if let Some(shown) = row.get("shown").cloned() {
            assert_ne!(last.get(&name).map(|row| &row["shown"]), Some(&shown), "{name} at {at}");
        } else {
            assert_ne!(last.get(&name), Some(&row), "{name} at {at}");
        }
        last.insert(name, row);
    }
    // The witness of the last speed: what decode says, in whole 1/256 km/h.
    let speeds = json(&printed(&["decode", CITY, "--format", "json", "--signals", "VCU1.vehicle_speed"]));
    let speed = speeds.last().unwrap()["value"].as_f64().unwrap();
    let shown = last["vehicle.speed"]["shown"].as_str().unwrap();
    assert_eq!(shown, format!("{:.1} km/h", (speed * 10.0).floor() / 10.0));
    assert_eq!(last["vehicle.gear"]["shown"], "D");
}

#[test]
fn text_says_the_same_as_json() {
    let text = printed(&["replay", CITY]);
    let rows = json(&printed(&["replay", CITY, "--json"]));
    let (lines, summary) = text.split_once("\n\n").unwrap();
    assert_eq!(lines.lines().count(), rows.len() - 1);
    for (line, row) in lines.lines().zip(&rows) {
        let mut words = line.split_whitespace();
        assert_eq!(words.next().unwrap().parse::<f64>().unwrap(), row["time"].as_f64().unwrap());
        assert_eq!(words.next(), row["name"].as_str());
        assert!(row.get("shown").is_none_or(|shown| line.ends_with(shown.as_str().unwrap())), "{line} {row}");
    }
    assert!(summary.starts_with("vehicle  citybus\nframes   6620 in 59.979 s: "), "{summary}");
}

#[test]
fn silence_is_shown_as_stale_and_an_invalid_value_as_invalid() {
    // Speed 48.5 km/h in D; then only the battery is heard; then a speed that is "not available".
    let rows = replayed(
        "(0.0) can0 0CF101A7#0400803000FF8000\n(3.0) can0 18F13DF3#0000000000000000\n\
         (3.1) can0 0CF101A7#0400FFFF00FF8001\n",
    );
    let speeds: Vec<&str> = rows
        .iter()
        .filter(|row| row["name"] == "vehicle.speed")
        .map(|row| row["shown"].as_str().unwrap())
        .collect();
    assert_eq!(speeds, ["48.5 km/h", "-- (stale)", "-- (invalid)"]);
}

#[test]
fn a_fault_lights_a_lamp_and_writes_a_line() {
    // The battery reports level 3, the worst, once the bulb check is over.
    let frames = (0..12).map(|at| format!("({}.500000) can0 18F13DF3#0000000000000300\n", at));
    let rows = replayed(&frames.collect::<String>());
    let lamps: Vec<&Json> = rows.iter().filter(|row| row["name"] == "lamps").collect();
    assert_eq!(lamps[0]["all"], true);
    let lit = lamps.last().unwrap()["lit"].as_array().unwrap();
    assert!(lit.contains(&"battery_fault".into()), "{lit:?}");
    let line = rows.iter().rfind(|row| row["name"] == "line").unwrap();
    assert!(line["zh"].is_string() && line["en"].is_string(), "{line}");
    assert_eq!(line["fault"], "silent_vcu", "nobody else is on this bus: {line}");
    for name in ["line", "noted"] {
        assert!(rows.iter().any(|row| row["name"] == name && row["fault"] == "battery_code"), "{name}");
    }
    assert!(rows.iter().any(|row| row["name"] == "sound" && row["frequency_hz"].is_u64()));
}

#[test]
fn frames_that_are_not_taken_are_counted() {
    let rows = replayed(
        "(0.0) can0 0CF101A7#0400803000FF8000\n(0.1) can0 0CF101A7#04\n(0.2) can0 7FF#00\n\
         (0.3) can0 0CF102A7#0000000000000000\n(0.4) can0 0CF101A7#R8\n",
    );
    let summary = rows.last().unwrap();
    for (name, count) in
        [("taken", 1), ("short", 1), ("unknown", 1), ("for_others", 1), ("remote", 1), ("frames", 5)]
    {
        assert_eq!(summary[name], count, "{name} in {summary}");
    }
}

#[test]
fn a_jump_of_the_recorders_clock_is_named_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("jump.log");
    std::fs::write(
        &path,
        "(0.0) can0 0CF101A7#0400803000FF8000\n(1767225600.0) can0 0CF101A7#0400803000FF8001\n",
    )
    .unwrap();
    let output = run(&["replay", path.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("jump.log:2: the time jumps by more than a day; cut the log there"), "{said}");
}
