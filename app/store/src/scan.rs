//! Which records of a region count: one look at all of it.
//!
//! Of the records of a key the one with the highest generation counts, within a sector the last. What cannot be read as
//! a record is passed over.

use crate::format::{self, FORMAT, Head, PAGE_BYTES, PAGES, SECTOR_BYTES, SLOT_BYTES, SLOTS};
use embedded_storage::nor_flash::ReadNorFlash;

/// Keys that a store can hold.
pub const MAX_KEYS: usize = 48;

/// What was found at start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Nothing was ever programmed.
    New,
    /// There are records.
    Kept,
    /// Something is there and none of it is a record.
    Damaged,
    /// A later firmware has written this version: nothing is read, nothing is changed.
    Newer(u16),
}

/// A record that counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub(crate) key: u8,
    pub(crate) sector: u8,
    /// Page and slot within the sector, counted in slots.
    pub(crate) slot: u8,
    /// Slots that the record takes.
    pub(crate) slots: u8,
    pub(crate) generation: u32,
}

impl Place {
    pub(crate) fn offset(&self) -> usize {
        usize::from(self.sector) * SECTOR_BYTES + usize::from(self.slot) * SLOT_BYTES
    }
}

/// The newest record of each key.
pub(crate) struct Index {
    places: [Option<Place>; MAX_KEYS],
}

impl Index {
    pub(crate) const fn new() -> Self {
        Self { places: [None; MAX_KEYS] }
    }

    pub(crate) fn get(&self, key: u8) -> Option<Place> {
        self.iter().find(|place| place.key == key)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = Place> {
        self.places.iter().flatten().copied()
    }

    /// Notes where the newest record of a key lies; `false` = there are too many keys.
    pub(crate) fn set(&mut self, place: Place) -> bool {
        let old = self.places.iter().position(|old| old.is_some_and(|old| old.key == place.key));
        let free = || self.places.iter().position(Option::is_none);
        let Some(entry) = old.or_else(free).and_then(|at| self.places.get_mut(at)) else { return false };
        *entry = Some(place);
        true
    }
}

/// What a look at a region has found.
pub(crate) struct Found {
    pub(crate) condition: Condition,
    pub(crate) index: Index,
    /// The sector with the newest generation, `None` = there is no record.
    pub(crate) active: Option<(usize, u32)>,
    /// First page of that sector behind everything that was ever programmed; [`PAGES`] = none.
    pub(crate) page: usize,
    /// The last record of that sector: nothing proves that it was programmed to the end.
    pub(crate) last: Option<Place>,
}

/// Looks at a region of `sectors` sectors.
pub(crate) fn scan<F: ReadNorFlash>(flash: &mut F, sectors: usize) -> Result<Found, F::Error> {
    let mut found =
        Found { condition: Condition::New, index: Index::new(), active: None, page: 1, last: None };
    let mut newer = None;
    for sector in 0..sectors {
        let (mut used, mut last) = (1, None);
        for page in 0..PAGES {
            let mut bytes = [0; PAGE_BYTES];
            flash.read((sector * SECTOR_BYTES + page * PAGE_BYTES) as u32, &mut bytes)?;
            if format::is_blank(&bytes) {
                continue;
            }
            used = page + 1;
            let head = bytes.first_chunk().filter(|_| page == 0).and_then(format::read_sector_head);
            newer = newer.max(head.map(|(version, _)| version).filter(|version| *version > FORMAT));
            // A head alone says nothing of what was there.
            if head.is_none() && found.condition == Condition::New {
                found.condition = Condition::Damaged;
            }
            last = found.take_page(sector, page, &bytes).or(last);
        }
        if found.active.is_some_and(|(active, _)| active == sector) {
            (found.page, found.last) = (used, last);
        }
    }
    if found.active.is_some() {
        found.condition = Condition::Kept;
    }
    if let Some(version) = newer {
        let condition = Condition::Newer(version);
        return Ok(Found { condition, index: Index::new(), active: None, page: 1, last: None });
    }
    Ok(found)
}

impl Found {
    /// Takes the records of a page and returns the last of them.
    fn take_page(&mut self, sector: usize, page: usize, bytes: &[u8; PAGE_BYTES]) -> Option<Place> {
        let (mut slot, mut last) = (0, None);
        while let Some(rest) = bytes.get(slot * SLOT_BYTES..).filter(|_| slot < SLOTS) {
            let head = rest.first_chunk().and_then(Head::read).filter(|head| head.is_whole(rest));
            let Some(head) = head else {
                slot += 1;
                continue;
            };
            let (sector_number, slot_number) = (sector as u8, (page * SLOTS + slot) as u8);
            let Head { key, generation, .. } = head;
            let slots = head.slots() as u8;
            let place = Place { key, sector: sector_number, slot: slot_number, slots, generation };
            if self.index.get(key).is_none_or(|old| old.generation <= generation) {
                self.index.set(place);
            }
            if self.active.is_none_or(|(_, newest)| newest < generation) {
                self.active = Some((sector, generation));
            }
            slot += head.slots();
            last = Some(place);
        }
        last
    }
}
