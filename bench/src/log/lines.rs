//! Bytes of a file as lines of text, whatever its encoding, in memory that does not grow with the file.
//!
//! Frames are ASCII in every format, so what else a line holds may be damaged by reading it as UTF-8. UTF-16 is found by
//! its mark or by the zero in every other byte. Lines end with LF, CR LF or CR.

use std::io::{self, BufRead, BufReader, Read};

/// Longest line: no format has more than a few hundred bytes in one.
pub(super) const LINE_MAX: usize = 1 << 16;
/// Bytes by which a file is known.
const START: usize = 4_096;

/// The lines of a file.
pub(super) struct Lines {
    bytes: Box<dyn BufRead + Send>,
    line: Vec<u8>,
    /// The last line ended with CR: an LF that follows belongs to it.
    after_cr: bool,
}

/// One line.
pub(super) struct Text {
    pub(super) text: String,
    /// It has its end: only the last line of a file may have none.
    pub(super) is_ended: bool,
}

/// Returns the first bytes of a stream and the stream with them.
pub(super) fn peeked(mut bytes: Box<dyn Read + Send>) -> io::Result<(Vec<u8>, Box<dyn Read + Send>)> {
    let mut start = Vec::new();
    bytes.by_ref().take(START as u64).read_to_end(&mut start)?;
    Ok((start.clone(), Box::new(io::Cursor::new(start).chain(bytes))))
}

impl Lines {
    /// The lines of a stream that begins with `start`.
    pub(super) fn new(start: &[u8], bytes: Box<dyn Read + Send>) -> Self {
        let bytes: Box<dyn BufRead + Send> = match wide(start) {
            Some(is_big) => {
                Box::new(BufReader::new(Utf16 { bytes: BufReader::new(bytes), is_big, high: None }))
            }
            None => Box::new(BufReader::with_capacity(1 << 16, bytes)),
        };
        Self { bytes, line: Vec::new(), after_cr: false }
    }

    /// Reads the next line; `None` at the end.
    pub(super) fn read(&mut self) -> io::Result<Option<Text>> {
        self.line.clear();
        loop {
            let held = self.bytes.fill_buf()?;
            if self.after_cr && held.first() == Some(&b'\n') {
                self.bytes.consume(1);
                self.after_cr = false;
                continue;
            }
            if held.is_empty() {
                return Ok((!self.line.is_empty()).then(|| self.text(false)));
            }
            self.after_cr = false;
            let end = held.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
            self.line.extend(&held[..end.unwrap_or(held.len())]);
            let used = end.map_or(held.len(), |end| end + 1);
            self.after_cr = end.is_some_and(|end| held[end] == b'\r');
            self.bytes.consume(used);
            if self.line.len() > LINE_MAX {
                return Err(io::Error::other(format!(
                    "a line of more than {LINE_MAX} bytes: not a text log"
                )));
            }
            if end.is_some() {
                return Ok(Some(self.text(true)));
            }
        }
    }

    fn text(&self, is_ended: bool) -> Text {
        Text { text: String::from_utf8_lossy(&self.line).into_owned(), is_ended }
    }
}

/// Returns whether a file is UTF-16, and then whether the high byte comes first.
fn wide(start: &[u8]) -> Option<bool> {
    match start {
        [0xFF, 0xFE, ..] => Some(false),
        [0xFE, 0xFF, ..] => Some(true),
        [1..=0xFF, 0, 1..=0xFF, 0, ..] => Some(false),
        [0, 1..=0xFF, 0, 1..=0xFF, ..] => Some(true),
        _ => None,
    }
}

/// UTF-16 read as UTF-8.
struct Utf16<R> {
    bytes: R,
    is_big: bool,
    /// The first half of a pair of surrogates.
    high: Option<u16>,
}

impl<R: Read> Read for Utf16<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        loop {
            let mut unit = [0; 2];
            let mut length = 0;
            while length < unit.len() {
                match self.bytes.read(&mut unit[length..])? {
                    0 => return Ok(0),
                    count => length += count,
                }
            }
            let unit = if self.is_big { u16::from_be_bytes(unit) } else { u16::from_le_bytes(unit) };
            if let (None, 0xD800..=0xDBFF) = (self.high, unit) {
                self.high = Some(unit);
                continue;
            }
            let units = self.high.take().into_iter().chain([unit]);
            let sign = char::decode_utf16(units).next().and_then(Result::ok);
            // The caller is a buffered reader: there is always room for one character.
            return Ok(sign.unwrap_or(char::REPLACEMENT_CHARACTER).encode_utf8(into).len());
        }
    }
}
