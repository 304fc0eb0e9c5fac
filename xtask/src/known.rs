//! The vehicles as their files are now: what the commands that read and write frames work with.
//!
//! `vehicles/` of the repository, a folder anywhere, or a DBC file alone; all read at run time, so a corrected file needs
//! no compiler. Vehicles are told apart by the identifiers heard: the one with most of them is taken.

use crate::out::note;
use crate::vehicles::can_id;
use crate::workspace;
use anyhow::{Result, anyhow, bail};
use bench::can::Id;
use clap::Args;
use protocol_core::CanId;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use vehicle_compiler::{Grade, RunTime, did_you_mean};

/// Where the meaning of the frames stands.
#[derive(Args, Clone, Debug, Default)]
pub struct Source {
    /// Vehicle whose files to use: a name in `vehicles/`, or the path of a folder with a DBC file and vehicle.toml; found
    /// from the identifiers heard if not given.
    #[arg(long, value_name = "NAME|PATH")]
    vehicle: Option<String>,
    /// DBC file to use alone, without a vehicle.toml.
    #[arg(long, value_name = "FILE", conflicts_with = "vehicle")]
    dbc: Option<PathBuf>,
}

impl Source {
    /// Returns the vehicle that is asked for, `None` if it has to be found.
    ///
    /// # Errors
    /// If there is none, or everything that is wrong with its files.
    pub fn wanted(&self) -> Result<Option<&'static RunTime>> {
        match (&self.vehicle, &self.dbc) {
            (Some(vehicle), _) => named(vehicle).map(Some),
            (None, Some(file)) => {
                RunTime::of_dbc(file).map(|read| Some(kept(read))).map_err(|wrong| anyhow!("{wrong}"))
            }
            (None, None) => Ok(None),
        }
    }

    /// Returns the vehicle that is asked for, else the one that most frames of a recording belong to:
    /// identifiers, and how many frames have them.
    ///
    /// # Errors
    /// Like [`Source::wanted`], or if no vehicle has any of the identifiers.
    pub fn of_frames(&self, ids: impl Iterator<Item = (Id, usize)>) -> Result<&'static RunTime> {
        if let Some(wanted) = self.wanted()? {
            return Ok(wanted);
        }
        let ids: Vec<(CanId, usize)> = ids.map(|(id, frames)| (can_id(id), frames)).collect();
        let heard = |known: &RunTime| {
            let of = ids.iter().filter(|(id, _)| known.network.message_of(*id).is_some());
            of.map(|(_, frames)| frames).sum::<usize>()
        };
        let all = all();
        let best = all.iter().map(|known| (heard(known), *known)).max_by_key(|(count, _)| *count);
        match best {
            Some((count, known)) if count > 0 => Ok(known),
            _ => bail!(no_vehicle(&all, ids.iter().map(|(id, _)| *id))),
        }
    }
}

/// Keeps what a command works with until it ends.
fn kept(read: RunTime) -> &'static RunTime {
    say_findings(&read);
    Box::leak(Box::new(read))
}

/// Says on standard error how the file was read, and that a part of it cannot be had.
fn say_findings(read: &RunTime) {
    let of = |grade: Grade| read.findings.0.iter().filter(move |found| found.grade == grade);
    for found in of(Grade::Note).filter(|found| found.line == 0) {
        note!("{}: {}", found.file, found.message);
    }
    if let Some(first) = of(Grade::Warning).next() {
        let more = of(Grade::Warning).count() - 1;
        let more =
            if more > 0 { format!(" (and {more} more: `cargo xtask dbc` shows all)") } else { String::new() };
        note!("{first}{more}");
    }
}

/// Returns every vehicle of the repository that can be read, sorted by name.
pub fn all() -> Vec<&'static RunTime> {
    let read = |name: &String| match RunTime::of_folder(&workspace::root().join("vehicles").join(name)) {
        Ok(read) => Some(&*Box::leak(Box::new(read))),
        Err(wrong) => {
            note!("vehicles/{name} is left out: {wrong}");
            None
        }
    };
    names().iter().filter_map(read).collect()
}

/// Returns the names of the vehicles of the repository, sorted.
fn names() -> Vec<String> {
    vehicle_compiler::vehicles(&workspace::root()).unwrap_or_default()
}

/// Returns the vehicle of a name or a path.
///
/// # Errors
/// If there is none; the error names the nearest and all. Or everything that is wrong with its files.
pub fn named(name: &str) -> Result<&'static RunTime> {
    let in_tree = workspace::root().join("vehicles").join(name);
    let is_name = Path::new(name).components().count() == 1;
    let folder = if is_name && in_tree.is_dir() { in_tree } else { PathBuf::from(name) };
    if folder.is_dir() {
        return RunTime::of_folder(&folder).map(kept).map_err(|wrong| anyhow!("{wrong}"));
    }
    let names = names();
    let near = did_you_mean(name, names.iter().map(String::as_str));
    bail!("no vehicle is called `{name}`{near} (known: {}; or the path of a folder)", names.join(", "))
}

/// Returns what to say when no vehicle has any of the identifiers heard.
pub fn no_vehicle(all: &[&RunTime], ids: impl Iterator<Item = CanId>) -> String {
    let ids: BTreeSet<CanId> = ids.collect();
    let first: Vec<String> = ids.iter().take(5).map(ToString::to_string).collect();
    let more = if ids.len() > first.len() { ", ..." } else { "" };
    let known: Vec<&str> = all.iter().map(|known| known.name.as_str()).collect();
    format!(
        "no vehicle ({}) has any of the identifiers heard ({}{more}); say which one with --vehicle, or --dbc FILE",
        known.join(", "),
        first.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A vehicle that is added may share identifiers with another; a recording of it is then read with `--vehicle`.
    #[test]
    fn no_identifier_belongs_to_two_of_the_documented_vehicles() {
        let all = all();
        let known =
            || all.iter().filter(|known| ["citybus", "c5ev", "jiulong"].contains(&known.name.as_str()));
        let ids: Vec<u32> =
            known().flat_map(|known| &known.network.messages).map(|message| message.id).collect();
        assert_eq!(known().count(), 3);
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
    }
}
