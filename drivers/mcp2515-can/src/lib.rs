//! MCP2515 CAN controller: one transaction per frame, nothing lost uncounted.
//!
//! Start-up, modes and filters go through the `mcp2515` crate; bit timing, reception, transmission and error handling
//! are done here, because a frame must cost 16 SPI bytes (one RX STATUS, one READ RX BUFFER), must never be
//! acknowledged twice, and the two receive buffers must be emptied in the order of arrival.
//!
//! From pure to bound: [`timing`], [`frame`] and [`irq`] are functions of their arguments, [`cmd`] has one method per
//! SPI instruction, [`driver`] owns the chip.
//!
//! INT is a level, low while any enabled flag is set. The application uses a level interrupt: call
//! [`Mcp2515::service`] in it, and mask it until the next tick when [`Serviced::drained`] is false.
//!
//! Source: Microchip DS20001801 (register and section numbers in the code), errata DS80179.
//! Not supported: one-shot mode, sleep, CLKOUT, the RXnBF and TXnRTS pins, TXB1 and TXB2 (errata 2).

#![no_std]
#![forbid(unsafe_code)]

pub mod cmd;
pub mod driver;
pub mod frame;
pub mod irq;
pub mod regs;
pub mod timing;

pub use driver::{
    Acceptance, Config, Health, Mcp2515, Mode, Oscillator, Refused, Serviced, StartError, TransmitError,
};
pub use irq::BusState;
pub use timing::{BitTiming, TimingError};
