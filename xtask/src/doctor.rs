//! Shows what this machine has, what is missing and what to type.

use crate::out::say;
use crate::toolchain::{TARGET, Toolchain};
use crate::{python, workspace};
use anyhow::Result;
use std::process::Command;

/// Prints one line per tool.
///
/// # Errors
/// Never for a missing tool: that is a line.
pub fn run() -> Result<()> {
    let version = |program: &str| workspace::capture(Command::new(program).arg("--version")).ok();
    line("rustc", version("rustc").as_deref(), "needed: https://rustup.rs")?;
    let chip = Toolchain::find().map(|toolchain| toolchain.to_string());
    line(
        TARGET,
        chip.as_deref(),
        "`cargo xtask run` and `cargo xtask test` install it by rustup, or type `rustup target add thumbv6m-none-eabi`",
    )?;
    line(
        "python3",
        version("python3").as_deref(),
        "for the tests' second opinion: `apt-get install python3 python3-venv`",
    )?;
    let witnesses = python::is_ready().then_some("cantools and python-can in target/venv");
    line("cantools", witnesses, "`cargo xtask test` installs it into target/venv")?;
    line(
        "qemu-system-arm",
        version("qemu-system-arm").as_deref(),
        "second opinion on the emulated core: `apt-get install qemu-system-arm`",
    )?;
    line(
        "chromium",
        ["chromium", "chromium-browser", "google-chrome"].into_iter().find_map(version).as_deref(),
        "for the test of the page: `apt-get install chromium`, or its path in CHROME",
    )?;
    line(
        "node",
        version("node").as_deref(),
        "a second place for the bench in a browser: `apt-get install nodejs`",
    )?;
    line(
        "cargo-deny",
        version("cargo-deny").as_deref(),
        "licences and advisories: `cargo install --locked cargo-deny`",
    )?;
    line(
        "probe-rs",
        version("probe-rs").as_deref(),
        "optional, to flash by debug probe: `cargo install --locked probe-rs-tools`",
    )?;
    line(
        "picotool",
        version("picotool").as_deref(),
        "optional, to flash without the drive: `apt-get install picotool`",
    )?;
    Ok(())
}

fn line(name: &str, found: Option<&str>, missing: &str) -> std::io::Result<()> {
    match found {
        Some(found) => say!("ok       {name:22} {}", found.lines().next().unwrap_or_default()),
        None => say!("missing  {name:22} {missing}"),
    }
}
