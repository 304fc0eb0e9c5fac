//! The length of a CAN frame on the wire, against a bit-string written from the standard and a CRC of another hand.

use bench::can::bits::{FrameBits, crc, first_difference};
use bench::can::{Frame, Id};
use proptest::prelude::*;

/// The frame from start of frame to the end of the data, one character per bit, no stuffing.
fn naive_body(frame: &Frame) -> String {
    let rtr = if frame.remote { "1" } else { "0" };
    let head = match frame.id {
        Id::Standard(id) => format!("0{:011b}{rtr}00", id.raw()),
        Id::Extended(id) => {
            let id = format!("{:029b}", id.raw());
            format!("0{}11{}{rtr}00", &id[..11], &id[11..])
        }
    };
    let data: String = frame.payload().iter().map(|byte| format!("{byte:08b}")).collect();
    format!("{head}{:04b}{data}", frame.dlc)
}

/// CRC-15/CAN of the CRC catalogue. Leading zeros change nothing, so the bits are padded to whole bytes.
fn catalogue_crc(body: &str) -> u16 {
    let padded = format!("{}{body}", "0".repeat(body.len().next_multiple_of(8) - body.len()));
    let bytes: Vec<u8> = padded
        .as_bytes()
        .chunks(8)
        .map(|c| u8::from_str_radix(std::str::from_utf8(c).unwrap(), 2).unwrap())
        .collect();
    crc::Crc::<u16>::new(&crc::CRC_15_CAN).checksum(&bytes)
}

/// Inserts a complement after every five equal characters; what was inserted counts towards the next five.
fn naive_stuff(bits: &str) -> String {
    let mut wire = String::new();
    for bit in bits.chars() {
        wire.push(bit);
        if wire.ends_with("00000") {
            wire.push('1');
        } else if wire.ends_with("11111") {
            wire.push('0');
        }
    }
    wire
}

fn naive_wire(frame: &Frame) -> String {
    let body = naive_body(frame);
    let stuffed = naive_stuff(&format!("{body}{:015b}", catalogue_crc(&body)));
    format!("{stuffed}1011111111111") // CRC delimiter, ACK slot, ACK delimiter, 7 x EOF, 3 x IFS
}

fn any_id() -> impl Strategy<Value = Id> {
    prop_oneof![
        (0..=0x7FFu16).prop_map(|raw| Id::standard(raw).unwrap()),
        (0..=0x1FFF_FFFFu32).prop_map(|raw| Id::extended(raw).unwrap()),
    ]
}

fn any_frame() -> impl Strategy<Value = Frame> {
    (any_id(), any::<bool>(), 0..=15u8, any::<[u8; 8]>()).prop_map(|(id, remote, dlc, data)| {
        if remote {
            return Frame::new_remote(id, dlc);
        }
        let mut frame = Frame::new(id, &data[..usize::from(dlc.min(8))]).unwrap();
        frame.dlc = dlc;
        frame
    })
}

#[test]
fn the_shortest_frame_is_47_bits_and_the_longest_extended_one_131_to_160() {
    // Microchip DS80179G calls 47 us at 1 Mbit/s the absolute minimum. Only remote frames reach it: the seven zeros
    // from RTR to the length code of an empty data frame need a stuff bit.
    let every_id = || (0..=0x7FF).map(|raw| Id::standard(raw).unwrap());
    let empty = every_id().map(|id| FrameBits::of(&Frame::new(id, &[]).unwrap()).total());
    let remote = every_id().map(|id| FrameBits::of(&Frame::new_remote(id, 4)).total());
    assert_eq!((empty.clone().min(), remote.min()), (Some(48), Some(47)));
    assert!(empty.max() <= Some(55));
    let zeros = Frame::new(Id::extended(0).unwrap(), &[0; 8]).unwrap();
    let mixed = Frame::new(Id::extended(0x0AAA_AAAA).unwrap(), &[0x55; 8]).unwrap();
    assert!((131..=160).contains(&FrameBits::of(&zeros).total()));
    assert!(FrameBits::of(&mixed).total() < 137, "alternating bits need next to no stuffing");
    assert!(FrameBits::of(&zeros).total() >= 145, "zeros need a stuff bit every five");
}

#[test]
fn the_crc_of_the_catalogue_is_the_one_that_is_checked_against() {
    assert_eq!(crc::Crc::<u16>::new(&crc::CRC_15_CAN).checksum(b"123456789"), 0x059E);
}

#[test]
fn a_length_code_above_eight_carries_eight_bytes() {
    let mut frame = Frame::new(Id::standard(0x123).unwrap(), &[1; 8]).unwrap();
    frame.dlc = 15;
    assert_eq!(frame.data_len(), 8);
    assert_eq!(naive_wire(&frame).len() as u32, FrameBits::of(&frame).total());
}

#[test]
fn frames_print_as_candump_writes_them() {
    let frame = Frame::new(Id::extended(0x18FE_F100).unwrap(), &[0xDE, 0xAD]).unwrap();
    assert_eq!(frame.to_string(), "18FEF100#DEAD");
    assert_eq!(Frame::new_remote(Id::standard(0x7F).unwrap(), 8).to_string(), "07F#R8");
}

proptest! {
    #[test]
    fn length_and_crc_agree_with_the_bit_string(frame in any_frame()) {
        let wire = naive_wire(&frame);
        prop_assert_eq!(FrameBits::of(&frame).total() as usize, wire.len());
        prop_assert_eq!(crc(&frame), catalogue_crc(&naive_body(&frame)));
    }

    #[test]
    fn length_stays_within_the_published_limits(id in any_id(), data in any::<[u8; 8]>(), dlc in 0..=8usize) {
        let total = FrameBits::of(&Frame::new(id, &data[..dlc]).unwrap()).total();
        let stuffable = if id.is_extended() { 54 } else { 34 } + 8 * dlc as u32;
        prop_assert!((stuffable + 13..=stuffable + 13 + (stuffable - 1) / 4).contains(&total));
    }

    #[test]
    fn the_lower_arbitration_key_is_the_frame_with_the_first_dominant_bit(a in any_frame(), b in any_frame()) {
        // Dominant is '0', so the order of the bit strings is the order of priority. Arbitration ends at the RTR bit
        // of an extended frame at the latest; behind it, frames of equal identifiers differ without an order.
        let end = |frame: &Frame| if frame.id.is_extended() { 33 } else { 14 };
        let (wire_a, wire_b) = (naive_body(&a), naive_body(&b));
        let (field_a, field_b) = (&wire_a[..end(&a)], &wire_b[..end(&b)]);
        prop_assert_eq!(field_a.cmp(field_b), a.arbitration_key().cmp(&b.arbitration_key()));
    }

    #[test]
    fn the_first_difference_is_where_the_stuffed_strings_part(a in any_frame(), b in any_frame()) {
        let parted = naive_wire(&a).chars().zip(naive_wire(&b).chars()).position(|(x, y)| x != y);
        // A stuff bit behind the last common bit is common as well, so the strings part at a data bit.
        prop_assert_eq!(first_difference(&a, &b).map(|bit| bit as usize), parted.map(|index| {
            // The bit that differs may be the fifth of its kind: the loser knows after its stuff bit at the latest.
            let own = &naive_wire(&a)[..=index];
            if own.ends_with("00000") || own.ends_with("11111") { index + 2 } else { index + 1 }
        }));
    }
}
