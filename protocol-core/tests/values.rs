//! What is said of a value besides its number: how it is missing, in which unit it is read, when it came.

use protocol_core::Millis;
use protocol_core::link::Sample;
use protocol_core::model::{Gear, Reading, Readings, Severity, Shown, Unit, Value};

#[test]
fn only_a_fresh_and_valid_value_has_a_number() {
    assert_eq!(Shown::Value(7).value(), Some(7));
    for missing in [Shown::Never, Shown::Stale, Shown::Invalid] {
        assert_eq!(missing.value(), None::<i32>);
    }
}

#[test]
fn a_conversion_keeps_every_kind_of_missing() {
    let double = |number: i32| i64::from(number) * 2;
    assert_eq!(Shown::Value(7).map(double), Shown::Value(14));
    assert_eq!(Shown::Never.map(double), Shown::Never);
    assert_eq!(Shown::Stale.map(double), Shown::Stale);
    assert_eq!(Shown::Invalid.map(double), Shown::Invalid);
}

#[test]
fn a_store_begins_with_nothing_seen_and_tells_who_wrote_what() {
    for mut readings in [Readings::new(), Readings::default()] {
        assert!(Value::ALL.iter().all(|&value| readings.get(value).is_none()));
        readings.set(3, Value::VehicleSpeed, Reading::Valid(-1));
        readings.set(Readings::LOCAL, Value::BodyHorn, Reading::Invalid);
        assert_eq!(readings.get(Value::VehicleSpeed), Some((Reading::Valid(-1), 3)));
        assert_eq!(readings.get(Value::BodyHorn), Some((Reading::Invalid, Readings::LOCAL)));
        let seen = Value::ALL.iter().filter(|&&value| readings.get(value).is_some());
        assert_eq!(seen.count(), 2);
    }
}

#[test]
fn every_value_has_a_name_of_its_own() {
    for (place, &value) in Value::ALL.iter().enumerate() {
        assert_eq!(value as usize, place);
        assert_eq!(Value::from_path(value.path()), Some(value));
    }
    assert_eq!(Value::from_path("battery.soul"), None);
}

#[test]
fn numbers_outside_the_words_of_a_unit_are_nothing() {
    let severities = [(-1, Severity::None), (0, Severity::None), (1, Severity::Warn), (2, Severity::Derate)];
    for (number, severity) in severities.into_iter().chain([(3, Severity::Stop), (4, Severity::None)]) {
        assert_eq!(Severity::from_model(number), severity);
    }
    let gears = [(1, Gear::D), (2, Gear::R), (3, Gear::N), (4, Gear::P)];
    let forward = (11..).zip([Gear::D1, Gear::D2, Gear::D3, Gear::D4, Gear::D5, Gear::D6]);
    for (number, gear) in gears.into_iter().chain(forward) {
        assert_eq!(Gear::from_number(number), Some(gear));
    }
    assert!([-1, 0, 5, 10, 17].iter().all(|&number| Gear::from_number(number).is_none()));
}

#[test]
fn every_unit_is_read_as_people_read_it() {
    let texts = [
        (Unit::Flag, 0, "no"),
        (Unit::Flag, 1, "yes"),
        (Unit::Count, 104, "104"),
        (Unit::Severity, 0, "none"),
        (Unit::Severity, 1, "warn"),
        (Unit::Severity, 2, "derate"),
        (Unit::Severity, 3, "stop"),
        (Unit::Gear, 0, "0"),
        (Unit::Gear, 2, "R"),
        (Unit::Gear, 16, "D6"),
        (Unit::Contactor, 0, "open"),
        (Unit::Contactor, 1, "closed"),
        (Unit::Contactor, 2, "welded"),
        (Unit::Contactor, 3, "fault"),
        (Unit::Run, 0, "stopped"),
        (Unit::Run, 1, "running"),
        (Unit::Run, 2, "fault"),
        (Unit::Charge, 0, "idle"),
        (Unit::Charge, 1, "charging"),
        (Unit::Charge, 2, "complete"),
        (Unit::Charge, 3, "fault"),
        (Unit::Fan, 0, "low"),
        (Unit::Fan, 1, "medium"),
        (Unit::Fan, 2, "high"),
        (Unit::Kmh256, 12_425, "48.5 km/h"),
        (Unit::Km8, -1, "-0.125 km"),
        (Unit::Permille, 1_000, "100.0 %"),
        (Unit::Decivolt, 5_376, "537.6 V"),
        (Unit::Millivolt, 3_305, "3.305 V"),
        (Unit::Deciamp, -7, "-0.7 A"),
        (Unit::DeciNm, 15_001, "1500.1 Nm"),
        (Unit::Rpm, -3_000, "-3000 rpm"),
        (Unit::Celsius, -40, "-40 °C"),
        (Unit::Kiloohm, 500, "500 kohm"),
        (Unit::Ah, 210, "210 Ah"),
        (Unit::CentiMpa, 82, "0.82 MPa"),
        (Unit::Kilopascal, 70, "70 kPa"),
        (Unit::Watt, 30_500, "30.500 kW"),
        (Unit::Hertz, 50, "50 Hz"),
        (Unit::Day, 9, "9 d"),
        (Unit::Key, 1, "acc"),
        (Unit::Mode, 5, "limp"),
        (Unit::Check, 2, "precharged"),
        (Unit::Check, 5, "5"),
        (Unit::Bits, 5, "5"),
    ];
    for (unit, counts, text) in texts {
        assert_eq!(unit.show(counts).to_string(), text, "{unit:?}");
        let symbol = text.split_once(' ').map_or("", |(_, symbol)| symbol);
        assert_eq!(unit.symbol(), symbol, "{unit:?}");
    }
    for value in Value::ALL {
        assert!(texts.iter().any(|(unit, ..)| *unit == value.unit()), "{:?} has no text here", value.unit());
    }
}

#[test]
fn a_missing_sample_says_how_it_is_missing() {
    let text = |sample: Sample| sample.show(Unit::Decivolt).to_string();
    assert_eq!(text(Sample::Value(5_376)), "537.6 V");
    assert_eq!(text(Sample::Never), "never");
    assert_eq!(text(Sample::Stale), "stale");
    assert_eq!(text(Sample::Invalid), "invalid");
}

#[test]
fn a_sample_is_what_is_shown() {
    let pairs = [
        (Sample::Never, Shown::Never),
        (Sample::Stale, Shown::Stale),
        (Sample::Invalid, Shown::Invalid),
        (Sample::Value(-5), Shown::Value(-5)),
    ];
    for (sample, shown) in pairs {
        assert_eq!((Sample::from(shown), Shown::<i32>::from(sample)), (sample, shown));
    }
}

#[test]
fn time_runs_forwards_only_and_does_not_wrap() {
    let at = Millis(1_000);
    assert_eq!((at.after(234), at.after(0)), (Millis(1_234), at));
    assert_eq!((at.after(234).since(at), at.since(at.after(234))), (234, 0), "never negative");
    // 49.7 days are 32 bits of milliseconds.
    let wrap = Millis(u64::from(u32::MAX));
    assert_eq!(wrap.after(5).since(wrap), 5);
    assert!(wrap.after(1) > wrap);
}
