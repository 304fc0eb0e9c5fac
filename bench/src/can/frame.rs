//! Classical CAN frames as the bus carries them.
//!
//! Owns identifiers, the remote flag, the raw length code and the payload. A length code of 9..=15 is legal on the wire
//! and means eight bytes, so the code is kept as sent. Source: Bosch CAN 2.0 part B, chapter 3.1.

use protocol_core::{CanFrame, CanId};
use std::fmt;

/// An 11-bit identifier.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StandardId(u16);

impl StandardId {
    /// The highest 11-bit identifier.
    pub const MAX: Self = Self(0x7FF);

    /// An identifier, or `None` above 0x7FF.
    pub const fn new(raw: u16) -> Option<Self> {
        if raw <= Self::MAX.0 { Some(Self(raw)) } else { None }
    }

    /// The 11 bits.
    pub const fn raw(self) -> u16 {
        self.0
    }
}

/// A 29-bit identifier.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ExtendedId(u32);

impl ExtendedId {
    /// The highest 29-bit identifier.
    pub const MAX: Self = Self(0x1FFF_FFFF);

    /// An identifier, or `None` above 0x1FFF_FFFF.
    pub const fn new(raw: u32) -> Option<Self> {
        if raw <= Self::MAX.0 { Some(Self(raw)) } else { None }
    }

    /// The 29 bits.
    pub const fn raw(self) -> u32 {
        self.0
    }
}

/// A frame identifier of either kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Id {
    /// 11 bits.
    Standard(StandardId),
    /// 29 bits.
    Extended(ExtendedId),
}

impl Id {
    /// A standard identifier, or `None` above 0x7FF.
    pub const fn standard(raw: u16) -> Option<Self> {
        match StandardId::new(raw) {
            Some(id) => Some(Self::Standard(id)),
            None => None,
        }
    }

    /// An extended identifier, or `None` above 0x1FFF_FFFF.
    pub const fn extended(raw: u32) -> Option<Self> {
        match ExtendedId::new(raw) {
            Some(id) => Some(Self::Extended(id)),
            None => None,
        }
    }

    /// The identifier bits, right-aligned.
    pub const fn raw(self) -> u32 {
        match self {
            Self::Standard(id) => id.0 as u32,
            Self::Extended(id) => id.0,
        }
    }

    /// True for a 29-bit identifier.
    pub const fn is_extended(self) -> bool {
        matches!(self, Self::Extended(_))
    }
}

/// One data or remote frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Frame {
    /// Who is it about.
    pub id: Id,
    /// A remote frame asks for data and carries none.
    pub remote: bool,
    /// The length code as sent, 0..=15; 9..=15 mean eight bytes.
    pub dlc: u8,
    /// The payload; bytes from [`Frame::data_len`] on are zero and not sent.
    pub data: [u8; 8],
}

impl Frame {
    /// A data frame; `None` if `payload` is longer than eight bytes.
    pub fn new(id: Id, payload: &[u8]) -> Option<Self> {
        let mut data = [0; 8];
        data.get_mut(..payload.len())?.copy_from_slice(payload);
        Some(Self { id, remote: false, dlc: u8::try_from(payload.len()).ok()?, data })
    }

    /// A remote frame that asks for `dlc` bytes (only the low four bits are sent).
    pub const fn new_remote(id: Id, dlc: u8) -> Self {
        Self { id, remote: true, dlc: dlc & 0x0F, data: [0; 8] }
    }

    /// Number of payload bytes on the wire, 0..=8.
    pub const fn data_len(&self) -> usize {
        match (self.remote, self.dlc) {
            (true, _) => 0,
            (false, dlc) if dlc > 8 => 8,
            (false, dlc) => dlc as usize,
        }
    }

    /// The payload bytes on the wire.
    pub fn payload(&self) -> &[u8] {
        &self.data[..self.data_len()]
    }

    /// The frame as the codecs have it; `None` for a remote request, which carries no signals.
    pub fn data_frame(&self) -> Option<CanFrame> {
        let id = match self.id {
            Id::Standard(id) => CanId::standard(id.raw()),
            Id::Extended(id) => CanId::extended(id.raw()),
        };
        if self.remote { None } else { CanFrame::from_slice(id, self.payload()) }
    }

    /// The arbitration field as one number, first bit on top: the lower number wins the bus.
    ///
    /// Base identifier, then RTR and IDE of a standard frame against SRR, IDE, the low 18 bits and RTR of an extended one.
    pub const fn arbitration_key(&self) -> u32 {
        match self.id {
            Id::Standard(id) => (id.0 as u32) << 21 | (self.remote as u32) << 20,
            Id::Extended(id) => (id.0 >> 18) << 21 | 0b11 << 19 | (id.0 & 0x3_FFFF) << 1 | self.remote as u32,
        }
    }
}

impl From<&CanFrame> for Frame {
    fn from(frame: &CanFrame) -> Self {
        let (bits, data) = (frame.id.bits(), *frame.padded());
        // A packed identifier has no more bits than its kind allows.
        let id = if frame.id.is_extended() {
            Id::Extended(ExtendedId(bits))
        } else {
            Id::Standard(StandardId(bits as u16))
        };
        Self { id, remote: false, dlc: frame.bytes().len() as u8, data }
    }
}

/// `123#DEADBEEF`, `18FEF100#R8`: the notation of candump logs. A length code of 9 to 15 follows the eight bytes that it
/// means: `123#0102030405060708_F`, `123#R8_9`.
impl fmt::Display for Frame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.id {
            Id::Standard(id) => write!(f, "{:03X}#", id.0)?,
            Id::Extended(id) => write!(f, "{:08X}#", id.0)?,
        }
        if self.remote {
            write!(f, "R{}", self.dlc.min(8))?;
        }
        self.payload().iter().try_for_each(|byte| write!(f, "{byte:02X}"))?;
        if self.dlc > 8 { write!(f, "_{:X}", self.dlc) } else { Ok(()) }
    }
}
