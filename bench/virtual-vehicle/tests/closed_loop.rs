//! The loop is closed by frames: what was not sent is not known, what anybody sends acts.
//!
//! Frames are decoded here by hand from the documents, not by the project's codecs.

mod ride;

use protocol_core::frame::CanId;
use ride::Ride;
use std::collections::BTreeSet;
use virtual_vehicle::{Cycles, Kind, Options, VirtualVehicle};

const fn id(bits: u32) -> CanId {
    CanId::extended(bits)
}

const VCU1: CanId = id(0x0CF1_01A7);
const VCU2: CanId = id(0x0CF1_02A7);
const VCU3: CanId = id(0x0CF1_03A7);
const VCU5: CanId = id(0x0C3C_514A);
const VCU7: CanId = id(0x0CF1_064A);
const BMS1: CanId = id(0x18F1_3DF3);
const BMS4: CanId = id(0x18F1_40F3);
const BMS5: CanId = id(0x18F1_41F3);
const BMS12: CanId = id(0x18F1_48F3);
const INSULATION: CanId = id(0x18F7_46E5);
const METER1: CanId = id(0x18F4_3A17);
const CHARGER_TX: CanId = id(0x18F1_F399);
const CHARGER_RX: CanId = id(0x18F1_99F3);

/// Bit of a byte, both as the documents count them: bytes from 1, bits from 0.
fn bit(data: [u8; 8], byte: usize, bit: u8) -> bool {
    data[byte - 1] >> bit & 1 == 1
}

/// Level and code of VCU7.
fn told(ride: &Ride) -> (u8, u16) {
    let data = ride.frame(VCU7);
    (data[0] & 7, u16::from(data[1]) | u16::from(data[2]) << 8)
}

fn started(settings: &[(&str, &str)]) -> Ride {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("driver.key", "start").seconds(4);
    for (path, value) in settings {
        ride.set(path, value);
    }
    ride
}

// --- what is not sent is not known

#[test]
fn a_motor_that_hears_no_command_gives_no_torque() {
    for silent in ["lost.VCU2", "link.inverter", "link.vcu"] {
        let mut ride = started(&[(silent, "on"), ("driver.gear", "D"), ("driver.accelerator", "100")]);
        ride.watch(5, |ride| assert_eq!(ride.world().motion.metres_per_s, 0.0, "{silent}"));
        let mut ride = Ride::at(Kind::Citybus, "40");
        ride.set(silent, "on").ms(300);
        assert_eq!(ride.world().motor.nm, 0.0, "{silent} while driving");
    }
}

#[test]
fn bus_r076_a_request_in_a_lost_bms1_is_answered_by_nobody_until_the_battery_opens_after_35_s() {
    let mut ride = started(&[("lost.BMS1", "on"), ("battery.hottest", "66")]);
    ride.seconds(34);
    assert!(ride.world().bms.main.closed && ride.frame(VCU3)[1] == 1);
    ride.seconds(2);
    assert!(!ride.world().bms.main.closed && ride.frame(VCU3)[1] == 1, "the command still says close");
}

#[test]
fn bus_r039_contactors_are_forwarded_from_a_heard_bms1_alone() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("lost.BMS1", "on").set("driver.key", "start").seconds(4);
    assert!(ride.world().bms.main.closed && !bit(ride.frame(VCU3), 7, 7));
    ride.set("lost.BMS1", "off").seconds(1);
    assert!(bit(ride.frame(VCU3), 7, 7));
}

#[test]
fn bus_r082_the_limit_that_was_heard_last_is_obeyed() {
    let mut ride = started(&[("lost.BMS4", "on"), ("battery.internal_bus", "on")]);
    ride.seconds(2);
    assert_eq!(ride.world().bms.discharge_limit_amps, 60.0);
    assert_eq!(ride.world().vcu.allowed_watts, 150_000.0, "nobody has told");
    ride.set("lost.BMS4", "off").seconds(1);
    assert!(ride.world().vcu.allowed_watts < 33_000.0);
}

#[test]
fn bus_r080_each_message_that_is_acted_on_is_missed_and_the_others_do_not_stand_in_for_it() {
    for lost in [&["BMS1", "BMS2", "BMS4", "BMS5"][..], &["BMS1"], &["BMS4"], &["BMS5"]] {
        let mut ride = started(&[]);
        for name in lost {
            ride.set(&format!("lost.{name}"), "on");
        }
        ride.seconds(5);
        assert!(ride.world().vcu.limp, "{lost:?}");
    }
    for lost in ["BMS2", "BMS6", "BMS12"] {
        let mut ride = started(&[]);
        ride.set(&format!("lost.{lost}"), "on").seconds(6);
        assert!(!ride.world().vcu.limp, "{lost}");
    }
}

#[test]
fn bus_r080_the_bit_is_on_the_bus_within_5_s_of_the_last_frame_of_the_battery() {
    for seed in 1..=20 {
        let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options { seed, ..Options::default() });
        let (mut last_us, mut told_us) = (0, None);
        for step in 0..1_200 {
            if step == 500 {
                vehicle.set("link.bms", Some(1.0)).unwrap();
            }
            vehicle.advance();
            for sent in vehicle.take_frames() {
                match sent.frame.id {
                    BMS1 | BMS4 | BMS5 => last_us = sent.at_us,
                    VCU1 if told_us.is_none() && bit(*sent.frame.padded(), 7, 6) => {
                        told_us = Some(sent.at_us);
                    }
                    _ => {}
                }
            }
        }
        let ms = (told_us.expect("it is told") - last_us) / 1_000;
        assert!((4_400..=5_000).contains(&ms), "seed {seed}: {ms} ms");
    }
}

#[test]
fn bus_r115_what_is_addressed_to_the_battery_is_missed_though_the_controller_speaks_to_others() {
    for lost in [&["VCU3"][..], &["VCU3", "VCU7"]] {
        let mut ride = started(&[]);
        for name in lost {
            ride.set(&format!("lost.{name}"), "on");
        }
        ride.seconds(4);
        assert_ne!(ride.frame(BMS5)[0], 70);
        ride.seconds(2);
        assert_eq!(ride.frame(BMS5)[0], 70, "{lost:?}");
    }
}

#[test]
fn bus_r021_a_life_counter_that_stands_still_is_silence_for_the_other_nodes() {
    let mut ride = started(&[("frozen.vcu", "on")]);
    ride.seconds(6);
    assert_eq!(ride.frame(BMS5)[0], 70, "VCU3 stands still");
    let mut ride = started(&[("frozen.bms", "on")]);
    ride.seconds(6);
    assert!(ride.world().vcu.limp, "BMS5 stands still");
    let mut ride = started(&[("frozen.inverter", "on")]);
    ride.seconds(2);
    assert!(!ride.world().vcu.ready && bit(ride.frame(VCU1), 7, 6), "IPU1 stands still");
}

#[test]
fn c5_r001_the_main_contactor_closes_after_0xaa_and_not_before() {
    let mut ride = Ride::new(Kind::C5ev);
    ride.set("lost.VCUToBMS", "on").set("driver.key", "start");
    ride.watch(6, |ride| assert!(!ride.world().bms.main.driven));
    ride.set("lost.VCUToBMS", "off").seconds(3);
    assert_eq!(ride.frame(id(0x1807_F427))[0], 0xAA);
    assert!(ride.world().bms.main.closed);
}

#[test]
fn a_command_from_before_the_power_off_does_not_act_after_it() {
    for kind in Kind::ALL {
        let mut ride = Ride::ready(kind);
        ride.set("driver.key", "lock").seconds(2).set("driver.key", "on");
        ride.watch(3, |ride| {
            assert!(!ride.world().bms.negative.driven && !ride.world().motor.running, "{kind:?}");
        });
    }
}

#[test]
fn c5_r006_bus_r154_current_flows_after_the_frame_that_allows_it() {
    let cases = [
        (Kind::Citybus, CHARGER_RX, (6, 0, true)),
        // Byte 5 bit 7: 0 charges (C5-R011).
        (Kind::C5ev, protocol_core::generated::c5ev::id::CHARGER_CONTROL, (5, 7, false)),
    ];
    for (kind, control, (byte, place, allows)) in cases {
        let mut ride = Ride::with(kind, Options { optional: true, ..Options::default() });
        ride.set("battery.soc", "50").set("charge.plug", "on");
        let mut allowed = false;
        ride.watch(6, |ride| {
            assert!(allowed || ride.world().charger.amps == 0.0, "{kind:?}");
            allowed |= ride.fresh(control).is_some_and(|data| bit(data, byte, place) == allows);
        });
        assert!(allowed && ride.world().charger.amps > 0.0, "{kind:?}");
    }
}

#[test]
fn bus_r065_the_three_seconds_of_the_answer_begin_with_the_frame_of_the_request() {
    for seed in 1..=10 {
        let mut ride = Ride::with(Kind::Citybus, Options { seed, ..Options::default() });
        ride.set("driver.key", "start").seconds(4).set("battery.hottest", "66");
        let asked = |ride: &Ride| ride.fresh(BMS1).is_some_and(|data| data[6] >> 3 & 3 == 3);
        ride.until("request", 1, asked);
        let answered = ride.until("answer", 5, |ride| ride.fresh(VCU3).is_some_and(|data| data[1] == 0));
        assert!((2_990..=3_200).contains(&answered), "seed {seed}: {answered} ms");
    }
}

// --- what anybody sends acts

#[test]
fn over_a_bus_the_nodes_hear_what_the_bus_brings_back_and_nothing_else() {
    for brings in [true, false] {
        let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
        vehicle.over_a_bus();
        vehicle.set("driver.key", Some(3.0)).unwrap();
        for _ in 0..800 {
            vehicle.advance();
            for sent in vehicle.take_frames().into_iter().filter(|_| brings) {
                vehicle.receive(&sent.frame);
            }
        }
        let world = vehicle.world();
        assert_eq!((world.vcu.ready, world.bms.main.closed, world.vcu.limp), (brings, brings, !brings));
    }
}

#[test]
fn a_limit_that_a_foreign_tool_sends_is_obeyed() {
    let mut ride = started(&[("lost.BMS4", "on")]);
    // 0 A of charge and 50 A of discharge: raw (50 + 1000) / 0.1.
    ride.hear(BMS4, [0x10, 0x27, 0x04, 0x29, 95, 20, 25, 0xFF]);
    ride.ms(30);
    let watts = ride.world().vcu.allowed_watts;
    assert!((20_000.0..30_000.0).contains(&watts), "{watts} W of 50 A");
    assert_eq!(ride.world().vcu.allowed_regeneration_watts, 0.0);
}

#[test]
fn a_torque_that_a_foreign_tool_sends_moves_the_bus() {
    let mut ride = started(&[("lost.VCU2", "on")]);
    for _ in 0..100 {
        // 500 Nm: raw (500 + 3000) / 0.1; enabled, torque mode.
        ride.hear(VCU2, [0xB8, 0x88, 0x01, 0x02, 0xFF, 0xFF, 0xFF, 0xFF]);
        ride.ms(20);
    }
    assert!(ride.world().motion.metres_per_s > 0.3 && ride.world().motor.nm > 499.0);
}

/// Meter1: key 0 LOCK, 1 ON, 2 ACC, 3 START in byte 2 bits 7-6, parking brake bit 4, entry door bit 2; life in byte 8.
fn say(ride: &mut Ride, key: u8, more: u8) {
    let life = (ride.world().now_ms / 10) as u8;
    ride.hear(METER1, [120, key << 6 | more, 75, 75, 0, 0, 0, life]);
}

#[test]
fn bus_r041_v_3_the_key_of_the_cluster_starts_and_switches_off() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.seconds(1);
    say(&mut ride, 3, 0);
    ride.seconds(3);
    assert!(ride.world().vcu.ready, "START by the cluster");
    say(&mut ride, 0, 0);
    ride.seconds(1);
    assert!(!ride.world().vcu.ready && !ride.world().bms.main.closed, "LOCK by the cluster");
    // A cluster that falls silent no longer counts.
    ride.seconds(3).set("driver.key", "start").seconds(4);
    assert!(ride.world().vcu.ready, "and without a cluster the wire does");
}

#[test]
fn v_3_a_bus_with_an_open_door_or_its_parking_brake_on_stands() {
    for more in [0b100, 0b1_0000] {
        let mut ride = started(&[("driver.gear", "D"), ("driver.accelerator", "40")]);
        ride.set("driver.accelerator", "0").set("driver.brake", "50").seconds(5);
        ride.set("driver.brake", "0").set("driver.accelerator", "40");
        for _ in 0..3 {
            say(&mut ride, 1, more);
            ride.seconds(1);
        }
        assert_eq!(ride.world().motion.metres_per_s, 0.0, "{more:#b}");
        assert_eq!(bit(ride.frame(VCU1), 1, 6), more == 0b1_0000, "parking brake in VCU1");
        say(&mut ride, 1, 0);
        ride.seconds(1);
        assert!(ride.world().motion.metres_per_s > 0.0);
    }
}

// --- the battery's codes go on

#[test]
fn bus_r072_bus_r026_to_r028_codes_of_both_take_turns_of_a_second_and_the_worst_level_stands_alone() {
    let seen = |ride: &mut Ride, seconds: u64| {
        let mut seen = BTreeSet::new();
        ride.watch(seconds, |ride| seen.extend([told(ride)]));
        seen
    };
    let mut ride = started(&[("battery.internal_bus", "on"), ("battery.current_sensor", "on")]);
    ride.seconds(4);
    assert_eq!(seen(&mut ride, 8), BTreeSet::from([(2, 63), (2, 64)]));
    ride.set("vcu.fault_level_2", "700").set("vcu.fault_level_1", "500").seconds(4);
    assert_eq!(seen(&mut ride, 10), BTreeSet::from([(2, 63), (2, 64), (2, 700)]));
    ride.set("battery.interlock", "on").seconds(3);
    assert_eq!(seen(&mut ride, 6), BTreeSet::from([(3, 20)]));
    ride.set("battery.interlock", "off").set("battery.current_sensor", "off").seconds(6);
    assert_eq!(seen(&mut ride, 8), BTreeSet::from([(2, 63), (2, 700)]));
    ride.set("battery.internal_bus", "off").set("vcu.fault_level_2", "0").seconds(4);
    assert_eq!(seen(&mut ride, 4), BTreeSet::from([(1, 500)]));
    ride.set("vcu.fault_level_1", "0").seconds(2);
    assert_eq!(told(&ride), (0, 0));
}

#[test]
fn bus_18_both_printed_cycles_of_every_message_can_be_sent_and_bus_33_a_code_is_held_for_ten_frames() {
    let count = |cycles: Cycles, id: CanId| {
        let mut ride = Ride::with(Kind::Citybus, Options { cycles, ..Options::default() });
        ride.seconds(1);
        let mut count = 0;
        ride.watch(30, |ride| count += usize::from(ride.fresh(id).is_some()));
        count
    };
    for (id, page, overview) in [(VCU7, 30, 300), (BMS12, 10, 60), (INSULATION, 30, 10), (BMS1, 60, 60)] {
        assert!(count(Cycles::Page, id).abs_diff(page) <= 1, "{id:?}");
        assert!(count(Cycles::Overview, id).abs_diff(overview) <= 1, "{id:?}");
    }
    let mut ride = Ride::with(Kind::Citybus, Options { cycles: Cycles::Overview, ..Options::default() });
    ride.set("vcu.fault_level_1", "1").set("vcu.fault_level_1b", "2").seconds(2);
    let mut codes = Vec::new();
    ride.watch(8, |ride| codes.extend(ride.fresh(VCU7).map(|data| data[1])));
    let runs: Vec<usize> = codes.chunk_by(|a, b| a == b).map(<[u8]>::len).collect();
    assert!(runs[1..runs.len() - 1].iter().all(|run| (9..=11).contains(run)), "{runs:?}");
}

// --- judged by what was sent

#[test]
fn bus_r102_a_current_over_the_limit_that_was_told_is_a_fault_and_clears_below_it() {
    let mut ride = started(&[("battery.soc", "15")]);
    ride.seconds(2);
    let data = ride.frame(BMS4);
    let limit = f64::from(u16::from(data[2]) | u16::from(data[3]) << 8) / 10.0 - 1_000.0;
    assert_eq!(limit, 200.0, "code 108 leaves half");
    let codes = |ride: &mut Ride, amps: &str| {
        ride.set("battery.amps", amps).seconds(2);
        let mut codes = BTreeSet::new();
        ride.watch(4, |ride| codes.extend([ride.frame(BMS5)[0]]));
        codes
    };
    assert_eq!(codes(&mut ride, "209"), BTreeSet::from([108]));
    assert_eq!(codes(&mut ride, "212"), BTreeSet::from([108, 110]));
    assert_eq!(codes(&mut ride, "201"), BTreeSet::from([108, 110]), "not below 100 %");
    assert_eq!(codes(&mut ride, "199"), BTreeSet::from([108]));
}

#[test]
fn bus_r102_a_limit_that_falls_is_no_fault_of_a_vehicle_that_follows_it() {
    let mut ride = Ride::at(Kind::Citybus, "75");
    ride.set("driver.target", "auto").set("driver.accelerator", "100").set("road.slope", "8").seconds(3);
    assert!(ride.world().pack.amps > 220.0, "{}", ride.world().pack.amps);
    ride.set("battery.soc", "19").watch(10, |ride| {
        assert!(ride.world().bms.active.iter().all(|fault| fault.code != 110), "at {}", ride.world().now_ms);
    });
    assert!(ride.world().pack.amps <= 200.0);
}

#[test]
fn v_7_what_converter_and_pumps_take_at_a_limit_of_0_is_no_current_over_the_limit() {
    for kind in [Kind::Citybus, Kind::C5ev] {
        let mut ride = Ride::ready(kind);
        ride.seconds(2).set("battery.interlock", "on");
        ride.watch(6, |ride| {
            let faults = &ride.world().bms.active;
            assert!(ride.world().now_ms < 4_000 || ride.world().pack.amps > 0.5, "they run");
            assert!(faults.len() <= 1, "{kind:?}: {faults:?}");
        });
    }
}

#[test]
fn bus_50_the_air_conditioning_decides_on_the_numbers_of_vcu5() {
    // Byte 5 in V; byte 6 and 7 high byte first, 0.4 %.
    let runs = |volts: &str, soc: &str| {
        let mut ride = Ride::ready(Kind::Citybus);
        ride.set("supply.volts", volts).set("battery.soc", soc).set("hvac.cabin", "40");
        ride.set("driver.air_conditioning", "on").seconds(9);
        let data = ride.frame(VCU5);
        let raw = u16::from(data[5]) << 8 | u16::from(data[6]);
        let hvac = ride.world().hvac;
        assert_eq!(hvac.on, data[4] >= 25 && raw >= 50, "{volts} V, {soc} %: {data:02X?}");
        assert_eq!(hvac.cooling, hvac.on && raw > 75, "{volts} V, {soc} %: {data:02X?}");
    };
    for volts in ["24.4", "24.5", "24.6", "25.0"] {
        runs(volts, "80");
    }
    for soc in ["19.7", "19.85", "19.9", "20.3", "29.9", "30.15", "30.3", "30.5"] {
        runs("27", soc);
    }
}

#[test]
fn bus_r046_v_10_below_30_percent_the_derate_is_sent_with_the_air_conditioning_off_too() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("battery.soc", "25").seconds(1);
    assert!(bit(ride.frame(VCU5), 1, 5) && !bit(ride.frame(VCU5), 1, 6));
}

#[test]
fn bus_r022_bus_r112_ready_is_where_torque_may_be_sent() {
    let parked: [&[(&str, &str)]; 2] =
        [&[("battery.interlock", "on")], &[("battery.highest_cell", "2.7"), ("battery.lowest_cell", "2.35")]];
    for settings in parked {
        let mut ride = Ride::new(Kind::Citybus);
        for (path, value) in settings {
            ride.set(path, value);
        }
        ride.seconds(1).set("driver.key", "start").seconds(5).set("driver.gear", "D").seconds(1);
        assert!(!bit(ride.frame(VCU1), 7, 7), "{settings:?}");
        assert_eq!(ride.frame(VCU1)[0] >> 2 & 0xF, 4, "the gear is N");
    }
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("battery.interlock", "on").seconds(1).set("driver.key", "start");
    ride.watch(5, |ride| assert!(!ride.world().bms.main.driven, "an open loop is not closed onto"));
    ride.set("battery.interlock", "off").seconds(4);
    assert!(ride.world().vcu.ready);
}

#[test]
fn bus_69_bus_r023_v_9_a_fault_of_level_1_is_a_fault() {
    let mut ride = started(&[]);
    ride.seconds(1);
    assert_eq!((ride.frame(BMS1)[6] >> 5, bit(ride.frame(VCU1), 7, 6)), (0b010, false));
    ride.set("battery.soc", "15").seconds(2);
    assert_eq!(ride.frame(BMS1)[6] & 7, 3, "level 1");
    assert_eq!((ride.frame(BMS1)[6] >> 5, bit(ride.frame(VCU1), 7, 6)), (0b100, true));
}

#[test]
fn bus_r144_v_11_the_insulation_monitor_judges_by_the_present_voltage() {
    let mut ride = started(&[]);
    for (volts, kiloohm, level) in [
        ("400", "200.4", 0),
        ("400", "199.6", 1),
        ("700", "350.7", 0),
        ("700", "349.3", 1),
        ("700", "69.3", 2),
    ] {
        ride.set("battery.volts", volts).set("insulation.kiloohm", kiloohm).seconds(2);
        assert_eq!(ride.frame(INSULATION)[0] & 7, level, "{kiloohm} kohm at {volts} V");
    }
}

#[test]
fn v_12_a_negative_contactor_that_does_not_close_is_told_as_long_as_it_is_wanted() {
    let bmsd = protocol_core::generated::c5ev::id::BMSD;
    let mut ride = Ride::new(Kind::C5ev);
    ride.set("battery.negative_stuck", "on").set("driver.key", "start").seconds(2);
    ride.watch(10, |ride| assert!(bit(ride.frame(bmsd), 4, 7), "BYTE4 bit 7"));
    ride.set("driver.key", "lock").seconds(1);
    ride.set("battery.negative_stuck", "off").set("driver.key", "start").seconds(3);
    assert!(!bit(ride.frame(bmsd), 4, 7) && ride.world().bms.main.closed);
}

// --- signs and hysteresis

#[test]
fn bus_r082_what_the_accessories_eat_does_not_reach_the_battery_which_is_charged_up_to_its_limit() {
    for on in ["off", "on"] {
        let mut ride = Ride::at(Kind::Citybus, "60");
        ride.set("driver.air_conditioning", on).set("hvac.cabin", "45").set("road.celsius", "45").seconds(12);
        // 1 degree leaves a tenth of 200 A.
        ride.set("battery.hottest", "15").set("battery.coldest", "1").seconds(1);
        ride.set("driver.target", "auto").set("driver.accelerator", "0").set("driver.brake", "40").ms(1_500);
        let mut lowest = 0.0f64;
        ride.watch(1, |ride| lowest = lowest.min(ride.world().pack.amps));
        assert!((-20.0..=-18.6).contains(&lowest), "air conditioning {on}: {lowest} A");
    }
}

#[test]
fn the_heater_of_the_battery_runs_below_3_degrees_and_until_8() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("battery.soc", "50").set("battery.coldest", "3.1").set("charge.plug", "on").seconds(6);
    let heats = |ride: &mut Ride, celsius: &str| {
        ride.set("battery.coldest", celsius).seconds(2);
        ride.world().bms.heater.iter().all(|relay| relay.closed)
    };
    let steps = ["3.1", "2.9", "3.1", "7.9", "8.1", "7.9", "3.1", "2.9"];
    let seen = steps.map(|celsius| heats(&mut ride, celsius));
    assert_eq!(seen, [false, true, true, true, false, false, false, true]);
    assert!(ride.has_heard(BMS1) && !ride.has_heard(CHARGER_TX));
}
