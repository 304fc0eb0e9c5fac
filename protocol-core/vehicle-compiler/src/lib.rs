//! Turns a vehicle folder (DBC and `vehicle.toml`) into the Rust of protocol-core.
//!
//! Owns the checks of both files and the form of the generated text; the keys of `vehicle.toml` are described in
//! `vehicles/FORMAT.md`. Deterministic: the same folder gives the same bytes. Refuses to guess: whatever is misspelt,
//! overlaps, has no unit or no meaning is an error with file and line, and all errors are shown at once. Writes all files
//! or none, and none that the compiler of Rust has not accepted. Needs no generated file to be built itself, so a tree
//! that does not build is mended with `cargo run -p vehicle-compiler`.

#![forbid(unsafe_code)]

mod binding;
mod codec_text;
mod diagnostics;
pub mod encoding;
mod fix;
mod gate;
mod interpreter;
pub mod lint;
mod meaning;
mod multiplex;
mod names;
pub mod network;
mod number;
mod places;
pub mod proof;
pub mod proposal;
mod ratio;
mod spelling;
mod sweep;
mod syntax;
mod vehicle_text;

pub use diagnostics::{Diagnostic, Diagnostics, Grade, did_you_mean};
pub use fix::fix;
pub use interpreter::RunTime;
pub use names::wrong_folder;
pub use number::Number;

use std::fs;
use std::path::{Path, PathBuf};

/// Folder of the generated files, from the root of the repository.
pub const GENERATED: &str = "protocol-core/src/generated";

/// One form of expression serves every width and range, and one list of imports every vehicle.
const MODULE_ATTRIBUTES: &str = "
#[rustfmt::skip]
#[allow(clippy::cast_lossless, clippy::manual_range_contains, clippy::unnecessary_cast, unused_imports)]
";

/// Turns one vehicle into Rust text.
///
/// `dbc` and `toml` are name and text of the two files; the names stand in diagnostics.
///
/// # Errors
///
/// Everything that is wrong with the two files.
pub fn compile(name: &str, dbc: (&str, &str), toml: (&str, &str)) -> Result<String, Diagnostics> {
    compile_vehicle(name, dbc, toml).map(|compiled| compiled.text)
}

/// What becomes of one vehicle.
struct Compiled {
    /// The generated module.
    text: String,
    /// Images hold the vehicle and look for it.
    shipped: bool,
}

fn compile_vehicle(name: &str, dbc: (&str, &str), toml: (&str, &str)) -> Result<Compiled, Diagnostics> {
    let network = gate::read(dbc.0, dbc.1)?.network;
    let binding = binding::read(toml.0, toml.1, dbc.0, &network)?;
    let mut out = format!(
        "//! Vehicle `{name}`: {} ({}).\n//!\n//! Generated from `{}` and `{}`; refresh with `cargo xtask codegen`.\n\n",
        one_line(&binding.en),
        one_line(&binding.zh),
        dbc.0,
        toml.0
    );
    out.push_str(
        "use crate::checksum::{Checksum, ChecksumKind};\n\
         use crate::codec::{self, Got, LifeKind, MessageInfo, Mux, Order, Scale, SignalInfo};\n\
         use crate::frame::CanId;\n\
         use crate::model::{INVALID, Readings, Severity, Value};\n\
         use crate::stream::{Bound, Cell, Stream};\n\
         use crate::vehicle::{FaultText, HvOffRule, Life, LimpRule, Node, NodeName, Rules, RxMessage, TxMessage, Vehicle};\n",
    );
    codec_text::write(&mut out, &network);
    vehicle_text::write(&mut out, name, &network, &binding);
    Ok(Compiled { text: out, shipped: binding.shipped })
}

/// Returns a text of a user as it may stand in a comment: what is no letter is written as its escape.
pub(crate) fn one_line(text: &str) -> String {
    let shown = |letter: char| match letter {
        '"' | '\'' | '\\' => letter.to_string(),
        _ => letter.escape_debug().to_string(),
    };
    text.chars().map(shown).collect()
}

/// Returns the vehicles' names: the folders under `vehicles/` that hold `<name>.dbc` and `vehicle.toml`, sorted.
///
/// # Errors
///
/// If the folder cannot be read, one of the two files stands alone, or the name is none for a module.
pub fn vehicles(root: &Path) -> Result<Vec<String>, Diagnostics> {
    let folder = root.join("vehicles");
    let entries = fs::read_dir(&folder)
        .map_err(|error| Diagnostics::one("vehicles", 0, format!("cannot be read: {error}")))?;
    let mut names = Vec::new();
    let mut wrong = Diagnostics::default();
    for entry in entries.flatten().filter(|entry| entry.path().is_dir()) {
        let name = entry.file_name().to_string_lossy().into_owned();
        let files = [format!("{name}.dbc"), "vehicle.toml".into()];
        match files.map(|file| entry.path().join(file).is_file()) {
            [true, true] => match wrong_folder(&name) {
                None => names.push(name),
                Some(reason) => wrong.0.extend(Diagnostics::one(&format!("vehicles/{name}"), 0, reason).0),
            },
            [false, false] => {}
            [dbc, _] => {
                let file = if dbc { "vehicle.toml".to_string() } else { format!("{name}.dbc") };
                let message = "is missing: a vehicle needs both files, see vehicles/FORMAT.md";
                wrong.0.push(Diagnostic::new(&format!("vehicles/{name}/{file}"), 0, message));
            }
        }
    }
    names.sort();
    wrong.or(names)
}

/// Compiles every vehicle under `root`: paths (from `root`) and texts of all generated files.
///
/// # Errors
///
/// Everything that is wrong with any vehicle.
pub fn compile_all(root: &Path) -> Result<Vec<(PathBuf, String)>, Diagnostics> {
    let names = vehicles(root)?;
    let mut files = Vec::new();
    let mut shipped = Vec::new();
    let mut wrong = Diagnostics::default();
    let mut modules = String::from(
        "//! The vehicles: one generated module each.\n//!\n//! Refresh with `cargo xtask codegen`.\n",
    );
    for name in &names {
        let read = |file: String| {
            let bytes = fs::read(root.join(&file));
            let bytes =
                bytes.map_err(|error| Diagnostics::one(&file, 0, format!("cannot be read: {error}")))?;
            let read = if file.ends_with(".dbc") {
                encoding::read(&file, bytes).map(|read| read.text)
            } else {
                encoding::decode(&file, bytes)
            };
            read.map(|text| (file, text))
        };
        let compiled = read(format!("vehicles/{name}/{name}.dbc")).and_then(|dbc| {
            let toml = read(format!("vehicles/{name}/vehicle.toml"))?;
            compile_vehicle(name, (&dbc.0, &dbc.1), (&toml.0, &toml.1))
        });
        match compiled {
            Ok(compiled) => {
                files.push((Path::new(GENERATED).join(format!("{name}.rs")), compiled.text));
                shipped.extend(compiled.shipped.then_some(name));
            }
            Err(error) => wrong.0.extend(error.0),
        }
        modules.push_str(MODULE_ATTRIBUTES);
        modules.push_str(&format!("pub mod {name};\n"));
    }
    let lists = [
        ("Every vehicle, sorted by name: for tools and tests.", "VEHICLES", names.iter().collect()),
        ("The vehicles that an image holds and looks for, sorted by name.", "SHIPPED_VEHICLES", shipped),
    ];
    for (meaning, list, names) in lists {
        modules.push_str(&format!("\n/// {meaning}\n#[rustfmt::skip]\n"));
        modules.push_str(&format!("pub static {list}: &[&crate::Vehicle] = &[\n"));
        names.iter().for_each(|name| modules.push_str(&format!("    &{name}::VEHICLE,\n")));
        modules.push_str("];\n");
    }
    modules
        .push_str("\n/// Name and messages of every vehicle, sorted by name: for tools.\n#[rustfmt::skip]\n");
    modules.push_str("pub static MESSAGES: &[(&str, &[crate::codec::MessageInfo])] = &[\n");
    for name in &names {
        modules.push_str(&format!("    ({name:?}, {name}::MESSAGES),\n"));
    }
    modules.push_str("];\n");
    files.push((Path::new(GENERATED).join("mod.rs"), modules));
    wrong.or(files)
}

/// Returns the paths of files in the generated folder that no vehicle makes any more.
fn leftovers(root: &Path, files: &[(PathBuf, String)]) -> Vec<PathBuf> {
    let entries = fs::read_dir(root.join(GENERATED)).into_iter().flatten().flatten();
    let mut paths: Vec<PathBuf> = entries.map(|entry| Path::new(GENERATED).join(entry.file_name())).collect();
    paths.retain(|path| files.iter().all(|(known, _)| known != path));
    paths.sort();
    paths
}

/// Writes the generated files that changed, removes those without a vehicle, and returns their paths.
///
/// All or nothing: what is wrong with one vehicle, or is not valid Rust, leaves every file as it was.
///
/// # Errors
///
/// Everything that is wrong with any vehicle, what [`proof::compiles`] finds, or the first file that cannot be written.
pub fn write(root: &Path) -> Result<Vec<PathBuf>, Diagnostics> {
    write_if(root, |files| proof::compiles(root, files))
}

/// Does what [`write`] does, with another proof of the generated texts: it is asked before anything is written.
///
/// # Errors
///
/// Everything that is wrong with any vehicle, what `proof` finds, or the first file that cannot be written.
pub fn write_if(
    root: &Path,
    proof: impl FnOnce(&[(PathBuf, String)]) -> Result<(), Diagnostics>,
) -> Result<Vec<PathBuf>, Diagnostics> {
    let files = compile_all(root)?;
    let is_new =
        |(path, text): &&(PathBuf, String)| fs::read_to_string(root.join(path)).ok().as_ref() != Some(text);
    let changed: Vec<&(PathBuf, String)> = files.iter().filter(is_new).collect();
    let gone = leftovers(root, &files);
    if !changed.is_empty() {
        proof(&files)?;
    }
    let failed = |path: &Path, error: std::io::Error| {
        Diagnostics::one(&path.to_string_lossy(), 0, format!("cannot be written: {error}"))
    };
    let folder = Path::new(GENERATED);
    fs::create_dir_all(root.join(folder)).map_err(|error| failed(folder, error))?;
    // A disk that is full shows itself here, before the first file of the tree is touched.
    let new = |path: &Path| root.join(path).with_extension("rs.new");
    for (path, text) in &changed {
        if let Err(error) = fs::write(new(path), text) {
            changed.iter().for_each(|(path, _)| drop(fs::remove_file(new(path))));
            return Err(failed(path, error));
        }
    }
    // `mod.rs` comes last and removals behind it: broken off in between, the tree still builds.
    let is_list = |path: &Path| path.ends_with("mod.rs");
    let (lists, vehicles): (Vec<_>, Vec<_>) = changed.into_iter().partition(|(path, _)| is_list(path));
    let mut written = Vec::new();
    for (path, _) in vehicles.into_iter().chain(lists) {
        fs::rename(new(path), root.join(path)).map_err(|error| failed(path, error))?;
        written.push(path.clone());
    }
    for path in gone {
        fs::remove_file(root.join(&path)).map_err(|error| failed(&path, error))?;
        written.push(path);
    }
    Ok(written)
}

/// Checks that the generated files are what the vehicles give.
///
/// # Errors
///
/// Everything that is wrong with any vehicle, or each file that differs, with the command that refreshes it.
pub fn check(root: &Path) -> Result<(), Diagnostics> {
    let files = compile_all(root)?;
    let mut wrong = Diagnostics::default();
    let mut note = |path: &Path, line, message: &str| {
        let message = format!("{message}: run `cargo xtask codegen` and commit the result");
        wrong.0.push(Diagnostic::new(&path.to_string_lossy(), line, message));
    };
    for (path, text) in &files {
        match fs::read_to_string(root.join(path)) {
            Ok(old) if old == *text => {}
            Ok(old) => {
                let line = old.lines().zip(text.lines()).take_while(|(old, new)| old == new).count() + 1;
                note(path, line, "differs from what its vehicle gives");
            }
            Err(_) => note(path, 0, "is missing"),
        }
    }
    for path in leftovers(root, &files) {
        note(&path, 0, "belongs to no vehicle");
    }
    wrong.or(())
}
