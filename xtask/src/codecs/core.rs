//! A core on flat memory that calls one function at a time and counts what it executes.
//!
//! No chip around it: every fetch and every access takes the architectural cycles and no wait state, so a figure says
//! what the code costs, not where it lies.

use anyhow::{Context, Result, bail};
use bench::rp2040::bus::{Bus, BusError, Width};
use bench::rp2040::cpu::Cpu;
use object::{Object, ObjectSegment, ObjectSymbol};

/// Where calls return to: the core stops there.
const HOME: u32 = 0x3000_0000;
const BREAKPOINT: u16 = 0xBE00;
const FLASH: u32 = 0x1000_0000;
/// Where data for a call may lie; statics are below, the stack is above.
pub const DATA: u32 = 0x2001_0000;
const RAM: u32 = 0x2000_0000;
const RAM_BYTES: usize = 0x4_0000;
const STACK: u32 = RAM + RAM_BYTES as u32;
/// More than any decoder needs: one that runs longer never ends.
const LIMIT: u32 = 1_000_000;

/// What a call has cost, its return included.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Instructions executed.
    pub instructions: u32,
    /// Cycles without wait states.
    pub cycles: u32,
}

struct Memory {
    flash: Vec<u8>,
    ram: Vec<u8>,
    home: bool,
}

impl Memory {
    fn bytes(&mut self, address: u32, count: usize) -> Result<&mut [u8], BusError> {
        let (bytes, base) = if address < RAM { (&mut self.flash, FLASH) } else { (&mut self.ram, RAM) };
        let at = address.checked_sub(base).ok_or(BusError)? as usize;
        bytes.get_mut(at..at + count).ok_or(BusError)
    }
}

const fn count(width: Width) -> usize {
    match width {
        Width::Byte => 1,
        Width::Half => 2,
        Width::Word => 4,
    }
}

impl Bus for Memory {
    fn fetch(&mut self, address: u32) -> Result<u16, BusError> {
        match address {
            HOME => Ok(BREAKPOINT),
            _ => self.load(address, Width::Half).map(|half| half as u16),
        }
    }

    fn load(&mut self, address: u32, width: Width) -> Result<u32, BusError> {
        let bytes = self.bytes(address, count(width))?;
        Ok(bytes.iter().rev().fold(0, |value, byte| value << 8 | u32::from(*byte)))
    }

    fn store(&mut self, address: u32, width: Width, value: u32) -> Result<(), BusError> {
        if address < RAM {
            return Err(BusError);
        }
        let bytes = self.bytes(address, count(width))?;
        bytes.copy_from_slice(&value.to_le_bytes()[..count(width)]);
        Ok(())
    }

    fn breakpoint(&mut self, pc: u32, _code: u8, _registers: &mut [u32; 16]) -> bool {
        self.home = pc == HOME;
        true
    }

    fn take_extra_cycles(&mut self) -> i32 {
        0
    }
}

/// A program in memory.
pub struct Core {
    memory: Memory,
    table: u32,
}

impl Core {
    /// Loads a program.
    ///
    /// # Errors
    /// If the file is no ELF for the chip or has no `TABLE`.
    pub fn load(elf: &[u8]) -> Result<Self> {
        let file = object::File::parse(elf)?;
        let mut memory = Memory { flash: Vec::new(), ram: vec![0; RAM_BYTES], home: false };
        for segment in file.segments() {
            let (at, data) = (segment.address(), segment.data()?);
            let Some(at) = at.checked_sub(u64::from(FLASH)).filter(|_| !data.is_empty()) else { continue };
            let at = usize::try_from(at)?;
            memory.flash.resize(memory.flash.len().max(at + data.len()), 0);
            memory.flash[at..at + data.len()].copy_from_slice(data);
        }
        let table = file.symbol_by_name("TABLE").context("the program has no TABLE")?;
        Ok(Self { memory, table: u32::try_from(table.address())? })
    }

    /// Returns the word at `index` of the program's table: the address of a function.
    ///
    /// # Errors
    /// If the table is not in memory.
    pub fn entry(&mut self, index: u32) -> Result<u32> {
        self.word(self.table + 4 * index)
    }

    /// Returns the word at `address`.
    ///
    /// # Errors
    /// If there is no memory.
    pub fn word(&mut self, address: u32) -> Result<u32> {
        self.memory.load(address, Width::Word).map_err(|_| anyhow::anyhow!("no memory at {address:#010x}"))
    }

    /// Writes bytes into RAM.
    ///
    /// # Errors
    /// If there is no memory.
    pub fn write(&mut self, address: u32, data: &[u8]) -> Result<()> {
        let bytes = self.memory.bytes(address, data.len());
        bytes.map_err(|_| anyhow::anyhow!("no memory at {address:#010x}"))?.copy_from_slice(data);
        Ok(())
    }

    /// Calls `function` with up to four arguments.
    ///
    /// # Errors
    /// If it stops, faults or does not end.
    pub fn call(&mut self, function: u32, arguments: &[u32]) -> Result<Cost> {
        let mut cpu = Cpu::new();
        cpu.registers[..arguments.len()].copy_from_slice(arguments);
        (cpu.registers[13], cpu.registers[14], cpu.registers[15]) = (STACK, HOME | 1, function & !1);
        self.memory.home = false;
        let mut cost = Cost::default();
        for _ in 0..LIMIT {
            let cycles = cpu.step(&mut self.memory)?;
            if let Some(fault) = cpu.take_fault() {
                bail!("the function at {function:#010x} faults: {fault:?}");
            }
            if self.memory.home {
                return Ok(cost);
            }
            cost.instructions += 1;
            cost.cycles += cycles;
        }
        bail!("the function at {function:#010x} does not end within {LIMIT} instructions")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn core(code: &[u16]) -> Core {
        let flash = code.iter().flat_map(|half| half.to_le_bytes()).collect();
        Core { memory: Memory { flash, ram: vec![0; RAM_BYTES], home: false }, table: FLASH }
    }

    #[test]
    fn a_call_counts_its_own_instructions_and_its_return() -> Result<()> {
        // adds r0, r0, r1; str r0, [r2]; bx lr
        let mut core = core(&[0x1840, 0x6010, 0x4770]);
        let cost = core.call(FLASH | 1, &[40, 2, DATA])?;
        assert_eq!(core.word(DATA)?, 42);
        // 1 + 2 + 2 cycles: TRM, table 3-1.
        assert_eq!(cost, Cost { instructions: 3, cycles: 5 });
        Ok(())
    }

    #[test]
    fn a_call_that_faults_or_never_ends_is_an_error() {
        // ldr r0, [r0] of no memory
        assert!(core(&[0x6800, 0x4770]).call(FLASH, &[0xF000_0000 >> 1]).is_err());
        // b .
        assert!(core(&[0xE7FE]).call(FLASH, &[]).is_err());
    }
}
