//! Tools that a test may be without, and what becomes of the test then.
//!
//! Here it is skipped and counted; in CI it fails, unless the row says why a CI machine may be without the tool. A skip
//! says itself aloud, past the capture of the test harness; started by `cargo xtask test` or `ci` it is also noted in
//! the file that [`FILE`] names, one line each, for their sum.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// The variable that names the file in which skips are noted.
pub const FILE: &str = "SKIPPED_TESTS";

/// A tool that a test needs.
#[derive(Debug)]
pub struct Need {
    /// What it is called.
    pub name: &'static str,
    /// What to type to have it.
    pub advice: &'static str,
    /// Why a CI machine may be without it; `None` = in CI its absence is a failure.
    pub may_lack_in_ci: Option<&'static str>,
}

/// A second opinion on the emulated core.
pub const QEMU: Need =
    Need { name: "qemu-system-arm", advice: "`apt-get install qemu-system-arm`", may_lack_in_ci: None };
/// A second place for the browser's module.
pub const NODE: Need = Need { name: "Node", advice: "`apt-get install nodejs`", may_lack_in_ci: None };
/// A browser in front of the page.
pub const CHROMIUM: Need = Need {
    name: "Chromium",
    advice: "`apt-get install chromium`, or name yours in CHROME",
    may_lack_in_ci: None,
};
/// Another reader of DBC files and another speaker on the bus: cantools and python-can.
pub const WITNESS: Need = Need {
    name: "Python with cantools and python-can",
    advice: "`cargo xtask test` installs it into target/venv",
    may_lack_in_ci: None,
};
/// A virtual CAN interface of Linux.
pub const VCAN: Need = Need {
    name: "interface vcan0",
    advice: "`sudo modprobe vcan; sudo ip link add dev vcan0 type vcan; sudo ip link set vcan0 up`",
    may_lack_in_ci: Some("a container has its host's kernel and may not load a module"),
};

impl Need {
    /// Says that `what` is not tested here, and why.
    ///
    /// # Panics
    /// In CI, unless the row says why a CI machine may be without this; and if the skip cannot be noted.
    pub fn skip(&self, what: &str) {
        let line = self.line(what);
        if let Err(line) = self.verdict(&line, crate::is_ci()) {
            panic!("{line}");
        }
        // Not by a macro: the harness would keep it back because the test passes.
        let _ = writeln!(std::io::stderr(), "skipped: {line}");
        if let Some(file) = std::env::var_os(FILE).map(PathBuf::from) {
            note(&file, &line).unwrap_or_else(|error| panic!("cannot write {}: {error}", file.display()));
        }
    }

    fn line(&self, what: &str) -> String {
        let Self { name, advice, may_lack_in_ci } = self;
        let excuse = may_lack_in_ci.map_or_else(String::new, |why| format!(" ({why})"));
        format!("{what}: no {name}{excuse}; {advice}")
    }

    fn verdict<'l>(&self, line: &'l str, in_ci: bool) -> Result<(), &'l str> {
        if in_ci && self.may_lack_in_ci.is_none() { Err(line) } else { Ok(()) }
    }
}

/// Adds a line by one write: several test programs note at once.
fn note(file: &Path, line: &str) -> std::io::Result<()> {
    let mut file = std::fs::OpenOptions::new().append(true).create(true).open(file)?;
    file.write_all(format!("{line}\n").as_bytes())
}

/// Returns a Python that has the witnesses, for `what`; without one that is skipped.
///
/// The one in `WITNESS_PYTHON`, else the one that `cargo xtask test` installs, else `python3`.
///
/// # Panics
/// Like [`Need::skip`].
#[must_use]
pub fn witness(what: &str) -> Option<PathBuf> {
    static FOUND: OnceLock<Option<PathBuf>> = OnceLock::new();
    let found = FOUND.get_or_init(|| {
        let named = std::env::var_os("WITNESS_PYTHON").map(PathBuf::from);
        let candidates = match named {
            Some(named) => vec![named],
            None => vec![crate::target().join("venv/bin/python"), "python3".into()],
        };
        candidates.into_iter().find(|python| has_witnesses(python))
    });
    if found.is_none() {
        WITNESS.skip(what);
    }
    found.clone()
}

/// Returns whether this Python has the witnesses.
#[must_use]
pub fn has_witnesses(python: &Path) -> bool {
    let mut probe = Command::new(python);
    probe.args(["-c", "import cantools, can, serial"]);
    let quiet = probe.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    quiet.status().is_ok_and(|status| status.success())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_skip_says_what_is_not_tested_why_and_what_to_type() {
        assert_eq!(QEMU.line("the core"), "the core: no qemu-system-arm; `apt-get install qemu-system-arm`");
        assert!(
            VCAN.line("frames").contains("(a container has its host's kernel"),
            "{}",
            VCAN.line("frames")
        );
    }

    #[test]
    fn in_ci_a_skip_is_a_failure_unless_the_machine_cannot_have_the_tool() {
        for need in [QEMU, CHROMIUM, WITNESS] {
            assert_eq!(need.verdict("line", true), Err("line"), "{need:?}");
            assert_eq!(need.verdict("line", false), Ok(()), "{need:?}");
        }
        assert_eq!(VCAN.verdict("line", true), Ok(()));
    }

    #[test]
    fn skips_are_noted_one_line_each_behind_what_is_there() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("skipped");
        note(&file, "one").unwrap();
        note(&file, "two").unwrap();
        assert_eq!(std::fs::read_to_string(file).unwrap(), "one\ntwo\n");
    }
}
