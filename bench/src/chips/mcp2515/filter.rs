//! MCP2515 message acceptance: which buffer takes a frame, and by which filter.
//!
//! Pure functions of the registers. Source: DS20001801J, chapter 4.5 and figure 4-3 (flow chart), table 4-2 (truth
//! table), register 4-1 and 4-2 (RXM).

use super::codec::{IDE, IdRegisters, extended_bits, standard_bits};
use crate::can::{Frame, Id};

/// What RXM says about a receive buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operation {
    /// 00: masks and filters.
    Filter,
    /// 01: reserved since revision J of the datasheet, standard identifiers only before.
    FilterStandard,
    /// 10: reserved since revision J of the datasheet, extended identifiers only before.
    FilterExtended,
    /// 11: any message.
    Any,
}

impl Operation {
    /// Decodes RXBnCTRL.
    pub(super) fn of(control: u8) -> Self {
        match control >> 5 & 0b11 {
            0b00 => Self::Filter,
            0b01 => Self::FilterStandard,
            0b10 => Self::FilterExtended,
            _ => Self::Any,
        }
    }

    fn admits(self, frame: &Frame) -> bool {
        match self {
            Self::Filter | Self::Any => true,
            Self::FilterStandard => !frame.id.is_extended(),
            Self::FilterExtended => frame.id.is_extended(),
        }
    }
}

/// Whether `filter` under `mask` accepts `frame`.
pub(super) fn accepts(mask: IdRegisters, filter: IdRegisters, frame: &Frame) -> bool {
    match (frame.id, filter[1] & IDE != 0) {
        (Id::Extended(id), true) => (id.raw() ^ extended_bits(filter)) & extended_bits(mask) == 0,
        (Id::Standard(id), false) => {
            // EID15..8 and EID7..0 are held against the first two data bytes; a byte that was not sent passes
            // only an open mask.
            let data = frame.payload();
            let byte_passes = |index: usize| {
                let (mask, filter) = (mask[2 + index], filter[2 + index]);
                data.get(index).map_or(mask == 0, |byte| (byte ^ filter) & mask == 0)
            };
            (id.raw() ^ standard_bits(filter)) & standard_bits(mask) == 0 && byte_passes(0) && byte_passes(1)
        }
        _ => false,
    }
}

/// The first of `filters` that lets `frame` into a buffer; 0 when the buffer takes any message.
pub(super) fn hit(
    operation: Operation,
    mask: IdRegisters,
    filters: &[IdRegisters],
    frame: &Frame,
) -> Option<usize> {
    match operation {
        Operation::Any => Some(0),
        _ if !operation.admits(frame) => None,
        _ => filters.iter().position(|&filter| accepts(mask, filter, frame)),
    }
}
