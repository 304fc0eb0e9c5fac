//! Recordings beside python-can: what it writes is read as it reads it, and what is written here it reads as we do.

mod program;

use program::xtask;
use std::path::Path;
use std::process::Command;
use surroundings::need;

/// Runs `corpus --logs` over a folder, which must agree with the second reader, and returns its table.
fn corpus(folder: &Path) -> String {
    let output = xtask().args(["corpus", "--logs"]).arg(folder).output().unwrap();
    let (table, said) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{table}{said}");
    table.into_owned()
}

#[test]
fn python_cans_files_are_read_as_it_reads_them_and_ours_by_it() {
    let Some(python) = need::witness("recordings") else { return };
    let folder = tempfile::tempdir().unwrap();
    let script = surroundings::root().join("tools/witness/write_logs.py");
    let status = Command::new(python).arg(script).arg(folder.path()).status().unwrap();
    assert!(status.success());
    let table = corpus(folder.path());
    // One frame is of CAN FD; traces hold no remote request, either.
    for (file, format, frames, fd) in [
        ("python.asc", "Vector ASC", 20_004, 1),
        ("python.blf", "Vector BLF", 20_004, 1),
        ("python.csv", "python-can CSV", 20_004, 0),
        ("python.log", "candump -l", 20_004, 1),
        ("python.trc", "PCAN trace", 20_003, 0),
    ] {
        let expected = format!(
            "{file:<52} {format:<22} {frames:>8} {:>7} {fd:>4} {:>6}  python-can: {frames} equal",
            0, 0
        );
        assert!(table.contains(&expected), "{expected}\n{table}");
    }
    let ours = folder.path().join("ours");
    std::fs::create_dir(&ours).unwrap();
    for ending in ["log", "asc", "csv"] {
        let (input, output) = (folder.path().join("python.blf"), ours.join(format!("a.{ending}")));
        let output = xtask().arg("convert").arg(input).arg(output).output().unwrap();
        assert!(output.status.success(), "{output:?}");
    }
    let table = corpus(&ours);
    assert_eq!(table.matches("python-can: 20004 equal").count(), 3, "{table}");
}

#[test]
fn the_sample_of_every_format_is_read_as_its_second_reader_reads_it() {
    if need::witness("recordings").is_none() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (number, format) in bench::log::FORMATS.iter().enumerate() {
        std::fs::write(folder.path().join(format!("{number}.sample")), format.sample).unwrap();
    }
    let table = corpus(folder.path());
    // Nothing but the reader here knows BUSMASTER's and CanKing's; one format has no sample.
    let equal = table.matches(": 2 equal").count();
    assert_eq!(equal, bench::log::FORMATS.len() - 3, "{table}");
}
