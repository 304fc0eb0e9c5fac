//! The sources of faults: what makes each report, how bad it is, what the line says.
//!
//! Owns the table and its reading; the set of active faults is in `faults`. A row says nothing of a vehicle: values that
//! no message of the vehicle brings make no report.
//! Source: BUS-R049 to BUS-R051, BUS-R059, BUS-R065, BUS-R072, BUS-R080, BUS-R119, BUS-R123, BUS-R125, BUS-R133;
//! JL-R013, JL-R023, JL-R024; C5-R005; readings BUS-55, BUS-77, BUS-79, BUS-90, BUS-106, BUS-109, BUS-113, C5-15,
//! JL-23, JL-24, JL-56.

use crate::facts::Facts;
use crate::faults::Fault;
use crate::history::{Entry, Source};
use crate::monitors::hv_off::Phase;
use crate::texts;
use crate::view::Text;
use protocol_core::model::{Severity, Shown, Value};
use protocol_core::states::{Mode, Run};
use protocol_core::vehicle::{FaultText, Node, Vehicle};

/// What makes a source report.
pub(crate) enum When {
    /// A severity value above none.
    Level(Value),
    /// A code value other than 0.
    Code(Value),
    /// The value is this.
    Is(Value, i32),
    /// One of the flags is set.
    AnyOf(&'static [Value]),
    /// Alarm bits: each is a fault of its own, bit n = code n + 1.
    Bits(Value),
    /// An expected message of the node is missing.
    Silent(Node),
    /// The battery asks for high voltage off, see `hv_off`.
    HvOff,
    /// The charger has fallen silent, see `charger`.
    ChargerLost,
    /// The air conditioning has lost its link, see `hvac`.
    HvacLost,
    /// The vehicle limps, see `limp`.
    Limps,
}

/// How bad the report is.
pub(crate) enum Grade {
    /// As the value says.
    Level(Value),
    /// The same always.
    Always(Severity),
    /// The documents print no level: takes turns with whatever the vehicle reports, and is at least this (BUS-113).
    Joins(Severity),
    /// As the alarm's text says; without a level there, as bad as the sender's level field, at least WARN.
    Stage(Value),
}

/// What the line says.
pub(crate) enum Words {
    /// The same always.
    Always(Text),
    /// One text each for level 1, 2 and 3.
    ByLevel([Text; 3]),
    /// The vehicle's text of the node's code; for a code without one, as [`Words::ByLevel`].
    ByCode(Node, [Text; 3]),
    /// The vehicle's text of an alarm bit, from the first of the nodes that has one.
    ByBit(&'static [Node], Text),
    /// The text of the request's phase.
    HvOff,
}

/// One source of faults.
pub(crate) struct Row {
    pub(crate) source: Source,
    pub(crate) when: When,
    grade: Grade,
    code: Option<Value>,
    words: Words,
    /// The sender reports several codes in turn: each is a fault of its own.
    pub(crate) rotates: bool,
    /// Level and code come in messages of their own: for a while a new level stands beside the code of the old one.
    pub(crate) code_lags: bool,
    /// The row that brings the same fault by another route: of the same code only the worse report is told, and that
    /// row's if they are equally bad (BUS-77: the vehicle forwards the battery's codes).
    pub(crate) repeats: Option<u8>,
    /// Left out on a vehicle that sends this value: it says the same in more detail.
    unless_sent: Option<Value>,
    pub(crate) sounds: bool,
}

impl Row {
    const fn new(source: Source, when: When, grade: Grade, words: Words) -> Self {
        let (code, unless_sent, repeats) = (None, None, None);
        let (rotates, code_lags, sounds) = (false, false, false);
        Self { source, when, grade, code, words, rotates, code_lags, repeats, unless_sent, sounds }
    }

    const fn code(mut self, value: Value) -> Self {
        self.code = Some(value);
        self
    }

    const fn rotates(mut self) -> Self {
        self.rotates = true;
        self
    }

    const fn code_lags(mut self) -> Self {
        self.code_lags = true;
        self
    }

    const fn repeats(mut self, row: u8) -> Self {
        self.repeats = Some(row);
        self
    }

    const fn unless_sent(mut self, value: Value) -> Self {
        self.unless_sent = Some(value);
        self
    }

    const fn sounds(mut self) -> Self {
        self.sounds = true;
        self
    }

    /// A level and the text of a code beside it.
    const fn level(source: Source, level: Value, words: Words) -> Self {
        Self::new(source, When::Level(level), Level(level), words)
    }

    const fn flag(source: Source, value: Value, grade: Grade, text: Text) -> Self {
        Self::new(source, When::Is(value, 1), grade, Words::Always(text))
    }

    const fn any_of(source: Source, values: &'static [Value], grade: Grade, text: Text) -> Self {
        Self::new(source, When::AnyOf(values), grade, Words::Always(text))
    }

    const fn component(source: Source, state: Value, code: Value, text: Text) -> Self {
        Self::new(source, When::Is(state, Run::Fault.number()), Joins(Warn), Words::Always(text)).code(code)
    }

    const fn silent(source: Source, node: Node, severity: Severity) -> Self {
        Self::new(source, When::Silent(node), Always(severity), Words::Always(texts::silent(node)))
    }
}

const SYSTEM: [Text; 3] = [texts::SYSTEM_1, texts::SYSTEM_2, texts::SYSTEM_3];
const BATTERY: [Text; 3] = [texts::BATTERY_1, texts::BATTERY_2, texts::BATTERY_3];
const VEHICLE_CODE: [Text; 3] = [texts::VEHICLE_CODE; 3];
const CONTROLLER: [Text; 3] = [texts::CONTROLLER; 3];
const CHARGER: [Text; 3] = [texts::CHARGER; 3];
const MOTOR: [Text; 3] = [texts::MOTOR; 3];
const INSULATION: [Text; 3] = [texts::INSULATION; 3];

use Grade::{Always, Joins, Level, Stage};
use Severity::{Derate, Stop, Warn};
use Source as S;
use Value as V;
use Words::{ByBit, ByCode, ByLevel};

/// All sources, in the order in which faults of one severity take their turns: the system's level text first.
#[rustfmt::skip]
pub(crate) const ROWS: &[Row] = &[
    Row::level(S::VehicleLevel, V::VehicleFaultLevel, ByLevel(SYSTEM)).sounds(),
    Row::new(S::VehicleCode, When::Code(V::VehicleFaultCode), Level(V::VehicleFaultLevel), ByCode(Node::Vcu, VEHICLE_CODE))
        .code(V::VehicleFaultCode).rotates().sounds(),
    Row::level(S::ControllerLevel, V::VehicleControllerLevel, ByLevel(CONTROLLER)).sounds(),
    Row::flag(S::VehicleFault, V::VehicleFault, Always(Warn), texts::SYSTEM).unless_sent(V::VehicleFaultLevel),
    Row::flag(S::ShiftFailed, V::VehicleShiftFailed, Always(Warn), texts::SHIFT_FAILED).sounds(),
    Row::new(S::HvOff, When::HvOff, Always(Stop), Words::HvOff).sounds(),
    Row::level(S::Battery, V::BatteryFaultLevel, ByCode(Node::Bms, BATTERY))
        .code(V::BatteryFaultCode).rotates().code_lags().repeats(FORWARDED).sounds(),
    Row::level(S::Battery, V::VehicleBatteryLevel, ByLevel(BATTERY)).repeats(BATTERY_ROW).sounds(),
    Row::flag(S::BatterySmoke, V::BatterySmoke, Always(Stop), texts::BATTERY_SMOKE).unless_sent(V::BatteryAlarms).sounds(),
    Row::new(S::BatteryAlarm, When::Bits(V::BatteryAlarms), Stage(V::BatteryFaultLevel), ByBit(&[Node::Bms], texts::BATTERY)).sounds(),
    Row::flag(S::BatteryFault, V::BatteryFault, Always(Warn), texts::BATTERY).unless_sent(V::BatteryAlarms),
    Row::level(S::Motor, V::MotorFaultLevel, ByCode(Node::Inverter, MOTOR)).code(V::MotorFaultCode).rotates().sounds(),
    Row::new(S::MotorAlarm, When::Bits(V::MotorAlarms), Stage(V::MotorFaultLevel), ByBit(&[Node::Inverter, Node::Vcu], texts::MOTOR)).sounds(),
    Row::level(S::Insulation, V::InsulationLevel, ByCode(Node::Insulation, INSULATION)).code(V::InsulationFaultCode).sounds(),
    Row::flag(S::InsulationFault, V::InsulationFault, Always(Warn), texts::INSULATION).unless_sent(V::InsulationLevel),
    Row::flag(S::InsulationDevice, V::InsulationDeviceFault, Always(Warn), texts::INSULATION_DEVICE),
    Row::flag(S::Smoke, V::BodySmoke, Always(Stop), texts::SMOKE).sounds(),
    Row::flag(S::DriverLeft, V::ClusterDriverLeft, Always(Warn), texts::DRIVER_LEFT).sounds(),
    Row::flag(S::MotorController, V::MotorFault, Joins(Warn), texts::MOTOR_CONTROLLER).code(V::MotorFaultCode),
    Row::component(S::Steering, V::SteeringState, V::SteeringFaultCode, texts::STEERING),
    Row::component(S::Dcdc, V::DcdcState, V::DcdcFaultCode, texts::DCDC),
    Row::flag(S::Dcdc, V::DcdcFault, Joins(Warn), texts::DCDC).unless_sent(V::DcdcState),
    Row::component(S::Compressor, V::CompressorState, V::CompressorFaultCode, texts::COMPRESSOR),
    Row::flag(S::Compressor, V::CompressorFault, Joins(Warn), texts::COMPRESSOR),
    Row::flag(S::CompressorHot, V::CompressorHot, Always(Warn), texts::COMPRESSOR_HOT),
    Row::flag(S::BrakeVacuum, V::BrakeVacuumFault, Always(Derate), texts::BRAKE_VACUUM).sounds(),
    Row::flag(S::BrakeEbd, V::BrakeEbdFault, Always(Warn), texts::BRAKE_EBD).sounds(),
    Row::flag(S::BrakeAbs, V::BrakeAbsFault, Always(Warn), texts::BRAKE_ABS),
    Row::any_of(S::Cooling, &[V::CoolingPumpFault, V::CoolingFanFault], Always(Warn), texts::COOLING),
    Row::any_of(S::Supply, &[V::SupplyLow, V::VehicleSupplyLow], Always(Warn), texts::SUPPLY_LOW),
    Row::level(S::Charger, V::ChargerFaultLevel, ByCode(Node::Charger, CHARGER)).code(V::ChargerFaultCode).rotates().sounds(),
    Row::flag(S::ChargerFault, V::ChargerFault, Always(Warn), texts::CHARGER).unless_sent(V::ChargerFaultLevel),
    Row::new(S::ChargerLost, When::ChargerLost, Always(Warn), Words::Always(texts::CHARGER_LOST)).sounds(),
    Row::flag(S::Hvac, V::HvacFault, Always(Warn), texts::HVAC),
    Row::new(S::HvacLost, When::HvacLost, Always(Severity::None), Words::Always(texts::HVAC_LOST)),
    // Without the vehicle controller there is no speed, no gear and no fault report; without the battery the vehicle
    // limps (BUS-R080).
    Row::new(S::Limp, When::Limps, Always(Derate), Words::Always(texts::LIMP)).sounds(),
    // Reported by the vehicle: it does not say why.
    Row::new(S::Limp, When::Is(V::VehicleMode, LIMP), Always(Derate), Words::Always(texts::LIMP_MODE)).sounds(),
    Row::flag(S::PowerLimit, V::VehiclePowerLimited, Joins(Severity::None), texts::POWER_LIMITED),
    Row::flag(S::TorqueLimit, V::VehicleTorqueLimited, Joins(Severity::None), texts::TORQUE_LIMITED),
    Row::silent(S::SilentVcu, Node::Vcu, Derate).sounds(),
    Row::silent(S::SilentBms, Node::Bms, Derate).sounds(),
    Row::silent(S::SilentInverter, Node::Inverter, Warn).sounds(),
    Row::silent(S::SilentSteering, Node::Steering, Warn),
    Row::silent(S::SilentCompressor, Node::Compressor, Warn),
    Row::silent(S::SilentInsulation, Node::Insulation, Warn),
    Row::silent(S::SilentDcdc, Node::Dcdc, Warn),
    Row::silent(S::SilentContactors, Node::Contactors, Warn),
    Row::silent(S::SilentCharger, Node::Charger, Warn),
    Row::silent(S::SilentHvac, Node::Hvac, Warn),
];

/// Returns what is said of a remembered fault, and its code as the driver reads it.
pub(crate) fn remembered(entry: &Entry, vehicle: &Vehicle) -> (Text, Option<u16>) {
    // Every source has a row; the first of two rows says the same as the other.
    let row = ROWS.iter().find(|row| row.source == entry.source).unwrap_or(&ROWS[0]);
    (row.words.of(entry.severity, entry.code, vehicle, None), row.printed(entry.code))
}

/// Number of limp mode.
const LIMP: i32 = Mode::Limp.number();
/// Row of the vehicle controller's codes.
const FORWARDED: u8 = 1;
/// Row of what the battery says itself.
const BATTERY_ROW: u8 = 6;
const _: () = assert!(matches!(ROWS[FORWARDED as usize].when, When::Code(V::VehicleFaultCode)));
const _: () = assert!(matches!(ROWS[BATTERY_ROW as usize].when, When::Level(V::BatteryFaultLevel)));
const _: () = assert!(ROWS.len() < u8::MAX as usize, "rows are counted in a byte");

/// What a source says now.
pub(crate) enum Report {
    /// Nothing that can be believed: silent, never heard or marked as not valid.
    Unknown,
    /// No fault.
    Clear,
    /// A fault.
    Fault(Severity, Option<u16>),
    /// Alarm bits; how bad each is, [`Row::stage`] says.
    Bits(u32),
}

impl Row {
    /// Returns what the source says now.
    pub(crate) fn report(&self, facts: &Facts<'_>) -> Report {
        if self.unless_sent.is_some_and(|value| facts.is_sent(value)) {
            return Report::Clear;
        }
        let value_of = |value| facts.shown(value).value();
        let reports = match self.when {
            When::Bits(value) => {
                return value_of(value).map_or(Report::Unknown, |bits| Report::Bits(bits.cast_unsigned()));
            }
            When::Silent(node) => Some(facts.silent.has(node)),
            When::Level(value) => value_of(value).map(|level| level > 0),
            When::Code(value) => value_of(value).map(|code| code != 0),
            When::Is(value, wanted) => value_of(value).map(|number| number == wanted),
            When::AnyOf(values) => any_of(facts, values),
            When::HvOff => Some(facts.timers.hv_off.phase(facts.now).is_some()),
            When::ChargerLost => Some(facts.timers.charger.is_lost()),
            When::HvacLost => Some(facts.has_lost_hvac()),
            When::Limps => Some(facts.link().limps()),
        };
        match reports {
            None => Report::Unknown,
            Some(false) => Report::Clear,
            Some(true) => {
                let code = self.code.and_then(|value| code_of(facts, value));
                let severity = self.grade.of(facts, || self.severity_of_text(facts, code));
                severity.map_or(Report::Unknown, |severity| Report::Fault(severity, code))
            }
        }
    }

    /// Returns how bad the alarm of `code` is.
    pub(crate) fn stage(&self, facts: &Facts<'_>, code: u16) -> Severity {
        self.grade.of(facts, || self.severity_of_text(facts, Some(code))).unwrap_or_default()
    }

    fn severity_of_text(&self, facts: &Facts<'_>, code: Option<u16>) -> Severity {
        let text = code.and_then(|code| self.words.fault_text(facts.vehicle, code));
        text.and_then(|text| text.severity).unwrap_or_default()
    }

    /// Returns whether the code is part of a fault's name.
    pub(crate) fn has_several(&self) -> bool {
        self.rotates || matches!(self.when, When::Bits(_))
    }

    /// Returns whether the row only says that a node is missing.
    pub(crate) fn misses_a_node(&self) -> bool {
        matches!(self.when, When::Silent(_))
    }

    /// Returns the code as the driver reads it: the number of a bit is nothing that a document prints.
    pub(crate) fn printed(&self, code: Option<u16>) -> Option<u16> {
        code.filter(|_| !matches!(self.when, When::Bits(_)))
    }

    /// Returns whether `fault` means that the vehicle limps: by its row, or by what the vehicle's documents say of it.
    pub(crate) fn limps(&self, fault: &Fault, vehicle: &Vehicle) -> bool {
        let text = fault.code.and_then(|code| self.words.fault_text(vehicle, code));
        matches!(self.when, When::Limps | When::Is(V::VehicleMode, LIMP))
            || text.is_some_and(|text| text.limps)
    }

    /// Returns what the line says of `fault`.
    pub(crate) fn text(&self, fault: &Fault, vehicle: &Vehicle, phase: Option<Phase>) -> Text {
        self.words.of(fault.severity, fault.code, vehicle, phase)
    }
}

/// Returns whether a flag is set; `None` = none is, and one that was sent cannot be believed.
fn any_of(facts: &Facts<'_>, values: &[Value]) -> Option<bool> {
    let mut sent = values.iter().map(|&value| facts.shown(value)).filter(|shown| *shown != Shown::Never);
    if sent.clone().any(|shown| shown == Shown::Value(1)) {
        return Some(true);
    }
    sent.all(|shown| shown.value().is_some()).then_some(false)
}

/// Returns the code in `value`, `None` for 0 and for anything that cannot be believed.
pub(crate) fn code_of(facts: &Facts<'_>, value: Value) -> Option<u16> {
    facts.shown(value).value().and_then(|code| u16::try_from(code).ok()).filter(|&code| code != 0)
}

impl Grade {
    /// Returns the severity, `None` while the value that says it is silent or not valid.
    ///
    /// The level field decides (BUS-79); `of_code` only on a vehicle that has none.
    fn of(&self, facts: &Facts<'_>, of_code: impl FnOnce() -> Severity) -> Option<Severity> {
        let fresh = |value| facts.shown(value).value().map_or(Severity::None, Severity::from_model);
        match *self {
            Level(value) => match facts.shown(value) {
                Shown::Value(level) => Some(Severity::from_model(level)),
                Shown::Never => Some(of_code()),
                Shown::Stale | Shown::Invalid => None,
            },
            Always(severity) => Some(severity),
            Joins(least) => Some(fresh(Value::VehicleFaultLevel).max(least)),
            Stage(level) => Some(match of_code() {
                Severity::None => fresh(level).max(Warn),
                stage => stage,
            }),
        }
    }
}

impl Words {
    fn of(&self, severity: Severity, code: Option<u16>, vehicle: &Vehicle, phase: Option<Phase>) -> Text {
        // The driver reads the number that the vehicle's own documents use.
        let counts_down = vehicle.worst_level == 1;
        let by_level = |texts: &[Text; 3]| match severity {
            Severity::None | Warn => texts[if counts_down { 2 } else { 0 }],
            Derate => texts[1],
            Stop => texts[if counts_down { 0 } else { 2 }],
        };
        let of_vehicle = || code.and_then(|code| self.fault_text(vehicle, code));
        let from = |text: &FaultText| Text { zh: text.zh, en: text.en };
        match self {
            Self::Always(text) => *text,
            ByLevel(texts) => by_level(texts),
            ByCode(_, texts) => of_vehicle().map_or_else(|| by_level(texts), from),
            ByBit(_, text) => of_vehicle().map_or(*text, from),
            Self::HvOff => match phase {
                None | Some(Phase::Asked) => texts::HV_OFF_ASKED,
                Some(Phase::Overdue) => texts::HV_OFF_OVERDUE,
                Some(Phase::Due) => texts::HV_OFF_NOW,
                Some(Phase::Off) => texts::HV_OFF_DONE,
            },
        }
    }

    /// Returns what the vehicle's documents say of `code`.
    fn fault_text(&self, vehicle: &Vehicle, code: u16) -> Option<&'static FaultText> {
        match *self {
            ByCode(node, _) => vehicle.fault(node, code),
            ByBit(nodes, _) => nodes.iter().find_map(|&node| vehicle.fault(node, code)),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::collections::BTreeSet;

    /// What a row says besides when it reports, as one can compare it: values, then switches.
    fn traits(row: &Row) -> ([Option<Value>; 2], [bool; 4]) {
        ([row.code, row.unless_sent], [row.rotates, row.code_lags, row.repeats == Some(9), row.sounds])
    }

    #[test]
    fn each_word_of_a_row_says_one_thing_and_leaves_the_others() {
        let plain =
            || Row::new(S::Supply, When::Code(V::SupplyLow), Always(Warn), Words::Always(texts::SUPPLY_LOW));
        let (none, off) = ([None; 2], [false; 4]);
        assert_eq!(traits(&plain()), (none, off));
        assert_eq!(traits(&plain().code(V::DcdcState)), ([Some(V::DcdcState), None], off));
        assert_eq!(traits(&plain().unless_sent(V::DcdcState)), ([None, Some(V::DcdcState)], off));
        assert_eq!(traits(&plain().rotates()), (none, [true, false, false, false]));
        assert_eq!(traits(&plain().code_lags()), (none, [false, true, false, false]));
        assert_eq!(traits(&plain().repeats(9)), (none, [false, false, true, false]));
        assert_eq!(traits(&plain().sounds()), (none, [false, false, false, true]));
    }

    #[test]
    fn each_kind_of_row_reports_on_its_values() {
        let level = Row::level(S::Battery, V::BatteryFaultLevel, ByLevel(BATTERY));
        assert!(matches!(level.when, When::Level(V::BatteryFaultLevel)));
        assert!(matches!(level.grade, Level(V::BatteryFaultLevel)), "a level grades itself");
        let flag = Row::flag(S::Hvac, V::HvacFault, Always(Warn), texts::HVAC);
        assert!(matches!(flag.when, When::Is(V::HvacFault, 1)));
        let any_of = Row::any_of(S::Cooling, &[V::CoolingFanFault], Always(Warn), texts::COOLING);
        assert!(matches!(any_of.when, When::AnyOf([V::CoolingFanFault])));
        let component = Row::component(S::Dcdc, V::DcdcState, V::DcdcFaultCode, texts::DCDC);
        assert!(matches!(component.when, When::Is(V::DcdcState, state) if state == Run::Fault.number()));
        assert!(matches!(component.grade, Joins(Warn)), "BUS-113: the documents print no level");
        assert_eq!(traits(&component), ([Some(V::DcdcFaultCode), None], [false; 4]));
        let silent = Row::silent(S::SilentInverter, Node::Inverter, Warn);
        assert!(matches!((silent.when, silent.grade), (When::Silent(Node::Inverter), Always(Warn))));
    }

    #[test]
    fn every_source_has_a_row_and_every_silent_node_its_own_text() {
        let sources: BTreeSet<Source> = ROWS.iter().map(|row| row.source).collect();
        assert_eq!(sources.len(), Source::ALL.len());
        let mut named = BTreeSet::new();
        for row in ROWS {
            if let When::Silent(node) = row.when {
                let text = texts::silent(node);
                assert!(matches!(row.words, Words::Always(words) if words == text), "{}", text.en);
                assert!(text.en.starts_with("No communication: "), "{}", text.en);
                assert!(named.insert(text.en) && named.insert(text.zh), "{} is said of two nodes", text.en);
            }
        }
    }
}
