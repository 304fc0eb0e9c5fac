//! Driving without word from the battery: limp home, no regeneration, little current.
//!
//! The vehicle controller limits itself and the battery limits its current; the cluster tells the driver what holds.
//! Which silence and which limit, the vehicle's document prints; without, nothing is concluded. A function of what is
//! known now, with no memory of its own. When everything is silent, the cluster's own wire is
//! the likelier cause and nothing is said of the vehicle.
//! Source: BUS-R080, BUS-R081; reading BUS-81 (5 s on both sides; 0.3C of the rated capacity).

use protocol_core::vehicle::LimpRule;

/// What is known of the link between battery and vehicle controller.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link {
    /// What the vehicle's document prints; `None` = nothing follows from silence.
    pub(crate) rule: Option<LimpRule>,
    /// An expected message of the battery is missing, for this long since its last sign of life, in milliseconds.
    pub(crate) battery_silent_ms: Option<u64>,
    /// The vehicle controller is silent too.
    pub(crate) vehicle_silent: bool,
}

impl Link {
    /// Returns whether the vehicle limps, as far as the cluster can tell.
    pub(crate) fn limps(self) -> bool {
        let silence = self.battery_silent_ms.zip(self.rule);
        let lost = silence.is_some_and(|(silent_ms, rule)| silent_ms >= u64::from(rule.silence_ms));
        lost && !self.vehicle_silent
    }
}

/// Returns the current limit in 0.1 A for a rated capacity in Ah: the smaller of a current and a rate (BUS-R081).
pub(crate) fn limit_deciamps(rule: LimpRule, capacity_ah: i32) -> Option<i32> {
    (capacity_ah > 0).then(|| capacity_ah.saturating_mul(rule.deciamps_per_ah).min(rule.most_deciamps))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BUS: LimpRule = LimpRule { silence_ms: 5_000, most_deciamps: 600, deciamps_per_ah: 3 };

    #[test]
    fn bus_r080_the_vehicle_limps_five_seconds_after_the_battery_s_last_word() {
        for silent_ms in [None, Some(0), Some(4_999), Some(5_000), Some(5_001), Some(u64::MAX)] {
            for vehicle_silent in [false, true] {
                for rule in [None, Some(BUS)] {
                    let link = Link { rule, battery_silent_ms: silent_ms, vehicle_silent };
                    // Concluded while the vehicle is heard and the battery is not, if the document says so.
                    let stated = match (rule, vehicle_silent, silent_ms) {
                        (None, ..) | (_, true, _) | (_, false, None) => false,
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
            let limit = f64::from(limit_deciamps(BUS, capacity).unwrap_or(-1)) / 10.0;
            let stated = f64::min(60.0, 0.3 * f64::from(capacity));
            assert!((limit - stated).abs() < 1e-9, "{capacity} Ah: {limit} A, not {stated} A");
        }
        assert_eq!(limit_deciamps(BUS, i32::MAX), Some(600));
        assert_eq!(
            [0, -5].map(|capacity| limit_deciamps(BUS, capacity)),
            [None, None],
            "no battery has no capacity"
        );
    }
}
