//! UART0 and UART1: the PL011 with 32-byte FIFOs and exact byte times.
//!
//! A byte takes start, data, parity and stop bits at clk_peri / (16 * divisor). Bytes from outside are queued and arrive
//! back to back at the same rate; what does not fit the receive FIFO is lost and counted as overrun.
//!
//! Source: ARM DDI 0183 (PL011), RP2040 datasheet 4.2.
//!
//! Not modelled: modem lines and flow control, break, framing and parity errors, IrDA, levels on the pins.

use super::fifo::Fifo;
use std::collections::VecDeque;

const NEVER: u64 = u64::MAX;
const FR_BUSY: u32 = 1 << 3;
const FR_RXFE: u32 = 1 << 4;
const FR_TXFF: u32 = 1 << 5;
const FR_RXFF: u32 = 1 << 6;
const FR_TXFE: u32 = 1 << 7;
const CR_ENABLE: u32 = 1 << 0;
const CR_LOOPBACK: u32 = 1 << 7;
const CR_TXE: u32 = 1 << 8;
const CR_RXE: u32 = 1 << 9;
const INT_RX: u32 = 1 << 4;
const INT_TX: u32 = 1 << 5;
const INT_RT: u32 = 1 << 6;
const INT_OE: u32 = 1 << 10;
const DATA_OVERRUN: u16 = 1 << 11;
const LCR_FIFOS: u32 = 1 << 4;
/// Bit periods of silence after which unread data raises the receive timeout.
const TIMEOUT_BITS: u64 = 32;
const IDENTIFICATION: [u32; 8] = [0x11, 0x10, 0x34, 0x00, 0x0d, 0xf0, 0x05, 0xb1];

#[derive(Clone, Debug)]
pub(super) struct Uart {
    ibrd: u32,
    fbrd: u32,
    lcr: u32,
    cr: u32,
    ifls: u32,
    imsc: u32,
    latched: u32,
    dmacr: u32,
    errors: u32,
    ilpr: u32,
    tx: Fifo<32>,
    rx: Fifo<32>,
    overrun: bool,
    shifting: Option<u8>,
    sent_at: u64,
    outside: VecDeque<u8>,
    arrives_at: u64,
    timeout_at: u64,
    clocks: (u64, u64),
    pub(super) next_event: u64,
}

impl Uart {
    pub(super) fn new(sys_hz: u64, peri_hz: u64) -> Self {
        Self {
            ibrd: 0,
            fbrd: 0,
            lcr: 0,
            cr: CR_TXE | CR_RXE,
            ifls: 0x12,
            imsc: 0,
            latched: 0,
            dmacr: 0,
            errors: 0,
            ilpr: 0,
            tx: Fifo::new(),
            rx: Fifo::new(),
            overrun: false,
            shifting: None,
            sent_at: NEVER,
            outside: VecDeque::new(),
            arrives_at: NEVER,
            timeout_at: NEVER,
            clocks: (sys_hz, peri_hz),
            next_event: NEVER,
        }
    }

    pub(super) fn set_clocks(&mut self, sys_hz: u64, peri_hz: u64) {
        self.clocks = (sys_hz, peri_hz);
    }

    fn depth(&self) -> usize {
        if self.lcr & LCR_FIFOS != 0 { 32 } else { 1 }
    }

    /// Cycles of `bits` bit periods, `None` while the baud rate generator does not run.
    fn cycles_of(&self, bits: u64) -> Option<u64> {
        let (sys, peri) = self.clocks;
        let divisor = u64::from(self.ibrd & 0xffff) * 64 + u64::from(self.fbrd & 0x3f); // in 1/64
        if divisor == 0 || self.cr & CR_ENABLE == 0 {
            return None;
        }
        (sys * bits * 16 * divisor).checked_div(peri * 64)
    }

    fn frame_bits(&self) -> u64 {
        let data = 5 + u64::from(self.lcr >> 5 & 3);
        let parity = u64::from(self.lcr >> 1 & 1);
        let stop = 1 + u64::from(self.lcr >> 3 & 1);
        1 + data + parity + stop
    }

    fn level(&self, selector: u32) -> usize {
        match (self.lcr & LCR_FIFOS != 0, selector & 7) {
            (false, _) => 1,
            (true, 0) => 4,
            (true, 1) => 8,
            (true, 2) => 16,
            (true, 3) => 24,
            (true, _) => 28,
        }
    }

    fn schedule(&mut self) {
        self.next_event = self.sent_at.min(self.arrives_at).min(self.timeout_at);
    }

    fn start(&mut self, now: u64) {
        if self.shifting.is_none()
            && self.cr & CR_TXE != 0
            && !self.tx.is_empty()
            && let Some(cycles) = self.cycles_of(self.frame_bits())
        {
            let before = self.tx.len();
            self.shifting = self.tx.pop().map(|word| (word & 0xff) as u8);
            self.sent_at = now + cycles;
            // The transmit interrupt marks the level falling through its trigger, not the level.
            let trigger = if self.lcr & LCR_FIFOS != 0 { 32 - self.level_tx() } else { 0 };
            if before > trigger && self.tx.len() <= trigger {
                self.latched |= INT_TX;
            }
        }
        self.schedule();
    }

    fn level_tx(&self) -> usize {
        match self.ifls & 7 {
            0 => 28,
            1 => 24,
            2 => 16,
            3 => 8,
            _ => 4,
        }
    }

    /// The cycle at which the byte on the wire has been sent.
    pub(super) fn sent_at(&self) -> u64 {
        self.sent_at
    }

    /// Takes the byte whose stop bit ends at [`Self::sent_at`].
    pub(super) fn finish_byte(&mut self) -> Option<u8> {
        let byte = self.shifting.take()?;
        let end = self.sent_at;
        self.sent_at = NEVER;
        self.start(end);
        if self.cr & CR_LOOPBACK != 0 {
            self.receive(byte, end);
            self.schedule();
            return None;
        }
        Some(byte)
    }

    /// Queues bytes that the outside sends.
    pub(super) fn queue(&mut self, bytes: &[u8], now: u64) {
        self.outside.extend(bytes);
        self.start_arrival(now);
        self.schedule();
    }

    fn start_arrival(&mut self, now: u64) {
        if self.arrives_at == NEVER && !self.outside.is_empty() {
            match self.cycles_of(self.frame_bits()) {
                Some(cycles) => self.arrives_at = now + cycles,
                // Nobody listens: the bytes pass by.
                None => self.outside.clear(),
            }
        }
    }

    /// Handles arrivals and timeouts that are due.
    pub(super) fn advance(&mut self, now: u64) {
        while self.arrives_at <= now {
            let at = self.arrives_at;
            self.arrives_at = NEVER;
            if let Some(byte) = self.outside.pop_front()
                && self.cr & CR_RXE != 0
            {
                self.receive(byte, at);
            }
            self.start_arrival(at);
        }
        if self.timeout_at <= now {
            self.timeout_at = NEVER;
            if !self.rx.is_empty() {
                self.latched |= INT_RT;
            }
        }
        self.schedule();
    }

    fn receive(&mut self, byte: u8, at: u64) {
        if self.rx.len() >= self.depth() {
            self.latched |= INT_OE;
            self.errors |= 8;
            self.overrun = true;
            return;
        }
        let flags = if std::mem::take(&mut self.overrun) { DATA_OVERRUN } else { 0 };
        self.rx.push(u16::from(byte) | flags);
        if self.rx.len() >= self.level(self.ifls >> 3) {
            self.latched |= INT_RX;
        }
        self.timeout_at = self.cycles_of(TIMEOUT_BITS).map_or(NEVER, |cycles| at + cycles);
    }

    pub(super) fn irq(&self) -> bool {
        self.latched & self.imsc != 0
    }

    pub(super) fn tx_requests(&self) -> u32 {
        u32::from(self.dmacr & 2 != 0 && self.tx.len() < self.depth())
    }

    pub(super) fn rx_requests(&self) -> u32 {
        u32::from(self.dmacr & 1 != 0 && !self.rx.is_empty())
    }

    pub(super) fn read_data(&mut self) -> u32 {
        let word = self.rx.pop().unwrap_or(0);
        if self.rx.len() < self.level(self.ifls >> 3) {
            self.latched &= !INT_RX;
        }
        if self.rx.is_empty() {
            self.latched &= !INT_RT;
            self.timeout_at = NEVER;
            self.schedule();
        }
        u32::from(word)
    }

    pub(super) fn write_data(&mut self, byte: u32, now: u64) {
        if self.tx.len() < self.depth() {
            self.tx.push((byte & 0xff) as u16);
        }
        let trigger = if self.lcr & LCR_FIFOS != 0 { 32 - self.level_tx() } else { 0 };
        if self.tx.len() > trigger {
            self.latched &= !INT_TX;
        }
        self.start(now);
    }

    pub(super) fn read(&mut self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x00 => self.read_data(),
            0x04 => self.errors,
            0x18 => {
                let flag = |set: bool, bit: u32| if set { bit } else { 0 };
                flag(self.shifting.is_some() || !self.tx.is_empty(), FR_BUSY)
                    | flag(self.rx.is_empty(), FR_RXFE)
                    | flag(self.tx.len() >= self.depth(), FR_TXFF)
                    | flag(self.rx.len() >= self.depth(), FR_RXFF)
                    | flag(self.tx.is_empty(), FR_TXFE)
            }
            0x20 => self.ilpr,
            0x24 => self.ibrd,
            0x28 => self.fbrd,
            0x2c => self.lcr,
            0x30 => self.cr,
            0x34 => self.ifls,
            0x38 => self.imsc,
            0x3c => self.latched,
            0x40 => self.latched & self.imsc,
            0x44 => 0,
            0x48 => self.dmacr,
            0xfe0..=0xffc => IDENTIFICATION[(offset as usize - 0xfe0) / 4],
            _ => return None,
        })
    }

    pub(super) fn write(&mut self, offset: u32, value: u32, now: u64) -> Option<()> {
        match offset {
            0x00 => self.write_data(value, now),
            0x04 => self.errors = 0,
            0x18 | 0x3c | 0x40 => {}
            0x20 => self.ilpr = value & 0xff,
            0x24 => self.ibrd = value & 0xffff,
            0x28 => self.fbrd = value & 0x3f,
            0x2c => self.lcr = value & 0xff,
            0x30 => {
                self.cr = value & 0xff87;
                self.start(now);
            }
            0x34 => self.ifls = value & 0x3f,
            0x38 => self.imsc = value & 0x7ff,
            0x44 => self.latched &= !value,
            0x48 => self.dmacr = value & 7,
            _ => return None,
        }
        Some(())
    }
}
