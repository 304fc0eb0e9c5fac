//! The Cortex-M0+ core by the book: instructions, cycles, exceptions, sleep and the core's own registers.
//!
//! What QEMU can say is in `cpu_oracle`; here is what it cannot: the cycle table, timing of interrupts, sleep, faults
//! inside faults, and the defects that other emulators of this chip were found to have.

#![allow(missing_docs, clippy::cast_possible_truncation, reason = "test code that builds opcodes")]

#[path = "../oracle/assembler.rs"]
#[allow(dead_code, reason = "shared with cpu_oracle")]
mod assembler;
mod cycles;
mod exceptions;
mod faults;
mod instructions;
mod machine;
mod registers;
mod sleep;
