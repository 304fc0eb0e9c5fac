//! Runs every test, with what the tests need.

use crate::steps::Steps;
use crate::{firmware, python, workspace};
use anyhow::Result;
use clap::Args;

/// Which tests to run.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Passed on to `cargo test`: a package or a name to filter by.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<String>,
}

/// Builds the firmware for the bench, installs the witnesses and runs `cargo test`.
///
/// # Errors
/// If anything fails; all of it is run first.
pub fn run(options: &Options) -> Result<()> {
    let mut steps = Steps::default();
    run_steps(&mut steps, &options.arguments);
    steps.finish()
}

/// The steps of [`run`], for `ci` to run among its own.
pub fn run_steps(steps: &mut Steps, arguments: &[String]) {
    let mut elfs = Vec::new();
    steps.run("firmware for the bench", || {
        for panel in [firmware::Panel::Ili9341, firmware::Panel::St7789] {
            elfs.push(firmware::build(&firmware::Options { panel, ..firmware::Options::default() })?.elf);
        }
        Ok(())
    });
    let mut witness = None;
    steps.run("witnesses (cantools, python-can)", || {
        witness = Some(python::witness()?);
        Ok(())
    });
    steps.run("cargo test", || {
        let mut command = workspace::cargo();
        command.args(["test", "--quiet", "--no-fail-fast"]).args(arguments);
        // The witnesses say how much they have compared.
        if !arguments.iter().any(|argument| argument == "--") {
            command.args(["--", "--show-output"]);
        }
        if let Some(python) = &witness {
            command.env("WITNESS_PYTHON", python);
        }
        if let [ili9341, st7789] = &elfs[..] {
            command.env("CLUSTER_ELF", ili9341).env("CLUSTER_ELF_ST7789", st7789);
        }
        workspace::run(&mut command)
    });
}
