//! Recordings as the commands take and make them: what is left open is asked for, what is a user's is kept.

use serde_json::Value as Json;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

fn root() -> PathBuf {
    surroundings::root()
}

fn xtask(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.current_dir(root()).args(arguments).stdin(Stdio::null()).output().unwrap()
}

/// Runs a command that must succeed and returns what it printed and said.
fn done(arguments: &[&str]) -> (String, String) {
    let output = xtask(arguments);
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {said}");
    (String::from_utf8(output.stdout).unwrap(), said)
}

/// Runs a command that must fail and returns what it said.
fn complaint(arguments: &[&str]) -> String {
    let output = xtask(arguments);
    assert_eq!(output.status.code(), Some(1), "{arguments:?} must fail");
    String::from_utf8(output.stderr).unwrap()
}

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).display().to_string()
    }

    fn written(&self, name: &str, text: &str) -> String {
        let path = self.path(name);
        fs::write(&path, text).unwrap();
        path
    }
}

/// Returns time and speed of every frame that `decode` prints, as written.
fn speeds(json: &str) -> Vec<(String, String)> {
    let row = |line: &str| {
        let row: Json = serde_json::from_str(line).unwrap();
        (row["time"].to_string(), row["value"].to_string())
    };
    json.lines().map(row).collect()
}

const SPEED: [&str; 6] = ["--vehicle", "citybus", "--format", "json", "--signals", "VCU1.vehicle_speed"];

/// A line of candump's screen with VCU1 at this speed, in whole km/h.
fn vcu1(head: &str, speed: u8) -> String {
    format!("{head}  0CF101A7   [8]  D0 00 00 {speed:02X} 50 FF 80 01\n")
}

#[test]
fn two_channels_are_told_apart_by_every_command() {
    let folder = Folder::new();
    let lines = ["1.0) can0", "1.5) can1", "2.0) can0"].iter().zip([50, 0, 51]);
    let text: String =
        lines.map(|(head, speed)| format!("({head} 0CF101A7#D00000{speed:02X}50FF8001\n")).collect();
    let log = folder.written("x.log", &text);
    for command in [&["decode"][..], &["replay"], &["run", "--headless", "--log"]] {
        let said = complaint(&[command, &[&log]].concat());
        assert!(said.contains("the log has 2 channels (can0: 2 frames, can1: 1 frames)"), "{said}");
        assert!(said.contains("--channel"), "{said}");
    }
    let (rows, said) = done(&[&["decode", &log, "--channel", "can0"][..], &SPEED].concat());
    assert_eq!(speeds(&rows), [("0.0".into(), "50".into()), ("1.0".into(), "51".into())]);
    assert!(said.contains("1 frames of other channels are left out"), "{said}");
    let (rows, _) = done(&["replay", &log, "--channel", "can1"]);
    assert!(rows.contains("vehicle.speed               0.0 km/h"), "{rows}");
    let said = complaint(&["run", "--headless", "--channel", "can0"]);
    assert!(said.contains("name one with --log FILE"), "{said}");
}

#[test]
fn times_that_nothing_proves_are_asked_for() {
    let folder = Folder::new();
    let lines = ["000.000000", "000.020000", "000.020000"].iter().zip(10..);
    let text: String = lines.map(|(time, speed)| vcu1(&format!(" ({time})  can0"), speed)).collect();
    let log = folder.written("x.log", &text);
    for command in ["decode", "replay"] {
        let said = complaint(&[command, &log]);
        assert!(
            said.contains("x.log:1: ") && said.contains("`--times absolute` or `--times delta`"),
            "{said}"
        );
    }
    let times = |kind: &str| {
        let (rows, _) = done(&[&["decode", &log, "--times", kind][..], &SPEED].concat());
        speeds(&rows).into_iter().map(|(time, _)| time).collect::<Vec<_>>()
    };
    assert_eq!(times("delta"), ["0.0", "0.02", "0.04"]);
    assert_eq!(times("absolute"), ["0.0", "0.02", "0.02"]);
}

#[test]
fn a_recording_without_times_is_decoded_without_and_played_at_a_rate_that_is_said() {
    let folder = Folder::new();
    let text: String = (0..100).map(|speed| vcu1("  can0", speed)).collect();
    let log = folder.written("x.log", &text);
    let (rows, said) = done(&[&["decode", &log][..], &SPEED].concat());
    assert_eq!(speeds(&rows)[99], ("null".into(), "99".into()));
    assert!(said.contains("frames   100 without times, 100 decoded"), "{said}");
    for command in [&["replay"][..], &["run", "--headless", "--log"]] {
        let said = complaint(&[command, &[&log]].concat());
        assert!(said.contains("x.log:1: the log has no times: say with `--spacing-ms N`"), "{said}");
    }
    let (rows, _) = done(&["replay", &log, "--spacing-ms", "20"]);
    assert!(rows.contains("frames   100 in 1.980 s"), "{rows}");
    assert!(rows.contains("     0.490  vehicle.speed               24.0 km/h"), "{rows}");
}

#[test]
fn what_was_left_out_or_mended_is_said_beside_the_output() {
    let folder = Folder::new();
    let good = vcu1(" (1597294762.404524)  can0", 10);
    let text = format!("$ candump can0\n{good}{}^C\n{}", vcu1(" (1597294762.404520)  can0", 11), &good[..30]);
    let log = folder.written("x.log", &text);
    for command in ["decode", "replay"] {
        let (_, said) = done(&[command, &log]);
        for note in [
            "x.log: 2 lines are no frames, the first is line 1",
            "x.log: 1 frames are dated up to 0.000004 s before the one above and take its time",
            "x.log: the last line is cut off; 2 frames before it were read",
        ] {
            assert!(said.contains(note), "{command}: {said}");
        }
    }
}

#[test]
fn a_time_below_zero_is_printed_as_the_recorder_wrote_it() {
    let folder = Folder::new();
    let text = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n\
                -1500000,0CF101A7,true,Rx,0,8,D0,00,00,0A,50,FF,80,01,\n\
                1,0CF101A7,true,Rx,0,8,D0,00,00,0B,50,FF,80,01,\n";
    let log = folder.written("x.csv", text);
    let (rows, _) = done(&[&["decode", &log, "--absolute"][..], &SPEED].concat());
    assert_eq!(speeds(&rows), [("-1.5".into(), "10".into()), ("1e-6".into(), "11".into())]);
}

#[test]
fn a_recording_is_converted_in_every_form_and_back() {
    let folder = Folder::new();
    let text = "(1767225600.000001) can0 123#0102\n(1767225600.250000) can1 18FEF100#01020304050607AB\n\
                (1767225601.000000) can0 124#R4\n(1767225602.000000) can1 125#0102030405060708_D\n";
    let log = folder.written("a.log", text);
    let (asc, back) = (folder.path("a.asc"), folder.path("b.log"));
    let (said, _) = done(&["convert", &log, &asc]);
    assert!(said.contains("a.asc: 4 frames (candump -l)"), "{said}");
    let written = fs::read_to_string(&asc).unwrap();
    assert!(written.starts_with("date Thu Jan 01 12:00:00.000 am 2026\n"), "{written}");
    assert!(
        written.contains("\n   0.249999 2  18FEF100x       Rx   d 8 01 02 03 04 05 06 07 AB\n"),
        "{written}"
    );
    done(&["convert", &asc, &back]);
    let expected = "(0.000000) can0 123#0102\n(0.249999) can1 18FEF100#01020304050607AB\n\
                    (0.999999) can0 124#R4\n(1.999999) can1 125#0102030405060708_D\n";
    assert_eq!(fs::read_to_string(&back).unwrap(), expected);
    let csv = folder.path("a.csv");
    let said = complaint(&["convert", &log, &csv]);
    assert!(said.contains("the log has 2 channels (can0: 2 frames, can1: 2 frames)"), "{said}");
    assert!(!fs::exists(&csv).unwrap(), "nothing is written then");
    done(&["convert", &log, &csv, "--channel", "can0"]);
    let rows = "timestamp,arbitration_id,extended,remote,error,dlc,data\n1767225600.000001,0x123,0,0,0,2,AQI=\n\
                1767225601.000000,0x124,0,1,0,4,\n";
    assert_eq!(fs::read_to_string(&csv).unwrap(), rows);
    let said = complaint(&["convert", &log, &asc]);
    assert!(said.contains("a.asc is already there"), "{said}");
    let said = complaint(&["convert", &log, &folder.path("a.xyz")]);
    assert!(said.contains(".xyz is no form that is written"), "{said}");
}

#[test]
fn a_conversion_that_fails_leaves_nothing() {
    let folder = Folder::new();
    let log = folder.written("a.log", "(2.0) can0 123#01\n(1.0) can0 123#02\n");
    let said = complaint(&["convert", &log, &folder.path("b.asc"), "--times", "absolute"]);
    assert!(said.contains("a.log:2: time goes back by 1.000000 s"), "{said}");
    assert_eq!(fs::read_dir(folder.0.path()).unwrap().count(), 1);
}

#[test]
fn strict_refuses_what_is_otherwise_said() {
    let folder = Folder::new();
    let log = folder.written("x.log", &format!("{}hello\n", vcu1(" (1.0)  can0", 10)));
    for command in ["decode", "replay"] {
        let (_, said) = done(&[command, &log]);
        assert!(said.contains("1 line is no frame: line 2"), "{said}");
        let said = complaint(&[command, &log, "--strict"]);
        assert!(said.contains("x.log:2: the line is no frame, and `--strict` leaves nothing out"), "{said}");
    }
}

#[test]
fn the_silence_after_the_last_frame_is_played_if_asked_for() {
    let folder = Folder::new();
    // Shorter than the time after which a counter that stands still is no sign of life.
    let lines = (0..20).map(|n| vcu1(&format!(" (1.{:02})  can0", n * 2), 10));
    let log = folder.written("x.log", &lines.collect::<String>());
    let (short, _) = done(&["replay", &log]);
    assert!(short.contains("vehicle.speed               10.0 km/h"), "{short}");
    assert!(!short.contains("-- (stale)"), "{short}");
    let (long, _) = done(&["replay", &log, "--tail", "5"]);
    let stale = long.lines().find(|line| line.contains("vehicle.speed") && line.contains("-- (stale)"));
    assert!(stale.is_some(), "{long}");
    assert!(
        long.starts_with(short.split("\nvehicle ").next().unwrap()),
        "what was played before is the same"
    );
    assert!(long.lines().any(|line| line.contains("noted")), "the lost node is noted: {long}");
    assert!(long.contains("frames   20 in 0.380 s"), "the summary is of the recording: {long}");
}

/// What would clear the screen, and what would write from right to left.
const STEERING: &str = "\u{1b}[2J\u{9b}2J\u{202e}\u{7}";

#[test]
fn nothing_that_a_file_says_can_steer_the_terminal() {
    let folder = Folder::new();
    let good = "(1.0) can0 0CF101A7#D000000A50FF8001\n";
    let in_data = folder.written("data.log", &format!("{good}(2.0) can0 123#{STEERING}\n"));
    let in_channel =
        folder.written("channel.log", &format!("{good}(2.0) {STEERING} 0CF101A7#D000000A50FF8001\n"));
    let in_name = folder.written(&format!("{STEERING}.log"), &format!("{good}hello\n"));
    let in_type = folder.written("type.trc", &format!(";$FILEVERSION=1.1\n1) 1.0 {STEERING} 0123 1 00\n"));
    let dbc = folder
        .written("x.dbc", &format!("VERSION \"\"\n\nBU_: A\n\nBO_ 1 M: 8 A\n SG_ {STEERING} : 0|8@1+\n"));
    let missing = folder.path(&format!("no{STEERING}"));
    let cases: &[&[&str]] = &[
        &["decode", &in_data],
        &["replay", &in_data],
        &["decode", &in_channel],
        &["replay", &in_type],
        &["decode", &in_name],
        &["replay", &in_name],
        &["convert", &in_name, &folder.path(&format!("{STEERING}.asc"))],
        &["decode", &missing],
        &["listen", &in_name],
        &["listen", &missing],
        &["dbc", &dbc],
        &["run", "--headless", "--log", &missing],
    ];
    for arguments in cases {
        let Output { stdout, stderr, .. } = xtask(arguments);
        for printed in [stdout, stderr] {
            let printed = String::from_utf8(printed).unwrap();
            let obeyed = |sign: char| sign.is_control() && sign != '\n' && sign != '\t' || sign == '\u{202e}';
            assert!(!printed.contains(obeyed), "{arguments:?}: {printed:?}");
        }
    }
}

/// The image that `cargo xtask test` builds first.
fn elf() -> String {
    let built = || root().join("target/out/cluster-ili9341.elf");
    let path = std::env::var_os("CLUSTER_ELF").map_or_else(built, PathBuf::from);
    assert!(path.exists(), "{} is not built: run `cargo xtask test`, which builds it first", path.display());
    path.display().to_string()
}

/// A headless run of the firmware.
fn headless<'a>(elf: &'a str, arguments: &[&'a str]) -> Vec<&'a str> {
    [&["run", "--headless", "--elf", elf][..], arguments].concat()
}

#[test]
fn a_recording_is_never_written_over_what_is_played_nor_over_another_file_unasked() {
    let (folder, elf) = (Folder::new(), elf());
    let text = "(1.0) can0 0CF101A7#D000000A50FF8001\n";
    let log = folder.written("a.log", text);
    let other = folder.written("b.log", "precious");
    let linked = folder.path("c.log");
    fs::hard_link(&log, &linked).unwrap();
    for (record, overwrite) in [(&log, true), (&linked, true), (&log, false)] {
        let mut arguments = headless(&elf, &["--log", &log, "--record", record]);
        arguments.extend(overwrite.then_some("--overwrite"));
        let said = complaint(&arguments);
        assert!(said.contains("is the same file as"), "{said}");
    }
    for option in ["--record", "--screenshot"] {
        let said = complaint(&headless(&elf, &["--log", &log, option, &other]));
        assert!(said.contains("b.log is already there; choose another name, or say --overwrite"), "{said}");
        let said = complaint(&headless(&elf, &["--log", &log, option, "no/such/folder/x"]));
        assert!(said.contains("there is no folder no/such/folder"), "{said}");
    }
    assert_eq!(
        (fs::read_to_string(log).unwrap(), fs::read_to_string(other).unwrap()),
        (text.into(), "precious".into())
    );
}

#[test]
fn a_short_recording_is_the_beginning_of_a_long_one_up_to_its_last_frame() {
    let (folder, elf) = (Folder::new(), elf());
    let recorded = |name: &str, seconds: &str| {
        let path = folder.path(name);
        let (printed, _) = done(&headless(&elf, &["--seconds", seconds, "--record", &path]));
        let text = fs::read_to_string(path).unwrap();
        (text.lines().map(str::to_owned).collect::<Vec<_>>(), printed)
    };
    let (short, printed) = recorded("short.log", "1.0");
    let (long, _) = recorded("long.log", "1.1");
    let before = |line: &&String| line.starts_with("(0.");
    assert_eq!(
        short.iter().filter(before).collect::<Vec<_>>(),
        long.iter().filter(before).collect::<Vec<_>>()
    );
    assert!(short.len() > 100, "{} frames", short.len());
    // The numbers of the summary add up: nothing is missing between the bus and the controller.
    let frames = printed.lines().find(|line| line.starts_with("frames ")).unwrap();
    let numbers: Vec<u64> = frames.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    assert!(numbers.len() == 3 && numbers[0] == numbers[1] + numbers[2], "{frames}");
    assert!(printed.contains("received, by its last report"), "{printed}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_ends_the_run_with_an_error_that_says_what_is_safe() {
    let elf = elf();
    // A device that is always full.
    let output = xtask(&headless(&elf, &["--seconds", "60", "--record", "/dev/full", "--overwrite"]));
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("the recording in /dev/full ended early: "), "{said}");
    assert!(said.contains("0 frames are safely in the log"), "{said}");
    assert!(!String::from_utf8(output.stdout).unwrap().contains("drove"), "the run ends there");
}

#[cfg(unix)]
#[test]
fn a_recording_that_ran_out_of_room_is_left_in_whole_lines() {
    let (folder, elf) = (Folder::new(), elf());
    let log = folder.path("x.log");
    // The largest file is a few kilobytes; the signal that would end the process is ignored, as on a full disk there is none.
    let limited = "trap '' XFSZ; ulimit -f 8; exec \"$0\" \"$@\"";
    let mut command = Command::new("sh");
    command.current_dir(root()).args(["-c", limited, env!("CARGO_BIN_EXE_xtask")]);
    let output = command.args(headless(&elf, &["--seconds", "60", "--record", &log])).output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{said}");
    let text = fs::read_to_string(&log).unwrap();
    let frames = text.lines().count();
    assert!(frames > 50 && text.ends_with('\n'), "{frames} frames");
    assert!(said.contains("x.log ended early: "), "{said}");
    assert!(said.contains(&format!("; {frames} frames are safely in the log")), "{frames} frames: {said}");
    let (_, said) = done(&["decode", &log, "--vehicle", "citybus"]);
    assert!(said.contains(&format!("frames   {frames} in ")), "{said}");
}

#[test]
fn a_screenshot_replaces_an_old_one_as_a_whole_if_asked() {
    let (folder, elf) = (Folder::new(), elf());
    let old = folder.written("x.png", "old");
    done(&headless(&elf, &["--seconds", "0.1", "--screenshot", &old, "--overwrite"]));
    assert!(fs::read(&old).unwrap().starts_with(b"\x89PNG"));
    assert_eq!(fs::read_dir(folder.0.path()).unwrap().count(), 1, "nothing else is left");
}
