//! Puts the scenarios and their golden pictures into the module: a browser has no folder of them.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

fn main() {
    let root = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default()).join("../scenarios");
    println!("cargo::rerun-if-changed={}", root.display());
    let (mut texts, mut pictures) = (String::new(), String::new());
    for folder in sorted(&root).into_iter().filter(|path| path.is_dir()) {
        let vehicle = name(&folder);
        for file in sorted(&folder) {
            if file.extension().is_some_and(|ending| ending == "toml") {
                let _ = writeln!(
                    texts,
                    "    ({:?}, include_str!({file:?})),",
                    format!("{vehicle}/{}", name(&file))
                );
            }
        }
        for file in sorted(&folder.join("pictures")) {
            let _ = writeln!(pictures, "    ({vehicle:?}, {:?}, include_bytes!({file:?})),", name(&file));
        }
    }
    let text = format!(
        "/// Every scenario file: folder and name, text.\npub(crate) const TEXTS: &[(&str, &str)] = &[\n{texts}];\n\
         /// Every golden picture: vehicle, name, PNG.\npub(crate) const PICTURES: &[(&str, &str, &[u8])] = &[\n{pictures}];\n"
    );
    let out = PathBuf::from(std::env::var_os("OUT_DIR").unwrap_or_default()).join("scenarios.rs");
    if let Err(error) = std::fs::write(&out, text) {
        panic!("{}: {error}", out.display());
    }
}

fn sorted(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten();
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.sort();
    paths
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}
