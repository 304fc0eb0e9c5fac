//! What outlives power-off: from the parts that are due to the store in flash, one program or one slice of an erase a
//! tick.
//!
//! At start the store is settled first, then every part is restored, then parts are due. A store that refuses is let go:
//! the instrument says so and drives on.

use cluster::kept::Bytes;
use cluster::{Instrument, Memory, Part};
use pico::FlashPort;
use protocol_core::Millis;
use rtic::Mutex;
use store::{Condition, Error, MAX_PAYLOAD, Next, Store};

use embedded_storage::nor_flash::NorFlashErrorKind;

/// When the region is looked at, in milliseconds since start: the panel has been woken by then.
const LOOK_MS: u64 = 20;
/// Time between two looks at what is due, in milliseconds: 3 m at 100 km/h.
const EVERY_MS: u64 = 100;
/// Programs in one tick until everything is restored: the picture waits for it.
const AT_START: u32 = 3;

/// The store, and what is under way in it.
pub struct Keeping {
    /// Where the region is; `None` = it has been looked at.
    flash: Option<FlashPort>,
    store: Option<Store<FlashPort>>,
    /// Everything that was kept has been restored; before that, what counts is copied to where no cut can have hit it.
    is_settled: bool,
    /// When it was last looked at what is due.
    looked: Millis,
    /// The part that is being kept.
    pending: Option<(Part, Bytes)>,
    /// The sector that is being erased, and whether that has begun.
    erasing: Option<(u32, bool)>,
}

impl Keeping {
    /// Takes the region; nothing is read yet.
    pub const fn new(flash: FlashPort) -> Self {
        Self {
            flash: Some(flash),
            store: None,
            is_settled: false,
            looked: Millis(0),
            pending: None,
            erasing: None,
        }
    }

    /// Does what takes one program or one slice of an erase; for every tick.
    pub fn tick(&mut self, instrument: &mut impl Mutex<T = Instrument>, now: Millis) {
        if now.0 < LOOK_MS {
            return;
        }
        if let Some(flash) = self.flash.take() {
            self.store = Store::mount(flash).ok();
        }
        let steps = if self.is_settled { 1 } else { AT_START };
        for _ in 0..steps {
            if self.erase() {
                return;
            }
            let next = if self.is_settled { self.keep(instrument, now) } else { self.settle(instrument) };
            match next {
                Ok(Next::Erase(offset)) => self.erasing = Some((offset, false)),
                Ok(Next::Again) => {}
                Ok(Next::Done) => return,
                Err(_) => self.give_up(instrument),
            }
        }
    }

    /// Goes on with an erase; returns whether one is under way.
    fn erase(&mut self) -> bool {
        let (Some(store), Some((offset, has_begun))) = (&mut self.store, self.erasing) else { return false };
        if store.flash_mut().erase_slice(offset, !has_begun) {
            self.erasing = None;
            // One that fails is found unready and erased again.
            let _ = store.erased(offset);
        } else {
            self.erasing = Some((offset, true));
        }
        true
    }

    fn settle(
        &mut self,
        instrument: &mut impl Mutex<T = Instrument>,
    ) -> Result<Next, Error<NorFlashErrorKind>> {
        let Some(store) = &mut self.store else {
            self.is_settled = true;
            instrument.lock(|instrument| instrument.resume(Memory::Damaged));
            return Ok(Next::Done);
        };
        let settled = store.settle();
        let memory = match (settled, store.condition()) {
            (Ok(Next::Again | Next::Erase(_)), _) => return settled,
            (Ok(Next::Done), Condition::New) => Memory::New,
            (Ok(Next::Done), Condition::Kept) => Memory::Kept,
            // What can be read is restored all the same.
            (Ok(Next::Done), Condition::Damaged | Condition::Newer(_)) | (Err(_), _) => Memory::Damaged,
        };
        for number in 1..=u8::MAX {
            let Some(part) = Part::from_number(number) else { continue };
            let mut bytes = [0; MAX_PAYLOAD];
            if let Ok(Some(len)) = store.get(number, &mut bytes)
                && let Some(bytes) = bytes.get(..len)
            {
                instrument.lock(|instrument| instrument.restore(part, bytes));
            }
        }
        self.is_settled = true;
        instrument.lock(|instrument| instrument.resume(memory));
        settled
    }

    fn keep(
        &mut self,
        instrument: &mut impl Mutex<T = Instrument>,
        now: Millis,
    ) -> Result<Next, Error<NorFlashErrorKind>> {
        let Some(store) = &mut self.store else { return Ok(Next::Done) };
        // To look at every part takes longer than a tick has to give each time.
        if self.pending.is_none() {
            if now.since(self.looked) < EVERY_MS {
                return Ok(Next::Done);
            }
            self.looked = now;
            self.pending = instrument.lock(|instrument| instrument.due(now));
        }
        let Some((part, bytes)) = &self.pending else { return store.prepare() };
        let next = store.put(part.number(), bytes)?;
        if next == Next::Done {
            instrument.lock(|instrument| instrument.saved(*part, bytes, now));
            self.pending = None;
        }
        Ok(next)
    }

    /// Nothing is kept from now on.
    fn give_up(&mut self, instrument: &mut impl Mutex<T = Instrument>) {
        self.store = None;
        self.pending = None;
        if self.is_settled {
            instrument.lock(Instrument::memory_failed);
        }
    }
}
