//! The cells: open-circuit voltage, resistance, charge, heat, and what the sensors make of it.
//!
//! A series string of lithium iron phosphate cells. Owns the one current of the pack: constant-power loads, charger and
//! precharge solved against the string's resistance. Refuses to judge what it finds.
//! Not supported: polarisation, ageing, self-discharge.

use crate::STEP_S;
use crate::spec::Battery;
use crate::world::{Extreme, World};

/// Open-circuit voltage of a cell over its state of charge, beyond both ends where cells may be forced.
const OPEN_CIRCUIT: &[(f64, f64)] = &[
    (-0.05, 1.80),
    (0.00, 2.60),
    (0.02, 2.90),
    (0.05, 3.06),
    (0.10, 3.17),
    (0.20, 3.225),
    (0.30, 3.26),
    (0.40, 3.285),
    (0.50, 3.295),
    (0.60, 3.31),
    (0.70, 3.325),
    (0.80, 3.33),
    (0.90, 3.335),
    (0.96, 3.345),
    (0.985, 3.38),
    (1.00, 3.45),
    (1.01, 3.60),
    (1.05, 4.20),
];
/// Largest distance of a cell's state of charge from the mean.
const SOC_SPREAD: f64 = 0.004;
/// Share by which resistance and cooling differ between cells.
const SPREAD: f64 = 0.05;
/// State of charge in which a vehicle is handed over.
const SOC_AT_START: f64 = 0.80;
/// A cell is bled down to its neighbours with this current.
const BALANCING_AMPS: f64 = 0.2;
/// Cells further above the lowest than this are bled.
const BALANCING_VOLTS: f64 = 0.010;
/// Balancing starts only where the voltage says something about the charge.
const BALANCING_FROM_VOLTS: f64 = 3.38;

/// Reads a table of points by straight lines; beyond its ends the end value holds.
pub(super) fn along(points: &[(f64, f64)], x: f64) -> f64 {
    let Some(&(first_x, first_y)) = points.first() else { return 0.0 };
    if x <= first_x {
        return first_y;
    }
    points
        .windows(2)
        .find(|pair| x <= pair[1].0)
        .map(|pair| pair[0].1 + (x - pair[0].0) / (pair[1].0 - pair[0].0) * (pair[1].1 - pair[0].1))
        .unwrap_or_else(|| points[points.len() - 1].1)
}

/// Numbers that look drawn, the same for the same seed: the SplitMix64 sequence.
struct Draw(u64);

impl Draw {
    /// Returns the next number from -1 to 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((mixed ^ (mixed >> 31)) >> 40) as f64 / f64::from(1 << 23) - 1.0
    }
}

/// Builds the string in the size of the vehicle or of its options.
pub(super) fn build(world: &mut World) {
    let spec = &world.spec.battery;
    let count = |chosen: u16, usual: u16| usize::from(if chosen == 0 { usual } else { chosen });
    let (cells, probes) = (count(world.options.cells, spec.cells), count(world.options.probes, spec.probes));
    let mut draw = Draw(world.options.seed);
    let pack = &mut world.pack;
    pack.capacity_ah = spec.capacity_ah;
    pack.cell_soc = (0..cells).map(|_| draw.next() * SOC_SPREAD).collect();
    pack.cell_ohm = (0..cells).map(|_| spec.cell_ohm * (1.0 + draw.next() * SPREAD)).collect();
    pack.cell_volts = vec![0.0; cells];
    pack.inner_celsius = (0..probes).map(|_| world.road.celsius + draw.next()).collect();
    pack.probe_celsius = pack.inner_celsius.clone();
    set_soc(world, SOC_AT_START);
    rest(world);
}

/// Puts every cell to a state of charge, 0 to 1, and keeps the distances between them.
pub(super) fn set_soc(world: &mut World, soc: f64) {
    let pack = &mut world.pack;
    let mean = mean(&pack.cell_soc);
    for cell in &mut pack.cell_soc {
        *cell += soc - mean;
    }
    pack.soc = soc;
    // Other cells, not a counter that has jumped.
    world.bms.soc_before = None;
}

/// Cell voltages without current.
fn rest(world: &mut World) {
    let pack = &mut world.pack;
    for (volts, soc) in pack.cell_volts.iter_mut().zip(&pack.cell_soc) {
        *volts = along(OPEN_CIRCUIT, *soc);
    }
    pack.terminal_volts = pack.cell_volts.iter().sum();
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// What pulls at the string in one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Load {
    /// Constant power of all consumers in W; regeneration is negative.
    pub(super) watts: f64,
    /// Current out of the string whatever its voltage, in A: precharge less charger.
    pub(super) amps: f64,
    /// Part of the consumed power that warms the cells, in W.
    pub(super) heater_watts: f64,
}

/// Solves the current of a string of open-circuit voltage `volts` and resistance `ohm`; more than it can give is cut.
fn solve(volts: f64, ohm: f64, load: Load) -> f64 {
    // (volts - i ohm) (i - load.amps) = load.watts
    let b = volts + ohm * load.amps;
    let c = load.watts + volts * load.amps;
    let inside = b * b - 4.0 * ohm * c;
    if inside <= 0.0 { b / (2.0 * ohm) } else { (b - inside.sqrt()) / (2.0 * ohm) }
}

/// Lets the load act for one step.
pub(super) fn step(world: &mut World, load: Load) {
    let spec = &world.spec.battery;
    rest(world);
    let air = world.road.celsius;
    let balancing = world.bms.balancing;
    let pack = &mut world.pack;
    let lowest = pack.cell_volts.iter().copied().fold(f64::MAX, f64::min);
    let ohm: f64 = pack.cell_ohm.iter().sum();
    let amps = solve(pack.terminal_volts, ohm, load);
    let drawn = STEP_S / (3_600.0 * pack.capacity_ah);
    for ((volts, ohm), soc) in pack.cell_volts.iter_mut().zip(&pack.cell_ohm).zip(&mut pack.cell_soc) {
        let bled = if balancing && *volts > lowest + BALANCING_VOLTS { BALANCING_AMPS } else { 0.0 };
        *volts -= amps * ohm;
        *soc = (*soc - (amps + bled) * drawn).clamp(-0.05, 1.05);
    }
    pack.terminal_amps = amps;
    pack.terminal_volts = pack.cell_volts.iter().sum();
    let joules = pack.terminal_volts * amps * STEP_S;
    if joules >= 0.0 {
        pack.joules_out += joules;
    } else {
        pack.joules_in -= joules;
    }
    warm(&mut world.pack, spec, amps * amps * ohm + load.heater_watts, air);
}

fn warm(pack: &mut crate::world::Pack, spec: &Battery, watts: f64, air: f64) {
    let count = pack.inner_celsius.len().max(1) as f64;
    for (index, probe) in pack.inner_celsius.iter_mut().enumerate() {
        // The middle of a box cools worse than its edge.
        let place = 1.0 + SPREAD * (2.0 * index as f64 / count - 1.0);
        *probe += (watts - spec.watts_per_kelvin * place * (*probe - air)) / spec.joules_per_kelvin * STEP_S;
    }
}

/// Lets the sensors look: what a person has set covers what is.
pub(super) fn measure(world: &mut World) {
    let sensor_dead = world.bms.defects.current_sensor;
    let pack = &mut world.pack;
    let forced = (pack.highest_volts_override, pack.lowest_volts_override);
    world.bms.cell_max = force(&mut pack.cell_volts, forced.0, f64::min, |a, b| a > b);
    world.bms.cell_min = force(&mut pack.cell_volts, forced.1, f64::max, |a, b| a < b);
    pack.probe_celsius.clone_from(&pack.inner_celsius);
    world.bms.hot = force(&mut pack.probe_celsius, pack.hottest_override, f64::min, |a, b| a > b);
    world.bms.cold = force(&mut pack.probe_celsius, pack.coldest_override, f64::max, |a, b| a < b);
    // Forcing the low end may have moved the high one.
    world.bms.cell_max = extreme(&pack.cell_volts, |a, b| a > b);
    world.bms.hot = extreme(&pack.probe_celsius, |a, b| a > b);

    pack.volts = pack.volts_override.unwrap_or(pack.terminal_volts);
    pack.amps = pack.amps_override.unwrap_or(if sensor_dead { 0.0 } else { pack.terminal_amps });
    pack.soc = (pack.soc - pack.amps * STEP_S / (3_600.0 * pack.capacity_ah)).clamp(0.0, 1.0);
    world.bms.balancing = world.bms.charge == crate::world::Charge::Charging
        && world.bms.cell_max.value > BALANCING_FROM_VOLTS
        && world.bms.cell_max.value - world.bms.cell_min.value > BALANCING_VOLTS;
}

/// Puts the outermost value to what is forced and keeps the others inside it.
fn force(
    values: &mut [f64],
    forced: Option<f64>,
    keep: fn(f64, f64) -> f64,
    further: fn(f64, f64) -> bool,
) -> Extreme {
    let mut outermost = extreme(values, further);
    if let Some(forced) = forced {
        for value in values.iter_mut() {
            *value = keep(*value, forced);
        }
        if let Some(value) = values.get_mut(outermost.index) {
            *value = forced;
        }
        outermost.value = forced;
    }
    outermost
}

fn extreme(values: &[f64], further: fn(f64, f64) -> bool) -> Extreme {
    let start = Extreme { value: values.first().copied().unwrap_or_default(), index: 0 };
    values.iter().enumerate().fold(start, |worst, (index, &value)| {
        if further(value, worst.value) { Extreme { value, index } } else { worst }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn current_of_a_constant_power_load_matches_terminal_power() {
        let amps = solve(540.0, 0.07, Load { watts: 100_000.0, ..Load::default() });
        assert!(((540.0 - amps * 0.07) * amps - 100_000.0).abs() < 1e-6);
        let charging = solve(540.0, 0.07, Load { amps: -50.0, ..Load::default() });
        assert!((charging + 50.0).abs() < 1e-9, "{charging}");
    }

    #[test]
    fn a_load_beyond_the_string_draws_its_largest_power() {
        let amps = solve(540.0, 0.07, Load { watts: 1e9, ..Load::default() });
        assert!((amps - 540.0 / 0.14).abs() < 1e-9);
    }

    #[test]
    fn table_between_its_points_and_beyond_its_ends() {
        let points = [(0.0, 1.0), (2.0, 5.0)];
        assert_eq!([along(&points, -1.0), along(&points, 0.5), along(&points, 9.0)], [1.0, 2.0, 5.0]);
    }
}
