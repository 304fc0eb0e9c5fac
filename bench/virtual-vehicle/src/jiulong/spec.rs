//! The vans and buses E66 to E10 as figures.
//!
//! The document prints none of them but the switches of behaviour: they are what vehicles of this class have.

use super::faults;
use crate::spec::{Battery, Spec};
use protocol_core::states::Gear;

/// The vehicle.
pub(super) static SPEC: Spec = Spec {
    mass_kg: 4_000.0,
    rotating: 1.05,
    drag: 1.2,
    rolling: 0.010,
    wheel_m: 0.35,
    ratio: 8.0,
    max_nm: 350.0,
    max_watts: 80_000.0,
    regeneration_watts: 50_000.0,
    idle_watts: 150.0,
    top_kmh: 100.0,
    top_reverse_kmh: 20.0,
    brake_newton: 28_000.0,
    coast: 0.5,
    limp_watts: 18_000.0,
    link_volts: 320.0,
    low_volts: 12.0,
    low_watts: 350.0,
    low_ah: 100.0,
    steering_watts: 600.0,
    compressor_watts: 500.0,
    hvac_watts: 3_500.0,
    cabin: 120_000.0,
    joules_per_metre: 1_000.0,
    gears: &[Gear::N, Gear::D, Gear::R],
    has_air: true,
    has_vacuum: true,
    has_buzzer: false,
    forwards_battery: false,
    serves_charging: false,
    // JL-R010: an ordinary fault drives on at limited speed.
    derated_top: 0.4,
    cells_per_box: 10,
    protections: [4, 16, 17],
    battery: Battery {
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
        measures_link: true,
        bounds_the_charger: false,
    },
    faults: faults::ROWS,
    extremes: &[],
    fire_code: None,
    apart: Some(faults::INSULATION_BIT),
};
