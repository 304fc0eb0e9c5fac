//! The cells of a NOR flash: what a program or an erase leaves behind, done or cut off.
//!
//! Programming only takes bits from 1 to 0, erasing takes a whole sector to 1. A cell that was cut off in the middle of
//! its change is weak: it reads either way, anew at each read, until it is erased or programmed to the end. The noise
//! is seeded, so runs stay equal. Owns the wear counter of each sector. Refuses to know commands and time.
//!
//! Source: W25Q16JV datasheet 6 (sectors, pages), 9.6 (endurance 100 000 cycles). Datasheets say nothing of cells that
//! are cut off; the model takes the worst that they may do.
//!
//! Not modelled: loss of charge over years, cells that wear out, disturbance of neighbours.

use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashErrorKind, ReadNorFlash};
use std::collections::BTreeMap;

/// Sector erase granularity, in bytes.
pub const SECTOR_BYTES: usize = 4096;
/// Page program granularity, in bytes.
pub const PAGE_BYTES: usize = 256;

/// Bytes of a page of which the bits change at the same time while it is programmed.
const STRIPE_BYTES: usize = 4;
/// Part of an erase, of 256, during which one cell is neither 0 nor 1.
const ERASE_SPREAD: usize = 48;

/// What is done to the cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Work {
    /// Whole sectors go to 1.
    Erase {
        /// First byte, a multiple of [`SECTOR_BYTES`].
        offset: usize,
        /// Bytes, a multiple of [`SECTOR_BYTES`].
        len: usize,
    },
    /// Bits that are 0 in the data go to 0.
    Program {
        /// First byte.
        offset: usize,
        /// What to program.
        data: Vec<u8>,
    },
}

impl Work {
    /// Bytes that it covers.
    pub fn len(&self) -> usize {
        match self {
            Self::Erase { len, .. } => *len,
            Self::Program { data, .. } => data.len(),
        }
    }

    /// Whether it covers nothing.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The cells, their weak bits and their wear.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cells {
    bytes: Vec<u8>,
    /// Bits that read either way, by byte.
    weak: BTreeMap<usize, u8>,
    erases: Vec<u32>,
    noise: u64,
}

impl Cells {
    /// Cells that hold `bytes`, without weak bits and wear.
    pub fn new(bytes: Vec<u8>) -> Self {
        let erases = vec![0; bytes.len().div_ceil(SECTOR_BYTES)];
        Self { bytes, weak: BTreeMap::new(), erases, noise: 1 }
    }

    /// The same cells with noise from another seed.
    #[must_use]
    pub fn seeded(self, seed: u64) -> Self {
        Self { noise: seed, ..self }
    }

    /// What the cells hold; a weak bit is told as it was before it became weak.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// How often each sector was erased.
    pub fn erases(&self) -> &[u32] {
        &self.erases
    }

    /// Weak bits in all cells.
    pub fn weak_bits(&self) -> usize {
        self.weak.values().map(|bits| bits.count_ones() as usize).sum()
    }

    /// Reads a byte: each weak bit either way.
    #[inline]
    pub fn read(&mut self, at: usize) -> u8 {
        let Some(weak) = self.weak.get(&at).copied() else { return self.bytes[at] };
        self.bytes[at] ^ (self.next_noise() as u8 & weak)
    }

    /// Reads everything once, weak bits either way: what a programmer would read out.
    pub fn read_out(&mut self) -> Vec<u8> {
        (0..self.bytes.len()).map(|at| self.read(at)).collect()
    }

    fn next_noise(&mut self) -> u64 {
        // SplitMix64.
        self.noise = self.noise.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.noise ^ self.noise >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    /// Does all of it.
    pub fn finish(&mut self, work: &Work) {
        match work {
            Work::Erase { offset, len } => (*offset..offset + len).step_by(SECTOR_BYTES).for_each(|at| {
                self.bytes[at..at + SECTOR_BYTES].fill(0xff);
                self.weak.retain(|byte, _| !(at..at + SECTOR_BYTES).contains(byte));
                self.erases[at / SECTOR_BYTES] += 1;
            }),
            Work::Program { offset, data } => {
                data.iter().enumerate().for_each(|(i, byte)| self.program(offset + i, *byte));
            }
        }
    }

    /// Programs one byte: its zeros are firm from now on, a weak bit that is to stay 1 stays weak.
    fn program(&mut self, at: usize, byte: u8) {
        self.bytes[at] &= byte;
        if let Some(weak) = self.weak.get_mut(&at) {
            *weak &= byte;
            if *weak == 0 {
                self.weak.remove(&at);
            }
        }
    }

    fn weaken(&mut self, at: usize, bits: u8) {
        if bits != 0 {
            *self.weak.entry(at).or_default() |= bits;
        }
    }

    /// The supply fails when `reached` bytes' worth of the time has passed.
    pub fn cut(&mut self, work: &Work, reached: usize) {
        match work {
            Work::Erase { offset, len } => {
                let whole = reached / SECTOR_BYTES * SECTOR_BYTES;
                self.finish(&Work::Erase { offset: *offset, len: whole.min(*len) });
                if whole < *len {
                    self.cut_erase(offset + whole, (reached - whole) * 256 / SECTOR_BYTES);
                }
            }
            Work::Program { offset, data } => {
                let whole = reached.min(data.len());
                let (done, rest) = data.split_at(whole);
                done.iter().enumerate().for_each(|(i, byte)| self.program(offset + i, *byte));
                for (i, byte) in rest.iter().enumerate().take(STRIPE_BYTES) {
                    let at = offset + whole + i;
                    let changing = self.bytes[at] & !byte;
                    self.weaken(at, changing);
                }
            }
        }
    }

    /// All cells of a sector are erased together, each at its own pace: `part` of 256 of the time has passed.
    fn cut_erase(&mut self, sector: usize, part: usize) {
        self.erases[sector / SECTOR_BYTES] += 1;
        for at in sector..sector + SECTOR_BYTES {
            let paces = self.next_noise().to_le_bytes();
            let (mut erased, mut weak) = (0, 0);
            for (bit, pace) in paces.into_iter().enumerate() {
                let begins = usize::from(pace) * (256 - ERASE_SPREAD) / 256;
                if part >= begins + ERASE_SPREAD {
                    erased |= 1 << bit;
                } else if part > begins {
                    weak |= 1 << bit;
                }
            }
            // A bit that was 1 all along has nothing to change.
            let zeros = !self.bytes[at];
            self.bytes[at] |= erased;
            if let Some(before) = self.weak.get_mut(&at) {
                *before &= !erased;
                if *before == 0 {
                    self.weak.remove(&at);
                }
            }
            self.weaken(at, weak & zeros);
        }
    }
}

/// A stretch of a flash as a driver sees it, without a chip around it; its supply may fail after so many bytes.
#[derive(Clone, Debug)]
pub struct Region {
    /// The cells of the whole flash.
    pub cells: Cells,
    /// First byte of the stretch.
    offset: usize,
    len: usize,
    /// Bytes that can still be programmed or erased; `None` = the supply stays.
    pub supply: Option<usize>,
    /// Everything done so far, if somebody asked for it.
    pub journal: Option<Vec<Work>>,
}

impl Region {
    /// The stretch of `len` bytes from `offset` on.
    pub fn new(cells: Cells, offset: usize, len: usize) -> Self {
        Self { cells, offset, len, supply: None, journal: None }
    }

    fn work(&mut self, work: Work) -> Result<(), NorFlashErrorKind> {
        if let Some(supply) = &mut self.supply {
            let reached = std::mem::take(supply);
            if reached < work.len() {
                self.cells.cut(&work, reached);
                return Err(NorFlashErrorKind::Other);
            }
            *supply = reached - work.len();
        }
        self.cells.finish(&work);
        if let Some(journal) = &mut self.journal {
            journal.push(work);
        }
        Ok(())
    }

    fn at(&self, offset: u32, len: usize, unit: usize) -> Result<usize, NorFlashErrorKind> {
        let offset = offset as usize;
        if !offset.is_multiple_of(unit) || !len.is_multiple_of(unit) {
            return Err(NorFlashErrorKind::NotAligned);
        }
        let is_inside = offset.checked_add(len).is_some_and(|end| end <= self.len);
        is_inside.then_some(self.offset + offset).ok_or(NorFlashErrorKind::OutOfBounds)
    }
}

impl ErrorType for Region {
    type Error = NorFlashErrorKind;
}

impl ReadNorFlash for Region {
    const READ_SIZE: usize = 1;

    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), Self::Error> {
        let at = self.at(offset, bytes.len(), 1)?;
        let end = at + bytes.len();
        bytes.copy_from_slice(&self.cells.bytes[at..end]);
        let weak: Vec<usize> = self.cells.weak.range(at..end).map(|(byte, _)| *byte).collect();
        weak.into_iter().for_each(|byte| bytes[byte - at] = self.cells.read(byte));
        Ok(())
    }

    fn capacity(&self) -> usize {
        self.len
    }
}

impl NorFlash for Region {
    const WRITE_SIZE: usize = 1;
    const ERASE_SIZE: usize = SECTOR_BYTES;

    fn erase(&mut self, from: u32, to: u32) -> Result<(), Self::Error> {
        let len = to.checked_sub(from).ok_or(NorFlashErrorKind::OutOfBounds)? as usize;
        let offset = self.at(from, len, SECTOR_BYTES)?;
        self.work(Work::Erase { offset, len })
    }

    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Self::Error> {
        let at = self.at(offset, bytes.len(), 1)?;
        if at / PAGE_BYTES != (at + bytes.len().max(1) - 1) / PAGE_BYTES {
            // The chip would go on at the start of the page.
            return Err(NorFlashErrorKind::NotAligned);
        }
        self.work(Work::Program { offset: at, data: bytes.to_vec() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(byte: u8) -> Cells {
        Cells::new(vec![byte; 2 * SECTOR_BYTES])
    }

    #[test]
    fn programming_clears_bits_and_erasing_sets_them_and_is_counted() {
        let mut cells = of(0x3c);
        cells.finish(&Work::Program { offset: 5, data: vec![0xf0; 3] });
        assert_eq!(cells.bytes()[4..9], [0x3c, 0x30, 0x30, 0x30, 0x3c]);
        cells.finish(&Work::Erase { offset: 0, len: SECTOR_BYTES });
        assert!(cells.bytes()[..SECTOR_BYTES].iter().all(|byte| *byte == 0xff));
        assert_eq!((cells.bytes()[SECTOR_BYTES], cells.erases()), (0x3c, &[1, 0][..]));
    }

    #[test]
    fn a_cut_program_is_whole_before_the_cut_weak_at_it_and_nothing_behind() {
        for reached in 0..=PAGE_BYTES {
            let mut cells = of(0xff);
            cells.cut(&Work::Program { offset: 0, data: vec![0x0f; PAGE_BYTES] }, reached);
            assert!(cells.bytes()[..reached].iter().all(|byte| *byte == 0x0f), "{reached}");
            let weak = STRIPE_BYTES.min(PAGE_BYTES - reached);
            assert_eq!(cells.weak_bits(), 4 * weak, "{reached}");
            for at in reached..reached + weak {
                let seen: Vec<u8> = (0..64).map(|_| cells.read(at)).collect();
                assert!(
                    seen.iter().any(|byte| *byte != seen[0]),
                    "byte {at} reads differently from read to read"
                );
                assert!(seen.iter().all(|byte| byte & 0x0f == 0x0f), "no bit changes that was not to change");
            }
            assert!(cells.bytes()[reached + weak..].iter().all(|byte| *byte == 0xff));
        }
    }

    #[test]
    fn an_erase_takes_more_and_more_cells_over_weak_ones_to_one() {
        let erased = |part: usize| {
            let mut cells = of(0);
            cells.cut(&Work::Erase { offset: 0, len: SECTOR_BYTES }, part);
            let ones: u32 = cells.bytes()[..SECTOR_BYTES].iter().map(|byte| byte.count_ones()).sum();
            (ones, cells.weak_bits())
        };
        assert_eq!(erased(0), (0, 0));
        let parts: Vec<_> = (1..8).map(|eighth| erased(eighth * SECTOR_BYTES / 8)).collect();
        assert!(parts.iter().all(|(_, weak)| *weak > 0), "{parts:?}");
        assert!(parts.windows(2).all(|pair| pair[0].0 < pair[1].0), "{parts:?}");
        assert_eq!(erased(SECTOR_BYTES), (8 * SECTOR_BYTES as u32, 0));
    }

    #[test]
    fn a_weak_bit_becomes_firm_when_it_is_programmed_or_erased_and_not_before() {
        let mut cells = of(0xff);
        cells.cut(&Work::Program { offset: 0, data: vec![0; 1] }, 0);
        cells.finish(&Work::Program { offset: 0, data: vec![0xf0] });
        assert_eq!(cells.weak_bits(), 4, "the upper half is to stay 1");
        cells.finish(&Work::Program { offset: 0, data: vec![0] });
        assert_eq!((cells.weak_bits(), cells.read(0)), (0, 0));
        cells.cut(&Work::Program { offset: 1, data: vec![0; 1] }, 0);
        cells.finish(&Work::Erase { offset: 0, len: SECTOR_BYTES });
        assert_eq!((cells.weak_bits(), cells.read(1)), (0, 0xff));
    }
}
