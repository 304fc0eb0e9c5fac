//! Battery of each vehicle: one row of sizes per vehicle.

use crate::Kind;

/// Sizes of a battery and of the charger on board.
pub(super) struct Spec {
    /// Cells in series.
    pub(super) cells: u16,
    /// Temperature probes.
    pub(super) probes: u16,
    /// Rated capacity in Ah.
    pub(super) capacity_ah: f64,
    /// Resistance of one cell in ohm.
    pub(super) cell_ohm: f64,
    /// Heat capacity of the whole pack in J/K.
    pub(super) joules_per_kelvin: f64,
    /// Heat lost to the air in W per kelvin.
    pub(super) watts_per_kelvin: f64,
    /// Heater in the pack in W.
    pub(super) heater_watts: f64,
    /// Largest discharge current in A.
    pub(super) discharge_amps: f64,
    /// Largest charge current in A, regeneration included.
    pub(super) charge_amps: f64,
    /// Capacitors of the high-voltage link in F.
    pub(super) link_farad: f64,
    /// Precharge resistor in ohm.
    pub(super) precharge_ohm: f64,
    /// Largest current of the charger in A.
    pub(super) charger_amps: f64,
    /// External charging goes through relays of its own and not through the main contactor.
    pub(super) own_charge_relays: bool,
}

const BUS: Spec = Spec {
    cells: 168,
    probes: 24,
    capacity_ah: 300.0,
    cell_ohm: 0.000_4,
    joules_per_kelvin: 2.0e6,
    watts_per_kelvin: 60.0,
    heater_watts: 4_000.0,
    discharge_amps: 400.0,
    charge_amps: 200.0,
    link_farad: 0.004,
    precharge_ohm: 100.0,
    charger_amps: 100.0,
    own_charge_relays: true,
};

const JIULONG: Spec = Spec {
    cells: 100,
    probes: 21,
    capacity_ah: 200.0,
    cell_ohm: 0.000_6,
    joules_per_kelvin: 0.8e6,
    watts_per_kelvin: 25.0,
    heater_watts: 1_500.0,
    discharge_amps: 300.0,
    charge_amps: 120.0,
    link_farad: 0.002,
    precharge_ohm: 100.0,
    charger_amps: 20.0,
    own_charge_relays: false,
};

const C5EV: Spec = Spec {
    cells: 100,
    probes: 16,
    capacity_ah: 60.0,
    cell_ohm: 0.001,
    joules_per_kelvin: 0.4e6,
    watts_per_kelvin: 15.0,
    heater_watts: 600.0,
    discharge_amps: 200.0,
    charge_amps: 80.0,
    link_farad: 0.001,
    precharge_ohm: 150.0,
    charger_amps: 10.0,
    own_charge_relays: false,
};

/// Returns the sizes of a vehicle.
pub(super) const fn spec(kind: Kind) -> &'static Spec {
    match kind {
        Kind::Citybus => &BUS,
        Kind::Jiulong => &JIULONG,
        Kind::C5ev => &C5EV,
    }
}
