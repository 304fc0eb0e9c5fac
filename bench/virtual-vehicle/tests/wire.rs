//! The frames of the virtual vehicle: cycles, life, fill, truth, links, and what is heard of the cluster.
//!
//! Frames are read back with the generated codecs and compared with what is true in the vehicle; where a rule speaks of
//! bytes, bytes are read by hand.

mod truth;

use protocol_core::codec::{LifeKind, MessageInfo, SignalInfo};
use protocol_core::generated::{self, citybus, jiulong};
use protocol_core::stream::Streams;
use protocol_core::vehicle::Node;
use protocol_core::{CanFrame, Vehicle};
use std::collections::{BTreeMap, BTreeSet};
use truth::{bottom, drive, set, top, truths};
use virtual_vehicle::{Cycles, Kind, Options, STEP_MS, Sent, VirtualVehicle, World};

fn messages(kind: Kind) -> &'static [MessageInfo] {
    let named = generated::MESSAGES.iter().find(|(name, _)| *name == kind.name());
    named.expect("a generated vehicle of this name").1
}

fn vehicle(kind: Kind) -> &'static Vehicle {
    let named = generated::VEHICLES.iter().find(|vehicle| vehicle.name == kind.name());
    named.expect("a generated vehicle of this name")
}

fn info(kind: Kind, frame: &CanFrame) -> &'static MessageInfo {
    let known = messages(kind).iter().find(|info| info.id == frame.id);
    known.unwrap_or_else(|| panic!("{} does not know {}", kind.name(), frame.id))
}

/// Returns the physical value of a signal as the generated getter has it; `None` = not available.
fn read(info: &MessageInfo, frame: &CanFrame, signal: &str) -> Option<f64> {
    let index = info.signals.iter().position(|row| row.name == signal);
    let index = index.unwrap_or_else(|| panic!("{} has no {signal}", info.name));
    let (_, counts) = (info.get)(index, *frame.padded()).expect("a getter for every signal");
    counts.map(|counts| counts as f64 / f64::from(info.signals[index].scale.den))
}

/// Lets time pass and shows every frame with the vehicle as it was when the frame was made.
fn run(vehicle: &mut VirtualVehicle, ms: u64, mut see: impl FnMut(&World, &Sent)) {
    for _ in 0..ms / STEP_MS {
        vehicle.advance();
        for sent in vehicle.take_frames() {
            see(vehicle.world(), &sent);
        }
    }
}

/// Returns the names of the messages that are sent within some time, with their frames.
fn heard(vehicle: &mut VirtualVehicle, ms: u64) -> BTreeMap<&'static str, Vec<CanFrame>> {
    let kind = vehicle.kind();
    let mut frames: BTreeMap<&'static str, Vec<CanFrame>> = BTreeMap::new();
    run(vehicle, ms, |_, sent| {
        frames.entry(info(kind, &sent.frame).name).or_default().push(sent.frame);
    });
    frames
}

/// Shows every frame of a minute of [`drive`].
fn minute(kind: Kind, options: Options, mut see: impl FnMut(&World, &Sent)) {
    let mut vehicle = VirtualVehicle::new(kind, options);
    for second in 0..60 {
        drive(&mut vehicle, second);
        run(&mut vehicle, 1_000, &mut see);
    }
}

const OPTIONAL: Options =
    Options { cycles: Cycles::Page, cells: 0, probes: 0, jitter_us: 500, seed: 1, optional: true };

// --- schedule

/// Counts frames and the shortest and longest way from one to the next.
#[derive(Clone, Copy)]
struct Pace {
    count: u64,
    last_us: u64,
    shortest_us: u64,
    longest_us: u64,
}

fn paces(kind: Kind, options: Options) -> BTreeMap<&'static str, Pace> {
    let mut paces: BTreeMap<&'static str, Pace> = BTreeMap::new();
    let mut vehicle = VirtualVehicle::new(kind, options);
    set(&mut vehicle, "charge.plug", 1.0);
    let mut before = 0;
    for _ in 0..60_000 / STEP_MS {
        let start_us = vehicle.now_ms() * 1_000;
        vehicle.advance();
        for sent in vehicle.take_frames() {
            assert!((start_us..start_us + STEP_MS * 1_000).contains(&sent.at_us), "ready in its step");
            assert!(sent.at_us >= before, "earliest first");
            before = sent.at_us;
            let fresh = Pace { count: 0, last_us: sent.at_us, shortest_us: u64::MAX, longest_us: 0 };
            let pace = paces.entry(info(kind, &sent.frame).name).or_insert(fresh);
            if pace.count > 0 {
                pace.shortest_us = pace.shortest_us.min(sent.at_us - pace.last_us);
                pace.longest_us = pace.longest_us.max(sent.at_us - pace.last_us);
            }
            pace.count += 1;
            pace.last_us = sent.at_us;
        }
    }
    paces
}

#[test]
fn every_message_keeps_its_cycle_for_a_minute() {
    for kind in Kind::ALL {
        for cycles in [Cycles::Page, Cycles::Slow] {
            let options = Options { cycles, jitter_us: 700, ..OPTIONAL };
            let paces = paces(kind, options);
            for info in messages(kind).iter().filter(|info| info.sender != "Cluster") {
                let Some(pace) = paces.get(info.name) else {
                    let is_series =
                        ["CellVoltages", "ModuleTemperatures"].map(|name| info.name.starts_with(name));
                    assert!(is_series.contains(&true), "{} is never sent", info.name);
                    continue;
                };
                let cycle_ms = if cycles == Cycles::Page { info.cycle_ms } else { info.slow_cycle_ms };
                let (cycle_us, name) = (u64::from(cycle_ms) * 1_000, info.name);
                let expected = 60_000_000 / cycle_us;
                assert!(pace.count.abs_diff(expected) <= 1, "{name}: {} frames, not {expected}", pace.count);
                assert!(pace.longest_us <= cycle_us + 700, "{name}: {} us without a frame", pace.longest_us);
                assert!(pace.shortest_us >= cycle_us - 700, "{name}: {} us after the last", pace.shortest_us);
            }
        }
    }
}

#[test]
fn bus_18_the_overview_prints_slower_cycles_for_some() {
    let insulation = |cycles| {
        let options = Options { cycles, ..Options::default() };
        heard(&mut VirtualVehicle::new(Kind::Citybus, options), 30_000)["Insulation"].len()
    };
    assert_eq!((insulation(Cycles::Page), insulation(Cycles::Slow)), (30, 10));
}

/// FNV-1a over time, identifier and bytes of every frame.
fn hash(kind: Kind, options: Options) -> u64 {
    let mut hash = 0xCBF2_9CE4_8422_2325_u64;
    minute(kind, options, |_, sent| {
        let head = sent.at_us.to_le_bytes().into_iter().chain(sent.frame.id.packed().to_le_bytes());
        for byte in head.chain(sent.frame.bytes().iter().copied()) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3);
        }
    });
    hash
}

#[test]
fn the_same_seed_gives_the_same_frames_and_another_one_does_not() {
    for kind in Kind::ALL {
        let of_seed = |seed| hash(kind, Options { seed, ..OPTIONAL });
        assert_eq!(of_seed(7), of_seed(7), "{}", kind.name());
        assert_ne!(of_seed(7), of_seed(8), "{}", kind.name());
    }
}

#[test]
fn another_seed_gives_other_phases() {
    for kind in Kind::ALL {
        let first = |seed| {
            let options = Options { seed, jitter_us: 0, ..OPTIONAL };
            let mut at: BTreeMap<&str, u64> = BTreeMap::new();
            run(&mut VirtualVehicle::new(kind, options), 4_000, |_, sent| {
                at.entry(info(kind, &sent.frame).name).or_insert(sent.at_us);
            });
            at
        };
        let (one, other) = (first(1), first(2));
        let equal: Vec<_> = one.iter().filter(|(name, at)| other.get(*name) == Some(at)).collect();
        assert!(equal.is_empty(), "{}: {equal:?} begin at the same time", kind.name());
        // Frames of one series follow one another; all others are spread.
        let places: BTreeSet<_> = one.values().map(|at| at / 1_000).collect();
        assert!(places.len() * 4 >= one.len() * 3, "{}: phases are bunched: {one:?}", kind.name());
    }
}

#[test]
fn without_jitter_every_way_is_the_cycle() {
    for (name, pace) in paces(Kind::Citybus, Options { jitter_us: 0, ..OPTIONAL }) {
        assert_eq!(pace.shortest_us, pace.longest_us, "{name}");
    }
}

#[test]
fn the_load_of_each_bus_is_what_250_kbit_per_s_carry() {
    for kind in Kind::ALL {
        for options in [Options::default(), OPTIONAL] {
            // 29-bit identifier, 8 bytes and the pause behind: 131 bits, with every stuff bit that can be 160.
            let mut frames = 0_u64;
            minute(kind, options, |_, _| frames += 1);
            let share = |bits: u64| (frames * bits) as f64 / (60.0 * 250_000.0) * 100.0;
            println!(
                "{}{}: {:.1} frames/s, load {:.1} % without, {:.1} % with every stuff bit",
                kind.name(),
                if options.optional { " with its optional messages" } else { "" },
                frames as f64 / 60.0,
                share(131),
                share(160)
            );
            assert!(share(160) < 60.0, "{}: {frames} frames in a minute", kind.name());
        }
    }
}

// --- identifiers, fill, order, scaling

#[test]
fn bus_r007_jl_r008_every_identifier_is_priority_0_0_format_specific_and_source() {
    for kind in Kind::ALL {
        minute(kind, OPTIONAL, |_, sent| {
            let id = sent.frame.id;
            assert!(id.is_extended(), "{id}");
            assert_eq!(id.bits() >> 24 & 0b11, 0, "{id}: R and DP");
            assert!(vehicle(kind).has_id(id), "{id}");
        });
    }
}

#[test]
fn jl_r007_source_addresses_are_those_of_road_vehicles_or_of_j1939() {
    // Cluster 0x28 and battery 0xF3 have theirs from J1939.
    let known = |address: u32| (208..=231).contains(&address) || [0x28, 0xF3].contains(&address);
    minute(Kind::Jiulong, OPTIONAL, |_, sent| {
        let address = sent.frame.id.bits() & 0xFF;
        assert!(known(address), "{}: {address}", sent.frame.id);
    });
}

/// Bits of a message that some signal uses.
fn used(info: &MessageInfo) -> [u8; 8] {
    let mut used = [0; 8];
    for signal in info.signals {
        signal.set_raw(&mut used, -1);
    }
    used
}

#[test]
fn bus_r008_c5_r002_every_frame_is_full_and_what_is_not_used_is_filled() {
    for kind in Kind::ALL {
        let fill = if kind == Kind::Citybus { 0xFF } else { 0x00 };
        minute(kind, OPTIONAL, |_, sent| {
            let info = info(kind, &sent.frame);
            assert_eq!(sent.frame.len(), 8, "{}", info.name);
            for (place, (byte, used)) in sent.frame.bytes().iter().zip(used(info)).enumerate() {
                let expected = if used == 0 { fill } else { 0 };
                assert_eq!(byte & !used, expected & !used, "{} byte {place}: {:?}", info.name, sent.frame);
            }
        });
    }
}

#[test]
fn bus_r005_bus_r009_words_come_low_byte_first_and_are_raw_times_resolution_plus_offset() {
    let mut checked = 0;
    minute(Kind::Citybus, Options::default(), |world, sent| {
        let bytes = sent.frame.bytes();
        let word = |at: usize| f64::from(u16::from(bytes[at]) | u16::from(bytes[at + 1]) << 8);
        let (got, truth, half) = match sent.frame.id {
            citybus::id::VCU1 => (word(2) / 256.0, world.motion.kmh(), 0.5 / 256.0),
            citybus::id::BMS1 => (word(2) * 0.1 - 1_000.0, world.pack.amps, 0.05),
            citybus::id::IPU2 => (word(2) - 12_000.0, world.motor.rpm, 0.5),
            _ => return,
        };
        assert!((got - truth).abs() <= half + 1e-9, "{}: {got}, not {truth}", sent.frame.id);
        checked += 1;
    });
    assert!(checked > 3_000);
}

#[test]
fn bus_r006_the_charge_in_vcu5_comes_high_byte_first() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    run(&mut vehicle, 2_000, |world, sent| {
        if sent.frame.id == citybus::id::VCU5 {
            let bytes = sent.frame.bytes();
            let got = f64::from(u16::from(bytes[5]) << 8 | u16::from(bytes[6])) * 0.4;
            let Some(soc) = world.vcu.heard.battery.soc else {
                assert_eq!(bytes[5..7], [0xFF, 0xFF], "nothing has been heard");
                return;
            };
            assert!((got - soc * 100.0).abs() <= 0.2 + 1e-9, "{got}: {bytes:02X?}");
        }
    });
}

#[test]
fn bus_r010_byte_1_is_sent_first_and_bit_7_is_its_highest() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    set(&mut vehicle, "driver.brake", 50.0);
    run(&mut vehicle, 100, |_, sent| {
        if sent.frame.id == citybus::id::VCU1 {
            let first = sent.frame.bytes()[0];
            assert_eq!(first & 0x80, 0x80, "foot brake is bit 7 of byte 1: {first:02X}");
            assert_eq!(sent.frame.bytes()[4], 125, "brake pedal is byte 5, 50 % in steps of 0.4 %");
        }
    });
}

// --- life

/// Returns the life counter of a message, frame by frame.
fn lives(kind: Kind, name: &str, ms: u64) -> Vec<i64> {
    let mut vehicle = VirtualVehicle::new(kind, Options::default());
    if name.starts_with("Charger") {
        set(&mut vehicle, "charge.plug", 1.0);
    }
    let frames = heard(&mut vehicle, ms);
    let info = messages(kind).iter().find(|info| info.name == name).expect("a message of this name");
    let life = life(info).expect("a life counter");
    frames[name].iter().map(|frame| life.raw(frame.padded())).collect()
}

fn life(info: &MessageInfo) -> Option<&'static SignalInfo> {
    info.signals.iter().find(|signal| signal.life.is_some())
}

#[test]
fn bus_r021_the_life_of_vcu1_goes_up_by_one_with_every_frame_and_wraps() {
    let lives = lives(Kind::Citybus, "VCU1", 12_000);
    assert!(lives.len() > 512);
    for pair in lives.windows(2) {
        assert_eq!(pair[1], (pair[0] + 1) % 256);
    }
}

#[test]
fn bus_r061_the_life_of_ipu1_is_four_bits_above_four_that_stay_0() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    let bytes: Vec<u8> = heard(&mut vehicle, 10_000)["IPU1"].iter().map(|frame| frame.bytes()[7]).collect();
    assert!(bytes.len() > 64);
    for pair in bytes.windows(2) {
        assert_eq!(pair[1], pair[0].wrapping_add(0x10));
        assert_eq!(pair[1] & 0x0F, 0);
    }
}

#[test]
fn bus_r121_the_life_of_the_components_runs_from_1_to_255() {
    for name in ["SteeringPump", "DCDC", "AirPump"] {
        let lives = lives(Kind::Citybus, name, 520_000);
        assert_eq!(lives[0], 1, "{name}");
        for pair in lives.windows(2) {
            assert_eq!(pair[1], pair[0] % 255 + 1, "{name}");
        }
        assert!(lives.contains(&255) && !lives.contains(&0), "{name}");
    }
}

#[test]
fn jl_r009_life_runs_from_0_to_255() {
    for name in ["VCU1", "VCU2", "BMSStatus", "Charger"] {
        let lives = lives(Kind::Jiulong, name, 270_000);
        for pair in lives.windows(2) {
            assert_eq!(pair[1], (pair[0] + 1) % 256, "{name}");
        }
        assert!(lives.len() >= 256, "{name}");
    }
}

#[test]
fn every_life_counter_changes_with_every_frame() {
    for kind in Kind::ALL {
        let mut last: BTreeMap<&str, i64> = BTreeMap::new();
        minute(kind, OPTIONAL, |_, sent| {
            let info = info(kind, &sent.frame);
            let Some(life) = life(info) else { return };
            let raw = life.raw(sent.frame.padded());
            let room = if life.life == Some(LifeKind::Nibble) { 16 } else { 256 };
            assert!((0..room).contains(&raw), "{}", info.name);
            assert_ne!(last.insert(info.name, raw), Some(raw), "{}", info.name);
        });
    }
}

// --- truth

#[test]
fn what_is_sent_is_what_is_true_within_half_a_count() {
    for kind in Kind::ALL {
        let truths = truths(kind);
        let mut seen: BTreeSet<(&str, &str)> = BTreeSet::new();
        minute(kind, OPTIONAL, |world, sent| {
            let info = info(kind, &sent.frame);
            for (_, signal, truth) in truths.iter().filter(|(message, ..)| *message == info.name) {
                let row = info.signal(signal).unwrap_or_else(|| panic!("{} has no {signal}", info.name));
                let physical = |raw: i64| row.scale.counts(raw) as f64 / f64::from(row.scale.den);
                let (low, high) = (physical(row.range.0), physical(row.range.1));
                let half = f64::from(row.scale.mul.abs()) / f64::from(row.scale.den) / 2.0;
                let truth = truth(world).clamp(low, high);
                let got = read(info, &sent.frame, signal);
                if truth.is_nan() {
                    let says_so = row.invalid_raw.is_some();
                    assert!(got.is_none() || !says_so, "{}.{signal}: nobody has told it yet", info.name);
                    continue;
                }
                let got = got.unwrap_or_else(|| panic!("{}.{signal} is not available", info.name));
                assert!((got - truth).abs() <= half + 1e-9, "{}.{signal}: {got}, not {truth}", info.name);
                seen.insert((info.name, signal));
            }
        });
        let missing: Vec<_> =
            truths.iter().filter(|(message, signal, _)| !seen.contains(&(*message, *signal))).collect();
        assert!(
            missing.is_empty(),
            "{}: {} never came, the first {}",
            kind.name(),
            missing.len(),
            missing[0].0
        );
    }
}

#[test]
fn the_drive_that_is_compared_goes_somewhere_and_ends_at_the_plug() {
    for kind in Kind::ALL {
        let (mut fastest, mut most_amps, mut least_amps, mut was_ready, mut charged) =
            (0.0_f64, f64::MIN, f64::MAX, false, false);
        minute(kind, OPTIONAL, |world, _| {
            fastest = fastest.max(world.motion.kmh());
            most_amps = most_amps.max(world.pack.amps);
            least_amps = least_amps.min(world.pack.amps);
            was_ready |= world.vcu.ready;
            charged |= world.charger.amps > 1.0;
        });
        let name = kind.name();
        assert!(fastest > 20.0, "{name}: {fastest} km/h");
        assert!(most_amps > 20.0 && least_amps < -5.0, "{name}: {least_amps} to {most_amps} A");
        assert!(was_ready && charged, "{name}: ready {was_ready}, charged {charged}");
    }
}

#[test]
fn every_value_that_is_sent_is_valid_or_says_that_it_is_not() {
    for kind in Kind::ALL {
        minute(kind, OPTIONAL, |_, sent| {
            let info = info(kind, &sent.frame);
            for signal in info.signals.iter().filter(|signal| info.carries(signal, sent.frame.padded())) {
                let raw = signal.raw(sent.frame.padded());
                let fits = signal.is_valid(raw) || signal.invalid_raw == Some(raw);
                assert!(fits, "{}.{}: raw {raw}", info.name, signal.name);
            }
        });
    }
}

#[test]
fn c5_r015_the_motor_command_is_a_torque_or_with_the_cruise_control_a_speed() {
    let mut seen = BTreeSet::new();
    minute(Kind::C5ev, Options::default(), |world, sent| {
        let info = info(Kind::C5ev, &sent.frame);
        if info.name != "VCUToMCU" {
            return;
        }
        let (torque, speed) = (info.signal("torque").expect("a row"), info.signal("speed").expect("a row"));
        let data = sent.frame.padded();
        let is_speed = info.carries(speed, data);
        assert_eq!(is_speed, world.driver.cruise);
        assert_eq!(info.carries(torque, data), !is_speed);
        let (got, truth) = if is_speed {
            // Beyond the present speed by 1 rpm per Nm that is wanted.
            (speed.raw(data) as f64, world.vcu.heard.motor.rpm + world.vcu.wanted_nm)
        } else {
            (torque.raw(data) as f64, world.vcu.wanted_nm.abs())
        };
        assert!((got - truth).abs() <= 0.5, "{got}, not {truth}");
        seen.insert(is_speed);
    });
    assert_eq!(seen.len(), 2);
}

// --- messages that are not always there

#[test]
fn bus_r145_bus_r146_charger_frames_come_only_where_they_are_built_in_and_a_charger_is_there() {
    for (optional, plugged, expected) in
        [(false, false, 0), (false, true, 0), (true, false, 0), (true, true, 2)]
    {
        let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options { optional, ..Options::default() });
        set(&mut vehicle, "charge.plug", f64::from(u8::from(plugged)));
        let frames = heard(&mut vehicle, 3_000);
        let chargers = frames.keys().filter(|name| name.starts_with("Charger")).count();
        assert_eq!(chargers, expected, "optional {optional}, plugged {plugged}");
    }
}

#[test]
fn bus_r054_bus_r055_frames_of_parts_that_are_not_built_in_do_not_come() {
    let parts = ["VCU9", "VCU10", "PEU", "LowVoltageSteering"];
    for optional in [false, true] {
        let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options { optional, ..Options::default() });
        let frames = heard(&mut vehicle, 3_000);
        for part in parts {
            assert_eq!(frames.contains_key(part), optional, "{part}");
        }
        assert_eq!(vehicle.nodes().contains(&Node::Contactors), optional);
    }
}

#[test]
fn the_charger_of_the_other_two_speaks_while_it_is_plugged_in() {
    for (kind, name) in [(Kind::Jiulong, "Charger"), (Kind::C5ev, "ChargerTx")] {
        let mut vehicle = VirtualVehicle::new(kind, Options::default());
        assert!(!heard(&mut vehicle, 3_000).contains_key(name));
        set(&mut vehicle, "charge.plug", 1.0);
        assert_eq!(heard(&mut vehicle, 3_000)[name].len(), 3);
        set(&mut vehicle, "charge.plug", 0.0);
        assert!(!heard(&mut vehicle, 3_000).contains_key(name));
    }
}

// --- cells and modules in any number

#[test]
fn jl_r020_jl_r021_jl_r022_cells_and_modules_come_in_as_many_frames_as_there_are() {
    for (cells, probes) in [(1, 1), (3, 3), (4, 2), (5, 4), (100, 20), (101, 21), (255, 68), (256, 69)] {
        let options = Options { cells, probes, ..Options::default() };
        let mut vehicle = VirtualVehicle::new(Kind::Jiulong, options);
        let table = crate::vehicle(Kind::Jiulong);
        let [cell_stream, module_stream] = table.streams else { panic!("two streams") };
        let mut streams = Streams::new();
        let mut formats: Vec<u32> = Vec::new();
        let mut modules: Vec<u32> = Vec::new();
        run(&mut vehicle, 500, |world, sent| {
            let Some((stream, index)) = table.stream_of(sent.frame.id) else { return };
            streams.store(stream, index, sent.frame.padded());
            let format = sent.frame.id.bits() >> 16 & 0xFF;
            if stream.name == cell_stream.name {
                formats.push(format);
                // Behind the last cell number and voltage are 0.
                for place in 0..4 {
                    let pair = &sent.frame.bytes()[2 * place..2 * place + 2];
                    let cell = usize::from(index) * 4 + place;
                    match world.pack.cell_volts.get(cell) {
                        Some(volts) => assert_eq!(pair, [cell as u8, (volts / 0.02).round() as u8], "{cell}"),
                        None => assert_eq!(pair, [0, 0], "padding of cell {cell}"),
                    }
                }
            } else {
                modules.push(format);
            }
        });
        let frames = u32::from(cells.div_ceil(4));
        let begin = formats.iter().position(|format| *format == 230).expect("the first frame");
        formats.rotate_left(begin);
        assert_eq!(formats, (0..frames).map(|frame| 230 - frame).collect::<Vec<_>>(), "{cells} cells");
        let begin = modules.iter().position(|format| *format == 4).expect("the first module");
        modules.rotate_left(begin);
        let frames = u32::from(probes.div_ceil(3));
        assert_eq!(modules, (0..frames).map(|frame| 4 + frame).collect::<Vec<_>>(), "{probes} probes");

        let summary = streams.summary(cell_stream);
        assert_eq!(summary.count, cells);
        let volts = &vehicle.world().pack.cell_volts;
        let millivolts = |volts: f64| {
            f64::from(cell_stream.scale.mul) * (volts / 0.02).round() / f64::from(cell_stream.scale.den)
        };
        assert_eq!(f64::from(summary.highest.expect("a cell").value), millivolts(top(volts)).floor());
        assert_eq!(f64::from(summary.lowest.expect("a cell").value), millivolts(bottom(volts)).floor());
        assert_eq!(streams.summary(module_stream).count, probes.div_ceil(3) * 3, "whole modules");
    }
}

#[test]
fn frames_of_a_series_stay_in_order_however_late_they_are() {
    let options = Options { cells: 256, probes: 69, jitter_us: 100_000, ..Options::default() };
    let mut vehicle = VirtualVehicle::new(Kind::Jiulong, options);
    let table = crate::vehicle(Kind::Jiulong);
    let mut next: BTreeMap<&str, u8> = BTreeMap::new();
    run(&mut vehicle, 5_000, |_, sent| {
        let Some((stream, index)) = table.stream_of(sent.frame.id) else { return };
        if let Some(next) = next.get(stream.name) {
            assert_eq!(index, *next, "{}", stream.name);
        }
        next.insert(stream.name, (index + 1) % stream.frames);
    });
}

// --- links

#[test]
fn nobody_sends_while_the_vehicle_sleeps_and_all_go_on_when_it_wakes() {
    for kind in Kind::ALL {
        let mut vehicle = VirtualVehicle::new(kind, Options::default());
        let awake = heard(&mut vehicle, 4_000).len();
        set(&mut vehicle, "driver.key", 0.0);
        assert_eq!(heard(&mut vehicle, 20_000).len(), 0, "{} talks in its sleep", kind.name());
        assert_eq!(vehicle.world().bms.vcu_silence_ms, 0, "who sleeps is not missed");
        set(&mut vehicle, "driver.key", 2.0);
        assert_eq!(heard(&mut vehicle, 4_000).len(), awake, "{}", kind.name());
    }
}

#[test]
fn a_node_that_is_cut_off_neither_sends_nor_hears() {
    for kind in Kind::ALL {
        let mut vehicle = VirtualVehicle::new(kind, Options::default());
        let before = heard(&mut vehicle, 4_000);
        set(&mut vehicle, "link.bms", 1.0);
        let sent_by_bms =
            |name: &str| messages(kind).iter().any(|info| info.name == name && info.sender == "BMS");
        let during = heard(&mut vehicle, 4_000);
        for name in before.keys() {
            assert_eq!(during.contains_key(name), !sent_by_bms(name), "{name}");
        }
        let world = vehicle.world();
        for silence in [world.vcu.heard.battery_silence_ms, world.bms.vcu_silence_ms] {
            assert!((3_990..4_600).contains(&silence), "{}: not heard for {silence} ms", kind.name());
        }
        set(&mut vehicle, "link.bms", 0.0);
        assert_eq!(heard(&mut vehicle, 4_000).len(), before.len());
        assert!(vehicle.world().vcu.heard.battery_silence_ms < 600);
    }
}

#[test]
fn a_lost_message_is_missed_alone() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    let before = heard(&mut vehicle, 4_000);
    set(&mut vehicle, "lost.VCU5", 1.0);
    assert_eq!(vehicle.setting("lost.VCU5"), Some(Some(1.0)));
    let during = heard(&mut vehicle, 4_000);
    let gone: Vec<_> = before.keys().filter(|name| !during.contains_key(*name)).collect();
    assert_eq!(gone, [&"VCU5"]);
    let links = &vehicle.world().links;
    assert!((3_990..=4_100).contains(&links.inbox(Node::Hvac).silence_ms(citybus::id::VCU5)));
    assert!(links.inbox(Node::Inverter).silence_ms(citybus::id::VCU1) <= 20, "the node still talks");
    set(&mut vehicle, "lost.VCU5", 0.0);
    assert!(heard(&mut vehicle, 4_000).contains_key("VCU5"));
}

#[test]
fn a_frozen_node_goes_on_with_the_same_life() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    run(&mut vehicle, 1_000, |_, _| {});
    set(&mut vehicle, "frozen.vcu", 1.0);
    let lives = |frames: &[CanFrame]| frames.iter().map(|frame| frame.bytes()[7]).collect::<BTreeSet<_>>();
    let frozen = heard(&mut vehicle, 2_000);
    assert_eq!(lives(&frozen["VCU1"]).len(), 1);
    assert_eq!(frozen["VCU1"].len(), 100, "it still sends");
    assert!(lives(&frozen["IPU1"]).len() > 1, "others live");
    set(&mut vehicle, "frozen.vcu", 0.0);
    assert_eq!(lives(&heard(&mut vehicle, 2_000)["VCU1"]).len(), 100);
}

#[test]
fn a_cluster_that_is_cut_off_gets_nothing_and_is_not_heard() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    set(&mut vehicle, "link.cluster", 1.0);
    assert!(heard(&mut vehicle, 3_000).is_empty());
    vehicle.receive(&CanFrame::full(citybus::id::METER1, citybus::Meter1::new().0));
    assert_eq!(vehicle.world().meter.frames, 0);
    assert!(vehicle.world().bms.vcu_silence_ms <= 110, "the others hear one another");
}

#[test]
fn every_vehicle_has_a_link_for_each_of_its_nodes_and_can_lose_only_its_own_messages() {
    for kind in Kind::ALL {
        let mut vehicle = VirtualVehicle::new(kind, OPTIONAL);
        for node in vehicle.nodes().to_vec() {
            let path = format!("link.{}", format!("{node:?}").to_lowercase());
            set(&mut vehicle, &path, 1.0);
            set(&mut vehicle, &path, 0.0);
        }
        for control in vehicle.controls().filter_map(|control| control.path.strip_prefix("lost.")) {
            assert!(messages(kind).iter().any(|info| info.name == control), "{}: {control}", kind.name());
        }
    }
}

// --- what is heard of the cluster

#[test]
fn bus_r127_to_bus_r129_heartbeat_doors_and_empty_seat_of_the_cluster_are_heard() {
    let mut vehicle = VirtualVehicle::new(Kind::Citybus, Options::default());
    run(&mut vehicle, 5_000, |_, _| {});
    assert!(vehicle.world().meter.silent_ms >= 5_000);
    let said = citybus::Meter1::new().with_driver_left_seat_raw(1).with_handbrake_raw(1).with_life_raw(7);
    vehicle.receive(&CanFrame::full(citybus::id::METER1, said.0));
    let meter = vehicle.world().meter;
    assert!(meter.seat_left && meter.parking_brake);
    assert_eq!((meter.frames, meter.silent_ms), (1, 0));

    // Not available is not "left".
    let said = citybus::Meter1::new().with_driver_left_seat_raw(255).with_life_raw(8);
    vehicle.receive(&CanFrame::full(citybus::id::METER1, said.0));
    assert!(!vehicle.world().meter.seat_left && !vehicle.world().meter.parking_brake);
    run(&mut vehicle, 1_000, |_, _| {});
    assert_eq!(vehicle.world().meter.silent_ms, 1_000);
}

#[test]
fn the_odometer_of_either_cluster_is_heard_in_km() {
    let mut city = VirtualVehicle::new(Kind::Citybus, Options::default());
    city.receive(&CanFrame::full(citybus::id::METER2, citybus::Meter2::new().with_odometer_raw(987_654).0));
    assert_eq!(city.world().meter.odometer_km, Some(987_654.0 * 0.125));
    city.receive(&CanFrame::full(citybus::id::METER2, [0xFF; 8]));
    assert_eq!(city.world().meter.odometer_km, None, "BUS-97: all ones is not available");

    let mut van = VirtualVehicle::new(Kind::Jiulong, Options::default());
    // Middle byte, low byte, high byte (JL-04): 0x012345 km.
    van.receive(&CanFrame::full(jiulong::id::METER1, [9, 0, 0, 0x23, 0x45, 0x01, 1, 1]));
    assert_eq!(van.world().meter.odometer_km, Some(f64::from(0x01_2345)));
}

#[test]
fn jl_r031_vehicle_and_battery_hear_whether_an_upgrade_is_forbidden() {
    for id in [jiulong::id::METER2, jiulong::id::METER3] {
        let mut van = VirtualVehicle::new(Kind::Jiulong, Options::default());
        assert_eq!(van.world().meter.upgrade_forbidden, None);
        van.receive(&CanFrame::full(id, [1, 1, 0, 0, 0, 0, 0, 0]));
        assert_eq!(van.world().meter.upgrade_forbidden, Some(true));
        van.receive(&CanFrame::full(id, [2, 0, 0, 0, 0, 0, 0, 0]));
        assert_eq!(van.world().meter.upgrade_forbidden, Some(false));
    }
}

#[test]
fn frames_that_nobody_listens_to_or_that_are_too_short_change_nothing() {
    for kind in Kind::ALL {
        let mut vehicle = VirtualVehicle::new(kind, Options::default());
        run(&mut vehicle, 1_000, |_, _| {});
        let before = vehicle.world().clone();
        for other in Kind::ALL.into_iter().filter(|other| *other != kind) {
            for info in messages(other) {
                vehicle.receive(&CanFrame::full(info.id, [0x01; 8]));
            }
        }
        for info in messages(kind).iter().filter(|info| info.len == 8) {
            vehicle.receive(&CanFrame::from_slice(info.id, &[1; 7]).expect("seven bytes"));
        }
        assert!(*vehicle.world() == before, "{}", kind.name());
    }
}
