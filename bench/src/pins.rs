//! The border between the RP2040 and what is soldered to it.
//!
//! The engine calls a [`Board`] at exact virtual times: when an output pin changes, when an SPI frame has been
//! clocked, when a UART byte has left. The board answers by driving [`InputPins`] and by naming the next instant at
//! which it wants to be called by itself.

use crate::time::Nanos;

/// Levels that the outside drives into GPIO 0..=29; a pin that nobody drives follows the pad's pull.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct InputPins {
    levels: u32,
    driven: u32,
}

impl InputPins {
    /// Drives `pin` to `level`.
    pub fn drive(&mut self, pin: u8, level: bool) {
        self.driven |= 1 << pin;
        self.levels = self.levels & !(1 << pin) | u32::from(level) << pin;
    }

    /// Lets `pin` float.
    pub fn release(&mut self, pin: u8) {
        self.driven &= !(1 << pin);
    }

    /// Bit n = the level driven into GPIO n (meaningful where [`Self::driven`] is set).
    pub fn levels(&self) -> u32 {
        self.levels
    }

    /// Bit n = GPIO n is driven from outside.
    pub fn driven(&self) -> u32 {
        self.driven
    }
}

/// What sits on the RP2040's pins. Every call carries the virtual time at which it happens; times never go back.
pub trait Board {
    /// The RP2040 drives `pin` to `level` (called on change only; a pin that stops being driven is not reported).
    fn pin_out(&mut self, now: Nanos, pin: u8, level: bool, inputs: &mut InputPins);

    /// SPI `port` (0 or 1) has clocked one frame of `bits` bits (4..=16) out; `now` is the end of its last bit.
    /// Returns the word that came back on MISO (0xFFFF-filled when nobody is selected).
    fn spi_frame(&mut self, now: Nanos, port: u8, word: u16, bits: u8, inputs: &mut InputPins) -> u16;

    /// UART `port` has sent `byte`; `now` is the end of its stop bit.
    fn uart_byte(&mut self, now: Nanos, port: u8, byte: u8);

    /// PWM output on `pin` changed to `frequency_hz` with `duty` of 65536 high (0 = constantly low).
    fn pwm(&mut self, now: Nanos, pin: u8, frequency_hz: u32, duty: u32);

    /// The supply of the chip fails (`false`) or comes back: what on the board hangs on the same supply forgets.
    fn power(&mut self, _now: Nanos, _on: bool, _inputs: &mut InputPins) {}

    /// The next instant at which the board changes by itself, if any.
    fn next_event(&self) -> Option<Nanos>;

    /// Brings the board up to `now`.
    fn advance(&mut self, now: Nanos, inputs: &mut InputPins);
}
