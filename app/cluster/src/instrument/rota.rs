//! Which faults of a list are reported in one round: those that are new, and one in turn.
//!
//! The link to a PC is slow: a list goes out piece by piece, for a PC that came later too. Refuses to know records.

use protocol_core::Millis;

/// New faults that are reported in one round: what comes in one burst beyond them waits for its turn.
const AT_ONCE: usize = 4;

/// How far the reports of one list are.
#[derive(Clone, Debug, Default)]
pub struct Rota {
    /// Place in the list whose turn it is.
    turn: usize,
    /// All that came before this have been reported, or wait for their turn.
    until: Millis,
}

impl Rota {
    /// Returns a rota of which nothing has been reported.
    pub const fn new() -> Self {
        Self { turn: 0, until: Millis(0) }
    }

    /// Reports what is new and what has its turn; returns whether the list has any entries.
    ///
    /// `entry` gives what stands at a place of the list and when it came, `None` = the list is shorter.
    pub fn round<T>(
        &mut self,
        now: Millis,
        mut entry: impl FnMut(usize) -> Option<(T, Millis)>,
        mut report: impl FnMut(&T),
    ) -> bool {
        let (mut length, mut at_once) = (0, 0);
        while let Some((item, came)) = entry(length) {
            let is_new = came >= self.until && at_once < AT_ONCE;
            if is_new || length == self.turn {
                at_once += usize::from(is_new);
                report(&item);
            }
            length += 1;
        }
        self.turn = if self.turn + 1 < length { self.turn + 1 } else { 0 };
        self.until = now;
        length > 0
    }
}
