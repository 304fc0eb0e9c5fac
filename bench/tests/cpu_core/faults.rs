//! HardFault, faults inside faults, lockup, and what stops the core loudly.

use bench::rp2040::cpu::{FaultCause, Stop};

use crate::assembler::{CPSID, NOP, bx, msr};
use crate::machine::{CODE, DATA, HARD_FAULT, ICSR, Machine, NOWHERE, RAM, STACK, VECTORS, handler, irq};

const STACKED_PC: u32 = 24;

#[test]
fn hard_fault_stacks_the_address_of_the_faulting_instruction() {
    // udf, bkpt, a bad load, an unaligned store.
    for (opcode, r0) in [(0xDE00, 0), (0xBE05, 0), (0x6800, NOWHERE), (0x6000, DATA + 1)] {
        let mut machine = Machine::with(&[NOP, opcode]);
        machine.cpu.registers[0] = r0;
        machine.steps(2);
        assert_eq!(machine.cpu.active_exception(), HARD_FAULT, "{opcode:#06x}");
        assert_eq!(machine.word(machine.sp() + STACKED_PC), CODE + 2);
        assert_eq!(machine.pc(), handler(HARD_FAULT));
    }
}

#[test]
fn a_branch_to_an_even_address_faults_at_its_target() {
    let mut machine = Machine::with(&[bx(0)]);
    machine.cpu.registers[0] = CODE + 0x40;
    machine.steps(2);
    let sp = machine.sp();
    assert_eq!(machine.word(sp + STACKED_PC), CODE + 0x40);
    assert_eq!(machine.word(sp + 28) & 1 << 24, 0, "the stacked T bit is clear");
    assert_eq!(machine.cpu.take_fault().map(|fault| fault.cause), Some(FaultCause::ArmState));
}

#[test]
fn a_fault_in_a_handlers_first_instruction_has_that_address() {
    let mut machine = Machine::with(&[NOP]);
    machine.put_handler(irq(0), &[0xDE00]);
    machine.enable(1);
    machine.cpu.set_irq_lines(1);
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), HARD_FAULT);
    assert_eq!(machine.word(machine.sp() + STACKED_PC), handler(irq(0)));
}

#[test]
fn a_fault_is_taken_under_primask() {
    let mut machine = Machine::with(&[CPSID, 0xDE00]);
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), HARD_FAULT);
}

#[test]
fn a_served_breakpoint_goes_on_and_may_change_registers() {
    let mut machine = Machine::with(&[0xBE07, NOP]);
    machine.memory.serves_breakpoints = true;
    machine.step();
    assert_eq!((machine.pc(), machine.cpu.registers[0]), (CODE + 2, 7));
}

#[test]
fn a_fault_inside_hard_fault_is_lockup_until_reset() {
    let mut machine = Machine::with(&[0xDE00]);
    machine.put_handler(HARD_FAULT, &[NOP, 0xDE01]);
    let lockup = Stop::Lockup { pc: handler(HARD_FAULT) + 2 };
    assert_eq!(machine.stop(), lockup);
    assert_eq!(machine.stop(), lockup, "it stays locked up");
    machine.cpu.reset(&mut machine.memory, VECTORS).expect("the vector table is in RAM");
    machine.step();
    assert_eq!(machine.cpu.active_exception(), HARD_FAULT, "reset ends it");
}

#[test]
fn a_breakpoint_inside_hard_fault_says_so() {
    let mut machine = Machine::with(&[0xDE00]);
    machine.put_handler(HARD_FAULT, &[0xBE09]);
    let stop = machine.stop();
    assert_eq!(stop, Stop::Breakpoint { pc: handler(HARD_FAULT), code: 9 });
    assert_eq!(stop.to_string(), "BKPT #9 inside HardFault or NMI at 0x20001060: on the chip this is lockup");
}

#[test]
fn a_fault_inside_nmi_is_lockup() {
    let mut machine = Machine::with(&[NOP]);
    machine.put_handler(2, &[0xDE00]);
    machine.write(ICSR, 1 << 31);
    assert_eq!(machine.stop(), Stop::Lockup { pc: handler(2) });
}

#[test]
fn a_stack_overflow_at_entry_becomes_a_hard_fault() {
    let mut machine = Machine::with(&[NOP]);
    machine.enable(1);
    machine.cpu.registers[13] = RAM + 8;
    machine.cpu.set_irq_lines(1);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), HARD_FAULT);
    let fault = machine.cpu.take_fault().expect("a fault was noted");
    assert_eq!((fault.pc, fault.cause), (CODE, FaultCause::Stacking { frame: RAM - 24 }));
    // HardFault outranks the interrupt, which stays pending.
    assert_eq!(machine.read(ICSR) >> 12 & 0x3F, irq(0));
}

#[test]
fn a_frame_that_cannot_be_read_back_becomes_a_hard_fault() {
    let mut machine = Machine::with(&[NOP]);
    machine.put_handler(irq(0), &[0x4685, 0x4770]);
    machine.enable(1);
    machine.cpu.registers[0] = NOWHERE;
    machine.cpu.set_irq_lines(1);
    machine.steps(2);
    machine.cpu.set_irq_lines(0);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), HARD_FAULT);
    assert_eq!(
        machine.cpu.take_fault().map(|fault| fault.cause),
        Some(FaultCause::Unstacking { frame: NOWHERE })
    );
}

#[test]
fn a_vector_table_that_cannot_be_read_is_lockup() {
    let mut machine = Machine::with(&[NOP]);
    machine.write(0xE000_ED08, NOWHERE);
    machine.enable(1);
    machine.cpu.set_irq_lines(1);
    assert_eq!(machine.stop(), Stop::Lockup { pc: CODE });
    let vector_of_hard_fault = FaultCause::Vector { address: NOWHERE + 4 * HARD_FAULT };
    assert_eq!(machine.cpu.take_fault().map(|fault| fault.cause), Some(vector_of_hard_fault));
}

#[test]
fn exc_return_in_thread_mode_is_an_ordinary_bad_branch() {
    let mut machine = Machine::with(&[bx(0)]);
    machine.cpu.registers[0] = 0xFFFF_FFF9;
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), HARD_FAULT);
}

#[test]
fn an_exc_return_that_does_not_fit_stops_loudly() {
    for value in [0xFFFF_FFF1, 0xFFFF_FFF5, 0xF000_0000] {
        let mut machine = Machine::with(&[NOP]);
        machine.put_handler(irq(0), &[bx(0)]);
        machine.enable(1);
        machine.cpu.registers[0] = value;
        machine.cpu.set_irq_lines(1);
        assert_eq!(machine.stop(), Stop::Unpredictable { pc: handler(irq(0)), opcode: bx(0) }, "{value:#x}");
    }
}

#[test]
fn core_registers_that_are_not_modelled_stop_loudly() {
    // DWT_CTRL; NVIC_IPR0 by byte, which ARMv6-M does not allow.
    for (opcode, address) in [(0x6801, 0xE000_1000u32), (0x6001, 0xE000_1000), (0x7001, 0xE000_E400)] {
        let mut machine = Machine::with(&[opcode]);
        machine.cpu.registers[0] = address;
        let stop = machine.stop();
        assert_eq!(stop, Stop::Unmodelled { pc: CODE, address });
        assert!(stop.to_string().contains("is not modelled"), "{stop}");
    }
}

#[test]
fn unprivileged_code_reaches_neither_masks_nor_core_registers() {
    let code = [&msr(20, 0)[..], &[CPSID], &msr(8, 1), &[0x680A]].concat();
    let mut machine = Machine::with(&code);
    machine.cpu.registers[..2].copy_from_slice(&[1, 0xE000_ED00]);
    machine.steps(3);
    assert!(!machine.cpu.interrupts_masked(), "CPSID does nothing");
    assert_eq!(machine.sp(), STACK, "MSR MSP does nothing");
    machine.step();
    assert_eq!(machine.cpu.active_exception(), HARD_FAULT, "no access to CPUID");
}
