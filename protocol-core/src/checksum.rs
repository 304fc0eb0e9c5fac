//! Check bytes: one byte of a frame that is made of all the others.
//!
//! Which message has one, and of which kind, stands in `vehicle.toml`. Refuses to know identifiers: a checksum that
//! mixes them in (AUTOSAR E2E) is not supported. Source: SAE J1850 for the CRC.

use crc::{CRC_8_SAE_J1850, Crc, NoTable};

// Bit by bit: one frame is 56 rounds, a table would be 256 bytes.
const CRC8: Crc<u8, NoTable> = Crc::<u8, NoTable>::new(&CRC_8_SAE_J1850);

/// How the check byte is made of the other bytes, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChecksumKind {
    /// Polynomial 0x1D, start 0xFF, inverted at the end.
    Crc8SaeJ1850,
    /// Their sum, carries dropped.
    Sum8,
    /// Their exclusive or.
    Xor8,
}

/// The check byte of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checksum {
    /// The check byte, 0 to 7.
    pub byte: u8,
    /// Bytes of the message, the check byte among them, 1 to 8.
    pub len: u8,
    /// How it is made.
    pub kind: ChecksumKind,
}

impl Checksum {
    /// Returns what the check byte must be.
    pub fn of(self, data: &[u8; 8]) -> u8 {
        let others = || {
            let bytes = data.iter().take(usize::from(self.len)).enumerate();
            bytes.filter(|(at, _)| *at != usize::from(self.byte)).map(|(_, byte)| *byte)
        };
        match self.kind {
            ChecksumKind::Crc8SaeJ1850 => {
                let mut digest = CRC8.digest();
                others().for_each(|byte| digest.update(&[byte]));
                digest.finalize()
            }
            ChecksumKind::Sum8 => others().fold(0, u8::wrapping_add),
            ChecksumKind::Xor8 => others().fold(0, |all, byte| all ^ byte),
        }
    }

    /// Returns whether the check byte is right.
    pub fn holds(self, data: &[u8; 8]) -> bool {
        data.get(usize::from(self.byte)) == Some(&self.of(data))
    }

    /// Writes the check byte; to be done last.
    pub fn seal(self, data: &mut [u8; 8]) {
        let sum = self.of(data);
        if let Some(byte) = data.get_mut(usize::from(self.byte)) {
            *byte = sum;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_check_bytes_are_those_worked_out_by_hand() {
        let of = |kind, data| Checksum { byte: 7, len: 8, kind }.of(data);
        let data = [0x01, 0x02, 0xF0, 0x20, 0, 0, 0, 0xEE];
        assert_eq!(of(ChecksumKind::Sum8, &data), 0x13, "0x113 without its carry");
        assert_eq!(of(ChecksumKind::Xor8, &data), 0xD3);
        // The check value of the catalogue of CRCs: the digits 1 to 9 give 0x4B. Four zero bytes give 0x59 (AUTOSAR).
        assert_eq!(CRC8.checksum(b"123456789"), 0x4B);
        assert_eq!(Checksum { byte: 0, len: 5, kind: ChecksumKind::Crc8SaeJ1850 }.of(&[0; 8]), 0x59);
    }

    #[test]
    fn a_sealed_frame_holds_and_every_flipped_bit_is_found() {
        for kind in [ChecksumKind::Crc8SaeJ1850, ChecksumKind::Sum8, ChecksumKind::Xor8] {
            for (byte, len) in [(7, 8), (0, 8), (3, 4)] {
                let checksum = Checksum { byte, len, kind };
                let mut data = [0x12, 0x34, 0x56, 0x78, 0x9A, 0xBC, 0xDE, 0xF0];
                checksum.seal(&mut data);
                assert!(checksum.holds(&data));
                for bit in 0..usize::from(len) * 8 {
                    let mut damaged = data;
                    damaged[bit / 8] ^= 1 << (bit % 8);
                    assert!(!checksum.holds(&damaged), "{kind:?}, bit {bit}");
                }
            }
        }
    }
}
