//! The lamps of the cluster: fixed places, fixed colours.
//!
//! Owns the list and the colour of each lamp; when a lamp is lit is decided by the cluster's tables.
//! Source: ISO 2575 clause 5 / UN R121: red = danger, yellow = caution, green = in operation, blue = high beam only.

/// Colour of a lamp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lamp {
    /// Danger: act at once.
    Red,
    /// Caution: outside normal limits.
    Yellow,
    /// In normal operation.
    Green,
    /// High beam, nothing else.
    Blue,
}

macro_rules! telltales {
    ($($(#[$doc:meta])* $name:ident $colour:ident;)*) => {
        /// A lamp of the cluster.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        #[repr(u8)]
        pub enum Telltale { $($(#[$doc])* $name),* }

        impl Telltale {
            /// Every lamp, in the order of its place on the screen.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Returns the colour of the lamp.
            pub const fn colour(self) -> Lamp {
                match self { $(Self::$name => Lamp::$colour),* }
            }
        }
    };
}

telltales! {
    /// Left direction indicator.
    TurnLeft Green;
    /// Right direction indicator.
    TurnRight Green;
    /// Dipped beam.
    LowBeam Green;
    /// Main beam.
    HighBeam Blue;
    /// Front fog lamps.
    FrontFog Green;
    /// Rear fog lamps.
    RearFog Yellow;
    /// Torque may be sent.
    Ready Green;
    /// System fault, leakage included.
    SystemFault Red;
    /// Traction battery fault.
    BatteryFault Red;
    /// Motor or motor controller fault.
    MotorFault Red;
    /// Insulation fault.
    Insulation Red;
    /// Drive power or torque is limited.
    PowerLimited Yellow;
    /// State of charge is low.
    LowCharge Yellow;
    /// Traction battery is cut off.
    BatteryCut Yellow;
    /// Charge plug inserted.
    ChargePlug Red;
    /// Charging.
    Charging Yellow;
    /// Low-voltage supply (DC/DC converter) fault.
    LowVoltage Red;
    /// Steering assistance fault.
    Steering Red;
    /// Air compressor fault.
    Compressor Yellow;
    /// Parking brake on.
    ParkingBrake Red;
    /// A door is open.
    Door Red;
    /// Air pressure low.
    AirPressure Red;
    /// A node has stopped sending.
    NoCommunication Red;
}

/// Which lamps are lit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Telltales(u32);

impl Telltales {
    /// Every lamp dark.
    pub const NONE: Self = Self(0);
    /// Every lamp lit: the bulb check.
    pub const ALL: Self = Self((1 << Telltale::ALL.len()) - 1);

    /// Lights or darkens `lamp`.
    pub fn set(&mut self, lamp: Telltale, lit: bool) {
        let bit = 1 << lamp as u8;
        if lit {
            self.0 |= bit;
        } else {
            self.0 &= !bit;
        }
    }

    /// Returns whether `lamp` is lit.
    pub const fn is_lit(self, lamp: Telltale) -> bool {
        self.0 >> lamp as u8 & 1 != 0
    }

    /// Returns the lamps as bits, bit n = `Telltale::ALL[n]`.
    pub const fn bits(self) -> u32 {
        self.0
    }
}
