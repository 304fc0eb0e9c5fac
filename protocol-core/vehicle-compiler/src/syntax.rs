//! Whether a text is a DBC, and the line at which it is not.
//!
//! `can-dbc` decides; this gives its errors a place, and pairs what it has read with where that stands.

use crate::diagnostics::{Diagnostics, line_of};
use crate::places::{Entry, MessagePlace, Places};
use can_dbc::{Dbc, DbcError};

/// What Vector's editors write signals into that belong to no message; neither number is an identifier.
const INDEPENDENT: [(&str, u64); 2] =
    [("VECTOR__INDEPENDENT_SIG_MSG", 0xC000_0000), ("VECTOR__INDEPENDENT_SIG_MSG", 0x4000_0000)];

/// Pairs each message of the text with its place, but for the container of signals without a message.
pub(crate) fn placed<'d, 'p, 't>(
    dbc: &'d Dbc,
    places: &'p Places<'t>,
) -> impl Iterator<Item = (&'d can_dbc::Message, &'p MessagePlace<'t>)> {
    dbc.messages
        .iter()
        .zip(&places.messages)
        .filter(|(_, place)| !INDEPENDENT.contains(&(place.name, place.id)))
}

/// Returns the first line at which the text's messages and signals are not those of the parser.
pub(crate) fn first_unplaced(dbc: &Dbc, places: &Places<'_>) -> Option<usize> {
    let last = places.messages.last().map_or(1, |place| place.at.line);
    if dbc.messages.len() != places.messages.len() {
        return Some(last);
    }
    let same = |(message, place): &(&can_dbc::Message, &MessagePlace<'_>)| {
        let names = message.signals.iter().map(|signal| signal.name.as_str());
        message.name == place.name && names.eq(place.signals.iter().map(|place| place.name))
    };
    dbc.messages.iter().zip(&places.messages).find(|pair| !same(pair)).map(|(_, place)| place.at.line)
}

/// Returns the text behind its byte-order mark, if it has one.
pub(crate) fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{FEFF}').unwrap_or(text)
}

/// Parses the text; a syntax error carries its line.
pub(crate) fn parse(file: &str, text: &str) -> Result<Dbc, Diagnostics> {
    let text = without_mark(text);
    let error = match Dbc::try_from(text) {
        Ok(dbc) => return Ok(dbc),
        Err(error) => error,
    };
    let shown = error.to_string();
    if let DbcError::Pest(_) = error {
        // The grammar's own report begins "--> line:column" and ends "= expected ...".
        let line =
            shown.split("--> ").nth(1).and_then(|at| at.split(':').next()?.trim().parse().ok()).unwrap_or(1);
        let source = text.lines().nth(usize::max(line, 1) - 1).unwrap_or("").trim();
        let message = if source.is_empty() || line > text.lines().count() {
            "the file ends in the middle of an entry".to_string()
        } else {
            let expected = shown.rsplit("= ").next().unwrap_or("").replace('_', " ");
            format!("not valid DBC: `{source}` ({expected})")
        };
        return Err(Diagnostics::one(file, line, message));
    }
    let entries = Places::find(text).entries;
    let Some(entry) = failing_entry(text, &entries, |text| Dbc::try_from(text).is_err_and(is_number_error))
    else {
        return Err(Diagnostics::one(file, 1, format!("not valid DBC: {shown}")));
    };
    let (line, number) = match &error {
        DbcError::InvalidInt(number) | DbcError::InvalidUint(number) => {
            (entry.line_of(number), number.clone())
        }
        DbcError::MessageIdOutOfRange(id) => (entry.line_of(&id.to_string()), id.to_string()),
        _ => {
            return Err(Diagnostics::one(
                file,
                line_of(text, entry.start),
                format!("not valid DBC: {shown}"),
            ));
        }
    };
    let line = line.unwrap_or(line_of(text, entry.start));
    let reason = if number.starts_with('-') { "must not be negative" } else { "is too large for its place" };
    Err(Diagnostics::one(file, line, format!("not valid DBC: the number {number} {reason}")))
}

/// The grammar holds, but a number does not fit: such errors carry no position.
fn is_number_error(error: DbcError) -> bool {
    !matches!(error, DbcError::Pest(_))
}

/// Returns the first entry with which the text fails; `fails` is asked once for each halving of the entries.
fn failing_entry<'e, 't>(
    text: &str,
    entries: &'e [Entry<'t>],
    mut fails: impl FnMut(&str) -> bool,
) -> Option<&'e Entry<'t>> {
    let end = |index: usize| entries.get(index + 1).map_or(text.len(), |next| next.start);
    let (mut right, mut wrong) = (0, entries.len());
    while right < wrong {
        let middle = right.midpoint(wrong);
        if fails(&text[..end(middle)]) { wrong = middle } else { right = middle + 1 }
    }
    entries.get(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_that_does_not_fit_is_found_without_parsing_the_file_for_every_line() {
        let mut text = String::from("VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: A\n\n");
        for id in 1..=400 {
            text.push_str(&format!("BO_ {id} M{id}: 8 A\n SG_ s : 0|8@1+ (1,0) [0|255] \"\" A\n\n"));
        }
        for id in 1..=400 {
            text.push_str(&format!("VAL_ {id} s 0 \"none\" 1 \"one\" ;\n"));
        }
        let wrong = "VAL_ 300 s 0 \"none\" 18446744073709551616 \"one\" ;";
        text = text.replace("VAL_ 300 s 0 \"none\" 1 \"one\" ;", wrong);
        let line =
            text.lines().position(|line| line.contains("18446744073709551616")).expect("it is there") + 1;
        let mut parses = 0;
        let entries = Places::find(&text).entries;
        let found = failing_entry(&text, &entries, |text| {
            parses += 1;
            Dbc::try_from(text).is_err_and(is_number_error)
        });
        assert_eq!(found.and_then(|entry| entry.line_of("18446744073709551616")), Some(line));
        assert!(parses <= 12, "{parses} parses of {} entries", entries.len());
        let said = parse("x.dbc", &text).expect_err("a number too large").to_string();
        let number = "the number 18446744073709551616 is too large for its place";
        assert_eq!(said, format!("x.dbc:{line}: not valid DBC: {number}"));
    }
}
