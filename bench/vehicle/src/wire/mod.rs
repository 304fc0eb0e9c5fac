//! What the documents make of the world: every message of every node, at its cycle.
//!
//! Owns schedule, life counters and links: who is on the bus and how long who has not heard whom. What a message says
//! are the tables of `bus`, `jiulong` and `c5ev`. Refuses to change anything but links and what is heard of the cluster.
//! Phases are spread over each cycle by the seed, every frame is late by its own jitter; both follow from seed,
//! identifier and count alone, so the same settings give the same frames. Asleep, nobody sends; the count of silence
//! begins when a node has something to say, not while it sleeps.
//! Source: BUS-R005 to R010, R021, R061, R121; BUS-18 (two cycles); JL-R007 to R009, R020 to R022; C5-R002.
//! Not supported: arbitration, errors and the time that a frame takes: those are the bus's, not the sender's.

mod c5ev;
mod citybus;
mod jiulong;
mod links;
mod meter;
mod rows;
mod truth;

pub(crate) use links::CONTROLS;

use crate::world::{NODE_COUNT, World};
use crate::{Cycles, Kind, Options, STEP_MS, Sent};
use protocol_core::CanFrame;
use protocol_core::codec::{LifeKind, MessageInfo};
use protocol_core::generated;
use protocol_core::vehicle::Node;
use rows::{Sheet, Slot};

/// Nodes in the order of their number.
const NODES: [Node; NODE_COUNT] = [
    Node::Vcu,
    Node::Inverter,
    Node::Bms,
    Node::Dcdc,
    Node::Steering,
    Node::Compressor,
    Node::Hvac,
    Node::Insulation,
    Node::Charger,
    Node::Contactors,
    Node::Cluster,
];

/// Names of the nodes in the DBC files.
const SENDERS: &[(&str, Node)] = &[
    ("AirCompressor", Node::Compressor),
    ("BMS", Node::Bms),
    ("Cluster", Node::Cluster),
    ("DCDC", Node::Dcdc),
    ("HVAC", Node::Hvac),
    ("ICS4in1", Node::Contactors),
    ("InsulationMonitor", Node::Insulation),
    ("LowVoltageSteering", Node::Steering),
    ("MCU", Node::Inverter),
    ("OBC", Node::Charger),
    ("SteeringPump", Node::Steering),
    ("VCU", Node::Vcu),
];

/// Distance from one frame of a series to the next, in microseconds; 64 frames fit into 500 ms.
const SERIES_SPACING_US: u64 = 3_000;

/// One message in the schedule.
struct Job {
    info: &'static MessageInfo,
    sheet: Sheet,
    slots: Vec<Slot>,
    node: Node,
    /// Frame of its series, from 0.
    frame: usize,
    /// On the cluster's bus.
    here: bool,
    cycle_us: u64,
    phase_us: u64,
    jitter_us: u64,
    /// What its jitter follows from; one for all frames of a series, which so stay in order.
    seed: u64,
    /// Frames whose time has come, sent or not.
    count: u64,
    life_kind: Option<LifeKind>,
    life: u8,
}

impl Job {
    /// Returns when frame `count` is ready, in microseconds since the start.
    fn at_us(&self) -> u64 {
        self.phase_us + self.count * self.cycle_us + mixed(self.seed, self.count) % (self.jitter_us + 1)
    }

    fn frame(&mut self, world: &World) -> CanFrame {
        let first = self.frame * self.sheet.series.map_or(0, |series| series.per_frame);
        let data = rows::encode(self.info, &self.slots, world, first, self.life);
        if !world.links.frozen[self.node as usize] {
            self.life = rows::next_life(self.life_kind, self.life);
        }
        let len = usize::from(self.info.len.min(8));
        CanFrame::from_slice(self.info.id, &data[..len]).unwrap_or(CanFrame::full(self.info.id, data))
    }
}

/// Returns a number that looks random and is the same for the same two (splitmix64's finaliser).
const fn mixed(seed: u64, count: u64) -> u64 {
    let mut word = seed.wrapping_add(count.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15));
    word = (word ^ word >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    word = (word ^ word >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
    word ^ word >> 31
}

const fn sheets(kind: Kind) -> &'static [Sheet] {
    match kind {
        Kind::Citybus => citybus::SHEETS,
        Kind::Jiulong => jiulong::SHEETS,
        Kind::C5ev => c5ev::SHEETS,
    }
}

const fn messages(kind: Kind) -> &'static [MessageInfo] {
    match kind {
        Kind::Citybus => generated::citybus::MESSAGES,
        Kind::Jiulong => generated::jiulong::MESSAGES,
        Kind::C5ev => generated::c5ev::MESSAGES,
    }
}

/// Returns the schedule of a vehicle, and every name in the tables that does not fit its DBC.
fn schedule(kind: Kind, options: Options) -> (Vec<Job>, Vec<String>) {
    let mut jobs: Vec<Job> = Vec::new();
    let mut problems = Vec::new();
    for sheet in sheets(kind) {
        if !messages(kind).iter().any(|info| sheet.frame_of(info.name).is_some()) {
            problems.push(format!("{} has no message `{}`", kind.name(), sheet.message));
        }
    }
    for info in messages(kind) {
        let Some((_, node)) = SENDERS.iter().find(|(sender, _)| *sender == info.sender) else {
            problems.push(format!("{} is sent by `{}`, which is no node", info.name, info.sender));
            continue;
        };
        if *node == Node::Cluster {
            continue;
        }
        let sheet = sheets(kind).iter().find_map(|sheet| Some((sheet, sheet.frame_of(info.name)?)));
        let Some((sheet, frame)) = sheet else {
            problems.push(format!("{} has no table", info.name));
            continue;
        };
        let cycle_ms = match options.cycles {
            Cycles::Page => info.cycle_ms,
            Cycles::Slow => info.slow_cycle_ms.max(info.cycle_ms),
        };
        if cycle_ms == 0 {
            problems.push(format!("{} has no cycle", info.name));
            continue;
        }
        let slots = rows::resolve(info, sheet.rows, &mut problems);
        // A vehicle that is built without a part does not have its messages; a series has as many as its cells.
        let here = !info.optional || options.optional || sheet.series.is_some();
        if !here && !sheet.elsewhere {
            continue;
        }
        let cycle_us = u64::from(cycle_ms) * 1_000;
        let (seed, phase_us) = match jobs.iter().find(|job| frame > 0 && job.sheet.message == sheet.message) {
            Some(first) => (first.seed, first.phase_us + frame as u64 * SERIES_SPACING_US),
            None => {
                let seed = mixed(options.seed, u64::from(info.id.bits()));
                (seed, mixed(seed, u64::MAX) % cycle_us)
            }
        };
        let life_kind = rows::life_of(&slots);
        jobs.push(Job {
            info,
            sheet: *sheet,
            slots,
            node: *node,
            frame,
            here,
            cycle_us,
            phase_us,
            // Later than half a cycle would be another cycle.
            jitter_us: u64::from(options.jitter_us).min(cycle_us / 2),
            seed,
            count: 0,
            life_kind,
            life: rows::first_life(life_kind),
        });
    }
    (jobs, problems)
}

/// Every sender of a vehicle, and what they sent last.
pub(crate) struct Wire {
    kind: Kind,
    jobs: Vec<Job>,
    nodes: Vec<Node>,
    sent: Vec<Sent>,
}

impl Wire {
    /// Builds the schedule; a name that does not fit its DBC leaves a signal not available, and fails a test.
    pub(crate) fn new(kind: Kind, options: Options) -> Self {
        let (jobs, _) = schedule(kind, options);
        let sends = |node: &Node| jobs.iter().any(|job| job.here && job.node == *node);
        let nodes = NODES.into_iter().filter(sends).collect();
        Self { kind, jobs, nodes, sent: Vec::new() }
    }

    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Sends what is due in the step that begins now.
    pub(crate) fn step(&mut self, world: &mut World) {
        let end_us = (world.now_ms + STEP_MS) * 1_000;
        let awake = world.is_awake();
        self.sent.clear();
        if world.links.message_silence_ms.len() != self.jobs.len() {
            world.links.message_silence_ms = self.jobs.iter().map(|job| (job.info.name, 0)).collect();
        }
        let mut on_duty = [false; NODE_COUNT];
        // The cluster keeps its own hours.
        on_duty[Node::Cluster as usize] = true;
        let mut heard = [false; NODE_COUNT];
        for (place, job) in self.jobs.iter_mut().enumerate() {
            let due = awake && job.sheet.is_due(world, job.frame);
            let sender = sender(world, job.node);
            on_duty[sender as usize] |= due;
            let cut = world.links.cut[sender as usize];
            let lost = world.links.lost.contains(&job.info.name);
            let mut went_out = false;
            while job.at_us() < end_us {
                let at_us = job.at_us();
                if due && !cut && !lost {
                    let frame = job.frame(world);
                    heard[sender as usize] = true;
                    went_out = true;
                    if job.here && !world.links.cut[Node::Cluster as usize] {
                        self.sent.push(Sent { at_us, node: sender, frame });
                    }
                }
                job.count += 1;
            }
            let (_, silence) = &mut world.links.message_silence_ms[place];
            if due && !went_out {
                World::count(silence);
            } else {
                *silence = 0;
            }
        }
        self.sent.sort_by_key(|sent| sent.at_us);
        count_silence(world, on_duty, heard);
        World::count(&mut world.meter.silent_ms);
    }

    pub(crate) fn take(&mut self) -> Vec<Sent> {
        std::mem::take(&mut self.sent)
    }

    /// Lets every node that is on the bus hear a frame of the cluster.
    pub(crate) fn receive(&mut self, world: &mut World, frame: &CanFrame) {
        if world.links.cut[Node::Cluster as usize] {
            return;
        }
        let mut said = world.meter;
        if !meter::hear(self.kind, &mut said, frame) {
            return;
        }
        for (to, silence) in world.links.silence_ms.iter_mut().enumerate() {
            if !world.links.cut[to] {
                silence[Node::Cluster as usize] = 0;
            }
        }
        // What the cluster says is for the vehicle controller.
        if !world.links.cut[Node::Vcu as usize] {
            world.meter = said;
            world.meter.silent_ms = 0;
            world.meter.frames += 1;
        }
    }
}

/// Who puts a node's frames on the cluster's bus: the vehicle controller forwards what comes from another (BUS-R056).
fn sender(world: &World, node: Node) -> Node {
    if node == Node::Inverter && world.motor.own_bus { Node::Vcu } else { node }
}

/// Counts how long nobody has heard whom; who has nothing to say now is not missed.
fn count_silence(world: &mut World, on_duty: [bool; NODE_COUNT], heard: [bool; NODE_COUNT]) {
    for (to, silences) in world.links.silence_ms.iter_mut().enumerate() {
        let deaf = world.links.cut[to];
        for (from, silence) in silences.iter_mut().enumerate() {
            if heard[from] && !deaf || !on_duty[from] {
                *silence = 0;
            } else {
                World::count(silence);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_signal_of_every_message_has_one_row_of_its_name() {
        for kind in Kind::ALL {
            for optional in [false, true] {
                let (jobs, problems) = schedule(kind, Options { optional, ..Options::default() });
                assert_eq!(problems, Vec::<String>::new(), "{}", kind.name());
                let others = messages(kind).iter().filter(|info| info.sender != "Cluster").count();
                assert!(!optional || jobs.len() == others, "{}: {} of {others}", kind.name(), jobs.len());
            }
        }
    }

    #[test]
    fn an_unknown_name_is_told() {
        let info = &generated::citybus::MESSAGES[0];
        let rows = [rows::fixed("gear", 0.0), rows::fixed("gaer", 0.0)];
        let mut problems = Vec::new();
        rows::resolve(info, &rows, &mut problems);
        assert!(problems.iter().any(|problem| problem.contains("no signal `gaer`")), "{problems:?}");
        assert!(problems.iter().any(|problem| problem.contains("vehicle_speed has no row")), "{problems:?}");
    }

    #[test]
    fn every_node_has_its_number() {
        for (place, node) in NODES.into_iter().enumerate() {
            assert_eq!(node as usize, place);
        }
    }

    #[test]
    fn a_number_becomes_the_nearest_valid_raw_value() {
        let signal = |message: &str, name: &str| {
            let info = generated::citybus::MESSAGES.iter().find(|info| info.name == message);
            info.and_then(|info| info.signal(name)).expect("a signal of the bus")
        };
        let current = signal("BMS1", "pack_current");
        assert_eq!(rows::raw_of(current, Some(0.04)), 10_000);
        assert_eq!(rows::raw_of(current, Some(0.06)), 10_001);
        assert_eq!(rows::raw_of(current, Some(-0.06)), 9_999);
        assert_eq!(rows::raw_of(current, Some(-5_000.0)), 0, "below the range");
        assert_eq!(rows::raw_of(current, Some(5_000.0)), 20_000, "above the range");
        assert_eq!(rows::raw_of(current, None), 65_535, "not available");
        assert_eq!(rows::raw_of(current, Some(f64::NAN)), 65_535, "no number");
        assert_eq!(
            rows::raw_of(signal("BMS1", "hv_open_request"), None),
            2,
            "nothing says not available: start"
        );
    }

    #[test]
    fn life_counters_count_as_their_kind_does() {
        let after = |kind, life| rows::next_life(Some(kind), life);
        assert_eq!(after(LifeKind::From0To255, 255), 0);
        assert_eq!(after(LifeKind::From0To255, 0), 1);
        assert_eq!(after(LifeKind::From1To255, 255), 1);
        assert_eq!(after(LifeKind::From1To255, 1), 2);
        assert_eq!(after(LifeKind::Nibble, 15), 0);
        assert_eq!(after(LifeKind::Nibble, 7), 8);
        assert_eq!(rows::first_life(Some(LifeKind::From1To255)), 1);
    }
}
