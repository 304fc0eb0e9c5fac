//! The Cortex-M0+ core: registers, one step at a time, exceptions, sleep.
//!
//! Owns everything from 0xE000_0000 (NVIC, SysTick, SCB) and the architectural cycles of each instruction; memory and
//! its wait states belong to the [`Bus`]. Anything the ARM manual calls UNPREDICTABLE or that is not modelled stops
//! the core with its address ([`Stop`]) instead of going on with a guess.
//!
//! Source: ARMv6-M Architecture Reference Manual (DDI 0419), B1.5 for exceptions; Cortex-M0+ TRM r0p1 (DDI 0484),
//! table 3-1 for cycles and 3.6.1 for the entry latency.
//!
//! Not supported: the MPU protects nothing (its registers are storage); LDM and STM are not abandoned for an
//! interrupt and a late arrival during stacking nests instead of taking over; debug halting.

mod decode;
mod exceptions;
mod execute;
mod flags;
mod private_bus;
mod systick;

use std::fmt;

use self::exceptions::{EXTERNAL, Exceptions, HARD_FAULT, SYS_TICK};
use self::flags::Flags;
use self::private_bus::{PRIVATE_BASE, SCR_SEVONPEND, SCR_SLEEPONEXIT, SystemControl};
use self::systick::SysTick;
use super::bus::{Bus, BusError, Width};

/// Cycles from a pending exception to its handler's first instruction (TRM 3.6.1, zero wait states).
pub const ENTRY_CYCLES: u32 = 15;
/// Cycles of an exception return on top of the BX or POP: eight loads and a refill. ARM publishes no figure.
pub const RETURN_CYCLES: u32 = 11;
/// Cycles of a tail chain on top of the BX or POP: return and entry without their sixteen transfers.
pub const TAIL_CHAIN_CYCLES: u32 = RETURN_CYCLES + ENTRY_CYCLES - 16;

const SP: usize = 13;
const LR: usize = 14;
const PC: usize = 15;

/// Bytes that exception entry pushes: r0 to r3, r12, LR, return address, xPSR.
const FRAME_BYTES: u32 = 32;
const XPSR_THUMB: u32 = 1 << 24;
/// Set in a stacked xPSR when entry left a gap to align the frame to 8 bytes.
const XPSR_ALIGNED: u32 = 1 << 9;
const IPSR_MASK: u32 = 0x3F;

const RETURN_TO_HANDLER: u32 = 0xFFFF_FFF1;
const RETURN_TO_THREAD_MAIN: u32 = 0xFFFF_FFF9;
const RETURN_TO_THREAD_PROCESS: u32 = 0xFFFF_FFFD;

/// Why the core cannot go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// A fault inside HardFault or NMI: the chip would stand still until a watchdog reset.
    Lockup {
        /// Address of the instruction that faulted.
        pc: u32,
    },
    /// A BKPT that nobody serves, inside HardFault or NMI.
    Breakpoint {
        /// Address of the BKPT.
        pc: u32,
        /// Its immediate.
        code: u8,
    },
    /// The ARM manual calls this instruction, here, UNPREDICTABLE.
    Unpredictable {
        /// Address of the instruction.
        pc: u32,
        /// Its first halfword.
        opcode: u16,
    },
    /// An access to the private peripheral bus that is not modelled.
    Unmodelled {
        /// Address of the instruction.
        pc: u32,
        /// Address of the register.
        address: u32,
    },
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lockup { pc } => write!(f, "lockup: a fault inside HardFault or NMI at {pc:#010x}"),
            Self::Breakpoint { pc, code } => {
                write!(f, "BKPT #{code} inside HardFault or NMI at {pc:#010x}: on the chip this is lockup")
            }
            Self::Unpredictable { pc, opcode } => {
                write!(f, "UNPREDICTABLE by the ARM manual: {opcode:#06x} at {pc:#010x}")
            }
            Self::Unmodelled { pc, address } => {
                write!(
                    f,
                    "core register {address:#010x}, accessed at {pc:#010x}, is not modelled in this way"
                )
            }
        }
    }
}

impl std::error::Error for Stop {}

/// What led to a HardFault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultCause {
    /// No code can be fetched from here.
    Fetch {
        /// Address of the halfword.
        address: u32,
    },
    /// The bus refused a load.
    Load {
        /// Address of the datum.
        address: u32,
    },
    /// The bus refused a store.
    Store {
        /// Address of the datum.
        address: u32,
    },
    /// ARMv6-M has no unaligned accesses.
    Unaligned {
        /// Address of the datum.
        address: u32,
    },
    /// An undefined instruction, UDF among them.
    Undefined {
        /// Its first halfword.
        opcode: u16,
    },
    /// A branch to an even address: the core has no ARM state.
    ArmState,
    /// A BKPT that nobody serves.
    Breakpoint {
        /// Its immediate.
        code: u8,
    },
    /// SVC where SVCall may not preempt.
    SupervisorCall,
    /// The exception frame does not fit: usually stack overflow.
    Stacking {
        /// Lowest address of the frame.
        frame: u32,
    },
    /// The exception frame cannot be read back.
    Unstacking {
        /// Lowest address of the frame.
        frame: u32,
    },
    /// The vector cannot be read.
    Vector {
        /// Address of the vector.
        address: u32,
    },
}

/// A HardFault and the instruction that led to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Address of the instruction.
    pub pc: u32,
    /// What was wrong.
    pub cause: FaultCause,
}

/// Why an instruction did not end by itself.
#[derive(Clone, Copy, Debug)]
enum Escape {
    /// It faulted.
    Fault(FaultCause),
    /// It branched to an EXC_RETURN value and has cost `cycles` so far.
    ExceptionReturn { value: u32, cycles: u8, opcode: u16 },
    /// See [`Stop::Unpredictable`].
    Unpredictable { opcode: u16 },
    /// See [`Stop::Unmodelled`].
    Unmodelled { address: u32 },
}

/// Whether instructions run, and what ends the wait if not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Sleep {
    #[default]
    Awake,
    /// WFI or sleep-on-exit.
    UntilInterrupt,
    /// WFE.
    UntilEvent,
}

/// One Cortex-M0+ core.
#[derive(Clone, Debug)]
pub struct Cpu {
    /// r0 to r12, the active stack pointer (r13), LR (r14), the address of the next instruction (r15).
    pub registers: [u32; 16],
    flags: Flags,
    /// Something other than the next instruction may be due: an exception, sleep, ARM state or a stop.
    attention: bool,
    /// EPSR.T.
    thumb: bool,
    /// CONTROL.SPSEL: r13 is PSP.
    on_process_stack: bool,
    /// CONTROL.nPRIV.
    unprivileged_thread: bool,
    primask: bool,
    /// The stack pointer that is not r13 now.
    other_stack: u32,
    /// Number of the running exception, 0 in thread mode.
    ipsr: u32,
    sleep: Sleep,
    event: bool,
    exceptions: Exceptions,
    systick: SysTick,
    system: SystemControl,
    reset_request: bool,
    stopped: Option<Stop>,
    last_fault: Option<Fault>,
}

impl Default for Cpu {
    fn default() -> Self {
        Self::new()
    }
}

impl Cpu {
    /// A core in privileged thread mode with all registers zero.
    pub fn new() -> Self {
        Self {
            registers: [0; 16],
            flags: Flags::default(),
            attention: false,
            thumb: true,
            on_process_stack: false,
            unprivileged_thread: false,
            primask: false,
            other_stack: 0,
            ipsr: 0,
            sleep: Sleep::Awake,
            event: false,
            exceptions: Exceptions::new(0),
            systick: SysTick::default(),
            system: SystemControl::default(),
            reset_request: false,
            stopped: None,
            last_fault: None,
        }
    }

    /// Resets the core, points VTOR at `vector_table` and loads SP and PC from it. The interrupt lines keep their
    /// levels: they belong to the chip.
    ///
    /// # Errors
    /// [`BusError`] when the bus refuses one of the two words; the core is reset all the same.
    pub fn reset<B: Bus>(&mut self, bus: &mut B, vector_table: u32) -> Result<(), BusError> {
        let lines = self.exceptions.lines();
        *self = Self { exceptions: Exceptions::new(lines), ..Self::new() };
        self.system.vector_table = vector_table & !0xFF;
        self.registers[LR] = u32::MAX;
        self.registers[SP] = bus.load(vector_table, Width::Word)? & !3;
        let entry = bus.load(vector_table + 4, Width::Word)?;
        self.branch_exchange(entry);
        self.refresh();
        Ok(())
    }

    /// Takes a pending exception or executes one instruction; returns its architectural cycles, without the extra
    /// cycles of the bus. Asleep it does nothing and returns 0.
    ///
    /// # Errors
    /// [`Stop`] when the core cannot go on; every further step returns the same until [`Cpu::reset`].
    #[inline]
    pub fn step<B: Bus>(&mut self, bus: &mut B) -> Result<u32, Stop> {
        if self.attention
            && let Some(cycles) = self.attend(bus)
        {
            return self.stopped.map_or(Ok(cycles), Err);
        }
        let pc = self.registers[PC];
        match self.execute(bus, pc) {
            Ok(cycles) => Ok(cycles),
            Err(escape) => {
                let cycles = self.leave(bus, pc, escape);
                self.stopped.map_or(Ok(cycles), Err)
            }
        }
    }

    /// Whether the core waits in WFI, WFE or sleep-on-exit. Waking needs no step: [`Cpu::set_irq_lines`] and
    /// [`Cpu::advance_systick`] end the wait at once.
    #[inline]
    pub fn is_sleeping(&self) -> bool {
        self.sleep != Sleep::Awake
    }

    /// Sets the levels of the hardware interrupt lines, bit n = IRQn. A rise latches pending; a level that is still
    /// high when its handler returns pends again.
    #[inline]
    pub fn set_irq_lines(&mut self, lines: u32) {
        if lines != self.exceptions.lines() {
            self.change_irq_lines(lines);
        }
    }

    /// Advances SysTick by `cycles` of clk_sys, awake or asleep.
    #[inline]
    pub fn advance_systick(&mut self, cycles: u64) {
        if self.systick.advance(cycles) {
            self.pend(1 << SYS_TICK);
            self.refresh();
        }
    }

    /// Cycles until SysTick raises its exception; `None` unless it is enabled with TICKINT.
    pub fn cycles_to_systick(&self) -> Option<u64> {
        self.systick.cycles_to_interrupt()
    }

    /// Whether AIRCR.SYSRESETREQ was written since the last call.
    #[inline]
    pub fn take_reset_request(&mut self) -> bool {
        std::mem::take(&mut self.reset_request)
    }

    /// Number of the exception that runs now, 0 in thread mode.
    pub fn active_exception(&self) -> u32 {
        self.ipsr
    }

    /// The exceptions whose handlers run or were preempted, bit n = number n.
    #[inline]
    pub fn active_exceptions(&self) -> u64 {
        self.exceptions.active()
    }

    /// Handlers started since the last reset, wrapping: a tail chain from an exception to itself leaves
    /// [`Self::active_exceptions`] as it was.
    #[inline]
    pub fn handlers_started(&self) -> u32 {
        self.exceptions.started()
    }

    /// Priority of an external interrupt, 0 to 3, the smaller the more urgent.
    pub fn irq_priority(&self, irq: u32) -> u32 {
        self.exceptions.priority_byte(EXTERNAL + irq) >> 6
    }

    /// The last HardFault since the last call, for reports.
    pub fn take_fault(&mut self) -> Option<Fault> {
        self.last_fault.take()
    }

    /// Flags, T bit and exception number as MRS and the exception frame show them (xPSR).
    pub fn xpsr(&self) -> u32 {
        self.flags.apsr() | self.ipsr | if self.thumb { XPSR_THUMB } else { 0 }
    }

    /// Address of the vector table (VTOR).
    pub fn vector_table(&self) -> u32 {
        self.system.vector_table
    }

    /// Whether PRIMASK holds interrupts back.
    pub fn interrupts_masked(&self) -> bool {
        self.primask
    }

    #[cold]
    fn change_irq_lines(&mut self, lines: u32) {
        let newly = self.exceptions.set_lines(lines);
        self.note_pended(newly);
        self.refresh();
    }

    /// Pends a set of exceptions; the caller refreshes.
    fn pend(&mut self, set: u64) {
        let newly = self.exceptions.pend(set);
        self.note_pended(newly);
    }

    fn note_pended(&mut self, newly: bool) {
        self.event |= newly && self.system.scr & SCR_SEVONPEND != 0;
    }

    /// Re-evaluates wake-up and attention. Due after every change of what is pending, enabled, active or masked.
    fn refresh(&mut self) {
        let preempting = self.exceptions.preempting().is_some();
        let to_take = preempting && self.exceptions.to_take(self.primask).is_some();
        match self.sleep {
            Sleep::Awake => {}
            // PRIMASK does not count: the race-free sleep is `cpsid i; wfi; cpsie i` (B1.5.18).
            Sleep::UntilInterrupt if preempting => self.sleep = Sleep::Awake,
            Sleep::UntilEvent if to_take => self.sleep = Sleep::Awake,
            Sleep::UntilEvent if self.event => {
                self.event = false;
                self.sleep = Sleep::Awake;
            }
            Sleep::UntilInterrupt | Sleep::UntilEvent => {}
        }
        self.attention = to_take || self.is_sleeping() || !self.thumb || self.stopped.is_some();
    }

    /// Does what is due before the next instruction and returns its cycles; `None` if nothing is due.
    #[cold]
    fn attend<B: Bus>(&mut self, bus: &mut B) -> Option<u32> {
        if self.stopped.is_some() || self.is_sleeping() {
            return Some(0);
        }
        if let Some(number) = self.exceptions.to_take(self.primask) {
            return Some(self.enter(bus, number));
        }
        if !self.thumb {
            let pc = self.registers[PC];
            return Some(self.leave(bus, pc, Escape::Fault(FaultCause::ArmState)));
        }
        self.refresh();
        None
    }

    /// Ends an instruction that did not end by itself; returns the cycles. May set [`Cpu::stopped`], as all below.
    #[cold]
    #[inline(never)]
    fn leave<B: Bus>(&mut self, bus: &mut B, pc: u32, escape: Escape) -> u32 {
        match escape {
            Escape::Fault(cause) => {
                self.last_fault = Some(Fault { pc, cause });
                // HardFault returns to the instruction that faulted (B1.5.6 ReturnAddress).
                self.registers[PC] = pc;
                match cause {
                    _ if self.exceptions.allows_hard_fault() => self.enter(bus, HARD_FAULT),
                    FaultCause::Breakpoint { code } => self.stop(Stop::Breakpoint { pc, code }),
                    _ => self.stop(Stop::Lockup { pc }),
                }
            }
            Escape::ExceptionReturn { value, cycles, opcode } => {
                u32::from(cycles) + self.return_from_exception(bus, pc, value, opcode)
            }
            Escape::Unpredictable { opcode } => self.stop(Stop::Unpredictable { pc, opcode }),
            Escape::Unmodelled { address } => self.stop(Stop::Unmodelled { pc, address }),
        }
    }

    /// Stops for good; takes no cycles.
    fn stop(&mut self, stop: Stop) -> u32 {
        self.stopped = Some(stop);
        self.attention = true;
        0
    }

    /// Exception entry: pushes the frame and starts the handler.
    fn enter<B: Bus>(&mut self, bus: &mut B, number: u32) -> u32 {
        let link = match (self.ipsr, self.on_process_stack) {
            (0, false) => RETURN_TO_THREAD_MAIN,
            (0, true) => RETURN_TO_THREAD_PROCESS,
            _ => RETURN_TO_HANDLER,
        };
        let pc = self.registers[PC];
        let stacked = self.push_frame(bus);
        if self.on_process_stack {
            self.switch_stack(false);
        }
        match stacked {
            Ok(()) => self.start_handler(bus, number, link),
            Err(cause) => self.start_derived_fault(bus, pc, cause, link),
        }
        ENTRY_CYCLES
    }

    fn push_frame<B: Bus>(&mut self, bus: &mut B) -> Result<(), FaultCause> {
        let sp = self.registers[SP];
        let frame = sp.wrapping_sub(FRAME_BYTES) & !4;
        let aligned = if sp & 4 != 0 { XPSR_ALIGNED } else { 0 };
        let r = &self.registers;
        let words = [r[0], r[1], r[2], r[3], r[12], r[LR], r[PC], self.xpsr() | aligned];
        self.registers[SP] = frame;
        for (address, word) in frame_addresses(frame).zip(words) {
            if address >= PRIVATE_BASE || bus.store(address, Width::Word, word).is_err() {
                return Err(FaultCause::Stacking { frame });
            }
        }
        Ok(())
    }

    /// Starts a handler; the frame is already on the stack that `link` names.
    fn start_handler<B: Bus>(&mut self, bus: &mut B, number: u32, link: u32) {
        let address = self.system.vector_table.wrapping_add(4 * number);
        let Ok(vector) = bus.load(address, Width::Word) else {
            let pc = self.registers[PC];
            let cause = FaultCause::Vector { address };
            if number == HARD_FAULT {
                self.last_fault = Some(Fault { pc, cause });
                self.stop(Stop::Lockup { pc });
            } else {
                self.start_derived_fault(bus, pc, cause, link);
            }
            return;
        };
        self.exceptions.activate(number);
        self.ipsr = number;
        self.event = true;
        self.registers[LR] = link;
        self.branch_exchange(vector);
        self.refresh();
    }

    /// HardFault instead of an entry or return that failed half-way; nothing is pushed again (B1.5.11).
    fn start_derived_fault<B: Bus>(&mut self, bus: &mut B, pc: u32, cause: FaultCause, link: u32) {
        self.last_fault = Some(Fault { pc, cause });
        if self.exceptions.allows_hard_fault() {
            self.start_handler(bus, HARD_FAULT, link);
        } else {
            self.stop(Stop::Lockup { pc });
        }
    }

    /// Exception return, or a tail chain into the next handler; returns the cycles on top of the BX or POP.
    fn return_from_exception<B: Bus>(&mut self, bus: &mut B, pc: u32, value: u32, opcode: u16) -> u32 {
        let nested = self.exceptions.nesting() > 1;
        let valid = match value {
            RETURN_TO_HANDLER => nested,
            RETURN_TO_THREAD_MAIN | RETURN_TO_THREAD_PROCESS => !nested,
            _ => false,
        };
        if !valid {
            return self.stop(Stop::Unpredictable { pc, opcode });
        }
        let pended_again = self.exceptions.deactivate(self.ipsr);
        self.note_pended(pended_again);
        self.event = true;

        if let Some(next) = self.exceptions.to_take(self.primask) {
            self.start_handler(bus, next, value);
            return TAIL_CHAIN_CYCLES;
        }

        let from_process_stack = value == RETURN_TO_THREAD_PROCESS;
        let frame = if from_process_stack { self.other_stack } else { self.registers[SP] };
        let words = match pop_frame(bus, frame) {
            Ok(words) => words,
            Err(cause) => {
                self.start_derived_fault(bus, pc, cause, value);
                return RETURN_CYCLES;
            }
        };
        let [r0, r1, r2, r3, r12, lr, return_address, xpsr] = words;
        let number = xpsr & IPSR_MASK;
        let consistent = if value == RETURN_TO_HANDLER {
            number != 0 && self.exceptions.is_active(number)
        } else {
            number == 0
        };
        if !consistent {
            return self.stop(Stop::Unpredictable { pc, opcode });
        }
        if from_process_stack {
            self.switch_stack(true);
        }
        self.registers[..4].copy_from_slice(&[r0, r1, r2, r3]);
        self.registers[12] = r12;
        self.registers[SP] = frame.wrapping_add(FRAME_BYTES) | if xpsr & XPSR_ALIGNED != 0 { 4 } else { 0 };
        self.registers[LR] = lr;
        self.registers[PC] = return_address & !1;
        self.flags = Flags::from_apsr(xpsr);
        self.thumb = xpsr & XPSR_THUMB != 0;
        self.ipsr = number;
        if number == 0 && self.system.scr & SCR_SLEEPONEXIT != 0 {
            self.sleep = Sleep::UntilInterrupt;
        }
        self.refresh();
        RETURN_CYCLES
    }

    /// Makes the other stack pointer r13.
    fn switch_stack(&mut self, to_process_stack: bool) {
        debug_assert_ne!(self.on_process_stack, to_process_stack);
        std::mem::swap(&mut self.registers[SP], &mut self.other_stack);
        self.on_process_stack = to_process_stack;
    }

    const fn is_privileged(&self) -> bool {
        self.ipsr != 0 || !self.unprivileged_thread
    }

    /// Branches to `target` and takes its bit 0 as the T bit.
    #[inline(always)]
    fn branch_exchange(&mut self, target: u32) {
        self.registers[PC] = target & !1;
        if target & 1 == 0 {
            self.thumb = false;
            self.attention = true;
        } else if !self.thumb {
            self.thumb = true;
        }
    }
}

fn pop_frame<B: Bus>(bus: &mut B, frame: u32) -> Result<[u32; 8], FaultCause> {
    let mut words = [0; 8];
    for (address, word) in frame_addresses(frame).zip(&mut words) {
        *word = match bus.load(address, Width::Word) {
            Ok(word) if address < PRIVATE_BASE => word,
            _ => return Err(FaultCause::Unstacking { frame }),
        };
    }
    Ok(words)
}

/// The eight word addresses of an exception frame; it may wrap when SP is garbage.
fn frame_addresses(frame: u32) -> impl Iterator<Item = u32> {
    (0..8).map(move |word| frame.wrapping_add(4 * word))
}
