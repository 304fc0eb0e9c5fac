//! Fault tables: one row per fault and level of each battery controller.
//!
//! The bus's rows are the twenty faults of its document (BUS-R085 to R117); jiulong and c5ev print alarm bits without
//! thresholds, theirs are taken from the bus where it has them (JL-33, C5-15). Refuses to act: `monitor` walks the rows.
//! Cells of the bus's table that are cut off (BUS-78): fault 1 clears below 3.65 V; fault 3 clears 2 degrees above, like
//! every temperature of the table; fault 8 is not monitored in the cold, where its one threshold is an ordinary voltage;
//! fault 12 clears on all levels where level 3 does; fault 18 clears with the first frame.

use crate::Kind;
use protocol_core::model::Severity::{self, Derate, Stop, Warn};

/// What a row looks at, in the unit of its thresholds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    /// Highest cell voltage in V.
    CellMax,
    /// Lowest cell voltage in V.
    CellMin,
    /// Highest less lowest cell voltage in V.
    CellSpread,
    /// Total voltage in V.
    PackVolts,
    /// Highest probe in degrees Celsius.
    Hot,
    /// Lowest probe in degrees Celsius.
    Cold,
    /// Highest less lowest probe in kelvin.
    HeatSpread,
    /// State of charge in percent.
    Soc,
    /// Discharge current in percent of what the cells allow.
    DischargePercent,
    /// Charge current in percent of what the cells allow.
    ChargePercent,
    /// Insulation of the worse side in ohm per volt of the pack.
    OhmPerVolt,
    /// Low-voltage supply in V.
    Supply,
    /// Charge socket in degrees Celsius.
    Socket,
    /// Silence of the vehicle controller in ms.
    VcuSilence,
    /// 1 = contact, coil or its driver has a fault.
    MainContactor,
    /// 1 = main positive does not open.
    MainWelded,
    /// 1 = main positive does not close.
    MainStuck,
    /// 1 = main negative does not open.
    NegativeWelded,
    /// 1 = main negative does not close.
    NegativeStuck,
    /// 1 = a measuring board is silent.
    InternalBus,
    /// 1 = the interlock loop is open.
    Interlock,
    /// 1 = the current sensor is broken.
    CurrentSensor,
    /// 1 = the smoke detector gives alarm.
    Smoke,
    /// 1 = the smoke detector is broken.
    SmokeDetector,
    /// 1 = the controller has cut the main negative.
    NegativeCut,
    /// 1 = the state of charge has jumped.
    SocJump,
    /// 1 = the charger is made for another battery.
    ChargerMismatch,
}

/// A threshold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Edge {
    /// Greater than.
    Above(f64),
    /// Less than.
    Below(f64),
    /// Greater than or equal.
    AtLeast(f64),
    /// Less than or equal.
    AtMost(f64),
    /// Less than the first or greater than the second.
    Outside(f64, f64),
    /// From the first to the second, both included.
    Within(f64, f64),
    /// Greater than the first times the number of cells plus the second.
    CellsAbove(f64, f64),
    /// Less than the first times the number of cells plus the second.
    CellsBelow(f64, f64),
    /// Whatever the value.
    Always,
    /// Not before power-off.
    Never,
}

impl Edge {
    /// Tells whether `value` is beyond the threshold in a pack of so many cells.
    pub(super) fn is_met(self, value: f64, cells: usize) -> bool {
        let of_cells = |per_cell: f64, more: f64| super::monitor::round(per_cell * cells as f64 + more);
        match self {
            Self::Above(limit) => value > limit,
            Self::Below(limit) => value < limit,
            Self::AtLeast(limit) => value >= limit,
            Self::AtMost(limit) => value <= limit,
            Self::Outside(low, high) => value < low || value > high,
            Self::Within(low, high) => (low..=high).contains(&value),
            Self::CellsAbove(per_cell, more) => value > of_cells(per_cell, more),
            Self::CellsBelow(per_cell, more) => value < of_cells(per_cell, more),
            Self::Always => true,
            Self::Never => false,
        }
    }
}

/// When a row is monitored; a mode and not a time (BUS-78).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum When {
    /// Always.
    Always,
    /// While the vehicle is on and not charging.
    Driving,
    /// While a plug or the pantograph is connected.
    Charging,
}

/// What the vehicle is asked for beyond the limits; no signal carries it (BUS-82).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Request {
    /// Nothing.
    Nothing,
    /// Goes on at the limp limit (BUS-R081).
    Limp,
    /// Stops.
    Stop,
}

/// What a row does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Effect {
    /// Share of the charge current that is left.
    pub(super) charge: f64,
    /// Share of the discharge current that is left.
    pub(super) discharge: f64,
    /// External charging is forbidden.
    pub(super) forbids_charging: bool,
    /// What is asked for.
    pub(super) request: Request,
}

/// One row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Row {
    /// Number of the fault; its levels share it.
    pub(super) fault: u8,
    /// Level.
    pub(super) severity: Severity,
    /// Code (citybus) or position of its bit (jiulong `BMSFaults`, c5ev `BMSD`); 0 on the citybus = undefined.
    pub(super) code: u8,
    /// When it is monitored.
    pub(super) when: When,
    /// What it looks at.
    pub(super) of: Quantity,
    /// Raises it.
    pub(super) set: Edge,
    /// Clears it.
    pub(super) clear: Edge,
    /// Raises and clears it in the cold.
    pub(super) cold: Option<(Edge, Edge)>,
    /// What it does.
    pub(super) does: Effect,
}

impl Row {
    const fn cold(mut self, set: Edge, clear: Edge) -> Self {
        self.cold = Some((set, clear));
        self
    }

    const fn when(mut self, when: When) -> Self {
        self.when = when;
        self
    }
}

const fn row(
    fault: u8,
    severity: Severity,
    code: u8,
    of: Quantity,
    set: Edge,
    clear: Edge,
    does: Effect,
) -> Row {
    Row { fault, severity, code, when: When::Always, of, set, clear, cold: None, does }
}

const fn effect(charge: f64, discharge: f64, forbids_charging: bool, request: Request) -> Effect {
    Effect { charge, discharge, forbids_charging, request }
}

const ALARM: Effect = effect(1.0, 1.0, false, Request::Nothing);
const HALF_CHARGE: Effect = effect(0.5, 1.0, false, Request::Nothing);
const HALF_DISCHARGE: Effect = effect(1.0, 0.5, false, Request::Nothing);
const HALF: Effect = effect(0.5, 0.5, false, Request::Nothing);
const NO_CHARGE: Effect = effect(0.0, 1.0, false, Request::Nothing);
const NO_CHARGE_STOP: Effect = effect(0.0, 1.0, false, Request::Stop);
const NO_DISCHARGE: Effect = effect(1.0, 0.0, false, Request::Nothing);
const NO_DISCHARGE_STOP: Effect = effect(1.0, 0.0, false, Request::Stop);
const NONE: Effect = effect(0.0, 0.0, false, Request::Nothing);
const NONE_STOP: Effect = effect(0.0, 0.0, false, Request::Stop);
/// Charging forbidden; while driving request limp.
const LIMP: Effect = effect(0.0, 1.0, true, Request::Limp);
/// Nothing allowed, external charging neither.
const OFF_STOP: Effect = effect(0.0, 0.0, true, Request::Stop);
/// Charging stops.
const END_CHARGE: Effect = effect(0.0, 1.0, true, Request::Nothing);

const YES: Edge = AtLeast(1.0);
const NO: Edge = Below(1.0);

use Edge::{Above, AtLeast, AtMost, Below, CellsAbove, CellsBelow, Outside, Within};
use Quantity::*;

/// The bus's table (BUS-R085 to R117).
const BUS: &[Row] = &[
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
    row(16, Stop, 20, Interlock, YES, NO, OFF_STOP),
    row(17, Warn, 74, Socket, Above(100.0), AtMost(95.0), HALF_CHARGE).when(When::Charging),
    row(17, Derate, 23, Socket, Above(120.0), AtMost(110.0), END_CHARGE).when(When::Charging),
    row(18, Derate, 70, VcuSilence, AtLeast(5_000.0), Below(5_000.0), LIMP).when(When::Driving),
    row(19, Derate, 64, CurrentSensor, YES, NO, LIMP),
    row(20, Stop, FIRE_CODE, Hot, AtLeast(75.0), Edge::Never, OFF_STOP),
];

/// Code of the fire alarm (BUS-R117).
pub(super) const FIRE_CODE: u8 = 24;

/// Jiulong: bits of `BMSFaults`; smoke has its levels printed (JL-R023, JL-R024).
const JIULONG: &[Row] = &[
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

/// Bit of jiulong's insulation fault; its level is reported apart (JL-53).
pub(super) const INSULATION_BIT: u8 = 10;

/// C5ev: bits of `BMSD` in two stages, the second is worse (C5-15).
const C5EV: &[Row] = &[
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
    row(16, Stop, 29, Interlock, YES, NO, OFF_STOP),
    row(17, Derate, 30, NegativeWelded, YES, NO, LIMP),
    row(18, Derate, 31, NegativeStuck, YES, NO, LIMP),
];

/// Returns a vehicle's table.
pub(super) const fn table(kind: Kind) -> &'static [Row] {
    match kind {
        Kind::Citybus => BUS,
        Kind::Jiulong => JIULONG,
        Kind::C5ev => C5EV,
    }
}

/// An extreme fault: the battery asks for high voltage to be opened (BUS-R073 to R076).
pub(super) struct ExtremeRow {
    /// What it looks at.
    pub(super) of: Quantity,
    /// Raises it.
    pub(super) set: Edge,
    /// Raises it in the cold.
    pub(super) cold: Edge,
}

/// The bus's extreme faults, and its fire warning (BUS-R077, R078).
pub(super) const EXTREMES: &[ExtremeRow] = &[
    ExtremeRow { of: CellMax, set: Above(4.1), cold: Above(4.1) },
    ExtremeRow { of: CellMin, set: Below(2.3), cold: Below(2.1) },
    ExtremeRow { of: Hot, set: Above(65.0), cold: Above(65.0) },
    ExtremeRow { of: Hot, set: AtLeast(75.0), cold: AtLeast(75.0) },
];
