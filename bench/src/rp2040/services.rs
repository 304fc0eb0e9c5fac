//! Boot ROM services: start-up, memory functions, erase and program.
//!
//! Serves the BKPTs of the stand-in ROM (`rom`). Erase and program take the flash chip's time, during which the board
//! lives on and interrupts are taken.
//!
//! Source: RP2040 datasheet 2.8.2 (boot sequence), 2.8.3 (functions).
//!
//! Not modelled: cycles of memset and memcpy are estimates; program by the ROM counts as one write, however many pages.

use super::Rp2040;
use super::bus::Width;
use super::chip::RAM_BASE;
use super::rom::{self, Service};
use super::xip::FLASH_BYTES;
use crate::flash::Work;
use crate::pins::Board;
use crate::time::Nanos;

const SECTOR_BYTES: u32 = crate::flash::SECTOR_BYTES as u32;
const PAGE_BYTES: u32 = crate::flash::PAGE_BYTES as u32;
const BLOCK_BYTES: u32 = 64 * 1024;
/// Cycles of one turn of the ROM's busy loop, status command included.
const POLL_CYCLES: u64 = 200;
/// First word of a vectored boot in the watchdog's scratch registers.
const VECTORED_BOOT: u32 = 0xb007_c0d3;

impl<B: Board> Rp2040<B> {
    /// The boot ROM after reset, up to the jump into the second stage.
    fn boot(&mut self, registers: &mut [u32; 16]) {
        if self.chip.watchdog.scratch[4] == VECTORED_BOOT {
            self.chip.stop_for("vectored boot through the watchdog's scratch registers is not modelled");
            return;
        }
        self.chip.boot_rom_resets();
        self.chip.xip.exit_xip(self.chip.now);
        self.chip.xip.flush_and_release(self.chip.now);
        // The ROM reads again and again for half a second: a write that goes on over a reset is waited for.
        if let Some(ready) = self.chip.xip.busy_until(self.chip.now) {
            self.chip.extra += i32::try_from(ready - self.chip.now).unwrap_or(i32::MAX / 2);
        }
        let boot2: Vec<u8> = (0..rom::BOOT2_BYTES).map(|at| self.chip.xip.cells.read(at)).collect();
        if !rom::is_boot2_valid(&boot2) {
            self.chip.stop_for("the flash has no valid second stage: the chip would enter USB boot");
            return;
        }
        let at = (rom::BOOT2_RAM - RAM_BASE) as usize;
        self.chip.ram[at..at + rom::BOOT2_BYTES].copy_from_slice(&boot2);
        registers[4] = rom::BOOT2_RAM | 1;
        registers[14] = 0;
        self.chip.extra += rom::BOOT_CYCLES;
    }

    pub(super) fn serve(&mut self, service: Service, r: &mut [u32; 16]) {
        self.chip.extra += service.cycles();
        self.catch_up(self.chip.now);
        match service {
            Service::Boot => self.boot(r),
            Service::Poll => self.poll_flash(r),
            Service::Popcount => r[0] = r[0].count_ones(),
            Service::Reverse => r[0] = r[0].reverse_bits(),
            Service::LeadingZeros => r[0] = r[0].leading_zeros(),
            Service::TrailingZeros => r[0] = r[0].trailing_zeros(),
            Service::Memset => self.rom_memset(r[0], r[1], r[2]),
            Service::Memcpy => self.rom_memcpy(r[0], r[1], r[2]),
            Service::UsbBoot => self.chip.stop_for("reset_to_usb_boot: the chip would enter USB boot"),
            Service::WaitForVector => self.chip.stop_for("_wait_for_vector: core 1 is not modelled"),
            Service::ConnectFlash | Service::Nothing => {}
            Service::ExitXip => self.chip.xip.exit_xip(self.chip.now),
            Service::RangeErase => self.start_erase(r),
            Service::RangeProgram => self.start_program(r),
            Service::FlushCache => self.chip.xip.flush_and_release(self.chip.now),
            Service::EnterCommandXip => self.chip.xip.enter_command_xip(self.chip.now),
            Service::Float(entry) => rom::float(entry, r),
            Service::Double(entry) => rom::double(entry, r),
        }
    }

    // The ROM copies words where it can: 2 cycles to load and 2 to store 4 bytes, plus its loop.
    fn rom_memset(&mut self, to: u32, byte: u32, len: u32) {
        for i in 0..len {
            if self.chip.store(to.wrapping_add(i), Width::Byte, byte).is_err() {
                self.chip.stop_for(format!("memset in ROM writes {:#010x}", to.wrapping_add(i)));
                return;
            }
        }
        self.chip.extra += (len / 4 * 3 + len % 4 * 3).cast_signed();
    }

    fn rom_memcpy(&mut self, to: u32, from: u32, len: u32) {
        for i in 0..len {
            let copied = self
                .chip
                .load(from.wrapping_add(i), Width::Byte)
                .and_then(|byte| self.chip.store(to.wrapping_add(i), Width::Byte, byte));
            if copied.is_err() {
                let (from, to) = (from.wrapping_add(i), to.wrapping_add(i));
                self.chip.stop_for(format!("memcpy in ROM from {from:#010x} to {to:#010x}"));
                return;
            }
        }
        let aligned = (to | from) & 3 == 0;
        self.chip.extra += (if aligned { len / 4 * 5 + len % 4 * 5 } else { len * 5 }).cast_signed();
    }

    fn start_erase(&mut self, r: &mut [u32; 16]) {
        let (offset, count, block_bytes) = (r[0], r[1], r[2]);
        if !self.may_write_flash("flash_range_erase", offset, count, SECTOR_BYTES) {
            return;
        }
        // Whole aligned blocks go by the block command, if the caller gave one.
        let by_block = block_bytes == BLOCK_BYTES;
        let times = self.chip.xip.times();
        let (mut at, end, mut time) = (offset, offset + count, Nanos::ZERO);
        while at < end {
            if by_block && at.is_multiple_of(BLOCK_BYTES) && end - at >= BLOCK_BYTES {
                time += times.block_erase;
                at += BLOCK_BYTES;
            } else {
                time += times.sector_erase;
                at += SECTOR_BYTES;
            }
        }
        let work = Work::Erase { offset: offset as usize, len: count as usize };
        self.chip.xip.begin(work, self.chip.now, time);
    }

    fn start_program(&mut self, r: &mut [u32; 16]) {
        let (offset, source, count) = (r[0], r[1], r[2]);
        if !self.may_write_flash("flash_range_program", offset, count, PAGE_BYTES) {
            return;
        }
        let mut data = Vec::with_capacity(count as usize);
        for i in 0..count {
            match self.chip.load(source.wrapping_add(i), Width::Byte) {
                Ok(byte) => data.push((byte & 0xff) as u8),
                Err(_) => {
                    let address = source.wrapping_add(i);
                    self.chip
                        .stop_for(format!("flash_range_program cannot read its source at {address:#010x}"));
                    return;
                }
            }
        }
        let time = Nanos(self.chip.xip.times().page_program.0 * u64::from(count / PAGE_BYTES));
        self.chip.xip.begin(Work::Program { offset: offset as usize, data }, self.chip.now, time);
    }

    fn may_write_flash(&mut self, function: &str, offset: u32, count: u32, unit: u32) -> bool {
        let end = u64::from(offset) + u64::from(count);
        let problem = if self.chip.xip.is_mapped() {
            "the flash is still in XIP mode: call flash_exit_xip first".to_owned()
        } else if !offset.is_multiple_of(unit) || !count.is_multiple_of(unit) {
            format!("offset {offset:#x} and count {count:#x} must be multiples of {unit}")
        } else if end > FLASH_BYTES as u64 {
            format!(
                "offset {offset:#x} and count {count:#x} end behind the flash (the offset counts from its start)"
            )
        } else {
            return true;
        };
        self.chip.stop_for(format!("{function}: {problem}"));
        false
    }

    /// One turn of the ROM's busy loop: r3 = 0 once the flash is ready.
    fn poll_flash(&mut self, r: &mut [u32; 16]) {
        r[3] = 0;
        let Some(done) = self.chip.xip.busy_until(self.chip.now) else { return };
        r[3] = 1;
        // Nothing can interest the loop before the flash is ready or something happens, so one turn takes that long.
        let until = done.min(self.chip.horizon);
        let cycles = until.saturating_sub(self.chip.now).max(POLL_CYCLES).min(done - self.chip.now).max(1);
        self.chip.extra += i32::try_from(cycles.min(1 << 24)).unwrap_or(0);
    }
}
