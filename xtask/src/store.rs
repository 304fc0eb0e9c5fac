//! Prints what a cluster keeps over power-off, out of an image of its flash; a workshop sets the odometer here.
//!
//! The image is what `picotool save --all` reads out of a board, or what `run --headless --flash FILE` writes. Nothing is
//! changed unless a distance is to be set, and that leaves its record.

use crate::out::say;
use ::store::{Condition, MAX_PAYLOAD, SECTOR_BYTES, Store};
use anyhow::{Context, Result, anyhow, bail, ensure};
use bench::flash::{Cells, Region};
use bench::rig::STORE;
use clap::Args;
use cluster::Part;
use cluster::kept::{Distance, KeptFault, Starts, Workshop};
use std::path::PathBuf;

/// Payload bytes of a UF2 block, and where its address and payload stand.
const UF2_BLOCK: usize = 512;
const UF2_MAGIC: [u8; 4] = *b"UF2\n";

/// What to look at.
#[derive(Args, Clone, Debug)]
pub struct Options {
    /// Image of a whole flash, or of the 32 KiB at its top; raw, or UF2 as `picotool save` writes it.
    file: PathBuf,
    /// Sets the odometer to this distance in kilometres; the image is written back, raw.
    #[arg(long, value_name = "KM", requires = "by")]
    set_km: Option<f64>,
    /// Who sets it, or on what order: it stays in the record.
    #[arg(long, value_name = "TEXT", requires = "set_km")]
    by: Option<String>,
}

/// Prints what is kept.
///
/// # Errors
/// If the file is no image of a flash, or nothing can be written to it.
pub fn run(options: &Options) -> Result<()> {
    let name = options.file.display();
    let file = std::fs::read(&options.file).with_context(|| format!("cannot read {name}"))?;
    let mut image = if file.starts_with(&UF2_MAGIC) { from_uf2(&file)? } else { file };
    let region = match image.len() {
        len if len == STORE.len() => 0..len,
        len if len >= STORE.end => STORE,
        len => bail!(
            "{name} has {len} bytes: neither a whole flash ({}) nor its top ({})",
            STORE.end,
            STORE.len()
        ),
    };
    let bytes = image.get(region.clone()).unwrap_or_default().to_vec();
    let mut kept = Store::mount(Region::new(Cells::new(bytes), 0, STORE.len())).map_err(refused)?;
    if let (Some(km), Some(by)) = (options.set_km, &options.by) {
        set(&mut kept, km, by)?;
        print(&mut kept)?;
        if let Some(place) = image.get_mut(region) {
            place.copy_from_slice(kept.free().cells.bytes());
        }
        return std::fs::write(&options.file, image).with_context(|| format!("cannot write {name}"));
    }
    print(&mut kept)
}

fn refused<E: std::fmt::Debug>(error: E) -> anyhow::Error {
    anyhow!("the store refuses: {error:?}")
}

/// Sets the odometer and leaves the record of it first: a cut between the two shows the act, not the distance alone.
fn set(kept: &mut Store<Region>, km: f64, by: &str) -> Result<()> {
    ensure!((0.0..=9_999_999.0).contains(&km), "{km} km is no distance of a vehicle");
    ensure!(!by.trim().is_empty(), "--by says who sets the odometer");
    let after = Distance::of_metres((km * 1_000.0).round() as u64);
    let before = read(kept, Part::Distance)?.and_then(|bytes| Distance::from_bytes(&bytes));
    let last = read(kept, Part::Workshop)?.and_then(|bytes| Workshop::from_bytes(&bytes));
    let times = last.map_or(0, |last| last.times).saturating_add(1);
    let record = Workshop { times, before, after, by: by.bytes().take(40).collect() };
    kept.save(Part::Workshop.number(), &record.to_bytes()).map_err(refused)?;
    kept.save(Part::Distance.number(), &after.to_bytes()).map_err(refused)
}

fn read(kept: &mut Store<Region>, part: Part) -> Result<Option<Vec<u8>>> {
    let mut payload = [0; MAX_PAYLOAD];
    let len = kept.get(part.number(), &mut payload).map_err(refused)?;
    Ok(len.map(|len| payload.iter().copied().take(len).collect()))
}

fn print(kept: &mut Store<Region>) -> Result<()> {
    let condition = match kept.condition() {
        Condition::New => "new: nothing was ever kept".to_owned(),
        Condition::Kept => "records are there".to_owned(),
        Condition::Damaged => "damaged: something is there and none of it is a record".to_owned(),
        Condition::Newer(version) => format!("written by a later firmware, format {version}: not read"),
    };
    say!("store    {condition}")?;
    let erases: Vec<String> = (0..STORE.len() / SECTOR_BYTES)
        .map(|sector| kept.erases(sector).ok().flatten().map_or("-".to_owned(), |erases| erases.to_string()))
        .collect();
    say!("wear     erases of the sectors: {}", erases.join(" "))?;
    let mut numbers: Vec<u8> = kept.keys().collect();
    numbers.sort_unstable();
    for number in numbers {
        let mut payload = [0; MAX_PAYLOAD];
        let Some(len) = kept.get(number, &mut payload).map_err(refused)? else { continue };
        line(number, payload.get(..len).unwrap_or_default())?;
    }
    Ok(())
}

/// Prints one part.
fn line(number: u8, bytes: &[u8]) -> std::io::Result<()> {
    let word = |at: usize, words: [&'static str; 2]| {
        bytes.get(at).and_then(|place| words.get(usize::from(*place))).copied().unwrap_or("?")
    };
    match Part::from_number(number) {
        Some(Part::Distance) => match Distance::from_bytes(bytes) {
            Some(distance) => say!("distance {}", told(distance)),
            None => say!("distance ? ({bytes:02x?})"),
        },
        Some(Part::Trips) => {
            let number = |at: usize| {
                bytes.get(8 * at..).and_then(<[u8]>::first_chunk).map_or(0, |word| u64::from_le_bytes(*word))
            };
            for (trip, first) in ["A", "B"].into_iter().zip([0, 4]) {
                let km = Distance { counts: number(first), is_known: true }.metres() as f64 / 1_000.0;
                // 10 mW times milliseconds.
                let kwh = |at| number(first + at) as f64 / 360_000_000.0 / 1_000.0;
                say!("trip {trip}   {km:.1} km, {:.2} kWh used, {:.2} kWh regained", kwh(2), kwh(3))?;
            }
            Ok(())
        }
        Some(Part::Settings) => {
            say!("settings language {}, theme {}", word(0, ["Chinese", "English"]), word(1, ["night", "day"]))
        }
        Some(Part::Vehicle) => say!("vehicle  {}", String::from_utf8_lossy(bytes)),
        Some(Part::Starts) => {
            let Starts { power_ons, watchdogs, panics, last } = Starts::from_bytes(bytes);
            let last = ["power", "watchdog", "panic"].get(usize::from(last)).copied().unwrap_or("?");
            say!(
                "starts   {power_ons} by power, {watchdogs} by the watchdog, {panics} after a panic; the last by {last}"
            )
        }
        Some(Part::Workshop) => match Workshop::from_bytes(bytes) {
            Some(act) => say!(
                "workshop the odometer was set {} times, last from {} to {} by {}",
                act.times,
                act.before.map_or("nothing".to_owned(), told),
                told(act.after),
                String::from_utf8_lossy(&act.by)
            ),
            None => say!("workshop ? ({bytes:02x?})"),
        },
        Some(Part::Fault(_)) => match KeptFault::from_bytes(bytes) {
            Some(fault) => say!(
                "fault    {} {}, {}, {} times, first in start {}, last in start {} at {:.1} km",
                fault.entry.fault.key(),
                fault.entry.code.map_or("without a code".to_owned(), |code| code.to_string()),
                fault.entry.severity.word(),
                fault.entry.count,
                fault.first_start,
                fault.last_start,
                f64::from(fault.hectometres) / 10.0
            ),
            None => say!("fault    ? ({bytes:02x?})"),
        },
        None => say!("part {number:3} of another firmware: {bytes:02x?}"),
    }
}

fn told(distance: Distance) -> String {
    let km = distance.metres() as f64 / 1_000.0;
    if distance.is_known { format!("{km:.1} km") } else { format!("not known, {km:.1} km since it was lost") }
}

/// Puts the blocks of a UF2 file where they belong in a whole flash.
fn from_uf2(file: &[u8]) -> Result<Vec<u8>> {
    let mut flash = vec![0xff; STORE.end];
    for block in file.chunks_exact(UF2_BLOCK) {
        let word = |at: usize| {
            block.get(at..).and_then(<[u8]>::first_chunk).map_or(0, |word| u32::from_le_bytes(*word))
        };
        let (at, len) = ((word(12) & 0x00FF_FFFF) as usize, word(16) as usize);
        let payload = block.get(32..32 + len).context("a block of the UF2 file is damaged")?;
        flash
            .get_mut(at..at + len)
            .context("a block of the UF2 file lies outside the flash")?
            .copy_from_slice(payload);
    }
    Ok(flash)
}
