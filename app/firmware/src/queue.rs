//! The queue of received frames, from the CAN interrupt to the tick.

use heapless::spsc::{Consumer, Producer, Queue};
use protocol_core::CanFrame;

/// Room of the queue, a power of two (the chip divides slowly): 24 ms of the shortest frames at 250 kbit/s (5 319 a second), 67 ms of full ones.
const ROOM: usize = 128;

/// A frame and when it was taken from the controller.
#[derive(Clone, Copy, Debug)]
pub struct Stamped {
    /// What the controller received.
    pub frame: CanFrame,
    /// Lower 32 bits of the microseconds since start.
    pub at_us: u32,
}

/// The queue; one of its places is always free.
pub type FrameQueue = Queue<Stamped, ROOM>;
/// The interrupt's end.
pub type FrameWriter = Producer<'static, Stamped>;
/// The tick's end.
pub type FrameReader = Consumer<'static, Stamped>;
