//! Chimes: what calls for a sound, which one wins, what silences it.

use crate::support::toy::*;
use crate::support::*;
use cluster::{Button, Sound};
use protocol_core::Value;
use protocol_core::{Millis, Severity};

const D: u8 = 1;
const R: u8 = 2;
const N: u8 = 3;

/// Returns how long after now the reversing chime begins, within three seconds.
fn reverse_after(drive: &mut Drive) -> Option<u64> {
    let start = drive.now;
    (0..3_000 / TICK).find_map(|_| {
        drive.run(TICK);
        (drive.sound() == Some(Sound::Reverse)).then(|| drive.now.since(start) - TICK)
    })
}

#[test]
fn bus_r017_the_reversing_chime_sounds_after_two_seconds_of_r() {
    let mut drive = healthy();
    drive.gear_and_speed(R, 0);
    assert_eq!(reverse_after(&mut drive), Some(2_000));
    assert_eq!(drive.view().gear, Some(protocol_core::model::Gear::R));
}

#[test]
fn bus_r016_the_letter_follows_at_once() {
    let mut drive = healthy();
    drive.send(DRIVE, [R, 0, 0, 0, 0, 0, 0, 99]);
    assert_eq!(drive.cluster.view(drive.now).gear, Some(protocol_core::model::Gear::R), "without any tick");
}

#[test]
fn bus_37_any_other_gear_starts_the_two_seconds_again() {
    let mut drive = healthy();
    drive.gear_and_speed(R, 0);
    drive.run(1_900);
    // A single frame of N between two ticks.
    drive.send(DRIVE, [N, 0, 0, 0, 0, 0, 0, 201]);
    drive.send(DRIVE, [R, 0, 0, 0, 0, 0, 0, 202]);
    assert_eq!(reverse_after(&mut drive), Some(2_000));
}

#[test]
fn bus_37_silence_starts_the_two_seconds_again() {
    let mut drive = healthy();
    drive.gear_and_speed(R, 0);
    drive.run(1_500);
    drive.stop(DRIVE);
    drive.run(DRIVE_TIMEOUT);
    drive.gear_and_speed(R, 0);
    assert_eq!(reverse_after(&mut drive), Some(2_000));
}

#[test]
fn bus_37_silence_without_any_tick_counts_too() {
    let mut drive = Drive::of(&TOY);
    let frame = |life| [R, 0, 0, 0, 0, 0, 0, life];
    drive.send(DRIVE, frame(1));
    drive.now = Millis(DRIVE_TIMEOUT);
    drive.send(DRIVE, frame(2));
    for (step, life) in (0..16).zip(3..) {
        drive.now = Millis(DRIVE_TIMEOUT + step * CYCLE);
        drive.send(DRIVE, frame(life));
    }
    drive.now = Millis(2_010);
    drive.cluster.tick(&drive.inputs, drive.now);
    assert_eq!(drive.cluster.chime(drive.now), None, "R since {DRIVE_TIMEOUT} ms only");
}

#[test]
fn bus_37_the_chime_ends_with_r_at_once() {
    for gear in [0, D, N, 4, 11, 99] {
        let mut drive = healthy();
        drive.gear_and_speed(R, 0);
        drive.run(2_500);
        assert_eq!(drive.sound(), Some(Sound::Reverse));
        drive.gear_and_speed(gear, 0);
        drive.run(TICK);
        assert_eq!(drive.sound(), None, "gear {gear}");
    }
}

#[test]
fn bus_112_every_level_sounds_until_it_returns_to_none() {
    for (level, sound) in [(1, Sound::Warn), (2, Sound::Derate), (3, Sound::Stop)] {
        let mut drive = healthy();
        drive.report(level, 0);
        drive.run(TICK);
        assert_eq!(drive.sound(), Some(sound), "BUS-R050");
        drive.run(30_000);
        assert_eq!(drive.sound(), Some(sound));
        drive.report(0, 0);
        drive.run(CYCLE);
        assert_eq!(drive.sound(), None);
    }
}

#[test]
fn jl_r013_a_stop_fault_of_any_of_three_nodes_is_on_the_screen_with_a_sound() {
    type Fault = fn(&mut Drive);
    let nodes: [(Fault, &str); 3] = [
        (|drive| drive.report(3, 0), "System fault level 3"),
        (|drive| drive.battery_report(3, 0), "Battery fault level 3"),
        (|drive| drive.repeat(MOTOR, [0, 0, 0, 0, 40, 50, 3, 0]), "Motor system fault"),
    ];
    for (fault, text) in nodes {
        let mut drive = healthy();
        fault(&mut drive);
        drive.run(CYCLE);
        assert_eq!(drive.line(), Some((text, None)));
        assert_eq!(drive.view().severity, Severity::Stop);
        assert_eq!(drive.sound(), Some(Sound::Stop));
    }
}

#[test]
fn smoke_stops_the_vehicle_with_a_sound() {
    let mut drive = healthy();
    drive.inputs.contacts.set(Value::BodySmoke, true);
    drive.run(TICK);
    assert_eq!(drive.line(), Some(("Smoke alarm", None)));
    assert_eq!(drive.sound(), Some(Sound::Stop));
    drive.inputs.contacts.set(Value::BodySmoke, false);
    drive.run(TICK);
    assert_eq!((drive.line(), drive.sound()), (None, None));
}

#[test]
fn acknowledging_silences_the_sound_not_the_line() {
    let mut drive = healthy();
    drive.report(3, 4);
    drive.run(TICK);
    let line = drive.line();
    drive.cluster.press(Button::Next, drive.now);
    assert_eq!(drive.sound(), None);
    assert_eq!(drive.line(), line);
    drive.run(20_000);
    assert_eq!(drive.sound(), None);
    assert!(drive.line().is_some());
}

#[test]
fn a_new_fault_sounds_again_after_acknowledging() {
    let mut drive = healthy();
    drive.report(1, 500);
    drive.run(TICK);
    drive.cluster.press(Button::Next, drive.now);
    drive.battery_report(1, 3);
    drive.run(CYCLE);
    assert_eq!(drive.sound(), Some(Sound::Warn));
}

#[test]
fn a_fault_that_worsens_or_returns_sounds_again_after_acknowledging() {
    let mut drive = healthy();
    drive.report(1, 500);
    drive.run(CYCLE);
    drive.cluster.press(Button::Next, drive.now);
    drive.report(2, 500);
    drive.run(CYCLE);
    assert_eq!(drive.sound(), Some(Sound::Derate), "worse");
    drive.cluster.press(Button::Next, drive.now);
    drive.report(0, 0);
    drive.run(CYCLE);
    drive.report(1, 500);
    drive.run(CYCLE);
    assert_eq!(drive.sound(), Some(Sound::Warn), "back again");
}

#[test]
fn bus_r079_fire_sounds_above_all_and_cannot_be_silenced() {
    let mut drive = healthy();
    drive.gear_and_speed(R, 0);
    drive.run(2_500);
    drive.report(3, 24);
    drive.run(CYCLE);
    assert_eq!(drive.sound(), Some(Sound::Fire));
    drive.cluster.press(Button::Next, drive.now);
    drive.run(60_000);
    assert_eq!(drive.sound(), Some(Sound::Fire));
}

#[test]
fn the_most_urgent_sound_wins() {
    let mut drive = healthy();
    drive.gear_and_speed(R, 0);
    drive.run(2_500);
    for (level, sound) in [(1, Sound::Reverse), (2, Sound::Reverse), (3, Sound::Stop), (0, Sound::Reverse)] {
        drive.report(level, 0);
        drive.run(CYCLE);
        assert_eq!(drive.sound(), Some(sound), "level {level}");
    }
}

#[test]
fn the_button_does_not_silence_the_reversing_chime() {
    let mut drive = healthy();
    drive.gear_and_speed(R, 0);
    drive.run(2_500);
    drive.cluster.press(Button::Next, drive.now);
    drive.run(CYCLE);
    assert_eq!(drive.sound(), Some(Sound::Reverse));
}

#[test]
fn bus_37_a_push_long_after_the_last_r_starts_no_chime() {
    let mut drive = healthy();
    drive.gear_and_speed(R, 0);
    drive.report(3, 0);
    drive.run(CYCLE);
    // No tick in between: the push is the first to see the silence.
    drive.now = drive.now.after(9_000);
    drive.cluster.press(Button::Next, drive.now);
    assert_eq!(drive.cluster.chime(drive.now), None);
}

#[test]
fn a_sound_begins_with_a_tone_and_keeps_its_rhythm() {
    let mut drive = healthy();
    drive.run(70);
    drive.report(2, 0);
    drive.run(30);
    let start = drive.now;
    drive.run(TICK);
    let chime = drive.cluster.chime(start).expect("a fault sounds");
    let period = u64::from(chime.on_ms) + u64::from(chime.off_ms);
    for ms in 0..3 * period {
        let now = drive.cluster.chime(start.after(ms)).expect("it goes on");
        assert_eq!(now.is_on, ms % period < u64::from(chime.on_ms), "{ms} ms");
    }
    // The ticks in between do not disturb it.
    drive.run(3 * period + u64::from(chime.on_ms));
    assert_eq!(drive.cluster.chime(drive.now).map(|chime| chime.is_on), Some(false));
    drive.run(u64::from(chime.off_ms));
    assert_eq!(drive.cluster.chime(drive.now).map(|chime| chime.is_on), Some(true));
}

#[test]
fn every_sound_has_a_public_name_and_no_two_the_same() {
    let keys: std::collections::BTreeSet<_> = Sound::ALL.iter().map(|sound| sound.key()).collect();
    assert_eq!(keys.len(), Sound::ALL.len());
    assert!(keys.iter().all(|key| key.chars().all(|one| one.is_ascii_lowercase())), "{keys:?}");
}
