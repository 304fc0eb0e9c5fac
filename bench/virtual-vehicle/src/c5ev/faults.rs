//! The car: fault table of its battery controller, one row per alarm bit.
//!
//! The document prints alarm bits without thresholds; they are taken from the bus where it has them. Stage two is worse
//! (C5-15). The code of a row is the place of its bit in `BMSD`.

use crate::fault::Edge::{self, Above, AtLeast, Below, CellsAbove, CellsBelow};
use crate::fault::Quantity::*;
use crate::fault::*;
use protocol_core::model::Severity::{Derate, Stop, Warn};

/// The table.
pub(super) const ROWS: &[Row] = &[
    row(1, Warn, 0, CellMax, Above(3.8), Below(3.65), HALF_CHARGE),
    row(1, Stop, 8, CellMax, Above(3.9), Below(3.7), NO_CHARGE_STOP),
    row(2, Warn, 1, CellMin, Below(2.8), Above(3.1), HALF_DISCHARGE).cold(Below(2.5), Above(2.8)),
    row(2, Stop, 9, CellMin, Below(2.4), Above(2.5), NO_DISCHARGE_STOP).cold(Below(2.2), Above(2.4)),
    row(3, Warn, 2, PackVolts, CellsAbove(3.7, 0.0), CellsBelow(3.7, -5.0), ALARM),
    row(3, Derate, 10, PackVolts, CellsAbove(3.75, 0.0), CellsBelow(3.7, 0.0), NO_CHARGE),
    row(4, Warn, 3, Soc, Below(20.0), Above(22.0), ALARM),
    row(4, Derate, 11, Soc, Below(10.0), Above(12.0), HALF_DISCHARGE),
    row(5, Warn, 4, DischargePercent, Above(105.0), Below(100.0), HALF_DISCHARGE),
    row(5, Derate, 12, DischargePercent, Above(120.0), Below(105.0), NO_DISCHARGE),
    row(6, Warn, 5, ChargePercent, Above(105.0), Below(100.0), HALF_CHARGE),
    row(6, Derate, 13, ChargePercent, Above(120.0), Below(105.0), NO_CHARGE),
    row(7, Warn, 6, Hot, Above(55.0), Below(53.0), HALF),
    row(7, Stop, 14, Hot, Above(60.0), Below(58.0), NONE_STOP),
    row(8, Warn, 7, Cold, Below(-20.0), Above(-18.0), ALARM),
    row(8, Derate, 15, Cold, Below(-25.0), Above(-23.0), HALF_DISCHARGE),
    row(9, Derate, 16, InternalBus, YES, NO, LIMP),
    row(10, Warn, 17, CellSpread, Above(0.3), Below(0.25), ALARM),
    row(10, Derate, 25, CellSpread, Above(0.5), Below(0.45), HALF),
    row(11, Warn, 18, PackVolts, CellsBelow(2.8, 0.0), CellsAbove(2.85, 5.0), ALARM)
        .cold(Edge::Never, Edge::Always),
    row(11, Derate, 26, PackVolts, CellsBelow(2.6, 0.0), CellsAbove(2.8, 0.0), HALF_DISCHARGE)
        .cold(Edge::Never, Edge::Always),
    row(12, Warn, 19, HeatSpread, Above(20.0), Below(18.0), HALF),
    row(12, Derate, 27, HeatSpread, Above(25.0), Below(23.0), NONE),
    row(13, Warn, 20, OhmPerVolt, Below(500.0), AtLeast(600.0), ALARM),
    row(13, Stop, 28, OhmPerVolt, Below(400.0), AtLeast(500.0), NO_DISCHARGE_STOP),
    row(14, Derate, 22, MainWelded, YES, NO, LIMP),
    row(15, Derate, 23, MainStuck, YES, NO, LIMP),
    row(16, Stop, 29, Interlock, YES, NO, OFF_STOP_PARKED),
    row(17, Derate, 30, NegativeWelded, YES, NO, LIMP),
    row(18, Derate, 31, NegativeStuck, YES, NO, LIMP),
];
