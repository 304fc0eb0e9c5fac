//! Rust names of DBC names.

/// Words that cannot be the name of a function.
const RESERVED: [&str; 12] =
    ["box", "const", "continue", "fill", "loop", "match", "mod", "move", "new", "ref", "static", "type"];

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
    if joined.starts_with(|first: char| first.is_ascii_digit()) { format!("M{joined}") } else { joined }
}

/// Returns the name of a function: `Engine_Speed` -> `engine_speed`.
pub(crate) fn function_name(name: &str) -> String {
    let joined = parts(name).join("_");
    if RESERVED.contains(&joined.as_str()) || joined.starts_with(|first: char| first.is_ascii_digit()) {
        format!("s_{joined}")
    } else {
        joined
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
    }
}
