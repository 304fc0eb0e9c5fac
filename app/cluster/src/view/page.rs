//! The pages, and what stands on the technical one.
//!
//! Owns the table of technical parts; refuses to know what rows say and how they look.
//! Source: BUS-R033, BUS-R038, BUS-R067.

use super::{List, Sheet};
use protocol_core::model::Value;

/// Rows of a list that stand on one part of its page.
pub const ROWS: usize = 4;
/// Values of a technical part, at most.
pub const CELLS: usize = 14;

/// A trip that the driver can reset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trip {
    /// Trip A.
    A,
    /// Trip B.
    B,
}

/// A page with what only it shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Page {
    /// Speed, charge, power: what is driven by.
    #[default]
    Main,
    /// One trip of the driver.
    Trip(Trip),
    /// Consumption and range; charging while a plug is inserted.
    Energy,
    /// Faults that are active, the worst first.
    Faults(List),
    /// Faults since power-on, the latest first.
    History(List),
    /// Relays, codes, cells and counters for whoever looks after the vehicle.
    Technic(Sheet),
}

/// Public names of the pages by their numbers; all numbers from the last on are technical.
pub const KEYS: [&str; 7] = ["main", "trip_a", "trip_b", "energy", "faults", "history", "technic"];

/// Returns the public name of a page by its number in records; of a technical one that of its part.
pub fn key_of(number: u8) -> Option<&'static str> {
    let technic = KEYS.len() - 1;
    match usize::from(number) {
        place if place < technic => Some(KEYS[place]),
        place => Part::ALL.get(place - technic).map(|part| part.key()),
    }
}

impl Page {
    /// Returns the number that stands in records: 0 main, 1 and 2 trips, 3 energy, 4 faults, 5 history, 6 and more
    /// technical.
    pub const fn number(self) -> u8 {
        match self {
            Self::Main => 0,
            Self::Trip(Trip::A) => 1,
            Self::Trip(Trip::B) => 2,
            Self::Energy => 3,
            Self::Faults(_) => 4,
            Self::History(_) => 5,
            Self::Technic(sheet) => 6 + sheet.part as u8,
        }
    }
}

/// One part of the technical page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum Part {
    /// Relays as the vehicle controller reports them (BUS-R038).
    #[default]
    Relays,
    /// Contactors in the battery (BUS-R067).
    Contactors,
    /// Contactors as the contactor box measures them.
    Box,
    /// Fault codes as numbers (BUS-R033).
    Codes,
    /// Highest and lowest cell and where they are.
    Extremes,
    /// What the CAN bus and its controller count.
    Bus,
}

impl Part {
    /// Every part, in the order of its pages.
    pub const ALL: &'static [Self] =
        &[Self::Relays, Self::Contactors, Self::Box, Self::Codes, Self::Extremes, Self::Bus];

    /// Returns the public name.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Relays => "relays",
            Self::Contactors => "contactors",
            Self::Box => "box",
            Self::Codes => "codes",
            Self::Extremes => "extremes",
            Self::Bus => "bus",
        }
    }

    /// Returns the values of the part, in the order of [`Sheet::cells`]; none = [`Count`] in its order.
    pub const fn values(self) -> &'static [Value] {
        use Value as V;
        match self {
            Self::Relays => &[
                V::RelayBattery,
                V::RelayMotor,
                V::RelayPrecharge,
                V::RelayAccessory,
                V::RelayAccessoryPrecharge,
                V::RelayDefrost,
                V::RelayCharge,
                V::RelayCutoff,
            ],
            Self::Contactors => &[
                V::ContactorMain,
                V::ContactorNegative,
                V::ContactorCharge1,
                V::ContactorCharge2,
                V::ContactorHeater,
            ],
            Self::Box => &[
                V::BoxBattery,
                V::BoxMotor,
                V::BoxMotorPrecharge,
                V::BoxAccessory,
                V::BoxAccessoryPrecharge,
                V::BoxDefrost,
                V::BoxHeater,
                V::BoxCharge1,
                V::BoxCharge2,
            ],
            Self::Codes => &[
                V::VehicleFaultCode,
                V::BatteryFaultCode,
                V::MotorFaultCode,
                V::SteeringFaultCode,
                V::DcdcFaultCode,
                V::CompressorFaultCode,
                V::InsulationFaultCode,
                V::ChargerFaultCode,
            ],
            Self::Extremes => &[
                V::BatteryCellMax,
                V::BatteryCellMaxBox,
                V::BatteryCellMaxCell,
                V::BatteryCellMaxNumber,
                V::BatteryCellMin,
                V::BatteryCellMinBox,
                V::BatteryCellMinCell,
                V::BatteryCellMinNumber,
                V::BatteryTemperatureMax,
                V::BatteryTemperatureMaxBox,
                V::BatteryTemperatureMaxModule,
                V::BatteryTemperatureMin,
                V::BatteryTemperatureMinBox,
                V::BatteryTemperatureMinModule,
            ],
            Self::Bus => &[],
        }
    }
}

/// What the bus part counts, in the order of [`Sheet::cells`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Count {
    /// State of the controller, see [`Controller::state`](crate::driver::inputs::Controller::state); 0 = it does not answer.
    State,
    /// Transmit error counter.
    TransmitErrors,
    /// Receive error counter.
    ReceiveErrors,
    /// Frames that were sent.
    Sent,
    /// Frames whose values were stored.
    Stored,
    /// Frames of nobody's.
    Unknown,
    /// Frames that the controller or the queue had no room for.
    Lost,
    /// Frames with too few bytes.
    Short,
    /// Frames with a wrong checksum.
    Damaged,
}

impl Count {
    /// Every counter, in order.
    pub const ALL: &'static [Self] = &[
        Self::State,
        Self::TransmitErrors,
        Self::ReceiveErrors,
        Self::Sent,
        Self::Stored,
        Self::Unknown,
        Self::Lost,
        Self::Short,
        Self::Damaged,
    ];
}
