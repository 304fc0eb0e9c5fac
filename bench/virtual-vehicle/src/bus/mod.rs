//! What goes out on the bus: every message of every node, at its cycle.
//!
//! Owns schedule and life counters. What a message says are the tables of each vehicle's `wire`; who hears it is
//! `hearing`'s. Phases are spread over each cycle by the seed, every frame is late by its own jitter; both follow from
//! seed, identifier and count alone, so the same settings give the same frames. Asleep, nobody sends.
//! Source: BUS-R005 to R010, R021, R061, R121; BUS-18 (two cycles); JL-R007 to R009, R020 to R022; C5-R002.
//! Not supported: arbitration, errors and the time that a frame takes: those are the bus's, not the sender's.

pub(crate) mod links;
pub(crate) mod rows;
pub(crate) mod truth;
pub(crate) mod unprinted;

use crate::hearing::{self, NODES};
use crate::vehicle::Definition;
use crate::world::World;
use crate::{Cycles, Options, STEP_MS, Sent};
use protocol_core::CanFrame;
use protocol_core::codec::{LifeKind, MessageInfo};
use protocol_core::vehicle::Node;
use rows::{Sheet, Slot};

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

/// Returns the schedule of a vehicle, and every name in the tables that does not fit its DBC.
fn schedule(vehicle: &Definition, options: Options) -> (Vec<Job>, Vec<String>) {
    let mut jobs: Vec<Job> = Vec::new();
    let mut problems = Vec::new();
    for sheet in vehicle.sheets {
        if !vehicle.messages.iter().any(|info| sheet.frame_of(info.name).is_some()) {
            problems.push(format!("{} has no message `{}`", vehicle.name, sheet.message));
        }
    }
    for info in vehicle.messages {
        let Some((_, node)) = SENDERS.iter().find(|(sender, _)| *sender == info.sender) else {
            problems.push(format!("{} is sent by `{}`, which is no node", info.name, info.sender));
            continue;
        };
        if *node == Node::Cluster {
            continue;
        }
        let sheet = vehicle.sheets.iter().find_map(|sheet| Some((sheet, sheet.frame_of(info.name)?)));
        let Some((sheet, frame)) = sheet else {
            problems.push(format!("{} has no table", info.name));
            continue;
        };
        let cycle_ms = match options.cycles {
            Cycles::Page => info.cycle_ms,
            Cycles::Overview => sheet.overview_ms.unwrap_or(info.cycle_ms),
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
    jobs: Vec<Job>,
    nodes: Vec<Node>,
    sent: Vec<Sent>,
    /// The nodes hear one another at once; else a bus brings their frames back.
    hears_itself: bool,
}

impl Wire {
    /// Builds the schedule; a name that does not fit its DBC leaves a signal not available, and fails a test.
    pub(crate) fn new(vehicle: &Definition, options: Options) -> Self {
        let (jobs, _) = schedule(vehicle, options);
        let sends = |node: &Node| jobs.iter().any(|job| job.here && job.node == *node);
        let nodes = NODES.into_iter().filter(sends).collect();
        Self { jobs, nodes, sent: Vec::new(), hears_itself: true }
    }

    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// From now on a bus brings back to the nodes what they send on it.
    pub(crate) fn over_a_bus(&mut self) {
        self.hears_itself = false;
    }

    /// Sends what is due in the step that begins now.
    pub(crate) fn step(&mut self, world: &mut World, vehicle: &Definition) {
        let end_us = (world.now_ms + STEP_MS) * 1_000;
        let is_awake = world.is_awake();
        let is_cut = |world: &World, node: Node| world.links.cut[node as usize];
        let cluster_is_cut = is_cut(world, Node::Cluster);
        self.sent.clear();
        let mut inside = Vec::new();
        for job in &mut self.jobs {
            let is_due = is_awake && job.sheet.is_due(world, job.frame);
            let is_lost = world.links.lost.contains(&job.info.name);
            let here = job.here && (job.sheet.here)(world);
            let sender = if here { sender(world, job.node) } else { job.node };
            while job.at_us() < end_us {
                let at_us = job.at_us();
                job.count += 1;
                if !is_due || is_lost || is_cut(world, sender) {
                    continue;
                }
                let frame = job.frame(world);
                (job.sheet.sent)(world);
                if here && !cluster_is_cut {
                    self.sent.push(Sent { at_us, node: sender, frame });
                } else {
                    inside.push(frame);
                }
            }
        }
        self.sent.sort_by_key(|sent| sent.at_us);
        if self.hears_itself {
            inside.extend(self.sent.iter().map(|sent| sent.frame));
        }
        for frame in &inside {
            hearing::deliver(world, vehicle, frame);
        }
    }

    pub(crate) fn take(&mut self) -> Vec<Sent> {
        std::mem::take(&mut self.sent)
    }
}

/// Who puts a node's frames on the cluster's bus: the vehicle controller forwards what comes from another (BUS-R056).
fn sender(world: &World, node: Node) -> Node {
    if node == Node::Inverter && world.motor.own_bus { Node::Vcu } else { node }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;
    use protocol_core::generated;

    #[test]
    fn every_signal_of_every_message_has_one_row_of_its_name() {
        for kind in Kind::ALL {
            for optional in [false, true] {
                let (jobs, problems) =
                    schedule(kind.definition(), Options { optional, ..Options::default() });
                assert_eq!(problems, Vec::<String>::new(), "{}", kind.name());
                let others =
                    kind.definition().messages.iter().filter(|info| info.sender != "Cluster").count();
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
