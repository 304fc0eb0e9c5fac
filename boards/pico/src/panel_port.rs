//! SPI1, DMA channel 0 and the panel's pins: one tile at a time leaves without the CPU.
//!
//! Life of a tile: [`PanelPort::start`] takes its buffer and opens the window; the DMA feeds SPI1; `DMA_IRQ_0` fires
//! ([`acknowledge`]); [`PanelPort::finish`] gives the buffer back. The panel stays selected from the first tile of a
//! picture until [`PanelPort::close`]: on the wire, one picture is one transaction. Pixels go as 16-bit frames in SPI
//! mode 3: the PL022 pauses two clocks after every frame in mode 0, which would cost an eighth of the time.
//! Source: RP2040 datasheet 2.5 (DMA) and 4.4.3 (PL022).

use core::convert::Infallible;
use core::sync::atomic::{Ordering, compiler_fence};
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::{ErrorType, SpiBus};
use rp2040_hal::dma::{CH0, Channel, SingleChannel};
use rp2040_hal::gpio::bank0::{Gpio8, Gpio9, Gpio10, Gpio11, Gpio12};
use rp2040_hal::gpio::{FunctionSio, FunctionSpi, Pin, PullDown, PullNone, SioOutput};
use rp2040_hal::pac;
use rp2040_hal::spi::{Enabled, Spi};
use tft::script::Command;
use tft::{Link, Window};

use crate::facts::PANEL_DMA;

pub(crate) type Mosi = Pin<Gpio11, FunctionSpi, PullDown>;
pub(crate) type Clock = Pin<Gpio10, FunctionSpi, PullDown>;
pub(crate) type Select = Pin<Gpio9, FunctionSio<SioOutput>, PullNone>;
pub(crate) type DataCommand = Pin<Gpio8, FunctionSio<SioOutput>, PullNone>;
pub(crate) type Reset = Pin<Gpio12, FunctionSio<SioOutput>, PullNone>;
pub(crate) type Bus = Spi<Enabled, pac::SPI1, (Mosi, Clock), 8>;

/// Turns of a wait for a FIFO of eight words: at 31 MHz they leave within 640 cycles.
const DRAIN_TURNS: u32 = 10_000;

/// SPI1, write only: bytes for commands, words for pixels.
pub struct PanelBus {
    _bus: Bus,
}

impl PanelBus {
    fn spi(&self) -> &pac::spi0::RegisterBlock {
        // SAFETY: `self` owns SPI1 through `_bus`; the DMA only writes its data register.
        unsafe { &*pac::SPI1::PTR }
    }

    /// Sets the frame to `bits`; SSPCR0 must not change while the block runs (PL022 TRM 3.3.1).
    fn frame(&mut self, bits: u8) {
        self.drain();
        let spi = self.spi();
        spi.sspcr1().modify(|_, w| w.sse().clear_bit());
        // SAFETY: DSS takes the number of bits less one, 3 to 15.
        spi.sspcr0().modify(|_, w| unsafe { w.dss().bits(bits - 1) });
        spi.sspcr1().modify(|_, w| w.sse().set_bit());
    }

    /// Waits until the last bit has left.
    fn drain(&mut self) {
        for _ in 0..DRAIN_TURNS {
            let status = self.spi().sspsr().read();
            if status.tfe().bit_is_set() && status.bsy().bit_is_clear() {
                return;
            }
        }
    }
}

impl ErrorType for PanelBus {
    type Error = Infallible;
}

impl SpiBus for PanelBus {
    fn write(&mut self, bytes: &[u8]) -> Result<(), Infallible> {
        for &byte in bytes {
            for _ in 0..DRAIN_TURNS {
                if self.spi().sspsr().read().tnf().bit_is_set() {
                    break;
                }
            }
            // SAFETY: any value is valid in SSPDR.
            self.spi().sspdr().write(|w| unsafe { w.data().bits(u16::from(byte)) });
        }
        Ok(())
    }

    /// The panel's data output is not connected: reads give zeros.
    fn read(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        bytes.fill(0);
        Ok(())
    }

    fn transfer(&mut self, read: &mut [u8], write: &[u8]) -> Result<(), Infallible> {
        read.fill(0);
        self.write(write)
    }

    fn transfer_in_place(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        self.write(bytes)?;
        bytes.fill(0);
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        self.drain();
        Ok(())
    }
}

/// The panel, its reset pin and the DMA channel that feeds it.
pub struct PanelPort {
    link: Link<PanelBus, Select, DataCommand>,
    reset: Reset,
    channel: Channel<CH0>,
    tile: Option<&'static mut [u16]>,
}

impl PanelPort {
    pub(crate) fn new(
        bus: Bus,
        select: Select,
        data: DataCommand,
        reset: Reset,
        mut channel: Channel<CH0>,
    ) -> Self {
        channel.enable_irq0();
        let Ok(link) = Link::new(PanelBus { _bus: bus }, select, data);
        Self { link, reset, channel, tile: None }
    }

    /// Drives the panel's reset pin.
    pub fn reset(&mut self, high: bool) {
        let Ok(()) = self.reset.set_state(high.into());
    }

    /// Sends a command; no tile may be on its way.
    pub fn command(&mut self, command: &Command) {
        let Ok(()) = self.link.command(command.code(), command.params());
    }

    /// Opens `window` and lets the DMA send its pixels from the start of `tile`.
    ///
    /// # Errors
    /// Gives the buffer back when a tile is on its way already or the buffer is shorter than the window.
    pub fn start(&mut self, window: Window, tile: &'static mut [u16]) -> Result<(), &'static mut [u16]> {
        if self.tile.is_some() || tile.len() < window.pixels() {
            return Err(tile);
        }
        let Ok(()) = self.link.open(window);
        self.link.bus().frame(16);
        let channel = self.channel.ch();
        let spi = self.link.bus().spi();
        // SAFETY: the buffer is kept in `self.tile`, untouched, until `finish` finds the channel idle; the addresses
        // are those of the buffer and of SSPDR, the count is that of pixels in the buffer.
        unsafe {
            spi.sspdmacr().write(|w| w.txdmae().set_bit());
            channel.ch_read_addr().write(|w| w.bits(tile.as_ptr() as u32));
            channel.ch_write_addr().write(|w| w.bits(spi.sspdr().as_ptr() as u32));
            channel.ch_trans_count().write(|w| w.bits(window.pixels() as u32));
            compiler_fence(Ordering::SeqCst);
            channel.ch_ctrl_trig().write(|w| {
                w.data_size().size_halfword().incr_read().set_bit();
                w.treq_sel().bits(PANEL_DMA.1).chain_to().bits(PANEL_DMA.0 as u8);
                w.en().set_bit()
            });
        }
        self.tile = Some(tile);
        Ok(())
    }

    /// Returns whether a tile is on its way or waits for [`Self::finish`].
    pub const fn is_open(&self) -> bool {
        self.tile.is_some()
    }

    /// Gives the buffer back, `None` while the DMA runs or when there is no tile.
    pub fn finish(&mut self) -> Option<&'static mut [u16]> {
        if self.channel.ch().ch_ctrl_trig().read().busy().bit_is_set() {
            return None;
        }
        let tile = self.tile.take()?;
        compiler_fence(Ordering::SeqCst);
        self.link.bus().frame(8);
        Some(tile)
    }

    /// Deselects the panel after the last tile of a picture.
    pub fn close(&mut self) {
        let Ok(()) = self.link.close();
    }
}

/// Clears the panel's interrupt at the DMA; for the `DMA_IRQ_0` task.
#[inline]
pub fn acknowledge() {
    // SAFETY: writing a one clears the flag of this channel only.
    unsafe { &*pac::DMA::PTR }.ints0().write(|w| unsafe { w.bits(1 << PANEL_DMA.0) });
}
