//! Lints DBC files: everything that is wrong or missing, with file and line.
//!
//! What is looked for is in `vehicle_compiler::lint` and where the generator reads the file; this prints it.

use crate::out::say;
use crate::workspace;
use anyhow::{Context, Result, anyhow, bail};
use clap::Args;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use vehicle_compiler::{Diagnostic, Grade, RunTime, encoding, lint};

/// What to lint.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// DBC files; all of `vehicles/` if none is given: there, a note is wrong too.
    files: Vec<PathBuf>,
    /// Mends what is mechanical and writes the file as UTF-8: bit 31 of identifiers, ranges beyond the bits, missing nodes.
    #[arg(long, requires = "files")]
    fix: bool,
    /// Prints every note, not only the first of many of a kind.
    #[arg(long)]
    all: bool,
}

/// Notes of one kind that are printed in any case.
const FEW: usize = 3;

/// Prints the findings, one per line.
///
/// # Errors
/// If there is an error or a file cannot be read; of the repository's own files, if there is any finding.
pub fn run(options: &Options) -> Result<()> {
    let is_own = options.files.is_empty();
    let files = if is_own { vehicles()? } else { options.files.clone() };
    let width = files.iter().map(|file| file.display().to_string().len()).max().unwrap_or(0);
    let (mut findings, mut bad_files) = (0, 0);
    for file in &files {
        let name = file.display().to_string();
        let in_repository = workspace::root().join(file);
        let path = if file.exists() { file } else { &in_repository };
        if options.fix {
            mend(&name, path)?;
        }
        let found = findings_of(&name, path);
        let wrong = found.iter().filter(|finding| is_own || finding.grade == Grade::Error).count();
        print(&found, options.all)?;
        if wrong == 0 {
            let rest = summary(&found);
            say!("{name:width$}  ok{rest}")?;
        }
        findings += wrong;
        bad_files += usize::from(wrong > 0);
    }
    if findings > 0 {
        let plural = if findings == 1 { "" } else { "s" };
        bail!("{findings} finding{plural} in {bad_files} of {} files", files.len());
    }
    Ok(())
}

/// Prints findings; of many notes of one kind the first, and how many follow.
fn print(found: &[Diagnostic], all: bool) -> Result<()> {
    let is_note = |finding: &&Diagnostic| finding.grade == Grade::Note && !all;
    let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
    found.iter().filter(is_note).for_each(|finding| *kinds.entry(finding.form()).or_default() += 1);
    let mut said = BTreeSet::new();
    for finding in found {
        let count = kinds.get(&finding.form()).copied().filter(|_| is_note(&finding)).unwrap_or(0);
        if said.contains(&finding.form()) && is_note(&finding) {
            continue;
        }
        match count {
            0..=FEW => say!("{finding}")?,
            count => {
                say!("{finding} (and {} more of this kind: --all)", count - 1)?;
                // What follows is counted in this line.
                said.insert(finding.form());
            }
        }
    }
    Ok(())
}

fn summary(found: &[Diagnostic]) -> String {
    let count = |grade: Grade| found.iter().filter(|finding| finding.grade == grade).count();
    match (count(Grade::Warning), count(Grade::Note)) {
        (0, 0) => String::new(),
        (warnings, notes) => format!("  ({warnings} warnings, {notes} notes)"),
    }
}

/// Writes a file as it should be and says what was done.
fn mend(name: &str, path: &Path) -> Result<()> {
    let bytes = std::fs::read(path).with_context(|| format!("{name} cannot be read"))?;
    let read = encoding::read(name, bytes.clone()).map_err(|wrong| anyhow!("{wrong}"))?;
    let (text, done) = vehicle_compiler::fix(name, &read.text).map_err(|wrong| anyhow!("{wrong}"))?;
    if text.as_bytes() == bytes {
        return Ok(());
    }
    std::fs::write(path, &text).with_context(|| format!("{name} cannot be written"))?;
    for line in read.note.iter().chain(&done) {
        say!("{name}: mended: {line}")?;
    }
    Ok(())
}

/// Returns the findings of one file, and what is wrong with the vehicle.toml beside it.
fn findings_of(name: &str, path: &Path) -> Vec<Diagnostic> {
    let read = match std::fs::read(path).map(|bytes| encoding::read(name, bytes)) {
        Ok(Ok(read)) => read,
        Ok(Err(wrong)) => return wrong.0,
        Err(error) => return vec![Diagnostic::new(name, 0, format!("cannot be read: {error}"))],
    };
    let note = read.note.map(|note| Diagnostic { grade: Grade::Note, ..Diagnostic::new(name, 0, note) });
    let mut found: Vec<Diagnostic> = note.into_iter().chain(lint::lint(name, &read.text).0).collect();
    let toml = path.with_file_name("vehicle.toml");
    if let Ok(text) = std::fs::read_to_string(&toml) {
        let shown = Path::new(name).with_file_name("vehicle.toml").display().to_string();
        let bound = RunTime::of_texts(name, (name, &read.text), Some((&shown, &text)));
        let already = |wrong: &Diagnostic| found.contains(wrong);
        let wrong: Vec<Diagnostic> =
            bound.err().into_iter().flat_map(|wrong| wrong.0).filter(|wrong| !already(wrong)).collect();
        found.extend(wrong);
    }
    found
}

/// Returns the DBC files of all vehicles, relative to the repository.
fn vehicles() -> Result<Vec<PathBuf>> {
    let root = workspace::root();
    let mut files = Vec::new();
    let folders = std::fs::read_dir(root.join("vehicles")).context("vehicles/ cannot be read")?;
    for folder in folders.flatten().filter(|folder| folder.path().is_dir()) {
        for file in std::fs::read_dir(folder.path())?.flatten() {
            let path = file.path();
            if path.extension().is_some_and(|extension| extension == "dbc") {
                files.push(path.strip_prefix(&root).unwrap_or(&path).to_owned());
            }
        }
    }
    files.sort();
    Ok(files)
}
