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

/// Whose bus it is like, and its identifiers: those above 7FF have 29 bits.
const SETS: &[(&str, &[u32])] = &[
    ("Leaf", &[0x11A, 0x1D4, 0x1DA, 0x1DB, 0x1DC, 0x284, 0x2B0, 0x355, 0x390, 0x54B, 0x55B, 0x59E, 0x5BC]),
    (
        "Tesla",
        &[0x102, 0x106, 0x116, 0x118, 0x129, 0x132, 0x20C, 0x212, 0x257, 0x292, 0x2B4, 0x318, 0x332, 0x3FE],
    ),
    ("i3", &[0x0AA, 0x0B5, 0x112, 0x1A1, 0x1D0, 0x2FA, 0x328, 0x349, 0x3E8, 0x432, 0x508, 0x5BC]),
    (
        "Zoe",
        &[0x0C6, 0x12E, 0x155, 0x186, 0x1F6, 0x1FD, 0x242, 0x29C, 0x35C, 0x427, 0x42E, 0x5D7, 0x654, 0x658],
    ),
    (
        "Kona",
        &[0x1F1, 0x200, 0x2A1, 0x331, 0x386, 0x449, 0x522, 0x524, 0x541, 0x549, 0x55F, 0x57F, 0x593, 0x595],
    ),
    ("a tester and its answers", &[0x7DF, 0x7E0, 0x7E8, 0x7E4, 0x7EC, 0x18DB_33F1, 0x18DA_F110, 0x18DA_10F1]),
    (
        "a truck with J1939",
        &[
            0x0CF0_0400,
            0x0CF0_0300,
            0x0C00_0003,
            0x18FE_F100,
            0x18FE_EE00,
            0x18FE_DF00,
            0x18F0_010B,
            0x18FE_CA00,
            0x18FE_F700,
            0x18EB_FF00,
            0x18EC_FF00,
            0x18FE_E500,
            0x18EA_FFF9,
        ],
    ),
    (
        "a machine with CANopen",
        &[0x000, 0x080, 0x100, 0x181, 0x182, 0x201, 0x281, 0x301, 0x581, 0x601, 0x701, 0x702],
    ),
    ("`vehicles/example`", EXAMPLE),
    (
        "a car and a truck on one wire",
        &[0x11A, 0x1DB, 0x55B, 0x0CF0_0400, 0x18FE_F100, 0x7E8, 0x181, 0x18FE_CA00],
    ),
];

/// Identifiers of `vehicles/example`.
const EXAMPLE: &[u32] = &[0x120, 0x128, 0x240, 0x248];

/// Time between two frames: each identifier of the example comes 20 times a second and more.
const SPACING: Nanos = Nanos::from_millis(5);
const SPAN: Nanos = Nanos::from_millis(2_500);

/// A recording of noise with these identifiers in turn.
fn noise(ids: &[u32]) -> Log {
    let frames = SPAN.0 / SPACING.0;
    let entries = (0..frames).map(|index| {
        let raw = ids[index as usize % ids.len()];
        let id = u16::try_from(raw).ok().and_then(Id::standard).or_else(|| Id::extended(raw));
        let id = id.expect("11 or 29 bits");
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
fn ride(ids: &[u32], bitrate: u32) -> Rig {
    let mut rig = Rig::new(&firmware::elf(), &RigOptions { bitrate, ..RigOptions::default() }).unwrap();
    rig.run_for(Nanos::from_millis(300)).unwrap();
    rig.replay(&noise(ids), true);
    rig.run_for(SPAN + Nanos::from_millis(300)).unwrap();
    rig
}

#[test]
fn ten_foreign_buses_stay_untouched_at_either_bit_rate() {
    assert!(SETS.len() >= 10);
    for (whose, ids) in SETS {
        for bitrate in [500_000, 250_000] {
            let rig = ride(ids, bitrate);
            let heard = rig.heard();
            assert!(heard.len() > 400, "{whose}: {} frames on the bus", heard.len());
            let sent = heard.iter().filter(|heard| heard.by_cluster).count();
            assert_eq!(sent, 0, "{whose} at {bitrate}: frames of the cluster");
            // A node that listens acknowledges nothing.
            assert_eq!(rig.board().mcp2515().mode(), Mode::ListenOnly, "{whose} at {bitrate}");
            let line = rig.screen().and_then(|screen| screen.line).map(|line| line.fault);
            assert_eq!(line, Some(FaultId::Listening.number()), "{whose} at {bitrate}");
        }
    }
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
