//! Nodes that fall silent, messages that stop, counters that stand still: settings of the group Links.
//!
//! One row per node and per message. Refuses to know what silence leads to: that is each node's rule.

use crate::Kind::{Bus, C5ev, Jiulong};
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
    cut!("vcu", Vcu, "整车控制器", "Vehicle controller", &[Bus, Jiulong, C5ev]),
    cut!("mcu", Mcu, "电机控制器", "Motor controller", &[Bus, C5ev]),
    cut!("bms", Bms, "电池管理系统", "Battery controller", &[Bus, Jiulong, C5ev]),
    cut!("dcdc", Dcdc, "DC/DC", "DC/DC", &[Bus]),
    cut!("steering", Steering, "转向助力", "Steering pump", &[Bus]),
    cut!("compressor", Compressor, "打气泵", "Air compressor", &[Bus]),
    cut!("hvac", Hvac, "电空调", "Air conditioning", &[Bus]),
    cut!("insulation", Insulation, "绝缘检测仪", "Insulation monitor", &[Bus]),
    cut!("charger", Charger, "充电机", "Charger", &[Bus, Jiulong, C5ev]),
    cut!("contactors", Contactors, "四合一", "Contactor box", &[Bus]),
    cut!("cluster", Cluster, "仪表", "Cluster", &[Bus, Jiulong, C5ev]),
    frozen!("vcu", Vcu, "整车控制器", "Vehicle controller", &[Bus, Jiulong]),
    frozen!("mcu", Mcu, "电机控制器", "Motor controller", &[Bus]),
    frozen!("bms", Bms, "电池管理系统", "Battery controller", &[Bus, Jiulong]),
    frozen!("dcdc", Dcdc, "DC/DC", "DC/DC", &[Bus]),
    frozen!("steering", Steering, "转向助力", "Steering pump", &[Bus]),
    frozen!("compressor", Compressor, "打气泵", "Air compressor", &[Bus]),
    frozen!("hvac", Hvac, "电空调", "Air conditioning", &[Bus]),
    frozen!("insulation", Insulation, "绝缘检测仪", "Insulation monitor", &[Bus]),
    frozen!("charger", Charger, "充电机", "Charger", &[Bus, Jiulong]),
    lost!("VCU1", &[Bus, Jiulong]),
    lost!("VCU2", &[Bus, Jiulong]),
    lost!("VCU3", &[Bus, Jiulong]),
    lost!("VCU4", &[Bus, Jiulong]),
    lost!("VCU5", &[Bus, Jiulong]),
    lost!("VCU6", &[Bus]),
    lost!("VCU7", &[Bus]),
    lost!("VCU8", &[Bus]),
    lost!("IPU1", &[Bus]),
    lost!("IPU2", &[Bus]),
    lost!("IPU3", &[Bus]),
    lost!("BMS1", &[Bus]),
    lost!("BMS2", &[Bus]),
    lost!("BMS4", &[Bus]),
    lost!("BMS5", &[Bus]),
    lost!("ChargerTx", &[Bus, C5ev]),
    lost!("ChargerRx", &[Bus]),
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
