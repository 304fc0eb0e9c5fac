//! Writes the firmware to a board by whatever is there.
//!
//! A debug probe if probe-rs sees one, else a board in BOOTSEL mode by picotool, else its RPI-RP2 drive. With none of
//! them it says how to press BOOTSEL.

use crate::out::say;
use crate::{firmware, workspace};
use anyhow::{Context, Result, bail};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use std::fs::File;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

/// What to flash and how.
#[derive(Args, Debug)]
pub struct Options {
    #[command(flatten)]
    build: firmware::Options,
    /// Flashes this ELF in place of building the firmware.
    #[arg(long)]
    elf: Option<PathBuf>,
    /// Says what would be done, and does nothing.
    #[arg(long)]
    dry_run: bool,
    /// Writes to the BOOTSEL drive mounted at this folder.
    #[arg(long)]
    drive: Option<PathBuf>,
}

/// A way to write to the board.
#[derive(Debug, PartialEq, Eq)]
enum Way {
    Probe,
    Picotool,
    Drive(PathBuf),
}

/// What the board's drive says of itself.
const INFO_FILE: &str = "INFO_UF2.TXT";
/// The name of the image on the drive; the boot loader takes any.
const UF2_FILE: &str = "cluster.uf2";
const NO_BOARD: &str = "no board found. Hold BOOTSEL while you plug the Pico's USB cable in, then let go: a drive named \
                        RPI-RP2 appears; run the command again. With a debug probe: `cargo install probe-rs-tools`. \
                        If the drive is mounted in an unusual place: `--drive FOLDER`.";

/// Builds (unless an ELF is given) and flashes.
///
/// # Errors
/// If the build fails, no board is found, or writing fails.
pub fn run(options: &Options) -> Result<()> {
    if let Some(elf) = &options.elf {
        bench::rp2040::image::load_elf(elf)?;
    }
    let way = match &options.drive {
        Some(drive) => is_bootsel_drive(drive).then(|| Way::Drive(drive.clone())).with_context(|| {
            format!(
                "{} is not a BOOTSEL drive: it has no INFO_UF2.TXT that names the RP2040",
                drive.display()
            )
        }),
        None => find(),
    }?;
    if options.dry_run {
        match way {
            Way::Probe => say!("would flash by the debug probe: probe-rs download --chip RP2040")?,
            Way::Picotool => say!("would flash by picotool: picotool load -v -x")?,
            Way::Drive(drive) => say!("would copy the UF2 to {}", drive.display())?,
        }
        return Ok(());
    }
    let image = match &options.elf {
        Some(elf) => with_uf2(elf)?,
        None => firmware::build_and_report(&options.build)?,
    };
    match way {
        Way::Probe => {
            workspace::run(Command::new("probe-rs").args(["download", "--chip", "RP2040"]).arg(&image.elf))
                .and_then(|()| workspace::run(Command::new("probe-rs").args(["reset", "--chip", "RP2040"])))
        }
        Way::Picotool => {
            workspace::run(Command::new("picotool").args(["load", "-v", "-x", "-t", "uf2"]).arg(&image.uf2))
        }
        Way::Drive(drive) => copy(&image.uf2, &drive),
    }
}

/// Flashes a folder that looks like a board's drive and looks at what has arrived, for `ci`.
///
/// # Errors
/// Like [`run`], or if something else than the image has arrived.
pub fn check() -> Result<()> {
    let image = firmware::build(&firmware::Options::default())?;
    let drive = crate::output_folder()?.join("bootsel-drive");
    std::fs::create_dir_all(&drive)?;
    std::fs::write(
        drive.join(INFO_FILE),
        "UF2 Bootloader v3.0\nModel: Raspberry Pi RP2\nBoard-ID: RPI-RP2\n",
    )?;
    let (build, elf) = (firmware::Options::default(), Some(image.elf));
    run(&Options { build, elf, dry_run: false, drive: Some(drive.clone()) })?;
    if std::fs::read(drive.join(UF2_FILE))? != std::fs::read(&image.uf2)? {
        bail!("{} is not the image in {}", drive.join(UF2_FILE).display(), image.uf2.display());
    }
    Ok(())
}

fn with_uf2(elf: &Path) -> Result<firmware::Image> {
    let uf2 = elf.with_extension("uf2");
    std::fs::write(&uf2, crate::uf2::encode(&bench::rp2040::image::load_elf(elf)?, 0x1000_0000))?;
    Ok(firmware::Image { elf: elf.to_owned(), uf2 })
}

fn find() -> Result<Way> {
    if let Ok(list) = workspace::capture(Command::new("probe-rs").arg("list"))
        && !list.contains("No debug probes")
    {
        return Ok(Way::Probe);
    }
    if workspace::capture(Command::new("picotool").arg("info")).is_ok() {
        return Ok(Way::Picotool);
    }
    find_drive(drives())
}

/// Returns the first of the folders that is a board's drive.
fn find_drive(folders: Vec<PathBuf>) -> Result<Way> {
    folders.into_iter().find(|folder| is_bootsel_drive(folder)).map(Way::Drive).context(NO_BOARD)
}

/// Returns every folder where an operating system may have mounted the drive.
fn drives() -> Vec<PathBuf> {
    let mut parents = vec![PathBuf::from("/media"), PathBuf::from("/Volumes"), PathBuf::from("/mnt")];
    for parent in ["/media", "/run/media"] {
        parents.extend(std::fs::read_dir(parent).into_iter().flatten().flatten().map(|entry| entry.path()));
    }
    let letters = ('D'..='Z').map(|letter| PathBuf::from(format!("{letter}:\\")));
    parents.into_iter().map(|parent| parent.join("RPI-RP2")).chain(letters).collect()
}

fn is_bootsel_drive(folder: &Path) -> bool {
    std::fs::read_to_string(folder.join(INFO_FILE)).is_ok_and(|info| info.contains("RPI-RP2"))
}

fn copy(uf2: &Path, drive: &Path) -> Result<()> {
    let bytes = std::fs::read(uf2)?;
    let bar = ProgressBar::new(bytes.len() as u64);
    bar.set_style(ProgressStyle::with_template("{bar:40} {bytes}/{total_bytes}")?);
    let mut to =
        File::create(drive.join(UF2_FILE)).with_context(|| format!("cannot write to {}", drive.display()))?;
    let mut from = &*bytes;
    let mut chunk = [0; 16 * 1024];
    loop {
        let length = from.read(&mut chunk)?;
        if length == 0 {
            break;
        }
        to.write_all(&chunk[..length])?;
        bar.inc(length as u64);
    }
    // The boot loader resets into the new firmware with the last block: the drive vanishes under our feet.
    let _ = to.sync_all();
    bar.finish();
    let written = std::fs::metadata(drive.join(UF2_FILE)).map_or(bytes.len() as u64, |file| file.len());
    if written != bytes.len() as u64 {
        bail!(
            "only {written} of {} bytes were written; unplug the board, hold BOOTSEL and try again",
            bytes.len()
        );
    }
    say!("flashed; the board restarts by itself")?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_the_boards_drive_only_if_its_info_file_says_so() {
        let folder = tempfile::tempdir().unwrap();
        assert!(!is_bootsel_drive(folder.path()));
        std::fs::write(folder.path().join("INFO_UF2.TXT"), "Board-ID: SAMD51").unwrap();
        assert!(!is_bootsel_drive(folder.path()));
        let info = "UF2 Bootloader v3.0\nModel: Raspberry Pi RP2\nBoard-ID: RPI-RP2\n";
        std::fs::write(folder.path().join("INFO_UF2.TXT"), info).unwrap();
        assert!(is_bootsel_drive(folder.path()));
    }

    #[test]
    fn the_uf2_arrives_whole_on_the_drive() {
        let folder = tempfile::tempdir().unwrap();
        let uf2 = folder.path().join("image.uf2");
        let bytes: Vec<u8> = (0..100_000u32).map(|n| (n * 31) as u8).collect();
        std::fs::write(&uf2, &bytes).unwrap();
        let drive = tempfile::tempdir().unwrap();
        copy(&uf2, drive.path()).unwrap();
        assert_eq!(std::fs::read(drive.path().join(UF2_FILE)).unwrap(), bytes);
    }

    #[test]
    fn without_a_board_the_error_says_how_to_press_bootsel() {
        let empty = tempfile::tempdir().unwrap();
        let error = find_drive(vec![empty.path().to_owned()]).unwrap_err();
        assert!(error.to_string().contains("Hold BOOTSEL while you plug"), "{error}");
        std::fs::write(empty.path().join(INFO_FILE), "Board-ID: RPI-RP2\n").unwrap();
        let found = find_drive(vec![PathBuf::from("/no/such"), empty.path().to_owned()]).unwrap();
        assert_eq!(found, Way::Drive(empty.path().to_owned()));
    }
}
