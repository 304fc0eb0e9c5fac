//! Where the checkout is.
//!
//! The one that runs, not the one that was compiled: cargo keeps what it has built when a folder is copied or moved,
//! and a path in the binary would lead into the old one. Cargo tells every program that it starts, by `cargo run` or
//! `cargo test`, the folder of its package.

use std::path::{Path, PathBuf};

/// Where this was compiled; for programs that cargo has not started.
const COMPILED: &str = env!("CARGO_MANIFEST_DIR");
/// The variable by which cargo tells a program the folder of its package.
const VARIABLE: &str = "CARGO_MANIFEST_DIR";

/// Returns the root of the checkout that this program belongs to.
///
/// The one that cargo names when it starts the program, else the one that this was compiled in, whether it is still
/// there or not ([`check`]).
#[must_use]
pub fn root() -> PathBuf {
    find(std::env::var_os(VARIABLE).as_deref().map(Path::new), Path::new(COMPILED))
        .unwrap_or_else(|| Path::new(COMPILED).join("../.."))
}

/// Returns whether there is a checkout to work on.
///
/// # Errors
/// If neither cargo names one nor the one that this was compiled in is there; the text says what to do.
pub fn check() -> Result<(), String> {
    let running = std::env::var_os(VARIABLE).map(PathBuf::from);
    match find(running.as_deref(), Path::new(COMPILED)) {
        Some(_) => Ok(()),
        None => Err(missing(running.as_deref(), Path::new(COMPILED))),
    }
}

fn missing(running: Option<&Path>, compiled: &Path) -> String {
    let running =
        running.map_or_else(String::new, |path| format!("{} is in no checkout, and ", path.display()));
    let compiled = compiled.display();
    format!(
        "{running}{compiled}, where this was compiled, is no longer in one: run `cargo xtask` in a checkout"
    )
}

fn find(running: Option<&Path>, compiled: &Path) -> Option<PathBuf> {
    // A relative path would be one from wherever the program was started.
    let running = running.filter(|path| path.is_absolute());
    [running, Some(compiled)].into_iter().flatten().find_map(around).map(Path::to_path_buf)
}

/// Returns the checkout that `folder` is in.
fn around(folder: &Path) -> Option<&Path> {
    let is_checkout =
        |path: &&Path| path.join("protocol-core/Cargo.toml").is_file() && path.join("vehicles").is_dir();
    folder.ancestors().find(is_checkout)
}

/// Returns the folder that cargo builds into.
#[must_use]
pub fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// Returns a folder in which a test may leave what a person wants to look at.
///
/// # Panics
/// If it cannot be made.
#[must_use]
pub fn scratch() -> PathBuf {
    let folder = target().join("tmp");
    std::fs::create_dir_all(&folder)
        .unwrap_or_else(|error| panic!("cannot make {}: {error}", folder.display()));
    folder
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checkout() -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for inside in ["protocol-core", "vehicles", "app/ui"] {
            std::fs::create_dir_all(folder.path().join(inside)).unwrap();
        }
        std::fs::write(folder.path().join("protocol-core/Cargo.toml"), "").unwrap();
        folder
    }

    #[test]
    fn the_checkout_that_runs_goes_before_the_one_that_was_compiled() {
        let (here, there) = (checkout(), checkout());
        let (ui, core) = (here.path().join("app/ui"), there.path().join("protocol-core"));
        assert_eq!(find(Some(&ui), &core).unwrap(), here.path());
        assert_eq!(find(None, &core).unwrap(), there.path());
    }

    #[test]
    fn a_package_of_another_repository_is_not_taken_for_ours() {
        let (other, ours) = (tempfile::tempdir().unwrap(), checkout());
        let core = ours.path().join("protocol-core");
        assert_eq!(find(Some(other.path()), &core).unwrap(), ours.path());
        assert_eq!(find(Some(Path::new("")), &core).unwrap(), ours.path(), "nothing is no folder");
    }

    #[test]
    fn a_checkout_that_is_gone_is_named_with_what_to_do() {
        let (running, compiled) = (Path::new("/no/such/xtask"), Path::new("/gone/tools/surroundings"));
        assert_eq!(find(Some(running), compiled), None);
        let said = missing(Some(running), compiled);
        for part in ["/no/such/xtask", "/gone/tools/surroundings", "run `cargo xtask` in a checkout"] {
            assert!(said.contains(part), "{said}");
        }
    }

    #[test]
    fn this_test_runs_in_a_checkout() {
        assert_eq!(check(), Ok(()));
        assert!(root().join("tools/surroundings/src/checkout.rs").is_file(), "{}", root().display());
    }
}
