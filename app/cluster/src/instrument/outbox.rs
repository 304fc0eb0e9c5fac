//! Frames that wait for the controller's one transmit buffer.

use heapless::Deque;
use protocol_core::CanFrame;

/// Frames that may wait.
const ROOM: usize = 8;

/// The waiting frames, the oldest first.
#[derive(Clone)]
pub(crate) struct Outbox(Deque<CanFrame, ROOM>);

impl Outbox {
    pub(crate) const fn new() -> Self {
        Self(Deque::new())
    }

    /// Adds a frame. A full box means that the bus takes nothing: the oldest frame is worth least and goes.
    pub(crate) fn push(&mut self, frame: CanFrame) {
        if self.0.is_full() {
            self.0.pop_front();
        }
        // There is room: either there was, or it has just been made.
        let _ = self.0.push_back(frame);
    }

    /// Lets all frames go.
    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }

    /// Offers the oldest frame; it goes if `take` takes it. Returns whether one has gone.
    pub(crate) fn offer(&mut self, take: impl FnOnce(&CanFrame) -> bool) -> bool {
        let is_taken = self.0.front().is_some_and(take);
        if is_taken {
            self.0.pop_front();
        }
        is_taken
    }
}
