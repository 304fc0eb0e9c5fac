//! What is to be shown: everything the screens need, already decided.
//!
//! The cluster fills a [`View`], the UI draws it. Two equal views give equal pixels.

pub mod page;

use crate::faults::Named;
use crate::telltales::Telltales;
use page::{Chapter, Page, ROWS, VALUES};
use protocol_core::Millis;
use protocol_core::model::{Gear, Severity, Shown};
use protocol_core::vehicle::Vehicle;

pub use crate::text::Text;
pub use protocol_core::states::Plug;

/// Language of the screens.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// Simplified Chinese.
    #[default]
    Chinese,
    /// English.
    English,
}

/// Colours of the screens.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Dark background, for night and for most days.
    #[default]
    Night,
    /// Light background, for direct sun.
    Day,
}

/// The message line at the bottom: one fault or one plain fact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// Which fault.
    pub named: Named,
    /// Colour of the line; [`Severity::None`] = information.
    pub severity: Severity,
    /// What is said.
    pub text: Text,
    /// Fault code, shown as a number.
    pub code: Option<u16>,
    /// This line's number among those that take turns, from 1.
    pub position: u8,
    /// How many lines take turns.
    pub count: u8,
}

impl Line {
    /// Returns what the driver can do; `None` = what its severity says.
    pub fn advice(&self) -> Option<Text> {
        self.named.fault.advice()
    }

    /// Returns the only line.
    pub fn of(named: Named, severity: Severity, vehicle: &Vehicle) -> Self {
        let (text, code) = (named.text(vehicle), named.printed_code());
        Self { named, severity, text, code, position: 1, count: 1 }
    }
}

/// One fault that is active, whether the line shows it now or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ActiveFault {
    /// Which fault.
    pub named: Named,
    /// Fault code, shown as a number.
    pub code: Option<u16>,
    /// How bad it is now.
    pub severity: Severity,
    /// What is said.
    pub text: Text,
    /// When it came, since power-on.
    pub first: Millis,
    /// How often it has come since power-on.
    pub count: u16,
}

/// One row of a list of faults.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Listed {
    /// How bad it is now, or has been at its worst.
    pub severity: Severity,
    /// What is said.
    pub text: Text,
    /// Fault code, shown as a number.
    pub code: Option<u16>,
    /// How often it has come since power-on.
    pub count: u16,
    /// When it came, in seconds since power-on.
    pub at_s: u32,
}

/// The part of a list of faults that is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct List {
    /// The rows, without gaps.
    pub rows: [Option<Listed>; ROWS],
    /// This part's number, from 1.
    pub position: u8,
    /// How many parts the list has.
    pub count: u8,
}

/// The chapter of the technical page that is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sheet {
    /// Which values these are.
    pub chapter: Chapter,
    /// Its values, in the order of [`Chapter::items`] or of [`Count`](page::Count); the rest is never seen.
    pub values: [Shown<i32>; VALUES],
    /// This chapter's number among those that the vehicle has, from 1.
    pub position: u8,
    /// How many chapters the vehicle has.
    pub count: u8,
}

/// Limp mode: the vehicle drives without word from its battery (BUS-R080); there is no regeneration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limp {
    /// Largest current in 0.1 A (BUS-R081); `None` = the rated capacity was never heard.
    pub limit_deciamps: Option<i32>,
}

/// A trip of the driver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Journey {
    /// Distance in 0.1 km.
    pub hectometres: u32,
    /// Average consumption in Wh/km, regained energy taken off; `None` = too short to say.
    pub average_whkm: Option<i32>,
    /// Energy out of the battery in Wh.
    pub used_watthours: u32,
    /// Energy back into the battery by driving in Wh.
    pub regained_watthours: u32,
}

/// How far the vehicle will go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// Whole kilometres, rounded down.
    pub km: u16,
    /// The cluster's own estimate: to be marked as such.
    pub is_estimated: bool,
}

/// What there is to tell while a plug is inserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Charging {
    /// What the plug does.
    pub plug: Plug,
    /// Voltage in 0.1 V.
    pub decivolts: Shown<i32>,
    /// Current in 0.1 A, positive = into the battery.
    pub deciamps: Shown<i32>,
    /// Power in 0.1 kW, positive = into the battery.
    pub hectowatts: Shown<i32>,
    /// Minutes until full at the present current; `None` = cannot be told.
    pub minutes_left: Option<u16>,
}

/// What the screens show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    /// Road speed, whole km/h, rounded down.
    pub speed_kmh: Shown<u16>,
    /// Gear; `None` = no icon at all (BUS-R015).
    pub gear: Option<Gear>,
    /// State of charge, whole percent, rounded down (BUS-115).
    pub soc_percent: Shown<u8>,
    /// Pack voltage in 0.1 V.
    pub pack_decivolts: Shown<i32>,
    /// Pack current in 0.1 A, positive = out of the battery.
    pub pack_deciamps: Shown<i32>,
    /// Pack power in 0.1 kW, positive = out of the battery.
    pub power_hectowatts: Shown<i32>,
    /// Motor speed in rpm, negative = backwards.
    pub motor_rpm: Shown<i32>,
    /// Motor temperature in degrees Celsius.
    pub motor_celsius: Shown<i32>,
    /// Motor controller temperature in degrees Celsius.
    pub inverter_celsius: Shown<i32>,
    /// Highest and lowest cell voltage in mV.
    pub cell_millivolts: (Shown<i32>, Shown<i32>),
    /// Highest and lowest cell temperature in degrees Celsius.
    pub cell_celsius: (Shown<i32>, Shown<i32>),
    /// Total distance in 0.1 km.
    pub odometer_hectometres: u32,
    /// Trip A and trip B.
    pub journeys: [Journey; 2],
    /// Present consumption in Wh/km, negative = regained; `Never` below 5 km/h.
    pub consumption_whkm: Shown<i32>,
    /// Remaining range.
    pub range: Shown<Range>,
    /// Charging, while a plug is inserted.
    pub charging: Option<Charging>,
    /// Limp mode, while it holds.
    pub limp: Option<Limp>,
    /// Seconds until the battery opens the high-voltage circuit, while it asks for that (BUS-68).
    pub hv_off_s: Option<u8>,
    /// The page, with what only it shows.
    pub page: Page,
    /// Lit lamps; all of them during their check after start, whatever is true.
    pub telltales: Telltales,
    /// Drive power or torque is limited.
    pub is_power_limited: bool,
    /// The low-charge telltale's condition holds: the bar takes its colour.
    pub is_charge_low: bool,
    /// Worst severity that is active.
    pub severity: Severity,
    /// The message line.
    pub line: Option<Line>,
    /// A STOP or DERATE that came and went, until it is acknowledged.
    pub unseen: Option<Line>,
    /// It has the place of the message line now.
    pub says_unseen: bool,
    /// What is milder than the STOP on the line: the documents want it on the main screen, too.
    pub below: Option<Line>,
    /// It has the place of the message line now.
    pub says_below: bool,
    /// A STOP or fire that nobody has acknowledged: it takes the main page over.
    pub alarm: Option<Line>,
    /// Toggles every half second while the firmware lives: a frozen screen is noticed.
    pub heartbeat: bool,
    /// Language of every text on the panel.
    pub language: Language,
    /// Colours.
    pub theme: Theme,
}

impl Default for View {
    fn default() -> Self {
        Self {
            speed_kmh: Shown::Never,
            gear: None,
            soc_percent: Shown::Never,
            pack_decivolts: Shown::Never,
            pack_deciamps: Shown::Never,
            power_hectowatts: Shown::Never,
            motor_rpm: Shown::Never,
            motor_celsius: Shown::Never,
            inverter_celsius: Shown::Never,
            cell_millivolts: (Shown::Never, Shown::Never),
            cell_celsius: (Shown::Never, Shown::Never),
            odometer_hectometres: 0,
            journeys: [Journey::default(); 2],
            consumption_whkm: Shown::Never,
            range: Shown::Never,
            charging: None,
            limp: None,
            hv_off_s: None,
            page: Page::Main,
            telltales: Telltales::NONE,
            is_power_limited: false,
            is_charge_low: false,
            severity: Severity::None,
            line: None,
            unseen: None,
            says_unseen: false,
            below: None,
            says_below: false,
            alarm: None,
            heartbeat: false,
            language: Language::default(),
            theme: Theme::default(),
        }
    }
}
