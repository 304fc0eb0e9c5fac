//! What is wrong with a vehicle folder: file, line, reason, nearest match.
//!
//! Errors are collected, not thrown: one run shows all of them.

use crate::places::At;
use std::fmt;

/// What a finding keeps from being done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Grade {
    /// What is asked for cannot be had.
    #[default]
    Error,
    /// A part of the file cannot be had; what is bound elsewhere can.
    Warning,
    /// Worth knowing: something was understood another way than it is written, or is missing.
    Note,
}

/// One thing that is wrong, at one place of one file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Diagnostic {
    /// File, relative to the repository.
    pub file: String,
    /// Line, from 1; 0 = the file as a whole.
    pub line: usize,
    /// Column, from 1, in bytes; 0 = the line as a whole.
    pub column: usize,
    /// What it keeps from being done.
    pub grade: Grade,
    /// What is wrong and what would be right.
    pub message: String,
}

impl Diagnostic {
    /// Returns an error at a line.
    pub fn new(file: &str, line: usize, message: impl Into<String>) -> Self {
        Self { file: file.into(), line, column: 0, grade: Grade::Error, message: message.into() }
    }
}

impl Diagnostic {
    /// Returns the message without its names and numbers: what findings of one kind have in common.
    pub fn form(&self) -> String {
        let words = self.message.split('`').step_by(2).collect::<Vec<_>>().join("X");
        let plain =
            words.split_whitespace().map(|word| match word.chars().any(|letter| letter.is_ascii_digit()) {
                true => "N",
                false => word,
            });
        plain.collect::<Vec<_>>().join(" ")
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let grade = match self.grade {
            Grade::Error => "",
            Grade::Warning => "warning: ",
            Grade::Note => "note: ",
        };
        match (self.line, self.column) {
            (0, _) => write!(f, "{}: {grade}{}", self.file, self.message),
            (line, 0) => write!(f, "{}:{line}: {grade}{}", self.file, self.message),
            (line, column) => write!(f, "{}:{line}:{column}: {grade}{}", self.file, self.message),
        }
    }
}

/// Everything that is wrong, in the order of files and lines.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Diagnostics(pub Vec<Diagnostic>);

impl Diagnostics {
    /// Returns a list of one.
    pub fn one(file: &str, line: usize, message: impl Into<String>) -> Self {
        Self(vec![Diagnostic::new(file, line, message)])
    }

    /// Returns whether one of them is an error.
    pub fn have_error(&self) -> bool {
        self.0.iter().any(|found| found.grade == Grade::Error)
    }

    /// Returns `value` if there is no error, else all that was found, sorted.
    ///
    /// # Errors
    ///
    /// Returns itself if one of them is an error.
    pub fn or<T>(mut self, value: T) -> Result<T, Self> {
        if !self.have_error() {
            return Ok(value);
        }
        self.sort();
        Err(self)
    }

    /// Sorts by file and line and drops what stands there twice.
    pub fn sort(&mut self) {
        self.0.sort();
        self.0.dedup();
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, diagnostic) in self.0.iter().enumerate() {
            if index > 0 {
                writeln!(f)?;
            }
            write!(f, "{diagnostic}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostics {}

/// Collects what is wrong in one file.
pub(crate) struct Report<'a> {
    file: &'a str,
    text: &'a str,
    found: Vec<Diagnostic>,
}

impl<'a> Report<'a> {
    pub(crate) fn new(file: &'a str, text: &'a str) -> Self {
        Self { file, text, found: Vec::new() }
    }

    /// Notes a fault at a line, from 1.
    pub(crate) fn line(&mut self, line: usize, message: impl Into<String>) {
        self.found.push(Diagnostic::new(self.file, line, message));
    }

    /// Notes a finding at a place.
    pub(crate) fn at(&mut self, at: At, grade: Grade, message: impl Into<String>) {
        let found = Diagnostic::new(self.file, at.line, message);
        self.found.push(Diagnostic { column: at.column, grade, ..found });
    }

    /// Notes what cannot be had.
    pub(crate) fn warning(&mut self, at: At, message: impl Into<String>) {
        self.at(at, Grade::Warning, message);
    }

    /// Notes what is worth knowing.
    pub(crate) fn note(&mut self, at: At, message: impl Into<String>) {
        self.at(at, Grade::Note, message);
    }

    /// Notes a fault at a byte offset.
    pub(crate) fn offset(&mut self, offset: usize, message: impl Into<String>) {
        let line = line_of(self.text, offset);
        self.line(line, message);
    }

    pub(crate) fn finish(self) -> Diagnostics {
        Diagnostics(self.found)
    }
}

/// Returns the line, from 1, of a byte offset.
pub(crate) fn line_of(text: &str, offset: usize) -> usize {
    text.as_bytes().iter().take(offset).filter(|&&byte| byte == b'\n').count() + 1
}

/// Returns "; did you mean `x`?" for the candidate nearest to `word`, or nothing if none is near.
pub fn did_you_mean<'a>(word: &str, candidates: impl Iterator<Item = &'a str>) -> String {
    let limit = (word.chars().count() / 3).max(1);
    candidates
        .map(|candidate| (distance(word, candidate), candidate))
        .filter(|(edits, _)| *edits <= limit)
        .min()
        .map(|(_, candidate)| format!("; did you mean `{candidate}`?"))
        .unwrap_or_default()
}

/// Returns how many single-character edits or swaps of neighbours turn `a` into `b` (optimal string alignment).
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) =
        (a.to_lowercase().chars().collect(), b.to_lowercase().chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    for (j, cell) in rows[0].iter_mut().enumerate() {
        *cell = j;
    }
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let replace = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replace.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_offered_and_a_far_one_is_not() {
        let names = ["vehicle_speed", "vehicle_mode", "soc"];
        assert_eq!(did_you_mean("vehicle_sped", names.into_iter()), "; did you mean `vehicle_speed`?");
        assert_eq!(did_you_mean("sco", names.into_iter()), "; did you mean `soc`?");
        assert_eq!(did_you_mean("temperature", names.into_iter()), "");
    }
}
