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
        use firmware::Panel::{Ili9341, St7789};
        for (panel, vehicle) in [(Ili9341, Some("example")), (St7789, None), (Ili9341, None)] {
            let vehicle = vehicle.map(str::to_owned);
            elfs.push(
                firmware::build(&firmware::Options { panel, vehicle, ..firmware::Options::default() })?.elf,
            );
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
        if let [example, st7789, ili9341] = &elfs[..] {
            command.env("CLUSTER_ELF", ili9341).env("CLUSTER_ELF_ST7789", st7789);
            command.env("CLUSTER_ELF_EXAMPLE", example);
        }
        workspace::run(&mut command)
    });
}
