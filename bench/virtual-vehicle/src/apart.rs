//! No node reads another node's memory: with the others' memory exchanged each decides and says the same.
//!
//! The memories come from another ride, in which nearly everything is otherwise; contacts, plugs, resistances, powers and
//! whatever else is physics or a wire stay. What a node knows of the others is then what it has heard.

use crate::world::{Bms, Charger, ContactorBox, Hvac, Insulation, Motor, Part, Vcu, World};
use crate::{Kind, Options, VirtualVehicle, bms, drive, parts, vcu};
use protocol_core::vehicle::Node;

/// A ride up to a moment; the settings act from the start.
fn ride(kind: Kind, settings: &[(&str, f64)], ms: u64) -> VirtualVehicle {
    let mut vehicle = VirtualVehicle::new(kind, Options { optional: true, ..Options::default() });
    for (path, value) in settings {
        if vehicle.setting(path).is_some() {
            vehicle.set(path, Some(*value)).expect("in range");
        }
    }
    while vehicle.now_ms() < ms {
        vehicle.advance();
    }
    vehicle
}

const DRIVES: &[(&str, f64)] =
    &[("driver.target", 50.0), ("driver.air_conditioning", 1.0), ("hvac.cabin", 40.0)];
const CHARGES: &[(&str, f64)] = &[("charge.plug", 1.0), ("battery.soc", 50.0)];
/// Nothing of it is in the others.
const OTHERWISE: &[(&str, f64)] = &[
    ("driver.key", 3.0),
    ("vcu.fault_level_2", 7.0),
    ("battery.soc", 15.0),
    ("battery.interlock", 1.0),
    ("battery.smoke", 1.0),
    ("motor.fault_code", 9.0),
    ("dcdc.fault_code", 3.0),
    ("compressor.fault_code", 10.0),
    ("steering.fault_code", 4.0),
    ("hvac.fault", 2.0),
    ("charge.charger_fault", 1.0),
    ("insulation.fault_code", 5.0),
];

/// The world with the memory of every node exchanged but of those that are kept.
fn exchanged(world: &World, other: &World, keep: &[Node]) -> World {
    let mut mixed = world.clone();
    let kept = |node: Node| keep.contains(&node);
    if !kept(Node::Vcu) {
        let mut vcu = Vcu { gear: world.vcu.gear, ..other.vcu.clone() };
        // Coils and coolant are wires.
        vcu.hvac.relay = world.vcu.hvac.relay;
        (vcu.coolant_pump, vcu.coolant_fan) = (world.vcu.coolant_pump, world.vcu.coolant_fan);
        mixed.vcu = vcu;
    }
    if !kept(Node::Bms) {
        let is = &world.bms;
        mixed.bms = Bms {
            main: is.main,
            negative: is.negative,
            precharge: is.precharge,
            charge_1: is.charge_1,
            charge_2: is.charge_2,
            heater: is.heater,
            ..other.bms.clone()
        };
    }
    let part = |is: &Part, other: &Part| Part { watts: is.watts, ..*other };
    for (node, to, is, other) in [
        (Node::Dcdc, &mut mixed.dcdc, &world.dcdc, &other.dcdc),
        (Node::Steering, &mut mixed.steering, &world.steering, &other.steering),
        (Node::Compressor, &mut mixed.compressor, &world.compressor, &other.compressor),
    ] {
        if !kept(node) {
            *to = part(is, other);
        }
    }
    if !kept(Node::Hvac) {
        mixed.hvac = Hvac { watts: world.hvac.watts, cabin_celsius: world.hvac.cabin_celsius, ..other.hvac };
    }
    if !kept(Node::Insulation) {
        let is = world.insulation;
        mixed.insulation = Insulation {
            positive_kiloohm: is.positive_kiloohm,
            negative_kiloohm: is.negative_kiloohm,
            kiloohm_override: is.kiloohm_override,
            ..other.insulation
        };
    }
    if !kept(Node::Charger) {
        let is = world.charger;
        mixed.charger = Charger {
            plugged: is.plugged,
            mains_volts: is.mains_volts,
            pantograph: is.pantograph,
            volts: is.volts,
            amps: is.amps,
            mismatched: is.mismatched,
            ..other.charger
        };
    }
    if !kept(Node::Inverter) {
        let (is, other) = (world.motor, other.motor);
        mixed.motor = Motor {
            running: other.running,
            fault_code: other.fault_code,
            protections: other.protections,
            protections_set: other.protections_set,
            heard: other.heard,
            wanted_nm: other.wanted_nm,
            ..is
        };
    }
    if !kept(Node::Contactors) {
        mixed.contactor_box = ContactorBox { motor: !world.contactor_box.motor, ..other.contactor_box };
    }
    mixed
}

/// Steps a world and the same with the others' memory exchanged, and compares what is left of both.
fn same<T: PartialEq + std::fmt::Debug>(
    what: &str,
    keep: &[Node],
    step: impl Fn(&mut World),
    look: impl Fn(&World) -> T,
) {
    for kind in Kind::ALL {
        let other = ride(kind, OTHERWISE, 6_000);
        for (settings, ms) in [(DRIVES, 3_000), (DRIVES, 20_000), (CHARGES, 12_000)] {
            let vehicle = ride(kind, settings, ms);
            let mut world = vehicle.world().clone();
            let mut mixed = exchanged(&world, other.world(), keep);
            step(&mut world);
            step(&mut mixed);
            assert_eq!(look(&world), look(&mixed), "{what} of {} at {ms} ms", kind.name());
        }
    }
}

#[test]
fn the_vehicle_controller_decides_by_what_it_heard() {
    same("vehicle controller", &[Node::Vcu], vcu::step, |world| world.vcu.clone());
}

#[test]
fn the_battery_controller_decides_by_what_it_heard() {
    same("battery", &[Node::Bms], bms::step, |world| world.bms.clone());
}

#[test]
fn the_charger_decides_by_what_it_heard() {
    same("charger", &[Node::Charger], bms::charger_step, |world| world.charger);
}

#[test]
fn the_motor_controller_decides_by_what_it_heard() {
    same("motor controller", &[Node::Inverter], drive::step, |world| (world.motor, world.motion));
}

#[test]
fn the_parts_decide_by_what_they_heard() {
    let all = [Node::Dcdc, Node::Steering, Node::Compressor, Node::Hvac, Node::Insulation];
    same("parts", &all, parts::step, |world| {
        (world.dcdc, world.steering, world.compressor, world.hvac, world.insulation)
    });
}

#[test]
fn what_a_node_says_is_its_own() {
    for kind in Kind::ALL {
        let other = ride(kind, OTHERWISE, 6_000);
        for (settings, ms) in [(DRIVES, 20_000), (CHARGES, 12_000)] {
            let vehicle = ride(kind, settings, ms);
            for node in vehicle.nodes().to_vec() {
                let said = |keep: &[Node]| {
                    let mut vehicle = ride(kind, settings, ms);
                    if !keep.is_empty() {
                        vehicle.world = exchanged(vehicle.world(), other.world(), keep);
                    }
                    // All cycles but the longest, without a step of the nodes.
                    let mut frames = Vec::new();
                    for _ in 0..100 {
                        vehicle.wire.step(&mut vehicle.world, kind.definition());
                        vehicle.world.now_ms += crate::STEP_MS;
                        frames.extend(vehicle.take_frames().into_iter().filter(|sent| sent.node == node));
                    }
                    frames
                };
                assert_eq!(said(&[]), said(&[node]), "{node:?} of {} at {ms} ms", kind.name());
            }
        }
    }
}
