//! One method per SPI instruction, without policy.
//!
//! Each call is one chip-select cycle. Source: DS20001801 section 12.

use crate::frame::Buffer;
use crate::irq::RxBuffer;
use crate::regs::{self, Register};
use embedded_hal::spi::SpiDevice;

/// Twelve neighbouring registers: filters 0 to 2, filters 3 to 5, or what lies from RXM0SIDH to CANINTE.
pub type Bank = [u8; 12];

/// The chip's instruction set over an SPI device: mode 0,0 and at most 10 MHz.
pub struct Commands<SPI> {
    spi: SPI,
}

impl<SPI: SpiDevice> Commands<SPI> {
    /// Wraps an SPI device.
    pub const fn new(spi: SPI) -> Self {
        Self { spi }
    }

    /// Gives the SPI device back.
    pub fn free(self) -> SPI {
        self.spi
    }

    /// Sends RESET (0xC0): registers take their reset values, the chip enters configuration mode.
    pub fn reset(&mut self) -> Result<(), SPI::Error> {
        self.spi.write(&[regs::RESET])
    }

    /// READ of one register.
    pub fn read(&mut self, register: Register) -> Result<u8, SPI::Error> {
        let mut bytes = [regs::READ, register as u8, 0];
        self.spi.transfer_in_place(&mut bytes)?;
        Ok(bytes[2])
    }

    /// READ of two neighbouring registers.
    pub fn read_pair(&mut self, first: Register) -> Result<[u8; 2], SPI::Error> {
        let mut bytes = [regs::READ, first as u8, 0, 0];
        self.spi.transfer_in_place(&mut bytes)?;
        Ok([bytes[2], bytes[3]])
    }

    /// READ of as many neighbouring registers as a [`Bank`] has.
    pub fn read_bank(&mut self, first: Register) -> Result<Bank, SPI::Error> {
        let mut bytes = [0; 2 + size_of::<Bank>()];
        bytes[..2].copy_from_slice(&[regs::READ, first as u8]);
        self.spi.transfer_in_place(&mut bytes)?;
        let [_, _, bank @ ..] = bytes;
        Ok(bank)
    }

    /// WRITE of one register.
    pub fn write(&mut self, register: Register, value: u8) -> Result<(), SPI::Error> {
        self.spi.write(&[regs::WRITE, register as u8, value])
    }

    /// WRITE of as many neighbouring registers as a [`Bank`] has.
    pub fn write_bank(&mut self, first: Register, bank: &Bank) -> Result<(), SPI::Error> {
        let mut bytes = [0; 2 + size_of::<Bank>()];
        bytes[..2].copy_from_slice(&[regs::WRITE, first as u8]);
        bytes[2..].copy_from_slice(bank);
        self.spi.write(&bytes)
    }

    /// BIT MODIFY: sets the bits of `mask` to those of `value`.
    pub fn bit_modify(&mut self, register: Register, mask: u8, value: u8) -> Result<(), SPI::Error> {
        self.spi.write(&[regs::BIT_MODIFY, register as u8, mask, value])
    }

    /// Sends READ STATUS (0xA0) and returns the receive and transmit flags in one byte (figure 12-8).
    pub fn read_status(&mut self) -> Result<u8, SPI::Error> {
        let mut bytes = [regs::READ_STATUS, 0];
        self.spi.transfer_in_place(&mut bytes)?;
        Ok(bytes[1])
    }

    /// RX STATUS: 2 bytes on the wire.
    #[inline(always)]
    pub fn rx_status(&mut self) -> Result<u8, SPI::Error> {
        let mut bytes = [regs::RX_STATUS, 0];
        self.spi.transfer_in_place(&mut bytes)?;
        Ok(bytes[1])
    }

    /// READ RX BUFFER: 14 bytes on the wire; its end releases the buffer.
    #[inline(always)]
    pub fn read_rx_buffer(&mut self, buffer: RxBuffer) -> Result<Buffer, SPI::Error> {
        let instruction = match buffer {
            RxBuffer::Rx0 => regs::READ_RX0,
            RxBuffer::Rx1 => regs::READ_RX1,
        };
        let mut bytes = [instruction, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        self.spi.transfer_in_place(&mut bytes)?;
        let [_, buffer @ ..] = bytes;
        Ok(buffer)
    }

    /// LOAD TX BUFFER 0 with the first `len` bytes of `buffer`.
    pub fn load_tx_buffer_0(&mut self, buffer: &Buffer, len: usize) -> Result<(), SPI::Error> {
        let len = len.min(buffer.len());
        let mut bytes = [0; 14];
        bytes[0] = regs::LOAD_TX0;
        bytes[1..=len].copy_from_slice(&buffer[..len]);
        self.spi.write(&bytes[..=len])
    }

    /// RTS of transmit buffer 0. Setting TXREQ by a write instead repeats frames (errata 5).
    pub fn request_to_send_0(&mut self) -> Result<(), SPI::Error> {
        self.spi.write(&[regs::RTS_TX0])
    }
}
