//! A whole bench: the firmware's ELF in an RP2040 on a board, traffic on its bus, its records decoded.
//!
//! Owns the wiring of the Pico board as this repository's README prints it, written down here a second time on
//! purpose: firmware that drives another pin is found out. Refuses to know what a frame means.

use crate::can::{Event, EventKind, Frame, Id, LoadGenerator, NodeId, NodeMode, Participant, Tag};
use crate::chips::bench_board::{BenchBoard, CanWiring, PanelWiring, Wiring};
use crate::chips::{mcp2515, panel};
use crate::flash::Cells;
use crate::join::{self, Members};
use crate::log::Log;
use crate::recent::Recent;
use crate::rp2040::{FlashTimes, Rp2040, Stop, Watched, image};
use crate::switches::SWITCHES;
use crate::time::Nanos;
use anyhow::Result;
use protocol_core::generated::VEHICLES;
use protocol_core::link::{Decoder, Health, Record, Sample, Screen};
use protocol_core::vehicle::{NO_VEHICLE, Node};
use protocol_core::{Value, Vehicle};
use std::path::Path;
use std::sync::{Arc, Mutex};
use virtual_vehicle::{Kind, VirtualVehicle, World};

/// The panel module that is soldered on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PanelKind {
    /// ILI9341 module.
    #[default]
    Ili9341,
    /// ST7789 IPS module.
    St7789,
}

/// What is on the desk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RigOptions {
    /// The panel module.
    pub panel: PanelKind,
    /// Crystal on the MCP2515 module, in Hz.
    pub crystal_hz: u32,
    /// Bit rate of the other nodes, in bit/s.
    pub bitrate: u32,
}

impl Default for RigOptions {
    fn default() -> Self {
        Self { panel: PanelKind::default(), crystal_hz: 8_000_000, bitrate: 250_000 }
    }
}

/// Where in the flash the firmware keeps what outlives power-off.
pub const STORE: std::ops::Range<usize> = 0x1F_8000..0x20_0000;

/// Time between the end of a recording and its next start, when it is played in a loop.
const LOOP_PAUSE: Nanos = Nanos::from_millis(20);

/// Frames that a node of the vehicle keeps for a bus that does not take them; beyond that a new one of the same
/// identifier replaces the old, as in a mailbox.
const MAILBOXES: usize = 16;
/// A babbling node repeats this without a pause: no identifier goes before it.
const BABBLE: Option<Id> = Id::standard(0);
/// Frames and records that are kept at least: a minute of a full bus, and ten of the link.
const FRAMES_KEPT: usize = 1 << 17;
const RECORDS_KEPT: usize = 1 << 14;

/// A frame that was on the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heard {
    /// End of the frame.
    pub at: Nanos,
    /// Identifier and data as on the wire.
    pub frame: Frame,
    /// Sent by the cluster.
    pub by_cluster: bool,
}

/// Frames counted in different places.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Frames that other nodes sent over the bus while the controller listened.
    pub on_bus: u64,
    /// Of these, frames that the controller put into its buffers.
    pub stored: u64,
    /// Frames that the firmware had received when it last reported.
    pub received: u64,
    /// Frames lost in the controller's buffers or in the firmware's queue.
    pub lost: u64,
}

/// A whole bench.
pub struct Rig {
    chip: Rp2040<BenchBoard>,
    heard: Arc<Mutex<Recent<Heard>>>,
    decoder: Decoder,
    /// Number of the first byte of the link that has not been read.
    uart_read: usize,
    records: Recent<(Nanos, Record)>,
    damaged: usize,
    values: [Sample; Value::COUNT],
    health: Health,
    screen: Option<Screen>,
    identified: &'static Vehicle,
    around: Option<Around>,
    /// Sends single frames by hand.
    hand: Option<NodeId>,
    babbler: Option<NodeId>,
    members: Members,
    /// When the other tools on the bus have their next turn.
    turn_due: Nanos,
}

/// The vehicle around the cluster, on the bus.
struct Around {
    vehicle: VirtualVehicle,
    /// Its start.
    since: Nanos,
    nodes: Vec<(Node, NodeId)>,
    /// Number of the first frame on the bus that it has not been told of.
    told: usize,
    /// Which switches are closed.
    closed: [bool; SWITCHES.len()],
}

impl Around {
    /// When its next step is due.
    fn due(&self) -> Nanos {
        self.since + Nanos::from_millis(self.vehicle.now_ms())
    }
}

impl Rig {
    /// Solders a Pico board together, writes the ELF into its flash and switches it on.
    ///
    /// # Errors
    /// If the file is not an image for the RP2040; the error names it and says why.
    pub fn new(elf: &Path, options: &RigOptions) -> Result<Self> {
        Ok(Self::with_flash(image::load_elf(elf)?, options))
    }

    /// The same with this image of the flash, as [`image::flash_from_elf`] makes it of an ELF.
    pub fn with_flash(flash: Vec<u8>, options: &RigOptions) -> Self {
        let can = mcp2515::Config { crystal_hz: options.crystal_hz, ..mcp2515::Config::default() };
        let panel = match options.panel {
            PanelKind::Ili9341 => panel::Config::ILI9341,
            PanelKind::St7789 => panel::Config::ST7789,
        };
        let mut board = BenchBoard::new(pico_wiring(), options.bitrate, can, panel);
        let heard = Arc::new(Mutex::new(Recent::keeping(FRAMES_KEPT)));
        let node = board.bus_mut().attach("logger");
        let cluster = board.mcp2515().node();
        board.join(Logger { node, cluster, last_sent: None, heard: Arc::clone(&heard) });
        Self {
            chip: Rp2040::new(flash, board),
            heard,
            decoder: Decoder::new(),
            uart_read: 0,
            records: Recent::keeping(RECORDS_KEPT),
            damaged: 0,
            values: [Sample::Never; Value::COUNT],
            health: Health::default(),
            screen: None,
            identified: &NO_VEHICLE,
            around: None,
            hand: None,
            babbler: None,
            members: Members::default(),
            turn_due: Nanos::ZERO,
        }
    }

    /// Puts a vehicle around the cluster: each of its nodes is a node of the bus, and hears what is on it, whoever sent it.
    pub fn drive(&mut self, mut vehicle: VirtualVehicle) {
        vehicle.over_a_bus();
        let since = self.now();
        let told = self.heard.lock().map_or(0, |heard| heard.next_number());
        let bus = self.board_mut().bus_mut();
        let nodes = vehicle.nodes().iter().map(|&node| (node, bus.attach(node.key()))).collect();
        self.around = Some(Around { vehicle, since, nodes, told, closed: [false; SWITCHES.len()] });
    }

    /// The vehicle around the cluster, if there is one.
    pub fn vehicle(&self) -> Option<&VirtualVehicle> {
        self.around.as_ref().map(|around| &around.vehicle)
    }

    /// The vehicle around the cluster, to change its settings.
    pub fn vehicle_mut(&mut self) -> Option<&mut VirtualVehicle> {
        self.around.as_mut().map(|around| &mut around.vehicle)
    }

    /// Lets other tools take part in the bus from now on; they have a turn every [`join::TURN`] of virtual time.
    pub fn host(&mut self, members: &Members) {
        members.attach(self.board_mut());
        self.turn_due = self.now();
        self.members = members.clone();
    }

    /// Puts a node on the bus that plays a recording at its recorded times, once or in a loop.
    pub fn replay(&mut self, log: &Log, repeat: bool) {
        let node = self.board_mut().bus_mut().attach("vehicle");
        let replay = crate::can::Replay::new(node, log.recording());
        if repeat {
            self.board_mut().join(replay.repeated_every(log.duration() + LOOP_PAUSE));
        } else {
            self.board_mut().join(replay);
        }
    }

    /// Lets `span` of virtual time pass.
    ///
    /// # Errors
    /// If the firmware does what the bench does not model, or locks up.
    pub fn run_for(&mut self, span: Nanos) -> Result<(), Stop> {
        let end = self.chip.now() + span;
        let mut result = Ok(());
        while result.is_ok() && self.now() < end {
            let due = [self.step_vehicle(), self.serve_members()];
            let stop = due.into_iter().flatten().fold(end, Nanos::min);
            result = self.chip.run_until(stop);
        }
        self.read_link();
        result
    }

    /// Lets the vehicle take the steps that are due and returns when the next one is.
    fn step_vehicle(&mut self) -> Option<Nanos> {
        let now = self.now();
        let mut around = self.around.take()?;
        while around.due() <= now {
            if let Ok(heard) = self.heard.lock() {
                for heard in heard.since(around.told) {
                    if let Some(frame) = heard.frame.data_frame() {
                        around.vehicle.receive(&frame);
                    }
                }
                around.told = heard.next_number();
            }
            around.vehicle.advance();
            let sent = around.vehicle.take_frames();
            let bus = self.board_mut().bus_mut();
            for sent in sent {
                if let Some((_, node)) = around.nodes.iter().find(|(node, _)| *node == sent.node) {
                    let frame = Frame::from(&sent.frame);
                    let mailbox = Tag(frame.arbitration_key());
                    if bus.pending(*node) >= MAILBOXES {
                        bus.abort(*node, mailbox);
                    }
                    // The engine stops behind the instruction in which the step fell due.
                    let at = (around.since + Nanos::from_micros(sent.at_us)).max(now);
                    bus.request(*node, at, frame, mailbox);
                }
            }
            self.wire_inputs(&mut around);
        }
        let due = around.due();
        self.around = Some(around);
        Some(due)
    }

    /// Gives the other tools their turn if it is due and returns when the next one is.
    fn serve_members(&mut self) -> Option<Nanos> {
        if self.members.is_empty() {
            return None;
        }
        if self.turn_due <= self.now() {
            self.settle_members();
        }
        Some(self.turn_due)
    }

    /// Gives the other tools a turn now, due or not: nothing that was on the bus so far is kept from them.
    pub fn settle_members(&mut self) {
        self.members.clone().poll(self.board_mut());
        self.turn_due = self.now() + join::TURN;
    }

    /// Puts what the cluster's own wires report onto the board's pins.
    fn wire_inputs(&mut self, around: &mut Around) {
        let world = around.vehicle.world();
        let now = self.now();
        for (index, (closed, switch)) in around.closed.iter_mut().zip(SWITCHES).enumerate() {
            let closes = (switch.is_closed)(world);
            if *closed != closes {
                *closed = closes;
                self.board_mut().press(now, BUTTONS.len() + index, closes);
            }
        }
        for (channel, read) in ANALOG.into_iter().enumerate() {
            self.chip.set_analog(channel, read(world));
        }
    }

    /// Virtual time since power-on.
    pub fn now(&self) -> Nanos {
        self.chip.now()
    }

    /// The chip, for its statistics.
    pub fn chip(&self) -> &Rp2040<BenchBoard> {
        &self.chip
    }

    /// Watches the core from now on, and returns what was seen since the last call.
    pub fn watch(&mut self) -> Option<Watched> {
        self.chip.watch()
    }

    /// The board with everything on it.
    pub fn board(&self) -> &BenchBoard {
        &self.chip.board
    }

    /// The board, to attach nodes and force faults.
    pub fn board_mut(&mut self) -> &mut BenchBoard {
        let now = self.chip.now();
        self.chip.board.arrive_at(now);
        &mut self.chip.board
    }

    /// The frames that were on the bus; of a long run, the last ones.
    pub fn heard(&self) -> Vec<Heard> {
        self.heard_since(0).0
    }

    /// The frames from `number` on, and the number of the frame that comes next.
    pub fn heard_since(&self, number: usize) -> (Vec<Heard>, usize) {
        self.heard.lock().map(|heard| (heard.since(number).to_vec(), heard.next_number())).unwrap_or_default()
    }

    /// The records that the firmware has sent, with the time of their last byte; of a long run, the last ones.
    pub fn records(&self) -> &[(Nanos, Record)] {
        self.records.as_slice()
    }

    /// The tone that the buzzer makes now, in Hz; `None` = it is silent.
    pub fn sound(&self) -> Option<u32> {
        self.board().buzzer().last().filter(|change| change.duty > 0).map(|change| change.frequency_hz)
    }

    /// Sends one frame by hand, as soon as the bus is free.
    pub fn send(&mut self, frame: Frame) {
        let (now, hand) = (self.now(), self.hand);
        let bus = self.board_mut().bus_mut();
        let node = hand.unwrap_or_else(|| bus.attach("hand"));
        bus.request(node, now, frame, Tag(frame.arbitration_key()));
        self.hand = Some(node);
    }

    /// Fault: the bus is stuck dominant, or free again.
    pub fn short_bus(&mut self, shorted: bool) {
        let now = self.now();
        self.board_mut().bus_mut().short(now, shorted);
    }

    /// Fault: a node sends the most urgent identifier without a pause, or falls silent again.
    pub fn babble(&mut self, on: bool) {
        let now = self.now();
        match (self.babbler, BABBLE) {
            (Some(node), _) => {
                let mode = if on { NodeMode::Active } else { NodeMode::Off };
                self.board_mut().bus_mut().set_mode(node, now, mode);
            }
            (None, Some(id)) if on => {
                let node = self.board_mut().bus_mut().attach("babbler");
                self.board_mut().join(LoadGenerator::sequenced(node, id));
                self.babbler = Some(node);
            }
            (None, _) => {}
        }
    }

    /// Fault: every frame reaches the cluster with a wrong CRC, or as it was sent again.
    pub fn garble(&mut self, on: bool) {
        let cluster = self.board().mcp2515().node();
        self.board_mut().bus_mut().garble_receptions(cluster, if on { u32::MAX } else { 0 });
    }

    /// Fault: the cluster's bus wires are pulled, or plugged in again.
    pub fn unplug(&mut self, unplugged: bool) {
        let (now, cluster) = (self.now(), self.board().mcp2515().node());
        let bus = self.board_mut().bus_mut();
        if unplugged {
            bus.cut(cluster, now);
        } else {
            bus.mend(cluster, now);
        }
    }

    /// The cluster's supply is cut, or comes back: the same image starts with what its flash holds. What it last told is
    /// forgotten.
    pub fn cut_power(&mut self, cut: bool) {
        if cut {
            self.read_link();
            self.chip.power_off();
            (self.decoder, self.screen) = (Decoder::new(), None);
            self.values = [Sample::Never; Value::COUNT];
            self.health = Health::default();
        } else {
            self.chip.power_on();
        }
    }

    /// Puts what was kept in another run into the flash; `flash` is a whole one. Before anything has run.
    pub fn keep(&mut self, flash: &[u8]) {
        let mut bytes = self.chip.flash().to_vec();
        if let Some(kept) = flash.get(STORE) {
            bytes[STORE].copy_from_slice(kept);
        }
        self.chip.set_cells(Cells::new(bytes));
    }

    /// What a programmer would read out of the flash now.
    pub fn flash(&self) -> Vec<u8> {
        self.chip.cells().clone().read_out()
    }

    /// The flash chip takes so long for its writes from now on.
    pub fn set_flash_times(&mut self, times: FlashTimes) {
        self.chip.set_flash_times(times);
    }

    /// Gives the cells of the flash that a cut has left weak another noise.
    pub fn seed_flash(&mut self, seed: u64) {
        let cells = self.chip.cells().clone().seeded(seed);
        self.chip.set_cells(cells);
    }

    /// Frames of the PC link that did not decode.
    pub fn damaged_records(&self) -> usize {
        self.damaged
    }

    /// What the firmware last said of a value.
    pub fn value(&self, value: Value) -> Sample {
        self.values[value as usize]
    }

    /// The firmware's last health record.
    pub fn health(&self) -> Health {
        self.health
    }

    /// What the firmware last said that it shows.
    pub fn screen(&self) -> Option<Screen> {
        self.screen
    }

    /// Holds or lets go of a button of the cluster.
    pub fn hold_button(&mut self, index: usize, down: bool) {
        let now = self.now();
        self.board_mut().press(now, index, down);
    }

    /// Frames on the bus, received and lost.
    pub fn counts(&self) -> Counts {
        let chip = self.board().mcp2515().counters();
        Counts {
            on_bus: chip.frames_seen,
            stored: chip.frames_stored.iter().sum(),
            received: u64::from(self.health.frames_received),
            lost: chip.frames_overrun.iter().sum::<u64>()
                + chip.frames_discarded
                + u64::from(self.health.ring_overflows),
        }
    }

    /// The panel as a person would see it, as PNG: black while it is dark.
    pub fn picture_png(&self) -> Vec<u8> {
        let panel = self.board().panel();
        let mut picture = panel.visible(self.now()).unwrap_or_else(|| panel.glass());
        if panel.visible(self.now()).is_none() {
            picture.rgb.fill(0);
        }
        picture.png().unwrap_or_default()
    }

    /// The vehicle that the firmware says it is in.
    pub fn identified(&self) -> &'static Vehicle {
        self.identified
    }

    /// What the firmware says it shows, as lines for a person.
    pub fn shown_lines(&self) -> Vec<(String, String)> {
        Value::ALL
            .iter()
            .filter(|value| self.values[**value as usize] != Sample::Never)
            .map(|value| {
                (value.path().to_owned(), self.values[*value as usize].show(value.unit()).to_string())
            })
            .collect()
    }

    fn read_link(&mut self) {
        let (bytes, next) = self.chip.board.uart_since(self.uart_read);
        for &(at, byte) in bytes {
            match self.decoder.push(byte) {
                Some(Ok(record)) => {
                    match &record {
                        Record::Values { first, items } => {
                            for (index, sample) in (usize::from(*first)..).zip(items.as_slice()) {
                                if let Some(value) = self.values.get_mut(index) {
                                    *value = *sample;
                                }
                            }
                        }
                        Record::Health(health) => self.health = *health,
                        Record::Shown(screen) => self.screen = Some(*screen),
                        Record::Hello { vehicle, .. } => {
                            let known = VEHICLES.iter().find(|known| known.name == vehicle.as_str());
                            self.identified = known.copied().unwrap_or(&NO_VEHICLE);
                        }
                        // Whoever wants the others reads the records.
                        _ => {}
                    }
                    self.records.push((at, record));
                }
                Some(Err(_)) => self.damaged += 1,
                None => {}
            }
        }
        self.uart_read = next;
    }
}

/// The cluster's buttons: next, menu.
const BUTTONS: [u8; 2] = [2, 3];

/// Millivolts on GPIO 26 to 28: supply, front and rear air reservoir.
const ANALOG: [fn(&World) -> u32; 3] = [
    |world| at_pin(world.supply.volts / SUPPLY_DIVIDER),
    |world| air(world, world.air.front_mpa),
    |world| air(world, world.air.rear_mpa),
];
/// Resistors of 100k and 10k.
const SUPPLY_DIVIDER: f64 = 11.0;
/// Air sensors: 0.5 V at nothing, 4.5 V at 1.2 MPa, over resistors of 10k and 20k.
const AIR_ZERO_VOLTS: f64 = 0.5;
const AIR_VOLTS_PER_MPA: f64 = 4.0 / 1.2;
const AIR_DIVIDER: f64 = 1.5;
/// The pads' clamp diodes.
const PIN_MAX_MILLIVOLTS: f64 = 3_600.0;

fn at_pin(volts: f64) -> u32 {
    (volts * 1_000.0).clamp(0.0, PIN_MAX_MILLIVOLTS).round() as u32
}

/// Only the bus brakes with air; elsewhere nothing is connected.
fn air(world: &World, mpa: f64) -> u32 {
    let volts = (AIR_ZERO_VOLTS + mpa * AIR_VOLTS_PER_MPA) / AIR_DIVIDER;
    if world.kind == Kind::Citybus { at_pin(volts) } else { 0 }
}

fn pico_wiring() -> Wiring {
    Wiring {
        can: CanWiring { spi: 0, cs: 17, int: 20 },
        panel: PanelWiring { spi: 1, cs: 9, dc: 8, reset: Some(12), backlight: Some(13) },
        buzzer: Some(15),
        buttons: BUTTONS.into_iter().chain(SWITCHES.iter().map(|switch| switch.pin)).collect(),
        uart: 0,
    }
}

/// Writes down every frame on the bus.
struct Logger {
    node: NodeId,
    cluster: NodeId,
    last_sent: Option<Nanos>,
    heard: Arc<Mutex<Recent<Heard>>>,
}

impl Participant for Logger {
    fn start(&mut self, _: Nanos, _: &mut crate::can::Bus) {}

    fn on_event(&mut self, event: &Event, _: &mut crate::can::Bus) {
        let Ok(mut heard) = self.heard.lock() else { return };
        match event.kind {
            EventKind::Received { frame } if event.node == self.node => {
                heard.push(Heard { at: event.at, frame, by_cluster: false });
            }
            // The sender learns of its frame one bit after the receivers have it.
            EventKind::Sent { .. } if event.node == self.cluster && self.last_sent != Some(event.at) => {
                self.last_sent = Some(event.at);
                if let Some(last) = heard.last_mut() {
                    last.by_cluster = true;
                }
            }
            _ => {}
        }
    }
}
