//! An MCP2515 model on a bus with one peer, clocked byte by byte, and an embedded-hal `SpiDevice` over it.
#![allow(dead_code)] // each test file uses its part

use std::cell::RefCell;
use std::convert::Infallible;
use std::rc::Rc;

use bench::can::{Bus, Event, EventKind, Frame, Id, NodeId, Tag};
use bench::chips::mcp2515::{Config, Mcp2515};
use bench::time::Nanos;
use embedded_hal::spi::{ErrorType, Operation, SpiDevice};

pub(crate) const BITRATE: u32 = 250_000;
pub(crate) const BIT: Nanos = Nanos(4_000);
/// 250 kbit/s from 16 MHz: 16 quanta, sample point 87.5 %.
pub(crate) const CNF_250K: [u8; 3] = [0x01, 0xBC, 0x01];
pub(crate) const CANSTAT: u8 = 0x0E;
pub(crate) const CANCTRL: u8 = 0x0F;
pub(crate) const CNF3: u8 = 0x28;
pub(crate) const CANINTE: u8 = 0x2B;
pub(crate) const CANINTF: u8 = 0x2C;
pub(crate) const EFLG: u8 = 0x2D;
pub(crate) const RXB0CTRL: u8 = 0x60;
pub(crate) const RXB1CTRL: u8 = 0x70;

pub(crate) struct Rig {
    pub(crate) bus: Bus,
    pub(crate) chip: Mcp2515,
    pub(crate) peer: NodeId,
    pub(crate) now: Nanos,
    /// Time of one SPI byte.
    pub(crate) byte: Nanos,
    /// CS high between two transactions.
    pub(crate) pause: Nanos,
    /// What the peer has heard.
    pub(crate) heard: Vec<(Nanos, Frame)>,
    pub(crate) events: Vec<Event>,
}

impl Rig {
    pub(crate) fn new(config: Config) -> Self {
        let mut bus = Bus::new(BITRATE);
        let chip = Mcp2515::new(config, Nanos::ZERO, &mut bus);
        let peer = bus.attach("peer");
        let now = Nanos::from_millis(1);
        Self {
            bus,
            chip,
            peer,
            now,
            byte: Nanos(800),
            pause: Nanos(100),
            heard: Vec::new(),
            events: Vec::new(),
        }
    }

    /// A chip in normal mode at 250 kbit/s that takes any message, with rollover and all receive interrupts.
    pub(crate) fn normal() -> Self {
        let mut rig = Self::new(Config::default());
        rig.configure(RXB0CTRL, 0x64);
        rig.configure(RXB1CTRL, 0x60);
        rig.write(CANINTE, &[0x23]);
        rig.mode(0b000);
        rig
    }

    /// Resets the chip's bit timing to 250 kbit/s and writes one register.
    pub(crate) fn configure(&mut self, address: u8, value: u8) {
        self.write(CNF3, &[CNF_250K[2], CNF_250K[1], CNF_250K[0]]);
        self.write(address, &[value]);
    }

    /// Requests a mode and waits until CANSTAT shows it.
    pub(crate) fn mode(&mut self, reqop: u8) {
        self.modify(CANCTRL, 0xE0, reqop << 5);
        for _ in 0..100 {
            if self.read(CANSTAT) >> 5 == reqop {
                return;
            }
            self.wait(BIT);
        }
        panic!("mode {reqop:03b} never came");
    }

    pub(crate) fn wait(&mut self, span: Nanos) {
        self.advance(self.now + span);
    }

    pub(crate) fn advance(&mut self, now: Nanos) {
        loop {
            let next = [self.bus.next_event(), self.chip.next_event()].into_iter().flatten().min();
            let Some(at) = next.filter(|&at| at <= now) else { break };
            self.chip.advance(at, &mut self.bus);
            while let Some(event) = self.bus.poll(at) {
                self.events.push(event);
                if let (true, EventKind::Received { frame }) = (event.node == self.peer, event.kind) {
                    self.heard.push((event.at, frame));
                }
                self.chip.on_bus(&event, &mut self.bus);
            }
        }
        self.now = now;
    }

    pub(crate) fn cs(&mut self, low: bool) {
        if low {
            self.wait(self.pause);
        }
        self.chip.select(self.now, low, &mut self.bus);
    }

    pub(crate) fn clock(&mut self, byte: u8) -> u8 {
        self.wait(self.byte);
        self.chip.exchange(self.now, byte, &mut self.bus)
    }

    /// One CS period.
    pub(crate) fn transaction(&mut self, bytes: &[u8]) -> Vec<u8> {
        self.cs(true);
        self.wait(Nanos(50));
        let replies = bytes.iter().map(|&byte| self.clock(byte)).collect();
        self.wait(Nanos(50));
        self.cs(false);
        replies
    }

    pub(crate) fn read(&mut self, address: u8) -> u8 {
        self.transaction(&[0x03, address, 0])[2]
    }

    pub(crate) fn write(&mut self, address: u8, values: &[u8]) {
        self.transaction(&[&[0x02, address], values].concat());
    }

    pub(crate) fn modify(&mut self, address: u8, mask: u8, value: u8) {
        self.transaction(&[0x05, address, mask, value]);
    }

    /// READ RX BUFFER n from SIDH: identifier registers, DLC, data.
    pub(crate) fn read_buffer(&mut self, buffer: u8) -> Vec<u8> {
        let mut bytes = [0; 14];
        bytes[0] = 0x90 | buffer << 2;
        self.transaction(&bytes)[1..].to_vec()
    }

    /// LOAD TX BUFFER n and RTS.
    pub(crate) fn send(&mut self, buffer: u8, registers: &[u8]) {
        self.load(buffer, registers);
        self.transaction(&[0x80 | 1 << buffer]);
    }

    pub(crate) fn load(&mut self, buffer: u8, registers: &[u8]) {
        self.transaction(&[&[0x40 | buffer << 1], registers].concat());
    }

    /// The peer sends a frame now, and time goes on until it has arrived.
    pub(crate) fn receive(&mut self, frame: Frame) {
        self.bus.request(self.peer, self.now, frame, Tag(0));
        self.wait(Nanos::from_millis(1));
    }

    pub(crate) fn no_violations(&self) {
        assert!(self.chip.violations().is_empty(), "{}", self.chip.violations());
    }
}

pub(crate) fn standard(raw: u16, payload: &[u8]) -> Frame {
    Frame::new(Id::standard(raw).unwrap(), payload).unwrap()
}

pub(crate) fn extended(raw: u32, payload: &[u8]) -> Frame {
    Frame::new(Id::extended(raw).unwrap(), payload).unwrap()
}

/// SIDH..DLC of a frame, as a transmit buffer wants them.
pub(crate) fn registers(frame: &Frame) -> Vec<u8> {
    let raw = frame.id.raw();
    let remote = if frame.remote { 0x40 } else { 0 };
    let head = match frame.id {
        Id::Standard(_) => [(raw >> 3) as u8, (raw << 5) as u8, 0, 0],
        Id::Extended(_) => [
            (raw >> 21) as u8,
            (raw >> 18 << 5) as u8 | 0x08 | (raw >> 16 & 3) as u8,
            (raw >> 8) as u8,
            raw as u8,
        ],
    };
    [&head[..], &[frame.dlc | remote], frame.payload()].concat()
}

/// A rig that drivers and tests share.
#[derive(Clone)]
pub(crate) struct Shared(pub(crate) Rc<RefCell<Rig>>);

impl Shared {
    pub(crate) fn new(rig: Rig) -> Self {
        Self(Rc::new(RefCell::new(rig)))
    }
}

impl ErrorType for Shared {
    type Error = Infallible;
}

impl SpiDevice for Shared {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let mut rig = self.0.borrow_mut();
        rig.cs(true);
        rig.wait(Nanos(50));
        for operation in operations {
            match operation {
                Operation::Read(bytes) => bytes.iter_mut().for_each(|byte| *byte = rig.clock(0)),
                Operation::Write(bytes) => bytes.iter().for_each(|&byte| {
                    rig.clock(byte);
                }),
                Operation::Transfer(read, write) => {
                    for index in 0..read.len().max(write.len()) {
                        let reply = rig.clock(write.get(index).copied().unwrap_or(0));
                        if let Some(slot) = read.get_mut(index) {
                            *slot = reply;
                        }
                    }
                }
                Operation::TransferInPlace(bytes) => {
                    bytes.iter_mut().for_each(|byte| *byte = rig.clock(*byte));
                }
                Operation::DelayNs(ns) => rig.wait(Nanos(u64::from(*ns))),
            }
        }
        rig.wait(Nanos(50));
        rig.cs(false);
        Ok(())
    }
}

/// Delays in the rig's virtual time.
impl embedded_hal::delay::DelayNs for Shared {
    fn delay_ns(&mut self, ns: u32) {
        self.0.borrow_mut().wait(Nanos(u64::from(ns)));
    }
}
