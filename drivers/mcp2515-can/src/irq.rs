//! What to do about flags: pure functions from what was read to what is to be done.
//!
//! [`reads`] orders the receive buffers by arrival; [`plan`] turns CANINTF and EFLG into counts and clears. Nothing
//! here touches the chip. Source: DS20001801 sections 4.2 (rollover), 6.7 and 7.

use crate::regs::{ERRIF, EWARN, RX_STATUS_RX0, RX_STATUS_RX1, RX0OVR, RX1OVR, RXEP, TXBO, TXEP};

/// One of the two receive buffers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RxBuffer {
    /// RXB0: filled first when both are empty.
    Rx0,
    /// RXB1: filled by rollover while RXB0 is full.
    Rx1,
}

/// Returns which buffers to read, oldest frame first, from an RX STATUS answer and the buffer released before it.
///
/// With both full, RXB0 is the older one: RXB1 fills only while RXB0 is full. The exception is a frame that rolled
/// over into RXB1 *while RXB0 was being read*: after RXB0's release a still newer frame may lie in RXB0, so right
/// after a read of RXB0 a full RXB1 goes first.
#[inline(always)]
pub const fn reads(rx_status: u8, released: Option<RxBuffer>) -> [Option<RxBuffer>; 2] {
    use RxBuffer::{Rx0, Rx1};
    match (rx_status & RX_STATUS_RX0 != 0, rx_status & RX_STATUS_RX1 != 0, released) {
        (false, false, _) => [None, None],
        (true, false, _) => [Some(Rx0), None],
        (false, true, _) => [Some(Rx1), None],
        (true, true, Some(Rx0)) => [Some(Rx1), Some(Rx0)],
        (true, true, Some(Rx1) | None) => [Some(Rx0), Some(Rx1)],
    }
}

/// Fault confinement state of the node.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum BusState {
    /// Takes part without restriction.
    #[default]
    Active,
    /// An error counter has reached 96.
    Warning,
    /// An error counter has reached 128: errors are no longer signalled to others.
    Passive,
    /// The transmit error counter has passed 255: off the bus until 128 * 11 recessive bits.
    BusOff,
}

impl BusState {
    /// Returns the state that EFLG describes.
    pub const fn from_eflg(eflg: u8) -> Self {
        match () {
            () if eflg & TXBO != 0 => Self::BusOff,
            () if eflg & (TXEP | RXEP) != 0 => Self::Passive,
            () if eflg & EWARN != 0 => Self::Warning,
            () => Self::Active,
        }
    }
}

/// What CANINTF and EFLG ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// EFLG bits to clear, before CANINTF: a flag stays set while its condition lasts (section 7.7).
    pub clear_eflg: u8,
    /// CANINTF bits to clear. Never a receive flag: READ RX BUFFER clears those, a second clear loses a frame.
    pub clear_canintf: u8,
    /// Frames lost for want of a free buffer: at least one per overrun bit.
    pub overruns: u8,
    /// State of the node.
    pub state: BusState,
}

/// Returns what to do about CANINTF and EFLG.
pub const fn plan(canintf: u8, eflg: u8) -> Plan {
    let overrun = eflg & (RX0OVR | RX1OVR);
    Plan {
        clear_eflg: overrun,
        clear_canintf: canintf & ERRIF,
        overruns: overrun.count_ones() as u8,
        state: BusState::from_eflg(eflg),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use RxBuffer::{Rx0, Rx1};

    #[test]
    fn every_status_byte_reads_each_full_buffer_exactly_once() {
        for status in 0..=255u8 {
            for released in [None, Some(Rx0), Some(Rx1)] {
                let order = reads(status, released);
                let count = |buffer| order.iter().filter(|read| **read == Some(buffer)).count();
                assert_eq!(count(Rx0), usize::from(status & 0x40 != 0), "{status:#04x} {released:?}");
                assert_eq!(count(Rx1), usize::from(status & 0x80 != 0), "{status:#04x} {released:?}");
                assert!(order[0].is_some() || order[1].is_none());
            }
        }
    }

    #[test]
    fn a_frame_that_rolled_over_during_the_read_of_rxb0_goes_first() {
        assert_eq!(reads(0xC0, Some(Rx0)), [Some(Rx1), Some(Rx0)]);
        assert_eq!(reads(0xC0, None), [Some(Rx0), Some(Rx1)]);
        assert_eq!(reads(0xC0, Some(Rx1)), [Some(Rx0), Some(Rx1)]);
    }

    // All 65 536 combinations against the datasheet's sentences.
    #[test]
    fn every_flag_combination_is_cleared_and_counted_as_the_datasheet_says() {
        for canintf in 0..=255u8 {
            for eflg in 0..=255u8 {
                let plan = plan(canintf, eflg);
                assert_eq!(plan.clear_canintf & 0x03, 0, "a receive flag would be acknowledged twice");
                assert_eq!(plan.clear_canintf != 0, canintf & 0x20 != 0);
                assert_eq!(plan.clear_eflg & 0x3F, 0, "only the overrun bits can be cleared");
                assert_eq!(plan.overruns, (eflg >> 6 & 1) + (eflg >> 7));
                assert_eq!(plan.clear_eflg >> 6, eflg >> 6);
                let state = match eflg & 0x3F {
                    bits if bits >= 0x20 => BusState::BusOff,
                    bits if bits >= 0x08 => BusState::Passive,
                    bits if bits & 1 != 0 => BusState::Warning,
                    _ => BusState::Active,
                };
                assert_eq!(plan.state, state, "{eflg:#04x}");
            }
        }
    }
}
