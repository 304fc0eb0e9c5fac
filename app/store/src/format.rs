//! How a record and a sector's head lie in flash.
//!
//! Everything starts at a multiple of [`SLOT_BYTES`]. Page 0 of a sector holds its head alone. In every other page the
//! first slot is the page's claim, all zeros, programmed before any record of the page; records follow and never reach
//! into the next page.
//!
//! | record: byte | what                                                     |
//! |--------------|----------------------------------------------------------|
//! | 0            | key, 1 to 254                                            |
//! | 1            | bytes of the payload                                     |
//! | 2 to 4       | generation of the sector, low byte first                 |
//! | 5 to 8       | CRC-32 of the bytes 0 to 4 and the payload               |
//! | from 9 on    | payload, then 0xFF up to the end of the slot             |
//!
//! | head: byte   | what                                                     |
//! |--------------|----------------------------------------------------------|
//! | 0 to 3       | `KEPT`                                                   |
//! | 4, 5         | version of the format                                    |
//! | 6 to 9       | how often the sector was erased                          |
//! | 10, 11       | 0xFF                                                     |
//! | 12 to 15     | CRC-32 of the bytes 0 to 11                              |
//!
//! The head is programmed when an erase has come to its end, and is overwritten with zeros before the next one begins:
//! a sector with a head was erased to the end.

use crc::{CRC_32_ISO_HDLC, Crc};

/// Version of the format.
pub const FORMAT: u16 = 1;
/// Granularity of everything, in bytes.
pub const SLOT_BYTES: usize = 16;
/// Bytes that one program may cover, and no record crosses.
pub const PAGE_BYTES: usize = 256;
/// Bytes that one erase covers.
pub const SECTOR_BYTES: usize = 4096;
/// Longest payload of a record.
pub const MAX_PAYLOAD: usize = PAGE_BYTES - SLOT_BYTES - HEADER;

/// Slots of a page and pages of a sector.
pub(crate) const SLOTS: usize = PAGE_BYTES / SLOT_BYTES;
pub(crate) const PAGES: usize = SECTOR_BYTES / PAGE_BYTES;
/// Bytes of a record before its payload.
pub(crate) const HEADER: usize = 9;
/// Generations are 24 bits: a region's sectors would have been erased 16 million times.
pub(crate) const MAX_GENERATION: u32 = 0x00FF_FFFF;

const MAGIC: [u8; 4] = *b"KEPT";
// A table of 1 KiB: a start looks at every record of the region.
static CRC: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);

/// The key of a slot that was never programmed, and that of a claim.
const BLANK: u8 = 0xFF;
const CLAIMED: u8 = 0;

/// A record as it lies in a buffer of a page.
#[derive(Clone, Copy)]
pub(crate) struct Head {
    pub(crate) key: u8,
    pub(crate) len: usize,
    pub(crate) generation: u32,
    crc: u32,
}

impl Head {
    /// Reads what stands at the start of a slot; `None` = no record can begin here.
    pub(crate) fn read(slot: &[u8; SLOT_BYTES]) -> Option<Self> {
        let [key, len, a, b, c, d, e, f, g, ..] = *slot;
        let head = Self {
            key,
            len: len.into(),
            generation: u32::from_le_bytes([a, b, c, 0]),
            crc: u32::from_le_bytes([d, e, f, g]),
        };
        (key != BLANK && key != CLAIMED && head.len <= MAX_PAYLOAD).then_some(head)
    }

    /// Returns the slots that the record takes.
    pub(crate) const fn slots(&self) -> usize {
        slots_of(self.len)
    }

    /// Returns whether `record`, from its first byte on, is whole.
    pub(crate) fn is_whole(&self, record: &[u8]) -> bool {
        let (Some(head), Some(payload)) = (record.get(..5), record.get(HEADER..HEADER + self.len)) else {
            return false;
        };
        checksum(head, payload) == self.crc
    }
}

/// Returns the slots of a record with so many bytes of payload.
pub(crate) const fn slots_of(len: usize) -> usize {
    (HEADER + len).div_ceil(SLOT_BYTES)
}

fn checksum(head: &[u8], payload: &[u8]) -> u32 {
    let mut digest = CRC.digest();
    digest.update(head);
    digest.update(payload);
    digest.finalize()
}

/// Writes a record to the start of `page`; returns its length in whole slots, `None` = it is too long or has no key.
pub(crate) fn write_record(
    page: &mut [u8; PAGE_BYTES],
    key: u8,
    generation: u32,
    payload: &[u8],
) -> Option<usize> {
    let len = u8::try_from(payload.len()).ok().filter(|_| payload.len() <= MAX_PAYLOAD)?;
    if key == BLANK || key == CLAIMED {
        return None;
    }
    let [a, b, c, _] = generation.to_le_bytes();
    let head = [key, len, a, b, c];
    page.fill(BLANK);
    page.get_mut(..5)?.copy_from_slice(&head);
    page.get_mut(5..HEADER)?.copy_from_slice(&checksum(&head, payload).to_le_bytes());
    page.get_mut(HEADER..HEADER + payload.len())?.copy_from_slice(payload);
    Some((HEADER + payload.len()).next_multiple_of(SLOT_BYTES))
}

/// A page's claim, and what takes a sector's head away.
pub(crate) const ZEROS: [u8; SLOT_BYTES] = [CLAIMED; SLOT_BYTES];

/// Returns the head of a sector that was erased `erases` times.
pub(crate) fn sector_head(erases: u32) -> [u8; SLOT_BYTES] {
    let mut head = [BLANK; SLOT_BYTES];
    let ([m, n, o, p], [v, w], [a, b, c, d]) = (MAGIC, FORMAT.to_le_bytes(), erases.to_le_bytes());
    let body = [m, n, o, p, v, w, a, b, c, d, BLANK, BLANK];
    let ([start @ .., _, _, _, _], crc) = (&mut head, CRC.checksum(&body).to_le_bytes());
    *start = body;
    if let Some(end) = head.last_chunk_mut() {
        *end = crc;
    }
    head
}

/// Returns version and erases of a sector's head; `None` = it is none.
pub(crate) fn read_sector_head(head: &[u8; SLOT_BYTES]) -> Option<(u16, u32)> {
    let [m, n, o, p, v, w, a, b, c, d, _, _, crc @ ..] = *head;
    let body = head.first_chunk::<12>()?;
    ([m, n, o, p] == MAGIC && CRC.checksum(body) == u32::from_le_bytes(crc))
        .then(|| (u16::from_le_bytes([v, w]), u32::from_le_bytes([a, b, c, d])))
}

/// Returns whether nothing was programmed here.
pub(crate) fn is_blank(bytes: &[u8]) -> bool {
    bytes.iter().all(|byte| *byte == BLANK)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_tells_its_version_and_erases_and_no_changed_bit_passes() {
        let head = sector_head(0x0102_0304);
        assert_eq!(read_sector_head(&head), Some((FORMAT, 0x0102_0304)));
        for bit in 0..8 * SLOT_BYTES {
            let mut other = head;
            other[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(read_sector_head(&other), None, "bit {bit}");
        }
        assert_eq!([read_sector_head(&[BLANK; SLOT_BYTES]), read_sector_head(&ZEROS)], [None; 2]);
    }

    #[test]
    fn every_length_comes_back_and_no_changed_bit_passes() {
        for len in 0..=MAX_PAYLOAD {
            let payload: [u8; MAX_PAYLOAD] = core::array::from_fn(|i| (i * 7 + len) as u8);
            let mut page = [0; PAGE_BYTES];
            let bytes = write_record(&mut page, 9, 0x00AB_CDEF, &payload[..len]).expect("it has room");
            let head = Head::read(page.first_chunk().expect("a slot")).expect("a record");
            assert_eq!((head.key, head.len, head.generation), (9, len, 0x00AB_CDEF));
            assert_eq!(head.slots() * SLOT_BYTES, bytes);
            assert!(head.is_whole(&page) && page[HEADER..HEADER + len] == payload[..len]);
            for bit in (0..8 * (HEADER + len)).step_by(if len < 20 { 1 } else { 41 }) {
                let mut other = page;
                other[bit / 8] ^= 1 << (bit % 8);
                let head = Head::read(other.first_chunk().expect("a slot"));
                assert!(head.is_none_or(|head| !head.is_whole(&other)), "{len} bytes, bit {bit}");
            }
        }
    }

    #[test]
    fn what_is_too_long_or_has_no_key_is_refused() {
        let mut page = [0; PAGE_BYTES];
        assert_eq!(write_record(&mut page, 1, 0, &[0; MAX_PAYLOAD + 1]), None);
        assert_eq!([0, 0xFF].map(|key| write_record(&mut page, key, 0, &[])), [None; 2]);
    }
}
