//! The insulation monitor: resistance to the body, and the level that it reports.
//!
//! Sits in the battery's own box and answers under its own address all the same (BUS-R144, BUS-101). The limits are
//! those of GB 18384: 500 ohm per volt of the present voltage warns, 100 is dangerous (V-11); the battery judges by its
//! own table.

use crate::world::World;

/// A sound vehicle, in kilo-ohm.
const SOUND_KILOOHM: f64 = 5_000.0;
/// Ohm per volt below which level 1 and level 2 are reported.
const OHM_PER_VOLT: (f64, f64) = (500.0, 100.0);

/// Measures.
pub(super) fn step(world: &mut World) {
    let monitor = &mut world.insulation;
    monitor.positive_kiloohm = monitor.kiloohm_override.unwrap_or(SOUND_KILOOHM);
    monitor.negative_kiloohm = SOUND_KILOOHM;
    monitor.device_fault = monitor.fault_code != 0;
    let volts = world.pack.volts.max(1.0);
    let ohm_per_volt = 1_000.0 * monitor.positive_kiloohm.min(monitor.negative_kiloohm) / volts;
    monitor.level = match ohm_per_volt {
        low if low < OHM_PER_VOLT.1 => 2,
        low if low < OHM_PER_VOLT.0 => 1,
        _ => 0,
    };
}
