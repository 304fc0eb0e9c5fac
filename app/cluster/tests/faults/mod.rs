//! Faults: each row alone, what a vehicle reports, which line is shown, what is remembered.
//!
//! `worlds_of_levels` and `worlds_of_events` state the arbitration a second time, naively, over every sequence of a small
//! world.

mod arbitration;
mod memory;
mod reports;
mod rows;
mod unseen;
mod worlds_of_events;
mod worlds_of_levels;
