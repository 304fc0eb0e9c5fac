//! Writes a recording in another form: candump, Vector ASC or python-can's CSV.
//!
//! Reads every format that the other commands read, in memory that does not grow. All channels are kept with their names
//! unless one is chosen; CSV has none, so a recording of several needs a choice there.

use crate::out::say;
use crate::output::Output;
use crate::recording::{Choices, say_notes};
use anyhow::{Context, Result, bail};
use bench::log::{Form, Writer};
use clap::{Args, ValueEnum};
use std::io::BufWriter;
use std::path::{Path, PathBuf};

/// What to convert into what.
#[derive(Args, Debug)]
pub struct Options {
    /// Recording in any of the formats of docs/reference/recordings.md.
    input: PathBuf,
    /// File to write; its ending says the form: .log (candump), .asc (Vector ASC), .csv (python-can).
    output: PathBuf,
    #[command(flatten)]
    choices: Choices,
    /// Form of the output, if its name does not say it.
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Replaces an output that is already there.
    #[arg(long)]
    overwrite: bool,
}

/// Form of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// `candump -l`.
    Candump,
    /// Vector ASC.
    Asc,
    /// The CSV of python-can.
    Csv,
}

/// Converts a recording.
///
/// # Errors
/// If it cannot be read, the output cannot be written, or would lose the channels.
pub fn run(options: &Options) -> Result<()> {
    let form = form(options)?;
    let output = Output::checked(&options.output, options.overwrite, &[&options.input])?;
    let keeps_channels = form != Form::Csv;
    let recording = options.choices.open_all(&options.input, keeps_channels)?;
    let channels: Vec<&str> = recording.channels().collect();
    let mut entries = recording.entries()?;
    let mut frames = 0;
    output.write_by(|file| {
        let mut writer = Writer::new(BufWriter::new(file), form, &channels);
        while let Some(entry) = entries.next().transpose()? {
            writer.write(entries.origin(), &entry)?;
            frames += 1;
        }
        Ok(writer.finish()?)
    })?;
    say_notes(&options.input, &entries.notes());
    say!("{}: {frames} frames ({})", options.output.display(), recording.format())?;
    Ok(())
}

fn form(options: &Options) -> Result<Form> {
    if let Some(format) = options.format {
        return Ok(match format {
            Format::Candump => Form::Candump,
            Format::Asc => Form::Asc,
            Format::Csv => Form::Csv,
        });
    }
    let ending = |path: &Path| Some(path.extension()?.to_str()?.to_ascii_lowercase());
    let ending = ending(&options.output).context("the output's name has no ending: say --format")?;
    let known = Form::ALL.into_iter().find(|form| form.extension() == ending);
    match known {
        Some(form) => Ok(form),
        None => bail!(".{ending} is no form that is written (.log, .asc, .csv): say --format"),
    }
}
