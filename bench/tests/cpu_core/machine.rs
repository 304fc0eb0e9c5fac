//! A core on 64 KiB of RAM with a vector table, handlers in fixed places and a program.

use bench::rp2040::bus::{Bus, BusError, Width};
use bench::rp2040::cpu::{Cpu, Stop};

pub(crate) const RAM: u32 = 0x2000_0000;
const RAM_BYTES: usize = 0x1_0000;
/// The vector table lies at the start of RAM.
pub(crate) const VECTORS: u32 = RAM;
/// Each exception's handler has 32 bytes from here.
pub(crate) const HANDLERS: u32 = RAM + 0x1000;
pub(crate) const CODE: u32 = RAM + 0x2000;
/// Free for data.
pub(crate) const DATA: u32 = RAM + 0x4000;
pub(crate) const STACK: u32 = RAM + 0x8000;
/// An address that the bus refuses.
pub(crate) const NOWHERE: u32 = 0x3000_0000;

pub(crate) const HARD_FAULT: u32 = 3;
pub(crate) const SYS_TICK: u32 = 15;

pub(crate) const ISER: u32 = 0xE000_E100;
pub(crate) const ICER: u32 = 0xE000_E180;
pub(crate) const ISPR: u32 = 0xE000_E200;
pub(crate) const ICPR: u32 = 0xE000_E280;
pub(crate) const IPR0: u32 = 0xE000_E400;
pub(crate) const ICSR: u32 = 0xE000_ED04;
pub(crate) const SCR: u32 = 0xE000_ED10;
pub(crate) const SHPR3: u32 = 0xE000_ED20;

pub(crate) struct Memory {
    ram: Vec<u8>,
    /// Whether BKPT is answered by the bus.
    pub(crate) serves_breakpoints: bool,
}

impl Memory {
    fn bytes(&mut self, address: u32, width: Width) -> Result<&mut [u8], BusError> {
        let count = match width {
            Width::Byte => 1,
            Width::Half => 2,
            Width::Word => 4,
        };
        let at = address.checked_sub(RAM).ok_or(BusError)? as usize;
        self.ram.get_mut(at..at + count).ok_or(BusError)
    }
}

impl Bus for Memory {
    fn fetch(&mut self, address: u32) -> Result<u16, BusError> {
        self.load(address, Width::Half).map(|half| half as u16)
    }

    fn load(&mut self, address: u32, width: Width) -> Result<u32, BusError> {
        let bytes = self.bytes(address, width)?;
        Ok(bytes.iter().rev().fold(0, |value, byte| value << 8 | u32::from(*byte)))
    }

    fn store(&mut self, address: u32, width: Width, value: u32) -> Result<(), BusError> {
        let bytes = self.bytes(address, width)?;
        let count = bytes.len();
        bytes.copy_from_slice(&value.to_le_bytes()[..count]);
        Ok(())
    }

    fn breakpoint(&mut self, _pc: u32, code: u8, registers: &mut [u32; 16]) -> bool {
        registers[0] = registers[0].wrapping_add(u32::from(code));
        self.serves_breakpoints
    }

    fn take_extra_cycles(&mut self) -> i32 {
        0
    }
}

pub(crate) struct Machine {
    pub(crate) cpu: Cpu,
    pub(crate) memory: Memory,
}

impl Machine {
    /// After reset, about to run `code`. Handlers are `BX LR`; r0 to r12 are 0.
    pub(crate) fn with(code: &[u16]) -> Self {
        let memory = Memory { ram: vec![0; RAM_BYTES], serves_breakpoints: false };
        let mut machine = Self { cpu: Cpu::new(), memory };
        machine.put_word(VECTORS, STACK);
        machine.put_word(VECTORS + 4, CODE | 1);
        for number in 2..48 {
            machine.put_word(VECTORS + 4 * number, handler(number) | 1);
            machine.put_handler(number, &[0x4770]);
        }
        machine.put_code(CODE, code);
        machine.cpu.reset(&mut machine.memory, VECTORS).expect("the vector table is in RAM");
        machine
    }

    pub(crate) fn put_word(&mut self, address: u32, value: u32) {
        self.memory.store(address, Width::Word, value).expect("an address in RAM");
    }

    pub(crate) fn word(&mut self, address: u32) -> u32 {
        self.memory.load(address, Width::Word).expect("an address in RAM")
    }

    pub(crate) fn put_code(&mut self, address: u32, code: &[u16]) {
        for (at, halfword) in (address..).step_by(2).zip(code) {
            self.memory.store(at, Width::Half, u32::from(*halfword)).expect("an address in RAM");
        }
    }

    pub(crate) fn put_handler(&mut self, number: u32, code: &[u16]) {
        assert!(code.len() <= 16, "the next handler is in the way");
        self.put_code(handler(number), code);
    }

    /// One step that must not stop; its cycles.
    pub(crate) fn step(&mut self) -> u32 {
        self.cpu.step(&mut self.memory).expect("the core goes on")
    }

    pub(crate) fn steps(&mut self, count: u32) -> u32 {
        (0..count).map(|_| self.step()).sum()
    }

    /// Steps until the core stops.
    pub(crate) fn stop(&mut self) -> Stop {
        (0..100).find_map(|_| self.cpu.step(&mut self.memory).err()).expect("the core stops within 100 steps")
    }

    pub(crate) fn pc(&self) -> u32 {
        self.cpu.registers[15]
    }

    pub(crate) fn sp(&self) -> u32 {
        self.cpu.registers[13]
    }

    /// Writes a core register as software does, by a store; the program's own registers stay. Nothing may be due.
    pub(crate) fn write(&mut self, register: u32, value: u32) {
        let saved = self.cpu.registers;
        // str r1, [r0]
        self.put_code(CODE - 4, &[0x6001]);
        (self.cpu.registers[0], self.cpu.registers[1]) = (register, value);
        self.cpu.registers[15] = CODE - 4;
        self.step();
        self.cpu.registers = saved;
    }

    /// Reads a core register as software does. Nothing may be due.
    pub(crate) fn read(&mut self, register: u32) -> u32 {
        let saved = self.cpu.registers;
        // ldr r0, [r0]
        self.put_code(CODE - 4, &[0x6800]);
        self.cpu.registers[0] = register;
        self.cpu.registers[15] = CODE - 4;
        self.step();
        std::mem::replace(&mut self.cpu.registers, saved)[0]
    }

    /// Enables external interrupts.
    pub(crate) fn enable(&mut self, set: u32) {
        self.write(ISER, set);
    }

    /// Sets the priority, 0 to 3, of an external interrupt.
    pub(crate) fn prioritise(&mut self, interrupt: u32, priority: u32) {
        let register = IPR0 + (interrupt & !3);
        let lane = 8 * (interrupt & 3);
        let others = self.read(register) & !(0xFF << lane);
        self.write(register, others | priority << (lane + 6));
    }
}

/// Address of an exception's handler.
pub(crate) const fn handler(number: u32) -> u32 {
    HANDLERS + 32 * number
}

/// Exception number of an external interrupt.
pub(crate) const fn irq(interrupt: u32) -> u32 {
    16 + interrupt
}
