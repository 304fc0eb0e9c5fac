//! Prints how fast the core runs simple code, in M instr/s and as a ratio to a 125 MHz chip.
//!
//! `cargo run --release -p bench --example cpu_speed`. The only wall clock in the bench: it measures the host.

use std::time::Instant;

use bench::rp2040::bus::{Bus, BusError, Width};
use bench::rp2040::cpu::Cpu;

const RAM_BASE: u32 = 0x2000_0000;
const RAM_BYTES: usize = 256 * 1024;
const CLK_SYS_HZ: f64 = 125e6;
const INSTRUCTIONS: u64 = 400_000_000;

/// Zero-wait RAM and nothing else.
struct Ram(Vec<u8>);

impl Ram {
    #[inline(always)]
    fn bytes<const N: usize>(&self, address: u32) -> Result<[u8; N], BusError> {
        let at = address.wrapping_sub(RAM_BASE) as usize;
        let bytes = self.0.get(at..).and_then(|tail| tail.first_chunk()).ok_or(BusError)?;
        Ok(*bytes)
    }
}

impl Bus for Ram {
    #[inline(always)]
    fn fetch(&mut self, address: u32) -> Result<u16, BusError> {
        self.bytes(address).map(u16::from_le_bytes)
    }

    #[inline(always)]
    fn load(&mut self, address: u32, width: Width) -> Result<u32, BusError> {
        match width {
            Width::Byte => self.bytes::<1>(address).map(|[byte]| u32::from(byte)),
            Width::Half => self.bytes(address).map(|half| u32::from(u16::from_le_bytes(half))),
            Width::Word => self.bytes(address).map(u32::from_le_bytes),
        }
    }

    #[inline(always)]
    fn store(&mut self, address: u32, width: Width, value: u32) -> Result<(), BusError> {
        let count = match width {
            Width::Byte => 1,
            Width::Half => 2,
            Width::Word => 4,
        };
        let at = address.wrapping_sub(RAM_BASE) as usize;
        let target = self.0.get_mut(at..at.saturating_add(count)).ok_or(BusError)?;
        target.copy_from_slice(&value.to_le_bytes()[..count]);
        Ok(())
    }

    fn breakpoint(&mut self, _pc: u32, _code: u8, _registers: &mut [u32; 16]) -> bool {
        false
    }

    fn take_extra_cycles(&mut self) -> i32 {
        0
    }
}

/// Endless loops of what compiled code is made of.
const PROGRAMS: [(&str, &[u16]); 3] = [
    // adds r0, r0, r1; eors r0, r2; lsls r3, r0, #3; subs r4, #1; orrs r3, r1; cmp r4, r0; b .-12
    ("arithmetic", &[0x1840, 0x4050, 0x00C3, 0x3C01, 0x430B, 0x4284, 0xE7F8]),
    // movs r0, #200; ldrb r1, [r7, r0]; adds r2, r2, r1; strb r2, [r6, r0]; subs r0, #1; bne .-8; b .-12
    ("byte loop", &[0x20C8, 0x5C39, 0x1852, 0x5432, 0x3801, 0xD1FA, 0xE7F8]),
    // bl f; adds r0, r0, r5; b .-6; nop; f: push {r4, lr}; mov r4, r0; ldr r1, [r7, #4]; muls r1, r4;
    // str r1, [r7, #8]; lsrs r0, r1, #7; pop {r4, pc}
    ("calls", &[0xF000, 0xF802, 0x1940, 0xE7FB, 0xB510, 0x4604, 0x6879, 0x4361, 0x60B9, 0x09C8, 0xBD10]),
];

fn main() {
    for (name, code) in PROGRAMS {
        let mut ram = Ram(vec![0; RAM_BYTES]);
        for (at, halfword) in code.iter().enumerate() {
            ram.0[2 * at..2 * at + 2].copy_from_slice(&halfword.to_le_bytes());
        }
        let mut cpu = Cpu::new();
        cpu.registers = [1, 3, 5, 7, 9, 11, RAM_BASE + 0x1000, RAM_BASE + 0x2000, 0, 0, 0, 0, 0, 0, 0, 0];
        cpu.registers[13] = RAM_BASE + 0x8000;
        cpu.registers[15] = RAM_BASE;

        let start = Instant::now();
        let mut cycles = 0;
        for _ in 0..INSTRUCTIONS {
            match cpu.step(&mut ram) {
                Ok(spent) => cycles += u64::from(spent),
                Err(stop) => panic!("{name}: {stop}"),
            }
        }
        let seconds = start.elapsed().as_secs_f64();
        #[expect(clippy::cast_precision_loss, reason = "for people")]
        let (instructions, cycles) = (INSTRUCTIONS as f64, cycles as f64);
        println!(
            "{name:<11} {:6.0} M instr/s   {:5.2} cycles/instr   {:5.2} x real time at 125 MHz",
            instructions / seconds / 1e6,
            cycles / instructions,
            cycles / seconds / CLK_SYS_HZ,
        );
    }
}
