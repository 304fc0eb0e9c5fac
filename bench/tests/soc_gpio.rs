//! GPIO: outputs, pads, levels and pin interrupts; PWM, ADC and the SIO divider.

mod soc_support;

use bench::time::Nanos;
use soc_support::*;

const GPIO_IN: u32 = SIO + 0x04;
const OUT_SET: u32 = SIO + 0x14;
const OUT_CLR: u32 = SIO + 0x18;
const OE_SET: u32 = SIO + 0x24;
const INTR0: u32 = IO_BANK0 + 0xf0;
const INTE0: u32 = IO_BANK0 + 0x100;
const INTS0: u32 = IO_BANK0 + 0x120;
const EDGE_LOW: u32 = 4;
const EDGE_HIGH: u32 = 8;

fn pad(pin: u32) -> u32 {
    PADS_BANK0 + 4 + 4 * pin
}

#[test]
fn an_output_is_reported_on_change_only_and_seen_in_gpio_in() {
    let mut machine = awake_chip();
    set_function(&mut machine, 17, 5);
    poke(&mut machine, OUT_SET, 1 << 17);
    assert!(machine.board.calls.is_empty(), "not driven yet");
    poke(&mut machine, OE_SET, 1 << 17);
    poke(&mut machine, OUT_SET, 1 << 17);
    run(&mut machine, Nanos::from_micros(5));
    assert_eq!(peek(&mut machine, GPIO_IN) >> 17 & 1, 1, "the pad reads its own output");
    poke(&mut machine, OUT_CLR, 1 << 17);
    let levels: Vec<bool> = pin_levels(&machine, 17).into_iter().map(|(_, level)| level).collect();
    assert_eq!(levels, [true, false]);
    assert_eq!(pin_levels(&machine, 17)[1].0, machine.now());
}

#[test]
fn a_pin_that_is_not_given_to_sio_is_not_driven_by_it() {
    let mut machine = awake_chip();
    poke(&mut machine, OE_SET, 1 << 17);
    poke(&mut machine, OUT_SET, 1 << 17);
    assert!(machine.board.calls.is_empty());
}

#[test]
fn pads_reset_to_input_enabled_with_pull_down() {
    let mut machine = awake_chip();
    assert_eq!(peek(&mut machine, pad(0)), 0x56);
    assert_eq!(peek(&mut machine, GPIO_IN), 0);
    poke(&mut machine, pad(3), 0x4a); // pull-up, input enabled
    assert_eq!(peek(&mut machine, GPIO_IN), 1 << 3);
    poke(&mut machine, pad(3), 0x0a); // input disabled
    assert_eq!(peek(&mut machine, GPIO_IN), 0);
}

#[test]
fn the_outside_beats_the_pull_and_letting_go_restores_it() {
    let at = Nanos::from_millis(14);
    let board = Recorder {
        script: vec![(at, 3, Some(false)), (at + Nanos::from_millis(1), 3, None)],
        ..Recorder::default()
    };
    let mut machine = awake_chip_with(board);
    poke(&mut machine, pad(3), 0x4a);
    assert!(machine.now() < at);
    assert_eq!(peek(&mut machine, GPIO_IN), 1 << 3);
    machine.run_until(at).unwrap();
    assert_eq!(peek(&mut machine, GPIO_IN), 0);
    machine.run_until(at + Nanos::from_millis(1)).unwrap();
    assert_eq!(peek(&mut machine, GPIO_IN), 1 << 3);
}

#[test]
fn edges_latch_until_written_and_levels_follow() {
    let at = Nanos::from_millis(14);
    let board = Recorder {
        script: vec![(at, 2, Some(true)), (at + Nanos(500), 2, Some(false))],
        ..Recorder::default()
    };
    let mut machine = awake_chip_with(board);
    poke(&mut machine, INTE0, (EDGE_HIGH | EDGE_LOW) << 8);
    machine.run_until(at + Nanos::from_micros(10)).unwrap();
    assert_eq!(
        peek(&mut machine, INTR0) >> 8 & 0xf,
        1 | EDGE_LOW | EDGE_HIGH,
        "level low, both edges latched"
    );
    assert_eq!(peek(&mut machine, INTS0), (EDGE_HIGH | EDGE_LOW) << 8);
    poke(&mut machine, INTR0, EDGE_HIGH << 8);
    assert_eq!(peek(&mut machine, INTS0), EDGE_LOW << 8);
    poke(&mut machine, INTR0, 0xf << 8);
    assert_eq!(peek(&mut machine, INTR0) >> 8 & 0xf, 1, "a level cannot be written away");
    assert_eq!(machine.stats().irqs[13], 1, "one rise of the line");
}

#[test]
fn driving_the_same_level_again_makes_no_edge() {
    let at = Nanos::from_millis(14);
    let board = Recorder {
        script: vec![(at, 2, Some(false)), (at + Nanos(500), 2, Some(false))],
        ..Recorder::default()
    };
    let mut machine = awake_chip_with(board);
    machine.run_until(at + Nanos::from_micros(10)).unwrap();
    assert_eq!(peek(&mut machine, INTR0) >> 8 & 0xf, 1);
}

#[test]
fn a_level_interrupt_runs_its_handler_with_primask_clear_and_wakes_wfi() {
    let mut program = Program::new();
    program.poke(NVIC_ISER, 1 << 13);
    program.sleep();
    program.handler(16 + 13);
    program.poke(INTE0, 0);
    program.poke(OUT_SET, 1 << 25);
    program.bx_lr();
    let at = Nanos::from_millis(15);
    let board = Recorder { script: vec![(at, 2, Some(true))], ..Recorder::default() };
    let mut machine = boot_with(&program, board);
    run(&mut machine, Nanos::from_millis(10));
    bring_up(&mut machine);
    set_function(&mut machine, 25, 5);
    poke(&mut machine, OE_SET, 1 << 25);
    poke(&mut machine, INTE0, 2 << 8);
    machine.run_until(at + Nanos::from_micros(20)).unwrap();
    let (rose, level) = *pin_levels(&machine, 25).last().unwrap();
    assert!(level);
    let latency = rose.since(at);
    assert!(latency > Nanos(15 * 8) && latency < Nanos::from_micros(10), "{latency}: entry plus misses");
}

#[test]
fn overrides_invert_and_force_a_pin() {
    let mut machine = awake_chip();
    poke(&mut machine, OE_SET, 1 << 6);
    set_function(&mut machine, 6, 5 | 1 << 8);
    assert!(pin_levels(&machine, 6).last().unwrap().1, "inverted");
    set_function(&mut machine, 6, 5 | 2 << 8);
    assert!(!pin_levels(&machine, 6).last().unwrap().1, "forced low");
}

#[test]
fn sio_fifo_status_shows_an_empty_ready_fifo() {
    let mut machine = awake_chip();
    assert_eq!(peek(&mut machine, SIO + 0x50), 2);
    assert_eq!(peek(&mut machine, SIO), 0, "CPUID of core 0");
}

#[test]
fn a_spinlock_is_claimed_by_reading_and_freed_by_writing() {
    let mut machine = awake_chip();
    let lock = SIO + 0x100 + 4 * 31;
    assert_eq!(peek(&mut machine, lock), 1 << 31);
    assert_eq!(peek(&mut machine, lock), 0, "taken");
    assert_eq!(peek(&mut machine, SIO + 0x5c), 1 << 31);
    poke(&mut machine, lock, 0);
    assert_eq!(peek(&mut machine, lock), 1 << 31);
}

#[test]
fn the_divider_needs_eight_cycles() {
    let mut machine = awake_chip();
    let mut divide = |dividend: u32, divisor: u32, signed: u32| {
        poke(&mut machine, SIO + 0x60 + 8 * signed, dividend);
        poke(&mut machine, SIO + 0x64 + 8 * signed, divisor);
        assert_eq!(peek(&mut machine, SIO + 0x78) & 1, 0, "not ready at once");
        run(&mut machine, Nanos(8 * 8));
        assert_eq!(peek(&mut machine, SIO + 0x78) & 1, 1);
        (peek(&mut machine, SIO + 0x70), peek(&mut machine, SIO + 0x74))
    };
    let minus = |value: i32| value.cast_unsigned();
    assert_eq!(divide(1_000_003, 1000, 0), (1000, 3));
    assert_eq!(divide(minus(-7), 2, 1), (minus(-3), minus(-1)));
    assert_eq!(divide(5, 0, 0), (u32::MAX, 5));
    assert_eq!(divide(minus(-5), 0, 1), (1, minus(-5)));
    assert_eq!(divide(5, 0, 1), (minus(-1), 5));
}

#[test]
fn pwm_is_reported_as_frequency_and_duty() {
    let mut machine = awake_chip();
    set_function(&mut machine, 15, 4); // slice 7, channel B
    let slice = PWM + 7 * 0x14;
    poke(&mut machine, slice + 4, 125 << 4);
    poke(&mut machine, slice + 0x10, 999);
    poke(&mut machine, slice + 0xc, 500 << 16);
    run(&mut machine, Nanos::from_millis(1));
    assert!(
        machine.board.calls.iter().all(|call| !matches!(call, Call::Pwm { frequency_hz: 1.., .. })),
        "still off"
    );
    poke(&mut machine, slice, 1);
    assert_eq!(peek(&mut machine, PWM + 0xa0), 1 << 7, "EN is an alias of CSR");
    let last = *machine.board.calls.last().unwrap();
    assert_eq!(last, Call::Pwm { at: machine.now(), pin: 15, frequency_hz: 1000, duty: 32_768 });
    run(&mut machine, Nanos::from_micros(250));
    assert_eq!(peek(&mut machine, slice + 8), 250, "counter");
    poke(&mut machine, PWM + 0xa0 + CLR, 1 << 7);
    assert_eq!(peek(&mut machine, slice) & 1, 0);
    assert!(matches!(machine.board.calls.last(), Some(Call::Pwm { frequency_hz: 0, .. })));
}

#[test]
fn writing_div_does_not_start_a_pwm_slice_and_en_aliases_leave_the_others_alone() {
    let mut machine = awake_chip();
    poke(&mut machine, PWM + 4, 4 << 4);
    run(&mut machine, Nanos::from_micros(10));
    assert_eq!(peek(&mut machine, PWM + 8), 0);
    poke(&mut machine, PWM + 0xa0 + SET, 1 << 2);
    poke(&mut machine, PWM + 0xa0 + SET, 1 << 5);
    poke(&mut machine, PWM + 0xa0 + CLR, 1 << 2);
    assert_eq!(peek(&mut machine, PWM + 0xa0), 1 << 5);
}

#[test]
fn a_pwm_wrap_raises_its_interrupt_each_period() {
    let mut machine = awake_chip();
    poke(&mut machine, PWM + 0x10, 12_499); // 100 us
    poke(&mut machine, PWM + 0xa8, 1);
    poke(&mut machine, PWM, 1);
    for _ in 0..3 {
        run(&mut machine, Nanos::from_micros(99));
        assert_eq!(peek(&mut machine, PWM + 0xa4), 0);
        run(&mut machine, Nanos::from_micros(1));
        assert_eq!(peek(&mut machine, PWM + 0xb0), 1);
        poke(&mut machine, PWM + 0xa4, 1);
    }
    assert_eq!(machine.stats().irqs[4], 3);
}

#[test]
fn an_adc_conversion_takes_two_microseconds() {
    let mut machine = awake_chip();
    machine.set_analog(1, 1650);
    poke(&mut machine, ADC, 1 | 1 << 12 | 4);
    assert_eq!(peek(&mut machine, ADC) & 0x100, 0, "busy");
    run(&mut machine, Nanos(1990));
    assert_eq!(peek(&mut machine, ADC) & 0x100, 0);
    run(&mut machine, Nanos(20));
    assert_eq!(peek(&mut machine, ADC) & 0x100, 0x100);
    assert_eq!(peek(&mut machine, ADC + 4), 2048);
}

#[test]
fn adc_round_robin_takes_its_channels_in_turn() {
    let mut machine = awake_chip();
    for (channel, millivolts) in [(0, 100), (1, 200), (2, 300), (3, 400)] {
        machine.set_analog(channel, millivolts);
    }
    poke(&mut machine, ADC + 8, 1); // FIFO
    poke(&mut machine, ADC, 1 | 8 | 0b1011 << 16); // channels 0, 1, 3, free running
    run(&mut machine, Nanos::from_micros(13));
    poke(&mut machine, ADC, 1);
    let millivolts: Vec<u32> =
        (0..6).map(|_| (peek(&mut machine, ADC + 0xc) * 3300).div_ceil(4096)).collect();
    assert_eq!(millivolts, [100, 200, 400, 100, 200, 400]);
}

#[test]
fn the_adc_fifo_interrupt_falls_when_the_fifo_is_read() {
    let mut machine = awake_chip();
    poke(&mut machine, ADC + 8, 1 | 3 << 24);
    poke(&mut machine, ADC + 0x18, 1);
    poke(&mut machine, ADC, 1 | 8);
    run(&mut machine, Nanos(6_100));
    poke(&mut machine, ADC, 1);
    assert_eq!(peek(&mut machine, ADC + 0x20), 1, "three samples");
    peek(&mut machine, ADC + 0xc);
    assert_eq!(peek(&mut machine, ADC + 0x20), 0);
    assert_eq!(peek(&mut machine, ADC + 8) >> 16 & 0xf, 2);
}

#[test]
fn a_full_adc_fifo_says_so_and_loses_samples() {
    let mut machine = awake_chip();
    poke(&mut machine, ADC + 8, 1);
    poke(&mut machine, ADC, 1 | 8);
    run(&mut machine, Nanos::from_micros(30));
    let status = peek(&mut machine, ADC + 8);
    assert_eq!(status >> 16 & 0xf, 8);
    assert_eq!(status & 1 << 11, 1 << 11, "OVER");
}

#[test]
fn a_watchdog_reset_silences_pwm() {
    let mut machine = awake_chip();
    set_function(&mut machine, 15, 4);
    poke(&mut machine, PWM + 7 * 0x14 + 0xc, 500 << 16);
    poke(&mut machine, PWM + 7 * 0x14, 1);
    assert!(matches!(machine.board.calls.last(), Some(Call::Pwm { frequency_hz: 1.., .. })));
    poke(&mut machine, PSM + 8, 0x1_fffc);
    poke(&mut machine, WATCHDOG, 1 << 31);
    run(&mut machine, Nanos::from_millis(1));
    assert!(matches!(machine.board.calls.last(), Some(Call::Pwm { pin: 15, frequency_hz: 0, duty: 0, .. })));
}

#[test]
fn a_fractional_pwm_divisor_does_not_drift() {
    let mut machine = awake_chip();
    poke(&mut machine, PWM + 4, 1 << 4 | 9); // 1 9/16: wraps fall between cycles
    poke(&mut machine, PWM + 0x10, 99);
    poke(&mut machine, PWM + 0xa8, 1);
    poke(&mut machine, PWM, 1);
    let mut wraps = 0;
    let begin = machine.now();
    while machine.now().since(begin) < Nanos::from_micros(1250) {
        run(&mut machine, Nanos(400));
        wraps += peek(&mut machine, PWM + 0xa4) & 1;
        poke(&mut machine, PWM + 0xa4, 1);
    }
    assert_eq!(wraps, 1000, "156,250 cycles of 156.25 each");
}
