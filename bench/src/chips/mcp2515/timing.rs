//! MCP2515 bit timing: from CNF1..CNF3 and the crystal to a bit rate.
//!
//! Source: DS20001801J, chapter 5 (segments, rules 5.3) and registers 5-1 to 5-3.

/// Time quanta of the information processing time, the least phase segment 2.
const INFORMATION_PROCESSING: u32 = 2;
/// Time quanta per bit.
const QUANTA: std::ops::RangeInclusive<u32> = 8..=25;

/// The segments of one bit, in time quanta.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BitTiming {
    /// Oscillator clocks per time quantum (2, 4, ... 128).
    pub clocks_per_quantum: u32,
    /// Propagation segment, 1..=8.
    pub propagation: u32,
    /// Phase segment 1, 1..=8.
    pub phase_1: u32,
    /// Phase segment 2, 2..=8 when valid.
    pub phase_2: u32,
    /// Synchronisation jump width, 1..=4.
    pub jump: u32,
}

/// Why a bit timing must not be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimingFault {
    /// Phase segment 2 is shorter than the information processing time of two quanta.
    Phase2TooShort,
    /// Propagation segment + phase segment 1 < phase segment 2.
    Phase2TooLong,
    /// Phase segment 2 is not longer than the jump width.
    JumpTooWide,
    /// Fewer than 8 or more than 25 quanta per bit.
    QuantaOutOfRange,
}

impl BitTiming {
    /// Decodes the three registers.
    pub const fn of(cnf1: u8, cnf2: u8, cnf3: u8) -> Self {
        let phase_1 = (cnf2 >> 3 & 0b111) as u32 + 1;
        let own_phase_2 = cnf2 & 0x80 != 0; // BTLMODE
        let phase_2 = match own_phase_2 {
            true => (cnf3 & 0b111) as u32 + 1,
            false if phase_1 > INFORMATION_PROCESSING => phase_1,
            false => INFORMATION_PROCESSING,
        };
        Self {
            clocks_per_quantum: 2 * ((cnf1 & 0x3F) as u32 + 1),
            propagation: (cnf2 & 0b111) as u32 + 1,
            phase_1,
            phase_2,
            jump: (cnf1 >> 6) as u32 + 1,
        }
    }

    /// Time quanta per bit, with the synchronisation segment.
    pub const fn quanta(self) -> u32 {
        1 + self.propagation + self.phase_1 + self.phase_2
    }

    /// Bit rate in bit/s with a crystal of `crystal_hz`.
    pub const fn bitrate(self, crystal_hz: u32) -> u32 {
        crystal_hz / (self.clocks_per_quantum * self.quanta())
    }

    /// Sample point in thousandths of the bit.
    pub const fn sample_point_per_mille(self) -> u32 {
        (1 + self.propagation + self.phase_1) * 1_000 / self.quanta()
    }

    /// The first rule that this timing breaks.
    pub fn fault(self) -> Option<TimingFault> {
        let rules = [
            (self.phase_2 < INFORMATION_PROCESSING, TimingFault::Phase2TooShort),
            (self.propagation + self.phase_1 < self.phase_2, TimingFault::Phase2TooLong),
            (self.phase_2 <= self.jump, TimingFault::JumpTooWide),
            (!QUANTA.contains(&self.quanta()), TimingFault::QuantaOutOfRange),
        ];
        rules.into_iter().find(|&(broken, _)| broken).map(|(_, fault)| fault)
    }
}
