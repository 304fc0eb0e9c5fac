//! The golden pictures of the screens, and the fonts and symbols they are made of.

use crate::workspace;
use anyhow::Result;
use clap::Args;

/// What to do with differences.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Takes the pictures drawn now as the new golden ones.
    #[arg(long)]
    pub bless: bool,
}

/// Draws every screen on the host and compares it with its golden picture.
///
/// # Errors
/// If a picture differs; the failure names the actual and the difference picture.
pub fn run(options: &Options) -> Result<()> {
    let mut command = workspace::cargo();
    command.args(["test", "--quiet", "--package", "ui", "--test", "screens"]);
    if options.bless {
        command.env("BLESS", "1");
    }
    workspace::run(&mut command)
}

/// Rasterises the fonts and symbols into app/ui/src/fonts.
///
/// # Errors
/// If a font is not installed; the message names its package.
pub fn fonts() -> Result<()> {
    workspace::run(workspace::cargo().args(["run", "--quiet", "--package", "fontgen"]))
}
