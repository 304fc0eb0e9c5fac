//! A measured run: the same drive on a PC and in a browser must come to the same numbers.

use bench::rig::{Rig, RigOptions};
use bench::time::Nanos;
use protocol_core::generated::VEHICLES;
use serde_json::json;
use virtual_vehicle::{Kind, Options, VirtualVehicle};

/// Settings of the drive: READY, then D and 50 km/h.
const SETTINGS: [(u64, &[(&str, &str)]); 2] = [
    (0, &[("driver.key", "start"), ("driver.parking_brake", "off"), ("driver.seat_empty", "off")]),
    (1, &[("driver.gear", "D"), ("driver.target", "50")]),
];

/// Drives a vehicle for so many seconds of virtual time and returns, as JSON, numbers for all that has happened: cycles
/// of the chip, frames with their times, the panel's pixels, every readout of the vehicle to the bit.
///
/// # Errors
/// If there is no such vehicle or the firmware does what the bench does not model, in words for a person.
pub fn drive(flash: &[u8], vehicle: &str, seconds: u64) -> Result<String, String> {
    let kind = Kind::from_name(vehicle).ok_or_else(|| format!("there is no vehicle `{vehicle}`"))?;
    let usual = RigOptions::default();
    let bitrate = VEHICLES.iter().find(|known| known.name == vehicle).map_or(usual.bitrate, |it| it.bitrate);
    let mut rig = Rig::with_flash(flash.to_vec(), &RigOptions { bitrate, ..usual });
    rig.drive(VirtualVehicle::new(kind, Options::default()));
    for second in 0..seconds {
        let due = SETTINGS.iter().filter(|(at, _)| *at == second).flat_map(|(_, settings)| *settings);
        for (path, text) in due {
            let Some(vehicle) = rig.vehicle_mut() else { continue };
            let control = vehicle.controls().find(|control| control.path == *path);
            let Some(control) = control else { continue };
            let set = control.read(text).and_then(|setting| vehicle.set(path, setting));
            set.map_err(|error| error.to_string())?;
        }
        let end = Nanos::from_secs(second + 1);
        rig.run_for(end.since(rig.now())).map_err(|stop| stop.to_string())?;
    }
    let heard = rig.heard();
    let frames = heard.iter().flat_map(|it| format!("{} {};", it.at.0, it.frame).into_bytes());
    let panel = rig.board().panel().glass().rgb;
    let readouts = rig.vehicle().map(VirtualVehicle::readouts).unwrap_or_default();
    let truths = readouts.iter().flat_map(|readout| readout.value.to_bits().to_le_bytes());
    let stats = rig.chip().stats();
    let told = json!({
        "vehicle": vehicle,
        "nanos": rig.now().0,
        "instructions": stats.instructions,
        "cycles": stats.cycles,
        "frames": heard.len(),
        "frames_hash": fingerprint(frames),
        "panel_hash": fingerprint(panel),
        "truths_hash": fingerprint(truths),
    });
    Ok(told.to_string())
}

/// Returns a short text that differs where the bytes do: FNV-1a of 64 bits, no more is asked of it.
pub fn fingerprint(bytes: impl IntoIterator<Item = u8>) -> String {
    let hash = bytes.into_iter().fold(0xCBF2_9CE4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3)
    });
    format!("{hash:016x}")
}
