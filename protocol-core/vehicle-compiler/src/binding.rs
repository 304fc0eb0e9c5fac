//! One `vehicle.toml`, checked against its DBC and the model: what the wire means to a cluster.
//!
//! The keys are described in `vehicles/FORMAT.md`.

use crate::diagnostics::{Diagnostics, Report, did_you_mean};
use crate::meaning::{CHECKSUMS, NODES, accepted, counts_per, states};
use crate::network::{Condition, Doubt, Message, Network, Signal};
use crate::number::Number;
use crate::ratio::{Linear, Ratio};
use protocol_core::checksum::Checksum;
use protocol_core::model::{Missing, Severity, Unit, Value};
use protocol_core::states::Kind;
use protocol_core::stream;
use protocol_core::vehicle::{HvOffRule, LimpRule, Node, Rules};
use std::collections::BTreeMap;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

pub(crate) struct Binding {
    pub(crate) zh: String,
    pub(crate) en: String,
    /// Bits per second.
    pub(crate) bitrate: u32,
    /// 1 or 3.
    pub(crate) worst_level: u8,
    /// Images hold the vehicle and look for it.
    pub(crate) shipped: bool,
    /// Values of a byte that say "not available", for the bit fields in it too.
    pub(crate) filler: Vec<u8>,
    pub(crate) rules: Rules,
    pub(crate) nodes: Vec<NodeRow>,
    /// Sorted by identifier.
    pub(crate) rx: Vec<Rx>,
    pub(crate) streams: Vec<StreamRow>,
    pub(crate) tx: Vec<Tx>,
    /// Sorted by source and code.
    pub(crate) faults: Vec<Fault>,
}

pub(crate) struct NodeRow {
    pub(crate) dbc: String,
    /// Further nodes of the DBC that are parts of this one.
    pub(crate) also: Vec<String>,
    pub(crate) node: Node,
    pub(crate) zh: String,
    pub(crate) en: String,
}

pub(crate) struct Rx {
    pub(crate) message: usize,
    pub(crate) node: Node,
    pub(crate) len: u8,
    pub(crate) cycle_ms: u32,
    pub(crate) timeout_ms: u32,
    pub(crate) checksum: Option<Checksum>,
    pub(crate) expected: bool,
    pub(crate) vital: bool,
    pub(crate) values: Vec<RxValue>,
}

pub(crate) struct RxValue {
    pub(crate) value: Value,
    /// More than one: a flag is set if any is, a severity is the worst, bits are numbered in this order.
    pub(crate) terms: Vec<Term>,
}

impl RxValue {
    /// Returns when the value is in the frame; all its signals are in it together.
    pub(crate) fn when<'m>(&self, message: &'m Message) -> &'m [Condition] {
        let mut conditions = self.terms.iter().map(|term| message.signals[term.signal].when.as_slice());
        conditions.find(|when| !when.is_empty()).unwrap_or(&[])
    }
}

/// A table that comes in several messages.
pub(crate) struct StreamRow {
    pub(crate) name: String,
    /// Index of its first message in the network.
    pub(crate) first: usize,
    pub(crate) frames: usize,
    pub(crate) step: i64,
    /// Byte of the number, if there is one, and byte of the value.
    pub(crate) cells: Vec<(Option<u8>, u8)>,
    pub(crate) zeros_pad: bool,
    pub(crate) start: usize,
    pub(crate) size: usize,
    pub(crate) valid: (u8, u8),
    pub(crate) scale: Linear,
    /// In the order of [`BOUND`].
    pub(crate) bound: [Option<Value>; 5],
}

/// What a stream fills in, by the fields of `stream::Bound`.
pub(crate) const BOUND: [&str; 5] = ["highest", "lowest", "highest_number", "lowest_number", "count"];

pub(crate) struct Term {
    pub(crate) signal: usize,
    pub(crate) how: How,
}

pub(crate) enum How {
    /// A number, scaled to the model's unit; the scale is off by `off` counts at most.
    Scaled { linear: Linear, nearest: bool, magnitude: bool, off: f64 },
    /// The number that an IEEE float is, scaled to the model's unit.
    Float { linear: Linear, nearest: bool, magnitude: bool },
    /// A state: model value of each raw value, `None` = invalid; what is not listed is `other`.
    Mapped { states: States, other: Option<i32> },
}

/// State of the model by raw value; `None` = invalid.
pub(crate) type States = BTreeMap<i64, Option<i32>>;

pub(crate) struct Tx {
    pub(crate) message: usize,
    pub(crate) cycle_ms: u32,
    pub(crate) checksum: Option<Checksum>,
    pub(crate) signals: Vec<TxSignal>,
}

pub(crate) struct TxSignal {
    pub(crate) signal: usize,
    pub(crate) value: Value,
    pub(crate) how: HowBack,
    /// Raw value while the model value is not known.
    pub(crate) missing: i64,
}

pub(crate) enum HowBack {
    /// Raw value of a model number, before it is limited to the valid range.
    Scaled { linear: Linear, nearest: bool },
    /// `length` bits from bit `low` of the number that the scale gives.
    Part { linear: Linear, low: u8, length: u8 },
    /// Raw value of each state.
    Mapped(BTreeMap<i32, i64>),
}

pub(crate) struct Fault {
    pub(crate) source: Node,
    pub(crate) code: u16,
    pub(crate) severity: Option<Severity>,
    pub(crate) fire: bool,
    pub(crate) limps: bool,
    pub(crate) zh: String,
    pub(crate) en: String,
}

/// What a DBC writes where no node is the sender of a message.
pub(crate) const NOBODY: &str = "Vector__XXX";

type Entry<'t> = (&'t Spanned<std::borrow::Cow<'t, str>>, &'t Spanned<DeValue<'t>>);
type Maps<'t> = BTreeMap<&'t str, &'t DeTable<'t>>;

/// Silence that is not shorter than this makes values stale (BUS-108).
const SHORTEST_TIMEOUT_MS: u32 = 500;

/// Returns the silence after which values of a message are stale, unless the file says otherwise.
fn usual_timeout(message: &Message) -> u32 {
    (5 * message.slow_cycle_ms).max(SHORTEST_TIMEOUT_MS)
}

/// Reads a `vehicle.toml`.
///
/// `dbc` is the name of the DBC file of the network.
pub(crate) fn read(file: &str, text: &str, dbc: &str, network: &Network) -> Result<Binding, Diagnostics> {
    let (root, errors) = DeTable::parse_recoverable(text);
    let mut report = Report::new(file, text);
    for error in &errors {
        let offset = error.span().map_or(0, |span| span.start);
        report.offset(offset, format!("not valid TOML: {}", error.message()));
    }
    if !errors.is_empty() {
        return report.finish().or(()).map(|()| unreachable!("a report with errors is an error"));
    }
    let mut reader = Reader { report, dbc, network };
    let binding = reader.root(root.get_ref());
    reader.report.finish().or(binding)
}

/// What `vehicle.toml` says of a signal in the place of the DBC.
#[derive(Default)]
struct Said {
    unit: Option<String>,
    factor: Option<Ratio>,
    offset: Option<Ratio>,
    /// The sign of the physical value is turned.
    negate: bool,
}

/// Returns factor and offset of a signal in counts of the model, if they have at most 37 digits.
fn scaled_by(signal: &Signal, said: &Said, counts: Ratio) -> Option<(Ratio, Ratio)> {
    let (factor, offset) = (said.factor.unwrap_or(signal.factor), said.offset.unwrap_or(signal.offset));
    let counts = if said.negate { Ratio { num: -counts.num, ..counts } } else { counts };
    Some((factor.checked_mul(counts)?, offset.checked_mul(counts)?))
}

/// Returns the model counts of a signal as a function of its raw value, and by how many counts that is off at most; `None`
/// if they do not fit in 31 bits over the whole valid range.
fn near_scale(signal: &Signal, said: &Said, counts: Ratio) -> Option<(Linear, f64)> {
    let scale = scaled_by(signal, said, counts).and_then(|(factor, shift)| {
        let span = if signal.number.is_float() { (0, 0) } else { signal.range };
        Linear::near(factor, shift, span)
    });
    let fits = |(linear, off): &(Linear, f64)| {
        let at = |raw: i128| {
            i64::try_from(raw)
                .is_ok_and(|raw| linear.checked_floor(raw).is_some_and(|n| i32::try_from(n).is_ok()))
        };
        // Half a count is what rounding may cost.
        *off <= 0.5 && (signal.number.is_float() || at(signal.range.0) && at(signal.range.1))
    };
    scale.filter(fits)
}

/// Does what [`near_scale`] does for a value of the model, with a unit of which one of the signal's is `times`; `None` too
/// if the unit is another one.
pub(crate) fn scale_of(value: Value, signal: &Signal, (unit, times): (&str, Ratio)) -> Option<(Linear, f64)> {
    near_scale(signal, &Said::default(), counts_per(value.unit(), unit)?.checked_mul(times)?)
}

struct Reader<'a> {
    report: Report<'a>,
    dbc: &'a str,
    network: &'a Network,
}

/// A flag that is sent as 0 or 1.
fn plain_flag() -> States {
    States::from([(0, Some(0)), (1, Some(1))])
}

fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) => "a number",
        DeValue::Float(_) => "a number with a decimal point",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

impl Reader<'_> {
    fn wrong(&mut self, at: &Spanned<DeValue<'_>>, needed: &str) {
        self.report.offset(at.span().start, format!("{needed} is needed here, not {}", kind(at.get_ref())));
    }

    fn text(&mut self, at: &Spanned<DeValue<'_>>) -> String {
        match at.get_ref() {
            DeValue::String(text) => text.to_string(),
            _ => {
                self.wrong(at, "a text");
                String::new()
            }
        }
    }

    fn number(&mut self, at: &Spanned<DeValue<'_>>, range: std::ops::RangeInclusive<i64>) -> i64 {
        let DeValue::Integer(integer) = at.get_ref() else {
            self.wrong(at, "a number");
            return *range.start();
        };
        match i64::from_str_radix(integer.as_str(), integer.radix()) {
            Ok(number) if range.contains(&number) => number,
            _ => {
                let message = format!("{integer} must be {} to {}", range.start(), range.end());
                self.report.offset(at.span().start, message);
                *range.start()
            }
        }
    }

    fn flag(&mut self, at: &Spanned<DeValue<'_>>) -> bool {
        if let DeValue::Boolean(flag) = at.get_ref() {
            return *flag;
        }
        self.wrong(at, "true or false");
        false
    }

    fn table<'t>(&mut self, at: &'t Spanned<DeValue<'_>>) -> Vec<Entry<'t>> {
        match at.get_ref() {
            DeValue::Table(table) => table.iter().collect(),
            _ => {
                self.wrong(at, "a table");
                Vec::new()
            }
        }
    }

    fn unknown<'c>(&mut self, offset: usize, what: &str, word: &str, known: impl Iterator<Item = &'c str>) {
        let near = did_you_mean(word, known);
        self.report.offset(offset, format!("no {what} `{word}`{near}"));
    }

    fn root(&mut self, root: &DeTable<'_>) -> Binding {
        const SECTIONS: [&str; 8] = ["faults", "maps", "nodes", "rules", "rx", "streams", "tx", "vehicle"];
        let mut binding = Binding {
            zh: String::new(),
            en: String::new(),
            bitrate: self.network.bitrate.unwrap_or(0),
            worst_level: 3,
            shipped: true,
            filler: Vec::new(),
            rules: Rules::NONE,
            nodes: Vec::new(),
            rx: Vec::new(),
            streams: Vec::new(),
            tx: Vec::new(),
            faults: Vec::new(),
        };
        for key in root.keys().filter(|key| !SECTIONS.contains(&key.get_ref().as_ref())) {
            self.unknown(key.span().start, "section", key.get_ref(), SECTIONS.into_iter());
        }
        match root.get("vehicle") {
            Some(vehicle) => self.vehicle(vehicle, &mut binding),
            None => self.report.line(1, "section [vehicle] with the names `zh` and `en` is missing"),
        }
        if let Some(rules) = root.get("rules") {
            binding.rules = self.rules(rules);
        }
        if let Some(nodes) = root.get("nodes") {
            binding.nodes = self.nodes(nodes);
        }
        let mut maps = Maps::new();
        if let Some(table) = root.get("maps") {
            for (name, map) in self.table(table) {
                match map.get_ref() {
                    DeValue::Table(map) => drop(maps.insert(name.get_ref(), map)),
                    _ => self.wrong(map, "a table"),
                }
            }
        }
        if let Some(rx) = root.get("rx") {
            binding.rx = self.received(rx, &binding.nodes, &maps);
        }
        if let Some(streams) = root.get("streams") {
            self.streams(streams, &mut binding);
        }
        if let Some(tx) = root.get("tx") {
            binding.tx = self.sent(tx, &binding.nodes, &maps);
        }
        if let Some(faults) = root.get("faults") {
            binding.faults = self.faults(faults, &binding.nodes);
        }
        binding
    }

    fn bytes(&mut self, at: &Spanned<DeValue<'_>>) -> Vec<u8> {
        match at.get_ref() {
            DeValue::Array(list) => list.iter().map(|byte| self.number(byte, 1..=255) as u8).collect(),
            _ => {
                self.wrong(at, "a list of bytes");
                Vec::new()
            }
        }
    }

    fn rules(&mut self, at: &Spanned<DeValue<'_>>) -> Rules {
        const KEYS: [&str; 5] = ["buzzer_ms", "charger_loss_ms", "hv_off", "hvac_loss_ms", "limp"];
        let mut rules = Rules::NONE;
        for (key, value) in self.table(at) {
            match key.get_ref().as_ref() {
                "buzzer_ms" => rules.buzzer_ms = Some(self.duration_ms(value)),
                "charger_loss_ms" => rules.charger_loss_ms = Some(self.duration_ms(value)),
                "hvac_loss_ms" => rules.hvac_loss_ms = Some(self.duration_ms(value)),
                "hv_off" => {
                    let [vehicle_ms, battery_ms] = self.numbers(value, ["vehicle_ms", "battery_ms"]);
                    rules.hv_off = Some(HvOffRule { vehicle_ms, battery_ms });
                }
                "limp" => {
                    let keys = ["silence_ms", "most_deciamps", "deciamps_per_ah"];
                    let [silence_ms, most, per_ah] = self.numbers(value, keys);
                    let [most_deciamps, deciamps_per_ah] = [most, per_ah].map(u32::cast_signed);
                    rules.limp = Some(LimpRule { silence_ms, most_deciamps, deciamps_per_ah });
                }
                other => self.unknown(key.span().start, "rule", other, KEYS.into_iter()),
            }
        }
        rules
    }

    /// Reads a table that needs all of `keys`.
    fn numbers<const N: usize>(&mut self, at: &Spanned<DeValue<'_>>, keys: [&str; N]) -> [u32; N] {
        let mut found = [0; N];
        for (key, value) in self.table(at) {
            match keys.iter().position(|known| *known == key.get_ref()) {
                Some(place) => found[place] = self.duration_ms(value),
                None => self.unknown(key.span().start, "key", key.get_ref(), keys.into_iter()),
            }
        }
        if let Some(place) = found.iter().position(|number| *number == 0) {
            self.report.offset(at.span().start, format!("`{}` is missing", keys[place]));
        }
        found
    }

    fn duration_ms(&mut self, at: &Spanned<DeValue<'_>>) -> u32 {
        self.number(at, 1..=600_000) as u32
    }

    fn vehicle(&mut self, at: &Spanned<DeValue<'_>>, binding: &mut Binding) {
        const KEYS: [&str; 6] = ["bitrate", "zh", "en", "worst_level", "shipped", "filler"];
        for (key, value) in self.table(at) {
            match key.get_ref().as_ref() {
                "zh" => binding.zh = self.text(value),
                "en" => binding.en = self.text(value),
                "bitrate" => binding.bitrate = self.number(value, 10_000..=1_000_000) as u32,
                "worst_level" => match self.number(value, 1..=3) {
                    2 => self.wrong(value, "1 or 3"),
                    level => binding.worst_level = level as u8,
                },
                "shipped" => binding.shipped = self.flag(value),
                "filler" => binding.filler = self.bytes(value),
                other => self.unknown(key.span().start, "key", other, KEYS.into_iter()),
            }
        }
        if binding.zh.is_empty() || binding.en.is_empty() {
            self.report.offset(at.span().start, "[vehicle] needs the names `zh` and `en`");
        }
        if binding.bitrate == 0 {
            let text =
                format!("{} does not say the bit rate (BusSpeed): write `bitrate = 500000` here", self.dbc);
            self.report.offset(at.span().start, text);
        }
    }

    fn nodes(&mut self, at: &Spanned<DeValue<'_>>) -> Vec<NodeRow> {
        let mut rows: Vec<NodeRow> = Vec::new();
        for (name, table) in self.table(at) {
            self.node_of_dbc(name.get_ref(), name.span().start);
            let (mut node, mut zh, mut en) = (None, String::new(), String::new());
            let mut also = Vec::new();
            for (key, value) in self.table(table) {
                match key.get_ref().as_ref() {
                    "node" => {
                        let word = self.text(value);
                        node = NODES.iter().find(|(name, _)| *name == word).map(|(_, node)| *node);
                        if node.is_none() {
                            let known = NODES.iter().map(|(name, _)| *name);
                            self.unknown(value.span().start, "kind of node", &word, known);
                            node = Some(Node::Vcu);
                        }
                    }
                    "zh" => zh = self.text(value),
                    "en" => en = self.text(value),
                    "also" => match value.get_ref() {
                        DeValue::Array(list) => {
                            for at in list.iter() {
                                let other = self.text(at);
                                self.node_of_dbc(&other, at.span().start);
                                also.push(other);
                            }
                        }
                        _ => self.wrong(value, "a list"),
                    },
                    other => {
                        self.unknown(
                            key.span().start,
                            "key",
                            other,
                            ["also", "node", "zh", "en"].into_iter(),
                        );
                    }
                }
            }
            let Some(node) = node.filter(|_| !zh.is_empty() && !en.is_empty()) else {
                let message = format!("node `{}` needs `node`, `zh` and `en`", name.get_ref());
                self.report.offset(name.span().start, message);
                continue;
            };
            if rows.iter().any(|row| row.node == node) {
                let message = format!("`{}` is the second node of this kind", name.get_ref());
                self.report.offset(name.span().start, message);
            }
            rows.push(NodeRow { dbc: name.get_ref().to_string(), also, node, zh, en });
        }
        rows.sort_by_key(|row| row.node);
        rows
    }

    /// Checks that a node is one of the DBC, or stands for the messages without a sender.
    fn node_of_dbc(&mut self, name: &str, offset: usize) {
        let nodes = &self.network.nodes;
        if name != NOBODY && !nodes.iter().any(|node| node == name) {
            let near = did_you_mean(name, nodes.iter().map(String::as_str));
            self.report.offset(offset, format!("no node `{name}` in the DBC{near}"));
        }
    }

    /// Returns the message of a section and the kind of its sender.
    fn message(
        &mut self,
        name: &Spanned<std::borrow::Cow<'_, str>>,
        nodes: &[NodeRow],
    ) -> Option<(usize, Node)> {
        let messages = &self.network.messages;
        let Some(index) = self.network.index(name.get_ref()) else {
            let near = did_you_mean(name.get_ref(), messages.iter().map(|message| message.name.as_str()));
            self.report
                .offset(name.span().start, format!("no message `{}` in the DBC{near}", name.get_ref()));
            return None;
        };
        if let Some(doubt) = messages[index].doubt.as_ref().or(messages[index].twice.as_ref()) {
            self.doubted(&format!("`{}`", name.get_ref()), name.span().start, doubt);
            return None;
        }
        let sender = if messages[index].sender.is_empty() { NOBODY } else { &messages[index].sender };
        let sends = |row: &&NodeRow| row.dbc == sender || row.also.iter().any(|other| other == sender);
        let Some(row) = nodes.iter().find(sends) else {
            let message =
                format!("`{}` is sent by `{sender}`, which has no [nodes.{sender}]", name.get_ref());
            self.report.offset(name.span().start, message);
            return None;
        };
        Some((index, row.node))
    }

    fn received(&mut self, at: &Spanned<DeValue<'_>>, nodes: &[NodeRow], maps: &Maps<'_>) -> Vec<Rx> {
        let mut rows: Vec<Rx> = Vec::new();
        let mut owners: BTreeMap<Value, String> = BTreeMap::new();
        for (name, table) in self.table(at) {
            let Some((index, node)) = self.message(name, nodes) else { continue };
            let message = &self.network.messages[index];
            if node == Node::Cluster {
                let text = format!("`{}` is sent by the cluster: it belongs to [tx.{0}]", message.name);
                self.report.offset(name.span().start, text);
                continue;
            }
            let mut enabled = true;
            let (mut cycle, mut timeout) = (None, None);
            let mut row = Rx {
                message: index,
                node,
                len: message.len,
                cycle_ms: message.cycle_ms,
                timeout_ms: 0,
                checksum: None,
                expected: !message.optional,
                vital: false,
                values: Vec::new(),
            };
            for (key, value) in self.table(table) {
                match key.get_ref().as_ref() {
                    "enabled" => enabled = self.flag(value),
                    "expected" => row.expected = self.flag(value),
                    "vital" => row.vital = self.flag(value),
                    "checksum" => row.checksum = self.checksum(value, message),
                    "len" => row.len = self.number(value, 0..=i64::from(message.len)) as u8,
                    "cycle_ms" => cycle = Some(self.number(value, 1..=60_000) as u32),
                    "timeout_ms" => timeout = Some(self.number(value, 50..=600_000) as u32),
                    _ => self.paths(String::new(), key, value, message, maps, &mut row.values),
                }
            }
            let usual = cycle.map_or(usual_timeout(message), |cycle| (5 * cycle).max(SHORTEST_TIMEOUT_MS));
            row.cycle_ms = cycle.unwrap_or(row.cycle_ms);
            row.timeout_ms = timeout.unwrap_or(usual);
            if row.checksum.is_some_and(|checksum| row.len < checksum.len) {
                let text =
                    format!("`len` of `{}` cuts its checksum off: it covers the whole frame", message.name);
                self.report.offset(name.span().start, text);
            }
            if timeout.is_none() && cycle.is_none() && message.slow_cycle_ms == 0 {
                let text = format!(
                    "`{}` has no cycle time in the DBC: set `cycle_ms` or `timeout_ms`",
                    message.name
                );
                self.report.offset(name.span().start, text);
            }
            row.values.sort_by_key(|value| value.value);
            if !enabled {
                continue;
            }
            for value in &row.values {
                if let Some(other) = owners.insert(value.value, message.name.clone()) {
                    let text =
                        format!("`{}` is bound in {other} and in {}", value.value.path(), message.name);
                    self.report.offset(name.span().start, text);
                }
            }
            rows.push(row);
        }
        rows.sort_by_key(|row| self.network.messages[row.message].id);
        if rows.len() >= 0xFE {
            self.report.offset(at.span().start, "more than 253 received messages");
        }
        rows
    }

    /// Reads `path = ...`, written in one key or in nested tables.
    fn paths(
        &mut self,
        prefix: String,
        key: &Spanned<std::borrow::Cow<'_, str>>,
        at: &Spanned<DeValue<'_>>,
        message: &Message,
        maps: &Maps<'_>,
        found: &mut Vec<RxValue>,
    ) {
        let path = format!("{prefix}{}", key.get_ref());
        if let Some(value) = Value::from_path(&path) {
            found.extend(self.bound(value, at, message, maps));
            return;
        }
        let prefix = format!("{path}.");
        match at.get_ref() {
            DeValue::Table(table) if !table.contains_key("signal") => {
                for (key, value) in table.iter() {
                    self.paths(prefix.clone(), key, value, message, maps, found);
                }
            }
            _ => {
                const OPTIONS: [&str; 7] =
                    ["checksum", "cycle_ms", "enabled", "expected", "len", "timeout_ms", "vital"];
                let known = Value::ALL.iter().map(|value| value.path()).chain(OPTIONS);
                self.unknown(key.span().start, "model value", &path, known);
            }
        }
    }

    fn bound(
        &mut self,
        value: Value,
        at: &Spanned<DeValue<'_>>,
        message: &Message,
        maps: &Maps<'_>,
    ) -> Option<RxValue> {
        let DeValue::Array(list) = at.get_ref() else {
            return Some(RxValue { value, terms: vec![self.term(value, at, message, maps)?] });
        };
        if !matches!(value.unit(), Unit::Flag | Unit::Severity | Unit::Fan | Unit::Bits) {
            let text =
                format!("`{}` is no flag, severity, fan speed or bits: a list has no meaning", value.path());
            self.report.offset(at.span().start, text);
        }
        let terms: Vec<Term> = list.iter().filter_map(|at| self.term(value, at, message, maps)).collect();
        if value.unit() == Unit::Bits && !(1..=31).contains(&list.len()) {
            self.report.offset(at.span().start, format!("`{}` holds 1 to 31 bits", value.path()));
        }
        let row = RxValue { value, terms };
        let when = row.when(message);
        let together = |term: &Term| {
            let own = message.signals[term.signal].when.as_slice();
            own.is_empty() || own == when
        };
        if !row.terms.iter().all(together) {
            let text = format!("the signals of `{}` are never in the same frame", value.path());
            self.report.offset(at.span().start, text);
        }
        Some(row)
    }

    fn signal(&mut self, name: &str, offset: usize, message: &Message) -> Option<usize> {
        let found = message.signal(name);
        let lost = || message.lost.iter().find(|(lost, _)| lost == name).map(|(_, doubt)| doubt);
        if let Some(doubt) = found.map_or_else(lost, |index| message.signals[index].doubt.as_ref()) {
            self.doubted(&format!("`{name}` of {}", message.name), offset, doubt);
            return None;
        }
        if found.is_none() {
            let known = message.signals.iter().map(|signal| signal.name.as_str());
            let near = did_you_mean(name, known);
            self.report.offset(offset, format!("no signal `{name}` in {}{near}", message.name));
        }
        found
    }

    /// Reports that something of the DBC cannot be bound, with its place there.
    fn doubted(&mut self, what: &str, offset: usize, doubt: &Doubt) {
        let (file, line, column) = (self.dbc, doubt.at.line, doubt.at.column);
        self.report.offset(offset, format!("{what} cannot be bound: {file}:{line}:{column}: {}", doubt.text));
    }

    /// Returns a signal that is one whole byte without a sign, and its byte.
    fn byte(&mut self, at: &Spanned<DeValue<'_>>, message: &Message) -> Option<(usize, u8)> {
        let (name, offset) = (self.text(at), at.span().start);
        let index = self.signal(&name, offset, message)?;
        let signal = &message.signals[index];
        match signal.segments().as_slice() {
            [segment] if segment.bits == 8 && signal.number == Number::Unsigned && signal.when.is_empty() => {
                Some((index, segment.byte))
            }
            _ => {
                self.report.offset(offset, format!("`{name}` is not one whole byte without a sign"));
                None
            }
        }
    }

    fn checksum(&mut self, at: &Spanned<DeValue<'_>>, message: &Message) -> Option<Checksum> {
        let (mut byte, mut kind) = (None, None);
        for (key, value) in self.table(at) {
            match key.get_ref().as_ref() {
                "signal" => byte = Some(self.byte(value, message)),
                "kind" => {
                    let word = self.text(value);
                    kind = CHECKSUMS.iter().find(|(name, _)| *name == word).map(|(_, kind)| *kind);
                    if kind.is_none() {
                        let known = CHECKSUMS.iter().map(|(name, _)| *name);
                        self.unknown(value.span().start, "kind of checksum", &word, known);
                        return None;
                    }
                }
                other => self.unknown(key.span().start, "key", other, ["signal", "kind"].into_iter()),
            }
        }
        let (Some(byte), Some(kind)) = (byte, kind) else {
            self.report.offset(at.span().start, "a checksum needs `signal` and `kind`");
            return None;
        };
        let (index, byte) = byte?;
        if message.signals[index].life.is_some() {
            self.report.offset(at.span().start, "the life counter cannot be the checksum");
        }
        Some(Checksum { byte, len: message.len, kind })
    }

    fn streams(&mut self, at: &Spanned<DeValue<'_>>, binding: &mut Binding) {
        for (name, table) in self.table(at) {
            let Some((row, rx)) = self.stream(name, table, binding) else { continue };
            if binding.rx.iter().any(|rx| (row.first..row.first + row.frames).contains(&rx.message)) {
                let text =
                    format!("messages of `{}` belong to the stream and have no [rx.] of their own", row.name);
                self.report.offset(name.span().start, text);
            }
            binding.rx.push(rx);
            binding.streams.push(row);
        }
        binding.rx.sort_by_key(|row| self.network.messages[row.message].id);
    }

    /// Returns a stream, and the receive row of its first message, which is its sign of life.
    fn stream(
        &mut self,
        name: &Spanned<std::borrow::Cow<'_, str>>,
        at: &Spanned<DeValue<'_>>,
        binding: &Binding,
    ) -> Option<(StreamRow, Rx)> {
        const KEYS: [&str; 9] = [
            "messages",
            "numbers",
            "values",
            "zeros_pad",
            "highest",
            "lowest",
            "highest_number",
            "lowest_number",
            "count",
        ];
        let here = name.span().start;
        let (mut ends, mut numbers, mut values, mut zeros_pad) = (None, None, None, false);
        let mut bound = [None; 5];
        for (key, value) in self.table(at) {
            let offset = value.span().start;
            match (key.get_ref().as_ref(), value.get_ref()) {
                ("messages", DeValue::Array(list)) if list.len() == 2 => ends = Some(list),
                ("numbers", DeValue::Array(list)) => numbers = Some(list),
                ("values", DeValue::Array(list)) => values = Some(list),
                ("messages", _) => self.wrong(value, "a list of the first and the last message"),
                ("numbers" | "values", _) => self.wrong(value, "a list of signals"),
                ("zeros_pad", _) => zeros_pad = self.flag(value),
                (other, _) => match BOUND.iter().position(|known| *known == other) {
                    Some(index) => {
                        let path = self.text(value);
                        bound[index] = Value::from_path(&path);
                        if bound[index].is_none() {
                            let known = Value::ALL.iter().map(|value| value.path());
                            self.unknown(offset, "model value", &path, known);
                        }
                    }
                    None => self.unknown(key.span().start, "key", other, KEYS.into_iter()),
                },
            }
        }
        let (Some(ends), Some(values)) = (ends, values) else {
            self.report.offset(here, format!("stream `{}` needs `messages` and `values`", name.get_ref()));
            return None;
        };
        let (first, frames, step, node) = self.run_of_messages(ends, here, &binding.nodes)?;
        let message = &self.network.messages[first];
        let values: Vec<(usize, u8)> = values.iter().filter_map(|at| self.byte(at, message)).collect();
        let numbers: Option<Vec<(usize, u8)>> =
            numbers.map(|list| list.iter().filter_map(|at| self.byte(at, message)).collect());
        if values.is_empty() || numbers.as_ref().is_some_and(|numbers| numbers.len() != values.len()) {
            self.report.offset(here, "`numbers` must be as many as `values`");
            return None;
        }
        let signals: Vec<&Signal> = values.iter().map(|(index, _)| &message.signals[*index]).collect();
        let alike = |signal: &&Signal| {
            (signal.factor, signal.offset, &signal.unit, signal.range, signal.invalid_raw)
                == (signals[0].factor, signals[0].offset, &signals[0].unit, signals[0].range, None)
        };
        if !signals.iter().all(alike) {
            self.report
                .offset(here, "`values` differ in factor, offset, unit or range, or have an invalid value");
        }
        for value in bound[2..].iter().flatten().filter(|value| value.unit() != Unit::Count) {
            self.report.offset(here, format!("`{}` does not count", value.path()));
        }
        let scales = [bound[0], bound[1]]
            .into_iter()
            .flatten()
            .map(|value| self.scale(value, signals[0], &Said::default(), here));
        let scales: Vec<Option<Linear>> = scales.map(|scale| scale.map(|(linear, _)| linear)).collect();
        if scales.windows(2).any(|pair| pair[0] != pair[1]) {
            self.report.offset(here, "`highest` and `lowest` are values of different units");
        }
        let start = binding.streams.last().map_or(0, |last| last.start + last.size);
        let size = if numbers.is_some() { 256 } else { frames * values.len() };
        if start + size > stream::ROOM {
            let text = format!("the streams hold {} cells, {} is the most", start + size, stream::ROOM);
            self.report.offset(here, text);
        }
        let numbers = numbers.map_or(vec![None; values.len()], |numbers| {
            numbers.into_iter().map(|(_, byte)| Some(byte)).collect()
        });
        let rx = Rx {
            message: first,
            node,
            len: message.len,
            cycle_ms: message.cycle_ms,
            timeout_ms: usual_timeout(message),
            checksum: None,
            expected: false,
            vital: false,
            values: Vec::new(),
        };
        let row = StreamRow {
            name: name.get_ref().to_string(),
            first,
            frames,
            step,
            cells: numbers.into_iter().zip(values.iter().map(|(_, byte)| *byte)).collect(),
            zeros_pad,
            start,
            size,
            valid: (signals[0].range.0 as u8, signals[0].range.1 as u8),
            scale: scales.first().copied().unwrap_or(signals[0].scale)?,
            bound,
        };
        Some((row, rx))
    }

    /// Returns index of the first message, how many there are, the distance of their identifiers and the sender.
    fn run_of_messages(
        &mut self,
        ends: &DeArray<'_>,
        here: usize,
        nodes: &[NodeRow],
    ) -> Option<(usize, usize, i64, Node)> {
        let mut found = Vec::new();
        for at in ends.iter() {
            let word = Spanned::new(at.span(), self.text(at).into());
            found.push(self.message(&word, nodes)?);
        }
        let [(first, node), (last, _)] = found[..] else { return None };
        let messages = self.network.messages.get(first..=last).unwrap_or_default();
        let steps: Vec<i64> =
            messages.windows(2).map(|pair| i64::from(pair[1].id) - i64::from(pair[0].id)).collect();
        let alike = |message: &Message| {
            let first = &messages[0];
            message.len == first.len && message.signals == first.signals && message.sender == first.sender
        };
        let even = steps.first().is_some_and(|step| steps.iter().all(|other| other == step));
        if !even || !messages.iter().all(alike) || messages.len() > 128 {
            let text = "the messages from the first to the last must be alike, in the order of the DBC, \
                        with identifiers at equal distance, and 2 to 128";
            self.report.offset(here, text);
            return None;
        }
        Some((first, messages.len(), steps[0], node))
    }

    fn term(
        &mut self,
        value: Value,
        at: &Spanned<DeValue<'_>>,
        message: &Message,
        maps: &Maps<'_>,
    ) -> Option<Term> {
        const KEYS: [&str; 10] =
            ["factor", "magnitude", "map", "negate", "offset", "other", "round", "signal", "unit", "when"];
        let mut name = None;
        let (mut nearest, mut magnitude) = (false, false);
        let (mut said, mut when) = (Said::default(), None);
        let (mut map, mut other): (Option<Vec<Entry<'_>>>, _) = (None, None);
        match at.get_ref() {
            DeValue::String(text) => name = Some((text.to_string(), at.span().start)),
            DeValue::Table(table) => {
                for (key, value_at) in table.iter() {
                    match key.get_ref().as_ref() {
                        "signal" => name = Some((self.text(value_at), value_at.span().start)),
                        "round" => nearest = self.rounding(value_at),
                        "magnitude" => magnitude = self.flag(value_at),
                        "when" => when = Some(value_at),
                        "negate" => said.negate = self.flag(value_at),
                        "unit" => said.unit = Some(self.text(value_at)),
                        "factor" => said.factor = self.decimal(value_at),
                        "offset" => said.offset = self.decimal(value_at),
                        "map" => map = self.map(value_at, maps),
                        "other" => other = self.state(value, value_at),
                        key_name => self.unknown(key.span().start, "key", key_name, KEYS.into_iter()),
                    }
                }
            }
            _ => self.wrong(at, "the name of a signal"),
        }
        let Some((name, offset)) = name else {
            self.report.offset(at.span().start, format!("`{}` needs a `signal`", value.path()));
            return None;
        };
        let index = self.signal(&name, offset, message)?;
        let signal = &message.signals[index];
        if value.unit() == Unit::Bits && signal.length != 1 && when.is_none() {
            let advice = "say at which values the bit is set: `when = [2, 3]`";
            self.report.offset(offset, format!("`{name}` has {} bits: {advice}", signal.length));
        }
        if let Some(when) = when.filter(|_| value.unit() != Unit::Bits) {
            self.report.offset(
                when.span().start,
                format!("`{}` is no list of bits: `when` says nothing", value.path()),
            );
        }
        let how = if let (Unit::Bits, Some(when)) = (value.unit(), when) {
            How::Mapped { states: self.set_at(when, signal), other: Some(0) }
        } else if value.unit() == Unit::Bits {
            How::Mapped { states: plain_flag(), other: None }
        } else if map.is_some() || value.unit().kind().is_some() {
            let mut states = self.states(value, signal, map.unwrap_or_default(), at.span().start)?;
            if other.is_none() {
                states.retain(|_, state| state.is_some());
            }
            How::Mapped { states, other }
        } else {
            let (linear, off) = self.scale(value, signal, &said, at.span().start)?;
            match signal.number.is_float() {
                true => How::Float { linear, nearest, magnitude },
                false => How::Scaled { linear, nearest, magnitude, off },
            }
        };
        Some(Term { signal: index, how })
    }

    /// Reads the raw values, as numbers or words of the value table, at which a bit is set.
    fn set_at(&mut self, at: &Spanned<DeValue<'_>>, signal: &Signal) -> States {
        let mut states = States::new();
        let DeValue::Array(list) = at.get_ref() else {
            self.wrong(at, "a list of raw values or words");
            return states;
        };
        if list.is_empty() {
            self.report.offset(at.span().start, "a bit that is never set says nothing: name a raw value");
        }
        for at in list.iter() {
            let (lowest, highest) = signal.short_span();
            if let DeValue::String(word) = at.get_ref() {
                let raws = signal.values.iter().filter(|(_, known)| known == word).map(|(raw, _)| *raw);
                let before = states.len();
                states.extend(raws.map(|raw| (raw, Some(1))));
                if states.len() == before {
                    let known = signal.values.iter().map(|(_, word)| word.as_str());
                    self.unknown(at.span().start, &format!("value of `{}` called", signal.name), word, known);
                }
            } else {
                states.insert(self.number(at, lowest..=highest), Some(1));
            }
        }
        states
    }

    /// Reads a number with a point or without, exactly.
    fn decimal(&mut self, at: &Spanned<DeValue<'_>>) -> Option<Ratio> {
        let number = match at.get_ref() {
            DeValue::Integer(integer) => Ratio::parse(integer.as_str()),
            DeValue::Float(float) => Ratio::parse(float.as_str()),
            _ => None,
        };
        if number.is_none() {
            self.wrong(at, "a decimal number");
        }
        number
    }

    fn rounding(&mut self, at: &Spanned<DeValue<'_>>) -> bool {
        let word = self.text(at);
        if !["down", "nearest"].contains(&word.as_str()) {
            self.unknown(at.span().start, "rounding", &word, ["down", "nearest"].into_iter());
        }
        word == "nearest"
    }

    /// Returns the entries of a map, given in place or by name.
    fn map<'t>(&mut self, at: &'t Spanned<DeValue<'_>>, maps: &Maps<'t>) -> Option<Vec<Entry<'t>>> {
        match at.get_ref() {
            DeValue::Table(table) => Some(table.iter().collect()),
            DeValue::String(name) => match maps.get(name.as_ref()) {
                Some(map) => Some(map.iter().collect()),
                None => {
                    self.unknown(at.span().start, "map", name, maps.keys().copied());
                    None
                }
            },
            _ => {
                self.wrong(at, "the name of a map or a table");
                None
            }
        }
    }

    /// Reads a state of the model: a word of its unit, or a number; `None` for "invalid".
    fn state(&mut self, value: Value, at: &Spanned<DeValue<'_>>) -> Option<i32> {
        let kind = value.unit().kind();
        match (at.get_ref(), kind) {
            (DeValue::Integer(_), None) => Some(self.number(at, 0..=i64::from(i32::MAX)) as i32),
            (DeValue::Boolean(flag), _) if value.unit() == Unit::Flag => Some(i32::from(*flag)),
            (DeValue::String(word), _) if word == Missing::Invalid.word() => None,
            (DeValue::String(word), kind) => self.word(value, kind, word, at.span().start),
            (DeValue::Integer(number), Some(_)) => self.word(value, kind, number.as_str(), at.span().start),
            _ => {
                self.wrong(at, "a word");
                None
            }
        }
    }

    /// Returns the number of a state's word; another spelling of it is an error that says the word.
    fn word(&mut self, value: Value, kind: Option<Kind>, word: &str, offset: usize) -> Option<i32> {
        let state = kind.and_then(|kind| kind.of_word(word));
        match (state, kind.and_then(|kind| kind.meant_by(word))) {
            (Some(_), _) => {}
            (None, Some(meant)) => {
                let text = format!("`{word}` is written `{}` in `{}`", meant.word, value.path());
                self.report.offset(offset, text);
            }
            (None, None) => {
                let known = states(value.unit()).iter().map(|state| state.word);
                let what = format!("state of `{}`", value.path());
                self.unknown(offset, &what, word, known.chain([Missing::Invalid.word()]));
            }
        }
        state.map(|state| state.number)
    }

    /// Returns raw value -> state: from the map, else from words that the value table and the model share.
    fn states(
        &mut self,
        value: Value,
        signal: &Signal,
        map: Vec<Entry<'_>>,
        offset: usize,
    ) -> Option<States> {
        let known = states(value.unit());
        if signal.number.is_float() {
            let text = format!("`{}` is a state, `{}` an IEEE float", value.path(), signal.name);
            self.report.offset(offset, text);
            return None;
        }
        let mut states = States::new();
        if value.unit() == Unit::Flag && signal.length == 1 && map.is_empty() {
            return Some(plain_flag());
        }
        for (raw, word) in &signal.values {
            if let Some(state) = known.iter().find(|state| state.word == word) {
                states.insert(*raw, Some(state.number));
            }
        }
        for (key, at) in &map {
            let name = key.get_ref().as_ref();
            // Several raw values may have one word: it stands for all of them.
            let mut raws: Vec<i64> =
                signal.values.iter().filter(|(_, word)| word == name).map(|(raw, _)| *raw).collect();
            if raws.is_empty() {
                let by_number = match name.strip_prefix("0x") {
                    Some(hex) => i64::from_str_radix(hex, 16).ok(),
                    None => name.parse().ok(),
                };
                let (lowest, highest) = signal.short_span();
                raws.extend(by_number.filter(|raw| (lowest..=highest).contains(raw)));
            }
            if raws.is_empty() {
                let candidates = signal.values.iter().map(|(_, word)| word.as_str());
                let near = did_you_mean(name, candidates);
                let text = format!("signal `{}` has no value `{name}`{near}", signal.name);
                self.report.offset(key.span().start, text);
                continue;
            }
            let state = self.state(value, at);
            states.extend(raws.into_iter().map(|raw| (raw, state)));
        }
        let missing = signal.values.iter().filter(|(raw, _)| !states.contains_key(raw));
        let missing: Vec<&str> = missing.map(|(_, word)| word.as_str()).collect();
        if !missing.is_empty() {
            let candidates: Vec<&str> = known.iter().map(|state| state.word).collect();
            let text = format!(
                "`{}` does not say what `{}` of `{}` means: map each to {} or invalid",
                value.path(),
                missing.join("`, `"),
                signal.name,
                if candidates.is_empty() { "a number".into() } else { candidates.join(", ") },
            );
            self.report.offset(offset, text);
        } else if states.is_empty() {
            let text = format!("`{}` needs a `map`: `{}` has no value table", value.path(), signal.name);
            self.report.offset(offset, text);
            return None;
        }
        Some(states)
    }

    /// Returns model counts as a function of the raw value, and by how many counts it is off at most.
    fn scale(&mut self, value: Value, signal: &Signal, said: &Said, offset: usize) -> Option<(Linear, f64)> {
        let unit = said.unit.as_ref().unwrap_or(&signal.unit);
        let Some(counts) = counts_per(value.unit(), unit) else {
            let text = format!(
                "`{}` is measured in {}, but `{}` has the unit \"{unit}\"",
                value.path(),
                accepted(value.unit()).join(" or "),
                signal.name,
            );
            self.report.offset(offset, text);
            return None;
        };
        let scale = near_scale(signal, said, counts);
        if scale.is_none() {
            let text = format!("`{}` does not fit in 31 bits of `{}`", signal.name, value.path());
            self.report.offset(offset, text);
        }
        scale
    }

    fn sent(&mut self, at: &Spanned<DeValue<'_>>, nodes: &[NodeRow], maps: &Maps<'_>) -> Vec<Tx> {
        let mut rows: Vec<Tx> = Vec::new();
        for (name, table) in self.table(at) {
            let Some((index, node)) = self.message(name, nodes) else { continue };
            let message = &self.network.messages[index];
            if node != Node::Cluster {
                let text = format!("`{}` is sent by `{}`, not by the cluster", message.name, message.sender);
                self.report.offset(name.span().start, text);
            }
            let mut row =
                Tx { message: index, cycle_ms: message.cycle_ms, checksum: None, signals: Vec::new() };
            for (key, value) in self.table(table) {
                match key.get_ref().as_ref() {
                    "cycle_ms" => row.cycle_ms = self.number(value, 10..=60_000) as u32,
                    // A signal of this name cannot be bound to anything else.
                    "checksum" => row.checksum = self.checksum(value, message),
                    signal => {
                        let Some(signal) = self.signal(signal, key.span().start, message) else { continue };
                        if !message.signals[signal].when.is_empty() {
                            let text = "the cluster sends no multiplexed signals";
                            self.report.offset(key.span().start, text);
                        }
                        if message.signals[signal].life.is_some() {
                            let text = "the life counter is counted by the sender and cannot be bound";
                            self.report.offset(key.span().start, text);
                        }
                        row.signals.extend(self.source(signal, message, value, maps));
                    }
                }
            }
            if row.cycle_ms == 0 {
                let text = format!("`{}` has no cycle time in the DBC: set `cycle_ms`", message.name);
                self.report.offset(name.span().start, text);
            }
            row.signals.sort_by_key(|signal| signal.signal);
            rows.push(row);
        }
        rows.sort_by_key(|row| self.network.messages[row.message].id);
        rows
    }

    fn source(
        &mut self,
        index: usize,
        message: &Message,
        at: &Spanned<DeValue<'_>>,
        maps: &Maps<'_>,
    ) -> Option<TxSignal> {
        const KEYS: [&str; 5] = ["bits", "from", "map", "missing", "round"];
        let signal = &message.signals[index];
        let (mut path, mut nearest, mut missing, mut part) = (None, false, None, None);
        let mut map_at = None;
        match at.get_ref() {
            DeValue::String(text) => path = Some((text.to_string(), at.span().start)),
            DeValue::Table(table) => {
                for (key, value) in table.iter() {
                    match key.get_ref().as_ref() {
                        "from" => path = Some((self.text(value), value.span().start)),
                        "round" => nearest = self.rounding(value),
                        "map" => map_at = Some(value),
                        "missing" => {
                            let (lowest, highest) = signal.short_span();
                            missing = Some(self.number(value, lowest..=highest));
                        }
                        "bits" => part = self.part(value, signal),
                        other => self.unknown(key.span().start, "key", other, KEYS.into_iter()),
                    }
                }
            }
            _ => self.wrong(at, "the path of a model value"),
        }
        let Some((path, offset)) = path else {
            self.report.offset(at.span().start, format!("`{}` needs a `from`", signal.name));
            return None;
        };
        let Some(value) = Value::from_path(&path) else {
            self.unknown(offset, "model value", &path, Value::ALL.iter().map(|value| value.path()));
            return None;
        };
        if signal.number.is_float() {
            let text = format!(
                "`{}` is an IEEE float (SIG_VALTYPE_): the cluster sends whole numbers only",
                signal.name
            );
            self.report.offset(at.span().start, text);
            return None;
        }
        let usual = signal.invalid_raw.unwrap_or(signal.start_raw);
        // Only a raw value of 64 bits without a sign can be longer; it is sent by its bits.
        let missing = missing.unwrap_or(usual as i64);
        let how = if map_at.is_some() || value.unit().kind().is_some() {
            let map = match map_at {
                Some(at) => self.map(at, maps)?,
                None => Vec::new(),
            };
            // A flag in the raw values 0 and 1 needs no words, whatever the value table calls them.
            let plain = signal.values.is_empty() || signal.range == (0, 1);
            let states = match value.unit() == Unit::Flag && map.is_empty() && plain {
                true => plain_flag(),
                false => self.states(value, signal, map, at.span().start)?,
            };
            let mut back = BTreeMap::new();
            for (raw, state) in states {
                if let Some(state) = state {
                    back.entry(state).or_insert(raw);
                }
            }
            HowBack::Mapped(back)
        } else {
            self.back(value, signal, nearest, part, at.span().start)?
        };
        Some(TxSignal { signal: index, value, how, missing })
    }

    fn part(&mut self, at: &Spanned<DeValue<'_>>, signal: &Signal) -> Option<(u8, u8)> {
        let DeValue::Array(list) = at.get_ref() else {
            self.wrong(at, "a list of two numbers, lowest bit and length,");
            return None;
        };
        let numbers: Vec<i64> = list.iter().map(|at| self.number(at, 0..=32)).collect();
        match numbers.as_slice() {
            [low, length] if low + length <= 32 && *length == i64::from(signal.length) => {
                Some((*low as u8, *length as u8))
            }
            _ => {
                let text = format!("`bits` needs lowest bit and length, the length being {}", signal.length);
                self.report.offset(at.span().start, text);
                None
            }
        }
    }

    fn back(
        &mut self,
        value: Value,
        signal: &Signal,
        nearest: bool,
        part: Option<(u8, u8)>,
        offset: usize,
    ) -> Option<HowBack> {
        let counts = counts_per(value.unit(), &signal.unit);
        let Some(counts) = counts else {
            self.scale(value, signal, &Said::default(), offset);
            return None;
        };
        let back = scaled_by(signal, &Said::default(), counts).and_then(|(factor, _)| {
            let offset = Ratio::ZERO.checked_sub(signal.offset)?.checked_div(signal.factor)?;
            Some((Ratio::whole(1).checked_div(factor)?, offset))
        });
        let counts_at =
            |raw: i128| (raw as f64 * signal.factor.approximately() + signal.offset.approximately()) as i128;
        let span = (counts_at(signal.range.0), counts_at(signal.range.1));
        let linear = back.and_then(|(factor, offset)| Linear::near(factor, offset, span));
        let linear = linear.filter(|(_, off)| *off <= 0.5).map(|(linear, _)| linear);
        if linear.is_none() {
            let text = format!("`{}` cannot be computed from `{}` in 31 bits", signal.name, value.path());
            self.report.offset(offset, text);
        }
        let linear = linear?;
        Some(match part {
            Some((low, length)) => HowBack::Part { linear, low, length },
            None => HowBack::Scaled { linear, nearest },
        })
    }

    fn faults(&mut self, at: &Spanned<DeValue<'_>>, nodes: &[NodeRow]) -> Vec<Fault> {
        let mut rows: Vec<Fault> = Vec::new();
        for (source, table) in self.table(at) {
            let mut sources: Vec<Node> = self.fault_source(source.get_ref(), source.span().start, nodes);
            let mut codes = None;
            for (key, value) in self.table(table) {
                match (key.get_ref().as_ref(), value.get_ref()) {
                    ("also", DeValue::Array(list)) => {
                        for at in list.iter() {
                            let name = self.text(at);
                            sources.extend(self.fault_source(&name, at.span().start, nodes));
                        }
                    }
                    ("codes", DeValue::Array(list)) => codes = Some(list),
                    ("also" | "codes", _) => self.wrong(value, "a list"),
                    (other, _) => self.unknown(key.span().start, "key", other, ["also", "codes"].into_iter()),
                }
            }
            for row in codes.into_iter().flat_map(|list| list.iter()) {
                self.fault(row, &sources, &mut rows);
            }
        }
        rows.sort_by_key(|fault| (fault.source, fault.code));
        rows
    }

    fn fault_source(&mut self, name: &str, offset: usize, nodes: &[NodeRow]) -> Vec<Node> {
        let found = nodes.iter().find(|row| row.dbc == name).map(|row| row.node);
        if found.is_none() {
            self.unknown(offset, "[nodes] entry", name, nodes.iter().map(|row| row.dbc.as_str()));
        }
        found.into_iter().collect()
    }

    fn fault(&mut self, at: &Spanned<DeValue<'_>>, sources: &[Node], rows: &mut Vec<Fault>) {
        let (mut code, mut severity, mut zh, mut en) = (0, None, String::new(), String::new());
        let (mut fire, mut limps) = (false, false);
        for (key, value) in self.table(at) {
            match key.get_ref().as_ref() {
                "code" => code = self.number(value, 1..=0xFFFF) as u16,
                "level" => {
                    let word = self.text(value);
                    severity = Severity::from_word(&word).filter(|severity| *severity != Severity::None);
                    if severity.is_none() {
                        let known = Severity::ALL.iter().filter(|severity| **severity != Severity::None);
                        self.unknown(
                            value.span().start,
                            "level",
                            &word,
                            known.map(|severity| severity.word()),
                        );
                    }
                }
                name @ ("fire" | "limps") => match value.get_ref() {
                    DeValue::Boolean(flag) if name == "fire" => fire = *flag,
                    DeValue::Boolean(flag) => limps = *flag,
                    _ => self.wrong(value, "true or false"),
                },
                "zh" => zh = self.text(value),
                "en" => en = self.text(value),
                other => {
                    let known = ["code", "level", "fire", "limps", "zh", "en"];
                    self.unknown(key.span().start, "key", other, known.into_iter());
                }
            }
        }
        if code == 0 || zh.is_empty() || en.is_empty() {
            self.report.offset(at.span().start, "a fault needs `code`, `zh` and `en`");
        }
        for &source in sources {
            if rows.iter().any(|row| row.source == source && row.code == code) {
                self.report.offset(at.span().start, format!("code {code} is named twice for this source"));
            }
            rows.push(Fault { source, code, severity, fire, limps, zh: zh.clone(), en: en.clone() });
        }
    }
}
