//! What is wrong in the vehicle, as the vehicle controller judges and reports it.
//!
//! Three levels; only codes of the worst are sent (BUS-R026, R027, R029), one second each (BUS-R028, BUS-33). Its own
//! codes are a person's: the table of their meanings is in another paper (BUS-08). The battery's codes are forwarded
//! (BUS-R072, BUS-77): those of its level that have been heard within a turn. The buzzer of the car stops after two
//! minutes while its lamps stay (C5-R014).

use crate::STEP_MS;
use crate::spec::Spec;
use crate::world::{Vcu, World};
use protocol_core::model::Severity;

/// Each of several codes is sent for this long.
const ROTATION_MS: u64 = 1_000;
/// A code of the battery that has not come for this long beyond a whole turn of its codes has gone: two of its cycles.
const CODE_GONE_MS: u64 = 1_000;
/// Silence of the battery after which it is lost: the bit has to be on the bus within 5 s, at the latest a cycle of VCU1
/// and a step later (BUS-R080).
pub(super) const BMS_LOST_MS: u64 = 4_900;
/// The buzzer sounds for this long (C5-R014).
pub(super) const BUZZER_MS: u64 = 120_000;

/// Severities in the order of [`crate::world::Vcu::set_codes`].
const SEVERITIES: [Severity; 3] = [Severity::Warn, Severity::Derate, Severity::Stop];

/// Judges what is wrong.
pub(super) fn step(world: &mut World) {
    let spec = world.spec;
    listen(world);
    report(world, spec);
    world.vcu.limp = world.vcu.heard.battery_silence_ms >= BMS_LOST_MS;
    let hears_motor = super::power_up::hears_motor(world);
    let worst = worst(world);
    let vcu = &mut world.vcu;
    let heard = &vcu.heard;
    vcu.system_fault = worst > Severity::None
        || vcu.limp
        || !hears_motor
        || heard.parts.leak > Severity::None
        || heard.motor.fault_code != 0
        || heard.motor.protections != 0;
    let alarm = alarms(world);
    let vcu = &mut world.vcu;
    vcu.spans.buzzer_ms = if alarm { vcu.spans.buzzer_ms.saturating_add(STEP_MS) } else { 0 };
    vcu.buzzer = alarm && vcu.spans.buzzer_ms <= BUZZER_MS;
}

/// There is a reason for the car's buzzer.
pub(super) fn alarms(world: &World) -> bool {
    let vcu = &world.vcu;
    world.spec.has_buzzer
        && (worst(world) >= Severity::Derate
            || vcu.limp
            || vcu.heard.parts.leak > Severity::None
            || vcu.heard.motor.fault_code != 0)
}

/// Worst of its own faults and of the battery's.
pub(super) fn worst(world: &World) -> Severity {
    world.vcu.severity.max(world.vcu.heard.battery.severity)
}

/// How bad the battery is, as last heard: by its level, and without that by the level that the code has in the table.
fn battery_severity(world: &World, spec: &Spec) -> Severity {
    let heard = &world.vcu.heard;
    if heard.level_silence_ms < BMS_LOST_MS {
        return heard.battery.severity;
    }
    let codes = world.vcu.battery_codes.iter();
    codes.filter_map(|(code, _)| level_of(spec, *code)).max().unwrap_or(heard.battery.severity)
}

/// Level that a code has in the battery's table; `None` = it is not in there.
fn level_of(spec: &Spec, code: u16) -> Option<Severity> {
    spec.faults.iter().find(|row| u16::from(row.code) == code).map(|row| row.severity)
}

/// Keeps the list of the battery's codes: in with a frame, out when a whole turn has passed without.
fn listen(world: &mut World) {
    let vcu = &mut world.vcu;
    let turn_ms = ROTATION_MS * vcu.battery_codes.len() as u64 + CODE_GONE_MS;
    for (_, age_ms) in &mut vcu.battery_codes {
        *age_ms = age_ms.saturating_add(STEP_MS);
    }
    match vcu.heard.battery.code {
        None => {}
        Some(0) => vcu.battery_codes.clear(),
        Some(code) => {
            vcu.battery_codes.retain(|(other, age_ms)| *other != code && *age_ms <= turn_ms);
            vcu.battery_codes.push((code, 0));
        }
    }
}

/// Puts the list together and picks the code that is sent now.
fn report(world: &mut World, spec: &Spec) {
    let own = |row: usize| world.vcu.set_codes[row].into_iter().filter(|code| *code != 0);
    let own_severity = (0..SEVERITIES.len()).rev().find(|row| own(*row).next().is_some());
    let own_severity = own_severity.map_or(Severity::None, |row| SEVERITIES[row]);
    let battery = if spec.forwards_battery { battery_severity(world, spec) } else { Severity::None };
    let severity = own_severity.max(battery);
    let mut codes: Vec<u16> =
        SEVERITIES.iter().position(|of| *of == severity).map(|row| own(row).collect()).unwrap_or_default();
    if battery == severity && severity > Severity::None {
        // A code of another level belongs to what the battery said before.
        let fits = |code: u16| level_of(spec, code).is_none_or(|level| level == severity);
        codes.extend(world.vcu.battery_codes.iter().map(|(code, _)| *code).filter(|code| fits(*code)));
    }
    codes.sort_unstable();
    codes.dedup();
    let vcu = &mut world.vcu;
    vcu.own_severity = own_severity;
    vcu.severity = severity;
    take_turns(vcu, &codes);
}

/// Sends each code for its time; one that joins waits for its turn, one that leaves hands over at once.
fn take_turns(vcu: &mut Vcu, codes: &[u16]) {
    let place = codes.iter().position(|code| *code == vcu.code);
    vcu.spans.rotation_ms = vcu.spans.rotation_ms.saturating_add(STEP_MS);
    let next = match place {
        Some(_) if vcu.spans.rotation_ms < ROTATION_MS => Some(vcu.code),
        Some(place) => Some(codes[(place + 1) % codes.len()]),
        None => codes.first().copied(),
    };
    if place.is_none() || vcu.spans.rotation_ms >= ROTATION_MS {
        vcu.spans.rotation_ms = 0;
    }
    vcu.code = next.unwrap_or(0);
}
