//! Owns the chip: start-up, service of INT, transmission, supervision.
//!
//! Decides nothing that [`crate::irq`] or [`crate::timing`] can decide. Every loop has a limit. Time comes in as
//! milliseconds; there is no clock here. One owner only: the application locks the driver for each call.

use crate::acceptance::{self, Acceptance};
use crate::cmd::{Bank, Commands};
use crate::frame::{self, Received};
use crate::irq::{self, BusState};
use crate::regs::{self, Register};
use crate::timing::{BitTiming, SAMPLE_POINT, TimingError};
use embedded_can::Frame;
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::InputPin;
use embedded_hal::spi::SpiDevice;

/// Crystal of the module. Blue modules mostly carry 8 MHz: read what is printed on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Oscillator {
    /// 8 MHz, as most modules have it.
    Mhz8,
    /// 16 MHz.
    Mhz16,
}

impl Oscillator {
    /// Returns the frequency in Hz.
    pub const fn hz(self) -> u32 {
        match self {
            Self::Mhz8 => 8_000_000,
            Self::Mhz16 => 16_000_000,
        }
    }
}

/// How the node takes part in the bus.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Sends, acknowledges and signals errors.
    #[default]
    Normal,
    /// Never drives the bus, not even to acknowledge. A single other sender then finds nobody to acknowledge it.
    ListenOnly,
    /// Sends to itself without touching the bus: for a test without a transceiver.
    Loopback,
}

impl Mode {
    /// Returns the mode as CANSTAT shows it and CANCTRL asks for it.
    const fn opmod(self) -> u8 {
        match self {
            Self::Normal => regs::OPMOD_NORMAL,
            Self::ListenOnly => regs::OPMOD_LISTEN_ONLY,
            Self::Loopback => regs::OPMOD_LOOPBACK,
        }
    }

    /// Returns CANSTAT, of that the bits [`regs::OPMOD`], and CANCTRL of a chip in this mode.
    const fn registers(self) -> [u8; 2] {
        [self.opmod(), self.opmod() | regs::CLKPRE]
    }
}

/// How to start the chip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config {
    /// Crystal of the module.
    pub oscillator: Oscillator,
    /// Bit rate of the bus in bits per second.
    pub bitrate: u32,
    /// How the node takes part.
    pub mode: Mode,
    /// Hardware filters, `None` = every data frame.
    pub acceptance: Option<Acceptance>,
}

/// Why the chip did not start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StartError<E> {
    /// The chip does not answer as it must after a reset: check wiring, supply and chip select.
    /// 0xFF or 0x00 in both bytes means that nothing drives MISO.
    Probe {
        /// CANSTAT and CANCTRL after a reset, of the latter the bits [`regs::CANCTRL_PROBE`].
        expected: [u8; 2],
        /// What was read.
        actual: [u8; 2],
    },
    /// A register does not read back as written: check the SPI clock (at most 10 MHz), the wires' length and contacts.
    Readback {
        /// Address of the register.
        address: u8,
        /// What was written.
        expected: u8,
        /// What was read.
        actual: u8,
    },
    /// The chip refuses a mode: check the CAN transceiver (a bus that is never recessive keeps it waiting).
    Mode {
        /// CANSTAT, of that OPMOD (bits 7 to 5), and CANCTRL in the mode asked for.
        expected: [u8; 2],
        /// What was read.
        actual: [u8; 2],
    },
    /// Crystal and bit rate do not go together.
    Timing(TimingError),
    /// The SPI bus failed.
    Spi(E),
}

impl<E: core::fmt::Debug> core::fmt::Display for StartError<E> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Probe { expected, actual } => {
                write!(
                    f,
                    "no MCP2515: CANSTAT, CANCTRL {actual:02x?}, expected {expected:02x?}; check wiring"
                )
            }
            Self::Readback { address, expected, actual } => {
                write!(
                    f,
                    "MCP2515 register {address:02x} {actual:02x}, wrote {expected:02x}; check SPI clock and wires"
                )
            }
            Self::Mode { expected, actual } => {
                write!(
                    f,
                    "MCP2515 mode: CANSTAT, CANCTRL {actual:02x?}, expected {expected:02x?}; check the CAN transceiver"
                )
            }
            Self::Timing(error) => write!(f, "MCP2515 bit timing: {error:?}; check crystal and bit rate"),
            Self::Spi(error) => write!(f, "MCP2515 SPI: {error:?}"),
        }
    }
}

/// Starts that were refused, by reason; counters stop at their maximum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Refusals {
    /// No chip has answered: [`StartError::Probe`].
    pub probe: u32,
    /// A register has not read back: [`StartError::Readback`].
    pub readback: u32,
    /// The chip has not entered its mode: [`StartError::Mode`].
    pub mode: u32,
    /// No timing for crystal and bit rate: [`StartError::Timing`].
    pub timing: u32,
    /// The SPI bus has failed: [`StartError::Spi`].
    pub spi: u32,
}

impl Refusals {
    /// None so far.
    pub const NONE: Self = Self { probe: 0, readback: 0, mode: 0, timing: 0, spi: 0 };

    /// Counts a refusal.
    pub const fn note<E>(&mut self, error: &StartError<E>) {
        let counter = match error {
            StartError::Probe { .. } => &mut self.probe,
            StartError::Readback { .. } => &mut self.readback,
            StartError::Mode { .. } => &mut self.mode,
            StartError::Timing(_) => &mut self.timing,
            StartError::Spi(_) => &mut self.spi,
        };
        *counter = counter.saturating_add(1);
    }

    /// Returns how many there were of all kinds.
    pub const fn total(self) -> u32 {
        let Self { probe, readback, mode, timing, spi } = self;
        probe.saturating_add(readback).saturating_add(mode).saturating_add(timing).saturating_add(spi)
    }
}

impl<E> From<E> for StartError<E> {
    fn from(error: E) -> Self {
        Self::Spi(error)
    }
}

/// A chip that did not start, with the parts to try again.
pub struct Refused<SPI: SpiDevice, INT> {
    /// Why.
    pub error: StartError<SPI::Error>,
    /// The SPI device.
    pub spi: SPI,
    /// The INT pin.
    pub int: INT,
}

/// Why a frame was not taken for transmission.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TransmitError<E> {
    /// The frame before it still waits for the bus.
    Busy,
    /// The node only listens.
    ListenOnly,
    /// The node went off the bus less than [`BUS_OFF_SILENCE_MS`] ago and spares it.
    Silent,
    /// The SPI bus failed.
    Spi(E),
}

impl<E> From<E> for TransmitError<E> {
    fn from(error: E) -> Self {
        Self::Spi(error)
    }
}

/// Counters and states since start-up; counters stop at their maximum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Health {
    /// Data frames received.
    pub received: u32,
    /// Remote frames received and dropped.
    pub remote: u32,
    /// Overrun flags seen: each stands for at least one frame lost in the chip.
    pub overruns: u32,
    /// Frames sent and acknowledged.
    pub sent: u32,
    /// Frames given up because the bus did not take them within [`TRANSMIT_LIMIT_MS`] or the node went off it.
    pub aborted: u32,
    /// Times the node went off the bus.
    pub bus_offs: u32,
    /// Times a frame lay in the chip while INT was high: a broken INT wire.
    pub missed_interrupts: u32,
    /// Services that ended with INT still low: INT stuck, or a chip that lost its mind.
    pub undrained: u32,
    /// Restarts after the chip had left its mode, for example by a dip of its supply.
    pub restarts: u32,
    /// Transmit error counter (TEC).
    pub transmit_errors: u8,
    /// Receive error counter (REC).
    pub receive_errors: u8,
    /// State of the node.
    pub state: BusState,
}

/// What one service did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Serviced {
    /// Data frames given to the sink.
    pub frames: u8,
    /// INT is high again. If not, mask its interrupt until the next tick.
    pub drained: bool,
}

/// What supervision found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The chip does what it should.
    Well,
    /// A frame waits although INT is high: call [`Mcp2515::service`] now, and again each tick.
    FrameWaiting,
    /// The chip is not in its mode, or has been off the bus for too long: call [`Mcp2515::restart`].
    Restart,
}

/// Longest wait of a frame for the bus, in milliseconds: at 250 kbit/s even a full bus lets 150 others pass.
pub const TRANSMIT_LIMIT_MS: u64 = 100;
/// Time without a request to send from when bus-off is noticed, in milliseconds. The chip itself would send again
/// after 128 * 11 bits (6 ms at 250 kbit/s), and if its frames all fail be off again every 20 ms.
pub const BUS_OFF_SILENCE_MS: u64 = 1_000;
/// Longest stay off the bus before the chip is restarted, in milliseconds; 128 times 11 free bits end it.
pub const BUS_OFF_LIMIT_MS: u64 = 1_000;

/// Passes of one service. Each takes up to two frames of 47 bits or more, so a running chip needs two or three.
const SERVICE_PASSES: u8 = 8;
/// Polls of the probe, 100 us apart: the crystal starts within 2 ms.
const PROBE_POLLS: u8 = 20;
/// Polls of a mode change, 100 us apart: the longest frame at 125 kbit/s lasts 1.3 ms.
const MODE_POLLS: u8 = 20;
const POLL_US: u32 = 100;

/// The driver. `SPI` is a device in mode 0,0 at no more than 10 MHz, `INT` the chip's interrupt pin.
pub struct Mcp2515<SPI, INT> {
    commands: Commands<SPI>,
    int: INT,
    config: Config,
    health: Health,
    pending_since_ms: Option<u64>,
    bus_off_since_ms: Option<u64>,
    /// Bus-off was noticed by a service, which has no time: the silence starts with the next call that has.
    silence_due: bool,
    silent_until_ms: u64,
}

impl<SPI: SpiDevice, INT: InputPin> Mcp2515<SPI, INT> {
    /// Resets, probes and configures the chip and joins the bus. Takes up to 5 ms.
    ///
    /// # Errors
    /// When the chip does not answer as expected; the parts come back for another attempt.
    pub fn new(
        spi: SPI,
        int: INT,
        config: Config,
        delay: &mut impl DelayNs,
    ) -> Result<Self, Refused<SPI, INT>> {
        let mut driver = Self {
            commands: Commands::new(spi),
            int,
            config,
            health: Health::default(),
            pending_since_ms: None,
            bus_off_since_ms: None,
            silence_due: false,
            silent_until_ms: 0,
        };
        match driver.start(delay) {
            Ok(()) => Ok(driver),
            Err(error) => {
                let (spi, int) = driver.free();
                Err(Refused { error, spi, int })
            }
        }
    }

    /// Gives the parts back.
    pub fn free(self) -> (SPI, INT) {
        (self.commands.free(), self.int)
    }

    /// Returns the counters.
    pub const fn health(&self) -> Health {
        self.health
    }

    /// Returns the configuration.
    pub const fn config(&self) -> Config {
        self.config
    }

    /// Lends the INT pin, to mask and arm its interrupt.
    #[inline(always)]
    pub const fn int(&mut self) -> &mut INT {
        &mut self.int
    }

    /// Starts the chip anew; a frame that waits to be sent is dropped and counted. Takes up to 5 ms.
    ///
    /// # Errors
    /// As in [`Self::new`]; call it again later.
    pub fn restart(&mut self, delay: &mut impl DelayNs) -> Result<(), StartError<SPI::Error>> {
        count(&mut self.health.restarts, 1);
        self.abandon();
        self.start(delay)
    }

    /// Forgets what a restart ends. The silence after bus-off is none of it: the bus is the same.
    fn abandon(&mut self) {
        if self.pending_since_ms.take().is_some() {
            count(&mut self.health.aborted, 1);
        }
        self.bus_off_since_ms = None;
    }

    /// Starts the chip anew as `config` says, for example at another bit rate; the counters stay. Takes up to 5 ms.
    ///
    /// # Errors
    /// As in [`Self::new`]; call it again later.
    pub fn reconfigure(
        &mut self,
        config: Config,
        delay: &mut impl DelayNs,
    ) -> Result<(), StartError<SPI::Error>> {
        self.config = config;
        self.abandon();
        self.start(delay)
    }

    /// Asks for another mode, without a restart and without losing a frame: the chip changes over between two frames.
    ///
    /// Whether it did is seen by the next [`Self::supervise`], which must not come within 2 ms. A frame that still waits
    /// is taken back when the node is only to listen: it would go out as soon as it may send again.
    ///
    /// # Errors
    /// When the SPI bus fails.
    pub fn change_mode(&mut self, mode: Mode) -> Result<(), SPI::Error> {
        if mode == Mode::ListenOnly {
            self.take_back()?;
        }
        self.config.mode = mode;
        self.commands.bit_modify(Register::CANCTRL, regs::REQOP, mode.opmod())
    }

    /// Returns whether a frame with an error was on the bus since the last call: on a node that only listens, the sign
    /// of a wrong bit rate (DS20001801 section 7.4).
    ///
    /// # Errors
    /// When the SPI bus fails.
    pub fn take_message_error(&mut self) -> Result<bool, SPI::Error> {
        let [canintf, _] = self.commands.read_pair(Register::CANINTF)?;
        let met = canintf & regs::MERRF != 0;
        if met {
            self.commands.bit_modify(Register::CANINTF, regs::MERRF, 0)?;
        }
        Ok(met)
    }

    /// Empties the receive buffers in the order of arrival and clears error flags, until INT is high.
    ///
    /// # Errors
    /// When the SPI bus fails.
    #[inline(always)]
    pub fn service<F: Frame>(&mut self, mut sink: impl FnMut(F)) -> Result<Serviced, SPI::Error> {
        let mut frames = 0;
        let mut released = None;
        for pass in 0..SERVICE_PASSES {
            // The first pass trusts the caller: polling works even with a broken INT wire.
            if pass != 0 && self.int.is_high().unwrap_or(false) {
                return Ok(Serviced { frames, drained: true });
            }
            let reads = irq::reads(self.commands.rx_status()?, released);
            if reads[0].is_none() {
                self.clear_flags()?;
            }
            for buffer in reads.into_iter().flatten() {
                match frame::decode(&self.commands.read_rx_buffer(buffer)?) {
                    Received::Data(frame) => {
                        frames += 1;
                        count(&mut self.health.received, 1);
                        sink(frame);
                    }
                    Received::Remote => count(&mut self.health.remote, 1),
                }
                released = Some(buffer);
            }
        }
        let drained = self.int.is_high().unwrap_or(false);
        if !drained {
            count(&mut self.health.undrained, 1);
        }
        Ok(Serviced { frames, drained })
    }

    /// Takes a frame for transmission through TXB0.
    ///
    /// One buffer only: the chip orders its three by number, not by identifier, and TXB1 and TXB2 can be corrupted
    /// by a reception at the same time (errata 2).
    ///
    /// # Errors
    /// When the frame before it still waits, the node only listens or was off the bus, or the SPI bus fails.
    pub fn transmit(&mut self, frame: &impl Frame, now_ms: u64) -> Result<(), TransmitError<SPI::Error>> {
        if self.config.mode == Mode::ListenOnly {
            return Err(TransmitError::ListenOnly);
        }
        self.start_silence(now_ms);
        if now_ms < self.silent_until_ms {
            return Err(TransmitError::Silent);
        }
        if self.settle_transmission(now_ms)? {
            return Err(TransmitError::Busy);
        }
        let (buffer, len) = frame::encode(frame);
        self.commands.load_tx_buffer_0(&buffer, len)?;
        self.commands.request_to_send_0()?;
        self.pending_since_ms = Some(now_ms);
        Ok(())
    }

    /// Looks after the chip: call every 100 ms or so.
    ///
    /// Finishes or gives up a transmission, reads the error counters, counts bus-off, and notices a chip that lost
    /// its mode or whose INT wire is broken.
    ///
    /// # Errors
    /// When the SPI bus fails.
    pub fn supervise(&mut self, now_ms: u64) -> Result<Verdict, SPI::Error> {
        self.settle_transmission(now_ms)?;
        if self.read_mode()? != self.config.mode.registers() {
            return Ok(Verdict::Restart);
        }
        self.clear_flags()?;
        self.start_silence(now_ms);
        let [tec, rec] = self.commands.read_pair(Register::TEC)?;
        self.health.transmit_errors = tec;
        self.health.receive_errors = rec;
        let off_bus = self.health.state == BusState::BusOff;
        let since_ms = *self.bus_off_since_ms.get_or_insert(now_ms);
        match off_bus {
            false => self.bus_off_since_ms = None,
            true if now_ms.saturating_sub(since_ms) >= BUS_OFF_LIMIT_MS => return Ok(Verdict::Restart),
            true => {}
        }
        let full = self.commands.rx_status()? & (regs::RX_STATUS_RX0 | regs::RX_STATUS_RX1) != 0;
        if full && self.int.is_high().unwrap_or(false) {
            count(&mut self.health.missed_interrupts, 1);
            return Ok(Verdict::FrameWaiting);
        }
        Ok(Verdict::Well)
    }

    fn start(&mut self, delay: &mut impl DelayNs) -> Result<(), StartError<SPI::Error>> {
        let timing = BitTiming::solve(self.config.oscillator.hz(), self.config.bitrate, SAMPLE_POINT)
            .map_err(StartError::Timing)?;
        self.probe(delay)?;
        self.configure(timing)?;
        self.enter_mode(delay)
    }

    /// Resets the chip and waits for it: 128 crystal periods after the reset (8.1), and up to 2 ms for a crystal that
    /// is only starting.
    fn probe(&mut self, delay: &mut impl DelayNs) -> Result<(), StartError<SPI::Error>> {
        let expected = [regs::OPMOD_CONFIGURATION, regs::CANCTRL_AFTER_RESET];
        let mut actual = [0; 2];
        self.commands.reset()?;
        for _ in 0..PROBE_POLLS {
            delay.delay_us(POLL_US);
            let [canstat, canctrl] = self.commands.read_pair(Register::CANSTAT)?;
            actual = [canstat, canctrl & regs::CANCTRL_PROBE];
            if actual == expected {
                self.health.state = BusState::Active;
                return Ok(());
            }
        }
        Err(StartError::Probe { expected, actual })
    }

    /// Writes all registers that matter, then reads them all: a byte that went astray may have hit one written before.
    fn configure(&mut self, timing: BitTiming) -> Result<(), StartError<SPI::Error>> {
        let banks = banks(self.config.acceptance.as_ref(), timing);
        for (first, bank) in &banks {
            self.commands.write_bank(*first, bank)?;
        }
        for (register, value, _) in SINGLE_REGISTERS {
            self.commands.write(register, value)?;
        }
        for (first, expected) in banks {
            let actual = self.commands.read_bank(first)?;
            for (address, (expected, actual)) in (first as u8..).zip(expected.into_iter().zip(actual)) {
                if actual != expected {
                    return Err(StartError::Readback { address, expected, actual });
                }
            }
        }
        for (register, expected, mask) in SINGLE_REGISTERS {
            let actual = self.commands.read(register)? & mask;
            if actual != expected {
                return Err(StartError::Readback { address: register as u8, expected, actual });
            }
        }
        Ok(())
    }

    /// Asks for the mode and waits: the chip joins between two frames, so a busy bus takes a frame's time.
    fn enter_mode(&mut self, delay: &mut impl DelayNs) -> Result<(), StartError<SPI::Error>> {
        let expected = self.config.mode.registers();
        let [_, canctrl] = expected;
        self.commands.write(Register::CANCTRL, canctrl)?;
        let mut actual = [0; 2];
        for _ in 0..MODE_POLLS {
            actual = self.read_mode()?;
            // Seen twice: the chip is asked while it still changes over, and one wrong byte would do.
            if actual == expected && self.read_mode()? == expected {
                return Ok(());
            }
            delay.delay_us(POLL_US);
        }
        Err(StartError::Mode { expected, actual })
    }

    /// Reads what [`Mode::registers`] gives. CANSTAT alone would not do: in normal mode it is as zero as a dead line.
    fn read_mode(&mut self) -> Result<[u8; 2], SPI::Error> {
        let [canstat, canctrl] = self.commands.read_pair(Register::CANSTAT)?;
        Ok([canstat & regs::OPMOD, canctrl])
    }

    /// Reads CANINTF and EFLG in one burst and does what [`irq::plan`] says.
    fn clear_flags(&mut self) -> Result<(), SPI::Error> {
        let [canintf, eflg] = self.commands.read_pair(Register::CANINTF)?;
        let plan = irq::plan(canintf, eflg);
        if plan.clear_eflg != 0 {
            self.commands.bit_modify(Register::EFLG, plan.clear_eflg, 0)?;
        }
        if plan.clear_canintf != 0 {
            self.commands.bit_modify(Register::CANINTF, plan.clear_canintf, 0)?;
        }
        count(&mut self.health.overruns, u32::from(plan.overruns));
        if plan.state == BusState::BusOff && self.health.state != BusState::BusOff {
            self.leave_bus()?;
        }
        self.health.state = plan.state;
        Ok(())
    }

    /// Takes the waiting frame back, which the chip would send as soon as it recovers.
    #[cold]
    fn leave_bus(&mut self) -> Result<(), SPI::Error> {
        self.take_back()?;
        count(&mut self.health.bus_offs, 1);
        self.silence_due = true;
        Ok(())
    }

    /// Takes the waiting frame back, if there is one.
    fn take_back(&mut self) -> Result<(), SPI::Error> {
        if self.pending_since_ms.is_some() {
            self.commands.bit_modify(Register::TXB0CTRL, regs::TXREQ, 0)?;
            self.pending_since_ms = None;
            count(&mut self.health.aborted, 1);
        }
        Ok(())
    }

    /// Starts the silence after a bus-off that was noticed since the last call.
    const fn start_silence(&mut self, now_ms: u64) {
        if self.silence_due {
            self.silence_due = false;
            self.silent_until_ms = now_ms.saturating_add(BUS_OFF_SILENCE_MS);
        }
    }

    /// Returns whether TXB0 is still occupied; gives it up when the bus has not taken it in time.
    fn settle_transmission(&mut self, now_ms: u64) -> Result<bool, SPI::Error> {
        let Some(since_ms) = self.pending_since_ms else { return Ok(false) };
        if self.commands.read_status()? & regs::READ_STATUS_TX0REQ == 0 {
            count(&mut self.health.sent, 1);
            self.pending_since_ms = None;
            return Ok(false);
        }
        if now_ms.saturating_sub(since_ms) < TRANSMIT_LIMIT_MS {
            return Ok(true);
        }
        self.commands.bit_modify(Register::TXB0CTRL, regs::TXREQ, 0)?;
        // A frame that is on the wire just now is finished first: only an empty buffer counts as given up.
        if self.commands.read_status()? & regs::READ_STATUS_TX0REQ != 0 {
            return Ok(true);
        }
        count(&mut self.health.aborted, 1);
        self.pending_since_ms = None;
        Ok(false)
    }
}

/// What is written in configuration mode beside the [`banks`]: register, value, and the bits that read back.
const SINGLE_REGISTERS: [(Register, u8, u8); 4] = [
    (Register::TXB0CTRL, 0, regs::TXREQ),
    (Register::RXB0CTRL, regs::BUKT, regs::RXM | regs::BUKT),
    (Register::RXB1CTRL, 0, regs::RXM),
    (Register::CANINTF, 0, 0xFF),
];

/// Filters, masks, CNF3 to CNF1 and CANINTE, in the order of their addresses.
fn banks(acceptance: Option<&Acceptance>, timing: BitTiming) -> [(Register, Bank); 3] {
    let acceptance::Registers { masks, filters } =
        acceptance.map_or(acceptance::Registers::EVERYTHING, acceptance::Registers::of);
    let [f0, f1, f2, f3, f4, f5] = filters;
    let [m0, m1] = masks;
    let [cnf3, cnf2, cnf1] = timing.registers();
    // MERRE stays off: one interrupt per bus error is 10 000 a second on a broken bus.
    let caninte = regs::RX0IF | regs::RX1IF | regs::ERRIF;
    [
        (Register::RXF0SIDH, bank([f0, f1, f2])),
        (Register::RXF3SIDH, bank([f3, f4, f5])),
        (Register::RXM0SIDH, bank([m0, m1, [cnf3, cnf2, cnf1, caninte]])),
    ]
}

fn bank(parts: [[u8; 4]; 3]) -> Bank {
    let mut bank = Bank::default();
    for (register, value) in bank.iter_mut().zip(parts.into_iter().flatten()) {
        *register = value;
    }
    bank
}

#[inline(always)]
fn count(counter: &mut u32, by: u32) {
    *counter = counter.saturating_add(by);
}
