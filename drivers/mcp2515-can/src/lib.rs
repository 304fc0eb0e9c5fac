//! MCP2515 CAN controller: one transaction per frame, nothing lost uncounted.
//!
//! A frame costs 16 SPI bytes (one RX STATUS, one READ RX BUFFER), is never acknowledged twice, and the two receive
//! buffers are emptied in the order of arrival. A start reads back all that it has written: over a bad contact it is
//! refused and says what was expected and read.
//!
//! Register names come from the `mcp2515` crate, which is also the second witness for masks and filters. Its driver is
//! not used: it panics on answers that no MCP2515 gives, waits 5 ms after a reset and reads nothing back.
//!
//! From pure to bound: [`timing`], [`acceptance`], [`frame`] and [`irq`] are functions of their arguments, [`cmd`] has
//! one method per SPI instruction, [`driver`] owns the chip.
//!
//! INT is a level, low while any enabled flag is set. The application uses a level interrupt: call
//! [`Mcp2515::service`] in it, and mask it until the next tick when [`Serviced::drained`] is false.
//!
//! Source: Microchip DS20001801 (register and section numbers in the code), errata DS80179.
//! Not supported: one-shot mode, sleep, CLKOUT, the RXnBF and TXnRTS pins, TXB1 and TXB2 (errata 2).

#![no_std]
#![forbid(unsafe_code)]

pub mod acceptance;
pub mod cmd;
pub mod driver;
pub mod frame;
pub mod irq;
pub mod regs;
pub mod timing;

pub use acceptance::Acceptance;
pub use driver::{
    Config, Health, Mcp2515, Mode, Oscillator, Refusals, Refused, Serviced, StartError, TransmitError,
};
pub use irq::BusState;
pub use timing::{BitTiming, TimingError};
