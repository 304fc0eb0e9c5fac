//! Runs every test, with what the tests need.

use crate::steps::Steps;
use crate::{firmware, python, site, workspace};
use anyhow::{Context, Result};
use clap::Args;
use surroundings::need;

/// Which tests to run.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Passed on to `cargo test`: a package or a name to filter by.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<String>,
}

/// Packages whose tests run the firmware's image.
const WITH_IMAGE: &[&str] = &["bench", "bench-host", "xtask"];
/// Package whose tests open the site.
const WITH_SITE: &[&str] = &["bench-host"];
/// Packages whose tests ask a Python witness.
const WITH_WITNESS: &[&str] = &["bench", "protocol-core", "virtual-vehicle", "xtask"];

/// Builds the firmware for the bench, installs the witnesses and runs `cargo test`.
///
/// # Errors
/// If anything fails; all of it is run first.
pub fn run(options: &Options) -> Result<()> {
    let mut steps = Steps::default();
    run_steps(&mut steps, &options.arguments)?;
    steps.finish()
}

/// The steps of [`run`], for `ci` to run among its own.
///
/// # Errors
/// If nothing can be printed.
pub fn run_steps(steps: &mut Steps, arguments: &[String]) -> Result<()> {
    let packages = Packages::of(arguments);
    let (mut elfs, mut witness) = (Vec::new(), None);
    if packages.have_any_of(WITH_IMAGE) {
        steps.run("firmware for the bench", || {
            use firmware::Panel::{Ili9341, St7789};
            for (panel, vehicle) in [(Ili9341, Some("example")), (St7789, None), (Ili9341, None)] {
                let vehicle = vehicle.map(str::to_owned);
                let options = firmware::Options { panel, vehicle, ..firmware::Options::default() };
                elfs.push(firmware::build(&options)?.elf);
            }
            Ok(())
        })?;
    }
    if packages.have_any_of(WITH_SITE) {
        steps.run("the bench in a browser is the bench on this machine", site::build_and_compare)?;
    }
    if packages.have_any_of(WITH_WITNESS) {
        steps.run("witnesses (cantools, python-can)", || {
            witness = Some(python::witness()?);
            Ok(())
        })?;
    }
    // One file per run: two may go on at once.
    let skips = crate::output_folder()?.join(format!("skipped-tests-{}.txt", std::process::id()));
    steps.run("cargo test", || {
        let mut command = workspace::cargo();
        command.args(["test", "--no-fail-fast"]).args(arguments);
        // The witnesses say how much they have compared.
        if !arguments.iter().any(|argument| argument == "--") {
            command.args(["--", "--quiet", "--show-output"]);
        }
        if let Some(python) = &witness {
            command.env("WITNESS_PYTHON", python);
        }
        if let [example, st7789, ili9341] = &elfs[..] {
            command.env("CLUSTER_ELF", ili9341).env("CLUSTER_ELF_ST7789", st7789);
            command.env("CLUSTER_ELF_EXAMPLE", example);
        }
        workspace::run(command.env(need::FILE, &skips))
    })?;
    // Without a skip there is no file.
    if skips.exists() {
        let noted =
            std::fs::read_to_string(&skips).and_then(|noted| std::fs::remove_file(&skips).map(|()| noted));
        let noted = noted.with_context(|| format!("cannot read {}", skips.display()))?;
        noted.lines().for_each(|line| steps.skip(line.to_owned()));
    }
    Ok(())
}

/// Which packages `cargo test` is told to test.
#[derive(Debug, Default, PartialEq, Eq)]
struct Packages {
    /// All if there is none.
    chosen: Vec<String>,
    excluded: Vec<String>,
}

impl Packages {
    /// Reads them out of cargo's arguments, up to those of the test programs.
    fn of(arguments: &[String]) -> Self {
        let mut packages = Self::default();
        let mut arguments = arguments.iter().map(String::as_str).take_while(|argument| *argument != "--");
        while let Some(argument) = arguments.next() {
            let (flag, value) = match argument.split_once('=') {
                Some((flag, value)) => (flag, Some(value)),
                None if argument.starts_with("-p") => {
                    (&argument[..2], Some(&argument[2..]).filter(|value| !value.is_empty()))
                }
                None => (argument, None),
            };
            let list = match flag {
                "-p" | "--package" => &mut packages.chosen,
                "--exclude" => &mut packages.excluded,
                _ => continue,
            };
            list.extend(value.or_else(|| arguments.next()).map(str::to_owned));
        }
        packages
    }

    /// Returns whether one of `names` is tested; of what is not a plain name (`ben*`, a URL) it may be one.
    fn have_any_of(&self, names: &[&str]) -> bool {
        let is_plain =
            |spec: &str| spec.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"-_".contains(&byte));
        let fits = |spec: &String, name: &str| {
            let spec = spec.split('@').next().unwrap_or_default();
            spec == name || !is_plain(spec)
        };
        names.iter().any(|name| {
            let is_chosen = self.chosen.is_empty() || self.chosen.iter().any(|spec| fits(spec, name));
            is_chosen && !self.excluded.iter().any(|spec| spec == name)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cargo_metadata::MetadataCommand;
    use std::path::Path;

    fn packages(line: &str) -> Packages {
        Packages::of(&line.split_whitespace().map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn an_image_is_built_only_for_packages_that_run_it() {
        for (line, image, witness) in [
            ("", true, true),
            ("a_name --release", true, true),
            ("-p protocol-core", false, true),
            ("-pprotocol-core", false, true),
            ("--package=cluster", false, false),
            ("--package cluster -- -p bench", false, false),
            ("-p cluster -p bench", true, true),
            ("-p bench-host", true, false),
            ("-p=bench@0.1.0", true, true),
            ("-p ben*", true, true),
            ("--workspace --exclude bench", true, true),
            ("--workspace --exclude=cluster", true, true),
        ] {
            assert_eq!(packages(line).have_any_of(WITH_IMAGE), image, "image for `{line}`");
            assert_eq!(packages(line).have_any_of(WITH_WITNESS), witness, "witness for `{line}`");
        }
    }

    /// Returns whether a Rust file below `folder` holds one of these.
    fn names(folder: &Path, words: &[&str]) -> bool {
        std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()).any(|path| {
            let is_rust = path.extension().is_some_and(|ending| ending == "rs");
            path.is_dir() && names(&path, words)
                || is_rust
                    && std::fs::read_to_string(&path)
                        .is_ok_and(|text| words.iter().any(|words| text.contains(words)))
        })
    }

    #[test]
    fn the_lists_are_the_packages_whose_tests_ask() {
        let manifest = workspace::root().join("Cargo.toml");
        let metadata = MetadataCommand::new().manifest_path(manifest).no_deps().exec().unwrap();
        let lists: [(&[&str], &[&str]); 3] = [
            (WITH_IMAGE, &["CLUSTER_ELF", "firmware::elf"]),
            (WITH_SITE, &["bench.html"]),
            (WITH_WITNESS, &["need::witness("]),
        ];
        for (list, words) in lists {
            let asks = metadata.packages.iter().filter(|package| {
                let folder = package.manifest_path.as_std_path().parent().unwrap();
                names(&folder.join("tests"), words)
            });
            let mut asks: Vec<&str> = asks.map(|package| package.name.as_str()).collect();
            asks.sort_unstable();
            assert_eq!(asks, list, "whose tests hold one of {words:?}");
        }
    }
}
