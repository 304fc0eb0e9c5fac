//! Model values as a person reads them: the number in its everyday unit, a state by its word.
//!
//! Integers only: a value is printed as an exact decimal, rounded towards zero where the unit is binary.

use crate::link::Sample;
use crate::model::{Missing, Unit};
use core::fmt;

/// How one unit is printed: everyday value = counts x `numerator` / `denominator`, with `decimals` digits.
struct Scale {
    numerator: i64,
    denominator: i64,
    decimals: u32,
    symbol: &'static str,
}

const fn scale(numerator: i64, denominator: i64, decimals: u32, symbol: &'static str) -> Scale {
    Scale { numerator, denominator, decimals, symbol }
}

impl Unit {
    const fn scale(self) -> Scale {
        match self {
            Self::Kmh256 => scale(1, 256, 1, "km/h"),
            Self::Km8 => scale(1, 8, 3, "km"),
            Self::Permille => scale(1, 10, 1, "%"),
            Self::Decivolt => scale(1, 10, 1, "V"),
            Self::Millivolt => scale(1, 1000, 3, "V"),
            Self::Deciamp => scale(1, 10, 1, "A"),
            Self::DeciNm => scale(1, 10, 1, "Nm"),
            Self::Rpm => scale(1, 1, 0, "rpm"),
            Self::Celsius => scale(1, 1, 0, "°C"),
            Self::Kiloohm => scale(1, 1, 0, "kohm"),
            Self::Ah => scale(1, 1, 0, "Ah"),
            Self::CentiMpa => scale(1, 100, 2, "MPa"),
            Self::Kilopascal => scale(1, 1, 0, "kPa"),
            Self::Watt => scale(1, 1000, 3, "kW"),
            Self::Hertz => scale(1, 1, 0, "Hz"),
            Self::Day => scale(1, 1, 0, "d"),
            _ => scale(1, 1, 0, ""),
        }
    }

    /// Returns the symbol of the everyday unit, empty for codes and states.
    pub const fn symbol(self) -> &'static str {
        self.scale().symbol
    }

    /// Returns `counts` as a decimal number in the everyday unit: a whole number of which the last figures, as many as
    /// the second says, stand behind the point. Rounded towards zero where the unit is binary.
    pub const fn decimal(self, counts: i32) -> (i64, u32) {
        let Scale { numerator, denominator, decimals, .. } = self.scale();
        (counts as i64 * numerator * 10_i64.pow(decimals) / denominator, decimals)
    }

    /// Returns `counts` for printing: `48.5 km/h`, `yes`, `D`.
    pub const fn show(self, counts: i32) -> Reader {
        Reader { unit: self, counts }
    }
}

/// A model value that prints itself in its everyday unit.
#[derive(Clone, Copy, Debug)]
pub struct Reader {
    unit: Unit,
    counts: i32,
}

impl fmt::Display for Reader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(state) = self.unit.kind().and_then(|kind| kind.of_number(self.counts)) {
            return f.write_str(state.word);
        }
        let (scaled, decimals) = self.unit.decimal(self.counts);
        let (ten, symbol) = (10_i64.pow(decimals), self.unit.symbol());
        let sign = if scaled < 0 { "-" } else { "" };
        let (whole, rest) = (scaled.unsigned_abs() / ten as u64, scaled.unsigned_abs() % ten as u64);
        write!(f, "{sign}{whole}")?;
        if decimals > 0 {
            write!(f, ".{rest:0width$}", width = decimals as usize)?;
        }
        if symbol.is_empty() { Ok(()) } else { write!(f, " {symbol}") }
    }
}

impl Sample {
    /// Returns the sample for printing: the value in the everyday unit, or how it is missing.
    pub const fn show(self, unit: Unit) -> SampleReader {
        SampleReader { unit, sample: self }
    }
}

/// A sample that prints itself in its everyday unit.
#[derive(Clone, Copy, Debug)]
pub struct SampleReader {
    unit: Unit,
    sample: Sample,
}

impl fmt::Display for SampleReader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.sample {
            Sample::Never => f.write_str(Missing::Never.word()),
            Sample::Stale => f.write_str(Missing::Stale.word()),
            Sample::Invalid => f.write_str(Missing::Invalid.word()),
            Sample::Value(counts) => fmt::Display::fmt(&self.unit.show(counts), f),
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::string::ToString;

    #[test]
    fn values_print_in_everyday_units() {
        let cases = [
            (Unit::Kmh256, 12_425, "48.5 km/h"),
            (Unit::Deciamp, -1_027, "-102.7 A"),
            (Unit::Deciamp, -7, "-0.7 A"),
            (Unit::Km8, 1, "0.125 km"),
            (Unit::Millivolt, 3_305, "3.305 V"),
            (Unit::Celsius, -40, "-40 °C"),
            (Unit::Gear, 1, "D"),
            (Unit::Gear, 13, "D3"),
            (Unit::Gear, 0, "0"),
            (Unit::Flag, 1, "yes"),
            (Unit::Severity, 3, "stop"),
            (Unit::Fan, 2, "high"),
            (Unit::Count, 104, "104"),
        ];
        for (unit, counts, text) in cases {
            assert_eq!(unit.show(counts).to_string(), text);
        }
    }

    #[test]
    fn the_extremes_of_every_unit_print_without_overflow() {
        for counts in [i32::MIN, i32::MAX] {
            for unit in crate::model::Value::ALL.iter().map(|value| value.unit()) {
                assert!(!unit.show(counts).to_string().is_empty());
            }
        }
    }
}
