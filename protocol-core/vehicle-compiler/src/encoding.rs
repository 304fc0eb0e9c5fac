//! Text out of the bytes of a file: UTF-8, or the encoding that the bytes speak for.
//!
//! A byte-order mark is dropped, and one of UTF-16 believed. What is not UTF-8 is GB18030 (Chinese editors) or
//! Windows-1252 (Vector's): pairs of bytes that make Chinese letters speak for the one, single ones between ASCII (`°C`,
//! `Länge`) for the other. The choice is said in one line that shows how the first such line reads.

use crate::diagnostics::Diagnostics;
use encoding_rs::{Encoding, GB18030, UTF_8, WINDOWS_1252};

/// Longest part of a line that is shown.
const SHOWN: usize = 60;

/// A text, and what to say about how it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Read {
    /// The text, without a byte-order mark.
    pub text: String,
    /// Set if the bytes are not UTF-8: which encoding was taken, and how a line reads in it.
    pub note: Option<String>,
}

/// Returns the text of `bytes`, whatever its encoding; `file` stands in the error.
///
/// # Errors
///
/// If the bytes are no text at all.
pub fn read(file: &str, bytes: Vec<u8>) -> Result<Read, Diagnostics> {
    let marked =
        Encoding::for_bom(&bytes).map(|(encoding, _)| encoding).filter(|encoding| *encoding != UTF_8);
    if let Some(encoding) = marked {
        let (text, _, wrong) = encoding.decode(&bytes);
        if wrong {
            return Err(Diagnostics::one(
                file,
                1,
                format!("is not the {} that its first bytes say", encoding.name()),
            ));
        }
        return Ok(Read { text: text.into_owned(), note: Some(format!("read as {}", encoding.name())) });
    }
    let wrong = match String::from_utf8(bytes) {
        Ok(mut text) => {
            if text.starts_with('\u{FEFF}') {
                text.drain(..'\u{FEFF}'.len_utf8());
            }
            return Ok(Read { text, note: None });
        }
        Err(wrong) => wrong,
    };
    let at = wrong.utf8_error().valid_up_to();
    let bytes = wrong.as_bytes();
    let encoding = if is_rather_chinese(bytes) { GB18030 } else { WINDOWS_1252 };
    let line = bytes[..at].iter().filter(|&&byte| byte == b'\n').count() + 1;
    let (text, _, _) = encoding.decode(bytes);
    let source = text.lines().nth(line - 1).unwrap_or_default().trim();
    let name = encoding.name().to_lowercase();
    let note = format!("is not UTF-8; read as {name}: line {line} is `{}`", around(source));
    Ok(Read { text: text.into_owned(), note: Some(note) })
}

/// Returns the text of `bytes`, for a file that has to be UTF-8.
///
/// # Errors
///
/// If it is not: line, and how it reads in the encoding that it seems to have.
pub fn decode(file: &str, bytes: Vec<u8>) -> Result<String, Diagnostics> {
    let line = std::str::from_utf8(&bytes)
        .err()
        .map_or(1, |error| bytes[..error.valid_up_to()].iter().filter(|&&byte| byte == b'\n').count() + 1);
    match read(file, bytes)? {
        Read { text, note: None } => Ok(text),
        Read { note: Some(note), .. } => Err(Diagnostics::one(
            file,
            line,
            format!("{note}; `cargo xtask dbc --fix {file}` writes it as UTF-8"),
        )),
    }
}

/// Whether the bytes above ASCII make letters of Chinese in pairs, all of them, and more than single western letters would.
fn is_rather_chinese(bytes: &[u8]) -> bool {
    let Some(text) = GB18030.decode_without_bom_handling_and_without_replacement(bytes) else { return false };
    let runs = bytes.split(|byte| byte.is_ascii()).filter(|run| !run.is_empty());
    let (odd, even): (Vec<&[u8]>, Vec<&[u8]>) = runs.partition(|run| run.len() % 2 == 1);
    let is_usual = |letter: &char| matches!(letter, '\u{4E00}'..='\u{9FA5}' | '\u{3000}'..='\u{303F}' | '\u{FF00}'..='\u{FFEF}');
    let foreign: Vec<char> = text.chars().filter(|letter| !letter.is_ascii()).collect();
    let usual = foreign.iter().filter(|letter| is_usual(letter)).count();
    even.len() > odd.len() && 2 * usual > foreign.len()
}

/// Returns the part of a line around its first letter that is not ASCII.
fn around(line: &str) -> String {
    let first = line.chars().position(|letter| !letter.is_ascii()).unwrap_or(0);
    let from = if line.chars().count() <= SHOWN { 0 } else { first.saturating_sub(SHOWN / 2) };
    line.chars().skip(from).take(SHOWN).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(bytes: &[u8]) -> (String, String) {
        let read = read("x.dbc", bytes.to_vec()).expect("a text");
        (read.text, read.note.unwrap_or_default())
    }

    #[test]
    fn a_degree_sign_of_windows_is_not_taken_for_chinese() {
        let (text, note) = of(b"VERSION \"\"\n SG_ t : 0|8@1+ (1,-40) [-40|210] \"\xB0C\" A\n");
        assert!(text.contains("\"°C\""), "{text}");
        assert_eq!(
            note,
            "is not UTF-8; read as windows-1252: line 2 is `SG_ t : 0|8@1+ (1,-40) [-40|210] \"°C\" A`"
        );
        // Two western letters side by side are no pair of Chinese ones where single ones stand too.
        assert!(of(b"CM_ \"gr\xF6\xDFer als 5 \xB0C, L\xE4nge\";").1.contains("windows-1252"));
    }

    #[test]
    fn chinese_is_told_by_its_pairs() {
        let text = "CM_ \"电池系统 25°C\";\nCM_ \"充电电流，单位\";";
        let (bytes, _, _) = GB18030.encode(text);
        let (read, note) = of(&bytes);
        assert_eq!(read, text);
        assert!(note.starts_with("is not UTF-8; read as gb18030: line 1 is `CM_ \"电池系统"), "{note}");
    }

    #[test]
    fn a_byte_order_mark_is_no_part_of_the_text() {
        let plain = |text: &str| Read { text: text.into(), note: None };
        assert_eq!(read("x.dbc", b"\xEF\xBB\xBFVERSION \"\"\n".to_vec()), Ok(plain("VERSION \"\"\n")));
        assert_eq!(of(b"\xFF\xFEV\0"), ("V".into(), "read as UTF-16LE".into()));
    }

    #[test]
    fn a_file_that_must_be_utf8_is_told_what_it_seems_to_be() {
        let said = decode("x.toml", b"a\nb \xB0C\n".to_vec()).expect_err("not UTF-8").to_string();
        assert!(said.starts_with("x.toml:2: is not UTF-8; read as windows-1252: line 2 is `b °C`"), "{said}");
    }
}
