//! How many bits a frame takes on the wire, to the bit.
//!
//! Builds start of frame, arbitration, control, data and CRC-15, counts the stuff bits over all of them and adds the
//! fixed tail: CRC delimiter, ACK slot and delimiter, end of frame, intermission.
//! Source: Bosch CAN 2.0 part B, chapters 3.1.1 (fields, CRC) and 5 (stuffing).

use super::frame::{Frame, Id};

/// CRC delimiter.
const CRC_DELIMITER: u32 = 1;
/// ACK slot.
const ACK_SLOT: u32 = 1;
/// ACK delimiter.
const ACK_DELIMITER: u32 = 1;
/// End of frame.
const EOF: u32 = 7;
/// Intermission between two frames.
pub const INTERMISSION: u32 = 3;
/// A transmitter puts a stuff bit after this many equal bits.
const STUFF_AFTER: u32 = 5;
/// x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1.
const CRC_POLYNOMIAL: u16 = 0x4599;

/// The part of a frame that is stuffed, without stuff bits: at most 118 bits, the last bit sent is bit 0.
#[derive(Clone, Copy, Debug)]
struct Raw {
    bits: u128,
    count: u32,
}

impl Raw {
    fn push(&mut self, value: u128, width: u32) {
        self.bits = self.bits << width | value;
        self.count += width;
    }

    /// Bit `index` in the order of sending.
    fn bit(&self, index: u32) -> bool {
        self.bits >> (self.count - 1 - index) & 1 == 1
    }
}

/// CRC-15 over the first `count` bits of `raw`.
fn crc15(raw: &Raw) -> u16 {
    (0..raw.count).fold(0u16, |crc, index| {
        let feedback = raw.bit(index) != (crc >> 14 & 1 == 1);
        let shifted = crc << 1 & 0x7FFF;
        if feedback { shifted ^ CRC_POLYNOMIAL } else { shifted }
    })
}

/// Start of frame to the end of the CRC sequence.
fn raw_bits(frame: &Frame) -> Raw {
    let mut raw = Raw { bits: 0, count: 0 };
    raw.push(0, 1); // SOF
    match frame.id {
        Id::Standard(id) => {
            raw.push(u128::from(id.raw()), 11);
            raw.push(u128::from(frame.remote), 1); // RTR
            raw.push(0, 2); // IDE, r0
        }
        Id::Extended(id) => {
            raw.push(u128::from(id.raw() >> 18), 11);
            raw.push(0b11, 2); // SRR, IDE
            raw.push(u128::from(id.raw() & 0x3_FFFF), 18);
            raw.push(u128::from(frame.remote), 1); // RTR
            raw.push(0, 2); // r1, r0
        }
    }
    raw.push(u128::from(frame.dlc & 0x0F), 4);
    for &byte in frame.payload() {
        raw.push(u128::from(byte), 8);
    }
    let crc = crc15(&raw);
    raw.push(u128::from(crc), 15);
    raw
}

/// Length of the first `count` bits of `raw` once stuffed.
fn stuffed(raw: &Raw, count: u32) -> u32 {
    let mut length = 0;
    let mut run = 0;
    let mut last = None;
    for index in 0..count {
        let bit = raw.bit(index);
        run = if last == Some(bit) { run + 1 } else { 1 };
        last = Some(bit);
        length += 1;
        if run == STUFF_AFTER {
            length += 1;
            last = Some(!bit);
            run = 1;
        }
    }
    length
}

/// Where the milestones of one frame lie, in bits after the falling edge of its start of frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameBits {
    /// End of the stuffed part: the last bit of the CRC sequence or the stuff bit behind it.
    pub crc_end: u32,
}

impl FrameBits {
    /// Measures `frame`.
    pub fn of(frame: &Frame) -> Self {
        let raw = raw_bits(frame);
        Self { crc_end: stuffed(&raw, raw.count) }
    }

    /// End of the ACK slot: the transmitter knows whether anybody has heard it.
    pub const fn ack_end(self) -> u32 {
        self.crc_end + CRC_DELIMITER + ACK_SLOT
    }

    /// End of the ACK delimiter: receivers that saw a CRC error start their error flag here.
    pub const fn ack_delimiter_end(self) -> u32 {
        self.ack_end() + ACK_DELIMITER
    }

    /// End of the last but one bit of the end of frame: the frame is valid for receivers.
    pub const fn received(self) -> u32 {
        self.ack_delimiter_end() + EOF - 1
    }

    /// End of the end of frame: the frame is valid for its transmitter.
    pub const fn sent(self) -> u32 {
        self.ack_delimiter_end() + EOF
    }

    /// With the intermission: the next frame may start.
    pub const fn total(self) -> u32 {
        self.sent() + INTERMISSION
    }
}

/// The bit, counted from the start of frame of `winner`, at whose end `loser` knows that they differ.
///
/// `None` if both frames are the same on the wire.
pub fn first_difference(winner: &Frame, loser: &Frame) -> Option<u32> {
    let (ours, theirs) = (raw_bits(winner), raw_bits(loser));
    let common = (0..ours.count.min(theirs.count)).find(|&index| ours.bit(index) != theirs.bit(index))?;
    Some(stuffed(&ours, common + 1))
}

/// The CRC-15 sequence of `frame`.
pub fn crc(frame: &Frame) -> u16 {
    let raw = raw_bits(frame);
    u16::try_from(raw.bits & 0x7FFF).unwrap_or(0)
}
