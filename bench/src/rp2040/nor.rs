//! The flash chip in serial mode: identification, status, read, and small writes.
//!
//! A command is what is exchanged while chip select is low; writes begin when it rises and take effect at their end,
//! during which the chip answers only its status and erase suspend. Reads by XIP do not come through here.
//!
//! Source: W25Q16JV datasheet 7.1 (status registers), 8.2 (instructions, suspend 8.2.16), 9.6 (times).
//!
//! Not modelled: block protection, security registers, 64 KiB erase and chip erase by command, writes while an erase is
//! suspended (ignored). Unknown instructions answer 0xFF and do nothing, as on the chip.

use crate::flash::{Cells, PAGE_BYTES, SECTOR_BYTES, Work};
use crate::time::Nanos;

/// How long the flash chip takes for what (W25Q16JV datasheet 9.6).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlashTimes {
    /// Page program, tPP.
    pub page_program: Nanos,
    /// Sector erase, tSE.
    pub sector_erase: Nanos,
    /// Erase of 64 KiB, tBE2.
    pub block_erase: Nanos,
    /// Write of a status register, tW.
    pub status_write: Nanos,
    /// From erase suspend to ready, tSUS.
    pub suspend: Nanos,
}

impl FlashTimes {
    /// The datasheet's typical times.
    pub const TYPICAL: Self = Self {
        page_program: Nanos::from_micros(400),
        sector_erase: Nanos::from_millis(45),
        block_erase: Nanos::from_millis(150),
        status_write: Nanos::from_millis(10),
        suspend: Nanos::from_micros(20),
    };
    /// The datasheet's longest times.
    pub const WORST: Self = Self {
        page_program: Nanos::from_millis(3),
        sector_erase: Nanos::from_millis(400),
        block_erase: Nanos::from_millis(2_000),
        status_write: Nanos::from_millis(15),
        suspend: Nanos::from_micros(20),
    };
}

/// Status register 2: an erase is suspended.
const SUS: u8 = 0x80;

/// A write under way.
#[derive(Clone, Debug)]
struct Job {
    work: Work,
    /// Its whole length, in cycles.
    total: u64,
    /// When it ends if nothing suspends it, in cycles.
    done: u64,
    /// It is suspended with so many cycles to go.
    left: Option<u64>,
}

/// The flash chip behind the SSI's serial mode.
#[derive(Clone, Debug)]
pub(super) struct Nor {
    command: Vec<u8>,
    status: [u8; 3],
    write_enabled: bool,
    busy_until: u64,
    job: Option<Job>,
    times: FlashTimes,
    /// clk_sys in hertz.
    hz: u64,
    /// Continuous read mode: reads come without an instruction.
    pub(super) continuous: bool,
}

impl Nor {
    const JEDEC_ID: [u8; 3] = [0xef, 0x40, 0x15]; // Winbond, SPI NOR, 16 Mbit
    const UNIQUE_ID: [u8; 8] = [0xe6, 0x61, 0x38, 0x52, 0x83, 0x00, 0x20, 0x40];

    pub(super) fn new(hz: u64) -> Self {
        // Quad enable is non-volatile: a board that has booted once has it.
        Self {
            command: Vec::new(),
            status: [0, 2, 0],
            write_enabled: false,
            busy_until: 0,
            job: None,
            times: FlashTimes::TYPICAL,
            hz,
            continuous: false,
        }
    }

    /// The supply fails: what is under way stays as it is, all that is not in cells is lost.
    pub(super) fn cut_power(&mut self, cells: &mut Cells, now: u64) {
        self.settle(cells, now);
        if let Some(job) = self.job.take() {
            let left = job.left.unwrap_or(job.done.saturating_sub(now)).min(job.total);
            let reached = job.work.len() as u64 * (job.total - left) / job.total.max(1);
            cells.cut(&job.work, reached as usize);
        }
        *self = Self { status: [0, self.status[1] & !SUS, 0], times: self.times, ..Self::new(self.hz) };
    }

    pub(super) fn set_times(&mut self, times: FlashTimes) {
        self.times = times;
    }

    pub(super) fn set_hz(&mut self, hz: u64) {
        self.hz = hz;
    }

    pub(super) fn times(&self) -> FlashTimes {
        self.times
    }

    /// Begins a write that takes `time`.
    pub(super) fn begin(&mut self, work: Work, now: u64, time: Nanos) {
        let total = self.cycles(time).max(1);
        self.job = Some(Job { work, total, done: now + total, left: None });
        self.finish_write(now, total);
    }

    fn cycles(&self, time: Nanos) -> u64 {
        (u128::from(time.0) * u128::from(self.hz) / 1_000_000_000) as u64
    }

    /// Lets a write that has ended by `now` take effect.
    pub(super) fn settle(&mut self, cells: &mut Cells, now: u64) {
        if let Some(job) = self.job.take_if(|job| job.left.is_none() && job.done <= now) {
            cells.finish(&job.work);
        }
    }

    /// When the write under way ends; `None` = the chip may be read.
    pub(super) fn busy_until(&self, now: u64) -> Option<u64> {
        (now < self.busy_until).then_some(self.busy_until)
    }

    /// Whether a write has begun and not ended, suspended or not.
    pub(super) fn is_writing(&self) -> bool {
        self.job.is_some()
    }

    fn suspend(&mut self, now: u64) {
        let pause = self.cycles(self.times.suspend);
        if let Some(job) = &mut self.job
            && matches!(job.work, Work::Erase { .. })
            && job.left.is_none()
        {
            job.left = Some(job.done.saturating_sub(now));
            self.status[1] |= SUS;
            self.busy_until = now + pause;
        }
    }

    fn resume(&mut self, now: u64) {
        if let Some(job) = &mut self.job
            && let Some(left) = job.left.take()
        {
            job.done = now + left;
            self.busy_until = job.done;
            self.status[1] &= !SUS;
        }
    }

    pub(super) fn exchange(&mut self, byte: u8, cells: &mut Cells, now: u64) -> u8 {
        self.settle(cells, now);
        let index = self.command.len();
        if self.command.len() < 4 + PAGE_BYTES {
            self.command.push(byte);
        }
        if index == 0 || self.continuous {
            return 0xff;
        }
        let mut address = |skip: usize| {
            let base = self.command[1..4].iter().fold(0, |address, byte| address << 8 | usize::from(*byte));
            cells.read((base + index - skip) % cells.bytes().len())
        };
        match self.command[0] {
            0x05 => self.status[0] | u8::from(self.write_enabled) << 1 | u8::from(now < self.busy_until),
            0x35 => self.status[1],
            0x15 => self.status[2],
            _ if now < self.busy_until => 0xff,
            0x9f => Self::JEDEC_ID[(index - 1) % 3],
            0x4b if index >= 5 => Self::UNIQUE_ID[(index - 5) % 8],
            0x90 if index >= 4 => [0xef, 0x14][index % 2],
            0xab if index >= 4 => 0x14,
            0x03 if index >= 4 => address(4),
            0x0b if index >= 5 => address(5),
            _ => 0xff,
        }
    }

    pub(super) fn deselect(&mut self, cells: &mut Cells, now: u64) {
        self.settle(cells, now);
        let command = std::mem::take(&mut self.command);
        let Some((instruction, rest)) = command.split_first() else { return };
        if self.continuous {
            // Mode bits of all ones end continuous read mode.
            self.continuous = command.iter().any(|byte| *byte != 0xff);
            return;
        }
        if now < self.busy_until {
            if *instruction == 0x75 {
                self.suspend(now);
            }
            return;
        }
        let size = cells.bytes().len();
        let address = rest.iter().take(3).fold(0, |address, byte| address << 8 | usize::from(*byte)) % size;
        let may_write = self.write_enabled && self.job.is_none();
        match (*instruction, may_write) {
            (0x06 | 0x50, _) => self.write_enabled = true,
            (0x04, _) => self.write_enabled = false,
            (0x7a, _) => self.resume(now),
            (0x01, true) => {
                for (register, value) in self.status.iter_mut().zip(rest) {
                    *register = *value;
                }
                self.status[0] &= !3; // BUSY and WEL are not storage
                self.finish_write(now, self.cycles(self.times.status_write));
            }
            (0x31, true) => {
                self.status[1] = rest.first().copied().unwrap_or(0);
                self.finish_write(now, self.cycles(self.times.status_write));
            }
            (0x02, true) if rest.len() > 3 => {
                // Beyond the end of the page it goes on at its start.
                let page = address / PAGE_BYTES * PAGE_BYTES;
                let mut data = vec![0xff; PAGE_BYTES];
                for (i, byte) in rest[3..].iter().enumerate() {
                    data[(address + i) % PAGE_BYTES] = *byte;
                }
                self.begin(Work::Program { offset: page, data }, now, self.times.page_program);
            }
            (0x20, true) if rest.len() >= 3 => {
                let offset = address / SECTOR_BYTES * SECTOR_BYTES;
                self.begin(Work::Erase { offset, len: SECTOR_BYTES }, now, self.times.sector_erase);
            }
            _ => {}
        }
    }

    fn finish_write(&mut self, now: u64, cycles: u64) {
        self.write_enabled = false;
        self.busy_until = now + cycles;
    }
}
