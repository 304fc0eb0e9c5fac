//! Current limits: what the cells may do by temperature and charge, cut by the faults that are active.
//!
//! Owns `charge_limit_amps` and `discharge_limit_amps`, which the vehicle controller must obey (BUS-R082). Refuses to
//! know faults one by one. Source: BUS-R081, R085 to R117.

use super::pack::along;
use crate::world::{Limits, World};

/// Limp limit in A (BUS-R081).
const LIMP_AMPS: f64 = 60.0;
/// Limp limit as a share of the rated capacity (BUS-R081).
const LIMP_RATE: f64 = 0.3;

/// Share of the largest discharge current by the coldest probe.
const DISCHARGE_BY_CELSIUS: &[(f64, f64)] = &[(-30.0, 0.2), (-20.0, 0.4), (0.0, 0.8), (10.0, 1.0)];
/// Share of the largest discharge current that pumps and converter may take, whatever the limit for driving is.
const ACCESSORIES: f64 = 0.1;
/// Share of the largest discharge current by state of charge; never none, for the pumps and the converter.
const DISCHARGE_BY_SOC: &[(f64, f64)] = &[(0.0, ACCESSORIES), (0.1, 1.0)];
/// Share of the largest charge current by the coldest probe: below freezing lithium would plate.
const CHARGE_BY_CELSIUS: &[(f64, f64)] = &[(0.0, 0.0), (2.0, 0.2), (15.0, 1.0)];
/// Share of the largest charge current by state of charge.
const CHARGE_BY_SOC: &[(f64, f64)] = &[(0.96, 1.0), (1.0, 0.25)];

/// What active faults leave of the allowance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Allowed {
    /// Share of the charge current.
    pub(super) charge: f64,
    /// Share of the discharge current.
    pub(super) discharge: f64,
    /// Share of both that a current over its limit leaves: charge and discharge.
    pub(super) over_limit: (f64, f64),
    /// Runs at the limp limit.
    pub(super) limp: bool,
}

impl Default for Allowed {
    fn default() -> Self {
        Self { charge: 1.0, discharge: 1.0, over_limit: (1.0, 1.0), limp: false }
    }
}

impl Allowed {
    /// Nothing is allowed.
    pub(super) fn none() -> Self {
        Self { charge: 0.0, discharge: 0.0, over_limit: (1.0, 1.0), limp: false }
    }
}

/// Charge current that the cells themselves allow, in A.
pub(super) fn charge_allowance(world: &World) -> f64 {
    let cold = world.bms.cold.value;
    world.spec.battery.charge_amps * along(CHARGE_BY_CELSIUS, cold).min(along(CHARGE_BY_SOC, world.pack.soc))
}

/// Discharge current that the cells themselves allow, in A.
pub(super) fn discharge_allowance(world: &World) -> f64 {
    let cold = world.bms.cold.value;
    world.spec.battery.discharge_amps
        * along(DISCHARGE_BY_CELSIUS, cold).min(along(DISCHARGE_BY_SOC, world.pack.soc))
}

/// Cuts the allowance of the cells by what the faults leave.
///
/// What a current over its limit costs is kept apart: that fault is judged by the limit as the others leave it, or it
/// would never clear (BUS-R102 to R105).
pub(super) fn step(world: &mut World, allowed: &Allowed) {
    let limp = LIMP_AMPS.min(LIMP_RATE * world.pack.capacity_ah);
    let cut = |amps: f64| if allowed.limp { amps.min(limp) } else { amps };
    let (charge, discharge) =
        (charge_allowance(world) * allowed.charge, discharge_allowance(world) * allowed.discharge);
    let bms = &mut world.bms;
    bms.limits = Limits { charge_amps: charge, discharge_amps: cut(discharge) };
    bms.charge_limit_amps = charge * allowed.over_limit.0;
    bms.discharge_limit_amps = cut(discharge * allowed.over_limit.1);
}

/// Keeps the limits that a frame has just told.
pub(crate) fn sent(world: &mut World) {
    let bms = &mut world.bms;
    bms.sent_limits = [Some(bms.limits), bms.sent_limits[0]];
}

/// Limits that the vehicle has had time to obey: of the last two frames the more generous, and for discharge what pumps
/// and converter take at least (V-7). `None` = none was told.
pub(super) fn obeyed(world: &World) -> Option<Limits> {
    let [later, earlier] = world.bms.sent_limits;
    let (later, earlier) = (later?, earlier.or(later)?);
    Some(Limits {
        charge_amps: later.charge_amps.max(earlier.charge_amps),
        discharge_amps: later
            .discharge_amps
            .max(earlier.discharge_amps)
            .max(ACCESSORIES * world.spec.battery.discharge_amps),
    })
}
