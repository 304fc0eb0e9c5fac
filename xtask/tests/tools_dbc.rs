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

/// Lints `text` and returns what is found, without the path of the file, and whether there is an error.
fn graded(text: &str) -> (Vec<String>, bool) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.dbc");
    std::fs::write(&path, text).unwrap();
    let path = path.display().to_string();
    let output = dbc(&[&path]);
    let found = String::from_utf8(output.stdout).unwrap();
    let lines = found.lines().map(|line| line.strip_prefix(&path).unwrap().to_owned());
    (lines.filter(|line| !line.starts_with("  ok")).collect(), output.status.code() == Some(1))
}

/// Lints `text`, in which nothing is bound, and returns what is found.
fn findings(text: &str) -> Vec<String> {
    let (found, wrong) = graded(text);
    assert_eq!(wrong, found.iter().any(|line| line.contains("not valid DBC")), "{found:#?}");
    found
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
        (gear, " SG_ gear : 1|4@1+ (1,0) [0|11] \"\"", "note: signal `gear` overlaps `drive_mode`"),
        (
            gear,
            " SG_ gear : 62|4@1+ (1,0) [0|11] \"\"",
            "warning: `gear` reaches beyond the 8 bytes of the message",
        ),
        (
            gear,
            " SG_ gear : 2|4@1+ (1,0) [0|99] \"\"",
            "note: range of `gear` is raw 0 to 99; its 4 bits hold 0 to 15",
        ),
        (gear, " SG_ drive_mode : 2|4@1+ (1,0) [0|11] \"\"", "signal `drive_mode` is used before"),
        (gear, " SG_ gear : 2|4@1+ (1,0 [0|11] \"\"", "not valid DBC: `SG_ gear : 2|4@1+ (1,0 [0|11]"),
        ("BO_ 2364605095 VCU2:", "BO_ 2364605095 VCU1:", "message `VCU1` is used before"),
        ("BO_ 2364605095 VCU2:", "BO_ 2364604839 VCU2:", "warning: identifier 2364604839 is used before"),
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
            |finding: &&String| finding.starts_with(&format!(":{line}:")) && finding.contains(problem);
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
        assert!(found[0].starts_with(&format!(":{line}:")) && found[0].contains(problem), "{found:#?}");
    }
}

#[test]
fn a_file_that_is_not_there_is_named() {
    let output = dbc(&["no/such.dbc"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stdout).unwrap().starts_with("no/such.dbc: cannot be read: "));
}

#[test]
fn an_encoding_is_said_and_no_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("gb.dbc");
    std::fs::write(&path, b"VERSION \"\xb4\xbf\xb5\xe7\"\n").unwrap();
    let output = dbc(&[path.to_str().unwrap()]);
    assert!(output.status.success(), "{output:?}");
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(
        said.contains("gb.dbc: note: is not UTF-8; read as gb18030: line 1 is `VERSION \"纯电\"`"),
        "{said}"
    );
}

#[test]
fn what_is_bound_and_cannot_be_had_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let (path, toml) = (folder.path().join("x.dbc"), folder.path().join("vehicle.toml"));
    let binding =
        std::fs::read_to_string(surroundings::root().join("vehicles/citybus/vehicle.toml")).unwrap();
    let (text, line) = broken(" SG_ gear : 2|4@1+", " SG_ gear : 62|4@1+");
    std::fs::write(&path, text).unwrap();
    assert!(dbc(&[path.to_str().unwrap()]).status.success(), "nothing binds it");
    std::fs::write(&toml, binding).unwrap();
    let output = dbc(&[path.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(
        said.contains("`gear` of VCU1 cannot be bound: ") && said.contains(&format!("x.dbc:{line}:2: ")),
        "{said}"
    );
}

#[test]
fn fix_mends_what_is_mechanical_and_writes_utf8() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.dbc");
    let text =
        b"VERSION \"\"\nNS_ :\nBS_:\nBU_: A\nBO_ 4096 M: 8 A\n SG_ s : 0|8@1+ (1,0) [0|256] \"\xb0C\" A\n";
    std::fs::write(&path, text).unwrap();
    let output = dbc(&["--fix", path.to_str().unwrap()]);
    assert!(output.status.success(), "{output:?}");
    let mended = std::fs::read_to_string(&path).unwrap();
    assert!(mended.contains("BO_ 2147487744 M") && mended.contains("[0|255] \"°C\""), "{mended}");
}

#[test]
fn of_many_notes_of_a_kind_the_first_is_printed_with_their_number() {
    let rows: String = (0..9).map(|at| format!(" SG_ s{at} : {at}|1@1+ (1,0) [0|1] \"\" A\n")).collect();
    let text = format!("VERSION \"\"\nNS_ :\nBS_:\nBU_: A\nBO_ 1 M: 8 A\n{rows}");
    let found = findings(&text);
    let comments: Vec<&String> =
        found.iter().filter(|line| line.contains("has no comment (CM_ SG_")).collect();
    assert_eq!(comments.len(), 1, "{found:#?}");
    assert!(
        comments[0].starts_with(":6:2: note: signal `s0`")
            && comments[0].ends_with("(and 8 more of this kind: --all)")
    );
}
