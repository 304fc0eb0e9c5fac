//! The car: what each node takes out of the frames that reach it.
//!
//! By the generated codecs. No message of the motor is printed, and none to the parts: those come unprinted. The main
//! contactor closes on 0xAA alone (C5-R001).
//! Source: the C5EV document, C5-R001, R003 to R011, R015.

use super::faults;
use crate::inbox::Inbox;
use crate::told::{ChargeOrder, ChargerBounds, ChargerReport, Hold, MotorCommand};
use crate::vehicle::{Cluster, Ears, Hears};
use crate::world::{Bms, Charge, Charger, ContactorBox, Heard, Hvac, Meter, PartsHeard};
use protocol_core::frame::CanId;
use protocol_core::generated::c5ev::{self, id};
use protocol_core::model::Severity;
use protocol_core::vehicle::Node;

/// Silence after which the motor controller gives no torque (V-4).
const MOTOR_COMMAND_MS: u64 = 200;
/// Messages of the battery that the vehicle controller acts on (V-1).
const BATTERY: &[CanId] = &[id::BMSA, id::BMSB, id::BMSC, id::BMSD];

pub(super) const HEARS: Hears = Hears {
    messages: &[
        (Node::Vcu, BATTERY),
        (Node::Bms, &[id::VCU_TO_BMS, id::CHARGER_TX]),
        (Node::Inverter, &[id::VCU_TO_MCU]),
        (Node::Charger, &[id::CHARGER_CONTROL, id::CHARGER_VOLTAGE_LIMITS, id::CHARGER_CURRENT_LIMITS]),
    ],
    while_plugged: &[
        id::CHARGER_TX,
        id::CHARGER_CONTROL,
        id::CHARGER_VOLTAGE_LIMITS,
        id::CHARGER_CURRENT_LIMITS,
    ],
    cluster: Cluster { messages: &[], proof: &[], take: cluster },
    vcu,
    bms,
    inverter,
    parts,
    hvac,
    charger,
    contactor_box,
};

fn tenths(raw: i32) -> f64 {
    f64::from(raw) / 10.0
}

fn vcu(ears: &Ears<'_>, heard: &mut Heard) {
    let Ears { inbox, unprinted } = ears;
    let battery = &mut heard.battery;
    if let Some(said) = inbox.last(id::BMSA).map(c5ev::Bmsa) {
        battery.soc = said.soc().map(|raw| f64::from(raw) / 500.0);
        battery.discharge_limit_amps = said.max_discharge_current().map(tenths);
        // Negative on the bus (C5-13).
        battery.charge_limit_amps = said.max_charge_current().map(|raw| -tenths(raw));
    }
    if let Some(said) = inbox.last(id::BMSB).map(c5ev::Bmsb) {
        battery.volts = said.pack_voltage().map(tenths);
    }
    if let Some(said) = inbox.last(id::BMSC).map(c5ev::Bmsc) {
        battery.main_closed = Some(said.positive_contactor_raw() == 1 && said.negative_contactor_raw() == 1);
        battery.hv_off_request = said.positive_open_request_raw() == 1;
        battery.charge = if said.charging_raw() == 1 { Charge::Charging } else { Charge::Idle };
    }
    if let Some(data) = inbox.last(id::BMSD) {
        battery.severity = severity(&data);
        heard.parts.leak = match (c5ev::Bmsd(data).insulation_1_raw(), c5ev::Bmsd(data).insulation_2_raw()) {
            (_, 1) => Severity::Stop,
            (1, _) => Severity::Derate,
            _ => Severity::None,
        };
    }
    heard.battery_silence_ms = inbox.worst_silence_ms(BATTERY);
    heard.level_silence_ms = inbox.silence_ms(id::BMSD);
    if let Some(told) = unprinted.motor.word {
        heard.motor = told;
    }
    heard.motor_silence_ms = unprinted.motor.silence_ms;
    if let Some(told) = unprinted.parts.word {
        heard.parts = crate::told::PartsReport { leak: heard.parts.leak, ..told };
    }
}

/// No level is sent: the worst of the stages whose bits are set (C5-15).
fn severity(data: &[u8; 8]) -> Severity {
    let is_set =
        |place: u8| data.get(usize::from(place / 8)).is_some_and(|byte| byte >> (place % 8) & 1 == 1);
    faults::ROWS.iter().filter(|row| is_set(row.code)).map(|row| row.severity).max().unwrap_or_default()
}

/// The car's cluster sends nothing.
fn cluster(_: &Inbox, _: &mut Meter) {}

fn bms(ears: &Ears<'_>, bms: &mut Bms) {
    let inbox = ears.inbox;
    match inbox.last(id::VCU_TO_BMS).map(|data| c5ev::VcuToBms(data).relay_command_raw()) {
        Some(0xAA) => bms.vcu.high_voltage = true,
        Some(0x55) => bms.vcu.high_voltage = false,
        // Any other value is invalid: the last one holds.
        Some(_) | None => {}
    }
    bms.vcu_silence_ms = inbox.silence_ms(id::VCU_TO_BMS);
    let said = inbox.last(id::CHARGER_TX).map(c5ev::ChargerTx);
    let stopped = |said: c5ev::ChargerTx| {
        let faults = [
            said.hardware_fault_raw(),
            said.input_voltage_fault_raw(),
            said.can_timeout_raw(),
            said.output_reversed_raw(),
            said.output_short_raw(),
            said.overcurrent_protection_raw(),
            said.undervoltage_protection_raw(),
            said.overvoltage_protection_raw(),
            said.overcurrent_data_error_raw(),
            said.undervoltage_data_error_raw(),
            said.overvoltage_data_error_raw(),
        ];
        faults.contains(&1)
    };
    bms.charger = ChargerReport { present: said.is_some(), stopped: said.is_some_and(stopped) };
    bms.charger_silence_ms = inbox.silence_ms(id::CHARGER_TX);
}

fn inverter(ears: &Ears<'_>) -> Option<MotorCommand> {
    let said = c5ev::VcuToMcu(ears.inbox.within(id::VCU_TO_MCU, MOTOR_COMMAND_MS)?);
    let forwards = match said.direction_raw() {
        2 => 1.0,
        1 => -1.0,
        _ => 0.0,
    };
    // Braking is torque against the direction.
    let drives = if said.work_mode_raw() == 2 { -1.0 } else { 1.0 };
    let hold = match said.control_mode_raw() {
        2 => Hold::Speed(forwards * said.speed().map_or(0.0, f64::from)),
        _ => Hold::Torque(forwards * drives * said.torque().map_or(0.0, f64::from)),
    };
    Some(MotorCommand { enabled: forwards != 0.0, hold })
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
    let inbox = ears.inbox;
    let control = inbox.last(id::CHARGER_CONTROL).map(c5ev::ChargerControl);
    let volts = inbox.last(id::CHARGER_VOLTAGE_LIMITS).map(c5ev::ChargerVoltageLimits);
    let amps = inbox.last(id::CHARGER_CURRENT_LIMITS).map(c5ev::ChargerCurrentLimits);
    charger.silence_ms = inbox.silence_ms(id::CHARGER_CONTROL);
    let tenths = |raw: Option<i32>| raw.map_or(0.0, tenths);
    charger.heard = ChargeOrder {
        // 0 charges (C5-R011), but only in a frame that has come.
        enabled: control.is_some_and(|said| said.charge_inhibit_raw() == 0),
        amps: tenths(control.and_then(|said| said.max_current())),
        volts: tenths(control.and_then(|said| said.max_voltage())),
        bounds: volts.zip(amps).map(|(volts, amps)| ChargerBounds {
            over_volts_warning: tenths(volts.overvoltage_warning()),
            over_volts_protection: tenths(volts.overvoltage_protection()),
            under_volts_warning: tenths(volts.undervoltage_warning()),
            under_volts_protection: tenths(volts.undervoltage_protection()),
            over_amps_warning: tenths(amps.overcurrent_warning()),
            over_amps_protection: tenths(amps.overcurrent_protection()),
        }),
    };
}

/// The car has none that listens.
fn contactor_box(_: &Ears<'_>, _: &mut ContactorBox) {}
