//! NVIC and exception model: ARMv6-M ARM, B1.5 and B3.4.

use crate::assembler::{CPSID, CPSIE, NOP, bx, mrs, msr};
use crate::machine::{
    CODE, DATA, HARD_FAULT, ICER, ICPR, ICSR, ISPR, Machine, SHPR3, STACK, VECTORS, handler, irq,
};

const PENDSVSET: u32 = 1 << 28;
const NMIPENDSET: u32 = 1 << 31;
const NMI: u32 = 2;
const SV_CALL: u32 = 11;
const PEND_SV: u32 = 14;

#[test]
fn entry_stacks_the_frame_and_return_restores_it() {
    let mut machine = Machine::with(&[NOP, NOP]);
    // The handler destroys what it may: movs r0..r3, #0; mov r12, r0; bx lr
    machine.put_handler(irq(0), &[0x2000, 0x2100, 0x2200, 0x2300, 0x4684, 0x4770]);
    machine.enable(1);
    machine.cpu.registers[..4].copy_from_slice(&[10, 11, 12, 13]);
    machine.cpu.registers[12] = 14;
    machine.cpu.registers[14] = 15;
    machine.cpu.set_irq_lines(1);
    machine.step();
    let frame: Vec<u32> = (0..8).map(|word| machine.word(STACK - 32 + 4 * word)).collect();
    assert_eq!(frame, [10, 11, 12, 13, 14, 15, CODE, 0x0100_0000]);
    assert_eq!(machine.cpu.registers[14], 0xFFFF_FFF9);
    machine.cpu.set_irq_lines(0);
    machine.steps(6);
    assert_eq!(machine.cpu.registers[..4], [10, 11, 12, 13]);
    assert_eq!((machine.cpu.registers[12], machine.cpu.registers[14]), (14, 15));
    assert_eq!((machine.pc(), machine.sp()), (CODE, STACK));
    assert_eq!(machine.cpu.active_exception(), 0);
}

#[test]
fn the_frame_is_aligned_to_8_bytes_and_bit_9_remembers_the_gap() {
    for (sp, frame, gap) in [(STACK, STACK - 32, 0), (STACK - 4, STACK - 40, 1 << 9)] {
        let mut machine = Machine::with(&[NOP]);
        machine.cpu.registers[13] = sp;
        machine.enable(1);
        machine.cpu.set_irq_lines(1);
        machine.step();
        assert_eq!(machine.sp(), frame);
        assert_eq!(machine.word(frame + 28) & 1 << 9, gap);
        machine.cpu.set_irq_lines(0);
        machine.step();
        assert_eq!(machine.sp(), sp);
    }
}

#[test]
fn flags_survive_an_interrupt() {
    for flags in (0..16).map(|nibble| nibble << 28) {
        let mut machine = Machine::with(&msr(0, 0));
        // cmp r0, r0 in the handler sets Z and C.
        machine.put_handler(irq(0), &[0x4280, 0x4770]);
        machine.enable(1);
        machine.cpu.registers[0] = flags;
        machine.step();
        machine.cpu.set_irq_lines(1);
        machine.steps(2);
        machine.cpu.set_irq_lines(0);
        machine.step();
        assert_eq!(machine.cpu.xpsr() & 0xF000_0000, flags);
    }
}

#[test]
fn the_process_stack_takes_the_frame_and_handlers_use_the_main_stack() {
    let process_stack = DATA + 0x400;
    let code = [&msr(9, 0)[..], &msr(20, 1), &[NOP]].concat();
    let mut machine = Machine::with(&code);
    machine.enable(1);
    machine.cpu.registers[..2].copy_from_slice(&[process_stack, 2]);
    machine.steps(2);
    assert_eq!(machine.sp(), process_stack);
    machine.cpu.set_irq_lines(1);
    machine.step();
    assert_eq!(machine.cpu.registers[14], 0xFFFF_FFFD);
    assert_eq!(machine.sp(), STACK, "the main stack is untouched");
    assert_eq!(machine.word(process_stack - 32), process_stack, "stacked r0");
    machine.cpu.set_irq_lines(0);
    machine.step();
    assert_eq!(machine.sp(), process_stack);
}

#[test]
fn a_more_urgent_interrupt_preempts_and_an_equal_one_waits() {
    let mut machine = Machine::with(&[NOP; 4]);
    for interrupt in [1, 2, 3] {
        machine.put_handler(irq(interrupt), &[NOP, NOP, bx(14)]);
    }
    machine.enable(0b1110);
    machine.prioritise(1, 2);
    machine.prioritise(2, 2);
    machine.prioritise(3, 1);
    machine.cpu.set_irq_lines(0b0010);
    machine.step();
    machine.cpu.set_irq_lines(0b0110);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(1), "an equal priority does not preempt");
    machine.cpu.set_irq_lines(0b1110);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(3));
    assert_eq!(machine.cpu.registers[14], 0xFFFF_FFF1, "back to a handler");
    machine.cpu.set_irq_lines(0b0110);
    machine.steps(3);
    assert_eq!(machine.cpu.active_exception(), irq(1), "back in the preempted handler");
    machine.cpu.set_irq_lines(0b0100);
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), irq(2), "the equal one is tail-chained");
}

#[test]
fn equal_priorities_are_taken_by_number_and_urgent_ones_first() {
    let mut machine = Machine::with(&[NOP; 4]);
    let set = 1 << 4 | 1 << 9 | 1 << 31 | 1 << 20;
    machine.enable(set);
    for (interrupt, priority) in [(4, 3), (9, 3), (31, 1), (20, 2)] {
        machine.prioritise(interrupt, priority);
    }
    machine.write(0xE000_ED10, 0);
    machine.put_code(CODE, &[CPSID, NOP, CPSIE]);
    machine.step();
    machine.write(ISPR, set);
    machine.steps(2);
    let mut order = Vec::new();
    for _ in 0..4 {
        machine.step();
        order.push(machine.cpu.active_exception());
    }
    assert_eq!(order, [irq(31), irq(20), irq(4), irq(9)]);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), 0);
}

#[test]
fn a_tail_chain_keeps_the_frame() {
    let mut machine = Machine::with(&[NOP; 2]);
    machine.enable(0b11);
    machine.cpu.registers[0] = 77;
    machine.cpu.set_irq_lines(0b11);
    machine.step();
    let sp = machine.sp();
    machine.cpu.set_irq_lines(0b10);
    machine.step();
    assert_eq!((machine.cpu.active_exception(), machine.sp()), (irq(1), sp));
    assert_eq!(machine.cpu.registers[14], 0xFFFF_FFF9);
    machine.cpu.set_irq_lines(0);
    machine.step();
    assert_eq!((machine.cpu.registers[0], machine.pc(), machine.sp()), (77, CODE, STACK));
}

#[test]
fn primask_holds_interrupts_but_not_nmi() {
    let mut machine = Machine::with(&[CPSID, NOP, NOP, CPSIE, NOP]);
    machine.enable(1);
    machine.step();
    machine.cpu.set_irq_lines(1);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), 0);
    machine.write(ICSR, NMIPENDSET);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), NMI);
    machine.step();
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), 0, "still masked before CPSIE has run");
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(0), "taken right behind CPSIE");
}

#[test]
fn clearing_primask_by_msr_lets_a_waiting_interrupt_in_at_once() {
    let [first, second] = msr(16, 0);
    let mut machine = Machine::with(&[CPSID, NOP, first, second, NOP]);
    machine.enable(1);
    machine.step();
    machine.cpu.set_irq_lines(1);
    machine.steps(3);
    assert_eq!(machine.cpu.active_exception(), irq(0));
}

#[test]
fn a_software_pended_hardware_interrupt_runs_once() {
    let mut machine = Machine::with(&[NOP; 4]);
    machine.enable(1 << 7);
    machine.write(ISPR, 1 << 7);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(7));
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), 0);
    assert_eq!(machine.pc(), CODE + 2);
}

#[test]
fn unpend_clears_every_interrupt_whose_line_is_low() {
    let mut machine = Machine::with(&[CPSID]);
    machine.step();
    machine.write(ISPR, u32::MAX);
    assert_eq!(machine.read(ISPR), u32::MAX);
    machine.write(ICPR, 0x0FFF_FFFE);
    assert_eq!(machine.read(ICPR), 0xF000_0001);
    machine.cpu.set_irq_lines(1 << 3);
    machine.write(ICPR, u32::MAX);
    assert_eq!(machine.read(ISPR), 1 << 3, "a level that is still high stays pending");
}

#[test]
fn pending_is_latched_when_the_source_goes_away() {
    let mut machine = Machine::with(&[CPSID, CPSIE, NOP]);
    machine.enable(1 << 2);
    machine.step();
    machine.cpu.set_irq_lines(1 << 2);
    machine.cpu.set_irq_lines(0);
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), irq(2));
}

#[test]
fn a_level_that_stays_high_is_taken_again_after_the_handler() {
    let mut machine = Machine::with(&[NOP; 2]);
    machine.enable(1);
    machine.cpu.set_irq_lines(1);
    machine.step();
    assert_eq!(machine.read(ISPR), 0, "active, not pending");
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(0), "tail-chained into itself");
    machine.cpu.set_irq_lines(0);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), 0);
}

#[test]
fn a_pulse_during_its_own_handler_is_taken_once_more() {
    let mut machine = Machine::with(&[NOP; 2]);
    machine.enable(1);
    for level in [1, 0] {
        machine.cpu.set_irq_lines(level);
    }
    machine.step();
    for level in [1, 0] {
        machine.cpu.set_irq_lines(level);
    }
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(0));
    machine.step();
    assert_eq!(machine.cpu.active_exception(), 0);
}

#[test]
fn a_disabled_interrupt_waits_for_its_enable() {
    let mut machine = Machine::with(&[NOP; 4]);
    machine.cpu.set_irq_lines(1 << 25);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), 0);
    machine.enable(1 << 25);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(25));
    machine.write(ICER, 1 << 25);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), 0, "masked at the source, as RTIC does on ARMv6-M");
    assert_eq!(machine.read(ISPR), 1 << 25);
}

#[test]
fn the_six_unwired_interrupts_serve_as_software_tasks() {
    for interrupt in 26..32 {
        let mut machine = Machine::with(&[NOP; 2]);
        machine.enable(1 << interrupt);
        machine.write(ISPR, 1 << interrupt);
        machine.step();
        assert_eq!(machine.cpu.active_exception(), irq(interrupt));
        assert_eq!(machine.pc(), handler(irq(interrupt)));
    }
}

#[test]
fn svc_is_taken_at_once_and_returns_behind_itself() {
    let mut machine = Machine::with(&[0xDF2A, NOP]);
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), SV_CALL);
    assert_eq!(machine.word(machine.sp() + 24), CODE + 2);
}

#[test]
fn svc_that_cannot_preempt_is_a_hard_fault() {
    let mut machine = Machine::with(&[CPSID, 0xDF00]);
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), HARD_FAULT);

    let mut machine = Machine::with(&[NOP]);
    machine.put_handler(irq(0), &[0xDF00]);
    machine.enable(1);
    machine.cpu.set_irq_lines(1);
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), HARD_FAULT, "both have priority 0");
}

#[test]
fn pendsv_waits_for_more_urgent_handlers() {
    let mut machine = Machine::with(&[NOP; 2]);
    machine.write(SHPR3, 3 << 22);
    machine.enable(1);
    machine.cpu.set_irq_lines(1);
    machine.step();
    machine.write(ICSR, PENDSVSET);
    assert_eq!(machine.cpu.active_exception(), irq(0));
    machine.cpu.set_irq_lines(0);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), PEND_SV);
}

#[test]
fn icsr_names_the_active_and_the_next_exception() {
    let mut machine = Machine::with(&[NOP; 2]);
    machine.enable(1 << 3 | 1 << 4);
    machine.prioritise(4, 1);
    machine.cpu.set_irq_lines(1 << 3 | 1 << 4);
    machine.step();
    assert_eq!(machine.read(ICSR), 1 << 22 | irq(4) << 12 | irq(3));
}

#[test]
fn the_vector_table_can_move() {
    let mut machine = Machine::with(&[NOP; 2]);
    let table = DATA & !0xFF;
    machine.put_word(table + 4 * irq(0), handler(20) | 1);
    machine.write(0xE000_ED08, table | 0x7F);
    assert_eq!(machine.cpu.vector_table(), table, "VTOR is aligned to 256 bytes");
    machine.enable(1);
    machine.cpu.set_irq_lines(1);
    machine.step();
    assert_eq!(machine.pc(), handler(20));
}

#[test]
fn handlers_see_their_number_and_return_by_pop() {
    let mut machine = Machine::with(&[NOP; 2]);
    let code = [&[0xB510][..], &mrs(4, 5), &[0xBD10]].concat();
    machine.put_handler(irq(6), &code);
    machine.enable(1 << 6);
    machine.cpu.set_irq_lines(1 << 6);
    machine.steps(3);
    assert_eq!(machine.cpu.registers[4], irq(6));
    machine.cpu.set_irq_lines(0);
    machine.step();
    assert_eq!((machine.cpu.active_exception(), machine.pc(), machine.sp()), (0, CODE, STACK));
}

#[test]
fn reset_forgets_everything_but_the_lines() {
    let mut machine = Machine::with(&[CPSID, NOP]);
    machine.step();
    machine.write(ISPR, 1 << 30);
    machine.cpu.set_irq_lines(1 << 8);
    machine.cpu.registers[4] = 9;
    machine.cpu.reset(&mut machine.memory, VECTORS).expect("the vector table is in RAM");
    assert_eq!((machine.pc(), machine.sp(), machine.cpu.registers[4]), (CODE, STACK, 0));
    assert!(!machine.cpu.interrupts_masked());
    assert_eq!(machine.read(ISPR), 1 << 8);
    machine.enable(1 << 8);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(8));
}
