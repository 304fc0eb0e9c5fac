//! The shape of a battery controller's fault table: what a row looks at, its thresholds, and what it does.
//!
//! One row per fault and level; the rows are each vehicle's `faults`. Refuses to walk them: that is the battery's
//! monitor.

use protocol_core::model::Severity;

/// What a row looks at, in the unit of its thresholds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
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
    /// Discharge current in percent of the limit that was told.
    DischargePercent,
    /// Charge current in percent of the limit that was told.
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
pub(crate) enum Edge {
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
    pub(crate) fn is_met(self, value: f64, cells: usize) -> bool {
        let of_cells = |per_cell: f64, more: f64| round(per_cell * cells as f64 + more);
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
pub(crate) enum When {
    /// Always.
    Always,
    /// While the vehicle is on and not charging.
    Driving,
    /// While a plug or the pantograph is connected.
    Charging,
}

/// What the vehicle is asked for beyond the limits; no signal carries it (BUS-82).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Request {
    /// Nothing.
    Nothing,
    /// Goes on at the limp limit (BUS-R081).
    Limp,
    /// Stops.
    Stop,
}

/// What a row does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Effect {
    /// Share of the charge current that is left.
    pub(crate) charge: f64,
    /// Share of the discharge current that is left.
    pub(crate) discharge: f64,
    /// External charging is forbidden.
    pub(crate) forbids_charging: bool,
    /// High voltage that is open stays open.
    pub(crate) stays_open: bool,
    /// What is asked for.
    pub(crate) request: Request,
}

/// One row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Row {
    /// Number of the fault; its levels share it.
    pub(crate) fault: u8,
    /// Level.
    pub(crate) severity: Severity,
    /// Code (citybus) or position of its bit (jiulong `BMSFaults`, c5ev `BMSD`); 0 on the citybus = undefined.
    pub(crate) code: u8,
    /// When it is monitored.
    pub(crate) when: When,
    /// What it looks at.
    pub(crate) of: Quantity,
    /// Raises it.
    pub(crate) set: Edge,
    /// Clears it.
    pub(crate) clear: Edge,
    /// Raises and clears it in the cold.
    pub(crate) cold: Option<(Edge, Edge)>,
    /// What it does.
    pub(crate) does: Effect,
}

impl Row {
    pub(crate) const fn cold(mut self, set: Edge, clear: Edge) -> Self {
        self.cold = Some((set, clear));
        self
    }

    pub(crate) const fn when(mut self, when: When) -> Self {
        self.when = when;
        self
    }
}

pub(crate) const fn row(
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

pub(crate) const fn effect(charge: f64, discharge: f64, forbids_charging: bool, request: Request) -> Effect {
    Effect { charge, discharge, forbids_charging, stays_open: false, request }
}

pub(crate) const ALARM: Effect = effect(1.0, 1.0, false, Request::Nothing);
pub(crate) const HALF_CHARGE: Effect = effect(0.5, 1.0, false, Request::Nothing);
pub(crate) const HALF_DISCHARGE: Effect = effect(1.0, 0.5, false, Request::Nothing);
pub(crate) const HALF: Effect = effect(0.5, 0.5, false, Request::Nothing);
pub(crate) const NO_CHARGE: Effect = effect(0.0, 1.0, false, Request::Nothing);
pub(crate) const NO_CHARGE_STOP: Effect = effect(0.0, 1.0, false, Request::Stop);
pub(crate) const NO_DISCHARGE: Effect = effect(1.0, 0.0, false, Request::Nothing);
pub(crate) const NO_DISCHARGE_STOP: Effect = effect(1.0, 0.0, false, Request::Stop);
pub(crate) const NONE: Effect = effect(0.0, 0.0, false, Request::Nothing);
pub(crate) const NONE_STOP: Effect = effect(0.0, 0.0, false, Request::Stop);
/// Charging forbidden; while driving request limp.
pub(crate) const LIMP: Effect = effect(0.0, 1.0, true, Request::Limp);
/// Nothing allowed, external charging neither.
pub(crate) const OFF_STOP: Effect = effect(0.0, 0.0, true, Request::Stop);
/// The same, and parked no driving off.
pub(crate) const OFF_STOP_PARKED: Effect = Effect { stays_open: true, ..OFF_STOP };
/// Charging stops.
pub(crate) const END_CHARGE: Effect = effect(0.0, 1.0, true, Request::Nothing);

pub(crate) const YES: Edge = Edge::AtLeast(1.0);
pub(crate) const NO: Edge = Edge::Below(1.0);

/// An extreme fault: the battery asks for high voltage to be opened (BUS-R073 to R076).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ExtremeRow {
    /// What it looks at.
    pub(crate) of: Quantity,
    /// Raises it.
    pub(crate) set: Edge,
    /// Raises it in the cold.
    pub(crate) cold: Edge,
}

/// Rounds to what the measuring boards resolve: thousandths of a volt, degree or percent.
pub(crate) fn round(value: f64) -> f64 {
    (value * 1_000.0).round() / 1_000.0
}
