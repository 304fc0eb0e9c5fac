//! Rows, getters and setters of every vehicle against cantools, which read the same DBC independently.
//!
//! `tools/witness/decode_witness.py` streams rows and frames; each raw value of each signal of up to 16 bits is met, and
//! random frames besides. Physical values are compared as fractions, never as floats. Runs with the interpreter in
//! `WITNESS_PYTHON`, else the one that `cargo xtask test` installs, else `python3`.

mod fleet;

use fleet::{Car, fleet};
use protocol_core::codec::{MessageInfo, Mux, Order, SignalInfo};
// The generated file names these as parts of its own crate.
use protocol_core::{checksum, codec, frame, model, stream, vehicle};
use serde_json::Value as Json;
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Stdio};
use surroundings::{need, root};

#[path = "codec_torture/torture.rs"]
#[rustfmt::skip]
#[allow(clippy::all, clippy::cast_lossless, dead_code, missing_docs, unreachable_pub, unused_imports)]
mod torture;

/// A signal that is not in the frame.
const ABSENT: i64 = i64::MIN;

/// A fraction of the witness, with a positive denominator.
#[derive(Clone, Copy)]
struct Fraction(i128, i128);

impl Fraction {
    fn read(json: &Json) -> Option<Self> {
        let (numerator, denominator) = json.as_str()?.split_once('/')?;
        Some(Self(numerator.parse().ok()?, denominator.parse().ok()?))
    }

    /// Returns `raw * self + offset`.
    fn scale(self, raw: i64, offset: Self) -> Self {
        Self(i128::from(raw) * self.0 * offset.1 + offset.0 * self.1, self.1 * offset.1)
    }

    fn at_most(self, other: Self) -> bool {
        self.0 * other.1 <= other.0 * self.1
    }
}

/// What the witness says of one signal.
struct Row {
    /// Index of the signal in the order of the file; cantools orders by place.
    index: usize,
    scale: Fraction,
    offset: Fraction,
    range: Option<(Fraction, Fraction)>,
}

impl Row {
    fn read(message: &MessageInfo, json: &Json) -> Self {
        let index = message.signals.iter().position(|info| json["name"] == info.name);
        let index = index.unwrap_or_else(|| panic!("{} has no row for {}", message.name, json["name"]));
        same_row(&message.signals[index], json);
        let fraction = |key: &str| Fraction::read(&json[key]);
        Self {
            index,
            scale: fraction("scale").expect("a fraction"),
            offset: fraction("offset").expect("a fraction"),
            range: fraction("minimum").zip(fraction("maximum")),
        }
    }

    /// Returns the physical value of a valid raw value.
    fn physical(&self, raw: i64, info: &SignalInfo) -> Option<Fraction> {
        let value = self.scale.scale(raw, self.offset);
        let inside = self.range.is_none_or(|(low, high)| low.at_most(value) && value.at_most(high));
        // "Not available" is an attribute of ours that cantools does not interpret.
        (inside && info.invalid_raw != Some(raw)).then_some(value)
    }
}

fn same_row(info: &SignalInfo, json: &Json) {
    let name = info.name;
    assert_eq!(u64::from(info.start), json["start"], "start bit of {name}");
    assert_eq!(u64::from(info.length), json["length"], "length of {name}");
    assert_eq!(info.order == Order::Intel, json["intel"], "byte order of {name}");
    assert_eq!(info.signed, json["signed"], "sign of {name}");
    assert_eq!(info.unit, json["unit"], "unit of {name}");
    assert_eq!(info.mux == Mux::Selector, json["selector"], "multiplexer {name}");
    let when = if let Mux::When(when) = info.mux { Json::from(when) } else { Json::Null };
    assert_eq!(when, json["when"], "multiplex value of {name}");
    let words: Vec<Json> = info.values.iter().map(|(raw, word)| serde_json::json!([raw, word])).collect();
    assert_eq!(Json::from(words), json["words"], "value table of {name}");
}

/// Counts of what was compared.
#[derive(Default)]
struct Tally {
    frames: u64,
    values: u64,
    encoded: u64,
}

fn compare_frame(
    message: &MessageInfo,
    rows: &[Row],
    data: [u8; 8],
    raws: &[i64],
    encoded: bool,
    tally: &mut Tally,
) {
    let name = message.name;
    tally.frames += 1;
    for (row, &raw) in rows.iter().zip(raws) {
        let info = &message.signals[row.index];
        assert_eq!(message.carries(info, &data), raw != ABSENT, "{name}.{} in {data:02X?}", info.name);
        if raw == ABSENT {
            continue;
        }
        tally.values += 1;
        assert_eq!(info.raw(&data), raw, "row of {name}.{} reads {data:02X?}", info.name);
        let (got, physical) = (message.get)(row.index, data).expect("a getter for every row");
        assert_eq!(got, raw, "getter of {name}.{} reads {data:02X?}", info.name);
        assert_eq!(info.physical(raw), physical, "row and getter of {name}.{}, raw {raw}", info.name);
        let expected = row.physical(raw, info);
        assert_eq!(physical.is_some(), expected.is_some(), "validity of {name}.{}, raw {raw}", info.name);
        if let (Some(counts), Some(Fraction(numerator, denominator))) = (physical, expected) {
            let equal = i128::from(counts) * denominator == numerator * i128::from(info.scale.den);
            assert!(
                equal,
                "{name}.{}, raw {raw}: {counts}/{} is not {numerator}/{denominator}",
                info.name, info.scale.den
            );
        }
    }
    if encoded {
        tally.encoded += 1;
        let (mut by_row, mut by_setter) = ([0; 8], [0; 8]);
        for (row, &raw) in rows.iter().zip(raws).filter(|(_, raw)| **raw != ABSENT) {
            message.signals[row.index].set_raw(&mut by_row, raw);
            by_setter = (message.set)(row.index, by_setter, raw);
        }
        assert_eq!(by_row, data, "{name} written by rows");
        assert_eq!(by_setter, data, "{name} written by setters");
    }
}

/// Returns how many frames hold every raw value of every signal of up to 16 bits, one message after the other.
fn sweep(messages: &[MessageInfo]) -> u64 {
    let longest = |message: &MessageInfo| message.signals.iter().map(|signal| signal.length.min(16)).max();
    messages.iter().map(|message| (1 << longest(message).unwrap_or(0)).max(256)).sum()
}

/// Compares all messages of a DBC file, named from the root of the repository, with the witness.
fn compare(dbc: &str, messages: &'static [MessageInfo]) {
    let at_least = sweep(messages);
    let Some(python) = need::witness(dbc) else { return };
    let mut child = Command::new(python)
        .arg(root().join("tools/witness/decode_witness.py"))
        .arg(root().join(dbc))
        .stdout(Stdio::piped())
        .spawn()
        .expect("the interpreter starts");
    let mut stream = BufReader::with_capacity(1 << 20, child.stdout.take().expect("a pipe"));
    let mut header = String::new();
    stream.read_line(&mut header).expect("the header line");
    let header: Vec<Json> = serde_json::from_str(&header).expect("the witness's own message is above");
    assert_eq!(messages.len(), header.len(), "number of messages of {dbc}");

    let mut rows: Vec<Vec<Row>> = Vec::new();
    for (message, json) in messages.iter().zip(&header) {
        assert_eq!(message.name, json["name"]);
        assert_eq!(u64::from(message.id.bits()), json["id"], "identifier of {}", message.name);
        assert_eq!(message.id.is_extended(), json["extended"], "identifier of {}", message.name);
        assert_eq!(u64::from(message.len), json["length"], "length of {}", message.name);
        assert_eq!(message.sender, json["sender"], "sender of {}", message.name);
        assert_eq!(u64::from(message.cycle_ms), json["cycle"], "cycle of {}", message.name);
        let signals = json["signals"].as_array().expect("a list");
        assert_eq!(message.signals.len(), signals.len(), "number of signals of {}", message.name);
        rows.push(signals.iter().map(|json| Row::read(message, json)).collect());
    }

    let mut tally = Tally::default();
    let mut head = [0; 9];
    while stream.read_exact(&mut head).is_ok() {
        let number =
            |at: usize| u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]) as usize;
        let (message, rows) = (&messages[number(0)], &rows[number(0)]);
        let mut record = vec![0; 8 + 8 * rows.len()];
        let mut raws = vec![0; rows.len()];
        for _ in 0..number(4) {
            stream.read_exact(&mut record).expect("a whole record");
            let (data, values) = record.split_at(8);
            for (raw, bytes) in raws.iter_mut().zip(values.chunks_exact(8)) {
                *raw = i64::from_le_bytes(bytes.try_into().expect("8 bytes"));
            }
            let data: [u8; 8] = data.try_into().expect("8 bytes");
            compare_frame(message, rows, data, &raws, head[8] == 1, &mut tally);
        }
    }
    assert!(
        child.wait().expect("the witness ends").success(),
        "the witness failed; its own message is above"
    );
    assert!(tally.frames >= at_least, "only {} frames of {at_least} came from {dbc}", tally.frames);
    println!(
        "{dbc}: {} frames, {} values and {} written frames as cantools has them",
        tally.frames, tally.values, tally.encoded
    );
}

#[test]
fn every_raw_value_of_every_vehicle_decodes_as_cantools_says() {
    std::thread::scope(|scope| {
        for Car { vehicle, messages, folder } in fleet() {
            scope.spawn(move || compare(&format!("{folder}/{}.dbc", vehicle.name), messages));
        }
    });
}

#[test]
fn crooked_signed_short_and_multiplexed_signals_decode_as_cantools_says() {
    compare("protocol-core/tests/codec_torture/torture.dbc", torture::MESSAGES);
}
