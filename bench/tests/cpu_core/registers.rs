//! SysTick, SCB and MPU as software sees them: ARMv6-M ARM, B3.2 to B3.5.

use bench::rp2040::cpu::Stop;

use crate::assembler::{CPSID, NOP};
use crate::machine::{CODE, ICSR, Machine, SCR, SHPR3};

const SYST_CSR: u32 = 0xE000_E010;
const SYST_RVR: u32 = 0xE000_E014;
const SYST_CVR: u32 = 0xE000_E018;
const AIRCR: u32 = 0xE000_ED0C;
const COUNTFLAG: u32 = 1 << 16;
const PENDSTSET: u32 = 1 << 26;
const ENABLE_PROCESSOR_CLOCK: u32 = 0b101;
const WITH_INTERRUPT: u32 = 0b111;

/// Counting, with interrupts masked so that a pending SysTick stays to be seen in ICSR.
fn with_systick(reload: u32, control: u32) -> Machine {
    let mut machine = Machine::with(&[CPSID]);
    machine.step();
    machine.write(SYST_RVR, reload);
    machine.write(SYST_CVR, 0);
    machine.write(SYST_CSR, control);
    machine
}

#[test]
fn writing_cvr_clears_the_counter_without_setting_countflag() {
    let mut machine = with_systick(1000, ENABLE_PROCESSOR_CLOCK);
    machine.cpu.advance_systick(400);
    assert_eq!(machine.read(SYST_CVR), 601);
    machine.write(SYST_CVR, 123);
    assert_eq!(machine.read(SYST_CVR), 0);
    assert_eq!(machine.read(SYST_CSR) & COUNTFLAG, 0, "a delay would end at once");
    machine.cpu.advance_systick(1);
    assert_eq!(machine.read(SYST_CVR), 1000, "reloaded by the next clock");
    assert_eq!(machine.read(SYST_CSR) & COUNTFLAG, 0);
}

#[test]
fn countflag_comes_after_reload_plus_one_cycles_and_reading_clears_it() {
    let mut machine = with_systick(1000, ENABLE_PROCESSOR_CLOCK);
    machine.cpu.advance_systick(1000);
    assert_eq!(machine.read(SYST_CSR) & COUNTFLAG, 0);
    machine.cpu.advance_systick(1);
    assert_eq!(machine.read(SYST_CSR) & COUNTFLAG, COUNTFLAG);
    assert_eq!(machine.read(SYST_CSR) & COUNTFLAG, 0);
    machine.cpu.advance_systick(1001);
    assert_eq!(machine.read(SYST_CSR) & COUNTFLAG, COUNTFLAG, "the period is reload + 1");
}

#[test]
fn skipping_cycles_counts_like_single_cycles() {
    for reload in [0, 1, 2, 7, 1000] {
        for skip in [0u64, 1, 2, 3, 7, 8, 9, 15, 1000, 1001, 1002, 5000] {
            let mut single = with_systick(reload, WITH_INTERRUPT);
            let mut skipping = with_systick(reload, WITH_INTERRUPT);
            for round in 0..3 {
                (0..skip).for_each(|_| single.cpu.advance_systick(1));
                skipping.cpu.advance_systick(skip);
                let [single, skipping] = [&mut single, &mut skipping]
                    .map(|machine| [SYST_CVR, SYST_CSR, ICSR].map(|register| machine.read(register)));
                assert_eq!(single, skipping, "reload {reload}, {skip} cycles, round {round}");
            }
        }
    }
}

#[test]
fn the_forecast_is_the_cycle_of_the_exception() {
    for (reload, spent) in [(99, 0), (99, 1), (99, 40), (99, 100), (99, 250), (1, 0), (0x00FF_FFFF, 5)] {
        let mut machine = with_systick(reload, ENABLE_PROCESSOR_CLOCK);
        machine.cpu.advance_systick(spent);
        assert_eq!(machine.cpu.cycles_to_systick(), None, "no interrupt was asked for");
        machine.write(SYST_CSR, WITH_INTERRUPT);
        let forecast = machine.cpu.cycles_to_systick().expect("it is enabled");
        machine.cpu.advance_systick(forecast - 1);
        assert_eq!(machine.read(ICSR) & PENDSTSET, 0, "reload {reload} after {spent}");
        machine.cpu.advance_systick(1);
        assert_eq!(machine.read(ICSR) & PENDSTSET, PENDSTSET, "reload {reload} after {spent}");
    }
}

#[test]
fn icsr_pends_and_unpends_systick_and_pendsv_apart() {
    const PENDSVSET: u32 = 1 << 28;
    const PENDSVCLR: u32 = 1 << 27;
    const PENDSTCLR: u32 = 1 << 25;
    let mut machine = with_systick(0, 0);
    let steps = [
        (PENDSTSET | PENDSVSET, PENDSTSET | PENDSVSET),
        (PENDSTCLR, PENDSVSET),
        (PENDSTSET, PENDSTSET | PENDSVSET),
        (PENDSVCLR, PENDSTSET),
        (0, PENDSTSET),
        (PENDSTCLR | PENDSVCLR, 0),
    ];
    for (written, expected) in steps {
        machine.write(ICSR, written);
        assert_eq!(machine.read(ICSR) & (PENDSTSET | PENDSVSET), expected, "after writing {written:#x}");
    }
}

#[test]
fn a_counter_without_reload_never_fires() {
    let mut machine = with_systick(0, WITH_INTERRUPT);
    assert_eq!(machine.cpu.cycles_to_systick(), None);
    machine.cpu.advance_systick(1_000_000);
    assert_eq!(machine.read(ICSR) & PENDSTSET, 0);
}

#[test]
fn the_reference_clock_is_refused_loudly() {
    let mut machine = Machine::with(&[0x6001]);
    machine.cpu.registers[..2].copy_from_slice(&[SYST_CSR, 0b011]);
    assert_eq!(machine.stop(), Stop::Unmodelled { pc: CODE, address: SYST_CSR });
}

#[test]
fn a_reset_request_needs_the_key() {
    let mut machine = Machine::with(&[NOP]);
    machine.write(AIRCR, 1 << 2);
    assert!(!machine.cpu.take_reset_request());
    machine.write(AIRCR, 0x05FA << 16 | 1 << 2);
    assert!(machine.cpu.take_reset_request());
    assert!(!machine.cpu.take_reset_request(), "a request is given once");
}

#[test]
fn identification_registers_are_those_of_the_rp2040() {
    let mut machine = Machine::with(&[NOP]);
    for (register, value) in [
        (0xE000_ED00, 0x410C_C601),
        (0xE000_ED14, 0x0000_0208),
        (0xE000_ED90, 0x0000_0800),
        (0xE000_E01C, 0),
        (0xE000_EDF0, 0),
    ] {
        assert_eq!(machine.read(register), value, "{register:#010x}");
    }
}

#[test]
fn scr_keeps_its_three_bits() {
    let mut machine = Machine::with(&[NOP]);
    machine.write(SCR, u32::MAX);
    assert_eq!(machine.read(SCR), 0b1_0110, "SEVONPEND, SLEEPDEEP, SLEEPONEXIT");
}

#[test]
fn priorities_keep_two_bits() {
    let mut machine = Machine::with(&[NOP]);
    for register in (0xE000_E400..0xE000_E420).step_by(4) {
        machine.write(register, 0xFF7F_BF3F);
        assert_eq!(machine.read(register), 0xC040_8000);
    }
    machine.write(0xE000_ED1C, u32::MAX);
    machine.write(SHPR3, u32::MAX);
    assert_eq!(machine.read(0xE000_ED1C), 0xC000_0000);
    assert_eq!(machine.read(SHPR3), 0xC0C0_0000);
}

#[test]
fn mpu_regions_are_storage() {
    let mut machine = Machine::with(&[NOP]);
    for region in 0..8 {
        // VALID selects the region.
        machine.write(0xE000_ED9C, 0x2000_0000 | region << 8 | 1 << 4 | region);
        machine.write(0xE000_EDA0, 0x0300_0001 | region << 8);
    }
    for region in 0..8 {
        machine.write(0xE000_ED98, region);
        assert_eq!(machine.read(0xE000_ED9C), 0x2000_0000 | region << 8 | region);
        assert_eq!(machine.read(0xE000_EDA0), 0x0300_0001 | region << 8);
    }
}
