//! APSR flags and the additions and shifts that set them.
//!
//! Owns N, Z, C, V and the pure arithmetic behind them. The flags are kept as the words they were computed from:
//! a branch costs one test, an instruction two or three stores.
//!
//! Source: ARMv6-M Architecture Reference Manual (DDI 0419), A2.2.1 AddWithCarry and the shift pseudocode.

const N_BIT: u32 = 1 << 31;
const Z_BIT: u32 = 1 << 30;
const C_BIT: u32 = 1 << 29;
const V_BIT: u32 = 1 << 28;

/// The four condition flags.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flags {
    /// N is bit 31.
    negative: u32,
    /// Z is set when this word is 0.
    zero: u32,
    /// C.
    pub(super) carry: bool,
    /// V is bit 31.
    overflow: u32,
}

impl Default for Flags {
    fn default() -> Self {
        Self::from_apsr(0)
    }
}

impl Flags {
    pub(super) const fn from_apsr(apsr: u32) -> Self {
        Self {
            negative: apsr & N_BIT,
            zero: (apsr & Z_BIT) ^ Z_BIT,
            carry: apsr & C_BIT != 0,
            overflow: if apsr & V_BIT != 0 { N_BIT } else { 0 },
        }
    }

    pub(super) const fn apsr(self) -> u32 {
        (if self.n() { N_BIT } else { 0 })
            | (if self.z() { Z_BIT } else { 0 })
            | (if self.carry { C_BIT } else { 0 })
            | (if self.v() { V_BIT } else { 0 })
    }

    #[inline(always)]
    pub(super) const fn n(self) -> bool {
        self.negative & N_BIT != 0
    }

    #[inline(always)]
    pub(super) const fn z(self) -> bool {
        self.zero == 0
    }

    #[inline(always)]
    pub(super) const fn v(self) -> bool {
        self.overflow & N_BIT != 0
    }

    /// Signed "greater or equal": N equals V.
    #[inline(always)]
    pub(super) const fn ge(self) -> bool {
        (self.negative ^ self.overflow) & N_BIT == 0
    }

    /// Sets N and Z from a result; C and V stay.
    #[inline(always)]
    pub(super) fn set_nz(&mut self, result: u32) -> u32 {
        self.negative = result;
        self.zero = result;
        result
    }

    /// Sets N and Z from a shifter's result and C from its carry out; V stays.
    #[inline(always)]
    pub(super) fn set_nzc(&mut self, (result, carry): (u32, bool)) -> u32 {
        self.carry = carry;
        self.set_nz(result)
    }

    /// `a + b`, all flags.
    #[inline(always)]
    pub(super) fn add(&mut self, a: u32, b: u32) -> u32 {
        let (result, carry) = a.overflowing_add(b);
        self.carry = carry;
        self.overflow = (a ^ result) & (b ^ result);
        self.set_nz(result)
    }

    /// `a - b`, all flags; C is "no borrow".
    #[inline(always)]
    pub(super) fn sub(&mut self, a: u32, b: u32) -> u32 {
        let result = a.wrapping_sub(b);
        self.carry = a >= b;
        self.overflow = (a ^ b) & (a ^ result);
        self.set_nz(result)
    }

    /// `a + b + C`, all flags.
    #[inline(always)]
    pub(super) fn adc(&mut self, a: u32, b: u32) -> u32 {
        let sum = u64::from(a) + u64::from(b) + u64::from(self.carry);
        #[expect(clippy::cast_possible_truncation, reason = "the low word is the result")]
        let result = sum as u32;
        self.carry = sum >> 32 != 0;
        self.overflow = (a ^ result) & (b ^ result);
        self.set_nz(result)
    }
}

// Shifts by a register use its low byte: 0 leaves C alone, 32 and more are not what `<<` does.

#[inline(always)]
pub(super) const fn lsl(value: u32, count: u32, carry: bool) -> (u32, bool) {
    match count {
        0 => (value, carry),
        1..=31 => (value << count, value >> (32 - count) & 1 != 0),
        32 => (0, value & 1 != 0),
        _ => (0, false),
    }
}

#[inline(always)]
pub(super) const fn lsr(value: u32, count: u32, carry: bool) -> (u32, bool) {
    match count {
        0 => (value, carry),
        1..=31 => (value >> count, value >> (count - 1) & 1 != 0),
        32 => (0, value & N_BIT != 0),
        _ => (0, false),
    }
}

#[inline(always)]
pub(super) const fn asr(value: u32, count: u32, carry: bool) -> (u32, bool) {
    match count {
        0 => (value, carry),
        1..=31 => ((value.cast_signed() >> count).cast_unsigned(), value >> (count - 1) & 1 != 0),
        _ => ((value.cast_signed() >> 31).cast_unsigned(), value & N_BIT != 0),
    }
}

#[inline(always)]
pub(super) const fn ror(value: u32, count: u32, carry: bool) -> (u32, bool) {
    if count == 0 {
        return (value, carry);
    }
    let result = value.rotate_right(count & 31);
    (result, result & N_BIT != 0)
}
