//! What a vehicle's folder gives: the shape that all of them share.
//!
//! `spec` figures, `faults` its battery's table, `wire` what its nodes send, `hears` what they make of what reaches them,
//! `controls` what a person may change. The engine walks these; it knows no vehicle by name.

use crate::bus::rows::Sheet;
use crate::control::Control;
use crate::inbox::Inbox;
use crate::spec::Spec;
use crate::told::{MotorCommand, Unprinted};
use crate::world::{Bms, Charger, ContactorBox, Heard, Hvac, Meter, PartsHeard, World};
use protocol_core::codec::MessageInfo;
use protocol_core::frame::CanId;
use protocol_core::vehicle::Node;

/// One vehicle.
pub(crate) struct Definition {
    /// Name of its folder in `vehicles/`.
    pub(crate) name: &'static str,
    /// Its figures.
    pub(crate) spec: &'static Spec,
    /// Messages of its DBC.
    pub(crate) messages: &'static [MessageInfo],
    /// What its nodes send.
    pub(crate) sheets: &'static [Sheet],
    /// What they say in messages that its document does not print.
    pub(crate) unprinted: &'static [Unsaid],
    /// What its nodes make of what reaches them.
    pub(crate) hears: Hears,
    /// What a person may change.
    pub(crate) controls: Controls,
}

/// What a person may change in a vehicle, beyond what every vehicle has.
pub(crate) struct Controls {
    /// Common controls that not every vehicle has.
    pub(crate) has: &'static [&'static str],
    /// Its own.
    pub(crate) own: &'static [&'static [Control]],
}

/// Something that is said in a message that the document does not print.
pub(crate) struct Unsaid {
    /// Who says it to whom; it is lost when one of them is cut off. `None` = over wires or a bus that nobody is cut off.
    pub(crate) between: Option<(Node, Node)>,
    /// Brings it, or lets a step pass without.
    pub(crate) bring: fn(world: &World, unprinted: &mut Unprinted, is_heard: bool),
}

/// What reaches a node.
pub(crate) struct Ears<'a> {
    /// Frames.
    pub(crate) inbox: &'a Inbox,
    /// What comes in messages that no document prints.
    pub(crate) unprinted: &'a Unprinted,
}

/// What the vehicle controller hears of the cluster.
pub(crate) struct Cluster {
    /// The cluster's messages.
    pub(crate) messages: &'static [CanId],
    /// Those of them that say what it acts on.
    pub(crate) proof: &'static [CanId],
    /// Takes them in.
    pub(crate) take: fn(&Inbox, &mut Meter),
}

/// How each node takes in what reaches it: into its own memory, out of its own ears.
pub(crate) struct Hears {
    /// Messages that a node listens to.
    pub(crate) messages: &'static [(Node, &'static [CanId])],
    /// Messages between battery and charger: nobody misses them while the plug is out.
    pub(crate) while_plugged: &'static [CanId],
    /// What the vehicle controller takes out of the cluster's messages.
    pub(crate) cluster: Cluster,
    /// Vehicle controller.
    pub(crate) vcu: fn(&Ears<'_>, &mut Heard),
    /// Battery controller.
    pub(crate) bms: fn(&Ears<'_>, &mut Bms),
    /// Motor controller.
    pub(crate) inverter: fn(&Ears<'_>) -> Option<MotorCommand>,
    /// Converter and pumps, each with its own ears: converter, steering pump, compressor.
    pub(crate) parts: fn([&Ears<'_>; 3], &mut PartsHeard),
    /// Air conditioning.
    pub(crate) hvac: fn(&Ears<'_>, &mut Hvac),
    /// Charger.
    pub(crate) charger: fn(&Ears<'_>, &mut Charger),
    /// Contactor box.
    pub(crate) contactor_box: fn(&Ears<'_>, &mut ContactorBox),
}
