//! The cluster's own driver starts a chip over a bad contact: it is refused or the chip is configured, never a panic.

mod mcp2515_rig;

use std::cell::Cell;
use std::convert::Infallible;
use std::rc::Rc;

use bench::chips::mcp2515 as chip;
use bench::time::Nanos;
use embedded_hal::digital::{ErrorType as PinErrorType, InputPin};
use embedded_hal::spi::{ErrorType, Operation, SpiDevice};
use mcp2515_can::{Config, Mcp2515, Mode, Oscillator, StartError};
use mcp2515_rig::*;

/// A byte on its way: transaction of the start, place in it, what was sent.
#[derive(Clone, Copy)]
struct Byte {
    transaction: usize,
    place: usize,
    value: u8,
}

/// The wires between the driver and the chip model, and what becomes of each byte on them.
struct Wires<MOSI, MISO> {
    rig: Shared,
    /// Transactions so far.
    transactions: Rc<Cell<usize>>,
    mosi: MOSI,
    miso: MISO,
}

impl<MOSI, MISO> ErrorType for Wires<MOSI, MISO> {
    type Error = Infallible;
}

impl<MOSI: FnMut(Byte) -> u8, MISO: FnMut(Byte) -> u8> SpiDevice for Wires<MOSI, MISO> {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let transaction = self.transactions.replace(self.transactions.get() + 1);
        let mut sent = Vec::new();
        for operation in operations.iter() {
            match operation {
                Operation::Write(bytes) => sent.extend_from_slice(bytes),
                Operation::TransferInPlace(bytes) => sent.extend_from_slice(bytes),
                Operation::Read(bytes) => sent.resize(sent.len() + bytes.len(), 0),
                _ => panic!("the driver has no use for this operation"),
            }
        }
        let bytes = (0..).zip(sent).map(|(place, value)| (self.mosi)(Byte { transaction, place, value }));
        let answer = self.rig.0.borrow_mut().transaction(&bytes.collect::<Vec<u8>>());
        let mut seen =
            (0..).zip(answer).map(|(place, value)| (self.miso)(Byte { transaction, place, value }));
        for operation in operations {
            match operation {
                Operation::Read(bytes) | Operation::TransferInPlace(bytes) => {
                    bytes.fill_with(|| seen.next().unwrap_or_default());
                }
                Operation::Write(bytes) => seen.by_ref().take(bytes.len()).for_each(drop),
                _ => {}
            }
        }
        Ok(())
    }
}

struct Int(Shared);

impl PinErrorType for Int {
    type Error = Infallible;
}

impl InputPin for Int {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        Ok(self.0.0.borrow().chip.int_level())
    }

    fn is_low(&mut self) -> Result<bool, Infallible> {
        self.is_high().map(|high| !high)
    }
}

const CONFIG: Config =
    Config { oscillator: Oscillator::Mhz16, bitrate: BITRATE, mode: Mode::Normal, acceptance: None };

/// What one start left behind.
struct Start {
    result: Result<(), StartError<Infallible>>,
    rig: Shared,
    transactions: usize,
}

fn start(mosi: impl FnMut(Byte) -> u8, miso: impl FnMut(Byte) -> u8) -> Start {
    let rig = Shared::new(Rig::new(chip::Config::default()));
    let transactions = Rc::new(Cell::new(0));
    let wires = Wires { rig: rig.clone(), transactions: transactions.clone(), mosi, miso };
    let started = Mcp2515::new(wires, Int(rig.clone()), CONFIG, &mut rig.clone());
    let result = started.map(drop).map_err(|refused| refused.error);
    Start { result, rig, transactions: transactions.get() }
}

fn undisturbed(byte: Byte) -> u8 {
    byte.value
}

/// Asserts that a chip whose start succeeded does what it was to do.
fn assert_configured(rig: &Shared, how: &str) {
    let rig = &mut *rig.0.borrow_mut();
    assert_eq!(rig.chip.mode(), chip::Mode::Normal, "{how}");
    assert_eq!(rig.chip.bit_timing().bitrate(16_000_000), BITRATE, "{how}");
    let register = |address| rig.chip.peek(address, &rig.bus);
    assert_eq!(register(CANINTE), 0x23, "{how}");
    assert_eq!(register(CANCTRL) & 0xF8, 0, "{how}: one-shot or an abort is left on");
    assert_eq!((register(RXB0CTRL) & 0x64, register(RXB1CTRL) & 0x60), (0x04, 0), "{how}");
    rig.receive(standard(0x2AA, &[0x55, 0xAA]));
    rig.receive(extended(0x1555_5555, &[0x55, 0xAA]));
    assert_eq!(rig.chip.counters().frames_stored, [1, 1], "{how}: both kinds of identifier come in");
}

#[test]
fn a_start_takes_less_than_a_millisecond() {
    let start = start(undisturbed, undisturbed);
    assert_eq!(start.result, Ok(()));
    let took = start.rig.0.borrow().now.since(Nanos::from_millis(1));
    println!("a start takes {took} and {} transactions", start.transactions);
    assert!(took < Nanos::from_millis(1), "{took}");
    assert_configured(&start.rig, "undisturbed");
    start.rig.0.borrow().no_violations();
}

#[test]
fn a_contact_that_is_lost_at_any_transaction_is_refused_with_what_was_expected_and_read() {
    for floating in [0xFF, 0x00] {
        for lost in 0..start(undisturbed, undisturbed).transactions {
            let miso = |byte: Byte| if byte.transaction >= lost { floating } else { byte.value };
            let error = start(undisturbed, miso).result.expect_err("nothing is heard of the chip any more");
            let text = error.to_string();
            assert!(text.contains("check") && !matches!(error, StartError::Timing(_)), "{lost}: {text}");
        }
    }
}

#[test]
fn one_wrong_byte_at_any_place_of_a_start_leaves_a_configured_chip_or_a_refusal() {
    let wrong: [fn(u8) -> u8; 10] = [
        |_| 0xFF,
        |_| 0x00,
        |_| 0x80,
        |_| 0xE0,
        |_| 0x20,
        |byte| !byte,
        |byte| byte ^ 0x01,
        |byte| byte ^ 0x08,
        |byte| byte ^ 0x40,
        |byte| byte << 1,
    ];
    for transaction in 0..start(undisturbed, undisturbed).transactions {
        for place in 0..16 {
            for (index, wrong) in (0..).zip(wrong) {
                let disturbed = |byte: Byte| match byte {
                    _ if (byte.transaction, byte.place) == (transaction, place) => wrong(byte.value),
                    _ => byte.value,
                };
                let how = format!("value {index} at byte {place} of transaction {transaction}");
                for start in [start(undisturbed, disturbed), start(disturbed, undisturbed)] {
                    if start.result.is_ok() {
                        assert_configured(&start.rig, &how);
                    }
                }
            }
        }
    }
}

#[test]
fn thousands_of_noisy_starts_leave_a_configured_chip_or_a_refusal() {
    let mut seed = 0x2515_u64;
    let mut random = || {
        // Knuth's MMIX generator; its upper bits are good.
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize
    };
    let (mut started, mut refused) = (0, 0);
    for round in 0..20_000 {
        let one_in = [1_000, 200, 20, 5][round % 4];
        let noise = std::cell::RefCell::new(&mut random);
        let disturbed = |byte: Byte| {
            let mut random = noise.borrow_mut();
            if random() % one_in == 0 { random() as u8 } else { byte.value }
        };
        let start = if round % 8 < 4 { start(undisturbed, disturbed) } else { start(disturbed, disturbed) };
        if start.result.is_ok() {
            assert_configured(&start.rig, &format!("round {round}"));
            started += 1;
        } else {
            refused += 1;
        }
    }
    println!("{started} started, {refused} refused");
    assert!(started > 1_000 && refused > 1_000, "{started} started, {refused} refused");
}
