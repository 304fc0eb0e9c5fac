//! One classic CAN data frame and its identifier.
//!
//! Remote frames carry no signals and are not represented: the driver counts and drops them.
//! Source: Bosch CAN Specification 2.0 parts A and B; the packed form of [`CanId`] is the one DBC files use.

use embedded_can::{ExtendedId, Id, StandardId};

/// An 11-bit or 29-bit identifier in the packed form of a DBC file: bit 31 set = 29-bit.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CanId(u32);

impl CanId {
    const EXTENDED: u32 = 1 << 31;

    /// A 29-bit identifier; bits above 28 are dropped.
    pub const fn extended(id: u32) -> Self {
        Self(id & 0x1FFF_FFFF | Self::EXTENDED)
    }

    /// An 11-bit identifier; bits above 10 are dropped.
    pub const fn standard(id: u16) -> Self {
        Self(id as u32 & 0x7FF)
    }

    /// Returns the identifier from its packed form (bit 31 = 29-bit), as printed in DBC files.
    pub const fn from_packed(packed: u32) -> Self {
        if packed & Self::EXTENDED != 0 { Self::extended(packed) } else { Self::standard(packed as u16) }
    }

    /// Returns the packed form (bit 31 = 29-bit).
    pub const fn packed(self) -> u32 {
        self.0
    }

    /// Returns the bare identifier, 11 or 29 bits.
    pub const fn bits(self) -> u32 {
        self.0 & !Self::EXTENDED
    }

    /// Returns what all frames of a J1939 group have in common: the identifier with priority 0 and source 0xFE, and with
    /// destination 0xFF where it names one; `None` for 11 bits. (SAE J1939-21: a group below 0xF000 is sent to somebody.)
    pub const fn group(self) -> Option<Self> {
        if !self.is_extended() {
            return None;
        }
        let is_for_one = (self.0 >> 16 & 0xFF) < 0xF0;
        let to = if is_for_one { 0xFF00 } else { self.0 & 0xFF00 };
        Some(Self::extended(self.0 & 0x03FF_0000 | to | 0xFE))
    }

    /// Returns whether the identifier has 29 bits.
    pub const fn is_extended(self) -> bool {
        self.0 & Self::EXTENDED != 0
    }
}

impl From<Id> for CanId {
    fn from(id: Id) -> Self {
        match id {
            Id::Standard(id) => Self::standard(id.as_raw()),
            Id::Extended(id) => Self::extended(id.as_raw()),
        }
    }
}

impl From<CanId> for Id {
    fn from(id: CanId) -> Self {
        if id.is_extended() {
            Self::Extended(ExtendedId::new(id.bits()).unwrap_or(ExtendedId::MAX))
        } else {
            Self::Standard(StandardId::new(id.bits() as u16).unwrap_or(StandardId::MAX))
        }
    }
}

/// Shows as candump prints it: 3 digits for 11 bits, 8 digits for 29 bits.
impl core::fmt::Display for CanId {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        if self.is_extended() { write!(f, "{:08X}", self.bits()) } else { write!(f, "{:03X}", self.bits()) }
    }
}

impl core::fmt::Debug for CanId {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        core::fmt::Display::fmt(self, f)
    }
}

/// A classic CAN data frame: identifier and 0 to 8 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CanFrame {
    /// Identifier.
    pub id: CanId,
    len: u8,
    data: [u8; 8],
}

impl CanFrame {
    /// Returns a frame with up to 8 bytes of `data`, `None` if there are more.
    pub fn from_slice(id: CanId, data: &[u8]) -> Option<Self> {
        let mut bytes = [0; 8];
        bytes.get_mut(..data.len())?.copy_from_slice(data);
        Some(Self { id, len: data.len() as u8, data: bytes })
    }

    /// Returns a full frame of 8 bytes.
    pub const fn full(id: CanId, data: [u8; 8]) -> Self {
        Self { id, len: 8, data }
    }

    /// Returns the bytes that were sent.
    pub fn bytes(&self) -> &[u8] {
        &self.data[..usize::from(self.len.min(8))]
    }

    /// Returns all 8 bytes; those beyond [`Self::len`] are zero.
    pub const fn padded(&self) -> &[u8; 8] {
        &self.data
    }

    /// Returns the number of bytes that were sent, 0 to 8.
    #[allow(clippy::len_without_is_empty)]
    pub const fn len(&self) -> u8 {
        self.len
    }
}

impl embedded_can::Frame for CanFrame {
    fn new(id: impl Into<Id>, data: &[u8]) -> Option<Self> {
        Self::from_slice(CanId::from(id.into()), data)
    }

    fn new_remote(_: impl Into<Id>, _: usize) -> Option<Self> {
        None
    }

    fn is_extended(&self) -> bool {
        self.id.is_extended()
    }

    fn is_remote_frame(&self) -> bool {
        false
    }

    fn id(&self) -> Id {
        self.id.into()
    }

    fn dlc(&self) -> usize {
        usize::from(self.len)
    }

    fn data(&self) -> &[u8] {
        self.bytes()
    }
}
