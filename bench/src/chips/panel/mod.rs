//! ILI9341 and ST7789 panels of 320 x 240 on 4-wire SPI: rebuilds the picture from the bytes.
//!
//! Modelled: reset pin and software reset, sleep in and out with their waits, display and inversion on and off, window,
//! memory write with wrap-around, MADCTL's exchange, mirroring and colour order, 16-bit colour, power mode, MADCTL and
//! COLMOD read-back; words of 8 or 16 bits; what the eye sees with the glass's own colour order and inversion and the
//! back-light. Manufacturer's commands are accepted and recorded. The memory powers up as noise.
//!
//! Not modelled, and a [`Violation`] when touched: 12- and 18-bit colour, memory read, identification, scrolling,
//! partial and idle mode, byte order and scan direction by manufacturer's commands. Not modelled and harmless: gamma,
//! voltages, frame rate, tearing effect line, the SPI clock limit.
//!
//! Source: Ilitek ILI9341 V1.11 (8.2, 9.3, 13.2, 15.4), Sitronix ST7789V V1.4 (9.1, 7.4).

mod command;
mod gram;
mod violation;

use self::command::Kind;
pub use self::gram::{COLUMNS, PAGES};
use self::gram::{Gram, Layout};
pub use self::violation::Violation;
use super::picture::Picture;
use super::violations::Violations;
use crate::time::Nanos;

/// Width of the picture as mounted.
pub const WIDTH: u16 = PAGES;
/// Height of the picture as mounted.
pub const HEIGHT: u16 = COLUMNS;

/// Wait after reset, SWRESET, SLPIN and SLPOUT before the next command (ILI9341 8.2.2, 8.2.11, 8.2.12, 15.4).
const COMMAND_PAUSE: Nanos = Nanos::from_millis(5);
/// Wait between SLPIN and SLPOUT in either order, and from a reset in sleep-out to SLPOUT; also the time until the
/// picture is steady (ILI9341 8.2.11, 8.2.12, 15.4).
const SLEEP_PAUSE: Nanos = Nanos::from_millis(120);
/// Shortest reset pulse (ILI9341 15.4).
const RESET_PULSE: Nanos = Nanos::from_micros(10);
/// MADCTL.BGR.
const BGR: u8 = 1 << 3;
/// COLMOD's low nibble for 16 bits per pixel on SPI.
const PIXEL_16_BIT: u8 = 0x05;
/// COLMOD after reset: 18 bits per pixel.
const PIXEL_RESET: u8 = 0x66;
/// What MISO reads while the panel does not drive it.
const RELEASED: u16 = 0xFFFF;
/// Back-light fully on.
pub const BACKLIGHT_FULL: u32 = 65_536;

/// Which chip drives the glass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Controller {
    /// Ilitek ILI9341.
    Ili9341,
    /// Sitronix ST7789 or ST7789V.
    St7789,
}

/// The module: controller, glass and how it is mounted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config {
    /// Chip on the panel: decides reset values and commands.
    pub controller: Controller,
    /// MADCTL (MY, MX, MV) under which a 320 x 240 picture stands upright in the housing.
    pub upright_madctl: u8,
    /// The glass's subpixels are blue, green, red: MADCTL.BGR must be set for true colours.
    pub bgr_glass: bool,
    /// The glass is normally black (IPS): INVON must be sent for true colours.
    pub inverted_glass: bool,
}

impl Config {
    /// The common 2.8" ILI9341 module: MV upright, BGR glass.
    pub const ILI9341: Self = Self {
        controller: Controller::Ili9341,
        upright_madctl: gram::MV,
        bgr_glass: true,
        inverted_glass: false,
    };

    /// The common 2.0" ST7789V IPS module: MV and MX upright, RGB glass, inverted.
    pub const ST7789: Self = Self {
        controller: Controller::St7789,
        upright_madctl: gram::MV | gram::MX,
        bgr_glass: false,
        inverted_glass: true,
    };
}

/// What passed through the panel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Bytes clocked while selected; a 16-bit word is two.
    pub bytes: u64,
    /// Commands received since power-on.
    pub commands: u64,
    /// Falling edges of CS.
    pub transactions: u64,
    /// Memory writes begun: RAMWR and RAMWRC.
    pub windows: u64,
    /// Pixels written.
    pub pixels: u64,
    /// Times the write position went past the end of its window and back to the start.
    pub wraps: u64,
}

/// An inclusive range of addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Span {
    start: u16,
    end: u16,
}

/// A panel: its controller's registers and frame memory.
#[derive(Clone, Debug)]
pub struct Panel {
    config: Config,
    gram: Gram,
    selected: bool,
    data: bool,
    /// Level of the reset pin and when it fell.
    reset: Option<Nanos>,
    backlight: u32,

    command: u8,
    parameters: Vec<u8>,
    parameter_count: usize,
    /// First byte of a pixel that came in two words.
    half_pixel: Option<u8>,
    reply: u16,

    commands_from: Nanos,
    sleep_out_from: Nanos,
    sleep_in_from: Nanos,
    awake_since: Option<Nanos>,
    display_on: bool,
    inverted: bool,
    madctl: u8,
    colmod: u8,
    layout: Layout,
    columns: Span,
    pages: Span,
    column: u16,
    page: u16,
    /// The write position has passed the window's last pixel.
    wrapped: bool,

    recorded: Vec<(u8, Vec<u8>)>,
    counters: Counters,
    violations: Violations<Violation>,
}

/// Recorded commands that are kept.
const RECORDED: usize = 256;
/// Longest parameter list that is kept (ILI9341's gamma tables have 64 bytes at most).
const PARAMETERS: usize = 128;

impl Panel {
    /// A panel that is powered on at `now`, in sleep, with noise in its memory.
    pub fn new(config: Config, now: Nanos) -> Self {
        let mut panel = Self {
            config,
            gram: Gram::new(),
            selected: false,
            data: false,
            reset: None,
            backlight: 0,
            command: command::NOP,
            parameters: Vec::with_capacity(PARAMETERS),
            parameter_count: 0,
            half_pixel: None,
            reply: RELEASED,
            commands_from: now,
            sleep_out_from: now,
            sleep_in_from: now,
            awake_since: None,
            display_on: false,
            inverted: false,
            madctl: 0,
            colmod: PIXEL_RESET,
            layout: Layout::of(0),
            columns: Span { start: 0, end: 0 },
            pages: Span { start: 0, end: 0 },
            column: 0,
            page: 0,
            wrapped: false,
            recorded: Vec::new(),
            counters: Counters::default(),
            violations: Violations::default(),
        };
        panel.restart(now);
        panel
    }

    /// The supply fails and comes back: the panel sleeps, its memory is noise, its counters and violations stay.
    pub fn power_cycle(&mut self, now: Nanos) {
        let Self { counters, violations, .. } = Self::new(self.config, now);
        let kept = (
            std::mem::replace(&mut self.counters, counters),
            std::mem::replace(&mut self.violations, violations),
        );
        *self = Self::new(self.config, now);
        (self.counters, self.violations) = kept;
    }

    /// CS goes low (`true`) or high (`false`); a command goes on over CS pauses.
    pub fn select(&mut self, _now: Nanos, selected: bool) {
        if selected && !self.selected {
            self.counters.transactions += 1;
            self.gram.begin_picture();
        }
        self.selected = selected;
    }

    /// The DC pin goes high (`true`, data) or low (`false`, command). It counts at the last bit of a word.
    pub fn data_command(&mut self, _now: Nanos, data: bool) {
        self.data = data;
    }

    /// The reset pin goes high (`true`) or low (`false`).
    pub fn reset(&mut self, now: Nanos, high: bool) {
        match (high, self.reset) {
            (false, None) => self.reset = Some(now),
            (true, Some(fell)) => {
                self.reset = None;
                let low = now.since(fell);
                if low < RESET_PULSE {
                    self.violations.report(now, Violation::ResetTooShort(low));
                } else {
                    self.restart(now);
                }
            }
            _ => {}
        }
    }

    /// Sets the back-light's duty: 0 = dark, [`BACKLIGHT_FULL`] = full.
    pub fn set_backlight(&mut self, duty: u32) {
        self.backlight = duty;
    }

    /// Duty of the back-light, 0..=[`BACKLIGHT_FULL`].
    pub fn backlight(&self) -> u32 {
        self.backlight
    }

    /// Clocks a word of `bits` bits (8 or 16) in and one out; `now` is the end of its last bit.
    #[inline]
    pub fn exchange(&mut self, now: Nanos, word: u16, bits: u8) -> u16 {
        let pixel_write = self.selected && self.data && self.reset.is_none() && bits == 16;
        if pixel_write && self.half_pixel.is_none() && self.is_writing() {
            self.counters.bytes += 2;
            self.write_pixel(now, word);
            return RELEASED;
        }
        self.exchange_bytes(now, word, bits)
    }

    fn exchange_bytes(&mut self, now: Nanos, word: u16, bits: u8) -> u16 {
        if !self.selected {
            self.violations.report(now, Violation::NotSelected);
            return RELEASED;
        }
        if self.reset.is_some() {
            self.violations.report(now, Violation::InReset);
            return RELEASED;
        }
        match bits {
            8 => self.byte(now, word as u8) | 0xFF00,
            16 => self.byte(now, (word >> 8) as u8) << 8 | self.byte(now, word as u8) & 0xFF,
            _ => {
                self.violations.report(now, Violation::WordSize(bits));
                RELEASED
            }
        }
    }

    /// What the eye sees at `now`, upright; `None` while the glass is dark.
    pub fn visible(&self, now: Nanos) -> Option<Picture> {
        let steady = self.awake_since.is_some_and(|since| now >= since + SLEEP_PAUSE);
        let lit = steady && self.display_on && self.backlight > 0 && self.reset.is_none();
        lit.then(|| self.glass())
    }

    /// What the memory would show with everything on, upright.
    pub fn glass(&self) -> Picture {
        let mut rgb = Vec::with_capacity(usize::from(WIDTH) * usize::from(HEIGHT) * 3);
        for y in 0..HEIGHT {
            for x in 0..WIDTH {
                rgb.extend(self.shown(self.colour_at(x, y)));
            }
        }
        Picture { width: u32::from(WIDTH), height: u32::from(HEIGHT), rgb }
    }

    /// RGB565 in memory under the upright pixel `x`, `y`.
    pub fn colour_at(&self, x: u16, y: u16) -> u16 {
        self.gram.colour(&Layout::of(self.config.upright_madctl), x, y)
    }

    /// RGB565 of a memory cell by its physical column (0..240) and page (0..320).
    pub fn memory(&self, column: u16, page: u16) -> u16 {
        self.gram.colour(&Layout::of(0), column, page)
    }

    /// When the upright pixel `x`, `y` was last written; `None` if never.
    pub fn written_at(&self, x: u16, y: u16) -> Option<Nanos> {
        self.gram.written_at(&Layout::of(self.config.upright_madctl), x, y)
    }

    /// When a pixel was last written.
    pub fn last_write(&self) -> Option<Nanos> {
        self.gram.last_write()
    }

    /// When a pixel was last changed.
    pub fn last_change(&self) -> Option<Nanos> {
        self.gram.last_change()
    }

    /// Pixels that nobody has written since power-on.
    pub fn undrawn_pixels(&self) -> usize {
        self.gram.undrawn()
    }

    /// When the upright pixel `x`, `y` was last given another colour; `None` if it was never written.
    pub fn changed_at(&self, x: u16, y: u16) -> Option<Nanos> {
        self.gram.changed_at(&Layout::of(self.config.upright_madctl), x, y)
    }

    /// Pixels that were given another colour, each as often as it was.
    pub fn changed_pixels(&self) -> u64 {
        self.gram.changed()
    }

    /// Pixels that left their colour and came back to it within one picture.
    ///
    /// A picture is what is written while CS is low: whoever draws keeps it low from the first pixel of a picture to the
    /// last. The picture before and the picture after have the same colour there, and the eye saw another between them:
    /// something was cleared first, or painted twice. What moves from picture to picture is not counted.
    pub fn flickered_pixels(&self) -> u64 {
        self.gram.flickered()
    }

    /// Commands that were only recorded, with their parameters, oldest first.
    pub fn recorded(&self) -> impl Iterator<Item = (u8, &[u8])> {
        self.recorded.iter().map(|(command, parameters)| (*command, parameters.as_slice()))
    }

    /// True while CS is low.
    pub fn is_selected(&self) -> bool {
        self.selected
    }

    /// True after SLPOUT.
    pub fn is_awake(&self) -> bool {
        self.awake_since.is_some()
    }

    /// True after DISPON.
    pub fn is_display_on(&self) -> bool {
        self.display_on
    }

    /// What passed through the panel.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// How the panel was misused.
    pub fn violations(&self) -> &Violations<Violation> {
        &self.violations
    }

    /// The same, to clear it.
    pub fn violations_mut(&mut self) -> &mut Violations<Violation> {
        &mut self.violations
    }

    /// RGB565 to what the glass makes of it.
    fn shown(&self, colour: u16) -> [u8; 3] {
        let inverted = self.inverted != self.config.inverted_glass;
        let colour = if inverted { !colour } else { colour };
        let wide = |value: u16, most: u32| ((u32::from(value) * 255 + most / 2) / most) as u8;
        let [red, green, blue] =
            [wide(colour >> 11, 31), wide(colour >> 5 & 0x3F, 63), wide(colour & 0x1F, 31)];
        let swapped = (self.madctl & BGR != 0) != self.config.bgr_glass;
        if swapped { [blue, green, red] } else { [red, green, blue] }
    }

    /// Hardware reset, software reset, power-on: registers to their defaults; the memory keeps its contents.
    fn restart(&mut self, now: Nanos) {
        let was_awake = self.awake_since.take().is_some();
        self.commands_from = now + COMMAND_PAUSE;
        self.sleep_out_from = now + if was_awake { SLEEP_PAUSE } else { COMMAND_PAUSE };
        self.display_on = false;
        self.inverted = false;
        self.colmod = PIXEL_RESET;
        self.set_madctl(0);
        self.columns = Span { start: 0, end: COLUMNS - 1 };
        self.pages = Span { start: 0, end: PAGES - 1 };
        self.begin(command::NOP);
    }

    fn begin(&mut self, command: u8) {
        self.command = command;
        self.parameters.clear();
        self.parameter_count = 0;
        self.half_pixel = None;
        self.reply = RELEASED;
    }

    fn set_madctl(&mut self, madctl: u8) {
        self.madctl = madctl;
        self.layout = Layout::of(madctl);
    }

    fn is_writing(&self) -> bool {
        matches!(self.command, command::RAMWR | command::RAMWRC) && self.colmod & 0x07 == PIXEL_16_BIT
    }

    fn byte(&mut self, now: Nanos, byte: u8) -> u16 {
        self.counters.bytes += 1;
        let reply = std::mem::replace(&mut self.reply, RELEASED);
        if self.data {
            self.parameter(now, byte);
        } else {
            self.command(now, byte);
        }
        reply
    }

    fn command(&mut self, now: Nanos, code: u8) {
        self.counters.commands += 1;
        self.begin(code);
        let from = match code {
            command::SLPOUT => self.commands_from.max(self.sleep_out_from),
            command::SLPIN => self.commands_from.max(self.sleep_in_from),
            _ => self.commands_from,
        };
        if now < from {
            self.violations.report(now, Violation::TooSoon { command: code, early: from.since(now) });
        }
        match command::kind(code) {
            Kind::Modelled => {}
            Kind::Recorded => {
                if self.recorded.len() < RECORDED {
                    self.recorded.push((code, Vec::new()));
                }
            }
            Kind::NotModelled => return self.violations.report(now, Violation::NotModelled(code)),
            Kind::Unknown => return self.violations.report(now, Violation::UnknownCommand(code)),
        }
        match code {
            command::SWRESET => self.restart(now),
            command::SLPIN => {
                self.awake_since = None;
                self.commands_from = now + COMMAND_PAUSE;
                self.sleep_out_from = now + SLEEP_PAUSE;
            }
            command::SLPOUT => {
                self.awake_since = self.awake_since.or(Some(now));
                self.commands_from = now + COMMAND_PAUSE;
                self.sleep_in_from = now + SLEEP_PAUSE;
            }
            command::INVOFF => self.inverted = false,
            command::INVON => self.inverted = true,
            command::DISPOFF => self.display_on = false,
            command::DISPON => self.display_on = true,
            command::RAMWR => {
                self.counters.windows += 1;
                (self.column, self.page, self.wrapped) = (self.columns.start, self.pages.start, false);
            }
            command::RAMWRC => self.counters.windows += 1,
            command::RDDPM => self.reply = self.power_mode() | 0xFF00,
            command::RDDMADCTL => self.reply = u16::from(self.madctl) | 0xFF00,
            command::RDDCOLMOD => self.reply = u16::from(self.colmod) | 0xFF00,
            _ => {}
        }
    }

    /// ILI9341 8.2.5: booster, sleep out, normal mode, display on.
    fn power_mode(&self) -> u16 {
        let awake = u16::from(self.is_awake());
        awake << 7 | awake << 4 | 1 << 3 | u16::from(self.display_on) << 2
    }

    fn parameter(&mut self, now: Nanos, byte: u8) {
        if matches!(self.command, command::RAMWR | command::RAMWRC) {
            return self.pixel_byte(now, byte);
        }
        let index = self.parameter_count;
        self.parameter_count += 1;
        if self.parameters.len() < PARAMETERS {
            self.parameters.push(byte);
        }
        match (self.command, index) {
            (command::CASET | command::RASET, 0..3) => {}
            (command::CASET | command::RASET, 3) => self.set_window(now),
            (command::MADCTL, 0) => self.set_madctl(byte),
            (command::COLMOD, 0) => self.colmod = byte,
            (command::RDDPM | command::RDDMADCTL | command::RDDCOLMOD, 0) => {}
            (code, _) => match command::kind(code) {
                Kind::Recorded => self.record(now, index, byte),
                Kind::Modelled => self.violations.report(now, Violation::UnexpectedData { command: code }),
                // The command itself has been reported.
                Kind::NotModelled | Kind::Unknown => {}
            },
        }
    }

    fn record(&mut self, now: Nanos, index: usize, byte: u8) {
        let st7789 = self.config.controller == Controller::St7789;
        if command::surprises(self.command, index, byte, st7789) {
            let violation = Violation::ParameterNotModelled { command: self.command, value: byte };
            self.violations.report(now, violation);
        }
        let command = self.command;
        if let Some((last, parameters)) = self.recorded.last_mut()
            && *last == command
            && parameters.len() < PARAMETERS
        {
            parameters.push(byte);
        }
    }

    fn set_window(&mut self, now: Nanos) {
        let [a, b, c, d] = [0, 1, 2, 3].map(|index| self.parameters[index]);
        let (start, end) = (u16::from_be_bytes([a, b]), u16::from_be_bytes([c, d]));
        let (columns, pages) = self.layout.size();
        let limit = if self.command == command::CASET { columns } else { pages };
        if start > end || end >= limit {
            return self.violations.report(now, Violation::Window { command: self.command, start, end });
        }
        if self.command == command::CASET {
            self.columns = Span { start, end };
        } else {
            self.pages = Span { start, end };
        }
    }

    fn pixel_byte(&mut self, now: Nanos, byte: u8) {
        if !self.is_writing() {
            self.parameter_count += 1;
            if self.parameter_count == 1 {
                self.violations.report(now, Violation::PixelFormat(self.colmod));
            }
            return;
        }
        match self.half_pixel.take() {
            None => self.half_pixel = Some(byte),
            Some(high) => self.write_pixel(now, u16::from_be_bytes([high, byte])),
        }
    }

    #[inline]
    fn write_pixel(&mut self, now: Nanos, colour: u16) {
        self.counters.pixels += 1;
        if self.wrapped {
            self.counters.wraps += 1;
            self.wrapped = false;
        }
        self.gram.write(now, &self.layout, self.column, self.page, colour);
        if self.column < self.columns.end {
            self.column += 1;
            return;
        }
        self.column = self.columns.start;
        if self.page < self.pages.end {
            self.page += 1;
            return;
        }
        self.page = self.pages.start;
        self.wrapped = true;
    }
}
