//! Boot ROM services: start-up, memory functions, erase and program.
//!
//! Serves the BKPTs of the stand-in ROM (`rom`). Erase and program take their datasheet-typical time, during which the
//! board lives on and interrupts are taken; what they do to the flash happens at their end, and a power cut in between
//! leaves the unit under way half done.
//!
//! Source: RP2040 datasheet 2.8.2 (boot sequence), 2.8.3 (functions); W25Q16JV datasheet 9.6 (times).
//!
//! Not modelled: the spread of erase and program times, wear. Cycles of memset and memcpy are estimates.

use super::Rp2040;
use super::bus::Width;
use super::chip::{FlashJob, RAM_BASE};
use super::nor::{PAGE_BYTES, SECTOR_BYTES};
use super::rom::{self, Service};
use super::xip::FLASH_BYTES;
use crate::pins::Board;
use crate::time::Nanos;

/// Typical sector erase (W25Q16JV datasheet 9.6).
pub const SECTOR_ERASE: Nanos = Nanos::from_millis(45);
/// Typical 64 KiB block erase.
pub const BLOCK_ERASE: Nanos = Nanos::from_millis(150);
/// Typical page program.
pub const PAGE_PROGRAM: Nanos = Nanos::from_micros(400);
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
        let boot2 = &self.chip.xip.flash[..rom::BOOT2_BYTES];
        if !rom::is_boot2_valid(boot2) {
            self.chip.stop_for("the flash has no valid second stage: the chip would enter USB boot");
            return;
        }
        let at = (rom::BOOT2_RAM - RAM_BASE) as usize;
        self.chip.ram[at..at + rom::BOOT2_BYTES].copy_from_slice(boot2);
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
            Service::EnterCommandXip => self.chip.xip.enter_command_xip(),
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
        let (mut at, end, mut time) = (offset, offset + count, Nanos::ZERO);
        while at < end {
            if by_block && at.is_multiple_of(BLOCK_BYTES) && end - at >= BLOCK_BYTES {
                time += BLOCK_ERASE;
                at += BLOCK_BYTES;
            } else {
                time += SECTOR_ERASE;
                at += SECTOR_BYTES;
            }
        }
        self.start_flash_job(offset, count, None, time);
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
        let time = Nanos(PAGE_PROGRAM.0 * u64::from(count / PAGE_BYTES));
        self.start_flash_job(offset, count, Some(data), time);
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

    fn start_flash_job(&mut self, offset: u32, count: u32, data: Option<Vec<u8>>, time: Nanos) {
        let started = self.chip.now;
        let done = self.chip.time.cycle(self.now() + time);
        self.chip.flash_job =
            Some(FlashJob { offset: offset as usize, len: count as usize, data, started, done });
    }

    /// One turn of the ROM's busy loop: r3 = 0 once the flash is ready.
    fn poll_flash(&mut self, r: &mut [u32; 16]) {
        r[3] = 0;
        let Some(job) = &self.chip.flash_job else { return };
        if self.chip.now >= job.done {
            let job = self.chip.flash_job.take();
            if let Some(job) = job {
                job.apply(&mut self.chip.xip.flash, job.len);
            }
            return;
        }
        r[3] = 1;
        // Nothing can interest the loop before the flash is ready or something happens, so one turn takes that long.
        let until = job.done.min(self.chip.horizon);
        let cycles =
            until.saturating_sub(self.chip.now).max(POLL_CYCLES).min(job.done - self.chip.now).max(1);
        self.chip.extra += i32::try_from(cycles.min(1 << 24)).unwrap_or(0);
    }
}

impl FlashJob {
    /// Carries the job out up to `reached` bytes; the unit that `reached` falls into is left half done.
    pub(super) fn apply(&self, flash: &mut [u8], reached: usize) {
        let unit = if self.data.is_some() { PAGE_BYTES } else { SECTOR_BYTES } as usize;
        let whole = reached / unit * unit;
        let target = &mut flash[self.offset..self.offset + self.len];
        for (i, byte) in target.iter_mut().enumerate().take((whole + unit).min(self.len)) {
            // A cell in the middle of its change reads either way; a fixed scramble decides, so runs stay equal.
            let scramble = (i as u32 ^ 0x5a5a).wrapping_mul(0x9e37_79b1).to_be_bytes()[0];
            let half_done = i >= whole;
            *byte = match (&self.data, half_done) {
                (None, false) => 0xff,
                (None, true) => *byte | scramble,
                (Some(data), false) => *byte & data[i],
                (Some(data), true) => *byte & (data[i] | scramble),
            };
        }
    }
}
