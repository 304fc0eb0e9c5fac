//! The cluster on jiulong's bus: bytes as the document prints them, written by hand.

use cluster::{Cluster, Inputs, Options, Sound, Telltale};
use protocol_core::generated::jiulong::VEHICLE;
use protocol_core::model::{Severity, Shown};
use protocol_core::{CanFrame, CanId, Millis};

const VCU1: u32 = 0x1802_28D0;
const VCU2: u32 = 0x1803_28D0;
const VCU3: u32 = 0x1804_28D0;
const STATUS: u32 = 0x1802_28F3;
const FAULTS: u32 = 0x181B_28F3;
const TO_VEHICLE: u32 = 0x1800_D028;
const UPGRADE_VEHICLE: u32 = 0x1801_D028;
const UPGRADE_BATTERY: u32 = 0x1800_F328;

struct Ride {
    cluster: Cluster,
    inputs: Inputs,
    now: Millis,
    sent: Vec<(u64, CanFrame)>,
}

impl Ride {
    /// A cluster after its bulb check, on a bus on which nothing has been heard yet.
    fn new() -> Self {
        let cluster = Cluster::with_options(&VEHICLE, Options { may_upgrade: true, ..Options::NONE });
        let mut ride = Self { cluster, inputs: Inputs::default(), now: Millis(0), sent: Vec::new() };
        ride.run(3_000);
        ride
    }

    fn run(&mut self, ms: u64) {
        for _ in 0..ms / 10 {
            self.cluster.tick(&self.inputs, self.now);
            while let Some(frame) = self.cluster.transmit(self.now) {
                self.sent.push((self.now.0, frame));
            }
            self.now = self.now.after(10);
        }
    }

    fn receive(&mut self, id: u32, data: [u8; 8]) {
        self.cluster.receive(&CanFrame::full(CanId::extended(id), data), self.now);
    }

    fn texts(&self) -> Vec<(&'static str, Severity)> {
        let faults = self.cluster.active_faults(self.now);
        faults.map(|fault| (fault.text.en, fault.severity)).collect()
    }

    /// What was last sent.
    fn last(&self, id: u32) -> [u8; 8] {
        let id = CanId::extended(id);
        *self.sent.iter().rfind(|(_, frame)| frame.id == id).expect("it is sent").1.padded()
    }
}

/// VCU3 at a whole km/h, motor speed 0, no alarm.
fn speed(kmh: u8) -> [u8; 8] {
    [kmh, 0, 100, 0x3A, 0x98, 0, 0, 0]
}

#[test]
fn jl_r013_level_1_is_the_worst_level_and_level_3_the_mildest() {
    // Byte 4 of VCU2: bits 1-0 motor, 3-2 battery, 5-4 vehicle controller; BMSStatus: the battery itself.
    type Report = fn(u8) -> (u32, [u8; 8]);
    let sources: [(Report, Telltale); 4] = [
        (|raw| (VCU2, [1, 0, 0, raw, 0, 90, 0xFF, 0]), Telltale::MotorFault),
        (|raw| (VCU2, [1, 0, 0, raw << 2, 0, 90, 0xFF, 0]), Telltale::BatteryFault),
        (|raw| (VCU2, [1, 0, 0, raw << 4, 0, 90, 0xFF, 0]), Telltale::SystemFault),
        (|raw| (STATUS, [0x15, 0x18, 0x13, 0x88, 200, 1, raw, 0]), Telltale::BatteryFault),
    ];
    for (raw, severity, sound) in [
        (0, Severity::None, None),
        (1, Severity::Stop, Some(Sound::Stop)),
        (2, Severity::Derate, Some(Sound::Derate)),
        (3, Severity::Warn, Some(Sound::Warn)),
    ] {
        for (place, (source, lamp)) in sources.iter().enumerate() {
            let mut ride = Ride::new();
            let (id, data) = source(raw);
            ride.receive(id, data);
            ride.run(10);
            let view = ride.cluster.view(ride.now);
            assert_eq!(view.severity, severity, "JL-14, JL-R010, JL-R019: {raw} of source {place}");
            let line = view.line.map(|line| line.severity);
            assert_eq!(line, (raw != 0).then_some(severity), "{raw} of source {place}");
            let heard = ride.cluster.chime(ride.now).map(|chime| chime.sound);
            assert_eq!(heard, sound, "a buzzer: {raw} of source {place}");
            assert_eq!(view.telltales.is_lit(*lamp), raw != 0, "{raw} of source {place}");
        }
    }
}

#[test]
fn jl_r013_of_the_battery_s_two_levels_the_worse_is_told_once_and_outlives_the_milder() {
    let severity =
        |raw: u8| [Severity::None, Severity::Stop, Severity::Derate, Severity::Warn][usize::from(raw)];
    for own in 0..=3 {
        for copy in 0..=3 {
            let mut ride = Ride::new();
            ride.receive(STATUS, [0x15, 0x18, 0x13, 0x88, 200, 1, own, 0]);
            ride.receive(VCU2, [1, 0, 0, copy << 2, 0, 90, 0xFF, 0]);
            ride.run(10);
            let worse = severity(own).max(severity(copy));
            let told: Vec<_> = ride.texts().iter().map(|text| text.1).collect();
            let expected: Vec<_> = (worse != Severity::None).then_some(worse).into_iter().collect();
            assert_eq!(told, expected, "own {own}, copy {copy}");
            // The battery falls silent; the vehicle controller goes on. A STOP stays until its own source takes it back.
            for life in 2..60 {
                ride.receive(VCU2, [life, 0, 0, copy << 2, 0, 90, 0xFF, 0]);
                ride.run(100);
            }
            let kept = if severity(own) == Severity::Stop { Severity::Stop } else { severity(copy) };
            let battery = ride
                .texts()
                .iter()
                .filter(|text| text.0.starts_with("Battery fault"))
                .map(|text| text.1)
                .max();
            assert_eq!(battery.unwrap_or_default(), kept, "own {own} is silent, copy {copy}");
        }
    }
}

#[test]
fn jl_r019_the_driver_reads_the_level_number_of_the_vehicles_own_documents() {
    for (raw, words, severity) in [
        (1, "Battery fault level 1", Severity::Stop),
        (2, "Battery fault level 2", Severity::Derate),
        (3, "Battery fault level 3", Severity::Warn),
    ] {
        let mut ride = Ride::new();
        ride.receive(STATUS, [0x15, 0x18, 0x13, 0x88, 200, 1, raw, 0]);
        ride.run(10);
        assert!(ride.texts().contains(&(words, severity)), "JL-14, X-01: {:?}", ride.texts());
    }
}

#[test]
fn jl_r023_jl_r024_a_smoke_alarm_is_level_1_and_a_detector_fault_level_2() {
    for detector in 0..6 {
        let mut ride = Ride::new();
        ride.receive(FAULTS, [0, 0, 100, 200, 0, 1 << detector, 0, 0]);
        ride.run(10);
        assert_eq!(ride.texts().iter().map(|text| text.1).collect::<Vec<_>>(), [Severity::Derate]);
        ride.receive(FAULTS, [0, 0, 100, 200, 0, 0, 1 << detector, 0]);
        ride.run(10);
        let [(text, severity)] = ride.texts()[..] else { panic!("one alarm: {:?}", ride.texts()) };
        assert_eq!((text.starts_with("Smoke alarm"), severity), (true, Severity::Stop));
        let view = ride.cluster.view(ride.now);
        assert!(view.telltales.is_lit(Telltale::BatteryFault));
        assert_eq!(ride.cluster.chime(ride.now).map(|chime| chime.sound), Some(Sound::Stop), "JL-24");
    }
}

#[test]
fn jl_33_every_battery_alarm_bit_has_its_own_text() {
    let mut seen = Vec::new();
    for (byte, bits) in [(0, 8), (1, 8), (5, 6), (6, 6), (7, 1)] {
        for bit in 0..bits {
            let mut ride = Ride::new();
            let mut data = [0, 0, 100, 200, 0, 0, 0, 0];
            data[byte] = 1 << bit;
            ride.receive(FAULTS, data);
            ride.run(10);
            let texts = ride.texts();
            assert!(!texts.is_empty(), "byte {byte}, bit {bit}");
            seen.push(texts[0].0);
        }
    }
    let count = seen.len();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!((count, seen.len()), (29, 29));
}

#[test]
fn every_motor_alarm_bit_has_its_own_text() {
    let mut seen = Vec::new();
    for bit in 0..23 {
        let mut ride = Ride::new();
        let mut data = speed(0);
        data[5 + bit / 8] = 1 << (bit % 8);
        ride.receive(VCU3, data);
        ride.run(10);
        let [(text, Severity::Warn)] = ride.texts()[..] else { panic!("one alarm: {:?}", ride.texts()) };
        seen.push(text);
    }
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen.len(), 23);
}

#[test]
fn jl_23_the_low_supply_lights_its_lamp_from_either_frame() {
    let frames = [(VCU1, [1, 0x40, 0, 0, 0x75, 0x30, 80, 0]), (VCU2, [1, 0, 0, 0, 0x10, 90, 0xFF, 0])];
    for (id, data) in frames {
        let mut ride = Ride::new();
        ride.receive(id, data);
        ride.run(10);
        assert_eq!(ride.texts(), [("Low-voltage supply low", Severity::Warn)]);
        assert!(ride.cluster.view(ride.now).telltales.is_lit(Telltale::LowVoltage));
    }
}

#[test]
fn jl_22_the_whole_byte_is_a_speed_and_the_range_is_shown_as_sent() {
    let mut ride = Ride::new();
    ride.receive(VCU3, [255, 0x01, 0x2C, 0x3A, 0x98, 0, 0, 0]);
    let view = ride.cluster.view(ride.now);
    assert_eq!(view.speed_kmh, Shown::Value(255));
    assert_eq!(view.range.map(|range| (range.km, range.is_estimated)), Shown::Value((300, false)));
}

/// A van that is driven and asked whether it may be upgraded.
struct Van {
    ride: Ride,
    life: u8,
}

impl Van {
    /// Lets time pass with these bytes of VCU1 (READY), VCU2 (gear) and VCU3 (speed); `None` = the frame does not come.
    fn drive(&mut self, ready: Option<u8>, gear: Option<u8>, kmh: Option<u8>) -> (u8, u8) {
        for _ in 0..60 {
            self.life = self.life.wrapping_add(1);
            let life = self.life;
            ready.iter().for_each(|&ready| self.ride.receive(VCU1, [life, ready, 0, 0, 0x75, 0x30, 80, 0]));
            gear.iter().for_each(|&gear| self.ride.receive(VCU2, [life, gear, 0, 0, 0, 90, 0xFF, 200]));
            kmh.iter().for_each(|&kmh| self.ride.receive(VCU3, speed(kmh)));
            self.ride.run(100);
        }
        (self.ride.last(UPGRADE_VEHICLE)[1], self.ride.last(UPGRADE_BATTERY)[1])
    }
}

#[test]
fn jl_r031_remote_upgrade_is_allowed_only_at_a_known_standstill_in_a_known_neutral_and_known_not_ready() {
    const ALLOWED: (u8, u8) = (0, 0);
    const FORBIDDEN: (u8, u8) = (1, 1);
    // Gears as the DBC's table: 0 N, 1 D, 2 R, 3 none.
    for (ready, gear, kmh) in [
        (None, None, None),
        (None, Some(0), Some(0)),
        (Some(0), None, Some(0)),
        (Some(0), Some(0), None),
        (Some(1), Some(0), Some(0)),
        (Some(0), Some(1), Some(0)),
        (Some(0), Some(2), Some(0)),
        (Some(0), Some(3), Some(0)),
        (Some(0), Some(0), Some(1)),
        (Some(0), Some(0), Some(255)),
    ] {
        let mut van = Van { ride: Ride::new(), life: 0 };
        assert_eq!(van.drive(ready, gear, kmh), FORBIDDEN, "from the start: {ready:?} {gear:?} {kmh:?}");
        assert_eq!(van.drive(Some(0), Some(0), Some(0)), ALLOWED, "parked after {ready:?} {gear:?} {kmh:?}");
        assert_eq!(van.drive(ready, gear, kmh), FORBIDDEN, "after it was parked: {ready:?} {gear:?} {kmh:?}");
        assert_eq!(van.ride.last(UPGRADE_VEHICLE)[2..], [0; 6], "reserved bytes are 0 here");
    }
}

#[test]
fn jl_04_jl_r026_the_distance_goes_middle_low_high_beside_supply_and_versions() {
    let mut ride = Ride::new();
    ride.cluster.restore(0x0012_3456 * 8 + 7);
    ride.inputs.supply_decivolts = Some(0x0102);
    ride.run(1_000);
    let [_, volts_high, volts_low, middle, low, high, hardware, software] = ride.last(TO_VEHICLE);
    assert_eq!((volts_high, volts_low), (1, 2), "0.1 V, high byte first");
    assert_eq!([middle, low, high], [0x34, 0x56, 0x12]);
    assert!(hardware > 0 && software > 0);
}

#[test]
fn jl_42_each_sent_message_keeps_its_cycle_and_counts_from_0_to_255_and_round() {
    let mut ride = Ride::new();
    ride.run(300_000);
    for (id, cycle) in [(TO_VEHICLE, 500), (UPGRADE_VEHICLE, 1_000), (UPGRADE_BATTERY, 1_000)] {
        let sent: Vec<_> = ride.sent.iter().filter(|(_, frame)| frame.id == CanId::extended(id)).collect();
        assert_eq!(sent.len(), 303_000 / cycle, "{id:08X}");
        for (n, pair) in sent.windows(2).enumerate() {
            assert_eq!(pair[1].0 - pair[0].0, cycle as u64, "{id:08X}");
            assert_eq!(usize::from(pair[0].1.padded()[0]), n % 256, "JL-R009");
        }
    }
}

#[test]
fn jl_23_a_living_batterys_charge_is_taken_from_the_vehicle_controllers_copy() {
    let mut ride = Ride::new();
    // 80 % by the battery, 60 % by the copy, so that one can tell them apart.
    let mut drive = |status: bool, battery: bool, copy: u8| {
        for life in 0..30 {
            ride.receive(VCU2, [life, 0, 0, 0, 0, 90, 0xFF, copy]);
            if status {
                ride.receive(STATUS, [0x15, 0x18, 0x13, 0x88, 200, life, 0, 0]);
            }
            if battery {
                ride.receive(FAULTS, [0; 8]);
            }
            ride.run(100);
        }
        ride.cluster.view(ride.now).soc_percent
    };
    assert_eq!(drive(true, true, 150), Shown::Value(80), "the battery's own has precedence");
    assert_eq!(drive(false, true, 150), Shown::Value(60), "its status is missing, it speaks");
    assert_eq!(drive(false, true, 0xFF), Shown::Stale, "no copy");
    assert_eq!(drive(false, false, 150), Shown::Stale, "a silent battery: the copy is old");
    assert_eq!(drive(true, true, 150), Shown::Value(80));
}
