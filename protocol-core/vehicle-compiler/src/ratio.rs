//! Exact fractions: a factor of a DBC file never passes through a float.

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

    /// Reads a decimal number of a DBC file, for example `-0.00390625` or `1e-3`: the first 24 digits of it.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        const DIGITS: usize = 24;
        // 10^37 is the last power of ten of 127 bits that leaves room for a sign and a digit.
        const PLACES: i64 = 37;
        let (digits, exponent) = match text.find(['e', 'E']) {
            Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (sign, digits) = match digits.strip_prefix('-') {
            Some(digits) => (-1, digits),
            None => (1, digits.strip_prefix('+').unwrap_or(digits)),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let all = format!("{whole}{fraction}");
        if all.is_empty() || !all.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        let significant = all.trim_start_matches('0');
        let mut shift = i64::from(exponent) - i64::try_from(fraction.len()).ok()?;
        let mut kept = significant.len().min(DIGITS);
        shift += i64::try_from(significant.len() - kept).ok()?;
        // What is smaller than the smallest power of ten is nothing.
        while shift < -PLACES && kept > 0 {
            kept -= 1;
            shift += 1;
        }
        if kept == 0 {
            return Some(Self::ZERO);
        }
        let number: i128 = significant[..kept].parse().ok()?;
        let power = 10i128.checked_pow(u32::try_from(shift.unsigned_abs()).ok()?)?;
        Some(if shift < 0 {
            Self::new(sign * number, power)
        } else {
            Self::new(sign * number.checked_mul(power)?, 1)
        })
    }

    /// Returns the nearest float, for what is only shown or compared.
    pub(crate) fn approximately(self) -> f64 {
        self.num as f64 / self.den as f64
    }

    pub(crate) fn floor(self) -> i128 {
        self.num.div_euclid(self.den)
    }

    /// Returns the denominators of the fractions that come nearest (convergents of the continued fraction).
    fn convergents(self) -> Vec<i128> {
        let (mut num, mut den) = (self.num.abs(), self.den);
        let (mut before, mut last) = (0i128, 1i128);
        let mut found = Vec::new();
        while den != 0 && last < 1 << 31 {
            found.push(last);
            (num, den) = (den, num % den);
            if den == 0 {
                break;
            }
            let next = num / den;
            (before, last) = (last, next.saturating_mul(last).saturating_add(before));
        }
        found
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

    pub(crate) fn checked_add(self, other: Self) -> Option<Self> {
        let (a, b) = (self.num.checked_mul(other.den)?, other.num.checked_mul(self.den)?);
        Some(Self::new(a.checked_add(b)?, self.den.checked_mul(other.den)?))
    }

    pub(crate) fn checked_mul(self, other: Self) -> Option<Self> {
        // Crosswise in lowest terms first: a long factor times a short one seldom needs more bits.
        let (a, b) = (Self::new(self.num, other.den), Self::new(other.num, self.den));
        Some(Self::new(a.num.checked_mul(b.num)?, a.den.checked_mul(b.den)?))
    }

    /// Returns `self / other`, `None` if `other` is 0 too.
    pub(crate) fn checked_div(self, other: Self) -> Option<Self> {
        let (num, den) = (self.num.checked_mul(other.den)?, self.den.checked_mul(other.num)?);
        (den != 0).then(|| Self::new(num, den))
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

    /// Returns the nearest function to `x * factor + offset` whose terms need 31 bits at most, and how far it is off at
    /// most while `x` is within `low` to `high`.
    pub(crate) fn near(factor: Ratio, offset: Ratio, (low, high): (i128, i128)) -> Option<(Self, f64)> {
        if let Some(exact) = Self::new(factor, offset) {
            return Some((exact, 0.0));
        }
        let (f, o) = (factor.approximately(), offset.approximately());
        let longest = low.unsigned_abs().max(high.unsigned_abs()) as f64;
        let candidate = |den: i128| {
            let term = |ratio: Ratio| {
                let scaled = ratio.num.checked_mul(den)?.checked_mul(2)?.checked_add(ratio.den)?;
                i32::try_from(scaled.div_euclid(ratio.den.checked_mul(2)?)).ok().map(i64::from)
            };
            let den = i64::from(i32::try_from(den).ok()?);
            let (mul, add) = (term(factor)?, term(offset)?);
            let [mul_off, add_off] =
                [(mul, f), (add, o)].map(|(term, exact)| (term as f64 / den as f64 - exact).abs());
            (mul != 0).then_some((Self { mul, add, den }, longest * mul_off + add_off))
        };
        let powers = (0..31).map(|bits| 1i128 << bits).chain((0..10).map(|places| 10i128.pow(places)));
        let dens = powers.chain(factor.convergents()).flat_map(|den| [den, den.saturating_mul(offset.den)]);
        dens.filter_map(candidate).min_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    /// Returns the value of `x`, rounded down; `None` if a step needs more than 63 bits.
    pub(crate) fn checked_floor(self, x: i64) -> Option<i64> {
        Some(x.checked_mul(self.mul)?.checked_add(self.add)?.div_euclid(self.den))
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
        let parse = |text| Ratio::parse(text).expect("a number");
        let (long, short) = (parse("999999999999999999999999"), parse("0.00000000000000000000001"));
        assert_eq!((long.checked_sub(short), short.checked_div(long)), (None, None));
        assert_eq!((Linear::new(short, long), Linear::new(long, Ratio::ZERO)), (None, None));
        assert_eq!(long.checked_div(Ratio::ZERO), None);
    }

    #[test]
    fn a_long_number_is_cut_to_its_first_digits_and_a_huge_one_is_none() {
        assert_eq!(Ratio::parse("0.1000000000000000000000000000000001"), Some(Ratio::new(1, 10)));
        assert_eq!(Ratio::parse("000000000000000000000000000000000012.50"), Some(Ratio::new(25, 2)));
        assert_eq!(Ratio::parse("1.84467440737096E+019"), Some(Ratio::whole(18_446_744_073_709_600_000)));
        assert_eq!(Ratio::parse("1e-400"), Some(Ratio::ZERO));
        assert_eq!(Ratio::parse("1.7976931348623157E+308"), None);
        assert_eq!(Ratio::parse("-"), None);
    }

    #[test]
    fn a_factor_of_many_digits_has_a_near_fraction_of_31_bits() {
        let factor = Ratio::parse("0.39215686275").expect("a number");
        let (near, off) = Linear::near(factor, Ratio::ZERO, (0, 255)).expect("one is near");
        assert_eq!(near, Linear { mul: 20, add: 0, den: 51 });
        assert!(off < 2e-9, "{off}");
        let factor = Ratio::parse("0.001221299164314").expect("a number");
        let (_, off) = Linear::near(factor, Ratio::parse("-40.00000000001").expect("a number"), (0, 65_535))
            .expect("one");
        assert!(off < 1e-4, "{off}");
        assert_eq!(Linear::near(Ratio::new(1, 2), Ratio::ZERO, (0, 9)).map(|(_, off)| off), Some(0.0));
    }

    #[test]
    fn a_linear_function_is_in_lowest_terms() {
        let torque = Linear::new(Ratio::new(1, 10), Ratio::whole(-3000));
        assert_eq!(torque, Some(Linear { mul: 1, add: -30000, den: 10 }));
        let half = Linear::new(Ratio::new(2, 5), Ratio::ZERO);
        assert_eq!(half, Some(Linear { mul: 2, add: 0, den: 5 }));
    }
}
