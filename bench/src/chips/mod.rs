//! Models of the chips on the RP2040's pins, and the board that wires them up.
//!
//! Each model answers as its datasheet says, counts what passes through it and keeps a list of [`violations`]: timing
//! rules broken, registers misused, features touched that are not modelled. A test that ends with an empty list has
//! used the chip as it may be used.

pub mod bench_board;
pub mod mcp2515;
pub mod panel;
pub mod picture;
pub mod violations;
