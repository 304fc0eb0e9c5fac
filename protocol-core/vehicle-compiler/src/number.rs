//! What the bits of a signal are: a whole number or an IEEE float.
//!
//! A raw value is the whole number that the bits make, whatever they mean: that of a float is its pattern.

use crate::ratio::Ratio;

/// What the bits of a signal are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// Whole, from 0.
    Unsigned,
    /// Whole, two's complement.
    Signed,
    /// IEEE 754 binary32.
    Float32,
    /// IEEE 754 binary64.
    Float64,
}

impl Number {
    /// Returns whether the raw value is a pattern and not a number.
    pub fn is_float(self) -> bool {
        matches!(self, Self::Float32 | Self::Float64)
    }

    /// Returns the raw value of `length` bits.
    pub(crate) fn of_bits(self, bits: u64, length: u8) -> i128 {
        let spare = 64 - u32::from(length.clamp(1, 64));
        match self {
            Self::Signed => i128::from((bits << spare) as i64 >> spare),
            _ => i128::from(bits),
        }
    }

    /// Returns lowest and highest raw value of `length` bits.
    pub(crate) fn span(self, length: u8) -> (i128, i128) {
        let half = 1i128 << (length.clamp(1, 64) - 1);
        match self {
            Self::Signed => (-half, half - 1),
            _ => (0, 2 * half - 1),
        }
    }

    /// Returns the float that a pattern is.
    pub(crate) fn float(self, raw: i128) -> f64 {
        match self {
            Self::Float32 => f64::from(f32::from_bits(raw as u32)),
            _ => f64::from_bits(raw as u64),
        }
    }

    /// Returns the pattern of the nearest float.
    pub(crate) fn pattern(self, value: f64) -> i128 {
        match self {
            Self::Float32 => i128::from((value as f32).to_bits()),
            _ => i128::from(value.to_bits()),
        }
    }
}

/// Returns `raw * factor + offset` as the shortest exact decimal, or the nearest float if that has too many digits.
pub(crate) fn decimal(raw: i128, factor: Ratio, offset: Ratio) -> String {
    let exact = Ratio::whole(raw).checked_mul(factor).and_then(|product| product.checked_add(offset));
    match exact.and_then(plain) {
        Some(text) => text,
        None => shown(raw as f64 * factor.approximately() + offset.approximately()),
    }
}

/// Returns a fraction of tens as a decimal.
pub(crate) fn plain(ratio: Ratio) -> Option<String> {
    let decimals = (0..38).find(|decimals| 10i128.pow(*decimals) % ratio.den == 0)?;
    let scaled = ratio.num.unsigned_abs().checked_mul(10u128.pow(decimals) / ratio.den.unsigned_abs())?;
    let digits = format!("{scaled:0width$}", width = decimals as usize + 1);
    let (whole, fraction) = digits.split_at(digits.len() - decimals as usize);
    let sign = if ratio.num < 0 { "-" } else { "" };
    Some(match fraction.trim_end_matches('0') {
        "" => format!("{sign}{whole}"),
        fraction => format!("{sign}{whole}.{fraction}"),
    })
}

/// Returns a float as a decimal that reads back as the same.
pub(crate) fn shown(value: f64) -> String {
    let plain = format!("{value}");
    if plain.len() <= 24 { plain } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact_up_to_64_bits_and_24_digits() {
        let text = |raw, factor, offset| {
            let read = |text| Ratio::parse(text).expect("a number");
            decimal(raw, read(factor), read(offset))
        };
        assert_eq!(text(18_446_744_073_709_551_615, "1", "0"), "18446744073709551615");
        assert_eq!(text(-5, "0.00390625", "-40"), "-40.01953125");
        assert_eq!(text(255, "0.39215686275", "0"), "100.00000000125");
        assert_eq!(text(i128::from(u64::MAX), "0.123456789012345678901234", "0"), "2277375791072698400");
    }

    #[test]
    fn the_span_of_64_bits_is_whole() {
        assert_eq!(Number::Unsigned.span(64), (0, i128::from(u64::MAX)));
        assert_eq!(Number::Signed.span(64), (i128::from(i64::MIN), i128::from(i64::MAX)));
        assert_eq!(Number::Signed.of_bits(u64::MAX, 64), -1);
        assert_eq!(Number::Signed.of_bits(8, 4), -8);
        assert_eq!(Number::Float32.float(0x43C8_0000), 400.0);
    }
}
