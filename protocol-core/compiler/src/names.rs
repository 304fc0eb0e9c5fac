//! Rust names of DBC names: legal, and proved different before anything is generated.
//!
//! A name that would be a word of the language or of the generated text gets a prefix. Two names that become one are an
//! error with both lines: which of them to rename is for the author of the DBC to say.

use crate::diagnostics::Report;
use std::collections::BTreeMap;

/// Words that cannot be the name of a function: the keywords of all editions, strict and reserved, and `new`.
const KEYWORDS: [&str; 53] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn",
    "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop",
    "macro", "match", "mod", "move", "mut", "new", "override", "priv", "pub", "ref", "return", "self",
    "static", "struct", "super", "trait", "true", "try", "type", "typeof", "union", "unsafe", "unsized",
    "use", "virtual", "where", "while", "yield",
];

/// Types that the generated text uses under these names.
const TYPES: [&str; 35] = [
    "Bound",
    "CanId",
    "Cell",
    "Checksum",
    "ChecksumKind",
    "Clone",
    "Copy",
    "Debug",
    "Default",
    "Eq",
    "Err",
    "FaultText",
    "Got",
    "Life",
    "LifeKind",
    "MessageInfo",
    "Mux",
    "Node",
    "NodeName",
    "None",
    "Ok",
    "Option",
    "Order",
    "PartialEq",
    "Readings",
    "RxMessage",
    "Scale",
    "Self",
    "Severity",
    "SignalInfo",
    "Some",
    "Stream",
    "TxMessage",
    "Value",
    "Vehicle",
];

/// Returns the parts of a name: split at underscores and before the capital that begins a new word.
fn parts(name: &str) -> Vec<String> {
    let letters: Vec<char> = name.chars().collect();
    let mut parts = vec![String::new()];
    for (index, letter) in letters.iter().enumerate() {
        let small =
            |at: Option<usize>| at.and_then(|at| letters.get(at)).is_some_and(char::is_ascii_lowercase);
        let after_capital = index > 0 && letters[index - 1].is_ascii_uppercase();
        let begins = small(index.checked_sub(1)) || after_capital && small(Some(index + 1));
        if *letter == '_' || letter.is_ascii_uppercase() && begins {
            parts.push(String::new());
        }
        if *letter != '_'
            && let Some(part) = parts.last_mut()
        {
            part.push(letter.to_ascii_lowercase());
        }
    }
    parts.retain(|part| !part.is_empty());
    parts
}

/// Returns the name of a type: `BMS1` -> `Bms1`, `ChargerTx` -> `ChargerTx`.
pub(crate) fn type_name(name: &str) -> String {
    let capitalised = |part: &String| part[..1].to_uppercase() + &part[1..];
    let joined: String = parts(name).iter().map(capitalised).collect();
    match joined.starts_with(|first: char| first.is_ascii_alphabetic()) && !TYPES.contains(&joined.as_str()) {
        true => joined,
        false => format!("M{joined}"),
    }
}

/// Returns the name of a function: `Engine_Speed` -> `engine_speed`.
pub(crate) fn function_name(name: &str) -> String {
    let joined = parts(name).join("_");
    match joined.starts_with(|first: char| first.is_ascii_alphabetic())
        && !KEYWORDS.contains(&joined.as_str())
    {
        true => joined,
        false => format!("s_{joined}"),
    }
}

/// Returns why a folder cannot give a vehicle its name, `None` if it can: the name is that of a module.
pub(crate) fn wrong_folder(name: &str) -> Option<&'static str> {
    let is_plain = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_';
    if !name.starts_with(|first: char| first.is_ascii_lowercase()) || !name.chars().all(is_plain) {
        return Some("a vehicle's folder is named with a to z, 0 to 9 and _, a letter first");
    }
    KEYWORDS.contains(&name).then_some("is a word of Rust and cannot name a vehicle's folder")
}

/// A name of the DBC and its line.
#[derive(Clone, Copy)]
pub(crate) struct Named<'a> {
    pub(crate) name: &'a str,
    pub(crate) line: usize,
}

/// Reports each name that is another one's in Rust. `messages` are all messages with their signals.
pub(crate) fn report_collisions(messages: &[(Named<'_>, Vec<Named<'_>>)], report: &mut Report<'_>) {
    let rust = |name: &str| vec![type_name(name), function_name(name)];
    report_among("message", messages.iter().map(|(message, _)| *message), rust, report);
    for (_, signals) in messages {
        let methods = |name: &str| {
            let name = function_name(name);
            vec![name.clone(), format!("{name}_raw"), format!("with_{name}_raw")]
        };
        report_among("signal", signals.iter().copied(), methods, report);
    }
}

fn report_among<'a>(
    what: &str,
    names: impl Iterator<Item = Named<'a>>,
    rust: impl Fn(&str) -> Vec<String>,
    report: &mut Report<'_>,
) {
    let mut owners: BTreeMap<String, Named<'_>> = BTreeMap::new();
    for named in names {
        let Named { name, line } = named;
        for rust in rust(name) {
            let Some(first) = owners.insert(rust.clone(), named) else { continue };
            let text = if first.name == name {
                format!("{what} `{name}` is used before, in line {}", first.line)
            } else {
                let other = format!("`{}` in line {}", first.name, first.line);
                format!("{what} `{name}` and {other} are both `{rust}` in Rust: rename one of them")
            };
            report.line(line, text);
            break;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dbc_names_become_rust_names() {
        assert_eq!(type_name("BMS1"), "Bms1");
        assert_eq!(type_name("ChargerTx"), "ChargerTx");
        assert_eq!(type_name("VCU_Status_2"), "VcuStatus2");
        assert_eq!(type_name("VCUToBMS"), "VcuToBms");
        assert_eq!(function_name("BMSExtremePositions"), "bms_extreme_positions");
        assert_eq!(type_name("4in1"), "M4in1");
        assert_eq!(function_name("Engine_Speed"), "engine_speed");
        assert_eq!(function_name("type"), "s_type");
        assert_eq!(
            (type_name("self"), type_name("VALUE"), type_name("_")),
            ("MSelf".into(), "MValue".into(), "M".into())
        );
        assert_eq!(
            (function_name("In"), function_name("4wd"), function_name("__")),
            ("s_in".into(), "s_4wd".into(), "s_".into())
        );
    }

    #[test]
    fn a_folder_is_named_as_a_module_can_be() {
        assert_eq!(["citybus", "c5ev", "my_van_2"].map(wrong_folder), [None; 3]);
        assert!(["My-Car", "4wd", "mod", "车", "", "a.b"].iter().all(|name| wrong_folder(name).is_some()));
    }
}
