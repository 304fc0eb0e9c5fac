//! Guards the arrows: which crate may depend on which, and that no files of a crate depend on each other in a circle.
//!
//! Firmware on boards on drivers on embedded-hal; firmware on ui on cluster on protocol-core on core. The bench and
//! the tools load the ELF, they never link firmware code. Dev-dependencies are free: tests look from outside.

use crate::out::say;
use crate::rooms::Rooms;
use anyhow::{Result, bail};
use cargo_metadata::{DependencyKind, MetadataCommand, Package};

/// One crate and what it may depend on inside the workspace.
struct Layer {
    name: &'static str,
    may_use: &'static [&'static str],
    /// Other people's crates that must not appear (the crate is to stay free of hardware, or of a runtime).
    never: &'static [&'static str],
}

/// Crates that only code at the edge may name.
const HARDWARE: &[&str] = &[
    "rp2040-hal",
    "rp2040-boot2",
    "rtic",
    "rtic-monotonics",
    "cortex-m",
    "cortex-m-rt",
    "mcp2515",
    "mipidsi",
];

/// Crates that a browser has no use for, or no place.
const IN_BROWSER: &[&str] =
    &["axum", "tokio", "rustix", "socketcan", "rp2040-hal", "rtic", "cortex-m", "mcp2515", "mipidsi"];

const LAYERS: &[Layer] = &[
    Layer { name: "surroundings", may_use: &[], never: HARDWARE },
    Layer { name: "protocol-core", may_use: &[], never: HARDWARE },
    Layer { name: "cluster", may_use: &["protocol-core"], never: HARDWARE },
    Layer { name: "store", may_use: &[], never: HARDWARE },
    Layer { name: "ui", may_use: &["cluster", "protocol-core"], never: HARDWARE },
    Layer { name: "mcp2515-can", may_use: &[], never: &["rp2040-hal", "rtic", "cortex-m"] },
    Layer { name: "tft", may_use: &[], never: &["rp2040-hal", "rtic", "cortex-m"] },
    Layer { name: "pico", may_use: &["mcp2515-can", "tft", "protocol-core"], never: &["rtic"] },
    Layer {
        name: "firmware",
        may_use: &["cluster", "mcp2515-can", "pico", "protocol-core", "store", "tft", "ui"],
        never: &["rp2040-hal", "mcp2515", "mipidsi"],
    },
    Layer { name: "vehicle-compiler", may_use: &["protocol-core"], never: HARDWARE },
    Layer { name: "fontgen", may_use: &["cluster", "surroundings"], never: HARDWARE },
    Layer { name: "virtual-vehicle", may_use: &["protocol-core"], never: HARDWARE },
    Layer {
        name: "bench",
        may_use: &["cluster", "protocol-core", "surroundings", "virtual-vehicle"],
        never: &["axum", "tokio", "rp2040-hal", "rtic", "mcp2515", "mipidsi"],
    },
    Layer {
        name: "bench-page",
        may_use: &["bench", "cluster", "protocol-core", "virtual-vehicle"],
        never: IN_BROWSER,
    },
    Layer { name: "bench-host", may_use: &["bench", "bench-page", "virtual-vehicle"], never: HARDWARE },
    Layer {
        name: "bench-web",
        may_use: &["bench", "bench-page", "protocol-core", "vehicle-compiler", "virtual-vehicle"],
        never: IN_BROWSER,
    },
    Layer {
        name: "xtask",
        may_use: &[
            "bench",
            "bench-host",
            "bench-page",
            "bench-web",
            "cluster",
            "fontgen",
            "protocol-core",
            "store",
            "surroundings",
            "ui",
            "vehicle-compiler",
            "virtual-vehicle",
        ],
        never: HARDWARE,
    },
];

/// Crates with circles that an issue of their own is to open, and how many there are: the number may only fall.
const OPEN: &[(&str, usize)] = &[("ui", 1)];

/// Prints the arrows and fails on one that must not be.
///
/// # Errors
/// If a crate is unknown here or depends on what it must not, or if files of a crate depend on each other in a circle.
pub fn run() -> Result<()> {
    let metadata =
        MetadataCommand::new().manifest_path(crate::workspace::root().join("Cargo.toml")).exec()?;
    let packages = metadata.workspace_packages();
    let mut wrong = check(&packages);
    let mut circles = 0;
    for package in &packages {
        let ours: Vec<_> =
            arrows(package).filter(|name| packages.iter().any(|p| p.name.as_str() == *name)).collect();
        let rooms = Rooms::read(package.manifest_path.with_file_name("src").as_std_path())?;
        say!(
            "{:18} -> {} ({} arrows inside)",
            package.name.as_str(),
            if ours.is_empty() { "-".into() } else { ours.join(", ") },
            rooms.arrow_count()
        )?;
        let found = rooms.circles();
        let open =
            OPEN.iter().find(|(name, _)| *name == package.name.as_str()).map_or(0, |(_, count)| *count);
        if found.len() > open {
            let circles = found.iter().map(|circle| circle.join(", ")).collect::<Vec<_>>().join("; ");
            wrong.push(format!("in `{}` these name each other in a circle: {circles}", package.name));
        } else if found.len() < open {
            wrong.push(format!("`{}` has {} circles: lower its row in OPEN", package.name, found.len()));
        }
        circles += found.len();
    }
    say!("{circles} circles inside crates")?;
    if wrong.is_empty() {
        return Ok(());
    }
    bail!("{}\n(the house is in CONTRIBUTING.md; the table is in xtask/src/layers.rs)", wrong.join("\n"))
}

fn arrows(package: &Package) -> impl Iterator<Item = &str> {
    let kinds = [DependencyKind::Normal, DependencyKind::Build];
    package.dependencies.iter().filter(move |d| kinds.contains(&d.kind)).map(|d| d.name.as_str())
}

fn check(packages: &[&Package]) -> Vec<String> {
    let mut wrong = Vec::new();
    for package in packages {
        let Some(layer) = LAYERS.iter().find(|layer| layer.name == package.name.as_str()) else {
            wrong.push(format!("crate `{}` has no layer: give it a row", package.name));
            continue;
        };
        for name in arrows(package) {
            let ours = packages.iter().any(|p| p.name.as_str() == name);
            if ours && !layer.may_use.contains(&name) || layer.never.contains(&name) {
                wrong.push(format!("`{}` must not depend on `{name}`", layer.name));
            }
        }
    }
    wrong
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::{Path, PathBuf};

    #[test]
    fn the_table_has_no_cycle() {
        // Rows may only name rows that can be placed below them.
        let mut placed: Vec<&str> = Vec::new();
        for _ in 0..LAYERS.len() {
            for layer in LAYERS {
                if !placed.contains(&layer.name) && layer.may_use.iter().all(|name| placed.contains(name)) {
                    placed.push(layer.name);
                }
            }
        }
        assert_eq!(placed.len(), LAYERS.len(), "placed only {placed:?}");
    }

    #[test]
    fn an_arrow_that_points_up_is_found() {
        let metadata =
            MetadataCommand::new().manifest_path(crate::workspace::root().join("Cargo.toml")).exec().unwrap();
        let mut upward =
            metadata.workspace_packages().into_iter().find(|p| p.name.as_str() == "cluster").unwrap().clone();
        let ui = metadata.workspace_packages().into_iter().find(|p| p.name.as_str() == "ui").unwrap().clone();
        let mut arrow = upward.dependencies[0].clone();
        arrow.name = "ui".into();
        upward.dependencies.push(arrow);
        assert_eq!(check(&[&upward, &ui]), ["`cluster` must not depend on `ui`"]);
    }

    /// Adds every Rust file below `folder`, but for what is built.
    fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
        for path in std::fs::read_dir(folder).unwrap().flatten().map(|entry| entry.path()) {
            let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
            if path.is_dir() && name != "target" && !name.starts_with('.') {
                sources(&path, found);
            } else if name.ends_with(".rs") {
                found.push(path);
            }
        }
    }

    #[test]
    fn only_surroundings_knows_where_it_was_compiled() {
        let root = crate::workspace::root();
        let mut files = Vec::new();
        sources(&root, &mut files);
        // Put together, or this file would hold them.
        let compiled = ["MANIFEST_DIR", "TARGET_TMPDIR"].map(|name| format!("env!(\"CARGO_{name}\")"));
        files.retain(|path| {
            let text = std::fs::read_to_string(path).unwrap();
            compiled.iter().any(|words| text.contains(words))
        });
        let found: Vec<_> = files.iter().map(|path| path.strip_prefix(&root).unwrap()).collect();
        assert_eq!(
            found,
            [Path::new("tools/surroundings/src/checkout.rs")],
            "a copied checkout would work on the old one: `surroundings::root()`"
        );
    }
}
