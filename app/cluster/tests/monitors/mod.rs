//! The timing rules as the driver sees them; the machines themselves are tested exhaustively in their modules.

use crate::support::probe::*;
use crate::support::*;
use cluster::{Cluster, Options, Sound};
use protocol_core::model::{Shown, Value as V};
use protocol_core::vehicle::{Node, RxMessage, Vehicle};
use protocol_core::{CanFrame, Millis, Severity};

fn hv_off_after(drive: &mut Drive, ms: u64) -> (Vec<&'static str>, Option<u8>) {
    drive.run(ms);
    (drive.texts(), drive.view().hv_off_s)
}

#[test]
fn bus_r065_bus_r076_a_request_counts_down_to_the_battery_s_own_action() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::ContactorMain, 1);
    drive.keep(Node::Bms, V::BatteryHvOffRequest, 1);
    assert_eq!(hv_off_after(&mut drive, TICK), (vec!["Battery asks for HV off: stop"], Some(35)));
    assert_eq!((drive.view().severity, drive.sound()), (Severity::Stop, Some(Sound::Stop)));
    assert_eq!(hv_off_after(&mut drive, 4_980), (vec!["Battery asks for HV off: stop"], Some(31)));
    assert_eq!(hv_off_after(&mut drive, 20), (vec!["HV still on: battery will cut it"], Some(30)));
    assert_eq!(hv_off_after(&mut drive, 29_980), (vec!["HV still on: battery will cut it"], Some(1)));
    assert_eq!(hv_off_after(&mut drive, 20), (vec!["Battery cuts HV now"], None));
    drive.keep(Node::Bms, V::ContactorMain, 0);
    assert_eq!(hv_off_after(&mut drive, CYCLE), (vec!["High voltage is off"], None));
}

#[test]
fn bus_68_contactors_that_open_early_end_the_countdown_and_closing_brings_it_back() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryHvOffRequest, 1);
    drive.run(3_000);
    drive.keep(Node::Bms, V::ContactorMain, 0);
    assert_eq!(hv_off_after(&mut drive, CYCLE), (vec!["High voltage is off"], None));
    drive.keep(Node::Bms, V::ContactorMain, 1);
    assert_eq!(hv_off_after(&mut drive, CYCLE), (vec!["Battery asks for HV off: stop"], Some(32)));
}

#[test]
fn bus_68_a_withdrawn_request_is_gone_and_a_second_one_counts_anew() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryHvOffRequest, 1);
    drive.run(10_000);
    drive.keep(Node::Bms, V::BatteryHvOffRequest, 0);
    assert_eq!(hv_off_after(&mut drive, CYCLE), (vec![], None));
    drive.keep(Node::Bms, V::BatteryHvOffRequest, 1);
    assert_eq!(hv_off_after(&mut drive, CYCLE), (vec!["Battery asks for HV off: stop"], Some(35)));
}

#[test]
fn bus_68_a_withdrawal_between_two_ticks_is_not_missed() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryHvOffRequest, 1);
    drive.run(10_000);
    for number in [0, 1] {
        let frame = [V::BatteryHvOffRequest as u8, 0, 0, 0, number, 0, 0, 0];
        let frame = CanFrame::full(PROBE.rx[2].id, frame);
        drive.cluster.receive(&frame, drive.now);
    }
    assert_eq!(hv_off_after(&mut drive, CYCLE).1, Some(35));
}

#[test]
fn bus_68_the_countdown_goes_on_while_the_battery_is_silent_and_an_open_contactor_is_not_believed() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryHvOffRequest, 1);
    drive.keep(Node::Bms, V::ContactorMain, 0);
    drive.run(6_000);
    assert_eq!(drive.texts(), ["High voltage is off"]);
    drive.hush(Node::Bms);
    drive.run(4_000);
    assert_eq!(drive.texts()[0], "HV still on: battery will cut it");
    assert_eq!(drive.view().hv_off_s, Some(26));
    drive.run(25_000 + TICK);
    assert_eq!(drive.texts()[0], "Battery cuts HV now");
    assert_eq!(drive.view().severity, Severity::Stop);
    drive.keep(Node::Bms, V::BatteryHvOffRequest, 0);
    drive.speak(Node::Bms);
    drive.run(CYCLE);
    assert_eq!(drive.texts(), [""; 0], "the battery is back and asks for nothing");
}

#[test]
fn bus_r080_bus_r081_the_vehicle_limps_five_seconds_after_the_battery_s_last_word() {
    let mut drive = healthy();
    drive.keep(Node::Bms, V::BatteryCapacity, 150);
    drive.run(CYCLE);
    drive.hush(Node::Bms);
    // The last frame came 100 ms ago.
    drive.run(4_900);
    assert_eq!((drive.texts(), drive.view().limp), (vec!["No communication: BMS"], None));
    drive.run(TICK);
    assert_eq!(drive.texts(), ["Limp: power limited, no regen", "No communication: BMS"]);
    assert_eq!(drive.view().limp.map(|limp| limp.limit_deciamps), Some(Some(450)), "0.3 x 150 Ah");
    drive.speak(Node::Bms);
    drive.run(CYCLE);
    assert_eq!((drive.texts(), drive.view().limp), (vec![], None), "at the first word");
}

#[test]
fn bus_r081_the_limit_is_never_above_60_amperes_and_unknown_without_a_capacity() {
    for (capacity, limit) in
        [(None, None), (Some(200), Some(600)), (Some(280), Some(600)), (Some(100), Some(300))]
    {
        let mut drive = healthy();
        if let Some(capacity) = capacity {
            drive.keep(Node::Bms, V::BatteryCapacity, capacity);
        }
        drive.keep(Node::Vcu, V::VehicleMode, 5);
        drive.run(CYCLE);
        assert_eq!(drive.view().limp.map(|limp| limp.limit_deciamps), Some(limit), "{capacity:?}");
    }
}

#[test]
fn bus_r080_when_everything_is_silent_nothing_is_said_of_limping() {
    let mut drive = healthy();
    drive.hush(Node::Bms);
    drive.hush(Node::Vcu);
    drive.run(60_000);
    assert_eq!(drive.texts(), ["No communication: VCU", "No communication: BMS"]);
    assert_eq!(drive.view().limp, None);
}

#[test]
fn bus_r133_bus_23_the_loss_of_the_air_conditioning_is_told_only_if_wanted() {
    for (wanted, texts) in [(false, vec![]), (true, vec!["Air conditioning link lost"])] {
        let mut drive = healthy();
        drive.cluster = Cluster::with_options(&PROBE, Options { hvac_alarm: wanted, ..Options::NONE });
        drive.keep(Node::Hvac, V::HvacOn, 1);
        drive.run(CYCLE);
        drive.hush(Node::Hvac);
        drive.run(9_900);
        assert_eq!(drive.texts(), [""; 0], "10 s after its last word");
        drive.run(TICK);
        assert_eq!(drive.texts(), texts);
        assert_eq!((drive.view().severity, drive.sound()), (Severity::None, None), "information");
        drive.speak(Node::Hvac);
        drive.run(CYCLE);
        assert_eq!(drive.texts(), [""; 0]);
    }
}

#[test]
fn bus_r133_an_air_conditioning_that_is_off_is_not_missed() {
    let mut drive = healthy();
    drive.cluster = Cluster::with_options(&PROBE, Options { hvac_alarm: true, ..Options::NONE });
    drive.keep(Node::Hvac, V::HvacOn, 0);
    drive.run(CYCLE);
    drive.hush(Node::Hvac);
    drive.run(20_000);
    assert_eq!(drive.texts(), [""; 0]);
}

#[test]
fn c5_r005_a_charger_that_falls_silent_while_plugged_in_is_told_after_five_seconds() {
    let mut drive = healthy();
    drive.keep(Node::Vcu, V::ChargePlug, 1);
    drive.keep(Node::Charger, V::ChargerVoltage, 3_500);
    drive.run(10_000);
    assert_eq!(drive.texts(), [""; 0]);
    drive.hush(Node::Charger);
    drive.run(4_900);
    assert_eq!(drive.texts(), [""; 0]);
    drive.run(TICK);
    assert_eq!(drive.texts(), ["Charger lost: charging ends"]);
    assert_eq!(drive.sound(), Some(Sound::Warn));
    drive.keep(Node::Vcu, V::ChargePlug, 0);
    drive.run(CYCLE);
    assert_eq!(drive.texts(), [""; 0], "unplugged");
    drive.keep(Node::Vcu, V::ChargePlug, 1);
    drive.run(5_000);
    assert_eq!(drive.texts(), [""; 0], "C5-22: it has its time again");
    drive.run(CYCLE);
    assert_eq!(drive.texts(), ["Charger lost: charging ends"]);
}

#[test]
fn c5_r005_a_charger_that_was_never_heard_is_not_missed() {
    let mut drive = healthy();
    drive.keep(Node::Vcu, V::ChargePlug, 1);
    drive.run(60_000);
    assert_eq!(drive.texts(), [""; 0]);
}

#[test]
fn c5_r013_c5_r014_the_buzzer_follows_its_bit_for_two_minutes_and_arms_again_when_it_falls() {
    let mut drive = healthy();
    drive.keep(Node::Vcu, V::VehicleBuzzer, 1);
    drive.run(TICK);
    assert_eq!(drive.sound(), Some(Sound::Buzzer));
    drive.run(120_000 - TICK);
    assert_eq!(drive.sound(), Some(Sound::Buzzer));
    drive.run(TICK);
    assert_eq!(drive.sound(), None, "C5-20: the guard");
    drive.run(600_000);
    assert_eq!(drive.sound(), None);
    drive.keep(Node::Vcu, V::VehicleBuzzer, 0);
    drive.run(CYCLE);
    drive.keep(Node::Vcu, V::VehicleBuzzer, 1);
    drive.run(CYCLE);
    assert_eq!(drive.sound(), Some(Sound::Buzzer));
    drive.hush(Node::Vcu);
    drive.run(TIMEOUT);
    assert_ne!(drive.sound(), Some(Sound::Buzzer), "a bit that is stale does not sound");
}

#[test]
fn a_stop_fault_sounds_above_the_buzzer_and_the_buzzer_above_milder_faults() {
    let mut drive = healthy();
    drive.keep(Node::Vcu, V::VehicleBuzzer, 1);
    for (level, sound) in [(1, Sound::Buzzer), (2, Sound::Buzzer), (3, Sound::Stop), (0, Sound::Buzzer)] {
        drive.keep(Node::Vcu, V::VehicleFaultLevel, level);
        drive.run(CYCLE);
        assert_eq!(drive.sound(), Some(sound), "level {level}");
    }
}

#[test]
fn another_cluster_on_the_bus_is_a_node_like_any_other() {
    let rx: &'static [RxMessage] = Box::leak(Box::new([RxMessage { node: Node::Cluster, ..PROBE.rx[0] }]));
    let mut cluster = Cluster::new(Box::leak(Box::new(Vehicle { rx, ..PROBE })));
    cluster.receive(&CanFrame::full(rx[0].id, [V::BodyHorn as u8, 0, 0, 0, 1, 0, 0, 0]), Millis(7));
    assert_eq!(cluster.shown(V::BodyHorn, Millis(8)), Shown::Value(1));
}
