//! Measures the tools on real files: which are read, which make a vehicle, and whether every value is cantools'.
//!
//! Owns the table that it prints. Every file of a folder and of the folders in it is tried; nothing is written. A value
//! that differs is an error with its file, message and bytes; a file that is refused is listed with file and line.

mod logs;

use crate::out::{note, say};
use crate::python;
use anyhow::{Context, Result, bail};
use clap::Args;
use protocol_core::CanId;
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use vehicle_compiler::network::{Message, Signal};
use vehicle_compiler::{Grade, Number, RunTime, proposal};

/// Which files to measure.
#[derive(Args, Debug)]
pub struct Options {
    /// Folder with DBC files, at any depth.
    folder: PathBuf,
    /// Frames of each message that are compared with cantools; more where a multiplexer has more pages.
    #[arg(long, default_value_t = 20)]
    frames: u32,
    /// Names every file with what became of it.
    #[arg(long)]
    files: bool,
    /// Reads the folder's recordings in place of its DBC files, beside python-can.
    #[arg(long)]
    logs: bool,
}

/// What became of all files.
#[derive(Default)]
struct Tally {
    files: usize,
    read: usize,
    messages: usize,
    signals: usize,
    /// Files with a warning: something in them cannot be had.
    partly: usize,
    vehicles: usize,
    bound: usize,
    witnessed: usize,
    compared: usize,
    wrong: Vec<String>,
    /// File and line of each refusal.
    refused: Vec<String>,
    /// Files and places by the form of a warning.
    warnings: BTreeMap<String, (usize, usize)>,
    /// What cantools says of files that it refuses.
    only_here: Vec<String>,
}

/// Prints the table.
///
/// # Errors
/// If the folder holds no such file, or a value or a frame differs from the witness's.
pub fn run(options: &Options) -> Result<()> {
    if options.logs {
        return logs::run(&options.folder);
    }
    let mut files = Vec::new();
    collect(&options.folder, &mut files)?;
    files.sort();
    if files.is_empty() {
        bail!("{} holds no .dbc file", options.folder.display());
    }
    let mut tally = Tally { files: files.len(), ..Tally::default() };
    let mut read = BTreeMap::new();
    for file in &files {
        match RunTime::of_dbc(file) {
            Ok(known) => {
                tally.count(&known);
                let made = make(file, &mut tally);
                if options.files {
                    say!("{}: {made}", file.display())?;
                }
                read.insert(file.display().to_string(), known);
            }
            Err(wrong) => {
                let first = wrong.0.first().map(ToString::to_string).unwrap_or_default();
                if options.files {
                    say!("{first}")?;
                }
                tally.refused.push(first);
            }
        }
    }
    compare(&files, &read, options.frames, &mut tally)?;
    tally.print()
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    let entries =
        std::fs::read_dir(folder).with_context(|| format!("{} cannot be read", folder.display()))?;
    for path in entries.flatten().map(|entry| entry.path()) {
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("dbc")) {
            files.push(path);
        }
    }
    Ok(())
}

/// Makes a vehicle of the commonest values that are found in a file, and returns what became of it.
fn make(file: &Path, tally: &mut Tally) -> String {
    let made = proposal::of_file(file, "corpus").and_then(|proposed| {
        let (dbc, toml) = (("corpus.dbc", proposed.dbc.as_str()), ("vehicle.toml", proposed.toml.as_str()));
        vehicle_compiler::compile("corpus", dbc, toml).map(|_| proposed.bound.len())
    });
    match made {
        Ok(0) => "read; none of the commonest values is found".into(),
        Ok(bound) => {
            tally.vehicles += 1;
            tally.bound += bound;
            format!("a vehicle with {bound} values")
        }
        Err(wrong) => {
            let first = wrong.0.first().map(ToString::to_string).unwrap_or_default();
            tally.wrong.push(format!("{}: no vehicle: {first}", file.display()));
            format!("no vehicle: {first}")
        }
    }
}

/// Compares values with those of cantools.
fn compare(
    files: &[PathBuf],
    read: &BTreeMap<String, RunTime>,
    frames: u32,
    tally: &mut Tally,
) -> Result<()> {
    let python = match python::witness() {
        Ok(python) => python,
        Err(problem) => {
            note!("nothing is compared: {problem}");
            return Ok(());
        }
    };
    // The names of signals are ASCII; how comments read does not matter here.
    let mut witness = Command::new(python)
        .arg(crate::workspace::root().join("tools/witness/corpus.py"))
        .args(["latin-1", &frames.to_string()])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .context("the witness cannot be started")?;
    let list: String = files.iter().map(|file| format!("{}\n", file.display())).collect();
    witness.stdin.take().context("no standard input")?.write_all(list.as_bytes())?;
    let mut known = None;
    for line in BufReader::new(witness.stdout.take().context("no standard output")?).lines() {
        let row: Json = serde_json::from_str(&line?).context("the witness does not speak JSON")?;
        if let Some(file) = row["file"].as_str() {
            known = read.get(file);
            match (known, row["error"].as_str()) {
                (Some(_), Some(error)) => tally.only_here.push(format!("{file}: cantools: {error}")),
                (Some(_), None) => tally.witnessed += 1,
                _ => {}
            }
        } else if let Some(known) = known {
            compare_frame(known, &row, tally);
        }
    }
    if !witness.wait()?.success() {
        bail!("the witness failed");
    }
    Ok(())
}

fn compare_frame(known: &RunTime, row: &Json, tally: &mut Tally) {
    let id = row["id"].as_u64().unwrap_or_default() as u32;
    let id = if row["extended"] == true { CanId::extended(id) } else { CanId::standard(id as u16) };
    let Some(index) = known.network.message_of(id) else { return };
    let message = &known.network.messages[index];
    let text = row["data"].as_str().unwrap_or_default();
    let mut data = [0; 8];
    for (byte, at) in data.iter_mut().zip((0..text.len()).step_by(2)) {
        *byte = u8::from_str_radix(&text[at..at + 2], 16).unwrap_or_default();
    }
    let Some(theirs) = row["signals"].as_object() else { return };
    for (at, signal) in message.signals.iter().enumerate() {
        if message.carries(at, &data) && !theirs.contains_key(&signal.name) {
            let place = format!("{}: {} {text}", known.name, message.name);
            tally.wrong.push(format!("{place}: `{}` is not in the frame by cantools", signal.name));
        }
    }
    for (name, pair) in theirs {
        let Some(at) = message.signal(name) else { continue };
        let signal = &message.signals[at];
        tally.compared += 1;
        if !message.carries(at, &data) || !is_same(signal, signal.raw(&data), &pair[0], &pair[1]) {
            let ours = shown(message, at, &data);
            let place = format!("{}: {} {text}", known.name, message.name);
            tally.wrong.push(format!("{place}: `{name}` is {ours}, cantools: {} ({})", pair[1], pair[0]));
        }
    }
}

fn shown(message: &Message, at: usize, data: &[u8; 8]) -> String {
    let signal = &message.signals[at];
    match message.carries(at, data) {
        true => format!("{} ({})", signal.value(signal.raw(data)), signal.raw(data)),
        false => "not in the frame".into(),
    }
}

/// Returns whether a value is cantools': raw values exactly, physical ones but for the last digits of its floats.
fn is_same(signal: &Signal, raw: i128, their_raw: &Json, theirs: &Json) -> bool {
    let ours: f64 = signal.value(raw).parse().unwrap_or(f64::NAN);
    if let Some(text) = theirs.as_str() {
        return ours.to_string().to_lowercase() == text.replace("infinity", "inf");
    }
    let their_number: f64 = theirs.to_string().parse().unwrap_or(f64::NAN);
    let near = (ours - their_number).abs() <= 1e-9 * ours.abs().max(their_number.abs()).max(1e-30);
    match signal.number {
        // Of a float cantools gives the value for the raw value.
        Number::Float32 | Number::Float64 => near,
        _ => near && their_raw.to_string().parse() == Ok(raw),
    }
}

impl Tally {
    fn count(&mut self, known: &RunTime) {
        self.read += 1;
        self.messages += known.network.messages.len();
        self.signals += known.network.messages.iter().map(|message| message.signals.len()).sum::<usize>();
        let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
        for found in known.findings.0.iter().filter(|found| found.grade == Grade::Warning) {
            *kinds.entry(found.form()).or_default() += 1;
        }
        self.partly += usize::from(!kinds.is_empty());
        for (kind, places) in kinds {
            let row = self.warnings.entry(kind).or_default();
            *row = (row.0 + 1, row.1 + places);
        }
    }

    fn print(&self) -> Result<()> {
        let unwitnessed = self.read - self.witnessed;
        let wrong = self.wrong.len();
        say!("{:>9}  DBC files", self.files)?;
        say!("{:>9}  read: {} messages, {} signals", self.read, self.messages, self.signals)?;
        say!("{:>9}  of them partly: something in them cannot be had", self.partly)?;
        say!("{:>9}  vehicles made, with {} values bound", self.vehicles, self.bound)?;
        say!("{:>9}  read by cantools too (leniently), {unwitnessed} only here", self.witnessed)?;
        say!("{:>9}  values compared with cantools, {wrong} differ", self.compared)?;
        say!("{:>9}  refused", self.refused.len())?;
        self.refused.iter().try_for_each(|line| say!("           {line}"))?;
        if !self.warnings.is_empty() {
            say!("\nwhat cannot be had, and is no error while nothing binds it (files, places):")?;
        }
        for (kind, (files, places)) in &self.warnings {
            say!("{files:>9} {places:>6}  {kind}")?;
        }
        if !self.only_here.is_empty() {
            say!("\nread here, refused by cantools:")?;
        }
        self.only_here.iter().try_for_each(|line| say!("           {line}"))?;
        self.wrong.iter().take(20).try_for_each(|line| say!("wrong: {line}"))?;
        if wrong > 0 {
            bail!("{wrong} values or vehicles are wrong");
        }
        Ok(())
    }
}
