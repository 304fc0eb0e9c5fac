//! The city bus: what a person may change in it, beyond what every vehicle has.
//!
//! Names the common controls that this vehicle has, too, and holds its own: words, nodes, messages.

use crate::bus::links::{cut, frozen, lost};
use crate::control::{Control, Word, word};
use crate::{drive, driver, vcu};

/// Common controls that not every vehicle has.
pub(super) const HAS: &[&str] = &[
    "driver.digital_brake",
    "vcu.dcdc_input_limit",
    "vcu.dcdc_start_volts",
    "motor.own_bus",
    "charge.pantograph",
    "charge.fault_code_1",
    "charge.fault_code_2",
    "charge.fault_code_3",
    "battery.socket",
    "battery.charge_interval",
    "battery.main_contactor_fault",
    "battery.charge_1_welded",
    "battery.charge_1b_welded",
    "battery.charge_1_stuck",
    "battery.charge_1b_stuck",
    "battery.charge_2_welded",
    "battery.charge_2b_welded",
    "battery.heater_welded",
    "battery.heater_b_welded",
    "battery.interlock",
    "battery.current_sensor",
    "dcdc.fault_code",
    "steering.fault_code",
    "compressor.fault_code",
    "hvac.fault",
    "insulation.fault_code",
    "air.mpa",
];

/// Tables of this vehicle alone.
pub(super) const OWN: &[&[Control]] = &[driver::GEAR, vcu::RISING_LEVELS, MOTOR, LINKS];

const MOTOR: &[Control] = &[drive::protection(PROTECTIONS)];

/// Protections of its motor controller, in the order of their bits.
const PROTECTIONS: &[Word] = &[
    word("none", "无", "None"),
    word("bus_overcurrent", "母线过流", "Link current too high"),
    word("position_sensor_fault", "位置传感器故障", "Position sensor"),
    word("bus_overvoltage", "母线过压", "Link voltage too high"),
    word("bus_undervoltage", "母线欠压", "Link voltage too low"),
    word("motor_over_temperature", "电机过温", "Motor too hot"),
    word("inverter_over_temperature", "控制器过温", "Controller too hot"),
    word("overspeed", "超速", "Motor too fast"),
];

/// Nodes that fall silent, messages that stop, counters that stand still.
const LINKS: &[Control] = &[
    cut!("vcu", Vcu, "整车控制器", "Vehicle controller"),
    cut!("inverter", Inverter, "电机控制器", "Motor controller"),
    cut!("bms", Bms, "电池管理系统", "Battery controller"),
    cut!("dcdc", Dcdc, "DC/DC", "DC/DC"),
    cut!("steering", Steering, "转向助力", "Steering pump"),
    cut!("compressor", Compressor, "打气泵", "Air compressor"),
    cut!("hvac", Hvac, "电空调", "Air conditioning"),
    cut!("insulation", Insulation, "绝缘检测仪", "Insulation monitor"),
    cut!("charger", Charger, "充电机", "Charger"),
    cut!("contactors", Contactors, "四合一", "Contactor box"),
    cut!("cluster", Cluster, "仪表", "Cluster"),
    frozen!("vcu", Vcu, "整车控制器", "Vehicle controller"),
    frozen!("inverter", Inverter, "电机控制器", "Motor controller"),
    frozen!("bms", Bms, "电池管理系统", "Battery controller"),
    frozen!("dcdc", Dcdc, "DC/DC", "DC/DC"),
    frozen!("steering", Steering, "转向助力", "Steering pump"),
    frozen!("compressor", Compressor, "打气泵", "Air compressor"),
    frozen!("hvac", Hvac, "电空调", "Air conditioning"),
    frozen!("insulation", Insulation, "绝缘检测仪", "Insulation monitor"),
    frozen!("charger", Charger, "充电机", "Charger"),
    lost!("VCU1"),
    lost!("VCU2"),
    lost!("VCU3"),
    lost!("VCU4"),
    lost!("VCU5"),
    lost!("VCU6"),
    lost!("VCU7"),
    lost!("VCU8"),
    lost!("VCU9"),
    lost!("VCU10"),
    lost!("IPU1"),
    lost!("IPU2"),
    lost!("IPU3"),
    lost!("BMS1"),
    lost!("BMS2"),
    lost!("BMS4"),
    lost!("BMS5"),
    lost!("BMS6"),
    lost!("BMS7"),
    lost!("BMS8"),
    lost!("BMS9"),
    lost!("BMS10"),
    lost!("BMS11"),
    lost!("BMS12"),
    lost!("SteeringPump"),
    lost!("LowVoltageSteering"),
    lost!("DCDC"),
    lost!("AirPump"),
    lost!("HVAC"),
    lost!("Insulation"),
    lost!("ChargerTx"),
    lost!("ChargerRx"),
    lost!("PEU"),
];
