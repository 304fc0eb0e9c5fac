//! When a lamp is lit: one table of lamps and conditions.
//!
//! Owns the table and the memory that hysteresis and silence need. A lamp lights when one of its rows does. Silence
//! darkens what is healthy or harmless and keeps what warns as it last was (BUS-108). Colours and places are in
//! `telltale`; the bulb check lies over this, so a real fault stays lit when it ends.
//! Source: BUS-R022 to BUS-R025, BUS-R096, BUS-39, BUS-75, BUS-108 to BUS-111, BUS-R128; C5-R012; readings JL-23, JL-24,
//! JL-56, C5-34; GB 7258 (air pressure).

use crate::reception::Facts;
use crate::telltale::{Telltale, Telltales};
use protocol_core::model::{Shown, Value};

/// What lights a lamp.
enum When {
    /// The value is this.
    Is(Value, i32),
    /// The value is this or more.
    AtLeast(Value, i32),
    /// The value has fallen below the first limit and has not yet risen above the second.
    Low(Value, i32, i32),
    /// A node has stopped sending.
    AnySilent,
}

/// What silence does to a lamp.
#[derive(PartialEq)]
enum Silence {
    /// Nothing healthy is lit from stale data.
    Darkens,
    /// A warning stays as it last was.
    Keeps,
}

struct Row {
    lamp: Telltale,
    when: When,
    silence: Silence,
    /// Not for a vehicle that sends this: it commands the lamp itself (C5-34, BUS-111).
    unless_sent: Option<Value>,
}

impl Row {
    const fn unless_sent(mut self, value: Value) -> Self {
        self.unless_sent = Some(value);
        self
    }
}

const fn row(lamp: Telltale, when: When, silence: Silence) -> Row {
    Row { lamp, when, silence, unless_sent: None }
}

/// State of charge below which the lamp lights and above which it goes out, in 0.1 % (BUS-R096).
const SOC_LOW: i32 = 200;
const SOC_LOW_CLEAR: i32 = 220;
/// Air pressure, in 0.01 MPa, below which a bus may not start off (GB 7258: 400 kPa where nothing else is marked).
const AIR_LOW: i32 = 40;

/// Contactor value "open", charge value "charging", run value "fault" of the model.
const OPEN: i32 = 0;
const CHARGING: i32 = 1;
const FAULT: i32 = 2;

use Silence::{Darkens, Keeps};
use When::{AnySilent, AtLeast, Is, Low};

const ROWS: &[Row] = &[
    row(Telltale::TurnLeft, Is(Value::BodyTurnLeft, 1), Darkens),
    row(Telltale::TurnRight, Is(Value::BodyTurnRight, 1), Darkens),
    row(Telltale::LowBeam, Is(Value::BodyLowBeam, 1), Darkens),
    row(Telltale::HighBeam, Is(Value::BodyHighBeam, 1), Darkens),
    row(Telltale::FrontFog, Is(Value::BodyFrontFog, 1), Darkens),
    row(Telltale::RearFog, Is(Value::BodyRearFog, 1), Darkens),
    row(Telltale::Ready, Is(Value::VehicleReady, 1), Darkens),
    row(Telltale::SystemFault, Is(Value::VehicleFault, 1), Keeps),
    row(Telltale::SystemFault, AtLeast(Value::VehicleFaultLevel, 1), Keeps).unless_sent(Value::VehicleFault),
    row(Telltale::SystemFault, AtLeast(Value::VehicleControllerLevel, 1), Keeps),
    row(Telltale::BatteryFault, AtLeast(Value::BatteryFaultLevel, 1), Keeps),
    row(Telltale::BatteryFault, Is(Value::BatteryFault, 1), Keeps),
    row(Telltale::BatteryFault, Is(Value::BatterySmoke, 1), Keeps),
    row(Telltale::MotorFault, Is(Value::MotorFault, 1), Keeps),
    row(Telltale::MotorFault, AtLeast(Value::MotorFaultLevel, 1), Keeps),
    row(Telltale::Insulation, AtLeast(Value::InsulationLevel, 1), Keeps),
    row(Telltale::Insulation, Is(Value::InsulationFault, 1), Keeps),
    row(Telltale::PowerLimited, Is(Value::VehiclePowerLimited, 1), Darkens),
    row(Telltale::PowerLimited, Is(Value::VehicleTorqueLimited, 1), Darkens),
    row(Telltale::LowCharge, Low(Value::BatterySoc, SOC_LOW, SOC_LOW_CLEAR), Darkens)
        .unless_sent(Value::BatteryLow),
    row(Telltale::LowCharge, Is(Value::BatteryLow, 1), Darkens),
    row(Telltale::BatteryCut, Is(Value::ContactorMain, OPEN), Darkens),
    row(Telltale::ChargePlug, Is(Value::ChargePlug, 1), Darkens),
    row(Telltale::Charging, Is(Value::ChargeState, CHARGING), Darkens),
    row(Telltale::LowVoltage, Is(Value::DcdcState, FAULT), Keeps),
    row(Telltale::LowVoltage, Is(Value::DcdcFault, 1), Keeps),
    row(Telltale::LowVoltage, Is(Value::SupplyLow, 1), Keeps),
    row(Telltale::LowVoltage, Is(Value::VehicleSupplyLow, 1), Keeps),
    row(Telltale::Steering, Is(Value::SteeringState, FAULT), Keeps),
    row(Telltale::Compressor, Is(Value::CompressorState, FAULT), Keeps),
    row(Telltale::Compressor, Is(Value::CompressorFault, 1), Keeps),
    row(Telltale::ParkingBrake, Is(Value::BodyHandBrake, 1), Darkens),
    row(Telltale::Door, Is(Value::BodyDoorFront, 1), Darkens),
    row(Telltale::Door, Is(Value::BodyDoorMiddle, 1), Darkens),
    row(Telltale::Door, Is(Value::BodyDoorRear, 1), Darkens),
    row(Telltale::Door, Is(Value::BodyDoorHatch, 1), Darkens),
    row(Telltale::AirPressure, Low(Value::AirFront, AIR_LOW, AIR_LOW - 1), Keeps),
    row(Telltale::AirPressure, Low(Value::AirRear, AIR_LOW, AIR_LOW - 1), Keeps),
    row(Telltale::NoCommunication, AnySilent, Darkens),
];

const _: () = assert!(ROWS.len() <= u64::BITS as usize, "one bit of memory per row");

/// Which rows are met, bit n = row n.
#[derive(Clone, Copy)]
pub(crate) struct Lamps {
    met: u64,
}

impl Lamps {
    pub(crate) const fn new() -> Self {
        Self { met: 0 }
    }

    /// Evaluates the table.
    pub(crate) fn tick(&mut self, facts: &Facts<'_>) {
        let before = self.met;
        self.met = 0;
        for (index, row) in ROWS.iter().enumerate() {
            self.met |= u64::from(row.is_met(before >> index & 1 != 0, facts)) << index;
        }
    }

    /// Returns the lit lamps.
    pub(crate) fn lit(&self) -> Telltales {
        let mut lit = Telltales::NONE;
        for (index, row) in ROWS.iter().enumerate() {
            if self.met >> index & 1 != 0 {
                lit.set(row.lamp, true);
            }
        }
        lit
    }
}

impl Row {
    fn is_met(&self, before: bool, facts: &Facts<'_>) -> bool {
        let value = match self.when {
            Is(value, _) | AtLeast(value, _) | Low(value, ..) => value,
            AnySilent => return !facts.silent.is_empty(),
        };
        if self.unless_sent.is_some_and(|value| facts.is_sent(value)) {
            return false;
        }
        match (facts.shown(value), &self.when) {
            (Shown::Value(number), Is(_, wanted)) => number == *wanted,
            (Shown::Value(number), AtLeast(_, least)) => number >= *least,
            (Shown::Value(number), Low(_, on, off)) => number < *on || before && number <= *off,
            (Shown::Stale | Shown::Invalid, _) => before && self.silence == Keeps,
            _ => false,
        }
    }
}
