//! What every page is told a few times a second: time, settings, truths, the bus, the cluster's own words.
//!
//! Only reads the bench. The words of the message line are those of the row of its fault.

use crate::catalog;
use crate::pace::Pace;
use crate::recording::Length;
use crate::scenes::Story;
use crate::trace::BusUpdate;
use crate::wires::Wires;
use bench::chips::panel::BACKLIGHT_FULL;
use bench::rig::Rig;
use bench::time::Nanos;
use cluster::{Named, Telltale};
use protocol_core::Vehicle;
use protocol_core::link::ScreenLine;
use serde::Serialize;
use std::time::Duration;
use virtual_vehicle::Setting;

/// Changes of the tone that are told at once: more of them cannot be heard.
const TONES_MAX: usize = 32;

/// The message line, in words.
#[derive(Debug, Serialize)]
struct Line {
    /// Public name of the fault; empty = of a newer firmware.
    fault: &'static str,
    zh: &'static str,
    en: &'static str,
    code: Option<u16>,
    severity: u8,
    position: u8,
    count: u8,
}

/// A change of the buzzer's tone: milliseconds before now, Hz, duty from 0 to 1.
#[derive(Debug, Serialize)]
struct Tone(f64, u32, f64);

/// What a page is told.
#[derive(Debug, Serialize)]
pub(crate) struct State<'a> {
    kind: &'static str,
    bench: u64,
    /// Virtual seconds since power-on.
    seconds: f64,
    paused: bool,
    /// Wanted virtual seconds per second, 0 = as fast as possible.
    factor: f64,
    /// Virtual seconds per second of late.
    speed: f64,
    /// Virtual seconds that the engine makes of one second of its thread.
    capability: f64,
    /// Frames on the bus, received by the firmware, lost.
    counts: [u64; 3],
    /// Part of the time in which the bus was busy since the last update, 0 to 1.
    load: f64,
    /// Fault confinement of the cluster's controller by its word, and its error counters.
    controller: (&'static str, u16, u16),
    /// Back-light, 0 to 1.
    backlight: f64,
    tones: Vec<Tone>,
    settings: Vec<Setting>,
    truths: Vec<f64>,
    shown: Vec<(String, String)>,
    telltales: Vec<(&'static str, &'static str)>,
    line: Option<Line>,
    bus: BusUpdate,
    recording: Option<Length>,
    /// A recording that has ended and may be fetched: its number, how long it is.
    recorded: Option<(u64, Length)>,
    playing: Option<&'a Story>,
    /// Why the bench stopped, if it did.
    stopped: Option<&'a str>,
}

/// What was told last, where only the difference counts.
#[derive(Clone, Copy, Default)]
pub(crate) struct Told {
    toned: Nanos,
    at: Nanos,
    busy: Nanos,
}

/// What the session knows beside the rig.
pub(crate) struct Around<'a> {
    pub(crate) bench: u64,
    pub(crate) wall: Duration,
    pub(crate) wires: &'a Wires,
    pub(crate) recording: Option<Length>,
    pub(crate) recorded: Option<(u64, Length)>,
    pub(crate) playing: Option<&'a Story>,
    pub(crate) stopped: Option<&'a str>,
    pub(crate) bus: BusUpdate,
}

impl<'a> State<'a> {
    pub(crate) fn of(rig: &Rig, pace: &mut Pace, told: &mut Told, around: Around<'a>) -> Self {
        let now = rig.now();
        let board = rig.board();
        let (bus, controller) = (board.bus(), board.mcp2515().node());
        let counts = rig.counts();
        let busy = bus.stats().busy;
        let span = now.since(told.at).as_secs_f64();
        let load = if span > 0.0 { (busy.since(told.busy).as_secs_f64() / span).min(1.0) } else { 0.0 };
        let tones = tones(rig, told.toned);
        *told = Told { toned: now, at: now, busy };
        let errors = bus.counters(controller);
        let vehicle = rig.vehicle();
        let screen = rig.screen();
        Self {
            kind: "state",
            bench: around.bench,
            seconds: now.as_secs_f64(),
            paused: pace.is_paused(),
            factor: pace.factor(),
            speed: pace.measure(now, around.wall),
            capability: pace.capability(),
            counts: [counts.on_bus, counts.received, counts.lost],
            load,
            controller: (bus.state(controller).word(), errors.transmit, errors.receive),
            backlight: f64::from(board.panel().backlight()) / f64::from(BACKLIGHT_FULL),
            tones,
            settings: vehicle
                .into_iter()
                .flat_map(catalog::settings)
                .chain(around.wires.settings())
                .collect(),
            truths: vehicle
                .map(|vehicle| vehicle.readouts().iter().map(|readout| readout.value).collect())
                .unwrap_or_default(),
            shown: rig.shown_lines(),
            telltales: screen.map(|screen| telltales(screen.telltales)).unwrap_or_default(),
            line: screen.and_then(|screen| screen.line).map(|line| line_of(&line, rig.identified())),
            bus: around.bus,
            recording: around.recording,
            recorded: around.recorded,
            playing: around.playing,
            stopped: around.stopped,
        }
    }
}

/// Returns the changes of the tone behind `since`; without one, none.
fn tones(rig: &Rig, since: Nanos) -> Vec<Tone> {
    let changes = rig.board().buzzer();
    let new = changes.iter().rev().take_while(|change| change.at > since).take(TONES_MAX).count();
    changes[changes.len() - new..]
        .iter()
        .map(|change| {
            let before = rig.now().since(change.at).as_secs_f64() * 1e3;
            Tone(before, change.frequency_hz, f64::from(change.duty) / 65_536.0)
        })
        .collect()
}

fn telltales(lit: u32) -> Vec<(&'static str, &'static str)> {
    let telltales = Telltale::ALL.iter().enumerate().filter(|(index, _)| lit >> index & 1 != 0);
    telltales.map(|(_, telltale)| (telltale.key(), telltale.colour().key())).collect()
}

fn line_of(line: &ScreenLine, vehicle: &Vehicle) -> Line {
    let ScreenLine { fault, stage, code, severity, position, count } = *line;
    let named = Named::of_record(fault, stage, code);
    let (fault, code) = named.map_or(("", code), |named| (named.fault.key(), named.printed_code()));
    let (zh, en) = named.map_or(("其他提示", "Another message"), |named| {
        let text = named.text(vehicle);
        (text.zh, text.en)
    });
    Line { fault, zh, en, code, severity, position, count }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cluster::FaultId;
    use protocol_core::generated::citybus::VEHICLE;

    fn line(fault: u8, stage: u8, code: Option<u16>) -> Line {
        line_of(&ScreenLine { fault, stage, code, ..ScreenLine::default() }, &VEHICLE)
    }

    #[test]
    fn the_message_line_has_the_words_of_its_fault() {
        let level = line(FaultId::VehicleLevel.number(), 2, None);
        assert_eq!((level.fault, level.zh, level.code), ("vehicle_level", "系统三级故障", None));
        let code = line(FaultId::Battery.number(), 0, Some(105));
        assert_eq!((code.en, code.code), ("Battery too hot", Some(105)));
        assert_eq!(line(FaultId::BatteryAlarm.number(), 0, Some(7)).code, None, "no document prints a bit");
        assert_eq!((line(250, 0, None).fault, line(250, 0, None).en), ("", "Another message"));
    }

    #[test]
    fn lit_telltales_are_named_with_their_colour() {
        assert_eq!(telltales(1 << Telltale::Ready as u8), [("ready", "green")]);
    }
}
