//! The proof that generated texts are valid Rust, asked of the compiler of Rust before a file of the tree is touched.
//!
//! Every tool of the repository is built from the generated files: one that does not compile would stop the generator
//! too. The texts are checked beside the tree, against `protocol-core` without its vehicles. Costs one `cargo check` of
//! that crate, which is mostly done already, and one run of `rustc` without code.

use crate::diagnostics::{Diagnostic, Diagnostics};
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicU32, Ordering};

/// What the generated modules name as parts of their own crate.
const CRATE: &str = "#![no_std]\npub use protocol_core::*;\npub mod generated;\n";

/// Checks the generated files (path from `root` and text) against the `protocol-core` of the repository at `root`.
///
/// # Errors
///
/// If one is not valid Rust, with its place: then the fault is the generator's, not the vehicle's. Or if cargo or rustc
/// cannot be run.
pub fn compiles(root: &Path, files: &[(PathBuf, String)]) -> Result<(), Diagnostics> {
    let library = library(root)?;
    let libraries = library.parent().unwrap_or(root);
    static RUNS: AtomicU32 = AtomicU32::new(0);
    let run = RUNS.fetch_add(1, Ordering::Relaxed);
    let scratch = libraries.with_file_name(format!("generated-{}-{run}", std::process::id()));
    let found = in_folder(&scratch, &library, libraries, files);
    // What is left here hurts nobody.
    let _ = fs::remove_dir_all(&scratch);
    found
}

fn in_folder(
    scratch: &Path,
    library: &Path,
    libraries: &Path,
    files: &[(PathBuf, String)],
) -> Result<(), Diagnostics> {
    let folder = scratch.join("generated");
    let put = |path: &Path, text: &str| {
        fs::write(path, text)
            .map_err(|error| failed(format!("{} cannot be written: {error}", path.display())))
    };
    fs::create_dir_all(&folder)
        .map_err(|error| failed(format!("{} cannot be made: {error}", folder.display())))?;
    put(&scratch.join("lib.rs"), CRATE)?;
    for (path, text) in files {
        put(&folder.join(path.file_name().unwrap_or_default()), text)?;
    }
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    // Lints that are errors by themselves stay errors.
    rustc.args([
        "--edition=2024",
        "--crate-type=lib",
        "--crate-name=generated",
        "--emit=metadata",
        "-Awarnings",
    ]);
    rustc.args(["--error-format=short", "lib.rs", "--out-dir", "."]).current_dir(scratch);
    let named = |prefix: &str, path: &Path| {
        let mut argument = OsString::from(prefix);
        argument.push(path);
        argument
    };
    rustc.arg("--extern").arg(named("protocol_core=", library));
    rustc.arg("-L").arg(named("dependency=", libraries));
    let output = run(&mut rustc)?;
    if output.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&output.stderr);
    let mut wrong = Diagnostics(said.lines().filter_map(|line| place(line, files)).collect());
    if wrong.0.is_empty() {
        wrong = failed(format!("rustc refuses the generated files: {}", said.trim()));
    }
    wrong.or(())
}

/// Returns the built `protocol-core` without vehicles.
fn library(root: &Path) -> Result<PathBuf, Diagnostics> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(root).args(["check", "--quiet", "--package", "protocol-core", "--lib"]);
    cargo.args(["--no-default-features", "--message-format=json-render-diagnostics"]);
    let output = run(&mut cargo)?;
    let said = String::from_utf8_lossy(&output.stdout);
    let mut built = said.lines().filter_map(|line| {
        let message: serde_json::Value = serde_json::from_str(line).ok()?;
        let is_it = message["reason"] == "compiler-artifact" && message["target"]["name"] == "protocol_core";
        let files = message["filenames"].as_array().filter(|_| is_it)?;
        files.iter().filter_map(|file| file.as_str()).find(|file| file.ends_with(".rmeta")).map(PathBuf::from)
    });
    built.next_back().filter(|_| output.status.success()).ok_or_else(|| {
        failed(format!(
            "`cargo check -p protocol-core` failed: {}",
            String::from_utf8_lossy(&output.stderr).trim()
        ))
    })
}

/// Reads `generated/bus.rs:12:5: error[...]: ...`.
fn place(line: &str, files: &[(PathBuf, String)]) -> Option<Diagnostic> {
    let (place, message) = line.split_once(": error")?;
    let mut place = place.split(':');
    let file = Path::new(place.next()?).file_name()?;
    let number: usize = place.next()?.parse().ok()?;
    let (path, text) = files.iter().find(|(path, _)| path.file_name() == Some(file))?;
    let source = text.lines().nth(number.checked_sub(1)?).unwrap_or("").trim();
    let message = format!(
        "would not be valid Rust, so nothing was written; this is a fault of the vehicle compiler, please report it: \
         error{message}, in `{source}`"
    );
    Some(Diagnostic::new(&path.to_string_lossy(), number, message))
}

fn run(command: &mut Command) -> Result<Output, Diagnostics> {
    let program = command.get_program().to_string_lossy().into_owned();
    command.output().map_err(|error| failed(format!("`{program}` cannot be run: {error}")))
}

fn failed(message: String) -> Diagnostics {
    Diagnostics::one(crate::GENERATED, 0, format!("nothing was written: {message}"))
}
