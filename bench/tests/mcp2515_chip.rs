//! The MCP2515 model against sentences of its datasheet (DS20001801J).

mod mcp2515_rig;

use bench::can::{Confinement, Frame, Id, LoadGenerator, NodeMode, Participant, Tag};
use bench::chips::mcp2515::{BitTiming, Config, Mode, TimingFault, Violation};
use bench::time::Nanos;
use mcp2515_rig::*;
use proptest::prelude::*;

fn violations(rig: &Rig) -> Vec<Violation> {
    rig.chip.violations().first().iter().map(|&(_, violation)| violation).collect()
}

#[test]
fn registers_have_their_reset_values() {
    let mut rig = Rig::new(Config::default());
    let expected = [
        (CANSTAT, 0x80),
        (CANCTRL, 0x87),
        (CNF3, 0),
        (0x29, 0),
        (0x2A, 0),
        (CANINTE, 0),
        (CANINTF, 0),
        (EFLG, 0),
        (0x1C, 0),
        (0x1D, 0),
        (0x0C, 0),
        (0x30, 0),
        (0x40, 0),
        (0x50, 0),
        (RXB0CTRL, 0),
        (RXB1CTRL, 0),
    ];
    for (address, value) in expected {
        assert_eq!(rig.read(address), value, "register {address:#04x}");
    }
    for row in 0..8 {
        assert_eq!(rig.read(row << 4 | 0x0E), 0x80, "CANSTAT is at every xE");
        assert_eq!(rig.read(row << 4 | 0x0F), 0x87, "CANCTRL is at every xF");
    }
    rig.no_violations();
}

#[test]
fn reset_brings_the_reset_values_back_and_keeps_the_chip_silent_for_128_clocks() {
    let mut rig = Rig::normal();
    assert_eq!(rig.chip.mode(), Mode::Normal);
    rig.transaction(&[0xC0]);
    assert_eq!(rig.chip.mode(), Mode::Configuration);
    rig.wait(Nanos(6_000)); // 128 clocks of 16 MHz are 8 us
    assert_eq!(rig.read(CANCTRL), 0xFF, "lost: the oscillator has not started");
    assert_eq!(violations(&rig), [Violation::NotStarted]);
    assert_eq!(rig.read(CANCTRL), 0x87, "the next instruction is late enough");
    assert_eq!(rig.read(RXB0CTRL), 0);
}

#[test]
fn read_and_write_run_through_consecutive_addresses() {
    let mut rig = Rig::new(Config::default());
    rig.write(CNF3, &[0x01, 0xBC, 0x41, 0x3F]);
    assert_eq!(rig.transaction(&[0x03, CNF3, 0, 0, 0, 0])[2..], [0x01, 0xBC, 0x41, 0x3F]);
    rig.no_violations();
}

#[test]
fn bit_modify_heeds_its_mask_only_where_the_map_allows_it() {
    let mut rig = Rig::new(Config::default());
    rig.write(CANINTE, &[0b1010_0000]);
    rig.modify(CANINTE, 0b0000_1111, 0b1111_0011);
    assert_eq!(rig.read(CANINTE), 0b1010_0011);
    rig.write(0x21, &[0xE0]); // RXM0SIDL is not bit-modifiable: the mask becomes FFh
    rig.modify(0x21, 0x01, 0x03);
    assert_eq!(rig.read(0x21), 0x03);
}

#[test]
fn unimplemented_and_read_only_bits_do_not_take_writes() {
    let mut rig = Rig::new(Config::default());
    rig.write(CNF3, &[0xFF]);
    assert_eq!(rig.read(CNF3), 0xC7);
    rig.write(RXB0CTRL, &[0xFF]);
    assert_eq!(rig.read(RXB0CTRL), 0x66, "BUKT1 copies BUKT; RXRTR and FILHIT0 cannot be written");
    rig.write(EFLG, &[0xFF]);
    assert_eq!(rig.read(EFLG), 0xC0);
    rig.no_violations();
    rig.write(0x1C, &[1]);
    rig.write(0x66, &[1]);
    assert_eq!(violations(&rig), [Violation::ReadOnly(0x1C), Violation::ReadOnly(0x66)]);
}

#[test]
fn timing_masks_and_filters_can_be_written_in_configuration_mode_only_and_hide_elsewhere() {
    let mut rig = Rig::new(Config::default());
    rig.configure(0x20, 0x5A);
    rig.mode(0b000);
    assert_eq!(rig.read(0x20), 0, "masks and filters read as zero outside configuration mode");
    rig.write(0x20, &[1]);
    rig.write(0x2A, &[1]);
    assert_eq!(
        violations(&rig),
        [Violation::OutsideConfiguration(0x20), Violation::OutsideConfiguration(0x2A)]
    );
    rig.mode(0b100);
    assert_eq!(rig.read(0x20), 0x5A, "and keep what they had");
}

#[test]
fn misuse_is_reported() {
    let cases: [(&[u8], Violation); 6] = [
        (&[0xFF], Violation::UnknownInstruction(0xFF)),
        (&[0x05, CANCTRL, 0xE0], Violation::Incomplete(0x05)),
        (&[0x03], Violation::Incomplete(0x03)),
        (&[0x03, 0x8F, 0], Violation::AddressOutOfRange(0x8F)),
        (&[0x02, CANCTRL, 0x27], Violation::ModeNotModelled(0x27)),
        (&[0x02, 0x0D, 0x01], Violation::RequestPins(0x01)),
    ];
    for (bytes, expected) in cases {
        let mut rig = Rig::new(Config::default());
        rig.transaction(bytes);
        assert_eq!(violations(&rig), [expected]);
    }
    let mut rig = Rig::new(Config::default());
    rig.clock(0x03);
    assert_eq!(violations(&rig), [Violation::NotSelected]);
}

#[test]
fn an_spi_clock_above_ten_megahertz_is_reported() {
    let mut rig = Rig::new(Config::default());
    rig.read(CANSTAT);
    rig.no_violations();
    rig.byte = Nanos(768); // 125 MHz / 12
    rig.read(CANSTAT);
    assert!(violations(&rig).contains(&Violation::SpiTooFast { byte: Nanos(768) }));
}

#[test]
fn bit_timing_follows_cnf_and_crystal() {
    for (cnf, crystal, bitrate, sample) in [
        ([0x01, 0xBC, 0x01], 16_000_000, 250_000, 875),
        ([0x00, 0xBC, 0x01], 8_000_000, 250_000, 875),
        ([0x00, 0xBC, 0x01], 16_000_000, 500_000, 875),
        ([0x00, 0x91, 0x01], 8_000_000, 500_000, 750),
        ([0x41, 0xF1, 0x85], 16_000_000, 250_000, 625),
        // BTLMODE clear: phase segment 2 is as long as phase segment 1, or two quanta.
        ([0x01, 0x32, 0x00], 16_000_000, 222_222, 611),
        ([0x03, 0x05, 0x07], 16_000_000, 200_000, 800),
    ] {
        let timing = BitTiming::of(cnf[0], cnf[1], cnf[2]);
        assert_eq!(timing.bitrate(crystal), bitrate);
        assert_eq!(timing.sample_point_per_mille(), sample);
        assert_eq!(timing.fault(), None);
    }
    assert_eq!(BitTiming::of(0x00, 0xC0, 0x80).fault(), Some(TimingFault::Phase2TooShort));
    assert_eq!(BitTiming::of(0xC1, 0xBC, 0x01).fault(), Some(TimingFault::JumpTooWide));
    assert_eq!(BitTiming::of(0x00, 0x80, 0x03).fault(), Some(TimingFault::Phase2TooLong));
}

#[test]
fn normal_mode_comes_after_eleven_recessive_bits() {
    let mut rig = Rig::new(Config::default());
    rig.configure(CANINTE, 0);
    rig.modify(CANCTRL, 0xE0, 0);
    let asked = rig.now;
    rig.advance(asked + Nanos(10 * BIT.0));
    assert_eq!(rig.chip.mode(), Mode::Configuration);
    rig.advance(asked + Nanos(11 * BIT.0));
    assert_eq!(rig.chip.mode(), Mode::Normal);
}

#[test]
fn normal_mode_waits_for_the_end_of_a_frame_under_way() {
    let mut rig = Rig::new(Config::default());
    rig.bus.attach("ear");
    rig.configure(RXB0CTRL, 0x60);
    let start = rig.now;
    rig.bus.request(rig.peer, start, extended(1, &[0xAA; 8]), Tag(0));
    rig.wait(Nanos(200_000));
    rig.modify(CANCTRL, 0xE0, 0);
    rig.wait(Nanos(200_000));
    assert_eq!(rig.chip.mode(), Mode::Configuration, "400 us into a frame of 524 us and more");
    rig.wait(Nanos(400_000));
    assert_eq!(rig.chip.mode(), Mode::Normal);
    assert_eq!(rig.chip.counters().frames_seen, 0, "the frame under way is not its own");
}

#[test]
fn configuration_mode_waits_for_the_frame_that_is_being_received() {
    let mut rig = Rig::normal();
    rig.bus.request(rig.peer, rig.now, extended(1, &[0xAA; 8]), Tag(0));
    rig.wait(Nanos(200_000));
    rig.modify(CANCTRL, 0xE0, 0x80);
    assert_eq!(rig.read(CANSTAT) >> 5, 0b000);
    rig.wait(Nanos(500_000));
    assert_eq!(rig.read(CANSTAT) >> 5, 0b100);
    assert_eq!(rig.chip.counters().frames_stored, [1, 0]);
}

#[test]
fn a_received_frame_pulls_int_low_and_read_rx_buffer_lets_it_go_when_cs_rises() {
    let mut rig = Rig::normal();
    let frame = extended(0x18FE_F100, &[1, 2, 3, 4, 5, 6, 7, 8]);
    assert!(rig.chip.int_level());
    rig.receive(frame);
    assert!(!rig.chip.int_level());
    assert_eq!(rig.read(CANSTAT) >> 1 & 7, 6, "ICOD: RXB0");
    rig.cs(true);
    let mut bytes = vec![rig.clock(0x90)];
    bytes.extend((0..13).map(|_| rig.clock(0)));
    assert!(!rig.chip.int_level(), "still low while CS is low");
    rig.cs(false);
    assert!(rig.chip.int_level());
    let mut expected = registers(&frame);
    expected[1] |= 0x10; // SRR, recessive in an extended frame and without meaning
    assert_eq!(bytes[1..], expected);
    rig.no_violations();
}

#[test]
fn read_rx_buffer_starts_at_the_identifier_or_at_the_data() {
    let mut rig = Rig::normal();
    rig.receive(standard(0x123, &[0xA0]));
    rig.receive(standard(0x456, &[0xB0]));
    for (opcode, first) in [(0x90, 0x24), (0x94, 0x8A)] {
        rig.chip.select(rig.now, true, &mut rig.bus);
        rig.clock(opcode);
        assert_eq!(rig.clock(0), first, "SIDH by {opcode:#04x}");
        rig.chip.select(rig.now, false, &mut rig.bus);
    }
    assert_eq!(rig.transaction(&[0x92, 0])[1], 0xA0);
    assert_eq!(rig.transaction(&[0x96, 0])[1], 0xB0);
}

#[test]
fn remote_frames_show_in_srr_for_standard_and_in_rtr_for_extended_identifiers() {
    let mut rig = Rig::normal();
    rig.receive(Frame::new_remote(Id::standard(0x123).unwrap(), 5));
    rig.receive(Frame::new_remote(Id::extended(0x123).unwrap(), 6));
    assert_eq!(rig.read(0x62) & 0x18, 0x10, "RXB0SIDL: SRR, no IDE");
    assert_eq!(rig.read(0x65), 5, "RXB0DLC: no RTR");
    assert_eq!(rig.read(0x72) & 0x08, 0x08, "RXB1SIDL: IDE");
    assert_eq!(rig.read(0x75), 0x46, "RXB1DLC: RTR");
    assert_eq!((rig.read(RXB0CTRL) & 0x08, rig.read(RXB1CTRL) & 0x08), (0x08, 0x08), "RXRTR");
}

#[test]
fn the_third_unserved_frame_is_lost_and_counted() {
    let mut rig = Rig::normal();
    for n in 0..3 {
        rig.receive(standard(0x100, &[n]));
    }
    let counters = rig.chip.counters();
    assert_eq!((counters.frames_stored, counters.frames_overrun), ([1, 1], [0, 1]));
    assert_eq!(rig.read(EFLG), 0x80, "RX1OVR: rollover was on");
    assert_eq!(rig.read(CANINTF), 0x23, "ERRIF, RX1IF, RX0IF");
    assert_eq!(rig.read(CANSTAT) >> 1 & 7, 1, "ICOD: an error is the most urgent");
    assert_eq!((rig.read_buffer(0)[5], rig.read_buffer(1)[5]), (0, 1), "the first two are whole");
    rig.modify(CANINTF, 0x20, 0);
    assert_eq!(rig.read(CANINTF), 0x20, "ERRIF cannot go before its condition");
    rig.modify(EFLG, 0xC0, 0);
    rig.modify(CANINTF, 0x20, 0);
    assert!(rig.chip.int_level());
    rig.no_violations();
}

#[test]
fn without_rollover_the_second_frame_is_lost() {
    let mut rig = Rig::new(Config::default());
    rig.configure(RXB0CTRL, 0x60);
    rig.mode(0);
    rig.receive(standard(0x100, &[0]));
    rig.receive(standard(0x100, &[1]));
    assert_eq!(rig.read(EFLG), 0x40, "RX0OVR");
    assert_eq!(rig.chip.counters().frames_overrun, [1, 0]);
}

#[test]
fn clearing_a_flag_twice_discards_the_frame_between() {
    // READ RX BUFFER clears RX0IF; a BIT MODIFY of the same flag throws away what came in between.
    let mut rig = Rig::normal();
    rig.receive(standard(1, &[1]));
    rig.read_buffer(0);
    rig.receive(standard(2, &[2]));
    rig.modify(CANINTF, 0x01, 0);
    assert_eq!(rig.chip.counters().frames_discarded, 1);
}

#[test]
fn a_frame_released_before_an_older_one_is_counted() {
    let mut rig = Rig::normal();
    let out_of_order = |rig: &Rig| rig.chip.counters().frames_read_out_of_order;
    rig.receive(standard(1, &[1]));
    rig.receive(standard(2, &[2]));
    rig.read_buffer(0);
    assert_eq!(out_of_order(&rig), 0, "RXB0 held the older one");
    rig.receive(standard(3, &[3]));
    rig.read_buffer(0);
    assert_eq!(out_of_order(&rig), 1, "RXB0 was filled again, RXB1 is older now");
    rig.read_buffer(1);
    assert_eq!(out_of_order(&rig), 1);
}

#[test]
fn a_frame_that_comes_while_an_empty_buffer_is_read_is_discarded() {
    let mut rig = Rig::normal();
    rig.bus.request(rig.peer, rig.now, standard(0x2AA, &[]), Tag(0));
    rig.byte = Nanos(40_000);
    rig.read_buffer(0);
    assert_eq!(rig.chip.counters().frames_stored, [1, 0]);
    assert_eq!(rig.chip.counters().frames_discarded, 1);
}

#[test]
fn filters_choose_the_buffer_and_report_the_hit() {
    let mut rig = Rig::new(Config::default());
    rig.configure(RXB0CTRL, 0x04); // RXM 00, BUKT
    rig.write(RXB1CTRL, &[0x00]);
    rig.write(0x20, &[0xFF, 0xE0, 0, 0, 0xFF, 0xE3, 0xFF, 0xFF]); // RXM0: 11 bits; RXM1: 29 bits
    let filters = [
        standard(0x100, &[]),
        standard(0x101, &[]),
        extended(2, &[]),
        extended(3, &[]),
        extended(4, &[]),
        extended(5, &[]),
    ];
    for (address, frame) in [0x00, 0x04, 0x08, 0x10, 0x14, 0x18].into_iter().zip(&filters) {
        rig.write(address, &registers(frame)[..4]);
    }
    rig.mode(0);
    for (hit, frame) in filters.into_iter().enumerate() {
        rig.receive(frame);
        let buffer = usize::from(hit >= 2);
        let status = rig.transaction(&[0xB0, 0])[1];
        assert_eq!(usize::from(status & 7), hit, "RX STATUS names the filter");
        assert_eq!(usize::from(status >> 6), buffer + 1, "and the buffer");
        assert_eq!(status >> 3 & 3, if buffer == 1 { 0b10 } else { 0 }, "and the kind of frame");
        let control = rig.read([RXB0CTRL, RXB1CTRL][buffer]);
        assert_eq!(usize::from(control & [1, 7][buffer]), hit, "so does FILHIT");
        rig.read_buffer(buffer as u8);
    }
    for other in [standard(0x102, &[]), extended(0x100, &[]), extended(6, &[])] {
        rig.receive(other);
        assert_eq!(rig.read(CANINTF) & 3, 0);
    }
    assert_eq!(rig.chip.counters().frames_filtered, 3);
    rig.receive(standard(0x101, &[]));
    rig.receive(standard(0x101, &[]));
    assert_eq!(rig.transaction(&[0xB0, 0])[1], 0xC0 | 1, "both full: RXB0 is shown");
    rig.read_buffer(0);
    assert_eq!(rig.transaction(&[0xB0, 0])[1], 0x80 | 7, "RXF1 rolled over to RXB1");
    rig.no_violations();
}

#[test]
fn a_standard_frame_is_filtered_by_its_first_two_data_bytes() {
    let mut rig = Rig::new(Config::default());
    rig.configure(RXB0CTRL, 0x00);
    rig.write(0x24, &[0xFF, 0xE0, 0, 0]);
    for address in [0x08, 0x10, 0x14, 0x18] {
        rig.write(address, &[0xFF, 0xE0, 0, 0]);
    }
    rig.write(0x20, &[0xFF, 0xE0, 0xFF, 0x0F]);
    for address in [0x00, 0x04] {
        rig.write(address, &[0x24, 0x60, 0x42, 0x05]); // 0x123, then data 42 x5
    }
    rig.mode(0);
    for (payload, accepted) in
        [(&[0x42, 0xF5, 9][..], true), (&[0x42, 0xF6], false), (&[0x43, 0xF5], false), (&[0x42], false)]
    {
        rig.receive(standard(0x123, payload));
        assert_eq!(rig.read(CANINTF) & 1 == 1, accepted, "{payload:x?}");
        rig.modify(CANINTF, 3, 0);
    }
}

#[test]
fn reserved_receive_modes_are_reported() {
    let mut rig = Rig::new(Config::default());
    rig.write(RXB0CTRL, &[0x20]);
    rig.write(RXB1CTRL, &[0x40]);
    assert_eq!(
        violations(&rig),
        [Violation::ReservedReceiveMode(0x20), Violation::ReservedReceiveMode(0x40)]
    );
}

#[test]
fn a_loaded_and_requested_frame_goes_out_and_sets_its_flag() {
    let mut rig = Rig::normal();
    rig.write(CANINTE, &[0x1C]);
    let frames = [
        extended(0x18FF_0001, &[1, 2, 3]),
        standard(0x7FF, &[]),
        Frame::new_remote(Id::standard(3).unwrap(), 4),
    ];
    for (buffer, frame) in (0..).zip(frames) {
        rig.send(buffer, &registers(&frame));
        assert_eq!(rig.transaction(&[0xA0, 0])[1] & 0x54, 0x04 << (2 * buffer), "READ STATUS: pending");
        rig.wait(Nanos::from_millis(1));
        assert_eq!(rig.transaction(&[0xA0, 0])[1] & 0xFC, 0x08 << (2 * buffer), "READ STATUS: sent");
        assert_eq!(rig.read(CANSTAT) >> 1 & 7, 3 + buffer, "ICOD");
        assert!(!rig.chip.int_level());
        rig.modify(CANINTF, 0x1C, 0);
    }
    assert_eq!(rig.heard.iter().map(|&(_, frame)| frame).collect::<Vec<_>>(), frames);
    rig.no_violations();
}

#[test]
fn transmit_buffers_go_by_priority_then_by_the_higher_number() {
    for (priorities, order) in [([0, 0, 0], [2, 1, 0]), ([3, 0, 1], [0, 2, 1]), ([1, 1, 0], [1, 0, 2])] {
        let mut rig = Rig::normal();
        for buffer in 0..3u8 {
            rig.write(0x30 + 0x10 * buffer, &[priorities[usize::from(buffer)]]);
            rig.load(buffer, &registers(&standard(0x100, &[buffer])));
        }
        rig.transaction(&[0x87]);
        rig.wait(Nanos::from_millis(2));
        assert_eq!(rig.heard.iter().map(|(_, frame)| frame.data[0]).collect::<Vec<_>>(), order);
    }
}

#[test]
fn a_more_urgent_buffer_overtakes_one_that_waits_for_the_bus() {
    let mut rig = Rig::normal();
    rig.bus.request(rig.peer, rig.now, standard(0, &[0; 8]), Tag(0));
    rig.wait(BIT);
    rig.send(0, &registers(&standard(0x100, &[0])));
    rig.send(2, &registers(&standard(0x100, &[2])));
    rig.wait(Nanos::from_millis(2));
    assert_eq!(rig.heard.iter().map(|(_, frame)| frame.data[0]).collect::<Vec<_>>(), [2, 0]);
}

#[test]
fn a_pending_buffer_cannot_be_written() {
    let mut rig = Rig::normal();
    rig.bus.cut(rig.peer, rig.now);
    rig.send(0, &registers(&standard(0x100, &[1])));
    rig.load(0, &[0xFF]);
    assert_eq!(violations(&rig), [Violation::BufferPending(0x31)]);
}

#[test]
fn lost_arbitration_is_marked_and_the_frame_follows() {
    let mut rig = Rig::normal();
    // Both start at the same instant: they wait for the end of a frame before them.
    rig.bus.request(rig.peer, rig.now, standard(0, &[]), Tag(0));
    rig.bus.request(rig.peer, rig.now, standard(0x001, &[1]), Tag(0));
    rig.send(0, &registers(&standard(0x002, &[2])));
    rig.wait(Nanos::from_millis(3));
    assert_eq!(rig.heard.len(), 1);
    assert_eq!(rig.read(0x30) & 0x20, 0x20, "MLOA stays until the next request");
    assert_eq!(rig.read(0x30) & 0x08, 0, "TXREQ is gone");
}

#[test]
fn one_shot_gives_up_after_lost_arbitration_and_after_an_error() {
    let mut rig = Rig::normal();
    rig.modify(CANCTRL, 0x08, 0x08);
    rig.bus.force_bit_errors(rig.chip.node(), 1);
    rig.send(0, &registers(&standard(0x100, &[1])));
    rig.wait(Nanos::from_millis(2));
    assert_eq!(rig.read(0x30), 0x50, "ABTF, TXERR; TXREQ is gone");
    assert!(rig.heard.is_empty());
    rig.bus.request(rig.peer, rig.now, standard(0, &[0; 8]), Tag(0));
    rig.bus.request(rig.peer, rig.now, standard(1, &[]), Tag(0));
    rig.wait(BIT);
    rig.send(0, &registers(&standard(0x100, &[1])));
    rig.wait(Nanos::from_millis(2));
    assert_eq!(rig.read(0x30), 0x60, "ABTF, MLOA");
    assert!(rig.heard.is_empty());
}

#[test]
fn abort_all_marks_what_it_took_back_and_lets_a_frame_under_way_finish() {
    let mut rig = Rig::normal();
    rig.send(2, &registers(&standard(0x100, &[2; 8])));
    rig.send(0, &registers(&standard(0x100, &[0])));
    rig.modify(CANCTRL, 0x10, 0x10);
    assert_eq!(rig.read(0x30), 0x40, "ABTF: it had not started");
    assert_eq!(rig.read(0x50) & 0x48, 0x08, "still on the bus");
    rig.wait(Nanos::from_millis(1));
    assert_eq!(rig.read(0x50) & 0x48, 0, "sent, not aborted");
    assert_eq!(rig.heard.len(), 1);
    rig.send(1, &registers(&standard(0x100, &[1])));
    rig.wait(Nanos::from_millis(1));
    assert_eq!(rig.heard.len(), 1, "nothing is sent while ABAT is set");
    rig.modify(CANCTRL, 0x10, 0);
    rig.wait(Nanos::from_millis(1));
    assert_eq!(rig.heard.len(), 2);
}

#[test]
fn clearing_txreq_takes_a_request_back_without_a_mark() {
    let mut rig = Rig::normal();
    rig.bus.cut(rig.peer, rig.now);
    rig.send(0, &registers(&standard(0x100, &[1])));
    rig.wait(Nanos::from_millis(5));
    rig.modify(0x30, 0x08, 0);
    rig.wait(Nanos::from_millis(5));
    assert_eq!(rig.read(0x30) & 0x48, 0);
    assert_eq!(rig.bus.pending(rig.chip.node()), 0);
}

#[test]
fn the_erratum_repeats_a_frame_that_was_requested_by_register() {
    for (repeats_frames, heard) in [(false, 1), (true, 2)] {
        let mut rig = Rig::new(Config { repeats_frames, ..Config::default() });
        rig.configure(RXB0CTRL, 0x60);
        rig.mode(0);
        rig.load(0, &registers(&standard(0x100, &[1])));
        rig.modify(0x30, 0x08, 0x08);
        rig.wait(Nanos::from_millis(3));
        assert_eq!(rig.heard.len(), heard);
        rig.transaction(&[0x81]);
        rig.wait(Nanos::from_millis(3));
        assert_eq!(rig.heard.len(), heard + 1, "RTS is not affected");
    }
}

#[test]
fn loopback_talks_to_itself_and_never_to_the_bus() {
    let mut rig = Rig::new(Config::default());
    rig.configure(RXB0CTRL, 0x64);
    rig.write(RXB1CTRL, &[0x60]);
    rig.mode(0b010);
    let frame = standard(0x2AA, &[0x55; 4]);
    let bits = bench::can::bits::FrameBits::of(&frame).total();
    rig.load(0, &registers(&frame));
    rig.transaction(&[0x81]);
    let requested = rig.now;
    rig.advance(requested + Nanos(u64::from(bits - 1) * BIT.0));
    assert_eq!(rig.read(CANINTF), 0, "it takes as long as on the bus");
    rig.wait(Nanos(2 * BIT.0));
    assert_eq!(rig.read(CANINTF), 0x05, "TX0IF, RX0IF");
    let got = rig.read_buffer(0);
    assert_eq!((&got[..2], &got[4..9]), (&registers(&frame)[..2], &registers(&frame)[4..]));
    assert!(rig.heard.is_empty());
    assert_eq!(rig.bus.stats().frames, 0);
}

#[test]
fn a_listen_only_chip_hears_but_does_not_acknowledge() {
    let mut rig = Rig::new(Config::default());
    rig.configure(RXB0CTRL, 0x60);
    rig.mode(0b011);
    rig.bus.request(rig.peer, rig.now, standard(1, &[1]), Tag(0));
    rig.wait(Nanos::from_millis(2));
    assert_eq!(rig.bus.pending(rig.peer), 1, "nobody acknowledges");
    let other = rig.bus.attach("other");
    rig.wait(Nanos::from_millis(2));
    assert_eq!(rig.bus.pending(rig.peer), 0);
    assert!(rig.chip.counters().frames_seen >= 1);
    rig.send(0, &registers(&standard(2, &[])));
    rig.wait(Nanos::from_millis(2));
    assert!(rig.heard.is_empty(), "nor does it send");
    assert_eq!(rig.bus.counters(other).receive, 0);
}

#[test]
fn error_flags_follow_the_transmit_counter_up_to_bus_off_and_back() {
    let mut rig = Rig::normal();
    rig.bus.force_bit_errors(rig.chip.node(), 32);
    rig.send(0, &registers(&standard(0x100, &[1])));
    let mut seen = vec![0];
    for _ in 0..5_000 {
        rig.wait(BIT);
        let eflg = rig.read(EFLG);
        if seen.last() != Some(&eflg) {
            seen.push(eflg);
            assert_eq!(rig.read(CANINTF) & 0x20, 0x20, "ERRIF at every change");
            rig.modify(CANINTF, 0xA0, 0);
            assert_eq!(rig.read(CANINTF) & 0x20, 0, "a state is no condition that holds ERRIF");
        }
        if seen.len() > 1 && eflg == 0 {
            break;
        }
    }
    // 96: EWARN, TXWAR; 128: TXEP; 256: TXBO; then recovery.
    assert_eq!(seen, [0x00, 0x05, 0x15, 0x35, 0x00]);
    rig.wait(Nanos::from_millis(10));
    assert_eq!(rig.heard.len(), 1, "the request survives bus-off");
}

#[test]
fn the_warning_comes_at_96_and_not_before() {
    for (errors, eflg) in [(11, 0x00), (12, 0x05)] {
        let mut rig = Rig::normal();
        rig.modify(CANCTRL, 0x08, 0x08); // one-shot: the counter stands still after the errors
        rig.bus.force_bit_errors(rig.chip.node(), errors);
        for _ in 0..errors {
            rig.send(0, &registers(&standard(0x100, &[1])));
            rig.wait(Nanos::from_millis(1));
        }
        assert_eq!((rig.read(0x1C), rig.read(EFLG)), (8 * errors as u8, eflg));
    }
}

#[test]
fn receive_errors_show_in_rec_and_in_the_receive_flags() {
    let mut rig = Rig::normal();
    rig.bus.attach("ear");
    rig.bus.garble_receptions(rig.chip.node(), 11);
    rig.bus.request(rig.peer, rig.now, standard(1, &[]), Tag(0));
    rig.wait(Nanos::from_millis(3));
    assert_eq!(rig.read(0x1D), 98, "11 x 9, less one for the good frame at the end");
    assert_eq!(rig.read(EFLG), 0x03, "RXWAR, EWARN");
    assert_eq!(rig.read(CANINTF) & 0xA0, 0xA0, "MERRF, ERRIF");
    rig.bus.garble_receptions(rig.chip.node(), 5);
    rig.bus.request(rig.peer, rig.now, standard(1, &[]), Tag(0));
    rig.wait(Nanos::from_millis(2));
    assert_eq!(rig.bus.state(rig.chip.node()), Confinement::ErrorPassive);
    assert_eq!(rig.read(EFLG) & 0x08, 0x08, "RXEP");
}

#[test]
fn the_wrong_crystal_makes_errors_instead_of_frames() {
    let mut rig = Rig::new(Config { crystal_hz: 8_000_000, ..Config::default() });
    rig.configure(RXB0CTRL, 0x60);
    rig.mode(0);
    rig.bus.attach("ear");
    rig.receive(standard(1, &[1]));
    assert_eq!(rig.chip.counters().frames_seen, 0);
    assert!(rig.chip.counters().bus_errors > 0);
    assert_eq!(rig.read(CANINTF) & 0x80, 0x80, "MERRF");
}

#[test]
fn a_bit_timing_that_breaks_a_rule_is_reported() {
    let mut rig = Rig::new(Config { crystal_hz: 8_000_000, ..Config::default() });
    rig.write(CNF3, &[0x80, 0xC0, 0x00]);
    rig.modify(CANCTRL, 0xE0, 0);
    assert_eq!(violations(&rig), [Violation::Timing(TimingFault::Phase2TooShort)]);
}

#[test]
fn configuration_mode_takes_the_chip_off_the_bus_and_clears_its_counters() {
    let mut rig = Rig::normal();
    rig.bus.attach("ear");
    rig.bus.garble_receptions(rig.chip.node(), 2);
    rig.receive(standard(1, &[1]));
    assert!(rig.read(0x1D) > 0);
    rig.mode(0b100);
    assert_eq!(rig.read(0x1D), 0);
    rig.receive(standard(1, &[1]));
    assert_eq!(rig.chip.counters().frames_seen, 1);
    rig.bus.set_mode(rig.peer, rig.now, NodeMode::Off);
}

#[test]
fn the_buffer_full_pins_follow_their_flags() {
    let mut rig = Rig::normal();
    assert_eq!(rig.chip.buffer_full_pins(), [None, None]);
    rig.write(0x0C, &[0x0F]);
    assert_eq!(rig.chip.buffer_full_pins(), [Some(true), Some(true)]);
    rig.receive(standard(1, &[]));
    assert_eq!(rig.chip.buffer_full_pins(), [Some(false), Some(true)]);
    rig.write(0x0C, &[0x1C]);
    assert_eq!(
        rig.chip.buffer_full_pins(),
        [Some(true), Some(false)],
        "plain outputs: B0BFS set, B1BFS clear"
    );
}

/// What a careful driver does at one INT: RX STATUS, then the buffer that it names, RXB0 first, until INT is high.
fn drain(rig: &mut Rig, sequence: &mut Vec<u64>) {
    for _ in 0..8 {
        if rig.chip.int_level() {
            return;
        }
        let full = rig.transaction(&[0xB0, 0])[1] >> 6;
        if full == 0 {
            return;
        }
        let bytes = rig.read_buffer(u8::from(full == 0b10));
        sequence.push(u64::from_le_bytes(bytes[5..13].try_into().unwrap()));
    }
}

#[test]
fn a_frame_that_ends_at_any_point_of_a_read_is_neither_lost_nor_torn() {
    // A second frame ends in every 100 ns step around the 14 byte times of a READ RX BUFFER of the first.
    let frame = |n: u64| extended(0x1555_5555, &n.to_le_bytes());
    let length = u64::from(bench::can::bits::FrameBits::of(&frame(1)).received()) * BIT.0;
    for offset in (0..16_000).step_by(100) {
        let mut rig = Rig::normal();
        rig.receive(frame(0));
        let request = rig.now;
        rig.bus.request(rig.peer, request, frame(1), Tag(0));
        rig.advance(request + Nanos(length) - Nanos(offset));
        let mut sequence = Vec::new();
        drain(&mut rig, &mut sequence);
        rig.advance(request + Nanos(length + 20_000));
        drain(&mut rig, &mut sequence);
        assert_eq!(sequence, [0, 1], "second frame ends {offset} ns after the drain begins");
        assert_eq!(rig.chip.counters().frames_discarded, 0);
        rig.no_violations();
    }
}

#[test]
fn full_load_loses_nothing_when_served_and_counts_what_it_loses_when_not() {
    let mut rig = Rig::normal();
    let load = rig.bus.attach("load");
    let mut generator = LoadGenerator::sequenced(load, Id::extended(0x1555_5555).unwrap());
    generator.start(rig.now, &mut rig.bus);
    let mut sequence = Vec::new();
    for round in 0..2_000u64 {
        // Service every 300 us, with one blackout of 20 ms.
        let until = rig.now + if round == 1_000 { Nanos::from_millis(20) } else { Nanos::from_micros(300) };
        while let Some(event) = rig.bus.poll(until) {
            generator.on_event(&event, &mut rig.bus);
            rig.chip.on_bus(&event, &mut rig.bus);
        }
        rig.now = until;
        let already = rig.events.len();
        drain(&mut rig, &mut sequence);
        for event in rig.events.split_off(already) {
            generator.on_event(&event, &mut rig.bus);
        }
        rig.modify(EFLG, 0xC0, 0);
        rig.modify(CANINTF, 0x20, 0);
    }
    let counters = rig.chip.counters();
    let lost: u64 = counters.frames_overrun.iter().sum();
    assert!(lost > 30, "20 ms are 36 frames and more: {lost}");
    assert_eq!(counters.frames_seen, sequence.len() as u64 + lost + u64::from(!rig.chip.int_level()));
    let gaps: u64 = sequence.windows(2).map(|pair| pair[1] - pair[0] - 1).sum();
    assert_eq!(gaps, lost, "every gap in the sequence is a counted loss, in one place");
    rig.no_violations();
}

proptest! {
    #[test]
    fn no_byte_stream_makes_the_model_panic(
        transactions in prop::collection::vec(prop::collection::vec(any::<u8>(), 0..20), 0..60),
    ) {
        let mut rig = Rig::normal();
        for (index, bytes) in transactions.iter().enumerate() {
            rig.transaction(bytes);
            if index % 8 == 0 {
                rig.receive(standard(index as u16, &[1]));
            }
        }
        rig.wait(Nanos::from_millis(5));
    }

    #[test]
    fn any_frame_passes_through_loopback_unchanged(
        raw in 0..0x2000_0000u32, is_extended: bool, remote: bool, dlc in 0..=15u8, data: [u8; 8],
    ) {
        let id = if is_extended { Id::extended(raw) } else { Id::standard((raw & 0x7FF) as u16) }.unwrap();
        let mut frame = Frame::new(id, &data[..usize::from(dlc.min(8))]).unwrap();
        frame.dlc = dlc;
        if remote {
            frame = Frame::new_remote(id, dlc);
        }
        let mut rig = Rig::new(Config::default());
        rig.configure(RXB0CTRL, 0x60);
        rig.mode(0b010);
        rig.send(0, &registers(&frame));
        rig.wait(Nanos::from_millis(1));
        let mut got = rig.read_buffer(0);
        let mut expected = registers(&frame);
        if !is_extended {
            // RTR of a standard frame comes back as SRR; the extended registers are not its own.
            expected[1] |= u8::from(remote) << 4;
            expected[4] &= 0x0F;
            got[2..4].fill(0);
        } else {
            expected[1] |= 0x10;
        }
        prop_assert_eq!(&got[..expected.len()], &expected[..]);
    }
}
