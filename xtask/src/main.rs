//! The one command line of this repository: `cargo xtask --help`.
//!
//! Everything a person or CI does goes through here. Each step prints its name; failures are collected and every one
//! names its fix.

#![allow(unreachable_pub, reason = "in a binary every `pub` is private to it")]
#![deny(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "they panic in a closed pipe: `out::say!`, `out::note!`"
)]

mod ci;
mod codecs;
mod codegen;
mod convert;
mod corpus;
mod coverage;
mod cuts;
mod dbc;
mod decode;
mod doctor;
mod encode;
mod faces;
mod figures;
mod firmware;
mod flash;
mod known;
mod layers;
mod listen;
mod out;
mod output;
mod python;
mod recording;
mod reference;
mod release;
mod replay;
mod rooms;
mod rules;
mod run;
mod scenario;
mod screens;
mod site;
mod steps;
mod store;
mod tasks;
mod test;
mod tokens;
mod toolchain;
mod uf2;
mod vehicle;
mod vehicle_new;
mod vehicles;
mod words;
mod workspace;

use anyhow::Result;
use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

/// Builds, runs, flashes and tests the instrument cluster.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", version, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Builds the firmware, drives it on the virtual bench and shows the cluster on a local page.
    Run(run::Options),
    /// Plays the virtual vehicle on a real CAN adapter, for a cluster on the desk; `vehicle new` makes one of a DBC file.
    Vehicle(vehicle::Options),
    /// Runs every test: host tests, witnesses and the firmware on the bench.
    Test(test::Options),
    /// Builds the firmware for the board: ELF and UF2, with size and budget lines.
    Build(firmware::Options),
    /// Writes the firmware to a board: by debug probe, by picotool or by the BOOTSEL drive, whichever is there.
    Flash(flash::Options),
    /// Runs scenario files against the cluster's logic and the real firmware, and names every expectation that fails.
    Scenario(scenario::Options),
    /// Plays a recording through the cluster's logic and prints what it shows, as text or as JSON lines.
    Replay(replay::Options),
    /// Decodes a recording or a live bus to signals, as text, JSON lines or CSV.
    Decode(decode::Options),
    /// Writes a recording in another form: candump, Vector ASC or python-can's CSV.
    Convert(convert::Options),
    /// Reads a folder of other people's files and prints what became of each, beside an independent reader.
    Corpus(corpus::Options),
    /// Makes the frame of a message from the values of its signals.
    Encode(encode::Options),
    /// Lints DBC files and names file and line of everything that is wrong or missing.
    Dbc(dbc::Options),
    /// Compares every screen with its golden picture, or blesses the new ones.
    Screens(screens::Options),
    /// Rasterises the fonts and symbols that the screens use.
    Fonts,
    /// Generates the codecs from the vehicles' DBC and TOML files.
    Codegen(codegen::Options),
    /// Measures the generated codecs on the emulated core beside dbc-codegen and cantools' C.
    Codecs(codecs::Options),
    /// Generates the reference pages of the vehicles' messages, values and faults.
    Reference(reference::Options),
    /// Maps every rule of the source documents to the tests that name it, and fails on one of the cluster without any.
    Rules(rules::Options),
    /// Measures which lines of the logic crates their tests reach; with `--check`, all of the cluster's must be.
    Coverage(coverage::Options),
    /// Prints flash and RAM of the firmware by section and checks the board's budgets.
    Size(firmware::Options),
    /// Prints the records that a cluster sends on its UART.
    Listen(listen::Options),
    /// Checks that the crates' dependency arrows point down only.
    Layers,
    /// Writes the table of the firmware's tasks from their attributes and from what the bench measures of each.
    Tasks(tasks::Options),
    /// Measures the firmware on the bench and prints the figures that the README quotes.
    Figures(figures::Options),
    /// Puts a release together: images, site, one-file bench, changes and checksums
    Release(release::Options),
    /// Builds the bench as a page that needs no server: a static folder, or one HTML file
    Site(site::Options),
    /// Cuts the power at every byte of a life of the store, and again in every recovery, and compares what is kept.
    Cuts(cuts::Options),
    /// Prints what a cluster keeps over power-off, out of an image of its flash; a workshop sets the odometer here.
    Store(store::Options),
    /// Shows what this machine has, what is missing and what to type.
    Doctor,
    /// Runs everything that CI runs.
    Ci,
}

impl Command {
    /// Returns whether the command works on the repository's files; without them it could only fail later.
    fn needs_checkout(&self) -> bool {
        let works_anywhere = matches!(
            self,
            Self::Vehicle(_)
                | Self::Replay(_)
                | Self::Decode(_)
                | Self::Convert(_)
                | Self::Encode(_)
                | Self::Listen(_)
        );
        !works_anywhere
    }
}

fn main() -> ExitCode {
    let command = Cli::parse().command;
    let checkout = if command.needs_checkout() { workspace::check() } else { Ok(()) };
    match checkout.and_then(|()| dispatch(command)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => out::exit_code(&error),
    }
}

fn dispatch(command: Command) -> Result<()> {
    match command {
        Command::Run(options) => run::run(&options),
        Command::Vehicle(options) => vehicle::run(&options),
        Command::Test(options) => test::run(&options),
        Command::Build(options) => firmware::build_and_report(&options).map(drop),
        Command::Flash(options) => flash::run(&options),
        Command::Scenario(options) => scenario::run(&options),
        Command::Replay(options) => replay::run(&options),
        Command::Decode(options) => decode::run(&options),
        Command::Convert(options) => convert::run(&options),
        Command::Corpus(options) => corpus::run(&options),
        Command::Encode(options) => encode::run(&options),
        Command::Dbc(options) => dbc::run(&options),
        Command::Screens(options) => screens::run(&options),
        Command::Fonts => screens::fonts(),
        Command::Codegen(options) => codegen::run(&options),
        Command::Codecs(options) => codecs::run(&options),
        Command::Reference(options) => reference::run(&options),
        Command::Rules(options) => rules::run(&options),
        Command::Coverage(options) => coverage::run(&options),
        Command::Size(options) => firmware::size(&options),
        Command::Listen(options) => listen::run(&options),
        Command::Layers => layers::run(),
        Command::Tasks(options) => tasks::run(&options),
        Command::Figures(options) => figures::run(&options),
        Command::Release(options) => release::run(&options),
        Command::Site(options) => site::run(&options),
        Command::Cuts(options) => cuts::run(&options),
        Command::Store(options) => store::run(&options),
        Command::Doctor => doctor::run(),
        Command::Ci => ci::run(),
    }
}

/// Where a command puts files that are not for the repository.
fn output_folder() -> Result<PathBuf> {
    let folder = workspace::root().join("target/out");
    std::fs::create_dir_all(&folder)?;
    Ok(folder)
}
