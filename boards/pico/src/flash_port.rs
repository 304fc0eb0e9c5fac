//! The top of the flash, where records are kept: it is programmed and erased while reception goes on.
//!
//! As long as the flash programs or erases, nothing can be fetched from it. [`run`] therefore lives in RAM and lets one
//! interrupt through, the CAN controller's, which does so too (memory.x names what it calls); all others wait, and with
//! them every task. A program takes one page at most: 0.4 ms, 3 ms at the longest. An erase goes on in slices of
//! [`SLICE_US`] and is suspended in between, so nothing ever waits longer than that.
//!
//! Source: RP2040 datasheet 2.8.3.1.3 (flash functions of the boot ROM), 4.10 (SSI); W25Q16JV datasheet 8.2 (commands,
//! suspend), 9.6 (times).

use core::arch::{asm, global_asm};
use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashErrorKind, ReadNorFlash};
use rp2040_hal::rom_data;

/// Time after which an erase is suspended, in microseconds: the longest page program.
pub const SLICE_US: u32 = 3_000;
/// Time after which a write that does not end is given up, in microseconds: twice the longest erase.
const PATIENCE_US: u32 = 800_000;

const PAGE_BYTES: usize = 256;
const SECTOR_BYTES: usize = 4096;
/// The flash without the cache, which would hold what was there before (RP2040 datasheet 2.6.3.1).
const UNCACHED: u32 = 0x1300_0000 - 0x1000_0000;

/// Instructions of the flash.
mod instruction {
    pub(super) const PAGE_PROGRAM: u8 = 0x02;
    pub(super) const READ_STATUS_1: u8 = 0x05;
    pub(super) const WRITE_ENABLE: u8 = 0x06;
    pub(super) const SECTOR_ERASE: u8 = 0x20;
    pub(super) const READ_STATUS_2: u8 = 0x35;
    pub(super) const SUSPEND: u8 = 0x75;
    pub(super) const RESUME: u8 = 0x7A;
}
/// Status register 1: a write is under way. Status register 2: an erase is suspended.
const BUSY: u8 = 1;
const SUSPENDED: u8 = 1 << 7;

// Registers by address: a call into the HAL could be a fetch from flash.
const SSI_STATUS: *const u32 = 0x1800_0028 as _;
const SSI_DATA: *mut u32 = 0x1800_0060 as _;
const SSI_ROOM: u32 = 1 << 1;
const SSI_RECEIVED: u32 = 1 << 3;
/// GPIO_QSPI_SS_CTRL: its output override holds chip select.
const SELECT: *mut u32 = 0x4001_800C as _;
const SELECTED: u32 = 2 << 8;
const RELEASED: u32 = 3 << 8;
const NVIC_ISER: *mut u32 = 0xE000_E100_u32 as _;
const NVIC_ICER: *mut u32 = 0xE000_E180_u32 as _;
const TIMER_RAW_LOW: *const u32 = 0x4005_4028 as _;
/// IO_IRQ_BANK0, the CAN controller's.
const CAN_IRQ: u32 = 1 << 13;

unsafe extern "C" {
    static __store_start: u8;
    static __store_bytes: u8;
}

// Copies .ram_text before anything runs that may call into it.
global_asm!(
    ".section .text.__pre_init, \"ax\"",
    ".global __pre_init",
    ".type __pre_init,%function",
    ".thumb_func",
    "__pre_init:",
    "ldr r0, =__sram_text",
    "ldr r1, =__eram_text",
    "ldr r2, =__siram_text",
    "1:",
    "cmp r0, r1",
    "bhs 2f",
    "ldm r2!, {{r3}}",
    "stm r0!, {{r3}}",
    "b 1b",
    "2:",
    "bx lr",
    ".ltorg",
);

/// What [`run`] calls, none of it in flash.
struct Calls {
    connect: unsafe extern "C" fn(),
    exit_xip: unsafe extern "C" fn(),
    flush: unsafe extern "C" fn(),
    /// The second stage of the boot, which sets quad reads up again.
    boot2: [u32; 64],
}

/// The region of the flash in which records are kept.
pub struct FlashPort {
    calls: Calls,
}

impl FlashPort {
    /// Takes the region; ends what a reset has left suspended.
    pub(crate) fn new() -> Self {
        let mut boot2 = [0; 64];
        // SAFETY: the second stage is the first 256 bytes of the flash, mapped now.
        unsafe { core::ptr::copy_nonoverlapping(0x1000_0000 as *const u32, boot2.as_mut_ptr(), boot2.len()) };
        let calls = Calls {
            connect: rom_data::connect_internal_flash::ptr(),
            exit_xip: rom_data::flash_exit_xip::ptr(),
            flush: rom_data::flash_flush_cache::ptr(),
            boot2,
        };
        let port = Self { calls };
        // Ignored by a flash that has nothing suspended.
        port.command(instruction::RESUME, None, &[], PATIENCE_US);
        port
    }

    /// Goes on with the erase of the sector at `offset`, or begins it; returns whether it has come to its end.
    pub fn erase_slice(&mut self, offset: u32, begins: bool) -> bool {
        if begins {
            self.command(instruction::SECTOR_ERASE, Some(base() + offset), &[], SLICE_US)
        } else {
            self.command(instruction::RESUME, None, &[], SLICE_US)
        }
    }

    /// Runs a command from RAM, with an address and data if it has any; returns whether the flash was ready again within
    /// `us`.
    fn command(&self, instruction: u8, address: Option<u32>, data: &[u8], us: u32) -> bool {
        // On the stack: what the caller names may lie in flash.
        let mut bytes = [0; 4 + PAGE_BYTES];
        let [_, a, b, c] = address.unwrap_or(0).to_be_bytes();
        bytes[..4].copy_from_slice(&[instruction, a, b, c]);
        bytes[4..4 + data.len()].copy_from_slice(data);
        let len = if address.is_some() { 4 + data.len() } else { 1 };
        // SAFETY: the bytes and `calls` are in RAM, as is everything that runs meanwhile.
        unsafe { run(&self.calls, address.is_some(), bytes.as_ptr(), len, us) }
    }
}

/// Offset of the region in the flash.
fn base() -> u32 {
    (&raw const __store_start as u32) & 0x00FF_FFFF
}

fn bytes() -> usize {
    &raw const __store_bytes as usize
}

/// Sends one byte to the flash and returns what comes back.
#[inline(always)]
unsafe fn exchange(byte: u8) -> u8 {
    // SAFETY: the SSI is in serial mode and nobody else uses it; each byte is read back, so its FIFOs are empty here.
    unsafe {
        while SSI_STATUS.read_volatile() & SSI_ROOM == 0 {}
        SSI_DATA.write_volatile(byte.into());
        while SSI_STATUS.read_volatile() & SSI_RECEIVED == 0 {}
        SSI_DATA.read_volatile() as u8
    }
}

/// Sends an instruction and returns the byte behind it.
#[inline(always)]
unsafe fn ask(instruction: u8) -> u8 {
    // SAFETY: as `exchange`.
    unsafe {
        SELECT.write_volatile(SELECTED);
        exchange(instruction);
        let answer = exchange(0);
        SELECT.write_volatile(RELEASED);
        answer
    }
}

/// Sends a command, with write enable before it if it `enables`, waits until the flash is ready, and maps it again. An erase that is not ready after `us` is
/// suspended; returns whether it was not.
///
/// # Safety
///
/// The bytes, `calls` and the stack must be in RAM, as must be all that IO_IRQ_BANK0 runs.
#[inline(never)]
#[unsafe(link_section = ".data.ram.flash")]
unsafe fn run(calls: &Calls, enables: bool, bytes: *const u8, len: usize, us: u32) -> bool {
    // SAFETY: see above; the other interrupts are let through again before the function returns.
    unsafe {
        let enabled = NVIC_ISER.read_volatile();
        NVIC_ICER.write_volatile(enabled & !CAN_IRQ);
        asm!("dsb", "isb");
        (calls.connect)();
        (calls.exit_xip)();
        if enables {
            SELECT.write_volatile(SELECTED);
            exchange(instruction::WRITE_ENABLE);
            SELECT.write_volatile(RELEASED);
        }
        SELECT.write_volatile(SELECTED);
        let mut sent = 0;
        while sent < len {
            exchange(bytes.add(sent).read_volatile());
            sent += 1;
        }
        SELECT.write_volatile(RELEASED);
        let start = TIMER_RAW_LOW.read_volatile();
        let mut is_suspended = false;
        while ask(instruction::READ_STATUS_1) & BUSY != 0 {
            if !is_suspended && TIMER_RAW_LOW.read_volatile().wrapping_sub(start) > us {
                is_suspended = true;
                SELECT.write_volatile(SELECTED);
                exchange(instruction::SUSPEND);
                SELECT.write_volatile(RELEASED);
            }
        }
        let is_ready = ask(instruction::READ_STATUS_2) & SUSPENDED == 0;
        (calls.flush)();
        let boot2 = calls.boot2.as_ptr() as usize | 1;
        core::mem::transmute::<usize, unsafe extern "C" fn()>(boot2)();
        NVIC_ISER.write_volatile(enabled);
        is_ready
    }
}

impl ErrorType for FlashPort {
    type Error = NorFlashErrorKind;
}

impl ReadNorFlash for FlashPort {
    const READ_SIZE: usize = 1;

    fn read(&mut self, offset: u32, to: &mut [u8]) -> Result<(), NorFlashErrorKind> {
        if offset as usize + to.len() > bytes() {
            return Err(NorFlashErrorKind::OutOfBounds);
        }
        let from = (&raw const __store_start as u32 + UNCACHED + offset) as *const u8;
        // Whole words where both ends allow it: each access goes to the flash.
        if offset.is_multiple_of(4) && to.len().is_multiple_of(4) {
            for (at, word) in to.chunks_exact_mut(4).enumerate() {
                // SAFETY: the region is mapped and aligned, the length was checked.
                let bytes = unsafe { from.cast::<u32>().add(at).read_volatile() }.to_le_bytes();
                word.copy_from_slice(&bytes);
            }
        } else {
            for (at, byte) in to.iter_mut().enumerate() {
                // SAFETY: as above.
                *byte = unsafe { from.add(at).read_volatile() };
            }
        }
        Ok(())
    }

    fn capacity(&self) -> usize {
        bytes()
    }
}

impl NorFlash for FlashPort {
    const WRITE_SIZE: usize = 1;
    const ERASE_SIZE: usize = SECTOR_BYTES;

    /// Erases to the end: for whoever has the time.
    fn erase(&mut self, from: u32, to: u32) -> Result<(), NorFlashErrorKind> {
        for offset in (from..to).step_by(SECTOR_BYTES) {
            let mut begins = true;
            while !self.erase_slice(offset, begins) {
                begins = false;
            }
        }
        Ok(())
    }

    fn write(&mut self, offset: u32, data: &[u8]) -> Result<(), NorFlashErrorKind> {
        let at = base() + offset;
        if offset as usize + data.len() > bytes() || at as usize % PAGE_BYTES + data.len() > PAGE_BYTES {
            return Err(NorFlashErrorKind::OutOfBounds);
        }
        if self.command(instruction::PAGE_PROGRAM, Some(at), data, PATIENCE_US) {
            Ok(())
        } else {
            Err(NorFlashErrorKind::Other)
        }
    }
}
