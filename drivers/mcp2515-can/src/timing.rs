//! Bit timing: from crystal and bit rate to CNF1, CNF2 and CNF3.
//!
//! A bit is 1 quantum of synchronisation, `Prop + PS1` before the sample point and `PS2` after it; one quantum is
//! `2 * BRP` crystal periods. The solver tries every prescaler and keeps the exact bit rate whose sample point is
//! nearest to the wish; it runs at compile time where crystal and rate are constants.
//! Source: DS20001801 section 5 (limits in 5.3 and registers 5-1 to 5-3); the `mcp2515` crate's table samples at
//! 75 % three times, J1939-11 asks for 87.5 % once.

/// Limits of the bit timing logic, in quanta unless said otherwise.
pub mod limits {
    /// Prescaler (CNF1.BRP + 1).
    pub const BRP: (u32, u32) = (1, 64);
    /// Propagation segment (CNF2.PRSEG + 1).
    pub const PROP: (u32, u32) = (1, 8);
    /// Phase segment 1 (CNF2.PHSEG1 + 1).
    pub const PS1: (u32, u32) = (1, 8);
    /// Phase segment 2 (CNF3.PHSEG2 + 1); 2 is the chip's information processing time.
    pub const PS2: (u32, u32) = (2, 8);
    /// Synchronisation jump width (CNF1.SJW + 1).
    pub const SJW: (u32, u32) = (1, 4);
    /// Whole bit.
    pub const BIT: (u32, u32) = (5, 25);
}

/// Why no bit timing exists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimingError {
    /// No prescaler divides the crystal into this bit rate exactly: take another crystal or another rate.
    NoExactRate,
    /// The crystal is too slow: a bit would have too few quanta for the chip's segments.
    CrystalTooSlow,
}

/// The segments of one bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BitTiming {
    /// Prescaler, 1 to 64.
    pub brp: u8,
    /// Propagation segment, 1 to 8 quanta.
    pub prop: u8,
    /// Phase segment 1, 1 to 8 quanta.
    pub ps1: u8,
    /// Phase segment 2, 2 to 8 quanta.
    pub ps2: u8,
    /// Synchronisation jump width, 1 to 4 quanta.
    pub sjw: u8,
}

/// Sample point that J1939-11 and CiA 301 recommend, in thousandths of a bit.
pub const SAMPLE_POINT: u32 = 875;

impl BitTiming {
    /// Returns the timing with the sample point nearest to `sample_permille`, from a crystal of `oscillator_hz`.
    ///
    /// # Errors
    /// When the rate cannot be met exactly, or only with a bit shorter than the chip's shortest.
    pub const fn solve(oscillator_hz: u32, bitrate: u32, sample_permille: u32) -> Result<Self, TimingError> {
        let mut best: Option<Self> = None;
        let mut best_distance = u32::MAX;
        let mut exact = false;
        let mut brp = limits::BRP.0;
        while brp <= limits::BRP.1 {
            let cycles = 2 * brp as u64 * bitrate as u64;
            if cycles != 0 && (oscillator_hz as u64).is_multiple_of(cycles) {
                exact = true;
                let bit = oscillator_hz as u64 / cycles;
                if bit >= limits::BIT.0 as u64 && bit <= limits::BIT.1 as u64 {
                    let mut ps2 = limits::PS2.0;
                    while ps2 <= limits::PS2.1 {
                        if let Some(timing) = Self::split(brp, bit as u32, ps2) {
                            let distance = timing.sample_permille().abs_diff(sample_permille);
                            // Lower prescalers come first: of equal sample points the finest quantum stays.
                            if distance < best_distance {
                                best = Some(timing);
                                best_distance = distance;
                            }
                        }
                        ps2 += 1;
                    }
                }
            }
            brp += 1;
        }
        match best {
            Some(timing) => Ok(timing),
            None if exact => Err(TimingError::CrystalTooSlow),
            None => Err(TimingError::NoExactRate),
        }
    }

    /// Same as [`Self::solve`] for constants: what cannot be met does not compile.
    ///
    /// # Panics
    /// At compile time, when there is no solution.
    pub const fn require(oscillator_hz: u32, bitrate: u32) -> Self {
        match Self::solve(oscillator_hz, bitrate, SAMPLE_POINT) {
            Ok(timing) => timing,
            Err(TimingError::NoExactRate) => panic!("no prescaler divides this crystal into this bit rate"),
            Err(TimingError::CrystalTooSlow) => panic!("this crystal is too slow for this bit rate"),
        }
    }

    /// Splits a bit of `bit` quanta so that `ps2` of them lie after the sample point.
    const fn split(brp: u32, bit: u32, ps2: u32) -> Option<Self> {
        if bit < 1 + ps2 + limits::PROP.0 + limits::PS1.0 {
            return None;
        }
        let before = bit - 1 - ps2;
        let ps1 =
            if before - limits::PROP.0 < limits::PS1.1 { before - limits::PROP.0 } else { limits::PS1.1 };
        let prop = before - ps1;
        if prop > limits::PROP.1 || before < ps2 {
            return None;
        }
        // PS2 > SJW; a wide jump tolerates the worst crystals.
        let sjw = if ps2 - 1 < limits::SJW.1 { ps2 - 1 } else { limits::SJW.1 };
        Some(Self { brp: brp as u8, prop: prop as u8, ps1: ps1 as u8, ps2: ps2 as u8, sjw: sjw as u8 })
    }

    /// Returns the quanta of one bit.
    pub const fn quanta(self) -> u32 {
        1 + self.prop as u32 + self.ps1 as u32 + self.ps2 as u32
    }

    /// Returns the sample point in thousandths of a bit.
    pub const fn sample_permille(self) -> u32 {
        (self.quanta() - self.ps2 as u32) * 1000 / self.quanta()
    }

    /// Returns the bit rate that a crystal of `oscillator_hz` gives.
    pub const fn bitrate(self, oscillator_hz: u32) -> u32 {
        oscillator_hz / (2 * self.brp as u32 * self.quanta())
    }

    /// Returns CNF3, CNF2, CNF1 in the order of their addresses (0x28 to 0x2A).
    pub const fn registers(self) -> [u8; 3] {
        // PS2 from its own field, not from PS1; one sample per bit (CNF2.BTLMODE = 1, CNF2.SAM = 0).
        const BTLMODE: u8 = 0x80;
        [self.ps2 - 1, BTLMODE | (self.ps1 - 1) << 3 | (self.prop - 1), (self.sjw - 1) << 6 | (self.brp - 1)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cnf123(oscillator_hz: u32, bitrate: u32) -> [u8; 3] {
        let [cnf3, cnf2, cnf1] = BitTiming::solve(oscillator_hz, bitrate, SAMPLE_POINT).unwrap().registers();
        [cnf1, cnf2, cnf3]
    }

    // CNF1, CNF2, CNF3 worked out by hand from registers 5-1 to 5-3.
    #[test]
    fn known_crystals_give_the_registers_worked_out_by_hand() {
        assert_eq!(cnf123(8_000_000, 250_000), [0x00, 0xBC, 0x01]);
        assert_eq!(cnf123(16_000_000, 250_000), [0x01, 0xBC, 0x01]);
        assert_eq!(cnf123(16_000_000, 500_000), [0x00, 0xBC, 0x01]);
        assert_eq!(cnf123(8_000_000, 125_000), [0x01, 0xBC, 0x01]);
    }

    #[test]
    fn eight_megahertz_at_500_kbit_can_only_sample_at_75_percent() {
        let timing = BitTiming::solve(8_000_000, 500_000, SAMPLE_POINT).unwrap();
        assert_eq!((timing.sample_permille(), timing.quanta(), timing.ps2), (750, 8, 2));
    }

    #[test]
    fn impossible_rates_say_why() {
        assert_eq!(BitTiming::solve(8_000_000, 1_000_000, SAMPLE_POINT), Err(TimingError::CrystalTooSlow));
        assert_eq!(BitTiming::solve(8_000_000, 300_000, SAMPLE_POINT), Err(TimingError::NoExactRate));
        assert_eq!(BitTiming::solve(8_000_000, 0, SAMPLE_POINT), Err(TimingError::NoExactRate));
        assert_eq!(BitTiming::solve(0, 250_000, SAMPLE_POINT), Err(TimingError::CrystalTooSlow));
    }

    #[test]
    fn constants_are_solved_at_compile_time() {
        const TIMING: BitTiming = BitTiming::require(16_000_000, 250_000);
        assert_eq!(TIMING.quanta(), 16);
    }

    // The limits are written out again as numbers: DS20001801 5.3 and the table of Linux's driver agree on them.
    #[test]
    fn every_solution_meets_every_limit_and_the_exact_rate() {
        for oscillator in [4, 8, 10, 12, 16, 20, 24, 25, 40].map(|mhz| mhz * 1_000_000) {
            for rate in [10, 20, 50, 100, 125, 200, 250, 400, 500, 800, 1000].map(|k| k * 1000) {
                for point in [500, 750, 800, 875, 900] {
                    let Ok(t) = BitTiming::solve(oscillator, rate, point) else { continue };
                    assert!((1..=64).contains(&t.brp), "{t:?}");
                    assert!((1..=8).contains(&t.prop) && (1..=8).contains(&t.ps1), "{t:?}");
                    assert!((2..=8).contains(&t.ps2) && (1..=4).contains(&t.sjw), "{t:?}");
                    assert!(t.prop + t.ps1 >= t.ps2 && t.ps2 > t.sjw, "{t:?}");
                    assert_eq!(2 * u32::from(t.brp) * t.quanta() * rate, oscillator, "{t:?}");
                    assert_eq!(t.bitrate(oscillator), rate);
                }
            }
        }
    }
}
