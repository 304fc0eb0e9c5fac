//! The bus as a person reads it: one row per identifier, the last frames, decoded signals.
//!
//! Owns counts, periods and which bytes have changed. What a page gets at once is bounded: rows that have changed, and
//! the newest frames; the rest is counted as skipped. Refuses to keep a frame that has been told.

use bench::can::{Frame, Id};
use bench::rig::Heard;
use bench::time::Nanos;
use protocol_core::CanId;
use protocol_core::codec::MessageInfo;
use protocol_core::generated::MESSAGES;
use serde::Serialize;
use std::collections::{BTreeMap, VecDeque};

/// Frames that one update tells of.
const FRAMES_MAX: usize = 120;
/// Identifiers that are told apart; a node that babbles through all of them must not fill the memory.
const IDS_MAX: usize = 512;
/// Weight of the newest distance in the period.
const PERIOD_WEIGHT: f64 = 0.2;

/// The last frame of one identifier.
struct Row {
    count: u64,
    at: Nanos,
    frame: Frame,
    by_cluster: bool,
    period_ms: Option<f64>,
    /// Bytes that have changed since the row was told, bit n = byte n.
    changed: u8,
    told: bool,
}

/// One row as it is told: identifier, frames so far, time in ms, period in ms, data, changed bytes, sent by the cluster.
#[derive(Debug, PartialEq, Serialize)]
pub(crate) struct RowUpdate(String, u64, f64, Option<f64>, String, u8, bool);

/// One frame as it is told: time in ms, identifier, data, sent by the cluster.
#[derive(Debug, PartialEq, Serialize)]
pub(crate) struct FrameUpdate(f64, String, String, bool);

/// What happened on the bus since the last update.
#[derive(Debug, Default, PartialEq, Serialize)]
pub(crate) struct BusUpdate {
    rows: Vec<RowUpdate>,
    frames: Vec<FrameUpdate>,
    /// Frames before those in `frames` that are not told one by one.
    skipped: u64,
}

/// Frames on the bus since the bench started.
#[derive(Default)]
pub(crate) struct Trace {
    rows: BTreeMap<(bool, u32), Row>,
    latest: VecDeque<Heard>,
    skipped: u64,
}

impl Trace {
    pub(crate) fn hear(&mut self, heard: &Heard) {
        if self.latest.len() == FRAMES_MAX {
            self.latest.pop_front();
            self.skipped += 1;
        }
        self.latest.push_back(*heard);
        let key = (heard.frame.id.is_extended(), heard.frame.id.raw());
        let Some(row) = self.rows.get_mut(&key) else {
            if self.rows.len() < IDS_MAX {
                self.rows.insert(key, Row::new(heard));
            }
            return;
        };
        row.hear(heard);
    }

    /// Takes what is new; `whole` = every row, for a page that has just come.
    pub(crate) fn take(&mut self, whole: bool) -> BusUpdate {
        let rows = self.rows.values_mut().filter(|row| whole || !row.told).map(Row::tell).collect();
        let frames = self.latest.drain(..).map(|heard| {
            let frame = &heard.frame;
            FrameUpdate(millis(heard.at), id_text(frame.id), data_text(frame), heard.by_cluster)
        });
        BusUpdate { rows, frames: frames.collect(), skipped: std::mem::take(&mut self.skipped) }
    }
}

impl Row {
    fn new(heard: &Heard) -> Self {
        Self {
            count: 1,
            at: heard.at,
            frame: heard.frame,
            by_cluster: heard.by_cluster,
            period_ms: None,
            changed: 0,
            told: false,
        }
    }

    fn hear(&mut self, heard: &Heard) {
        let distance = millis(heard.at.since(self.at));
        self.period_ms = Some(self.period_ms.map_or(distance, |old| old + (distance - old) * PERIOD_WEIGHT));
        for (index, (old, new)) in self.frame.data.iter().zip(&heard.frame.data).enumerate() {
            self.changed |= u8::from(old != new) << index;
        }
        self.count += 1;
        (self.at, self.frame, self.by_cluster, self.told) = (heard.at, heard.frame, heard.by_cluster, false);
    }

    fn tell(&mut self) -> RowUpdate {
        self.told = true;
        RowUpdate(
            id_text(self.frame.id),
            self.count,
            millis(self.at),
            self.period_ms,
            data_text(&self.frame),
            std::mem::take(&mut self.changed),
            self.by_cluster,
        )
    }
}

/// A message as the page lists it.
#[derive(Debug, Serialize)]
pub(crate) struct Named {
    id: String,
    name: &'static str,
    sender: &'static str,
    /// Milliseconds from one frame to the next, 0 = not periodic.
    cycle_ms: u32,
}

/// Returns the messages of one vehicle, or of all.
pub(crate) fn messages(vehicle: Option<&str>) -> Vec<Named> {
    let of = MESSAGES.iter().filter(|(name, _)| vehicle.is_none_or(|vehicle| vehicle == *name));
    of.flat_map(|(_, messages)| *messages)
        .map(|message| Named {
            id: message.id.to_string().trim_start_matches("0x").to_owned(),
            name: message.name,
            sender: message.sender,
            cycle_ms: message.cycle_ms,
        })
        .collect()
}

/// A decoded signal.
#[derive(Debug, PartialEq, Serialize)]
pub(crate) struct Signal {
    name: &'static str,
    raw: i64,
    /// The physical value, valid or not.
    value: f64,
    unit: &'static str,
    /// The sender may send it as a value.
    valid: bool,
    /// The word of the value table.
    word: Option<&'static str>,
}

/// Decodes one frame, given as the page shows it: `18FEF100` and `0102030405060708`.
///
/// # Errors
/// If one of them is not hexadecimal, or no vehicle has this message.
pub(crate) fn decode(id: &str, data: &str) -> Result<Vec<Signal>, String> {
    let raw = u32::from_str_radix(id, 16).map_err(|_| format!("`{id}` is not an identifier"))?;
    let wanted = match (id.len(), u16::try_from(raw)) {
        (3, Ok(short)) => CanId::standard(short),
        (8, _) => CanId::extended(raw),
        _ => return Err(format!("`{id}` has neither 3 nor 8 digits")),
    };
    let bytes = hexadecimal(data).ok_or_else(|| format!("`{data}` is not up to 8 bytes in hexadecimal"))?;
    let mut messages = MESSAGES.iter().flat_map(|(_, messages)| *messages);
    let message = messages.find(|message| message.id == wanted);
    message.map(|message| signals(message, &bytes)).ok_or_else(|| format!("no vehicle sends {id}"))
}

fn signals(message: &MessageInfo, data: &[u8; 8]) -> Vec<Signal> {
    let carried = message.signals.iter().filter(|signal| message.carries(signal, data));
    carried
        .map(|signal| {
            let raw = signal.raw(data);
            Signal {
                name: signal.name,
                raw,
                value: signal.scale.counts(raw) as f64 / f64::from(signal.scale.den.max(1)),
                unit: signal.unit,
                valid: signal.is_valid(raw),
                word: signal.word(raw),
            }
        })
        .collect()
}

fn hexadecimal(text: &str) -> Option<[u8; 8]> {
    let mut data = [0; 8];
    if !text.is_ascii() || !text.len().is_multiple_of(2) {
        return None;
    }
    for index in 0..text.len() / 2 {
        *data.get_mut(index)? = u8::from_str_radix(&text[index * 2..index * 2 + 2], 16).ok()?;
    }
    Some(data)
}

fn millis(at: Nanos) -> f64 {
    (at.0 / 1_000) as f64 / 1e3
}

fn id_text(id: Id) -> String {
    match id {
        Id::Standard(id) => format!("{:03X}", id.raw()),
        Id::Extended(id) => format!("{:08X}", id.raw()),
    }
}

fn data_text(frame: &Frame) -> String {
    if frame.remote { "R".into() } else { frame.payload().iter().map(|byte| format!("{byte:02X}")).collect() }
}

/// Returns the signals of a frame as JSON: identifier and data as the page writes them.
///
/// # Errors
/// If no vehicle has a message of this identifier, or the data is no frame; in words for a person.
pub fn decode_to_json(id: &str, data: &str) -> Result<String, String> {
    serde_json::to_string(&decode(id, data)?).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heard(at_ms: u64, id: u16, data: &[u8]) -> Heard {
        let frame = Frame::new(Id::standard(id).unwrap(), data).unwrap();
        Heard { at: Nanos::from_millis(at_ms), frame, by_cluster: false }
    }

    #[test]
    fn a_row_tells_its_period_and_the_bytes_that_changed() {
        let mut trace = Trace::default();
        trace.hear(&heard(0, 0x123, &[1, 2, 3]));
        trace.take(false);
        trace.hear(&heard(100, 0x123, &[1, 9, 3]));
        trace.hear(&heard(200, 0x123, &[1, 9, 4]));
        let update = trace.take(false);
        assert_eq!(
            update.rows,
            [RowUpdate("123".into(), 3, 200.0, Some(100.0), "010904".into(), 0b110, false)]
        );
        assert_eq!(update.frames.len(), 2);
        assert_eq!(trace.take(false), BusUpdate::default(), "told once");
        assert_eq!(trace.take(true).rows.len(), 1, "a page that has just come gets every row");
    }

    #[test]
    fn a_flood_is_counted_and_not_kept() {
        let mut trace = Trace::default();
        for index in 0..2_048 {
            trace.hear(&heard(index, index as u16, &[]));
        }
        let update = trace.take(false);
        assert_eq!((update.rows.len(), update.frames.len()), (IDS_MAX, FRAMES_MAX));
        assert_eq!(update.skipped, 2_048 - FRAMES_MAX as u64);
        assert_eq!(update.frames.last().unwrap().1, "7FF");
    }

    #[test]
    fn a_frame_decodes_to_the_signals_of_its_vehicle() {
        let (_, known) = MESSAGES.iter().find(|(vehicle, _)| *vehicle == "citybus").unwrap();
        let speed = known.iter().find(|message| message.name == "VCU1").unwrap();
        let id = &messages(Some("citybus")).into_iter().find(|message| message.name == "VCU1").unwrap().id;
        let decoded = decode(id, "0000000000000000").unwrap();
        assert_eq!(decoded.len(), speed.signals.len());
        assert!(decoded.iter().any(|signal| signal.name == "vehicle_speed" && signal.unit == "km/h"));
    }

    #[test]
    fn what_cannot_be_decoded_says_why() {
        for (id, data) in
            [("xyz", "00"), ("12", "00"), ("123", "0"), ("123", "zz"), ("123", "001122334455667788")]
        {
            assert!(decode(id, data).is_err(), "{id} {data}");
        }
        assert_eq!(decode("7FF", "00"), Err("no vehicle sends 7FF".into()));
    }
}
