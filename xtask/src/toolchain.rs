//! Finds or installs a compiler for the chip: `thumbv6m-none-eabi`.
//!
//! Three ways, tried in this order: the target's standard library is there already; rustup adds it; the distribution's
//! compiler builds `core` and `alloc` from its source package (`-Z build-std`). Says what it does.

use crate::out::note;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The Cortex-M0+ target.
pub const TARGET: &str = "thumbv6m-none-eabi";

/// How code for the chip is compiled here.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Toolchain {
    /// The target's `core` is installed beside the compiler.
    Installed,
    /// `core` is built from source by this cargo and rustc.
    BuildStd {
        /// The distribution's cargo.
        cargo: PathBuf,
        /// The distribution's rustc.
        rustc: PathBuf,
        /// A linker that knows ARM: `rust-lld` or `ld.lld`.
        linker: String,
    },
}

/// What to type when no compiler for the chip can be had.
const ADVICE: &str = "no compiler for thumbv6m-none-eabi. With rustup: `rustup target add thumbv6m-none-eabi`. \
                      On Debian without rustup: `apt-get install rustc-web cargo-web rust-web-src lld`.";

impl Toolchain {
    /// Finds a way to compile for the chip and installs the target by rustup if that is all that is missing.
    ///
    /// # Errors
    /// If there is no way here; the message says what to type.
    pub fn find_or_install() -> Result<Self> {
        if let Some(found) = Self::find() {
            return Ok(found);
        }
        if workspace::has("rustup") {
            note!("installing the chip's target: rustup target add {TARGET}");
            match workspace::run(Command::new("rustup").args(["target", "add", TARGET])) {
                Ok(()) => return Ok(Self::Installed),
                Err(error) => {
                    note!("rustup could not: {error:#}; looking for the distribution's compiler");
                }
            }
        }
        Self::find_distribution().context(ADVICE)
    }

    /// Finds a way to compile for the chip without installing anything.
    pub fn find() -> Option<Self> {
        let sysroot = sysroot(Path::new("rustc")).ok()?;
        if sysroot.join("lib/rustlib").join(TARGET).join("lib").is_dir() {
            return Some(Self::Installed);
        }
        if workspace::has("rustup") { None } else { Self::find_distribution().ok() }
    }

    /// Finds a compiler whose source package is installed.
    fn find_distribution() -> Result<Self> {
        for (cargo, rustc) in
            [("/usr/bin/cargo", "/usr/bin/rustc"), ("/usr/bin/cargo-web", "/usr/bin/rustc-web")]
        {
            let (cargo, rustc) = (PathBuf::from(cargo), PathBuf::from(rustc));
            let Ok(sysroot) = sysroot(&rustc) else { continue };
            if !cargo.exists() || !sysroot.join("lib/rustlib/src/rust/library/core").is_dir() {
                continue;
            }
            let linker = ["rust-lld", "ld.lld"].into_iter().find(|name| workspace::has(name));
            let Some(linker) = linker else {
                bail!(
                    "found {} and its sources, but no linker for ARM: `apt-get install lld`",
                    rustc.display()
                )
            };
            return Ok(Self::BuildStd { cargo, rustc, linker: linker.to_owned() });
        }
        bail!("no distribution compiler with its source package found")
    }

    /// Returns a cargo command that compiles for the chip when `--target` is passed.
    pub fn cargo(&self) -> Command {
        match self {
            Self::Installed => workspace::cargo(),
            Self::BuildStd { cargo, rustc, linker } => {
                let mut command = Command::new(cargo);
                command.current_dir(workspace::root());
                command.env("RUSTC", rustc).env("RUSTC_BOOTSTRAP", "1").env_remove("RUSTUP_TOOLCHAIN");
                command.env("CARGO_TARGET_THUMBV6M_NONE_EABI_LINKER", linker);
                command
            }
        }
    }

    /// Returns the arguments that follow the sub-command.
    pub fn arguments(&self) -> &'static [&'static str] {
        match self {
            Self::Installed => &[],
            Self::BuildStd { .. } => &["-Z", "build-std=core,alloc"],
        }
    }
}

/// Shows which way is taken.
impl std::fmt::Display for Toolchain {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Installed => write!(f, "{TARGET} is installed"),
            Self::BuildStd { rustc, linker, .. } => {
                write!(f, "{TARGET} is built from source by {} with {linker}", rustc.display())
            }
        }
    }
}

/// Returns the folder of what belongs to the compiler and the machine it runs on: libraries, LLVM's tools.
///
/// # Errors
/// If the compiler cannot be asked.
pub fn host_libraries() -> Result<PathBuf> {
    let mut command = Command::new("rustc");
    let version = workspace::capture(command.current_dir(workspace::root()).arg("-vV"))?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).context("rustc names no host")?;
    Ok(sysroot(Path::new("rustc"))?.join("lib/rustlib").join(host))
}

fn sysroot(rustc: &Path) -> Result<PathBuf> {
    let mut command = Command::new(rustc);
    command.current_dir(workspace::root()).args(["--print", "sysroot"]);
    Ok(PathBuf::from(workspace::capture(&mut command)?.trim()))
}
