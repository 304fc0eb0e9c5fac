//! From a file to a [`Scenario`]: every mistake is told with its line and with what there is instead.
//!
//! TOML, one row per step; bench/scenarios/README.md has the format. Steps stand in the order of time. What cannot be
//! done or looked at in this vehicle is refused here, before anything runs.

use super::{Act, Action, BusFault, Demand, Name, Place, Scenario, Wanted};
use crate::can::{Frame, Id};
use crate::scenario::line::WantedLine;
use anyhow::{Context, Result, bail};
use cluster::Button;
use serde::Deserialize;
use std::path::Path;
use toml::{Spanned, Table, Value};
use virtual_vehicle::{ControlError, Cycles, Kind, Options, VirtualVehicle};

/// Time that what is shown may take, in seconds: the link's records come every 200 ms and take 50 ms on the wire.
const WITHIN_S: f64 = 0.3;
/// Time for which a button is pressed, in seconds.
const PRESS_S: f64 = 0.2;
/// Longest scenario in seconds: a slip of the pen must not run for hours.
const LONGEST_S: f64 = 3_600.0;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: String,
    #[serde(default)]
    rules: Vec<Spanned<String>>,
    #[serde(default)]
    on: Option<Vec<Spanned<String>>>,
    #[serde(default)]
    build: Build,
    steps: Vec<Spanned<Step>>,
}

/// How the vehicle is built; what is left out is as usual.
#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields)]
struct Build {
    cells: Option<u16>,
    probes: Option<u16>,
    jitter_us: Option<u32>,
    seed: Option<u64>,
    optional: Option<bool>,
    slow_cycles: Option<bool>,
    overview_cycles: Option<bool>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Step {
    at: f64,
    set: Option<Table>,
    press: Option<String>,
    #[serde(rename = "for")]
    span: Option<f64>,
    send: Option<Frames>,
    every: Option<f64>,
    expect: Option<Table>,
    never: Option<Table>,
    within: Option<f64>,
    until: Option<f64>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Frames {
    One(String),
    Several(Vec<String>),
}

/// Reads a scenario; its vehicle is the name of its folder.
///
/// # Errors
/// If it cannot be read or is wrong; the error has a line for each mistake.
pub fn read_file(path: &Path) -> Result<Scenario> {
    let text =
        std::fs::read_to_string(path).with_context(|| format!("{}: cannot be read", path.display()))?;
    let part = |path: Option<&Path>| {
        path.and_then(Path::file_name).unwrap_or_default().to_string_lossy().into_owned()
    };
    let folder = part(path.parent());
    let Some(kind) = Kind::from_name(&folder) else {
        let names = Kind::ALL.map(Kind::name).join(", ");
        bail!("{}: lies in `{folder}`, which is no vehicle (there are {names})", path.display());
    };
    parse(&format!("{folder}/{}", part(Some(path))), kind, &text)
}

/// Reads the text of a scenario; `file` is its name in messages.
///
/// # Errors
/// If it is wrong; the error has a line for each mistake.
pub fn parse(file: &str, kind: Kind, text: &str) -> Result<Scenario> {
    let line_of = |offset: usize| text.bytes().take(offset).filter(|byte| *byte == b'\n').count() + 1;
    let raw: File = match toml::from_str(text) {
        Ok(raw) => raw,
        Err(error) => {
            let line = line_of(error.span().map_or(0, |span| span.start));
            bail!("{file}:{line}: {}", error.message().trim_end());
        }
    };
    let mut reader = Reader { file, kind, wrong: Vec::new(), line: 1 };
    let on = reader.places(&raw, line_of);
    let rules = reader.rules(&raw, line_of);
    let options = options(&raw.build);
    let vehicle = VirtualVehicle::new(kind, options);
    let (mut acts, mut demands) = (Vec::new(), Vec::new());
    let mut last_at = 0.0;
    for step in &raw.steps {
        reader.line = line_of(step.span().start);
        let step = step.get_ref();
        if step.at < last_at {
            reader.fail(format!("{} s comes after {last_at} s: steps stand in the order of time", step.at));
        }
        last_at = step.at.max(last_at);
        reader.acts(step, &vehicle, &on, &mut acts);
        reader.demands(step, &mut demands);
    }
    if demands.is_empty() {
        reader.fail("nothing is expected: no step has `expect` or `never`".into());
    }
    if !reader.wrong.is_empty() {
        bail!("{}", reader.wrong.join("\n"));
    }
    acts.sort_by_key(|act: &Act| act.at_ms);
    let ends = demands.iter().map(|demand: &Demand| demand.until_ms.unwrap_or(0).max(demand.settled_ms));
    let end_ms = ends.chain(acts.iter().map(|act| act.at_ms)).max().unwrap_or_default();
    Ok(Scenario { file: file.into(), kind, title: raw.title, rules, on, options, acts, demands, end_ms })
}

fn options(build: &Build) -> Options {
    let usual = Options::default();
    Options {
        cycles: match (build.slow_cycles, build.overview_cycles) {
            (Some(true), _) => Cycles::Slow,
            (_, Some(true)) => Cycles::Overview,
            _ => Cycles::Page,
        },
        cells: build.cells.unwrap_or(usual.cells),
        probes: build.probes.unwrap_or(usual.probes),
        jitter_us: build.jitter_us.unwrap_or(usual.jitter_us),
        seed: build.seed.unwrap_or(usual.seed),
        optional: build.optional.unwrap_or(usual.optional),
    }
}

/// Reads one file and collects what is wrong with it.
struct Reader<'f> {
    file: &'f str,
    kind: Kind,
    wrong: Vec<String>,
    /// Line of what is being read.
    line: usize,
}

impl Reader<'_> {
    fn fail(&mut self, message: String) {
        self.wrong.push(format!("{}:{}: {message}", self.file, self.line));
    }

    fn places(&mut self, raw: &File, line_of: impl Fn(usize) -> usize) -> Vec<Place> {
        let Some(words) = &raw.on else { return Place::ALL.to_vec() };
        let mut places = Vec::new();
        for word in words {
            match Place::ALL.into_iter().find(|place| place.word() == word.get_ref()) {
                Some(place) => places.push(place),
                None => {
                    self.line = line_of(word.span().start);
                    self.fail(format!(
                        "`{}` is no place to run; there are host and firmware",
                        word.get_ref()
                    ));
                }
            }
        }
        places
    }

    fn rules(&mut self, raw: &File, line_of: impl Fn(usize) -> usize) -> Vec<String> {
        for rule in &raw.rules {
            let (document, number) = rule.get_ref().split_once("-R").unwrap_or_default();
            let is_number = number.len() == 3 && number.bytes().all(|digit| digit.is_ascii_digit());
            if !["BUS", "JL", "C5"].contains(&document) || !is_number {
                self.line = line_of(rule.span().start);
                self.fail(format!("`{}` is not a rule's number, for example BUS-R017", rule.get_ref()));
            }
        }
        raw.rules.iter().map(|rule| rule.get_ref().clone()).collect()
    }

    /// Returns seconds as milliseconds.
    fn millis(&mut self, what: &str, seconds: f64) -> u64 {
        if !(0.0..=LONGEST_S).contains(&seconds) {
            self.fail(format!("`{what}` is {seconds} s; it takes 0 to {LONGEST_S} s"));
            return 0;
        }
        (seconds * 1_000.0).round() as u64
    }

    fn acts(&mut self, step: &Step, vehicle: &VirtualVehicle, on: &[Place], acts: &mut Vec<Act>) {
        let at_ms = self.millis("at", step.at);
        let line = self.line;
        let mut add = |at_ms, action| acts.push(Act { at_ms, line, action });
        for (path, value) in flat(step.set.as_ref(), &[]) {
            if let Some(action) = self.setting(&path, value, vehicle, on) {
                add(at_ms, action);
            }
        }
        if let Some(word) = &step.press {
            let span_ms = self.millis("for", step.span.unwrap_or(PRESS_S));
            match button(word) {
                Some(button) => {
                    add(at_ms, Action::Hold(button, true));
                    add(at_ms + span_ms, Action::Hold(button, false));
                }
                None => self.fail(format!("`{word}` is no button; there are next and menu")),
            }
        } else if step.span.is_some() {
            self.fail("`for` goes with `press`".into());
        }
        let frames = match &step.send {
            None => Vec::new(),
            Some(Frames::One(frame)) => vec![frame],
            Some(Frames::Several(frames)) => frames.iter().collect(),
        };
        let mut times = vec![at_ms];
        match (step.every, step.until) {
            (None, _) => {}
            (Some(_), _) if frames.is_empty() => self.fail("`every` goes with `send`".into()),
            (Some(_), None) => self.fail("`every` needs an end: `until`".into()),
            (Some(every), Some(until)) => {
                let (every_ms, until_ms) = (self.millis("every", every), self.millis("until", until));
                times = (at_ms..=until_ms).step_by(every_ms.max(1) as usize).collect();
            }
        }
        for text in frames {
            match frame(text) {
                Some(frame) => times.iter().for_each(|at_ms| add(*at_ms, Action::Send(frame))),
                None => self.fail(format!("`{text}` is no frame, for example 18F13DF3#0011223344556677")),
            }
        }
        let does = step.set.is_some() || step.press.is_some() || step.send.is_some();
        if !does && step.expect.is_none() && step.never.is_none() {
            self.fail("the step does nothing: it has none of set, press, send, expect, never".into());
        }
    }

    fn setting(
        &mut self,
        path: &str,
        value: &Value,
        vehicle: &VirtualVehicle,
        on: &[Place],
    ) -> Option<Action> {
        let text = match value {
            Value::String(word) => word.clone(),
            Value::Boolean(on) => if *on { "on" } else { "off" }.to_owned(),
            Value::Integer(number) => number.to_string(),
            Value::Float(number) => number.to_string(),
            _ => {
                self.fail(format!("`{path}` takes a word or a number"));
                return None;
            }
        };
        let flag = match &text[..] {
            "on" => Some(true),
            "off" => Some(false),
            _ => None,
        };
        if let Some((_, fault)) = BusFault::ALL.into_iter().find(|(name, _)| *name == path) {
            if matches!(fault, BusFault::Garble | BusFault::PowerCut) && on.contains(&Place::Host) {
                self.fail(format!("`{path}` needs a bus and a board: on = [\"firmware\"]"));
            }
            if flag.is_none() {
                self.fail(format!("`{path}` takes off or on"));
            }
            return flag.map(|on| Action::Fault(fault, on));
        }
        if let Some(button) = path.strip_prefix("button.").and_then(button) {
            if flag.is_none() {
                self.fail(format!("`{path}` takes off or on"));
            }
            return flag.map(|on| Action::Hold(button, on));
        }
        let control = vehicle.controls().find(|control| control.path == path);
        let Some(control) = control else {
            let last = |path: &str| path.rsplit('.').next().unwrap_or_default().to_owned();
            let group = path.split('.').next();
            let all: Vec<&str> = self
                .kind
                .controls()
                .map(|control| control.path)
                .filter(|other| other.split('.').next() == group || last(other) == last(path))
                .chain(
                    BusFault::ALL
                        .map(|(name, _)| name)
                        .into_iter()
                        .filter(|name| name.split('.').next() == group),
                )
                .collect();
            let there = if all.is_empty() {
                "none is like it".into()
            } else {
                format!("there are {}", all.join(", "))
            };
            self.fail(format!("{} has no control `{path}`; {there}", self.kind.name()));
            return None;
        };
        match control.read(&text) {
            Ok(setting) => Some(Action::Set { path: path.to_owned(), setting }),
            Err(error @ ControlError::Spelling { .. }) => {
                self.fail(error.to_string());
                None
            }
            Err(error) => {
                self.fail(format!("{error}, not `{text}`"));
                None
            }
        }
    }

    fn demands(&mut self, step: &Step, demands: &mut Vec<Demand>) {
        let at_ms = self.millis("at", step.at);
        let within_ms = self.millis("within", step.within.unwrap_or(WITHIN_S));
        let until_ms = step.until.filter(|_| step.every.is_none()).map(|until| self.millis("until", until));
        let looks = step.expect.is_some() || step.never.is_some();
        if (step.within.is_some() || until_ms.is_some()) && !looks {
            self.fail("`within` and `until` go with `expect` or `never`".into());
        }
        if until_ms.is_some_and(|until_ms| until_ms < at_ms + within_ms) {
            let settled = (at_ms + within_ms) as f64 / 1_000.0;
            self.fail(format!(
                "`until` comes before the {settled} s by which it must have settled (`at` + `within`)"
            ));
        }
        if step.never.is_some() && until_ms.is_none() {
            self.fail("`never` needs an end: `until`".into());
        }
        for (table, never) in [(&step.expect, false), (&step.never, true)] {
            for (path, value) in flat(table.as_ref(), &["line", "unseen", "below"]) {
                let wanted = Name::read(&path, self.kind)
                    .and_then(|name| self.wanted(&name, value).map(|wanted| (name, wanted)));
                match wanted {
                    Ok((name, wanted)) => {
                        let (line, settled_ms) = (self.line, at_ms + within_ms);
                        demands.push(Demand { line, name, wanted, never, at_ms, settled_ms, until_ms });
                    }
                    Err(error) => self.fail(error),
                }
            }
        }
    }

    fn wanted(&self, name: &Name, value: &Value) -> Result<Wanted, String> {
        let answers = name.answers();
        let number = |value: &Value| match value {
            Value::Integer(number) => Some(*number as f64),
            Value::Float(number) => Some(*number),
            _ => None,
        };
        let check = |word: &str| {
            let free =
                *name == Name::Picture && Path::new(word).extension().is_some_and(|ending| ending == "png");
            if free || answers.words.iter().any(|known| known == word) {
                return Ok(word.to_owned());
            }
            if let Some(spelling) = answers.spelling(word) {
                return Err(spelling);
            }
            let mut there = answers.words.clone();
            if answers.numbers {
                there.push("a number, [from, to]".into());
            }
            Err(format!("`{name}` is never `{word}`; it is one of {}", there.join(", ")))
        };
        if matches!(name, Name::Line | Name::Unseen | Name::Below)
            && value.as_str() != Some("none")
            && let Some(line) = WantedLine::read(value, self.kind)
        {
            return line.map(Wanted::Line);
        }
        match value {
            Value::String(word) => check(word).map(|word| Wanted::Words(vec![word])),
            Value::Boolean(on) => {
                let words = if *on { ["on", "yes"] } else { ["off", "no"] };
                let word = words.into_iter().find(|word| answers.words.iter().any(|known| known == word));
                let word = word.ok_or_else(|| format!("`{name}` is not a yes or no"))?;
                Ok(Wanted::Words(vec![word.to_owned()]))
            }
            Value::Array(items) if !items.is_empty() && items.iter().all(Value::is_str) => {
                let words = items.iter().filter_map(Value::as_str).map(check);
                words.collect::<Result<_, _>>().map(Wanted::Words)
            }
            _ if !answers.numbers => {
                let state = value.as_integer().and_then(|number| answers.spelling(&number.to_string()));
                let is_no_number =
                    || format!("`{name}` is no number; it is one of {}", answers.words.join(", "));
                Err(state.unwrap_or_else(is_no_number))
            }
            Value::Array(items) => match items[..] {
                [ref low, ref high] => match (number(low), number(high)) {
                    (Some(low), Some(high)) if low <= high => Ok(Wanted::Range(low, high)),
                    _ => Err(format!("`{name}`: a range is [lowest, highest]")),
                },
                _ => Err(format!("`{name}`: a range is [lowest, highest]")),
            },
            value => {
                number(value).map(Wanted::Number).ok_or_else(|| format!("`{name}` takes a number or a word"))
            }
        }
    }
}

/// Returns the leaves of nested tables with their dotted paths; the tables named `whole` are leaves.
fn flat<'t>(table: Option<&'t Table>, whole: &[&str]) -> Vec<(String, &'t Value)> {
    let mut leaves = Vec::new();
    for (key, value) in table.into_iter().flatten() {
        match value {
            Value::Table(inner) if !whole.contains(&&key[..]) => {
                let inner = flat(Some(inner), &[]);
                leaves.extend(inner.into_iter().map(|(rest, value)| (format!("{key}.{rest}"), value)));
            }
            value => leaves.push((key.clone(), value)),
        }
    }
    leaves
}

fn button(word: &str) -> Option<Button> {
    match word {
        "next" => Some(Button::Next),
        "menu" => Some(Button::Menu),
        _ => None,
    }
}

/// Reads `18F13DF3#0011` or `123#00`, as candump and cansend write it.
fn frame(text: &str) -> Option<Frame> {
    let (id, data) = text.split_once('#')?;
    let raw = u32::from_str_radix(id, 16).ok()?;
    let id = match id.len() {
        3 => Id::standard(u16::try_from(raw).ok()?),
        8 => Id::extended(raw),
        _ => None,
    }?;
    if !data.is_ascii() || data.len() % 2 != 0 {
        return None;
    }
    let bytes = (0..data.len()).step_by(2).map(|at| u8::from_str_radix(&data[at..at + 2], 16).ok());
    Frame::new(id, &bytes.collect::<Option<Vec<u8>>>()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Scenario> {
        parse("citybus/test.toml", Kind::Citybus, text)
    }

    fn error(steps: &str) -> String {
        let text = format!("title = \"t\"\nsteps = [\n{steps}\n]\n");
        read(&text).map(|_| String::new()).unwrap_or_else(|error| error.to_string())
    }

    #[test]
    fn a_step_becomes_what_is_done_and_what_is_expected() {
        let scenario = read(
            "title = \"A title\"\nrules = [\"BUS-R017\"]\nsteps = [\n\
             { at = 0.5, send = \"18F13DF3#0011\", every = 0.1, until = 0.7 },\n\
             { at = 1, press = \"next\" },\n\
             { at = 2, expect = { telltale.ready = \"on\", \"battery.soc\" = [48, 52], sound = \"none\" }, until = 3 },\n\
             { at = 4, never = { line = { code = 24, severity = \"stop\" } }, within = 0, until = 5.5 },\n]\n",
        )
        .unwrap();
        assert_eq!(scenario.on, Place::ALL);
        assert_eq!(scenario.name(), "test");
        let times: Vec<u64> = scenario.acts.iter().map(|act| act.at_ms).collect();
        assert_eq!(times, [500, 600, 700, 1_000, 1_200]);
        assert_eq!(scenario.end_ms, 5_500);
        let demand =
            |name: &str| scenario.demands.iter().find(|demand| demand.name.to_string() == name).unwrap();
        assert_eq!(demand("telltale.ready").wanted, Wanted::Words(vec!["on".into()]));
        assert_eq!(demand("battery.soc").wanted, Wanted::Range(48.0, 52.0));
        assert_eq!((demand("sound").line, demand("sound").settled_ms), (6, 2_300));
        assert_eq!(demand("sound").until_ms, Some(3_000));
        assert!(demand("line").never);
        assert_eq!(demand("line").settled_ms, 4_000);
    }

    #[test]
    fn every_mistake_is_told_with_its_line_and_what_there_is() {
        let all = error(
            "{ at = 1, expect = { telltale.redy = \"on\" } },\n\
             { at = 2, expect = { sound = \"revers\" } },\n\
             { at = 1, expect = { gear = 5 } },\n\
             { at = 3 },\n\
             { at = 4, set = { driver.gaer = \"R\" } },\n\
             { at = 5, press = \"left\" },\n\
             { at = 6, send = \"18F13DF3\" },\n\
             { at = 7, never = { sound = \"stop\" } },\n\
             { at = 8, expect = { line = { text = \"Battery fault level 3\" } } },\n\
             { at = 8, expect = { line = [] } },",
        );
        let lines: Vec<&str> = all.lines().collect();
        let has = |line: usize, part: &str| {
            let place = format!("citybus/test.toml:{line}: ");
            assert!(lines.iter().any(|l| l.starts_with(&place) && l.contains(part)), "{line}: {part}\n{all}");
        };
        has(3, "no telltale `redy`; there are turn_left");
        has(4, "`sound` is never `revers`; it is one of none, fire, stop, reverse");
        has(5, "1 s comes after 2 s");
        has(5, "`gear` is no number; it is one of none, D, R");
        has(6, "the step does nothing");
        has(7, "bus has no control `driver.gaer`");
        has(8, "`left` is no button; there are next and menu");
        has(9, "`18F13DF3` is no frame");
        has(10, "`never` needs an end");
        has(11, "is written { fault = \"battery_code\", stage = \"level_3\" }");
        has(12, "`line` is no number; it is one of none");
    }

    #[test]
    fn a_file_that_is_no_toml_or_has_an_unknown_key_is_told_with_its_line() {
        assert!(
            error("{ at = 1, expect = { gear = \"R\" }, wihtin = 1 },")
                .starts_with("citybus/test.toml:3: unknown field")
        );
        assert!(error("{ at = 1,").starts_with("citybus/test.toml:"));
        let text = "title = \"t\"\non = [\"hsot\"]\nrules = [\"R17\"]\nsteps = []\n";
        let error = read(text).unwrap_err().to_string();
        assert!(error.contains("citybus/test.toml:2: `hsot` is no place"), "{error}");
        assert!(error.contains("citybus/test.toml:3: `R17` is not a rule's number"), "{error}");
        assert!(error.contains("nothing is expected"), "{error}");
    }

    #[test]
    fn frames_are_read_as_candump_writes_them() {
        for text in ["123#", "18F13DF3#0011223344556677", "7FF#FF"] {
            assert_eq!(frame(text).map(|frame| frame.to_string()).as_deref(), Some(text));
        }
        for text in ["", "12#00", "800#00", "123#0", "123#001122334455667788", "FFFFFFFF#", "123#é"] {
            assert_eq!(frame(text), None, "{text}");
        }
    }
}
