//! WATCHDOG, PSM and RESETS: what counts down, what is held in reset, what survives.
//!
//! The counter decrements twice per tick (erratum RP2040-E1). Expiry or TRIGGER asks for a real reset of what
//! PSM.WDSEL and RESETS.WDSEL select; the scratch registers and REASON survive it.
//!
//! Source: RP2040 datasheet 4.7 (watchdog), 2.13 (PSM), 2.14 (resets).
//!
//! Not modelled: PSM.FRCE_OFF of anything but core 1 (an error), pausing under a debugger.

use super::clocks::Ratio;

const NEVER: u64 = u64::MAX;
const CTRL_ENABLE: u32 = 1 << 30;
const CTRL_TRIGGER: u32 = 1 << 31;
const TICK_ENABLE: u32 = 1 << 9;
const TICK_RUNNING: u32 = 1 << 10;

/// REASON: the counter ran out.
pub(super) const REASON_TIMER: u32 = 1;
/// REASON: CTRL.TRIGGER was written.
pub(super) const REASON_FORCE: u32 = 2;

#[derive(Clone, Debug)]
pub(super) struct Watchdog {
    ctrl: u32,
    /// Counter at `base_cycle`; it loses 2 per tick.
    count: u32,
    base_cycle: u64,
    tick: Option<Ratio>,
    tick_register: u32,
    pub(super) reason: u32,
    pub(super) scratch: [u32; 8],
}

impl Watchdog {
    pub(super) fn new() -> Self {
        Self {
            ctrl: 0x0700_0000,
            count: 0,
            base_cycle: 0,
            tick: None,
            tick_register: TICK_ENABLE,
            reason: 0,
            scratch: [0; 8],
        }
    }

    /// A watchdog reset: the counter stops, the tick generator returns to its reset value.
    pub(super) fn reset_keeping_scratch(&mut self, reason: u32) {
        *self = Self { reason, scratch: self.scratch, ..Self::new() };
    }

    /// Rate of the microsecond tick, in hertz; 0 while it does not run.
    pub(super) fn tick_hz(&self, ref_hz: u64) -> u64 {
        let cycles = u64::from(self.tick_register & 0x1ff);
        if self.tick_register & TICK_ENABLE == 0 || cycles == 0 { 0 } else { ref_hz / cycles }
    }

    fn is_counting(&self) -> Option<Ratio> {
        if self.ctrl & CTRL_ENABLE != 0 { self.tick } else { None }
    }

    fn remaining(&self, now: u64) -> u32 {
        let Some(tick) = self.is_counting() else { return self.count };
        let lost = tick.ticks_in(now.saturating_sub(self.base_cycle)).saturating_mul(2);
        u32::try_from(u64::from(self.count).saturating_sub(lost)).unwrap_or(0)
    }

    pub(super) fn set_tick(&mut self, now: u64, tick: Option<Ratio>) {
        if tick != self.tick {
            self.count = self.remaining(now);
            self.base_cycle = now;
            self.tick = tick;
        }
    }

    /// The cycle at which the counter reaches 0.
    pub(super) fn next_event(&self) -> u64 {
        match self.is_counting() {
            Some(tick) => self.base_cycle.saturating_add(tick.cycles_for(u64::from(self.count.div_ceil(2)))),
            None => NEVER,
        }
    }

    pub(super) fn read(&self, offset: u32, now: u64) -> Option<u32> {
        Some(match offset {
            0x00 => self.ctrl | self.remaining(now) & 0x00ff_ffff,
            0x04 => 0,
            0x08 => self.reason,
            0x0c..=0x28 => self.scratch[(offset as usize - 0x0c) / 4],
            0x2c => {
                let running = self.tick_register & TICK_ENABLE != 0 && self.tick.is_some();
                self.tick_register | if running { TICK_RUNNING } else { 0 }
            }
            _ => return None,
        })
    }

    /// Writes a register; `Some(true)` if the chip must reset now.
    pub(super) fn write(&mut self, offset: u32, value: u32, now: u64) -> Option<bool> {
        match offset {
            0x00 => {
                self.count = self.remaining(now);
                self.base_cycle = now;
                self.ctrl = value & (0x0700_0000 | CTRL_ENABLE);
                return Some(value & CTRL_TRIGGER != 0);
            }
            0x04 => {
                self.count = value & 0x00ff_ffff;
                self.base_cycle = now;
            }
            0x08 => {}
            0x0c..=0x28 => self.scratch[(offset as usize - 0x0c) / 4] = value,
            0x2c => self.tick_register = value & 0x3ff,
            _ => return None,
        }
        Some(false)
    }
}

/// Bits of PSM.WDSEL that this engine honours.
pub(super) mod psm {
    pub(in super::super) const XOSC: u32 = 1 << 1;
    pub(in super::super) const CLOCKS: u32 = 1 << 2;
    pub(in super::super) const RESETS: u32 = 1 << 3;
    pub(in super::super) const XIP: u32 = 1 << 12;
    pub(in super::super) const SIO: u32 = 1 << 14;
    pub(in super::super) const PROC0: u32 = 1 << 15;
    pub(in super::super) const PROC1: u32 = 1 << 16;
    pub(in super::super) const ALL: u32 = 0x1_ffff;
}

#[derive(Clone, Debug, Default)]
pub(super) struct Psm {
    force_on: u32,
    force_off: u32,
    pub(super) wdsel: u32,
}

impl Psm {
    pub(super) fn read(&self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x0 => self.force_on,
            0x4 => self.force_off,
            0x8 => self.wdsel,
            0xc => psm::ALL & !self.force_off,
            _ => return None,
        })
    }

    pub(super) fn write(&mut self, offset: u32, value: u32) -> Option<()> {
        match offset {
            0x0 => self.force_on = value & psm::ALL,
            0x4 if value & !psm::PROC1 == 0 => self.force_off = value,
            0x8 => self.wdsel = value & psm::ALL,
            0xc => {}
            _ => return None,
        }
        Some(())
    }
}

/// Bit numbers of RESETS.
pub(super) mod block {
    pub(in super::super) const ADC: u32 = 0;
    pub(in super::super) const BUSCTRL: u32 = 1;
    pub(in super::super) const DMA: u32 = 2;
    pub(in super::super) const I2C0: u32 = 3;
    pub(in super::super) const I2C1: u32 = 4;
    pub(in super::super) const IO_BANK0: u32 = 5;
    pub(in super::super) const IO_QSPI: u32 = 6;
    pub(in super::super) const PADS_BANK0: u32 = 8;
    pub(in super::super) const PADS_QSPI: u32 = 9;
    pub(in super::super) const PIO0: u32 = 10;
    pub(in super::super) const PIO1: u32 = 11;
    pub(in super::super) const PLL_SYS: u32 = 12;
    pub(in super::super) const PLL_USB: u32 = 13;
    pub(in super::super) const PWM: u32 = 14;
    pub(in super::super) const RTC: u32 = 15;
    pub(in super::super) const SPI0: u32 = 16;
    pub(in super::super) const SPI1: u32 = 17;
    pub(in super::super) const SYSCFG: u32 = 18;
    pub(in super::super) const SYSINFO: u32 = 19;
    pub(in super::super) const TBMAN: u32 = 20;
    pub(in super::super) const TIMER: u32 = 21;
    pub(in super::super) const UART0: u32 = 22;
    pub(in super::super) const UART1: u32 = 23;
    pub(in super::super) const USBCTRL: u32 = 24;
    pub(in super::super) const ALL: u32 = 0x01ff_ffff;
}

#[derive(Clone, Debug)]
pub(super) struct Resets {
    pub(super) held: u32,
    pub(super) wdsel: u32,
}

impl Resets {
    pub(super) fn new() -> Self {
        Self { held: block::ALL, wdsel: 0 }
    }

    pub(super) fn read(&self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x0 => self.held,
            0x4 => self.wdsel,
            0x8 => !self.held & block::ALL,
            _ => return None,
        })
    }

    /// Writes a register; returns the blocks that went into reset.
    pub(super) fn write(&mut self, offset: u32, value: u32) -> Option<u32> {
        match offset {
            0x0 => {
                let entering = value & !self.held & block::ALL;
                self.held = value & block::ALL;
                Some(entering)
            }
            0x4 => {
                self.wdsel = value & block::ALL;
                Some(0)
            }
            0x8 => Some(0),
            _ => None,
        }
    }
}
