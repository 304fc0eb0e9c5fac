//! TIMER: the 64-bit microsecond counter and its four alarms.
//!
//! The counter advances on the watchdog's tick. An alarm fires when the low word of the counter equals it, hence never
//! early; an alarm written with the present count fires at once.
//!
//! Source: RP2040 datasheet 4.6.
//!
//! Not modelled: DBGPAUSE (there is no debugger).

use super::clocks::Ratio;

const NEVER: u64 = u64::MAX;

#[derive(Clone, Debug)]
pub(super) struct Timer {
    /// Count at `base_cycle`, which lies on a tick.
    base_count: u64,
    base_cycle: u64,
    tick: Option<Ratio>,
    written_low: u32,
    latched_high: u32,
    alarms: [u32; 4],
    armed: u32,
    raw: u32,
    enable: u32,
    force: u32,
    paused: bool,
    dbgpause: u32,
}

impl Timer {
    pub(super) fn new(now: u64, tick: Option<Ratio>) -> Self {
        Self {
            base_count: 0,
            base_cycle: now,
            tick,
            written_low: 0,
            latched_high: 0,
            alarms: [0; 4],
            armed: 0,
            raw: 0,
            enable: 0,
            force: 0,
            paused: false,
            dbgpause: 7,
        }
    }

    fn running(&self) -> Option<Ratio> {
        if self.paused { None } else { self.tick }
    }

    fn count(&self, now: u64) -> u64 {
        match self.running() {
            Some(tick) => self.base_count.wrapping_add(tick.ticks_in(now - self.base_cycle)),
            None => self.base_count,
        }
    }

    /// Changes what the count follows from; the count itself does not jump.
    fn rebase(&mut self, now: u64) {
        if let Some(tick) = self.running() {
            let ticks = tick.ticks_in(now - self.base_cycle);
            self.base_count = self.base_count.wrapping_add(ticks);
            self.base_cycle += tick.cycles_for(ticks);
        } else {
            self.base_cycle = now;
        }
    }

    /// The tick's rate has changed.
    pub(super) fn set_tick(&mut self, now: u64, tick: Option<Ratio>) {
        if tick == self.tick {
            return;
        }
        self.rebase(now);
        self.base_cycle = now;
        self.tick = tick;
    }

    /// The cycle at which the next alarm fires.
    pub(super) fn next_event(&self) -> u64 {
        let Some(tick) = self.running() else { return NEVER };
        if self.armed == 0 {
            return NEVER;
        }
        let mut next = NEVER;
        for alarm in 0..4 {
            if self.armed & 1 << alarm != 0 {
                // The base count itself may be the match.
                let ticks = u64::from(self.alarms[alarm].wrapping_sub(low(self.base_count)));
                next = next.min(self.base_cycle.saturating_add(tick.cycles_for(ticks)));
            }
        }
        next
    }

    /// Fires the alarms that are due at `now`.
    pub(super) fn advance(&mut self, now: u64) {
        let Some(tick) = self.running() else { return };
        let passed = tick.ticks_in(now - self.base_cycle);
        for alarm in 0..4 {
            let due = u64::from(self.alarms[alarm].wrapping_sub(low(self.base_count)));
            if self.armed & 1 << alarm != 0 && due <= passed {
                self.armed &= !(1 << alarm);
                self.raw |= 1 << alarm;
            }
        }
        self.rebase(now);
    }

    /// Levels of TIMER_IRQ_0 to 3.
    pub(super) fn irqs(&self) -> u32 {
        self.raw & self.enable | self.force
    }

    pub(super) fn read(&mut self, offset: u32, now: u64) -> Option<u32> {
        Some(match offset {
            0x00 | 0x04 => 0,
            0x08 => self.latched_high,
            0x0c => {
                let count = self.count(now);
                self.latched_high = high(count);
                low(count)
            }
            0x10..=0x1c => self.alarms[(offset as usize - 0x10) / 4],
            0x20 => self.armed,
            0x24 => high(self.count(now)),
            0x28 => low(self.count(now)),
            0x2c => self.dbgpause,
            0x30 => u32::from(self.paused),
            0x34 => self.raw,
            0x38 => self.enable,
            0x3c => self.force,
            0x40 => self.irqs(),
            _ => return None,
        })
    }

    pub(super) fn write(&mut self, offset: u32, value: u32, now: u64) -> Option<()> {
        self.advance(now);
        match offset {
            0x00 => {
                self.base_count = u64::from(value) << 32 | u64::from(self.written_low);
                self.base_cycle = now;
            }
            0x04 => self.written_low = value,
            0x08 | 0x0c | 0x24 | 0x28 | 0x40 => {}
            0x10..=0x1c => {
                let alarm = (offset as usize - 0x10) / 4;
                self.alarms[alarm] = value;
                self.armed |= 1 << alarm;
                self.advance(now);
            }
            0x20 => self.armed &= !value,
            0x2c => self.dbgpause = value & 6,
            0x30 => {
                self.rebase(now);
                self.paused = value & 1 != 0;
                self.base_cycle = now;
            }
            0x34 => self.raw &= !value,
            0x38 => self.enable = value & 0xf,
            0x3c => self.force = value & 0xf,
            _ => return None,
        }
        Some(())
    }
}

fn low(count: u64) -> u32 {
    count as u32
}

fn high(count: u64) -> u32 {
    low(count >> 32)
}
