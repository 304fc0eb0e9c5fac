//! What a person reads off the vehicle: one row per truth, in reading order.
//!
//! Names are those of the cluster's model where the cluster shows the same thing. Refuses to know what a node says about
//! it on the bus: that may differ, and then the difference is the point.

use crate::Readout;
use crate::world::{Charge, Gear, World};
use protocol_core::states::{Contactor, Flag, Kind, Severity};

struct Row {
    path: &'static str,
    zh: &'static str,
    en: &'static str,
    unit: &'static str,
    digits: u8,
    /// What kind of state it is; `None` = a number.
    kind: Option<Kind>,
    value: fn(&World) -> f64,
}

const fn row(
    path: &'static str,
    [zh, en]: [&'static str; 2],
    (unit, digits): (&'static str, u8),
    value: fn(&World) -> f64,
) -> Row {
    Row { path, zh, en, unit, digits, kind: None, value }
}

/// A row whose value is the number of a state.
const fn state(path: &'static str, [zh, en]: [&'static str; 2], kind: Kind, value: fn(&World) -> f64) -> Row {
    Row { path, zh, en, unit: "", digits: 0, kind: Some(kind), value }
}

const NUMBER: (&str, u8) = ("", 0);
const CELSIUS: (&str, u8) = ("°C", 0);

const ROWS: &[Row] = &[
    row("vehicle.speed", ["车速", "Speed"], ("km/h", 1), |w| w.motion.kmh()),
    row("vehicle.distance", ["行驶距离", "Distance"], ("km", 2), |w| w.motion.metres / 1_000.0),
    row("vehicle.range", ["续驶里程", "Range"], ("km", 0), |w| w.vcu.range_km),
    state("vcu.ready", ["READY", "READY"], Flag::KIND, |w| yes(w.vcu.ready)),
    state("vcu.gear", ["挡位", "Gear engaged"], Gear::KIND, |w| {
        w.vcu.gear.map_or(NO_STATE, |gear| f64::from(gear.number()))
    }),
    row("motor.speed", ["电机转速", "Motor speed"], ("rpm", 0), |w| w.motor.rpm),
    row("motor.torque", ["电机转矩", "Motor torque"], ("Nm", 0), |w| w.motor.nm),
    row("motor.power", ["电机功率", "Motor power"], ("kW", 1), |w| w.motor.watts / 1_000.0),
    row("motor.temperature", ["电机温度", "Motor temperature"], CELSIUS, |w| w.motor.celsius),
    row("inverter.temperature", ["电机控制器温度", "Motor controller temperature"], CELSIUS, |w| {
        w.motor.inverter_celsius
    }),
    row("battery.soc", ["电量", "State of charge"], ("%", 1), |w| 100.0 * w.pack.soc),
    row("battery.voltage", ["总电压", "Pack voltage"], ("V", 1), |w| w.pack.volts),
    row("battery.current", ["总电流", "Pack current"], ("A", 1), |w| w.pack.amps),
    row("battery.power", ["电池功率", "Battery power"], ("kW", 1), |w| {
        w.pack.volts * w.pack.amps / 1_000.0
    }),
    row("battery.cell.max", ["单体最高电压", "Highest cell"], ("V", 3), |w| w.bms.cell_max.value),
    row("battery.cell.min", ["单体最低电压", "Lowest cell"], ("V", 3), |w| w.bms.cell_min.value),
    row("battery.temperature.max", ["电池最高温度", "Hottest probe"], CELSIUS, |w| w.bms.hot.value),
    row("battery.temperature.min", ["电池最低温度", "Coldest probe"], CELSIUS, |w| w.bms.cold.value),
    row("battery.charge_limit", ["允许充电电流", "Charge limit"], ("A", 0), |w| {
        w.bms.charge_limit_amps
    }),
    row("battery.discharge_limit", ["允许放电电流", "Discharge limit"], ("A", 0), |w| {
        w.bms.discharge_limit_amps
    }),
    state("battery.severity", ["电池故障等级", "Battery fault severity"], Severity::KIND, |w| {
        f64::from(w.bms.severity.number())
    }),
    row("battery.code", ["电池故障代码", "Battery fault code"], NUMBER, |w| f64::from(w.bms.code)),
    state("contactor.main", ["主接触器", "Main contactor"], Contactor::KIND, |w| {
        let state = if w.bms.main.closed { Contactor::Closed } else { Contactor::Open };
        f64::from(state.number())
    }),
    row("link.voltage", ["直流母线电压", "Link voltage"], ("V", 1), |w| w.motor.link_volts),
    state("hv_off_request", ["请求断高压", "HV-off request"], Flag::KIND, |w| yes(w.bms.hv_off_request)),
    state("vcu.hv_cutoff", ["已断高压", "HV cut off"], Flag::KIND, |w| yes(w.vcu.hv_cutoff)),
    state("vcu.limp", ["跛行", "Limp"], Flag::KIND, |w| yes(w.vcu.limp)),
    state("vcu.power_limited", ["限功率", "Power limited"], Flag::KIND, |w| yes(w.vcu.power_limited)),
    state("vcu.torque_limited", ["限转矩", "Torque limited"], Flag::KIND, |w| yes(w.vcu.torque_limited)),
    row("vcu.allowed_power", ["允许功率", "Power allowed"], ("kW", 1), |w| w.vcu.allowed_watts / 1_000.0),
    state("vcu.severity", ["整车故障等级", "Vehicle fault severity"], Severity::KIND, |w| {
        f64::from(w.vcu.severity.number())
    }),
    row("vcu.code", ["整车故障代码", "Vehicle fault code"], NUMBER, |w| f64::from(w.vcu.code)),
    state("vcu.shift_failed", ["换挡失败", "Shift refused"], Flag::KIND, |w| yes(w.vcu.shift_failed)),
    state("vcu.seat_cut", ["离座断扭矩", "Torque cut, seat empty"], Flag::KIND, |w| yes(w.vcu.seat_cut)),
    state("vcu.buzzer", ["蜂鸣器", "Buzzer"], Flag::KIND, |w| yes(w.vcu.buzzer)),
    state("charge.state", ["充电状态", "Charge state"], Charge::KIND, |w| {
        f64::from(w.bms.charge.number())
    }),
    row("charge.power", ["充电功率", "Charge power"], ("kW", 1), |w| {
        w.charger.volts * w.charger.amps / 1_000.0
    }),
    row("supply.volts", ["低压蓄电池", "Auxiliary battery"], ("V", 1), |w| w.supply.volts),
    row("dcdc.output", ["DC/DC 输出", "DC/DC output"], ("A", 0), |w| w.dcdc.output_amps),
    row("air.front", ["前气压", "Front air"], ("MPa", 2), |w| w.air.front_mpa),
    row("air.rear", ["后气压", "Rear air"], ("MPa", 2), |w| w.air.rear_mpa),
    row("steering.speed", ["助力泵转速", "Steering pump"], ("rpm", 0), |w| w.steering.rpm),
    row("compressor.speed", ["空压机转速", "Air compressor"], ("rpm", 0), |w| w.compressor.rpm),
    row("cabin.temperature", ["车内温度", "Cabin temperature"], CELSIUS, |w| w.hvac.cabin_celsius),
    row("hvac.fan", ["空调风机", "Air conditioning fan"], NUMBER, |w| f64::from(w.hvac.fan)),
    state("hvac.cooling", ["制冷", "Cooling"], Flag::KIND, |w| yes(w.hvac.cooling)),
    state("hvac.heating", ["制热", "Heating"], Flag::KIND, |w| yes(w.hvac.heating)),
    state("hvac.communication_alarm", ["空调通信告警", "Air conditioning lost"], Flag::KIND, |w| {
        yes(w.hvac.communication_alarm)
    }),
    row("insulation.positive", ["正极绝缘", "Insulation, positive"], ("kohm", 0), |w| {
        w.insulation.positive_kiloohm
    }),
    row("insulation.level", ["漏电等级", "Leakage level"], NUMBER, |w| f64::from(w.insulation.level)),
    row("driver.accelerator", ["加速踏板", "Accelerator"], ("%", 0), |w| 100.0 * w.driver.accelerator),
    row("driver.brake", ["制动踏板", "Brake"], ("%", 0), |w| 100.0 * w.driver.brake),
    row("meter.frames", ["仪表报文数", "Frames of the cluster"], NUMBER, |w| w.meter.frames as f64),
];

/// Number of no state: the vehicle itself does not know.
const NO_STATE: f64 = -1.0;

fn yes(is: bool) -> f64 {
    f64::from(u8::from(is))
}

/// Reads every row.
pub(crate) fn readouts(world: &World) -> Vec<Readout> {
    let read = |row: &Row| Readout {
        path: row.path,
        zh: row.zh,
        en: row.en,
        value: (row.value)(world),
        unit: row.unit,
        digits: row.digits,
        kind: row.kind,
    };
    ROWS.iter().map(read).collect()
}
