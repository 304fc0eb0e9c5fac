//! Units as people write them in DBC files, and the model's way to write the same.

use crate::ratio::Ratio;

/// Spellings, the unit that the model knows, and how many of it one is (numerator, denominator).
const SPELLINGS: [(&[&str], &str, i128, i128); 9] = [
    (&["kph", "kmh", "km/hr", "kmph", "unit_kilometerperhour"], "km/h", 1, 1),
    (&["mph", "unit_mileperhour"], "km/h", 1_609_344, 1_000_000),
    (&["m/s", "m/sec", "unit_meterpersecon"], "km/h", 36, 10),
    (&["1/min", "rev/min", "revpm", "u/min", "unit_minutinver"], "rpm", 1, 1),
    (&["c", "deg c", "deg_c", "celsius", "degrees c", "\u{2103}", "unit_degrecelsi"], "°C", 1, 1),
    (&["volt", "volts", "unit_volt"], "V", 1, 1),
    (&["amp", "amps", "ampere", "unit_ampere"], "A", 1, 1),
    (&["percent", "pct", "%soc", "unit_percent"], "%", 1, 1),
    (&["kilometer", "unit_kilometer"], "km", 1, 1),
];

/// Returns the model's spelling of a unit and how many of it one is; that of a unit in other letters (`KM/H`) too.
pub(crate) fn unit(written: &str) -> Option<(&'static str, Ratio)> {
    let small = written.trim().to_lowercase();
    let known = ["km/h", "rpm", "°C", "degC", "V", "A", "%", "km"];
    let same =
        known.into_iter().find(|unit| unit.to_lowercase() == small).map(|unit| (unit, Ratio::whole(1)));
    let row = || SPELLINGS.iter().find(|(spellings, ..)| spellings.contains(&small.as_str()));
    same.or_else(|| row().map(|(_, unit, num, den)| (*unit, Ratio::new(*num, *den))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_people_write_is_known() {
        assert_eq!(unit("KPH"), Some(("km/h", Ratio::whole(1))));
        assert_eq!(unit("Km/h"), Some(("km/h", Ratio::whole(1))));
        assert_eq!(unit("Unit_KiloMeterPerHour"), Some(("km/h", Ratio::whole(1))));
        assert_eq!(unit("mph"), Some(("km/h", Ratio::new(1_609_344, 1_000_000))));
        assert_eq!(unit("K"), None, "kelvin has another zero");
        assert_eq!(unit("F"), None, "and so has Fahrenheit");
    }
}
