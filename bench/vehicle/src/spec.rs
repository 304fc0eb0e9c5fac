//! The three vehicles as figures: one row each.
//!
//! Masses, forces, powers and voltages that physics and the vehicle controller need. The documents print none of them:
//! they are what vehicles of these classes have. The cells are the battery's own table.

use crate::Kind;
use crate::world::Gear;

/// Figures of one vehicle.
pub(crate) struct Spec {
    /// Mass with some passengers, in kg.
    pub(crate) mass_kg: f64,
    /// Mass that rotating parts add when speed changes, as a factor.
    pub(crate) rotating: f64,
    /// Air resistance in N per (m/s)^2: half the density of air by drag coefficient by frontal area.
    pub(crate) drag: f64,
    /// Coefficient of rolling resistance.
    pub(crate) rolling: f64,
    /// Radius of the wheel in m.
    pub(crate) wheel_m: f64,
    /// Motor revolutions per revolution of the wheel.
    pub(crate) ratio: f64,
    /// Largest torque of the motor in Nm.
    pub(crate) max_nm: f64,
    /// Largest electrical power of the motor in W.
    pub(crate) max_watts: f64,
    /// Largest electrical power of regeneration in W.
    pub(crate) regeneration_watts: f64,
    /// Power of motor controller and excitation while it is enabled, in W.
    pub(crate) idle_watts: f64,
    /// Speed at which the vehicle controller takes the torque back, in km/h.
    pub(crate) top_kmh: f64,
    /// The same in reverse.
    pub(crate) top_reverse_kmh: f64,
    /// Force of the friction brakes at a full pedal, in N.
    pub(crate) brake_newton: f64,
    /// Deceleration with both pedals released, in m/s^2.
    pub(crate) coast: f64,
    /// Power in limp mode in W (BUS-R080).
    pub(crate) limp_watts: f64,
    /// Nominal voltage of the high-voltage link.
    pub(crate) link_volts: f64,
    /// Nominal voltage of the low-voltage system, 12 or 24.
    pub(crate) low_volts: f64,
    /// Low-voltage loads with the key on, in W.
    pub(crate) low_watts: f64,
    /// Capacity of the auxiliary battery in Ah.
    pub(crate) low_ah: f64,
    /// Largest power of the steering pump in W.
    pub(crate) steering_watts: f64,
    /// Power of the air compressor (jiulong: of the vacuum and air pump) in W; 0 = has none.
    pub(crate) compressor_watts: f64,
    /// Cooling or heating power of the air conditioning, taken from the link, in W.
    pub(crate) hvac_watts: f64,
    /// Heat that it takes to warm the cabin by one degree, in J/K.
    pub(crate) cabin: f64,
    /// Consumption that the range starts from, in J/m.
    pub(crate) joules_per_metre: f64,
    /// What the lever has, in the order of [`Gear`]'s words on the page.
    pub(crate) gears: &'static [Gear],
}

impl Spec {
    /// Largest speed of the motor in rpm: a tenth above the vehicle's top speed.
    pub(crate) fn overspeed_rpm(&self) -> f64 {
        1.1 * self.rpm(self.top_kmh / 3.6)
    }

    /// Motor speed in rpm at a speed in m/s.
    pub(crate) fn rpm(&self, metres_per_s: f64) -> f64 {
        self.omega(metres_per_s) * 30.0 / std::f64::consts::PI
    }

    /// Motor speed in rad/s at a speed in m/s.
    pub(crate) fn omega(&self, metres_per_s: f64) -> f64 {
        metres_per_s * self.ratio / self.wheel_m
    }

    /// Force at the wheels in N from a torque of the motor in Nm.
    pub(crate) fn newton(&self, nm: f64) -> f64 {
        nm * self.ratio / self.wheel_m
    }

    /// Torque of the motor in Nm for a force at the wheels in N.
    pub(crate) fn nm(&self, newton: f64) -> f64 {
        newton * self.wheel_m / self.ratio
    }

    /// Share of the mechanical power that becomes heat.
    pub(crate) const LOSS: f64 = 0.06;

    /// Heat of the windings in W at a torque in Nm, turning or not.
    pub(crate) fn copper_watts(&self, nm: f64) -> f64 {
        let share = nm / self.max_nm;
        0.02 * self.max_watts * share * share
    }

    /// Torque in Nm with which the motor takes no more than `watts` at `omega` in rad/s; never negative.
    pub(crate) fn driving_nm(&self, watts: f64, omega: f64) -> f64 {
        let turning = (1.0 + Self::LOSS) * omega.max(0.0);
        let within = |watts: f64| match turning {
            turning if turning * self.max_nm <= watts => self.max_nm,
            turning => watts.max(0.0) / turning,
        };
        // Two steps: the copper loss of the first, larger torque leaves the second on the safe side.
        let first = within(watts - self.idle_watts);
        within(watts - self.idle_watts - self.copper_watts(first))
    }

    /// Torque in Nm, positive, with which the motor gives back no more than `watts` at `omega` in rad/s.
    pub(crate) fn regeneration_nm(&self, watts: f64, omega: f64) -> f64 {
        let turning = (1.0 - Self::LOSS) * omega.max(0.0);
        if turning * self.max_nm <= watts { self.max_nm } else { watts.max(0.0) / turning }
    }
}

/// Returns the figures of a vehicle.
pub(crate) fn of(kind: Kind) -> &'static Spec {
    match kind {
        Kind::Citybus => &BUS,
        Kind::Jiulong => &JIULONG,
        Kind::C5ev => &C5EV,
    }
}

const BUS: Spec = Spec {
    mass_kg: 13_000.0,
    rotating: 1.05,
    drag: 2.9,
    rolling: 0.008,
    wheel_m: 0.48,
    ratio: 5.5,
    max_nm: 2_500.0,
    max_watts: 150_000.0,
    regeneration_watts: 110_000.0,
    idle_watts: 300.0,
    top_kmh: 80.0,
    top_reverse_kmh: 15.0,
    brake_newton: 78_000.0,
    coast: 0.4,
    limp_watts: 30_000.0,
    link_volts: 540.0,
    low_volts: 24.0,
    low_watts: 900.0,
    low_ah: 180.0,
    steering_watts: 2_200.0,
    compressor_watts: 3_000.0,
    hvac_watts: 9_000.0,
    cabin: 400_000.0,
    joules_per_metre: 3_200.0,
    gears: &[Gear::N, Gear::D, Gear::R],
};

const JIULONG: Spec = Spec {
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
};

const C5EV: Spec = Spec {
    mass_kg: 1_200.0,
    rotating: 1.05,
    drag: 0.42,
    rolling: 0.011,
    wheel_m: 0.29,
    ratio: 8.3,
    max_nm: 160.0,
    max_watts: 45_000.0,
    regeneration_watts: 20_000.0,
    idle_watts: 80.0,
    top_kmh: 120.0,
    top_reverse_kmh: 20.0,
    brake_newton: 9_600.0,
    coast: 0.6,
    limp_watts: 10_000.0,
    link_volts: 320.0,
    low_volts: 12.0,
    low_watts: 220.0,
    low_ah: 45.0,
    steering_watts: 250.0,
    compressor_watts: 0.0,
    hvac_watts: 1_800.0,
    cabin: 60_000.0,
    joules_per_metre: 420.0,
    gears: &[Gear::N, Gear::D, Gear::R, Gear::P],
};
