//! ADC: one-shot, free running and round robin, with its sample FIFO.
//!
//! A conversion takes 96 cycles of clk_adc; DIV paces free running conversions. The inputs are settable voltages;
//! channel 4 is the temperature sensor, at [`TEMPERATURE_MILLIVOLTS`] unless set.
//!
//! Source: RP2040 datasheet 4.9 (the FIFO has 8 entries there; LEVEL has the four bits that 8 needs).
//!
//! Not modelled: noise, non-linearity (erratum RP2040-E11), conversion errors.

use super::fifo::Fifo;

const NEVER: u64 = u64::MAX;
const CONVERSION_CLOCKS: u64 = 96;
const REFERENCE_MILLIVOLTS: u32 = 3300;
/// Temperature sensor at 27 degrees Celsius.
const TEMPERATURE_MILLIVOLTS: u32 = 706;
const CS_ENABLE: u32 = 1 << 0;
const CS_START_ONCE: u32 = 1 << 2;
const CS_START_MANY: u32 = 1 << 3;
const CS_READY: u32 = 1 << 8;
const FCS_ENABLE: u32 = 1 << 0;
const FCS_SHIFT: u32 = 1 << 1;
const FCS_DREQ: u32 = 1 << 3;
const FCS_UNDER: u32 = 1 << 10;
const FCS_OVER: u32 = 1 << 11;

#[derive(Clone, Debug)]
pub(super) struct Adc {
    cs: u32,
    fcs: u32,
    div: u32,
    result: u32,
    enable: u32,
    force: u32,
    fifo: Fifo<8>,
    millivolts: [u32; 5],
    started_at: u64,
    clocks: (u64, u64),
    pub(super) next_event: u64,
}

impl Adc {
    pub(super) fn new(sys_hz: u64, adc_hz: u64) -> Self {
        Self {
            cs: 0,
            fcs: 0,
            div: 0,
            result: 0,
            enable: 0,
            force: 0,
            fifo: Fifo::new(),
            millivolts: [0, 0, 0, 0, TEMPERATURE_MILLIVOLTS],
            started_at: 0,
            clocks: (sys_hz, adc_hz),
            next_event: NEVER,
        }
    }

    pub(super) fn reset(&mut self) {
        *self = Self { millivolts: self.millivolts, ..Self::new(self.clocks.0, self.clocks.1) };
    }

    pub(super) fn set_clocks(&mut self, sys_hz: u64, adc_hz: u64) {
        self.clocks = (sys_hz, adc_hz);
    }

    /// Puts `millivolts` on `channel` (0 to 3 = GPIO 26 to 29, 4 = temperature sensor).
    pub(super) fn set_input(&mut self, channel: usize, millivolts: u32) {
        if let Some(input) = self.millivolts.get_mut(channel) {
            *input = millivolts;
        }
    }

    fn cycles(&self, adc_clocks: u64) -> Option<u64> {
        let (sys, adc) = self.clocks;
        (sys * adc_clocks).checked_div(adc)
    }

    fn channel(&self) -> usize {
        (self.cs >> 12 & 7) as usize
    }

    fn begin(&mut self, at: u64) {
        if self.cs & CS_ENABLE != 0
            && let Some(cycles) = self.cycles(CONVERSION_CLOCKS)
        {
            self.started_at = at;
            self.next_event = at + cycles;
        }
    }

    /// Ends the conversion that is due at `now`.
    pub(super) fn advance(&mut self, now: u64) {
        if now < self.next_event {
            return;
        }
        let end = self.next_event;
        self.next_event = NEVER;
        let millivolts = self.millivolts.get(self.channel()).copied().unwrap_or(0);
        let sensor_off = self.channel() == 4 && self.cs & 2 == 0;
        self.result = if sensor_off { 0 } else { (millivolts * 4096 / REFERENCE_MILLIVOLTS).min(4095) };
        if self.fcs & FCS_ENABLE != 0 {
            let shift = if self.fcs & FCS_SHIFT != 0 { 4 } else { 0 };
            if !self.fifo.push((self.result >> shift & 0xfff) as u16) {
                self.fcs |= FCS_OVER;
            }
        }
        self.select_next();
        if self.cs & CS_START_MANY != 0 {
            // DIV counts from start to start; a period below one conversion runs back to back.
            let period = u64::from(self.div >> 8) + 1;
            let start = match self.cycles(period) {
                Some(cycles) if self.div >> 8 != 0 => end.max(self.started_at + cycles),
                _ => end,
            };
            self.begin(start);
        }
    }

    fn select_next(&mut self) {
        let round_robin = self.cs >> 16 & 0x1f;
        if round_robin == 0 {
            return;
        }
        let channel = self.channel() as u32;
        let next = (1..=5).map(|step| (channel + step) % 5).find(|next| round_robin & 1 << next != 0);
        self.cs = self.cs & !(7 << 12) | next.unwrap_or(channel) << 12;
    }

    fn has_samples(&self) -> bool {
        let threshold = (self.fcs >> 24 & 0xf) as usize;
        self.fcs & FCS_ENABLE != 0 && self.fifo.len() >= threshold.max(1)
    }

    pub(super) fn irq(&self) -> bool {
        u32::from(self.has_samples()) & self.enable | self.force != 0
    }

    pub(super) fn requests(&self) -> u32 {
        u32::from(self.fcs & FCS_DREQ != 0 && self.has_samples())
    }

    pub(super) fn read_fifo(&mut self) -> u32 {
        match self.fifo.pop() {
            Some(sample) => u32::from(sample),
            None => {
                self.fcs |= FCS_UNDER;
                0
            }
        }
    }

    pub(super) fn read(&mut self, offset: u32) -> Option<u32> {
        let raw = u32::from(self.has_samples());
        Some(match offset {
            0x00 => {
                let ready = self.cs & CS_ENABLE != 0 && self.next_event == NEVER;
                self.cs | if ready { CS_READY } else { 0 }
            }
            0x04 => self.result,
            0x08 => {
                let level = (self.fifo.len() as u32) << 16;
                self.fcs | u32::from(self.fifo.is_empty()) << 8 | u32::from(self.fifo.is_full()) << 9 | level
            }
            0x0c => self.read_fifo(),
            0x10 => self.div,
            0x14 => raw,
            0x18 => self.enable,
            0x1c => self.force,
            0x20 => raw & self.enable | self.force,
            _ => return None,
        })
    }

    pub(super) fn write(&mut self, offset: u32, value: u32, now: u64) -> Option<()> {
        match offset {
            0x00 => {
                self.cs = value & 0x001f_700b;
                if self.cs & CS_ENABLE == 0 {
                    self.next_event = NEVER;
                } else if value & (CS_START_ONCE | CS_START_MANY) != 0 && self.next_event == NEVER {
                    self.begin(now);
                }
            }
            0x08 => {
                let cleared = value & (FCS_UNDER | FCS_OVER);
                self.fcs = value & 0x0f00_000f | self.fcs & (FCS_UNDER | FCS_OVER) & !cleared;
            }
            0x04 | 0x0c | 0x14 | 0x20 => {}
            0x10 => self.div = value & 0x00ff_ffff,
            0x18 => self.enable = value & 1,
            0x1c => self.force = value & 1,
            _ => return None,
        }
        Some(())
    }
}
