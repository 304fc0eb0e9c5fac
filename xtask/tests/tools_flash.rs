//! `cargo xtask flash`: what it would do, and what it refuses, without a board.

mod program;

use program::xtask;
use std::path::Path;
use std::process::Output;

fn flash(arguments: &[&str]) -> Output {
    xtask().arg("flash").args(arguments).output().unwrap()
}

fn complaint(arguments: &[&str]) -> String {
    let output = flash(arguments);
    assert_eq!(output.status.code(), Some(1), "{arguments:?} must fail: {output:?}");
    String::from_utf8(output.stderr).unwrap()
}

/// A folder that looks like the drive of a board in BOOTSEL mode.
fn drive() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let info = "UF2 Bootloader v3.0\nModel: Raspberry Pi RP2\nBoard-ID: RPI-RP2\n";
    std::fs::write(folder.path().join("INFO_UF2.TXT"), info).unwrap();
    folder
}

fn path(folder: &Path) -> &str {
    folder.to_str().unwrap()
}

#[test]
fn a_dry_run_says_what_would_be_done_and_does_nothing() {
    let drive = drive();
    let output = flash(&["--dry-run", "--drive", path(drive.path())]);
    assert!(output.status.success(), "{output:?}");
    let said = String::from_utf8(output.stdout).unwrap();
    assert_eq!(said, format!("would copy the UF2 to {}\n", drive.path().display()));
    assert!(!drive.path().join("cluster.uf2").exists());
}

#[test]
fn a_dry_run_without_a_board_fails_as_the_real_one_does() {
    let empty = tempfile::tempdir().unwrap();
    for arguments in [&["--dry-run", "--drive", path(empty.path())][..], &["--drive", path(empty.path())]] {
        let said = complaint(arguments);
        assert!(said.contains("is not a BOOTSEL drive"), "{said}");
    }
}

#[test]
fn an_elf_that_cannot_be_flashed_is_refused_by_the_dry_run_too() {
    let drive = drive();
    let text = drive.path().join("notes.elf");
    std::fs::write(&text, "not an ELF").unwrap();
    for elf in ["/no/such.elf", path(&text)] {
        for dry_run in [&[][..], &["--dry-run"]] {
            let said = complaint(&[&["--drive", path(drive.path()), "--elf", elf], dry_run].concat());
            assert!(said.contains(elf), "{said}");
        }
    }
}
