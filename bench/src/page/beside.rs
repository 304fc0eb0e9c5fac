//! Which value of the cluster stands beside which truth of the vehicle, and how a truth is worded.
//!
//! A readout that the cluster's model calls by the same name needs no row for that; words are for readouts that are no
//! quantities.

use serde::Serialize;

/// How a number that is no quantity is worded; the words themselves are the page's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Wording {
    /// No, yes.
    Flag,
    /// Model numbers of gears as the vehicle counts them: N, D, R, P; -1 = none.
    Gear,
    /// None, warn, derate, stop.
    Severity,
    /// Idle, charging, complete, fault.
    Charge,
    /// Open, closed.
    Contactor,
}

/// One readout: its path, the model's path of the same thing, its wording.
struct Row(&'static str, &'static str, Option<Wording>);

use Wording::{Charge, Contactor, Flag, Gear, Severity};

const ROWS: &[Row] = &[
    Row("vcu.ready", "vehicle.ready", Some(Flag)),
    Row("vcu.gear", "vehicle.gear", Some(Gear)),
    Row("battery.severity", "battery.fault_level", Some(Severity)),
    Row("battery.code", "battery.fault_code", None),
    Row("contactor.main", "contactor.main", Some(Contactor)),
    Row("link.voltage", "inverter.voltage", None),
    Row("hv_off_request", "battery.hv_off_request", Some(Flag)),
    Row("vcu.hv_cutoff", "relay.cutoff", Some(Flag)),
    Row("vcu.limp", "", Some(Flag)),
    Row("vcu.power_limited", "vehicle.power_limited", Some(Flag)),
    Row("vcu.torque_limited", "vehicle.torque_limited", Some(Flag)),
    Row("vcu.severity", "vehicle.fault_level", Some(Severity)),
    Row("vcu.code", "vehicle.fault_code", None),
    Row("vcu.shift_failed", "vehicle.shift_failed", Some(Flag)),
    Row("vcu.seat_cut", "", Some(Flag)),
    Row("vcu.buzzer", "vehicle.buzzer", Some(Flag)),
    Row("charge.state", "charge.state", Some(Charge)),
    // The vehicle tells the current, and the model calls the voltage so.
    Row("dcdc.output", "dcdc.current", None),
    Row("supply.volts", "supply.voltage", None),
    Row("hvac.cooling", "", Some(Flag)),
    Row("hvac.heating", "", Some(Flag)),
    Row("hvac.communication_alarm", "", Some(Flag)),
    Row("driver.accelerator", "vehicle.accelerator", None),
    Row("driver.brake", "vehicle.brake", None),
];

/// Returns the model's name of what the readout `path` tells, and its wording.
pub(super) fn beside(path: &'static str) -> (&'static str, Option<Wording>) {
    ROWS.iter().find(|row| row.0 == path).map_or((path, None), |row| (row.1, row.2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use protocol_core::Value;
    use virtual_vehicle::{Kind, Options, VirtualVehicle};

    #[test]
    fn every_row_names_a_readout_and_a_value_of_the_model() {
        let readouts = VirtualVehicle::new(Kind::Citybus, Options::default()).readouts();
        for Row(path, value, _) in ROWS {
            assert!(readouts.iter().any(|readout| readout.path == *path), "no readout {path}");
            assert!(value.is_empty() || Value::from_path(value).is_some(), "no value {value}");
        }
    }
}
