//! Messages that no document prints and that more than one vehicle must have.

use super::truth::{converter_command, hvac_order, motor_report, parts_report, pump_command};
use crate::vehicle::Unsaid;
use protocol_core::vehicle::Node;

/// Motor controller to vehicle controller, on the bus of the cluster.
pub(crate) const MOTOR_REPORT: Unsaid = Unsaid {
    between: Some((Node::Inverter, Node::Vcu)),
    bring: |world, unprinted, is_heard| {
        unprinted.motor.bring(is_heard.then(|| motor_report(world)));
    },
};

/// The same on a bus that nobody is cut off from.
pub(crate) const MOTOR_REPORT_ELSEWHERE: Unsaid = Unsaid { between: None, ..MOTOR_REPORT };

/// Vehicle controller to converter, pumps and air conditioning, over wires.
pub(crate) const PARTS_COMMANDS: Unsaid = Unsaid {
    between: None,
    bring: |world, unprinted, is_heard| {
        unprinted.converter.bring(is_heard.then(|| converter_command(world)));
        unprinted.steering.bring(is_heard.then(|| pump_command(world.vcu.steering)));
        unprinted.compressor.bring(is_heard.then(|| pump_command(world.vcu.compressor)));
        unprinted.hvac.bring(is_heard.then(|| hvac_order(world)));
    },
};

/// Their answer.
pub(crate) const PARTS_REPORT: Unsaid = Unsaid {
    between: None,
    bring: |world, unprinted, is_heard| unprinted.parts.bring(is_heard.then(|| parts_report(world))),
};
