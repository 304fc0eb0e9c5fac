//! Two drivers by other hands against the MCP2515 model: what they find is what the datasheet says, faults included.
//!
//! `mcp25xx` 0.4.0 uses READ RX BUFFER and RTS but reads RXB1 by 0x92, which is RXB0's data; `mcp2515` 0.3.0 uses plain
//! registers and sets TXREQ by BIT MODIFY. Neither was written from this model.

mod mcp2515_rig;

use bench::can;
use bench::chips::mcp2515::{Config, Mode, Violation};
use bench::time::Nanos;
use embedded_can::{ExtendedId, Frame as _, Id, StandardId, nb::Can as _};
use mcp25xx::registers::{OperationMode, RXB0CTRL, RXM};
use mcp25xx::{Config as DriverConfig, MCP25xx};
use mcp2515_rig::*;

/// The `mcp25xx` driver in `mode`, 250 kbit/s from 16 MHz, any message into RXB0.
///
/// It writes the bit timing right after RESET, without the 128 clocks that the oscillator needs; a pause between
/// transactions stands for a slow processor.
fn mcp25xx(mode: OperationMode) -> (MCP25xx<Shared>, Shared) {
    let mut rig = Rig::new(Config::default());
    rig.pause = Nanos::from_micros(10);
    let shared = Shared::new(rig);
    let mut driver = MCP25xx { spi: shared.clone() };
    let config = DriverConfig::default()
        .mode(mode)
        .bitrate(mcp25xx::bitrates::clock_16mhz::CNF_250K_BPS)
        .receive_buffer_0(RXB0CTRL::default().with_rxm(RXM::ReceiveAny));
    driver.apply_config(&config).unwrap();
    shared.0.borrow_mut().wait(Nanos::from_millis(1));
    (driver, shared)
}

fn ids() -> [(Id, can::Id); 3] {
    [
        (StandardId::new(0x123).unwrap().into(), can::Id::standard(0x123).unwrap()),
        (ExtendedId::new(0x18FE_F100).unwrap().into(), can::Id::extended(0x18FE_F100).unwrap()),
        (ExtendedId::new(0).unwrap().into(), can::Id::extended(0).unwrap()),
    ]
}

#[test]
fn mcp25xx_brings_the_chip_into_normal_mode() {
    let (_, shared) = mcp25xx(OperationMode::NormalOperation);
    let rig = shared.0.borrow();
    assert_eq!(rig.chip.mode(), Mode::Normal);
    assert_eq!(rig.chip.bit_timing().bitrate(16_000_000), 250_000);
    rig.no_violations();
}

#[test]
fn mcp25xx_without_a_pause_after_reset_meets_a_chip_that_has_not_started() {
    let shared = Shared::new(Rig::new(Config::default()));
    let mut driver = MCP25xx { spi: shared.clone() };
    driver.apply_config(&DriverConfig::default()).unwrap();
    let rig = shared.0.borrow();
    assert!(rig.chip.violations().first().iter().any(|&(_, violation)| violation == Violation::NotStarted));
}

#[test]
fn mcp25xx_sends_what_the_peer_hears() {
    let (mut driver, shared) = mcp25xx(OperationMode::NormalOperation);
    for (id, wire) in ids() {
        let frame = mcp25xx::CanFrame::new(id, &[1, 2, 3]).unwrap();
        driver.transmit(&frame).unwrap();
        shared.0.borrow_mut().wait(Nanos::from_millis(1));
        let heard = shared.0.borrow().heard.last().map(|&(_, frame)| frame);
        assert_eq!(heard, can::Frame::new(wire, &[1, 2, 3]));
    }
    shared.0.borrow().no_violations();
}

#[test]
fn mcp25xx_receives_what_the_peer_sends() {
    let (mut driver, shared) = mcp25xx(OperationMode::NormalOperation);
    for (id, wire) in ids() {
        shared.0.borrow_mut().receive(can::Frame::new(wire, &[9, 8, 7, 6, 5, 4, 3, 2]).unwrap());
        let frame = driver.receive().unwrap();
        assert_eq!((frame.id(), frame.data()), (id, &[9, 8, 7, 6, 5, 4, 3, 2][..]));
        assert!(driver.receive().is_err(), "one frame, one reception");
    }
    shared.0.borrow().no_violations();
}

#[test]
fn mcp25xx_hears_itself_in_loopback() {
    let (mut driver, shared) = mcp25xx(OperationMode::Loopback);
    let frame = mcp25xx::CanFrame::new(StandardId::new(0x7FF).unwrap(), &[0xAA; 8]).unwrap();
    driver.transmit(&frame).unwrap();
    assert!(driver.receive().is_err(), "not before the frame has passed");
    shared.0.borrow_mut().wait(Nanos::from_millis(1));
    assert_eq!(driver.receive().unwrap().data(), [0xAA; 8]);
    assert!(shared.0.borrow().heard.is_empty());
}

#[test]
fn mcp25xx_reads_the_data_of_buffer_0_when_it_means_buffer_1() {
    let (mut driver, shared) = mcp25xx(OperationMode::NormalOperation);
    driver.write_register(RXB0CTRL::default().with_rxm(RXM::ReceiveAny).with_bukt(true)).unwrap();
    {
        let mut rig = shared.0.borrow_mut();
        rig.receive(standard(0x123, &[0xA0; 8]));
        rig.receive(standard(0x456, &[0xB0; 8]));
    }
    assert_eq!(driver.receive().unwrap().data(), [0xA0; 8]);
    let second = driver.receive().unwrap();
    assert_ne!(second.id(), Id::Standard(StandardId::new(0x456).unwrap()), "0x92 is RXB0's data");
    assert_eq!(shared.0.borrow_mut().read(CANINTF) & 2, 2, "and RX1IF stays for ever");
    // By the right opcode the frame is there.
    assert_eq!(shared.0.borrow_mut().read_buffer(1)[5..13], [0xB0; 8]);
}

#[test]
fn mcp25xx_takes_sixteen_bytes_in_two_transactions_per_frame() {
    let (mut driver, shared) = mcp25xx(OperationMode::NormalOperation);
    shared.0.borrow_mut().receive(extended(0x18FE_F100, &[0; 8]));
    let before = shared.0.borrow().chip.counters();
    driver.receive().unwrap();
    let after = shared.0.borrow().chip.counters();
    let cost = (after.spi_bytes - before.spi_bytes, after.spi_transactions - before.spi_transactions);
    assert_eq!(cost, (16, 2));
}

/// The `mcp2515` driver in `mode`; it waits 5 ms after reset by itself.
fn mcp2515(mode: mcp2515::regs::OpMode) -> (mcp2515::MCP2515<Shared>, Shared) {
    let shared = Shared::new(Rig::new(Config::default()));
    let mut driver = mcp2515::MCP2515::new(shared.clone());
    let settings = mcp2515::Settings {
        mode,
        can_speed: mcp2515::CanSpeed::Kbps250,
        mcp_speed: mcp2515::McpSpeed::MHz16,
        clkout_en: false,
    };
    driver.init(&mut shared.clone(), settings).unwrap();
    (driver, shared)
}

#[test]
fn mcp2515_sends_and_receives() {
    let (mut driver, shared) = mcp2515(mcp2515::regs::OpMode::Normal);
    shared.0.borrow().no_violations();
    for (id, wire) in ids() {
        driver.send_message(mcp2515::frame::CanFrame::new(id, &[1, 2, 3]).unwrap()).unwrap();
        shared.0.borrow_mut().wait(Nanos::from_millis(1));
        let heard = shared.0.borrow().heard.last().map(|&(_, frame)| frame);
        assert_eq!(heard, can::Frame::new(wire, &[1, 2, 3]));

        shared.0.borrow_mut().receive(can::Frame::new(wire, &[9; 8]).unwrap());
        let frame = driver.read_message().unwrap();
        assert_eq!((frame.id(), frame.data()), (id, &[9; 8][..]));
        assert!(matches!(driver.read_message(), Err(mcp2515::error::Error::NoMessage)));
    }
    shared.0.borrow().no_violations();
}

#[test]
fn mcp2515_reads_both_buffers_in_order() {
    let (mut driver, shared) = mcp2515(mcp2515::regs::OpMode::Normal);
    for n in 0..2 {
        shared.0.borrow_mut().receive(standard(0x100, &[n]));
    }
    for n in 0..2 {
        assert_eq!(driver.read_message().unwrap().data(), [n]);
    }
    shared.0.borrow().no_violations();
}

#[test]
fn mcp2515_hears_itself_in_loopback() {
    let (mut driver, shared) = mcp2515(mcp2515::regs::OpMode::Loopback);
    let frame = mcp2515::frame::CanFrame::new(ExtendedId::new(0x1234_5678).unwrap(), &[1, 2]).unwrap();
    driver.send_message(frame).unwrap();
    shared.0.borrow_mut().wait(Nanos::from_millis(1));
    let back = driver.read_message().unwrap();
    assert_eq!((back.id(), back.data()), (frame.id(), frame.data()));
}

#[test]
fn mcp2515_takes_thirty_two_bytes_in_eight_transactions_per_frame() {
    let (mut driver, shared) = mcp2515(mcp2515::regs::OpMode::Normal);
    shared.0.borrow_mut().receive(extended(0x18FE_F100, &[0; 8]));
    let before = shared.0.borrow().chip.counters();
    driver.read_message().unwrap();
    let after = shared.0.borrow().chip.counters();
    let cost = (after.spi_bytes - before.spi_bytes, after.spi_transactions - before.spi_transactions);
    assert_eq!(cost, (32, 8));
}

#[test]
fn mcp2515_leaves_int_low_after_an_error_and_an_edge_would_never_come_again() {
    // It enables ERRIE and MERRE and never clears their flags: the hang of davidcole1340/mcp2515-rs#8.
    let (mut driver, shared) = mcp2515(mcp2515::regs::OpMode::Normal);
    {
        let mut rig = shared.0.borrow_mut();
        rig.bus.attach("ear");
        let node = rig.chip.node();
        rig.bus.garble_receptions(node, 1);
        rig.receive(standard(0x100, &[1]));
    }
    driver.read_message().unwrap();
    let rig = shared.0.borrow();
    assert!(!rig.chip.int_level());
    assert_eq!(rig.bus.pending(rig.peer), 0);
}

#[test]
fn mcp2515_meets_the_repeated_frame_erratum() {
    let shared = Shared::new(Rig::new(Config { repeats_frames: true, ..Config::default() }));
    let mut driver = mcp2515::MCP2515::new(shared.clone());
    let settings =
        mcp2515::Settings { can_speed: mcp2515::CanSpeed::Kbps250, ..mcp2515::Settings::default() };
    driver.init(&mut shared.clone(), settings).unwrap();
    let frame = mcp2515::frame::CanFrame::new(StandardId::ZERO, &[1]).unwrap();
    driver.send_message(frame).unwrap();
    let mut rig = shared.0.borrow_mut();
    rig.wait(Nanos::from_millis(3));
    assert_eq!(rig.heard.len(), 2);
}
