//! The vehicle controller's own fault list: which severity, which code, what follows.
//!
//! Three levels; only codes of the worst are sent (BUS-R026, R027, R029), one second each (BUS-R028, BUS-33). The codes
//! are a person's: the table of their meanings is in another paper (BUS-08). The buzzer of the car stops after two
//! minutes while its lamps stay (C5-R014).

use crate::world::World;
use crate::{Kind, STEP_MS};
use protocol_core::model::Severity;
use protocol_core::vehicle::Node;

/// Each of several codes is sent for this long.
const ROTATION_MS: u64 = 1_000;
/// Silence of the battery after which it is lost (BUS-R080).
pub(super) const BMS_LOST_MS: u64 = 5_000;
/// The buzzer sounds for this long (C5-R014).
pub(super) const BUZZER_MS: u64 = 120_000;

/// Severities in the order of [`crate::world::Vcu::set_codes`].
const SEVERITIES: [Severity; 3] = [Severity::Warn, Severity::Derate, Severity::Stop];

/// Judges what is wrong.
pub(super) fn step(world: &mut World) {
    list(world);
    world.vcu.limp = world.links.silence_ms(Node::Vcu, Node::Bms) >= BMS_LOST_MS;
    let vcu = &mut world.vcu;
    vcu.system_fault = vcu.severity > Severity::None
        || vcu.limp
        || vcu.heard.severity >= Severity::Derate
        || world.insulation.level > 0
        || world.motor.fault_code != 0
        || world.motor.protections != 0;
    let alarm = alarms(world);
    let vcu = &mut world.vcu;
    vcu.spans.buzzer_ms = if alarm { vcu.spans.buzzer_ms.saturating_add(STEP_MS) } else { 0 };
    vcu.buzzer = alarm && vcu.spans.buzzer_ms <= BUZZER_MS;
}

/// There is a reason for the car's buzzer.
pub(super) fn alarms(world: &World) -> bool {
    world.kind == Kind::C5ev
        && (world.vcu.severity >= Severity::Derate
            || world.vcu.heard.severity >= Severity::Derate
            || world.vcu.limp
            || world.insulation.level > 0
            || world.motor.fault_code != 0)
}

/// Puts the list together and picks the code that is sent now.
fn list(world: &mut World) {
    let vcu = &mut world.vcu;
    let codes = |severity: usize| vcu.set_codes[severity].into_iter().filter(|code| *code != 0);
    let before = vcu.severity;
    let faults: Vec<_> = (0..SEVERITIES.len())
        .rev()
        .flat_map(|row| codes(row).map(move |code| (code, SEVERITIES[row])))
        .collect();
    vcu.severity = faults.first().map_or(Severity::None, |(_, severity)| *severity);
    let worst: Vec<_> = faults.iter().filter(|(_, severity)| *severity == vcu.severity).collect();
    vcu.spans.rotation_ms =
        if vcu.severity == before { vcu.spans.rotation_ms.saturating_add(STEP_MS) } else { 0 };
    let turn = vcu.spans.rotation_ms / ROTATION_MS % worst.len().max(1) as u64;
    vcu.code = worst.get(turn as usize).map_or(0, |(code, _)| *code);
    vcu.faults = faults;
}
