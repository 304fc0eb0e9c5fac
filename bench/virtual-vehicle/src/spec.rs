//! A vehicle as figures: masses, forces, powers, voltages, its battery, and which of the common behaviours it has.
//!
//! What physics and controllers need; the figures are each vehicle's `spec`.

use crate::fault::{ExtremeRow, Row};
use protocol_core::states::Gear;

/// Figures of one vehicle.
#[derive(Debug, PartialEq)]
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
    /// Brakes by air.
    pub(crate) has_air: bool,
    /// Has a brake vacuum that its pump holds, too.
    pub(crate) has_vacuum: bool,
    /// The vehicle controller sounds a buzzer in the cluster (C5-R014).
    pub(crate) has_buzzer: bool,
    /// The vehicle controller forwards the battery's codes with its own (BUS-R072).
    pub(crate) forwards_battery: bool,
    /// High voltage is asked for while it charges, for converter and air conditioning (BUS-R030).
    pub(crate) serves_charging: bool,
    /// Share of the top speed that an ordinary fault leaves.
    pub(crate) derated_top: f64,
    /// Cells in one box of the battery.
    pub(crate) cells_per_box: usize,
    /// Protection bits of a winding and a controller that are too hot and of a motor that is too fast.
    pub(crate) protections: [u32; 3],
    /// The battery and the charger on board.
    pub(crate) battery: Battery,
    /// Fault table of the battery controller.
    pub(crate) faults: &'static [Row],
    /// Faults on which it asks for high voltage to be opened.
    pub(crate) extremes: &'static [ExtremeRow],
    /// Code of the fire alarm.
    pub(crate) fire_code: Option<u8>,
    /// Code of the fault whose severity is reported apart.
    pub(crate) apart: Option<u8>,
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

/// Sizes of a battery and of the charger on board.
#[derive(Debug, PartialEq)]
pub(crate) struct Battery {
    /// Cells in series.
    pub(crate) cells: u16,
    /// Temperature probes.
    pub(crate) probes: u16,
    /// Rated capacity in Ah.
    pub(crate) capacity_ah: f64,
    /// Resistance of one cell in ohm.
    pub(crate) cell_ohm: f64,
    /// Heat capacity of the whole pack in J/K.
    pub(crate) joules_per_kelvin: f64,
    /// Heat lost to the air in W per kelvin.
    pub(crate) watts_per_kelvin: f64,
    /// Heater in the pack in W.
    pub(crate) heater_watts: f64,
    /// Largest discharge current in A.
    pub(crate) discharge_amps: f64,
    /// Largest charge current in A, regeneration included.
    pub(crate) charge_amps: f64,
    /// Capacitors of the high-voltage link in F.
    pub(crate) link_farad: f64,
    /// Precharge resistor in ohm.
    pub(crate) precharge_ohm: f64,
    /// Largest current of the charger in A.
    pub(crate) charger_amps: f64,
    /// External charging goes through relays of its own and not through the main contactor.
    pub(crate) own_charge_relays: bool,
    /// Measures the voltage of the link itself; else it is told by the vehicle controller (BUS-R036).
    pub(crate) measures_link: bool,
    /// Sends the charger thresholds by which it judges, and keeps its main contactor open without a charger (C5-R005,
    /// R009).
    pub(crate) bounds_the_charger: bool,
}
