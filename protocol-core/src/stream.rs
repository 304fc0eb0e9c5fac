//! Tables that come in many frames: every cell voltage and every module temperature of a battery.
//!
//! Owns the raw tables and what can be said of them: highest, lowest and how many. A stream is a row of
//! `vehicle.toml`; its frames have identifiers at equal distance and the sender begins anew with the first one in every
//! cycle. A cell that does not come for [`KEPT`] cycles is dropped, so a shorter pack leaves nothing behind, and a frame
//! that is lost once or twice changes nothing; order does not matter. Refuses to know time: whether a stream still
//! comes is told by its first frame, which is a row of the receive table.
//! Source: JL-R020 to JL-R022, JL-25 (padding), JL-27 (restart with each cycle), JL-28 (limits of PF).
//! Not supported: cells of more than one byte, more than [`ROOM`] cells in one vehicle.

use crate::codec::Scale;
use crate::frame::CanId;
use crate::model::{Reading, Value};

/// Cells that the tables of one vehicle hold.
pub const ROOM: usize = 384;

/// Cycles that a cell outlives without being sent.
pub const KEPT: u8 = 3;

/// One cell of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Byte with its number; `None` = cells are numbered by their place, and the number shown is that of the frame.
    pub number: Option<u8>,
    /// Byte with its value.
    pub value: u8,
}

/// Model values that a stream fills in as long as no other message brings them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bound {
    /// The highest value.
    pub highest: Option<Value>,
    /// The lowest value.
    pub lowest: Option<Value>,
    /// Number of the cell, or of the frame, with the highest value.
    pub highest_number: Option<Value>,
    /// Number of the cell, or of the frame, with the lowest value.
    pub lowest_number: Option<Value>,
    /// How many cells there are.
    pub count: Option<Value>,
}

/// One stream of a vehicle.
#[derive(Clone, Copy, Debug)]
pub struct Stream {
    /// Name in `vehicle.toml`.
    pub name: &'static str,
    /// Index of the first frame in the receive table.
    pub row: u8,
    /// Identifier of the first frame.
    pub first: CanId,
    /// Distance from each identifier to the next, not 0.
    pub step: i32,
    /// Most frames of one cycle.
    pub frames: u8,
    /// Bytes that each frame must have.
    pub len: u8,
    /// The cells of one frame.
    pub cells: &'static [Cell],
    /// Number 0 with value 0 fills up the last frame: no cell, but for the first place of the first frame (JL-25).
    pub zeros_pad: bool,
    /// Where its cells begin in the tables.
    pub start: u16,
    /// Most cells.
    pub size: u16,
    /// Lowest and highest raw value that is valid.
    pub valid: (u8, u8),
    /// From raw values to the model's counts, rounded down.
    pub scale: Scale,
    /// What it fills in.
    pub bound: Bound,
}

impl Stream {
    /// Returns the index of the frame with this identifier, from 0.
    pub fn frame_of(&self, id: CanId) -> Option<u8> {
        if id.is_extended() != self.first.is_extended() {
            return None;
        }
        // Both have at most 29 bits. Compared before divided: the chip divides slowly, and most frames are not of it.
        let distance = id.bits() as i32 - self.first.bits() as i32;
        let (distance, step) = if self.step < 0 { (-distance, -self.step) } else { (distance, self.step) };
        let in_range = (0..step.saturating_mul(i32::from(self.frames))).contains(&distance);
        (in_range && distance % step == 0).then(|| (distance / step) as u8)
    }

    /// Returns a raw value in the model's counts.
    fn counts(&self, raw: u8) -> i32 {
        self.scale.counts(i64::from(raw)).div_euclid(i64::from(self.scale.den)) as i32
    }
}

/// The highest or the lowest cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extreme {
    /// Its value, in the model's counts.
    pub value: i32,
    /// Its number, or that of its frame.
    pub number: i32,
}

/// What can be said of a table; cells with a value that is not valid count, and nothing else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// The highest cell, the first of equals; `None` = no cell has a valid value.
    pub highest: Option<Extreme>,
    /// The lowest cell, the first of equals.
    pub lowest: Option<Extreme>,
    /// How many cells there are.
    pub count: u16,
}

impl Summary {
    /// Returns what to store under the values that `bound` names.
    pub fn readings(self, bound: &Bound) -> impl Iterator<Item = (Value, Reading)> {
        let value = |extreme: Option<Extreme>| extreme.map(|extreme| extreme.value);
        let number = |extreme: Option<Extreme>| extreme.map(|extreme| extreme.number);
        let all = [
            (bound.highest, value(self.highest)),
            (bound.lowest, value(self.lowest)),
            (bound.highest_number, number(self.highest)),
            (bound.lowest_number, number(self.lowest)),
            (bound.count, Some(i32::from(self.count))),
        ];
        all.into_iter()
            .filter_map(|(value, counts)| Some((value?, counts.map_or(Reading::Invalid, Reading::Valid))))
    }
}

/// The raw tables of all streams of a vehicle.
#[derive(Clone)]
pub struct Streams {
    raw: [u8; ROOM],
    /// Cycles that each cell still outlives; 0 = not there.
    left: [u8; ROOM],
}

impl Default for Streams {
    fn default() -> Self {
        Self::new()
    }
}

impl Streams {
    /// Returns empty tables.
    pub const fn new() -> Self {
        Self { raw: [0; ROOM], left: [0; ROOM] }
    }

    /// Stores the cells of frame `index` of a stream; the first one begins a new cycle.
    pub fn store(&mut self, stream: &Stream, index: u8, data: &[u8; 8]) {
        let start = usize::from(stream.start);
        let table = start..start + usize::from(stream.size);
        let (Some(raw), Some(left)) = (self.raw.get_mut(table.clone()), self.left.get_mut(table)) else {
            return;
        };
        if index == 0 {
            left.iter_mut().for_each(|left| *left = left.saturating_sub(1));
        }
        let byte = |at: u8| data.get(usize::from(at)).copied().unwrap_or(0);
        for (place, cell) in stream.cells.iter().enumerate() {
            let value = byte(cell.value);
            let number = match cell.number {
                Some(at) => usize::from(byte(at)),
                None => usize::from(index) * stream.cells.len() + place,
            };
            let is_first = index == 0 && place == 0;
            if stream.zeros_pad && number == 0 && value == 0 && !is_first {
                continue;
            }
            if let (Some(raw), Some(left)) = (raw.get_mut(number), left.get_mut(number)) {
                (*raw, *left) = (value, KEPT);
            }
        }
    }

    /// Returns every cell that is there, raw, with its place in the table: its number, or its place in the stream.
    pub fn cells(&self, stream: &Stream) -> impl Iterator<Item = (u16, u8)> {
        let start = usize::from(stream.start);
        let table = start..start + usize::from(stream.size);
        let raw = self.raw.get(table.clone()).unwrap_or_default();
        let left = self.left.get(table).unwrap_or_default();
        let cells = (0u16..).zip(raw.iter().zip(left));
        cells.filter(|(_, (_, left))| **left > 0).map(|(place, (raw, _))| (place, *raw))
    }

    /// Returns what can be said of a stream now.
    pub fn summary(&self, stream: &Stream) -> Summary {
        let (mut highest, mut lowest, mut count) = (None::<(u16, u8)>, None::<(u16, u8)>, 0);
        for (place, raw) in self.cells(stream) {
            count += 1;
            if !(stream.valid.0..=stream.valid.1).contains(&raw) {
                continue;
            }
            if highest.is_none_or(|(_, highest)| raw > highest) {
                highest = Some((place, raw));
            }
            if lowest.is_none_or(|(_, lowest)| raw < lowest) {
                lowest = Some((place, raw));
            }
        }
        let is_numbered = stream.cells.iter().any(|cell| cell.number.is_some());
        let extreme = |(place, raw): (u16, u8)| {
            let per_frame = stream.cells.len().max(1) as u16;
            let number = if is_numbered { place } else { place / per_frame + 1 };
            Extreme { value: stream.counts(raw), number: i32::from(number) }
        };
        Summary { highest: highest.map(extreme), lowest: lowest.map(extreme), count }
    }
}
