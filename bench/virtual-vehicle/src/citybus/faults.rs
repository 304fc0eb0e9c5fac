//! The city bus: fault table of its battery controller, one row per fault and level.
//!
//! The twenty faults of the document (BUS-R085 to R117). Cells of the table that are cut off (BUS-78): fault 1 clears
//! below 3.65 V; fault 3 clears 2 degrees above, like every temperature of the table; fault 8 is not monitored in the
//! cold, where its one threshold is an ordinary voltage; fault 12 clears on all levels where level 3 does; fault 18
//! clears with the first frame.

use crate::fault::Edge::{self, Above, AtLeast, AtMost, Below, CellsAbove, CellsBelow, Outside, Within};
use crate::fault::Quantity::*;
use crate::fault::*;
use protocol_core::model::Severity::{Derate, Stop, Warn};

/// Code of the fire alarm (BUS-R117).
pub(super) const FIRE_CODE: u8 = 24;

/// The table.
pub(super) const ROWS: &[Row] = &[
    row(1, Warn, 102, CellMax, Above(3.8), Below(3.65), HALF_CHARGE),
    row(1, Derate, 52, CellMax, Above(3.85), Below(3.65), NO_CHARGE),
    row(1, Stop, 3, CellMax, Above(3.9), Below(3.7), NO_CHARGE_STOP),
    row(2, Warn, 103, CellMin, Below(2.8), Above(3.1), HALF_DISCHARGE).cold(Below(2.5), Above(2.8)),
    row(2, Derate, 53, CellMin, Below(2.5), Above(2.8), NO_DISCHARGE).cold(Below(2.3), Above(2.5)),
    row(2, Stop, 4, CellMin, Below(2.4), Above(2.5), NO_DISCHARGE_STOP).cold(Below(2.2), Above(2.4)),
    row(3, Warn, 106, Cold, Below(-25.0), Above(-23.0), ALARM),
    row(4, Warn, 105, Hot, Above(55.0), Below(53.0), HALF),
    row(4, Derate, 55, Hot, Above(60.0), Below(58.0), NONE),
    row(4, Stop, 6, Hot, Above(64.0), Below(62.0), NONE_STOP),
    row(5, Warn, 104, CellSpread, Above(0.3), Below(0.25), ALARM).when(When::Driving),
    row(6, Warn, 108, Soc, Below(20.0), Above(22.0), HALF_DISCHARGE),
    row(7, Warn, 100, PackVolts, CellsAbove(3.7, 0.0), CellsBelow(3.7, -5.0), ALARM),
    row(8, Warn, 101, PackVolts, CellsBelow(2.6, 0.0), CellsAbove(2.85, 5.0), ALARM)
        .cold(Edge::Never, Edge::Always),
    row(9, Warn, 107, HeatSpread, Above(20.0), Below(18.0), HALF),
    row(9, Derate, 57, HeatSpread, Above(25.0), Below(23.0), NONE),
    row(9, Stop, 8, HeatSpread, Above(30.0), Below(28.0), NONE_STOP),
    row(10, Warn, 110, DischargePercent, Above(105.0), Below(100.0), HALF_DISCHARGE),
    row(11, Warn, 111, ChargePercent, Above(105.0), Below(100.0), HALF_CHARGE),
    row(11, Derate, 61, ChargePercent, Above(120.0), Below(105.0), NO_CHARGE),
    row(11, Stop, 12, ChargePercent, Above(125.0), Below(105.0), NONE_STOP),
    row(12, Warn, 112, OhmPerVolt, Below(600.0), AtLeast(900.0), HALF).when(When::Driving),
    row(12, Derate, 62, OhmPerVolt, Below(500.0), AtLeast(900.0), NO_DISCHARGE).when(When::Driving),
    row(12, Stop, 13, OhmPerVolt, Below(400.0), AtLeast(900.0), NO_DISCHARGE_STOP).when(When::Driving),
    row(13, Derate, 72, MainContactor, YES, NO, LIMP),
    row(14, Stop, 0, Supply, Outside(18.0, 32.0), Within(19.0, 31.0), OFF_STOP),
    row(15, Derate, 63, InternalBus, YES, NO, LIMP),
    row(16, Stop, 20, Interlock, YES, NO, OFF_STOP_PARKED),
    row(17, Warn, 74, Socket, Above(100.0), AtMost(95.0), HALF_CHARGE).when(When::Charging),
    row(17, Derate, 23, Socket, Above(120.0), AtMost(110.0), END_CHARGE).when(When::Charging),
    row(18, Derate, 70, VcuSilence, AtLeast(5_000.0), Below(5_000.0), LIMP).when(When::Driving),
    row(19, Derate, 64, CurrentSensor, YES, NO, LIMP),
    row(20, Stop, FIRE_CODE, Hot, AtLeast(75.0), Edge::Never, OFF_STOP_PARKED),
];

/// Extreme faults, and the fire warning (BUS-R073 to R078).
pub(super) const EXTREMES: &[ExtremeRow] = &[
    ExtremeRow { of: CellMax, set: Above(4.1), cold: Above(4.1) },
    ExtremeRow { of: CellMin, set: Below(2.3), cold: Below(2.1) },
    ExtremeRow { of: Hot, set: Above(65.0), cold: Above(65.0) },
    ExtremeRow { of: Hot, set: AtLeast(75.0), cold: AtLeast(75.0) },
];
