//! The vans: what a person may change in it, beyond what every vehicle has.
//!
//! Names the common controls that this vehicle has, too, and holds its own: words, nodes, messages.

use crate::bus::links::{cut, frozen, lost};
use crate::control::{Control, Word, word};
use crate::{drive, driver, vcu};

/// Common controls that not every vehicle has.
pub(super) const HAS: &[&str] = &[
    "driver.accelerator_fault",
    "charge.mismatched",
    "charge.fault_code_1",
    "charge.fault_code_2",
    "charge.fault_code_3",
    "battery.negative_welded",
    "battery.negative_stuck",
    "battery.negative_cut",
    "battery.soc_error",
    "battery.smoke",
    "battery.smoke_detector",
    "dcdc.fault_code",
    "compressor.fault_code",
    "air.mpa",
    "air.pressure_sensor_fault",
    "air.vacuum_sensor_fault",
];

/// Tables of this vehicle alone.
pub(super) const OWN: &[&[Control]] = &[driver::GEAR, vcu::FALLING_LEVELS, MOTOR, LINKS];

const MOTOR: &[Control] = &[drive::protection(PROTECTIONS)];

/// Protections of its motor controller, in the order of their bits.
const PROTECTIONS: &[Word] = &[
    word("none", "无", "None"),
    word("igbt_protection", "IGBT 保护", "IGBT"),
    word("drive_supply_undervoltage", "驱动电源欠压", "Gate supply too low"),
    word("bridge_shoot_through", "桥臂直通", "Bridge shoot-through"),
    word("igbt_over_temperature", "IGBT 过温", "IGBT too hot"),
    word("motor_over_temperature", "电机过温", "Motor too hot"),
    word("bus_overcurrent", "母线过流", "Link current too high"),
    word("phase_overcurrent", "相电流过流", "Phase current too high"),
    word("control_undervoltage", "控制电源欠压", "Control supply too low"),
    word("control_reversed", "控制电源反接", "Control supply reversed"),
    word("control_overvoltage", "控制电源过压", "Control supply too high"),
    word("dq_overcurrent", "DQ 电流过流", "DQ current too high"),
    word("bus_undervoltage", "母线欠压", "Link voltage too low"),
    word("bus_overvoltage", "母线过压", "Link voltage too high"),
    word("over_torque", "过转矩", "Torque too high"),
    word("overload", "过载", "Overload"),
    word("stall", "堵转", "Stalled"),
    word("driver_over_temperature", "控制器过温", "Controller too hot"),
    word("overspeed", "超速", "Motor too fast"),
    word("can_fault", "CAN 故障", "CAN"),
    word("back_emf", "反电动势", "Back EMF"),
    word("phase_loss", "缺相", "Phase lost"),
    word("resolver_fault", "旋变故障", "Resolver"),
    word("hardware_shutdown", "硬件封锁", "Hardware shutdown"),
];

/// Nodes that fall silent, messages that stop, counters that stand still.
const LINKS: &[Control] = &[
    cut!("vcu", Vcu, "整车控制器", "Vehicle controller"),
    cut!("bms", Bms, "电池管理系统", "Battery controller"),
    cut!("charger", Charger, "充电机", "Charger"),
    cut!("cluster", Cluster, "仪表", "Cluster"),
    frozen!("vcu", Vcu, "整车控制器", "Vehicle controller"),
    frozen!("bms", Bms, "电池管理系统", "Battery controller"),
    frozen!("charger", Charger, "充电机", "Charger"),
    lost!("VCU1"),
    lost!("VCU2"),
    lost!("VCU3"),
    lost!("VCU4"),
    lost!("VCU5"),
    lost!("BMSStatus"),
    lost!("CellVoltages1"),
    lost!("ModuleTemperatures1"),
    lost!("BMSFaults"),
    lost!("BMSExtremes"),
    lost!("BMSExtremePositions"),
    lost!("Charger"),
];
