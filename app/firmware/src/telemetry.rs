//! From the state of the firmware to records of the PC link and to what the instrument takes in: conversions only.

use cluster::own::Restart;
use cluster::view::Line;
use cluster::{Cluster, Controller, Counters, View};
use pico::{Boot, Reset};
use protocol_core::link::{
    CHUNK, Chunk, Excerpt, Fault, Health, Record, ResetReason, Sample, Screen, ScreenLine, Trip, Trips,
};
use protocol_core::{Millis, Shown, Value, Vehicle};

use mcp2515_can::BusState;
use protocol_core::states::Confinement;

use crate::can_node::Status;

/// First 32 bits of the build's identity; whoever builds sets `CLUSTER_BUILD` to eight hexadecimal digits.
const BUILD: u32 = match option_env!("CLUSTER_BUILD") {
    Some(digits) => match u32::from_str_radix(digits, 16) {
        Ok(build) => build,
        Err(_) => panic!("CLUSTER_BUILD is not a hexadecimal number of up to eight digits"),
    },
    None => 0,
};

/// Returns the identity record; without a vehicle's name until one is identified.
pub fn hello(vehicle: &Vehicle) -> Record {
    Record::Hello { version: env!("CARGO_PKG_VERSION").into(), vehicle: vehicle.name.into(), build: BUILD }
}

/// The last words of the previous run, if it had any.
pub fn last_words(boot: &Boot) -> Option<Record> {
    boot.note.map(|note| Record::Panic { line: note.line, text: Excerpt::from(note.text()) })
}

/// What the tasks measure of themselves.
#[derive(Clone, Copy, Debug, Default)]
pub struct Measured {
    /// Pictures sent.
    pub draws: u32,
    /// Longest time from a view to the last pixel, in microseconds.
    pub max_draw_us: u32,
    /// Share of the last second that the CPU slept, in 0.1 %.
    pub idle_permille: u16,
}

/// Returns the fault confinement of the CAN controller; `None` = it does not answer.
fn confinement(can: &Status) -> Option<Confinement> {
    can.controller.map(|chip| match chip.state {
        BusState::Active => Confinement::ErrorActive,
        BusState::Warning => Confinement::Warning,
        BusState::Passive => Confinement::ErrorPassive,
        BusState::BusOff => Confinement::BusOff,
    })
}

/// How the CAN controller is, as the cluster wants it.
pub fn controller(can: Status) -> Controller {
    let chip = can.controller.unwrap_or_default();
    Controller {
        state: confinement(&can),
        transmit_errors: chip.transmit_errors,
        receive_errors: chip.receive_errors,
        sent: chip.sent,
        lost: chip.overruns.saturating_add(can.queue_overflows),
    }
}

/// Why the firmware started, if it was a fault of its own.
pub fn restart(boot: &Boot) -> Option<Restart> {
    match (&boot.note, boot.reset) {
        (Some(note), _) => Some(Restart::Panic(u16::try_from(note.line).ok())),
        (None, Reset::Watchdog) => Some(Restart::Watchdog),
        (None, Reset::Power | Reset::Pin | Reset::Panic) => None,
    }
}

/// Returns the health record: load, worst cases and counters of the firmware.
pub fn health(can: Status, counters: Counters, boot: &Boot, measured: Measured, now_ms: u64) -> Record {
    let chip = can.controller.unwrap_or_default();
    Record::Health(Health {
        uptime_ms: now_ms,
        frames_received: chip.received,
        frames_dropped_short: counters.too_short,
        frames_damaged: counters.damaged,
        frames_unknown: counters.unknown,
        overruns: chip.overruns,
        ring_overflows: can.queue_overflows,
        can_state: confinement(&can),
        tec: chip.transmit_errors,
        rec: chip.receive_errors,
        frames_sent: chip.sent,
        spi_errors: can.spi_errors.saturating_add(can.refusals.total()).saturating_add(chip.undrained),
        draws: measured.draws,
        max_draw_us: measured.max_draw_us,
        idle_permille: measured.idle_permille,
        resets: boot.resets,
        last_reset: match boot.reset {
            Reset::Power => ResetReason::Power,
            Reset::Pin => ResetReason::Pin,
            Reset::Watchdog => ResetReason::Watchdog,
            Reset::Panic => ResetReason::Panic,
        },
    })
}

/// The values from `first` on, as many as a record holds.
pub fn values(cluster: &Cluster, first: usize, now: Millis) -> Record {
    let items = Value::ALL.iter().skip(first).take(CHUNK);
    let items: Chunk = items.map(|&value| Sample::from(cluster.shown(value, now))).collect();
    Record::Values { first: first as u8, items }
}

/// What the screen shows.
pub fn screen(view: &View, now_ms: u64) -> Record {
    Record::Shown(Screen {
        time_ms: now_ms,
        speed_kmh: sample(view.speed_kmh),
        gear: view.gear.map_or(0, |gear| gear as u8),
        soc_percent: sample(view.soc_percent),
        pack_decivolts: sample(view.pack_decivolts),
        pack_deciamps: sample(view.pack_deciamps),
        motor_rpm: sample(view.motor_rpm),
        motor_celsius: sample(view.motor_celsius),
        inverter_celsius: sample(view.inverter_celsius),
        odometer_hectometres: view.odometer_hectometres,
        page: view.page.number(),
        hv_off_s: view.hv_off_s,
        limps: view.limp.is_some(),
        limp_deciamps: view.limp.and_then(|limp| limp.limit_deciamps),
        plug: view.charging.map(|charging| charging.plug as u8),
        telltales: view.telltales.bits(),
        line: view.line.map(line),
        unseen: view.unseen.map(line),
        below: view.below.map(line),
    })
}

fn line(line: Line) -> ScreenLine {
    ScreenLine {
        fault: line.named.fault.number(),
        stage: line.named.stage,
        code: line.named.code,
        severity: line.severity as u8,
        position: line.position,
        count: line.count,
    }
}

/// Trips, consumption and range.
pub fn trips(view: &View) -> Record {
    let trips = view.journeys.map(|journey| Trip {
        hectometres: journey.hectometres,
        average_whkm: journey.average_whkm,
        used_watthours: journey.used_watthours,
        regained_watthours: journey.regained_watthours,
    });
    Record::Trips(Trips {
        trips,
        consumption_whkm: sample(view.consumption_whkm),
        range_km: sample(view.range.map(|range| range.km)),
        range_is_estimated: view.range.value().is_some_and(|range| range.is_estimated),
    })
}

/// The active fault at `place`, and when it came; `None` = there are fewer.
pub fn active(cluster: &Cluster, place: usize, now: Millis) -> Option<(Record, Millis)> {
    let fault = cluster.active_faults(now).nth(place)?;
    let count = cluster.active_faults(now).count() as u8;
    let record = Fault {
        place: place as u8,
        fault: fault.named.fault.number(),
        stage: fault.named.stage,
        code: fault.named.code,
        severity: fault.severity as u8,
        first_ms: fault.first.0,
        times: fault.count,
    };
    Some((Record::Active { count, fault: Some(record) }, fault.first))
}

/// Nothing is active.
pub const ALL_CLEAR: Record = Record::Active { count: 0, fault: None };

/// The remembered fault at `place`, and when it came last; `None` = there are fewer.
pub fn remembered(cluster: &Cluster, place: usize) -> Option<(Record, Millis)> {
    let entry = cluster.history().nth(place)?;
    let fault = Fault {
        place: place as u8,
        fault: entry.fault.number(),
        stage: cluster.named(entry).stage,
        code: entry.code,
        severity: entry.severity as u8,
        first_ms: entry.first.0,
        times: entry.count,
    };
    let count = cluster.history().count() as u8;
    Some((Record::Remembered { count, fault, last_ms: entry.last.0 }, entry.last))
}

fn sample(shown: Shown<impl Into<i32>>) -> Sample {
    shown.map(Into::into).into()
}
