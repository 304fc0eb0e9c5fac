//! Single-cycle IO block: CPUID, spinlocks and the hardware divider.
//!
//! The GPIO registers of the block are served by `gpio`. The divider needs 8 cycles: who reads earlier gets the previous
//! result, as a reminder that the chip gives an intermediate one.
//!
//! Source: RP2040 datasheet 2.3.1.
//!
//! Not supported: the interpolators and core 1 (its FIFO looks empty and ready, and a write to it is an error).

/// Cycles from the last operand to the result.
const DIVIDER_CYCLES: u64 = 8;

#[derive(Clone, Debug)]
pub(super) struct Sio {
    spinlocks: u32,
    dividend: u32,
    divisor: u32,
    previous: (u32, u32),
    result: (u32, u32),
    ready_at: u64,
    dirty: bool,
    fifo_flags: u32,
}

impl Sio {
    pub(super) fn new() -> Self {
        Self {
            spinlocks: 0,
            dividend: 0,
            divisor: 0,
            previous: (0, 0),
            result: (0, 0),
            ready_at: 0,
            dirty: false,
            fifo_flags: 0,
        }
    }

    pub(super) fn read(&mut self, offset: u32, now: u64) -> Option<u32> {
        let (quotient, remainder) = if now >= self.ready_at { self.result } else { self.previous };
        Some(match offset {
            0x00 => 0,
            0x50 => 2 | self.fifo_flags,
            0x58 => {
                self.fifo_flags |= 8; // read while empty
                0
            }
            0x5c => self.spinlocks,
            0x60 | 0x68 => self.dividend,
            0x64 | 0x6c => self.divisor,
            0x70 => {
                self.dirty = false;
                quotient
            }
            0x74 => remainder,
            0x78 => u32::from(now >= self.ready_at) | u32::from(self.dirty) << 1,
            0x100..=0x17c => {
                let lock = 1 << ((offset - 0x100) / 4);
                let free = self.spinlocks & lock == 0;
                self.spinlocks |= lock;
                if free { lock } else { 0 }
            }
            _ => return None,
        })
    }

    pub(super) fn write(&mut self, offset: u32, value: u32, now: u64) -> Option<()> {
        match offset {
            0x50 => self.fifo_flags = 0,
            0x60 | 0x68 => {
                self.dividend = value;
                self.divide(offset == 0x68, now);
            }
            0x64 | 0x6c => {
                self.divisor = value;
                self.divide(offset == 0x6c, now);
            }
            // Written back by code that saves and restores the divider.
            0x70 => self.restore((value, self.result.1), now),
            0x74 => self.restore((self.result.0, value), now),
            0x100..=0x17c => self.spinlocks &= !(1 << ((offset - 0x100) / 4)),
            _ => return None,
        }
        Some(())
    }

    fn restore(&mut self, result: (u32, u32), now: u64) {
        self.result = result;
        self.previous = result;
        self.ready_at = now;
        self.dirty = true;
    }

    fn divide(&mut self, signed: bool, now: u64) {
        if now >= self.ready_at {
            self.previous = self.result;
        }
        self.ready_at = now + DIVIDER_CYCLES;
        self.dirty = true;
        self.result = if signed {
            let (dividend, divisor) = (self.dividend.cast_signed(), self.divisor.cast_signed());
            match divisor {
                0 => (if dividend < 0 { 1 } else { u32::MAX }, self.dividend),
                _ => (
                    dividend.wrapping_div(divisor).cast_unsigned(),
                    dividend.wrapping_rem(divisor).cast_unsigned(),
                ),
            }
        } else {
            match self.divisor {
                0 => (u32::MAX, self.dividend),
                divisor => (self.dividend / divisor, self.dividend % divisor),
            }
        };
    }
}
