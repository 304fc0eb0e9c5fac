//! `cargo xtask vehicle new`: a DBC of a hostile kind becomes a folder that is read, generated, compiled and driven.

mod program;

use program::xtask;
use std::path::Path;
use std::process::Output;

/// Ids without bit 31 and shared ones, no cycle, no bit rate, no sender, Windows-1252, floats, pages, keywords, odd names.
const HOSTILE: &[u8] = b"VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: M5Dial\n\n\
BO_ 801 type: 8 Vector__XXX\n SG_ VehicleSpeed : 7|16@0+ (0.0099999,0) [0|999] \"km/h\" M5Dial\n\
 SG_ Gear : 16|3@1+ (1,0) [0|7] \"\" M5Dial\n SG_ gear : 19|3@1+ (1,0) [0|7] \"\" M5Dial\n\n\
BO_ 802 Pack_Status: 8 BMS\n SG_ page M : 0|2@1+ (1,0) [0|3] \"\" M5Dial\n\
 SG_ Pack_SOC m0 : 8|8@1+ (0.392156862745,0) [0|100] \"%\" M5Dial\n\
 SG_ Pack_Voltage m1 : 8|32@1- (1,0) [0|800] \"V\" M5Dial\n SG_ Battery_Temp m3 : 8|8@1+ (1,-40) [-40|300] \"\xB0C\" M5Dial\n\n\
BO_ 802 Again: 8 BMS\n SG_ x : 0|8@1+ (1,0) [0|255] \"\" M5Dial\n\n\
BO_ 218042932 Lost: 8 BMS\n SG_ Odometer : 0|32@1+ (1,0) [0|1] \"km\" M5Dial\n\n\
BO_ 2566844926 CCVS: 8 BMS\n SG_ motor_rpm : 8|64@1+ (1,0) [0|9] \"rpm\" M5Dial\n SG_ Motor_Speed : 8|16@1+ (0.5,0) [0|16000] \"rpm\" M5Dial\n\n\
VAL_ 801 Gear 0 \"P\" 1 \"R\" 2 \"N\" 3 \"D\" 4 \"B\" ;\nSIG_VALTYPE_ 802 Pack_Voltage : 1;\n";

fn said(output: &Output) -> String {
    let text = [&output.stdout[..], &output.stderr[..]].concat();
    String::from_utf8(text).expect("text")
}

fn run(arguments: &[&str]) -> String {
    let output = xtask().args(arguments).output().expect("it starts");
    let said = said(&output);
    assert!(output.status.success(), "{arguments:?}: {said}");
    said
}

fn made(folder: &Path, dbc: &[u8]) -> String {
    let file = folder.join("Hostile Car.dbc");
    std::fs::write(&file, dbc).expect("can be written");
    run(&["vehicle", "new", file.to_str().expect("a path"), "--into", folder.to_str().expect("a path")])
}

#[test]
fn a_hostile_file_becomes_a_vehicle_that_drives() {
    let folder = tempfile::tempdir().expect("a folder");
    // The second message on one identifier would take the first one's place, so the first is tried without it.
    let text: Vec<u8> = HOSTILE.to_vec();
    let alone = {
        let cut = |from: &[u8], to: &[u8]| {
            let at = |part: &[u8]| {
                text.windows(part.len()).position(|window| window == part).expect("it is there")
            };
            [&text[..at(from)], &text[at(to)..]].concat()
        };
        cut(b"BO_ 802 Again", b"BO_ 218042932 Lost")
    };
    let told = made(folder.path(), &alone);
    assert!(told.contains("is not UTF-8; read as windows-1252"), "{told}");
    for bound in [
        "vehicle.speed              type.VehicleSpeed",
        "battery.soc                Pack_Status.Pack_SOC",
        "battery.voltage            Pack_Status.Pack_Voltage",
        "battery.temperature.max    Pack_Status.Battery_Temp",
        "motor.speed                CCVS.Motor_Speed",
        "vehicle.gear               type.Gear",
    ] {
        assert!(told.contains(bound), "{bound}: {told}");
    }
    assert!(!told.contains("Odometer"), "its identifier cannot be: {told}");
    let vehicle = folder.path().join("hostile_car");
    let [path, log] =
        [vehicle.clone(), vehicle.join("captures/sweep.log")].map(|path| path.display().to_string());
    let dbc = vehicle.join("hostile_car.dbc");
    let linted = run(&["dbc", dbc.to_str().expect("a path")]);
    assert!(linted.contains("warning: identifier 218042932"), "{linted}");

    let decoded = run(&["decode", "--vehicle", &path, "--signals", "Pack_*,Motor_Speed", &log]);
    assert!(decoded.contains("Pack_Voltage") && decoded.contains("400 V"), "the half of its range");
    assert!(decoded.contains("18FEF100"), "a group is sent from some source");
    let played = run(&["replay", "--vehicle", &path, &log]);
    for value in ["vehicle.speed", "battery.soc", "battery.voltage", "motor.speed", "vehicle.gear"] {
        assert!(played.lines().any(|line| line.contains(value) && !line.contains("--")), "{value}: {played}");
    }

    // What is made is Rust, too.
    let root = surroundings::root();
    let read = |file: &str| std::fs::read_to_string(vehicle.join(file)).expect("a text");
    let (dbc, toml) = (read("hostile_car.dbc"), read("vehicle.toml"));
    let text = vehicle_compiler::compile("hostile_car", ("hostile_car.dbc", &dbc), ("vehicle.toml", &toml));
    let text = text.unwrap_or_else(|error| panic!("{error}"));
    let list = "pub mod hostile_car;\npub static VEHICLE: &crate::Vehicle = &hostile_car::VEHICLE;\n";
    let files = [("hostile_car.rs".into(), text), ("mod.rs".into(), list.to_owned())];
    vehicle_compiler::proof::compiles(&root, &files).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn the_steps_of_the_page_work_with_a_hostile_file() {
    let page =
        std::fs::read_to_string(surroundings::root().join("docs/add-your-vehicle.md")).expect("the page");
    let (_, block) = page.split_once("```steps\n").expect("the block of steps");
    let steps: Vec<&str> = block.lines().take_while(|line| *line != "```").collect();
    assert_eq!(steps.len(), 4, "{steps:?}");
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("my.dbc"), HOSTILE).expect("can be written");
    for step in steps {
        let arguments = step.strip_prefix("cargo xtask ").expect("a command of this program").split(' ');
        let output = xtask().args(arguments).current_dir(folder.path()).output().expect("it starts");
        assert!(output.status.success(), "{step}: {}", said(&output));
        assert!(!output.stdout.is_empty(), "{step} says something");
    }
}

#[test]
fn two_messages_on_one_identifier_are_not_bound() {
    let folder = tempfile::tempdir().expect("a folder");
    let told = made(folder.path(), HOSTILE);
    assert!(!told.contains("Pack_Status"), "{told}");
    assert!(told.contains("type.VehicleSpeed"), "{told}");
}

#[test]
fn a_folder_that_is_there_is_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    made(folder.path(), HOSTILE);
    let file = folder.path().join("Hostile Car.dbc");
    let again = xtask()
        .args([
            "vehicle",
            "new",
            file.to_str().expect("a path"),
            "--into",
            folder.path().to_str().expect("a path"),
        ])
        .output()
        .expect("it starts");
    assert!(!again.status.success() && said(&again).contains("is there already"), "{}", said(&again));
}
