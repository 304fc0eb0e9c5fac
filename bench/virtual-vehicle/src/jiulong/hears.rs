//! The vans: what each node takes out of the frames that reach it.
//!
//! By the generated codecs. The document is the instrument's part of the protocol: what is not in it comes unprinted.
//! Source: the jiulong document, JL-R010, R018, R019, R027 to R031.

use crate::inbox::Inbox;
use crate::told::{ChargerReport, MotorCommand};
use crate::vehicle::{Cluster, Ears, Hears};
use crate::world::{Bms, Charger, ContactorBox, Heard, Hvac, Meter, PartsHeard};
use protocol_core::generated::jiulong::{self, id};
use protocol_core::model::Severity;
use protocol_core::vehicle::Node;

pub(super) const HEARS: Hears = Hears {
    messages: &[
        (Node::Vcu, &[id::BMS_STATUS, id::METER1, id::METER2, id::METER3]),
        (Node::Bms, &[id::CHARGER, id::METER3]),
    ],
    while_plugged: &[id::CHARGER],
    cluster: Cluster { messages: &[id::METER1, id::METER2, id::METER3], proof: &[], take: cluster },
    vcu,
    bms,
    inverter,
    parts,
    hvac,
    charger,
    contactor_box,
};

/// One count of the upper part of the odometer, in km (JL-05).
const HIGH_PART_KM: f64 = 65_536.0;

/// 1 is worst (JL-R010, R019, R030).
const fn level(raw: u8) -> Severity {
    match raw {
        1 => Severity::Stop,
        2 => Severity::Derate,
        3 => Severity::Warn,
        _ => Severity::None,
    }
}

fn vcu(ears: &Ears<'_>, heard: &mut Heard) {
    let Ears { inbox, unprinted } = ears;
    if let Some(told) = &unprinted.battery.word {
        let battery = &mut heard.battery;
        battery.charge_limit_amps = told.charge_limit_amps;
        battery.discharge_limit_amps = told.discharge_limit_amps;
        battery.main_closed = told.main_closed;
        (battery.charge, battery.limp) = (told.charge, told.limp);
    }
    if let Some(said) = inbox.last(id::BMS_STATUS).map(jiulong::BmsStatus) {
        let battery = &mut heard.battery;
        battery.volts = said.pack_voltage().map(|raw| f64::from(raw) / 10.0);
        battery.soc = said.soc().map(|raw| f64::from(raw) / 500.0);
        battery.severity = level(said.battery_fault_level_raw());
        heard.parts.leak = level(said.insulation_fault_level_raw());
    }
    heard.battery_silence_ms = inbox.silence_ms(id::BMS_STATUS);
    heard.level_silence_ms = heard.battery_silence_ms;
    if let Some(told) = unprinted.motor.word {
        heard.motor = told;
    }
    heard.motor_silence_ms = unprinted.motor.silence_ms;
    if let Some(told) = unprinted.parts.word {
        heard.parts = crate::told::PartsReport { leak: heard.parts.leak, ..told };
    }
}

fn cluster(inbox: &Inbox, meter: &mut Meter) {
    if let Some(said) = inbox.last(id::METER1).map(jiulong::Meter1) {
        let high = f64::from(said.odometer_high_raw()) * HIGH_PART_KM;
        meter.odometer_km = Some(high + f64::from(said.odometer_low_raw()));
    }
    // Meter3 is Meter2 once more, for the battery: the two say the same.
    let last = inbox.fresh(id::METER3).or(inbox.last(id::METER2)).or(inbox.last(id::METER3));
    if let Some(said) = last.map(jiulong::Meter2) {
        meter.upgrade_forbidden = Some(said.upgrade_forbidden_raw() == 1);
    }
}

fn bms(ears: &Ears<'_>, bms: &mut Bms) {
    let Ears { inbox, unprinted } = ears;
    if let Some(told) = unprinted.battery_command.word {
        bms.vcu = told;
    }
    bms.vcu_silence_ms = unprinted.battery_command.silence_ms;
    let said = inbox.last(id::CHARGER).map(jiulong::Charger);
    bms.charger = ChargerReport {
        present: said.is_some(),
        stopped: said.is_some_and(|said| level(said.fault_level_raw()) == Severity::Stop),
    };
    bms.charger_silence_ms = inbox.silence_ms(id::CHARGER);
}

fn inverter(ears: &Ears<'_>) -> Option<MotorCommand> {
    ears.unprinted.motor_command.word
}

fn parts([dcdc, steering, compressor]: [&Ears<'_>; 3], heard: &mut PartsHeard) {
    heard.converter = dcdc.unprinted.converter.word.unwrap_or_default();
    heard.steering = steering.unprinted.steering.word;
    heard.compressor = compressor.unprinted.compressor.word;
}

fn hvac(ears: &Ears<'_>, hvac: &mut Hvac) {
    hvac.heard = ears.unprinted.hvac.word.unwrap_or_default();
    hvac.silence_ms = ears.unprinted.hvac.silence_ms;
}

fn charger(ears: &Ears<'_>, charger: &mut Charger) {
    charger.heard = ears.unprinted.charge_order.word.unwrap_or_default();
    charger.silence_ms = ears.unprinted.charge_order.silence_ms;
}

/// The vans have none that listens.
fn contactor_box(_: &Ears<'_>, _: &mut ContactorBox) {}
