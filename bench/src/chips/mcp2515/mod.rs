//! MCP2515 CAN controller: an SPI slave on one side, a node of the CAN bus on the other.
//!
//! Modelled: all nine SPI instructions with CS edges as their limits; all registers with their reset values and write
//! rules; normal, listen-only, loopback and configuration mode and the waits between them; bit timing from CNF1..3 and
//! the crystal; masks, filters (standard, extended, data bytes), RXM, rollover, filter hits; the message assembly
//! buffer and its overflow; three transmit buffers with priorities, one-shot, abort; error counters and EFLG; interrupt
//! flags, ICOD, the INT pin; the RXnBF pins; the oscillator start-up after power-on and reset; the 10 MHz limit and the
//! minimum CS pause; the repeated-frame erratum on request ([`Config::repeats_frames`]).
//!
//! Not modelled, and a [`Violation`] when touched: sleep and wake-up, the TXnRTS pins, reading a frame with errors in
//! listen-only mode. Not modelled and harmless: CLKOUT, triple sampling, the wake-up filter.
//!
//! A byte's reply is fixed when the byte before it has been clocked, a written byte takes effect when its last bit has.
//!
//! Source: Microchip DS20001801J; errata DS80179G.

mod codec;
mod filter;
mod regs;
mod timing;
mod violation;

use self::codec::IdRegisters;
use self::filter::Operation;
use self::regs::Access;
pub use self::timing::{BitTiming, TimingFault};
pub use self::violation::Violation;
use super::violations::Violations;
use crate::can::bits::FrameBits;
use crate::can::{Aborted, Bus, Event, EventKind, Frame, NodeId, NodeMode, Tag};
use crate::time::Nanos;

/// What MISO reads while the chip does not drive it.
const RELEASED: u8 = 0xFF;
/// Eight bits at the highest SPI clock, 10 MHz (table 13-6, F_CLK).
const FASTEST_BYTE: Nanos = Nanos(800);
/// Shortest pause between two instructions (table 13-6, T_CSD).
const SHORTEST_PAUSE: Nanos = Nanos(50);
/// Oscillator clocks after power-on and reset in which the chip does not answer (chapter 8.1).
const START_UP_CLOCKS: u64 = 128;
/// Counters from here on set a warning flag (chapter 7.6.2).
const WARNING_FROM: u16 = 96;
/// Counters above this set an error-passive flag (chapter 7.6.4).
const PASSIVE_ABOVE: u16 = 127;
/// Transmit counter above this sets TXBO (chapter 7.6.6).
const BUS_OFF_ABOVE: u16 = 255;
/// First filter of each receive buffer, and the one behind its last.
const FILTERS_OF: [std::ops::Range<usize>; 2] = [0..2, 2..6];

/// What is soldered around the chip, and which silicon it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config {
    /// Crystal in Hz: 8, 16 or 20 MHz on common modules.
    pub crystal_hz: u32,
    /// DS80179G item 5: a frame whose TXREQ was set by WRITE or BIT MODIFY instead of RTS goes out twice.
    pub repeats_frames: bool,
}

impl Default for Config {
    fn default() -> Self {
        Self { crystal_hz: 16_000_000, repeats_frames: false }
    }
}

/// Operating mode, as in CANSTAT.OPMOD.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Takes full part in the bus.
    Normal,
    /// Talks to itself only.
    Loopback,
    /// Hears the bus, never drives it.
    ListenOnly,
    /// Off the bus, timing and filters may be written.
    Configuration,
}

impl Mode {
    const fn code(self) -> u8 {
        match self {
            Self::Normal => 0b000,
            Self::Loopback => 0b010,
            Self::ListenOnly => 0b011,
            Self::Configuration => 0b100,
        }
    }

    /// The mode that CANCTRL.REQOP asks for; sleep and the invalid codes have none.
    const fn requested(canctrl: u8) -> Option<Self> {
        match canctrl >> 5 {
            0b000 => Some(Self::Normal),
            0b010 => Some(Self::Loopback),
            0b011 => Some(Self::ListenOnly),
            0b100 => Some(Self::Configuration),
            _ => None,
        }
    }

    const fn on_the_bus(self) -> NodeMode {
        match self {
            Self::Normal => NodeMode::Active,
            Self::ListenOnly => NodeMode::ListenOnly,
            Self::Loopback | Self::Configuration => NodeMode::Off,
        }
    }
}

/// What passed through the chip.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Bytes clocked while selected.
    pub spi_bytes: u64,
    /// Falling edges of CS.
    pub spi_transactions: u64,
    /// Valid frames that reached the message assembly buffer.
    pub frames_seen: u64,
    /// Of these, frames that no filter wanted.
    pub frames_filtered: u64,
    /// Of these, frames put into RXB0 and RXB1.
    pub frames_stored: [u64; 2],
    /// Of these, frames lost because RXB0 or RXB1 was full.
    pub frames_overrun: [u64; 2],
    /// Stored frames whose flag was cleared although nobody had read them.
    pub frames_discarded: u64,
    /// Stored frames that were released while the other buffer held an older one.
    pub frames_read_out_of_order: u64,
    /// Frames sent and acknowledged, or looped back.
    pub frames_sent: u64,
    /// Frames repeated by the erratum.
    pub frames_repeated: u64,
    /// Errors seen on the bus.
    pub bus_errors: u64,
}

/// The instruction that the last bytes belong to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Instruction {
    /// CS is high.
    None,
    /// CS is low, nothing clocked yet.
    Opcode,
    /// Unknown, finished or refused: further bytes are ignored.
    Done,
    ReadAddress,
    Read(u8),
    WriteAddress,
    Write(u8),
    LoadTransmit(u8),
    ReadStatus,
    ReceiveStatus,
    ModifyAddress,
    ModifyMask(u8),
    ModifyData(u8, u8),
}

/// The chip.
#[derive(Debug)]
pub struct Mcp2515 {
    config: Config,
    node: NodeId,
    regs: [u8; regs::COUNT],
    mode: Mode,
    /// Asked for, but the bus is not ready yet.
    mode_wanted: Option<Mode>,
    started_at: Nanos,

    instruction: Instruction,
    opcode: u8,
    reply: u8,
    /// Buffer whose flag READ RX BUFFER clears at the end.
    releases: Option<usize>,
    selected_at: Nanos,
    deselected_at: Nanos,
    last_byte_at: Option<Nanos>,

    /// The stored frame has been read at least in part.
    read: [bool; 2],
    /// The stored frame came while READ RX BUFFER was reading what was there before.
    arrived_during_read: [bool; 2],
    /// Which of all frames seen each buffer holds.
    arrival: [u64; 2],
    /// Filter of the frame in RXB1, 0..=5, and whether it rolled over.
    filter_hit: [u8; 2],
    /// The transmit buffer that the bus knows about.
    offered: Option<usize>,
    /// ABAT met this buffer in the middle of its frame.
    aborting: [bool; 3],
    /// The erratum will send this buffer once more.
    repeats: [bool; 3],
    /// The transmit buffer that talks to itself, and until when.
    loopback: Option<(usize, Nanos)>,

    counters: Counters,
    violations: Violations<Violation>,
}

impl Mcp2515 {
    /// A chip that is powered on at `now` and joins `bus` when the firmware says so.
    pub fn new(config: Config, now: Nanos, bus: &mut Bus) -> Self {
        let node = bus.attach_off("mcp2515");
        let mut chip = Self {
            config,
            node,
            regs: regs::reset_values(),
            mode: Mode::Configuration,
            mode_wanted: None,
            started_at: Nanos::ZERO,
            instruction: Instruction::None,
            opcode: 0,
            reply: RELEASED,
            releases: None,
            selected_at: now,
            deselected_at: Nanos::ZERO,
            last_byte_at: None,
            read: [true; 2],
            arrived_during_read: [false; 2],
            arrival: [0; 2],
            filter_hit: [0; 2],
            offered: None,
            aborting: [false; 3],
            repeats: [false; 3],
            loopback: None,
            counters: Counters::default(),
            violations: Violations::default(),
        };
        chip.started_at = now + chip.start_up();
        chip
    }

    /// The chip's node on the bus.
    pub fn node(&self) -> NodeId {
        self.node
    }

    /// The mode that CANSTAT shows.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The bit timing in CNF1..CNF3.
    pub fn bit_timing(&self) -> BitTiming {
        BitTiming::of(self.reg(regs::CNF1), self.reg(regs::CNF2), self.reg(regs::CNF3))
    }

    /// What passed through the chip.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// How the chip was misused.
    pub fn violations(&self) -> &Violations<Violation> {
        &self.violations
    }

    /// The same, to clear it.
    pub fn violations_mut(&mut self) -> &mut Violations<Violation> {
        &mut self.violations
    }

    /// True while CS is low.
    pub fn is_selected(&self) -> bool {
        self.instruction != Instruction::None
    }

    /// Level of the INT pin: low while any enabled flag is set.
    pub fn int_level(&self) -> bool {
        self.reg(regs::CANINTF) & self.reg(regs::CANINTE) == 0
    }

    /// Levels of RX0BF and RX1BF, `None` while a pin floats (register 4-3).
    pub fn buffer_full_pins(&self) -> [Option<bool>; 2] {
        let control = self.reg(regs::BFPCTRL);
        [0, 1].map(|n| {
            let bit = |base: u8| control >> (base + n) & 1 == 1;
            match (bit(2), bit(0)) {
                (false, _) => None,
                (true, true) => Some(self.reg(regs::CANINTF) & regs::RX0 << n == 0),
                (true, false) => Some(bit(4)),
            }
        })
    }

    /// The value that a READ of `address` would give, without a transaction: for tests.
    pub fn peek(&self, address: u8, bus: &Bus) -> u8 {
        let address = regs::canonical(address);
        match address {
            regs::CANSTAT => self.mode.code() << 5 | self.interrupt_code() << 1,
            regs::TEC => bus.counters(self.node).transmit.min(255) as u8,
            regs::REC => bus.counters(self.node).receive.min(255) as u8,
            _ if regs::is_acceptance(address) && self.mode != Mode::Configuration => 0,
            _ => self.reg(address),
        }
    }

    /// The next instant at which the chip does something by itself; bus events come through [`Mcp2515::on_bus`].
    pub fn next_event(&self) -> Option<Nanos> {
        self.loopback.map(|(_, until)| until)
    }

    /// Brings the chip's own clock up to `now`.
    pub fn advance(&mut self, now: Nanos, bus: &mut Bus) {
        // Every pass sends one pending buffer: at most three, unless the erratum repeats them once.
        while let Some((buffer, until)) = self.loopback.filter(|&(_, until)| until <= now) {
            self.loopback = None;
            if let Some(frame) = self.transmit_frame(buffer) {
                self.receive(&frame);
            }
            self.sent(buffer);
            self.pursue(until, bus);
        }
    }

    /// CS goes low (`true`) or high (`false`).
    pub fn select(&mut self, now: Nanos, selected: bool, bus: &mut Bus) {
        if selected == (self.instruction != Instruction::None) {
            return;
        }
        if selected {
            self.counters.spi_transactions += 1;
            if self.counters.spi_transactions > 1 && now.since(self.deselected_at) < SHORTEST_PAUSE {
                self.violations.report(now, Violation::PauseTooShort);
            }
            self.instruction = Instruction::Opcode;
            self.reply = RELEASED;
            self.selected_at = now;
            self.last_byte_at = None;
            return;
        }
        let cut_off = matches!(
            self.instruction,
            Instruction::ReadAddress
                | Instruction::WriteAddress
                | Instruction::ModifyAddress
                | Instruction::ModifyMask(_)
                | Instruction::ModifyData(..)
        );
        if cut_off {
            self.violations.report(now, Violation::Incomplete(self.opcode));
        }
        if let Some(buffer) = self.releases.take() {
            self.write_flags(!(regs::RX0 << buffer), 0);
        }
        self.instruction = Instruction::None;
        self.deselected_at = now;
        self.pursue(now, bus);
    }

    /// Clocks one byte in and one out; `now` is the end of its last bit.
    pub fn exchange(&mut self, now: Nanos, byte: u8, bus: &mut Bus) -> u8 {
        self.check_clock(now, 1);
        self.clock(now, byte, bus)
    }

    /// Clocks two bytes in one SPI frame of 16 bits, the high one first; both take effect at `now`, its end.
    pub fn exchange_pair(&mut self, now: Nanos, pair: u16, bus: &mut Bus) -> u16 {
        self.check_clock(now, 2);
        let [high, low] = pair.to_be_bytes();
        u16::from_be_bytes([self.clock(now, high, bus), self.clock(now, low, bus)])
    }

    /// Reports bytes that came faster than the chip can read.
    fn check_clock(&mut self, now: Nanos, bytes: u64) {
        let byte = Nanos(now.since(self.last_byte_at.unwrap_or(self.selected_at)).0 / bytes);
        self.last_byte_at = Some(now);
        if self.is_selected() && byte < FASTEST_BYTE {
            self.violations.report(now, Violation::SpiTooFast { byte });
        }
    }

    fn clock(&mut self, now: Nanos, byte: u8, bus: &mut Bus) -> u8 {
        if self.instruction == Instruction::None {
            self.violations.report(now, Violation::NotSelected);
            return RELEASED;
        }
        self.counters.spi_bytes += 1;
        let reply = std::mem::replace(&mut self.reply, RELEASED);
        self.instruction = self.step(now, byte, bus);
        self.reply = self.next_reply(bus);
        reply
    }

    /// Takes note of what happened on the bus; events of other nodes are ignored.
    pub fn on_bus(&mut self, event: &Event, bus: &mut Bus) {
        if event.node != self.node {
            return;
        }
        match event.kind {
            EventKind::Joined => {
                if let Some(mode) = self.mode_wanted.take() {
                    self.mode = mode;
                }
            }
            EventKind::Received { frame } => self.receive(&frame),
            EventKind::Sent { tag } => {
                self.offered = None;
                self.sent(buffer_of(tag));
            }
            EventKind::ArbitrationLost { tag } => self.txb_control(buffer_of(tag), 0xFF, regs::MLOA),
            EventKind::GivenUp { tag } => self.given_up(buffer_of(tag)),
            EventKind::Error { transmitting, .. } => self.bus_error(transmitting),
            EventKind::StateChanged { .. } => {}
        }
        self.pursue(event.at, bus);
    }

    fn start_up(&self) -> Nanos {
        Nanos(START_UP_CLOCKS * 1_000_000_000 / u64::from(self.config.crystal_hz.max(1)))
    }

    fn reg(&self, address: u8) -> u8 {
        self.regs[usize::from(address)]
    }

    fn reg_mut(&mut self, address: u8) -> &mut u8 {
        &mut self.regs[usize::from(address)]
    }

    /// Source of the most urgent enabled interrupt (register 10-2, ICOD).
    fn interrupt_code(&self) -> u8 {
        // Error, wake-up, TXB0, TXB1, TXB2, RXB0, RXB1: most urgent first.
        const BY_URGENCY: [u8; 7] = [1 << 5, 1 << 6, 1 << 2, 1 << 3, 1 << 4, 1 << 0, 1 << 1];
        let pending = self.reg(regs::CANINTF) & self.reg(regs::CANINTE);
        (1u8..).zip(BY_URGENCY).find(|&(_, flag)| pending & flag != 0).map_or(0, |(code, _)| code)
    }

    fn step(&mut self, now: Nanos, byte: u8, bus: &mut Bus) -> Instruction {
        match self.instruction {
            Instruction::None | Instruction::Done => Instruction::Done,
            Instruction::Opcode => self.decode(now, byte, bus),
            Instruction::ReadAddress => Instruction::Read(self.checked(now, byte)),
            Instruction::Read(address) => Instruction::Read(address.wrapping_add(1) & 0x7F),
            Instruction::WriteAddress => Instruction::Write(self.checked(now, byte)),
            Instruction::Write(address) => {
                self.write(now, address, 0xFF, byte, bus);
                Instruction::Write(address.wrapping_add(1) & 0x7F)
            }
            Instruction::LoadTransmit(address) => {
                self.write(now, address, 0xFF, byte, bus);
                Instruction::LoadTransmit(address.wrapping_add(1) & 0x7F)
            }
            Instruction::ReadStatus => Instruction::ReadStatus,
            Instruction::ReceiveStatus => Instruction::ReceiveStatus,
            Instruction::ModifyAddress => Instruction::ModifyMask(self.checked(now, byte)),
            Instruction::ModifyMask(address) => Instruction::ModifyData(address, byte),
            Instruction::ModifyData(address, mask) => {
                let modifiable = regs::is_bit_modifiable(regs::canonical(address));
                self.write(now, address, if modifiable { mask } else { 0xFF }, byte, bus);
                Instruction::Done
            }
        }
    }

    fn decode(&mut self, now: Nanos, opcode: u8, bus: &mut Bus) -> Instruction {
        self.opcode = opcode;
        if now < self.started_at {
            self.violations.report(now, Violation::NotStarted);
            return Instruction::Done;
        }
        match opcode {
            0b1100_0000 => {
                self.reset(now, bus);
                Instruction::Done
            }
            0b0000_0011 => Instruction::ReadAddress,
            0b0000_0010 => Instruction::WriteAddress,
            0b0000_0101 => Instruction::ModifyAddress,
            0b1010_0000 => Instruction::ReadStatus,
            0b1011_0000 => Instruction::ReceiveStatus,
            0b1001_0000 | 0b1001_0010 | 0b1001_0100 | 0b1001_0110 => {
                let buffer = usize::from(opcode >> 2 & 1);
                self.releases = Some(buffer);
                let offset = if opcode & 0b10 != 0 { 6 } else { 1 }; // D0 or SIDH
                Instruction::Read(regs::RXBCTRL[buffer] + offset)
            }
            0b0100_0000..=0b0100_0101 => {
                let offset = if opcode & 1 != 0 { 6 } else { 1 };
                Instruction::LoadTransmit(regs::TXBCTRL[usize::from(opcode >> 1 & 0b11)] + offset)
            }
            0b1000_0000..=0b1000_0111 => {
                for buffer in (0..3).filter(|buffer| opcode >> buffer & 1 == 1) {
                    self.request(now, buffer, bus);
                }
                Instruction::Done
            }
            _ => {
                self.violations.report(now, Violation::UnknownInstruction(opcode));
                Instruction::Done
            }
        }
    }

    fn checked(&mut self, now: Nanos, address: u8) -> u8 {
        if address > 0x7F {
            self.violations.report(now, Violation::AddressOutOfRange(address));
        }
        address & 0x7F
    }

    /// What MISO will carry during the next byte.
    fn next_reply(&mut self, bus: &Bus) -> u8 {
        match self.instruction {
            Instruction::Read(address) => {
                for (buffer, control) in regs::RXBCTRL.into_iter().enumerate() {
                    if (control + 1..=control + 0x0D).contains(&address) {
                        self.read[buffer] = true;
                    }
                }
                self.peek(address, bus)
            }
            Instruction::ReadStatus => self.status(),
            Instruction::ReceiveStatus => self.receive_status(),
            _ => RELEASED,
        }
    }

    /// Figure 12-8.
    fn status(&self) -> u8 {
        let flags = self.reg(regs::CANINTF);
        (0..3u8).fold(flags & 0b11, |status, buffer| {
            let requested = self.reg(regs::TXBCTRL[usize::from(buffer)]) & regs::TXREQ != 0;
            let sent = flags & regs::TX0 << buffer != 0;
            status | u8::from(requested) << (2 + 2 * buffer) | u8::from(sent) << (3 + 2 * buffer)
        })
    }

    /// Figure 12-9.
    fn receive_status(&self) -> u8 {
        let full = self.reg(regs::CANINTF) & 0b11;
        let buffer = match full {
            0 => return 0,
            0b10 => 1,
            _ => 0,
        };
        let start = usize::from(regs::RXBCTRL[buffer]);
        let extended = self.regs[start + 2] & codec::IDE != 0;
        let remote = self.regs[start] & regs::RXRTR != 0;
        full << 6 | u8::from(extended) << 4 | u8::from(remote) << 3 | self.filter_hit[buffer]
    }

    fn write(&mut self, now: Nanos, address: u8, mask: u8, value: u8, bus: &mut Bus) {
        let address = regs::canonical(address);
        let writable = match regs::access(address) {
            Access::Write(writable) => writable,
            Access::Configuration(writable) if self.mode == Mode::Configuration => writable,
            Access::Configuration(_) => {
                return self.violations.report(now, Violation::OutsideConfiguration(address));
            }
            Access::Transmit(buffer, _) if self.reg(regs::TXBCTRL[buffer]) & regs::TXREQ != 0 => {
                return self.violations.report(now, Violation::BufferPending(address));
            }
            Access::Transmit(_, writable) => writable,
            Access::ReadOnly => return self.violations.report(now, Violation::ReadOnly(address)),
        };
        let mask = mask & writable;
        let old = self.reg(address);
        let new = old & !mask | value & mask;
        match address {
            regs::CANINTF => self.write_flags(!mask, value & mask),
            regs::CANCTRL => {
                *self.reg_mut(address) = new;
                self.control_written(now, old, new, bus);
            }
            regs::TXRTSCTRL if new != 0 => self.violations.report(now, Violation::RequestPins(new)),
            0x30 | 0x40 | 0x50 => self.transmit_control_written(now, usize::from(address >> 4) - 3, new, bus),
            0x60 => {
                let copy = if new & regs::BUKT != 0 { regs::BUKT1 } else { 0 };
                *self.reg_mut(address) = new & !regs::BUKT1 | copy;
                self.check_receive_mode(now, new);
            }
            0x70 => {
                *self.reg_mut(address) = new;
                self.check_receive_mode(now, new);
            }
            _ => *self.reg_mut(address) = new,
        }
    }

    fn check_receive_mode(&mut self, now: Nanos, control: u8) {
        if matches!(Operation::of(control), Operation::FilterStandard | Operation::FilterExtended) {
            self.violations.report(now, Violation::ReservedReceiveMode(control));
        }
    }

    /// Writes CANINTF. A receive flag that goes frees its buffer; ERRIF stays while an overflow is not cleared
    /// (chapter 7.7: a flag cannot be reset until its condition is removed).
    fn write_flags(&mut self, keep: u8, set: u8) {
        let old = self.reg(regs::CANINTF);
        let overflow = self.reg(regs::EFLG) & (regs::RX0OVR | regs::RX0OVR << 1) != 0;
        let new = old & keep | set | if overflow { regs::ERR } else { 0 };
        for (buffer, other) in [(0, 1), (1, 0)] {
            if old & !new & regs::RX0 << buffer == 0 {
                continue;
            }
            let unread = !self.read[buffer] || self.arrived_during_read[buffer];
            let overtakes = new & regs::RX0 << other != 0 && self.arrival[other] < self.arrival[buffer];
            self.counters.frames_discarded += u64::from(unread);
            self.counters.frames_read_out_of_order += u64::from(overtakes);
        }
        *self.reg_mut(regs::CANINTF) = new;
    }

    fn raise(&mut self, flags: u8) {
        *self.reg_mut(regs::CANINTF) |= flags;
    }

    fn control_written(&mut self, now: Nanos, old: u8, new: u8, bus: &mut Bus) {
        match Mode::requested(new) {
            None => {
                self.violations.report(now, Violation::ModeNotModelled(new));
                self.mode_wanted = None;
            }
            Some(mode) if mode == self.mode => {
                self.mode_wanted = None;
                bus.set_mode(self.node, now, mode.on_the_bus()); // a join that has not come is taken back
            }
            Some(mode) => self.mode_wanted = Some(mode),
        }
        if new & regs::ABAT != 0 && old & regs::ABAT == 0 {
            for buffer in 0..3 {
                self.abort(buffer, true, bus);
            }
        }
        self.pursue(now, bus);
    }

    /// The supply fails and comes back: registers are as after power-on, the node leaves the bus, the counters stay.
    pub fn power_cycle(&mut self, now: Nanos, bus: &mut Bus) {
        self.reset(now, bus);
        self.instruction = Instruction::None;
        self.reply = RELEASED;
        self.selected_at = now;
        self.last_byte_at = None;
    }

    fn reset(&mut self, now: Nanos, bus: &mut Bus) {
        bus.set_mode(self.node, now, NodeMode::Off);
        bus.reset_errors(self.node);
        if let Some(buffer) = self.offered.take() {
            bus.abort(self.node, tag_of(buffer));
        }
        self.regs = regs::reset_values();
        self.mode = Mode::Configuration;
        self.mode_wanted = None;
        self.releases = None;
        self.read = [true; 2];
        self.arrival = [0; 2];
        self.filter_hit = [0; 2];
        self.aborting = [false; 3];
        self.repeats = [false; 3];
        self.loopback = None;
        self.started_at = now + self.start_up();
    }

    /// Does what the bus allows now: the wanted mode, the next frame, the error flags.
    fn pursue(&mut self, now: Nanos, bus: &mut Bus) {
        self.change_mode(now, bus);
        self.offer(now, bus);
        self.follow_error_counters(bus);
    }

    fn change_mode(&mut self, now: Nanos, bus: &mut Bus) {
        let Some(wanted) = self.mode_wanted else { return };
        let pending = regs::TXBCTRL.iter().any(|&control| self.reg(control) & regs::TXREQ != 0);
        let speaking = matches!(self.mode, Mode::Normal | Mode::Loopback) && pending;
        if speaking || self.loopback.is_some() || bus.is_busy(self.node) {
            return;
        }
        match (self.mode.on_the_bus(), wanted.on_the_bus()) {
            (_, NodeMode::Off) => {
                if let Some(buffer) = self.offered.take() {
                    bus.abort(self.node, tag_of(buffer));
                }
                bus.set_mode(self.node, now, NodeMode::Off);
                if wanted == Mode::Configuration {
                    bus.reset_errors(self.node);
                }
                self.enter(wanted);
            }
            (NodeMode::Off, mode) => {
                // The mode comes with `Joined`; asking again until then changes nothing.
                let timing = self.bit_timing();
                if let Some(fault) = timing.fault()
                    && !self.violations.first().iter().any(|(_, v)| *v == Violation::Timing(fault))
                {
                    self.violations.report(now, Violation::Timing(fault));
                }
                bus.set_bitrate(self.node, timing.bitrate(self.config.crystal_hz));
                bus.set_mode(self.node, now, mode);
            }
            (_, mode) => {
                bus.set_mode(self.node, now, mode);
                self.enter(wanted);
            }
        }
    }

    fn enter(&mut self, mode: Mode) {
        self.mode = mode;
        self.mode_wanted = None;
    }

    fn txb_control(&mut self, buffer: usize, keep: u8, set: u8) {
        let control = self.reg_mut(regs::TXBCTRL[buffer]);
        *control = *control & keep | set;
    }

    fn transmit_frame(&self, buffer: usize) -> Option<Frame> {
        let start = usize::from(regs::TXBCTRL[buffer]) + 1;
        codec::transmit_frame(self.regs[start..start + 13].try_into().ok()?)
    }

    /// Sets TXREQ, which clears the marks of the last attempt (register 3-1).
    fn request(&mut self, now: Nanos, buffer: usize, bus: &mut Bus) {
        self.txb_control(buffer, !(regs::ABTF | regs::MLOA | regs::TXERR), regs::TXREQ);
        self.pursue(now, bus);
    }

    fn transmit_control_written(&mut self, now: Nanos, buffer: usize, new: u8, bus: &mut Bus) {
        let control = regs::TXBCTRL[buffer];
        let was_requested = self.reg(control) & regs::TXREQ != 0;
        if was_requested && new & regs::TXREQ == 0 {
            // A frame on the bus goes on and is not tried again.
            self.abort(buffer, false, bus);
        }
        *self.reg_mut(control) = new;
        match (was_requested, new & regs::TXREQ != 0) {
            (false, true) => {
                self.repeats[buffer] = self.config.repeats_frames;
                self.request(now, buffer, bus);
            }
            _ => self.pursue(now, bus),
        }
    }

    /// Takes a request back: by ABAT, which leaves a mark, or by clearing TXREQ, which does not (chapter 3.6).
    fn abort(&mut self, buffer: usize, by_abat: bool, bus: &mut Bus) {
        if self.reg(regs::TXBCTRL[buffer]) & regs::TXREQ == 0
            || self.loopback.is_some_and(|(b, _)| b == buffer)
        {
            return;
        }
        let on_the_bus =
            self.offered == Some(buffer) && bus.abort(self.node, tag_of(buffer)) == Aborted::InTransmission;
        if on_the_bus {
            self.aborting[buffer] = by_abat;
            return;
        }
        if self.offered == Some(buffer) {
            self.offered = None;
        }
        self.txb_control(buffer, !regs::TXREQ, if by_abat { regs::ABTF } else { 0 });
    }

    /// The buffer that goes next: highest TXP, then highest number (chapter 3.3).
    fn most_urgent(&self) -> Option<usize> {
        let urgency = |buffer: &usize| (self.reg(regs::TXBCTRL[*buffer]) & regs::TXP, *buffer);
        (0..3).filter(|&buffer| self.reg(regs::TXBCTRL[buffer]) & regs::TXREQ != 0).max_by_key(urgency)
    }

    /// Keeps the bus informed about the frame that goes next; a frame under way stays.
    fn offer(&mut self, now: Nanos, bus: &mut Bus) {
        let halted = self.reg(regs::CANCTRL) & regs::ABAT != 0;
        let next = self.most_urgent().filter(|_| !halted);
        match self.mode {
            Mode::Normal => {}
            Mode::Loopback => {
                if let (Some(buffer), None) = (next, self.loopback)
                    && let Some(frame) = self.transmit_frame(buffer)
                {
                    let bitrate = u64::from(self.bit_timing().bitrate(self.config.crystal_hz).max(1));
                    let bits = u64::from(FrameBits::of(&frame).total());
                    self.loopback = Some((buffer, now + Nanos(bits * 1_000_000_000 / bitrate)));
                }
                return;
            }
            Mode::ListenOnly | Mode::Configuration => return,
        }
        if self.offered == next || bus.is_transmitting(self.node) {
            return;
        }
        if let Some(old) = self.offered.take() {
            bus.abort(self.node, tag_of(old));
        }
        let Some((buffer, frame)) = next.and_then(|buffer| Some((buffer, self.transmit_frame(buffer)?)))
        else {
            return;
        };
        self.offered = Some(buffer);
        if self.reg(regs::CANCTRL) & regs::OSM != 0 {
            bus.request_once(self.node, now, frame, tag_of(buffer));
        } else {
            bus.request(self.node, now, frame, tag_of(buffer));
        }
    }

    fn sent(&mut self, buffer: usize) {
        self.counters.frames_sent += 1;
        self.aborting[buffer] = false;
        self.raise(regs::TX0 << buffer);
        if std::mem::take(&mut self.repeats[buffer]) {
            self.counters.frames_repeated += 1;
        } else {
            self.txb_control(buffer, !regs::TXREQ, 0);
        }
    }

    fn given_up(&mut self, buffer: usize) {
        self.offered = None;
        let one_shot = self.reg(regs::CANCTRL) & regs::OSM != 0;
        let marked = std::mem::take(&mut self.aborting[buffer]) || one_shot;
        self.txb_control(buffer, !regs::TXREQ, if marked { regs::ABTF } else { 0 });
    }

    fn bus_error(&mut self, transmitting: Option<Tag>) {
        self.counters.bus_errors += 1;
        self.raise(regs::MERR);
        if let Some(tag) = transmitting {
            self.txb_control(buffer_of(tag), 0xFF, regs::TXERR);
        }
    }

    fn id_registers(&self, start: u8) -> IdRegisters {
        let start = usize::from(start);
        [self.regs[start], self.regs[start + 1], self.regs[start + 2], self.regs[start + 3]]
    }

    fn filter_hit(&self, buffer: usize, frame: &Frame) -> Option<usize> {
        let mask = self.id_registers(regs::RXM0SIDH + 4 * buffer as u8);
        let range = FILTERS_OF[buffer].clone();
        let filters: Vec<IdRegisters> = range.clone().map(|n| self.id_registers(regs::RXFSIDH[n])).collect();
        let operation = Operation::of(self.reg(regs::RXBCTRL[buffer]));
        filter::hit(operation, mask, &filters, frame).map(|hit| range.start + hit)
    }

    /// The message assembly buffer holds a valid frame: figure 4-3.
    fn receive(&mut self, frame: &Frame) {
        self.counters.frames_seen += 1;
        let full = |chip: &Self, buffer: usize| chip.reg(regs::CANINTF) & regs::RX0 << buffer != 0;
        if let Some(hit) = self.filter_hit(0, frame) {
            let rolls_over = self.reg(regs::RXBCTRL[0]) & regs::BUKT != 0;
            match (full(self, 0), rolls_over) {
                (false, _) => self.store(0, hit, frame, false),
                (true, false) => self.overrun(0),
                (true, true) if full(self, 1) => self.overrun(1),
                (true, true) => self.store(1, hit, frame, true),
            }
        } else if let Some(hit) = self.filter_hit(1, frame) {
            if full(self, 1) { self.overrun(1) } else { self.store(1, hit, frame, false) }
        } else {
            self.counters.frames_filtered += 1;
        }
    }

    fn store(&mut self, buffer: usize, hit: usize, frame: &Frame, rolled_over: bool) {
        let control = regs::RXBCTRL[buffer];
        let start = usize::from(control) + 1;
        codec::store_received(frame, &mut self.regs[start..start + 13]);
        let hit = hit as u8;
        let remote = if frame.remote { regs::RXRTR } else { 0 };
        if buffer == 0 || rolled_over {
            // FILHIT0 names the filter of a frame that rolled over, too (register 4-1, note 1).
            let first = self.reg_mut(regs::RXBCTRL[0]);
            *first = *first & !1 | hit;
        }
        let hit_mask = if buffer == 0 { 0b1 } else { 0b111 };
        let value = self.reg_mut(control);
        *value = *value & !(hit_mask | regs::RXRTR) | hit | remote;
        // RX STATUS calls the filters of a frame that rolled over 6 and 7 (figure 12-9).
        self.filter_hit[buffer] = if rolled_over { 6 + hit } else { hit };
        self.read[buffer] = false;
        self.arrival[buffer] = self.counters.frames_seen;
        self.arrived_during_read[buffer] = self.releases == Some(buffer);
        self.counters.frames_stored[buffer] += 1;
        self.raise(regs::RX0 << buffer);
    }

    fn overrun(&mut self, buffer: usize) {
        self.counters.frames_overrun[buffer] += 1;
        *self.reg_mut(regs::EFLG) |= regs::RX0OVR << buffer;
        self.raise(regs::ERR);
    }

    /// EFLG follows the counters; every change is an error interrupt (chapter 7.6).
    fn follow_error_counters(&mut self, bus: &Bus) {
        let counters = bus.counters(self.node);
        let transmit_warns = counters.transmit >= WARNING_FROM;
        let receive_warns = counters.receive >= WARNING_FROM;
        let flags = [
            (counters.transmit > BUS_OFF_ABOVE, regs::TXBO),
            (counters.transmit > PASSIVE_ABOVE, regs::TXEP),
            (counters.receive > PASSIVE_ABOVE, regs::RXEP),
            (transmit_warns, regs::TXWAR),
            (receive_warns, regs::RXWAR),
            (transmit_warns || receive_warns, regs::EWARN),
        ];
        let state = flags.into_iter().filter(|&(set, _)| set).fold(0, |eflg, (_, flag)| eflg | flag);
        let old = self.reg(regs::EFLG);
        if old & regs::EFLG_STATE != state {
            *self.reg_mut(regs::EFLG) = old & !regs::EFLG_STATE | state;
            self.raise(regs::ERR);
        }
    }
}

fn tag_of(buffer: usize) -> Tag {
    Tag(buffer as u32)
}

fn buffer_of(tag: Tag) -> usize {
    (tag.0 as usize).min(2)
}
