//! A message as a table: for each signal, what in the world it tells.
//!
//! Owns the shape of the tables, how a physical value becomes a raw one, and the resolving of names against the
//! generated metadata. Refuses to know any message: those are rows of each vehicle's `wire`.
//! Source: BUS-R005 to R009 (order, fill, scaling), BUS-R021, R061, R121 and JL-R009 (life counters).

use crate::world::World;
use protocol_core::codec::{LifeKind, MessageInfo, Mux, SignalInfo};

/// Where the value of a signal comes from; all in the signal's physical unit, a word as its number.
#[derive(Clone, Copy)]
pub(crate) enum Source {
    /// From the world; `None` is sent as the signal's "not available".
    World(fn(&World) -> Option<f64>),
    /// A flag of the world.
    Flag(fn(&World) -> bool),
    /// Element of a list; in a series, counted on through its frames.
    Element(fn(&World, usize) -> Option<f64>, usize),
    /// A bit that the world knows by its place in the frame, counted from 0 as in the DBC.
    Bit(fn(&World, u8) -> bool),
    /// Always the same: a fact of this vehicle, or a function that it is built without.
    Fixed(f64),
    /// No row: always "not available".
    Unknown,
    /// The life counter, told by the metadata.
    Life(LifeKind),
}

/// One signal.
#[derive(Clone, Copy)]
pub(crate) struct Row {
    /// Name in the DBC.
    pub(crate) signal: &'static str,
    /// What it tells.
    pub(crate) source: Source,
}

/// A number or a word.
pub(crate) const fn value(signal: &'static str, of: fn(&World) -> Option<f64>) -> Row {
    Row { signal, source: Source::World(of) }
}

/// A flag.
pub(crate) const fn flag(signal: &'static str, of: fn(&World) -> bool) -> Row {
    Row { signal, source: Source::Flag(of) }
}

/// Element `place` of a list.
pub(crate) const fn element(signal: &'static str, of: fn(&World, usize) -> Option<f64>, place: usize) -> Row {
    Row { signal, source: Source::Element(of, place) }
}

/// A bit that the world knows by its place in the frame.
pub(crate) const fn bit(signal: &'static str, of: fn(&World, u8) -> bool) -> Row {
    Row { signal, source: Source::Bit(of) }
}

/// A fact of this vehicle, or the value of a function that it is built without.
pub(crate) const fn fixed(signal: &'static str, number: f64) -> Row {
    Row { signal, source: Source::Fixed(number) }
}

/// A table that comes in many frames.
#[derive(Clone, Copy)]
pub(crate) struct Series {
    /// Elements of one frame.
    pub(crate) per_frame: usize,
    /// Elements that there are now.
    pub(crate) elements: fn(&World) -> usize,
}

/// One message, or all messages of a series.
#[derive(Clone, Copy)]
pub(crate) struct Sheet {
    /// Name in the DBC; of a series, the name without its number.
    pub(crate) message: &'static str,
    /// The signals but for the life counter.
    pub(crate) rows: &'static [Row],
    /// When its sender sends it while the vehicle is awake.
    pub(crate) when: fn(&World) -> bool,
    /// The tables that it is a part of.
    pub(crate) series: Option<Series>,
    /// Is on another bus, unless the vehicle is built with its optional messages.
    pub(crate) elsewhere: bool,
    /// Is on the cluster's bus only while this holds; else on one of its own.
    pub(crate) here: fn(&World) -> bool,
    /// What its sender keeps of having sent it.
    pub(crate) sent: fn(&mut World),
    /// Cycle in the overview where that is another than on the page, in milliseconds (BUS-18).
    pub(crate) overview_ms: Option<u32>,
}

impl Sheet {
    pub(crate) const fn of(message: &'static str, rows: &'static [Row]) -> Self {
        Self {
            message,
            rows,
            when: |_| true,
            series: None,
            elsewhere: false,
            here: |_| true,
            sent: |_| (),
            overview_ms: None,
        }
    }

    /// Sent only when this holds.
    pub(crate) const fn only(self, when: fn(&World) -> bool) -> Self {
        Self { when, ..self }
    }

    /// Comes as frames 1, 2, ... of `per_frame` elements each.
    pub(crate) const fn series(self, per_frame: usize, elements: fn(&World) -> usize) -> Self {
        Self { series: Some(Series { per_frame, elements }), ..self }
    }

    /// Travels on a bus that the cluster is not on.
    pub(crate) const fn elsewhere(self) -> Self {
        Self { elsewhere: true, ..self }
    }

    /// Travels on the cluster's bus only while this holds.
    pub(crate) const fn here(self, here: fn(&World) -> bool) -> Self {
        Self { here, ..self }
    }

    /// Lets its sender keep what it has sent.
    pub(crate) const fn sent(self, sent: fn(&mut World)) -> Self {
        Self { sent, ..self }
    }

    /// Has this cycle in the overview, in milliseconds.
    pub(crate) const fn overview(self, ms: u32) -> Self {
        Self { overview_ms: Some(ms), ..self }
    }

    /// Returns the frame of the series that message `name` is, from 0; `None` if it is not of this sheet.
    pub(crate) fn frame_of(&self, name: &str) -> Option<usize> {
        if self.series.is_none() {
            return (name == self.message).then_some(0);
        }
        let number: usize = name.strip_prefix(self.message)?.parse().ok()?;
        number.checked_sub(1)
    }

    /// Returns whether frame `frame` is sent now.
    pub(crate) fn is_due(&self, world: &World, frame: usize) -> bool {
        let has = self.series.is_none_or(|series| frame * series.per_frame < (series.elements)(world));
        has && (self.when)(world)
    }
}

/// A signal with its metadata.
pub(crate) struct Slot {
    info: &'static SignalInfo,
    source: Source,
}

/// Pairs each signal of a message with its row, selectors first.
///
/// Says in `problems` which names do not fit; such a signal is sent as not available.
pub(crate) fn resolve(info: &'static MessageInfo, rows: &[Row], problems: &mut Vec<String>) -> Vec<Slot> {
    for (place, row) in rows.iter().enumerate() {
        if info.signal(row.signal).is_none() {
            problems.push(format!("{} has no signal `{}`", info.name, row.signal));
        }
        if rows[..place].iter().any(|before| before.signal == row.signal) {
            problems.push(format!("{}.{} has two rows", info.name, row.signal));
        }
    }
    let mut slots: Vec<Slot> = Vec::with_capacity(info.signals.len());
    for signal in info.signals {
        let row = rows.iter().find(|row| row.signal == signal.name).map(|row| row.source);
        let source = match (signal.life, row) {
            (Some(kind), None) => Source::Life(kind),
            (None, Some(source)) => source,
            (Some(_), Some(_)) => {
                problems.push(format!("{}.{} is a life counter and needs no row", info.name, signal.name));
                Source::Unknown
            }
            (None, None) => {
                problems.push(format!("{}.{} has no row", info.name, signal.name));
                Source::Unknown
            }
        };
        slots.push(Slot { info: signal, source });
    }
    // Whether a multiplexed signal is in the frame is read from the frame.
    slots.sort_by_key(|slot| slot.info.mux != Mux::Selector);
    slots
}

/// Returns the 8 bytes of a message as the world is; `first` is the place of the frame's first element.
pub(crate) fn encode(info: &MessageInfo, slots: &[Slot], world: &World, first: usize, life: u8) -> [u8; 8] {
    let mut data = info.fill;
    for slot in slots {
        if !info.carries(slot.info, &data) {
            continue;
        }
        let number = match slot.source {
            Source::World(of) => of(world),
            Source::Flag(of) => Some(f64::from(u8::from(of(world)))),
            Source::Element(of, place) => of(world, first + place),
            Source::Bit(of) => Some(f64::from(u8::from(of(world, slot.info.start)))),
            Source::Fixed(number) => Some(number),
            Source::Unknown => None,
            Source::Life(_) => {
                slot.info.set_raw(&mut data, i64::from(life));
                continue;
            }
        };
        slot.info.set_raw(&mut data, raw_of(slot.info, number));
    }
    data
}

/// Returns the nearest raw value that is valid; what is not known is sent as "not available", else as the start value.
pub(crate) fn raw_of(signal: &SignalInfo, number: Option<f64>) -> i64 {
    let Some(number) = number.filter(|number| number.is_finite()) else {
        return signal.invalid_raw.unwrap_or(signal.start_raw);
    };
    let scale = signal.scale;
    let raw = (number * f64::from(scale.den) - f64::from(scale.add)) / f64::from(scale.mul);
    // A cast from f64 saturates.
    (raw.round() as i64).clamp(signal.range.0, signal.range.1)
}

/// Returns the kind of the life counter of a message.
pub(crate) fn life_of(slots: &[Slot]) -> Option<LifeKind> {
    slots.iter().find_map(|slot| if let Source::Life(kind) = slot.source { Some(kind) } else { None })
}

/// Returns the first value of a life counter.
pub(crate) const fn first_life(kind: Option<LifeKind>) -> u8 {
    if matches!(kind, Some(LifeKind::From1To255)) { 1 } else { 0 }
}

/// Returns what follows in a life counter.
pub(crate) const fn next_life(kind: Option<LifeKind>, life: u8) -> u8 {
    match kind {
        None => 0,
        Some(LifeKind::From0To255) => life.wrapping_add(1),
        Some(LifeKind::From1To255) if life == u8::MAX => 1,
        Some(LifeKind::From1To255) => life + 1,
        Some(LifeKind::Nibble) => (life + 1) & 0x0F,
    }
}
