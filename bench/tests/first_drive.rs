//! The whole path, from a frame on the bus to a pixel on the panel, with the image that goes to the board.

mod firmware;

use bench::can::{Id, LoadGenerator};
use bench::log::{Log, candump_line};
use bench::rig::{Heard, Rig, RigOptions};
use bench::time::Nanos;
use cluster::{Cluster, Inputs};
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics_core::prelude::*;
use embedded_graphics_core::primitives::Rectangle;
use protocol_core::generated::citybus::VEHICLE;
use protocol_core::link::{Health, Record, Sample, Screen};
use protocol_core::{CanFrame, CanId, Millis, Value};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;
use surroundings::need;

/// Time that the firmware has to start before the first frame is sent.
const BOOT: Nanos = Nanos::from_millis(500);
/// Time after the last frame at which nothing is stale yet and everything is drawn.
const SETTLED: Nanos = Nanos::from_millis(230);

fn city() -> PathBuf {
    surroundings::root().join("vehicles/citybus/captures/city.log")
}

/// What a drive along the whole of city.log left behind.
struct Drive {
    log: Log,
    /// When the picture was taken.
    taken_at: Nanos,
    pixels: Vec<u16>,
    values: Vec<Sample>,
    screen: Screen,
    heard: Vec<Heard>,
    /// Reported after the last frame.
    health: Health,
    overruns: u64,
    undrawn: usize,
    flickered: u64,
    /// Times that the panel was selected.
    selections: u64,
    violations: Vec<String>,
    damaged_records: usize,
}

static DRIVE: LazyLock<Drive> = LazyLock::new(|| {
    let log = Log::read_file(&city()).unwrap();
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.run_for(BOOT).unwrap();
    rig.replay(&log, false);
    rig.run_for(log.duration() + SETTLED).unwrap();
    let taken_at = rig.now();
    let panel = rig.board().panel();
    let pixels =
        (0..240).flat_map(|y| (0..320).map(move |x| (x, y))).map(|(x, y)| panel.colour_at(x, y)).collect();
    let values = Value::ALL.iter().map(|value| rig.value(*value)).collect();
    let screen = rig.screen().expect("the firmware says what it shows");
    let (undrawn, flickered) = (panel.undrawn_pixels(), panel.flickered_pixels());
    rig.run_for(Nanos::from_millis(1_500)).unwrap();
    let board = rig.board();
    let can =
        board.mcp2515().violations().first().iter().map(|(at, violation)| format!("{at}: {violation:?}"));
    let panel =
        board.panel().violations().first().iter().map(|(at, violation)| format!("{at}: {violation:?}"));
    let violations = can.chain(panel).collect();
    Drive {
        taken_at,
        pixels,
        values,
        screen,
        heard: rig.heard(),
        health: rig.health(),
        overruns: board.mcp2515().counters().frames_overrun.iter().sum(),
        undrawn,
        flickered,
        selections: board.panel().counters().transactions,
        violations,
        damaged_records: rig.damaged_records(),
        log,
    }
});

impl Drive {
    fn value(&self, path: &str) -> Sample {
        self.values[Value::from_path(path).unwrap() as usize]
    }

    /// Frames that the cluster sent with this identifier.
    fn sent(&self, id: u32) -> Vec<&Heard> {
        self.heard.iter().filter(|heard| heard.by_cluster && heard.frame.id.raw() == id).collect()
    }
}

/// Asks cantools for the last value of every signal in a log.
fn cantools(log: &Path) -> Option<HashMap<String, f64>> {
    let root = surroundings::root();
    let python = need::witness("the firmware's values of the city drive")?;
    let output = Command::new(python)
        .arg(root.join("tools/witness/last_values.py"))
        .arg(root.join("vehicles/citybus/citybus.dbc"))
        .arg(log)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(serde_json::from_slice(&output.stdout).unwrap())
}

#[test]
fn the_cluster_knows_what_cantools_decodes_from_the_same_log() {
    let drive = &*DRIVE;
    let Some(expected) = cantools(&city()) else { return };
    let rows = [
        ("vehicle.speed", "VCU1.vehicle_speed", 256.0),
        ("vehicle.gear", "VCU1.gear", 1.0),
        ("vehicle.ready", "VCU1.ready", 1.0),
        ("vehicle.accelerator", "VCU1.accelerator_pedal", 10.0),
        ("vehicle.brake", "VCU1.brake_pedal", 10.0),
        ("battery.voltage", "BMS1.pack_voltage", 10.0),
        ("battery.current", "BMS1.pack_current", 10.0),
        ("battery.soc", "BMS1.soc", 10.0),
        ("battery.cell.max", "BMS2.max_cell_voltage", 1000.0),
        ("battery.cell.min", "BMS2.min_cell_voltage", 1000.0),
        ("battery.temperature.max", "BMS2.max_cell_temperature", 1.0),
        ("battery.temperature.min", "BMS2.min_cell_temperature", 1.0),
        ("motor.speed", "IPU2.motor_speed", 1.0),
        ("motor.torque", "IPU2.motor_torque", 10.0),
        ("motor.temperature", "IPU2.motor_temperature", 1.0),
        ("inverter.temperature", "IPU2.controller_temperature", 1.0),
        ("inverter.voltage", "IPU1.bus_voltage", 10.0),
        ("dcdc.output", "DCDC.output_voltage", 10.0),
    ];
    for (path, signal, counts_per_unit) in rows {
        let physical = expected.get(signal).unwrap_or_else(|| panic!("cantools has no {signal}"));
        let counts = (physical * counts_per_unit).round() as i32;
        assert_eq!(drive.value(path), Sample::Value(counts), "{path} against {signal} = {physical}");
    }
    assert_eq!(drive.screen.speed_kmh, Sample::Value(expected["VCU1.vehicle_speed"].floor() as i32));
    assert_eq!(drive.screen.soc_percent, Sample::Value(expected["BMS1.soc"].floor() as i32));
    assert_eq!(drive.screen.motor_rpm, Sample::Value(expected["IPU2.motor_speed"] as i32));
}

/// The same frames through the same cluster logic and the same UI, on the host.
fn host_picture(drive: &Drive) -> Vec<u16> {
    let mut host = Cluster::new(&VEHICLE);
    let mut tick = 0;
    let tick_until = |host: &mut Cluster, until: u64, tick: &mut u64| {
        while *tick <= until {
            host.tick(&Inputs::default(), Millis(*tick));
            while host.transmit(Millis(*tick)).is_some() {}
            *tick += 10;
        }
    };
    let heard = drive.heard.iter().filter(|heard| !heard.by_cluster && heard.at <= drive.taken_at);
    for heard in heard {
        let now = heard.at.0 / 1_000_000;
        tick_until(&mut host, now, &mut tick);
        let id = CanId::extended(heard.frame.id.raw());
        host.receive(&CanFrame::from_slice(id, heard.frame.payload()).unwrap(), Millis(now));
    }
    let now = drive.taken_at.0 / 1_000_000;
    tick_until(&mut host, now, &mut tick);
    let mut canvas = Canvas(vec![0; 320 * 240]);
    let mut screen = ui::Screen::new();
    screen.update(&host.view(Millis(now)));
    while let Some(tile) = screen.next_tile(5_120) {
        screen.draw(&tile, &mut canvas).unwrap();
    }
    canvas.0
}

/// A picture in memory, drawn pixel by pixel.
struct Canvas(Vec<u16>);

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(320, 240)
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb565;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(point, colour) in pixels {
            if Rectangle::new(Point::zero(), self.size()).contains(point) {
                self.0[point.y as usize * 320 + point.x as usize] =
                    u16::from(colour.r()) << 11 | u16::from(colour.g()) << 5 | u16::from(colour.b());
            }
        }
        Ok(())
    }
}

#[test]
fn the_picture_rebuilt_from_spi_bytes_is_the_picture_drawn_on_the_host() {
    let drive = &*DRIVE;
    let host = host_picture(drive);
    let differing = host.iter().zip(&drive.pixels).filter(|(host, panel)| host != panel).count();
    if differing != 0 {
        let out = surroundings::scratch();
        firmware::save_565(&out.join("host.png"), &host);
        firmware::save_565(&out.join("panel.png"), &drive.pixels);
        panic!("{differing} pixels differ: compare host.png and panel.png in {}", out.display());
    }
    assert_eq!(drive.undrawn, 0, "pixels that nobody has drawn");
}

#[test]
fn every_frame_of_the_drive_is_received() {
    let drive = &*DRIVE;
    println!("city.log: {} frames sent, {} received", drive.log.entries.len(), drive.health.frames_received);
    assert_eq!(u64::from(drive.health.frames_received), drive.log.entries.len() as u64);
    assert_eq!((drive.overruns, drive.health.overruns, drive.health.ring_overflows), (0, 0, 0));
    assert_eq!((drive.health.frames_dropped_short, drive.health.spi_errors), (0, 0));
}

#[test]
fn nothing_flickers_and_no_chip_is_misused() {
    let drive = &*DRIVE;
    // What flickers is counted from one selection of the panel to the next: each is a whole picture, or a command of the
    // start. A second of pictures may have followed the last report.
    let pictures = u64::from(drive.health.draws);
    assert!(drive.selections <= pictures + 60, "{} selections for {pictures} pictures", drive.selections);
    assert_eq!(drive.flickered, 0, "pixels that left their colour and came back to it in one picture");
    assert_eq!(drive.violations, [""; 0]);
    assert_eq!(drive.damaged_records, 0);
}

#[test]
fn meter1_and_meter2_are_on_the_bus_every_second_and_decode() {
    let drive = &*DRIVE;
    for id in [0x18F4_3A17, 0x18F5_4A17] {
        let sent = drive.sent(id);
        assert!(sent.len() >= 60, "{id:08X}: {} frames in a minute", sent.len());
        for pair in sent.windows(2) {
            let cycle = pair[1].at.since(pair[0].at).as_micros();
            assert!((990_000..=1_010_000).contains(&cycle), "{id:08X} after {cycle} us");
        }
    }
    let heartbeat: Vec<u8> = drive.sent(0x18F4_3A17).iter().map(|heard| heard.frame.data[7]).collect();
    assert!(heartbeat.windows(2).all(|pair| pair[1] == pair[0].wrapping_add(1)), "bus_r127: {heartbeat:?}");

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sent.log");
    let sent = drive.heard.iter().filter(|heard| heard.by_cluster && heard.at <= drive.taken_at);
    let lines: Vec<_> = sent.map(|heard| candump_line(heard.at, "can0", &heard.frame)).collect();
    std::fs::write(&path, lines.join("\n")).unwrap();
    let Some(decoded) = cantools(&path) else { return };
    // The log covers about half a kilometre; Meter2 counts in 1/8 km.
    let driven = f64::from(drive.screen.odometer_hectometres) / 10.0;
    assert!(
        (decoded["Meter2.odometer"] - driven).abs() <= 0.125 + 0.1,
        "{} km, shown {driven} km",
        decoded["Meter2.odometer"]
    );
    assert_eq!(decoded["Meter1.driver_left_seat"], 0.0);
}

#[test]
fn no_frame_is_lost_or_out_of_order_at_full_bus_load_while_the_screen_is_redrawn() {
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.run_for(BOOT).unwrap();
    rig.replay(&Log::read_file(&city()).unwrap(), true);
    let flood = rig.board_mut().bus_mut().attach("flood");
    let id = Id::extended(0x1FFF_FFF0).unwrap();
    rig.board_mut().join(LoadGenerator::sequenced(flood, id));
    let before = rig.board().bus().stats();
    let span = Nanos::from_secs(10);
    rig.run_for(span).unwrap();
    let after = rig.board().bus().stats();
    let load = (after.busy - before.busy).as_secs_f64() / span.as_secs_f64();
    assert!(load > 0.99, "the bus is busy {:.1} % of the time", 100.0 * load);

    // The records are sent once a second: a report is compared with what had been on the bus when it was made.
    let chip = rig.board().mcp2515().counters();
    println!(
        "full load: {} frames in {} s, {} lost",
        chip.frames_seen,
        span.as_secs_f64(),
        chip.frames_overrun[1]
    );
    assert_eq!(chip.frames_overrun, [0, 0], "lost in the controller");
    assert_eq!(chip.frames_discarded, 0, "acknowledged without having been read");
    assert_eq!(chip.frames_read_out_of_order, 0);
    let health = rig.health();
    assert_eq!((health.overruns, health.ring_overflows), (0, 0), "lost in the firmware");
    let heard = rig.heard();
    for (at, record) in rig.records() {
        let Record::Health(health) = record else { continue };
        // UART: a record takes up to 15 ms to leave; the CAN counter is read before that.
        let until = |slack: u64| {
            heard.iter().filter(|h| !h.by_cluster && h.at + Nanos::from_millis(slack) <= *at).count() as i64
        };
        let received = i64::from(health.frames_received);
        assert!(
            (until(40)..=until(0)).contains(&received),
            "{received} received at {at}, {} on the bus",
            until(0)
        );
    }
    assert!(rig.board().panel().violations().is_empty());
}

#[test]
fn two_runs_are_equal_to_the_cycle() {
    let run = || {
        let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
        rig.replay(&Log::read_file(&city()).unwrap(), true);
        rig.run_for(Nanos::from_secs(2)).unwrap();
        (rig.chip().stats(), rig.picture_png(), rig.board().uart().to_vec())
    };
    let (first, second) = (run(), run());
    assert_eq!(first.0, second.0);
    assert!(first == second, "same counts, other picture or bytes");
}

#[test]
fn the_same_image_drives_with_an_st7789() {
    let options = RigOptions { panel: bench::rig::PanelKind::St7789, ..RigOptions::default() };
    let mut rig = Rig::new(&firmware::elf_st7789(), &options).unwrap();
    rig.replay(&Log::read_file(&city()).unwrap(), true);
    rig.run_for(Nanos::from_secs(3)).unwrap();
    let panel = rig.board().panel();
    assert!(panel.visible(rig.now()).is_some(), "the panel is dark");
    assert_eq!(panel.undrawn_pixels(), 0);
    assert!(panel.violations().is_empty(), "{:?}", panel.violations().first());
}

#[test]
fn a_bus_with_another_bit_rate_is_silence_on_the_screen_and_not_zero() {
    let options = RigOptions { bitrate: 500_000, ..RigOptions::default() };
    let mut rig = Rig::new(&firmware::elf(), &options).unwrap();
    rig.replay(&Log::read_file(&city()).unwrap(), true);
    rig.run_for(Nanos::from_secs(3)).unwrap();
    let screen = rig.screen().expect("the firmware lives");
    assert_eq!((screen.speed_kmh, screen.soc_percent, screen.gear), (Sample::Never, Sample::Never, 0));
}

#[test]
fn silence_turns_what_was_shown_into_missing() {
    let log = Log::read_file(&city()).unwrap();
    let mut rig = Rig::new(&firmware::elf(), &RigOptions::default()).unwrap();
    rig.run_for(BOOT).unwrap();
    let short =
        Log { entries: log.entries.into_iter().filter(|e| e.at < Nanos::from_secs(1)).collect(), ..log };
    rig.replay(&short, false);
    rig.run_for(Nanos::from_millis(1_300)).unwrap();
    assert!(matches!(rig.screen().unwrap().soc_percent, Sample::Value(_)));
    // BMS1 has a cycle of 500 ms: stale after 2.5 s of silence (BUS-108).
    rig.run_for(Nanos::from_millis(3_500)).unwrap();
    let screen = rig.screen().unwrap();
    assert_eq!((screen.speed_kmh, screen.soc_percent, screen.gear), (Sample::Stale, Sample::Stale, 0));
}
