//! The fixed words of the screens, in both languages.

use crate::theme::Ink;
use cluster::page::{Count, Part};
use cluster::view::Text;
use protocol_core::model::Value;
use protocol_core::states::{Confinement, Contactor, Flag, Plug};

/// Motor temperature.
pub(crate) const MOTOR: Text = Text { zh: "电机", en: "Motor" };
/// Motor controller temperature.
pub(crate) const INVERTER: Text = Text { zh: "电控", en: "Inverter" };
/// Cell voltages and temperatures.
pub(crate) const CELLS: Text = Text { zh: "单体 V °C", en: "Cell V °C" };
/// Total distance.
pub(crate) const ODOMETER: Text = Text { zh: "总里程", en: "Total" };
/// Drive power or torque is limited.
pub(crate) const LIMITED: Text = Text { zh: "功率受限", en: "Limited" };
/// Torque may be sent.
pub(crate) const READY: Text = same("READY");
/// Unit of road speed.
pub(crate) const KMH: Text = same("km/h");
/// Unit of motor speed.
pub(crate) const RPM: Text = same("rpm");
/// Unit of distance.
pub(crate) const KM: Text = same("km");
/// Unit of power.
pub(crate) const KW: Text = same("kW");
/// Unit of voltage.
pub(crate) const VOLT: Text = same("V");
/// Unit of current.
pub(crate) const AMP: Text = same("A");
/// Unit of temperature.
pub(crate) const CELSIUS: Text = same("°C");
/// Unit of state of charge.
pub(crate) const PERCENT: Text = same("%");

/// Before the highest cell.
pub(crate) const HIGHEST: Text = same("\u{4}");
/// Before the lowest cell.
pub(crate) const LOWEST: Text = same("\u{5}");

/// Unit of energy.
pub(crate) const KWH: Text = same("kWh");
/// Unit of consumption.
pub(crate) const KWH_100KM: Text = same("kWh/100km");
/// Hours and minutes.
pub(crate) const HOURS: Text = same("h");

/// Trip A.
pub(crate) const TRIP_A: Text = text("行程 A", "Trip A");
/// Trip B.
pub(crate) const TRIP_B: Text = text("行程 B", "Trip B");
/// Distance of a trip.
pub(crate) const DISTANCE: Text = text("里程", "Distance");
/// Average consumption of a trip.
pub(crate) const AVERAGE: Text = text("平均电耗", "Average");
/// Energy out of the battery.
pub(crate) const USED: Text = text("耗电", "Used");
/// Energy back into the battery.
pub(crate) const REGAINED: Text = text("回收", "Regained");
/// Remaining range.
pub(crate) const RANGE: Text = text("续航", "Range");
/// What a long push does on a trip's page.
pub(crate) const HOLD_TO_RESET: Text = text("长按按键清零", "Hold button: reset");

/// Page of consumption and charging.
pub(crate) const ENERGY: Text = text("能量", "Energy");
/// State of charge.
pub(crate) const CHARGE: Text = text("电量", "Charge");
/// Time until the battery is full.
pub(crate) const TIME_LEFT: Text = text("剩余时间", "Time left");
/// Power into the battery.
pub(crate) const CHARGE_POWER: Text = text("充电功率", "Charge power");
/// Power out of the battery.
pub(crate) const POWER: Text = text("功率", "Power");
/// Present consumption.
pub(crate) const CONSUMPTION: Text = text("瞬时电耗", "Consumption");
/// Voltage of the battery.
pub(crate) const VOLTAGE: Text = text("电压", "Voltage");
/// Current of the battery.
pub(crate) const CURRENT: Text = text("电流", "Current");

/// Page of active faults.
pub(crate) const FAULTS: Text = text("当前故障", "Active faults");
/// Page of past faults.
pub(crate) const HISTORY: Text = text("历史故障", "Fault history");
/// A list of faults is empty.
pub(crate) const NO_FAULTS: Text = text("无故障", "None");

/// Highest cell voltage.
pub(crate) const CELL_MAX: Text = text("最高单体", "Highest cell");
/// Lowest cell voltage.
pub(crate) const CELL_MIN: Text = text("最低单体", "Lowest cell");
/// Highest cell temperature.
pub(crate) const TEMPERATURE_MAX: Text = text("最高温度", "Hottest");
/// Lowest cell temperature.
pub(crate) const TEMPERATURE_MIN: Text = text("最低温度", "Coldest");

const fn text(zh: &'static str, en: &'static str) -> Text {
    Text { zh, en }
}

/// Returns the title of a technical part.
pub(crate) const fn part(part: Part) -> Text {
    match part {
        Part::Relays => text("整车继电器", "Vehicle relays"),
        Part::Contactors => text("电池接触器", "Battery contactors"),
        Part::Box => text("高压控制盒", "Contactor box"),
        Part::Codes => text("部件故障代码", "Component codes"),
        Part::Extremes => text("单体极值", "Cell extremes"),
        Part::Bus => text("CAN 总线", "CAN bus"),
    }
}

/// Returns the label of a value in a table; no words = it stands in none.
pub(crate) const fn value(value: Value) -> Text {
    match value {
        Value::RelayBattery | Value::ContactorMain => text("电池总正", "Main"),
        Value::RelayMotor | Value::BoxMotor => text("电机", "Motor"),
        Value::RelayPrecharge | Value::BoxMotorPrecharge => text("电机预充", "Motor pre."),
        Value::RelayAccessory | Value::BoxAccessory => text("附件", "Accessory"),
        Value::RelayAccessoryPrecharge | Value::BoxAccessoryPrecharge => text("附件预充", "Access. pre."),
        Value::RelayDefrost | Value::BoxDefrost => text("除霜", "Defrost"),
        Value::RelayCharge => text("充电", "Charge"),
        Value::RelayCutoff => text("高压急断", "HV cut-off"),
        Value::ContactorNegative => text("总负", "Negative"),
        Value::ContactorCharge1 | Value::BoxCharge1 => text("充电 1", "Charge 1"),
        Value::ContactorCharge2 | Value::BoxCharge2 => text("充电 2", "Charge 2"),
        Value::ContactorHeater | Value::BoxHeater => text("加热", "Heater"),
        Value::BoxBattery => text("电池", "Battery"),
        Value::VehicleFaultCode => text("整车", "Vehicle"),
        Value::BatteryFaultCode => text("电池", "Battery"),
        Value::MotorFaultCode => text("电机", "Motor"),
        Value::SteeringFaultCode => text("助力", "Steering"),
        Value::DcdcFaultCode => same("DCDC"),
        Value::CompressorFaultCode => text("空压机", "Compressor"),
        Value::InsulationFaultCode => text("绝缘", "Insulation"),
        Value::ChargerFaultCode => text("充电机", "Charger"),
        _ => same(""),
    }
}

/// Returns the label of a counter of the bus.
pub(crate) const fn count(count: Count) -> Text {
    match count {
        Count::State => text("状态", "State"),
        Count::TransmitErrors => same("TEC"),
        Count::ReceiveErrors => same("REC"),
        Count::Sent => text("已发送", "Sent"),
        Count::Stored => text("已接收", "Received"),
        Count::Unknown => text("未知", "Unknown"),
        Count::Lost => text("丢失", "Lost"),
        Count::Short => text("过短", "Too short"),
        Count::Damaged => text("校验错误", "Checksum"),
    }
}

/// Returns the title of the page of a plug that does this.
pub(crate) const fn plug(plug: Plug) -> Text {
    match plug {
        Plug::Inserted => text("充电枪已插入", "Plugged in"),
        Plug::Charging => text("正在充电", "Charging"),
        Plug::Complete => text("充电完成", "Charging complete"),
        Plug::Fault => text("充电故障", "Charging failed"),
    }
}

/// Returns the word for a contactor, and its ink.
pub(crate) const fn contactor(contactor: Contactor) -> (Text, Ink) {
    match contactor {
        Contactor::Open => (text("断开", "Open"), Ink::Secondary),
        Contactor::Closed => (text("闭合", "Closed"), Ink::Accent),
        Contactor::Welded => (text("粘连", "Welded"), Ink::Red),
        Contactor::Fault => (text("故障", "Fault"), Ink::Red),
    }
}

/// Returns the word for a flag, and its ink: those of the tables warn.
pub(crate) const fn flag(flag: Flag) -> (Text, Ink) {
    match flag {
        Flag::No => (text("否", "No"), Ink::Secondary),
        Flag::Yes => (text("是", "Yes"), Ink::Red),
    }
}

/// Returns the short word for the fault confinement of the CAN controller, and its ink; `None` = it does not answer.
pub(crate) const fn confinement(state: Option<Confinement>) -> (Text, Ink) {
    match state {
        None => (text("离线", "Offline"), Ink::Red),
        Some(Confinement::ErrorActive) => (text("正常", "Active"), Ink::Primary),
        Some(Confinement::Warning) => (text("警告", "Warning"), Ink::Yellow),
        Some(Confinement::ErrorPassive) => (text("被动", "Passive"), Ink::Yellow),
        Some(Confinement::BusOff) => (text("关闭", "Bus off"), Ink::Red),
    }
}

/// Returns a text that is the same in both languages.
pub(crate) const fn same(text: &'static str) -> Text {
    Text { zh: text, en: text }
}
