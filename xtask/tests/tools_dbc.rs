//! `cargo xtask dbc`: the repository's files are clean, and each wrong line is named.

mod program;

use program::xtask;
use std::process::Output;

fn dbc(arguments: &[&str]) -> Output {
    xtask().arg("dbc").args(arguments).output().unwrap()
}

fn bus() -> String {
    std::fs::read_to_string(surroundings::root().join("vehicles/citybus/citybus.dbc")).unwrap()
}

/// Lints `text` and returns what is found, without the path of the file.
fn findings(text: &str) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.dbc");
    std::fs::write(&path, text).unwrap();
    let path = path.display().to_string();
    let output = dbc(&[&path]);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("in 1 of 1 files"), "{said}");
    let found = String::from_utf8(output.stdout).unwrap();
    found.lines().map(|line| line.strip_prefix(&path).unwrap().into()).collect()
}

/// Returns the bus's file with `from` replaced in the first line that holds it, and that line's number.
fn broken(from: &str, to: &str) -> (String, usize) {
    let text = bus();
    let line = 1 + text.lines().position(|line| line.contains(from)).expect(from);
    (text.replacen(from, to, 1), line)
}

#[test]
fn the_vehicles_are_clean() {
    let output = dbc(&[]);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{said}");
    for name in ["citybus", "c5ev", "jiulong"] {
        let line = said.lines().find(|line| line.starts_with(&format!("vehicles/{name}/{name}.dbc")));
        assert!(line.is_some_and(|line| line.ends_with("  ok")), "{said}");
    }
}

#[test]
fn each_wrong_line_is_named() {
    let gear = " SG_ gear : 2|4@1+ (1,0) [0|11] \"\"";
    for (from, to, problem) in [
        (gear, " SG_ gear : 1|4@1+ (1,0) [0|11] \"\"", "`gear` overlaps `drive_mode`"),
        (gear, " SG_ gear : 62|4@1+ (1,0) [0|11] \"\"", "`gear` reaches beyond the 8 bytes of the message"),
        (
            gear,
            " SG_ gear : 2|4@1+ (1,0) [0|99] \"\"",
            "range of `gear` is raw 0 to 99; its 4 bits hold 0 to 15",
        ),
        (gear, " SG_ drive_mode : 2|4@1+ (1,0) [0|11] \"\"", "signal `drive_mode` is used before"),
        (gear, " SG_ gear : 2|4@1+ (1,0 [0|11] \"\"", "not valid DBC: `SG_ gear : 2|4@1+ (1,0 [0|11]"),
        ("BO_ 2364605095 VCU2:", "BO_ 2364605095 VCU1:", "message `VCU1` is used before"),
        ("BO_ 2364605095 VCU2:", "BO_ 2364604839 VCU2:", "identifier 2364604839 is used before"),
        (
            "[0|200] \"km/h\"",
            "[0|200] \"\"",
            "signal `vehicle_speed` is scaled by 0.00390625 and has no unit",
        ),
        ("[0|200] \"km/h\"", "[0|199.999] \"km/h\"", "limit 199.999 of `vehicle_speed` cannot be reached"),
        (
            "VAL_ 2364604839 gear",
            "VAL_ 2364604839 gear 77 \"seventy\"",
            "value 77 \"seventy\" does not fit in the 4 bits of `gear`",
        ),
    ] {
        let (text, line) = broken(from, to);
        let found = findings(&text);
        let names =
            |finding: &&String| finding.starts_with(&format!(":{line}: ")) && finding.contains(problem);
        assert!(found.iter().any(|finding| names(&finding)), "line {line}: {problem} in {found:#?}");
    }
}

#[test]
fn a_missing_comment_is_found_at_its_message_and_at_its_signal() {
    for (comment, place, problem) in [
        ("CM_ BO_ 2364604839 ", "BO_ 2364604839 ", "message `VCU1` has no comment"),
        ("CM_ SG_ 2364604839 gear ", " SG_ gear ", "signal `gear` has no comment"),
    ] {
        let text: String =
            bus().lines().filter(|line| !line.starts_with(comment)).map(|l| format!("{l}\n")).collect();
        let line = 1 + text.lines().position(|line| line.starts_with(place)).unwrap();
        let found = findings(&text);
        assert_eq!(found.len(), 1, "{found:#?}");
        assert!(found[0].starts_with(&format!(":{line}: {problem}")), "{found:#?}");
    }
}

#[test]
fn a_file_that_is_not_there_or_not_utf8_is_named() {
    let said = |path: &str| {
        let output = dbc(&[path]);
        assert_eq!(output.status.code(), Some(1));
        String::from_utf8(output.stdout).unwrap()
    };
    assert!(said("no/such.dbc").starts_with("no/such.dbc: cannot be read: "));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("gb.dbc");
    std::fs::write(&path, b"VERSION \"\xb4\xbf\xb5\xe7\"\n").unwrap();
    assert!(said(path.to_str().unwrap()).contains("gb.dbc:1: byte 0xB4 is not UTF-8 text"));
}
