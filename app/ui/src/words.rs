//! The fixed words of the screens, in both languages.

use cluster::view::Text;

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

/// Returns a text that is the same in both languages.
pub(crate) const fn same(text: &'static str) -> Text {
    Text { zh: text, en: text }
}
