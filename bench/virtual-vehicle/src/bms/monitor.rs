//! Walks the fault table: hysteresis, what is left of the allowance, the code that is sent, the request to open.
//!
//! One engine for all three tables. Refuses to know a fault by its number. Source: BUS-R065, R066, R073 to R079, R085 to
//! R117; BUS-32 (only codes of the highest level), BUS-33 (each for 1 s), BUS-68 (5 s is the vehicle's, 35 s ours).

use super::limits::{self, Allowed};
use crate::STEP_MS;
use crate::fault::{Quantity, Request, When, round};
use crate::world::{ActiveFault, Key, Turn, World};
use protocol_core::model::Severity;

/// Each of several codes is sent for so long (BUS-33).
const TURN_MS: u64 = 1_000;
/// The battery opens high voltage itself when the vehicle has not done so (BUS-R076, R078).
const HV_OFF_FALLBACK_MS: u64 = 35_000;
/// Below it the cold thresholds hold; printed nowhere (BUS-78), the freezing point as for charging.
const COLD_CELSIUS: f64 = 0.0;
/// A state of charge that changes by more in one step has jumped; no current does that.
const SOC_JUMP: f64 = 0.05;
/// A jump is told for so long.
const SOC_JUMP_MS: u64 = 10_000;
/// More than any threshold in percent: current where none is allowed.
const BEYOND_PERCENT: f64 = 1_000.0;

impl Turn {
    /// Returns the code to send now: each of `codes` in order, again and again; 0 if there is none.
    pub(super) fn next(&mut self, codes: &[u8]) -> u8 {
        self.held_ms += STEP_MS;
        let place = codes.iter().position(|code| *code == self.code);
        let code = match place {
            Some(_) if self.held_ms < TURN_MS => return self.code,
            Some(place) => codes[(place + 1) % codes.len()],
            None => codes.first().copied().unwrap_or(0),
        };
        *self = Self { code, held_ms: 0 };
        code
    }
}

fn is_charging(world: &World) -> bool {
    world.charger.plugged || world.charger.pantograph
}

fn is_cold(world: &World) -> bool {
    world.bms.cold.value < COLD_CELSIUS
}

fn percent(amps: f64, allowance: f64) -> f64 {
    match (amps > 0.0, allowance > 0.0) {
        (false, _) => 0.0,
        (true, true) => amps / allowance * 100.0,
        (true, false) => BEYOND_PERCENT,
    }
}

fn measure(world: &World, of: Quantity) -> f64 {
    let (bms, pack) = (&world.bms, &world.pack);
    let flag = |flag: bool| f64::from(u8::from(flag));
    round(match of {
        Quantity::CellMax => bms.cell_max.value,
        Quantity::CellMin => bms.cell_min.value,
        Quantity::CellSpread => bms.cell_max.value - bms.cell_min.value,
        Quantity::PackVolts => pack.volts,
        Quantity::Hot => bms.hot.value,
        Quantity::Cold => bms.cold.value,
        Quantity::HeatSpread => bms.hot.value - bms.cold.value,
        Quantity::Soc => world.counted_soc() * 100.0,
        Quantity::DischargePercent => {
            limits::obeyed(world).map_or(0.0, |limits| percent(pack.amps, limits.discharge_amps))
        }
        Quantity::ChargePercent => {
            limits::obeyed(world).map_or(0.0, |limits| percent(-pack.amps, limits.charge_amps))
        }
        Quantity::OhmPerVolt => {
            let kiloohm = world.insulation.positive_kiloohm.min(world.insulation.negative_kiloohm);
            kiloohm * 1_000.0 / pack.volts.max(1.0)
        }
        Quantity::Supply => world.supply.volts_override.unwrap_or(world.supply.volts),
        Quantity::Socket => bms.defects.socket_celsius.unwrap_or(world.road.celsius),
        Quantity::VcuSilence => bms.vcu_silence_ms as f64,
        Quantity::MainContactor => {
            flag(bms.defects.main_contactor || bms.main.fails_to_open() || bms.main.fails_to_close())
        }
        Quantity::MainWelded => flag(bms.main.fails_to_open()),
        Quantity::MainStuck => flag(bms.main.fails_to_close()),
        Quantity::NegativeWelded => flag(bms.negative.fails_to_open()),
        Quantity::NegativeStuck => flag(bms.negative_failed),
        Quantity::InternalBus => flag(bms.defects.internal_bus),
        Quantity::Interlock => flag(bms.defects.interlock_open),
        Quantity::CurrentSensor => flag(bms.defects.current_sensor),
        Quantity::Smoke => flag(bms.defects.smoke),
        Quantity::SmokeDetector => flag(bms.defects.smoke_detector),
        Quantity::NegativeCut => flag(bms.defects.negative_cut),
        Quantity::SocJump => flag(bms.soc_jump_ms > 0),
        Quantity::ChargerMismatch => flag(world.charger.mismatched),
    })
}

/// Watches the charge counter for jumps.
fn watch_soc(world: &mut World) {
    let soc = world.counted_soc();
    let bms = &mut world.bms;
    let jumped = bms.soc_before.is_some_and(|before| (soc - before).abs() > SOC_JUMP);
    bms.soc_jump_ms = if jumped { SOC_JUMP_MS } else { bms.soc_jump_ms.saturating_sub(STEP_MS) };
    bms.soc_before = Some(soc);
}

/// Walks the table; returns what the active rows leave.
pub(super) fn step(world: &mut World) -> Allowed {
    watch_soc(world);
    let rows = world.spec.faults;
    let cells = world.pack.cell_volts.len();
    let (charging, cold) = (is_charging(world), is_cold(world));
    let driving = !charging && world.driver.key >= Key::On;
    world.bms.raised.resize(rows.len(), false);
    for (index, row) in rows.iter().enumerate() {
        let monitored = match row.when {
            When::Always => true,
            When::Driving => driving,
            When::Charging => charging,
        };
        let (set, clear) = row.cold.filter(|_| cold).unwrap_or((row.set, row.clear));
        let value = measure(world, row.of);
        let raised = world.bms.raised[index];
        world.bms.raised[index] =
            monitored && if raised { !clear.is_met(value, cells) } else { set.is_met(value, cells) };
    }
    report(world);
    allow(world, driving)
}

/// Lists active faults, worst first, and picks the code whose turn it is.
fn report(world: &mut World) {
    let rows = world.spec.faults;
    let spec = world.spec;
    let apart = |code: u8| spec.apart == Some(code);
    let bms = &mut world.bms;
    bms.active = rows
        .iter()
        .enumerate()
        .filter(|(row, _)| bms.raised[*row])
        .map(|(row, fault)| ActiveFault { row, severity: fault.severity, code: fault.code })
        .collect();
    bms.active.sort_by_key(|fault| (std::cmp::Reverse(fault.severity), fault.row));
    let worst =
        |of: &mut dyn Iterator<Item = &ActiveFault>| of.map(|fault| fault.severity).max().unwrap_or_default();
    bms.severity = worst(&mut bms.active.iter().filter(|fault| !apart(fault.code)));
    bms.insulation_severity = worst(&mut bms.active.iter().filter(|fault| apart(fault.code)));
    let codes: Vec<u8> = bms
        .active
        .iter()
        .filter(|fault| fault.severity == bms.severity && fault.code != 0)
        .map(|fault| fault.code)
        .collect();
    bms.code = bms.turn.next(&codes);
    bms.fire |= spec.fire_code.is_some_and(|fire| bms.active.iter().any(|fault| fault.code == fire));
}

/// Sums up what rows do: of the levels of one fault the strictest acts, different faults each take their share.
fn allow(world: &mut World, driving: bool) -> Allowed {
    let rows = world.spec.faults;
    let bms = &mut world.bms;
    let mut allowed = Allowed::default();
    bms.forbids_charging = false;
    bms.requests_stop = false;
    bms.forbids_closing = false;
    for (place, active) in bms.active.iter().enumerate() {
        let row = &rows[active.row];
        allowed.limp |= row.does.request == Request::Limp && driving;
        bms.forbids_charging |= row.does.forbids_charging;
        bms.requests_stop |= row.does.request == Request::Stop;
        bms.forbids_closing |= row.does.stays_open;
        let same = |other: &&ActiveFault| rows[other.row].fault == row.fault;
        if bms.active[..place].iter().any(|other| same(&other)) {
            continue;
        }
        let levels = || bms.active.iter().filter(same).map(|other| rows[other.row].does);
        let charge = levels().map(|does| does.charge).fold(1.0, f64::min);
        let discharge = levels().map(|does| does.discharge).fold(1.0, f64::min);
        if matches!(row.of, Quantity::ChargePercent | Quantity::DischargePercent) {
            allowed.over_limit.0 *= charge;
            allowed.over_limit.1 *= discharge;
        } else {
            allowed.charge *= charge;
            allowed.discharge *= discharge;
        }
    }
    bms.limp = allowed.limp;
    allowed
}

/// Asks the vehicle to open high voltage on an extreme fault, until it is open; opens it after the fallback.
///
/// Once open it stays so until power-off, whoever opened it: what comes back would be asked to open again at once.
pub(super) fn hv_off(world: &mut World) {
    let cold = is_cold(world);
    let extreme = world.spec.extremes.iter().any(|row| {
        let edge = if cold { row.cold } else { row.set };
        edge.is_met(measure(world, row.of), world.pack.cell_volts.len())
    });
    let bms = &mut world.bms;
    let was_requested = bms.hv_off_request;
    let asked_and_open = was_requested && !bms.main.driven && !super::contactors::charges(bms);
    bms.isolated |= asked_and_open;
    bms.hv_off_request = extreme || bms.fire || (was_requested && !asked_and_open);
    super::count_while(was_requested && bms.hv_off_request, &mut bms.hv_off_ms);
    bms.isolated |= bms.hv_off_request && bms.hv_off_ms >= HV_OFF_FALLBACK_MS;
}

/// Forgets every fault: power-off.
pub(super) fn forget(world: &mut World) {
    let bms = &mut world.bms;
    bms.raised.clear();
    bms.active.clear();
    bms.sent_limits = [None; 2];
    bms.soc_before = None;
    bms.soc_jump_ms = 0;
    bms.turn = Turn::default();
    bms.severity = Severity::None;
    bms.insulation_severity = Severity::None;
    bms.code = 0;
    bms.fire = false;
    bms.limp = false;
    bms.forbids_charging = false;
    bms.requests_stop = false;
    bms.forbids_closing = false;
    bms.isolated = false;
    bms.hv_off_request = false;
    bms.hv_off_ms = 0;
    bms.hv_wanted = false;
}
