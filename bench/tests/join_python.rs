//! Another tool on the bench's bus: python-can, over the pseudo-terminal, with cantools as its decoder and encoder.
//!
//! Nothing here waits for the wall clock: virtual time goes on while the client lives, up to a limit in virtual time,
//! and what is judged is what the bus and the firmware did.

#![cfg(unix)]

mod firmware;

use bench::join::Members;
use bench::join::pty::Pty;
use bench::join::terminal::Terminal;
use bench::rig::{Rig, RigOptions};
use bench::time::Nanos;
use protocol_core::Value;
use protocol_core::link::Sample;
use std::collections::{HashMap, VecDeque};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use surroundings::{need, root};
use virtual_vehicle::{Kind, Options, VirtualVehicle};

/// Virtual time between two looks at the client and the firmware.
const SLICE: Nanos = Nanos::from_millis(10);
/// Virtual time after which a client that still lives has hung.
const LIMIT: Nanos = Nanos::from_secs(900);
/// Time that the firmware takes at most to draw what it says it shows.
const DRAWN: Nanos = Nanos::from_millis(60);
/// Pictures that are kept: the firmware says what it shows up to half a second after it has drawn it.
const PICTURES: usize = 50;
/// What the vehicle is told: control, setting, signal that a client sees it in, one count of that signal.
const TOLD: &[(&str, f64, &str, f64)] = &[
    ("battery.soc", 61.6, "BMS1.soc", 0.4),
    ("battery.volts", 543.2, "BMS1.pack_voltage", 0.1),
    ("battery.highest_cell", 3.46, "BMS2.max_cell_voltage", 0.01),
    ("motor.celsius", 77.0, "IPU2.motor_temperature", 1.0),
];
/// The message that the client sends in place of the vehicle.
const LOST: &str = "VCU1";
/// What the client says of the speed, in km/h.
const SPEED: i32 = 88;

/// A vehicle that does not send its speed.
fn vehicle() -> VirtualVehicle {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    vehicle.set(&format!("lost.{LOST}"), Some(1.0)).unwrap();
    for (control, setting, ..) in TOLD {
        vehicle.set(control, Some(*setting)).unwrap();
    }
    vehicle
}

/// What the client prints when it is done.
#[derive(serde::Deserialize)]
struct Report {
    version: (u8, u8),
    serial: String,
    frames: usize,
    counts: HashMap<String, usize>,
    heard: HashMap<String, f64>,
}

fn client(python: &Path, terminal: &Path) -> Child {
    let arguments = ["250000", "400", "40", LOST].map(str::to_owned);
    Command::new(python)
        .arg(root().join("tools/witness/join_bus.py"))
        .arg(terminal)
        .arg(root().join("vehicles/citybus/citybus.dbc"))
        .args(arguments)
        .args([format!("vehicle_speed={SPEED}"), "ready=1".into()])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Is done after so many slices.
fn slices(count: usize) -> impl FnMut() -> bool {
    let mut left = count;
    move || {
        left = left.saturating_sub(1);
        left == 0
    }
}

fn pixels(rig: &Rig) -> Vec<u16> {
    let panel = rig.board().panel();
    (0..240).flat_map(|y| (0..320).map(move |x| (x, y))).map(|(x, y)| panel.colour_at(x, y)).collect()
}

/// The firmware with a client on its bus, and what was seen of it.
struct Joined {
    rig: Rig,
    /// The last pictures, one per slice, oldest first.
    pictures: VecDeque<Vec<u16>>,
    /// The speed that the firmware reported.
    reported: Option<Sample>,
    /// Pixels that moved within the last pictures when the firmware said that it shows the speed.
    moved: Option<usize>,
}

impl Joined {
    /// Lets time pass until `done`, or the limit is reached.
    fn drive(&mut self, mut done: impl FnMut() -> bool) {
        let end = self.rig.now() + LIMIT;
        while !done() {
            assert!(self.rig.now() < end, "the client has not ended within {LIMIT} of virtual time");
            self.rig.run_for(SLICE).unwrap();
            self.look();
            // Leaves the processor to the client; how long that takes changes no verdict.
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    fn look(&mut self) {
        let speed = self.rig.value(Value::VehicleSpeed);
        if matches!(speed, Sample::Value(_)) {
            self.reported = Some(speed);
        }
        let shown = self.rig.screen().is_some_and(|screen| screen.speed_kmh == Sample::Value(SPEED));
        if shown && self.moved.is_none() {
            self.rig.run_for(DRAWN).unwrap();
            self.photograph();
            self.moved = Some(self.moved_pixels());
        } else if self.moved.is_none() {
            self.photograph();
        }
    }

    fn photograph(&mut self) {
        if self.pictures.len() == PICTURES {
            self.pictures.pop_front();
        }
        self.pictures.push_back(pixels(&self.rig));
    }

    /// Pixels that differ between the oldest and the newest picture.
    fn moved_pixels(&self) -> usize {
        let (before, after) = (self.pictures.front().unwrap(), self.pictures.back().unwrap());
        before.iter().zip(after).filter(|(before, after)| before != after).count()
    }
}

#[test]
fn python_can_hears_the_vehicle_and_what_it_sends_moves_the_needle() {
    let Some(python) = need::witness("another tool on the bus") else { return };
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.drive(vehicle());
    let pty = Pty::open().unwrap();
    let terminal = pty.path().to_owned();
    let members = Members::default();
    members.add(Terminal::new("slcan", pty));
    rig.host(&members);
    rig.run_for(Nanos::from_secs(2)).unwrap();
    assert_eq!(rig.value(Value::VehicleSpeed), Sample::Never, "nobody has sent the speed yet");

    let mut joined = Joined { rig, pictures: VecDeque::new(), reported: None, moved: None };
    joined.drive(slices(100));
    let moved_without = joined.moved_pixels();
    let mut child = client(&python, &terminal);
    joined.drive(|| child.try_wait().unwrap().is_some());
    joined.drive(slices(100));
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let report: Report = serde_json::from_slice(&output.stdout).unwrap();

    assert_eq!((report.version, report.serial.as_str(), report.frames), ((1, 1), "BNCH", 400));
    for (control, told, signal, count) in TOLD {
        let heard = report.heard.get(*signal).unwrap_or_else(|| panic!("{signal} was not heard"));
        assert!(
            (heard - told).abs() <= *count,
            "{control} was set to {told}, cantools says {signal} = {heard}"
        );
    }
    assert!(report.counts.contains_key("Meter1"), "the cluster's own frames: {:?}", report.counts);
    assert!(!report.counts.contains_key(LOST), "its own frames do not come back to a client");

    assert_eq!(joined.reported, Some(Sample::Value(SPEED * 256)), "the firmware's own word on the speed");
    let moved = joined.moved.expect("the firmware said that it shows the speed");
    println!(
        "{} frames heard; {moved} pixels moved with what was sent, {moved_without} before",
        report.frames
    );
    assert!(moved > 1_000 + 2 * moved_without, "{moved} pixels moved, {moved_without} do without the client");
}
