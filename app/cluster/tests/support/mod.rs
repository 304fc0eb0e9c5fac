//! The one drive of the tests: a cluster, its clock, and what is sent to it again and again.
//!
//! `toy` and `probe` are vehicles made for the tests: one with hand-written codecs, one that can say every value.

pub(crate) mod probe;
pub(crate) mod toy;

use cluster::{Cluster, Inputs, Options, Received, Sound, Telltale, View};
use protocol_core::model::Value;
use protocol_core::vehicle::{HvOffRule, LimpRule, Node, Rules, Vehicle};
use protocol_core::{CanFrame, CanId, Millis, Severity};
use std::collections::BTreeMap;

/// Frames are sent this often, in milliseconds.
pub(crate) const CYCLE: u64 = 100;
/// The clock's step, in milliseconds.
pub(crate) const TICK: u64 = 10;

/// What any document may print.
pub(crate) const RULES: Rules = Rules {
    hv_off: Some(HvOffRule { vehicle_ms: 5_000, battery_ms: 35_000 }),
    limp: Some(LimpRule { silence_ms: 5_000, most_deciamps: 600, deciamps_per_ah: 3 }),
    charger_loss_ms: Some(5_000),
    hvac_loss_ms: Some(10_000),
    buzzer_ms: Some(120_000),
};

/// What is sent again and again: a frame, or a value of [`probe`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kept {
    Frame(CanId),
    Value(Value),
}

/// A drive: frames at their cycles, a tick every 10 ms.
#[derive(Clone)]
pub(crate) struct Drive {
    pub(crate) cluster: Cluster,
    pub(crate) inputs: Inputs,
    /// Time of the next tick.
    pub(crate) now: Millis,
    /// Frames are taken from the cluster after each tick, into [`Self::sent`].
    pub(crate) takes: bool,
    /// What was taken, and when.
    pub(crate) sent: Vec<(u64, CanFrame)>,
    kept: BTreeMap<Kept, (CanId, [u8; 8])>,
    silent: Vec<Node>,
    life: u8,
}

impl Drive {
    /// A drive on a dead bus, before the first tick.
    pub(crate) fn of(vehicle: &'static Vehicle) -> Self {
        Self::at(vehicle, Millis(0))
    }

    /// The same at another time.
    pub(crate) fn at(vehicle: &'static Vehicle, now: Millis) -> Self {
        Self {
            // The owner consents to remote upgrades: what else forbids them is seen so.
            cluster: Cluster::with_options(vehicle, Options { may_upgrade: true, ..Options::NONE }),
            inputs: Inputs::default(),
            now,
            takes: false,
            sent: Vec::new(),
            kept: BTreeMap::new(),
            silent: Vec::new(),
            life: 0,
        }
    }

    /// Sends the frame from now on at every cycle; its life counter is filled in.
    pub(crate) fn repeat(&mut self, id: CanId, data: [u8; 8]) {
        self.kept.insert(Kept::Frame(id), (id, data));
    }

    /// Sends the frame no more.
    pub(crate) fn stop(&mut self, id: CanId) {
        self.kept.remove(&Kept::Frame(id));
    }

    /// Sends the number from now on at every cycle, in a frame of [`probe`].
    pub(crate) fn keep(&mut self, node: Node, value: Value, number: i32) {
        self.kept.insert(Kept::Value(value), (probe::id(node), probe::data(value, Some(number))));
    }

    /// Sends the value as not valid from now on, in a frame of [`probe`].
    pub(crate) fn keep_invalid(&mut self, node: Node, value: Value) {
        self.kept.insert(Kept::Value(value), (probe::id(node), probe::data(value, None)));
    }

    /// Sends nothing any more.
    pub(crate) fn forget(&mut self) {
        self.kept.clear();
    }

    /// The node sends nothing from now on, until [`Self::speak`].
    pub(crate) fn hush(&mut self, node: Node) {
        self.silent.push(node);
    }

    /// The node sends again.
    pub(crate) fn speak(&mut self, node: Node) {
        self.silent.retain(|&silent| silent != node);
    }

    /// Sends one frame now.
    pub(crate) fn send(&mut self, id: CanId, data: [u8; 8]) -> Received {
        self.cluster.receive(&CanFrame::full(id, data), self.now)
    }

    /// Sends one frame that the vehicle has, with an identifier of 29 bits; returns what is shown a tick later.
    pub(crate) fn hear(&mut self, id: u32, data: [u8; 8]) -> View {
        assert_eq!(self.send(CanId::extended(id), data), Received::Stored);
        self.run(TICK);
        self.view()
    }

    /// Lets time pass in ticks.
    pub(crate) fn run(&mut self, ms: u64) {
        self.run_by(ms, TICK);
    }

    /// Lets time pass in steps of `tick_ms`; the frames of a step come before its tick.
    pub(crate) fn run_by(&mut self, ms: u64, tick_ms: u64) {
        let end = self.now.after(ms);
        while self.now < end {
            if self.now.0.is_multiple_of(CYCLE) {
                self.send_all();
            }
            self.cluster.tick(&self.inputs, self.now);
            while self.takes
                && let Some(frame) = self.cluster.transmit(self.now)
            {
                self.sent.push((self.now.0, frame));
            }
            self.now = self.now.after(tick_ms);
        }
    }

    fn send_all(&mut self) {
        self.life = self.life.wrapping_add(1);
        let vehicle = self.cluster.vehicle();
        for &(id, mut data) in self.kept.values() {
            let message = vehicle.index_of(id).map(|index| &vehicle.rx[usize::from(index)]);
            if message.is_some_and(|message| self.silent.contains(&message.node)) {
                continue;
            }
            if let Some(life) = message.and_then(|message| message.life) {
                let counter = self.life << life.mask.trailing_zeros() & life.mask;
                let byte = &mut data[usize::from(life.byte)];
                *byte = *byte & !life.mask | counter;
            }
            self.cluster.receive(&CanFrame::full(id, data), self.now);
        }
    }

    /// The time of the last tick.
    pub(crate) fn last(&self) -> Millis {
        Millis(self.now.0 - TICK)
    }

    /// What is shown as of the last tick.
    pub(crate) fn view(&self) -> View {
        self.cluster.view(self.last())
    }

    /// The sound that plays as of the last tick.
    pub(crate) fn sound(&self) -> Option<Sound> {
        self.cluster.chime(self.last()).map(|chime| chime.sound)
    }

    /// The telltales that are lit.
    pub(crate) fn lit(&self) -> Vec<Telltale> {
        let telltales = self.view().telltales;
        Telltale::ALL.iter().copied().filter(|&telltale| telltales.is_lit(telltale)).collect()
    }

    /// English text, code and severity of all active faults.
    pub(crate) fn faults(&self) -> Vec<(&'static str, Option<u16>, Severity)> {
        let faults = self.cluster.active_faults(self.last());
        faults.map(|fault| (fault.text.en, fault.code, fault.severity)).collect()
    }

    /// English texts of all active faults.
    pub(crate) fn texts(&self) -> Vec<&'static str> {
        self.faults().into_iter().map(|(text, ..)| text).collect()
    }

    /// The English text and the code of the line.
    pub(crate) fn line(&self) -> Option<(&'static str, Option<u16>)> {
        self.view().line.map(|line| (line.text.en, line.code))
    }

    /// Every line that is shown during the next seconds, each once, in the order of their first turns.
    pub(crate) fn lines(&mut self, seconds: u64) -> Vec<(&'static str, Option<u16>)> {
        let mut lines = Vec::new();
        for line in self.turns(seconds) {
            if !lines.contains(&line) {
                lines.push(line);
            }
        }
        lines
    }

    /// The lines of the next seconds, turn by turn.
    pub(crate) fn turns(&mut self, seconds: u64) -> Vec<(&'static str, Option<u16>)> {
        let mut lines = Vec::new();
        for _ in 0..seconds * 1_000 / TICK {
            lines.extend(self.line().filter(|line| lines.last() != Some(line)));
            self.run(TICK);
        }
        lines
    }
}
