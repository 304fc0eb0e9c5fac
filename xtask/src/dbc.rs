//! Lints DBC files: everything that is wrong or missing, with file and line.
//!
//! What is looked for is in `vehicle_compiler::lint` and where the generator reads the file; this prints it.

use crate::out::say;
use crate::workspace;
use anyhow::{Context, Result, bail};
use clap::Args;
use std::path::{Path, PathBuf};
use vehicle_compiler::{Diagnostic, encoding, lint};

/// What to lint.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// DBC files; all of `vehicles/` if none is given.
    files: Vec<PathBuf>,
}

/// Prints the findings, one per line.
///
/// # Errors
/// If there is a finding or a file cannot be read.
pub fn run(options: &Options) -> Result<()> {
    let files = if options.files.is_empty() { vehicles()? } else { options.files.clone() };
    let width = files.iter().map(|file| file.display().to_string().len()).max().unwrap_or(0);
    let (mut findings, mut bad_files) = (0, 0);
    for file in &files {
        let name = file.display().to_string();
        let found = findings_of(&name, &workspace::root().join(file), file);
        if found.is_empty() {
            say!("{name:width$}  ok")?;
        }
        found.iter().try_for_each(|finding| say!("{finding}"))?;
        findings += found.len();
        bad_files += usize::from(!found.is_empty());
    }
    if findings > 0 {
        let plural = if findings == 1 { "" } else { "s" };
        bail!("{findings} finding{plural} in {bad_files} of {} files", files.len());
    }
    Ok(())
}

/// Returns the findings of one file; a path that is not there is looked for in the repository.
fn findings_of(name: &str, in_repository: &Path, given: &Path) -> Vec<Diagnostic> {
    let path = if given.exists() { given } else { in_repository };
    match std::fs::read(path).map(|bytes| encoding::decode(name, bytes)) {
        Ok(Ok(text)) => lint::lint(name, &text).0,
        Ok(Err(wrong)) => wrong.0,
        Err(error) => {
            vec![Diagnostic::new(name, 0, format!("cannot be read: {error}"))]
        }
    }
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
