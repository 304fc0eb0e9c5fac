//! SPI0 and SPI1: the PL022 as Motorola-format master, with exact frame times.
//!
//! A frame takes `bits` SCK periods of clk_peri / (CPSDVSR * (1 + SCR)). With SPH = 0 the PL022 raises its frame signal
//! between frames, which costs [`GAP_BITS`] SCK periods; with SPH = 1 the clock runs through. The word is exchanged
//! with the board at the end of its last bit.
//!
//! Source: ARM DDI 0194 (PL022), RP2040 datasheet 4.4; the gap: raspberrypi/pico-examples issue 285.
//!
//! Not modelled: slave mode, TI and Microwire formats (errors), the levels of SCK, TX and CSn as pins.

use super::fifo::Fifo;

const NEVER: u64 = u64::MAX;
/// SCK periods between frames when SPH = 0.
const GAP_BITS: u64 = 2;
/// SCK periods of silence after which unread data raises the receive timeout.
const TIMEOUT_BITS: u64 = 32;
/// Times inside a frame are kept in 1/256 cycles of clk_sys.
const FINE: u32 = 8;

const CR1_LOOPBACK: u32 = 1 << 0;
const CR1_ENABLE: u32 = 1 << 1;
const CR1_SLAVE: u32 = 1 << 2;
const INT_OVERRUN: u32 = 1 << 0;
const INT_TIMEOUT: u32 = 1 << 1;
const INT_RX: u32 = 1 << 2;
const INT_TX: u32 = 1 << 3;
const DMA_RX: u32 = 1 << 0;
const DMA_TX: u32 = 1 << 1;
const IDENTIFICATION: [u32; 8] = [0x22, 0x10, 0x34, 0x00, 0x0d, 0xf0, 0x05, 0xb1];

/// A frame whose last bit has been clocked.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) word: u16,
    pub(super) bits: u8,
    pub(super) loopback: bool,
}

#[derive(Clone, Debug)]
pub(super) struct Spi {
    cr0: u32,
    cr1: u32,
    cpsr: u32,
    imsc: u32,
    latched: u32,
    dmacr: u32,
    tx: Fifo<8>,
    rx: Fifo<8>,
    shifting: Option<u16>,
    frame_end: u64,
    free_at: u64,
    frame_fine: u64,
    gap_fine: u64,
    bit_fine: u64,
    clocks: (u64, u64),
    /// The cycle at which the engine has to look at this port.
    pub(super) next_event: u64,
    timeout_at: u64,
    /// Frames that the engine may leave unserved, because nobody can see the difference.
    lag: u32,
}

impl Spi {
    pub(super) fn new(sys_hz: u64, peri_hz: u64) -> Self {
        let mut spi = Self {
            cr0: 0,
            cr1: 0,
            cpsr: 0,
            imsc: 0,
            latched: 0,
            dmacr: 0,
            tx: Fifo::new(),
            rx: Fifo::new(),
            shifting: None,
            frame_end: 0,
            free_at: 0,
            frame_fine: 0,
            gap_fine: 0,
            bit_fine: 0,
            clocks: (sys_hz, peri_hz),
            next_event: NEVER,
            timeout_at: NEVER,
            lag: 0,
        };
        spi.derive();
        spi
    }

    /// clk_sys or clk_peri has changed; a frame on the wire keeps its end.
    pub(super) fn set_clocks(&mut self, sys_hz: u64, peri_hz: u64) {
        self.clocks = (sys_hz, peri_hz);
        self.derive();
    }

    fn derive(&mut self) {
        let (sys, peri) = self.clocks;
        let divisor = u64::from(self.cpsr & 0xfe) * (1 + u64::from(self.cr0 >> 8 & 0xff));
        self.bit_fine = ((sys << FINE) * divisor).checked_div(peri).unwrap_or(0);
        self.frame_fine = self.bit_fine * u64::from(self.bits());
        self.gap_fine = if self.cr0 & 1 << 7 == 0 { GAP_BITS * self.bit_fine } else { 0 };
    }

    fn bits(&self) -> u8 {
        (self.cr0 & 0xf) as u8 + 1
    }

    fn is_running(&self) -> bool {
        self.cr1 & CR1_ENABLE != 0 && self.bit_fine != 0
    }

    /// Cycle of the frame's end (rounded up), if one is on the wire.
    #[inline]
    pub(super) fn frame_end(&self) -> Option<u64> {
        self.shifting.map(|_| (self.frame_end + (1 << FINE) - 1) >> FINE)
    }

    fn schedule(&mut self) {
        self.next_event = if self.shifting.is_some() {
            let lag = u64::from(self.lag) * (self.frame_fine + self.gap_fine);
            (self.frame_end + lag + (1 << FINE) - 1) >> FINE
        } else {
            self.timeout_at
        };
    }

    /// Lets the engine serve up to `frames` frames late; 0 = each at its end.
    pub(super) fn set_lag(&mut self, frames: u32) {
        self.lag = frames;
        self.schedule();
    }

    /// Whether nothing but DMA and the board could see when a frame ends.
    pub(super) fn is_unwatched(&self) -> bool {
        self.imsc == 0 && self.cr1 & CR1_LOOPBACK == 0 && self.shifting.is_some()
    }

    /// Puts the next word on the wire if nothing is there.
    #[inline]
    pub(super) fn start(&mut self, now: u64) {
        if self.shifting.is_none() && self.is_running() {
            self.shifting = self.tx.pop();
            if self.shifting.is_some() {
                self.frame_end = self.free_at.max(now << FINE) + self.frame_fine;
            }
        }
        self.schedule();
    }

    /// The frame that ends at [`Self::frame_end`].
    #[inline]
    pub(super) fn frame(&self) -> Frame {
        let mask = (1u32 << self.bits()) - 1;
        let word = self.shifting.unwrap_or(0) & mask as u16;
        Frame { word, bits: self.bits(), loopback: self.cr1 & CR1_LOOPBACK != 0 }
    }

    /// Ends the frame with `received` on MISO and starts the next one.
    #[inline]
    pub(super) fn finish_frame(&mut self, received: u16) {
        let mask = (1u32 << self.bits()) - 1;
        let received = received & mask as u16;
        if !self.rx.push(received) {
            self.latched |= INT_OVERRUN;
        }
        self.shifting = None;
        self.free_at = self.frame_end + self.gap_fine;
        self.timeout_at = (self.frame_end + TIMEOUT_BITS * self.bit_fine) >> FINE;
        self.start(self.frame_end >> FINE);
    }

    /// Raises the receive timeout if it is due.
    pub(super) fn expire(&mut self, now: u64) {
        if now >= self.timeout_at {
            self.timeout_at = NEVER;
            if !self.rx.is_empty() {
                self.latched |= INT_TIMEOUT;
            }
            self.schedule();
        }
    }

    fn raw(&self) -> u32 {
        self.latched
            | if self.rx.len() >= 4 { INT_RX } else { 0 }
            | if self.tx.len() <= 4 { INT_TX } else { 0 }
    }

    #[inline]
    pub(super) fn irq(&self) -> bool {
        self.imsc != 0 && self.raw() & self.imsc != 0
    }

    /// Entries that TX DMA may write now.
    #[inline]
    pub(super) fn tx_requests(&self) -> u32 {
        if self.dmacr & DMA_TX != 0 && !self.tx.is_full() { 1 } else { 0 }
    }

    /// Entries that RX DMA may read now.
    #[inline]
    pub(super) fn rx_requests(&self) -> u32 {
        if self.dmacr & DMA_RX != 0 && !self.rx.is_empty() { 1 } else { 0 }
    }

    /// Writes the data register.
    #[inline]
    pub(super) fn write_data(&mut self, word: u16, now: u64) {
        // A write to a full FIFO is lost, as on the chip.
        self.tx.push(word);
        if self.shifting.is_none() {
            self.start(now);
        }
    }

    /// Reads the data register.
    pub(super) fn read_data(&mut self) -> u32 {
        let word = self.rx.pop().unwrap_or(0);
        if self.rx.is_empty() {
            self.latched &= !INT_TIMEOUT;
        }
        u32::from(word)
    }

    pub(super) fn read(&mut self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x00 => self.cr0,
            0x04 => self.cr1,
            0x08 => self.read_data(),
            0x0c => {
                u32::from(self.tx.is_empty())
                    | u32::from(!self.tx.is_full()) << 1
                    | u32::from(!self.rx.is_empty()) << 2
                    | u32::from(self.rx.is_full()) << 3
                    | u32::from(self.shifting.is_some() || !self.tx.is_empty()) << 4
            }
            0x10 => self.cpsr,
            0x14 => self.imsc,
            0x18 => self.raw(),
            0x1c => self.raw() & self.imsc,
            0x20 => 0,
            0x24 => self.dmacr,
            0xfe0..=0xffc => IDENTIFICATION[(offset as usize - 0xfe0) / 4],
            _ => return None,
        })
    }

    pub(super) fn write(&mut self, offset: u32, value: u32, now: u64) -> Option<()> {
        match offset {
            0x00 if value & 0x30 == 0 => self.cr0 = value & 0xffff,
            0x04 if value & CR1_SLAVE == 0 => self.cr1 = value & 0xf,
            0x08 => self.write_data((value & 0xffff) as u16, now),
            0x0c | 0x18 | 0x1c => {}
            0x10 => self.cpsr = value & 0xff,
            0x14 => self.imsc = value & 0xf,
            0x20 => self.latched &= !value,
            0x24 => self.dmacr = value & 3,
            _ => return None,
        }
        if matches!(offset, 0x00 | 0x04 | 0x10) {
            self.derive();
            self.start(now);
        }
        Some(())
    }
}
