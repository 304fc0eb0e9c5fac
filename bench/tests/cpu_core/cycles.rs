//! The Cortex-M0+ TRM's table 3-1, instruction by instruction.

use bench::rp2040::cpu::{ENTRY_CYCLES, RETURN_CYCLES, TAIL_CHAIN_CYCLES};

use crate::assembler::{SEMIHOSTING, bl, branch, mrs, msr};
use crate::machine::{CODE, DATA, Machine, STACK, irq};

/// Runs one instruction with r0 = a landing place, r1 = data, and the given flags.
fn cycles(code: &[u16], apsr: u32) -> u32 {
    let [first, second] = msr(0, 7);
    let mut machine = Machine::with(&[&[first, second], code].concat());
    machine.memory.serves_breakpoints = true;
    machine.cpu.registers[..2].copy_from_slice(&[(CODE + 0x100) | 1, DATA]);
    machine.cpu.registers[7] = apsr;
    for word in 0..16 {
        machine.put_word(STACK + 4 * word, (CODE + 0x200) | 1);
    }
    machine.step();
    machine.step()
}

#[test]
fn every_instruction_costs_what_the_trm_says() {
    let rows: [(&str, &[u16], u32); 44] = [
        ("movs r2, #1", &[0x2201], 1),
        ("mov r8, r0", &[0x4680], 1),
        ("mov pc, r0", &[0x4687], 2),
        ("adds r2, r0, r1", &[0x1842], 1),
        ("add r2, r8", &[0x4442], 1),
        ("add pc, r3", &[0x449F], 2),
        ("add sp, #4", &[0xB001], 1),
        ("adr r2, +4", &[0xA201], 1),
        ("muls r2, r1", &[0x434A], 1),
        ("cmp r1, r2", &[0x4291], 1),
        ("lsls r2, r1, #3", &[0x00CA], 1),
        ("rors r2, r1", &[0x41CA], 1),
        ("ldr r2, [r1]", &[0x680A], 2),
        ("ldrb r2, [r1, r3]", &[0x5CCA], 2),
        ("ldrsh r2, [r1, r3]", &[0x5ECA], 2),
        ("ldr r2, [pc, #8]", &[0x4A02], 2),
        ("ldr r2, [sp, #4]", &[0x9A01], 2),
        ("str r2, [r1]", &[0x600A], 2),
        ("strh r2, [r1]", &[0x800A], 2),
        ("str r2, [sp, #4]", &[0x9201], 2),
        ("ldm r1!, {r2}", &[0xC904], 2),
        ("ldm r1!, {r2-r6}", &[0xC97C], 6),
        ("stm r1!, {r2-r4}", &[0xC11C], 4),
        ("push {r2}", &[0xB404], 2),
        ("push {r4-r7, lr}", &[0xB5F0], 6),
        ("push {lr}", &[0xB500], 2),
        ("pop {r2, r3}", &[0xBC0C], 3),
        ("pop {pc}", &[0xBD00], 4),
        ("pop {r4-r7, pc}", &[0xBDF0], 8),
        ("bne, taken", &[0xD110], 2),
        ("beq, not taken", &[0xD010], 1),
        ("b", &[branch(0x40)], 2),
        ("bl", &bl(0x40), 3),
        ("bx r0", &[0x4700], 2),
        ("blx r0", &[0x4780], 2),
        ("sxtb r2, r1", &[0xB24A], 1),
        ("rev r2, r1", &[0xBA0A], 1),
        ("cpsid i", &[0xB672], 1),
        ("mrs r2, apsr", &mrs(2, 0), 3),
        ("msr primask, r3", &msr(16, 3), 3),
        ("dsb", &[0xF3BF, 0x8F4F], 3),
        ("isb", &[0xF3BF, 0x8F6F], 3),
        ("nop", &[0xBF00], 1),
        ("sev", &[0xBF40], 1),
    ];
    for (name, code, expected) in rows {
        assert_eq!(cycles(code, 0), expected, "{name}");
    }
    assert_eq!(cycles(&[0xBF30], 0), 2, "wfi");
    assert_eq!(cycles(&[0xBF20], 0), 2, "wfe");
    assert_eq!(cycles(&[SEMIHOSTING], 0), 1, "a served bkpt; its service is charged by the bus");
}

#[test]
fn an_interrupt_is_entered_in_15_cycles() {
    let mut machine = Machine::with(&[0xBF00; 8]);
    machine.enable(1 << 5);
    machine.cpu.set_irq_lines(1 << 5);
    assert_eq!(machine.step(), ENTRY_CYCLES);
    assert_eq!(ENTRY_CYCLES, 15);
    assert_eq!(machine.cpu.active_exception(), irq(5));
}

#[test]
fn returns_and_tail_chains_cost_cycles() {
    let mut machine = Machine::with(&[0xBF00; 8]);
    machine.enable(0b11);
    machine.cpu.set_irq_lines(0b11);
    machine.step();
    machine.cpu.set_irq_lines(0b10);
    assert_eq!(machine.step(), 2 + TAIL_CHAIN_CYCLES, "bx lr into the next handler");
    assert_eq!(machine.cpu.active_exception(), irq(1));
    machine.cpu.set_irq_lines(0);
    assert_eq!(machine.step(), 2 + RETURN_CYCLES, "bx lr to the thread");
    assert_eq!(machine.pc(), CODE);
    // ARM publishes neither figure; a change of the model is to be seen here.
    assert_eq!((2 + RETURN_CYCLES, 2 + TAIL_CHAIN_CYCLES), (13, 12));
}
