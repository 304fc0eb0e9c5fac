//! Lets every node take in what has reached it: frames into its inbox, inboxes into its memory.
//!
//! Owns the inboxes and what is said in messages that no document prints. A node that is cut off hears nothing, one that
//! sleeps forgets; nobody misses a charger that is not plugged in. Refuses to know a message.

use crate::inbox::Inbox;
use crate::told::{BatteryCommand, ChargeOrder, ChargerReport, HvacOrder};
use crate::vehicle::{Definition, Ears};
use crate::world::{ContactorBox, Heard, NODE_COUNT, PartsHeard, World};
use protocol_core::CanFrame;
use protocol_core::frame::CanId;
use protocol_core::vehicle::Node;

/// Nodes in the order of their number.
pub(crate) const NODES: [Node; NODE_COUNT] = [
    Node::Vcu,
    Node::Inverter,
    Node::Bms,
    Node::Dcdc,
    Node::Steering,
    Node::Compressor,
    Node::Hvac,
    Node::Insulation,
    Node::Charger,
    Node::Contactors,
    Node::Cluster,
];

/// Gives every node its inbox.
pub(crate) fn build(world: &mut World, vehicle: &Definition) {
    world.links.inboxes = NODES.map(|node| {
        let listens =
            |id: &CanId| vehicle.hears.messages.iter().any(|(of, ids)| *of == node && ids.contains(id));
        Inbox::of(vehicle.messages.iter().filter(|info| listens(&info.id)))
    });
}

/// Brings a frame to every node that is on the bus and listens to it.
pub(crate) fn deliver(world: &mut World, vehicle: &Definition, frame: &CanFrame) {
    for node in NODES {
        let place = node as usize;
        if world.links.cut[place] || !world.links.inboxes[place].hear(frame) {
            continue;
        }
        let cluster = &vehicle.hears.cluster;
        if node == Node::Vcu && cluster.messages.contains(&frame.id) {
            world.meter.frames += 1;
            if cluster.proof.contains(&frame.id) {
                world.meter.silent_ms = 0;
            }
            (cluster.take)(&world.links.inboxes[place], &mut world.meter);
        }
    }
}

/// Lets one step pass and every node take in what has come since the last one.
pub(crate) fn step(world: &mut World, vehicle: &Definition) {
    let is_awake = world.is_awake();
    for inbox in &mut world.links.inboxes {
        if is_awake {
            inbox.pass();
        } else {
            inbox.rest();
        }
        if !world.charger.plugged {
            vehicle.hears.while_plugged.iter().for_each(|id| inbox.forget(*id));
        }
    }
    say_unprinted(world, vehicle, is_awake);
    if !is_awake {
        forget(world);
        return;
    }
    let links = &world.links;
    let ears = |node: Node| Ears { inbox: links.inbox(node), unprinted: &links.unprinted };
    (vehicle.hears.vcu)(&ears(Node::Vcu), &mut world.vcu.heard);
    (vehicle.hears.bms)(&ears(Node::Bms), &mut world.bms);
    world.motor.heard = (vehicle.hears.inverter)(&ears(Node::Inverter));
    let parts = [&ears(Node::Dcdc), &ears(Node::Steering), &ears(Node::Compressor)];
    (vehicle.hears.parts)(parts, &mut world.parts_heard);
    (vehicle.hears.hvac)(&ears(Node::Hvac), &mut world.hvac);
    (vehicle.hears.charger)(&ears(Node::Charger), &mut world.charger);
    (vehicle.hears.contactor_box)(&ears(Node::Contactors), &mut world.contactor_box);
}

/// Forgets what was heard: power-off. A command from before it must not act after it.
fn forget(world: &mut World) {
    world.vcu.heard = Heard::default();
    world.vcu.battery_codes.clear();
    world.bms.vcu = BatteryCommand::default();
    world.bms.vcu_silence_ms = 0;
    world.bms.charger = ChargerReport::default();
    world.bms.charger_silence_ms = 0;
    world.motor.heard = None;
    world.parts_heard = PartsHeard::default();
    world.hvac.heard = HvacOrder::default();
    world.charger.heard = ChargeOrder::default();
    world.contactor_box = ContactorBox::default();
}

fn say_unprinted(world: &mut World, vehicle: &Definition, is_awake: bool) {
    let mut unprinted = std::mem::take(&mut world.links.unprinted);
    if !is_awake {
        return;
    }
    for unsaid in vehicle.unprinted {
        let is_cut = |node: Node| world.links.cut[node as usize];
        let is_heard = unsaid.between.is_none_or(|(from, to)| !is_cut(from) && !is_cut(to));
        (unsaid.bring)(world, &mut unprinted, is_heard);
    }
    world.links.unprinted = unprinted;
}
