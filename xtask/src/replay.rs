//! Plays a recording through the instrument's own logic and prints what it shows.
//!
//! The same code as on the chip, ticked every 10 ms of the recording's time; without the cluster's own wires (key,
//! doors, lamps), which no recording has. Printed is what changes: values that the bus brings, in everyday units, the
//! worst severity, the lamps, the message line and the sound, the page, the countdown to high voltage off, limp mode, the
//! range, and every fault that is noted. Pixels are the bench's business: `cargo xtask run`.

use crate::known::Source;
use crate::out;
use crate::recording::{Choices, say_notes};
use crate::vehicles::{can_frame, short_seconds};
use crate::words;
use anyhow::{Result, anyhow, bail};
use bench::log::Entries;
use bench::time::Nanos;
use clap::Args;
use cluster::view::{Limp, Line, Range};
use cluster::{Chime, Cluster, Entry, Inputs, Instrument, Received, Sound, Telltale, Telltales, View};
use protocol_core::model::{Missing, Severity, Shown, Value};
use protocol_core::{Millis, Vehicle};
use serde_json::{Value as Json, json};
use std::io::{self, BufWriter, Write};
use std::path::PathBuf;
use vehicle_compiler::RunTime;

/// Time from tick to tick on the chip, in milliseconds.
const TICK_MS: u64 = 10;
/// Longest silence that a recording may have: a jump of the recorder's clock would play for years.
const LONGEST_GAP: Nanos = Nanos::from_secs(24 * 60 * 60);

/// What to play and how to print it.
#[derive(Args, Debug)]
pub struct Options {
    /// Recording in any of the formats of docs/reference/recordings.md.
    file: PathBuf,
    #[command(flatten)]
    choices: Choices,
    /// Seconds of silence to play after the last frame: values go stale, nodes are missed.
    #[arg(long, value_name = "SECONDS", default_value_t = 0, value_parser = clap::value_parser!(u32).range(..=86_400))]
    tail: u32,
    #[command(flatten)]
    source: Source,
    /// Prints one JSON object per line.
    #[arg(long)]
    json: bool,
}

/// Plays a recording and prints what changes.
///
/// # Errors
/// If the recording cannot be read or no vehicle fits it.
pub fn run(options: &Options) -> Result<()> {
    let recording = options.choices.open(&options.file)?;
    let known = options.source.of_frames(recording.ids())?;
    let mut entries = recording.entries()?;
    let result = play(&mut entries, known, options, &mut BufWriter::new(out::stdout()));
    say_notes(&options.file, &entries.notes());
    result
}

fn play(
    entries: &mut Entries,
    known: &'static RunTime,
    options: &Options,
    out: &mut impl Write,
) -> Result<()> {
    let vehicle = known.vehicle().map_err(|problem| anyhow!(problem))?;
    let mut instrument = Instrument::fixed(vehicle, cluster::Options::default());
    let mut screen = Screen::new(vehicle, options.json);
    let mut tally = Tally::default();
    let mut next_tick = Millis(0);
    while let Some(entry) = entries.next().transpose()? {
        if entry.at.since(tally.last) > LONGEST_GAP {
            let (file, line) = (options.file.display(), entry.line);
            bail!("{file}:{line}: the time jumps by more than a day; cut the log there");
        }
        while next_tick.0 * 1_000_000 <= entry.at.0 {
            tick(&mut instrument, &mut screen, next_tick, out)?;
            next_tick = next_tick.after(TICK_MS);
        }
        tally.count(&mut instrument, known, &entry);
    }
    let end = tally.last.0 / 1_000_000 + u64::from(options.tail) * 1_000;
    tick(&mut instrument, &mut screen, next_tick, out)?;
    while next_tick.0 + TICK_MS <= end {
        next_tick = next_tick.after(TICK_MS);
        tick(&mut instrument, &mut screen, next_tick, out)?;
    }
    tally.report(entries.error_frames(), vehicle, options.json, out)?;
    out.flush()?;
    Ok(())
}

fn tick(
    instrument: &mut Instrument,
    screen: &mut Screen,
    now: Millis,
    out: &mut impl Write,
) -> io::Result<()> {
    instrument.tick(&Inputs::default(), now);
    // What it sends goes nowhere: the recording has its own.
    while instrument.offer(|_| true) {}
    screen.print_changes(instrument.cluster(), now, out)
}

/// What was printed last, to print only what is new.
struct Screen {
    json: bool,
    values: Vec<(Value, Shown<i32>, String)>,
    severity: Severity,
    lamps: Option<Telltales>,
    line: Option<Line>,
    sound: Option<Sound>,
    page: u8,
    hv_off_s: Option<u8>,
    limp: Option<Limp>,
    range: Shown<Range>,
    history: Vec<Entry>,
}

impl Screen {
    fn new(vehicle: &'static Vehicle, json: bool) -> Self {
        let values = from_the_bus(vehicle).map(|value| (value, Shown::Never, String::new()));
        Self {
            json,
            values: values.collect(),
            severity: Severity::None,
            lamps: None,
            line: None,
            sound: None,
            page: 0,
            hv_off_s: None,
            limp: None,
            range: Shown::Never,
            history: Vec::new(),
        }
    }

    fn print_changes(&mut self, cluster: &Cluster, now: Millis, out: &mut impl Write) -> io::Result<()> {
        let json = self.json;
        let mut print = |name: &str, text: &str, mut fields: Json| {
            let time = short_seconds(now.0);
            if !json {
                return writeln!(out, "{time:>10}  {name:<26}  {text}");
            }
            let rest = fields.as_object_mut().map(std::mem::take).unwrap_or_default();
            let rest = Json::from(rest).to_string();
            writeln!(out, "{{\"time\":{time},\"name\":\"{name}\",{}", rest.trim_start_matches('{'))
        };
        for (value, last, last_text) in &mut self.values {
            let shown = cluster.shown(*value, now);
            if shown == *last {
                continue;
            }
            *last = shown;
            let text = text_of(*value, shown);
            // The everyday unit is coarser than the model's: half a count is no news.
            if text == *last_text {
                continue;
            }
            let state = state_of(shown);
            print(value.path(), &text, json!({ "state": state, "counts": shown.value(), "shown": text }))?;
            *last_text = text;
        }
        let view = cluster.view(now);
        if self.severity != view.severity {
            self.severity = view.severity;
            let severity = view.severity.word();
            print("severity", severity, json!({ "severity": severity }))?;
        }
        if self.lamps != Some(view.telltales) {
            self.lamps = Some(view.telltales);
            let lit = lit(view.telltales);
            let all = view.telltales == Telltales::ALL;
            let text = match &lit[..] {
                _ if all => format!("all {} (bulb check)", lit.len()),
                [] => "none".into(),
                lit => lit.join(", "),
            };
            print("lamps", &text, json!({ "lit": lit, "all": all }))?;
        }
        if self.line != view.line {
            self.line = view.line;
            let (text, fields) = line(view.line);
            print("line", &text, fields)?;
        }
        let chime = cluster.chime(now);
        if self.sound != chime.map(|chime| chime.sound) {
            self.sound = chime.map(|chime| chime.sound);
            let (text, fields) = sound(chime);
            print("sound", &text, fields)?;
        }
        let View { page, hv_off_s, limp, range, .. } = view;
        if self.page != page.number() {
            self.page = page.number();
            let name = words::page(self.page);
            print("page", &name, json!({ "page": self.page, "shown": name }))?;
        }
        if self.hv_off_s != hv_off_s {
            self.hv_off_s = hv_off_s;
            let text = hv_off_s.map_or("over".into(), |seconds| format!("{seconds} s"));
            print("hv_off", &text, json!({ "seconds": hv_off_s }))?;
        }
        if self.limp != limp {
            self.limp = limp;
            let limit = limp.and_then(|limp| limp.limit_deciamps);
            let text = match (limp, limit) {
                (None, _) => "over".into(),
                (Some(_), None) => "limit not known".into(),
                (Some(_), Some(limit)) => format!("at most {}.{} A", limit / 10, limit % 10),
            };
            print("limp", &text, json!({ "limps": limp.is_some(), "limit_deciamps": limit }))?;
        }
        if self.range != range {
            self.range = range;
            let estimated = range.value().is_some_and(|range| range.is_estimated);
            let mark = if estimated { "~" } else { "" };
            let km = range.map(|range| i32::from(range.km));
            let text = match km {
                Shown::Value(km) => format!("{mark}{km} km"),
                missing => format!("-- ({})", state_of(missing)),
            };
            print(
                "range",
                &text,
                json!({ "state": state_of(km), "km": km.value(), "estimated": estimated }),
            )?;
        }
        // Most ticks note nothing: compare before anything is copied.
        if !cluster.history().eq(&self.history) {
            let history: Vec<Entry> = cluster.history().copied().collect();
            for entry in history.iter().filter(|entry| !self.history.contains(entry)) {
                let (said, code) = cluster.remembered(entry);
                let (fault, severity) = (entry.fault.key(), entry.severity.word());
                let number = code.map(|code| format!(" {code}")).unwrap_or_default();
                let times = if entry.count > 1 { format!(" ({} times)", entry.count) } else { String::new() };
                let text = format!("{severity}{number}: {} {} from {fault}{times}", said.en, said.zh);
                let fields = json!({
                    "fault": fault, "code": entry.code, "severity": severity, "zh": said.zh, "en": said.en,
                    "count": entry.count,
                });
                print("noted", &text, fields)?;
            }
            self.history = history;
        }
        Ok(())
    }
}

/// Returns the values that are not the cluster's own inputs, and the odometer that it counts itself.
fn from_the_bus(vehicle: &'static Vehicle) -> impl Iterator<Item = Value> {
    let mut deaf = Cluster::new(vehicle);
    deaf.tick(&Inputs::default(), Millis(0));
    let is_own = move |value| deaf.shown(value, Millis(0)) != Shown::Never;
    Value::ALL.iter().copied().filter(move |value| !is_own(*value) || *value == Value::ClusterOdometer)
}

fn text_of(value: Value, shown: Shown<i32>) -> String {
    match shown {
        Shown::Value(counts) => value.unit().show(counts).to_string(),
        missing => format!("-- ({})", state_of(missing)),
    }
}

fn state_of(shown: Shown<i32>) -> &'static str {
    shown.missing().map_or("value", Missing::word)
}

fn lit(lamps: Telltales) -> Vec<&'static str> {
    Telltale::ALL.iter().filter(|lamp| lamps.is_lit(**lamp)).map(|lamp| lamp.key()).collect()
}

fn line(line: Option<Line>) -> (String, Json) {
    let Some(line) = line else {
        return ("empty".into(), json!({ "fault": null, "severity": null, "zh": null, "en": null }));
    };
    let severity = line.severity.word();
    let code = line.code.map(|code| format!(" {code}")).unwrap_or_default();
    let turn =
        if line.count > 1 { format!("  ({} of {})", line.position, line.count) } else { String::new() };
    let text = format!("{severity}{code}: {} {}{turn}", line.text.en, line.text.zh);
    let fields = json!({
        "fault": line.named.fault.key(), "stage": line.named.stage_key(),
        "severity": severity, "code": line.code, "zh": line.text.zh, "en": line.text.en,
        "position": line.position, "count": line.count,
    });
    (text, fields)
}

fn sound(chime: Option<Chime>) -> (String, Json) {
    let Some(chime) = chime else { return ("silent".into(), json!({ "sound": null })) };
    let Chime { frequency_hz, on_ms, off_ms, .. } = chime;
    let sound = chime.sound.key();
    let text = format!("{sound} ({frequency_hz} Hz, {on_ms} ms on, {off_ms} ms off)");
    (text, json!({ "sound": sound, "frequency_hz": frequency_hz, "on_ms": on_ms, "off_ms": off_ms }))
}

/// What became of the frames.
#[derive(Default)]
struct Tally {
    taken: usize,
    /// Frames of the vehicle that are for other nodes.
    for_others: usize,
    unknown: usize,
    short: usize,
    damaged: usize,
    remote: usize,
    frames: usize,
    /// Time of the last frame.
    last: Nanos,
}

impl Tally {
    fn count(&mut self, instrument: &mut Instrument, known: &RunTime, entry: &bench::log::Entry) {
        self.frames += 1;
        self.last = entry.at;
        let counter = match can_frame(&entry.frame) {
            None => &mut self.remote,
            // An instrument for one vehicle keeps no frame for later.
            Some(frame) => {
                match instrument.hear(&frame, Millis(entry.at.0 / 1_000_000)).unwrap_or(Received::Unknown) {
                    Received::Stored => &mut self.taken,
                    Received::TooShort => &mut self.short,
                    Received::Damaged => &mut self.damaged,
                    Received::Unknown if known.network.message_of(frame.id).is_some() => &mut self.for_others,
                    Received::Unknown => &mut self.unknown,
                }
            }
        };
        *counter += 1;
    }

    fn report(&self, errors: usize, vehicle: &Vehicle, json: bool, out: &mut impl Write) -> io::Result<()> {
        let Self { taken, for_others, unknown, short, damaged, remote, frames, last } = self;
        let millis = last.0 / 1_000_000;
        if json {
            let fields = json!({
                "name": "summary", "vehicle": vehicle.name, "frames": frames, "taken": taken,
                "for_others": for_others, "unknown": unknown, "short": short, "damaged": damaged,
                "remote": remote, "error_frames": errors, "span_ms": millis,
            });
            return writeln!(out, "{fields}");
        }
        let counts = [
            (*taken, "taken"),
            (*for_others, "for other nodes"),
            (*unknown, "unknown"),
            (*short, "too short"),
            (*damaged, "with a wrong checksum"),
            (*remote, "remote requests"),
            (errors, "error frames"),
        ];
        let counts: Vec<String> = counts
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, what)| format!("{count} {what}"))
            .collect();
        writeln!(out, "\nvehicle  {}", vehicle.name)?;
        writeln!(out, "frames   {frames} in {} s: {}", short_seconds(millis), counts.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn own_inputs_are_not_the_buses_news() {
        for vehicle in protocol_core::generated::VEHICLES {
            let values: Vec<Value> = from_the_bus(vehicle).collect();
            assert!(!values.contains(&Value::BodyKey) && values.contains(&Value::ClusterOdometer));
            assert!(values.contains(&Value::BatterySoc));
        }
    }
}
