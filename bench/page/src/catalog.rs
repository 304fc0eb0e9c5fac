//! What there is to see and to change in a bench, told once to every page.
//!
//! Built from the vehicle's own tables of controls and readouts, from the tables of messages, and from two small tables
//! of the page: presets (several settings at once) and faults of the bus wires. Refuses to know what a control leads to.

use crate::beside::beside;
use crate::scenes::{Library, Scene};
use crate::trace::{self, Named};
use crate::wires::WIRES;
use cluster::Telltale;
use protocol_core::Value;
use protocol_core::states::{self, State};
use serde::Serialize;
use std::collections::BTreeMap;
use virtual_vehicle::{Control, Group, Kind, Readout, Setting, Takes, VirtualVehicle};

/// One word of a choice.
#[derive(Debug, Serialize)]
struct Word {
    word: &'static str,
    zh: &'static str,
    en: &'static str,
}

/// What a control takes, as the page needs it.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
enum Form {
    Flag,
    Choice { words: Vec<Word> },
    Number { min: f64, max: f64, step: f64, unit: &'static str },
}

/// One control.
#[derive(Debug, Serialize)]
struct Row {
    path: &'static str,
    zh: &'static str,
    en: &'static str,
    group: &'static str,
    free: bool,
    #[serde(flatten)]
    form: Form,
}

/// One readout.
#[derive(Debug, Serialize)]
struct Truth {
    path: &'static str,
    zh: &'static str,
    en: &'static str,
    unit: &'static str,
    digits: u8,
    /// Name of the cluster's value of the same thing; empty = it has none.
    beside: &'static str,
    /// Name of its kind of state; `None` = a number.
    states: Option<&'static str>,
}

/// A vehicle to choose from.
#[derive(Debug, Serialize)]
struct Choice {
    name: &'static str,
    zh: &'static str,
    en: &'static str,
}

/// Several settings at once.
struct Preset {
    name: &'static str,
    zh: &'static str,
    en: &'static str,
    settings: &'static [(&'static str, &'static str)],
}

/// A preset as the page lists it.
#[derive(Debug, Serialize)]
struct PresetName {
    name: &'static str,
    zh: &'static str,
    en: &'static str,
}

const DRIVE_50: &[(&str, &str)] = &[
    ("charge.plug", "off"),
    ("driver.key", "start"),
    ("driver.parking_brake", "off"),
    ("driver.seat_empty", "off"),
    ("driver.brake", "0"),
    ("driver.accelerator", "0"),
    ("driver.gear", "D"),
    ("driver.target", "50"),
];

const STOP: &[(&str, &str)] = &[
    ("driver.accelerator", "0"),
    ("driver.target", "0"),
    ("driver.gear", "N"),
    ("driver.parking_brake", "on"),
];

const CHARGE: &[(&str, &str)] = &[
    ("driver.accelerator", "0"),
    ("driver.target", "0"),
    ("driver.gear", "N"),
    ("driver.parking_brake", "on"),
    ("charge.mains", "220"),
    ("charge.plug", "on"),
];

const PRESETS: &[Preset] = &[
    Preset { name: "drive", zh: "行驶 50 km/h", en: "Drive 50 km/h", settings: DRIVE_50 },
    Preset { name: "stop", zh: "停车", en: "Stop and park", settings: STOP },
    Preset { name: "charge", zh: "插枪充电", en: "Plug in and charge", settings: CHARGE },
];

/// Settings with which a bench begins: the driver's seat is taken, the vehicle is READY.
const BEGINNING: &[(&str, &str)] =
    &[("driver.key", "start"), ("driver.parking_brake", "off"), ("driver.seat_empty", "off")];

/// What a person calls a telltale.
#[derive(Debug, Serialize)]
struct Legend {
    key: &'static str,
    zh: &'static str,
    en: &'static str,
}

/// What a page is told when it comes, and when the bench starts again.
#[derive(Debug, Serialize)]
pub(crate) struct Catalog {
    kind: &'static str,
    /// Counts benches: another number means that everything begins again.
    bench: u64,
    /// Folder of the vehicle; `None` while a recording plays.
    vehicle: Option<&'static str>,
    vehicles: Vec<Choice>,
    /// Name of the recording that may be played in place of a vehicle.
    recording: Option<String>,
    /// What else is on the bus.
    notes: Vec<String>,
    bitrate: u32,
    controls: Vec<Row>,
    /// What they are set to when a vehicle is new, in the same order.
    initial: Vec<Setting>,
    presets: Vec<PresetName>,
    truths: Vec<Truth>,
    /// Every telltale.
    telltales: Vec<Legend>,
    /// The states of every kind.
    states: BTreeMap<&'static str, &'static [State]>,
    /// The kind of every value of the cluster that is a state.
    values: BTreeMap<&'static str, &'static str>,
    scenarios: Vec<Scene>,
    messages: Vec<Named>,
}

/// What the page knows of a bench beside its vehicle.
pub(crate) struct Around<'a> {
    pub(crate) bench: u64,
    pub(crate) recording: Option<&'a str>,
    pub(crate) notes: &'a [String],
    pub(crate) bitrate: u32,
}

impl Catalog {
    pub(crate) fn of(vehicle: Option<&VirtualVehicle>, library: &Library, around: &Around<'_>) -> Self {
        let kind = vehicle.map(VirtualVehicle::kind);
        let mut controls: Vec<Row> =
            vehicle.map(|vehicle| vehicle.controls().map(row).collect()).unwrap_or_default();
        controls.extend(WIRES.iter().map(|wire| Row {
            path: wire.path,
            zh: wire.zh,
            en: wire.en,
            group: group_name(Group::Links),
            free: false,
            form: Form::Flag,
        }));
        let mut initial = vehicle.map(fresh).unwrap_or_default();
        initial.extend(WIRES.iter().map(|_| Some(0.0)));
        let truths = vehicle.map(VirtualVehicle::readouts).unwrap_or_default();
        let presets = vehicle.map(|vehicle| {
            let fits = |preset: &&Preset| preset.settings.iter().any(|(path, _)| has(vehicle, path));
            PRESETS.iter().filter(fits).map(|p| PresetName { name: p.name, zh: p.zh, en: p.en }).collect()
        });
        Self {
            kind: "catalog",
            bench: around.bench,
            vehicle: kind.map(Kind::name),
            vehicles: Kind::ALL.into_iter().map(choice).collect(),
            recording: around.recording.map(str::to_owned),
            notes: around.notes.to_vec(),
            bitrate: around.bitrate,
            controls,
            initial,
            presets: presets.unwrap_or_default(),
            truths: truths
                .iter()
                .map(|readout| {
                    let Readout { path, zh, en, unit, digits, kind, .. } = *readout;
                    let states = kind.map(|kind| kind.name);
                    Truth { path, zh, en, unit, digits, beside: beside(path), states }
                })
                .collect(),
            telltales: Telltale::ALL
                .iter()
                .map(|it| Legend { key: it.key(), zh: it.zh(), en: it.en() })
                .collect(),
            states: states::KINDS.iter().map(|kind| (kind.name, kind.states)).collect(),
            values: Value::ALL
                .iter()
                .filter_map(|value| Some((value.path(), value.unit().kind()?.name)))
                .collect(),
            scenarios: kind.map(|kind| library.list(kind)).unwrap_or_default(),
            messages: trace::messages(kind.map(Kind::name)),
        }
    }
}

/// Returns what the controls of [`Catalog::of`] are set to, in the same order, without the wires.
pub(crate) fn settings(vehicle: &VirtualVehicle) -> impl Iterator<Item = Setting> {
    vehicle.controls().map(|control| (control.get)(vehicle.world()))
}

/// Returns the settings of a new vehicle that is built as this one was.
fn fresh(vehicle: &VirtualVehicle) -> Vec<Setting> {
    settings(&VirtualVehicle::new(vehicle.kind(), vehicle.world().options)).collect()
}

/// Sets what a bench begins with.
pub(crate) fn begin(vehicle: &mut VirtualVehicle) {
    // A setting that this vehicle does not have is not missed.
    let _ = apply(vehicle, BEGINNING);
}

/// Sets everything of the preset of this name that the vehicle has.
///
/// # Errors
/// If there is no such preset, or the vehicle takes one of its settings otherwise.
pub(crate) fn preset(vehicle: &mut VirtualVehicle, name: &str) -> Result<(), String> {
    let preset = PRESETS.iter().find(|preset| preset.name == name);
    apply(vehicle, preset.ok_or_else(|| format!("there is no preset `{name}`"))?.settings)
}

fn apply(vehicle: &mut VirtualVehicle, settings: &[(&str, &str)]) -> Result<(), String> {
    let mut result = Ok(());
    for (path, text) in settings {
        let Some(control) = vehicle.controls().find(|control| control.path == *path) else { continue };
        let set = control.read(text).and_then(|setting| vehicle.set(path, setting));
        result = result.and(set.map_err(|error| error.to_string()));
    }
    result
}

fn has(vehicle: &VirtualVehicle, path: &str) -> bool {
    vehicle.controls().any(|control| control.path == path)
}

fn choice(kind: Kind) -> Choice {
    let (zh, en) = match kind {
        Kind::Citybus => ("公交车", "City bus"),
        Kind::Jiulong => ("九龙客车", "Jiulong van"),
        Kind::C5ev => ("C5EV 轿车", "C5EV car"),
    };
    Choice { name: kind.name(), zh, en }
}

fn row(control: &'static Control) -> Row {
    let word = |word: &virtual_vehicle::Word| Word { word: word.word, zh: word.zh, en: word.en };
    let form = match control.takes {
        Takes::Flag => Form::Flag,
        Takes::Choice(words) => Form::Choice { words: words.iter().map(word).collect() },
        Takes::Number { min, max, step, unit } => Form::Number { min, max, step, unit },
    };
    Row {
        path: control.path,
        zh: control.zh,
        en: control.en,
        group: group_name(control.group),
        free: control.free,
        form,
    }
}

const fn group_name(group: Group) -> &'static str {
    match group {
        Group::Driver => "driver",
        Group::Body => "body",
        Group::Road => "road",
        Group::Charging => "charging",
        Group::Battery => "battery",
        Group::Motor => "motor",
        Group::Parts => "parts",
        Group::Links => "links",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nothing() -> Library {
        Library::new(|_| Vec::new())
    }
    use serde_json::json;
    use virtual_vehicle::Options;

    #[test]
    fn every_preset_is_taken_by_every_vehicle() {
        for kind in Kind::ALL {
            for preset in PRESETS.iter().map(|preset| preset.settings).chain([BEGINNING]) {
                let mut vehicle = VirtualVehicle::new(kind, Options::default());
                assert_eq!(apply(&mut vehicle, preset), Ok(()), "{kind:?} {preset:?}");
            }
        }
    }

    #[test]
    fn presets_name_controls_that_some_vehicle_has() {
        let vehicles = Kind::ALL.map(|kind| VirtualVehicle::new(kind, Options::default()));
        for (path, _) in PRESETS.iter().flat_map(|preset| preset.settings) {
            assert!(vehicles.iter().any(|vehicle| has(vehicle, path)), "{path}");
        }
    }

    #[test]
    fn the_page_is_told_what_every_telltale_is_called() {
        let vehicle = VirtualVehicle::new(Kind::C5ev, Options::default());
        let around = Around { bench: 0, recording: None, notes: &[], bitrate: 250_000 };
        let catalog = serde_json::to_value(Catalog::of(Some(&vehicle), &nothing(), &around)).unwrap();
        for (row, telltale) in catalog["telltales"].as_array().unwrap().iter().zip(Telltale::ALL) {
            assert_eq!((&row["key"], &row["zh"]), (&telltale.key().into(), &telltale.zh().into()));
            assert_eq!(row["en"], telltale.en());
        }
        assert_eq!(catalog["telltales"].as_array().map(Vec::len), Some(Telltale::ALL.len()));
    }

    #[test]
    fn the_page_has_the_texts_of_every_state_and_the_kind_of_every_value() {
        let around = Around { bench: 0, recording: None, notes: &[], bitrate: 250_000 };
        let catalog = serde_json::to_value(Catalog::of(None, &nothing(), &around)).expect("a catalog");
        for kind in states::KINDS {
            let rows = &catalog["states"][kind.name];
            assert_eq!(rows.as_array().map(Vec::len), Some(kind.states.len()), "{}", kind.name);
            for (place, state) in kind.states.iter().enumerate() {
                let State { number, word, zh, en, .. } = *state;
                assert_eq!(rows[place], json!({ "number": number, "word": word, "zh": zh, "en": en }));
            }
        }
        for value in Value::ALL {
            let kind = catalog["values"][value.path()].as_str();
            assert_eq!(kind, value.unit().kind().map(|kind| kind.name), "{}", value.path());
        }
    }

    #[test]
    fn the_page_types_no_text_of_a_state_again() {
        let script = include_str!("page.js");
        // A telltale is called as the charge state that lights it.
        for kind in ["severity", "contactor", "run", "missing", "confinement"] {
            let kind = states::KINDS.iter().find(|known| known.name == kind).expect("a kind");
            for state in kind.states {
                let pair = format!("[\"{}\", \"{}\"]", state.zh, state.en);
                assert!(!script.to_lowercase().contains(&pair.to_lowercase()), "page.js has {pair}");
            }
        }
    }

    #[test]
    fn every_control_of_a_vehicle_is_on_the_page_once() {
        for kind in Kind::ALL {
            let vehicle = VirtualVehicle::new(kind, Options::default());
            let around = Around { bench: 0, recording: None, notes: &[], bitrate: 250_000 };
            let catalog = Catalog::of(Some(&vehicle), &nothing(), &around);
            let mut paths: Vec<&str> = catalog.controls.iter().map(|control| control.path).collect();
            assert_eq!(paths.len(), vehicle.controls().count() + WIRES.len());
            assert_eq!(settings(&vehicle).count() + WIRES.len(), paths.len());
            paths.sort_unstable();
            let all = paths.len();
            paths.dedup();
            assert_eq!(paths.len(), all, "{kind:?}: a name stands for one thing");
        }
    }
}
