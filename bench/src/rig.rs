//! A whole bench: the firmware's ELF in an RP2040 on a board, traffic on its bus, its records decoded.
//!
//! Owns the wiring of the Pico board as this repository's README prints it, written down here a second time on
//! purpose: firmware that drives another pin is found out. Refuses to know what a frame means.

use crate::can::{Event, EventKind, Frame, NodeId, Participant};
use crate::chips::bench_board::{BenchBoard, CanWiring, PanelWiring, Wiring};
use crate::chips::{mcp2515, panel};
use crate::log::Log;
use crate::rp2040::{Rp2040, Stop, image};
use crate::time::Nanos;
use anyhow::Result;
use protocol_core::Value;
use protocol_core::link::{Decoder, Health, Record, Sample, Screen};
use std::path::Path;
use std::sync::{Arc, Mutex};

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

/// Time between the end of a recording and its next start, when it is played in a loop.
const LOOP_PAUSE: Nanos = Nanos::from_millis(20);

/// A pixel that goes A, B, A within this span was cleared and drawn again: views come 50 ms apart.
const FLICKER_SPAN: Nanos = Nanos::from_millis(40);

/// A frame that was on the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heard {
    /// End of the frame.
    pub at: Nanos,
    /// The frame.
    pub frame: Frame,
    /// Sent by the cluster.
    pub by_cluster: bool,
}

/// Frames counted in different places.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Frames that other nodes sent over the bus while the controller listened.
    pub on_bus: u64,
    /// Frames that the firmware had received when it last reported.
    pub received: u64,
    /// Frames lost in the controller's buffers or in the firmware's queue.
    pub lost: u64,
}

/// A whole bench.
pub struct Rig {
    chip: Rp2040<BenchBoard>,
    heard: Arc<Mutex<Vec<Heard>>>,
    decoder: Decoder,
    uart_read: usize,
    records: Vec<(Nanos, Record)>,
    damaged: usize,
    values: [Sample; Value::COUNT],
    health: Health,
    screen: Option<Screen>,
}

impl Rig {
    /// Solders a Pico board together, writes the ELF into its flash and switches it on.
    ///
    /// # Errors
    /// If the file is not an image for the RP2040; the error names it and says why.
    pub fn new(elf: &Path, options: &RigOptions) -> Result<Self> {
        let flash = image::load_elf(elf)?;
        let can = mcp2515::Config { crystal_hz: options.crystal_hz, ..mcp2515::Config::default() };
        let panel = match options.panel {
            PanelKind::Ili9341 => panel::Config::ILI9341,
            PanelKind::St7789 => panel::Config::ST7789,
        };
        let panel = panel::Config { flicker_span: FLICKER_SPAN, ..panel };
        let mut board = BenchBoard::new(pico_wiring(), options.bitrate, can, panel);
        let heard = Arc::default();
        let node = board.bus_mut().attach("logger");
        let cluster = board.mcp2515().node();
        board.join(Logger { node, cluster, last_sent: None, heard: Arc::clone(&heard) });
        Ok(Self {
            chip: Rp2040::new(flash, board),
            heard,
            decoder: Decoder::new(),
            uart_read: 0,
            records: Vec::new(),
            damaged: 0,
            values: [Sample::Never; Value::COUNT],
            health: Health::default(),
            screen: None,
        })
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
        let result = self.chip.run_until(self.chip.now() + span);
        self.read_link();
        result
    }

    /// Virtual time since power-on.
    pub fn now(&self) -> Nanos {
        self.chip.now()
    }

    /// The chip, for its statistics.
    pub fn chip(&self) -> &Rp2040<BenchBoard> {
        &self.chip
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

    /// Every frame that was on the bus.
    pub fn heard(&self) -> Vec<Heard> {
        self.heard.lock().map(|heard| heard.clone()).unwrap_or_default()
    }

    /// Every record that the firmware has sent, with the time of its last byte.
    pub fn records(&self) -> &[(Nanos, Record)] {
        &self.records
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
        let uart = self.chip.board.uart();
        for &(at, byte) in uart.get(self.uart_read..).unwrap_or_default() {
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
                        Record::Hello { .. } | Record::Panic { .. } => {}
                    }
                    self.records.push((at, record));
                }
                Some(Err(_)) => self.damaged += 1,
                None => {}
            }
        }
        self.uart_read = uart.len();
    }
}

fn pico_wiring() -> Wiring {
    Wiring {
        can: CanWiring { spi: 0, cs: 17, int: 20 },
        panel: PanelWiring { spi: 1, cs: 9, dc: 8, reset: Some(12), backlight: Some(13) },
        buzzer: Some(15),
        buttons: vec![2, 3],
        uart: 0,
    }
}

/// Writes down every frame on the bus.
struct Logger {
    node: NodeId,
    cluster: NodeId,
    last_sent: Option<Nanos>,
    heard: Arc<Mutex<Vec<Heard>>>,
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
