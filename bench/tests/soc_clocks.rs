//! Clock tree, timer, watchdog and resets.

mod soc_support;

use bench::rp2040::{ResetCause, Stop};
use bench::time::Nanos;
use soc_support::*;

#[test]
fn the_chip_starts_on_the_ring_oscillator_and_follows_its_clock_registers() {
    let mut program = Program::new();
    program.sleep();
    let mut machine = boot(&program);
    assert_eq!(machine.clk_sys_hz(), 6_500_000);
    run(&mut machine, Nanos::from_millis(10));
    bring_up(&mut machine);
    assert_eq!((machine.clk_sys_hz(), machine.clk_peri_hz()), (125_000_000, 125_000_000));
    poke(&mut machine, CLOCKS + 0x3c, 0); // back to clk_ref, the crystal
    assert_eq!(machine.clk_sys_hz(), 12_000_000);
    assert_eq!(peek(&mut machine, CLOCKS + 0x44), 1, "SELECTED is one-hot");
    poke(&mut machine, CLOCKS + 0x40, 2 << 8);
    assert_eq!(machine.clk_sys_hz(), 6_000_000);
}

#[test]
fn time_does_not_jump_when_clk_sys_changes() {
    let mut machine = awake_chip();
    let before = machine.now();
    for _ in 0..10 {
        poke(&mut machine, CLOCKS + 0x3c, 0);
        poke(&mut machine, CLOCKS + 0x3c, 1);
    }
    assert_eq!(machine.now(), before);
    let deadline = before + Nanos::from_millis(7);
    machine.run_until(deadline).unwrap();
    assert!(machine.now().since(deadline) < Nanos(8), "{}", machine.now());
}

#[test]
fn switching_clk_sys_to_a_dead_source_stops_the_run() {
    let mut machine = awake_chip();
    poke(&mut machine, RESETS + SET, 1 << 12); // PLL_SYS into reset while clk_sys runs from it
    let stop = run_to_stop(&mut machine, Nanos::from_micros(10));
    assert!(matches!(&stop, Stop::Chip { what, .. } if what.contains("clk_sys")), "{stop}");
}

#[test]
fn the_crystal_is_stable_after_its_startup_delay() {
    let mut program = Program::new();
    program.sleep();
    let mut machine = boot(&program);
    run(&mut machine, Nanos::from_millis(10));
    poke(&mut machine, XOSC + 0xc, 47);
    poke(&mut machine, XOSC, 0xfab << 12 | 0xaa0);
    run(&mut machine, Nanos::from_micros(1000)); // 47 * 256 / 12 MHz = 1002.7 us
    assert_eq!(peek(&mut machine, XOSC + 4) >> 31, 0);
    run(&mut machine, Nanos::from_micros(3));
    assert_eq!(peek(&mut machine, XOSC + 4) >> 31, 1);
}

#[test]
fn the_frequency_counter_reads_clk_sys_in_khz() {
    let mut machine = awake_chip();
    poke(&mut machine, CLOCKS + 0x94, 9);
    assert_eq!(peek(&mut machine, CLOCKS + 0x98) & 0x10, 0x10, "DONE");
    assert_eq!(peek(&mut machine, CLOCKS + 0x9c) >> 5, 125_000);
}

#[test]
fn the_timer_counts_microseconds_of_the_watchdog_tick() {
    let mut machine = awake_chip();
    let before = peek(&mut machine, TIMER + 0x28);
    run(&mut machine, Nanos::from_micros(1234));
    assert_eq!(peek(&mut machine, TIMER + 0x28) - before, 1234);
    poke(&mut machine, WATCHDOG + 0x2c, 12); // tick off
    let stopped = peek(&mut machine, TIMER + 0x28);
    run(&mut machine, Nanos::from_micros(50));
    assert_eq!(peek(&mut machine, TIMER + 0x28), stopped);
}

#[test]
fn reading_timelr_latches_timehr() {
    let mut machine = awake_chip();
    poke(&mut machine, TIMER + 4, 0xffff_fffe);
    poke(&mut machine, TIMER, 7);
    assert_eq!(peek(&mut machine, TIMER + 0x0c), 0xffff_fffe);
    run(&mut machine, Nanos::from_micros(3));
    assert_eq!(peek(&mut machine, TIMER + 0x08), 7, "latched with the low word");
    assert_eq!(peek(&mut machine, TIMER + 0x24), 8, "raw");
}

#[test]
fn an_alarm_never_fires_early() {
    let mut machine = awake_chip();
    poke(&mut machine, TIMER + 0x38, 1);
    for delay in [1, 2, 99, 1000] {
        run(&mut machine, Nanos(371)); // somewhere inside a microsecond
        let target = peek(&mut machine, TIMER + 0x28) + delay;
        poke(&mut machine, TIMER + 0x10, target);
        for _ in 0..=delay * 20 {
            let fired = peek(&mut machine, TIMER + 0x34) & 1 != 0;
            let count = peek(&mut machine, TIMER + 0x28);
            assert_eq!(fired, count >= target, "count {count}, alarm at {target}");
            if fired {
                break;
            }
            run(&mut machine, Nanos(80));
        }
        assert_eq!(peek(&mut machine, TIMER + 0x20), 0, "disarmed");
        poke(&mut machine, TIMER + 0x34, 1);
    }
    assert_eq!(machine.stats().irqs[0], 4);
}

#[test]
fn an_alarm_wakes_a_sleeping_core_and_its_handler_runs() {
    let mut program = Program::new();
    program.poke(NVIC_ISER, 1);
    program.sleep();
    program.handler(16);
    program.poke(TIMER + 0x34, 1);
    program.load(0, TIMER);
    program.ldr(2, 0, 0x28);
    program.load(0, RAM);
    program.str(2, 0, 0);
    program.bx_lr();
    let mut machine = boot(&program);
    run(&mut machine, Nanos::from_millis(10));
    bring_up(&mut machine);
    poke(&mut machine, TIMER + 0x38, 1);
    let target = peek(&mut machine, TIMER + 0x28) + 250;
    poke(&mut machine, TIMER + 0x10, target);
    run(&mut machine, Nanos::from_micros(400));
    let seen = peek(&mut machine, RAM);
    assert!(
        (target..target + 5).contains(&seen),
        "handler ran at {seen}, alarm at {target}: entry plus XIP misses"
    );
}

#[test]
fn a_paused_timer_stands_still_and_its_alarms_wait() {
    let mut machine = awake_chip();
    let target = peek(&mut machine, TIMER + 0x28) + 10;
    poke(&mut machine, TIMER + 0x10, target);
    poke(&mut machine, TIMER + 0x30, 1);
    run(&mut machine, Nanos::from_micros(100));
    assert_eq!(peek(&mut machine, TIMER + 0x34), 0);
    poke(&mut machine, TIMER + 0x30, 0);
    run(&mut machine, Nanos::from_micros(12));
    assert_eq!(peek(&mut machine, TIMER + 0x34), 1);
}

#[test]
fn clearing_armed_disarms_and_intf_forces() {
    let mut machine = awake_chip();
    let soon = peek(&mut machine, TIMER + 0x28) + 5;
    poke(&mut machine, TIMER + 0x14, soon);
    poke(&mut machine, TIMER + 0x20, 2);
    run(&mut machine, Nanos::from_micros(20));
    assert_eq!(peek(&mut machine, TIMER + 0x34), 0);
    poke(&mut machine, TIMER + 0x3c, 8);
    assert_eq!(peek(&mut machine, TIMER + 0x40), 8);
}

#[test]
fn the_watchdog_decrements_twice_per_tick_and_its_reset_keeps_scratch_and_ram() {
    let mut machine = awake_chip();
    poke(&mut machine, PSM + 8, 0x1_fffc);
    poke(&mut machine, WATCHDOG + 0x0c, 0xcafe_0001);
    poke(&mut machine, RAM + 0x100, 0x0dd5_eed5);
    poke(&mut machine, WATCHDOG + 4, 20_000);
    poke(&mut machine, WATCHDOG, 1 << 30);
    let start = machine.now();
    run(&mut machine, Nanos::from_micros(9_000));
    assert_eq!(machine.stats().resets.len(), 1, "20,000 counts are 10 ms");
    poke(&mut machine, WATCHDOG + 4, 20_000); // feed
    let fed = machine.now();
    run(&mut machine, Nanos::from_micros(9_990));
    assert_eq!(machine.stats().resets.len(), 1);
    run(&mut machine, Nanos::from_millis(20));
    let resets = machine.stats().resets;
    assert_eq!(resets.len(), 2);
    assert_eq!(resets[1].1, ResetCause::WatchdogTimer);
    let after = resets[1].0.since(fed);
    assert!(
        after >= Nanos(9_999_000) && after < Nanos(10_002_000),
        "{after} after the last feed, began {start}"
    );
    assert_eq!(peek(&mut machine, WATCHDOG + 8), 1, "REASON: timer");
    assert_eq!(peek(&mut machine, WATCHDOG + 0x0c), 0xcafe_0001);
    assert_eq!(peek(&mut machine, RAM + 0x100), 0x0dd5_eed5);
    assert_eq!(machine.clk_sys_hz(), 6_500_000, "clocks were reset");
    assert_eq!(peek(&mut machine, RESETS) & 1 << 16, 1 << 16, "SPI0 is held again");
    assert!(machine.core().unwrap().is_sleeping(), "the firmware runs again");
}

#[test]
fn a_watchdog_trigger_resets_once_and_says_so() {
    let mut machine = awake_chip();
    poke(&mut machine, PSM + 8, 0x1_fffc);
    poke(&mut machine, WATCHDOG, 1 << 31);
    run(&mut machine, Nanos::from_millis(50));
    assert_eq!(machine.stats().resets.len(), 2);
    assert_eq!(machine.stats().resets[1].1, ResetCause::WatchdogForce);
    assert_eq!(peek(&mut machine, WATCHDOG + 8), 2, "REASON: force");
}

#[test]
fn a_held_block_ignores_writes_and_loses_its_state() {
    let mut machine = awake_chip();
    poke(&mut machine, TIMER + 0x38, 0xf);
    poke(&mut machine, RESETS + SET, 1 << 21);
    assert_eq!(peek(&mut machine, RESETS + 8) & 1 << 21, 0, "RESET_DONE");
    poke(&mut machine, TIMER + 0x38, 3);
    assert_eq!(peek(&mut machine, TIMER + 0x38), 0);
    poke(&mut machine, RESETS + CLR, 1 << 21);
    assert_eq!(peek(&mut machine, RESETS + 8) & 1 << 21, 1 << 21);
    assert_eq!(peek(&mut machine, TIMER + 0x38), 0);
    assert!(peek(&mut machine, TIMER + 0x28) < 2, "the counter starts again");
}

#[test]
fn atomic_aliases_set_clear_and_flip() {
    let mut machine = awake_chip();
    poke(&mut machine, TIMER + 0x38 + SET, 5);
    poke(&mut machine, TIMER + 0x38 + XOR, 6);
    assert_eq!(peek(&mut machine, TIMER + 0x38), 3);
    poke(&mut machine, TIMER + 0x38 + CLR, 1);
    assert_eq!(peek(&mut machine, TIMER + 0x38 + SET), 2, "reading an alias reads the register");
}
