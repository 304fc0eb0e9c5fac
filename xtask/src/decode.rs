//! Turns every frame of a recording into the signals of a vehicle.
//!
//! One row per signal: time, identifier, message, signal, raw value, exact value, unit, whether it is valid, and the
//! word of the value table. A file of any length is read in memory that does not grow; stdin is decoded line by line, so that `candump -ta can0 |
//! cargo xtask decode -` is live. What cannot be decoded is counted and summed up on stderr, never dropped silently.
//! Of a recording without times the time is missing: `-`, `null` or an empty cell.

use crate::known::{self, Source};
use crate::out::{self, note};
use crate::recording::{Choices, say_notes};
use crate::vehicles::{can_frame, can_id, seconds, short_seconds, with_unit};
use anyhow::{Context, Result, bail};
use bench::can::Frame;
use bench::time::Nanos;
use clap::{Args, ValueEnum};
use protocol_core::CanId;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, BufRead, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};
use vehicle_compiler::RunTime;
use vehicle_compiler::network::{Message, Signal};

/// What to decode and how to print it.
#[derive(Args, Debug)]
pub struct Options {
    /// Recording in any of the formats of docs/reference/recordings.md; `-` reads stdin line by line.
    #[arg(default_value = "-")]
    file: PathBuf,
    #[command(flatten)]
    choices: Choices,
    #[command(flatten)]
    source: Source,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Prints only these signals: names or MESSAGE.signal with commas between them, `*` and `?` stand for anything; may
    /// be repeated.
    #[arg(long, value_name = "GLOB,...", value_delimiter = ',')]
    signals: Vec<String>,
    /// Prints the recorder's own time instead of seconds since the first frame.
    #[arg(long)]
    absolute: bool,
}

/// Form of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Aligned columns for people.
    Text,
    /// One JSON object per line.
    Json,
    /// Comma-separated, with a header.
    Csv,
}

/// Decodes a recording to stdout.
///
/// # Errors
/// If the recording cannot be read, no vehicle fits it, or a pattern matches no signal.
pub fn run(options: &Options) -> Result<()> {
    if options.file == Path::new("-") { live(options) } else { whole(options) }
}

fn whole(options: &Options) -> Result<()> {
    let recording = options.choices.open_untimed(&options.file)?;
    let tables = options.source.of_frames(recording.ids())?;
    let mut tally = Tally::default();
    let mut out = BufWriter::new(out::stdout());
    let printer = Printer::new(tables, options)?;
    printer.head(&mut out)?;
    let mut entries = recording.entries()?;
    while let Some(entry) = entries.next().transpose()? {
        let clock = Clock { origin: entries.origin(), timed: entries.is_timed() };
        printer.frame(&mut out, clock, entry.at, &entry.frame, &mut tally)?;
    }
    out.flush()?;
    say_notes(&options.file, &entries.notes());
    (tally.bus_errors, tally.untimed) = (entries.error_frames(), !entries.is_timed());
    tally.report(tables);
    Ok(())
}

fn live(options: &Options) -> Result<()> {
    if io::stdin().is_terminal() {
        bail!("no recording: name a file, or pipe one in: `candump -ta can0 | cargo xtask decode -`");
    }
    let mut tally = Tally::default();
    let mut out = BufWriter::new(out::stdout());
    let wanted = options.source.wanted()?;
    let mut printer = wanted.map(|tables| Printer::new(tables, options)).transpose()?;
    if let Some(printer) = &printer {
        printer.head(&mut out)?;
    }
    let (mut recording, mut stdin, mut line) = (options.choices.live(), io::stdin().lock(), Vec::new());
    let known = if wanted.is_some() { Vec::new() } else { known::all() };
    loop {
        line.clear();
        if stdin.read_until(b'\n', &mut line).context("stdin cannot be read")? == 0 {
            break;
        }
        let Some(entry) = recording.read(&String::from_utf8_lossy(&line))? else { continue };
        let (at, frame) = (entry.at, entry.frame);
        if printer.is_none()
            && let Some(tables) =
                known.iter().find(|known| known.network.message_of(can_id(frame.id)).is_some())
        {
            let found = Printer::new(tables, options)?;
            note!("vehicle  {} (first heard: {})", tables.name, can_id(frame.id));
            found.head(&mut out)?;
            printer = Some(found);
        }
        let clock = Clock { origin: recording.origin(), timed: recording.is_timed() };
        match &printer {
            Some(printer) => printer.frame(&mut out, clock, at, &frame, &mut tally)?,
            None => tally.unknown(can_id(frame.id), at),
        }
        // Whoever watches a live bus must see each frame at once.
        out.flush()?;
    }
    recording.finish()?;
    say_notes(Path::new("stdin"), &recording.notes());
    (tally.bus_errors, tally.untimed) = (recording.error_frames(), !recording.is_timed());
    let Some(printer) = printer else { bail!(known::no_vehicle(&known, tally.unknown.keys().copied())) };
    tally.report(printer.tables);
    Ok(())
}

/// The recorder's clock.
#[derive(Clone, Copy)]
struct Clock {
    /// Time of the first frame, in nanoseconds since the recorder's epoch.
    origin: i64,
    /// There is one.
    timed: bool,
}

/// What became of the frames.
#[derive(Default)]
struct Tally {
    decoded: usize,
    heard: BTreeSet<CanId>,
    unknown: BTreeMap<CanId, usize>,
    short: BTreeMap<CanId, usize>,
    remote: usize,
    bus_errors: usize,
    last: Nanos,
    untimed: bool,
}

impl Tally {
    fn unknown(&mut self, id: CanId, at: Nanos) {
        self.last = at;
        *self.unknown.entry(id).or_default() += 1;
    }

    /// Sums up on stderr; what did not happen is not mentioned.
    fn report(&self, tables: &RunTime) {
        let (unknown, short) = (self.unknown.values().sum::<usize>(), self.short.values().sum::<usize>());
        let frames = self.decoded + unknown + short + self.remote;
        note!(
            "vehicle  {}: {} of its {} messages heard",
            tables.name,
            self.heard.len(),
            tables.network.messages.len()
        );
        let span = short_seconds(self.last.0 / 1_000_000);
        let span = if self.untimed { "without times".into() } else { format!("in {span} s") };
        note!("frames   {frames} {span}, {} decoded", self.decoded);
        if unknown > 0 {
            note!("unknown  {unknown}: {}", listed(&self.unknown, ToString::to_string));
        }
        let others = if self.unknown.is_empty() { Vec::new() } else { known::all() };
        for other in others.iter().filter(|other| other.name != tables.name) {
            let theirs = self.unknown.keys().filter(|id| other.network.message_of(**id).is_some()).count();
            if theirs > 0 {
                note!("         {theirs} of these identifiers are those of `{}`", other.name);
            }
        }
        if short > 0 {
            let message = |id: &CanId| Some(&tables.network.messages[tables.network.message_of(*id)?]);
            let name = |id: &CanId| message(id).map_or("", |message| message.name.as_str());
            note!("short    {short}: {}", listed(&self.short, |id| format!("{} ({id})", name(id))));
        }
        if self.remote > 0 {
            note!("remote   {} requests, which carry no signals", self.remote);
        }
        if self.bus_errors > 0 {
            note!("errors   {} error frames recorded", self.bus_errors);
        }
    }
}

/// Returns the most frequent identifiers with their counts.
fn listed(counts: &BTreeMap<CanId, usize>, name: impl Fn(&CanId) -> String) -> String {
    const MOST: usize = 6;
    let mut sorted: Vec<_> = counts.iter().collect();
    sorted.sort_by_key(|(id, count)| (std::cmp::Reverse(**count), **id));
    let shown: Vec<String> =
        sorted.iter().take(MOST).map(|(id, count)| format!("{} x {count}", name(id))).collect();
    let more = counts.len().saturating_sub(MOST);
    let more = if more > 0 { format!(" and {more} more identifiers") } else { String::new() };
    shown.join(", ") + &more
}

/// One signal of one frame.
struct Row<'a> {
    time: String,
    id: CanId,
    message: &'a Message,
    signal: &'a Signal,
    raw: i128,
    /// Exact decimal; `None` = not valid.
    value: Option<String>,
}

/// Prints rows in one form, with columns as wide as the vehicle's names.
struct Printer {
    tables: &'static RunTime,
    format: Format,
    absolute: bool,
    /// Of each message the indices of the signals to print.
    wanted: Vec<Vec<usize>>,
    widths: (usize, usize),
}

impl Printer {
    fn new(tables: &'static RunTime, options: &Options) -> Result<Self> {
        let messages = &tables.network.messages;
        let full = |message: &Message, signal: &Signal| format!("{}.{}", message.name, signal.name);
        let fits = |pattern: &String, message: &Message, signal: &Signal| {
            matches_glob(pattern, &signal.name) || matches_glob(pattern, &full(message, signal))
        };
        let all = || messages.iter().flat_map(|message| message.signals.iter().map(move |s| (message, s)));
        for pattern in &options.signals {
            if !all().any(|(message, signal)| fits(pattern, message, signal)) {
                let names: Vec<String> = all().flat_map(|(m, s)| [s.name.clone(), full(m, s)]).collect();
                let near = vehicle_compiler::did_you_mean(pattern, names.iter().map(String::as_str));
                bail!("no signal of `{}` matches `{pattern}`{near}", tables.name);
            }
        }
        let is_wanted = |message: &Message, signal: &Signal| {
            options.signals.is_empty() || options.signals.iter().any(|pattern| fits(pattern, message, signal))
        };
        let row = |message: &Message| -> Vec<usize> {
            (0..message.signals.len()).filter(|&index| is_wanted(message, &message.signals[index])).collect()
        };
        let wanted: Vec<Vec<usize>> = messages.iter().map(row).collect();
        let printed = || messages.iter().zip(&wanted).filter(|(_, indices)| !indices.is_empty());
        let message_width = printed().map(|(message, _)| message.name.len()).max().unwrap_or(0);
        let names = printed()
            .flat_map(|(message, indices)| indices.iter().map(|&index| &message.signals[index].name));
        let signal_width = names.map(String::len).max().unwrap_or(0);
        Ok(Self {
            tables,
            format: options.format,
            absolute: options.absolute,
            widths: (message_width.max("message".len()), signal_width.max("signal".len())),
            wanted,
        })
    }

    /// Prints what stands above the rows.
    fn head(&self, out: &mut impl Write) -> io::Result<()> {
        let (message, signal) = self.widths;
        match self.format {
            Format::Text => writeln!(
                out,
                "{:>w$}  {:8}  {:message$}  {:signal$}  {:>10}  value",
                "time",
                "id",
                "message",
                "signal",
                "raw",
                w = self.time_width()
            ),
            Format::Json => Ok(()),
            Format::Csv => writeln!(out, "time,id,message,signal,raw,value,unit,valid,word"),
        }
    }

    /// Returns a time as this form writes it, one that is missing too.
    fn time(&self, clock: Clock, at: Nanos) -> String {
        match (clock.timed, self.format) {
            (true, _) if self.absolute => {
                let nanos = i128::from(clock.origin) + i128::from(at.0);
                let sign = if nanos < 0 { "-" } else { "" };
                let micros = nanos.unsigned_abs() / 1_000;
                format!("{sign}{}.{:06}", micros / 1_000_000, micros % 1_000_000)
            }
            (true, _) => seconds(at),
            (false, Format::Text) => "-".into(),
            (false, Format::Json) => "null".into(),
            (false, Format::Csv) => String::new(),
        }
    }

    fn time_width(&self) -> usize {
        if self.absolute { 17 } else { 12 }
    }

    fn frame(
        &self,
        out: &mut impl Write,
        clock: Clock,
        at: Nanos,
        frame: &Frame,
        tally: &mut Tally,
    ) -> io::Result<()> {
        tally.last = at;
        let Some(frame) = can_frame(frame) else {
            tally.remote += 1;
            return Ok(());
        };
        let Some(index) = self.tables.network.message_of(frame.id) else {
            tally.unknown(frame.id, at);
            return Ok(());
        };
        let (message, signals) = (&self.tables.network.messages[index], &self.wanted[index]);
        if frame.len() < message.len {
            *tally.short.entry(frame.id).or_default() += 1;
            return Ok(());
        }
        tally.decoded += 1;
        tally.heard.insert(frame.id);
        let data = frame.padded();
        let time = self.time(clock, at);
        for &index in signals {
            let signal = &message.signals[index];
            if !message.carries(index, data) {
                continue;
            }
            let raw = signal.raw(data);
            let value = signal.is_valid(raw).then(|| signal.value(raw));
            self.row(out, &Row { time: time.clone(), id: frame.id, message, signal, raw, value })?;
        }
        Ok(())
    }

    fn row(&self, out: &mut impl Write, row: &Row<'_>) -> io::Result<()> {
        let Row { time, id, message, signal, raw, value } = row;
        let word = signal.word(*raw);
        match self.format {
            Format::Text => {
                let shown = match (value, word) {
                    (Some(_), Some(word)) => word.to_owned(),
                    (Some(value), None) => with_unit(value, &signal.unit),
                    (None, Some(word)) => format!("-- (invalid: {word})"),
                    (None, None) => {
                        format!("-- (invalid: {})", with_unit(&signal.value(*raw), &signal.unit))
                    }
                };
                let id = id.to_string();
                let (time_width, (wide, wider)) = (self.time_width(), self.widths);
                let (message, signal) = (&message.name, &signal.name);
                writeln!(
                    out,
                    "{time:>time_width$}  {id:8}  {message:wide$}  {signal:wider$}  {raw:>10}  {shown}"
                )
            }
            Format::Json => {
                let quoted = |text: &str| serde_json::Value::from(text).to_string();
                writeln!(
                    out,
                    "{{\"time\":{time},\"id\":\"{}\",\"message\":{},\"signal\":{},\"raw\":{raw},\"value\":{},\
                     \"unit\":{},\"valid\":{},\"word\":{}}}",
                    id,
                    quoted(&message.name),
                    quoted(&signal.name),
                    value.as_deref().unwrap_or("null"),
                    quoted(&signal.unit),
                    value.is_some(),
                    word.map_or("null".into(), quoted)
                )
            }
            Format::Csv => writeln!(
                out,
                "{time},{},{},{},{raw},{},{},{},{}",
                id,
                message.name,
                signal.name,
                value.as_deref().unwrap_or(""),
                cell(&signal.unit),
                value.is_some(),
                cell(word.unwrap_or(""))
            ),
        }
    }
}

/// Returns a CSV cell, in quotes where RFC 4180 asks for them.
fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// Returns whether `text` is what `pattern` says: `*` any characters, `?` any one; case is ignored.
fn matches_glob(pattern: &str, text: &str) -> bool {
    let (pattern, text) = (pattern.to_ascii_lowercase(), text.to_ascii_lowercase());
    let (pattern, text) = (pattern.as_bytes(), text.as_bytes());
    // reached[i]: the pattern so far can match the first i characters.
    let mut reached = vec![false; text.len() + 1];
    reached[0] = true;
    for &sign in pattern {
        let mut next = vec![false; text.len() + 1];
        for at in 0..=text.len() {
            next[at] = match sign {
                b'*' => reached[at] || at > 0 && next[at - 1],
                b'?' => at > 0 && reached[at - 1],
                sign => at > 0 && reached[at - 1] && text[at - 1] == sign,
            };
        }
        reached = next;
    }
    reached[text.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn globs_match_like_a_shell() {
        let cases = [
            ("soc", "soc", true),
            ("soc", "soc2", false),
            ("*soc*", "pack_soc_2", true),
            ("BMS1.*", "BMS1.soc", true),
            ("bms1.S?C", "BMS1.soc", true),
            ("BMS1.*", "BMS10.soc", false),
            ("*a*a*b", "aaaa", false),
            ("", "", true),
            ("*", "", true),
        ];
        for (pattern, text, fits) in cases {
            assert_eq!(matches_glob(pattern, text), fits, "{pattern} {text}");
        }
    }

    #[test]
    fn cells_with_commas_and_quotes_are_quoted() {
        assert_eq!(cell("on, \"really\""), "\"on, \"\"really\"\"\"");
        assert_eq!(cell("°C"), "°C");
    }
}
