//! The battery controller against the source's rules: limits, requests, relays, and what the fault table does not say.
//!
//! The rows of the table themselves, at their thresholds, are in `documents.rs`.

mod battery_rig;

use battery_rig::Rig;
use protocol_core::model::Severity;
use virtual_vehicle::Kind;
use virtual_vehicle::world::RelayState;

/// Controls and what they are set to.
type Settings = &'static [(&'static str, f64)];

fn severity(level: u8) -> Severity {
    [Severity::None, Severity::Warn, Severity::Derate, Severity::Stop][usize::from(level)]
}

fn is_active(rig: &Rig, code: u8, level: u8) -> bool {
    rig.world().bms.active.iter().any(|fault| fault.code == code && fault.severity == severity(level))
}

fn limits(rig: &Rig) -> (f64, f64) {
    (rig.world().bms.charge_limit_amps, rig.world().bms.discharge_limit_amps)
}

/// Sets and lets the other nodes' steps follow.
fn put(rig: &mut Rig, path: &str, setting: f64) {
    rig.set(path, setting);
    rig.steps(3);
}

fn near(actual: f64, expected: f64) -> bool {
    (actual - expected).abs() <= 0.015 * expected.abs() + 1e-9
}

#[test]
fn bus_r095_spread_is_not_monitored_while_charging() {
    let mut rig = Rig::new(Kind::Citybus);
    put(&mut rig, "battery.lowest_cell", 3.0);
    assert!(is_active(&rig, 104, 1));
    put(&mut rig, "charge.plug", 1.0);
    assert!(!is_active(&rig, 104, 1));
}

#[test]
fn bus_r113_socket_is_monitored_only_while_charging() {
    let mut rig = Rig::new(Kind::Citybus);
    put(&mut rig, "battery.socket", 130.0);
    assert!(rig.world().bms.active.is_empty());
}

#[test]
fn cold_thresholds_begin_below_freezing() {
    let mut rig = Rig::new(Kind::Citybus);
    for (path, setting) in
        [("battery.hottest", 5.0), ("battery.highest_cell", 3.0), ("battery.lowest_cell", 2.79)]
    {
        put(&mut rig, path, setting);
    }
    put(&mut rig, "battery.coldest", 0.0);
    assert!(is_active(&rig, 103, 1), "warm at the freezing point");
    let mut rig = Rig::new(Kind::Citybus);
    put(&mut rig, "battery.hottest", 5.0);
    put(&mut rig, "battery.coldest", -0.1);
    put(&mut rig, "battery.highest_cell", 3.0);
    put(&mut rig, "battery.lowest_cell", 2.79);
    assert!(!is_active(&rig, 103, 1), "cold below it");
}

#[test]
fn bus_r098_pack_undervoltage_is_not_judged_in_the_cold() {
    let mut rig = Rig::new(Kind::Citybus);
    put(&mut rig, "battery.volts", 430.0);
    assert!(is_active(&rig, 101, 1));
    put(&mut rig, "battery.hottest", 5.0);
    put(&mut rig, "battery.coldest", -5.0);
    assert!(!is_active(&rig, 101, 1));
}

#[test]
fn bus_r115_silence_of_the_vehicle_controller_limps_after_five_seconds() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.start();
    rig.set("link.vcu", 1.0);
    rig.wait_until(6_000, |world| world.bms.vcu_silence_ms >= 4_990);
    assert_eq!(rig.world().bms.vcu_silence_ms, 4_990);
    assert!(!is_active(&rig, 70, 2), "4990 ms were seen");
    rig.steps(1);
    assert!(is_active(&rig, 70, 2), "5000 ms were seen");
    assert!(rig.world().bms.limp && rig.world().bms.forbids_charging);
    assert_eq!(limits(&rig), (0.0, 60.0), "BUS-R081: 60 A is less than 0.3 x 300 A");
    assert!(rig.world().hv_connected(), "the last command heard holds");
    rig.set("link.vcu", 0.0);
    rig.wait_ms(1_000);
    assert!(!is_active(&rig, 70, 2));
    assert!(limits(&rig).1 > 300.0);
}

#[test]
fn bus_r081_limp_takes_the_smaller_of_sixty_amperes_and_a_third_of_the_capacity() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.internal_bus", 1.0);
    rig.steps(2);
    assert_eq!(limits(&rig).1, 18.0, "0.3 x 60 A");
}

#[test]
fn bus_r026_to_bus_r028_only_codes_of_the_worst_level_one_second_each() {
    let mut rig = Rig::new(Kind::Citybus);
    put(&mut rig, "battery.volts", 430.0);
    assert_eq!(rig.world().bms.code, 101, "level 1 alone");
    rig.set("battery.internal_bus", 1.0);
    rig.set("battery.current_sensor", 1.0);
    rig.steps(1);
    let mut runs: Vec<(u8, usize)> = Vec::new();
    for _ in 0..450 {
        let code = rig.world().bms.code;
        match runs.last_mut() {
            Some((last, count)) if *last == code => *count += 1,
            _ => runs.push((code, 1)),
        }
        rig.steps(1);
    }
    runs.pop();
    assert_eq!(runs, [(63, 100), (64, 100), (63, 100), (64, 100)]);
    put(&mut rig, "battery.interlock", 1.0);
    assert_eq!((rig.world().bms.code, rig.world().bms.severity), (20, Severity::Stop));
    put(&mut rig, "battery.interlock", 0.0);
    assert_eq!(rig.world().bms.severity, Severity::Derate);
}

#[test]
fn different_faults_each_take_half() {
    let mut rig = Rig::new(Kind::Citybus);
    put(&mut rig, "battery.soc", 50.0);
    let whole = limits(&rig).1;
    put(&mut rig, "battery.soc", 15.0);
    assert!(near(limits(&rig).1, 0.5 * whole));
    put(&mut rig, "battery.coldest", 48.0);
    put(&mut rig, "battery.hottest", 56.0);
    assert!(near(limits(&rig).1, 0.25 * whole));
}

/// Settings that are just short of, and just beyond, an extreme limit (BUS-R073 to R075).
const EXTREMES: &[(Settings, &str, f64, f64)] = &[
    (&[("battery.lowest_cell", 4.0)], "battery.highest_cell", 4.1, 4.101),
    (&[("battery.highest_cell", 2.5)], "battery.lowest_cell", 2.3, 2.299),
    (
        &[("battery.highest_cell", 2.4), ("battery.hottest", 5.0), ("battery.coldest", -5.0)],
        "battery.lowest_cell",
        2.1,
        2.099,
    ),
    (&[("battery.coldest", 55.0)], "battery.hottest", 65.0, 65.1),
];

#[test]
fn bus_r073_to_bus_r075_extreme_limits_ask_for_high_voltage_to_be_opened() {
    for &(with, path, not_yet, set) in EXTREMES {
        let mut rig = Rig::new(Kind::Citybus);
        rig.start();
        for &(path, setting) in with {
            put(&mut rig, path, setting);
        }
        put(&mut rig, path, not_yet);
        assert!(!rig.world().bms.hv_off_request, "{path} {not_yet}");
        rig.wait_ms(600);
        assert_eq!(rig.raw("BMS1", "hv_open_request"), 2, "{path} {not_yet}");
        put(&mut rig, path, set);
        assert!(rig.world().bms.hv_off_request, "{path} {set}");
        rig.wait_ms(600);
        assert_eq!(rig.raw("BMS1", "hv_open_request"), 3, "{path} {set}");
    }
}

#[test]
fn bus_r065_vehicle_opens_high_voltage_in_five_seconds_and_it_stays_open() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.start();
    put(&mut rig, "battery.coldest", 58.0);
    rig.set("battery.hottest", 66.0);
    rig.wait_until(5_100, |world| !world.hv_connected());
    rig.free("battery.hottest");
    rig.free("battery.coldest");
    rig.wait_ms(100);
    assert!(!rig.world().bms.hv_off_request, "open and cool: nothing left to ask");
    rig.say("driver.key", "start");
    rig.wait_ms(8_000);
    assert!(!rig.world().hv_connected(), "only power-off lets it close again");
    rig.say("driver.key", "lock");
    rig.wait_ms(1_000);
    rig.say("driver.key", "on");
    rig.wait_ms(200);
    rig.start();
}

/// Steps from the request to open until the main coil is released, with a vehicle that does not answer.
fn steps_until_opened(path: &str, setting: f64) -> usize {
    let mut rig = Rig::new(Kind::Citybus);
    rig.start();
    rig.set("vcu.ignores_hv_off", 1.0);
    rig.set(path, setting);
    rig.steps(1);
    assert!(rig.world().bms.hv_off_request);
    let mut count = 0;
    while rig.world().bms.main.driven {
        count += 1;
        assert!(count < 4_000, "not opened");
        rig.steps(1);
    }
    assert!(rig.world().bms.hv_off_request, "still asks: nobody has answered");
    rig.wait_ms(100);
    assert!(!rig.world().hv_connected());
    count
}

#[test]
fn bus_r076_battery_opens_by_itself_after_thirty_five_seconds() {
    assert_eq!(steps_until_opened("battery.highest_cell", 4.2), 3_500);
    assert_eq!(steps_until_opened("battery.lowest_cell", 2.0), 3_500);
    assert_eq!(steps_until_opened("battery.hottest", 66.0), 3_500);
}

#[test]
fn bus_r078_fire_warning_opens_after_thirty_five_seconds_too() {
    assert_eq!(steps_until_opened("battery.hottest", 75.0), 3_500);
}

#[test]
fn bus_r077_bus_r079_bus_r117_fire_is_latched_until_power_off() {
    let mut rig = Rig::new(Kind::Citybus);
    put(&mut rig, "battery.coldest", 60.0);
    put(&mut rig, "battery.hottest", 74.9);
    assert!(!rig.world().bms.fire && !is_active(&rig, 24, 3));
    put(&mut rig, "battery.hottest", 75.0);
    assert!(rig.world().bms.fire && is_active(&rig, 24, 3));
    assert_eq!(limits(&rig), (0.0, 0.0));
    assert!(rig.world().bms.forbids_charging && rig.world().bms.requests_stop);
    rig.free("battery.hottest");
    rig.free("battery.coldest");
    rig.wait_ms(2_500);
    assert!(is_active(&rig, 24, 3), "no hysteresis: it stays");
    assert_eq!((rig.raw("BMS5", "fault_code"), rig.raw("BMS1", "fault_level")), (24, 1));
    rig.say("driver.key", "acc");
    rig.wait_ms(500);
    rig.say("driver.key", "on");
    rig.wait_ms(500);
    assert!(!rig.world().bms.fire, "power-off clears it");
    assert!(rig.world().bms.active.is_empty());
}

#[test]
fn bus_r063_discharge_is_positive_and_charge_negative() {
    let mut rig = Rig::new(Kind::Citybus);
    put(&mut rig, "battery.amps", 123.4);
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMS1", "pack_current"), 11_234);
    put(&mut rig, "battery.amps", -123.4);
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMS1", "pack_current"), 8_766);
}

#[test]
fn bus_r068_to_bus_r070_double_relays_are_welded_if_either_is_and_closed_if_both_are() {
    use virtual_vehicle::world::Contactor;
    let open = Contactor::default();
    let closed = Contactor { closed: true, ..open };
    let welded = Contactor { closed: true, welded: true, ..open };
    let cases = [
        ([open, open], RelayState::Open),
        ([closed, open], RelayState::Open),
        ([open, closed], RelayState::Open),
        ([closed, closed], RelayState::Closed),
        ([welded, open], RelayState::Welded),
        ([open, welded], RelayState::Welded),
        ([welded, closed], RelayState::Welded),
    ];
    for (pair, state) in cases {
        assert_eq!(Contactor::pair_state(&pair), state, "{pair:?}");
    }
    let mut rig = Rig::new(Kind::Citybus);
    let wire = [
        ("charge_1_relay", "battery.charge_1_welded", "battery.charge_1b_welded"),
        ("charge_2_relay", "battery.charge_2_welded", "battery.charge_2b_welded"),
        ("heater_relay", "battery.heater_welded", "battery.heater_b_welded"),
    ];
    for (signal, one, other) in wire {
        for path in [one, other] {
            rig.set(path, 1.0);
            rig.wait_ms(600);
            assert_eq!(rig.raw("BMS1", signal), 3, "{path}");
            rig.set(path, 0.0);
            rig.wait_ms(600);
            assert_eq!(rig.raw("BMS1", signal), 0, "{path}");
        }
    }
}

#[test]
fn bus_r069_bus_r070_charge_circuit_with_one_relay_stuck_is_open() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.charge_1b_stuck", 1.0);
    rig.set("charge.plug", 1.0);
    rig.wait_ms(5_000);
    assert!(rig.world().bms.charge_1[0].closed);
    assert_eq!(rig.raw("BMS1", "charge_1_relay"), 0);
    rig.set("battery.charge_1b_stuck", 0.0);
    rig.wait_ms(500);
    assert_eq!(rig.raw("BMS1", "charge_1_relay"), 1);
}

#[test]
fn bus_r036_main_closes_only_when_the_link_has_come_up_to_ninety_five_percent() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.say("driver.key", "start");
    rig.wait_until(2_000, |world| world.bms.precharge.closed && world.bms.negative.closed);
    let mut last = 0.0;
    while !rig.world().bms.main.driven {
        let link = rig.world().motor.link_volts;
        assert!(link >= last, "rises");
        last = link;
        rig.steps(1);
    }
    let share = rig.world().motor.link_volts / rig.world().pack.terminal_volts;
    assert!((0.95..0.96).contains(&share), "{share}");
    rig.wait_ms(100);
    assert_eq!(rig.world().motor.link_volts, rig.world().pack.terminal_volts);
    assert!(!rig.world().bms.precharge.closed, "its work is done");
}

#[test]
fn bus_r036_without_vcu3_the_battery_knows_neither_the_wish_nor_the_link_voltage() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("lost.VCU3", 1.0);
    rig.wait_ms(1_000);
    rig.say("driver.key", "start");
    rig.wait_ms(7_000);
    assert!(!rig.world().bms.negative.closed && !rig.world().bms.main.closed);
    rig.set("lost.VCU3", 0.0);
    rig.wait_ms(3_000);
    assert!(rig.world().bms.main.closed);
    // Once closed, the last wish holds.
    rig.set("lost.VCU3", 1.0);
    rig.wait_ms(7_000);
    assert!(rig.world().bms.main.closed);
}

#[test]
fn bus_r034_precharge_that_does_not_come_up_keeps_main_open_and_has_no_code() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.precharge_stuck", 1.0);
    rig.say("driver.key", "start");
    rig.wait_ms(7_000);
    let bms = &rig.world().bms;
    assert!(bms.precharge_failed && !bms.main.closed && !bms.negative.closed);
    assert!(bms.active.is_empty(), "code 22 is gone: {:?}", bms.active);
}

#[test]
fn bus_r109_welded_main_contactor_is_found_when_it_should_open() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.start();
    put(&mut rig, "battery.main_welded", 1.0);
    assert!(!is_active(&rig, 72, 2), "closed as it should be");
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMS1", "main_relay"), 3);
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.main_welded", 1.0);
    rig.wait_ms(500);
    assert!(is_active(&rig, 72, 2));
}

#[test]
fn bus_r109_main_contactor_that_does_not_close_is_a_fault() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.main_stuck", 1.0);
    rig.say("driver.key", "start");
    rig.wait_until(5_000, |world| world.bms.main.driven);
    rig.wait_ms(190);
    assert!(!is_active(&rig, 72, 2));
    rig.wait_ms(20);
    assert!(is_active(&rig, 72, 2));
}

#[test]
fn bus_r064_soc_that_is_set_moves_the_cells() {
    let mut rig = Rig::new(Kind::Citybus);
    for percent in [100.0, 50.0, 5.0] {
        put(&mut rig, "battery.soc", percent);
        let cells = &rig.world().pack.cell_soc;
        let mean = cells.iter().sum::<f64>() / cells.len() as f64;
        assert!((mean * 100.0 - percent).abs() < 0.01, "{mean}");
        assert!((rig.world().pack.soc * 100.0 - percent).abs() < 0.01);
    }
}

#[test]
fn bus_r066_severity_is_inverted_on_the_wire() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMS1", "fault_level"), 0, "no fault");
    for (path, raw) in [("battery.volts", 3), ("battery.internal_bus", 2), ("battery.interlock", 1)] {
        rig.set(path, 1.0);
        rig.wait_ms(600);
        assert_eq!(rig.raw("BMS1", "fault_level"), raw, "{path}");
    }
}

#[test]
fn bus_r144_insulation_frame_comes_from_the_battery_s_own_box() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("insulation.kiloohm", 1_234.0);
    rig.wait_ms(1_100);
    assert_eq!(rig.raw("Insulation", "positive_resistance"), 1_234);
}

#[test]
fn jiulong_level_one_is_the_worst_and_insulation_is_reported_apart() {
    let mut rig = Rig::new(Kind::Jiulong);
    rig.wait_ms(600);
    let levels = |rig: &Rig| {
        let level = |signal| rig.raw("BMSStatus", signal);
        (level("battery_fault_level"), level("insulation_fault_level"))
    };
    assert_eq!(levels(&rig), (0, 0));
    // 320 V: 600, 500 and 400 ohm per volt are about 199, 166 and 133 kilo-ohm.
    for (kiloohm, raw) in [(185.0, 3), (150.0, 2), (100.0, 1)] {
        rig.set("insulation.kiloohm", kiloohm);
        rig.wait_ms(600);
        assert_eq!(levels(&rig), (0, raw), "{kiloohm} kilo-ohm");
    }
    assert_eq!(rig.raw("BMSFaults", "insulation_fault"), 1);
}

#[test]
fn jl_r019_battery_fault_levels_on_the_wire() {
    for (volts, raw) in [(3.79, 0), (3.81, 3), (3.86, 2), (3.91, 1)] {
        let mut rig = Rig::new(Kind::Jiulong);
        rig.set("battery.lowest_cell", 3.66);
        rig.set("battery.highest_cell", volts);
        rig.wait_ms(600);
        assert_eq!(rig.raw("BMSStatus", "battery_fault_level"), raw, "{volts} V");
        assert_eq!(rig.raw("BMSFaults", "max_voltage_exceeded"), i64::from(volts > 3.8), "{volts} V");
    }
}

#[test]
fn jl_r018_discharge_is_positive() {
    let mut rig = Rig::new(Kind::Jiulong);
    rig.set("battery.amps", 100.0);
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMSStatus", "pack_current"), 6_000);
    rig.set("battery.amps", -100.0);
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMSStatus", "pack_current"), 4_000);
}

#[test]
fn jl_r023_broken_smoke_detector_is_level_two() {
    let mut rig = Rig::new(Kind::Jiulong);
    rig.set("battery.smoke_detector", 1.0);
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMSFaults", "smoke_detector_1_fault"), 1);
    assert_eq!(rig.raw("BMSStatus", "battery_fault_level"), 2);
}

#[test]
fn jl_r024_smoke_alarm_is_level_one() {
    let mut rig = Rig::new(Kind::Jiulong);
    rig.set("battery.smoke", 1.0);
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMSFaults", "smoke_alarm_1"), 1);
    assert_eq!(rig.raw("BMSStatus", "battery_fault_level"), 1);
}

#[test]
fn c5_r003_discharge_is_positive() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.amps", 100.0);
    rig.wait_ms(1_100);
    assert_eq!(rig.raw("BMSA", "pack_current"), 6_000);
}

#[test]
fn c5ev_alarms_come_in_two_stages() {
    let stages = |with: &[(&str, f64)]| {
        let mut rig = Rig::new(Kind::C5ev);
        for &(path, setting) in with {
            put(&mut rig, path, setting);
        }
        rig.wait_ms(1_100);
        move |one: &str, two: &str| (rig.raw("BMSD", one), rig.raw("BMSD", two))
    };
    let high = ("cell_voltage_high_1", "cell_voltage_high_2");
    let near = ("battery.lowest_cell", 3.66);
    assert_eq!(stages(&[near, ("battery.highest_cell", 3.8)])(high.0, high.1), (0, 0));
    assert_eq!(stages(&[near, ("battery.highest_cell", 3.81)])(high.0, high.1), (1, 0));
    assert_eq!(stages(&[near, ("battery.highest_cell", 3.91)])(high.0, high.1), (1, 1));
    assert_eq!(stages(&[("battery.soc", 19.0)])("soc_low_1", "soc_low_2"), (1, 0));
    assert_eq!(stages(&[("battery.soc", 9.0)])("soc_low_1", "soc_low_2"), (1, 1));
    let hot = ("temperature_high_1", "temperature_high_2");
    assert_eq!(stages(&[("battery.coldest", 50.0), ("battery.hottest", 56.0)])(hot.0, hot.1), (1, 0));
    assert_eq!(stages(&[("battery.coldest", 50.0), ("battery.hottest", 61.0)])(hot.0, hot.1), (1, 1));
    assert_eq!(stages(&[("battery.interlock", 1.0)])("hv_interlock_fault", "self_check_fault"), (1, 0));
}

#[test]
fn c5ev_contactors_that_do_not_follow_raise_their_bits() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.main_welded", 1.0);
    rig.set("battery.negative_welded", 1.0);
    rig.wait_ms(1_300);
    assert_eq!((rig.raw("BMSD", "positive_open_fault"), rig.raw("BMSD", "negative_open_fault")), (1, 1));
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.main_stuck", 1.0);
    rig.say("driver.key", "start");
    rig.wait_ms(4_000);
    assert_eq!((rig.raw("BMSD", "positive_close_fault"), rig.raw("BMSD", "negative_close_fault")), (1, 0));
}
