//! Generates docs/reference/: what every vehicle sends, what the cluster makes of it, every fault.
//!
//! Made from the same generated tables as the firmware, and from the comments of the DBC files; committed, and compared
//! by `cargo xtask ci`. Which signal feeds which value is found by trying: a signal that changes a value feeds it.

use crate::faces;
use crate::out::say;
use crate::vehicles::{Tables, decimal, value_of, with_unit};
use crate::workspace;
use anyhow::{Context, Result, bail};
use bench::log::{BLF, FORMATS, Format};
use clap::Args;
use cluster::faults::{self, Grade, ROWS, Route, Voice, When, Words};
use cluster::view::Text;
use cluster::{Cluster, Inputs};
use protocol_core::Millis;
use protocol_core::codec::{LifeKind, MessageInfo, Mux, Order, SignalInfo};
use protocol_core::generated::SHIPPED_VEHICLES;
use protocol_core::model::{Readings, Severity, Shown, Unit, Value};
use protocol_core::states::{KINDS, State};
use protocol_core::vehicle::{FaultText, Vehicle};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;
use vehicle_compiler::lint;

/// What to do with the pages.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Compares with the committed pages and writes nothing.
    #[arg(long)]
    pub check: bool,
}

const FOLDER: &str = "docs/reference";
const REFRESH: &str = "run `cargo xtask reference` and commit the result";

/// Comments by packed identifier and signal.
type Comments = BTreeMap<(u32, String), String>;

/// Writes the pages, or checks that they are up to date.
///
/// # Errors
/// If a DBC file cannot be read, or a committed page is stale.
pub fn run(options: &Options) -> Result<()> {
    let mut stale = Vec::new();
    for (name, text) in pages()? {
        let path = format!("{FOLDER}/{name}.md");
        let file = workspace::root().join(&path);
        let old = std::fs::read_to_string(&file).unwrap_or_default();
        if old == text {
            continue;
        }
        if options.check {
            let line = old.lines().zip(text.lines()).take_while(|(old, new)| old == new).count() + 1;
            stale.push(format!("{path}:{line}: differs from what the vehicles give: {REFRESH}"));
            continue;
        }
        std::fs::create_dir_all(file.parent().unwrap_or(Path::new(".")))?;
        std::fs::write(&file, text).with_context(|| format!("{path}: cannot be written"))?;
        say!("{path}")?;
    }
    if !stale.is_empty() {
        bail!("{}", stale.join("\n       "));
    }
    if options.check {
        say!("reference pages are up to date")?;
    }
    Ok(())
}

/// Returns the page of the recordings' formats, from the rows by which they are read.
fn recordings() -> String {
    let mut page = String::from(
        "# Recordings\n\nThe formats that `decode`, `replay`, `run --log` and `convert` read, found by the head or the lines of the file. \
         `convert`\nwrites candump (`.log`), Vector ASC (`.asc`) and python-can's CSV (`.csv`). Text may be UTF-8 or UTF-16, with CR, LF \
         or both\nat the ends of its lines. Frames of CAN FD are counted and left out.\n\n\
         | format | written by | times | holds |\n| --- | --- | --- | --- |\n",
    );
    for Format { name, written_by, times, holds, .. } in FORMATS {
        let _ = writeln!(page, "| {name} | {written_by} | {times} | {holds} |");
    }
    let _ = writeln!(
        page,
        "| {BLF} | CANoe, CANalyzer, python-can | nanoseconds or 10 us since the start | channels, remote requests, errors, \
         length codes of 9 to 15 |"
    );
    page += "\n## Two frames in each\n";
    for Format { name, sample, .. } in FORMATS.iter().filter(|format| !format.sample.is_empty()) {
        let _ = write!(page, "\n{name}:\n\n```text\n{sample}```\n");
    }
    page
}

/// Returns name and text of every page.
fn pages() -> Result<Vec<(String, String)>> {
    let mut pages = vec![
        ("support".into(), support()),
        ("faults".into(), faults()),
        ("states".into(), states()),
        ("values".into(), values()?),
        ("recordings".into(), recordings()),
    ];
    for tables in Tables::all() {
        let name = tables.vehicle.name;
        let path = format!("vehicles/{name}/{name}.dbc");
        let text = std::fs::read_to_string(workspace::root().join(&path))
            .with_context(|| format!("{path}: cannot be read"))?;
        pages.push((name.into(), vehicle(tables, &lint::comments(&path, &text)?)));
    }
    Ok(pages)
}

/// Returns a row of a table.
fn row(cells: &[String]) -> String {
    let cells: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|").replace('\n', " ")).collect();
    format!("| {} |\n", cells.join(" | "))
}

/// Returns the head of a table.
fn head(names: &[&str]) -> String {
    let names: Vec<String> = names.iter().map(ToString::to_string).collect();
    format!("\n{}|{}\n", row(&names), "---|".repeat(names.len()))
}

fn page(title: &str, text: &str) -> String {
    format!("# {title}\n\n<!-- Generated: cargo xtask reference -->\n\n{text}\n")
}

/// One vehicle: a table of its messages, then a table of signals for each.
fn vehicle(tables: Tables, comments: &Comments) -> String {
    let Tables { vehicle, messages } = tables;
    let signals: usize = messages.iter().map(|message| message.signals.len()).sum();
    let mut out = page(
        &format!("Vehicle `{}`: messages and signals", vehicle.name),
        &format!(
            "{} messages, {signals} signals, {} kbit/s. Source: `vehicles/{}/`. Bits are numbered as in the DBC: the \
             lowest bit of an Intel signal, the highest of a Motorola signal. A value outside its range is not valid. \
             The values of the cluster are in [support.md](support.md), fault texts in [faults.md](faults.md).",
            messages.len(),
            vehicle.bitrate / 1_000,
            vehicle.name
        ),
    );
    out += &head(&["Id", "Message", "Sender", "Cycle", "Bytes", "Signals", "Cluster", "About"]);
    for message in messages {
        out += &row(&[
            format!("`{}`", message.id),
            format!("[{}](#{})", message.name, anchor(message)),
            message.sender.into(),
            cycle(message),
            message.len.to_string(),
            message.signals.len().to_string(),
            role(vehicle, message),
            comment(comments, message, "").into(),
        ]);
    }
    for message in messages {
        out += &signals_of(message, comments);
    }
    out
}

fn anchor(message: &MessageInfo) -> String {
    message.name.to_lowercase()
}

fn cycle(message: &MessageInfo) -> String {
    let optional = if message.optional { ", optional" } else { "" };
    match (message.cycle_ms, message.slow_cycle_ms) {
        (0, _) => format!("on events{optional}"),
        (cycle, slow) if slow > cycle => format!("{cycle} to {slow} ms{optional}"),
        (cycle, _) => format!("{cycle} ms{optional}"),
    }
}

/// Returns what the cluster does with a message.
fn role(vehicle: &Vehicle, message: &MessageInfo) -> String {
    if let Some(received) = vehicle.rx.iter().find(|received| received.id == message.id) {
        return format!("receives, stale after {} ms", received.timeout_ms);
    }
    match vehicle.tx.iter().find(|sent| sent.id == message.id) {
        Some(sent) => format!("sends every {} ms", sent.cycle_ms),
        None => String::new(),
    }
}

fn comment<'a>(comments: &'a Comments, message: &MessageInfo, signal: &str) -> &'a str {
    comments.get(&(message.id.packed(), signal.to_owned())).map_or("", String::as_str)
}

/// Splits a comment into the document's Chinese name and the rest.
fn halves(comment: &str) -> (String, String) {
    let is_chinese = |letter: char| ('\u{3000}'..='\u{9FFF}').contains(&letter) || letter >= '\u{FF00}';
    let sentence = comment.find(['.', ';']).map_or(comment, |end| &comment[..end]);
    let Some((last, _)) = sentence.char_indices().rfind(|(_, letter)| is_chinese(*letter)) else {
        return (String::new(), comment.trim().into());
    };
    // The name ends with the word that holds its last Chinese character.
    let end = sentence[last..].find(' ').map_or(sentence.len(), |space| last + space);
    let (chinese, rest) = comment.split_at(end);
    (chinese.trim().into(), rest.trim_start_matches(['.', ';', ' ']).trim().into())
}

fn signals_of(message: &MessageInfo, comments: &Comments) -> String {
    let about = comment(comments, message, "");
    let mut out = format!("\n## {}\n\n`{}` {about}\n", message.name, message.id);
    if message.signals.is_empty() {
        return out;
    }
    out +=
        &head(&["Signal", "名称", "Start", "Type", "Factor", "Offset", "Range", "Unit", "Values", "Remarks"]);
    for signal in message.signals {
        let (chinese, english) = halves(comment(comments, message, signal.name));
        let scale = signal.scale;
        let mut limits = [signal.range.0, signal.range.1];
        limits.sort_by_key(|&raw| scale.counts(raw));
        let [least, most] = limits.map(|raw| value_of(signal, raw));
        let words: Vec<String> = signal.values.iter().map(|(raw, word)| format!("{raw} {word}")).collect();
        out += &row(&[
            format!("`{}`", signal.name),
            chinese,
            signal.start.to_string(),
            kind(signal),
            decimal(scale.mul.into(), scale.den),
            decimal(scale.add.into(), scale.den),
            format!("{least} to {most}"),
            signal.unit.into(),
            words.join(", "),
            remarks(message, signal, &english),
        ]);
    }
    out
}

/// Returns the form of a signal: `u16 LE`, `i8`; the byte order matters beyond one byte only.
fn kind(signal: &SignalInfo) -> String {
    let sign = if signal.signed { 'i' } else { 'u' };
    let within_byte = match signal.order {
        Order::Intel => u32::from(signal.start) % 8 + u32::from(signal.length) <= 8,
        Order::Motorola => signal.length <= signal.start % 8 + 1,
    };
    let order = match signal.order {
        _ if within_byte => "",
        Order::Intel => " LE",
        Order::Motorola => " BE",
    };
    format!("{sign}{}{order}", signal.length)
}

fn remarks(message: &MessageInfo, signal: &SignalInfo, english: &str) -> String {
    let mut remarks = Vec::new();
    match signal.mux {
        Mux::Always => {}
        Mux::Selector => remarks.push("selects the multiplexed signals".into()),
        Mux::When(raw) => {
            let selector = message.signals.iter().find(|signal| signal.mux == Mux::Selector);
            remarks.push(format!("only while `{}` is {raw}", selector.map_or("", |selector| selector.name)));
        }
    }
    if let Some(life) = signal.life {
        remarks.push(match life {
            LifeKind::From0To255 => "life counter 0 to 255".into(),
            LifeKind::From1To255 => "life counter 1 to 255".into(),
            LifeKind::Nibble => "life counter 0 to 15".into(),
        });
    }
    if let Some(raw) = signal.invalid_raw {
        remarks.push(format!("raw {raw} = not available"));
    }
    if signal.start_raw != 0 {
        remarks.push(match signal.physical(signal.start_raw) {
            Some(counts) => {
                format!("starts at {}", with_unit(&decimal(counts, signal.scale.den), signal.unit))
            }
            None => format!("starts at raw {}", signal.start_raw),
        });
    }
    if !english.is_empty() {
        remarks.push(english.trim_end_matches('.').into());
    }
    remarks.join("; ")
}

/// Which model values each vehicle brings, and from which signals.
fn support() -> String {
    let all: Vec<Tables> = Tables::all().collect();
    let sources: Vec<BTreeMap<Value, BTreeSet<String>>> = all.iter().map(|tables| sources(*tables)).collect();
    let mut out = page(
        "Values of the cluster and where they come from",
        "One row per value of the vehicle-neutral model (`protocol-core/src/model.rs`), one column per vehicle: the \
         messages and signals that the value is made of. An empty cell: this vehicle does not have it.",
    );
    let mut names = vec!["Value", "Unit"];
    names.extend(all.iter().map(|tables| tables.vehicle.name));
    out += &head(&names);
    let own = own_values(all.first().map(|tables| tables.vehicle));
    for value in Value::ALL {
        let mut cells = vec![format!("`{}`", value.path()), unit(value.unit())];
        for sources in &sources {
            let from: Vec<String> = sources.get(value).into_iter().flatten().cloned().collect();
            let own = if own.contains(value) { "own input" } else { "" };
            cells.push(if from.is_empty() { own.into() } else { from.join(", ") });
        }
        out += &row(&cells);
    }
    let mut counts = vec!["values from the bus".to_string(), String::new()];
    counts.extend(sources.iter().map(|sources| sources.len().to_string()));
    out + &row(&counts)
}

fn unit(unit: Unit) -> String {
    match (unit, unit.kind()) {
        (_, Some(kind)) => format!("[{0}](states.md#{0})", kind.name),
        (Unit::Bits, None) => "bits".into(),
        (_, None) => unit.symbol().into(),
    }
}

/// Returns the values that the cluster has without a bus.
fn own_values(vehicle: Option<&'static Vehicle>) -> BTreeSet<Value> {
    let Some(vehicle) = vehicle else { return BTreeSet::new() };
    let mut deaf = Cluster::new(vehicle);
    deaf.tick(&Inputs::default(), Millis(0));
    let is_own = |value: &Value| deaf.shown(*value, Millis(0)) != Shown::Never;
    Value::ALL.iter().copied().filter(is_own).collect()
}

/// Returns the signals that each value is made of, as `MESSAGE.signal`.
pub fn sources(tables: Tables) -> BTreeMap<Value, BTreeSet<String>> {
    let mut found: BTreeMap<Value, BTreeSet<String>> = BTreeMap::new();
    for (index, received) in tables.vehicle.rx.iter().enumerate() {
        let Some(message) = tables.message(received.id) else { continue };
        let decoded = |data: &[u8; 8]| {
            let mut readings = Readings::new();
            (tables.vehicle.decode)(index as u8, data, &mut readings);
            readings
        };
        for base in bases(message) {
            let before = decoded(&base);
            for signal in message.signals.iter().filter(|signal| message.carries(signal, &base)) {
                for raw in probes(signal) {
                    let mut data = base;
                    signal.set_raw(&mut data, raw);
                    let after = decoded(&data);
                    // A multiplexer chooses which values are read; it is not what they are made of.
                    let changed = |value: &&Value| match signal.mux {
                        Mux::Selector => before.get(**value).is_some() && after.get(**value).is_some(),
                        _ => true,
                    } && before.get(**value) != after.get(**value);
                    for value in Value::ALL.iter().filter(changed) {
                        let name = format!("{}.{}", message.name, signal.name);
                        found.entry(*value).or_default().insert(name);
                    }
                }
            }
        }
    }
    for stream in tables.vehicle.streams {
        let bound = &stream.bound;
        let values = [bound.highest, bound.lowest, bound.highest_number, bound.lowest_number, bound.count];
        for value in values.into_iter().flatten() {
            found.entry(value).or_default().insert(format!("stream {}", stream.name));
        }
    }
    found
}

/// Returns frames to start from: all signals at their start, lowest and highest values, for each multiplexer state.
fn bases(message: &MessageInfo) -> Vec<[u8; 8]> {
    let mut states: BTreeSet<Option<u32>> = BTreeSet::from([None]);
    states.extend(message.signals.iter().filter_map(|signal| match signal.mux {
        Mux::When(raw) => Some(Some(raw)),
        _ => None,
    }));
    let mut bases = Vec::new();
    let picks: [fn(&SignalInfo) -> i64; 3] = [|s| s.start_raw, |s| s.range.0, |s| s.range.1];
    for state in states {
        for pick in picks {
            let mut data = message.fill;
            for signal in message.signals {
                match signal.mux {
                    Mux::When(raw) if Some(raw) != state => {}
                    Mux::Selector if state.is_some() => {
                        signal.set_raw(&mut data, i64::from(state.unwrap_or(0)));
                    }
                    _ => signal.set_raw(&mut data, pick(signal)),
                }
            }
            bases.push(data);
        }
    }
    bases
}

/// Returns raw values that a signal is tried with: its limits, its words, its codes, and what is not valid.
fn probes(signal: &SignalInfo) -> BTreeSet<i64> {
    let (low, high) = signal.range;
    let all_ones = (1_i64 << signal.length.min(32)) - 1;
    let mut probes = BTreeSet::from([low, high, low + (high - low) / 2, signal.start_raw, all_ones]);
    probes.extend(low..=high.min(low + 7));
    probes.extend(signal.values.iter().map(|(raw, _)| *raw));
    probes.extend(signal.invalid_raw);
    probes
}

/// Where each received value shows.
fn values() -> Result<String> {
    let all: Vec<Tables> = Tables::all().filter(is_shipped).collect();
    let found: Vec<faces::Faces> =
        all.iter().map(|tables| faces::of(*tables, &sources(*tables))).collect::<Result<_>>()?;
    for (tables, faces) in all.iter().zip(&found) {
        faces::check(tables.vehicle.name, faces)?;
    }
    let mut out = page(
        "Where values show",
        "One row per value that a vehicle sends, one column per vehicle: the pages that show it, the telltales that it \
         lights, whether it makes a fault line or a sound and whether the cluster sends it on. Found by changing one \
         signal at a time in the vehicle's own recording and comparing all that the cluster gives out; a value that needs \
         more than one signal to act may have more faces than are found so. What no driver sees has its reason.",
    );
    let mut names = vec!["Value"];
    names.extend(all.iter().map(|tables| tables.vehicle.name));
    out += &head(&names);
    for value in Value::ALL {
        if !found.iter().any(|faces| faces.contains_key(value)) {
            continue;
        }
        let mut cells = vec![format!("`{}`", value.path())];
        cells.extend(all.iter().zip(&found).map(|(tables, faces)| {
            let seen = faces.get(value).into_iter().flatten().cloned().collect::<Vec<_>>();
            let reason = faces.get(value).and_then(|_| faces::reason(tables.vehicle.name, *value));
            reason.map_or(seen.join(", "), |reason| format!("hidden: {reason}"))
        }));
        out += &row(&cells);
    }
    Ok(out)
}

/// Returns whether images have this vehicle.
fn is_shipped(tables: &Tables) -> bool {
    SHIPPED_VEHICLES.iter().any(|vehicle| vehicle.name == tables.vehicle.name)
}

/// The rows of the cluster's table of faults, and the texts of every vehicle's codes.
fn faults() -> String {
    let mut out = page(
        "Faults",
        "What puts a line on the screen. Scenarios and JSON have the key; the number is that of the history and of the PC \
         link, and is kept for ever. Where a row reads the codes of a node, the vehicle's own text of the code stands in \
         place of the row's. The rows are those of `app/cluster/src/faults/table.rs`.",
    );
    out +=
        &head(&["Number", "Key", "Stage", "中文", "English", "When", "Severity", "Sound", "History", "Turn"]);
    for fault in ROWS {
        let stages = fault.words.stages();
        let each =
            |of: fn(&Text) -> &'static str| join(fault.words.texts().iter().map(|text| of(text).into()));
        let (zh, en) = match fault.words {
            Words::Vehicle => ("(车名)".into(), "(the vehicle's name)".into()),
            _ => (each(|text| text.zh), each(|text| text.en)),
        };
        let mut when = fault.routes.iter().map(condition).collect::<Vec<_>>();
        if !fault.codes.is_empty() {
            let nodes = fault.codes.iter().map(|node| node.key()).collect::<Vec<_>>().join(", ");
            when.push(format!("texts of the codes of: {nodes}"));
        }
        let mut severities: Vec<String> = fault.routes.iter().map(severity).collect();
        severities.dedup();
        out += &row(&[
            fault.fault.number().to_string(),
            format!("`{}`", fault.fault.key()),
            join(stages.iter().map(|stage| format!("`{stage}`"))),
            zh,
            en,
            join(when.into_iter()),
            join(severities.into_iter()),
            match fault.voice {
                Voice::Silent => String::new(),
                Voice::AsSevere => "of its severity".into(),
                Voice::Moving => "of its severity, not while the vehicle stands".into(),
                Voice::Fire => "fire".into(),
            },
            if fault.is_kept { "kept".into() } else { String::new() },
            match fault.order {
                faults::Order::Turn(turn) => turn.to_string(),
                faults::Order::Over => "before all".into(),
                faults::Order::Beside => "beside".into(),
            },
        ]);
    }
    out += "\n## Codes\n\nA code means what its own sender says; the same number means something else elsewhere. No severity: \
            the sender's level says how bad it is.\n";
    for tables in Tables::all() {
        let vehicle = tables.vehicle;
        let _ = writeln!(out, "\n### {}\n\n{} codes.", vehicle.name, vehicle.faults.len());
        if vehicle.faults.is_empty() {
            continue;
        }
        out += &head(&["Source", "Code", "Severity", "中文", "English"]);
        for FaultText { source, code, severity, zh, en, .. } in vehicle.faults {
            let source = vehicle.node(*source).map_or(source.key(), |name| name.en);
            let severity = severity.map(|severity| severity.word()).unwrap_or_default();
            out += &row(&[source.into(), code.to_string(), severity.into(), (*zh).into(), (*en).into()]);
        }
    }
    out
}

/// Returns what stands in one cell, one below the other.
fn join(parts: impl Iterator<Item = String>) -> String {
    parts.collect::<Vec<_>>().join("<br>")
}

/// Returns the number of a value as somebody reads it.
fn word(value: Value, number: i32) -> String {
    let state = value.unit().kind().and_then(|kind| kind.of_number(number));
    state.map_or(number.to_string(), |state| state.word.to_owned())
}

/// Returns what makes a report by this route, in words.
fn condition(route: &Route) -> String {
    let path = |value: Value| format!("`{}`", value.path());
    let any = |values: &[Value]| values.iter().map(|value| path(*value)).collect::<Vec<_>>().join(" or ");
    let mut text = match route.when {
        When::Level(value) => format!("{} above none", path(value)),
        When::Code(value) => format!("{} not 0", path(value)),
        When::Is(value, number) => format!("{} = {}", path(value), word(value, number)),
        When::AnyIs(values, number) => format!("{} = {}", any(values), word(values[0], number)),
        When::AnyBelow(values, limit) => format!("{} below {}", any(values), values[0].unit().show(limit)),
        When::Moving(flags) => {
            format!("{} = yes, while {} is above 0", any(flags), path(Value::VehicleSpeed))
        }
        When::Bits(value) => format!("a bit of {}, its code is its number from 1", path(value)),
        When::Silent(node) => format!("an expected message of {} is missing", node.key()),
        When::HvOff => format!("{} = yes, through silence too", path(Value::BatteryHvOffRequest)),
        When::ChargerLost => format!("{} = yes and the charger silent for 5 s", path(Value::ChargePlug)),
        When::HvacLost => format!("{} = yes and silent for 10 s, if wanted", path(Value::HvacOn)),
        When::Limps => format!("{} = limp, or the battery silent for 5 s", path(Value::VehicleMode)),
        When::Fire(_, value) => format!("a code that means fire in {}", path(value)),
        When::Own => "found by the instrument in itself".into(),
    };
    if let Some(code) = route.code {
        let rotates = if route.rotates { ", several in turn" } else { "" };
        let _ = write!(text, ", code {}{rotates}", path(code));
    }
    if let Some(value) = route.unless_sent {
        let _ = write!(text, ", not where {} is sent", path(value));
    }
    if let Some(fault) = route.repeats {
        let _ = write!(text, ", the same as `{}`", fault.key());
    }
    text
}

/// Returns how bad a report by this route is, in words.
fn severity(route: &Route) -> String {
    match route.grade {
        Grade::Level(value) => format!("`{}`", value.path()),
        Grade::Always(severity) => severity.word().into(),
        Grade::Joins(Severity::None) => format!("`{}`", Value::VehicleFaultLevel.path()),
        Grade::Joins(least) => {
            format!("`{}`, at least {}", Value::VehicleFaultLevel.path(), least.word())
        }
        Grade::Alarm(value) => format!("its text's, or `{}`, at least warn", value.path()),
    }
}

/// The states of every kind.
fn states() -> String {
    let mut out = page(
        "States",
        "What is no quantity is a state. `vehicle.toml`, scenarios, recordings and JSON have the word; the number is that \
         of the model and of the PC link. The rows are those of `protocol-core/src/states.rs`.",
    );
    for kind in KINDS {
        let values = Value::ALL.iter().filter(|value| value.unit().kind() == Some(*kind));
        let paths: Vec<String> = values.map(|value| format!("`{}`", value.path())).collect();
        let _ = writeln!(out, "\n## {}", kind.name);
        if !paths.is_empty() {
            let _ = writeln!(out, "\n{}", paths.join(", "));
        }
        out += &head(&["Number", "Word", "中文", "English"]);
        for State { number, word, zh, en, .. } in kind.states {
            out += &row(&[number.to_string(), format!("`{word}`"), (*zh).into(), (*en).into()]);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_split_into_the_documents_name_and_the_rest() {
        let cases = [
            ("整车车速 Vehicle speed; drives the dial.", "整车车速", "Vehicle speed; drives the dial."),
            ("剩余电量(SOC) State of charge. C5-12", "剩余电量(SOC)", "State of charge. C5-12"),
            ("VCU 广播信息 Relay command; 打开 is on", "VCU 广播信息", "Relay command; 打开 is on"),
            ("DC/DC converter. 电", "", "DC/DC converter. 电"),
            ("", "", ""),
        ];
        for (comment, chinese, rest) in cases {
            assert_eq!(halves(comment), (chinese.into(), rest.into()));
        }
    }

    #[test]
    fn every_page_names_every_vehicle_or_is_one() {
        let pages = pages().unwrap();
        for tables in Tables::all() {
            let name = tables.vehicle.name;
            assert!(pages.iter().any(|(page, _)| page == name));
            assert!(pages[0].1.contains(name) && pages[1].1.contains(name));
        }
    }

    #[test]
    fn every_fault_stands_in_the_reference_with_its_number_its_words_and_its_condition() {
        let text = faults();
        for fault in ROWS {
            let start = format!("| {} | `{}` |", fault.fault.number(), fault.fault.key());
            let line = text.lines().find(|line| line.starts_with(&start)).expect("a row of the page");
            assert!(fault.words.texts().iter().all(|said| line.contains(said.zh) && line.contains(said.en)));
            assert!(fault.routes.iter().all(|route| line.contains(&condition(route))), "{line}");
        }
    }

    #[test]
    fn the_sources_of_a_value_are_found() {
        let bus = sources(Tables::named("citybus").unwrap());
        assert_eq!(bus[&Value::VehicleSpeed], BTreeSet::from(["VCU1.vehicle_speed".to_owned()]));
    }
}
