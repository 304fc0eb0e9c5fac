//! What a person may do to the parts.

use crate::control::{Control, Group, Setting, Takes, Word, flag, is_on, word};
use crate::world::World;

/// Fault code with four bits on the bus.
const CODE: Takes = Takes::Number { min: 0.0, max: 15.0, step: 1.0, unit: "" };
const PARTS: Group = Group::Parts;

/// Faults of the air conditioning, in the order of its frame.
const HVAC_FAULTS: &[Word] = &[
    word("none", "无", "None"),
    word("return_sensor_open", "回风传感器断路", "Return air sensor open"),
    word("outside_sensor_open", "外温传感器断路", "Outside sensor open"),
    word("evaporator_1_sensor_open", "蒸发器 1 传感器断路", "Evaporator 1 sensor open"),
    word("evaporator_2_sensor_open", "蒸发器 2 传感器断路", "Evaporator 2 sensor open"),
    word("supply_overvoltage", "电源过压", "Supply too high"),
    word("supply_undervoltage", "电源欠压", "Supply too low"),
    word("inverter_fault", "变频器故障", "Inverter"),
    word("pressure_fault", "压力故障", "Pressure"),
];

fn get_hvac_fault(world: &World) -> Setting {
    Some(match world.hvac.faults {
        0 => 0.0,
        bits => f64::from(bits.trailing_zeros() + 1),
    })
}

fn set_hvac_fault(world: &mut World, setting: Setting) {
    world.hvac.faults = match setting.unwrap_or_default() as u32 {
        0 => 0,
        word => 1 << (word - 1).min(7),
    };
}

/// Converter, pumps, air, air conditioning, insulation.
pub(crate) const CONTROLS: &[Control] = &[
    Control::new(
        "dcdc.fault_code",
        ["DC/DC 故障代码", "DC/DC fault code"],
        PARTS,
        CODE,
        |world| Some(f64::from(world.dcdc.fault_code)),
        |world, setting| world.dcdc.fault_code = setting.unwrap_or_default() as u8,
    )
    .optional(),
    Control::new(
        "steering.fault_code",
        ["助力故障代码", "Steering fault code"],
        PARTS,
        CODE,
        |world| Some(f64::from(world.steering.fault_code)),
        |world, setting| world.steering.fault_code = setting.unwrap_or_default() as u8,
    )
    .optional(),
    Control::new(
        "compressor.fault_code",
        ["空压机故障代码", "Air compressor fault code"],
        PARTS,
        CODE,
        |world| Some(f64::from(world.compressor.fault_code)),
        |world, setting| world.compressor.fault_code = setting.unwrap_or_default() as u8,
    )
    .optional(),
    Control::new(
        "hvac.fault",
        ["空调故障", "Air conditioning fault"],
        PARTS,
        Takes::Choice(HVAC_FAULTS),
        get_hvac_fault,
        set_hvac_fault,
    )
    .optional(),
    Control::new(
        "hvac.setpoint",
        ["空调设定温度", "Air conditioning setpoint"],
        PARTS,
        Takes::Number { min: 16.0, max: 36.0, step: 1.0, unit: "°C" },
        |world| Some(world.hvac.setpoint_celsius),
        |world, setting| world.hvac.setpoint_celsius = setting.unwrap_or(24.0),
    ),
    Control::new(
        "hvac.cabin",
        ["车内温度", "Cabin temperature, set once"],
        PARTS,
        Takes::Number { min: -40.0, max: 70.0, step: 1.0, unit: "°C" },
        |world| Some(world.hvac.cabin_celsius),
        |world, setting| world.hvac.cabin_celsius = setting.unwrap_or(world.road.celsius),
    ),
    Control::new(
        "insulation.kiloohm",
        ["正极绝缘电阻", "Insulation of the positive side"],
        PARTS,
        Takes::Number { min: 0.0, max: 60_000.0, step: 1.0, unit: "kohm" },
        |world| world.insulation.kiloohm_override,
        |world, setting| world.insulation.kiloohm_override = setting,
    )
    .free(),
    Control::new(
        "insulation.fault_code",
        ["绝缘仪故障代码", "Insulation monitor fault code"],
        PARTS,
        Takes::Number { min: 0.0, max: 255.0, step: 1.0, unit: "" },
        |world| Some(f64::from(world.insulation.fault_code)),
        |world, setting| world.insulation.fault_code = setting.unwrap_or_default() as u8,
    )
    .optional(),
    Control::new(
        "supply.volts",
        ["低压蓄电池电压", "Auxiliary battery"],
        PARTS,
        Takes::Number { min: 0.0, max: 40.0, step: 0.1, unit: "V" },
        |world| world.supply.volts_override,
        |world, setting| world.supply.volts_override = setting,
    )
    .free(),
    Control::new(
        "air.mpa",
        ["制动气压", "Brake air, both reservoirs"],
        PARTS,
        Takes::Number { min: 0.0, max: 1.2, step: 0.01, unit: "MPa" },
        |world| world.air.mpa_override,
        |world, setting| world.air.mpa_override = setting,
    )
    .free()
    .optional(),
    Control::new(
        "air.pressure_sensor_fault",
        ["气压传感器故障", "Air pressure sensor broken"],
        PARTS,
        Takes::Flag,
        |world| flag(world.air.pressure_sensor_fault),
        |world, setting| world.air.pressure_sensor_fault = is_on(setting),
    )
    .optional(),
    Control::new(
        "air.vacuum_sensor_fault",
        ["真空度传感器故障", "Vacuum sensor broken"],
        PARTS,
        Takes::Flag,
        |world| flag(world.air.vacuum_sensor_fault),
        |world, setting| world.air.vacuum_sensor_fault = is_on(setting),
    )
    .optional(),
];
