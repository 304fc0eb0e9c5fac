//! Recordings as people have them: what is read of each, and whether a second reader reads the same.
//!
//! The second reader is python-can where it knows the format, else one regular expression per format in
//! tools/witness/read_log.py. Frames must be equal in time (to the microsecond), identifier, its bits, kind, length and
//! data; channels may have other names, but the same frames must be on the same ones.

use crate::out::{note, say};
use crate::python;
use crate::workspace;
use anyhow::{Context, Result, bail};
use bench::log::{Channel, Entries, Entry, Reading, Recording};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The second reader.
const WITNESS: &str = "tools/witness/read_log.py";

/// What was read of one file.
#[derive(Debug)]
pub struct Read {
    /// Name of the format.
    pub format: &'static str,
    /// Classic frames.
    pub frames: usize,
    /// Lines that are no frames.
    pub foreign: usize,
    /// Frames of CAN FD.
    pub fd: usize,
    /// Bus errors.
    pub errors: usize,
    /// What the witness says: who it is, or the first difference.
    pub witness: Result<String, String>,
}

/// Prints the table of all recordings in a folder.
///
/// # Errors
/// If the folder cannot be read or has none, or a frame differs from what the witness read.
pub fn run(folder: &Path) -> Result<()> {
    let files = files(folder)?;
    if files.is_empty() {
        bail!("{}: no file in it", folder.display());
    }
    let python = python::witness()?;
    say!(
        "{:<52} {:<22} {:>8} {:>7} {:>4} {:>6}  witness",
        "file",
        "format",
        "frames",
        "foreign",
        "FD",
        "errors"
    )?;
    let (mut read, mut differ) = (0, 0);
    for file in &files {
        let name = file.strip_prefix(folder).unwrap_or(file).display().to_string();
        let name: String = name.chars().take(52).collect();
        match read_twice(file, &python) {
            Ok(Read { format, frames, foreign, fd, errors, witness }) => {
                read += 1;
                differ += usize::from(witness.is_err());
                let verdict = witness.unwrap_or_else(|difference| format!("DIFFERS: {difference}"));
                say!("{name:<52} {format:<22} {frames:>8} {foreign:>7} {fd:>4} {errors:>6}  {verdict}")?;
            }
            Err(refusal) => say!("{name:<52} refused: {refusal}")?,
        }
    }
    say!("{read} of {} recordings are read, {differ} of them unlike the second reader", files.len())?;
    if differ > 0 {
        bail!("{differ} recordings are not read as the second reader reads them");
    }
    Ok(())
}

/// Returns every file of a folder that may be a recording, sorted.
fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let entries = std::fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    for entry in entries {
        let path = entry?.path();
        let is_other =
            path.extension().is_some_and(|end| ["dbc", "toml", "md"].iter().any(|other| end == *other));
        if path.is_dir() {
            files.extend(self::files(&path)?);
        } else if !is_other {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// Reads one file twice.
///
/// # Errors
/// If it is refused: line and reason.
pub fn read_twice(file: &Path, python: &Path) -> Result<Read, String> {
    let reading = Reading { channel: Some(Channel::All), untimed: true, ..Reading::default() };
    let read = reading.open(file).and_then(|recording| {
        let mut entries = recording.entries()?;
        let mut frames = 0;
        for entry in entries.by_ref() {
            entry?;
            frames += 1;
        }
        Ok(Read {
            format: recording.format(),
            frames,
            foreign: entries.foreign_lines(),
            fd: entries.fd_frames(),
            errors: entries.error_frames(),
            witness: compared(&recording, file, python),
        })
    });
    let text = |error: bench::log::LogError| {
        let place = if error.line > 0 { format!("line {}: ", error.line) } else { String::new() };
        place + &error.problem
    };
    read.map_err(text)
}

/// Compares with the second reader; returns who it is, or the first difference.
fn compared(recording: &Recording, file: &Path, python: &Path) -> Result<String, String> {
    let mut command = Command::new(python);
    command.arg(workspace::root().join(WITNESS)).arg(file).arg(recording.format());
    let mut child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| format!("{WITNESS}: {error}"))?;
    let lines = BufReader::new(child.stdout.take().ok_or("no output")?).lines();
    let mut entries = recording.entries().map_err(|error| error.to_string())?;
    let result = same(&mut entries, lines.map_while(Result::ok));
    if result.is_err() {
        let _ = child.kill();
    }
    let ended = child.wait_with_output().map_err(|error| error.to_string())?;
    let said = String::from_utf8_lossy(&ended.stderr);
    let last = said.lines().last().unwrap_or_default().to_owned();
    match result {
        Ok(_) if !ended.status.success() && last == "no second reader" => Ok("none".into()),
        Ok(_) | Err(_) if !ended.status.success() && !last.is_empty() => {
            note!("{}: the second reader: {last}", file.display());
            Ok(format!("none: {last}"))
        }
        result => result,
    }
}

/// Compares frame by frame; `lines` begin with the name of the second reader.
fn same(entries: &mut Entries, mut lines: impl Iterator<Item = String>) -> Result<String, String> {
    let Some(name) = lines.next() else { return Ok(String::new()) };
    let (mut frames, mut latest) = (0, 0);
    // Each channel here with the one there.
    let (mut channels, mut taken) = (BTreeMap::new(), BTreeMap::new());
    loop {
        let (here, there) = (entries.next(), lines.next());
        let (entry, line) = match (here, there) {
            (None, None) => return Ok(format!("{name}: {frames} equal")),
            (Some(Err(error)), _) => return Err(error.to_string()),
            (Some(Ok(entry)), None) => {
                return Err(format!("line {}: {} is not there", entry.line, entry.frame));
            }
            (None, Some(line)) => return Err(format!("`{line}` is not here")),
            (Some(Ok(entry)), Some(line)) => (entry, line),
        };
        frames += 1;
        let words: Vec<&str> = line.split(' ').collect();
        let [micros, id, bits, kind, channel, length, data] = words[..] else {
            return Err(format!("`{line}` is not a frame"));
        };
        // A frame that is dated before the one above takes its time.
        let micros: Option<i64> = micros.parse().ok();
        latest = micros.map_or(latest, |micros| micros.max(latest));
        if micros.is_some() && latest.abs_diff(entry.at.0 as i64 / 1_000) > 1 {
            return Err(format!("line {}: {} us, there {latest} us", entry.line, entry.at.as_micros()));
        }
        let (ours, theirs) = (told(&entry), format!("{id} {bits} {kind} {length} {data}"));
        if ours != theirs {
            return Err(format!("line {}: {ours}, there {theirs}", entry.line));
        }
        let there = channels.entry(entry.channel).or_insert_with(|| channel.to_owned());
        let here = taken.entry(channel.to_owned()).or_insert(entry.channel);
        if (there.as_str(), *here) != (channel, entry.channel) {
            return Err(format!("line {}: channel {}, there {channel}", entry.line, entry.channel));
        }
    }
}

/// Returns a frame as the second reader prints it.
fn told(entry: &Entry) -> String {
    let frame = &entry.frame;
    let bits = if frame.id.is_extended() { 'x' } else { 's' };
    let kind = if frame.remote { 'r' } else { 'd' };
    let data: String = frame.payload().iter().map(|byte| format!("{byte:02x}")).collect();
    let data = if data.is_empty() { "-".to_owned() } else { data };
    format!("{:X} {bits} {kind} {} {data}", frame.id.raw(), frame.dlc)
}
