//! The car: what a person may change in it, beyond what every vehicle has.
//!
//! Names the common controls that this vehicle has, too, and holds its own: words, nodes, messages.

use crate::bus::links::{cut, lost};
use crate::control::Control;
use crate::{driver, vcu};

/// Common controls that not every vehicle has.
pub(super) const HAS: &[&str] = &[
    "driver.cruise",
    "charge.bounds_exchanged",
    "battery.negative_welded",
    "battery.negative_stuck",
    "battery.interlock",
    "battery.current_sensor",
];

/// Tables of this vehicle alone.
pub(super) const OWN: &[&[Control]] = &[driver::GEAR_WITH_PARK, vcu::RISING_LEVELS, LINKS];

/// Nodes that fall silent, messages that stop, counters that stand still.
const LINKS: &[Control] = &[
    cut!("vcu", Vcu, "整车控制器", "Vehicle controller"),
    cut!("inverter", Inverter, "电机控制器", "Motor controller"),
    cut!("bms", Bms, "电池管理系统", "Battery controller"),
    cut!("charger", Charger, "充电机", "Charger"),
    cut!("cluster", Cluster, "仪表", "Cluster"),
    lost!("VCUToBMS"),
    lost!("BMSA"),
    lost!("BMSB"),
    lost!("BMSC"),
    lost!("BMSD"),
    lost!("ChargerTx"),
    lost!("ChargerControl"),
    lost!("ChargerVoltageLimits"),
    lost!("ChargerCurrentLimits"),
    lost!("VCUToCluster"),
    lost!("VCUToMCU"),
];
