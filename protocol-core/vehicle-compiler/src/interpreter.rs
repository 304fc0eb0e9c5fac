//! A vehicle at run time: decodes and encodes by the two files alone, nothing is generated or compiled.
//!
//! For tools on the PC. Values are those of the generated code, count for count: both follow the same binding, and a test
//! compares them (`xtask/tests/run_time.rs`). Nothing here is fast.

use crate::binding::{self, Binding, How, HowBack, RxValue, StreamRow, Term, TxSignal};
use crate::codec_text::validity;
use crate::diagnostics::{Diagnostic, Diagnostics, Grade};
use crate::network::{Condition, Message, Network, Signal};
use crate::number::Number;
use crate::ratio::Linear;
use crate::vehicle_text::field_bytes;
use crate::{encoding, gate};
use protocol_core::CanId;
use protocol_core::codec::{self, Scale};
use protocol_core::model::{INVALID, Reading, Readings, Unit};
use protocol_core::stream::{Bound, Cell, Stream};
use protocol_core::vehicle::{FaultText, Life, Node, NodeName, RxMessage, TxMessage, Vehicle};
use std::path::Path;
use std::sync::OnceLock;

/// A DBC file, and what its signals mean to a cluster if there is a `vehicle.toml` beside it.
pub struct RunTime {
    /// Name of the folder or of the file.
    pub name: String,
    /// What is on the wire.
    pub network: Network,
    binding: Option<Binding>,
    /// Warnings and notes of the DBC.
    pub findings: Diagnostics,
}

/// The vehicle of which [`RunTime::vehicle`] has made a table: its functions have no room for an argument of their own.
static PLAYED: OnceLock<&'static RunTime> = OnceLock::new();

fn text(path: &Path) -> Result<(String, String, Option<String>), Diagnostics> {
    let name = path.display().to_string();
    let bytes = std::fs::read(path)
        .map_err(|error| Diagnostics::one(&name, 0, format!("cannot be read: {error}")))?;
    let read = encoding::read(&name, bytes)?;
    Ok((name, read.text, read.note))
}

impl RunTime {
    /// Reads a DBC file without a `vehicle.toml`.
    ///
    /// # Errors
    /// If it is none.
    pub fn of_dbc(path: &Path) -> Result<Self, Diagnostics> {
        let (file, text, note) = text(path)?;
        let found = gate::read(&file, &text)?;
        let mut findings = found.findings;
        findings
            .0
            .extend(note.map(|note| Diagnostic { grade: Grade::Note, ..Diagnostic::new(&file, 0, note) }));
        let name = path.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        Ok(Self { name, network: found.network, binding: None, findings })
    }

    /// Reads the folder of a vehicle: its only DBC file, or the one of the folder's name, and its `vehicle.toml`.
    ///
    /// # Errors
    /// Everything that is wrong with the two files.
    pub fn of_folder(folder: &Path) -> Result<Self, Diagnostics> {
        let shown = folder.display().to_string();
        let folder = folder.canonicalize().map_err(|error| Diagnostics::one(&shown, 0, error.to_string()))?;
        let name = folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let mut run_time = Self::of_dbc(&dbc_of(&folder, &name, &shown)?)?;
        let (file, toml, _) = text(&folder.join("vehicle.toml"))?;
        let dbc = format!("{name}.dbc");
        run_time.binding = Some(binding::read(&file, &toml, &dbc, &run_time.network)?);
        run_time.name = name;
        Ok(run_time)
    }

    /// Reads texts, each with the name that stands in diagnostics.
    ///
    /// # Errors
    /// Everything that is wrong with them.
    pub fn of_texts(name: &str, dbc: (&str, &str), toml: Option<(&str, &str)>) -> Result<Self, Diagnostics> {
        let found = gate::read(dbc.0, dbc.1)?;
        let bound = |(file, text)| binding::read(file, text, dbc.0, &found.network);
        let binding = toml.map(bound).transpose()?;
        Ok(Self { name: name.into(), network: found.network, binding, findings: found.findings })
    }

    pub(crate) fn binding(&self) -> Option<&Binding> {
        self.binding.as_ref()
    }

    /// Returns how many messages are received.
    pub fn received(&self) -> usize {
        self.binding.as_ref().map_or(0, |binding| binding.rx.len())
    }

    /// Decodes the 8 bytes of received message `index` into the readings.
    pub fn decode(&self, index: u8, data: &[u8; 8], readings: &mut Readings) {
        let row = self.binding.as_ref().and_then(|binding| binding.rx.get(usize::from(index)));
        let Some(row) = row else { return };
        let filler = self.binding.as_ref().map_or(&[][..], |binding| &binding.filler);
        let message = &self.network.messages[row.message];
        for value in &row.values {
            let holds =
                |condition: &Condition| condition.holds(message.signals[condition.selector].raw(data));
            if value.when(message).iter().all(holds) {
                let number = number(value, message, data, filler);
                readings.put(index, value.value, number.unwrap_or(0), number.is_some());
            }
        }
    }

    /// Encodes sent message `index` from what the cluster knows.
    pub fn encode(&self, index: u8, values: &Readings) -> [u8; 8] {
        let row = self.binding.as_ref().and_then(|binding| binding.tx.get(usize::from(index)));
        let Some(row) = row else { return [0; 8] };
        let message = &self.network.messages[row.message];
        let mut data = message.fill;
        for (at, signal) in message.signals.iter().enumerate().filter(|(_, signal)| signal.life.is_none()) {
            let bound = row.signals.iter().find(|bound| bound.signal == at);
            let raw = bound.map_or(signal.start_raw, |bound| raw(bound, signal, values).into());
            if bound.is_some() || raw != 0 {
                signal.set_raw(&mut data, raw);
            }
        }
        data
    }

    /// Makes the table that a cluster works with. It stays for the whole process, and a process has one such vehicle.
    ///
    /// # Errors
    /// If there is no `vehicle.toml`, or one was made before.
    pub fn vehicle(&'static self) -> Result<&'static Vehicle, String> {
        let Some(binding) = &self.binding else {
            return Err(format!("`{}` is a DBC file without a vehicle.toml", self.name));
        };
        PLAYED.set(self).map_err(|_| "a process plays one vehicle that is read at run time".to_owned())?;
        Ok(Box::leak(Box::new(self.table(binding))))
    }

    fn table(&'static self, binding: &'static Binding) -> Vehicle {
        Vehicle {
            name: &self.name,
            zh: &binding.zh,
            en: &binding.en,
            bitrate: binding.bitrate,
            rx: self.received_rows(binding),
            decode: |index, data, readings| {
                if let Some(played) = PLAYED.get() {
                    played.decode(index, data, readings);
                }
            },
            streams: kept(binding.streams.iter().map(|row| self.stream(row, binding))),
            ids: self.identifiers(binding),
            tx: kept(binding.tx.iter().map(|row| {
                let message = &self.network.messages[row.message];
                TxMessage {
                    id: CanId::from_packed(message.id),
                    name: &message.name,
                    cycle_ms: row.cycle_ms,
                    life: life(message),
                    checksum: row.checksum,
                }
            })),
            encode: |index, values| PLAYED.get().map_or([0; 8], |played| played.encode(index, values)),
            worst_level: binding.worst_level,
            rules: binding.rules,
            faults: kept(binding.faults.iter().map(|row| FaultText {
                source: row.source,
                code: row.code,
                severity: row.severity,
                fire: row.fire,
                limps: row.limps,
                zh: &row.zh,
                en: &row.en,
            })),
            nodes: kept(binding.nodes.iter().map(|row| NodeName {
                node: row.node,
                zh: &row.zh,
                en: &row.en,
            })),
        }
    }

    fn received_rows(&'static self, binding: &'static Binding) -> &'static [RxMessage] {
        kept(binding.rx.iter().map(|row| {
            let message = &self.network.messages[row.message];
            RxMessage {
                id: CanId::from_packed(message.id),
                name: &message.name,
                node: row.node,
                len: row.len,
                cycle_ms: row.cycle_ms,
                timeout_ms: row.timeout_ms,
                life: life(message),
                checksum: row.checksum,
                expected: row.expected,
                vital: row.vital,
            }
        }))
    }

    /// Returns the identifiers of all messages that the cluster does not send itself, sorted.
    fn identifiers(&self, binding: &Binding) -> &'static [CanId] {
        let own = binding.nodes.iter().find(|row| row.node == Node::Cluster).map(|row| row.dbc.as_str());
        let others = self.network.messages.iter().filter(|message| message.doubt.is_none());
        let others = others.filter(|message| Some(message.sender.as_str()) != own);
        let mut ids: Vec<CanId> = others.map(|message| CanId::from_packed(message.id)).collect();
        ids.sort_unstable();
        kept(ids)
    }

    fn stream(&'static self, row: &'static StreamRow, binding: &Binding) -> Stream {
        let message = &self.network.messages[row.first];
        let [highest, lowest, highest_number, lowest_number, count] = row.bound;
        let Linear { mul, add, den } = row.scale;
        Stream {
            name: &row.name,
            row: binding.rx.iter().position(|rx| rx.message == row.first).unwrap_or(usize::MAX) as u8,
            first: CanId::from_packed(message.id),
            step: row.step as i32,
            frames: row.frames as u8,
            len: message.len,
            zeros_pad: row.zeros_pad,
            start: row.start as u16,
            size: row.size as u16,
            valid: row.valid,
            scale: Scale { mul: mul as i32, add: add as i32, den: den as u32 },
            cells: kept(row.cells.iter().map(|(number, value)| Cell { number: *number, value: *value })),
            bound: Bound { highest, lowest, highest_number, lowest_number, count },
        }
    }
}

/// Returns the DBC file of a folder: the one of its name, else the only one.
fn dbc_of(folder: &Path, name: &str, shown: &str) -> Result<std::path::PathBuf, Diagnostics> {
    let named = folder.join(format!("{name}.dbc"));
    if named.is_file() {
        return Ok(named);
    }
    let entries = std::fs::read_dir(folder)
        .map_err(|error| Diagnostics::one(shown, 0, format!("cannot be read: {error}")))?;
    let is_dbc =
        |path: &std::path::PathBuf| path.extension().is_some_and(|end| end.eq_ignore_ascii_case("dbc"));
    let found: Vec<std::path::PathBuf> = entries.flatten().map(|entry| entry.path()).filter(is_dbc).collect();
    match found.as_slice() {
        [one] => Ok(one.clone()),
        many => Err(Diagnostics::one(shown, 0, format!("holds {} DBC files and no {name}.dbc", many.len()))),
    }
}

fn kept<T>(rows: impl IntoIterator<Item = T>) -> &'static [T] {
    Vec::leak(rows.into_iter().collect())
}

fn life(message: &Message) -> Option<Life> {
    let segment = *message.life()?.segments().first()?;
    Some(Life { byte: segment.byte, mask: (((1u16 << segment.bits) - 1) << segment.low) as u8 })
}

/// Returns the counts of a model value in a frame, `None` if it is invalid.
///
/// Bit fields in a byte of filler say nothing; of several, one that reports something stands although others are filler.
fn number(value: &RxValue, message: &Message, data: &[u8; 8], filler: &[u8]) -> Option<i32> {
    let in_filler = |terms: &[Term]| {
        let bytes = field_bytes(terms, message);
        bytes.iter().any(|byte| filler.contains(&data[usize::from(*byte)]))
    };
    let is_unknown = in_filler(&value.terms);
    let of = |term: &Term| {
        let signal = &message.signals[term.signal];
        counts(term, signal, signal.raw(data))
    };
    if value.value.unit() == Unit::Bits {
        let is_set = |term: &Term| {
            let stands = matches!(term.how, How::Mapped { other: Some(0), .. })
                || !in_filler(std::slice::from_ref(term));
            stands && of(term).is_some_and(|bit| bit != 0)
        };
        let bits = value.terms.iter().enumerate().map(|(bit, term)| i32::from(is_set(term)) << bit);
        let bits = bits.fold(0, |all, bit| all | bit);
        return (bits != 0 || !is_unknown).then_some(bits);
    }
    let fields = field_bytes(&value.terms, message);
    if let ([term], true) = (value.terms.as_slice(), fields.is_empty() && filler.contains(&0xFF)) {
        let signal = &message.signals[term.signal];
        let is_whole = signal.length.is_multiple_of(8) && !signal.signed();
        let is_free = matches!(term.how, How::Scaled { .. }) && validity(signal, "raw").is_empty();
        if is_free && is_whole && signal.raw(data) == signal.span().1 {
            return None;
        }
    }
    // Of several, the worst: one that is invalid is less than all states.
    let believed = |term: &Term| of(term).filter(|_| !in_filler(std::slice::from_ref(term)));
    let worst = value.terms.iter().map(|term| believed(term).unwrap_or(INVALID)).max()?;
    let reports = fields.len() > 1 && value.terms.len() > 1 && worst > 0;
    (reports || worst != INVALID && !is_unknown).then_some(worst)
}

fn counts(term: &Term, signal: &Signal, raw: i128) -> Option<i32> {
    let sized = |number: i32, magnitude: bool| if magnitude { number.abs() } else { number };
    let half = |linear: &Linear, nearest: bool| if nearest { linear.den / 2 } else { 0 };
    match &term.how {
        How::Mapped { states, other } => {
            let state = i64::try_from(raw).ok().and_then(|raw| states.get(&raw));
            state.copied().unwrap_or(*other)
        }
        How::Float { linear, nearest, magnitude } => {
            let add = linear.add + half(linear, *nearest);
            let counts = match signal.number {
                Number::Float32 => codec::float32_counts(raw as u32, linear.mul, add, linear.den),
                _ => codec::float64_counts(raw as u64, linear.mul, add, linear.den),
            };
            (counts != INVALID && signal.is_valid(raw)).then(|| sized(counts, *magnitude))
        }
        How::Scaled { linear, nearest, magnitude, .. } => {
            let Linear { mul, add, den } = *linear;
            let sum = raw * i128::from(mul) + i128::from(add + half(linear, *nearest));
            let counts = i32::try_from(sum.div_euclid(den.into())).ok().filter(|_| signal.is_valid(raw))?;
            Some(sized(counts, *magnitude))
        }
    }
}

/// Returns the raw value that a model value is sent as.
fn raw(bound: &TxSignal, signal: &Signal, values: &Readings) -> i64 {
    let Some((Reading::Valid(known), _)) = values.get(bound.value) else { return bound.missing };
    let scaled = |linear: &Linear, nearest: bool, low: i64, high: i64| {
        let add = if nearest { linear.add + linear.den / 2 } else { linear.add };
        codec::scaled(known, linear.mul, add, linear.den, low, high)
    };
    let short = |raw: i128| raw.clamp(i64::MIN.into(), i64::MAX.into()) as i64;
    match &bound.how {
        HowBack::Scaled { linear, nearest } => {
            scaled(linear, *nearest, short(signal.range.0), short(signal.range.1))
        }
        HowBack::Part { linear, low, length } => {
            let number = scaled(linear, false, 0, i64::from(u32::MAX));
            number >> low & ((1 << length) - 1)
        }
        HowBack::Mapped(states) => {
            // A flag in the raw values 0 and 1 is set by any number but 0.
            let is_plain = bound.value.unit() == Unit::Flag && states.iter().eq([(&0, &0), (&1, &1)]);
            let state = if is_plain { i32::from(known != 0) } else { known };
            states.get(&state).copied().unwrap_or(bound.missing)
        }
    }
}
