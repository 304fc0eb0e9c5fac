//! SPI0 and INT as the MCP2515 driver wants them.
//!
//! [`CanSpi`] keeps the transmit FIFO filled while it reads, so that bytes follow each other without pauses; its loop
//! lives in RAM, because a flash fetch that misses the cache costs as much as half a byte on the wire. The INT pin is
//! a level interrupt that can be masked.

use core::convert::Infallible;
use embedded_hal::digital::{ErrorType as PinErrorType, InputPin, OutputPin};
use embedded_hal::spi::{Error, ErrorKind, ErrorType, Operation, SpiDevice};
use rp2040_hal::gpio::bank0::{Gpio16, Gpio17, Gpio18, Gpio19, Gpio20};
use rp2040_hal::gpio::{
    FunctionSio, FunctionSpi, Interrupt, Pin, PullDown, PullNone, PullUp, SioInput, SioOutput,
};
use rp2040_hal::pac;
use rp2040_hal::spi::{Enabled, Spi};

pub(crate) type Mosi = Pin<Gpio19, FunctionSpi, PullDown>;
pub(crate) type Miso = Pin<Gpio16, FunctionSpi, PullUp>;
pub(crate) type Clock = Pin<Gpio18, FunctionSpi, PullDown>;
pub(crate) type Select = Pin<Gpio17, FunctionSio<SioOutput>, PullNone>;
pub(crate) type IntPin = Pin<Gpio20, FunctionSio<SioInput>, PullUp>;
pub(crate) type Bus = Spi<Enabled, pac::SPI0, (Mosi, Miso, Clock), 8>;

/// Depth of the PL022's FIFOs: so many bytes may be on their way before one must be read back.
const FIFO: usize = 8;
/// Turns of the loop per byte before the bus counts as stuck; a byte takes about 10.
const TURNS_PER_BYTE: usize = 200;

/// The SPI block has stopped shifting: its clock or its reset has been taken away.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpiStuck;

impl Error for SpiStuck {
    fn kind(&self) -> ErrorKind {
        ErrorKind::Other
    }
}

/// The MCP2515's SPI device: SPI0, mode 0,0, chip select by software.
pub struct CanSpi {
    _bus: Bus,
    select: Select,
}

impl CanSpi {
    pub(crate) fn new(bus: Bus, mut select: Select) -> Self {
        let Ok(()) = select.set_high();
        Self { _bus: bus, select }
    }

    #[inline(always)]
    fn selected<T>(&mut self, clock: impl FnOnce() -> T) -> T {
        // Set-up, hold and disable times of 50 ns are 6 cycles: what lies between these calls takes longer.
        let Ok(()) = self.select.set_low();
        let result = clock();
        let Ok(()) = self.select.set_high();
        result
    }
}

/// Clocks `bytes` out and what comes back in.
#[inline(never)]
#[unsafe(link_section = ".data.ram.can_exchange")]
fn exchange(bytes: &mut [u8]) -> Result<(), SpiStuck> {
    // SAFETY: the caller owns SPI0 through `Bus`; nothing else touches its data and status registers.
    let spi = unsafe { &*pac::SPI0::PTR };
    let (mut sent, mut received) = (0, 0);
    for _ in 0..bytes.len() * TURNS_PER_BYTE {
        if sent < bytes.len() && sent - received < FIFO {
            // SAFETY: any value is valid in SSPDR; the FIFO has room, less than its depth is on the way.
            spi.sspdr().write(|w| unsafe { w.data().bits(u16::from(bytes[sent])) });
            sent += 1;
        }
        if spi.sspsr().read().rne().bit_is_set() {
            bytes[received] = spi.sspdr().read().data().bits() as u8;
            received += 1;
            if received == bytes.len() {
                return Ok(());
            }
        }
    }
    if bytes.is_empty() { Ok(()) } else { Err(SpiStuck) }
}

/// Clocks `bytes` out and drops what comes back.
fn send(bytes: &[u8]) -> Result<(), SpiStuck> {
    let mut chunk = [0; 2 * FIFO];
    bytes.chunks(chunk.len()).try_for_each(|part| {
        let chunk = &mut chunk[..part.len()];
        chunk.copy_from_slice(part);
        exchange(chunk)
    })
}

impl ErrorType for CanSpi {
    type Error = SpiStuck;
}

impl SpiDevice for CanSpi {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), SpiStuck> {
        self.selected(|| {
            operations.iter_mut().try_for_each(|operation| match operation {
                Operation::TransferInPlace(bytes) => exchange(bytes),
                Operation::Write(bytes) => send(bytes),
                Operation::Read(bytes) => {
                    bytes.fill(0);
                    exchange(bytes)
                }
                Operation::Transfer(read, write) => {
                    let both = read.len().min(write.len());
                    read.fill(0);
                    read[..both].copy_from_slice(&write[..both]);
                    exchange(read)?;
                    send(&write[both..])
                }
                Operation::DelayNs(ns) => {
                    cortex_m::asm::delay(*ns / (1_000_000_000 / crate::facts::SYS_HZ) + 1);
                    Ok(())
                }
            })
        })
    }

    #[inline(always)]
    fn transfer_in_place(&mut self, bytes: &mut [u8]) -> Result<(), SpiStuck> {
        self.selected(|| exchange(bytes))
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), SpiStuck> {
        self.selected(|| send(bytes))
    }
}

/// The MCP2515's INT pin: low = service me.
pub struct CanInt(IntPin);

impl CanInt {
    pub(crate) const fn new(pin: IntPin) -> Self {
        Self(pin)
    }

    /// Lets a low level raise `IO_IRQ_BANK0`.
    pub fn arm(&mut self) {
        self.0.set_interrupt_enabled(Interrupt::LevelLow, true);
    }

    /// Keeps a low level from raising `IO_IRQ_BANK0`.
    pub fn mask(&mut self) {
        self.0.set_interrupt_enabled(Interrupt::LevelLow, false);
    }
}

impl PinErrorType for CanInt {
    type Error = Infallible;
}

impl InputPin for CanInt {
    #[inline(always)]
    fn is_high(&mut self) -> Result<bool, Infallible> {
        self.0.is_high()
    }

    #[inline(always)]
    fn is_low(&mut self) -> Result<bool, Infallible> {
        self.0.is_low()
    }
}
