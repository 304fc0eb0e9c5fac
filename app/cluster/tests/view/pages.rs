//! Pages: what turns them, what leads back, what stands on them.

use crate::support::probe::{decode, id, rx};
use crate::support::*;
use cluster::page::{Chapter, Count, Page, ROWS};
use cluster::view::{Limp, List, Listed, Sheet};
use cluster::{Button, Controller, Sound, Trip};
use protocol_core::model::{Shown, Value as V};
use protocol_core::states::Confinement;
use protocol_core::vehicle::{FaultText, LimpRule, NO_VEHICLE, Node, Rules, Vehicle};
use protocol_core::{CanFrame, CanId, Severity};

/// A vehicle that sends any value, one in each frame.
static ANY: Vehicle = Vehicle {
    name: "any",
    rx: &[rx(Node::Inverter)],
    decode,
    faults: &[
        FaultText { source: Node::Vcu, code: 24, fire: true, ..text("火灾", "Fire") },
        FaultText { source: Node::Bms, code: 3, ..text("过压", "Overvoltage") },
        FaultText { source: Node::Bms, code: 4, limps: true, ..text("失联", "Link lost") },
    ],
    rules: Rules {
        limp: Some(LimpRule { silence_ms: 5_000, most_deciamps: 600, deciamps_per_ah: 3 }),
        ..Rules::NONE
    },
    ..NO_VEHICLE
};

const fn text(zh: &'static str, en: &'static str) -> FaultText {
    FaultText { source: Node::Bms, code: 0, severity: None, fire: false, limps: false, zh, en }
}

/// A vehicle that stands, after the bulb check.
fn standing() -> Drive {
    let mut drive = Drive::of(&ANY);
    drive.keep(Node::Inverter, V::VehicleSpeed, 0);
    drive.run(4_000);
    drive
}

/// What the driver does with the pages, and what stands on them.
impl Drive {
    fn speed(&mut self, kmh: i32) {
        self.keep(Node::Inverter, V::VehicleSpeed, kmh * 256);
        self.run(100);
    }

    /// Holds `next` down for so long, and lets the contact settle.
    fn push(&mut self, ms: u64) {
        self.inputs.buttons.next = true;
        self.run(ms);
        self.inputs.buttons.next = false;
        self.run(100);
    }

    fn turn(&mut self) {
        self.push(100);
    }

    /// Turns until the page has this number.
    fn turn_to(&mut self, number: u8) {
        for _ in 0..40 {
            if self.view().page.number() == number {
                return;
            }
            self.turn();
        }
        panic!("no page {number}");
    }

    fn number(&self) -> u8 {
        self.view().page.number()
    }

    fn list(&self) -> List {
        match self.view().page {
            Page::Faults(list) | Page::History(list) => list,
            page => panic!("{page:?} is no list"),
        }
    }

    fn sheet(&self) -> Sheet {
        match self.view().page {
            Page::Technic(sheet) => sheet,
            page => panic!("{page:?} is not technical"),
        }
    }

    fn listed(&self) -> Vec<&'static str> {
        self.list().rows.iter().flatten().map(|row| row.text.en).collect()
    }
}

const MAIN: u8 = 0;
const TRIP_A: u8 = 1;
const TRIP_B: u8 = 2;
const ENERGY: u8 = 3;
const FAULTS: u8 = 4;
const HISTORY: u8 = 5;
const BUS: u8 = Chapter::Bus.number();

#[test]
fn a_short_push_turns_to_the_next_page_and_the_last_leads_to_the_first() {
    let mut drive = standing();
    let mut seen = Vec::new();
    for _ in 0..10 {
        seen.push(drive.number());
        drive.turn();
    }
    // A vehicle that sends nothing technical has what the cluster measures, and the counters of its bus.
    let [supply, air] = [Chapter::Supply, Chapter::Pumps].map(Chapter::number);
    assert_eq!(seen, [MAIN, TRIP_A, TRIP_B, ENERGY, FAULTS, HISTORY, supply, air, BUS, MAIN]);
}

#[test]
fn a_page_turns_when_the_finger_goes_and_a_bounce_turns_nothing() {
    let mut drive = standing();
    drive.inputs.buttons.next = true;
    drive.run(900);
    assert_eq!(drive.number(), MAIN, "it may become a long push");
    drive.inputs.buttons.next = false;
    drive.run(2 * TICK);
    assert_eq!(drive.number(), MAIN, "two samples could be a bounce");
    drive.run(TICK);
    assert_eq!(drive.number(), TRIP_A);
    drive.run(5_000);
    assert_eq!(drive.number(), TRIP_A, "a wire that stays up turns nothing");
}

#[test]
fn a_long_push_leads_back_to_the_main_page_and_turns_nothing_when_it_ends() {
    let mut drive = standing();
    drive.turn_to(HISTORY);
    drive.inputs.buttons.next = true;
    drive.run(1_020);
    assert_eq!(drive.number(), HISTORY, "the push began after three samples");
    drive.run(TICK);
    assert_eq!(drive.number(), MAIN);
    drive.run(5_000);
    drive.inputs.buttons.next = false;
    drive.run(500);
    assert_eq!(drive.number(), MAIN);
}

#[test]
fn a_long_push_sets_the_shown_trip_to_zero_and_no_other() {
    let mut drive = standing();
    drive.keep(Node::Inverter, V::BatteryVoltage, 3_500);
    drive.keep(Node::Inverter, V::BatteryCurrent, 400);
    drive.speed(60);
    drive.run(60_000);
    let [a, b] = drive.view().journeys;
    assert!(a.hectometres >= 10 && a == b, "a minute at 60 km/h: {a:?}");
    drive.turn_to(TRIP_B);
    drive.push(1_500);
    assert_eq!(drive.view().page, Page::Trip(Trip::B), "the page stays");
    assert!(drive.view().journeys[0].hectometres >= 10, "trip A is kept");
    assert!(drive.view().journeys[1].hectometres < 2, "trip B counts from zero");
    drive.turn_to(TRIP_A);
    drive.cluster.hold(drive.now);
    assert_eq!(drive.view().journeys[0].hectometres, 0);
}

#[test]
fn a_push_that_silences_neither_turns_nor_resets() {
    let mut drive = standing();
    drive.turn();
    drive.keep(Node::Inverter, V::VehicleFaultLevel, 2);
    drive.run(100);
    assert_eq!(drive.sound(), Some(Sound::Derate));
    drive.push(100);
    assert_eq!((drive.sound(), drive.number()), (None, TRIP_A));
    drive.keep(Node::Inverter, V::MotorFaultLevel, 2);
    drive.run(100);
    drive.push(2_000);
    assert_eq!((drive.sound(), drive.number()), (None, TRIP_A), "a long one neither");
    drive.cluster.press(Button::Next, drive.now);
    assert_eq!(drive.number(), TRIP_B);
}

#[test]
fn a_stop_or_fire_leads_to_the_main_page_until_it_is_silenced() {
    let mut drive = standing();
    drive.turn_to(FAULTS);
    drive.keep(Node::Inverter, V::VehicleFaultLevel, 3);
    drive.run(100);
    assert_eq!((drive.number(), drive.sound()), (MAIN, Some(Sound::Stop)));
    drive.turn();
    assert_eq!((drive.number(), drive.sound()), (MAIN, None), "this push was for the sound");
    drive.turn_to(FAULTS);
    assert_eq!(drive.listed(), ["System fault level 3"], "what is wrong can be read up then");
    drive.keep(Node::Inverter, V::BodySmoke, 1);
    drive.run(100);
    assert_eq!(drive.number(), MAIN, "another one");
}

#[test]
fn fire_holds_the_main_page_for_ever() {
    let mut drive = standing();
    drive.turn_to(TRIP_A);
    drive.keep(Node::Inverter, V::VehicleFaultCode, 24);
    drive.run(100);
    assert_eq!((drive.number(), drive.sound()), (MAIN, Some(Sound::Fire)));
    drive.turn();
    assert_eq!((drive.number(), drive.sound()), (MAIN, None), "this push was for the sound");
    for _ in 0..3 {
        drive.turn();
        assert_eq!((drive.number(), drive.sound()), (MAIN, None), "no push leaves it");
    }
}

#[test]
fn a_milder_fault_turns_no_page() {
    let mut drive = standing();
    drive.turn_to(TRIP_A);
    drive.keep(Node::Inverter, V::VehicleFaultLevel, 2);
    drive.run(5_000);
    assert_eq!(drive.number(), TRIP_A);
}

#[test]
fn the_energy_page_comes_with_the_plug_and_goes_with_it() {
    let mut drive = standing();
    drive.keep(Node::Inverter, V::ChargePlug, 1);
    drive.run(100);
    assert_eq!(drive.number(), ENERGY);
    drive.run(100_000);
    assert_eq!(drive.number(), ENERGY);
    drive.keep(Node::Inverter, V::ChargePlug, 0);
    drive.run(100);
    assert_eq!(drive.number(), MAIN);
}

#[test]
fn the_driver_may_leave_the_energy_page_while_charging() {
    let mut drive = standing();
    drive.keep(Node::Inverter, V::ChargePlug, 1);
    drive.run(100);
    drive.turn_to(HISTORY);
    drive.run(100_000);
    assert_eq!(drive.number(), HISTORY, "nothing falls back while the vehicle stands");
    drive.keep(Node::Inverter, V::ChargePlug, 0);
    drive.run(100);
    assert_eq!(drive.number(), HISTORY, "and the plug takes nothing away");
}

#[test]
fn a_plug_in_a_moving_vehicle_brings_no_page_before_it_stands() {
    let mut drive = standing();
    drive.keep(Node::Inverter, V::ChargePlug, 1);
    drive.speed(1);
    drive.hold_main();
    drive.run(1_000);
    assert_eq!(drive.number(), MAIN);
    drive.speed(0);
    assert_eq!(drive.number(), ENERGY);
}

impl Drive {
    fn hold_main(&mut self) {
        self.cluster.hold(self.now);
    }
}

#[test]
fn a_plug_counts_while_the_speed_is_not_known() {
    let mut drive = standing();
    drive.forget();
    drive.keep(Node::Inverter, V::ChargeState, 1);
    drive.run(1_000);
    assert_eq!(drive.number(), ENERGY, "the vehicle controller sleeps while the charger works");
}

#[test]
fn lists_and_technical_pages_fall_back_in_a_driving_vehicle_after_thirty_seconds() {
    for (number, falls_back) in
        [(TRIP_A, false), (TRIP_B, false), (ENERGY, false), (FAULTS, true), (HISTORY, true), (BUS, true)]
    {
        let mut drive = standing();
        drive.turn_to(number);
        drive.speed(5);
        drive.run(29_000);
        assert_eq!(drive.number(), number, "29 s");
        drive.run(2_000);
        assert_eq!(drive.number(), if falls_back { MAIN } else { number }, "page {number}");
    }
}

#[test]
fn a_push_starts_the_thirty_seconds_again_and_walking_pace_never_ends_them() {
    let mut drive = standing();
    drive.turn_to(FAULTS);
    drive.speed(4);
    drive.run(100_000);
    assert_eq!(drive.number(), FAULTS, "4 km/h");
    drive.turn();
    drive.speed(50);
    drive.run(20_000);
    drive.turn();
    drive.run(20_000);
    assert_eq!(drive.number(), Chapter::Supply.number());
}

#[test]
fn every_button_that_was_never_pushed_is_idle_since_the_start() {
    let mut drive = standing();
    drive.speed(50);
    drive.run(60_000);
    assert_eq!(drive.number(), MAIN);
}

#[test]
fn the_list_of_faults_has_the_worst_first_and_an_empty_one_has_one_part() {
    let mut drive = standing();
    drive.turn_to(FAULTS);
    let empty = List { position: 1, count: 1, ..List::default() };
    assert_eq!(drive.list(), empty);
    drive.keep(Node::Inverter, V::VehiclePowerLimited, 1);
    drive.keep(Node::Inverter, V::DcdcState, 2);
    drive.keep(Node::Inverter, V::DcdcFaultCode, 7);
    drive.keep(Node::Inverter, V::BrakeVacuumFault, 1);
    drive.run(100);
    drive.cluster.press(Button::Next, drive.now);
    assert_eq!(drive.listed(), ["Brake vacuum fault", "DC/DC converter fault", "Power limited"]);
    let row = drive.list().rows[1].expect("a row");
    assert_eq!((row.severity, row.code, row.count), (Severity::Warn, Some(7), 1));
    assert_eq!(row.at_s, 4, "whole seconds since power-on");
}

/// Ten faults of ten rows.
const TEN: [V; 10] = [
    V::BrakeVacuumFault,
    V::BrakeAbsFault,
    V::HvacFault,
    V::CompressorHot,
    V::InsulationDeviceFault,
    V::ChargerFault,
    V::CoolingFanFault,
    V::SupplyLow,
    V::VehicleTorqueLimited,
    V::VehiclePowerLimited,
];

#[test]
fn a_long_list_is_turned_through_part_by_part() {
    let mut drive = standing();
    TEN.iter().for_each(|&value| drive.keep(Node::Inverter, value, 1));
    drive.run(100);
    drive.cluster.press(Button::Next, drive.now);
    drive.turn_to(FAULTS);
    let mut texts = Vec::new();
    for part in 1..=3 {
        assert_eq!((drive.list().position, drive.list().count), (part, 3));
        assert_eq!(drive.listed().len(), if part < 3 { ROWS } else { TEN.len() - 2 * ROWS });
        texts.extend(drive.listed());
        drive.turn();
    }
    assert_eq!(drive.number(), HISTORY);
    let mut distinct = texts.clone();
    distinct.sort_unstable();
    distinct.dedup();
    assert_eq!(distinct.len(), TEN.len(), "each fault stands there once: {texts:?}");
}

#[test]
fn a_list_that_gets_shorter_shows_its_last_part() {
    let mut drive = standing();
    TEN.iter().for_each(|&value| drive.keep(Node::Inverter, value, 1));
    drive.run(100);
    drive.cluster.press(Button::Next, drive.now);
    drive.turn_to(FAULTS);
    drive.turn();
    drive.turn();
    assert_eq!(drive.list().position, 3);
    TEN[1..].iter().for_each(|&value| drive.keep(Node::Inverter, value, 0));
    drive.run(100);
    assert_eq!((drive.list().position, drive.list().count), (1, 1));
    assert_eq!(drive.listed(), ["Brake vacuum fault"]);
}

#[test]
fn the_history_has_the_latest_first_and_counts_what_returns() {
    let mut drive = standing();
    for (value, times) in [(V::BrakeAbsFault, 2), (V::HvacFault, 1)] {
        for _ in 0..times {
            drive.keep(Node::Inverter, value, 1);
            drive.run(1_000);
            drive.keep(Node::Inverter, value, 0);
            drive.run(1_000);
        }
    }
    drive.keep(Node::Inverter, V::BatteryFaultLevel, 2);
    drive.keep(Node::Inverter, V::BatteryFaultCode, 3);
    drive.run(100);
    drive.cluster.press(Button::Next, drive.now);
    drive.turn_to(HISTORY);
    let rows: Vec<Listed> = drive.list().rows.into_iter().flatten().collect();
    let said: Vec<_> = rows.iter().map(|row| (row.text.en, row.code, row.count, row.severity)).collect();
    let expected = [
        ("Overvoltage", Some(3), 1, Severity::Derate),
        ("Air conditioning fault", None, 1, Severity::Warn),
        ("ABS fault", None, 2, Severity::Warn),
    ];
    assert_eq!(said, expected);
    assert_eq!(rows.iter().map(|row| row.at_s).collect::<Vec<_>>(), [10, 8, 6], "when each came last");
}

#[test]
fn the_history_prints_no_numbers_of_alarm_bits() {
    let mut drive = standing();
    drive.keep(Node::Inverter, V::BatteryAlarms, 0b100);
    drive.run(100);
    drive.cluster.press(Button::Next, drive.now);
    drive.turn_to(HISTORY);
    let row = drive.list().rows[0].expect("the alarm");
    assert_eq!((row.text.en, row.code), ("Overvoltage", None));
}

#[test]
fn bus_r038_and_bus_r067_relay_states_stand_on_a_page_of_their_own() {
    let mut drive = standing();
    drive.keep(Node::Inverter, V::RelayMotor, 1);
    drive.keep(Node::Inverter, V::ContactorCharge1, 2);
    drive.keep(Node::Inverter, V::BoxHeater, 3);
    drive.run(100);
    let expected = [(Chapter::Relays, 1, 1), (Chapter::Contactors, 2, 2), (Chapter::Box, 6, 3)];
    // Before them stand supply and air, behind them the bus.
    for (position, (chapter, place, state)) in (3..).zip(expected) {
        drive.turn_to(chapter.number());
        let sheet = drive.sheet();
        assert_eq!((sheet.chapter, sheet.values[place]), (chapter, Shown::Value(state)));
        let others = sheet.values.iter().enumerate().filter(|(other, _)| *other != place);
        assert!(others.clone().all(|(_, value)| *value == Shown::Never), "{sheet:?}");
        assert_eq!((sheet.position, sheet.count), (position, 6));
    }
}

#[test]
fn bus_r033_bus_r060_bus_r120_bus_r124_bus_r126_and_bus_r143_codes_stand_there_as_numbers() {
    let codes = [
        V::MotorFaultCode,
        V::SteeringFaultCode,
        V::DcdcFaultCode,
        V::CompressorFaultCode,
        V::InsulationFaultCode,
    ];
    let mut drive = standing();
    (100..).zip(codes).for_each(|(code, value)| drive.keep(Node::Inverter, value, code));
    drive.run(100);
    drive.turn_to(Chapter::Codes.number());
    let sheet = drive.sheet();
    for (code, value) in (100..).zip(codes) {
        let place = sheet.chapter.items().iter().position(|item| item.value == value).expect("a code");
        assert_eq!(sheet.values[place], Shown::Value(code), "{}", value.path());
    }
    drive.forget();
    drive.run(1_000);
    assert_eq!(drive.sheet().values[2], Shown::Stale, "silence is shown as silence");
}

#[test]
fn the_extremes_come_with_their_places() {
    let mut drive = standing();
    for (number, item) in (1..).zip(Chapter::Extremes.items()) {
        drive.keep(Node::Inverter, item.value, number);
    }
    drive.run(100);
    drive.turn_to(Chapter::Extremes.number());
    let values = drive.sheet().values;
    assert!((1..).zip(values).all(|(number, value)| value == Shown::Value(number)), "{values:?}");
}

#[test]
fn the_bus_s_counters_are_the_controller_s_and_the_cluster_s() {
    let mut drive = standing();
    drive.turn_to(BUS);
    let of = |drive: &Drive, count: Count| drive.sheet().values[count as usize];
    assert_eq!(of(&drive, Count::State), Shown::Never, "nobody says");
    drive.inputs.controller = Some(Controller {
        state: Some(Confinement::ErrorPassive),
        transmit_errors: 130,
        receive_errors: 7,
        sent: 11,
        lost: u32::MAX,
    });
    drive.cluster.receive(&CanFrame::full(CanId::standard(5), [0; 8]), drive.now);
    drive.cluster.receive(&CanFrame::from_slice(id(Node::Inverter), &[1, 2]).expect("two bytes"), drive.now);
    drive.run(TICK);
    let expected = [
        (Count::State, 3),
        (Count::TransmitErrors, 130),
        (Count::ReceiveErrors, 7),
        (Count::Sent, 11),
        (Count::Lost, i32::MAX),
        (Count::Unknown, 1),
        (Count::Short, 1),
        (Count::Damaged, 0),
    ];
    for (count, number) in expected {
        assert_eq!(of(&drive, count), Shown::Value(number), "{count:?}");
    }
    assert!(matches!(of(&drive, Count::Stored), Shown::Value(40..)), "a frame every 100 ms");
}

#[test]
fn every_page_has_a_number_of_its_own() {
    let technic = Chapter::ALL.iter().map(|&chapter| Page::Technic(Sheet { chapter, ..Sheet::default() }));
    let pages = [Page::Main, Page::Trip(Trip::A), Page::Trip(Trip::B), Page::Energy];
    let lists = [Page::Faults(List::default()), Page::History(List::default())];
    let mut numbers: Vec<u8> = pages.into_iter().chain(lists).chain(technic).map(Page::number).collect();
    numbers.sort_unstable();
    assert_eq!(numbers, (0..numbers.len() as u8).collect::<Vec<_>>());
}

#[test]
fn c5_r013_a_push_silences_the_vehicle_s_buzzer_until_its_bit_has_fallen() {
    let mut drive = standing();
    drive.keep(Node::Inverter, V::VehicleBuzzer, 1);
    drive.keep(Node::Inverter, V::BatteryFault, 1);
    drive.run(100);
    assert_eq!(drive.sound(), Some(Sound::Buzzer));
    let lamps = drive.view().telltales;
    drive.turn();
    assert_eq!((drive.sound(), drive.number()), (None, MAIN));
    drive.run(30_000);
    assert_eq!(drive.sound(), None);
    assert_eq!(drive.view().telltales, lamps, "C5-R014: the icon stays");
    drive.keep(Node::Inverter, V::VehicleBuzzer, 0);
    drive.run(100);
    drive.turn();
    assert_eq!(drive.number(), TRIP_A, "nothing sounds: the push turns");
    drive.keep(Node::Inverter, V::VehicleBuzzer, 1);
    drive.run(100);
    assert_eq!(drive.sound(), Some(Sound::Buzzer), "asked for anew");
}

#[test]
fn a_gear_that_is_not_engaged_is_a_line() {
    let mut drive = standing();
    drive.keep(Node::Inverter, V::VehicleShiftFailed, 1);
    drive.run(100);
    let line = drive.view().line.expect("a line");
    assert_eq!((line.text.en, line.severity), ("Gear not engaged", Severity::Warn));
    drive.keep(Node::Inverter, V::VehicleShiftFailed, 0);
    drive.run(100);
    assert_eq!(drive.view().line, None);
}

#[test]
fn bus_r115_a_fault_that_means_limp_is_one_by_its_row_in_the_vehicle_s_table() {
    for (code, limps) in [(3, false), (4, true), (70, false)] {
        let mut drive = standing();
        drive.keep(Node::Inverter, V::BatteryFaultLevel, 2);
        drive.keep(Node::Inverter, V::BatteryFaultCode, code);
        drive.run(100);
        assert_eq!(drive.view().limp.is_some(), limps, "code {code}");
        drive.keep(Node::Inverter, V::BatteryFaultLevel, 0);
        drive.run(100);
        assert_eq!(drive.view().limp, None, "limp mode ends with its fault");
    }
}

#[test]
fn limp_stands_in_the_view_on_every_page() {
    let mut drive = standing();
    drive.keep(Node::Inverter, V::VehicleMode, 5);
    drive.keep(Node::Inverter, V::BatteryCapacity, 100);
    drive.run(100);
    drive.cluster.press(Button::Next, drive.now);
    for number in [MAIN, TRIP_A, ENERGY, FAULTS] {
        drive.turn_to(number);
        assert_eq!(drive.view().limp, Some(Limp { limit_deciamps: Some(300) }));
    }
}
