//! The oracle's program: a harness that runs short snippets and writes what they did.
//!
//! Each case is eight halfwords with the registers and flags to start from. The harness copies them into the middle of
//! a field of landing pads, runs them, stores registers, flags, stack pointers and a window of memory, and appends
//! that record to a file by semihosting. The same image runs on QEMU's `microbit` and on our core.

use super::assembler::*;
use super::cases::{Case, Numbers};

pub(crate) const FLASH_BYTES: usize = 256 * 1024;
pub(crate) const RAM_BASE: u32 = 0x2000_0000;
pub(crate) const RAM_BYTES: usize = 16 * 1024;

/// File that the program writes its records to.
pub(crate) const RESULT_FILE: &str = "results.bin";

/// Halfwords of a snippet.
pub(crate) const SNIPPET: usize = 8;
/// Words of a record: registers, then the window.
pub(crate) const RECORD_WORDS: usize = STATE_NAMES.len() + WINDOW_WORDS;
/// The registers of a record, in order.
pub(crate) const STATE_NAMES: [&str; 18] = [
    "r0", "r1", "r2", "r3", "r4", "r5", "r6", "r7", "xPSR", "r8", "r9", "r12", "lr", "sp", "CONTROL", "MSP",
    "PSP", "PRIMASK",
];

pub(crate) const WINDOW_WORDS: usize = 32;
/// Memory that cases read and write, filled anew for each.
pub(crate) const WINDOW: u32 = RAM_BASE + 0x600;
/// Default stack pointer of a case: an exception frame falls into the window.
pub(crate) const CASE_STACK: u32 = WINDOW + 96;
/// Where the snippet lies.
pub(crate) const STUB: u32 = RAM_BASE + 0x1400;
/// Stores the record; every landing pad leads here.
pub(crate) const TAIL: u32 = STUB + 2056;
/// First words of the window that hold addresses of landing pads, with bit 0 set.
pub(crate) const WINDOW_PADS: usize = 16;

const VARIABLES: u32 = RAM_BASE;
const RECORD: u32 = RAM_BASE + 0x80;
const PATTERN: u32 = RAM_BASE + 0x180;
const HEAD_END: u32 = STUB - 2048;
/// Pads beyond this distance use r11 only, which no case changes.
const PLAIN_PADS: u32 = STUB + 1056;

const VECTORS: usize = 48;
const CODE: u32 = 4 * VECTORS as u32;
const CASES: u32 = 0x400;
const CASE_BYTES: usize = 72;
/// Cases that fit in one image.
pub(crate) const CASES_PER_IMAGE: usize = (FLASH_BYTES - CASES as usize) / CASE_BYTES;

const SYS_OPEN: u16 = 0x01;
const SYS_WRITE: u16 = 0x05;
const SYS_EXIT: u16 = 0x18;
const OPEN_WRITE_BINARY: u32 = 5;
const APPLICATION_EXIT: u32 = 0x2_0026;

/// What is loaded to address 0 and to RAM.
pub(crate) struct Image {
    pub(crate) flash: Vec<u8>,
    pub(crate) ram: Vec<u8>,
}

/// A landing pad: `BLX` leaves its own address in LR. Which register it uses varies, so that loads from the field tell
/// addresses apart.
fn pad(address: u32) -> u16 {
    const VARIED: [u16; 8] = [0, 1, 2, 3, 4, 5, 6, 7];
    if (STUB..PLAIN_PADS).contains(&address) {
        let scramble = (address / 2).wrapping_mul(0x9E37_79B9) >> 29;
        blx(VARIED[scramble as usize])
    } else {
        blx(11)
    }
}

pub(crate) fn build(cases: &[Case]) -> Image {
    assert!(cases.len() <= CASES_PER_IMAGE, "too many cases for one image");
    let mut ram = vec![0; RAM_BYTES];

    // Words of the variables: case pointer, stub, window, pattern, record, tail, then semihosting's write block.
    let variables = [
        CASES,
        STUB,
        WINDOW,
        PATTERN,
        RECORD,
        TAIL | 1,
        0,
        RECORD,
        4 * RECORD_WORDS as u32,
        cases.len() as u32,
    ];
    put_words(&mut ram, (VARIABLES - RAM_BASE) as usize, &variables);
    put_words(&mut ram, (PATTERN - RAM_BASE) as usize, &window_pattern());

    let head = head();
    put_halfwords(&mut ram, HEAD_END + 2 - 2 * head.len() as u32, &head);
    for address in (HEAD_END + 2..TAIL).step_by(2) {
        put_halfwords(&mut ram, address, &[pad(address)]);
    }
    let after_snippet = STUB + 2 * SNIPPET as u32;
    put_halfwords(&mut ram, after_snippet, &[branch((TAIL - after_snippet) as i32)]);
    put_halfwords(&mut ram, TAIL, &tail(HEAD_END + 2 - 2 * head.len() as u32));

    let (startup, handler) = startup();
    let mut vectors = [handler | 1; VECTORS];
    vectors[0] = RAM_BASE + RAM_BYTES as u32;
    vectors[1] = CODE | 1;
    let mut flash = Vec::new();
    flash.extend(vectors.iter().flat_map(|word| word.to_le_bytes()));
    flash.extend(startup.iter().flat_map(|halfword| halfword.to_le_bytes()));
    assert!(flash.len() <= CASES as usize, "the startup code runs into the cases");
    flash.resize(CASES as usize, 0);
    for case in cases {
        flash.extend(case.halfwords().iter().flat_map(|halfword| halfword.to_le_bytes()));
        flash.extend(case.start_state().iter().flat_map(|word| word.to_le_bytes()));
    }
    Image { flash, ram }
}

/// What the window holds when a case starts.
pub(crate) fn window_pattern() -> [u32; WINDOW_WORDS] {
    let mut numbers = Numbers::new(0xF1E1D);
    std::array::from_fn(|word| match word {
        _ if word >= WINDOW_PADS => (PLAIN_PADS + 4 * word as u32) | 1,
        _ => numbers.word(),
    })
}

/// Copies the snippet, fills the window, loads the registers and falls into the snippet.
fn head() -> Vec<u16> {
    const FOUR: u16 = 0xF0;
    let mut code = vec![
        movs_imm(0, 0x20),
        lsls_imm(0, 0, 24),
        ldr(1, 0, 0),
        ldr(2, 0, 4),
        ldm(1, FOUR),
        stm(2, FOUR),
        ldr(2, 0, 8),
        ldr(3, 0, 12),
    ];
    for _ in 0..WINDOW_WORDS / 4 {
        code.extend([ldm(3, FOUR), stm(2, FOUR)]);
    }
    code.extend([ldr(4, 0, 16), mov(10, 4), ldr(4, 0, 20), mov(11, 4)]);
    code.extend([ldm(1, 0b1111_1100), mov(8, 2), mov(9, 3), mov(12, 4), mov(LR, 5), mov(SP, 6)]);
    code.extend(msr(APSR, 7));
    code.extend([mov(7, 1), ldm(7, 0b0111_1111), ldr(7, 7, 0)]);
    code.push(branch((STUB - HEAD_END) as i32));
    code
}

/// Stores the record, puts the core back in order, writes the record, goes on with the next case.
fn tail(head: u32) -> Vec<u16> {
    let mut p = Program::at(TAIL);
    p.emit(&[mov(11, SP), mov(SP, 10)]);
    for register in 0..8 {
        p.emit(&[str_sp(register, 4 * register)]);
    }
    p.emit(&mrs(0, XPSR)).emit(&[str_sp(0, 32)]);
    for (slot, register) in [(9, 8), (10, 9), (11, 12), (12, LR), (13, 11)] {
        p.emit(&[mov(0, register), str_sp(0, 4 * slot)]);
    }
    for (slot, special) in [(14, CONTROL), (15, MSP), (16, PSP), (17, PRIMASK)] {
        p.emit(&mrs(0, special)).emit(&[str_sp(0, 4 * slot)]);
    }
    // Mask, forget everything pending, all priorities 0, main stack, unmask.
    p.emit(&[CPSID, movs_imm(0, 0)]).emit(&msr(CONTROL, 0)).emit(&msr(PSP, 0));
    p.constant(1, u32::MAX).constant(2, 0xE000_E180).emit(&[str(1, 2, 0)]);
    p.constant(2, 0xE000_E280).emit(&[str(1, 2, 0)]);
    p.constant(2, 0xE000_ED04).constant(1, 1 << 27 | 1 << 25).emit(&[str(1, 2, 0)]);
    p.emit(&[str(0, 2, 0x18), str(0, 2, 0x1C)]);
    p.constant(2, 0xE000_E400);
    for lane in 0..8 {
        p.emit(&[str(0, 2, 4 * lane)]);
    }
    p.emit(&[0xF3BF, 0x8F4F, 0xF3BF, 0x8F6F, CPSIE, mov(SP, 10)]);

    p.constant(1, WINDOW).constant(2, RECORD + 4 * STATE_NAMES.len() as u32);
    for _ in 0..WINDOW_WORDS / 4 {
        p.emit(&[ldm(1, 0xF0), stm(2, 0xF0)]);
    }
    p.emit(&[movs_imm(0, SYS_WRITE)]).constant(1, VARIABLES + 24).emit(&[SEMIHOSTING]);

    p.constant(0, VARIABLES).emit(&[ldr(1, 0, 0), adds_imm(1, CASE_BYTES as u16), str(1, 0, 0)]);
    p.emit(&[ldr(1, 0, 36), subs_imm(1, 1), str(1, 0, 36)]);
    p.emit(&[branch_if(EQ, 6)]).constant(0, head | 1).emit(&[bx(0)]);
    p.emit(&[movs_imm(0, SYS_EXIT)]).constant(1, APPLICATION_EXIT).emit(&[SEMIHOSTING]);
    p.finish()
}

/// Reset code and the handler of all exceptions: opens the file; shows number, return address and EXC_RETURN in r0 to
/// r3 and returns to the tail.
fn startup() -> (Vec<u16>, u32) {
    let name = RESULT_FILE.as_bytes();
    let mut p = Program::at(CODE);
    p.constant(2, VARIABLES + 40);
    p.emit(&[movs_imm(3, OPEN_WRITE_BINARY as u16), str(3, 2, 4)]);
    p.emit(&[movs_imm(3, name.len() as u16), str(3, 2, 8)]);
    // The name lies behind the open block.
    p.emit(&[mov(3, 2), adds_imm(3, 16), str(3, 2, 0)]);
    for (at, chunk) in name.chunks(4).enumerate() {
        let mut word = [0; 4];
        word[..chunk.len()].copy_from_slice(chunk);
        p.constant(4, u32::from_le_bytes(word)).emit(&[str(4, 3, 4 * at as u16)]);
    }
    p.emit(&[movs_imm(0, SYS_OPEN), mov(1, 2), SEMIHOSTING]);
    p.constant(2, VARIABLES).emit(&[str(0, 2, 24)]);
    p.constant(0, (HEAD_END + 2 - 2 * head().len() as u32) | 1).emit(&[bx(0)]);

    let handler = p.here();
    p.emit(&[mov(0, SP), mov(1, LR), movs_imm(2, 4), tst(1, 2), branch_if(EQ, 6)]).emit(&mrs(0, PSP));
    p.emit(&[ldr(1, 0, 24), str(1, 0, 0), ldr(1, 0, 28), str(1, 0, 4)]);
    p.emit(&mrs(1, IPSR)).emit(&[str(1, 0, 8), mov(1, LR), str(1, 0, 12)]);
    p.emit(&[movs_imm(1, 1), lsls_imm(1, 1, 24), ldr(2, 0, 28), orrs(2, 1), str(2, 0, 28)]);
    p.constant(1, TAIL).emit(&[str(1, 0, 24), bx(LR)]);
    (p.finish(), handler)
}

fn put_words(ram: &mut [u8], at: usize, words: &[u32]) {
    for (slot, word) in ram[at..].chunks_exact_mut(4).zip(words) {
        slot.copy_from_slice(&word.to_le_bytes());
    }
}

fn put_halfwords(ram: &mut [u8], address: u32, code: &[u16]) {
    for (slot, halfword) in ram[(address - RAM_BASE) as usize..].chunks_exact_mut(2).zip(code) {
        slot.copy_from_slice(&halfword.to_le_bytes());
    }
}
