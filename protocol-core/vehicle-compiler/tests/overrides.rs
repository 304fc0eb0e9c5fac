//! What vehicle.toml says in the place of the DBC: unit, factor, offset, sign, cycle, bit rate, nodes that are one.

use protocol_core::model::Reading;
use protocol_core::{Readings, Value};
use vehicle_compiler::RunTime;

const DBC: &str = "VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: A B\n\nBO_ 1 M: 8 A\n \
    SG_ speed : 0|16@1+ (0.1,0) [0|300] \"MPH\" B\n SG_ amps : 16|16@1- (0.1,0) [-900|900] \"A\" B\n \
    SG_ warm : 32|8@1+ (0.5,-40) [-40|80] \"dC*2\" B\n\nBO_ 2 N: 8 B\n SG_ soc : 0|8@1+ (1,0) [0|100] \"%+1\" A\n";

fn toml(lines: &str) -> String {
    format!(
        "[vehicle]\nzh = \"车\"\nen = \"Car\"\nbitrate = 500000\n[nodes]\n\
         A = {{ node = \"vcu\", zh = \"甲\", en = \"A\", also = [\"B\"] }}\n[rx.M]\ncycle_ms = 200\n{lines}\n"
    )
}

fn read(lines: &str) -> Result<RunTime, String> {
    let toml = toml(lines);
    let read = RunTime::of_texts("car", ("car.dbc", DBC), Some(("vehicle.toml", &toml)));
    read.map_err(|wrong| wrong.to_string())
}

/// Returns the counts that message `index` brings.
fn counts(lines: &str, index: u8, data: [u8; 8], value: Value) -> i32 {
    let car = read(lines).unwrap_or_else(|error| panic!("{error}"));
    let mut readings = Readings::new();
    car.decode(index, &data, &mut readings);
    match readings.get(value) {
        Some((Reading::Valid(number), _)) => number,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_unit_and_a_factor_are_said_where_the_dbc_has_others() {
    // 100.0 mph are 160.9344 km/h.
    let line = "vehicle.speed = { signal = \"speed\", unit = \"km/h\", factor = 0.1609344 }";
    assert_eq!(counts(line, 0, [0xE8, 3, 0, 0, 0, 0, 0, 0], Value::VehicleSpeed), 41_199);
    let line = "motor.temperature = { signal = \"warm\", unit = \"degC\", factor = 1, offset = -50 }";
    assert_eq!(counts(line, 0, [0, 0, 0, 0, 70, 0, 0, 0], Value::MotorTemperature), 20);
}

#[test]
fn a_current_that_counts_the_other_way_is_turned() {
    let line = "battery.current = { signal = \"amps\", negate = true }";
    assert_eq!(counts(line, 0, [0, 0, 0x85, 0xFF, 0, 0, 0, 0], Value::BatteryCurrent), 123);
}

#[test]
fn two_nodes_of_the_dbc_are_one_and_a_bit_rate_and_a_cycle_are_said() {
    let line = "[rx.N]\ntimeout_ms = 700\nbattery.soc = { signal = \"soc\", unit = \"%\" }";
    assert_eq!(counts(line, 1, [42, 0, 0, 0, 0, 0, 0, 0], Value::BatterySoc), 420);
    let text = vehicle_compiler::compile("car", ("car.dbc", DBC), ("vehicle.toml", &toml(line)));
    let text = text.unwrap_or_else(|error| panic!("{error}"));
    for part in
        ["bitrate: 500000,", "node: Node::Vcu, len: 8, cycle_ms: 200, timeout_ms: 1000,", "timeout_ms: 700,"]
    {
        assert!(text.contains(part), "{part}");
    }
}

#[test]
fn what_is_said_wrongly_is_told_with_its_line() {
    let wrong = |lines: &str| read(lines).err().unwrap_or_default();
    assert_eq!(
        wrong("vehicle.speed = { signal = \"speed\", unit = \"kmh\" }"),
        "vehicle.toml:9: `vehicle.speed` is measured in km/h, but `speed` has the unit \"kmh\""
    );
    assert_eq!(
        wrong("battery.current = { signal = \"amps\", factor = \"much\" }"),
        "vehicle.toml:9: a decimal number is needed here, not a text"
    );
    assert_eq!(
        wrong("battery.current = { signal = \"amps\", negated = true }"),
        "vehicle.toml:9: no key `negated`; did you mean `negate`?"
    );
    let none = RunTime::of_texts(
        "car",
        ("car.dbc", DBC),
        Some(("vehicle.toml", &toml("").replace("bitrate = 500000", ""))),
    );
    let said = none.err().map(|wrong| wrong.to_string()).unwrap_or_default();
    assert_eq!(
        said,
        "vehicle.toml:1: car.dbc does not say the bit rate (BusSpeed): write `bitrate = 500000` here"
    );
}

#[test]
fn a_field_of_two_bits_is_a_bit_for_each_level() {
    let words = DBC.to_owned() + "VAL_ 1 warm 1 \"high\" 2 \"too high\" 3 \"too high\" ;\n";
    let alarms = |entries: &str| toml(&format!("battery.alarms = [{entries}]"));
    let entries = "{ signal = \"warm\", when = [\"high\"] }, { signal = \"warm\", when = [\"too high\", 9] }";
    let text = alarms(entries);
    let car = RunTime::of_texts("car", ("car.dbc", &words), Some(("vehicle.toml", &text)))
        .unwrap_or_else(|error| panic!("{error}"));
    for (raw, bits) in [(0, 0), (1, 1), (2, 2), (3, 2), (4, 0), (9, 2), (255, 0)] {
        let mut readings = Readings::new();
        car.decode(0, &[0, 0, 0, 0, raw, 0, 0, 0], &mut readings);
        assert_eq!(readings.get(Value::BatteryAlarms), Some((Reading::Valid(bits), 0)), "{raw}");
    }
    let wrong = |entries: &str| {
        let text = alarms(entries);
        let read = RunTime::of_texts("car", ("car.dbc", &words), Some(("vehicle.toml", &text)));
        read.err().map(|wrong| wrong.to_string()).unwrap_or_default()
    };
    assert_eq!(
        wrong("\"warm\""),
        "vehicle.toml:9: `warm` has 8 bits: say at which values the bit is set: `when = [2, 3]`"
    );
    assert_eq!(
        wrong("{ signal = \"warm\", when = [\"hihg\"] }"),
        "vehicle.toml:9: no value of `warm` called `hihg`; did you mean `high`?"
    );
}
