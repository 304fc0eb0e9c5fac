//! Commands of the ILI9341 and the ST7789: what is known of each.
//!
//! One row per command. Source: ILI9341 V1.11 chapter 8.1, ST7789V V1.4 chapter 9 and 10.

/// NOP
pub(super) const NOP: u8 = 0x00;
/// Software reset. SWRESET
pub(super) const SWRESET: u8 = 0x01;
/// Power mode. RDDPM
pub(super) const RDDPM: u8 = 0x0A;
/// Memory access control. RDDMADCTL
pub(super) const RDDMADCTL: u8 = 0x0B;
/// Pixel format. RDDCOLMOD
pub(super) const RDDCOLMOD: u8 = 0x0C;
/// Enter sleep. SLPIN
pub(super) const SLPIN: u8 = 0x10;
/// Leave sleep. SLPOUT
pub(super) const SLPOUT: u8 = 0x11;
/// Normal display mode. NORON
pub(super) const NORON: u8 = 0x13;
/// Inversion off. INVOFF
pub(super) const INVOFF: u8 = 0x20;
/// Inversion on. INVON
pub(super) const INVON: u8 = 0x21;
/// Display off. DISPOFF
pub(super) const DISPOFF: u8 = 0x28;
/// Display on. DISPON
pub(super) const DISPON: u8 = 0x29;
/// Column window. CASET
pub(super) const CASET: u8 = 0x2A;
/// Page window. RASET (PASET)
pub(super) const RASET: u8 = 0x2B;
/// Write pixels from the window's start. RAMWR
pub(super) const RAMWR: u8 = 0x2C;
/// Write pixels from where the last write stopped. RAMWRC
pub(super) const RAMWRC: u8 = 0x3C;
/// Memory access control. MADCTL
pub(super) const MADCTL: u8 = 0x36;
/// Pixel format. COLMOD (PIXSET)
pub(super) const COLMOD: u8 = 0x3A;
/// RAM control (ST7789). RAMCTRL
pub(super) const RAMCTRL: u8 = 0xB0;
/// Display function control (ILI9341). DFUNCTR
pub(super) const DFUNCTR: u8 = 0xB6;
/// Interface control (ILI9341). IFCTL
pub(super) const IFCTL: u8 = 0xF6;

/// How the model treats a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Modelled in full.
    Modelled,
    /// Changes nothing that a picture or a counter shows; its parameters are recorded.
    Recorded,
    /// Exists, would change the picture or answer on MISO, and is not modelled.
    NotModelled,
    /// Does not exist.
    Unknown,
}

/// What is known about `command`.
pub(super) const fn kind(command: u8) -> Kind {
    match command {
        NOP | SWRESET | RDDPM | RDDMADCTL | RDDCOLMOD | SLPIN | SLPOUT | NORON | INVOFF | INVON | DISPOFF
        | DISPON | CASET | RASET | RAMWR | RAMWRC | MADCTL | COLMOD => Kind::Modelled,
        // Gamma set, tearing effect line, idle mode off, tear line, brightness, content-adaptive brightness.
        0x26 | 0x34 | 0x35 | 0x38 | 0x44 | 0x51 | 0x53 | 0x55 | 0x5E => Kind::Recorded,
        // The manufacturer's commands: frame rates, voltages, gamma curves.
        0xB0..=0xD2 | 0xD4..=0xD9 | 0xE0..=0xFF => Kind::Recorded,
        // Identification, status, partial mode, memory read, scrolling, idle mode, scan line, brightness read.
        0x04
        | 0x09
        | 0x0D..=0x0F
        | 0x12
        | 0x2E
        | 0x30
        | 0x33
        | 0x37
        | 0x39
        | 0x3E
        | 0x45
        | 0x52
        | 0x54
        | 0x56
        | 0x5F
        | 0xD3
        | 0xDA..=0xDD => Kind::NotModelled,
        _ => Kind::Unknown,
    }
}

/// Whether parameter `index` of a recorded command asks for something that this model cannot show: another byte
/// order, address mirroring behind MADCTL's back, another scan direction.
pub(super) const fn surprises(command: u8, index: usize, value: u8, st7789: bool) -> bool {
    match (command, index, st7789) {
        (RAMCTRL, 1, true) => value & 0x08 != 0,  // ENDIAN
        (IFCTL, 0, false) => value & 0xE8 != 0,   // MY_EOR, MX_EOR, MV_EOR, BGR_EOR
        (IFCTL, 2, false) => value & 0x20 != 0,   // ENDIAN
        (DFUNCTR, 1, false) => value & 0x60 != 0, // GS, SS
        _ => false,
    }
}
