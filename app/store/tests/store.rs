//! The store over cells that can be cut off at any byte.

use bench::flash::{Cells, Region, SECTOR_BYTES};
use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashErrorKind, ReadNorFlash};
use store::{Condition, Error, MAX_PAYLOAD, Next, Store};

const SECTORS: usize = 4;

fn blank() -> Region {
    Region::new(Cells::new(vec![0xff; SECTORS * SECTOR_BYTES]), 0, SECTORS * SECTOR_BYTES)
}

fn mounted(region: Region) -> Store<Region> {
    Store::mount(region).expect("it mounts")
}

fn settled(region: Region) -> Store<Region> {
    let mut store = mounted(region);
    loop {
        match store.settle().expect("it settles") {
            Next::Done => return store,
            Next::Again => {}
            Next::Erase(offset) => store.erase(offset).expect("it erases"),
        }
    }
}

fn read(store: &mut Store<Region>, key: u8) -> Option<Vec<u8>> {
    let mut payload = [0; MAX_PAYLOAD];
    let len = store.get(key, &mut payload).expect("it reads")?;
    Some(payload[..len].to_vec())
}

/// Brings the region to where the next sector is erased.
fn prepared(store: &mut Store<Region>) {
    loop {
        match store.prepare().expect("it prepares") {
            Next::Done => return,
            Next::Again => {}
            Next::Erase(offset) => store.erase(offset).expect("it erases"),
        }
    }
}

#[test]
fn a_blank_region_is_new_and_keeps_the_newest_of_each_key_from_then_on() {
    let mut store = settled(blank());
    assert_eq!((store.condition(), read(&mut store, 1)), (Condition::New, None));
    for round in 0..2_000_u32 {
        store.save(1, &round.to_le_bytes()).unwrap();
        if round % 10 == 0 {
            store.save(2, &[round as u8; 100]).unwrap();
        }
    }
    let mut store = settled(store.free());
    assert_eq!(store.condition(), Condition::Kept);
    assert_eq!(read(&mut store, 1), Some(1_999_u32.to_le_bytes().to_vec()));
    assert_eq!(read(&mut store, 2), Some(vec![1_990_u32 as u8; 100]));
    assert_eq!(read(&mut store, 3), None);
}

#[test]
fn a_store_that_is_only_looked_at_changes_nothing() {
    let mut store = settled(blank());
    store.save(1, b"one").unwrap();
    let before = store.free();
    let mut store = mounted(before.clone());
    assert_eq!(read(&mut store, 1), Some(b"one".to_vec()));
    assert_eq!(store.free().cells, before.cells);
}

#[test]
fn one_call_is_one_program_and_an_erase_is_the_callers() {
    let mut store = settled(blank());
    let journal = |store: &mut Store<Region>| store.flash_mut().journal.as_ref().map_or(0, Vec::len);
    store.flash_mut().journal = Some(Vec::new());
    for value in 0..1_000_u32 {
        loop {
            let before = journal(&mut store);
            let next = store.put(7, &value.to_le_bytes()).unwrap();
            assert!(journal(&mut store) <= before + 1, "{next:?}");
            match next {
                Next::Done => break,
                Next::Again => {}
                Next::Erase(offset) => store.erase(offset).unwrap(),
            }
        }
    }
}

#[test]
fn with_the_next_sector_prepared_nothing_is_erased_while_records_are_kept() {
    let mut store = settled(blank());
    store.save(1, &[0; 4]).unwrap();
    for value in 0..1_000_u32 {
        prepared(&mut store);
        loop {
            match store.put(1, &value.to_le_bytes()).unwrap() {
                Next::Done => break,
                Next::Again => {}
                Next::Erase(_) => panic!("at {value}"),
            }
        }
    }
}

#[test]
fn sectors_wear_alike_and_their_heads_say_how_much() {
    let mut store = settled(blank());
    for value in 0..20_000_u32 {
        store.save(1, &value.to_le_bytes()).unwrap();
    }
    let worn = store.flash_mut().cells.erases().to_vec();
    assert!(worn.iter().max().unwrap() - worn.iter().min().unwrap() <= 1, "{worn:?}");
    let told: Vec<_> = (0..SECTORS).map(|sector| store.erases(sector).unwrap()).collect();
    assert_eq!(told, worn.iter().map(|erases| Some(*erases)).collect::<Vec<_>>());
}

#[test]
fn foreign_bytes_are_damage_and_are_replaced() {
    let cells = Cells::new((0..SECTORS * SECTOR_BYTES).map(|at| (at * 31 + 7) as u8).collect());
    let mut store = settled(Region::new(cells, 0, SECTORS * SECTOR_BYTES));
    assert_eq!((store.condition(), read(&mut store, 1)), (Condition::Damaged, None));
    store.save(1, b"again").unwrap();
    assert_eq!(read(&mut settled(store.free()), 1), Some(b"again".to_vec()));
}

#[test]
fn the_format_of_a_later_firmware_is_left_as_it_is_and_said() {
    let mut store = settled(blank());
    store.save(1, b"mine").unwrap();
    let mut bytes = store.free().cells.read_out();
    // The head of sector 0, one version on.
    let mut head = bytes[..12].to_vec();
    head[4] += 1;
    let crc = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC).checksum(&head);
    bytes[4] += 1;
    bytes[12..16].copy_from_slice(&crc.to_le_bytes());
    let region = Region::new(Cells::new(bytes), 0, SECTORS * SECTOR_BYTES);
    let mut store = mounted(region.clone());
    assert_eq!(store.condition(), Condition::Newer(2));
    assert_eq!(read(&mut store, 1), None);
    assert_eq!(store.put(1, b"no"), Err(Error::Newer));
    assert_eq!(store.prepare(), Err(Error::Newer));
    assert_eq!(store.free().cells, region.cells, "nothing was changed");
}

#[test]
fn what_does_not_fit_is_refused_and_what_was_kept_stays() {
    let mut store = settled(blank());
    store.save(1, b"one").unwrap();
    assert_eq!(store.save(2, &[0; MAX_PAYLOAD + 1]), Err(Error::TooLong));
    assert_eq!(store.save(0, b"no key"), Err(Error::TooLong));
    assert_eq!(read(&mut store, 1), Some(b"one".to_vec()));
    // As many long records as there are keys are longer than a sector: the store says so and does not go in circles.
    let refused = (10..50).find_map(|key| store.save(key, &[key; MAX_PAYLOAD]).err());
    assert_eq!(refused, Some(Error::TooLong));
    store.save(1, b"two").unwrap();
    let mut store = settled(store.free());
    assert_eq!(
        (read(&mut store, 1), read(&mut store, 10)),
        (Some(b"two".to_vec()), Some(vec![10; MAX_PAYLOAD]))
    );
}

#[test]
fn a_start_after_another_without_a_save_wears_a_page_and_no_more() {
    let mut store = settled(blank());
    store.save(1, b"one").unwrap();
    let mut region = store.free();
    for start in 1..200 {
        let mut store = settled(region);
        assert_eq!(read(&mut store, 1), Some(b"one".to_vec()), "start {start}");
        region = store.free();
    }
    assert!(region.cells.erases().iter().all(|erases| *erases <= 200_u32.div_ceil(15).div_ceil(4) + 1));
}

/// A flash of which a sector no longer takes ones: an erase leaves zeros in it.
struct Dying {
    region: Region,
    sector: u32,
}

impl ErrorType for Dying {
    type Error = NorFlashErrorKind;
}

impl ReadNorFlash for Dying {
    const READ_SIZE: usize = 1;

    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), NorFlashErrorKind> {
        self.region.read(offset, bytes)
    }

    fn capacity(&self) -> usize {
        self.region.capacity()
    }
}

impl NorFlash for Dying {
    const WRITE_SIZE: usize = 1;
    const ERASE_SIZE: usize = SECTOR_BYTES;

    fn erase(&mut self, from: u32, to: u32) -> Result<(), NorFlashErrorKind> {
        self.region.erase(from, to)?;
        if from == self.sector * SECTOR_BYTES as u32 {
            self.region.write(from + 3_000, &[0xEF])?;
        }
        Ok(())
    }

    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), NorFlashErrorKind> {
        self.region.write(offset, bytes)
    }
}

#[test]
fn a_sector_that_does_not_stay_erased_is_passed_over() {
    let mut store = Store::mount(Dying { region: blank(), sector: 2 }).unwrap();
    for value in 0..3_000_u32 {
        store.save(1, &value.to_le_bytes()).unwrap();
    }
    let mut payload = [0; 4];
    assert_eq!(store.get(1, &mut payload), Ok(Some(4)));
    assert_eq!(u32::from_le_bytes(payload), 2_999);
}

/// What is kept at one moment of a scripted life, and what was just being put.
struct Account {
    kept: [Option<Vec<u8>>; 3],
    pending: Option<(u8, Vec<u8>)>,
}

impl Account {
    fn allows(&self, key: u8, read: Option<&Vec<u8>>) -> bool {
        let kept = self.kept[usize::from(key) - 1].as_ref();
        read == kept
            || self.pending.as_ref().is_some_and(|(other, payload)| *other == key && read == Some(payload))
    }
}

/// Every cut of a short life that fills some sectors, and a second cut in each recovery; `cargo xtask cuts` does more.
#[test]
fn after_a_cut_each_key_has_its_last_value_or_the_one_that_was_being_kept() {
    let mut account = Account { kept: [const { None }; 3], pending: None };
    let mut region = blank();
    let (mut cuts, mut seed) = (0_u64, 0);
    for step in 0..330_u32 {
        let key = [1, 1, 2, 1, 1, 3][step as usize % 6];
        let payload: Vec<u8> = step.to_le_bytes().repeat(1 + key as usize * 5);
        account.pending = Some((key, payload.clone()));
        // One program or erase after the other, and each of them cut off at every seventh byte.
        let mut store = settled(region.clone());
        store.flash_mut().journal = Some(Vec::new());
        store.save(key, &payload).unwrap();
        let total: usize =
            store.flash_mut().journal.as_ref().unwrap().iter().map(bench::flash::Work::len).sum();
        let stride = if total > SECTOR_BYTES { 97 } else { 3 };
        for supply in (0..total).step_by(stride) {
            seed += 1;
            let mut cut = settled(region.clone());
            cut.flash_mut().supply = Some(supply);
            assert!(cut.save(key, &payload).is_err());
            let mut left = cut.free();
            left.cells = left.cells.seeded(seed);
            // The recovery is cut off too, then left alone.
            left.supply = Some((seed as usize * 13) % 120);
            let mut second = mounted(left);
            while matches!(second.settle(), Ok(Next::Again)) {}
            let mut left = second.free();
            left.supply = None;
            let mut store = settled(left);
            let first: Vec<_> = (1..=3).map(|key| read(&mut store, key)).collect();
            for key in 1..=3 {
                let read = first[usize::from(key) - 1].as_ref();
                assert!(account.allows(key, read), "step {step}, cut at {supply}: key {key} has {read:?}");
            }
            let mut again = settled(store.free());
            let second: Vec<_> = (1..=3).map(|key| read(&mut again, key)).collect();
            assert_eq!(first, second, "step {step}, cut at {supply}: what was read once stays");
            cuts += 1;
        }
        let mut store = settled(region);
        store.save(key, &payload).unwrap();
        account.kept[usize::from(key) - 1] = Some(payload);
        region = store.free();
    }
    assert!(cuts > 5_000, "{cuts}");
}
