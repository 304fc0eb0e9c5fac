//! Execute-in-place: the flash window and its 16 KiB cache, in front of SSI and flash chip.
//!
//! Owns the cells of the flash. A load or fetch from the flash windows goes through a two-way cache of 8-byte lines that holds
//! its own copy of the data, so code that forgets to flush after programming reads stale bytes here too. The cost of a
//! miss follows from the SSI registers that boot2 programmed: SCK clocks of command, address, wait cycles and 64 data
//! bits, times BAUDR, plus [`MISS_OVERHEAD`]. While the SSI is not set up for XIP, or chip select is forced, or the
//! flash expects another kind of command or is busy, the window is unmapped and every access to it is an error.
//!
//! Source: RP2040 datasheet 2.6.3 (flash, XIP cache).
//!
//! Not modelled: XIP streaming, the cache as SRAM. XIP_CTRL's counters count one access per line crossed, not one per
//! word. The replacement policy (least recently used) is an assumption. DMA out of flash costs the DMA no time.

use super::nor::{FlashTimes, Nor};
use super::ssi::Ssi;
use crate::flash::{Cells, Work};
use crate::time::Nanos;

/// First address of the cached flash window.
pub const FLASH_BASE: u32 = 0x1000_0000;
/// Flash on the board, in bytes.
pub const FLASH_BYTES: usize = 2 * 1024 * 1024;

/// Cycles of clk_sys between the cache and the SSI per miss, on top of the SCK clocks (an estimate).
const MISS_OVERHEAD: u32 = 4;
const SETS: usize = 1024;
const NO_LINE: u32 = u32::MAX;

/// The flash window is not mapped now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Unmapped;

/// Who reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Port {
    /// Instruction fetch.
    Fetch,
    /// Load.
    Data,
}

/// Cache, SSI and flash.
#[derive(Clone, Debug)]
pub(super) struct Xip {
    pub(super) cells: Cells,
    tags: Vec<u32>,
    lines: Vec<u64>,
    newest: Vec<u8>,
    /// The line last used by fetches and the one last used by loads: address (with its window) and data.
    current: [(u32, u64); 2],
    ctrl: u32,
    hits_base: u64,
    accesses_base: u64,
    pub(super) hits: u64,
    pub(super) misses: u64,
    miss_cycles: u32,
    word_cycles: u32,
    mapped: bool,
    ssi: Ssi,
    nor: Nor,
}

impl Xip {
    pub(super) fn new(cells: Cells, hz: u64) -> Self {
        let mut xip = Self {
            cells,
            tags: vec![NO_LINE; 2 * SETS],
            lines: vec![0; 2 * SETS],
            newest: vec![0; SETS],
            current: [(NO_LINE, 0); 2],
            ctrl: 3,
            hits_base: 0,
            accesses_base: 0,
            hits: 0,
            misses: 0,
            miss_cycles: 0,
            word_cycles: 0,
            mapped: false,
            ssi: Ssi::new(),
            nor: Nor::new(hz),
        };
        xip.refresh(0);
        xip
    }

    /// Resets the cache and the SSI; the flash chip keeps its mode and goes on with what it does.
    pub(super) fn reset(&mut self, now: u64) {
        self.ctrl = 3;
        self.ssi = Ssi::new();
        self.flush();
        self.refresh(now);
    }

    /// The supply fails.
    pub(super) fn cut_power(&mut self, now: u64) {
        self.settle(now);
        self.nor.cut_power(&mut self.cells, now);
        self.reset(now);
    }

    pub(super) fn set_times(&mut self, times: FlashTimes) {
        self.nor.set_times(times);
    }

    pub(super) fn times(&self) -> FlashTimes {
        self.nor.times()
    }

    pub(super) fn set_hz(&mut self, hz: u64) {
        self.nor.set_hz(hz);
    }

    /// Begins a write by the boot ROM that takes `time`.
    pub(super) fn begin(&mut self, work: Work, now: u64, time: Nanos) {
        self.nor.begin(work, now, time);
    }

    /// When the flash chip's write under way ends; `None` = it is ready.
    pub(super) fn busy_until(&mut self, now: u64) -> Option<u64> {
        self.nor.settle(&mut self.cells, now);
        self.nor.busy_until(now)
    }

    /// Whether the flash chip has a write to end, suspended or not.
    pub(super) fn is_writing(&self) -> bool {
        self.nor.is_writing()
    }

    pub(super) fn is_mapped(&self) -> bool {
        self.mapped
    }

    pub(super) fn flush(&mut self) {
        self.tags.fill(NO_LINE);
        self.forget_current();
    }

    fn refresh(&mut self, now: u64) {
        let is_ready = self.busy_until(now).is_none();
        let ssi = &self.ssi;
        let continuous = ssi.sends_no_command();
        self.mapped =
            ssi.is_xip() && ssi.select_forced.is_none() && continuous == self.nor.continuous && is_ready;
        self.miss_cycles = ssi.sck_clocks(64) * ssi.divisor() + MISS_OVERHEAD;
        self.word_cycles = ssi.sck_clocks(32) * ssi.divisor() + MISS_OVERHEAD;
        if !self.mapped {
            self.forget_current();
        }
    }

    fn forget_current(&mut self) {
        self.current = [(NO_LINE, 0); 2];
    }

    fn flash_line(&mut self, address: u32) -> u64 {
        let offset = (address & 0x00ff_fff8) as usize % self.cells.bytes().len();
        (0..8).rev().fold(0, |line, i| line << 8 | u64::from(self.cells.read(offset + i)))
    }

    /// The 8-byte line that holds `address`, for a fetch or a load; `extra` collects the wait states.
    #[inline]
    pub(super) fn line(&mut self, port: Port, address: u32, extra: &mut i32) -> Result<u64, Unmapped> {
        let (current, line) = self.current[port as usize];
        if address & !7 == current {
            return Ok(line);
        }
        self.look_up(port, address, extra)
    }

    #[inline(never)]
    fn look_up(&mut self, port: Port, address: u32, extra: &mut i32) -> Result<u64, Unmapped> {
        // Even what the cache still holds is out of bounds: next time the line may be gone.
        if !self.mapped {
            return Err(Unmapped);
        }
        let (checks, allocates) = match address >> 24 {
            _ if self.ctrl & 1 == 0 => (false, false),
            0x10 => (true, true),
            0x11 => (true, false),
            0x12 => (false, true),
            _ => (false, false),
        };
        let tag = address & 0x00ff_fff8;
        let set = (tag >> 3) as usize % SETS;
        if checks && let Some(way) = (0..2).find(|way| self.tags[2 * set + way] == tag) {
            self.hits += 1;
            self.newest[set] = u8::from(way == 1);
            let line = self.lines[2 * set + way];
            self.current[port as usize] = (address & !7, line);
            return Ok(line);
        }
        self.misses += 1;
        let data = self.flash_line(address);
        if allocates {
            *extra += self.miss_cycles.cast_signed();
            let way = usize::from(self.newest[set] == 0);
            self.newest[set] = u8::from(way == 1);
            let evicted = std::mem::replace(&mut self.tags[2 * set + way], tag);
            for current in &mut self.current {
                if current.0 & 0x00ff_fff8 == evicted {
                    current.0 = NO_LINE;
                }
            }
            self.lines[2 * set + way] = data;
            self.current[port as usize] = (address & !7, data);
        } else {
            *extra += self.word_cycles.cast_signed();
        }
        Ok(data)
    }

    /// A store to a flash window: drops the line from the cache. `false` = bus error (ERR_BADWRITE).
    pub(super) fn store(&mut self, address: u32) -> bool {
        if address >> 24 == 0x10 {
            let tag = address & 0x00ff_fff8;
            let set = (tag >> 3) as usize % SETS;
            for entry in &mut self.tags[2 * set..2 * set + 2] {
                if *entry == tag {
                    *entry = NO_LINE;
                }
            }
            self.forget_current();
            return true;
        }
        self.ctrl & 2 == 0
    }

    pub(super) fn read_ctrl(&self, offset: u32) -> Option<u32> {
        let counter = |value: u64| u32::try_from(value).unwrap_or(u32::MAX);
        Some(match offset {
            0x00 => self.ctrl,
            0x04 => 0,
            0x08 => 2 | 1, // FIFO empty, flush ready
            0x0c => counter(self.hits - self.hits_base),
            0x10 => counter(self.hits + self.misses - self.accesses_base),
            _ => return None,
        })
    }

    pub(super) fn write_ctrl(&mut self, offset: u32, value: u32) -> Option<()> {
        match offset {
            0x00 => {
                self.ctrl = value & 0xb;
                self.forget_current();
            }
            0x04 => {
                if value & 1 != 0 {
                    self.flush();
                }
            }
            0x08 => {}
            0x0c => self.hits_base = self.hits,
            0x10 => self.accesses_base = self.hits + self.misses,
            _ => return None,
        }
        Some(())
    }

    /// Forces flash chip select (IO_QSPI override): `Some(false)` selected, `Some(true)` deselected, `None` automatic.
    pub(super) fn force_select(&mut self, level: Option<bool>, now: u64) {
        self.settle(now);
        if level == Some(true) || self.ssi.select_forced == Some(false) {
            self.nor.deselect(&mut self.cells, now);
        }
        self.ssi.select_forced = level;
        self.refresh(now);
    }

    /// What the boot ROM's flash_exit_xip leaves behind: serial mode, /6, chip select forced high.
    pub(super) fn exit_xip(&mut self, now: u64) {
        self.settle(now);
        self.nor.deselect(&mut self.cells, now);
        self.nor.continuous = false;
        self.ssi = Ssi::serial();
        self.refresh(now);
    }

    /// What flash_flush_cache leaves behind: an empty, enabled cache and automatic chip select.
    pub(super) fn flush_and_release(&mut self, now: u64) {
        self.force_select(None, now);
        self.ctrl |= 1;
        self.flush();
    }

    /// What flash_enter_cmd_xip leaves behind: a 03h serial read per miss.
    pub(super) fn enter_command_xip(&mut self, now: u64) {
        self.ssi.ssienr = 1;
        self.ssi.ser = 1;
        self.ssi.ctrlr0 = 3 << 8 | 31 << 16;
        self.ssi.ctrlr1 = 0;
        self.ssi.spi_ctrlr0 = 0x03 << 24 | 2 << 8 | 6 << 2;
        self.refresh(now);
    }

    pub(super) fn read_ssi(&mut self, offset: u32, now: u64) -> Option<u32> {
        self.settle(now);
        self.ssi.read(offset, now)
    }

    pub(super) fn write_ssi(&mut self, offset: u32, value: u32, now: u64) -> Option<()> {
        self.settle(now);
        self.ssi.write(offset, value, now, &mut self.nor, &mut self.cells)?;
        self.refresh(now);
        Some(())
    }

    /// Ends a flash transaction whose last frame is over.
    fn settle(&mut self, now: u64) {
        if self.ssi.select_forced.is_none() && now >= self.ssi.busy_until {
            self.nor.deselect(&mut self.cells, self.ssi.busy_until);
        }
    }
}
