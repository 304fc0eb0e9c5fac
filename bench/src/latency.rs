//! How long a change takes from the wire to the glass: the end of a CAN frame to the last pixel that it changes.
//!
//! Owns the traffic of a standing bus on which one value changes again and again, at every phase of the firmware's
//! clocks, and the part of the screen in which the change must show. Counts virtual time on the models' side of the
//! pins: the firmware is not asked. Refuses to say what a picture should look like.

use crate::can::{Frame, Id, LoadGenerator};
use crate::log::Log;
use crate::rig::{Rig, RigOptions};
use crate::time::Nanos;
use anyhow::{Context, Result, bail};
use protocol_core::generated::citybus::{Bms1, Vcu1, id};
use protocol_core::{CanFrame, CanId};
use std::path::Path;

/// What changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// The gear, N to D and back: one letter.
    Gear,
    /// A fault of the battery, level 2, comes and goes: its lamps, the stripe and the message line.
    Fault,
    /// The speed, 48 to 49 km/h and back: one figure and the pointer.
    Speed,
    /// The speed, 119 to 188 km/h and back: three figures and two thirds of the dial.
    Dial,
}

/// Which part of a bus's time is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Traffic {
    /// The frames of a standing bus.
    Standing,
    /// The same, and every gap filled with frames of an identifier that no vehicle has.
    Full,
}

/// Times between the end of a frame and the last pixel that it changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Latencies(Vec<Nanos>);

impl Latencies {
    /// The time that half of the changes stay below.
    pub fn median(&self) -> Nanos {
        self.0.get(self.0.len() / 2).copied().unwrap_or_default()
    }

    /// The longest.
    pub fn worst(&self) -> Nanos {
        self.0.last().copied().unwrap_or_default()
    }
}

/// Time in which the vehicle is recognised, its name has been shown and the lamps' check is over.
const SETTLED: Nanos = Nanos::from_millis(7_500);
/// Period of the frame that carries the change: not a multiple of any period of the firmware, so that the phase between
/// them takes every value.
const PERIOD: Nanos = Nanos::from_micros(20_037);
/// Frames with the same value: within their time every picture is finished.
const FRAMES_EACH: usize = 9;
/// How much of the recording is repeated: the bus stands in it, and each node's life counter moves.
const STANDING: Nanos = Nanos::from_millis(2_500);

/// An identifier that no vehicle has.
const STRANGER: Option<Id> = Id::extended(0x1FFF_FFF0);

/// A rectangle of the screen: columns, rows.
type Place = ([u16; 2], [u16; 2]);

impl Change {
    /// The identifier of the frame that carries it.
    const fn id(self) -> CanId {
        match self {
            Self::Fault => id::BMS1,
            Self::Gear | Self::Speed | Self::Dial => id::VCU1,
        }
    }

    /// Returns `rest`, the frame of a standing bus, in one of the two states of the change.
    fn apply(self, rest: [u8; 8], second: bool, count: u8) -> [u8; 8] {
        let speed = |kmh: u16| Vcu1(rest).with_vehicle_speed_raw(kmh << 8).with_life_raw(count).0;
        match self {
            Self::Gear => {
                Vcu1(rest).with_gear_raw(if second { DRIVE } else { NEUTRAL }).with_life_raw(count).0
            }
            Self::Fault => Bms1(rest).with_fault_level_raw(if second { 2 } else { 0 }).0,
            Self::Speed => speed(if second { 49 } else { 48 }),
            Self::Dial => speed(if second { 188 } else { 119 }),
        }
    }

    /// Where it shows; nothing that changes without it stands there.
    const fn place(self) -> Place {
        match self {
            Self::Gear => ([146, 174], [45, 69]),
            Self::Fault => ([0, 320], [189, 240]),
            Self::Speed | Self::Dial => ([70, 240], [26, 170]),
        }
    }
}

/// Codes of the gear in VCU1 (BUS-36).
const DRIVE: u8 = 1;
const NEUTRAL: u8 = 4;

/// Lets a value change `count` times and measures each.
///
/// # Errors
/// If the image or the recording cannot be loaded, the bench stops, or a change does not show.
pub fn measure(elf: &Path, city: &Log, change: Change, traffic: Traffic, count: usize) -> Result<Latencies> {
    let carrier = Frame::from(&CanFrame::full(change.id(), [0; 8])).id;
    let rest = city.entries.iter().find(|entry| entry.frame.id == carrier);
    let rest =
        rest.with_context(|| format!("the recording has no frame {:08X}", change.id().bits()))?.frame.data;
    let others = city.entries.iter().filter(|entry| entry.at < STANDING && entry.frame.id != carrier);
    let others = Log { entries: others.cloned().collect(), ..city.clone() };

    let mut rig = Rig::new(elf, &RigOptions::default())?;
    rig.replay(&others, true);
    if traffic == Traffic::Full {
        let flood = rig.board_mut().bus_mut().attach("flood");
        rig.board_mut().join(LoadGenerator::sequenced(flood, STRANGER.context("a 29-bit identifier")?));
    }
    let mut sent = 0_u8;
    let mut send = |rig: &mut Rig, second: bool| -> Result<Nanos> {
        let data = change.apply(rest, second, sent);
        sent = sent.wrapping_add(1);
        let (_, before) = rig.heard_since(usize::MAX);
        rig.send(Frame::from(&CanFrame::full(change.id(), data)));
        rig.run_for(PERIOD)?;
        let (heard, _) = rig.heard_since(before);
        let own = heard.iter().find(|heard| heard.frame.id == carrier && heard.frame.data == data);
        own.map(|heard| heard.at).context("the bus did not take the frame within its period")
    };
    while rig.now() < SETTLED {
        send(&mut rig, false)?;
    }
    let mut times = Vec::new();
    for number in 1..=count {
        let second = number % 2 == 1;
        let at = send(&mut rig, second)?;
        for _ in 1..FRAMES_EACH {
            send(&mut rig, second)?;
        }
        let shown_at = last_change(&rig, change.place());
        if shown_at < at {
            bail!("{change:?} number {number}, on the bus at {at}, does not show on the panel");
        }
        times.push(shown_at.since(at));
    }
    times.sort_unstable();
    Ok(Latencies(times))
}

/// Returns when a pixel of a part of the screen last changed its colour.
fn last_change(rig: &Rig, ([left, right], [top, bottom]): Place) -> Nanos {
    let panel = rig.board().panel();
    let pixels = (top..bottom).flat_map(|y| (left..right).map(move |x| (x, y)));
    pixels.filter_map(|(x, y)| panel.changed_at(x, y)).max().unwrap_or_default()
}
