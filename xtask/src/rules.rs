//! Maps every rule of the source documents to the tests that name it, or to the page that states it.
//!
//! The rules stand in docs/rules.csv: number, who must do it, a phrase of our own, and a page where no test can show it.
//! A test names a rule in its name (`bus_r017_...`, `bus_r022_to_bus_r025_...`) or in a comment (`BUS-R017`); a scenario
//! names it in its `rules`. Rules of other nodes are kept by the virtual vehicle and shown in its tests.

use crate::out::say;
use crate::workspace;
use anyhow::{Context, Result, bail};
use clap::Args;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use virtual_vehicle::Kind;

/// What to do with the page.
#[derive(Args, Debug, Default)]
pub struct Options {
    /// Compares with the committed page and writes nothing.
    #[arg(long)]
    pub check: bool,
}

const LIST: &str = "docs/rules.csv";
const PAGE: &str = "docs/reference/rules.md";
/// Where tests are looked for.
const SOURCES: &[&str] = &["app", "bench", "drivers", "protocol-core", "vehicles", "xtask"];

const OWN: &str = "xtask/src/rules.rs";
/// Where scenario files are.
const SCENARIOS: &str = "bench/scenarios/";

/// One rule of a document.
struct Rule {
    number: String,
    actors: String,
    subject: String,
    /// Page that states it, where no test can show it; empty otherwise.
    page: String,
}

/// Tests by rule number: path and name; a scenario is its whole file.
type Tests = BTreeMap<String, BTreeSet<(String, String)>>;

/// Writes the page of rules, or checks that it is up to date and that every rule is shown.
///
/// # Errors
/// If a rule has neither a test nor a page, or the committed page is stale.
pub fn run(options: &Options) -> Result<()> {
    let root = workspace::root();
    let list = std::fs::read_to_string(root.join(LIST)).with_context(|| format!("{LIST}: cannot be read"))?;
    let rules = parse(&list)?;
    let tests = tests(&root)?;
    let mut missing = Vec::new();
    for rule in &rules {
        let (number, page) = (&rule.number, &rule.page);
        if page.is_empty() && !tests.contains_key(number) {
            missing.push(format!(
                "{number} ({}): no test and no scenario names it; name one after it, or give it a page in {LIST}",
                rule.subject
            ));
        }
        let is_stated =
            || std::fs::read_to_string(root.join(page)).is_ok_and(|text| names(&text).contains(number));
        if !page.is_empty() && !is_stated() {
            missing.push(format!("{number}: {LIST} says that {page} states it, which it does not"));
        }
    }
    for number in tests.keys().filter(|number| !rules.iter().any(|rule| rule.number == **number)) {
        let (path, name) = tests[number].first().cloned().unwrap_or_default();
        let name = if name.is_empty() { "the scenario" } else { &name };
        missing.push(format!("{path}: {name} names {number}, which {LIST} does not have"));
    }
    if !missing.is_empty() {
        bail!("{}", missing.join("\n       "));
    }
    let text = page(&rules, &tests)?;
    let file = root.join(PAGE);
    let old = std::fs::read_to_string(&file).unwrap_or_default();
    if options.check {
        if old != text {
            let line = old.lines().zip(text.lines()).take_while(|(old, new)| old == new).count() + 1;
            bail!(
                "{PAGE}:{line}: differs from what the tests name: run `cargo xtask rules` and commit the result"
            );
        }
    } else if old != text {
        std::fs::write(&file, text).with_context(|| format!("{PAGE}: cannot be written"))?;
        say!("{PAGE}")?;
    }
    let tested = rules.iter().filter(|rule| tests.contains_key(&rule.number)).count();
    say!("{} rules: {tested} with tests, {} on a page", rules.len(), rules.len() - tested)?;
    Ok(())
}

/// Reads the list: a header, then `rule,actors,subject,page`; no field holds a comma or a quote.
fn parse(list: &str) -> Result<Vec<Rule>> {
    let mut rules: Vec<Rule> = Vec::new();
    for (line, row) in (1..).zip(list.lines()).skip(1) {
        let fields: Vec<&str> = row.split(',').collect();
        let [number, actors, subject, page] = fields[..] else {
            bail!("{LIST}:{line}: {} fields where there should be 4", fields.len());
        };
        if names(number) != BTreeSet::from([number.to_owned()]) {
            bail!("{LIST}:{line}: `{number}` is not a rule's number, for example BUS-R017");
        }
        if rules.iter().any(|rule| rule.number == number) {
            bail!("{LIST}:{line}: {number} is there twice");
        }
        let [number, actors, subject, page] = [number, actors, subject, page].map(str::to_owned);
        rules.push(Rule { number, actors, subject, page });
    }
    Ok(rules)
}

/// Finds every test and the rules that it names.
fn tests(root: &Path) -> Result<Tests> {
    let mut tests = Tests::new();
    for folder in SOURCES {
        for file in rust_files(&root.join(folder))? {
            let text = std::fs::read_to_string(&file)
                .with_context(|| format!("{}: cannot be read", file.display()))?;
            let path = file.strip_prefix(root).unwrap_or(&file).to_string_lossy().replace('\\', "/");
            // The examples in this module's own tests show nothing.
            if path == OWN {
                continue;
            }
            for (name, numbers) in tests_of(&text) {
                for number in numbers {
                    tests.entry(number).or_default().insert((path.clone(), name.clone()));
                }
            }
        }
    }
    for kind in Kind::ALL {
        for scenario in bench::scenario::load(kind)? {
            let path = format!("bench/scenarios/{}", scenario.file);
            for number in scenario.rules {
                tests.entry(number).or_default().insert((path.clone(), String::new()));
            }
        }
    }
    Ok(tests)
}

fn rust_files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let entries =
        std::fs::read_dir(folder).with_context(|| format!("{}: cannot be read", folder.display()))?;
    for entry in entries {
        let path = entry?.path();
        if path.is_dir() && path.file_name().is_some_and(|name| name != "target") {
            files.extend(rust_files(&path)?);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
    Ok(files)
}

/// Returns the tests of a source file and the rules that each names, in its name or in the comments on it and in it.
fn tests_of(text: &str) -> Vec<(String, BTreeSet<String>)> {
    let lines: Vec<&str> = text.lines().collect();
    let is_comment = |line: usize| lines.get(line).is_some_and(|line| line.trim_start().starts_with("//"));
    let marks: Vec<usize> = (0..lines.len()).filter(|&line| lines[line].trim() == "#[test]").collect();
    // A test begins with the comments on it.
    let begin = |&mark: &usize| (0..mark).rev().find(|&line| !is_comment(line)).map_or(0, |line| line + 1);
    let begins: Vec<usize> = marks.iter().map(begin).chain([lines.len()]).collect();
    let mut tests = Vec::new();
    for (pair, &mark) in begins.windows(2).zip(&marks) {
        let body = &lines[pair[0]..pair[1].max(mark)];
        let name =
            lines[mark..].iter().find_map(|line| line.trim_start().strip_prefix("fn ")?.split('(').next());
        if let Some(name) = name {
            tests.push((name.to_owned(), names(&body.join("\n"))));
        }
    }
    tests
}

/// Returns every rule number in a text: `BUS-R017`, `bus_r017`, and all of `BUS-R022 to BUS-R025`.
fn names(text: &str) -> BTreeSet<String> {
    let text = text.to_ascii_uppercase().replace('_', "-");
    let mut found = BTreeSet::new();
    // Where the last number ended, and what it was.
    let mut last: Option<(usize, &str, u32)> = None;
    for (at, _) in text.match_indices("-R") {
        let Some(document) = ["BUS", "JL", "C5"].into_iter().find(|document| text[..at].ends_with(document))
        else {
            continue;
        };
        let before = text[..at - document.len()].chars().next_back();
        let digits = &text[at + 2..text.len().min(at + 5)];
        let Ok(number) = digits.parse::<u32>() else { continue };
        if digits.len() != 3 || before.is_some_and(char::is_alphanumeric) {
            continue;
        }
        let first = match last {
            Some((end, same, first))
                if same == document && matches!(&text[end..at - document.len()], " TO " | "-TO-") =>
            {
                first
            }
            _ => number,
        };
        found.extend((first..=number).map(|number| format!("{document}-R{number:03}")));
        last = Some((at + 5, document, number));
    }
    found
}

fn page(rules: &[Rule], tests: &Tests) -> Result<String> {
    let mut text = String::from(
        "# Rules\n\n<!-- Generated: cargo xtask rules -->\n\n\
         What the source documents ask for, who must do it, and what shows that it is done. Rules of other nodes are\n\
         those of the virtual vehicle.\n",
    );
    for (document, title) in [("BUS", "citybus"), ("JL", "jiulong"), ("C5", "c5ev")] {
        writeln!(text, "\n## {title}\n\n| Rule | Actor | Subject | Shown by |\n|---|---|---|---|")?;
        for rule in rules.iter().filter(|rule| rule.number.starts_with(document)) {
            let mut shown: Vec<String> = Vec::new();
            let mut by_file: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
            for (path, name) in tests.get(&rule.number).into_iter().flatten() {
                by_file.entry(path).or_default().push(name);
            }
            // One line for all scenarios: their names say what they show.
            let (scenarios, files): (Vec<_>, Vec<_>) =
                by_file.into_iter().partition(|(path, _)| path.starts_with(SCENARIOS));
            for (path, names) in files {
                shown.push(format!("[{path}](../../{path}): {}", names.join(", ")));
            }
            if !scenarios.is_empty() {
                let link = |(path, _): &(&str, Vec<&str>)| {
                    let name = path.trim_start_matches(SCENARIOS).trim_end_matches(".toml");
                    format!("[{name}](../../{path})")
                };
                shown
                    .push(format!("scenarios {}", scenarios.iter().map(link).collect::<Vec<_>>().join(", ")));
            }
            if !rule.page.is_empty() {
                shown.push(format!("[{0}](../../{0})", rule.page));
            }
            let actors = rule.actors.replace('+', ", ");
            writeln!(text, "| {} | {actors} | {} | {} |", rule.number, rule.subject, shown.join("; "))?;
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Vec<String> {
        names(text).into_iter().collect()
    }

    #[test]
    fn rule_numbers_are_found_in_names_comments_and_ranges() {
        assert_eq!(found("fn bus_r017_the_chime()"), ["BUS-R017"]);
        assert_eq!(found("// JL-R013, C5-R005."), ["C5-R005", "JL-R013"]);
        assert_eq!(found("bus_r022_to_bus_r024_lamps"), ["BUS-R022", "BUS-R023", "BUS-R024"]);
        assert_eq!(found("BUS-R027 to BUS-R028, BUS-R033"), ["BUS-R027", "BUS-R028", "BUS-R033"]);
        let none: [&str; 0] = [];
        assert_eq!(found("BUS-17 OMNIBUS-R017 BUS-R17 BUS-RED 故障-R017"), none);
    }

    #[test]
    fn a_comment_on_a_test_belongs_to_it_and_not_to_the_one_before() {
        let source = "#[test]\nfn first() {\n    // BUS-R001\n}\n\n/// BUS-R002\n#[test]\nfn second() {}\n";
        let tests = tests_of(source);
        let tests: Vec<_> = tests.iter().map(|(name, numbers)| (name.as_str(), numbers.len())).collect();
        assert_eq!(tests, [("first", 1), ("second", 1)]);
        assert_eq!(tests_of(source)[1].1, BTreeSet::from(["BUS-R002".into()]));
    }

    #[test]
    fn a_list_with_a_wrong_row_is_refused_with_its_line() {
        let error = |list: &str| parse(list).err().map(|error| error.to_string()).unwrap_or_default();
        assert!(error("rule,actors,subject,page\nBUS-R001,all,x").starts_with("docs/rules.csv:2: 3 fields"));
        assert!(error("h\nBUS-1,all,x,").contains("not a rule's number"));
        assert!(
            error("h\nBUS-R001,all,x,\nBUS-R001,all,x,")
                .contains("docs/rules.csv:3: BUS-R001 is there twice")
        );
    }
}
