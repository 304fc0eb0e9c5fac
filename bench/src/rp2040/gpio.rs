//! GPIO 0 to 29: SIO outputs, function select, pads and pin interrupts.
//!
//! Owns IO_BANK0, PADS_BANK0 and the GPIO registers of SIO. A pin reads what drives it: the chip's own output, else the
//! outside, else the pad's pull; and 0 while the pad's input is disabled. Edge interrupts latch until written, level
//! interrupts follow the pin.
//!
//! Source: RP2040 datasheet 2.19 (GPIO), 2.3.1.2 (SIO GPIO).
//!
//! Not modelled: waveforms of SPI, UART and PWM pins as levels (such a pin reads its pull), drive strength and slew, the
//! input synchronisers' two cycles, the interrupts of core 1 and of dormant wake (plain storage).

use crate::pins::InputPins;

/// Number of pins in the bank.
pub(super) const PINS: usize = 30;
const ALL: u32 = (1 << PINS) - 1;
const PAD_RESET: u32 = 0x56;
const CTRL_RESET: u32 = 0x1f;
const FUNCTION_SIO: u32 = 5;

/// Four masks of pins, one per value of a two-bit override field.
#[derive(Clone, Copy, Debug, Default)]
struct Overrides {
    invert: u32,
    low: u32,
    high: u32,
}

impl Overrides {
    fn set(&mut self, pin: usize, field: u32) {
        let bit = 1 << pin;
        self.invert = self.invert & !bit | if field == 1 { bit } else { 0 };
        self.low = self.low & !bit | if field == 2 { bit } else { 0 };
        self.high = self.high & !bit | if field == 3 { bit } else { 0 };
    }

    fn apply(self, value: u32) -> u32 {
        (value ^ self.invert) & !self.low | self.high
    }
}

#[derive(Clone, Debug)]
pub(super) struct Gpio {
    out: u32,
    oe: u32,
    ctrl: [u32; PINS],
    pads: [u32; PINS],
    voltage: u32,
    swd_pads: [u32; 2],
    sio: u32,
    out_over: Overrides,
    oe_over: Overrides,
    in_over: Overrides,
    irq_over: Overrides,
    input_enable: u32,
    output_disable: u32,
    pull_up: u32,
    driven_outside: u32,
    outside: u32,
    /// Level of the pads after input enable.
    level: u32,
    edges: [u32; 2],
    enable: [u32; 4],
    force: [u32; 4],
    unused: [u32; 24],
    reported: u32,
    ever_reported: u32,
    irq: bool,
}

impl Gpio {
    pub(super) fn new() -> Self {
        let mut gpio = Self {
            out: 0,
            oe: 0,
            ctrl: [CTRL_RESET; PINS],
            pads: [PAD_RESET; PINS],
            voltage: 0,
            swd_pads: [0xda, 0x5a],
            sio: 0,
            out_over: Overrides::default(),
            oe_over: Overrides::default(),
            in_over: Overrides::default(),
            irq_over: Overrides::default(),
            input_enable: 0,
            output_disable: 0,
            pull_up: 0,
            driven_outside: 0,
            outside: 0,
            level: 0,
            edges: [0; 2],
            enable: [0; 4],
            force: [0; 4],
            unused: [0; 24],
            reported: 0,
            ever_reported: 0,
            irq: false,
        };
        gpio.derive();
        gpio
    }

    /// Resets IO_BANK0.
    pub(super) fn reset_bank(&mut self) {
        self.ctrl = [CTRL_RESET; PINS];
        self.edges = [0; 2];
        self.enable = [0; 4];
        self.force = [0; 4];
        self.unused = [0; 24];
        self.derive();
    }

    /// Resets PADS_BANK0.
    pub(super) fn reset_pads(&mut self) {
        self.pads = [PAD_RESET; PINS];
        self.voltage = 0;
        self.derive();
    }

    /// Resets the SIO outputs.
    pub(super) fn reset_sio(&mut self) {
        self.out = 0;
        self.oe = 0;
        self.settle();
    }

    /// The pin's FUNCSEL.
    pub(super) fn function(&self, pin: usize) -> u32 {
        self.ctrl[pin] & 0x1f
    }

    /// Whether the pad's input buffer is on.
    pub(super) fn has_input(&self, pin: usize) -> bool {
        self.input_enable & 1 << pin != 0
    }

    fn derive(&mut self) {
        self.sio = 0;
        (self.input_enable, self.output_disable, self.pull_up) = (0, 0, 0);
        for pin in 0..PINS {
            let (bit, ctrl, pad) = (1 << pin, self.ctrl[pin], self.pads[pin]);
            self.sio |= if ctrl & 0x1f == FUNCTION_SIO { bit } else { 0 };
            self.out_over.set(pin, ctrl >> 8 & 3);
            self.oe_over.set(pin, ctrl >> 12 & 3);
            self.in_over.set(pin, ctrl >> 16 & 3);
            self.irq_over.set(pin, ctrl >> 28 & 3);
            self.input_enable |= if pad & 1 << 6 != 0 { bit } else { 0 };
            self.output_disable |= if pad & 1 << 7 != 0 { bit } else { 0 };
            self.pull_up |= if pad & 1 << 3 != 0 { bit } else { 0 };
        }
        self.settle();
    }

    fn driven_level(&self) -> u32 {
        self.out_over.apply(self.out & self.sio) & ALL
    }

    fn driving(&self) -> u32 {
        self.oe_over.apply(self.oe & self.sio) & !self.output_disable & ALL
    }

    fn settle(&mut self) {
        let driving = self.driving();
        let outside = self.driven_outside & self.outside | !self.driven_outside & self.pull_up;
        let level = (driving & self.driven_level() | !driving & outside) & self.input_enable & ALL;
        self.edges[0] |= self.level & !level;
        self.edges[1] |= level & !self.level;
        self.level = level;
        self.derive_irq();
    }

    fn derive_irq(&mut self) {
        self.irq = self.status().iter().any(|mask| *mask != 0);
    }

    /// Takes what the outside drives; `true` if anything changed.
    #[inline]
    pub(super) fn set_inputs(&mut self, inputs: &InputPins) -> bool {
        if inputs.levels() == self.outside && inputs.driven() == self.driven_outside {
            return false;
        }
        self.outside = inputs.levels();
        self.driven_outside = inputs.driven();
        self.settle();
        true
    }

    /// Outputs that changed since the last call: mask of pins and their levels.
    pub(super) fn take_changed_outputs(&mut self) -> (u32, u32) {
        let (driving, level) = (self.driving(), self.driven_level());
        let changed = driving & (level ^ self.reported | !self.ever_reported);
        self.reported = self.reported & !changed | level & changed;
        self.ever_reported |= changed;
        (changed, level)
    }

    fn raw(&self) -> [u32; 4] {
        let level = self.irq_over.apply(self.level);
        [!level & ALL, level & ALL, self.edges[0], self.edges[1]]
    }

    fn status(&self) -> [u32; 4] {
        let raw = self.raw();
        [0, 1, 2, 3].map(|kind| raw[kind] & self.enable[kind] | self.force[kind])
    }

    /// Level of IO_IRQ_BANK0.
    #[inline]
    pub(super) fn irq(&self) -> bool {
        self.irq
    }

    pub(super) fn read_sio(&self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x04 => self.in_over.apply(self.level) & ALL,
            0x08 => 0x3e, // QSPI pins at rest: chip select and data high
            0x10..=0x1c => self.out,
            0x20..=0x2c => self.oe,
            0x30..=0x4c => 0,
            _ => return None,
        })
    }

    pub(super) fn write_sio(&mut self, offset: u32, value: u32) -> Option<()> {
        let value = value & ALL;
        match offset {
            0x10 => self.out = value,
            0x14 => self.out |= value,
            0x18 => self.out &= !value,
            0x1c => self.out ^= value,
            0x20 => self.oe = value,
            0x24 => self.oe |= value,
            0x28 => self.oe &= !value,
            0x2c => self.oe ^= value,
            _ => return None,
        }
        self.settle();
        Some(())
    }

    pub(super) fn read_bank(&self, offset: u32) -> Option<u32> {
        let register = (offset as usize >> 2) % 4;
        Some(match offset {
            0x000..=0x0ef if offset & 4 == 0 => self.pin_status(offset as usize / 8),
            0x000..=0x0ef => self.ctrl[offset as usize / 8],
            0x0f0..=0x0ff => pack(self.raw(), register),
            0x100..=0x10f => pack(self.enable, register),
            0x110..=0x11f => pack(self.force, register),
            0x120..=0x12f => pack(self.status(), register),
            0x130..=0x18f => self.unused[(offset as usize - 0x130) / 4],
            _ => return None,
        })
    }

    fn pin_status(&self, pin: usize) -> u32 {
        let bit = |mask: u32, at: u32| (mask >> pin & 1) << at;
        let interrupt = self.status().iter().fold(0, |any, mask| any | mask);
        bit(self.out & self.sio, 8)
            | bit(self.driven_level(), 9)
            | bit(self.oe & self.sio, 12)
            | bit(self.driving(), 13)
            | bit(self.level, 17)
            | bit(self.in_over.apply(self.level), 19)
            | bit(interrupt, 24)
            | bit(interrupt, 26)
    }

    pub(super) fn write_bank(&mut self, offset: u32, value: u32) -> Option<()> {
        let register = (offset as usize >> 2) % 4;
        match offset {
            0x000..=0x0ef if offset & 4 == 0 => {}
            0x000..=0x0ef => {
                self.ctrl[offset as usize / 8] = value & 0x3003_331f;
                self.derive();
            }
            0x0f0..=0x0ff => {
                let [_, _, low, high] = unpack(value, register);
                self.edges[0] &= !low;
                self.edges[1] &= !high;
            }
            0x100..=0x10f => replace(&mut self.enable, value, register),
            0x110..=0x11f => replace(&mut self.force, value, register),
            0x120..=0x12f => {}
            0x130..=0x18f => self.unused[(offset as usize - 0x130) / 4] = value,
            _ => return None,
        }
        self.derive_irq();
        Some(())
    }

    pub(super) fn read_pads(&self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x00 => self.voltage,
            0x04..=0x78 => self.pads[offset as usize / 4 - 1],
            0x7c => self.swd_pads[0],
            0x80 => self.swd_pads[1],
            _ => return None,
        })
    }

    pub(super) fn write_pads(&mut self, offset: u32, value: u32) -> Option<()> {
        match offset {
            0x00 => self.voltage = value & 1,
            0x04..=0x78 => {
                self.pads[offset as usize / 4 - 1] = value & 0xff;
                self.derive();
            }
            0x7c => self.swd_pads[0] = value & 0xff,
            0x80 => self.swd_pads[1] = value & 0xff,
            _ => return None,
        }
        Some(())
    }
}

/// Four masks of pins -> the nibbles of eight pins.
fn pack(masks: [u32; 4], register: usize) -> u32 {
    let mut word = 0;
    for pin in 0..8 {
        for (kind, mask) in masks.iter().enumerate() {
            word |= (mask >> (8 * register + pin) & 1) << (4 * pin + kind);
        }
    }
    word
}

/// The nibbles of eight pins -> four masks of pins.
fn unpack(word: u32, register: usize) -> [u32; 4] {
    let mut masks = [0; 4];
    for pin in 0..8 {
        for (kind, mask) in masks.iter_mut().enumerate() {
            *mask |= (word >> (4 * pin + kind) & 1) << (8 * register + pin);
        }
    }
    masks.map(|mask| mask & ALL)
}

fn replace(masks: &mut [u32; 4], word: u32, register: usize) {
    let pins = 0xff << (8 * register);
    for (mask, new) in masks.iter_mut().zip(unpack(word, register)) {
        *mask = *mask & !pins | new;
    }
}
