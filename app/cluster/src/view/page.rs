//! The pages, and what stands on the technical one.
//!
//! Owns the table of chapters: which values, under which words. Refuses to know how they look.
//! Source: BUS-R033, BUS-R038, BUS-R067, BUS-R135 to BUS-R138; readings BUS-38, BUS-102.

use super::{List, Sheet, Text};
use protocol_core::model::Value;

/// Rows of a list that stand on one page.
pub const ROWS: usize = 4;
/// Values of a chapter, at most.
pub const VALUES: usize = 14;

/// A trip that the driver can reset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trip {
    /// Trip A.
    A,
    /// Trip B.
    B,
}

/// A page with what only it shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Page {
    /// Speed, charge, power: what is driven by.
    #[default]
    Main,
    /// One trip of the driver.
    Trip(Trip),
    /// Consumption and range; charging while a plug is inserted.
    Energy,
    /// Faults that are active, the worst first.
    Faults(List),
    /// Faults since power-on, the latest first.
    History(List),
    /// Relays, codes, cells and counters for whoever looks after the vehicle.
    Technic(Sheet),
}

/// Public names of the pages before the technical one, by their numbers.
const KEYS: [&str; 6] = ["main", "trip_a", "trip_b", "energy", "faults", "history"];

/// Returns the public name of a page by its number in records; of the technical one that of its chapter.
pub fn key_of(number: u8) -> Option<&'static str> {
    let chapter =
        || Chapter::ALL.iter().find(|chapter| chapter.number() == number).map(|chapter| chapter.key());
    KEYS.get(usize::from(number)).copied().or_else(chapter)
}

/// Returns the public name of every page.
pub fn keys() -> impl Iterator<Item = &'static str> {
    KEYS.into_iter().chain(Chapter::ALL.iter().map(|chapter| chapter.key()))
}

impl Page {
    /// Returns the number that stands in records: 0 main, 1 and 2 trips, 3 energy, 4 faults, 5 history, 6 and more
    /// technical ([`Chapter::number`]).
    pub const fn number(self) -> u8 {
        match self {
            Self::Main => 0,
            Self::Trip(Trip::A) => 1,
            Self::Trip(Trip::B) => 2,
            Self::Energy => 3,
            Self::Faults(_) => 4,
            Self::History(_) => 5,
            Self::Technic(sheet) => sheet.chapter.number(),
        }
    }
}

/// One value of a chapter, with what the panel calls it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Item {
    /// What is shown.
    pub value: Value,
    /// Label before it; empty where the chapter is drawn with words of its own.
    pub label: Text,
    /// "Yes" is a warning.
    pub warns: bool,
}

macro_rules! chapters {
    (@warns) => { false };
    (@warns warns) => { true };
    ($($(#[$doc:meta])* $name:ident $number:literal $key:literal $title_zh:literal $title_en:literal:
       [$($value:ident $zh:literal $en:literal $($warns:ident)?),* $(,)?];)*) => {
        /// One chapter of the technical page: a table of values for whoever looks after the vehicle.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub enum Chapter { $($(#[$doc])* $name),* }

        impl Chapter {
            /// Every chapter, in the order of its pages.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Returns the number of its page in records; kept for ever and never given to another chapter.
            pub const fn number(self) -> u8 {
                match self { $(Self::$name => $number),* }
            }

            /// Returns the public name of its page.
            pub const fn key(self) -> &'static str {
                match self { $(Self::$name => $key),* }
            }

            /// Returns the title of its page.
            pub const fn title(self) -> Text {
                match self { $(Self::$name => Text { zh: $title_zh, en: $title_en }),* }
            }

            /// Returns its values, in the order of [`Sheet::values`]; none = [`Count`] in its order.
            pub const fn items(self) -> &'static [Item] {
                match self {
                    $(Self::$name => &[$(Item {
                        value: Value::$value,
                        label: Text { zh: $zh, en: $en },
                        warns: chapters!(@warns $($warns)?),
                    }),*]),*
                }
            }
        }
    };
}

#[rustfmt::skip]
chapters! {
    /// What the driver asks for, as the vehicle controller has understood it (BUS-38).
    Controls 12 "controls" "操作" "Controls": [
        VehicleMode "模式" "Mode",
        VehicleEconomy "经济模式" "Economy",
        VehicleCruise "定速巡航" "Cruise",
        VehicleAccelerator "加速踏板" "Accel.",
        VehicleBrake "制动踏板" "Brake",
        VehicleFootBrake "脚制动" "Foot brake",
        VehicleParkingBrake "驻车制动" "Park. brake",
        BrakeVacuum "制动负压" "Vacuum",
        VehicleHvCommand "高压请求" "HV wanted",
    ];
    /// Motor and inverter.
    Drive 13 "drive" "驱动" "Drive": [
        MotorState "电机" "Motor",
        MotorTorque "转矩" "Torque",
        MotorPhaseCurrent "相电流" "Phase",
        InverterVoltage "母线电压" "DC voltage",
        InverterCurrent "母线电流" "DC current",
    ];
    /// What the battery is able to do now, and its insulation (BUS-102).
    Battery 14 "battery" "动力电池" "Battery": [
        BatteryState "自检" "Self-check",
        BatteryHealth "健康度" "Health",
        BatteryDischargeLimit "放电限流" "Discharge",
        BatteryChargeLimit "充电限流" "Charging",
        BatteryBalancing "均衡" "Balancing",
        InsulationPositive "正极绝缘" "Insul. +",
        InsulationNegative "负极绝缘" "Insul. -",
        ChargerVoltage "充电机" "Charger",
        ChargerCurrent "充电机" "Charger",
        ChargeInterval "距上次充" "Last charge",
    ];
    /// What stands on the battery's nameplate.
    Nameplate 15 "nameplate" "电池铭牌" "Nameplate": [
        BatteryCapacity "容量" "Capacity",
        BatteryRatedVoltage "额定电压" "Rated",
        BatteryTemperatureUpper "最高允许" "At most",
        BatteryTemperatureLower "最低允许" "At least",
        BatterySocLower "SOC 下限" "Lowest SOC",
        BatteryCellCount "单体数" "Cells",
        BatteryTemperatureCount "测温点" "Sensors",
    ];
    /// Low-voltage supply.
    Supply 16 "supply" "低压电源" "Low voltage": [
        DcdcState "DCDC" "DC/DC",
        DcdcInput "输入电压" "Input",
        DcdcOutput "输出电压" "Output",
        DcdcCurrent "输出电流" "Current",
        DcdcTemperature "温度" "Temp.",
        SupplyVoltage "仪表电源" "At cluster",
    ];
    /// Steering pump, air compressor and what it fills.
    Pumps 17 "pumps" "助力与空压" "Steering and air": [
        SteeringState "助力泵" "Steering",
        SteeringSpeed "助力转速" "Speed",
        SteeringTemperature "助力温度" "Temp.",
        AirFront "前气压" "Front air",
        AirRear "后气压" "Rear air",
        CompressorState "空压机" "Compressor",
        CompressorSpeed "空压转速" "Speed",
        CompressorTemperature "空压温度" "Temp.",
        CompressorDryerSwitch "干燥器" "Dryer",
    ];
    /// Air conditioning (BUS-R135 to BUS-R138).
    Climate 18 "climate" "空调" "Climate": [
        HvacOn "空调" "HVAC",
        HvacCooling "制冷" "Cooling",
        HvacHeating "制热" "Heating",
        HvacDefrosting "除霜" "Defrost",
        HvacFan "风量" "Fan",
        HvacFreshAir "新风" "Fresh air",
        HvacSterilising "杀菌" "Sterilising",
        HvacInside "车内" "Inside",
        HvacOutside "车外" "Outside",
    ];
    /// Relays as the vehicle controller reports them (BUS-R038).
    #[default]
    Relays 6 "relays" "整车继电器" "Vehicle relays": [
        RelayBattery "电池总正" "Main",
        RelayMotor "电机" "Motor",
        RelayPrecharge "电机预充" "Motor pre.",
        RelayAccessory "附件" "Accessory",
        RelayAccessoryPrecharge "附件预充" "Access. pre.",
        RelayDefrost "除霜" "Defrost",
        RelayCharge "充电" "Charge",
        RelayCutoff "高压急断" "HV cut-off" warns,
    ];
    /// Contactors in the battery (BUS-R067).
    Contactors 7 "contactors" "电池接触器" "Battery contactors": [
        ContactorMain "电池总正" "Main",
        ContactorNegative "总负" "Negative",
        ContactorCharge1 "充电 1" "Charge 1",
        ContactorCharge2 "充电 2" "Charge 2",
        ContactorHeater "加热" "Heater",
    ];
    /// Contactors as the contactor box measures them.
    Box 8 "box" "高压控制盒" "Contactor box": [
        BoxBattery "电池" "Battery",
        BoxMotor "电机" "Motor",
        BoxMotorPrecharge "电机预充" "Motor pre.",
        BoxAccessory "附件" "Accessory",
        BoxAccessoryPrecharge "附件预充" "Access. pre.",
        BoxDefrost "除霜" "Defrost",
        BoxHeater "加热" "Heater",
        BoxCharge1 "充电 1" "Charge 1",
        BoxCharge2 "充电 2" "Charge 2",
    ];
    /// Fault codes as numbers (BUS-R033).
    Codes 9 "codes" "部件故障代码" "Component codes": [
        VehicleFaultCode "整车" "Vehicle",
        BatteryFaultCode "电池" "Battery",
        MotorFaultCode "电机" "Motor",
        SteeringFaultCode "助力" "Steering",
        DcdcFaultCode "DCDC" "DCDC",
        CompressorFaultCode "空压机" "Compressor",
        InsulationFaultCode "绝缘" "Insulation",
        ChargerFaultCode "充电机" "Charger",
    ];
    /// Highest and lowest cell and where they are.
    Extremes 10 "extremes" "单体极值" "Cell extremes": [
        BatteryCellMax "" "",
        BatteryCellMaxBox "" "",
        BatteryCellMaxCell "" "",
        BatteryCellMaxNumber "" "",
        BatteryCellMin "" "",
        BatteryCellMinBox "" "",
        BatteryCellMinCell "" "",
        BatteryCellMinNumber "" "",
        BatteryTemperatureMax "" "",
        BatteryTemperatureMaxBox "" "",
        BatteryTemperatureMaxModule "" "",
        BatteryTemperatureMin "" "",
        BatteryTemperatureMinBox "" "",
        BatteryTemperatureMinModule "" "",
    ];
    /// What the CAN bus and its controller count.
    Bus 11 "bus" "CAN 总线" "CAN bus": [];
}

/// What the chapter of the bus counts, in the order of [`Sheet::values`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Count {
    /// State of the controller, see [`Controller::state`](crate::driver::inputs::Controller::state); 0 = it does not answer.
    State,
    /// Transmit error counter.
    TransmitErrors,
    /// Receive error counter.
    ReceiveErrors,
    /// Frames that were sent.
    Sent,
    /// Frames whose values were stored.
    Stored,
    /// Frames with an identifier that the vehicle's table does not have.
    Unknown,
    /// Frames that the controller or the queue had no room for.
    Lost,
    /// Frames with too few bytes.
    Short,
    /// Frames with a wrong checksum.
    Damaged,
}

impl Count {
    /// Every counter, in order.
    pub const ALL: &'static [Self] = &[
        Self::State,
        Self::TransmitErrors,
        Self::ReceiveErrors,
        Self::Sent,
        Self::Stored,
        Self::Unknown,
        Self::Lost,
        Self::Short,
        Self::Damaged,
    ];
}
