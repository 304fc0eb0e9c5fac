//! The run on the bench of which the table of tasks tells.
//!
//! Everything that makes a task long, one after another: power-on, a drive with its pages turned and its colours
//! changed, a full bus, a bus that is shorted and comes back.

use anyhow::{Context, Result};
use bench::can::LoadGenerator;
use bench::log::Log;
use bench::rig::{Rig, RigOptions};
use bench::rp2040::Watched;
use bench::time::Nanos;
use std::path::Path;

/// What the run is, for whoever reads the table.
pub const RUN: &str = "power-on, the 60 s city drive while pages turn, its frames back to back for 5 s, the bus shorted for 1 s";

/// Until then everything is started: the first picture is lit.
const STARTED: Nanos = Nanos::from_millis(500);
/// Until then the cluster is alone.
const ALONE: Nanos = Nanos::from_secs(2);
/// Time between two presses of the button that turns pages; every fifth is of the other one, which changes colours
/// and language.
const TURN: Nanos = Nanos::from_millis(1_300);
const PRESS: Nanos = Nanos::from_millis(100);
const FLOODED: Nanos = Nanos::from_secs(5);
const SHORTED: Nanos = Nanos::from_secs(1);
/// Time in which the bus and the picture come back.
const AFTERWARDS: Nanos = Nanos::from_secs(2);

/// What was seen.
pub struct Measured {
    /// Until [`STARTED`].
    pub start: Watched,
    /// After it.
    pub later: Watched,
    /// Priority of each external interrupt, 0 to 3, the smaller the more urgent.
    pub priorities: [u32; 32],
}

/// Lets the image run and watches it.
///
/// # Errors
/// If the image or the recording cannot be loaded, or the bench stops.
pub fn run(elf: &Path, city: &Path) -> Result<Measured> {
    let log = Log::read_file(city)?;
    let mut rig = Rig::new(elf, &RigOptions::default())?;
    rig.watch();
    rig.run_for(STARTED)?;
    let start = rig.watch().context("the core is watched")?;
    rig.run_for(ALONE)?;
    rig.replay(&log, false);
    turn_pages(&mut rig, log.duration())?;
    let node = rig.board_mut().bus_mut().attach("flood");
    rig.board_mut().join(LoadGenerator::of_recording(node, log.recording()));
    turn_pages(&mut rig, FLOODED)?;
    rig.short_bus(true);
    rig.run_for(SHORTED)?;
    rig.short_bus(false);
    rig.run_for(AFTERWARDS)?;
    let later = rig.watch().context("the core is watched")?;
    let core = rig.chip().core().context("the core is here between two runs")?;
    let priorities = std::array::from_fn(|irq| core.irq_priority(irq as u32));
    Ok(Measured { start, later, priorities })
}

fn turn_pages(rig: &mut Rig, span: Nanos) -> Result<()> {
    let end = rig.now() + span;
    let mut press = 1_usize;
    while rig.now() < end {
        let button = usize::from(press.is_multiple_of(5));
        rig.hold_button(button, true);
        rig.run_for(PRESS)?;
        rig.hold_button(button, false);
        rig.run_for(TURN - PRESS)?;
        press += 1;
    }
    Ok(())
}
