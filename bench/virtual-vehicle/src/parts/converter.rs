//! The DC/DC converter and the auxiliary battery behind it.
//!
//! The converter runs on the start command of the vehicle controller and stands by on the other (BUS-R048); a threshold
//! of 0 means its own (BUS-R047). The last command holds while none comes (V-6). The battery is a voltage that rises with its charge, and gives what the converter does
//! not.

use super::take;
use crate::STEP_S;
use crate::spec::Spec;
use crate::world::World;

/// Output per nominal volt: 27.6 V in a 24 V system.
const OUTPUT: f64 = 1.15;
/// Its own lowest input, as a share of the link's nominal voltage.
const OWN_INPUT: f64 = 0.5;
/// Its own start voltage: always, since a battery at rest is below it.
const OWN_START: f64 = 1.125;
/// Power out per power in.
const EFFICIENCY: f64 = 0.92;
/// Resistance of the auxiliary battery in ohm per nominal volt.
const OHM: f64 = 0.000_6;
/// Voltage at rest per nominal volt: empty, and how much more when full.
const REST: (f64, f64) = (0.98, 0.09);
/// Current that charges the auxiliary battery at most, per Ah.
const CHARGE_PER_AH: f64 = 0.2;

/// Puts the auxiliary battery at rest.
pub(super) fn rest(world: &mut World, spec: &Spec) {
    world.supply.volts = rest_volts(world, spec);
}

fn rest_volts(world: &World, spec: &Spec) -> f64 {
    spec.low_volts * (REST.0 + REST.1 * world.supply.charge)
}

/// Lets converter and battery share the load.
pub(super) fn step(world: &mut World, spec: &Spec) {
    let own = |threshold: f64, own: f64| if threshold > 0.0 { threshold } else { own };
    let command = world.parts_heard.converter;
    let lowest_input = own(command.lowest_input, OWN_INPUT * spec.link_volts);
    let start = own(command.start_volts, OWN_START * spec.low_volts);
    let dcdc = &mut world.dcdc;
    let may = command.run && dcdc.precharged && dcdc.fault_code == 0 && dcdc.input_volts >= lowest_input;
    dcdc.running = may && (dcdc.running || world.supply.volts < start);

    let rest = rest_volts(world, spec);
    let ohm = OHM * spec.low_volts;
    let watts = if world.is_awake() { spec.low_watts } else { 2.0 };
    let load = watts / world.supply.volts.max(0.5 * spec.low_volts);
    let output = OUTPUT * spec.low_volts;
    // Positive = out of the auxiliary battery.
    let (volts, battery) = match world.dcdc.running {
        true => (output, -((output - rest) / (4.0 * ohm)).clamp(0.0, CHARGE_PER_AH * spec.low_ah)),
        false => (rest - ohm * load, load),
    };
    world.supply.charge = (world.supply.charge - battery * STEP_S / (3_600.0 * spec.low_ah)).clamp(0.0, 1.0);
    world.supply.load_amps = load;
    world.supply.volts = world.supply.volts_override.unwrap_or(volts);
    let dcdc = &mut world.dcdc;
    dcdc.output_amps = if dcdc.running { load - battery } else { 0.0 };
    dcdc.output_volts = volts;
    take(dcdc, dcdc.output_amps * output / EFFICIENCY);
}
