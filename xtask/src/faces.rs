//! Where each received value shows: found by changing one signal and looking at everything that an instrument gives out.
//!
//! A vehicle's own recording is played, up to a moment, with messages that it lacks at their start values; then one signal
//! of one message is set to each of its probes, in every later frame of that message, and what the cluster shows, lights,
//! says, sounds and sends after two and a half seconds is compared with what it does when nothing is changed. So it goes
//! driving, standing, and with a plug inserted that charges. A chapter shows the values of its row. What no driver sees has a
//! reason in [`HIDDEN`]; a value without face and reason is an error, and so is a reason for what has a face.

use crate::vehicles::{Tables, can_frame};
use crate::workspace;
use anyhow::{Context, Result, bail};
use bench::log::Log;
use cluster::page::Chapter;
use cluster::{Cluster, Inputs, Telltale, View};
use protocol_core::codec::SignalInfo;
use protocol_core::model::{Reading, Readings, Value};
use protocol_core::states::Charge;
use protocol_core::{CanFrame, CanId, Millis, RxMessage};
use std::collections::{BTreeMap, BTreeSet};

/// Values of a vehicle that reach no face by intention, each with the reason.
const HIDDEN: &[(&str, Value, &str)] = &[
    ("jiulong", Value::VehicleSoc, "stands in for `battery.soc` while that is missing"),
    ("jiulong", Value::ChargerFault, "the fault level of the same frame decides"),
    ("c5ev", Value::MotorPower, "stands in for the battery's power where the bus does not have that"),
];

/// Returns why a value of a vehicle has no face, if it has none by intention.
pub fn reason(vehicle: &str, value: Value) -> Option<&'static str> {
    HIDDEN.iter().find(|(of, hidden, _)| (*of, *hidden) == (vehicle, value)).map(|(.., reason)| *reason)
}

/// How long a change stands before it is looked at, in milliseconds.
const STANDS_MS: u64 = 2_500;
const TICK_MS: u64 = 10;
/// Cycle of messages that the recording lacks, in milliseconds.
const MISSING_CYCLE_MS: usize = 100;

/// What one value of a vehicle is seen in.
pub type Faces = BTreeMap<Value, BTreeSet<String>>;

/// Returns the faces of every value that `tables`' vehicle receives; `sources` are the signals of each, `MESSAGE.signal`.
///
/// # Errors
/// If the vehicle's recording cannot be read.
pub fn of(tables: Tables, sources: &BTreeMap<Value, BTreeSet<String>>) -> Result<Faces> {
    let on_pages = |value: Value| {
        let chapters =
            Chapter::ALL.iter().filter(move |it| it.items().iter().any(|item| item.value == value));
        chapters.map(|chapter| format!("page {}", chapter.key())).collect()
    };
    let mut faces: Faces = sources.keys().map(|&value| (value, on_pages(value))).collect();
    let driven = recording(tables)?;
    let charged = charging(tables, &driven);
    let end = driven.last().map_or(0, |(at, _)| at.saturating_sub(STANDS_MS));
    for (frames, from) in [(&driven, end / 4), (&driven, end / 2), (&driven, end), (&charged, end)] {
        let before = played(tables, frames, from);
        let plain = Seen::after(before.clone(), frames, from, |frame| frame);
        for received in tables.vehicle.rx {
            for signal in tables.message(received.id).map_or(&[][..], |message| message.signals) {
                let name = format!("{}.{}", received.name, signal.name);
                let fed =
                    sources.iter().filter(|(_, signals)| signals.contains(&name)).map(|(value, _)| *value);
                let fed: Vec<Value> = fed.collect();
                if fed.is_empty() {
                    continue;
                }
                for raw in probes(signal) {
                    let change = |frame: CanFrame| with(frame, received, signal, raw);
                    let seen = Seen::after(before.clone(), frames, from, change).beside(&plain);
                    fed.iter()
                        .for_each(|value| faces.entry(*value).or_default().extend(seen.iter().cloned()));
                }
            }
        }
    }
    Ok(faces)
}

/// Checks that every value of a vehicle has a face or a reason.
///
/// # Errors
/// The values that have neither, and those that have both.
pub fn check(vehicle: &str, faces: &Faces) -> Result<()> {
    let wrong = faces.iter().filter_map(|(&value, seen)| match (seen.is_empty(), reason(vehicle, value)) {
        (true, None) => {
            Some(format!("{vehicle}: `{}` reaches no face: give it one, or a reason", value.path()))
        }
        (false, Some(_)) => {
            Some(format!("{vehicle}: `{}` has a face: its reason in HIDDEN is not true", value.path()))
        }
        _ => None,
    });
    let wrong: Vec<String> = wrong.collect();
    if wrong.is_empty() { Ok(()) } else { bail!("{}\n(xtask/src/faces.rs)", wrong.join("\n")) }
}

/// Returns the vehicle's own recording: when, in milliseconds, and what; messages that it lacks come at start values.
fn recording(tables: Tables) -> Result<Vec<(u64, CanFrame)>> {
    let folder = workspace::root().join("vehicles").join(tables.vehicle.name).join("captures");
    let files = folder.read_dir().with_context(|| format!("{} cannot be read", folder.display()))?;
    let paths: BTreeSet<_> = files.filter_map(|entry| Some(entry.ok()?.path())).collect();
    let path = paths.iter().find(|path| path.extension().is_some_and(|extension| extension == "log"));
    let log = Log::read_file(path.with_context(|| format!("{} has no recording", folder.display()))?)?;
    let start = log.entries.first().map_or(0, |entry| entry.at.0);
    let heard = log.entries.iter();
    let heard = heard.filter_map(|entry| Some(((entry.at.0 - start) / 1_000_000, can_frame(&entry.frame)?)));
    let mut frames: Vec<(u64, CanFrame)> = heard.collect();
    let end = frames.last().map_or(0, |(at, _)| *at);
    let lacks = |received: &&RxMessage| frames.iter().all(|(_, frame)| frame.id != received.id);
    let missing: Vec<&RxMessage> = tables.vehicle.rx.iter().filter(lacks).collect();
    for received in missing {
        let Some(message) = tables.message(received.id) else { continue };
        for (count, at) in (0..=end).step_by(MISSING_CYCLE_MS).enumerate() {
            let mut data = message.start_frame();
            if let Some(life) = received.life {
                let byte = &mut data[usize::from(life.byte)];
                *byte = *byte & !life.mask | (count as u8) << life.mask.trailing_zeros() & life.mask;
            }
            frames.push((at, sealed(received, data)));
        }
    }
    frames.sort_by_key(|(at, _)| *at);
    Ok(frames)
}

/// Returns the recording with a plug that is inserted and charges, in a vehicle that stands.
fn charging(tables: Tables, frames: &[(u64, CanFrame)]) -> Vec<(u64, CanFrame)> {
    let wanted =
        [(Value::ChargePlug, 1), (Value::ChargeState, Charge::Charging.number()), (Value::VehicleSpeed, 0)];
    let mut changes = Vec::new();
    for (index, received) in tables.vehicle.rx.iter().enumerate() {
        let Some(message) = tables.message(received.id) else { continue };
        for signal in message.signals {
            let brings = |raw: &i64| {
                let mut data = message.start_frame();
                signal.set_raw(&mut data, *raw);
                let mut readings = Readings::new();
                (tables.vehicle.decode)(index as u8, &data, &mut readings);
                let is = |&(value, number)| {
                    readings.get(value).is_some_and(|(it, _)| it == Reading::Valid(number))
                };
                let feeds = |value: Value| {
                    let mut plain = Readings::new();
                    let mut other = message.start_frame();
                    signal.set_raw(&mut other, if *raw == 0 { 1 } else { 0 });
                    (tables.vehicle.decode)(index as u8, &other, &mut plain);
                    plain.get(value) != readings.get(value)
                };
                wanted.iter().any(|wanted| is(wanted) && feeds(wanted.0))
            };
            if let Some(raw) = probes(signal).into_iter().find(brings) {
                changes.push((received, signal, raw));
            }
        }
    }
    let changed = |frame| {
        changes.iter().fold(frame, |frame, (received, signal, raw)| with(frame, received, signal, *raw))
    };
    frames.iter().map(|(at, frame)| (*at, changed(*frame))).collect()
}

/// Returns raw values to try: both limits and the first states.
fn probes(signal: &SignalInfo) -> BTreeSet<i64> {
    let (low, high) = signal.range;
    let mut probes = BTreeSet::from([low, high, low + (high - low) / 3]);
    probes.extend(signal.values.iter().map(|(raw, _)| *raw).take(6));
    probes
}

/// Returns `frame` with the signal set, if it is of that message.
fn with(frame: CanFrame, received: &RxMessage, signal: &SignalInfo, raw: i64) -> CanFrame {
    if frame.id != received.id {
        return frame;
    }
    let mut data = *frame.padded();
    signal.set_raw(&mut data, raw);
    sealed(received, data)
}

/// Returns a frame with a right check byte, where the message has one.
fn sealed(received: &RxMessage, mut data: [u8; 8]) -> CanFrame {
    if let Some(checksum) = received.checksum {
        checksum.seal(&mut data);
    }
    CanFrame::full(received.id, data)
}

/// Returns a cluster that has received the recording up to `until`.
fn played(tables: Tables, frames: &[(u64, CanFrame)], until: u64) -> Cluster {
    let mut cluster = Cluster::new(tables.vehicle);
    play(&mut cluster, frames, 0, until, |frame| frame, |_| {});
    cluster
}

fn play(
    cluster: &mut Cluster,
    frames: &[(u64, CanFrame)],
    from: u64,
    until: u64,
    change: impl Fn(CanFrame) -> CanFrame,
    mut sent: impl FnMut(CanFrame),
) {
    let mut frames = frames.iter().skip_while(|(at, _)| *at < from).peekable();
    for now in (from..until).step_by(TICK_MS as usize) {
        while let Some((at, frame)) = frames.next_if(|(at, _)| *at <= now) {
            cluster.receive(&change(*frame), Millis(*at));
        }
        cluster.tick(&Inputs::default(), Millis(now));
        while let Some(frame) = cluster.transmit(Millis(now)) {
            sent(frame);
        }
    }
}

/// Everything that an instrument gives out at the end of a run.
struct Seen {
    view: View,
    faults: Vec<(&'static str, Option<u16>)>,
    sound: Option<cluster::Sound>,
    sent: BTreeMap<CanId, [u8; 8]>,
}

impl Seen {
    fn after(
        mut cluster: Cluster,
        frames: &[(u64, CanFrame)],
        from: u64,
        change: impl Fn(CanFrame) -> CanFrame,
    ) -> Self {
        let mut sent = BTreeMap::new();
        let until = from + STANDS_MS;
        play(&mut cluster, frames, from, until, change, |frame| {
            sent.insert(frame.id, *frame.padded());
        });
        let now = Millis(until);
        let faults = cluster.active_faults(now).map(|fault| (fault.text.en, fault.code)).collect();
        let sound = cluster.chime(now).map(|chime| chime.sound);
        Self { view: cluster.view(now), faults, sound, sent }
    }

    /// Returns in what this differs from `plain`.
    fn beside(&self, plain: &Self) -> BTreeSet<String> {
        let mut faces = BTreeSet::new();
        let mut note = |differs: bool, face: &str| {
            if differs {
                faces.insert(face.to_owned());
            }
        };
        let (new, old) = (&self.view, &plain.view);
        note(self.faults != plain.faults || new.line != old.line, "fault");
        note(self.sound != plain.sound, "sound");
        note(self.sent != plain.sent, "sent to the bus");
        for &telltale in Telltale::ALL {
            let differs = new.telltales.is_lit(telltale) != old.telltales.is_lit(telltale);
            note(differs, &format!("telltale {}", telltale.key()));
        }
        note(new.journeys != old.journeys, "page trip_a");
        note(new.charging != old.charging || new.consumption_whkm != old.consumption_whkm, "page energy");
        let rest = |view: &View| View {
            line: None,
            unseen: None,
            says_unseen: false,
            below: None,
            says_below: false,
            alarm: None,
            severity: View::default().severity,
            telltales: View::default().telltales,
            is_power_limited: false,
            is_charge_low: false,
            journeys: View::default().journeys,
            charging: None,
            consumption_whkm: View::default().consumption_whkm,
            page: View::default().page,
            ..*view
        };
        note(rest(new) != rest(old), "page main");
        faces
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_shows_where_a_driver_would_look_for_it() {
        let citybus = Tables::named("citybus").unwrap();
        let faces = of(citybus, &crate::reference::sources(citybus)).unwrap();
        let seen = |value: Value| faces[&value].iter().map(String::as_str).collect::<Vec<_>>();
        assert!(seen(Value::VehicleSpeed).contains(&"page main"));
        assert!(seen(Value::VehicleReady).contains(&"telltale ready"));
        assert_eq!(seen(Value::HvacInside), ["page climate"]);
        let fault = seen(Value::SteeringState);
        assert!(
            ["fault", "page pumps", "telltale steering"].iter().all(|face| fault.contains(face)),
            "{fault:?}"
        );
    }

    #[test]
    fn a_value_without_face_and_reason_is_found() {
        let none = Faces::from([(Value::HvacInside, BTreeSet::new())]);
        let error = check("citybus", &none).unwrap_err().to_string();
        assert!(error.contains("`hvac.inside`"), "{error}");
        let both = Faces::from([(Value::VehicleSoc, BTreeSet::from(["page main".to_owned()]))]);
        assert!(check("jiulong", &both).is_err(), "a reason that is not true");
    }
}
