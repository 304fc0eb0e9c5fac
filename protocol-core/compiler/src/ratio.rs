//! Exact fractions: a factor of a DBC file never passes through a float.

use std::ops::{Div, Mul, Sub};

/// A fraction in lowest terms with a positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Ratio {
    pub(crate) num: i128,
    pub(crate) den: i128,
}

fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

impl Ratio {
    pub(crate) const ZERO: Self = Self { num: 0, den: 1 };

    pub(crate) fn new(num: i128, den: i128) -> Self {
        let by = gcd(num, den).max(1) * den.signum();
        Self { num: num / by, den: den / by }
    }

    pub(crate) fn whole(num: i128) -> Self {
        Self { num, den: 1 }
    }

    /// Reads a decimal number of a DBC file, for example `-0.00390625` or `1e-3`.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let (digits, exponent) = match text.find(['e', 'E']) {
            Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let joined = format!("{whole}{fraction}");
        if joined.len() > 24 || exponent.abs() > 12 {
            return None;
        }
        let number: i128 = joined.parse().ok()?;
        let shift = exponent - i32::try_from(fraction.len()).ok()?;
        let power = 10i128.pow(shift.unsigned_abs());
        Some(if shift < 0 { Self::new(number, power) } else { Self::new(number * power, 1) })
    }

    pub(crate) fn floor(self) -> i128 {
        self.num.div_euclid(self.den)
    }

    pub(crate) fn ceil(self) -> i128 {
        -(-self.num).div_euclid(self.den)
    }
}

// Numbers of 24 digits are read; what their sums and quotients need beyond 127 bits is told, not lost.
impl Ratio {
    pub(crate) fn checked_sub(self, other: Self) -> Option<Self> {
        let (a, b) = (self.num.checked_mul(other.den)?, other.num.checked_mul(self.den)?);
        Some(Self::new(a.checked_sub(b)?, self.den.checked_mul(other.den)?))
    }

    /// Returns `self / other`, `None` if `other` is 0 too.
    pub(crate) fn checked_div(self, other: Self) -> Option<Self> {
        let (num, den) = (self.num.checked_mul(other.den)?, self.den.checked_mul(other.num)?);
        (den != 0).then(|| Self::new(num, den))
    }
}

/// For numbers that a [`Linear`] has proved short.
impl Mul for Ratio {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.num * other.num, self.den * other.den)
    }
}

/// For numbers that a [`Linear`] has proved short.
impl Sub for Ratio {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.num * other.den - other.num * self.den, self.den * other.den)
    }
}

/// For numbers that a [`Linear`] has proved short.
impl Div for Ratio {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::new(self.num * other.den, self.den * other.num)
    }
}

/// `(x * mul + add) / den`, in lowest terms with `den` at least 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Linear {
    pub(crate) mul: i64,
    pub(crate) add: i64,
    pub(crate) den: i64,
}

impl Linear {
    /// Returns `x * factor + offset`, `None` if a term needs more than 31 bits.
    pub(crate) fn new(factor: Ratio, offset: Ratio) -> Option<Self> {
        let den = factor.den.checked_mul(offset.den / gcd(factor.den, offset.den).max(1))?;
        let mul = factor.num.checked_mul(den / factor.den)?;
        let add = offset.num.checked_mul(den / offset.den)?;
        let narrow = |number: i128| i32::try_from(number).ok().map(i64::from);
        Some(Self { mul: narrow(mul)?, add: narrow(add)?, den: narrow(den)? })
    }

    /// Returns the value of `x`, rounded down.
    pub(crate) fn floor(self, x: i64) -> i64 {
        (x * self.mul + self.add).div_euclid(self.den)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_read_exactly() {
        assert_eq!(Ratio::parse("0.00390625"), Some(Ratio::new(1, 256)));
        assert_eq!(Ratio::parse("-3000"), Some(Ratio::whole(-3000)));
        assert_eq!(Ratio::parse("-0.5"), Some(Ratio::new(-1, 2)));
        assert_eq!(Ratio::parse("2.5E-3"), Some(Ratio::new(1, 400)));
        assert_eq!(Ratio::parse("536870911.875"), Some(Ratio::new(4_294_967_295, 8)));
        assert_eq!(Ratio::parse(""), None);
        assert_eq!(Ratio::parse("0x10"), None);
    }

    #[test]
    fn floor_and_ceiling_hold_below_zero() {
        assert_eq!((Ratio::new(-7, 2).floor(), Ratio::new(-7, 2).ceil()), (-4, -3));
        assert_eq!((Ratio::new(7, 2).floor(), Ratio::new(7, 2).ceil()), (3, 4));
    }

    #[test]
    fn what_needs_too_many_bits_is_told() {
        let parse = |text| Ratio::parse(text).expect("a number of at most 24 digits");
        let (long, short) = (parse("999999999999999999999999"), parse("0.00000000000000000000001"));
        assert_eq!((long.checked_sub(short), short.checked_div(long)), (None, None));
        assert_eq!((Linear::new(short, long), Linear::new(long, Ratio::ZERO)), (None, None));
        assert_eq!(long.checked_div(Ratio::ZERO), None);
    }

    #[test]
    fn a_linear_function_is_in_lowest_terms() {
        let torque = Linear::new(Ratio::new(1, 10), Ratio::whole(-3000));
        assert_eq!(torque, Some(Linear { mul: 1, add: -30000, den: 10 }));
        let half = Linear::new(Ratio::new(2, 5), Ratio::ZERO);
        assert_eq!(half, Some(Linear { mul: 2, add: 0, den: 5 }));
    }
}
