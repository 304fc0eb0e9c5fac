//! The second witness for the core: the same program on QEMU's Cortex-M0 and on ours.

pub(crate) mod assembler;
pub(crate) mod cases;
pub(crate) mod layout;
pub(crate) mod machines;
