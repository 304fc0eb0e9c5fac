//! The jiulong's alarms: every bit of its battery has a cause, and the motor has three levels.
//!
//! The documents print alarms without thresholds (JL-33); what raises them is this vehicle's, what they look like on
//! the wire is the documents'.

mod battery_rig;

use battery_rig::Rig;
use virtual_vehicle::Kind;

/// Bits that say more than "alarm": one cause at a time must raise one of them.
const ALARMS: &[&str] = &[
    "voltage_balance_fault",
    "max_temperature_exceeded",
    "pack_voltage_exceeded",
    "negative_cut",
    "pack_current_exceeded",
    "mean_voltage_exceeded",
    "max_voltage_exceeded",
    "min_voltage_exceeded",
    "capacity_low",
    "slave_no_response",
    "insulation_fault",
    "temperature_balance_fault",
    "soc_jump",
    "storage_mismatch",
    "overcharge",
    "soc_high",
    "smoke_detector_1_fault",
    "smoke_alarm_1",
    "negative_contactor_welded",
];

/// Settings, the bits that they raise, and the battery's level as sent (1 is the worst, JL-R019).
type Cause = (&'static [(&'static str, f64)], &'static [&'static str], i64);

#[rustfmt::skip]
const CAUSES: &[Cause] = &[
    (&[("battery.highest_cell", 3.55), ("battery.lowest_cell", 3.2)], &["voltage_balance_fault"], 3),
    (&[("battery.hottest", 61.0), ("battery.coldest", 50.0)], &["max_temperature_exceeded"], 2),
    (&[("battery.hottest", 65.0), ("battery.coldest", 50.0)], &["max_temperature_exceeded"], 1),
    (&[("battery.volts", 371.0)], &["pack_voltage_exceeded"], 3),
    (&[("battery.volts", 376.0)], &["pack_voltage_exceeded", "mean_voltage_exceeded"], 2),
    (&[("battery.negative_cut", 1.0)], &["negative_cut"], 0),
    (&[("battery.amps", 320.0)], &["pack_current_exceeded"], 3),
    (&[("battery.amps", -130.0)], &["pack_current_exceeded"], 3),
    (&[("battery.highest_cell", 3.81), ("battery.lowest_cell", 3.7)], &["max_voltage_exceeded"], 3),
    (&[("battery.highest_cell", 3.86), ("battery.lowest_cell", 3.7)], &["max_voltage_exceeded", "overcharge"], 2),
    (&[("battery.highest_cell", 2.9), ("battery.lowest_cell", 2.79)], &["min_voltage_exceeded"], 3),
    (&[("battery.soc", 19.0)], &["capacity_low"], 3),
    (&[("battery.internal_bus", 1.0)], &["slave_no_response"], 2),
    (&[("insulation.kiloohm", 185.0)], &["insulation_fault"], 0),
    (&[("battery.hottest", 45.0), ("battery.coldest", 20.0)], &["temperature_balance_fault"], 3),
    (&[("battery.soc_error", -10.0)], &["soc_jump"], 3),
    (&[("charge.mismatched", 1.0), ("charge.plug", 1.0)], &["storage_mismatch"], 2),
    (&[("battery.soc", 98.0), ("battery.soc_error", 3.0)], &["soc_high"], 3),
    (&[("battery.smoke_detector", 1.0)], &["smoke_detector_1_fault"], 2),
    (&[("battery.smoke", 1.0)], &["smoke_alarm_1"], 1),
    (&[("battery.negative_welded", 1.0)], &["negative_contactor_welded"], 2),
];

fn raised(rig: &Rig) -> Vec<&'static str> {
    ALARMS.iter().copied().filter(|alarm| rig.raw("BMSFaults", alarm) == 1).collect()
}

#[test]
fn jl_r019_every_alarm_of_the_battery_has_a_cause_and_a_level() {
    for (settings, bits, level) in CAUSES {
        let mut rig = Rig::new(Kind::Jiulong);
        rig.wait_ms(600);
        assert_eq!(raised(&rig), Vec::<&str>::new(), "before {settings:?}");
        for (path, setting) in *settings {
            rig.set(path, *setting);
        }
        rig.wait_ms(1_200);
        assert_eq!(raised(&rig), *bits, "{settings:?}");
        assert_eq!(rig.raw("BMSStatus", "battery_fault_level"), *level, "{settings:?}");
    }
    for alarm in ALARMS {
        assert!(CAUSES.iter().any(|(_, bits, _)| bits.contains(alarm)), "nothing raises {alarm}");
    }
}

#[test]
fn a_counter_that_is_off_by_more_than_five_percent_at_once_has_jumped_for_ten_seconds() {
    let jumps = |rig: &Rig| rig.world().bms.soc_jump_ms > 0;
    let mut rig = Rig::new(Kind::Jiulong);
    rig.set("battery.soc", 50.0);
    rig.steps(2);
    assert!(!jumps(&rig), "other cells are no jump");
    rig.set("battery.soc_error", 4.9);
    rig.steps(2);
    assert!(!jumps(&rig));
    rig.set("battery.soc_error", 10.0);
    rig.steps(1);
    assert!(jumps(&rig));
    rig.wait_ms(9_990);
    assert!(jumps(&rig), "the last step of ten seconds");
    rig.steps(1);
    assert!(!jumps(&rig));
    rig.wait_ms(1_000);
    // 0.4 % per count: 60 %.
    assert_eq!(rig.raw("BMSStatus", "soc"), 150);
    assert_eq!(rig.raw("VCU2", "soc"), 150);
    rig.set("battery.soc_error", -10.0);
    rig.steps(1);
    rig.say("driver.key", "lock");
    rig.wait_ms(100);
    rig.say("driver.key", "on");
    rig.steps(2);
    assert!(!jumps(&rig), "power-off forgets it");
}

#[test]
fn charge_above_full_is_told_and_takes_no_more() {
    let mut rig = Rig::new(Kind::Jiulong);
    rig.set("battery.soc", 95.0);
    rig.set("battery.soc_error", 5.0);
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMSFaults", "soc_high"), 0, "full is not above full");
    rig.set("battery.soc_error", 5.1);
    rig.wait_ms(600);
    assert_eq!(rig.raw("BMSFaults", "soc_high"), 1);
    assert_eq!(rig.world().bms.charge_limit_amps, 0.0);
    assert_eq!(rig.raw("BMSStatus", "soc"), 250, "100 % at most");
}

#[test]
fn jl_32_cutting_the_main_negative_is_an_event_that_ends_ready() {
    let mut rig = Rig::new(Kind::Jiulong);
    rig.start();
    rig.set("battery.negative_cut", 1.0);
    rig.wait_until(100, |world| !world.bms.negative.closed && !world.vcu.ready);
    rig.wait_ms(1_000);
    assert_eq!(rig.raw("BMSFaults", "negative_cut"), 1);
    assert_eq!(rig.raw("BMSStatus", "battery_fault_level"), 0);
    rig.set("battery.negative_cut", 0.0);
    rig.wait_until(5_000, |world| world.hv_connected() && world.vcu.ready);
}

#[test]
fn a_charger_for_another_battery_is_told_when_it_is_plugged_in_and_never_charges() {
    let mut rig = Rig::new(Kind::Jiulong);
    rig.set("battery.soc", 50.0);
    rig.set("charge.mismatched", 1.0);
    rig.wait_ms(1_000);
    assert_eq!(rig.raw("BMSFaults", "storage_mismatch"), 0, "not plugged in");
    rig.set("charge.plug", 1.0);
    for _ in 0..100 {
        rig.wait_ms(100);
        assert_eq!(rig.world().charger.amps, 0.0);
    }
    assert_eq!(rig.raw("BMSFaults", "storage_mismatch"), 1);
    rig.set("charge.mismatched", 0.0);
    rig.wait_until(10_000, |world| world.charger.amps > 0.0);
}

#[test]
fn jl_r010_a_warm_motor_is_level_3_a_hot_one_level_2_and_its_own_fault_level_1() {
    type Case = (&'static str, f64, i64);
    let cases: [Case; 11] = [
        ("motor.celsius", 140.0, 0),
        ("motor.celsius", 141.0, 3),
        ("motor.celsius", 150.0, 3),
        ("motor.celsius", 151.0, 2),
        ("motor.inverter_celsius", 85.0, 0),
        ("motor.inverter_celsius", 86.0, 3),
        ("motor.inverter_celsius", 90.0, 3),
        ("motor.inverter_celsius", 91.0, 2),
        ("motor.fault_code", 0.0, 0),
        ("motor.fault_code", 1.0, 1),
        ("motor.protection", 21.0, 1),
    ];
    for (path, setting, level) in cases {
        let mut rig = Rig::new(Kind::Jiulong);
        rig.start();
        rig.set(path, setting);
        rig.wait_ms(600);
        assert_eq!(rig.raw("VCU2", "motor_fault_level"), level, "{path} {setting}");
    }
}

#[test]
fn jl_r010_level_2_of_the_motor_drives_on_at_limited_speed() {
    let mut rig = Rig::new(Kind::Jiulong);
    rig.set("driver.target", 70.0);
    rig.wait_until(60_000, |world| world.motion.kmh() > 68.0);
    rig.set("motor.celsius", 151.0);
    rig.wait_ms(180_000);
    assert!((20.0..=41.0).contains(&rig.world().motion.kmh()), "{} km/h", rig.world().motion.kmh());
}
