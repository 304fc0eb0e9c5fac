//! Where the next record goes, and which sector is erased next.
//!
//! Sectors are used in turn. The active one is filled page by page; before it is full the next one has been erased.
//! Whoever enters a sector, or starts after a cut, first copies the newest record of every key to a page that nothing
//! was programmed to before: from then on nothing that counts can have been hit by a cut, and everything else may go.
//!
//! What a cut leaves can read either way, or as if nothing had been programmed. Hence a page is claimed by zeros before
//! its first record: a claim that was cut off is programmed once more with the same zeros, and a page that carries a
//! claim is never used again after a start. What lies behind the last record of a page that was in use is overwritten
//! with zeros at the next start: it cannot become a record later.

use crate::format::{
    self, Head, MAX_GENERATION, MAX_PAYLOAD, PAGE_BYTES, PAGES, SECTOR_BYTES, SLOT_BYTES, SLOTS,
};
use crate::scan::{self, Condition, Index, Place};
use core::ops::Range;
use embedded_storage::nor_flash::NorFlash;

/// Sectors that a region must have: one in use, one erased, one that still holds what the one in use replaces.
const LEAST_SECTORS: usize = 3;
/// Pages in a row that do not hold what was programmed, after which the flash counts as worn out.
const MOST_BAD: u8 = 20;
/// Looks at a region of which the last record reads either way, before it counts as worn out.
const MOST_LOOKS: usize = 100;
/// Slots of all records that count, together: two thirds of a sector, so a sector has room for more than the copies.
const MOST_SLOTS: usize = 150;
/// The page behind that of the sector's head.
const FIRST_PAGE: usize = 1;

/// What the caller does next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// Nothing: it is done.
    Done,
    /// Call again when there is time: one program has been done towards it.
    Again,
    /// Erase the sector at this offset, call [`Store::erased`], then call again.
    Erase(u32),
}

/// Why nothing can be kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error<E> {
    /// The flash refuses.
    Flash(E),
    /// The flash does not hold what is programmed.
    WornOut,
    /// A later firmware has written the region.
    Newer,
    /// The payload, the keys or all records together are too long.
    TooLong,
}

impl<E> From<E> for Error<E> {
    fn from(error: E) -> Self {
        Self::Flash(error)
    }
}

/// A record in RAM.
#[derive(Clone, Copy)]
struct Last {
    key: u8,
    payload: [u8; MAX_PAYLOAD],
    len: usize,
}

/// Records in a region of flash; `F` is that region alone, from offset 0 on.
pub struct Store<F> {
    flash: F,
    sectors: usize,
    condition: Condition,
    index: Index,
    active: usize,
    generation: u32,
    /// Where the next record goes, in slots of the active sector; a multiple of [`SLOTS`] = a page not claimed yet.
    next: usize,
    /// Slots of the active sector in which the trace of a cut may lie; they are overwritten first.
    trace: Range<usize>,
    /// The last record as it was read at start: it is copied first, and never read again.
    last: Option<Last>,
    /// Place in the index of the next key to copy; `None` = all are copied.
    copying: Option<usize>,
    /// A record has found room behind the copies of the active sector.
    has_room: bool,
    /// Which sector is known to be erased to the end.
    ready: Option<usize>,
    /// Sectors behind the active one that do not stay erased.
    skipped: usize,
    bad: u8,
}

impl<F: NorFlash> Store<F> {
    /// Looks at a region; writes nothing.
    ///
    /// # Errors
    /// [`Error::TooLong`] if the region is no whole number of sectors or has fewer than three; [`Error::Flash`].
    pub fn mount(flash: F) -> Result<Self, Error<F::Error>> {
        let sectors = flash.capacity() / SECTOR_BYTES;
        if !(LEAST_SECTORS..=256).contains(&sectors)
            || F::ERASE_SIZE != SECTOR_BYTES
            || !SLOT_BYTES.is_multiple_of(F::WRITE_SIZE)
        {
            return Err(Error::TooLong);
        }
        let mut store = Self {
            flash,
            sectors,
            condition: Condition::New,
            index: Index::new(),
            active: 0,
            generation: 0,
            next: 0,
            trace: 0..0,
            last: None,
            copying: None,
            has_room: true,
            ready: None,
            skipped: 0,
            bad: 0,
        };
        store.look()?;
        Ok(store)
    }

    /// Looks at the region until two looks in a row agree on the last record: if a cut has hit it, it reads as a record
    /// only now and then.
    fn look(&mut self) -> Result<(), Error<F::Error>> {
        for _ in 0..MOST_LOOKS {
            if self.look_once()? {
                return Ok(());
            }
        }
        Err(Error::WornOut)
    }

    fn look_once(&mut self) -> Result<bool, Error<F::Error>> {
        let found = scan::scan(&mut self.flash, self.sectors)?;
        // Without a record, the first sector to be entered is number 0.
        (self.active, self.generation) = found.active.unwrap_or((self.sectors - 1, 0));
        let page = if found.active.is_some() { found.page } else { PAGES };
        self.next = page * SLOTS;
        let end = |last: Place| usize::from(last.slot) + usize::from(last.slots);
        self.trace = found.last.map_or(self.next, end)..self.next;
        (self.condition, self.index) = (found.condition, found.index);
        (self.copying, self.has_room, self.ready) = (Some(0), true, None);
        self.last = None;
        let Some(last) = found.last else { return Ok(true) };
        let mut page = [0; PAGE_BYTES];
        let Some(len) = self.read_record(last, &mut page)? else { return Ok(false) };
        if self.index.get(last.key) == Some(last) {
            let mut payload = [0; MAX_PAYLOAD];
            if let Some(kept) = page.get(format::HEADER..format::HEADER + MAX_PAYLOAD) {
                payload.copy_from_slice(kept);
            }
            self.last = Some(Last { key: last.key, payload, len });
        }
        Ok(true)
    }

    /// Returns what was found at start.
    pub const fn condition(&self) -> Condition {
        self.condition
    }

    /// Gives the flash back.
    pub fn free(self) -> F {
        self.flash
    }

    /// The flash, for whoever erases.
    pub const fn flash_mut(&mut self) -> &mut F {
        &mut self.flash
    }

    /// Returns the keys that have a record.
    pub fn keys(&self) -> impl Iterator<Item = u8> {
        self.index.iter().map(|place| place.key)
    }

    /// Returns how often a sector was erased; `None` = its head is gone.
    ///
    /// # Errors
    /// [`Error::Flash`].
    pub fn erases(&mut self, sector: usize) -> Result<Option<u32>, Error<F::Error>> {
        let head = self.sector_head(sector)?;
        Ok(format::read_sector_head(&head).map(|(_, erases)| erases))
    }

    /// Reads the newest record of a key into `payload` as far as it has room; returns the length of the record,
    /// `None` = there is none.
    ///
    /// # Errors
    /// [`Error::Flash`].
    pub fn get(&mut self, key: u8, payload: &mut [u8]) -> Result<Option<usize>, Error<F::Error>> {
        let Some(place) = self.index.get(key) else { return Ok(None) };
        let mut page = [0; PAGE_BYTES];
        let Some(len) = self.read_record(place, &mut page)? else { return Ok(None) };
        let room = payload.len().min(len);
        if let (Some(to), Some(from)) =
            (payload.get_mut(..room), page.get(format::HEADER..format::HEADER + room))
        {
            to.copy_from_slice(from);
        }
        Ok(Some(len))
    }

    /// Reads the slots of a record to the start of `page`; returns the length of its payload, `None` = it reads otherwise
    /// than when the region was looked at: a cut has left cells in it that read either way.
    fn read_record(
        &mut self,
        place: Place,
        page: &mut [u8; PAGE_BYTES],
    ) -> Result<Option<usize>, Error<F::Error>> {
        let room = PAGE_BYTES - usize::from(place.slot) % SLOTS * SLOT_BYTES;
        if let Some(page) = page.get_mut(..room) {
            self.flash.read(place.offset() as u32, page)?;
        }
        let head = page.first_chunk().and_then(Head::read);
        Ok(head.filter(|head| head.key == place.key && head.is_whole(page)).map(|head| head.len))
    }

    /// Brings the store to where nothing that counts can be hit by what a cut has left; to be called until
    /// [`Next::Done`] before anything that was read is relied on. One program per call.
    ///
    /// # Errors
    /// As [`Self::put`].
    pub fn settle(&mut self) -> Result<Next, Error<F::Error>> {
        if let Condition::Newer(_) = self.condition {
            return Err(Error::Newer);
        }
        if !self.trace.is_empty() {
            // What did not read as a record now could read as one at the next start.
            let slot = self.trace.start;
            let end = (slot / SLOTS + 1) * SLOTS;
            let zeros = [0; PAGE_BYTES];
            let offset = (self.active * SECTOR_BYTES + slot * SLOT_BYTES) as u32;
            self.flash.write(offset, zeros.get(..(end - slot) * SLOT_BYTES).unwrap_or(&zeros))?;
            self.trace.start = end;
            return Ok(Next::Again);
        }
        if let Some(Last { key, payload, len }) = self.last {
            let next = self.append(key, payload.get(..len).unwrap_or_default())?;
            if next == Next::Done {
                self.last = None;
                return Ok(Next::Again);
            }
            return Ok(next);
        }
        let Some(at) = self.copying else { return Ok(Next::Done) };
        let Some(place) = self.index.iter().nth(at) else {
            self.copying = None;
            return Ok(Next::Done);
        };
        let mut page = [0; PAGE_BYTES];
        let Some(len) = self.read_record(place, &mut page)? else {
            // It has become unreadable since the start.
            self.copying = Some(at + 1);
            return Ok(Next::Again);
        };
        let mut payload = [0; MAX_PAYLOAD];
        if let Some(kept) = page.get(format::HEADER..format::HEADER + MAX_PAYLOAD) {
            payload.copy_from_slice(kept);
        }
        let next = self.append(place.key, payload.get(..len).unwrap_or_default())?;
        if next == Next::Done {
            // Entering another sector meanwhile has started the copying anew.
            self.copying = self.copying.map(|at| at + 1);
            return Ok(Next::Again);
        }
        Ok(next)
    }

    /// Keeps `payload` under `key` once it returns [`Next::Done`]; until then to be called again, with the same or a
    /// newer payload. One program per call.
    ///
    /// # Errors
    /// As [`Error`] says; what was kept before stays kept.
    pub fn put(&mut self, key: u8, payload: &[u8]) -> Result<Next, Error<F::Error>> {
        let others = self.index.iter().filter(|place| place.key != key);
        let slots =
            others.map(|place| usize::from(place.slots)).sum::<usize>() + format::slots_of(payload.len());
        if slots > MOST_SLOTS {
            return Err(Error::TooLong);
        }
        match self.settle()? {
            Next::Done => self.append(key, payload),
            next => Ok(next),
        }
    }

    /// Prepares the sector that comes next; to be called until [`Next::Done`] whenever there is time.
    ///
    /// # Errors
    /// As [`Self::put`].
    pub fn prepare(&mut self) -> Result<Next, Error<F::Error>> {
        match self.settle()? {
            Next::Done => self.ready_next(),
            next => Ok(next),
        }
    }

    /// Takes note that the sector at `offset` has been erased to the end.
    ///
    /// # Errors
    /// [`Error::Flash`].
    pub fn erased(&mut self, offset: u32) -> Result<(), Error<F::Error>> {
        let sector = offset as usize / SECTOR_BYTES;
        let head = format::sector_head(self.count_of(sector)?);
        self.flash.write(offset, &head)?;
        self.ready = None;
        if !self.is_ready(sector)? {
            self.skipped += 1;
        }
        Ok(())
    }

    /// Erases, waiting for its end: for whoever has the time.
    ///
    /// # Errors
    /// [`Error::Flash`].
    pub fn erase(&mut self, offset: u32) -> Result<(), Error<F::Error>> {
        self.flash.erase(offset, offset + SECTOR_BYTES as u32)?;
        self.erased(offset)
    }

    /// Returns the erases of a sector that has just been erased once more: all sectors take turns.
    fn count_of(&mut self, sector: usize) -> Result<u32, Error<F::Error>> {
        let mut most = 0;
        for other in (0..self.sectors).filter(|other| *other != sector) {
            let erases = self.erases(other)?.unwrap_or(0);
            // Those behind this one in the circle have had this turn already.
            most = most.max(if other < sector { erases } else { erases + 1 });
        }
        Ok(most.max(1))
    }

    fn sector_head(&mut self, sector: usize) -> Result<[u8; SLOT_BYTES], Error<F::Error>> {
        let mut head = [0; SLOT_BYTES];
        self.flash.read((sector * SECTOR_BYTES) as u32, &mut head)?;
        Ok(head)
    }

    const fn next_sector(&self) -> usize {
        (self.active + 1 + self.skipped) % self.sectors
    }

    /// Returns whether a sector was erased to the end and nothing was programmed to it since.
    fn is_ready(&mut self, sector: usize) -> Result<bool, Error<F::Error>> {
        if self.ready == Some(sector) {
            return Ok(true);
        }
        let mut page = [0; PAGE_BYTES];
        for number in 0..PAGES {
            self.flash.read((sector * SECTOR_BYTES + number * PAGE_BYTES) as u32, &mut page)?;
            let (head, rest) = page.split_at(if number == 0 { SLOT_BYTES } else { 0 });
            let head = head.first_chunk().map(format::read_sector_head);
            if !format::is_blank(rest) || head == Some(None) {
                return Ok(false);
            }
        }
        self.ready = Some(sector);
        Ok(true)
    }

    fn ready_next(&mut self) -> Result<Next, Error<F::Error>> {
        let sector = self.next_sector();
        if self.is_ready(sector)? {
            return Ok(Next::Done);
        }
        if self.index.iter().any(|place| usize::from(place.sector) == sector)
            || self.skipped + 1 >= self.sectors
        {
            // Only if no sector stays erased, or every sector was filled by starts that were cut off before all was copied.
            return Err(Error::WornOut);
        }
        let offset = (sector * SECTOR_BYTES) as u32;
        if self.sector_head(sector)? != format::ZEROS {
            self.flash.write(offset, &format::ZEROS)?;
            return Ok(Next::Again);
        }
        Ok(Next::Erase(offset))
    }

    /// Does one program towards a record of `key`: the record itself, or what must come before it.
    fn append(&mut self, key: u8, payload: &[u8]) -> Result<Next, Error<F::Error>> {
        let mut page = [0; PAGE_BYTES];
        let len = format::write_record(&mut page, key, self.generation, payload).ok_or(Error::TooLong)?;
        let slot = self.next % SLOTS;
        if slot != 0 && slot + len / SLOT_BYTES > SLOTS {
            self.next += SLOTS - slot;
        }
        if self.next >= PAGES * SLOTS {
            return self.enter();
        }
        let base = self.active * SECTOR_BYTES;
        if self.next.is_multiple_of(SLOTS) {
            let page = (base + self.next * SLOT_BYTES) as u32;
            self.flash.write(page, &format::ZEROS)?;
            self.next += 1;
            return Ok(Next::Again);
        }
        let record = page.get(..len).unwrap_or_default();
        let offset = (base + self.next * SLOT_BYTES) as u32;
        self.flash.write(offset, record)?;
        if !self.holds(offset, record)? {
            return self.skip_page();
        }
        let slots = len / SLOT_BYTES;
        let place = Place {
            key,
            sector: self.active as u8,
            slot: self.next as u8,
            slots: slots as u8,
            generation: self.generation,
        };
        if !self.index.set(place) {
            return Err(Error::TooLong);
        }
        self.next += slots;
        self.has_room |= self.copying.is_none();
        self.bad = 0;
        Ok(Next::Done)
    }

    fn holds(&mut self, offset: u32, record: &[u8]) -> Result<bool, Error<F::Error>> {
        let mut read = [0; PAGE_BYTES];
        let Some(read) = read.get_mut(..record.len()) else { return Ok(false) };
        self.flash.read(offset, read)?;
        Ok(read == record)
    }

    /// Leaves a page that does not hold what is programmed to it.
    fn skip_page(&mut self) -> Result<Next, Error<F::Error>> {
        self.bad += 1;
        if self.bad >= MOST_BAD {
            return Err(Error::WornOut);
        }
        self.next = (self.next / SLOTS + 1) * SLOTS;
        Ok(Next::Again)
    }

    /// Goes on in the next sector, which gets a copy of everything first.
    fn enter(&mut self) -> Result<Next, Error<F::Error>> {
        if self.generation == MAX_GENERATION {
            return Err(Error::WornOut);
        }
        if !self.has_room {
            // The copies fill a whole sector.
            return Err(Error::TooLong);
        }
        match self.ready_next()? {
            Next::Done => {}
            next => return Ok(next),
        }
        self.active = self.next_sector();
        self.generation += 1;
        self.next = FIRST_PAGE * SLOTS;
        (self.copying, self.has_room) = (Some(0), false);
        (self.ready, self.skipped) = (None, 0);
        Ok(Next::Again)
    }
}

impl<F: NorFlash> Store<F> {
    /// Keeps `payload` under `key`, erasing where that is due: for whoever has the time.
    ///
    /// # Errors
    /// As [`Self::put`].
    pub fn save(&mut self, key: u8, payload: &[u8]) -> Result<(), Error<F::Error>> {
        loop {
            match self.put(key, payload)? {
                Next::Done => return Ok(()),
                Next::Again => {}
                Next::Erase(offset) => self.erase(offset)?,
            }
        }
    }
}
