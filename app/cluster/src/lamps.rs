//! When a lamp is lit: one table of lamps and conditions.
//!
//! Owns the table and the memory that hysteresis and silence need. A lamp lights when one of its rows does. Silence
//! darkens what is healthy or harmless and keeps what warns as it last was (BUS-108). Colours and places are in
//! `telltale`; the bulb check lies over this, so a real fault stays lit when it ends.
//! Source: BUS-R022 to BUS-R025, BUS-R096, BUS-39, BUS-75, BUS-108 to BUS-111, BUS-R128; C5-R012; JL-R013; readings JL-23, JL-24,
//! JL-56, C5-34; GB 7258 (air pressure).

use crate::facts::Facts;
use crate::telltale::{Telltale, Telltales};
use protocol_core::model::{Shown, Value};
use protocol_core::states::{Charge, Contactor, Run};

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

macro_rules! rows {
    ($($lamp:ident $silence:ident: $when:expr $(, unless sent $value:ident)?;)*) => {
        &[$(Row {
            lamp: Telltale::$lamp,
            when: $when,
            silence: Silence::$silence,
            unless_sent: rows!(@unless $($value)?),
        }),*]
    };
    (@unless) => { None };
    (@unless $value:ident) => { Some(Value::$value) };
}

/// State of charge below which the lamp lights and above which it goes out, in 0.1 % (BUS-R096).
const SOC_LOW: i32 = 200;
const SOC_LOW_CLEAR: i32 = 220;
/// Air pressure, in 0.01 MPa, below which a bus may not start off (GB 7258: 400 kPa where nothing else is marked).
const AIR_LOW: i32 = 40;

use Silence::Keeps;
use When::{AnySilent, AtLeast, Is, Low};

const ROWS: &[Row] = rows! {
    TurnLeft Darkens: Is(Value::BodyTurnLeft, 1);
    TurnRight Darkens: Is(Value::BodyTurnRight, 1);
    LowBeam Darkens: Is(Value::BodyLowBeam, 1);
    HighBeam Darkens: Is(Value::BodyHighBeam, 1);
    FrontFog Darkens: Is(Value::BodyFrontFog, 1);
    RearFog Darkens: Is(Value::BodyRearFog, 1);
    Ready Darkens: Is(Value::VehicleReady, 1);
    SystemFault Keeps: Is(Value::VehicleFault, 1);
    SystemFault Keeps: AtLeast(Value::VehicleFaultLevel, 1), unless sent VehicleFault;
    SystemFault Keeps: AtLeast(Value::VehicleControllerLevel, 1);
    BatteryFault Keeps: AtLeast(Value::BatteryFaultLevel, 1);
    BatteryFault Keeps: AtLeast(Value::VehicleBatteryLevel, 1);
    BatteryFault Keeps: Is(Value::BatteryFault, 1);
    BatteryFault Keeps: Is(Value::BatterySmoke, 1);
    MotorFault Keeps: Is(Value::MotorFault, 1);
    MotorFault Keeps: AtLeast(Value::MotorFaultLevel, 1);
    Insulation Keeps: AtLeast(Value::InsulationLevel, 1);
    Insulation Keeps: Is(Value::InsulationFault, 1);
    PowerLimited Darkens: Is(Value::VehiclePowerLimited, 1);
    PowerLimited Darkens: Is(Value::VehicleTorqueLimited, 1);
    LowCharge Darkens: Low(Value::BatterySoc, SOC_LOW, SOC_LOW_CLEAR), unless sent BatteryLow;
    LowCharge Darkens: Is(Value::BatteryLow, 1);
    BatteryCut Darkens: Is(Value::ContactorMain, Contactor::Open.number());
    ChargePlug Darkens: Is(Value::ChargePlug, 1);
    Charging Darkens: Is(Value::ChargeState, Charge::Charging.number());
    LowVoltage Keeps: Is(Value::DcdcState, Run::Fault.number());
    LowVoltage Keeps: Is(Value::DcdcFault, 1);
    LowVoltage Keeps: Is(Value::SupplyLow, 1);
    LowVoltage Keeps: Is(Value::VehicleSupplyLow, 1);
    Steering Keeps: Is(Value::SteeringState, Run::Fault.number());
    Compressor Keeps: Is(Value::CompressorState, Run::Fault.number());
    Compressor Keeps: Is(Value::CompressorFault, 1);
    ParkingBrake Darkens: Is(Value::BodyParkingBrake, 1);
    Door Darkens: Is(Value::BodyDoorFront, 1);
    Door Darkens: Is(Value::BodyDoorMiddle, 1);
    Door Darkens: Is(Value::BodyDoorRear, 1);
    Door Darkens: Is(Value::BodyDoorHatch, 1);
    AirPressure Keeps: Low(Value::AirFront, AIR_LOW, AIR_LOW - 1);
    AirPressure Keeps: Low(Value::AirRear, AIR_LOW, AIR_LOW - 1);
    NoCommunication Darkens: AnySilent;
};

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
