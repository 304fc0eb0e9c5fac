//! The vehicles: one generated module each.
//!
//! Refresh with `cargo xtask codegen`.

#[rustfmt::skip]
#[allow(clippy::cast_lossless, clippy::manual_range_contains, clippy::unnecessary_cast, unused_imports)]
pub mod c5ev;

#[rustfmt::skip]
#[allow(clippy::cast_lossless, clippy::manual_range_contains, clippy::unnecessary_cast, unused_imports)]
pub mod citybus;

#[rustfmt::skip]
#[allow(clippy::cast_lossless, clippy::manual_range_contains, clippy::unnecessary_cast, unused_imports)]
pub mod example;

#[rustfmt::skip]
#[allow(clippy::cast_lossless, clippy::manual_range_contains, clippy::unnecessary_cast, unused_imports)]
pub mod jiulong;

/// Every vehicle, sorted by name: for tools and tests.
#[rustfmt::skip]
pub static VEHICLES: &[&crate::Vehicle] = &[
    &c5ev::VEHICLE,
    &citybus::VEHICLE,
    &example::VEHICLE,
    &jiulong::VEHICLE,
];

/// The vehicles that an image holds and looks for, sorted by name.
#[rustfmt::skip]
pub static SHIPPED_VEHICLES: &[&crate::Vehicle] = &[
    &c5ev::VEHICLE,
    &citybus::VEHICLE,
    &jiulong::VEHICLE,
];

/// Name and messages of every vehicle, sorted by name: for tools.
#[rustfmt::skip]
pub static MESSAGES: &[(&str, &[crate::codec::MessageInfo])] = &[
    ("c5ev", c5ev::MESSAGES),
    ("citybus", citybus::MESSAGES),
    ("example", example::MESSAGES),
    ("jiulong", jiulong::MESSAGES),
];
