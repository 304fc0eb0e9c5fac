//! Contactors: coils, contacts that follow late, precharge of the link, states of double-relay circuits.
//!
//! Owns every switch of the battery and the voltage of the high-voltage link. Refuses to decide whether high voltage
//! may be closed. Source: BUS-R036, BUS-R068 to R070, C5-R006.

use crate::world::{Bms, Contactor, RelayState, World};
use crate::{STEP_MS, STEP_S};

/// Contacts touch this long after the coil is driven.
const CLOSING_MS: u32 = 40;
/// Contacts part this long after the coil is released.
const OPENING_MS: u32 = 20;
/// Contacts that have not followed their coil for so long are faulty.
const MISMATCH_MS: u32 = 200;
/// Share of the pack voltage at which the link counts as precharged.
const PRECHARGED: f64 = 0.95;
/// Precharge that takes longer has failed: three time constants take 1.2 s at most.
const PRECHARGE_LIMIT_MS: u64 = 5_000;
/// Time constant of the link's bleeder in s.
const BLEED_S: f64 = 1.0;

impl Contactor {
    /// Drives or releases the coil.
    pub(super) fn drive(&mut self, on: bool) {
        if self.driven != on {
            self.driven = on;
            self.moving_ms = 0;
        }
    }

    /// Lets the contacts follow for one step.
    fn step(&mut self) {
        self.moving_ms = self.moving_ms.saturating_add(STEP_MS as u32);
        let late = if self.driven { CLOSING_MS } else { OPENING_MS };
        if self.welded {
            self.closed = true;
        } else if self.stuck_open {
            self.closed = false;
        } else if self.moving_ms >= late {
            self.closed = self.driven;
        }
    }

    /// Its contacts touch though its coil has long been released.
    pub(super) fn fails_to_open(&self) -> bool {
        self.closed && !self.driven && self.moving_ms >= MISMATCH_MS
    }

    /// Its contacts do not touch though its coil has long been driven.
    pub(super) fn fails_to_close(&self) -> bool {
        self.driven && !self.closed && self.moving_ms >= MISMATCH_MS
    }

    /// What its owner reports.
    pub fn state(&self) -> RelayState {
        match (self.welded, self.closed) {
            (true, _) => RelayState::Welded,
            (false, true) => RelayState::Closed,
            (false, false) => RelayState::Open,
        }
    }

    /// What is reported of a circuit of two relays: welded if either is, closed only if both are (BUS-R068 to R070).
    pub fn pair_state(pair: &[Self; 2]) -> RelayState {
        if pair.iter().any(|relay| relay.welded) {
            RelayState::Welded
        } else if pair.iter().all(|relay| relay.closed) {
            RelayState::Closed
        } else {
            RelayState::Open
        }
    }
}

/// Both relays of a circuit touch: it conducts.
pub(super) fn conducts(pair: &[Contactor; 2]) -> bool {
    pair.iter().all(|relay| relay.closed)
}

/// An external charge circuit is closed or about to be.
pub(super) fn charges(bms: &Bms) -> bool {
    bms.charge_1.iter().chain(&bms.charge_2).any(|relay| relay.driven)
}

/// What the coils are to do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Wish {
    /// Main contactors closed, after precharge.
    pub(super) high_voltage: bool,
    /// Charge circuit 1 (plug).
    pub(super) charge_1: bool,
    /// Charge circuit 2 (pantograph).
    pub(super) charge_2: bool,
    /// Heater.
    pub(super) heater: bool,
}

/// Drives the coils: negative and precharge first, main when the link has come up, as its voltage is told.
pub(super) fn drive(world: &mut World, wish: Wish, link_volts: Option<f64>) {
    let enough = world.pack.terminal_volts * PRECHARGED;
    let bms = &mut world.bms;
    bms.charge_1.iter_mut().for_each(|relay| relay.drive(wish.charge_1));
    bms.charge_2.iter_mut().for_each(|relay| relay.drive(wish.charge_2));
    bms.heater.iter_mut().for_each(|relay| relay.drive(wish.heater));
    bms.negative.drive(wish.high_voltage && !bms.precharge_failed);
    bms.negative_failed = wish.high_voltage && (bms.negative_failed || bms.negative.fails_to_close());
    bms.negative_failed &= !bms.negative.closed;
    if !wish.high_voltage {
        bms.precharged = false;
        bms.precharge_failed = false;
        bms.precharge_ms = 0;
        bms.precharge.drive(false);
        bms.main.drive(false);
        return;
    }
    if !bms.precharged {
        World::count(&mut bms.precharge_ms);
        bms.precharged = bms.negative.closed && link_volts.is_some_and(|volts| volts >= enough);
        bms.precharge_failed |= !bms.precharged && bms.precharge_ms >= PRECHARGE_LIMIT_MS;
    }
    bms.main.drive(bms.precharged);
    let main_has_settled = bms.main.driven && bms.main.moving_ms > CLOSING_MS;
    bms.precharge.drive(!bms.precharge_failed && !main_has_settled);
}

/// Lets every contact follow its coil, then the link the contacts; returns the current into the link through the
/// precharge resistor in A. What the last few volts take when the main contact closes is not counted.
pub(super) fn step(world: &mut World) -> f64 {
    let spec = &world.spec.battery;
    let bms = &mut world.bms;
    let pairs = bms.charge_1.iter_mut().chain(&mut bms.charge_2).chain(&mut bms.heater);
    for relay in pairs.chain([&mut bms.main, &mut bms.negative, &mut bms.precharge]) {
        relay.step();
    }
    let link_volts = &mut world.motor.link_volts;
    if bms.main.closed && bms.negative.closed {
        *link_volts = world.pack.terminal_volts;
        0.0
    } else if bms.precharge.closed && bms.negative.closed {
        let amps = (world.pack.terminal_volts - *link_volts) / spec.precharge_ohm;
        *link_volts += amps / spec.link_farad * STEP_S;
        amps
    } else {
        *link_volts -= *link_volts / BLEED_S * STEP_S;
        0.0
    }
}
