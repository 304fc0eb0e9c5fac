//! The cluster on C5EV's bus: one frame commands lamps and buzzer; the battery adds details. Bytes written by hand.

use cluster::view::Plug;
use cluster::{Cluster, Inputs, Sound, Telltale};
use protocol_core::generated::c5ev::VEHICLE;
use protocol_core::model::{Gear, Severity, Shown};
use protocol_core::{CanFrame, CanId, Millis};

fn id(name: &str) -> CanId {
    VEHICLE.rx.iter().find(|message| message.name == name).expect("in the table").id
}

struct Ride {
    cluster: Cluster,
    now: Millis,
    kept: Vec<(CanId, [u8; 8])>,
}

impl Ride {
    fn new() -> Self {
        let mut ride = Self { cluster: Cluster::new(&VEHICLE), now: Millis(0), kept: Vec::new() };
        ride.keep("VCUToCluster", command(0, 0));
        ride.run(3_010);
        ride
    }

    fn keep(&mut self, name: &str, data: [u8; 8]) {
        let id = id(name);
        self.kept.retain(|kept| kept.0 != id);
        self.kept.push((id, data));
    }

    fn hush(&mut self, name: &str) {
        let id = id(name);
        self.kept.retain(|kept| kept.0 != id);
    }

    fn run(&mut self, ms: u64) {
        for _ in 0..ms / 10 {
            if self.now.0.is_multiple_of(100) {
                for &(id, data) in &self.kept {
                    self.cluster.receive(&CanFrame::full(id, data), self.now);
                }
            }
            self.cluster.tick(&Inputs::default(), self.now);
            self.now = self.now.after(10);
        }
    }

    fn lit(&self) -> Vec<Telltale> {
        let telltales = self.cluster.view(self.now).telltales;
        Telltale::ALL.iter().copied().filter(|&lamp| telltales.is_lit(lamp)).collect()
    }

    fn sound(&self) -> Option<Sound> {
        self.cluster.chime(self.now).map(|chime| chime.sound)
    }

    fn texts(&self) -> Vec<(&'static str, Severity)> {
        self.cluster.active_faults(self.now).map(|fault| (fault.text.en, fault.severity)).collect()
    }
}

/// The cluster's frame: 10 %, standing, 0 kW, 320 V, 60 km, with two bytes of bits.
fn command(byte_6: u8, byte_7: u8) -> [u8; 8] {
    [20, 0, 50, 0x40, 0x01, 60, byte_6, byte_7]
}

#[test]
fn c5_r012_each_lamp_follows_its_bit_alone_and_at_once() {
    let lamps = [
        (0x04, 0, Telltale::Insulation),
        (0x08, 0, Telltale::BatteryFault),
        (0x10, 0, Telltale::MotorFault),
        (0x20, 0, Telltale::Ready),
        (0x40, 0, Telltale::SystemFault),
        (0x80, 0, Telltale::Charging),
        (0, 0x01, Telltale::BrakeForce),
        (0, 0x02, Telltale::AntiLock),
        (0, 0x04, Telltale::PowerLimited),
        (0, 0x08, Telltale::ChargePlug),
        (0, 0x20, Telltale::LowCharge),
    ];
    for (byte_6, byte_7, lamp) in lamps {
        let mut ride = Ride::new();
        assert_eq!(ride.lit(), [], "C5-34: 10 % of charge alone lights nothing");
        ride.keep("VCUToCluster", command(byte_6, byte_7));
        ride.run(100);
        assert_eq!(ride.lit(), [lamp], "{byte_6:02X} {byte_7:02X}");
        ride.keep("VCUToCluster", command(0, 0));
        ride.run(100);
        assert_eq!(ride.lit(), []);
    }
}

#[test]
fn c5_r013_the_buzzer_follows_bit_6_of_byte_7_with_a_guard_of_two_minutes() {
    let mut ride = Ride::new();
    ride.keep("VCUToCluster", command(0, 0x40));
    ride.run(10_000);
    assert_eq!(ride.sound(), Some(Sound::Buzzer));
    ride.run(120_000);
    assert_eq!(ride.sound(), None, "C5-R014, C5-20");
    ride.keep("VCUToCluster", command(0, 0));
    ride.run(100);
    ride.keep("VCUToCluster", command(0, 0x40));
    ride.run(100);
    assert_eq!(ride.sound(), Some(Sound::Buzzer));
}

#[test]
fn c5_15_the_second_stage_of_an_alarm_is_worse_than_the_first() {
    let stages = [
        ([1, 0, 0, 0], "Cell overvoltage 1", Severity::Warn),
        ([0, 1, 0, 0], "Cell overvoltage 2", Severity::Derate),
        ([0, 0, 0x10, 0], "Insulation 1", Severity::Warn),
        ([0, 0, 0, 0x10], "Insulation 2", Severity::Derate),
    ];
    for (bytes, text, severity) in stages {
        let mut ride = Ride::new();
        let mut data = [0, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF];
        data[..4].copy_from_slice(&bytes);
        ride.keep("BMSD", data);
        ride.run(100);
        assert_eq!(ride.texts(), [(text, severity)]);
    }
}

#[test]
fn c5_r003_what_the_cluster_s_own_frame_says_is_shown() {
    let mut ride = Ride::new();
    ride.keep("VCUToCluster", [150, 50, 80, 0x40, 0x01, 60, 0, 0]);
    ride.run(100);
    let view = ride.cluster.view(ride.now);
    assert_eq!((view.speed_kmh, view.soc_percent), (Shown::Value(50), Shown::Value(75)));
    assert_eq!(view.pack_decivolts, Shown::Value(3_200));
    assert_eq!(view.power_hectowatts, Shown::Value(300), "the motor's own, 80 - 50 kW");
    assert_eq!(view.range.map(|range| range.km), Shown::Value(60));
    assert_ne!(view.gear, Some(Gear::P), "the frame has D, R and N only");
}

#[test]
fn c5_r005_a_charger_that_falls_silent_is_told_after_five_seconds() {
    let mut ride = Ride::new();
    ride.keep("VCUToCluster", command(0x80, 0x08));
    ride.keep("ChargerTx", [0x10, 0x0E, 0x64, 0, 0, 0, 0, 0]);
    ride.run(1_000);
    let charging = ride.cluster.view(ride.now).charging.expect("plugged in");
    assert_eq!((charging.plug, charging.deciamps), (Plug::Charging, Shown::Value(100)));
    ride.hush("ChargerTx");
    ride.run(4_990);
    assert_eq!(ride.texts(), []);
    ride.run(10);
    assert_eq!(ride.texts(), [("Charger lost: charging ends", Severity::Warn)], "C5-41");
}

#[test]
fn silence_of_the_cluster_s_frame_darkens_the_healthy_and_keeps_the_warnings() {
    let mut ride = Ride::new();
    ride.keep("VCUToCluster", command(0x28, 0x20));
    ride.run(100);
    assert_eq!(ride.lit(), [Telltale::Ready, Telltale::BatteryFault, Telltale::LowCharge]);
    ride.hush("VCUToCluster");
    ride.run(10_000);
    assert_eq!(ride.lit(), [Telltale::BatteryFault, Telltale::NoCommunication]);
}
