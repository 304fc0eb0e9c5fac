//! What the other nodes hear of the cluster.
//!
//! Decodes the cluster's own frames with the generated codecs. A frame of another identifier or length changes nothing.
//! Source: BUS-R127 to R129, JL-R026, JL-R031; the car's cluster sends nothing.

use crate::Kind;
use crate::world::Meter;
use protocol_core::CanFrame;
use protocol_core::generated::{citybus, jiulong};

/// Takes over what a frame says; returns whether it is one of the cluster's.
pub(super) fn hear(kind: Kind, meter: &mut Meter, frame: &CanFrame) -> bool {
    if frame.len() != 8 {
        return false;
    }
    let data = *frame.padded();
    match (kind, frame.id) {
        (Kind::Citybus, citybus::id::METER1) => {
            let said = citybus::Meter1(data);
            // Not available is not "left".
            meter.seat_left = said.driver_left_seat() == Some(1);
            meter.parking_brake = said.handbrake_raw() == 1;
        }
        (Kind::Citybus, citybus::id::METER2) => {
            let eighths = citybus::Meter2(data).odometer_raw();
            // All ones: not available (BUS-97).
            meter.odometer_km = (eighths != u32::MAX).then(|| f64::from(eighths) / EIGHTHS_PER_KM);
        }
        (Kind::Jiulong, jiulong::id::METER1) => {
            let said = jiulong::Meter1(data);
            let high = f64::from(said.odometer_high_raw()) * HIGH_PART_KM;
            meter.odometer_km = Some(high + f64::from(said.odometer_low_raw()));
        }
        // Meter3 is Meter2 once more, for the battery.
        (Kind::Jiulong, jiulong::id::METER2 | jiulong::id::METER3) => {
            meter.upgrade_forbidden = Some(jiulong::Meter2(data).upgrade_forbidden_raw() == 1);
        }
        _ => return false,
    }
    true
}

const EIGHTHS_PER_KM: f64 = 8.0;
/// One count of the upper part of the odometer, in km (JL-05).
const HIGH_PART_KM: f64 = 65_536.0;
