//! Which page is shown and what leads from one to another.
//!
//! | what happens                                  | the screen shows                                      |
//! |-----------------------------------------------|-------------------------------------------------------|
//! | a short push of `next`                        | the next page, or the next part of a long one         |
//! | a long push of `next`                         | a trip from zero; on any other page the main page     |
//! | a STOP that nobody has silenced, or fire      | the main page, whatever was there                     |
//! | a plug is inserted while the vehicle stands   | the energy page, until the plug is drawn              |
//! | [`IDLE_MS`] without a push in a driving vehicle | the main page in place of lists and technical pages |
//!
//! Owns the place among the pages; refuses to know what stands on them.
//! Source: BUS-R060, BUS-R120, BUS-R124, BUS-R126, BUS-R143; reading BUS-43.

use crate::view::Plug;
use crate::view::page::{Chapter, ROWS, Trip};
use protocol_core::Millis;
use protocol_core::model::Shown;

/// Time without a push after which a driving vehicle shows its main page, in milliseconds.
const IDLE_MS: u64 = 30_000;
/// Speed from which a vehicle drives, in 1/256 km/h.
const DRIVING: i32 = 5 * 256;

/// One page, with its part of a long one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Leaf {
    Main,
    Trip(Trip),
    Energy,
    /// Part of the list, from 0.
    Faults(u8),
    /// Part of the list, from 0.
    History(u8),
    /// Place in [`Chapter::ALL`].
    Technic(u8),
}

/// What turning needs to know.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Contents {
    /// Active faults.
    pub(crate) faults: usize,
    /// Remembered faults.
    pub(crate) history: usize,
    /// Chapters of which the vehicle sends something, bit n = n-th of [`Chapter::ALL`].
    pub(crate) chapters: u16,
}

/// Returns the parts of a list of `rows`; an empty list says so on one.
pub(crate) fn parts_of(rows: usize) -> u8 {
    rows.div_ceil(ROWS).clamp(1, u8::MAX.into()) as u8
}

impl Contents {
    fn first_chapter(self, from: u8) -> Option<u8> {
        (from..Chapter::ALL.len() as u8).find(|&chapter| self.chapters >> chapter & 1 != 0)
    }

    /// Returns the page behind `leaf`.
    fn after(self, leaf: Leaf) -> Leaf {
        match leaf {
            Leaf::Main => Leaf::Trip(Trip::A),
            Leaf::Trip(Trip::A) => Leaf::Trip(Trip::B),
            Leaf::Trip(Trip::B) => Leaf::Energy,
            Leaf::Energy => Leaf::Faults(0),
            Leaf::Faults(part) if part + 1 < parts_of(self.faults) => Leaf::Faults(part + 1),
            Leaf::Faults(_) => Leaf::History(0),
            Leaf::History(part) if part + 1 < parts_of(self.history) => Leaf::History(part + 1),
            Leaf::History(_) => self.first_chapter(0).map_or(Leaf::Main, Leaf::Technic),
            Leaf::Technic(chapter) => self.first_chapter(chapter + 1).map_or(Leaf::Main, Leaf::Technic),
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

/// The page that is shown, and since when.
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
