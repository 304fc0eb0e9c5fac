//! What a DBC must never do: give a wrong value silently, lose a message, or generate what is not Rust.

use std::fmt::Write;
use vehicle_compiler::lint;

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
    match vehicle_compiler::compile("car", ("car.dbc", dbc), ("vehicle.toml", TOML)) {
        Ok(_) => Vec::new(),
        Err(found) => found.0.iter().map(ToString::to_string).collect(),
    }
}

/// Lint and generator say the same of a text: this, and nothing else.
fn both_say(dbc: &str, expected: &[&str]) {
    let linted: Vec<String> = lint::lint("car.dbc", dbc).0.iter().map(ToString::to_string).collect();
    let said: Vec<&String> = linted.iter().filter(|line| !line.contains("has no comment")).collect();
    assert_eq!(said, expected, "lint");
    assert_eq!(compiled(dbc), expected, "codegen");
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

#[test]
fn an_ieee_float_is_not_read_as_a_whole_number() {
    let said = |bits: u32| {
        format!(
            "car.dbc:29: `volts` of Status is an IEEE float of {bits} bits (SIG_VALTYPE_), which is not supported: take \
             the signal out, or have it sent as a whole number with a factor"
        )
    };
    both_say(&with("SIG_VALTYPE_ 513 volts : 1;"), &[&said(32)]);
    both_say(&with("SIG_VALTYPE_ 513 volts : 2;"), &[&said(64)]);
    both_say(&with("SIG_VALTYPE_ 513 volts : 0;"), &[]);
    both_say(&with("SIG_VALTYPE_ 513 page : 0; SIG_VALTYPE_ 513\tvolts:1;"), &[&said(32)]);
}

#[test]
fn a_multiplexer_range_is_not_cut_to_its_first_value() {
    let said = |signal: &str| {
        format!(
            "car.dbc:29: SG_MUL_VAL_ lets `{signal}` of Status depend on more than one value of one multiplexer, which is \
             not supported: write one signal (m0, m1 ...) for each value"
        )
    };
    for same in ["soc page 1-1", "volts page 0-0"] {
        both_say(&with(&format!("SG_MUL_VAL_ 513 {same};")), &[]);
    }
    for other in ["soc page 1-1, 3-5", "soc page 1-2", "soc page 2-2", "soc volts 1-1"] {
        both_say(&with(&format!("SG_MUL_VAL_ 513 {other};")), &[&said("soc")]);
    }
    both_say(
        &with("SG_MUL_VAL_ 513 soq page 1-1;"),
        &["car.dbc:29: SG_MUL_VAL_ of a signal that does not exist: `soq`"],
    );
}

#[test]
fn a_multiplex_value_is_one_that_the_multiplexer_can_hold() {
    both_say(
        &replaced("soc m1", "soc m256"),
        &["car.dbc:12: `soc` is sent at 256, which the 8 bits of `page` never hold"],
    );
    both_say(
        &replaced("soc m1", "soc m4294967297"),
        &[
            "car.dbc:12: `soc` is sent at 4294967297, which has more than 32 bits",
            "car.dbc:12: signal `soc` overlaps `volts`",
        ],
    );
    both_say(
        &replaced("soc m1", "soc m"),
        &[
            "car.dbc:12: `soc` is multiplexed (`m`) but does not say at which value",
            "car.dbc:12: signal `soc` overlaps `volts`",
        ],
    );
}

#[test]
fn frames_that_are_not_classic_can_are_refused() {
    let fd = "message `Level` is CAN FD (StandardCAN_FD); only classic CAN is received here";
    both_say(&with("BA_ \"VFrameFormat\" BO_ 514 4;"), &[&format!("car.dbc:29: {fd}")]);
    both_say(&with("BA_ \"VFrameFormat\" BO_ 514 \"StandardCAN_FD\";"), &[&format!("car.dbc:29: {fd}")]);
    both_say(
        &replaced("BO_ 514 Level: 8", "BO_ 514 Level: 12"),
        &["car.dbc:14: message `Level` has 12 bytes; classic CAN has 8"],
    );
}

#[test]
fn a_message_that_j1939_matches_by_its_group_is_refused() {
    both_say(
        &with("BA_ \"VFrameFormat\" BO_ 514 3;"),
        &[
            "car.dbc:29: message `Level` is matched by its J1939 group (VFrameFormat J1939PG), which is not supported: all 29 \
           bits must match, so write the identifier as it is on the bus and ExtendedCAN",
        ],
    );
    let all = replaced("\"VFrameFormat\" \"StandardCAN\"", "\"VFrameFormat\" \"J1939PG\"");
    let said = compiled(&all);
    assert_eq!(said.len(), 2, "{said:?}");
    assert!(said[0].starts_with("car.dbc:9: message `Status` is"), "{said:?}");
    assert!(said[1].starts_with("car.dbc:14: message `Level` is"), "{said:?}");
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
        let dbc = DBC.replace("514", id);
        both_say(&dbc, &[&format!("car.dbc:14: identifier {id} of `Level` {said}")]);
    }
    for id in ["0", "2047", "2147483648", "2684354559"] {
        both_say(&DBC.replace("514", id), &[]);
    }
}

#[test]
fn two_messages_on_one_identifier_are_told_with_both_lines() {
    both_say(&DBC.replace("514", "513"), &["car.dbc:14: identifier 513 is used before, in line 9"]);
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
    both_say(
        &with("VAL_ 514 level 0 \"none\" ;\nVAL_ 514 level 1 \"some\" ;"),
        &["car.dbc:30: this value table is given before, in line 29"],
    );
    both_say(
        &with("BA_ \"GenMsgCycleTime\" BO_ 514 10;\nBA_ \"GenMsgCycleTime\" BO_ 514 20;"),
        &["car.dbc:30: GenMsgCycleTime is given before, in line 29"],
    );
}

#[test]
fn names_that_become_one_in_rust_are_told_with_both_lines() {
    both_say(
        &replaced("514 Level", "514 STATUS"),
        &[
            "car.dbc:14: message `STATUS` and `Status` in line 9 are both `Status` in Rust: rename one of them",
        ],
    );
    both_say(
        &replaced("SG_ soc m1", "SG_ Volts m1").replace("SG_ 513 soc", "SG_ 513 Volts"),
        &["car.dbc:12: signal `Volts` and `volts` in line 11 are both `volts` in Rust: rename one of them"],
    );
    both_say(
        &replaced("SG_ soc m1", "SG_ volts_raw m1").replace("SG_ 513 soc", "SG_ 513 volts_raw"),
        &[
            "car.dbc:12: signal `volts_raw` and `volts` in line 11 are both `volts_raw` in Rust: rename one of them",
        ],
    );
}

#[test]
fn numbers_of_too_many_digits_are_told_and_do_not_panic() {
    both_say(
        &replaced(
            "(0.5,0) [0|100]",
            "(0.00000000001,0.00000000000000000000001) [0|999999999999999999999999]",
        ),
        &["car.dbc:12: factor and offset of `soc` need more than 31 bits as a fraction"],
    );
    let long = compiled(&replaced("\"BusSpeed\" 250000", "\"BusSpeed\" 18446744073709551615"));
    assert_eq!(long.len(), 1, "{long:?}");
    both_say(
        &with("VAL_ 514 level 18446744073709551616 \"x\" ;"),
        &["car.dbc:29: not valid DBC: the number 18446744073709551616 is too large for its place"],
    );
}

#[test]
fn a_byte_order_mark_changes_nothing() {
    both_say(&format!("\u{FEFF}{DBC}"), &[]);
    let marked = replaced("514 Level", "514 STATUS");
    assert_eq!(compiled(&format!("\u{FEFF}{marked}")), compiled(&marked), "the same lines");
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
    let said = "car.dbc:29: value table of a signal that does not exist: `level`";
    both_say(&table, &[said]);
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
