//! The driver against a script: exact bytes per transaction, and one broken reply per call.

use core::cell::RefCell;
use core::convert::Infallible;
use embedded_can::{ExtendedId, Frame, Id, StandardId};
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{ErrorType as PinErrorType, InputPin};
use embedded_hal::spi::{ErrorType, Operation, SpiDevice};
use mcp2515_can::driver::{BUS_OFF_LIMIT_MS, BUS_OFF_SILENCE_MS, TRANSMIT_LIMIT_MS, Verdict};
use mcp2515_can::*;
use std::collections::VecDeque;
use std::rc::Rc;

/// What the chip would do next: an answer to exactly these bytes, with the level of INT after it.
struct Exchange {
    sent: Vec<u8>,
    answer: Vec<u8>,
    int_high_after: bool,
}

#[derive(Default)]
struct Wire {
    script: VecDeque<Exchange>,
    int_high: bool,
    bytes: usize,
}

#[derive(Clone, Default)]
struct Chip(Rc<RefCell<Wire>>);

impl Chip {
    /// Expects `sent`, answers `answer` (padded with zeros), leaves INT as it is.
    fn expect(&self, sent: &[u8], answer: &[u8]) {
        let int_high_after =
            self.0.borrow().script.back().map_or(self.0.borrow().int_high, |e| e.int_high_after);
        self.expect_int(sent, answer, int_high_after);
    }

    fn expect_int(&self, sent: &[u8], answer: &[u8], int_high_after: bool) {
        self.0.borrow_mut().script.push_back(Exchange {
            sent: sent.into(),
            answer: answer.into(),
            int_high_after,
        });
    }

    fn int(&self, high: bool) {
        self.0.borrow_mut().int_high = high;
    }

    fn finish(&self) -> usize {
        let mut wire = self.0.borrow_mut();
        assert!(wire.script.is_empty(), "{} exchanges were never made", wire.script.len());
        core::mem::take(&mut wire.bytes)
    }
}

impl ErrorType for Chip {
    type Error = Infallible;
}

impl SpiDevice for Chip {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let mut sent = Vec::new();
        for operation in operations.iter() {
            match operation {
                Operation::Write(bytes) => sent.extend_from_slice(bytes),
                Operation::TransferInPlace(bytes) => sent.extend_from_slice(bytes),
                Operation::Read(bytes) => sent.resize(sent.len() + bytes.len(), 0),
                _ => panic!("the driver has no use for this operation"),
            }
        }
        let mut wire = self.0.borrow_mut();
        let Some(exchange) = wire.script.pop_front() else { panic!("not in the script: {sent:02x?}") };
        assert_eq!(sent, exchange.sent, "sent {sent:02x?}, script says {:02x?}", exchange.sent);
        wire.int_high = exchange.int_high_after;
        wire.bytes += sent.len();
        let mut answer = exchange.answer.into_iter().chain(core::iter::repeat(0));
        for operation in operations {
            match operation {
                Operation::TransferInPlace(bytes) => bytes.fill_with(|| answer.next().unwrap()),
                Operation::Read(bytes) => bytes.fill_with(|| answer.next().unwrap()),
                Operation::Write(bytes) => answer.by_ref().take(bytes.len()).for_each(drop),
                _ => {}
            }
        }
        Ok(())
    }
}

struct IntPin(Chip);

impl PinErrorType for IntPin {
    type Error = Infallible;
}

impl InputPin for IntPin {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        Ok(self.0.0.borrow().int_high)
    }
    fn is_low(&mut self) -> Result<bool, Infallible> {
        Ok(!self.0.0.borrow().int_high)
    }
}

#[derive(Default)]
struct Waited(u64);

impl DelayNs for Waited {
    fn delay_ns(&mut self, ns: u32) {
        self.0 += u64::from(ns);
    }
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct TestFrame(Id, Vec<u8>);

impl Frame for TestFrame {
    fn new(id: impl Into<Id>, data: &[u8]) -> Option<Self> {
        Some(Self(id.into(), data.into()))
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

const CONFIG: Config =
    Config { oscillator: Oscillator::Mhz8, bitrate: 250_000, mode: Mode::Normal, acceptance: None };

const READ_CANSTAT: [u8; 4] = [0x03, 0x0E, 0, 0];
const READ_FLAGS: [u8; 4] = [0x03, 0x2C, 0, 0];
const RX_STATUS: [u8; 2] = [0xB0, 0];
const READ_STATUS: [u8; 2] = [0xA0, 0];

/// What is written in configuration mode without acceptance filters, in blocks of neighbouring registers.
const CONFIGURATION: [&[u8]; 7] = [
    &[0x02, 0x00, 0, 0, 0, 0, 0, 0x08, 0, 0, 0, 0, 0, 0],
    &[0x02, 0x10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    &[0x02, 0x20, 0, 0, 0, 0, 0, 0, 0, 0, 0x01, 0xBC, 0x00, 0x23],
    &[0x02, 0x30, 0x00],
    &[0x02, 0x60, 0x04],
    &[0x02, 0x70, 0x00],
    &[0x02, 0x2C, 0x00],
];

/// Expects the configuration to be written, and then read back up to and including block `last`. `disturb` may change
/// what is read of it.
fn expect_configuration(chip: &Chip, last: usize, disturb: impl Fn(&mut Vec<u8>)) {
    for block in CONFIGURATION {
        chip.expect(block, &[]);
    }
    for (number, block) in CONFIGURATION.into_iter().enumerate().take(last + 1) {
        let mut sent = vec![0; block.len()];
        sent[..2].copy_from_slice(&[0x03, block[1]]);
        let mut answer = block.to_vec();
        if block[1] == 0x60 {
            // BUKT has a read-only copy, and FILHIT0 is unknown.
            answer[2] |= 0x03;
        }
        if number == last {
            disturb(&mut answer);
        }
        chip.expect(&sent, &answer);
    }
}

fn expect_start(chip: &Chip, mode: u8) {
    chip.expect(&[0xC0], &[]);
    chip.expect(&READ_CANSTAT, &[0, 0, 0x80, 0x87]);
    expect_configuration(chip, CONFIGURATION.len() - 1, |_| {});
    expect_mode(chip, mode);
}

/// Expects a request for `mode`, which the chip follows at once.
fn expect_mode(chip: &Chip, mode: u8) {
    chip.expect(&[0x02, 0x0F, mode | 0x03], &[]);
    for _ in 0..2 {
        chip.expect(&READ_CANSTAT, &[0, 0, mode, mode | 0x03]);
    }
}

type Driver = Mcp2515<Chip, IntPin>;

fn start(chip: &Chip, config: Config) -> Result<Driver, StartError<Infallible>> {
    Mcp2515::new(chip.clone(), IntPin(chip.clone()), config, &mut Waited::default())
        .map_err(|refused| refused.error)
}

fn started() -> (Chip, Driver) {
    let chip = Chip::default();
    chip.int(true);
    expect_start(&chip, 0x00);
    let driver = start(&chip, CONFIG).unwrap();
    chip.finish();
    chip.int(false);
    (chip, driver)
}

/// The bytes of READ RX BUFFER and the answer that carries a 29-bit frame with `last` as its only data byte.
fn expect_read(chip: &Chip, instruction: u8, last: u8, int_high_after: bool) {
    let mut sent = vec![instruction];
    sent.resize(14, 0);
    chip.expect_int(&sent, &[0, 0xC7, 0xEB, 0x4D, 0x17, 1, last], int_high_after);
}

fn service(driver: &mut Driver) -> (Serviced, Vec<u8>) {
    let mut data = Vec::new();
    let serviced = driver.service(|TestFrame(_, bytes)| data.push(bytes[0])).unwrap();
    (serviced, data)
}

#[test]
fn start_up_sends_exactly_these_bytes_and_writes_the_solved_bit_timing() {
    let (chip, driver) = started();
    assert_eq!(driver.health(), Health::default());
    chip.finish();
}

#[test]
fn a_missing_chip_is_refused_with_what_was_expected_and_read() {
    for floating in [0xFF, 0x00] {
        let chip = Chip::default();
        chip.expect(&[0xC0], &[]);
        for _ in 0..20 {
            chip.expect(&READ_CANSTAT, &[floating; 4]);
        }
        let error = start(&chip, CONFIG).err().unwrap();
        assert_eq!(error, StartError::Probe { expected: [0x80, 0x07], actual: [floating, floating & 0x17] });
        assert!(error.to_string().contains("check wiring"), "{error}");
        chip.finish();
    }
}

#[test]
fn a_crystal_that_starts_slowly_is_waited_for() {
    let chip = Chip::default();
    chip.expect(&[0xC0], &[]);
    for _ in 0..19 {
        chip.expect(&READ_CANSTAT, &[0; 4]);
    }
    chip.expect(&READ_CANSTAT, &[0, 0, 0x80, 0x87]);
    expect_configuration(&chip, CONFIGURATION.len() - 1, |_| {});
    expect_mode(&chip, 0x00);
    assert!(start(&chip, CONFIG).is_ok());
    chip.finish();
}

#[test]
fn any_register_that_does_not_read_back_is_refused_by_its_address() {
    for (number, block) in CONFIGURATION.into_iter().enumerate() {
        for place in 2..block.len() {
            let chip = Chip::default();
            chip.expect(&[0xC0], &[]);
            chip.expect(&READ_CANSTAT, &[0, 0, 0x80, 0x87]);
            // One of the bits that count in every register: TXREQ, RXM, or all of them.
            let bit = if block[1] == 0x30 { 0x08 } else { 0x40 };
            expect_configuration(&chip, number, |answer| answer[place] ^= bit);
            let expected = block[place];
            let address = block[1] + place as u8 - 2;
            let refusal = StartError::Readback { address, expected, actual: expected ^ bit };
            assert_eq!(start(&chip, CONFIG).err(), Some(refusal));
            chip.finish();
        }
    }
}

#[test]
fn a_mode_that_never_comes_is_refused_after_a_bounded_wait() {
    // The chip stays where it is; a line that is stuck low looks like normal mode in CANSTAT alone.
    for (mode, asked, read) in [
        (Mode::ListenOnly, 0x60, [0x80, 0x63]),
        (Mode::Normal, 0x00, [0, 0]),
        (Mode::Loopback, 0x40, [0xE0, 0xFF]),
    ] {
        let chip = Chip::default();
        chip.expect(&[0xC0], &[]);
        chip.expect(&READ_CANSTAT, &[0, 0, 0x80, 0x87]);
        expect_configuration(&chip, CONFIGURATION.len() - 1, |_| {});
        chip.expect(&[0x02, 0x0F, asked | 0x03], &[]);
        for _ in 0..20 {
            chip.expect(&READ_CANSTAT, &[0, 0, read[0], read[1]]);
        }
        let refusal = StartError::Mode { expected: [asked, asked | 0x03], actual: read };
        assert_eq!(start(&chip, Config { mode, ..CONFIG }).err(), Some(refusal));
        chip.finish();
    }
}

#[test]
fn refusals_are_counted_by_reason() {
    let mut refusals = Refusals::default();
    refusals.note(&StartError::<Infallible>::Probe { expected: [0; 2], actual: [0; 2] });
    for _ in 0..2 {
        refusals.note(&StartError::<Infallible>::Readback { address: 0, expected: 0, actual: 1 });
    }
    refusals.note(&StartError::<Infallible>::Mode { expected: [0; 2], actual: [1; 2] });
    refusals.note(&StartError::<Infallible>::Timing(TimingError::NoExactRate));
    refusals.note(&StartError::Spi(()));
    assert_eq!(refusals, Refusals { probe: 1, readback: 2, mode: 1, timing: 1, spi: 1 });
    assert_eq!(refusals.total(), 6);
}

#[test]
fn acceptance_filters_and_masks_are_written_where_they_belong() {
    let id = |raw| Id::from(StandardId::new(raw).unwrap());
    let extended = Id::from(ExtendedId::new(0x18FF_4D17).unwrap());
    let acceptance =
        Acceptance { masks: [id(0x7FF), extended], filters: [id(1), id(2), extended, id(4), id(5), id(6)] };
    let chip = Chip::default();
    chip.expect(&[0xC0], &[]);
    chip.expect(&READ_CANSTAT, &[0, 0, 0x80, 0x87]);
    let banks: [&[u8]; 3] = [
        &[0x02, 0x00, 0x00, 0x20, 0, 0, 0x00, 0x40, 0, 0, 0xC7, 0xEB, 0x4D, 0x17],
        &[0x02, 0x10, 0x00, 0x80, 0, 0, 0x00, 0xA0, 0, 0, 0x00, 0xC0, 0, 0],
        &[0x02, 0x20, 0xFF, 0xE0, 0, 0, 0xC7, 0xE3, 0x4D, 0x17, 0x01, 0xBC, 0x00, 0x23],
    ];
    for block in banks.into_iter().chain(CONFIGURATION.into_iter().skip(3)) {
        chip.expect(block, &[]);
    }
    for block in banks.into_iter().chain(CONFIGURATION.into_iter().skip(3)) {
        let mut sent = vec![0; block.len()];
        sent[..2].copy_from_slice(&[0x03, block[1]]);
        chip.expect(&sent, block);
    }
    expect_mode(&chip, 0x00);
    assert!(start(&chip, Config { acceptance: Some(acceptance), ..CONFIG }).is_ok());
    chip.finish();
}

#[test]
fn a_rate_that_the_crystal_cannot_give_is_refused_before_the_chip_is_touched() {
    let chip = Chip::default();
    let config = Config { bitrate: 1_000_000, ..CONFIG };
    assert_eq!(start(&chip, config).err(), Some(StartError::Timing(TimingError::CrystalTooSlow)));
    chip.finish();
}

#[test]
fn a_change_of_mode_is_one_instruction_and_keeps_frames_and_counters() {
    let (chip, mut driver) = started();
    chip.expect(&RX_STATUS, &[0, 0x40]);
    expect_read(&chip, 0x90, 7, true);
    service(&mut driver);
    chip.expect(&[0x05, 0x0F, 0xE0, 0x60], &[]);
    driver.change_mode(Mode::ListenOnly).unwrap();
    assert_eq!((driver.config().mode, driver.health().received), (Mode::ListenOnly, 1));
    chip.finish();
}

#[test]
fn a_message_error_is_told_once_and_nothing_else_is_cleared() {
    let (chip, mut driver) = started();
    chip.expect(&[0x03, 0x2C, 0, 0], &[0, 0, 0x00, 0]);
    assert!(!driver.take_message_error().unwrap());
    chip.expect(&[0x03, 0x2C, 0, 0], &[0, 0, 0xA3, 0]);
    chip.expect(&[0x05, 0x2C, 0x80, 0], &[]);
    assert!(driver.take_message_error().unwrap());
    chip.finish();
}

#[test]
fn one_frame_costs_16_bytes() {
    let (chip, mut driver) = started();
    chip.expect(&RX_STATUS, &[0, 0x40]);
    expect_read(&chip, 0x90, 7, true);
    assert_eq!(service(&mut driver), (Serviced { frames: 1, drained: true }, vec![7]));
    assert_eq!(chip.finish(), 16);
}

#[test]
fn two_waiting_frames_cost_30_bytes_and_come_in_order() {
    let (chip, mut driver) = started();
    chip.expect(&RX_STATUS, &[0, 0xC0]);
    expect_read(&chip, 0x90, 1, false);
    expect_read(&chip, 0x94, 2, true);
    assert_eq!(service(&mut driver), (Serviced { frames: 2, drained: true }, vec![1, 2]));
    assert_eq!(chip.finish(), 30);
}

#[test]
fn a_frame_that_rolls_over_during_the_read_is_not_overtaken() {
    let (chip, mut driver) = started();
    chip.expect(&RX_STATUS, &[0, 0x40]);
    expect_read(&chip, 0x90, 1, false);
    // RXB1 filled while RXB0 was read, RXB0 filled again right after its release.
    chip.expect(&RX_STATUS, &[0, 0xC0]);
    expect_read(&chip, 0x94, 2, false);
    expect_read(&chip, 0x90, 3, true);
    assert_eq!(service(&mut driver).1, [1, 2, 3]);
    chip.finish();
}

#[test]
fn remote_frames_are_counted_and_dropped() {
    let (chip, mut driver) = started();
    chip.expect(&RX_STATUS, &[0, 0x40]);
    let mut sent = vec![0x90];
    sent.resize(14, 0);
    chip.expect_int(&sent, &[0, 0xC7, 0xEB, 0x4D, 0x17, 0x48], true);
    assert_eq!(service(&mut driver), (Serviced { frames: 0, drained: true }, vec![]));
    assert_eq!((driver.health().remote, driver.health().received), (1, 0));
    chip.finish();
}

#[test]
fn an_overrun_is_counted_and_cleared_eflg_first() {
    let (chip, mut driver) = started();
    chip.expect(&RX_STATUS, &[0, 0x00]);
    chip.expect(&READ_FLAGS, &[0, 0, 0x20, 0x80]);
    chip.expect(&[0x05, 0x2D, 0x80, 0x00], &[]);
    chip.expect_int(&[0x05, 0x2C, 0x20, 0x00], &[], true);
    assert!(service(&mut driver).0.drained);
    assert_eq!(driver.health().overruns, 1);
    chip.finish();
}

#[test]
fn a_stuck_int_ends_the_service_and_is_counted() {
    let (chip, mut driver) = started();
    for _ in 0..8 {
        chip.expect(&RX_STATUS, &[0, 0x00]);
        chip.expect(&READ_FLAGS, &[0, 0, 0x00, 0x00]);
    }
    assert_eq!(service(&mut driver).0, Serviced { frames: 0, drained: false });
    assert_eq!(driver.health().undrained, 1);
    chip.finish();
}

fn frame() -> TestFrame {
    TestFrame(Id::Extended(ExtendedId::new(0x18FF_4D17).unwrap()), vec![1, 2, 3])
}

const LOAD: [u8; 9] = [0x40, 0xC7, 0xEB, 0x4D, 0x17, 3, 1, 2, 3];

#[test]
fn a_frame_is_sent_by_load_and_rts_and_counted_when_it_is_out() {
    let (chip, mut driver) = started();
    chip.expect(&LOAD, &[]);
    chip.expect(&[0x81], &[]);
    driver.transmit(&frame(), 0).unwrap();
    chip.expect(&READ_STATUS, &[0, 0x04]);
    assert_eq!(driver.transmit(&frame(), 10), Err(TransmitError::Busy));
    assert_eq!(driver.health().sent, 0);
    chip.expect(&READ_STATUS, &[0, 0x00]);
    chip.expect(&[0x40, 0x24, 0x60, 0, 0, 0], &[]);
    chip.expect(&[0x81], &[]);
    let short = TestFrame(Id::Standard(StandardId::new(0x123).unwrap()), vec![]);
    driver.transmit(&short, 20).unwrap();
    assert_eq!(driver.health().sent, 1);
    chip.finish();
}

#[test]
fn a_frame_that_nobody_acknowledges_is_given_up_and_counted() {
    let (chip, mut driver) = started();
    chip.expect(&LOAD, &[]);
    chip.expect(&[0x81], &[]);
    driver.transmit(&frame(), 0).unwrap();
    chip.expect(&READ_STATUS, &[0, 0x04]);
    chip.expect(&[0x05, 0x30, 0x08, 0x00], &[]);
    chip.expect(&READ_STATUS, &[0, 0x00]);
    chip.expect(&LOAD, &[]);
    chip.expect(&[0x81], &[]);
    driver.transmit(&frame(), TRANSMIT_LIMIT_MS).unwrap();
    assert_eq!((driver.health().aborted, driver.health().sent), (1, 0));
    chip.finish();
}

#[test]
fn listen_only_never_drives_the_bus() {
    let chip = Chip::default();
    expect_start(&chip, 0x60);
    let mut driver = start(&chip, Config { mode: Mode::ListenOnly, ..CONFIG }).unwrap();
    assert_eq!(driver.transmit(&frame(), 0), Err(TransmitError::ListenOnly));
    chip.finish();
}

fn expect_supervision(chip: &Chip, eflg: u8, tec: u8) {
    chip.expect(&READ_CANSTAT, &[0, 0, 0x00, 0x03]);
    chip.expect(&READ_FLAGS, &[0, 0, 0x00, eflg]);
    chip.expect(&[0x03, 0x1C, 0, 0], &[0, 0, tec, 9]);
}

#[test]
fn supervision_reports_the_error_counters_and_state() {
    let (chip, mut driver) = started();
    expect_supervision(&chip, 0x15, 130);
    chip.expect(&RX_STATUS, &[0, 0]);
    assert_eq!(driver.supervise(0), Ok(Verdict::Well));
    let health = driver.health();
    assert_eq!((health.transmit_errors, health.receive_errors, health.state), (130, 9, BusState::Passive));
    chip.finish();
}

#[test]
fn bus_off_is_counted_once_and_ends_in_a_restart() {
    let (chip, mut driver) = started();
    for (now_ms, verdict) in [(0, Verdict::Well), (BUS_OFF_LIMIT_MS - 1, Verdict::Well)] {
        expect_supervision(&chip, 0x35, 255);
        chip.expect(&RX_STATUS, &[0, 0]);
        assert_eq!(driver.supervise(now_ms), Ok(verdict));
    }
    expect_supervision(&chip, 0x35, 255);
    assert_eq!(driver.supervise(BUS_OFF_LIMIT_MS), Ok(Verdict::Restart));
    assert_eq!((driver.health().bus_offs, driver.health().state), (1, BusState::BusOff));
    expect_start(&chip, 0x00);
    driver.restart(&mut Waited::default()).unwrap();
    assert_eq!(driver.health().restarts, 1);
    chip.finish();
}

#[test]
fn bus_off_that_ends_by_itself_starts_its_limit_anew() {
    let (chip, mut driver) = started();
    for (now_ms, eflg) in [(0, 0x35), (500, 0x00), (BUS_OFF_LIMIT_MS + 100, 0x35)] {
        expect_supervision(&chip, eflg, 0);
        chip.expect(&RX_STATUS, &[0, 0]);
        assert_eq!(driver.supervise(now_ms), Ok(Verdict::Well));
    }
    assert_eq!(driver.health().bus_offs, 2);
    chip.finish();
}

#[test]
fn a_restart_that_did_not_help_is_given_its_second_before_the_next() {
    let (chip, mut driver) = started();
    for (now_ms, verdict) in [(0, Verdict::Well), (BUS_OFF_LIMIT_MS, Verdict::Restart)] {
        expect_supervision(&chip, 0x35, 255);
        if verdict == Verdict::Well {
            chip.expect(&RX_STATUS, &[0, 0]);
        }
        assert_eq!(driver.supervise(now_ms), Ok(verdict));
    }
    expect_start(&chip, 0x00);
    driver.restart(&mut Waited::default()).unwrap();
    assert_eq!(driver.health().state, BusState::Active, "a reset clears the error counters");
    let again = BUS_OFF_LIMIT_MS + 100;
    for (now_ms, verdict) in [(again, Verdict::Well), (again + BUS_OFF_LIMIT_MS, Verdict::Restart)] {
        expect_supervision(&chip, 0x35, 255);
        if verdict == Verdict::Well {
            chip.expect(&RX_STATUS, &[0, 0]);
        }
        assert_eq!(driver.supervise(now_ms), Ok(verdict), "{now_ms} ms");
    }
    assert_eq!(driver.health().bus_offs, 2);
    chip.finish();
}

#[test]
fn bus_off_takes_the_waiting_frame_back_and_nothing_is_sent_for_a_second() {
    let (chip, mut driver) = started();
    chip.expect(&LOAD, &[]);
    chip.expect(&[0x81], &[]);
    driver.transmit(&frame(), 0).unwrap();
    // ERRIF interrupts; the service has no clock.
    chip.expect(&RX_STATUS, &[0, 0x00]);
    chip.expect(&READ_FLAGS, &[0, 0, 0x20, 0x35]);
    chip.expect(&[0x05, 0x2C, 0x20, 0x00], &[]);
    chip.expect_int(&[0x05, 0x30, 0x08, 0x00], &[], true);
    assert!(service(&mut driver).0.drained);
    let health = driver.health();
    assert_eq!((health.bus_offs, health.aborted, health.sent), (1, 1, 0));
    assert_eq!(driver.transmit(&frame(), 10), Err(TransmitError::Silent));
    // A restart is no way round it.
    chip.int(false);
    expect_start(&chip, 0x00);
    driver.restart(&mut Waited::default()).unwrap();
    assert_eq!(driver.transmit(&frame(), 10 + BUS_OFF_SILENCE_MS - 1), Err(TransmitError::Silent));
    chip.expect(&LOAD, &[]);
    chip.expect(&[0x81], &[]);
    driver.transmit(&frame(), 10 + BUS_OFF_SILENCE_MS).unwrap();
    chip.finish();
}

#[test]
fn a_chip_that_fell_back_into_configuration_mode_or_is_heard_no_more_is_restarted() {
    for answer in [[0, 0, 0x80, 0x87], [0xFF; 4], [0x00; 4]] {
        let (chip, mut driver) = started();
        chip.expect(&READ_CANSTAT, &answer);
        assert_eq!(driver.supervise(0), Ok(Verdict::Restart), "{answer:02x?}");
        chip.finish();
    }
}

#[test]
fn a_broken_int_wire_is_noticed_because_a_frame_waits_behind_it() {
    let (chip, mut driver) = started();
    chip.int(true);
    for exchange in
        [(&READ_CANSTAT[..], [0, 0, 0, 0x03]), (&READ_FLAGS[..], [0; 4]), (&[0x03, 0x1C, 0, 0], [0; 4])]
    {
        chip.expect_int(exchange.0, &exchange.1, true);
    }
    chip.expect_int(&RX_STATUS, &[0, 0x40], true);
    assert_eq!(driver.supervise(0), Ok(Verdict::FrameWaiting));
    assert_eq!(driver.health().missed_interrupts, 1);
    // Polling works with INT high: the first pass reads without looking at it.
    chip.expect_int(&RX_STATUS, &[0, 0x40], true);
    expect_read(&chip, 0x90, 5, true);
    assert_eq!(service(&mut driver).1, [5]);
    chip.finish();
}
