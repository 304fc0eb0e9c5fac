//! Text out of the bytes of a file: UTF-8, or what to do about it.
//!
//! A byte-order mark is dropped. Anything else is an error with line and byte that shows how the line reads in the two
//! encodings that DBC files have (Windows-1252 from Vector's editors, GB18030 from Chinese ones): only a reader can
//! tell which is right, for almost every text of the one is valid in the other.

use crate::diagnostics::Diagnostics;
use encoding_rs::{Encoding, GB18030, WINDOWS_1252};

/// Longest part of a line that is shown.
const SHOWN: usize = 60;

/// Returns the text of `bytes`; `file` stands in the error.
///
/// # Errors
///
/// If they are not UTF-8: line, byte, and how to convert the file.
pub fn decode(file: &str, bytes: Vec<u8>) -> Result<String, Diagnostics> {
    if bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]) {
        let advice = format!("convert it: `iconv -f utf-16 -t utf-8 {file}`");
        return Err(Diagnostics::one(file, 1, format!("is UTF-16 text; {advice}")));
    }
    let wrong = match String::from_utf8(bytes) {
        Ok(mut text) => {
            if text.starts_with('\u{FEFF}') {
                text.drain(..'\u{FEFF}'.len_utf8());
            }
            return Ok(text);
        }
        Err(wrong) => wrong,
    };
    let at = wrong.utf8_error().valid_up_to();
    let bytes = wrong.as_bytes();
    let start = bytes[..at].iter().rposition(|&byte| byte == b'\n').map_or(0, |newline| newline + 1);
    let line = bytes[..at].iter().filter(|&&byte| byte == b'\n').count() + 1;
    let source = bytes[start..].split(|&byte| byte == b'\n').next().unwrap_or_default();
    let western = is_rather_western(bytes);
    let [first, second] = if western { [WINDOWS_1252, GB18030] } else { [GB18030, WINDOWS_1252] };
    let reading = |encoding: &'static Encoding| {
        let (text, _, _) = encoding.decode(source);
        let text = around(text.trim(), source.len());
        format!("{}: `{text}`", encoding.name())
    };
    let name = |encoding: &'static Encoding| encoding.name().to_lowercase();
    let text = format!(
        "byte 0x{:02X} is not UTF-8 text. The line reads {}; or {}. If the first is right: \
         `iconv -f {} -t utf-8 {file}`, if the second: `-f {}`",
        bytes[at],
        reading(first),
        reading(second),
        name(first),
        name(second),
    );
    Err(Diagnostics::one(file, line, text))
}

/// Whether single letters of another alphabet stand between ASCII (`°C`, `Länge`), and not pairs of bytes.
fn is_rather_western(bytes: &[u8]) -> bool {
    let runs = bytes.split(|byte| byte.is_ascii()).filter(|run| !run.is_empty());
    let (odd, even): (Vec<&[u8]>, Vec<&[u8]>) = runs.partition(|run| run.len() % 2 == 1);
    odd.len() > even.len()
}

/// Returns the part of a line around its first letter that is not ASCII.
fn around(line: &str, length: usize) -> String {
    if length <= SHOWN {
        return line.to_owned();
    }
    let first = line.chars().position(|letter| !letter.is_ascii()).unwrap_or(0);
    line.chars().skip(first.saturating_sub(SHOWN / 2)).take(SHOWN).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(bytes: &[u8]) -> String {
        decode("x.dbc", bytes.to_vec()).expect_err("not UTF-8").to_string()
    }

    #[test]
    fn a_degree_sign_of_windows_is_not_called_chinese() {
        assert_eq!(
            said(b"VERSION \"\"\n SG_ t : 0|8@1+ (1,-40) [-40|210] \"\xB0C\" A\n"),
            "x.dbc:2: byte 0xB0 is not UTF-8 text. The line reads windows-1252: `SG_ t : 0|8@1+ (1,-40) [-40|210] \"°C\" A`; \
             or gb18030: `SG_ t : 0|8@1+ (1,-40) [-40|210] \"癈\" A`. If the first is right: \
             `iconv -f windows-1252 -t utf-8 x.dbc`, if the second: `-f gb18030`"
        );
    }

    #[test]
    fn chinese_is_offered_first_where_bytes_come_in_pairs() {
        let (bytes, _, _) = GB18030.encode("CM_ \"电池系统 25°C\";\n");
        let said = said(&bytes);
        assert!(
            said.starts_with(
                "x.dbc:1: byte 0xB5 is not UTF-8 text. The line reads gb18030: `CM_ \"电池系统 25°C\";`"
            ),
            "{said}"
        );
        assert!(
            said.ends_with("`iconv -f gb18030 -t utf-8 x.dbc`, if the second: `-f windows-1252`"),
            "{said}"
        );
    }

    #[test]
    fn a_byte_order_mark_is_no_part_of_the_text() {
        assert_eq!(decode("x.dbc", b"\xEF\xBB\xBFVERSION \"\"\n".to_vec()), Ok("VERSION \"\"\n".into()));
        assert_eq!(
            said(b"\xFF\xFEV\0"),
            "x.dbc:1: is UTF-16 text; convert it: `iconv -f utf-16 -t utf-8 x.dbc`"
        );
    }
}
