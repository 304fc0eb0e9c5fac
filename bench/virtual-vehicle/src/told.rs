//! What one node tells another, in the words of neither's document: commands and reports.
//!
//! A receiving node keeps one of these as it last heard it. Filled from frames by each vehicle's `hears`; where a
//! document does not print a message that the vehicle must have (jiulong's is only the instrument's part, c5ev's has no
//! answer of the motor), the same words travel in [`Unprinted`], which is lost like a frame when a node is cut off.
//! Units and signs: positive currents leave the battery, positive torque drives forwards.

use crate::STEP_MS;
use protocol_core::model::Severity;
use protocol_core::states::Charge;

/// What the motor is to hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// A torque in Nm.
    Torque(f64),
    /// A speed in rpm.
    Speed(f64),
}

/// Vehicle controller to motor controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorCommand {
    /// The motor controller is enabled.
    pub enabled: bool,
    /// What it is to do.
    pub hold: Hold,
}

/// Motor controller to vehicle controller.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotorReport {
    /// Link voltage in V; `None` = not known.
    pub link_volts: Option<f64>,
    /// Shaft speed in rpm.
    pub rpm: f64,
    /// Electrical power in W.
    pub watts: f64,
    /// Winding temperature in degrees Celsius; `None` = not known.
    pub celsius: Option<f64>,
    /// Controller temperature in degrees Celsius; `None` = not known.
    pub inverter_celsius: Option<f64>,
    /// Fault code, 0 = none.
    pub fault_code: u8,
    /// Protections that have tripped.
    pub protections: u32,
    /// A protection other than heat and speed has tripped.
    pub tripped: bool,
    /// Phase current in A; negative while it charges.
    pub phase_amps: f64,
    /// Phase voltage in V.
    pub phase_volts: f64,
}

/// Battery to vehicle controller.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BatteryReport {
    /// Asks for high voltage to be opened.
    pub hv_off_request: bool,
    /// Largest charge current allowed, in A; `None` = not known.
    pub charge_limit_amps: Option<f64>,
    /// Largest discharge current allowed, in A; `None` = not known.
    pub discharge_limit_amps: Option<f64>,
    /// Pack voltage in V; `None` = not known.
    pub volts: Option<f64>,
    /// State of charge, 0 to 1; `None` = not known.
    pub soc: Option<f64>,
    /// Worst severity.
    pub severity: Severity,
    /// Main contactor conducts (closed or welded, BUS-44); `None` = the battery does not say.
    pub main_closed: Option<bool>,
    /// Any charge circuit conducts.
    pub charge_closed: bool,
    /// Charging state.
    pub charge: Charge,
    /// It asks to limp.
    pub limp: bool,
    /// Fault code that came in the last step; `Some(0)` = it says that there is none.
    pub code: Option<u16>,
}

/// Converter, pumps, air conditioning and insulation monitor to vehicle controller.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PartsReport {
    /// Leakage, as a severity.
    pub leak: Severity,
    /// The air conditioning has a fault.
    pub hvac_fault: bool,
    /// It runs.
    pub hvac_on: bool,
    /// It heats with its fan at this step, 0 = it does not.
    pub heating_fan: u8,
    /// Fault code of the compressor, 0 = none.
    pub compressor_code: u8,
    /// The compressor runs.
    pub compressor_on: bool,
    /// The DC/DC converter has a fault.
    pub dcdc_fault: bool,
}

/// Vehicle controller to battery.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BatteryCommand {
    /// High voltage is to be closed.
    pub high_voltage: bool,
    /// Voltage of the link, by which the main contactor is closed (BUS-R036); `None` = not said.
    pub link_volts: Option<f64>,
    /// Charging by the pantograph is allowed.
    pub charge_enable: bool,
}

/// Vehicle controller to DC/DC converter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ConverterCommand {
    /// Start; else stand by.
    pub run: bool,
    /// Lowest input voltage, 0 = its own.
    pub lowest_input: f64,
    /// Auxiliary battery voltage below which it starts, 0 = its own.
    pub start_volts: f64,
}

/// Vehicle controller to steering pump or compressor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PumpCommand {
    /// Run.
    pub run: bool,
    /// Frequency in Hz, 0 = its own.
    pub hertz: f64,
}

/// Vehicle controller to air conditioning.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HvacOrder {
    /// It may start (BUS-R044).
    pub permit: bool,
    /// It is to reduce its frequency (BUS-R046).
    pub derate: bool,
    /// It is to reset (BUS-R045).
    pub reset: bool,
    /// Auxiliary battery in V, as it was sent.
    pub supply_volts: f64,
    /// State of charge, 0 to 1, as it was sent; `None` = not said.
    pub soc: Option<f64>,
}

/// Battery to charger.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChargeOrder {
    /// It may deliver.
    pub enabled: bool,
    /// Largest current in A.
    pub amps: f64,
    /// Highest voltage in V.
    pub volts: f64,
    /// Thresholds by which it classifies its faults (C5-R009).
    pub bounds: Option<ChargerBounds>,
}

/// Thresholds that the battery sends to the charger, in V and A.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChargerBounds {
    /// Above it the charger warns.
    pub over_volts_warning: f64,
    /// Above it the charger stops.
    pub over_volts_protection: f64,
    /// Below it the charger warns.
    pub under_volts_warning: f64,
    /// Below it the charger stops.
    pub under_volts_protection: f64,
    /// Above it the charger warns.
    pub over_amps_warning: f64,
    /// Above it the charger stops.
    pub over_amps_protection: f64,
}

/// Charger to battery.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChargerReport {
    /// A frame has come since the plug went in.
    pub present: bool,
    /// It has switched itself off for a fault.
    pub stopped: bool,
}

/// A word and its age.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told<T> {
    /// What was said; `None` = nothing since the receiver is awake.
    pub word: Option<T>,
    /// Since it was said, in milliseconds; before the first word, since the receiver is awake.
    pub silence_ms: u64,
}

impl<T> Default for Told<T> {
    fn default() -> Self {
        Self { word: None, silence_ms: 0 }
    }
}

impl<T> Told<T> {
    /// Brings a word, or lets a step pass without.
    pub(crate) fn bring(&mut self, word: Option<T>) {
        match word {
            Some(word) => *self = Self { word: Some(word), silence_ms: 0 },
            None => self.silence_ms = self.silence_ms.saturating_add(STEP_MS),
        }
    }
}

/// Words whose messages a vehicle's document does not print; a vehicle uses those that it needs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Unprinted {
    /// Vehicle controller to motor controller.
    pub motor_command: Told<MotorCommand>,
    /// Motor controller to vehicle controller.
    pub motor: Told<MotorReport>,
    /// Vehicle controller to battery.
    pub battery_command: Told<BatteryCommand>,
    /// Battery to vehicle controller.
    pub battery: Told<BatteryReport>,
    /// Vehicle controller to converter.
    pub converter: Told<ConverterCommand>,
    /// Vehicle controller to steering pump.
    pub steering: Told<PumpCommand>,
    /// Vehicle controller to compressor.
    pub compressor: Told<PumpCommand>,
    /// Vehicle controller to air conditioning.
    pub hvac: Told<HvacOrder>,
    /// The parts to the vehicle controller.
    pub parts: Told<PartsReport>,
    /// Battery to charger.
    pub charge_order: Told<ChargeOrder>,
}
