//! The two machines that run the oracle's image: QEMU's `microbit` and our core.

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use std::{fs, io, thread};

use bench::rp2040::bus::{Bus, BusError, Width};
use bench::rp2040::cpu::Cpu;

use super::layout::{FLASH_BYTES, Image, RAM_BASE, RAM_BYTES, RESULT_FILE};

/// A hung QEMU is killed after this many polls.
const QEMU_POLLS: u32 = 1_200;
const QEMU_POLL: Duration = Duration::from_millis(50);
/// Instructions per case, with plenty to spare.
const STEPS_PER_CASE: usize = 2_000;

/// Records of a run, as words.
pub(crate) type Records = Vec<u32>;

fn words(bytes: &[u8]) -> Records {
    bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect()
}

/// Whether QEMU for ARM can be started at all.
pub(crate) fn qemu_is_installed() -> bool {
    let run =
        Command::new("qemu-system-arm").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    run.is_ok_and(|status| status.success())
}

/// Runs the image on QEMU's Cortex-M0.
pub(crate) fn run_on_qemu(image: &Image, folder: &Path) -> io::Result<Records> {
    fs::write(folder.join("flash.bin"), &image.flash)?;
    fs::write(folder.join("ram.bin"), &image.ram)?;
    let mut qemu = Command::new("qemu-system-arm")
        .args(["-M", "microbit", "-display", "none", "-monitor", "none", "-serial", "none"])
        .args(["-semihosting-config", "enable=on,target=native"])
        .args(["-kernel", "flash.bin"])
        .args(["-device", &format!("loader,file=ram.bin,addr={RAM_BASE:#x},force-raw=on")])
        .current_dir(folder)
        .stdin(Stdio::null())
        .spawn()?;
    wait_or_kill(&mut qemu)?;
    Ok(words(&fs::read(folder.join(RESULT_FILE))?))
}

fn wait_or_kill(child: &mut Child) -> io::Result<()> {
    for _ in 0..QEMU_POLLS {
        if child.try_wait()?.is_some() {
            return Ok(());
        }
        thread::sleep(QEMU_POLL);
    }
    child.kill()?;
    child.wait()?;
    Err(io::Error::new(io::ErrorKind::TimedOut, "QEMU did not reach the end of the program"))
}

/// Runs the image on our core.
pub(crate) fn run_on_ours(image: &Image, cases: usize) -> Result<Records, String> {
    let mut memory =
        Memory { flash: image.flash.clone(), ram: image.ram.clone(), written: Vec::new(), exited: false };
    memory.flash.resize(FLASH_BYTES, 0);
    memory.ram.resize(RAM_BYTES, 0);
    let mut cpu = Cpu::new();
    cpu.reset(&mut memory, 0).map_err(|_| "no vector table")?;
    for _ in 0..cases * STEPS_PER_CASE {
        cpu.step(&mut memory)
            .map_err(|stop| format!("{stop}, {} bytes into the records", memory.written.len()))?;
        if memory.exited {
            return Ok(words(&memory.written));
        }
    }
    Err(format!("no exit; pc {:#010x}, {} bytes written", cpu.registers[15], memory.written.len()))
}

/// Flash, RAM and the three semihosting calls that the program uses.
struct Memory {
    flash: Vec<u8>,
    ram: Vec<u8>,
    written: Vec<u8>,
    exited: bool,
}

impl Memory {
    fn bytes(&mut self, address: u32, count: usize) -> Result<&mut [u8], BusError> {
        let (memory, at) = match address {
            RAM_BASE.. => (&mut self.ram, (address - RAM_BASE) as usize),
            _ => (&mut self.flash, address as usize),
        };
        memory.get_mut(at..at + count).ok_or(BusError)
    }

    fn word(&mut self, address: u32) -> Result<u32, BusError> {
        self.load(address, Width::Word)
    }

    fn semihosting(&mut self, call: u32, block: u32) -> Result<u32, BusError> {
        match call {
            0x01 => Ok(1),
            0x05 => {
                let (from, count) = (self.word(block + 4)?, self.word(block + 8)?);
                let bytes = self.bytes(from, count as usize)?.to_vec();
                self.written.extend(bytes);
                Ok(0)
            }
            0x18 => {
                self.exited = true;
                Ok(0)
            }
            _ => Err(BusError),
        }
    }
}

const fn byte_count(width: Width) -> usize {
    match width {
        Width::Byte => 1,
        Width::Half => 2,
        Width::Word => 4,
    }
}

impl Bus for Memory {
    fn fetch(&mut self, address: u32) -> Result<u16, BusError> {
        self.load(address, Width::Half).map(|half| half as u16)
    }

    fn load(&mut self, address: u32, width: Width) -> Result<u32, BusError> {
        let bytes = self.bytes(address, byte_count(width))?;
        Ok(bytes.iter().rev().fold(0, |value, byte| value << 8 | u32::from(*byte)))
    }

    fn store(&mut self, address: u32, width: Width, value: u32) -> Result<(), BusError> {
        let count = byte_count(width);
        self.bytes(address, count)?.copy_from_slice(&value.to_le_bytes()[..count]);
        Ok(())
    }

    fn breakpoint(&mut self, _pc: u32, code: u8, registers: &mut [u32; 16]) -> bool {
        if code != 0xAB {
            return false;
        }
        match self.semihosting(registers[0], registers[1]) {
            Ok(answer) => {
                registers[0] = answer;
                true
            }
            Err(BusError) => false,
        }
    }

    fn take_extra_cycles(&mut self) -> i32 {
        0
    }
}
