//! A ride in a virtual vehicle: settings as a person writes them, time, and the last frame of every message.

#![allow(dead_code)]

use protocol_core::CanFrame;
use protocol_core::frame::CanId;
use std::collections::BTreeMap;
use virtual_vehicle::{Kind, Options, STEP_MS, VirtualVehicle, World};

/// A vehicle and what it has said so far.
pub(crate) struct Ride {
    vehicle: VirtualVehicle,
    last: BTreeMap<CanId, [u8; 8]>,
    fresh: Vec<(CanId, [u8; 8])>,
}

impl Ride {
    /// A vehicle that stands, key on.
    pub(crate) fn new(kind: Kind) -> Self {
        Self::with(kind, Options::default())
    }

    /// The same, built to order.
    pub(crate) fn with(kind: Kind, options: Options) -> Self {
        Self { vehicle: VirtualVehicle::new(kind, options), last: BTreeMap::new(), fresh: Vec::new() }
    }

    /// A vehicle with READY, lever in N.
    pub(crate) fn ready(kind: Kind) -> Self {
        let mut ride = Self::new(kind);
        ride.set("driver.key", "start");
        ride.until("READY", 5, |ride| ride.world().vcu.ready);
        ride
    }

    /// A vehicle that its driver holds at a speed.
    pub(crate) fn at(kind: Kind, kmh: &str) -> Self {
        let mut ride = Self::ready(kind);
        ride.set("driver.target", kmh);
        ride.seconds(90);
        ride
    }

    /// Sets a control as it is written in a scenario.
    pub(crate) fn set(&mut self, path: &str, text: &str) -> &mut Self {
        let control = self.vehicle.controls().find(|control| control.path == path);
        let setting = control.unwrap_or_else(|| panic!("no control {path}")).read(text).unwrap();
        self.vehicle.set(path, setting).unwrap();
        self
    }

    /// Lets one step pass.
    pub(crate) fn step(&mut self) {
        self.vehicle.advance();
        self.fresh =
            self.vehicle.take_frames().iter().map(|sent| (sent.frame.id, *sent.frame.padded())).collect();
        self.last.extend(self.fresh.iter().copied());
    }

    /// Lets milliseconds pass.
    pub(crate) fn ms(&mut self, ms: u64) -> &mut Self {
        (0..ms / STEP_MS).for_each(|_| self.step());
        self
    }

    /// Lets seconds pass.
    pub(crate) fn seconds(&mut self, seconds: u64) -> &mut Self {
        self.ms(1_000 * seconds)
    }

    /// Lets time pass and looks after every step.
    pub(crate) fn watch(&mut self, seconds: u64, mut look: impl FnMut(&Self)) {
        for _ in 0..1_000 * seconds / STEP_MS {
            self.step();
            look(self);
        }
    }

    /// Waits for something and returns how long it took, in ms.
    pub(crate) fn until(&mut self, what: &str, limit_s: u64, is: impl Fn(&Self) -> bool) -> u64 {
        let limit_ms = 1_000 * limit_s;
        for waited in (0..=limit_ms).step_by(STEP_MS as usize) {
            if is(self) {
                return waited;
            }
            self.step();
        }
        panic!("no {what} within {limit_s} s");
    }

    /// What is true.
    pub(crate) fn world(&self) -> &World {
        self.vehicle.world()
    }

    /// A readout.
    pub(crate) fn read(&self, path: &str) -> f64 {
        self.vehicle.readout(path).unwrap_or_else(|| panic!("no readout {path}")).value
    }

    /// The last frame of a message.
    pub(crate) fn frame(&self, id: CanId) -> [u8; 8] {
        *self.last.get(&id).unwrap_or_else(|| panic!("never heard {id:?}"))
    }

    /// The frame of a message if it came in the last step.
    pub(crate) fn fresh(&self, id: CanId) -> Option<[u8; 8]> {
        self.fresh.iter().rev().find(|(heard, _)| *heard == id).map(|(_, data)| *data)
    }

    /// The message has been heard.
    pub(crate) fn has_heard(&self, id: CanId) -> bool {
        self.last.contains_key(&id)
    }

    /// The cluster says something.
    pub(crate) fn hear(&mut self, id: CanId, data: [u8; 8]) {
        self.vehicle.receive(&CanFrame::full(id, data));
    }
}
