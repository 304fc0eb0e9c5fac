//! Faults of the bus wires, which belong to no vehicle: a table beside the vehicle's own controls.

use bench::rig::Rig;

/// One fault of the wires.
pub(crate) struct Wire {
    /// Public name.
    pub(crate) path: &'static str,
    /// What it is called in simplified Chinese.
    pub(crate) zh: &'static str,
    /// What it is called in English.
    pub(crate) en: &'static str,
    set: fn(&mut Rig, bool),
}

/// Every fault, in the order of the page.
pub(crate) const WIRES: &[Wire] = &[
    Wire { path: "bus.unplug", zh: "仪表 CAN 线断开", en: "Cluster's bus wires cut", set: Rig::unplug },
    Wire { path: "bus.short", zh: "CAN 总线短路", en: "Bus wires shorted", set: Rig::short_bus },
    Wire {
        path: "bus.garble",
        zh: "仪表收到的帧 CRC 错误",
        en: "Frames garbled at the cluster",
        set: Rig::garble,
    },
    Wire { path: "bus.babble", zh: "某节点持续占用总线", en: "A node babbles", set: Rig::babble },
];

/// Which faults are on now.
#[derive(Default)]
pub(crate) struct Wires([bool; WIRES.len()]);

impl Wires {
    /// Sets a fault; `false` if there is none of this name.
    pub(crate) fn set(&mut self, rig: &mut Rig, path: &str, on: bool) -> bool {
        let Some(index) = WIRES.iter().position(|wire| wire.path == path) else { return false };
        // A fault that is there already is not put in twice.
        if self.0[index] != on {
            self.0[index] = on;
            (WIRES[index].set)(rig, on);
        }
        true
    }

    /// What is set, in the order of [`WIRES`].
    pub(crate) fn settings(&self) -> impl Iterator<Item = Option<f64>> {
        self.0.iter().map(|on| Some(f64::from(u8::from(*on))))
    }
}
