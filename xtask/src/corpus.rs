//! Reads a folder of other people's files and prints what became of each.

mod logs;

use anyhow::{Result, bail};
use clap::Args;
use std::path::PathBuf;

/// Which files to read.
#[derive(Args, Debug)]
pub struct Options {
    /// Folder, with all folders in it.
    folder: PathBuf,
    /// Reads its recordings.
    #[arg(long)]
    logs: bool,
}

/// Prints the table.
///
/// # Errors
/// If the folder cannot be read, or a frame differs from what the witness read.
pub fn run(options: &Options) -> Result<()> {
    if !options.logs {
        bail!("say which files: --logs");
    }
    logs::run(&options.folder)
}
