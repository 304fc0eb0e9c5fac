//! PWM: eight slices as frequency and duty, plus counters, wrap interrupts and wrap requests.
//!
//! The board hears frequency and duty of each output, not its edges. The counter is computed from time when it is read;
//! a wrap is an event only while an interrupt or DMA wants it.
//!
//! Source: RP2040 datasheet 4.5.
//!
//! Not modelled: input modes (DIVMODE 1 to 3: an error), phase advance and retard (ignored), double buffering of TOP and
//! CC (a change takes effect at once instead of at the next wrap).

const NEVER: u64 = u64::MAX;
/// Number of slices.
pub(super) const SLICES: usize = 8;
const CSR_ENABLE: u32 = 1 << 0;
const CSR_PHASE_CORRECT: u32 = 1 << 1;
const CSR_INVERT_A: u32 = 1 << 2;
const CSR_INVERT_B: u32 = 1 << 3;
const CSR_DIVMODE: u32 = 3 << 4;

/// What a PWM output looks like from outside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Output {
    /// Periods per second, 0 if constant.
    pub(super) frequency_hz: u32,
    /// Share of the period that is high, of 65536.
    pub(super) duty: u32,
}

#[derive(Clone, Copy, Debug)]
struct Slice {
    csr: u32,
    div: u32,
    cc: u32,
    top: u32,
    /// Counter at `base_sixteenth`.
    counter: u32,
    /// In 1/16 cycles of clk_sys, so that fractional divisors do not drift.
    base_sixteenth: u64,
}

impl Slice {
    const RESET: Self = Self { csr: 0, div: 0x10, cc: 0, top: 0xffff, counter: 0, base_sixteenth: 0 };

    /// Cycles per count, in 1/16.
    fn divisor(&self) -> u64 {
        match self.div & 0xfff {
            raw if raw >> 4 == 0 => 256 * 16 + u64::from(raw & 15),
            raw => u64::from(raw),
        }
    }

    fn counts(&self) -> u64 {
        let period = u64::from(self.top & 0xffff) + 1;
        if self.csr & CSR_PHASE_CORRECT != 0 { (2 * (period - 1)).max(1) } else { period }
    }

    fn is_enabled(&self) -> bool {
        self.csr & CSR_ENABLE != 0
    }

    fn position(&self, now: u64) -> u64 {
        if !self.is_enabled() {
            return u64::from(self.counter);
        }
        u64::from(self.counter) + (now * 16).saturating_sub(self.base_sixteenth) / self.divisor()
    }

    fn count(&self, now: u64) -> u32 {
        let position = self.position(now) % self.counts();
        let folded = if self.csr & CSR_PHASE_CORRECT != 0 && position > u64::from(self.top) {
            self.counts() - position
        } else {
            position
        };
        u32::try_from(folded).unwrap_or(0)
    }

    fn next_wrap(&self) -> u64 {
        if !self.is_enabled() {
            return NEVER;
        }
        let left = self.counts().saturating_sub(u64::from(self.counter)).max(1);
        (self.base_sixteenth + left * self.divisor()).div_ceil(16)
    }

    fn rebase(&mut self, now: u64) {
        self.counter = self.count(now);
        self.base_sixteenth = now * 16;
    }

    fn output(&self, channel: usize, sys_hz: u64) -> Output {
        let compare = u64::from(self.cc >> (16 * channel) & 0xffff);
        let inverted = self.csr & [CSR_INVERT_A, CSR_INVERT_B][channel] != 0;
        let period = u64::from(self.top & 0xffff) + 1;
        let (frequency, duty) = if self.is_enabled() {
            (sys_hz * 16 / (self.divisor() * self.counts()), (compare * 65_536 / period).min(65_536))
        } else {
            (0, if u64::from(self.counter) < compare { 65_536 } else { 0 })
        };
        let duty = if inverted { 65_536 - duty } else { duty };
        let constant = duty == 0 || duty == 65_536;
        let narrow = |value: u64| u32::try_from(value).unwrap_or(u32::MAX);
        Output { frequency_hz: if constant { 0 } else { narrow(frequency) }, duty: narrow(duty) }
    }
}

#[derive(Clone, Debug)]
pub(super) struct Pwm {
    slices: [Slice; SLICES],
    raw: u32,
    enable: u32,
    force: u32,
    /// Slices whose wraps DMA waits for.
    pub(super) wanted: u32,
    /// Wraps that DMA has not used yet, one bit per slice.
    pub(super) requests: u32,
    pub(super) next_event: u64,
}

impl Pwm {
    pub(super) fn new() -> Self {
        Self {
            slices: [Slice::RESET; SLICES],
            raw: 0,
            enable: 0,
            force: 0,
            wanted: 0,
            requests: 0,
            next_event: NEVER,
        }
    }

    /// What GPIO `pin` shows while its function is PWM.
    pub(super) fn output(&self, pin: usize, sys_hz: u64) -> Output {
        self.slices[pin / 2 % SLICES].output(pin % 2, sys_hz)
    }

    /// Sets the raw flag of each slice that has wrapped by `now`.
    pub(super) fn advance(&mut self, now: u64) {
        for (i, slice) in self.slices.iter_mut().enumerate() {
            if slice.next_wrap() <= now {
                self.raw |= 1 << i;
                self.requests |= self.wanted & 1 << i;
                let position = slice.position(now) % slice.counts();
                let used = (slice.position(now) - u64::from(slice.counter)) * slice.divisor();
                slice.counter = u32::try_from(position).unwrap_or(0);
                slice.base_sixteenth += used;
            }
        }
        self.schedule();
    }

    pub(super) fn schedule(&mut self) {
        let watched = self.enable | self.wanted;
        self.next_event = NEVER;
        for (i, slice) in self.slices.iter().enumerate() {
            if watched & 1 << i != 0 {
                self.next_event = self.next_event.min(slice.next_wrap());
            }
        }
    }

    pub(super) fn irq(&self) -> bool {
        self.raw & self.enable | self.force != 0
    }

    fn enabled(&self) -> u32 {
        (0..SLICES).fold(0, |mask, i| mask | (self.slices[i].csr & CSR_ENABLE) << i)
    }

    pub(super) fn read(&mut self, offset: u32, now: u64) -> Option<u32> {
        self.advance(now);
        if offset < 0xa0 {
            let slice = &self.slices[offset as usize / 0x14];
            return Some(match offset % 0x14 {
                0x00 => slice.csr,
                0x04 => slice.div,
                0x08 => slice.count(now),
                0x0c => slice.cc,
                0x10 => slice.top,
                _ => return None,
            });
        }
        Some(match offset {
            0xa0 => self.enabled(),
            0xa4 => self.raw,
            0xa8 => self.enable,
            0xac => self.force,
            0xb0 => self.raw & self.enable | self.force,
            _ => return None,
        })
    }

    pub(super) fn write(&mut self, offset: u32, value: u32, now: u64) -> Option<()> {
        self.advance(now);
        if offset < 0xa0 {
            let slice = &mut self.slices[offset as usize / 0x14];
            slice.rebase(now);
            match offset % 0x14 {
                0x00 if value & CSR_DIVMODE == 0 => slice.csr = value & 0x3f,
                0x04 => slice.div = value & 0xfff,
                0x08 => slice.counter = value & 0xffff,
                0x0c => slice.cc = value,
                0x10 => slice.top = value & 0xffff,
                _ => return None,
            }
        } else {
            match offset {
                0xa0 => {
                    for (i, slice) in self.slices.iter_mut().enumerate() {
                        slice.rebase(now);
                        slice.csr = slice.csr & !CSR_ENABLE | value >> i & 1;
                    }
                }
                0xa4 => self.raw &= !value,
                0xa8 => self.enable = value & 0xff,
                0xac => self.force = value & 0xff,
                0xb0 => {}
                _ => return None,
            }
        }
        self.schedule();
        Some(())
    }
}
