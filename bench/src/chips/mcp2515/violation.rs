//! Ways to misuse the MCP2515, or to go beyond its model.
//!
//! Each text says what to do. Source: DS20001801J, errata DS80179G.

use std::fmt;

use super::timing::TimingFault;
use crate::time::Nanos;

/// A way in which the chip must not be used, or that this model does not know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Violation {
    /// Selected before the oscillator had started; the instruction was lost.
    NotStarted,
    /// A byte within less than 800 ns: SPI clock above 10 MHz.
    SpiTooFast {
        /// Time between the ends of two bytes.
        byte: Nanos,
    },
    /// CS was high for less than 50 ns.
    PauseTooShort,
    /// Bytes were clocked with CS high and reached nobody.
    NotSelected,
    /// No such instruction.
    UnknownInstruction(u8),
    /// CS rose before the instruction had all its bytes.
    Incomplete(u8),
    /// The address has eight bits.
    AddressOutOfRange(u8),
    /// Written, but cannot be.
    ReadOnly(u8),
    /// Written outside configuration mode; the write was lost.
    OutsideConfiguration(u8),
    /// A transmit buffer was written while its request was pending; the write was lost.
    BufferPending(u8),
    /// CANCTRL.REQOP asks for sleep, which is not modelled, or for a mode that does not exist.
    ModeNotModelled(u8),
    /// TXRTSCTRL makes request pins of TXnRTS, which are not modelled.
    RequestPins(u8),
    /// RXM 01 or 10, reserved since revision J.
    ReservedReceiveMode(u8),
    /// The bit timing breaks a rule.
    Timing(TimingFault),
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotStarted => {
                write!(f, "MCP2515 selected before its oscillator had started: wait 128 clocks")
            }
            Self::SpiTooFast { byte } => {
                write!(f, "MCP2515 clocked a byte in {} ns: 10 MHz is the limit", byte.0)
            }
            Self::PauseTooShort => write!(f, "MCP2515 CS high for less than 50 ns"),
            Self::NotSelected => write!(f, "byte clocked while no CS was low"),
            Self::UnknownInstruction(code) => write!(f, "MCP2515 has no instruction {code:#04x}"),
            Self::Incomplete(code) => write!(f, "MCP2515 instruction {code:#04x} cut off by CS"),
            Self::AddressOutOfRange(address) => write!(f, "MCP2515 has no register {address:#04x}"),
            Self::ReadOnly(address) => write!(f, "MCP2515 register {address:#04x} cannot be written"),
            Self::OutsideConfiguration(address) => {
                write!(f, "MCP2515 register {address:#04x} can be written in configuration mode only")
            }
            Self::BufferPending(address) => {
                write!(f, "MCP2515 register {address:#04x} written while its transmit request was pending")
            }
            Self::ModeNotModelled(canctrl) => {
                write!(f, "MCP2515 mode request {:#05b} is not modelled", canctrl >> 5)
            }
            Self::RequestPins(value) => write!(f, "MCP2515 TXRTSCTRL = {value:#04x}: pins are not modelled"),
            Self::ReservedReceiveMode(control) => {
                write!(f, "MCP2515 RXM {:#04b} is reserved: use 00 or 11", control >> 5 & 0b11)
            }
            Self::Timing(fault) => write!(f, "MCP2515 bit timing: {fault:?}"),
        }
    }
}
