//! The city bus: what each node takes out of the frames that reach it.
//!
//! By the generated codecs. Receivers as the pages print them; VCU7 is printed for the battery, too, which has no use for
//! it. What was last heard holds, unless a node has a rule for silence: motor controller and pumps follow nothing old.
//! Source: the bus document, BUS-R035 to R048, R065, R072, R076 to R082, R127 to R133, R154.

use crate::bus::truth::leak;
use crate::inbox::Inbox;
use crate::told::{BatteryCommand, ChargeOrder, ChargerReport, Hold, HvacOrder, MotorCommand, PumpCommand};
use crate::vehicle::{Cluster, Ears, Hears};
use crate::world::{Bms, Charge, Charger, ContactorBox, Heard, Hvac, Key, Meter, PartsHeard};
use protocol_core::frame::CanId;
use protocol_core::generated::citybus::{self, id};
use protocol_core::model::Severity;
use protocol_core::vehicle::Node;

/// Silence after which the motor controller gives no torque: ten cycles of VCU2 (V-4).
const MOTOR_COMMAND_MS: u64 = 200;
/// Silence after which a pump's command is no longer valid (BUS-R118).
const PUMP_COMMAND_MS: u64 = 1_000;
/// Messages of the battery that the vehicle controller acts on (V-1).
const BATTERY: &[CanId] = &[id::BMS1, id::BMS4, id::BMS5];

pub(super) const HEARS: Hears = Hears {
    messages: &[
        (
            Node::Vcu,
            &[
                id::BMS1,
                id::BMS4,
                id::BMS5,
                id::IPU1,
                id::IPU2,
                id::IPU3,
                id::AIR_PUMP,
                id::HVAC,
                id::INSULATION,
                id::METER1,
                id::METER2,
            ],
        ),
        (Node::Bms, &[id::VCU3, id::VCU7, id::CHARGER_TX]),
        (Node::Inverter, &[id::VCU1, id::VCU2]),
        (Node::Dcdc, &[id::VCU6]),
        (Node::Steering, &[id::VCU4]),
        (Node::Compressor, &[id::VCU8]),
        (Node::Hvac, &[id::VCU5]),
        (Node::Charger, &[id::CHARGER_RX]),
        (Node::Contactors, &[id::VCU10]),
    ],
    while_plugged: &[id::CHARGER_TX, id::CHARGER_RX],
    cluster: Cluster { messages: &[id::METER1, id::METER2], proof: &[id::METER1], take: cluster },
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

/// State of charge from counts of 0.2 %.
fn fifths(raw: i32) -> f64 {
    f64::from(raw) / 500.0
}

/// 1 is worst (BUS-R066, R147).
const fn level_down(raw: u8) -> Severity {
    match raw {
        1 => Severity::Stop,
        2 => Severity::Derate,
        3 => Severity::Warn,
        _ => Severity::None,
    }
}

/// A relay conducts: closed, or welded (BUS-44).
const fn conducts(raw: u8) -> bool {
    matches!(raw, 1 | 3)
}

fn vcu(ears: &Ears<'_>, heard: &mut Heard) {
    let inbox = ears.inbox;
    let battery = &mut heard.battery;
    if let Some(said) = inbox.last(id::BMS1).map(citybus::Bms1) {
        battery.volts = said.pack_voltage().map(tenths);
        battery.soc = said.soc().map(fifths);
        battery.severity = level_down(said.fault_level_raw());
        battery.hv_off_request = said.hv_open_request_raw() == 3;
        battery.main_closed = Some(conducts(said.main_relay_raw()));
        battery.charge_closed = conducts(said.charge_1_relay_raw()) || conducts(said.charge_2_relay_raw());
    }
    if let Some(said) = inbox.last(id::BMS4).map(citybus::Bms4) {
        battery.charge_limit_amps = said.max_charge_current().map(tenths);
        battery.discharge_limit_amps = said.max_discharge_current().map(tenths);
    }
    if let Some(said) = inbox.last(id::BMS5).map(citybus::Bms5) {
        battery.charge = Charge::from_number(said.charge_state_raw().into()).unwrap_or_default();
    }
    battery.code = inbox.fresh(id::BMS5).map(|data| u16::from(citybus::Bms5(data).fault_code_raw()));
    heard.battery_silence_ms = inbox.worst_silence_ms(BATTERY);
    heard.level_silence_ms = inbox.silence_ms(id::BMS1);
    motor(inbox, heard);
    let parts = &mut heard.parts;
    if let Some(said) = inbox.last(id::INSULATION).map(citybus::Insulation) {
        parts.leak = leak(said.leakage_level_raw());
    }
    if let Some(said) = inbox.last(id::AIR_PUMP).map(citybus::AirPump) {
        parts.compressor_code = said.fault_code_raw();
    }
    if let Some(data) = inbox.last(id::HVAC) {
        // All of its first byte.
        parts.hvac_fault = data[0] != 0;
    }
}

fn motor(inbox: &Inbox, heard: &mut Heard) {
    let motor = &mut heard.motor;
    if let Some(said) = inbox.last(id::IPU1).map(citybus::Ipu1) {
        motor.link_volts = said.bus_voltage().map(tenths);
        let bits = [
            said.bus_overcurrent_raw(),
            said.position_sensor_fault_raw(),
            said.bus_overvoltage_raw(),
            said.bus_undervoltage_raw(),
            said.motor_over_temperature_raw(),
            said.inverter_over_temperature_raw(),
            said.overspeed_raw(),
        ];
        motor.protections = bits.iter().rev().fold(0, |all, bit| all << 1 | u32::from(*bit));
    }
    if let Some(said) = inbox.last(id::IPU2).map(citybus::Ipu2) {
        motor.rpm = said.motor_speed().map_or(0.0, f64::from);
        motor.celsius = said.motor_temperature().map(f64::from);
        motor.inverter_celsius = said.controller_temperature().map(f64::from);
    }
    if let Some(said) = inbox.last(id::IPU3).map(citybus::Ipu3) {
        motor.fault_code = said.fault_code_raw();
    }
    heard.motor_silence_ms = inbox.silence_ms(id::IPU1);
}

fn cluster(inbox: &Inbox, meter: &mut Meter) {
    if let Some(said) = inbox.last(id::METER1).map(citybus::Meter1) {
        // Order as printed: LOCK, ON, ACC, START (BUS-94).
        meter.key =
            Some([Key::Lock, Key::On, Key::Accessory, Key::Start][usize::from(said.key_position_raw() & 3)]);
        meter.door_open =
            said.entry_door_raw() == 1 || said.middle_door_raw() == 1 || said.exit_door_raw() == 1;
        meter.parking_brake = said.handbrake_raw() == 1;
        // Not available is not "left".
        meter.seat_left = said.driver_left_seat() == Some(1);
    }
    if let Some(said) = inbox.last(id::METER2).map(citybus::Meter2) {
        // All ones: not available (BUS-97).
        let eighths = said.odometer_raw();
        meter.odometer_km = (eighths != u32::MAX).then(|| f64::from(eighths) / 8.0);
    }
}

fn bms(ears: &Ears<'_>, bms: &mut Bms) {
    let inbox = ears.inbox;
    if let Some(said) = inbox.last(id::VCU3).map(citybus::Vcu3) {
        bms.vcu = BatteryCommand {
            high_voltage: said.hv_command_raw() == 1,
            link_volts: said.mcu_input_voltage().map(tenths),
            charge_enable: said.charge_enable_raw() == 1,
        };
    }
    bms.vcu_silence_ms = inbox.silence_ms(id::VCU3);
    let said = inbox.last(id::CHARGER_TX).map(citybus::ChargerTx);
    bms.charger = ChargerReport {
        present: said.is_some(),
        stopped: said.is_some_and(|said| level_down(said.fault_level_raw()) == Severity::Stop),
    };
    bms.charger_silence_ms = inbox.silence_ms(id::CHARGER_TX);
}

fn inverter(ears: &Ears<'_>) -> Option<MotorCommand> {
    let said = citybus::Vcu2(ears.inbox.within(id::VCU2, MOTOR_COMMAND_MS)?);
    let torque = said.target_torque().map_or(0.0, tenths);
    Some(MotorCommand { enabled: said.ipu_enable_raw() == 1, hold: Hold::Torque(torque) })
}

fn parts([dcdc, steering, compressor]: [&Ears<'_>; 3], heard: &mut PartsHeard) {
    if let Some(said) = dcdc.inbox.last(id::VCU6).map(citybus::Vcu6) {
        match said.command_raw() {
            0xAA => heard.converter.run = true,
            0x55 => heard.converter.run = false,
            _ => {}
        }
        heard.converter.lowest_input = said.input_voltage_limit().map_or(0.0, tenths);
        heard.converter.start_volts = said.start_battery_voltage().map_or(0.0, f64::from);
    }
    let command =
        |run: u8, hertz: Option<i32>| PumpCommand { run: run == 1, hertz: hertz.map_or(0.0, f64::from) };
    heard.steering = steering
        .inbox
        .within(id::VCU4, PUMP_COMMAND_MS)
        .map(citybus::Vcu4)
        .map(|said| command(said.run_raw(), said.frequency()));
    heard.compressor = compressor
        .inbox
        .within(id::VCU8, PUMP_COMMAND_MS)
        .map(citybus::Vcu4)
        .map(|said| command(said.run_raw(), said.frequency()));
}

fn hvac(ears: &Ears<'_>, hvac: &mut Hvac) {
    if let Some(said) = ears.inbox.last(id::VCU5).map(citybus::Vcu5) {
        hvac.heard = HvacOrder {
            permit: said.start_permit_raw() == 1,
            derate: said.derate_raw() == 1,
            reset: said.reset_raw() == 1,
            supply_volts: said.aux_battery_voltage().map_or(0.0, f64::from),
            soc: said.soc().map(fifths),
        };
    }
    hvac.silence_ms = ears.inbox.silence_ms(id::VCU5);
}

fn charger(ears: &Ears<'_>, charger: &mut Charger) {
    let said = ears.inbox.last(id::CHARGER_RX).map(citybus::ChargerRx);
    charger.silence_ms = ears.inbox.silence_ms(id::CHARGER_RX);
    charger.heard = match said {
        _ if !charger.plugged => ears.unprinted.charge_order.word.unwrap_or_default(),
        None => ChargeOrder::default(),
        Some(said) => ChargeOrder {
            enabled: said.enable_raw() == 1,
            amps: said.max_current().map_or(0.0, tenths),
            volts: said.max_voltage().map_or(0.0, tenths),
            bounds: None,
        },
    };
}

fn contactor_box(ears: &Ears<'_>, heard: &mut ContactorBox) {
    if let Some(said) = ears.inbox.last(id::VCU10).map(citybus::Vcu10) {
        *heard = ContactorBox {
            motor: said.positive_contactor_raw() == 1,
            precharge: said.positive_precharge_raw() == 1,
            accessory: said.accessory_raw() == 1,
            accessory_precharge: said.accessory_precharge_raw() == 1,
            defrost: said.defrost_raw() == 1,
        };
    }
}
