//! Fetch and execute: the ARMv6-M instruction set.
//!
//! Owns what each instruction does and its cycles: one `match` on the decoded name. It refuses what ARMv6-M leaves
//! UNPREDICTABLE when compilers never emit it; the should-be-zero bits are ignored.
//!
//! Source: ARMv6-M Architecture Reference Manual, chapters A5 (encodings) and A6 (operations); Cortex-M0+ TRM r0p1,
//! table 3-1 (cycles, with the single-cycle multiplier that RP2040 has).

use super::decode::Instruction::*;
use super::decode::decode;
use super::flags::{Flags, asr, lsl, lsr, ror};
use super::private_bus::PRIVATE_BASE;
use super::{Cpu, Escape, FaultCause, LR, PC, SP, Sleep};
use crate::rp2040::bus::{Bus, Width};

/// Loads and stores of zero-wait memory.
const ACCESS: u32 = 2;
const BRANCH: u32 = 2;
const BRANCH_LINK: u32 = 3;
/// MRS, MSR and the barriers.
const SYSTEM: u32 = 3;
const SLEEP: u32 = 2;

/// Top nibble of a branch target that is an exception return in handler mode.
const EXC_RETURN_NIBBLE: u32 = 0xF;

/// Nothing executes from here upwards: peripherals, devices and the system region are execute-never by the default
/// memory map (B3.1), and RP2040 has no external RAM between them.
const EXECUTE_NEVER: u32 = 0x4000_0000;

type Executed = Result<u32, Escape>;

/// Three-bit register number at `shift`.
#[inline(always)]
const fn low(op: u32, shift: u32) -> usize {
    (op >> shift & 7) as usize
}

/// Four-bit register number at `shift`.
#[inline(always)]
const fn any(op: u32, shift: u32) -> usize {
    (op >> shift & 15) as usize
}

/// Four-bit destination of the high-register instructions: bit 7 and bits 2:0.
#[inline(always)]
const fn split_destination(op: u32) -> usize {
    (op >> 4 & 8 | op & 7) as usize
}

#[inline(always)]
const fn imm3(op: u32) -> u32 {
    op >> 6 & 7
}

#[inline(always)]
const fn imm5(op: u32) -> u32 {
    op >> 6 & 31
}

#[inline(always)]
const fn imm8(op: u32) -> u32 {
    op & 0xFF
}

/// Sign-extends the low `bits`.
#[inline(always)]
const fn sign_extend(value: u32, bits: u32) -> u32 {
    ((value << (32 - bits)).cast_signed() >> (32 - bits)).cast_unsigned()
}

/// The first halfword, for reports.
const fn halfword(op: u32) -> u16 {
    (op & 0xFFFF) as u16
}

const fn is_aligned(address: u32, width: Width) -> bool {
    match width {
        Width::Byte => true,
        Width::Half => address & 1 == 0,
        Width::Word => address & 3 == 0,
    }
}

impl Cpu {
    /// Executes the instruction at `pc`; returns its cycles.
    #[inline(always)]
    #[expect(clippy::too_many_lines, reason = "the instruction set is one table")]
    pub(super) fn execute<B: Bus>(&mut self, bus: &mut B, pc: u32) -> Executed {
        let opcode = fetch(bus, pc)?;
        let op = u32::from(opcode);
        self.registers[PC] = pc.wrapping_add(2);
        let r = &mut self.registers;
        let flags = &mut self.flags;

        match decode(opcode) {
            // LSLS #0 is MOVS: the carry stays.
            LslImmediate => r[low(op, 0)] = flags.set_nzc(lsl(r[low(op, 3)], imm5(op), flags.carry)),
            LsrImmediate => {
                r[low(op, 0)] = flags.set_nzc(lsr(r[low(op, 3)], full_if_zero(imm5(op)), flags.carry));
            }
            AsrImmediate => {
                r[low(op, 0)] = flags.set_nzc(asr(r[low(op, 3)], full_if_zero(imm5(op)), flags.carry));
            }
            AddRegister => r[low(op, 0)] = flags.add(r[low(op, 3)], r[low(op, 6)]),
            SubRegister => r[low(op, 0)] = flags.sub(r[low(op, 3)], r[low(op, 6)]),
            AddImmediate3 => r[low(op, 0)] = flags.add(r[low(op, 3)], imm3(op)),
            SubImmediate3 => r[low(op, 0)] = flags.sub(r[low(op, 3)], imm3(op)),
            MovImmediate => r[low(op, 8)] = flags.set_nz(imm8(op)),
            CmpImmediate => {
                flags.sub(r[low(op, 8)], imm8(op));
            }
            AddImmediate8 => r[low(op, 8)] = flags.add(r[low(op, 8)], imm8(op)),
            SubImmediate8 => r[low(op, 8)] = flags.sub(r[low(op, 8)], imm8(op)),

            // Data processing, low registers.
            And => r[low(op, 0)] = flags.set_nz(r[low(op, 0)] & r[low(op, 3)]),
            Eor => r[low(op, 0)] = flags.set_nz(r[low(op, 0)] ^ r[low(op, 3)]),
            LslRegister => shift_by_register(r, flags, op, lsl),
            LsrRegister => shift_by_register(r, flags, op, lsr),
            AsrRegister => shift_by_register(r, flags, op, asr),
            Adc => r[low(op, 0)] = flags.adc(r[low(op, 0)], r[low(op, 3)]),
            Sbc => r[low(op, 0)] = flags.adc(r[low(op, 0)], !r[low(op, 3)]),
            RorRegister => shift_by_register(r, flags, op, ror),
            Tst => {
                flags.set_nz(r[low(op, 0)] & r[low(op, 3)]);
            }
            Rsb => r[low(op, 0)] = flags.sub(0, r[low(op, 3)]),
            CmpRegister => {
                flags.sub(r[low(op, 0)], r[low(op, 3)]);
            }
            Cmn => {
                flags.add(r[low(op, 0)], r[low(op, 3)]);
            }
            Orr => r[low(op, 0)] = flags.set_nz(r[low(op, 0)] | r[low(op, 3)]),
            Mul => r[low(op, 0)] = flags.set_nz(r[low(op, 0)].wrapping_mul(r[low(op, 3)])),
            Bic => r[low(op, 0)] = flags.set_nz(r[low(op, 0)] & !r[low(op, 3)]),
            Mvn => r[low(op, 0)] = flags.set_nz(!r[low(op, 3)]),

            // High registers: ADD, CMP, MOV, BX, BLX.
            AddHigh => {
                let destination = split_destination(op);
                let sum = self.operand(destination).wrapping_add(self.operand(any(op, 3)));
                return Ok(self.write_any(destination, sum));
            }
            CmpHigh => {
                let (a, b) = (self.operand(split_destination(op)), self.operand(any(op, 3)));
                self.flags.sub(a, b);
            }
            MovHigh => {
                let value = self.operand(any(op, 3));
                return Ok(self.write_any(split_destination(op), value));
            }
            Bx => {
                let target = self.operand(any(op, 3));
                return self.branch_or_return(target, BRANCH, op);
            }
            Blx => {
                let target = self.operand(any(op, 3));
                self.registers[LR] = self.registers[PC] | 1;
                self.branch_exchange(target);
                return Ok(BRANCH);
            }

            LdrLiteral => {
                let address = (pc.wrapping_add(4) & !3).wrapping_add(imm8(op) << 2);
                return self.load_to(bus, low(op, 8), address, Width::Word);
            }
            StrRegister => return self.store_from(bus, low(op, 0), self.indexed(op), Width::Word),
            StrhRegister => return self.store_from(bus, low(op, 0), self.indexed(op), Width::Half),
            StrbRegister => return self.store_from(bus, low(op, 0), self.indexed(op), Width::Byte),
            LdrsbRegister => {
                let value = self.load(bus, self.indexed(op), Width::Byte)?;
                self.registers[low(op, 0)] = sign_extend(value, 8);
                return Ok(ACCESS);
            }
            LdrRegister => return self.load_to(bus, low(op, 0), self.indexed(op), Width::Word),
            LdrhRegister => return self.load_to(bus, low(op, 0), self.indexed(op), Width::Half),
            LdrbRegister => return self.load_to(bus, low(op, 0), self.indexed(op), Width::Byte),
            LdrshRegister => {
                let value = self.load(bus, self.indexed(op), Width::Half)?;
                self.registers[low(op, 0)] = sign_extend(value, 16);
                return Ok(ACCESS);
            }
            StrImmediate => return self.store_from(bus, low(op, 0), self.offset(op, 2), Width::Word),
            LdrImmediate => return self.load_to(bus, low(op, 0), self.offset(op, 2), Width::Word),
            StrbImmediate => return self.store_from(bus, low(op, 0), self.offset(op, 0), Width::Byte),
            LdrbImmediate => return self.load_to(bus, low(op, 0), self.offset(op, 0), Width::Byte),
            StrhImmediate => return self.store_from(bus, low(op, 0), self.offset(op, 1), Width::Half),
            LdrhImmediate => return self.load_to(bus, low(op, 0), self.offset(op, 1), Width::Half),
            StrStack => {
                let address = r[SP].wrapping_add(imm8(op) << 2);
                return self.store_from(bus, low(op, 8), address, Width::Word);
            }
            LdrStack => {
                let address = r[SP].wrapping_add(imm8(op) << 2);
                return self.load_to(bus, low(op, 8), address, Width::Word);
            }
            Adr => {
                r[low(op, 8)] = (pc.wrapping_add(4) & !3).wrapping_add(imm8(op) << 2);
            }
            AddFromStack => r[low(op, 8)] = r[SP].wrapping_add(imm8(op) << 2),

            // Miscellaneous.
            AddToStack => r[SP] = r[SP].wrapping_add((op & 0x7F) << 2),
            SubFromStack => r[SP] = r[SP].wrapping_sub((op & 0x7F) << 2),
            Sxth => r[low(op, 0)] = sign_extend(r[low(op, 3)], 16),
            Sxtb => r[low(op, 0)] = sign_extend(r[low(op, 3)], 8),
            Uxth => r[low(op, 0)] = r[low(op, 3)] & 0xFFFF,
            Uxtb => r[low(op, 0)] = r[low(op, 3)] & 0xFF,
            Push => return self.push(bus, op),
            Cps => return self.change_processor_state(op),
            Rev => r[low(op, 0)] = r[low(op, 3)].swap_bytes(),
            Rev16 => r[low(op, 0)] = r[low(op, 3)].swap_bytes().rotate_right(16),
            Revsh => r[low(op, 0)] = sign_extend(r[low(op, 3)].swap_bytes() >> 16, 16),
            Pop => return self.pop(bus, op),
            Bkpt => return self.breakpoint(bus, pc, op),
            Hint => return self.hint(op),

            Stm => return self.store_multiple(bus, op),
            Ldm => return self.load_multiple(bus, op),

            // Conditional branches; the pairs are a condition and its negation.
            Beq => return Ok(branch_if(r, flags.z(), op)),
            Bne => return Ok(branch_if(r, !flags.z(), op)),
            Bcs => return Ok(branch_if(r, flags.carry, op)),
            Bcc => return Ok(branch_if(r, !flags.carry, op)),
            Bmi => return Ok(branch_if(r, flags.n(), op)),
            Bpl => return Ok(branch_if(r, !flags.n(), op)),
            Bvs => return Ok(branch_if(r, flags.v(), op)),
            Bvc => return Ok(branch_if(r, !flags.v(), op)),
            Bhi => return Ok(branch_if(r, flags.carry && !flags.z(), op)),
            Bls => return Ok(branch_if(r, !flags.carry || flags.z(), op)),
            Bge => return Ok(branch_if(r, flags.ge(), op)),
            Blt => return Ok(branch_if(r, !flags.ge(), op)),
            Bgt => return Ok(branch_if(r, flags.ge() && !flags.z(), op)),
            Ble => return Ok(branch_if(r, !flags.ge() || flags.z(), op)),
            Svc => return self.supervisor_call(),
            B => {
                r[PC] = pc.wrapping_add(4).wrapping_add(sign_extend(op, 11) << 1);
                return Ok(BRANCH);
            }
            Wide => return self.execute_wide(bus, pc, op),

            Undefined => return Err(Escape::Fault(FaultCause::Undefined { opcode: halfword(op) })),
        }
        Ok(1)
    }

    /// BL, the only 32-bit instruction that is frequent; the others are out of line.
    #[inline(always)]
    fn execute_wide<B: Bus>(&mut self, bus: &mut B, pc: u32, op: u32) -> Executed {
        let second = u32::from(fetch(bus, self.registers[PC])?);
        let next = pc.wrapping_add(4);
        if second & 0xD000 != 0xD000 {
            return self.execute_system(next, op, second);
        }
        let sign = op >> 10 & 1;
        let i1 = !(second >> 13 ^ sign) & 1;
        let i2 = !(second >> 11 ^ sign) & 1;
        let offset = sign << 24 | i1 << 23 | i2 << 22 | (op & 0x3FF) << 12 | (second & 0x7FF) << 1;
        self.registers[LR] = next | 1;
        self.registers[PC] = next.wrapping_add(sign_extend(offset, 25));
        Ok(BRANCH_LINK)
    }

    /// MSR, MRS and the barriers.
    #[cold]
    fn execute_system(&mut self, next: u32, op: u32, second: u32) -> Executed {
        let undefined = Err(Escape::Fault(FaultCause::Undefined { opcode: halfword(op) }));
        if second & 0xD000 != 0x8000 {
            return undefined;
        }
        let special = second & 0xFF;
        match op >> 4 & 0x7F {
            0x38 | 0x39 => self.write_special(special, any(op, 0), op)?,
            0x3B if matches!(second >> 4 & 0xF, 4..=6) => {}
            0x3E | 0x3F => self.read_special(special, any(second, 8), op)?,
            _ => return undefined,
        }
        self.registers[PC] = next;
        Ok(SYSTEM)
    }

    /// MRS.
    fn read_special(&mut self, special: u32, destination: usize, op: u32) -> Result<(), Escape> {
        let privileged = self.is_privileged();
        let (main, process) = if self.on_process_stack {
            (self.other_stack, self.registers[SP])
        } else {
            (self.registers[SP], self.other_stack)
        };
        let value = match special {
            // Bit 0 adds IPSR, bit 2 leaves the flags out; EPSR always reads as zero.
            0..=3 | 5..=7 => {
                (if special & 4 == 0 { self.flags.apsr() } else { 0 })
                    | (if special & 1 != 0 && privileged { self.ipsr } else { 0 })
            }
            8 if privileged => main,
            9 if privileged => process,
            16 if privileged => u32::from(self.primask),
            8 | 9 | 16 => 0,
            20 => u32::from(self.on_process_stack) << 1 | u32::from(self.unprivileged_thread),
            _ => return Err(Escape::Unpredictable { opcode: halfword(op) }),
        };
        if destination == SP || destination == PC {
            return Err(Escape::Unpredictable { opcode: halfword(op) });
        }
        self.registers[destination] = value;
        Ok(())
    }

    /// MSR.
    fn write_special(&mut self, special: u32, source: usize, op: u32) -> Result<(), Escape> {
        if source == SP || source == PC {
            return Err(Escape::Unpredictable { opcode: halfword(op) });
        }
        let value = self.registers[source];
        let privileged = self.is_privileged();
        match special {
            0..=3 => self.flags = Flags::from_apsr(value),
            5..=7 => {}
            8 | 9 | 16 | 20 if !privileged => {}
            8 | 9 if (special == 9) == self.on_process_stack => self.registers[SP] = value & !3,
            8 | 9 => self.other_stack = value & !3,
            16 => {
                self.primask = value & 1 != 0;
                self.refresh();
            }
            20 => {
                self.unprivileged_thread = value & 1 != 0;
                let to_process_stack = value & 2 != 0;
                // Handlers always run on the main stack; SPSEL is ignored there.
                if self.ipsr == 0 && to_process_stack != self.on_process_stack {
                    self.switch_stack(to_process_stack);
                }
            }
            _ => return Err(Escape::Unpredictable { opcode: halfword(op) }),
        }
        Ok(())
    }

    /// A register as an operand: r15 reads as the instruction's address + 4.
    #[inline(always)]
    fn operand(&self, register: usize) -> u32 {
        let value = self.registers[register & 15];
        if register == PC { value.wrapping_add(2) } else { value }
    }

    /// Writes any register; r15 is a branch, r13 is always word-aligned. Returns the cycles.
    #[inline(always)]
    fn write_any(&mut self, register: usize, value: u32) -> u32 {
        match register {
            PC => {
                self.registers[PC] = value & !1;
                BRANCH
            }
            SP => {
                self.registers[SP] = value & !3;
                1
            }
            _ => {
                self.registers[register & 15] = value;
                1
            }
        }
    }

    /// BX and POP to PC: an exception return if the core runs a handler and the target says so.
    #[inline(always)]
    fn branch_or_return(&mut self, target: u32, cycles: u32, op: u32) -> Executed {
        if target >> 28 == EXC_RETURN_NIBBLE && self.ipsr != 0 {
            #[expect(clippy::cast_possible_truncation, reason = "at most 12 cycles")]
            let cycles = cycles as u8;
            return Err(Escape::ExceptionReturn { value: target, cycles, opcode: halfword(op) });
        }
        self.branch_exchange(target);
        Ok(cycles)
    }

    /// Address of the register-offset loads and stores.
    #[inline(always)]
    fn indexed(&self, op: u32) -> u32 {
        self.registers[low(op, 3)].wrapping_add(self.registers[low(op, 6)])
    }

    /// Address of the immediate-offset loads and stores.
    #[inline(always)]
    fn offset(&self, op: u32, scale: u32) -> u32 {
        self.registers[low(op, 3)].wrapping_add(imm5(op) << scale)
    }

    #[inline(always)]
    fn load<B: Bus>(&mut self, bus: &mut B, address: u32, width: Width) -> Executed {
        if !is_aligned(address, width) {
            return Err(Escape::Fault(FaultCause::Unaligned { address }));
        }
        if address >= PRIVATE_BASE {
            return self.load_private(address, width);
        }
        bus.load(address, width).map_err(|_| Escape::Fault(FaultCause::Load { address }))
    }

    #[inline(always)]
    fn store<B: Bus>(&mut self, bus: &mut B, address: u32, width: Width, value: u32) -> Result<(), Escape> {
        if !is_aligned(address, width) {
            return Err(Escape::Fault(FaultCause::Unaligned { address }));
        }
        if address >= PRIVATE_BASE {
            return self.store_private(address, width, value);
        }
        bus.store(address, width, value).map_err(|_| Escape::Fault(FaultCause::Store { address }))
    }

    #[inline(always)]
    fn load_to<B: Bus>(&mut self, bus: &mut B, register: usize, address: u32, width: Width) -> Executed {
        self.registers[register & 7] = self.load(bus, address, width)?;
        Ok(ACCESS)
    }

    #[inline(always)]
    fn store_from<B: Bus>(&mut self, bus: &mut B, register: usize, address: u32, width: Width) -> Executed {
        self.store(bus, address, width, self.registers[register & 7])?;
        Ok(ACCESS)
    }

    /// PUSH: SP moves when all stores have gone well, so that a fault can be retried.
    #[inline(always)]
    fn push<B: Bus>(&mut self, bus: &mut B, op: u32) -> Executed {
        // Bit 8 stands for LR.
        let list = op & 0xFF | (op & 0x100) << 6;
        let count = list.count_ones();
        let bottom = self.registers[SP].wrapping_sub(4 * count);
        self.store_list(bus, list, bottom, op)?;
        self.registers[SP] = bottom;
        Ok(1 + count)
    }

    #[inline(always)]
    fn pop<B: Bus>(&mut self, bus: &mut B, op: u32) -> Executed {
        let list = op & 0xFF;
        let bottom = self.registers[SP];
        let low_count = list.count_ones();
        let top = bottom.wrapping_add(4 * low_count);
        if op & 0x100 == 0 {
            self.load_list(bus, list, bottom, op)?;
            self.registers[SP] = top;
            return Ok(1 + low_count);
        }
        if list != 0 {
            self.load_list(bus, list, bottom, op)?;
        }
        let target = self.load(bus, top, Width::Word)?;
        self.registers[SP] = top.wrapping_add(4);
        self.branch_or_return(target, 3 + low_count + 1, op)
    }

    #[inline(always)]
    fn store_multiple<B: Bus>(&mut self, bus: &mut B, op: u32) -> Executed {
        let base = low(op, 8);
        let list = imm8(op);
        let count = list.count_ones();
        let address = self.registers[base];
        self.store_list(bus, list, address, op)?;
        self.registers[base] = address.wrapping_add(4 * count);
        Ok(1 + count)
    }

    #[inline(always)]
    fn load_multiple<B: Bus>(&mut self, bus: &mut B, op: u32) -> Executed {
        let base = low(op, 8);
        let list = imm8(op);
        let count = list.count_ones();
        let address = self.registers[base];
        if let Err(escape) = self.load_list(bus, list, address, op) {
            self.registers[base] = address;
            return Err(escape);
        }
        // A base that is in the list keeps what was loaded.
        if list >> base & 1 == 0 {
            self.registers[base] = address.wrapping_add(4 * count);
        }
        Ok(1 + count)
    }

    #[inline(always)]
    fn store_list<B: Bus>(
        &mut self,
        bus: &mut B,
        mut list: u32,
        mut address: u32,
        op: u32,
    ) -> Result<(), Escape> {
        if list == 0 {
            return Err(Escape::Unpredictable { opcode: halfword(op) });
        }
        while list != 0 {
            let register = list.trailing_zeros() as usize & 15;
            list &= list - 1;
            self.store(bus, address, Width::Word, self.registers[register])?;
            address = address.wrapping_add(4);
        }
        Ok(())
    }

    #[inline(always)]
    fn load_list<B: Bus>(
        &mut self,
        bus: &mut B,
        mut list: u32,
        mut address: u32,
        op: u32,
    ) -> Result<(), Escape> {
        if list == 0 {
            return Err(Escape::Unpredictable { opcode: halfword(op) });
        }
        while list != 0 {
            let register = list.trailing_zeros() as usize & 7;
            list &= list - 1;
            self.registers[register] = self.load(bus, address, Width::Word)?;
            address = address.wrapping_add(4);
        }
        Ok(())
    }

    /// CPSIE i and CPSID i; without privilege they do nothing.
    fn change_processor_state(&mut self, op: u32) -> Executed {
        match op & 0x3F {
            0x22 | 0x32 => {
                if self.is_privileged() {
                    self.primask = op & 0x10 != 0;
                    self.refresh();
                }
                Ok(1)
            }
            0x20..=0x3F => Err(Escape::Unpredictable { opcode: halfword(op) }),
            _ => Err(Escape::Fault(FaultCause::Undefined { opcode: halfword(op) })),
        }
    }

    /// NOP, YIELD, WFE, WFI, SEV; a hint without a name is a NOP.
    fn hint(&mut self, op: u32) -> Executed {
        if op & 0xF != 0 {
            // IT does not exist in ARMv6-M.
            return Err(Escape::Fault(FaultCause::Undefined { opcode: halfword(op) }));
        }
        match op >> 4 & 0xF {
            2 => {
                if self.event {
                    self.event = false;
                } else {
                    self.sleep = Sleep::UntilEvent;
                    self.refresh();
                }
                Ok(SLEEP)
            }
            3 => {
                self.sleep = Sleep::UntilInterrupt;
                self.refresh();
                Ok(SLEEP)
            }
            4 => {
                self.event = true;
                Ok(1)
            }
            _ => Ok(1),
        }
    }

    /// BKPT: first the bus (boot ROM services), then HardFault.
    fn breakpoint<B: Bus>(&mut self, bus: &mut B, pc: u32, op: u32) -> Executed {
        let code = (op & 0xFF) as u8;
        if bus.breakpoint(pc, code, &mut self.registers) {
            Ok(1)
        } else {
            Err(Escape::Fault(FaultCause::Breakpoint { code }))
        }
    }

    /// SVC; entry follows with the next step.
    fn supervisor_call(&mut self) -> Executed {
        if !self.exceptions.allows_supervisor_call(self.primask) {
            return Err(Escape::Fault(FaultCause::SupervisorCall));
        }
        self.pend(1 << super::exceptions::SV_CALL);
        self.refresh();
        Ok(1)
    }
}

#[inline(always)]
fn fetch<B: Bus>(bus: &mut B, address: u32) -> Result<u16, Escape> {
    if address >= EXECUTE_NEVER {
        return Err(Escape::Fault(FaultCause::Fetch { address }));
    }
    bus.fetch(address).map_err(|_| Escape::Fault(FaultCause::Fetch { address }))
}

/// LSR and ASR by an immediate 0 shift by 32.
#[inline(always)]
const fn full_if_zero(count: u32) -> u32 {
    if count == 0 { 32 } else { count }
}

#[inline(always)]
fn shift_by_register(
    r: &mut [u32; 16],
    flags: &mut Flags,
    op: u32,
    shift: impl Fn(u32, u32, bool) -> (u32, bool),
) {
    let count = r[low(op, 3)] & 0xFF;
    r[low(op, 0)] = flags.set_nzc(shift(r[low(op, 0)], count, flags.carry));
}

#[inline(always)]
fn branch_if(r: &mut [u32; 16], condition: bool, op: u32) -> u32 {
    if condition {
        r[PC] = r[PC].wrapping_add(2).wrapping_add(sign_extend(op, 8) << 1);
        BRANCH
    } else {
        1
    }
}
