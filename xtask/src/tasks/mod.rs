//! The table of tasks at the top of the firmware's `main.rs`.
//!
//! Names, triggers, priorities and resources come from the tasks' attributes, times and stack from a run of the image
//! on the bench. Refuses to change anything else in that file.

mod measure;
mod source;
mod table;

use crate::out::say;
use crate::{firmware, workspace};
use anyhow::{Context, Result, anyhow, ensure};
use clap::Args;
use source::App;
use std::process::Command;
use table::{BEGIN, END, Table};

/// What to do with the table.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Fails if the table says something else, or something takes longer than it says.
    #[arg(long)]
    pub check: bool,
}

const MAIN: &str = "app/firmware/src/main.rs";
const CITY: &str = "vehicles/citybus/captures/city.log";

/// Writes the table, or checks that it holds.
///
/// # Errors
/// If the firmware cannot be built or run, the table does not hold, or the stack leaves less than a quarter of its
/// budget.
pub fn run(options: &Options) -> Result<()> {
    let path = workspace::root().join(MAIN);
    let app = App::read(&path)?;
    let elf = firmware::build(&firmware::Options::default())?.elf;
    let measured = measure::run(&elf, &workspace::root().join(CITY))?;
    let lowest = measured.start.lowest_stack.min(measured.later.lowest_stack);
    let stack = firmware::stack_top(&elf)?.saturating_sub(lowest.into());
    let compiler = workspace::capture(Command::new("rustc").arg("--version"))?;
    let compiler = compiler.split(" (").next().unwrap_or_default();
    let table = Table::new(&app, &measured, stack, compiler).with_context(|| MAIN)?;

    let source = std::fs::read_to_string(&path)?;
    let (head, rest) =
        source.split_once(BEGIN).with_context(|| format!("{MAIN} has no line `{}`", BEGIN.trim()))?;
    let (standing, tail) =
        rest.split_once(END).with_context(|| format!("{MAIN} has no line `{}`", END.trim()))?;
    say!("{}", table.text().trim_end())?;
    if options.check {
        let is_compared = table
            .check(standing, compiler)
            .map_err(|difference| anyhow!("{MAIN}: {difference}; `cargo xtask tasks` writes what is"))?;
        if !is_compared {
            say!("the table is of another compiler than {compiler}: times and stack not compared")?;
        }
    } else {
        std::fs::write(&path, format!("{head}{BEGIN}{}{END}{tail}", table.text()))?;
    }
    let budget = firmware::budget()?.stack;
    ensure!(
        stack * 4 <= budget * 3,
        "the stack took {stack} of {budget} bytes, and a quarter is to be free: save some, or raise `stack` in \
         [package.metadata.budget] of boards/pico/Cargo.toml and say why"
    );
    say!("stack: {stack} of {budget} bytes")?;
    Ok(())
}
