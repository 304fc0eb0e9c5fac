//! The programs of `bench/codec-cost`: how they are built and how large they are.

use crate::toolchain::{TARGET, Toolchain};
use crate::{python, workspace};
use anyhow::{Context, Result};
use object::{Object, ObjectSection};
use std::path::{Path, PathBuf};
use std::process::Command;

const MANIFEST: &str = "bench/codec-cost/Cargo.toml";
const GCC: &str = "arm-none-eabi-gcc";

/// How the compiler was asked to optimise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Level {
    /// Cargo profile of the programs.
    pub profile: &'static str,
    /// `opt-level`.
    pub name: &'static str,
}

/// As the firmware, and for speed.
pub const LEVELS: [Level; 2] = [Level { profile: "small", name: "s" }, Level { profile: "fast", name: "3" }];

/// Where the programs were built, and whether cantools' is among them.
pub struct Programs {
    folder: PathBuf,
    /// The C compiler's version; `None` = there is none here, and no program of cantools' C.
    pub gcc: Option<String>,
}

impl Programs {
    /// Builds all programs at all levels.
    ///
    /// # Errors
    /// If there is no compiler for the chip or something does not compile.
    pub fn build() -> Result<Self> {
        let toolchain = Toolchain::find_or_install()?;
        let folder = workspace::target().join("codec-cost");
        let gcc = version(Command::new(GCC).arg("-dumpfullversion")).ok();
        for level in LEVELS {
            let mut command = toolchain.cargo();
            command.args([
                "build",
                "--quiet",
                "--locked",
                "--manifest-path",
                MANIFEST,
                "--bins",
                "--target",
                TARGET,
            ]);
            command.args(["--profile", level.profile, "--target-dir"]).arg(&folder);
            if gcc.is_some() {
                command.args(["--features", "cantools"]).env("CANTOOLS_C", cantools_c(&folder)?);
            }
            workspace::run(command.args(toolchain.arguments()))?;
        }
        Ok(Self { folder, gcc })
    }

    /// Reads a program.
    ///
    /// # Errors
    /// If it was not built.
    pub fn read(&self, level: Level, name: &str) -> Result<Vec<u8>> {
        let path = self.folder.join(TARGET).join(level.profile).join(name);
        std::fs::read(&path).with_context(|| format!("the build left no {}", path.display()))
    }

    /// Returns the bytes of code and constants that a program has beyond the empty one.
    ///
    /// # Errors
    /// If one of the two cannot be read.
    pub fn size(&self, level: Level, name: &str) -> Result<u64> {
        Ok(flash(&self.read(level, name)?)?.saturating_sub(flash(&self.read(level, "empty")?)?))
    }

    /// Returns the line that says what compiled the programs.
    ///
    /// # Errors
    /// If the compiler or the lock file cannot be read.
    pub fn origin(&self) -> Result<String> {
        let rustc = version(workspace_rustc().arg("--version"))?;
        let rustc: Vec<&str> = rustc.split(' ').take(2).collect();
        let lock = std::fs::read_to_string(workspace::root().join("bench/codec-cost/Cargo.lock"))?;
        let codegen =
            lock.split("name = \"dbc-codegen\"\nversion = \"").nth(1).and_then(|rest| rest.split('"').next());
        let codegen = codegen.context("bench/codec-cost/Cargo.lock has no dbc-codegen")?;
        Ok(format!("{}, dbc-codegen {codegen}", rustc.join(" ")))
    }
}

fn workspace_rustc() -> Command {
    let mut command = Command::new("rustc");
    command.current_dir(workspace::root());
    command
}

fn version(command: &mut Command) -> Result<String> {
    Ok(workspace::capture(command)?.trim().to_owned())
}

/// Lets cantools write its C and returns the folder.
fn cantools_c(folder: &Path) -> Result<PathBuf> {
    let folder = folder.join("cantools");
    std::fs::create_dir_all(&folder)?;
    let dbc = workspace::root().join("vehicles/citybus/citybus.dbc");
    let mut command = Command::new(python::witness()?);
    command.args(["-m", "cantools", "generate_c_source", "--no-floating-point-numbers"]);
    workspace::capture(command.arg("--output-directory").arg(&folder).arg(dbc))?;
    Ok(folder)
}

fn flash(elf: &[u8]) -> Result<u64> {
    let file = object::File::parse(elf)?;
    let sections = [".text", ".rodata", ".data"];
    Ok(sections.iter().filter_map(|name| file.section_by_name(name)).map(|section| section.size()).sum())
}

/// Returns the messages of the mix with their bound signals, as the programs name them.
///
/// # Errors
/// If the program does not name them.
pub fn mix(elf: &[u8]) -> Result<Vec<(String, Vec<String>)>> {
    let file = object::File::parse(elf)?;
    let section = file.section_by_name(".mix").context("the program names no messages")?;
    let text = std::str::from_utf8(section.data()?)?;
    let row = |line: &str| {
        let mut words = line.split(' ').map(str::to_owned);
        (words.next().unwrap_or_default(), words.collect())
    };
    Ok(text.lines().map(row).collect())
}

/// Decodes the frames of a file on the PC by both decoders: frames per second, ours and cantools'.
///
/// # Errors
/// If one of the two fails.
pub fn throughput(frames: &Path) -> Result<(f64, f64)> {
    let mut ours = workspace::cargo();
    ours.args([
        "run",
        "--quiet",
        "--locked",
        "--manifest-path",
        MANIFEST,
        "--example",
        "throughput",
        "--target-dir",
    ]);
    ours.arg(workspace::target().join("codec-cost")).args(["--profile", "fast", "--"]).arg(frames);
    let mut theirs = Command::new(python::witness()?);
    theirs.current_dir(workspace::root()).arg("tools/witness/codec_throughput.py");
    theirs.arg("vehicles/citybus/citybus.dbc").arg(frames);
    let figure = |command: &mut Command| -> Result<f64> { Ok(workspace::capture(command)?.trim().parse()?) };
    Ok((figure(&mut ours)?, figure(&mut theirs)?))
}
