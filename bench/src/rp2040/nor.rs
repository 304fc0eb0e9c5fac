//! The flash chip in serial mode: identification, status, read, and small writes.
//!
//! A command is what is exchanged while chip select is low; writes take effect when it rises. Reads by XIP do not come
//! through here.
//!
//! Source: W25Q16JV datasheet 7.1 (status registers), 8.2 (instructions).
//!
//! Not modelled: block protection, suspend, security registers, 64 KiB erase and chip erase by command. Unknown
//! instructions answer 0xFF and do nothing, as on the chip. Write times do not depend on the instruction.

/// Sector erase granularity, in bytes.
pub(super) const SECTOR_BYTES: u32 = 4096;
/// Page program granularity, in bytes.
pub(super) const PAGE_BYTES: u32 = 256;

/// The flash chip behind the SSI's serial mode.
#[derive(Clone, Debug)]
pub(super) struct Nor {
    command: Vec<u8>,
    status: [u8; 3],
    write_enabled: bool,
    busy_until: u64,
    /// Continuous read mode: reads come without an instruction.
    pub(super) continuous: bool,
}

impl Nor {
    const JEDEC_ID: [u8; 3] = [0xef, 0x40, 0x15]; // Winbond, SPI NOR, 16 Mbit
    const UNIQUE_ID: [u8; 8] = [0xe6, 0x61, 0x38, 0x52, 0x83, 0x00, 0x20, 0x40];
    const STATUS_WRITE_CYCLES: u64 = 65_000; // 10 ms at the ring oscillator's 6.5 MHz

    pub(super) fn new() -> Self {
        // Quad enable is non-volatile: a board that has booted once has it.
        Self {
            command: Vec::new(),
            status: [0, 2, 0],
            write_enabled: false,
            busy_until: 0,
            continuous: false,
        }
    }

    pub(super) fn exchange(&mut self, byte: u8, flash: &[u8], now: u64) -> u8 {
        let index = self.command.len();
        if self.command.len() < 4 + PAGE_BYTES as usize {
            self.command.push(byte);
        }
        if index == 0 || self.continuous {
            return 0xff;
        }
        let address = |skip: usize| {
            let base = self.command[1..4].iter().fold(0, |address, byte| address << 8 | usize::from(*byte));
            flash[(base + index - skip) % flash.len()]
        };
        match self.command[0] {
            0x05 => self.status[0] | u8::from(self.write_enabled) << 1 | u8::from(now < self.busy_until),
            0x35 => self.status[1],
            0x15 => self.status[2],
            0x9f => Self::JEDEC_ID[(index - 1) % 3],
            0x4b if index >= 5 => Self::UNIQUE_ID[(index - 5) % 8],
            0x90 if index >= 4 => [0xef, 0x14][index % 2],
            0xab if index >= 4 => 0x14,
            0x03 if index >= 4 => address(4),
            0x0b if index >= 5 => address(5),
            _ => 0xff,
        }
    }

    pub(super) fn deselect(&mut self, flash: &mut [u8], now: u64) {
        let command = std::mem::take(&mut self.command);
        let Some((instruction, rest)) = command.split_first() else { return };
        if self.continuous {
            // Mode bits of all ones end continuous read mode.
            self.continuous = command.iter().any(|byte| *byte != 0xff);
            return;
        }
        let address =
            rest.iter().take(3).fold(0, |address, byte| address << 8 | usize::from(*byte)) % flash.len();
        match (*instruction, self.write_enabled) {
            (0x06 | 0x50, _) => self.write_enabled = true,
            (0x04, _) => self.write_enabled = false,
            (0x01, true) => {
                for (register, value) in self.status.iter_mut().zip(rest) {
                    *register = *value;
                }
                self.status[0] &= !3; // BUSY and WEL are not storage
                self.finish_write(now, Self::STATUS_WRITE_CYCLES);
            }
            (0x31, true) => {
                self.status[1] = rest.first().copied().unwrap_or(0);
                self.finish_write(now, Self::STATUS_WRITE_CYCLES);
            }
            (0x02, true) if rest.len() > 3 => {
                let page = address & !(PAGE_BYTES as usize - 1);
                for (i, byte) in rest[3..].iter().enumerate() {
                    flash[page + (address + i) % PAGE_BYTES as usize] &= byte;
                }
                self.finish_write(now, Self::STATUS_WRITE_CYCLES);
            }
            (0x20, true) if rest.len() >= 3 => {
                let sector = address & !(SECTOR_BYTES as usize - 1);
                flash[sector..sector + SECTOR_BYTES as usize].fill(0xff);
                self.finish_write(now, Self::STATUS_WRITE_CYCLES);
            }
            _ => {}
        }
    }

    pub(super) fn finish_write(&mut self, now: u64, cycles: u64) {
        self.write_enabled = false;
        self.busy_until = now + cycles;
    }
}
