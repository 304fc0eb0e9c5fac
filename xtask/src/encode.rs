//! Turns a message and its values into a frame for `cansend`.
//!
//! Values are exact decimals, words of the value table or raw values. Refuses to round: a value between two raw values
//! or out of range is an error that says which values are nearest. What is not given has its start value.

use crate::out::say;
use crate::vehicles::{Tables, value_of, with_unit};
use anyhow::{Result, bail};
use clap::Args;
use protocol_core::codec::{MessageInfo, Mux, SignalInfo};
use vehicle_compiler::did_you_mean;

/// Which frame to make.
#[derive(Args, Debug)]
pub struct Options {
    /// Name of the message in the DBC, or its identifier in hexadecimal.
    message: String,
    /// Values as `signal=48.5`, `signal=word` or `signal=raw:0x1F`.
    #[arg(value_name = "SIGNAL=VALUE")]
    values: Vec<String>,
    /// Vehicle whose message it is; needed only if several have one of that name.
    #[arg(long)]
    vehicle: Option<String>,
}

/// Prints the frame as `cansend` takes it.
///
/// # Errors
/// If the message or a signal is not known, or a value cannot be sent; all wrong values are named at once.
pub fn run(options: &Options) -> Result<()> {
    let message = find(&options.message, options.vehicle.as_deref(), &options.values)?;
    let data = frame(message, &options.values)?;
    let bytes: String = data.iter().take(message.len.into()).map(|byte| format!("{byte:02X}")).collect();
    say!("{}#{bytes}", message.id)?;
    Ok(())
}

/// Returns the message of a name; of several, the one that has all the signals.
fn find(name: &str, vehicle: Option<&str>, values: &[String]) -> Result<&'static MessageInfo> {
    let tables: Vec<Tables> = match vehicle {
        Some(vehicle) => vec![Tables::named(vehicle)?],
        None => Tables::all().collect(),
    };
    let fits =
        |message: &MessageInfo| message.name == name || message.id.to_string().eq_ignore_ascii_case(name);
    let found: Vec<(&str, &'static MessageInfo)> = tables
        .iter()
        .flat_map(|tables| tables.messages.iter().map(|message| (tables.vehicle.name, message)))
        .filter(|(_, message)| fits(message))
        .collect();
    let has_all = |message: &MessageInfo| {
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
            let names = tables.iter().flat_map(|tables| tables.messages.iter().map(|message| message.name));
            let near = did_you_mean(name, names);
            bail!("no message is called `{name}`{near}")
        }
        _ => {
            let vehicles: Vec<&str> = found.iter().map(|(vehicle, _)| *vehicle).collect();
            bail!("`{name}` is a message of {}; say which with --vehicle", vehicles.join(" and "))
        }
    }
}

/// Returns a frame with start values, then the given ones.
fn frame(message: &MessageInfo, assignments: &[String]) -> Result<[u8; 8]> {
    let mut wrong = Vec::new();
    let mut given: Vec<(usize, i64)> = Vec::new();
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
    let set = |data, index, raw| (message.set)(index, data, raw);
    let mut data = given.iter().fold(message.start_frame(), |data, &(index, raw)| set(data, index, raw));
    for (index, signal) in message.signals.iter().enumerate() {
        let is_given = given.iter().any(|(other, _)| *other == index);
        if matches!(signal.mux, Mux::When(_)) && !is_given && message.carries(signal, &data) {
            data = set(data, index, signal.start_raw);
        }
    }
    Ok(data)
}

/// Sets the multiplexer as the given multiplexed signals need it.
fn select(message: &MessageInfo, given: &mut Vec<(usize, i64)>) -> Result<()> {
    let Some(selector) = message.signals.iter().position(|signal| signal.mux == Mux::Selector) else {
        return Ok(());
    };
    let name = message.signals[selector].name;
    for (index, _) in given.clone() {
        let Mux::When(needed) = message.signals[index].mux else { continue };
        let needed = i64::from(needed);
        match given.iter().find(|(other, _)| *other == selector) {
            None => given.push((selector, needed)),
            Some((_, raw)) if *raw == needed => {}
            Some((_, raw)) => {
                let signal = message.signals[index].name;
                bail!("`{signal}` is sent only while `{name}` is raw:{needed}, here it is raw:{raw}")
            }
        }
    }
    Ok(())
}

fn read(message: &MessageInfo, assignment: &str) -> Result<(usize, i64), String> {
    let Some((name, text)) = assignment.split_once('=') else {
        return Err(format!("`{assignment}` is not SIGNAL=VALUE"));
    };
    let (name, text) = (name.trim(), text.trim());
    let Some(index) = message.signals.iter().position(|signal| signal.name == name) else {
        let near = did_you_mean(name, message.signals.iter().map(|signal| signal.name));
        return Err(format!("`{}` has no signal `{name}`{near}", message.name));
    };
    raw_of(&message.signals[index], text).map(|raw| (index, raw))
}

/// Returns the raw value that `text` means.
fn raw_of(signal: &SignalInfo, text: &str) -> Result<i64, String> {
    let name = signal.name;
    if let Some(raw) = text.strip_prefix("raw:") {
        let number = match raw.strip_prefix("0x").or_else(|| raw.strip_prefix("0X")) {
            Some(digits) => i64::from_str_radix(digits, 16),
            None => raw.parse(),
        };
        let (lowest, highest) = span(signal);
        return match number {
            Ok(number) if (lowest..=highest).contains(&number) => Ok(number),
            Ok(_) => {
                Err(format!("`{name}` has {} bits: raw {lowest} to {highest}, not {raw}", signal.length))
            }
            Err(_) => Err(format!("`{name}`: `{raw}` is not a whole number, decimal or 0x")),
        };
    }
    let number = text.strip_suffix(signal.unit).unwrap_or(text).trim_end();
    if let Some((number, decimals)) = exact(number) {
        return on_grid(signal, number, decimals);
    }
    let word = signal.values.iter().find(|(_, word)| word.eq_ignore_ascii_case(text));
    word.map(|(raw, _)| *raw).ok_or_else(|| {
        let near = did_you_mean(text, signal.values.iter().map(|(_, word)| *word));
        let words: Vec<&str> = signal.values.iter().map(|(_, word)| *word).collect();
        let words =
            if words.is_empty() { String::new() } else { format!(", one of `{}`", words.join("`, `")) };
        format!("`{name}`: `{text}` is neither a number{words} nor raw:N{near}")
    })
}

/// Returns lowest and highest raw value that the bits hold.
fn span(signal: &SignalInfo) -> (i64, i64) {
    let values = 1_i64 << signal.length.min(32);
    if signal.signed { (-values / 2, values / 2 - 1) } else { (0, values - 1) }
}

/// Reads a decimal as a whole number and how many of its digits stand behind the point.
fn exact(text: &str) -> Option<(i128, u32)> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = format!("{whole}{fraction}");
    let bare = digits.strip_prefix(['-', '+']).unwrap_or(&digits);
    let is_number = !bare.is_empty() && bare.len() <= 18 && bare.bytes().all(|byte| byte.is_ascii_digit());
    Some((is_number.then(|| digits.parse().ok())??, fraction.len() as u32))
}

/// Returns the valid raw value of exactly `number / 10^decimals`.
fn on_grid(signal: &SignalInfo, number: i128, decimals: u32) -> Result<i64, String> {
    let scale = signal.scale;
    let ten = 10_i128.pow(decimals);
    // raw = (value * den - add) / mul
    let numerator = number * i128::from(scale.den) - i128::from(scale.add) * ten;
    let denominator = i128::from(scale.mul) * ten;
    let (numerator, denominator) = (numerator * denominator.signum(), denominator.abs());
    let below = numerator.div_euclid(denominator);
    let is_exact = numerator.rem_euclid(denominator) == 0;
    let (low, high) = (i128::from(signal.range.0), i128::from(signal.range.1));
    let valid = |raw: i128| i64::try_from(raw).ok().filter(|&raw| signal.is_valid(raw));
    if let Some(raw) = valid(below).filter(|_| is_exact) {
        return Ok(raw);
    }
    // A "not available" pattern inside the range leaves a hole of one.
    let down = [below, below - 1].into_iter().find_map(|raw| valid(raw.min(high)));
    let up = [below + 1, below + 2].into_iter().find_map(|raw| valid(raw.max(low)));
    let mut near: Vec<i64> = down.into_iter().chain(up).collect();
    near.dedup();
    near.sort_by_key(|&raw| signal.scale.counts(raw));
    let near: Vec<String> = near.into_iter().map(|raw| value_of(signal, raw)).collect();
    let near = format!("nearest valid: {}", with_unit(&near.join(" and "), signal.unit));
    let mut limits = [signal.range.0, signal.range.1];
    limits.sort_by_key(|&raw| signal.scale.counts(raw));
    let [least, most] = limits.map(|raw| value_of(signal, raw));
    let name = signal.name;
    if (low..high).contains(&below) && !is_exact {
        let step = crate::vehicles::decimal(i64::from(scale.mul.abs()), scale.den);
        return Err(format!("`{name}` goes in steps of {}; {near}", with_unit(&step, signal.unit)));
    }
    Err(format!("`{name}` is valid from {least} to {}; {near}", with_unit(&most, signal.unit)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use protocol_core::codec::{Order, Scale};

    const SPEED: SignalInfo = SignalInfo {
        name: "speed",
        start: 0,
        length: 16,
        order: Order::Intel,
        signed: false,
        scale: Scale { mul: 1, add: 0, den: 256 },
        unit: "km/h",
        range: (0, 51_200),
        start_raw: 0,
        invalid_raw: Some(0xFFFF),
        mux: Mux::Always,
        life: None,
        values: &[(0xFFFE, "error")],
    };

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
            assert_eq!(raw_of(&SPEED, text), Ok(raw), "{text}");
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
            assert_eq!(raw_of(&SPEED, text), Err(problem.into()), "{text}");
        }
    }

    #[test]
    fn a_negative_factor_keeps_the_order_of_the_limits() {
        let falling =
            SignalInfo { scale: Scale { mul: -2, add: 10, den: 1 }, range: (0, 10), values: &[], ..SPEED };
        assert_eq!(raw_of(&falling, "10"), Ok(0));
        assert_eq!(raw_of(&falling, "-10"), Ok(10));
        let between = raw_of(&falling, "1").unwrap_err();
        assert_eq!(between, "`speed` goes in steps of 2 km/h; nearest valid: 0 and 2 km/h");
        let beyond = raw_of(&falling, "12").unwrap_err();
        assert_eq!(beyond, "`speed` is valid from -10 to 10 km/h; nearest valid: 10 km/h");
    }

    #[test]
    fn a_hole_in_the_range_is_stepped_over() {
        let holed = SignalInfo { scale: Scale { mul: 1, add: 0, den: 1 }, invalid_raw: Some(5), ..SPEED };
        let hole = raw_of(&holed, "5").unwrap_err();
        assert_eq!(hole, "`speed` is valid from 0 to 51200 km/h; nearest valid: 4 and 6 km/h");
    }
}
