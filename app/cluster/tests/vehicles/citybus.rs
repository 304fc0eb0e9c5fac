//! The cluster on the generated citybus: bytes as the document prints them, and a minute of city driving.
//!
//! The bytes are written by hand from the document, not with the generated codecs.

use crate::support::*;
use cluster::view::ActiveFault;
use cluster::{Button, Cluster, Contacts, FaultId, Inputs, Key, Received, Sound, Telltale, View};
use protocol_core::generated::citybus::VEHICLE;
use protocol_core::model::{Gear, Severity, Shown, Value};
use protocol_core::{CanFrame, CanId, Millis};

pub(super) const VCU1: u32 = 0x0CF1_01A7;
pub(super) const VCU7: u32 = 0x0CF1_064A;
pub(super) const IPU3: u32 = 0x18F1_21F0;
pub(super) const BMS1: u32 = 0x18F1_3DF3;
pub(super) const BMS5: u32 = 0x18F1_41F3;
pub(super) const STEERING: u32 = 0x142F_FF95;
pub(super) const DCDC: u32 = 0x142C_FF98;
pub(super) const AIR: u32 = 0x1429_FF9B;
pub(super) const METER1: u32 = 0x18F4_3A17;
pub(super) const METER2: u32 = 0x18F5_4A17;

/// BMS1 of a healthy pack: 540.0 V, 10.0 A, 75.0 %, no HV-off request (10), main relay closed (01).
pub(super) const PACK: [u8; 8] = [0x18, 0x15, 0x74, 0x27, 0xBB, 0x00, 0b0001_0000, 0b0100_0000];

/// A cluster and its clock; a frame given once is not repeated.
pub(super) fn started() -> Drive {
    let mut ride = Drive::of(&VEHICLE);
    ride.run(TICK);
    ride
}

/// What is sent within a second, by identifier.
fn sent(ride: &mut Drive, id: u32) -> [u8; 8] {
    let mut data = None;
    for _ in 0..1_000 / TICK {
        ride.run(TICK);
        while let Some(frame) = ride.cluster.transmit(ride.last()) {
            data = (frame.id == CanId::extended(id)).then_some(*frame.padded()).or(data);
        }
    }
    data.expect("a cycle of 1000 ms")
}

#[test]
fn bus_36_gear_codes_of_vcu1() {
    use Gear::{D, D1, N, P, R};
    let gears = [
        (0b0000, None),
        (0b0001, Some(D)),
        (0b0010, Some(R)),
        (0b0011, Some(D1)),
        (0b0100, Some(N)),
        (0b0111, None),
        (0b1000, Some(P)),
        (0b1100, None),
        (0b1111, None),
    ];
    for (life, (code, gear)) in (1..).zip(gears) {
        let mut ride = started();
        assert_eq!(ride.hear(VCU1, [code << 2, 0, 0, 0, 0, 0xFF, 0, life]).gear, gear, "{code:04b}");
    }
}

#[test]
fn bus_r020_the_speed_of_vcu1_is_in_256ths() {
    let mut ride = started();
    assert_eq!(ride.hear(VCU1, [0, 0, 0xFF, 0x31, 0, 0xFF, 0, 1]).speed_kmh, Shown::Value(49));
    assert_eq!(ride.hear(VCU1, [0, 0, 0xFF, 0xFF, 0, 0xFF, 0, 2]).speed_kmh, Shown::Invalid, "BUS-14");
}

#[test]
fn bus_r022_to_bus_r025_lamps_of_vcu1() {
    let lamps = [
        (0b1000_0000, Telltale::Ready),
        (0b0100_0000, Telltale::SystemFault),
        (0b0000_0010, Telltale::PowerLimited),
        (0b0000_0001, Telltale::PowerLimited),
    ];
    for (bits, lamp) in lamps {
        let mut ride = started();
        ride.run(3_000);
        let view = ride.hear(VCU1, [0, 0, 0, 0, 0, 0xFF, bits, 1]);
        let lit: Vec<_> = Telltale::ALL.iter().filter(|&&lamp| view.telltales.is_lit(lamp)).collect();
        assert_eq!(lit, [&lamp], "BYTE7 = {bits:08b}");
    }
}

#[test]
fn bus_r071_cell_voltages_and_temperatures_of_bms2() {
    let mut ride = started();
    // 3.38 V and 3.35 V at 0.01 V, 32 and 29 degrees with 40 added.
    let view = ride.hear(0x18F1_3EF3, [0x52, 0x01, 0x4F, 0x01, 72, 69, 0xFF, 0xFF]);
    assert_eq!(view.cell_millivolts, (Shown::Value(3_380), Shown::Value(3_350)));
    assert_eq!(view.cell_celsius, (Shown::Value(32), Shown::Value(29)));
    let view = ride.hear(0x18F1_3EF3, [0xFF; 8]);
    assert_eq!(view.cell_millivolts, (Shown::Invalid, Shown::Invalid), "BUS-14");
    assert_eq!(view.cell_celsius, (Shown::Invalid, Shown::Invalid));
}

#[test]
fn bus_34_the_levels_of_vcu7_and_bms1_run_in_opposite_directions() {
    use Severity::{Derate, None, Stop, Warn};
    for (raw, vehicle, battery) in [(0, None, None), (1, Warn, Stop), (2, Derate, Derate), (3, Stop, Warn)] {
        let mut ride = started();
        assert_eq!(ride.hear(VCU7, [raw, 0, 0, 0, 0, 0, 0, 0]).severity, vehicle, "VCU7 {raw}");
        let mut ride = started();
        let mut data = PACK;
        data[6] |= raw;
        assert_eq!(ride.hear(BMS1, data).severity, battery, "BMS1 {raw}");
    }
}

#[test]
fn bus_r072_the_battery_s_codes_have_their_texts_from_vcu7() {
    let mut ride = started();
    ride.hear(VCU7, [3, 20, 0, 0, 0, 0, 0, 0]);
    ride.run(1_000);
    let line = ride.view().line.expect("two lines in turn");
    assert_eq!((line.text.zh, line.code, line.severity), ("高压互锁故障", Some(20), Severity::Stop));
}

#[test]
fn bus_55_the_number_is_shown_without_a_level_and_without_a_sound() {
    let mut ride = started();
    let line = ride.hear(VCU7, [0, 20, 0, 0, 0, 0, 0, 0]).line.expect("the code");
    assert_eq!((line.code, line.severity), (Some(20), Severity::None));
    assert_eq!(ride.cluster.chime(ride.last()), None);
}

#[test]
fn bus_67_high_voltage_off_is_asked_for_by_exactly_11() {
    for (bits, asked) in [(0b00, false), (0b01, false), (0b10, false), (0b11, true)] {
        let mut ride = started();
        let mut data = PACK;
        data[6] = bits << 3;
        let line = ride.hear(BMS1, data).line;
        assert_eq!(line.is_some_and(|line| line.text.en.contains("HV off")), asked, "{bits:02b}");
    }
}

/// The battery's and the vehicle controller's report of one code, each 0 to 3 = none to stop.
#[derive(Clone, Copy)]
struct Routes {
    battery: u8,
    vehicle: u8,
}

/// BMS1 and BMS5, or VCU7, with code 6 (cell too hot).
impl Routes {
    const CODE: u8 = 6;

    fn by_battery(self, ride: &mut Drive) {
        let mut data = PACK;
        // BMS1 counts down (BUS-34): raw 1 is level 3.
        data[6] |= [0, 3, 2, 1][usize::from(self.battery)];
        ride.hear(BMS5, [if self.battery > 0 { Self::CODE } else { 0 }, 1, 0, 0, 0xAA, 0, 1, 0xFF]);
        ride.hear(BMS1, data);
    }

    fn by_vehicle(self, ride: &mut Drive, code: u8) {
        ride.hear(VCU7, [self.vehicle, code, 0, 0xFF, 0, 0xFF, 0xFF, 0xFF]);
    }

    /// What is told of the code.
    fn told(ride: &Drive) -> Vec<Severity> {
        let code = |fault: &ActiveFault| fault.code == Some(Self::CODE.into());
        ride.cluster.active_faults(ride.last()).filter(code).map(|fault| fault.severity).collect()
    }
}

pub(super) const fn sound_of(severity: Severity) -> Option<Sound> {
    match severity {
        Severity::None => None,
        Severity::Warn => Some(Sound::Warn),
        Severity::Derate => Some(Sound::Derate),
        Severity::Stop => Some(Sound::Stop),
    }
}

#[test]
fn bus_77_of_one_code_by_two_routes_the_worse_is_told_once_and_each_route_takes_back_only_its_own() {
    let severity = |raw: u8| Severity::from_model(raw.into());
    let all = (1..=3).flat_map(|battery| (0..=3).map(move |vehicle| Routes { battery, vehicle }));
    for routes in all {
        let Routes { battery, vehicle } = routes;
        let worse = severity(battery.max(vehicle));
        for case in 0..8 {
            let [battery_first, acknowledged, battery_leaves] = [1, 2, 4].map(|bit| case & bit != 0);
            let what = format!("battery {battery}, vehicle {vehicle}, case {case}");
            let mut ride = started();
            let sound = |ride: &Drive| ride.cluster.chime(ride.last()).map(|chime| chime.sound);
            if battery_first {
                routes.by_battery(&mut ride);
                routes.by_vehicle(&mut ride, Routes::CODE);
            } else {
                routes.by_vehicle(&mut ride, Routes::CODE);
                routes.by_battery(&mut ride);
            }
            let view = ride.view();
            assert_eq!(Routes::told(&ride), [worse], "{what}");
            assert_eq!((view.severity, view.line.map(|line| line.severity)), (worse, Some(worse)), "{what}");
            assert_eq!(sound(&ride), sound_of(worse), "{what}");
            let noted = ride.cluster.history().filter(|entry| entry.code == Some(Routes::CODE.into()));
            let noted: Vec<_> = noted.map(|entry| (entry.severity, entry.count)).collect();
            assert_eq!(noted, [(worse, 1)], "{what}");
            if acknowledged {
                ride.cluster.press(Button::Next, ride.now);
                ride.run(10);
                assert_eq!(sound(&ride), None, "{what}");
            }
            let left = if battery_leaves {
                Routes { battery: 0, vehicle }.by_battery(&mut ride);
                severity(vehicle)
            } else {
                Routes { battery, vehicle: 0 }.by_vehicle(&mut ride, 0);
                severity(battery)
            };
            assert_eq!(Routes::told(&ride), [left], "{what}: what the other route says holds");
            assert_eq!(ride.view().severity, left, "{what}");
            let heard = if acknowledged { None } else { sound_of(left) };
            assert_eq!(sound(&ride), heard, "{what}: milder than what was acknowledged");
        }
    }
}

#[test]
fn bus_77_what_the_driver_has_acknowledged_sounds_again_only_if_the_other_route_says_worse() {
    for vehicle in 1..=3 {
        for battery in 1..=3 {
            let routes = Routes { battery, vehicle };
            let mut ride = started();
            routes.by_vehicle(&mut ride, Routes::CODE);
            ride.cluster.press(Button::Next, ride.now);
            routes.by_battery(&mut ride);
            let sound = ride.cluster.chime(ride.last()).map(|chime| chime.sound);
            let worse = (battery > vehicle).then(|| Severity::from_model(battery.into()));
            assert_eq!(sound, worse.and_then(sound_of), "battery {battery} after vehicle {vehicle}");
        }
    }
}

#[test]
fn bus_67_bus_r065_what_nobody_defined_neither_withdraws_a_request_nor_starts_its_clock_anew() {
    // Bits 4 and 3 of byte 7.
    let asked = |request: u8| {
        let mut data = PACK;
        data[6] = request << 3;
        data
    };
    for undefined in [0b00, 0b01] {
        let mut ride = started();
        assert_eq!(ride.hear(BMS1, asked(undefined)).hv_off_s, None, "{undefined:02b} asks for nothing");
        assert_eq!(ride.hear(BMS1, asked(0b11)).hv_off_s, Some(35));
        for _ in 0..20 {
            ride.run(490);
            let view = ride.hear(BMS1, asked(undefined));
            assert_eq!(view.line.map(|line| line.named.fault), Some(FaultId::HvOff), "{undefined:02b}");
            assert_eq!(view.severity, Severity::Stop);
        }
        assert_eq!(ride.hear(BMS1, asked(0b11)).hv_off_s, Some(25), "the battery's clock has run on");
        assert_eq!(ride.hear(BMS1, asked(0b10)).hv_off_s, None, "only 10 withdraws");
    }
}

#[test]
fn bus_34_x_01_an_undefined_level_of_the_battery_neither_clears_nor_softens_what_it_said_before() {
    // Bits 2 to 0 of byte 7: raw 1, 2, 3 = level 3, 2, 1; 4 to 7 are not defined. Nothing is asked for.
    let level = |raw: u8| [0, 0, 0, 0, 0, 0, 0b10 << 3 | raw, 0];
    for raw in 1..=3 {
        for undefined in 4..=7 {
            let mut ride = started();
            let before = ride.hear(BMS1, level(raw));
            assert!(before.severity > Severity::None, "raw {raw}");
            for _ in 0..3 {
                ride.run(490);
                let after = ride.hear(BMS1, level(undefined));
                assert_eq!(after.severity, before.severity, "raw {raw}, then {undefined}");
                assert!(after.telltales.is_lit(Telltale::BatteryFault));
            }
            assert_eq!(ride.hear(BMS1, level(0)).severity, Severity::None, "a defined normal clears");
        }
    }
}

#[test]
fn bus_116_code_24_is_fire_by_vcu7_and_by_bms5() {
    for (id, data) in [(VCU7, [0, 24, 0, 0, 0, 0, 0, 0]), (BMS5, [24, 0, 0, 0, 0, 0, 1, 0])] {
        let mut ride = started();
        let view = ride.hear(id, data);
        assert_eq!(view.line.map(|line| line.text.zh), Some("火灾报警 立即停车疏散"));
        assert_eq!(view.severity, Severity::Stop);
        assert_eq!(ride.cluster.chime(ride.last()).map(|chime| chime.sound), Some(Sound::Fire));
    }
    // The high byte belongs to the code (BUS-54).
    assert_eq!(started().hear(VCU7, [0, 24, 1, 0, 0, 0, 0, 0]).severity, Severity::None);
}

#[test]
fn component_states_have_their_texts() {
    // BUS-R059, BUS-R119, BUS-R123, BUS-R125: status 5, then status 10 in bits 5 and 4 of BYTE8.
    let rows = [
        (IPU3, [5, 7, 0, 0, 0, 0, 0, 0], "电机控制器系统故障", 7),
        (STEERING, [0, 0, 0, 0, 0, 0, 1, 0x24], "助力系统故障", 4),
        (DCDC, [0, 0, 0, 0, 0, 0, 1, 0x28], "DCDC 系统故障", 8),
        (AIR, [0, 0, 0, 0, 0, 0, 1, 0x2A], "空压机系统故障", 10),
    ];
    for (id, data, zh, code) in rows {
        let line = started().hear(id, data).line.expect("a component has failed");
        assert_eq!((line.text.zh, line.code), (zh, Some(code)));
    }
    for status in [0, 1, 2, 3, 4] {
        assert_eq!(started().hear(IPU3, [status, 7, 0, 0, 0, 0, 0, 0]).line, None, "BUS-66, status {status}");
    }
}

#[test]
fn bus_100_the_insulation_monitor_s_levels_light_its_lamp() {
    // BYTE1 bits 2 to 0: 0 normal, 1 level 1, 2 level 2; BYTE6 is the code (BUS-R143).
    let levels = [(0, None, Severity::None), (1, Some(77), Severity::Warn), (2, Some(77), Severity::Stop)];
    for (level, code, severity) in levels {
        let mut ride = started();
        ride.run(3_000);
        let view = ride.hear(0x18F7_46E5, [level, 0, 0, 0, 0, 77, 0, 1]);
        assert_eq!(view.telltales.is_lit(Telltale::Insulation), level > 0);
        assert_eq!((view.line.and_then(|line| line.code), view.severity), (code, severity));
    }
}

#[test]
fn bus_69_the_check_state_alone_is_no_alarm() {
    let mut data = PACK;
    data[6] |= 0b100 << 5;
    let mut ride = started();
    ride.run(3_000);
    let view = ride.hear(BMS1, data);
    assert_eq!((view.line, view.telltales.bits()), (None, 0));
}

#[test]
fn bus_r127_and_bus_94_meter1_says_what_the_wires_say() {
    let mut ride = started();
    ride.inputs = Inputs {
        key: Some(Key::On),
        contacts: Contacts::closed([
            Value::BodySeatEmpty,
            Value::BodyParkingBrake,
            Value::BodyDoorFront,
            Value::BodyTurnLeft,
            Value::BodyLowBeam,
            Value::BodySideLamp,
        ]),
        supply_decivolts: Some(246),
        air_front_centimpa: Some(80),
        air_rear_centimpa: None,
        ..Inputs::default()
    };
    let first = sent(&mut ride, METER1);
    // 24.6 V at 0.2 V; key ON = 01, parking brake, entry door; 0.80 MPa, no sensor; left turn and dipped beam; side
    // lamps.
    assert_eq!(first[..6], [123, 0b0101_0100, 80, 0xFF, 0b0001_0001, 0b0000_0001]);
    let second = sent(&mut ride, METER1);
    assert_eq!(second[7], first[7].wrapping_add(1), "the heartbeat");
}

#[test]
fn bus_r129_meter1_tells_that_the_driver_has_left_in_its_next_frame() {
    let mut ride = started();
    ride.inputs.contacts.set(Value::BodySeatEmpty, true);
    let mut seen = Vec::new();
    for life in 0..=200 {
        let gear = if life < 50 { 0b0100 } else { 0b0001 };
        ride.hear(VCU1, [gear << 2, 0, 0, 0, 0, 0xFF, 0, life]);
        while let Some(frame) = ride.cluster.transmit(ride.now) {
            if frame.id == CanId::extended(METER1) {
                seen.push(frame.padded()[6]);
            }
        }
    }
    assert_eq!(seen, [0, 1, 1], "N at the first, D from half a second on");
}

#[test]
fn bus_97_meter2_holds_the_distance_low_byte_first() {
    let mut ride = started();
    ride.cluster.restore(0x0403_0201);
    assert_eq!(sent(&mut ride, METER2)[..4], [1, 2, 3, 4]);
}

#[test]
fn bus_05_an_unlisted_battery_frame_is_tolerated() {
    let mut ride = started();
    let frame = CanFrame::full(CanId::extended(0x18F1_3FF3), [0x55; 8]);
    assert_eq!(ride.cluster.receive(&frame, ride.now), Received::Unknown);
    assert!(Value::ALL.iter().all(|value| {
        let local = ["body.", "cluster.", "air.", "supply."];
        let own = local.iter().any(|prefix| value.path().starts_with(prefix));
        own || ride.cluster.shown(*value, ride.now) == Shown::Never
    }));
}

/// The frames of the capture and their times in milliseconds.
fn city() -> Vec<(u64, CanFrame)> {
    let log = include_str!("../../../../vehicles/citybus/captures/city.log");
    let frames = log.lines().map(|line| {
        let (time, rest) = line.split_once(") can0 ").expect("candump -L");
        let (id, data) = rest.split_once('#').expect("candump -L");
        let seconds: f64 = time[1..].parse().expect("a time");
        let bytes: Vec<u8> = (0..data.len() / 2)
            .map(|n| u8::from_str_radix(&data[2 * n..2 * n + 2], 16).expect("hex"))
            .collect();
        let id = CanId::extended(u32::from_str_radix(id, 16).expect("hex"));
        (
            ((seconds - 1_767_225_600.0) * 1_000.0) as u64,
            CanFrame::from_slice(id, &bytes).expect("at most 8 bytes"),
        )
    });
    frames.collect()
}

/// Plays the capture and returns the cluster and every view, one per tick.
fn play_city() -> (Cluster, Vec<View>) {
    let mut cluster = Cluster::new(&VEHICLE);
    let frames = city();
    let mut rest = frames.iter().peekable();
    let mut views = Vec::new();
    for now in (0..60_000).step_by(10).map(Millis) {
        while let Some((at, frame)) = rest.next_if(|(at, _)| *at <= now.0) {
            cluster.receive(frame, Millis(*at));
        }
        cluster.tick(&Inputs::default(), now);
        views.push(cluster.view(now));
    }
    for (at, frame) in rest {
        cluster.receive(frame, Millis(*at));
    }
    (cluster, views)
}

#[test]
fn a_minute_of_city_driving_is_understood() {
    let (cluster, views) = play_city();
    let counters = cluster.counters();
    // BMS9 and BMS11, one a second each, carry nothing that the cluster shows.
    assert_eq!((counters.stored, counters.unknown, counters.too_short), (6_500, 120, 0));
    let last = cluster.view(Millis(59_980));
    // 0CF101A7#870089302DFF80D6: D, 0x3089 / 256 km/h, READY.
    assert_eq!((last.gear, last.speed_kmh), (Some(Gear::D), Shown::Value(48)));
    assert!(last.telltales.is_lit(Telltale::Ready));
    assert!(last.odometer_hectometres > 0);

    // Nothing is missing after the first second, and no node is ever missed.
    for view in &views[100..] {
        assert!(view.speed_kmh.value().is_some() && view.soc_percent.value().is_some());
        assert!(view.pack_decivolts.value().is_some() && view.motor_rpm.value().is_some());
    }
    assert!(views[300..].iter().all(|view| !view.telltales.is_lit(Telltale::NoCommunication)));
}

#[test]
fn the_fault_of_the_capture_is_shown_while_it_lasts() {
    let (_, views) = play_city();
    let seconds: Vec<u64> =
        (0..60).filter(|&second| views[second as usize * 100 + 99].line.is_some()).collect();
    // VCU7 reports level 1, code 104 from second 38 on, for eight frames.
    assert_eq!(seconds, (38..46).collect::<Vec<_>>());
    let mut lines: Vec<_> =
        views.iter().filter_map(|view| view.line).map(|line| (line.text.en, line.code)).collect();
    lines.sort();
    lines.dedup();
    assert_eq!(lines, [("Cell voltages uneven", Some(104)), ("System fault level 1", None)]);
}

#[test]
fn playing_a_capture_twice_gives_the_same() {
    let ((_, first), (_, second)) = (play_city(), play_city());
    assert!(first == second);
}

#[test]
fn the_odometer_of_the_capture_is_the_sum_of_its_speeds() {
    let (cluster, views) = play_city();
    // Whole km/h, so the sum is short by at most 1 km/h for a minute: 17 m, less than 0.2 km / 10.
    let metres: u64 = views
        .iter()
        .filter_map(|view| view.speed_kmh.value())
        .map(|kmh| u64::from(kmh) * 10 * 10)
        .sum::<u64>()
        / 36_000;
    let shown = u64::from(cluster.view(Millis(60_000)).odometer_hectometres);
    assert!((metres / 100..=(metres + 17) / 100).contains(&shown), "{metres} m, {shown} hm");
}
