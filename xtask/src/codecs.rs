//! Measures the generated codecs on the emulated core, beside dbc-codegen and cantools' C.
//!
//! Every decoder reads the same random frames of the messages that a cluster receives on the bus, and must give the
//! numbers that the DBC's rows give. Counts only: what depends on the machine (throughput on the PC) is printed beside
//! the tables, not in them. Other compilers give other counts, so the page names them, and a check under others only
//! holds the targets.

mod core;
mod programs;

use self::core::{Core, Cost, DATA};
use self::programs::{LEVELS, Level, Programs};
use crate::out::say;
use crate::steps::Outcome;
use crate::workspace;
use anyhow::{Context, Result, bail, ensure};
use clap::Args;
use protocol_core::codec::{MessageInfo, SignalInfo};
use protocol_core::generated::citybus;
use protocol_core::{Reading, Readings, Value};
use std::fmt::Write;

/// What to do with the tables.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Fails if the page quotes other figures, or a target is missed.
    #[arg(long)]
    pub check: bool,
}

const PAGE: &str = "docs/codecs.md";
/// Frames of each message.
const FRAMES: usize = 500;
/// Most instructions of one decoded message, as a mean over the messages.
const MOST_INSTRUCTIONS: f64 = 50.0;
/// Most bytes of flash of all three vehicles' codecs.
const MOST_FLASH: u64 = 24 * 1024;

const VALUES: u32 = DATA + 0x100;
/// In place of an invalid value (`codec_cost::INVALID`).
const INVALID: i32 = i32::MIN;

/// One way to decode.
struct Candidate {
    program: &'static str,
    what: &'static str,
    kind: Kind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Raw value and scale of every bound signal.
    Values,
    /// The same, and [`INVALID`] in place of what is not valid.
    Judged,
    /// The vehicle's decoder into the model.
    Model,
}

const OURS: &str = "ours";
const CANDIDATES: &[Candidate] = &[
    Candidate { program: OURS, what: "ours", kind: Kind::Values },
    Candidate { program: "judged", what: "ours, each value judged valid or not", kind: Kind::Judged },
    Candidate { program: "model", what: "ours, as the firmware runs it: into the model", kind: Kind::Model },
    Candidate {
        program: "codegen_raw",
        what: "dbc-codegen, raw values and integer scale",
        kind: Kind::Values,
    },
    Candidate { program: "codegen_float", what: "dbc-codegen, physical values (`f32`)", kind: Kind::Values },
];
const CANTOOLS: &[Candidate] =
    &[Candidate { program: "cantools", what: "cantools' C, unpack and integer scale", kind: Kind::Values }];

/// Programs that only have a size.
const SIZES: &[(&str, &str)] = &[
    ("vehicles", "decode into the model and encode from it: the code that the firmware runs"),
    ("tables", "the same with receive and send tables, names and all fault texts in two languages"),
    ("every", "every signal of every message, bound or not: read with validity, and write"),
];

/// One message of the mix.
struct Message {
    name: String,
    signals: Vec<&'static SignalInfo>,
}

/// What a candidate costs at one level.
struct Measured {
    /// Mean and largest count of each message.
    messages: Vec<(f64, u32)>,
    cycles: f64,
    bytes: u64,
}

impl Measured {
    fn mean(&self) -> f64 {
        self.messages.iter().map(|(mean, _)| mean).sum::<f64>() / self.messages.len() as f64
    }
}

/// Prints the tables and writes them into the page, or checks that it quotes them.
///
/// # Errors
/// If a program cannot be built or run, two decoders disagree, a target is missed, or the page quotes other figures.
pub fn run(options: &Options) -> Result<()> {
    if let Outcome::Partly(reason) = measure_and_quote(options)? {
        say!("skipped: {reason}")?;
    }
    Ok(())
}

/// Does what [`run`] does; without a C compiler for the chip the part of cantools is left out.
///
/// # Errors
/// Like [`run`].
pub fn measure_and_quote(options: &Options) -> Result<Outcome> {
    let programs = Programs::build()?;
    let mix = messages(&programs)?;
    let frames = frames(&mix);
    let rust = measure_all(&programs, CANDIDATES, &mix, &frames)?;
    let mut pages = vec![Block { marker: "codecs", text: rust_tables(&programs, &mix, &rust)? }];
    let mut left_out = None;
    match &programs.gcc {
        Some(gcc) => {
            let c = measure_all(&programs, CANTOOLS, &mix, &frames)?;
            let origin = format!("arm-none-eabi-gcc {gcc}, each C file by itself.\n\n");
            let text = origin + &table(CANTOOLS, &c, signals(&mix));
            pages.push(Block { marker: "codecs of cantools", text });
        }
        None => left_out = Some("cantools' C: no arm-none-eabi-gcc, `apt-get install gcc-arm-none-eabi`"),
    }
    for page in &pages {
        say!("{}", page.text)?;
    }
    print_throughput(&mix, &frames)?;
    check_targets(&programs, &rust)?;
    quote(&pages, options.check)?;
    Ok(left_out.map_or(Outcome::Done, |reason| Outcome::Partly(reason.into())))
}

fn signals(mix: &[Message]) -> usize {
    mix.iter().map(|message| message.signals.len()).sum()
}

/// Returns the messages of the mix with the rows of their bound signals.
fn messages(programs: &Programs) -> Result<Vec<Message>> {
    let mut mix = Vec::new();
    for (name, signals) in programs::mix(&programs.read(LEVELS[0], OURS)?)? {
        let info = info(&name)?;
        let signals =
            signals.iter().map(|signal| info.signal(signal).context("a bound signal is in the DBC"));
        mix.push(Message { signals: signals.collect::<Result<_>>()?, name });
    }
    Ok(mix)
}

fn info(name: &str) -> Result<&'static MessageInfo> {
    citybus::MESSAGES
        .iter()
        .find(|info| info.name == name)
        .with_context(|| format!("the bus has no message {name}"))
}

/// Returns the same pseudo-random frames on every machine, [`FRAMES`] of each message.
fn frames(mix: &[Message]) -> Vec<Vec<[u8; 8]>> {
    let mut state = 0x2545_F491_4F6C_DD1D_u64;
    // xorshift64: Marsaglia, Xorshift RNGs, 2003.
    let mut frame = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state.to_le_bytes()
    };
    mix.iter().map(|_| (0..FRAMES).map(|_| frame()).collect()).collect()
}

fn measure_all(
    programs: &Programs,
    candidates: &[Candidate],
    mix: &[Message],
    frames: &[Vec<[u8; 8]>],
) -> Result<Vec<[Measured; 2]>> {
    let measured = |candidate: &Candidate| -> Result<[Measured; 2]> {
        let at = |level: Level| {
            let elf = programs.read(level, candidate.program)?;
            let bytes = programs.size(level, candidate.program)?;
            let failed = || format!("{} at opt-level {}", candidate.what, level.name);
            measure(&elf, bytes, candidate.kind, mix, frames).with_context(failed)
        };
        Ok([at(LEVELS[0])?, at(LEVELS[1])?])
    };
    candidates.iter().map(measured).collect()
}

fn measure(elf: &[u8], bytes: u64, kind: Kind, mix: &[Message], frames: &[Vec<[u8; 8]>]) -> Result<Measured> {
    let mut core = Core::load(elf)?;
    let mut measured = Measured { messages: Vec::new(), cycles: 0.0, bytes };
    for (index, (message, frames)) in mix.iter().zip(frames).enumerate() {
        let mut costs = Vec::with_capacity(frames.len());
        for data in frames {
            core.write(DATA, data)?;
            costs.push(match kind {
                Kind::Model => decode_into_model(&mut core, index as u8, data),
                _ => decode_values(&mut core, index as u32, message, data, kind),
            }?);
        }
        let instructions: u32 = costs.iter().map(|cost| cost.instructions).sum();
        let cycles: u32 = costs.iter().map(|cost| cost.cycles).sum();
        let most = costs.iter().map(|cost| cost.instructions).max().unwrap_or(0);
        measured.messages.push((f64::from(instructions) / frames.len() as f64, most));
        measured.cycles += f64::from(cycles) / (frames.len() * mix.len()) as f64;
    }
    Ok(measured)
}

fn decode_values(core: &mut Core, index: u32, message: &Message, data: &[u8; 8], kind: Kind) -> Result<Cost> {
    let function = core.entry(index)?;
    let cost = core.call(function, &[DATA, VALUES])?;
    for (place, signal) in message.signals.iter().enumerate() {
        let raw = signal.raw(data);
        let judged = kind == Kind::Judged && !signal.is_valid(raw);
        let expected = if judged { i64::from(INVALID) } else { signal.scale.counts(raw) };
        let got = core.word(VALUES + 4 * place as u32)? as i32;
        let name = signal.name;
        ensure!(i64::from(got) == expected, "{name} of {data:02X?} is {expected}, the program says {got}");
    }
    Ok(cost)
}

/// Runs the decoder on the core and on the PC: both must leave the same readings.
fn decode_into_model(core: &mut Core, index: u8, data: &[u8; 8]) -> Result<Cost> {
    let function = core.entry(0)?;
    let cost = core.call(function, &[u32::from(index), DATA, VALUES])?;
    let mut readings = Readings::new();
    (citybus::VEHICLE.decode)(index, data, &mut readings);
    for value in Value::ALL.iter().copied() {
        let Some((reading, _)) = readings.get(value) else { continue };
        let expected = match reading {
            Reading::Valid(number) => number,
            Reading::Invalid => protocol_core::model::INVALID,
        };
        // A slot is two words: the number and its source.
        let got = core.word(VALUES + 8 * value as u32)? as i32;
        ensure!(got == expected, "{} of {data:02X?} is {expected}, the program says {got}", value.path());
    }
    Ok(cost)
}

fn table(candidates: &[Candidate], measured: &[[Measured; 2]], signals: usize) -> String {
    let mut text = String::from(
        "| decoder | instructions per message | per signal | most | cycles per message | flash |\n\
         | --- | --- | --- | --- | --- | --- |\n",
    );
    for (candidate, [small, fast]) in candidates.iter().zip(measured) {
        let both = |figure: &dyn Fn(&Measured) -> String| format!("{}, {}", figure(small), figure(fast));
        let per_signal = |one: &Measured| one.mean() * one.messages.len() as f64 / signals as f64;
        let most = |one: &Measured| one.messages.iter().map(|(_, most)| *most).max().unwrap_or(0);
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            candidate.what,
            both(&|one| format!("{:.1}", one.mean())),
            both(&|one| format!("{:.1}", per_signal(one))),
            both(&|one| most(one).to_string()),
            both(&|one| format!("{:.1}", one.cycles)),
            both(&|one| format!("{} B", one.bytes)),
        );
    }
    text
}

fn rust_tables(programs: &Programs, mix: &[Message], measured: &[[Measured; 2]]) -> Result<String> {
    let mut text =
        format!("{}; {} messages with {} signals.\n\n", programs.origin()?, mix.len(), signals(mix));
    text.push_str(&table(CANDIDATES, measured, signals(mix)));
    text.push_str("\n| all three vehicles | flash |\n| --- | --- |\n");
    for (program, what) in SIZES {
        let [small, fast] = [programs.size(LEVELS[0], program)?, programs.size(LEVELS[1], program)?];
        let _ = writeln!(text, "| {what} | {small} B, {fast} B |");
    }
    text.push_str("\nBy message, mean instructions at opt-level s:\n\n| message | signals |");
    for candidate in CANDIDATES {
        let _ = write!(text, " {} |", candidate.program.replace('_', " "));
    }
    let _ = writeln!(text, "\n| --- | --- |{}", " --- |".repeat(CANDIDATES.len()));
    for (index, message) in mix.iter().enumerate() {
        let _ = write!(text, "| {} | {} |", message.name, message.signals.len());
        for [small, _] in measured {
            let _ = write!(text, " {:.1} |", small.messages[index].0);
        }
        text.push('\n');
    }
    Ok(text)
}

/// Prints how fast both decode on this PC, in one run.
fn print_throughput(mix: &[Message], frames: &[Vec<[u8; 8]>]) -> Result<()> {
    let mut text = String::new();
    for (message, frames) in mix.iter().zip(frames) {
        for data in frames {
            let _ = writeln!(text, "{} {:016x}", message.name, u64::from_be_bytes(*data));
        }
    }
    let path = crate::output_folder()?.join("codec-frames.txt");
    std::fs::write(&path, text)?;
    let (ours, theirs) = programs::throughput(&path)?;
    say!(
        "(this PC: ours {:.1} million frames per second, cantools {:.3} million: {:.0} times as many)\n",
        ours / 1e6,
        theirs / 1e6,
        ours / theirs
    )?;
    Ok(())
}

fn check_targets(programs: &Programs, measured: &[[Measured; 2]]) -> Result<()> {
    for (candidate, [small, _]) in CANDIDATES.iter().zip(measured).filter(|(one, _)| one.program == OURS) {
        let mean = small.mean();
        if mean > MOST_INSTRUCTIONS {
            bail!(
                "{}: {mean:.1} instructions per message, at most {MOST_INSTRUCTIONS} are asked for",
                candidate.what
            );
        }
    }
    for (program, what) in SIZES {
        let bytes = programs.size(LEVELS[0], program)?;
        if bytes > MOST_FLASH {
            bail!("{what}: {bytes} B of flash, at most {MOST_FLASH} are asked for");
        }
    }
    Ok(())
}

/// A part of the page between two markers.
struct Block {
    marker: &'static str,
    text: String,
}

fn quote(blocks: &[Block], check: bool) -> Result<()> {
    let path = workspace::root().join(PAGE);
    let mut page = std::fs::read_to_string(&path)?;
    for block in blocks {
        let (head, old, tail) = split(&page, block.marker)?;
        if old == block.text {
            continue;
        }
        let origin = |text: &str| text.lines().next().unwrap_or_default().to_owned();
        let (here, there) = (origin(&block.text), origin(old));
        if check && here == there {
            bail!("{PAGE} quotes other figures; `cargo xtask codecs` writes these into it");
        }
        if check {
            say!("only the targets are checked: {PAGE} is of `{there}`, this is `{here}`")?;
            continue;
        }
        page = format!("{head}{}{tail}", block.text);
    }
    if !check {
        std::fs::write(path, page)?;
        say!("{PAGE} is up to date")?;
    }
    Ok(())
}

/// Returns the page up to a block, the block's text, and the rest of the page.
fn split<'page>(page: &'page str, marker: &str) -> Result<(&'page str, &'page str, &'page str)> {
    let begin = format!("<!-- {marker}: cargo xtask codecs -->\n");
    let end = format!("<!-- /{marker} -->");
    let from = page.find(&begin).with_context(|| format!("{PAGE} has no block `{marker}`"))? + begin.len();
    let length =
        page[from..].find(&end).with_context(|| format!("the block `{marker}` of {PAGE} has no end"))?;
    Ok((&page[..from], &page[from..from + length], &page[from + length..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_is_what_stands_between_its_markers() -> Result<()> {
        let page = "# Page\n<!-- a: cargo xtask codecs -->\nold\n<!-- /a -->\nrest\n";
        let (head, old, tail) = split(page, "a")?;
        assert_eq!(old, "old\n");
        assert_eq!(format!("{head}{old}{tail}"), page);
        assert!(split(page, "b").is_err());
        Ok(())
    }

    #[test]
    fn frames_are_the_same_on_every_machine() {
        let mix = [
            Message { name: String::new(), signals: vec![] },
            Message { name: String::new(), signals: vec![] },
        ];
        assert_eq!(frames(&mix), frames(&mix));
        let first = frames(&mix);
        assert_ne!(first[0][0], first[1][0]);
    }
}
