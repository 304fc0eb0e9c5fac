//! The RP2040 engine: one Cortex-M0+ core and the peripherals that this firmware uses.
//!
//! Owns virtual time. The core runs until the next event of a peripheral or of the board, asleep it jumps there; each
//! SPI frame, UART byte and pin change reaches the [`Board`] with its exact time, in order. Two runs of the same flash
//! and board are equal to the cycle.
//!
//! What is not modelled is loud: [`Stop`] names the register and the instruction. Each module's header says what that
//! covers. Source: RP2040 datasheet; chapters in the modules.
//!
//! Not supported: core 1, PIO, I2C, USB, RTC, interpolators, NMI, dormant modes, contention between bus masters.

mod adc;
pub mod bus;
mod chip;
pub mod clocks;
pub mod cpu;
mod dma;
mod fifo;
mod gpio;
pub mod image;
mod map;
mod names;
mod nor;
mod pwm;
mod rom;
mod services;
mod sio;
mod spi;
mod ssi;
mod system;
mod timer;
mod transfers;
mod uart;
mod watch;
mod watchdog;
pub mod xip;

use std::fmt;

use self::bus::{Bus, BusError, Width};
use self::chip::{Chip, NEVER, RAM_BASE, RAM_BYTES, Source};
use self::cpu::Cpu;
pub use self::nor::FlashTimes;
use self::rom::Service;
use self::watch::Watch;
pub use self::watch::{Handler, Watched};
use self::watchdog::{REASON_FORCE, REASON_TIMER};
use self::xip::FLASH_BYTES;
use crate::flash::Cells;
use crate::pins::{Board, InputPins};
use crate::time::Nanos;

/// Frames that are served one by one after a frame has made the board change.
const WARY_FRAMES: u32 = 1000;
/// Board events at one instant after which the board is taken to be stuck.
const BOARD_PATIENCE: u32 = 10_000;
const FUNCTION_PWM: u32 = 4;

/// Why a run ended before its deadline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The core cannot go on.
    Core {
        /// Its reason.
        stop: cpu::Stop,
        /// The HardFault that led there, if any.
        fault: Option<cpu::Fault>,
        /// When.
        at: Nanos,
    },
    /// A register that this engine does not model was touched, or given a value that it does not model.
    Unmodelled {
        /// Peripheral and register.
        register: String,
        /// Address of the access.
        address: u32,
        /// Store rather than load.
        write: bool,
        /// Address of the instruction.
        pc: u32,
        /// When.
        at: Nanos,
    },
    /// Code or data was wanted from flash while the flash was not mapped.
    FlashUnmapped {
        /// Address of the access.
        address: u32,
        /// Address of the instruction.
        pc: u32,
        /// When.
        at: Nanos,
    },
    /// The chip as a whole cannot go on.
    Chip {
        /// What is wrong.
        what: String,
        /// Address of the instruction.
        pc: u32,
        /// When.
        at: Nanos,
    },
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Core { stop, fault: None, at } => write!(f, "{at}: {stop}"),
            Self::Core { stop, fault: Some(fault), at } => {
                write!(f, "{at}: {stop}; it began with {:?} at {:#010x}", fault.cause, fault.pc)
            }
            Self::Unmodelled { register, address, write, pc, at } => {
                let verb = if *write { "stores to" } else { "loads from" };
                write!(
                    f,
                    "{at}: the instruction at {pc:#010x} {verb} {register} ({address:#010x}): not modelled"
                )
            }
            Self::FlashUnmapped { address, pc, at } if address == pc => write!(
                f,
                "{at}: the core fetches from {pc:#010x} while the flash is not mapped (erase or program under way): \
                 put this code into RAM or mask its interrupt"
            ),
            Self::FlashUnmapped { address, pc, at } => write!(
                f,
                "{at}: the instruction at {pc:#010x} reads {address:#010x} while the flash is not mapped (erase or \
                 program under way): put this data into RAM"
            ),
            Self::Chip { what, pc, at } => write!(f, "{at}: {what} (at {pc:#010x})"),
        }
    }
}

impl std::error::Error for Stop {}

/// What reset the chip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResetCause {
    /// Power came on.
    PowerOn,
    /// The watchdog's counter ran out.
    WatchdogTimer,
    /// WATCHDOG.CTRL.TRIGGER was written.
    WatchdogForce,
    /// AIRCR.SYSRESETREQ was written: only the core restarts.
    Software,
}

/// Counts since power-on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Instructions executed.
    pub instructions: u64,
    /// clk_sys cycles.
    pub cycles: u64,
    /// clk_sys cycles in WFI or WFE.
    pub cycles_asleep: u64,
    /// XIP accesses served from the cache, one per line crossed.
    pub xip_hits: u64,
    /// XIP accesses that went to the flash.
    pub xip_misses: u64,
    /// Rises of each interrupt line.
    pub irqs: [u64; 32],
    /// SPI frames that reached the board, per port.
    pub spi_frames: [u64; 2],
    /// SPI frames that went nowhere because SCK or TX was on no pin, per port.
    pub spi_unrouted: [u64; 2],
    /// Resets, the first being power-on.
    pub resets: Vec<(Nanos, ResetCause)>,
}

/// An RP2040 on a board.
pub struct Rp2040<B: Board> {
    /// What is on its pins.
    pub board: B,
    /// The supply is off: only the board lives on.
    is_off: bool,
    chip: Chip,
    cpu: Option<Box<Cpu>>,
    inputs: InputPins,
    board_wants: Option<Nanos>,
    last_board_call: Nanos,
    stuck: u32,
    pwm_reported: [pwm::Output; gpio::PINS],
    lines: u32,
    /// Frames per SPI port that still have to be served one by one, because one has changed the board.
    wary: [u32; 2],
    stats: Stats,
    watch: Option<Box<Watch>>,
}

impl<B: Board> Rp2040<B> {
    /// Switches the power on. `flash` is the image from 0x1000_0000 on; the rest of the 2 MiB is erased (0xFF).
    pub fn new(flash: Vec<u8>, board: B) -> Self {
        let mut flash = flash;
        flash.resize(FLASH_BYTES, 0xff);
        Self::with_cells(Cells::new(flash), board)
    }

    /// Switches the power on with a flash that has a past: 2 MiB, as [`Self::power_cut`] leaves them.
    pub fn with_cells(cells: Cells, board: B) -> Self {
        let mut machine = Self {
            board,
            is_off: false,
            chip: Chip::new(cells),
            cpu: Some(Box::new(Cpu::new())),
            inputs: InputPins::default(),
            board_wants: None,
            last_board_call: Nanos::ZERO,
            stuck: 0,
            pwm_reported: [pwm::Output::default(); gpio::PINS],
            lines: 0,
            wary: [0; 2],
            stats: Stats::default(),
            watch: None,
        };
        machine.stats.resets.push((Nanos::ZERO, ResetCause::PowerOn));
        machine.board.advance(Nanos::ZERO, &mut machine.inputs);
        machine.after_board();
        machine.restart_core();
        machine
    }

    /// Virtual time since power-on.
    pub fn now(&self) -> Nanos {
        self.chip.nanos()
    }

    /// clk_sys in hertz.
    pub fn clk_sys_hz(&self) -> u64 {
        self.chip.time.hz()
    }

    /// clk_peri in hertz, 0 if stopped.
    pub fn clk_peri_hz(&self) -> u64 {
        self.chip.peri_hz()
    }

    /// Runs until `deadline`, or a few cycles longer to end an instruction.
    ///
    /// # Errors
    /// [`Stop`] if the firmware did something that ends the run: it names the address of the instruction.
    pub fn run_until(&mut self, deadline: Nanos) -> Result<(), Stop> {
        self.run(deadline, NEVER, &mut |_| true)
    }

    /// Runs while `condition` holds, at most until `deadline`; `true` if the condition ended it. The condition is asked
    /// after each event and at least every 1000 cycles.
    ///
    /// # Errors
    /// As [`Self::run_until`].
    pub fn run_while(&mut self, deadline: Nanos, condition: impl FnMut(&Self) -> bool) -> Result<bool, Stop> {
        const STRIDE: u64 = 1000;
        let mut condition = condition;
        let mut ended = false;
        self.run(deadline, STRIDE, &mut |machine| {
            ended = !condition(machine);
            !ended
        })?;
        Ok(ended)
    }

    /// Counts since power-on.
    pub fn stats(&self) -> Stats {
        Stats {
            cycles: self.chip.now,
            xip_hits: self.chip.xip.hits,
            xip_misses: self.chip.xip.misses,
            ..self.stats.clone()
        }
    }

    /// Watches the core from now on, and returns what was seen since the last call. Instructions take a little longer
    /// to emulate, not longer in virtual time.
    pub fn watch(&mut self) -> Option<Watched> {
        let seen = self.watch.take().map(|watch| watch.into_seen());
        self.watch = self.cpu.as_deref().map(|cpu| Box::new(Watch::new(cpu)));
        seen
    }

    /// The flash as it is now; a bit that was cut off in its change is told as it was before.
    pub fn flash(&self) -> &[u8] {
        self.chip.xip.cells.bytes()
    }

    /// The cells of the flash with their wear.
    pub fn cells(&self) -> &Cells {
        &self.chip.xip.cells
    }

    /// Gives the flash another past, and its noise another seed; for a chip that is off or has just been switched on.
    pub fn set_cells(&mut self, cells: Cells) {
        self.chip.xip.cells = cells;
        self.chip.xip.flush();
    }

    /// How long the flash chip takes for its writes from now on.
    pub fn set_flash_times(&mut self, times: FlashTimes) {
        self.chip.xip.set_times(times);
    }

    /// Whether the flash has a write to end, suspended or not.
    pub fn is_writing_flash(&self) -> bool {
        self.chip.xip.is_writing()
    }

    /// Cuts the power for good. The flash survives; what was being written holds something in between.
    pub fn power_cut(mut self) -> (Cells, B) {
        let now = self.chip.now;
        self.chip.xip.cut_power(now);
        (self.chip.xip.cells, self.board)
    }

    /// Cuts the power of the chip and of what is on its board; the rest of the world lives on. Cutting twice is once.
    pub fn power_off(&mut self) {
        if self.is_off {
            return;
        }
        self.catch_up(self.chip.now);
        self.chip.power_cycle();
        self.report_outputs();
        self.lines = 0;
        self.wary = [0; 2];
        self.is_off = true;
        let at = self.board_time(self.chip.now);
        self.board.power(at, false, &mut self.inputs);
        self.board_wants = None;
        self.after_board();
    }

    /// Switches the power on again.
    pub fn power_on(&mut self) {
        if !std::mem::take(&mut self.is_off) {
            return;
        }
        let at = self.board_time(self.chip.now);
        self.board.power(at, true, &mut self.inputs);
        self.board_wants = None;
        self.after_board();
        self.stats.resets.push((self.now(), ResetCause::PowerOn));
        self.restart_core();
    }

    /// `len` bytes of SRAM from `address` on; empty if that is not all SRAM.
    pub fn read_ram(&self, address: u32, len: usize) -> &[u8] {
        let start = address.wrapping_sub(RAM_BASE) as usize;
        self.chip.ram.get(start..start.saturating_add(len)).unwrap_or(&[])
    }

    /// The core's registers; `None` inside a [`Self::run_while`] condition, where the core is busy.
    pub fn core(&self) -> Option<&Cpu> {
        self.cpu.as_deref()
    }

    /// FUNCSEL of GPIO `pin` (5 = SIO, 31 = none).
    pub fn pin_function(&self, pin: u8) -> u32 {
        self.chip.gpio.function(usize::from(pin))
    }

    /// Puts `millivolts` on ADC `channel` (0 to 3 = GPIO 26 to 29, 4 = temperature sensor).
    pub fn set_analog(&mut self, channel: usize, millivolts: u32) {
        self.chip.adc.set_input(channel, millivolts);
    }

    /// Sends `bytes` into UART `port`'s RX, back to back at its baud rate.
    pub fn uart_input(&mut self, port: usize, bytes: &[u8]) {
        self.chip.uart[port].queue(bytes, self.chip.now);
    }

    // --- the run loop

    fn run(
        &mut self,
        deadline: Nanos,
        stride: u64,
        go_on: &mut dyn FnMut(&Self) -> bool,
    ) -> Result<(), Stop> {
        if let Some(stop) = &self.chip.stop {
            return Err(stop.clone());
        }
        let Some(mut cpu) = self.cpu.take() else { return Ok(()) };
        self.after_board();
        let result = self.run_core(&mut cpu, deadline, stride, go_on);
        self.cpu = Some(cpu);
        if let Err(stop) = &result {
            self.chip.stop = Some(stop.clone());
        }
        result
    }

    fn run_core(
        &mut self,
        cpu: &mut Cpu,
        deadline: Nanos,
        stride: u64,
        go_on: &mut dyn FnMut(&Self) -> bool,
    ) -> Result<(), Stop> {
        let mut until = self.chip.time.cycle(deadline);
        loop {
            let mut next = self.chip.next_event();
            while next.0 <= self.chip.now {
                self.handle(next.1, next.0);
                next = self.chip.next_event();
            }
            if let Some(cause) = self.chip.reset_request.take() {
                self.reset(cpu, cause);
                continue;
            }
            if let Some(stop) = &self.chip.stop {
                return Err(stop.clone());
            }
            if self.chip.reclocked {
                self.chip.reclocked = false;
                self.board_wants = None;
                self.after_board();
                until = self.chip.time.cycle(deadline);
                continue;
            }
            self.set_lines(cpu);
            if self.chip.now >= until || stride != NEVER {
                self.catch_up(self.chip.now);
                if self.chip.now >= until || !go_on(self) {
                    return Ok(());
                }
                if self.chip.next_event().0 <= self.chip.now {
                    continue;
                }
            }
            let target = next.0.min(until).min(self.chip.now.saturating_add(stride));
            if self.is_off {
                self.chip.now = target;
                continue;
            }
            if cpu.is_sleeping() {
                let wake = cpu
                    .cycles_to_systick()
                    .map_or(NEVER, |cycles| self.chip.now.saturating_add(cycles.max(1)));
                let target = target.min(wake);
                let cycles = target - self.chip.now;
                cpu.advance_systick(cycles);
                self.stats.cycles_asleep += cycles;
                self.chip.now = target;
                continue;
            }
            self.chip.limit = target;
            self.chip.horizon = target;
            match self.watch.take() {
                None => self.run_instructions(cpu, |_, _, _| {})?,
                Some(mut watch) => {
                    let outcome = self.run_instructions(cpu, |chip, cpu, from| {
                        watch.look(cpu, || (chip.time.nanos(from), chip.nanos()));
                    });
                    self.watch = Some(watch);
                    outcome?;
                }
            }
        }
    }

    /// Runs instructions until `chip.limit`, sleep or a stop; `look` is called behind each with the cycle of its start.
    #[inline]
    fn run_instructions(
        &mut self,
        cpu: &mut Cpu,
        mut look: impl FnMut(&Chip, &Cpu, u64),
    ) -> Result<(), Stop> {
        let mut instructions = 0;
        let mut outcome = Ok(());
        while self.chip.now < self.chip.limit {
            match cpu.step(self) {
                Ok(cycles) => {
                    let cycles = i64::from(cycles) + i64::from(self.chip.extra);
                    self.chip.extra = 0;
                    let cycles = cycles.max(0).cast_unsigned();
                    let from = self.chip.now;
                    self.chip.now += cycles;
                    instructions += 1;
                    cpu.advance_systick(cycles);
                    look(&self.chip, cpu, from);
                }
                Err(stop) => {
                    let fault = cpu.take_fault();
                    let at = self.now();
                    outcome = Err(self.chip.stop.take().unwrap_or(Stop::Core { stop, fault, at }));
                    break;
                }
            }
            if cpu.is_sleeping() {
                break;
            }
        }
        if cpu.take_reset_request() {
            self.chip.reset_request.get_or_insert(ResetCause::Software);
        }
        self.stats.instructions += instructions;
        outcome
    }

    #[inline]
    fn set_lines(&mut self, cpu: &mut Cpu) {
        let lines = self.chip.irq_lines();
        if lines != self.lines {
            let mut rising = lines & !self.lines;
            while rising != 0 {
                self.stats.irqs[rising.trailing_zeros() as usize] += 1;
                rising &= rising - 1;
            }
            self.lines = lines;
            cpu.set_irq_lines(lines);
        }
    }

    fn handle(&mut self, source: Source, at: u64) {
        let now = self.chip.now;
        if self.chip.streams != 0 && !matches!(source, Source::Timer | Source::Dma) {
            self.catch_up(at);
        }
        match source {
            Source::Spi(port) => self.handle_spi(port),
            Source::Board => self.handle_board(at),
            Source::Timer => {
                self.chip.timer.advance(now);
                self.chip.timer_event = self.chip.timer.next_event();
            }
            Source::Dma => self.chip.serve_dma(),
            Source::Uart(port) => self.handle_uart(port),
            Source::Watchdog => {
                self.chip.watchdog_event = NEVER;
                self.chip.reset_request = Some(ResetCause::WatchdogTimer);
            }
            Source::Pwm => {
                self.chip.pwm.advance(now);
                self.chip.feed_pwm();
            }
            Source::Adc => {
                self.chip.adc.advance(now);
                self.chip.feed_adc();
            }
        }
    }

    fn handle_spi(&mut self, port: usize) {
        let now = self.chip.now;
        if let Some(end) = self.chip.spi[port].frame_end()
            && end <= now
        {
            self.end_frame(port, end);
            if self.chip.spi_out[port] {
                self.after_board();
            }
        }
        self.chip.spi[port].expire(now);
        if self.wary[port] == 0 && self.chip.dma.active != 0 {
            self.chip.plan_stream(port);
        }
        self.wary[port] = self.wary[port].saturating_sub(1);
    }

    /// Exchanges the frame that ends at cycle `end` with the board.
    #[inline]
    fn end_frame(&mut self, port: usize, end: u64) {
        let frame = self.chip.spi[port].frame();
        let mut received = if frame.loopback { frame.word } else { 0 };
        if !self.chip.spi_out[port] {
            self.stats.spi_unrouted[port] += 1;
        } else if !frame.loopback {
            let at = self.board_time(end);
            let miso = self.board.spi_frame(at, port as u8, frame.word, frame.bits, &mut self.inputs);
            if self.chip.spi_in[port] {
                received = miso;
            }
            self.stats.spi_frames[port] += 1;
        }
        self.chip.spi[port].finish_frame(received);
        self.chip.feed_spi(port);
    }

    /// Serves the frames of all streams that have ended by cycle `until`.
    fn catch_up(&mut self, until: u64) {
        let streams = self.chip.streams;
        if streams == 0 {
            return;
        }
        let mut served = false;
        loop {
            let end = |port: usize| match self.chip.spi[port].frame_end() {
                Some(end) if streams & 1 << port != 0 => end,
                _ => NEVER,
            };
            let port = usize::from(end(1) < end(0));
            let at = end(port);
            if at > until {
                break;
            }
            self.end_frame(port, at);
            served = true;
        }
        if !served {
            return;
        }
        let wants = self.board_wants;
        let inputs = self.chip.gpio.set_inputs(&self.inputs);
        self.after_board();
        if inputs || self.board_wants != wants {
            self.wary = [WARY_FRAMES; 2];
            self.chip.end_streams();
            self.chip.limit = 0;
            return;
        }
        for port in 0..2 {
            if streams & 1 << port != 0 {
                self.chip.plan_stream(port);
            }
        }
    }

    fn handle_uart(&mut self, port: usize) {
        let now = self.chip.now;
        let sent_at = self.chip.uart[port].sent_at();
        if sent_at <= now
            && let Some(byte) = self.chip.uart[port].finish_byte()
            && self.chip.is_uart_routed(port)
        {
            let at = self.board_time(sent_at);
            self.board.uart_byte(at, port as u8, byte);
            self.after_board();
        }
        self.chip.uart[port].advance(now);
        self.chip.feed_uart(port);
    }

    fn handle_board(&mut self, at: u64) {
        let at = self.board_time(at);
        // The clock may have changed since the cycle was worked out: it is anew, even for the same instant.
        let wanted = self.board_wants.take();
        self.board.advance(at, &mut self.inputs);
        self.after_board();
        if self.board_wants.is_some() && self.board_wants <= wanted {
            self.stuck += 1;
            if self.stuck > BOARD_PATIENCE {
                self.chip.board_event = NEVER;
                self.chip.stop_for(
                    "the board asks again and again for the same instant: its next_event never moves on",
                );
            }
        } else {
            self.stuck = 0;
        }
    }

    /// The time of a call to the board: never before the last one.
    #[inline]
    fn board_time(&mut self, cycle: u64) -> Nanos {
        self.last_board_call = self.chip.time.nanos(cycle).max(self.last_board_call);
        self.last_board_call
    }

    /// Takes over what the board has changed.
    #[inline]
    fn after_board(&mut self) {
        self.chip.gpio.set_inputs(&self.inputs);
        let wants = self.board.next_event();
        if wants != self.board_wants {
            self.board_wants = wants;
            self.chip.board_event = wants.map_or(NEVER, |at| self.chip.time.cycle(at));
        } else if wants.is_none() {
            self.chip.board_event = NEVER;
        }
    }

    /// Tells the board about pins and PWM outputs that have changed.
    #[inline(never)]
    fn report_outputs(&mut self) {
        self.chip.outputs_touched = false;
        self.catch_up(self.chip.now);
        let at = self.board_time(self.chip.now);
        let (mut changed, levels) = self.chip.gpio.take_changed_outputs();
        let mut called = changed != 0;
        while changed != 0 {
            let pin = changed.trailing_zeros();
            changed &= changed - 1;
            self.board.pin_out(at, pin as u8, levels >> pin & 1 != 0, &mut self.inputs);
        }
        if std::mem::take(&mut self.chip.pwm_touched) {
            called |= self.report_pwm(at);
        }
        if called {
            self.after_board();
        }
        self.chip.limit = 0;
    }

    /// Tells the board about PWM outputs that have changed; a pin that leaves PWM counts as constantly low.
    fn report_pwm(&mut self, at: Nanos) -> bool {
        let hz = self.chip.time.hz();
        let mut called = false;
        for pin in 0..gpio::PINS {
            let output = match self.chip.gpio.function(pin) {
                FUNCTION_PWM => self.chip.pwm.output(pin, hz),
                _ => pwm::Output::default(),
            };
            if output != self.pwm_reported[pin] {
                self.pwm_reported[pin] = output;
                self.board.pwm(at, pin as u8, output.frequency_hz, output.duty);
                called = true;
            }
        }
        called
    }

    // --- reset and boot

    fn restart_core(&mut self) {
        if let Some(mut cpu) = self.cpu.take() {
            self.reset_core(&mut cpu);
            self.cpu = Some(cpu);
        }
    }

    fn reset_core(&mut self, cpu: &mut Cpu) {
        if cpu.reset(self, 0).is_err() {
            self.chip.stop_for("the boot ROM's vector table cannot be read");
        }
        self.chip.extra = 0;
        if let Some(watch) = &mut self.watch {
            watch.restart(cpu);
        }
    }

    fn reset(&mut self, cpu: &mut Cpu, cause: ResetCause) {
        self.catch_up(self.chip.now);
        self.chip.end_streams();
        self.stats.resets.push((self.now(), cause));
        let core = match cause {
            ResetCause::WatchdogTimer => self.chip.watchdog_reset(REASON_TIMER),
            ResetCause::WatchdogForce => self.chip.watchdog_reset(REASON_FORCE),
            ResetCause::PowerOn | ResetCause::Software => true,
        };
        if self.chip.outputs_touched {
            self.report_outputs();
        }
        if core {
            self.reset_core(cpu);
        }
    }
}

impl<B: Board> Bus for Rp2040<B> {
    #[inline]
    fn fetch(&mut self, address: u32) -> Result<u16, BusError> {
        self.chip.fetch(address)
    }

    #[inline]
    fn load(&mut self, address: u32, width: Width) -> Result<u32, BusError> {
        if address >> 29 == 0x4000_0000 >> 29 && self.chip.streams != 0 {
            self.catch_up(self.chip.now);
        }
        self.chip.load(address, width)
    }

    #[inline]
    fn store(&mut self, address: u32, width: Width, value: u32) -> Result<(), BusError> {
        let offset = address.wrapping_sub(RAM_BASE) as usize;
        if offset < RAM_BYTES {
            let (first, len) = self.chip.stream_source;
            if offset.wrapping_sub(first) < len {
                self.catch_up(self.chip.now);
            }
            self.chip.ram_store(offset, width, value);
            return Ok(());
        }
        if self.chip.streams != 0 && address >> 29 == 0x4000_0000 >> 29 {
            self.catch_up(self.chip.now);
            self.chip.end_streams();
        }
        let done = self.chip.store_elsewhere(address, width, value);
        if self.chip.outputs_touched {
            self.report_outputs();
        }
        done
    }

    fn breakpoint(&mut self, pc: u32, code: u8, registers: &mut [u32; 16]) -> bool {
        if pc >= rom::ROM_BYTES {
            return false;
        }
        let Some(service) = Service::from_code(code) else { return false };
        self.serve(service, registers);
        true
    }

    fn take_extra_cycles(&mut self) -> i32 {
        std::mem::take(&mut self.chip.extra)
    }
}
