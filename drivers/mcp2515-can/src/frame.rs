//! The 13 bytes of a message buffer: identifier, length, data.
//!
//! Pure, in both directions, for any type with the `embedded_can::Frame` trait.
//! Source: DS20001801 registers 3-3 to 3-8 (transmit) and 4-4 to 4-9 (receive); both have the same layout but for the
//! remote bit of standard frames.

use crate::regs::{DLC, IDE, RTR, SRR};
use embedded_can::{ExtendedId, Frame, Id, StandardId};

/// SIDH, SIDL, EID8, EID0, DLC and 8 data bytes, as READ RX BUFFER gives and LOAD TX BUFFER takes them.
pub type Buffer = [u8; 13];

/// What a receive buffer held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Received<F> {
    /// A data frame.
    Data(F),
    /// A remote frame: no data, of no use to a listener.
    Remote,
}

/// Decodes a receive buffer. A length code above 8 means 8 bytes (ISO 11898-1); `F` must take 8 bytes.
#[inline(always)]
pub fn decode<F: Frame>(buffer: &Buffer) -> Received<F> {
    let [sidh, sidl, eid8, eid0, dlc, ref data @ ..] = *buffer;
    let sid = u16::from(sidh) << 3 | u16::from(sidl) >> 5;
    let (id, remote) = if sidl & IDE != 0 {
        let bits = u32::from(sid) << 18 | u32::from(sidl & 3) << 16 | u32::from(eid8) << 8 | u32::from(eid0);
        (ExtendedId::new(bits).map(Id::Extended), dlc & RTR != 0)
    } else {
        (StandardId::new(sid).map(Id::Standard), sidl & SRR != 0)
    };
    let len = usize::from(dlc & DLC).min(data.len());
    match id {
        Some(id) if !remote => F::new(id, &data[..len]).map_or(Received::Remote, Received::Data),
        _ => Received::Remote,
    }
}

/// Returns SIDH, SIDL, EID8 and EID0 of an identifier, as transmit buffers and filters hold it.
#[inline(always)]
pub fn id_registers(id: Id) -> [u8; 4] {
    match id {
        Id::Standard(id) => {
            let bits = id.as_raw();
            [(bits >> 3) as u8, (bits << 5) as u8, 0, 0]
        }
        Id::Extended(id) => {
            let bits = id.as_raw();
            let sidl = (bits >> 13) as u8 & 0xE0 | IDE | (bits >> 16) as u8 & 3;
            [(bits >> 21) as u8, sidl, (bits >> 8) as u8, bits as u8]
        }
    }
}

/// Encodes a data frame; returns the buffer and how many bytes of it matter (5 to 13).
pub fn encode(frame: &impl Frame) -> (Buffer, usize) {
    let mut buffer = [0; 13];
    buffer[..4].copy_from_slice(&id_registers(frame.id()));
    let data = frame.data();
    let len = data.len().min(8);
    buffer[4] = len as u8;
    buffer[5..5 + len].copy_from_slice(&data[..len]);
    (buffer, 5 + len)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use proptest::prelude::*;
    use std::vec::Vec;

    #[derive(Clone, Debug, PartialEq, Eq)]
    struct TestFrame(Id, Vec<u8>);

    impl Frame for TestFrame {
        fn new(id: impl Into<Id>, data: &[u8]) -> Option<Self> {
            (data.len() <= 8).then(|| Self(id.into(), data.into()))
        }
        fn new_remote(_: impl Into<Id>, _: usize) -> Option<Self> {
            None
        }
        fn is_extended(&self) -> bool {
            matches!(self.0, Id::Extended(_))
        }
        fn is_remote_frame(&self) -> bool {
            false
        }
        fn id(&self) -> Id {
            self.0
        }
        fn dlc(&self) -> usize {
            self.1.len()
        }
        fn data(&self) -> &[u8] {
            &self.1
        }
    }

    fn extended(bits: u32) -> Id {
        Id::Extended(ExtendedId::new(bits).unwrap())
    }

    // Worked out by hand: 0x18FF4D17 = 11000111111 11 01001101 00010111 -> SID 0x63F, EID17:16 = 11.
    #[test]
    fn a_29_bit_frame_is_laid_out_as_the_datasheet_says() {
        let (buffer, len) = encode(&TestFrame(extended(0x18FF_4D17), [1, 2, 3].into()));
        assert_eq!((&buffer[..len], len), (&[0xC7, 0xEB, 0x4D, 0x17, 3, 1, 2, 3][..], 8));
    }

    #[test]
    fn an_11_bit_frame_is_laid_out_as_the_datasheet_says() {
        let id = Id::Standard(StandardId::new(0x123).unwrap());
        assert_eq!(encode(&TestFrame(id, [0xAA].into())).0[..6], [0x24, 0x60, 0, 0, 1, 0xAA]);
    }

    #[test]
    fn a_length_code_above_8_reads_8_bytes() {
        for dlc in 9..=15 {
            let buffer = [0x24, 0x60, 0, 0, dlc, 1, 2, 3, 4, 5, 6, 7, 8];
            let Received::Data(TestFrame(_, data)) = decode(&buffer) else { panic!("dropped") };
            assert_eq!(data, [1, 2, 3, 4, 5, 6, 7, 8]);
        }
    }

    #[test]
    fn remote_frames_of_both_kinds_are_told_apart_from_data() {
        assert_eq!(
            decode::<TestFrame>(&[0x24, 0x60 | SRR, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
            Received::Remote
        );
        assert_eq!(decode::<TestFrame>(&[0xC7, 0xEB, 0, 0, RTR, 0, 0, 0, 0, 0, 0, 0, 0]), Received::Remote);
        // In an extended frame SRR is always recessive and means nothing.
        assert!(matches!(
            decode::<TestFrame>(&[0xC7, 0xEB | SRR, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
            Received::Data(_)
        ));
    }

    proptest! {
        #[test]
        fn what_is_encoded_decodes_to_itself(
            wide in any::<bool>(),
            bits in 0u32..0x2000_0000,
            data in proptest::collection::vec(any::<u8>(), 0..=8),
        ) {
            let id = if wide { extended(bits) } else { Id::Standard(StandardId::new(bits as u16 & 0x7FF).unwrap()) };
            let frame = TestFrame(id, data);
            prop_assert_eq!(decode(&encode(&frame).0), Received::Data(frame));
        }

        #[test]
        fn no_buffer_panics(buffer in any::<[u8; 13]>()) {
            decode::<TestFrame>(&buffer);
        }
    }
}
