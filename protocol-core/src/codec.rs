//! What a tool can know of any message: rows of metadata and an integer codec.
//!
//! The rows are generated next to the getters of each message; firmware does not refer to them, so the linker leaves
//! them out. The codec here reads and writes any signal by its row, slowly, and must agree with the generated getters
//! (`tests/codec_*.rs`). Refuses to know what a signal means: that is [`crate::vehicle`].
//! Source: the DBC files; the sawtooth bit numbering of Motorola signals is the one of Vector's DBC format.
//! Not supported: signals longer than 32 bits, floating-point signals, extended multiplexing.

use crate::frame::CanId;
use crate::model::{INVALID, Reading, Readings, Value};

/// Byte order of a signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Low byte first; `start` is the lowest bit.
    Intel,
    /// High byte first; `start` is the highest bit, bits counted down within a byte and on in the next byte.
    Motorola,
}

/// When a signal is in the frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mux {
    /// In every frame of the message.
    Always,
    /// Always, and its raw value selects the others.
    Selector,
    /// Only while the selector has this raw value.
    When(u32),
}

/// What a life counter does; each form changes with every frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LifeKind {
    /// 0 to 255, then 0.
    From0To255,
    /// 1 to 255, then 1.
    From1To255,
    /// 0 to 15, then 0.
    Nibble,
}

/// Physical value of a raw value, exactly: `(raw * mul + add) / den`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scale {
    /// Multiplier of the raw value.
    pub mul: i32,
    /// Summand, in counts of `1 / den`.
    pub add: i32,
    /// Counts in one physical unit, at least 1; with `mul` and `add` in lowest terms.
    pub den: u32,
}

impl Scale {
    /// Returns the physical value in counts of `1 / den` of the unit.
    pub const fn counts(self, raw: i64) -> i64 {
        raw * self.mul as i64 + self.add as i64
    }
}

/// One signal of a message.
#[derive(Debug)]
pub struct SignalInfo {
    /// Name in the DBC.
    pub name: &'static str,
    /// Start bit as in the DBC: lowest bit (Intel) or highest bit (Motorola).
    pub start: u8,
    /// Bits, 1 to 32.
    pub length: u8,
    /// Byte order.
    pub order: Order,
    /// Two's complement.
    pub signed: bool,
    /// Physical value of a raw value.
    pub scale: Scale,
    /// Unit of the physical value, as in the DBC.
    pub unit: &'static str,
    /// Lowest and highest valid raw value.
    pub range: (i64, i64),
    /// Raw value sent before anything is known.
    pub start_raw: i64,
    /// Raw value that says "not available".
    pub invalid_raw: Option<i64>,
    /// When the signal is in the frame.
    pub mux: Mux,
    /// Set if the signal is a life counter.
    pub life: Option<LifeKind>,
    /// Words for raw values, sorted by raw value.
    pub values: &'static [(i64, &'static str)],
}

/// Bit of a byte that follows `bit` downwards in a Motorola signal.
const fn below(bit: u32) -> u32 {
    if bit.is_multiple_of(8) { bit + 15 } else { bit - 1 }
}

impl SignalInfo {
    /// Calls `visit` with byte and bit of each bit of the signal, from the highest down.
    fn walk(&self, mut visit: impl FnMut(usize, u32)) {
        let mut bit = match self.order {
            Order::Intel => u32::from(self.start) + u32::from(self.length) - 1,
            Order::Motorola => u32::from(self.start),
        };
        for _ in 0..self.length.min(32) {
            visit((bit / 8) as usize, bit % 8);
            bit = match self.order {
                Order::Intel => bit.saturating_sub(1),
                Order::Motorola => below(bit),
            };
        }
    }

    /// Returns the raw value in a frame; bits beyond the frame read as 0.
    pub fn raw(&self, data: &[u8; 8]) -> i64 {
        let mut bits = 0u32;
        self.walk(|byte, bit| bits = bits << 1 | u32::from(data.get(byte).copied().unwrap_or(0) >> bit & 1));
        let spare = 32 - u32::from(self.length.clamp(1, 32));
        if self.signed { i64::from((bits << spare) as i32 >> spare) } else { i64::from(bits) }
    }

    /// Writes the low bits of `raw` into a frame and leaves all other bits.
    pub fn set_raw(&self, data: &mut [u8; 8], raw: i64) {
        let mut left = u32::from(self.length);
        self.walk(|byte, bit| {
            left = left.saturating_sub(1);
            if let Some(byte) = data.get_mut(byte) {
                *byte = *byte & !(1 << bit) | ((raw >> left & 1) as u8) << bit;
            }
        });
    }

    /// Returns whether the sender may send `raw` as a value.
    pub fn is_valid(&self, raw: i64) -> bool {
        (self.range.0..=self.range.1).contains(&raw) && self.invalid_raw != Some(raw)
    }

    /// Returns the physical value in counts of `1 / scale.den`, `None` if `raw` is not a value.
    pub fn physical(&self, raw: i64) -> Option<i64> {
        self.is_valid(raw).then(|| self.scale.counts(raw))
    }

    /// Returns the word for a raw value.
    pub fn word(&self, raw: i64) -> Option<&'static str> {
        self.values.binary_search_by_key(&raw, |(value, _)| *value).ok().map(|index| self.values[index].1)
    }
}

/// Raw value of a signal, and its physical value in counts of `1 / scale.den` if it is valid.
pub type Got = (i64, Option<i64>);

/// One message of a vehicle.
#[derive(Debug)]
pub struct MessageInfo {
    /// Identifier.
    pub id: CanId,
    /// Name in the DBC.
    pub name: &'static str,
    /// Node in the DBC that sends it; empty = none is named.
    pub sender: &'static str,
    /// Bytes of a frame, 0 to 8.
    pub len: u8,
    /// Shortest time from one frame to the next, in milliseconds; 0 = not periodic.
    pub cycle_ms: u32,
    /// Longest time from one frame to the next that the documents print, in milliseconds.
    pub slow_cycle_ms: u32,
    /// Not every vehicle of this type sends it.
    pub optional: bool,
    /// A frame in which no signal is set yet.
    pub fill: [u8; 8],
    /// The signals, in the order of the DBC.
    pub signals: &'static [SignalInfo],
    /// The generated getters of signal `index`.
    pub get: fn(index: usize, data: [u8; 8]) -> Option<Got>,
    /// The generated setter of signal `index`.
    pub set: fn(index: usize, data: [u8; 8], raw: i64) -> [u8; 8],
}

impl MessageInfo {
    /// Returns the signal of this name.
    pub fn signal(&self, name: &str) -> Option<&'static SignalInfo> {
        self.signals.iter().find(|signal| signal.name == name)
    }

    /// Returns whether `signal` is in this frame: multiplexed signals are only sometimes.
    pub fn carries(&self, signal: &SignalInfo, data: &[u8; 8]) -> bool {
        let Mux::When(wanted) = signal.mux else { return true };
        let selector = self.signals.iter().find(|signal| signal.mux == Mux::Selector);
        selector.is_some_and(|selector| selector.raw(data) == i64::from(wanted))
    }

    /// Returns a frame of the start values of all signals that are always in it.
    pub fn start_frame(&self) -> [u8; 8] {
        let mut data = self.fill;
        for signal in self.signals.iter().filter(|signal| !matches!(signal.mux, Mux::When(_))) {
            signal.set_raw(&mut data, signal.start_raw);
        }
        data
    }
}

/// Returns `numerator / denominator` rounded down, also for negative numerators.
pub const fn floor_div(numerator: i32, denominator: i32) -> i32 {
    numerator.div_euclid(denominator)
}

/// Returns `numerator / denominator` rounded to the nearest, halves up.
pub const fn nearest_div(numerator: i32, denominator: i32) -> i32 {
    (numerator + denominator / 2).div_euclid(denominator)
}

/// Returns a number that is ordered as the IEEE binary32 patterns are; NaN is beyond both infinities.
#[inline(always)]
pub const fn float32_order(bits: u32) -> i32 {
    let bits = bits as i32;
    bits ^ ((bits >> 31) as u32 >> 1) as i32
}

/// Does what [`float32_order`] does for binary64.
#[inline(always)]
pub const fn float64_order(bits: u64) -> i64 {
    let bits = bits as i64;
    bits ^ ((bits >> 63) as u64 >> 1) as i64
}

/// Returns `(value * mul + add) / den`, rounded down, of the IEEE binary32 `bits`: in integers, exactly. [`INVALID`] if the
/// float is infinite or no number, or the result has more than 31 bits.
pub const fn float32_counts(bits: u32, mul: i64, add: i64, den: i64) -> i32 {
    let (exponent, fraction) = ((bits >> 23 & 0xFF) as i32, (bits & 0x7F_FFFF) as i128);
    float_counts(bits >> 31 != 0, exponent, 0xFF, fraction, 23, [mul, add, den])
}

/// Does what [`float32_counts`] does for binary64.
pub const fn float64_counts(bits: u64, mul: i64, add: i64, den: i64) -> i32 {
    let (exponent, fraction) = ((bits >> 52 & 0x7FF) as i32, (bits & 0xF_FFFF_FFFF_FFFF) as i128);
    float_counts(bits >> 63 != 0, exponent, 0x7FF, fraction, 52, [mul, add, den])
}

/// Scales a float of its parts: biased exponent with its highest value, fraction and the bits of it.
const fn float_counts(
    negative: bool,
    exponent: i32,
    highest: i32,
    fraction: i128,
    bits: i32,
    [mul, add, den]: [i64; 3],
) -> i32 {
    if exponent == highest {
        return INVALID;
    }
    // Without the hidden bit a number is as small as the smallest exponent makes it.
    let (mantissa, exponent) = if exponent == 0 { (fraction, 1) } else { (fraction | 1 << bits, exponent) };
    let shift = exponent - highest / 2 - bits;
    let mantissa = if negative { -mantissa } else { mantissa };
    // At most 53 + 31 bits. Rounding down before and after a division by a whole number is rounding down once.
    let product = mantissa * mul as i128;
    let whole = if product == 0 {
        0
    } else if shift > 42 {
        return INVALID;
    } else if shift >= 0 {
        product << shift
    } else if shift < -126 {
        product >> 126
    } else {
        product >> -shift
    };
    let counts = (whole + add as i128).div_euclid(den as i128);
    if counts > i32::MIN as i128 && counts <= i32::MAX as i128 { counts as i32 } else { INVALID }
}

/// Returns the number of `value` if it has ever been seen and is valid: the form of generated encoders.
pub fn known(values: &Readings, value: Value) -> Option<i32> {
    match values.get(value)? {
        (Reading::Valid(number), _) => Some(number),
        (Reading::Invalid, _) => None,
    }
}

/// Returns `(number * mul + add) / den`, rounded down, within `low` to `high`: the form of generated encoders.
#[inline(always)]
pub const fn scaled(number: i32, mul: i64, add: i64, den: i64, low: i64, high: i64) -> i64 {
    let raw = (number as i64 * mul + add).div_euclid(den);
    if raw < low {
        low
    } else if raw > high {
        high
    } else {
        raw
    }
}
