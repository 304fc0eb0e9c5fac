//! One image, every vehicle: the firmware that goes to the board finds out on which bus it is and shows what is sent.
//!
//! Values read back over the PC link are compared with what cantools decodes from the same frames.

mod firmware;

use bench::log::Log;
use bench::rig::{Rig, RigOptions};
use bench::time::Nanos;
use cluster::FaultId;
use protocol_core::Value;
use protocol_core::link::{Record, Sample};
use std::collections::HashMap;
use std::path::PathBuf;
use std::process::Command;
use surroundings::{need, root};

/// Time that the firmware has to start before the first frame is sent.
const BOOT: Nanos = Nanos::from_millis(500);
/// Part of each recording that is played, in milliseconds.
const PLAYED_MS: u64 = 4_000;

/// A value of the model, the signal that brings it, model counts in one unit of the signal.
type Row = (&'static str, &'static str, f64);

struct Vehicle {
    name: &'static str,
    log: &'static str,
    bitrate: u32,
    /// The image that knows it.
    elf: fn() -> PathBuf,
    rows: &'static [Row],
}

const BUS: Vehicle = Vehicle {
    name: "citybus",
    log: "city.log",
    bitrate: 250_000,
    elf: firmware::elf,
    rows: &[
        ("vehicle.speed", "VCU1.vehicle_speed", 256.0),
        ("vehicle.ready", "VCU1.ready", 1.0),
        ("battery.voltage", "BMS1.pack_voltage", 10.0),
        ("battery.current", "BMS1.pack_current", 10.0),
        ("battery.soc", "BMS1.soc", 10.0),
        ("motor.speed", "IPU2.motor_speed", 1.0),
        ("motor.temperature", "IPU2.motor_temperature", 1.0),
    ],
};

const JIULONG: Vehicle = Vehicle {
    name: "jiulong",
    log: "ride.log",
    bitrate: 250_000,
    elf: firmware::elf,
    rows: &[
        ("vehicle.speed", "VCU3.vehicle_speed", 256.0),
        ("vehicle.range", "VCU3.remaining_range", 8.0),
        ("motor.speed", "VCU3.motor_speed", 1.0),
        ("motor.torque", "VCU1.torque", 10.0),
        ("battery.voltage", "BMSStatus.pack_voltage", 10.0),
        ("battery.current", "BMSStatus.pack_current", 10.0),
        ("battery.soc", "BMSStatus.soc", 10.0),
        ("battery.cell.max", "BMSExtremes.max_cell_voltage", 1000.0),
        ("battery.cell.min", "BMSExtremes.min_cell_voltage", 1000.0),
        ("battery.temperature.max", "BMSExtremes.max_temperature", 1.0),
        ("battery.cell.count", "BMSFaults.series_cells", 1.0),
    ],
};

const C5EV: Vehicle = Vehicle {
    name: "c5ev",
    log: "ride.log",
    bitrate: 250_000,
    elf: firmware::elf,
    rows: &[
        ("vehicle.speed", "VCUToCluster.vehicle_speed", 256.0),
        ("vehicle.gear", "VCUToCluster.gear", 1.0),
        ("battery.soc", "VCUToCluster.soc", 10.0),
        ("battery.voltage", "VCUToCluster.battery_voltage", 10.0),
        ("motor.power", "VCUToCluster.motor_power", 1000.0),
        ("battery.current", "BMSA.pack_current", 10.0),
        ("battery.cell.max", "BMSB.max_cell_voltage", 1000.0),
    ],
};

const EXAMPLE: Vehicle = Vehicle {
    name: "example",
    log: "example.log",
    bitrate: 500_000,
    elf: firmware::elf_example,
    rows: &[
        ("vehicle.speed", "Drive.speed", 256.0),
        ("vehicle.accelerator", "Drive.accelerator", 10.0),
        ("motor.speed", "Motor.speed", 1.0),
        ("motor.torque", "Motor.torque", 10.0),
        ("battery.voltage", "Pack.voltage", 10.0),
        ("battery.current", "Pack.current", 10.0),
        ("battery.soc", "Pack.soc", 10.0),
        ("battery.cell.max", "PackDetails.max_cell_voltage", 1.0),
        ("battery.temperature.max", "PackDetails.max_temperature", 1.0),
        ("battery.discharge_limit", "PackDetails.discharge_limit", 10.0),
        ("dcdc.output", "Converter.output_voltage", 10.0),
        ("dcdc.current", "Converter.output_current", 10.0),
    ],
};

/// What a ride left behind.
struct Ride {
    rig: Rig,
    log: Log,
}

impl Vehicle {
    fn path(&self) -> PathBuf {
        root().join("vehicles").join(self.name).join("captures").join(self.log)
    }

    /// Plays the beginning of the recording to a board that has just started.
    fn ride(&self) -> Ride {
        let log = Log::read_file(&self.path()).unwrap();
        let until = Nanos::from_millis(PLAYED_MS);
        let log = Log { entries: log.entries.into_iter().filter(|entry| entry.at <= until).collect(), ..log };
        let options = RigOptions { bitrate: self.bitrate, ..RigOptions::default() };
        let mut rig = Rig::new(&(self.elf)(), &options).unwrap();
        rig.run_for(BOOT).unwrap();
        rig.replay(&log, false);
        rig.run_for(Nanos::from_millis(PLAYED_MS + 230)).unwrap();
        Ride { rig, log }
    }

    /// What cantools decodes from the frames that were played.
    fn cantools(&self) -> Option<HashMap<String, f64>> {
        let output = Command::new(need::witness("the values of the recordings")?)
            .arg(root().join("tools/witness/last_values.py"))
            .arg(root().join(format!("vehicles/{0}/{0}.dbc", self.name)))
            .arg(self.path())
            .arg((PLAYED_MS / 1_000).to_string())
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        Some(serde_json::from_slice(&output.stdout).unwrap())
    }

    fn is_recognised_and_read(&self) {
        let mut ride = self.ride();
        let named = |record: &Record| matches!(record, Record::Hello { vehicle, .. } if vehicle.as_str() == self.name);
        let greeted = ride.rig.records().iter().find(|(_, record)| named(record)).map(|(at, _)| *at);
        let greeted = greeted.unwrap_or_else(|| panic!("{} is not recognised", self.name));
        assert!(greeted <= BOOT + Nanos::from_secs(1), "{} at {greeted}", self.name);
        let path = self.rows[0].0;
        let first = self.first_value(&ride, path).expect("the first value of the list is shown");
        println!("{}: recognised at {greeted}, {path} at {first}", self.name);
        assert!(first <= BOOT + Nanos::from_secs(1), "{path} at {first}");

        if let Some(expected) = self.cantools() {
            for (path, signal, counts_per_unit) in self.rows {
                let physical = expected.get(*signal).unwrap_or_else(|| panic!("cantools has no {signal}"));
                // The model rounds down; the float may lie a hair below the exact decimal.
                let counts = (physical * counts_per_unit + 1e-6).floor() as i32;
                let shown = ride.rig.value(Value::from_path(path).unwrap());
                assert_eq!(
                    shown,
                    Sample::Value(counts),
                    "{}: {path} against {signal} = {physical}",
                    self.name
                );
            }
        }
        ride.rig.run_for(Nanos::from_millis(1_200)).unwrap();
        let violations = ride.rig.board().mcp2515().violations().first();
        assert!(violations.is_empty(), "{violations:?}");
        let health = ride.rig.health();
        assert_eq!((health.overruns, health.ring_overflows, health.spi_errors), (0, 0, 0));
        assert_eq!(u64::from(health.frames_received), ride.log.entries.len() as u64, "frames received");
    }

    /// When a value was first reported.
    fn first_value(&self, ride: &Ride, path: &str) -> Option<Nanos> {
        let index = Value::from_path(path)? as usize;
        let has_it = |record: &Record| match record {
            Record::Values { first, items } => {
                let sample = index.checked_sub(usize::from(*first)).and_then(|at| items.as_slice().get(at));
                matches!(sample, Some(Sample::Value(_)))
            }
            _ => false,
        };
        ride.rig.records().iter().find(|(_, record)| has_it(record)).map(|(at, _)| *at)
    }
}

#[test]
fn the_bus_is_recognised_and_its_values_are_those_of_cantools() {
    BUS.is_recognised_and_read();
}

#[test]
fn jiulong_is_recognised_and_its_values_and_cells_are_those_of_cantools() {
    JIULONG.is_recognised_and_read();
}

#[test]
fn c5ev_is_recognised_and_its_values_are_those_of_cantools() {
    C5EV.is_recognised_and_read();
}

#[test]
fn an_image_for_the_example_reads_500_kbit_and_11_bits_and_its_values_are_those_of_cantools() {
    EXAMPLE.is_recognised_and_read();
}

#[test]
fn until_a_vehicle_is_known_the_cluster_is_not_on_the_bus() {
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.run_for(Nanos::from_secs(3)).unwrap();
    assert!(rig.heard().iter().all(|heard| !heard.by_cluster), "nothing is sent to an unknown bus");
    let line = rig.screen().unwrap().line.expect("the screen says that it listens");
    assert_eq!(line.fault, FaultId::Listening.number());
}

#[test]
fn a_frame_that_came_before_the_recognition_is_shown_all_the_same() {
    let log = Log::read_file(&JIULONG.path()).unwrap();
    // Each message once: the last of them is the proof, the first one was heard before it.
    let short = Log { entries: log.entries.iter().take(8).cloned().collect(), ..log };
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.run_for(BOOT).unwrap();
    rig.replay(&short, false);
    rig.run_for(Nanos::from_millis(500)).unwrap();
    assert_eq!(rig.value(Value::VehicleReady), Sample::Value(1), "from VCU1");
    assert_eq!(rig.value(Value::VehicleRange), Sample::Value(143 * 8), "from VCU3");
}

#[test]
fn another_vehicle_on_the_same_bus_is_told_and_changes_nothing() {
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.run_for(BOOT).unwrap();
    rig.replay(&Log::read_file(&BUS.path()).unwrap(), true);
    rig.run_for(Nanos::from_secs(4)).unwrap();
    let soc = rig.value(Value::BatterySoc);
    assert!(matches!(soc, Sample::Value(_)));
    rig.replay(&Log::read_file(&JIULONG.path()).unwrap(), true);
    rig.run_for(Nanos::from_secs(2)).unwrap();
    assert_eq!(rig.value(Value::BatterySoc), soc, "the bus's own, not Jiulong's 66 %");
    let greetings = rig.records().iter().filter_map(|(_, record)| match record {
        Record::Hello { vehicle, .. } => Some(vehicle.as_str()),
        _ => None,
    });
    assert!(greetings.into_iter().all(|name| ["", "citybus"].contains(&name)));
    let line = rig.screen().unwrap().line.expect("the driver is told");
    assert_eq!(line.fault, FaultId::Doubt.number());
}
