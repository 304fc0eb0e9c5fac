//! What a DBC must never do: give a wrong value silently, lose a message, or generate what is not Rust.

use protocol_core::model::Reading;
use protocol_core::{CanId, Readings, Value};
use std::fmt::Write;
use vehicle_compiler::{RunTime, lint};

const DBC: &str = r#"VERSION ""

NS_ :

BS_:

BU_: Engine Cluster

BO_ 513 Status: 8 Engine
 SG_ page M : 0|8@1+ (1,0) [0|255] "" Cluster
 SG_ volts m0 : 8|32@1- (1,0) [0|1000] "V" Cluster
 SG_ soc m1 : 8|8@1+ (0.5,0) [0|100] "%" Cluster

BO_ 514 Level: 8 Engine
 SG_ level : 0|8@1+ (1,0) [0|255] "" Cluster

CM_ BO_ 513 "Status";
CM_ SG_ 513 page "Page";
CM_ SG_ 513 volts "Volts";
CM_ SG_ 513 soc "State of charge";
CM_ BO_ 514 "Level";
CM_ SG_ 514 level "Level";
BA_DEF_ "BusSpeed" INT 0 1000000;
BA_DEF_ BO_ "GenMsgCycleTime" INT 0 65535;
BA_DEF_ BO_ "VFrameFormat" ENUM "StandardCAN","ExtendedCAN","reserved","J1939PG","StandardCAN_FD";
BA_DEF_DEF_ "BusSpeed" 250000;
BA_DEF_DEF_ "GenMsgCycleTime" 100;
BA_DEF_DEF_ "VFrameFormat" "StandardCAN";
"#;

const TOML: &str = r#"[vehicle]
zh = "车"
en = "Car"

[nodes]
Engine = { node = "vcu", zh = "发动机", en = "Engine" }

[rx.Level]
vehicle.fault_code = "level"
"#;

fn compiled(dbc: &str) -> Vec<String> {
    bound(dbc, "")
}

/// What is wrong if these lines are bound too.
fn bound(dbc: &str, lines: &str) -> Vec<String> {
    match vehicle_compiler::compile("car", ("car.dbc", dbc), ("vehicle.toml", &format!("{TOML}{lines}\n"))) {
        Ok(_) => Vec::new(),
        Err(found) => found.0.iter().map(ToString::to_string).collect(),
    }
}

fn linted(dbc: &str) -> Vec<String> {
    let found = lint::lint("car.dbc", dbc).0;
    let said = found.iter().map(ToString::to_string);
    said.filter(|line| !line.contains("has no comment")).collect()
}

/// Lint and generator say the same of a text: this, and nothing else.
fn both_say(dbc: &str, expected: &[&str]) {
    assert_eq!(linted(dbc), expected, "lint");
    assert_eq!(compiled(dbc), expected, "codegen");
}

/// Lint says this, and it keeps nobody from binding what is right.
fn only_lint_says(dbc: &str, expected: &[&str]) {
    assert_eq!(linted(dbc), expected, "lint");
    assert_eq!(compiled(dbc), Vec::<String>::new(), "codegen");
}

/// Lint warns of it; to bind `level` is an error that names the same place.
fn level_cannot_be_had(dbc: &str, line: usize, column: usize, what: &str, reason: &str) {
    assert_eq!(linted(dbc), [format!("car.dbc:{line}:{column}: warning: {reason}")], "lint");
    let said = format!("{what} cannot be bound: car.dbc:{line}:{column}: {reason}");
    let found = compiled(dbc);
    assert!(found.len() == 1 && found[0].ends_with(&said), "{found:#?}");
}

/// Text of the generated vehicle that binds these lines too.
fn text(dbc: &str, lines: &str) -> String {
    let toml = format!("{TOML}{lines}\n");
    let text = vehicle_compiler::compile("car", ("car.dbc", dbc), ("vehicle.toml", &toml));
    text.unwrap_or_else(|error| panic!("{error}"))
}

/// Model values after one frame of Status, by the interpreter.
fn status(dbc: &str, lines: &str, data: [u8; 8]) -> Vec<(String, Option<i32>)> {
    let toml = format!("{TOML}{lines}\n");
    let car = RunTime::of_texts("car", ("car.dbc", dbc), Some(("vehicle.toml", &toml)));
    let car = car.unwrap_or_else(|error| panic!("{error}"));
    let mut readings = Readings::new();
    car.decode(0, &data, &mut readings);
    let known =
        Value::ALL.iter().filter_map(|value| Some((value.path().to_owned(), readings.get(*value)?.0)));
    known
        .map(|(path, reading)| (path, if let Reading::Valid(number) = reading { Some(number) } else { None }))
        .collect()
}

fn only(path: &str, number: Option<i32>) -> Vec<(String, Option<i32>)> {
    vec![(path.into(), number)]
}

/// The text with one more line at its end, which is line 29.
fn with(line: &str) -> String {
    format!("{DBC}{line}\n")
}

fn replaced(old: &str, new: &str) -> String {
    assert!(DBC.contains(old), "{old}");
    DBC.replacen(old, new, 1)
}

#[test]
fn the_text_itself_is_right() {
    both_say(DBC, &[]);
}

const VOLTS: &str = "[rx.Status]\nbattery.voltage = \"volts\"";

#[test]
fn an_ieee_float_is_read_as_one_in_integers() {
    let dbc = with("SIG_VALTYPE_ 513 volts : 1;");
    only_lint_says(&dbc, &[]);
    let of = |bits: u32| {
        let [a, b, c, d] = bits.to_le_bytes();
        status(&dbc, VOLTS, [0, a, b, c, d, 0, 0, 0])
    };
    for (volts, counts) in [
        (400.0f32, Some(4000)),
        (412.25, Some(4122)),
        (0.0, Some(0)),
        (-0.0, Some(0)),
        (1000.0, Some(10_000)),
        (1000.1, None),
        (-0.1, None),
        (f32::NAN, None),
        (f32::INFINITY, None),
        (f32::MIN_POSITIVE / 2.0, Some(0)),
    ] {
        assert_eq!(of(volts.to_bits()), only("battery.voltage", counts), "{volts}");
    }
    let text = text(&dbc, VOLTS);
    assert!(text.contains("codec::float32_counts(raw, 10, 0, 1)") && !text.contains("f32"), "no float in it");
    only_lint_says(&with("SIG_VALTYPE_ 513 volts : 0;"), &[]);
}

#[test]
fn a_float_of_the_wrong_length_cannot_be_bound() {
    let dbc = with("SIG_VALTYPE_ 513 volts : 2;");
    let reason = "`volts` is an IEEE float of 64 bits (SIG_VALTYPE_), but has 32";
    only_lint_says(&dbc, &[&format!("car.dbc:29:1: warning: {reason}")]);
    assert_eq!(
        bound(&dbc, VOLTS),
        [format!("vehicle.toml:11: `volts` of Status cannot be bound: car.dbc:29:1: {reason}")]
    );
}

#[test]
fn a_value_comes_from_every_page_of_a_multiplexer_range() {
    let dbc = with("SG_MUL_VAL_ 513 soc page 1-1, 3-5; SG_MUL_VAL_ 513 volts page 0-0;");
    only_lint_says(&dbc, &[]);
    let soc = "[rx.Status]\nbattery.soc = \"soc\"";
    for page in 0..=255 {
        let expected = if [1, 3, 4, 5].contains(&page) { only("battery.soc", Some(500)) } else { Vec::new() };
        assert_eq!(status(&dbc, soc, [page, 100, 0, 0, 0, 0, 0, 0]), expected, "page {page}");
    }
    assert!(text(&dbc, soc).contains("if matches!(frame.page_raw(), 1..=1 | 3..=5) {"));
    only_lint_says(
        &with("SG_MUL_VAL_ 513 soq page 1-1;"),
        &["car.dbc:29:1: warning: SG_MUL_VAL_ of a signal that does not exist: `soq`"],
    );
}

#[test]
fn a_multiplexer_behind_a_multiplexer_needs_both() {
    let dbc = replaced(
        "SG_ soc m1 : 8|8",
        "SG_ half m1M : 8|8@1+ (1,0) [0|255] \"\" Cluster\n SG_ soc m7 : 16|8",
    ) + "SG_MUL_VAL_ 513 half page 1-1;\nSG_MUL_VAL_ 513 volts page 0-0;\nSG_MUL_VAL_ 513 soc half 7-7;\n";
    only_lint_says(&dbc, &[]);
    let soc = "[rx.Status]\nbattery.soc = \"soc\"";
    for (page, half, seen) in [(1, 7, true), (0, 7, false), (1, 6, false), (7, 1, false)] {
        let expected = if seen { only("battery.soc", Some(400)) } else { Vec::new() };
        assert_eq!(status(&dbc, soc, [page, half, 80, 0, 0, 0, 0, 0]), expected, "{page} {half}");
    }
    assert!(text(&dbc, soc).contains("if frame.page_raw() == 1 && frame.half_raw() == 7 {"));
}

#[test]
fn a_multiplexed_signal_whose_multiplexer_is_not_known_cannot_be_bound() {
    for (old, new, reason) in [
        ("soc m1", "soc m256", "`soc` is sent at 256, which the 8 bits of `page` never hold"),
        ("soc m1", "soc m", "`soc` is multiplexed (`m`) but does not say at which value"),
    ] {
        let dbc = replaced(old, new);
        only_lint_says(&dbc, &[&format!("car.dbc:12:2: warning: {reason}")]);
        let said = bound(&dbc, "[rx.Status]\nbattery.soc = \"soc\"");
        assert_eq!(
            said,
            [format!("vehicle.toml:11: `soc` of Status cannot be bound: car.dbc:12:2: {reason}")]
        );
    }
    let none = linted(&replaced("page M", "page"));
    assert_eq!(none.len(), 2, "{none:#?}");
    assert!(none[0].contains("`volts` is multiplexed, and its message has 0 multiplexers"), "{none:#?}");
}

#[test]
fn frames_that_are_not_classic_can_cannot_be_bound() {
    let fd = "message `Level` is CAN FD (StandardCAN_FD); only classic CAN is received here";
    for value in ["4", "\"StandardCAN_FD\""] {
        level_cannot_be_had(&with(&format!("BA_ \"VFrameFormat\" BO_ 514 {value};")), 29, 1, "`Level`", fd);
    }
    let long = "message `Level` has 12 bytes; classic CAN has 8";
    level_cannot_be_had(&replaced("BO_ 514 Level: 8", "BO_ 514 Level: 12"), 14, 1, "`Level`", long);
}

#[test]
fn a_j1939_group_is_heard_from_any_source_with_any_priority() {
    let dbc = DBC.replace("514", "2364540158") + "BA_ \"VFrameFormat\" BO_ 2364540158 3;\n";
    only_lint_says(&dbc, &[]);
    // 0x0CF004FE: the group without priority and source.
    assert!(text(&dbc, "").contains("RxMessage { id: CanId::extended(0x00F004FE), name: \"Level\""));
    let car = RunTime::of_texts("car", ("car.dbc", &dbc), None).expect("a DBC");
    let heard = |id: u32| {
        car.network.message_of(CanId::extended(id)).map(|index| car.network.messages[index].name.as_str())
    };
    for id in [0x0CF0_0400, 0x18F0_0417, 0x0CF0_04FE] {
        assert_eq!(heard(id), Some("Level"), "{id:08X}");
    }
    for id in [0x0CF0_0500, 0x0DF0_0400] {
        assert_eq!(heard(id), None, "{id:08X}");
    }
    // The same group with another priority and source is the same message.
    let twice =
        dbc.replace("BO_ 513 Status", "BO_ 2565866496 Status") + "BA_ \"VFrameFormat\" BO_ 2565866496 3;\n";
    let said = linted(&twice);
    assert!(
        said.iter().any(|line| line.contains("identifier 2364540158 is used before, in line 9")),
        "{said:#?}"
    );
    let exact = DBC.replace("514", "2364540158") + "BA_ \"VFrameFormat\" BO_ 2364540158 1;\n";
    assert!(text(&exact, "").contains("RxMessage { id: CanId::extended(0x0CF004FE), name: \"Level\""));
}

#[test]
fn an_identifier_out_of_range_is_not_cut_to_another() {
    for (id, said) in [
        ("2048", "(0x800) has more than 11 bits: write 2147485696 if it has 29 (bit 31 set)"),
        ("218042932", "(0xCFF1234) has more than 11 bits: write 2365526580 if it has 29 (bit 31 set)"),
        ("536870912", "(0x20000000) has more than 29 bits"),
        ("2684354560", "(0x20000000) has more than 29 bits"),
        ("4294967295", "(0x7FFFFFFF) has more than 29 bits"),
    ] {
        let reason = format!("identifier {id} of `Level` {said}");
        level_cannot_be_had(&DBC.replace("514", id), 14, 1, "`Level`", &reason);
    }
    for id in ["0", "2047", "2147483648", "2684354559"] {
        both_say(&DBC.replace("514", id), &[]);
    }
}

#[test]
fn two_messages_on_one_identifier_cannot_be_bound() {
    let reason = "identifier 513 is used before, in line 9";
    level_cannot_be_had(&DBC.replace("514", "513"), 14, 1, "`Level`", reason);
}

#[test]
fn one_name_for_two_cannot_be_bound() {
    let messages = replaced("514 Level", "514 Status");
    only_lint_says_then(&messages, "car.dbc:14:1: warning: message `Status` is used before, in line 9");
    let signals = replaced("SG_ soc m1", "SG_ volts m1").replace("CM_ SG_ 513 soc", "CM_ SG_ 513 volts");
    assert_eq!(linted(&signals), ["car.dbc:12:2: warning: signal `volts` is used before, in line 11"]);
    let said = bound(&signals, VOLTS);
    assert!(said[0].ends_with("car.dbc:12:2: signal `volts` is used before, in line 11"), "{said:?}");
}

fn only_lint_says_then(dbc: &str, expected: &str) {
    assert_eq!(linted(dbc), [expected]);
    let toml = TOML.replace("rx.Level", "rx.Status").replace("\"level\"", "\"page\"");
    let found = vehicle_compiler::compile("car", ("car.dbc", dbc), ("vehicle.toml", &toml))
        .expect_err("two of a name");
    assert!(found.to_string().contains("`Status` cannot be bound: car.dbc:14:1: "), "{found}");
}

#[test]
fn entries_on_one_line_are_all_read() {
    let late = "250000; BO_ 515 Late: 8 Engine\n SG_ late : 0|8@1+ (1,0) [0|255] \"\" Cluster";
    let dbc = replaced("250000;", late);
    both_say(&dbc, &[]);
    let text = vehicle_compiler::compile("car", ("car.dbc", &dbc), ("vehicle.toml", TOML));
    assert!(text.is_ok_and(|text| text.contains("pub const fn late_raw(self)")), "the signal is not lost");
}

#[test]
fn a_value_table_or_an_attribute_is_given_once() {
    let table = "this value table is given before, in line 29";
    let twice = with("VAL_ 514 level 0 \"none\" ;\nVAL_ 514 level 1 \"some\" ;");
    level_cannot_be_had(&twice, 30, 1, "`level` of Level", table);
    let cycle = "GenMsgCycleTime is given before, in line 29";
    let twice = with("BA_ \"GenMsgCycleTime\" BO_ 514 10;\nBA_ \"GenMsgCycleTime\" BO_ 514 20;");
    level_cannot_be_had(&twice, 30, 1, "`Level`", cycle);
}

#[test]
fn names_that_become_one_in_rust_are_numbered() {
    let messages = replaced("514 Level", "514 STATUS");
    assert_eq!(linted(&messages), Vec::<String>::new());
    let toml = TOML.replace("rx.Level", "rx.STATUS");
    let text = vehicle_compiler::compile("car", ("car.dbc", &messages), ("vehicle.toml", &toml));
    let text = text.unwrap_or_else(|error| panic!("{error}"));
    assert!(text.contains("pub struct Status(") && text.contains("pub struct Status2("));
    for (other, function) in [("Volts", "volts_2_raw"), ("volts_raw", "volts_raw_2_raw")] {
        let dbc = replaced("SG_ soc m1", &format!("SG_ {other} m1"))
            .replace("SG_ 513 soc", &format!("SG_ 513 {other}"));
        only_lint_says(&dbc, &[]);
        let text = self::text(&dbc, &format!("[rx.Status]\nbattery.soc = \"{other}\""));
        assert!(text.contains(&format!("let raw = frame.{function}();")), "{other}");
    }
}

#[test]
fn a_range_beyond_the_bits_is_limited_to_them() {
    let dbc = replaced("(0.5,0) [0|100]", "(0.5,0) [-10|1E+300]");
    let said =
        "car.dbc:12:2: note: range of `soc` is raw -20 to beyond; its 8 bits hold 0 to 255, which is taken";
    assert_eq!(linted(&dbc), [said]);
    let soc = "[rx.Status]\nbattery.soc = \"soc\"";
    assert_eq!(status(&dbc, soc, [1, 255, 0, 0, 0, 0, 0, 0]), only("battery.soc", Some(1275)));
}

#[test]
fn a_long_factor_is_taken_as_the_nearest_short_one_with_its_error() {
    let dbc = replaced("(0.5,0) [0|100]", "(0.3921568627455,0) [0|0]");
    let soc = "[rx.Status]\nbattery.soc = \"soc\"";
    let comment = "// The factor as a short fraction: at most ";
    assert!(text(&dbc, soc).lines().any(|line| line.contains(comment) && line.ends_with("e-9 counts off.")));
    for raw in 0..=255u8 {
        let expected = (f64::from(raw) * 3.921568627455 + 1e-9).floor() as i32;
        assert_eq!(
            status(&dbc, soc, [1, raw, 0, 0, 0, 0, 0, 0]),
            only("battery.soc", Some(expected)),
            "{raw}"
        );
    }
    let wild = replaced("(0.5,0) [0|100]", "(999999999999999999999999,0) [0|0]");
    assert_eq!(bound(&wild, soc), ["vehicle.toml:11: `soc` does not fit in 31 bits of `battery.soc`"]);
}

#[test]
fn a_signal_of_64_bits_is_read_whole() {
    let dbc = replaced("level : 0|8@1+ (1,0) [0|255]", "level : 7|64@0+ (1,0) [0|1000]");
    only_lint_says(&dbc, &[]);
    assert!(text(&dbc, "").contains("pub const fn level_raw(self) -> u64 { u64::from_be_bytes("));
    let whole = RunTime::of_texts("car", ("car.dbc", &dbc), None).expect("a DBC");
    let level = &whole.network.messages[1].signals[0];
    assert_eq!(level.raw(&[0xFF; 8]), i128::from(u64::MAX));
    assert_eq!(level.value(level.raw(&[0xFF; 8])), "18446744073709551615");
}

#[test]
fn a_long_name_is_the_name_and_the_short_one_still_finds_it() {
    let dbc = with(
        "BA_ \"SystemSignalLongSymbol\" SG_ 514 level \"level_of_the_tank_in_the_back\";\nVAL_ 514 level 0 \"none\" 1 \"low\" ;",
    );
    let map = "vehicle.fault_code = { signal = \"level\", map = { none = 0, low = 7 } }";
    for name in ["level", "level_of_the_tank_in_the_back"] {
        let toml =
            TOML.replace("vehicle.fault_code = \"level\"", &map.replace("\"level\"", &format!("\"{name}\"")));
        let text = vehicle_compiler::compile("car", ("car.dbc", &dbc), ("vehicle.toml", &toml));
        assert!(text.is_ok_and(|text| text.contains("frame.level_of_the_tank_in_the_back_raw()")), "{name}");
    }
}

#[test]
fn a_number_too_large_for_the_parser_is_told_with_its_line() {
    both_say(
        &with("VAL_ 514 level 18446744073709551616 \"x\" ;"),
        &["car.dbc:29: not valid DBC: the number 18446744073709551616 is too large for its place"],
    );
}

#[test]
fn a_byte_order_mark_changes_nothing() {
    both_say(&format!("\u{FEFF}{DBC}"), &[]);
    let wrong = DBC.replace("514", "4096");
    assert_eq!(compiled(&format!("\u{FEFF}{wrong}")), compiled(&wrong), "the same places");
}

#[test]
fn a_finding_always_has_a_line() {
    let bad = DBC
        .replace("BU_: Engine Cluster", "BU_:")
        .replace("BO_ 514", "BO_ 99999")
        .replace("[0|100]", "[0|0]");
    for found in lint::lint("car.dbc", &bad).0 {
        assert!(found.line > 0, "{found}");
    }
    let table = with("VAL_ 99514 level 0 \"of another\" ;");
    only_lint_says(&table, &["car.dbc:29:1: note: value table of a signal that does not exist: `level`"]);
    assert!(lint::lint("car.dbc", "").0.iter().all(|found| found.line > 0));
    assert!(lint::lint("car.dbc", "VERSION").0.iter().all(|found| found.line > 0));
}

#[test]
fn two_raw_values_with_one_word_are_both_mapped_by_it() {
    let dbc = with("VAL_ 514 level 0 \"Idle\" 1 \"charging\" 2 \"Idle\" ;");
    let toml = TOML.replace(
        "vehicle.fault_code = \"level\"",
        "charge.state = { signal = \"level\", map = { Idle = \"idle\" } }",
    );
    let compiled = vehicle_compiler::compile("car", ("car.dbc", &dbc), ("vehicle.toml", &toml));
    assert!(compiled.is_ok_and(|text| text.contains("0 => 0, 1 => 1, 2 => 0, _ => INVALID")));
}

/// Every word of the language, of the generated text and a few of no letters, as message, signal and value.
const WORDS: &str = "as break const continue crate else enum extern false fn for if impl in let loop match mod move mut pub \
    ref return self Self static struct super trait true type unsafe use where while async await dyn abstract become box do \
    final macro override priv typeof unsized virtual yield try gen union auto default raw safe macro_rules \
    new clone eq ne fmt drop frame index data source readings values state worst set number known codec id decode encode \
    Some None Ok Err Option Result Default Clone Copy Debug PartialEq Eq String Vec Box Iterator Send Sync Sized Fn \
    CanId Checksum ChecksumKind Got LifeKind MessageInfo Mux Order Scale SignalInfo INVALID Readings Severity Value Bound \
    Cell Stream FaultText Life Node NodeName RxMessage TxMessage Vehicle RX TX IDS NODES FAULTS STREAMS DECODERS MESSAGES \
    VEHICLE u8 i32 bool str usize core std alloc 4wd 0 __ A1";

/// A file in which every word is the name of a message, of a signal and of a value.
fn of_words() -> (String, String) {
    let mut words: Vec<&str> = WORDS.split_whitespace().collect();
    // `self` and `Self` are one name in Rust, and so on: the first of such a pair stands for both.
    let mut met = std::collections::BTreeSet::new();
    words.retain(|word| met.insert(word.to_lowercase().replace('_', "")));
    let mut dbc = String::from("VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: Engine Cluster\n\n");
    let mut toml = String::from(
        "[vehicle]\nzh = \"车\\n}\"\nen = \"Car\\n*/ \\u202E\\r fn x( \"\n[nodes]\nEngine = { node = \"vcu\", zh = \"\\\"\", en = \"{}\" }\n\
         Cluster = { node = \"cluster\", zh = \"\\\\\", en = \"E\" }\n",
    );
    for (index, word) in words.iter().enumerate() {
        let signal = words[(index + 1) % words.len()];
        let _ = writeln!(
            dbc,
            "BO_ {} {word}: 8 Engine\n SG_ {signal} : 0|8@1+ (1,0) [0|9] \"\\\" {{}}\" Cluster\n",
            index + 1
        );
    }
    let _ = writeln!(dbc, "BO_ 1000 AllWords: 8 Engine\n SG_ page M : 0|16@1+ (1,0) [0|65535] \"\" Cluster");
    for (index, word) in words.iter().enumerate() {
        let _ = writeln!(dbc, " SG_ {word} m{index} : 16|8@1+ (0.5,0) [0|20] \"°\" Cluster");
    }
    let _ = writeln!(dbc, "\nBO_ 1001 Reply: 8 Cluster\n SG_ type : 0|8@1+ (1,0) [0|9] \"\" Engine\n");
    dbc.push_str("BA_DEF_ \"BusSpeed\" INT 0 1000000;\nBA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\n");
    dbc.push_str("BA_DEF_DEF_ \"BusSpeed\" 250000;\nBA_DEF_DEF_ \"GenMsgCycleTime\" 100;\nVAL_ 1000 type");
    for (index, word) in words.iter().enumerate() {
        let _ = write!(dbc, " {index} \"{word}\\\"\"");
    }
    dbc.push_str(" ;\n");
    toml.push_str(
        "[rx.as]\nvehicle.fault_code = \"break\"\n[rx.AllWords]\nbattery.temperature.count = { signal = \"type\", map = {",
    );
    for (index, _) in words.iter().enumerate() {
        let _ = write!(toml, " {index} = {index},");
    }
    toml.truncate(toml.len() - 1);
    toml.push_str(" } }\n[tx.Reply]\ntype = \"battery.cell.count\"\n");
    (dbc, toml)
}

#[test]
fn every_keyword_can_be_a_message_a_signal_and_a_value() {
    let root = surroundings::root();
    let (dbc, toml) = of_words();
    let text = vehicle_compiler::compile("words", ("words.dbc", &dbc), ("vehicle.toml", &toml));
    let text = text.unwrap_or_else(|error| panic!("{error}"));
    let list = "#[rustfmt::skip]\npub mod words;\npub static VEHICLE: &crate::Vehicle = &words::VEHICLE;\n";
    let files = [("words.rs".into(), text), ("mod.rs".into(), list.into())];
    vehicle_compiler::proof::compiles(&root, &files).unwrap_or_else(|error| panic!("{error}"));
}
