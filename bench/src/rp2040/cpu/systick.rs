//! SysTick: the 24-bit down counter inside the core.
//!
//! Owns SYST_CSR, SYST_RVR and SYST_CVR and counts in closed form, so that a sleeping core may skip any number of
//! cycles. The period is reload + 1 cycles. It raises nothing itself: [`SysTick::advance`] says that the counter
//! reached zero with TICKINT set.
//!
//! Source: ARMv6-M Architecture Reference Manual, B3.3. Not supported: the 1 us reference clock (CLKSOURCE = 0).

const ENABLE: u32 = 1 << 0;
const TICKINT: u32 = 1 << 1;
const CLKSOURCE: u32 = 1 << 2;
const COUNTFLAG: u32 = 1 << 16;
const COUNTER_MASK: u32 = 0x00FF_FFFF;

/// The counter and its registers.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct SysTick {
    enabled: bool,
    interrupt: bool,
    processor_clock: bool,
    count_flag: bool,
    reload: u32,
    current: u32,
}

impl SysTick {
    /// Counts `cycles` down; `true` when the exception is to be pended.
    #[inline(always)]
    pub(super) fn advance(&mut self, cycles: u64) -> bool {
        if !self.enabled {
            return false;
        }
        if cycles < u64::from(self.current) {
            #[expect(clippy::cast_possible_truncation, reason = "smaller than the 24-bit counter")]
            let cycles = cycles as u32;
            self.current -= cycles;
            return false;
        }
        self.wrap(cycles)
    }

    /// The rest of [`Self::advance`]: the counter reaches zero or stands there.
    #[cold]
    fn wrap(&mut self, cycles: u64) -> bool {
        let mut reached_zero = self.current != 0;
        let after_zero = cycles - u64::from(self.current);
        self.current = 0;
        if self.reload != 0 {
            let period = u64::from(self.reload) + 1;
            reached_zero |= after_zero >= period;
            let phase = after_zero % period;
            #[expect(clippy::cast_possible_truncation, reason = "at most the 24-bit reload value")]
            let current = if phase == 0 { 0 } else { (period - phase) as u32 };
            self.current = current;
        }
        self.count_flag |= reached_zero;
        reached_zero && self.interrupt
    }

    /// Cycles until the exception is pended; `None` when it never is.
    pub(super) fn cycles_to_interrupt(&self) -> Option<u64> {
        match (self.enabled && self.interrupt, self.current, self.reload) {
            (false, _, _) | (true, 0, 0) => None,
            (true, 0, reload) => Some(u64::from(reload) + 1),
            (true, current, _) => Some(u64::from(current)),
        }
    }

    /// Reads SYST_CSR, which clears COUNTFLAG.
    pub(super) fn read_control(&mut self) -> u32 {
        let flag = std::mem::take(&mut self.count_flag);
        (if self.enabled { ENABLE } else { 0 })
            | (if self.interrupt { TICKINT } else { 0 })
            | (if self.processor_clock { CLKSOURCE } else { 0 })
            | (if flag { COUNTFLAG } else { 0 })
    }

    /// Writes SYST_CSR; `false` when it asks for the reference clock, which is not modelled.
    #[must_use]
    pub(super) fn write_control(&mut self, value: u32) -> bool {
        self.enabled = value & ENABLE != 0;
        self.interrupt = value & TICKINT != 0;
        self.processor_clock = value & CLKSOURCE != 0;
        self.processor_clock || !self.enabled
    }

    pub(super) const fn reload(&self) -> u32 {
        self.reload
    }

    pub(super) fn write_reload(&mut self, value: u32) {
        self.reload = value & COUNTER_MASK;
    }

    pub(super) const fn current(&self) -> u32 {
        self.current
    }

    /// Any write to SYST_CVR clears the counter and COUNTFLAG; it neither counts as reaching zero nor pends.
    pub(super) fn clear_current(&mut self) {
        self.current = 0;
        self.count_flag = false;
    }
}
