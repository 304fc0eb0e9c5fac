//! The chip without its core: its blocks, its clocks and resets, and the next event.
//!
//! Owns every peripheral and says when something happens by itself. It knows no board: the engine in `mod.rs` carries
//! frames, bytes and levels across. `map` decides what an address reaches, `transfers` what moves by DMA.
//!
//! Source: RP2040 datasheet 2.3.2 (interrupts), 2.13 and 2.14 (resets), 2.15 (clocks).
//!
//! Not modelled: contention for SRAM banks and the bus fabric.

use super::Stop;
use super::adc::Adc;
use super::bus::BusError;
use super::clocks::{Clocks, ROSC_HZ, Ratio, Timebase};
use super::dma::Dma;
use super::gpio::Gpio;
use super::names;
use super::pwm::Pwm;
use super::rom;
use super::sio::Sio;
use super::spi::Spi;
use super::system::System;
use super::timer::Timer;
use super::uart::Uart;
use super::watchdog::{Psm, Resets, Watchdog, block, psm};
use super::xip::Xip;
use crate::flash::Cells;
use crate::time::Nanos;

/// First address of SRAM.
pub(super) const RAM_BASE: u32 = 0x2000_0000;
/// Bytes of SRAM: four striped banks of 64 KiB and two of 4 KiB.
pub(super) const RAM_BYTES: usize = 264 * 1024;
/// What SRAM holds at power-on (on the chip: noise).
const RAM_POWER_ON: u8 = 0xa5;

pub(super) const NEVER: u64 = u64::MAX;

const IRQ_PWM: u32 = 4;
const IRQ_DMA0: u32 = 11;
const IRQ_IO_BANK0: u32 = 13;
const IRQ_SPI0: u32 = 18;
const IRQ_UART0: u32 = 20;
const IRQ_ADC: u32 = 22;

/// Something that happens by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    Board,
    Spi(usize),
    Uart(usize),
    Timer,
    Watchdog,
    Dma,
    Pwm,
    Adc,
}

pub(super) struct Chip {
    /// clk_sys cycles since power-on.
    pub(super) now: u64,
    /// The core runs until here, then the engine looks again.
    pub(super) limit: u64,
    /// Nothing outside the chip happens before this cycle, and the run does not end before it.
    pub(super) horizon: u64,
    /// Cycles that bus accesses have cost beyond the architectural ones.
    pub(super) extra: i32,
    pub(super) ram: Box<[u8; RAM_BYTES]>,
    pub(super) xip: Xip,
    pub(super) gpio: Gpio,
    pub(super) spi: [Spi; 2],
    pub(super) uart: [Uart; 2],
    pub(super) timer: Timer,
    pub(super) watchdog: Watchdog,
    pub(super) pwm: Pwm,
    pub(super) adc: Adc,
    pub(super) dma: Dma,
    pub(super) time: Timebase,
    pub(super) resets: Resets,
    pub(super) psm: Psm,
    pub(super) rom: Vec<u8>,
    pub(super) clocks: Clocks,
    pub(super) sio: Sio,
    pub(super) system: System,
    pub(super) timer_event: u64,
    pub(super) watchdog_event: u64,
    pub(super) board_event: u64,
    /// The time base has changed: cycles computed from nanoseconds are stale.
    pub(super) reclocked: bool,
    /// Pins may have changed.
    pub(super) outputs_touched: bool,
    /// PWM outputs may have changed, which is looked at with the pins.
    pub(super) pwm_touched: bool,
    pub(super) reset_request: Option<super::ResetCause>,
    pub(super) stop: Option<Stop>,
    /// Address of the last fetch, for messages.
    pub(super) pc: u32,
    /// SPI ports whose SCK and TX are on pins, and those whose RX is.
    pub(super) spi_out: [bool; 2],
    pub(super) spi_in: [bool; 2],
    /// SPI ports whose frames are served in batches: see [`Self::plan_stream`].
    pub(super) streams: u32,
    /// Offsets in SRAM that hold what is still to be streamed: first and length.
    pub(super) stream_source: (usize, usize),
}

impl Chip {
    pub(super) fn new(cells: Cells) -> Self {
        let clocks = Clocks::new();
        let ram: Box<[u8; RAM_BYTES]> = match vec![RAM_POWER_ON; RAM_BYTES].into_boxed_slice().try_into() {
            Ok(ram) => ram,
            Err(_) => unreachable!("the vector has RAM_BYTES bytes"),
        };
        Self {
            now: 0,
            limit: 0,
            horizon: 0,
            extra: 0,
            ram,
            xip: Xip::new(cells, ROSC_HZ),
            gpio: Gpio::new(),
            spi: [Spi::new(ROSC_HZ, 0), Spi::new(ROSC_HZ, 0)],
            uart: [Uart::new(ROSC_HZ, 0), Uart::new(ROSC_HZ, 0)],
            timer: Timer::new(0, None),
            watchdog: Watchdog::new(),
            pwm: Pwm::new(),
            adc: Adc::new(ROSC_HZ, 0),
            dma: Dma::new(),
            time: Timebase::new(clocks.sys_hz()),
            resets: Resets::new(),
            psm: Psm::default(),
            rom: rom::image(),
            clocks,
            sio: Sio::new(),
            system: System::new(),
            timer_event: NEVER,
            watchdog_event: NEVER,
            board_event: NEVER,
            reclocked: false,
            outputs_touched: false,
            pwm_touched: false,
            reset_request: None,
            stop: None,
            pc: 0,
            spi_out: [false; 2],
            spi_in: [false; 2],
            streams: 0,
            stream_source: (0, 0),
        }
    }

    /// The supply fails and comes back: all that is not in the flash is lost; time goes on, pins fall.
    pub(super) fn power_cycle(&mut self) {
        let now = self.now;
        self.xip.cut_power(now);
        self.gpio.reset_bank();
        self.gpio.reset_pads();
        self.gpio.reset_sio();
        let mut fresh = Self::new(Cells::new(Vec::new()));
        self.time.change(now, fresh.time.hz());
        self.xip.set_hz(fresh.time.hz());
        std::mem::swap(&mut fresh.time, &mut self.time);
        std::mem::swap(&mut fresh.xip, &mut self.xip);
        std::mem::swap(&mut fresh.gpio, &mut self.gpio);
        fresh.now = now;
        fresh.timer = Timer::new(now, None);
        fresh.reclocked = true;
        fresh.stop = self.stop.take();
        fresh.touch_outputs();
        *self = fresh;
    }

    pub(super) fn nanos(&self) -> Nanos {
        self.time.nanos(self.now)
    }

    /// Stops the run for a reason that has no register.
    pub(super) fn stop_for(&mut self, what: impl Into<String>) {
        let stop = Stop::Chip { what: what.into(), pc: self.pc, at: self.nanos() };
        self.stop.get_or_insert(stop);
        self.limit = 0;
    }

    pub(super) fn unmodelled<T>(&mut self, address: u32, write: bool) -> Result<T, BusError> {
        let register = names::register(address);
        let stop = Stop::Unmodelled { register, address, write, pc: self.pc, at: self.nanos() };
        self.stop.get_or_insert(stop);
        self.limit = 0;
        Err(BusError)
    }

    pub(super) fn unmapped_flash<T>(&mut self, address: u32) -> Result<T, BusError> {
        let stop = Stop::FlashUnmapped { address, pc: self.pc, at: self.nanos() };
        self.stop.get_or_insert(stop);
        self.limit = 0;
        Err(BusError)
    }

    /// The earliest event and its source.
    #[inline]
    pub(super) fn next_event(&self) -> (u64, Source) {
        let mut next = (self.board_event, Source::Board);
        let mut consider = |at: u64, source: Source| {
            if at < next.0 {
                next = (at, source);
            }
        };
        consider(self.spi[0].next_event, Source::Spi(0));
        consider(self.spi[1].next_event, Source::Spi(1));
        consider(self.timer_event, Source::Timer);
        consider(self.dma.next_event, Source::Dma);
        consider(self.uart[0].next_event, Source::Uart(0));
        consider(self.uart[1].next_event, Source::Uart(1));
        consider(self.watchdog_event, Source::Watchdog);
        consider(self.pwm.next_event, Source::Pwm);
        consider(self.adc.next_event, Source::Adc);
        next
    }

    /// Levels of the interrupt lines.
    #[inline]
    pub(super) fn irq_lines(&self) -> u32 {
        self.timer.irqs()
            | u32::from(self.pwm.irq()) << IRQ_PWM
            | self.dma.irqs() << IRQ_DMA0
            | u32::from(self.gpio.irq()) << IRQ_IO_BANK0
            | u32::from(self.spi[0].irq()) << IRQ_SPI0
            | u32::from(self.spi[1].irq()) << (IRQ_SPI0 + 1)
            | u32::from(self.uart[0].irq()) << IRQ_UART0
            | u32::from(self.uart[1].irq()) << (IRQ_UART0 + 1)
            | u32::from(self.adc.irq()) << IRQ_ADC
    }

    /// Re-derives everything that follows from the clock tree.
    pub(super) fn reclock(&mut self) {
        let sys = self.clocks.sys_hz();
        if sys == 0 {
            self.stop_for("clk_sys has stopped: its source oscillator or PLL does not run");
            return;
        }
        if sys != self.time.hz() {
            self.time.change(self.now, sys);
            self.xip.set_hz(sys);
            self.reclocked = true;
        }
        let (peri, adc) = (self.clocks.peri_hz(), self.clocks.adc_hz());
        for spi in &mut self.spi {
            spi.set_clocks(sys, peri);
        }
        for uart in &mut self.uart {
            uart.set_clocks(sys, peri);
        }
        self.adc.set_clocks(sys, adc);
        let tick = Ratio::new(sys, self.watchdog.tick_hz(self.clocks.ref_hz()));
        self.timer.set_tick(self.now, tick);
        self.watchdog.set_tick(self.now, tick);
        self.timer_event = self.timer.next_event();
        self.watchdog_event = self.watchdog.next_event();
        self.touch_outputs(); // PWM frequencies follow clk_sys
    }

    /// clk_peri in hertz.
    pub(super) fn peri_hz(&self) -> u64 {
        self.clocks.peri_hz()
    }

    /// Resets the blocks of RESETS whose bits are set.
    pub(super) fn reset_blocks(&mut self, blocks: u32) {
        let (sys, peri) = (self.time.hz(), self.clocks.peri_hz());
        let tick = Ratio::new(sys, self.watchdog.tick_hz(self.clocks.ref_hz()));
        let has = |bit: u32| blocks & 1 << bit != 0;
        for (i, bit) in [block::SPI0, block::SPI1].into_iter().enumerate() {
            if has(bit) {
                self.spi[i] = Spi::new(sys, peri);
            }
        }
        for (i, bit) in [block::UART0, block::UART1].into_iter().enumerate() {
            if has(bit) {
                self.uart[i] = Uart::new(sys, peri);
            }
        }
        for (i, bit) in [block::PLL_SYS, block::PLL_USB].into_iter().enumerate() {
            if has(bit) {
                self.clocks.reset_pll(i);
            }
        }
        if has(block::ADC) {
            self.adc.reset();
        }
        if has(block::BUSCTRL) {
            self.system.reset_busctrl();
        }
        if has(block::DMA) {
            self.dma = Dma::new();
        }
        if has(block::IO_BANK0) {
            self.gpio.reset_bank();
            self.route_pins();
        }
        if has(block::IO_QSPI) {
            self.system.reset_qspi_bank();
            self.xip.force_select(None, self.now);
        }
        if has(block::PADS_BANK0) {
            self.gpio.reset_pads();
        }
        if has(block::PADS_QSPI) {
            self.system.reset_qspi_pads();
        }
        if has(block::PWM) {
            self.pwm = Pwm::new();
        }
        if has(block::SYSCFG) {
            self.system.reset_syscfg();
        }
        if has(block::TIMER) {
            self.timer = Timer::new(self.now, tick);
        }
        self.touch_outputs();
        self.reclock();
    }

    /// Pins and PWM outputs may have changed.
    pub(super) fn touch_outputs(&mut self) {
        self.outputs_touched = true;
        self.pwm_touched = true;
    }

    /// A watchdog reset: what PSM.WDSEL and RESETS.WDSEL select. `true` if the core is among it.
    pub(super) fn watchdog_reset(&mut self, reason: u32) -> bool {
        let stages = self.psm.wdsel;
        let has = |bit: u32| stages & bit != 0;
        self.watchdog.reset_keeping_scratch(reason);
        let blocks = if has(psm::RESETS) { block::ALL } else { self.resets.wdsel };
        if has(psm::CLOCKS) {
            self.clocks.reset_generators();
        }
        if has(psm::XOSC) {
            self.clocks.reset_xosc();
        }
        if has(psm::RESETS) {
            self.resets = Resets::new();
        }
        self.resets.held |= blocks;
        self.reset_blocks(blocks);
        if has(psm::XIP) {
            self.xip.reset(self.now);
        }
        if has(psm::SIO) {
            self.sio = Sio::new();
            self.gpio.reset_sio();
        }
        has(psm::PROC0)
    }

    /// What the boot ROM does to the peripherals before it looks at the flash.
    pub(super) fn boot_rom_resets(&mut self) {
        let blocks = 1 << block::IO_QSPI | 1 << block::PADS_QSPI | 1 << block::TIMER;
        self.reset_blocks(blocks);
        self.resets.held &= !blocks;
    }

    pub(super) fn route_pins(&mut self) {
        const FUNCTION_SPI: u32 = 1;
        let mut routed = [[false; 4]; 2];
        for pin in 0..super::gpio::PINS {
            if self.gpio.function(pin) == FUNCTION_SPI {
                // Pins come in fours: RX, CSn, SCK, TX; and in eights per port.
                routed[pin / 8 % 2][pin % 4] |= pin % 4 != 0 || self.gpio.has_input(pin);
            }
        }
        self.spi_in = routed.map(|[rx, ..]| rx);
        self.spi_out = routed.map(|[_, _, sck, tx]| sck && tx);
    }

    /// Whether UART `port`'s TX is on a pin.
    pub(super) fn is_uart_routed(&self, port: usize) -> bool {
        const FUNCTION_UART: u32 = 2;
        (0..super::gpio::PINS)
            .any(|pin| pin % 4 == 0 && (pin + 4) / 8 % 2 == port && self.gpio.function(pin) == FUNCTION_UART)
    }
}
