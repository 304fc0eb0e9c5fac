//! Driving without word from the battery: limp home, no regeneration, little current.
//!
//! The vehicle controller limits itself and the battery limits its current; the cluster tells the driver what holds.
//! A function of what is known now, with no memory of its own. When everything is silent, the cluster's own wire is
//! the likelier cause and nothing is said of the vehicle.
//! Source: BUS-R080, BUS-R081; reading BUS-81 (5 s on both sides; 0.3C of the rated capacity).

use protocol_core::states::Mode;

/// Silence of the battery after which the vehicle limps, in milliseconds.
pub(crate) const LOSS_MS: u64 = 5_000;

/// Largest current in limp mode, in 0.1 A.
const MOST_DECIAMPS: i32 = 600;
/// 0.3C in 0.1 A for each Ah of rated capacity.
const DECIAMPS_PER_AH: i32 = 3;

/// What is known of the link between battery and vehicle controller.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link {
    /// An expected message of the battery is missing, for this long since its last sign of life, in milliseconds.
    pub(crate) battery_silent_ms: Option<u64>,
    /// The vehicle controller is silent too.
    pub(crate) vehicle_silent: bool,
    /// Mode that the vehicle controller reports, fresh.
    pub(crate) mode: Option<i32>,
}

impl Link {
    /// Returns whether the vehicle limps, as far as the cluster can tell.
    pub(crate) fn limps(self) -> bool {
        let lost = self.battery_silent_ms.is_some_and(|silent_ms| silent_ms >= LOSS_MS);
        lost && !self.vehicle_silent || self.mode == Some(Mode::Limp.number())
    }
}

/// Returns the current limit in 0.1 A for a rated capacity in Ah: the smaller of 60 A and 0.3C (BUS-R081).
pub(crate) fn limit_deciamps(capacity_ah: i32) -> Option<i32> {
    (capacity_ah > 0).then(|| capacity_ah.saturating_mul(DECIAMPS_PER_AH).min(MOST_DECIAMPS))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bus_r080_the_vehicle_limps_five_seconds_after_the_battery_s_last_word() {
        for silent_ms in [None, Some(0), Some(4_999), Some(5_000), Some(5_001), Some(u64::MAX)] {
            for vehicle_silent in [false, true] {
                for mode in [None, Some(0), Some(2), Some(4), Some(5), Some(6)] {
                    let link = Link { battery_silent_ms: silent_ms, vehicle_silent, mode };
                    // Said by the vehicle itself, or concluded while the vehicle is heard and the battery is not.
                    let stated = match (mode, vehicle_silent, silent_ms) {
                        (Some(5), ..) => true,
                        (_, true, _) | (_, false, None) => false,
                        (_, false, Some(ms)) => ms / 1_000 >= 5,
                    };
                    assert_eq!(link.limps(), stated, "{link:?}");
                }
            }
        }
    }

    #[test]
    fn bus_r081_the_limit_is_the_smaller_of_60_amperes_and_three_tenths_of_the_capacity() {
        for capacity in 1..=2_000 {
            let limit = f64::from(limit_deciamps(capacity).unwrap_or(-1)) / 10.0;
            let stated = f64::min(60.0, 0.3 * f64::from(capacity));
            assert!((limit - stated).abs() < 1e-9, "{capacity} Ah: {limit} A, not {stated} A");
        }
        assert_eq!(limit_deciamps(i32::MAX), Some(600));
        assert_eq!([0, -5].map(limit_deciamps), [None, None], "no battery has no capacity");
    }
}
