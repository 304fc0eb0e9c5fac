//! Firmware files: what loads, and what a wrong file is told.

mod soc_support;

use std::io::Write;

use bench::rp2040::image::{Problem, flash_from_elf, load_elf};
use soc_support::*;

/// A minimal ELF: header, one LOAD program header, data.
struct Elf {
    class: u8,
    machine: u16,
    kind: u16,
    entry: u32,
    address: u32,
    data: Vec<u8>,
}

impl Elf {
    fn good() -> Self {
        let mut program = Program::new();
        program.sleep();
        Self { class: 1, machine: 40, kind: 2, entry: CODE | 1, address: 0x1000_0000, data: image(&program) }
    }

    fn bytes(&self) -> Vec<u8> {
        let mut elf = vec![0x7f, b'E', b'L', b'F', self.class, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        let half = |elf: &mut Vec<u8>, value: u16| elf.extend(value.to_le_bytes());
        half(&mut elf, self.kind);
        half(&mut elf, self.machine);
        for word in [1, self.entry, 52, 0, 0x0500_0000] {
            elf.extend(word.to_le_bytes());
        }
        for value in [52, 32, 1, 40, 0, 0] {
            half(&mut elf, value);
        }
        let size = self.data.len() as u32;
        for word in [1, 84, self.address, self.address, size, size, 5, 4] {
            elf.extend(word.to_le_bytes());
        }
        elf.extend(&self.data);
        elf
    }
}

#[test]
fn a_good_elf_becomes_its_flash_bytes() {
    let elf = Elf::good();
    assert_eq!(flash_from_elf(&elf.bytes()).unwrap(), elf.data);
}

#[test]
fn a_file_that_is_no_elf_is_refused_by_name() {
    let mut file = tempfile::NamedTempFile::with_suffix(".uf2").unwrap();
    file.write_all(b"UF2\nnot an elf").unwrap();
    let error = load_elf(file.path()).unwrap_err();
    assert!(matches!(error.problem(), Problem::NotElf(_)));
    let text = error.to_string();
    assert!(text.contains(".uf2") && text.contains("not an ELF"), "{text}");
}

#[test]
fn a_missing_file_is_named() {
    let error = load_elf(std::path::Path::new("no/such/firmware")).unwrap_err();
    assert!(matches!(error.problem(), Problem::Io(_)));
    assert!(error.to_string().contains("no/such/firmware"));
}

#[test]
fn another_machines_elf_is_refused() {
    for elf in
        [Elf { machine: 243, ..Elf::good() }, Elf { kind: 1, ..Elf::good() }, Elf { class: 2, ..Elf::good() }]
    {
        let problem = flash_from_elf(&elf.bytes()).unwrap_err();
        assert!(matches!(problem, Problem::WrongKind(_) | Problem::NotElf(_)), "{problem:?}");
    }
}

#[test]
fn an_elf_for_another_chips_flash_is_refused() {
    let elf = Elf { address: 0x0800_0000, entry: 0x0800_0201, ..Elf::good() };
    assert!(matches!(flash_from_elf(&elf.bytes()), Err(Problem::OutsideFlash { address: 0x0800_0000, .. })));
    let elf = Elf { entry: 0x0800_0201, ..Elf::good() };
    assert!(matches!(flash_from_elf(&elf.bytes()), Err(Problem::EntryOutsideFlash { .. })));
}

#[test]
fn an_image_behind_the_end_of_flash_is_refused() {
    let elf = Elf { address: 0x101f_fff0, ..Elf::good() };
    assert!(matches!(flash_from_elf(&elf.bytes()), Err(Problem::OutsideFlash { .. })));
}

#[test]
fn an_image_without_a_second_stage_is_refused() {
    let mut elf = Elf::good();
    elf.data[..256].fill(0);
    assert!(matches!(flash_from_elf(&elf.bytes()), Err(Problem::NoBoot2)));
}
