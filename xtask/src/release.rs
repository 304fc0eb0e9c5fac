//! Puts a release together in one folder: images, the bench as a site and as one file, what has changed, checksums.
//!
//! Every file's name says its commit; nothing in it says when or where it was built, so two builds of one commit are equal
//! byte for byte. Refuses a tree that differs from its commit. `--check` builds a second time, out of a fresh clone in
//! another folder, and compares the checksums.

use crate::firmware::{self, Panel};
use crate::out::{note, say};
use crate::{site, workspace};
use anyhow::{Context, Result, bail};
use clap::Args;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where the release goes.
#[derive(Args, Clone, Debug, Default)]
pub struct Options {
    /// Folder of the release; it must not be there yet.
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Builds the commit a second time in another folder and compares.
    #[arg(long)]
    check: bool,
}

/// Kinds of fragments, in the order of the page.
const KINDS: &[(&str, &str)] =
    &[("added", "Added"), ("changed", "Changed"), ("fixed", "Fixed"), ("removed", "Removed")];

/// Builds a release.
///
/// # Errors
/// If the tree differs from its commit, a part cannot be built or written, or a second build is another one.
pub fn run(options: &Options) -> Result<()> {
    let git = |arguments: &[&str]| {
        let mut command = Command::new("git");
        workspace::capture(command.current_dir(workspace::root()).args(arguments))
    };
    let differs = git(&["status", "--porcelain"])?;
    if let Some(first) = differs.lines().next() {
        bail!("the tree differs from its commit ({}): commit or remove that first", first.trim());
    }
    let commit = git(&["rev-parse", "--short=10", "HEAD"])?.trim().to_owned();
    let default = crate::output_folder()?.join(format!("release-{commit}"));
    let out = options.out.clone().unwrap_or(default);
    if out.exists() {
        bail!("{} is there already; remove it or name another --out", out.display());
    }
    fs::create_dir_all(&out).with_context(|| format!("cannot create {}", out.display()))?;
    for panel in [Panel::Ili9341, Panel::St7789] {
        let image = firmware::build(&firmware::Options { panel, ..firmware::Options::default() })?;
        let name = format!("cluster-{}-{commit}", panel.feature());
        copy(&image.elf, &out.join(format!("{name}.elf")))?;
        copy(&image.uf2, &out.join(format!("{name}.uf2")))?;
    }
    let built = site::build(Some(&out.join("site")))?;
    copy(&built.single, &out.join(format!("bench-{commit}.html")))?;
    let changes = changes(&workspace::root().join("changelog"))?;
    fs::write(out.join("CHANGES.md"), format!("# Changes up to {commit}\n\n{changes}"))?;
    let sums = sums(&out)?;
    fs::write(out.join("SHA256SUMS"), &sums)?;
    say!("{}{}", sums, out.display())?;
    if options.check { compare(&sums, &commit) } else { Ok(()) }
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::copy(from, to).with_context(|| format!("cannot write {}", to.display()))?;
    Ok(())
}

/// Puts the fragments together, kind by kind.
fn changes(folder: &Path) -> Result<String> {
    let mut files: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))? {
        files.push(entry?.path());
    }
    files.sort();
    let mut text = String::new();
    let mut used = 0;
    for (kind, title) in KINDS {
        let is_of_kind = |path: &&PathBuf| {
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            name.strip_prefix(kind).is_some_and(|rest| rest.starts_with('-'))
        };
        let of_kind: Vec<&PathBuf> = files.iter().filter(is_of_kind).collect();
        if of_kind.is_empty() {
            continue;
        }
        let _ = writeln!(text, "## {title}\n");
        for path in of_kind {
            let fragment = fs::read_to_string(path).with_context(|| path.display().to_string())?;
            let _ = writeln!(text, "- {}", fragment.trim().replace('\n', "\n  "));
            used += 1;
        }
        text.push('\n');
    }
    // All but the page that says what fragments are.
    if used + 1 != files.len() {
        bail!("{} of the files in {} are of no kind", files.len() - used - 1, folder.display());
    }
    Ok(text)
}

/// Returns a line for each file below `folder`, sorted, as `sha256sum -c` reads it.
fn sums(folder: &Path) -> Result<String> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(&next).with_context(|| format!("cannot read {}", next.display()))? {
            let path = entry?.path();
            if path.is_dir() { folders.push(path) } else { files.push(path) }
        }
    }
    files.sort();
    let mut text = String::new();
    for path in files {
        let bytes = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        let hex = Sha256::digest(&bytes).iter().fold(String::new(), |mut hex, byte| {
            let _ = write!(hex, "{byte:02x}");
            hex
        });
        let _ = writeln!(text, "{hex}  {}", path.strip_prefix(folder).unwrap_or(&path).display());
    }
    Ok(text)
}

/// Builds the commit out of a fresh clone in another folder.
fn compare(sums: &str, commit: &str) -> Result<()> {
    let other = std::env::temp_dir().join(format!("cluster-release-{commit}-{}", std::process::id()));
    note!("building {commit} again in {}", other.display());
    let result = again(sums, &other);
    let _ = fs::remove_dir_all(&other);
    result
}

fn again(sums: &str, other: &Path) -> Result<()> {
    let mut clone = Command::new("git");
    workspace::run(clone.arg("clone").arg("--quiet").arg(workspace::root()).arg(other))?;
    let out = other.join("release");
    let mut build = Command::new("cargo");
    build.current_dir(other).env_remove("CARGO_TARGET_DIR");
    workspace::run(build.args(["xtask", "release", "--out"]).arg(&out))?;
    let second = fs::read_to_string(out.join("SHA256SUMS"))?;
    let wrong: Vec<&str> = sums.lines().filter(|line| !second.lines().any(|other| other == *line)).collect();
    if !wrong.is_empty() {
        bail!("another build of the same commit has other bytes:\n{}", wrong.join("\n"));
    }
    say!("equal byte for byte in another folder: {} files", sums.lines().count())?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_fragment_of_the_tree_stands_in_the_changes_once() {
        let folder = workspace::root().join("changelog");
        let text = changes(&folder).unwrap();
        let fragments = fs::read_dir(&folder).unwrap().count() - 1;
        assert_eq!(text.lines().filter(|line| line.starts_with("- ")).count(), fragments);
        assert!(text.starts_with("## Added\n"));
    }

    #[test]
    fn a_file_of_no_kind_is_an_error_and_sums_are_those_of_sha256sum() {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in [("README.md", "r"), ("fixed-a.md", "One.\nTwo."), ("odd-b.md", "x")] {
            fs::write(folder.path().join(name), text).unwrap();
        }
        assert!(changes(folder.path()).unwrap_err().to_string().contains("1 of the files"));
        fs::remove_file(folder.path().join("odd-b.md")).unwrap();
        assert_eq!(changes(folder.path()).unwrap(), "## Fixed\n\n- One.\n  Two.\n\n");
        fs::write(folder.path().join("abc"), "abc").unwrap();
        let known = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  abc";
        assert!(sums(folder.path()).unwrap().lines().any(|line| line == known), "FIPS 180-4's own example");
    }
}
