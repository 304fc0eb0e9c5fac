//! Text from files and links made harmless for a terminal.
//!
//! Owns the one rule for it: every control character and every mark that turns the direction of writing becomes an escape
//! that can be read, `\u{1b}`.

use std::borrow::Cow;

/// Returns text with everything that a terminal would obey as an escape, ends of lines and tabs too.
pub fn printable(text: &str) -> Cow<'_, str> {
    escaped(text, is_obeyed)
}

/// Returns text of whole lines with everything that a terminal would obey as an escape; lines and tabs stay.
pub fn printable_lines(text: &str) -> Cow<'_, str> {
    escaped(text, |sign| is_obeyed(sign) && !matches!(sign, '\n' | '\t'))
}

fn is_obeyed(sign: char) -> bool {
    sign.is_control()
        || matches!(sign, '\u{200E}' | '\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}')
}

fn escaped(text: &str, is_obeyed: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.chars().any(&is_obeyed) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for sign in text.chars() {
        if is_obeyed(sign) { shown.extend(sign.escape_default()) } else { shown.push(sign) }
    }
    Cow::Owned(shown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_obeys_is_escaped_and_the_rest_stays() {
        assert_eq!(
            printable("a\u{1b}[2J\u{9b}2J\u{7f}\r\n°温\u{202e}"),
            "a\\u{1b}[2J\\u{9b}2J\\u{7f}\\r\\n°温\\u{202e}"
        );
        assert_eq!(printable_lines("a\tb\n\u{7}c\r\n"), "a\tb\n\\u{7}c\\r\n");
    }
}
