//! Which vehicle this is: set when the image is built, or found out by listening.
//!
//! Until it is known the cluster is nobody's, and until it is certain the controller only listens; the frames heard
//! meanwhile are handed over afterwards, none is lost. The rules are in `cluster::detect`; here they are wired to
//! controller and cluster.

use cluster::Cluster;
use cluster::detect::{Detector, Dial};
use cluster::own::Search;
use protocol_core::generated::{SHIPPED_VEHICLES, VEHICLES};
use protocol_core::vehicle::{NO_VEHICLE, Vehicle};
use protocol_core::{CanFrame, Millis};

use crate::can_node::{CanNode, Care};

/// The vehicle that this image is for; whoever builds sets `CLUSTER_VEHICLE` to its name, or leaves it out.
pub const FIXED: Option<&Vehicle> = match option_env!("CLUSTER_VEHICLE") {
    Some(name) => Some(named(name)),
    None => None,
};

/// The bit rate to start with.
pub const FIRST_BITRATE: u32 = match FIXED {
    Some(vehicle) => vehicle.bitrate,
    None => Dial::new(SHIPPED_VEHICLES).bitrate(),
};

const fn named(name: &str) -> &'static Vehicle {
    let mut index = 0;
    while index < VEHICLES.len() {
        if is_same(VEHICLES[index].name.as_bytes(), name.as_bytes()) {
            return VEHICLES[index];
        }
        index += 1;
    }
    panic!("CLUSTER_VEHICLE is not the name of a folder in vehicles/")
}

const fn is_same(a: &[u8], b: &[u8]) -> bool {
    let mut index = 0;
    while index < a.len() && index < b.len() && a[index] == b[index] {
        index += 1;
    }
    index == a.len() && index == b.len()
}

/// Returns the cluster to start with.
pub fn cluster() -> Cluster {
    Cluster::new(FIXED.unwrap_or(&NO_VEHICLE))
}

/// The search for the vehicle.
pub struct Recognition {
    detector: Detector,
    dial: Dial,
    /// Frames have come since the last [`Self::listen`].
    heard: bool,
    has_joined: bool,
}

impl Recognition {
    /// Returns a search that has heard nothing.
    pub const fn new() -> Self {
        let (detector, dial) = (Detector::new(SHIPPED_VEHICLES), Dial::new(SHIPPED_VEHICLES));
        Self { detector, dial, heard: false, has_joined: FIXED.is_some() }
    }

    /// Takes a frame: the cluster gets it now, or as soon as it knows whose it is.
    pub fn hear(&mut self, cluster: &mut Cluster, frame: &CanFrame, at: Millis) {
        if FIXED.is_some() {
            cluster.receive(frame, at);
            return;
        }
        self.heard = true;
        let is_known = self.detector.found().is_some();
        if let Some(found) = self.detector.hear(frame, self.dial.bitrate(), at) {
            cluster.recognise(found.vehicle);
            for (frame, at) in self.detector.take_kept() {
                cluster.receive(&frame, at);
            }
        } else if is_known {
            cluster.receive(frame, at);
        }
    }

    /// Turns the dial while nothing is found, joins the bus when the vehicle is certain; after a tick's look at the
    /// controller.
    pub fn listen(&mut self, can: &mut CanNode, now: Millis) -> Care {
        if !self.has_joined && self.detector.may_answer() {
            can.join();
            self.has_joined = true;
        }
        if self.has_joined || self.detector.found().is_some() {
            return Care::Nothing;
        }
        let heard = core::mem::take(&mut self.heard);
        match self.dial.listen(heard, can.take_message_error(), now) {
            Some(bitrate) => can.retune(bitrate),
            None => Care::Nothing,
        }
    }

    /// Returns how far the search is; `None` = the image is for one vehicle and searches for none.
    pub fn state(&self, now: Millis) -> Option<Search> {
        FIXED.is_none().then(|| self.detector.state(now))
    }
}
