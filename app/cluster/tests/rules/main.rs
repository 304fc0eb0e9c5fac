//! The cluster against a vehicle made for its tests, rule by rule.

mod arbitration;
mod faults;
mod odometer;
mod own_wires;
mod pages;
mod properties;
mod reception;
mod screen;
mod sounds;
mod telltales;
mod transmit;
mod worlds;

/// A small vehicle and a clock to drive it by.
mod toy;
