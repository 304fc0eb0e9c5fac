//! What the tests of the RP2040 engine share: a recording board, a register poker and a tiny Thumb assembler.
//!
//! Owns no expectation: every number that a test compares with stands in the test.

#![allow(dead_code)] // each test binary uses its own part

use bench::pins::{Board, InputPins};
use bench::rp2040::bus::{Bus, Width};
use bench::rp2040::{Rp2040, Stop};
use bench::time::Nanos;

/// Addresses of the peripherals.
pub(crate) const CLOCKS: u32 = 0x4000_8000;
pub(crate) const RESETS: u32 = 0x4000_c000;
pub(crate) const PSM: u32 = 0x4001_0000;
pub(crate) const IO_BANK0: u32 = 0x4001_4000;
pub(crate) const IO_QSPI: u32 = 0x4001_8000;
pub(crate) const PADS_BANK0: u32 = 0x4001_c000;
pub(crate) const XOSC: u32 = 0x4002_4000;
pub(crate) const PLL_SYS: u32 = 0x4002_8000;
pub(crate) const PLL_USB: u32 = 0x4002_c000;
pub(crate) const UART0: u32 = 0x4003_4000;
pub(crate) const SPI0: u32 = 0x4003_c000;
pub(crate) const SPI1: u32 = 0x4004_0000;
pub(crate) const ADC: u32 = 0x4004_c000;
pub(crate) const PWM: u32 = 0x4005_0000;
pub(crate) const TIMER: u32 = 0x4005_4000;
pub(crate) const WATCHDOG: u32 = 0x4005_8000;
pub(crate) const DMA: u32 = 0x5000_0000;
pub(crate) const SIO: u32 = 0xd000_0000;
pub(crate) const XIP_CTRL: u32 = 0x1400_0000;
pub(crate) const XIP_SSI: u32 = 0x1800_0000;
pub(crate) const RAM: u32 = 0x2000_0000;
/// Interrupt enable register of the core.
pub(crate) const NVIC_ISER: u32 = 0xe000_e100;
/// Atomic aliases.
pub(crate) const XOR: u32 = 0x1000;
pub(crate) const SET: u32 = 0x2000;
pub(crate) const CLR: u32 = 0x3000;

/// One call of the engine to its board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Call {
    Pin { at: Nanos, pin: u8, level: bool },
    Spi { at: Nanos, port: u8, word: u16, bits: u8 },
    Uart { at: Nanos, port: u8, byte: u8 },
    Pwm { at: Nanos, pin: u8, frequency_hz: u32, duty: u32 },
}

impl Call {
    pub(crate) fn at(self) -> Nanos {
        match self {
            Self::Pin { at, .. } | Self::Spi { at, .. } | Self::Uart { at, .. } | Self::Pwm { at, .. } => at,
        }
    }
}

/// Records every call; answers SPI with the complement of what it got; drives pins by a script.
#[derive(Clone, Debug, Default)]
pub(crate) struct Recorder {
    pub(crate) calls: Vec<Call>,
    /// Instants at which pins change from outside, in order: (when, pin, level; `None` = let go).
    pub(crate) script: Vec<(Nanos, u8, Option<bool>)>,
    pub(crate) played: usize,
}

impl Board for Recorder {
    fn pin_out(&mut self, at: Nanos, pin: u8, level: bool, _: &mut InputPins) {
        self.calls.push(Call::Pin { at, pin, level });
    }
    fn spi_frame(&mut self, at: Nanos, port: u8, word: u16, bits: u8, _: &mut InputPins) -> u16 {
        self.calls.push(Call::Spi { at, port, word, bits });
        !word
    }
    fn uart_byte(&mut self, at: Nanos, port: u8, byte: u8) {
        self.calls.push(Call::Uart { at, port, byte });
    }
    fn pwm(&mut self, at: Nanos, pin: u8, frequency_hz: u32, duty: u32) {
        self.calls.push(Call::Pwm { at, pin, frequency_hz, duty });
    }
    fn next_event(&self) -> Option<Nanos> {
        self.script.get(self.played).map(|(at, ..)| *at)
    }
    fn advance(&mut self, now: Nanos, inputs: &mut InputPins) {
        while let Some((at, pin, level)) = self.script.get(self.played).copied() {
            if at > now {
                break;
            }
            match level {
                Some(level) => inputs.drive(pin, level),
                None => inputs.release(pin),
            }
            self.played += 1;
        }
    }
}

pub(crate) type Machine = Rp2040<Recorder>;

/// Instants of the SPI frames of `port`.
pub(crate) fn spi_times(machine: &Machine, port: u8) -> Vec<Nanos> {
    let of_port = |call: &Call| match call {
        Call::Spi { at, port: p, .. } if *p == port => Some(*at),
        _ => None,
    };
    machine.board.calls.iter().filter_map(of_port).collect()
}

/// Levels of `pin`, as reported.
pub(crate) fn pin_levels(machine: &Machine, pin: u8) -> Vec<(Nanos, bool)> {
    let of_pin = |call: &Call| match call {
        Call::Pin { at, pin: p, level } if *p == pin => Some((*at, *level)),
        _ => None,
    };
    machine.board.calls.iter().filter_map(of_pin).collect()
}

pub(crate) fn poke<B: Board>(machine: &mut Rp2040<B>, address: u32, value: u32) {
    machine.store(address, Width::Word, value).expect("the store is answered");
}

pub(crate) fn peek<B: Board>(machine: &mut Rp2040<B>, address: u32) -> u32 {
    machine.load(address, Width::Word).expect("the load is answered")
}

/// Runs for `span`.
pub(crate) fn run<B: Board>(machine: &mut Rp2040<B>, span: Nanos) {
    let deadline = machine.now() + span;
    machine.run_until(deadline).expect("the run goes on");
}

/// Runs until the run stops by itself.
pub(crate) fn run_to_stop<B: Board>(machine: &mut Rp2040<B>, span: Nanos) -> Stop {
    let deadline = machine.now() + span;
    machine.run_until(deadline).expect_err("the run stops")
}

/// A flash image: the W25Q080 second stage, a vector table and `program` behind it.
pub(crate) fn image(program: &Program) -> Vec<u8> {
    let mut flash = rp2040_boot2::BOOT_LOADER_W25Q080.to_vec();
    let mut vectors = [HANDLER_SLOT; 48];
    vectors[0] = STACK_TOP;
    vectors[1] = CODE | 1;
    for (exception, offset) in &program.handlers {
        vectors[*exception] = (CODE + *offset) | 1;
    }
    flash.extend(vectors.iter().flat_map(|word| word.to_le_bytes()));
    flash.resize((CODE - 0x1000_0000) as usize, 0xff);
    flash.extend(&program.bytes());
    flash
}

/// Where [`image`] puts the program.
pub(crate) const CODE: u32 = 0x1000_0200;
pub(crate) const STACK_TOP: u32 = 0x2002_0000;
/// Vector of exceptions without a handler: even, so taking it is a fault.
const HANDLER_SLOT: u32 = 0;

/// A machine that runs `program` from flash, at power-on.
pub(crate) fn boot(program: &Program) -> Machine {
    boot_with(program, Recorder::default())
}

pub(crate) fn boot_with(program: &Program, board: Recorder) -> Machine {
    Rp2040::new(image(program), board)
}

/// A machine whose core sleeps, at 125 MHz with the 1 us tick, all blocks out of reset.
pub(crate) fn awake_chip() -> Machine {
    awake_chip_with(Recorder::default())
}

pub(crate) fn awake_chip_with(board: Recorder) -> Machine {
    let mut program = Program::new();
    let sleep = program.here();
    program.wfi();
    program.branch(sleep);
    let mut machine = boot_with(&program, board);
    run(&mut machine, Nanos::from_millis(10));
    machine.board.calls.clear();
    bring_up(&mut machine);
    machine
}

/// What `init_clocks_and_plls` does, by pokes.
pub(crate) fn bring_up(machine: &mut Machine) {
    poke(machine, XOSC, 0xaa0);
    poke(machine, XOSC + 0xc, 47);
    poke(machine, XOSC, 0xfab << 12 | 0xaa0);
    run(machine, Nanos::from_millis(2));
    assert_eq!(peek(machine, XOSC + 4) >> 31, 1, "the crystal is stable");
    poke(machine, RESETS, 0);
    for (pll, feedback, dividers) in [(PLL_SYS, 125, 6 << 16 | 2 << 12), (PLL_USB, 100, 5 << 16 | 5 << 12)] {
        poke(machine, pll, 1);
        poke(machine, pll + 8, feedback);
        poke(machine, pll + 4 + CLR, 0x21);
        run(machine, Nanos::from_micros(100));
        assert_eq!(peek(machine, pll) >> 31, 1, "the PLL has locked");
        poke(machine, pll + 0xc, dividers);
        poke(machine, pll + 4 + CLR, 8);
    }
    poke(machine, CLOCKS + 0x30, 2); // clk_ref = crystal
    poke(machine, WATCHDOG + 0x2c, 0x200 | 12);
    poke(machine, CLOCKS + 0x3c, 1); // clk_sys = PLL_SYS
    poke(machine, CLOCKS + 0x48, 1 << 11); // clk_peri = clk_sys
    poke(machine, CLOCKS + 0x60, 1 << 11); // clk_adc = PLL_USB
    assert_eq!(machine.clk_sys_hz(), 125_000_000);
}

/// Gives GPIO `pin` to `function`.
pub(crate) fn set_function<B: Board>(machine: &mut Rp2040<B>, pin: u8, function: u32) {
    poke(machine, IO_BANK0 + u32::from(pin) * 8 + 4, function);
}

/// Thumb code, as halfwords.
#[derive(Clone, Debug, Default)]
pub(crate) struct Program {
    code: Vec<u16>,
    handlers: Vec<(usize, u32)>,
}

impl Program {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    /// Offset of the next instruction.
    pub(crate) fn here(&self) -> u32 {
        self.code.len() as u32 * 2
    }

    pub(crate) fn raw(&mut self, halfword: u16) {
        self.code.push(halfword);
    }

    /// From here on stands the handler of `exception` (16 + IRQ number).
    pub(crate) fn handler(&mut self, exception: usize) {
        let here = self.here();
        self.handlers.push((exception, here));
    }

    /// rd = value, from a literal right behind, which a branch skips: code stays within reach of any length.
    pub(crate) fn load(&mut self, rd: u16, value: u32) {
        if self.code.len() % 2 == 1 {
            self.nop();
        }
        self.raw(0x4800 | rd << 8); // ldr rd, [pc, #0]
        self.raw(0xe001); // b behind the literal
        self.raw((value & 0xffff) as u16);
        self.raw((value >> 16) as u16);
    }

    /// rd = imm8.
    pub(crate) fn movs(&mut self, rd: u16, imm: u16) {
        self.raw(0x2000 | rd << 8 | imm);
    }

    /// rd = rd + imm8.
    pub(crate) fn adds(&mut self, rd: u16, imm: u16) {
        self.raw(0x3000 | rd << 8 | imm);
    }

    /// rd = rd - imm8.
    pub(crate) fn subs(&mut self, rd: u16, imm: u16) {
        self.raw(0x3800 | rd << 8 | imm);
    }

    /// [rn + offset] = rt; offset is a multiple of 4 below 128.
    pub(crate) fn str(&mut self, rt: u16, rn: u16, offset: u16) {
        self.raw(0x6000 | (offset / 4) << 6 | rn << 3 | rt);
    }

    /// rt = [rn + offset].
    pub(crate) fn ldr(&mut self, rt: u16, rn: u16, offset: u16) {
        self.raw(0x6800 | (offset / 4) << 6 | rn << 3 | rt);
    }

    pub(crate) fn wfi(&mut self) {
        self.raw(0xbf30);
    }

    pub(crate) fn nop(&mut self) {
        self.raw(0xbf00);
    }

    pub(crate) fn bx_lr(&mut self) {
        self.raw(0x4770);
    }

    pub(crate) fn blx(&mut self, rm: u16) {
        self.raw(0x4780 | rm << 3);
    }

    pub(crate) fn push_lr(&mut self) {
        self.raw(0xb500);
    }

    pub(crate) fn pop_pc(&mut self) {
        self.raw(0xbd00);
    }

    pub(crate) fn branch(&mut self, to: u32) {
        let distance = (to as i32 - self.here() as i32 - 4) / 2;
        self.raw(0xe000 | (distance as u16 & 0x7ff));
    }

    pub(crate) fn branch_not_equal(&mut self, to: u32) {
        let distance = (to as i32 - self.here() as i32 - 4) / 2;
        self.raw(0xd100 | (distance as u16 & 0xff));
    }

    /// Stores `value` to `address`, through r0 and r1.
    pub(crate) fn poke(&mut self, address: u32, value: u32) {
        self.load(0, address);
        self.load(1, value);
        self.str(1, 0, 0);
    }

    /// Appends `other`'s code, as if it stood here.
    pub(crate) fn append(&mut self, other: &Self) {
        if self.code.len() % 2 == 1 {
            self.nop();
        }
        self.code.extend(&other.code);
    }

    /// Sleeps for ever.
    pub(crate) fn sleep(&mut self) {
        let here = self.here();
        self.wfi();
        self.branch(here);
    }

    /// The code as it stands in memory. It must start at a multiple of 4.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        self.code.iter().flat_map(|half| half.to_le_bytes()).collect()
    }
}
