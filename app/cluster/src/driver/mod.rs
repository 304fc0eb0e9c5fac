//! The driver's side: contacts and buttons, what a push means, what may be chosen.

pub(crate) mod debounce;
pub mod inputs;
pub(crate) mod press;
pub(crate) mod settings;
