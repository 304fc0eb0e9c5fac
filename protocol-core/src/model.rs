//! The vehicle-neutral model: one tree of names for every value that a cluster can know.
//!
//! Owns the list of values with their paths and units, and the store ([`Readings`]) into which generated decoders
//! write. The same paths stand in `vehicle.toml`, scenario files, logs and the book; the states that a value can be in
//! are in [`states`]. Refuses to know messages, identifiers or time-outs; freshness is the cluster's business.

use crate::states;

pub use crate::states::{Gear, Missing, Severity};

/// One decoded signal value, in the model's unit of its [`Value`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// The sender gave a value inside the valid range.
    Valid(i32),
    /// The sender gave a value outside the valid range, or the "not available" pattern.
    Invalid,
}

/// What may be shown of a value: missing is a value of its own and never looks like zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shown<T> {
    /// No message with this value has arrived since power-on.
    #[default]
    Never,
    /// The message has stopped arriving.
    Stale,
    /// The message arrives, but the sender marks the value as not valid.
    Invalid,
    /// The value is fresh and valid.
    Value(T),
}

impl<T> Shown<T> {
    /// Returns the value if it is fresh and valid.
    pub fn value(self) -> Option<T> {
        match self {
            Self::Value(value) => Some(value),
            _ => None,
        }
    }

    /// Returns how the value is missing; `None` = it is fresh and valid.
    pub fn missing(&self) -> Option<Missing> {
        match self {
            Self::Never => Some(Missing::Never),
            Self::Stale => Some(Missing::Stale),
            Self::Invalid => Some(Missing::Invalid),
            Self::Value(_) => None,
        }
    }

    /// Applies `f` to a fresh value and keeps every kind of missing.
    pub fn map<U>(self, f: impl FnOnce(T) -> U) -> Shown<U> {
        match self {
            Self::Never => Shown::Never,
            Self::Stale => Shown::Stale,
            Self::Invalid => Shown::Invalid,
            Self::Value(value) => Shown::Value(f(value)),
        }
    }
}

/// The unit of one count of a model value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// State: [`states::Flag`](states::Flag).
    Flag,
    /// A plain number or code.
    Count,
    /// State: [`Severity`].
    Severity,
    /// State: [`Gear`].
    Gear,
    /// State: [`states::Contactor`](states::Contactor).
    Contactor,
    /// State: [`states::Run`](states::Run).
    Run,
    /// State: [`states::Charge`](states::Charge).
    Charge,
    /// 1/256 km/h.
    Kmh256,
    /// 1/8 km, as J1939 counts distance.
    Km8,
    /// 0.1 %.
    Permille,
    /// 0.1 V.
    Decivolt,
    /// 1 mV.
    Millivolt,
    /// 0.1 A.
    Deciamp,
    /// 0.1 Nm.
    DeciNm,
    /// 1 rpm.
    Rpm,
    /// 1 degree Celsius.
    Celsius,
    /// 1 kilo-ohm.
    Kiloohm,
    /// 1 Ah.
    Ah,
    /// 0.01 MPa (10 kPa).
    CentiMpa,
    /// 1 kPa.
    Kilopascal,
    /// 1 W.
    Watt,
    /// 1 Hz.
    Hertz,
    /// Whole days.
    Day,
    /// State: [`states::Key`](states::Key).
    Key,
    /// State: [`states::Fan`](states::Fan).
    Fan,
    /// State: [`states::Mode`](states::Mode).
    Mode,
    /// State: [`states::Check`](states::Check).
    Check,
    /// Bit n set = fault code n + 1 of the node is active; see [`crate::vehicle::FaultText`].
    Bits,
}

impl Unit {
    /// Returns the kind of state that a value of this unit is; `None` for numbers and bits.
    pub const fn kind(self) -> Option<states::Kind> {
        Some(match self {
            Self::Flag => states::Flag::KIND,
            Self::Severity => Severity::KIND,
            Self::Gear => Gear::KIND,
            Self::Contactor => states::Contactor::KIND,
            Self::Run => states::Run::KIND,
            Self::Charge => states::Charge::KIND,
            Self::Key => states::Key::KIND,
            Self::Fan => states::Fan::KIND,
            Self::Mode => states::Mode::KIND,
            Self::Check => states::Check::KIND,
            _ => return None,
        })
    }
}

macro_rules! model {
    ($($(#[$doc:meta])* $name:ident $path:literal $unit:ident;)*) => {
        /// A value of the model; [`Value::path`] is its public name.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u8)]
        pub enum Value { $($(#[$doc])* $name),* }

        impl Value {
            /// Every value, in order.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];
            /// How many values there are.
            pub const COUNT: usize = Self::ALL.len();

            /// Returns the public name, for example `battery.soc`.
            pub const fn path(self) -> &'static str {
                match self { $(Self::$name => $path),* }
            }

            /// Returns the unit of one count.
            pub const fn unit(self) -> Unit {
                match self { $(Self::$name => Unit::$unit),* }
            }

            /// Returns the value of a public name.
            pub fn from_path(path: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|value| value.path() == path)
            }
        }
    };
}

model! {
    /// Road speed, never negative.
    VehicleSpeed "vehicle.speed" Kmh256;
    /// Gear that the vehicle controller has engaged.
    VehicleGear "vehicle.gear" Gear;
    /// How the vehicle controller drives.
    VehicleMode "vehicle.mode" Mode;
    /// Torque may be sent: the READY lamp.
    VehicleReady "vehicle.ready" Flag;
    /// System fault lamp.
    VehicleFault "vehicle.fault" Flag;
    /// Severity of the vehicle controller's own fault report.
    VehicleFaultLevel "vehicle.fault_level" Severity;
    /// Fault code of the vehicle controller, 0 = none.
    VehicleFaultCode "vehicle.fault_code" Count;
    /// Drive power is limited.
    VehiclePowerLimited "vehicle.power_limited" Flag;
    /// Drive torque is limited.
    VehicleTorqueLimited "vehicle.torque_limited" Flag;
    /// Accelerator pedal.
    VehicleAccelerator "vehicle.accelerator" Permille;
    /// Brake pedal.
    VehicleBrake "vehicle.brake" Permille;
    /// Service brake switch.
    VehicleFootBrake "vehicle.foot_brake" Flag;
    /// Parking brake as the vehicle controller sees it.
    VehicleParkingBrake "vehicle.parking_brake" Flag;
    /// The vehicle controller asks for high voltage.
    VehicleHvCommand "vehicle.hv_command" Flag;
    /// Total distance, if the vehicle sends one.
    VehicleOdometer "vehicle.odometer" Km8;
    /// Remaining range.
    VehicleRange "vehicle.range" Km8;
    /// Severity that the vehicle controller gives its own state, beside its fault report (JL-56).
    VehicleControllerLevel "vehicle.controller_level" Severity;
    /// Severity of the battery's fault as the vehicle controller repeats it, beside the battery's own (JL-R013).
    VehicleBatteryLevel "vehicle.battery_level" Severity;
    /// State of charge as the vehicle controller repeats it; the battery's own has precedence (JL-23).
    VehicleSoc "vehicle.soc" Permille;
    /// The vehicle controller asks for the buzzer.
    VehicleBuzzer "vehicle.buzzer" Flag;
    /// Cruise control is on.
    VehicleCruise "vehicle.cruise" Flag;
    /// The last gear request failed.
    VehicleShiftFailed "vehicle.shift_failed" Flag;
    /// Economy mode; "no" = power or sport mode.
    VehicleEconomy "vehicle.economy" Flag;
    /// The vehicle controller sees its low-voltage supply under its limit.
    VehicleSupplyLow "vehicle.supply_low" Flag;

    /// Brake vacuum pressure.
    BrakeVacuum "brake.vacuum" Kilopascal;
    /// Brake vacuum is faulty.
    BrakeVacuumFault "brake.vacuum_fault" Flag;
    /// Anti-lock brake fault.
    BrakeAbsFault "brake.abs_fault" Flag;
    /// Brake force distribution fault.
    BrakeEbdFault "brake.ebd_fault" Flag;

    /// Pack voltage.
    BatteryVoltage "battery.voltage" Decivolt;
    /// Pack current, positive = out of the battery.
    BatteryCurrent "battery.current" Deciamp;
    /// State of charge.
    BatterySoc "battery.soc" Permille;
    /// How far the battery's check of itself has come (BUS-69).
    BatteryState "battery.state" Check;
    /// The battery asks the vehicle to open the high-voltage circuit.
    BatteryHvOffRequest "battery.hv_off_request" Flag;
    /// Severity of the battery's fault report.
    BatteryFaultLevel "battery.fault_level" Severity;
    /// Fault code of the battery, 0 = none.
    BatteryFaultCode "battery.fault_code" Count;
    /// Alarms of a battery that sends bits in place of codes.
    BatteryAlarms "battery.alarms" Bits;
    /// Highest cell voltage.
    BatteryCellMax "battery.cell.max" Millivolt;
    /// Lowest cell voltage.
    BatteryCellMin "battery.cell.min" Millivolt;
    /// Highest cell temperature.
    BatteryTemperatureMax "battery.temperature.max" Celsius;
    /// Lowest cell temperature.
    BatteryTemperatureMin "battery.temperature.min" Celsius;
    /// Largest charge current that the battery allows, magnitude.
    BatteryChargeLimit "battery.charge_limit" Deciamp;
    /// Largest discharge current that the battery allows.
    BatteryDischargeLimit "battery.discharge_limit" Deciamp;
    /// Rated capacity.
    BatteryCapacity "battery.capacity" Ah;
    /// Cell balancing is active.
    BatteryBalancing "battery.balancing" Flag;
    /// Battery fault lamp.
    BatteryFault "battery.fault" Flag;
    /// State of charge is low, as the vehicle reports it.
    BatteryLow "battery.low" Flag;
    /// State of health.
    BatteryHealth "battery.health" Permille;
    /// Nominal voltage of the pack as its nameplate has it.
    BatteryRatedVoltage "battery.rated_voltage" Decivolt;
    /// Highest cell temperature that the battery allows.
    BatteryTemperatureUpper "battery.temperature.upper" Celsius;
    /// Lowest cell temperature that the battery allows.
    BatteryTemperatureLower "battery.temperature.lower" Celsius;
    /// Lowest state of charge that the battery allows.
    BatterySocLower "battery.soc_lower" Permille;
    /// Box of the highest cell voltage, as sent.
    BatteryCellMaxBox "battery.cell.max_box" Count;
    /// Cell of the highest cell voltage within its box, as sent.
    BatteryCellMaxCell "battery.cell.max_cell" Count;
    /// Box of the lowest cell voltage, as sent.
    BatteryCellMinBox "battery.cell.min_box" Count;
    /// Cell of the lowest cell voltage within its box, as sent.
    BatteryCellMinCell "battery.cell.min_cell" Count;
    /// Number of the cell with the highest voltage, counted through the whole pack.
    BatteryCellMaxNumber "battery.cell.max_number" Count;
    /// Number of the cell with the lowest voltage, counted through the whole pack.
    BatteryCellMinNumber "battery.cell.min_number" Count;
    /// How many cells send their voltage.
    BatteryCellCount "battery.cell.count" Count;
    /// Box of the highest temperature, as sent.
    BatteryTemperatureMaxBox "battery.temperature.max_box" Count;
    /// Box of the lowest temperature, as sent.
    BatteryTemperatureMinBox "battery.temperature.min_box" Count;
    /// Module with the highest temperature.
    BatteryTemperatureMaxModule "battery.temperature.max_module" Count;
    /// Module with the lowest temperature.
    BatteryTemperatureMinModule "battery.temperature.min_module" Count;
    /// How many temperature sensors send.
    BatteryTemperatureCount "battery.temperature.count" Count;
    /// A smoke detector in the battery gives alarm.
    BatterySmoke "battery.smoke" Flag;
    /// A smoke detector in the battery is faulty.
    BatterySmokeDetectorFault "battery.smoke_detector_fault" Flag;
    /// The battery has cut its main negative contactor.
    BatteryNegativeCut "battery.negative_cut" Flag;

    /// Main contactor in the battery.
    ContactorMain "contactor.main" Contactor;
    /// Charge contactor 1.
    ContactorCharge1 "contactor.charge_1" Contactor;
    /// Charge contactor 2.
    ContactorCharge2 "contactor.charge_2" Contactor;
    /// Heater contactor.
    ContactorHeater "contactor.heater" Contactor;
    /// Main negative contactor in the battery.
    ContactorNegative "contactor.negative" Contactor;

    /// High-voltage emergency cut-off, as the vehicle controller reports it.
    RelayCutoff "relay.cutoff" Flag;
    /// Precharge relay, as the vehicle controller reports it.
    RelayPrecharge "relay.precharge" Contactor;
    /// Main motor relay, as the vehicle controller reports it.
    RelayMotor "relay.motor" Contactor;
    /// Accessory relay, as the vehicle controller reports it.
    RelayAccessory "relay.accessory" Contactor;
    /// Accessory precharge relay, as the vehicle controller reports it.
    RelayAccessoryPrecharge "relay.accessory_precharge" Contactor;
    /// Defrost relay, as the vehicle controller reports it.
    RelayDefrost "relay.defrost" Contactor;
    /// Charge relay, as the vehicle controller reports it.
    RelayCharge "relay.charge" Contactor;
    /// Main relay in the battery, as the vehicle controller reports it.
    RelayBattery "relay.battery" Contactor;

    /// Motor contactor, as the contactor box measures it.
    BoxMotor "box.motor" Contactor;
    /// Battery main contactor, as the contactor box measures it.
    BoxBattery "box.battery" Contactor;
    /// Motor precharge contactor, as the contactor box measures it.
    BoxMotorPrecharge "box.motor_precharge" Contactor;
    /// Defrost contactor, as the contactor box measures it.
    BoxDefrost "box.defrost" Contactor;
    /// Battery heater contactor, as the contactor box measures it.
    BoxHeater "box.heater" Contactor;
    /// Accessory contactor, as the contactor box measures it.
    BoxAccessory "box.accessory" Contactor;
    /// Accessory precharge contactor, as the contactor box measures it.
    BoxAccessoryPrecharge "box.accessory_precharge" Contactor;
    /// Charge contactor 1, as the contactor box measures it.
    BoxCharge1 "box.charge_1" Contactor;
    /// Charge contactor 2, as the contactor box measures it.
    BoxCharge2 "box.charge_2" Contactor;

    /// Charging state.
    ChargeState "charge.state" Charge;
    /// The charge plug is inserted.
    ChargePlug "charge.plug" Flag;
    /// Days since the last external charge.
    ChargeInterval "charge.interval" Day;

    /// On-board charger output voltage.
    ChargerVoltage "charger.voltage" Decivolt;
    /// On-board charger output current, magnitude.
    ChargerCurrent "charger.current" Deciamp;
    /// Severity of the on-board charger's fault report.
    ChargerFaultLevel "charger.fault_level" Severity;
    /// Fault code of the on-board charger, 0 = none.
    ChargerFaultCode "charger.fault_code" Count;
    /// On-board charger is faulty or may not start.
    ChargerFault "charger.fault" Flag;

    /// Motor speed, negative = backwards.
    MotorSpeed "motor.speed" Rpm;
    /// Motor torque, negative = regeneration.
    MotorTorque "motor.torque" DeciNm;
    /// Motor temperature.
    MotorTemperature "motor.temperature" Celsius;
    /// Motor controller is in its fault state.
    MotorFault "motor.fault" Flag;
    /// Fault code of the motor controller, 0 = none.
    MotorFaultCode "motor.fault_code" Count;
    /// Alarms of a motor controller that sends bits in place of codes.
    MotorAlarms "motor.alarms" Bits;
    /// Phase current, effective value, magnitude.
    MotorPhaseCurrent "motor.phase_current" Deciamp;
    /// Severity of the motor system's fault.
    MotorFaultLevel "motor.fault_level" Severity;
    /// Motor power, positive = drive.
    MotorPower "motor.power" Watt;
    /// Motor controller runs.
    MotorState "motor.state" Run;

    /// Motor controller temperature.
    InverterTemperature "inverter.temperature" Celsius;
    /// DC-link voltage.
    InverterVoltage "inverter.voltage" Decivolt;
    /// DC-link current, positive = drive.
    InverterCurrent "inverter.current" Deciamp;

    /// DC/DC converter.
    DcdcState "dcdc.state" Run;
    /// Fault code of the DC/DC converter, 0 = none.
    DcdcFaultCode "dcdc.fault_code" Count;
    /// Low-voltage output of the DC/DC converter.
    DcdcOutput "dcdc.output" Decivolt;
    /// DC/DC converter temperature.
    DcdcTemperature "dcdc.temperature" Celsius;
    /// High-voltage input of the DC/DC converter.
    DcdcInput "dcdc.input" Decivolt;
    /// Output current of the DC/DC converter.
    DcdcCurrent "dcdc.current" Deciamp;
    /// DC/DC converter fault lamp.
    DcdcFault "dcdc.fault" Flag;

    /// Steering pump.
    SteeringState "steering.state" Run;
    /// Fault code of the steering pump, 0 = none.
    SteeringFaultCode "steering.fault_code" Count;
    /// Steering pump speed.
    SteeringSpeed "steering.speed" Rpm;
    /// Steering pump temperature.
    SteeringTemperature "steering.temperature" Celsius;

    /// Air compressor.
    CompressorState "compressor.state" Run;
    /// Fault code of the air compressor, 0 = none.
    CompressorFaultCode "compressor.fault_code" Count;
    /// Air compressor speed.
    CompressorSpeed "compressor.speed" Rpm;
    /// Air compressor temperature.
    CompressorTemperature "compressor.temperature" Celsius;
    /// Air compressor is too hot.
    CompressorHot "compressor.hot" Flag;
    /// Pressure switch of the air dryer.
    CompressorDryerSwitch "compressor.dryer_switch" Flag;
    /// Air compressor is faulty.
    CompressorFault "compressor.fault" Flag;

    /// Air conditioning is on.
    HvacOn "hvac.on" Flag;
    /// Air conditioning cools.
    HvacCooling "hvac.cooling" Flag;
    /// Air conditioning heats.
    HvacHeating "hvac.heating" Flag;
    /// Air conditioning defrosts.
    HvacDefrosting "hvac.defrosting" Flag;
    /// Speed of the fan, while the air conditioning is on.
    HvacFan "hvac.fan" Fan;
    /// Air conditioning lets in air from outside.
    HvacFreshAir "hvac.fresh_air" Flag;
    /// Air conditioning sterilises the air.
    HvacSterilising "hvac.sterilising" Flag;
    /// Air conditioning is faulty.
    HvacFault "hvac.fault" Flag;
    /// Air temperature in the cabin.
    HvacInside "hvac.inside" Celsius;
    /// Air temperature outside.
    HvacOutside "hvac.outside" Celsius;

    /// Severity of the insulation alarm.
    InsulationLevel "insulation.level" Severity;
    /// Insulation fault lamp.
    InsulationFault "insulation.fault" Flag;
    /// Insulation of the positive side.
    InsulationPositive "insulation.positive" Kiloohm;
    /// Insulation of the negative side.
    InsulationNegative "insulation.negative" Kiloohm;
    /// Fault code of the insulation monitor, 0 = none.
    InsulationFaultCode "insulation.fault_code" Count;
    /// The insulation monitor itself or its wiring is faulty.
    InsulationDeviceFault "insulation.device_fault" Flag;

    /// Water pump is faulty.
    CoolingPumpFault "cooling.pump_fault" Flag;
    /// Cooling fan is faulty.
    CoolingFanFault "cooling.fan_fault" Flag;

    /// Low-voltage supply at the cluster.
    SupplyVoltage "supply.voltage" Decivolt;
    /// Low-voltage supply is under its limit, as the vehicle repeats it (JL-23).
    SupplyLow "supply.low" Flag;
    /// Front brake air reservoir, or the first of two without names.
    AirFront "air.front" CentiMpa;
    /// Rear brake air reservoir, or the second of two without names.
    AirRear "air.rear" CentiMpa;

    /// Key position.
    BodyKey "body.key" Key;
    /// Entry (front) door is open.
    BodyDoorFront "body.door.front" Flag;
    /// Middle door of a three-door bus is open (BUS-R128).
    BodyDoorMiddle "body.door.middle" Flag;
    /// Exit (rear) door is open.
    BodyDoorRear "body.door.rear" Flag;
    /// Rear hatch (engine bay) is open.
    BodyDoorHatch "body.door.hatch" Flag;
    /// Parking brake lever is set.
    BodyParkingBrake "body.parking_brake" Flag;
    /// Smoke alarm.
    BodySmoke "body.smoke" Flag;
    /// Nobody sits on the driver's seat.
    BodySeatEmpty "body.seat_empty" Flag;
    /// Horn is pressed.
    BodyHorn "body.horn" Flag;
    /// Dipped beam is on.
    BodyLowBeam "body.lamp.low_beam" Flag;
    /// Main beam is on.
    BodyHighBeam "body.lamp.high_beam" Flag;
    /// Brake lamps are on.
    BodyBrakeLamp "body.lamp.brake" Flag;
    /// Right direction indicator is on.
    BodyTurnRight "body.lamp.turn_right" Flag;
    /// Left direction indicator is on.
    BodyTurnLeft "body.lamp.turn_left" Flag;
    /// Hazard warning is on.
    BodyHazard "body.lamp.hazard" Flag;
    /// Front fog lamps are on.
    BodyFrontFog "body.lamp.front_fog" Flag;
    /// Rear fog lamps are on.
    BodyRearFog "body.lamp.rear_fog" Flag;
    /// Side lamps are on.
    BodySideLamp "body.lamp.side" Flag;

    /// Total distance that the cluster keeps.
    ClusterOdometer "cluster.odometer" Km8;
    /// The driver has left the seat with a driving gear engaged (BUS-R129); decided by the cluster.
    ClusterDriverLeft "cluster.driver_left" Flag;
    /// Remote upgrades are forbidden now (JL-R031); decided by the cluster.
    ClusterUpgradeForbidden "cluster.upgrade_forbidden" Flag;
    /// Hardware version of the cluster.
    ClusterHardware "cluster.hardware" Count;
    /// Software version of the cluster.
    ClusterSoftware "cluster.software" Count;
}

/// Two whole words, so that a decoder stores a reading with two instructions on ARMv6-M.
#[derive(Clone, Copy)]
struct Slot {
    /// The number, or [`INVALID`].
    value: i32,
    /// Who wrote the slot: index of the message in the receive table, [`Readings::LOCAL`] or [`NOBODY`].
    source: u32,
}

/// The number of an invalid reading inside [`Readings`]; no model value reaches it.
pub const INVALID: i32 = i32::MIN;
const NOBODY: u32 = u32::MAX;

/// The last reading of every value and which message brought it.
#[derive(Clone)]
pub struct Readings {
    slots: [Slot; Value::COUNT],
}

impl Default for Readings {
    fn default() -> Self {
        Self::new()
    }
}

impl Readings {
    /// Source of what the cluster knows by itself: its own inputs and decisions.
    pub const LOCAL: u8 = 0xFE;

    /// Returns a store in which nothing has ever been seen.
    pub const fn new() -> Self {
        Self { slots: [Slot { value: INVALID, source: NOBODY }; Value::COUNT] }
    }

    /// Stores what `source` (its index in the vehicle's receive table, or [`Self::LOCAL`]) says of `value`.
    #[inline]
    pub fn set(&mut self, source: u8, value: Value, reading: Reading) {
        match reading {
            Reading::Valid(number) => self.put(source, value, number, true),
            Reading::Invalid => self.put(source, value, 0, false),
        }
    }

    /// Stores `number` as [`Self::set`] does, valid or not: the form of generated decoders.
    #[inline(always)]
    pub fn put(&mut self, source: u8, value: Value, number: i32, valid: bool) {
        let number = if valid { number } else { INVALID };
        self.slots[value as usize] = Slot { value: number, source: u32::from(source) };
    }

    /// Returns the last reading of `value` and the index of the message that brought it.
    pub fn get(&self, value: Value) -> Option<(Reading, u8)> {
        let slot = self.slots[value as usize];
        let reading = if slot.value == INVALID { Reading::Invalid } else { Reading::Valid(slot.value) };
        (slot.source != NOBODY).then_some((reading, slot.source as u8))
    }
}
