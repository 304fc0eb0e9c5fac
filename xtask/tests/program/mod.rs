//! The program that is tested, as cargo has built it for this checkout.

use std::process::Command;

/// Returns `cargo xtask`, to be started in the root of the checkout.
pub(crate) fn xtask() -> Command {
    // Cargo says it at run time since 1.94; what is compiled in is the path of the checkout that was built first.
    let program = std::env::var_os("CARGO_BIN_EXE_xtask");
    let mut command = Command::new(program.unwrap_or_else(|| env!("CARGO_BIN_EXE_xtask").into()));
    command.current_dir(surroundings::root());
    command
}
