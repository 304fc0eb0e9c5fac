//! A vehicle whose battery is watched: settings in, world and frames out.

#![allow(dead_code, reason = "each test file uses its part of the rig")]

use protocol_core::codec::MessageInfo;
use protocol_core::generated::{c5ev, citybus, jiulong};
use std::collections::BTreeMap;
use virtual_vehicle::{Kind, Options, STEP_MS, VirtualVehicle, World};

/// A vehicle and the last frame of each of its messages.
pub(crate) struct Rig {
    vehicle: VirtualVehicle,
    messages: &'static [MessageInfo],
    last: BTreeMap<&'static str, [u8; 8]>,
}

impl Rig {
    /// A vehicle that has been on for some steps.
    pub(crate) fn new(kind: Kind) -> Self {
        let messages = match kind {
            Kind::Citybus => citybus::MESSAGES,
            Kind::Jiulong => jiulong::MESSAGES,
            Kind::C5ev => c5ev::MESSAGES,
        };
        let options = Options { optional: true, ..Options::default() };
        let mut rig = Self { vehicle: VirtualVehicle::new(kind, options), messages, last: BTreeMap::new() };
        rig.steps(20);
        rig
    }

    /// What is true.
    pub(crate) fn world(&self) -> &World {
        self.vehicle.world()
    }

    /// Virtual time since the start, in milliseconds.
    pub(crate) fn now_ms(&self) -> u64 {
        self.vehicle.now_ms()
    }

    /// Sets a control to a number.
    pub(crate) fn set(&mut self, path: &str, setting: f64) {
        self.vehicle.set(path, Some(setting)).unwrap();
    }

    /// Leaves a control to the vehicle.
    pub(crate) fn free(&mut self, path: &str) {
        self.vehicle.set(path, None).unwrap();
    }

    /// Sets a control to one of its words.
    pub(crate) fn say(&mut self, path: &str, word: &str) {
        let control = self.vehicle.controls().find(|control| control.path == path).unwrap();
        let setting = control.read(word).unwrap();
        self.vehicle.set(path, setting).unwrap();
    }

    /// Lets so many steps pass.
    pub(crate) fn steps(&mut self, count: usize) {
        for _ in 0..count {
            self.vehicle.advance();
            for sent in self.vehicle.take_frames() {
                let id = sent.frame.id;
                if let Some(info) = self.messages.iter().find(|info| info.id == id) {
                    self.last.insert(info.name, *sent.frame.padded());
                }
            }
        }
    }

    /// Lets time pass, in milliseconds.
    pub(crate) fn wait_ms(&mut self, ms: u64) {
        self.steps((ms / STEP_MS) as usize);
    }

    /// Lets steps pass until something holds; returns how many it took.
    ///
    /// # Panics
    /// If it does not come true in `limit_ms`.
    pub(crate) fn wait_until(&mut self, limit_ms: u64, holds: impl Fn(&World) -> bool) -> u64 {
        for step in 0..limit_ms / STEP_MS {
            if holds(self.world()) {
                return step;
            }
            self.steps(1);
        }
        panic!("not true after {limit_ms} ms: {:?}", self.world().bms);
    }

    /// Turns the key to START and waits until high voltage is closed.
    pub(crate) fn start(&mut self) {
        self.say("driver.key", "start");
        self.wait_until(10_000, |world| world.hv_connected() && world.vcu.ready);
    }

    /// The raw value of a signal in the last frame of its message.
    pub(crate) fn raw(&self, message: &str, signal: &str) -> i64 {
        let info = self.messages.iter().find(|info| info.name == message).unwrap();
        let data = self.last.get(message).unwrap_or_else(|| panic!("{message} has not been sent"));
        info.signal(signal).unwrap().raw(data)
    }
}
