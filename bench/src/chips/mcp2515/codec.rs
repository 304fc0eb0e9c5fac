//! MCP2515 buffer layout: thirteen registers to a frame and back.
//!
//! SIDH, SIDL, EID8, EID0, DLC, D0..D7. Pure. Source: DS20001801J, registers 3-3 to 3-8 and 4-4 to 4-9.

use crate::can::{Frame, Id};

/// SIDL.EXIDE / SIDL.IDE.
pub(super) const IDE: u8 = 1 << 3;
/// SIDL.SRR of a receive buffer: remote frame with a standard identifier.
const SRR: u8 = 1 << 4;
/// DLC.RTR.
const RTR: u8 = 1 << 6;

/// Identifier registers in the order SIDH, SIDL, EID8, EID0.
pub(super) type IdRegisters = [u8; 4];

/// Returns the 11 bits of the base identifier (SIDH, SIDL).
pub(super) fn standard_bits(regs: IdRegisters) -> u16 {
    u16::from(regs[0]) << 3 | u16::from(regs[1]) >> 5
}

/// The 29 extended bits: the standard bits on top, then EID17..EID0.
pub(super) fn extended_bits(regs: IdRegisters) -> u32 {
    u32::from(standard_bits(regs)) << 18
        | u32::from(regs[1] & 0b11) << 16
        | u32::from(regs[2]) << 8
        | u32::from(regs[3])
}

/// The frame that a transmit buffer describes. A length code above eight sends eight bytes.
pub(super) fn transmit_frame(regs: [u8; 13]) -> Option<Frame> {
    let id = [regs[0], regs[1], regs[2], regs[3]];
    let id =
        if regs[1] & IDE != 0 { Id::extended(extended_bits(id)) } else { Id::standard(standard_bits(id)) }?;
    let dlc = regs[4] & 0x0F;
    if regs[4] & RTR != 0 {
        return Some(Frame::new_remote(id, dlc));
    }
    let length = usize::from(dlc.min(8));
    let mut frame = Frame::new(id, &regs[5..5 + length])?;
    frame.dlc = dlc;
    Some(frame)
}

/// Writes `frame` into a receive buffer. Data registers beyond its length, and the extended identifier registers of a
/// standard frame, keep what they held: a driver must not look at them.
pub(super) fn store_received(frame: &Frame, regs: &mut [u8]) {
    match frame.id {
        Id::Standard(id) => {
            regs[0] = (id.raw() >> 3) as u8;
            regs[1] = (id.raw() << 5) as u8 | if frame.remote { SRR } else { 0 };
            regs[4] = frame.dlc & 0x0F;
        }
        Id::Extended(id) => {
            let raw = id.raw();
            regs[0] = (raw >> 21) as u8;
            // SRR is on the wire as a recessive bit and means nothing here.
            regs[1] = (raw >> 13) as u8 & 0xE0 | SRR | IDE | (raw >> 16) as u8 & 0b11;
            regs[2] = (raw >> 8) as u8;
            regs[3] = raw as u8;
            regs[4] = frame.dlc & 0x0F | if frame.remote { RTR } else { 0 };
        }
    }
    regs[5..5 + frame.data_len()].copy_from_slice(frame.payload());
}
