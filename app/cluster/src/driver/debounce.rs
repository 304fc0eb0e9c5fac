//! The levels of wires out of samples: bounces are shorter than three ticks, 30 ms.

/// Up to 32 wires, bit by bit; each has its own level.
#[derive(Clone, Copy)]
pub(crate) struct Debounce {
    levels: u32,
    /// The samples before, the older first: with the next one they are the three that make a level.
    before: [u32; 2],
}

impl Debounce {
    /// Returns wires that have had these levels for long.
    pub(crate) const fn new(levels: u32) -> Self {
        Self { levels, before: [levels; 2] }
    }

    /// Takes a sample of every wire and returns the levels: one changes with the third equal sample in a row.
    pub(crate) fn sample(&mut self, sample: u32) -> u32 {
        let [first, second] = self.before;
        let differ = first ^ second | second ^ sample;
        self.levels = self.levels & differ | sample & !differ;
        self.before = [second, sample];
        self.levels
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A second statement, for one wire: the level of the last three samples that were equal.
    fn stated(start: u32, samples: &[u32]) -> u32 {
        let at = |place: usize| place.checked_sub(3).map_or(start, |place| samples[place]);
        let mut ends = (2..samples.len() + 3).rev();
        ends.find(|&end| at(end) == at(end - 1) && at(end) == at(end - 2)).map_or(start, at)
    }

    #[test]
    fn a_level_is_what_the_last_three_equal_samples_were_in_every_history() {
        for history in 0..1_u32 << 12 {
            for start in [0, 1] {
                let samples: [u32; 12] = core::array::from_fn(|place| history >> place & 1);
                let mut wires = Debounce::new(start);
                for (index, sample) in samples.iter().enumerate() {
                    assert_eq!(wires.sample(*sample), stated(start, &samples[..=index]), "{samples:?}");
                }
            }
        }
    }

    #[test]
    fn a_wire_that_bounces_holds_up_no_other() {
        const STEADY: u32 = 1 << 31;
        let mut wires = Debounce::new(0);
        let levels: [u32; 6] = core::array::from_fn(|tick| wires.sample(STEADY | tick as u32 & 1));
        assert_eq!(levels, [0, 0, STEADY, STEADY, STEADY, STEADY]);
    }
}
