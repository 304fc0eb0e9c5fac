//! Whose reader is gone and whose disk is full: no command panics, and the exit code says which it was.

#![cfg(unix)]

mod program;

use program::xtask;
use std::collections::BTreeSet;
use std::fs::File;
use std::process::{Command, Output, Stdio};

const CITY: &str = "vehicles/citybus/captures/city.log";
/// What a shell says of a tool that SIGPIPE has ended.
const NOBODY_READS: i32 = 141;

/// Every command that prints within seconds, with arguments that make it print.
const PRINTING: &[(&str, &[&str])] = &[
    ("codegen", &["--check"]),
    ("corpus", &["vehicles/example", "--frames", "2"]),
    ("dbc", &[]),
    ("decode", &[CITY]),
    ("doctor", &[]),
    ("encode", &["VCU1", "vehicle_speed=48.5"]),
    ("layers", &[]),
    ("reference", &["--check"]),
    ("replay", &[CITY]),
    ("rules", &["--check"]),
    ("scenario", &["--list"]),
    ("test", &["--package", "surroundings"]),
    ("vehicle", &["--list"]),
];

/// The others; they print by the same macro as those, which a lint of the crate sees to.
const LEFT_OUT: &[(&str, &str)] = &[
    ("build", "builds the firmware"),
    ("ci", "the steps of `test` and of all others"),
    ("codecs", "builds programs for the chip"),
    ("convert", "writes a file and prints one line: tools_recordings.rs"),
    ("coverage", "builds the tests anew"),
    ("cuts", "takes a minute"),
    ("figures", "builds the firmware and drives it for minutes"),
    ("flash", "prints by the board: tools_flash.rs"),
    ("fonts", "needs the system's fonts; what it prints is of another program"),
    ("help", "clap's own"),
    ("listen", "prints by what it hears: tools_listen.rs"),
    ("release", "builds everything"),
    ("run", "needs the firmware"),
    ("screens", "what it prints is of `cargo test`"),
    ("site", "builds the firmware and the browser's module"),
    ("size", "builds the firmware"),
    ("store", "needs the image of a flash: tools_store.rs"),
    ("tasks", "builds the firmware and drives it for a minute"),
];

fn command(name: &str, arguments: &[&str]) -> Command {
    let mut command = xtask();
    command.arg(name).args(arguments).stdin(Stdio::null()).stderr(Stdio::piped());
    command
}

fn ended(name: &str, mut command: Command) -> (Option<i32>, String) {
    let Output { status, stderr, .. } = command.spawn().unwrap().wait_with_output().unwrap();
    let said = String::from_utf8(stderr).unwrap();
    assert!(!said.contains("panicked"), "{name}: {said}");
    (status.code(), said)
}

#[test]
fn every_command_is_in_one_of_the_lists() {
    let help = String::from_utf8(xtask().arg("--help").output().unwrap().stdout).unwrap();
    let (_, commands) = help.split_once("Commands:\n").expect("clap lists the commands");
    let commands = commands.lines().take_while(|line| !line.is_empty());
    let commands: BTreeSet<&str> = commands.filter_map(|line| line.split_whitespace().next()).collect();
    let printing = PRINTING.iter().map(|(name, _)| *name);
    let listed: BTreeSet<&str> = printing.chain(LEFT_OUT.iter().map(|(name, _)| *name)).collect();
    assert_eq!(listed.len(), PRINTING.len() + LEFT_OUT.len(), "none is in both");
    assert_eq!(commands, listed, "a command needs a row here");
}

#[test]
fn a_reader_that_is_gone_ends_a_command_quietly() {
    for (name, arguments) in PRINTING {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut command = command(name, arguments);
        command.stdout(writer);
        let (code, said) = ended(name, command);
        assert_eq!(code, Some(NOBODY_READS), "{name}: {said}");
        assert!(!said.contains("error:"), "{name}: {said}");
    }
}

#[test]
fn a_reader_of_the_errors_that_is_gone_makes_no_difference() {
    for (name, arguments) in [("decode", &[CITY][..]), ("encode", &["NoMessage"])] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut command = command(name, arguments);
        let status = command.stdout(Stdio::null()).stderr(writer).status().unwrap();
        assert_eq!(status.code(), Some(i32::from(name == "encode")), "{name}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_that_says_so() {
    for (name, arguments) in PRINTING {
        let mut command = command(name, arguments);
        command.stdout(File::create("/dev/full").unwrap());
        let (code, said) = ended(name, command);
        assert_eq!(code, Some(1), "{name}: {said}");
        assert!(said.contains("cannot write to standard output"), "{name}: {said}");
    }
}
