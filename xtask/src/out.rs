//! The one way to the terminal: [`say!`] prints a line on standard output, [`note!`] one beside it.
//!
//! What a file or a link says may hold anything. Everything printed here goes through [`printable_lines`]: a terminal
//! gets no control character but the end of a line and the tab.
//!
//! What a command prints may go into a pipe whose reader ends early, or into a file on a full disk. `println!` panics
//! there; here it is an error, and [`exit_code`] tells the one from the other: nobody reads on is the end of a Unix
//! tool, all else is a failure.

use bench::printable::printable_lines;
use std::error::Error;
use std::fmt;
use std::io::{self, Stdout, Write};
use std::process::ExitCode;

/// What a shell says of a tool that SIGPIPE has ended: 128 + 13.
const NOBODY_READS: u8 = 141;

/// Prints a line on standard output; returns an error if that fails, which goes up to `main`.
macro_rules! say {
    ($($text:tt)*) => { $crate::out::line(format_args!($($text)*)) };
}

/// Prints a line on standard error: progress and sums that are not the command's result.
macro_rules! note {
    ($($text:tt)*) => { $crate::out::beside(format_args!($($text)*)) };
}

pub(crate) use {note, say};

/// Standard output, as a writer whose errors say what could not be written.
pub struct Out(Printable<Stdout>);

/// Returns standard output.
pub fn stdout() -> Out {
    Out(Printable { out: io::stdout(), begun: Vec::new() })
}

impl Write for Out {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes).map_err(named)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush().map_err(named)
    }
}

/// A writer that lets through what a terminal does not obey.
struct Printable<W> {
    out: W,
    /// The beginning of a character whose rest comes by the next call.
    begun: Vec<u8>,
}

impl<W: Write> Write for Printable<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let joined = [&self.begun[..], bytes].concat();
        let whole = match std::str::from_utf8(&joined) {
            Err(error) if error.error_len().is_none() => error.valid_up_to(),
            _ => joined.len(),
        };
        let (text, begun) = joined.split_at(whole);
        self.out.write_all(printable_lines(&String::from_utf8_lossy(text)).as_bytes())?;
        self.begun = begun.to_vec();
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// What [`say!`] does.
///
/// # Errors
/// If standard output is closed or full.
pub fn line(text: fmt::Arguments<'_>) -> io::Result<()> {
    writeln!(stdout(), "{text}")
}

/// What [`note!`] does. Where standard error is closed there is nobody to tell.
pub fn beside(text: fmt::Arguments<'_>) {
    let _ = writeln!(io::stderr(), "{}", printable_lines(&text.to_string()));
}

/// Standard output could not be written.
#[derive(Debug)]
struct Unwritten(io::Error);

impl fmt::Display for Unwritten {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot write to standard output: {}", self.0)
    }
}

impl Error for Unwritten {}

fn named(error: io::Error) -> io::Error {
    io::Error::new(error.kind(), Unwritten(error))
}

/// Returns the exit code of a command that failed, and says why unless it was only that nobody reads on.
pub fn exit_code(error: &anyhow::Error) -> ExitCode {
    if is_nobody_reads(error) {
        return ExitCode::from(NOBODY_READS);
    }
    note!("error: {error:#}");
    ExitCode::FAILURE
}

/// Another pipe may break too, to an adapter or to a tool: that is a failure.
fn is_nobody_reads(error: &anyhow::Error) -> bool {
    error.chain().filter_map(|cause| cause.downcast_ref::<io::Error>()).any(|error| {
        error.kind() == io::ErrorKind::BrokenPipe
            && error.get_ref().is_some_and(|inner| inner.is::<Unwritten>())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::Context;

    #[test]
    fn a_terminal_gets_no_control_character_however_the_text_is_cut() {
        let text = "a\u{1b}[2J\u{9b}\u{202e}\r\tü温\n";
        let expected = "a\\u{1b}[2J\\u{9b}\\u{202e}\\r\tü温\n";
        for cut in 1..text.len() {
            let mut printable = Printable { out: Vec::new(), begun: Vec::new() };
            for part in text.as_bytes().chunks(cut) {
                printable.write_all(part).unwrap();
            }
            assert_eq!(String::from_utf8(printable.out).unwrap(), expected, "cut at {cut}");
        }
    }

    #[test]
    fn only_a_closed_standard_output_ends_quietly() {
        let closed = || io::Error::from(io::ErrorKind::BrokenPipe);
        let full = io::Error::from(io::ErrorKind::StorageFull);
        let wrapped = Err::<(), _>(named(closed())).context("while it printed").unwrap_err();
        assert!(is_nobody_reads(&anyhow::Error::from(named(closed()))));
        assert!(is_nobody_reads(&wrapped));
        assert!(!is_nobody_reads(&anyhow::Error::from(closed())), "the pipe to a tool");
        assert!(!is_nobody_reads(&anyhow::Error::from(named(full))));
    }

    #[test]
    fn a_full_disk_is_named() {
        let full = named(io::Error::from(io::ErrorKind::StorageFull));
        assert!(full.to_string().starts_with("cannot write to standard output: "), "{full}");
    }
}
