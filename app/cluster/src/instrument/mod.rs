//! The instrument without its hardware: the one door to all of its logic.
//!
//! Frames and raw inputs go in; what the controller should do, frames to send, a [`View`] and a [`Chime`] come out. The
//! firmware, the bench's runs on the host and the player of recordings all use it, so they cannot differ.
//!
//! | part               | decides                                                        |
//! |--------------------|----------------------------------------------------------------|
//! | `identification`   | which vehicle this is, when it is certain                      |
//! | `bitrate`          | at which bit rate to listen until then                         |
//! | `Debounce`         | which contacts are closed                                      |
//! | [`Cluster`]        | everything that follows from frames, inputs and time           |
//! | `own`              | what the instrument says of itself                             |
//! | `outbox`           | which frames wait, which go when the bus takes none            |
//! | `kept`             | what outlives power-off, and when each part of it is due      |
//! | `rota`             | which faults are reported to a PC in one round                 |
//!
//! Until the vehicle is known the cluster decodes no message and the frames received are kept; until it is certain, and
//! while the bus contradicts it, nothing is sent. What a wrong vehicle has left goes with it: values, faults, distance,
//! frames that wait. Refuses to know pins, controllers and clocks.

pub mod bitrate;
pub mod identification;
mod outbox;
pub mod rota;

use crate::chime::Chime;
use crate::cluster::Cluster;
use crate::driver::debounce::Debounce;
use crate::driver::inputs::{Contacts, Inputs};
use crate::kept::keeper::Keeper;
use crate::kept::parts::{Bytes, Memory, Part};
use crate::monitors::Options;
use crate::own::{Conditions, Restart, Search};
use crate::reception::Received;
use crate::view::View;
use bitrate::BitrateScan;
use identification::Detector;
use outbox::Outbox;
use protocol_core::vehicle::{NO_VEHICLE, Vehicle};
use protocol_core::{CanFrame, Millis};

/// How the CAN controller is to take part in the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Access {
    /// Bit rate in bit/s.
    pub bitrate: u32,
    /// It may send and acknowledge; else it only listens.
    pub may_send: bool,
}

impl Access {
    /// Returns how to start where one of these vehicles is searched for.
    pub const fn searching(vehicles: &'static [&'static Vehicle]) -> Self {
        Self { bitrate: BitrateScan::new(vehicles).bitrate(), may_send: false }
    }

    /// Returns how to take part in the bus of this vehicle.
    pub const fn fixed(vehicle: &Vehicle) -> Self {
        Self { bitrate: vehicle.bitrate, may_send: true }
    }
}

/// The search for the vehicle.
#[derive(Clone)]
struct Identification {
    detector: Detector,
    scan: BitrateScan,
    /// Frames have come since the last look at the bit rate.
    heard: bool,
}

/// Everything that an instrument cluster decides.
#[derive(Clone)]
pub struct Instrument {
    cluster: Cluster,
    /// `None` = it is for one vehicle and searches for none.
    identification: Option<Identification>,
    restart: Option<Restart>,
    /// `None` until the first tick: what is closed then has been so for long.
    contacts: Option<Debounce>,
    outbox: Outbox,
    access: Access,
    keeper: Keeper,
    memory: Memory,
}

impl Instrument {
    /// Returns an instrument that finds out which of `vehicles` it is in.
    ///
    /// # Panics
    ///
    /// As [`Cluster::new`], but for vehicles of which the tables are longer.
    pub const fn searching(vehicles: &'static [&'static Vehicle], options: Options) -> Self {
        let scan = BitrateScan::new(vehicles);
        let access = Access::searching(vehicles);
        let identification = Identification { detector: Detector::new(vehicles), scan, heard: false };
        Self::of(&NO_VEHICLE, options, Some(identification), access)
    }

    /// Returns an instrument for one vehicle: it takes part in the bus from the start.
    ///
    /// # Panics
    ///
    /// As [`Cluster::new`].
    pub const fn fixed(vehicle: &'static Vehicle, options: Options) -> Self {
        let access = Access::fixed(vehicle);
        Self::of(vehicle, options, None, access)
    }

    const fn of(
        vehicle: &'static Vehicle,
        options: Options,
        identification: Option<Identification>,
        access: Access,
    ) -> Self {
        let cluster = Cluster::with_options(vehicle, options);
        Self {
            cluster,
            identification,
            restart: None,
            contacts: None,
            outbox: Outbox::new(),
            access,
            keeper: Keeper::new(),
            memory: Memory::New,
        }
    }

    /// Goes on from a part that was kept over power-off; before the first tick, and before [`Self::resume`].
    pub fn restore(&mut self, part: Part, bytes: &[u8]) {
        self.keeper.restore(&mut self.cluster, part, bytes);
    }

    /// Takes note that every kept part has been restored, and how they were found: from now on parts are due. After
    /// [`Self::restarted`].
    pub fn resume(&mut self, memory: Memory) {
        self.memory = memory;
        self.keeper.begin(&mut self.cluster, memory, self.restart);
        if let Some(Identification { detector, scan, heard: false }) = &mut self.identification
            && detector.found().is_none()
        {
            self.access.bitrate = scan.expect(self.keeper.vehicle());
        }
    }

    /// Takes note that nothing can be kept any more: it is said at the next start, if that can be read then.
    pub const fn memory_failed(&mut self) {
        self.memory = Memory::Damaged;
    }

    /// Returns the part that is to be kept next, with its bytes; once they are, [`Self::saved`] wants to know.
    pub fn due(&self, now: Millis) -> Option<(Part, Bytes)> {
        self.keeper.due(&self.cluster, self.may_send(now), now)
    }

    /// Takes note that a part is kept.
    pub fn saved(&mut self, part: Part, bytes: &Bytes, now: Millis) {
        self.keeper.saved_now(part, bytes, now);
    }

    /// Takes why the instrument has started, if it was a fault of its own: it says so for a while.
    pub const fn restarted(&mut self, restart: Option<Restart>) {
        self.restart = restart;
    }

    /// Takes a frame that was received at `at`; `None` = it is kept until the vehicle is known.
    pub fn hear(&mut self, frame: &CanFrame, at: Millis) -> Option<Received> {
        let Some(Identification { detector, scan, heard }) = &mut self.identification else {
            return Some(self.cluster.receive(frame, at));
        };
        *heard = true;
        let is_known = detector.found().is_some();
        if let Some(found) = detector.hear(frame, scan.bitrate(), at) {
            self.outbox.clear();
            self.cluster.recognise(found.vehicle);
            self.keeper.recall(&mut self.cluster);
            // This frame is the last of them; in place of a certain vehicle it comes alone.
            let last = detector.take_kept().map(|(frame, at)| self.cluster.receive(&frame, at)).last();
            return last.or_else(|| Some(self.cluster.receive(frame, at)));
        }
        is_known.then(|| self.cluster.receive(frame, at))
    }

    /// Takes the inputs as they are at the pins and lets time pass; to be called every 10 ms.
    pub fn tick(&mut self, inputs: &Inputs, now: Millis) {
        let sample = inputs.contacts.bits();
        let contacts = self.contacts.get_or_insert(Debounce::new(sample)).sample(sample);
        let search = self.search(now);
        let controller_missing = inputs.controller.is_some_and(|controller| controller.state.is_none());
        let is_memory_damaged = self.memory == Memory::Damaged;
        self.cluster.know(Conditions {
            controller_missing,
            restart: self.restart,
            search,
            is_memory_damaged,
        });
        self.cluster.tick(&Inputs { contacts: Contacts::of_bits(contacts), ..*inputs }, now);
        self.access.may_send &= self.may_send(now);
        if !self.access.may_send {
            self.outbox.clear();
        }
        // Cycles start when the controller may send: none of the first frames is lost, none comes out of step.
        while self.access.may_send
            && let Some(frame) = self.cluster.transmit(now)
        {
            self.outbox.push(frame);
        }
    }

    /// Returns how far the search for the vehicle is; `None` = there is none.
    fn search(&self, now: Millis) -> Option<Search> {
        self.identification.as_ref().map(|search| search.detector.state(now))
    }

    /// Returns whether the vehicle is certain, and not in doubt.
    fn may_send(&self, now: Millis) -> bool {
        self.identification.as_ref().is_none_or(|search| search.detector.may_answer(now))
    }

    /// Returns how the controller is to take part in the bus, as of the last [`Self::look`].
    pub const fn access(&self) -> Access {
        self.access
    }

    /// Decides how the controller is to take part in the bus; to be called after every tick.
    ///
    /// `errors` tells whether a frame with an error was on the bus since it was asked last; it is asked only while no
    /// vehicle is known.
    pub fn look(&mut self, errors: impl FnOnce() -> bool, now: Millis) -> Access {
        self.access.may_send = self.may_send(now);
        if let Some(Identification { detector, scan, heard }) = &mut self.identification
            && detector.found().is_none()
        {
            let heard = core::mem::take(heard);
            self.access.bitrate = scan.listen(heard, errors(), now).unwrap_or(self.access.bitrate);
        }
        self.access
    }

    /// Offers the oldest frame that waits to the controller; it goes if `take` takes it. Returns whether one has gone.
    pub fn offer(&mut self, take: impl FnOnce(&CanFrame) -> bool) -> bool {
        self.outbox.offer(take)
    }

    /// Returns what is to be shown.
    pub fn view(&self, now: Millis) -> View {
        self.cluster.view(now)
    }

    /// Returns the sound that plays as of the last tick, and whether it is in a tone or in a pause now.
    pub fn chime(&self, now: Millis) -> Option<Chime> {
        self.cluster.chime(now)
    }

    /// Returns the cluster: values, counters and faults for records.
    pub const fn cluster(&self) -> &Cluster {
        &self.cluster
    }
}
