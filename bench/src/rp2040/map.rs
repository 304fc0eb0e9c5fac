//! The address map: which memory or register an address reaches, and what the access costs.
//!
//! Owns the order in which targets are tried (SRAM and flash first: they are the hot path), the atomic aliases, and the
//! replication of narrow stores. A block that RESETS holds reads 0 and ignores writes.
//!
//! Source: RP2040 datasheet 2.1 (bus fabric), 2.2 (address map). An APB read takes 3 cycles on the bus and a write 4
//! (2.1.4), so a load adds 2 and a store 3 to the core's own 2; SIO answers within one (-1).
//!
//! Not modelled: I2C, PIO, RTC, USB and the interpolators, which stop the run when touched.

use super::ResetCause;
use super::bus::{BusError, Width};
use super::chip::{Chip, NEVER, RAM_BASE, RAM_BYTES};
use super::rom;
use super::system::System;
use super::watchdog::block;
use super::xip::Port;

const RAM_UNSTRIPED: u32 = 0x2100_0000;
const APB_READ_EXTRA: i32 = 2;
const APB_WRITE_EXTRA: i32 = 3;
const SIO_EXTRA: i32 = -1;

impl Chip {
    #[inline]
    pub(super) fn ram_load(&self, offset: usize, width: Width) -> u32 {
        match width {
            Width::Byte => u32::from(self.ram[offset]),
            Width::Half => {
                let offset = offset & !1;
                u32::from(u16::from_le_bytes([self.ram[offset], self.ram[offset + 1]]))
            }
            Width::Word => {
                let offset = offset & !3;
                let ram = &self.ram;
                u32::from_le_bytes([ram[offset], ram[offset + 1], ram[offset + 2], ram[offset + 3]])
            }
        }
    }

    #[inline]
    pub(super) fn ram_store(&mut self, offset: usize, width: Width, value: u32) {
        let bytes = value.to_le_bytes();
        match width {
            Width::Byte => self.ram[offset] = bytes[0],
            Width::Half => {
                let offset = offset & !1;
                self.ram[offset..offset + 2].copy_from_slice(&bytes[..2]);
            }
            Width::Word => {
                let offset = offset & !3;
                self.ram[offset..offset + 4].copy_from_slice(&bytes);
            }
        }
    }

    /// Offset in SRAM of an address in the unstriped alias of banks 0 to 3.
    fn unstriped(address: u32) -> Option<usize> {
        let offset = address.wrapping_sub(RAM_UNSTRIPED);
        if offset >= 4 << 16 {
            return None;
        }
        let (bank, word, byte) = (offset >> 16, (offset & 0xffff) >> 2, offset & 3);
        Some(((word << 2 | bank) << 2 | byte) as usize)
    }

    #[inline]
    pub(super) fn fetch(&mut self, address: u32) -> Result<u16, BusError> {
        self.pc = address;
        let offset = address.wrapping_sub(RAM_BASE) as usize;
        if offset < RAM_BYTES {
            let offset = offset & !1;
            return Ok(u16::from_le_bytes([self.ram[offset], self.ram[offset + 1]]));
        }
        if address >> 26 == 0x1000_0000 >> 26 {
            return match self.xip.line(Port::Fetch, address, &mut self.extra) {
                Ok(line) => Ok((line >> ((address & 6) * 8)) as u16),
                Err(_) => self.unmapped_flash(address),
            };
        }
        self.fetch_elsewhere(address)
    }

    fn fetch_elsewhere(&mut self, address: u32) -> Result<u16, BusError> {
        if address < rom::ROM_BYTES {
            let at = address as usize & !1;
            return Ok(u16::from_le_bytes([self.rom[at], self.rom[at + 1]]));
        }
        match Self::unstriped(address) {
            Some(offset) => Ok((self.ram_load(offset, Width::Half) & 0xffff) as u16),
            None => Err(BusError),
        }
    }

    #[inline]
    pub(super) fn load(&mut self, address: u32, width: Width) -> Result<u32, BusError> {
        let offset = address.wrapping_sub(RAM_BASE) as usize;
        if offset < RAM_BYTES {
            return Ok(self.ram_load(offset, width));
        }
        if address >> 26 == 0x1000_0000 >> 26 {
            return match self.xip.line(Port::Data, address, &mut self.extra) {
                Ok(line) => Ok(lane((line >> ((address & 4) * 8)) as u32, address, width)),
                Err(_) => self.unmapped_flash(address),
            };
        }
        self.load_elsewhere(address, width)
    }

    #[inline(never)]
    fn load_elsewhere(&mut self, address: u32, width: Width) -> Result<u32, BusError> {
        let word = match address >> 28 {
            0x0 if address < rom::ROM_BYTES => {
                let at = address as usize & !3;
                u32::from_le_bytes([self.rom[at], self.rom[at + 1], self.rom[at + 2], self.rom[at + 3]])
            }
            0x1 => self.read_xip_block(address)?,
            0x2 => {
                let offset = Self::unstriped(address).ok_or(BusError)?;
                return Ok(self.ram_load(offset, width));
            }
            0x4 => {
                self.extra += APB_READ_EXTRA;
                self.read_apb(address)?
            }
            0x5 => self.read_ahb(address)?,
            0xd => {
                self.extra += SIO_EXTRA;
                self.read_sio(address)?
            }
            _ => return Err(BusError),
        };
        Ok(lane(word, address, width))
    }

    /// Stores anywhere but striped SRAM.
    #[inline(never)]
    pub(super) fn store_elsewhere(&mut self, address: u32, width: Width, value: u32) -> Result<(), BusError> {
        // The bus replicates a narrow store over all lanes and peripherals take the whole word.
        let word = match width {
            Width::Byte => (value & 0xff) * 0x0101_0101,
            Width::Half => (value & 0xffff) * 0x0001_0001,
            Width::Word => value,
        };
        match address >> 28 {
            0x1 if address >> 26 == 0x1000_0000 >> 26 => {
                if self.xip.store(address) {
                    Ok(())
                } else {
                    Err(BusError)
                }
            }
            0x1 => self.write_xip_block(address, word),
            0x2 => {
                let offset = Self::unstriped(address).ok_or(BusError)?;
                self.ram_store(offset, width, value);
                Ok(())
            }
            0x4 => {
                self.extra += APB_WRITE_EXTRA;
                self.write_apb(address, word)
            }
            0x5 => self.write_ahb(address, word),
            0xd => {
                self.extra += SIO_EXTRA;
                self.write_sio(address, word)
            }
            _ => Err(BusError),
        }
    }

    // --- peripherals

    fn read_xip_block(&mut self, address: u32) -> Result<u32, BusError> {
        let value = match address >> 24 {
            0x14 => self.xip.read_ctrl(address & 0xfff),
            0x18 => self.xip.read_ssi(address & 0xfff, self.now),
            _ => None,
        };
        value.map_or_else(|| self.unmodelled(address, false), Ok)
    }

    fn write_xip_block(&mut self, address: u32, value: u32) -> Result<(), BusError> {
        let done = match address >> 24 {
            0x14 => {
                let current = self.xip.read_ctrl(address & 0xfff).unwrap_or(0);
                self.xip.write_ctrl(address & 0xfff, merged(address, current, value))
            }
            0x18 => self.xip.write_ssi(address & 0xfff, value, self.now),
            _ => None,
        };
        done.map_or_else(|| self.unmodelled(address, true), Ok)
    }

    fn read_sio(&mut self, address: u32) -> Result<u32, BusError> {
        let offset = address & 0xfff;
        let value = self.gpio.read_sio(offset).or_else(|| self.sio.read(offset, self.now));
        value.map_or_else(|| self.unmodelled(address, false), Ok)
    }

    fn write_sio(&mut self, address: u32, value: u32) -> Result<(), BusError> {
        let offset = address & 0xfff;
        if self.gpio.write_sio(offset, value).is_some() {
            self.outputs_touched = true;
            return Ok(());
        }
        let done = self.sio.write(offset, value, self.now);
        done.map_or_else(|| self.unmodelled(address, true), Ok)
    }

    /// Whether RESETS holds the block at `address`.
    fn is_held(&self, address: u32) -> bool {
        // By 16 KiB slot of the APB; 31 = never held.
        const BLOCKS: [u32; 28] = [
            block::SYSINFO,
            block::SYSCFG,
            31,
            31,
            31,
            block::IO_BANK0,
            block::IO_QSPI,
            block::PADS_BANK0,
            block::PADS_QSPI,
            31,
            block::PLL_SYS,
            block::PLL_USB,
            block::BUSCTRL,
            block::UART0,
            block::UART1,
            block::SPI0,
            block::SPI1,
            block::I2C0,
            block::I2C1,
            block::ADC,
            block::PWM,
            block::TIMER,
            31,
            block::RTC,
            31,
            31,
            31,
            block::TBMAN,
        ];
        let bit = match address >> 20 {
            0x400 => BLOCKS.get((address >> 14 & 0x3f) as usize).copied().unwrap_or(31),
            0x500 => block::DMA,
            0x501 => block::USBCTRL,
            0x502 => block::PIO0,
            0x503 => block::PIO1,
            _ => 31,
        };
        self.resets.held & 1 << bit != 0
    }

    fn read_apb(&mut self, address: u32) -> Result<u32, BusError> {
        if self.is_held(address) {
            return Ok(0);
        }
        let (offset, now) = (address & 0xffc, self.now);
        let value = match address >> 14 & 0x3f {
            _ if address >> 20 != 0x400 => return Err(BusError),
            0 => System::read_sysinfo(offset),
            1 => self.system.read_syscfg(offset),
            2 => self.clocks.read(offset),
            3 => self.resets.read(offset),
            4 => self.psm.read(offset),
            5 => self.gpio.read_bank(offset),
            6 => self.system.read_qspi_bank(offset),
            7 => self.gpio.read_pads(offset),
            8 => self.system.read_qspi_pads(offset),
            9 => self.clocks.read_xosc(offset, self.nanos()),
            slot @ (10 | 11) => self.clocks.read_pll(slot as usize - 10, offset, self.nanos()),
            12 => self.system.read_busctrl(offset),
            slot @ (13 | 14) => {
                self.limit = 0;
                self.uart[slot as usize - 13].read(offset)
            }
            slot @ (15 | 16) => {
                // Reading data may drop an interrupt line.
                self.limit = if offset == 8 { 0 } else { self.limit };
                self.spi[slot as usize - 15].read(offset)
            }
            19 => {
                self.limit = 0;
                self.adc.read(offset)
            }
            20 => self.pwm.read(offset, now),
            21 => self.timer.read(offset, now),
            22 => self.watchdog.read(offset, now),
            24 => self.clocks.read_rosc(offset),
            25 => self.system.read_vreg(offset),
            27 => System::read_tbman(offset),
            _ => None,
        };
        value.map_or_else(|| self.unmodelled(address, false), Ok)
    }

    fn write_apb(&mut self, address: u32, value: u32) -> Result<(), BusError> {
        self.limit = 0;
        if self.is_held(address) {
            return Ok(());
        }
        let (offset, now) = (address & 0xffc, self.now);
        let slot = address >> 14 & 0x3f;
        // A data register has no atomic aliases worth the name: reading it would take an entry.
        let value = match address >> 12 & 3 {
            0 => value,
            _ if matches!((slot, offset), (13 | 14, 0) | (15 | 16, 8) | (19, 0xc)) => value,
            _ => {
                let current = self.read_apb(address & !0x3000)?;
                merged(address, current, value)
            }
        };
        let done = match slot {
            _ if address >> 20 != 0x400 => return Err(BusError),
            0 | 27 => Some(()),
            1 => self.system.write_syscfg(offset, value),
            2 => self.clocks.write(offset, value).map(|()| self.reclock()),
            3 => self.resets.write(offset, value).map(|entering| {
                if entering != 0 {
                    self.reset_blocks(entering);
                }
            }),
            4 => self.psm.write(offset, value),
            5 => self.gpio.write_bank(offset, value).map(|()| {
                self.route_pins();
                self.touch_outputs();
            }),
            6 => self.system.write_qspi_bank(offset, value).map(|select| {
                if let Some(level) = select {
                    self.xip.force_select(level, now);
                }
            }),
            7 => self.gpio.write_pads(offset, value).map(|()| {
                self.route_pins();
                self.touch_outputs();
            }),
            8 => self.system.write_qspi_pads(offset, value),
            9 => self.clocks.write_xosc(offset, value, self.nanos()).map(|()| self.reclock()),
            10 | 11 => {
                let at = self.nanos();
                self.clocks.write_pll(slot as usize - 10, offset, value, at).map(|()| self.reclock())
            }
            12 => self.system.write_busctrl(offset, value),
            13 | 14 => {
                let port = slot as usize - 13;
                let done = self.uart[port].write(offset, value, now);
                self.feed_uart(port);
                done
            }
            15 | 16 => {
                let port = slot as usize - 15;
                let done = self.spi[port].write(offset, value, now);
                if offset != 8 {
                    self.feed_spi(port);
                }
                done
            }
            19 => self.adc.write(offset, value, now),
            20 => {
                self.touch_outputs();
                self.pwm.write(offset, value, now)
            }
            21 => {
                let done = self.timer.write(offset, value, now);
                self.timer_event = self.timer.next_event();
                done
            }
            22 => self.watchdog.write(offset, value, now).map(|forced| {
                if forced {
                    self.reset_request = Some(ResetCause::WatchdogForce);
                }
                self.reclock();
            }),
            24 => self.clocks.write_rosc(offset, value),
            25 => self.system.write_vreg(offset, value),
            _ => None,
        };
        done.map_or_else(|| self.unmodelled(address, true), Ok)
    }

    fn read_ahb(&mut self, address: u32) -> Result<u32, BusError> {
        if address >> 20 != 0x500 {
            return self.unmodelled(address, false);
        }
        if self.is_held(address) {
            return Ok(0);
        }
        // Only unpaced and timed channels move without an event of their own.
        if self.dma.next_event != NEVER {
            self.serve_dma();
            self.limit = 0;
        }
        self.dma.read(address & 0xffc).map_or_else(|| self.unmodelled(address, false), Ok)
    }

    fn write_ahb(&mut self, address: u32, value: u32) -> Result<(), BusError> {
        self.limit = 0;
        if address >> 20 != 0x500 {
            return self.unmodelled(address, true);
        }
        if self.is_held(address) {
            return Ok(());
        }
        self.serve_dma();
        let offset = address & 0xffc;
        let value = match address >> 12 & 3 {
            0 => value,
            _ => merged(address, self.dma.read(offset).unwrap_or(0), value),
        };
        if self.dma.write(offset, value, self.now).is_none() {
            return self.unmodelled(address, true);
        }
        self.serve_dma();
        Ok(())
    }

    #[inline]
    pub(super) fn store(&mut self, address: u32, width: Width, value: u32) -> Result<(), BusError> {
        let offset = address.wrapping_sub(RAM_BASE) as usize;
        if offset < RAM_BYTES {
            self.ram_store(offset, width, value);
            return Ok(());
        }
        self.store_elsewhere(address, width, value)
    }
}

/// The lane of `word` that a narrow load of `address` sees.
fn lane(word: u32, address: u32, width: Width) -> u32 {
    match width {
        Width::Byte => word >> (8 * (address & 3)) & 0xff,
        Width::Half => word >> (8 * (address & 2)) & 0xffff,
        Width::Word => word,
    }
}

/// What a store through the XOR, SET or CLR alias writes.
fn merged(address: u32, current: u32, value: u32) -> u32 {
    match address >> 12 & 3 {
        1 => current ^ value,
        2 => current | value,
        3 => current & !value,
        _ => value,
    }
}
