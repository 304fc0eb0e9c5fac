//! The bus's battery against its document's table, from outside: settings in, bytes out, decoded here by hand.
//!
//! `documents/citybus_battery.txt` is the table as text. Neither the controller's own rows nor the project's codecs are
//! used, so that a slip in either shows.

use std::collections::BTreeMap;
use virtual_vehicle::{Kind, Options, VirtualVehicle};

/// One row of the table.
struct Row {
    rule: u16,
    code: u8,
    level: u8,
    what: String,
    not_yet: f64,
    set: f64,
    holds: f64,
    clear: f64,
    left: (f64, f64),
    when: String,
    with: Vec<(String, f64)>,
}

fn rows() -> Vec<Row> {
    let text = include_str!("documents/citybus_battery.txt");
    let row = |line: &str| {
        let words: Vec<&str> = line.split_whitespace().collect();
        let number = |place: usize| words[place].parse::<f64>().expect("a number");
        let with = words[11..].iter().filter_map(|word| word.split_once('='));
        Row {
            rule: number(0) as u16,
            code: number(1) as u8,
            level: number(2) as u8,
            what: words[3].to_owned(),
            not_yet: number(4),
            set: number(5),
            holds: number(6),
            clear: number(7),
            left: (number(8), number(9)),
            when: words[10].to_owned(),
            with: with.map(|(path, value)| (path.to_owned(), value.parse().expect("a number"))).collect(),
        }
    };
    text.lines().filter(|line| !line.starts_with('#') && !line.is_empty()).map(row).collect()
}

/// Controls and what they are set to.
type Settings = &'static [(&'static str, f64)];

const VCU7: u32 = 0x0CF1_064A;
const BMS1: u32 = 0x18F1_3DF3;
const BMS4: u32 = 0x18F1_40F3;
const BMS5: u32 = 0x18F1_41F3;

/// A bus and the last bytes of each identifier.
struct Bus {
    vehicle: VirtualVehicle,
    last: BTreeMap<u32, [u8; 8]>,
}

impl Bus {
    fn new() -> Self {
        Self { vehicle: VirtualVehicle::new(Kind::Citybus, Options::default()), last: BTreeMap::new() }
    }

    fn set(&mut self, path: &str, value: f64) -> &mut Self {
        self.vehicle.set(path, Some(value)).expect("a control");
        self
    }

    fn ms(&mut self, ms: u64) -> &mut Self {
        for _ in 0..ms / 10 {
            self.vehicle.advance();
            let sent = self.vehicle.take_frames();
            self.last.extend(sent.iter().map(|sent| (sent.frame.id.bits(), *sent.frame.padded())));
        }
        self
    }

    fn bytes(&self, id: u32) -> [u8; 8] {
        self.last[&id]
    }

    /// Level of BMS1 as the document names it, 0 = none: raw 1 is level 3.
    fn level(&self) -> u8 {
        match self.bytes(BMS1)[6] & 0b111 {
            0 => 0,
            raw => 4 - raw,
        }
    }

    fn code(&self) -> u8 {
        self.bytes(BMS5)[0]
    }

    /// Charge and discharge current of BMS4 in A: 0.1 A and -1000 A.
    fn limits(&self) -> (f64, f64) {
        let data = self.bytes(BMS4);
        let amps = |low: u8, high: u8| f64::from(u16::from(low) | u16::from(high) << 8) / 10.0 - 1_000.0;
        (amps(data[0], data[1]), amps(data[2], data[3]))
    }

    /// Level and code of VCU7.
    fn forwarded(&self) -> (u8, u16) {
        let data = self.bytes(VCU7);
        (data[0] & 0b111, u16::from(data[1]) | u16::from(data[2]) << 8)
    }

    /// The battery says this level and, within three of its cycles, this code.
    fn says(&mut self, row: &Row) -> bool {
        (0..3).any(|_| {
            self.ms(500);
            self.level() == row.level && self.code() == row.code
        })
    }
}

fn prepared(row: &Row) -> Bus {
    let mut bus = Bus::new();
    for (path, value) in &row.with {
        bus.set(path, *value).ms(30);
    }
    // One that is not the row's: 1.5 s let every message come.
    bus.set(&row.what, row.clear).ms(1_500);
    bus
}

/// A share of a limit, within what BMS4 resolves and what a temperature that is set moves.
fn is_left(now: f64, whole: f64, share: f64) -> bool {
    if share == 1.0 {
        now > 0.8 * whole || whole == 0.0
    } else {
        (now - whole * share).abs() <= 0.015 * whole * share + 0.1
    }
}

#[test]
fn bus_r085_to_bus_r117_every_row_of_the_table_both_sides_and_back() {
    for row in rows() {
        let name = format!("BUS-R{:03} code {} level {} at {}", row.rule, row.code, row.level, row.what);
        let mut bus = prepared(&row);
        let whole = bus.limits();
        assert!(!bus.set(&row.what, row.not_yet).says(&row), "{name}: {} is no fault", row.not_yet);
        assert!(bus.set(&row.what, row.set).says(&row), "{name}: {} is one", row.set);
        bus.ms(1_000);
        let now = bus.limits();
        assert!(is_left(now.0, whole.0, row.left.0), "{name}: charge {} of {}", now.0, whole.0);
        assert!(is_left(now.1, whole.1, row.left.1), "{name}: discharge {} of {}", now.1, whole.1);
        assert!(bus.set(&row.what, row.holds).says(&row), "{name}: {} holds it", row.holds);
        assert!(!bus.set(&row.what, row.clear).ms(600).says(&row), "{name}: {} clears it", row.clear);
    }
}

#[test]
fn bus_r095_bus_r106_to_bus_r108_bus_r113_bus_r114_rows_of_one_mode_are_silent_in_the_other() {
    for row in rows().iter().filter(|row| row.when != "always") {
        let mut bus = prepared(row);
        bus.set("charge.mains", 0.0)
            .set("charge.plug", if row.when == "driving" { 1.0 } else { 0.0 })
            .ms(100);
        assert!(!bus.set(&row.what, row.set).says(row), "BUS-R{:03} is of {}", row.rule, row.when);
    }
}

#[test]
fn bus_r072_bus_77_every_code_of_the_battery_goes_on_in_vcu7_with_its_level() {
    for row in rows() {
        let mut bus = prepared(&row);
        assert!(bus.set(&row.what, row.set).says(&row));
        bus.ms(3_000);
        // A second code of the same level may have its turn: each has one second.
        let came = (0..4).any(|_| bus.ms(1_000).forwarded() == (row.level, u16::from(row.code)));
        assert!(came, "BUS-R{:03}: {:?}", row.rule, bus.forwarded());
        assert!(
            bus.set(&row.what, row.clear).ms(4_000).forwarded().1 != u16::from(row.code) || row.code == 0
        );
    }
}

#[test]
fn bus_r116_bus_r117_a_fire_is_told_from_75_degrees_on_by_both_routes_and_stays() {
    let mut bus = Bus::new();
    bus.set("battery.coldest", 65.0).set("battery.hottest", 74.999).ms(3_000);
    assert!(bus.code() != 24 && bus.forwarded().1 != 24);
    let mut seen = std::collections::BTreeSet::new();
    bus.set("battery.hottest", 75.0).ms(1_000);
    for _ in 0..5 {
        bus.ms(1_000);
        seen.insert((bus.level(), bus.code(), bus.forwarded()));
    }
    assert!(seen.iter().any(|(level, code, _)| (*level, *code) == (3, 24)), "{seen:?}");
    assert!(seen.iter().any(|(_, _, forwarded)| *forwarded == (3, 24)), "{seen:?}");
    bus.set("battery.hottest", 25.0).ms(3_000);
    assert_eq!((bus.code(), bus.forwarded()), (24, (3, 24)), "until power-off");
}

#[test]
fn bus_r073_to_bus_r076_extreme_faults_ask_for_high_voltage_to_be_opened_both_sides() {
    let cases: [(Settings, &str, f64, f64); 4] = [
        (&[("battery.lowest_cell", 3.62)], "battery.highest_cell", 4.1, 4.101),
        (&[("battery.highest_cell", 2.75)], "battery.lowest_cell", 2.3, 2.299),
        (&[("battery.hottest", 5.0), ("battery.coldest", -5.0)], "battery.lowest_cell", 2.1, 2.099),
        (&[("battery.coldest", 55.0)], "battery.hottest", 65.0, 65.001),
    ];
    for (with, path, not_yet, set) in cases {
        let mut bus = Bus::new();
        for (path, value) in with {
            bus.set(path, *value).ms(30);
        }
        // BYTE7 bits 4-3: 2 = no request, 3 = open.
        let request = |bus: &mut Bus, value: f64| bus.set(path, value).ms(600).bytes(BMS1)[6] >> 3 & 0b11;
        assert_eq!(request(&mut bus, not_yet), 2, "{path} {not_yet}");
        assert_eq!(request(&mut bus, set), 3, "{path} {set}");
    }
}
