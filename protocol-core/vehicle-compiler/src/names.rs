//! Rust names of DBC names: legal and different.
//!
//! A name that would be a word of the language or of the generated text gets a prefix, the second of two that would be one
//! a number. Tools and vehicle.toml know the names of the DBC only.

use crate::network::Message;
use std::collections::BTreeSet;

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
pub fn wrong_folder(name: &str) -> Option<&'static str> {
    let is_plain = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_';
    if !name.starts_with(|first: char| first.is_ascii_lowercase()) || !name.chars().all(is_plain) {
        return Some("a vehicle's folder is named with a to z, 0 to 9 and _, a letter first");
    }
    KEYWORDS.contains(&name).then_some("is a word of Rust and cannot name a vehicle's folder")
}

/// Returns whether a text can be the name of a message or a signal.
pub(crate) fn is_name(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
}

/// Gives each message and each signal of it a name in Rust that no other has: the second of two that would be one gets a
/// number behind it, and so on in the order of the file.
pub(crate) fn make_unique(messages: &mut [Message]) {
    let mut taken = BTreeSet::new();
    for message in messages {
        let (kind, function) = (type_name(&message.name), function_name(&message.name));
        let form = |number: usize| match number {
            1 => (kind.clone(), function.clone()),
            number => (format!("{kind}{number}"), format!("{function}_{number}")),
        };
        let names = |number: usize| vec![form(number).0, form(number).1];
        (message.type_name, message.function) = form(free(&mut taken, names));
        let mut taken = BTreeSet::new();
        for signal in &mut message.signals {
            let name = function_name(&signal.name);
            let form = |number: usize| if number == 1 { name.clone() } else { format!("{name}_{number}") };
            let methods = |number: usize| {
                vec![form(number), format!("{}_raw", form(number)), format!("with_{}_raw", form(number))]
            };
            signal.function = form(free(&mut taken, methods));
        }
    }
}

/// Takes the names of the first number from 1 of which none is taken.
fn free(taken: &mut BTreeSet<String>, names: impl Fn(usize) -> Vec<String>) -> usize {
    let is_free = |number: &usize| names(*number).iter().all(|name| !taken.contains(name));
    // As many numbers as names taken, and one more, always have a free one among them.
    let number = (1..=taken.len() + 1).find(is_free).unwrap_or(1);
    taken.extend(names(number));
    number
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
