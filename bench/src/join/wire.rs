//! Bytes to and from another program: what a line is sent over, and the queue in front of it.
//!
//! Nothing here waits. A reader that is too slow costs the oldest lines, whole ones, and they are counted: memory stays
//! bounded whatever the other side does.

use std::collections::VecDeque;
use std::io;

/// Two-way bytes that never wait.
pub trait Wire: Send {
    /// Reads what is there; 0 = nothing now.
    ///
    /// # Errors
    /// If the wire itself is gone, not only who is at its other end.
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize>;

    /// Writes as much as fits and returns how much that was.
    ///
    /// # Errors
    /// Like [`Wire::read`].
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize>;

    /// Returns whether somebody is at the other end.
    ///
    /// # Errors
    /// Like [`Wire::read`].
    fn is_connected(&mut self) -> io::Result<bool>;
}

/// Lines that wait to be written.
#[derive(Clone, Debug)]
pub struct Outbox {
    lines: VecDeque<Vec<u8>>,
    /// Bytes of the first line that are written.
    written: usize,
    limit: usize,
}

impl Outbox {
    /// A queue of at most `limit` lines, at least 2.
    pub fn new(limit: usize) -> Self {
        Self { lines: VecDeque::new(), written: 0, limit: limit.max(2) }
    }

    /// Takes a line; `false` if the oldest one had to go for it.
    pub fn push(&mut self, line: Vec<u8>) -> bool {
        let full = self.lines.len() >= self.limit;
        if full {
            // A line that has begun must be finished, or the reader joins two halves.
            let oldest = usize::from(self.written > 0);
            self.lines.remove(oldest);
        }
        self.lines.push_back(line);
        !full
    }

    /// Lines that wait.
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// Nothing waits.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// No further line fits.
    pub fn is_full(&self) -> bool {
        self.lines.len() >= self.limit
    }

    /// Throws everything away: who was to read it is gone.
    pub fn clear(&mut self) {
        self.lines.clear();
        self.written = 0;
    }

    /// Writes as much as the wire takes.
    ///
    /// # Errors
    /// If the wire is gone.
    pub fn flush(&mut self, wire: &mut impl Wire) -> io::Result<()> {
        // Ends: every pass writes at least one byte or leaves.
        while let Some(line) = self.lines.front() {
            let rest = &line[self.written..];
            if !rest.is_empty() {
                match wire.write(rest)? {
                    0 => return Ok(()),
                    count => self.written += count,
                }
            }
            if self.written >= line.len() {
                self.lines.pop_front();
                self.written = 0;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A wire in memory.
    #[derive(Debug, Default)]
    pub(crate) struct Memory {
        /// What the other side has written.
        pub(crate) incoming: VecDeque<u8>,
        /// What the other side can read.
        pub(crate) outgoing: Vec<u8>,
        /// Bytes that fit.
        pub(crate) room: usize,
        /// The other side has gone.
        pub(crate) gone: bool,
    }

    impl Wire for Memory {
        fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
            let count = into.len().min(self.incoming.len());
            for (place, byte) in into.iter_mut().zip(self.incoming.drain(..count)) {
                *place = byte;
            }
            Ok(count)
        }

        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let count = bytes.len().min(self.room);
            self.outgoing.extend_from_slice(&bytes[..count]);
            self.room -= count;
            Ok(count)
        }

        fn is_connected(&mut self) -> io::Result<bool> {
            Ok(!self.gone)
        }
    }

    #[test]
    fn a_line_is_written_in_parts_as_the_wire_takes_them() {
        let mut outbox = Outbox::new(4);
        let mut wire = Memory { room: 3, ..Memory::default() };
        assert!(outbox.push(b"first\r".to_vec()) && outbox.push(b"second\r".to_vec()));
        outbox.flush(&mut wire).unwrap();
        assert_eq!(wire.outgoing, b"fir");
        wire.room = 100;
        outbox.flush(&mut wire).unwrap();
        assert_eq!(wire.outgoing, b"first\rsecond\r");
        assert!(outbox.is_empty());
    }

    #[test]
    fn a_full_queue_loses_its_oldest_whole_line_and_never_half_of_one() {
        let mut outbox = Outbox::new(3);
        let mut wire = Memory { room: 1, ..Memory::default() };
        let kept: Vec<bool> = [&b"a1\r"[..], b"b2\r", b"c3\r"].map(|line| outbox.push(line.to_vec())).into();
        assert_eq!(kept, [true; 3]);
        outbox.flush(&mut wire).unwrap();
        assert!(!outbox.push(b"d4\r".to_vec()));
        wire.room = 100;
        outbox.flush(&mut wire).unwrap();
        assert_eq!(wire.outgoing, b"a1\rc3\rd4\r");
    }
}
