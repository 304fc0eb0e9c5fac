//! Ways to misuse a panel, or to go beyond its model.
//!
//! Each text says what to do. Source: ILI9341 V1.11, ST7789V V1.4.

use std::fmt;

use crate::time::Nanos;

/// A way in which the panel must not be used, or that this model does not know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Violation {
    /// A command within a forbidden wait.
    TooSoon {
        /// The command.
        command: u8,
        /// How long it should have waited.
        early: Nanos,
    },
    /// The reset pin was low for less than 10 us; the reset was ignored.
    ResetTooShort(Nanos),
    /// A word was clocked while the reset pin was low.
    InReset,
    /// Not a command of this controller.
    UnknownCommand(u8),
    /// A command that exists and is not modelled.
    NotModelled(u8),
    /// A parameter that would change the picture in a way that is not modelled.
    ParameterNotModelled {
        /// The command.
        command: u8,
        /// The parameter byte.
        value: u8,
    },
    /// A window that ends before it starts or outside the memory; it was ignored.
    Window {
        /// CASET or RASET.
        command: u8,
        /// First address.
        start: u16,
        /// Last address.
        end: u16,
    },
    /// Pixels while COLMOD is not 16 bits per pixel; they were ignored.
    PixelFormat(u8),
    /// Data for a command that takes none, or too much of it.
    UnexpectedData {
        /// The command.
        command: u8,
    },
    /// A word of other than 8 or 16 bits.
    WordSize(u8),
    /// A word was clocked while not selected.
    NotSelected,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooSoon { command, early } => {
                write!(f, "panel command {command:#04x} came {} us too soon", early.as_micros())
            }
            Self::ResetTooShort(low) => write!(f, "panel reset low for {} ns: 10 us is the least", low.0),
            Self::InReset => write!(f, "panel was sent a word while its reset pin was low"),
            Self::UnknownCommand(command) => write!(f, "panel has no command {command:#04x}"),
            Self::NotModelled(command) => write!(f, "panel command {command:#04x} is not modelled"),
            Self::ParameterNotModelled { command, value } => {
                write!(f, "panel command {command:#04x} with parameter {value:#04x} is not modelled")
            }
            Self::Window { command, start, end } => {
                write!(f, "panel window {command:#04x} from {start} to {end} does not fit the memory")
            }
            Self::PixelFormat(format) => {
                write!(f, "panel got pixels with COLMOD {format:#04x}: send COLMOD 0x55 first")
            }
            Self::UnexpectedData { command } => {
                write!(f, "panel got data that command {command:#04x} does not take")
            }
            Self::WordSize(bits) => write!(f, "panel got a word of {bits} bits: 8 or 16 are modelled"),
            Self::NotSelected => write!(f, "panel was sent a word while CS was high"),
        }
    }
}
