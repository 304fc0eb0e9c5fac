//! The board as constants: clocks, panel, crystal, rates, channels.
//!
//! Pins are in [`crate::init`], which is the only place that names them; flash and RAM are in `memory.x`, budgets in
//! `Cargo.toml`. Source: RP2040 datasheet; Pico datasheet appendix B; the modules' data.

use mcp2515_can::Oscillator;
use tft::Panel;

/// Crystal of the Pico.
pub const XTAL_HZ: u32 = 12_000_000;
/// Start-up wait of the crystal in milliseconds, as the factor that XOSC takes (RP2040 datasheet 2.16.3).
pub const XTAL_START_FACTOR: u32 = 1;
/// System and peripheral clock (`PLL_SYS`).
pub const SYS_HZ: u32 = 125_000_000;

/// Upper limit of the MCP2515's SPI clock (DS20001801 table 13-6). At 125 MHz the divider gives 125 / 14 = 8.93 MHz.
pub const CAN_SPI_LIMIT_HZ: u32 = 10_000_000;

/// Crystal of the MCP2515 module.
pub const CAN_OSCILLATOR: Oscillator =
    if cfg!(feature = "crystal-16mhz") { Oscillator::Mhz16 } else { Oscillator::Mhz8 };

/// The panel that the image is built for.
pub const PANEL: Panel = if cfg!(feature = "st7789") { Panel::St7789 } else { Panel::Ili9341 };

/// SPI clock of the panel. ST7789VW: 62.5 MHz is its limit (16 ns write cycle). ILI9341: its datasheet says 10 MHz,
/// its modules take 40 MHz and more; 31.25 MHz is the divider's next step below and halves the time of a picture
/// against every slower one.
pub const PANEL_SPI_HZ: u32 = match PANEL {
    Panel::St7789 => 62_500_000,
    Panel::Ili9341 => 31_250_000,
};

/// Full scale of the ADC: its reference is the 3.3 V supply (Pico datasheet 4.3).
pub const ADC_MILLIVOLTS: u32 = 3_300;
/// Largest number of the ADC.
pub const ADC_MOST: u32 = 4_095;
/// A pin that its own pull-up lifts to here has no divider: a fitted one keeps it below 3.2 V.
pub(crate) const ADC_OPEN: u16 = 3_972;

/// Divider of the supply, 100 k over 10 k.
pub const SUPPLY_DIVIDER: (u32, u32) = (11, 1);
/// Below this there is no supply to measure, in millivolts.
pub const SUPPLY_LEAST_MV: u32 = 3_000;

/// Divider of an air sensor, 10 k over 20 k.
pub const AIR_DIVIDER: (u32, u32) = (3, 2);
/// What an air sensor gives at nothing and at [`AIR_MOST_CENTIMPA`], in millivolts.
pub const AIR_SPAN_MV: (u32, u32) = (500, 4_500);
/// Full scale of an air sensor in 0.01 MPa.
pub const AIR_MOST_CENTIMPA: u32 = 120;
/// What a sensor that is there and whole gives, in millivolts.
pub const AIR_WHOLE_MV: (u32, u32) = (250, 4_750);

/// Bit rate of the PC link.
pub const LINK_BAUD: u32 = 115_200;
/// Bytes that wait to leave over the PC link: 89 ms at 115 200 baud.
pub const LINK_RING: usize = 1_024;

/// Frequency of the back-light's PWM: above hearing.
pub const BACKLIGHT_HZ: u32 = 25_000;

/// The watchdog resets the chip when it has not been fed for so long.
pub const WATCHDOG_US: u32 = 1_000_000;

/// DMA channel and request of the panel (SPI1 TX, RP2040 datasheet table 120).
pub(crate) const PANEL_DMA: (usize, u8) = (0, 18);
/// DMA channel and request of the PC link (UART0 TX).
pub(crate) const LINK_DMA: (usize, u8) = (1, 20);
