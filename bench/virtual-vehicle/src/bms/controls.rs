//! What a person may change in the battery and at the plug.
//!
//! One row per control. Refuses to act: what a setting leads to is in the other modules.

use super::pack;
use crate::control::{Control, Group, Setting, Takes, flag, is_on};
use crate::world::World;

const VOLTS: Takes = Takes::Number { min: 0.0, max: 5.0, step: 0.01, unit: "V" };
const CELSIUS: Takes = Takes::Number { min: -40.0, max: 150.0, step: 1.0, unit: "°C" };
const CODE: Takes = Takes::Number { min: 0.0, max: 255.0, step: 1.0, unit: "" };

/// A switch: on or off, kept in one field.
macro_rules! switch {
    ($path:literal, $zh:literal, $en:literal, $group:ident, $optional:literal, $($field:tt)+) => {
        Control {
            path: $path,
            zh: $zh,
            en: $en,
            group: Group::$group,
            takes: Takes::Flag,
            free: false,
            optional: $optional,
            get: |world| flag(world.$($field)+),
            set: |world, setting| world.$($field)+ = is_on(setting),
        }
    };
}

/// A value that a person may force or leave to the vehicle.
macro_rules! forced {
    ($path:literal, $zh:literal, $en:literal, $group:ident, $optional:literal, $takes:expr, $($field:tt)+) => {
        Control {
            path: $path,
            zh: $zh,
            en: $en,
            group: Group::$group,
            takes: $takes,
            free: true,
            optional: $optional,
            get: |world| world.$($field)+,
            set: |world, setting| world.$($field)+ = setting,
        }
    };
}

/// A fault code of the charger.
macro_rules! charger_code {
    ($path:literal, $zh:literal, $en:literal, $index:literal) => {
        Control {
            path: $path,
            zh: $zh,
            en: $en,
            group: Group::Charging,
            takes: CODE,
            free: false,
            optional: true,
            get: |world| Some(f64::from(world.charger.faults[$index])),
            set: |world, setting| world.charger.faults[$index] = setting.unwrap_or_default() as u8,
        }
    };
}

fn set_soc(world: &mut World, setting: Setting) {
    pack::set_soc(world, setting.unwrap_or_default() / 100.0);
}

fn set_interval(world: &mut World, setting: Setting) {
    world.bms.charge_interval_days = setting.unwrap_or_default() as u32;
}

fn set_mains(world: &mut World, setting: Setting) {
    world.charger.mains_volts = setting.unwrap_or_default();
}

/// Every control of the battery and the plug, in the order of the page.
pub(crate) const CONTROLS: &[Control] = &[
    switch!("charge.plug", "充电插头", "Charge plug", Charging, false, charger.plugged),
    Control {
        path: "charge.mains",
        zh: "电网电压",
        en: "Mains voltage",
        group: Group::Charging,
        takes: Takes::Number { min: 0.0, max: 260.0, step: 1.0, unit: "V" },
        free: false,
        optional: false,
        get: |world| Some(world.charger.mains_volts),
        set: set_mains,
    },
    switch!("charge.pantograph", "受电弓", "Pantograph", Charging, true, charger.pantograph),
    switch!(
        "charge.charger_fault",
        "充电机故障",
        "Charger hardware fault",
        Charging,
        false,
        charger.hardware_fault
    ),
    switch!("charge.charger_hot", "充电机过温", "Charger too hot", Charging, false, charger.over_temperature),
    switch!("charge.reversed", "电池反接", "Battery reversed", Charging, false, charger.reversed),
    switch!(
        "charge.mismatched",
        "充电机与电池不匹配",
        "Charger for another battery",
        Charging,
        true,
        charger.mismatched
    ),
    charger_code!("charge.fault_code_1", "充电机故障码1", "Charger fault code 1", 0),
    charger_code!("charge.fault_code_2", "充电机故障码2", "Charger fault code 2", 1),
    charger_code!("charge.fault_code_3", "充电机故障码3", "Charger fault code 3", 2),
    switch!(
        "charge.bounds_exchanged",
        "告警保护值颠倒",
        "Warning and protection exchanged",
        Charging,
        true,
        bms.defects.bounds_exchanged
    ),
    forced!(
        "battery.socket",
        "充电座温度",
        "Charge socket",
        Charging,
        true,
        CELSIUS,
        bms.defects.socket_celsius
    ),
    Control {
        path: "battery.soc",
        zh: "电量",
        en: "State of charge",
        group: Group::Battery,
        takes: Takes::Number { min: 0.0, max: 100.0, step: 0.5, unit: "%" },
        free: false,
        optional: false,
        get: |world| Some(world.pack.soc * 100.0),
        set: set_soc,
    },
    forced!(
        "battery.highest_cell",
        "最高单体电压",
        "Highest cell",
        Battery,
        false,
        VOLTS,
        pack.highest_volts_override
    ),
    forced!(
        "battery.lowest_cell",
        "最低单体电压",
        "Lowest cell",
        Battery,
        false,
        VOLTS,
        pack.lowest_volts_override
    ),
    forced!("battery.hottest", "最高温度", "Hottest probe", Battery, false, CELSIUS, pack.hottest_override),
    forced!("battery.coldest", "最低温度", "Coldest probe", Battery, false, CELSIUS, pack.coldest_override),
    forced!(
        "battery.volts",
        "电池总电压",
        "Pack voltage",
        Battery,
        false,
        Takes::Number { min: 0.0, max: 1_000.0, step: 0.1, unit: "V" },
        pack.volts_override
    ),
    forced!(
        "battery.amps",
        "电池总电流",
        "Pack current",
        Battery,
        false,
        Takes::Number { min: -1_000.0, max: 1_000.0, step: 0.1, unit: "A" },
        pack.amps_override
    ),
    Control {
        path: "battery.charge_interval",
        zh: "外接充电间隔",
        en: "Days since charging",
        group: Group::Battery,
        takes: Takes::Number { min: 0.0, max: 254.0, step: 1.0, unit: "d" },
        free: false,
        optional: true,
        get: |world| Some(f64::from(world.bms.charge_interval_days)),
        set: set_interval,
    },
    switch!("battery.main_welded", "主正粘连", "Main contactor welded", Battery, false, bms.main.welded),
    switch!(
        "battery.main_stuck",
        "主正不闭合",
        "Main contactor stuck open",
        Battery,
        false,
        bms.main.stuck_open
    ),
    switch!(
        "battery.main_contactor_fault",
        "主正接触器故障",
        "Main contactor fault",
        Battery,
        true,
        bms.defects.main_contactor
    ),
    switch!(
        "battery.negative_welded",
        "主负粘连",
        "Negative contactor welded",
        Battery,
        true,
        bms.negative.welded
    ),
    switch!(
        "battery.negative_stuck",
        "主负不闭合",
        "Negative contactor stuck open",
        Battery,
        true,
        bms.negative.stuck_open
    ),
    switch!(
        "battery.precharge_stuck",
        "预充不闭合",
        "Precharge stuck open",
        Battery,
        false,
        bms.precharge.stuck_open
    ),
    switch!(
        "battery.charge_1_welded",
        "充电1粘连",
        "Charge 1, relay A welded",
        Battery,
        true,
        bms.charge_1[0].welded
    ),
    switch!(
        "battery.charge_1b_welded",
        "充电1B粘连",
        "Charge 1, relay B welded",
        Battery,
        true,
        bms.charge_1[1].welded
    ),
    switch!(
        "battery.charge_1_stuck",
        "充电1不闭合",
        "Charge 1, relay A stuck",
        Battery,
        true,
        bms.charge_1[0].stuck_open
    ),
    switch!(
        "battery.charge_1b_stuck",
        "充电1B不闭合",
        "Charge 1, relay B stuck",
        Battery,
        true,
        bms.charge_1[1].stuck_open
    ),
    switch!(
        "battery.charge_2_welded",
        "充电2粘连",
        "Charge 2, relay A welded",
        Battery,
        true,
        bms.charge_2[0].welded
    ),
    switch!(
        "battery.charge_2b_welded",
        "充电2B粘连",
        "Charge 2, relay B welded",
        Battery,
        true,
        bms.charge_2[1].welded
    ),
    switch!(
        "battery.heater_welded",
        "加热粘连",
        "Heater, relay A welded",
        Battery,
        true,
        bms.heater[0].welded
    ),
    switch!(
        "battery.heater_b_welded",
        "加热B粘连",
        "Heater, relay B welded",
        Battery,
        true,
        bms.heater[1].welded
    ),
    switch!("battery.interlock", "高压互锁断开", "Interlock open", Battery, true, bms.defects.interlock_open),
    switch!(
        "battery.current_sensor",
        "电流传感器故障",
        "Current sensor broken",
        Battery,
        true,
        bms.defects.current_sensor
    ),
    switch!(
        "battery.internal_bus",
        "BMS内部通讯故障",
        "Internal bus lost",
        Battery,
        false,
        bms.defects.internal_bus
    ),
    switch!("battery.negative_cut", "切断主负", "Main negative cut", Battery, true, bms.defects.negative_cut),
    Control {
        path: "battery.soc_error",
        zh: "电量计误差",
        en: "Charge counter off by",
        group: Group::Battery,
        takes: Takes::Number { min: -100.0, max: 100.0, step: 0.5, unit: "%" },
        free: false,
        optional: true,
        get: |world| Some(world.bms.defects.soc_error * 100.0),
        set: |world, setting| world.bms.defects.soc_error = setting.unwrap_or_default() / 100.0,
    },
    switch!("battery.smoke", "电池烟雾报警", "Battery smoke alarm", Battery, true, bms.defects.smoke),
    switch!(
        "battery.smoke_detector",
        "烟雾探测器故障",
        "Smoke detector broken",
        Battery,
        true,
        bms.defects.smoke_detector
    ),
];
