//! Charging against the source's rules: handshake, limits, faults, completion, and where the energy goes.

mod battery_rig;

use battery_rig::Rig;
use protocol_core::generated::citybus;
use protocol_core::model::Severity;
use protocol_core::vehicle::Node;
use virtual_vehicle::world::Charge;
use virtual_vehicle::{Kind, Options, STEP_MS, VirtualVehicle};

/// Plugs in and waits for current.
fn charge(rig: &mut Rig) {
    rig.set("charge.plug", 1.0);
    rig.wait_until(10_000, |world| world.bms.charge == Charge::Charging && world.charger.amps > 0.0);
}

/// Plugs in and waits until the current has risen.
fn charge_fully(rig: &mut Rig) {
    charge(rig);
    rig.wait_ms(15_000);
}

#[test]
fn every_vehicle_charges_when_it_is_plugged_in() {
    for kind in Kind::ALL {
        let mut rig = Rig::new(kind);
        rig.say("driver.key", "lock");
        rig.set("battery.soc", 50.0);
        charge_fully(&mut rig);
        let world = rig.world();
        assert!(world.charger.amps >= world.charger.max_amps - 0.01, "{kind:?}: {}", world.charger.amps);
        assert!(world.pack.amps < 0.0, "{kind:?}");
        assert!(world.bms.active.is_empty(), "{kind:?}: {:?}", world.bms.active);
        rig.set("charge.plug", 0.0);
        rig.wait_ms(200);
        assert_eq!(rig.world().bms.charge, Charge::Idle, "{kind:?}");
        assert_eq!(rig.world().charger.amps, 0.0, "{kind:?}");
    }
}

#[test]
fn charging_ends_with_full_cells_that_nobody_complains_of() {
    for kind in Kind::ALL {
        let mut rig = Rig::new(kind);
        rig.set("battery.soc", 97.0);
        if kind == Kind::Citybus {
            rig.set("battery.charge_interval", 9.0);
        }
        charge(&mut rig);
        let mut highest: f64 = 0.0;
        while rig.world().bms.charge == Charge::Charging {
            assert!(rig.now_ms() < 4 * 3_600_000, "{kind:?} does not come to an end");
            assert!(rig.world().bms.active.is_empty(), "{kind:?}: {:?}", rig.world().bms.active);
            highest = highest.max(rig.world().bms.cell_max.value);
            rig.steps(10);
        }
        let world = rig.world();
        assert_eq!(world.bms.charge, Charge::Complete, "{kind:?}");
        assert!((3.48..3.56).contains(&highest), "{kind:?}: {highest} V");
        assert!(world.pack.soc > 0.999_9, "{kind:?}: {}", world.pack.soc);
        let mean = world.pack.cell_soc.iter().sum::<f64>() / world.pack.cell_soc.len() as f64;
        assert!((mean - 1.0).abs() < 0.02, "{kind:?}: the cells are full, too: {mean}");
        assert_eq!(world.bms.charge_interval_days, 0, "BUS-R084: cleared after every external charge");
        rig.wait_ms(60_000);
        assert_eq!(rig.world().bms.charge, Charge::Complete, "{kind:?}: does not begin again");
        assert_eq!(rig.world().charger.amps, 0.0, "{kind:?}");
    }
}

#[test]
fn bus_r084_charging_that_is_broken_off_does_not_clear_the_count() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.charge_interval", 9.0);
    rig.set("battery.soc", 50.0);
    charge_fully(&mut rig);
    rig.set("charge.plug", 0.0);
    rig.wait_ms(1_500);
    assert_eq!(rig.raw("BMS5", "charge_interval"), 9);
}

#[test]
fn bus_r154_charger_delivers_only_while_enabled() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.soc", 50.0);
    assert!(!rig.world().bms.charger_enabled, "off until there is something to charge");
    charge_fully(&mut rig);
    assert!(rig.world().bms.charger_enabled);
    rig.set("battery.interlock", 1.0);
    rig.steps(1);
    assert!(!rig.world().bms.charger_enabled);
    assert_eq!(rig.world().bms.charge, Charge::Fault);
    rig.wait_until(1_010, |world| world.charger.amps == 0.0);
    rig.set("battery.interlock", 0.0);
    rig.wait_ms(2_000);
    assert_eq!(rig.world().bms.charge, Charge::Charging, "goes on when the fault has gone");
}

#[test]
fn bus_r146_without_an_on_board_charger_nobody_sends_its_frame() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    vehicle.set("charge.plug", Some(1.0)).unwrap();
    let charger = citybus::MESSAGES.iter().find(|info| info.name == "ChargerTx").unwrap().id;
    for _ in 0..300 {
        vehicle.advance();
        assert!(vehicle.take_frames().iter().all(|sent| sent.frame.id != charger));
    }
    assert!(vehicle.world().charger.running, "the pack is charged all the same");
}

#[test]
fn bus_r030_battery_does_not_command_the_converter_while_charging() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    vehicle.set("charge.plug", Some(1.0)).unwrap();
    let order = citybus::MESSAGES.iter().find(|info| info.name == "VCU6").unwrap().id;
    let mut senders = Vec::new();
    for _ in 0..300 {
        vehicle.advance();
        senders
            .extend(vehicle.take_frames().iter().filter(|sent| sent.frame.id == order).map(|sent| sent.node));
    }
    assert!(!senders.is_empty() && senders.iter().all(|node| *node == Node::Vcu), "{senders:?}");
}

#[test]
fn bus_r076_extreme_heat_ends_charging_for_good() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.soc", 50.0);
    charge_fully(&mut rig);
    rig.set("battery.coldest", 58.0);
    rig.set("battery.hottest", 66.0);
    rig.wait_ms(100);
    assert!(!rig.world().bms.charge_1.iter().any(|relay| relay.closed));
    rig.free("battery.hottest");
    rig.free("battery.coldest");
    rig.wait_ms(5_000);
    assert_eq!(rig.world().bms.charge, Charge::Fault, "until power-off");
    rig.say("driver.key", "lock");
    rig.set("charge.plug", 0.0);
    rig.wait_ms(100);
    charge(&mut rig);
}

#[test]
fn bus_r113_hot_socket_halves_the_current_and_bus_r114_ends_it() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.soc", 50.0);
    charge_fully(&mut rig);
    let whole = rig.world().bms.charge_limit_amps;
    rig.set("battery.socket", 100.1);
    rig.steps(2);
    assert!((rig.world().bms.charge_limit_amps - 0.5 * whole).abs() < 0.01 * whole);
    assert!(rig.world().charger.running);
    rig.set("battery.socket", 120.1);
    rig.wait_until(1_010, |world| !world.charger.running);
    assert_eq!(rig.world().bms.charge, Charge::Fault);
}

#[test]
fn bus_r153_jl_r028_c5_r010_wrong_mains_stops_the_charger() {
    for kind in Kind::ALL {
        for (volts, runs) in [(186.0, false), (187.0, true), (253.0, true), (254.0, false)] {
            let mut rig = Rig::new(kind);
            rig.set("battery.soc", 50.0);
            charge(&mut rig);
            rig.set("charge.mains", volts);
            rig.wait_ms(3_000);
            assert_eq!(rig.world().charger.running, runs, "{kind:?} at {volts} V");
            assert_eq!(rig.world().charger.input_fault, !runs, "{kind:?} at {volts} V");
        }
    }
}

#[test]
fn a_dead_mains_is_a_pause_and_not_a_fault() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.soc", 50.0);
    charge(&mut rig);
    rig.set("charge.mains", 0.0);
    rig.wait_ms(2_000);
    assert_eq!(rig.world().bms.charge, Charge::Idle);
    assert_eq!(rig.world().charger.severity, Severity::None);
    rig.set("charge.mains", 220.0);
    rig.wait_ms(2_000);
    assert_eq!(rig.world().bms.charge, Charge::Charging);
}

#[test]
fn bus_r152_jl_r029_reversed_battery_does_not_start() {
    for kind in [Kind::Citybus, Kind::Jiulong] {
        let mut rig = Rig::new(kind);
        rig.set("charge.reversed", 1.0);
        rig.set("charge.plug", 1.0);
        rig.wait_ms(8_000);
        assert!(rig.world().charger.start_inhibited && !rig.world().charger.running, "{kind:?}");
    }
}

#[test]
fn bus_r147_to_bus_r151_charger_reports_the_worst_level_by_code_range() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.soc", 50.0);
    charge_fully(&mut rig);
    let whole = rig.world().charger.amps;
    rig.set("charge.fault_code_1", 101.0);
    rig.wait_ms(100);
    assert_eq!((rig.world().charger.severity, rig.world().charger.code), (Severity::Warn, 101));
    assert_eq!(rig.world().charger.amps, whole, "a warning leaves the current");
    rig.set("charge.fault_code_2", 58.0);
    rig.wait_ms(1_100);
    assert_eq!((rig.world().charger.severity, rig.world().charger.code), (Severity::Derate, 58));
    assert!((rig.world().charger.amps - 50.0).abs() < 0.01, "half of 100 A");
    assert_eq!((rig.raw("ChargerTx", "fault_level"), rig.raw("ChargerTx", "fault_code")), (2, 58));
    rig.set("charge.fault_code_3", 8.0);
    rig.steps(1);
    assert_eq!((rig.world().charger.severity, rig.world().charger.code), (Severity::Stop, 8));
    assert!(!rig.world().charger.running);
}

#[test]
fn bus_r150_codes_of_one_level_take_turns_of_one_second() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("charge.plug", 1.0);
    rig.set("charge.fault_code_1", 102.0);
    rig.set("charge.fault_code_2", 105.0);
    rig.set("charge.fault_code_3", 108.0);
    rig.steps(1);
    let mut runs: Vec<(u8, usize)> = Vec::new();
    for _ in 0..450 {
        let code = rig.world().charger.code;
        match runs.last_mut() {
            Some((last, count)) if *last == code => *count += 1,
            _ => runs.push((code, 1)),
        }
        rig.steps(1);
    }
    runs.pop();
    assert_eq!(runs, [(102, 100), (105, 100), (108, 100), (102, 100)]);
}

#[test]
fn jl_r027_jl_r030_charger_current_is_negative_and_its_level_inverted() {
    let mut rig = Rig::new(Kind::Jiulong);
    rig.set("battery.soc", 50.0);
    charge_fully(&mut rig);
    assert_eq!(rig.raw("Charger", "output_current"), 5_000 - 200, "20 A of charge");
    rig.set("charge.fault_code_1", 101.0);
    rig.wait_ms(1_100);
    assert_eq!(rig.raw("Charger", "fault_level"), 3);
    rig.set("charge.charger_fault", 1.0);
    rig.wait_ms(1_100);
    assert_eq!(rig.raw("Charger", "fault_level"), 1);
}

#[test]
fn bus_r037_pantograph_charges_through_circuit_two_when_the_vehicle_enables_it() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.soc", 50.0);
    rig.set("charge.pantograph", 1.0);
    rig.wait_until(60_000, |world| world.bms.charge == Charge::Charging && world.charger.amps > 100.0);
    let bms = &rig.world().bms;
    assert!(bms.charge_2.iter().all(|relay| relay.closed));
    assert!(!bms.charge_1.iter().any(|relay| relay.closed));
    rig.set("charge.pantograph", 0.0);
    rig.wait_ms(1_000);
    assert_eq!(rig.world().charger.amps, 0.0);
}

#[test]
fn a_freezing_battery_is_heated_before_it_is_charged() {
    let mut rig = Rig::new(Kind::Citybus);
    rig.set("battery.soc", 50.0);
    rig.set("battery.hottest", 2.0);
    rig.set("battery.coldest", -3.0);
    rig.set("charge.plug", 1.0);
    rig.wait_ms(10_000);
    assert_eq!(rig.raw("BMS1", "heater_relay"), 1);
    assert_eq!(rig.world().charger.amps, 0.0);
    rig.set("battery.hottest", 12.0);
    rig.set("battery.coldest", 9.0);
    rig.wait_ms(10_000);
    assert_eq!(rig.raw("BMS1", "heater_relay"), 0);
    assert!(rig.world().charger.amps > 50.0);
}

#[test]
fn c5_r004_charger_is_ready_before_and_after_charging() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.soc", 99.0);
    rig.set("charge.mains", 0.0);
    rig.set("charge.plug", 1.0);
    rig.wait_ms(2_100);
    assert_eq!(rig.raw("ChargerTx", "charger_state"), 0, "a: waits without a fault");
    rig.set("charge.mains", 220.0);
    rig.wait_ms(5_100);
    assert_eq!(rig.raw("ChargerTx", "charger_state"), 1);
    rig.wait_until(3_600_000, |world| world.bms.charge == Charge::Complete);
    rig.wait_ms(2_100);
    assert_eq!(rig.raw("ChargerTx", "charger_state"), 0, "b: end of charge and no fault");
    rig.set("charge.charger_fault", 1.0);
    rig.wait_ms(1_100);
    assert_eq!(rig.raw("ChargerTx", "charger_state"), 2);
}

/// Charger heard, precharge closed, main relay closed, charger enabled.
type Stage = (bool, bool, bool, bool);

#[test]
fn c5_r006_precharge_then_main_relay_then_charger_on() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.soc", 50.0);
    rig.set("charge.plug", 1.0);
    let mut seen = Vec::new();
    for _ in 0..600 {
        rig.steps(1);
        let bms = &rig.world().bms;
        let stage = (bms.charger_heard, bms.precharge.closed, bms.main.closed, bms.charger_enabled);
        if seen.last() != Some(&stage) {
            seen.push(stage);
        }
    }
    let place = |stage: &dyn Fn(&Stage) -> bool| seen.iter().position(stage).unwrap();
    let heard = place(&|stage| stage.0);
    let precharging = place(&|stage| stage.1);
    let closed = place(&|stage| stage.2);
    let enabled = place(&|stage| stage.3);
    assert!(heard < precharging && precharging < closed && closed <= enabled, "{seen:?}");
}

#[test]
fn c5_r005_main_relay_stays_open_when_the_charger_is_never_heard() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("link.charger", 1.0);
    rig.set("charge.plug", 1.0);
    rig.wait_ms(20_000);
    assert!(!rig.world().bms.main.closed);
    assert_eq!(rig.world().bms.charge, Charge::Fault);
}

#[test]
fn c5_r005_main_relay_opens_after_five_seconds_without_the_charger() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.soc", 50.0);
    charge_fully(&mut rig);
    rig.set("link.charger", 1.0);
    let mut seen = 0;
    while rig.world().bms.main.driven {
        seen = rig.world().bms.charger_silence_ms;
        assert!(seen < 10_000);
        rig.steps(1);
    }
    assert_eq!(seen, 4_990, "one step earlier the relay was still on");
    rig.wait_ms(100);
    assert!(!rig.world().bms.main.closed && rig.world().charger.amps == 0.0);
}

#[test]
fn c5_r007_bus_r154_charger_switches_off_after_five_seconds_without_orders() {
    for (kind, message) in [(Kind::C5ev, "ChargerControl"), (Kind::Citybus, "ChargerRx")] {
        let mut rig = Rig::new(kind);
        rig.set("battery.soc", 50.0);
        charge_fully(&mut rig);
        let lost = format!("lost.{message}");
        rig.set(&lost, 1.0);
        let mut seen = 0;
        while rig.world().charger.running {
            seen = rig.world().charger.silence_ms;
            assert!(seen < 10_000, "{message}");
            rig.steps(1);
        }
        assert_eq!(seen, 4_990, "{message}: one step earlier it still delivered");
        assert!(rig.world().charger.communication_fault, "{message}");
        assert_eq!(rig.world().charger.amps, 0.0, "{message}");
        rig.set(&lost, 0.0);
        rig.wait_ms(5_000);
        assert!(rig.world().charger.running, "{message}: goes on when it is told again");
    }
}

#[test]
fn c5_r007_other_frames_of_the_battery_are_not_orders_that_are_missed() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.soc", 50.0);
    charge_fully(&mut rig);
    rig.set("lost.BMSA", 1.0);
    rig.wait_ms(8_000);
    assert!(rig.world().charger.running);
}

#[test]
fn c5_r008_charger_runs_at_the_smaller_of_both_maxima() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.soc", 50.0);
    charge_fully(&mut rig);
    assert!(rig.world().bms.wanted_charge.0 > 20.0, "the battery would take more");
    assert_eq!(rig.world().charger.amps, rig.world().charger.max_amps);
    rig.set("battery.hottest", 20.0);
    rig.set("battery.coldest", 2.0);
    rig.set("battery.interlock", 0.0);
    rig.wait_ms(2_000);
    rig.set("battery.coldest", 0.5);
    rig.wait_ms(3_000);
    let world = rig.world();
    assert!(world.charger.amps < world.charger.max_amps, "the cold battery takes less");
    assert!((world.charger.amps - world.bms.wanted_charge.0).abs() < 0.2);
}

#[test]
fn c5_r009_charger_classifies_by_the_battery_s_thresholds() {
    // 100 cells: warned of 365 V and 260 V, protected at 375 V and 230 V.
    let cases: [(f64, [i64; 4]); 6] = [
        (330.0, [0, 0, 0, 0]),
        (365.1, [1, 0, 0, 0]),
        (375.1, [1, 1, 0, 0]),
        (260.0, [0, 0, 0, 0]),
        (259.9, [0, 0, 1, 0]),
        (229.9, [0, 0, 1, 1]),
    ];
    for (volts, expected) in cases {
        let mut rig = Rig::new(Kind::C5ev);
        rig.set("battery.soc", 50.0);
        charge_fully(&mut rig);
        rig.set("battery.volts", volts);
        rig.wait_ms(1_100);
        let signals = [
            "overvoltage_warning",
            "overvoltage_protection",
            "undervoltage_warning",
            "undervoltage_protection",
        ];
        assert_eq!(signals.map(|signal| rig.raw("ChargerTx", signal)), expected, "{volts} V");
        assert_eq!(rig.world().charger.running, expected[1] + expected[3] == 0, "{volts} V");
    }
}

#[test]
fn c5_r009_charger_refuses_thresholds_that_contradict_each_other() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.soc", 50.0);
    charge_fully(&mut rig);
    rig.set("charge.bounds_exchanged", 1.0);
    rig.wait_ms(2_100);
    for signal in ["overvoltage_data_error", "undervoltage_data_error", "overcurrent_data_error"] {
        assert_eq!(rig.raw("ChargerTx", signal), 1, "{signal}");
    }
    assert!(!rig.world().charger.running);
}

#[test]
fn c5_r011_zero_enables_and_one_switches_off() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.soc", 50.0);
    rig.wait_ms(1_100);
    assert_eq!(rig.raw("ChargerControl", "charge_inhibit"), 1);
    charge_fully(&mut rig);
    assert_eq!(rig.raw("ChargerControl", "charge_inhibit"), 0);
    rig.set("battery.interlock", 1.0);
    rig.wait_ms(1_100);
    assert_eq!(rig.raw("ChargerControl", "charge_inhibit"), 1);
}

/// Sums up what crosses the terminals: charge in Ah and heat in the cells in J, both into and out of the pack.
#[derive(Default)]
struct Meter {
    ampere_hours: f64,
    lost_joules: f64,
}

impl Meter {
    fn step(&mut self, rig: &mut Rig) {
        rig.steps(1);
        let pack = &rig.world().pack;
        let seconds = STEP_MS as f64 / 1_000.0;
        let ohm: f64 = pack.cell_ohm.iter().sum();
        self.ampere_hours += pack.terminal_amps * seconds / 3_600.0;
        self.lost_joules += pack.terminal_amps * pack.terminal_amps * ohm * seconds;
    }
}

#[test]
fn what_is_charged_comes_back_but_for_the_heat_in_the_cells() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.soc", 50.0);
    rig.steps(1);
    let start_soc = rig.world().pack.soc;
    let start_joules = rig.world().pack.joules_in - rig.world().pack.joules_out;
    let mut meter = Meter::default();
    rig.set("charge.plug", 1.0);
    while rig.world().pack.soc < start_soc + 0.03 {
        assert!(rig.now_ms() < 3 * 3_600_000);
        meter.step(&mut rig);
    }
    let charged_hours = -meter.ampere_hours;
    assert!((charged_hours - 0.03 * 60.0).abs() < 0.001, "3 % of 60 Ah: {charged_hours}");
    rig.set("charge.plug", 0.0);
    rig.set("driver.target", 80.0);
    while rig.world().pack.soc > start_soc {
        assert!(rig.now_ms() < 6 * 3_600_000);
        meter.step(&mut rig);
    }
    let pack = &rig.world().pack;
    let kept = pack.joules_in - pack.joules_out - start_joules;
    assert!(meter.lost_joules > 1_000.0, "there was current");
    let share = kept / meter.lost_joules;
    assert!((0.9..1.1).contains(&share), "{kept} J stayed, {} J of heat", meter.lost_joules);
}

#[test]
fn heat_of_the_current_warms_the_cells() {
    let mut rig = Rig::new(Kind::C5ev);
    rig.set("battery.soc", 50.0);
    let before = rig.world().pack.inner_celsius.clone();
    rig.set("driver.target", 110.0);
    rig.wait_ms(180_000);
    let warmer = rig.world().pack.inner_celsius.iter().zip(&before).all(|(now, before)| now > before);
    assert!(warmer, "{:?}", rig.world().pack.inner_celsius);
}
