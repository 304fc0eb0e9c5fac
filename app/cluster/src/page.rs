//! The pages of the screen: which one is shown, what leads from one to another, what stands on the technical one.
//!
//! | what happens                                  | the screen shows                                      |
//! |-----------------------------------------------|-------------------------------------------------------|
//! | a short push of `next`                        | the next page, or the next part of a long one         |
//! | a long push of `next`                         | a trip from zero; on any other page the main page     |
//! | a STOP that nobody has silenced, or fire      | the main page, whatever was there                     |
//! | a plug is inserted while the vehicle stands   | the energy page, until the plug is drawn              |
//! | [`IDLE_MS`] without a push in a driving vehicle | the main page in place of lists and technical pages |
//!
//! Owns the place in the book of pages and the table of technical parts; refuses to know what rows say and how they
//! look. Source: BUS-R033, BUS-R038, BUS-R060, BUS-R067, BUS-R120, BUS-R124, BUS-R126, BUS-R143; reading BUS-43.

use crate::trip::Trip;
use crate::view::{List, Plug, Sheet};
use protocol_core::Millis;
use protocol_core::model::{Shown, Value};

/// Rows of a list that stand on one part of its page.
pub const ROWS: usize = 4;
/// Values of a technical part, at most.
pub const CELLS: usize = 14;

/// Time without a push after which a driving vehicle shows its main page, in milliseconds.
const IDLE_MS: u64 = 30_000;
/// Speed from which a vehicle drives, in 1/256 km/h.
const DRIVING: i32 = 5 * 256;

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
    /// State of the controller, see [`Controller::state`](crate::inputs::Controller::state); 0 = it does not answer.
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

/// A leaf of the book of pages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Leaf {
    Main,
    Trip(Trip),
    Energy,
    /// Part of the list, from 0.
    Faults(u8),
    /// Part of the list, from 0.
    History(u8),
    /// Place in [`Part::ALL`].
    Technic(u8),
}

/// What turning needs to know.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Contents {
    /// Active faults.
    pub(crate) faults: usize,
    /// Remembered faults.
    pub(crate) history: usize,
    /// Technical parts of which the vehicle sends something, bit n = n-th of [`Part::ALL`].
    pub(crate) parts: u8,
}

/// Returns the parts of a list of `rows`; an empty list says so on one.
pub(crate) fn parts_of(rows: usize) -> u8 {
    rows.div_ceil(ROWS).clamp(1, u8::MAX.into()) as u8
}

impl Contents {
    fn first_part(self, from: u8) -> Option<u8> {
        (from..Part::ALL.len() as u8).find(|&part| self.parts >> part & 1 != 0)
    }

    /// Returns the leaf behind `leaf`.
    fn after(self, leaf: Leaf) -> Leaf {
        match leaf {
            Leaf::Main => Leaf::Trip(Trip::A),
            Leaf::Trip(Trip::A) => Leaf::Trip(Trip::B),
            Leaf::Trip(Trip::B) => Leaf::Energy,
            Leaf::Energy => Leaf::Faults(0),
            Leaf::Faults(part) if part + 1 < parts_of(self.faults) => Leaf::Faults(part + 1),
            Leaf::Faults(_) => Leaf::History(0),
            Leaf::History(part) if part + 1 < parts_of(self.history) => Leaf::History(part + 1),
            Leaf::History(_) => self.first_part(0).map_or(Leaf::Main, Leaf::Technic),
            Leaf::Technic(part) => self.first_part(part + 1).map_or(Leaf::Main, Leaf::Technic),
        }
    }
}

/// What leads from page to page by itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Situation {
    /// A STOP or fire that nobody has silenced.
    pub(crate) is_alarming: bool,
    /// What an inserted plug does.
    pub(crate) plug: Option<Plug>,
    /// Road speed in 1/256 km/h.
    pub(crate) speed: Shown<i32>,
}

/// The open book.
#[derive(Clone, Copy)]
pub(crate) struct Pages {
    leaf: Leaf,
    /// The last push.
    pushed: Option<Millis>,
    /// A plug was inserted in a standing vehicle as of the last look.
    was_plugged: bool,
}

impl Pages {
    pub(crate) const fn new() -> Self {
        Self { leaf: Leaf::Main, pushed: None, was_plugged: false }
    }

    /// Returns the page that is shown.
    pub(crate) fn leaf(&self) -> Leaf {
        self.leaf
    }

    /// Takes a short push.
    pub(crate) fn turn(&mut self, contents: Contents, now: Millis) {
        self.leaf = contents.after(self.leaf);
        self.pushed = Some(now);
    }

    /// Takes a long push; returns the trip that it sets to zero.
    pub(crate) fn hold(&mut self, now: Millis) -> Option<Trip> {
        self.pushed = Some(now);
        if let Leaf::Trip(trip) = self.leaf {
            return Some(trip);
        }
        self.leaf = Leaf::Main;
        None
    }

    /// Lets the situation lead; to be called every tick.
    pub(crate) fn follow(&mut self, situation: Situation, now: Millis) {
        let speed = situation.speed.value().unwrap_or(0);
        let is_plugged = situation.plug.is_some() && speed == 0;
        if is_plugged != self.was_plugged {
            self.was_plugged = is_plugged;
            match self.leaf {
                _ if is_plugged => self.leaf = Leaf::Energy,
                Leaf::Energy => self.leaf = Leaf::Main,
                _ => {}
            }
        }
        let is_idle = self.pushed.is_none_or(|pushed| now.since(pushed) >= IDLE_MS);
        let distracts = matches!(self.leaf, Leaf::Faults(_) | Leaf::History(_) | Leaf::Technic(_));
        if situation.is_alarming || distracts && is_idle && speed >= DRIVING {
            self.leaf = Leaf::Main;
        }
    }
}
