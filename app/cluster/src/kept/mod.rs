//! What an instrument keeps over power-off: which parts, when each is due, how it is restored.
//!
//! A part is a few bytes under a number of its own; where they are kept is somebody else's business. Numbers stand for
//! ever. A part grows at its end only: whoever finds it shorter takes the rest as it is at first, whoever finds it
//! longer leaves the rest alone.
//!
//! | number       | part       | bytes                                                          | due                     |
//! |--------------|------------|----------------------------------------------------------------|-------------------------|
//! | 1            | `Distance` | 7: counts of the odometer; topmost bit = not known             | every 0.1 km, stopped   |
//! | 2            | `Trips`    | 64: both trips: way, way with known power, used, regained      | every 1 km, stopped, reset, every 5 min |
//! | 3            | `Settings` | 2: language, theme                                             | changed                 |
//! | 4            | `Vehicle`  | its name                                                       | another is certain      |
//! | 5            | `Starts`   | 13: power-ons, watchdog, panics, last cause                    | every start             |
//! | 6            | `Workshop` | written by a workshop's tool alone (docs/store.md)             | never                   |
//! | 32 to 63     | `Fault`    | `faults`                                                       | it came, worsened, came again |
//!
//! Numbers of more than a byte have their low byte first. Nothing is due before `Instrument::resume`: what was kept is
//! never overwritten by an instrument that has not been told of it.

mod faults;
pub(crate) mod keeper;
pub(crate) mod parts;

pub use faults::KeptFault;
pub use parts::{Bytes, Distance, Memory, PART_BYTES, Part, Starts, Workshop};
