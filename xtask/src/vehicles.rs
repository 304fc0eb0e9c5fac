//! Which vehicle, which message, which number: what the commands that read and write frames share.
//!
//! Names are looked up exactly and the nearest one is offered. Numbers are exact decimals made from integers; no float takes part.

use anyhow::{Result, anyhow};
use bench::can::{Frame, Id};
use bench::log::Log;
use bench::time::Nanos;
use protocol_core::codec::{MessageInfo, SignalInfo};
use protocol_core::generated::{MESSAGES, VEHICLES};
use protocol_core::{CanFrame, CanId, Vehicle};
use vehicle_compiler::did_you_mean;

/// One vehicle with all of its messages, those of the other nodes too.
#[derive(Clone, Copy)]
pub struct Tables {
    /// What the cluster receives and sends.
    pub vehicle: &'static Vehicle,
    /// Every message of the DBC.
    pub messages: &'static [MessageInfo],
}

impl Tables {
    /// Returns every vehicle, sorted by name.
    pub fn all() -> impl Iterator<Item = Self> {
        let messages =
            |name: &str| MESSAGES.iter().find(|(of, _)| *of == name).map(|(_, messages)| *messages);
        VEHICLES.iter().filter_map(move |vehicle| Some(Self { vehicle, messages: messages(vehicle.name)? }))
    }

    /// Returns the vehicle of a name.
    ///
    /// # Errors
    /// If there is none; the error names the nearest and all.
    pub fn named(name: &str) -> Result<Self> {
        let names = || Self::all().map(|tables| tables.vehicle.name);
        Self::all().find(|tables| tables.vehicle.name == name).ok_or_else(|| {
            let near = did_you_mean(name, names());
            anyhow!("no vehicle is called `{name}`{near} (known: {})", names().collect::<Vec<_>>().join(", "))
        })
    }

    /// Returns the vehicle that most frames of a recording belong to, of those that an image can hold.
    pub fn of_log(log: &Log) -> Option<Self> {
        let ids: Vec<(CanId, usize)> = log.entries.iter().map(|entry| (can_id(entry.frame.id), 1)).collect();
        let heard = |tables: &Self| {
            let known = ids.iter().filter(|(id, _)| tables.message(*id).is_some());
            known.map(|(_, frames)| frames).sum::<usize>()
        };
        let best = Self::all().map(|tables| (heard(&tables), tables)).max_by_key(|(count, _)| *count);
        best.filter(|(count, _)| *count > 0).map(|(_, tables)| tables)
    }

    /// Returns the message with `id`.
    pub fn message(&self, id: CanId) -> Option<&'static MessageInfo> {
        self.messages.iter().find(|message| message.id == id)
    }
}

/// Returns a bench identifier as the codecs have it.
pub fn can_id(id: Id) -> CanId {
    match id {
        Id::Standard(id) => CanId::standard(id.raw()),
        Id::Extended(id) => CanId::extended(id.raw()),
    }
}

/// Returns a bench frame as the codecs have it; `None` for a remote request, which carries no signals.
pub fn can_frame(frame: &Frame) -> Option<CanFrame> {
    if frame.remote { None } else { CanFrame::from_slice(can_id(frame.id), frame.payload()) }
}

/// Returns seconds with six decimals.
pub fn seconds(at: Nanos) -> String {
    format!("{}.{:06}", at.0 / 1_000_000_000, at.0 / 1_000 % 1_000_000)
}

/// Returns seconds with three decimals.
pub fn short_seconds(millis: u64) -> String {
    format!("{}.{:03}", millis / 1_000, millis % 1_000)
}

/// Returns `counts / den` as the shortest exact decimal; `den` divides a power of ten, as it does for every DBC factor.
pub fn decimal(counts: i64, den: u32) -> String {
    // The denominator has at most 31 factors of 2 or 5.
    let decimals =
        (0..32).find(|decimals| 10_u128.pow(*decimals) % u128::from(den.max(1)) == 0).unwrap_or(31);
    let scaled = u128::from(counts.unsigned_abs()) * (10_u128.pow(decimals) / u128::from(den.max(1)));
    let digits = format!("{scaled:0width$}", width = decimals as usize + 1);
    let (whole, fraction) = digits.split_at(digits.len() - decimals as usize);
    let sign = if counts < 0 { "-" } else { "" };
    match fraction.trim_end_matches('0') {
        "" => format!("{sign}{whole}"),
        fraction => format!("{sign}{whole}.{fraction}"),
    }
}

/// Returns the physical value of `raw` as an exact decimal, valid or not.
pub fn value_of(signal: &SignalInfo, raw: i64) -> String {
    decimal(signal.scale.counts(raw), signal.scale.den)
}

/// Returns `text` with its unit behind it.
pub fn with_unit(text: &str, unit: &str) -> String {
    if unit.is_empty() { text.to_owned() } else { format!("{text} {unit}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact_and_short() {
        assert_eq!(decimal(12_425, 256), "48.53515625");
        assert_eq!(decimal(-1, 256), "-0.00390625");
        assert_eq!(decimal(512, 256), "2");
        assert_eq!(decimal(-30_000, 10), "-3000");
        assert_eq!(decimal(5, 10), "0.5");
        assert_eq!(decimal(0, 1), "0");
        assert_eq!(decimal(1_200, 1), "1200");
        assert_eq!(decimal(i64::MIN, 1), "-9223372036854775808");
    }
}
