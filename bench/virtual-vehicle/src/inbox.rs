//! What has reached a node over the bus: the last frame of each message that it listens to, and how old it is.
//!
//! A node knows of another what is in here and nothing else. A frame of another length is refused, and so is one whose
//! life counter stands still: that is silence (BUS-R021, R061, R121, JL-R009). Ages are counted in steps while the node
//! is awake. Refuses to decode: that is each vehicle's `hears`, with the generated codecs.

use crate::STEP_MS;
use protocol_core::CanFrame;
use protocol_core::codec::{MessageInfo, SignalInfo};
use protocol_core::frame::CanId;

/// The last frame of one message.
#[derive(Clone, Debug)]
struct Entry {
    info: &'static MessageInfo,
    life: Option<&'static SignalInfo>,
    data: Option<[u8; 8]>,
    /// Since the last frame; before the first one, since the node is awake.
    silence_ms: u64,
    /// It has come since the last step.
    is_new: bool,
    /// It came in the step before this one.
    is_fresh: bool,
}

impl PartialEq for Entry {
    fn eq(&self, other: &Self) -> bool {
        self.info.id == other.info.id
            && (self.data, self.silence_ms, self.is_new, self.is_fresh)
                == (other.data, other.silence_ms, other.is_new, other.is_fresh)
    }
}

/// The messages that one node listens to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inbox {
    entries: Vec<Entry>,
}

impl Inbox {
    /// An inbox for these messages, in which nothing has come yet.
    pub(crate) fn of(messages: impl Iterator<Item = &'static MessageInfo>) -> Self {
        let entry = |info: &'static MessageInfo| Entry {
            info,
            life: info.signals.iter().find(|signal| signal.life.is_some()),
            data: None,
            silence_ms: 0,
            is_new: false,
            is_fresh: false,
        };
        Self { entries: messages.map(entry).collect() }
    }

    /// Takes a frame in; returns whether the node listens to it and believes it.
    pub(crate) fn hear(&mut self, frame: &CanFrame) -> bool {
        let Some(entry) = self.entries.iter_mut().find(|entry| entry.info.id == frame.id) else {
            return false;
        };
        if frame.len() != entry.info.len.min(8) {
            return false;
        }
        let data = *frame.padded();
        let stands_still =
            |life: &SignalInfo| entry.data.is_some_and(|last| life.raw(&last) == life.raw(&data));
        if entry.life.is_some_and(stands_still) {
            return false;
        }
        (entry.data, entry.silence_ms, entry.is_new) = (Some(data), 0, true);
        true
    }

    /// Lets one step pass.
    pub(crate) fn pass(&mut self) {
        for entry in &mut self.entries {
            entry.is_fresh = std::mem::take(&mut entry.is_new);
            if !entry.is_fresh {
                entry.silence_ms = entry.silence_ms.saturating_add(STEP_MS);
            }
        }
    }

    /// Forgets everything: the node sleeps.
    pub(crate) fn rest(&mut self) {
        self.entries.iter_mut().for_each(Entry::forget);
    }

    /// Forgets one message: its sender has nothing to say.
    pub(crate) fn forget(&mut self, id: CanId) {
        self.entries.iter_mut().filter(|entry| entry.info.id == id).for_each(Entry::forget);
    }

    fn entry(&self, id: CanId) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.info.id == id)
    }

    /// Returns the last frame of a message, however old; `None` = none since the node is awake.
    pub fn last(&self, id: CanId) -> Option<[u8; 8]> {
        self.entry(id)?.data
    }

    /// Returns the last frame of a message if it is younger than this, in milliseconds.
    pub fn within(&self, id: CanId, ms: u64) -> Option<[u8; 8]> {
        let entry = self.entry(id)?;
        entry.data.filter(|_| entry.silence_ms < ms)
    }

    /// Returns the frame of a message if it came in the last step.
    pub fn fresh(&self, id: CanId) -> Option<[u8; 8]> {
        let entry = self.entry(id)?;
        entry.data.filter(|_| entry.is_fresh)
    }

    /// Returns for how long a message has not come, in milliseconds; before its first frame, since the node is awake.
    pub fn silence_ms(&self, id: CanId) -> u64 {
        self.entry(id).map_or(0, |entry| entry.silence_ms)
    }

    /// Returns the longest silence of some messages, in milliseconds.
    pub fn worst_silence_ms(&self, ids: &[CanId]) -> u64 {
        ids.iter().map(|id| self.silence_ms(*id)).max().unwrap_or(0)
    }
}

impl Entry {
    fn forget(&mut self) {
        (self.data, self.silence_ms, self.is_new, self.is_fresh) = (None, 0, false, false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use protocol_core::generated::citybus::{self, id};

    fn inbox() -> Inbox {
        Inbox::of(citybus::MESSAGES.iter().filter(|info| [id::BMS1, id::BMS5].contains(&info.id)))
    }

    fn bms5(life: u8, code: u8) -> CanFrame {
        CanFrame::full(id::BMS5, [code, 0, 0, 0, 170, 0, life, 0xFF])
    }

    #[test]
    fn silence_grows_by_one_step_and_ends_with_a_frame() {
        let mut inbox = inbox();
        inbox.pass();
        inbox.pass();
        assert_eq!((inbox.silence_ms(id::BMS5), inbox.last(id::BMS5)), (20, None));
        assert!(inbox.hear(&bms5(0, 7)));
        inbox.pass();
        assert_eq!(inbox.silence_ms(id::BMS5), 0);
        assert!(inbox.fresh(id::BMS5).is_some());
        inbox.pass();
        assert!(inbox.fresh(id::BMS5).is_none() && inbox.silence_ms(id::BMS5) == 10);
        assert!(inbox.within(id::BMS5, 11).is_some() && inbox.within(id::BMS5, 10).is_none());
        assert_eq!(inbox.worst_silence_ms(&[id::BMS1, id::BMS5]), 40);
    }

    #[test]
    fn bus_r021_a_life_counter_that_stands_still_is_silence() {
        let mut inbox = inbox();
        assert!(inbox.hear(&bms5(3, 0)));
        inbox.pass();
        for _ in 0..10 {
            assert!(!inbox.hear(&bms5(3, 24)));
            inbox.pass();
        }
        assert_eq!((inbox.silence_ms(id::BMS5), inbox.last(id::BMS5).map(|data| data[0])), (100, Some(0)));
        assert!(inbox.hear(&bms5(4, 24)));
        assert!(inbox.hear(&CanFrame::full(id::BMS1, [0; 8])));
        assert!(inbox.hear(&CanFrame::full(id::BMS1, [0; 8])), "it has no counter");
    }

    #[test]
    fn other_messages_and_other_lengths_are_not_heard() {
        let mut inbox = inbox();
        assert!(!inbox.hear(&CanFrame::full(id::VCU1, [0; 8])));
        let short = CanFrame::from_slice(id::BMS5, &[0; 7]).expect("seven bytes");
        assert!(!inbox.hear(&short) && inbox.last(id::BMS5).is_none());
        assert!(inbox.hear(&bms5(0, 0)));
        inbox.rest();
        assert_eq!((inbox.last(id::BMS5), inbox.silence_ms(id::BMS5)), (None, 0));
    }
}
