//! What the real image keeps over power-off, and that keeping it costs no frame.

mod firmware;

use bench::can::{Frame, Id, LoadGenerator};
use bench::log::Log;
use bench::rig::{Rig, RigOptions, STORE};
use bench::rp2040::FlashTimes;
use bench::time::Nanos;

const METER2: u32 = 0x18F5_4A17;
/// Time in which the store is settled, the vehicle is certain, and Meter2 and the records have come.
const STARTED: Nanos = Nanos::from_millis(2_500);

fn rig() -> Rig {
    Rig::new(&firmware::elf(), &RigOptions::default()).unwrap()
}

fn city() -> Log {
    Log::read_file(&surroundings::root().join("vehicles/citybus/captures/city.log")).unwrap()
}

fn run(rig: &mut Rig, span: Nanos) {
    rig.run_for(span).unwrap_or_else(|stop| panic!("{stop}"));
}

/// The odometer that the firmware says it shows, in 0.1 km.
fn shown(rig: &Rig) -> u32 {
    rig.screen().expect("it has reported").odometer_hectometres
}

/// The bytes of the last Meter2 since frame `number`.
fn meter2(rig: &Rig, number: usize) -> Option<u32> {
    let (heard, _) = rig.heard_since(number);
    let id = Id::extended(METER2).unwrap();
    let last = heard.iter().rev().find(|heard| heard.by_cluster && heard.frame.id == id)?;
    Some(u32::from_le_bytes(*last.frame.payload().first_chunk().unwrap()))
}

#[test]
fn the_odometer_goes_on_after_a_cut_and_the_bus_hears_the_same_as_the_driver() {
    let mut rig = rig();
    rig.replay(&city(), true);
    run(&mut rig, Nanos::from_secs(60));
    let before = shown(&rig);
    assert!(before >= 3, "{before}");
    rig.cut_power(true);
    run(&mut rig, Nanos::from_millis(100));
    let number = rig.heard_since(0).1;
    rig.cut_power(false);
    run(&mut rig, STARTED);
    let after = shown(&rig);
    assert!(after + 1 >= before && after <= before + 1, "{before} before, {after} after the cut");
    let told = meter2(&rig, number).expect("it is sent");
    assert!(told * 10 / 8 <= after && (told + 1) * 10 / 8 + 1 >= after, "{told} / 8 km told, {after} shown");
}

/// The bus filled with the shortest frames there are, from the first moment on: the store is settled, two sectors are
/// erased and the first records are kept under this load, by the slowest flash that the datasheet allows.
#[test]
fn no_frame_is_lost_at_full_load_while_the_flash_is_erased_and_programmed() {
    for (times, data) in [(FlashTimes::WORST, &[][..]), (FlashTimes::TYPICAL, &[0; 8][..])] {
        let mut rig = rig();
        rig.set_flash_times(times);
        run(&mut rig, Nanos::from_millis(60));
        rig.replay(&city(), true);
        let flood = rig.board_mut().bus_mut().attach("flood");
        let frame = Frame::new(Id::standard(0x7F0).unwrap(), data).unwrap();
        rig.board_mut().join(LoadGenerator::new(flood, move |_| frame));
        let (before, from) = (rig.board().bus().stats(), rig.now());
        run(&mut rig, Nanos::from_secs(8));
        let load = (rig.board().bus().stats().busy - before.busy).as_secs_f64()
            / rig.now().since(from).as_secs_f64();
        assert!(load > 0.99, "{load}");
        let erases: u32 = rig.chip().cells().erases().iter().sum();
        assert!(erases >= 2, "{erases} erases");
        assert!(rig.flash()[STORE].windows(4).any(|bytes| bytes == b"KEPT"), "sectors have been prepared");
        let (chip, health) = (rig.board().mcp2515().counters(), rig.health());
        println!("{erases} erases, {} frames, {:?} lost", chip.frames_seen, chip.frames_overrun);
        assert_eq!((chip.frames_overrun, chip.frames_discarded), ([0, 0], 0), "lost in the controller");
        assert_eq!(chip.frames_read_out_of_order, 0);
        assert_eq!((health.overruns, health.ring_overflows), (0, 0), "lost in the firmware");
    }
}

/// Cuts at random moments of a drive, each followed by a start: `CUTS=1000` for more of them.
#[test]
fn after_every_cut_the_odometer_is_where_it_was() {
    let cuts: u64 = std::env::var("CUTS").ok().and_then(|cuts| cuts.parse().ok()).unwrap_or(24);
    let mut rig = rig();
    // The slowest flash is hit most often.
    rig.set_flash_times(FlashTimes::WORST);
    rig.replay(&city(), true);
    run(&mut rig, Nanos::from_secs(30));
    let (mut least, mut random, mut weak, mut writing) = (shown(&rig), 0x1234_5678_u64, 0, 0);
    for cut in 0..cuts {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        // Half of the cuts fall into the first 150 ms, when most is written.
        let span = if cut % 2 == 0 { 150_000 } else { 2_000_000 };
        run(&mut rig, Nanos::from_micros((random >> 33) % span));
        if let Some(screen) = rig.screen().filter(|screen| screen.odometer_hectometres > 0) {
            least = least.max(screen.odometer_hectometres.saturating_sub(1));
        }
        writing += u32::from(rig.chip().is_writing_flash());
        rig.cut_power(true);
        weak += usize::from(rig.chip().cells().weak_bits() > 0);
        rig.seed_flash(random);
        run(&mut rig, Nanos::from_millis(20));
        let number = rig.heard_since(0).1;
        rig.cut_power(false);
        if cut % 3 == 0 {
            continue;
        }
        run(&mut rig, STARTED);
        let now = shown(&rig);
        assert!(now >= least && now <= least + 3, "cut {cut}: {now} shown, {least} kept");
        let told = meter2(&rig, number).unwrap_or_else(|| panic!("cut {cut}: no Meter2"));
        assert!(
            told * 10 / 8 <= now && (told + 1) * 10 / 8 + 1 >= now,
            "cut {cut}: {told} told, {now} shown"
        );
        assert!(
            rig.screen().unwrap().line.is_none_or(|line| line.fault != cluster::FaultId::Memory.number())
        );
    }
    println!("{cuts} cuts, {writing} of them while the flash was written, {weak} starts with weak cells");
}

#[test]
fn a_damaged_region_is_said_once_and_the_cluster_drives_on_without_a_distance() {
    let mut rig = rig();
    let mut flash = rig.chip().flash().to_vec();
    flash[STORE].iter_mut().enumerate().for_each(|(at, byte)| *byte = (at * 31 + 7) as u8);
    rig.cut_power(true);
    let mut kept = rig.chip().cells().bytes().to_vec();
    kept[STORE].copy_from_slice(&flash[STORE]);
    rig.keep(&kept);
    rig.cut_power(false);
    rig.replay(&city(), true);
    run(&mut rig, Nanos::from_secs(3));
    let says = |rig: &Rig| {
        rig.screen()
            .and_then(|screen| screen.line)
            .is_some_and(|line| line.fault == cluster::FaultId::Memory.number())
    };
    assert!(says(&rig));
    run(&mut rig, Nanos::from_secs(12));
    assert!(!says(&rig), "once");
    assert!(rig.screen().unwrap().speed_kmh != protocol_core::link::Sample::Never, "it drives on");
}
