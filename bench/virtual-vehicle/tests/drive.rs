//! Physics: energy is neither made nor lost, a hill charges, a standing vehicle stands.

mod ride;

use ride::Ride;
use virtual_vehicle::{Kind, World};

/// Where all energy that left the cells has gone, in J.
fn spent(world: &World) -> f64 {
    let energy = &world.energy;
    world.kinetic_joules()
        + energy.motor_heat
        + energy.accessories
        + energy.resistance
        + energy.brakes
        + energy.climb
}

fn drawn(world: &World) -> f64 {
    world.pack.joules_out - world.pack.joules_in
}

/// Stop and go, uphill and downhill, ten minutes.
fn city(ride: &mut Ride) {
    for (kmh, slope, seconds) in [
        ("30", "0", 40),
        ("0", "0", 30),
        ("50", "2", 70),
        ("20", "0", 30),
        ("0", "0", 30),
        ("45", "-3", 60),
        ("0", "0", 40),
        ("60", "0", 90),
        ("0", "-1", 60),
        ("25", "4", 60),
        ("0", "0", 40),
        ("40", "0", 50),
    ] {
        ride.set("driver.target", kmh).set("road.slope", slope).seconds(seconds);
    }
}

#[test]
fn energy_of_a_city_cycle_balances_within_one_percent() {
    for kind in Kind::ALL {
        let mut ride = Ride::ready(kind);
        ride.set("driver.air_conditioning", "on").set("hvac.cabin", "35");
        let before = (drawn(ride.world()), spent(ride.world()));
        city(&mut ride);
        let (out, gone) = (drawn(ride.world()) - before.0, spent(ride.world()) - before.1);
        assert!(out > 1e6, "{kind:?} took {out} J");
        assert!((out / gone - 1.0).abs() < 0.01, "{kind:?}: {out} J out of the pack, {gone} J accounted for");
    }
}

#[test]
fn a_bus_uses_about_one_kilowatt_hour_per_kilometre_in_town() {
    let mut ride = Ride::ready(Kind::Citybus);
    city(&mut ride);
    let per_km = drawn(ride.world()) / 3.6e6 / ride.read("vehicle.distance");
    assert!((0.6..1.4).contains(&per_km), "{per_km} kWh/km");
}

#[test]
fn a_hill_charges_the_pack() {
    for kind in Kind::ALL {
        let mut ride = Ride::at(kind, "40");
        ride.set("road.slope", "-8").seconds(20);
        assert!(ride.read("battery.current") < 0.0 && ride.read("motor.torque") < 0.0, "{kind:?}");
        let before = ride.world().pack.soc;
        ride.seconds(60);
        assert!(ride.world().pack.soc > before, "{kind:?}");
        assert!((ride.read("vehicle.speed") - 40.0).abs() < 1.5, "{kind:?}: {}", ride.read("vehicle.speed"));
    }
}

#[test]
fn top_speed_is_that_of_the_class() {
    for (kind, kmh) in [(Kind::Citybus, 80.0), (Kind::Jiulong, 100.0), (Kind::C5ev, 120.0)] {
        let mut ride = Ride::ready(kind);
        ride.set("driver.gear", "D").set("driver.accelerator", "100").seconds(120);
        let speed = ride.read("vehicle.speed");
        assert!((0.96 * kmh..=kmh).contains(&speed), "{kind:?}: {speed} km/h");
        ride.set("road.slope", "-4");
        ride.watch(30, |ride| assert!(ride.read("motor.speed") > 0.0));
    }
}

#[test]
fn a_standing_vehicle_stands_and_does_not_drift() {
    for kind in Kind::ALL {
        let mut ride = Ride::ready(kind);
        ride.set("driver.gear", "D").seconds(600);
        assert_eq!((ride.read("vehicle.speed"), ride.read("vehicle.distance")), (0.0, 0.0), "{kind:?}");
        ride.set("road.slope", "10").set("driver.brake", "50").seconds(60);
        assert_eq!(ride.read("vehicle.distance"), 0.0, "{kind:?} on a slope with the brake");
        ride.set("driver.brake", "0").set("driver.parking_brake", "on").seconds(60);
        assert_eq!(ride.read("vehicle.distance"), 0.0, "{kind:?} on a slope with the hand brake");
    }
}

#[test]
fn a_vehicle_without_brakes_rolls_down_a_slope() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("road.slope", "5").seconds(10);
    assert!(ride.world().motion.metres_per_s < -1.0);
}

#[test]
fn a_full_brake_stops_the_bus_from_50_in_a_believable_distance_and_leaves_it_standing() {
    let mut ride = Ride::at(Kind::Citybus, "50");
    let from = ride.read("vehicle.distance");
    ride.set("driver.target", "auto").set("driver.brake", "100").seconds(10);
    let metres = 1_000.0 * (ride.read("vehicle.distance") - from);
    assert_eq!(ride.read("vehicle.speed"), 0.0);
    assert!((14.0..25.0).contains(&metres), "{metres} m");
}

#[test]
fn nothing_flows_behind_open_contactors() {
    for kind in Kind::ALL {
        let mut ride = Ride::at(kind, "50");
        ride.set("driver.target", "auto").set("driver.key", "lock").seconds(2);
        ride.watch(10, |ride| {
            assert_eq!((ride.world().load_watts(), ride.world().motor.nm), (0.0, 0.0), "{kind:?}");
        });
        assert!(ride.read("vehicle.speed") > 20.0, "{kind:?} rolls on");
    }
}

#[test]
fn the_driver_holds_a_speed_uphill_and_downhill() {
    for kind in Kind::ALL {
        let mut ride = Ride::at(kind, "30");
        for slope in ["6", "-6", "0"] {
            ride.set("road.slope", slope).seconds(60);
            let kmh = ride.read("vehicle.speed");
            assert!((kmh - 30.0).abs() < 1.0, "{kind:?} at {slope} %: {kmh} km/h");
        }
    }
}

#[test]
fn the_driver_stops_and_starts_again_without_rolling_back() {
    let mut ride = Ride::at(Kind::Citybus, "30");
    ride.set("road.slope", "5").set("driver.target", "0").seconds(30);
    assert_eq!(ride.read("vehicle.speed"), 0.0);
    ride.set("driver.target", "30");
    let mut backwards = 0.0_f64;
    ride.watch(40, |ride| backwards = backwards.min(ride.world().motion.metres_per_s));
    assert!(backwards > -0.3, "rolled back at {backwards} m/s");
    assert!((ride.read("vehicle.speed") - 30.0).abs() < 1.5);
}

#[test]
fn work_warms_the_motor_and_rest_cools_it() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("road.slope", "6").set("driver.target", "50").seconds(300);
    let hot = ride.read("motor.temperature");
    assert!((35.0..140.0).contains(&hot), "{hot}");
    ride.set("road.slope", "0").set("driver.target", "0").seconds(300);
    assert!(ride.read("motor.temperature") < hot - 3.0);
}

#[test]
fn the_range_fits_the_consumption() {
    for (kind, km) in [(Kind::Citybus, 60.0..200.0), (Kind::Jiulong, 80.0..280.0), (Kind::C5ev, 70.0..230.0)]
    {
        let mut ride = Ride::ready(kind);
        city(&mut ride);
        let range = ride.read("vehicle.range");
        assert!(km.contains(&range), "{kind:?}: {range} km");
    }
}

#[test]
fn the_same_settings_give_the_same_vehicle() {
    let run = || {
        let mut ride = Ride::ready(Kind::Citybus);
        city(&mut ride);
        ride.world().clone()
    };
    assert_eq!(run(), run());
}

#[test]
fn every_readout_has_a_name_of_its_own_and_a_finite_value() {
    for kind in Kind::ALL {
        let mut vehicle = virtual_vehicle::VirtualVehicle::new(kind, virtual_vehicle::Options::default());
        vehicle.advance();
        let mut paths: Vec<_> = vehicle.readouts().iter().map(|readout| readout.path).collect();
        assert!(vehicle.readouts().iter().all(|readout| readout.value.is_finite() && !readout.zh.is_empty()));
        let count = paths.len();
        paths.sort_unstable();
        paths.dedup();
        assert_eq!(paths.len(), count);
    }
}

#[test]
fn every_control_reads_back_what_was_set() {
    for kind in Kind::ALL {
        let mut vehicle = virtual_vehicle::VirtualVehicle::new(kind, virtual_vehicle::Options::default());
        let own = [
            "driver.",
            "body.",
            "road.",
            "vcu.",
            "motor.",
            "hvac.",
            "supply.",
            "air.",
            "insulation.",
            "dcdc.",
        ];
        let controls: Vec<_> = vehicle
            .controls()
            .filter(|control| own.iter().any(|start| control.path.starts_with(start)))
            .collect();
        assert!(controls.len() > 25);
        for control in controls {
            let setting = match control.takes {
                virtual_vehicle::Takes::Flag => 1.0,
                virtual_vehicle::Takes::Choice(words) => words.len() as f64 - 1.0,
                virtual_vehicle::Takes::Number { max, .. } => max,
            };
            vehicle.set(control.path, Some(setting)).unwrap();
            let read = vehicle.setting(control.path).flatten().expect("is set");
            assert!((read - setting).abs() < 1e-9, "{}", control.path);
        }
    }
}
