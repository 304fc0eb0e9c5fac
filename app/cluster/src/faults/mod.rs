//! Faults: what makes each report, which is on the line, what is remembered.
//!
//! | file          | owns                                                                  |
//! |---------------|-----------------------------------------------------------------------|
//! | `table`       | the rows: number, name, turn, words, sound, routes                    |
//! | `turns`       | the order of the routes: whose turn comes after whose                 |
//! | `named`       | a fault as records name it, and from there its words                  |
//! | `reading`     | what a route says now                                                 |
//! | `arbitration` | the active set: one line, one sound                                   |
//! | `memory`      | what went wrong since power-on                                        |

pub(crate) mod arbitration;
pub(crate) mod memory;
mod named;
mod reading;
mod table;
mod turns;

pub use memory::{ENTRY_BYTES, Entry, HISTORY};
pub use named::Named;
pub(crate) use table::AIR_LOW;
pub use table::{FaultId, Grade, Order, ROWS, Route, Row, Voice, When, Words};
