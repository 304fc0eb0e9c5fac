//! The bench in a browser: the real firmware, the chips, the vehicle and the page's session in one WebAssembly module.
//!
//! [`Desk`] holds a session and a box of what is to be told; [`abi`] is the handful of calls by which `worker.js` reaches
//! it. [`judge_scenario`] judges a scenario in a second Worker, [`drive`] measures a run so that it can be compared with
//! one on a PC, [`read_file`] says what a file is that a person has dropped on the page. Bytes in, bytes out: no path, no
//! thread, no socket; the wall clock comes from the Worker. Nothing is uploaded: there is nothing that could.

#[cfg(target_arch = "wasm32")]
pub mod abi;
mod desk;
mod drive;
mod dropped;
mod embedded;
mod judge;

pub use desk::{Desk, Out};
pub use drive::{drive, fingerprint};
pub use dropped::{Dropped, read_file};
pub use judge::judge_scenario;
