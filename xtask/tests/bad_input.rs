//! Bad input gets an error that names file and line, and the command fails.

mod program;

use program::xtask;
use std::path::Path;

/// Runs `cargo xtask` with `arguments`, which must fail, and returns what it said on stderr.
fn complaint(arguments: &[&str]) -> String {
    let output = xtask().args(arguments).output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{arguments:?} must fail: {output:?}");
    String::from_utf8(output.stderr).unwrap()
}

fn written(folder: &Path, name: &str, content: impl AsRef<[u8]>) -> String {
    let path = folder.join(name);
    std::fs::write(&path, content).unwrap();
    path.display().to_string()
}

#[test]
fn a_missing_log_is_named() {
    let said = complaint(&["replay", "no/such.log"]);
    assert!(said.contains("no/such.log: cannot read the log"), "{said}");
}

#[test]
fn a_malformed_log_is_named_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let log = written(
        folder.path(),
        "bad.log",
        "(1.0) can0 0CF101A7#0102030405060708\n(2.0) can0 0CF101A7#01020\n",
    );
    for command in [&["replay"][..], &["run", "--headless", "--log"]] {
        let said = complaint(&[command, &[log.as_str()]].concat());
        assert!(
            said.contains("bad.log:2:21: `01020` is not pairs of hexadecimal digits (candump -l)"),
            "{said}"
        );
    }
}

#[test]
fn an_elf_for_another_chip_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    // The head of an ELF for a 64-bit PC.
    let mut elf = vec![0; 64];
    elf[..20].copy_from_slice(b"\x7fELF\x02\x01\x01\0\0\0\0\0\0\0\0\0\x02\0\x3e\0");
    elf[20] = 1;
    let elf = written(folder.path(), "pc.elf", elf);
    let said = complaint(&["run", "--headless", "--elf", &elf]);
    assert!(said.contains("pc.elf"), "{said}");
    assert!(said.contains("ARM"), "{said}");
    let text = written(folder.path(), "notes.elf", "not an ELF");
    let said = complaint(&["run", "--headless", "--elf", &text]);
    assert!(said.contains("notes.elf") && said.contains("not an ELF"), "{said}");
}
