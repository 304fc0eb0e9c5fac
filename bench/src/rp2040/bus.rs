//! The CPU's view of memory: loads, stores and fetches with their wait states.

/// Width of an access.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// 8 bits.
    Byte,
    /// 16 bits.
    Half,
    /// 32 bits.
    Word,
}

/// An access that the bus answers with an error; the CPU turns it into HardFault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BusError;

/// Everything below 0xE000_0000. The private peripheral bus (NVIC, SysTick, SCB) belongs to the CPU.
///
/// Addresses are already checked for alignment. Cycle rule: the CPU charges the architectural cycles of the
/// instruction (for example 2 for a load from zero-wait memory); the bus adds whatever the target costs on top
/// (APB +2/+3, XIP miss, -1 for the single-cycle port of SIO) to its own counter, which the run loop collects.
pub trait Bus {
    /// Fetches one halfword of code.
    fn fetch(&mut self, address: u32) -> Result<u16, BusError>;
    /// Loads, zero-extended.
    fn load(&mut self, address: u32, width: Width) -> Result<u32, BusError>;
    /// Stores the low bits of `value`.
    fn store(&mut self, address: u32, width: Width, value: u32) -> Result<(), BusError>;
    /// BKPT executed at `pc`. `true` if the bus handled it as a boot-ROM service (the core continues behind it).
    fn breakpoint(&mut self, pc: u32, code: u8, registers: &mut [u32; 16]) -> bool;
    /// Cycles that accesses since the last call have cost on top of the architectural ones (may be negative).
    fn take_extra_cycles(&mut self) -> i32;
}
