//! Erase and program through the stand-in boot ROM, and what happens to those who touch the flash meanwhile.

mod soc_support;

use bench::flash::{Cells, Work};
use bench::rp2040::{FlashTimes, Rp2040, Stop};
use bench::time::Nanos;
use soc_support::*;

const SECTOR: u32 = 0x0010_0000;

/// r7 = address of the ROM function `code`.
fn find(program: &mut Program, code: &[u8; 2]) {
    program.movs(4, 0x14);
    program.raw(0x8820); // ldrh r0, [r4, #0]
    program.load(1, u32::from(u16::from_le_bytes(*code)));
    program.raw(0x88a2); // ldrh r2, [r4, #4]
    program.blx(2);
}

/// Keeps r0 in RAM at `slot`.
fn keep(program: &mut Program, slot: u32) {
    program.load(1, slot);
    program.str(0, 1, 0);
}

/// A program in flash that finds the ROM's functions, then runs `ram` (assembled apart) from RAM at 0x2000_1000.
fn run_from_ram(ram: &Program) -> Program {
    let mut program = Program::new();
    for (i, code) in [b"IF", b"EX", b"RE", b"RP", b"FC", b"CX"].into_iter().enumerate() {
        find(&mut program, code);
        keep(&mut program, RAM + 0x800 + 4 * i as u32);
    }
    for (i, word) in ram.bytes().chunks(4).enumerate() {
        let mut bytes = [0; 4];
        bytes[..word.len()].copy_from_slice(word);
        program.poke(RAM + 0x1000 + 4 * i as u32, u32::from_le_bytes(bytes));
    }
    program.load(0, RAM + 0x1001);
    program.blx(0);
    program.sleep();
    program
}

/// Calls the function kept in slot `index`, in RAM code; arguments are in r0 to r3.
fn call(program: &mut Program, index: u32) {
    program.load(6, RAM + 0x800 + 4 * index);
    program.ldr(6, 6, 0);
    program.blx(6);
}

fn enter(program: &mut Program) {
    program.push_lr();
    call(program, 0);
    call(program, 1);
}

fn leave(program: &mut Program) {
    call(program, 4);
    call(program, 5);
    program.pop_pc();
}

fn erase_sector() -> Program {
    let mut ram = Program::new();
    enter(&mut ram);
    ram.load(0, SECTOR);
    ram.load(1, 4096);
    ram.movs(2, 0);
    ram.movs(3, 0);
    call(&mut ram, 2);
    leave(&mut ram);
    ram
}

fn program_page(source: u32) -> Program {
    let mut ram = Program::new();
    enter(&mut ram);
    ram.load(0, SECTOR);
    ram.load(1, source);
    ram.load(2, 256);
    call(&mut ram, 3);
    leave(&mut ram);
    ram
}

fn machine_with(program: &Program, sector: u8) -> Machine {
    let mut flash = image(program);
    flash.resize(SECTOR as usize, 0xff);
    flash.resize(SECTOR as usize + 4096, sector);
    flash.push(0x77);
    Rp2040::new(flash, Recorder::default())
}

#[test]
fn erasing_a_sector_takes_45_ms_of_virtual_time_and_leaves_ff() {
    let mut machine = machine_with(&run_from_ram(&erase_sector()), 0x12);
    run(&mut machine, Nanos::from_millis(40));
    assert!(!machine.core().unwrap().is_sleeping(), "still erasing");
    assert_eq!(machine.flash()[SECTOR as usize], 0x12);
    run(&mut machine, Nanos::from_millis(20));
    assert!(machine.core().unwrap().is_sleeping());
    let start = SECTOR as usize;
    assert!(machine.flash()[start..start + 4096].iter().all(|byte| *byte == 0xff));
    assert_eq!(machine.flash()[start + 4096], 0x77, "the next sector is as it was");
}

#[test]
fn programming_only_clears_bits() {
    let ram = program_page(RAM + 0x2000);
    let mut machine = machine_with(&run_from_ram(&ram), 0x3c);
    for i in 0..64 {
        poke(&mut machine, RAM + 0x2000 + 4 * i, 0xf0f0_f0f0);
    }
    run(&mut machine, Nanos::from_millis(40));
    assert!(machine.core().unwrap().is_sleeping());
    let page = &machine.flash()[SECTOR as usize..SECTOR as usize + 257];
    assert!(page[..256].iter().all(|byte| *byte == 0x30));
    assert_eq!(page[256], 0x3c, "the next page is as it was");
}

#[test]
fn programming_from_a_source_in_flash_is_an_error() {
    let mut machine = machine_with(&run_from_ram(&program_page(0x1000_8000)), 0xff);
    let stop = run_to_stop(&mut machine, Nanos::from_millis(40));
    assert!(matches!(stop, Stop::FlashUnmapped { address: 0x1000_8000, .. }), "{stop}");
}

#[test]
fn erasing_without_leaving_xip_is_an_error() {
    let mut ram = Program::new();
    ram.push_lr();
    ram.load(0, SECTOR);
    ram.load(1, 4096);
    call(&mut ram, 2);
    ram.pop_pc();
    let mut machine = machine_with(&run_from_ram(&ram), 0xff);
    let stop = run_to_stop(&mut machine, Nanos::from_millis(40));
    assert!(matches!(&stop, Stop::Chip { what, .. } if what.contains("flash_exit_xip")), "{stop}");
}

#[test]
fn an_interrupt_handler_in_flash_during_an_erase_is_an_error() {
    let at = Nanos::from_millis(30);
    let mut program = Program::new();
    program.poke(RESETS + CLR, 1 << 5 | 1 << 8);
    program.poke(IO_BANK0 + 0x100, 2 << 8); // GPIO 2, level high
    program.poke(NVIC_ISER, 1 << 13);
    let offset = program.here();
    let body = run_from_ram(&erase_sector());
    program.append(&body);
    program.handler(16 + 13);
    let handler = program.here();
    program.bx_lr();
    assert!(offset > 0);
    let mut flash = image(&program);
    flash.resize(SECTOR as usize + 8192, 0);
    let board = Recorder { script: vec![(at, 2, Some(true))], ..Recorder::default() };
    let mut machine = Rp2040::new(flash, board);
    let deadline = Nanos::from_millis(100);
    match machine.run_until(deadline).expect_err("the handler is in flash") {
        Stop::FlashUnmapped { address, at: when, .. } => {
            // The vector table is in flash too, and is read first.
            assert!(address == CODE + handler || address == 0x1000_0100 + 4 * 29, "{address:#x}");
            assert!(when >= at && when < at + Nanos::from_micros(100), "{when}: in the middle of the erase");
        }
        stop => panic!("{stop}"),
    }
}

#[test]
fn the_world_goes_on_during_an_erase() {
    let mut program = Program::new();
    program.poke(SIO + 0x24, 0);
    program.append(&run_from_ram(&erase_sector()));
    let mut flash = image(&program);
    flash.resize(SECTOR as usize + 8192, 0);
    let script = (0..40).map(|i| (Nanos::from_millis(10 + i), 2, Some(i % 2 == 0))).collect();
    let mut machine = Rp2040::new(flash, Recorder { script, ..Recorder::default() });
    machine.run_until(Nanos::from_millis(45)).unwrap();
    assert!(!machine.core().unwrap().is_sleeping(), "still erasing");
    assert_eq!(machine.board.played, 36);
}

#[test]
fn a_power_cut_in_the_middle_of_an_erase_leaves_neither_old_nor_new() {
    let mut machine = machine_with(&run_from_ram(&erase_sector()), 0x12);
    run(&mut machine, Nanos::from_millis(40));
    let (mut cells, _) = machine.power_cut();
    assert!(cells.weak_bits() > 0);
    let (flash, again) = (cells.read_out(), cells.read_out());
    let sector = SECTOR as usize..SECTOR as usize + 4096;
    assert_ne!(flash[sector.clone()], again[sector.clone()], "half erased cells read differently each time");
    let sector = &flash[sector];
    assert!(sector.iter().any(|byte| *byte != 0x12) && sector.iter().any(|byte| *byte != 0xff));
    assert_eq!(flash[SECTOR as usize + 4096], 0x77);
    assert_eq!(cells.erases()[(SECTOR / 4096) as usize], 1, "wear counts");
}

#[test]
fn an_erase_takes_as_long_as_the_slowest_chip_if_that_is_soldered_on() {
    let mut machine = machine_with(&run_from_ram(&erase_sector()), 0x12);
    machine.set_flash_times(FlashTimes::WORST);
    run(&mut machine, Nanos::from_millis(390));
    assert!(machine.is_writing_flash() && !machine.core().unwrap().is_sleeping(), "still erasing");
    run(&mut machine, Nanos::from_millis(30));
    assert!(!machine.is_writing_flash() && machine.core().unwrap().is_sleeping());
}

#[test]
fn a_chip_that_is_switched_off_and_on_has_its_flash_and_nothing_else() {
    let mut machine = machine_with(&run_from_ram(&erase_sector()), 0x12);
    run(&mut machine, Nanos::from_millis(40));
    poke(&mut machine, RAM + 0x3000, 0x1234_5678);
    machine.power_off();
    let off_at = machine.now();
    run(&mut machine, Nanos::from_millis(100));
    assert!(machine.now() >= off_at + Nanos::from_millis(100), "time goes on without it");
    assert!(machine.cells().weak_bits() > 0, "the erase has not gone on");
    machine.power_on();
    assert_ne!(peek(&mut machine, RAM + 0x3000), 0x1234_5678);
    run(&mut machine, Nanos::from_millis(100));
    assert!(machine.core().unwrap().is_sleeping(), "the same image has run again");
    assert!(machine.flash()[SECTOR as usize..][..4096].iter().all(|byte| *byte == 0xff));
    assert_eq!((machine.cells().weak_bits(), machine.stats().resets.len()), (0, 2));
}

#[test]
fn the_flash_of_one_machine_goes_on_in_the_next() {
    let mut cells = Cells::new(vec![0xff; bench::rp2040::xip::FLASH_BYTES]);
    let code = image(&run_from_ram(&erase_sector()));
    cells.finish(&Work::Program { offset: 0, data: code });
    let mut machine = Rp2040::with_cells(cells, Recorder::default());
    run(&mut machine, Nanos::from_millis(100));
    assert_eq!(machine.power_cut().0.erases()[(SECTOR / 4096) as usize], 1);
}

#[test]
fn an_erase_by_command_takes_its_time_and_can_be_suspended() {
    let mut machine = awake_chip();
    flash_command(&mut machine, &[0xff; 4]);
    flash_command(&mut machine, &[0x06]);
    flash_command(&mut machine, &[0x20, 0x10, 0, 0]);
    assert_eq!(flash_command(&mut machine, &[0x05, 0])[1] & 1, 1, "busy");
    run(&mut machine, Nanos::from_millis(20));
    flash_command(&mut machine, &[0x75]);
    run(&mut machine, Nanos::from_micros(20));
    assert_eq!(flash_command(&mut machine, &[0x05, 0])[1] & 1, 0, "suspended: may be read");
    assert_eq!(flash_command(&mut machine, &[0x35, 0])[1] & 0x80, 0x80);
    run(&mut machine, Nanos::from_millis(100));
    assert!(machine.is_writing_flash(), "it waits");
    flash_command(&mut machine, &[0x7a]);
    run(&mut machine, Nanos::from_millis(20));
    assert_eq!(flash_command(&mut machine, &[0x05, 0])[1] & 1, 1, "20 ms of 45 are done, and 20 more");
    run(&mut machine, Nanos::from_millis(10));
    assert_eq!(flash_command(&mut machine, &[0x05, 0])[1] & 1, 0);
    assert_eq!(machine.cells().erases()[0x100], 1);
}

#[test]
fn stale_cache_lines_survive_programming_until_they_are_flushed() {
    // Read the page, program it, map the flash again without flush_cache, read: the cache answers with what it had.
    let mut ram = Program::new();
    ram.push_lr();
    ram.load(0, 0x1000_0000 + SECTOR);
    ram.ldr(1, 0, 0);
    call(&mut ram, 1);
    ram.load(0, SECTOR);
    ram.load(1, RAM + 0x2000);
    ram.load(2, 256);
    call(&mut ram, 3);
    ram.poke(IO_QSPI + 0x0c, 0); // chip select automatic again
    call(&mut ram, 5);
    ram.load(0, 0x1000_0000 + SECTOR);
    ram.ldr(2, 0, 0); // hit: stale
    ram.load(3, RAM);
    ram.str(2, 3, 0);
    call(&mut ram, 4);
    call(&mut ram, 5);
    ram.load(0, 0x1000_0000 + SECTOR);
    ram.ldr(2, 0, 0);
    ram.load(3, RAM);
    ram.str(2, 3, 4);
    ram.pop_pc();
    let mut machine = machine_with(&run_from_ram(&ram), 0xff);
    for i in 0..64 {
        poke(&mut machine, RAM + 0x2000 + 4 * i, 0x1111_1111);
    }
    run(&mut machine, Nanos::from_millis(40));
    assert_eq!((peek(&mut machine, RAM), peek(&mut machine, RAM + 4)), (0xffff_ffff, 0x1111_1111));
}

/// One flash command as the SDK sends it from RAM: SSI in serial mode, chip select held through IO_QSPI.
fn flash_command(machine: &mut Machine, bytes: &[u32]) -> Vec<u32> {
    assert!(machine.core().unwrap().is_sleeping(), "the core fetches nothing while the flash is unmapped");
    poke(machine, XIP_SSI + 8, 0);
    poke(machine, XIP_SSI, 7 << 16);
    poke(machine, XIP_SSI + 0x14, 6);
    poke(machine, XIP_SSI + 0x10, 1);
    poke(machine, XIP_SSI + 8, 1);
    poke(machine, IO_QSPI + 0x0c, 2 << 8);
    let mut answers = Vec::new();
    for byte in bytes {
        poke(machine, XIP_SSI + 0x60, *byte);
        assert_eq!(peek(machine, XIP_SSI + 0x28) & 8, 0, "nothing received yet");
        run(machine, Nanos::from_micros(10));
        answers.push(peek(machine, XIP_SSI + 0x60));
    }
    poke(machine, IO_QSPI + 0x0c, 3 << 8);
    answers
}

#[test]
fn jedec_and_unique_id_come_through_the_ssi() {
    let mut machine = awake_chip();
    // The chip is still in continuous read mode: all ones end it, the answer means nothing.
    flash_command(&mut machine, &[0xff; 4]);
    assert_eq!(flash_command(&mut machine, &[0x9f, 0, 0, 0])[1..], [0xef, 0x40, 0x15]);
    let id = flash_command(&mut machine, &[0x4b, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
    assert!(id[5..].iter().any(|byte| *byte != 0xff && *byte != 0));
}

#[test]
fn a_flash_without_quad_enable_gets_it_from_the_second_stage() {
    let mut machine = awake_chip();
    flash_command(&mut machine, &[0xff; 4]);
    assert_eq!(flash_command(&mut machine, &[0x35, 0])[1], 2, "quad enable is set");
    flash_command(&mut machine, &[0x01, 0, 0]);
    assert_eq!(flash_command(&mut machine, &[0x35, 0])[1], 2, "no write without write enable");
    flash_command(&mut machine, &[0x06]);
    flash_command(&mut machine, &[0x01, 0, 0]);
    assert_eq!(flash_command(&mut machine, &[0x05, 0])[1] & 1, 1, "busy");
    run(&mut machine, Nanos::from_millis(20));
    assert_eq!(flash_command(&mut machine, &[0x05, 0])[1] & 1, 0);
    assert_eq!(flash_command(&mut machine, &[0x35, 0])[1], 0);
    poke(&mut machine, PSM + 8, 0x1_fffc);
    poke(&mut machine, WATCHDOG, 1 << 31);
    run(&mut machine, Nanos::from_millis(30));
    assert!(machine.core().unwrap().is_sleeping(), "booted again");
    poke(&mut machine, RESETS + CLR, 1 << 6);
    flash_command(&mut machine, &[0xff; 4]);
    assert_eq!(flash_command(&mut machine, &[0x35, 0])[1], 2);
}

#[test]
fn a_power_cut_in_the_middle_of_a_program_leaves_whole_pages_and_one_torn_one() {
    let mut ram = Program::new();
    enter(&mut ram);
    ram.load(0, SECTOR);
    ram.load(1, RAM + 0x4000);
    ram.load(2, 16 * 256);
    call(&mut ram, 3);
    leave(&mut ram);
    let mut machine = machine_with(&run_from_ram(&ram), 0xff);
    for i in 0..1024 {
        poke(&mut machine, RAM + 0x4000 + 4 * i, 0);
    }
    // 16 pages take 6.4 ms; find a moment in the middle.
    let deadline = machine.now() + Nanos::from_millis(60);
    let started = machine.run_while(deadline, |machine| !machine.is_writing_flash()).unwrap();
    assert!(started);
    run(&mut machine, Nanos::from_micros(3_400));
    let (mut cells, _) = machine.power_cut();
    let flash = cells.read_out();
    let pages: Vec<u32> = flash[SECTOR as usize..SECTOR as usize + 4096]
        .chunks(256)
        .map(|page| page.iter().map(|byte| byte.count_ones()).sum())
        .collect();
    assert_eq!(pages[..8], [0; 8], "written");
    assert!(pages[8] > 0 && pages[8] < 2048, "torn: {pages:?}");
    assert_eq!(pages[9..], [2048; 7], "untouched");
}
