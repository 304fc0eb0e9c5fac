//! The vans: fault table of their battery controller, one row per alarm bit and level.
//!
//! The document prints alarm bits without thresholds; they are taken from the bus where it has them (JL-33). Smoke has
//! its levels printed (JL-R023, JL-R024). The code of a row is the place of its bit in `BMSFaults`.

use crate::fault::Edge::{Above, AtLeast, AtMost, Below, CellsAbove, CellsBelow};
use crate::fault::Quantity::*;
use crate::fault::*;
use protocol_core::model::Severity::{self, Derate, Stop, Warn};

/// Bit of the insulation fault; its level is reported apart (JL-53).
pub(super) const INSULATION_BIT: u8 = 10;

/// The table.
pub(super) const ROWS: &[Row] = &[
    row(1, Warn, 0, CellSpread, Above(0.3), Below(0.25), ALARM),
    row(2, Derate, 1, Hot, Above(60.0), Below(58.0), HALF),
    row(2, Stop, 1, Hot, Above(64.0), Below(62.0), NONE_STOP),
    row(3, Warn, 2, PackVolts, CellsAbove(3.7, 0.0), CellsBelow(3.7, -5.0), ALARM),
    row(4, Warn, 4, DischargePercent, Above(105.0), Below(100.0), HALF_DISCHARGE),
    row(5, Warn, 4, ChargePercent, Above(105.0), Below(100.0), HALF_CHARGE),
    row(6, Derate, 5, PackVolts, CellsAbove(3.75, 0.0), CellsBelow(3.7, 0.0), NO_CHARGE),
    row(7, Warn, 6, CellMax, Above(3.8), Below(3.65), HALF_CHARGE),
    row(7, Stop, 6, CellMax, Above(3.9), Below(3.7), NO_CHARGE_STOP),
    row(8, Warn, 7, CellMin, Below(2.8), Above(3.1), HALF_DISCHARGE).cold(Below(2.5), Above(2.8)),
    row(8, Stop, 7, CellMin, Below(2.4), Above(2.5), NO_DISCHARGE_STOP).cold(Below(2.2), Above(2.4)),
    row(9, Warn, 8, Soc, Below(20.0), Above(22.0), HALF_DISCHARGE),
    row(10, Derate, 9, InternalBus, YES, NO, LIMP),
    row(11, Warn, INSULATION_BIT, OhmPerVolt, Below(600.0), AtLeast(900.0), ALARM),
    row(11, Derate, INSULATION_BIT, OhmPerVolt, Below(500.0), AtLeast(900.0), HALF_DISCHARGE),
    row(11, Stop, INSULATION_BIT, OhmPerVolt, Below(400.0), AtLeast(900.0), NO_DISCHARGE_STOP),
    row(12, Warn, 11, HeatSpread, Above(20.0), Below(18.0), HALF),
    row(13, Derate, 14, CellMax, Above(3.85), Below(3.65), NO_CHARGE),
    row(14, Derate, 40, SmokeDetector, YES, NO, ALARM),
    row(15, Stop, 48, Smoke, YES, NO, OFF_STOP),
    row(16, Derate, 56, NegativeWelded, YES, NO, LIMP),
    // An event and no fault (JL-32): it has no level of its own.
    row(17, Severity::None, 3, NegativeCut, YES, NO, ALARM),
    row(18, Warn, 12, SocJump, YES, NO, ALARM),
    row(19, Derate, 13, ChargerMismatch, YES, NO, END_CHARGE).when(When::Charging),
    // More than full: the counter is off.
    row(20, Warn, 15, Soc, Above(100.0), AtMost(100.0), NO_CHARGE),
];
