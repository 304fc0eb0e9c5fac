//! Writes the generated files of the repository in the working folder, as `cargo xtask codegen` does.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    match vehicle_compiler::write(Path::new(".")) {
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
