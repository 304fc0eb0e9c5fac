//! External charging: what the battery asks for, the charger on board, the handshake between them.
//!
//! Owns `World::charger`, the charging state and the day count between charges. Constant current up to a voltage of the
//! highest cell, then constant voltage until the current has gone down. Refuses to lay out frames. Source: BUS-R030,
//! R037, R084, R113, R114, R147 to R154, JL-R027 to R030, C5-R004 to R011. Battery and charger know of each other what
//! their frames say; on the bus those travel on a bus of their own (BUS-R011).

use super::contactors::{Wish, conducts};
use super::pack::Load;
use super::{SILENCE_MS, count_while};
use crate::world::{Charge, ChargerBounds, ChargerTrips, Turn, World};
use crate::{STEP_MS, STEP_S};
use protocol_core::model::Severity::{self, Derate, Stop, Warn};

/// The highest cell is charged up to this voltage and held there.
const FULL_CELL_VOLTS: f64 = 3.50;
/// Voltage per cell that the charger is told.
const CHARGE_VOLTS: f64 = 3.60;
/// Largest current asked for, as a share of the capacity per hour.
const CHARGE_RATE: f64 = 0.5;
/// Charging is complete below this share of the capacity per hour ...
const TAIL_RATE: f64 = 0.05;
/// ... for so long ...
const TAIL_MS: u64 = 10_000;
/// ... with the highest cell this near to its end.
const FULL_TOLERANCE_VOLTS: f64 = 0.02;
/// Output current rises by so many amperes per second.
const RAMP_AMPS_PER_S: f64 = 10.0;
/// Mains voltage that the charger takes: 220 V and 15 % to either side.
const MAINS_VOLTS: std::ops::RangeInclusive<f64> = 187.0..=253.0;
/// Heater runs below the first and until the second, in degrees Celsius.
const HEATER_CELSIUS: (f64, f64) = (3.0, 8.0);
/// A day, and the driving that makes it one (BUS-R084), in ms.
const DAY_MS: u64 = 24 * 3_600_000;
const DRIVEN_DAY_MS: u64 = 3_600_000;
/// Largest count that is sent; 255 means invalid (BUS-76).
const MOST_DAYS: u32 = 254;

/// Codes of the charger's own findings; the ranges are printed, the meanings are the maker's (BUS-R151).
const HARDWARE_CODE: u8 = 1;
const INPUT_CODE: u8 = 2;
const REVERSED_CODE: u8 = 3;
const COMMUNICATION_CODE: u8 = 4;
const HEAT_CODE: u8 = 51;

/// Severity of a charger's code by its range (BUS-R151).
fn severity_of(code: u8) -> Severity {
    match code {
        1..=8 => Stop,
        51..=58 => Derate,
        101..=108 => Warn,
        _ => Severity::None,
    }
}

/// Fits the charger to the vehicle.
pub(super) fn build(world: &mut World) {
    world.charger.max_amps = world.spec.battery.charger_amps;
}

fn charge_path_is_closed(world: &World) -> bool {
    let bms = &world.bms;
    if world.spec.battery.own_charge_relays {
        conducts(&bms.charge_1) || conducts(&bms.charge_2)
    } else {
        world.hv_connected()
    }
}

fn pack_ohm(world: &World) -> f64 {
    world.pack.cell_ohm.iter().sum()
}

/// What pulls at the cells in this step.
pub(super) fn load(world: &mut World, precharge_amps: f64) -> Load {
    if !charge_path_is_closed(world) {
        world.charger.amps = 0.0;
    }
    let heater_watts = if conducts(&world.bms.heater) { world.spec.battery.heater_watts } else { 0.0 };
    let link = if world.hv_connected() { world.load_watts() } else { 0.0 };
    Load { watts: link + heater_watts, amps: precharge_amps - world.charger.amps, heater_watts }
}

/// The battery has not heard the charger for too long (C5-R005).
fn charger_is_lost(world: &World) -> bool {
    world.charger.plugged && world.bms.charger_silence_ms >= SILENCE_MS
}

/// The charger has not heard what it is to do for too long (C5-R007).
fn battery_is_lost(world: &World) -> bool {
    world.charger.plugged && world.charger.silence_ms >= SILENCE_MS
}

/// A silent charger keeps the main relay open though the vehicle asks for it (C5-R005).
pub(super) fn forbids_high_voltage(world: &World) -> bool {
    world.spec.battery.bounds_the_charger && charger_is_lost(world)
}

/// Lets battery and charger decide; returns which circuits are to be closed.
pub(super) fn step(world: &mut World) -> Wish {
    let bms = &mut world.bms;
    bms.charger_heard = world.charger.plugged && bms.charger.present;
    count_while(world.charger.plugged, &mut bms.plugged_ms);
    let wish = decide(world);
    charger(world);
    complete(world);
    day(world);
    wish
}

/// What the battery controller wants.
fn decide(world: &mut World) -> Wish {
    let spec = &world.spec.battery;
    let plug = world.charger.plugged && world.charger.mains_volts > 0.0;
    let pantograph = world.charger.pantograph && world.bms.vcu.charge_enable;
    let closed = charge_path_is_closed(world);
    let charger_lost = charger_is_lost(world);
    let ohm = world.pack.cell_ohm.get(world.bms.cell_max.index).copied().unwrap_or(1.0);
    let bms = &mut world.bms;
    let charger_fault = plug && bms.charger.stopped;
    let refused = bms.forbids_charging || bms.hv_off_request || bms.isolated;
    bms.charge = match bms.charge {
        _ if !world.charger.plugged && !pantograph => Charge::Idle,
        _ if refused || charger_lost || charger_fault => Charge::Fault,
        Charge::Complete => Charge::Complete,
        _ if !plug && !pantograph => Charge::Idle,
        _ if plug && !bms.charger_heard => Charge::Idle,
        _ if closed => Charge::Charging,
        _ => Charge::Idle,
    };
    let ready = if plug { bms.charger_heard } else { pantograph };
    let wants = ready && matches!(bms.charge, Charge::Idle | Charge::Charging);
    bms.charger_enabled = wants && bms.charge == Charge::Charging;
    // The current at which the highest cell would just reach its end.
    let to_full = world.charger.amps + (FULL_CELL_VOLTS - bms.cell_max.value) / ohm;
    let rate = CHARGE_RATE * world.pack.capacity_ah;
    let amps = if wants { bms.charge_limit_amps.min(rate).min(to_full).max(0.0) } else { 0.0 };
    let cells = world.pack.cell_volts.len() as f64;
    bms.wanted_charge = (amps, if wants { CHARGE_VOLTS * cells } else { 0.0 });
    bms.charger_bounds = bounds(cells, spec.charge_amps, bms.defects.bounds_exchanged);
    let heated = bms.heater.iter().all(|relay| relay.driven);
    let heater_until = if heated { HEATER_CELSIUS.1 } else { HEATER_CELSIUS.0 };
    Wish {
        high_voltage: wants && !spec.own_charge_relays,
        charge_1: wants && spec.own_charge_relays && plug,
        charge_2: wants && spec.own_charge_relays && pantograph && !plug,
        heater: wants && closed && bms.cold.value < heater_until,
    }
}

/// Warning and protection that the charger is told, in V per cell and as shares of the largest charge current.
const OVER_VOLTS: (f64, f64) = (3.65, 3.75);
const UNDER_VOLTS: (f64, f64) = (2.6, 2.3);
const OVER_AMPS: (f64, f64) = (1.0, 1.1);

/// Thresholds for the charger; `exchanged` is a defect that puts warnings where protections belong.
fn bounds(cells: f64, amps: f64, exchanged: bool) -> ChargerBounds {
    let pair = |(warning, protection): (f64, f64), by: f64| {
        if exchanged { (protection * by, warning * by) } else { (warning * by, protection * by) }
    };
    let (over_volts_warning, over_volts_protection) = pair(OVER_VOLTS, cells);
    let (under_volts_warning, under_volts_protection) = pair(UNDER_VOLTS, cells);
    let (over_amps_warning, over_amps_protection) = pair(OVER_AMPS, amps);
    ChargerBounds {
        over_volts_warning,
        over_volts_protection,
        under_volts_warning,
        under_volts_protection,
        over_amps_warning,
        over_amps_protection,
    }
}

impl ChargerTrips {
    /// Classifies by the battery's thresholds, which are first checked against each other (C5-R009).
    fn classify(bounds: &ChargerBounds, volts: f64, amps: f64) -> Self {
        Self {
            over_volts_warning: volts > bounds.over_volts_warning,
            over_volts_protection: volts > bounds.over_volts_protection,
            under_volts_warning: volts < bounds.under_volts_warning,
            under_volts_protection: volts < bounds.under_volts_protection,
            over_amps_warning: amps > bounds.over_amps_warning,
            over_amps_protection: amps > bounds.over_amps_protection,
            over_volts_data: bounds.over_volts_warning >= bounds.over_volts_protection,
            under_volts_data: bounds.under_volts_warning <= bounds.under_volts_protection,
            over_amps_data: bounds.over_amps_warning >= bounds.over_amps_protection,
        }
    }

    /// One of them turns the output off.
    pub fn is_protection(&self) -> bool {
        let protections =
            [self.over_volts_protection, self.under_volts_protection, self.over_amps_protection];
        let data = [self.over_volts_data, self.under_volts_data, self.over_amps_data];
        protections.into_iter().chain(data).any(|trip| trip)
    }
}

/// The charger itself.
pub(crate) fn charger(world: &mut World) {
    let plugged = world.charger.plugged;
    let by_pantograph = conducts(&world.bms.charge_2) && !plugged;
    let heard = !battery_is_lost(world);
    let bounds = world.charger.heard.bounds.filter(|_| plugged && heard);
    let mains_volts = world.charger.mains_volts;
    let charger = &mut world.charger;
    charger.communication_fault = plugged && !heard;
    charger.input_fault = plugged && mains_volts > 0.0 && !MAINS_VOLTS.contains(&mains_volts);
    charger.start_inhibited = plugged && charger.reversed;
    charger.trips = bounds
        .map(|bounds| ChargerTrips::classify(&bounds, world.pack.volts, charger.amps))
        .unwrap_or_default();
    report(charger);
    let plug_delivers = plugged && mains_volts > 0.0 && heard && !charger.trips.is_protection();
    charger.running = charger.heard.enabled && charger.severity < Stop && (plug_delivers || by_pantograph);
    let most = match (by_pantograph, charger.severity) {
        (true, _) => world.spec.battery.charge_amps,
        (false, Derate) => charger.max_amps * 0.5,
        (false, _) => charger.max_amps,
    };
    let amps = world.charger.amps;
    let order = world.charger.heard;
    let to_volts = amps + (order.volts - world.pack.terminal_volts) / pack_ohm(world);
    let wanted = order.amps.min(most).min(to_volts).max(0.0);
    let is_closed = charge_path_is_closed(world);
    let charger = &mut world.charger;
    charger.amps =
        if charger.running && is_closed { wanted.min(amps + RAMP_AMPS_PER_S * STEP_S) } else { 0.0 };
    charger.volts = if charger.running { world.pack.volts } else { 0.0 };
}

/// Lists the charger's codes and picks the one whose turn it is (BUS-R148 to R151).
fn report(charger: &mut crate::world::Charger) {
    let own = [
        (charger.hardware_fault, HARDWARE_CODE),
        (charger.input_fault, INPUT_CODE),
        (charger.start_inhibited, REVERSED_CODE),
        (charger.communication_fault, COMMUNICATION_CODE),
        (charger.over_temperature, HEAT_CODE),
    ];
    let own = own.into_iter().filter(|(present, _)| *present).map(|(_, code)| code);
    let mut codes: Vec<u8> = own.chain(charger.faults.into_iter().filter(|code| *code != 0)).collect();
    charger.severity = codes.iter().map(|code| severity_of(*code)).max().unwrap_or_default();
    codes.retain(|code| severity_of(*code) == charger.severity);
    codes.sort_unstable();
    codes.dedup();
    charger.code = charger.turn.next(&codes);
}

/// Ends charging when the current has gone down with the cells full.
fn complete(world: &mut World) {
    let full = world.bms.cell_max.value >= FULL_CELL_VOLTS - FULL_TOLERANCE_VOLTS;
    let down = world.charger.amps < TAIL_RATE * world.pack.capacity_ah;
    let bms = &mut world.bms;
    count_while(bms.charger_enabled && full && down, &mut bms.tail_ms);
    if bms.tail_ms >= TAIL_MS {
        bms.charge = Charge::Complete;
        bms.charge_interval_days = 0;
        world.pack.soc = 1.0;
    }
}

/// Counts the day on: one more if it was driven for more than an hour (BUS-R084).
fn day(world: &mut World) {
    let drives = world.bms.hv_wanted && world.bms.main.closed && !world.charger.plugged;
    let bms = &mut world.bms;
    bms.day.passed_ms += STEP_MS;
    bms.day.driven_ms += if drives { STEP_MS } else { 0 };
    if bms.day.passed_ms >= DAY_MS {
        let counts = bms.day.driven_ms > DRIVEN_DAY_MS;
        bms.charge_interval_days = (bms.charge_interval_days + u32::from(counts)).min(MOST_DAYS);
        bms.day = crate::world::Day::default();
    }
}

/// Stops everything: power-off.
pub(super) fn stop(world: &mut World) {
    let bms = &mut world.bms;
    bms.charge = Charge::Idle;
    bms.charger_enabled = false;
    bms.wanted_charge = (0.0, 0.0);
    bms.tail_ms = 0;
    bms.balancing = false;
    let charger = &mut world.charger;
    charger.running = false;
    charger.amps = 0.0;
    charger.volts = 0.0;
    charger.input_fault = false;
    charger.start_inhibited = false;
    charger.communication_fault = false;
    charger.trips = ChargerTrips::default();
    charger.severity = Severity::None;
    charger.code = 0;
    charger.turn = Turn::default();
    day(world);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::world::Day;
    use crate::{Kind, Options};

    fn next_day(driven_ms: u64, days: u32) -> u32 {
        let mut world = World::new(Kind::Citybus, Options::default());
        world.bms.charge_interval_days = days;
        world.bms.day = Day { passed_ms: DAY_MS - STEP_MS, driven_ms };
        day(&mut world);
        assert_eq!(world.bms.day, Day::default(), "a new day starts from nothing");
        world.bms.charge_interval_days
    }

    #[test]
    fn bus_r084_only_days_driven_more_than_an_hour_count() {
        assert_eq!(next_day(3_599_990, 4), 4);
        assert_eq!(next_day(3_600_000, 4), 4);
        assert_eq!(next_day(3_600_010, 4), 5);
    }

    #[test]
    fn c5_r009_each_protection_and_each_contradiction_alone_turns_the_output_off() {
        let sound = bounds(100.0, 80.0, false);
        let stops = |bounds: &ChargerBounds, volts: f64, amps: f64| {
            ChargerTrips::classify(bounds, volts, amps).is_protection()
        };
        assert!(!stops(&sound, 370.0, 85.0) && !stops(&sound, 250.0, 85.0), "warnings alone do not");
        assert!(stops(&sound, 376.0, 10.0));
        assert!(stops(&sound, 229.0, 10.0));
        assert!(stops(&sound, 330.0, 88.1));
        let over = ChargerBounds { over_volts_warning: sound.over_volts_protection, ..sound };
        let under = ChargerBounds { under_volts_warning: sound.under_volts_protection, ..sound };
        let amps = ChargerBounds { over_amps_warning: sound.over_amps_protection, ..sound };
        assert!([over, under, amps].iter().all(|bounds| stops(bounds, 330.0, 10.0)));
    }

    #[test]
    fn bus_r084_count_stops_before_the_invalid_value() {
        assert_eq!(next_day(7_200_000, 253), 254);
        assert_eq!(next_day(7_200_000, 254), 254);
    }
}
