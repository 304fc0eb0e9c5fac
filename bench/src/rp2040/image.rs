//! Loads a firmware ELF into a flash image, the way a flashing tool does.
//!
//! Owns the checks that catch the wrong file before it runs: not an ELF, another chip's ELF, one without a second-stage
//! boot loader. It never changes what it loads.

use std::fmt;
use std::path::{Path, PathBuf};

use object::read::elf::{ElfFile32, FileHeader, ProgramHeader};
use object::{Endianness, elf};

use super::rom;
use super::xip::{FLASH_BASE, FLASH_BYTES};

/// Why a firmware file cannot be loaded.
#[derive(Debug)]
pub struct ImageError {
    file: PathBuf,
    problem: Problem,
}

/// What is wrong with the file.
#[derive(Debug)]
pub enum Problem {
    /// It cannot be read.
    Io(std::io::Error),
    /// It is not an ELF.
    NotElf(String),
    /// It is an ELF for something else than a 32-bit ARM chip, or not a linked program.
    WrongKind(String),
    /// It loads outside the flash of an RP2040.
    OutsideFlash {
        /// First address of the segment.
        address: u64,
        /// Length in bytes.
        bytes: u64,
    },
    /// It starts outside the flash of an RP2040.
    EntryOutsideFlash {
        /// Its entry point.
        entry: u64,
    },
    /// The first 256 bytes are not a second-stage boot loader with its checksum.
    NoBoot2,
}

impl fmt::Display for ImageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.file.display())?;
        let flash_end = FLASH_BASE as usize + FLASH_BYTES;
        match &self.problem {
            Problem::Io(error) => write!(f, "cannot be read: {error}"),
            Problem::NotElf(error) => {
                write!(f, "is not an ELF file ({error}); pass the linked firmware, not a UF2 or BIN")
            }
            Problem::WrongKind(what) => {
                write!(f, "is {what}; the RP2040 needs a linked 32-bit little-endian ARM program")
            }
            Problem::OutsideFlash { address, bytes } => write!(
                f,
                "loads {bytes} bytes at {address:#010x}, outside the flash {FLASH_BASE:#010x} to {flash_end:#010x}: \
                 it is an ELF for another chip, or it is too large"
            ),
            Problem::EntryOutsideFlash { entry } => {
                write!(f, "starts at {entry:#010x}, outside the flash: it is an ELF for another chip")
            }
            Problem::NoBoot2 => write!(
                f,
                "has no valid second-stage boot loader in its first 256 bytes (wrong CRC-32); link rp2040-boot2 into \
                 section .boot2"
            ),
        }
    }
}

impl std::error::Error for ImageError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match &self.problem {
            Problem::Io(error) => Some(error),
            _ => None,
        }
    }
}

impl ImageError {
    /// What is wrong with the file.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }
}

/// Reads the ELF `file` and returns the flash from 0x1000_0000 on, as far as the ELF fills it.
///
/// # Errors
/// [`ImageError`], which names the file and says what is wrong with it.
pub fn load_elf(file: &Path) -> Result<Vec<u8>, ImageError> {
    let fail = |problem| ImageError { file: file.to_path_buf(), problem };
    let bytes = std::fs::read(file).map_err(|error| fail(Problem::Io(error)))?;
    flash_from_elf(&bytes).map_err(fail)
}

/// Returns what is wrong with a file of this name, in words for a person.
pub fn told(file: &str, problem: Problem) -> String {
    ImageError { file: file.into(), problem }.to_string()
}

/// The flash image inside the bytes of an ELF.
///
/// # Errors
/// [`Problem`], which says what is wrong.
pub fn flash_from_elf(bytes: &[u8]) -> Result<Vec<u8>, Problem> {
    match object::FileKind::parse(bytes) {
        Ok(object::FileKind::Elf32) => {}
        Ok(object::FileKind::Elf64) => {
            return Err(Problem::WrongKind("a 64-bit ELF, for a PC perhaps".into()));
        }
        Ok(kind) => return Err(Problem::NotElf(format!("{kind:?}"))),
        Err(error) => return Err(Problem::NotElf(error.to_string())),
    }
    let file = ElfFile32::<Endianness>::parse(bytes).map_err(|error| Problem::NotElf(error.to_string()))?;
    let (header, endian) = (file.elf_header(), file.endian());
    if header.e_machine(endian) != elf::EM_ARM || endian != Endianness::Little {
        return Err(Problem::WrongKind(format!("an ELF for machine {}", header.e_machine(endian))));
    }
    if header.e_type(endian) != elf::ET_EXEC {
        return Err(Problem::WrongKind("an ARM object or library".into()));
    }
    let entry = u64::from(header.e_entry(endian));
    let flash = u64::from(FLASH_BASE)..u64::from(FLASH_BASE) + FLASH_BYTES as u64;
    let mut image = Vec::new();
    for segment in file.elf_program_headers() {
        let size = u64::from(segment.p_filesz(endian));
        if segment.p_type(endian) != elf::PT_LOAD || size == 0 {
            continue;
        }
        let address = u64::from(segment.p_paddr(endian));
        if !flash.contains(&address) || address + size > flash.end {
            return Err(Problem::OutsideFlash { address, bytes: size });
        }
        let data =
            segment.data(endian, bytes).map_err(|()| Problem::NotElf("a segment is cut off".into()))?;
        let start = (address - flash.start) as usize;
        let end = start + data.len();
        if image.len() < end {
            image.resize(end, 0xff);
        }
        image[start..end].copy_from_slice(data);
    }
    if !flash.contains(&entry) {
        return Err(Problem::EntryOutsideFlash { entry });
    }
    if !rom::is_boot2_valid(&image) {
        return Err(Problem::NoBoot2);
    }
    Ok(image)
}
