//! Power-on to the first instruction of the firmware, resets, and the stand-in boot ROM's tables.

mod soc_support;

use bench::rp2040::bus::{Bus, Width};
use bench::rp2040::{ResetCause, Rp2040, Stop};
use bench::time::Nanos;
use soc_support::*;

#[test]
fn the_real_second_stage_boots_into_the_vector_table() {
    let mut program = Program::new();
    program.poke(RAM, 0x1234_5678);
    program.sleep();
    let mut machine = boot(&program);
    run(&mut machine, Nanos::from_millis(20));
    assert_eq!(machine.read_ram(RAM, 4), 0x1234_5678u32.to_le_bytes());
    assert!(machine.core().unwrap().is_sleeping());
    assert_eq!(machine.stats().resets, [(Nanos::ZERO, ResetCause::PowerOn)]);
}

#[test]
fn an_erased_flash_stops_loudly_instead_of_entering_usb_boot() {
    let mut machine = Rp2040::new(Vec::new(), Recorder::default());
    let stop = run_to_stop(&mut machine, Nanos::from_millis(20));
    assert!(matches!(&stop, Stop::Chip { what, .. } if what.contains("second stage")), "{stop}");
}

#[test]
fn a_second_stage_with_one_wrong_bit_does_not_boot() {
    let mut flash = image(&Program::new());
    flash[17] ^= 4;
    let mut machine = Rp2040::new(flash, Recorder::default());
    assert!(matches!(run_to_stop(&mut machine, Nanos::from_millis(20)), Stop::Chip { .. }));
}

#[test]
fn an_xip_miss_costs_28_sck_of_the_divisor_that_the_second_stage_sets() {
    // The blob sets BAUDR = 2: 28 * 2 cycles plus the engine's 4 between cache and SSI.
    let mut machine = awake_chip();
    poke(&mut machine, XIP_CTRL + 4, 1); // flush
    machine.take_extra_cycles();
    machine.load(0x1000_4000, Width::Word).unwrap();
    assert_eq!(machine.take_extra_cycles(), 28 * 2 + 4);
    machine.load(0x1000_4004, Width::Word).unwrap();
    assert_eq!(machine.take_extra_cycles(), 0, "the other half of the line is a hit");
    assert_eq!(peek(&mut machine, XIP_SSI + 0x14), 2);
}

#[test]
fn xip_counters_count_accesses_and_hits_and_clear_on_write() {
    let mut machine = awake_chip();
    poke(&mut machine, XIP_CTRL + 4, 1);
    poke(&mut machine, XIP_CTRL + 0x0c, 0);
    poke(&mut machine, XIP_CTRL + 0x10, 0);
    // Three lines of one set: the third evicts the first.
    for line in [0x1000_8000, 0x1000_a000, 0x1000_8000, 0x1000_c000, 0x1000_8000, 0x1000_a000] {
        machine.load(line, Width::Word).unwrap();
    }
    assert_eq!(peek(&mut machine, XIP_CTRL + 0x10), 6, "accesses");
    assert_eq!(peek(&mut machine, XIP_CTRL + 0x0c), 2, "hits: least recently used goes");
    poke(&mut machine, XIP_CTRL + 0x0c, 0);
    assert_eq!(peek(&mut machine, XIP_CTRL + 0x0c), 0);
}

#[test]
fn a_store_to_flash_changes_nothing_and_faults_outside_the_cached_window() {
    let mut machine = awake_chip();
    let before = machine.load(0x1000_0200, Width::Word).unwrap();
    machine.store(0x1000_0200, Width::Word, 0).unwrap();
    assert_eq!(machine.load(0x1000_0200, Width::Word).unwrap(), before);
    assert!(machine.store(0x1300_0200, Width::Word, 0).is_err(), "XIP_CTRL.ERR_BADWRITE resets to 1");
}

#[test]
fn unmapped_addresses_are_bus_errors() {
    let mut machine = awake_chip();
    for address in [0x0000_4000, 0x2004_2000, 0x3000_0000, 0x6000_0000, 0x4007_0000 + 0x0010_0000] {
        assert!(machine.load(address, Width::Word).is_err(), "{address:#x}");
        assert!(machine.store(address, Width::Word, 0).is_err(), "{address:#x}");
    }
    run(&mut machine, Nanos::from_micros(1));
}

#[test]
fn unstriped_sram_is_the_same_memory_bank_by_bank() {
    let mut machine = awake_chip();
    for (striped, word) in
        [(0u32, 0xaaaa_0000u32), (4, 0xaaaa_0001), (8, 0xaaaa_0002), (12, 0xaaaa_0003), (16, 0xaaaa_0010)]
    {
        poke(&mut machine, RAM + striped, word);
    }
    assert_eq!(peek(&mut machine, 0x2100_0000), 0xaaaa_0000);
    assert_eq!(peek(&mut machine, 0x2101_0000), 0xaaaa_0001);
    assert_eq!(peek(&mut machine, 0x2103_0000), 0xaaaa_0003);
    assert_eq!(peek(&mut machine, 0x2100_0004), 0xaaaa_0010, "bank 0's next word is four words on");
}

#[test]
fn peripheral_accesses_cost_what_their_bus_costs() {
    let mut machine = awake_chip();
    let mut cost = |address: u32, write: bool| {
        machine.take_extra_cycles();
        if write {
            machine.store(address, Width::Word, 0).unwrap();
        } else {
            machine.load(address, Width::Word).unwrap();
        }
        machine.take_extra_cycles()
    };
    assert_eq!(cost(RAM, false), 0);
    assert_eq!(cost(TIMER + 0x28, false), 2, "APB read: 3 on the bus");
    assert_eq!(cost(TIMER + 0x10, true), 3, "APB write: 4 on the bus");
    assert_eq!(cost(SIO + 0x04, false), -1, "SIO: single cycle");
    assert_eq!(cost(DMA + 0x400, false), 0);
}

#[test]
fn the_rom_tables_are_found_by_the_roms_own_lookup_routine() {
    let mut program = Program::new();
    // r0 = function table, r1 = 'P3'; call the lookup; then call what it found on 0xf0f0_0001.
    program.movs(4, 0x14);
    program.raw(0x8820); // ldrh r0, [r4, #0]
    program.load(1, u32::from(u16::from_le_bytes(*b"P3")));
    program.raw(0x88a2); // ldrh r2, [r4, #4]
    program.blx(2);
    program.raw(0x0003); // movs r3, r0
    program.load(0, 0xf0f0_0001);
    program.blx(3);
    program.load(1, RAM);
    program.str(0, 1, 0);
    program.sleep();
    let mut machine = boot(&program);
    run(&mut machine, Nanos::from_millis(20));
    assert_eq!(peek(&mut machine, RAM), 9);
    assert_eq!(machine.load(0x10, Width::Word).unwrap(), u32::from_le_bytes([b'M', b'u', 1, 2]));
}

#[test]
fn an_unmodelled_register_is_named_with_its_instruction() {
    for (address, name) in [
        (0x4004_4000 + 0x6c, "I2C0.IC_ENABLE"),
        (0x5020_0000, "PIO0.CTRL"),
        (0x5011_0040, "USBCTRL_REGS.MAIN_CTRL"),
        (0x4005_c00c, "RTC.CTRL"),
        (SIO + 0x80, "SIO.INTERP0_ACCUM0"),
        (SPI0 + 0x30, "SPI0 + 0x30"),
    ] {
        let mut program = Program::new();
        program.poke(RESETS, 0);
        program.load(0, address);
        let at = program.here();
        program.ldr(1, 0, 0);
        program.sleep();
        let mut machine = boot(&program);
        match run_to_stop(&mut machine, Nanos::from_millis(20)) {
            Stop::Unmodelled { register, pc, write: false, .. } => {
                assert_eq!(register, name);
                assert_eq!(pc, CODE + at);
            }
            stop => panic!("{stop}"),
        }
    }
}

/// Calls entry `index` of table `name` on `arguments` and returns r0 and r1.
fn rom_float(name: &[u8; 2], index: u32, arguments: [u32; 4]) -> (u32, u32) {
    let mut program = Program::new();
    program.movs(4, 0x14);
    program.raw(0x8860); // ldrh r0, [r4, #2]
    program.load(1, u32::from(u16::from_le_bytes(*name)));
    program.raw(0x88a2); // ldrh r2, [r4, #4]
    program.blx(2);
    program.load(5, 4 * index);
    program.raw(0x5946); // ldr r6, [r0, r5]
    for (register, value) in (0..).zip(arguments) {
        program.load(register, value);
    }
    program.blx(6);
    program.load(2, RAM);
    program.str(0, 2, 0);
    program.str(1, 2, 4);
    program.sleep();
    let mut machine = boot(&program);
    run(&mut machine, Nanos::from_millis(20));
    (peek(&mut machine, RAM), peek(&mut machine, RAM + 4))
}

fn pair(value: f64) -> [u32; 2] {
    let bits = value.to_bits();
    [(bits & 0xffff_ffff) as u32, (bits >> 32) as u32]
}

#[test]
fn rom_single_precision_is_ieee() {
    let binary =
        |index, a: f32, b: f32| f32::from_bits(rom_float(b"SF", index, [a.to_bits(), b.to_bits(), 0, 0]).0);
    assert_eq!(binary(0, 0.1, 0.2), 0.1 + 0.2);
    assert_eq!(binary(1, 1.0, 1e-8), 1.0);
    assert_eq!(binary(2, 1e30, 1e30), f32::INFINITY);
    assert_eq!(binary(3, 1.0, 3.0), 1.0 / 3.0);
    assert_eq!(binary(6, 2.0, 0.0), 2f32.sqrt());
}

#[test]
fn rom_conversions_round_towards_minus_infinity_and_clamp() {
    let to_int =
        |index, value: f32, n: u32| rom_float(b"SF", index, [value.to_bits(), n, 0, 0]).0.cast_signed();
    assert_eq!(to_int(7, -1.5, 0), -2);
    assert_eq!(to_int(7, 3e9, 0), i32::MAX);
    assert_eq!(to_int(8, 0.5, 16), 0x8000);
    assert_eq!(to_int(9, -5.0, 0), 0);
    assert_eq!(to_int(21, 1.0, 2f32.to_bits()), -1, "compare");
    assert_eq!(f32::from_bits(rom_float(b"SF", 12, [0x18000, 16, 0, 0]).0), 1.5);
    let [low, high] = pair(-1e10);
    let (low, high) = rom_float(b"SD", 27, [low, high, 0, 0]);
    assert_eq!((u64::from(high) << 32 | u64::from(low)).cast_signed(), -10_000_000_000);
}

#[test]
fn rom_double_precision_is_ieee() {
    let [a, b] = [pair(1.0), pair(3.0)];
    let (low, high) = rom_float(b"SD", 3, [a[0], a[1], b[0], b[1]]);
    assert_eq!([low, high], pair(1.0 / 3.0));
    let (low, _) = rom_float(b"SD", 31, [a[0], a[1], 0, 0]);
    assert_eq!(low, 1f32.to_bits(), "double to float");
}

#[test]
fn oscillator_and_regulator_report_that_they_run() {
    let mut machine = awake_chip();
    assert_eq!(peek(&mut machine, 0x4006_0018) & 1 << 31, 1 << 31, "ROSC is stable");
    assert_eq!(peek(&mut machine, 0x4006_4000), 0x10b1, "VREG: reset value and ROK");
    assert_eq!(peek(&mut machine, 0x4006_4008), 0x100, "HAD_POR");
    assert_eq!(peek(&mut machine, 0x4000_0000), 0x2000_2927, "chip id: B2");
}

#[test]
fn launching_core_1_stops_the_run() {
    let mut program = Program::new();
    program.poke(SIO + 0x54, 0);
    program.sleep();
    let mut machine = boot(&program);
    let stop = run_to_stop(&mut machine, Nanos::from_millis(20));
    assert!(matches!(&stop, Stop::Unmodelled { register, .. } if register.contains("core 1")), "{stop}");
}

#[test]
fn a_software_reset_restarts_the_core_and_leaves_the_peripherals() {
    let mut program = Program::new();
    program.poke(NVIC_ISER, 1);
    program.sleep();
    program.handler(16);
    program.poke(0xe000_ed0c, 0x05fa_0004);
    let wait = program.here();
    program.branch(wait);
    let mut machine = boot(&program);
    run(&mut machine, Nanos::from_millis(10));
    bring_up(&mut machine);
    poke(&mut machine, SPI0 + 0x10, 14);
    poke(&mut machine, TIMER + 0x38, 1);
    poke(&mut machine, TIMER + 0x3c, 1); // force the interrupt
    run(&mut machine, Nanos::from_millis(10));
    assert_eq!(machine.stats().resets.last().unwrap().1, ResetCause::Software);
    assert_eq!(machine.stats().resets.len(), 2, "once: the boot ROM resets TIMER");
    assert_eq!(peek(&mut machine, SPI0 + 0x10), 14);
    assert_eq!(machine.clk_sys_hz(), 125_000_000);
}

#[test]
fn two_runs_are_equal_to_the_cycle() {
    let history = || {
        let mut program = Program::new();
        program.poke(SIO + 0x24, 1 << 25);
        program.load(2, SIO + 0x1c);
        program.load(3, 1 << 25);
        let again = program.here();
        program.str(3, 2, 0);
        program.branch(again);
        let mut machine = boot(&program);
        poke(&mut machine, RESETS + CLR, 1 << 5);
        set_function(&mut machine, 25, 5);
        run(&mut machine, Nanos::from_millis(30));
        (machine.stats(), machine.board.calls)
    };
    let (first, second) = (history(), history());
    assert!(first.1.len() > 1000, "the pin toggles");
    assert_eq!(first, second);
}

#[test]
fn a_board_that_never_moves_on_stops_the_run() {
    #[derive(Default)]
    struct Stuck;
    impl bench::pins::Board for Stuck {
        fn pin_out(&mut self, _: Nanos, _: u8, _: bool, _: &mut bench::pins::InputPins) {}
        fn spi_frame(&mut self, _: Nanos, _: u8, _: u16, _: u8, _: &mut bench::pins::InputPins) -> u16 {
            0
        }
        fn uart_byte(&mut self, _: Nanos, _: u8, _: u8) {}
        fn pwm(&mut self, _: Nanos, _: u8, _: u32, _: u32) {}
        fn next_event(&self) -> Option<Nanos> {
            Some(Nanos::from_millis(1))
        }
        fn advance(&mut self, _: Nanos, _: &mut bench::pins::InputPins) {}
    }
    let mut program = Program::new();
    program.sleep();
    let mut machine = Rp2040::new(image(&program), Stuck);
    let stop = run_to_stop(&mut machine, Nanos::from_millis(20));
    assert!(matches!(&stop, Stop::Chip { what, .. } if what.contains("next_event")), "{stop}");
}
