//! The list in which a chip model complains.
//!
//! Keeps the first complaints and counts all of them, so that a firmware which breaks a rule once per pixel stays
//! readable.

use std::fmt;

use crate::time::Nanos;

/// Complaints that are kept word by word.
const KEPT: usize = 64;

/// Complaints of type `V`, each with its time.
#[derive(Clone, Debug)]
pub struct Violations<V> {
    kept: Vec<(Nanos, V)>,
    total: u64,
}

impl<V> Default for Violations<V> {
    fn default() -> Self {
        Self { kept: Vec::new(), total: 0 }
    }
}

impl<V> Violations<V> {
    /// Adds a complaint.
    pub fn report(&mut self, at: Nanos, violation: V) {
        self.total += 1;
        if self.kept.len() < KEPT {
            self.kept.push((at, violation));
        }
    }

    /// The first complaints, oldest first.
    pub fn first(&self) -> &[(Nanos, V)] {
        &self.kept
    }

    /// The number of all complaints.
    pub fn total(&self) -> u64 {
        self.total
    }

    /// True if there was none.
    pub fn is_empty(&self) -> bool {
        self.total == 0
    }

    /// Forgets all complaints, for a test that has provoked some.
    pub fn clear(&mut self) {
        *self = Self::default();
    }
}

/// One complaint per line: time, then what.
impl<V: fmt::Display> fmt::Display for Violations<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.kept.iter().try_for_each(|(at, violation)| writeln!(f, "{at}: {violation}"))?;
        match self.total - self.kept.len() as u64 {
            0 => Ok(()),
            more => writeln!(f, "and {more} more"),
        }
    }
}
