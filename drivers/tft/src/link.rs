//! Commands and windows over SPI with a data/command pin and a chip select.
//!
//! Owns bus and pins. Between [`Link::open`] and [`Link::close`] the panel is selected, in data mode, and takes pixel
//! words through [`Link::bus`] in whatever way the board can send them.
//! Source: ILI9341 datasheet section 7.1.9 (4-line serial interface); MIPI DCS for the commands.

use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiBus;

const COLUMN_ADDRESS_SET: u8 = 0x2A;
const PAGE_ADDRESS_SET: u8 = 0x2B;
const MEMORY_WRITE: u8 = 0x2C;

/// A part of the picture, in pixels from the top left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    x: u16,
    y: u16,
    width: u16,
    height: u16,
}

impl Window {
    /// Returns a window, `None` if it is empty or reaches beyond the picture.
    pub fn new(x: u16, y: u16, width: u16, height: u16) -> Option<Self> {
        let fits = |start: u16, size: u16, limit: u16| {
            size != 0 && start.checked_add(size).is_some_and(|end| end <= limit)
        };
        (fits(x, width, crate::WIDTH) && fits(y, height, crate::HEIGHT)).then_some(Self {
            x,
            y,
            width,
            height,
        })
    }

    /// Returns the number of pixels.
    pub const fn pixels(self) -> usize {
        self.width as usize * self.height as usize
    }
}

/// Takes a rectangle of `embedded-graphics`.
impl TryFrom<embedded_graphics_core::primitives::Rectangle> for Window {
    type Error = OutsidePicture;

    fn try_from(area: embedded_graphics_core::primitives::Rectangle) -> Result<Self, OutsidePicture> {
        let small = |value: u32| u16::try_from(value).map_err(|_| OutsidePicture);
        let start = |value: i32| u16::try_from(value).map_err(|_| OutsidePicture);
        Self::new(
            start(area.top_left.x)?,
            start(area.top_left.y)?,
            small(area.size.width)?,
            small(area.size.height)?,
        )
        .ok_or(OutsidePicture)
    }
}

/// The rectangle is empty or reaches beyond the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutsidePicture;

/// What failed: the bus or a pin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkError<B, P> {
    /// The SPI bus.
    Bus(B),
    /// The chip select or the data/command pin.
    Pin(P),
}

/// The panel's end of the wires. `CS` low = selected, `DC` low = command.
pub struct Link<BUS, CS, DC> {
    bus: BUS,
    cs: CS,
    dc: DC,
}

impl<BUS, CS, DC, P> Link<BUS, CS, DC>
where
    BUS: SpiBus,
    CS: OutputPin<Error = P>,
    DC: OutputPin<Error = P>,
{
    /// Takes bus and pins and deselects the panel.
    ///
    /// # Errors
    /// When a pin fails.
    pub fn new(bus: BUS, mut cs: CS, dc: DC) -> Result<Self, LinkError<BUS::Error, P>> {
        cs.set_high().map_err(LinkError::Pin)?;
        Ok(Self { bus, cs, dc })
    }

    /// Gives bus, chip select and data/command pin back.
    pub fn free(self) -> (BUS, CS, DC) {
        (self.bus, self.cs, self.dc)
    }

    /// Lends the bus; pixel words only between [`Self::open`] and [`Self::close`].
    pub const fn bus(&mut self) -> &mut BUS {
        &mut self.bus
    }

    /// Sends one command in a chip select of its own.
    ///
    /// # Errors
    /// When bus or pins fail.
    pub fn command(&mut self, code: u8, params: &[u8]) -> Result<(), LinkError<BUS::Error, P>> {
        self.cs.set_low().map_err(LinkError::Pin)?;
        self.write(code, params)?;
        self.cs.set_high().map_err(LinkError::Pin)
    }

    /// Opens `window` for writing; the panel stays selected and takes pixels, left to right, top to bottom.
    ///
    /// Another window may follow without [`Self::close`] between them, after the last word has left the bus.
    ///
    /// # Errors
    /// When bus or pins fail.
    pub fn open(&mut self, window: Window) -> Result<(), LinkError<BUS::Error, P>> {
        let span = |start: u16, size: u16| {
            let ([a, b], [c, d]) = (start.to_be_bytes(), (start + size - 1).to_be_bytes());
            [a, b, c, d]
        };
        self.cs.set_low().map_err(LinkError::Pin)?;
        self.write(COLUMN_ADDRESS_SET, &span(window.x, window.width))?;
        self.write(PAGE_ADDRESS_SET, &span(window.y, window.height))?;
        self.write(MEMORY_WRITE, &[])?;
        self.dc.set_high().map_err(LinkError::Pin)
    }

    /// Ends the pixel stream, after its last word has left the bus.
    ///
    /// # Errors
    /// When the pin fails.
    pub fn close(&mut self) -> Result<(), LinkError<BUS::Error, P>> {
        self.cs.set_high().map_err(LinkError::Pin)
    }

    /// The data/command pin is sampled with the last bit of each byte, so the bus must be idle before it changes.
    fn write(&mut self, code: u8, params: &[u8]) -> Result<(), LinkError<BUS::Error, P>> {
        self.dc.set_low().map_err(LinkError::Pin)?;
        self.bus.write(&[code]).and_then(|()| self.bus.flush()).map_err(LinkError::Bus)?;
        if params.is_empty() {
            return Ok(());
        }
        self.dc.set_high().map_err(LinkError::Pin)?;
        self.bus.write(params).and_then(|()| self.bus.flush()).map_err(LinkError::Bus)
    }
}
