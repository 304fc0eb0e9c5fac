//! Screens as scene literals against committed pictures, pixel by pixel.
//!
//! `cargo xtask screens --bless` (BLESS=1) takes the pictures anew; look at every one before it is committed.

mod common;

use cluster::{
    FaultId, Named, Page, Telltale, Telltales, Trip, View,
    page::Chapter,
    view::{Journey, Limp, Line, List, Plug, Sheet},
};
use common::{Panel, day, english, lamps, line, list, missing, on, plugged, sheets, travelled};
use protocol_core::model::{Gear, Severity, Shown};
use protocol_core::vehicle::NO_VEHICLE;
use std::{fs, path::Path};
use ui::{HEIGHT, WIDTH};

fn alarm(fault: FaultId, code: Option<u16>, hv_off_s: Option<u8>) -> View {
    let stop = Line { code, ..Line::of(Named { code, ..Named::of(fault) }, Severity::Stop, &NO_VEHICLE) };
    View {
        line: Some(stop),
        severity: Severity::Stop,
        alarm: Some(stop),
        hv_off_s,
        telltales: lamps(&[Telltale::BatteryFault, Telltale::LowBeam, Telltale::SystemFault]),
        ..common::driving()
    }
}

fn above_steering(view: View) -> View {
    let named = Named { code: Some(5), ..Named::of(FaultId::Steering) };
    View { below: Some(Line { count: 2, ..Line::of(named, Severity::Warn, &NO_VEHICLE) }), ..view }
}

fn after_a_stop(view: View) -> View {
    let line = line(Severity::Stop, "绝缘故障", "Insulation fault", 11, 1, 1);
    View { line: None, severity: Severity::None, unseen: Some(line), says_unseen: true, ..view }
}

/// Returns 8-bit red, green and blue of 5-6-5 words, the full range used.
fn rgb(words: &[u16]) -> Vec<u8> {
    let widen = |part: u16, bits: u32| (u32::from(part) * 255 / ((1 << bits) - 1)) as u8;
    words
        .iter()
        .flat_map(|word| [widen(word >> 11, 5), widen(word >> 5 & 63, 6), widen(word & 31, 5)])
        .collect()
}

fn write_png(path: &Path, pixels: &[u8]) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let file = fs::File::create(path).unwrap();
    let mut encoder = png::Encoder::new(file, u32::from(WIDTH), u32::from(HEIGHT));
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header().unwrap().write_image_data(pixels).unwrap();
}

fn read_png(path: &Path) -> Option<Vec<u8>> {
    let file = std::io::BufReader::new(fs::File::open(path).ok()?);
    let mut reader = png::Decoder::new(file).read_info().ok()?;
    let mut pixels = vec![0; reader.output_buffer_size()?];
    reader.next_frame(&mut pixels).ok()?;
    Some(pixels)
}

/// Compares the picture of `view` with `tests/screens/<name>.png`.
fn check(name: &str, view: &View) {
    let actual = rgb(&Panel::of(view).pixels);
    let expected_path = surroundings::root().join(format!("app/ui/tests/screens/{name}.png"));
    if std::env::var_os("BLESS").is_some() {
        write_png(&expected_path, &actual);
        return;
    }
    let expected = read_png(&expected_path).unwrap_or_default();
    if expected == actual {
        return;
    }
    let folder = surroundings::scratch().join("screens");
    write_png(&folder.join(format!("{name}.actual.png")), &actual);
    let differs = |at: usize| expected.get(3 * at..3 * at + 3) != actual.get(3 * at..3 * at + 3);
    let count = (0..actual.len() / 3).filter(|&at| differs(at)).count();
    let diff: Vec<u8> = (0..actual.len() / 3)
        .flat_map(
            |at| if differs(at) { [255, 0, 255] } else { [0, 1, 2].map(|part| actual[3 * at + part] / 4) },
        )
        .collect();
    write_png(&folder.join(format!("{name}.diff.png")), &diff);
    panic!(
        "screen {name} differs in {count} pixels from {}\n  actual: {folder}/{name}.actual.png\n  difference: \
         {folder}/{name}.diff.png\n  if the new picture is right: cargo xtask screens --bless",
        expected_path.display(),
        folder = folder.display(),
    );
}

macro_rules! screens {
    ($($(#[$doc:meta])* $name:ident: $view:expr;)*) => {
        mod screen {
            use super::*;
            $($(#[$doc])* #[test] fn $name() { check(stringify!($name), &$view); })*
        }

        /// A picture that no scene draws is forgotten work.
        #[test]
        fn every_committed_picture_has_its_scene() {
            let scenes = [$(stringify!($name)),*];
            for entry in fs::read_dir(surroundings::root().join("app/ui/tests/screens")).unwrap() {
                let path = entry.unwrap().path();
                let name = path.file_stem().unwrap().to_str().unwrap();
                assert!(scenes.contains(&name), "{} belongs to no scene: delete it", path.display());
            }
        }
    };
}

fn stop_view() -> View {
    View {
        telltales: lamps(&[Telltale::BatteryFault, Telltale::SystemFault, Telltale::LowBeam]),
        severity: Severity::Stop,
        line: Some(line(Severity::Stop, "绝缘故障 立即停车", "Insulation fault: stop now", 11, 2, 5)),
        ..common::driving()
    }
}

fn warn_view() -> View {
    View {
        telltales: lamps(&[Telltale::Ready, Telltale::LowBeam, Telltale::LowCharge]),
        is_charge_low: true,
        soc_percent: Shown::Value(12),
        severity: Severity::Warn,
        line: Some(line(Severity::Warn, "剩余电量低", "Charge is low", 4, 1, 1)),
        ..common::driving()
    }
}

fn bulb_check_view() -> View {
    View { telltales: Telltales::ALL, ..View::default() }
}

/// The vehicle speaks before the check is over.
fn bulb_check_known_view() -> View {
    View {
        speed_kmh: Shown::Value(0),
        gear: Some(Gear::P),
        soc_percent: Shown::Value(80),
        power_hectowatts: Shown::Value(4),
        pack_deciamps: Shown::Value(8),
        motor_rpm: Shown::Value(0),
        telltales: Telltales::ALL,
        ..common::driving()
    }
}

fn fast_view() -> View {
    View {
        speed_kmh: Shown::Value(188),
        motor_rpm: Shown::Value(11_900),
        power_hectowatts: Shown::Value(1999),
        ..common::driving()
    }
}

fn hv_off_view() -> View {
    View {
        telltales: lamps(&[Telltale::BatteryFault, Telltale::SystemFault, Telltale::Ready]),
        severity: Severity::Stop,
        line: Some(Line {
            count: 3,
            ..Line::of(Named { stage: 1, ..Named::of(FaultId::HvOff) }, Severity::Stop, &NO_VEHICLE)
        }),
        hv_off_s: Some(28),
        ..travelled()
    }
}

fn limp_view() -> View {
    View {
        speed_kmh: Shown::Value(23),
        telltales: lamps(&[Telltale::Ready, Telltale::PowerLimited, Telltale::NoCommunication]),
        is_power_limited: true,
        severity: Severity::Derate,
        line: Some(Line { count: 2, ..Line::of(Named::of(FaultId::Limp), Severity::Derate, &NO_VEHICLE) }),
        limp: Some(Limp { limit_deciamps: Some(540) }),
        ..missing::<true>(travelled())
    }
}

fn chapter_view(chapter: Chapter) -> View {
    on(Page::Technic(sheet_of(chapter)), common::driving())
}

fn sheet_of(chapter: Chapter) -> Sheet {
    sheets().into_iter().find(|sheet| sheet.chapter == chapter).expect("every chapter has a sheet")
}

screens! {
    bulb_check: bulb_check_view();
    /// Every lamp is lit, and nothing else says what is not true: the charge is not low, no power is limited.
    bulb_check_known: bulb_check_known_view();
    never_seen: View::default();
    driving: common::driving();
    driving_en: english(common::driving());
    driving_day: day(common::driving());
    driving_day_en: day(english(common::driving()));
    /// A STOP that nobody has acknowledged has taken the page over.
    alarm_insulation: alarm(FaultId::Insulation, Some(11), None);
    alarm_insulation_day_en: day(english(alarm(FaultId::Insulation, Some(11), None)));
    alarm_hv_off: alarm(FaultId::HvOff, None, Some(27));
    alarm_hv_off_en: english(alarm(FaultId::HvOff, None, Some(27)));
    alarm_fire: alarm(FaultId::Fire, Some(24), Some(3));
    alarm_fire_day_en: day(english(alarm(FaultId::Fire, Some(24), Some(3))));
    /// Below it stands what is milder.
    alarm_and_steering_en: english(above_steering(alarm(FaultId::Insulation, Some(11), None)));
    /// A STOP that is over and that nobody has acknowledged.
    unseen: after_a_stop(common::driving());
    unseen_day_en: day(english(after_a_stop(common::driving())));
    /// Three figures in every place.
    full_scale: View {
        soc_percent: Shown::Value(100),
        pack_decivolts: Shown::Value(7500),
        pack_deciamps: Shown::Value(-4200),
        motor_celsius: Shown::Value(-40),
        inverter_celsius: Shown::Value(128),
        cell_millivolts: (Shown::Value(4180), Shown::Value(2790)),
        cell_celsius: (Shown::Value(101), Shown::Value(-28)),
        odometer_hectometres: 9_999_999,
        telltales: lamps(&[Telltale::Ready, Telltale::HighBeam, Telltale::TurnLeft, Telltale::TurnRight]),
        ..fast_view()
    };
    /// Zero is a value: pointers stand at zero, nothing is dashed.
    standing: View {
        speed_kmh: Shown::Value(0),
        gear: Some(Gear::P),
        pack_deciamps: Shown::Value(12),
        power_hectowatts: Shown::Value(4),
        motor_rpm: Shown::Value(0),
        telltales: lamps(&[Telltale::Ready, Telltale::ParkingBrake, Telltale::Door]),
        ..common::driving()
    };
    regeneration: View {
        speed_kmh: Shown::Value(47),
        pack_deciamps: Shown::Value(-412),
        power_hectowatts: Shown::Value(-221),
        motor_rpm: Shown::Value(3690),
        ..common::driving()
    };
    reversing: View {
        speed_kmh: Shown::Value(6),
        gear: Some(Gear::R),
        motor_rpm: Shown::Value(-480),
        power_hectowatts: Shown::Value(38),
        ..common::driving()
    };
    stale: View {
        telltales: lamps(&[Telltale::NoCommunication]),
        gear: None,
        severity: Severity::Stop,
        line: Some(line(Severity::Stop, "整车控制器通信中断", "No communication: VCU", 901, 1, 3)),
        ..missing::<true>(common::driving())
    };
    invalid: View { telltales: lamps(&[Telltale::SystemFault]), gear: None, ..missing::<false>(common::driving()) };
    warn: warn_view();
    warn_en: english(warn_view());
    warn_day: day(warn_view());
    derate: View {
        telltales: lamps(&[Telltale::Ready, Telltale::PowerLimited, Telltale::MotorFault]),
        is_power_limited: true,
        motor_celsius: Shown::Value(142),
        severity: Severity::Derate,
        line: Some(line(Severity::Derate, "电机过热 功率受限", "Motor too hot: power is limited", 215, 1, 2)),
        ..common::driving()
    };
    derate_en: english(View {
        telltales: lamps(&[Telltale::Ready, Telltale::PowerLimited, Telltale::MotorFault]),
        is_power_limited: true,
        severity: Severity::Derate,
        line: Some(line(Severity::Derate, "电机过热 功率受限", "Motor too hot: power is limited", 215, 1, 2)),
        ..common::driving()
    });
    stop: stop_view();
    stop_en: english(stop_view());
    stop_day: day(stop_view());
    stop_day_en: day(english(stop_view()));
    fire: View {
        speed_kmh: Shown::Value(0),
        gear: Some(Gear::N),
        motor_rpm: Shown::Value(0),
        power_hectowatts: Shown::Value(0),
        pack_deciamps: Shown::Value(0),
        cell_celsius: (Shown::Value(168), Shown::Value(41)),
        telltales: lamps(&[Telltale::BatteryFault, Telltale::SystemFault, Telltale::BatteryCut]),
        severity: Severity::Stop,
        line: Some(line(Severity::Stop, "火灾报警 立即停车疏散", "FIRE: stop, get everyone out", 1, 1, 4)),
        ..common::driving()
    };
    charging: View {
        speed_kmh: Shown::Value(0),
        gear: Some(Gear::P),
        pack_deciamps: Shown::Value(-1204),
        power_hectowatts: Shown::Value(-647),
        motor_rpm: Shown::Value(0),
        motor_celsius: Shown::Value(31),
        inverter_celsius: Shown::Value(29),
        telltales: lamps(&[Telltale::ChargePlug, Telltale::Charging, Telltale::ParkingBrake]),
        line: Some(Line { code: None, ..line(Severity::None, "正在充电", "Charging", 0, 1, 1) }),
        ..common::driving()
    };
    charging_day: day(View {
        speed_kmh: Shown::Value(0),
        gear: Some(Gear::P),
        power_hectowatts: Shown::Value(-647),
        pack_deciamps: Shown::Value(-1204),
        telltales: lamps(&[Telltale::ChargePlug, Telltale::Charging, Telltale::ParkingBrake]),
        line: Some(Line { code: None, ..line(Severity::None, "正在充电", "Charging", 0, 1, 1) }),
        ..common::driving()
    });
    bulb_check_day: day(bulb_check_view());
    /// A text that is too long is cut and says so.
    long_text: english(View {
        severity: Severity::Warn,
        line: Some(line(Severity::Warn, "", "A text that is far too long for the line of this screen", 65_535, 12, 12)),
        ..common::driving()
    });
    /// The range stands under the charge.
    range: travelled();
    hv_off: hv_off_view();
    hv_off_en: english(hv_off_view());
    hv_off_day: day(hv_off_view());
    limp: limp_view();
    limp_en: english(limp_view());
    trip_a: on(Page::Trip(Trip::A), travelled());
    trip_b_en: english(on(Page::Trip(Trip::B), travelled()));
    trip_day: day(on(Page::Trip(Trip::A), travelled()));
    /// A trip that has just been set to zero has no average.
    trip_reset_en: english(on(
        Page::Trip(Trip::A),
        View { journeys: [Journey::default(); 2], range: Shown::Stale, ..travelled() },
    ));
    energy: on(Page::Energy, travelled());
    energy_en: english(on(Page::Energy, travelled()));
    /// A number that has no room beside its unit loses its decimals, not a part of the unit.
    energy_regeneration: on(
        Page::Energy,
        View {
            pack_deciamps: Shown::Value(-3_200),
            power_hectowatts: Shown::Value(-1_718),
            consumption_whkm: Shown::Value(-1_315),
            ..travelled()
        },
    );
    energy_missing: on(Page::Energy, View { range: Shown::Stale, consumption_whkm: Shown::Stale, ..missing::<true>(travelled()) });
    plugged_en: english(plugged(Plug::Inserted));
    plug_charging: plugged(Plug::Charging);
    plug_charging_en: english(plugged(Plug::Charging));
    plug_charging_day: day(plugged(Plug::Charging));
    plug_complete: View { soc_percent: Shown::Value(100), ..plugged(Plug::Complete) };
    plug_fault_en: english(View {
        severity: Severity::Warn,
        line: Some(Line { code: None, ..line(Severity::Warn, "充电机故障", "Charger fault", 0, 1, 1) }),
        ..plugged(Plug::Fault)
    });
    faults: on(Page::Faults(list()), stop_view());
    faults_en: english(on(Page::Faults(list()), stop_view()));
    faults_day: day(on(Page::Faults(list()), stop_view()));
    faults_none: on(Page::Faults(List { position: 1, count: 1, ..List::default() }), travelled());
    history: on(Page::History(List { position: 2, ..list() }), travelled());
    history_en: english(on(Page::History(List { position: 2, ..list() }), travelled()));
    relays: chapter_view(Chapter::Relays);
    relays_en: english(chapter_view(Chapter::Relays));
    contactors: chapter_view(Chapter::Contactors);
    contactors_en: english(chapter_view(Chapter::Contactors));
    contactor_box: chapter_view(Chapter::Box);
    contactor_box_en: english(chapter_view(Chapter::Box));
    codes: chapter_view(Chapter::Codes);
    codes_day_en: day(english(chapter_view(Chapter::Codes)));
    extremes: chapter_view(Chapter::Extremes);
    extremes_en: english(chapter_view(Chapter::Extremes));
    bus_counters: chapter_view(Chapter::Bus);
    bus_counters_en: english(chapter_view(Chapter::Bus));
    controls: chapter_view(Chapter::Controls);
    controls_en: english(chapter_view(Chapter::Controls));
    drive_en: english(chapter_view(Chapter::Drive));
    battery: chapter_view(Chapter::Battery);
    battery_en: english(chapter_view(Chapter::Battery));
    nameplate_day: day(chapter_view(Chapter::Nameplate));
    supply_en: english(chapter_view(Chapter::Supply));
    pumps: chapter_view(Chapter::Pumps);
    pumps_en: english(chapter_view(Chapter::Pumps));
    climate_day_en: day(english(chapter_view(Chapter::Climate)));
    /// A sender that is silent looks silent here too.
    relays_stale: on(
        Page::Technic(Sheet { values: [Shown::Stale; cluster::page::VALUES], ..sheet_of(Chapter::Relays) }),
        common::driving(),
    );
}
