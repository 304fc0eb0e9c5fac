//! What the compiler says of wrong vehicles: file, line, reason, nearest name; all faults at once.

use std::fs;
use std::path::{Path, PathBuf};
use vehicle_compiler::{Diagnostics, write_if};

const DBC: &str = r#"VERSION ""

NS_ :

BS_:

BU_: Engine Cluster

BO_ 2566834687 Status: 8 Engine
 SG_ speed : 0|16@1+ (0.1,-1000) [-1000|1000] "A" Cluster
 SG_ gear : 16|4@1+ (1,0) [0|3] "" Cluster
 SG_ life : 56|8@1+ (1,0) [0|255] "" Cluster

BO_ 2566834688 Panel: 8 Cluster
 SG_ odometer : 0|32@1+ (0.125,0) [0|1000] "km" Engine

CM_ BO_ 2566834687 "A comment
over two lines with SG_ speed : in it";
BA_DEF_ "BusSpeed" INT 0 1000000;
BA_DEF_ BO_ "GenMsgCycleTime" INT 0 65535;
BA_DEF_ SG_ "SigInvalidRaw" INT -1 2147483647;
BA_DEF_DEF_ "BusSpeed" 250000;
BA_DEF_DEF_ "GenMsgCycleTime" 100;
BA_DEF_DEF_ "SigInvalidRaw" -1;
BA_ "SigInvalidRaw" SG_ 2566834687 speed 65535;
VAL_ 2566834687 gear 0 "N" 1 "D" 2 "creep" ;
"#;

const TOML: &str = r#"[vehicle]
zh = "车"
en = "Car"

[nodes]
Engine = { node = "vcu", zh = "发动机", en = "Engine" }
Cluster = { node = "cluster", zh = "仪表", en = "Cluster" }

[rx.Status]
battery.current = "speed"
vehicle.gear = { signal = "gear", map = { creep = "D1" } }

[tx.Panel]
odometer = "cluster.odometer"

[faults.Engine]
codes = [
    { code = 1, level = "warn", zh = "一", en = "One" },
]
"#;

/// Returns what is wrong, one line each.
fn wrong(dbc: &str, toml: &str) -> Vec<String> {
    match vehicle_compiler::compile("car", ("car.dbc", dbc), ("vehicle.toml", toml)) {
        Ok(_) => Vec::new(),
        Err(found) => found.0.iter().map(ToString::to_string).collect(),
    }
}

/// Writes a tree that is not the repository; what is generated is proved elsewhere.
fn write(root: &Path) -> Result<Vec<PathBuf>, Diagnostics> {
    write_if(root, |_| Ok(()))
}

fn wrong_dbc(old: &str, new: &str) -> Vec<String> {
    assert!(DBC.contains(old), "{old}");
    wrong(&DBC.replacen(old, new, 1), TOML)
}

fn wrong_toml(old: &str, new: &str) -> Vec<String> {
    assert!(TOML.contains(old), "{old}");
    wrong(DBC, &TOML.replacen(old, new, 1))
}

fn only(found: Vec<String>, expected: &str) {
    assert_eq!(found, [expected]);
}

#[test]
fn a_right_vehicle_has_nothing_wrong() {
    assert_eq!(wrong(DBC, TOML), Vec::<String>::new());
}

#[test]
fn a_state_that_is_written_as_it_is_known_elsewhere_is_told_its_word() {
    let bound =
        |state: &str| TOML.replace("vehicle.gear = { signal = \"gear\", map = { creep = \"D1\" } }", state);
    let of = |state: &str| wrong(DBC, &bound(state));
    let map = "map = { N = \"idle\", D = \"charging\", creep = ";
    let charge = |state: &str| of(&format!("charge.state = {{ signal = \"gear\", {map}{state} }} }}"));
    only(charge("\"not charging\""), "vehicle.toml:11: `not charging` is written `idle` in `charge.state`");
    only(charge("\"充满\""), "vehicle.toml:11: `充满` is written `complete` in `charge.state`");
    only(charge("3"), "vehicle.toml:11: `3` is written `fault` in `charge.state`");
    assert_eq!(charge("\"complete\""), Vec::<String>::new());
    let mode = "vehicle.mode = { signal = \"gear\", map = { N = 1, D = \"drive\", creep = \"limp\" } }";
    only(of(mode), "vehicle.toml:11: `1` is written `park` in `vehicle.mode`");
}

#[test]
fn a_syntax_error_of_the_dbc_names_its_line() {
    for (old, new, line) in [
        (r#" SG_ gear : 16|4@1+ (1,0)"#, r#" SG_ gear : 16|4@1+ (1;0)"#, 11),
        (r#" SG_ life : 56|8@1+"#, r#" SG_ life : 56|8@3+"#, 12),
        ("BO_ 2566834688 Panel: 8 Cluster", "BO_ Panel: 8 Cluster", 14),
        (r#"BA_DEF_DEF_ "BusSpeed" 250000;"#, r#"BA_DEF_DEF_ "BusSpeed" ;"#, 22),
        (r#"VAL_ 2566834687 gear 0 "N""#, r#"VAL_ 2566834687 gear 0 N"#, 26),
    ] {
        let found = wrong_dbc(old, new);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            found[0].starts_with(&format!("car.dbc:{line}: not valid DBC: `")),
            "line {line}: {}",
            found[0]
        );
    }
}

#[test]
fn a_number_that_the_dbc_cannot_hold_names_its_line_too() {
    let found = wrong_dbc("BO_ 2566834688 Panel", "BO_ 99999999999 Panel");
    assert!(found[0].starts_with("car.dbc:14: not valid DBC: "), "{}", found[0]);
}

#[test]
fn a_cut_file_is_not_a_dbc() {
    let cut = &DBC[..DBC.find("over two").expect("the comment")];
    let found = wrong(cut, TOML);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("car.dbc:"), "{}", found[0]);
}

/// What is bound and cannot be had is said where it is bound, with the place in the DBC.
fn not_bound(found: Vec<String>, place: &str, reason: &str) {
    assert_eq!(found.len(), 1, "{found:#?}");
    assert!(found[0].ends_with(&format!(" cannot be bound: car.dbc:{place}: {reason}")), "{found:#?}");
}

#[test]
fn signals_must_fit() {
    not_bound(
        wrong_dbc("gear : 16|4", "gear : 62|4"),
        "11:2",
        "`gear` reaches beyond the 8 bytes of the message",
    );
    not_bound(
        wrong_dbc("speed 65535;", "speed 65536;"),
        "25:1",
        "SigInvalidRaw of `speed` does not fit in its 16 bits",
    );
}

#[test]
fn what_harms_no_value_is_no_error() {
    for (old, new) in [
        ("gear : 16|4", "gear : 14|4"),
        ("life : 56|8", "life : 60|8"),
        ("[0|3] \"\" Cluster", "[0|16] \"\" Cluster"),
        ("2 \"creep\"", "2 \"creep\" 16 \"crawl\""),
    ] {
        assert_eq!(wrong_dbc(old, new), Vec::<String>::new(), "{new}");
    }
}

#[test]
fn names_and_identifiers_are_used_once_and_known() {
    let found = wrong_dbc("BO_ 2566834688 Panel", "BO_ 2566834687 Panel");
    let reason = "car.dbc:14:1: identifier 2566834687 is used before, in line 9";
    assert!(found.len() == 2 && found.iter().all(|line| line.ends_with(reason)), "{found:#?}");
    only(
        wrong_dbc("Panel: 8 Cluster", "Panel: 8 Clutser"),
        "vehicle.toml:13: `Panel` is sent by `Clutser`, which has no [nodes.Clutser]",
    );
    not_bound(wrong_dbc(" SG_ life", " SG_ gear"), "12:2", "signal `gear` is used before, in line 11");
}

#[test]
fn a_misspelt_name_of_the_binding_gets_its_nearest_match() {
    only(
        wrong_toml("\"speed\"", "\"sped\""),
        "vehicle.toml:10: no signal `sped` in Status; did you mean `speed`?",
    );
    only(
        wrong_toml("battery.current", "batery.current"),
        "vehicle.toml:10: no model value `batery.current`; did you mean `battery.current`?",
    );
    only(
        wrong_toml("battery.current", "battery.curent"),
        "vehicle.toml:10: no model value `battery.curent`; did you mean `battery.current`?",
    );
    only(
        wrong_toml("[rx.Status]", "[rx.Statsu]"),
        "vehicle.toml:9: no message `Statsu` in the DBC; did you mean `Status`?",
    );
    only(
        wrong_toml("node = \"vcu\"", "node = \"vcx\""),
        "vehicle.toml:6: no kind of node `vcx`; did you mean `vcu`?",
    );
    only(
        wrong_toml("\"cluster.odometer\"", "\"cluster.odometr\""),
        "vehicle.toml:14: no model value `cluster.odometr`; did you mean `cluster.odometer`?",
    );
    only(
        wrong_toml("level = \"warn\"", "level = \"wran\""),
        "vehicle.toml:18: no level `wran`; did you mean `warn`?",
    );
    only(
        wrong_toml("[faults.Engine]", "[faults.Engin]"),
        "vehicle.toml:16: no [nodes] entry `Engin`; did you mean `Engine`?",
    );
    only(wrong_toml("[tx.Panel]", "[txx]"), "vehicle.toml:13: no section `txx`; did you mean `tx`?");
}

#[test]
fn units_states_and_directions_must_fit() {
    only(
        wrong_toml("battery.current", "battery.voltage"),
        "vehicle.toml:10: `battery.voltage` is measured in V or mV, but `speed` has the unit \"A\"",
    );
    let found = wrong_toml("{ signal = \"gear\", map = { creep = \"D1\" } }", "\"gear\"");
    assert!(
        found[0].starts_with("vehicle.toml:11: `vehicle.gear` does not say what `creep` of `gear` means"),
        "{found:?}"
    );
    only(
        wrong_toml("creep = \"D1\"", "creep = \"D9\""),
        "vehicle.toml:11: no state of `vehicle.gear` `D9`; did you mean `D`?",
    );
    only(
        wrong_toml("creep = \"D1\"", "creep = \"D1\", crep = \"D2\""),
        "vehicle.toml:11: signal `gear` has no value `crep`; did you mean `creep`?",
    );
    only(
        wrong_toml("[tx.Panel]\nodometer = \"cluster.odometer\"", "[rx.Panel]\nvehicle.range = \"odometer\""),
        "vehicle.toml:13: `Panel` is sent by the cluster: it belongs to [tx.Panel]",
    );
    only(
        wrong_toml("battery.current = \"speed\"", "battery.current = [\"speed\"]"),
        "vehicle.toml:10: `battery.current` is no flag, severity, fan speed or bits: a list has no meaning",
    );
}

#[test]
fn a_value_has_one_source() {
    let two = TOML.replace("[tx.Panel]\nodometer = \"cluster.odometer\"", "").replace(
        "vehicle.gear =",
        "battery.charge_limit = \"speed\"\nbattery.discharge_limit = \"speed\"\nvehicle.gear =",
    );
    assert_eq!(wrong(DBC, &two), Vec::<String>::new(), "one signal may serve two values");
    let dbc = DBC.replace("Panel: 8 Cluster", "Panel: 8 Engine");
    let twice = TOML.replace(
        "[tx.Panel]\nodometer = \"cluster.odometer\"",
        "[rx.Panel]\nvehicle.gear = { signal = \"odometer\", map = { 1 = \"D\" } }",
    );
    only(wrong(&dbc, &twice), "vehicle.toml:9: `vehicle.gear` is bound in Panel and in Status");
}

#[test]
fn toml_errors_name_their_line_and_kinds_are_checked() {
    let found = wrong_toml("en = \"Car\"", "en = ");
    assert!(found[0].starts_with("vehicle.toml:3: not valid TOML: "), "{found:?}");
    only(
        wrong_toml("battery.current = \"speed\"", "timeout_ms = \"long\"\nbattery.current = \"speed\""),
        "vehicle.toml:10: a number is needed here, not a text",
    );
    only(
        wrong_toml("en = \"Car\"\n", "en = \"Car\"\nshipped = \"no\"\n"),
        "vehicle.toml:4: true or false is needed here, not a text",
    );
    only(
        wrong_toml("battery.current = \"speed\"", "timeout_ms = 7\nbattery.current = \"speed\""),
        "vehicle.toml:10: 7 must be 50 to 600000",
    );
}

#[test]
fn all_faults_are_shown_at_once_in_order_of_lines() {
    let toml = TOML
        .replace("\"speed\"", "\"sped\"")
        .replace("cluster.odometer", "cluster.odo")
        .replace("code = 1", "code = 0");
    let found = wrong(DBC, &toml);
    let lines: Vec<&str> = found.iter().filter_map(|text| text.split(':').nth(1)).collect();
    assert_eq!(lines, ["10", "14", "18"], "{found:#?}");
}

#[test]
fn check_names_the_command_and_write_repairs() {
    let root = tempfile::tempdir().expect("a folder");
    let vehicle = root.path().join("vehicles/car");
    fs::create_dir_all(&vehicle).expect("a folder");
    fs::write(vehicle.join("car.dbc"), DBC).expect("a file");
    let half = vehicle_compiler::check(root.path()).expect_err("half a vehicle").to_string();
    assert_eq!(
        half,
        "vehicles/car/vehicle.toml: is missing: a vehicle needs both files, see vehicles/FORMAT.md"
    );

    fs::write(vehicle.join("vehicle.toml"), TOML).expect("a file");
    let missing = vehicle_compiler::check(root.path()).expect_err("nothing is written yet").to_string();
    assert!(
        missing.contains("car.rs: is missing: run `cargo xtask codegen` and commit the result"),
        "{missing}"
    );

    let written = write(root.path()).expect("a right vehicle");
    assert_eq!(written.len(), 2);
    assert_eq!(vehicle_compiler::check(root.path()), Ok(()));
    assert_eq!(write(root.path()), Ok(Vec::new()), "nothing changed, nothing is written");

    let file = root.path().join(vehicle_compiler::GENERATED).join("car.rs");
    let text = fs::read_to_string(&file).expect("the file");
    fs::write(&file, text.replacen("0x", "0y", 1)).expect("a file");
    let stale = vehicle_compiler::check(root.path()).expect_err("the file is stale").to_string();
    assert!(stale.contains("differs from what its vehicle gives: run `cargo xtask codegen`"), "{stale}");

    fs::rename(&vehicle, root.path().join("vehicles/van")).expect("a folder");
    fs::rename(root.path().join("vehicles/van/car.dbc"), root.path().join("vehicles/van/van.dbc"))
        .expect("a file");
    write(root.path()).expect("a right vehicle");
    assert!(!file.exists(), "a vehicle that is gone leaves no file");
}

#[test]
fn a_vehicle_that_is_not_shipped_is_in_the_tools_list_and_in_no_image() {
    let root = tempfile::tempdir().expect("a folder");
    for (name, shipped) in [("car", ""), ("draft", "shipped = false\n"), ("van", "shipped = true\n")] {
        let vehicle = root.path().join("vehicles").join(name);
        fs::create_dir_all(&vehicle).expect("a folder");
        fs::write(vehicle.join(format!("{name}.dbc")), DBC).expect("a file");
        let toml = TOML.replace("en = \"Car\"\n", &format!("en = \"Car\"\n{shipped}"));
        fs::write(vehicle.join("vehicle.toml"), toml).expect("a file");
    }
    write(root.path()).expect("right vehicles");
    let lists = root.path().join(vehicle_compiler::GENERATED).join("mod.rs");
    let lists = fs::read_to_string(lists).expect("the lists");
    let list = |name: &str| {
        let (_, list) = lists.split_once(&format!("pub static {name}: ")).expect("the list");
        let (list, _) = list.split_once("];").expect("its end");
        ["car", "draft", "van"].map(|vehicle| list.contains(&format!("&{vehicle}::VEHICLE")))
    };
    assert_eq!(list("VEHICLES"), [true; 3]);
    assert_eq!(list("SHIPPED_VEHICLES"), [true, false, true]);
}

/// Three messages alike, each with two cells; a page in a fourth.
const STREAM_DBC: &str = r#"VERSION ""

NS_ :

BS_:

BU_: Pack Cluster

BO_ 512 Cells1: 6 Pack
 SG_ n1 : 0|8@1+ (1,0) [0|255] "" Cluster
 SG_ v1 : 8|8@1+ (0.02,0) [0|5.1] "V" Cluster
 SG_ n2 : 16|8@1+ (1,0) [0|255] "" Cluster
 SG_ v2 : 24|8@1+ (0.02,0) [0|5.1] "V" Cluster
 SG_ wide : 32|12@1+ (1,0) [0|4095] "" Cluster

BO_ 514 Cells2: 6 Pack
 SG_ n1 : 0|8@1+ (1,0) [0|255] "" Cluster
 SG_ v1 : 8|8@1+ (0.02,0) [0|5.1] "V" Cluster
 SG_ n2 : 16|8@1+ (1,0) [0|255] "" Cluster
 SG_ v2 : 24|8@1+ (0.02,0) [0|5.1] "V" Cluster
 SG_ wide : 32|12@1+ (1,0) [0|4095] "" Cluster

BO_ 600 Pages: 4 Pack
 SG_ page M : 0|8@1+ (1,0) [0|1] "" Cluster
 SG_ low m0 : 8|1@1+ (1,0) [0|1] "" Cluster
 SG_ high m1 : 8|1@1+ (1,0) [0|1] "" Cluster
 SG_ check : 24|8@1+ (1,0) [0|255] "" Cluster

BO_ 700 Own: 4 Cluster
 SG_ page M : 0|8@1+ (1,0) [0|1] "" Pack
 SG_ km m0 : 8|16@1+ (1,0) [0|65535] "km" Pack

BA_DEF_ "BusSpeed" INT 0 1000000;
BA_DEF_ BO_ "GenMsgCycleTime" INT 0 65535;
BA_DEF_DEF_ "BusSpeed" 500000;
BA_DEF_DEF_ "GenMsgCycleTime" 100;
"#;

const STREAM_TOML: &str = r#"[vehicle]
zh = "车"
en = "Car"
[nodes]
Pack = { node = "bms", zh = "电池", en = "Pack" }
Cluster = { node = "cluster", zh = "仪表", en = "Cluster" }
[streams.cells]
messages = ["Cells1", "Cells2"]
numbers = ["n1", "n2"]
values = ["v1", "v2"]
highest = "battery.cell.max"
count = "battery.cell.count"
[rx.Pages]
checksum = { signal = "check", kind = "xor8" }
battery.balancing = "low"
[tx.Own]
cycle_ms = 100
"#;

/// Returns what is wrong after one replacement.
fn wrong_stream(from: &str, to: &str) -> Vec<String> {
    assert!(STREAM_TOML.contains(from), "{from}");
    let toml = STREAM_TOML.replace(from, to);
    match vehicle_compiler::compile("car", ("car.dbc", STREAM_DBC), ("vehicle.toml", &toml)) {
        Ok(_) => Vec::new(),
        Err(found) => found.0.iter().map(ToString::to_string).collect(),
    }
}

#[test]
fn streams_pages_and_checksums_are_checked() {
    assert_eq!(wrong_stream("zh", "zh"), [""; 0]);
    let cases = [
        ("\"xor8\"", "\"xor\"", "vehicle.toml:14: no kind of checksum `xor`; did you mean `xor8`?"),
        (", kind = \"xor8\"", "", "vehicle.toml:14: a checksum needs `signal` and `kind`"),
        ("\"check\"", "\"low\"", "vehicle.toml:14: `low` is not one whole byte without a sign"),
        (
            "\"low\"",
            "[\"low\", \"high\"]",
            "vehicle.toml:15: the signals of `battery.balancing` are never in the same frame",
        ),
        (
            "cycle_ms = 100",
            "km = \"cluster.odometer\"",
            "vehicle.toml:17: the cluster sends no multiplexed signals",
        ),
        ("\"v2\"]", "\"wide\"]", "vehicle.toml:10: `wide` is not one whole byte without a sign"),
        ("[\"n1\", \"n2\"]", "[\"n1\"]", "vehicle.toml:7: `numbers` must be as many as `values`"),
        (
            "\"battery.cell.count\"",
            "\"battery.cell.max\"",
            "vehicle.toml:7: `battery.cell.max` does not count",
        ),
        (
            "\"Cells2\"",
            "\"Pages\"",
            "vehicle.toml:7: the messages from the first to the last must be alike, in the order of the DBC, with \
             identifiers at equal distance, and 2 to 128",
        ),
        (
            "[rx.Pages]",
            "[rx.Cells2]\n[rx.Pages]",
            "vehicle.toml:7: messages of `cells` belong to the stream and have no [rx.] of their own",
        ),
        (
            "highest = \"battery.cell.max\"",
            "highest = \"battery.temperature.max\"",
            "vehicle.toml:7: `battery.temperature.max` is measured in °C or degC, but `v1` has the unit \"V\"",
        ),
    ];
    for (from, to, said) in cases {
        let found = wrong_stream(from, to);
        assert!(found.iter().any(|line| line == said), "{from} -> {to}: {found:#?}");
    }
}
