//! Writes the generated vehicles without needing them: `cargo run -p vehicle-compiler`.
//!
//! Does what `cargo xtask codegen` does. `xtask` is built from the generated files, this is not: it works in a tree whose
//! generated files are missing, half merged or do not compile.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Returns the root of the repository: as cargo says it, else the folder that the program is started in.
fn root() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| ".".into(), |here| Path::new(&here).join("../.."))
}

fn main() -> ExitCode {
    if std::env::args().len() > 1 {
        eprintln!(
            "usage: cargo run -p vehicle-compiler (no arguments); to compare only: cargo xtask codegen --check"
        );
        return ExitCode::FAILURE;
    }
    match vehicle_compiler::write(&root()) {
        Ok(paths) => {
            for path in paths {
                println!("{}", path.display());
            }
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
