//! Line and region coverage of the logic crates by their own tests.
//!
//! Owns the list of crates, the instrumented build in a folder of its own, and the check that no line of app/cluster
//! is without a test. Tests that only repeat what others reach, at length, are left out. Lines of test modules and
//! generated code are not counted. A stable compiler has no branch coverage; its regions are finer than lines.
//! Needs the compiler's own LLVM tools; refuses those of another version, which cannot read its counters.

use crate::out::{note, say};
use crate::steps::Outcome;
use crate::{toolchain, workspace};
use anyhow::{Context, Result, bail};
use clap::Args;
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What to do with the figures.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Fails if a line of app/cluster is not reached by any test.
    #[arg(long)]
    pub check: bool,
}

/// Where the measured sources are.
const SOURCES: [&str; 2] = ["app/cluster/src", "protocol-core/src"];
/// Sources of which every line must be reached.
const WHOLE: &str = "app/cluster/src";
/// Generated sources: thousands of lines of one pattern, checked value by value against cantools.
const GENERATED: &str = "protocol-core/src/generated";
/// Test programs that take long and reach nothing that others do not: the day on a full bus, millions of frames.
const PROGRAMS_LEFT_OUT: [&str; 2] = ["day", "codec_witness"];
/// Beginnings of such tests: whole worlds, hours of driving; with counters they take minutes.
const TESTS_LEFT_OUT: [&str; 5] = [
    "worlds_of",
    "odometer::the_slowest",
    "trips::any_division",
    "after_a_bus_off",
    "liveness::a_healthy_vehicle",
];

/// Lines that no test reaches yet, by file; a number may only fall.
const OPEN: &[(&str, usize)] = &[];

/// How often something was executed, by place; of several instances of a generic function the most.
type Counts<Place> = BTreeMap<Place, u64>;

/// What was reached of one source file.
#[derive(Default)]
struct Module {
    lines: Counts<u64>,
    /// By first line and column, last line and column.
    regions: Counts<[u64; 4]>,
}

impl Module {
    fn missed_lines(&self) -> impl Iterator<Item = u64> {
        self.lines.iter().filter(|(_, count)| **count == 0).map(|(line, _)| *line)
    }
}

/// Measures, prints a table, and with `--check` fails on a line of app/cluster that no test reaches.
///
/// # Errors
/// If the tools are missing, a test fails, or with `--check` a line is missed.
pub fn run(options: &Options) -> Result<()> {
    match measure(options)? {
        Outcome::Done => Ok(()),
        Outcome::Skipped(reason) | Outcome::Unreachable(reason) | Outcome::Partly(reason) => {
            bail!("{reason}")
        }
    }
}

/// Does what [`run`] does; without LLVM's tools the step is skipped for a reason.
///
/// # Errors
/// If a test fails, or with `--check` a line is missed.
pub fn measure(options: &Options) -> Result<Outcome> {
    let tools = match find_or_install_tools() {
        Ok(tools) => tools,
        Err(error) => return Ok(Outcome::Skipped(format!("{error:#}"))),
    };
    let folder = workspace::target().join("coverage");
    let programs = build(&folder)?;
    let profile = run_programs(&programs, &folder, &tools)?;
    let modules = read(&programs, &profile, &tools)?;
    print_table(&modules)?;
    if options.check {
        check(&modules)?;
    }
    Ok(Outcome::Done)
}

/// Returns the folder of the LLVM tools that belong to the compiler; rustup adds them if they are all that is missing.
fn find_or_install_tools() -> Result<PathBuf> {
    const ADVICE: &str =
        "coverage needs the compiler's own llvm-profdata and llvm-cov: `rustup component add llvm-tools`";
    let find = || -> Result<PathBuf> {
        let folder = toolchain::host_libraries()?.join("bin");
        ["llvm-profdata", "llvm-cov"]
            .iter()
            .all(|tool| folder.join(tool).is_file())
            .then_some(folder)
            .context(ADVICE)
    };
    find().or_else(|missing| {
        if !workspace::has("rustup") {
            return Err(missing);
        }
        note!("installing the coverage tools: rustup component add llvm-tools");
        workspace::run(Command::new("rustup").args(["component", "add", "llvm-tools"])).context(ADVICE)?;
        find()
    })
}

/// A test program, and the folder of its package, in which it expects to run.
struct Program {
    executable: PathBuf,
    package: PathBuf,
}

/// Builds the test programs with counters in them.
fn build(folder: &Path) -> Result<Vec<Program>> {
    let mut command = workspace::cargo();
    command.args(["test", "--quiet", "--no-run", "--message-format", "json", "--lib", "--tests"]);
    command.args(["--package", "cluster", "--package", "protocol-core"]);
    // What counts must not be moved around; the build scripts and macros run once, uncounted.
    command.env("CARGO_TARGET_DIR", folder).env("RUSTFLAGS", "-C instrument-coverage");
    command.env("LLVM_PROFILE_FILE", folder.join("build.profraw"));
    let mut programs = Vec::new();
    for line in workspace::capture(&mut command)?.lines() {
        let message: Json = serde_json::from_str(line).with_context(|| format!("cargo printed `{line}`"))?;
        let name = message["target"]["name"].as_str().unwrap_or_default();
        let (Some(executable), Some(manifest)) =
            (message["executable"].as_str(), message["manifest_path"].as_str())
        else {
            continue;
        };
        if PROGRAMS_LEFT_OUT.contains(&name) {
            continue;
        }
        let package = Path::new(manifest).parent().map(Path::to_path_buf).unwrap_or_default();
        programs.push(Program { executable: executable.into(), package });
    }
    Ok(programs)
}

/// Runs the programs and merges their counters into one file.
fn run_programs(programs: &[Program], folder: &Path, tools: &Path) -> Result<PathBuf> {
    let raw = folder.join("raw");
    if raw.exists() {
        std::fs::remove_dir_all(&raw).with_context(|| format!("{}: cannot be emptied", raw.display()))?;
    }
    for (index, program) in programs.iter().enumerate() {
        let mut command = Command::new(&program.executable);
        command.current_dir(&program.package).arg("--quiet");
        command.args(TESTS_LEFT_OUT.iter().flat_map(|name| ["--skip", name]));
        command.env("LLVM_PROFILE_FILE", raw.join(format!("{index}.profraw")));
        let output =
            command.output().with_context(|| format!("cannot start {}", program.executable.display()))?;
        if !output.status.success() {
            say!("{}", String::from_utf8_lossy(&output.stdout).trim_end())?;
            bail!(
                "{}: a test failed; `cargo xtask test` shows it without counters",
                program.executable.display()
            );
        }
    }
    let profile = folder.join("all.profdata");
    let mut merge = Command::new(tools.join("llvm-profdata"));
    workspace::run(merge.args(["merge", "--sparse", "--output"]).arg(&profile).arg(&raw))?;
    Ok(profile)
}

/// Returns what was reached, by path from the root of the repository.
fn read(programs: &[Program], profile: &Path, tools: &Path) -> Result<BTreeMap<String, Module>> {
    let root = workspace::root();
    let export = |format: &str| {
        let mut command = Command::new(tools.join("llvm-cov"));
        command.arg("export").arg(format!("--format={format}")).arg("--instr-profile").arg(profile);
        for program in programs {
            command.arg("--object").arg(&program.executable);
        }
        workspace::capture(command.arg("--sources").args(SOURCES.map(|folder| root.join(folder))))
    };
    let mut modules = BTreeMap::new();
    for folder in SOURCES {
        add_modules(&root, &root.join(folder), &mut modules)?;
    }
    let name = |path: &str| Some(Path::new(path).strip_prefix(&root).ok()?.to_str()?.to_owned());
    add_lines(&export("lcov")?, &mut modules, name)?;
    add_regions(&export("text")?, &mut modules, name)?;
    Ok(modules.into_iter().map(|(name, (module, _))| (name, module)).collect())
}

/// A module, and the first line that is of tests.
type Open = (Module, u64);

/// Adds every source file of a folder: one that no test program contains shall be seen too.
fn add_modules(root: &Path, folder: &Path, modules: &mut BTreeMap<String, Open>) -> Result<()> {
    for entry in std::fs::read_dir(folder).with_context(|| format!("{}: cannot be read", folder.display()))? {
        let path = entry?.path();
        let Some(name) = path.strip_prefix(root).ok().and_then(Path::to_str) else { continue };
        if name.starts_with(GENERATED) || !name.ends_with(".rs") {
            continue;
        }
        let text = std::fs::read_to_string(&path).with_context(|| format!("{name}: cannot be read"))?;
        let tests = text.lines().take_while(|line| *line != "#[cfg(test)]").count() as u64 + 1;
        modules.insert(name.to_owned(), (Module::default(), tests));
    }
    Ok(())
}

/// Reads lines of lcov: `SF:path`, then `DA:line,count` for each line with code.
fn add_lines(
    lcov: &str,
    modules: &mut BTreeMap<String, Open>,
    name: impl Fn(&str) -> Option<String>,
) -> Result<()> {
    let mut current = None;
    for row in lcov.lines() {
        if let Some(path) = row.strip_prefix("SF:") {
            current = name(path).filter(|name| modules.contains_key(name));
        }
        let (Some(pair), Some((module, tests))) =
            (row.strip_prefix("DA:"), current.as_ref().and_then(|name| modules.get_mut(name)))
        else {
            continue;
        };
        let read = pair.split_once(',').map(|(line, count)| (line.parse().ok(), count.parse().ok()));
        let Some((Some(line), Some(count))) = read else { bail!("llvm-cov printed `{row}`") };
        if line < *tests {
            add(&mut module.lines, line, count);
        }
    }
    Ok(())
}

/// Reads the regions of all functions: first line and column, last line and column, count, file, and more.
fn add_regions(
    text: &str,
    modules: &mut BTreeMap<String, Open>,
    name: impl Fn(&str) -> Option<String>,
) -> Result<()> {
    /// The kind of a region that is code: no gap, no skipped text, no expansion.
    const CODE: u64 = 0;
    let export: Json = serde_json::from_str(text).context("llvm-cov printed no JSON")?;
    let functions = export["data"][0]["functions"].as_array().context("llvm-cov printed no functions")?;
    for function in functions {
        for region in function["regions"].as_array().into_iter().flatten() {
            let numbers: Vec<u64> =
                region.as_array().into_iter().flatten().filter_map(Json::as_u64).collect();
            let [line, column, last_line, last_column, count, file, _, CODE] = numbers[..] else { continue };
            let path = function["filenames"][file as usize].as_str().and_then(&name);
            let Some((module, tests)) = path.and_then(|name| modules.get_mut(&name)) else { continue };
            if line < *tests {
                add(&mut module.regions, [line, column, last_line, last_column], count);
            }
        }
    }
    Ok(())
}

fn add<Place: Ord>(counts: &mut Counts<Place>, place: Place, count: u64) {
    let known = counts.entry(place).or_default();
    *known = count.max(*known);
}

fn print_table(modules: &BTreeMap<String, Module>) -> io::Result<()> {
    say!("{:<38} {:>6} {:>7} {:>8} {:>7}", "module", "lines", "reached", "regions", "reached")?;
    for folder in SOURCES {
        let inside = || modules.iter().filter(|(name, _)| name.starts_with(folder));
        for (name, module) in inside().filter(|(_, module)| !module.lines.is_empty()) {
            print_row(name, &[module])?;
        }
        print_row(folder, &inside().map(|(_, module)| module).collect::<Vec<_>>())?;
    }
    for (name, module) in modules {
        let missed: Vec<String> = module.missed_lines().map(|line| line.to_string()).collect();
        if !missed.is_empty() {
            say!("{name}: no test reaches line {}", missed.join(", "))?;
        }
    }
    Ok(())
}

fn print_row(name: &str, modules: &[&Module]) -> io::Result<()> {
    let percent = |all: usize, reached: usize| match all {
        0 => "-".to_owned(),
        _ => format!("{:.1} %", reached as f64 * 100.0 / all as f64),
    };
    let lines: usize = modules.iter().map(|module| module.lines.len()).sum();
    let missed: usize = modules.iter().map(|module| module.missed_lines().count()).sum();
    let regions: usize = modules.iter().map(|module| module.regions.len()).sum();
    let run = |module: &&Module| module.regions.values().filter(|count| **count > 0).count();
    let run: usize = modules.iter().map(run).sum();
    say!(
        "{name:<38} {lines:>6} {:>7} {regions:>8} {:>7}",
        percent(lines, lines - missed),
        percent(regions, run)
    )
}

/// Fails on a line that must be reached and is not.
fn check(modules: &BTreeMap<String, Module>) -> Result<()> {
    let whole = modules.iter().filter(|(name, _)| name.starts_with(WHOLE));
    if whole.clone().all(|(_, module)| module.lines.is_empty()) {
        bail!(
            "nothing of {WHOLE} was measured: remove the folder `coverage` of the target folder and run again"
        );
    }
    let mut wrong = Vec::new();
    for (name, module) in whole {
        let missed: Vec<String> = module.missed_lines().map(|line| line.to_string()).collect();
        let open = OPEN.iter().find(|(file, _)| name.ends_with(file)).map_or(0, |(_, count)| *count);
        if missed.len() > open {
            wrong.push(format!(
                "{name}: no test reaches line {}: write one, or take it out",
                missed.join(", ")
            ));
        } else if missed.len() < open {
            wrong.push(format!("{name} has {} lines without a test: lower its row in OPEN", missed.len()));
        }
    }
    if wrong.is_empty() {
        Ok(())
    } else {
        bail!("{}\n       (xtask/src/coverage.rs)", wrong.join("\n       "))
    }
}
