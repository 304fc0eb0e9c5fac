//! Where things stand in a DBC text: the line of each entry, and decimals as they are written.
//!
//! `can-dbc` says what a text means, but keeps neither lines nor exact numbers. This walks the tokens of a text that its
//! grammar has accepted: several entries on one line and entries over several lines are found like all others.

use std::collections::{BTreeMap, BTreeSet};

/// Line and column of a word, both from 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct At {
    pub(crate) line: usize,
    pub(crate) column: usize,
}

/// A value as it is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Written<'a> {
    /// Without its quotes.
    Text(&'a str),
    /// Sign, digits, point and exponent.
    Number(&'a str),
}

/// An attribute of a message, a signal or the network.
#[derive(Clone, Copy)]
pub(crate) struct Note<'a> {
    pub(crate) at: At,
    pub(crate) value: Written<'a>,
}

/// A value table (`VAL_`): where, raw values and words in the order of the text.
pub(crate) struct Words<'a> {
    pub(crate) at: At,
    pub(crate) rows: Vec<(&'a str, &'a str)>,
}

/// A message (`BO_`) with its signals, in the order of the text.
pub(crate) struct MessagePlace<'a> {
    /// Identifier as written; bit 31 = 29 bits.
    pub(crate) id: u64,
    pub(crate) name: &'a str,
    pub(crate) at: At,
    pub(crate) signals: Vec<SignalPlace<'a>>,
}

/// A signal (`SG_`).
pub(crate) struct SignalPlace<'a> {
    pub(crate) name: &'a str,
    /// `M`, `m3` and the like; empty if the signal is in every frame.
    pub(crate) mux: &'a str,
    pub(crate) at: At,
    /// From the start bit up to the unit.
    pub(crate) numbers: &'a str,
}

/// The type of a signal's value (`SIG_VALTYPE_`).
pub(crate) struct ValueKind<'a> {
    pub(crate) message: u64,
    pub(crate) signal: &'a str,
    /// `0` = whole number, `1` = IEEE float of 32 bits, `2` = of 64.
    pub(crate) kind: &'a str,
    pub(crate) at: At,
}

/// When a multiplexed signal is in the frame (`SG_MUL_VAL_`).
pub(crate) struct MuxValues<'a> {
    pub(crate) message: u64,
    pub(crate) signal: &'a str,
    pub(crate) selector: &'a str,
    /// First and last raw value of the selector.
    pub(crate) ranges: Vec<(u64, u64)>,
    pub(crate) at: At,
}

/// One entry; a text that ends before or behind it fits the grammar too.
pub(crate) struct Entry<'a> {
    /// Its first byte.
    pub(crate) start: usize,
    /// Its words with their lines.
    pub(crate) words: Vec<(usize, &'a str)>,
}

impl Entry<'_> {
    /// Returns the line of a number in it; the sign does not count.
    pub(crate) fn line_of(&self, number: &str) -> Option<usize> {
        let digits = number.trim_start_matches(['-', '+']);
        self.words.iter().find(|(_, word)| *word == digits).map(|(line, _)| *line)
    }
}

/// Everything that the checks point at.
#[derive(Default)]
pub(crate) struct Places<'a> {
    pub(crate) messages: Vec<MessagePlace<'a>>,
    pub(crate) kinds: Vec<ValueKind<'a>>,
    pub(crate) mux_values: Vec<MuxValues<'a>>,
    /// Attributes and value tables (`VAL_`) that are given again, by (attribute or `VAL_`, message, signal): the place, and
    /// the line of the one before.
    pub(crate) repeated: Vec<((&'a str, u64, &'a str), At, usize)>,
    pub(crate) entries: Vec<Entry<'a>>,
    /// Byte and digits of each identifier, wherever one is named.
    pub(crate) identifiers: Vec<(usize, &'a str)>,
    /// Byte behind the last node of the list (`BU_`).
    pub(crate) nodes_end: Option<usize>,
    /// Attributes by (name, message, signal).
    notes: BTreeMap<(&'a str, u64, &'a str), Note<'a>>,
    /// Value tables by (message, signal).
    words: BTreeMap<(u64, &'a str), Words<'a>>,
    /// Comments by (message, signal); a message's own stands under `""`.
    comments: BTreeMap<(u64, &'a str), &'a str>,
    /// Indices of the messages by their identifiers.
    by_id: BTreeMap<u64, usize>,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Word,
    Text,
    Mark,
}

#[derive(Clone, Copy)]
struct Token<'a> {
    kind: Kind,
    /// Without the quotes of a text.
    text: &'a str,
    start: usize,
    at: At,
    line: usize,
    /// The first of its line, at the very left.
    leads: bool,
}

/// Returns the tokens: words, quoted texts and single marks; comments (`//`) are none.
fn tokens(text: &str) -> Vec<Token<'_>> {
    let bytes = text.as_bytes();
    let (mut tokens, mut at, mut line) = (Vec::new(), 0, 1);
    let (mut seen, mut line_start) = (0, 0);
    while let Some(&byte) = bytes.get(at) {
        let start = at;
        let leads = start == 0 || bytes[start - 1] == b'\n' || bytes[start - 1] == b'\r';
        let first_line = line;
        if let Some(newline) = bytes[seen..start].iter().rposition(|&byte| byte == b'\n') {
            line_start = seen + newline + 1;
        }
        seen = start;
        let column = start - line_start + 1;
        let (kind, inner) = match byte {
            b'"' => {
                at += 1;
                while bytes.get(at).is_some_and(|&byte| byte != b'"') {
                    at += usize::from(bytes[at] == b'\\' && bytes.get(at + 1) == Some(&b'"'));
                    line += usize::from(bytes[at] == b'\n');
                    at += 1;
                }
                at += 1;
                (Kind::Text, text.get(start + 1..at - 1).unwrap_or(""))
            }
            b'/' if bytes.get(at + 1) == Some(&b'/') => {
                while bytes.get(at).is_some_and(|&byte| byte != b'\n' && byte != b'\r') {
                    at += 1;
                }
                continue;
            }
            byte if byte.is_ascii_alphanumeric() || byte == b'_' => {
                while bytes.get(at).is_some_and(|&byte| byte.is_ascii_alphanumeric() || byte == b'_') {
                    at += 1;
                }
                (Kind::Word, &text[start..at])
            }
            byte => {
                line += usize::from(byte == b'\n');
                at += 1;
                while !text.is_char_boundary(at) {
                    at += 1;
                }
                if byte.is_ascii_whitespace() {
                    continue;
                }
                (Kind::Mark, &text[start..at])
            }
        };
        let place = At { line: first_line, column };
        tokens.push(Token { kind, text: inner, start, at: place, line: first_line, leads });
    }
    tokens
}

fn number(text: &str) -> u64 {
    text.parse().unwrap_or(u64::MAX)
}

struct Walk<'a> {
    text: &'a str,
    tokens: Vec<Token<'a>>,
    at: usize,
}

impl<'a> Walk<'a> {
    fn peek(&self, ahead: usize) -> Option<Token<'a>> {
        self.tokens.get(self.at + ahead).copied()
    }

    /// Takes the next token and returns its text; empty at the end.
    fn take(&mut self) -> &'a str {
        let text = self.peek(0).map_or("", |token| token.text);
        self.at += 1;
        text
    }

    fn is(&self, ahead: usize, kind: Kind) -> bool {
        self.peek(ahead).is_some_and(|token| token.kind == kind)
    }

    fn is_number(&self, ahead: usize) -> bool {
        let digits = |token: Token<'_>| token.text.bytes().all(|byte| byte.is_ascii_digit());
        self.peek(ahead).is_some_and(|token| token.kind == Kind::Word && digits(token))
    }

    /// Takes a number with its sign, point and exponent and returns it as it is written.
    fn number(&mut self) -> &'a str {
        let start = self.peek(0).map_or(self.text.len(), |token| token.start);
        let mut end = start;
        while let Some(token) = self.peek(0) {
            let is_part = token.kind == Kind::Word || ["-", "+", "."].contains(&token.text);
            if token.kind == Kind::Text || !is_part || end != start && token.start != end {
                break;
            }
            end = token.start + token.text.len();
            self.at += 1;
        }
        self.text.get(start..end).unwrap_or("")
    }

    /// Passes everything up to the token and the token itself.
    fn pass(&mut self, is_last: impl Fn(Token<'a>) -> bool) {
        while let Some(token) = self.peek(0) {
            self.at += 1;
            if is_last(token) {
                break;
            }
        }
    }

    fn pass_semicolon(&mut self) {
        self.pass(|token| token.kind == Kind::Mark && token.text == ";");
    }
}

impl<'a> Places<'a> {
    /// Finds them in a text that fits the grammar.
    pub(crate) fn find(text: &'a str) -> Self {
        let mut places = Self::default();
        let mut walk = Walk { text, tokens: tokens(text), at: 0 };
        while let Some(token) = walk.peek(0) {
            let first = walk.at;
            walk.at += 1;
            places.entry(token, &mut walk);
            let words = walk.tokens[first..walk.at.min(walk.tokens.len())].iter();
            let words = words.filter(|token| token.kind == Kind::Word).map(|token| (token.line, token.text));
            places.entries.push(Entry { start: token.start, words: words.collect() });
        }
        let named = ["BO_", "SG_", "VAL_", "SIG_VALTYPE_", "SG_MUL_VAL_", "BO_TX_BU_", "SIG_GROUP_"];
        for pair in walk.tokens.windows(2).filter(|pair| pair[0].kind == Kind::Word) {
            if named.contains(&pair[0].text) && pair[1].kind == Kind::Word {
                places.identifiers.push((pair[1].start, pair[1].text));
            }
        }
        for (index, message) in places.messages.iter().enumerate() {
            places.by_id.entry(message.id).or_insert(index);
        }
        places
    }

    /// Reads one entry; `walk` stands behind its first word.
    fn entry(&mut self, token: Token<'a>, walk: &mut Walk<'a>) {
        let (at, line) = (token.at, token.line);
        match token.text {
            // Names of sections and nodes; lines that are indented belong to them.
            "NS_" | "BU_" => {
                while let Some(next) = walk.peek(0).filter(|next| next.line == line || !next.leads) {
                    if token.text == "BU_" {
                        self.nodes_end = Some(next.start + next.text.len());
                    }
                    walk.at += 1;
                }
            }
            "BS_" => {
                while walk.peek(0).is_some_and(|next| next.line == line) {
                    walk.at += 1;
                }
            }
            "VERSION" => walk.at += 1,
            "BO_" => {
                let (id, name) = (number(walk.take()), walk.take());
                // `: length sender`
                walk.at += 3;
                self.messages.push(MessagePlace { id, name, at, signals: Vec::new() });
            }
            "SG_" => {
                let name = walk.take();
                let mux = if walk.is(0, Kind::Word) { walk.take() } else { "" };
                let start = walk.peek(1).map_or(walk.text.len(), |token| token.start);
                while walk.peek(0).is_some() && !walk.is(0, Kind::Text) {
                    walk.at += 1;
                }
                let end = walk.peek(0).map_or(walk.text.len(), |token| token.start);
                let numbers = walk.text.get(start..end).unwrap_or("");
                // Unit and first receiver, then one more behind each comma.
                walk.at += 2;
                while walk.peek(0).is_some_and(|next| next.kind == Kind::Mark && next.text == ",") {
                    walk.at += 2;
                }
                if let Some(message) = self.messages.last_mut() {
                    message.signals.push(SignalPlace { name, mux, at, numbers });
                }
            }
            "CM_" => {
                let of = walk.peek(0).filter(|token| token.kind == Kind::Word).map_or("", |token| token.text);
                if let "BO_" | "SG_" = of {
                    walk.at += 1;
                    let id = number(walk.take());
                    let signal = if of == "SG_" { walk.take() } else { "" };
                    let comment = walk.peek(0).map_or("", |token| token.text);
                    self.comments.entry((id, signal)).or_insert(comment);
                }
                walk.pass(|token| token.kind == Kind::Text);
                self.pass_optional_semicolon(walk);
            }
            "VAL_" => {
                // Without an identifier it is the table of an environment variable.
                let has_id = walk.is_number(0);
                let id = if has_id { number(walk.take()) } else { 0 };
                let signal = walk.take();
                let mut rows = Vec::new();
                while walk.is_number(0) || walk.is(0, Kind::Mark) && walk.is_number(1) {
                    let raw = walk.number();
                    rows.push((raw, walk.peek(0).map_or("", |token| token.text)));
                    walk.pass(|token| token.kind == Kind::Text);
                }
                if has_id && let Some(first) = self.words.insert((id, signal), Words { at, rows }) {
                    self.repeated.push((("VAL_", id, signal), at, first.at.line));
                }
                self.pass_optional_semicolon(walk);
            }
            "BA_" => {
                let name = walk.take();
                let of = walk.peek(0).filter(|token| token.kind == Kind::Word).map_or("", |token| token.text);
                match of {
                    "BO_" | "SG_" => {
                        walk.at += 1;
                        let id = number(walk.take());
                        let signal = if of == "SG_" { walk.take() } else { "" };
                        self.note(name, id, signal, at, walk);
                    }
                    // Attributes of nodes and environment variables say nothing of the wire.
                    "BU_" | "EV_" => {}
                    _ => self.note(name, u64::MAX, "", at, walk),
                }
                walk.pass_semicolon();
            }
            "SIG_VALTYPE_" => {
                let (message, signal) = (number(walk.take()), walk.take());
                walk.at += 1;
                self.kinds.push(ValueKind { message, signal, kind: walk.take(), at });
                walk.pass_semicolon();
            }
            "SG_MUL_VAL_" => {
                let (message, signal, selector) = (number(walk.take()), walk.take(), walk.take());
                let mut ranges = Vec::new();
                while walk.is(0, Kind::Word) {
                    let first = number(walk.take());
                    walk.at += 1;
                    ranges.push((first, number(walk.take())));
                    if walk.take() != "," {
                        break;
                    }
                }
                self.mux_values.push(MuxValues { message, signal, selector, ranges, at });
            }
            _ => walk.pass_semicolon(),
        }
    }

    fn pass_optional_semicolon(&self, walk: &mut Walk<'a>) {
        if walk.peek(0).is_some_and(|next| next.kind == Kind::Mark && next.text == ";") {
            walk.at += 1;
        }
    }

    /// Notes an attribute whose value comes next.
    fn note(&mut self, name: &'a str, message: u64, signal: &'a str, at: At, walk: &mut Walk<'a>) {
        let value = match walk.peek(0) {
            Some(token) if token.kind == Kind::Text => Written::Text(token.text),
            _ => Written::Number(walk.number()),
        };
        if let Some(first) = self.notes.insert((name, message, signal), Note { at, value }) {
            self.repeated.push(((name, message, signal), at, first.at.line));
        }
    }

    /// Returns an attribute of a message, or of a signal if one is named.
    pub(crate) fn attribute(&self, name: &str, message: u64, signal: &str) -> Option<Note<'a>> {
        self.notes.get(&(name, message, signal)).copied()
    }

    /// Returns an attribute of the whole network.
    pub(crate) fn network_attribute(&self, name: &str) -> Option<Note<'a>> {
        self.attribute(name, u64::MAX, "")
    }

    /// Returns the value table of a signal.
    pub(crate) fn words<'s>(&'s self, message: u64, signal: &'s str) -> Option<&'s Words<'a>> {
        self.words.get(&(message, signal))
    }

    /// Returns the comment of a message, or of a signal if one is named.
    pub(crate) fn comment(&self, message: u64, signal: &str) -> Option<&'a str> {
        self.comments.get(&(message, signal)).copied()
    }

    /// Returns place and signal of each value table (`VAL_`) whose signal is not in the text.
    pub(crate) fn tables_of_nothing(&self) -> Vec<(At, &'a str)> {
        let signals = |message: &MessagePlace<'a>| {
            let id = message.id;
            message.signals.iter().map(move |signal| (id, signal.name)).collect::<Vec<_>>()
        };
        let there: BTreeSet<(u64, &str)> = self.messages.iter().flat_map(signals).collect();
        let lost = self.words.iter().filter(|(key, _)| !there.contains(*key));
        lost.map(|((_, signal), words)| (words.at, *signal)).collect()
    }

    /// Returns the first message with this identifier as written.
    pub(crate) fn message(&self, id: u64) -> Option<&MessagePlace<'a>> {
        self.by_id.get(&id).map(|index| &self.messages[*index])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_found_wherever_they_stand() {
        let text = "VERSION \"a \\\" BO_ 9\"\nNS_ :\n\tBO_TX_BU_\n\tVAL_\nBS_:\nBU_: A\n  B\n\
            BO_ 1 One: 8 A // BO_ 7 None: 8 A\n SG_ x m3 : 7|8@0- (-0.5, 1e-3) [ -1 | 2 ] \"SG_\" A,B\n SG_ y : 0|1@1+ (1,0) [0|1] \"\" A\n\
            CM_ SG_ 1 x \"two\nlines; SG_ z : 1\"; BO_ 2 Two: 8 B\n\
            VAL_ 1 x -1 \"minus\" 0 \"null\" ; VAL_ knob 1 \"on\";\nBA_ \"A\" SG_ 1 x 5; BA_ \"A\" SG_ 1 x 6;\n\
            SG_MUL_VAL_ 1 x y 0-0 , 3 - 5; SIG_VALTYPE_ 1 x : 1;\n";
        let places = Places::find(text);
        let shown: Vec<(u64, &str, usize)> =
            places.messages.iter().map(|message| (message.id, message.name, message.at.line)).collect();
        assert_eq!(shown, [(1, "One", 8), (2, "Two", 12)]);
        let signal = &places.messages[0].signals[0];
        assert_eq!((signal.name, signal.mux, signal.at), ("x", "m3", At { line: 9, column: 2 }));
        assert_eq!(signal.numbers, "7|8@0- (-0.5, 1e-3) [ -1 | 2 ] ");
        assert_eq!(places.messages[0].signals.len(), 2);
        let words = places.words(1, "x").expect("the table");
        assert_eq!((words.at.line, words.rows.as_slice()), (13, [("-1", "minus"), ("0", "null")].as_slice()));
        assert_eq!(places.repeated, [(("A", 1, "x"), At { line: 14, column: 20 }, 14)]);
        let note = places.attribute("A", 1, "x").expect("the attribute");
        assert_eq!((note.at.column, note.value), (20, Written::Number("6")));
        assert_eq!(places.comment(1, "x"), Some("two\nlines; SG_ z : 1"));
        assert_eq!(places.mux_values[0].ranges, [(0, 0), (3, 5)]);
        assert_eq!(
            (places.mux_values[0].selector, places.kinds[0].kind, places.kinds[0].at.line),
            ("y", "1", 15)
        );
    }
}
