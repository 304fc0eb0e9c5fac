//! The fixed words of the screens, in both languages.

use crate::theme::Ink;
use cluster::page::Count;
use cluster::view::Text;
use protocol_core::model::Unit;
use protocol_core::states::{Check, Confinement, Contactor, Flag, Plug, Run, State};

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
/// Before a fault that is over.
pub(crate) const WAS: Text = Text { zh: "曾报：", en: "Was: " };
/// Head of what takes the main page over.
pub(crate) const STOP: Text = Text { zh: "立即停车", en: "STOP" };
/// What to do about it where the fault says nothing of its own.
pub(crate) const STOP_SAFELY: Text = Text { zh: "请在安全处停车", en: "Stop in a safe place" };
/// Before the code of a fault.
pub(crate) const CODE: Text = Text { zh: "代码", en: "Code" };
/// Before the seconds until high voltage goes off.
pub(crate) const HV_OFF_IN: Text = Text { zh: "断电倒计时", en: "HV off in" };
/// Seconds.
pub(crate) const SECONDS: Text = same("s");
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

/// Returns the word for a state that a value of this unit is, and its ink; `None` = it is a number. `warns` = "yes" is a
/// warning.
pub(crate) fn state(unit: Unit, number: i32, warns: bool) -> Option<(Text, Ink)> {
    let State { zh, en, .. } = unit.kind()?.of_number(number)?;
    let ink = match unit {
        Unit::Contactor => match Contactor::from_number(number)? {
            Contactor::Open => Ink::Secondary,
            Contactor::Closed => Ink::Accent,
            Contactor::Welded | Contactor::Fault => Ink::Red,
        },
        Unit::Flag if warns && number == Flag::Yes.number() => Ink::Red,
        Unit::Run if number == Run::Fault.number() => Ink::Red,
        Unit::Check if number == Check::Fault.number() => Ink::Red,
        Unit::Flag if number == Flag::No.number() => Ink::Secondary,
        Unit::Run if number == Run::Stopped.number() => Ink::Secondary,
        _ => Ink::Primary,
    };
    let en = match unit {
        Unit::Check => short_check(Check::from_number(number)?),
        _ => en,
    };
    Some((Text { zh, en }, ink))
}

/// Returns the word for a step of the battery's check of itself, as it has room in a table.
const fn short_check(check: Check) -> &'static str {
    match check {
        Check::Unknown => "n/a",
        Check::Precharging => "Pre-chg.",
        Check::Precharged => "Done",
        Check::Calibration => "Calibr.",
        Check::Fault => "Fault",
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
