//! The made-up vehicles of protocol-core's tests: their generated files are what the generator writes today.

use std::fs;

/// Compares the generated file of `protocol-core/tests/<folder>/<name>.dbc` with the committed one.
fn is_generated_as_committed(folder: &str, name: &str) {
    let folder = surroundings::root().join("protocol-core/tests").join(folder);
    let read = |file: &str| fs::read_to_string(folder.join(file)).expect("the file is there");
    let dbc_name = format!("{name}.dbc");
    let (dbc, toml) = (read(&dbc_name), read("vehicle.toml"));
    let compile = || vehicle_compiler::compile(name, (&dbc_name, &dbc), ("vehicle.toml", &toml));
    let text = compile().unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(compile().as_ref(), Ok(&text), "the same folder gives the same bytes");
    let committed = folder.join(format!("{name}.rs"));
    if std::env::var_os("BLESS").is_some() {
        fs::write(&committed, &text).expect("the file can be written");
    }
    let same = fs::read_to_string(&committed).is_ok_and(|old| old == text);
    assert!(same, "{name}.rs differs: `BLESS=1 cargo test -p vehicle-compiler` refreshes it");
}

#[test]
fn the_torture_vehicle_is_generated_as_committed() {
    is_generated_as_committed("codec_torture", "torture");
}

#[test]
fn the_hostile_vehicle_is_generated_as_committed_and_has_no_findings() {
    is_generated_as_committed("hostile", "hostile");
    let folder = surroundings::root().join("protocol-core/tests/hostile");
    let dbc = fs::read_to_string(folder.join("hostile.dbc")).expect("the file is there");
    assert_eq!(vehicle_compiler::lint::lint("hostile.dbc", &dbc).to_string(), "");
}

#[test]
fn the_wide_vehicle_is_generated_as_committed() {
    is_generated_as_committed("wide", "wide");
}
