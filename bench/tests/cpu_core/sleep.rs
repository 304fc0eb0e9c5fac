//! WFI, WFE, SEV and sleep-on-exit: ARMv6-M ARM, B1.5.17 to B1.5.19.

use crate::assembler::{CPSID, CPSIE, NOP, bx};
use crate::machine::{CODE, Machine, SCR, SYS_TICK, irq};

const WFI: u16 = 0xBF30;
const WFE: u16 = 0xBF20;
const SEV: u16 = 0xBF40;
const SLEEPONEXIT: u32 = 1 << 1;
const SEVONPEND: u32 = 1 << 4;

#[test]
fn wfi_sleeps_until_an_interrupt_and_then_runs_its_handler() {
    let mut machine = Machine::with(&[WFI, NOP]);
    machine.enable(1);
    machine.step();
    assert!(machine.cpu.is_sleeping());
    assert_eq!(machine.steps(5), 0, "asleep nothing happens and nothing is charged");
    assert_eq!(machine.pc(), CODE + 2);
    machine.cpu.set_irq_lines(1);
    assert!(!machine.cpu.is_sleeping(), "awake before the next step");
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(0));
}

#[test]
fn wfi_with_primask_and_a_pending_interrupt_does_not_sleep() {
    let mut machine = Machine::with(&[CPSID, WFI, NOP, CPSIE]);
    machine.enable(1);
    machine.step();
    machine.cpu.set_irq_lines(1);
    machine.step();
    assert!(!machine.cpu.is_sleeping());
    machine.steps(2);
    assert_eq!(machine.pc(), CODE + 8);
}

#[test]
fn an_interrupt_during_wfi_under_primask_wakes_without_entering_its_handler() {
    let mut machine = Machine::with(&[CPSID, WFI, NOP, CPSIE, NOP]);
    machine.enable(1);
    machine.steps(2);
    assert!(machine.cpu.is_sleeping());
    machine.cpu.set_irq_lines(1);
    assert!(!machine.cpu.is_sleeping());
    machine.step();
    assert_eq!((machine.cpu.active_exception(), machine.pc()), (0, CODE + 6));
    machine.steps(2);
    assert_eq!(machine.cpu.active_exception(), irq(0), "after CPSIE");
}

#[test]
fn a_disabled_interrupt_does_not_end_wfi() {
    let mut machine = Machine::with(&[WFI, NOP]);
    machine.step();
    machine.cpu.set_irq_lines(1);
    assert!(machine.cpu.is_sleeping());
}

#[test]
fn wfi_in_a_handler_wakes_only_for_more_urgent_interrupts() {
    let mut machine = Machine::with(&[NOP]);
    machine.put_handler(irq(0), &[WFI, bx(14)]);
    machine.enable(0b111);
    machine.prioritise(0, 2);
    machine.prioritise(1, 2);
    machine.prioritise(2, 1);
    machine.cpu.set_irq_lines(0b001);
    machine.steps(2);
    machine.cpu.set_irq_lines(0b011);
    assert!(machine.cpu.is_sleeping());
    machine.cpu.set_irq_lines(0b111);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(2));
}

#[test]
fn systick_ends_wfi() {
    let mut machine = Machine::with(&[WFI, NOP]);
    machine.write(0xE000_E014, 99);
    machine.write(0xE000_E010, 0b111);
    machine.step();
    machine.cpu.advance_systick(99);
    assert!(machine.cpu.is_sleeping());
    machine.cpu.advance_systick(1);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), SYS_TICK);
}

#[test]
fn sev_arms_the_next_wfe_and_only_that() {
    let mut machine = Machine::with(&[SEV, WFE, WFE]);
    machine.steps(2);
    assert!(!machine.cpu.is_sleeping());
    machine.step();
    assert!(machine.cpu.is_sleeping());
    assert_eq!((machine.steps(3), machine.pc()), (0, CODE + 6), "asleep nothing happens");
}

#[test]
fn entering_a_handler_is_an_event() {
    let mut machine = Machine::with(&[NOP]);
    machine.put_handler(irq(0), &[WFE, WFE]);
    machine.enable(1);
    machine.cpu.set_irq_lines(1);
    machine.steps(2);
    assert!(!machine.cpu.is_sleeping());
    machine.step();
    assert!(machine.cpu.is_sleeping());
}

#[test]
fn returning_from_a_handler_is_an_event() {
    let mut machine = Machine::with(&[NOP, WFE, WFE]);
    // The handler consumes the event of its own entry.
    machine.put_handler(irq(0), &[WFE, bx(14)]);
    machine.enable(1);
    machine.cpu.set_irq_lines(1);
    machine.step();
    machine.cpu.set_irq_lines(0);
    machine.steps(4);
    assert!(!machine.cpu.is_sleeping());
    machine.step();
    assert!(machine.cpu.is_sleeping());
}

#[test]
fn a_masked_interrupt_ends_wfe_only_with_sevonpend_and_only_once() {
    for enabled in [0, 1] {
        for (scr, wakes) in [(0, false), (SEVONPEND, true)] {
            let mut machine = Machine::with(&[CPSID, WFE, WFE]);
            machine.enable(enabled);
            machine.write(SCR, scr);
            machine.steps(2);
            assert!(machine.cpu.is_sleeping());
            machine.cpu.set_irq_lines(1);
            assert_eq!(!machine.cpu.is_sleeping(), wakes, "scr {scr:#x}, enabled {enabled}");
            machine.step();
            assert!(machine.cpu.is_sleeping(), "the event was used up");
            assert_eq!(machine.cpu.active_exception(), 0);
        }
    }
}

#[test]
fn a_masked_systick_ends_wfe_with_sevonpend() {
    let mut machine = Machine::with(&[CPSID, WFE]);
    machine.write(SCR, SEVONPEND);
    machine.write(0xE000_E014, 9);
    machine.write(0xE000_E010, 0b111);
    machine.steps(2);
    machine.cpu.advance_systick(10);
    assert!(!machine.cpu.is_sleeping());
}

#[test]
fn an_interrupt_that_can_be_taken_ends_wfe() {
    let mut machine = Machine::with(&[WFE, NOP]);
    machine.enable(1);
    machine.step();
    machine.cpu.set_irq_lines(1);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(0));
}

#[test]
fn sleep_on_exit_returns_into_sleep() {
    let mut machine = Machine::with(&[NOP; 4]);
    machine.write(SCR, SLEEPONEXIT);
    machine.enable(1);
    machine.cpu.set_irq_lines(1);
    machine.step();
    machine.cpu.set_irq_lines(0);
    machine.step();
    assert!(machine.cpu.is_sleeping());
    assert_eq!(machine.cpu.active_exception(), 0);
    machine.cpu.set_irq_lines(1);
    machine.step();
    assert_eq!(machine.cpu.active_exception(), irq(0));
}
