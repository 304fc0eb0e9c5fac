//! The tree of generated files: written whole or not at all, and always writable again.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use vehicle_compiler::{Diagnostics, GENERATED, proof, write_if};

fn repository() -> PathBuf {
    surroundings::root()
}

/// Copies vehicles and generated files of the repository into a new folder.
fn copy() -> tempfile::TempDir {
    let tree = tempfile::tempdir().expect("a folder");
    let put = |from: &Path, to: &Path| {
        fs::create_dir_all(to.parent().expect("a folder")).expect("can be made");
        fs::copy(from, to).expect("can be copied");
    };
    for vehicle in vehicle_compiler::vehicles(&repository()).expect("the vehicles") {
        for file in [format!("vehicles/{vehicle}/{vehicle}.dbc"), format!("vehicles/{vehicle}/vehicle.toml")]
        {
            put(&repository().join(&file), &tree.path().join(&file));
        }
    }
    for file in fs::read_dir(repository().join(GENERATED)).expect("the generated files").flatten() {
        put(&file.path(), &tree.path().join(GENERATED).join(file.file_name()));
    }
    tree
}

/// Name and text of every generated file.
fn generated(tree: &Path) -> BTreeMap<String, String> {
    let files = fs::read_dir(tree.join(GENERATED)).expect("the folder").flatten();
    files
        .map(|file| {
            let text = fs::read_to_string(file.path()).expect("a text");
            (file.file_name().to_string_lossy().into_owned(), text)
        })
        .collect()
}

fn write(tree: &Path) -> Result<Vec<PathBuf>, Diagnostics> {
    write_if(tree, |files| proof::compiles(&repository(), files))
}

/// Adds the vehicle of `protocol-core/tests/hostile` under `name`, its DBC changed by one replacement.
fn add(tree: &Path, name: &str, from: &str, to: &str) -> PathBuf {
    let source = repository().join("protocol-core/tests/hostile");
    let read = |file: &str| fs::read_to_string(source.join(file)).expect("the file is there");
    let folder = tree.join("vehicles").join(name);
    let dbc = read("hostile.dbc");
    assert!(dbc.contains(from), "{from}");
    fs::create_dir_all(&folder).expect("can be made");
    fs::write(folder.join(format!("{name}.dbc")), dbc.replace(from, to)).expect("can be written");
    fs::write(folder.join("vehicle.toml"), read("vehicle.toml")).expect("can be written");
    folder
}

#[test]
fn a_wrong_vehicle_changes_no_file_and_the_next_run_works() {
    let tree = copy();
    let before = generated(tree.path());
    let folder = add(tree.path(), "wrong", "SG_ as ", "SG_ in ");
    let said = write(tree.path()).expect_err("one name for two").to_string();
    assert!(said.contains("signal `in` is used before, in line"), "{said}");
    assert_eq!(generated(tree.path()), before);
    fs::remove_dir_all(folder).expect("can be removed");
    assert_eq!(write(tree.path()), Ok(Vec::new()));

    add(tree.path(), "fine", "SG_ as ", "SG_ as ");
    let written = write(tree.path()).unwrap_or_else(|error| panic!("{error}"));
    let files = ["fine.rs", "mod.rs"].map(|file| Path::new(GENERATED).join(file));
    assert_eq!(written, files, "the list comes behind what it lists");
}

#[test]
fn a_text_that_is_not_rust_is_told_with_its_place_and_changes_no_file() {
    let tree = copy();
    let before = generated(tree.path());
    add(tree.path(), "fine", "SG_ as ", "SG_ as ");
    for (from, to, error) in [
        ("pub const fn s_as(self)", "pub const fn as(self)", "expected identifier, found keyword `as`"),
        ("pub const fn s_as(self)", "pub const fn s_in(self)", "duplicate definitions with name `s_in`"),
        ("self.0[5]", "self.0[8]", "this operation will panic at runtime"),
    ] {
        let spoilt = |files: &[(PathBuf, String)]| {
            let mut files = files.to_vec();
            let (_, text) = files.iter_mut().find(|(path, _)| path.ends_with("fine.rs")).expect("its file");
            assert!(text.contains(from), "{from}");
            *text = text.replacen(from, to, 1);
            proof::compiles(&repository(), &files)
        };
        let said = write_if(tree.path(), spoilt).expect_err("it is not Rust").to_string();
        let place = format!("{GENERATED}/fine.rs:");
        assert!(
            said.contains(&place) && said.contains(error) && said.contains("nothing was written"),
            "{said}"
        );
        assert_eq!(generated(tree.path()), before);
    }
    assert!(write(tree.path()).is_ok());
}

#[test]
fn a_run_that_was_broken_off_leaves_nothing_behind() {
    let tree = copy();
    fs::write(tree.path().join(GENERATED).join("bus.rs.new"), "half").expect("can be written");
    assert_eq!(write(tree.path()), Ok(vec![Path::new(GENERATED).join("bus.rs.new")]));
    assert_eq!(generated(tree.path()), generated(&repository()));
}

#[test]
fn a_folder_that_cannot_name_a_module_is_told() {
    let tree = copy();
    for name in ["mod", "My-Van"] {
        let folder = add(tree.path(), name, "SG_ as ", "SG_ as ");
        let said = write(tree.path()).expect_err("no name of a module").to_string();
        assert!(said.starts_with(&format!("vehicles/{name}: ")), "{said}");
        fs::remove_dir_all(folder).expect("can be removed");
    }
}

#[test]
fn the_compiler_is_built_without_the_files_that_it_writes() {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(repository()).args([
        "tree",
        "--package",
        "vehicle-compiler",
        "--edges",
        "normal,build,features",
    ]);
    let output = cargo.output().expect("cargo starts");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(said.contains("protocol-core") && !said.contains("\"vehicles\""), "{said}");
}
