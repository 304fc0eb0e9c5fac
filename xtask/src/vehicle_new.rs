//! Makes the folder of a vehicle out of a DBC file: what can be proposed by names and units, and a drive to look at.
//!
//! Writes a new folder or nothing. What it proposes is for a person to read: it prints each binding with its signal.

use crate::out::say;
use crate::workspace;
use anyhow::{Context, Result, anyhow, bail};
use clap::Args;
use std::path::{Path, PathBuf};
use vehicle_compiler::{RunTime, proposal};

/// Seconds that the made drive lasts.
const DRIVE_S: u32 = 20;

/// What to make a vehicle of.
#[derive(Args, Clone, Debug)]
pub struct Options {
    /// DBC file, in whatever encoding.
    dbc: PathBuf,
    /// Name of the vehicle and its folder; the file's, in small letters, if not given.
    #[arg(long)]
    name: Option<String>,
    /// Where to make the folder; `vehicles/` of the repository if not given.
    #[arg(long, value_name = "FOLDER")]
    into: Option<PathBuf>,
}

/// Writes the folder and says what is bound and what comes next.
///
/// # Errors
/// If the file is no DBC, the name is none for a vehicle, or the folder is there already.
pub fn run(options: &Options) -> Result<()> {
    let name = match &options.name {
        Some(name) => name.clone(),
        None => name_of(&options.dbc)?,
    };
    if let Some(reason) = vehicle_compiler::wrong_folder(&name) {
        bail!("`{name}`: {reason}; say another with --name");
    }
    let folder = options.into.clone().unwrap_or_else(|| workspace::root().join("vehicles")).join(&name);
    if folder.exists() {
        bail!("{} is there already; say another name with --name", folder.display());
    }
    let proposed = proposal::of_file(&options.dbc, &name).map_err(|wrong| anyhow!("{wrong}"))?;
    let file = format!("{name}.dbc");
    let known = RunTime::of_texts(&name, (&file, &proposed.dbc), Some(("vehicle.toml", &proposed.toml)));
    let known = known.map_err(|wrong| anyhow!("{wrong}"))?;
    std::fs::create_dir_all(folder.join("captures"))
        .with_context(|| format!("{} cannot be made", folder.display()))?;
    for (path, text) in [
        (file.as_str(), proposed.dbc.as_str()),
        ("vehicle.toml", &proposed.toml),
        ("captures/sweep.log", &known.sweep(DRIVE_S)),
        (
            "captures/README.md",
            "`sweep.log` is made from the two files, not recorded: each bound value goes through its range.\n",
        ),
        (
            "README.md",
            &format!(
                "# {name}\n\nMade by `cargo xtask vehicle new`; what it is, its quirks, what is left out: not written yet.\n"
            ),
        ),
    ] {
        std::fs::write(folder.join(path), text)
            .with_context(|| format!("{} cannot be written", folder.join(path).display()))?;
    }
    if let Some(note) = &proposed.note {
        say!("{}: {note}; written as UTF-8", options.dbc.display())?;
    }
    say!("{}", folder.display())?;
    for (value, message, signal) in &proposed.bound {
        say!("  {:26} {message}.{signal}", value.path())?;
    }
    let shown = if options.into.is_some() { folder.display().to_string() } else { name.clone() };
    if proposed.bound.is_empty() {
        say!("nothing is bound: no signal has both a name and a unit (or words) of the commonest values")?;
    }
    say!("next: read {}/vehicle.toml, then", folder.display())?;
    say!("  cargo xtask replay --vehicle {shown} {}", folder.join("captures/sweep.log").display())?;
    if options.into.is_none() {
        say!("  cargo xtask codegen && cargo xtask run --log vehicles/{name}/captures/sweep.log")?;
    }
    Ok(())
}

/// Returns the name of a file in the letters that a folder may have.
fn name_of(path: &Path) -> Result<String> {
    let stem = path.file_stem().context("this is not the path of a file")?.to_string_lossy().to_lowercase();
    let plain = |letter: char| if letter.is_ascii_alphanumeric() { letter } else { '_' };
    let name: String = stem.chars().map(plain).collect();
    let name = name.trim_matches('_');
    Ok(if name.starts_with(|first: char| first.is_ascii_digit()) { format!("v{name}") } else { name.into() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_gives_its_name_in_the_letters_of_a_folder() {
        let of = |path: &str| name_of(Path::new(path)).expect("a name");
        assert_eq!(of("a/BMW-i3 PT.dbc"), "bmw_i3_pt");
        assert_eq!(of("4x4.DBC"), "v4x4");
    }
}
