//! Identifiers and frames: packed and bare, printed, in the words of embedded-can.

use embedded_can::{ExtendedId, Frame, Id, StandardId};
use protocol_core::{CanFrame, CanId};

/// Packed, bare, as candump prints it; by hand from the specification: 11 bits in 3 digits, 29 bits in 8.
const IDS: [(CanId, u32, u32, &str); 6] = [
    (CanId::standard(0), 0, 0, "000"),
    (CanId::standard(0x7F), 0x7F, 0x7F, "07F"),
    (CanId::standard(0x7FF), 0x7FF, 0x7FF, "7FF"),
    (CanId::extended(0), 0x8000_0000, 0, "00000000"),
    (CanId::extended(0x7FF), 0x8000_07FF, 0x7FF, "000007FF"),
    (CanId::extended(0x1FFF_FFFF), 0x9FFF_FFFF, 0x1FFF_FFFF, "1FFFFFFF"),
];

#[test]
fn bus_11_an_identifier_is_the_same_packed_bare_and_printed() {
    for (id, packed, bare, text) in IDS {
        assert_eq!((id.packed(), id.bits(), id.is_extended()), (packed, bare, text.len() == 8), "{text}");
        assert_eq!(CanId::from_packed(packed), id, "{text}");
        assert_eq!((format!("{id}"), format!("{id:?}")), (text.to_owned(), text.to_owned()));
    }
}

#[test]
fn bus_11_an_11_bit_identifier_is_never_the_29_bit_one_of_the_same_number() {
    for (place, (id, ..)) in IDS.iter().enumerate() {
        for (other, ..) in &IDS[..place] {
            assert_ne!(id, other);
        }
    }
}

#[test]
fn bits_that_an_identifier_does_not_have_are_dropped() {
    assert_eq!(CanId::standard(0xFFFF), CanId::standard(0x7FF));
    assert_eq!(CanId::extended(0xFFFF_FFFF), CanId::extended(0x1FFF_FFFF));
    assert_eq!(CanId::from_packed(0xFFFF_FFFF), CanId::extended(0x1FFF_FFFF));
    assert_eq!(CanId::from_packed(0x7FFF_FFFF), CanId::standard(0x7FF));
}

#[test]
fn embedded_can_reads_the_same_identifier() {
    for (id, _, bare, text) in IDS {
        let foreign = match text.len() {
            3 => Id::from(StandardId::new(bare as u16).expect("11 bits")),
            _ => Id::from(ExtendedId::new(bare).expect("29 bits")),
        };
        assert_eq!((CanId::from(foreign), Id::from(id)), (id, foreign), "{text}");
    }
}

#[test]
fn a_frame_keeps_its_bytes_and_pads_with_zeros() {
    let data = [1, 2, 3, 4, 5, 6, 7, 8, 9];
    for len in 0..=8 {
        let frame = CanFrame::from_slice(CanId::standard(5), &data[..len]).expect("at most 8 bytes");
        assert_eq!((usize::from(frame.len()), frame.bytes()), (len, &data[..len]));
        let (sent, rest) = frame.padded().split_at(len);
        assert!(sent == &data[..len] && rest.iter().all(|byte| *byte == 0));
    }
    assert_eq!(CanFrame::from_slice(CanId::standard(5), &data), None, "9 bytes are no classic frame");
    let full = CanFrame::full(CanId::standard(5), [7; 8]);
    assert_eq!(Some(full), CanFrame::from_slice(CanId::standard(5), &[7; 8]));
}

#[test]
fn embedded_can_reads_the_same_frame_and_makes_no_remote_frames() {
    for id in [CanId::standard(0x123), CanId::extended(0x123)] {
        let frame = <CanFrame as Frame>::new(id, &[4, 5, 6]).expect("3 bytes");
        assert_eq!(Some(frame), CanFrame::from_slice(id, &[4, 5, 6]));
        assert_eq!((Frame::id(&frame), frame.dlc(), frame.data()), (Id::from(id), 3, &[4, 5, 6][..]));
        assert_eq!((frame.is_extended(), frame.is_standard()), (id.is_extended(), !id.is_extended()));
        assert!(frame.is_data_frame() && !frame.is_remote_frame());
        assert_eq!(<CanFrame as Frame>::new_remote(id, 3), None);
        assert_eq!(<CanFrame as Frame>::new(id, &[0; 9]), None);
    }
}
