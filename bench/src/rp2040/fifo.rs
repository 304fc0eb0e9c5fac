//! Fixed-depth FIFO of the peripherals.
//!
//! Owns nothing but its entries; what happens when it is full or empty is for its peripheral to say.

/// A FIFO of `DEPTH` entries (a power of two).
#[derive(Clone, Debug)]
pub(super) struct Fifo<const DEPTH: usize> {
    entries: [u16; DEPTH],
    head: usize,
    len: usize,
}

impl<const DEPTH: usize> Fifo<DEPTH> {
    pub(super) fn new() -> Self {
        const { assert!(DEPTH.is_power_of_two()) };
        Self { entries: [0; DEPTH], head: 0, len: 0 }
    }

    #[inline]
    pub(super) fn len(&self) -> usize {
        self.len
    }

    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.len == 0
    }

    #[inline]
    pub(super) fn is_full(&self) -> bool {
        self.len == DEPTH
    }

    /// Appends `entry`; `false` if there was no room.
    #[inline]
    pub(super) fn push(&mut self, entry: u16) -> bool {
        if self.is_full() {
            return false;
        }
        self.entries[(self.head + self.len) % DEPTH] = entry;
        self.len += 1;
        true
    }

    #[inline]
    pub(super) fn pop(&mut self) -> Option<u16> {
        if self.len == 0 {
            return None;
        }
        let entry = self.entries[self.head];
        self.head = (self.head + 1) % DEPTH;
        self.len -= 1;
        Some(entry)
    }
}
