//! What the cluster sends and when: one engine for the vehicle's table of sent messages.
//!
//! Owns due times, life counters and check bytes. A message keeps its phase for ever; after a stall it is sent once, never in a
//! burst. Refuses to know what is in a message and whether the bus takes it.
//! Source: bus document, Meter1 and Meter2 (1000 ms); BUS-R127 (heartbeat).

use protocol_core::model::Readings;
use protocol_core::vehicle::Vehicle;
use protocol_core::{CanFrame, Millis};

/// Most messages that a vehicle's send table may have.
pub const MAX_SENT: usize = 8;

/// Time between the first frames of two messages, in milliseconds: they never ask for the bus together.
const PHASE_MS: u64 = 20;

/// Due time and life counter of every sent message.
#[derive(Clone)]
pub(crate) struct Transmit {
    /// `None` until [`Self::start`].
    due: [Option<Millis>; MAX_SENT],
    life: [u8; MAX_SENT],
}

impl Transmit {
    pub(crate) const fn new() -> Self {
        Self { due: [None; MAX_SENT], life: [0; MAX_SENT] }
    }

    /// Makes the first message due at once, the others one phase apart; later calls change nothing.
    pub(crate) fn start(&mut self, now: Millis) {
        for (index, due) in (0u64..).zip(&mut self.due) {
            *due = due.or(Some(now.after(index * PHASE_MS)));
        }
    }

    /// Returns the next frame that is due.
    pub(crate) fn next(&mut self, vehicle: &Vehicle, values: &Readings, now: Millis) -> Option<CanFrame> {
        let rows = vehicle.tx.iter().zip(&mut self.due).zip(&mut self.life);
        for (index, ((message, due), life)) in (0u8..).zip(rows) {
            let Some(at) = due.filter(|&at| now >= at) else { continue };
            let cycle_ms = u64::from(message.cycle_ms.max(1));
            *due = Some(at.after((now.since(at) / cycle_ms + 1) * cycle_ms));

            let mut data = (vehicle.encode)(index, values);
            if let Some(place) = message.life {
                if let Some(byte) = data.get_mut(usize::from(place.byte)) {
                    let shift = place.mask.trailing_zeros().min(7);
                    *byte = *byte & !place.mask | *life << shift & place.mask;
                }
                *life = life.wrapping_add(1);
            }
            if let Some(checksum) = message.checksum {
                checksum.seal(&mut data);
            }
            return Some(CanFrame::full(message.id, data));
        }
        None
    }
}
