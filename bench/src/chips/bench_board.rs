//! The board on the bench: MCP2515, panel, buzzer, buttons and UART wired to the RP2040's pins.
//!
//! Owns the wiring, the CAN bus with everything on it, and the logs of what left the RP2040. Routes pin edges and SPI
//! frames to the chip whose CS is low; the end of an SPI frame is the time that the chips see. Refuses to know what
//! the firmware is for.

use std::collections::VecDeque;

use super::mcp2515::{self, Mcp2515};
use super::panel::{self, Panel};
use crate::can::{Bus, Event, Participant};
use crate::pins::{Board, InputPins};
use crate::recent::Recent;
use crate::time::Nanos;

/// Where the MCP2515 is soldered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CanWiring {
    /// SPI port, 0 or 1.
    pub spi: u8,
    /// CS, low active.
    pub cs: u8,
    /// INT, low active, driven by the chip.
    pub int: u8,
}

/// Where the panel is soldered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PanelWiring {
    /// SPI port, 0 or 1.
    pub spi: u8,
    /// CS, low active.
    pub cs: u8,
    /// Data (high) or command (low).
    pub dc: u8,
    /// Reset, low active, if it is wired.
    pub reset: Option<u8>,
    /// Back-light, high active, PWM or plain; `None` = always on.
    pub backlight: Option<u8>,
}

/// What is soldered where; numbers are GPIO numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wiring {
    /// The CAN controller.
    pub can: CanWiring,
    /// SPI port and control pins of the panel.
    pub panel: PanelWiring,
    /// The buzzer's PWM pin.
    pub buzzer: Option<u8>,
    /// Buttons and switches to ground, pulled up.
    pub buttons: Vec<u8>,
    /// UART port whose bytes are recorded.
    pub uart: u8,
}

/// A change of a PWM output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PwmChange {
    /// When.
    pub at: Nanos,
    /// New frequency in Hz.
    pub frequency_hz: u32,
    /// High time of 65536.
    pub duty: u32,
}

/// Entries that each log keeps at least: minutes at full load.
const KEPT: usize = 1 << 18;

/// The chips beside the RP2040 and the wires between them.
pub struct BenchBoard {
    wiring: Wiring,
    bus: Bus,
    mcp2515: Mcp2515,
    panel: Panel,
    participants: Vec<Box<dyn Participant + Send>>,
    /// Button presses to come: when, which, pressed.
    presses: VecDeque<(Nanos, u8, bool)>,
    uart: Recent<(Nanos, u8)>,
    buzzer: Recent<PwmChange>,
    backlight: Recent<PwmChange>,
    int_edges: Recent<(Nanos, bool)>,
    miso_is_cut: bool,
    now: Nanos,
    due: Option<Nanos>,
}

impl BenchBoard {
    /// A board that is powered on at time zero, with a bus of `bitrate` bit/s.
    pub fn new(wiring: Wiring, bitrate: u32, can: mcp2515::Config, panel: panel::Config) -> Self {
        let mut bus = Bus::new(bitrate);
        let mcp2515 = Mcp2515::new(can, Nanos::ZERO, &mut bus);
        let mut panel = Panel::new(panel, Nanos::ZERO);
        if wiring.panel.backlight.is_none() {
            panel.set_backlight(panel::BACKLIGHT_FULL);
        }
        Self {
            wiring,
            bus,
            mcp2515,
            panel,
            participants: Vec::new(),
            presses: VecDeque::new(),
            uart: Recent::keeping(KEPT),
            buzzer: Recent::keeping(KEPT),
            backlight: Recent::keeping(KEPT),
            int_edges: Recent::keeping(KEPT),
            miso_is_cut: false,
            now: Nanos::ZERO,
            due: Some(Nanos::ZERO),
        }
    }

    /// The CAN bus.
    pub fn bus(&self) -> &Bus {
        &self.bus
    }

    /// The CAN bus, to attach nodes, request frames and force faults. Requests must not lie before [`Self::now`].
    pub fn bus_mut(&mut self) -> &mut Bus {
        self.due = Some(self.now);
        &mut self.bus
    }

    /// The CAN controller.
    pub fn mcp2515(&self) -> &Mcp2515 {
        &self.mcp2515
    }

    /// The CAN controller, to clear its violations.
    pub fn mcp2515_mut(&mut self) -> &mut Mcp2515 {
        &mut self.mcp2515
    }

    /// Fault: the CAN controller's MISO wire is off and reads high, or is on again.
    pub fn cut_miso(&mut self, cut: bool) {
        self.miso_is_cut = cut;
    }

    /// Returns the panel with what it shows.
    pub fn panel(&self) -> &Panel {
        &self.panel
    }

    /// The panel, to clear its violations.
    pub fn panel_mut(&mut self) -> &mut Panel {
        &mut self.panel
    }

    /// Time of the last call.
    pub fn now(&self) -> Nanos {
        self.now
    }

    /// Time has come to `now` without a call to the board: what is done to it from outside happens then.
    pub fn arrive_at(&mut self, now: Nanos) {
        self.now = self.now.max(now);
    }

    /// Puts a participant on the bus and starts it now.
    pub fn join(&mut self, mut participant: impl Participant + Send + 'static) {
        participant.start(self.now, &mut self.bus);
        self.participants.push(Box::new(participant));
        self.due = Some(self.now);
    }

    /// Presses (`true`) or lets go of button or switch `index` at `at`; presses must come in the order of time.
    pub fn press(&mut self, at: Nanos, index: usize, pressed: bool) {
        if let Some(&pin) = self.wiring.buttons.get(index) {
            self.presses.push_back((at.max(self.now), pin, pressed));
            self.refresh_due();
        }
    }

    /// Bytes that left the UART last, with the end of their stop bits.
    pub fn uart(&self) -> &[(Nanos, u8)] {
        self.uart.as_slice()
    }

    /// The same from byte `number` on, and the number of the byte that comes next.
    pub fn uart_since(&self, number: usize) -> (&[(Nanos, u8)], usize) {
        (self.uart.since(number), self.uart.next_number())
    }

    /// What the buzzer was told last.
    pub fn buzzer(&self) -> &[PwmChange] {
        self.buzzer.as_slice()
    }

    /// What the back-light was told last.
    pub fn backlight(&self) -> &[PwmChange] {
        self.backlight.as_slice()
    }

    /// Levels of the MCP2515's INT pin: at power-on, then every edge; the last ones of a long run.
    pub fn int_edges(&self) -> &[(Nanos, bool)] {
        self.int_edges.as_slice()
    }

    fn refresh_due(&mut self) {
        let press = self.presses.front().map(|&(at, _, _)| at);
        self.due = [self.bus.next_event(), self.mcp2515.next_event(), press].into_iter().flatten().min();
    }

    fn announce(&mut self, event: Event) {
        self.mcp2515.on_bus(&event, &mut self.bus);
        for participant in &mut self.participants {
            participant.on_event(&event, &mut self.bus);
        }
    }

    /// Drives INT as the chip has it now.
    fn show_int(&mut self, at: Nanos, inputs: &mut InputPins) {
        let level = self.mcp2515.int_level();
        if self.int_edges.last().is_none_or(|&(_, last)| last != level) {
            self.int_edges.push((at, level));
            inputs.drive(self.wiring.can.int, level);
        }
    }

    fn catch_up(&mut self, now: Nanos, inputs: &mut InputPins) {
        self.now = self.now.max(now);
        if self.due.is_none_or(|due| due > now) {
            return;
        }
        if self.int_edges.next_number() == 0 {
            for &pin in &self.wiring.buttons {
                inputs.drive(pin, true);
            }
        }
        loop {
            self.refresh_due();
            let Some(at) = self.due.filter(|&at| at <= now) else { break };
            while let Some(&(_, pin, pressed)) = self.presses.front().filter(|&&(due, _, _)| due <= at) {
                self.presses.pop_front();
                inputs.drive(pin, !pressed);
            }
            self.mcp2515.advance(at, &mut self.bus);
            while let Some(event) = self.bus.poll(at) {
                self.announce(event);
                self.show_int(event.at, inputs);
            }
            self.show_int(at, inputs);
        }
        self.show_int(now, inputs);
    }

    fn pwm_change(&mut self, at: Nanos, pin: u8, frequency_hz: u32, duty: u32) {
        let change = PwmChange { at, frequency_hz, duty };
        if self.wiring.panel.backlight == Some(pin) {
            self.panel.set_backlight(duty);
            self.backlight.push(change);
        } else if self.wiring.buzzer == Some(pin) {
            self.buzzer.push(change);
        }
    }
}

impl Board for BenchBoard {
    fn pin_out(&mut self, now: Nanos, pin: u8, level: bool, inputs: &mut InputPins) {
        self.catch_up(now, inputs);
        if pin == self.wiring.can.cs {
            self.mcp2515.select(now, !level, &mut self.bus);
            self.show_int(now, inputs);
            self.refresh_due();
        } else if pin == self.wiring.panel.cs {
            self.panel.select(now, !level);
        } else if pin == self.wiring.panel.dc {
            self.panel.data_command(now, level);
        } else if Some(pin) == self.wiring.panel.reset {
            self.panel.reset(now, level);
        } else {
            self.pwm_change(now, pin, 0, if level { panel::BACKLIGHT_FULL } else { 0 });
        }
    }

    fn spi_frame(&mut self, now: Nanos, port: u8, word: u16, bits: u8, inputs: &mut InputPins) -> u16 {
        self.catch_up(now, inputs);
        let mut reply = 0xFFFF;
        if port == self.wiring.panel.spi && (self.panel.is_selected() || port != self.wiring.can.spi) {
            reply &= self.panel.exchange(now, word, bits);
        }
        if port == self.wiring.can.spi && (self.mcp2515.is_selected() || port != self.wiring.panel.spi) {
            let answer = match bits {
                16 => self.mcp2515.exchange_pair(now, word, &mut self.bus),
                _ => 0xFF00 | u16::from(self.mcp2515.exchange(now, word as u8, &mut self.bus)),
            };
            reply &= if self.miso_is_cut { 0xFFFF } else { answer };
            self.show_int(now, inputs);
            self.refresh_due();
        }
        reply
    }

    fn power(&mut self, now: Nanos, on: bool, inputs: &mut InputPins) {
        self.catch_up(now, inputs);
        self.mcp2515.power_cycle(now, &mut self.bus);
        self.panel.power_cycle(now);
        if self.wiring.panel.backlight.is_none() {
            self.panel.set_backlight(if on { panel::BACKLIGHT_FULL } else { 0 });
        }
        self.show_int(now, inputs);
        self.refresh_due();
    }

    fn uart_byte(&mut self, now: Nanos, port: u8, byte: u8) {
        if port == self.wiring.uart {
            self.uart.push((now, byte));
        }
    }

    fn pwm(&mut self, now: Nanos, pin: u8, frequency_hz: u32, duty: u32) {
        self.pwm_change(now, pin, frequency_hz, duty);
    }

    fn next_event(&self) -> Option<Nanos> {
        self.due
    }

    fn advance(&mut self, now: Nanos, inputs: &mut InputPins) {
        self.catch_up(now, inputs);
    }
}
