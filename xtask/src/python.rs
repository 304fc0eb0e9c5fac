//! The outside witnesses: cantools and python-can, in a virtual environment of the repository's own.

use crate::out::note;
use crate::workspace;
use anyhow::{Context, Result};
use std::path::PathBuf;
use std::process::Command;
use surroundings::need;

/// Python packages that the tests ask for a second opinion.
const REQUIREMENTS: &str = "tools/witness/requirements.txt";

/// Returns the environment's interpreter, creating the environment on first use.
///
/// # Errors
/// If there is no Python 3 or the packages cannot be installed; the message says what to type.
pub fn witness() -> Result<PathBuf> {
    let folder = workspace::target().join("venv");
    let python = folder.join("bin/python");
    if need::has_witnesses(&python) {
        return Ok(python);
    }
    note!("installing the witnesses (cantools, python-can) into {}", folder.display());
    let mut create = Command::new("python3");
    workspace::run(create.args(["-m", "venv", "--clear"]).arg(&folder)).context(
        "the witnesses need Python 3 with venv: `apt-get install python3 python3-venv` (or your system's equivalent)",
    )?;
    let mut install = Command::new(&python);
    install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--requirement"]);
    workspace::run(install.arg(workspace::root().join(REQUIREMENTS)))
        .with_context(|| format!("cannot install {REQUIREMENTS}; is the package index reachable?"))?;
    Ok(python)
}

/// Returns whether the witnesses are installed already.
pub fn is_ready() -> bool {
    need::has_witnesses(&workspace::target().join("venv/bin/python"))
}
