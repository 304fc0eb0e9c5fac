//! The vehicle controller's rules, read off the wire where the wire says it.

mod ride;

use protocol_core::generated::{c5ev, citybus, jiulong};
use protocol_core::model::Severity;
use protocol_core::vehicle::Node;
use ride::Ride;
use std::collections::BTreeSet;
use virtual_vehicle::world::Gear;
use virtual_vehicle::{Kind, Options, VirtualVehicle};

fn vcu1(ride: &Ride) -> citybus::Vcu1 {
    citybus::Vcu1(ride.frame(citybus::id::VCU1))
}

fn vcu3(ride: &Ride) -> citybus::Vcu3 {
    citybus::Vcu3(ride.frame(citybus::id::VCU3))
}

fn vcu7(ride: &Ride) -> citybus::Vcu7 {
    citybus::Vcu7(ride.frame(citybus::id::VCU7))
}

fn to_cluster(ride: &Ride) -> c5ev::VcuToCluster {
    c5ev::VcuToCluster(ride.frame(c5ev::id::VCU_TO_CLUSTER))
}

#[test]
fn a_speed_to_hold_is_all_that_a_newcomer_sets() {
    for kind in Kind::ALL {
        let mut ride = Ride::new(kind);
        ride.set("driver.parking_brake", "on").set("driver.target", "50").seconds(60);
        let kmh = ride.read("vehicle.speed");
        assert!((49.0..51.5).contains(&kmh), "{kind:?} drives at {kmh} km/h");
    }
}

#[test]
fn a_gear_and_a_foot_drive_off_with_the_key_on() {
    for kind in Kind::ALL {
        let mut ride = Ride::new(kind);
        ride.set("driver.gear", "D").set("driver.accelerator", "40").seconds(6);
        assert!(ride.read("vehicle.speed") > 5.0, "{kind:?}");
    }
}

#[test]
fn a_key_that_is_turned_off_stays_off_whatever_the_driver_holds() {
    let mut ride = Ride::at(Kind::Citybus, "40");
    ride.set("driver.key", "lock").seconds(60);
    assert_eq!((ride.world().vcu.ready, ride.read("vehicle.speed")), (false, 0.0));
    ride.set("driver.key", "on").seconds(60);
    assert!(ride.read("vehicle.speed") > 39.0, "turned on again, he drives on");
}

#[test]
fn key_on_alone_closes_nothing() {
    for kind in Kind::ALL {
        let mut ride = Ride::new(kind);
        ride.set("driver.accelerator", "100").watch(5, |ride| {
            assert!(!ride.world().vcu.ready && !ride.world().bms.main.driven, "{kind:?}");
        });
    }
}

#[test]
fn ready_follows_precharge_and_comes_within_three_seconds() {
    for kind in Kind::ALL {
        let mut ride = Ride::new(kind);
        ride.set("driver.key", "start");
        let precharged = ride.until("precharge", 5, |ride| ride.world().bms.precharged);
        let closed = precharged + ride.until("main contactor", 1, |ride| ride.world().bms.main.closed);
        let ready = closed + ride.until("READY", 1, |ride| ride.world().vcu.ready);
        assert!(
            0 < precharged && precharged < closed && closed < ready && ready <= 3_000,
            "{kind:?} {ready}"
        );
    }
}

#[test]
fn key_off_takes_ready_and_high_voltage_away() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("driver.key", "lock").ms(200);
    assert!(!ride.world().vcu.ready && !ride.world().bms.main.closed);
    ride.set("driver.key", "on").seconds(3);
    assert!(!ride.world().vcu.ready, "START has to be given anew");
}

#[test]
fn a_plug_keeps_the_vehicle_where_it_is() {
    for kind in Kind::ALL {
        let mut ride = Ride::new(kind);
        ride.set("charge.plug", "on").set("driver.gear", "D").set("driver.accelerator", "100").seconds(10);
        assert_eq!((ride.world().vcu.ready, ride.read("vehicle.distance")), (false, 0.0), "{kind:?}");
    }
}

#[test]
fn bus_r014_without_a_gearbox_only_d_r_and_n_are_sent() {
    let mut ride = Ride::ready(Kind::Citybus);
    let mut seen = BTreeSet::new();
    for (lever, code) in [("D", 1), ("N", 4), ("R", 2), ("N", 4)] {
        ride.set("driver.gear", lever);
        ride.watch(1, |ride| {
            seen.insert(vcu1(ride).gear_raw());
        });
        assert_eq!(vcu1(&ride).gear_raw(), code, "lever at {lever}");
    }
    assert_eq!(seen, BTreeSet::from([1, 2, 4]));
}

#[test]
fn bus_r018_no_special_mode_is_sent_by_a_bus_without_any() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("driver.target", "30");
    ride.watch(30, |ride| {
        let mode = ride.fresh(citybus::id::VCU1).map_or(0, |data| citybus::Vcu1(data).drive_mode_raw());
        assert!(matches!(mode, 0 | 3), "neither snow (1) nor climb (2): {mode}");
    });
}

#[test]
fn bus_r019_a_digital_brake_pedal_is_sent_as_nothing_or_all() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("driver.brake", "40").ms(50);
    assert_eq!(vcu1(&ride).brake_pedal_raw(), 100, "0.4 % a bit");
    ride.set("driver.digital_brake", "on").set("driver.brake", "1").ms(50);
    assert_eq!(vcu1(&ride).brake_pedal_raw(), 250);
    ride.set("driver.brake", "0").ms(50);
    assert_eq!(vcu1(&ride).brake_pedal_raw(), 0);
}

#[test]
fn bus_r026_bus_r027_bus_r029_only_codes_of_the_highest_level_are_sent() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("vcu.fault_level_1", "11").seconds(2);
    assert_eq!((vcu7(&ride).fault_level_raw(), vcu7(&ride).dtc_raw()), (1, 11));
    ride.set("vcu.fault_level_2", "22").seconds(2);
    assert_eq!(
        (vcu7(&ride).fault_level_raw(), vcu7(&ride).dtc_raw()),
        (2, 22),
        "levels 1 and 2 report 2 (BUS-32)"
    );
    ride.set("vcu.fault_level_3", "33").seconds(2);
    assert_eq!((vcu7(&ride).fault_level_raw(), vcu7(&ride).dtc_raw()), (3, 33));
    ride.set("vcu.fault_level_3", "0").set("vcu.fault_level_2", "0").seconds(2);
    assert_eq!((vcu7(&ride).fault_level_raw(), vcu7(&ride).dtc_raw()), (1, 11));
    ride.set("vcu.fault_level_1", "0").seconds(2);
    assert_eq!((vcu7(&ride).fault_level_raw(), vcu7(&ride).dtc_raw()), (0, 0));
}

#[test]
fn bus_r028_codes_of_one_level_take_turns_of_a_second() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("vcu.fault_level_1", "11").set("vcu.fault_level_2", "21").set("vcu.fault_level_2b", "22");
    let mut turns = Vec::new();
    ride.watch(8, |ride| turns.push(ride.world().vcu.code));
    let lengths: Vec<_> = turns.chunk_by(|a, b| a == b).map(|turn| (turn[0], turn.len())).collect();
    assert_eq!(lengths[..4], [(21, 100), (22, 100), (21, 100), (22, 100)]);
    let mut sent = BTreeSet::new();
    ride.watch(8, |ride| {
        sent.extend(ride.fresh(citybus::id::VCU7).map(|data| citybus::Vcu7(data).dtc_raw()));
    });
    assert_eq!(sent, BTreeSet::from([21, 22]));
}

#[test]
fn a_stop_fault_takes_the_torque_and_a_derate_halves_the_power() {
    let mut ride = Ride::at(Kind::Citybus, "40");
    let full = ride.world().vcu.allowed_watts;
    ride.set("vcu.fault_level_2", "20").ms(100);
    assert!((ride.world().vcu.allowed_watts / full - 0.5).abs() < 0.01);
    assert_eq!(vcu1(&ride).power_limited_raw(), 1);
    ride.set("vcu.fault_level_3", "30").ms(100);
    assert_eq!((vcu1(&ride).ready_raw(), ride.world().motor.nm), (0, 0.0));
}

#[test]
fn bus_r030_while_charging_the_vehicle_controller_commands_the_converter() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    vehicle.set("charge.plug", Some(1.0)).unwrap();
    let mut commands = Vec::new();
    for _ in 0..2_000 {
        vehicle.advance();
        let frames = vehicle.take_frames();
        commands.extend(frames.into_iter().filter(|sent| sent.frame.id == citybus::id::VCU6));
    }
    assert!(commands.iter().all(|sent| sent.node == Node::Vcu));
    let last = citybus::Vcu6(*commands.last().expect("VCU6 comes every second").frame.padded());
    assert_eq!(last.command_raw(), 0xAA, "started, for a bus that charges for hours");
    assert!(vehicle.world().dcdc.running && !vehicle.world().vcu.ready);
}

#[test]
fn bus_r035_the_power_limit_is_never_sent_as_0_and_as_255_only_when_there_is_none() {
    let mut ride = Ride::at(Kind::Citybus, "40");
    let limit = |ride: &Ride| citybus::Vcu2(ride.frame(citybus::id::VCU2)).power_limit_raw();
    assert_eq!(limit(&ride), 150);
    ride.set("battery.hottest", "61").seconds(2);
    assert_eq!(ride.world().vcu.allowed_watts, 0.0);
    assert_eq!(limit(&ride), 255);
}

#[test]
fn bus_r036_vcu3_carries_the_link_voltage_through_the_precharge() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("driver.key", "start");
    let mut sent = Vec::new();
    ride.watch(2, |ride| {
        if let Some(data) = ride.fresh(citybus::id::VCU3) {
            let volts = f64::from(citybus::Vcu3(data).mcu_input_voltage_raw()) / 10.0;
            // As the motor controller told it last.
            assert_eq!(Some(volts), ride.world().vcu.link_volts);
            sent.push(volts);
        }
    });
    assert!(
        sent[0] < 50.0 && sent.is_sorted_by(|a, b| a <= &(b + 3.0)) && *sent.last().unwrap() > 500.0,
        "{sent:?}"
    );
}

#[test]
fn bus_r037_byte_6_speaks_only_while_the_pantograph_is_used() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.seconds(2);
    let byte = |ride: &Ride| (vcu3(ride).pantograph_state_raw(), vcu3(ride).charge_enable_raw());
    assert_eq!(byte(&ride), (0, 0));
    ride.set("charge.pantograph", "on").seconds(1);
    assert_eq!(byte(&ride), (1, 0), "rising");
    ride.seconds(5);
    assert_eq!(byte(&ride), (2, 1), "connected, charging enabled");
    ride.set("charge.pantograph", "off").seconds(1);
    assert_eq!(byte(&ride), (0, 0));
}

#[test]
fn the_pantograph_stays_down_while_the_bus_moves() {
    let mut ride = Ride::at(Kind::Citybus, "30");
    ride.set("charge.pantograph", "on").seconds(6);
    assert_eq!(vcu3(&ride).pantograph_state_raw(), 0);
    assert!(ride.read("vehicle.speed") > 29.0);
}

#[test]
fn bus_r038_relays_that_are_not_there_are_sent_as_open() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("driver.target", "30");
    ride.watch(20, |ride| {
        if let Some(data) = ride.fresh(citybus::id::VCU3) {
            let said = citybus::Vcu3(data);
            assert_eq!((said.defrost_relay_raw(), said.accessory_precharge_relay_raw()), (0, 0));
        }
    });
    let relays = vcu3(&ride);
    assert_eq!(
        (relays.motor_relay_raw(), relays.accessory_relay_raw(), relays.precharge_relay_raw()),
        (1, 1, 0)
    );
}

#[test]
fn bus_r039_main_and_charging_relays_are_forwarded_from_the_battery() {
    let relays = |ride: &Ride| (vcu3(ride).battery_relay_raw(), vcu3(ride).charge_relay_raw());
    let mut ride = Ride::new(Kind::Citybus);
    ride.seconds(1);
    assert_eq!(relays(&ride), (0, 0));
    ride.set("battery.charge_2_welded", "on").seconds(1);
    assert_eq!(relays(&ride), (0, 1), "any charging contactor; a welded one conducts (BUS-44)");
    ride.set("battery.charge_2_welded", "off").set("battery.main_welded", "on").seconds(1);
    assert_eq!(relays(&ride), (1, 0));

    let mut ride = Ride::new(Kind::Citybus);
    ride.set("charge.plug", "on").seconds(10);
    assert_eq!(vcu3(&ride).charge_relay_raw(), 1, "charge circuit 1 is closed");
}

#[test]
fn bus_r041_steering_is_enabled_by_start_whatever_the_parking_brake_does() {
    let runs = |ride: &Ride| citybus::Vcu4(ride.frame(citybus::id::VCU4)).run_raw();
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("driver.parking_brake", "on").seconds(3);
    assert_eq!(runs(&ride), 0, "no START yet");
    ride.set("driver.key", "start").seconds(3);
    assert_eq!(runs(&ride), 1);
    ride.set("driver.parking_brake", "off").seconds(1);
    assert_eq!(runs(&ride), 1);
}

#[test]
fn bus_r044_the_start_permit_comes_3_s_after_the_relay() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("driver.air_conditioning", "on");
    ride.until("relay", 1, |ride| ride.world().vcu.hvac.relay);
    assert!(!ride.world().vcu.hvac.permit);
    let waited = ride.until("permit", 5, |ride| ride.world().vcu.hvac.permit);
    assert_eq!(waited, 3_000);
    ride.ms(200);
    assert_eq!(citybus::Vcu5(ride.frame(citybus::id::VCU5)).start_permit_raw(), 1);
    ride.set("driver.air_conditioning", "off").ms(200);
    assert_eq!(citybus::Vcu5(ride.frame(citybus::id::VCU5)).start_permit_raw(), 0);
}

#[test]
fn bus_r046_derate_is_sent_below_30_percent_and_not_at_30() {
    let derate = |soc: &str| {
        let mut ride = Ride::ready(Kind::Citybus);
        ride.set("battery.soc", soc).set("driver.air_conditioning", "on").seconds(5);
        // The drive of the air conditioning moves the charge by less than a thousandth.
        citybus::Vcu5(ride.frame(citybus::id::VCU5)).derate_raw()
    };
    assert_eq!([derate("29.7"), derate("29.9"), derate("30.1"), derate("80")], [1, 0, 0, 0]);
}

#[test]
fn bus_r054_vcu9_is_sent_only_where_an_oil_pump_is_supplied() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.seconds(5);
    assert!(!ride.has_heard(citybus::id::VCU9));
    let mut ride = Ride::with(Kind::Citybus, Options { optional: true, ..Options::default() });
    ride.seconds(5);
    assert!(ride.has_heard(citybus::id::VCU9));
}

#[test]
fn bus_r056_a_motor_controller_on_another_bus_is_forwarded_under_its_own_identifiers() {
    let senders = |own_bus: f64| {
        let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
        vehicle.set("motor.own_bus", Some(own_bus)).unwrap();
        let mut senders = BTreeSet::new();
        for _ in 0..200 {
            vehicle.advance();
            for sent in vehicle.take_frames() {
                for (name, id) in
                    [("IPU1", citybus::id::IPU1), ("IPU2", citybus::id::IPU2), ("IPU3", citybus::id::IPU3)]
                {
                    if sent.frame.id == id {
                        senders.insert((name, sent.node as usize));
                    }
                }
            }
        }
        senders.into_iter().collect::<Vec<_>>()
    };
    let (mcu, vcu) = (Node::Inverter as usize, Node::Vcu as usize);
    assert_eq!(senders(0.0), [("IPU1", mcu), ("IPU2", mcu), ("IPU3", mcu)]);
    assert_eq!(senders(1.0), [("IPU2", vcu), ("IPU3", vcu)], "IPU1 is not forwarded (BUS-06)");
}

/// Time from the battery's request to the open contactor, in ms.
fn answer_ms(hottest: &str) -> u64 {
    let mut ride = Ride::at(Kind::Citybus, "40");
    ride.set("battery.hottest", hottest);
    ride.until("request", 2, |ride| ride.world().bms.hv_off_request);
    ride.until("open contactor", 40, |ride| !ride.world().bms.main.closed)
}

#[test]
fn bus_r065_bus_r076_bus_r078_high_voltage_is_open_within_5_s_of_the_request() {
    for hottest in ["66", "75"] {
        let took = answer_ms(hottest);
        assert!((1_000..=5_000).contains(&took), "{hottest} degrees: {took} ms, with time for the driver");
    }
}

#[test]
fn bus_r065_the_torque_fades_before_the_contactor_opens() {
    let mut ride = Ride::at(Kind::Citybus, "60");
    ride.set("battery.highest_cell", "4.15").ms(200);
    assert_eq!(citybus::Bms1(ride.frame(citybus::id::BMS1)).hv_open_request_raw(), 3);
    assert_eq!((vcu3(&ride).hv_command_raw(), vcu3(&ride).hv_cutoff_raw()), (1, 0));
    let mut before = f64::MAX;
    for _ in 0..6 {
        ride.ms(500);
        assert!(ride.world().vcu.allowed_watts < before);
        before = ride.world().vcu.allowed_watts;
    }
    ride.ms(200);
    assert_eq!((vcu3(&ride).hv_command_raw(), vcu3(&ride).hv_cutoff_raw()), (0, 1));
    assert_eq!(vcu1(&ride).ready_raw(), 0);
    assert!(ride.read("battery.current").abs() < 1.0, "opened without load");
}

#[test]
fn bus_r076_bus_r078_a_controller_that_ignores_the_request_leaves_it_to_the_battery() {
    let mut ride = Ride::at(Kind::Citybus, "40");
    ride.set("vcu.ignores_hv_off", "on").set("battery.hottest", "66");
    ride.until("request", 2, |ride| ride.world().bms.hv_off_request);
    let took = ride.until("open contactor", 60, |ride| !ride.world().bms.main.closed);
    assert!((35_000..=35_100).contains(&took), "{took}");
    ride.step();
    assert!(!ride.world().vcu.ready);
}

#[test]
fn after_a_cut_off_only_the_key_brings_high_voltage_back() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("battery.hottest", "66").seconds(6);
    ride.set("battery.hottest", "auto").set("driver.key", "start").seconds(4);
    assert!(!ride.world().vcu.ready);
    ride.set("driver.key", "lock").seconds(1).set("driver.key", "start").seconds(4);
    assert!(ride.world().vcu.ready);
}

#[test]
fn bus_r080_five_seconds_without_the_battery_mean_limp_without_regeneration() {
    let mut ride = Ride::at(Kind::Citybus, "60");
    ride.set("link.bms", "on");
    let silence = |ride: &Ride| ride.world().vcu.heard.battery_silence_ms;
    // What it decides in a step comes from the silence at the end of the step before.
    let took = ride.until("limp", 6, |ride| ride.world().vcu.limp);
    assert_eq!(silence(&ride), 4_900);
    assert!(took <= 4_900, "{took}");
    ride.ms(100);
    assert_eq!((vcu1(&ride).power_limited_raw(), ride.world().vcu.allowed_watts), (1, 30_000.0));
    ride.set("driver.target", "0");
    ride.watch(10, |ride| assert!(ride.world().motor.nm >= -1e-9, "it regenerates"));
    ride.set("driver.target", "80");
    ride.watch(20, |ride| assert!(ride.world().motor.watts <= 30_000.0));
    ride.set("link.bms", "off").seconds(2);
    assert!(!ride.world().vcu.limp && ride.world().vcu.may_regenerate);
}

#[test]
fn bus_r080_a_shorter_silence_changes_nothing() {
    let mut ride = Ride::at(Kind::Citybus, "60");
    ride.set("link.bms", "on");
    ride.watch(4, |ride| assert!(!ride.world().vcu.limp));
    ride.set("link.bms", "off");
    ride.watch(10, |ride| assert!(!ride.world().vcu.limp));
}

#[test]
fn bus_r082_the_pack_never_gives_or_takes_more_than_the_battery_allows() {
    for (path, value) in
        [("battery.hottest", "56"), ("battery.soc", "6"), ("battery.soc", "99"), ("road.slope", "12")]
    {
        let mut ride = Ride::ready(Kind::Citybus);
        // Warm all over: a spread between the probes would be a fault of its own.
        ride.set("battery.coldest", "40").set(path, value).set("driver.air_conditioning", "on").seconds(6);
        for target in ["80", "0", "80", "20"] {
            ride.set("driver.target", target);
            ride.watch(20, |ride| {
                let (amps, out) = (ride.read("battery.current"), ride.read("battery.discharge_limit"));
                assert!(amps <= out, "{path} {value}: {amps} A of {out}");
                assert!(amps >= -ride.read("battery.charge_limit"), "{path} {value}: {amps} A");
            });
        }
    }
}

#[test]
fn bus_r082_a_limit_of_nothing_leaves_steering_and_supply_but_neither_drive_nor_comfort() {
    let mut ride = Ride::at(Kind::Citybus, "40");
    ride.set("driver.air_conditioning", "on").set("hvac.cabin", "35").seconds(10);
    assert!(ride.world().hvac.watts > 0.0);
    ride.set("battery.hottest", "61").seconds(1);
    assert_eq!((ride.read("battery.discharge_limit"), ride.world().hvac.watts), (0.0, 0.0));
    assert!(ride.world().motor.nm <= 0.0 && ride.world().steering.running && ride.world().dcdc.running);
}

#[test]
fn bus_r082_the_driver_is_told_of_the_limit() {
    let mut ride = Ride::at(Kind::Citybus, "40");
    assert_eq!(vcu1(&ride).power_limited_raw(), 0);
    ride.set("battery.coldest", "40").set("battery.hottest", "56").ms(600);
    assert!((1_000.0..120_000.0).contains(&ride.world().vcu.allowed_watts));
    assert_eq!(vcu1(&ride).power_limited_raw(), 1);
    ride.set("battery.hottest", "auto").ms(600);
    assert_eq!(vcu1(&ride).power_limited_raw(), 0);
}

/// The cluster says whether the seat is left.
fn say_seat(ride: &mut Ride, left: bool) {
    let life = (ride.world().now_ms / 10) as u8;
    let said = citybus::Meter1::new().with_key_position_raw(1).with_life_raw(life);
    ride.hear(citybus::id::METER1, said.with_driver_left_seat_raw(u8::from(left)).0);
}

/// The same every second.
fn sit(ride: &mut Ride, left: bool, ms: u64) {
    for _ in 0..ms.div_ceil(1_000) {
        say_seat(ride, left);
        ride.ms(ms.min(1_000));
    }
}

#[test]
fn bus_r130_to_bus_r132_a_left_seat_takes_the_torque_after_2_s_and_the_bus_coasts() {
    let mut ride = Ride::at(Kind::Citybus, "50");
    ride.set("driver.target", "auto").set("driver.accelerator", "30");
    sit(&mut ride, false, 1_000);
    sit(&mut ride, true, 1_000);
    say_seat(&mut ride, true);
    ride.ms(990);
    assert!(ride.world().motor.nm > 10.0, "not yet");
    ride.ms(10);
    assert!(ride.world().vcu.seat_cut);
    ride.ms(30);
    assert_eq!(ride.world().motor.nm, 0.0, "with the next VCU2");
    let before = ride.read("vehicle.speed");
    sit(&mut ride, true, 5_000);
    let after = ride.read("vehicle.speed");
    assert!(after < before && after > before - 5.0, "coasts from {before} to {after}");
    assert!(ride.world().motor.watts >= 0.0, "nor does it regenerate");
    sit(&mut ride, false, 1_000);
    assert!(ride.world().motor.nm > 10.0, "back in the seat");
}

#[test]
fn bus_r132_a_bus_that_stands_stays_standing() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("driver.gear", "D");
    sit(&mut ride, true, 3_000);
    ride.set("driver.accelerator", "100");
    sit(&mut ride, true, 5_000);
    assert_eq!(ride.read("vehicle.distance"), 0.0);
}

#[test]
fn jl_r010_level_1_is_sent_as_1_and_is_the_worst() {
    let mut ride = Ride::ready(Kind::Jiulong);
    let level = |ride: &Ride| jiulong::Vcu2(ride.frame(jiulong::id::VCU2)).vcu_fault_level_raw();
    ride.set("vcu.fault_level_3", "7").seconds(1);
    assert_eq!((level(&ride), ride.world().vcu.severity), (3, Severity::Warn));
    ride.set("vcu.fault_level_2", "8").seconds(1);
    assert_eq!((level(&ride), ride.world().vcu.severity), (2, Severity::Derate));
    ride.set("vcu.fault_level_1", "9").seconds(1);
    assert_eq!((level(&ride), ride.world().vcu.severity), (1, Severity::Stop));
    assert!(!ride.world().vcu.ready, "stop at once");
}

#[test]
fn jl_r010_level_2_limits_the_speed() {
    let mut ride = Ride::at(Kind::Jiulong, "80");
    ride.set("vcu.fault_level_2", "8").seconds(180);
    assert!(ride.read("vehicle.speed") <= 40.5, "{}", ride.read("vehicle.speed"));
}

#[test]
fn jl_r011_a_broken_accelerator_is_sent_as_ff_and_gives_no_torque() {
    let mut ride = Ride::ready(Kind::Jiulong);
    ride.set("driver.gear", "D").set("driver.accelerator", "50").ms(500);
    let said = |ride: &Ride| jiulong::Vcu1(ride.frame(jiulong::id::VCU1));
    assert_eq!(said(&ride).accelerator_pedal_raw(), 125);
    ride.set("driver.accelerator_fault", "on").seconds(1);
    assert_eq!(said(&ride).accelerator_pedal_raw(), 0xFF);
    assert!(ride.world().motor.nm <= 0.0);
}

#[test]
fn jl_r012_jl_r017_regeneration_has_negative_torque_and_negative_phase_current() {
    let mut ride = Ride::at(Kind::Jiulong, "60");
    let torque =
        |ride: &Ride| f64::from(jiulong::Vcu1(ride.frame(jiulong::id::VCU1)).torque_raw()) * 0.1 - 3_000.0;
    let phase = |ride: &Ride| {
        f64::from(jiulong::Vcu4(ride.frame(jiulong::id::VCU4)).phase_current_raw()) * 0.1 - 500.0
    };
    assert!(torque(&ride) > 0.0 && phase(&ride) > 0.0);
    ride.set("driver.target", "30").seconds(2);
    assert!(torque(&ride) < -20.0 && phase(&ride) < -5.0 && ride.read("battery.current") < 0.0);
}

#[test]
fn jl_r014_jl_r016_broken_sensors_are_sent_as_ff() {
    let mut ride = Ride::new(Kind::Jiulong);
    ride.seconds(2);
    let vacuum = |ride: &Ride| jiulong::Vcu2(ride.frame(jiulong::id::VCU2)).vacuum_raw();
    let air = |ride: &Ride| jiulong::Vcu4(ride.frame(jiulong::id::VCU4)).air_pressure_1_raw();
    assert!(vacuum(&ride) <= 200 && air(&ride) <= 254);
    ride.set("air.vacuum_sensor_fault", "on").set("air.pressure_sensor_fault", "on").seconds(2);
    assert_eq!((vacuum(&ride), air(&ride)), (0xFF, 0xFF));
}

#[test]
fn jl_r015_motor_speed_is_negative_in_reverse() {
    let mut ride = Ride::ready(Kind::Jiulong);
    ride.set("driver.gear", "R").set("driver.accelerator", "20").seconds(4);
    let rpm = f64::from(jiulong::Vcu3(ride.frame(jiulong::id::VCU3)).motor_speed_raw()) - 15_000.0;
    assert!(rpm < -50.0 && ride.read("vehicle.speed") > 1.0);
}

#[test]
fn jl_r025_versions_are_those_of_the_maker_and_stay() {
    let mut ride = Ride::ready(Kind::Jiulong);
    ride.seconds(3);
    let version = |ride: &Ride| {
        let said = jiulong::Vcu5(ride.frame(jiulong::id::VCU5));
        (said.hardware_version_raw(), said.software_version_raw())
    };
    let first = version(&ride);
    ride.seconds(5);
    assert_eq!(version(&ride), first);
}

#[test]
fn a_gear_against_the_motion_is_refused_and_said_so() {
    let failed = |ride: &Ride| jiulong::Vcu2(ride.frame(jiulong::id::VCU2)).shift_failed_raw();
    let mut ride = Ride::at(Kind::Jiulong, "30");
    assert_eq!(failed(&ride), 0);
    ride.set("driver.target", "auto").set("driver.gear", "R").seconds(1);
    assert_eq!((failed(&ride), ride.world().vcu.gear), (1, Some(Gear::N)));
    assert!(ride.world().motor.nm == 0.0);
    ride.set("driver.brake", "40").seconds(10);
    assert_eq!((failed(&ride), ride.world().vcu.gear), (0, Some(Gear::R)), "engages once it may");
}

#[test]
fn park_engages_at_standstill_only_and_holds_on_a_slope() {
    let mut ride = Ride::at(Kind::C5ev, "30");
    ride.set("driver.target", "auto").set("driver.gear", "P").seconds(1);
    assert_ne!(ride.world().vcu.gear, Some(Gear::P));
    ride.set("driver.brake", "40").seconds(8).set("driver.brake", "0").set("road.slope", "15");
    assert_eq!(ride.world().vcu.gear, Some(Gear::P));
    let before = ride.read("vehicle.distance");
    ride.seconds(10);
    assert_eq!(ride.read("vehicle.distance"), before);
    assert_eq!(to_cluster(&ride).gear_raw(), 3);
}

#[test]
fn c5_r001_the_relay_command_is_aa_for_on_and_55_for_off() {
    let command = |ride: &Ride| c5ev::VcuToBms(ride.frame(c5ev::id::VCU_TO_BMS)).relay_command_raw();
    let mut ride = Ride::new(Kind::C5ev);
    ride.seconds(1);
    assert_eq!(command(&ride), 0x55);
    ride.set("driver.key", "start").seconds(3);
    assert_eq!((command(&ride), ride.world().bms.main.closed), (0xAA, true));
    ride.set("battery.interlock", "on")
        .set("driver.key", "lock")
        .seconds(1)
        .set("driver.key", "on")
        .seconds(1);
    assert_eq!((command(&ride), ride.world().bms.main.closed), (0x55, false));
}

#[test]
fn c5_r012_lamps_follow_the_vehicle() {
    let mut ride = Ride::new(Kind::C5ev);
    ride.seconds(1);
    assert_eq!((to_cluster(&ride).ready_raw(), to_cluster(&ride).system_fault_raw()), (0, 0));
    ride.set("driver.key", "start").seconds(3);
    assert_eq!((to_cluster(&ride).ready_raw(), to_cluster(&ride).motor_fault_raw()), (1, 0));
    ride.set("motor.fault_code", "5").seconds(1);
    let lamps = to_cluster(&ride);
    assert_eq!((lamps.ready_raw(), lamps.motor_fault_raw(), lamps.system_fault_raw()), (0, 1, 1));
    ride.set("motor.fault_code", "0").set("insulation.kiloohm", "100").seconds(1);
    assert_eq!((to_cluster(&ride).insulation_fault_raw(), to_cluster(&ride).motor_fault_raw()), (1, 0));
}

#[test]
fn c5_r013_c5_r014_the_buzzer_falls_silent_after_2_minutes_and_the_lamp_and_the_derating_stay() {
    let mut ride = Ride::ready(Kind::C5ev);
    let full = ride.world().vcu.allowed_watts;
    ride.set("insulation.kiloohm", "140");
    ride.until("buzzer", 1, |ride| ride.world().vcu.buzzer);
    ride.ms(300);
    assert_eq!(to_cluster(&ride).buzzer_raw(), 1);
    let sounded = 300 + ride.until("silence", 130, |ride| !ride.world().vcu.buzzer);
    assert_eq!(sounded, 120_000);
    ride.seconds(1);
    let lamps = to_cluster(&ride);
    assert_eq!((lamps.buzzer_raw(), lamps.insulation_fault_raw(), lamps.system_fault_raw()), (0, 1, 1));
    assert!(ride.world().vcu.allowed_watts <= 0.51 * full);
    ride.set("insulation.kiloohm", "auto").seconds(1).set("insulation.kiloohm", "140").seconds(1);
    assert_eq!(to_cluster(&ride).buzzer_raw(), 1, "sounds anew for a new reason");
}

#[test]
fn c5_r015_cruise_control_asks_for_a_speed_and_the_pedal_for_a_torque() {
    let mode = |ride: &Ride| c5ev::VcuToMcu(ride.frame(c5ev::id::VCU_TO_MCU)).control_mode_raw();
    let mut ride = Ride::at(Kind::C5ev, "50");
    assert_eq!(mode(&ride), 1);
    ride.set("driver.cruise", "on").seconds(1);
    assert_eq!(mode(&ride), 2);
}

#[test]
fn c5_r016_motor_trips_lie_at_150_and_90_degrees() {
    let motor_lamp = |path: &str, celsius: &str| {
        let mut ride = Ride::ready(Kind::C5ev);
        ride.set(path, celsius).seconds(1);
        to_cluster(&ride).motor_fault_raw()
    };
    assert_eq!([motor_lamp("motor.celsius", "150"), motor_lamp("motor.celsius", "151")], [0, 1]);
    assert_eq!(
        [motor_lamp("motor.inverter_celsius", "90"), motor_lamp("motor.inverter_celsius", "91")],
        [0, 1]
    );
}

#[test]
fn a_hot_motor_gives_less_torque_and_says_so() {
    let mut ride = Ride::at(Kind::Citybus, "40");
    ride.set("motor.celsius", "140").ms(100);
    assert_eq!(vcu1(&ride).torque_limited_raw(), 0);
    ride.set("motor.celsius", "150").ms(100);
    assert_eq!(vcu1(&ride).torque_limited_raw(), 1);
    assert!((ride.world().vcu.allowed_watts - 75_000.0).abs() < 1_000.0);
}
