//! Clock tree: oscillators, PLLs and the generators that feed clk_sys and clk_peri.
//!
//! Owns CLOCKS, XOSC, ROSC, PLL_SYS and PLL_USB, and the conversion between clk_sys cycles and virtual time. Each
//! frequency follows from the registers: the chip leaves reset on the ring oscillator, then runs from the crystal, then
//! from a PLL, and the time per cycle follows.
//!
//! Source: RP2040 datasheet 2.15 (clocks), 2.16 (XOSC), 2.17 (ROSC), 2.18 (PLL).
//!
//! Not modelled: resus, GPIN clocks, dormant modes, phase and nudge, sleep gating (WAKE_EN/SLEEP_EN are plain storage),
//! ROSC trimming (it is always [`ROSC_HZ`]), glitches while a mux switches. The frequency counter answers at once.

use crate::time::Nanos;

/// Crystal on the board, in hertz.
pub const XOSC_HZ: u64 = 12_000_000;
/// Nominal ring oscillator after reset, in hertz (datasheet 2.17: 1.8 to 12 MHz, 6.5 MHz nominal).
pub const ROSC_HZ: u64 = 6_500_000;
/// Time from VCO power-up to LOCK. The datasheet gives no figure; the order of magnitude is what matters at boot.
const PLL_LOCK: Nanos = Nanos::from_micros(50);

const NANOS_PER_SECOND: u64 = 1_000_000_000;

/// Converts clk_sys cycles to virtual time and back, exactly, across changes of clk_sys.
#[derive(Clone, Debug)]
pub(super) struct Timebase {
    cycle: u64,
    nanos: u64,
    hz: u64,
    nanos_per_cycle: Option<u64>,
}

impl Timebase {
    pub(super) fn new(hz: u64) -> Self {
        Self { cycle: 0, nanos: 0, hz, nanos_per_cycle: whole_nanos(hz) }
    }

    /// clk_sys in hertz.
    pub(super) fn hz(&self) -> u64 {
        self.hz
    }

    /// The instant of `cycle`, rounded down to a nanosecond.
    #[inline]
    pub(super) fn nanos(&self, cycle: u64) -> Nanos {
        let delta = cycle.saturating_sub(self.cycle);
        match self.nanos_per_cycle {
            Some(nanos) => Nanos(self.nanos + delta * nanos),
            None => {
                let (seconds, rest) = (delta / self.hz, delta % self.hz);
                Nanos(self.nanos + seconds * NANOS_PER_SECOND + rest * NANOS_PER_SECOND / self.hz)
            }
        }
    }

    /// The first cycle that is not before `at`.
    pub(super) fn cycle(&self, at: Nanos) -> u64 {
        let delta = at.0.saturating_sub(self.nanos);
        if let Some(nanos) = self.nanos_per_cycle {
            return self.cycle.saturating_add(delta.div_ceil(nanos));
        }
        let (seconds, rest) = (delta / NANOS_PER_SECOND, delta % NANOS_PER_SECOND);
        let cycles =
            seconds.saturating_mul(self.hz).saturating_add((rest * self.hz).div_ceil(NANOS_PER_SECOND));
        self.cycle.saturating_add(cycles)
    }

    /// From `cycle` on, clk_sys runs at `hz`.
    pub(super) fn change(&mut self, cycle: u64, hz: u64) {
        self.nanos = self.nanos(cycle).0;
        self.cycle = cycle;
        self.hz = hz;
        self.nanos_per_cycle = whole_nanos(hz);
    }
}

fn whole_nanos(hz: u64) -> Option<u64> {
    NANOS_PER_SECOND.is_multiple_of(hz).then(|| NANOS_PER_SECOND / hz)
}

#[derive(Clone, Debug)]
struct Pll {
    cs: u32,
    pwr: u32,
    fbdiv: u32,
    prim: u32,
    locked_at: Nanos,
}

impl Pll {
    const CS_REFDIV: u32 = 0x3f;
    const CS_BYPASS: u32 = 1 << 8;
    const CS_LOCK: u32 = 1 << 31;
    const PWR_PD: u32 = 1 << 0;
    const PWR_POSTDIVPD: u32 = 1 << 3;
    const PWR_VCOPD: u32 = 1 << 5;

    fn new() -> Self {
        Self { cs: 1, pwr: 0x2d, fbdiv: 0, prim: 0x0007_7000, locked_at: Nanos::ZERO }
    }

    fn is_on(&self) -> bool {
        self.pwr & (Self::PWR_PD | Self::PWR_VCOPD) == 0
    }

    fn hz(&self, reference: u64) -> u64 {
        if self.cs & Self::CS_BYPASS != 0 {
            return reference;
        }
        let refdiv = u64::from(self.cs & Self::CS_REFDIV);
        let post = u64::from(self.prim >> 16 & 7) * u64::from(self.prim >> 12 & 7);
        if !self.is_on() || self.pwr & Self::PWR_POSTDIVPD != 0 || refdiv == 0 || post == 0 {
            return 0;
        }
        reference / refdiv * u64::from(self.fbdiv & 0xfff) / post
    }

    fn read(&self, offset: u32, now: Nanos) -> Option<u32> {
        Some(match offset {
            0x0 => {
                let locked = self.is_on() && self.fbdiv != 0 && now >= self.locked_at;
                self.cs & (Self::CS_REFDIV | Self::CS_BYPASS) | if locked { Self::CS_LOCK } else { 0 }
            }
            0x4 => self.pwr,
            0x8 => self.fbdiv,
            0xc => self.prim,
            _ => return None,
        })
    }

    fn write(&mut self, offset: u32, value: u32, now: Nanos) -> Option<()> {
        match offset {
            0x0 => self.cs = value,
            0x4 => {
                let was_on = self.is_on();
                self.pwr = value & 0x2d;
                if self.is_on() && !was_on {
                    self.locked_at = now + PLL_LOCK;
                }
            }
            0x8 => self.fbdiv = value & 0xfff,
            0xc => self.prim = value & 0x0007_7000,
            _ => return None,
        }
        Some(())
    }
}

/// CLOCKS, XOSC, ROSC and both PLLs.
#[derive(Clone, Debug)]
pub(super) struct Clocks {
    registers: [u32; 0xc8 / 4],
    xosc_ctrl: u32,
    xosc_startup: u32,
    xosc_stable_at: Option<Nanos>,
    rosc: [u32; 8],
    random: u32,
    plls: [Pll; 2],
}

const GPOUT_LAST: u32 = 0x2c;
const REF_CTRL: u32 = 0x30;
const REF_DIV: u32 = 0x34;
const REF_SELECTED: u32 = 0x38;
const SYS_CTRL: u32 = 0x3c;
const SYS_DIV: u32 = 0x40;
const SYS_SELECTED: u32 = 0x44;
const PERI_CTRL: u32 = 0x48;
const PERI_DIV: u32 = 0x4c;
const USB_CTRL: u32 = 0x54;
const USB_DIV: u32 = 0x58;
const ADC_CTRL: u32 = 0x60;
const ADC_DIV: u32 = 0x64;
const RTC_DIV: u32 = 0x70;
const RESUS_CTRL: u32 = 0x78;
const RESUS_STATUS: u32 = 0x7c;
const FC0_MAX: u32 = 0x88;
const FC0_DELAY: u32 = 0x8c;
const FC0_INTERVAL: u32 = 0x90;
const FC0_SRC: u32 = 0x94;
const FC0_STATUS: u32 = 0x98;
const FC0_RESULT: u32 = 0x9c;
const WAKE_EN0: u32 = 0xa0;
const WAKE_EN1: u32 = 0xa4;
const SLEEP_EN0: u32 = 0xa8;
const SLEEP_EN1: u32 = 0xac;
const ENABLED0: u32 = 0xb0;
const ENABLED1: u32 = 0xb4;

const CTRL_ENABLE: u32 = 1 << 11;
const XOSC_ENABLE: u32 = 0xfab;
const OSC_ENABLED: u32 = 1 << 12;
const OSC_STABLE: u32 = 1 << 31;

impl Clocks {
    pub(super) fn new() -> Self {
        Self {
            registers: Self::generator_reset(),
            xosc_ctrl: 0,
            xosc_startup: 0xc4,
            xosc_stable_at: None,
            rosc: [0xaa0, 0, 0, 0, 0, 8, 0, 1],
            random: 0x1357_9bdf,
            plls: [Pll::new(), Pll::new()],
        }
    }

    fn generator_reset() -> [u32; 0xc8 / 4] {
        let mut registers = [0; 0xc8 / 4];
        let divisors = [0x04, 0x10, 0x1c, 0x28, REF_DIV, SYS_DIV, USB_DIV, ADC_DIV, RTC_DIV];
        for offset in divisors {
            registers[offset as usize / 4] = 0x100;
        }
        for (offset, value) in [
            (RESUS_CTRL, 0xff),
            (FC0_MAX, 0x01ff_ffff),
            (FC0_DELAY, 1),
            (FC0_INTERVAL, 8),
            (WAKE_EN0, u32::MAX),
            (WAKE_EN1, 0x7fff),
            (SLEEP_EN0, u32::MAX),
            (SLEEP_EN1, 0x7fff),
        ] {
            registers[offset as usize / 4] = value;
        }
        registers
    }

    /// Resets what the power-on state machine resets with its CLOCKS stage.
    pub(super) fn reset_generators(&mut self) {
        self.registers = Self::generator_reset();
    }

    /// Stops the crystal oscillator (XOSC stage of the power-on state machine).
    pub(super) fn reset_xosc(&mut self) {
        self.xosc_ctrl = 0;
        self.xosc_startup = 0xc4;
        self.xosc_stable_at = None;
    }

    /// Resets PLL `index` (RESETS bit PLL_SYS or PLL_USB).
    pub(super) fn reset_pll(&mut self, index: usize) {
        self.plls[index] = Pll::new();
    }

    fn register(&self, offset: u32) -> u32 {
        self.registers[offset as usize / 4]
    }

    fn xosc_hz(&self) -> u64 {
        if self.xosc_stable_at.is_some() { XOSC_HZ } else { 0 }
    }

    fn pll_hz(&self, index: usize) -> u64 {
        self.plls[index].hz(self.xosc_hz())
    }

    /// clk_ref in hertz, 0 if its source does not run.
    pub(super) fn ref_hz(&self) -> u64 {
        let source = match self.register(REF_CTRL) & 3 {
            0 => ROSC_HZ,
            1 if self.register(REF_CTRL) >> 5 & 3 == 0 => self.pll_hz(1),
            2 => self.xosc_hz(),
            _ => 0,
        };
        source / u64::from(self.register(REF_DIV) >> 8 & 3).max(1)
    }

    /// clk_sys in hertz, 0 if its source does not run.
    pub(super) fn sys_hz(&self) -> u64 {
        let ctrl = self.register(SYS_CTRL);
        let source = if ctrl & 1 == 0 {
            self.ref_hz()
        } else {
            match ctrl >> 5 & 7 {
                0 => self.pll_hz(0),
                1 => self.pll_hz(1),
                2 => ROSC_HZ,
                3 => self.xosc_hz(),
                _ => 0,
            }
        };
        // 24.8 fixed point; an integer part of 0 means 65536.
        let divisor = match self.register(SYS_DIV) {
            raw if raw >> 8 == 0 => 65_536 << 8 | u64::from(raw & 0xff),
            raw => u64::from(raw),
        };
        (source << 8) / divisor
    }

    /// clk_peri in hertz, 0 if stopped.
    pub(super) fn peri_hz(&self) -> u64 {
        let ctrl = self.register(PERI_CTRL);
        if ctrl & CTRL_ENABLE == 0 {
            return 0;
        }
        match ctrl >> 5 & 7 {
            0 => self.sys_hz(),
            1 => self.pll_hz(0),
            2 => self.pll_hz(1),
            3 => ROSC_HZ,
            4 => self.xosc_hz(),
            _ => 0,
        }
    }

    /// clk_adc in hertz, 0 if stopped.
    pub(super) fn adc_hz(&self) -> u64 {
        self.usb_like_hz(ADC_CTRL, ADC_DIV)
    }

    fn usb_like_hz(&self, ctrl: u32, div: u32) -> u64 {
        let ctrl = self.register(ctrl);
        if ctrl & CTRL_ENABLE == 0 {
            return 0;
        }
        let source = match ctrl >> 5 & 7 {
            0 => self.pll_hz(1),
            1 => self.pll_hz(0),
            2 => ROSC_HZ,
            3 => self.xosc_hz(),
            _ => 0,
        };
        source / u64::from(self.register(div) >> 8 & 3).max(1)
    }

    /// What the frequency counter would measure on `source`, in hertz.
    fn counted_hz(&self, source: u32) -> u64 {
        match source {
            1 => self.pll_hz(0),
            2 => self.pll_hz(1),
            3 | 4 => ROSC_HZ,
            5 => self.xosc_hz(),
            8 => self.ref_hz(),
            9 => self.sys_hz(),
            10 => self.peri_hz(),
            11 => self.usb_like_hz(USB_CTRL, USB_DIV),
            12 => self.adc_hz(),
            _ => 0,
        }
    }

    pub(super) fn read(&self, offset: u32) -> Option<u32> {
        Some(match offset {
            REF_SELECTED => 1 << (self.register(REF_CTRL) & 3),
            SYS_SELECTED => 1 << (self.register(SYS_CTRL) & 1),
            0x08 | 0x14 | 0x20 | 0x2c | 0x50 | 0x5c | 0x68 | 0x74 => 1,
            RESUS_STATUS => 0,
            FC0_STATUS => 0x11, // DONE and PASS
            FC0_RESULT => (self.counted_hz(self.register(FC0_SRC)) * 32 / 1000) as u32,
            ENABLED0 => self.register(WAKE_EN0),
            ENABLED1 => self.register(WAKE_EN1),
            PERI_DIV => 0x100,
            0..=0xc4 if offset.is_multiple_of(4) => self.register(offset),
            _ => return None,
        })
    }

    /// Writes a generator register; the caller re-derives the frequencies.
    pub(super) fn write(&mut self, offset: u32, value: u32) -> Option<()> {
        match offset {
            REF_SELECTED | SYS_SELECTED | RESUS_STATUS | FC0_STATUS | FC0_RESULT | ENABLED0 | ENABLED1 => {}
            0..=GPOUT_LAST | REF_CTRL..=0xc4 if offset.is_multiple_of(4) => {
                self.registers[offset as usize / 4] = value;
            }
            _ => return None,
        }
        Some(())
    }

    pub(super) fn read_xosc(&self, offset: u32, now: Nanos) -> Option<u32> {
        Some(match offset {
            0x0 => self.xosc_ctrl,
            0x4 => match self.xosc_stable_at {
                Some(stable) if now >= stable => OSC_ENABLED | OSC_STABLE,
                Some(_) => OSC_ENABLED,
                None => 0,
            },
            0x8 => 0x7761_6b65, // DORMANT reads WAKE
            0xc => self.xosc_startup,
            _ => return None,
        })
    }

    pub(super) fn write_xosc(&mut self, offset: u32, value: u32, now: Nanos) -> Option<()> {
        match offset {
            0x0 => {
                self.xosc_ctrl = value & 0x00ff_ffff;
                match (value >> 12 & 0xfff == XOSC_ENABLE, self.xosc_stable_at) {
                    (true, None) => {
                        let delay = u64::from(self.xosc_startup & 0x3fff) * 256;
                        let delay = if self.xosc_startup & 1 << 20 == 0 { delay } else { delay * 4 };
                        self.xosc_stable_at = Some(now + Nanos(delay * NANOS_PER_SECOND / XOSC_HZ));
                    }
                    (true, Some(_)) => {}
                    (false, _) => self.xosc_stable_at = None,
                }
            }
            0x4 => {}
            0xc => self.xosc_startup = value & 0x0010_3fff,
            _ => return None, // DORMANT would stop the chip
        }
        Some(())
    }

    pub(super) fn read_rosc(&mut self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x18 => OSC_ENABLED | 1 << 16 | OSC_STABLE,
            0x1c => {
                // A fixed xorshift sequence: runs stay equal.
                self.random ^= self.random << 13;
                self.random ^= self.random >> 17;
                self.random ^= self.random << 5;
                self.random & 1
            }
            0x0 | 0x4 | 0x8 | 0x10 | 0x14 => self.rosc[offset as usize / 4],
            _ => return None,
        })
    }

    pub(super) fn write_rosc(&mut self, offset: u32, value: u32) -> Option<()> {
        match offset {
            0x0 | 0x4 | 0x8 | 0x10 | 0x14 => self.rosc[offset as usize / 4] = value,
            0x18 | 0x1c => {}
            _ => return None, // DORMANT would stop the chip
        }
        Some(())
    }

    pub(super) fn read_pll(&self, index: usize, offset: u32, now: Nanos) -> Option<u32> {
        self.plls[index].read(offset, now)
    }

    pub(super) fn write_pll(&mut self, index: usize, offset: u32, value: u32, now: Nanos) -> Option<()> {
        self.plls[index].write(offset, value, now)
    }
}

/// A ratio of two clocks in lowest terms: `cycles` of clk_sys make `ticks` of the other clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Ratio {
    cycles: u64,
    ticks: u64,
}

impl Ratio {
    /// The other clock has `hz`, clk_sys has `sys_hz`; `None` if the other clock does not run.
    pub(super) fn new(sys_hz: u64, hz: u64) -> Option<Self> {
        if hz == 0 || sys_hz == 0 {
            return None;
        }
        let divisor = gcd(sys_hz, hz);
        Some(Self { cycles: sys_hz / divisor, ticks: hz / divisor })
    }

    /// Whole ticks in `cycles`.
    #[inline]
    pub(super) fn ticks_in(self, cycles: u64) -> u64 {
        if self.ticks == 1 {
            return cycles / self.cycles;
        }
        widen(u128::from(cycles) * u128::from(self.ticks) / u128::from(self.cycles))
    }

    /// Cycles until `ticks` ticks have passed (rounded up: never early).
    #[inline]
    pub(super) fn cycles_for(self, ticks: u64) -> u64 {
        if self.ticks == 1 {
            return ticks.saturating_mul(self.cycles);
        }
        widen((u128::from(ticks) * u128::from(self.cycles)).div_ceil(u128::from(self.ticks)))
    }
}

fn widen(value: u128) -> u64 {
    u64::try_from(value).unwrap_or(u64::MAX)
}

fn gcd(a: u64, b: u64) -> u64 {
    let (mut a, mut b) = (a, b);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
