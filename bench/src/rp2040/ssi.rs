//! SSI: the serial controller between the XIP cache and the flash chip.
//!
//! Owns the registers that a second stage programs, the clocks that an XIP read takes with them, and the serial mode in
//! which firmware talks to the flash chip directly. Chip select falls with the first frame and rises when the last one
//! is over, unless IO_QSPI forces it.
//!
//! Source: RP2040 datasheet 4.10.
//!
//! Not modelled: DDR, interrupts and DMA, FIFO thresholds, frames that are not whole bytes.

use std::collections::VecDeque;

use super::nor::Nor;
use crate::flash::Cells;

/// Registers, what has been received, and until when the last frame lasts.
#[derive(Clone, Debug)]
pub(super) struct Ssi {
    pub(super) ctrlr0: u32,
    pub(super) ctrlr1: u32,
    pub(super) ssienr: u32,
    pub(super) ser: u32,
    pub(super) baudr: u32,
    pub(super) spi_ctrlr0: u32,
    rx_sample_dly: u32,
    plain: [u32; 3],
    received: VecDeque<(u64, u32)>,
    control: Vec<u32>,
    pub(super) busy_until: u64,
    pub(super) select_forced: Option<bool>,
}

impl Ssi {
    pub(super) fn new() -> Self {
        Self {
            ctrlr0: 0,
            ctrlr1: 0,
            ssienr: 0,
            ser: 0,
            baudr: 0,
            spi_ctrlr0: 0x0300_0000,
            rx_sample_dly: 0,
            plain: [0; 3],
            received: VecDeque::new(),
            control: Vec::new(),
            busy_until: 0,
            select_forced: None,
        }
    }

    /// As the boot ROM leaves it for commands: byte frames, /6, chip select forced high.
    pub(super) fn serial() -> Self {
        Self { baudr: 6, ctrlr0: 7 << 16, ser: 1, ssienr: 1, select_forced: Some(true), ..Self::new() }
    }

    pub(super) fn divisor(&self) -> u32 {
        self.baudr & 0xfffe
    }

    pub(super) fn transfer_mode(&self) -> u32 {
        self.ctrlr0 >> 8 & 3
    }

    pub(super) fn lanes(&self) -> u32 {
        1 << (self.ctrlr0 >> 21 & 3)
    }

    pub(super) fn frame_bits(&self) -> u32 {
        (self.ctrlr0 >> 16 & 0x1f) + 1
    }

    pub(super) fn is_xip(&self) -> bool {
        self.ssienr & 1 != 0 && self.transfer_mode() == 3 && self.frame_bits() == 32 && self.divisor() != 0
    }

    pub(super) fn instruction_bits(&self) -> u32 {
        [0, 4, 8, 16][(self.spi_ctrlr0 >> 8 & 3) as usize]
    }

    pub(super) fn sends_no_command(&self) -> bool {
        self.instruction_bits() == 0
    }

    /// SCK clocks of one read of `data_bits`.
    pub(super) fn sck_clocks(&self, data_bits: u32) -> u32 {
        let lanes = self.lanes();
        let (instruction_lanes, address_lanes) = match self.spi_ctrlr0 & 3 {
            0 => (1, 1),
            1 => (1, lanes),
            _ => (lanes, lanes),
        };
        let address_bits = (self.spi_ctrlr0 >> 2 & 0xf) * 4;
        let wait = self.spi_ctrlr0 >> 11 & 0x1f;
        self.instruction_bits() / instruction_lanes + address_bits / address_lanes + wait + data_bits / lanes
    }

    pub(super) fn is_busy(&self, now: u64) -> bool {
        now < self.busy_until
    }

    pub(super) fn read(&mut self, offset: u32, now: u64) -> Option<u32> {
        let ready = self.received.iter().take_while(|(at, _)| *at <= now).count();
        let level = u32::try_from(ready).unwrap_or(u32::MAX);
        Some(match offset {
            0x00 => self.ctrlr0,
            0x04 => self.ctrlr1,
            0x08 => self.ssienr,
            0x0c | 0x2c..=0x4c => 0,
            0x10 => self.ser,
            0x14 => self.baudr,
            0x18 => self.plain[0],
            0x1c => self.plain[1],
            0x20 => 0,
            0x24 => level,
            // TFNF always; TFE once the last frame has left the FIFO for the wire, which is when it is over here.
            0x28 => {
                let busy = self.is_busy(now);
                2 | u32::from(busy) | if busy { 0 } else { 4 } | if ready > 0 { 8 } else { 0 }
            }
            0x50 | 0x54 => 0,
            0x58 => 0x5153_5049,
            0x5c => 0x3430_312a,
            0x60..=0xec => {
                if ready > 0 {
                    self.received.pop_front().map_or(0, |(_, word)| word)
                } else {
                    0
                }
            }
            0xf0 => self.rx_sample_dly,
            0xf4 => self.spi_ctrlr0,
            0xf8 => self.plain[2],
            _ => return None,
        })
    }

    pub(super) fn write(
        &mut self,
        offset: u32,
        value: u32,
        now: u64,
        nor: &mut Nor,
        cells: &mut Cells,
    ) -> Option<()> {
        match offset {
            0x00 => self.ctrlr0 = value,
            0x04 => self.ctrlr1 = value & 0xffff,
            0x08 => {
                self.ssienr = value & 1;
                if value & 1 == 0 {
                    self.received.clear();
                    self.control.clear();
                }
            }
            0x10 => self.ser = value & 1,
            0x14 => self.baudr = value & 0xffff,
            0x18 => self.plain[0] = value,
            0x1c => self.plain[1] = value,
            0x2c..=0x34 | 0x4c => {
                if value != 0 && offset != 0x2c {
                    return None;
                }
            }
            0x60..=0xec => self.transmit(value, now, nor, cells),
            0xf0 => self.rx_sample_dly = value,
            0xf4 => self.spi_ctrlr0 = value,
            0xf8 => self.plain[2] = value,
            _ => return None,
        }
        Some(())
    }

    pub(super) fn transmit(&mut self, value: u32, now: u64, nor: &mut Nor, cells: &mut Cells) {
        if self.ssienr & 1 == 0 || self.ser & 1 == 0 {
            return;
        }
        let start = now.max(self.busy_until);
        let sck = u64::from(self.divisor());
        if self.transfer_mode() != 3 {
            let bits = self.frame_bits().min(32);
            self.busy_until = start + u64::from(bits) * sck;
            let mut word = 0;
            for byte in (0..bits / 8).rev() {
                word = word << 8 | u32::from(nor.exchange((value >> (8 * byte)) as u8, cells, start));
            }
            if self.transfer_mode() != 1 && self.received.len() < 16 {
                self.received.push_back((self.busy_until, word));
            }
            return;
        }
        // EEPROM read: instruction, then address and mode bits, then NDF + 1 frames come back.
        self.control.push(value);
        let wanted = usize::from(self.instruction_bits() != 0) + 1;
        if self.control.len() < wanted {
            return;
        }
        let instruction = if wanted == 2 { self.control[0] } else { 0xeb };
        let address_and_mode = value;
        self.control.clear();
        let frames = self.ctrlr1 + 1;
        self.busy_until = start + u64::from(self.sck_clocks(frames * self.frame_bits())) * sck;
        if instruction == 0xeb {
            nor.continuous = address_and_mode >> 4 & 0xf == 0xa;
        }
        let address = (address_and_mode >> 8) as usize;
        for frame in 0..frames.min(16) as usize {
            let word = (0..4).fold(0, |word, i| {
                word << 8 | u32::from(cells.read((address + 4 * frame + i) % cells.bytes().len()))
            });
            self.received.push_back((self.busy_until, word));
        }
    }
}
