//! A copied or moved checkout: what was built in the old one works on the new one.

mod program;

use program::xtask;
use std::path::Path;
use std::process::Command;

/// Makes a checkout with one vehicle, whose DBC has a finding.
fn copy() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for inside in ["protocol-core", "vehicles/scratch", "xtask"] {
        std::fs::create_dir_all(folder.path().join(inside)).unwrap();
    }
    std::fs::write(folder.path().join("protocol-core/Cargo.toml"), "").unwrap();
    std::fs::write(folder.path().join("vehicles/scratch/scratch.dbc"), "VERSION \"\"\nnot a DBC\n").unwrap();
    folder
}

#[test]
fn a_program_that_cargo_starts_works_on_the_checkout_that_cargo_names() {
    let copy = copy();
    let output = xtask().arg("dbc").env("CARGO_MANIFEST_DIR", copy.path().join("xtask")).output().unwrap();
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.starts_with("vehicles/scratch/scratch.dbc:2: "), "{said}");
    assert!(!said.contains("vehicles/citybus"), "{said}");
}

/// Starts the program as cargo does not, from `folder`.
fn stranger(folder: &Path, arguments: &[&str]) -> Command {
    let program = xtask().get_program().to_owned();
    let mut command = Command::new(program);
    command.current_dir(folder).args(arguments).env_remove("CARGO_MANIFEST_DIR");
    command
}

#[test]
fn without_cargo_it_is_the_checkout_that_was_compiled() {
    let elsewhere = tempfile::tempdir().unwrap();
    let output = stranger(elsewhere.path(), &["dbc"]).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    assert!(String::from_utf8(output.stdout).unwrap().contains("vehicles/citybus/citybus.dbc"));
}
