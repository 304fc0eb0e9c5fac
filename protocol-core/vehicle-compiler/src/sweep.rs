//! A recording in which each bound value of a vehicle goes through its range: to see a vehicle drive before one is recorded.
//!
//! Made from the two files, so it proves nothing about the vehicle. Life counters count and check bytes hold.

use crate::binding::{How, Rx, RxValue};
use crate::interpreter::RunTime;
use crate::network::{Condition, Message, Signal};
use protocol_core::codec::LifeKind;
use protocol_core::{CanId, Value};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Time from frame to frame where the DBC does not say it.
const CYCLE_MS: u32 = 100;
/// Priority of the frames of a J1939 group, and a source.
const J1939: u32 = 0x1800_0000;

impl RunTime {
    /// Returns a candump log in which each bound value rises to the top of its range and falls again; speed stays under
    /// 120 km/h, whatever the bits allow.
    pub fn sweep(&self, seconds: u32) -> String {
        let Some(binding) = self.binding() else { return String::new() };
        let mut lines: Vec<(u32, String)> = Vec::new();
        for row in binding.rx.iter().filter(|row| !row.values.is_empty()) {
            self.sweep_message(row, seconds * 1_000, &mut lines);
        }
        lines.sort();
        let mut text = String::new();
        for (ms, frame) in lines {
            let _ = writeln!(text, "({}.{:03}000) can0 {frame}", ms / 1_000, ms % 1_000);
        }
        text
    }

    fn sweep_message(&self, row: &Rx, end_ms: u32, lines: &mut Vec<(u32, String)>) {
        let message = &self.network.messages[row.message];
        let mut pages: BTreeMap<&[Condition], Vec<&RxValue>> = BTreeMap::new();
        row.values.iter().for_each(|value| pages.entry(value.when(message)).or_default().push(value));
        let cycle_ms = if message.cycle_ms == 0 { CYCLE_MS } else { message.cycle_ms };
        let id = CanId::from_packed(message.id);
        let id = if message.any_source { CanId::extended(J1939 | id.bits() & 0x03FF_FF00) } else { id };
        let mut count = 0;
        for ms in (0..end_ms).step_by(cycle_ms as usize) {
            for (when, values) in &pages {
                let mut data = message.start_frame();
                for condition in *when {
                    let first = condition.ranges.first().map_or(0, |range| range.0);
                    message.signals[condition.selector].set_raw(&mut data, first);
                }
                for value in values {
                    put(value, message, rise(ms, end_ms), &mut data);
                }
                if let Some(signal) = message.life() {
                    signal.set_raw(&mut data, life(signal, count));
                }
                if let Some(checksum) = row.checksum {
                    checksum.seal(&mut data);
                }
                count += 1;
                let bytes: String =
                    data.iter().take(message.len.into()).map(|byte| format!("{byte:02X}")).collect();
                lines.push((ms, format!("{id}#{bytes}")));
            }
        }
    }
}

/// Returns how far a value has risen, in thousandths: up to the middle of the time, then down.
fn rise(ms: u32, end_ms: u32) -> i128 {
    let half = i128::from(end_ms / 2).max(1);
    let ms = i128::from(ms);
    1_000 * if ms <= half { ms } else { 2 * half - ms }.max(0) / half
}

fn life(signal: &Signal, count: i128) -> i128 {
    match signal.life {
        Some(LifeKind::From1To255) => count % 255 + 1,
        _ => count % (signal.span().1 + 1),
    }
}

/// Writes the signals of one value.
fn put(value: &RxValue, message: &Message, rise: i128, data: &mut [u8; 8]) {
    for term in &value.terms {
        let signal = &message.signals[term.signal];
        let raw = match &term.how {
            // One state after the other; a flag is left as it starts.
            How::Mapped { states, .. } => {
                let valid: Vec<i64> =
                    states.iter().filter(|(_, state)| state.is_some()).map(|(raw, _)| *raw).collect();
                let at = (rise as usize * valid.len() / 1_001).min(valid.len().saturating_sub(1));
                valid.get(at).map_or(signal.start_raw, |raw| i128::from(*raw))
            }
            How::Float { .. } => {
                let (low, high) = signal.float_range.unwrap_or((0.0, 100.0));
                signal.number.pattern(low + (high - low) * rise as f64 / 1_000.0)
            }
            How::Scaled { .. } => {
                let (low, high) = limits(value.value, signal);
                low + (high - low) * rise / 1_000
            }
        };
        signal.set_raw(data, raw);
    }
}

fn limits(value: Value, signal: &Signal) -> (i128, i128) {
    let (low, high) = signal.range;
    let town = signal.raw_of(120, 0).map(|(raw, _)| raw);
    match town.filter(|raw| value == Value::VehicleSpeed && (low..=high).contains(raw)) {
        Some(town) => (low.max(0), town),
        None => (low, high),
    }
}
