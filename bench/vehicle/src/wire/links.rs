//! Nodes that fall silent, messages that stop, counters that stand still: settings of the group Links.
//!
//! One row per node and per message. Refuses to know what silence leads to: that is each node's rule.

use crate::Kind::{C5ev, Citybus, Jiulong};
use crate::control::{Control, Group, Setting, Takes};
use crate::world::World;
use protocol_core::vehicle::Node;

fn is_on(setting: Setting) -> bool {
    setting == Some(1.0)
}

fn flag(on: bool) -> Setting {
    Some(f64::from(u8::from(on)))
}

fn lose(world: &mut World, message: &'static str, lost: bool) {
    world.links.lost.retain(|name| *name != message);
    if lost {
        world.links.lost.push(message);
    }
}

macro_rules! row {
    ($path:expr, $zh:expr, $en:expr, $on:expr, $get:expr, $set:expr) => {
        Control {
            path: $path,
            zh: $zh,
            en: $en,
            group: Group::Links,
            takes: Takes::Flag,
            free: false,
            on: $on,
            get: $get,
            set: $set,
        }
    };
}

/// A node that neither sends nor hears.
macro_rules! cut {
    ($path:literal, $node:ident, $zh:literal, $en:literal, $on:expr) => {
        row!(
            concat!("link.", $path),
            concat!($zh, "断开"),
            concat!($en, " cut off"),
            $on,
            |world| flag(world.links.cut[Node::$node as usize]),
            |world, setting| world.links.cut[Node::$node as usize] = is_on(setting)
        )
    };
}

/// A node whose life counters stand still.
macro_rules! frozen {
    ($path:literal, $node:ident, $zh:literal, $en:literal, $on:expr) => {
        row!(
            concat!("frozen.", $path),
            concat!($zh, "心跳停止"),
            concat!($en, " life stands still"),
            $on,
            |world| flag(world.links.frozen[Node::$node as usize]),
            |world, setting| world.links.frozen[Node::$node as usize] = is_on(setting)
        )
    };
}

/// A message that is no longer sent.
macro_rules! lost {
    ($message:literal, $on:expr) => {
        row!(
            concat!("lost.", $message),
            concat!($message, " 丢失"),
            concat!($message, " lost"),
            $on,
            |world| flag(world.links.lost.contains(&$message)),
            |world, setting| lose(world, $message, is_on(setting))
        )
    };
}

pub(crate) const CONTROLS: &[Control] = &[
    cut!("vcu", Vcu, "整车控制器", "Vehicle controller", &[Citybus, Jiulong, C5ev]),
    cut!("inverter", Inverter, "电机控制器", "Motor controller", &[Citybus, C5ev]),
    cut!("bms", Bms, "电池管理系统", "Battery controller", &[Citybus, Jiulong, C5ev]),
    cut!("dcdc", Dcdc, "DC/DC", "DC/DC", &[Citybus]),
    cut!("steering", Steering, "转向助力", "Steering pump", &[Citybus]),
    cut!("compressor", Compressor, "打气泵", "Air compressor", &[Citybus]),
    cut!("hvac", Hvac, "电空调", "Air conditioning", &[Citybus]),
    cut!("insulation", Insulation, "绝缘检测仪", "Insulation monitor", &[Citybus]),
    cut!("charger", Charger, "充电机", "Charger", &[Citybus, Jiulong, C5ev]),
    cut!("contactors", Contactors, "四合一", "Contactor box", &[Citybus]),
    cut!("cluster", Cluster, "仪表", "Cluster", &[Citybus, Jiulong, C5ev]),
    frozen!("vcu", Vcu, "整车控制器", "Vehicle controller", &[Citybus, Jiulong]),
    frozen!("inverter", Inverter, "电机控制器", "Motor controller", &[Citybus]),
    frozen!("bms", Bms, "电池管理系统", "Battery controller", &[Citybus, Jiulong]),
    frozen!("dcdc", Dcdc, "DC/DC", "DC/DC", &[Citybus]),
    frozen!("steering", Steering, "转向助力", "Steering pump", &[Citybus]),
    frozen!("compressor", Compressor, "打气泵", "Air compressor", &[Citybus]),
    frozen!("hvac", Hvac, "电空调", "Air conditioning", &[Citybus]),
    frozen!("insulation", Insulation, "绝缘检测仪", "Insulation monitor", &[Citybus]),
    frozen!("charger", Charger, "充电机", "Charger", &[Citybus, Jiulong]),
    lost!("VCU1", &[Citybus, Jiulong]),
    lost!("VCU2", &[Citybus, Jiulong]),
    lost!("VCU3", &[Citybus, Jiulong]),
    lost!("VCU4", &[Citybus, Jiulong]),
    lost!("VCU5", &[Citybus, Jiulong]),
    lost!("VCU6", &[Citybus]),
    lost!("VCU7", &[Citybus]),
    lost!("VCU8", &[Citybus]),
    lost!("IPU1", &[Citybus]),
    lost!("IPU2", &[Citybus]),
    lost!("IPU3", &[Citybus]),
    lost!("BMS1", &[Citybus]),
    lost!("BMS2", &[Citybus]),
    lost!("BMS4", &[Citybus]),
    lost!("BMS5", &[Citybus]),
    lost!("ChargerTx", &[Citybus, C5ev]),
    lost!("ChargerRx", &[Citybus]),
    lost!("BMSStatus", &[Jiulong]),
    lost!("BMSFaults", &[Jiulong]),
    lost!("BMSExtremes", &[Jiulong]),
    lost!("CellVoltages1", &[Jiulong]),
    lost!("Charger", &[Jiulong]),
    lost!("VCUToBMS", &[C5ev]),
    lost!("BMSA", &[C5ev]),
    lost!("BMSB", &[C5ev]),
    lost!("BMSC", &[C5ev]),
    lost!("BMSD", &[C5ev]),
    lost!("ChargerControl", &[C5ev]),
    lost!("VCUToCluster", &[C5ev]),
];
