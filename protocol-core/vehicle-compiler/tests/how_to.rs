//! The page "Add your vehicle in an hour", executed: its blocks make a vehicle in an empty folder.

use std::fs;
use std::path::{Path, PathBuf};
use surroundings::root;

/// Does the page's `cargo xtask codegen` in a folder that is not the repository.
fn write(folder: &Path) -> Result<Vec<PathBuf>, vehicle_compiler::Diagnostics> {
    vehicle_compiler::write_if(folder, |files| vehicle_compiler::proof::compiles(&root(), files))
}

/// Returns the words behind the fence, and the text, of every block of the page.
fn blocks() -> Vec<(String, String)> {
    let page = fs::read_to_string(root().join("docs/add-your-vehicle.md")).expect("the page is there");
    let parts: Vec<&str> = page.split("```").collect();
    let inside = parts.iter().skip(1).step_by(2);
    inside.filter_map(|block| block.split_once('\n')).map(|(head, text)| (head.into(), text.into())).collect()
}

/// Writes every block that names a file into a new root.
fn follow() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (head, text) in blocks() {
        if let Some((_, path)) = head.split_once(" vehicles/") {
            let path = folder.path().join("vehicles").join(path);
            fs::create_dir_all(path.parent().expect("a folder")).expect("can be made");
            fs::write(path, text).expect("can be written");
        }
    }
    folder
}

#[test]
fn the_blocks_make_a_vehicle_without_findings() {
    let folder = follow();
    let dbc = fs::read_to_string(folder.path().join("vehicles/van/van.dbc")).expect("step 1 writes it");
    assert_eq!(vehicle_compiler::lint::lint("van.dbc", &dbc).to_string(), "");
    let written = write(folder.path()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(written.len(), 2, "the vehicle and the list of vehicles: {written:?}");

    // protocol-core's tests decode the page's frame with it.
    let text =
        fs::read_to_string(folder.path().join("protocol-core/src/generated/van.rs")).expect("generated");
    let committed = root().join("protocol-core/tests/how_to/van.rs");
    if std::env::var_os("BLESS").is_some() {
        fs::write(&committed, &text).expect("the file can be written");
    }
    let same = fs::read_to_string(&committed).is_ok_and(|old| old == text);
    assert!(same, "van.rs differs: `BLESS=1 cargo test -p vehicle-compiler --test how_to` refreshes it");
}

#[test]
fn the_misspelt_name_gets_the_words_that_the_page_prints() {
    let folder = follow();
    let (head, said) = blocks().into_iter().find(|(head, _)| head.starts_with("error ")).expect("the block");
    let (from, to) = head["error ".len()..].split_once(" -> ").expect("what is misspelt how");
    let path = folder.path().join("vehicles/van/vehicle.toml");
    let text = fs::read_to_string(&path).expect("step 2 writes it");
    fs::write(&path, text.replace(&format!("= \"{from}\""), &format!("= \"{to}\""))).expect("can be written");
    let error = write(folder.path()).expect_err("a misspelt name");
    assert_eq!(error.to_string().trim(), said.trim());
}
