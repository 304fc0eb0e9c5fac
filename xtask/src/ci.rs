//! Everything that CI runs; what is not in here is not a rule.

use crate::out::say;
use crate::steps::{Outcome, Steps};
use crate::{
    codecs, codegen, coverage, cuts, dbc, figures, firmware, flash, layers, reference, rules, run, scenario,
    screens, tasks, test, toolchain, workspace,
};
use anyhow::{Context, Result, bail};
use std::process::Command;

/// Runs all checks, all tests and the bench, and sums up.
///
/// # Errors
/// If any step failed.
pub fn run() -> Result<()> {
    let mut steps = Steps::default();
    steps.run("tools that the tests ask for a second opinion", install_tools)?;
    steps.run("fmt", || workspace::run(workspace::cargo().args(["fmt", "--all", "--check"])))?;
    steps.run("layers", layers::run)?;
    steps.run("generated codecs are up to date", || codegen::run(&codegen::Options { check: true }))?;
    steps.run("reference pages are up to date", || reference::run(&reference::Options { check: true }))?;
    steps.run("every rule of the documents is shown", || rules::run(&rules::Options { check: true }))?;
    steps.run("DBC files are clean", || dbc::run(&dbc::Options::default()))?;
    steps.run("clippy on the PC", || clippy(workspace::cargo(), &[], &["--all-targets"]))?;
    steps.run("clippy for the chip", || {
        let toolchain = toolchain::Toolchain::find_or_install()?;
        let target = ["--target", toolchain::TARGET, "--package", "firmware", "--package", "pico"];
        let target: Vec<&str> = target.iter().chain(toolchain.arguments()).copied().collect();
        clippy(toolchain.cargo(), &target, &[])
    })?;
    steps.try_run("licences, bans and sources", deny)?;
    steps.try_run("advisories", advisories)?;
    test::run_steps(&mut steps, &[])?;
    steps.try_run("every line of the cluster is tested", || {
        coverage::measure(&coverage::Options { check: true })
    })?;
    steps.run("screens", || screens::run(&screens::Options::default()))?;
    steps
        .run("scenarios on the host and on the firmware", || scenario::run(&scenario::Options::default()))?;
    steps.run("power cut at every byte", || cuts::run(&cuts::Options::default()))?;
    steps.run("size", || firmware::size(&firmware::Options::default()))?;
    steps.run("table of the firmware's tasks", || tasks::run(&tasks::Options { check: true }))?;
    steps.run("run --headless", || run::headless_for_ci(&crate::output_folder()?.join("drive.png")))?;
    steps.run("figures in the README", || figures::run(&figures::Options { check: true }))?;
    steps
        .try_run("codec costs in the docs", || codecs::measure_and_quote(&codecs::Options { check: true }))?;
    steps.run("flash to a board's drive", flash::check)?;
    steps.finish()
}

fn clippy(mut cargo: Command, before: &[&str], after: &[&str]) -> Result<()> {
    workspace::run(cargo.args(["clippy", "--quiet"]).args(before).args(after).args(["--", "-D", "warnings"]))
}

/// A program that a test needs: its names, and Debian's package of it.
struct Tool {
    names: &'static [&'static str],
    package: &'static str,
}

/// What the tests need beside Rust and Python.
const TOOLS: &[Tool] = &[
    Tool { names: &["qemu-system-arm"], package: "qemu-system-arm" },
    Tool { names: &["node"], package: "nodejs" },
    Tool { names: &["chromium", "chromium-browser", "google-chrome"], package: "chromium" },
];

/// Installs what a fresh CI machine lacks; on a person's machine it only says what to type.
fn install_tools() -> Result<()> {
    let is_missing = |tool: &&Tool| !tool.names.iter().copied().any(workspace::has);
    let missing: Vec<&str> = TOOLS.iter().filter(is_missing).map(|tool| tool.package).collect();
    if missing.is_empty() {
        say!("{} are here", TOOLS.iter().map(|tool| tool.package).collect::<Vec<_>>().join(", "))?;
        return Ok(());
    }
    let advice = format!("`apt-get install {}`", missing.join(" "));
    if !workspace::is_ci() {
        say!("the tests that need {} will be skipped: {advice}", missing.join(", "))?;
        return Ok(());
    }
    let apt = |arguments: &[&str]| {
        let mut command = Command::new("apt-get");
        workspace::run(command.env("DEBIAN_FRONTEND", "noninteractive").arg("-qq").args(arguments))
    };
    let install: Vec<&str> =
        ["install", "-y", "--no-install-recommends"].into_iter().chain(missing).collect();
    apt(&["update"]).and_then(|()| apt(&install)).with_context(|| format!("cannot install; type {advice}"))
}

fn deny() -> Result<Outcome> {
    if !workspace::has("cargo-deny") {
        if !workspace::is_ci() {
            return Ok(Outcome::Skipped(NO_CARGO_DENY.into()));
        }
        workspace::run(workspace::cargo().args(["install", "--quiet", "--locked", "cargo-deny"]))?;
    }
    let mut checks = workspace::cargo();
    workspace::run(checks.args(["deny", "--all-features", "check", "licenses", "bans", "sources"]))?;
    Ok(Outcome::Done)
}

/// Asks the advisory database, which is on the network.
fn advisories() -> Result<Outcome> {
    if !workspace::has("cargo-deny") {
        return Ok(Outcome::Skipped(NO_CARGO_DENY.into()));
    }
    match workspace::capture(workspace::cargo().args(["deny", "check", "advisories"])) {
        Ok(_) => Ok(Outcome::Done),
        Err(error) if format!("{error:#}").contains("failed to fetch advisory database") => {
            Ok(Outcome::Unreachable("the advisory database cannot be reached from here".into()))
        }
        Err(error) => bail!("{error:#}"),
    }
}

const NO_CARGO_DENY: &str = "cargo-deny is missing: `cargo install --locked cargo-deny`";
