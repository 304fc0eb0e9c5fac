//! What a `mipidsi` model sends at start-up, recorded instead of sent.
//!
//! The model believes that it talks to a panel and waits; commands and waits end up in a short list. Recording costs
//! microseconds and turns 265 ms of blocking start-up into data.

use core::cell::RefCell;
use embedded_hal::delay::DelayNs;
use mipidsi::interface::{Interface, InterfaceKind};
use mipidsi::models::Model;
use mipidsi::options::ModelOptions;

/// A command with its parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Command {
    code: u8,
    len: u8,
    params: [u8; Command::MAX_PARAMS],
}

impl Command {
    /// The longest parameter list of the start-up sequences.
    pub const MAX_PARAMS: usize = 4;

    /// Returns a command, `None` if it has too many parameters.
    pub fn new(code: u8, params: &[u8]) -> Option<Self> {
        let mut command = Self { code, len: params.len() as u8, params: [0; Self::MAX_PARAMS] };
        command.params.get_mut(..params.len())?.copy_from_slice(params);
        Some(command)
    }

    /// Returns the command code.
    pub const fn code(&self) -> u8 {
        self.code
    }

    /// Returns the parameters.
    pub fn params(&self) -> &[u8] {
        &self.params[..usize::from(self.len)]
    }
}

/// One line of a script.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// Send a command.
    Send(Command),
    /// Wait, in microseconds.
    Wait(u32),
}

/// The model sends more lines, or longer ones, than a script holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overflow;

/// A start-up sequence.
#[derive(Clone, Copy, Debug)]
pub struct Script {
    lines: [Line; Script::MAX_LINES],
    len: usize,
}

impl Script {
    /// Room for the longest of the supported models (12) and some more.
    pub const MAX_LINES: usize = 16;

    /// Records `model`.
    ///
    /// # Errors
    /// When the model sends more than fits.
    pub fn record(mut model: impl Model, options: &ModelOptions) -> Result<Self, Overflow> {
        let script = RefCell::new(Self { lines: [Line::Wait(0); Self::MAX_LINES], len: 0 });
        let overflow = RefCell::new(false);
        let mut clock = Clock { script: &script, overflow: &overflow };
        let sent = model.init(&mut Recorder(&script), &mut clock, options);
        if sent.is_err() || overflow.into_inner() { Err(Overflow) } else { Ok(script.into_inner()) }
    }

    /// Returns the recorded lines, oldest first.
    pub fn lines(&self) -> &[Line] {
        &self.lines[..self.len]
    }

    fn push(&mut self, line: Line) -> Result<(), Overflow> {
        *self.lines.get_mut(self.len).ok_or(Overflow)? = line;
        self.len += 1;
        Ok(())
    }
}

struct Recorder<'a>(&'a RefCell<Script>);

impl Interface for Recorder<'_> {
    type Word = u8;
    type Error = Overflow;
    const KIND: InterfaceKind = InterfaceKind::Serial4Line;

    fn send_command(&mut self, command: u8, args: &[u8]) -> Result<(), Overflow> {
        let command = Command::new(command, args).ok_or(Overflow)?;
        self.0.borrow_mut().push(Line::Send(command))
    }

    /// A start-up sequence has no pixels.
    fn send_pixels<const N: usize>(
        &mut self,
        _: impl IntoIterator<Item = [Self::Word; N]>,
    ) -> Result<(), Overflow> {
        Err(Overflow)
    }

    /// A start-up sequence has no pixels.
    fn send_repeated_pixel<const N: usize>(&mut self, _: [Self::Word; N], _: u32) -> Result<(), Overflow> {
        Err(Overflow)
    }
}

struct Clock<'a> {
    script: &'a RefCell<Script>,
    overflow: &'a RefCell<bool>,
}

impl DelayNs for Clock<'_> {
    fn delay_ns(&mut self, ns: u32) {
        self.delay_us(ns.div_ceil(1000));
    }

    fn delay_us(&mut self, us: u32) {
        if self.script.borrow_mut().push(Line::Wait(us)).is_err() {
            self.overflow.replace(true);
        }
    }
}
