//! A vehicle of which every node can send every value, and a drive in it.
//!
//! One frame holds one value. What is kept is sent again every 100 ms, so each node has one time-out: 500 ms.

use cluster::{Cluster, Inputs, Sound, Telltale, View};
use protocol_core::model::{Readings, Value};
use protocol_core::vehicle::{
    FaultText, HvOffRule, LimpRule, NO_VEHICLE, Node, NodeName, Rules, RxMessage, Vehicle,
};
use protocol_core::{CanFrame, CanId, Millis, Severity};
use std::collections::BTreeMap;

/// What any document may print.
const RULES: Rules = Rules {
    hv_off: Some(HvOffRule { vehicle_ms: 5_000, battery_ms: 35_000 }),
    limp: Some(LimpRule { silence_ms: 5_000, most_deciamps: 600, deciamps_per_ah: 3 }),
    charger_loss_ms: Some(5_000),
    hvac_loss_ms: Some(10_000),
    buzzer_ms: Some(120_000),
};

pub(crate) const TIMEOUT: u64 = 500;
pub(crate) const CYCLE: u64 = 100;
pub(crate) const TICK: u64 = 10;

pub(crate) const NODES: [Node; 10] = [
    Node::Vcu,
    Node::Inverter,
    Node::Bms,
    Node::Dcdc,
    Node::Steering,
    Node::Compressor,
    Node::Hvac,
    Node::Insulation,
    Node::Charger,
    Node::Contactors,
];

const fn id(node: Node) -> CanId {
    CanId::extended(0x100 + node as u32)
}

const fn rx(node: Node) -> RxMessage {
    let expected = matches!(node, Node::Vcu | Node::Bms);
    let timeout_ms = TIMEOUT as u32;
    RxMessage {
        id: id(node),
        name: "Probe",
        node,
        len: 8,
        cycle_ms: 0,
        timeout_ms,
        life: None,
        checksum: None,
        expected,
        vital: false,
    }
}

const RX: [RxMessage; NODES.len()] = {
    let mut rows = [rx(Node::Vcu); NODES.len()];
    let mut index = 0;
    while index < NODES.len() {
        rows[index] = rx(NODES[index]);
        index += 1;
    }
    rows
};

/// The code that says the battery burns.
pub(crate) const FIRE_CODE: i32 = 99;

const fn alarm(source: Node, code: u16, severity: Option<Severity>, en: &'static str) -> FaultText {
    FaultText { source, code, severity, fire: false, limps: false, zh: en, en }
}

const FAULTS: &[FaultText] = &[
    alarm(Node::Vcu, 70, None, "Link fault"),
    FaultText { fire: true, ..alarm(Node::Vcu, FIRE_CODE as u16, None, "Fire") },
    alarm(Node::Bms, 1, None, "Alarm 1"),
    alarm(Node::Bms, 2, Some(Severity::Derate), "Alarm 2"),
    alarm(Node::Bms, 3, Some(Severity::Stop), "Alarm 3"),
    alarm(Node::Bms, 32, Some(Severity::Warn), "Alarm 32"),
    FaultText { fire: true, ..alarm(Node::Bms, FIRE_CODE as u16, None, "Fire") },
];

pub(crate) static PROBE: Vehicle = Vehicle {
    name: "probe",
    bitrate: 250_000,
    rx: &RX,
    decode: |index, data, readings: &mut Readings| {
        let number = i32::from_le_bytes([data[4], data[5], data[6], data[7]]);
        let value = Value::ALL[usize::from(data[0])];
        readings.put(index, value, number, data[1] == 0);
    },
    faults: FAULTS,
    rules: RULES,
    nodes: &[NodeName { node: Node::Vcu, zh: "整车", en: "VCU" }],
    ..NO_VEHICLE
};

/// A drive: what is kept is sent every cycle until its node falls silent.
#[derive(Clone)]
pub(crate) struct Drive {
    pub(crate) cluster: Cluster,
    pub(crate) inputs: Inputs,
    pub(crate) now: Millis,
    kept: BTreeMap<Value, (Node, Option<i32>)>,
    silent: Vec<Node>,
}

impl Drive {
    /// A healthy vehicle after the bulb check and after every time-out of a start.
    pub(crate) fn new() -> Self {
        let (cluster, inputs) = (Cluster::new(&PROBE), Inputs::default());
        let mut drive = Self { cluster, inputs, now: Millis(0), kept: BTreeMap::new(), silent: Vec::new() };
        drive.keep(Node::Vcu, Value::VehicleSpeed, 0);
        drive.keep(Node::Bms, Value::BatteryHvOffRequest, 0);
        drive.run(6_000);
        drive
    }

    /// Sends `number` from now on.
    pub(crate) fn keep(&mut self, node: Node, value: Value, number: i32) {
        self.kept.insert(value, (node, Some(number)));
    }

    /// Sends the value as not valid from now on.
    pub(crate) fn keep_invalid(&mut self, node: Node, value: Value) {
        self.kept.insert(value, (node, None));
    }

    /// The node sends nothing from now on, until [`Self::speak`].
    pub(crate) fn hush(&mut self, node: Node) {
        self.silent.push(node);
    }

    pub(crate) fn speak(&mut self, node: Node) {
        self.silent.retain(|&silent| silent != node);
    }

    pub(crate) fn run(&mut self, ms: u64) {
        self.run_by(ms, TICK);
    }

    /// Lets time pass in steps of `tick_ms`; the frames of a step come before its tick.
    pub(crate) fn run_by(&mut self, ms: u64, tick_ms: u64) {
        let end = self.now.after(ms);
        while self.now < end {
            if self.now.0.is_multiple_of(CYCLE) {
                self.send_all();
            }
            self.cluster.tick(&self.inputs, self.now);
            self.now = self.now.after(tick_ms);
        }
    }

    fn send_all(&mut self) {
        for (&value, &(node, number)) in self.kept.iter().filter(|(_, (node, _))| !self.silent.contains(node))
        {
            let [a, b, c, d] = number.unwrap_or(0).to_le_bytes();
            let frame = CanFrame::full(id(node), [value as u8, u8::from(number.is_none()), 0, 0, a, b, c, d]);
            self.cluster.receive(&frame, self.now);
        }
    }

    /// The time of the last tick.
    pub(crate) fn at(&self) -> Millis {
        Millis(self.now.0 - TICK)
    }

    pub(crate) fn view(&self) -> View {
        self.cluster.view(self.at())
    }

    pub(crate) fn sound(&self) -> Option<Sound> {
        self.cluster.chime(self.at()).map(|chime| chime.sound)
    }

    pub(crate) fn lit(&self) -> Vec<Telltale> {
        let telltales = self.view().telltales;
        Telltale::ALL.iter().copied().filter(|&lamp| telltales.is_lit(lamp)).collect()
    }

    /// English text, code and severity of all active faults.
    pub(crate) fn faults(&self) -> Vec<(&'static str, Option<u16>, Severity)> {
        let faults = self.cluster.active_faults(self.at());
        faults.map(|fault| (fault.text.en, fault.code, fault.severity)).collect()
    }

    /// English texts of all active faults.
    pub(crate) fn texts(&self) -> Vec<&'static str> {
        self.faults().into_iter().map(|(text, ..)| text).collect()
    }
}
