//! Cuts the power at every byte that the store programs or erases, and again in every recovery.
//!
//! A life is scripted with the cluster's own logic: starts, drives, settings, faults, and first of all what the version
//! before has kept. Each step of it is done once whole, for the account of what is kept, and once for every byte at
//! which the supply may fail. After each cut the region is started anew, in whole and with a second cut: every part must
//! be what the account says, or what was being kept, and stay so at the next start.

use crate::out::say;
use ::store::{MAX_PAYLOAD, Next, Store};
use anyhow::{Context, Result, bail, ensure};
use bench::flash::{Cells, Region, SECTOR_BYTES, Work};
use clap::Args;
use cluster::kept::Distance;
use cluster::{Inputs, Instrument, Memory, Options as ClusterOptions, Part};
use protocol_core::generated::citybus::{VEHICLE, Vcu1, id};
use protocol_core::{CanFrame, Millis};
use std::collections::BTreeMap;

/// Sectors of the region: fewer than the board has, so that they are used again sooner.
const SECTORS: usize = 3;

/// How thorough to be.
#[derive(Args, Clone, Debug, Default)]
pub struct Options {
    /// Every byte of every program, erase and recovery, which takes hours; otherwise every seventh byte of a program, every
    /// 1021st of an erase, every 101st of a recovery.
    #[arg(long)]
    full: bool,
}

/// Bytes between two cuts.
struct Strides {
    program: usize,
    erase: usize,
    recovery: usize,
}

/// What is kept, by number.
type Account = BTreeMap<u8, Vec<u8>>;

/// A step of the life.
enum Event {
    Start,
    Keep(u8, Vec<u8>),
}

#[derive(Default)]
struct Counts {
    cuts: usize,
    recoveries: usize,
    weak: usize,
    new: usize,
}

/// Lives the life and cuts it.
///
/// # Errors
/// If after a cut something is not as the account says; the error names the step and the byte.
pub fn run(options: &Options) -> Result<()> {
    let strides = match options.full {
        true => Strides { program: 1, erase: 1, recovery: 1 },
        false => Strides { program: 7, erase: 1_021, recovery: 101 },
    };
    let (mut region, mut account, mut counts) = (blank(), Account::new(), Counts::default());
    let events = life()?;
    for (step, event) in events.iter().enumerate() {
        let Ok(done) = perform(region.clone(), event, None) else {
            bail!("step {step} does not come to its end")
        };
        let lens: Vec<usize> = done.journal.iter().flatten().map(Work::len).collect();
        let mut start = 0;
        for len in lens {
            let stride = if len >= SECTOR_BYTES { strides.erase } else { strides.program };
            for at in (0..len).step_by(stride) {
                let Err(left) = perform(region.clone(), event, Some(start + at)) else {
                    bail!("step {step}: the supply did not fail");
                };
                check(*left, event, &account, &strides, &mut counts)
                    .with_context(|| format!("step {step}, cut at byte {at} of {len}"))?;
            }
            start += len;
        }
        if let Event::Keep(number, payload) = event {
            account.insert(*number, payload.clone());
        }
        region = done;
        region.journal = None;
    }
    let keeps = events.iter().filter(|event| matches!(event, Event::Keep(..))).count();
    let starts = events.len() - keeps;
    say!("life     {starts} starts, {keeps} parts kept, {:?} erases of the sectors", region.cells.erases())?;
    say!(
        "cuts     {} in programs and erases, {} of them leave cells that read either way",
        counts.cuts,
        counts.weak
    )?;
    say!("         {} more in the recoveries", counts.recoveries)?;
    say!(
        "after    every part is as it was kept; {} times the one that was being kept is the new one already",
        counts.new
    )?;
    Ok(())
}

fn blank() -> Region {
    Region::new(Cells::new(vec![0xff; SECTORS * SECTOR_BYTES]), 0, SECTORS * SECTOR_BYTES)
}

/// Does a step to its end; `Err` = the supply has failed, with what is left.
fn perform(mut region: Region, event: &Event, supply: Option<usize>) -> Result<Region, Box<Region>> {
    region.supply = supply;
    region.journal = Some(Vec::new());
    let Ok(mut store) = Store::mount(region) else { unreachable!("reading needs no supply") };
    let mut next = match event {
        Event::Start => settle(&mut store),
        Event::Keep(number, payload) => {
            settle(&mut store).and_then(|()| store.save(*number, payload).map_err(drop))
        }
    };
    // The sector that comes next is erased ahead, as the firmware does it.
    while next.is_ok() {
        next = match store.prepare() {
            Ok(Next::Done) => return Ok(store.free()),
            Ok(Next::Again) => Ok(()),
            Ok(Next::Erase(offset)) => store.erase(offset).map_err(drop),
            Err(_) => Err(()),
        };
    }
    let mut left = store.free();
    left.supply = None;
    Err(Box::new(left))
}

fn settle(store: &mut Store<Region>) -> Result<(), ()> {
    loop {
        match store.settle().map_err(drop)? {
            Next::Done => return Ok(()),
            Next::Again => {}
            Next::Erase(offset) => store.erase(offset).map_err(drop)?,
        }
    }
}

/// Starts with what a cut has left, to the end and with a second cut at many bytes.
fn check(
    left: Region,
    event: &Event,
    account: &Account,
    strides: &Strides,
    counts: &mut Counts,
) -> Result<()> {
    counts.cuts += 1;
    counts.weak += usize::from(left.cells.weak_bits() > 0);
    let seed = counts.cuts as u64;
    let left = noisy(left, seed);
    let (first, after) = started(left.clone())?;
    compare(&first, event, account)?;
    counts.new += usize::from(first != *account);
    let (second, _) = started(after.clone())?;
    ensure!(first == second, "the next start has {second:02X?}, not {first:02X?}");
    let total: usize = after.journal.iter().flatten().map(Work::len).sum();
    // Each recovery is cut at other bytes.
    for supply in (counts.cuts % strides.recovery..total).step_by(strides.recovery) {
        let Err(twice) = perform(left.clone(), &Event::Start, Some(supply)) else { continue };
        let (found, _) = started(noisy(*twice, seed ^ supply as u64))?;
        compare(&found, event, account).with_context(|| format!("second cut at byte {supply} of {total}"))?;
        counts.recoveries += 1;
    }
    Ok(())
}

/// Starts a region; returns what it holds.
fn started(region: Region) -> Result<(Account, Region)> {
    let region = perform(region, &Event::Start, None).map_err(|_| anyhow::anyhow!("the region refuses"))?;
    let journal = region.journal.clone();
    let mut store = Store::mount(region).map_err(|error| anyhow::anyhow!("{error:?}"))?;
    let mut found = Account::new();
    for number in store.keys().collect::<Vec<_>>() {
        let mut payload = [0; MAX_PAYLOAD];
        if let Ok(Some(len)) = store.get(number, &mut payload) {
            found.insert(number, payload[..len].to_vec());
        }
    }
    let mut region = store.free();
    region.journal = journal;
    Ok((found, region))
}

/// Gives the cells that a cut has left weak another noise.
fn noisy(mut region: Region, seed: u64) -> Region {
    region.cells = region.cells.seeded(seed);
    region
}

/// Fails unless every part is as the account says, or the one that was being kept is new.
fn compare(found: &Account, event: &Event, account: &Account) -> Result<()> {
    let mut new = account.clone();
    if let Event::Keep(number, payload) = event {
        new.insert(*number, payload.clone());
    }
    ensure!(found == account || *found == new, "{found:02X?} is kept, not {account:02X?} or {new:02X?}");
    Ok(())
}

/// Scripts a life: every part that the cluster wants to keep, in the order in which it wants to.
fn life() -> Result<Vec<Event>> {
    // What the version before has kept: one trip, no theme, no cause of the last start.
    let mut shelf = Account::from([
        (Part::Distance.number(), Distance::of_metres(123_456_700).to_bytes().to_vec()),
        (Part::Trips.number(), vec![7; 32]),
        (Part::Settings.number(), vec![1]),
        (Part::Starts.number(), vec![9; 12]),
    ]);
    let mut events: Vec<Event> =
        shelf.iter().map(|(number, bytes)| Event::Keep(*number, bytes.clone())).collect();
    for (start, seconds) in [14, 2, 25, 1, 1, 8].into_iter().enumerate() {
        events.push(Event::Start);
        let before = metres(&shelf);
        live(&mut shelf, &mut events, start, seconds);
        ensure!(metres(&shelf) >= before, "the scripted life runs backwards");
    }
    Ok(events)
}

fn metres(shelf: &Account) -> u64 {
    shelf
        .get(&Part::Distance.number())
        .and_then(|bytes| Distance::from_bytes(bytes))
        .map_or(0, Distance::metres)
}

/// One drive: the bus's controller alone is heard, so every other node is a fault; buttons are pushed now and then.
fn live(shelf: &mut Account, events: &mut Vec<Event>, start: usize, seconds: u64) {
    let mut instrument = Instrument::fixed(&VEHICLE, ClusterOptions::default());
    for (number, bytes) in &*shelf {
        if let Some(part) = Part::from_number(*number) {
            instrument.restore(part, bytes);
        }
    }
    instrument.resume(Memory::Kept);
    for tick in 0..seconds * 100 {
        let now = Millis(tick * 10);
        if tick % 5 == 0 {
            // 90 km/h, and at a stop in the last second of every twenty.
            let stands = tick / 100 % 20 == 19 || tick / 100 + 1 == seconds;
            let speed = if stands { 0 } else { 90 << 8 };
            let vcu = Vcu1::new().with_vehicle_speed_raw(speed).with_life_raw((tick / 5) as u8);
            instrument.hear(&CanFrame::full(id::VCU1, vcu.0), now);
        }
        let mut inputs = Inputs::default();
        inputs.buttons.menu = tick % 1_500 < 10 && start > 0;
        instrument.tick(&inputs, now);
        if let Some((part, bytes)) = instrument.due(now) {
            shelf.insert(part.number(), bytes.to_vec());
            events.push(Event::Keep(part.number(), bytes.to_vec()));
            instrument.saved(part, &bytes, now);
        }
    }
}
