//! Turns a message and its values into a frame for `cansend`.
//!
//! Values are exact decimals, words of the value table or raw values. Refuses to round: a value between two raw values
//! or out of range is an error that says which values are nearest. What is not given has its start value.

use crate::known;
use crate::out::say;
use crate::vehicles::with_unit;
use anyhow::{Result, bail};
use clap::Args;
use protocol_core::CanId;
use vehicle_compiler::network::{Message, Signal};
use vehicle_compiler::{RunTime, did_you_mean};

/// Which frame to make.
#[derive(Args, Debug)]
pub struct Options {
    /// Name of the message in the DBC, or its identifier in hexadecimal.
    message: String,
    /// Values as `signal=48.5`, `signal=word` or `signal=raw:0x1F`.
    #[arg(value_name = "SIGNAL=VALUE")]
    values: Vec<String>,
    #[command(flatten)]
    source: known::Source,
}

/// Prints the frame as `cansend` takes it.
///
/// # Errors
/// If the message or a signal is not known, or a value cannot be sent; all wrong values are named at once.
pub fn run(options: &Options) -> Result<()> {
    let message = find(&options.message, options.source.wanted()?, &options.values)?;
    let data = frame(message, &options.values)?;
    let bytes: String = data.iter().take(message.len.into()).map(|byte| format!("{byte:02X}")).collect();
    say!("{}#{bytes}", CanId::from_packed(message.id))?;
    Ok(())
}

/// Returns the message of a name; of several, the one that has all the signals.
fn find(name: &str, wanted: Option<&'static RunTime>, values: &[String]) -> Result<&'static Message> {
    let tables = wanted.map_or_else(known::all, |wanted| vec![wanted]);
    let id = |message: &Message| CanId::from_packed(message.id).to_string();
    let fits = |message: &Message| message.name == name || id(message).eq_ignore_ascii_case(name);
    let found: Vec<(&str, &'static Message)> = tables
        .iter()
        .flat_map(|known| known.network.messages.iter().map(|message| (known.name.as_str(), message)))
        .filter(|(_, message)| fits(message) && message.doubt.is_none())
        .collect();
    let has_all = |message: &Message| {
        let mut names = values.iter().map(|value| value.split('=').next().unwrap_or_default().trim());
        names.all(|name| message.signal(name).is_some())
    };
    let mut fitting = found.iter().filter(|(_, message)| has_all(message));
    if let (Some((_, message)), None) = (fitting.next(), fitting.next()) {
        return Ok(message);
    }
    match found[..] {
        [(_, message)] => Ok(message),
        [] => {
            let names = tables.iter().flat_map(|known| known.network.messages.iter());
            let near = did_you_mean(name, names.map(|message| message.name.as_str()));
            bail!("no message is called `{name}`{near}")
        }
        _ => {
            let vehicles: Vec<&str> = found.iter().map(|(vehicle, _)| *vehicle).collect();
            bail!("`{name}` is a message of {}; say which with --vehicle", vehicles.join(" and "))
        }
    }
}

/// Returns a frame with start values, then the given ones.
fn frame(message: &Message, assignments: &[String]) -> Result<[u8; 8]> {
    let mut wrong = Vec::new();
    let mut given: Vec<(usize, i128)> = Vec::new();
    for assignment in assignments {
        match read(message, assignment) {
            Ok((index, _)) if given.iter().any(|(other, _)| *other == index) => {
                wrong.push(format!("`{}` is given twice", message.signals[index].name));
            }
            Ok(value) => given.push(value),
            Err(problem) => wrong.push(problem),
        }
    }
    if !wrong.is_empty() {
        bail!("{}", wrong.join("\n       "));
    }
    select(message, &mut given)?;
    let mut data = message.start_frame();
    for &(index, raw) in &given {
        message.signals[index].set_raw(&mut data, raw);
    }
    for (index, signal) in message.signals.iter().enumerate() {
        let is_given = given.iter().any(|(other, _)| *other == index);
        if !signal.when.is_empty() && !is_given && message.carries(index, &data) {
            signal.set_raw(&mut data, signal.start_raw());
        }
    }
    Ok(data)
}

/// Sets the multiplexers as the given multiplexed signals need them.
fn select(message: &Message, given: &mut Vec<(usize, i128)>) -> Result<()> {
    for (index, _) in given.clone() {
        for condition in &message.signals[index].when {
            let needed = condition.ranges.first().map_or(0, |(first, _)| *first);
            match given.iter().find(|(other, _)| *other == condition.selector) {
                None => given.push((condition.selector, needed)),
                Some((_, raw)) if condition.holds(*raw) => {}
                Some((_, raw)) => {
                    let (signal, name) =
                        (&message.signals[index].name, &message.signals[condition.selector].name);
                    bail!("`{signal}` is sent only while `{name}` is raw:{needed}, here it is raw:{raw}")
                }
            }
        }
    }
    Ok(())
}

fn read(message: &Message, assignment: &str) -> Result<(usize, i128), String> {
    let Some((name, text)) = assignment.split_once('=') else {
        return Err(format!("`{assignment}` is not SIGNAL=VALUE"));
    };
    let (name, text) = (name.trim(), text.trim());
    let Some(index) = message.signal(name) else {
        let near = did_you_mean(name, message.signals.iter().map(|signal| signal.name.as_str()));
        return Err(format!("`{}` has no signal `{name}`{near}", message.name));
    };
    raw_of(&message.signals[index], text).map(|raw| (index, raw))
}

/// Returns the raw value that `text` means.
fn raw_of(signal: &Signal, text: &str) -> Result<i128, String> {
    let name = &signal.name;
    if let Some(raw) = text.strip_prefix("raw:") {
        let number = match raw.strip_prefix("0x").or_else(|| raw.strip_prefix("0X")) {
            Some(digits) => i128::from_str_radix(digits, 16),
            None => raw.parse(),
        };
        let (lowest, highest) = signal.span();
        return match number {
            Ok(number) if (lowest..=highest).contains(&number) => Ok(number),
            Ok(_) => {
                Err(format!("`{name}` has {} bits: raw {lowest} to {highest}, not {raw}", signal.length))
            }
            Err(_) => Err(format!("`{name}`: `{raw}` is not a whole number, decimal or 0x")),
        };
    }
    let number = text.strip_suffix(signal.unit.as_str()).unwrap_or(text).trim_end();
    if let Some((number, decimals)) = exact(number) {
        return on_grid(signal, number, decimals);
    }
    let word = signal.values.iter().find(|(_, word)| word.eq_ignore_ascii_case(text));
    word.map(|(raw, _)| i128::from(*raw)).ok_or_else(|| {
        let near = did_you_mean(text, signal.values.iter().map(|(_, word)| word.as_str()));
        let words: Vec<&str> = signal.values.iter().map(|(_, word)| word.as_str()).collect();
        let words =
            if words.is_empty() { String::new() } else { format!(", one of `{}`", words.join("`, `")) };
        format!("`{name}`: `{text}` is neither a number{words} nor raw:N{near}")
    })
}

/// Reads a decimal as a whole number and how many of its digits stand behind the point.
fn exact(text: &str) -> Option<(i128, u32)> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = format!("{whole}{fraction}");
    let bare = digits.strip_prefix(['-', '+']).unwrap_or(&digits);
    let is_number = !bare.is_empty() && bare.len() <= 18 && bare.bytes().all(|byte| byte.is_ascii_digit());
    Some((is_number.then(|| digits.parse().ok())??, fraction.len() as u32))
}

/// Returns the valid raw value of exactly `number / 10^decimals`; of a float the nearest.
fn on_grid(signal: &Signal, number: i128, decimals: u32) -> Result<i128, String> {
    let name = &signal.name;
    let Some((below, is_exact)) = signal.raw_of(number, decimals) else {
        return Err(format!("`{name}` has no raw value for this number: give raw:N"));
    };
    if is_exact && signal.is_valid(below) {
        return Ok(below);
    }
    if signal.number.is_float() {
        return Err(format!("`{name}` is not valid at {}", signal.value(below)));
    }
    let (low, high) = signal.range();
    let valid = |raw: i128| Some(raw).filter(|&raw| signal.is_valid(raw));
    // A "not available" pattern inside the range leaves a hole of one.
    let down = [below, below - 1].into_iter().find_map(|raw| valid(raw.min(high)));
    let up = [below + 1, below + 2].into_iter().find_map(|raw| valid(raw.max(low)));
    let mut near: Vec<i128> = down.into_iter().chain(up).collect();
    near.dedup();
    let mut limits = vec![low, high];
    if signal.is_falling() {
        near.reverse();
        limits.reverse();
    }
    let shown = |raws: &[i128]| raws.iter().map(|&raw| signal.value(raw)).collect::<Vec<String>>();
    let near = format!("nearest valid: {}", with_unit(&shown(&near).join(" and "), &signal.unit));
    if (low..high).contains(&below) && !is_exact {
        return Err(format!("`{name}` goes in steps of {}; {near}", with_unit(&signal.step(), &signal.unit)));
    }
    let limits = shown(&limits).join(" to ");
    Err(format!("`{name}` is valid from {}; {near}", with_unit(&limits, &signal.unit)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns a signal of this form and range.
    fn signal(form: &str, extra: &str) -> &'static Signal {
        let text = format!(
            "VERSION \"\"\nNS_ :\nBS_:\nBU_: A\nBO_ 1 M: 8 A\n SG_ speed : {form} \"km/h\" A\n{extra}\n"
        );
        let read = RunTime::of_texts("x", ("x.dbc", &text), None).expect("a DBC");
        &Box::leak(Box::new(read)).network.messages[0].signals[0]
    }

    fn speed() -> &'static Signal {
        let invalid = "BA_ \"SigInvalidRaw\" SG_ 1 speed 65535;\nVAL_ 1 speed 65534 \"error\" ;";
        signal("0|16@1+ (0.00390625,0) [0|200]", invalid)
    }

    #[test]
    fn decimals_words_and_raw_values_are_taken_exactly() {
        for (text, raw) in [
            ("48.5", 12_416),
            ("48.5 km/h", 12_416),
            ("200", 51_200),
            ("0.00390625", 1),
            ("ERROR", 0xFFFE),
            ("raw:65535", 65_535),
            ("raw:0x1F", 31),
        ] {
            assert_eq!(raw_of(speed(), text), Ok(raw), "{text}");
        }
    }

    #[test]
    fn what_cannot_be_sent_is_refused_with_the_nearest_valid_values() {
        for (text, problem) in [
            ("48.501", "`speed` goes in steps of 0.00390625 km/h; nearest valid: 48.5 and 48.50390625 km/h"),
            ("200.001", "`speed` is valid from 0 to 200 km/h; nearest valid: 200 km/h"),
            ("-1", "`speed` is valid from 0 to 200 km/h; nearest valid: 0 km/h"),
            ("raw:65536", "`speed` has 16 bits: raw 0 to 65535, not 65536"),
            ("raw:x", "`speed`: `x` is not a whole number, decimal or 0x"),
            ("eror", "`speed`: `eror` is neither a number, one of `error` nor raw:N; did you mean `error`?"),
        ] {
            assert_eq!(raw_of(speed(), text), Err(problem.into()), "{text}");
        }
    }

    #[test]
    fn a_negative_factor_keeps_the_order_of_the_limits() {
        let falling = signal("0|16@1+ (-2,10) [-10|10]", "");
        assert_eq!(raw_of(falling, "10"), Ok(0));
        assert_eq!(raw_of(falling, "-10"), Ok(10));
        let between = raw_of(falling, "1").unwrap_err();
        assert_eq!(between, "`speed` goes in steps of 2 km/h; nearest valid: 0 and 2 km/h");
        let beyond = raw_of(falling, "12").unwrap_err();
        assert_eq!(beyond, "`speed` is valid from -10 to 10 km/h; nearest valid: 10 km/h");
    }

    #[test]
    fn a_hole_in_the_range_is_stepped_over() {
        let holed = signal("0|16@1+ (1,0) [0|51200]", "BA_ \"SigInvalidRaw\" SG_ 1 speed 5;");
        let hole = raw_of(holed, "5").unwrap_err();
        assert_eq!(hole, "`speed` is valid from 0 to 51200 km/h; nearest valid: 4 and 6 km/h");
    }
}
