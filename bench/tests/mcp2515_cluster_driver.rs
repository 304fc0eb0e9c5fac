//! The cluster's own driver against the MCP2515 model: nothing lost, nothing out of order, all losses counted.

mod mcp2515_rig;

use std::convert::Infallible;

use bench::can::bits::FrameBits;
use bench::can::{Confinement, EventKind, Frame, Id, LoadGenerator, Participant, Tag};
use bench::chips::mcp2515 as chip;
use bench::time::Nanos;
use embedded_can::Frame as _;
use embedded_hal::digital::{ErrorType, InputPin};
use mcp2515::frame::CanFrame;
use mcp2515_can::{BusState, Config, Mcp2515, Mode, Oscillator, StartError};
use mcp2515_rig::*;

struct Int(Shared);

impl ErrorType for Int {
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

type Driver = Mcp2515<Shared, Int>;

fn config(oscillator: Oscillator, mode: Mode) -> Config {
    Config { oscillator, bitrate: BITRATE, mode, acceptance: None }
}

fn start(crystal_hz: u32, config: Config) -> (Result<Driver, StartError<Infallible>>, Shared) {
    let shared = Shared::new(Rig::new(chip::Config { crystal_hz, ..chip::Config::default() }));
    let driver = Mcp2515::new(shared.clone(), Int(shared.clone()), config, &mut shared.clone());
    (driver.map_err(|refused| refused.error), shared)
}

fn normal() -> (Driver, Shared) {
    let (driver, shared) = start(16_000_000, config(Oscillator::Mhz16, Mode::Normal));
    (driver.expect("starts"), shared)
}

/// Serves the chip and appends the sequence numbers that came.
fn serve(driver: &mut Driver, sequence: &mut Vec<u64>) {
    let served = driver
        .service(|frame: CanFrame| {
            sequence.push(u64::from_le_bytes(frame.data().try_into().unwrap_or_default()));
        })
        .unwrap();
    assert!(served.drained);
}

fn numbered(n: u64) -> Frame {
    extended(0x1555_5555, &n.to_le_bytes())
}

#[test]
fn it_starts_in_every_mode_and_with_every_crystal_without_breaking_a_rule() {
    for (crystal_hz, oscillator) in [(8_000_000, Oscillator::Mhz8), (16_000_000, Oscillator::Mhz16)] {
        for (mode, expected) in [
            (Mode::Normal, chip::Mode::Normal),
            (Mode::ListenOnly, chip::Mode::ListenOnly),
            (Mode::Loopback, chip::Mode::Loopback),
        ] {
            let (driver, shared) = start(crystal_hz, config(oscillator, mode));
            assert!(driver.is_ok());
            let rig = shared.0.borrow();
            assert_eq!(rig.chip.mode(), expected);
            assert_eq!(rig.chip.bit_timing().bitrate(crystal_hz), BITRATE);
            rig.no_violations();
        }
    }
}

#[test]
fn a_bus_that_is_stuck_keeps_it_from_starting() {
    let shared = Shared::new(Rig::new(chip::Config::default()));
    shared.0.borrow_mut().bus.short(Nanos::ZERO, true);
    let settings = config(Oscillator::Mhz16, Mode::Normal);
    let mut delay = shared.clone();
    let refused = Mcp2515::new(shared.clone(), Int(shared), settings, &mut delay).err();
    assert!(matches!(refused.map(|r| r.error), Some(StartError::Mode { expected: [0, _], .. })));
}

#[test]
fn it_sends_and_hears_both_kinds_of_identifier() {
    let (mut driver, shared) = normal();
    for (n, wire) in [standard(0x123, &[1, 2]), extended(0x18FE_F100, &[1, 2])].into_iter().enumerate() {
        let id: embedded_can::Id = match wire.id {
            Id::Standard(id) => embedded_can::StandardId::new(id.raw()).unwrap().into(),
            Id::Extended(id) => embedded_can::ExtendedId::new(id.raw()).unwrap().into(),
        };
        driver.transmit(&CanFrame::new(id, &[1, 2]).unwrap(), n as u64).unwrap();
        shared.0.borrow_mut().wait(Nanos::from_millis(1));
        assert_eq!(shared.0.borrow().heard.last().map(|&(_, frame)| frame), Some(wire));
        shared.0.borrow_mut().receive(wire);
        let mut got = Vec::new();
        driver.service(|frame: CanFrame| got.push((frame.id(), frame.data().to_vec()))).unwrap();
        assert_eq!(got, [(id, vec![1, 2])]);
    }
    shared.0.borrow().no_violations();
}

#[test]
fn frames_that_end_at_any_point_of_a_service_keep_their_order() {
    // One frame waits, a second and a third end in every 100 ns step of the service and shortly before and after it.
    let received = u64::from(FrameBits::of(&numbered(1)).received()) * BIT.0;
    for waiting in [1, 2] {
        for offset in (0..40_000).step_by(100) {
            let (mut driver, shared) = normal();
            let request = {
                let rig = &mut *shared.0.borrow_mut();
                (0..waiting).for_each(|n| rig.receive(numbered(n)));
                let now = rig.now;
                rig.bus.request(rig.peer, now, numbered(waiting), Tag(0));
                rig.advance(now + Nanos(received) - Nanos(offset));
                now
            };
            let mut sequence = Vec::new();
            serve(&mut driver, &mut sequence);
            shared.0.borrow_mut().advance(request + Nanos(received + 100_000));
            serve(&mut driver, &mut sequence);
            let rig = shared.0.borrow();
            let counters = rig.chip.counters();
            assert_eq!(counters.frames_discarded, 0, "{offset} ns: a frame was acknowledged unread");
            let lost: u64 = counters.frames_overrun.iter().sum();
            assert_eq!(sequence.len() as u64 + lost, waiting + 1, "{offset} ns");
            assert_eq!(counters.frames_read_out_of_order, 0, "{offset} ns: {sequence:?}");
            assert!(sequence.is_sorted(), "{offset} ns: {sequence:?}");
            rig.no_violations();
        }
    }
}

#[test]
fn full_load_is_received_whole_at_two_bytes_more_than_the_frame() {
    let (mut driver, shared) = normal();
    let mut generator = {
        let rig = &mut *shared.0.borrow_mut();
        let load = rig.bus.attach("load");
        let mut generator = LoadGenerator::sequenced(load, Id::extended(0x1555_5555).unwrap());
        generator.start(rig.now, &mut rig.bus);
        generator
    };
    let before = shared.0.borrow().chip.counters();
    let mut sequence = Vec::new();
    while sequence.len() < 2_000 {
        {
            let rig = &mut *shared.0.borrow_mut();
            // Until INT falls, then 200 us of other work.
            let until = if rig.chip.int_level() { rig.now + BIT } else { rig.now + Nanos::from_micros(200) };
            while let Some(event) = rig.bus.poll(until) {
                generator.on_event(&event, &mut rig.bus);
                rig.chip.on_bus(&event, &mut rig.bus);
            }
            rig.now = until;
        }
        if !shared.0.borrow().chip.int_level() {
            serve(&mut driver, &mut sequence);
        }
        let rig = &mut *shared.0.borrow_mut();
        for event in std::mem::take(&mut rig.events) {
            generator.on_event(&event, &mut rig.bus);
        }
    }
    assert!(sequence.iter().copied().eq(0..2_000), "none lost, none doubled, none out of order");
    let after = shared.0.borrow().chip.counters();
    let bytes = (after.spi_bytes - before.spi_bytes) as f64 / sequence.len() as f64;
    assert!(bytes <= 16.1, "{bytes} SPI bytes per frame");
    shared.0.borrow().no_violations();
}

#[test]
fn two_nodes_with_one_identifier_cost_no_frame() {
    let (mut driver, shared) = normal();
    let nodes = ["one", "same"].map(|name| shared.0.borrow_mut().bus.attach(name));
    let mut received = 0;
    for step in 0..40_000 {
        {
            let rig = &mut *shared.0.borrow_mut();
            if step % 50 == 0 {
                rig.bus.request(rig.peer, rig.now, numbered(step), Tag(0));
            }
            // The second asks for its burst while the first is sending: they meet at its second frame.
            for (own, node) in nodes.into_iter().enumerate() {
                if step % 100 == 3 * own as u64 && rig.bus.pending(node) == 0 {
                    let frame = |n| extended(0x18FF_1234, &[own as u8, n]);
                    (0..4).for_each(|n| rig.bus.request(node, rig.now, frame(n), Tag(0)));
                }
            }
            rig.wait(Nanos::from_micros(100));
        }
        if !shared.0.borrow().chip.int_level() {
            driver.service(|_: CanFrame| received += 1).unwrap();
        }
    }
    let counters = shared.0.borrow().chip.counters();
    assert_eq!((counters.frames_overrun, driver.health().overruns), ([0, 0], 0));
    assert!(counters.bus_errors > 1_000, "they collide: {}", counters.bus_errors);
    assert!(received >= 799, "the peer speaks every 5 ms: {received}");
    shared.0.borrow().no_violations();
}

#[test]
fn an_overrun_is_counted_and_int_goes_high_again() {
    let (mut driver, shared) = normal();
    for n in 0..5 {
        shared.0.borrow_mut().receive(numbered(n));
    }
    let mut sequence = Vec::new();
    serve(&mut driver, &mut sequence);
    assert_eq!(sequence, [0, 1]);
    assert_eq!(shared.0.borrow().chip.counters().frames_overrun, [0, 3]);
    assert!(driver.health().overruns >= 1);
    assert!(shared.0.borrow().chip.int_level());
    shared.0.borrow_mut().receive(numbered(5));
    serve(&mut driver, &mut sequence);
    assert_eq!(sequence, [0, 1, 5], "reception goes on");
}

fn own_frame() -> CanFrame {
    CanFrame::new(embedded_can::StandardId::ZERO, &[1]).unwrap()
}

#[test]
fn bus_off_is_seen_and_ends_by_itself_on_a_free_bus() {
    let (mut driver, shared) = normal();
    {
        let rig = &mut *shared.0.borrow_mut();
        let node = rig.chip.node();
        rig.bus.force_bit_errors(node, 32);
    }
    driver.transmit(&own_frame(), 0).unwrap();
    let mut states = Vec::new();
    for _ in 0..40 {
        shared.0.borrow_mut().wait(Nanos::from_micros(500));
        driver.service(|_: CanFrame| {}).unwrap();
        driver.supervise(1).unwrap();
        if states.last() != Some(&driver.health().state) {
            states.push(driver.health().state);
        }
    }
    assert!(states.contains(&BusState::BusOff), "{states:?}");
    assert_eq!(states.last(), Some(&BusState::Active));
    let health = driver.health();
    assert_eq!((health.bus_offs, health.aborted, health.sent), (1, 1, 0));
    assert!(shared.0.borrow().heard.is_empty(), "the frame is given up");
    shared.0.borrow_mut().receive(numbered(7));
    let mut sequence = Vec::new();
    serve(&mut driver, &mut sequence);
    assert_eq!(sequence, [7], "the node hears on");
    driver.transmit(&own_frame(), 1_001).unwrap();
    shared.0.borrow_mut().wait(Nanos::from_millis(1));
    assert_eq!(shared.0.borrow().heard.len(), 1, "and sends again after a second");
    shared.0.borrow().no_violations();
}

#[test]
fn a_node_whose_frames_all_fail_goes_off_the_bus_once_a_second_at_most() {
    let (mut driver, shared) = normal();
    {
        let rig = &mut *shared.0.borrow_mut();
        let node = rig.chip.node();
        rig.bus.force_bit_errors(node, u32::MAX);
    }
    // A frame every 10 ms, INT served at once, a look every 100 ms.
    for step in 0..50_000_u64 {
        shared.0.borrow_mut().wait(Nanos::from_micros(100));
        let now_ms = step / 10;
        if step % 100 == 0 {
            let _ = driver.transmit(&own_frame(), now_ms);
        }
        if step % 1_000 == 0 {
            driver.supervise(now_ms).unwrap();
        }
        if !shared.0.borrow().chip.int_level() {
            driver.service(|_: CanFrame| {}).unwrap();
        }
    }
    let rig = shared.0.borrow();
    let node = rig.chip.node();
    let off = EventKind::StateChanged { state: Confinement::BusOff };
    let times: Vec<Nanos> =
        rig.events.iter().filter(|e| e.node == node && e.kind == off).map(|event| event.at).collect();
    assert_eq!(times.len(), 5, "in 5 s; the first at {:?}", times.first());
    assert!(times.windows(2).all(|pair| pair[1] - pair[0] >= Nanos::from_secs(1)), "{times:?}");
    assert_eq!(driver.health().bus_offs, 5);
    rig.no_violations();
}
