//! What a watch says of handlers that are known to the instruction.

mod soc_support;

use bench::rp2040::Watched;
use bench::time::Nanos;
use soc_support::*;

const NVIC_ISPR: u32 = 0xe000_e200;
/// Priorities of interrupts 24 to 27.
const NVIC_IPR6: u32 = 0xe000_e418;
/// SW0_IRQ gives way to SW1_IRQ.
const PRIORITIES: u32 = 0x40c0_0000;
const SW0: u32 = 1 << 26;
const SW1: u32 = 1 << 27;
const CPSID: u16 = 0xb672;
const CPSIE: u16 = 0xb662;

/// A thread that enables both interrupts and pends `first`, then masks interrupts for 50 instructions, then sleeps.
fn thread(first: u32) -> Program {
    let mut program = Program::new();
    program.poke(RAM, 3);
    program.poke(NVIC_IPR6, PRIORITIES);
    program.poke(NVIC_ISER, SW0 | SW1);
    program.poke(NVIC_ISPR, first);
    program.raw(CPSID);
    for _ in 0..50 {
        program.nop();
    }
    program.raw(CPSIE);
    let sleep = program.here();
    program.wfi();
    program.branch(sleep);
    program
}

/// SW0_IRQ pends SW1_IRQ, which preempts it.
fn nested() -> Program {
    let mut program = thread(SW0);
    program.handler(16 + 26);
    program.push_lr();
    program.poke(NVIC_ISPR, SW1);
    for _ in 0..100 {
        program.nop();
    }
    program.pop_pc();
    program.handler(16 + 27);
    for _ in 0..200 {
        program.nop();
    }
    program.bx_lr();
    program
}

fn watched(program: &Program) -> Watched {
    let mut machine = boot(program);
    assert_eq!(machine.watch(), None);
    run(&mut machine, Nanos::from_millis(20));
    machine.watch().unwrap()
}

#[test]
fn a_handler_that_is_preempted_takes_its_own_time_and_that_of_the_other() {
    let seen = watched(&nested());
    let (low, high) = (seen.handler("SW0_IRQ").unwrap().1, seen.handler("SW1_IRQ").unwrap().1);
    assert_eq!((low.runs, high.runs), (1, 1));
    assert_eq!(high.own, high.whole);
    // 200 instructions, entry and return at the 6.5 MHz of the ring oscillator, and what their fetches wait for.
    assert!(high.own > Nanos(200 * 153), "{}", high.own);
    assert!(low.own > Nanos(100 * 153) && low.own < high.own, "{}", low.own);
    assert_eq!(low.whole, low.own + high.own);
    assert_eq!(
        seen.ran().map(|(irq, name, _)| (irq, name)).collect::<Vec<_>>(),
        [(26, "SW0_IRQ"), (27, "SW1_IRQ")]
    );
}

#[test]
fn the_lowest_stack_is_that_of_the_nested_handler() {
    // Two frames of eight words and one LR, and a word that aligns the second.
    assert_eq!(watched(&nested()).lowest_stack, STACK_TOP - 32 - 4 - 4 - 32);
}

#[test]
fn the_masked_time_is_that_of_the_section() {
    let seen = watched(&nested());
    // 50 instructions of one cycle, and 60 for each of the 14 lines that their fetches bring into the cache.
    assert!(seen.masked > Nanos(50 * 153) && seen.masked < Nanos(900 * 154), "{}", seen.masked);
    assert!(seen.first.is_some_and(|first| first < Nanos::from_millis(20)));
}

#[test]
fn a_handler_that_follows_itself_has_run_more_than_once() {
    let mut program = thread(SW1);
    let again = program.here();
    program.poke(NVIC_ISPR, SW1);
    program.bx_lr();
    program.handler(16 + 27);
    program.load(0, RAM);
    program.ldr(1, 0, 0);
    program.subs(1, 1);
    program.str(1, 0, 0);
    program.branch_not_equal(again);
    program.bx_lr();
    let (_, handler) = watched(&program).handler("SW1_IRQ").unwrap();
    assert_eq!(handler.runs, 3);
    assert_eq!(handler.own, handler.whole);
}

#[test]
fn a_watched_run_is_equal_to_one_that_is_not() {
    let (mut with, mut without) = (boot(&nested()), boot(&nested()));
    with.watch();
    for machine in [&mut with, &mut without] {
        run(machine, Nanos::from_millis(20));
    }
    assert_eq!(with.stats(), without.stats());
    assert_eq!(with.now(), without.now());
}

#[test]
fn a_second_watch_begins_anew() {
    let mut machine = boot(&nested());
    machine.watch();
    run(&mut machine, Nanos::from_millis(20));
    machine.watch();
    run(&mut machine, Nanos::from_millis(20));
    assert_eq!(machine.watch().unwrap().ran().count(), 0, "it sleeps");
}
