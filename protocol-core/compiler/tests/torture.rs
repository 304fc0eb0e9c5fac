//! The made-up vehicle of protocol-core's tests: its generated file is what the generator writes today.

use std::fs;

#[test]
fn the_torture_vehicle_is_generated_as_committed() {
    let folder = surroundings::root().join("protocol-core/tests/codec_torture");
    let read = |file: &str| fs::read_to_string(folder.join(file)).expect("the file is there");
    let (dbc, toml) = (read("torture.dbc"), read("vehicle.toml"));
    let compile = || vehicle_compiler::compile("torture", ("torture.dbc", &dbc), ("vehicle.toml", &toml));
    let text = compile().unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(compile().as_ref(), Ok(&text), "the same folder gives the same bytes");
    let committed = folder.join("torture.rs");
    if std::env::var_os("BLESS").is_some() {
        fs::write(&committed, &text).expect("the file can be written");
    }
    let same = fs::read_to_string(&committed).is_ok_and(|old| old == text);
    assert!(same, "torture.rs differs: `BLESS=1 cargo test -p vehicle-compiler` refreshes it");
}
