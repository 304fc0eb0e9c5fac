//! A push of a button out of the level of its wire, sampled every tick.

/// Equal samples that make a level: bounces are shorter.
const STEADY: u8 = 3;

/// One wire.
#[derive(Clone, Copy)]
pub(crate) struct Debounce {
    is_down: bool,
    /// Samples in a row that differ from `is_down`.
    differ: u8,
}

impl Debounce {
    /// Returns a wire that is up; a button held down since power-on counts once.
    pub(crate) const fn new() -> Self {
        Self { is_down: false, differ: 0 }
    }

    /// Takes one sample; returns whether it completes a push.
    pub(crate) fn pushed(&mut self, down: bool) -> bool {
        self.differ = if down == self.is_down { 0 } else { self.differ + 1 };
        if self.differ < STEADY {
            return false;
        }
        (self.is_down, self.differ) = (down, 0);
        down
    }
}
