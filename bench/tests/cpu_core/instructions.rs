//! Arithmetic against wider arithmetic, and what the oracle leaves out.

use bench::rp2040::cpu::{FaultCause, Stop};

use crate::assembler::{bl, mrs, msr};
use crate::machine::{CODE, DATA, HARD_FAULT, Machine, NOWHERE, STACK};

const N: u32 = 1 << 31;
const Z: u32 = 1 << 30;
const C: u32 = 1 << 29;
const V: u32 = 1 << 28;
const FLAGS: u32 = N | Z | C | V;

/// Edges first, then SplitMix64.
fn operands(count: usize) -> Vec<u32> {
    let mut state = 0x00C0_FFEEu64;
    let mut words = vec![0, 1, 2, 0x7FFF_FFFF, 0x8000_0000, 0x8000_0001, u32::MAX, 0xFFFF_FFFE];
    while words.len() < count {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (state ^ state >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        words.push((mixed >> 29) as u32);
    }
    words
}

/// Runs `opcode` on r0 = `a`, r1 = `b`; returns r0 and the flags.
fn run(machine: &mut Machine, opcode: u16, a: u32, b: u32, flags: u32) -> (u32, u32) {
    let [first, second] = msr(0, 2);
    machine.put_code(CODE, &[first, second, opcode]);
    machine.cpu.registers[..3].copy_from_slice(&[a, b, flags]);
    machine.cpu.registers[15] = CODE;
    machine.steps(2);
    (machine.cpu.registers[0], machine.cpu.xpsr() & FLAGS)
}

fn nz(result: u32) -> u32 {
    result & N | if result == 0 { Z } else { 0 }
}

#[test]
fn adcs_and_sbcs_agree_with_64_bit_arithmetic() {
    let mut machine = Machine::with(&[]);
    let words = operands(120);
    for &a in &words {
        for &b in &words {
            for carry in [0u32, 1] {
                for (opcode, b_added) in [(0x4148, b), (0x4188, !b)] {
                    let unsigned = u64::from(a) + u64::from(b_added) + u64::from(carry);
                    let signed =
                        i64::from(a.cast_signed()) + i64::from(b_added.cast_signed()) + i64::from(carry);
                    let result = unsigned as u32;
                    let overflow = i64::from(result.cast_signed()) != signed;
                    let flags =
                        nz(result) | if unsigned >> 32 != 0 { C } else { 0 } | if overflow { V } else { 0 };
                    let seen = run(&mut machine, opcode, a, b, carry << 29);
                    assert_eq!(seen, (result, flags), "{opcode:#06x} {a:#x} {b:#x} carry {carry}");
                }
            }
        }
    }
}

/// One bit at a time, which is what a shift by any count means.
fn shift_slowly(opcode: u16, mut value: u32, count: u32, mut carry: bool) -> (u32, bool) {
    for _ in 0..count & 0xFF {
        let (out, next) = match opcode {
            0x4088 => (value >> 31, value << 1),
            0x40C8 => (value & 1, value >> 1),
            0x4108 => (value & 1, value >> 1 | value & N),
            _ => (value & 1, value.rotate_right(1)),
        };
        carry = out != 0;
        value = next;
    }
    (value, carry)
}

#[test]
fn shifts_by_register_agree_with_shifting_bit_by_bit() {
    let mut machine = Machine::with(&[]);
    for opcode in [0x4088, 0x40C8, 0x4108, 0x41C8] {
        for value in operands(24) {
            for count in (0..=66).chain([127, 128, 255, 256, 257, 0x8000_0020]) {
                for flags in [0, C, V, C | V] {
                    let (result, carry) = shift_slowly(opcode, value, count, flags & C != 0);
                    let expected = (result, nz(result) | if carry { C } else { 0 } | flags & V);
                    let seen = run(&mut machine, opcode, value, count, flags);
                    assert_eq!(seen, expected, "{opcode:#06x} {value:#x} by {count}, flags {flags:#x}");
                }
            }
        }
    }
}

#[test]
fn compiled_64_bit_comparison_near_the_limits_is_right() {
    // i64 "a < b": subs low, sbcs high, then LT.
    let mut machine = Machine::with(&[]);
    for a in [i64::MAX, i64::MIN, 0, -1, 1, i64::MAX - 1, 1 << 32] {
        for b in [i64::MAX, i64::MIN, 0, -1, 1, i64::MIN + 1, 1 << 31] {
            // subs r0, r0, r2; sbcs r1, r3; blt +2 (to the second of the next two)
            machine.put_code(CODE, &[0x1A80, 0x4199, 0xDB00]);
            let (a_words, b_words) = (a.cast_unsigned(), b.cast_unsigned());
            machine.cpu.registers[..4].copy_from_slice(&[
                a_words as u32,
                (a_words >> 32) as u32,
                b_words as u32,
                (b_words >> 32) as u32,
            ]);
            machine.cpu.registers[15] = CODE;
            machine.steps(3);
            let taken = machine.pc() == CODE + 8;
            assert_eq!(taken, a < b, "{a} < {b}");
        }
    }
}

#[test]
fn bl_reaches_16_mib_both_ways_and_links_behind_itself() {
    for shift in 2..24 {
        for offset in [4 + (1 << shift), 4 - (1 << shift), 4 + (1 << shift) + 2, 4 - (1 << shift) - 2] {
            let mut machine = Machine::with(&bl(offset));
            machine.step();
            assert_eq!(machine.pc(), CODE.wrapping_add_signed(offset), "offset {offset}");
            assert_eq!(machine.cpu.registers[14], (CODE + 4) | 1);
        }
    }
}

#[test]
fn thumb2_encodings_that_armv6m_lacks_are_undefined() {
    // cbz, cbnz, setend, it, hlt, movw, and a 32-bit load.
    for opcode in [0xB100, 0xB910, 0xB650, 0xBF08, 0xBA80, 0xF240, 0xF8D0] {
        let mut machine = Machine::with(&[opcode, 0x0000]);
        machine.step();
        assert_eq!(machine.cpu.active_exception(), HARD_FAULT, "{opcode:#06x}");
        let fault = machine.cpu.take_fault().expect("a fault was noted");
        assert_eq!((fault.pc, fault.cause), (CODE, FaultCause::Undefined { opcode }));
    }
}

#[test]
fn a_fault_in_the_middle_of_a_list_leaves_the_base_alone() {
    let last_words = crate::machine::RAM + 0x1_0000 - 8;
    // ldm r1!, {r0-r3}; stm r4!, {r0-r3}; push and pop of four registers.
    for (opcode, base) in [(0xC90Fu16, 1usize), (0xC40F, 4), (0xBC0F, 13)] {
        let mut machine = Machine::with(&[opcode]);
        let handler_stack = machine.sp();
        machine.cpu.registers[base] = last_words;
        machine.put_handler(HARD_FAULT, &[0xBF00]);
        machine.step();
        assert_eq!(machine.cpu.active_exception(), HARD_FAULT);
        let expected = if base == 13 { last_words - 32 } else { last_words };
        assert_eq!(machine.cpu.registers[base], expected, "{opcode:#06x}");
        if base != 13 {
            assert_eq!(machine.sp(), handler_stack - 32);
        }
    }
}

#[test]
fn an_empty_register_list_stops_loudly() {
    for opcode in [0xB400, 0xBC00, 0xC000, 0xC800] {
        let mut machine = Machine::with(&[opcode]);
        let stop = Stop::Unpredictable { pc: CODE, opcode };
        assert_eq!(machine.stop(), stop);
        assert_eq!(machine.cpu.step(&mut machine.memory), Err(stop), "and stays stopped");
    }
}

#[test]
fn special_registers_move_through_neither_sp_nor_pc() {
    for code in [mrs(13, 0), mrs(15, 0), msr(0, 13), msr(0, 15), mrs(0, 4), msr(17, 0)] {
        let mut machine = Machine::with(&code);
        assert_eq!(machine.stop(), Stop::Unpredictable { pc: CODE, opcode: code[0] }, "{code:04x?}");
    }
}

#[test]
fn code_is_never_fetched_from_the_peripherals() {
    for target in [0x4000_0001, 0x5000_0001, 0xD000_0001, 0xE000_E001, 0xFFFF_FFF9u32] {
        let mut machine = Machine::with(&[0x4708]);
        machine.cpu.registers[1] = target;
        machine.steps(2);
        let fault = machine.cpu.take_fault().expect("a fault was noted");
        assert_eq!(fault.cause, FaultCause::Fetch { address: target & !1 });
        assert_eq!(machine.word(machine.sp() + 24), target & !1, "the stacked return address");
    }
}

#[test]
fn a_bus_that_refuses_is_a_hard_fault_with_the_address_in_the_report() {
    let causes = [
        (0x6800u16, NOWHERE, FaultCause::Load { address: NOWHERE }),
        (0x6000, NOWHERE, FaultCause::Store { address: NOWHERE }),
        (0x6800, DATA + 2, FaultCause::Unaligned { address: DATA + 2 }),
        (0x8000, DATA + 1, FaultCause::Unaligned { address: DATA + 1 }),
    ];
    for (opcode, address, cause) in causes {
        let mut machine = Machine::with(&[0xBF00, opcode]);
        machine.cpu.registers[0] = address;
        machine.steps(2);
        let fault = machine.cpu.take_fault().expect("a fault was noted");
        assert_eq!((fault.pc, fault.cause), (CODE + 2, cause));
        assert_eq!(machine.cpu.take_fault(), None, "a report is given once");
        assert_eq!(machine.sp(), STACK - 32);
    }
}
