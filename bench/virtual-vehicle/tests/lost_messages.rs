//! For every message of every vehicle a run in which only that message is lost: who notices, and after how long.
//!
//! The answers are a table in the documentation, `docs/lost-messages.md`, that this test writes and checks: each
//! line is what is other than in the same run with every message. Two scenes: a drive at 40 km/h with air conditioning,
//! in which ten seconds later a hot battery asks for high voltage to be opened; and charging from the mains.

use protocol_core::CanFrame;
use protocol_core::codec::MessageInfo;
use protocol_core::generated::{c5ev, citybus, jiulong};
use std::fmt::Write as _;
use virtual_vehicle::world::Charge;
use virtual_vehicle::{Kind, Options, STEP_MS, VirtualVehicle, World};

const FILE: &str = "docs/lost-messages.md";

fn messages(kind: Kind) -> &'static [MessageInfo] {
    match kind {
        Kind::Citybus => citybus::MESSAGES,
        Kind::Jiulong => jiulong::MESSAGES,
        Kind::C5ev => c5ev::MESSAGES,
    }
}

/// Something that somebody concludes, in words and as what is true then.
type Conclusion = (&'static str, fn(&World) -> bool);

const DRIVING: &[Conclusion] = &[
    ("vehicle controller limps", |world| world.vcu.limp),
    ("system fault bit", |world| world.vcu.system_fault),
    ("battery: code 70, limp", |world| {
        world.bms.active.iter().any(|fault| fault.code == 70) && world.bms.limp
    }),
    ("READY goes out", |world| !world.vcu.ready),
    ("motor without torque", |world| !world.motor.running),
    ("battery says that it has lost the vehicle controller", |world| {
        world.kind == Kind::C5ev && world.bms.vcu_silence_ms >= 1_000
    }),
    ("steering pump at its own speed", |world| {
        !world.steering.external && world.steering.running && world.motion.kmh() > 25.0
    }),
    ("compressor stops", |world| !world.compressor.running),
    ("air conditioning: alarm, goes on", |world| world.hvac.communication_alarm && world.hvac.on),
    ("high voltage is not opened in time", |world| world.bms.hv_off_ms >= 5_000 && world.bms.main.closed),
    ("battery opens it itself", |world| world.bms.isolated && world.bms.main.closed),
    ("cluster not heard: key and parking brake by wire", |world| world.meter.silent_ms >= 3_000),
];

const CHARGING: &[Conclusion] = &[
    ("charger: communication fault, output off", |world| world.charger.communication_fault),
    ("battery: charging fault", |world| world.bms.charge == Charge::Fault),
    ("battery: its charge circuit opens", |world| {
        !world.bms.main.closed && !world.bms.charge_1.iter().all(|relay| relay.closed)
    }),
];

/// A scene: when the message is lost and when the scene ends, in ms, what is set when, what may be concluded.
struct Scene {
    name: &'static str,
    lost_ms: u64,
    end_ms: u64,
    settings: &'static [(u64, &'static str, f64)],
    conclusions: &'static [Conclusion],
}

const SCENES: [Scene; 2] = [
    Scene {
        name: "driving",
        lost_ms: 30_000,
        end_ms: 78_000,
        settings: &[
            (1_000, "driver.key", 3.0),
            (2_000, "driver.target", 40.0),
            (2_000, "air.mpa", 0.6),
            (2_000, "hvac.cabin", 45.0),
            (2_000, "road.celsius", 45.0),
            (2_000, "battery.hottest", 30.0),
            (2_000, "driver.air_conditioning", 1.0),
            (40_000, "battery.hottest", 66.0),
        ],
        conclusions: DRIVING,
    },
    Scene {
        name: "charging",
        lost_ms: 20_000,
        end_ms: 28_000,
        settings: &[(500, "battery.soc", 50.0), (1_000, "charge.plug", 1.0)],
        conclusions: CHARGING,
    },
];

/// Runs a scene; `lost` = the message that is not sent from the moment on. Returns what is true in each step.
fn run(kind: Kind, scene: &Scene, lost: Option<&str>) -> Vec<Vec<bool>> {
    let mut vehicle = VirtualVehicle::new(kind, Options { optional: true, ..Options::default() });
    let mut history = Vec::new();
    while vehicle.now_ms() < scene.end_ms {
        let now = vehicle.now_ms();
        for (_, path, value) in scene.settings.iter().filter(|(at, ..)| *at == now) {
            if vehicle.setting(path).is_some() {
                vehicle.set(path, Some(*value)).expect("in range");
            }
        }
        let is_gone = |name: &str| now >= scene.lost_ms && lost == Some(name);
        if now == scene.lost_ms {
            let path = lost.map(|name| format!("lost.{name}"));
            if let Some(path) = path.filter(|path| vehicle.setting(path).is_some()) {
                vehicle.set(&path, Some(1.0)).expect("a switch");
            }
        }
        speak(kind, &mut vehicle, is_gone);
        vehicle.advance();
        let world = vehicle.world();
        history.push(scene.conclusions.iter().map(|(_, is)| is(world)).collect());
    }
    history
}

/// What the cluster says, once a second.
fn speak(kind: Kind, vehicle: &mut VirtualVehicle, is_gone: impl Fn(&str) -> bool) {
    let now = vehicle.now_ms();
    if !now.is_multiple_of(1_000) {
        return;
    }
    let life = (now / 1_000) as u8;
    let said = citybus::Meter1::new().with_key_position_raw(1).with_life_raw(life);
    let frames: &[(&str, CanFrame)] = match kind {
        Kind::Citybus => &[
            ("Meter1", CanFrame::full(citybus::id::METER1, said.0)),
            ("Meter2", CanFrame::full(citybus::id::METER2, citybus::Meter2::new().0)),
        ],
        Kind::Jiulong => &[
            ("Meter1", CanFrame::full(jiulong::id::METER1, [life, 0, 0, 0, 0, 0, 1, 1])),
            ("Meter2", CanFrame::full(jiulong::id::METER2, [life, 0, 0, 0, 0, 0, 0, 0])),
            ("Meter3", CanFrame::full(jiulong::id::METER3, [life, 0, 0, 0, 0, 0, 0, 0])),
        ],
        Kind::C5ev => &[],
    };
    for (_, frame) in frames.iter().filter(|(name, _)| !is_gone(name)) {
        vehicle.receive(frame);
    }
}

/// What is concluded from the loss and after how long, in ms.
fn conclusions(scene: &Scene, with: &[Vec<bool>], without: &[Vec<bool>]) -> Vec<(&'static str, u64)> {
    let first = |place: usize| {
        let steps = with.iter().zip(without).position(|(with, without)| without[place] && !with[place])?;
        Some((steps as u64 + 1) * STEP_MS - scene.lost_ms)
    };
    let all = scene.conclusions.iter().enumerate();
    let mut found: Vec<_> = all.filter_map(|(place, (words, _))| Some((*words, first(place)?))).collect();
    found.sort_by_key(|(_, ms)| *ms);
    found
}

/// A series is one line: its frames say the same of other cells.
fn is_first(name: &str) -> bool {
    let number = name.strip_prefix("CellVoltages").or(name.strip_prefix("ModuleTemperatures"));
    number.is_none_or(|number| number == "1")
}

/// Scene, conclusion, and after how long, in ms.
type Found = (&'static str, &'static str, u64);

/// Every message of a vehicle, and what follows from its loss.
fn losses(kind: Kind) -> Vec<(&'static str, Vec<Found>)> {
    let with = SCENES.each_ref().map(|scene| run(kind, scene, None));
    let names = messages(kind).iter().map(|info| info.name).filter(|name| is_first(name));
    names
        .map(|name| {
            let found = SCENES.iter().zip(&with).flat_map(|(scene, with)| {
                let found = conclusions(scene, with, &run(kind, scene, Some(name)));
                found.into_iter().map(|(words, ms)| (scene.name, words, ms)).collect::<Vec<_>>()
            });
            (name, found.collect())
        })
        .collect()
}

#[test]
fn every_message_that_is_lost_alone_is_missed_as_the_documents_say() {
    let mut text = String::from(
        "# What follows when one message is lost\n\n\
         Each line is a run of the virtual vehicle in which only that message is missing, compared with the same run with\n\
         every message: who notices, and how long after the last moment at which it could have been sent. *Driving* is\n\
         40 km/h with air conditioning; ten seconds after the loss the battery is at 66 °C and asks for high voltage to be\n\
         opened. *Charging* is from the mains. What no node but the cluster acts on is -: what the cluster says of it is in\n\
         the scenarios. Nobody follows a command that was not sent: what was last heard holds until the time here.\n\n\
         Written and checked by `cargo test -p virtual-vehicle --test lost_messages`; refresh it with `BLESS=1` before it.\n\
         The readings behind it: [vehicle-readings.md](vehicle-readings.md).\n",
    );
    let mut all = Vec::new();
    for kind in Kind::ALL {
        write!(text, "\n## {}\n\n| message | driving | charging |\n| --- | --- | --- |\n", kind.name())
            .unwrap();
        for (name, found) in losses(kind) {
            let cell = |scene: &str| {
                let lines = found.iter().filter(|(of, ..)| *of == scene);
                let lines: Vec<_> =
                    lines.map(|(_, words, ms)| format!("{words} ({:.1} s)", *ms as f64 / 1_000.0)).collect();
                if lines.is_empty() { "-".to_owned() } else { lines.join("; ") }
            };
            writeln!(text, "| {name} | {} | {} |", cell("driving"), cell("charging")).unwrap();
            all.push((kind, name, found));
        }
    }
    let path = surroundings::root().join(FILE);
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(&path, &text).expect("the file can be written");
    }
    let after = |kind: Kind, message: &str, words: &str| {
        let (_, _, found) = all.iter().find(|(of, name, _)| (*of, *name) == (kind, message)).expect("a row");
        found.iter().find(|(_, said, _)| said.contains(words)).map(|(_, _, ms)| *ms)
    };
    // BUS-R080: within 5 s, whichever of the battery's messages it is.
    for message in ["BMS1", "BMS4", "BMS5"] {
        assert!(after(Kind::Citybus, message, "limps").is_some_and(|ms| ms <= 5_000), "{message}");
    }
    // BUS-R076: not answered, because nobody heard it, or because the answer does not come.
    for message in ["BMS1", "VCU3"] {
        let ms = after(Kind::Citybus, message, "opens it itself").unwrap_or_default();
        assert!((44_000..47_000).contains(&ms), "{message}: {ms} ms, 35 s after 10 s");
    }
    // BUS-R115: 5 s, and not before.
    assert!(after(Kind::Citybus, "VCU3", "code 70").is_some_and(|ms| (4_900..5_200).contains(&ms)));
    assert_eq!(after(Kind::Citybus, "VCU7", "code 70"), None);
    // The motor follows VCU2 and nothing else.
    assert!(after(Kind::Citybus, "VCU2", "without torque").is_some_and(|ms| ms <= 250));
    // BUS-R133: 10 s.
    assert!(after(Kind::Citybus, "VCU5", "alarm").is_some_and(|ms| (9_900..10_200).contains(&ms)));
    // C5-R005, C5-R007: 5 s.
    for (message, words) in [("ChargerTx", "charging fault"), ("ChargerControl", "output off")] {
        let ms = after(Kind::C5ev, message, words);
        assert!(ms.is_some_and(|ms| (4_000..=5_100).contains(&ms)), "{message}: {ms:?}");
    }
    let now = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        now == text,
        "{FILE} differs: `BLESS=1 cargo test -p virtual-vehicle --test lost_messages` refreshes it"
    );
}
