//! Nodes that fall silent, messages that stop, counters that stand still: rows of each vehicle's controls.
//!
//! Refuses to know what silence leads to: that is each node's rule.

use crate::control::{Control, Group, Setting, Takes};
use crate::world::World;

/// A switch of the group Links.
pub(crate) const fn link(
    path: &'static str,
    words: [&'static str; 2],
    get: fn(&World) -> Setting,
    set: fn(&mut World, Setting),
) -> Control {
    Control::new(path, words, Group::Links, Takes::Flag, get, set)
}

/// Loses a message, or lets it be sent again.
pub(crate) fn lose(world: &mut World, message: &'static str, lost: bool) {
    world.links.lost.retain(|name| *name != message);
    if lost {
        world.links.lost.push(message);
    }
}

/// A node that neither sends nor hears.
macro_rules! cut {
    ($path:literal, $node:ident, $zh:literal, $en:literal) => {
        $crate::bus::links::link(
            concat!("link.", $path),
            [concat!($zh, "断开"), concat!($en, " cut off")],
            |world| $crate::control::flag(world.links.cut[protocol_core::vehicle::Node::$node as usize]),
            |world, setting| {
                let node = protocol_core::vehicle::Node::$node;
                world.links.cut[node as usize] = $crate::control::is_on(setting);
            },
        )
    };
}

/// A node whose life counters stand still.
macro_rules! frozen {
    ($path:literal, $node:ident, $zh:literal, $en:literal) => {
        $crate::bus::links::link(
            concat!("frozen.", $path),
            [concat!($zh, "心跳停止"), concat!($en, " life stands still")],
            |world| $crate::control::flag(world.links.frozen[protocol_core::vehicle::Node::$node as usize]),
            |world, setting| {
                let node = protocol_core::vehicle::Node::$node;
                world.links.frozen[node as usize] = $crate::control::is_on(setting);
            },
        )
    };
}

/// A message that is no longer sent.
macro_rules! lost {
    ($message:literal) => {
        $crate::bus::links::link(
            concat!("lost.", $message),
            [concat!($message, " 丢失"), concat!($message, " lost")],
            |world| $crate::control::flag(world.links.lost.contains(&$message)),
            |world, setting| $crate::bus::links::lose(world, $message, $crate::control::is_on(setting)),
        )
    };
}

pub(crate) use {cut, frozen, lost};
