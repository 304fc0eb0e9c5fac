//! What is true in the vehicle at one moment.
//!
//! One struct per thing that exists: physics (driver, road, motion, cells, contacts, supply, air) and the memory of each
//! node (vehicle controller, battery controller, motor controller, parts, charger). A node reads physics and its own
//! memory; of another node it knows what it heard ([`Links::inboxes`]). Physical units in the names; the tables of the
//! bus alone know what raw value that is. An `Option` called `forced_...` or `*_override` is a setting of a person that
//! physics leaves alone.

use crate::inbox::Inbox;
use crate::spec::Spec;
use crate::told::{
    BatteryCommand, BatteryReport, ChargeOrder, ChargerReport, ConverterCommand, HvacOrder, MotorCommand,
    MotorReport, PartsReport, PumpCommand, Unprinted,
};
use crate::{Kind, Options, STEP_MS};
use protocol_core::model::Severity;
use protocol_core::vehicle::Node;

pub use crate::told::ChargerBounds;
pub use protocol_core::states::{Charge, Gear, Key};

/// Nodes that a bus can have.
pub const NODE_COUNT: usize = Node::Cluster as usize + 1;

/// What the person at the wheel does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Driver {
    /// Key position. Locked, every node but the cluster sleeps; Start asks for READY and falls back to On by itself.
    pub key: Key,
    /// Accelerator pedal, 0 to 1.
    pub accelerator: f64,
    /// Brake pedal, 0 to 1.
    pub brake: f64,
    /// Gear lever.
    pub gear: Gear,
    /// Parking brake set.
    pub parking_brake: bool,
    /// Nobody sits on the seat.
    pub seat_empty: bool,
    /// Speed to hold in km/h in place of the pedals: a driver who does it by himself.
    pub target_kmh: Option<f64>,
    /// Economy mode chosen.
    pub economy: bool,
    /// Cruise control on.
    pub cruise: bool,
    /// Air conditioning wanted.
    pub air_conditioning: bool,
    /// Set by a person: the accelerator's sensor is broken (JL-R011: sent as 0xFF).
    pub accelerator_fault: bool,
    /// The brake pedal is a switch: sent as 0 or 100 % (BUS-R019).
    pub digital_brake: bool,
    /// What the driver with a target has learned to press, -1 to 1 (owner: driver).
    pub effort: f64,
}

/// Doors, lights and what else the cluster's own wires report; the firmware's pins follow it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Body {
    /// Entry door open.
    pub front_door: bool,
    /// Exit door open.
    pub rear_door: bool,
    /// Left indicator on (steady here; the flasher is the cluster's side).
    pub turn_left: bool,
    /// Right indicator on.
    pub turn_right: bool,
    /// Hazard warning switched on.
    pub hazard: bool,
    /// Smoke detector in the passenger room gives alarm.
    pub smoke: bool,
}

/// The world outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Road {
    /// Slope in percent, positive = uphill.
    pub slope_percent: f64,
    /// Air temperature in degrees Celsius.
    pub celsius: f64,
}

/// Mass in motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Speed over ground in m/s, negative = backwards.
    pub metres_per_s: f64,
    /// Distance since the vehicle was built, in m; backwards counts too.
    pub metres: f64,
}

impl Motion {
    /// Returns the speed in km/h, never negative.
    pub fn kmh(&self) -> f64 {
        self.metres_per_s.abs() * 3.6
    }
}

/// Motor and motor controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motor {
    /// Shaft speed in rpm, negative = backwards.
    pub rpm: f64,
    /// Torque in Nm, negative = regeneration while going forwards.
    pub nm: f64,
    /// What the motor controller heard that it is to do; `None` = nothing that is still valid.
    pub heard: Option<MotorCommand>,
    /// Torque that it follows, in Nm.
    pub wanted_nm: f64,
    /// Electrical power in W, positive = out of the battery.
    pub watts: f64,
    /// DC-link voltage in V: follows the pack through precharge, bleeds off behind open contactors.
    pub link_volts: f64,
    /// Winding temperature in degrees Celsius.
    pub celsius: f64,
    /// Controller temperature in degrees Celsius.
    pub inverter_celsius: f64,
    /// Set by a person: winding temperature.
    pub celsius_override: Option<f64>,
    /// Set by a person: controller temperature.
    pub inverter_celsius_override: Option<f64>,
    /// The controller is enabled and runs.
    pub running: bool,
    /// Fault code by a person, 0 = none (meanings are the maker's).
    pub fault_code: u8,
    /// Which protection bits are set (citybus: IPU1, jiulong: VCU3). Bit n is the n-th named protection signal of the DBC,
    /// reserved bits not counted: bus 0 = `bus_overcurrent` to 6 = `overspeed`, jiulong 0 = `igbt_protection` to 22 =
    /// `hardware_shutdown`.
    pub protections: u32,
    /// It sits on a bus of its own: the vehicle controller forwards IPU2 and IPU3, IPU1 stays there (BUS-R056, BUS-06).
    pub own_bus: bool,
    /// Which of them a person has set; the others come from temperatures and speed.
    pub protections_set: u32,
    /// Phase current in A, effective; negative while it charges (JL-R017).
    pub phase_amps: f64,
    /// Phase voltage in V, effective.
    pub phase_volts: f64,
    /// Largest torque it could give now, in Nm, never negative.
    pub peak_nm: f64,
}

/// Switch with contacts that can weld.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Contactor {
    /// Its coil is driven.
    pub driven: bool,
    /// Its contacts touch.
    pub closed: bool,
    /// Its contacts are welded (by a person): closed whatever the coil does.
    pub welded: bool,
    /// Its contacts do not close (by a person).
    pub stuck_open: bool,
    /// Milliseconds since the coil changed; contacts follow after a moment.
    pub moving_ms: u32,
}

/// State of a relay circuit as its owner reports it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RelayState {
    /// Does not conduct.
    #[default]
    Open,
    /// Conducts.
    Closed,
    /// Conducts whatever its coil does.
    Welded,
}

/// The cells: what is physically there.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pack {
    /// Open-circuit state of charge of each cell, 0 to 1.
    pub cell_soc: Vec<f64>,
    /// Terminal voltage of each cell in V.
    pub cell_volts: Vec<f64>,
    /// Temperature of each probe in degrees Celsius.
    pub probe_celsius: Vec<f64>,
    /// Probe temperatures that physics knows, whatever a person has set.
    pub inner_celsius: Vec<f64>,
    /// Internal resistance of each cell in ohm.
    pub cell_ohm: Vec<f64>,
    /// Rated capacity in Ah.
    pub capacity_ah: f64,
    /// Total voltage in V as measured: what the battery controller reports.
    pub volts: f64,
    /// Current in A as measured, positive = out of the battery.
    pub amps: f64,
    /// Sum of cell voltages in V that physics knows, whatever a person has set.
    pub terminal_volts: f64,
    /// Current in A that physics knows, positive = out of the battery.
    pub terminal_amps: f64,
    /// Mean state of charge, 0 to 1.
    pub soc: f64,
    /// Energy out of the cells since start, in J, and into them.
    pub joules_out: f64,
    /// Energy into the cells since start, in J.
    pub joules_in: f64,
    /// Set by a person: voltage of the highest cell.
    pub highest_volts_override: Option<f64>,
    /// Set by a person: voltage of the lowest cell.
    pub lowest_volts_override: Option<f64>,
    /// Set by a person: temperature of the hottest probe.
    pub hottest_override: Option<f64>,
    /// Set by a person: temperature of the coldest probe.
    pub coldest_override: Option<f64>,
    /// Set by a person: total voltage.
    pub volts_override: Option<f64>,
    /// Set by a person: current.
    pub amps_override: Option<f64>,
}

/// Highest or lowest value, and where.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extreme {
    /// The value.
    pub value: f64,
    /// Index of the cell or probe, from 0.
    pub index: usize,
}

/// The battery controller.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bms {
    /// Main positive contactor.
    pub main: Contactor,
    /// Main negative contactor.
    pub negative: Contactor,
    /// Precharge contactor.
    pub precharge: Contactor,
    /// Charge circuit 1, its two relays (BUS-R068 to R070).
    pub charge_1: [Contactor; 2],
    /// Charge circuit 2, its two relays.
    pub charge_2: [Contactor; 2],
    /// Heater circuit, its two relays.
    pub heater: [Contactor; 2],
    /// Precharge is complete.
    pub precharged: bool,
    /// Precharge did not reach its voltage in time; tried again when high voltage is next asked for.
    pub precharge_failed: bool,
    /// How long precharge has run, in milliseconds.
    pub precharge_ms: u64,
    /// Rows of the fault table whose condition has come and not gone.
    pub raised: Vec<bool>,
    /// Takes turns among codes of the same severity.
    pub turn: Turn,
    /// Active faults as (row of the fault table, its severity), worst first.
    pub active: Vec<ActiveFault>,
    /// Worst severity reported.
    pub severity: Severity,
    /// Worst severity of insulation faults where it is reported apart (jiulong).
    pub insulation_severity: Severity,
    /// Code sent now, 0 = none; codes of the worst severity take turns.
    pub code: u8,
    /// A fault forbids charging.
    pub forbids_charging: bool,
    /// A fault asks the vehicle to stop; said by severity and limits alone (BUS-82).
    pub requests_stop: bool,
    /// High voltage as the vehicle controller last asked for it.
    pub hv_wanted: bool,
    /// An extreme fault has opened high voltage; it stays open until power-off.
    pub isolated: bool,
    /// Asks the vehicle to open high voltage (BUS-R065).
    pub hv_off_request: bool,
    /// Milliseconds since that request began.
    pub hv_off_ms: u64,
    /// Fire has been seen since power-on (BUS-R117).
    pub fire: bool,
    /// Runs its limp limit after losing the vehicle controller (BUS-R081, R115).
    pub limp: bool,
    /// Largest charge (regeneration) current allowed, in A, never negative.
    pub charge_limit_amps: f64,
    /// Largest discharge current allowed, in A, never negative.
    pub discharge_limit_amps: f64,
    /// Charging state.
    pub charge: Charge,
    /// Balancing is active.
    pub balancing: bool,
    /// Days since the last external charge (BUS-R084).
    pub charge_interval_days: u32,
    /// The day that is running.
    pub day: Day,
    /// How long the charge current has been down at its tail, in milliseconds.
    pub tail_ms: u64,
    /// Thresholds by which the charger classifies its faults (C5-R009).
    pub charger_bounds: ChargerBounds,
    /// Charge current and voltage wanted from the charger.
    pub wanted_charge: (f64, f64),
    /// The charger may deliver.
    pub charger_enabled: bool,
    /// The charger has been heard since the plug went in.
    pub charger_heard: bool,
    /// What it heard of the charger.
    pub charger: ChargerReport,
    /// For how long it has not heard the plugged charger, in milliseconds.
    pub charger_silence_ms: u64,
    /// What it heard of the vehicle controller.
    pub vcu: BatteryCommand,
    /// For how long it has not heard a command of the vehicle controller, in milliseconds.
    pub vcu_silence_ms: u64,
    /// Current limits without the halving for a current over them.
    pub limits: Limits,
    /// The same as they were in the last two frames that told them, the later one first; `None` = not yet told.
    pub sent_limits: [Option<Limits>; 2],
    /// Main negative has not followed its coil since high voltage was asked for.
    pub negative_failed: bool,
    /// A fault keeps open what is open (interlock, fire: no driving off).
    pub forbids_closing: bool,
    /// Milliseconds since the plug went in.
    pub plugged_ms: u64,
    /// Highest cell voltage in V.
    pub cell_max: Extreme,
    /// Lowest cell voltage in V.
    pub cell_min: Extreme,
    /// Highest probe temperature in degrees Celsius.
    pub hot: Extreme,
    /// Lowest probe temperature in degrees Celsius.
    pub cold: Extreme,
    /// Defects of the controller itself, set by a person.
    pub defects: BmsDefects,
    /// State of charge as last counted, 0 to 1; `None` = not yet, or a person has exchanged the charge.
    pub soc_before: Option<f64>,
    /// How long a jump of it will still be told, in milliseconds.
    pub soc_jump_ms: u64,
}

/// Current limits in A, never negative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// Into the battery.
    pub charge_amps: f64,
    /// Out of the battery.
    pub discharge_amps: f64,
}

/// Codes that take turns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Turn {
    /// Whose turn it is, 0 = nobody's.
    pub code: u8,
    /// For how long, in milliseconds.
    pub held_ms: u64,
}

/// A day of operation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Day {
    /// Milliseconds of it that have passed.
    pub passed_ms: u64,
    /// Milliseconds of it that the vehicle was driven.
    pub driven_ms: u64,
}

/// One active fault of the battery controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ActiveFault {
    /// Row of the fault table.
    pub row: usize,
    /// How bad it is.
    pub severity: Severity,
    /// Its code (citybus), or the position of its bit in `BMSFaults` (jiulong) or `BMSD` (c5ev).
    pub code: u8,
}

/// Defects that a person puts into the battery controller.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BmsDefects {
    /// High-voltage interlock open.
    pub interlock_open: bool,
    /// Current sensor broken.
    pub current_sensor: bool,
    /// Internal bus to the measuring boards lost.
    pub internal_bus: bool,
    /// Main positive contactor reports a fault.
    pub main_contactor: bool,
    /// Temperature of the charge socket in degrees Celsius.
    pub socket_celsius: Option<f64>,
    /// Smoke detector in the battery gives alarm (jiulong).
    pub smoke: bool,
    /// Smoke detector in the battery is broken (jiulong).
    pub smoke_detector: bool,
    /// Sends thresholds to the charger in which warning and protection are exchanged (c5ev).
    pub bounds_exchanged: bool,
    /// Cuts the main negative (jiulong).
    pub negative_cut: bool,
    /// What the charge counter is off by, 1 = a whole battery (jiulong).
    pub soc_error: f64,
}

/// The vehicle controller.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vcu {
    /// Key position by wire and by the cluster's message.
    pub key: Key,
    /// Gear engaged; `None` = not known.
    pub gear: Option<Gear>,
    /// The last gear request was refused.
    pub shift_failed: bool,
    /// Torque may be given: READY.
    pub ready: bool,
    /// Wants high voltage closed.
    pub hv_command: bool,
    /// Emergency cut-off has been done.
    pub hv_cutoff: bool,
    /// Limp mode after losing the battery's frames (BUS-R080).
    pub limp: bool,
    /// Power is limited.
    pub power_limited: bool,
    /// Torque is limited.
    pub torque_limited: bool,
    /// Regeneration is allowed.
    pub may_regenerate: bool,
    /// Worst severity of its own faults.
    pub own_severity: Severity,
    /// Severity that it reports: the worse of its own and the battery's (BUS-R027, R072).
    pub severity: Severity,
    /// Code sent now, 0 = none.
    pub code: u16,
    /// Codes heard of the battery, each with the milliseconds since it was heard.
    pub battery_codes: Vec<(u16, u64)>,
    /// Voltage of the link, as the motor controller last told it; `None` = not for too long.
    pub link_volts: Option<f64>,
    /// The parking brake is on, by the cluster's word or by wire.
    pub parking_brake: bool,
    /// Torque that it asks the motor for, in Nm.
    pub wanted_nm: f64,
    /// Asks for the buzzer (c5ev).
    pub buzzer: bool,
    /// Steering pump command: run, frequency in Hz (0 = default).
    pub steering: (bool, f64),
    /// Air compressor command: run, frequency in Hz (0 = default).
    pub compressor: (bool, f64),
    /// DC/DC converter command: run.
    pub dcdc: bool,
    /// Air conditioning: relay closed, start permitted, derate, reset.
    pub hvac: HvacCommand,
    /// Charging is enabled to the battery; pantograph state 0 to 3.
    pub charge_enable: bool,
    /// Motor contactor and accessory contactors as commanded.
    pub relays: Relays,
    /// Remaining range in km.
    pub range_km: f64,
    /// Torque is withheld because the driver has left the seat (BUS-R130 to R132).
    pub seat_cut: bool,
    /// The START signal has been given since the key was turned on (BUS-R041).
    pub started: bool,
    /// Something in the vehicle is faulty: its own list, leakage, motor, battery, limp (BUS-R023, C5-R012).
    pub system_fault: bool,
    /// Electrical power that it lets the motor take, in W; what its frames call a limit (BUS-R035, R082).
    pub allowed_watts: f64,
    /// Electrical power that it lets the motor give back, in W, never negative.
    pub allowed_regeneration_watts: f64,
    /// Pantograph state 0 to 3 of VCU3 (BUS-R037); 0 without one.
    pub pantograph_state: u8,
    /// Lowest input voltage for the DC/DC converter, and auxiliary battery voltage below which it starts; 0 = its own
    /// (BUS-R047).
    pub dcdc_volts: (f64, f64),
    /// Coolant pump of motor and controller runs.
    pub coolant_pump: bool,
    /// Their fan: 0 off, 1 low, 2 high.
    pub coolant_fan: u8,
    /// Mean consumption in J per metre, from which the range follows.
    pub joules_per_metre: f64,
    /// Codes by a person: two for each of level 1, 2 and 3 of the bus (WARN, DERATE, STOP), 0 = none.
    pub set_codes: [[u16; 2]; 3],
    /// By a person: does not answer the battery's request to open high voltage.
    pub ignores_hv_off: bool,
    /// What it last heard of the others.
    pub heard: Heard,
    /// Spans that it watches.
    pub spans: VcuSpans,
}

/// What the vehicle controller last heard; stands still while nothing comes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Heard {
    /// Of the battery.
    pub battery: BatteryReport,
    /// For how long a message of the battery that it acts on has not come, in milliseconds: the longest.
    pub battery_silence_ms: u64,
    /// The same of the message that says how bad the battery is.
    pub level_silence_ms: u64,
    /// Of the motor controller.
    pub motor: MotorReport,
    /// For how long the motor controller has not been heard, in milliseconds.
    pub motor_silence_ms: u64,
    /// Of the parts.
    pub parts: PartsReport,
}

/// Spans that the vehicle controller watches, in milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VcuSpans {
    /// Since the key went to start.
    pub start_ms: u64,
    /// Since the battery's request to open high voltage was heard.
    pub hv_off_ms: u64,
    /// Since the driver left the seat.
    pub seat_ms: u64,
    /// Since the air conditioning's relay was commanded closed.
    pub hvac_relay_ms: u64,
    /// Since the air conditioning reported a fault.
    pub hvac_fault_ms: u64,
    /// Since the buzzer's cause began (C5-R014).
    pub buzzer_ms: u64,
    /// Since the present codes began to take turns (BUS-R028).
    pub rotation_ms: u64,
    /// Since high voltage is on.
    pub hv_on_ms: u64,
    /// Since the pantograph was sent up.
    pub pantograph_ms: u64,
}

/// What the vehicle controller tells the air conditioning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HvacCommand {
    /// Its relay in the high-voltage cabinet is commanded closed.
    pub relay: bool,
    /// It may start (BUS-R044).
    pub permit: bool,
    /// It is to reduce its frequency (BUS-R046).
    pub derate: bool,
    /// It is to reset (BUS-R045).
    pub reset: bool,
}

/// High-voltage relays that the vehicle controller drives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Relays {
    /// Motor precharge.
    pub precharge: bool,
    /// Motor.
    pub motor: bool,
    /// Accessories.
    pub accessory: bool,
    /// Accessory precharge.
    pub accessory_precharge: bool,
    /// Defroster.
    pub defrost: bool,
    /// Any charging contactor conducts, forwarded from the battery (BUS-R039: K6 of VCU3).
    pub charge: bool,
    /// The battery's main contactor conducts, forwarded (BUS-R039: K7 of VCU3).
    pub battery: bool,
}

/// A part with a motor or a converter: steering pump, compressor, DC/DC.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Part {
    /// Runs.
    pub running: bool,
    /// Fault code by a person, 0 = none: then it stops and says "fault".
    pub fault_code: u8,
    /// Motor speed in rpm.
    pub rpm: f64,
    /// High-voltage side in V.
    pub input_volts: f64,
    /// High-voltage side in A.
    pub input_amps: f64,
    /// Low-voltage side in V (DC/DC).
    pub output_volts: f64,
    /// Low-voltage side in A (DC/DC).
    pub output_amps: f64,
    /// Temperature in degrees Celsius.
    pub celsius: f64,
    /// Its own precharge is complete.
    pub precharged: bool,
    /// Follows the frequency that it is sent (BUS-R118).
    pub external: bool,
    /// Electrical power from the high-voltage link in W.
    pub watts: f64,
    /// Milliseconds since high voltage reached it.
    pub powered_ms: u64,
}

/// The low-voltage supply.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Supply {
    /// Auxiliary battery in V.
    pub volts: f64,
    /// Set by a person.
    pub volts_override: Option<f64>,
    /// State of charge of the auxiliary battery, 0 to 1.
    pub charge: f64,
    /// Current of all low-voltage loads in A.
    pub load_amps: f64,
}

/// Brake air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Air {
    /// Front reservoir in MPa.
    pub front_mpa: f64,
    /// Rear reservoir in MPa.
    pub rear_mpa: f64,
    /// Set by a person: both reservoirs.
    pub mpa_override: Option<f64>,
    /// Brake vacuum in kPa below the atmosphere (jiulong).
    pub vacuum_kpa: f64,
    /// Brake pedal in the last step, 0 to 1: air is used while it goes down.
    pub pressed: f64,
    /// By a person: the pressure sensors are broken (JL-R016: sent as 0xFF).
    pub pressure_sensor_fault: bool,
    /// By a person: no vacuum sensor, or it is broken (JL-R014: sent as 0xFF).
    pub vacuum_sensor_fault: bool,
}

/// Air conditioning.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hvac {
    /// Powered and running.
    pub on: bool,
    /// Fan: 0 off, 1 low, 2 medium, 3 high.
    pub fan: u8,
    /// Compressor cools.
    pub cooling: bool,
    /// Heats.
    pub heating: bool,
    /// Cabin temperature in degrees Celsius.
    pub cabin_celsius: f64,
    /// Setpoint in degrees Celsius (BUS-R142).
    pub setpoint_celsius: f64,
    /// Fault bits in the document's order, by a person.
    pub faults: u8,
    /// Has lost the vehicle controller (BUS-R133).
    pub communication_alarm: bool,
    /// Its own precharge is complete.
    pub precharged: bool,
    /// Has stopped for a fault that a reset did not clear (BUS-R045).
    pub stopped: bool,
    /// Electrical power from the high-voltage link in W.
    pub watts: f64,
    /// What it last heard of the vehicle controller.
    pub heard: HvacOrder,
    /// For how long it has not, in milliseconds.
    pub silence_ms: u64,
    /// Milliseconds since it has been permitted to start.
    pub permitted_ms: u64,
    /// Milliseconds since a reset began.
    pub reset_ms: u64,
}

/// Insulation monitor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Insulation {
    /// Positive side in kilo-ohm.
    pub positive_kiloohm: f64,
    /// Negative side in kilo-ohm.
    pub negative_kiloohm: f64,
    /// Device fault, by a person.
    pub device_fault: bool,
    /// Leakage level 0 to 2 as it reports.
    pub level: u8,
    /// Set by a person: resistance of the positive side.
    pub kiloohm_override: Option<f64>,
    /// Fault code by a person, 0 = none.
    pub fault_code: u8,
}

/// Where the energy has gone since start, in J: what is kept to prove that none is made.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Into the motor controller from the link; regeneration counts back.
    pub motor: f64,
    /// Into everything else on the link.
    pub accessories: f64,
    /// Heat of motor and controller.
    pub motor_heat: f64,
    /// Rolling and air resistance.
    pub resistance: f64,
    /// Heat of the friction brakes.
    pub brakes: f64,
    /// Height; positive = uphill.
    pub climb: f64,
}

/// On-board charger and the mains behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Charger {
    /// The plug is inserted.
    pub plugged: bool,
    /// Mains voltage in V, 0 = off; the right one is 220.
    pub mains_volts: f64,
    /// Pantograph is up and wanted (citybus).
    pub pantograph: bool,
    /// Delivers.
    pub running: bool,
    /// Output in V.
    pub volts: f64,
    /// Output in A, never negative.
    pub amps: f64,
    /// Largest output in A.
    pub max_amps: f64,
    /// Hardware fault, by a person.
    pub hardware_fault: bool,
    /// Over-temperature, by a person.
    pub over_temperature: bool,
    /// Battery connected the wrong way round, by a person.
    pub reversed: bool,
    /// Is made for another battery, by a person (jiulong).
    pub mismatched: bool,
    /// What it last heard of the battery.
    pub heard: ChargeOrder,
    /// For how long it has not, in milliseconds.
    pub silence_ms: u64,
    /// Has lost the battery's frames (C5-R007).
    pub communication_fault: bool,
    /// Input voltage is wrong (BUS-R153, JL-R028, C5-R010).
    pub input_fault: bool,
    /// Battery voltage is abnormal: does not start (BUS-R152, JL-R029).
    pub start_inhibited: bool,
    /// What it makes of the battery's thresholds (C5-R009).
    pub trips: ChargerTrips,
    /// Fault codes by a person, 0 = none; the code's range is its severity (BUS-R151).
    pub faults: [u8; 3],
    /// Worst severity that it reports.
    pub severity: Severity,
    /// Code sent now, 0 = none; codes of the worst severity take turns (BUS-R150).
    pub code: u8,
    /// Takes turns among codes of the same severity.
    pub turn: Turn,
}

/// Faults that the charger classifies by the battery's thresholds (C5-R009).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ChargerTrips {
    /// Voltage is above its warning.
    pub over_volts_warning: bool,
    /// Voltage is above its protection: output off.
    pub over_volts_protection: bool,
    /// Voltage is below its warning.
    pub under_volts_warning: bool,
    /// Voltage is below its protection: output off.
    pub under_volts_protection: bool,
    /// Current is above its warning.
    pub over_amps_warning: bool,
    /// Current is above its protection: output off.
    pub over_amps_protection: bool,
    /// Warning of over-voltage does not lie below its protection.
    pub over_volts_data: bool,
    /// Warning of under-voltage does not lie above its protection.
    pub under_volts_data: bool,
    /// Warning of over-current does not lie below its protection.
    pub over_amps_data: bool,
}

/// What steering pump, compressor and converter last heard of the vehicle controller.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PartsHeard {
    /// Steering pump; `None` = nothing that is still valid.
    pub steering: Option<PumpCommand>,
    /// Compressor; `None` = nothing that is still valid.
    pub compressor: Option<PumpCommand>,
    /// Converter.
    pub converter: ConverterCommand,
}

/// Relays of the contactor box as it last heard their commands over the bus.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactorBox {
    /// Motor.
    pub motor: bool,
    /// Motor precharge.
    pub precharge: bool,
    /// Accessories.
    pub accessory: bool,
    /// Accessory precharge.
    pub accessory_precharge: bool,
    /// Defroster.
    pub defrost: bool,
}

/// What the vehicle controller heard of the cluster.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Meter {
    /// Key position; `None` = not said.
    pub key: Option<Key>,
    /// A passenger door is open.
    pub door_open: bool,
    /// The driver has left the seat (BUS-R129).
    pub seat_left: bool,
    /// Parking brake as the cluster reports it.
    pub parking_brake: bool,
    /// Total distance in km.
    pub odometer_km: Option<f64>,
    /// Remote upgrade is forbidden (JL-R031).
    pub upgrade_forbidden: Option<bool>,
    /// Milliseconds since the cluster's last frame that says so; large before the first.
    pub silent_ms: u64,
    /// Frames heard.
    pub frames: u64,
}

/// Who hears what.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Links {
    /// By a person: this node is cut off the bus.
    pub cut: [bool; NODE_COUNT],
    /// By a person: messages that are no longer sent, by name.
    pub lost: Vec<&'static str>,
    /// By a person: life counters of this node stand still.
    pub frozen: [bool; NODE_COUNT],
    /// What has reached each node, by its number.
    pub inboxes: [Inbox; NODE_COUNT],
    /// What they say in messages that no document prints.
    pub unprinted: Unprinted,
}

impl Links {
    /// Returns what has reached a node.
    pub fn inbox(&self, node: Node) -> &Inbox {
        &self.inboxes[node as usize]
    }
}

/// What is true in the vehicle.
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    /// Which vehicle.
    pub kind: Kind,
    /// Its figures.
    pub(crate) spec: &'static Spec,
    /// How it was built.
    pub options: Options,
    /// Milliseconds since start.
    pub now_ms: u64,
    /// The person at the wheel.
    pub driver: Driver,
    /// Doors and lights.
    pub body: Body,
    /// The world outside.
    pub road: Road,
    /// Mass in motion.
    pub motion: Motion,
    /// Motor and its controller.
    pub motor: Motor,
    /// The cells.
    pub pack: Pack,
    /// The battery controller.
    pub bms: Bms,
    /// The vehicle controller.
    pub vcu: Vcu,
    /// Steering pump.
    pub steering: Part,
    /// Air compressor.
    pub compressor: Part,
    /// DC/DC converter.
    pub dcdc: Part,
    /// What the parts heard.
    pub parts_heard: PartsHeard,
    /// Contactor box.
    pub contactor_box: ContactorBox,
    /// Low-voltage supply.
    pub supply: Supply,
    /// Brake air.
    pub air: Air,
    /// Air conditioning.
    pub hvac: Hvac,
    /// Insulation monitor.
    pub insulation: Insulation,
    /// On-board charger.
    pub charger: Charger,
    /// What the cluster says.
    pub meter: Meter,
    /// Who hears whom.
    pub links: Links,
    /// Where the energy has gone.
    pub energy: Energy,
}

impl World {
    /// A vehicle that stands, keyed on, in mild weather; battery and parts are still to be fitted.
    pub(crate) fn bare(kind: Kind, spec: &'static Spec, options: Options) -> Self {
        Self {
            kind,
            spec,
            options,
            now_ms: 0,
            driver: Driver { key: Key::On, ..Driver::default() },
            body: Body::default(),
            road: Road { slope_percent: 0.0, celsius: 20.0 },
            motion: Motion::default(),
            motor: Motor {
                rpm: 0.0,
                nm: 0.0,
                heard: None,
                wanted_nm: 0.0,
                watts: 0.0,
                link_volts: 0.0,
                celsius: 25.0,
                inverter_celsius: 25.0,
                celsius_override: None,
                inverter_celsius_override: None,
                running: false,
                fault_code: 0,
                protections: 0,
                own_bus: false,
                protections_set: 0,
                phase_amps: 0.0,
                phase_volts: 0.0,
                peak_nm: 0.0,
            },
            pack: Pack::default(),
            bms: Bms::default(),
            vcu: Vcu::default(),
            steering: Part { celsius: 25.0, ..Part::default() },
            compressor: Part { celsius: 25.0, ..Part::default() },
            dcdc: Part { celsius: 25.0, ..Part::default() },
            parts_heard: PartsHeard::default(),
            contactor_box: ContactorBox::default(),
            supply: Supply { volts: 0.0, volts_override: None, charge: 0.8, load_amps: 0.0 },
            air: Air {
                front_mpa: 0.75,
                rear_mpa: 0.75,
                mpa_override: None,
                vacuum_kpa: 70.0,
                pressed: 0.0,
                pressure_sensor_fault: false,
                vacuum_sensor_fault: false,
            },
            hvac: Hvac { cabin_celsius: 20.0, setpoint_celsius: 24.0, ..Hvac::default() },
            insulation: Insulation {
                positive_kiloohm: 5_000.0,
                negative_kiloohm: 5_000.0,
                device_fault: false,
                level: 0,
                kiloohm_override: None,
                fault_code: 0,
            },
            charger: Charger { mains_volts: 220.0, max_amps: 32.0, ..Charger::default() },
            meter: Meter { silent_ms: u64::MAX / 2, ..Meter::default() },
            links: Links::default(),
            energy: Energy::default(),
        }
    }

    /// Nodes are awake: the key is beyond accessories, or a plug is inserted.
    pub fn is_awake(&self) -> bool {
        self.driver.key >= Key::On || self.charger.plugged
    }

    /// High voltage is on the link: main and negative contactor both conduct.
    pub fn hv_connected(&self) -> bool {
        self.bms.main.closed && self.bms.negative.closed
    }

    /// Power that everything but the charger takes from the pack now, in W; negative = regeneration feeds it. The pack's
    /// current is this by its voltage, less what the charger delivers.
    pub fn load_watts(&self) -> f64 {
        self.motor.watts + self.accessory_watts()
    }

    /// Power that everything but the motor takes from the link, in W.
    pub fn accessory_watts(&self) -> f64 {
        self.dcdc.watts + self.steering.watts + self.compressor.watts + self.hvac.watts
    }

    /// State of charge as the battery controller counts it: 0 and up, above 1 if the counter is off.
    pub fn counted_soc(&self) -> f64 {
        (self.pack.soc + self.bms.defects.soc_error).max(0.0)
    }

    /// Counts a span up by one step.
    pub(crate) fn count(ms: &mut u64) {
        *ms = ms.saturating_add(STEP_MS);
    }
}
