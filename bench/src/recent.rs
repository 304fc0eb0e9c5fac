//! What happened last: a list that forgets its oldest part, so that a bench can run for hours.
//!
//! Every item has a number, from 0 on, that stays the same when older ones are forgotten: a reader remembers the number
//! of the next item that it wants. Refuses to know what the items are.

/// At least the last `keep` items of all that were pushed, and at most twice as many.
#[derive(Clone, Debug)]
pub struct Recent<T> {
    items: Vec<T>,
    keep: usize,
    forgotten: usize,
}

impl<T> Recent<T> {
    /// An empty list that keeps the last `keep` items.
    pub const fn keeping(keep: usize) -> Self {
        Self { items: Vec::new(), keep, forgotten: 0 }
    }

    /// Adds an item; when twice as many are there as are to be kept, the older half goes.
    pub fn push(&mut self, item: T) {
        if self.items.len() >= self.keep.saturating_mul(2).max(1) {
            let surplus = self.items.len() - self.keep;
            self.items.drain(..surplus);
            self.forgotten += surplus;
        }
        self.items.push(item);
    }

    /// Everything that is still there, oldest first.
    pub fn as_slice(&self) -> &[T] {
        &self.items
    }

    /// The items from `number` on that are still there.
    pub fn since(&self, number: usize) -> &[T] {
        let from = number.saturating_sub(self.forgotten).min(self.items.len());
        &self.items[from..]
    }

    /// Number of the item that comes next: how many were pushed.
    pub const fn next_number(&self) -> usize {
        self.forgotten + self.items.len()
    }

    /// The last item.
    pub fn last(&self) -> Option<&T> {
        self.items.last()
    }

    /// The last item, to complete it.
    pub fn last_mut(&mut self) -> Option<&mut T> {
        self.items.last_mut()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_oldest_are_forgotten_and_the_numbers_stay() {
        let mut recent = Recent::keeping(3);
        for number in 0..100 {
            recent.push(number);
            assert!(recent.as_slice().len() <= 6, "bounded");
            assert!(recent.as_slice().ends_with(&[number]));
        }
        assert_eq!(recent.next_number(), 100);
        assert_eq!(recent.since(98), [98, 99]);
        assert!(recent.since(100).is_empty());
        assert!(recent.since(1_000).is_empty());
        assert!(recent.since(0).len() >= 3, "what is still there");
        assert_eq!(recent.since(0), recent.as_slice());
    }
}
