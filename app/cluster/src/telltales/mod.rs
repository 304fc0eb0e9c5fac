//! When a telltale is lit: the table of `table`, and the memory that hysteresis and silence need.
//!
//! A telltale lights when one of its conditions is met. Silence darkens what is healthy or harmless and keeps what warns
//! as it last was (BUS-108). The check after start lies over this, so a real fault stays lit when it ends.

mod table;

pub use table::{Place, Telltale, TelltaleColour, Telltales};

use crate::facts::Facts;
use protocol_core::model::Shown;
use table::{Condition, ROWS, Silence, When};

/// Which conditions are met: bit n = the n-th of all rows, in order.
#[derive(Clone, Copy)]
pub(crate) struct Lighting {
    met: u64,
}

const _: () = {
    let (mut row, mut conditions) = (0, 0);
    while row < ROWS.len() {
        conditions += ROWS[row].conditions.len();
        row += 1;
    }
    assert!(conditions <= u64::BITS as usize, "one bit of memory per condition");
    assert!(ROWS.len() <= u32::BITS as usize, "one bit in records per telltale");
};

/// Every condition with its telltale and what silence does to it.
fn conditions() -> impl Iterator<Item = (Telltale, Silence, &'static Condition)> {
    let rows = Telltale::ALL.iter().zip(ROWS);
    rows.flat_map(|(&telltale, row)| row.conditions.iter().map(move |one| (telltale, row.silence, one)))
}

impl Lighting {
    pub(crate) const fn new() -> Self {
        Self { met: 0 }
    }

    /// Evaluates the table.
    pub(crate) fn tick(&mut self, facts: &Facts<'_>) {
        let before = self.met;
        self.met = 0;
        for (index, (_, silence, condition)) in conditions().enumerate() {
            let was_met = before >> index & 1 != 0;
            self.met |= u64::from(condition.is_met(was_met, silence, facts)) << index;
        }
    }

    /// Returns the lit telltales.
    pub(crate) fn lit(&self) -> Telltales {
        let mut lit = Telltales::NONE;
        for (index, (telltale, ..)) in conditions().enumerate() {
            if self.met >> index & 1 != 0 {
                lit.set(telltale, true);
            }
        }
        lit
    }
}

impl Condition {
    fn is_met(&self, before: bool, silence: Silence, facts: &Facts<'_>) -> bool {
        let value = match self.when {
            When::Is(value, _) | When::AtLeast(value, _) | When::Low(value, ..) => value,
            When::AnySilent => return !facts.silent.is_empty(),
        };
        if self.unless_sent.is_some_and(|value| facts.is_sent(value)) {
            return false;
        }
        match (facts.shown(value), &self.when) {
            (Shown::Value(number), When::Is(_, wanted)) => number == *wanted,
            (Shown::Value(number), When::AtLeast(_, least)) => number >= *least,
            (Shown::Value(number), When::Low(_, on, off)) => number < *on || before && number <= *off,
            (Shown::Stale | Shown::Invalid, _) => before && silence == Silence::Keeps,
            _ => false,
        }
    }
}
