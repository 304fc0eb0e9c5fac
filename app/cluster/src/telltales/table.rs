//! The table of telltales: one row each, from which all that concerns one is derived.
//!
//! Owns name, colour, words, place and conditions of every telltale; one that stands for a fault follows the values of
//! the fault's row. To add one: a row here, and its symbol under the
//! same key in `app/ui/fontgen`. Rows are added at the end: a row's number is its bit in records.
//! Source: ISO 2575 clause 5 / UN R121: red = danger, yellow = caution, green = in operation, blue = high beam only;
//! BUS-R022 to BUS-R025, BUS-R096, BUS-39, BUS-75, BUS-108 to BUS-111, BUS-R128; JL-R013; C5-R012; readings JL-23, JL-24,
//! JL-56, C5-34; GB 7258 (air pressure).

use crate::faults::{AIR_LOW, FaultId, When as Reports};
use protocol_core::model::Value;
use protocol_core::states::{Charge, Contactor};

/// Colour in which a telltale lights, by ISO 2575.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TelltaleColour {
    /// Danger: act at once.
    Red,
    /// Caution: outside normal limits.
    Yellow,
    /// In normal operation.
    Green,
    /// High beam, nothing else.
    Blue,
}

impl TelltaleColour {
    /// Returns the public name of the colour.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Red => "red",
            Self::Yellow => "yellow",
            Self::Green => "green",
            Self::Blue => "blue",
        }
    }
}

/// Where a telltale stands: fixed, as ISO 2575 wants it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A cell of its own: row 0 or 1, column 0 to 11.
    Cell(u8, u8),
    /// The cell of another telltale, which has one of its own. While both are lit they take turns of half a second.
    With(Telltale),
}

/// What silence does to a telltale.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Silence {
    /// Nothing healthy is lit from stale data.
    Darkens,
    /// A warning stays as it last was (BUS-108).
    Keeps,
}

/// What a condition looks at.
pub(super) enum When {
    /// The value is this.
    Is(Value, i32),
    /// The value is this or more.
    AtLeast(Value, i32),
    /// The value has fallen below the first limit and has not yet risen above the second.
    Low(Value, i32, i32),
    /// A node has stopped sending.
    AnySilent,
}

/// One of the conditions that light a telltale.
pub(super) struct Condition {
    pub(super) when: When,
    /// Not for a vehicle that sends this: it commands the telltale itself (C5-34, BUS-111).
    pub(super) unless_sent: Option<Value>,
}

impl Condition {
    const fn unless_sent(mut self, value: Value) -> Self {
        self.unless_sent = Some(value);
        self
    }
}

const fn when(when: When) -> Condition {
    Condition { when, unless_sent: None }
}

const fn is(value: Value, number: i32) -> Condition {
    when(When::Is(value, number))
}

const fn at_least(value: Value, number: i32) -> Condition {
    when(When::AtLeast(value, number))
}

const fn low(value: Value, on_below: i32, off_above: i32) -> Condition {
    when(When::Low(value, on_below, off_above))
}

/// What the first value of a fault says.
const fn fault(fault: FaultId) -> Condition {
    value_of(fault, 0)
}

/// What value `place` of a fault says, counted from 0 through all its routes.
const fn value_of(fault: FaultId, place: usize) -> Condition {
    let routes = fault.row().routes;
    let (mut route, mut before) = (0, 0);
    while route < routes.len() {
        let at = place - before;
        let values = match routes[route].when {
            Reports::Level(value) if at == 0 => return at_least(value, 1),
            Reports::Is(value, number) if at == 0 => return is(value, number),
            Reports::AnyIs(values, number) if at < values.len() => return is(values[at], number),
            Reports::Level(_) | Reports::Is(..) => 1,
            Reports::AnyIs(values, _) => values.len(),
            _ => panic!("a telltale follows values only"),
        };
        (route, before) = (route + 1, before + values);
    }
    panic!("the fault has no such value")
}

/// What lights a telltale and what silence does to it.
pub(super) struct Row {
    pub(super) silence: Silence,
    pub(super) conditions: &'static [Condition],
}

macro_rules! telltales {
    ($($(#[$doc:meta])* $name:ident $key:literal $zh:literal $en:literal, $colour:ident, $place:expr, $silence:ident:
       $($condition:expr),+;)*) => {
        /// A telltale of the cluster.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        #[repr(u8)]
        pub enum Telltale { $($(#[$doc])* $name),* }

        impl Telltale {
            /// Every telltale, in the order of its bits in records.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Returns the public name: scenarios, the bench page, `replay` and the symbol have it.
            pub const fn key(self) -> &'static str {
                match self { $(Self::$name => $key),* }
            }

            /// Returns what a person calls it, in Chinese.
            pub const fn zh(self) -> &'static str {
                match self { $(Self::$name => $zh),* }
            }

            /// Returns what a person calls it, in English.
            pub const fn en(self) -> &'static str {
                match self { $(Self::$name => $en),* }
            }

            /// Returns the colour it lights in.
            pub const fn colour(self) -> TelltaleColour {
                match self { $(Self::$name => TelltaleColour::$colour),* }
            }

            /// Returns where it stands on the panel.
            pub const fn place(self) -> Place {
                match self { $(Self::$name => $place),* }
            }
        }

        /// The conditions, in the order of [`Telltale::ALL`].
        pub(super) const ROWS: &[Row] = &[$(Row { silence: Silence::$silence, conditions: &[$($condition),+] }),*];
    };
}

/// State of charge below which the telltale lights and above which it goes out, in 0.1 % (BUS-R096).
const SOC_LOW: i32 = 200;
const SOC_LOW_CLEAR: i32 = 220;

const OPEN: i32 = Contactor::Open.number();
const CHARGING: i32 = Charge::Charging.number();

use FaultId as F;
use Place::{Cell, With};
use Value as V;

#[rustfmt::skip]
telltales! {
    /// Left direction indicator.
    TurnLeft "turn_left" "左转" "Left turn", Green, Cell(0, 0), Darkens: is(V::BodyTurnLeft, 1);
    /// Right direction indicator.
    TurnRight "turn_right" "右转" "Right turn", Green, Cell(0, 11), Darkens: is(V::BodyTurnRight, 1);
    /// Dipped beam.
    LowBeam "low_beam" "近光" "Low beam", Green, Cell(0, 2), Darkens: is(V::BodyLowBeam, 1);
    /// Main beam.
    HighBeam "high_beam" "远光" "High beam", Blue, Cell(0, 1), Darkens: is(V::BodyHighBeam, 1);
    /// Front fog lamps.
    FrontFog "front_fog" "前雾灯" "Front fog", Green, Cell(0, 3), Darkens: is(V::BodyFrontFog, 1);
    /// Rear fog lamps.
    RearFog "rear_fog" "后雾灯" "Rear fog", Yellow, Cell(0, 4), Darkens: is(V::BodyRearFog, 1);
    /// Torque may be sent; a word of two cells.
    Ready "ready" "READY" "READY", Green, Cell(0, 5), Darkens: is(V::VehicleReady, 1);
    /// System fault, leakage included.
    SystemFault "system_fault" "系统故障" "System fault", Red, Cell(1, 0), Keeps:
        fault(F::VehicleFault), fault(F::VehicleLevel).unless_sent(V::VehicleFault), fault(F::ControllerLevel);
    /// Traction battery fault.
    BatteryFault "battery_fault" "电池故障" "Battery fault", Red, Cell(1, 1), Keeps:
        fault(F::Battery), value_of(F::Battery, 1), fault(F::BatteryFault), fault(F::BatterySmoke);
    /// Motor or inverter fault.
    MotorFault "motor_fault" "电机故障" "Motor fault", Red, Cell(1, 2), Keeps:
        fault(F::Inverter), fault(F::Motor);
    /// Insulation fault.
    Insulation "insulation" "绝缘故障" "Insulation", Red, Cell(1, 3), Keeps:
        fault(F::Insulation), fault(F::InsulationFault);
    /// Drive power or torque is limited.
    PowerLimited "power_limited" "功率受限" "Power limited", Yellow, Cell(0, 10), Darkens:
        fault(F::PowerLimit), fault(F::TorqueLimit);
    /// State of charge is low.
    LowCharge "low_charge" "电量低" "Low charge", Yellow, Cell(0, 9), Darkens:
        low(V::BatterySoc, SOC_LOW, SOC_LOW_CLEAR).unless_sent(V::BatteryLow), is(V::BatteryLow, 1);
    /// Traction battery is cut off.
    BatteryCut "battery_cut" "电池切断" "Battery cut off", Yellow, Cell(1, 4), Darkens: is(V::ContactorMain, OPEN);
    /// Charge plug inserted.
    ChargePlug "charge_plug" "充电枪" "Charge plug", Red, Cell(0, 8), Darkens: is(V::ChargePlug, 1);
    /// Charging.
    Charging "charging" "充电中" "Charging", Yellow, Cell(0, 7), Darkens: is(V::ChargeState, CHARGING);
    /// Low-voltage supply (DC/DC converter) fault.
    LowVoltage "low_voltage" "低压电源" "Low voltage", Red, Cell(1, 5), Keeps:
        fault(F::Dcdc), value_of(F::Dcdc, 1), fault(F::Supply), value_of(F::Supply, 1);
    /// Steering assistance fault.
    Steering "steering" "转向助力" "Steering", Red, Cell(1, 6), Keeps: fault(F::Steering);
    /// Air compressor fault.
    Compressor "compressor" "空压机" "Compressor", Yellow, Cell(1, 8), Keeps:
        fault(F::Compressor), value_of(F::Compressor, 1);
    /// Parking brake on.
    ParkingBrake "parking_brake" "驻车制动" "Parking brake", Red, Cell(1, 10), Darkens: is(V::BodyParkingBrake, 1);
    /// A door is open.
    Door "door" "车门" "Door", Red, Cell(1, 9), Darkens:
        is(V::BodyDoorFront, 1), is(V::BodyDoorMiddle, 1), is(V::BodyDoorRear, 1), is(V::BodyDoorHatch, 1);
    /// Air pressure low.
    AirPressure "air_pressure" "气压低" "Air pressure", Red, Cell(1, 7), Keeps:
        low(V::AirFront, AIR_LOW, AIR_LOW - 1), low(V::AirRear, AIR_LOW, AIR_LOW - 1);
    /// A node has stopped sending.
    NoCommunication "no_communication" "通信中断" "No communication", Red, Cell(1, 11), Darkens: when(When::AnySilent);
    /// Anti-lock brake fault (C5-R012).
    AntiLock "anti_lock" "ABS" "ABS", Yellow, With(Telltale::FrontFog), Keeps: fault(F::BrakeAbs);
    /// Brake force distribution fault (C5-R012).
    BrakeForce "brake_force" "EBD" "EBD", Yellow, With(Telltale::RearFog), Keeps: fault(F::BrakeEbd);
}

/// Which telltales are lit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Telltales(u32);

impl Telltales {
    /// Every telltale dark.
    pub const NONE: Self = Self(0);
    /// Every telltale lit: the check after start.
    pub const ALL: Self = Self((1 << Telltale::ALL.len()) - 1);

    /// Lights or darkens `telltale`.
    pub fn set(&mut self, telltale: Telltale, lit: bool) {
        let bit = 1 << telltale as u8;
        if lit {
            self.0 |= bit;
        } else {
            self.0 &= !bit;
        }
    }

    /// Returns whether `telltale` is lit.
    pub const fn is_lit(self, telltale: Telltale) -> bool {
        self.0 >> telltale as u8 & 1 != 0
    }

    /// Returns the telltales as bits, bit n = `Telltale::ALL[n]`.
    pub const fn bits(self) -> u32 {
        self.0
    }

    /// Returns those that a panel shows now: of two that share a cell and are both lit, the one whose turn it is.
    ///
    /// `is_second_turn` changes every half second ([`View::heartbeat`](crate::View::heartbeat)).
    pub fn in_turn(self, is_second_turn: bool) -> Self {
        let mut shown = self;
        for &guest in Telltale::ALL {
            let With(host) = guest.place() else { continue };
            if self.is_lit(guest) && self.is_lit(host) {
                shown.set(if is_second_turn { host } else { guest }, false);
            }
        }
        shown
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a condition looks at, as one can compare it.
    fn seen(condition: &Condition) -> (Value, i32, bool) {
        match condition.when {
            When::Is(value, number) => (value, number, false),
            When::AtLeast(value, number) => (value, number, true),
            When::Low(..) | When::AnySilent => panic!("no fault says this"),
        }
    }

    #[test]
    fn a_telltale_follows_the_values_of_a_fault_through_all_its_routes() {
        assert_eq!(seen(&fault(F::VehicleFault)), (V::VehicleFault, 1, false));
        assert_eq!(seen(&fault(F::Battery)), (V::BatteryFaultLevel, 1, true));
        assert_eq!(seen(&value_of(F::Battery, 1)), (V::VehicleBatteryLevel, 1, true));
        assert_eq!(seen(&fault(F::Dcdc)), (V::DcdcState, 2, false));
        assert_eq!(seen(&value_of(F::Supply, 0)), (V::SupplyLow, 1, false));
        assert_eq!(seen(&value_of(F::Supply, 1)), (V::VehicleSupplyLow, 1, false));
    }
}
