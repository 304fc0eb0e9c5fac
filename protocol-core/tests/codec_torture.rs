//! What a vehicle's table can ask of decoder and encoder, with numbers worked out by hand.
//!
//! The vehicle is made up; `cargo test -p vehicle-compiler` keeps its generated file current.

// The generated file names these as parts of its own crate.
use protocol_core::{checksum, codec, frame, model, stream, vehicle};

use model::{Reading, Readings, Value};
use vehicle::Life;

#[path = "codec_torture/torture.rs"]
#[rustfmt::skip]
#[allow(clippy::all, clippy::cast_lossless, dead_code, missing_docs, unreachable_pub, unused_imports)]
mod torture;

use torture::{Plain, VEHICLE, Wide};

fn decoded(message: &str, data: [u8; 8], value: Value) -> Option<i32> {
    let index = VEHICLE.rx.iter().position(|row| row.name == message).expect("a received message");
    let mut readings = Readings::new();
    (VEHICLE.decode)(index as u8, &data, &mut readings);
    match readings.get(value).expect("the message carries the value").0 {
        Reading::Valid(number) => Some(number),
        Reading::Invalid => None,
    }
}

fn sent(inputs: &[(Value, Reading)]) -> [u8; 8] {
    let mut values = Readings::new();
    for (value, reading) in inputs {
        values.set(Readings::LOCAL, *value, *reading);
    }
    (VEHICLE.encode)(0, &values)
}

#[test]
fn an_offset_and_a_quarter_factor_reach_the_model_exactly() {
    // (40 * 0.25 - 10) = 0 km/h, (41 * 0.25 - 10) = 0.25 km/h = 64 / 256.
    let speed = |raw| decoded("Plain", Plain::new().with_crooked_raw(raw).0, Value::VehicleSpeed);
    assert_eq!([speed(40), speed(41), speed(0)], [Some(0), Some(64), Some(-2_560)]);
    assert_eq!(
        [speed(77), speed(4_041)],
        [None, None],
        "77 is the invalid raw value, 4041 is above 1000 km/h"
    );
}

#[test]
fn a_negative_factor_and_sign_turn_the_range_round() {
    // raw -2048 * -0.5 + 3.5 = 1027.5 A; raw 2047: -1020 A.
    let current = |raw| decoded("Plain", Plain::new().with_falling_raw(raw).0, Value::BatteryCurrent);
    assert_eq!([current(-2048), current(0), current(2047)], [Some(10_275), Some(35), Some(-10_200)]);
    assert_eq!(Plain::new().with_falling_raw(-1).falling_raw(), -1);
}

#[test]
fn a_signed_nibble_keeps_its_sign() {
    let hot = |raw| decoded("Plain", Plain::new().with_signed_nibble_raw(raw).0, Value::MotorTemperature);
    assert_eq!([hot(-8), hot(-1), hot(7)], [Some(-8), Some(-1), Some(7)]);
}

#[test]
fn rounding_is_down_unless_the_table_says_nearest() {
    // 0.001 V/bit into 0.1 V: -1 mV is -0.01 steps, down is -1.
    let volts = |raw| decoded("Wide", Wide::new().with_twenty_raw(raw).0, Value::BatteryVoltage);
    assert_eq!([volts(-1), volts(99), volts(100), volts(-100)], [Some(-1), Some(0), Some(1), Some(-1)]);
    let cell = |raw| decoded("Wide", Wide::new().with_twenty_raw(raw).0, Value::BatteryCellMax);
    assert_eq!([cell(-3_650), cell(3_650)], [Some(3_650); 2], "a magnitude");
    assert_eq!(
        (codec::floor_div(-15, 10), codec::nearest_div(-15, 10), codec::nearest_div(15, 10)),
        (-2, -1, 2)
    );
}

#[test]
fn the_worst_of_a_list_counts_and_an_unknown_state_does_not_hide_a_known_one() {
    let level = |state, flag| {
        decoded("Plain", Plain::new().with_state_raw(state).with_flag_raw(flag).0, Value::VehicleFaultLevel)
    };
    assert_eq!([level(0, 0), level(1, 0), level(2, 0), level(4, 0)], [Some(0), Some(1), Some(2), Some(3)]);
    assert_eq!([level(2, 1), level(7, 1), level(7, 0)], [Some(3), Some(3), Some(0)]);
}

#[test]
fn states_may_be_numbers_invalid_or_everything_else() {
    let mode = |state| decoded("Plain", Plain::new().with_state_raw(state).0, Value::MotorFaultCode);
    assert_eq!([mode(0), mode(1), mode(2), mode(3), mode(4)], [Some(7), None, Some(5), Some(6), Some(5)]);
}

#[test]
fn rows_carry_the_options_of_the_table() {
    let plain = VEHICLE.rx.iter().find(|row| row.name == "Plain").expect("it is received");
    assert_eq!((plain.timeout_ms, plain.expected), (500, true));
    assert_eq!(plain.life, Some(Life { byte: 7, mask: 0x0F }));
    let wide = VEHICLE.rx.iter().find(|row| row.name == "Wide").expect("it is received");
    assert_eq!((wide.timeout_ms, wide.expected), (1234, false));
    assert!(VEHICLE.rx.iter().all(|row| row.name != "Full"), "it is not enabled");
    assert_eq!((VEHICLE.tx[0].cycle_ms, VEHICLE.tx[0].life), (70, Some(Life { byte: 5, mask: 0xFF })));
    assert_eq!(VEHICLE.bitrate, 500_000);
}

#[test]
fn a_number_is_sent_scaled_rounded_and_limited() {
    let speed = |reading| torture::Out(sent(&[(Value::VehicleSpeed, reading)])).speed_raw();
    // 0.375 km/h = 96 / 256 is 41.5 steps above -10 km/h: nearest is 42.
    assert_eq!([speed(Reading::Valid(0)), speed(Reading::Valid(96))], [40, 42]);
    assert_eq!([speed(Reading::Valid(i32::MAX)), speed(Reading::Valid(-9_999))], [4_040, 0]);
    assert_eq!(speed(Reading::Invalid), 0, "no invalid raw value: the start value");
}

#[test]
fn a_state_is_sent_by_the_words_that_both_sides_share() {
    let mode = |state| torture::Out(sent(&[(Value::BodyKey, Reading::Valid(state))])).mode_raw();
    assert_eq!([mode(0), mode(1), mode(2), mode(3)], [0, 1, 2, 5]);
    assert_eq!([mode(9), torture::Out(sent(&[])).mode_raw()], [3, 3], "unknown: the start value");
}

#[test]
fn bytes_without_signals_are_filled_within_the_length_only() {
    assert_eq!(torture::Short::new().0, [0, 0, 0, 0, 0, 0, 0, 0]);
    assert_eq!(torture::Empty::new().0, [0; 8], "no byte is sent");
    assert_eq!(torture::Muxed::new().0, [0, 0, 0, 0, 0xA5, 0, 0, 0]);
    assert_eq!(sent(&[])[3..5], [0xA5, 0xA5]);
}
