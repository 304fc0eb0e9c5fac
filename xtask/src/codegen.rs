//! Generates `protocol-core/src/generated/` from the vehicles' folders.
//!
//! The same as `cargo run -p vehicle-compiler`, which is there for a tree in which this program does not build.

use crate::out::say;
use anyhow::{Result, bail};
use clap::Args;

/// What to do with the generated files.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Compares with the committed files and writes nothing.
    #[arg(long)]
    pub check: bool,
}

/// Writes the generated files, or checks that they are up to date.
///
/// # Errors
/// If a vehicle is wrong (file, line and what is wrong), or a committed file is stale.
pub fn run(options: &Options) -> Result<()> {
    let root = crate::workspace::root();
    if options.check {
        return match vehicle_compiler::check(&root) {
            Ok(()) => {
                say!("generated files are up to date")?;
                Ok(())
            }
            Err(problem) => bail!("{problem}"),
        };
    }
    match vehicle_compiler::write(&root) {
        Ok(files) => {
            files.iter().try_for_each(|file| say!("{}", file.display()))?;
            Ok(())
        }
        Err(problem) => bail!("{problem}"),
    }
}
