//! Which value of the cluster stands beside which truth of the vehicle.
//!
//! A readout that the cluster's model calls by the same name needs no row.

/// One readout: its path, and the model's path of the same thing; empty = the cluster has none.
struct Row(&'static str, &'static str);

const ROWS: &[Row] = &[
    Row("vcu.ready", "vehicle.ready"),
    Row("vcu.gear", "vehicle.gear"),
    Row("battery.severity", "battery.fault_level"),
    Row("battery.code", "battery.fault_code"),
    Row("link.voltage", "inverter.voltage"),
    Row("hv_off_request", "battery.hv_off_request"),
    Row("vcu.hv_cutoff", "relay.cutoff"),
    Row("vcu.limp", ""),
    Row("vcu.power_limited", "vehicle.power_limited"),
    Row("vcu.torque_limited", "vehicle.torque_limited"),
    Row("vcu.severity", "vehicle.fault_level"),
    Row("vcu.code", "vehicle.fault_code"),
    Row("vcu.shift_failed", "vehicle.shift_failed"),
    Row("vcu.seat_cut", ""),
    Row("vcu.buzzer", "vehicle.buzzer"),
    // The vehicle tells the current, and the model calls the voltage so.
    Row("dcdc.output", "dcdc.current"),
    Row("supply.volts", "supply.voltage"),
    Row("hvac.cooling", ""),
    Row("hvac.heating", ""),
    Row("hvac.communication_alarm", ""),
    Row("driver.accelerator", "vehicle.accelerator"),
    Row("driver.brake", "vehicle.brake"),
];

/// Returns the model's name of what the readout `path` tells.
pub(crate) fn beside(path: &'static str) -> &'static str {
    ROWS.iter().find(|row| row.0 == path).map_or(path, |row| row.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use protocol_core::Value;
    use virtual_vehicle::{Kind, Options, VirtualVehicle};

    #[test]
    fn every_row_names_a_readout_and_a_value_of_the_model() {
        let readouts = VirtualVehicle::new(Kind::Citybus, Options::default()).readouts();
        for Row(path, value) in ROWS {
            assert!(readouts.iter().any(|readout| readout.path == *path), "no readout {path}");
            assert!(value.is_empty() || Value::from_path(value).is_some(), "no value {value}");
        }
    }

    #[test]
    fn a_truth_that_is_a_state_stands_beside_a_value_of_the_same_kind() {
        for readout in VirtualVehicle::new(Kind::Citybus, Options::default()).readouts() {
            let (Some(kind), Some(value)) = (readout.kind, Value::from_path(beside(readout.path))) else {
                continue;
            };
            assert_eq!(Some(kind), value.unit().kind(), "{}", readout.path);
        }
    }
}
