//! The table of faults: one row each, from which all that concerns one is derived.
//!
//! Owns number, name, turn, words, sound and routes of every fault, and of what the instrument says of itself. To add one:
//! a row here. A number is kept for ever: it stands in records, and is never given to another fault. A row says nothing of
//! a vehicle: values that no message of the vehicle brings make no report. Texts of fault codes belong to a vehicle and
//! come from its folder.
//! Source: BUS-R024, BUS-R025, BUS-R049 to BUS-R051, BUS-R059, BUS-R065, BUS-R072, BUS-R079, BUS-R080, BUS-R119, BUS-R123,
//! BUS-R125, BUS-R133; JL-R013, JL-R023, JL-R024; C5-R005; readings BUS-55, BUS-68, BUS-77, BUS-79, BUS-90, BUS-106,
//! BUS-109, BUS-113, BUS-116, C5-15, JL-23, JL-24, JL-56.

use crate::text::Text;
use protocol_core::model::{Severity, Value};
use protocol_core::states::{Charge, Contactor, Mode, Run};
use protocol_core::vehicle::Node;

/// What makes a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// A severity value above none.
    Level(Value),
    /// A code value other than 0.
    Code(Value),
    /// The value is this.
    Is(Value, i32),
    /// One of the values is this.
    AnyIs(&'static [Value], i32),
    /// One of the values is below this.
    AnyBelow(&'static [Value], i32),
    /// One of the flags is set while the vehicle is known to move.
    Moving(&'static [Value]),
    /// Alarm bits: each is a fault of its own, bit n = code n + 1.
    Bits(Value),
    /// An expected message of the node is missing.
    Silent(Node),
    /// The battery asks for high voltage off, see `monitors::hv_off`.
    HvOff,
    /// The charger has fallen silent, see `monitors::charger`.
    ChargerLost,
    /// The air conditioning has lost its link, see `monitors::hvac`.
    HvacLost,
    /// The vehicle limps, see `monitors::limp`.
    Limps,
    /// The node's code in this value is one that means fire, by the vehicle's documents.
    Fire(Node, Value),
    /// The instrument finds it in itself, see `own`.
    Own,
}

impl When {
    /// Returns the one value that is looked at, if it is one.
    pub(crate) const fn value(self) -> Option<Value> {
        match self {
            Self::Level(value) | Self::Code(value) | Self::Is(value, _) | Self::Bits(value) => Some(value),
            _ => None,
        }
    }
}

/// How bad the report is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grade {
    /// As the value says.
    Level(Value),
    /// The same always.
    Always(Severity),
    /// The documents print no level: takes turns with whatever the vehicle reports, and is at least this (BUS-113).
    Joins(Severity),
    /// As the alarm's text says; without a level there, as bad as this value, at least WARN.
    Alarm(Value),
}

/// One way by which a fault is reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Route {
    /// What makes the report.
    pub when: When,
    /// How bad it is.
    pub grade: Grade,
    /// Value of its code.
    pub code: Option<Value>,
    /// The sender reports several codes in turn: each is a fault of its own.
    pub rotates: bool,
    /// Level and code come in messages of their own: for a while a new level stands beside the code of the old one.
    pub code_lags: bool,
    /// The fault that brings the same by another route: of the same code only the worse report is told, and that fault's
    /// if they are equally bad (BUS-77: the vehicle forwards the battery's codes). This fault itself = its first route.
    pub repeats: Option<FaultId>,
    /// Left out on a vehicle that sends this value: it says the same in more detail.
    pub unless_sent: Option<Value>,
}

impl Route {
    const fn new(when: When, grade: Grade) -> Self {
        let (code, repeats, unless_sent) = (None, None, None);
        Self { when, grade, code, rotates: false, code_lags: false, repeats, unless_sent }
    }

    const fn code(mut self, value: Value) -> Self {
        self.code = Some(value);
        self
    }

    const fn rotates(mut self) -> Self {
        self.rotates = true;
        self
    }

    const fn code_lags(mut self) -> Self {
        self.code_lags = true;
        self
    }

    const fn repeats(mut self, fault: FaultId) -> Self {
        self.repeats = Some(fault);
        self
    }

    const fn unless_sent(mut self, value: Value) -> Self {
        self.unless_sent = Some(value);
        self
    }
}

const fn level(value: Value) -> Route {
    Route::new(When::Level(value), Level(value))
}

const fn flag(value: Value, grade: Grade) -> Route {
    Route::new(When::Is(value, 1), grade)
}

const fn any_of(values: &'static [Value], grade: Grade) -> Route {
    Route::new(When::AnyIs(values, 1), grade)
}

const fn bits(value: Value, level: Value) -> Route {
    Route::new(When::Bits(value), Alarm(level))
}

const fn component(state: Value, code: Value) -> Route {
    Route::new(When::Is(state, Run::Fault.number()), Joins(Warn)).code(code)
}

const fn silent(node: Node, severity: Severity) -> Route {
    Route::new(When::Silent(node), Always(severity))
}

const fn fire(node: Node, code: Value) -> Route {
    Route::new(When::Fire(node, code), Always(Stop))
}

const fn own(severity: Severity) -> Route {
    Route::new(When::Own, Always(severity))
}

/// What the line says; a fault with several texts goes through stages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Words {
    /// The same always.
    One(Text),
    /// One text each for the levels 1, 2 and 3 as the vehicle's documents count them.
    Levels(&'static [Text; 3]),
    /// One text for each phase of a request for high voltage off, see `monitors::hv_off`.
    Phases(&'static [Text; 4]),
    /// The vehicle's name.
    Vehicle,
}

impl Words {
    /// Returns every text, by stage.
    pub const fn texts(&self) -> &[Text] {
        match self {
            Self::One(text) => core::slice::from_ref(text),
            Self::Levels(texts) => *texts,
            Self::Phases(texts) => *texts,
            Self::Vehicle => &[],
        }
    }

    /// Returns the public names of the stages; none = there is only one.
    pub const fn stages(&self) -> &'static [&'static str] {
        match self {
            Self::One(_) | Self::Vehicle => &[],
            Self::Levels(_) => &["level_1", "level_2", "level_3"],
            Self::Phases(_) => &["asked", "overdue", "now", "done"],
        }
    }
}

const fn text(zh: &'static str, en: &'static str) -> Text {
    Text { zh, en }
}

const fn one(zh: &'static str, en: &'static str) -> Words {
    Words::One(text(zh, en))
}

/// Where a fault stands among the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Faults of one severity take turns, the lowest number first.
    Turn(u16),
    /// Takes over everything until power-off.
    Over,
    /// The instrument's own: stands beside what the vehicle reports, see `own`.
    Beside,
}

/// What is heard of a fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Voice {
    /// Nothing.
    Silent,
    /// The sound of its severity.
    AsSevere,
    /// The same, unless the vehicle is known to stand.
    Moving,
    /// The sound of fire, which is silenced for a time only.
    Fire,
}

/// One fault, but for its public name and what only tools need.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Which fault.
    pub fault: FaultId,
    /// Where it stands among the others.
    pub order: Order,
    /// What the line says where the vehicle has no text of its own for the code.
    pub words: Words,
    /// Nodes whose codes the vehicle's documents may explain: the first with a text has it.
    pub codes: &'static [Node],
    /// What is heard.
    pub voice: Voice,
    /// The history keeps it.
    pub is_kept: bool,
    /// How it is reported.
    pub routes: &'static [Route],
}

macro_rules! faults {
    ($($(#[$doc:meta])* $name:ident $number:literal $key:literal, $order:expr, $words:expr
       $(, [$($node:ident)+])? $(, ($zh:literal $en:literal))?, $voice:ident, $kept:literal: $($route:expr),+;)*) => {
        /// A fault, or what the instrument says of itself; its number is kept for ever.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u8)]
        pub enum FaultId { $($(#[$doc])* $name = $number),* }

        /// Places of the rows.
        enum Place { $($name),* }

        /// Every row, in the order of the numbers.
        pub const ROWS: &[Row] = &[$(Row {
            fault: FaultId::$name,
            order: $order,
            words: $words,
            codes: &[$($(Node::$node),+)?],
            voice: Voice::$voice,
            is_kept: $kept,
            routes: &[$($route),+],
        }),*];

        impl FaultId {
            /// Every fault, in the order of the numbers.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Returns the row.
            pub const fn row(self) -> &'static Row {
                match self { $(Self::$name => &ROWS[Place::$name as usize]),* }
            }

            /// Returns the public name: scenarios, JSON and the reference have it.
            pub const fn key(self) -> &'static str {
                match self { $(Self::$name => $key),* }
            }

            /// Returns what the driver can do; `None` = not written yet.
            pub const fn advice(self) -> Option<Text> {
                let advice: &[Text] = match self { $(Self::$name => &[$(text($zh, $en))?]),* };
                advice.first().copied()
            }
        }
    };
}

use Grade::{Alarm, Always, Joins, Level};
use Order::{Beside, Over, Turn};
use Severity::{Derate, Stop, Warn};
use Value as V;
use Words::{Levels, Phases};

/// Air pressure, in 0.01 MPa, below which a bus may not start off (GB 7258: 400 kPa where nothing else is marked).
pub(crate) const AIR_LOW: i32 = 40;

/// What opens and closes high-voltage circuits, as battery, vehicle controller and contactor box report it.
const CONTACTORS: &[Value] = &[
    V::ContactorMain,
    V::ContactorNegative,
    V::ContactorCharge1,
    V::ContactorCharge2,
    V::ContactorHeater,
    V::BoxMotor,
    V::BoxBattery,
    V::BoxMotorPrecharge,
    V::BoxDefrost,
    V::BoxHeater,
    V::BoxAccessory,
    V::BoxAccessoryPrecharge,
    V::BoxCharge1,
    V::BoxCharge2,
];

#[rustfmt::skip]
faults! {
    /// Level of the vehicle controller (BUS-R050).
    VehicleLevel 1 "vehicle_level", Turn(10), Levels(&[text("系统一级故障", "System fault level 1"),
        text("系统二级故障", "System fault level 2"), text("系统三级故障", "System fault level 3")]), AsSevere, true:
        level(V::VehicleFaultLevel);
    /// Code of the vehicle controller.
    VehicleCode 2 "vehicle_code", Turn(20), one("整车故障代码", "Vehicle fault code"), [Vcu], AsSevere, true:
        Route::new(When::Code(V::VehicleFaultCode), Level(V::VehicleFaultLevel)).code(V::VehicleFaultCode).rotates();
    /// Level that the vehicle controller gives its own state (JL-56).
    ControllerLevel 3 "controller_level", Turn(30), one("整车控制器故障", "Vehicle controller fault"), AsSevere, true:
        level(V::VehicleControllerLevel);
    /// System fault bit of a vehicle without levels.
    VehicleFault 4 "vehicle_fault", Turn(40), one("系统故障", "System fault"), Silent, true:
        flag(V::VehicleFault, Always(Warn)).unless_sent(V::VehicleFaultLevel);
    /// The battery asks for high voltage off: the vehicle has 5 s, the battery acts after 35 s (BUS-R065, BUS-68).
    HvOff 5 "hv_off", Turn(60), Phases(&[text("电池请求断开高压 请停车", "Battery asks for HV off: stop"),
        text("高压未断开 电池将自行断开", "HV still on: battery will cut it"), text("电池正在断开高压", "Battery cuts HV now"),
        text("动力电池高压断开", "High voltage is off")]), AsSevere, true:
        Route::new(When::HvOff, Always(Stop));
    /// Level and code of the battery; the vehicle repeats the code as one of its own, and the level (BUS-77).
    Battery 6 "battery_code", Turn(70), Levels(&[text("动力电池一级故障", "Battery fault level 1"),
        text("动力电池二级故障", "Battery fault level 2"), text("动力电池三级故障", "Battery fault level 3")]),
        [Bms], AsSevere, true:
        level(V::BatteryFaultLevel).code(V::BatteryFaultCode).rotates().code_lags().repeats(FaultId::VehicleCode),
        level(V::VehicleBatteryLevel).repeats(FaultId::Battery);
    /// Alarm bit of the battery.
    BatteryAlarm 7 "battery_alarm", Turn(90), one("动力电池故障", "Battery fault"), [Bms], AsSevere, true:
        bits(V::BatteryAlarms, V::BatteryFaultLevel);
    /// Battery fault bit of a vehicle without levels.
    BatteryFault 8 "battery_fault", Turn(100), one("动力电池故障", "Battery fault"), Silent, true:
        flag(V::BatteryFault, Always(Warn)).unless_sent(V::BatteryAlarms);
    /// A smoke detector in the battery gives alarm (JL-24).
    BatterySmoke 9 "battery_smoke", Turn(80), one("动力电池烟雾报警", "Smoke in the battery"),
        ("停车 疏散乘客" "Stop, let everyone out"), AsSevere, true:
        flag(V::BatterySmoke, Always(Stop)).unless_sent(V::BatteryAlarms);
    /// Level and code of the motor system.
    Motor 10 "motor_code", Turn(110), one("电机系统故障", "Motor system fault"), [Inverter], AsSevere, true:
        level(V::MotorFaultLevel).code(V::MotorFaultCode).rotates();
    /// Alarm bit of the inverter.
    MotorAlarm 11 "motor_alarm", Turn(120), one("电机系统故障", "Motor system fault"), [Inverter Vcu], AsSevere, true:
        bits(V::MotorAlarms, V::MotorFaultLevel);
    /// Fault state of the inverter: IPU3 status 5 (BUS-R059).
    Inverter 12 "inverter", Turn(170), one("电机控制器系统故障", "Motor controller fault"), Silent, true:
        flag(V::MotorFault, Joins(Warn)).code(V::MotorFaultCode);
    /// Level and code of the insulation monitor.
    Insulation 13 "insulation_code", Turn(130), one("绝缘故障", "Insulation fault"), [Insulation],
        ("停车 勿触高压部件" "Stop, touch no HV part"), AsSevere, true:
        level(V::InsulationLevel).code(V::InsulationFaultCode);
    /// Insulation fault bit of a vehicle without levels.
    InsulationFault 14 "insulation_fault", Turn(140), one("绝缘故障", "Insulation fault"), Silent, true:
        flag(V::InsulationFault, Always(Warn)).unless_sent(V::InsulationLevel);
    /// The insulation monitor itself or its wiring.
    InsulationDevice 15 "insulation_device", Turn(150), one("绝缘监测故障", "Insulation monitor fault"), Silent, true:
        flag(V::InsulationDeviceFault, Always(Warn));
    /// The cluster's own smoke detector.
    Smoke 16 "smoke", Turn(160), one("烟雾报警", "Smoke alarm"), ("停车 疏散乘客" "Stop, let everyone out"), AsSevere, true: flag(V::BodySmoke, Always(Stop));
    /// Steering pump: status 10 (BUS-R119).
    Steering 17 "steering", Turn(180), one("助力系统故障", "Steering assistance fault"), Moving, true:
        component(V::SteeringState, V::SteeringFaultCode);
    /// DC/DC converter: status 10 (BUS-R123), or its flag.
    Dcdc 18 "dcdc", Turn(190), one("DCDC 系统故障", "DC/DC converter fault"), Silent, true:
        component(V::DcdcState, V::DcdcFaultCode), flag(V::DcdcFault, Joins(Warn)).unless_sent(V::DcdcState);
    /// Air compressor: status 10 (BUS-R125), or its flag.
    Compressor 19 "compressor", Turn(200), one("空压机系统故障", "Air compressor fault"), Silent, true:
        component(V::CompressorState, V::CompressorFaultCode), flag(V::CompressorFault, Joins(Warn));
    /// Air compressor too hot.
    CompressorHot 20 "compressor_hot", Turn(210), one("空压机过温", "Air compressor hot"), Silent, true:
        flag(V::CompressorHot, Always(Warn));
    /// Level and code of the charger.
    Charger 21 "charger_code", Turn(270), one("充电机故障", "Charger fault"), [Charger], AsSevere, true:
        level(V::ChargerFaultLevel).code(V::ChargerFaultCode).rotates();
    /// Fault bit of a charger.
    ChargerFault 22 "charger_fault", Turn(280), one("充电机故障", "Charger fault"), Silent, true:
        flag(V::ChargerFault, Always(Warn)).unless_sent(V::ChargerFaultLevel);
    /// The charger has fallen silent while plugged in (C5-R005).
    ChargerLost 23 "charger_lost", Turn(290), one("充电机通信中断 充电断开", "Charger lost: charging ends"), AsSevere, true:
        Route::new(When::ChargerLost, Always(Warn));
    /// Anti-lock brake.
    BrakeAbs 24 "brake_abs", Turn(240), one("ABS 故障", "ABS fault"), Silent, true: flag(V::BrakeAbsFault, Always(Warn));
    /// Brake force distribution.
    BrakeEbd 25 "brake_ebd", Turn(230), one("EBD 故障", "EBD fault"), AsSevere, true: flag(V::BrakeEbdFault, Always(Warn));
    /// Brake vacuum.
    BrakeVacuum 26 "brake_vacuum", Turn(220), one("制动负压故障", "Brake vacuum fault"), AsSevere, true:
        flag(V::BrakeVacuumFault, Always(Derate));
    /// Water pump or fan.
    Cooling 27 "cooling", Turn(250), one("散热系统故障", "Cooling fault"), Silent, true:
        any_of(&[V::CoolingPumpFault, V::CoolingFanFault], Always(Warn));
    /// The low-voltage supply is under its limit (JL-23).
    Supply 28 "supply_low", Turn(260), one("低压电源欠压", "Low-voltage supply low"), Silent, true:
        any_of(&[V::SupplyLow, V::VehicleSupplyLow], Always(Warn));
    /// Air conditioning.
    Hvac 29 "hvac", Turn(300), one("空调系统故障", "Air conditioning fault"), Silent, true: flag(V::HvacFault, Always(Warn));
    /// A running air conditioning has lost its link (BUS-R133).
    HvacLost 30 "hvac_lost", Turn(310), one("空调通信故障", "Air conditioning link lost"), Silent, true:
        Route::new(When::HvacLost, Always(Severity::None));
    /// The vehicle limps without word from the battery (BUS-R080).
    Limp 31 "limp", Turn(320), one("电池通信中断 限功率 无回馈", "Limp: power limited, no regen"), AsSevere, true:
        Route::new(When::Limps, Always(Derate));
    /// Drive power is limited (BUS-R024).
    PowerLimit 32 "power_limited", Turn(330), one("限功率", "Power limited"), Silent, true:
        flag(V::VehiclePowerLimited, Joins(Severity::None));
    /// Drive torque is limited (BUS-R025).
    TorqueLimit 33 "torque_limited", Turn(340), one("限转矩", "Torque limited"), Silent, true:
        flag(V::VehicleTorqueLimited, Joins(Severity::None));
    /// The vehicle has not taken the gear that was asked for.
    ShiftFailed 34 "shift_failed", Turn(50), one("挂档失败", "Gear not engaged"), AsSevere, true:
        flag(V::VehicleShiftFailed, Always(Warn));
    /// The vehicle reports limp mode; it does not say why.
    LimpMode 35 "limp_mode", Turn(325), one("整车限功率行车模式", "Limp mode"), AsSevere, true:
        Route::new(When::Is(V::VehicleMode, Mode::Limp.number()), Always(Derate));
    /// Charging has ended by a fault (BUS-75).
    ChargeFault 36 "charge_fault", Turn(285), one("充电故障 充电停止", "Charging ended by a fault"), AsSevere, true:
        Route::new(When::Is(V::ChargeState, Charge::Fault.number()), Always(Warn));
    /// Brake air is low: a bus may not start off with it.
    AirLow 37 "air_low", Turn(215), one("制动气压低", "Brake air pressure low"), Moving, true:
        Route::new(When::AnyBelow(&[V::AirFront, V::AirRear], AIR_LOW), Always(Warn));
    /// A contactor does not open any more (BUS-R068).
    Welded 38 "contactor_welded", Turn(145), one("高压接触器粘连", "HV contactor welded"), AsSevere, true:
        Route::new(When::AnyIs(CONTACTORS, Contactor::Welded.number()), Always(Warn)).unless_sent(V::BatteryAlarms);
    /// A door is open while the vehicle moves.
    DoorOpen 39 "door_open", Turn(166), one("行驶中车门打开", "Door open while moving"), AsSevere, true:
        Route::new(When::Moving(&[V::BodyDoorFront, V::BodyDoorMiddle, V::BodyDoorRear, V::BodyDoorHatch]),
            Always(Warn));
    /// The driver's seat is empty in a driving gear (BUS-R129).
    DriverLeft 60 "driver_left", Turn(165), one("驾驶员离座 请换空挡", "Seat empty in gear: select N"), AsSevere, true:
        flag(V::ClusterDriverLeft, Always(Warn));
    /// No communication with the vehicle controller: there is no speed, no gear and no fault report.
    SilentVcu 64 "silent_vcu", Turn(400), one("整车控制器通信中断", "No communication: VCU"), AsSevere, true:
        silent(Node::Vcu, Derate);
    /// No communication with the inverter.
    SilentInverter 65 "silent_inverter", Turn(420), one("电机控制器通信中断", "No communication: motor"), AsSevere, true:
        silent(Node::Inverter, Warn);
    /// No communication with the battery: the vehicle limps (BUS-R080).
    SilentBms 66 "silent_bms", Turn(410), one("电池管理系统通信中断", "No communication: BMS"), AsSevere, true:
        silent(Node::Bms, Derate);
    /// No communication with the DC/DC converter.
    SilentDcdc 67 "silent_dcdc", Turn(460), one("DCDC 通信中断", "No communication: DC/DC"), Silent, true:
        silent(Node::Dcdc, Warn);
    /// No communication with the steering pump.
    SilentSteering 68 "silent_steering", Turn(430), one("助力系统通信中断", "No communication: steering"), Moving, true:
        silent(Node::Steering, Warn);
    /// No communication with the air compressor.
    SilentCompressor 69 "silent_compressor", Turn(440), one("空压机通信中断", "No communication: compressor"), Silent, true:
        silent(Node::Compressor, Warn);
    /// No communication with the air conditioning.
    SilentHvac 70 "silent_hvac", Turn(490), one("空调通信中断", "No communication: HVAC"), Silent, true:
        silent(Node::Hvac, Warn);
    /// No communication with the insulation monitor.
    SilentInsulation 71 "silent_insulation", Turn(450), one("绝缘监测通信中断", "No communication: insulation"), Silent, true:
        silent(Node::Insulation, Warn);
    /// No communication with the charger.
    SilentCharger 72 "silent_charger", Turn(480), one("充电机通信中断", "No communication: charger"), Silent, true:
        silent(Node::Charger, Warn);
    /// No communication with the contactor box.
    SilentContactors 73 "silent_contactors", Turn(470), one("高压控制盒通信中断", "No communication: contactors"), Silent, true:
        silent(Node::Contactors, Warn);
    /// Fire in the battery, by either route (BUS-R079, BUS-116).
    Fire 96 "fire", Over, one("火灾报警 立即停车疏散", "FIRE: stop, get everyone out"),
        ("断电 远离车辆" "Power off and keep away"), Fire, true:
        fire(Node::Vcu, V::VehicleFaultCode), fire(Node::Bms, V::BatteryFaultCode);
    /// The CAN controller does not answer.
    NoController 128 "no_controller", Beside, one("CAN 控制器通信中断", "No CAN controller: check wiring"), Silent, false:
        own(Warn);
    /// The cluster has been reset by a fault of its own; the code is the source line.
    Restarted 129 "restarted", Beside, one("仪表故障后重启", "Cluster restarted after a fault"), Silent, false: own(Warn);
    /// As much speaks for another vehicle as for the one identified.
    Doubt 130 "doubt", Beside, one("总线与车不匹配", "Another vehicle on this bus"), Silent, false: own(Warn);
    /// The vehicle has been identified.
    Identified 131 "identified", Beside, Words::Vehicle, Silent, false: own(Severity::None);
    /// No vehicle has been identified yet.
    Listening 132 "listening", Beside, one("总线监测中", "Listening for a vehicle"), Silent, false: own(Severity::None);
    /// All that was heard of the vehicle has stopped: as bad as the silence that it stands for.
    NoTraffic 133 "no_traffic", Beside, one("总线通信中断 检测线路", "No traffic: check the CAN wires"), Silent, false:
        own(Derate);
    /// One message comes from two senders.
    TwoSenders 134 "two_senders", Beside, one("总线报文冲突", "One message, two senders"), Silent, false: own(Warn);
    /// What was kept over power-off cannot be read or written.
    Memory 135 "memory", Beside, one("仪表存储故障", "Stored data lost"), Silent, false: own(Warn);
}

impl FaultId {
    /// Returns the number that stands in records.
    pub const fn number(self) -> u8 {
        self as u8
    }

    /// Returns the fault of a number in a record.
    pub fn from_number(number: u8) -> Option<Self> {
        Self::ALL.iter().copied().find(|fault| fault.number() == number)
    }

    /// Returns the fault of a public name.
    pub fn from_key(key: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|fault| fault.key() == key)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::collections::BTreeSet;

    /// What a route says besides when it reports, as one can compare it: values, then switches.
    fn traits(route: &Route) -> ([Option<Value>; 2], [bool; 3]) {
        let repeats = route.repeats == Some(FaultId::Limp);
        ([route.code, route.unless_sent], [route.rotates, route.code_lags, repeats])
    }

    #[test]
    fn each_word_of_a_route_says_one_thing_and_leaves_the_others() {
        let plain = || Route::new(When::Code(V::SupplyLow), Always(Warn));
        let (none, off) = ([None; 2], [false; 3]);
        assert_eq!(traits(&plain()), (none, off));
        assert_eq!(traits(&plain().code(V::DcdcState)), ([Some(V::DcdcState), None], off));
        assert_eq!(traits(&plain().unless_sent(V::DcdcState)), ([None, Some(V::DcdcState)], off));
        assert_eq!(traits(&plain().rotates()), (none, [true, false, false]));
        assert_eq!(traits(&plain().code_lags()), (none, [false, true, false]));
        assert_eq!(traits(&plain().repeats(FaultId::Limp)), (none, [false, false, true]));
    }

    #[test]
    fn each_kind_of_route_reports_on_its_values() {
        let of = |route: Route| (route.when, route.grade);
        let battery = V::BatteryFaultLevel;
        assert_eq!(of(level(battery)), (When::Level(battery), Level(battery)), "a level grades itself");
        assert_eq!(of(flag(V::HvacFault, Always(Warn))), (When::Is(V::HvacFault, 1), Always(Warn)));
        let fans: &[Value] = &[V::CoolingFanFault];
        assert_eq!(of(any_of(&[V::CoolingFanFault], Always(Warn))), (When::AnyIs(fans, 1), Always(Warn)));
        let alarms = (When::Bits(V::BatteryAlarms), Alarm(battery));
        assert_eq!(of(bits(V::BatteryAlarms, battery)), alarms);
        let dcdc = component(V::DcdcState, V::DcdcFaultCode);
        let state = When::Is(V::DcdcState, Run::Fault.number());
        assert_eq!(of(dcdc), (state, Joins(Warn)), "BUS-113: the documents print no level");
        assert_eq!(traits(&dcdc), ([Some(V::DcdcFaultCode), None], [false; 3]));
        assert_eq!(of(silent(Node::Bms, Derate)), (When::Silent(Node::Bms), Always(Derate)));
        let code = V::BatteryFaultCode;
        assert_eq!(of(fire(Node::Bms, code)), (When::Fire(Node::Bms, code), Always(Stop)));
        assert_eq!(of(own(Warn)), (When::Own, Always(Warn)));
    }

    #[test]
    fn a_number_and_a_key_name_one_fault_and_stay_apart() {
        let numbers: BTreeSet<u8> = FaultId::ALL.iter().map(|fault| fault.number()).collect();
        let keys: BTreeSet<&str> = FaultId::ALL.iter().map(|fault| fault.key()).collect();
        assert_eq!((numbers.len(), keys.len()), (ROWS.len(), ROWS.len()));
        assert!(!numbers.contains(&0), "0 is no fault");
        for (row, &fault) in ROWS.iter().zip(FaultId::ALL) {
            assert_eq!((row.fault, fault.row().fault), (fault, fault));
            assert_eq!(FaultId::from_number(fault.number()), Some(fault));
            assert_eq!(FaultId::from_key(fault.key()), Some(fault));
            let is_snake = |c: char| c.is_ascii_lowercase() || c == '_';
            assert!(fault.key().chars().all(is_snake), "{}", fault.key());
        }
        assert_eq!((FaultId::from_number(0), FaultId::from_key("battery")), (None, None));
    }

    #[test]
    fn a_fault_is_said_in_both_languages_and_each_stage_has_its_own_key() {
        let mut stages = 0;
        for row in ROWS {
            let (texts, keys) = (row.words.texts(), row.words.stages());
            assert_eq!(texts.is_empty(), row.words == Words::Vehicle);
            assert!(keys.is_empty() || keys.len() == texts.len(), "{}", row.fault.key());
            assert!(texts.iter().all(|text| !text.zh.is_empty() && !text.en.is_empty()));
            let unlike: BTreeSet<_> = texts.iter().map(|text| (text.zh, text.en)).collect();
            assert_eq!(unlike.len(), texts.len(), "{}: two stages say the same", row.fault.key());
            assert!(row.fault.advice().is_none_or(|advice| !advice.zh.is_empty() && !advice.en.is_empty()));
            stages += keys.len();
        }
        assert_eq!(stages, 3 + 3 + 4);
    }

    #[test]
    fn every_silent_node_is_named_and_no_two_alike() {
        let mut named = BTreeSet::new();
        for row in ROWS.iter().filter(|row| matches!(row.routes, [Route { when: When::Silent(_), .. }])) {
            for text in row.words.texts() {
                assert!(text.en.starts_with("No communication: "), "{}", text.en);
                assert!(named.insert(text.en) && named.insert(text.zh), "{} is said of two nodes", text.en);
            }
        }
        assert_eq!(named.len(), 2 * 10);
    }
}
