//! The firmware on the bus of a vehicle that it does not know: it listens, and leaves no trace.
//!
//! The identifiers are those of other makers' cars, and the example vehicle's own with wrong check bytes; what they
//! carry is noise.

mod firmware;

use bench::can::{Frame, Id};
use bench::chips::mcp2515::Mode;
use bench::log::{Entry, Log};
use bench::rig::{Rig, RigOptions};
use bench::time::Nanos;
use cluster::FaultId;

/// Identifiers of 11 bits as they are heard in cars.
const LEAF_LIKE: &[u16] =
    &[0x11A, 0x1D4, 0x1DA, 0x1DB, 0x1DC, 0x284, 0x2B0, 0x355, 0x390, 0x54B, 0x55B, 0x59E, 0x5BC];
const TESLA_LIKE: &[u16] =
    &[0x102, 0x106, 0x116, 0x118, 0x129, 0x132, 0x20C, 0x212, 0x257, 0x292, 0x2B4, 0x318, 0x332, 0x3FE];
const I3_LIKE: &[u16] = &[0x0AA, 0x0B5, 0x112, 0x1A1, 0x1D0, 0x2FA, 0x328, 0x349, 0x3E8, 0x432, 0x508, 0x5BC];
/// Identifiers of `vehicles/example`.
const EXAMPLE_LIKE: &[u16] = &[0x120, 0x128, 0x240, 0x248];

/// Time between two frames: each identifier of the example comes 20 times a second and more.
const SPACING: Nanos = Nanos::from_millis(5);
const SPAN: Nanos = Nanos::from_millis(2_500);

/// A recording of noise with these identifiers in turn.
fn noise(ids: &[u16]) -> Log {
    let frames = SPAN.0 / SPACING.0;
    let entries = (0..frames).map(|index| {
        let id = Id::standard(ids[index as usize % ids.len()]).expect("11 bits");
        let data = index.wrapping_mul(0x9E37_79B9_7F4A_7C15).to_le_bytes();
        Entry {
            at: Nanos(index * SPACING.0),
            frame: Frame::new(id, &data).expect("8 bytes"),
            line: 0,
            channel: 0,
        }
    });
    Log::of(entries.collect())
}

/// Runs the firmware on a bus with these identifiers.
fn ride(ids: &[u16], bitrate: u32) -> Rig {
    let mut rig = Rig::new(&firmware::elf(), &RigOptions { bitrate, ..RigOptions::default() }).unwrap();
    rig.run_for(Nanos::from_millis(300)).unwrap();
    rig.replay(&noise(ids), true);
    rig.run_for(SPAN + Nanos::from_millis(300)).unwrap();
    rig
}

/// Asserts that the cluster has sent nothing and still only listens: a node that listens acknowledges nothing.
fn is_untouched(ids: &[u16], bitrate: u32) {
    let rig = ride(ids, bitrate);
    let heard = rig.heard();
    assert!(heard.len() > 400, "{} frames on the bus", heard.len());
    let sent = heard.iter().filter(|heard| heard.by_cluster).count();
    assert_eq!(sent, 0, "frames of the cluster among {ids:X?} at {bitrate}");
    let mode = rig.board().mcp2515().mode();
    assert_eq!(mode, Mode::ListenOnly, "{ids:X?} at {bitrate}");
    let line = rig.screen().and_then(|screen| screen.line).map(|line| line.fault);
    assert_eq!(line, Some(FaultId::Listening.number()), "{ids:X?} at {bitrate}");
}

#[test]
fn a_leaf_like_bus_stays_untouched() {
    is_untouched(LEAF_LIKE, 500_000);
    is_untouched(LEAF_LIKE, 250_000);
}

#[test]
fn a_tesla_like_bus_stays_untouched() {
    is_untouched(TESLA_LIKE, 500_000);
    is_untouched(TESLA_LIKE, 250_000);
}

#[test]
fn an_i3_like_bus_stays_untouched() {
    is_untouched(I3_LIKE, 500_000);
    is_untouched(I3_LIKE, 250_000);
}

#[test]
fn a_bus_with_the_example_s_identifiers_stays_untouched() {
    is_untouched(EXAMPLE_LIKE, 500_000);
    is_untouched(EXAMPLE_LIKE, 250_000);
}

#[test]
fn the_example_is_in_no_image_that_is_not_built_for_it() {
    let name = b"Example vehicle";
    let holds = |elf: std::path::PathBuf| {
        let flash = bench::rp2040::image::load_elf(&elf).unwrap();
        flash.windows(name.len()).any(|window| window == name)
    };
    assert!(holds(firmware::elf_example()), "an image that is built for it holds its name");
    assert!(!holds(firmware::elf()));
    assert!(!holds(firmware::elf_st7789()));
}

#[test]
fn a_vehicle_that_is_only_likely_is_shown_and_only_listened_to() {
    let id = Id::extended(0x18C2_1727).expect("29 bits");
    let data = [0xA0, 0x32, 0x32, 0x4A, 0x01, 0x64, 0x21, 0x00];
    let entries = (0..30).map(|index| {
        let frame = Frame::new(id, &data).expect("8 bytes");
        Entry { at: Nanos::from_millis(200 * index), frame, line: 0, channel: 0 }
    });
    let log = Log::of(entries.collect());
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.run_for(Nanos::from_millis(300)).unwrap();
    rig.replay(&log, false);
    rig.run_for(Nanos::from_millis(4_500)).unwrap();
    let screen = rig.screen().expect("the firmware reports");
    assert!(matches!(screen.speed_kmh, protocol_core::link::Sample::Value(_)), "{:?}", screen.speed_kmh);
    assert_eq!(rig.board().mcp2515().mode(), Mode::ListenOnly);
}
